// SPDX-License-Identifier: MIT
/** @file The transform of actors: that of their root component. */
#include "Components/SceneComponent.h"
#include "GameFramework/Actor.h"

namespace {
/** What the K2_ functions report for a move that was not swept. */
FHitResult* SweepResult(bool bSweep, FHitResult& Hit) {
    Hit.Init();
    return bSweep ? &Hit : nullptr;
}
} // namespace

const FTransform& AActor::ActorToWorld() const {
    return RootComponent ? RootComponent->GetComponentTransform() : FTransform::Identity;
}

FVector AActor::GetActorLocation() const {
    return RootComponent ? RootComponent->GetComponentLocation() : FVector::ZeroVector;
}

FVector AActor::K2_GetActorLocation() const { return GetActorLocation(); }

FRotator AActor::GetActorRotation() const {
    return RootComponent ? RootComponent->GetComponentRotation() : FRotator::ZeroRotator;
}

FRotator AActor::K2_GetActorRotation() const { return GetActorRotation(); }

FQuat AActor::GetActorQuat() const { return RootComponent ? RootComponent->GetComponentQuat() : FQuat::Identity; }

FVector AActor::GetActorScale3D() const {
    return RootComponent ? RootComponent->GetComponentScale() : FVector::OneVector;
}

void AActor::SetActorScale3D(FVector NewScale3D) {
    if (RootComponent) {
        RootComponent->SetWorldScale3D(NewScale3D);
    }
}

void AActor::SetActorRelativeScale3D(FVector NewRelativeScale) {
    if (RootComponent) {
        RootComponent->SetRelativeScale3D(NewRelativeScale);
    }
}

FVector AActor::GetActorRelativeScale3D() const {
    return RootComponent ? RootComponent->GetRelativeScale3D() : FVector::OneVector;
}

FVector AActor::GetActorForwardVector() const {
    return RootComponent ? RootComponent->GetForwardVector() : FVector::ForwardVector;
}

FVector AActor::GetActorRightVector() const {
    return RootComponent ? RootComponent->GetRightVector() : FVector::RightVector;
}

FVector AActor::GetActorUpVector() const { return RootComponent ? RootComponent->GetUpVector() : FVector::UpVector; }

FVector AActor::GetVelocity() const {
    return RootComponent ? RootComponent->GetComponentVelocity() : FVector::ZeroVector;
}

// ------------------------------------------------------------------------------------------------------------ set,
// world

bool AActor::SetActorLocation(
    const FVector& NewLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    return SetActorLocationAndRotation(NewLocation, GetActorQuat(), bSweep, OutSweepHitResult, Teleport);
}

bool AActor::K2_SetActorLocation(FVector NewLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    return SetActorLocation(NewLocation, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

bool AActor::SetActorRotation(FRotator NewRotation, ETeleportType Teleport) {
    return SetActorRotation(NewRotation.Quaternion(), Teleport);
}

bool AActor::SetActorRotation(const FQuat& NewRotation, ETeleportType Teleport) {
    return RootComponent &&
           RootComponent->MoveComponent(FVector::ZeroVector, NewRotation, true, nullptr, MOVECOMP_NoFlags, Teleport);
}

bool AActor::K2_SetActorRotation(FRotator NewRotation, bool bTeleportPhysics) {
    return SetActorRotation(NewRotation, TeleportFlagToEnum(bTeleportPhysics));
}

bool AActor::SetActorLocationAndRotation(
    FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    return SetActorLocationAndRotation(NewLocation, NewRotation.Quaternion(), bSweep, OutSweepHitResult, Teleport);
}

bool AActor::SetActorLocationAndRotation(
    FVector NewLocation, const FQuat& NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (!RootComponent) {
        if (OutSweepHitResult) {
            OutSweepHitResult->Init();
        }
        return false;
    }
    return RootComponent->MoveComponent(
        NewLocation - GetActorLocation(), NewRotation, bSweep, OutSweepHitResult, MOVECOMP_NoFlags, Teleport);
}

bool AActor::K2_SetActorLocationAndRotation(
    FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    return SetActorLocationAndRotation(
        NewLocation, NewRotation, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

bool AActor::SetActorTransform(
    const FTransform& NewTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (!RootComponent) {
        return false;
    }
    RootComponent->SetWorldTransform(NewTransform, bSweep, OutSweepHitResult, Teleport);
    return true;
}

bool AActor::K2_SetActorTransform(
    const FTransform& NewTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    return SetActorTransform(NewTransform, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

bool AActor::TeleportTo(const FVector& DestLocation, const FRotator& DestRotation, bool bIsATest, bool) {
    // Nothing can be in the way in a world without collision.
    if (!RootComponent) {
        return false;
    }
    if (!bIsATest) {
        SetActorLocationAndRotation(DestLocation, DestRotation, false, nullptr, ETeleportType::TeleportPhysics);
    }
    return true;
}

bool AActor::K2_TeleportTo(FVector DestLocation, FRotator DestRotation) {
    return TeleportTo(DestLocation, DestRotation);
}

// -------------------------------------------------------------------------------------------------------------------
// add

void AActor::AddActorWorldOffset(
    FVector DeltaLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddWorldOffset(DeltaLocation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_AddActorWorldOffset(FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    AddActorWorldOffset(DeltaLocation, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

void AActor::AddActorWorldRotation(
    FRotator DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddWorldRotation(DeltaRotation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::AddActorWorldRotation(
    const FQuat& DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddWorldRotation(DeltaRotation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_AddActorWorldRotation(FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    AddActorWorldRotation(DeltaRotation, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

void AActor::AddActorWorldTransform(
    const FTransform& DeltaTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddWorldTransform(DeltaTransform, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_AddActorWorldTransform(
    const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    AddActorWorldTransform(DeltaTransform, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

void AActor::AddActorWorldTransformKeepScale(
    const FTransform& DeltaTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddWorldTransformKeepScale(DeltaTransform, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_AddActorWorldTransformKeepScale(
    const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    AddActorWorldTransformKeepScale(
        DeltaTransform, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

void AActor::AddActorLocalOffset(
    FVector DeltaLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddLocalOffset(DeltaLocation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_AddActorLocalOffset(FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    AddActorLocalOffset(DeltaLocation, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

void AActor::AddActorLocalRotation(
    FRotator DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddLocalRotation(DeltaRotation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::AddActorLocalRotation(
    const FQuat& DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddLocalRotation(DeltaRotation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_AddActorLocalRotation(FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    AddActorLocalRotation(DeltaRotation, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

void AActor::AddActorLocalTransform(
    const FTransform& NewTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->AddLocalTransform(NewTransform, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_AddActorLocalTransform(
    const FTransform& NewTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    AddActorLocalTransform(NewTransform, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

// --------------------------------------------------------------------------------------------------------- set,
// relative

void AActor::SetActorRelativeLocation(
    FVector NewRelativeLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->SetRelativeLocation(NewRelativeLocation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_SetActorRelativeLocation(
    FVector NewRelativeLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SetActorRelativeLocation(
        NewRelativeLocation, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

void AActor::SetActorRelativeRotation(
    FRotator NewRelativeRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->SetRelativeRotation(NewRelativeRotation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::SetActorRelativeRotation(
    const FQuat& NewRelativeRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->SetRelativeRotation(NewRelativeRotation, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_SetActorRelativeRotation(
    FRotator NewRelativeRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SetActorRelativeRotation(
        NewRelativeRotation, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

void AActor::SetActorRelativeTransform(
    const FTransform& NewRelativeTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (RootComponent) {
        RootComponent->SetRelativeTransform(NewRelativeTransform, bSweep, OutSweepHitResult, Teleport);
    } else if (OutSweepHitResult) {
        OutSweepHitResult->Init();
    }
}

void AActor::K2_SetActorRelativeTransform(
    const FTransform& NewRelativeTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SetActorRelativeTransform(
        NewRelativeTransform, bSweep, SweepResult(bSweep, SweepHitResult), TeleportFlagToEnum(bTeleport));
}

// -------------------------------------------------------------------------------------------------------------
// distances

float AActor::GetSquaredDistanceTo(const AActor* OtherActor) const {
    return OtherActor ? static_cast<float>((GetActorLocation() - OtherActor->GetActorLocation()).SizeSquared()) : 0.f;
}

float AActor::GetDistanceTo(const AActor* OtherActor) const {
    return OtherActor ? static_cast<float>((GetActorLocation() - OtherActor->GetActorLocation()).Size()) : 0.f;
}

float AActor::GetSquaredHorizontalDistanceTo(const AActor* OtherActor) const {
    return OtherActor ? static_cast<float>((GetActorLocation() - OtherActor->GetActorLocation()).SizeSquared2D()) : 0.f;
}

float AActor::GetHorizontalDistanceTo(const AActor* OtherActor) const {
    return OtherActor ? static_cast<float>((GetActorLocation() - OtherActor->GetActorLocation()).Size2D()) : 0.f;
}

float AActor::GetVerticalDistanceTo(const AActor* OtherActor) const {
    return OtherActor ? static_cast<float>(FMath::Abs(GetActorLocation().Z - OtherActor->GetActorLocation().Z)) : 0.f;
}

float AActor::GetDotProductTo(const AActor* OtherActor) const {
    if (!OtherActor) {
        return -2.f;
    }
    const FVector Direction = (OtherActor->GetActorLocation() - GetActorLocation()).GetSafeNormal();
    return static_cast<float>(FVector::DotProduct(GetActorForwardVector(), Direction));
}

float AActor::GetHorizontalDotProductTo(const AActor* OtherActor) const {
    if (!OtherActor) {
        return -2.f;
    }
    const FVector Direction = (OtherActor->GetActorLocation() - GetActorLocation()).GetSafeNormal2D();
    return static_cast<float>(FVector::DotProduct(GetActorForwardVector().GetSafeNormal2D(), Direction));
}
