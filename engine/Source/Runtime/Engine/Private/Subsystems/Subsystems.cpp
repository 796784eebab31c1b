// SPDX-License-Identifier: MIT
#include "Engine/GameInstance.h"
#include "Engine/LocalPlayer.h"
#include "Engine/World.h"
#include "Subsystems/EngineSubsystem.h"
#include "Subsystems/GameInstanceSubsystem.h"
#include "Subsystems/LocalPlayerSubsystem.h"
#include "Subsystems/Subsystem.h"
#include "Subsystems/WorldSubsystem.h"

USubsystem::USubsystem() : InternalOwningSubsystem(nullptr) {}

UDynamicSubsystem::UDynamicSubsystem() = default;

UEngineSubsystem::UEngineSubsystem() = default;

UGameInstanceSubsystem::UGameInstanceSubsystem() = default;

UGameInstance* UGameInstanceSubsystem::GetGameInstance() const { return Cast<UGameInstance>(GetOuter()); }

UWorld* UGameInstanceSubsystem::GetWorld() const {
    const UGameInstance* GameInstance = GetGameInstance();
    return GameInstance ? GameInstance->GetWorld() : nullptr;
}

ULocalPlayerSubsystem::ULocalPlayerSubsystem() = default;

ULocalPlayer* ULocalPlayerSubsystem::GetLocalPlayerChecked() const { return CastChecked<ULocalPlayer>(GetOuter()); }

UWorld* ULocalPlayerSubsystem::GetWorld() const {
    const ULocalPlayer* Player = GetLocalPlayer();
    return Player ? Player->GetWorld() : nullptr;
}

UWorldSubsystem::UWorldSubsystem() = default;

UWorld* UWorldSubsystem::GetWorld() const { return Cast<UWorld>(GetOuter()); }

UWorld& UWorldSubsystem::GetWorldRef() const {
    UWorld* World = GetWorld();
    check(World);
    return *World;
}

bool UWorldSubsystem::ShouldCreateSubsystem(UObject* Outer) const {
    const UWorld* World = Cast<UWorld>(Outer);
    return World && DoesSupportWorldType(World->WorldType);
}

bool UWorldSubsystem::DoesSupportWorldType(const EWorldType::Type WorldType) const {
    return WorldType == EWorldType::Game || WorldType == EWorldType::Editor || WorldType == EWorldType::PIE;
}

UTickableWorldSubsystem::UTickableWorldSubsystem() : bInitialized(false) {}

UTickableWorldSubsystem::~UTickableWorldSubsystem() = default;

UWorld* UTickableWorldSubsystem::GetTickableGameObjectWorld() const { return GetWorld(); }

ETickableTickType UTickableWorldSubsystem::GetTickableTickType() const {
    // The class default object belongs to no world and must not tick.
    return IsTemplate() ? ETickableTickType::Never : ETickableTickType::Conditional;
}

bool UTickableWorldSubsystem::IsAllowedToTick() const { return !IsTemplate() && bInitialized; }

void UTickableWorldSubsystem::Tick(float) {}

TStatId UTickableWorldSubsystem::GetStatId() const { return TStatId(); }

void UTickableWorldSubsystem::Initialize(FSubsystemCollectionBase& Collection) {
    Super::Initialize(Collection);
    bInitialized = true;
    SetTickableTickType(GetTickableTickType());
}

void UTickableWorldSubsystem::Deinitialize() {
    bInitialized = false;
    SetTickableTickType(ETickableTickType::Never);
    Super::Deinitialize();
}
