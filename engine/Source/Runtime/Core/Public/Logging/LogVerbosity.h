// SPDX-License-Identifier: MIT
/** How important a log line is. */
#pragma once

#include "CoreTypes.h"

namespace ELogVerbosity {
enum Type : uint8 {
    NoLogging = 0,
    /** Always printed, then the process aborts. */
    Fatal,
    Error,
    Warning,
    Display,
    Log,
    Verbose,
    VeryVerbose,
    All = VeryVerbose,
    NumVerbosity,
    VerbosityMask = 0xf,
    SetColor = 0x40,
    BreakOnLog = 0x80
};
} // namespace ELogVerbosity

/** "Warning" and so on. */
CORE_API const TCHAR* ToString(ELogVerbosity::Type Verbosity);
/** The other way round, without case; Log for unknown words. */
CORE_API ELogVerbosity::Type ParseLogVerbosityFromString(const class FString& VerbosityString);
