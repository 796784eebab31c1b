// SPDX-License-Identifier: MIT
// Every kind of value through the proxies of the RoundTrip module: as an argument, a result, an out-parameter, a
// property.
#include "fixture.hpp"

#include <fmt/format.h>

#include <spear/unreal/Engine/ACameraActor.hpp>
#include <spear/unreal/Engine/APawn.hpp>
#include <spear/unreal/RoundTrip/URoundTrip.hpp>
#include <spear/unreal/RoundTrip/URoundTripCalls.hpp>
#include <spear/unreal/RoundTrip/URoundTripCallsChild.hpp>

using namespace proxies;
using spear::Future;
using unreal::FRoundTripRecord;
using unreal::FVector;
using Mode = unreal::ERoundTripMode;

namespace {

struct Values : Client {
    unreal::URoundTrip object;
    unreal::URoundTripCalls calls;
    void run(const std::function<void()>& test) {
        transact([&] {
            object = game.new_object<unreal::URoundTrip>();
            calls = game.new_object<unreal::URoundTripCalls>();
            test();
            game.release_object(object);
            game.release_object(calls);
        });
    }
};

} // namespace

TEST_CASE_FIXTURE(Values, "numbers, texts, enums") {
    run([&] {
        CHECK(object.EchoBool(true));
        CHECK(object.EchoInt8(-7) == -7);
        CHECK(object.EchoInt64(std::int64_t{1} << 60) == std::int64_t{1} << 60);
        CHECK(object.EchoUInt64(~std::uint64_t{0}) == ~std::uint64_t{0});
        CHECK_THROWS_AS(object.EchoUInt8(300), spear::OutOfRange);
        CHECK(object.EchoFloat(1.5) == 1.5f);
        CHECK(object.EchoDouble(3) == 3.0);
        CHECK(object.EchoString("text") == "text");
        CHECK(object.EchoName(std::string("Name")) == "Name");
        CHECK(object.EchoText(std::string_view("t")) == "t");
        CHECK(object.EchoEnum(Mode::Reckless) == Mode::Reckless);
        CHECK(object.EchoByteEnum(unreal::ERoundTripLegacy::RTL_Second) == unreal::ERoundTripLegacy::RTL_Second);
        object.EnumValue().set(Mode::Fast);
        CHECK(object.EnumValue().get() == Mode::Fast);
        CHECK(object.CopyInt32(5).Result == 5);
        auto [result] = object.CopyString("out");
        CHECK(result == "out");
        object.bBitTwo().set(true);
        CHECK(object.bBitTwo().get());
        CHECK_FALSE(object.bBitOne().get());
        CHECK(spear::enum_name(Mode::Reckless) == "Reckless");
        CHECK(spear::enum_from_name<Mode>("Fast") == Mode::Fast);
        CHECK_FALSE(spear::enum_from_name<Mode>("Nonsense").has_value());
        CHECK(fmt::format("{}", Mode::Slow) == "Slow");
    });
}

TEST_CASE_FIXTURE(Values, "references: objects, classes, weak, lazy, soft, interfaces") {
    run([&] {
        const auto actor = game.spawn_actor<unreal::ACameraActor>();
        CHECK(object.EchoObject(object) == object);
        CHECK(object.EchoObject(nullptr).is_null());
        CHECK(object.EchoActor(actor) == actor);
        CHECK(object.CopyActor(actor).Result == actor);
        CHECK(object.EchoActor(object.async().EchoActor(actor)) == actor);
        CHECK(object.EchoWeak(actor) == actor);
        CHECK(object.EchoLazy(actor) == actor);
        object.ActorValue().set(actor);
        CHECK(object.ActorValue().K2_GetActorLocation() == FVector{});
        CHECK(object.EchoClass(spear::class_of<unreal::APawn>) == game.get_class("APawn"));
        CHECK(object.EchoClass(game.get_class<unreal::APawn>()) == game.get_class("APawn"));
        const spear::SubclassOf<unreal::AActor> pawn_class = object.EchoClass("APawn");
        CHECK(pawn_class.super_class() == game.get_class("AActor"));
        CHECK(object.EchoClass(pawn_class) == pawn_class);
        CHECK_THROWS_AS(
            object.EchoClass(game.get_class("UObject")), spear::WrongType); // what is not known here, the engine checks
        CHECK(object.EchoSoftObject("/Game/Folder/Thing.Thing").path == "/Game/Folder/Thing.Thing");
        CHECK(object.EchoSoftObject(actor).path == actor.path_name());
        CHECK(object.EchoSoftObject("").is_null());
        CHECK(object.EchoSoftClass("/Script/Engine.Pawn").path == "/Script/Engine.Pawn");
        const unreal::IRoundTripListener listener = object.EchoInterface(object);
        CHECK(listener == object);
        listener.Hear(42);
        CHECK(object.LastHeard().get() == 42);
        object.Hear(43); // a class has the functions of its interfaces
        CHECK(object.LastHeard().get() == 43);
        CHECK(spear::Object(object).cast<unreal::IRoundTripListener>() == listener);
        CHECK_THROWS_AS(actor.cast<unreal::IRoundTripListener>(), spear::WrongType);
        object.InterfaceValue().set(listener);
        object.CallListener(44);
        CHECK(object.LastHeard().get() == 44);
        object.InterfaceValue().send().Hear(45);
        CHECK(object.LastHeard().get() == 45);
        game.destroy_actor(actor);
    });
}

TEST_CASE_FIXTURE(Values, "structs: members not given keep the engine's own values") {
    run([&] {
        CHECK(object.EchoVector({1, 2, 3}) == FVector{1, 2, 3});
        CHECK(object.EchoColor({.R = 9}) == unreal::FColor{.R = 9});
        CHECK(object.EchoTransform({.Translation = {1, 2, 3}}).Translation == FVector{1, 2, 3});
        const FRoundTripRecord own = object.EchoRecord({});
        CHECK(own.Count == 3);
        CHECK(own.bOn);
        CHECK(own.Title == "untitled");
        CHECK(*own.Samples == std::vector<double>{});
        const FRoundTripRecord some = object.EchoRecord({.Title = "mine", .Place = {1, 2, 3}, .Samples = {0.5, 1.5}});
        CHECK(some.Count == 3); // was not sent
        CHECK(some.Title == "mine");
        CHECK(some.Place->Y == 2);
        CHECK(some.Samples->size() == 2);
        CHECK(object.EchoRecord(some) == some); // all members are given in what the engine sent

        object.RecordValue().set({.Count = 9});
        CHECK(object.RecordValue().get().Title == "untitled"); // a property keeps the other members
        object.RecordValue().Scores().set({{"a", 1}, {"b", 2}});
        CHECK(object.RecordValue().Scores()["b"].get() == 2);
        object.RecordValue().Scores()["c"].set(3);
        CHECK(object.RecordValue().get().Scores->size() == 3);
        CHECK(object.RecordValue().Place().Z().get() == 0);

        FRoundTripRecord changed = object.RecordValue().get();
        changed.Place->X = 7;
        changed.Count = 10;
        object.RecordValue().set(changed);
        CHECK(object.RecordValue().Place().X().get() == 7);
        CHECK(object.RecordValue().Count().get() == 10);

        CHECK_THROWS_AS(changed.Count = std::int64_t{1} << 40, spear::OutOfRange);

        FRoundTripRecord fresh;
        CHECK_FALSE(fresh.Count.is_given());
        CHECK(fresh.Count.value_or(-1) == -1);
        CHECK_THROWS_AS(fresh.Count.get(), spear::ArgumentError);
        CHECK_THROWS_AS(static_cast<void>(fresh.Place->X), spear::ArgumentError);
        fresh.Place.edit().X = 1;
        CHECK(fresh.Place->X == 1);
        CHECK(fmt::format("{}", some.Count) == "3");
        CHECK(object.EchoEmpty({}) == unreal::FRoundTripEmpty{});
    });
}

TEST_CASE_FIXTURE(Values, "futures as members of structs and elements of containers") {
    run([&] {
        const auto actor = game.spawn_actor<unreal::ACameraActor>({.location = {1, 2, 3}});
        const Future<FVector> place = actor.async().K2_GetActorLocation();
        const Future<FRoundTripRecord> echoed =
            object.async().EchoRecord({.Title = object.async().EchoString("later"), .Place = place});
        CHECK(echoed.get().Title == "later");
        CHECK(echoed.get().Place->Z == 3);
        CHECK(object.EchoVectorArray(std::vector<Future<FVector>>{place, place}).size() == 2);
        CHECK(object.EchoObjectArray(std::vector<Future<unreal::AActor>>{object.async().EchoActor(actor)}).at(0) ==
              actor);
        game.destroy_actor(actor);
    });
}

TEST_CASE_FIXTURE(Values, "containers") {
    run([&] {
        CHECK(object.EchoIntArray({1, 2, 3}) == std::vector<std::int32_t>{1, 2, 3});
        CHECK(object.EchoIntArray(std::array<int, 2>{4, 5}) == std::vector<std::int32_t>{4, 5});
        CHECK(object.EchoBoolArray({true, false}) == std::vector<bool>{true, false});
        CHECK(object.EchoStringArray({"a", "b"}) == std::vector<std::string>{"a", "b"});
        CHECK(object.EchoVectorArray({{1, 2, 3}, {4, 5, 6}}).at(1) == FVector{4, 5, 6});
        CHECK(object.EchoByteArray(std::vector<std::uint8_t>{1, 255}) == std::vector<std::uint8_t>{1, 255});
        const auto actor = game.spawn_actor<unreal::ACameraActor>();
        CHECK(object.EchoObjectArray({actor, nullptr}).at(0) == actor);
        CHECK(object.EchoObjectArray(std::vector<unreal::ACameraActor>{actor}).at(0) == actor);
        const std::vector<FRoundTripRecord> records = object.EchoRecordArray({{.Count = 1}, {.Title = "x"}});
        CHECK(records.at(0).Title == "untitled");
        CHECK(records.at(1).Title == "x");
        object.RecordArrayValue().set(records);
        CHECK(object.RecordArrayValue()[1].Title().get() == "x");
        CHECK(object.EchoNameSet({"b", "a"}) == std::set<std::string>{"a", "b"});
        CHECK(object.EchoIntSet({3, 1, 3}) == std::set<std::int32_t>{1, 3});
        CHECK(object.EchoStringMap({{"one", 1}, {"two", 2}}) ==
              std::map<std::string, std::int32_t>{{"one", 1}, {"two", 2}});
        CHECK(object.EchoVectorMap({{"up", {0, 0, 1}}}).at("up").Z == 1);
        CHECK(object.EchoEnumMap({{Mode::Fast, "f"}, {Mode::Slow, "s"}}) ==
              std::map<Mode, std::string>{{Mode::Slow, "s"}, {Mode::Fast, "f"}});
        object.EnumMapValue().set({{Mode::Fast, "f"}});
        CHECK(object.EnumMapValue()[Mode::Fast].get() == "f");
        CHECK(object.EchoOptional(5) == 5);
        CHECK_FALSE(object.EchoOptional(std::nullopt).has_value());
        CHECK(object.FixedValue().get() == std::array<std::int32_t, 4>{1, 2, 3, 4});
        object.FixedValue()[2].set(30);
        CHECK(object.FixedValue().get()[2] == 30);
        object.ObjectArrayValue().set({actor});
        CHECK(object.ObjectArrayValue()[0].K2_GetActorLocation() == FVector{});
        game.destroy_actor(actor);
    });
}

TEST_CASE_FIXTURE(Values, "delegates") {
    run([&] {
        object.DelegateValue().set({object, "OnEvent"});
        object.FireDelegate(5);
        CHECK(object.LastHeard().get() == 5);
        CHECK(object.DelegateValue().get() == spear::Delegate{object, "OnEvent"});
        CHECK(object.EchoDelegate({object, "OnEvent"}).function_name == "OnEvent");
        object.DelegateValue().set(nullptr);
        CHECK_FALSE(object.DelegateValue().get().is_bound());
        object.MulticastValue().set({{object, "OnEvent"}});
        object.FireMulticast(6);
        CHECK(object.LastHeard().get() == 6);
        CHECK(object.MulticastValue().get().size() == 1);
        CHECK_THROWS_AS(object.DelegateValue().set({object, "OnOther"}), spear::WrongType);
    });
}

TEST_CASE_FIXTURE(Values, "defaults, omitted arguments, named arguments") {
    run([&] {
        const std::string all_defaults = calls.Describe("text");
        CHECK(all_defaults == calls.Describe("text", 5, 0.5, FVector{1, 2, 3}, true, Mode::Fast, "None", "!", nullptr));
        CHECK(all_defaults == calls.Describe("text", spear::omit, spear::omit));
        CHECK(calls.Describe("text", spear::omit, spear::omit, {9, 9, 9}) ==
              calls.Describe("text", 5, 0.5, FVector{9, 9, 9}, true, Mode::Fast));
        CHECK(calls.Describe({.Text = "text", .Suffix = "?"}) ==
              calls.Describe("text", 5, 0.5, FVector{1, 2, 3}, true, Mode::Fast, "None", "?"));
        CHECK(calls.async().Describe({.Text = object.async().EchoString("text"), .Mode = Mode::Slow}).get() ==
              calls.Describe("text", spear::omit, spear::omit, spear::omit, spear::omit, Mode::Slow));
        CHECK(calls.Needed(7, 2) == 5);
        auto [ok, left, right] = calls.Split("a|b");
        CHECK(left + right == "ab");
        CHECK(calls.Increment(41).Value == 42);
        CHECK(calls.Length({3, 4, 0}) == 5);
        CHECK(calls.Add(1, 2) == 3);
        const auto statics = game.get_class<unreal::URoundTripCalls>();
        CHECK(statics.Add(1, 2) == 3);
        CHECK_FALSE(statics.WorldName().empty());
        CHECK(statics.async().Add(statics.async().Add(1, 2), 4).get() == 7);
        CHECK_THROWS_AS(calls.NobodyHome(), spear::NotCallable);
        const auto child = game.new_object<unreal::URoundTripCallsChild>();
        CHECK(child.WhoAmI() == "child"); // overrides count
        CHECK(unreal::URoundTripCalls(child).WhoAmI() == "child");
        game.release_object(child);
    });
}

TEST_CASE_FIXTURE(Values, "properties with accessors, maps of structs, paths through objects") {
    run([&] {
        calls.Guarded().set(99);
        CHECK(calls.Guarded().get() == 10); // its setter's doing
        calls.Snapped().X().set(1.6);
        CHECK(calls.Snapped().get() == FVector{2, 0, 0});
        calls.Records().set({{"one", {.Count = 1}}});
        calls.Records()["two"].set({.Title = "second"});
        CHECK(calls.Records()["one"].Count().get() == 1);
        CHECK(calls.Records().get().at("two").Count == 3);
        calls.Other().set(calls);
        CHECK(calls.Other().Other().Other().Guarded().get() == 10);
        CHECK(calls.Other().Other().Needed(5, 1) == 4);
        calls.List().set({{.Count = 1}, {.Count = 2}});
        CHECK(calls.List()[1].Count().get() == 2);
    });
}
