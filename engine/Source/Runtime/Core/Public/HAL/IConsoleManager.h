// SPDX-License-Identifier: MIT
/**
 * Console variables and commands. A variable remembers with which priority it was last set; a set of lower priority is
 * refused with a warning. Names are found without case. See Epic's "Console Variables in C++".
 */
#pragma once

#include "CoreMinimal.h"

class IConsoleCommand;
class IConsoleVariable;
class UWorld;

enum EConsoleVariableFlags : uint32 {
    ECVF_FlagMask = 0x0000ffff,
    ECVF_Default = 0x0,
    ECVF_Cheat = 0x1,
    ECVF_ReadOnly = 0x4,
    ECVF_Unregistered = 0x8,
    ECVF_CreatedFromIni = 0x10,
    ECVF_RenderThreadSafe = 0x20,
    ECVF_Scalability = 0x40,
    ECVF_ScalabilityGroup = 0x80,
    ECVF_Preview = 0x100,

    ECVF_SetFlagMask = 0x00ff0000,
    /** Do not call the change callbacks. */
    ECVF_Set_NoSinkCall_Unsafe = 0x00010000,

    ECVF_SetByMask = 0xff000000,
    // Who set the value, in ascending priority.
    ECVF_SetByConstructor = 0x00000000,
    ECVF_SetByScalability = 0x01000000,
    ECVF_SetByGameSetting = 0x02000000,
    ECVF_SetByProjectSetting = 0x03000000,
    ECVF_SetBySystemSettingsIni = 0x04000000,
    ECVF_SetByPluginLowPriority = 0x05000000,
    ECVF_SetByDeviceProfile = 0x06000000,
    ECVF_SetByPluginHighPriority = 0x07000000,
    ECVF_SetByGameOverride = 0x08000000,
    ECVF_SetByConsoleVariablesIni = 0x09000000,
    ECVF_SetByHotfix = 0x0A000000,
    ECVF_SetByPreview = 0x0B000000,
    ECVF_SetByCommandline = 0x0C000000,
    ECVF_SetByCode = 0x0D000000,
    ECVF_SetByConsole = 0x0E000000,
};
/** "Console", "Code", ...: who set a value. */
CORE_API const TCHAR* GetConsoleVariableSetByName(EConsoleVariableFlags InSetBy);

DECLARE_DELEGATE_OneParam(FConsoleVariableDelegate, IConsoleVariable*)
    DECLARE_MULTICAST_DELEGATE_OneParam(FConsoleVariableMulticastDelegate, IConsoleVariable*)
        DECLARE_DELEGATE(FConsoleCommandDelegate)
            DECLARE_DELEGATE_OneParam(FConsoleCommandWithArgsDelegate, const TArray<FString>&)
                DECLARE_DELEGATE_OneParam(FConsoleCommandWithWorldDelegate, UWorld*)
                    DECLARE_DELEGATE_TwoParams(FConsoleCommandWithWorldAndArgsDelegate, const TArray<FString>&, UWorld*)
                        DECLARE_DELEGATE_ThreeParams(FConsoleCommandWithWorldArgsAndOutputDeviceDelegate,
                            const TArray<FString>&, UWorld*, FOutputDevice&)
                            DECLARE_DELEGATE_OneParam(FConsoleCommandWithOutputDeviceDelegate, FOutputDevice&)
                                DECLARE_DELEGATE_TwoParams(FConsoleObjectVisitor, const TCHAR*, class IConsoleObject*)

                                    class IConsoleObject {
public:
    virtual ~IConsoleObject() = default;
    virtual const TCHAR* GetHelp() const = 0;
    virtual void SetHelp(const TCHAR* Value) = 0;
    virtual EConsoleVariableFlags GetFlags() const = 0;
    virtual void SetFlags(const EConsoleVariableFlags Value) = 0;
    virtual void ClearFlags(const EConsoleVariableFlags Value) = 0;
    bool TestFlags(const EConsoleVariableFlags Value) const {
        return (static_cast<uint32>(GetFlags()) & static_cast<uint32>(Value)) != 0;
    }
    virtual IConsoleVariable* AsVariable() { return nullptr; }
    virtual bool IsVariableBool() const { return false; }
    virtual bool IsVariableInt() const { return false; }
    virtual bool IsVariableFloat() const { return false; }
    virtual bool IsVariableString() const { return false; }
    virtual IConsoleCommand* AsCommand() { return nullptr; }
};

class IConsoleVariable : public IConsoleObject {
public:
    /** The value as text is converted to the variable's type. The priority is in SetBy. */
    virtual void Set(const TCHAR* InValue, EConsoleVariableFlags SetBy = ECVF_SetByCode) = 0;
    void Set(bool InValue, EConsoleVariableFlags SetBy = ECVF_SetByCode) {
        Set(InValue ? TEXT("1") : TEXT("0"), SetBy);
    }
    void Set(int32 InValue, EConsoleVariableFlags SetBy = ECVF_SetByCode) { Set(*FString::FromInt(InValue), SetBy); }
    void Set(float InValue, EConsoleVariableFlags SetBy = ECVF_SetByCode) {
        Set(*FString::Printf(TEXT("%.9g"), static_cast<double>(InValue)), SetBy);
    }
    /** With the priority the variable has now, so that it is never refused. */
    void SetWithCurrentPriority(bool InValue) { Set(InValue, CurrentPriority()); }
    void SetWithCurrentPriority(int32 InValue) { Set(InValue, CurrentPriority()); }
    void SetWithCurrentPriority(float InValue) { Set(InValue, CurrentPriority()); }
    void SetWithCurrentPriority(const TCHAR* InValue) { Set(InValue, CurrentPriority()); }
    virtual bool GetBool() const = 0;
    virtual int32 GetInt() const = 0;
    virtual float GetFloat() const = 0;
    virtual FString GetString() const = 0;
    virtual FString GetDefaultValue() = 0;
    virtual void SetOnChangedCallback(const FConsoleVariableDelegate& Callback) = 0;
    virtual FConsoleVariableMulticastDelegate& OnChangedDelegate() = 0;
    IConsoleVariable* AsVariable() override { return this; }

private:
    EConsoleVariableFlags CurrentPriority() const {
        return static_cast<EConsoleVariableFlags>(
            static_cast<uint32>(GetFlags()) & static_cast<uint32>(ECVF_SetByMask));
    }
};

class IConsoleCommand : public IConsoleObject {
public:
    virtual bool Execute(const TArray<FString>& Args, UWorld* InWorld, FOutputDevice& OutputDevice) = 0;
    IConsoleCommand* AsCommand() override { return this; }
};

class IConsoleManager {
public:
    static CORE_API IConsoleManager& Get();
    virtual ~IConsoleManager() = default;

    /** If a variable of that name exists, it gets the new help and keeps its value. */
    virtual IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, bool DefaultValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, int32 DefaultValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, float DefaultValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, const TCHAR* DefaultValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleVariable* RegisterConsoleVariable(
        const TCHAR* Name, const FString& DefaultValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    /** Over a variable of the caller, which must outlive the registration. */
    virtual IConsoleVariable* RegisterConsoleVariableRef(
        const TCHAR* Name, bool& RefValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleVariable* RegisterConsoleVariableRef(
        const TCHAR* Name, int32& RefValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleVariable* RegisterConsoleVariableRef(
        const TCHAR* Name, float& RefValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleVariable* RegisterConsoleVariableRef(
        const TCHAR* Name, FString& RefValue, const TCHAR* Help, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleCommand* RegisterConsoleCommand(
        const TCHAR* Name, const TCHAR* Help, const FConsoleCommandDelegate& Command, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
        const FConsoleCommandWithArgsDelegate& Command, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
        const FConsoleCommandWithWorldDelegate& Command, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
        const FConsoleCommandWithWorldAndArgsDelegate& Command, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
        const FConsoleCommandWithWorldArgsAndOutputDeviceDelegate& Command, uint32 Flags = ECVF_Default) = 0;
    virtual IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
        const FConsoleCommandWithOutputDeviceDelegate& Command, uint32 Flags = ECVF_Default) = 0;

    virtual void UnregisterConsoleObject(IConsoleObject* Object, bool bKeepState = false) = 0;
    virtual void UnregisterConsoleObject(const TCHAR* Name, bool bKeepState = false) = 0;
    virtual IConsoleObject* FindConsoleObject(const TCHAR* Name, bool bTrackFrequentCalls = true) const = 0;
    /** Null if there is no variable of that name. */
    virtual IConsoleVariable* FindConsoleVariable(const TCHAR* Name, bool bTrackFrequentCalls = true) const = 0;
    virtual FString FindConsoleObjectName(const IConsoleObject* Object) const = 0;
    bool IsNameRegistered(const TCHAR* Name) const { return FindConsoleObject(Name) != nullptr; }
    /** In alphabetical order. */
    virtual void ForEachConsoleObjectThatStartsWith(
        const FConsoleObjectVisitor& Visitor, const TCHAR* ThatStartsWith = TEXT("")) const = 0;
    virtual void ForEachConsoleObjectThatContains(
        const FConsoleObjectVisitor& Visitor, const TCHAR* ThatContains) const = 0;
    /** "name", "name ?", "name value" of variables; "name args" of commands. False if there is no such thing. */
    virtual bool ProcessUserConsoleInput(const TCHAR* InInput, FOutputDevice& Ar, UWorld* InWorld) = 0;
    /** Sinks are told once after a number of changes: the engine loop calls this each frame. */
    virtual void CallAllConsoleVariableSinks() = 0;
    virtual FDelegateHandle RegisterConsoleVariableSink_Handle(const FConsoleCommandDelegate& Command) = 0;
    virtual void UnregisterConsoleVariableSink_Handle(FDelegateHandle Handle) = 0;
};

/** Base of the static helpers: unregisters when it goes. */
class FAutoConsoleObject {
protected:
    explicit FAutoConsoleObject(IConsoleObject* InTarget) : Target(InTarget) { check(Target); }

public:
    virtual ~FAutoConsoleObject() { IConsoleManager::Get().UnregisterConsoleObject(Target, false); }
    UE_NONCOPYABLE(FAutoConsoleObject)
    IConsoleVariable* AsVariable() { return Target->AsVariable(); }
    const IConsoleVariable* AsVariable() const { return Target->AsVariable(); }

protected:
    IConsoleObject* Target;
};

class FAutoConsoleVariable : public FAutoConsoleObject {
public:
    template <typename T>
    FAutoConsoleVariable(const TCHAR* Name, T DefaultValue, const TCHAR* Help, uint32 Flags = ECVF_Default)
        : FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleVariable(Name, DefaultValue, Help, Flags)) {}
    template <typename T>
    FAutoConsoleVariable(const TCHAR* Name, T DefaultValue, const TCHAR* Help, const FConsoleVariableDelegate& Callback,
        uint32 Flags = ECVF_Default)
        : FAutoConsoleVariable(Name, DefaultValue, Help, Flags) {
        AsVariable()->SetOnChangedCallback(Callback);
    }
    IConsoleVariable* operator->() { return AsVariable(); }
    const IConsoleVariable* operator->() const { return AsVariable(); }
    IConsoleVariable& operator*() { return *AsVariable(); }
};

/** `static TAutoConsoleVariable<int32> CVarFoo(TEXT("foo.Bar"), 1, TEXT("Help"));` T is bool, int32, float or FString.
 */
template <class T>
class TAutoConsoleVariable : public FAutoConsoleVariable {
public:
    template <typename ValueType>
    TAutoConsoleVariable(
        const TCHAR* Name, const ValueType& DefaultValue, const TCHAR* Help, uint32 Flags = ECVF_Default)
        : FAutoConsoleVariable(Name, Convert(DefaultValue), Help, Flags) {}
    template <typename ValueType>
    TAutoConsoleVariable(const TCHAR* Name, const ValueType& DefaultValue, const TCHAR* Help,
        const FConsoleVariableDelegate& Callback, uint32 Flags = ECVF_Default)
        : FAutoConsoleVariable(Name, Convert(DefaultValue), Help, Callback, Flags) {}
    T GetValueOnGameThread() const { return GetValue(); }
    T GetValueOnRenderThread() const { return GetValue(); }
    T GetValueOnAnyThread(bool /*bForceGameThread*/ = false) const { return GetValue(); }

private:
    template <typename ValueType>
    static T Convert(const ValueType& Value) {
        return T(Value);
    }
    T GetValue() const {
        const IConsoleVariable* Variable = AsVariable();
        if constexpr (std::is_same_v<T, bool>) {
            return Variable->GetBool();
        } else if constexpr (std::is_same_v<T, int32>) {
            return Variable->GetInt();
        } else if constexpr (std::is_same_v<T, float>) {
            return Variable->GetFloat();
        } else {
            static_assert(std::is_same_v<T, FString>, "TAutoConsoleVariable is for bool, int32, float and FString");
            return Variable->GetString();
        }
    }
};

class FAutoConsoleVariableRef : public FAutoConsoleObject {
public:
    template <typename T>
    FAutoConsoleVariableRef(const TCHAR* Name, T& RefValue, const TCHAR* Help, uint32 Flags = ECVF_Default)
        : FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleVariableRef(Name, RefValue, Help, Flags)) {}
    template <typename T>
    FAutoConsoleVariableRef(const TCHAR* Name, T& RefValue, const TCHAR* Help, const FConsoleVariableDelegate& Callback,
        uint32 Flags = ECVF_Default)
        : FAutoConsoleVariableRef(Name, RefValue, Help, Flags) {
        AsVariable()->SetOnChangedCallback(Callback);
    }
    IConsoleVariable* operator->() { return AsVariable(); }
};

#define UE_AUTO_CONSOLE_COMMAND(ClassName, DelegateType)                                                               \
    class ClassName : private FAutoConsoleObject {                                                                     \
    public:                                                                                                            \
        ClassName(const TCHAR* Name, const TCHAR* Help, const DelegateType& Command, uint32 Flags = ECVF_Default)      \
            : FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleCommand(Name, Help, Command, Flags)) {}         \
        ClassName(const TCHAR* Name, const DelegateType& Command, uint32 Flags = ECVF_Default)                         \
            : ClassName(Name, TEXT(""), Command, Flags) {}                                                             \
    };
UE_AUTO_CONSOLE_COMMAND(FAutoConsoleCommand, FConsoleCommandDelegate)
UE_AUTO_CONSOLE_COMMAND(FAutoConsoleCommandWithArgs, FConsoleCommandWithArgsDelegate)
UE_AUTO_CONSOLE_COMMAND(FAutoConsoleCommandWithWorld, FConsoleCommandWithWorldDelegate)
UE_AUTO_CONSOLE_COMMAND(FAutoConsoleCommandWithWorldAndArgs, FConsoleCommandWithWorldAndArgsDelegate)
UE_AUTO_CONSOLE_COMMAND(
    FAutoConsoleCommandWithWorldArgsAndOutputDevice, FConsoleCommandWithWorldArgsAndOutputDeviceDelegate)
UE_AUTO_CONSOLE_COMMAND(FAutoConsoleCommandWithOutputDevice, FConsoleCommandWithOutputDeviceDelegate)
#undef UE_AUTO_CONSOLE_COMMAND
