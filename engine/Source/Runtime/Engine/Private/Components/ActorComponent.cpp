// SPDX-License-Identifier: MIT
#include "Components/ActorComponent.h"

#include "Components/SceneComponent.h"
#include "Engine/Level.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "UObject/UObjectHash.h"

DEFINE_LOG_CATEGORY_STATIC(LogActorComponent, Log, All);

UActorComponent::UActorComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    PrimaryComponentTick.TickGroup = TG_DuringPhysics;
    PrimaryComponentTick.bStartWithTickEnabled = true;
    PrimaryComponentTick.bCanEverTick = false;
    PrimaryComponentTick.SetTickFunctionEnable(false);
    bEditableWhenInherited = true;
    bAutoActivate = false;
    bWantsInitializeComponent = false;
    CreationMethod = EComponentCreationMethod::Native;
    bAutoRegister = true;
    bIsActive = false;
    bRegistered = false;
    bHasBeenCreated = false;
    bHasBeenInitialized = false;
    bHasBegunPlay = false;
    bIsBeingDestroyed = false;
    bTickFunctionsRegistered = false;
    bRenderStateCreated = false;
    bRenderStateDirty = false;
    bRenderTransformDirty = false;
    bRenderDynamicDataDirty = false;
    bMarkedForEndOfFrameUpdate = false;
    OwnerPrivate = GetTypedOuter<AActor>();
    WorldPrivate = nullptr;
}

void UActorComponent::PostInitProperties() {
    Super::PostInitProperties();
    OwnerPrivate = GetTypedOuter<AActor>();
    if (OwnerPrivate) {
        OwnerPrivate->AddOwnedComponent(this);
    }
}

void UActorComponent::BeginDestroy() {
    if (bHasBegunPlay) {
        EndPlay(EEndPlayReason::Destroyed);
    }
    if (bHasBeenInitialized) {
        UninitializeComponent();
    }
    if (bRegistered) {
        ExecuteUnregisterEvents();
        bRegistered = false;
        WorldPrivate = nullptr;
    }
    Super::BeginDestroy();
}

AActor* UActorComponent::GetOwner() const { return OwnerPrivate; }

UWorld* UActorComponent::GetWorld() const {
    if (WorldPrivate) {
        return WorldPrivate;
    }
    if (HasAnyFlags(RF_ClassDefaultObject)) {
        return nullptr;
    }
    return OwnerPrivate ? OwnerPrivate->GetWorld() : GetTypedOuter<UWorld>();
}

ULevel* UActorComponent::GetComponentLevel() const { return OwnerPrivate ? OwnerPrivate->GetLevel() : nullptr; }

ENetRole UActorComponent::GetOwnerRole() const { return OwnerPrivate ? OwnerPrivate->GetLocalRole() : ROLE_None; }

FString UActorComponent::GetReadableName() const {
    return OwnerPrivate ? OwnerPrivate->GetName() + TEXT(".") + GetName() : GetName();
}

bool UActorComponent::ComponentHasTag(FName Tag) const { return Tag != NAME_None && ComponentTags.Contains(Tag); }

// ------------------------------------------------------------------------------------------------------------
// activation

bool UActorComponent::ShouldActivate() const { return !IsActive(); }

void UActorComponent::Activate(bool bReset) {
    if (bReset || ShouldActivate()) {
        SetComponentTickEnabled(true);
        SetActiveFlag(true);
        OnComponentActivated.Broadcast(this, bReset);
    }
}

void UActorComponent::Deactivate() {
    if (!ShouldActivate()) {
        SetComponentTickEnabled(false);
        SetActiveFlag(false);
        OnComponentDeactivated.Broadcast(this);
    }
}

void UActorComponent::SetActive(bool bNewActive, bool bReset) {
    if (bNewActive) {
        Activate(bReset);
    } else {
        Deactivate();
    }
}

void UActorComponent::ToggleActive() { SetActive(!IsActive()); }

bool UActorComponent::IsActive() const { return bIsActive; }

void UActorComponent::SetAutoActivate(bool bNewAutoActivate) {
    if (!bRegistered || !OwnerPrivate || !OwnerPrivate->IsActorInitialized()) {
        bAutoActivate = bNewAutoActivate;
    } else {
        UE_LOG(LogActorComponent, Warning,
            TEXT("SetAutoActivate called on component %s after construction: call Activate or Deactivate instead"),
            *GetFullName());
    }
}

// ------------------------------------------------------------------------------------------------------------------
// tick

void UActorComponent::TickComponent(
    float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) {
    // Native classes implement this function, not the event.
    if (!GetClass()->HasAnyClassFlags(CLASS_Native)) {
        ReceiveTick(DeltaTime);
    }
}

void UActorComponent::SetComponentTickEnabled(bool bEnabled) {
    if (PrimaryComponentTick.bCanEverTick && !IsTemplate()) {
        PrimaryComponentTick.SetTickFunctionEnable(bEnabled);
    }
}

bool UActorComponent::IsComponentTickEnabled() const { return PrimaryComponentTick.IsTickFunctionEnabled(); }

void UActorComponent::SetComponentTickInterval(float TickInterval) { PrimaryComponentTick.TickInterval = TickInterval; }

void UActorComponent::SetComponentTickIntervalAndCooldown(float TickInterval) {
    PrimaryComponentTick.UpdateTickIntervalAndCoolDown(TickInterval);
}

float UActorComponent::GetComponentTickInterval() const { return PrimaryComponentTick.TickInterval; }

void UActorComponent::AddTickPrerequisiteActor(AActor* PrerequisiteActor) {
    if (PrimaryComponentTick.bCanEverTick && PrerequisiteActor && PrerequisiteActor->PrimaryActorTick.bCanEverTick) {
        PrimaryComponentTick.AddPrerequisite(PrerequisiteActor, PrerequisiteActor->PrimaryActorTick);
    }
}

void UActorComponent::AddTickPrerequisiteComponent(UActorComponent* PrerequisiteComponent) {
    if (PrimaryComponentTick.bCanEverTick && PrerequisiteComponent &&
        PrerequisiteComponent->PrimaryComponentTick.bCanEverTick) {
        PrimaryComponentTick.AddPrerequisite(PrerequisiteComponent, PrerequisiteComponent->PrimaryComponentTick);
    }
}

void UActorComponent::RemoveTickPrerequisiteActor(AActor* PrerequisiteActor) {
    if (PrerequisiteActor) {
        PrimaryComponentTick.RemovePrerequisite(PrerequisiteActor, PrerequisiteActor->PrimaryActorTick);
    }
}

void UActorComponent::RemoveTickPrerequisiteComponent(UActorComponent* PrerequisiteComponent) {
    if (PrerequisiteComponent) {
        PrimaryComponentTick.RemovePrerequisite(PrerequisiteComponent, PrerequisiteComponent->PrimaryComponentTick);
    }
}

void UActorComponent::SetTickableWhenPaused(bool bTickableWhenPaused) {
    PrimaryComponentTick.bTickEvenWhenPaused = bTickableWhenPaused;
}

void UActorComponent::SetTickGroup(ETickingGroup NewTickGroup) { PrimaryComponentTick.TickGroup = NewTickGroup; }

bool UActorComponent::SetupActorComponentTickFunction(FTickFunction* TickFunction) {
    if (!TickFunction->bCanEverTick || IsTemplate()) {
        return false;
    }
    ULevel* Level = GetComponentLevel();
    UWorld* World = GetWorld();
    if (!Level && World) {
        Level = World->PersistentLevel;
    }
    if (!Level) {
        return false;
    }
    TickFunction->SetTickFunctionEnable(TickFunction->bStartWithTickEnabled || TickFunction->IsTickFunctionEnabled());
    TickFunction->RegisterTickFunction(Level);
    return true;
}

void UActorComponent::RegisterComponentTickFunctions(bool bRegister) {
    if (bRegister) {
        if (SetupActorComponentTickFunction(&PrimaryComponentTick)) {
            PrimaryComponentTick.Target = this;
        }
    } else if (PrimaryComponentTick.IsTickFunctionRegistered()) {
        PrimaryComponentTick.UnRegisterTickFunction();
    }
}

void UActorComponent::RegisterAllComponentTickFunctions(bool bRegister) {
    if (bTickFunctionsRegistered != static_cast<uint8>(bRegister)) {
        RegisterComponentTickFunctions(bRegister);
        bTickFunctionsRegistered = bRegister;
    }
}

// ------------------------------------------------------------------------------------------------------------------
// play

void UActorComponent::BeginPlay() {
    check(bRegistered);
    check(!bHasBegunPlay);
    bHasBegunPlay = true;
    ReceiveBeginPlay();
}

void UActorComponent::EndPlay(const EEndPlayReason::Type EndPlayReason) {
    check(bHasBegunPlay);
    if (!HasAnyFlags(RF_BeginDestroyed)) {
        ReceiveEndPlay(EndPlayReason);
    }
    bHasBegunPlay = false;
}

void UActorComponent::InitializeComponent() {
    check(bRegistered);
    check(!bHasBeenInitialized);
    bHasBeenInitialized = true;
}

void UActorComponent::UninitializeComponent() {
    check(bHasBeenInitialized);
    bHasBeenInitialized = false;
}

// ----------------------------------------------------------------------------------------------------------
// registration

void UActorComponent::OnComponentCreated() { bHasBeenCreated = true; }

void UActorComponent::OnComponentDestroyed(bool) {}

void UActorComponent::RegisterComponent() {
    if (UWorld* World = OwnerPrivate ? OwnerPrivate->GetWorld() : GetWorld()) {
        RegisterComponentWithWorld(World);
    } else {
        UE_LOG(LogActorComponent, Warning,
            TEXT("RegisterComponent of %s: its owner %s is in no world. Spawn the actor first, or call "
                 "RegisterComponentWithWorld"),
            *GetPathName(), *GetNameSafe(OwnerPrivate));
    }
}

void UActorComponent::RegisterComponentWithWorld(UWorld* InWorld) {
    if (bRegistered) {
        return;
    }
    if (!InWorld || IsTemplate() || !IsValid(this)) {
        UE_LOG(LogActorComponent, Log, TEXT("RegisterComponentWithWorld of %s: %s"), *GetPathName(),
            InWorld ? TEXT("the component is a template or destroyed") : TEXT("there is no world"));
        return;
    }
    if (OwnerPrivate) {
        if (OwnerPrivate->IsActorBeingDestroyed()) {
            return;
        }
        if (!bHasBeenCreated) {
            OnComponentCreated();
        }
        OwnerPrivate->AddOwnedComponent(this);
    }

    WorldPrivate = InWorld;
    ExecuteRegisterEvents();

    if (OwnerPrivate) {
        if (OwnerPrivate->IsActorInitialized() && bWantsInitializeComponent && !bHasBeenInitialized) {
            InitializeComponent();
        }
        if (OwnerPrivate->HasActorBegunPlay() || OwnerPrivate->IsActorBeginningPlay()) {
            RegisterAllComponentTickFunctions(true);
            if (!bHasBegunPlay && !bIsBeingDestroyed) {
                BeginPlay();
            }
        }
    } else {
        if (bWantsInitializeComponent && !bHasBeenInitialized) {
            InitializeComponent();
        }
        RegisterAllComponentTickFunctions(true);
    }

    // Parts of this component that are components themselves.
    ForEachObjectWithOuter(
        this,
        [InWorld](UObject* Object) {
            UActorComponent* Child = Cast<UActorComponent>(Object);
            if (Child && Child->bAutoRegister && !Child->IsRegistered() && IsValid(Child) && !Child->OwnerPrivate) {
                Child->RegisterComponentWithWorld(InWorld);
            }
        },
        false);
}

void UActorComponent::ExecuteRegisterEvents() {
    if (!bRegistered) {
        OnRegister();
        checkf(bRegistered, TEXT("%s did not call Super::OnRegister()"), *GetClass()->GetName());
    }
    if (!bRenderStateCreated && ShouldCreateRenderState()) {
        CreateRenderState_Concurrent(nullptr);
    }
}

void UActorComponent::ExecuteUnregisterEvents() {
    if (bRenderStateCreated) {
        DestroyRenderState_Concurrent();
    }
    if (bRegistered) {
        OnUnregister();
    }
}

void UActorComponent::OnRegister() {
    bRegistered = true;
    // Actors activate their components when they are initialised; what comes later activates itself.
    if (bAutoActivate && (!OwnerPrivate || OwnerPrivate->IsActorInitialized())) {
        Activate(true);
    }
}

void UActorComponent::OnUnregister() { bRegistered = false; }

void UActorComponent::UnregisterComponent() {
    if (!bRegistered) {
        return;
    }
    RegisterAllComponentTickFunctions(false);
    ExecuteUnregisterEvents();
    if (WorldPrivate) {
        WorldPrivate->ClearActorComponentEndOfFrameUpdate(this);
    }
    bMarkedForEndOfFrameUpdate = false;
    WorldPrivate = nullptr;
}

void UActorComponent::ReregisterComponent() {
    if (!bRegistered) {
        return;
    }
    UWorld* World = WorldPrivate;
    const bool bWasActive = bIsActive;
    UnregisterComponent();
    RegisterComponentWithWorld(World);
    if (bWasActive != static_cast<bool>(bIsActive)) {
        SetActive(bWasActive);
    }
}

void UActorComponent::DestroyComponent(bool) {
    if (bIsBeingDestroyed) {
        return;
    }
    bIsBeingDestroyed = true;
    if (bHasBegunPlay) {
        EndPlay(EEndPlayReason::Destroyed);
    }
    if (bHasBeenInitialized) {
        UninitializeComponent();
    }
    if (bRegistered) {
        UnregisterComponent();
    }
    if (OwnerPrivate) {
        OwnerPrivate->RemoveOwnedComponent(this);
        if (OwnerPrivate->GetRootComponent() == this) {
            OwnerPrivate->SetRootComponent(nullptr);
        }
    }
    OnComponentDestroyed(false);
    MarkAsGarbage();
}

void UActorComponent::K2_DestroyComponent(UObject* Object) {
    if (bIsBeingDestroyed) {
        return;
    }
    if (!OwnerPrivate || Object == OwnerPrivate || Object == this) {
        DestroyComponent();
    } else {
        UE_LOG(LogActorComponent, Error,
            TEXT("May not destroy component %s owned by %s on behalf of %s: pass the owner as Object"), *GetFullName(),
            *GetNameSafe(OwnerPrivate), *GetNameSafe(Object));
    }
}

// ---------------------------------------------------------------------------------------------------------- render
// state

void UActorComponent::CreateRenderState_Concurrent(FRegisterComponentContext*) {
    bRenderStateCreated = true;
    bRenderStateDirty = false;
    bRenderTransformDirty = false;
    bRenderDynamicDataDirty = false;
}

void UActorComponent::SendRenderTransform_Concurrent() { bRenderTransformDirty = false; }

void UActorComponent::SendRenderDynamicData_Concurrent() { bRenderDynamicDataDirty = false; }

void UActorComponent::DestroyRenderState_Concurrent() { bRenderStateCreated = false; }

void UActorComponent::RecreateRenderState_Concurrent() {
    if (bRenderStateCreated) {
        DestroyRenderState_Concurrent();
    }
    if (bRegistered && WorldPrivate && ShouldCreateRenderState()) {
        CreateRenderState_Concurrent(nullptr);
    }
}

void UActorComponent::MarkForNeededEndOfFrameUpdate() {
    if (!bMarkedForEndOfFrameUpdate && WorldPrivate) {
        bMarkedForEndOfFrameUpdate = true;
        WorldPrivate->MarkActorComponentForNeededEndOfFrameUpdate(this);
    }
}

void UActorComponent::MarkRenderStateDirty() {
    // Also without a render state: whether there should be one is asked again when it is dirty.
    if (bRegistered) {
        bRenderStateDirty = true;
        MarkForNeededEndOfFrameUpdate();
    }
}

void UActorComponent::MarkRenderTransformDirty() {
    if (bRegistered && bRenderStateCreated) {
        bRenderTransformDirty = true;
        MarkForNeededEndOfFrameUpdate();
    }
}

void UActorComponent::MarkRenderDynamicDataDirty() {
    if (bRegistered && bRenderStateCreated) {
        bRenderDynamicDataDirty = true;
        MarkForNeededEndOfFrameUpdate();
    }
}

void UActorComponent::DoDeferredRenderUpdates_Concurrent() {
    bMarkedForEndOfFrameUpdate = false;
    if (!bRegistered) {
        return;
    }
    if (bRenderStateDirty) {
        bRenderStateDirty = false;
        RecreateRenderState_Concurrent();
        return;
    }
    if (bRenderTransformDirty) {
        SendRenderTransform_Concurrent();
    }
    if (bRenderDynamicDataDirty) {
        SendRenderDynamicData_Concurrent();
    }
}
