// SPDX-License-Identifier: MIT
#pragma once

// What the benchmark calls through reflection, and the same calls made without SPEAR, for comparison.

#include "CoreMinimal.h"
#include "UObject/Object.h"

#include "SpearBench.generated.h"

UCLASS()
class SPEARBENCH_API USpearBench : public UObject {
    GENERATED_BODY()

public:
    /** A function that does next to nothing, with a vector as argument and result. */
    UFUNCTION(BlueprintCallable, Category = "SpearBench")
    FVector Move(FVector By) {
        Place += By;
        return Place;
    }

    /** Calls Move through ProcessEvent that many times, as C++ code inside the engine does: by name each time, as the
     * code that Unreal generates for events does it, or with the function kept. Returns the nanoseconds of one call. */
    UFUNCTION(BlueprintCallable, Category = "SpearBench")
    double MeasureDirect(int32 Calls, bool bByName);

    UPROPERTY()
    FVector Place = FVector::ZeroVector;
};
