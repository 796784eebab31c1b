// SPDX-License-Identifier: MIT
/** @file What the source files of UKismetMathLibrary share. */
#pragma once

#include "CoreMinimal.h"
#include "Kismet/KismetMathLibrary.h"

DECLARE_LOG_CATEGORY_EXTERN(LogBlueprintMath, Log, All);

namespace KismetMathPrivate {

/** Says in the log that a function was asked to divide by zero. */
void WarnDivideByZero(const TCHAR* Function);

/** A number as an integer; what does not fit is clamped, not-a-number is 0. */
int32 ToInt32(double Value);
/** A number as a 64 bit integer; what does not fit is clamped, not-a-number is 0. */
int64 ToInt64(double Value);

/** Where between 0 and 1 an easing function is for an alpha between 0 and 1. */
double EaseAlpha(double Alpha, EEasingFunc::Type Function, double Exponent, int32 Steps);
/** The easing function EaseInOut. */
double EaseInOutAlpha(double Alpha, double Exponent);

/** Blends two transforms: location and scale linearly, the rotation by the mode. */
FTransform InterpolateTransforms(
    const FTransform& A, const FTransform& B, double Alpha, ELerpInterpolationMode::Type Mode);

} // namespace KismetMathPrivate
