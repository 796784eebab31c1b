// SPDX-License-Identifier: MIT
#include "LaunchEngineLoop.h"

#include "LaunchOptions.h"
#include "PluginDescriptor.h"

#include "Async/TaskGraphInterfaces.h"
#include "Engine/GameEngine.h"
#include "Engine/World.h"
#include "EngineUtils.h"
#include "GameFramework/PlayerController.h"
#include "HAL/PlatformProcess.h"
#include "Misc/App.h"
#include "Misc/CommandLine.h"
#include "Misc/CoreDelegates.h"
#include "Misc/Parse.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "UObject/GarbageCollection.h"
#include "UObject/Package.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

DEFINE_LOG_CATEGORY_STATIC(LogLaunch, Log, All);

namespace {
FString ToFString(const std::string& Text) { return FString(UTF8_TO_TCHAR(Text.c_str())); }

/** Quotes an argument with spaces the way FParse reads it: -Key="a b". */
FString QuoteArgument(const FString& Argument) {
    int32 Equals = INDEX_NONE;
    if (!Argument.Contains(TEXT(" ")) || Argument.Contains(TEXT("\""))) {
        return Argument;
    }
    if (Argument.FindChar(TEXT('='), Equals)) {
        return Argument.Left(Equals + 1) + TEXT("\"") + Argument.Mid(Equals + 1) + TEXT("\"");
    }
    return TEXT("\"") + Argument + TEXT("\"");
}

FString BuildCommandLine(const FLaunchOptions& Options) {
    FString CommandLine;
    if (!Options.Scene.empty()) {
        CommandLine += QuoteArgument(TEXT("-Map=") + ToFString(Options.Scene));
    }
    for (const std::string& Argument : Options.EngineArguments) {
        CommandLine += TEXT(" ");
        CommandLine += QuoteArgument(ToFString(Argument));
    }
    return CommandLine.TrimStart();
}

bool IsRuntimeModule(const FPluginModule& Module) {
    return Module.Type == "Runtime" || Module.Type == "RuntimeNoCommandlet" || Module.Type == "RuntimeAndProgram" ||
           Module.Type == "ClientOnly" || Module.Type == "ServerOnly";
}

/** Phases before the engine is made, in their order. */
const char* const EarlyPhases[] = {"EarliestPossible", "PostConfigInit", "PostSplashScreen", "PreEarlyLoadingScreen",
    "PreLoadingScreen", "PreDefault", "Default", "PostDefault"};

void SetUpLog(const FLaunchOptions& Options) {
    const FString Level = ToFString(Options.LogLevel);
    ApplyLogCommands(TEXT("global ") + Level);
    if (!Options.LogFile.empty()) {
        // Lives as long as the process: the log may be written to until its very end.
        FOutputDeviceFile* File = new FOutputDeviceFile(*ToFString(Options.LogFile));
        if (File->IsOpened()) {
            GLog->AddOutputDevice(File);
        } else {
            UE_LOG(LogLaunch, Warning, TEXT("The log file '%s' cannot be opened for writing; there is no log file"), *ToFString(Options.LogFile));
            delete File;
        }
    }
}
} // namespace

FEngineLoop::FEngineLoop() : FramesToGo(0), bLimitFrames(false) {}

FEngineLoop::~FEngineLoop() = default;

int32 FEngineLoop::PreInit(const FLaunchOptions& Options) {
    LaunchOptions = MakeUnique<FLaunchOptions>(Options);
    FCommandLine::Set(*BuildCommandLine(Options));
    if (!Options.ContentDirectory.empty()) {
        setenv("SPEAR_CONTENT_DIR", Options.ContentDirectory.c_str(), 1);
    }

    const bool bUnrealFixedStep = FParse::Param(FCommandLine::Get(), TEXT("UseFixedTimeStep"));
    FApp::SetBenchmarking(FParse::Param(FCommandLine::Get(), TEXT("Benchmark")));
    FApp::SetUseFixedTimeStep(bUnrealFixedStep || Options.FixedDeltaSeconds.has_value());
    double UnrealFramesPerSecond = 0.0;
    if (FParse::Value(FCommandLine::Get(), TEXT("-FPS="), UnrealFramesPerSecond) && UnrealFramesPerSecond > 0.0) {
        FApp::SetFixedDeltaTime(1.0 / UnrealFramesPerSecond);
    }
    if (Options.FixedDeltaSeconds) {
        FApp::SetFixedDeltaTime(*Options.FixedDeltaSeconds);
    }
    SetUpLog(Options);
    FMath::RandInit(Options.Seed);
    FMath::SRandInit(Options.Seed);
    bLimitFrames = Options.Frames.has_value();
    FramesToGo = Options.Frames.value_or(0);

    std::vector<std::string> Errors;
    std::vector<FPluginDescriptor> Found;
    const FString ExecutableFolder = FPlatformProcess::BaseDir();
    FModuleManager::Get().AddBinariesDirectory(*ExecutableFolder, false);
    FModuleManager::Get().AddBinariesDirectory(
        *FPaths::ConvertRelativePathToFull(FPaths::Combine(ExecutableFolder, TEXT("../lib"))), false);
    const FString DefaultPluginFolder = FPaths::Combine(ExecutableFolder, TEXT("../plugins"));
    std::vector<std::string> Folders = {std::string(TCHAR_TO_UTF8(*DefaultPluginFolder))};
    Folders.insert(Folders.end(), Options.PluginDirectories.begin(), Options.PluginDirectories.end());
    for (const std::string& Folder : Folders) {
        for (FPluginDescriptor& Plugin : ReadPlugins(Folder, Errors)) {
            Found.push_back(std::move(Plugin));
        }
    }
    FString EnabledNames;
    FParse::Value(FCommandLine::Get(), TEXT("-EnablePlugins="), EnabledNames, false);
    TArray<FString> EnabledPlugins;
    EnabledNames.ParseIntoArray(EnabledPlugins, TEXT(","), true);
    for (FPluginDescriptor& Plugin : SortPlugins(std::move(Found), Errors)) {
        if (Plugin.bEnabledByDefault || EnabledPlugins.Contains(ToFString(Plugin.Name))) {
            FModuleManager::Get().AddBinariesDirectory(
                *FPaths::Combine(ToFString(Plugin.Directory), TEXT("Binaries/Linux")), false);
            Plugins.push_back(std::move(Plugin));
        }
    }
    for (const std::string& Error : Errors) {
        UE_LOG(LogLaunch, Warning, TEXT("%s"), *ToFString(Error));
    }

    FModuleManager::Get().StartProcessingNewlyLoadedObjects();
    for (const TCHAR* ModuleName : {TEXT("Core"), TEXT("CoreUObject"), TEXT("Engine")}) {
        if (!LoadNamedModule(ModuleName, TEXT("the engine"))) {
            return 1;
        }
    }
    if (!LoadPluginModules(false)) {
        return 1;
    }
    for (const std::string& ModuleName : Options.Modules) {
        if (!LoadNamedModule(ToFString(ModuleName), TEXT("the option --module"))) {
            return 1;
        }
    }
    return 0;
}

bool FEngineLoop::LoadNamedModule(const FString& ModuleName, const FString& WhatFor) {
    EModuleLoadResult Result = EModuleLoadResult::Success;
    if (!FModuleManager::Get().LoadModuleWithFailureReason(FName(*ModuleName), Result)) {
        UE_LOG(LogLaunch, Error,
            TEXT("The module %s (for %s) could not be loaded (reason %d): the library libSpearUE-%s.so must lie beside "
                 "the executable, in ../lib or in a plugin's Binaries/Linux"),
            *ModuleName, *WhatFor, static_cast<int32>(Result), *ModuleName);
        return false;
    }
    return true;
}

bool FEngineLoop::LoadPluginModules(bool bPostEngineInit) {
    const auto LoadPhase = [this](const char* Phase) {
        for (const FPluginDescriptor& Plugin : Plugins) {
            for (const FPluginModule& Module : Plugin.Modules) {
                if (Module.LoadingPhase == Phase && IsRuntimeModule(Module) &&
                    !LoadNamedModule(ToFString(Module.Name), TEXT("the plugin ") + ToFString(Plugin.Name))) {
                    return false;
                }
            }
        }
        return true;
    };
    if (bPostEngineInit) {
        return LoadPhase("PostEngineInit");
    }
    for (const char* Phase : EarlyPhases) {
        if (!LoadPhase(Phase)) {
            return false;
        }
    }
    return true;
}

int32 FEngineLoop::Init() {
    UGameEngine* GameEngine = NewObject<UGameEngine>(GetTransientPackage(), FName(TEXT("GameEngine")));
    GEngine = GameEngine;
    GEngine->AddToRoot();
    GEngine->SetMaxFPS(static_cast<float>(LaunchOptions->FramesPerSecond));
    GEngine->Init(this);
    FCoreDelegates::OnPostEngineInit.Broadcast();
    if (!LoadPluginModules(true)) {
        return 1;
    }

    GEngine->Start();
    if (!GameEngine->StartError.IsEmpty()) {
        std::fprintf(stderr, "spear-engine: %s\n", TCHAR_TO_UTF8(*GameEngine->StartError));
        return 2;
    }
    UWorld* World = GameEngine->GetGameWorld();
    if (LaunchOptions->bPaused) {
        APlayerController* PlayerController = World ? World->GetFirstPlayerController() : nullptr;
        if (!PlayerController || !PlayerController->SetPause(true)) {
            std::fprintf(stderr, "spear-engine: --paused: the game mode of the scene does not allow to pause\n");
            return 2;
        }
    }
    if (LaunchOptions->bPrintScene) {
        PrintScene();
        RequestEngineExit(TEXT("--print-scene"));
    }
    for (const std::string& Command : LaunchOptions->Commands) {
        GEngine->DeferCommand(ToFString(Command));
    }
    FCoreDelegates::OnFEngineLoopInitComplete.Broadcast();
    return 0;
}

void FEngineLoop::Tick() {
    if (bLimitFrames && FramesToGo == 0) {
        RequestEngineExit(TEXT("--frames reached"));
        return;
    }
    FCoreDelegates::OnBeginFrame.Broadcast();
    GEngine->UpdateTimeAndHandleMaxTickRate();
    FTaskGraphInterface::Get().ProcessThreadUntilIdle(ENamedThreads::GameThread);
    GEngine->Tick(static_cast<float>(FApp::GetDeltaTime()), false);
    FCoreDelegates::OnEndFrame.Broadcast();
    // Other threads read it for the log.
    std::atomic_ref<uint64>(GFrameCounter).store(GFrameCounter + 1, std::memory_order_relaxed);
    if (bLimitFrames) {
        --FramesToGo;
    }
}

void FEngineLoop::Exit() {
    // While worlds are alive: who listens may still look at them.
    FCoreDelegates::OnEnginePreExit.Broadcast();
    if (GEngine) {
        GEngine->PreExit();
        GEngine->RemoveFromRoot();
        GEngine = nullptr;
    }
    CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS, true);
    FCoreDelegates::OnPreExit.Broadcast();
    FModuleManager::Get().UnloadModulesAtShutdown();
    FCoreDelegates::OnExit.Broadcast();
    GLog->Flush();
}

void FEngineLoop::PrintScene() const {
    const UWorld* World = CastChecked<UGameEngine>(GEngine)->GetGameWorld();
    std::printf("# %s\n", TCHAR_TO_UTF8(*World->GetPathName()));
    for (FActorIterator It(World); It; ++It) {
        const FVector Location = It->GetActorLocation();
        FString Tags;
        for (const FName& Tag : It->Tags) {
            Tags += (Tags.IsEmpty() ? TEXT("") : TEXT(",")) + Tag.ToString();
        }
        std::printf("%s\t%s\t(%.1f, %.1f, %.1f)\t%s\n", TCHAR_TO_UTF8(*It->GetName()),
            TCHAR_TO_UTF8(*It->GetClass()->GetName()), Location.X, Location.Y, Location.Z, TCHAR_TO_UTF8(*Tags));
    }
    std::fflush(stdout);
}
