// SPDX-License-Identifier: MIT
/** FExec: something that can run a console command; FSelfRegisteringExec: one that the engine asks by itself. */
#pragma once

#include "CoreMinimal.h"

class UWorld;
class FOutputDevice;

class FExec {
public:
    virtual ~FExec() = default;
    /** True if it was a command of this object. */
    virtual bool Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar) = 0;
};

class FSelfRegisteringExec : public FExec {
public:
    CORE_API FSelfRegisteringExec();
    CORE_API ~FSelfRegisteringExec() override;
    UE_NONCOPYABLE(FSelfRegisteringExec)
    /** Asks all of them until one says yes. */
    static CORE_API bool StaticExec(UWorld* Inworld, const TCHAR* Cmd, FOutputDevice& Ar);
};

/** A function as a self-registering exec. */
class FStaticSelfRegisteringExec : public FSelfRegisteringExec {
public:
    using FFunction = bool(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar);
    explicit FStaticSelfRegisteringExec(FFunction* InStaticExecFunc) : StaticExecFunc(InStaticExecFunc) {}
    bool Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar) override {
        return StaticExecFunc(InWorld, Cmd, Ar);
    }

private:
    FFunction* StaticExecFunc;
};
