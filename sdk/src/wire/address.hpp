// SPDX-License-Identifier: MIT
#pragma once

// Addresses: "unix:/path", "unix:@name" (abstract), "tcp://host:port", "tcp://[v6]:port". "unix:///path" and
// "tcp:host:port" are understood too.

#include <cstdint>
#include <string>
#include <string_view>

#include "spear/error_code.hpp"
#include "spear_wire.h"

namespace spear::wire {

struct Address {
    enum class Kind { unix_path, unix_abstract, tcp };
    Kind kind = Kind::unix_path;
    std::string path; ///< unix: path or abstract name
    std::string host; ///< tcp
    std::uint16_t port = 0;
    bool is_loopback = true; ///< tcp, after listen_at: no other machine can reach it

    std::string text() const;    ///< as the user writes it
    std::string kj_text() const; ///< as kj's network parses it
    bool is_local() const;       ///< Unix socket or loopback, by its text: no token needed
};

/// Fills a wire error, cutting the message to its buffer.
void fill_error(spear_wire_error* error, ErrorCode code, std::string_view message);

/// False, with the error filled, if the text is no address.
bool parse_address(std::string_view text, Address& address, spear_wire_error* error);

/// A socket bound to the address and listening (Unix: mode 0600; a dead socket file is replaced, a live one is not). -1
/// with the error filled on failure. Sets address.port to the real port.
int listen_at(Address& address, spear_wire_error* error);

} // namespace spear::wire
