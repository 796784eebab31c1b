// SPDX-License-Identifier: MIT
#include "GameFramework/DefaultPawn.h"

#include "Components/SphereComponent.h"
#include "Engine/World.h"
#include "GameFramework/Controller.h"
#include "GameFramework/FloatingPawnMovement.h"

FName ADefaultPawn::MovementComponentName(TEXT("MovementComponent0"));
FName ADefaultPawn::CollisionComponentName(TEXT("CollisionComponent0"));

ADefaultPawn::ADefaultPawn(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    BaseEyeHeight = 0.f;
    bUseControllerRotationPitch = true;
    bUseControllerRotationYaw = true;
    BaseTurnRate = 45.f;
    BaseLookUpRate = 45.f;

    CollisionComponent = CreateDefaultSubobject<USphereComponent>(CollisionComponentName);
    CollisionComponent->InitSphereRadius(35.f);
    RootComponent = CollisionComponent;

    MovementComponent = CreateDefaultSubobject<UFloatingPawnMovement>(MovementComponentName);
    MovementComponent->UpdatedComponent = CollisionComponent;
}

void ADefaultPawn::MoveForward(float Val) {
    if (Val != 0.f && Controller) {
        AddMovementInput(Controller->GetControlRotation().Vector(), Val);
    }
}

void ADefaultPawn::MoveRight(float Val) {
    if (Val != 0.f && Controller) {
        AddMovementInput(FRotationMatrix(Controller->GetControlRotation()).GetScaledAxis(EAxis::Y), Val);
    }
}

void ADefaultPawn::MoveUp_World(float Val) {
    if (Val != 0.f) {
        AddMovementInput(FVector::UpVector, Val);
    }
}

void ADefaultPawn::TurnAtRate(float Rate) {
    AddControllerYawInput(Rate * BaseTurnRate * GetWorld()->GetDeltaSeconds() * CustomTimeDilation);
}

void ADefaultPawn::LookUpAtRate(float Rate) {
    AddControllerPitchInput(Rate * BaseLookUpRate * GetWorld()->GetDeltaSeconds() * CustomTimeDilation);
}
