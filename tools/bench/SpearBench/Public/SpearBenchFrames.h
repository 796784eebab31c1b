// SPDX-License-Identifier: MIT
#pragma once

// What `spear bench frames` and the tests of robustness look at: which frame an operation ran in, frames with work, and
// a log of all frames that other processes read while the engine runs.

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "Kismet/BlueprintFunctionLibrary.h"

#include "SpearBenchFrames.generated.h"

/** The frame log: with -SpearBenchFrameLog=PATH the engine makes this file, maps it, and notes each frame in it.
 * All numbers are little-endian; the clock is the monotonic one of the machine (CLOCK_MONOTONIC), in nanoseconds. */
struct FSpearFrameLog {
    /** One frame. */
    struct FEntry {
        uint64 Frame;     ///< GFrameCounter
        int64 BeginNs;    ///< when it began
        int64 EndNs;      ///< when its work was done; 0 while it lasts
        int64 SleepEndNs; ///< when the world began to tick: the pause that keeps the frame rate lies before
    };
    static constexpr uint64 NumEntries = 1u << 16;

    uint64 NumFrames; ///< frames ever noted; number N lies at N modulo NumEntries. Written after the entry
    uint64 Reserved[3];
    FEntry Entries[NumEntries];
};

UCLASS()
class SPEARBENCH_API USpearBenchFrames : public UBlueprintFunctionLibrary {
    GENERATED_BODY()

public:
    /** The engine's frame counter, now. */
    UFUNCTION(BlueprintCallable, Category = "SpearBench")
    static int64 Frame();

    /** Keeps the game thread busy for so many milliseconds. */
    UFUNCTION(BlueprintCallable, Category = "SpearBench")
    static void Work(double Milliseconds);
};

/** Something in the scene that takes time in each frame. */
UCLASS()
class SPEARBENCH_API ASpearBenchLoad : public AActor {
    GENERATED_BODY()

public:
    ASpearBenchLoad();
    virtual void Tick(float DeltaSeconds) override;

    /** Milliseconds of computation in each frame. */
    UPROPERTY(EditAnywhere, Category = "SpearBench")
    double Milliseconds = 0;
};
