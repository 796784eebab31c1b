// SPDX-License-Identifier: MIT
#pragma once

#include "CoreTypes.h"

namespace EAxis {
/** A coordinate axis. */
enum Type { None, X, Y, Z };
} // namespace EAxis
namespace EAxisList {
/** A set of axes. */
enum Type { None = 0, X = 1, Y = 2, Z = 4, XY = X | Y, XZ = X | Z, YZ = Y | Z, XYZ = X | Y | Z, All = XYZ };
} // namespace EAxisList
