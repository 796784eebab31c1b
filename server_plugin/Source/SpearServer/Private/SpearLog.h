// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

/// Everything this plugin says in the engine's log.
DECLARE_LOG_CATEGORY_EXTERN(LogSpear, Log, All);
