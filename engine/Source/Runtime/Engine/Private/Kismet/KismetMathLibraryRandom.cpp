// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Random numbers

int32 UKismetMathLibrary::RandomInteger(int32 Max) { return FMath::RandHelper(Max); }

int32 UKismetMathLibrary::RandomIntegerInRange(int32 Min, int32 Max) { return FMath::RandRange(Min, Max); }

double UKismetMathLibrary::RandomFloat() { return FMath::FRand(); }

double UKismetMathLibrary::RandomFloatInRange(double Min, double Max) { return Min + (Max - Min) * FMath::FRand(); }

FVector UKismetMathLibrary::RandomUnitVector() { return FMath::VRand(); }

FVector UKismetMathLibrary::RandomPointInBoundingBox(const FVector Center, const FVector HalfSize) {
    return FVector(RandomFloatInRange(Center.X - HalfSize.X, Center.X + HalfSize.X),
        RandomFloatInRange(Center.Y - HalfSize.Y, Center.Y + HalfSize.Y),
        RandomFloatInRange(Center.Z - HalfSize.Z, Center.Z + HalfSize.Z));
}

FRandomStream UKismetMathLibrary::MakeRandomStream(int32 InitialSeed) { return FRandomStream(InitialSeed); }

void UKismetMathLibrary::BreakRandomStream(const FRandomStream& InRandomStream, int32& InitialSeed) {
    InitialSeed = InRandomStream.GetInitialSeed();
}

// Random streams

int32 UKismetMathLibrary::RandomIntegerFromStream(const FRandomStream& Stream, int32 Max) {
    return Stream.RandHelper(Max);
}

int32 UKismetMathLibrary::RandomIntegerInRangeFromStream(const FRandomStream& Stream, int32 Min, int32 Max) {
    return Stream.RandRange(Min, Max);
}

bool UKismetMathLibrary::RandomBoolFromStream(const FRandomStream& Stream) { return Stream.RandRange(0, 1) == 1; }

bool UKismetMathLibrary::RandomBoolWithWeightFromStream(const FRandomStream& RandomStream, float Weight) {
    return Weight > 0.0f && Weight >= RandomStream.GetFraction();
}

float UKismetMathLibrary::RandomFloatFromStream(const FRandomStream& Stream) { return Stream.GetFraction(); }

float UKismetMathLibrary::RandomFloatInRangeFromStream(const FRandomStream& Stream, float Min, float Max) {
    return Stream.FRandRange(Min, Max);
}

FVector UKismetMathLibrary::RandomUnitVectorFromStream(const FRandomStream& Stream) { return Stream.GetUnitVector(); }

FRotator UKismetMathLibrary::RandomRotatorFromStream(const FRandomStream& Stream, bool bRoll) {
    const double Yaw = Stream.GetFraction() * 360.0;
    const double Pitch = Stream.GetFraction() * 360.0;
    const double Roll = bRoll ? Stream.GetFraction() * 360.0 : 0.0;
    return FRotator(Pitch, Yaw, Roll);
}

void UKismetMathLibrary::ResetRandomStream(const FRandomStream& Stream) { Stream.Reset(); }

void UKismetMathLibrary::SeedRandomStream(FRandomStream& Stream) { Stream.GenerateNewSeed(); }

void UKismetMathLibrary::SetRandomStreamSeed(FRandomStream& Stream, int32 NewSeed) { Stream.Initialize(NewSeed); }

// Choices

FString UKismetMathLibrary::SelectString(const FString& A, const FString& B, bool bPickA) { return bPickA ? A : B; }

int32 UKismetMathLibrary::SelectInt(int32 A, int32 B, bool bPickA) { return bPickA ? A : B; }

double UKismetMathLibrary::SelectFloat(double A, double B, bool bPickA) { return bPickA ? A : B; }

FVector UKismetMathLibrary::SelectVector(FVector A, FVector B, bool bPickA) { return bPickA ? A : B; }

FRotator UKismetMathLibrary::SelectRotator(FRotator A, FRotator B, bool bPickA) { return bPickA ? A : B; }

FLinearColor UKismetMathLibrary::SelectColor(FLinearColor A, FLinearColor B, bool bPickA) { return bPickA ? A : B; }

FTransform UKismetMathLibrary::SelectTransform(const FTransform& A, const FTransform& B, bool bPickA) {
    return bPickA ? A : B;
}

UObject* UKismetMathLibrary::SelectObject(UObject* A, UObject* B, bool bSelectA) { return bSelectA ? A : B; }

UClass* UKismetMathLibrary::SelectClass(UClass* A, UClass* B, bool bSelectA) { return bSelectA ? A : B; }

bool UKismetMathLibrary::EqualEqual_ObjectObject(UObject* A, UObject* B) { return A == B; }

bool UKismetMathLibrary::NotEqual_ObjectObject(UObject* A, UObject* B) { return A != B; }

bool UKismetMathLibrary::EqualEqual_ClassClass(UClass* A, UClass* B) { return A == B; }

bool UKismetMathLibrary::ClassIsChildOf(TSubclassOf<UObject> TestClass, TSubclassOf<UObject> ParentClass) {
    return ParentClass && TestClass && TestClass->IsChildOf(ParentClass);
}

bool UKismetMathLibrary::EqualEqual_NameName(FName A, FName B) { return A == B; }

bool UKismetMathLibrary::NotEqual_NameName(FName A, FName B) { return !(A == B); }
