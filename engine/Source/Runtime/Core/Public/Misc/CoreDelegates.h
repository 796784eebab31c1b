// SPDX-License-Identifier: MIT
/** FCoreDelegates: moments of the engine's life. */
#pragma once

#include "Delegates/Delegate.h"

class FCoreDelegates {
public:
    /** On the game thread, first and last thing in each frame. */
    static CORE_API FSimpleMulticastDelegate OnBeginFrame;
    static CORE_API FSimpleMulticastDelegate OnEndFrame;
    static CORE_API FSimpleMulticastDelegate OnSamplingInput;
    /** All modules loaded, engine object made and initialised. */
    static CORE_API FSimpleMulticastDelegate OnPostEngineInit;
    static CORE_API FSimpleMulticastDelegate OnFEngineLoopInitComplete;
    static CORE_API FSimpleMulticastDelegate OnAllModuleLoadingPhasesComplete;
    /** The engine is about to shut down, everything is still there. */
    static CORE_API FSimpleMulticastDelegate OnEnginePreExit;
    static CORE_API FSimpleMulticastDelegate OnPreExit;
    static CORE_API FSimpleMulticastDelegate OnExit;
    static CORE_API FSimpleMulticastDelegate& GetApplicationWillTerminateDelegate();
    /** Someone called RequestEngineExit. */
    static CORE_API FSimpleMulticastDelegate& GetOnEngineExitRequested();

private:
    FCoreDelegates() = delete;
};
