// SPDX-License-Identifier: MIT
#include "SpearBenchFrames.h"

#include "Engine/World.h"
#include "HAL/PlatformTime.h"
#include "Misc/CommandLine.h"
#include "Misc/CoreDelegates.h"
#include "Misc/Parse.h"
#include "Modules/ModuleManager.h"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

DEFINE_LOG_CATEGORY_STATIC(LogSpearBench, Log, All);

static_assert(sizeof(FSpearFrameLog::FEntry) == 32 && sizeof(FSpearFrameLog) == 32 + 32 * FSpearFrameLog::NumEntries);

int64 USpearBenchFrames::Frame() { return static_cast<int64>(GFrameCounter); }

void USpearBenchFrames::Work(double Milliseconds) {
    const double Ends = FPlatformTime::Seconds() + Milliseconds * 1e-3;
    while (FPlatformTime::Seconds() < Ends) {}
}

ASpearBenchLoad::ASpearBenchLoad() { PrimaryActorTick.bCanEverTick = true; }

void ASpearBenchLoad::Tick(float DeltaSeconds) {
    Super::Tick(DeltaSeconds);
    USpearBenchFrames::Work(Milliseconds);
}

namespace {

int64 MonotonicNs() {
    timespec Now{};
    clock_gettime(CLOCK_MONOTONIC, &Now);
    return static_cast<int64>(Now.tv_sec) * 1'000'000'000 + static_cast<int64>(Now.tv_nsec);
}

/** The module: keeps the frame log if the command line asks for one. Game thread. */
class FSpearBenchModule : public IModuleInterface {
public:
    virtual void StartupModule() override {
        FString Path;
        if (!FParse::Value(FCommandLine::Get(), TEXT("-SpearBenchFrameLog="), Path, false)) {
            return;
        }
        const int File = open(TCHAR_TO_UTF8(*Path), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (File >= 0 && ftruncate(File, sizeof(FSpearFrameLog)) == 0) {
            void* const Mapped = mmap(nullptr, sizeof(FSpearFrameLog), PROT_READ | PROT_WRITE, MAP_SHARED, File, 0);
            Log = Mapped != MAP_FAILED ? static_cast<FSpearFrameLog*>(Mapped) : nullptr;
        }
        if (!Log) {
            UE_LOG(
                LogSpearBench, Error, TEXT("There is no frame log: '%s': %s"), *Path, UTF8_TO_TCHAR(strerror(errno)));
        } else {
            BeginHandle = FCoreDelegates::OnBeginFrame.AddRaw(this, &FSpearBenchModule::OnBeginFrame);
            EndHandle = FCoreDelegates::OnEndFrame.AddRaw(this, &FSpearBenchModule::OnEndFrame);
            TickHandle = FWorldDelegates::OnWorldTickStart.AddRaw(this, &FSpearBenchModule::OnWorldTickStart);
        }
        if (File >= 0) {
            close(File);
        }
    }

    virtual void ShutdownModule() override {
        FCoreDelegates::OnBeginFrame.Remove(BeginHandle);
        FCoreDelegates::OnEndFrame.Remove(EndHandle);
        FWorldDelegates::OnWorldTickStart.Remove(TickHandle);
        if (Log) {
            munmap(Log, sizeof(FSpearFrameLog));
            Log = nullptr;
        }
    }

private:
    FSpearFrameLog::FEntry& Entry() { return Log->Entries[NumFrames % FSpearFrameLog::NumEntries]; }
    void OnBeginFrame() { Entry() = {GFrameCounter, MonotonicNs(), 0, 0}; }
    void OnWorldTickStart(UWorld*, ELevelTick, float) {
        if (Entry().SleepEndNs == 0) {
            Entry().SleepEndNs = MonotonicNs();
        }
    }
    void OnEndFrame() {
        Entry().EndNs = MonotonicNs();
        __atomic_store_n(&Log->NumFrames, ++NumFrames, __ATOMIC_RELEASE);
    }

    FSpearFrameLog* Log = nullptr;
    uint64 NumFrames = 0;
    FDelegateHandle BeginHandle;
    FDelegateHandle EndHandle;
    FDelegateHandle TickHandle;
};

} // namespace

IMPLEMENT_MODULE(FSpearBenchModule, SpearBench)
