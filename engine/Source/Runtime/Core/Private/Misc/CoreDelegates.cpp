// SPDX-License-Identifier: MIT
#include "Misc/CoreDelegates.h"

#include "CoreMinimal.h"

FSimpleMulticastDelegate FCoreDelegates::OnBeginFrame;
FSimpleMulticastDelegate FCoreDelegates::OnEndFrame;
FSimpleMulticastDelegate FCoreDelegates::OnSamplingInput;
FSimpleMulticastDelegate FCoreDelegates::OnPostEngineInit;
FSimpleMulticastDelegate FCoreDelegates::OnFEngineLoopInitComplete;
FSimpleMulticastDelegate FCoreDelegates::OnAllModuleLoadingPhasesComplete;
FSimpleMulticastDelegate FCoreDelegates::OnEnginePreExit;
FSimpleMulticastDelegate FCoreDelegates::OnPreExit;
FSimpleMulticastDelegate FCoreDelegates::OnExit;

FSimpleMulticastDelegate& FCoreDelegates::GetApplicationWillTerminateDelegate() {
    static FSimpleMulticastDelegate Delegate;
    return Delegate;
}
FSimpleMulticastDelegate& FCoreDelegates::GetOnEngineExitRequested() {
    static FSimpleMulticastDelegate Delegate;
    return Delegate;
}
