// SPDX-License-Identifier: MIT
#include "Modules/ModuleManager.h"

#include <dlfcn.h>
#include <sys/stat.h>

#include "HAL/PlatformProcess.h"
#include "Misc/ScopeLock.h"

IMPLEMENT_MODULE(FDefaultModuleImpl, Core)

namespace {
FString LibraryName(const FString& ModuleName) { return FString::Printf(TEXT("libSpearUE-%s.so"), *ModuleName); }

bool IsFile(const FString& Path) {
    struct stat Info;
    return stat(TCHAR_TO_UTF8(*Path), &Info) == 0 && S_ISREG(Info.st_mode);
}

/** Where this very library lies: the engine's modules lie beside it. */
FString OwnDirectory() {
    Dl_info Info;
    if (!dladdr(reinterpret_cast<void*>(&OwnDirectory), &Info) || !Info.dli_fname) {
        return FString();
    }
    const FString Path(UTF8_TO_TCHAR(Info.dli_fname));
    int32 Slash = INDEX_NONE;
    return Path.FindLastChar(TCHAR('/'), Slash) ? Path.Left(Slash) : FString(TEXT("."));
}
} // namespace

FModuleManager& FModuleManager::Get() {
    // Never destroyed: module objects are given up by UnloadModulesAtShutdown, not by a static destructor.
    static FModuleManager& Instance = *new FModuleManager();
    return Instance;
}

FString FModuleManager::FindLibrary(const FString& ModuleName) const {
    const FString File = LibraryName(ModuleName);
    for (const FString& Directory : BinariesDirectories) {
        const FString Path = Directory / File;
        if (IsFile(Path)) {
            return Path;
        }
    }
    const FString Beside = OwnDirectory() / File;
    return IsFile(Beside) ? Beside : FString();
}

IModuleInterface* FModuleManager::StartLoaded(FName Name, FModuleInfo& Info) {
    // Classes and their default objects exist before the module's own code runs.
    ProcessLoadedObjectsCallback.Broadcast(Name, true);
    Info.Module = TUniquePtr<IModuleInterface>(Info.Initializer());
    check(Info.Module);
    Info.LoadOrder = NextLoadOrder++;
    Info.Module->StartupModule();
    Info.bIsLoading = false;
    UE_LOG(LogModuleManager, Verbose, TEXT("Module '%s' is loaded (%s)"), *Name.ToString(), *Info.Filename);
    ModulesChangedEvent.Broadcast(Name, EModuleChangeReason::ModuleLoaded);
    return Info.Module.Get();
}

IModuleInterface* FModuleManager::LoadModuleWithFailureReason(
    const FName InModuleName, EModuleLoadResult& OutFailureReason, ELoadModuleFlags InLoadModuleFlags) {
    checkf(IsInGameThread(), TEXT("Module '%s' must be loaded on the game thread"), *InModuleName.ToString());
    OutFailureReason = EModuleLoadResult::Success;
    TSharedPtr<FModuleInfo> Info;
    {
        FScopeLock Lock(&ModulesCriticalSection);
        TSharedRef<FModuleInfo>* Found = Modules.Find(InModuleName);
        Info = Found ? TSharedPtr<FModuleInfo>(*Found) : TSharedPtr<FModuleInfo>();
        if (!Info) {
            Info = MakeShared<FModuleInfo>();
            Modules.Add(InModuleName, Info.ToSharedRef());
        }
    }
    if (Info->Module || Info->bIsLoading) {
        return Info->Module.Get();
    }
    const FString Name = InModuleName.ToString();
    const auto Fail = [&](EModuleLoadResult Reason, const FString& Why) -> IModuleInterface* {
        OutFailureReason = Reason;
        FScopeLock Lock(&ModulesCriticalSection);
        Modules.Remove(InModuleName);
        if (EnumHasAnyFlags(InLoadModuleFlags, ELoadModuleFlags::LogFailures)) {
            UE_LOG(LogModuleManager, Warning, TEXT("Module '%s' could not be loaded: %s"), *Name, *Why);
        }
        return nullptr;
    };
    if (!Info->Initializer) {
        const FString Path = FindLibrary(Name);
        // Without a file of our own, the dynamic linker searches (RPATH, LD_LIBRARY_PATH, what is loaded already).
        Info->Filename = Path.IsEmpty() ? LibraryName(Name) : Path;
        Info->Handle = FPlatformProcess::GetDllHandle(*Info->Filename);
        if (!Info->Handle) {
            const FString Error = FPlatformProcess::GetDllError();
            return Fail(Path.IsEmpty() ? EModuleLoadResult::FileNotFound : EModuleLoadResult::CouldNotBeLoadedByOS,
                FString::Printf(
                    TEXT("%s. Looked for %s in %d binaries directories, beside libSpearUE-Core.so and on the "
                         "library search path; add its directory with AddBinariesDirectory."),
                    *Error, *LibraryName(Name), BinariesDirectories.Num()));
        }
        const FString Symbol = TEXT("SpearUE_InitializeModule_") + Name;
        Info->Initializer =
            reinterpret_cast<FInitializeModuleFunctionPtr>(FPlatformProcess::GetDllExport(Info->Handle, *Symbol));
        if (!Info->Initializer) {
            return Fail(EModuleLoadResult::FailedToInitialize,
                FString::Printf(TEXT("%s has no function %s; put IMPLEMENT_MODULE(Class, %s) into one of its sources."),
                    *Info->Filename, *Symbol, *Name));
        }
    }
    Info->bIsLoading = true;
    return StartLoaded(InModuleName, *Info);
}

IModuleInterface* FModuleManager::LoadModule(const FName InModuleName, ELoadModuleFlags InLoadModuleFlags) {
    EModuleLoadResult Reason;
    return LoadModuleWithFailureReason(InModuleName, Reason, InLoadModuleFlags);
}

IModuleInterface& FModuleManager::LoadModuleChecked(const FName InModuleName) {
    IModuleInterface* Module = LoadModule(InModuleName);
    checkf(Module, TEXT("Module '%s' could not be loaded"), *InModuleName.ToString());
    return *Module;
}

IModuleInterface* FModuleManager::GetModule(const FName InModuleName) {
    FScopeLock Lock(&ModulesCriticalSection);
    const TSharedRef<FModuleInfo>* Found = Modules.Find(InModuleName);
    return Found ? (*Found)->Module.Get() : nullptr;
}

bool FModuleManager::IsModuleLoaded(const FName InModuleName) const {
    return const_cast<FModuleManager*>(this)->GetModule(InModuleName) != nullptr;
}

bool FModuleManager::ModuleExists(const TCHAR* ModuleName, FString* OutModuleFilePath) const {
    const FString Path = FindLibrary(ModuleName);
    if (OutModuleFilePath) {
        *OutModuleFilePath = Path;
    }
    return !Path.IsEmpty() || IsModuleLoaded(FName(ModuleName));
}

bool FModuleManager::UnloadModule(const FName InModuleName, bool bIsShutdown) {
    TUniquePtr<IModuleInterface> Module;
    {
        FScopeLock Lock(&ModulesCriticalSection);
        if (TSharedRef<FModuleInfo>* Found = Modules.Find(InModuleName)) {
            Module = MoveTemp((*Found)->Module);
        }
    }
    if (!Module) {
        return false;
    }
    Module->PreUnloadCallback();
    Module->ShutdownModule();
    Module.Reset();
    if (!bIsShutdown) {
        ModulesChangedEvent.Broadcast(InModuleName, EModuleChangeReason::ModuleUnloaded);
    }
    return true;
}

void FModuleManager::UnloadModulesAtShutdown() {
    TArray<TPair<int32, FName>> Loaded;
    {
        FScopeLock Lock(&ModulesCriticalSection);
        for (const auto& Pair : Modules) {
            if (Pair.Value->Module && Pair.Value->Module->SupportsAutomaticShutdown()) {
                Loaded.Emplace(Pair.Value->LoadOrder, Pair.Key);
            }
        }
    }
    Loaded.Sort([](const TPair<int32, FName>& A, const TPair<int32, FName>& B) { return A.Key > B.Key; });
    for (const TPair<int32, FName>& Pair : Loaded) {
        UnloadModule(Pair.Value, true);
    }
}

bool FModuleManager::QueryModule(const FName InModuleName, FModuleStatus& OutModuleStatus) const {
    FScopeLock Lock(&ModulesCriticalSection);
    const TSharedRef<FModuleInfo>* Found = Modules.Find(InModuleName);
    if (!Found) {
        return false;
    }
    OutModuleStatus.Name = InModuleName.ToString();
    OutModuleStatus.FilePath = (*Found)->Filename;
    OutModuleStatus.bIsLoaded = (*Found)->Module.IsValid();
    OutModuleStatus.bIsGameModule = OutModuleStatus.bIsLoaded && (*Found)->Module->IsGameModule();
    return true;
}

void FModuleManager::QueryModules(TArray<FModuleStatus>& OutModuleStatuses) const {
    FScopeLock Lock(&ModulesCriticalSection);
    OutModuleStatuses.Reset();
    for (const auto& Pair : Modules) {
        QueryModule(Pair.Key, OutModuleStatuses.AddDefaulted_GetRef());
    }
}

FString FModuleManager::GetModuleFilename(FName ModuleName) const {
    FModuleStatus Status;
    return QueryModule(ModuleName, Status) ? Status.FilePath : FString();
}

void FModuleManager::AddBinariesDirectory(const TCHAR* InDirectory, bool) {
    FScopeLock Lock(&ModulesCriticalSection);
    BinariesDirectories.AddUnique(FString(InDirectory));
}

void FModuleManager::RegisterStaticallyLinkedModule(
    const FName InModuleName, FInitializeModuleFunctionPtr InInitializer) {
    check(InInitializer);
    FScopeLock Lock(&ModulesCriticalSection);
    TSharedRef<FModuleInfo> Info = MakeShared<FModuleInfo>();
    Info->Initializer = InInitializer;
    Modules.Add(InModuleName, Info);
}

void FModuleManager::StartProcessingNewlyLoadedObjects() { ProcessLoadedObjectsCallback.Broadcast(NAME_None, true); }
