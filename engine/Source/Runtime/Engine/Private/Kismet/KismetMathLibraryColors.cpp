// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Linear colour functions

FLinearColor UKismetMathLibrary::LinearColor_White() { return FLinearColor(1.0f, 1.0f, 1.0f, 1.0f); }

FLinearColor UKismetMathLibrary::LinearColor_Gray() { return FLinearColor(0.5f, 0.5f, 0.5f, 1.0f); }

FLinearColor UKismetMathLibrary::LinearColor_Black() { return FLinearColor(0.0f, 0.0f, 0.0f, 1.0f); }

FLinearColor UKismetMathLibrary::LinearColor_Red() { return FLinearColor(1.0f, 0.0f, 0.0f, 1.0f); }

FLinearColor UKismetMathLibrary::LinearColor_Green() { return FLinearColor(0.0f, 1.0f, 0.0f, 1.0f); }

FLinearColor UKismetMathLibrary::LinearColor_Blue() { return FLinearColor(0.0f, 0.0f, 1.0f, 1.0f); }

FLinearColor UKismetMathLibrary::LinearColor_Yellow() { return FLinearColor(1.0f, 1.0f, 0.0f, 1.0f); }

FLinearColor UKismetMathLibrary::LinearColor_Transparent() { return FLinearColor(0.0f, 0.0f, 0.0f, 0.0f); }

FLinearColor UKismetMathLibrary::MakeColor(float R, float G, float B, float A) { return FLinearColor(R, G, B, A); }

void UKismetMathLibrary::BreakColor(FLinearColor InColor, float& R, float& G, float& B, float& A) {
    R = InColor.R;
    G = InColor.G;
    B = InColor.B;
    A = InColor.A;
}

FLinearColor UKismetMathLibrary::HSVToRGB(float H, float S, float V, float A) {
    return FLinearColor(H, S, V, A).HSVToLinearRGB();
}

void UKismetMathLibrary::RGBToHSV(FLinearColor InColor, float& H, float& S, float& V, float& A) {
    const FLinearColor Hsv = InColor.LinearRGBToHSV();
    H = Hsv.R;
    S = Hsv.G;
    V = Hsv.B;
    A = Hsv.A;
}

FLinearColor UKismetMathLibrary::LinearColorLerp(FLinearColor A, FLinearColor B, float Alpha) {
    return FLinearColor(
        A.R + Alpha * (B.R - A.R), A.G + Alpha * (B.G - A.G), A.B + Alpha * (B.B - A.B), A.A + Alpha * (B.A - A.A));
}

FLinearColor UKismetMathLibrary::CInterpTo(
    FLinearColor Current, FLinearColor Target, float DeltaTime, float InterpSpeed) {
    if (InterpSpeed <= 0.0f) {
        return Target;
    }
    return LinearColorLerp(
        Current, Target, static_cast<float>(FClamp(static_cast<double>(DeltaTime) * InterpSpeed, 0.0, 1.0)));
}

FLinearColor UKismetMathLibrary::Multiply_LinearColorLinearColor(FLinearColor A, FLinearColor B) {
    return FLinearColor(A.R * B.R, A.G * B.G, A.B * B.B, A.A * B.A);
}

FLinearColor UKismetMathLibrary::Multiply_LinearColorFloat(FLinearColor A, float B) {
    return FLinearColor(A.R * B, A.G * B, A.B * B, A.A * B);
}

FLinearColor UKismetMathLibrary::Add_LinearColorLinearColor(FLinearColor A, FLinearColor B) {
    return FLinearColor(A.R + B.R, A.G + B.G, A.B + B.B, A.A + B.A);
}

FLinearColor UKismetMathLibrary::Subtract_LinearColorLinearColor(FLinearColor A, FLinearColor B) {
    return FLinearColor(A.R - B.R, A.G - B.G, A.B - B.B, A.A - B.A);
}

bool UKismetMathLibrary::EqualEqual_LinearColorLinearColor(FLinearColor A, FLinearColor B) {
    return A.R == B.R && A.G == B.G && A.B == B.B && A.A == B.A;
}

float UKismetMathLibrary::LinearColor_GetLuminance(FLinearColor InColor) {
    return InColor.R * 0.3f + InColor.G * 0.59f + InColor.B * 0.11f;
}

FLinearColor UKismetMathLibrary::LinearColor_Desaturated(FLinearColor InColor, float InDesaturation) {
    const float Luminance = LinearColor_GetLuminance(InColor);
    return LinearColorLerp(InColor, FLinearColor(Luminance, Luminance, Luminance, 0.0f), InDesaturation);
}

float UKismetMathLibrary::LinearColor_Distance(FLinearColor C1, FLinearColor C2) {
    const FLinearColor D = Subtract_LinearColorLinearColor(C1, C2);
    return std::sqrt(D.R * D.R + D.G * D.G + D.B * D.B + D.A * D.A);
}

FColor UKismetMathLibrary::LinearColor_Quantize(FLinearColor InColor) { return InColor.ToFColor(false); }
