// SPDX-License-Identifier: MIT
#include "WorldTestTypes.h"

#include "Subsystems/SubsystemCollection.h"

#include "Modules/ModuleManager.h"

IMPLEMENT_MODULE(FDefaultModuleImpl, EngineTestTypes)

TArray<FString>& FTestJournal::Get() {
    static TArray<FString> Journal;
    return Journal;
}

void FTestJournal::Add(const FString& Entry) { Get().Add(Entry); }

FString FTestJournal::Take() {
    const FString Result = FString::Join(Get(), TEXT(" "));
    Get().Reset();
    return Result;
}

namespace {
FString ReasonText(EEndPlayReason::Type Reason) {
    switch (Reason) {
    case EEndPlayReason::Destroyed:
        return TEXT("Destroyed");
    case EEndPlayReason::LevelTransition:
        return TEXT("LevelTransition");
    case EEndPlayReason::Quit:
        return TEXT("Quit");
    default:
        return TEXT("Other");
    }
}
} // namespace

UJournalComponent::UJournalComponent() {
    PrimaryComponentTick.bCanEverTick = true;
    bWantsInitializeComponent = true;
}

void UJournalComponent::OnRegister() {
    Super::OnRegister();
    FTestJournal::Add(TEXT("c.OnRegister"));
}

void UJournalComponent::OnUnregister() {
    FTestJournal::Add(TEXT("c.OnUnregister"));
    Super::OnUnregister();
}

void UJournalComponent::InitializeComponent() {
    Super::InitializeComponent();
    FTestJournal::Add(TEXT("c.Initialize"));
}

void UJournalComponent::UninitializeComponent() {
    FTestJournal::Add(TEXT("c.Uninitialize"));
    Super::UninitializeComponent();
}

void UJournalComponent::BeginPlay() {
    Super::BeginPlay();
    FTestJournal::Add(TEXT("c.BeginPlay"));
}

void UJournalComponent::EndPlay(const EEndPlayReason::Type EndPlayReason) {
    FTestJournal::Add(TEXT("c.EndPlay:") + ReasonText(EndPlayReason));
    Super::EndPlay(EndPlayReason);
}

void UJournalComponent::TickComponent(
    float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) {
    Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
    FTestJournal::Add(TEXT("c.Tick"));
}

AJournalActor::AJournalActor() {
    PrimaryActorTick.bCanEverTick = true;
    Journal = CreateDefaultSubobject<UJournalComponent>(TEXT("Journal"));
}

void AJournalActor::PreInitializeComponents() {
    Super::PreInitializeComponents();
    FTestJournal::Add(TEXT("PreInitialize"));
}

void AJournalActor::PostInitializeComponents() {
    Super::PostInitializeComponents();
    FTestJournal::Add(TEXT("PostInitialize"));
}

void AJournalActor::BeginPlay() {
    FTestJournal::Add(TEXT("BeginPlay"));
    Super::BeginPlay();
}

void AJournalActor::EndPlay(const EEndPlayReason::Type EndPlayReason) {
    FTestJournal::Add(TEXT("EndPlay:") + ReasonText(EndPlayReason));
    Super::EndPlay(EndPlayReason);
}

void AJournalActor::Destroyed() {
    FTestJournal::Add(TEXT("Destroyed"));
    Super::Destroyed();
}

void AJournalActor::Tick(float DeltaSeconds) {
    Super::Tick(DeltaSeconds);
    FTestJournal::Add(TEXT("Tick"));
    TickedSeconds += DeltaSeconds;
    ++TickCount;
    if (bDestroyInTick) {
        Destroy();
    }
}

void AJournalActor::HandleDestroyed(AActor* DestroyedActor) {
    FTestJournal::Add(TEXT("OnDestroyed:") + DestroyedActor->GetName());
}

void AJournalActor::HandleTimer() { FTestJournal::Add(TEXT("Timer")); }

void ULatentTarget::Resume(int32 Linkage) {
    LastLinkage = Linkage;
    ++CallCount;
}

AUnpauseableGameMode::AUnpauseableGameMode(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    bPauseable = false;
}

void UJournalEngineSubsystem::Initialize(FSubsystemCollectionBase& Collection) { FTestJournal::Add(TEXT("Engine+")); }

void UJournalEngineSubsystem::Deinitialize() { FTestJournal::Add(TEXT("Engine-")); }

void UJournalGameInstanceSubsystem::Initialize(FSubsystemCollectionBase& Collection) {
    FTestJournal::Add(TEXT("GameInstance+"));
}

void UJournalGameInstanceSubsystem::Deinitialize() { FTestJournal::Add(TEXT("GameInstance-")); }

void UJournalLocalPlayerSubsystem::Initialize(FSubsystemCollectionBase& Collection) {
    FTestJournal::Add(TEXT("LocalPlayer+"));
}

void UJournalLocalPlayerSubsystem::Deinitialize() { FTestJournal::Add(TEXT("LocalPlayer-")); }

void UADependentWorldSubsystem::Initialize(FSubsystemCollectionBase& Collection) {
    Collection.InitializeDependency<UJournalTickingSubsystem>();
    FTestJournal::Add(TEXT("Dependent+"));
}

void UADependentWorldSubsystem::Deinitialize() { FTestJournal::Add(TEXT("Dependent-")); }

void UADependentWorldSubsystem::OnWorldBeginPlay(UWorld& InWorld) { FTestJournal::Add(TEXT("WorldBeginPlay")); }

void UJournalTickingSubsystem::Initialize(FSubsystemCollectionBase& Collection) {
    Super::Initialize(Collection);
    FTestJournal::Add(TEXT("Ticking+"));
}

void UJournalTickingSubsystem::Deinitialize() {
    Super::Deinitialize();
    FTestJournal::Add(TEXT("Ticking-"));
}

void UJournalTickingSubsystem::Tick(float DeltaTime) { TickedSeconds += DeltaTime; }
