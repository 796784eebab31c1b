// SPDX-License-Identifier: MIT
// Include path of UE; the class is declared with the other properties.
#pragma once

#include "UObject/UnrealType.h"
