// SPDX-License-Identifier: MIT
/** @file Life of actors: construction, components, play, destruction, tick. Their transform and attachment are in
 * ActorTransform.cpp and ActorAttachment.cpp. */
#include "GameFramework/Actor.h"

#include "Camera/CameraComponent.h"
#include "Camera/CameraTypes.h"
#include "Components/PrimitiveComponent.h"
#include "Components/SceneComponent.h"
#include "Engine/Engine.h"
#include "Engine/GameInstance.h"
#include "Engine/Level.h"
#include "Engine/World.h"
#include "GameFramework/Controller.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/WorldSettings.h"
#include "TimerManager.h"
#include "UObject/GarbageCollection.h"

DEFINE_LOG_CATEGORY_STATIC(LogActor, Log, All);

AActor::AActor() { InitializeDefaults(); }

AActor::AActor(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) { InitializeDefaults(); }

void AActor::InitializeDefaults() {
    PrimaryActorTick.TickGroup = TG_PrePhysics;
    PrimaryActorTick.bCanEverTick = false;
    PrimaryActorTick.bStartWithTickEnabled = true;
    PrimaryActorTick.SetTickFunctionEnable(false);

    CustomTimeDilation = 1.f;
    InitialLifeSpan = 0.f;
    bFindCameraComponentWhenViewTarget = true;
    SpawnCollisionHandlingMethod = ESpawnActorCollisionHandlingMethod::AlwaysSpawn;
    bHidden = false;
    bActorEnableCollision = true;
    bAutoDestroyWhenFinished = false;
    CreationTime = 0.0;
    ActorHasBegunPlay = EActorBeginPlayState::HasNotBegunPlay;
    bActorInitialized = false;
    bActorIsBeingDestroyed = false;
    bHasFinishedSpawning = false;
    bTickFunctionsRegistered = false;
    bHasRegisteredAllComponents = false;
}

void AActor::PostInitProperties() {
    Super::PostInitProperties();
    // Not copied from a template: they belong to this instance.
    if (!HasAnyFlags(RF_ClassDefaultObject | RF_ArchetypeObject)) {
        Children.Empty();
        Owner = nullptr;
    }
}

void AActor::BeginDestroy() {
    // Collected without having been destroyed: its world was dropped as a whole.
    RegisterAllActorTickFunctions(false, false);
    Super::BeginDestroy();
}

void AActor::AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector) {
    AActor* This = CastChecked<AActor>(InThis);
    Collector.AddReferencedObjects(This->OwnedComponents);
    Super::AddReferencedObjects(InThis, Collector);
}

UWorld* AActor::GetWorld() const {
    // Class default objects and templates are in no world.
    if (HasAnyFlags(RF_ClassDefaultObject)) {
        return nullptr;
    }
    const ULevel* Level = GetLevel();
    return Level ? Level->OwningWorld.Get() : nullptr;
}

ULevel* AActor::GetLevel() const { return GetTypedOuter<ULevel>(); }

FTransform AActor::GetLevelTransform() const { return FTransform::Identity; }

bool AActor::IsInPersistentLevel(bool) const {
    const ULevel* Level = GetLevel();
    return Level && Level->IsPersistentLevel();
}

UGameInstance* AActor::GetGameInstance() const {
    const UWorld* World = GetWorld();
    return World ? World->GetGameInstance() : nullptr;
}

FTimerManager& AActor::GetWorldTimerManager() const {
    UWorld* World = GetWorld();
    checkf(World, TEXT("GetWorldTimerManager of %s, which is in no world"), *GetPathName());
    return World->GetTimerManager();
}

// --------------------------------------------------------------------------------------------------------------
// spawning

namespace {
/** Gives actors without a root their first scene component as root, and attaches stray native scene components to it.
 */
USceneComponent* FixupNativeComponents(AActor* Actor) {
    TArray<USceneComponent*> SceneComponents;
    Actor->GetComponents(SceneComponents);
    USceneComponent* Root = Actor->GetRootComponent();
    if (!Root && SceneComponents.Num() > 0) {
        Root = SceneComponents[0];
        Actor->SetRootComponent(Root);
    }
    for (USceneComponent* Component : SceneComponents) {
        if (Component != Root && !Component->GetAttachParent() &&
            Component->CreationMethod == EComponentCreationMethod::Native) {
            Component->SetupAttachment(Root);
        }
    }
    return Root;
}

/** Where the root component goes when the actor is spawned at a transform. */
FTransform GetSpawnRootTransform(
    const FTransform& RootTransform, const FTransform& SpawnTransform, ESpawnActorScaleMethod Method) {
    FTransform Result = RootTransform * SpawnTransform;
    if (Method == ESpawnActorScaleMethod::OverrideRootScale) {
        Result.SetScale3D(SpawnTransform.GetScale3D());
    }
    return Result;
}
} // namespace

void AActor::PostSpawnInitialize(const FTransform& SpawnTransform, AActor* InOwner, APawn* InInstigator,
    bool bDeferConstruction, ESpawnActorScaleMethod TransformScaleMethod) {
    UWorld* World = GetWorld();
    CreationTime = World->GetTimeSeconds();
    Instigator = InInstigator;
    SetOwner(InOwner);

    if (USceneComponent* Root = FixupNativeComponents(this)) {
        const FTransform RootTransform(
            Root->GetRelativeRotation(), Root->GetRelativeLocation(), Root->GetRelativeScale3D());
        Root->SetWorldTransform(GetSpawnRootTransform(RootTransform, SpawnTransform, TransformScaleMethod), false,
            nullptr, ETeleportType::ResetPhysics);
    }

    // By index: components may create others.
    for (int32 Index = 0; Index < OwnedComponents.Num(); ++Index) {
        if (!OwnedComponents[Index]->HasBeenCreated()) {
            OwnedComponents[Index]->OnComponentCreated();
        }
    }
    RegisterAllComponents();
    PostActorCreated();
    if (!bDeferConstruction) {
        FinishSpawning(SpawnTransform, true, nullptr, TransformScaleMethod);
    }
}

void AActor::FinishSpawning(const FTransform& Transform, bool bIsDefaultTransform, const FComponentInstanceDataCache*,
    ESpawnActorScaleMethod TransformScaleMethod) {
    if (bHasFinishedSpawning || bActorIsBeingDestroyed) {
        return;
    }
    bHasFinishedSpawning = true;

    if (RootComponent && !bIsDefaultTransform) {
        const USceneComponent* Template = GetClass()->GetDefaultObject<AActor>()->GetRootComponent();
        const FTransform RootTransform = Template ? FTransform(Template->GetRelativeRotation(),
                                                        Template->GetRelativeLocation(), Template->GetRelativeScale3D())
                                                  : FTransform::Identity;
        RootComponent->SetWorldTransform(GetSpawnRootTransform(RootTransform, Transform, TransformScaleMethod), false,
            nullptr, ETeleportType::ResetPhysics);
    }

    UWorld* World = GetWorld();
    const bool bWasRunning = World->bIsRunningConstructionScript;
    World->bIsRunningConstructionScript = true;
    UserConstructionScript();
    World->bIsRunningConstructionScript = bWasRunning;
    OnConstruction(RootComponent ? RootComponent->GetComponentTransform() : Transform);
    RegisterAllComponents();
    PostActorConstruction();
}

void AActor::PostActorConstruction() {
    UWorld* World = GetWorld();
    if (bActorIsBeingDestroyed || !World->AreActorsInitialized() || bActorInitialized) {
        return;
    }
    PreInitializeComponents();
    if (bActorIsBeingDestroyed) {
        return;
    }
    InitializeComponents();
    PostInitializeComponents();
    if (!bActorInitialized && !bActorIsBeingDestroyed) {
        UE_LOG(LogActor, Error, TEXT("%s did not call Super::PostInitializeComponents()"), *GetFullName());
        bActorInitialized = true;
    }
    if (!bActorIsBeingDestroyed && World->HasBegunPlay()) {
        DispatchBeginPlay();
    }
}

// ------------------------------------------------------------------------------------------------------------------
// play

void AActor::PreInitializeComponents() {}

void AActor::PostInitializeComponents() { bActorInitialized = true; }

void AActor::InitializeComponents() {
    for (int32 Index = 0; Index < OwnedComponents.Num(); ++Index) {
        UActorComponent* Component = OwnedComponents[Index];
        if (!Component->IsRegistered()) {
            continue;
        }
        if (Component->bAutoActivate && !Component->IsActive()) {
            Component->Activate(true);
        }
        if (Component->bWantsInitializeComponent && !Component->HasBeenInitialized()) {
            Component->InitializeComponent();
        }
    }
}

void AActor::UninitializeComponents() {
    for (int32 Index = 0; Index < OwnedComponents.Num(); ++Index) {
        if (OwnedComponents[Index]->HasBeenInitialized()) {
            OwnedComponents[Index]->UninitializeComponent();
        }
    }
}

void AActor::DispatchBeginPlay(bool) {
    if (ActorHasBegunPlay != EActorBeginPlayState::HasNotBegunPlay || bActorIsBeingDestroyed || !IsValid(this) ||
        !GetWorld()) {
        return;
    }
    ActorHasBegunPlay = EActorBeginPlayState::BeginningPlay;
    BeginPlay();
    if (ActorHasBegunPlay == EActorBeginPlayState::BeginningPlay) {
        UE_LOG(LogActor, Error, TEXT("%s did not call Super::BeginPlay()"), *GetFullName());
        ActorHasBegunPlay = EActorBeginPlayState::HasBegunPlay;
    }
}

void AActor::BeginPlay() {
    SetLifeSpan(InitialLifeSpan);
    RegisterAllActorTickFunctions(true, false);
    const TArray<TObjectPtr<UActorComponent>> Components = OwnedComponents;
    for (UActorComponent* Component : Components) {
        if (Component->IsRegistered() && !Component->HasBegunPlay()) {
            Component->RegisterAllComponentTickFunctions(true);
            Component->BeginPlay();
        }
    }
    ReceiveBeginPlay();
    ActorHasBegunPlay = EActorBeginPlayState::HasBegunPlay;
}

void AActor::EndPlay(const EEndPlayReason::Type EndPlayReason) {
    if (ActorHasBegunPlay != EActorBeginPlayState::HasBegunPlay) {
        return;
    }
    ActorHasBegunPlay = EActorBeginPlayState::HasNotBegunPlay;
    SetLifeSpan(0.f);
    ReceiveEndPlay(EndPlayReason);
    OnEndPlay.Broadcast(this, EndPlayReason);
    const TArray<TObjectPtr<UActorComponent>> Components = OwnedComponents;
    for (UActorComponent* Component : Components) {
        if (Component->HasBegunPlay()) {
            Component->EndPlay(EndPlayReason);
        }
    }
}

void AActor::RouteEndPlay(const EEndPlayReason::Type EndPlayReason) {
    if (!bActorInitialized) {
        return;
    }
    if (ActorHasBegunPlay == EActorBeginPlayState::HasBegunPlay) {
        EndPlay(EndPlayReason);
    }
    UninitializeComponents();
    if (EndPlayReason != EEndPlayReason::Destroyed) {
        bActorInitialized = false;
        RegisterAllActorTickFunctions(false, true);
    }
}

// ---------------------------------------------------------------------------------------------------------------
// destroy

bool AActor::Destroy(bool bNetForce, bool bShouldModifyLevel) {
    if (!bActorIsBeingDestroyed) {
        if (UWorld* World = GetWorld()) {
            World->DestroyActor(this, bNetForce, bShouldModifyLevel);
        } else {
            UE_LOG(LogActor, Warning, TEXT("Destroying %s, which is in no world"), *GetName());
        }
    }
    return bActorIsBeingDestroyed;
}

void AActor::K2_DestroyActor() { Destroy(); }

void AActor::Destroyed() {
    RouteEndPlay(EEndPlayReason::Destroyed);
    ReceiveDestroyed();
    OnDestroyed.Broadcast(this);
}

void AActor::OnLeaveWorld() {
    // Others attached to this stay where they are.
    TArray<AActor*> AttachedActors;
    GetAttachedActors(AttachedActors);
    for (AActor* AttachedActor : AttachedActors) {
        for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
            if (USceneComponent* SceneComponent = Cast<USceneComponent>(Component.Get())) {
                AttachedActor->DetachAllSceneComponents(SceneComponent, FDetachmentTransformRules::KeepWorldTransform);
            }
        }
    }
    if (RootComponent && RootComponent->GetAttachParent() && RootComponent->GetAttachParent()->GetOwner() != this) {
        RootComponent->DetachFromComponent(FDetachmentTransformRules::KeepWorldTransform);
    }
    SetOwner(nullptr);
    const TArray<TObjectPtr<AActor>> FormerChildren = Children;
    for (AActor* Child : FormerChildren) {
        if (Child) {
            Child->SetOwner(nullptr);
        }
    }
}

void AActor::SetLifeSpan(float InLifespan) {
    InitialLifeSpan = InLifespan;
    UWorld* World = GetWorld();
    if (!World) {
        return;
    }
    if (InLifespan > 0.f) {
        World->GetTimerManager().SetTimer(TimerHandle_LifeSpanExpired, this, &AActor::LifeSpanExpired, InLifespan);
    } else {
        World->GetTimerManager().ClearTimer(TimerHandle_LifeSpanExpired);
    }
}

float AActor::GetLifeSpan() const {
    const UWorld* World = GetWorld();
    const float Remaining = World ? World->GetTimerManager().GetTimerRemaining(TimerHandle_LifeSpanExpired) : 0.f;
    return FMath::Max(Remaining, 0.f);
}

bool AActor::CheckStillInWorld() {
    const UWorld* World = GetWorld();
    const AWorldSettings* Settings = World ? World->GetWorldSettings(false, false) : nullptr;
    if (bActorIsBeingDestroyed || !Settings) {
        return false;
    }
    if (Settings->bEnableWorldBoundsChecks && GetActorLocation().Z < static_cast<double>(Settings->KillZ)) {
        UE_LOG(LogActor, Log, TEXT("%s fell out of the world (KillZ %g)"), *GetName(),
            static_cast<double>(Settings->KillZ));
        Destroy();
        return false;
    }
    return true;
}

void AActor::LifeSpanExpired() { Destroy(); }

float AActor::GetGameTimeSinceCreation() const {
    const UWorld* World = GetWorld();
    return World ? static_cast<float>(World->GetTimeSeconds() - CreationTime) : 0.f;
}

bool AActor::HasAuthority() const { return GetLocalRole() == ROLE_Authority; }

void AActor::Reset() { K2_OnReset(); }

// ------------------------------------------------------------------------------------------------------------------
// tick

void AActor::Tick(float DeltaSeconds) {
    // Native classes implement this function, not the event.
    if (!GetClass()->HasAnyClassFlags(CLASS_Native)) {
        ReceiveTick(DeltaSeconds);
    }
    if (UWorld* World = GetWorld()) {
        World->GetLatentActionManager().ProcessLatentActions(this, World->GetDeltaSeconds());
    }
    if (bAutoDestroyWhenFinished) {
        bool bFinished = true;
        for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
            bFinished &= Component->IsReadyForOwnerToAutoDestroy();
        }
        if (bFinished) {
            Destroy();
        }
    }
}

void AActor::TickActor(float DeltaTime, ELevelTick, FActorTickFunction&) {
    if (!bActorIsBeingDestroyed && GetWorld()) {
        Tick(DeltaTime);
    }
}

void AActor::RegisterActorTickFunctions(bool bRegister) {
    if (bRegister) {
        if (PrimaryActorTick.bCanEverTick && !IsTemplate()) {
            PrimaryActorTick.Target = this;
            PrimaryActorTick.SetTickFunctionEnable(
                PrimaryActorTick.bStartWithTickEnabled || PrimaryActorTick.IsTickFunctionEnabled());
            PrimaryActorTick.RegisterTickFunction(GetLevel());
        }
    } else if (PrimaryActorTick.IsTickFunctionRegistered()) {
        PrimaryActorTick.UnRegisterTickFunction();
    }
}

void AActor::RegisterAllActorTickFunctions(bool bRegister, bool bDoComponents) {
    if (!IsTemplate() && bTickFunctionsRegistered != static_cast<uint8>(bRegister)) {
        RegisterActorTickFunctions(bRegister);
        bTickFunctionsRegistered = bRegister;
    }
    if (bDoComponents) {
        for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
            Component->RegisterAllComponentTickFunctions(bRegister);
        }
    }
}

void AActor::SetActorTickEnabled(bool bEnabled) {
    if (PrimaryActorTick.bCanEverTick && !IsTemplate()) {
        PrimaryActorTick.SetTickFunctionEnable(bEnabled);
    }
}

bool AActor::IsActorTickEnabled() const { return PrimaryActorTick.IsTickFunctionEnabled(); }

void AActor::SetActorTickInterval(float TickInterval) { PrimaryActorTick.TickInterval = TickInterval; }

float AActor::GetActorTickInterval() const { return PrimaryActorTick.TickInterval; }

void AActor::SetTickGroup(ETickingGroup NewTickGroup) { PrimaryActorTick.TickGroup = NewTickGroup; }

void AActor::SetTickableWhenPaused(bool bTickableWhenPaused) {
    PrimaryActorTick.bTickEvenWhenPaused = bTickableWhenPaused;
}

bool AActor::GetTickableWhenPaused() { return PrimaryActorTick.bTickEvenWhenPaused; }

void AActor::AddTickPrerequisiteActor(AActor* PrerequisiteActor) {
    if (PrimaryActorTick.bCanEverTick && PrerequisiteActor && PrerequisiteActor->PrimaryActorTick.bCanEverTick) {
        PrimaryActorTick.AddPrerequisite(PrerequisiteActor, PrerequisiteActor->PrimaryActorTick);
    }
}

void AActor::AddTickPrerequisiteComponent(UActorComponent* PrerequisiteComponent) {
    if (PrimaryActorTick.bCanEverTick && PrerequisiteComponent &&
        PrerequisiteComponent->PrimaryComponentTick.bCanEverTick) {
        PrimaryActorTick.AddPrerequisite(PrerequisiteComponent, PrerequisiteComponent->PrimaryComponentTick);
    }
}

void AActor::RemoveTickPrerequisiteActor(AActor* PrerequisiteActor) {
    if (PrerequisiteActor) {
        PrimaryActorTick.RemovePrerequisite(PrerequisiteActor, PrerequisiteActor->PrimaryActorTick);
    }
}

void AActor::RemoveTickPrerequisiteComponent(UActorComponent* PrerequisiteComponent) {
    if (PrerequisiteComponent) {
        PrimaryActorTick.RemovePrerequisite(PrerequisiteComponent, PrerequisiteComponent->PrimaryComponentTick);
    }
}

float AActor::GetActorTimeDilation() const {
    const UWorld* World = GetWorld();
    const AWorldSettings* Settings = World ? World->GetWorldSettings() : nullptr;
    return CustomTimeDilation * (Settings ? Settings->GetEffectiveTimeDilation() : 1.f);
}

// ---------------------------------------------------------------------------------------------- visibility and
// collision

void AActor::SetActorHiddenInGame(bool bNewHidden) {
    if (static_cast<bool>(bHidden) != bNewHidden) {
        SetHidden(bNewHidden);
        MarkComponentsRenderStateDirty();
    }
}

void AActor::SetActorEnableCollision(bool bNewActorEnableCollision) {
    bActorEnableCollision = bNewActorEnableCollision;
}

bool AActor::GetActorEnableCollision() const { return bActorEnableCollision; }

void AActor::NotifyActorBeginOverlap(AActor* OtherActor) { ReceiveActorBeginOverlap(OtherActor); }

void AActor::NotifyActorEndOverlap(AActor* OtherActor) { ReceiveActorEndOverlap(OtherActor); }

void AActor::NotifyHit(UPrimitiveComponent* MyComp, AActor* Other, UPrimitiveComponent* OtherComp, bool bSelfMoved,
    FVector HitLocation, FVector HitNormal, FVector NormalImpulse, const FHitResult& Hit) {
    ReceiveHit(MyComp, Other, OtherComp, bSelfMoved, HitLocation, HitNormal, NormalImpulse, Hit);
}

// ------------------------------------------------------------------------------------------------- owner, instigator,
// tags

void AActor::SetOwner(AActor* NewOwner) {
    if (Owner == NewOwner || (NewOwner && bActorIsBeingDestroyed)) {
        return;
    }
    if (NewOwner && NewOwner->IsOwnedBy(this)) {
        UE_LOG(LogActor, Error, TEXT("SetOwner: %s cannot own %s, which is its owner already"), *NewOwner->GetName(),
            *GetName());
        return;
    }
    if (Owner) {
        Owner->Children.Remove(this);
    }
    Owner = NewOwner;
    if (Owner) {
        Owner->Children.AddUnique(this);
    }
}

AActor* AActor::GetOwner() const { return Owner; }

bool AActor::IsOwnedBy(const AActor* TestOwner) const {
    for (const AActor* Actor = this; Actor; Actor = Actor->Owner) {
        if (Actor == TestOwner) {
            return true;
        }
    }
    return false;
}

APawn* AActor::GetInstigator() const { return Instigator; }

void AActor::SetInstigator(APawn* InInstigator) { Instigator = InInstigator; }

AController* AActor::GetInstigatorController() const { return Instigator ? Instigator->GetController() : nullptr; }

bool AActor::ActorHasTag(FName Tag) const { return Tag != NAME_None && Tags.Contains(Tag); }

// ----------------------------------------------------------------------------------------------------------- view
// target

void AActor::GetActorEyesViewPoint(FVector& OutLocation, FRotator& OutRotation) const {
    OutLocation = GetActorLocation();
    OutRotation = GetActorRotation();
}

void AActor::CalcCamera(float DeltaTime, FMinimalViewInfo& OutResult) {
    if (bFindCameraComponentWhenViewTarget) {
        for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
            UCameraComponent* Camera = Cast<UCameraComponent>(Component.Get());
            if (Camera && Camera->IsActive()) {
                Camera->GetCameraView(DeltaTime, OutResult);
                return;
            }
        }
    }
    GetActorEyesViewPoint(OutResult.Location, OutResult.Rotation);
}

bool AActor::HasActiveCameraComponent(bool bForceFindCamera) const {
    if (bFindCameraComponentWhenViewTarget || bForceFindCamera) {
        for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
            const UCameraComponent* Camera = Cast<UCameraComponent>(Component.Get());
            if (Camera && Camera->IsActive()) {
                return true;
            }
        }
    }
    return false;
}

void AActor::BecomeViewTarget(APlayerController* PC) { K2_OnBecomeViewTarget(PC); }

void AActor::EndViewTarget(APlayerController* PC) { K2_OnEndViewTarget(PC); }

FVector AActor::GetTargetLocation(AActor*) const { return GetActorLocation(); }
