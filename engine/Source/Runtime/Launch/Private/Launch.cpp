// SPDX-License-Identifier: MIT
/** @file main() of spear-engine. */
#include "LaunchEngineLoop.h"
#include "LaunchOptions.h"

#include "CoreGlobals.h"
#include "HAL/PlatformMisc.h"

#include <csignal>
#include <cstdio>
#include <pthread.h>
#include <unistd.h>

namespace {
sigset_t TerminationSignals() {
    sigset_t Signals;
    sigemptyset(&Signals);
    sigaddset(&Signals, SIGINT);
    sigaddset(&Signals, SIGTERM);
    return Signals;
}

/** Waits for signals in a thread of its own, where everything may be called: the first asks to end, the second ends at
 * once. */
void* WaitForSignals(void*) {
    const sigset_t Signals = TerminationSignals();
    int Signal = 0;
    if (sigwait(&Signals, &Signal) == 0) {
        RequestEngineExit(Signal == SIGINT ? TEXT("SIGINT") : TEXT("SIGTERM"));
    }
    if (sigwait(&Signals, &Signal) == 0) {
        static const char Text[] = "spear-engine: second signal, ending at once\n";
        (void)!write(STDERR_FILENO, Text, sizeof(Text) - 1);
        _exit(128 + Signal);
    }
    return nullptr;
}
} // namespace

int main(int ArgumentCount, char** Arguments) {
    FLaunchOptions Options;
    if (const std::optional<int> ExitCode = ParseLaunchOptions(ArgumentCount, Arguments, Options)) {
        return *ExitCode;
    }
    // Blocked before any other thread exists, so that all inherit it and only the waiting thread receives the signals.
    const sigset_t Signals = TerminationSignals();
    pthread_sigmask(SIG_BLOCK, &Signals, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    pthread_t Thread;
    if (pthread_create(&Thread, nullptr, &WaitForSignals, nullptr) == 0) {
        pthread_detach(Thread);
    }

    FEngineLoop EngineLoop;
    int32 ExitCode = EngineLoop.PreInit(Options);
    if (ExitCode == 0) {
        ExitCode = EngineLoop.Init();
    }
    while (ExitCode == 0 && !IsEngineExitRequested()) {
        EngineLoop.Tick();
    }
    EngineLoop.Exit();
    return ExitCode != 0 ? ExitCode : FPlatformMisc::GetRequestedExitStatus();
}
