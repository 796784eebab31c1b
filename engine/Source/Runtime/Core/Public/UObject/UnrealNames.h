// SPDX-License-Identifier: MIT
/** EName: the names that have a fixed index. */
#pragma once

#include "CoreTypes.h"
#include "Templates/TypeHash.h"

/** Longest name, terminator included. */
enum { NAME_SIZE = 1024 };

enum class EName : uint32 { None = 0, MaxHardcodedNameIndex };
inline constexpr EName NAME_None = EName::None;
