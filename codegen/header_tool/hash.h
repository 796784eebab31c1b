// SPDX-License-Identifier: MIT
// A 128-bit hash of bytes: names of cache entries, and their check sums. Not for secrets.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace spear::header_tool {

struct Hash {
    std::uint64_t low = 0, high = 0;
    bool operator==(const Hash&) const = default;
    // 32 hexadecimal digits.
    std::string text() const;
};

// MurmurHash3 (x64, 128 bits).
Hash hash_bytes(std::string_view bytes, std::uint64_t seed = 0);

// Feeds several fields into one hash; each field's length counts, so that "ab","c" and "a","bc" differ.
class Hasher {
public:
    Hasher& add(std::string_view field);
    Hasher& add(std::uint64_t number);
    Hash hash() const { return hash_bytes(fields_); }

private:
    std::string fields_;
};

} // namespace spear::header_tool
