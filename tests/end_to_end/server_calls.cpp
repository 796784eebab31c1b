// SPDX-License-Identifier: MIT
// Calls and property paths: which function, which defaults, which errors; and handles of objects that are gone.
#include <cmath>
#include <string>
#include <vector>

#include "engine_fixture.hpp"

using namespace end_to_end;
using spear::Object;
using spear::Value;

TEST_CASE("omitted arguments take the engine's defaults, or raise") {
    Client client;
    client.transact([&] {
        const Object calls = client.game.new_object("URoundTripCalls");
        CHECK(calls.call<std::string>("Describe", "a") == "a 5 0.50 1,2,3 1 1 None! 0");
        CHECK(calls.call<std::string>("describe", arg("text", "b"), arg("MODE", "Slow"), arg("Tag", "here")) ==
              "b 5 0.50 1,2,3 1 0 here! 0");
        CHECK(calls.call<std::string>("Describe", "c", 6, 1.5) == "c 6 1.50 1,2,3 1 1 None! 0");
        CHECK(calls.call<int>("Needed", arg("Second", 1), arg("First", 5)) == 4);

        CHECK(contains(error_text<spear::MissingArgument>([&] { calls.call("Needed", arg("First", 1)); }), "Second"));
        CHECK(contains(
            error_text<spear::UnknownArgument>([&] { calls.call("Needed", arg("Frist", 1), arg("Second", 2)); }),
            "First"));
        error_text<spear::UnknownArgument>([&] { calls.call("Needed", 1, 2, 3); });
        error_text<spear::UnknownArgument>([&] { calls.call("Needed", 1, arg("First", 2)); });
        const std::string text = error_text<spear::UnknownFunction>([&] { calls.call("Neded", 1, 2); });
        CHECK(contains(text, "URoundTripCalls"));
        CHECK(contains(text, "Needed"));
        try {
            calls.call("Needed", 1, "two");
        } catch (const spear::WrongType& error) {
            CHECK(error.info().operation == "URoundTripCalls::Needed");
            CHECK(error.info().argument == "Second");
            CHECK(error.info().expected == "int32");
        }
    });
}

TEST_CASE("outputs, inputs by reference, world contexts, overrides") {
    Client client;
    client.transact([&] {
        const Object calls = client.game.new_object("URoundTripCalls");
        const Value split = calls.call("Split", "left|right");
        CHECK(split.type_name() == "Split_Result");
        CHECK(split["ReturnValue"] == Value(true));
        CHECK(split["Left"] == Value("left"));
        CHECK(split["Right"] == Value("right"));
        CHECK(calls.call("Increment", 41)["Value"] == Value(42));
        error_text<spear::MissingArgument>([&] { calls.call("Increment"); });
        CHECK(calls.call<double>("Length", FVector{3, 4, 0}) ==
              doctest::Approx(5)); // `const T&` is an input, and no output

        const Object calls_class = client.game.get_class("URoundTripCalls");
        CHECK(calls_class.call<int>("Add", 2, 3) == 5);
        CHECK_FALSE(calls_class.call<std::string>("WorldName").empty());
        CHECK(calls.call<std::string>("WorldName", arg("WorldContextObject", client.spawn())) ==
              calls_class.call<std::string>("WorldName"));
        error_text<spear::NotCallable>([&] { calls_class.call("WhoAmI"); });

        CHECK(calls.call<std::string>("WhoAmI") == "parent");
        const Object child = client.game.new_object("URoundTripCallsChild");
        CHECK(child.call<std::string>("WhoAmI") == "child");
        error_text<spear::NotCallable>([&] { calls.call("NobodyHome"); });
        error_text<spear::NotCallable>([&] { calls.call("Thunked", 1); });
    });
}

TEST_CASE("native accessors: the outermost setter runs, also for members") {
    Client client;
    client.transact([&] {
        const Object calls = client.game.new_object("URoundTripCalls");
        calls["Guarded"].set(99.0);
        CHECK(calls["Guarded"].get<double>() == 10.0);
        calls["Snapped"].set(FVector{1.4, 2.6, 0});
        CHECK(calls["Snapped"].get<FVector>() == FVector{1, 3, 0});
        calls["Snapped"]["Z"].set(7.7);
        CHECK(calls["Snapped"].get<FVector>() == FVector{1, 3, 8});
        CHECK(calls["SetterCalls"].get<int>() == 3);
        calls["ReadByBlueprints"].set(5); // read-only for Blueprints, not for us
        CHECK(calls["ReadByBlueprints"].get<int>() == 5);
    });
}

TEST_CASE("property paths through objects, structs, arrays, maps") {
    Client client;
    client.transact([&] {
        const Object calls = client.game.new_object("URoundTripCalls");
        const Object other = client.game.new_object("URoundTripCallsChild");
        CHECK(contains(error_text<spear::NullObject>([&] { calls["Other"]["Guarded"].get(); }), "Other"));
        calls["Other"].set(other);
        calls.property("Other.Guarded").set(4.5);
        CHECK(other["Guarded"].get<double>() == 4.5);
        calls.property("other.OTHER").set(calls);
        CHECK(calls.property("Other.Other.Other").get<Object>() == other);

        calls["List"].set(Value(Value::List{
            Value(Value::Dict{{"Count", 1}}), Value(Value::Dict{{"Count", 2}, {"Samples", Value(Value::List{0.5})}})}));
        CHECK(calls["List"][1]["Samples"][0].get<double>() == 0.5);
        calls.property("List[0].Place.Y").set(8);
        CHECK(calls["List"][0]["Place"].get<FVector>() == FVector{0, 8, 0});
        CHECK(contains(error_text<spear::OutOfRange>([&] { calls["List"][2].get(); }), "2 elements"));
        error_text<spear::OutOfRange>([&] { calls.property("List[-1]").get(); });

        calls["Records"].key("a key").set(Value(Value::Dict{{"Count", 5}})); // adds it
        CHECK(calls["Records"].key("a key")["Count"].get<int>() == 5);
        calls["Records"].key("a key")["Count"].set(6);
        CHECK(calls["Records"].key("a key")["Count"].get<int>() == 6);
        CHECK(contains(error_text<spear::OutOfRange>([&] { calls["Records"].key("none").get(); }), "none"));
        calls["Records"].key("a key")["Scores"].key("s").set(3);
        CHECK(calls["Records"].key("a key")["Scores"].key("s").get<int>() == 3);

        CHECK(contains(error_text<spear::UnknownProperty>([&] { calls["Guardd"].get(); }), "Guarded"));
        CHECK(contains(error_text<spear::UnknownProperty>([&] { calls.property("List[0].Cuont").get(); }), "Count"));
        error_text<spear::UnknownProperty>([&] { calls.property("Guarded.X").get(); });
        error_text<spear::UnknownProperty>([&] { calls.property("Guarded[0]").get(); });
        for (const char* path : {"", ".", "A.", "List[", "List[]", "List[0", "List[\"x]", "List[0]x"}) {
            CAPTURE(path);
            CHECK_THROWS_AS(calls.property(path).get(), spear::Error);
        }
        std::string deep = "Other";
        for (int index = 0; index < 100; ++index) {
            deep += ".Other";
        }
        error_text<spear::LimitExceeded>([&] { calls.property(deep).get(); });

        const Object values = client.game.new_object("URoundTrip");
        values["NameSetValue"].set(Value(Value::List{"one"}));
        CHECK(values["NameSetValue"][0].get<std::string>() == "one");
        error_text<spear::ReadOnly>([&] { values["NameSetValue"][0].set("two"); });
    });
}

TEST_CASE("handles: the same object has the same one; destroyed and collected objects are stale") {
    Client client;
    Object actor, kept, dropped;
    client.transact([&] {
        actor = client.spawn();
        CHECK(client.game.find_actor_by_path(actor.path_name()) == actor);
        CHECK(client.game.destroy_actor(actor));
        CHECK_FALSE(actor.is_valid()); // destroyed, but not collected yet
        CHECK(contains(error_text<spear::StaleObject>([&] { actor.call("K2_GetActorLocation"); }), "destroyed"));
        error_text<spear::StaleObject>([&] { actor["Tags"].get(); });
        error_text<spear::StaleObject>([&] { client.game.new_object("URoundTrip")["ActorValue"].set(actor); });

        kept = client.game.new_object("URoundTripCalls");
        dropped = client.game.new_object("URoundTripCalls");
        client.game.release_object(dropped);
        kept.call("CollectNow"); // in the middle of a block, while plans of this very class are in use
        CHECK(kept.is_valid());
        CHECK_FALSE(dropped.is_valid());
        CHECK(contains(error_text<spear::StaleObject>([&] { dropped.call("WhoAmI"); }), "RoundTripCalls"));
        CHECK(kept.call<std::string>("WhoAmI") == "parent");
        for (int index = 0; index < 20; ++index) { // new objects in recycled slots are not taken for the old one
            (void)client.game.new_object("URoundTripCalls");
        }
        error_text<spear::StaleObject>([&] { dropped.call("WhoAmI"); });
    });
}

TEST_CASE("latent functions complete a future in a later frame") {
    Client client;
    spear::Future<void> waited;
    client.transact([&] {
        const Object library = client.game.get_class("UKismetSystemLibrary");
        waited = library.async<void>("Delay", arg("Duration", 0.1));
        error_text<spear::NeedsFrames>([&] { waited.get(); }); // the open block holds the engine
    });
    waited.get(5s);
    CHECK(waited.is_ready());
}

TEST_CASE("making objects: what cannot be made raises and leaves the engine running") {
    Client client;
    client.transact([&] {
        error_text<spear::WrongType>([&] { client.game.new_object("AActor"); });
        error_text<spear::WrongType>([&] { client.game.new_object("UClass"); });
        error_text<spear::WrongType>([&] { client.game.new_object("UPackage"); });
        error_text<spear::OutOfRange>([&] { client.game.new_object("URoundTrip", nullptr, "a.b"); });
        const Object first = client.game.new_object("URoundTrip", nullptr, "OnlyOneOfThatName");
        error_text<spear::SpawnFailed>([&] { client.game.new_object("URoundTrip", nullptr, "OnlyOneOfThatName"); });
        error_text<spear::WrongType>([&] { client.game.spawn_actor("URoundTrip"); });
        error_text<spear::OutOfRange>(
            [&] { client.game.spawn_actor("ACameraActor", {.location = {std::nan(""), 0, 0}}); });
        error_text<spear::OutOfRange>([&] { client.game.spawn_actor("ACameraActor", {.name = "with space"}); });
        error_text<spear::OutOfRange>(
            [&] { client.game.spawn_actor("ACameraActor", {.collision_handling = "maybe"}); });
        for (const char* path : {"", "/", "//x", "/Game//x", "no/slash", "/Game/x.", "/Game/*"}) {
            CAPTURE(path);
            error_text<spear::UnknownObject>([&] { client.game.load_object(path); });
            error_text<spear::UnknownClass>([&] { client.game.load_class(path); });
        }
        error_text<spear::UnknownObject>([&] { client.game.release_object(client.spawn()); });
    });
}
