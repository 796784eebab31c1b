// SPDX-License-Identifier: MIT
#pragma once

#include "CoreGlobals.h"
#include "Misc/Exec.h"
