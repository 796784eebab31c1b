// SPDX-License-Identifier: MIT
#include "HAL/ConsoleManager.h"

#include "Misc/ScopeLock.h"

const TCHAR* GetConsoleVariableSetByName(EConsoleVariableFlags InSetBy) {
    static const TCHAR* const Names[] = {TEXT("Constructor"), TEXT("Scalability"), TEXT("GameSetting"),
        TEXT("ProjectSetting"), TEXT("SystemSettingsIni"), TEXT("PluginLowPriority"), TEXT("DeviceProfile"),
        TEXT("PluginHighPriority"), TEXT("GameOverride"), TEXT("ConsoleVariablesIni"), TEXT("Hotfix"), TEXT("Preview"),
        TEXT("Commandline"), TEXT("Code"), TEXT("Console")};
    const uint32 Index = (static_cast<uint32>(InSetBy) & static_cast<uint32>(ECVF_SetByMask)) >> 24;
    return Index < UE_ARRAY_COUNT(Names) ? Names[Index] : TEXT("<UNKNOWN>");
}

namespace {
/** What variables and commands share. */
template <typename Base>
class TConsoleObject : public Base {
public:
    TConsoleObject(const TCHAR* InHelp, uint32 InFlags) : Help(InHelp), Flags(InFlags) {}
    const TCHAR* GetHelp() const override { return *Help; }
    void SetHelp(const TCHAR* Value) override { Help = Value; }
    EConsoleVariableFlags GetFlags() const override { return static_cast<EConsoleVariableFlags>(Flags); }
    void SetFlags(const EConsoleVariableFlags Value) override { Flags = static_cast<uint32>(Value); }
    void ClearFlags(const EConsoleVariableFlags Value) override { Flags &= ~static_cast<uint32>(Value); }

protected:
    FString Help;
    uint32 Flags;
};

template <typename T>
T ParseAs(const TCHAR* Text) {
    if constexpr (std::is_same_v<T, FString>) {
        return FString(Text);
    } else if constexpr (std::is_same_v<T, bool>) {
        return FCString::ToBool(Text);
    } else {
        // Words for truth are numbers, too.
        if (FCString::Stricmp(Text, TEXT("true")) == 0) {
            return T(1);
        }
        if (FCString::Stricmp(Text, TEXT("false")) == 0) {
            return T(0);
        }
        if constexpr (std::is_same_v<T, int32>) {
            return FCString::Atoi(Text);
        } else {
            return FCString::Atof(Text);
        }
    }
}

template <typename T>
FString ToText(const T& Value) {
    if constexpr (std::is_same_v<T, float>) {
        return FString::Printf(TEXT("%.9g"), static_cast<double>(Value));
    } else {
        return LexToString(Value);
    }
}

/** A variable of the manager's own, or (Ref not null) over one of somebody else's. */
template <typename T>
class TConsoleVariable final : public TConsoleObject<IConsoleVariable> {
public:
    TConsoleVariable(T Default, T* InRef, const TCHAR* InHelp, uint32 InFlags)
        : TConsoleObject<IConsoleVariable>(InHelp, InFlags), Own(Default), DefaultText(ToText(Default)),
          Value(InRef ? InRef : &Own) {}

    using IConsoleVariable::Set;
    void Set(const TCHAR* InValue, EConsoleVariableFlags SetBy) override {
        const uint32 New = static_cast<uint32>(SetBy) & static_cast<uint32>(ECVF_SetByMask);
        const uint32 Old = Flags & static_cast<uint32>(ECVF_SetByMask);
        if (New < Old) {
            UE_LOG(LogConsoleManager, Warning,
                TEXT("Setting the console variable '%s' with 'SetBy%s' was ignored as it is lower priority than the "
                     "previous "
                     "'SetBy%s'. Value remains '%s'"),
                *IConsoleManager::Get().FindConsoleObjectName(this), GetConsoleVariableSetByName(SetBy),
                GetConsoleVariableSetByName(static_cast<EConsoleVariableFlags>(Old)), *GetString());
            return;
        }
        *Value = ParseAs<T>(InValue);
        Flags = (Flags & ~static_cast<uint32>(ECVF_SetByMask)) | New;
        if (!(static_cast<uint32>(SetBy) & static_cast<uint32>(ECVF_Set_NoSinkCall_Unsafe))) {
            static_cast<FConsoleManager&>(IConsoleManager::Get()).NoteChange();
            Callback.ExecuteIfBound(this);
            Changed.Broadcast(this);
        }
    }
    bool GetBool() const override {
        if constexpr (std::is_same_v<T, FString>) {
            return Value->ToBool();
        } else {
            return *Value != T(0);
        }
    }
    int32 GetInt() const override {
        if constexpr (std::is_same_v<T, FString>) {
            return FCString::Atoi(**Value);
        } else {
            return static_cast<int32>(*Value);
        }
    }
    float GetFloat() const override {
        if constexpr (std::is_same_v<T, FString>) {
            return FCString::Atof(**Value);
        } else {
            return static_cast<float>(*Value);
        }
    }
    FString GetString() const override { return ToText(*Value); }
    FString GetDefaultValue() override { return DefaultText; }
    void SetOnChangedCallback(const FConsoleVariableDelegate& InCallback) override { Callback = InCallback; }
    FConsoleVariableMulticastDelegate& OnChangedDelegate() override { return Changed; }
    bool IsVariableBool() const override { return std::is_same_v<T, bool>; }
    bool IsVariableInt() const override { return std::is_same_v<T, int32>; }
    bool IsVariableFloat() const override { return std::is_same_v<T, float>; }
    bool IsVariableString() const override { return std::is_same_v<T, FString>; }

private:
    T Own;
    FString DefaultText;
    T* Value;
    FConsoleVariableDelegate Callback;
    FConsoleVariableMulticastDelegate Changed;
};

/** A command; the function takes arguments, world and output. */
class FConsoleCommand final : public TConsoleObject<IConsoleCommand> {
public:
    using FFunction = TFunction<bool(const TArray<FString>&, UWorld*, FOutputDevice&)>;
    FConsoleCommand(const TCHAR* InHelp, uint32 InFlags, FFunction InFunction)
        : TConsoleObject<IConsoleCommand>(InHelp, InFlags), Function(MoveTemp(InFunction)) {}
    bool Execute(const TArray<FString>& Args, UWorld* InWorld, FOutputDevice& OutputDevice) override {
        const FFunction Copy(Function); // a command may unregister itself
        return Copy(Args, InWorld, OutputDevice);
    }

private:
    FFunction Function;
};

template <typename T>
IConsoleObject* MakeVariable(T Default, T* Ref, const TCHAR* Help, uint32 Flags) {
    return new TConsoleVariable<T>(Default, Ref, Help, Flags);
}
} // namespace

IConsoleManager& IConsoleManager::Get() {
    // Never destroyed: variables in static storage unregister themselves when the process ends.
    static FConsoleManager& Manager = *new FConsoleManager();
    return Manager;
}

IConsoleObject* FConsoleManager::AddObject(const TCHAR* Name, IConsoleObject* Object) {
    checkf(Name && *Name, TEXT("A console object needs a name"));
    FScopeLock Lock(&CriticalSection);
    const FString Key(Name);
    if (IConsoleObject** Found = Objects.Find(Key)) {
        IConsoleObject* Existing = *Found;
        IConsoleVariable* OldVariable = Existing->AsVariable();
        IConsoleVariable* NewVariable = Object->AsVariable();
        const bool bWasUnregistered = Existing->TestFlags(ECVF_Unregistered);
        checkf(!OldVariable == !NewVariable,
            TEXT("Console object '%s' can't be registered a second time as another kind of object"), Name);
        if (OldVariable && bWasUnregistered) {
            // The value survived its owner, with its priority.
            const uint32 SetBy = static_cast<uint32>(Existing->GetFlags()) & static_cast<uint32>(ECVF_SetByMask);
            NewVariable->Set(*OldVariable->GetString(), static_cast<EConsoleVariableFlags>(SetBy));
        } else if (OldVariable) {
            UE_LOG(LogConsoleManager, Warning,
                TEXT("Console variable '%s' is registered a second time; the first one stays"), Name);
            Existing->SetHelp(Object->GetHelp());
            delete Object;
            return Existing;
        }
        Graveyard.Add(Existing);
        *Found = Object;
        return Object;
    }
    Objects.Add(Key, Object);
    return Object;
}

#define UE_CONSOLE_REGISTER(Type)                                                                                      \
    IConsoleVariable* FConsoleManager::RegisterConsoleVariable(                                                        \
        const TCHAR* Name, Type DefaultValue, const TCHAR* Help, uint32 Flags) {                                       \
        return AddObject(Name, MakeVariable<Type>(DefaultValue, nullptr, Help, Flags))->AsVariable();                  \
    }
UE_CONSOLE_REGISTER(bool)
UE_CONSOLE_REGISTER(int32)
UE_CONSOLE_REGISTER(float)
#undef UE_CONSOLE_REGISTER

IConsoleVariable* FConsoleManager::RegisterConsoleVariable(
    const TCHAR* Name, const TCHAR* DefaultValue, const TCHAR* Help, uint32 Flags) {
    return AddObject(Name, MakeVariable<FString>(FString(DefaultValue), nullptr, Help, Flags))->AsVariable();
}

IConsoleVariable* FConsoleManager::RegisterConsoleVariable(
    const TCHAR* Name, const FString& DefaultValue, const TCHAR* Help, uint32 Flags) {
    return RegisterConsoleVariable(Name, *DefaultValue, Help, Flags);
}

#define UE_CONSOLE_REGISTER_REF(Type)                                                                                  \
    IConsoleVariable* FConsoleManager::RegisterConsoleVariableRef(                                                     \
        const TCHAR* Name, Type& RefValue, const TCHAR* Help, uint32 Flags) {                                          \
        return AddObject(Name, MakeVariable<Type>(RefValue, &RefValue, Help, Flags))->AsVariable();                    \
    }
UE_CONSOLE_REGISTER_REF(bool)
UE_CONSOLE_REGISTER_REF(int32)
UE_CONSOLE_REGISTER_REF(float)
UE_CONSOLE_REGISTER_REF(FString)
#undef UE_CONSOLE_REGISTER_REF

#define UE_CONSOLE_COMMAND(DelegateType, ...)                                                                          \
    IConsoleCommand* FConsoleManager::RegisterConsoleCommand(                                                          \
        const TCHAR* Name, const TCHAR* Help, const DelegateType& Command, uint32 Flags) {                             \
        return AddObject(Name, new FConsoleCommand(Help, Flags,                                                        \
                                   [Command](const TArray<FString>& Args, UWorld* World, FOutputDevice& Ar) {          \
                                       (void)Args;                                                                     \
                                       (void)World;                                                                    \
                                       (void)Ar;                                                                       \
                                       return Command.ExecuteIfBound(__VA_ARGS__);                                     \
                                   }))                                                                                 \
            ->AsCommand();                                                                                             \
    }
UE_CONSOLE_COMMAND(FConsoleCommandDelegate)
UE_CONSOLE_COMMAND(FConsoleCommandWithArgsDelegate, Args)
UE_CONSOLE_COMMAND(FConsoleCommandWithWorldDelegate, World)
UE_CONSOLE_COMMAND(FConsoleCommandWithWorldAndArgsDelegate, Args, World)
UE_CONSOLE_COMMAND(FConsoleCommandWithWorldArgsAndOutputDeviceDelegate, Args, World, Ar)
UE_CONSOLE_COMMAND(FConsoleCommandWithOutputDeviceDelegate, Ar)
#undef UE_CONSOLE_COMMAND

void FConsoleManager::UnregisterConsoleObject(IConsoleObject* Object, bool bKeepState) {
    if (!Object) {
        return;
    }
    FScopeLock Lock(&CriticalSection);
    const FString Name = FindConsoleObjectName(Object);
    if (Name.IsEmpty()) {
        return;
    }
    // A variable that keeps its state must not keep looking at its owner's memory.
    IConsoleVariable* Variable = Object->AsVariable();
    if (bKeepState && Variable) {
        IConsoleVariable* Kept = MakeVariable<FString>(Variable->GetString(), nullptr, Variable->GetHelp(),
            static_cast<uint32>(Variable->GetFlags()) | ECVF_Unregistered)
                                     ->AsVariable();
        Objects.Add(Name, Kept);
    } else {
        Objects.Remove(Name);
    }
    Graveyard.Add(Object);
}

void FConsoleManager::UnregisterConsoleObject(const TCHAR* Name, bool bKeepState) {
    UnregisterConsoleObject(FindConsoleObject(Name, false), bKeepState);
}

IConsoleObject* FConsoleManager::FindConsoleObject(const TCHAR* Name, bool) const {
    FScopeLock Lock(&CriticalSection);
    IConsoleObject* const* Found = Objects.Find(FString(Name));
    return Found && !(*Found)->TestFlags(ECVF_Unregistered) ? *Found : nullptr;
}

IConsoleVariable* FConsoleManager::FindConsoleVariable(const TCHAR* Name, bool bTrackFrequentCalls) const {
    IConsoleObject* Object = FindConsoleObject(Name, bTrackFrequentCalls);
    return Object ? Object->AsVariable() : nullptr;
}

FString FConsoleManager::FindConsoleObjectName(const IConsoleObject* Object) const {
    FScopeLock Lock(&CriticalSection);
    for (const auto& Pair : Objects) {
        if (Pair.Value == Object) {
            return Pair.Key;
        }
    }
    return FString();
}

void FConsoleManager::Visit(const FConsoleObjectVisitor& Visitor, TFunctionRef<bool(const FString&)> Matches) const {
    TArray<TPair<FString, IConsoleObject*>> Found;
    {
        FScopeLock Lock(&CriticalSection);
        for (const auto& Pair : Objects) {
            if (!Pair.Value->TestFlags(ECVF_Unregistered) && Matches(Pair.Key)) {
                Found.Emplace(Pair.Key, Pair.Value);
            }
        }
    }
    Found.Sort([](const auto& A, const auto& B) { return A.Key < B.Key; });
    for (const auto& Pair : Found) {
        Visitor.Execute(*Pair.Key, Pair.Value);
    }
}

void FConsoleManager::ForEachConsoleObjectThatStartsWith(
    const FConsoleObjectVisitor& Visitor, const TCHAR* ThatStartsWith) const {
    Visit(Visitor, [&](const FString& Name) { return Name.StartsWith(ThatStartsWith); });
}

void FConsoleManager::ForEachConsoleObjectThatContains(
    const FConsoleObjectVisitor& Visitor, const TCHAR* ThatContains) const {
    Visit(Visitor, [&](const FString& Name) { return Name.Contains(ThatContains); });
}

bool FConsoleManager::ProcessUserConsoleInput(const TCHAR* InInput, FOutputDevice& Ar, UWorld* InWorld) {
    const FString Input = FString(InInput).TrimStartAndEnd();
    int32 NameLength = 0;
    while (NameLength < Input.Len() && !FChar::IsWhitespace(Input[NameLength])) {
        ++NameLength;
    }
    FString Name = Input.Left(NameLength);
    FString Rest = Input.Mid(NameLength).TrimStart();
    bool bWantsHelp = Rest == TEXT("?");
    if (Name.Len() > 1 && Name.EndsWith(TEXT("?"))) {
        Name.LeftChopInline(1);
        bWantsHelp = true;
    }
    IConsoleObject* Object = Name.IsEmpty() ? nullptr : FindConsoleObject(*Name, false);
    if (!Object) {
        return false;
    }
    if (bWantsHelp) {
        Ar.Logf(TEXT("HELP for '%s': %s"), *Name, Object->GetHelp());
        if (IConsoleVariable* Variable = Object->AsVariable()) {
            Ar.Logf(TEXT("%s = \"%s\"      LastSetBy: %s"), *Name, *Variable->GetString(),
                GetConsoleVariableSetByName(Variable->GetFlags()));
        }
        return true;
    }
    if (IConsoleCommand* Command = Object->AsCommand()) {
        TArray<FString> Args;
        const TCHAR* Cursor = *Rest;
        for (FString Token; FParse::Token(Cursor, Token, false);) {
            Args.Add(Token);
        }
        return Command->Execute(Args, InWorld, Ar);
    }
    IConsoleVariable* Variable = Object->AsVariable();
    if (Rest.IsEmpty()) {
        Ar.Logf(TEXT("%s = \"%s\"      LastSetBy: %s"), *Name, *Variable->GetString(),
            GetConsoleVariableSetByName(Variable->GetFlags()));
    } else if (Variable->TestFlags(ECVF_ReadOnly)) {
        Ar.Logf(TEXT("Error: %s is read only!"), *Name);
    } else {
        if (Rest.Len() >= 2 && Rest.StartsWith(TEXT("\"")) && Rest.EndsWith(TEXT("\""))) {
            Rest = Rest.Mid(1, Rest.Len() - 2);
        }
        Variable->Set(*Rest, ECVF_SetByConsole);
        Ar.Logf(TEXT("%s = \"%s\""), *Name, *Variable->GetString());
    }
    return true;
}

void FConsoleManager::CallAllConsoleVariableSinks() {
    if (bCallSinks.exchange(false)) {
        const TArray<FConsoleCommandDelegate> Copy(Sinks);
        for (const FConsoleCommandDelegate& Sink : Copy) {
            Sink.ExecuteIfBound();
        }
    }
}

FDelegateHandle FConsoleManager::RegisterConsoleVariableSink_Handle(const FConsoleCommandDelegate& Command) {
    Sinks.Add(Command);
    return Sinks.Last().GetHandle();
}

void FConsoleManager::UnregisterConsoleVariableSink_Handle(FDelegateHandle Handle) {
    Sinks.RemoveAll([&](const FConsoleCommandDelegate& Sink) { return Sink.GetHandle() == Handle; });
}
