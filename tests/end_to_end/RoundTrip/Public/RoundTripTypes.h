// SPDX-License-Identifier: MIT
#pragma once

// Enums, structs, delegates and the interface that the round-trip classes are made of.

#include "CoreMinimal.h"
#include "UObject/Interface.h"
#include "UObject/Object.h"
#include "UObject/ScriptDelegates.h"

#include "RoundTripTypes.generated.h"

UENUM(BlueprintType)
enum class ERoundTripMode : uint8 {
    Slow,
    Fast,
    Reckless = 7,
};

UENUM(Flags)
enum class ERoundTripBits : uint8 {
    None = 0,
    Left = 1,
    Right = 2,
    Up = 4,
};

UENUM()
enum ERoundTripLegacy {
    RTL_First,
    RTL_Second,
};

DECLARE_DYNAMIC_DELEGATE_OneParam(FRoundTripDelegate, int32, Number);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FRoundTripEvent, int32, Number);

/** Numbers, texts and a nested struct side by side. */
USTRUCT(BlueprintType)
struct ROUNDTRIP_API FRoundTripRecord {
    GENERATED_BODY()

    UPROPERTY(EditAnywhere)
    int32 Count = 3;
    UPROPERTY(EditAnywhere)
    bool bOn = true;
    UPROPERTY(EditAnywhere)
    FString Title = TEXT("untitled");
    UPROPERTY(EditAnywhere)
    FVector Place = FVector::ZeroVector;
    UPROPERTY(EditAnywhere)
    TArray<double> Samples;
    UPROPERTY(EditAnywhere)
    TMap<FName, int32> Scores;
};

/** A struct without members. */
USTRUCT()
struct ROUNDTRIP_API FRoundTripEmpty {
    GENERATED_BODY()
};

UINTERFACE()
class ROUNDTRIP_API URoundTripListener : public UInterface {
    GENERATED_BODY()
};

class ROUNDTRIP_API IRoundTripListener {
    GENERATED_BODY()

public:
    UFUNCTION(BlueprintNativeEvent)
    void Hear(int32 Number);
};
