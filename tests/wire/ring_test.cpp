// SPDX-License-Identifier: MIT
// One ring of the channel: a stream of messages from one thread to another, also of messages larger than the ring, also
// from a writer that means harm.
#include <cstring>
#include <random>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "channel.hpp"

using namespace spear::wire;

namespace {

constexpr std::size_t largest = 1u << 20;

struct Ring {
    explicit Ring(std::size_t bytes)
        : memory(bytes), writer(memory.data(), &tail, &head, bytes),
          reader(memory.data(), &tail, &head, bytes, largest) {}
    std::vector<std::byte> memory;
    std::uint64_t tail = 0, head = 0;
    ChannelWriter writer;
    ChannelReader reader;
};

/// A message with a number; its bytes follow from it.
std::vector<std::byte> make_message(std::uint64_t number, std::size_t size) {
    std::vector<std::byte> message(size);
    const std::uint64_t announced = size;
    std::memcpy(message.data(), &announced, 8);
    std::memcpy(message.data() + 8, &number, 8);
    for (std::size_t i = 16; i < size; ++i) {
        message[i] = static_cast<std::byte>(number * 31 + i);
    }
    return message;
}

bool is_message(const ChannelReader& reader, const std::vector<std::byte>& wanted) {
    return reader.size() == wanted.size() && std::memcmp(reader.data(), wanted.data(), wanted.size()) == 0;
}

std::size_t random_size(std::mt19937& random, std::size_t most) { return 40 + random() % (most / 8 - 4) * 8; }

} // namespace

TEST_CASE("ring: messages come out as they went in, across the wrap") {
    Ring ring(1024);
    std::mt19937 random(1);
    for (std::uint64_t number = 0; number < 20'000; ++number) {
        const auto message = make_message(number, random_size(random, 512));
        ring.writer.write({{message.data(), 24}, {message.data() + 24, message.size() - 24}});
        REQUIRE(ring.writer.waiting_bytes() == 0);
        REQUIRE(ring.reader.has_news());
        REQUIRE(ring.reader.next() == ChannelReader::Result::message);
        REQUIRE(is_message(ring.reader, message));
    }
    CHECK(ring.reader.next() == ChannelReader::Result::nothing);
    CHECK_FALSE(ring.reader.has_news());
}

TEST_CASE("ring: the writer never waits; what does not fit goes later, in order") {
    Ring ring(1024);
    for (std::uint64_t number = 0; number < 100; ++number) {
        const auto message = make_message(number, 400);
        ring.writer.write({{message.data(), message.size()}});
    }
    CHECK(ring.writer.waiting_bytes() == 100 * 400 - 1024);
    for (std::uint64_t number = 0; number < 100; ++number) {
        while (ring.reader.next() != ChannelReader::Result::message) {
            ring.writer.flush();
        }
        REQUIRE(is_message(ring.reader, make_message(number, 400)));
    }
    CHECK(ring.writer.flush());
}

TEST_CASE("ring: messages larger than the ring, between two threads") {
    Ring ring(4096);
    constexpr std::uint64_t count = 300;
    std::thread writing([&] {
        std::mt19937 random(2);
        for (std::uint64_t number = 0; number < count; ++number) {
            const auto message = make_message(number, random_size(random, number % 10 == 0 ? 200'000 : 3000));
            ring.writer.write({{message.data(), message.size()}});
            while (ring.writer.waiting_bytes() > 10'000) {
                ring.writer.flush();
                std::this_thread::yield();
            }
        }
        while (!ring.writer.flush()) {
            std::this_thread::yield();
        }
    });
    std::mt19937 random(2);
    for (std::uint64_t number = 0; number < count; ++number) {
        const auto wanted = make_message(number, random_size(random, number % 10 == 0 ? 200'000 : 3000));
        ChannelReader::Result result{};
        while ((result = ring.reader.next()) == ChannelReader::Result::nothing) {
            std::this_thread::yield();
        }
        REQUIRE(result == ChannelReader::Result::message);
        REQUIRE(is_message(ring.reader, wanted));
    }
    writing.join();
}

TEST_CASE("ring: sizes and positions that cannot be are malformed, and stay so") {
    const auto announce = [](std::uint64_t size) {
        Ring ring(1024);
        ring.writer.write({{&size, sizeof(size)}});
        const auto result = ring.reader.next();
        CHECK(ring.reader.next() == result);
        return result;
    };
    CHECK(announce(0) == ChannelReader::Result::malformed);
    CHECK(announce(8) == ChannelReader::Result::malformed);
    CHECK(announce(41) == ChannelReader::Result::malformed);
    CHECK(announce(largest + 8) == ChannelReader::Result::malformed);
    CHECK(announce(~std::uint64_t{7}) == ChannelReader::Result::malformed);
    CHECK(announce(largest) == ChannelReader::Result::nothing); // may still come
    for (const std::uint64_t tail : {std::uint64_t{1025}, ~std::uint64_t{0}, std::uint64_t{1} << 63}) {
        Ring ring(1024);
        ring.tail = tail;
        CHECK(ring.reader.next() == ChannelReader::Result::malformed);
        ring.tail = 0;
        CHECK(ring.reader.next() == ChannelReader::Result::malformed);
    }
}

TEST_CASE("ring: a reader that lies about its position gets nothing written over others' memory") {
    Ring ring(1024);
    const auto message = make_message(1, 800);
    ring.writer.write({{message.data(), message.size()}});
    ring.head = 5000; // more than was ever written
    ring.writer.write({{message.data(), message.size()}});
    ring.writer.write({{message.data(), message.size()}});
    CHECK(ring.writer.broken());
    CHECK_FALSE(ring.writer.flush());
    CHECK(ring.tail <= 1024);
}

TEST_CASE("ring: any bytes and positions at all leave the reader whole") {
    std::mt19937_64 random(3);
    for (int round = 0; round < 3000; ++round) {
        Ring ring(1024);
        for (auto& byte : ring.memory) {
            byte = static_cast<std::byte>(random() % 4 == 0 ? random() : 0);
        }
        for (int step = 0; step < 20; ++step) {
            ring.tail = random() % 3 == 0 ? random() : ring.tail + random() % 1100;
            ring.head = random();
            if (ring.reader.next() == ChannelReader::Result::message) {
                REQUIRE(ring.reader.size() <= largest);
                volatile std::byte last = ring.reader.data()[ring.reader.size() - 1];
                (void)last;
            }
        }
    }
}

TEST_CASE("spinner: gives up where it does not pay, tries again now and then") {
    if (!Spinner::allowed()) {
        Spinner spinner(true);
        int asked = 0;
        CHECK_FALSE(spinner.spin(nullptr, [&] { return ++asked, true; }));
        CHECK(asked == 0);
        return;
    }
    Spinner spinner(true);
    for (int i = 0; i < 4; ++i) {
        CHECK_FALSE(spinner.spin(nullptr, [] { return false; }));
    }
    int spun = 0;
    for (int i = 0; i < 160; ++i) {
        bool asked = false;
        spinner.spin(nullptr, [&] { return asked = true, false; });
        spun += asked;
    }
    CHECK(spun == 10);
    bool asked = false;
    while (!asked) {
        spinner.spin(nullptr, [&] { return asked = true; });
    }
    CHECK(spinner.spin(nullptr, [] { return true; })); // it pays again
    Spinner off(false);
    CHECK_FALSE(off.spin(nullptr, [] { return true; }));
}

TEST_CASE("spinner: does not spin for a partner that ran on the same core") {
    Spinner spinner(true);
    int asked = 0;
    for (int i = 0; i < 100; ++i) {
        const std::uint32_t here = Spinner::this_cpu();
        const bool spun = spinner.spin(&here, [&] { return ++asked, true; });
        CHECK((!spun || here != Spinner::this_cpu())); // or this thread was moved meanwhile
    }
    CHECK(asked < 10);
    const std::uint32_t elsewhere = 100'000;
    CHECK(spinner.spin(&elsewhere, [] { return true; }) == Spinner::allowed());
}
