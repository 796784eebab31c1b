// SPDX-License-Identifier: MIT
// Calls, futures, paths and lookups through the proxies of the engine's own classes.
#include "fixture.hpp"

#include <spear/unreal/Engine/ACameraActor.hpp>
#include <spear/unreal/Engine/AStaticMeshActor.hpp>
#include <spear/unreal/Engine/FActorTickFunction.hpp>
#include <spear/unreal/Engine/UCameraComponent.hpp>
#include <spear/unreal/Engine/UGameplayStatics.hpp>
#include <spear/unreal/Engine/UKismetMathLibrary.hpp>
#include <spear/unreal/Engine/UKismetSystemLibrary.hpp>
#include <spear/unreal/Engine/UMaterialInstanceDynamic.hpp>
#include <spear/unreal/Engine/UStaticMesh.hpp>
#include <spear/unreal/Engine/UStaticMeshComponent.hpp>

using namespace proxies;
using spear::Future;
using unreal::FVector;

TEST_CASE("the issue's own lines") {
    Client client;
    Future<FVector> location;
    double x = 0;
    client.transact(
        [&] {
            auto axes = client.game.spawn_actor<unreal::AStaticMeshActor>({.location = {-10, 280, 50}});
            axes.SetMobility(unreal::EComponentMobility::Movable);
            axes.SetActorScale3D({4, 4, 4});
            const unreal::USceneComponent root = axes.RootComponent().get();
            location = root.async().K2_GetComponentLocation();
            CHECK(axes.GetActorScale3D() == FVector{4, 4, 4});
            axes.send().SetActorScale3D({.X = 1, .Y = 2, .Z = 3});
            CHECK(axes.GetActorScale3D() == FVector{1, 2, 3});
            x = axes.RootComponent().RelativeLocation().X().get();
            client.game.get_class<unreal::UGameplayStatics>().SetGamePaused(false);
            client.game.destroy_actor(axes);
        },
        nullptr);
    CHECK(location.get() == FVector{-10, 280, 50});
    CHECK(x == -10);
}

TEST_CASE("futures of proxies are used like the proxies, without a round trip") {
    Client client;
    Future<FVector> moved, scale;
    Future<double> y;
    Future<unreal::AActor_K2_SetActorLocation_Result> result;
    client.transact([&] {
        const auto actor = client.game.async().spawn_actor<unreal::ACameraActor>({.location = {1, 2, 3}});
        const auto other = client.game.async().spawn_actor<unreal::ACameraActor>({.location = {7, 8, 9}});
        result = actor.async().K2_SetActorLocation(other.async().K2_GetActorLocation(), false, true); // G8
        moved = actor.async().K2_GetActorLocation();
        actor.send().SetActorScale3D(moved);
        scale = actor.async().GetActorScale3D();
        y = actor.async().RootComponent().RelativeLocation().Y().get();
        actor.RootComponent().RelativeRotation().Yaw().send_set(90);
        CHECK_FALSE(moved.is_ready());                      // nothing has been sent
        CHECK(actor.GetActorScale3D() == FVector{7, 8, 9}); // synchronous, on the future's object
        CHECK(actor.RootComponent().RelativeRotation().get().Yaw == 90);
        CHECK(moved.is_ready());
        CHECK(actor.RootComponent().get() == actor.get().K2_GetRootComponent());
        CHECK(actor.async<FVector>("K2_GetActorLocation").get() == FVector{7, 8, 9}); // by name still works
        client.game.destroy_actor(actor);
        client.game.destroy_actor(other);
    });
    CHECK(moved.get() == FVector{7, 8, 9});
    CHECK(scale.get() == FVector{7, 8, 9});
    CHECK(y.get() == 8);
    CHECK(result.get().ReturnValue);
    CHECK_FALSE(result.get().SweepHitResult.bBlockingHit);
}

TEST_CASE("properties: read, written, asynchronous, nested, elements") {
    Client client;
    Future<double> later;
    client.transact([&] {
        auto actor = client.game.spawn_actor<unreal::ACameraActor>({.location = {1, 2, 3}, .tags = {"one", "two"}});
        CHECK(actor.CustomTimeDilation().get() == 1.0f);
        actor.CustomTimeDilation().set(0.5);
        CHECK(actor.CustomTimeDilation().get() == 0.5f);
        Future<void> written = actor.CustomTimeDilation().async_set(0.25);
        CHECK(actor.async().CustomTimeDilation().get().get() == 0.25f);
        written.get();
        actor.send().CustomTimeDilation().set(2);
        CHECK(actor.CustomTimeDilation().async_get().get() == 2.0f);
        CHECK(actor.Tags().get() == std::vector<std::string>{"one", "two"});
        CHECK(actor.Tags()[1].get() == "two");
        actor.Tags().set({"three", "four"});
        actor.Tags()[0].set("five");
        CHECK(actor.Tags().get() == std::vector<std::string>{"five", "four"});
        actor.RootComponent().RelativeLocation().set({4, 5, 6});
        actor.RootComponent().RelativeLocation().Y().set(50);
        CHECK(actor.RootComponent().RelativeLocation().get() == FVector{4, 50, 6});
        CHECK(actor.RootComponent().RelativeLocation().path() == "RootComponent.RelativeLocation");
        CHECK(actor.RootComponent().Mobility().get() == unreal::EComponentMobility::Movable);
        CHECK(actor.PrimaryActorTick().bCanEverTick().get() ==
              actor.property("PrimaryActorTick.bCanEverTick").get<bool>());
        CHECK(actor.RootComponent().K2_GetComponentLocation() ==
              FVector{1, 2, 3}); // a call at the end of a path; raw writes move nothing
        later = actor.RootComponent().async().RelativeLocation().X().get();
        CHECK(actor.Owner().get().is_null());
        CHECK_THROWS_AS(actor.Owner().Tags().get(), spear::NullObject);
        CHECK_THROWS_AS(actor.Tags()[9].get(), spear::OutOfRange);
        client.game.destroy_actor(actor);
    });
    CHECK(later.get() == 4);
}

TEST_CASE("several outputs, defaults, enums, objects and classes as arguments") {
    Client client;
    client.transact([&] {
        auto actor = client.game.spawn_actor<unreal::ACameraActor>({.location = {1, 2, 3}});
        auto [moved, hit] = actor.K2_SetActorLocation({5, 0, 0}, false, true);
        CHECK(moved);
        CHECK_FALSE(hit.bBlockingHit);
        CHECK(hit.Location->X == 0);
        CHECK(actor.GetActorEyesViewPoint().OutLocation == FVector{5, 0, 0});
        const auto parent = client.game.spawn_actor<unreal::ACameraActor>({.location = {100, 0, 0}});
        const bool attached = actor.K2_AttachToActor(parent, "None", unreal::EAttachmentRule::KeepWorld,
            unreal::EAttachmentRule::KeepWorld, unreal::EAttachmentRule::KeepWorld, false);
        CHECK(attached);
        CHECK(actor.GetAttachParentActor() == parent);
        const std::vector<unreal::AActor> attached_actors =
            parent.GetAttachedActors().OutActors; // its parameters have defaults
        CHECK(attached_actors.size() == 1);
        actor.SetOwner(parent);
        CHECK(actor.GetOwner() == parent);
        actor.SetOwner(nullptr);
        CHECK(actor.GetOwner().is_null());
        const auto component = actor.GetComponentByClass(spear::class_of<unreal::UCameraComponent>);
        CHECK(component.cast<unreal::UCameraComponent>().FieldOfView().get() > 0);
        CHECK(actor.GetComponentByClass("UCameraComponent") == component);
        CHECK(actor.GetComponentByClass(client.game.get_class<unreal::UCameraComponent>()) == component);
        CHECK(client.game.find_component_by_class<unreal::UCameraComponent>(actor) == component);
        client.game.destroy_actor(actor);
        client.game.destroy_actor(parent);
    });
}

TEST_CASE("static functions on classes, asynchronous ones too; the world context is filled in") {
    Client client;
    Future<double> size;
    client.transact([&] {
        const auto math = client.game.get_class<unreal::UKismetMathLibrary>();
        CHECK(math.VSize(FVector{3, 4, 0}) == doctest::Approx(5));
        CHECK(math.Add_VectorVector({1, 2, 3}, {1, 1, 1}) == FVector{2, 3, 4});
        size = math.async().VSize(math.async().Add_VectorVector({1, 2, 2}, FVector{}));
        const Future<spear::ClassOf<unreal::UKismetMathLibrary>> later =
            client.game.async().get_class<unreal::UKismetMathLibrary>();
        CHECK(later.async().Sqrt(9.0).get() == doctest::Approx(3));
        const auto statics = client.game.get_class<unreal::UGameplayStatics>();
        CHECK_FALSE(statics.IsGamePaused());
        CHECK(statics.GetAllActorsOfClass(spear::class_of<unreal::ACameraActor>).OutActors.size() ==
              client.game.find_actors_by_class<unreal::ACameraActor>().size());
        CHECK(statics.class_path() == "/Script/CoreUObject.Class");
        CHECK(statics.unreal_name == "UClass");
    });
    CHECK(size.get() == doctest::Approx(3));
}

TEST_CASE("typed lookups") {
    Client client;
    client.transact([&] {
        const auto made = client.game.new_object<unreal::UMaterialInstanceDynamic>();
        CHECK(made.class_name() == "UMaterialInstanceDynamic");
        client.game.release_object(made);
        const unreal::AActor fallback = client.game.get_default_object<unreal::AActor>();
        CHECK(fallback.derives_from("AActor"));
        const auto actor =
            client.game.spawn_actor<unreal::ACameraActor>({.name = "ProxyTests", .tags = {"proxy_tests"}});
        CHECK(client.game.find_actor_by_name<unreal::ACameraActor>("ProxyTests") == actor);
        CHECK(client.game.find_actors_by_tag<unreal::AActor>("proxy_tests").at(0) == actor);
        CHECK_THROWS_AS(client.game.find_actor_by_name<unreal::AStaticMeshActor>("ProxyTests"), spear::LookupFailed);
        CHECK_THROWS_AS(actor.cast<unreal::AStaticMeshActor>(), spear::WrongType);
        const unreal::AActor base = actor; // up without a cast
        CHECK(base.cast<unreal::ACameraActor>() == actor);
        client.game.destroy_actor(actor);
    });
}

TEST_CASE("errors come as from calls by name") {
    Client client;
    client.transact([&] {
        CHECK_THROWS_AS(unreal::AActor().GetActorScale3D(), spear::NullObject);
        CHECK_THROWS_AS(unreal::AActor().RootComponent().get(), spear::NullObject);
        CHECK_THROWS_AS(Future<unreal::AActor>().GetActorScale3D(), spear::ArgumentError);
        const auto actor = client.game.spawn_actor<unreal::ACameraActor>();
        client.game.destroy_actor(actor);
        CHECK_THROWS_AS(actor.GetActorScale3D(), spear::StaleObject);
        CHECK_THROWS_AS(actor.RootComponent().RelativeLocation().get(), spear::StaleObject);
    });
}

static_assert(sizeof(unreal::AStaticMeshActor) == sizeof(spear::Object));
static_assert(sizeof(unreal::UStaticMeshComponent) == sizeof(spear::Object));
static_assert(sizeof(spear::SubclassOf<unreal::AActor>) == sizeof(spear::Object));
static_assert(sizeof(spear::ClassOf<unreal::UGameplayStatics>) == sizeof(spear::Object));
static_assert(sizeof(Future<unreal::AActor>) == sizeof(Future<int>));
static_assert(std::derived_from<unreal::AStaticMeshActor, unreal::AActor>);
static_assert(std::is_same_v<decltype(std::declval<unreal::AActor>().K2_GetActorLocation()), FVector>);
static_assert(std::is_same_v<decltype(std::declval<unreal::AActor>().async().K2_GetActorLocation()), Future<FVector>>);
static_assert(std::is_void_v<decltype(std::declval<unreal::AActor>().send().K2_GetActorLocation())>);
static_assert(std::is_same_v<decltype(std::declval<unreal::AActor>().RootComponent().get()), unreal::USceneComponent>);
static_assert(std::is_same_v<decltype(std::declval<Future<unreal::AActor>>().RootComponent().async_get()),
    Future<unreal::USceneComponent>>);
