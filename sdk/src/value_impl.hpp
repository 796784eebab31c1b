// SPDX-License-Identifier: MIT
#pragma once

// Shared by the files that implement Value.

#include "spear/value.hpp"

namespace spear::detail {

template <typename... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <typename... F>
Overloaded(F...) -> Overloaded<F...>;

/// Lists and numeric arrays, seen alike.
inline bool is_sequence(const Value& value) { return value.get_if<Value::List>() || value.get_if<NumericArray>(); }

} // namespace spear::detail
