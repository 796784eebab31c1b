// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "HAL/CriticalSection.h"
#include "HAL/IConsoleManager.h"

/** The console manager. Objects that leave it stay allocated, since others may hold pointers to them. */
class FConsoleManager final : public IConsoleManager {
public:
    IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, bool DefaultValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, int32 DefaultValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, float DefaultValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, const TCHAR* DefaultValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, const FString& DefaultValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleVariable* RegisterConsoleVariableRef(
        const TCHAR* Name, bool& RefValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleVariable* RegisterConsoleVariableRef(
        const TCHAR* Name, int32& RefValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleVariable* RegisterConsoleVariableRef(
        const TCHAR* Name, float& RefValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleVariable* RegisterConsoleVariableRef(
        const TCHAR* Name, FString& RefValue, const TCHAR* Help, uint32 Flags) override;
    IConsoleCommand* RegisterConsoleCommand(
        const TCHAR* Name, const TCHAR* Help, const FConsoleCommandDelegate& Command, uint32 Flags) override;
    IConsoleCommand* RegisterConsoleCommand(
        const TCHAR* Name, const TCHAR* Help, const FConsoleCommandWithArgsDelegate& Command, uint32 Flags) override;
    IConsoleCommand* RegisterConsoleCommand(
        const TCHAR* Name, const TCHAR* Help, const FConsoleCommandWithWorldDelegate& Command, uint32 Flags) override;
    IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
        const FConsoleCommandWithWorldAndArgsDelegate& Command, uint32 Flags) override;
    IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
        const FConsoleCommandWithWorldArgsAndOutputDeviceDelegate& Command, uint32 Flags) override;
    IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
        const FConsoleCommandWithOutputDeviceDelegate& Command, uint32 Flags) override;
    void UnregisterConsoleObject(IConsoleObject* Object, bool bKeepState) override;
    void UnregisterConsoleObject(const TCHAR* Name, bool bKeepState) override;
    IConsoleObject* FindConsoleObject(const TCHAR* Name, bool bTrackFrequentCalls) const override;
    IConsoleVariable* FindConsoleVariable(const TCHAR* Name, bool bTrackFrequentCalls) const override;
    FString FindConsoleObjectName(const IConsoleObject* Object) const override;
    void ForEachConsoleObjectThatStartsWith(
        const FConsoleObjectVisitor& Visitor, const TCHAR* ThatStartsWith) const override;
    void ForEachConsoleObjectThatContains(
        const FConsoleObjectVisitor& Visitor, const TCHAR* ThatContains) const override;
    bool ProcessUserConsoleInput(const TCHAR* InInput, FOutputDevice& Ar, UWorld* InWorld) override;
    void CallAllConsoleVariableSinks() override;
    FDelegateHandle RegisterConsoleVariableSink_Handle(const FConsoleCommandDelegate& Command) override;
    void UnregisterConsoleVariableSink_Handle(FDelegateHandle Handle) override;

    /** A variable changed: the sinks are to be called. */
    void NoteChange() { bCallSinks.store(true); }

private:
    IConsoleObject* AddObject(const TCHAR* Name, IConsoleObject* Object);
    void Visit(const FConsoleObjectVisitor& Visitor, TFunctionRef<bool(const FString&)> Matches) const;

    mutable FCriticalSection CriticalSection;
    TMap<FString, IConsoleObject*> Objects;
    TArray<IConsoleObject*> Graveyard;
    TArray<FConsoleCommandDelegate> Sinks;
    std::atomic<bool> bCallSinks{false};
};
