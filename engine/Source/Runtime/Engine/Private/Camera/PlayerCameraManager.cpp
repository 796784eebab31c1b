// SPDX-License-Identifier: MIT
#include "Camera/PlayerCameraManager.h"

#include "Components/SceneComponent.h"
#include "Engine/World.h"
#include "GameFramework/Controller.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/PlayerState.h"

void FTViewTarget::SetNewTarget(AActor* NewTarget) { Target = NewTarget; }

APawn* FTViewTarget::GetTargetPawn() const {
    if (APawn* Pawn = Cast<APawn>(Target.Get())) {
        return Pawn;
    }
    const AController* Controller = Cast<AController>(Target.Get());
    return Controller ? Controller->GetPawn() : nullptr;
}

void FTViewTarget::CheckViewTarget(APlayerController* OwningController) {
    if (IsValid(Target) && !Target->IsActorBeingDestroyed()) {
        return;
    }
    APawn* Pawn = OwningController->GetPawn();
    SetNewTarget(IsValid(Pawn) && !Pawn->IsActorBeingDestroyed() ? static_cast<AActor*>(Pawn) : OwningController);
}

float FViewTargetTransitionParams::GetBlendAlpha(const float& TimePct) const {
    switch (BlendFunction) {
    case VTBlend_Linear:
        return FMath::Lerp(0.f, 1.f, TimePct);
    case VTBlend_Cubic:
        return FMath::CubicInterp(0.f, 0.f, 1.f, 0.f, TimePct);
    case VTBlend_EaseIn:
        return FMath::Lerp(0.f, 1.f, FMath::Pow(TimePct, BlendExp));
    case VTBlend_EaseOut:
        return FMath::Lerp(0.f, 1.f, FMath::Pow(TimePct, FMath::IsNearlyZero(BlendExp) ? 1.f : 1.f / BlendExp));
    case VTBlend_EaseInOut:
        return FMath::InterpEaseInOut(0.f, 1.f, TimePct, BlendExp);
    default:
        return 1.f;
    }
}

APlayerCameraManager::APlayerCameraManager(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    DefaultFOV = 90.f;
    LockedFOV = 0.f;
    BlendTimeToGo = 0.f;
    ViewPitchMin = -89.9f;
    ViewPitchMax = 89.9f;
    ViewYawMin = 0.f;
    ViewYawMax = 359.999f;
    ViewRollMin = -89.9f;
    ViewRollMax = 89.9f;
    SetHidden(true);
    USceneComponent* Transform = CreateDefaultSubobject<USceneComponent>(FName(TEXT("TransformComponent0")));
    RootComponent = Transform;
}

void APlayerCameraManager::PostInitializeComponents() { Super::PostInitializeComponents(); }

void APlayerCameraManager::Destroyed() {
    if (PCOwner && PCOwner->PlayerCameraManager == this) {
        PCOwner->PlayerCameraManager = nullptr;
    }
    Super::Destroyed();
}

void APlayerCameraManager::InitializeFor(APlayerController* PC) {
    FMinimalViewInfo DefaultView = CameraCachePrivate.POV;
    DefaultView.FOV = DefaultFOV;
    FillCameraCache(DefaultView);
    PCOwner = PC;
    SetViewTarget(PC);
    UpdateCamera(0.f);
}

APlayerController* APlayerCameraManager::GetOwningPlayerController() const { return PCOwner; }

AActor* APlayerCameraManager::GetViewTarget() const {
    // During a blend the pending target is what is asked for already.
    if (PendingViewTarget.Target && BlendTimeToGo > 0.f) {
        return PendingViewTarget.Target;
    }
    return ViewTarget.Target;
}

void APlayerCameraManager::SetViewTarget(AActor* NewViewTarget, FViewTargetTransitionParams TransitionParams) {
    if (!NewViewTarget) {
        NewViewTarget = PCOwner;
    }
    if (!NewViewTarget || (NewViewTarget == ViewTarget.Target && !PendingViewTarget.Target) ||
        NewViewTarget == PendingViewTarget.Target) {
        return;
    }
    AActor* OldTarget = GetViewTarget();
    BlendParams = TransitionParams;
    if (TransitionParams.BlendTime > 0.f && ViewTarget.Target) {
        BlendTimeToGo = TransitionParams.BlendTime;
        PendingViewTarget.SetNewTarget(NewViewTarget);
        PendingViewTarget.POV = ViewTarget.POV;
    } else {
        BlendTimeToGo = 0.f;
        PendingViewTarget.SetNewTarget(nullptr);
        ViewTarget.SetNewTarget(NewViewTarget);
    }
    if (OldTarget && OldTarget != NewViewTarget && IsValid(OldTarget)) {
        OldTarget->EndViewTarget(PCOwner);
    }
    NewViewTarget->BecomeViewTarget(PCOwner);
}

void APlayerCameraManager::UpdateViewTarget(FTViewTarget& OutVT, float DeltaTime) {
    OutVT.POV.FOV = DefaultFOV;
    OutVT.POV.ProjectionMode = ECameraProjectionMode::Perspective;
    OutVT.Target->CalcCamera(DeltaTime, OutVT.POV);
    if (LockedFOV > 0.f) {
        OutVT.POV.FOV = LockedFOV;
    }
    SetActorLocationAndRotation(OutVT.POV.Location, OutVT.POV.Rotation);
}

void APlayerCameraManager::UpdateCamera(float DeltaTime) {
    if (!PCOwner) {
        return;
    }
    ViewTarget.CheckViewTarget(PCOwner);
    const bool bLocked = PendingViewTarget.Target && BlendParams.bLockOutgoing;
    if (!bLocked) {
        UpdateViewTarget(ViewTarget, DeltaTime);
    }
    FMinimalViewInfo NewView = ViewTarget.POV;

    if (PendingViewTarget.Target) {
        BlendTimeToGo -= DeltaTime;
        PendingViewTarget.CheckViewTarget(PCOwner);
        UpdateViewTarget(PendingViewTarget, DeltaTime);
        if (BlendTimeToGo > 0.f) {
            const float DurationPct = (BlendParams.BlendTime - BlendTimeToGo) / BlendParams.BlendTime;
            NewView.BlendViewInfo(PendingViewTarget.POV, BlendParams.GetBlendAlpha(DurationPct));
        } else {
            ViewTarget = PendingViewTarget;
            PendingViewTarget.SetNewTarget(nullptr);
            BlendTimeToGo = 0.f;
            NewView = ViewTarget.POV;
        }
    }
    FillCameraCache(NewView);
}

void APlayerCameraManager::FillCameraCache(const FMinimalViewInfo& NewInfo) {
    const float Now = GetWorld() ? static_cast<float>(GetWorld()->GetTimeSeconds()) : 0.f;
    if (CameraCachePrivate.TimeStamp != Now) {
        LastFrameCameraCachePrivate = CameraCachePrivate;
    }
    CameraCachePrivate.POV = NewInfo;
    CameraCachePrivate.TimeStamp = Now;
}

void APlayerCameraManager::GetCameraViewPoint(FVector& OutCamLoc, FRotator& OutCamRot) const {
    OutCamLoc = CameraCachePrivate.POV.Location;
    OutCamRot = CameraCachePrivate.POV.Rotation;
}

FRotator APlayerCameraManager::GetCameraRotation() const { return CameraCachePrivate.POV.Rotation; }

FVector APlayerCameraManager::GetCameraLocation() const { return CameraCachePrivate.POV.Location; }

float APlayerCameraManager::GetFOVAngle() const { return LockedFOV > 0.f ? LockedFOV : CameraCachePrivate.POV.FOV; }

void APlayerCameraManager::SetFOV(float NewFOV) { LockedFOV = NewFOV; }

void APlayerCameraManager::UnlockFOV() { LockedFOV = 0.f; }

void APlayerCameraManager::ProcessViewRotation(float, FRotator& OutViewRotation, FRotator& OutDeltaRot) {
    OutViewRotation += OutDeltaRot;
    OutDeltaRot = FRotator::ZeroRotator;
    OutViewRotation.Pitch =
        FMath::ClampAngle(OutViewRotation.Pitch, static_cast<double>(ViewPitchMin), static_cast<double>(ViewPitchMax));
    OutViewRotation.Yaw =
        FMath::ClampAngle(OutViewRotation.Yaw, static_cast<double>(ViewYawMin), static_cast<double>(ViewYawMax));
    OutViewRotation.Roll =
        FMath::ClampAngle(OutViewRotation.Roll, static_cast<double>(ViewRollMin), static_cast<double>(ViewRollMax));
}
