// SPDX-License-Identifier: MIT
// Exceptions, aliases, log, launching: the rest that needs no engine.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

#include <doctest/doctest.h>
#include <csignal>
#include <unistd.h>

#include "spear/spear.hpp"

using namespace spear;

static_assert(std::is_base_of_v<std::runtime_error, Error>);
static_assert(std::is_base_of_v<Error, LookupFailed> && std::is_base_of_v<LookupFailed, UnknownClass> &&
              std::is_base_of_v<ArgumentError, WrongType>);
static_assert(std::is_base_of_v<WaitError, HeldByClient> && std::is_base_of_v<FrameError, NeedsFrames> &&
              std::is_base_of_v<ConnectionError, EngineExited>);
static_assert(std::is_nothrow_copy_constructible_v<StaleObject>);

TEST_CASE("throw_error throws the class of the code, for each code") {
    for (std::size_t i = 0; i < error_count; ++i) {
        const auto code = static_cast<ErrorCode>(i);
        try {
            throw_error(code, "text", "operation", "argument", "expected");
        } catch (const Error& error) {
            CHECK(error.code() == code);
            CHECK(error.name() == error_name(code));
            CHECK(std::string(error.what()) == "text");
            CHECK(error.info().argument == "argument");
            CHECK(error.original() == nullptr);
        }
    }
    CHECK_THROWS_AS(throw_error(ErrorCode::StaleObject, ""), StaleObject);
    CHECK_THROWS_AS(throw_error(static_cast<ErrorCode>(60000), ""), Error);
}

TEST_CASE("DependencyFailed carries the original") {
    const auto original =
        std::make_shared<const ErrorInfo>(ErrorInfo{ErrorCode::UnknownObject, "no such actor", "", "", ""});
    try {
        throw_error(ErrorInfo{ErrorCode::DependencyFailed, "an argument failed", "", "", ""}, original);
    } catch (const DependencyFailed& error) {
        REQUIRE(error.original());
        CHECK(error.original()->code == ErrorCode::UnknownObject);
    }
}

TEST_CASE("aliases") {
    CHECK(resolve_function_alias("GetActorLocation") == "K2_GetActorLocation");
    CHECK(resolve_function_alias("GetComponentLocation") == "K2_GetComponentLocation");
    CHECK(resolve_function_alias("GetWorldLocation") == "K2_GetComponentLocation");
    CHECK(resolve_function_alias("GetActorTransform") == "GetTransform");
    CHECK(resolve_function_alias("K2_GetActorLocation") == "K2_GetActorLocation");
    CHECK(resolve_function_alias("SetActorScale3D") == "SetActorScale3D");
    for (const FunctionAlias& alias : function_aliases) {
        CAPTURE(alias.alias);
        CHECK(resolve_function_alias(alias.name) == alias.name); // no chains
    }
}

TEST_CASE("the log handler receives messages and cannot throw into the SDK") {
    std::vector<std::string> messages;
    set_log_handler([&](LogLevel level, std::string_view message) {
        messages.push_back((level == LogLevel::warning ? "w:" : "e:") + std::string(message));
        throw std::runtime_error("handler");
    });
    log_message(LogLevel::warning, "a");
    log_message(LogLevel::error, "b");
    set_log_handler(nullptr);
    CHECK(messages == std::vector<std::string>{"w:a", "e:b"});
}

TEST_CASE("engine not running") {
    CHECK_THROWS_AS(connect("unix:/nonexistent/spear.sock"), EngineNotRunning);
    CHECK_THROWS_AS(connect("gopher:whatever"), Error);
}

TEST_CASE("launch") {
    const auto folder = std::filesystem::temp_directory_path() / ("spear-launch-test-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const auto script = [&](const char* name, const std::string& text) {
        const auto path = folder / name;
        std::ofstream(path) << "#!/bin/sh\n" << text;
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
        return path;
    };
    SUBCASE("of what is no program raises LaunchFailed with the reason") {
        try {
            launch({.executable = folder / "absent"});
            FAIL("no error");
        } catch (const LaunchFailed& error) {
            CHECK(std::string(error.what()).find("No such file") != std::string::npos);
        }
    }
    SUBCASE("of an engine that ends raises EngineExited with exit code and log") {
        try {
            launch({.scene = "no such place",
                .executable = script("ends", "echo arguments: \"$@\"; echo scene not found >&2; exit 7\n"),
                .connect_timeout = Milliseconds(10'000)});
            FAIL("no error");
        } catch (const EngineExited& error) {
            const std::string text = error.what();
            CAPTURE(text);
            CHECK(text.find("exit code 7") != std::string::npos);
            CHECK(text.find("scene not found") != std::string::npos);
            CHECK(text.find("arguments: --scene no such place -SpearAddress=unix:") != std::string::npos);
        }
    }
    SUBCASE("of an engine that does not answer raises EngineBusy and ends it") {
        const auto pid_file = folder / "pid";
        const auto hangs = script("hangs", "echo $$ > " + pid_file.string() + "; exec sleep 1000\n");
        int pid = 0;
        for (int timeout = 300; pid == 0 && timeout < 60'000; timeout *= 4) { // long enough for the script to start
            CHECK_THROWS_AS(launch({.executable = hangs, .connect_timeout = Milliseconds(timeout)}), EngineBusy);
            std::ifstream(pid_file) >> pid;
        }
        REQUIRE(pid > 0);
        CHECK(::kill(pid, 0) != 0);
    }
    std::filesystem::remove_all(folder);
}
