// SPDX-License-Identifier: MIT
#pragma once

// Frame: an open begin_frame or end_frame block. Two blocks make a transaction, which runs within one frame of the
// engine:
//
//     {
//         auto frame = instance.begin_frame();      // work at the beginning of a frame
//         location = actor.async<FVector>("K2_GetActorLocation");
//         frame.execute();                          // errors surface here, not in a destructor
//     }
//     {
//         auto frame = instance.end_frame({.single_step = true});   // work at the end of the same frame
//         double x = actor["RelativeLocation"]["X"].get<double>();
//         frame.execute();
//     }
//
// What happens when:
// - Opening a block sends nothing and holds nothing (G4). Operations are recorded.
// - A block of asynchronous and fire-and-forget operations only is one message, sent by execute(), which does not wait
// (G5).
// - The first synchronous operation, or get() of a future recorded in this block, sends what is recorded and waits;
// from then on the
//   game thread is held until the block closes, and each further synchronous operation is one round trip.
// - execute() sends the rest. It waits only if the game thread is held and fire-and-forget operations are still
// unanswered.
// - After begin work ran, the engine's frame goes on and waits at its end for the end block.
//
// When fire-and-forget operations fail, the first failure is raised (its message counts the others) by the first of:
// execute() of the block, if it is known by then; execute() of the end block of the transaction; the next
// begin_frame(); Instance::flush(). If execute() of a *begin* block raises, the transaction has been closed with an
// empty end block: go on with begin_frame.

#include <memory>

#include "spear/session.hpp"

namespace spear {

/// How an end_frame block ends.
struct EndFrameOptions {
    /// The engine advances to the beginning of the next frame and waits there for the next transaction (G2). Until then
    /// the world stands still for everybody; other clients wait (HeldByClient).
    bool single_step = false;
};

/// Movable, belongs to the thread that opened it.
class [[nodiscard("the block closes at once")]] Frame {
public:
    Frame(std::shared_ptr<Session> session, BlockKind kind, EndFrameOptions options = {})
        : session_(std::move(session)), kind_(kind), options_(options) {
        session_->open_block(kind_);
    }
    Frame(Frame&& other) noexcept : session_(std::move(other.session_)), kind_(other.kind_), options_(other.options_) {}
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
    Frame& operator=(Frame&&) = delete;

    /// A block left without execute(), by an exception or by forgetting: submits what was recorded, closes the whole
    /// transaction with an empty end block, logs failures. Never throws.
    ~Frame() {
        if (session_) {
            session_->abandon_transaction();
        }
    }

    /// Closes the block. Raises FrameMisuse if it is closed already, WrongThread, the known fire-and-forget failures,
    /// and what waits raise; the block is closed in any case.
    void execute();

    bool is_open() const noexcept { return session_ != nullptr; }
    BlockKind kind() const noexcept { return kind_; }

private:
    std::shared_ptr<Session> session_; // null once closed
    BlockKind kind_;
    EndFrameOptions options_;
};

} // namespace spear
