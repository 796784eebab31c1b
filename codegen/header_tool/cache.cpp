// SPDX-License-Identifier: MIT
#include "cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace spear::header_tool {

namespace fs = std::filesystem;

namespace {

// First bytes of an entry's file, then the hash of the rest, then the rest.
constexpr std::string_view magic = "SPEARHC1";
constexpr std::size_t head_size = magic.size() + sizeof(Hash);
constexpr std::uint64_t largest_entry = 256ull << 20;
// An entry's time says when it was used last; it is renewed only when it is older, so that a run writes nothing.
constexpr auto renew_after = std::chrono::hours(6);
constexpr auto left_behind_after = std::chrono::hours(1);

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0)
            close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return number_; }
    bool close_now() { return close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
}

// Only files that a cache itself made are ever removed, whatever folder --cache names: "3f/" and 30 digits.
bool is_own(const fs::path& path) {
    auto digits = [](std::string_view text, std::size_t count) {
        return text.size() == count && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
    };
    std::string name = path.filename().string();
    bool temporary = name.ends_with(".part");
    return digits(path.parent_path().filename().string(), 2) &&
           digits(temporary ? std::string_view(name).substr(0, name.find('.')) : std::string_view(name), 30);
}

std::optional<std::string> read_all(int descriptor, std::uint64_t size) {
    std::string out(size, '\0');
    std::size_t done = 0;
    while (done < size) {
        ssize_t n = ::read(descriptor, out.data() + done, size - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return std::nullopt;
        done += static_cast<std::size_t>(n);
    }
    return out;
}

} // namespace

Cache::Cache(std::string folder, std::uint64_t size_limit) : folder_(std::move(folder)), size_limit_(size_limit) {
    if (folder_.empty())
        return;
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_, error))
        note_trouble(fmt::format("cannot create {}: {}", folder_, error ? error.message() : "not a folder"));
}

std::string Cache::file_of(const Hash& key) const {
    std::string name = key.text();
    return fmt::format("{}/{}/{}", folder_, name.substr(0, 2), name.substr(2));
}

std::optional<CacheEntry> Cache::load(const Hash& key) {
    if (!enabled())
        return std::nullopt;
    std::string file = file_of(key);
    Descriptor descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status{};
    if (descriptor.get() < 0 || fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode))
        return std::nullopt;
    auto size = static_cast<std::uint64_t>(status.st_size);
    std::optional<CacheEntry> entry;
    if (size >= head_size && size <= largest_entry)
        if (std::optional<std::string> bytes = read_all(descriptor.get(), size)) {
            Hash sum;
            std::memcpy(&sum, bytes->data() + magic.size(), sizeof sum);
            std::string_view body = std::string_view(*bytes).substr(head_size);
            if (bytes->starts_with(magic) && sum == hash_bytes(body))
                entry = from_bytes(body);
        }
    if (!entry) {
        unlink(file.c_str());
        return std::nullopt;
    }
    auto used = std::chrono::system_clock::from_time_t(status.st_mtime);
    if (std::chrono::system_clock::now() - used > renew_after)
        utimensat(AT_FDCWD, file.c_str(), nullptr, 0);
    return entry;
}

void Cache::store(const Hash& key, const CacheEntry& entry) {
    if (!enabled() || !trouble().empty())
        return;
    std::string body = to_bytes(entry);
    if (body.size() + head_size > largest_entry)
        return;
    Hash sum = hash_bytes(body);
    std::string head(magic);
    head.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    std::string file = file_of(key);
    std::error_code error;
    fs::create_directories(fs::path(file).parent_path(), error);
    // Complete or absent, also when several runs store the same: written under a name of our own, then renamed.
    std::string temporary = fmt::format("{}.{}.{}.part", file, getpid(), stored_++);
    Descriptor descriptor(open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    bool good = descriptor.get() >= 0 && write_all(descriptor.get(), head) && write_all(descriptor.get(), body) &&
                descriptor.close_now() && rename(temporary.c_str(), file.c_str()) == 0;
    if (!good) {
        note_trouble(fmt::format("cannot write in {}: {}", folder_, std::strerror(errno)));
        unlink(temporary.c_str());
    }
}

void Cache::evict() {
    if (!enabled() || stored_ == 0)
        return;
    struct Item {
        fs::file_time_type used;
        std::uint64_t size;
        fs::path path;
    };
    std::vector<Item> items;
    std::uint64_t total = 0;
    std::error_code error;
    auto now = fs::file_time_type::clock::now();
    fs::recursive_directory_iterator it(folder_, fs::directory_options::skip_permission_denied, error), end;
    for (; !error && it != end; it.increment(error)) {
        std::error_code own;
        if (it.depth() > 1)
            it.disable_recursion_pending();
        if (it->is_symlink(own) || !it->is_regular_file(own) || own || !is_own(it->path()))
            continue;
        Item item{it->last_write_time(own), it->file_size(own), it->path()};
        if (own)
            continue;                           // removed by another run meanwhile
        if (item.path.extension() == ".part") { // of a run that was killed
            if (now - item.used > left_behind_after)
                fs::remove(item.path, own);
            continue;
        }
        total += item.size;
        items.push_back(std::move(item));
    }
    if (total <= size_limit_)
        return;
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.used < b.used; });
    // Some room more, so that not every run has to make some.
    for (const Item& item : items) {
        if (total <= size_limit_ - size_limit_ / 5)
            break;
        if (fs::remove(item.path, error))
            total -= item.size;
    }
}

std::string Cache::trouble() const {
    std::lock_guard lock(mutex_);
    return trouble_;
}

void Cache::note_trouble(std::string text) {
    std::lock_guard lock(mutex_);
    if (trouble_.empty())
        trouble_ = std::move(text);
}

std::string default_cache_folder() {
    const char* base = std::getenv("XDG_CACHE_HOME");
    if (base && base[0] == '/')
        return std::string(base) + "/spear/headers";
    const char* home = std::getenv("HOME");
    return home && home[0] == '/' ? std::string(home) + "/.cache/spear/headers" : std::string();
}

std::optional<Hash> tool_fingerprint() {
    Descriptor descriptor(open("/proc/self/exe", O_RDONLY | O_CLOEXEC));
    struct stat status{};
    if (descriptor.get() < 0 || fstat(descriptor.get(), &status) != 0)
        return std::nullopt;
    std::optional<std::string> bytes = read_all(descriptor.get(), static_cast<std::uint64_t>(status.st_size));
    if (!bytes)
        return std::nullopt;
    return hash_bytes(*bytes);
}

} // namespace spear::header_tool
