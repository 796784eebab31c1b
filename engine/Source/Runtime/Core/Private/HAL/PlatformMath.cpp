// SPDX-License-Identifier: MIT
// Random numbers: two generators of 32 bits (PCG), one for Rand/FRand, one for SRand. Seeds make them repeatable. Game
// thread only.
#include "HAL/PlatformMath.h"

namespace {

struct FPcg {
    uint64 State = 0x853c49e6748fea9bull;

    void Seed(uint64 Value) {
        State = 0;
        Next();
        State += Value;
        Next();
    }
    uint32 Next() {
        const uint64 Old = State;
        State = Old * 6364136223846793005ull + 1442695040888963407ull;
        const uint32 Shifted = static_cast<uint32>(((Old >> 18) ^ Old) >> 27);
        const uint32 Turn = static_cast<uint32>(Old >> 59);
        return (Shifted >> Turn) | (Shifted << ((32u - Turn) & 31u));
    }
    /** In [0, 1): 24 bits, so that float holds them exactly. */
    float Share() { return static_cast<float>(Next() >> 8) * (1.0f / 16777216.0f); }
};
FPcg RandGenerator;
FPcg SRandGenerator;
int32 SRandSeed = 0;

} // namespace

int32 FGenericPlatformMath::Rand() { return static_cast<int32>(RandGenerator.Next() >> 1); }
int32 FGenericPlatformMath::Rand32() { return static_cast<int32>(RandGenerator.Next()); }
void FGenericPlatformMath::RandInit(int32 Seed) { RandGenerator.Seed(static_cast<uint32>(Seed)); }
float FGenericPlatformMath::FRand() { return RandGenerator.Share(); }
void FGenericPlatformMath::SRandInit(int32 Seed) {
    SRandSeed = Seed;
    SRandGenerator.Seed(static_cast<uint32>(Seed));
}
int32 FGenericPlatformMath::GetRandSeed() { return SRandSeed; }
float FGenericPlatformMath::SRand() { return SRandGenerator.Share(); }
