// SPDX-License-Identifier: MIT
/** The engine's global state and log categories. */
#pragma once

#include "Logging/LogMacros.h"

class FOutputDeviceRedirector;

/** Never null. */
#define GLog (GetGlobalLogSingleton())
CORE_API FOutputDeviceRedirector* GetGlobalLogSingleton();

/** Frames since the start; the engine loop counts it up. */
extern CORE_API uint64 GFrameCounter;
/** The same for the game thread in 32 bits. */
extern CORE_API uint32 GFrameNumber;
extern CORE_API bool GIsRunning;
extern CORE_API bool GIsInitialLoad;
extern CORE_API bool GIsCriticalError;
extern CORE_API bool GIsEditor;
extern CORE_API bool GIsClient;
extern CORE_API bool GIsServer;
extern CORE_API bool GIsPlayInEditorWorld;
extern CORE_API bool GIsSilent;
extern CORE_API bool GIsAutomationTesting;
/** FPlatformTime::Seconds() at the start. */
extern CORE_API double GStartTime;
extern CORE_API uint32 GGameThreadId;
extern CORE_API bool GIsGameThreadIdInitialized;
extern CORE_API bool PRIVATE_GIsRunningCommandlet;
extern CORE_API TCHAR GInternalProjectName[64];
/** Where crash and fatal error texts go. */
extern CORE_API TCHAR GErrorHist[16384];

/** Has someone asked the engine to end? */
CORE_API bool IsEngineExitRequested();
/** Asks the engine loop to end after this frame. Callable from any thread. */
CORE_API void RequestEngineExit(const TCHAR* ReasonString);
CORE_API void RequestEngineExit(const FString& ReasonString);
/** For tests that run the loop more than once. */
CORE_API void ClearEngineExitRequest();

CORE_API bool IsInGameThread();
inline bool IsRunningCommandlet() { return PRIVATE_GIsRunningCommandlet; }
inline bool IsRunningDedicatedServer() { return false; }
inline bool IsRunningGame() { return !GIsEditor && !IsRunningCommandlet(); }
inline bool IsRunningClientOnly() { return false; }

CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogTemp, Log, All)
CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogCore, Log, All)
CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogInit, Log, All)
CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogExit, Log, All)
CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogHAL, Log, All)
CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogMemory, Log, All)
CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogModuleManager, Log, All)
CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogConsoleManager, Log, All)
CORE_API DECLARE_LOG_CATEGORY_EXTERN(LogConsoleResponse, Log, All)
