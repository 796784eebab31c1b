// SPDX-License-Identifier: MIT
/** @file Base types of ticking, input and travel. Mirrors UE's Engine/EngineBaseTypes.h. */
#pragma once

#include "Async/TaskGraphInterfaces.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"
#include "UObject/WeakObjectPtrTemplates.h"

#include "EngineBaseTypes.generated.h"

class AActor;
class UActorComponent;
class ULevel;
class UWorld;

/**
 * Determines which ticking group a tick function belongs to. Groups run in this order, each to its end, once per frame.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/ETickingGroup
 */
UENUM(BlueprintType)
enum ETickingGroup : int {
    /** Any item that needs to be executed before physics simulation starts. */
    TG_PrePhysics UMETA(DisplayName = "Pre Physics"),
    /** Special tick group that starts physics simulation. */
    TG_StartPhysics UMETA(Hidden, DisplayName = "Start Physics"),
    /** Any item that can be run in parallel with our physics simulation work. */
    TG_DuringPhysics UMETA(DisplayName = "During Physics"),
    /** Special tick group that ends physics simulation. */
    TG_EndPhysics UMETA(Hidden, DisplayName = "End Physics"),
    /** Any item that needs rigid body and cloth simulation to be complete before being executed. */
    TG_PostPhysics UMETA(DisplayName = "Post Physics"),
    /** Any item that needs the update work to be done before being ticked. */
    TG_PostUpdateWork UMETA(DisplayName = "Post Update Work"),
    /** Catchall for anything demoted to the end. */
    TG_LastDemotable UMETA(Hidden, DisplayName = "Last Demotable"),
    /** Special tick group that is not actually a tick group. After every tick group this is repeatedly re-run until
       there are no more newly spawned items to run. */
    TG_NewlySpawned UMETA(Hidden, DisplayName = "Newly Spawned"),

    TG_MAX,
};

/** Type of tick we wish to perform on the level. */
enum ELevelTick : int {
    /** Update the level time only. */
    LEVELTICK_TimeOnly = 0,
    /** Update time and viewports. */
    LEVELTICK_ViewportsOnly = 1,
    /** Update all. */
    LEVELTICK_All = 2,
    /** Delta time is zero, we are paused. Only functions with bTickEvenWhenPaused run. */
    LEVELTICK_PauseTick = 3,
};

/** The network mode the game is currently running. The embedded engine has no network: worlds are NM_Standalone. */
enum ENetMode : int {
    NM_Standalone,
    NM_DedicatedServer,
    NM_ListenServer,
    NM_Client,
    NM_MAX,
};

/** Travel from server to server. */
UENUM()
enum ETravelType : int {
    /** Absolute URL. */
    TRAVEL_Absolute,
    /** Partial (carry name, reset server). */
    TRAVEL_Partial,
    /** Relative URL. */
    TRAVEL_Relative,
    TRAVEL_MAX,
};

struct FTickFunction;

/**
 * A prerequisite of a tick function: a tick function of an object that must have completed in this frame before.
 */
struct FTickPrerequisite {
    /** The object that holds the tick function; the prerequisite is ignored when the object is gone. */
    TWeakObjectPtr<UObject> PrerequisiteObject;
    /** Pointer to the actual tick function; only valid while PrerequisiteObject is. */
    FTickFunction* PrerequisiteTickFunction = nullptr;

    FTickPrerequisite() = default;
    FTickPrerequisite(UObject* TargetObject, FTickFunction& TargetTickFunction)
        : PrerequisiteObject(TargetObject), PrerequisiteTickFunction(&TargetTickFunction) {}

    bool operator==(const FTickPrerequisite& Other) const {
        return PrerequisiteObject == Other.PrerequisiteObject &&
               PrerequisiteTickFunction == Other.PrerequisiteTickFunction;
    }

    /** The tick function, or null when its object is gone. */
    FTickFunction* Get() const { return PrerequisiteObject.IsValid() ? PrerequisiteTickFunction : nullptr; }
};

/**
 * Abstract base of all tick functions: a callback that the world runs once per frame (or per TickInterval) in a tick
 * group.
 *
 * The order is deterministic. A function starts in the later of its TickGroup and the groups of its prerequisites;
 * inside a group the prerequisites run first, then high-priority functions, then the others, each in the order of
 * registration. Functions registered during a frame run in that frame if their group has not passed, else at the end of
 * the current group.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FTickFunction
 */
USTRUCT()
struct ENGINE_API FTickFunction {
    GENERATED_BODY()

public:
    /** Defines the minimum tick group for this tick function. These groups determine the relative order of when objects
     * tick during a frame update. */
    UPROPERTY(EditDefaultsOnly, Category = "Tick", AdvancedDisplay)
    TEnumAsByte<ETickingGroup> TickGroup;

    /** Defines the tick group that this tick function must finish in. These groups determine the relative order of when
     * objects tick during a frame update. */
    UPROPERTY(EditDefaultsOnly, Category = "Tick", AdvancedDisplay)
    TEnumAsByte<ETickingGroup> EndTickGroup;

    /** Bool indicating that this function should execute even if the game is paused. Pause ticks are very limited in
     * capabilities. */
    UPROPERTY(EditDefaultsOnly, Category = "Tick", AdvancedDisplay)
    uint8 bTickEvenWhenPaused : 1;

    /** If false, this tick function will never be registered and will never tick. Only settable in defaults. */
    UPROPERTY()
    uint8 bCanEverTick : 1;

    /** If true, this tick function will start enabled, but can be disabled later on. */
    UPROPERTY(EditDefaultsOnly, Category = "Tick")
    uint8 bStartWithTickEnabled : 1;

    /** If we allow this tick to run on a dedicated server. */
    UPROPERTY(EditDefaultsOnly, Category = "Tick", AdvancedDisplay)
    uint8 bAllowTickOnDedicatedServer : 1;

    /** Run this tick first within the tick group. */
    uint8 bHighPriority : 1;

private:
    uint8 bRegistered : 1;
    uint8 bTickEnabled : 1;

public:
    /** The frequency in seconds at which this tick function will be executed. If less than or equal to 0 then it will
     * tick every frame. */
    UPROPERTY(EditDefaultsOnly, Category = "Tick", meta = (DisplayName = "Tick Interval (secs)"))
    float TickInterval;

    FTickFunction();
    /** A tick function belongs to one object: a copy takes the settings (defaults), not the registration. */
    FTickFunction(const FTickFunction& Other);
    FTickFunction& operator=(const FTickFunction& Other);
    /** Unregisters. */
    virtual ~FTickFunction();

    /** Adds the tick function to the list of tick functions of the world of the level. @param Level the level that owns
     * the ticking object. */
    void RegisterTickFunction(ULevel* Level);
    /** Removes the tick function from the list of tick functions. */
    void UnRegisterTickFunction();
    /** See if the tick function is currently registered. */
    bool IsTickFunctionRegistered() const { return bRegistered; }

    /** Enables or disables this tick function. @param bInEnabled whether it should be enabled. */
    void SetTickFunctionEnable(bool bInEnabled);
    /** Returns whether the tick function is currently enabled. */
    bool IsTickFunctionEnabled() const { return bTickEnabled; }

    /** Update tick interval in the system and overwrite the current cooldown if any, so that the next tick is
     * NewTickInterval seconds after the last. */
    void UpdateTickIntervalAndCoolDown(float NewTickInterval);

    /**
     * Adds a tick function to the list of prerequisites: it will have run in this frame before this one does.
     * @param TargetObject object that holds the prerequisite tick function.
     * @param TargetTickFunction the tick function to use as a prerequisite.
     */
    void AddPrerequisite(UObject* TargetObject, FTickFunction& TargetTickFunction);
    /** Removes a prerequisite that was previously added. */
    void RemovePrerequisite(UObject* TargetObject, FTickFunction& TargetTickFunction);
    /** The prerequisites of this tick function. */
    TArray<FTickPrerequisite>& GetPrerequisites() { return Prerequisites; }
    const TArray<FTickPrerequisite>& GetPrerequisites() const { return Prerequisites; }

    /** Sets this function and all its prerequisites to high priority, or not. */
    void SetPriorityIncludingPrerequisites(bool bInHighPriority);

    /** The group this function ran in, or will run in, in the current frame (TickGroup, or a later one of a
     * prerequisite). */
    TEnumAsByte<ETickingGroup> GetActualTickGroup() const { return ActualStartTickGroup; }
    /** The group in which this function completes in the current frame. */
    TEnumAsByte<ETickingGroup> GetActualEndTickGroup() const { return ActualStartTickGroup; }
    /** World time in seconds of the last tick, or -1 if this has never ticked. */
    double GetLastTickGameTime() const { return LastTickGameTimeSeconds; }

    /**
     * Actually executes the tick.
     * @param DeltaTime frame time to advance, in seconds.
     * @param TickType kind of tick for this frame.
     * @param CurrentThread thread we are executing on: always the game thread here.
     * @param MyCompletionGraphEvent completion event for this task: always null here, ticks complete when this returns.
     */
    virtual void ExecuteTick(float DeltaTime, ELevelTick TickType, ENamedThreads::Type CurrentThread,
        const FGraphEventRef& MyCompletionGraphEvent) {}
    /** Describes this tick. Used to report cycles of prerequisites. */
    virtual FString DiagnosticMessage() { return FString(TEXT("FTickFunction")); }
    /** Name of the context of this tick, for profiling. */
    virtual FName DiagnosticContext(bool bDetailed) { return NAME_None; }

private:
    friend class FTickTaskManager;

    /** Functions that must have ticked before this in each frame. */
    TArray<FTickPrerequisite> Prerequisites;
    /** The manager of the world this is registered with; null when it is not registered. */
    class FTickTaskManager* Manager;
    /** Place in the list of the manager, which is in the order of registration: the deterministic tie break. */
    int32 ManagerIndex;
    /** Frame in which this was queued last, and in which it was executed last. */
    uint64 QueuedFrame;
    uint64 ExecutedFrame;
    /** Seconds until an interval tick is due. */
    double CooldownSeconds;
    double LastTickGameTimeSeconds;
    /** Time that passed since the last tick of an interval tick; negative before its first. */
    float TimeSinceLastTick;
    TEnumAsByte<ETickingGroup> ActualStartTickGroup;
};

template <>
struct TStructOpsTypeTraits<FTickFunction> : public TStructOpsTypeTraitsBase2<FTickFunction> {
    enum { WithCopy = false, WithPureVirtual = false };
};

/** Tick function that calls AActor::TickActor. */
USTRUCT()
struct ENGINE_API FActorTickFunction : public FTickFunction {
    GENERATED_BODY()

    /** AActor that is the target of this tick. */
    AActor* Target = nullptr;

    virtual void ExecuteTick(float DeltaTime, ELevelTick TickType, ENamedThreads::Type CurrentThread,
        const FGraphEventRef& MyCompletionGraphEvent) override;
    virtual FString DiagnosticMessage() override;
    virtual FName DiagnosticContext(bool bDetailed) override;
};

template <>
struct TStructOpsTypeTraits<FActorTickFunction> : public TStructOpsTypeTraitsBase2<FActorTickFunction> {
    enum { WithCopy = false };
};

/** Tick function that calls UActorComponent::TickComponent. */
USTRUCT()
struct ENGINE_API FActorComponentTickFunction : public FTickFunction {
    GENERATED_BODY()

    /** Actor component that is the target of this tick. */
    UActorComponent* Target = nullptr;

    virtual void ExecuteTick(float DeltaTime, ELevelTick TickType, ENamedThreads::Type CurrentThread,
        const FGraphEventRef& MyCompletionGraphEvent) override;
    virtual FString DiagnosticMessage() override;
    virtual FName DiagnosticContext(bool bDetailed) override;
};

template <>
struct TStructOpsTypeTraits<FActorComponentTickFunction>
    : public TStructOpsTypeTraitsBase2<FActorComponentTickFunction> {
    enum { WithCopy = false };
};

/**
 * A uniform resource locator of a map: "MapName?Option=Value?Flag". The embedded engine has no network, so Host is
 * always empty.
 */
USTRUCT()
struct ENGINE_API FURL {
    GENERATED_BODY()

    /** Protocol, i.e. "unreal" or "http". */
    UPROPERTY()
    FString Protocol;

    /** Optional hostname, i.e. "204.157.115.40" or "unreal.epicgames.com", blank if local. */
    UPROPERTY()
    FString Host;

    /** Optional host port. */
    UPROPERTY()
    int32 Port;

    /** Whether the URL could be parsed. */
    UPROPERTY()
    int32 Valid;

    /** Map name, i.e. "SkyCity", default is "Entry". */
    UPROPERTY()
    FString Map;

    /** Optional place to download Map if client does not possess it. */
    UPROPERTY()
    FString RedirectURL;

    /** Options, each "Name=Value" or "Name". */
    UPROPERTY()
    TArray<FString> Op;

    /** Portal to enter through, default is "". */
    UPROPERTY()
    FString Portal;

    FURL();
    /**
     * Parses a URL.
     * @param Base the URL that a relative one starts from, or null.
     * @param TextURL the text, e.g. "/Game/Scenes/apartment?game=/Script/Engine.GameModeBase".
     * @param Type how TextURL relates to Base.
     */
    FURL(FURL* Base, const TCHAR* TextURL, ETravelType Type);

    /** Whether the option is there, e.g. HasOption(TEXT("game")); names compare without case. */
    bool HasOption(const TCHAR* Test) const;
    /** Value of the option "Match" (with its "=": GetOption(TEXT("game="), Default)), or Default when it is not there.
     */
    const TCHAR* GetOption(const TCHAR* Match, const TCHAR* Default) const;
    /** Adds or replaces an option "Name=Value". */
    void AddOption(const TCHAR* Str);
    /** Removes an option by its name (with or without "="). */
    void RemoveOption(const TCHAR* Key);
    /** The URL as text. */
    FString ToString(bool FullyQualified = false) const;
    /** Options as one text: "?A=1?B". */
    FString OptionsToString() const;

    bool operator==(const FURL& Other) const;
};
