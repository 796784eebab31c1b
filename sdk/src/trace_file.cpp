// SPDX-License-Identifier: MIT
#include "trace_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "spear/error.hpp"

namespace spear::detail {
namespace {

/// How a kind of event appears in the file.
struct Kind {
    std::string_view name;
    std::string_view category;
    std::string_view a; ///< name of the argument; empty: none
    std::string_view b;
    bool has_block = false;
};

constexpr std::array<Kind, SPEAR_TRACE_KINDS> kinds = {{
    {},
    {"begin_frame block", "client", "session", "transaction"},
    {"end_frame block", "client", "session", "transaction"},
    {"send", "client", "session", "transaction", true},
    {"wait for result", "client", "session", "operation"},
    {"wait for frame", "client", "session", "transaction"},
    {"receive", "server", "session", "transaction", true},
    {"queued", "server", "session", "transaction", true},
    {"answer", "server", "session", "request"},
    {"frame", "game", "frame", ""},
    {"begin work", "game", "session", "transaction"},
    {"end work", "game", "session", "transaction"},
    {"waiting for client", "game", "session", ""},
    {"world tick", "game", "", ""},
    {"idle", "game", "", ""},
    {"operation", "operation", "operation", ""},
}};

std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (const char character : text) {
        const auto byte = static_cast<unsigned char>(character);
        if (character == '"' || character == '\\') {
            out += '\\';
            out += character;
        } else if (byte < 0x20) {
            out += fmt::format("\\u{:04x}", byte);
        } else {
            out += character;
        }
    }
    return out + '"';
}

/// Microseconds, as the format wants them, with all digits of the nanoseconds.
std::string microseconds(std::uint64_t nanoseconds) {
    return fmt::format("{}.{:03}", nanoseconds / 1000, nanoseconds % 1000);
}

/// Leaves out what belongs to a frame that was under way when the recording began or ended.
void keep_whole_frames(RecordedThread& thread) {
    std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t last = 0;
    for (const spear_trace_event& event : thread.events) {
        if (event.kind == SPEAR_TRACE_FRAME) {
            first = std::min(first, event.begin_ns);
            last = std::max(last, event.begin_ns + event.duration_ns);
        }
    }
    if (last != 0) {
        std::erase_if(thread.events, [&](const spear_trace_event& event) {
            return event.begin_ns < first || event.begin_ns + event.duration_ns > last;
        });
    }
}

/// The way of a block from the client through the queue to the game thread, drawn as arrows. Named by session,
/// transaction and block.
using FlowKey = std::tuple<std::uint64_t, std::uint64_t, std::uint16_t>;

std::optional<FlowKey> flow_of(const spear_trace_event& event) {
    switch (event.kind) {
    case SPEAR_TRACE_SEND:
    case SPEAR_TRACE_RECEIVE:
        return event.detail != 0 ? std::optional(FlowKey{event.a, event.b, event.detail}) : std::nullopt;
    case SPEAR_TRACE_BEGIN_WORK:
        return FlowKey{event.a, event.b, std::uint16_t{1}};
    case SPEAR_TRACE_END_WORK:
        return FlowKey{event.a, event.b, std::uint16_t{2}};
    default:
        return std::nullopt;
    }
}

class Writer {
public:
    explicit Writer(const std::filesystem::path& file) : out_(file, std::ios::binary | std::ios::trunc) {}

    template <typename... A>
    void event(fmt::format_string<A...> format, A&&... arguments) {
        line_.clear();
        fmt::format_to(std::back_inserter(line_), format, std::forward<A>(arguments)...);
        out_ << (std::exchange(is_first_, false) ? "\n" : ",\n") << line_;
    }
    std::ofstream& stream() { return out_; }

private:
    std::ofstream out_;
    std::string line_;
    bool is_first_ = true;
};

void write_threads(Writer& out, const RecordedProcess& process, std::uint64_t base) {
    for (const RecordedThread& thread : process.threads) {
        for (const spear_trace_event& event : thread.events) {
            if (event.kind == 0 || event.kind >= kinds.size()) {
                continue;
            }
            const Kind& kind = kinds[event.kind];
            std::string name(kind.name);
            std::string arguments;
            const auto add = [&arguments](std::string_view argument, const std::string& value) {
                arguments += fmt::format("{}\"{}\":{}", arguments.empty() ? "" : ",", argument, value);
            };
            if (!kind.a.empty())
                add(kind.a, std::to_string(event.a));
            if (!kind.b.empty())
                add(kind.b, std::to_string(event.b));
            if (kind.has_block)
                add("block", event.detail == 1 ? "\"begin_frame\"" : event.detail == 2 ? "\"end_frame\"" : "null");
            if (event.kind == SPEAR_TRACE_FRAME)
                name += fmt::format(" {}", event.a);
            if (event.text != 0 && event.text <= process.texts.size()) {
                const std::string& text = process.texts[event.text - 1];
                if (event.kind == SPEAR_TRACE_OPERATION)
                    name = text;
                else
                    add("of", json_text(text));
            }
            const bool is_moment = event.kind == SPEAR_TRACE_QUEUED;
            out.event(R"({{"ph":"{}","name":{},"cat":"{}","pid":{},"tid":{},"ts":{},{},"args":{{{}}}}})",
                is_moment ? "i" : "X", json_text(name), kind.category, process.id, thread.id,
                microseconds(event.begin_ns - base),
                is_moment ? std::string(R"("s":"t")") : R"("dur":)" + microseconds(event.duration_ns), arguments);
        }
    }
}

/// Arrows from client to engine: only where both are in the trace, and there is one engine, whose sessions they are.
void write_flows(Writer& out, const std::vector<RecordedProcess>& processes, std::uint64_t base) {
    struct Point {
        const RecordedProcess* process;
        const RecordedThread* thread;
        std::uint64_t time;
        std::uint16_t kind;
    };
    if (std::ranges::count_if(processes, &RecordedProcess::is_engine) != 1) {
        return;
    }
    std::map<FlowKey, std::vector<Point>> flows;
    for (const RecordedProcess& process : processes) {
        for (const RecordedThread& thread : process.threads) {
            for (const spear_trace_event& event : thread.events) {
                if (const auto key = flow_of(event)) {
                    flows[*key].push_back({&process, &thread, event.begin_ns, event.kind});
                }
            }
        }
    }
    std::uint64_t number = 0;
    for (auto& [key, points] : flows) {
        std::ranges::sort(points, {}, [](const Point& point) { return std::pair(point.time, point.kind); });
        const auto next = [&points](std::size_t from, auto&& wanted) {
            return static_cast<std::size_t>(
                std::find_if(points.begin() + static_cast<std::ptrdiff_t>(from), points.end(), wanted) -
                points.begin());
        };
        // The first message of the block, as it is sent, received and worked on.
        const std::size_t sent = next(0, [](const Point& point) { return point.kind == SPEAR_TRACE_SEND; });
        const std::size_t worked = next(sent, [](const Point& point) {
            return point.kind == SPEAR_TRACE_BEGIN_WORK || point.kind == SPEAR_TRACE_END_WORK;
        });
        if (worked >= points.size()) {
            continue;
        }
        ++number;
        const auto write = [&](const Point& point, std::string_view phase) {
            out.event(R"({{"ph":"{}","name":"block","cat":"flow","id":{},"pid":{},"tid":{},"ts":{}{}}})", phase, number,
                point.process->id, point.thread->id, microseconds(point.time - base),
                phase == "f" ? R"(,"bp":"e")" : "");
        };
        write(points[sent], "s");
        const std::size_t received = next(sent, [](const Point& point) { return point.kind == SPEAR_TRACE_RECEIVE; });
        if (received < worked) {
            write(points[received], "t");
        }
        write(points[worked], "f");
    }
}

} // namespace

void write_trace_file(const std::filesystem::path& file, std::vector<RecordedProcess> processes) {
    std::uint64_t base = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t i = 0; i < processes.size(); ++i) {
        // In containers two processes may have the same number: the file tells them apart.
        for (std::size_t j = 0; j < i; ++j) {
            if (processes[j].id == processes[i].id && processes[j].is_engine != processes[i].is_engine) {
                processes[i].id += 1'000'000;
            }
        }
        for (RecordedThread& thread : processes[i].threads) {
            keep_whole_frames(thread);
            // Outer spans before inner ones, as readers like them.
            std::ranges::sort(thread.events, [](const spear_trace_event& x, const spear_trace_event& y) {
                return std::tuple(x.begin_ns, y.duration_ns, x.kind) < std::tuple(y.begin_ns, x.duration_ns, y.kind);
            });
            if (!thread.events.empty()) {
                base = std::min(base, thread.events.front().begin_ns);
            }
        }
    }
    Writer out(file);
    out.stream() << R"({"displayTimeUnit":"ms","traceEvents":[)";
    std::uint64_t dropped = 0;
    for (std::size_t i = 0; i < processes.size(); ++i) {
        const RecordedProcess& process = processes[i];
        out.event(
            R"({{"ph":"M","name":"process_name","pid":{},"args":{{"name":{}}}}})", process.id, json_text(process.name));
        out.event(R"({{"ph":"M","name":"process_sort_index","pid":{},"args":{{"sort_index":{}}}}})", process.id, i);
        for (const RecordedThread& thread : process.threads) {
            out.event(R"({{"ph":"M","name":"thread_name","pid":{},"tid":{},"args":{{"name":{}}}}})", process.id,
                thread.id, json_text(thread.name));
            dropped += thread.dropped;
        }
        write_threads(out, process, base);
    }
    write_flows(out, processes, base);
    out.stream() << "\n],\n\"otherData\":{"
                 << fmt::format(R"("clock_base_ns":{},"dropped_events":{})",
                        base == std::numeric_limits<std::uint64_t>::max() ? 0 : base, dropped)
                 << "}}\n";
    out.stream().close();
    if (!out.stream()) {
        throw_error(ErrorCode::ConnectionError,
            fmt::format("The trace file {} cannot be written: {}.", file.string(), std::strerror(errno)), "trace");
    }
}

} // namespace spear::detail
