// SPDX-License-Identifier: MIT
// Both halves of a channel: who reads when, sleeping and waking, the region's life, clients that mean harm.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <functional>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <doctest/doctest.h>

#include "client_channel.hpp"
#include "server_channels.hpp"

using namespace spear::wire;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t largest = 64u << 20;

bool exists(const std::string& name) { return std::filesystem::exists("/dev/shm/" + name); }

/// A server's channels with one client's, and no RPC between them.
struct Pair {
    using Submit = std::function<void(std::uint64_t, const spear_batch&)>;
    std::mutex submit_mutex; ///< ThreadSanitizer does not see that two mappings are one memory
    Submit on_submit;        ///< under submit_mutex
    std::atomic<int> dropped{0};
    ServerChannels server{ChannelEvents{[this](std::uint64_t, std::uint64_t request, const spear_batch& batch) {
                                            const std::lock_guard lock(submit_mutex);
                                            on_submit(request, batch);
                                        },
        [this](std::uint64_t, const char*) { ++dropped; }}};
    std::shared_ptr<ServerChannel> channel;
    std::unique_ptr<ChannelRegion> spare; ///< a mapping to do harm with
    std::unique_ptr<ClientChannel> client;

    Pair() {
        std::string why;
        server.set_session_count(1);
        channel = server.offer(1, largest, why);
        REQUIRE_MESSAGE(channel, why);
        spare = ChannelRegion::open(channel->name(), why);
        auto region = ChannelRegion::open(channel->name(), why);
        REQUIRE_MESSAGE(region, why);
        REQUIRE(channel->confirm(region->nonce(), channel_nonce_bytes, true));
        client = std::make_unique<ClientChannel>(std::move(region), largest, true);
        // Answers with the operations it got.
        set_submit([this](std::uint64_t request, const spear_batch& batch) {
            spear_answers answers{};
            answers.answers = batch.operations;
            answers.types = batch.types;
            answers.frame = batch.transaction;
            server.reply(1, request, answers);
        });
        server.add(channel);
    }
    ~Pair() { server.remove(1); }

    Submit set_submit(Submit submit) {
        const std::lock_guard lock(submit_mutex);
        return std::exchange(on_submit, std::move(submit));
    }

    void submit(
        std::uint64_t request, const std::vector<std::uint8_t>& operations, std::uint8_t block = SPEAR_BLOCK_NONE) {
        spear_batch batch{};
        batch.transaction = request;
        batch.block = block;
        batch.operations = {operations.data(), operations.size()};
        batch.releases = &request;
        batch.release_count = 1;
        client->submit(request, batch);
    }
    /// Waits for the next answers.
    std::uint64_t take(std::vector<std::uint8_t>& bytes) {
        std::uint64_t request = 0;
        spear_answers answers{};
        for (int i = 0; i < 2000; ++i) {
            const std::uint32_t wakes = client->wakes();
            const int taken = client->take(request, answers);
            if (taken == 1) {
                bytes.assign(answers.answers.data, answers.answers.data + answers.answers.size);
                return request;
            }
            REQUIRE(taken == 0);
            client->wait(wakes, 10'000);
        }
        FAIL("no answer");
        return 0;
    }
};

std::vector<std::uint8_t> make_bytes(std::uint64_t number, std::size_t size) {
    std::vector<std::uint8_t> bytes(size);
    for (std::size_t i = 0; i < size; ++i) {
        bytes[i] = static_cast<std::uint8_t>(number * 7 + i);
    }
    return bytes;
}

} // namespace

TEST_CASE("region: of this user only, gone from the file system once the client has proven it sees it") {
    std::string why;
    auto made = ChannelRegion::create(why);
    REQUIRE_MESSAGE(made, why);
    const std::string name = made->name();
    struct stat info{};
    REQUIRE(::stat(("/dev/shm/" + name).c_str(), &info) == 0);
    CHECK((info.st_mode & 0777) == 0600);
    CHECK(static_cast<std::size_t>(info.st_size) == channel_region_bytes);
    auto opened = ChannelRegion::open(name, why);
    REQUIRE_MESSAGE(opened, why);
    CHECK(std::memcmp(opened->nonce(), made->nonce(), channel_nonce_bytes) == 0);
    made->unlink();
    CHECK_FALSE(exists(name));
    CHECK_FALSE(ChannelRegion::open(name, why));
    opened->header().to_server_tail = 5;
    CHECK(made->header().to_server_tail == 5); // both mappings live on
}

TEST_CASE("region: names that are none of ours, sizes and versions that are not ours, are not opened") {
    std::string why;
    CHECK_FALSE(ChannelRegion::open("", why));
    CHECK_FALSE(ChannelRegion::open("spear-1-nothing", why));
    CHECK_FALSE(ChannelRegion::open("spear-/../../etc/passwd", why));
    auto made = ChannelRegion::create(why);
    REQUIRE(made);
    made->header().layout_version = 99;
    CHECK_FALSE(ChannelRegion::open(made->name(), why));
    CHECK(why.find("layout") != std::string::npos);
    made->header().layout_version = channel_layout_version;
    REQUIRE(::truncate(("/dev/shm/" + made->name()).c_str(), 100) == 0);
    CHECK_FALSE(ChannelRegion::open(made->name(), why));
}

TEST_CASE("region: what a killed server left is removed by the next one") {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
        std::string why;
        auto made = ChannelRegion::create(why);
        const std::string name = made ? made->name() : "?";
        (void)!::write(ends[1], name.data(), name.size());
        ::_exit(0); // no destructor
    }
    ::close(ends[1]);
    char name[128] = {};
    REQUIRE(::read(ends[0], name, sizeof(name) - 1) > 0);
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    CHECK(exists(name));
    std::string why;
    auto of_the_living = ChannelRegion::create(why);
    ChannelRegion::remove_leftovers([](const std::string&) {});
    CHECK_FALSE(exists(name));
    CHECK(exists(of_the_living->name()));
}

TEST_CASE("channel: a wrong nonce opens nothing and leaves nothing") {
    Pair pair;
    std::string why;
    auto offered = pair.server.offer(2, largest, why);
    REQUIRE(offered);
    const std::string name = offered->name();
    std::uint8_t nonce[channel_nonce_bytes] = {1, 2, 3};
    CHECK_FALSE(offered->confirm(nonce, sizeof(nonce), true));
    CHECK_FALSE(exists(name));
    auto another = pair.server.offer(3, largest, why);
    CHECK_FALSE(another->confirm(nullptr, 0, true));
    CHECK_FALSE(exists(another->name()));
    auto unanswered = pair.server.offer(4, largest, why);
    const std::string third = unanswered->name();
    unanswered.reset();
    CHECK_FALSE(exists(third));
    CHECK_FALSE(exists(pair.channel->name()));
}

TEST_CASE("channel: without a game thread the watcher takes everything, in order, of any size") {
    Pair pair;
    std::mt19937 random(1);
    std::vector<std::uint8_t> bytes;
    for (std::uint64_t number = 1; number <= 400; ++number) {
        const std::size_t size = number % 20 == 0 ? 1'500'000 : random() % 5000;
        pair.submit(number, make_bytes(number, size), number % 3);
        REQUIRE(pair.take(bytes) == number);
        REQUIRE(bytes == make_bytes(number, size));
    }
}

TEST_CASE("channel: answers that nobody takes wait, and are all there in the end") {
    Pair pair;
    constexpr std::uint64_t count = 3000;
    for (std::uint64_t number = 1; number <= count; ++number) {
        pair.submit(number, make_bytes(number, 1000));
        while (!pair.client->flush()) {
            std::this_thread::yield();
        }
    }
    std::vector<std::uint8_t> bytes;
    for (std::uint64_t number = 1; number <= count; ++number) {
        REQUIRE(pair.take(bytes) == number);
        REQUIRE(bytes == make_bytes(number, 1000));
    }
    CHECK(pair.dropped == 0);
}

TEST_CASE("channel: hand-over between game thread and watcher loses nothing, doubles nothing, keeps the order") {
    Pair pair;
    std::atomic<bool> ends{false};
    std::atomic<std::uint64_t> last{0}, out_of_order{0}, by_game_thread{0};
    std::thread game_thread;
    std::atomic<std::thread::id> game_thread_id{};
    Pair::Submit echo;
    echo = pair.set_submit([&](std::uint64_t request, const spear_batch& batch) {
        out_of_order += last.exchange(request) + 1 != request;
        by_game_thread += std::this_thread::get_id() == game_thread_id.load();
        echo(request, batch);
    });
    game_thread = std::thread([&] {
        game_thread_id = std::this_thread::get_id();
        std::mt19937 random(5);
        while (!ends) { // frames: look, hold for some waits, let go, do something else
            pair.server.poll();
            for (unsigned waits = random() % 20; waits != 0 && !ends; --waits) {
                pair.server.wait(1, 1);
            }
            pair.server.release();
            if (random() % 4 == 0) {
                std::this_thread::sleep_for(std::chrono::microseconds(random() % 300));
            }
        }
    });
    std::vector<std::uint8_t> bytes;
    std::mt19937 random(6);
    std::uint64_t number = 0;
    for (int round = 0; round < 4000; ++round) {
        const std::uint64_t first = number + 1;
        for (unsigned burst = 1 + random() % 3; burst != 0; --burst) {
            ++number;
            pair.submit(number, make_bytes(number, random() % 300), static_cast<std::uint8_t>(random() % 3));
        }
        for (std::uint64_t wanted = first; wanted <= number; ++wanted) {
            REQUIRE(pair.take(bytes) == wanted);
        }
    }
    ends = true;
    game_thread.join();
    CHECK(out_of_order == 0);
    CHECK(last == number);
    CHECK(by_game_thread > 0);
    CHECK(pair.dropped == 0);
}

TEST_CASE("channel: wake() ends the game thread's wait, also one that begins afterwards") {
    Pair pair;
    for (int round = 0; round < 200; ++round) {
        std::thread waking([&] {
            if (round % 2 == 0)
                std::this_thread::sleep_for(200us);
            pair.server.wake();
        });
        const auto began = std::chrono::steady_clock::now();
        pair.server.wait(round % 3 == 0 ? 77 : 1, 100'000); // 77 has no channel
        CHECK(std::chrono::steady_clock::now() - began < 60s);
        waking.join();
        pair.server.wait(1, 0); // what is left of the wake
    }
    pair.server.release();
}

TEST_CASE("channel: wake() ends the client's wait") {
    Pair pair;
    for (int round = 0; round < 200; ++round) {
        const std::uint32_t wakes = pair.client->wakes();
        std::thread waking([&] { pair.client->wake(); });
        const auto began = std::chrono::steady_clock::now();
        while (pair.client->wakes() == wakes) {
            pair.client->wait(wakes, 100'000'000);
        }
        CHECK(std::chrono::steady_clock::now() - began < 60s);
        waking.join();
    }
}

TEST_CASE("channel: garbage from the client ends its session, never the server") {
    std::mt19937_64 random(7);
    int ended = 0;
    for (int round = 0; round < 150; ++round) {
        Pair pair;
        pair.set_submit([](std::uint64_t, const spear_batch& batch) {
            // All of what is said to be there can be read.
            std::uint64_t sum = 0;
            for (std::size_t i = 0; i < batch.operations.size; ++i)
                sum += batch.operations.data[i];
            for (std::size_t i = 0; i < batch.types.size; ++i)
                sum += batch.types.data[i];
            for (std::size_t i = 0; i < batch.release_count; ++i)
                sum += batch.releases[i];
            volatile std::uint64_t keep = sum;
            (void)keep;
        });
        ChannelHeader& header = pair.spare->header();
        auto* ring = pair.spare->to_server();
        for (int step = 0; step < 8; ++step) {
            ChannelBatch head{};
            head.bytes = random() % 3 == 0 ? random() : random() % 64 * 8;
            head.release_count = random() % 2 == 0 ? static_cast<std::uint32_t>(random()) : 1;
            head.operations_bytes = random() % 2 == 0 ? static_cast<std::uint32_t>(random()) : 8;
            head.types_bytes = random() % 4 == 0 ? static_cast<std::uint32_t>(random()) : 0;
            std::memcpy(ring + random() % 8 * 64, &head, sizeof(head));
            if (step == 0)
                std::memcpy(ring, &head, sizeof(head));
            store_ordered(&header.to_server_head, random());
            store_ordered(&header.to_client_head, random() % 4 == 0 ? random() : std::uint64_t{0});
            store_ordered(&header.game_thread_reads, static_cast<std::uint32_t>(random() % 3));
            store_ordered(&header.game_thread_sleeps, static_cast<std::uint32_t>(random() % 3));
            store_ordered(&header.to_server_tail, random() % 8 == 0 ? random() : random() % 1000);
            store_ordered(&header.watcher_sleeps, 0u);
            futex_wake(&header.watcher_sleeps);
            pair.server.poll();
            pair.server.wait(1, 0);
            spear_answers answers{};
            const std::uint8_t text[] = "an answer";
            answers.answers = {text, sizeof(text)};
            pair.server.reply(1, 1, answers);
        }
        pair.server.release();
        ended += pair.dropped != 0;
    }
    CHECK(ended > 100);
}

TEST_CASE("channel: garbage from the server is an error of the client") {
    std::mt19937_64 random(8);
    for (int round = 0; round < 300; ++round) {
        Pair pair;
        ChannelHeader& header = pair.spare->header();
        auto* ring = pair.spare->to_client();
        ChannelAnswers head{};
        head.bytes = random() % 3 == 0 ? random() : random() % 64 * 8;
        head.answers_bytes = static_cast<std::uint32_t>(random() % 2 == 0 ? random() : random() % 100);
        head.types_bytes = static_cast<std::uint32_t>(random() % 2 == 0 ? random() : random() % 100);
        head.error_bytes = static_cast<std::uint32_t>(random() % 2 == 0 ? random() : random() % 100);
        head.has_error = 1;
        std::memcpy(ring, &head, sizeof(head));
        store_ordered(&header.to_client_tail, random() % 4 == 0 ? random() : random() % 1000);
        std::uint64_t request = 0;
        spear_answers answers{};
        int taken = 0;
        for (int i = 0; i < 5 && (taken = pair.client->take(request, answers)) == 1; ++i) {
            volatile std::uint8_t last = answers.answers.size ? answers.answers.data[answers.answers.size - 1] : 0;
            (void)last;
        }
        CHECK(taken <= 1);
    }
}

// Calls: the place beside the rings.

namespace {

/// Takes calls on a thread that stands for the game thread, and answers with what `answer` makes of them.
class CallServer {
public:
    using Answer = std::function<spear_call_answer(const spear_call&)>;
    CallServer(Pair& pair, Answer answer) : pair_(pair), thread_([this, answer = std::move(answer)] { run(answer); }) {}
    ~CallServer() {
        stop_ = true;
        pair_.server.wake();
        thread_.join();
    }

private:
    void run(const Answer& answer) {
        while (!stop_) {
            spear_call call{};
            if (pair_.server.wait_call(1, 10, call)) {
                pair_.server.answer_call(1, answer(call));
            }
        }
        pair_.server.release();
    }

    Pair& pair_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

struct CallResult {
    int taken = 0; ///< as spear_client_take_call says
    bool failed = false;
    std::uint64_t frame = 0;
    std::vector<std::uint8_t> bytes;
    std::uint64_t request = 0; ///< of an answer in the ring
};

CallResult make_call(Pair& pair, std::uint64_t number, const std::vector<std::uint8_t>& arguments) {
    const spear_call call{number, 7, {arguments.data(), arguments.size()}};
    while (!pair.client->call(call)) { // the game thread does not read yet
        std::this_thread::yield();
    }
    for (;;) {
        const std::uint32_t wakes = pair.client->wakes();
        spear_call_answer answer{};
        CallResult result;
        result.taken = pair.client->take_call(true, answer);
        if (result.taken == 2) {
            result.request = pair.take(result.bytes);
            return result;
        }
        if (result.taken != 0) {
            result.failed = answer.failed != 0;
            result.frame = answer.frame;
            result.bytes.assign(answer.value.data, answer.value.data + answer.value.size);
            return result;
        }
        pair.client->wait(wakes, 10'000);
    }
}

} // namespace

TEST_CASE("call: arguments of every size there and back, also what only the ring can take") {
    Pair pair;
    std::vector<std::uint8_t> large(200'000, 5);
    CallServer server(pair, [&](const spear_call& call) {
        CHECK(call.entry_point == 7);
        spear_call_answer answer{};
        answer.frame = call.number * 2;
        answer.failed = call.number % 3 == 0;
        answer.value = call.number % 10 == 0 ? spear_bytes{large.data(), large.size()} : call.arguments;
        return answer;
    });
    for (std::uint64_t number = 1; number <= 3000; ++number) {
        const auto arguments = make_bytes(number, number % (sizeof(ChannelCall::arguments) + 1));
        const CallResult result = make_call(pair, number, arguments);
        if (number % 10 == 0) {
            CHECK(result.taken == 2);
            CHECK(result.request == (call_request | (number % 3 == 0 ? call_failed : 0) | number));
            CHECK(result.bytes == large);
        } else {
            CHECK(result.taken == 1);
            CHECK(result.failed == (number % 3 == 0));
            CHECK(result.frame == number * 2);
            CHECK(result.bytes == arguments);
        }
    }
    const std::vector<std::uint8_t> too_large(sizeof(ChannelCall::arguments) + 1);
    CHECK_FALSE(pair.client->call({4000, 7, {too_large.data(), too_large.size()}}));
    CHECK(make_call(pair, 4001, make_bytes(1, 8)).taken == 1); // the refused one has changed nothing
    CHECK(pair.dropped == 0);
}

TEST_CASE("call: batches before and after it keep their place") {
    Pair pair;
    std::vector<std::uint64_t> order; // the server thread's
    pair.set_submit([&](std::uint64_t request, const spear_batch&) {
        order.push_back(request);
        spear_answers answers{};
        pair.server.reply(1, request, answers);
    });
    {
        CallServer server(pair, [&](const spear_call& call) {
            order.push_back(call.number);
            return spear_call_answer{};
        });
        for (std::uint64_t number = 1; number < 2000; number += 2) {
            CHECK(make_call(pair, number, make_bytes(number, 40)).taken == 1);
            pair.submit(number + 1, make_bytes(number, 100), SPEAR_BLOCK_BEGIN);
            std::vector<std::uint8_t> bytes;
            CHECK(pair.take(bytes) == number + 1);
        }
    }
    REQUIRE(order.size() == 2000);
    for (std::size_t i = 0; i < order.size(); ++i) {
        CHECK(order[i] == i + 1);
    }
}

TEST_CASE("call: one that nobody may take ends the session") {
    Pair pair;
    const std::vector<std::uint8_t> arguments(8);
    SUBCASE("when the game thread waits for something else") {
        CHECK_FALSE(pair.client->call({1, 7, {arguments.data(), arguments.size()}})); // it does not read
        pair.server.wait(1, 0);
        REQUIRE(pair.client->call({1, 7, {arguments.data(), arguments.size()}}));
        pair.server.wait(1, 10);
    }
    SUBCASE("when it stops waiting") {
        spear_call call{};
        CHECK_FALSE(pair.server.wait_call(1, 1, call));
        REQUIRE(pair.client->call({1, 7, {arguments.data(), arguments.size()}}));
        pair.server.release();
    }
    CHECK(pair.dropped == 1);
    pair.server.release();
    CHECK(pair.dropped == 1); // once
}

TEST_CASE("call: garbage in its place ends the session, or is no call") {
    Pair pair;
    ChannelCall& place = pair.spare->header().call;
    spear_call call{};
    SUBCASE("a size beyond the place") {
        place.arguments_bytes = 1009;
        store_release(&place.sequence, 1u);
        CHECK_FALSE(pair.server.wait_call(1, 10, call));
        CHECK(pair.dropped == 1);
    }
    SUBCASE("a number that stands for something else") {
        place.number = call_failed | 1;
        store_release(&place.sequence, 1u);
        CHECK_FALSE(pair.server.wait_call(1, 10, call));
        CHECK(pair.dropped == 1);
    }
    SUBCASE("a sequence out of order") {
        for (const std::uint32_t sequence : {0u, 2u, 77u, 0xffff'ffffu}) {
            store_release(&place.sequence, sequence);
            CHECK_FALSE(pair.server.wait_call(1, 1, call));
        }
        CHECK(pair.dropped == 0);
    }
    pair.server.release();
}

TEST_CASE("call: bytes that change while the server reads them do no harm") {
    Pair pair;
    ChannelCall& place = pair.spare->header().call;
    std::atomic<bool> stop{false};
    std::thread liar([&] {
        std::mt19937 random(1);
        while (!stop) {
            place.arguments_bytes = static_cast<std::uint16_t>(random());
            place.entry_point = static_cast<std::uint16_t>(random());
            place.number = random();
            std::memset(place.arguments, static_cast<int>(random()), sizeof(place.arguments));
        }
    });
    std::size_t taken = 0;
    for (std::uint32_t sequence = 1; sequence <= 2000; ++sequence) {
        store_release(&place.sequence, sequence);
        spear_call call{};
        if (pair.server.wait_call(1, 10, call)) {
            ++taken;
            REQUIRE(call.arguments.size <= sizeof(place.arguments));
            std::vector<std::uint8_t> copy(call.arguments.data, call.arguments.data + call.arguments.size);
            // What was taken is the server's own.
            CHECK(std::equal(copy.begin(), copy.end(), call.arguments.data));
            pair.server.answer_call(1, {0, 0, call.arguments, {}});
        }
    }
    stop = true;
    liar.join();
    CHECK(taken + static_cast<std::size_t>(pair.dropped) == 2000);
    pair.server.release();
}

TEST_CASE("call: garbage in the answer is an error of the client") {
    Pair pair;
    ChannelCallAnswer& place = pair.spare->header().answer;
    const std::vector<std::uint8_t> arguments(8);
    spear_call_answer answer{};
    pair.server.wait(1, 0);
    REQUIRE(pair.client->call({1, 7, {arguments.data(), arguments.size()}}));
    store_release(&place.sequence, 9u); // of no call
    CHECK(pair.client->take_call(false, answer) == 0);
    SUBCASE("an unknown state") { place.state = 99; }
    SUBCASE("a size beyond the place") {
        place.state = static_cast<std::uint16_t>(CallState::succeeded);
        place.answer_bytes = 1009;
    }
    store_release(&place.sequence, 1u);
    CHECK(pair.client->take_call(false, answer) == -1);
}
