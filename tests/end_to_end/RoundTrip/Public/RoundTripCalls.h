// SPDX-License-Identifier: MIT
#pragma once

// Functions and properties with something particular about them: defaults, accessors, overrides, world context, no
// body.

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "RoundTripTypes.h"
#include "UObject/Object.h"

#include "RoundTripCalls.generated.h"

UCLASS()
class ROUNDTRIP_API URoundTripCalls : public UObject {
    GENERATED_BODY()

public:
    /** Every parameter but the first has a default. */
    UFUNCTION(BlueprintCallable, Category = "RoundTrip")
    FString Describe(const FString& Text, int32 Number = 5, double Weight = 0.5, FVector Place = FVector(1, 2, 3),
        bool bLoud = true, ERoundTripMode Mode = ERoundTripMode::Fast, FName Tag = NAME_None,
        const FString& Suffix = TEXT("!"), UObject* Object = nullptr);
    UFUNCTION()
    int32 Needed(int32 First, int32 Second) { return First - Second; }
    /** A return value and two outputs. */
    UFUNCTION()
    bool Split(const FString& Text, FString& Left, FString& Right);
    /** In and out. */
    UFUNCTION()
    void Increment(UPARAM(ref) int32& Value) { ++Value; }
    /** `const T&` carries CPF_OutParm, and is an input all the same. */
    UFUNCTION()
    double Length(const FVector& Vector) { return Vector.Size(); }
    UFUNCTION(BlueprintCallable, Category = "RoundTrip", meta = (WorldContext = "WorldContextObject"))
    static FString WorldName(const UObject* WorldContextObject);
    UFUNCTION(BlueprintCallable, Category = "RoundTrip")
    static int32 Add(int32 A, int32 B) { return A + B; }
    UFUNCTION(BlueprintNativeEvent)
    FString WhoAmI();
    UFUNCTION(BlueprintImplementableEvent)
    void NobodyHome();
    UFUNCTION(BlueprintCallable, CustomThunk, Category = "RoundTrip")
    void Thunked(int32 Number);
    DECLARE_FUNCTION(execThunked);
    /** Collects garbage now, in the middle of a call. */
    UFUNCTION()
    static void CollectNow();
    /** What the C library's allocator has given out to this process. */
    UFUNCTION()
    static int64 AllocatedBytes();
    UFUNCTION()
    TArray<uint8> Bytes(int64 Count);
    /** 1, 2, 3, ...: tells in which order calls of all clients run. */
    UFUNCTION()
    static int64 Ticket();
    /** How often the game thread has asked for memory, if the program counts that (tests/allocations); else -1. */
    UFUNCTION()
    static int64 Allocations();
    /** Runs no frame any more, like a modal dialog: makes the file "began" in the folder, returns when it has a file
     * "go". */
    UFUNCTION()
    static void BlockFrames(const FString& Folder);
    /** Names that mean something else in Python: of the function and of its parameters. */
    UFUNCTION()
    int32 async(int32 is, int32 lambda) { return is - lambda; }
    /** A name that clients have a function of their own for. */
    UFUNCTION()
    FString call() { return TEXT("called"); }
    /** The same as a variable. */
    UPROPERTY()
    int32 get = 17;
    /** Two actors as they are given; a null one is no error here. */
    UFUNCTION()
    bool Pair(AActor* First, AActor* Second, AActor*& OutFirst, AActor*& OutSecond);

    /** Kept within 0 and 10 by its setter. */
    UPROPERTY(EditAnywhere, Getter, Setter)
    double Guarded = 1.0;
    double GetGuarded() const;
    void SetGuarded(double NewGuarded);
    /** Its setter rounds every member. */
    UPROPERTY(EditAnywhere, Setter)
    FVector Snapped = FVector::ZeroVector;
    void SetSnapped(const FVector& NewSnapped);
    UPROPERTY()
    int32 SetterCalls = 0;
    UPROPERTY(BlueprintReadOnly, Category = "RoundTrip")
    int32 ReadByBlueprints = 0;
    UPROPERTY()
    TObjectPtr<URoundTripCalls> Other;
    UPROPERTY()
    TMap<FString, FRoundTripRecord> Records;
    UPROPERTY()
    TArray<FRoundTripRecord> List;
};

UCLASS()
class ROUNDTRIP_API URoundTripCallsChild : public URoundTripCalls {
    GENERATED_BODY()

public:
    virtual FString WhoAmI_Implementation() override { return TEXT("child"); }
};
