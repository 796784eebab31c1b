// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/MovementComponent.h"
#include "UObject/ObjectMacros.h"

#include "InterpToMovementComponent.generated.h"

/** What happens at the end of the path. Epic page: EInterpToBehaviourType. */
UENUM(BlueprintType)
enum class EInterpToBehaviourType : uint8 {
    /** Move to the last control point and stop. */
    OneShot UMETA(DisplayName = "One shot"),
    /** Move to the last control point, then back to the first, and stop. */
    OneShot_Reverse UMETA(DisplayName = "One shot reverse"),
    /** Move to the last control point, jump to the first, and so on. */
    Loop_Reset UMETA(DisplayName = "Loop reset"),
    /** Move to and fro. */
    PingPong UMETA(DisplayName = "Ping Pong")
};

/** One point of the path. Epic page: FInterpControlPoint. */
USTRUCT(BlueprintType)
struct FInterpControlPoint {
    GENERATED_BODY()

    /** Location of the control point, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ControlPoint)
    FVector PositionControlPoint;

    /** Whether the position is relative to where the component started, or absolute. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ControlPoint)
    bool bPositionIsRelative;

    /** Distance from the start of the path, by which time is distributed; filled when the path is made. */
    float Percentage = 0.0f;
    /** Share of the path's length that the segment from here to the next point has. */
    float DistanceToNext = 0.0f;

    FInterpControlPoint() : PositionControlPoint(0.0, 0.0, 0.0), bPositionIsRelative(false) {}
    FInterpControlPoint(FVector InPosition, bool bIsRelative)
        : PositionControlPoint(InPosition), bPositionIsRelative(bIsRelative) {}
};

/** Broadcast when the component changes direction, at a time along the path (0 to 1). */
DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(FOnInterpToReverseDelegate, const FHitResult&, ImpactResult, float, Time);
/** Broadcast when the component jumps back to the start. */
DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(FOnInterpToResetDelegate, const FHitResult&, ImpactResult, float, Time);
/** Broadcast when the component stops at the end. */
DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(FOnInterpToStopDelegate, const FHitResult&, ImpactResult, float, Time);

/** Moves the updated component along a path of control points at a constant speed. Epic page:
 * UInterpToMovementComponent. */
UCLASS(ClassGroup = Movement, meta = (BlueprintSpawnableComponent), HideCategories = Velocity)
class ENGINE_API UInterpToMovementComponent : public UMovementComponent {
    GENERATED_BODY()

public:
    /** How long to take to move from the first point to the last, in seconds. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Control)
    float Duration;

    /** What happens at the end of the path. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Behaviour)
    EInterpToBehaviourType BehaviourType;

    /** The points of the path. FinaliseControlPoints must run after changing them. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ControlPoints)
    TArray<FInterpControlPoint> ControlPoints;

    /** Called when the component changes direction. */
    UPROPERTY(BlueprintAssignable)
    FOnInterpToReverseDelegate OnInterpToReverse;

    /** Called when the component jumps back to the start. */
    UPROPERTY(BlueprintAssignable)
    FOnInterpToResetDelegate OnInterpToReset;

    /** Called when the component stops. */
    UPROPERTY(BlueprintAssignable)
    FOnInterpToStopDelegate OnInterpToStop;

    UInterpToMovementComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Starts again from the first point (direction 1) or from the last one backwards (direction -1). */
    UFUNCTION(BlueprintCallable, Category = "Game|Components|InterpToMovement")
    void RestartMovement(float InitialDirection = 1.0f);

    /** Adds a control point to the end of the path. */
    UFUNCTION(BlueprintCallable, Category = "Game|Components|InterpToMovement")
    virtual void AddControlPointPosition(FVector Pos, bool bPositionIsRelative = true);

    /** Removes all control points. */
    UFUNCTION(BlueprintCallable, Category = "Game|Components|InterpToMovement")
    virtual void ResetControlPoints();

    /** Computes the lengths after the control points were added. */
    UFUNCTION(BlueprintCallable, Category = "Game|Components|InterpToMovement")
    virtual void FinaliseControlPoints();

    // UMovementComponent
    virtual void BeginPlay() override;
    virtual void TickComponent(
        float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override;

private:
    FVector PointAt(int32 Index) const;
    FVector PositionAt(float Time) const;
    void Advance(float DeltaTime);

    FVector StartLocation;
    float CurrentTime;
    float CurrentDirection;
    bool bStopped;
};
