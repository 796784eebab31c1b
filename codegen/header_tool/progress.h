// SPDX-License-Identifier: MIT
// Progress on a terminal, and work spread over threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>

namespace spear::header_tool {

// A bar on stderr where that is a terminal, silence elsewhere.
class Progress {
public:
    Progress(std::string title, std::size_t total, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step();

private:
    void draw(std::size_t done);

    std::string title_;
    std::size_t total_;
    bool shown_;
    std::atomic<std::size_t> done_{0};
    std::mutex mutex_;
    std::size_t drawn_ = 0; // percent
};

// Calls work(0) ... work(count - 1) on `jobs` threads, in no order. `work` must not throw.
void parallel(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work);

} // namespace spear::header_tool
