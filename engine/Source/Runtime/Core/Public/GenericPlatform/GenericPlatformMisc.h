// SPDX-License-Identifier: MIT
#pragma once

#include "HAL/PlatformMisc.h"
