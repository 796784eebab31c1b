// SPDX-License-Identifier: MIT
#include "Kismet/KismetSystemLibrary.h"
#include "Components/PrimitiveComponent.h"
#include "Components/SceneComponent.h"
#include "DelayAction.h"
#include "Engine/Engine.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "GameFramework/PlayerController.h"
#include "HAL/IConsoleManager.h"
#include "HAL/PlatformProcess.h"
#include "KismetPrivate.h"
#include "Misc/App.h"
#include "Misc/CommandLine.h"
#include "Misc/EngineVersion.h"
#include "Misc/Parse.h"
#include "Misc/Paths.h"
#include "TimerManager.h"

// Engine and platform

FString UKismetSystemLibrary::GetEngineVersion() { return FEngineVersion::Current().ToString(); }

FString UKismetSystemLibrary::GetBuildConfiguration() { return FString(TEXT("Development")); }

FString UKismetSystemLibrary::GetGameName() { return FString(FApp::GetProjectName()); }

FString UKismetSystemLibrary::GetProjectDirectory() { return FPaths::ProjectDir(); }

FString UKismetSystemLibrary::GetProjectContentDirectory() { return FPaths::ProjectContentDir(); }

FString UKismetSystemLibrary::GetProjectSavedDirectory() { return FPaths::ProjectSavedDir(); }

FString UKismetSystemLibrary::GetPlatformUserName() { return FPlatformProcess::UserName(false); }

FString UKismetSystemLibrary::GetCommandLine() { return FString(FCommandLine::Get()); }

int64 UKismetSystemLibrary::GetFrameCount() { return static_cast<int64>(GFrameCounter); }

bool UKismetSystemLibrary::ParseParam(const FString& InString, const FString& InParam) {
    return FParse::Param(*InString, *InParam);
}

bool UKismetSystemLibrary::ParseParamValue(const FString& InString, const FString& InParam, FString& OutValue) {
    return FParse::Value(*InString, *(InParam + TEXT("=")), OutValue);
}

// Kind of process

bool UKismetSystemLibrary::IsServer(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetNetMode() != NM_Client : false;
}

bool UKismetSystemLibrary::IsDedicatedServer(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetNetMode() == NM_DedicatedServer : false;
}

bool UKismetSystemLibrary::IsStandalone(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetNetMode() == NM_Standalone : false;
}

// Console and printing

void UKismetSystemLibrary::PrintString(const UObject* WorldContextObject, const FString& InString, bool bPrintToScreen,
    bool bPrintToLog, FLinearColor TextColor, float Duration, const FName Key) {
    KismetPrivate::Print(InString, bPrintToScreen, bPrintToLog, TextColor, Duration, Key);
}

void UKismetSystemLibrary::PrintText(const UObject* WorldContextObject, const FText InText, bool bPrintToScreen,
    bool bPrintToLog, FLinearColor TextColor, float Duration, const FName Key) {
    KismetPrivate::Print(InText.ToString(), bPrintToScreen, bPrintToLog, TextColor, Duration, Key);
}

void UKismetSystemLibrary::PrintWarning(const FString& InString) {
    UE_LOG(LogBlueprintUserMessages, Warning, TEXT("%s"), *InString);
}

void UKismetSystemLibrary::ExecuteConsoleCommand(
    const UObject* WorldContextObject, const FString& Command, APlayerController* SpecificPlayer) {
    KismetPrivate::ExecuteConsoleCommand(WorldContextObject, Command, SpecificPlayer);
}

FString UKismetSystemLibrary::GetConsoleVariableStringValue(const FString& VariableName) {
    const IConsoleVariable* const Variable = KismetPrivate::FindConsoleVariable(VariableName);
    return Variable ? Variable->GetString() : FString();
}

float UKismetSystemLibrary::GetConsoleVariableFloatValue(const FString& VariableName) {
    const IConsoleVariable* const Variable = KismetPrivate::FindConsoleVariable(VariableName);
    return Variable ? Variable->GetFloat() : 0.0f;
}

int32 UKismetSystemLibrary::GetConsoleVariableIntValue(const FString& VariableName) {
    const IConsoleVariable* const Variable = KismetPrivate::FindConsoleVariable(VariableName);
    return Variable ? Variable->GetInt() : 0;
}

bool UKismetSystemLibrary::GetConsoleVariableBoolValue(const FString& VariableName) {
    const IConsoleVariable* const Variable = KismetPrivate::FindConsoleVariable(VariableName);
    return Variable && Variable->GetInt() != 0;
}

void UKismetSystemLibrary::QuitGame(const UObject* WorldContextObject, APlayerController* SpecificPlayer,
    TEnumAsByte<EQuitPreference::Type> QuitPreference, bool bIgnorePlatformRestrictions) {
    RequestEngineExit(TEXT("UKismetSystemLibrary::QuitGame"));
}
