// SPDX-License-Identifier: MIT
/** FParse: values, switches and words of a command line or other text. Keys match without case. */
#pragma once

#include "UObject/NameTypes.h"

class FOutputDevice;
struct FGuid;

struct FParse {
    /** The value after Match (which ends with '=', as in "Name="), at a word's beginning; quoted values may have
     * blanks. */
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, FString& Value,
        bool bShouldStopOnSeparator = true, const TCHAR** OptStreamGotTo = nullptr);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, TCHAR* Value, int32 MaxLen,
        bool bShouldStopOnSeparator = true, const TCHAR** OptStreamGotTo = nullptr);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, FName& Name);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, FText& Text, const TCHAR* Namespace = nullptr);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, FGuid& Guid);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, uint8& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, int8& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, uint16& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, int16& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, uint32& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, int32& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, uint64& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, int64& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, float& Value);
    static CORE_API bool Value(const TCHAR* Stream, const TCHAR* Match, double& Value);
    static CORE_API bool Bool(const TCHAR* Stream, const TCHAR* Match, bool& OnOff);
    /** Is there a word -Param or /Param? */
    static CORE_API bool Param(const TCHAR* Stream, const TCHAR* Param);
    /** Takes the word Match from the front, if it is there. */
    static CORE_API bool Command(const TCHAR** Stream, const TCHAR* Match, bool bParseMightTriggerExecution = true);
    /** Takes the next word; quotes keep blanks together. */
    static CORE_API bool Token(const TCHAR*& Str, FString& Arg, bool UseEscape);
    static CORE_API bool Token(const TCHAR*& Str, TCHAR* Result, int32 MaxLen, bool UseEscape);
    static CORE_API FString Token(const TCHAR*& Str, bool UseEscape);
    static CORE_API bool AlphaToken(const TCHAR*& Str, FString& Arg);
    /** The next line, without its end. */
    static CORE_API bool Line(const TCHAR** Stream, FString& Result, bool Exact = false);
    /** Skips blanks, line ends and comments (`;`). */
    static CORE_API void Next(const TCHAR** Stream);
    static CORE_API uint32 HexNumber(const TCHAR* HexString);
    static CORE_API uint64 HexNumber64(const TCHAR* HexString);
    static int32 HexDigit(TCHAR C) { return FChar::IsHexDigit(C) ? FChar::HexValue(C) : 0; }
    static CORE_API bool QuotedString(const TCHAR* Stream, FString& Value, int32* OutNumCharsRead = nullptr);
};
