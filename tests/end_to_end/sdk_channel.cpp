// SPDX-License-Identifier: MIT
// The shared memory channel with a real engine at the other end: that it is used, that it can be turned off, that it
// leaves nothing behind, and that a client that writes nonsense into it only ends its own session.
#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "raw_client.hpp"

using namespace end_to_end;

namespace {

/// The files in /dev/shm of the shared engine.
std::size_t files_of_engine() {
    const std::string prefix = "spear-" + std::to_string(engine().process()->process_id()) + "-";
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/dev/shm")) {
        count += entry.path().filename().string().starts_with(prefix);
    }
    return count;
}

/// A TCP port that nobody uses at the moment.
int free_port() {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    REQUIRE(::bind(socket, reinterpret_cast<sockaddr*>(&address), size) == 0);
    REQUIRE(::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0);
    ::close(socket);
    return ntohs(address.sin_port);
}

struct Mapping {
    std::byte* data;
    std::size_t size;
};

/// This process's mappings of channels: their names are gone already.
std::vector<Mapping> mapped_channels() {
    std::vector<Mapping> found;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        if (contains(line, "/dev/shm/spear-")) {
            char* end = nullptr;
            const auto from = std::strtoull(line.c_str(), &end, 16);
            const auto to = std::strtoull(end + 1, nullptr, 16);
            found.push_back({reinterpret_cast<std::byte*>(from), static_cast<std::size_t>(to - from)});
        }
    }
    return found;
}

} // namespace

TEST_CASE("channel: used on one machine, also over TCP; off by option") {
    CHECK(Client().instance.session()->uses_channel() == channel_is_on());
    Client without({.deadline = 10s, .channel = false});
    CHECK_FALSE(without.instance.session()->uses_channel());
    CHECK(without.game.get_class("AActor").class_name() == "UClass");
    Client quiet({.deadline = 10s, .spin = false});
    CHECK(quiet.game.get_class("AActor").class_name() == "UClass");
    CHECK(files_of_engine() == 0);
    if (engine_is_apart()) {
        return; // its loopback is not ours
    }
    spear::LaunchOptions options = launch_options();
    options.address = "tcp://127.0.0.1:" + std::to_string(free_port());
    spear::Instance instance = spear::launch(options);
    CHECK(instance.session()->uses_channel() == channel_is_on());
    CHECK(instance.game().get_class("AActor").class_name() == "UClass");
}

TEST_CASE("channel: messages larger than its rings, both ways, and many at once") {
    Client client;
    client.transact([&] {
        const spear::Object trip = client.game.new_object("URoundTrip");
        std::vector<std::uint8_t> bytes(3'000'000);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 1000);
        CHECK(trip.call<std::vector<std::uint8_t>>("EchoByteArray", bytes) == bytes);
        std::vector<spear::Future<std::vector<std::uint8_t>>> futures;
        for (std::uint8_t i = 0; i < 10; ++i) {
            futures.push_back(
                trip.async<std::vector<std::uint8_t>>("EchoByteArray", std::vector<std::uint8_t>(500'000, i)));
        }
        for (std::uint8_t i = 0; i < 10; ++i)
            CHECK(futures[i].get() == std::vector<std::uint8_t>(500'000, i));
    });
}

TEST_CASE("channel: an asynchronous block larger than the ring goes out without anybody waiting for it") {
    Client client;
    std::vector<std::uint8_t> bytes(2'000'000, 3);
    spear::Future<std::vector<std::uint8_t>> echoed;
    spear::Object trip;
    client.transact([&] { trip = client.game.new_object("URoundTrip"); });
    client.transact([&] { echoed = trip.async<std::vector<std::uint8_t>>("EchoByteArray", bytes); });
    CHECK(eventually([&] { return echoed.is_ready(); }));
    CHECK(echoed.get() == bytes);
}

TEST_CASE("channel: answers arrive although nobody waits") {
    Client client;
    spear::Object trip;
    client.transact([&] { trip = client.game.new_object("URoundTrip"); });
    std::vector<spear::Future<std::vector<std::uint8_t>>> futures;
    client.transact([&] {
        for (std::uint8_t i = 0; i < 20; ++i)
            futures.push_back(
                trip.async<std::vector<std::uint8_t>>("EchoByteArray", std::vector<std::uint8_t>(100'000, i)));
    });
    for (std::uint8_t i = 0; i < 20; ++i) {
        CHECK(eventually([&] { return futures[i].is_ready(); }));
        CHECK(futures[i].get().front() == i);
    }
}

TEST_CASE("channel: many threads wait at once, each gets its own answers, and all of one future") {
    Client client;
    const auto shared = client.instance.async(spear::engine_service::ping, "shared");
    std::atomic<int> wrong{0};
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 8; ++thread) {
        threads.emplace_back([&, thread] {
            wrong += shared.get() != "shared";
            for (int i = 0; i < 300; ++i) {
                const std::string text = std::to_string(thread) + " " + std::to_string(i);
                if (i % 3 == 0) {
                    const auto first = client.instance.async(spear::engine_service::ping, text);
                    const auto second = client.instance.async(spear::engine_service::ping, text + "!");
                    wrong += second.get() != text + "!" || first.get() != text;
                } else {
                    wrong += client.instance.call(spear::engine_service::ping, text) != text;
                }
            }
        });
    }
    for (auto& thread : threads)
        thread.join();
    CHECK(wrong == 0);
}

TEST_CASE("channel: close() from another thread ends a wait") {
    Client client;
    auto frame = client.instance.begin_frame();
    (void)client.game.find_actors_by_class("AActor"); // the other client will wait
    Client waiting;
    auto other = waiting.instance.begin_frame();
    std::thread closing([&] {
        std::this_thread::sleep_for(50ms); // most likely the call waits by then; if not, it finds the session closed
        waiting.instance.close();
    });
    CHECK_THROWS_AS((void)waiting.game.find_actors_by_class("AActor"), spear::Disconnected);
    closing.join();
}

TEST_CASE("channel: a deadline passes while another client holds the engine") {
    Client holding;
    auto frame = holding.instance.begin_frame();
    (void)holding.game.find_actors_by_class("AActor");
    Client waiting({.deadline = 1s});
    auto other = waiting.instance.begin_frame();
    CHECK_THROWS_AS((void)waiting.game.find_actors_by_class("AActor"), spear::HeldByClient);
}

TEST_CASE("channel: nonsense in the ring ends the session with MalformedMessage; the engine and other clients go on") {
    if (!channel_is_on()) {
        return;
    }
    std::mt19937_64 random(11);
    Client witness;
    int lost = 0;
    constexpr int rounds = 24;
    for (int round = 0; round < rounds; ++round) {
        const std::vector<Mapping> before = mapped_channels();
        RawClient client;
        REQUIRE(client.connected());
        std::vector<Mapping> added = mapped_channels();
        std::erase_if(added, [&](const Mapping& one) {
            return std::ranges::any_of(before, [&](const Mapping& other) { return other.data == one.data; });
        });
        REQUIRE(added.size() == 1);
        if (round % 2 == 0) { // while the game thread itself reads
            RawClient::Batch holds;
            holds.transaction = 1;
            holds.block = SPEAR_BLOCK_BEGIN;
            RawClient::add(holds, spear::unreal_service::find_class, 1,
                [](spear::Encoder& out) { spear::encode_value(out, std::string_view("AActor")); });
            REQUIRE(client.exchange(holds));
        }
        // Layout: docs/protocol.md, "The channel".
        constexpr std::size_t tail_at = 128, ring_at = 4096;
        for (std::size_t at = ring_at; at < added[0].size; ++at) {
            added[0].data[at] = static_cast<std::byte>(random());
        }
        auto* const tail = reinterpret_cast<std::uint64_t*>(added[0].data + tail_at);
        __atomic_fetch_add(tail, round % 4 == 3 ? random() : 8 + random() % 1000, __ATOMIC_SEQ_CST);
        lost += client.lost();
        CHECK(witness.frames_go_on());
        CHECK(witness.game.get_class("AActor").class_name() == "UClass");
    }
    CHECK(lost == rounds);
}

TEST_CASE("channel: kill -9 in any state frees the engine at once and leaves nothing in /dev/shm") {
    Client witness;
    std::mt19937 random(12);
    for (const char* const state : {"kill: idle", "kill: in single_step", "kill: recording", "kill: calling",
             "kill: calling in the end block", "kill: flooding", "kill: sending much"}) {
        CAPTURE(state);
        for (int round = 0; round < 4; ++round) {
            const int child = start_child(state);
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 20'000));
            ::kill(child, SIGKILL);
            wait_for_child(child);
            CHECK(witness.frames_go_on());
        }
    }
    CHECK(files_of_engine() == 0);
}
