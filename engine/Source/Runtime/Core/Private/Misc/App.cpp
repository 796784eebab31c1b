// SPDX-License-Identifier: MIT
#include "Misc/App.h"

#include "CoreMinimal.h"
#include "HAL/PlatformProcess.h"
#include "Misc/EngineVersion.h"

namespace {
/** Game thread only, but for the ids and names, which are constant. */
struct FAppState {
    FGuid InstanceId = FGuid::NewGuid();
    FString ProjectName = TEXT("EmbeddedEngine");
    bool bHasProjectName = false;
    double CurrentTime = 0.0, LastTime = 0.0, GameTime = 0.0, DeltaTime = 1.0 / 30.0, IdleTime = 0.0,
           IdleTimeOvershoot = 0.0;
    double FixedDeltaTime = 1.0 / 30.0;
    bool bUseFixedTimeStep = false, bBenchmarking = false, bUseFixedSeed = false;
};
FAppState& State() {
    static FAppState Instance;
    return Instance;
}
} // namespace

FGuid FApp::GetInstanceId() { return State().InstanceId; }
FGuid FApp::GetSessionId() { return State().InstanceId; }
FString FApp::GetInstanceName() {
    return FString::Printf(TEXT("%s-%u"), FPlatformProcess::ComputerName(), FPlatformProcess::GetCurrentProcessId());
}
const TCHAR* FApp::GetProjectName() { return *State().ProjectName; }
bool FApp::HasProjectName() { return State().bHasProjectName; }
void FApp::SetProjectName(const TCHAR* InProjectName) {
    State().ProjectName = InProjectName;
    State().bHasProjectName = true;
}
FString FApp::GetName() { return State().ProjectName; }
const TCHAR* FApp::GetBuildVersion() { return TEXT("spear-embedded"); }
bool FApp::CanEverRender() { return false; }
bool FApp::IsUnattended() { return true; }
double FApp::GetCurrentTime() { return State().CurrentTime; }
void FApp::SetCurrentTime(double Seconds) { State().CurrentTime = Seconds; }
double FApp::GetLastTime() { return State().LastTime; }
void FApp::UpdateLastTime() { State().LastTime = State().CurrentTime; }
double FApp::GetGameTime() { return State().GameTime; }
void FApp::SetGameTime(double Seconds) { State().GameTime = Seconds; }
double FApp::GetDeltaTime() { return State().DeltaTime; }
void FApp::SetDeltaTime(double Seconds) { State().DeltaTime = Seconds; }
double FApp::GetIdleTime() { return State().IdleTime; }
void FApp::SetIdleTime(double Seconds) { State().IdleTime = Seconds; }
double FApp::GetIdleTimeOvershoot() { return State().IdleTimeOvershoot; }
void FApp::SetIdleTimeOvershoot(double Seconds) { State().IdleTimeOvershoot = Seconds; }
double FApp::GetFixedDeltaTime() { return State().FixedDeltaTime; }
void FApp::SetFixedDeltaTime(double Seconds) { State().FixedDeltaTime = Seconds; }
bool FApp::UseFixedTimeStep() { return State().bUseFixedTimeStep; }
void FApp::SetUseFixedTimeStep(bool bVal) { State().bUseFixedTimeStep = bVal; }
bool FApp::IsBenchmarking() { return State().bBenchmarking; }
void FApp::SetBenchmarking(bool bVal) { State().bBenchmarking = bVal; }
bool FApp::UseFixedSeed() { return State().bUseFixedSeed; }
void FApp::SetUseFixedSeed(bool bVal) { State().bUseFixedSeed = bVal; }

const FEngineVersion& FEngineVersion::Current() {
    static const FEngineVersion Version(
        ENGINE_MAJOR_VERSION, ENGINE_MINOR_VERSION, ENGINE_PATCH_VERSION, 0, TEXT("spear-embedded"));
    return Version;
}
FString FEngineVersion::ToString(EVersionComponent LastComponent) const {
    FString Result = FString::Printf(TEXT("%u"), static_cast<uint32>(Major));
    if (LastComponent >= EVersionComponent::Minor) {
        Result += FString::Printf(TEXT(".%u"), static_cast<uint32>(Minor));
    }
    if (LastComponent >= EVersionComponent::Patch) {
        Result += FString::Printf(TEXT(".%u"), static_cast<uint32>(Patch));
    }
    if (LastComponent >= EVersionComponent::Changelist) {
        Result += FString::Printf(TEXT("-%u"), Changelist);
    }
    if (LastComponent >= EVersionComponent::Branch && !Branch.IsEmpty()) {
        Result += TEXT("+") + Branch;
    }
    return Result;
}
