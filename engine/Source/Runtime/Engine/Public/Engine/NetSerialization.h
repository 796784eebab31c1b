// SPDX-License-Identifier: MIT
/** @file Vectors that UE quantises on the network. There is no network here: they are vectors with their own reflected
 * type. */
#pragma once

#include "CoreMinimal.h"
#include "UObject/Class.h"

#include "NetSerialization.generated.h"

/** FVector that UE rounds to integers when it is replicated. */
USTRUCT(BlueprintType)
struct FVector_NetQuantize : public FVector {
    GENERATED_BODY()

    FVector_NetQuantize() : FVector(0.0, 0.0, 0.0) {}
    explicit FVector_NetQuantize(EForceInit E) : FVector(E) {}
    FVector_NetQuantize(double InX, double InY, double InZ) : FVector(InX, InY, InZ) {}
    FVector_NetQuantize(const FVector& InVec) : FVector(InVec) {}
};

/** FVector that UE rounds to one hundredth when it is replicated. */
USTRUCT(BlueprintType)
struct FVector_NetQuantize100 : public FVector {
    GENERATED_BODY()

    FVector_NetQuantize100() : FVector(0.0, 0.0, 0.0) {}
    explicit FVector_NetQuantize100(EForceInit E) : FVector(E) {}
    FVector_NetQuantize100(double InX, double InY, double InZ) : FVector(InX, InY, InZ) {}
    FVector_NetQuantize100(const FVector& InVec) : FVector(InVec) {}
};

/** Unit FVector that UE sends as 16 bits a component when it is replicated. */
USTRUCT(BlueprintType)
struct FVector_NetQuantizeNormal : public FVector {
    GENERATED_BODY()

    FVector_NetQuantizeNormal() : FVector(0.0, 0.0, 0.0) {}
    explicit FVector_NetQuantizeNormal(EForceInit E) : FVector(E) {}
    FVector_NetQuantizeNormal(double InX, double InY, double InZ) : FVector(InX, InY, InZ) {}
    FVector_NetQuantizeNormal(const FVector& InVec) : FVector(InVec) {}
};
