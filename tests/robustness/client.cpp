// SPDX-License-Identifier: MIT
// robustness-client STATE ADDRESS | STATE --launch ENGINE [ARGUMENT...]: a client that goes into one state of a
// transaction, says so ("ready ADDRESS PROCESS" on standard output), and is killed there or stopped, or has its engine
// taken away. Some states need others to do something first: they say "connected ..." and wait for a line on standard
// input. States that wait for a line when they are ready go on after it; then, and when the call that a state is
// blocked in returns, the outcome is one line of JSON: {"error": name or "", "message": ...}. Lease and deadline in
// milliseconds come from SPEAR_TEST_LEASE and SPEAR_TEST_DEADLINE. client.py is the same in Python.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include "spear/spear.hpp"

namespace {

using spear::Milliseconds;
using spear::unreal::FVector;

Milliseconds setting(const char* name, int otherwise) {
    const char* const text = std::getenv(name);
    return Milliseconds(text ? std::atoi(text) : otherwise);
}

void say(const std::string& line) {
    const std::string text = line + "\n";
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0) {
        std::_Exit(3);
    }
}

/// The shared memory of this process's one session. Its name is gone already, so it is looked up among the mappings.
struct Region {
    std::byte* data = nullptr;
    std::size_t size = 0;

    Region() {
        std::ifstream maps("/proc/self/maps");
        for (std::string line; std::getline(maps, line);) {
            if (line.find("/dev/shm/spear-") != std::string::npos) {
                char* end = nullptr;
                const auto from = std::strtoull(line.c_str(), &end, 16);
                data = reinterpret_cast<std::byte*>(from);
                size = static_cast<std::size_t>(std::strtoull(end + 1, nullptr, 16) - from);
            }
        }
        if (!data) {
            std::cerr << "robustness-client: the session has no channel\n";
            std::exit(3);
        }
    }
    // Offsets: docs/protocol.md, "The channel".
    std::uint64_t& to_server_tail() { return *reinterpret_cast<std::uint64_t*>(data + 128); }
    std::byte* ring() { return data + 4096; }
    std::size_t ring_bytes() { return *reinterpret_cast<std::uint32_t*>(data + 12); }

    /// Writes the first bytes of a message of that size at the end of the ring to the server.
    void write_beginning(std::uint64_t message_bytes, std::size_t written, bool published) {
        const std::uint64_t tail = to_server_tail();
        for (std::size_t i = 0; i < written; ++i) {
            const auto byte = i < 8 ? static_cast<std::byte>(message_bytes >> (8 * i)) : std::byte{0};
            ring()[(tail + i) & (ring_bytes() - 1)] = byte;
        }
        if (published) {
            __atomic_store_n(&to_server_tail(), tail + written, __ATOMIC_SEQ_CST);
        }
    }
};

/// What a state has to work with.
class Run {
public:
    explicit Run(spear::Instance connected) : instance(std::move(connected)), game(instance.game()) {
        transact([&] { bench = game.new_object("USpearBench"); });
        frames = game.get_class("USpearBenchFrames");
        system = game.get_class("UKismetSystemLibrary");
    }

    spear::Instance instance;
    spear::Game game;
    spear::Object bench; ///< a USpearBench
    spear::Class frames; ///< USpearBenchFrames
    spear::Class system; ///< UKismetSystemLibrary

    FVector move() const { return bench.call<FVector>("Move", FVector{1, 0, 0}); }
    spear::Future<FVector> move_later() const { return bench.async<FVector>("Move", FVector{1, 0, 0}); }
    void transact(const std::function<void()>& begin, bool single_step = false) {
        auto first = instance.begin_frame();
        begin();
        first.execute();
        instance.end_frame({.single_step = single_step}).execute();
    }

    void say_where(const std::string& word) const {
        const auto* process = instance.process();
        say(word + " " + instance.session()->address() + " " + std::to_string(process ? process->process_id() : 0));
    }
    void say_ready() const { say_where("ready"); }
    /// Before the state: waits until the test has arranged what it needs.
    void connected() const {
        say_where("connected");
        std::string line;
        std::getline(std::cin, line);
    }
    /// The state is reached: waits for a line on standard input.
    void ready() const {
        say_ready();
        std::string line;
        std::getline(std::cin, line);
    }
    /// The next call of this thread blocks: says "ready" when it does.
    void ready_when_blocked() const {
        std::thread([this, thread = ::gettid()] {
            const std::string file = "/proc/self/task/" + std::to_string(thread) + "/stat";
            for (;;) {
                std::ifstream in(file);
                std::string text;
                std::getline(in, text);
                const std::size_t at = text.rfind(") ");
                if (at != std::string::npos && at + 2 < text.size() && text[at + 2] == 'S') {
                    break;
                }
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            }
            say_ready();
        }).detach();
    }
};

// The states of a transaction, in its order. Each says when it is reached; what follows must end with an error if the
// session has been lost meanwhile.
const std::map<std::string, std::function<void(Run&)>>& states() {
    static const std::map<std::string, std::function<void(Run&)>> table = {
        {"idle",
            [](Run& run) {
                run.ready();
                run.transact([&] { run.move(); });
            }},
        {"begin_open",
            [](Run& run) {
                auto frame = run.instance.begin_frame();
                const auto moved = run.move_later();
                run.ready();
                frame.execute();
                run.instance.end_frame().execute();
                moved.get();
            }},
        {"begin_held",
            [](Run& run) {
                auto frame = run.instance.begin_frame();
                run.move();
                run.ready();
                run.move();
                frame.execute();
                run.instance.end_frame().execute();
                run.instance.flush();
            }},
        {"between",
            [](Run& run) {
                auto frame = run.instance.begin_frame();
                run.move();
                frame.execute();
                run.ready();
                auto end = run.instance.end_frame();
                run.move();
                end.execute();
            }},
        {"end_open",
            [](Run& run) {
                run.instance.begin_frame().execute();
                auto frame = run.instance.end_frame();
                const auto moved = run.move_later();
                run.ready();
                frame.execute();
                moved.get();
            }},
        {"end_held",
            [](Run& run) {
                run.instance.begin_frame().execute();
                auto frame = run.instance.end_frame();
                run.move();
                run.ready();
                run.move();
                frame.execute();
                run.instance.flush();
            }},
        {"single_step",
            [](Run& run) {
                run.instance.step();
                run.ready();
                run.transact([&] { run.move(); });
            }},
        {"queued", // another client holds the engine
            [](Run& run) {
                run.connected();
                spear::Future<FVector> moved;
                run.transact([&] { moved = run.move_later(); });
                run.ready();
                moved.get();
            }},
        {"waiting_for_other", // likewise
            [](Run& run) {
                run.connected();
                auto frame = run.instance.begin_frame();
                run.ready_when_blocked();
                run.move();
                frame.execute();
                run.instance.end_frame().execute();
                run.instance.flush();
            }},
        {"latent",
            [](Run& run) {
                spear::Future<void> delay;
                run.transact([&] { delay = run.system.async<void>("Delay", spear::arg("Duration", 1000.0)); });
                run.instance.flush();
                run.ready_when_blocked();
                delay.get();
            }},
        {"running", // an operation that takes a while
            [](Run& run) {
                auto frame = run.instance.begin_frame();
                run.move();
                run.ready_when_blocked();
                run.frames.call("Work", 60.0);
                for (;;) { // until the engine or this process ends
                    run.frames.call("Work", 60.0);
                }
            }},
        {"receiving", // results of many megabytes, one after the other
            [](Run& run) {
                auto frame = run.instance.begin_frame();
                const spear::Object calls = run.game.new_object("URoundTripCalls");
                run.say_ready();
                for (;;) {
                    (void)calls.call<std::vector<std::uint8_t>>("Bytes", std::int64_t{12} << 20);
                }
            }},
        {"sending", // arguments of many megabytes
            [](Run& run) {
                const std::string text(8u << 20, 'x');
                run.say_ready();
                for (;;) {
                    (void)run.instance.call(spear::engine_service::ping, text);
                }
            }},
        {"flooding", // asynchronous transactions without end
            [](Run& run) {
                std::vector<spear::Future<FVector>> kept;
                for (bool first = true;; first = false) {
                    kept.clear();
                    run.transact([&] {
                        for (int i = 0; i < 100; ++i) {
                            kept.push_back(run.move_later());
                        }
                    });
                    if (first) {
                        run.say_ready();
                    }
                }
            }},
        {"stepping", // synchronous transactions without end, the engine held between them
            [](Run& run) {
                for (bool first = true;; first = false) {
                    run.transact([&] { run.move(); }, true);
                    if (first) {
                        run.say_ready();
                    }
                }
            }},
        {"writing", // a message begun in the ring, its size not announced
            [](Run& run) {
                Region().write_beginning(4096, 1000, false);
                run.ready();
                run.transact([&] { run.move(); });
            }},
        {"written_half", // announced, and never to be completed
            [](Run& run) {
                Region().write_beginning(4096, 1000, true);
                run.ready();
                run.transact([&] { run.move(); });
            }},
        {"written_half_held", // while the game thread itself reads the ring
            [](Run& run) {
                auto frame = run.instance.begin_frame();
                run.move();
                Region().write_beginning(1u << 20, 200'000, true);
                run.ready();
                run.move();
            }},
        {"closing", // the engine's answer to it does not come
            [](Run& run) {
                auto frame = run.instance.begin_frame();
                run.move();
                run.connected();
                run.ready_when_blocked();
                run.instance.close();
            }},
        {"hostile", // corrupts its channel at random, with the seed on standard input
            [](Run& run) {
                run.say_ready();
                std::string line;
                std::getline(std::cin, line);
                std::mt19937_64 random(std::strtoull(line.c_str(), nullptr, 10));
                Region region;
                std::optional<spear::Frame> held;
                if (random() % 2 != 0) {
                    held.emplace(run.instance.begin_frame());
                    run.move();
                }
                for (int round = 0; round < 4000 && run.instance.session()->is_open(); ++round) {
                    // The positions, cores and sleeping words, the places of a single call and its answer, and the
                    // rings.
                    const std::size_t words[] = {128, 136, 256, 384, 392, 512, 640, 644, 648, 768, 896, 1024};
                    const std::size_t places[] = {
                        1152, 1160, 1168 + random() % 1000, 2176, 2184, 2192 + random() % 1000};
                    const std::size_t kind = random() % 3;
                    const std::size_t at = kind == 0   ? words[random() % std::size(words)]
                                           : kind == 1 ? places[random() % std::size(places)]
                                                       : 4096 + random() % (region.size - 4096);
                    auto* const word = reinterpret_cast<std::uint64_t*>(region.data + at / 8 * 8);
                    const std::uint64_t value[] = {
                        random(), random() % 1024, *word + 8 * (random() % 64), *word + random() % 3};
                    __atomic_store_n(word, value[random() % std::size(value)], __ATOMIC_SEQ_CST);
                    if (round % 32 == 0) { // the engine shall look at it now and then
                        std::this_thread::sleep_for(std::chrono::microseconds(50));
                    }
                }
                run.move();
            }},
    };
    return table;
}

std::string as_json(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char code[8];
            std::snprintf(code, sizeof(code), "\\u%04x", static_cast<unsigned>(c));
            out += code;
        } else {
            out += c;
        }
    }
    return out + '"';
}

spear::Instance open(int argc, char** argv) {
    const Milliseconds deadline = setting("SPEAR_TEST_DEADLINE", 10'000);
    const Milliseconds lease = setting("SPEAR_TEST_LEASE", 0);
    if (std::string(argv[2]) == "--launch") {
        return spear::launch({.fps = 100,
            .executable = argv[3],
            .arguments = std::vector<std::string>(argv + 4, argv + argc),
            .lease = lease,
            .deadline = deadline});
    }
    return spear::connect(argv[2], {.client_name = "victim", .lease = lease, .deadline = deadline});
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "usage: robustness-client STATE ADDRESS | STATE --launch ENGINE [ARGUMENT...] | --states -\n";
        return 2;
    }
    if (std::string(argv[1]) == "--states") {
        for (const auto& [name, run] : states()) {
            std::cout << name << '\n';
        }
        return 0;
    }
    std::string error, message;
    try {
        const auto state = states().find(argv[1]);
        if (state == states().end()) {
            std::cerr << "robustness-client: no state '" << argv[1] << "'\n";
            return 2;
        }
        Run run(open(argc, argv));
        try {
            state->second(run);
        } catch (const spear::Error& caught) {
            error = caught.name();
            message = caught.what();
        }
        say("{\"error\": " + as_json(error) + ", \"message\": " + as_json(message) + "}");
        return 0;
    } catch (const spear::Error& caught) {
        error = caught.name();
        message = caught.what();
    }
    say("{\"error\": " + as_json(error) + ", \"message\": " + as_json(message) + "}"); // of connecting
    return 0;
}
