// SPDX-License-Identifier: MIT
#include "hash.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace spear::header_tool {

namespace {

constexpr std::uint64_t c1 = 0x87c37b91114253d5ull, c2 = 0x4cf5ad432745937full;

std::uint64_t finish(std::uint64_t k) {
    k ^= k >> 33;
    k *= 0xff51afd7ed558ccdull;
    k ^= k >> 33;
    k *= 0xc4ceb9fe1a85ec53ull;
    return k ^ (k >> 33);
}

std::uint64_t mix_low(std::uint64_t k) { return std::rotl(k * c1, 31) * c2; }
std::uint64_t mix_high(std::uint64_t k) { return std::rotl(k * c2, 33) * c1; }

} // namespace

std::string Hash::text() const { return fmt::format("{:016x}{:016x}", high, low); }

Hash hash_bytes(std::string_view bytes, std::uint64_t seed) {
    std::uint64_t h1 = seed, h2 = seed;
    std::size_t blocks = bytes.size() / 16;
    for (std::size_t i = 0; i < blocks; ++i) {
        std::uint64_t k[2];
        std::memcpy(k, bytes.data() + i * 16, 16);
        h1 = (std::rotl(h1 ^ mix_low(k[0]), 27) + h2) * 5 + 0x52dce729;
        h2 = (std::rotl(h2 ^ mix_high(k[1]), 31) + h1) * 5 + 0x38495ab5;
    }
    std::uint64_t k[2] = {0, 0};
    std::memcpy(k, bytes.data() + blocks * 16, bytes.size() - blocks * 16);
    h1 ^= mix_low(k[0]);
    h2 ^= mix_high(k[1]);
    h1 ^= bytes.size();
    h2 ^= bytes.size();
    h1 += h2;
    h2 += h1;
    h1 = finish(h1);
    h2 = finish(h2);
    h1 += h2;
    h2 += h1;
    return {h1, h2};
}

Hasher& Hasher::add(std::string_view field) {
    add(static_cast<std::uint64_t>(field.size()));
    fields_.append(field);
    return *this;
}

Hasher& Hasher::add(std::uint64_t number) {
    fields_.append(reinterpret_cast<const char*>(&number), sizeof number);
    return *this;
}

} // namespace spear::header_tool
