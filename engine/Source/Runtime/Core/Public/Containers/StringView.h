// SPDX-License-Identifier: MIT
/** FStringView: borrowed characters, not necessarily terminated. Operators compare without case, as FString's do. */
#pragma once

#include "Containers/ContainersFwd.h"
#include "Misc/CString.h"
#include "Misc/Crc.h"
#include "Templates/UnrealTemplate.h"

template <typename CharType>
class TStringView {
public:
    using ElementType = CharType;
    using ViewType = TStringView;

    constexpr TStringView() = default;
    constexpr TStringView(const CharType* InData) : DataPtr(InData), Size(0) {
        if (InData) {
            while (InData[Size]) {
                ++Size;
            }
        }
    }
    constexpr TStringView(const CharType* InData, int32 InSize) : DataPtr(InData), Size(InSize) {}
    /** Of FString and string builders: whatever has characters and a Len(). */
    template <typename RangeType>
        requires(!std::is_same_v<RangeType, TStringView> &&
                    requires(const RangeType& Range) {
                        { Range.GetData() } -> std::convertible_to<const CharType*>;
                        { Range.Len() } -> std::convertible_to<int32>;
                    })
    constexpr TStringView(const RangeType& Range) : DataPtr(Range.GetData()), Size(Range.Len()) {}

    constexpr const CharType* GetData() const { return DataPtr; }
    constexpr int32 Len() const { return Size; }
    constexpr bool IsEmpty() const { return Size == 0; }
    constexpr SIZE_T NumBytes() const { return static_cast<SIZE_T>(Size) * sizeof(CharType); }
    const CharType& operator[](int32 Index) const {
        checkf(Index >= 0 && Index < Size, TEXT("Index %d out of bounds of a string view of length %d"), Index, Size);
        return DataPtr[Index];
    }
    constexpr void Reset() { *this = TStringView(); }
    constexpr void RemovePrefix(int32 Count) {
        DataPtr += Count;
        Size -= Count;
    }
    constexpr void RemoveSuffix(int32 Count) { Size -= Count; }
    /** Copies up to CharCount characters without terminating; returns how many. */
    int32 CopyString(CharType* Dest, int32 CharCount, int32 Position = 0) const {
        const TStringView Part = Mid(Position, CharCount);
        FMemory::Memcpy(Dest, Part.DataPtr, Part.NumBytes());
        return Part.Size;
    }

    constexpr TStringView Left(int32 Count) const { return TStringView(DataPtr, Clamped(Count)); }
    constexpr TStringView LeftChop(int32 Count) const { return TStringView(DataPtr, Clamped(Size - Count)); }
    constexpr TStringView Right(int32 Count) const {
        const int32 Length = Clamped(Count);
        return TStringView(DataPtr + Size - Length, Length);
    }
    constexpr TStringView RightChop(int32 Count) const { return Right(Size - Count); }
    constexpr TStringView Mid(int32 Position, int32 Count = MAX_int32) const {
        const int32 Start = Clamped(Position);
        const int32 Rest = Size - Start;
        return TStringView(DataPtr + Start, Count < 0 ? 0 : (Count < Rest ? Count : Rest));
    }
    constexpr TStringView SubStr(int32 Position, int32 Count) const { return Mid(Position, Count); }
    TStringView TrimStart() const {
        int32 Start = 0;
        while (Start < Size && TChar<CharType>::IsWhitespace(DataPtr[Start])) {
            ++Start;
        }
        return RightChop(Start);
    }
    TStringView TrimEnd() const {
        int32 End = Size;
        while (End > 0 && TChar<CharType>::IsWhitespace(DataPtr[End - 1])) {
            --End;
        }
        return Left(End);
    }
    TStringView TrimStartAndEnd() const { return TrimStart().TrimEnd(); }

    /** Negative, 0 or positive. */
    int32 Compare(TStringView Other, ESearchCase::Type SearchCase = ESearchCase::CaseSensitive) const {
        const int32 Common = Size < Other.Size ? Size : Other.Size;
        for (int32 Index = 0; Index < Common; ++Index) {
            CharType A = DataPtr[Index];
            CharType B = Other.DataPtr[Index];
            if (A != B) {
                if (SearchCase == ESearchCase::IgnoreCase) {
                    A = TChar<CharType>::ToLower(A);
                    B = TChar<CharType>::ToLower(B);
                }
                if (A != B) {
                    return TChar<CharType>::ToUnsigned(A) < TChar<CharType>::ToUnsigned(B) ? -1 : 1;
                }
            }
        }
        return Size == Other.Size ? 0 : (Size < Other.Size ? -1 : 1);
    }
    bool Equals(TStringView Other, ESearchCase::Type SearchCase = ESearchCase::CaseSensitive) const {
        return Size == Other.Size && Compare(Other, SearchCase) == 0;
    }
    bool StartsWith(CharType Prefix) const { return Size > 0 && DataPtr[0] == Prefix; }
    bool StartsWith(TStringView Prefix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const {
        return Size >= Prefix.Size && Left(Prefix.Size).Equals(Prefix, SearchCase);
    }
    bool EndsWith(CharType Suffix) const { return Size > 0 && DataPtr[Size - 1] == Suffix; }
    bool EndsWith(TStringView Suffix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const {
        return Size >= Suffix.Size && Right(Suffix.Size).Equals(Suffix, SearchCase);
    }
    int32 Find(
        TStringView Search, int32 StartPosition = 0, ESearchCase::Type SearchCase = ESearchCase::CaseSensitive) const {
        for (int32 Index = StartPosition < 0 ? 0 : StartPosition; Index + Search.Size <= Size; ++Index) {
            if (TStringView(DataPtr + Index, Search.Size).Equals(Search, SearchCase)) {
                return Index;
            }
        }
        return INDEX_NONE;
    }
    /** The last place that begins before StartPosition (INDEX_NONE: anywhere). */
    int32 FindFromEnd(TStringView Search, int32 StartPosition, ESearchCase::Type SearchCase) const {
        int32 Index = Size - Search.Size;
        if (StartPosition != INDEX_NONE && StartPosition - 1 < Index) {
            Index = StartPosition - 1;
        }
        for (; Index >= 0; --Index) {
            if (TStringView(DataPtr + Index, Search.Size).Equals(Search, SearchCase)) {
                return Index;
            }
        }
        return INDEX_NONE;
    }
    bool Contains(TStringView Search, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase) const {
        return Find(Search, 0, SearchCase) != INDEX_NONE;
    }
    bool FindChar(CharType InChar, int32& OutIndex) const {
        for (OutIndex = 0; OutIndex < Size; ++OutIndex) {
            if (DataPtr[OutIndex] == InChar) {
                return true;
            }
        }
        OutIndex = INDEX_NONE;
        return false;
    }
    bool FindLastChar(CharType InChar, int32& OutIndex) const {
        for (OutIndex = Size - 1; OutIndex >= 0; --OutIndex) {
            if (DataPtr[OutIndex] == InChar) {
                return true;
            }
        }
        OutIndex = INDEX_NONE;
        return false;
    }
    constexpr const CharType* begin() const { return DataPtr; }
    constexpr const CharType* end() const { return DataPtr + Size; }

    friend bool operator==(TStringView A, TStringView B) { return A.Equals(B, ESearchCase::IgnoreCase); }
    friend bool operator<(TStringView A, TStringView B) { return A.Compare(B, ESearchCase::IgnoreCase) < 0; }
    friend bool operator<=(TStringView A, TStringView B) { return A.Compare(B, ESearchCase::IgnoreCase) <= 0; }
    friend bool operator>(TStringView A, TStringView B) { return A.Compare(B, ESearchCase::IgnoreCase) > 0; }
    friend bool operator>=(TStringView A, TStringView B) { return A.Compare(B, ESearchCase::IgnoreCase) >= 0; }
    friend uint32 GetTypeHash(TStringView View) { return FCrc::StrihashSpan(View.DataPtr, View.Size); }

private:
    constexpr int32 Clamped(int32 Count) const { return Count < 0 ? 0 : (Count < Size ? Count : Size); }
    const CharType* DataPtr = nullptr;
    int32 Size = 0;
};
template <typename C>
struct TIsContiguousContainer<TStringView<C>> : UE::Core::Private::TBoolTrait<true> {};
template <typename C>
constexpr int32 GetNum(const TStringView<C>& View) {
    return View.Len();
}

#define TEXTVIEW(str) FStringView(TEXT(str), static_cast<int32>(sizeof(str) - 1))
#define ANSITEXTVIEW(str) FAnsiStringView(str, static_cast<int32>(sizeof(str) - 1))
#define UTF8TEXTVIEW(str) FUtf8StringView(UTF8TEXT(str), static_cast<int32>(sizeof(UTF8TEXT(str)) - 1))

template <typename CharType>
TStringView<CharType> MakeStringView(const CharType* Data, int32 Size) {
    return TStringView<CharType>(Data, Size);
}
template <typename CharType>
TStringView<CharType> MakeStringView(const CharType* Data) {
    return TStringView<CharType>(Data);
}
template <typename T>
    requires requires(const T& Value) {
        Value.GetData();
        Value.Len();
    }
auto MakeStringView(const T& Value) {
    return TStringView<std::remove_cvref_t<decltype(*Value.GetData())>>(Value.GetData(), Value.Len());
}
