// SPDX-License-Identifier: MIT
#include "loop_queue.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <kj/debug.h>

namespace spear::wire {

LoopQueue::LoopQueue(kj::LowLevelAsyncIoProvider& provider) {
    KJ_SYSCALL(event_fd_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
    using Flags = kj::LowLevelAsyncIoProvider;
    wake_ = provider.wrapInputFd(event_fd_, Flags::ALREADY_CLOEXEC | Flags::ALREADY_NONBLOCK);
}

LoopQueue::~LoopQueue() {
    wake_ = nullptr;
    ::close(event_fd_);
}

bool LoopQueue::post(std::function<void()> work) {
    bool first = false;
    {
        const std::lock_guard lock(mutex_);
        if (closed_) {
            return false;
        }
        first = work_.empty();
        work_.push_back(std::move(work));
        if (first) { // under the lock, so that the descriptor cannot be closed meanwhile
            const std::uint64_t one = 1;
            [[maybe_unused]] const auto written =
                ::write(event_fd_, &one, sizeof(one)); // fails only when already signalled
        }
    }
    return true;
}

void LoopQueue::close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
}

kj::Promise<void> LoopQueue::run() { return drain(); }

kj::Promise<void> LoopQueue::drain() {
    return wake_->tryRead(&wake_count_, sizeof(wake_count_), sizeof(wake_count_)).then([this](std::size_t) {
        std::vector<std::function<void()>> batch;
        {
            const std::lock_guard lock(mutex_);
            batch.swap(work_);
        }
        for (auto& work : batch) {
            work();
        }
        return drain();
    });
}

} // namespace spear::wire
