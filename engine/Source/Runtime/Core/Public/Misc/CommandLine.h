// SPDX-License-Identifier: MIT
/** FCommandLine. */
#pragma once

#include "Containers/UnrealString.h"

struct FCommandLine {
    /** The arguments, without the program's name. Empty until Set. */
    static CORE_API const TCHAR* Get();
    static CORE_API const TCHAR* GetOriginal();
    static CORE_API bool IsInitialized();
    static CORE_API bool Set(const TCHAR* NewCommandLine);
    static CORE_API void Append(const TCHAR* AppendString);
    static CORE_API void Reset();
    /** One line of main's arguments; values with blanks are quoted. */
    static CORE_API FString BuildFromArgV(const TCHAR* Prefix, int32 ArgC, ANSICHAR* ArgV[], const TCHAR* Suffix);
    /** Splits into words and, of those, the ones with '-' in front. */
    static CORE_API void Parse(const TCHAR* CmdLine, TArray<FString>& Tokens, TArray<FString>& Switches);
};
