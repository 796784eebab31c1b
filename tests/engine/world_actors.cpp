// SPDX-License-Identifier: MIT
// Spawning, life and destruction of actors and components.
#include "engine_fixture.h"

#include "Components/SceneComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/StaticMeshActor.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/GameStateBase.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerStart.h"
#include "UObject/WeakObjectPtrTemplates.h"
#include "WorldTestTypes.h"

TEST_CASE_FIXTURE(EngineFixture, "actor life: order of calls, spawned before play") {
    FTestJournal::Take();
    AJournalActor* actor = World->SpawnActor<AJournalActor>();
    CHECK(FTestJournal::Take() == TEXT("c.OnRegister"));
    CHECK_FALSE(actor->IsActorInitialized());
    BeginPlay();
    CHECK(
        FTestJournal::Take() == TEXT("PreInitialize c.Initialize PostInitialize WorldBeginPlay BeginPlay c.BeginPlay"));
    CHECK(actor->HasActorBegunPlay());
    Tick(0.1f);
    CHECK(FTestJournal::Take() == TEXT("Tick c.Tick")); // the actor in TG_PrePhysics, its component in TG_DuringPhysics
    actor->Destroy();
    CHECK(
        FTestJournal::Take() == TEXT("Destroyed EndPlay:Destroyed c.EndPlay:Destroyed c.Uninitialize c.OnUnregister"));
}

TEST_CASE_FIXTURE(EngineFixture, "actor life: order of calls, spawned during play, ended by the world") {
    BeginPlay();
    FTestJournal::Take();
    World->SpawnActor<AJournalActor>();
    CHECK(FTestJournal::Take() == TEXT("c.OnRegister PreInitialize c.Initialize PostInitialize BeginPlay c.BeginPlay"));
    World->BeginTearingDown();
    World->EndPlay(EEndPlayReason::Quit);
    CHECK(FTestJournal::Take() == TEXT("EndPlay:Quit c.EndPlay:Quit c.Uninitialize"));
}

TEST_CASE_FIXTURE(EngineFixture, "destroy: out of the world at once, an object until the garbage is collected") {
    BeginPlay();
    AJournalActor* actor = World->SpawnActor<AJournalActor>();
    AJournalActor* listener = World->SpawnActor<AJournalActor>();
    actor->OnDestroyed.AddDynamic(listener, &AJournalActor::HandleDestroyed);
    const FName name = actor->GetFName();
    TWeakObjectPtr<AActor> weak = actor;
    TWeakObjectPtr<UActorComponent> weak_component = actor->Journal.Get();
    const int32 count = World->GetActorCount();
    FTestJournal::Take();

    CHECK(actor->Destroy());
    CHECK(FTestJournal::Take().Contains(TEXT("OnDestroyed:")));
    CHECK(World->GetActorCount() == count - 1);
    CHECK(actor->IsActorBeingDestroyed());
    CHECK_FALSE(IsValid(actor));
    CHECK_FALSE(weak.IsValid());
    CHECK(weak.Get(true) == actor); // still there
    CHECK_FALSE(weak_component.IsValid());
    CHECK(FindObject<AActor>(World->PersistentLevel, *name.ToString()) != nullptr);
    CHECK(actor->Destroy()); // again: already
    Tick(0.1f);
    CHECK(FTestJournal::Take() == TEXT("Tick c.Tick")); // the listener only

    Engine->ForceGarbageCollection(true);
    Tick(0.1f);
    CHECK(weak.Get(true) == nullptr);
    CHECK(weak_component.Get(true) == nullptr);
    CHECK(FindObject<AActor>(World->PersistentLevel, *name.ToString()) == nullptr);
}

TEST_CASE_FIXTURE(EngineFixture, "destroy: during iteration and in its own tick") {
    BeginPlay();
    for (int index = 0; index < 5; ++index) {
        World->SpawnActor<AJournalActor>();
    }
    int32 visited = 0;
    for (TActorIterator<AJournalActor> it(World); it; ++it) {
        ++visited;
        it->bDestroyInTick = visited % 2 == 0;
        if (visited == 3) {
            it->Destroy();
        }
        if (visited == 5) {
            World->SpawnActor<AJournalActor>(); // visited too
        }
    }
    CHECK(visited == 6);
    Tick(0.1f);
    int32 left = 0;
    for (AJournalActor* actor : TActorRange<AJournalActor>(World)) {
        CHECK(actor->TickCount == 1);
        ++left;
    }
    CHECK(left == 2); // of six: the third was destroyed in the loop, the second, fourth and sixth in their tick
    Tick(0.1f);
    CHECK_FALSE(World->PersistentLevel->Actors.Contains(nullptr));
}

TEST_CASE_FIXTURE(EngineFixture, "spawn: names, transform, deferred, what is refused") {
    BeginPlay();
    FActorSpawnParameters parameters;
    parameters.Name = FName(TEXT("Chair"));
    AActor* chair = World->SpawnActor<AStaticMeshActor>(FVector(1, 2, 3), FRotator(0, 90, 0), parameters);
    REQUIRE(chair);
    CHECK(chair->GetName() == TEXT("Chair"));
    CHECK(chair->GetPathName() == World->GetPathName() + TEXT(":PersistentLevel.Chair"));
    CHECK(chair->GetActorLocation() == FVector(1, 2, 3));
    CHECK(chair->GetActorRotation().Equals(FRotator(0, 90, 0), 1e-6));
    parameters.NameMode = ESpawnActorNameMode::Required_ReturnNull;
    CHECK(World->SpawnActor<AStaticMeshActor>(parameters) == nullptr);
    parameters.Name = FName(TEXT("chair")); // names compare without case
    CHECK(World->SpawnActor<AStaticMeshActor>(parameters) == nullptr);
    parameters.NameMode = ESpawnActorNameMode::Requested;
    AActor* other = World->SpawnActor<AStaticMeshActor>(parameters);
    REQUIRE(other);
    CHECK(other->GetFName() != chair->GetFName());

    CHECK(World->SpawnActor(nullptr) == nullptr);
    CHECK(World->SpawnActor(UObject::StaticClass()) == nullptr);
    CHECK(World->SpawnActor(AInfo::StaticClass()) == nullptr); // abstract
    const FVector not_a_number(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    CHECK(World->SpawnActor(AStaticMeshActor::StaticClass(), &not_a_number) == nullptr);

    AJournalActor* deferred =
        World->SpawnActorDeferred<AJournalActor>(AJournalActor::StaticClass(), FTransform::Identity);
    REQUIRE(deferred);
    CHECK_FALSE(deferred->HasActorBegunPlay());
    deferred->FinishSpawning(FTransform::Identity);
    CHECK(deferred->HasActorBegunPlay());
    CHECK(deferred->IsActorFinishedSpawning());

    AActor* owned = nullptr;
    {
        FActorSpawnParameters owner_parameters;
        owner_parameters.Owner = chair;
        owned = World->SpawnActor<AJournalActor>(owner_parameters);
    }
    CHECK(owned->GetOwner() == chair);
    CHECK(chair->Children.Contains(owned));
    chair->SetOwner(owned); // a cycle is refused
    CHECK(chair->GetOwner() == nullptr);
    chair->Destroy();
    CHECK(owned->GetOwner() == nullptr);
}

TEST_CASE_FIXTURE(EngineFixture, "spawn: delegates tell, world settings stay") {
    BeginPlay();
    TArray<AActor*> spawned, destroyed, level_added;
    const FDelegateHandle handle = World->AddOnActorSpawnedHandler(
        FOnActorSpawned::FDelegate::CreateLambda([&](AActor* actor) { spawned.Add(actor); }));
    World->AddOnActorDestroyedHandler(
        FOnActorDestroyed::FDelegate::CreateLambda([&](AActor* actor) { destroyed.Add(actor); }));
    Engine->OnLevelActorAdded().AddLambda([&](AActor* actor) { level_added.Add(actor); });
    AActor* actor = World->SpawnActor<AActor>();
    CHECK(spawned == TArray<AActor*>{actor});
    CHECK(level_added == TArray<AActor*>{actor});
    actor->Destroy();
    CHECK(destroyed == TArray<AActor*>{actor});
    World->RemoveOnActorSpawnedHandler(handle);
    World->SpawnActor<AActor>();
    CHECK(spawned.Num() == 1);
    CHECK_FALSE(World->DestroyActor(World->GetWorldSettings()));
}

TEST_CASE_FIXTURE(EngineFixture, "tags and components: found by class, tag and name without case") {
    BeginPlay();
    AStaticMeshActor* actor = World->SpawnActor<AStaticMeshActor>();
    actor->Tags.Add(FName(TEXT("Kitchen")));
    CHECK(actor->ActorHasTag(FName(TEXT("kitchen"))));
    CHECK_FALSE(actor->ActorHasTag(FName(TEXT("Bath"))));
    CHECK_FALSE(actor->ActorHasTag(NAME_None));

    UActorComponent* extra =
        actor->AddComponentByClass(USceneComponent::StaticClass(), false, FTransform(FVector(0, 0, 50)), false);
    REQUIRE(extra);
    extra->ComponentTags.Add(FName(TEXT("Extra")));
    CHECK(extra->IsRegistered());
    CHECK(extra->HasBegunPlay());
    CHECK(Cast<USceneComponent>(extra)->GetAttachParent() == actor->GetRootComponent());
    CHECK(actor->GetComponentByClass(UStaticMeshComponent::StaticClass()) == actor->GetRootComponent());
    CHECK(actor->K2_GetComponentsByClass(USceneComponent::StaticClass()).Num() == 2);
    CHECK(actor->GetComponentsByTag(UActorComponent::StaticClass(), FName(TEXT("extra"))).Num() == 1);
    CHECK(actor->FindComponentByTag(UActorComponent::StaticClass(), FName(TEXT("extra"))) == extra);
    CHECK(actor->AddComponentByClass(UActorComponent::StaticClass(), false, FTransform::Identity, false) ==
          nullptr);                                        // abstract
    extra->K2_DestroyComponent(World->GetWorldSettings()); // not its owner
    CHECK_FALSE(extra->IsBeingDestroyed());
    extra->K2_DestroyComponent(actor);
    CHECK_FALSE(IsValid(extra));
    CHECK(actor->K2_GetComponentsByClass(USceneComponent::StaticClass()).Num() == 1);
}

TEST_CASE_FIXTURE(EngineFixture, "component: activation") {
    BeginPlay();
    AJournalActor* actor = World->SpawnActor<AJournalActor>();
    UJournalComponent* component = actor->Journal;
    CHECK_FALSE(component->IsActive());
    component->Activate();
    CHECK(component->IsActive());
    component->Deactivate();
    CHECK_FALSE(component->IsActive());
    CHECK_FALSE(component->IsComponentTickEnabled());
    FTestJournal::Take();
    Tick(0.1f);
    CHECK(FTestJournal::Take() == TEXT("Tick"));
    component->SetActive(true);
    Tick(0.1f);
    CHECK(FTestJournal::Take() == TEXT("Tick c.Tick"));
}

TEST_CASE_FIXTURE(EngineFixture, "attachment: destroyed parents let go, children keep their place") {
    BeginPlay();
    AStaticMeshActor* table = World->SpawnActor<AStaticMeshActor>(FVector(100, 0, 0), FRotator::ZeroRotator);
    AStaticMeshActor* cup = World->SpawnActor<AStaticMeshActor>(FVector(110, 0, 80), FRotator::ZeroRotator);
    table->SetMobility(EComponentMobility::Movable);
    cup->SetMobility(EComponentMobility::Movable);
    CHECK(cup->AttachToActor(table, FAttachmentTransformRules::KeepWorldTransform));
    CHECK(cup->GetAttachParentActor() == table);
    CHECK(cup->IsAttachedTo(table));
    TArray<AActor*> attached;
    table->GetAttachedActors(attached);
    CHECK(attached == TArray<AActor*>{cup});
    table->SetActorLocation(FVector(200, 0, 0));
    CHECK(cup->GetActorLocation().Equals(FVector(210, 0, 80), 1e-6));
    table->Destroy();
    CHECK(cup->GetAttachParentActor() == nullptr);
    CHECK(cup->GetActorLocation().Equals(FVector(210, 0, 80), 1e-6));
}

TEST_CASE_FIXTURE(EngineFixture, "life span: an actor expires by world time") {
    BeginPlay();
    AActor* actor = World->SpawnActor<AJournalActor>();
    actor->SetLifeSpan(0.5f);
    Tick(0.25f);
    CHECK(actor->GetLifeSpan() > 0.0f);
    CHECK(IsValid(actor));
    Tick(0.3f);
    Tick(0.3f);
    CHECK_FALSE(IsValid(actor));
}

TEST_CASE_FIXTURE(EngineFixture, "world bounds: what falls below KillZ is destroyed") {
    BeginPlay();
    AStaticMeshActor* actor = World->SpawnActor<AStaticMeshActor>();
    actor->SetMobility(EComponentMobility::Movable);
    CHECK(actor->CheckStillInWorld());
    World->GetWorldSettings()->KillZ = -100.0f;
    actor->SetActorLocation(FVector(0, 0, -101));
    World->GetWorldSettings()->bEnableWorldBoundsChecks = false;
    CHECK(actor->CheckStillInWorld());
    World->GetWorldSettings()->bEnableWorldBoundsChecks = true;
    CHECK_FALSE(actor->CheckStillInWorld());
    CHECK_FALSE(IsValid(actor));
}

TEST_CASE_FIXTURE(EngineFixture, "players: game mode, state, controller, pawn, camera") {
    APlayerStart* start = World->SpawnActor<APlayerStart>(FVector(10, 20, 30), FRotator(0, 45, 0));
    BeginPlay();
    REQUIRE(start);
    AGameModeBase* game_mode = World->GetAuthGameMode();
    REQUIRE(game_mode);
    CHECK(World->GetGameState() == game_mode->GameState);
    CHECK(game_mode->GetNumPlayers() == 1);
    REQUIRE(Player());
    CHECK(World->GetGameState()->PlayerArray.Num() == 1);
    APawn* pawn = Player()->GetPawn();
    REQUIRE(pawn);
    CHECK(pawn->GetController() == Player());
    CHECK(pawn->GetActorLocation().Equals(FVector(10, 20, 30), 1e-6));
    Tick(0.1f);
    FVector location;
    FRotator rotation;
    Player()->GetPlayerViewPoint(location, rotation);
    CHECK(location.Equals(FVector(10, 20, 30), 1e-6));
    CHECK(rotation.Equals(FRotator(0, 45, 0), 1e-6));
    CHECK(Player()->PlayerCameraManager->ViewTarget.POV.Location.Equals(location, 1e-6));

    Player()->UnPossess();
    CHECK(Player()->GetPawn() == nullptr);
    CHECK(pawn->GetController() == nullptr);
    Player()->Possess(pawn);
    CHECK(pawn->IsPlayerControlled());
    AActor* view = World->SpawnActor<AStaticMeshActor>(FVector(0, 0, 500), FRotator(-90, 0, 0));
    Player()->SetViewTargetWithBlend(view, 1.0f);
    Tick(0.25f);
    Player()->GetPlayerViewPoint(location, rotation);
    CHECK(location.Z > 30.0);
    CHECK(location.Z < 500.0);
    for (int frame = 0; frame < 5; ++frame) {
        Tick(0.25f);
    }
    Player()->GetPlayerViewPoint(location, rotation);
    CHECK(location.Equals(FVector(0, 0, 500), 1e-4));
    view->Destroy();
    Tick(0.25f);
    CHECK(Player()->GetViewTarget() == pawn);
    pawn->Destroy();
    CHECK(Player()->GetPawn() == nullptr);
    Tick(0.25f);
    CHECK(Player()->GetViewTarget() == Player());
}
