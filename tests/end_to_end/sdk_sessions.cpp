// SPDX-License-Identifier: MIT
// Connecting, versions, closing, engines that end.
#include <algorithm>
#include <csignal>
#include <optional>
#include <string>
#include <vector>

#include "engine_fixture.hpp"
#include "spear_wire.h"

using namespace end_to_end;

namespace {

/// A bare connection that says what we want it to say.
spear_wire_error connect_raw(const char* version, const std::vector<const char*>& entry_points) {
    spear_client_options options{};
    options.address = engine().process()->address().c_str();
    options.spear_version = version;
    options.client_name = "raw";
    options.connect_timeout_ms = 5000;
    options.entry_points = entry_points.data();
    options.entry_point_count = entry_points.size();
    const spear_client_callbacks callbacks{
        nullptr, [](void*, std::uint64_t, const spear_answers*) {}, [](void*, const spear_wire_error*) {}, nullptr};
    spear_wire_error error{};
    spear_client* client = spear_client_connect(&options, &callbacks, &error);
    CHECK(client == nullptr);
    spear_client_close(client);
    return error;
}

} // namespace

TEST_CASE("engine_info tells what runs") {
    Client client;
    const spear::EngineInfo info = client.instance.engine_info();
    CHECK(info.spear_version == spear::version);
    CHECK(info.engine_name == "embedded");
    CHECK(info.process_id == static_cast<std::uint64_t>(engine().process()->process_id()));
    CHECK_FALSE(info.is_editor);
    CHECK(client.instance.call(spear::engine_service::ping, "häß") == "häß");
    const std::vector<spear::WorldInfo> worlds = client.game.get_worlds();
    REQUIRE_FALSE(worlds.empty());
    CHECK(std::ranges::count_if(worlds, [](const auto& world) { return world.is_primary; }) == 1);
}

TEST_CASE("version mismatch: an entry point that the server does not have is refused by name") {
    const std::string version(spear::version);
    const spear_wire_error error =
        connect_raw(version.c_str(), {"unreal_service.no_such_thing(x: bool) -> none @game_thread"});
    CHECK(error.code == static_cast<std::uint16_t>(spear::ErrorCode::VersionMismatch));
    CHECK(contains(error.message, "no_such_thing"));
}

TEST_CASE("engine not running") {
    CHECK_THROWS_AS(spear::connect("unix:/nonexistent/spear.sock"), spear::EngineNotRunning);
    CHECK_THROWS_AS(spear::connect("tcp://127.0.0.1:1"), spear::EngineNotRunning);
}

TEST_CASE("objects and futures outlive their session and raise Disconnected") {
    spear::Object actor;
    spear::Future<FVector> future;
    {
        Client client;
        client.transact([&] {
            actor = client.spawn();
            future = actor.async<FVector>("K2_GetActorLocation");
        });
        future.get();
    }
    CHECK_THROWS_AS(actor.call("K2_GetActorLocation"), spear::Disconnected);
    CHECK(future.get() == FVector{}); // its answer had come
    CHECK(actor.class_name() == "ACameraActor");
}

TEST_CASE("a launched engine that dies raises EngineExited with the call, the signal and the log") {
    spear::Instance instance = spear::launch(launch_options());
    const spear::Game game = instance.game();
    auto frame = instance.begin_frame();
    game.get_class("AActor");
    ::kill(static_cast<pid_t>(instance.process()->process_id()), SIGSEGV);
    const std::string text = error_text<spear::EngineExited>([&] { game.get_class("APawn"); });
    CHECK(contains(text, "signal 11"));
    CHECK(contains(text, "find_class"));
    CHECK_THROWS_AS(game.get_class("APawn"), spear::EngineExited);
    CHECK_THROWS_AS(frame.execute(), spear::EngineExited);
}

TEST_CASE("a launched engine ends with its instance") {
    std::int64_t process_id = 0;
    {
        spear::Instance instance = spear::launch(launch_options());
        process_id = instance.process()->process_id();
        CHECK(::kill(static_cast<pid_t>(process_id), 0) == 0);
    }
    CHECK(::kill(static_cast<pid_t>(process_id), 0) != 0);
}

TEST_CASE("request_exit ends the engine in good order") {
    spear::Instance instance = spear::launch(launch_options());
    instance.call(spear::engine_service::request_exit);
    CHECK(instance.process()->wait(10s));
    const auto exit = instance.process()->describe_exit();
    REQUIRE(exit);
    CHECK(contains(exit->message, "exit code 0"));
}

TEST_CASE("an engine that is asked to end while a client holds it does so in good order, and the client is told") {
    for (const bool in_single_step : {false, true}) {
        CAPTURE(in_single_step);
        spear::Instance instance = spear::launch(launch_options());
        const spear::Game game = instance.game();
        Client other({.deadline = 30s}, instance);
        std::optional<spear::Frame> frame;
        if (in_single_step) {
            instance.step();
        } else {
            frame.emplace(instance.begin_frame());
            (void)game.find_actors_by_class("AActor"); // holds the game thread
        }
        other.instance.call(spear::engine_service::request_exit);
        CHECK(instance.process()->wait(60s));
        CHECK(contains(instance.process()->describe_exit()->message, "exit code 0"));
        // Our I/O thread may hear of the end a moment after it, and opening a block sends nothing.
        CHECK(eventually([&] { return !instance.session()->is_open(); }));
        if (!frame)
            CHECK_THROWS_AS(frame.emplace(instance.begin_frame()), spear::EngineExited);
        else
            CHECK_THROWS_AS((void)game.find_actors_by_class("AActor"), spear::EngineExited);
    }
}
