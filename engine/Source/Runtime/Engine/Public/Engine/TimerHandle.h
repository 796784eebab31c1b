// SPDX-License-Identifier: MIT
/** @file Handle of a timer. Mirrors UE's Engine/TimerHandle.h. */
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "TimerHandle.generated.h"

/**
 * Unique handle that can be used to distinguish timers that have identical delegates.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FTimerHandle
 */
USTRUCT(BlueprintType)
struct FTimerHandle {
    GENERATED_BODY()

    friend class FTimerManager;

    FTimerHandle() : Handle(0) {}

    /** True if this handle was ever initialized by the timer manager. */
    bool IsValid() const { return Handle != 0; }
    /** Explicitly clears the handle; the timer itself goes on. */
    void Invalidate() { Handle = 0; }

    bool operator==(const FTimerHandle& Other) const { return Handle == Other.Handle; }
    bool operator!=(const FTimerHandle& Other) const { return Handle != Other.Handle; }

    /** Text for logs. */
    FString ToString() const { return FString::Printf(TEXT("%llu"), static_cast<unsigned long long>(Handle)); }

    friend uint32 GetTypeHash(const FTimerHandle& InHandle) { return GetTypeHash(InHandle.Handle); }

private:
    /** Serial number of the timer; 0 is no timer. */
    UPROPERTY(Transient)
    uint64 Handle;
};
