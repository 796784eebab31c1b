// SPDX-License-Identifier: MIT
/** @file Result of a trace or a sweep. Mirrors UE's Engine/HitResult.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/ActorInstanceHandle.h"
#include "Engine/NetSerialization.h"
#include "UObject/Class.h"
#include "UObject/WeakObjectPtrTemplates.h"

#include "HitResult.generated.h"

class AActor;
class UPrimitiveComponent;

/**
 * Structure containing information about one hit of a trace, such as point of impact and surface normal at that point.
 * Lengths in centimetres.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FHitResult
 */
USTRUCT(BlueprintType, meta = (HasNativeBreak = "/Script/Engine.GameplayStatics.BreakHitResult",
                           HasNativeMake = "/Script/Engine.GameplayStatics.MakeHitResult"))
struct FHitResult {
    GENERATED_BODY()

    /** Face index we hit (for complex hits with triangle meshes). */
    UPROPERTY()
    int32 FaceIndex;

    /** 'Time' of impact along trace direction (ranging from 0.0 to 1.0) if there is a hit, indicating time between
     * TraceStart and TraceEnd. 1 if there was no hit. */
    UPROPERTY()
    float Time;

    /** The distance from the TraceStart to the Location in world space. */
    UPROPERTY()
    float Distance;

    /** The location in world space where the moving shape would end up against the impacted object, if there is a hit.
     * Equal to the point of impact for line tests. */
    UPROPERTY()
    FVector_NetQuantize Location;

    /** Location in world space of the actual contact of the trace shape (box, sphere, ray, etc) with the impacted
     * object. */
    UPROPERTY()
    FVector_NetQuantize ImpactPoint;

    /** Normal of the hit in world space, for the object that was swept. Equal to ImpactNormal for line tests. */
    UPROPERTY()
    FVector_NetQuantizeNormal Normal;

    /** Normal of the hit in world space, for the object that was hit by the sweep, if any. */
    UPROPERTY()
    FVector_NetQuantizeNormal ImpactNormal;

    /** Start location of the trace. */
    UPROPERTY()
    FVector_NetQuantize TraceStart;

    /** End location of the trace; this is NOT where the impact occurred (if any), but the furthest point in the
     * attempted sweep. */
    UPROPERTY()
    FVector_NetQuantize TraceEnd;

    /** If this test started in penetration (bStartPenetrating is true) and a depenetration vector can be computed, this
     * value is the distance along Normal that will result in moving out of penetration. */
    UPROPERTY()
    float PenetrationDepth;

    /** If the colliding object was part of the moving one: its item, else -1. */
    UPROPERTY()
    int32 MyItem;

    /** Extra data about item that was hit (hit primitive specific). */
    UPROPERTY()
    int32 Item;

    /** Index to item that was hit, also hit primitive specific. */
    UPROPERTY()
    uint8 ElementIndex;

    /** Indicates if this hit was a result of blocking collision. If false, there was no hit or it was an overlap/touch
     * instead. */
    UPROPERTY()
    uint8 bBlockingHit : 1;

    /** Whether the trace started in penetration, i.e. with an initial blocking overlap. */
    UPROPERTY()
    uint8 bStartPenetrating : 1;

    /** Handle to the object hit by the trace. */
    UPROPERTY()
    FActorInstanceHandle HitObjectHandle;

    /** PrimitiveComponent hit by the trace. */
    UPROPERTY()
    TWeakObjectPtr<UPrimitiveComponent> Component;

    /** Name of bone we hit (for skeletal meshes). */
    UPROPERTY()
    FName BoneName;

    /** Name of the _my_ bone which took part in hit event (in case of two skeletal meshes colliding). */
    UPROPERTY()
    FName MyBoneName;

    /** No hit, Time 1. */
    FHitResult() { Init(); }
    explicit FHitResult(float InTime) {
        Init();
        Time = InTime;
    }
    explicit FHitResult(EForceInit) { Init(); }
    FHitResult(const FVector& Start, const FVector& End) { Init(Start, End); }
    /** Hit of a component at a point with a normal. */
    ENGINE_API FHitResult(
        AActor* InActor, UPrimitiveComponent* InComponent, const FVector& HitLoc, const FVector& HitNorm);

    /** Sets everything to "no hit". */
    ENGINE_API void Init();
    /** Sets everything to "no hit" of a trace from Start to End. */
    void Init(const FVector& Start, const FVector& End) {
        Init();
        TraceStart = Start;
        TraceEnd = End;
    }

    /** Resets hit result while optionally saving the TraceStart and TraceEnd. */
    ENGINE_API void Reset(float InTime = 1.f, bool bPreserveTraceData = true);

    /** The actor that owns the hit component, or null. */
    AActor* GetActor() const { return HitObjectHandle.FetchActor(); }
    /** The component that was hit, or null. */
    UPrimitiveComponent* GetComponent() const { return Component.Get(); }
    /** The handle of the object that was hit. */
    FActorInstanceHandle GetHitObjectHandle() const { return HitObjectHandle; }
    /** Whether there was an actual blocking hit that did not start in penetration. */
    bool IsValidBlockingHit() const { return bBlockingHit && !bStartPenetrating; }

    /** Index of the first blocking hit, or INDEX_NONE. */
    static ENGINE_API int32 GetFirstBlockingHit(const TArray<FHitResult>& InHits);
    /** The first blocking hit, or null. */
    static ENGINE_API FHitResult* GetFirstBlockingHit(TArray<FHitResult>& InHits, int32& OutIndex);
    /** A copy with start and end, normals and locations reversed. */
    static ENGINE_API FHitResult GetReversedHit(const FHitResult& Hit);

    /** Text for logs. */
    ENGINE_API FString ToString() const;
};
