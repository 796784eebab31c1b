// SPDX-License-Identifier: MIT
#include "progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <thread>
#include <unistd.h>
#include <vector>

namespace spear::header_tool {

Progress::Progress(std::string title, std::size_t total, bool quiet)
    : title_(std::move(title)), total_(total), shown_(!quiet && isatty(2) && total > 0) {
    if (shown_)
        draw(0);
}

Progress::~Progress() {
    if (shown_) {
        fmt::print(stderr, "\r{:70}\r", "");
        std::fflush(stderr);
    }
}

void Progress::step() {
    std::size_t done = ++done_;
    if (!shown_)
        return;
    std::lock_guard lock(mutex_);
    if (done * 100 / total_ > drawn_)
        draw(done);
}

void Progress::draw(std::size_t done) {
    constexpr std::size_t width = 30;
    drawn_ = std::min<std::size_t>(100, done * 100 / total_);
    std::size_t filled = std::min(width, width * done / total_);
    fmt::print(stderr, "\r{:<10} [{}{}] {}/{}", title_, std::string(filled, '#'), std::string(width - filled, '.'),
        done, total_);
    std::fflush(stderr);
}

void parallel(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    auto loop = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < jobs && i < count; ++i)
        threads.emplace_back(loop);
    loop();
}

} // namespace spear::header_tool
