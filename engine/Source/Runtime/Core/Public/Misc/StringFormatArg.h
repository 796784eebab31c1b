// SPDX-License-Identifier: MIT
#pragma once

#include "Containers/UnrealString.h"
