// SPDX-License-Identifier: MIT
#pragma once

#include "HAL/PlatformTime.h"
