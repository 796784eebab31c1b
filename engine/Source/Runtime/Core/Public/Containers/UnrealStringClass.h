// SPDX-License-Identifier: MIT
/**
 * FString: a resizable string of TCHAR.
 * `==` and the other operators compare without case; Equals and Compare default to case. See Epic's "String Handling".
 */
#pragma once

#include "Containers/ArrayView.h"
#include "Containers/Map.h"
#include "Containers/StringConv.h"
#include "Containers/StringView.h"
#include "Misc/Crc.h"

struct FStringFormatArg;
typedef TMap<FString, FStringFormatArg> FStringFormatNamedArguments;
typedef TArray<FStringFormatArg> FStringFormatOrderedArguments;

class FString {
public:
    using AllocatorType = FDefaultAllocator;
    using ElementType = TCHAR;

    FString() = default;
    FString(const FString&) = default;
    FString(FString&&) = default;
    FString& operator=(const FString&) = default;
    FString& operator=(FString&&) = default;
    FString(const TCHAR* Str) { Append(FStringView(Str)); }
    FString(const ANSICHAR* Str) { AppendConverted(Str, Str ? TCString<ANSICHAR>::Strlen(Str) : 0); }
    FString(const UTF8CHAR* Str) { AppendConverted(Str, Str ? TCString<UTF8CHAR>::Strlen(Str) : 0); }
    FString(const WIDECHAR* Str) { AppendConverted(Str, Str ? TCString<WIDECHAR>::Strlen(Str) : 0); }
    explicit FString(FStringView View) { Append(View); }
    explicit FString(FAnsiStringView View) { AppendConverted(View.GetData(), View.Len()); }
    explicit FString(FUtf8StringView View) { AppendConverted(View.GetData(), View.Len()); }
    explicit FString(const FStringBuilderBase& Builder);
    FString(FStringView View, int32 ExtraSlack) {
        Reserve(View.Len() + ExtraSlack);
        Append(View);
    }
    /** Of Size characters, of whatever encoding the character type tells. */
    template <typename CharType>
    static FString ConstructFromPtrSize(const CharType* Ptr, int32 Size) {
        FString Result;
        Result.AppendConverted(Ptr, Size);
        return Result;
    }
    static FString ConstructWithSlack(const TCHAR* Ptr, int32 ExtraSlack) {
        return FString(FStringView(Ptr), ExtraSlack);
    }

    FString& operator=(const TCHAR* Str) {
        FString Copy(Str);
        return *this = MoveTemp(Copy);
    }
    FString& operator=(FStringView View) {
        FString Copy(View);
        return *this = MoveTemp(Copy);
    }

    // ----- access

    TCHAR& operator[](int32 Index) {
        checkf(
            IsValidIndex(Index), TEXT("String index out of bounds: index %d of a string of length %d"), Index, Len());
        return Data.GetData()[Index];
    }
    const TCHAR& operator[](int32 Index) const {
        checkf(
            IsValidIndex(Index), TEXT("String index out of bounds: index %d of a string of length %d"), Index, Len());
        return Data.GetData()[Index];
    }
    /** The characters, terminated; never null. */
    const TCHAR* operator*() const { return Data.Num() ? Data.GetData() : TEXT(""); }
    /** The array with the terminator (empty for the empty string). */
    TArray<TCHAR>& GetCharArray() { return Data; }
    const TArray<TCHAR>& GetCharArray() const { return Data; }
    const TCHAR* GetData() const { return **this; }
    int32 Len() const { return Data.Num() ? Data.Num() - 1 : 0; }
    bool IsEmpty() const { return Data.Num() <= 1; }
    bool IsValidIndex(int32 Index) const { return Index >= 0 && Index < Len(); }
    SIZE_T GetAllocatedSize() const { return Data.GetAllocatedSize(); }
    void Empty(int32 Slack = 0) { Data.Empty(Slack ? Slack + 1 : 0); }
    void Reset(int32 NewReservedSize = 0) { Data.Reset(NewReservedSize ? NewReservedSize + 1 : 0); }
    void Reserve(int32 CharacterCount) { Data.Reserve(CharacterCount + 1); }
    void Shrink() { Data.Shrink(); }
    const TCHAR* begin() const { return **this; }
    const TCHAR* end() const { return **this + Len(); }
    TCHAR* begin() { return Data.GetData(); }
    TCHAR* end() { return Data.GetData() + Len(); }

    // ----- appending

    FString& AppendChar(TCHAR InChar) { return Append(FStringView(&InChar, 1)); }
    CORE_API FString& AppendChars(const TCHAR* Str, int32 Count);
    FString& Append(const TCHAR* Str, int32 Count) { return AppendChars(Str, Count); }
    FString& Append(FStringView Str) { return AppendChars(Str.GetData(), Str.Len()); }
    FString& Append(const FString& Str) { return AppendChars(*Str, Str.Len()); }
    FString& Append(const TCHAR* Str) { return Append(FStringView(Str)); }
    FString& Append(const ANSICHAR* Str) { return Append(FString(Str)); }
    CORE_API void AppendInt(int32 Num);
    FString& operator+=(TCHAR Char) { return AppendChar(Char); }
    FString& operator+=(ANSICHAR Char) { return AppendChar(static_cast<TCHAR>(Char)); }
    FString& operator+=(const TCHAR* Str) { return Append(Str); }
    FString& operator+=(const ANSICHAR* Str) { return Append(Str); }
    FString& operator+=(const FString& Str) { return Append(Str); }
    FString& operator+=(FStringView Str) { return Append(Str); }
    CORE_API void PathAppend(const TCHAR* Str, int32 StrLength);
    FString& operator/=(FStringView Str) {
        PathAppend(Str.GetData(), Str.Len());
        return *this;
    }
    CORE_API void InsertAt(int32 Index, TCHAR Character);
    CORE_API void InsertAt(int32 Index, const FString& Characters);
    CORE_API void RemoveAt(int32 Index, int32 Count = 1, EAllowShrinking AllowShrinking = EAllowShrinking::Yes);
    bool RemoveFromStart(FStringView InPrefix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) {
        if (!InPrefix.IsEmpty() && StartsWith(InPrefix, SearchCase)) {
            RemoveAt(0, InPrefix.Len());
            return true;
        }
        return false;
    }
    bool RemoveFromEnd(FStringView InSuffix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) {
        if (!InSuffix.IsEmpty() && EndsWith(InSuffix, SearchCase)) {
            RemoveAt(Len() - InSuffix.Len(), InSuffix.Len());
            return true;
        }
        return false;
    }

    // ----- comparing and searching

    int32 Compare(FStringView Other, ESearchCase::Type SearchCase = ESearchCase::CaseSensitive) const {
        return View().Compare(Other, SearchCase);
    }
    bool Equals(FStringView Other, ESearchCase::Type SearchCase = ESearchCase::CaseSensitive) const {
        return View().Equals(Other, SearchCase);
    }
    bool StartsWith(FStringView InPrefix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const {
        return View().StartsWith(InPrefix, SearchCase);
    }
    bool EndsWith(FStringView InSuffix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const {
        return View().EndsWith(InSuffix, SearchCase);
    }
    bool Contains(FStringView SubStr, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase,
        ESearchDir::Type SearchDir = ESearchDir::FromStart) const {
        return Find(SubStr, SearchCase, SearchDir) != INDEX_NONE;
    }
    int32 Find(FStringView SubStr, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase,
        ESearchDir::Type SearchDir = ESearchDir::FromStart, int32 StartPosition = INDEX_NONE) const {
        return SearchDir == ESearchDir::FromStart
                   ? View().Find(SubStr, StartPosition == INDEX_NONE ? 0 : StartPosition, SearchCase)
                   : View().FindFromEnd(SubStr, StartPosition, SearchCase);
    }
    bool FindChar(TCHAR InChar, int32& Index) const { return View().FindChar(InChar, Index); }
    bool FindLastChar(TCHAR InChar, int32& Index) const { return View().FindLastChar(InChar, Index); }
    template <typename Predicate>
    int32 FindLastCharByPredicate(Predicate Pred) const {
        for (int32 Index = Len() - 1; Index >= 0; --Index) {
            if (::Invoke(Pred, (*this)[Index])) {
                return Index;
            }
        }
        return INDEX_NONE;
    }
    /** `*` and `?` as in file names. */
    CORE_API bool MatchesWildcard(FStringView Wildcard, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const;
    bool IsNumeric() const { return !IsEmpty() && FCString::IsNumeric(**this); }
    bool ToBool() const { return FCString::ToBool(**this); }

    // ----- parts

    FString Left(int32 Count) const { return FString(View().Left(Count)); }
    FString LeftChop(int32 Count) const { return FString(View().LeftChop(Count)); }
    FString Right(int32 Count) const { return FString(View().Right(Count)); }
    FString RightChop(int32 Count) const { return FString(View().RightChop(Count)); }
    FString Mid(int32 Start, int32 Count = MAX_int32) const { return FString(View().Mid(Start, Count)); }
    void LeftInline(int32 Count, EAllowShrinking = EAllowShrinking::Default) { *this = Left(Count); }
    void LeftChopInline(int32 Count, EAllowShrinking = EAllowShrinking::Default) { *this = LeftChop(Count); }
    void RightInline(int32 Count, EAllowShrinking = EAllowShrinking::Default) { *this = Right(Count); }
    void RightChopInline(int32 Count, EAllowShrinking = EAllowShrinking::Default) { *this = RightChop(Count); }
    void MidInline(int32 Start, int32 Count = MAX_int32, EAllowShrinking = EAllowShrinking::Default) {
        *this = Mid(Start, Count);
    }
    /** Splits at the first (or last) place of InS; either part may be null. False if it is not there. */
    CORE_API bool Split(const FString& InS, FString* LeftS, FString* RightS,
        ESearchCase::Type SearchCase = ESearchCase::IgnoreCase,
        ESearchDir::Type SearchDir = ESearchDir::FromStart) const;
    /** Splits at every delimiter; returns the number of parts. */
    CORE_API int32 ParseIntoArray(TArray<FString>& OutArray, const TCHAR* pchDelim, bool InCullEmpty = true) const;
    CORE_API int32 ParseIntoArray(
        TArray<FString>& OutArray, const TCHAR* const* DelimArray, int32 NumDelims, bool InCullEmpty = true) const;
    CORE_API int32 ParseIntoArrayWS(
        TArray<FString>& OutArray, const TCHAR* pchExtraDelim = nullptr, bool InCullEmpty = true) const;
    CORE_API int32 ParseIntoArrayLines(TArray<FString>& OutArray, bool InCullEmpty = true) const;

    // ----- changed copies, and the same in place

    FString ToUpper() const {
        FString Result(*this);
        Result.ToUpperInline();
        return Result;
    }
    FString ToLower() const {
        FString Result(*this);
        Result.ToLowerInline();
        return Result;
    }
    CORE_API void ToUpperInline();
    CORE_API void ToLowerInline();
    FString TrimStart() const { return FString(View().TrimStart()); }
    FString TrimEnd() const { return FString(View().TrimEnd()); }
    FString TrimStartAndEnd() const { return FString(View().TrimStartAndEnd()); }
    void TrimStartInline() { *this = TrimStart(); }
    void TrimEndInline() { *this = TrimEnd(); }
    void TrimStartAndEndInline() { *this = TrimStartAndEnd(); }
    CORE_API FString TrimQuotes(bool* bQuotesRemoved = nullptr) const;
    CORE_API FString TrimChar(TCHAR CharacterToTrim, bool* bCharRemoved = nullptr) const;
    CORE_API FString LeftPad(int32 ChCount) const;
    CORE_API FString RightPad(int32 ChCount) const;
    CORE_API FString Reverse() const;
    void ReverseString() { *this = Reverse(); }
    FString Replace(const TCHAR* From, const TCHAR* To, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const {
        FString Result(*this);
        Result.ReplaceInline(From, To, SearchCase);
        return Result;
    }
    /** Returns the number of replacements. */
    CORE_API int32 ReplaceInline(
        const TCHAR* SearchText, const TCHAR* ReplacementText, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);
    CORE_API void ReplaceCharInline(
        TCHAR SearchChar, TCHAR ReplacementChar, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);
    FString ReplaceQuotesWithEscapedQuotes() const { return Replace(TEXT("\""), TEXT("\\\"")); }
    CORE_API FString ReplaceCharWithEscapedChar() const;
    CORE_API FString ReplaceEscapedCharWithChar() const;
    CORE_API void RemoveSpacesInline();

    // ----- making

    /** printf. Strings are passed as `*Str` (TCHAR) with %s; %hs takes ANSICHAR. */
    template <typename FmtType, typename... Types>
    [[nodiscard]] static FString Printf(const FmtType& Fmt, Types... Args) {
        static_assert(std::is_convertible_v<const FmtType&, const TCHAR*>, "Formatting string must be a TCHAR array.");
        static_assert((UE::Core::Private::TIsPrintfArgument<Types> && ...),
            "Invalid argument(s) passed to FString::Printf; pass strings as *Str");
        return PrintfImpl(Fmt, Args...);
    }
    template <typename FmtType, typename... Types>
    FString& Appendf(const FmtType& Fmt, Types... Args) {
        return Append(Printf(Fmt, Args...));
    }
    static CORE_API FString PrintfVa(const TCHAR* Fmt, va_list Args);
    /** Replaces {Name} and {0}. */
    [[nodiscard]] static CORE_API FString Format(
        const TCHAR* InFormatString, const FStringFormatNamedArguments& InNamedArguments);
    [[nodiscard]] static CORE_API FString Format(
        const TCHAR* InFormatString, const FStringFormatOrderedArguments& InOrderedArguments);
    [[nodiscard]] static FString Chr(TCHAR Ch) { return FString(FStringView(&Ch, 1)); }
    [[nodiscard]] static CORE_API FString ChrN(int32 NumCharacters, TCHAR Char);
    [[nodiscard]] static CORE_API FString FromInt(int32 Num);
    [[nodiscard]] static CORE_API FString FormatAsNumber(int32 InNumber);
    /** Shortest plain form: no trailing zeros, at least InMinFractionalDigits of them ("1.0"). */
    [[nodiscard]] static CORE_API FString SanitizeFloat(double InFloat, int32 InMinFractionalDigits = 1);
    template <typename RangeType>
    [[nodiscard]] static FString Join(const RangeType& Range, const TCHAR* Separator) {
        return JoinBy(Range, Separator, [](const auto& Element) -> const auto& { return Element; });
    }
    template <typename RangeType, typename ProjectionType>
    [[nodiscard]] static FString JoinBy(const RangeType& Range, const TCHAR* Separator, ProjectionType Projection) {
        FString Result;
        bool bFirst = true;
        for (auto&& Element : Range) {
            if (!bFirst) {
                Result += Separator;
            }
            bFirst = false;
            Result += ::Invoke(Projection, Element);
        }
        return Result;
    }

    friend FString operator+(const FString& Lhs, const FString& Rhs) { return Joined(Lhs, Rhs); }
    friend FString operator+(const FString& Lhs, const TCHAR* Rhs) { return Joined(Lhs, Rhs); }
    friend FString operator+(const TCHAR* Lhs, const FString& Rhs) { return Joined(Lhs, Rhs); }
    friend FString operator+(const FString& Lhs, FStringView Rhs) { return Joined(Lhs, Rhs); }
    friend FString operator+(FStringView Lhs, const FString& Rhs) { return Joined(Lhs, Rhs); }
    friend FString operator+(const FString& Lhs, TCHAR Rhs) { return Joined(Lhs, FStringView(&Rhs, 1)); }
    friend FString operator+(TCHAR Lhs, const FString& Rhs) { return Joined(FStringView(&Lhs, 1), Rhs); }
    friend FString operator+(FString&& Lhs, const FString& Rhs) { return MoveTemp(Lhs.Append(Rhs)); }
    friend FString operator+(FString&& Lhs, const TCHAR* Rhs) { return MoveTemp(Lhs.Append(Rhs)); }
    friend FString operator+(FString&& Lhs, FStringView Rhs) { return MoveTemp(Lhs.Append(Rhs)); }
    friend FString operator+(FString&& Lhs, TCHAR Rhs) { return MoveTemp(Lhs.AppendChar(Rhs)); }
    /** Joins paths with exactly one separator. */
    friend FString operator/(const FString& Lhs, const FString& Rhs) {
        FString Result(Lhs);
        Result.PathAppend(*Rhs, Rhs.Len());
        return Result;
    }
    friend FString operator/(const FString& Lhs, const TCHAR* Rhs) { return Lhs / FString(Rhs); }
    friend FString operator/(const TCHAR* Lhs, const FString& Rhs) { return FString(Lhs) / Rhs; }

    friend bool operator==(const FString& Lhs, const FString& Rhs) { return Lhs.Equals(Rhs, ESearchCase::IgnoreCase); }
    friend bool operator==(const FString& Lhs, const TCHAR* Rhs) { return Lhs.Equals(Rhs, ESearchCase::IgnoreCase); }
    friend bool operator==(const FString& Lhs, FStringView Rhs) { return Lhs.Equals(Rhs, ESearchCase::IgnoreCase); }
    friend bool operator<(const FString& Lhs, const FString& Rhs) {
        return Lhs.Compare(Rhs, ESearchCase::IgnoreCase) < 0;
    }
    friend bool operator<(const FString& Lhs, const TCHAR* Rhs) {
        return Lhs.Compare(Rhs, ESearchCase::IgnoreCase) < 0;
    }
    friend bool operator<=(const FString& Lhs, const FString& Rhs) {
        return Lhs.Compare(Rhs, ESearchCase::IgnoreCase) <= 0;
    }
    friend bool operator>(const FString& Lhs, const FString& Rhs) {
        return Lhs.Compare(Rhs, ESearchCase::IgnoreCase) > 0;
    }
    friend bool operator>(const FString& Lhs, const TCHAR* Rhs) {
        return Lhs.Compare(Rhs, ESearchCase::IgnoreCase) > 0;
    }
    friend bool operator>=(const FString& Lhs, const FString& Rhs) {
        return Lhs.Compare(Rhs, ESearchCase::IgnoreCase) >= 0;
    }
    friend uint32 GetTypeHash(const FString& S) { return GetTypeHash(S.View()); }

private:
    FStringView View() const { return FStringView(**this, Len()); }
    static CORE_API FString PrintfImpl(const TCHAR* Fmt, ...);
    static FString Joined(FStringView Lhs, FStringView Rhs) {
        FString Result;
        Result.Reserve(Lhs.Len() + Rhs.Len());
        Result.Append(Lhs);
        Result.Append(Rhs);
        return Result;
    }
    template <typename CharType>
    void AppendConverted(const CharType* Ptr, int32 Size) {
        if (Size > 0) {
            if (Data.Num()) {
                Data.Pop(EAllowShrinking::No);
            }
            UE::Core::Private::ConvertString<TCHAR>(Ptr, Size, Data);
            Data.Add(TCHAR(0));
        }
    }

    TArray<TCHAR> Data;
};
static_assert(sizeof(FString) == sizeof(TArray<TCHAR>));

template <>
struct TIsContiguousContainer<FString> : UE::Core::Private::TBoolTrait<true> {};
inline int32 GetNum(const FString& String) { return String.Len(); }

/** A value for FString::Format. */
struct FStringFormatArg {
    enum EType { Int, UInt, Double, String, StringLiteral };
    FStringFormatArg(int32 Value) : Text(FString::Printf(TEXT("%d"), Value)) {}
    FStringFormatArg(uint32 Value) : Text(FString::Printf(TEXT("%u"), Value)) {}
    FStringFormatArg(int64 Value) : Text(FString::Printf(TEXT("%lld"), Value)) {}
    FStringFormatArg(uint64 Value) : Text(FString::Printf(TEXT("%llu"), Value)) {}
    FStringFormatArg(float Value) : Text(FString::Printf(TEXT("%f"), static_cast<double>(Value))) {}
    FStringFormatArg(double Value) : Text(FString::Printf(TEXT("%f"), Value)) {}
    FStringFormatArg(FString Value) : Text(MoveTemp(Value)) {}
    FStringFormatArg(FStringView Value) : Text(Value) {}
    FStringFormatArg(const TCHAR* Value) : Text(Value) {}
    FStringFormatArg(const ANSICHAR* Value) : Text(Value) {}
    /** The text that stands for the value. */
    FString Text;
};

/** Hexadecimal text of bytes, and back (returns the count of bytes). */
CORE_API FString BytesToHex(const uint8* Bytes, int32 NumBytes);
CORE_API int32 HexToBytes(const FString& HexString, uint8* OutBytes);
