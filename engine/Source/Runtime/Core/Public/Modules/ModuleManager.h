// SPDX-License-Identifier: MIT
/**
 * FModuleManager: modules are shared libraries `libSpearUE-<Name>.so`, looked for where the dynamic linker looks and in
 * the binaries directories. Loading one runs: dlopen, registration of its classes (OnProcessLoadedObjectsCallback),
 * construction of the module object, StartupModule.
 */
#pragma once

#include "CoreMinimal.h"
#include "HAL/CriticalSection.h"
#include "Modules/ModuleInterface.h"

typedef IModuleInterface* (*FInitializeModuleFunctionPtr)();

enum class EModuleLoadResult {
    Success,
    FileNotFound,
    FileIncompatible,
    CouldNotBeLoadedByOS,
    FailedToInitialize,
    NotLoadedByGameCode
};
enum class EModuleChangeReason { ModuleLoaded, ModuleUnloaded, PluginDirectoryChanged };
enum class ELoadModuleFlags : uint32 { None = 0, LogFailures = 1 << 0 };
ENUM_CLASS_FLAGS(ELoadModuleFlags)

struct FModuleStatus {
    FString Name;
    FString FilePath;
    bool bIsLoaded = false;
    bool bIsGameModule = false;
};

class FModuleManager {
public:
    DECLARE_EVENT_TwoParams(FModuleManager, FModulesChangedEvent, FName, EModuleChangeReason)
        DECLARE_EVENT_TwoParams(FModuleManager, ProcessLoadedObjectsEvent, FName, bool)

            static CORE_API FModuleManager& Get();

    /** Loads a module and those it links with. Null if it cannot be; the log says why. */
    CORE_API IModuleInterface* LoadModule(
        const FName InModuleName, ELoadModuleFlags InLoadModuleFlags = ELoadModuleFlags::LogFailures);
    /** The same, and fails a check if it cannot be. */
    CORE_API IModuleInterface& LoadModuleChecked(const FName InModuleName);
    CORE_API IModuleInterface* LoadModuleWithFailureReason(const FName InModuleName,
        EModuleLoadResult& OutFailureReason, ELoadModuleFlags InLoadModuleFlags = ELoadModuleFlags::None);
    template <typename TModuleInterface>
    static TModuleInterface& LoadModuleChecked(const FName InModuleName) {
        return static_cast<TModuleInterface&>(Get().LoadModuleChecked(InModuleName));
    }
    template <typename TModuleInterface>
    static TModuleInterface* LoadModulePtr(const FName InModuleName) {
        return static_cast<TModuleInterface*>(Get().LoadModule(InModuleName));
    }
    /** Null if it is not loaded. */
    CORE_API IModuleInterface* GetModule(const FName InModuleName);
    template <typename TModuleInterface>
    TModuleInterface* GetModulePtr(const FName ModuleName) {
        return static_cast<TModuleInterface*>(GetModule(ModuleName));
    }
    template <typename TModuleInterface>
    static TModuleInterface& GetModuleChecked(const FName ModuleName) {
        IModuleInterface* Module = Get().GetModule(ModuleName);
        checkf(Module, TEXT("Tried to get module interface for unloaded module: '%s'"), *ModuleName.ToString());
        return static_cast<TModuleInterface&>(*Module);
    }
    CORE_API bool IsModuleLoaded(const FName InModuleName) const;
    /** Is there a library of that name in the binaries directories, or is the module loaded? */
    CORE_API bool ModuleExists(const TCHAR* ModuleName, FString* OutModuleFilePath = nullptr) const;
    /** Calls ShutdownModule and drops the module object. The library stays mapped, for its classes stay registered. */
    CORE_API bool UnloadModule(const FName InModuleName, bool bIsShutdown = false);
    /** In reverse order of loading. */
    CORE_API void UnloadModulesAtShutdown();
    CORE_API void QueryModules(TArray<FModuleStatus>& OutModuleStatuses) const;
    CORE_API bool QueryModule(const FName InModuleName, FModuleStatus& OutModuleStatus) const;
    CORE_API FString GetModuleFilename(FName ModuleName) const;
    int32 GetModuleCount() const { return Modules.Num(); }
    /** Further directories with libraries. */
    CORE_API void AddBinariesDirectory(const TCHAR* InDirectory, bool bIsGameDirectory = false);
    /** Statically linked modules: the function makes the module object. */
    CORE_API void RegisterStaticallyLinkedModule(const FName InModuleName, FInitializeModuleFunctionPtr InInitializer);

    FModulesChangedEvent& OnModulesChanged() { return ModulesChangedEvent; }
    /**
     * Broadcast after a library was loaded and before its StartupModule: CoreUObject makes the new classes and their
     * default objects here. The module's name (none at engine start) and whether new objects may be processed now.
     */
    ProcessLoadedObjectsEvent& OnProcessLoadedObjectsCallback() { return ProcessLoadedObjectsCallback; }
    /** Processes the classes of the modules that the program itself links with (module name NAME_None). */
    CORE_API void StartProcessingNewlyLoadedObjects();

private:
    struct FModuleInfo {
        TUniquePtr<IModuleInterface> Module;
        void* Handle = nullptr;
        FString Filename;
        FInitializeModuleFunctionPtr Initializer = nullptr;
        int32 LoadOrder = 0;
        bool bIsLoading = false;
    };
    FModuleManager() = default;
    FString FindLibrary(const FString& ModuleName) const;
    IModuleInterface* StartLoaded(FName Name, FModuleInfo& Info);

    TMap<FName, TSharedRef<FModuleInfo>> Modules;
    TArray<FString> BinariesDirectories;
    FModulesChangedEvent ModulesChangedEvent;
    ProcessLoadedObjectsEvent ProcessLoadedObjectsCallback;
    mutable FCriticalSection ModulesCriticalSection;
    int32 NextLoadOrder = 0;
};

/** The module class of modules that need none. */
class FDefaultModuleImpl : public IModuleInterface {};
class FDefaultGameModuleImpl : public FDefaultModuleImpl {
public:
    bool IsGameModule() const override { return true; }
};

/** Put once in a module: its library's entry point, which makes the module object. */
#define IMPLEMENT_MODULE(ModuleImplClass, ModuleName)                                                                  \
    extern "C" DLLEXPORT IModuleInterface* SpearUE_InitializeModule_##ModuleName();                                    \
    extern "C" DLLEXPORT IModuleInterface* SpearUE_InitializeModule_##ModuleName() { return new ModuleImplClass(); }
#define IMPLEMENT_GAME_MODULE(ModuleImplClass, ModuleName) IMPLEMENT_MODULE(ModuleImplClass, ModuleName)
#define IMPLEMENT_PRIMARY_GAME_MODULE(ModuleImplClass, ModuleName, DeprecatedGameName)                                 \
    IMPLEMENT_GAME_MODULE(ModuleImplClass, ModuleName)
