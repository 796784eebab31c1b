// SPDX-License-Identifier: MIT
#include "Internationalization/Text.h"

const FString& FText::ToString() const {
    static const FString Empty;
    return TextData ? *TextData : Empty;
}

FText FText::Format(const FText& Fmt, const FFormatNamedArguments& InArguments) {
    FStringFormatNamedArguments Named;
    for (const auto& Pair : InArguments) {
        Named.Add(Pair.Key, FStringFormatArg(Pair.Value.GetTextValue().ToString()));
    }
    return FromString(FString::Format(*Fmt.ToString(), Named));
}

FText FText::Format(const FText& Fmt, const FFormatOrderedArguments& InArguments) {
    FStringFormatOrderedArguments Ordered;
    for (const FFormatArgumentValue& Value : InArguments) {
        Ordered.Add(FStringFormatArg(Value.GetTextValue().ToString()));
    }
    return FromString(FString::Format(*Fmt.ToString(), Ordered));
}

namespace {
/** English conventions: groups of three with commas, a point before the fraction. */
FString Decorate(FString Digits, const FNumberFormattingOptions& Options) {
    const bool bNegative = Digits.RemoveFromStart(TEXT("-"));
    FString Integral = Digits;
    FString Fraction;
    Digits.Split(TEXT("."), &Integral, &Fraction);
    while (Fraction.Len() > Options.MinimumFractionalDigits && Fraction.EndsWith(TEXT("0"))) {
        Fraction.LeftChopInline(1);
    }
    while (Integral.Len() < Options.MinimumIntegralDigits) {
        Integral.InsertAt(0, TCHAR('0'));
    }
    if (Options.UseGrouping) {
        for (int32 Index = Integral.Len() - 3; Index > 0; Index -= 3) {
            Integral.InsertAt(Index, TCHAR(','));
        }
    }
    FString Result = bNegative ? TEXT("-") : (Options.AlwaysSign ? TEXT("+") : TEXT(""));
    Result += Integral;
    if (!Fraction.IsEmpty()) {
        Result += TEXT(".") + Fraction;
    }
    return Result;
}
} // namespace

FText FText::AsNumberImpl(double Value, const FNumberFormattingOptions* Options) {
    const FNumberFormattingOptions Used = Options ? *Options : FNumberFormattingOptions();
    const FString Digits = FString::Printf(TEXT("%.*f"), Used.MaximumFractionalDigits, Value);
    return FromString(Digits.IsNumeric() ? Decorate(Digits, Used) : Digits);
}

FText FText::AsNumberImpl(int64 Value, const FNumberFormattingOptions* Options) {
    const FNumberFormattingOptions Used = Options ? *Options : FNumberFormattingOptions();
    FString Digits = FString::Printf(TEXT("%lld"), Value);
    if (Used.MinimumFractionalDigits > 0) {
        Digits += TEXT(".") + FString::ChrN(Used.MinimumFractionalDigits, TCHAR('0'));
    }
    return FromString(Decorate(Digits, Used));
}

FText FText::AsPercent(double Value, const FNumberFormattingOptions* Options) {
    FNumberFormattingOptions Default;
    Default.SetMaximumFractionalDigits(0);
    return FromString(AsNumberImpl(Value * 100.0, Options ? Options : &Default).ToString() + TEXT("%"));
}
