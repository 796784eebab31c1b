// SPDX-License-Identifier: MIT
// The first program of the paper, in C++: getting_started.py beside it does the same and prints the same.
//
//     tools/spear demo           runs both
//     getting_started            runs this one (starts the embedded engine)
//     getting_started --help

#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <spear/spear.hpp>

namespace {

namespace unreal = spear::unreal;
using spear::arg;

/// One transaction: spawn, scale, read back, all within one frame.
void spawn_axes(spear::Instance& instance, const spear::Game& game) {
    spear::Future<unreal::FVector> location, same_location;
    spear::Object axes;
    double scale = 0;
    {
        auto frame = instance.begin_frame(); // work of this block runs at the beginning of a frame
        axes = game.spawn_actor("ACoordinateAxes", {.location = {-10, 280, 50}});
        axes.call("SetActorScale3D", arg("NewScale3D", unreal::FVector{4, 4, 4}));
        auto root = axes["RootComponent"].get<spear::Object>();
        location = root.async<unreal::FVector>("K2_GetComponentLocation"); // a future: nothing waits
        same_location =
            root.async<unreal::FVector>("GetComponentLocation"); // the paper's spelling of the same function
        frame.execute();
    }
    {
        auto frame = instance.end_frame(); // and work of this block at the end of the same frame
        scale = axes["RootComponent"]["RelativeScale3D"]["X"].get<double>();
        frame.execute();
    }
    const unreal::FVector where = location.get();
    if (const unreal::FVector same = same_location.get(); same.X != where.X || same.Y != where.Y || same.Z != where.Z) {
        throw std::runtime_error("the two spellings disagree");
    }
    fmt::print("axes at {:.1f} {:.1f} {:.1f}, scaled by {:.1f}\n", where.X, where.Y, where.Z, scale);
}

/// A paused world, unpaused for exactly one frame at a time: deterministic, and the engine stays responsive in between.
void throw_ball(spear::Instance& instance, const spear::Game& game, int steps) {
    const spear::Class statics = game.get_class("UGameplayStatics");
    spear::Object ball;
    {
        auto frame = instance.begin_frame();
        statics.call("SetGamePaused", arg("bPaused", true));
        ball = game.spawn_actor("AStaticMeshActor", {.location = {0, 0, 200}});
        ball["StaticMeshComponent"].get<spear::Object>().call("SetMobility", arg("NewMobility", "Movable"));
        auto motion = ball.call<spear::Object>("AddComponentByClass", arg("Class", "UProjectileMovementComponent"),
            arg("bManualAttachment", false), arg("RelativeTransform", unreal::FTransform{}),
            arg("bDeferredFinish", false));
        motion["Velocity"].set(unreal::FVector{300, 0, 400}); // centimetres per second
        frame.execute();
    }
    instance.end_frame().execute();
    for (int step = 1; step <= steps; ++step) {
        {
            auto frame = instance.begin_frame();
            statics.call("SetGamePaused", arg("bPaused", false));
            frame.execute();
        }
        auto frame = instance.end_frame();
        statics.call("SetGamePaused", arg("bPaused", true));
        if (step % 10 == 0) {
            const auto location = ball.call<unreal::FVector>("K2_GetActorLocation");
            fmt::print("step {:3}: {:9.3f} {:9.3f} {:9.3f}\n", step, location.X, location.Y, location.Z);
        }
        frame.execute();
    }
}

/// What the running engine exposes, counted in its live schema.
void count_reflection(spear::Instance& instance) {
    const spear::Value schema = instance.call(spear::unreal_service::get_schema, std::vector<std::string>{});
    const spear::Value& classes = schema["classes"];
    const spear::Value& structs = schema["structs"];
    std::size_t functions = 0, properties = 0;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const spear::Value entity = classes[i];
        functions += entity["functions"].size();
        properties += entity["properties"].size();
    }
    for (std::size_t i = 0; i < structs.size(); ++i) {
        properties += structs[i]["properties"].size();
    }
    fmt::print("{} classes, {} functions, {} properties\n", classes.size(), functions, properties);
}

int run(int count, char** arguments) {
    std::string address;
    int steps = 100;
    for (int i = 1; i < count; ++i) {
        const std::string_view option = arguments[i];
        if (option == "--address" && i + 1 < count) {
            address = arguments[++i];
        } else if (option == "--steps" && i + 1 < count) {
            steps = std::atoi(arguments[++i]);
        } else {
            fmt::print("usage: getting_started [--address unix:/path|tcp://host:port] [--steps N]\n"
                       "Spawns coordinate axes, throws a ball step by step, counts what is reflected. Starts an engine "
                       "if no address is given.\n");
            return option == "--help" || option == "-h" ? 0 : 2;
        }
    }
    spear::Instance instance =
        address.empty() ? spear::launch({.scene = "apartment", .fixed_dt = 1.0 / 60}) : spear::connect(address);
    const spear::Game game = instance.game();
    spawn_axes(instance, game);
    throw_ball(instance, game, steps);
    count_reflection(instance);
    return 0;
}

} // namespace

int main(int count, char** arguments) {
    try {
        return run(count, arguments);
    } catch (const std::exception& error) {
        fmt::print(stderr, "getting_started: {}\n", error.what());
        return 1;
    }
}
