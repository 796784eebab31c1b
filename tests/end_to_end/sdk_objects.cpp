// SPDX-License-Identifier: MIT
// Objects, functions and properties by name; finding; what each error says.
#include <algorithm>
#include <string>
#include <vector>

#include "engine_fixture.hpp"

using namespace end_to_end;

namespace {

/// A part of FHitResult, and the results of functions with out-parameters, as a user would declare them.
struct HitResult {
    bool bBlockingHit = true;
    FVector Location{-1, -1, -1};
};
struct SetActorLocationResult {
    bool ReturnValue = false;
    HitResult SweepHitResult;
};
struct EyesViewPoint {
    FVector OutLocation;
    FRotator OutRotation;
};

/// What a generated proxy looks like.
struct ACameraActor : spear::Object {
    static constexpr std::string_view unreal_name = "ACameraActor";
    using Object::Object;
    FVector GetLocation() const { return call<FVector>("K2_GetActorLocation"); }
};

} // namespace

template <>
struct spear::Members<HitResult> {
    static constexpr std::string_view name = "FHitResult";
    static constexpr auto list =
        std::tuple{Member{"bBlockingHit", &HitResult::bBlockingHit}, Member{"Location", &HitResult::Location}};
};
template <>
struct spear::Members<SetActorLocationResult> {
    static constexpr std::string_view name = "SetActorLocationResult";
    static constexpr auto list = std::tuple{Member{"ReturnValue", &SetActorLocationResult::ReturnValue},
        Member{"SweepHitResult", &SetActorLocationResult::SweepHitResult}};
};
template <>
struct spear::Members<EyesViewPoint> {
    static constexpr std::string_view name = "EyesViewPoint";
    static constexpr auto list = std::tuple{
        Member{"OutLocation", &EyesViewPoint::OutLocation}, Member{"OutRotation", &EyesViewPoint::OutRotation}};
};

TEST_CASE("spawning, finding, destroying") {
    Client client;
    client.transact([&] {
        const spear::Object actor = client.game.spawn_actor("ACameraActor",
            {.location = {1, 2, 3}, .rotation = {.Yaw = 90}, .name = "FoundByTests", .tags = {"sdk_tests"}});
        CHECK(actor.class_name() == "ACameraActor");
        CHECK(actor.derives_from("AActor"));
        CHECK_FALSE(actor.derives_from("APawn"));
        CHECK(actor.is_a("Actor"));
        CHECK(actor.call<FRotator>("K2_GetActorRotation").Yaw == doctest::Approx(90));
        CHECK(client.game.find_actor_by_name("foundbytests") == actor); // names match without case
        CHECK(client.game.find_actor_by_tag("sdk_tests") == actor);
        CHECK(client.game.find_actor_by_path(actor.path_name()) == actor);
        CHECK(client.game.find_actors_by_tag("sdk_tests") == std::vector<spear::Object>{actor});
        CHECK(client.game.find_actors_by_name("FoundBy*").size() == 1);
        CHECK(client.game.find_actors_by_class_as_map("ACameraActor").contains("FoundByTests"));
        CHECK(client.game.find_actors_by_tag("no such tag").empty());
        CHECK_THROWS_AS(client.game.spawn_actor("ACameraActor", {.name = "FoundByTests"}), spear::SpawnFailed);
        const spear::Object root = client.game.find_component_by_class(actor, "UCameraComponent");
        CHECK(root.class_name() == "UCameraComponent");
        CHECK(client.game.find_components_by_class_as_map(actor, "USceneComponent").size() >= 1);

        const auto typed = client.game.find_actor_by_name<ACameraActor>("FoundByTests");
        CHECK(typed.GetLocation() == FVector{1, 2, 3});
        CHECK(actor.cast<ACameraActor>() == typed);
        CHECK_THROWS_AS(root.cast<ACameraActor>(), spear::WrongType);
        CHECK(client.game.spawn_actor<ACameraActor>().class_name() == "ACameraActor");

        CHECK(actor.is_valid());
        CHECK(client.game.destroy_actor(actor));
        CHECK_FALSE(actor.is_valid());
        CHECK_THROWS_AS(client.game.find_actor_by_name("FoundByTests"), spear::UnknownObject);
    });
}

TEST_CASE("classes") {
    Client client;
    const spear::Class actor_class = client.game.get_class("AActor"); // no block needed
    CHECK(client.game.get_class("Actor") == actor_class);
    CHECK(client.game.get_class("/Script/Engine.Actor") == actor_class);
    CHECK(client.game.get_class("aactor") == actor_class);
    CHECK(actor_class.super_class() == client.game.get_class("UObject"));
    CHECK(actor_class.super_class().super_class().is_null());
    const std::vector<spear::Class> derived = actor_class.derived_classes();
    CHECK(std::ranges::find(derived, client.game.get_class("APawn")) != derived.end());
    CHECK(client.game.get_class("ACameraActor").default_object().derives_from("ACameraActor"));
}

TEST_CASE("calls: positional and named arguments, defaults, out-parameters, static functions, aliases") {
    Client client;
    client.transact([&] {
        const spear::Object actor = client.spawn({1, 2, 3});
        const auto moved = actor.call<SetActorLocationResult>(
            "K2_SetActorLocation", arg("NewLocation", FVector{5, 0, 0}), arg("bSweep", false), arg("bTeleport", true));
        CHECK(moved.ReturnValue);
        CHECK_FALSE(moved.SweepHitResult.bBlockingHit);
        CHECK(actor.call<FVector>("k2_getactorlocation") == FVector{5, 0, 0}); // without case
        CHECK(actor.call<FVector>("GetActorLocation") == FVector{5, 0, 0});    // alias
        CHECK(actor.call<EyesViewPoint>("GetActorEyesViewPoint").OutLocation == FVector{5, 0, 0});
        CHECK(actor.call("GetActorEyesViewPoint")["OutLocation"]["X"].as<double>() == 5);
        CHECK(actor.call<bool>("K2_TeleportTo", FVector{6, 0, 0}, FRotator{}));
        CHECK(actor.call<bool>(
            "K2_SetActorLocation", FVector{5, 0, 0}, false, arg("bTeleport", true))); // the return value only
        CHECK(actor.call<bool>("ActorHasTag", "x") == false);
        CHECK(actor.call<spear::Value>("GetActorBounds", false)["BoxExtent"].as<FVector>() ==
              FVector{}); // the last parameter has a default
        actor.call(
            "SetActorScale3D", spear::Value(spear::Value::Dict{{"X", 2}, {"Y", 3}, {"Z", 4}})); // a struct as a dict
        CHECK(actor.call<FVector>("GetActorScale3D") == FVector{2, 3, 4});
        const spear::Class math = client.game.get_class("UKismetMathLibrary");
        CHECK(math.call<double>("VSize", FVector{3, 4, 0}) == doctest::Approx(5));
        CHECK(actor.call<spear::Object>("K2_GetRootComponent").derives_from("USceneComponent"));
        CHECK(actor.call<spear::Object>("GetOwner").is_null());
        client.game.destroy_actor(actor);
    });
}

TEST_CASE("properties: paths through objects and structs, arrays, setters") {
    Client client;
    client.transact([&] {
        const spear::Object actor =
            client.game.spawn_actor("ACameraActor", {.location = {1, 2, 3}, .tags = {"one", "two"}});
        CHECK(actor["RootComponent"]["RelativeLocation"]["X"].get<double>() == 1);
        CHECK(actor.property("RootComponent.RelativeLocation").get<FVector>() == FVector{1, 2, 3});
        CHECK(actor["Tags"].get<std::vector<std::string>>() == std::vector<std::string>{"one", "two"});
        CHECK(actor["Tags"][1].get<std::string>() == "two");
        actor["Tags"].set(std::vector<std::string>{"three"});
        CHECK(actor["tags"][0].get<std::string>() == "three");
        actor["CustomTimeDilation"].set(0.5);
        CHECK(actor["CustomTimeDilation"].get<float>() == 0.5f);
        actor["RootComponent"]["RelativeScale3D"]["Y"].set(7);
        CHECK(actor["RootComponent"]["RelativeScale3D"].get<FVector>() == FVector{1, 7, 1});
        CHECK(actor["RootComponent"].get<spear::Object>() == actor.call<spear::Object>("K2_GetRootComponent"));
        const spear::Value mobility = actor["RootComponent"]["Mobility"].get();
        CHECK(mobility.type_name() == "EComponentMobility");
        CHECK(mobility.as<std::string>() == "Movable");
        client.game.destroy_actor(actor);
    });
}

TEST_CASE("errors name what was asked, what was found, and what is near") {
    Client client;
    client.transact([&] {
        const spear::Object actor = client.spawn();
        CHECK(contains(
            error_text<spear::UnknownClass>([&] { client.game.get_class("AStaticMeshActr"); }), "AStaticMeshActor"));
        CHECK(contains(
            error_text<spear::UnknownFunction>([&] { actor.call("K2_GetActorLocatio"); }), "K2_GetActorLocation"));
        CHECK(contains(error_text<spear::UnknownProperty>([&] { actor["RootComponen"].get(); }), "RootComponent"));
        CHECK(contains(error_text<spear::UnknownProperty>([&] { actor["RootComponent"]["RelativeLocatio"].get(); }),
            "RelativeLocation"));
        CHECK(contains(
            error_text<spear::UnknownArgument>([&] { actor.call("SetActorScale3D", arg("NewScale", FVector{})); }),
            "NewScale3D"));
        CHECK(contains(error_text<spear::MissingArgument>([&] { actor.call("SetActorScale3D"); }), "NewScale3D"));
        CHECK_THROWS_AS(actor.call("SetActorScale3D", FVector{1, 1, 1}, 5), spear::ArgumentError); // too many
        try {
            actor.call("SetActorScale3D", arg("NewScale3D", "large"));
            FAIL_CHECK("no error");
        } catch (const spear::WrongType& error) {
            CHECK(error.info().argument == "NewScale3D");
            CHECK(contains(error.info().expected, "FVector"));
            CHECK(contains(error.info().operation, "SetActorScale3D"));
        }
        CHECK_THROWS_AS(actor["Tags"][5].get(), spear::OutOfRange);
        CHECK_THROWS_AS(actor["InitialLifeSpan"].set("long"), spear::WrongType);
        CHECK_THROWS_AS(actor["Owner"]["Tags"].get(), spear::NullObject);
        CHECK_THROWS_AS(client.game.spawn_actor("USceneComponent"), spear::WrongType);
        CHECK_THROWS_AS(client.game.spawn_actor("ANoSuchActor"), spear::UnknownClass);
        CHECK_THROWS_AS(client.game.find_actor_by_name("NoSuchActor"), spear::UnknownObject);
        CHECK_THROWS_AS(spear::Object().call("F"), spear::NullObject);
        client.game.destroy_actor(actor);
        CHECK_THROWS_AS(actor.call<FVector>("K2_GetActorLocation"), spear::StaleObject);
        CHECK_THROWS_AS(actor["Tags"].get(), spear::StaleObject);
    });
}

TEST_CASE("integers outside the range of a property are refused") {
    Client client;
    client.transact([&] {
        const spear::Object actor = client.game.spawn_actor("AStaticMeshActor");
        const spear::Property stencil = actor["StaticMeshComponent"]["CustomDepthStencilValue"];
        CHECK_THROWS_AS(stencil.set(std::int64_t{1} << 40), spear::OutOfRange);
        CHECK_THROWS_AS(stencil.set(1.5), spear::WrongType);
        stencil.set(-7);
        CHECK(stencil.get<std::int32_t>() == -7);
        CHECK_THROWS_AS(stencil.get<std::uint8_t>(), spear::OutOfRange);
        client.game.destroy_actor(actor);
    });
}

TEST_CASE("objects made by new_object live until they are released") {
    Client client;
    spear::Object object;
    client.transact([&] { object = client.game.new_object("UMaterialInstanceDynamic"); });
    CHECK(object.is_valid());
    client.transact([&] { client.game.get_class("UKismetSystemLibrary").call("CollectGarbage"); });
    client.transact(nullptr, nullptr);
    CHECK(object.is_valid());
    client.transact([&] {
        client.game.release_object(object);
        client.game.get_class("UKismetSystemLibrary").call("CollectGarbage");
    });
    client.transact(nullptr);
    client.instance.flush();
    CHECK(eventually([&] { return !object.is_valid(); }));
}
