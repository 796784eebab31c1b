// SPDX-License-Identifier: MIT
/** The trait lives with its siblings in Templates/UnrealTypeTraits.h. */
#pragma once

#include "Templates/UnrealTypeTraits.h"
