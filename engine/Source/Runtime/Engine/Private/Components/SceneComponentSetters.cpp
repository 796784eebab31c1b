// SPDX-License-Identifier: MIT
// The setters of USceneComponent: each works out the wanted transform and moves the component there.
#include "Components/SceneComponent.h"

namespace {

// 1 / scale, and 0 where the scale is 0: nothing can be scaled back from there.
FVector SafeReciprocal(const FVector& Scale) {
    return FVector(Scale.X != 0.0 ? 1.0 / Scale.X : 0.0, Scale.Y != 0.0 ? 1.0 / Scale.Y : 0.0,
        Scale.Z != 0.0 ? 1.0 / Scale.Z : 0.0);
}

} // namespace

// ------------------------------------------------------------------------------------------------------------ relative

void USceneComponent::SetRelativeLocationAndRotation(
    FVector NewLocation, const FQuat& NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    const FTransform Wanted = CalcNewComponentToWorld(FTransform(NewRotation, NewLocation, RelativeScale3D));
    MoveComponent(Wanted.GetLocation() - ComponentToWorld.GetLocation(), Wanted.GetRotation(), bSweep,
        OutSweepHitResult, MOVECOMP_NoFlags, Teleport);
}

void USceneComponent::SetRelativeLocationAndRotation(
    FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeLocationAndRotation(NewLocation, RememberedQuat(NewRotation), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::SetRelativeLocation(
    FVector NewLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeLocationAndRotation(NewLocation, GetRelativeQuat(), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::SetRelativeRotation(
    FRotator NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeLocationAndRotation(RelativeLocation, RememberedQuat(NewRotation), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::SetRelativeRotation(
    const FQuat& NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeLocationAndRotation(RelativeLocation, NewRotation, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::SetRelativeTransform(
    const FTransform& NewTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeLocationAndRotation(
        NewTransform.GetLocation(), NewTransform.GetRotation(), bSweep, OutSweepHitResult, Teleport);
    SetRelativeScale3D(NewTransform.GetScale3D());
}

void USceneComponent::ResetRelativeTransform() {
    SetRelativeTransform(FTransform(FQuat(0.0, 0.0, 0.0, 1.0), FVector(0.0, 0.0, 0.0), FVector(1.0, 1.0, 1.0)));
}

void USceneComponent::SetRelativeScale3D(FVector NewScale3D) {
    if (NewScale3D == RelativeScale3D &&
        ComponentToWorld.GetScale3D() == CalcNewComponentToWorld(GetRelativeTransform()).GetScale3D()) {
        return;
    }
    RelativeScale3D = NewScale3D;
    UpdateComponentToWorld();
}

void USceneComponent::AddRelativeLocation(
    FVector DeltaLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeLocation(RelativeLocation + DeltaLocation, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddRelativeRotation(
    FRotator DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeRotation(RelativeRotation + DeltaRotation, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddRelativeRotation(
    const FQuat& DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeRotation(DeltaRotation * GetRelativeQuat(), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddLocalOffset(
    FVector DeltaLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeLocation(
        RelativeLocation + GetRelativeQuat().RotateVector(DeltaLocation), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddLocalRotation(
    FRotator DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeRotation(GetRelativeQuat() * DeltaRotation.Quaternion(), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddLocalRotation(
    const FQuat& DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetRelativeRotation(GetRelativeQuat() * DeltaRotation, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddLocalTransform(
    const FTransform& DeltaTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    const FTransform Wanted = DeltaTransform * GetRelativeTransform();
    SetRelativeLocationAndRotation(Wanted.GetLocation(), Wanted.GetRotation(), bSweep, OutSweepHitResult, Teleport);
}

// --------------------------------------------------------------------------------------------------------------- world

void USceneComponent::SetWorldLocationAndRotation(
    FVector NewLocation, const FQuat& NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    MoveComponent(NewLocation - ComponentToWorld.GetLocation(), NewRotation, bSweep, OutSweepHitResult,
        MOVECOMP_NoFlags, Teleport);
}

void USceneComponent::SetWorldLocationAndRotation(
    FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    SetWorldLocationAndRotation(NewLocation,
        AttachParent && !bAbsoluteRotation ? NewRotation.Quaternion() : RememberedQuat(NewRotation), bSweep,
        OutSweepHitResult, Teleport);
}

void USceneComponent::SetWorldLocation(
    FVector NewLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    SetWorldLocationAndRotation(NewLocation, ComponentToWorld.GetRotation(), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::SetWorldRotation(
    FRotator NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    SetWorldLocationAndRotation(ComponentToWorld.GetLocation(), NewRotation, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::SetWorldRotation(
    const FQuat& NewRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    SetWorldLocationAndRotation(ComponentToWorld.GetLocation(), NewRotation, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::SetWorldScale3D(FVector NewScale) {
    if (AttachParent && !bAbsoluteScale) {
        const FVector Inverse = SafeReciprocal(AttachParent->GetSocketTransform(AttachSocketName).GetScale3D());
        NewScale = FVector(NewScale.X * Inverse.X, NewScale.Y * Inverse.Y, NewScale.Z * Inverse.Z);
    }
    SetRelativeScale3D(NewScale);
}

void USceneComponent::SetWorldTransform(
    const FTransform& NewTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    if (!AttachParent) {
        SetRelativeTransform(NewTransform, bSweep, OutSweepHitResult, Teleport);
        return;
    }
    FTransform Relative = NewTransform.GetRelativeTransform(AttachParent->GetSocketTransform(AttachSocketName));
    if (bAbsoluteLocation) {
        Relative.SetLocation(NewTransform.GetLocation());
    }
    if (bAbsoluteRotation) {
        Relative.SetRotation(NewTransform.GetRotation());
    }
    if (bAbsoluteScale) {
        Relative.SetScale3D(NewTransform.GetScale3D());
    }
    SetRelativeTransform(Relative, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddWorldOffset(
    FVector DeltaLocation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    SetWorldLocation(ComponentToWorld.GetLocation() + DeltaLocation, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddWorldRotation(
    FRotator DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    AddWorldRotation(DeltaRotation.Quaternion(), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddWorldRotation(
    const FQuat& DeltaRotation, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    SetWorldRotation(DeltaRotation * ComponentToWorld.GetRotation(), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddWorldTransform(
    const FTransform& DeltaTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    const FQuat Rotation = DeltaTransform.GetRotation() * ComponentToWorld.GetRotation();
    const FVector Location = DeltaTransform.GetLocation() + ComponentToWorld.GetLocation();
    SetWorldTransform(FTransform(Rotation, Location, FVector(1.0, 1.0, 1.0)), bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::AddWorldTransformKeepScale(
    const FTransform& DeltaTransform, bool bSweep, FHitResult* OutSweepHitResult, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    const FQuat Rotation = DeltaTransform.GetRotation() * ComponentToWorld.GetRotation();
    const FVector Location = DeltaTransform.GetLocation() + ComponentToWorld.GetLocation();
    SetWorldLocationAndRotation(Location, Rotation, bSweep, OutSweepHitResult, Teleport);
}

void USceneComponent::SetAbsolute(bool bNewAbsoluteLocation, bool bNewAbsoluteRotation, bool bNewAbsoluteScale) {
    bAbsoluteLocation = bNewAbsoluteLocation;
    bAbsoluteRotation = bNewAbsoluteRotation;
    bAbsoluteScale = bNewAbsoluteScale;
    UpdateComponentToWorld();
}

// ------------------------------------------------------------------------------------------- the reflected ones (K2_)

void USceneComponent::K2_SetRelativeLocation(
    FVector NewLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    SetRelativeLocation(NewLocation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_SetRelativeRotation(
    FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    SetRelativeRotation(NewRotation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_SetRelativeLocationAndRotation(
    FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    SetRelativeLocationAndRotation(NewLocation, NewRotation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_SetRelativeTransform(
    const FTransform& NewTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    SetRelativeTransform(NewTransform, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddRelativeLocation(
    FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddRelativeLocation(DeltaLocation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddRelativeRotation(
    FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddRelativeRotation(DeltaRotation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddLocalOffset(
    FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddLocalOffset(DeltaLocation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddLocalRotation(
    FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddLocalRotation(DeltaRotation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddLocalTransform(
    const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddLocalTransform(DeltaTransform, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_SetWorldLocation(
    FVector NewLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    SetWorldLocation(NewLocation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_SetWorldRotation(
    FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    SetWorldRotation(NewRotation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_SetWorldLocationAndRotation(
    FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    SetWorldLocationAndRotation(NewLocation, NewRotation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_SetWorldTransform(
    const FTransform& NewTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    SetWorldTransform(NewTransform, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddWorldOffset(
    FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddWorldOffset(DeltaLocation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddWorldRotation(
    FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddWorldRotation(DeltaRotation, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddWorldTransform(
    const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddWorldTransform(DeltaTransform, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

void USceneComponent::K2_AddWorldTransformKeepScale(
    const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport) {
    SweepHitResult.Reset(1.0f, false);
    AddWorldTransformKeepScale(DeltaTransform, bSweep, &SweepHitResult, TeleportFlagToEnum(bTeleport));
}

FVector USceneComponent::K2_GetComponentLocation() const { return ComponentToWorld.GetLocation(); }

FRotator USceneComponent::K2_GetComponentRotation() const { return ComponentToWorld.Rotator(); }

FVector USceneComponent::K2_GetComponentScale() const { return ComponentToWorld.GetScale3D(); }

FTransform USceneComponent::K2_GetComponentToWorld() const { return ComponentToWorld; }

FVector USceneComponent::GetForwardVector() const {
    return ComponentToWorld.GetRotation().RotateVector(FVector(1.0, 0.0, 0.0));
}

FVector USceneComponent::GetRightVector() const {
    return ComponentToWorld.GetRotation().RotateVector(FVector(0.0, 1.0, 0.0));
}

FVector USceneComponent::GetUpVector() const {
    return ComponentToWorld.GetRotation().RotateVector(FVector(0.0, 0.0, 1.0));
}
