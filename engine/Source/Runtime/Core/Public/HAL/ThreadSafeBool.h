// SPDX-License-Identifier: MIT
#pragma once

#include "HAL/ThreadSafeCounter.h"
