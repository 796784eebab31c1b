// SPDX-License-Identifier: MIT
// end_to_end_tests [doctest options]; or, as a child of a test, `end_to_end_tests --child WHAT ADDRESS`: a client that
// dies or hangs; or `--determinism STEPS FILE ADDRESS` (determinism.hpp).
#define DOCTEST_CONFIG_IMPLEMENT
#include "determinism.hpp"
#include "engine_fixture.hpp"

#include <memory>
#include <string_view>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace end_to_end {
namespace {

std::unique_ptr<spear::Instance>& shared() {
    static std::unique_ptr<spear::Instance> instance;
    return instance;
}

/// Holds the engine's game thread, says so by writing a byte to standard output, then dies or hangs as asked.
int be_child(std::string_view what, const char* address) {
    const bool has_no_lease = what == "hang without a lease";
    const bool has_default_lease = what == "hang idle";
    spear::Instance instance = spear::connect(address,
        {.client_name = "the child",
            .lease = has_default_lease ? 0ms : what == "hang" ? 1000ms : 20'000ms,
            .no_lease = has_no_lease});
    const auto say_ready = [] { [[maybe_unused]] const auto written = ::write(STDOUT_FILENO, "!", 1); };
    const spear::Game game = instance.game();
    const auto hold = [&] { (void)game.find_actors_by_class("AActor"); }; // synchronous: holds the game thread
    // Those that wait to be killed, see start_child in sdk_channel.cpp.
    if (what == "kill: idle") {
        say_ready();
        ::pause();
    } else if (has_default_lease) {
        say_ready();
        ::raise(SIGSTOP);
    } else if (what == "kill: in single_step") {
        instance.step();
        say_ready();
        ::pause();
    } else if (what == "kill: recording") {
        auto frame = instance.begin_frame();
        const auto future = game.async().find_actors_by_class("AActor");
        say_ready();
        ::pause();
    } else if (what == "kill: calling") {
        auto frame = instance.begin_frame();
        hold();
        say_ready();
        for (;;)
            hold();
    } else if (what == "kill: calling in the end block") {
        instance.begin_frame().execute();
        auto frame = instance.end_frame();
        hold();
        say_ready();
        for (;;)
            hold();
    } else if (what == "kill: flooding") {
        for (bool first = true;; first = false) {
            auto frame = instance.begin_frame();
            for (int i = 0; i < 100; ++i)
                game.send().find_actors_by_class("AActor");
            frame.execute();
            instance.end_frame().execute();
            if (first)
                say_ready();
        }
    } else if (what == "kill: sending much") {
        const std::string text(8u << 20, 'x');
        say_ready();
        for (;;)
            instance.call(spear::engine_service::ping, text);
    }
    auto frame = instance.begin_frame();
    instance.call(
        spear::unreal_service::find_actors_by_class, nullptr, "AActor", ""); // synchronous: holds the game thread
    if (what == "between") {
        frame.execute();
        instance.flush();
    }
    [[maybe_unused]] const auto written = ::write(STDOUT_FILENO, "!", 1);
    if (what == "hang" || has_no_lease) {
        ::raise(SIGSTOP);
    }
    ::_exit(0); // no destructor runs: as after a crash
}

} // namespace

spear::LaunchOptions launch_options() {
    const char* const other = std::getenv("SPEAR_TEST_ENGINE");    // see run_apart
    const char* const address = std::getenv("SPEAR_TEST_ADDRESS"); // another one than a Unix socket of its own
    return {.fps = 200,
        .fixed_dt = fixed_dt,
        .seed = 1,
        .executable = other ? other : SPEAR_TEST_ENGINE,
        .arguments = {"--plugin-dir", SPEAR_TEST_PLUGINS},
        .address = address ? address : "",
        .connect_timeout = 60s,
        .deadline = 10s};
}

spear::Instance& engine() {
    if (!shared())
        shared() = std::make_unique<spear::Instance>(spear::launch(launch_options()));
    return *shared();
}

void close_engine() { shared().reset(); }

int start_child(const std::string& what, std::string address) {
    if (address.empty())
        address = engine().process()->address();
    int ends[2];
    REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::string program("/proc/self/exe"), option("--child"), argument(what);
    char* argv[] = {program.data(), option.data(), argument.data(), address.data(), nullptr};
    pid_t process_id = 0;
    REQUIRE(::posix_spawn(&process_id, "/proc/self/exe", &actions, nullptr, argv, environ) == 0);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    char ready = 0;
    CHECK(::read(ends[0], &ready, 1) == 1);
    ::close(ends[0]);
    return process_id;
}

void wait_for_child(int process_id) {
    int status = 0;
    ::waitpid(process_id, &status, 0);
}

} // namespace end_to_end

int main(int argc, char** argv) {
    if (argc == 4 && std::string_view(argv[1]) == "--child") {
        return end_to_end::be_child(argv[2], argv[3]);
    }
    if (argc == 5 && std::string_view(argv[1]) == "--determinism") {
        return end_to_end::run_determinism(argv[2], argv[3], argv[4]);
    }
    doctest::Context context(argc, argv);
    const int result = context.run();
    end_to_end::close_engine();
    return result;
}
