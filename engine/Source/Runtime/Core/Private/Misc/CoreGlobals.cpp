// SPDX-License-Identifier: MIT
#include "CoreGlobals.h"

#include <atomic>

#include "HAL/PlatformTLS.h"
#include "HAL/PlatformTime.h"
#include "Misc/CoreDelegates.h"
#include "Misc/OutputDeviceRedirector.h"

uint64 GFrameCounter = 0;
uint32 GFrameNumber = 0;
bool GIsRunning = false;
bool GIsInitialLoad = true;
bool GIsCriticalError = false;
bool GIsEditor = false;
bool GIsClient = true;
bool GIsServer = true;
bool GIsPlayInEditorWorld = false;
bool GIsSilent = false;
bool GIsAutomationTesting = false;
bool PRIVATE_GIsRunningCommandlet = false;
double GStartTime = FPlatformTime::Seconds();
// The thread that loads Core; the launcher sets it again.
uint32 GGameThreadId = FPlatformTLS::GetCurrentThreadId();
bool GIsGameThreadIdInitialized = true;
TCHAR GInternalProjectName[64] = TEXT("");
TCHAR GErrorHist[16384] = TEXT("");

DEFINE_LOG_CATEGORY(LogTemp)
DEFINE_LOG_CATEGORY(LogCore)
DEFINE_LOG_CATEGORY(LogInit)
DEFINE_LOG_CATEGORY(LogExit)
DEFINE_LOG_CATEGORY(LogHAL)
DEFINE_LOG_CATEGORY(LogMemory)
DEFINE_LOG_CATEGORY(LogModuleManager)
DEFINE_LOG_CATEGORY(LogConsoleManager)
DEFINE_LOG_CATEGORY(LogConsoleResponse)

namespace {
std::atomic<bool> GExitRequested{false};
}

FOutputDeviceRedirector* GetGlobalLogSingleton() { return FOutputDeviceRedirector::Get(); }

bool IsEngineExitRequested() { return GExitRequested.load(std::memory_order_acquire); }

void RequestEngineExit(const TCHAR* ReasonString) {
    if (!GExitRequested.exchange(true)) {
        UE_LOG(
            LogCore, Log, TEXT("Engine exit requested (reason: %s)"), ReasonString ? ReasonString : TEXT("none given"));
        FCoreDelegates::GetOnEngineExitRequested().Broadcast();
    }
}

void RequestEngineExit(const FString& ReasonString) { RequestEngineExit(*ReasonString); }

void ClearEngineExitRequest() { GExitRequested.store(false); }

bool IsInGameThread() { return FPlatformTLS::GetCurrentThreadId() == GGameThreadId; }
