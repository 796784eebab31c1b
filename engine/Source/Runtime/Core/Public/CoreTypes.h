// SPDX-License-Identifier: MIT
/** Basic types, build switches and the macros everything else needs. */
#pragma once

#include "HAL/Platform.h"
#include "Misc/Build.h"
#include "Misc/CoreMiscDefines.h"
#include "Math/NumericLimits.h"
#include "Misc/AssertionMacros.h"
