// SPDX-License-Identifier: MIT
#include "spear/log.hpp"

#include <cstdio>
#include <memory>
#include <mutex>
#include <string>

namespace spear {
namespace {

struct Handler {
    std::mutex mutex;
    std::shared_ptr<const LogHandler> current;
};

Handler& handler() {
    static Handler* const instance = new Handler; // never destroyed: I/O threads may log while the process ends
    return *instance;
}

void write_to_stderr(LogLevel level, std::string_view message) {
    static constexpr std::string_view names[] = {"", "warning: ", "error: "};
    std::string line("spear: ");
    line.append(names[static_cast<std::size_t>(level)]).append(message).push_back('\n');
    std::fwrite(line.data(), 1, line.size(), stderr);
}

} // namespace

void set_log_handler(LogHandler new_handler) {
    auto shared = new_handler ? std::make_shared<const LogHandler>(std::move(new_handler)) : nullptr;
    const std::lock_guard lock(handler().mutex);
    handler().current.swap(shared);
}

void log_message(LogLevel level, std::string_view message) noexcept {
    try {
        std::shared_ptr<const LogHandler> current;
        {
            const std::lock_guard lock(handler().mutex);
            current = handler().current;
        }
        if (current) {
            (*current)(level, message);
        } else {
            write_to_stderr(level, message);
        }
    } catch (...) { // NOLINT(bugprone-empty-catch): there is nobody left to tell
    }
}

} // namespace spear
