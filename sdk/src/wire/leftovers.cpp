// SPDX-License-Identifier: MIT
// What killed engines, and killed programs with the engines they had launched, leave behind: sockets, registry entries,
// logs, and in the moment between making a channel's region and unlinking it, that region. Nothing here touches what
// belongs to a process that lives, or to a socket at which somebody answers.
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <string>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "channel.hpp"
#include "registry.hpp"
#include "spear_wire.h"

namespace spear::wire {
namespace {
namespace files = std::filesystem;

bool is_gone(long process) { return process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH; }

/// Whether a socket is there at which nobody listens: certain, also if its process is in another namespace.
bool is_dead_socket(const files::path& path) {
    sockaddr_un where{};
    where.sun_family = AF_UNIX;
    const std::string name = path.string();
    if (name.size() >= sizeof(where.sun_path)) {
        return false;
    }
    std::memcpy(where.sun_path, name.data(), name.size());
    const int probe = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const bool refused = probe >= 0 &&
                         ::connect(probe, reinterpret_cast<const sockaddr*>(&where), sizeof(where)) != 0 &&
                         errno == ECONNREFUSED;
    if (probe >= 0) {
        ::close(probe);
    }
    return refused;
}

/// The process in a name like engine-123-1.sock, engine-123.json or 123.sock; 0 if it is no such name.
long process_of(const std::string& name) {
    constexpr std::string_view prefix = "engine-";
    const std::size_t at = name.compare(0, prefix.size(), prefix) == 0 ? prefix.size() : 0;
    char* end = nullptr;
    const long process = std::strtol(name.c_str() + at, &end, 10);
    return end != name.c_str() + at && (*end == '.' || (at != 0 && *end == '-')) ? process : 0;
}

constexpr auto log_kept_for = std::chrono::hours(24);

} // namespace
} // namespace spear::wire

extern "C" size_t spear_remove_leftovers(
    const char* directory, int logs_too, void* user, void (*each)(void* user, const char* path)) {
    using namespace spear::wire;
    std::size_t count = 0;
    try {
        const auto removed = [&](const std::string& path) {
            ++count;
            if (each) {
                each(user, path.c_str());
            }
        };
        const std::string home = directory && *directory ? directory : runtime_directory();
        std::error_code ignored;
        for (const auto& entry : files::directory_iterator(home, ignored)) {
            const std::string kind = entry.path().extension();
            if (!is_gone(process_of(entry.path().filename()))) {
                continue;
            }
            bool is_left = false;
            if (kind == ".sock") {
                is_left = is_dead_socket(entry.path());
            } else if (kind == ".json" || kind == ".new" || kind == ".token") {
                is_left = true;
            } else if (kind == ".log") { // it says why an engine ended: worth a while
                const auto age = files::file_time_type::clock::now() - entry.last_write_time(ignored);
                is_left = logs_too || age > log_kept_for;
            }
            if (is_left && files::remove(entry.path(), ignored)) {
                removed(entry.path());
            }
        }
        ChannelRegion::remove_leftovers([&](const std::string& name) { removed("/dev/shm/" + name); });
    } catch (...) { // what cannot be read is left
    }
    return count;
}
