// SPDX-License-Identifier: MIT
#pragma once

#include "CoreTypes.h"

struct FGenericPlatformTLS {
    /** Id of the calling thread, as the operating system tells it. */
    static CORE_API uint32 GetCurrentThreadId();
};
typedef FGenericPlatformTLS FPlatformTLS;
