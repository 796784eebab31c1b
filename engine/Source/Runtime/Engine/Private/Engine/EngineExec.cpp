// SPDX-License-Identifier: MIT
/** @file Console commands. */
#include "Engine/Engine.h"
#include "EngineUtils.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/WorldSettings.h"
#include "HAL/IConsoleManager.h"
#include "HAL/PlatformMisc.h"
#include "Misc/Parse.h"
#include "UObject/UObjectIterator.h"

bool UEngine::Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar) {
    if (!Cmd) {
        return false;
    }
    const TCHAR* const WholeCommand = Cmd;
    if (FParse::Command(&Cmd, TEXT("EXIT")) || FParse::Command(&Cmd, TEXT("QUIT"))) {
        Ar.Log(TEXT("Exit requested by the console"));
        FPlatformMisc::RequestExit(false);
        return true;
    }
    if (FParse::Command(&Cmd, TEXT("OBJ"))) {
        return HandleObjCommand(Cmd, Ar);
    }
    if (InWorld && InWorld->Exec(InWorld, Cmd, Ar)) {
        return true;
    }
    return IConsoleManager::Get().ProcessUserConsoleInput(WholeCommand, Ar, InWorld);
}

bool UWorld::Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar) {
    const FString Rest = FString(Cmd).TrimStartAndEnd();
    if (FParse::Command(&Cmd, TEXT("SLOMO"))) {
        const FString Argument = FString(Cmd).TrimStartAndEnd();
        AWorldSettings* Settings = GetWorldSettings();
        if (Argument.IsEmpty() || !Argument.IsNumeric()) {
            Ar.Logf(TEXT("slomo: the time dilation is %g; 'slomo RATE' sets it"), Settings->TimeDilation);
        } else {
            Settings->SetTimeDilation(FCString::Atof(*Argument));
        }
        return true;
    }
    if (FParse::Command(&Cmd, TEXT("PAUSE"))) {
        APlayerController* PlayerController = GetFirstPlayerController();
        if (!PlayerController) {
            Ar.Log(TEXT("pause: the world has no player controller"));
        } else {
            PlayerController->Pause();
        }
        return true;
    }
    if (FParse::Command(&Cmd, TEXT("OPEN"))) {
        const FString Map = FString(Cmd).TrimStartAndEnd();
        if (Map.IsEmpty()) {
            Ar.Log(TEXT("open: name a map, e.g. 'open apartment'"));
        } else {
            GEngine->SetClientTravel(this, *Map, TRAVEL_Absolute);
        }
        return true;
    }
    if (FParse::Command(&Cmd, TEXT("RESTARTLEVEL"))) {
        GEngine->SetClientTravel(this, TEXT("?restart"), TRAVEL_Relative);
        return true;
    }
    if (Rest.Equals(TEXT("stat actors"), ESearchCase::IgnoreCase)) {
        TMap<FString, int32> Counts;
        for (FActorIterator It(this); It; ++It) {
            ++Counts.FindOrAdd(It->GetClass()->GetName());
        }
        Counts.KeySort([](const FString& A, const FString& B) { return A < B; });
        for (const TPair<FString, int32>& Count : Counts) {
            Ar.Logf(TEXT("%6d %s"), Count.Value, *Count.Key);
        }
        Ar.Logf(TEXT("%6d actors in %s"), GetActorCount(), *GetPathName());
        return true;
    }
    return false;
}

bool UEngine::HandleObjCommand(const TCHAR* Cmd, FOutputDevice& Ar) {
    if (FParse::Command(&Cmd, TEXT("GARBAGE")) || FParse::Command(&Cmd, TEXT("GC"))) {
        ForceGarbageCollection(true);
        return true;
    }
    if (FParse::Command(&Cmd, TEXT("LIST"))) {
        UClass* OfClass = UObject::StaticClass();
        FString ClassName;
        if (FParse::Value(Cmd, TEXT("CLASS="), ClassName)) {
            OfClass = FindFirstObject<UClass>(*ClassName);
            if (!OfClass) {
                Ar.Logf(TEXT("obj list: there is no class '%s'"), *ClassName);
                return true;
            }
        }
        TMap<FString, int32> Counts;
        int32 Total = 0;
        for (TObjectIterator<UObject> It; It; ++It) {
            if (It->IsA(OfClass)) {
                ++Counts.FindOrAdd(It->GetClass()->GetName());
                ++Total;
            }
        }
        Counts.KeySort([](const FString& A, const FString& B) { return A < B; });
        for (const TPair<FString, int32>& Count : Counts) {
            Ar.Logf(TEXT("%6d %s"), Count.Value, *Count.Key);
        }
        Ar.Logf(TEXT("%6d objects"), Total);
        return true;
    }
    return false;
}

void UEngine::TickDeferredCommands() {
    const TArray<FString> Commands = MoveTemp(DeferredCommands);
    DeferredCommands.Reset();
    for (const FString& Command : Commands) {
        UWorld* World = GetCurrentPlayWorld();
        if (!Exec(World, *Command, *GLog)) {
            UE_LOG(LogEngine, Warning, TEXT("Unknown console command: %s"), *Command);
        }
    }
}
