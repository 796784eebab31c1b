// SPDX-License-Identifier: MIT
#include <atomic>
#include <cstring>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <ctime>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "spear_trace.h"

extern "C" {
uint32_t spear_trace_level = SPEAR_TRACE_OFF; // changed under Recorder::mutex, read by everybody
}

namespace {

constexpr std::size_t most_texts = 1u << 16;

/// What one thread has recorded. Written by that thread; who reads takes `count` first.
struct Buffer {
    std::uint64_t recording = 0;
    std::size_t capacity = 0;
    std::unique_ptr<spear_trace_event[]> events; // not zero-filled: memory is taken as it is used
    std::atomic<std::size_t> count{0};
    std::atomic<std::uint64_t> dropped{0};
    std::string name;
    std::uint64_t thread_id = 0;
};

struct Recording {
    std::uint64_t number = 0;
    std::size_t capacity = 0;
    std::vector<std::shared_ptr<Buffer>> buffers;
    std::unordered_map<std::string, std::uint32_t> text_numbers;
    std::vector<std::string> texts;
};

/// One for each process; never destroyed, as threads may outlive static objects.
struct Recorder {
    std::mutex mutex;
    std::unique_ptr<Recording> running; // under mutex
    std::uint64_t last = 0;             // under mutex: number of the last recording
    std::atomic<std::uint64_t> current{0};
};

Recorder& recorder() {
    static Recorder* const made = new Recorder;
    return *made;
}

struct ThisThread {
    std::shared_ptr<Buffer> buffer;
    std::uint64_t without_memory = 0; // the recording for which there was none
    char name[32] = "";
};
thread_local ThisThread this_thread;

std::string thread_name() {
    if (this_thread.name[0] != 0) {
        return this_thread.name;
    }
    if (static_cast<pid_t>(::syscall(SYS_gettid)) == ::getpid()) {
        return "main thread";
    }
    char system_name[16] = "";
    ::pthread_getname_np(::pthread_self(), system_name, sizeof(system_name));
    return system_name;
}

/// The calling thread's buffer in the running recording; null if there is none.
Buffer* buffer_of_thread() {
    Recorder& all = recorder();
    const std::uint64_t current = all.current.load(std::memory_order_acquire);
    if (this_thread.buffer && this_thread.buffer->recording == current) {
        return this_thread.buffer.get();
    }
    if (current == 0 || this_thread.without_memory == current) {
        return nullptr;
    }
    const std::lock_guard lock(all.mutex);
    if (!all.running) {
        return nullptr;
    }
    try {
        auto made = std::make_shared<Buffer>();
        made->recording = all.running->number;
        made->capacity = all.running->capacity;
        made->events.reset(new spear_trace_event[made->capacity]);
        made->name = thread_name();
        made->thread_id = static_cast<std::uint64_t>(::syscall(SYS_gettid));
        all.running->buffers.push_back(made);
        this_thread.buffer = std::move(made);
        return this_thread.buffer.get();
    } catch (const std::bad_alloc&) {
        this_thread.without_memory = all.running->number;
        return nullptr;
    }
}

} // namespace

struct spear_trace {
    struct Thread {
        std::shared_ptr<const Buffer> buffer;
        std::size_t count = 0; // as of the end: threads that were in the middle of a record may add one
        std::uint64_t dropped = 0;
    };
    std::vector<Thread> threads;
    std::vector<std::string> texts;
};

extern "C" uint64_t spear_trace_now(void) {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<uint64_t>(now.tv_sec) * 1'000'000'000u + static_cast<uint64_t>(now.tv_nsec);
}

extern "C" void spear_trace_record(const spear_trace_event* event) {
    Buffer* const buffer = buffer_of_thread();
    if (!buffer) {
        return;
    }
    const std::size_t count = buffer->count.load(std::memory_order_relaxed); // only this thread writes it
    if (count == buffer->capacity) {
        buffer->dropped.store(buffer->dropped.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        return;
    }
    buffer->events[count] = *event;
    buffer->count.store(count + 1, std::memory_order_release);
}

extern "C" uint32_t spear_trace_text(const char* text, size_t size) {
    Recorder& all = recorder();
    const std::lock_guard lock(all.mutex);
    if (!all.running) {
        return 0;
    }
    try {
        Recording& running = *all.running;
        std::string key(text, size);
        if (const auto found = running.text_numbers.find(key); found != running.text_numbers.end()) {
            return found->second;
        }
        if (running.texts.size() == most_texts) {
            return 0;
        }
        running.texts.push_back(key);
        const auto number = static_cast<std::uint32_t>(running.texts.size());
        running.text_numbers.emplace(std::move(key), number);
        return number;
    } catch (const std::bad_alloc&) {
        return 0;
    }
}

extern "C" void spear_trace_name_thread(const char* name) {
    std::strncpy(this_thread.name, name, sizeof(this_thread.name) - 1);
}

extern "C" uint64_t spear_trace_start(uint32_t level, size_t events_per_thread) {
    Recorder& all = recorder();
    const std::lock_guard lock(all.mutex);
    try {
        auto made = std::make_unique<Recording>();
        made->number = ++all.last;
        made->capacity = events_per_thread;
        all.running = std::move(made);
    } catch (const std::bad_alloc&) {
        return 0;
    }
    all.current.store(all.last, std::memory_order_release);
    __atomic_store_n(&spear_trace_level, level, __ATOMIC_RELAXED);
    return all.last;
}

extern "C" int spear_trace_runs(uint64_t recording) {
    return recording != 0 && recorder().current.load(std::memory_order_acquire) == recording;
}

extern "C" spear_trace* spear_trace_stop(uint64_t recording) {
    Recorder& all = recorder();
    const std::lock_guard lock(all.mutex);
    if (!all.running || all.running->number != recording) {
        return nullptr;
    }
    __atomic_store_n(&spear_trace_level, std::uint32_t{SPEAR_TRACE_OFF}, __ATOMIC_RELAXED);
    all.current.store(0, std::memory_order_release);
    const std::unique_ptr<Recording> ended = std::move(all.running);
    try {
        auto made = std::make_unique<spear_trace>();
        for (const auto& buffer : ended->buffers) {
            made->threads.push_back({buffer, buffer->count.load(std::memory_order_acquire),
                buffer->dropped.load(std::memory_order_relaxed)});
        }
        made->texts = std::move(ended->texts);
        return made.release();
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

extern "C" size_t spear_trace_thread_count(const spear_trace* trace) { return trace->threads.size(); }

extern "C" const spear_trace_event* spear_trace_thread(
    const spear_trace* trace, size_t thread, const char** name, uint64_t* thread_id, size_t* count, uint64_t* dropped) {
    const spear_trace::Thread& wanted = trace->threads[thread];
    *name = wanted.buffer->name.c_str();
    *thread_id = wanted.buffer->thread_id;
    *count = wanted.count;
    *dropped = wanted.dropped;
    return wanted.buffer->events.get();
}

extern "C" size_t spear_trace_text_count(const spear_trace* trace) { return trace->texts.size(); }
extern "C" const char* spear_trace_text_at(const spear_trace* trace, size_t number) {
    return number >= 1 && number <= trace->texts.size() ? trace->texts[number - 1].c_str() : "";
}
extern "C" void spear_trace_free(spear_trace* trace) { delete trace; }
