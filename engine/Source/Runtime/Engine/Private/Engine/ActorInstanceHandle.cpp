// SPDX-License-Identifier: MIT
#include "Engine/ActorInstanceHandle.h"

#include "GameFramework/Actor.h"

FActorInstanceHandle::FActorInstanceHandle(AActor* InActor) : Actor(InActor) {}

bool FActorInstanceHandle::IsValid() const { return Actor.IsValid(); }

bool FActorInstanceHandle::DoesRepresentClass(const UClass* OtherClass) const {
    const AActor* Live = Actor.Get();
    return Live && OtherClass && Live->IsA(OtherClass);
}

FVector FActorInstanceHandle::GetLocation() const {
    const AActor* Live = Actor.Get();
    return Live ? Live->GetActorLocation() : FVector::ZeroVector;
}

FRotator FActorInstanceHandle::GetRotation() const {
    const AActor* Live = Actor.Get();
    return Live ? Live->GetActorRotation() : FRotator::ZeroRotator;
}

FName FActorInstanceHandle::GetFName() const {
    const AActor* Live = Actor.Get();
    return Live ? Live->GetFName() : NAME_None;
}

FString FActorInstanceHandle::GetName() const {
    const AActor* Live = Actor.Get();
    return Live ? Live->GetName() : FString();
}

AActor* FActorInstanceHandle::FetchActor() const { return Actor.Get(); }

bool FActorInstanceHandle::operator==(const FActorInstanceHandle& Other) const { return Actor == Other.Actor; }

bool FActorInstanceHandle::operator==(const AActor* OtherActor) const { return Actor.Get() == OtherActor; }
