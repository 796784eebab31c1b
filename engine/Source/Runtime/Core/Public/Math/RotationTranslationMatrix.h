// SPDX-License-Identifier: MIT
/** Lives with its siblings in Math/RotationMatrix.h. */
#pragma once

#include "Math/Matrix.h"
