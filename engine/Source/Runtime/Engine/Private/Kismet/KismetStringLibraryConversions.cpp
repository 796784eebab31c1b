// SPDX-License-Identifier: MIT
#include "Kismet/KismetStringLibrary.h"

#include <cmath>

// Conversions to strings

FString UKismetStringLibrary::Conv_DoubleToString(double InDouble) { return FString::SanitizeFloat(InDouble); }

FString UKismetStringLibrary::Conv_IntToString(int32 InInt) { return FString::Printf(TEXT("%d"), InInt); }

FString UKismetStringLibrary::Conv_Int64ToString(int64 InInt) {
    return FString::Printf(TEXT("%lld"), static_cast<long long>(InInt));
}

FString UKismetStringLibrary::Conv_ByteToString(uint8 InByte) {
    return FString::Printf(TEXT("%d"), static_cast<int32>(InByte));
}

FString UKismetStringLibrary::Conv_BoolToString(bool InBool) { return FString(InBool ? TEXT("true") : TEXT("false")); }

FString UKismetStringLibrary::Conv_VectorToString(FVector InVec) { return InVec.ToString(); }

FString UKismetStringLibrary::Conv_Vector2dToString(FVector2D InVec) { return InVec.ToString(); }

FString UKismetStringLibrary::Conv_RotatorToString(FRotator InRot) { return InRot.ToString(); }

FString UKismetStringLibrary::Conv_TransformToString(const FTransform& InTrans) {
    return FString::Printf(TEXT("Translation: %s Rotation: %s Scale %s"), *InTrans.GetLocation().ToString(),
        *InTrans.Rotator().ToString(), *InTrans.GetScale3D().ToString());
}

FString UKismetStringLibrary::Conv_ObjectToString(UObject* InObj) { return GetNameSafe(InObj); }

FString UKismetStringLibrary::Conv_ColorToString(FLinearColor InColor) { return InColor.ToString(); }

FString UKismetStringLibrary::Conv_NameToString(FName InName) { return InName.ToString(); }

// Conversions from strings

FName UKismetStringLibrary::Conv_StringToName(const FString& InString) { return FName(*InString); }

int32 UKismetStringLibrary::Conv_StringToInt(const FString& InString) { return FCString::Atoi(*InString); }

int64 UKismetStringLibrary::Conv_StringToInt64(const FString& InString) { return FCString::Atoi64(*InString); }

double UKismetStringLibrary::Conv_StringToDouble(const FString& InString) { return FCString::Atod(*InString); }

void UKismetStringLibrary::Conv_StringToVector(const FString& InString, FVector& OutConvertedVector, bool& OutIsValid) {
    OutIsValid = OutConvertedVector.InitFromString(InString);
}

void UKismetStringLibrary::Conv_StringToVector2D(
    const FString& InString, FVector2D& OutConvertedVector2D, bool& OutIsValid) {
    OutIsValid = OutConvertedVector2D.InitFromString(InString);
}

void UKismetStringLibrary::Conv_StringToRotator(
    const FString& InString, FRotator& OutConvertedRotator, bool& OutIsValid) {
    OutIsValid = OutConvertedRotator.InitFromString(InString);
}

void UKismetStringLibrary::Conv_StringToColor(
    const FString& InString, FLinearColor& OutConvertedColor, bool& OutIsValid) {
    OutIsValid = OutConvertedColor.InitFromString(InString);
}
