// SPDX-License-Identifier: MIT
// getting_started.cpp with typed proxies (<spear/unreal/MODULE/TYPE.hpp>): the compiler knows every function, property
// and argument. Does the same and prints the same but the last line.
//
//     getting_started_typed [ADDRESS [STEPS]]      starts the embedded engine if there is no address, or it is ""

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include <spear/spear.hpp>
#include <spear/unreal/Engine/ACoordinateAxes.hpp>
#include <spear/unreal/Engine/AStaticMeshActor.hpp>
#include <spear/unreal/Engine/UGameplayStatics.hpp>
#include <spear/unreal/Engine/UProjectileMovementComponent.hpp>
#include <spear/unreal/Engine/UStaticMeshComponent.hpp>

namespace {

namespace unreal = spear::unreal;

/// One transaction: spawn, scale, read back, all within one frame.
void spawn_axes(spear::Instance& instance, const spear::Game& game) {
    spear::Future<unreal::FVector> location;
    unreal::ACoordinateAxes axes;
    double scale = 0;
    {
        auto frame = instance.begin_frame();
        axes = game.spawn_actor<unreal::ACoordinateAxes>({.location = {-10, 280, 50}});
        axes.SetActorScale3D({4, 4, 4});
        const unreal::USceneComponent root = axes.RootComponent().get();
        location = root.async().K2_GetComponentLocation(); // a future: nothing waits
        frame.execute();
    }
    {
        auto frame = instance.end_frame();
        scale = axes.RootComponent().RelativeScale3D().X().get(); // one round trip
        frame.execute();
    }
    const unreal::FVector where = location.get();
    fmt::print("axes at {:.1f} {:.1f} {:.1f}, scaled by {:.1f}\n", where.X, where.Y, where.Z, scale);
}

/// A paused world, unpaused for exactly one frame at a time.
void throw_ball(spear::Instance& instance, const spear::Game& game, int steps) {
    const auto statics = game.get_class<unreal::UGameplayStatics>();
    unreal::AStaticMeshActor ball;
    {
        auto frame = instance.begin_frame();
        statics.SetGamePaused(true);
        ball = game.spawn_actor<unreal::AStaticMeshActor>({.location = {0, 0, 200}});
        ball.StaticMeshComponent().SetMobility(unreal::EComponentMobility::Movable);
        const auto motion =
            ball.AddComponentByClass(spear::class_of<unreal::UProjectileMovementComponent>, false, {}, false)
                .cast<unreal::UProjectileMovementComponent>();
        motion.Velocity().set({300, 0, 400}); // centimetres per second
        frame.execute();
    }
    instance.end_frame().execute();
    for (int step = 1; step <= steps; ++step) {
        {
            auto frame = instance.begin_frame();
            statics.SetGamePaused(false);
            frame.execute();
        }
        auto frame = instance.end_frame();
        statics.SetGamePaused(true);
        if (step % 10 == 0) {
            const unreal::FVector location = ball.K2_GetActorLocation();
            fmt::print("step {:3}: {:9.3f} {:9.3f} {:9.3f}\n", step, location.X, location.Y, location.Z);
        }
        frame.execute();
    }
}

} // namespace

int main(int count, char** arguments) {
    try {
        const std::string address = count > 1 ? arguments[1] : "";
        const int steps = count > 2 ? std::atoi(arguments[2]) : 100;
        spear::Instance instance =
            address.empty() ? spear::launch({.scene = "apartment", .fixed_dt = 1.0 / 60}) : spear::connect(address);
        spawn_axes(instance, instance.game());
        throw_ball(instance, instance.game(), steps);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "getting_started_typed: {}\n", error.what());
        return 1;
    }
}
