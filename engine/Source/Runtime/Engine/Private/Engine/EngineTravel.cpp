// SPDX-License-Identifier: MIT
/** @file Loading maps. */
#include "Engine/Engine.h"
#include "Engine/GameInstance.h"
#include "Engine/GameViewportClient.h"
#include "Engine/LocalPlayer.h"
#include "Engine/SceneLoader.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/WorldSettings.h"
#include "HAL/PlatformTime.h"
#include "Misc/Paths.h"
#include "UObject/GarbageCollection.h"
#include "UObject/Package.h"

namespace {
const TCHAR* const EntryMap = TEXT("/Engine/Maps/Entry");
const TCHAR* const ScenesFolder = TEXT("/Game/Scenes/");

/** What a map name stands for. */
struct FResolvedMap {
    /** Package of the world, e.g. "/Game/Scenes/apartment". */
    FString PackageName;
    /** File of the scene; empty: an empty world. */
    FString ScenePath;
    /** Game mode named by the scene, or empty. */
    FString GameMode;
};

/** "/Game/Scenes/apartment.apartment" and "/Game/Scenes/apartment" -> "apartment"; other names stay. */
FString SceneNameOf(const FString& Map) {
    if (!Map.StartsWith(ScenesFolder, ESearchCase::IgnoreCase)) {
        return Map;
    }
    FString Name = Map.Mid(FCString::Strlen(ScenesFolder));
    int32 Dot = INDEX_NONE;
    if (Name.FindChar(TEXT('.'), Dot)) {
        Name.LeftInline(Dot);
    }
    return Name;
}

bool ResolveMap(const FString& Map, FResolvedMap& OutMap, FString& Error) {
    if (Map.IsEmpty() || Map.Equals(EntryMap, ESearchCase::IgnoreCase) ||
        Map.Equals(TEXT("Entry"), ESearchCase::IgnoreCase)) {
        OutMap.PackageName = EntryMap;
        return true;
    }
    FSceneLoader::FSettings Settings;
    if (!FSceneLoader::ReadSceneSettings(SceneNameOf(Map), Settings, Error)) {
        return false;
    }
    OutMap.PackageName = ScenesFolder + Settings.Name;
    OutMap.ScenePath = Settings.SidecarPath.IsEmpty() ? Settings.GltfPath : Settings.SidecarPath;
    OutMap.GameMode = Settings.GameMode;
    return true;
}

/** Finds a game mode by the path of its class, or by its name with or without the prefix A. */
UClass* FindGameModeClass(const FString& Name) {
    UClass* Class =
        Name.Contains(TEXT("/")) ? LoadClass<AGameModeBase>(nullptr, *Name) : FindFirstObject<UClass>(*Name);
    if (!Class && Name.StartsWith(TEXT("A"), ESearchCase::CaseSensitive)) {
        Class = FindFirstObject<UClass>(*Name.Mid(1));
    }
    return Class && Class->IsChildOf(AGameModeBase::StaticClass()) ? Class : nullptr;
}

/** Takes the world out of its context, so that nothing of it is left when this returns, except what others hold. */
void TearDownWorld(FWorldContext& WorldContext) {
    UWorld* OldWorld = WorldContext.World();
    if (!OldWorld) {
        return;
    }
    OldWorld->BeginTearingDown();
    if (WorldContext.OwningGameInstance) {
        for (ULocalPlayer* Player : WorldContext.OwningGameInstance->GetLocalPlayers()) {
            Player->PlayerController = nullptr;
        }
    }
    UPackage* OldPackage = OldWorld->GetOutermost();
    OldWorld->DestroyWorld(true);
    WorldContext.SetCurrentWorld(nullptr);
    if (WorldContext.GameViewport) {
        WorldContext.GameViewport->World = nullptr;
    }
    OldPackage->RemoveFromRoot();
    OldPackage->ClearFlags(RF_Standalone);
    CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS, true);
}
} // namespace

bool UEngine::LoadMap(FWorldContext& WorldContext, FURL URL, UPendingNetGame* Pending, FString& Error) {
    Error.Empty();
    if (Pending) {
        Error = TEXT("LoadMap: there is no network here; pass no pending net game");
        return false;
    }
    FResolvedMap Map;
    if (!ResolveMap(URL.Map, Map, Error)) {
        Error = FString::Printf(TEXT("Cannot load map '%s': %s"), *URL.Map, *Error);
        UE_LOG(LogLoad, Error, TEXT("%s"), *Error);
        return false;
    }
    UE_LOG(LogLoad, Log, TEXT("LoadMap: %s"), *Map.PackageName);
    const double StartTime = FPlatformTime::Seconds();
    URL.Map = Map.PackageName;

    TearDownWorld(WorldContext);

    const FString WorldName = FPaths::GetBaseFilename(Map.PackageName);
    UPackage* Package = CreatePackage(*Map.PackageName);
    if (UWorld* Leftover = FindObject<UWorld>(Package, *WorldName)) {
        // Somebody holds the old world: it makes way, since the new one has the right to the name.
        Leftover->Rename(
            *MakeUniqueObjectName(GetTransientPackage(), UWorld::StaticClass(), FName(*WorldName)).ToString(),
            GetTransientPackage());
    }
    UWorld* World = UWorld::CreateWorld(WorldContext.WorldType, false, FName(*WorldName), Package, true, nullptr, true);
    WorldContext.SetCurrentWorld(World);
    GWorld = World;
    if (WorldContext.OwningGameInstance) {
        World->SetGameInstance(WorldContext.OwningGameInstance);
    }
    if (WorldContext.GameViewport) {
        WorldContext.GameViewport->World = World;
    }
    World->URL = URL;
    World->InitWorld();
    WorldAdded(World);

    bool bLoaded = true;
    if (!Map.ScenePath.IsEmpty()) {
        bLoaded = FSceneLoader::LoadScene(World, Map.ScenePath, Error);
        if (!bLoaded) {
            // The world is there, empty: the game goes on in it, as in UE's entry map.
            Error = FString::Printf(TEXT("Cannot load map '%s': %s"), *Map.PackageName, *Error);
            UE_LOG(LogLoad, Error, TEXT("%s"), *Error);
        }
        if (!Map.GameMode.IsEmpty() && !World->GetWorldSettings()->DefaultGameMode) {
            World->GetWorldSettings()->DefaultGameMode = FindGameModeClass(Map.GameMode);
            if (!World->GetWorldSettings()->DefaultGameMode) {
                UE_LOG(LogLoad, Warning,
                    TEXT("Map '%s' asks for game mode '%s', which is no game mode class; the default one is used"),
                    *Map.PackageName, *Map.GameMode);
            }
        }
    }

    World->SetGameMode(URL);
    World->InitializeActorsForPlay(URL);
    if (WorldContext.OwningGameInstance) {
        for (ULocalPlayer* Player : WorldContext.OwningGameInstance->GetLocalPlayers()) {
            FString PlayerError;
            if (!Player->SpawnPlayActor(URL.ToString(), PlayerError, World)) {
                UE_LOG(LogLoad, Warning, TEXT("LoadMap: no player controller for %s: %s"), *Player->GetName(),
                    *PlayerError);
            }
        }
    }
    WorldContext.LastURL = URL;
    World->BeginPlay();
    FCoreUObjectDelegates::PostLoadMapWithWorld.Broadcast(World);
    UE_LOG(LogLoad, Log, TEXT("Loaded %s: %d actors in %.3f s"), *Map.PackageName, World->GetActorCount(),
        FPlatformTime::Seconds() - StartTime);
    return bLoaded;
}

bool UEngine::Browse(FWorldContext& WorldContext, FURL URL, FString& Error) {
    WorldContext.TravelURL.Empty();
    if (URL.HasOption(TEXT("restart"))) {
        URL = WorldContext.LastURL;
    }
    if (!URL.Valid) {
        Error = FString::Printf(TEXT("Browse: '%s' names no map"), *URL.ToString());
        return false;
    }
    return LoadMap(WorldContext, URL, nullptr, Error);
}

void UEngine::SetClientTravel(UWorld* InWorld, const TCHAR* NextURL, ETravelType InTravelType) {
    FWorldContext& Context = GetWorldContextFromWorldChecked(InWorld);
    Context.TravelURL = NextURL;
    Context.TravelType = static_cast<uint8>(InTravelType);
}

void UEngine::TickWorldTravel(FWorldContext& WorldContext, float) {
    if (WorldContext.TravelURL.IsEmpty()) {
        return;
    }
    const FString TravelURL = WorldContext.TravelURL;
    WorldContext.TravelURL.Empty();
    FString Error;
    if (!Browse(WorldContext,
            FURL(&WorldContext.LastURL, *TravelURL, static_cast<ETravelType>(WorldContext.TravelType)), Error)) {
        UE_LOG(LogLoad, Warning, TEXT("Travel to '%s' failed: %s"), *TravelURL, *Error);
    }
}
