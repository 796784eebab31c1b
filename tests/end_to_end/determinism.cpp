// SPDX-License-Identifier: MIT
#include "determinism.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "engine_fixture.hpp"

namespace end_to_end {
namespace {

using unreal::FTransform;

/// Of each kind: balls that fly, wheels that turn, and chains of actors attached to both.
constexpr int groups = 6;

struct Scene {
    spear::Game game;
    std::vector<spear::Object> actors;

    spear::Object spawn(double x, double y, double z) {
        return actors.emplace_back(game.spawn_actor("ACameraActor", {.location = {x, y, z}}));
    }
    spear::Object add(const spear::Object& actor, const char* component) {
        return actor.call<spear::Object>("AddComponentByClass", arg("Class", component), arg("bManualAttachment", false),
            arg("RelativeTransform", FTransform{}), arg("bDeferredFinish", false));
    }
    void attach(const spear::Object& child, const spear::Object& parent) {
        child.call("K2_AttachToActor", arg("ParentActor", parent), arg("SocketName", "None"),
            arg("LocationRule", "KeepWorld"), arg("RotationRule", "KeepWorld"), arg("ScaleRule", "KeepWorld"),
            arg("bWeldSimulatedBodies", false));
    }
    void build() {
        const spear::Class random = game.get_class("UKismetMathLibrary");
        for (int i = 0; i < groups; ++i) {
            const spear::Object ball = spawn(50.0 * i, 0, 200 + 10.0 * i);
            const spear::Object motion = add(ball, "UProjectileMovementComponent");
            const auto speed = random.call<double>("RandomFloatInRange", arg("Min", 50.0), arg("Max", 150.0));
            motion["bRotationFollowsVelocity"].set(i % 2 == 0);
            motion["Velocity"].set(FVector{speed, 7.0 * i, 300});
            const spear::Object wheel = spawn(50.0 * i, 300, 100);
            const spear::Object rotation = add(wheel, "URotatingMovementComponent");
            rotation["RotationRate"].set(FRotator{11.0 * i, 45, 3.0 * i});
            rotation["PivotTranslation"].set(FVector{1.0 * i, 20, 0});
            spear::Object parent = i % 2 == 0 ? wheel : ball;
            for (int link = 1; link <= 3; ++link) {
                const spear::Object child = spawn(50.0 * i + 10 * link, 310, 100 + 20.0 * link);
                attach(child, parent);
                parent = child;
            }
            add(parent, "URotatingMovementComponent")["RotationRate"].set(FRotator{0, 0, 90});
        }
    }
};

} // namespace

std::vector<double> run_scene(spear::Instance& instance, std::uint64_t steps) {
    Scene scene{instance.game(), {}};
    const spear::Class statics = scene.game.get_class("UGameplayStatics");
    const spear::Class random = scene.game.get_class("UKismetMathLibrary");
    {
        auto frame = instance.begin_frame();
        scene.build();
        frame.execute();
        instance.end_frame().execute();
    }
    std::vector<double> numbers;
    numbers.reserve(steps * scene.actors.size() * 10);
    for (std::uint64_t step = 0; step < steps; ++step) {
        {
            auto frame = instance.begin_frame();
            statics.send("SetGamePaused", arg("bPaused", false));
            const auto push = random.async<double>("RandomFloatInRange", arg("Min", -1.0), arg("Max", 1.0));
            const spear::Object& pushed = scene.actors[step % scene.actors.size()];
            pushed.send("K2_AddActorWorldOffset",
                arg("DeltaLocation", std::map<std::string, spear::Future<double>>{{"X", push}, {"Y", push}, {"Z", push}}),
                arg("bSweep", false), arg("bTeleport", true));
            frame.execute();
        }
        std::vector<spear::Future<FTransform>> transforms;
        {
            auto frame = instance.end_frame();
            statics.send("SetGamePaused", arg("bPaused", true));
            for (const spear::Object& actor : scene.actors)
                transforms.push_back(actor.async<FTransform>("GetTransform"));
            frame.execute();
        }
        for (const auto& future : transforms) {
            const FTransform value = future.get();
            for (const double number :
                {value.Rotation.X, value.Rotation.Y, value.Rotation.Z, value.Rotation.W, value.Translation.X,
                    value.Translation.Y, value.Translation.Z, value.Scale3D.X, value.Scale3D.Y, value.Scale3D.Z})
                numbers.push_back(number);
        }
    }
    return numbers;
}

int run_determinism(const char* steps, const char* file, const char* address) {
    try {
        spear::Instance instance = spear::connect(address, {.deadline = 120s});
        const std::vector<double> numbers = run_scene(instance, std::strtoull(steps, nullptr, 10));
        std::ofstream out(file, std::ios::binary);
        out.write(reinterpret_cast<const char*>(numbers.data()),
            static_cast<std::streamsize>(numbers.size() * sizeof(double)));
        return out.flush() ? 0 : 1;
    } catch (const spear::Error& error) {
        std::fprintf(stderr, "%s: %s\n", std::string(error.name()).c_str(), error.what());
        return 1;
    }
}

} // namespace end_to_end
