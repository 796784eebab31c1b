// SPDX-License-Identifier: MIT
/** FText: text for people. This engine has one culture (English), so text is an immutable shared string. */
#pragma once

#include "Containers/UnrealString.h"
#include "Misc/EnumClassFlags.h"
#include "Templates/SharedPointer.h"
#include "UObject/NameTypes.h"

enum class ETextFlag : uint32 {
    Transient = (1 << 0),
    CultureInvariant = (1 << 1),
    ConvertedProperty = (1 << 2),
    Immutable = (1 << 3),
    InitializedFromString = (1 << 4),
};
ENUM_CLASS_FLAGS(ETextFlag)

namespace ETextComparisonLevel {
enum Type { Default, Primary, Secondary, Tertiary, Quaternary, Quinary };
}

struct FNumberFormattingOptions {
    bool UseGrouping = true;
    bool AlwaysSign = false;
    int32 MinimumIntegralDigits = 1;
    int32 MaximumIntegralDigits = 308 + 15 + 1;
    int32 MinimumFractionalDigits = 0;
    int32 MaximumFractionalDigits = 3;
    FNumberFormattingOptions& SetUseGrouping(bool bValue) {
        UseGrouping = bValue;
        return *this;
    }
    FNumberFormattingOptions& SetAlwaysSign(bool bValue) {
        AlwaysSign = bValue;
        return *this;
    }
    FNumberFormattingOptions& SetMinimumIntegralDigits(int32 Value) {
        MinimumIntegralDigits = Value;
        return *this;
    }
    FNumberFormattingOptions& SetMinimumFractionalDigits(int32 Value) {
        MinimumFractionalDigits = Value;
        return *this;
    }
    FNumberFormattingOptions& SetMaximumFractionalDigits(int32 Value) {
        MaximumFractionalDigits = Value;
        return *this;
    }
};

class FFormatArgumentValue;
typedef TMap<FString, FFormatArgumentValue> FFormatNamedArguments;
typedef TArray<FFormatArgumentValue> FFormatOrderedArguments;

class FText {
public:
    FText() = default;

    static const FText& GetEmpty() {
        static const FText Empty;
        return Empty;
    }
    [[nodiscard]] static FText FromString(const FString& String) {
        return FText(FString(String), ETextFlag::InitializedFromString);
    }
    [[nodiscard]] static FText FromString(FString&& String) {
        return FText(MoveTemp(String), ETextFlag::InitializedFromString);
    }
    [[nodiscard]] static FText FromStringView(FStringView String) { return FromString(FString(String)); }
    [[nodiscard]] static FText FromName(const FName& Name) { return FromString(Name.ToString()); }
    [[nodiscard]] static FText AsCultureInvariant(const FString& String) {
        return FText(FString(String), ETextFlag::CultureInvariant);
    }
    [[nodiscard]] static FText AsCultureInvariant(FString&& String) {
        return FText(MoveTemp(String), ETextFlag::CultureInvariant);
    }

    template <typename T>
        requires std::is_arithmetic_v<T>
    [[nodiscard]] static FText AsNumber(T Value, const FNumberFormattingOptions* Options = nullptr) {
        if constexpr (std::is_floating_point_v<T>) {
            return AsNumberImpl(static_cast<double>(Value), Options);
        } else {
            return AsNumberImpl(static_cast<int64>(Value), Options);
        }
    }
    /** 0.25 is "25%". */
    [[nodiscard]] static CORE_API FText AsPercent(double Value, const FNumberFormattingOptions* Options = nullptr);

    CORE_API const FString& ToString() const;
    FString BuildSourceString() const { return ToString(); }
    bool IsEmpty() const { return ToString().IsEmpty(); }
    bool IsEmptyOrWhitespace() const { return ToString().TrimStartAndEnd().IsEmpty(); }
    bool IsTransient() const { return EnumHasAnyFlags(Flags, ETextFlag::Transient); }
    bool IsCultureInvariant() const { return EnumHasAnyFlags(Flags, ETextFlag::CultureInvariant); }
    bool IsInitializedFromString() const { return EnumHasAnyFlags(Flags, ETextFlag::InitializedFromString); }
    bool IsNumeric() const { return ToString().IsNumeric(); }
    FText ToLower() const { return FromString(ToString().ToLower()); }
    FText ToUpper() const { return FromString(ToString().ToUpper()); }
    static FText TrimPreceding(const FText& Text) { return FromString(Text.ToString().TrimStart()); }
    static FText TrimTrailing(const FText& Text) { return FromString(Text.ToString().TrimEnd()); }
    static FText TrimPrecedingAndTrailing(const FText& Text) { return FromString(Text.ToString().TrimStartAndEnd()); }

    int32 CompareTo(const FText& Other, ETextComparisonLevel::Type = ETextComparisonLevel::Default) const {
        return ToString().Compare(Other.ToString(), ESearchCase::CaseSensitive);
    }
    int32 CompareToCaseIgnored(const FText& Other) const {
        return ToString().Compare(Other.ToString(), ESearchCase::IgnoreCase);
    }
    bool EqualTo(const FText& Other, ETextComparisonLevel::Type Level = ETextComparisonLevel::Default) const {
        return CompareTo(Other, Level) == 0;
    }
    bool EqualToCaseIgnored(const FText& Other) const { return CompareToCaseIgnored(Other) == 0; }
    /** The very same text object, or both empty. */
    bool IdenticalTo(const FText& Other) const { return TextData == Other.TextData; }

    /** Replaces {Name} or {0}; a backtick escapes a brace. */
    [[nodiscard]] static CORE_API FText Format(const FText& Fmt, const FFormatNamedArguments& InArguments);
    [[nodiscard]] static CORE_API FText Format(const FText& Fmt, const FFormatOrderedArguments& InArguments);
    template <typename... TArguments>
        requires(std::is_constructible_v<FFormatArgumentValue, TArguments> && ...)
    [[nodiscard]] static FText Format(const FText& Fmt, TArguments&&... Args);
    template <typename... TArguments>
    [[nodiscard]] static FText FormatOrdered(const FText& Fmt, TArguments&&... Args);
    template <typename RangeType>
    [[nodiscard]] static FText Join(const FText& Delimiter, const RangeType& Args) {
        return FromString(
            FString::JoinBy(Args, *Delimiter.ToString(), [](const FText& Text) { return Text.ToString(); }));
    }

private:
    FText(FString&& InString, ETextFlag InFlags)
        : TextData(InString.IsEmpty() ? TSharedPtr<const FString>()
                                      : TSharedPtr<const FString>(new FString(MoveTemp(InString)))),
          Flags(InFlags) {}
    static CORE_API FText AsNumberImpl(double Value, const FNumberFormattingOptions* Options);
    static CORE_API FText AsNumberImpl(int64 Value, const FNumberFormattingOptions* Options);

    TSharedPtr<const FString> TextData;
    ETextFlag Flags = static_cast<ETextFlag>(0);
};

/** A value for FText::Format. */
class FFormatArgumentValue {
public:
    FFormatArgumentValue() = default;
    template <typename T>
        requires std::is_arithmetic_v<T>
    FFormatArgumentValue(T Value) : Text(FText::AsNumber(Value)) {}
    FFormatArgumentValue(const FText& Value) : Text(Value) {}
    FFormatArgumentValue(const FString& Value) : Text(FText::FromString(Value)) {}
    FFormatArgumentValue(const TCHAR* Value) : Text(FText::FromString(FString(Value))) {}
    const FText& GetTextValue() const { return Text; }

private:
    FText Text;
};

template <typename... TArguments>
    requires(std::is_constructible_v<FFormatArgumentValue, TArguments> && ...)
FText FText::Format(const FText& Fmt, TArguments&&... Args) {
    FFormatOrderedArguments Ordered;
    (Ordered.Emplace(Forward<TArguments>(Args)), ...);
    return Format(Fmt, Ordered);
}
template <typename... TArguments>
FText FText::FormatOrdered(const FText& Fmt, TArguments&&... Args) {
    return Format(Fmt, Forward<TArguments>(Args)...);
}

inline FString LexToString(const FText& Value) { return Value.ToString(); }
inline void LexFromString(FText& OutValue, const TCHAR* Buffer) { OutValue = FText::FromString(FString(Buffer)); }

/** Localisable literals. Namespace and key are for tools; this engine shows the source text. */
#define NSLOCTEXT(InNamespace, InKey, InTextLiteral) FText::FromString(FString(TEXT(InTextLiteral)))
#define LOCTEXT(InKey, InTextLiteral) NSLOCTEXT(LOCTEXT_NAMESPACE, InKey, InTextLiteral)
#define INVTEXT(InTextLiteral) FText::AsCultureInvariant(FString(TEXT(InTextLiteral)))
