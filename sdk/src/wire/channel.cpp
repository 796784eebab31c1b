// SPDX-License-Identifier: MIT
#include "channel.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <new>
#include <string_view>

#include <csignal>
#include <fcntl.h>
#include <linux/futex.h>
#include <sched.h>
#include <sys/random.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <boost/interprocess/mapped_region.hpp>
#include <boost/interprocess/shared_memory_object.hpp>

namespace spear::wire {
namespace ipc = boost::interprocess;

// Futex

void futex_wait(std::uint32_t* word, std::uint32_t value, std::uint32_t timeout_us) {
    timespec timeout{};
    timeout.tv_sec = static_cast<time_t>(timeout_us / 1'000'000);
    timeout.tv_nsec = static_cast<long>(timeout_us % 1'000'000) * 1000;
    ::syscall(SYS_futex, word, FUTEX_WAIT, value, &timeout, nullptr, 0);
}

void futex_wake(std::uint32_t* word) { ::syscall(SYS_futex, word, FUTEX_WAKE, 0x7fffffff, nullptr, nullptr, 0); }

// Region

namespace {
constexpr std::string_view name_prefix = "spear-";

std::string random_name(const std::uint64_t (&random)[2]) {
    char text[80];
    std::snprintf(text, sizeof(text), "%s%ld-%016llx%016llx", std::string(name_prefix).c_str(),
        static_cast<long>(::getpid()), static_cast<unsigned long long>(random[0]),
        static_cast<unsigned long long>(random[1]));
    return text;
}

bool get_random(void* data, std::size_t size) { return ::getrandom(data, size, 0) == static_cast<ssize_t>(size); }
} // namespace

struct ChannelRegion::Mapping {
    ipc::shared_memory_object memory;
    ipc::mapped_region region;
};

ChannelRegion::ChannelRegion() = default;
ChannelRegion::~ChannelRegion() { unlink(); }

std::unique_ptr<ChannelRegion> ChannelRegion::create(std::string& why) {
    try {
        std::uint64_t random[2];
        std::unique_ptr<ChannelRegion> made(new ChannelRegion);
        if (!get_random(random, sizeof(random)) || !get_random(made->nonce_, sizeof(made->nonce_))) {
            why = "the system gives no random numbers";
            return nullptr;
        }
        made->name_ = random_name(random);
        made->mapping_ = std::make_unique<Mapping>();
        Mapping& mapping = *made->mapping_;
        mapping.memory =
            ipc::shared_memory_object(ipc::create_only, made->name_.c_str(), ipc::read_write, ipc::permissions(0600));
        made->linked_ = true;
        mapping.memory.truncate(static_cast<ipc::offset_t>(channel_region_bytes));
        // Without its memory reserved, a full /dev/shm would be a SIGBUS at the first touch.
        const int descriptor = mapping.memory.get_mapping_handle().handle;
        if (const int failed = ::posix_fallocate(descriptor, 0, static_cast<off_t>(channel_region_bytes))) {
            why = std::string("no shared memory: ") + std::strerror(failed);
            return nullptr;
        }
        mapping.region = ipc::mapped_region(mapping.memory, ipc::read_write, 0, channel_region_bytes);
        ChannelHeader& header = made->header(); // the rest is zero
        header.magic = channel_magic;
        header.layout_version = channel_layout_version;
        header.ring_bytes = channel_ring_bytes;
        std::memcpy(header.nonce, made->nonce_, sizeof(header.nonce));
        return made;
    } catch (const std::exception& exception) {
        why = exception.what();
        return nullptr;
    }
}

std::unique_ptr<ChannelRegion> ChannelRegion::open(const std::string& name, std::string& why) {
    if (name.compare(0, name_prefix.size(), name_prefix) != 0 || name.find('/') != std::string::npos) {
        why = "'" + name + "' is no region of ours";
        return nullptr;
    }
    try {
        std::unique_ptr<ChannelRegion> made(new ChannelRegion);
        made->name_ = name;
        made->mapping_ = std::make_unique<Mapping>();
        Mapping& mapping = *made->mapping_;
        mapping.memory = ipc::shared_memory_object(ipc::open_only, name.c_str(), ipc::read_write);
        ipc::offset_t size = 0;
        if (!mapping.memory.get_size(size) || size != static_cast<ipc::offset_t>(channel_region_bytes)) {
            why = "its size is not this layout's";
            return nullptr;
        }
        mapping.region = ipc::mapped_region(mapping.memory, ipc::read_write, 0, channel_region_bytes);
        const ChannelHeader& header = made->header();
        if (header.magic != channel_magic || header.layout_version != channel_layout_version ||
            header.ring_bytes != channel_ring_bytes) {
            why = "its layout is another version's";
            return nullptr;
        }
        std::memcpy(made->nonce_, header.nonce, sizeof(made->nonce_));
        return made;
    } catch (const std::exception& exception) { // of another machine, container or user
        why = exception.what();
        return nullptr;
    }
}

void ChannelRegion::unlink() noexcept {
    if (linked_) {
        linked_ = false;
        ipc::shared_memory_object::remove(name_.c_str());
    }
}

ChannelHeader& ChannelRegion::header() noexcept { return *static_cast<ChannelHeader*>(mapping_->region.get_address()); }
std::byte* ChannelRegion::to_server() noexcept {
    return static_cast<std::byte*>(mapping_->region.get_address()) + channel_header_bytes;
}
std::byte* ChannelRegion::to_client() noexcept { return to_server() + channel_ring_bytes; }

void ChannelRegion::remove_leftovers(const std::function<void(const std::string& name)>& removed) {
    try {
        std::error_code ignored;
        for (const auto& entry : std::filesystem::directory_iterator("/dev/shm", ignored)) {
            const std::string name = entry.path().filename();
            if (name.compare(0, name_prefix.size(), name_prefix) != 0) {
                continue;
            }
            const long process = std::strtol(name.c_str() + name_prefix.size(), nullptr, 10);
            if (process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH) {
                if (ipc::shared_memory_object::remove(name.c_str())) { // not those of other users
                    removed(name);
                }
            }
        }
    } catch (...) { // what cannot be listed is left
    }
}

// Writer

std::size_t ChannelWriter::room() {
    if (broken_) {
        return 0;
    }
    if (written_ - seen_head_ == ring_bytes_ || waiting_.size() != waiting_from_) {
        seen_head_ = load_acquire(head_);
    }
    if (written_ - seen_head_ > ring_bytes_) {
        broken_ = true;
        return 0;
    }
    return ring_bytes_ - static_cast<std::size_t>(written_ - seen_head_);
}

void ChannelWriter::put(const std::byte* data, std::size_t size) {
    if (size == 0) {
        return;
    }
    const std::size_t at = static_cast<std::size_t>(written_) & (ring_bytes_ - 1);
    const std::size_t first = size < ring_bytes_ - at ? size : ring_bytes_ - at;
    std::memcpy(ring_ + at, data, first);
    std::memcpy(ring_, data + first, size - first);
    written_ += size;
}

void ChannelWriter::publish() {
    if (written_ != published_) {
        published_ = written_;
        if (cpu_) {
            note_cpu(cpu_);
        }
        store_ordered(tail_, written_);
    }
}

void ChannelWriter::write(std::initializer_list<Bytes> parts) {
    std::size_t total = 0;
    for (const Bytes& part : parts) {
        total += part.size;
    }
    if (waiting_bytes() != 0) {
        flush();
    }
    std::size_t fits = waiting_bytes() != 0 ? 0 : room();
    if (fits < total && waiting_bytes() == 0) { // the reader may have read since
        seen_head_ = load_acquire(head_);
        fits = room();
    }
    if (fits < total) {
        waiting_.reserve(waiting_.size() + total); // may throw: before anything is written
    }
    for (const Bytes& part : parts) {
        const auto* data = static_cast<const std::byte*>(part.data);
        const std::size_t direct = part.size < fits ? part.size : fits;
        put(data, direct);
        fits -= direct;
        waiting_.insert(waiting_.end(), data + direct, data + part.size);
    }
    publish();
}

bool ChannelWriter::flush() {
    while (waiting_bytes() != 0) {
        const std::size_t fits = room();
        if (fits == 0) {
            return false;
        }
        const std::size_t size = fits < waiting_bytes() ? fits : waiting_bytes();
        put(waiting_.data() + waiting_from_, size);
        waiting_from_ += size;
        publish();
    }
    waiting_.clear();
    waiting_from_ = 0;
    if (waiting_.capacity() > 4 * ring_bytes_) {
        waiting_ = {};
    }
    return true;
}

// Reader

void ChannelReader::take(std::size_t size) {
    const std::uint64_t read = read_.load(std::memory_order_relaxed);
    const std::size_t at = static_cast<std::size_t>(read) & (ring_bytes_ - 1);
    const std::size_t first = size < ring_bytes_ - at ? size : ring_bytes_ - at;
    if (have_ + size > capacity_) {
        // Grows with what has arrived, not with what is announced.
        std::size_t capacity = capacity_ ? capacity_ : 4096;
        while (capacity < have_ + size) {
            capacity *= 2;
        }
        std::unique_ptr<std::byte[]> larger(new std::byte[capacity]);
        if (have_ != 0) {
            std::memcpy(larger.get(), message_.get(), have_);
        }
        message_ = std::move(larger);
        capacity_ = capacity;
    }
    std::memcpy(message_.get() + have_, ring_ + at, first);
    std::memcpy(message_.get() + have_ + first, ring_, size - first);
    have_ += size;
    read_.store(read + size, std::memory_order_relaxed);
}

ChannelReader::Result ChannelReader::next() {
    if (message_size_ != 0 && have_ == message_size_) { // the one of the last call is done with
        have_ = 0;
        message_size_ = 0;
        if (capacity_ > 4 * ring_bytes_) {
            message_.reset();
            capacity_ = 0;
        }
    }
    for (;;) {
        const std::uint64_t there = load_acquire(tail_) - read_.load(std::memory_order_relaxed);
        if (there > ring_bytes_ || broken_) {
            broken_ = true;
            return Result::malformed;
        }
        std::size_t available = static_cast<std::size_t>(there);
        if (available == 0) {
            return Result::nothing;
        }
        if (message_size_ == 0) {
            const std::size_t missing = sizeof(std::uint64_t) - have_;
            const std::size_t size = missing < available ? missing : available;
            take(size);
            available -= size;
            if (have_ == sizeof(std::uint64_t)) {
                std::uint64_t announced = 0;
                std::memcpy(&announced, message_.get(), sizeof(announced));
                if (announced < sizeof(ChannelBatch) || announced % 8 != 0 || announced > max_message_bytes_) {
                    broken_ = true;
                    return Result::malformed;
                }
                message_size_ = static_cast<std::size_t>(announced);
            }
        }
        if (message_size_ != 0) {
            const std::size_t missing = message_size_ - have_;
            take(missing < available ? missing : available);
        }
        store_ordered(head_, read_.load(std::memory_order_relaxed));
        if (message_size_ != 0 && have_ == message_size_) {
            return Result::message;
        }
    }
}

// Spinning

bool setting_is_on(const char* variable) {
    const char* const value = std::getenv(variable);
    if (!value) {
        return true;
    }
    const std::string_view text(value);
    return text != "off" && text != "0" && text != "no" && text != "false";
}

bool Spinner::allowed() {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    const bool several = ::sched_getaffinity(0, sizeof(cores), &cores) != 0 || CPU_COUNT(&cores) > 1;
    return several && setting_is_on("SPEAR_SPIN");
}

std::uint32_t Spinner::this_cpu() { return static_cast<std::uint32_t>(::sched_getcpu() + 1); }

std::uint64_t Spinner::now_ns() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::uint64_t>(now.tv_sec) * 1'000'000'000u + static_cast<std::uint64_t>(now.tv_nsec);
}

} // namespace spear::wire
