// SPDX-License-Identifier: MIT
#include "spear/frame.hpp"

#include <fmt/format.h>

namespace spear {

void Frame::execute() {
    if (!session_) {
        throw_error(ErrorCode::FrameMisuse, fmt::format("execute() was called twice on a {} block.", block_name(kind_)),
            std::string(block_name(kind_)));
    }
    if (session_->open_block_of_this_thread() != kind_) { // another thread's: stays open for it
        session_->close_block(kind_, options_.single_step);
    }
    const std::shared_ptr<Session> session = std::move(session_); // closed in any case
    session->close_block(kind_, options_.single_step);
}

} // namespace spear
