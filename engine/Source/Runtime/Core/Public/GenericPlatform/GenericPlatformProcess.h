// SPDX-License-Identifier: MIT
#pragma once

#include "HAL/PlatformProcess.h"
