// SPDX-License-Identifier: MIT
// Several clients of one engine (order, sharing of frames, one that holds while others wait), clients that vanish (G7),
// and an engine that runs no frames.
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "engine_fixture.hpp"

#include "spear_wire.h"

using namespace end_to_end;
using State = spear::Session::Status::State;

namespace {

/// The sessions of the engine at an address, as it tells them itself.
std::uint32_t sessions_at(const std::string& address) {
    spear_description description{};
    spear_wire_error error{};
    REQUIRE(spear_describe(address.c_str(), 10'000, &description, &error) == 0);
    return description.sessions;
}

struct TicketClient : Client {
    const spear::Class calls = game.get_class("URoundTripCalls");
    /// A number that tells in which order the calls of all clients ran.
    spear::Future<std::int64_t> ticket() { return calls.async<std::int64_t>("Ticket"); }
};

struct Folder {
    std::filesystem::path path;
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "spear-test-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path = name;
    }
    ~Folder() { std::filesystem::remove_all(path); }
};

} // namespace

TEST_CASE("several clients: begin works run in order of arrival, end works in the same order, all in one frame") {
    TicketClient holder, a, b, c;
    auto held = holder.instance.begin_frame();
    const auto first = holder.ticket();
    first.get(); // holds the engine: the others arrive meanwhile
    std::vector<spear::Future<std::int64_t>> begins{first};
    const std::vector<TicketClient*> arrivals{&b, &c, &a};
    for (TicketClient* const client : arrivals) {
        auto frame = client->instance.begin_frame();
        begins.push_back(client->ticket());
        frame.execute();
        client->arrive();
    }
    CHECK_FALSE(begins.back().is_ready());
    held.execute();
    for (std::size_t i = 1; i < begins.size(); ++i)
        CHECK(begins[i].get() == begins[i - 1].get() + 1);

    std::vector<spear::Future<std::int64_t>> ends(4);
    for (const std::size_t i : {std::size_t{3}, std::size_t{2}, std::size_t{1}}) { // the other way round
        auto frame = arrivals[i - 1]->instance.end_frame();
        ends[i] = arrivals[i - 1]->ticket();
        frame.execute();
        arrivals[i - 1]->arrive();
        CHECK_FALSE(ends[i].is_ready());
    }
    auto frame = holder.instance.end_frame();
    ends[0] = holder.ticket();
    frame.execute();
    for (std::size_t i = 1; i < ends.size(); ++i)
        CHECK(ends[i].get() == ends[i - 1].get() + 1);
    CHECK(ends[0].get() > begins.back().get());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        CHECK(frame_of(begins[i]) == frame_of(first));
        CHECK(frame_of(ends[i]) == frame_of(first));
    }
}

TEST_CASE("several clients: a frame carries one transaction of each; the next ones wait for the next frame") {
    Client holder, a, b;
    auto held = holder.instance.begin_frame();
    const auto now = holder.game.async().get_class("AActor");
    (void)now.get();
    std::vector<spear::Future<spear::Class>> first, second;
    for (Client* const client : {&a, &b}) {
        client->transact([&] { first.push_back(client->game.async().get_class("AActor")); });
        client->arrive();
    }
    held.execute();
    holder.instance.end_frame().execute();
    for (Client* const client : {&a, &b})
        client->transact([&] { second.push_back(client->game.async().get_class("AActor")); });
    for (std::size_t i = 0; i < 2; ++i) {
        first[i].get();
        second[i].get();
        CHECK(frame_of(first[i]) == frame_of(now));
        CHECK(frame_of(second[i]) > frame_of(now));
    }
}

TEST_CASE("several clients at once: each has its own frames and results, also while one steps") {
    constexpr int threads = 4, transactions = 20;
    std::atomic<int> wrong{0};
    std::vector<std::thread> running;
    for (int number = 0; number < threads; ++number) {
        running.emplace_back([&, number] {
            Client client({.deadline = 120s});
            std::uint64_t last = 0;
            spear::Object actor;
            client.transact([&] { actor = client.spawn(); });
            for (int i = 1; i <= transactions; ++i) {
                spear::Future<FVector> begin, end;
                client.transact(
                    [&] {
                        const FVector place{double(i), double(number), 0};
                        actor.send("K2_SetActorLocation", place, false, arg("bTeleport", true));
                        begin = actor.async<FVector>("K2_GetActorLocation");
                        if (i % 3 == 0)
                            wrong += !(actor.call<FVector>("K2_GetActorLocation") == place);
                    },
                    [&] { end = actor.async<FVector>("K2_GetActorLocation"); }, {.single_step = number == 0});
                wrong += !(begin.get() == FVector{double(i), double(number), 0}) || !(end.get() == begin.get());
                wrong += frame_of(begin) != frame_of(end) || frame_of(begin) <= last;
                wrong += number == 0 && i > 1 && frame_of(begin) != last + 1;
                last = frame_of(begin);
            }
            client.transact([&] { client.game.destroy_actor(actor); });
        });
    }
    for (auto& thread : running)
        thread.join();
    CHECK(wrong == 0);
    CHECK(Client().frames_go_on());
}

TEST_CASE("two clients: while one holds the engine by single_step, the other waits up to its deadline and is told") {
    Client one({.client_name = "the holder", .deadline = 30s}), two;
    one.transact(nullptr, nullptr, {.single_step = true});
    one.instance.flush();
    CHECK(eventually([&] { return one.instance.session()->status().state == State::held_by_you; }));
    CHECK(two.instance.session()->status().state == State::held_by_other);

    two.instance.session()->set_deadline(200ms);
    const std::string text = error_text<spear::HeldByClient>([&] { two.transact([&] { two.spawn(); }); });
    CHECK(contains(text, "the holder"));
    CHECK(contains(text, "single_step"));
    CHECK(two.game.get_class("AActor").class_name() == "UClass"); // facts need no frame

    one.transact(nullptr);
    two.instance.session()->set_deadline(30s);
    CHECK_NOTHROW(two.instance.flush()); // what it gave up waiting for has run
    CHECK_NOTHROW(two.transact([&] { two.spawn(); }));
    CHECK(two.frames_go_on());
}

TEST_CASE("two clients: a queued transaction runs in the frame in which the holder goes on") {
    TicketClient one, two;
    spear::Future<std::int64_t> waiting, next;
    one.transact(nullptr, nullptr, {.single_step = true});
    one.instance.flush();
    CHECK(eventually([&] { return one.instance.session()->status().state == State::held_by_you; }));
    two.transact([&] { waiting = two.ticket(); });
    two.arrive();
    CHECK_FALSE(waiting.wait(50ms));
    one.transact([&] { next = one.ticket(); }, nullptr, {.single_step = true});
    CHECK(waiting.get() == next.get() + 1); // its begin work is first, though it arrived later
    CHECK(frame_of(waiting) == frame_of(next));
    one.transact(nullptr);
    CHECK(two.frames_go_on());
}

TEST_CASE("G7: a client that dies, hangs or closes in the middle of a block does not freeze the engine") {
    Client client;
    int child = 0;
    SUBCASE("dies within a begin block") { child = start_child("die"); }
    SUBCASE("dies between its blocks") { child = start_child("between"); }
    SUBCASE("hangs past its lease") { child = start_child("hang"); }
    SUBCASE("closes") {
        Client other;
        auto frame = other.instance.begin_frame();
        other.game.get_class("AActor");
        other.instance.close();
        CHECK_THROWS_AS(frame.execute(), spear::Disconnected);
    }
    client.transact([&] { client.game.get_class("AActor"); });
    CHECK(client.frames_go_on());
    if (child != 0) {
        ::kill(child, SIGKILL);
        wait_for_child(child);
    }
}

TEST_CASE("G7: lease=off keeps the session of a process that is stopped; the default lease ends it") {
    spear::LaunchOptions options = launch_options();
    options.arguments.push_back("-SpearLease=1000");
    options.lease = 60s;
    spear::Instance instance = spear::launch(options);
    const std::string address = instance.process()->address();
    Client witness({.lease = 60s, .deadline = 30s}, instance);

    const int holder = start_child("hang without a lease", address);
    const int idle = start_child("hang idle", address);
    CHECK(eventually([&] { return sessions_at(address) == 3; })); // this one's, the witness's, the holder's
    CHECK(witness.instance.session()->status().state == State::held_by_other);
    CHECK(witness.instance.session()->status().holder == "the child");
    CHECK(witness.frames_stand());
    for (const int child : {holder, idle}) {
        ::kill(child, SIGKILL);
        wait_for_child(child);
    }
    CHECK(witness.frames_go_on());
}

TEST_CASE("an engine that runs no frames: clients get EngineBusy, and go on when it does") {
    const Folder folder;
    Client blocker, client;
    const spear::Class calls = blocker.game.get_class("URoundTripCalls");
    spear::Object actor;
    client.transact([&] { actor = client.spawn(); });
    client.instance.flush();
    spear::Future<void> blocked;
    blocker.transact([&] { blocked = calls.async<void>("BlockFrames", folder.path.string()); });
    REQUIRE(eventually([&] { return std::filesystem::exists(folder.path / "began"); }));

    client.instance.session()->set_deadline(1500ms);
    const std::string text =
        error_text<spear::EngineBusy>([&] { client.transact([&] { actor.call("K2_GetActorLocation"); }); });
    CHECK(contains(text, "K2_GetActorLocation"));
    CHECK(contains(text, "no frame"));
    CHECK_THROWS_AS(blocked.get(10ms), spear::EngineBusy);
    CHECK(client.instance.session()->status().state == State::busy);
    CHECK(client.instance.call(spear::engine_service::ping, "still there") == "still there");

    std::ofstream(folder.path / "go").put('\n');
    CHECK_NOTHROW(blocked.get());
    client.instance.session()->set_deadline(30s);
    client.transact([&] { CHECK(actor.call<FVector>("K2_GetActorLocation") == FVector{}); });
    CHECK(client.frames_go_on());
}
