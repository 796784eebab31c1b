// SPDX-License-Identifier: MIT
#include "Engine/HitResult.h"

#include "Components/PrimitiveComponent.h"
#include "GameFramework/Actor.h"

FHitResult::FHitResult(
    AActor* InActor, UPrimitiveComponent* InComponent, const FVector& HitLoc, const FVector& HitNorm) {
    Init();
    Location = ImpactPoint = HitLoc;
    Normal = ImpactNormal = HitNorm;
    HitObjectHandle = FActorInstanceHandle(InActor);
    Component = InComponent;
}

void FHitResult::Init() {
    FaceIndex = INDEX_NONE;
    Time = 1.f;
    Distance = 0.f;
    Location = FVector::ZeroVector;
    ImpactPoint = FVector::ZeroVector;
    Normal = FVector::ZeroVector;
    ImpactNormal = FVector::ZeroVector;
    TraceStart = FVector::ZeroVector;
    TraceEnd = FVector::ZeroVector;
    PenetrationDepth = 0.f;
    MyItem = INDEX_NONE;
    Item = INDEX_NONE;
    ElementIndex = 0;
    bBlockingHit = false;
    bStartPenetrating = false;
    HitObjectHandle = FActorInstanceHandle();
    Component = nullptr;
    BoneName = NAME_None;
    MyBoneName = NAME_None;
}

void FHitResult::Reset(float InTime, bool bPreserveTraceData) {
    const FVector Start = TraceStart;
    const FVector End = TraceEnd;
    Init();
    Time = InTime;
    if (bPreserveTraceData) {
        TraceStart = Start;
        TraceEnd = End;
    }
}

int32 FHitResult::GetFirstBlockingHit(const TArray<FHitResult>& InHits) {
    for (int32 Index = 0; Index < InHits.Num(); ++Index) {
        if (InHits[Index].bBlockingHit) {
            return Index;
        }
    }
    return INDEX_NONE;
}

FHitResult* FHitResult::GetFirstBlockingHit(TArray<FHitResult>& InHits, int32& OutIndex) {
    OutIndex = GetFirstBlockingHit(InHits);
    return OutIndex == INDEX_NONE ? nullptr : &InHits[OutIndex];
}

FHitResult FHitResult::GetReversedHit(const FHitResult& Hit) {
    FHitResult Result(Hit);
    Result.Normal = FVector(-Hit.Normal);
    Result.ImpactNormal = FVector(-Hit.ImpactNormal);
    Result.Item = Hit.MyItem;
    Result.MyItem = Hit.Item;
    Result.BoneName = Hit.MyBoneName;
    Result.MyBoneName = Hit.BoneName;
    return Result;
}

FString FHitResult::ToString() const {
    return FString::Printf(TEXT("bBlockingHit:%s bStartPenetrating:%s Time:%f Location:%s ImpactPoint:%s Normal:%s "
                                "ImpactNormal:%s TraceStart:%s TraceEnd:%s Actor:%s Component:%s"),
        bBlockingHit ? TEXT("True") : TEXT("False"), bStartPenetrating ? TEXT("True") : TEXT("False"), Time,
        *Location.ToString(), *ImpactPoint.ToString(), *Normal.ToString(), *ImpactNormal.ToString(),
        *TraceStart.ToString(), *TraceEnd.ToString(), *GetNameSafe(GetActor()), *GetNameSafe(GetComponent()));
}
