// SPDX-License-Identifier: MIT
/** @file What the source files of the function libraries share. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "Engine/LatentActionManager.h"
#include "Engine/TimerHandle.h"
#include "Kismet/KismetSystemLibrary.h"
#include "Templates/Function.h"
#include "Templates/SubclassOf.h"

class AActor;
class APawn;
class APlayerController;
class FTimerManager;
class IConsoleVariable;
class USceneComponent;
class UWorld;

DECLARE_LOG_CATEGORY_EXTERN(LogKismet, Log, All);

namespace KismetPrivate {

/** The world of a context object; null, with a warning in the log, if it has none. */
UWorld* GetWorld(const UObject* WorldContextObject);
/** The pawn responsible for what a context object spawns, or null. */
APawn* FindInstigator(const UObject* WorldContextObject);
/** All actors of a class, or derived from it, that a filter lets through. */
void CollectActors(const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass, TArray<AActor*>& OutActors,
    TFunctionRef<bool(const AActor*)> Filter);
/** Finds "?Key=Value" or "?Key" in an options string; keys compare without case. */
bool FindOption(const FString& Options, const FString& Key, FString& OutValue);

/** Write a property of an object by its name; what does not fit stays as it is, with a warning in the log. */
void SetNumber(UObject* Object, FName PropertyName, int64 Value);
void SetNumber(UObject* Object, FName PropertyName, double Value);
void SetBool(UObject* Object, FName PropertyName, bool Value);
void SetObject(UObject* Object, FName PropertyName, UObject* Value);
void SetName(UObject* Object, FName PropertyName, FName Value);
void SetString(UObject* Object, FName PropertyName, const FString& Value);
void SetStruct(UObject* Object, FName PropertyName, const TCHAR* StructPath, const void* Value);

/** Prints to log and screen. */
void Print(
    const FString& Text, bool bPrintToScreen, bool bPrintToLog, FLinearColor TextColor, float Duration, FName Key);
/** Runs a console command. */
void ExecuteConsoleCommand(
    const UObject* WorldContextObject, const FString& Command, APlayerController* SpecificPlayer);
/** Finds a console variable; null, with a warning in the log, if there is none. */
IConsoleVariable* FindConsoleVariable(const FString& Name);

/** A delegate to a function of an object, unbound and with a warning in the log if it cannot be called by a timer. */
FTimerDynamicDelegate MakeTimerDelegate(UObject* Object, const FString& FunctionName);
/** Sets the timer of a delegate, or resets the one it has. */
FTimerHandle SetTimer(const FTimerDynamicDelegate& Delegate, float Time, bool bLooping, bool bMaxOncePerFrame,
    float InitialStartDelay, float InitialStartDelayVariance);
/** Calls with the timer of a function, if there is one. */
void WithTimer(UObject* Object, const FString& FunctionName, TFunctionRef<void(FTimerManager&, FTimerHandle&)> Use);

/** See UKismetSystemLibrary::MoveComponentTo. */
void MoveComponentTo(USceneComponent* Component, FVector TargetRelativeLocation, FRotator TargetRelativeRotation,
    bool bEaseOut, bool bEaseIn, float OverTime, bool bForceShortestRotationPath, EMoveComponentAction::Type MoveAction,
    const FLatentActionInfo& LatentInfo);

} // namespace KismetPrivate
