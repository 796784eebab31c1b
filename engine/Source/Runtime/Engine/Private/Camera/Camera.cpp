// SPDX-License-Identifier: MIT
#include "Camera/CameraActor.h"
#include "Camera/CameraComponent.h"
#include "Camera/CameraTypes.h"

#include "GameFramework/Controller.h"
#include "GameFramework/Pawn.h"

#include <cmath>

// -----------------------------------------------------------------------------------------------------------------------
// view

bool FMinimalViewInfo::Equals(const FMinimalViewInfo& OtherInfo) const {
    constexpr float Tolerance = 1.e-4f;
    return Location.Equals(OtherInfo.Location, Tolerance) && Rotation.Equals(OtherInfo.Rotation, Tolerance) &&
           std::fabs(FOV - OtherInfo.FOV) <= Tolerance && std::fabs(OrthoWidth - OtherInfo.OrthoWidth) <= Tolerance &&
           std::fabs(OrthoNearClipPlane - OtherInfo.OrthoNearClipPlane) <= Tolerance &&
           std::fabs(OrthoFarClipPlane - OtherInfo.OrthoFarClipPlane) <= Tolerance &&
           std::fabs(AspectRatio - OtherInfo.AspectRatio) <= Tolerance &&
           bConstrainAspectRatio == OtherInfo.bConstrainAspectRatio && ProjectionMode == OtherInfo.ProjectionMode;
}

void FMinimalViewInfo::BlendViewInfo(FMinimalViewInfo& OtherInfo, float OtherWeight) {
    Location = Location + (OtherInfo.Location - Location) * static_cast<double>(OtherWeight);
    const FRotator Delta = (OtherInfo.Rotation - Rotation).GetNormalized();
    Rotation = FRotator(Rotation.Pitch + Delta.Pitch * OtherWeight, Rotation.Yaw + Delta.Yaw * OtherWeight,
        Rotation.Roll + Delta.Roll * OtherWeight);
    FOV += (OtherInfo.FOV - FOV) * OtherWeight;
    DesiredFOV += (OtherInfo.DesiredFOV - DesiredFOV) * OtherWeight;
    OrthoWidth += (OtherInfo.OrthoWidth - OrthoWidth) * OtherWeight;
    OrthoNearClipPlane += (OtherInfo.OrthoNearClipPlane - OrthoNearClipPlane) * OtherWeight;
    OrthoFarClipPlane += (OtherInfo.OrthoFarClipPlane - OrthoFarClipPlane) * OtherWeight;
    AspectRatio += (OtherInfo.AspectRatio - AspectRatio) * OtherWeight;
    bConstrainAspectRatio |= OtherInfo.bConstrainAspectRatio;
}

void FMinimalViewInfo::ApplyBlendWeight(const float& Weight) {
    Location = Location * static_cast<double>(Weight);
    const FRotator Normalized = Rotation.GetNormalized();
    Rotation = FRotator(Normalized.Pitch * Weight, Normalized.Yaw * Weight, Normalized.Roll * Weight);
    FOV *= Weight;
    DesiredFOV *= Weight;
    OrthoWidth *= Weight;
    OrthoNearClipPlane *= Weight;
    OrthoFarClipPlane *= Weight;
    AspectRatio *= Weight;
}

void FMinimalViewInfo::AddWeightedViewInfo(const FMinimalViewInfo& OtherView, const float& Weight) {
    FMinimalViewInfo Weighted = OtherView;
    Weighted.ApplyBlendWeight(Weight);
    Location = Location + Weighted.Location;
    Rotation = Rotation + Weighted.Rotation;
    FOV += Weighted.FOV;
    DesiredFOV += Weighted.DesiredFOV;
    OrthoWidth += Weighted.OrthoWidth;
    OrthoNearClipPlane += Weighted.OrthoNearClipPlane;
    OrthoFarClipPlane += Weighted.OrthoFarClipPlane;
    AspectRatio += Weighted.AspectRatio;
    bConstrainAspectRatio |= OtherView.bConstrainAspectRatio;
}

// ------------------------------------------------------------------------------------------------------------------
// component

UCameraComponent::UCameraComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    FieldOfView = 90.0f;
    OrthoWidth = 1536.0f;
    OrthoNearClipPlane = 0.0f;
    OrthoFarClipPlane = 2097152.0f;
    AspectRatio = 1.777778f;
    bConstrainAspectRatio = false;
    bUseFieldOfViewForLOD = true;
    bUsePawnControlRotation = false;
    ProjectionMode = ECameraProjectionMode::Perspective;
    bAutoActivate = true;
}

void UCameraComponent::SetFieldOfView(float InFieldOfView) { FieldOfView = InFieldOfView; }

void UCameraComponent::SetOrthoWidth(float InOrthoWidth) { OrthoWidth = InOrthoWidth; }

void UCameraComponent::SetOrthoNearClipPlane(float InOrthoNearClipPlane) { OrthoNearClipPlane = InOrthoNearClipPlane; }

void UCameraComponent::SetOrthoFarClipPlane(float InOrthoFarClipPlane) { OrthoFarClipPlane = InOrthoFarClipPlane; }

void UCameraComponent::SetAspectRatio(float InAspectRatio) { AspectRatio = InAspectRatio; }

void UCameraComponent::SetConstraintAspectRatio(bool bInConstrainAspectRatio) {
    bConstrainAspectRatio = bInConstrainAspectRatio;
}

void UCameraComponent::SetUseFieldOfViewForLOD(bool bInUseFieldOfViewForLOD) {
    bUseFieldOfViewForLOD = bInUseFieldOfViewForLOD;
}

void UCameraComponent::SetProjectionMode(ECameraProjectionMode::Type InProjectionMode) {
    ProjectionMode = InProjectionMode;
}

void UCameraComponent::GetCameraView(float, FMinimalViewInfo& DesiredView) {
    if (bUsePawnControlRotation) {
        const APawn* const Pawn = Cast<APawn>(GetOwner());
        if (Pawn && Pawn->GetController()) {
            const FRotator Wanted = Pawn->GetViewRotation();
            if (!Wanted.Equals(GetComponentRotation())) {
                SetWorldRotation(Wanted);
            }
        }
    }
    DesiredView.Location = GetComponentLocation();
    DesiredView.Rotation = GetComponentRotation();
    DesiredView.FOV = FieldOfView;
    DesiredView.DesiredFOV = FieldOfView;
    DesiredView.AspectRatio = AspectRatio;
    DesiredView.bConstrainAspectRatio = bConstrainAspectRatio;
    DesiredView.ProjectionMode = ProjectionMode;
    DesiredView.OrthoWidth = OrthoWidth;
    DesiredView.OrthoNearClipPlane = OrthoNearClipPlane;
    DesiredView.OrthoFarClipPlane = OrthoFarClipPlane;
}

// ----------------------------------------------------------------------------------------------------------------------
// actor

ACameraActor::ACameraActor(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    SceneComponent = CreateDefaultSubobject<USceneComponent>(TEXT("SceneComponent"));
    RootComponent = SceneComponent;
    CameraComponent = CreateDefaultSubobject<UCameraComponent>(TEXT("CameraComponent"));
    CameraComponent->FieldOfView = 90.0f;
    CameraComponent->bConstrainAspectRatio = true;
    CameraComponent->AspectRatio = 1.777778f;
    CameraComponent->SetupAttachment(SceneComponent);
}
