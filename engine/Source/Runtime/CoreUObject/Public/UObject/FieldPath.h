// SPDX-License-Identifier: MIT
// Include path of UE.
#pragma once

#include "UObject/FieldPathProperty.h"
