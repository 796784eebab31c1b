// SPDX-License-Identifier: MIT
/** TStringBuilder<N>: text built in place, on the stack while it has at most N characters. */
#pragma once

#include "Containers/UnrealString.h"

template <typename CharType>
class TStringBuilderBase {
public:
    using ElementType = CharType;
    using ViewType = TStringView<CharType>;

    TStringBuilderBase(CharType* Buffer, int32 Capacity) : Base(Buffer), Cur(Buffer), End(Buffer + Capacity) {}
    UE_NONCOPYABLE(TStringBuilderBase)
    ~TStringBuilderBase() {
        if (bIsDynamic) {
            FMemory::Free(Base);
        }
    }

    int32 Len() const { return static_cast<int32>(Cur - Base); }
    CharType* GetData() { return Base; }
    const CharType* GetData() const { return Base; }
    /** Terminates and returns the text. */
    const CharType* ToString() const {
        EnsureTerminated();
        return Base;
    }
    const CharType* operator*() const { return ToString(); }
    ViewType ToView() const { return ViewType(Base, Len()); }
    operator ViewType() const { return ToView(); }
    CharType LastChar() const { return *(Cur - 1); }
    void Reset() { Cur = Base; }
    void RemoveSuffix(int32 Count) {
        check(Count <= Len());
        Cur -= Count;
    }
    TStringBuilderBase& AppendChar(CharType Char) {
        EnsureCapacity(1);
        *Cur++ = Char;
        return *this;
    }
    template <typename OtherChar>
    TStringBuilderBase& Append(const OtherChar* Str, int32 Count) {
        if constexpr (std::is_same_v<OtherChar, CharType>) {
            EnsureCapacity(Count);
            FMemory::Memcpy(Cur, Str, static_cast<SIZE_T>(Count) * sizeof(CharType));
            Cur += Count;
        } else {
            TArray<CharType, TInlineAllocator<128>> Converted;
            UE::Core::Private::ConvertString<CharType>(Str, Count, Converted);
            Append(Converted.GetData(), Converted.Num());
        }
        return *this;
    }
    template <typename OtherChar>
        requires TIsCharType_V<OtherChar>
    TStringBuilderBase& Append(const OtherChar* Str) {
        return Append(Str, TCString<OtherChar>::Strlen(Str));
    }
    template <typename OtherChar>
    TStringBuilderBase& Append(TStringView<OtherChar> View) {
        return Append(View.GetData(), View.Len());
    }
    TStringBuilderBase& Append(const FString& Str) { return Append(*Str, Str.Len()); }
    template <typename FmtType, typename... Types>
    TStringBuilderBase& Appendf(const FmtType& Fmt, Types... Args) {
        return Append(FString::Printf(Fmt, Args...));
    }
    template <typename RangeType>
    TStringBuilderBase& Join(const RangeType& Range, TStringView<CharType> Separator) {
        bool bFirst = true;
        for (auto&& Element : Range) {
            if (!bFirst) {
                Append(Separator);
            }
            bFirst = false;
            *this << Element;
        }
        return *this;
    }
    void InsertAt(int32 Position, ViewType Str) { ReplaceAt(Position, 0, Str); }
    void RemoveAt(int32 Position, int32 Count) { ReplaceAt(Position, Count, ViewType()); }
    void ReplaceAt(int32 Position, int32 Count, ViewType Str) {
        check(Position >= 0 && Count >= 0 && Position + Count <= Len());
        const int32 Tail = Len() - Position - Count;
        EnsureCapacity(Str.Len());
        FMemory::Memmove(
            Base + Position + Str.Len(), Base + Position + Count, static_cast<SIZE_T>(Tail) * sizeof(CharType));
        FMemory::Memcpy(Base + Position, Str.GetData(), Str.NumBytes());
        Cur += Str.Len() - Count;
    }

    friend TStringBuilderBase& operator<<(TStringBuilderBase& Builder, const FString& Str) {
        return Builder.Append(Str);
    }
    template <typename C>
    friend TStringBuilderBase& operator<<(TStringBuilderBase& Builder, TStringView<C> View) {
        return Builder.Append(View);
    }
    template <typename C>
        requires TIsCharType_V<C>
    friend TStringBuilderBase& operator<<(TStringBuilderBase& Builder, const C* Str) {
        return Builder.Append(Str);
    }
    template <typename T>
        requires std::is_arithmetic_v<T>
    friend TStringBuilderBase& operator<<(TStringBuilderBase& Builder, T Value) {
        if constexpr (TIsCharType_V<T>) {
            return Builder.AppendChar(static_cast<CharType>(Value));
        } else {
            return Builder.Append(LexToString(Value));
        }
    }
    friend TStringBuilderBase& operator<<(TStringBuilderBase& Builder, const TStringBuilderBase& Other) {
        return Builder.Append(Other.ToView());
    }

private:
    void EnsureTerminated() const {
        const_cast<TStringBuilderBase*>(this)->EnsureCapacity(1);
        *Cur = CharType(0);
    }
    void EnsureCapacity(int32 Required) {
        if (End - Cur < Required + 1) {
            const int32 Length = Len();
            const int32 NewCapacity = (Length + Required + 1) * 2;
            CharType* NewBase =
                static_cast<CharType*>(FMemory::Malloc(static_cast<SIZE_T>(NewCapacity) * sizeof(CharType)));
            FMemory::Memcpy(NewBase, Base, static_cast<SIZE_T>(Length) * sizeof(CharType));
            if (bIsDynamic) {
                FMemory::Free(Base);
            }
            Base = NewBase;
            Cur = Base + Length;
            End = Base + NewCapacity;
            bIsDynamic = true;
        }
    }
    CharType* Base;
    CharType* Cur;
    CharType* End;
    bool bIsDynamic = false;
};

template <typename CharType, int32 BufferSize>
class TStringBuilderWithBuffer : public TStringBuilderBase<CharType> {
public:
    TStringBuilderWithBuffer() : TStringBuilderBase<CharType>(StringBuffer, BufferSize) {}
    /** Made from anything that can be appended. */
    template <typename... ArgTypes>
    explicit TStringBuilderWithBuffer(EInPlace, ArgTypes&&... Args) : TStringBuilderWithBuffer() {
        (void)(static_cast<TStringBuilderBase<CharType>&>(*this) << ... << Forward<ArgTypes>(Args));
    }

private:
    CharType StringBuffer[BufferSize];
};
template <int32 BufferSize>
using TStringBuilder = TStringBuilderWithBuffer<TCHAR, BufferSize>;
template <int32 BufferSize>
using TAnsiStringBuilder = TStringBuilderWithBuffer<ANSICHAR, BufferSize>;
template <int32 BufferSize>
using TUtf8StringBuilder = TStringBuilderWithBuffer<UTF8CHAR, BufferSize>;

/** A builder that holds the arguments one after another, for the length of an expression. */
template <int32 BufferSize>
class TWriteToString : public TStringBuilder<BufferSize> {
public:
    template <typename... ArgTypes>
    explicit TWriteToString(ArgTypes&&... Args) {
        (void)(static_cast<TStringBuilderBase<TCHAR>&>(*this) << ... << Forward<ArgTypes>(Args));
    }
};
template <int32 BufferSize, typename... ArgTypes>
TWriteToString<BufferSize> WriteToString(ArgTypes&&... Args) {
    return TWriteToString<BufferSize>(Forward<ArgTypes>(Args)...);
}

inline FString::FString(const FStringBuilderBase& Builder) : FString(Builder.ToView()) {}
