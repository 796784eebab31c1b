// SPDX-License-Identifier: MIT
#pragma once

// The engine that the tests of this binary share: started at the first use, ended by main(). Each test has a session of
// its own, so that no test inherits another's open blocks.

#include <chrono>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <thread>

#include <doctest/doctest.h>

#include "spear/spear.hpp"

namespace end_to_end {

using namespace std::chrono_literals;
namespace unreal = spear::unreal;
using spear::arg;
using unreal::FRotator;
using unreal::FVector;

/// Simulated seconds per frame of the shared engine.
inline constexpr double fixed_dt = 1.0 / 60;

/// How every engine of these tests is started.
spear::LaunchOptions launch_options();

/// The shared engine.
spear::Instance& engine();
void close_engine();

/// Waits until a condition holds; false if it does not within a time that only a broken program takes.
template <typename F>
bool eventually(F&& condition) {
    const auto ends = std::chrono::steady_clock::now() + 30s;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > ends)
            return false;
        std::this_thread::sleep_for(2ms);
    }
    return true;
}

/// A session of its own, with a world and two blocks at hand.
struct Client {
    spear::Instance instance;
    spear::Game game;

    explicit Client(spear::SessionOptions options = {.deadline = 30s}, spear::Instance& of = engine())
        : instance(spear::connect(of.process()->address(), std::move(options))), game(instance.game()) {}

    /// Runs one transaction; `end` may be empty.
    void transact(const std::function<void()>& begin, const std::function<void()>& end = nullptr,
        spear::EndFrameOptions options = {}) {
        {
            auto frame = instance.begin_frame();
            if (begin)
                begin();
            frame.execute();
        }
        auto frame = instance.end_frame(options);
        if (end)
            end();
        frame.execute();
    }
    /// An actor with a movable scene component as its root.
    spear::Object spawn(FVector location = {}) {
        return game.spawn_actor("ACameraActor", {.location = {location.X, location.Y, location.Z}});
    }
    std::uint64_t frame_number() { return instance.frame_number(); }
    /// Whether the engine runs frames: waits for two of them, long.
    bool frames_go_on() {
        const std::uint64_t before = frame_number();
        return eventually([&] { return frame_number() > before + 1; });
    }
    /// Whether the engine, which must be held already, runs no frame for a while.
    bool frames_stand() {
        const std::uint64_t before = frame_number();
        std::this_thread::sleep_for(150ms);
        return frame_number() == before;
    }
    /// Returns when the server has everything that this client has sent: a session's messages arrive in order.
    void arrive() { instance.call(spear::engine_service::ping, ""); }
};

/// The frame of the engine in which a future's operation ran.
template <typename T>
std::uint64_t frame_of(const spear::Future<T>& future) {
    return future.operation().get().frame;
}

/// Whether the engine has a network and shared memory of its own (run_apart).
inline bool engine_is_apart() { return std::getenv("SPEAR_TEST_APART") != nullptr; }

/// Whether sessions may use shared memory here: SPEAR_CHANNEL=off turns it off for whole runs of these tests.
inline bool channel_is_on() {
    const char* const setting = std::getenv("SPEAR_CHANNEL");
    return !engine_is_apart() && (!setting || std::string_view(setting) != "off");
}

/// Starts this program again to be a client of the shared engine, or the one at the address, that dies or hangs: see
/// main.cpp. Returns its process id when the client has said that it is where it shall be.
int start_child(const std::string& what, std::string address = {});
void wait_for_child(int process_id);

/// The text of the error that f raises, which must be an E; empty if it raises none.
template <typename E, typename F>
std::string error_text(F&& f) {
    try {
        f();
    } catch (const E& error) {
        return error.what();
    } catch (const spear::Error& error) {
        FAIL_CHECK(std::string(error.name()) << ": " << error.what());
        return {};
    }
    FAIL_CHECK("no error was raised");
    return {};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace end_to_end
