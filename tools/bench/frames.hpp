// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Which frames so many asynchronous transactions in a row ran in.
struct TransactionFrames {
    std::vector<std::int64_t> frames; ///< of the begin_frame block of each transaction
    std::size_t split = 0;            ///< transactions whose end_frame block ran in another frame: must be 0
};

/// Runs transactions of `calls` asynchronous calls each, one after the other, without ever waiting for a result: what
/// opening a block waits for is all. The engine needs the plugin SpearBench. Raises spear::Error.
TransactionFrames run_transactions(const std::string& address, std::size_t transactions, std::size_t calls);
