// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Conversions

int64 UKismetMathLibrary::Conv_DoubleToInt64(double InDouble) { return ToInt64(InDouble); }

float UKismetMathLibrary::Conv_DoubleToFloat(double InDouble) { return static_cast<float>(InDouble); }

double UKismetMathLibrary::Conv_FloatToDouble(float InFloat) { return static_cast<double>(InFloat); }

double UKismetMathLibrary::Conv_IntToDouble(int32 InInt) { return static_cast<double>(InInt); }

int64 UKismetMathLibrary::Conv_IntToInt64(int32 InInt) { return static_cast<int64>(InInt); }

uint8 UKismetMathLibrary::Conv_IntToByte(int32 InInt) { return static_cast<uint8>(InInt); }

int32 UKismetMathLibrary::Conv_Int64ToInt(int64 InInt) { return static_cast<int32>(InInt); }

double UKismetMathLibrary::Conv_Int64ToDouble(int64 InInt) { return static_cast<double>(InInt); }

bool UKismetMathLibrary::Conv_IntToBool(int32 InInt) { return InInt != 0; }

int32 UKismetMathLibrary::Conv_BoolToInt(bool InBool) { return InBool ? 1 : 0; }

double UKismetMathLibrary::Conv_BoolToDouble(bool InBool) { return InBool ? 1.0 : 0.0; }

uint8 UKismetMathLibrary::Conv_BoolToByte(bool InBool) { return InBool ? 1 : 0; }

double UKismetMathLibrary::Conv_ByteToDouble(uint8 InByte) { return static_cast<double>(InByte); }

int32 UKismetMathLibrary::Conv_ByteToInt(uint8 InByte) { return static_cast<int32>(InByte); }

int64 UKismetMathLibrary::Conv_ByteToInt64(uint8 InByte) { return static_cast<int64>(InByte); }

FVector UKismetMathLibrary::Conv_DoubleToVector(double InDouble) { return FVector(InDouble, InDouble, InDouble); }

FVector2D UKismetMathLibrary::Conv_DoubleToVector2D(double InDouble) { return FVector2D(InDouble, InDouble); }

FLinearColor UKismetMathLibrary::Conv_DoubleToLinearColor(double InDouble) {
    const float Value = static_cast<float>(InDouble);
    return FLinearColor(Value, Value, Value, 1.0f);
}

FVector UKismetMathLibrary::Conv_IntToVector(int32 InInt) { return FVector(InInt, InInt, InInt); }

FLinearColor UKismetMathLibrary::Conv_VectorToLinearColor(FVector InVec) {
    return FLinearColor(static_cast<float>(InVec.X), static_cast<float>(InVec.Y), static_cast<float>(InVec.Z), 1.0f);
}

FVector2D UKismetMathLibrary::Conv_VectorToVector2D(FVector InVector) { return FVector2D(InVector.X, InVector.Y); }

FVector UKismetMathLibrary::Conv_Vector2DToVector(FVector2D InVector2D, float Z) {
    return FVector(InVector2D.X, InVector2D.Y, Z);
}

FTransform UKismetMathLibrary::Conv_VectorToTransform(FVector InLocation) { return FTransform(InLocation); }

FRotator UKismetMathLibrary::Conv_VectorToRotator(FVector InVec) { return InVec.ToOrientationRotator(); }

FQuat UKismetMathLibrary::Conv_VectorToQuaternion(FVector InVec) { return InVec.ToOrientationQuat(); }

FVector UKismetMathLibrary::Conv_RotatorToVector(FRotator InRot) { return InRot.Vector(); }

FTransform UKismetMathLibrary::Conv_RotatorToTransform(const FRotator& InRotator) { return FTransform(InRotator); }

FQuat UKismetMathLibrary::Conv_RotatorToQuaternion(FRotator InRot) { return InRot.Quaternion(); }

FVector UKismetMathLibrary::Conv_IntVectorToVector(const FIntVector& InIntVector) {
    return FVector(InIntVector.X, InIntVector.Y, InIntVector.Z);
}

FVector2D UKismetMathLibrary::Conv_IntPointToVector2D(FIntPoint InIntPoint) {
    return FVector2D(InIntPoint.X, InIntPoint.Y);
}

FLinearColor UKismetMathLibrary::Conv_ColorToLinearColor(FColor InColor) { return FLinearColor(InColor); }

FVector UKismetMathLibrary::Conv_LinearColorToVector(FLinearColor InLinearColor) {
    return FVector(InLinearColor.R, InLinearColor.G, InLinearColor.B);
}

FColor UKismetMathLibrary::Conv_LinearColorToColor(FLinearColor InLinearColor, bool InUseSRGB) {
    return InLinearColor.ToFColor(InUseSRGB);
}
