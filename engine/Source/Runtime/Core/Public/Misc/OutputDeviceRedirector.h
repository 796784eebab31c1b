// SPDX-License-Identifier: MIT
/** FOutputDeviceRedirector (GLog): hands each log line to all devices, at once and from whatever thread. */
#pragma once

#include "Misc/OutputDevice.h"

class FOutputDeviceRedirector final : public FOutputDevice {
public:
    CORE_API FOutputDeviceRedirector();
    CORE_API ~FOutputDeviceRedirector() override;
    static CORE_API FOutputDeviceRedirector* Get();

    CORE_API void AddOutputDevice(FOutputDevice* OutputDevice);
    CORE_API void RemoveOutputDevice(FOutputDevice* OutputDevice);
    CORE_API bool IsRedirectingTo(FOutputDevice* OutputDevice);
    CORE_API void Serialize(const TCHAR* Data, ELogVerbosity::Type Verbosity, const FName& Category) override;
    CORE_API void Serialize(
        const TCHAR* Data, ELogVerbosity::Type Verbosity, const FName& Category, const double Time) override;
    CORE_API void Flush() override;
    void FlushThreadedLogs() {}
    void SetCurrentThreadAsPrimaryThread() {}
    /** Flushes and forgets all devices. */
    CORE_API void TearDown() override;
    bool CanBeUsedOnAnyThread() const override { return true; }
    bool CanBeUsedOnMultipleThreads() const override { return true; }

private:
    struct FImpl;
    FImpl* Impl;
};

/** The one that is there from the start: lines to stderr, with the time and frame number in front. */
class FOutputDeviceStdErr final : public FOutputDevice {
public:
    static CORE_API FOutputDeviceStdErr& Get();
    CORE_API void Serialize(const TCHAR* V, ELogVerbosity::Type Verbosity, const FName& Category) override;
    using FOutputDevice::Serialize;
    bool CanBeUsedOnAnyThread() const override { return true; }
    /** Lines less important than that are not written. */
    void SetMaxVerbosity(ELogVerbosity::Type Verbosity) { MaxVerbosity = Verbosity; }

private:
    ELogVerbosity::Type MaxVerbosity = ELogVerbosity::All;
};

/** Lines to a file, which is truncated when it is opened. */
class FOutputDeviceFile final : public FOutputDevice {
public:
    explicit CORE_API FOutputDeviceFile(const TCHAR* InFilename);
    CORE_API ~FOutputDeviceFile() override;
    CORE_API void Serialize(const TCHAR* V, ELogVerbosity::Type Verbosity, const FName& Category) override;
    using FOutputDevice::Serialize;
    CORE_API void Flush() override;
    CORE_API void TearDown() override;
    bool IsOpened() const { return Handle != nullptr; }
    const TCHAR* GetFilename() const { return *Filename; }
    bool CanBeUsedOnAnyThread() const override { return true; }

private:
    FString Filename;
    void* Handle;
};
