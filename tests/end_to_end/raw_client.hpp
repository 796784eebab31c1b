// SPDX-License-Identifier: MIT
#pragma once

// A client without the SDK's manners: it submits whatever bytes a test likes.

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine_fixture.hpp"

#include "spear_wire.h"

namespace end_to_end {

class RawClient {
public:
    struct Reply {
        bool has_error = false;
        spear::ErrorCode error = spear::ErrorCode::Error;
        std::string message{};
        std::vector<std::byte> types{}, answers{};
        std::uint64_t frame = 0;

        /// The answers: number -> value bytes, or error.
        std::map<std::uint64_t, std::vector<std::byte>> values() const;
        std::map<std::uint64_t, spear::ErrorInfo> errors() const;
    };
    struct Batch {
        std::uint64_t transaction = 0;
        std::uint8_t block = SPEAR_BLOCK_NONE;
        bool closes = false, abort = false, single_step = false;
        std::vector<std::byte> types{}, operations{};
        std::vector<std::uint64_t> releases{};
    };

    explicit RawClient(const std::vector<std::string>& entry_points = all_signatures(), std::uint32_t lease_ms = 20'000,
        spear::Instance& of = engine());
    ~RawClient();
    RawClient(const RawClient&) = delete;
    RawClient& operator=(const RawClient&) = delete;

    static std::vector<std::string> all_signatures();
    bool connected() const { return client_ != nullptr; }
    const spear_wire_error& connect_error() const { return connect_error_; }

    std::uint64_t submit(const Batch& batch);
    /// The reply, or nothing if the session was lost or the time has passed.
    std::optional<Reply> wait(std::uint64_t request, spear::Milliseconds timeout = 60s);
    std::optional<Reply> exchange(const Batch& batch) { return wait(submit(batch)); }
    /// Waits until the server has ended the session; false if it does not.
    bool lost();
    void close();

    /// Appends an operation to a batch.
    template <typename E, typename F>
    static void add(Batch& batch, const E&, std::uint64_t number, F&& put_arguments,
        spear::OperationFlags flags = spear::OperationFlags::wants_answer) {
        spear::Encoder out;
        const std::size_t at = spear::begin_operation(out, number, spear::AllEntryPoints::index_of<E>(), flags);
        put_arguments(out);
        spear::end_operation(out, at);
        batch.operations.insert(batch.operations.end(), out.buffer.begin(), out.buffer.end());
    }

private:
    void take(); ///< from the channel
    void add(std::uint64_t request, const spear_answers& answers);
    static void on_answers(void* user, std::uint64_t request, const spear_answers* answers);
    static void on_lost(void* user, const spear_wire_error* error);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<std::uint64_t, Reply> replies_;
    bool lost_ = false;
    std::uint64_t last_request_ = 0;
    spear_client* client_ = nullptr;
    spear_wire_error connect_error_{};
};

inline constexpr auto begin = static_cast<std::uint8_t>(SPEAR_BLOCK_BEGIN);
inline constexpr auto end = static_cast<std::uint8_t>(SPEAR_BLOCK_END);

/// An empty batch that closes a block.
RawClient::Batch closing(std::uint64_t transaction, std::uint8_t block);
inline void put_text(spear::Encoder& out, std::string_view text) { spear::encode_value(out, text); }
void add_find_class(RawClient::Batch& batch, std::uint64_t number, std::string_view name);
void announce(RawClient::Batch& batch, spear::TypeId number, const spear::TypeInfo& info);
/// Runs operations in a transaction of its own and gives the first error.
std::optional<spear::ErrorInfo> error_of(RawClient& client, std::uint64_t transaction, RawClient::Batch batch);

} // namespace end_to_end
