// SPDX-License-Identifier: MIT
#include "Engine/Level.h"

#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "GameFramework/WorldSettings.h"
#include "UObject/GarbageCollection.h"

ULevel::ULevel(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer), bIsVisible(true) {}

void ULevel::AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector) {
    ULevel* This = CastChecked<ULevel>(InThis);
    Collector.AddReferencedObjects(This->Actors);
    Super::AddReferencedObjects(InThis, Collector);
}

UWorld* ULevel::GetWorld() const { return OwningWorld; }

AWorldSettings* ULevel::GetWorldSettings(bool bChecked) const {
    checkf(!bChecked || WorldSettings, TEXT("%s has no world settings: is the world initialised?"), *GetPathName());
    return WorldSettings;
}

void ULevel::SetWorldSettings(AWorldSettings* NewWorldSettings) { WorldSettings = NewWorldSettings; }

bool ULevel::IsPersistentLevel() const { return OwningWorld && OwningWorld->PersistentLevel == this; }

bool ULevel::IsCurrentLevel() const { return OwningWorld && OwningWorld->GetCurrentLevel() == this; }

void ULevel::CompactActors() { Actors.Remove(nullptr); }
