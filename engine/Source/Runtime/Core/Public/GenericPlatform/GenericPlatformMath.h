// SPDX-License-Identifier: MIT
#pragma once

#include "HAL/PlatformMath.h"
