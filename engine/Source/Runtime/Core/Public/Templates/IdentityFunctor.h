// SPDX-License-Identifier: MIT
#pragma once

#include "Templates/Invoke.h"
