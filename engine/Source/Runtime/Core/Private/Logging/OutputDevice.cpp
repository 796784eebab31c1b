// SPDX-License-Identifier: MIT
#include <atomic>
#include <cstdio>

#include "CoreGlobals.h"
#include "Misc/DateTime.h"
#include "Misc/OutputDeviceHelper.h"
#include "Misc/OutputDeviceRedirector.h"
#include "Misc/ScopeLock.h"

FString FOutputDeviceHelper::FormatLogLine(
    ELogVerbosity::Type Verbosity, const FName& Category, const TCHAR* Message, bool bWithPrefix) {
    FString Line;
    if (bWithPrefix) {
        const FDateTime Now = FDateTime::UtcNow();
        const uint64 Frame = std::atomic_ref<uint64>(GFrameCounter).load(std::memory_order_relaxed); // any thread logs
        Line = FString::Printf(TEXT("[%s:%03d][%3llu]"), *Now.ToString(), Now.GetMillisecond(), Frame % 1000);
    }
    if (!Category.IsNone()) {
        Line += Category.ToString() + TEXT(": ");
    }
    // Plain log lines carry no word for their verbosity.
    const int32 Level = Verbosity & ELogVerbosity::VerbosityMask;
    if (Level != ELogVerbosity::Log && Level != ELogVerbosity::NoLogging) {
        Line += FString(::ToString(Verbosity)) + TEXT(": ");
    }
    Line += Message;
    return Line;
}

struct FOutputDeviceRedirector::FImpl {
    // Recursive: a device may log.
    FCriticalSection Lock;
    TArray<FOutputDevice*> Devices;
};

FOutputDeviceRedirector::FOutputDeviceRedirector() : Impl(new FImpl()) {
    Impl->Devices.Add(&FOutputDeviceStdErr::Get());
}

FOutputDeviceRedirector::~FOutputDeviceRedirector() { delete Impl; }

FOutputDeviceRedirector* FOutputDeviceRedirector::Get() {
    // Never destroyed: static destructors log too.
    static FOutputDeviceRedirector* Singleton = new FOutputDeviceRedirector();
    return Singleton;
}

void FOutputDeviceRedirector::AddOutputDevice(FOutputDevice* OutputDevice) {
    FScopeLock Lock(&Impl->Lock);
    if (OutputDevice) {
        Impl->Devices.AddUnique(OutputDevice);
    }
}

void FOutputDeviceRedirector::RemoveOutputDevice(FOutputDevice* OutputDevice) {
    FScopeLock Lock(&Impl->Lock);
    Impl->Devices.Remove(OutputDevice);
}

bool FOutputDeviceRedirector::IsRedirectingTo(FOutputDevice* OutputDevice) {
    FScopeLock Lock(&Impl->Lock);
    return Impl->Devices.Contains(OutputDevice);
}

void FOutputDeviceRedirector::Serialize(const TCHAR* Data, ELogVerbosity::Type Verbosity, const FName& Category) {
    Serialize(Data, Verbosity, Category, -1.0);
}

void FOutputDeviceRedirector::Serialize(
    const TCHAR* Data, ELogVerbosity::Type Verbosity, const FName& Category, const double Time) {
    FScopeLock Lock(&Impl->Lock);
    const TArray<FOutputDevice*> Devices(Impl->Devices);
    for (FOutputDevice* Device : Devices) {
        Device->Serialize(Data, Verbosity, Category, Time);
    }
}

void FOutputDeviceRedirector::Flush() {
    FScopeLock Lock(&Impl->Lock);
    for (FOutputDevice* Device : Impl->Devices) {
        Device->Flush();
    }
}

void FOutputDeviceRedirector::TearDown() {
    FScopeLock Lock(&Impl->Lock);
    const TArray<FOutputDevice*> Devices = MoveTemp(Impl->Devices);
    for (FOutputDevice* Device : Devices) {
        Device->Flush();
        Device->TearDown();
    }
}

FOutputDeviceStdErr& FOutputDeviceStdErr::Get() {
    static FOutputDeviceStdErr& Device = *new FOutputDeviceStdErr();
    return Device;
}

void FOutputDeviceStdErr::Serialize(const TCHAR* V, ELogVerbosity::Type Verbosity, const FName& Category) {
    if ((Verbosity & ELogVerbosity::VerbosityMask) <= MaxVerbosity) {
        const FString Line = FOutputDeviceHelper::FormatLogLine(Verbosity, Category, V) + TEXT("\n");
        // One write, so that lines of several processes do not mix.
        const FTCHARToUTF8 Utf8(*Line, Line.Len());
        std::fwrite(Utf8.Get(), 1, static_cast<size_t>(Utf8.Length()), stderr);
    }
}

FOutputDeviceFile::FOutputDeviceFile(const TCHAR* InFilename)
    : Filename(InFilename), Handle(std::fopen(TCHAR_TO_UTF8(InFilename), "w")) {}

FOutputDeviceFile::~FOutputDeviceFile() { TearDown(); }

void FOutputDeviceFile::Serialize(const TCHAR* V, ELogVerbosity::Type Verbosity, const FName& Category) {
    if (Handle) {
        const FString Line = FOutputDeviceHelper::FormatLogLine(Verbosity, Category, V) + TEXT("\n");
        const FTCHARToUTF8 Utf8(*Line, Line.Len());
        std::fwrite(Utf8.Get(), 1, static_cast<size_t>(Utf8.Length()), static_cast<FILE*>(Handle));
        if ((Verbosity & ELogVerbosity::VerbosityMask) <= ELogVerbosity::Warning) {
            Flush();
        }
    }
}

void FOutputDeviceFile::Flush() {
    if (Handle) {
        std::fflush(static_cast<FILE*>(Handle));
    }
}

void FOutputDeviceFile::TearDown() {
    if (Handle) {
        std::fclose(static_cast<FILE*>(Handle));
        Handle = nullptr;
    }
}
