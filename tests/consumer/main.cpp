// SPDX-License-Identifier: MIT
// Built against an installed SDK, typed proxies included. With an address as argument it prints what runs there;
// without, it proves that the library links.
#include <fmt/core.h>
#include <spear/spear.hpp>
#include <spear/unreal/Engine/ACameraActor.hpp>

int main(int argc, char** argv) {
    try {
        spear::Instance instance = spear::connect(argc > 1 ? argv[1] : "unix:/nonexistent/spear.sock");
        const spear::EngineInfo info = instance.engine_info();
        fmt::print("{} {} with scene {}\n", info.engine_name, info.engine_version, info.scene);
        auto frame = instance.begin_frame();
        const auto actor = instance.game().spawn_actor<spear::unreal::ACameraActor>({.location = {1, 2, 3}});
        fmt::print("an actor at X = {}\n", actor.K2_GetActorLocation().X);
        frame.execute();
    } catch (const spear::EngineNotRunning& error) {
        fmt::print("EngineNotRunning: {}\n", error.what());
        return argc > 1 ? 1 : 0;
    }
}
