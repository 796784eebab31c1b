// SPDX-License-Identifier: MIT
// UGameplayStatics and UKismetSystemLibrary on a running world.
#include "engine_fixture.h"

#include "Components/BoxComponent.h"
#include "Components/SceneComponent.h"
#include "Engine/PointLight.h"
#include "Engine/StaticMeshActor.h"
#include "Engine/TargetPoint.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/PlayerController.h"
#include "HAL/IConsoleManager.h"
#include "Kismet/GameplayStatics.h"
#include "Kismet/KismetSystemLibrary.h"

using Statics = UGameplayStatics;
using System = UKismetSystemLibrary;

TEST_CASE_FIXTURE(EngineFixture, "gameplay statics: actors by class, tag and distance") {
    BeginPlay();
    APointLight* lamp = World->SpawnActor<APointLight>(FVector(100, 0, 0), FRotator(0, 0, 0));
    ATargetPoint* near_point = World->SpawnActor<ATargetPoint>(FVector(10, 0, 0), FRotator(0, 0, 0));
    ATargetPoint* far_point = World->SpawnActor<ATargetPoint>(FVector(0, 0, 500), FRotator(0, 0, 0));
    lamp->Tags.Add(FName(TEXT("Kitchen")));
    far_point->Tags.Add(FName(TEXT("kitchen"))); // names compare without case

    TArray<AActor*> actors;
    Statics::GetAllActorsOfClass(World, ATargetPoint::StaticClass(), actors);
    REQUIRE(actors.Num() == 2);
    CHECK(actors[0] == near_point);
    CHECK(actors[1] == far_point);
    CHECK(Statics::GetActorOfClass(lamp, APointLight::StaticClass()) == lamp); // any object in the world is a context
    CHECK(Statics::GetActorOfClass(World, AStaticMeshActor::StaticClass()) == nullptr);
    float distance = 0.0f;
    CHECK(Statics::FindNearestActor(FVector(0, 0, 0), actors, distance) == near_point);
    CHECK(distance == doctest::Approx(10.0f));
    CHECK(Statics::GetActorArrayAverageLocation(actors).Equals(FVector(5, 0, 250)));
    Statics::GetAllActorsWithTag(World, FName(TEXT("KITCHEN")), actors);
    CHECK(actors.Num() == 2);
    Statics::GetAllActorsOfClassWithTag(World, ATargetPoint::StaticClass(), FName(TEXT("Kitchen")), actors);
    CHECK(actors.Num() == 1);
    Statics::GetAllActorsWithTag(World, NAME_None, actors);
    CHECK(actors.Num() == 0);
    near_point->Destroy();
    Statics::GetAllActorsOfClass(World, ATargetPoint::StaticClass(), actors);
    CHECK(actors.Num() == 1); // destroyed ones are out of the world at once
    Statics::GetAllActorsOfClass(nullptr, ATargetPoint::StaticClass(), actors);
    CHECK(actors.Num() == 0);
}

TEST_CASE_FIXTURE(EngineFixture, "gameplay statics: deferred spawning") {
    BeginPlay();
    const FTransform transform(FRotator(0, 90, 0), FVector(1, 2, 3));
    AActor* actor = Statics::BeginDeferredActorSpawnFromClass(World, AStaticMeshActor::StaticClass(), transform);
    REQUIRE(actor);
    CHECK_FALSE(actor->HasActorBegunPlay());
    CHECK(Statics::FinishSpawningActor(actor, transform) == actor);
    CHECK(actor->HasActorBegunPlay());
    CHECK(actor->GetActorLocation().Equals(FVector(1, 2, 3)));
    CHECK(Statics::BeginDeferredActorSpawnFromClass(World, nullptr, transform) == nullptr);
    CHECK(Statics::FinishSpawningActor(nullptr, transform) == nullptr);
}

TEST_CASE_FIXTURE(EngineFixture, "gameplay statics: bounds, options and time dilation") {
    BeginPlay();
    AActor* actor = World->SpawnActor<AActor>();
    UBoxComponent* box = NewObject<UBoxComponent>(actor);
    actor->SetRootComponent(box);
    box->RegisterComponent();
    box->SetBoxExtent(FVector(10, 20, 30));
    actor->SetActorLocation(FVector(100, 0, 0));
    FVector center, extent;
    Statics::GetActorArrayBounds(TArray<AActor*>{actor}, false, center, extent);
    CHECK(center.Equals(FVector(100, 0, 0)));
    CHECK(extent.Equals(FVector(10, 20, 30)));
    float radius = 0.0f;
    System::GetComponentBounds(box, center, extent, radius);
    CHECK(extent.Equals(FVector(10, 20, 30)));

    CHECK(Statics::ParseOption(TEXT("?Name=Bob?Level=7"), TEXT("level")) == TEXT("7"));
    CHECK(Statics::GetIntOption(TEXT("?Name=Bob?Level=7"), TEXT("Level"), 1) == 7);
    CHECK(Statics::HasOption(TEXT("?listen"), TEXT("Listen")));
    CHECK_FALSE(Statics::HasOption(TEXT("?listen"), TEXT("Li")));
    FString key, value;
    Statics::GetKeyValue(TEXT("a=b"), key, value);
    CHECK(key == TEXT("a"));
    CHECK(value == TEXT("b"));

    CHECK(Statics::GetGlobalTimeDilation(World) == 1.0f);
    Statics::SetGlobalTimeDilation(World, 0.5f);
    const double before = Statics::GetTimeSeconds(World);
    const double real_before = Statics::GetRealTimeSeconds(World);
    Tick(0.25f);
    CHECK(Statics::GetTimeSeconds(World) - before == doctest::Approx(0.125));
    CHECK(Statics::GetRealTimeSeconds(World) - real_before == doctest::Approx(0.25));
    CHECK(Statics::GetWorldDeltaSeconds(World) == doctest::Approx(0.125));
}

TEST_CASE_FIXTURE(EngineFixture, "system library: objects, literals, properties by name") {
    APointLight* lamp = World->SpawnActor<APointLight>();
    CHECK(System::IsValid(lamp));
    CHECK_FALSE(System::IsValid(nullptr));
    CHECK(System::GetObjectName(lamp) == lamp->GetName());
    CHECK(System::GetPathName(lamp) == lamp->GetPathName());
    CHECK(System::GetObjectName(nullptr) == TEXT("None"));
    CHECK(System::GetClassDisplayName(lamp->GetClass()) == TEXT("PointLight"));
    CHECK(System::Conv_ObjectToClass(lamp->GetClass(), AActor::StaticClass()) == APointLight::StaticClass());
    CHECK(System::Conv_ObjectToClass(lamp, AActor::StaticClass()) == nullptr);
    CHECK(System::MakeLiteralInt(7) == 7);
    CHECK(System::GetEngineVersion().Contains(TEXT("5.5")));

    {
        System::SetDoublePropertyByName(lamp, FName(TEXT("CustomTimeDilation")), 2.0);
        CHECK(lamp->CustomTimeDilation == 2.0f);
        System::SetIntPropertyByName(lamp, FName(TEXT("CustomTimeDilation")), 5); // another type: refused
        CHECK(lamp->CustomTimeDilation == 2.0f);
        System::SetBoolPropertyByName(lamp, FName(TEXT("bFindCameraComponentWhenViewTarget")), false);
        CHECK_FALSE(bool(lamp->bFindCameraComponentWhenViewTarget));
        System::SetVectorPropertyByName(lamp->GetRootComponent(), FName(TEXT("RelativeLocation")), FVector(1, 2, 3));
        CHECK(lamp->GetRootComponent()->GetRelativeLocation() == FVector(1, 2, 3));
        CHECK(lamp->GetActorLocation() == FVector(0, 0, 0)); // raw
        System::SetBoolPropertyByName(lamp, FName(TEXT("NoSuchProperty")), true);
    }
}

TEST_CASE_FIXTURE(EngineFixture, "system library: console variables") {
    IConsoleVariable* variable =
        IConsoleManager::Get().RegisterConsoleVariable(TEXT("spear.test.kismet"), 3, TEXT("a variable of a test"));
    CHECK(System::GetConsoleVariableIntValue(TEXT("spear.test.kismet")) == 3);
    CHECK(System::GetConsoleVariableBoolValue(TEXT("SPEAR.test.Kismet"))); // without case
    CHECK(System::GetConsoleVariableStringValue(TEXT("spear.test.kismet")) == TEXT("3"));
    CHECK(System::GetConsoleVariableIntValue(TEXT("spear.test.missing")) == 0);
    System::ExecuteConsoleCommand(World, TEXT("spear.test.kismet 8"));
    CHECK(System::GetConsoleVariableFloatValue(TEXT("spear.test.kismet")) == 8.0f);
    IConsoleManager::Get().UnregisterConsoleObject(variable, false);
}

TEST_CASE_FIXTURE(EngineFixture, "system library: a delay completes frames later") {
    BeginPlay();
    // A latent call ends by calling a function of an int on an object: here a setter, so that its arrival is seen.
    AActor* actor = World->SpawnActor<AActor>();
    UBoxComponent* box = NewObject<UBoxComponent>(actor);
    actor->SetRootComponent(box);
    box->RegisterComponent();
    const auto info = [&](int32 linkage, int32 uuid) {
        return FLatentActionInfo(linkage, uuid, TEXT("SetTranslucentSortPriority"), box);
    };

    SUBCASE("delay") {
        System::Delay(World, 0.1f, info(7, 1));
        System::Delay(World, 5.0f, info(9, 1)); // one is counting already: ignored
        for (int i = 0; i < 3; ++i) {
            Tick(0.03125f);
            CHECK(box->TranslucencySortPriority == 0);
        }
        Tick(0.03125f);
        CHECK(box->TranslucencySortPriority == 7);
        System::Delay(World, 0.01f, info(8, 1));
        Tick(0.03125f);
        CHECK(box->TranslucencySortPriority == 8);
    }
    SUBCASE("retriggerable delay") {
        System::RetriggerableDelay(World, 0.1f, info(7, 2));
        Tick(0.0625f);
        System::RetriggerableDelay(World, 0.1f, info(7, 2));
        Tick(0.0625f);
        CHECK(box->TranslucencySortPriority == 0);
        Tick(0.0625f);
        CHECK(box->TranslucencySortPriority == 7);
    }
    SUBCASE("move a component over time") {
        System::MoveComponentTo(box, FVector(100, 0, 0), FRotator(0, 90, 0), false, false, 1.0f, true,
            EMoveComponentAction::Move, info(5, 3));
        for (int i = 0; i < 8; ++i) {
            Tick(0.0625f);
        }
        CHECK(box->GetComponentLocation().Equals(FVector(50, 0, 0), 1e-3));
        CHECK(box->GetComponentRotation().Equals(FRotator(0, 45, 0), 1e-3));
        for (int i = 0; i < 8; ++i) {
            Tick(0.0625f);
        }
        CHECK(box->GetComponentLocation().Equals(FVector(100, 0, 0), 1e-6));
        CHECK(box->TranslucencySortPriority == 5);
    }
}

TEST_CASE_FIXTURE(EngineFixture, "system library: timers by function name") {
    BeginPlay();
    AActor* actor = World->SpawnActor<AActor>();
    USceneComponent* root = NewObject<USceneComponent>(actor);
    actor->SetRootComponent(root);
    root->RegisterComponent();
    root->SetRelativeLocation(FVector(1, 1, 1));
    FTimerHandle handle = System::K2_SetTimer(root, TEXT("ResetRelativeTransform"), 0.1f, false);
    CHECK(System::K2_IsValidTimerHandle(handle));
    CHECK(System::K2_IsTimerActive(root, TEXT("ResetRelativeTransform")));
    Tick(0.0625f);
    CHECK(root->GetComponentLocation().Equals(FVector(1, 1, 1)));
    CHECK(System::K2_GetTimerRemainingTimeHandle(World, handle) == doctest::Approx(0.1f)); // counts from the next tick
    Tick(0.0625f);
    CHECK(System::K2_GetTimerRemainingTimeHandle(World, handle) == doctest::Approx(0.0375f));
    Tick(0.0625f);
    CHECK(root->GetComponentLocation().Equals(FVector(0, 0, 0)));
    CHECK_FALSE(System::K2_TimerExists(root, TEXT("ResetRelativeTransform")));
    CHECK_FALSE(System::K2_IsValidTimerHandle(System::K2_SetTimer(root, TEXT("NoSuchFunction"), 0.1f, false)));
    CHECK_FALSE(System::K2_IsValidTimerHandle(
        System::K2_SetTimer(root, TEXT("SetRelativeScale3D"), 0.1f, false))); // takes something

    handle = System::K2_SetTimer(root, TEXT("ResetRelativeTransform"), 0.1f, true);
    System::K2_ClearAndInvalidateTimerHandle(World, handle);
    CHECK_FALSE(System::K2_TimerExists(root, TEXT("ResetRelativeTransform")));
}

TEST_CASE_FIXTURE(EngineFixture, "gameplay statics: pausing and players") {
    BeginPlay();
    CHECK(Statics::GetNumPlayerControllers(World) == 1);
    CHECK(Statics::GetPlayerController(World, 0) == Player());
    CHECK(Statics::GetPlayerController(World, 1) == nullptr);
    CHECK(Statics::GetPlayerController(World, -1) == nullptr);
    CHECK(Statics::GetPlayerPawn(World, 0) == Player()->GetPawn());
    CHECK(Statics::GetGameMode(World) == World->GetAuthGameMode());
    CHECK(Statics::GetGameState(World) == World->GetGameState());
    CHECK(Statics::GetGameInstance(World) == World->GetGameInstance());
    CHECK(Statics::GetObjectClass(World) == UWorld::StaticClass());

    Tick(0.1f);
    CHECK(Statics::SetGamePaused(World, true));
    CHECK(Statics::IsGamePaused(World));
    const double time = Statics::GetTimeSeconds(World);
    const double unpaused = Statics::GetUnpausedTimeSeconds(World);
    Tick(0.1f);
    CHECK(Statics::GetTimeSeconds(World) == time);
    CHECK(Statics::GetUnpausedTimeSeconds(World) > unpaused);
    CHECK(Statics::SetGamePaused(World, false));
    CHECK_FALSE(Statics::IsGamePaused(World));
    Tick(0.1f);
    CHECK(Statics::GetTimeSeconds(World) > time);
}

TEST_CASE_FIXTURE(EngineFixture, "system library: printing goes to the list on the screen until its time is over") {
    GEngine->ClearOnScreenDebugMessages();
    System::PrintString(World, TEXT("one"), true, true, FLinearColor(1.0f, 0.0f, 0.0f), 0.25f);
    System::PrintString(nullptr, TEXT("two"), true, false, FLinearColor(1.0f, 1.0f, 1.0f), 9.0f, FName(TEXT("Key")));
    System::PrintString(World, TEXT("three"), true, false, FLinearColor(1.0f, 1.0f, 1.0f), 9.0f, FName(TEXT("Key")));
    System::PrintString(World, TEXT("only in the log"), false);
    REQUIRE(GEngine->GetOnScreenDebugMessages().Num() == 2); // the third took the place of the second
    CHECK(GEngine->GetOnScreenDebugMessages()[0].ScreenMessage == TEXT("one"));
    CHECK(GEngine->GetOnScreenDebugMessages()[0].DisplayColor == FColor(255, 0, 0, 255));
    CHECK(GEngine->GetOnScreenDebugMessages()[1].ScreenMessage == TEXT("three"));
    Tick(0.3f);
    CHECK(GEngine->GetOnScreenDebugMessages().Num() == 1);
    GEngine->ClearOnScreenDebugMessages();
}
