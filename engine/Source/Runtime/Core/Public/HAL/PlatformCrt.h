// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdarg>
#include <cstring>
