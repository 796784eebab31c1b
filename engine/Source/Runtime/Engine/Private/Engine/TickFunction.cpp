// SPDX-License-Identifier: MIT
#include "Components/ActorComponent.h"
#include "Engine/EngineBaseTypes.h"
#include "Engine/Level.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "TickTaskManager.h"

FTickFunction::FTickFunction()
    : TickGroup(TG_PrePhysics), EndTickGroup(TG_PrePhysics), bTickEvenWhenPaused(false), bCanEverTick(false),
      bStartWithTickEnabled(false), bAllowTickOnDedicatedServer(true), bHighPriority(false), bRegistered(false),
      bTickEnabled(true), TickInterval(0.f), Manager(nullptr), ManagerIndex(INDEX_NONE), QueuedFrame(0),
      ExecutedFrame(0), CooldownSeconds(0.0), LastTickGameTimeSeconds(-1.0), TimeSinceLastTick(-1.f),
      ActualStartTickGroup(TG_PrePhysics) {}

FTickFunction::FTickFunction(const FTickFunction& Other) : FTickFunction() { *this = Other; }

FTickFunction& FTickFunction::operator=(const FTickFunction& Other) {
    TickGroup = Other.TickGroup;
    EndTickGroup = Other.EndTickGroup;
    bTickEvenWhenPaused = Other.bTickEvenWhenPaused;
    bCanEverTick = Other.bCanEverTick;
    bStartWithTickEnabled = Other.bStartWithTickEnabled;
    bAllowTickOnDedicatedServer = Other.bAllowTickOnDedicatedServer;
    bHighPriority = Other.bHighPriority;
    TickInterval = Other.TickInterval;
    return *this;
}

FTickFunction::~FTickFunction() { UnRegisterTickFunction(); }

void FTickFunction::RegisterTickFunction(ULevel* Level) {
    UWorld* World = Level ? Level->OwningWorld.Get() : nullptr;
    if (!bRegistered && World) {
        World->GetTickTaskManager().Add(*this);
    }
}

void FTickFunction::UnRegisterTickFunction() {
    if (bRegistered && Manager) {
        Manager->Remove(*this);
    }
}

void FTickFunction::SetTickFunctionEnable(bool bInEnabled) {
    const bool bWasEnabled = bTickEnabled;
    bTickEnabled = bInEnabled;
    if (bInEnabled && !bWasEnabled) {
        CooldownSeconds = 0.0;
        TimeSinceLastTick = -1.f;
        if (bRegistered) {
            Manager->NotifyEnabled(*this);
        }
    }
}

void FTickFunction::UpdateTickIntervalAndCoolDown(float NewTickInterval) {
    TickInterval = NewTickInterval;
    TimeSinceLastTick = FMath::Max(TimeSinceLastTick, 0.f);
    CooldownSeconds = FMath::Max(0.0, static_cast<double>(NewTickInterval) - static_cast<double>(TimeSinceLastTick));
}

void FTickFunction::AddPrerequisite(UObject* TargetObject, FTickFunction& TargetTickFunction) {
    // As UE: only what can ever tick can be waited for.
    if (TargetObject && TargetTickFunction.bCanEverTick && &TargetTickFunction != this) {
        Prerequisites.AddUnique(FTickPrerequisite(TargetObject, TargetTickFunction));
    }
}

void FTickFunction::RemovePrerequisite(UObject* TargetObject, FTickFunction& TargetTickFunction) {
    if (TargetObject) {
        Prerequisites.Remove(FTickPrerequisite(TargetObject, TargetTickFunction));
    }
}

void FTickFunction::SetPriorityIncludingPrerequisites(bool bInHighPriority) {
    if (static_cast<bool>(bHighPriority) == bInHighPriority) {
        return;
    }
    bHighPriority = bInHighPriority;
    for (const FTickPrerequisite& Prerequisite : Prerequisites) {
        if (FTickFunction* Function = Prerequisite.Get()) {
            Function->SetPriorityIncludingPrerequisites(bInHighPriority);
        }
    }
}

void FActorTickFunction::ExecuteTick(float DeltaTime, ELevelTick TickType, ENamedThreads::Type, const FGraphEventRef&) {
    if (IsValid(Target) && (TickType != LEVELTICK_ViewportsOnly || Target->ShouldTickIfViewportsOnly())) {
        Target->TickActor(DeltaTime * Target->CustomTimeDilation, TickType, *this);
    }
}

FString FActorTickFunction::DiagnosticMessage() { return GetFullNameSafe(Target) + TEXT("[TickActor]"); }

FName FActorTickFunction::DiagnosticContext(bool bDetailed) {
    return Target ? (bDetailed ? Target->GetFName() : Target->GetClass()->GetFName()) : NAME_None;
}

void FActorComponentTickFunction::ExecuteTick(
    float DeltaTime, ELevelTick TickType, ENamedThreads::Type, const FGraphEventRef&) {
    if (IsValid(Target) && Target->IsRegistered()) {
        const AActor* Owner = Target->GetOwner();
        Target->TickComponent(DeltaTime * (Owner ? Owner->CustomTimeDilation : 1.f), TickType, this);
    }
}

FString FActorComponentTickFunction::DiagnosticMessage() { return GetFullNameSafe(Target) + TEXT("[TickComponent]"); }

FName FActorComponentTickFunction::DiagnosticContext(bool bDetailed) {
    return Target ? (bDetailed ? Target->GetFName() : Target->GetClass()->GetFName()) : NAME_None;
}
