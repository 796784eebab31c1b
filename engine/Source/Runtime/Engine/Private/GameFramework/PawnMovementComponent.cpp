// SPDX-License-Identifier: MIT
#include "GameFramework/PawnMovementComponent.h"

#include "GameFramework/Pawn.h"

UPawnMovementComponent::UPawnMovementComponent(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer) {}

void UPawnMovementComponent::SetUpdatedComponent(USceneComponent* NewUpdatedComponent) {
    Super::SetUpdatedComponent(NewUpdatedComponent);
    PawnOwner = NewUpdatedComponent ? Cast<APawn>(NewUpdatedComponent->GetOwner()) : nullptr;
}

APawn* UPawnMovementComponent::GetPawnOwner() const { return PawnOwner; }

void UPawnMovementComponent::AddInputVector(FVector WorldVector, bool bForce) {
    if (APawn* Pawn = PawnOwner ? PawnOwner.Get() : GetOwner<APawn>()) {
        Pawn->Internal_AddMovementInput(WorldVector, bForce);
    }
}

FVector UPawnMovementComponent::GetPendingInputVector() const {
    return PawnOwner ? PawnOwner->Internal_GetPendingMovementInputVector() : FVector::ZeroVector;
}

FVector UPawnMovementComponent::GetLastInputVector() const {
    return PawnOwner ? PawnOwner->Internal_GetLastMovementInputVector() : FVector::ZeroVector;
}

FVector UPawnMovementComponent::ConsumeInputVector() {
    APawn* Pawn = PawnOwner ? PawnOwner.Get() : GetOwner<APawn>();
    return Pawn ? Pawn->Internal_ConsumeMovementInputVector() : FVector::ZeroVector;
}

bool UPawnMovementComponent::IsMoveInputIgnored() const {
    return !UpdatedComponent || !PawnOwner || PawnOwner->IsMoveInputIgnored();
}
