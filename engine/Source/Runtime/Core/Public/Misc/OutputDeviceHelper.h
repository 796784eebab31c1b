// SPDX-License-Identifier: MIT
/** Puts log lines together: `[date][frame]Category: Verbosity: text`. */
#pragma once

#include "Misc/OutputDevice.h"

struct FOutputDeviceHelper {
    static const TCHAR* VerbosityToString(ELogVerbosity::Type Verbosity) { return ToString(Verbosity); }
    /** With the current time and frame number, unless bWithPrefix is false. */
    static CORE_API FString FormatLogLine(
        ELogVerbosity::Type Verbosity, const FName& Category, const TCHAR* Message, bool bWithPrefix = true);
};
