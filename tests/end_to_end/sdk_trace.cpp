// SPDX-License-Identifier: MIT
// spear::Trace. What is in the file is tested in tests/python/test_trace.py, by the same recorder.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "engine_fixture.hpp"

using namespace end_to_end;

TEST_CASE("a trace has this program and the engine, and is written once") {
    Client client;
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("spear-trace-" + std::to_string(::getpid()) + ".json");
    {
        spear::Trace trace(client.instance, {.file = file});
        CHECK_THROWS_AS(spear::Trace(client.instance, {.file = file}), spear::ArgumentError);
        for (int i = 0; i < 3; ++i)
            client.transact([&] { (void)client.game.async().find_actors_by_class("AActor"); });
        client.instance.flush();
        trace.stop();
        trace.stop();
        CHECK(std::filesystem::file_size(file) > 0);
        std::filesystem::resize_file(file, 0);
    }
    CHECK(std::filesystem::file_size(file) == 0); // its end does not write again
    {
        const spear::Trace trace(client.instance, {.file = file, .operations = true});
        for (int i = 0; i < 3; ++i)
            client.transact([&] { (void)client.game.async().find_actors_by_class("AActor"); });
        client.instance.flush();
    }
    std::ifstream in(file);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    for (const char* const part : {"\"begin_frame block\"", "\"send\"", "\"receive\"", "\"begin work\"", "\"end work\"",
             "\"world tick\"", "unreal_service.find_actors_by_class", "\"game thread\"", "\"dropped_events\":0"}) {
        CAPTURE(part);
        CHECK(contains(text, part));
    }
    std::filesystem::remove(file);
    CHECK_THROWS_AS(spear::Trace(client.instance, {}), spear::ArgumentError);
}

TEST_CASE("limits: events of a trace") {
    Client client;
    CHECK_THROWS_AS(client.instance.call(spear::trace_service::start, false, spear::limits::max_trace_events + 1),
        spear::LimitExceeded);
    CHECK_THROWS_AS(client.instance.call(spear::trace_service::start, false, std::uint64_t{0}), spear::LimitExceeded);
    CHECK_THROWS_AS(
        client.instance.call(spear::trace_service::stop, std::uint64_t{0}, std::uint64_t{0}), spear::UnknownObject);
}
