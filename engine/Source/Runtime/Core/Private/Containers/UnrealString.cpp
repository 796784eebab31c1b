// SPDX-License-Identifier: MIT
#include "Containers/UnrealString.h"

#include <algorithm>

FString& FString::AppendChars(const TCHAR* Str, int32 Count) {
    check(Count >= 0);
    if (Count == 0) {
        return *this;
    }
    check(Str);
    // The characters may be part of this string, which is about to move.
    const bool bInside = Data.Num() && Str >= Data.GetData() && Str < Data.GetData() + Data.Num();
    const int32 Offset = bInside ? static_cast<int32>(Str - Data.GetData()) : 0;
    const int32 OldLength = Len();
    Data.AddUninitialized(Data.Num() ? Count : Count + 1);
    const TCHAR* Source = bInside ? Data.GetData() + Offset : Str;
    FMemory::Memmove(Data.GetData() + OldLength, Source, static_cast<SIZE_T>(Count) * sizeof(TCHAR));
    Data.GetData()[OldLength + Count] = 0;
    return *this;
}

void FString::AppendInt(int32 Num) { Append(FromInt(Num)); }

void FString::PathAppend(const TCHAR* Str, int32 StrLength) {
    if (StrLength == 0) {
        if (!IsEmpty() && (*this)[Len() - 1] != TCHAR('/') && (*this)[Len() - 1] != TCHAR('\\')) {
            AppendChar(TCHAR('/'));
        }
        return;
    }
    if (!IsEmpty()) {
        const TCHAR Last = (*this)[Len() - 1];
        const bool bHasSeparator = Last == TCHAR('/') || Last == TCHAR('\\');
        const bool bStartsWithSeparator = *Str == TCHAR('/') || *Str == TCHAR('\\');
        if (bHasSeparator && bStartsWithSeparator) {
            ++Str;
            --StrLength;
        } else if (!bHasSeparator && !bStartsWithSeparator) {
            AppendChar(TCHAR('/'));
        }
    }
    AppendChars(Str, StrLength);
}

void FString::InsertAt(int32 Index, TCHAR Character) { InsertAt(Index, Chr(Character)); }

void FString::InsertAt(int32 Index, const FString& Characters) {
    check(Index >= 0 && Index <= Len());
    if (Characters.IsEmpty()) {
        return;
    }
    if (IsEmpty()) {
        *this = Characters;
    } else {
        const FString Copy(Characters);
        Data.Insert(*Copy, Copy.Len(), Index);
    }
}

void FString::RemoveAt(int32 Index, int32 Count, EAllowShrinking AllowShrinking) {
    Count = std::clamp(Count, 0, std::max(0, Len() - Index));
    if (Count > 0) {
        check(Index >= 0);
        Data.RemoveAt(Index, Count, AllowShrinking);
        if (Data.Num() == 1) {
            Data.Empty();
        }
    }
}

bool FString::MatchesWildcard(FStringView Wildcard, ESearchCase::Type SearchCase) const {
    const FStringView Text = View();
    int32 T = 0;
    int32 W = 0;
    int32 StarW = INDEX_NONE;
    int32 StarT = 0;
    // Greedy matching which goes back to the last star is linear enough, and needs no recursion.
    while (T < Text.Len()) {
        if (W < Wildcard.Len() && Wildcard[W] == TCHAR('*')) {
            StarW = W++;
            StarT = T;
        } else if (W < Wildcard.Len() &&
                   (Wildcard[W] == TCHAR('?') || Wildcard.Mid(W, 1).Equals(Text.Mid(T, 1), SearchCase))) {
            ++T;
            ++W;
        } else if (StarW != INDEX_NONE) {
            W = StarW + 1;
            T = ++StarT;
        } else {
            return false;
        }
    }
    while (W < Wildcard.Len() && Wildcard[W] == TCHAR('*')) {
        ++W;
    }
    return W == Wildcard.Len();
}

bool FString::Split(const FString& InS, FString* LeftS, FString* RightS, ESearchCase::Type SearchCase,
    ESearchDir::Type SearchDir) const {
    const int32 Place = Find(InS, SearchCase, SearchDir);
    if (Place == INDEX_NONE) {
        return false;
    }
    // The outputs may be this string or the separator.
    FString LeftPart = Left(Place);
    FString RightPart = Mid(Place + InS.Len());
    if (LeftS) {
        *LeftS = MoveTemp(LeftPart);
    }
    if (RightS) {
        *RightS = MoveTemp(RightPart);
    }
    return true;
}

int32 FString::ParseIntoArray(TArray<FString>& OutArray, const TCHAR* pchDelim, bool InCullEmpty) const {
    check(pchDelim);
    return ParseIntoArray(OutArray, &pchDelim, 1, InCullEmpty);
}

int32 FString::ParseIntoArray(
    TArray<FString>& OutArray, const TCHAR* const* DelimArray, int32 NumDelims, bool InCullEmpty) const {
    TArray<FString> Parts;
    const FStringView Text = View();
    int32 Start = 0;
    for (int32 Index = 0; Index < Text.Len();) {
        int32 DelimLength = 0;
        for (int32 Delim = 0; Delim < NumDelims && DelimLength == 0; ++Delim) {
            const FStringView Candidate(DelimArray[Delim]);
            if (!Candidate.IsEmpty() && Text.Mid(Index).StartsWith(Candidate, ESearchCase::CaseSensitive)) {
                DelimLength = Candidate.Len();
            }
        }
        if (DelimLength == 0) {
            ++Index;
            continue;
        }
        if (!InCullEmpty || Index > Start) {
            Parts.Emplace(Text.Mid(Start, Index - Start));
        }
        Index += DelimLength;
        Start = Index;
    }
    if (!InCullEmpty || Start < Text.Len()) {
        Parts.Emplace(Text.Mid(Start));
    }
    OutArray = MoveTemp(Parts);
    return OutArray.Num();
}

int32 FString::ParseIntoArrayWS(TArray<FString>& OutArray, const TCHAR* pchExtraDelim, bool InCullEmpty) const {
    const TCHAR* Delimiters[] = {TEXT(" "), TEXT("\t"), TEXT("\r"), TEXT("\n"), TEXT("")};
    int32 NumDelimiters = 4;
    if (pchExtraDelim && *pchExtraDelim) {
        Delimiters[NumDelimiters++] = pchExtraDelim;
    }
    return ParseIntoArray(OutArray, Delimiters, NumDelimiters, InCullEmpty);
}

int32 FString::ParseIntoArrayLines(TArray<FString>& OutArray, bool InCullEmpty) const {
    const TCHAR* LineEndings[] = {TEXT("\r\n"), TEXT("\r"), TEXT("\n")};
    return ParseIntoArray(OutArray, LineEndings, 3, InCullEmpty);
}

void FString::ToUpperInline() {
    for (TCHAR& Char : *this) {
        Char = FChar::ToUpper(Char);
    }
}

void FString::ToLowerInline() {
    for (TCHAR& Char : *this) {
        Char = FChar::ToLower(Char);
    }
}

FString FString::TrimChar(TCHAR CharacterToTrim, bool* bCharRemoved) const {
    const bool bFront = Len() > 0 && (*this)[0] == CharacterToTrim;
    const bool bBack = Len() > (bFront ? 1 : 0) && (*this)[Len() - 1] == CharacterToTrim;
    if (bCharRemoved) {
        *bCharRemoved = bFront || bBack;
    }
    return Mid(bFront ? 1 : 0, Len() - (bFront ? 1 : 0) - (bBack ? 1 : 0));
}

FString FString::TrimQuotes(bool* bQuotesRemoved) const { return TrimChar(TCHAR('"'), bQuotesRemoved); }

FString FString::LeftPad(int32 ChCount) const {
    return ChCount > Len() ? ChrN(ChCount - Len(), TCHAR(' ')) + *this : *this;
}

FString FString::RightPad(int32 ChCount) const {
    return ChCount > Len() ? *this + ChrN(ChCount - Len(), TCHAR(' ')) : *this;
}

FString FString::Reverse() const {
    FString Result(*this);
    std::reverse(Result.begin(), Result.end());
    return Result;
}

int32 FString::ReplaceInline(const TCHAR* SearchText, const TCHAR* ReplacementText, ESearchCase::Type SearchCase) {
    const FStringView Search(SearchText);
    if (IsEmpty() || Search.IsEmpty()) {
        return 0;
    }
    int32 Count = 0;
    FString Result;
    int32 Start = 0;
    for (int32 Place; (Place = View().Find(Search, Start, SearchCase)) != INDEX_NONE; Start = Place + Search.Len()) {
        Result.Append(View().Mid(Start, Place - Start));
        Result.Append(ReplacementText);
        ++Count;
    }
    if (Count) {
        Result.Append(View().Mid(Start));
        *this = MoveTemp(Result);
    }
    return Count;
}

void FString::ReplaceCharInline(TCHAR SearchChar, TCHAR ReplacementChar, ESearchCase::Type SearchCase) {
    for (TCHAR& Char : *this) {
        if (Char == SearchChar ||
            (SearchCase == ESearchCase::IgnoreCase && FChar::ToLower(Char) == FChar::ToLower(SearchChar))) {
            Char = ReplacementChar;
        }
    }
}

namespace {
struct FEscape {
    TCHAR Char;
    TCHAR Letter;
};
const FEscape Escapes[] = {{TCHAR('\n'), TCHAR('n')}, {TCHAR('\r'), TCHAR('r')}, {TCHAR('\t'), TCHAR('t')},
    {TCHAR('\''), TCHAR('\'')}, {TCHAR('\\'), TCHAR('\\')}, {TCHAR('"'), TCHAR('"')}};
} // namespace

FString FString::ReplaceCharWithEscapedChar() const {
    FString Result;
    for (const TCHAR Char : *this) {
        TCHAR Letter = 0;
        for (const FEscape& Escape : Escapes) {
            Letter = Escape.Char == Char ? Escape.Letter : Letter;
        }
        if (Letter) {
            Result.AppendChar(TCHAR('\\'));
        }
        Result.AppendChar(Letter ? Letter : Char);
    }
    return Result;
}

FString FString::ReplaceEscapedCharWithChar() const {
    FString Result;
    for (int32 Index = 0; Index < Len(); ++Index) {
        TCHAR Char = (*this)[Index];
        if (Char == TCHAR('\\') && Index + 1 < Len()) {
            for (const FEscape& Escape : Escapes) {
                if (Escape.Letter == (*this)[Index + 1]) {
                    Char = Escape.Char;
                    ++Index;
                    break;
                }
            }
        }
        Result.AppendChar(Char);
    }
    return Result;
}

void FString::RemoveSpacesInline() { ReplaceInline(TEXT(" "), TEXT("")); }

FString FString::Format(const TCHAR* InFormatString, const FStringFormatNamedArguments& InNamedArguments) {
    FString Result;
    for (const TCHAR* Cursor = InFormatString; *Cursor;) {
        if (*Cursor == TCHAR('`') && (Cursor[1] == TCHAR('{') || Cursor[1] == TCHAR('`'))) {
            Result.AppendChar(Cursor[1]);
            Cursor += 2;
            continue;
        }
        const TCHAR* End = *Cursor == TCHAR('{') ? FCString::Strchr(Cursor, TCHAR('}')) : nullptr;
        if (End) {
            const FString Name(FStringView(Cursor + 1, static_cast<int32>(End - Cursor - 1)).TrimStartAndEnd());
            if (const FStringFormatArg* Argument = InNamedArguments.Find(Name)) {
                Result.Append(Argument->Text);
                Cursor = End + 1;
                continue;
            }
        }
        // What names no argument stays as it is.
        Result.AppendChar(*Cursor++);
    }
    return Result;
}

FString FString::Format(const TCHAR* InFormatString, const FStringFormatOrderedArguments& InOrderedArguments) {
    FStringFormatNamedArguments Named;
    for (int32 Index = 0; Index < InOrderedArguments.Num(); ++Index) {
        Named.Add(FromInt(Index), InOrderedArguments[Index]);
    }
    return Format(InFormatString, Named);
}

FString FString::ChrN(int32 NumCharacters, TCHAR Char) {
    check(NumCharacters >= 0);
    FString Result;
    Result.Reserve(NumCharacters);
    for (int32 Index = 0; Index < NumCharacters; ++Index) {
        Result.AppendChar(Char);
    }
    return Result;
}

FString FString::FromInt(int32 Num) { return Printf(TEXT("%d"), Num); }

FString FString::FormatAsNumber(int32 InNumber) {
    FString Result = FromInt(InNumber);
    const int32 FirstDigit = InNumber < 0 ? 1 : 0;
    for (int32 Index = Result.Len() - 3; Index > FirstDigit; Index -= 3) {
        Result.InsertAt(Index, TCHAR(','));
    }
    return Result;
}

FString FString::SanitizeFloat(double InFloat, int32 InMinFractionalDigits) {
    if (InFloat == 0.0) {
        InFloat = 0.0; // no "-0"
    }
    FString Result = Printf(TEXT("%f"), InFloat);
    if (!Result.IsNumeric()) {
        return Result; // inf, nan
    }
    int32 Dot = INDEX_NONE;
    if (Result.FindChar(TCHAR('.'), Dot)) {
        int32 End = Result.Len();
        while (End > Dot + 1 && Result[End - 1] == TCHAR('0')) {
            --End;
        }
        Result.LeftInline(End == Dot + 1 ? Dot : End);
    }
    if (InMinFractionalDigits > 0) {
        if (!Result.FindChar(TCHAR('.'), Dot)) {
            Dot = Result.Len();
            Result.AppendChar(TCHAR('.'));
        }
        for (int32 Digits = Result.Len() - Dot - 1; Digits < InMinFractionalDigits; ++Digits) {
            Result.AppendChar(TCHAR('0'));
        }
    }
    return Result;
}

FString BytesToHex(const uint8* Bytes, int32 NumBytes) {
    FString Result;
    Result.Reserve(NumBytes * 2);
    const TCHAR* Digits = TEXT("0123456789ABCDEF");
    for (int32 Index = 0; Index < NumBytes; ++Index) {
        Result.AppendChar(Digits[Bytes[Index] >> 4]);
        Result.AppendChar(Digits[Bytes[Index] & 15]);
    }
    return Result;
}

int32 HexToBytes(const FString& HexString, uint8* OutBytes) {
    int32 NumBytes = 0;
    int32 Index = HexString.Len() & 1;
    if (Index) {
        OutBytes[NumBytes++] = static_cast<uint8>(FChar::HexValue(HexString[0]));
    }
    for (; Index + 1 < HexString.Len(); Index += 2) {
        OutBytes[NumBytes++] =
            static_cast<uint8>(FChar::HexValue(HexString[Index]) * 16 + FChar::HexValue(HexString[Index + 1]));
    }
    return NumBytes;
}
