// SPDX-License-Identifier: MIT
// FParse and FCommandLine. Mirrors Epic's API pages of these names.
#include "Misc/Parse.h"

#include "CoreMinimal.h"
#include "Misc/CommandLine.h"
#include "Misc/Guid.h"

namespace {

bool IsBlank(TCHAR Char) { return Char == TEXT(' ') || Char == TEXT('\t') || Char == TEXT('\r') || Char == TEXT('\n'); }

/** Where Match begins as a word (not inside another, not inside quotes); null if nowhere. */
const TCHAR* FindWord(const TCHAR* Stream, const TCHAR* Match) {
    const int32 Length = FCString::Strlen(Match);
    bool bQuoted = false;
    for (const TCHAR* At = Stream; At && *At; ++At) {
        const bool bStartsWord = At == Stream || (!FChar::IsAlnum(At[-1]) && At[-1] != TEXT('_'));
        if (!bQuoted && bStartsWord && FCString::Strnicmp(At, Match, static_cast<SIZE_T>(Length)) == 0) {
            return At;
        }
        if (*At == TEXT('"')) {
            bQuoted = !bQuoted;
        }
    }
    return nullptr;
}

template <typename NumberType>
bool IntegerValue(const TCHAR* Stream, const TCHAR* Match, NumberType& Value) {
    FString Text;
    if (!FParse::Value(Stream, Match, Text)) {
        return false;
    }
    if constexpr (std::is_signed_v<NumberType>) {
        Value = static_cast<NumberType>(FCString::Atoi64(*Text));
    } else {
        Value = static_cast<NumberType>(FCString::Strtoui64(*Text, nullptr, 10));
    }
    return true;
}

} // namespace

bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, FString& Value, bool bShouldStopOnSeparator,
    const TCHAR** OptStreamGotTo) {
    const TCHAR* At = FindWord(Stream, Match);
    if (!At) {
        return false;
    }
    At += FCString::Strlen(Match);
    Value.Reset();
    if (*At == TEXT('"')) {
        for (++At; *At && *At != TEXT('"'); ++At) {
            Value.AppendChar(*At);
        }
        At += *At ? 1 : 0;
    } else {
        for (; *At && !IsBlank(*At) && !(bShouldStopOnSeparator && (*At == TEXT(',') || *At == TEXT(')'))); ++At) {
            Value.AppendChar(*At);
        }
    }
    if (OptStreamGotTo) {
        *OptStreamGotTo = At;
    }
    return true;
}

bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, TCHAR* Value, int32 MaxLen, bool bShouldStopOnSeparator,
    const TCHAR** OptStreamGotTo) {
    FString Text;
    if (!FParse::Value(Stream, Match, Text, bShouldStopOnSeparator, OptStreamGotTo)) {
        return false;
    }
    FCString::Strncpy(Value, *Text, MaxLen);
    return true;
}

bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, FName& Name) {
    FString Text;
    if (!FParse::Value(Stream, Match, Text)) {
        return false;
    }
    Name = FName(*Text);
    return true;
}

bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, FText& Text, const TCHAR* Namespace) {
    FString String;
    if (!FParse::Value(Stream, Match, String)) {
        return false;
    }
    Text = FText::FromString(String);
    return true;
}

bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, FGuid& Guid) {
    FString Text;
    return FParse::Value(Stream, Match, Text) && FGuid::Parse(Text, Guid);
}

bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, uint8& Value) { return IntegerValue(Stream, Match, Value); }
bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, int8& Value) { return IntegerValue(Stream, Match, Value); }
bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, uint16& Value) {
    return IntegerValue(Stream, Match, Value);
}
bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, int16& Value) { return IntegerValue(Stream, Match, Value); }
bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, uint32& Value) {
    return IntegerValue(Stream, Match, Value);
}
bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, int32& Value) { return IntegerValue(Stream, Match, Value); }
bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, uint64& Value) {
    return IntegerValue(Stream, Match, Value);
}
bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, int64& Value) { return IntegerValue(Stream, Match, Value); }

bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, double& Value) {
    FString Text;
    if (!FParse::Value(Stream, Match, Text)) {
        return false;
    }
    Value = FCString::Atod(*Text);
    return true;
}
bool FParse::Value(const TCHAR* Stream, const TCHAR* Match, float& Value) {
    double Double = 0.0;
    if (!FParse::Value(Stream, Match, Double)) {
        return false;
    }
    Value = static_cast<float>(Double);
    return true;
}

bool FParse::Bool(const TCHAR* Stream, const TCHAR* Match, bool& OnOff) {
    FString Text;
    if (!FParse::Value(Stream, Match, Text)) {
        return false;
    }
    OnOff = Text.ToBool();
    return true;
}

bool FParse::Param(const TCHAR* Stream, const TCHAR* Param) {
    const int32 Length = FCString::Strlen(Param);
    bool bQuoted = false;
    for (const TCHAR* At = Stream; At && *At; ++At) {
        bQuoted ^= *At == TEXT('"');
        const bool bSwitch = (*At == TEXT('-') || *At == TEXT('/')) && (At == Stream || IsBlank(At[-1]));
        if (!bQuoted && bSwitch && FCString::Strnicmp(At + 1, Param, static_cast<SIZE_T>(Length)) == 0 &&
            (!At[1 + Length] || IsBlank(At[1 + Length]))) {
            return true;
        }
    }
    return false;
}

bool FParse::Command(const TCHAR** Stream, const TCHAR* Match, bool) {
    const TCHAR* At = *Stream;
    while (IsBlank(*At)) {
        ++At;
    }
    const int32 Length = FCString::Strlen(Match);
    if (FCString::Strnicmp(At, Match, static_cast<SIZE_T>(Length)) != 0 || FChar::IsAlnum(At[Length]) ||
        At[Length] == TEXT('_')) {
        return false;
    }
    At += Length;
    while (IsBlank(*At)) {
        ++At;
    }
    *Stream = At;
    return true;
}

bool FParse::Token(const TCHAR*& Str, FString& Arg, bool UseEscape) {
    Arg.Reset();
    while (IsBlank(*Str)) {
        ++Str;
    }
    if (!*Str) {
        return false;
    }
    bool bQuoted = false;
    for (; *Str && (bQuoted || !IsBlank(*Str)); ++Str) {
        if (UseEscape && *Str == TEXT('\\') && Str[1]) {
            Arg.AppendChar(*++Str);
        } else if (*Str == TEXT('"')) {
            bQuoted = !bQuoted;
        } else {
            Arg.AppendChar(*Str);
        }
    }
    return true;
}
bool FParse::Token(const TCHAR*& Str, TCHAR* Result, int32 MaxLen, bool UseEscape) {
    FString Arg;
    const bool bFound = Token(Str, Arg, UseEscape);
    FCString::Strncpy(Result, *Arg, MaxLen);
    return bFound;
}
FString FParse::Token(const TCHAR*& Str, bool UseEscape) {
    FString Arg;
    Token(Str, Arg, UseEscape);
    return Arg;
}

bool FParse::AlphaToken(const TCHAR*& Str, FString& Arg) {
    Arg.Reset();
    while (IsBlank(*Str)) {
        ++Str;
    }
    for (; FChar::IsAlpha(*Str) || (!Arg.IsEmpty() && (FChar::IsDigit(*Str) || *Str == TEXT('_'))); ++Str) {
        Arg.AppendChar(*Str);
    }
    return !Arg.IsEmpty();
}

bool FParse::Line(const TCHAR** Stream, FString& Result, bool) {
    Result.Reset();
    const TCHAR* At = *Stream;
    if (!*At) {
        return false;
    }
    for (; *At && *At != TEXT('\n'); ++At) {
        if (*At != TEXT('\r')) {
            Result.AppendChar(*At);
        }
    }
    *Stream = *At ? At + 1 : At;
    return true;
}

void FParse::Next(const TCHAR** Stream) {
    while (IsBlank(**Stream) || **Stream == TEXT(';')) {
        if (**Stream == TEXT(';')) {
            while (**Stream && **Stream != TEXT('\n')) {
                ++*Stream;
            }
        } else {
            ++*Stream;
        }
    }
}

uint64 FParse::HexNumber64(const TCHAR* HexString) {
    uint64 Result = 0;
    for (; FChar::IsHexDigit(*HexString); ++HexString) {
        Result = (Result << 4) | static_cast<uint64>(FChar::HexValue(*HexString));
    }
    return Result;
}
uint32 FParse::HexNumber(const TCHAR* HexString) { return static_cast<uint32>(HexNumber64(HexString)); }

bool FParse::QuotedString(const TCHAR* Stream, FString& Value, int32* OutNumCharsRead) {
    const TCHAR* At = Stream;
    if (*At != TEXT('"')) {
        return false;
    }
    Value.Reset();
    for (++At; *At != TEXT('"'); ++At) {
        if (!*At) {
            return false;
        }
        if (*At != TEXT('\\')) {
            Value.AppendChar(*At);
            continue;
        }
        switch (*++At) {
        case TEXT('n'):
            Value.AppendChar(TEXT('\n'));
            break;
        case TEXT('r'):
            Value.AppendChar(TEXT('\r'));
            break;
        case TEXT('t'):
            Value.AppendChar(TEXT('\t'));
            break;
        case 0:
            return false;
        default:
            Value.AppendChar(*At);
            break;
        }
    }
    if (OutNumCharsRead) {
        *OutNumCharsRead = static_cast<int32>(At + 1 - Stream);
    }
    return true;
}

// FCommandLine
// ------------------------------------------------------------------------------------------------------------------

namespace {

/** Set by main before other threads start; read by all. */
struct FCommandLineText {
    FString Current;
    FString Original;
    bool bSet = false;
};
FCommandLineText& GetCommandLineText() {
    static FCommandLineText Text;
    return Text;
}

} // namespace

const TCHAR* FCommandLine::Get() { return *GetCommandLineText().Current; }
const TCHAR* FCommandLine::GetOriginal() { return *GetCommandLineText().Original; }
bool FCommandLine::IsInitialized() { return GetCommandLineText().bSet; }
bool FCommandLine::Set(const TCHAR* NewCommandLine) {
    FCommandLineText& Text = GetCommandLineText();
    Text.Current = NewCommandLine;
    if (!Text.bSet) {
        Text.Original = NewCommandLine;
        Text.bSet = true;
    }
    return true;
}
void FCommandLine::Append(const TCHAR* AppendString) { GetCommandLineText().Current += AppendString; }
void FCommandLine::Reset() { GetCommandLineText() = FCommandLineText(); }

FString FCommandLine::BuildFromArgV(const TCHAR* Prefix, int32 ArgC, ANSICHAR* ArgV[], const TCHAR* Suffix) {
    FString Result;
    const auto Add = [&Result](const FString& Word) {
        Result += Result.IsEmpty() ? TEXT("") : TEXT(" ");
        Result += Word;
    };
    if (Prefix) {
        Add(Prefix);
    }
    for (int32 Index = 0; Index < ArgC; ++Index) {
        FString Word(UTF8_TO_TCHAR(ArgV[Index]));
        int32 Equals = INDEX_NONE;
        if (Word.Contains(TEXT(" ")) && !Word.Contains(TEXT("\""))) {
            // -Key=value with blanks becomes -Key="value with blanks".
            Word = Word.StartsWith(TEXT("-")) && Word.FindChar(TEXT('='), Equals)
                       ? Word.Left(Equals + 1) + TEXT("\"") + Word.Mid(Equals + 1) + TEXT("\"")
                       : TEXT("\"") + Word + TEXT("\"");
        }
        Add(Word);
    }
    if (Suffix) {
        Add(Suffix);
    }
    return Result;
}

void FCommandLine::Parse(const TCHAR* CmdLine, TArray<FString>& Tokens, TArray<FString>& Switches) {
    FString Word;
    while (FParse::Token(CmdLine, Word, false)) {
        if (Word.StartsWith(TEXT("-")) || Word.StartsWith(TEXT("/"))) {
            Switches.Add(Word.RightChop(1));
        }
        Tokens.Add(Word.StartsWith(TEXT("-")) ? Word.RightChop(1) : Word);
    }
}
