// SPDX-License-Identifier: MIT
/** FRandomStream: a repeatable sequence of random numbers. */
#pragma once

#include "Math/Box.h"

struct FRandomStream {
    FRandomStream() : InitialSeed(0), Seed(0) {}
    FRandomStream(int32 InSeed) { Initialize(InSeed); }
    explicit FRandomStream(FName InName) { Initialize(InName); }

    void Initialize(int32 InSeed) {
        InitialSeed = InSeed;
        Seed = InSeed;
    }
    void Initialize(FName InName) { Initialize(static_cast<int32>(FCrc::StrCrc32(*InName.ToString()))); }
    void Reset() const { Seed = InitialSeed; }
    int32 GetInitialSeed() const { return InitialSeed; }
    int32 GetCurrentSeed() const { return Seed; }
    void GenerateNewSeed() { Initialize(FMath::Rand()); }
    /** In [0, 1). */
    float GetFraction() const {
        MutateSeed();
        const uint32 Bits = 0x3F800000u | (static_cast<uint32>(Seed) >> 9);
        float Result;
        FMemory::Memcpy(&Result, &Bits, sizeof(Result));
        return Result - 1.0f;
    }
    float FRand() const { return GetFraction(); }
    uint32 GetUnsignedInt() const {
        MutateSeed();
        return static_cast<uint32>(Seed);
    }
    /** Unit vector, uniform on the sphere. */
    FVector GetUnitVector() const {
        FVector Result;
        double Length;
        do {
            Result.X = static_cast<double>(GetFraction()) * 2.0 - 1.0;
            Result.Y = static_cast<double>(GetFraction()) * 2.0 - 1.0;
            Result.Z = static_cast<double>(GetFraction()) * 2.0 - 1.0;
            Length = Result.SizeSquared();
        } while (Length > 1.0 || Length < UE_KINDA_SMALL_NUMBER);
        return Result.GetUnsafeNormal();
    }
    FVector VRand() const { return GetUnitVector(); }
    /** Unit vector within an angle of a direction. */
    FVector VRandCone(const FVector& Dir, float ConeHalfAngleRad) const {
        if (ConeHalfAngleRad <= 0.f) {
            return Dir.GetSafeNormal();
        }
        const double Phi = 2.0 * UE_DOUBLE_PI * static_cast<double>(GetFraction());
        const double CosTheta =
            1.0 - static_cast<double>(GetFraction()) * (1.0 - FMath::Cos(static_cast<double>(ConeHalfAngleRad)));
        const double SinTheta = FMath::Sqrt(1.0 - CosTheta * CosTheta);
        const FVector Local(CosTheta, SinTheta * FMath::Cos(Phi), SinTheta * FMath::Sin(Phi));
        return Dir.ToOrientationQuat().RotateVector(Local);
    }
    /** Integer in [0, A). */
    int32 RandHelper(int32 A) const {
        return A > 0 ? FMath::TruncToInt32(GetFraction() * (static_cast<float>(A) - UE_DELTA)) : 0;
    }
    /** Integer in [Min, Max]. */
    int32 RandRange(int32 InMin, int32 InMax) const {
        const int32 Range = InMax - InMin + 1;
        return InMin + RandHelper(Range);
    }
    float FRandRange(float InMin, float InMax) const { return InMin + (InMax - InMin) * GetFraction(); }
    double FRandRange(double InMin, double InMax) const {
        return InMin + (InMax - InMin) * static_cast<double>(GetFraction());
    }
    FVector RandPointInBox(const FBox& Box) const {
        return FVector(
            FRandRange(Box.Min.X, Box.Max.X), FRandRange(Box.Min.Y, Box.Max.Y), FRandRange(Box.Min.Z, Box.Max.Z));
    }
    FString ToString() const {
        return FString::Printf(TEXT("FRandomStream(InitialSeed=%d, Seed=%u)"), InitialSeed, static_cast<uint32>(Seed));
    }

private:
    void MutateSeed() const { Seed = static_cast<int32>(static_cast<uint32>(Seed) * 196314165u + 907633515u); }

    int32 InitialSeed;
    mutable int32 Seed;
};
