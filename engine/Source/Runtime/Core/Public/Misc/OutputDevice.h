// SPDX-License-Identifier: MIT
/** FOutputDevice: something that takes log lines. */
#pragma once

#include "Logging/LogVerbosity.h"
#include "UObject/NameTypes.h"

class FOutputDevice {
public:
    FOutputDevice() = default;
    virtual ~FOutputDevice() = default;
    FOutputDevice(const FOutputDevice&) = default;
    FOutputDevice& operator=(const FOutputDevice&) = default;

    virtual void Serialize(const TCHAR* V, ELogVerbosity::Type Verbosity, const FName& Category) = 0;
    /** Time in seconds since the start, or -1 if unknown. */
    virtual void Serialize(
        const TCHAR* V, ELogVerbosity::Type Verbosity, const FName& Category, const double /*Time*/) {
        Serialize(V, Verbosity, Category);
    }
    virtual void Flush() {}
    virtual void TearDown() {}
    virtual bool CanBeUsedOnAnyThread() const { return false; }
    virtual bool CanBeUsedOnMultipleThreads() const { return false; }

    void Log(const TCHAR* S) { Serialize(S, ELogVerbosity::Log, FName(TEXT("LogOutputDevice"))); }
    void Log(const FString& S) { Log(*S); }
    void Log(ELogVerbosity::Type Verbosity, const TCHAR* S) { Serialize(S, Verbosity, FName(TEXT("LogOutputDevice"))); }
    void Log(ELogVerbosity::Type Verbosity, const FString& S) { Log(Verbosity, *S); }
    void Log(const FName& Category, ELogVerbosity::Type Verbosity, const FString& S) {
        Serialize(*S, Verbosity, Category);
    }

    template <typename FmtType, typename... Types>
        requires std::is_convertible_v<const FmtType&, const TCHAR*>
    void Logf(const FmtType& Fmt, Types... Args) {
        Log(FString::Printf(Fmt, Args...));
    }
    template <typename FmtType, typename... Types>
    void Logf(ELogVerbosity::Type Verbosity, const FmtType& Fmt, Types... Args) {
        Log(Verbosity, FString::Printf(Fmt, Args...));
    }
    template <typename FmtType, typename... Types>
    void CategorizedLogf(const FName& Category, ELogVerbosity::Type Verbosity, const FmtType& Fmt, Types... Args) {
        Log(Category, Verbosity, FString::Printf(Fmt, Args...));
    }
    void SetSuppressEventTag(bool bInSuppressEventTag) { bSuppressEventTag = bInSuppressEventTag; }
    bool GetSuppressEventTag() const { return bSuppressEventTag; }
    void SetAutoEmitLineTerminator(bool bInAuto) { bAutoEmitLineTerminator = bInAuto; }
    bool GetAutoEmitLineTerminator() const { return bAutoEmitLineTerminator; }

protected:
    bool bSuppressEventTag = false;
    bool bAutoEmitLineTerminator = true;
};

/** Takes everything and does nothing. */
class FOutputDeviceNull : public FOutputDevice {
public:
    void Serialize(const TCHAR*, ELogVerbosity::Type, const FName&) override {}
    using FOutputDevice::Serialize;
};
