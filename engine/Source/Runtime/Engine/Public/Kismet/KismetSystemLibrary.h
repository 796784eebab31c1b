// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "Engine/LatentActionManager.h"
#include "Engine/TimerHandle.h"
#include "Internationalization/Text.h"
#include "Kismet/BlueprintFunctionLibrary.h"
#include "Templates/SubclassOf.h"
#include "UObject/Interface.h"
#include "UObject/ObjectMacros.h"
#include "UObject/ScriptInterface.h"
#include "UObject/SoftObjectPath.h"
#include "UObject/SoftObjectPtr.h"

#include "KismetSystemLibrary.generated.h"

class AActor;
class APlayerController;
class UPrimitiveComponent;
class USceneComponent;

DECLARE_LOG_CATEGORY_EXTERN(LogBlueprintUserMessages, Log, All);

/** What MoveComponentTo does. Epic page: EMoveComponentAction::Type. */
UENUM()
namespace EMoveComponentAction {
enum Type : int {
    /** Move to target over specified time. */
    Move,
    /** If currently moving, stop. */
    Stop,
    /** If currently moving, return to where you started, over the time elapsed so far. */
    Return
};
}

/** How a game is left. Epic page: EQuitPreference::Type. */
UENUM()
namespace EQuitPreference {
enum Type : int {
    /** Exit the game completely. */
    Quit,
    /** Move the application to the background. */
    Background
};
}

/**
 * General services for scripts and remote programs: objects, console, printing, delays and timers. Epic page:
 * UKismetSystemLibrary.
 */
UCLASS(meta = (ScriptName = "SystemLibrary"))
class ENGINE_API UKismetSystemLibrary : public UBlueprintFunctionLibrary {
    GENERATED_BODY()

public:
    // --------------------------------------------------------------------------------------------------------- Objects

    /** Returns true if the object is usable: non-null and not pending destruction. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities")
    static bool IsValid(const UObject* Object);

    /** Returns true if the class is usable: non-null and not pending destruction. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities")
    static bool IsValidClass(UClass* Class);

    /** Returns the actual object name; "None" for null. */
    UFUNCTION(BlueprintPure, Category = "Utilities")
    static FString GetObjectName(const UObject* Object);

    /** Returns the full path to the specified object; "None" for null. */
    UFUNCTION(BlueprintPure, Category = "Utilities")
    static FString GetPathName(const UObject* Object);

    /** Returns the display name (or actor label), for displaying. In the embedded engine that is the object name;
     * "None" for null. */
    UFUNCTION(BlueprintPure, Category = "Utilities")
    static FString GetDisplayName(const UObject* Object);

    /** Returns the display name of a class; an empty string for null. */
    UFUNCTION(BlueprintPure, Category = "Utilities")
    static FString GetClassDisplayName(const UClass* Class);

    /** Returns the outer object of an object. */
    UFUNCTION(BlueprintPure, Category = "Utilities")
    static UObject* GetOuterObject(const UObject* Object);

    /** Determines if the passed object implements the supplied interface. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Does Object Implement Interface"), Category = "Utilities")
    static bool DoesImplementInterface(const UObject* TestObject, TSubclassOf<UInterface> Interface);

    /** Determines if the passed class implements the supplied interface. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Does Class Implement Interface"), Category = "Utilities")
    static bool DoesClassImplementInterface(const UClass* TestClass, TSubclassOf<UInterface> Interface);

    /** Casts from an object to a class; null when it is no class or not derived from the wanted one. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Cast To Class", DeterminesOutputType = "Class"), Category = "Utilities")
    static TSubclassOf<UObject> Conv_ObjectToClass(UObject* Object, TSubclassOf<UObject> Class);

    /** Deletes all unreferenced objects, keeping only referenced objects (this command will be queued and happen at the
     * end of the frame). */
    UFUNCTION(BlueprintCallable, Category = "Utilities")
    static void CollectGarbage();

    /** Converts an object to a soft reference to it. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Soft Object Reference", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities")
    static TSoftObjectPtr<UObject> Conv_ObjectToSoftObjectReference(UObject* Object);

    /** Resolves a soft reference to an object that is loaded; null if it is not. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Resolve Soft Reference", BlueprintInternalUseOnly = "true"),
        Category = "Utilities")
    static UObject* Conv_SoftObjectReferenceToObject(const TSoftObjectPtr<UObject>& SoftObject);

    /** Converts a soft object reference to its path. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To String (SoftObjectReference)", CompactNodeTitle = "->", BlueprintThreadSafe,
            BlueprintAutocast),
        Category = "Utilities")
    static FString Conv_SoftObjectReferenceToString(const TSoftObjectPtr<UObject>& SoftObjectReference);

    /** Returns true if the soft object reference is not null. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities")
    static bool IsValidSoftObjectReference(const TSoftObjectPtr<UObject>& SoftObjectReference);

    /** Returns true if the soft object references are equal (A == B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Equal (SoftObjectReference)", CompactNodeTitle = "==", BlueprintThreadSafe),
        Category = "Utilities")
    static bool EqualEqual_SoftObjectReference(const TSoftObjectPtr<UObject>& A, const TSoftObjectPtr<UObject>& B);

    /** Resolves or loads a soft object reference immediately. */
    UFUNCTION(BlueprintCallable, Category = "Utilities")
    static UObject* LoadAsset_Blocking(TSoftObjectPtr<UObject> Asset);

    /** Builds a soft object path from a string that contains a full path. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build", NativeMakeFunc, BlueprintThreadSafe),
        Category = "Utilities")
    static FSoftObjectPath MakeSoftObjectPath(const FString& PathString);

    /** Gets the path string out of a soft object path. */
    UFUNCTION(BlueprintPure, meta = (NativeBreakFunc, BlueprintThreadSafe), Category = "Utilities")
    static void BreakSoftObjectPath(FSoftObjectPath InSoftObjectPath, FString& PathString);

    // -------------------------------------------------------------------------------------------------------- Literals

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static int32 MakeLiteralInt(int32 Value);

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static int64 MakeLiteralInt64(int64 Value);

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static float MakeLiteralFloat(float Value);

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static double MakeLiteralDouble(double Value);

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static bool MakeLiteralBool(bool Value);

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static FName MakeLiteralName(FName Value);

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static uint8 MakeLiteralByte(uint8 Value);

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static FString MakeLiteralString(FString Value);

    /** Creates a literal: returns the value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Utilities|Literals")
    static FText MakeLiteralText(FText Value);

    // ---------------------------------------------------------------------------------------------- Properties by name

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetIntPropertyByName(UObject* Object, FName PropertyName, int32 Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetInt64PropertyByName(UObject* Object, FName PropertyName, int64 Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetBytePropertyByName(UObject* Object, FName PropertyName, uint8 Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetDoublePropertyByName(UObject* Object, FName PropertyName, double Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetBoolPropertyByName(UObject* Object, FName PropertyName, bool Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetObjectPropertyByName(UObject* Object, FName PropertyName, UObject* Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetClassPropertyByName(UObject* Object, FName PropertyName, TSubclassOf<UObject> Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetNamePropertyByName(UObject* Object, FName PropertyName, FName Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetStringPropertyByName(UObject* Object, FName PropertyName, const FString& Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetVectorPropertyByName(UObject* Object, FName PropertyName, const FVector& Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetRotatorPropertyByName(UObject* Object, FName PropertyName, const FRotator& Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetLinearColorPropertyByName(UObject* Object, FName PropertyName, const FLinearColor& Value);

    /** Sets a property of an object by its name; a property that is not there or has another type stays as it is, with
     * a warning in the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Utilities|Properties")
    static void SetTransformPropertyByName(UObject* Object, FName PropertyName, const FTransform& Value);

    // --------------------------------------------------------------------------------------------- Engine and platform

    /** Returns the version of the engine. The embedded engine says so in it. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static FString GetEngineVersion();

    /** Returns the build configuration. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static FString GetBuildConfiguration();

    /** Returns the name of the current project. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static FString GetGameName();

    /** Returns the directory of the current project. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "gamedir projectdir"), Category = "Utilities|Platform")
    static FString GetProjectDirectory();

    /** Returns the content directory of the current project. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static FString GetProjectContentDirectory();

    /** Returns the saved directory of the current project. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static FString GetProjectSavedDirectory();

    /** Returns the name of the user who runs the process. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static FString GetPlatformUserName();

    /** Returns the command line the process was launched with. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static FString GetCommandLine();

    /** Returns the number of the current frame. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static int64 GetFrameCount();

    /** Returns whether a string has a -parameter. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static bool ParseParam(const FString& InString, const FString& InParam);

    /** Returns "value" if a string has "param=value". */
    UFUNCTION(BlueprintPure, Category = "Utilities|Platform")
    static bool ParseParamValue(const FString& InString, const FString& InParam, FString& OutValue);

    // ------------------------------------------------------------------------------------------------- Kind of process

    /** Returns whether this process is (also) the server. Without a network it is. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Networking")
    static bool IsServer(const UObject* WorldContextObject);

    /** Returns whether this is running on a dedicated server. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Networking")
    static bool IsDedicatedServer(const UObject* WorldContextObject);

    /** Returns whether this game instance is stand-alone (no networking). */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Networking")
    static bool IsStandalone(const UObject* WorldContextObject);

    // -------------------------------------------------------------------------------------------- Console and printing

    /** Prints a string to the log, and optionally to the list of messages on the screen. If bPrintToLog is false the
     * log gets it as Verbose. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", CallableWithoutWorldContext, Keywords = "log print",
            AdvancedDisplay = "2", DevelopmentOnly),
        Category = "Development")
    static void PrintString(const UObject* WorldContextObject, const FString& InString = FString(TEXT("Hello")),
        bool bPrintToScreen = true, bool bPrintToLog = true, FLinearColor TextColor = FLinearColor(0.0, 0.66, 1.0),
        float Duration = 2.f, const FName Key = NAME_None);

    /** Prints text to the log, and optionally to the list of messages on the screen. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", CallableWithoutWorldContext, Keywords = "log",
            AdvancedDisplay = "2", DevelopmentOnly),
        Category = "Development")
    static void PrintText(const UObject* WorldContextObject, const FText InText, bool bPrintToScreen = true,
        bool bPrintToLog = true, FLinearColor TextColor = FLinearColor(0.0, 0.66, 1.0), float Duration = 2.f,
        const FName Key = NAME_None);

    /** Prints a warning string to the log. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true"), Category = "Development")
    static void PrintWarning(const FString& InString);

    /** Executes a console command, optionally on a specific player controller. */
    UFUNCTION(BlueprintCallable, meta = (WorldContext = "WorldContextObject"), Category = "Development")
    static void ExecuteConsoleCommand(
        const UObject* WorldContextObject, const FString& Command, APlayerController* SpecificPlayer = nullptr);

    /** Gets the value of a console variable as text; an empty string with a warning in the log if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Development")
    static FString GetConsoleVariableStringValue(const FString& VariableName);

    /** Gets the value of a console variable as a float; 0 with a warning in the log if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Development")
    static float GetConsoleVariableFloatValue(const FString& VariableName);

    /** Gets the value of a console variable as an integer; 0 with a warning in the log if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Development")
    static int32 GetConsoleVariableIntValue(const FString& VariableName);

    /** Gets whether a console variable has a non-zero value; false with a warning in the log if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Development")
    static bool GetConsoleVariableBoolValue(const FString& VariableName);

    /** Exits the current game at the end of the frame. Background is the same here as Quit. */
    UFUNCTION(BlueprintCallable, meta = (WorldContext = "WorldContextObject", CallableWithoutWorldContext),
        Category = "Development")
    static void QuitGame(const UObject* WorldContextObject, APlayerController* SpecificPlayer,
        TEnumAsByte<EQuitPreference::Type> QuitPreference, bool bIgnorePlatformRestrictions);

    // ----------------------------------------------------------------------------------------- Time, delays and timers

    /** Gets the current game time, in seconds. This stops when the game is paused and is affected by time dilation. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static double GetGameTimeInSeconds(const UObject* WorldContextObject);

    /** Performs a latent action with a delay (specified in seconds). Calling again while it is counting down will be
     * ignored. */
    UFUNCTION(BlueprintCallable,
        meta = (Latent, WorldContext = "WorldContextObject", LatentInfo = "LatentInfo", Duration = "0.2",
            Keywords = "sleep"),
        Category = "Utilities|Time")
    static void Delay(const UObject* WorldContextObject, float Duration, FLatentActionInfo LatentInfo);

    /** Performs a latent action with a retriggerable delay (specified in seconds). Calling again while it is counting
     * down will reset the countdown to Duration. */
    UFUNCTION(BlueprintCallable,
        meta = (Latent, WorldContext = "WorldContextObject", LatentInfo = "LatentInfo", Duration = "0.2",
            Keywords = "sleep"),
        Category = "Utilities|Time")
    static void RetriggerableDelay(const UObject* WorldContextObject, float Duration, FLatentActionInfo LatentInfo);

    /** Performs a latent action with a delay of one tick. Calling again while it is counting down will be ignored. */
    UFUNCTION(BlueprintCallable,
        meta = (Latent, WorldContext = "WorldContextObject", LatentInfo = "LatentInfo", Keywords = "sleep"),
        Category = "Utilities|Time")
    static void DelayUntilNextTick(const UObject* WorldContextObject, FLatentActionInfo LatentInfo);

    /** Sets a timer to execute a function of an object. Setting an existing timer will reset that timer with updated
     * parameters; a time of 0 or less clears it. */
    UFUNCTION(BlueprintCallable,
        meta = (DefaultToSelf = "Object", DisplayName = "Set Timer by Function Name", ScriptName = "SetTimer",
            AdvancedDisplay = "InitialStartDelay, InitialStartDelayVariance"),
        Category = "Utilities|Time")
    static FTimerHandle K2_SetTimer(UObject* Object, FString FunctionName, float Time, bool bLooping,
        bool bMaxOncePerFrame = false, float InitialStartDelay = 0.f, float InitialStartDelayVariance = 0.f);

    /** Sets a timer to execute a delegate. Setting an existing timer will reset that timer with updated parameters; a
     * time of 0 or less clears it. */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Set Timer by Event", ScriptName = "SetTimerDelegate",
            AdvancedDisplay = "InitialStartDelay, InitialStartDelayVariance"),
        Category = "Utilities|Time")
    static FTimerHandle K2_SetTimerDelegate(UPARAM(DisplayName = "Event") FTimerDynamicDelegate Delegate, float Time,
        bool bLooping, bool bMaxOncePerFrame = false, float InitialStartDelay = 0.f,
        float InitialStartDelayVariance = 0.f);

    /** Sets a timer to execute a function of an object on the next tick. */
    UFUNCTION(BlueprintCallable,
        meta = (DefaultToSelf = "Object", DisplayName = "Set Timer for Next Tick by Function Name",
            ScriptName = "SetTimerForNextTick"),
        Category = "Utilities|Time")
    static FTimerHandle K2_SetTimerForNextTick(UObject* Object, FString FunctionName);

    /** Clears a set timer. */
    UFUNCTION(BlueprintCallable,
        meta = (DefaultToSelf = "Object", DisplayName = "Clear Timer by Function Name", ScriptName = "ClearTimer"),
        Category = "Utilities|Time")
    static void K2_ClearTimer(UObject* Object, FString FunctionName);

    /** Pauses a set timer at its current elapsed time. */
    UFUNCTION(BlueprintCallable,
        meta = (DefaultToSelf = "Object", DisplayName = "Pause Timer by Function Name", ScriptName = "PauseTimer"),
        Category = "Utilities|Time")
    static void K2_PauseTimer(UObject* Object, FString FunctionName);

    /** Resumes a paused timer from its current elapsed time. */
    UFUNCTION(BlueprintCallable,
        meta = (DefaultToSelf = "Object", DisplayName = "Unpause Timer by Function Name", ScriptName = "UnPauseTimer"),
        Category = "Utilities|Time")
    static void K2_UnPauseTimer(UObject* Object, FString FunctionName);

    /** Returns true if a timer exists and is active for the given function, false otherwise. */
    UFUNCTION(BlueprintPure,
        meta = (DefaultToSelf = "Object", DisplayName = "Is Timer Active by Function Name",
            ScriptName = "IsTimerActive"),
        Category = "Utilities|Time")
    static bool K2_IsTimerActive(UObject* Object, FString FunctionName);

    /** Returns true if a timer exists for the given function, false otherwise. */
    UFUNCTION(BlueprintPure,
        meta = (DefaultToSelf = "Object", DisplayName = "Does Timer Exist by Function Name",
            ScriptName = "TimerExists"),
        Category = "Utilities|Time")
    static bool K2_TimerExists(UObject* Object, FString FunctionName);

    /** Returns whether the timer handle is valid. This does not indicate that there is an active timer that this handle
     * references. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Is Valid Timer Handle", ScriptName = "IsValidTimerHandle"),
        Category = "Utilities|Time")
    static bool K2_IsValidTimerHandle(FTimerHandle Handle);

    /** Invalidates the supplied timer handle and returns it. The timer itself goes on. */
    UFUNCTION(BlueprintCallable, meta = (DisplayName = "Invalidate Timer Handle", ScriptName = "InvalidateTimerHandle"),
        Category = "Utilities|Time")
    static FTimerHandle K2_InvalidateTimerHandle(UPARAM(ref) FTimerHandle& Handle);

    /** Clears the timer and invalidates the handle. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", DisplayName = "Clear and Invalidate Timer by Handle",
            ScriptName = "ClearAndInvalidateTimerHandle"),
        Category = "Utilities|Time")
    static void K2_ClearAndInvalidateTimerHandle(const UObject* WorldContextObject, UPARAM(ref) FTimerHandle& Handle);

    /** Pauses a timer at its current elapsed time. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", DisplayName = "Pause Timer by Handle",
            ScriptName = "PauseTimerHandle"),
        Category = "Utilities|Time")
    static void K2_PauseTimerHandle(const UObject* WorldContextObject, FTimerHandle Handle);

    /** Resumes a paused timer from its current elapsed time. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", DisplayName = "Unpause Timer by Handle",
            ScriptName = "UnPauseTimerHandle"),
        Category = "Utilities|Time")
    static void K2_UnPauseTimerHandle(const UObject* WorldContextObject, FTimerHandle Handle);

    /** Returns true if a timer exists and is active for the given handle, false otherwise. */
    UFUNCTION(BlueprintPure,
        meta = (WorldContext = "WorldContextObject", DisplayName = "Is Timer Active by Handle",
            ScriptName = "IsTimerActiveHandle"),
        Category = "Utilities|Time")
    static bool K2_IsTimerActiveHandle(const UObject* WorldContextObject, FTimerHandle Handle);

    /** Returns elapsed time for the given handle (time since current countdown iteration began), in seconds; 0 if there
     * is no such timer. */
    UFUNCTION(BlueprintPure,
        meta = (WorldContext = "WorldContextObject", DisplayName = "Get Timer Elapsed Time by Handle",
            ScriptName = "GetTimerElapsedTimeHandle"),
        Category = "Utilities|Time")
    static float K2_GetTimerElapsedTimeHandle(const UObject* WorldContextObject, FTimerHandle Handle);

    /** Returns time until the timer will next execute its function, in seconds; 0 if there is no such timer. */
    UFUNCTION(BlueprintPure,
        meta = (WorldContext = "WorldContextObject", DisplayName = "Get Timer Remaining Time by Handle",
            ScriptName = "GetTimerRemainingTimeHandle"),
        Category = "Utilities|Time")
    static float K2_GetTimerRemainingTimeHandle(const UObject* WorldContextObject, FTimerHandle Handle);

    // ------------------------------------------------------------------------------------------- Components and actors

    /** Interpolates a component to the specified relative location and rotation over a time (seconds). Move starts,
     * Stop leaves the component where it is, Return moves it back to where it started. */
    UFUNCTION(BlueprintCallable,
        meta = (Latent, LatentInfo = "LatentInfo", WorldContext = "Component", ExpandEnumAsExecs = "MoveAction",
            OverTime = "0.2"),
        Category = "Components")
    static void MoveComponentTo(USceneComponent* Component, FVector TargetRelativeLocation,
        FRotator TargetRelativeRotation, bool bEaseOut, bool bEaseIn, float OverTime, bool bForceShortestRotationPath,
        TEnumAsByte<EMoveComponentAction::Type> MoveAction, FLatentActionInfo LatentInfo);

    /** Gets the bounds of a component in world space, in centimetres; zero for null. */
    UFUNCTION(BlueprintPure, Category = "Components")
    static void GetComponentBounds(
        const USceneComponent* Component, FVector& Origin, FVector& BoxExtent, float& SphereRadius);

    /** Returns the distinct owners of a list of components, optionally only those of a class. */
    UFUNCTION(BlueprintCallable, Category = "Components")
    static void GetActorListFromComponentList(
        const TArray<UPrimitiveComponent*>& ComponentList, UClass* ActorClassFilter, TArray<AActor*>& OutActorList);
};
