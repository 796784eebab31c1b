// SPDX-License-Identifier: MIT
// spear-bench ADDRESS: measures what calls of the engine at that address cost, one row at a time, as standard input
// asks. Each line of input names a row (`spear-bench --rows` lists them); each gives one line of JSON: {"row": ...,
// "us": [samples, microseconds]}. `spear bench calls` runs it, interleaved with its own rows. The engine needs the
// plugin SpearBench. `spear-bench ADDRESS --transactions N --calls M` is for `spear bench frames`: {"frames": [...],
// "split": n}, see frames.hpp.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <linux/futex.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "frames.hpp"
#include "spear/spear.hpp"

namespace {

using Samples = std::vector<double>;
using Clock = std::chrono::steady_clock;
using spear::unreal::FVector;

double us_since(Clock::time_point began) {
    return std::chrono::duration<double, std::micro>(Clock::now() - began).count();
}

constexpr int pings = 200;       ///< round trips of a row, each one a sample
constexpr int warm_up = 50;      ///< before them
constexpr int transactions = 20; ///< of an asynchronous row, together one sample
constexpr int block = 1000;      ///< operations of each

/// Measures `ping`, which makes one round trip.
template <typename F>
Samples measure_pings(F&& ping) {
    for (int i = 0; i < warm_up; ++i) {
        ping();
    }
    Samples samples;
    for (int i = 0; i < pings; ++i) {
        const auto began = Clock::now();
        ping();
        samples.push_back(us_since(began));
    }
    return samples;
}

/// Runs `partner` in a process of its own while `measure` runs in this one.
template <typename P, typename F>
Samples with_partner(P&& partner, F&& measure) {
    const pid_t child = ::fork();
    if (child < 0) {
        std::perror("spear-bench: fork");
        std::exit(1);
    }
    if (child == 0) {
        partner();
        ::_exit(0);
    }
    Samples samples = measure();
    ::waitpid(child, nullptr, 0);
    return samples;
}

/// Which cores a row may use. Free: the scheduler decides, and a sleeping partner is woken on the waker's core in one run
/// and on the other in the next, which is four to ten times as slow on a virtual machine. So rows that sleep are also
/// measured with both sides on one core, and on two.
enum class Placement { free, one_core, two_cores };

/// The cores that this process may use; not fewer than one.
std::vector<int> allowed_cores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    ::sched_getaffinity(0, sizeof(set), &set);
    std::vector<int> cores;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(core, &set)) {
            cores.push_back(core);
        }
    }
    return cores;
}

/// Puts all threads of a process on one core; gives back where they might run before on destruction.
class Pinned {
public:
    Pinned(std::uint64_t process, int core) {
        cpu_set_t set;
        CPU_ZERO(&set);
        CPU_SET(core, &set);
        const std::string tasks = "/proc/" + std::to_string(process) + "/task";
        for (const auto& entry : std::filesystem::directory_iterator(tasks)) {
            const auto thread = static_cast<pid_t>(std::stol(entry.path().filename().string()));
            cpu_set_t before;
            if (::sched_getaffinity(thread, sizeof(before), &before) == 0 &&
                ::sched_setaffinity(thread, sizeof(set), &set) == 0) {
                before_.emplace_back(thread, before);
            }
        }
    }
    ~Pinned() {
        for (const auto& [thread, before] : before_) {
            ::sched_setaffinity(thread, sizeof(before), &before);
        }
    }
    Pinned(const Pinned&) = delete;
    Pinned& operator=(const Pinned&) = delete;

private:
    std::vector<std::pair<pid_t, cpu_set_t>> before_;
};

/// This process on one core, and where its partner belongs; nothing if the scheduler decides.
struct Places {
    std::optional<Pinned> own;
    std::optional<int> partner;

    explicit Places(Placement placement) {
        if (placement == Placement::free) {
            return;
        }
        const std::vector<int> cores = allowed_cores();
        partner = placement == Placement::one_core ? cores.front() : cores.back();
        own.emplace(static_cast<std::uint64_t>(::getpid()), cores.front());
    }
};

/// The floor: one byte there and back over a raw Unix socket, between two processes.
Samples floor_socket(Placement placement) {
    const Places places(placement);
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
        std::perror("spear-bench: socketpair");
        std::exit(1);
    }
    return with_partner(
        [&] {
            std::optional<Pinned> own;
            if (places.partner) {
                own.emplace(static_cast<std::uint64_t>(::getpid()), *places.partner);
            }
            ::close(ends[0]);
            char byte = 0;
            while (::read(ends[1], &byte, 1) == 1 && ::write(ends[1], &byte, 1) == 1) {}
        },
        [&] {
            ::close(ends[1]);
            Samples samples = measure_pings([&] {
                char byte = 1;
                if (::write(ends[0], &byte, 1) != 1 || ::read(ends[0], &byte, 1) != 1) {
                    std::exit(1);
                }
            });
            ::close(ends[0]);
            return samples;
        });
}

/// What shared memory alone costs: a number there and back.
Samples floor_memory(bool spins) {
    struct Words {
        alignas(128) std::uint32_t there;
        alignas(128) std::uint32_t back;
    };
    auto* const words =
        static_cast<Words*>(::mmap(nullptr, sizeof(Words), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    constexpr std::uint32_t rounds = pings + warm_up;
    const auto wait = [&](std::uint32_t* word, std::uint32_t wanted) {
        for (std::uint32_t seen; (seen = __atomic_load_n(word, __ATOMIC_SEQ_CST)) != wanted;) {
            if (spins) {
#if defined(__x86_64__)
                __builtin_ia32_pause();
#endif
            } else {
                ::syscall(SYS_futex, word, FUTEX_WAIT, seen, nullptr, nullptr, 0);
            }
        }
    };
    const auto post = [&](std::uint32_t* word, std::uint32_t value) {
        __atomic_store_n(word, value, __ATOMIC_SEQ_CST);
        if (!spins) {
            ::syscall(SYS_futex, word, FUTEX_WAKE, 1, nullptr, nullptr, 0);
        }
    };
    Samples samples = with_partner(
        [&] {
            for (std::uint32_t i = 1; i <= rounds; ++i) {
                wait(&words->there, i);
                post(&words->back, i);
            }
        },
        [&] {
            std::uint32_t i = 0;
            return measure_pings([&] {
                post(&words->there, ++i);
                wait(&words->back, i);
            });
        });
    ::munmap(words, sizeof(Words));
    return samples;
}

/// A client and what it calls.
struct Client {
    spear::Instance instance;
    spear::Object bench;

    Client(const std::string& address, spear::SessionOptions options)
        : instance(spear::connect(address, std::move(options))) {
        auto frame = instance.begin_frame();
        bench = instance.game().new_object("USpearBench");
        frame.execute();
        instance.end_frame().execute();
    }

    /// Runs it in a begin_frame block that holds the game thread already.
    template <typename F>
    Samples in_block(F&& f) {
        auto frame = instance.begin_frame();
        bench.call<FVector>("Move", FVector{1, 0, 0});
        Samples samples = f();
        frame.execute();
        instance.end_frame().execute();
        instance.flush();
        return samples;
    }
};

Samples synchronous(
    const std::string& address, spear::SessionOptions options, Placement placement = Placement::free) {
    Client client(address, std::move(options));
    const Places places(placement);
    std::optional<Pinned> engine;
    if (places.partner) {
        engine.emplace(client.instance.engine_info().process_id, *places.partner);
    }
    return client.in_block(
        [&] { return measure_pings([&] { client.bench.call<FVector>("Move", FVector{1, 0, 0}); }); });
}

Samples synchronous_read(const std::string& address) {
    Client client(address, {});
    return client.in_block([&] { return measure_pings([&] { (void)client.bench["Place.X"].get<double>(); }); });
}

/// Blocks of asynchronous calls, one after the other; the engine runs one while the next is recorded.
template <typename F>
Samples asynchronous(const std::string& address, spear::SessionOptions options, F&& record) {
    Client client(address, std::move(options));
    const auto run = [&] {
        for (int i = 0; i < transactions; ++i) {
            auto begin = client.instance.begin_frame();
            record(client);
            begin.execute();
            client.instance.end_frame().execute();
        }
        client.instance.flush();
    };
    run();
    const auto began = Clock::now();
    run();
    return {us_since(began) / (transactions * block)};
}

void record_futures(Client& client) {
    std::vector<spear::Future<FVector>> futures;
    futures.reserve(block);
    for (int i = 0; i < block; ++i) {
        futures.push_back(client.bench.async<FVector>("Move", FVector{1, 0, 0}));
    }
}

void record_sends(Client& client) {
    for (int i = 0; i < block; ++i) {
        client.bench.send("Move", FVector{1, 0, 0});
    }
}

Samples direct(const std::string& address, bool by_name) {
    Client client(address, {});
    return client.in_block([&] {
        client.bench.call<double>("MeasureDirect", block, by_name);
        return Samples{client.bench.call<double>("MeasureDirect", transactions * block, by_name) / 1000};
    });
}

const std::vector<std::pair<std::string, std::function<Samples(const std::string&)>>>& rows() {
    static const std::vector<std::pair<std::string, std::function<Samples(const std::string&)>>> table = {
        {"floor", [](const std::string&) { return floor_socket(Placement::free); }},
        {"floor_one_core", [](const std::string&) { return floor_socket(Placement::one_core); }},
        {"floor_two_cores", [](const std::string&) { return floor_socket(Placement::two_cores); }},
        {"memory_spinning", [](const std::string&) { return floor_memory(true); }},
        {"memory_sleeping", [](const std::string&) { return floor_memory(false); }},
        {"cpp_sync", [](const std::string& address) { return synchronous(address, {}); }},
        {"cpp_sync_no_spin", [](const std::string& address) { return synchronous(address, {.spin = false}); }},
        {"cpp_sync_no_spin_one_core",
            [](const std::string& address) { return synchronous(address, {.spin = false}, Placement::one_core); }},
        {"cpp_sync_no_spin_two_cores",
            [](const std::string& address) { return synchronous(address, {.spin = false}, Placement::two_cores); }},
        {"cpp_sync_rpc", [](const std::string& address) { return synchronous(address, {.channel = false}); }},
        {"cpp_sync_read", [](const std::string& address) { return synchronous_read(address); }},
        {"cpp_async", [](const std::string& address) { return asynchronous(address, {}, record_futures); }},
        {"cpp_send", [](const std::string& address) { return asynchronous(address, {}, record_sends); }},
        {"cpp_async_rpc",
            [](const std::string& address) { return asynchronous(address, {.channel = false}, record_futures); }},
        {"direct", [](const std::string& address) { return direct(address, true); }},
        {"direct_bare", [](const std::string& address) { return direct(address, false); }},
    };
    return table;
}

int print_transactions(const std::string& address, std::size_t transactions, std::size_t calls) {
    try {
        const TransactionFrames result = run_transactions(address, transactions, calls);
        std::cout << "{\"frames\": [";
        const char* separator = "";
        for (const std::int64_t frame : result.frames) {
            std::cout << std::exchange(separator, ", ") << frame;
        }
        std::cout << "], \"split\": " << result.split << '}' << std::endl;
        return 0;
    } catch (const spear::Error& error) {
        std::cerr << "spear-bench: " << error.what() << '\n';
        return 1;
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 6 && std::string(argv[2]) == "--transactions" && std::string(argv[4]) == "--calls") {
        return print_transactions(argv[1], std::strtoull(argv[3], nullptr, 10), std::strtoull(argv[5], nullptr, 10));
    }
    if (argc != 2 || std::string(argv[1]) == "--help") {
        std::cerr << "usage: spear-bench ADDRESS | ADDRESS --transactions N --calls M | --rows\n";
        return 2;
    }
    const std::string address = argv[1];
    if (address == "--rows") {
        for (const auto& [name, measure] : rows()) {
            std::cout << name << '\n';
        }
        return 0;
    }
    std::string wanted;
    while (std::getline(std::cin, wanted)) {
        const auto at = std::ranges::find(rows(), wanted, [](const auto& row) { return row.first; });
        if (at == rows().end()) {
            std::cerr << "spear-bench: no row '" << wanted << "'\n";
            return 2;
        }
        try {
            std::cout << "{\"row\": \"" << wanted << "\", \"us\": [";
            const char* separator = "";
            for (const double sample : at->second(address)) {
                std::cout << std::exchange(separator, ", ") << sample;
            }
            std::cout << "]}" << std::endl;
        } catch (const spear::Error& error) {
            std::cerr << "spear-bench: " << wanted << ": " << error.what() << '\n';
            return 1;
        }
    }
    return 0;
}
