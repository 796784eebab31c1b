// SPDX-License-Identifier: MIT
#include "Kismet/KismetSystemLibrary.h"
#include "Components/PrimitiveComponent.h"
#include "Components/SceneComponent.h"
#include "DelayAction.h"
#include "Engine/Engine.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "GameFramework/PlayerController.h"
#include "HAL/IConsoleManager.h"
#include "HAL/PlatformProcess.h"
#include "KismetPrivate.h"
#include "Misc/App.h"
#include "Misc/CommandLine.h"
#include "Misc/EngineVersion.h"
#include "Misc/Parse.h"
#include "Misc/Paths.h"
#include "TimerManager.h"

// Time, delays and timers

double UKismetSystemLibrary::GetGameTimeInSeconds(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetTimeSeconds() : 0.0;
}

void UKismetSystemLibrary::Delay(const UObject* WorldContextObject, float Duration, FLatentActionInfo LatentInfo) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World) {
        FLatentActionManager& Manager = World->GetLatentActionManager();
        if (!Manager.FindExistingAction<FDelayAction>(LatentInfo.CallbackTarget, LatentInfo.UUID)) {
            Manager.AddNewAction(LatentInfo.CallbackTarget, LatentInfo.UUID, new FDelayAction(Duration, LatentInfo));
        }
    }
}

void UKismetSystemLibrary::RetriggerableDelay(
    const UObject* WorldContextObject, float Duration, FLatentActionInfo LatentInfo) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World) {
        FLatentActionManager& Manager = World->GetLatentActionManager();
        if (FDelayAction* const Action =
                Manager.FindExistingAction<FDelayAction>(LatentInfo.CallbackTarget, LatentInfo.UUID)) {
            Action->TimeRemaining = Duration;
        } else {
            Manager.AddNewAction(LatentInfo.CallbackTarget, LatentInfo.UUID, new FDelayAction(Duration, LatentInfo));
        }
    }
}

void UKismetSystemLibrary::DelayUntilNextTick(const UObject* WorldContextObject, FLatentActionInfo LatentInfo) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World) {
        FLatentActionManager& Manager = World->GetLatentActionManager();
        if (!Manager.FindExistingAction<FDelayUntilNextTickAction>(LatentInfo.CallbackTarget, LatentInfo.UUID)) {
            Manager.AddNewAction(LatentInfo.CallbackTarget, LatentInfo.UUID, new FDelayUntilNextTickAction(LatentInfo));
        }
    }
}

FTimerHandle UKismetSystemLibrary::K2_SetTimer(UObject* Object, FString FunctionName, float Time, bool bLooping,
    bool bMaxOncePerFrame, float InitialStartDelay, float InitialStartDelayVariance) {
    return KismetPrivate::SetTimer(KismetPrivate::MakeTimerDelegate(Object, FunctionName), Time, bLooping,
        bMaxOncePerFrame, InitialStartDelay, InitialStartDelayVariance);
}

FTimerHandle UKismetSystemLibrary::K2_SetTimerDelegate(FTimerDynamicDelegate Delegate, float Time, bool bLooping,
    bool bMaxOncePerFrame, float InitialStartDelay, float InitialStartDelayVariance) {
    return KismetPrivate::SetTimer(
        Delegate, Time, bLooping, bMaxOncePerFrame, InitialStartDelay, InitialStartDelayVariance);
}

FTimerHandle UKismetSystemLibrary::K2_SetTimerForNextTick(UObject* Object, FString FunctionName) {
    const FTimerDynamicDelegate Delegate = KismetPrivate::MakeTimerDelegate(Object, FunctionName);
    UWorld* const World = Delegate.IsBound() ? KismetPrivate::GetWorld(Delegate.GetUObject()) : nullptr;
    return World ? World->GetTimerManager().SetTimerForNextTick(Delegate) : FTimerHandle();
}

void UKismetSystemLibrary::K2_ClearTimer(UObject* Object, FString FunctionName) {
    KismetPrivate::WithTimer(
        Object, FunctionName, [](FTimerManager& Manager, FTimerHandle& Handle) { Manager.ClearTimer(Handle); });
}

void UKismetSystemLibrary::K2_PauseTimer(UObject* Object, FString FunctionName) {
    KismetPrivate::WithTimer(
        Object, FunctionName, [](FTimerManager& Manager, FTimerHandle& Handle) { Manager.PauseTimer(Handle); });
}

void UKismetSystemLibrary::K2_UnPauseTimer(UObject* Object, FString FunctionName) {
    KismetPrivate::WithTimer(
        Object, FunctionName, [](FTimerManager& Manager, FTimerHandle& Handle) { Manager.UnPauseTimer(Handle); });
}

bool UKismetSystemLibrary::K2_IsTimerActive(UObject* Object, FString FunctionName) {
    bool bActive = false;
    KismetPrivate::WithTimer(Object, FunctionName,
        [&bActive](FTimerManager& Manager, FTimerHandle& Handle) { bActive = Manager.IsTimerActive(Handle); });
    return bActive;
}

bool UKismetSystemLibrary::K2_TimerExists(UObject* Object, FString FunctionName) {
    bool bExists = false;
    KismetPrivate::WithTimer(Object, FunctionName,
        [&bExists](FTimerManager& Manager, FTimerHandle& Handle) { bExists = Manager.TimerExists(Handle); });
    return bExists;
}

bool UKismetSystemLibrary::K2_IsValidTimerHandle(FTimerHandle Handle) { return Handle.IsValid(); }

FTimerHandle UKismetSystemLibrary::K2_InvalidateTimerHandle(FTimerHandle& Handle) {
    Handle.Invalidate();
    return Handle;
}

void UKismetSystemLibrary::K2_ClearAndInvalidateTimerHandle(const UObject* WorldContextObject, FTimerHandle& Handle) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World && Handle.IsValid()) {
        World->GetTimerManager().ClearTimer(Handle);
    }
    Handle.Invalidate();
}

void UKismetSystemLibrary::K2_PauseTimerHandle(const UObject* WorldContextObject, FTimerHandle Handle) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World && Handle.IsValid()) {
        World->GetTimerManager().PauseTimer(Handle);
    }
}

void UKismetSystemLibrary::K2_UnPauseTimerHandle(const UObject* WorldContextObject, FTimerHandle Handle) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World && Handle.IsValid()) {
        World->GetTimerManager().UnPauseTimer(Handle);
    }
}

bool UKismetSystemLibrary::K2_IsTimerActiveHandle(const UObject* WorldContextObject, FTimerHandle Handle) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World && Handle.IsValid() && World->GetTimerManager().IsTimerActive(Handle);
}

float UKismetSystemLibrary::K2_GetTimerElapsedTimeHandle(const UObject* WorldContextObject, FTimerHandle Handle) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World && Handle.IsValid() && World->GetTimerManager().TimerExists(Handle)
               ? World->GetTimerManager().GetTimerElapsed(Handle)
               : 0.0f;
}

float UKismetSystemLibrary::K2_GetTimerRemainingTimeHandle(const UObject* WorldContextObject, FTimerHandle Handle) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World && Handle.IsValid() && World->GetTimerManager().TimerExists(Handle)
               ? World->GetTimerManager().GetTimerRemaining(Handle)
               : 0.0f;
}

// Components and actors

void UKismetSystemLibrary::MoveComponentTo(USceneComponent* Component, FVector TargetRelativeLocation,
    FRotator TargetRelativeRotation, bool bEaseOut, bool bEaseIn, float OverTime, bool bForceShortestRotationPath,
    TEnumAsByte<EMoveComponentAction::Type> MoveAction, FLatentActionInfo LatentInfo) {
    KismetPrivate::MoveComponentTo(Component, TargetRelativeLocation, TargetRelativeRotation, bEaseOut, bEaseIn,
        OverTime, bForceShortestRotationPath, MoveAction, LatentInfo);
}

void UKismetSystemLibrary::GetComponentBounds(
    const USceneComponent* Component, FVector& Origin, FVector& BoxExtent, float& SphereRadius) {
    Origin = Component ? Component->Bounds.Origin : FVector(0.0, 0.0, 0.0);
    BoxExtent = Component ? Component->Bounds.BoxExtent : FVector(0.0, 0.0, 0.0);
    SphereRadius = Component ? static_cast<float>(Component->Bounds.SphereRadius) : 0.0f;
}

void UKismetSystemLibrary::GetActorListFromComponentList(
    const TArray<UPrimitiveComponent*>& ComponentList, UClass* ActorClassFilter, TArray<AActor*>& OutActorList) {
    OutActorList.Reset();
    for (const UPrimitiveComponent* Component : ComponentList) {
        AActor* const Owner = Component ? Component->GetOwner() : nullptr;
        if (Owner && (!ActorClassFilter || Owner->IsA(ActorClassFilter))) {
            OutActorList.AddUnique(Owner);
        }
    }
}
