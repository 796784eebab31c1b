// SPDX-License-Identifier: MIT
#include "registry.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "spear_wire.h"

namespace spear::wire {
namespace files = std::filesystem;

std::string runtime_directory() {
    const char* runtime = std::getenv("XDG_RUNTIME_DIR");
    const std::string directory =
        runtime && *runtime ? std::string(runtime) + "/spear" : "/tmp/spear-" + std::to_string(::getuid());
    if (::mkdir(directory.c_str(), 0700) != 0 && errno != EEXIST) {
        return {};
    }
    // /tmp is everybody's: only a directory that is ours, and no link, may hold our sockets.
    struct stat info{};
    if (::lstat(directory.c_str(), &info) != 0 || !S_ISDIR(info.st_mode) || info.st_uid != ::getuid() ||
        (info.st_mode & 0022) != 0) {
        return {};
    }
    return directory;
}

namespace {

/// When a process began, in the kernel's ticks since boot: tells it from a later one of the same number. 0: unknown.
std::uint64_t start_time_of(pid_t process) {
    std::ifstream in("/proc/" + std::to_string(process) + "/stat");
    std::string text((std::istreambuf_iterator<char>(in)), {});
    const std::size_t after_name = text.rfind(')'); // the name may hold spaces and parentheses
    if (after_name == std::string::npos) {
        return 0;
    }
    std::istringstream rest(text.substr(after_name + 1));
    std::string field;
    for (int i = 3; i < 22 && rest >> field; ++i) {}
    std::uint64_t ticks = 0;
    rest >> ticks;
    return rest ? ticks : 0;
}

/// Whether the process of an entry still runs.
bool is_running(const nlohmann::json& entry) {
    const auto process = entry["pid"].get<pid_t>();
    if (process <= 0 || (::kill(process, 0) != 0 && errno == ESRCH)) {
        return false;
    }
    const auto began = entry.find("started");
    const std::uint64_t begins = start_time_of(process);
    return began == entry.end() || !began->is_number_unsigned() || begins == 0 || began->get<std::uint64_t>() == begins;
}

} // namespace

RegistryEntry::RegistryEntry(const std::string& directory, const std::string& address) {
    const std::string home = directory.empty() ? runtime_directory() : directory;
    if (home.empty()) {
        return;
    }
    const std::string file = home + "/engine-" + std::to_string(::getpid()) + ".json";
    const std::string unfinished = file + ".new";
    std::ofstream out(unfinished);
    out << nlohmann::json{{"address", address}, {"pid", ::getpid()}, {"started", start_time_of(::getpid())}}.dump()
        << '\n';
    out.close();
    if (out && std::rename(unfinished.c_str(), file.c_str()) == 0) {
        file_ = file;
    }
}

RegistryEntry::~RegistryEntry() {
    if (!file_.empty()) {
        ::unlink(file_.c_str());
    }
}

} // namespace spear::wire

extern "C" size_t spear_runtime_directory(char* buffer, size_t size) {
    try {
        const std::string directory = spear::wire::runtime_directory();
        if (size > directory.size()) {
            std::memcpy(buffer, directory.c_str(), directory.size() + 1);
        }
        return directory.size();
    } catch (...) {
        return 0;
    }
}

extern "C" size_t spear_list_engines(
    const char* directory, void* user, void (*each)(void* user, const char* address, uint64_t process_id)) {
    std::size_t count = 0;
    try {
        const std::string home = directory && *directory ? directory : spear::wire::runtime_directory();
        std::error_code ignored;
        for (const auto& entry : spear::wire::files::directory_iterator(home, ignored)) {
            const std::string name = entry.path().filename();
            if (name.rfind("engine-", 0) != 0 || entry.path().extension() != ".json") {
                continue;
            }
            std::ifstream in(entry.path());
            const auto json = nlohmann::json::parse(in, nullptr, false);
            if (!json.is_object() || !json.contains("address") || !json["address"].is_string() ||
                !json.contains("pid") || !json["pid"].is_number_integer()) {
                continue;
            }
            if (!spear::wire::is_running(json)) {
                spear::wire::files::remove(entry.path(), ignored); // its engine was killed
                continue;
            }
            each(user, json["address"].get_ref<const std::string&>().c_str(), json["pid"].get<uint64_t>());
            ++count;
        }
    } catch (...) { // an unreadable directory lists nothing
    }
    return count;
}
