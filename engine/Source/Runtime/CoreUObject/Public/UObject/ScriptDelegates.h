// SPDX-License-Identifier: MIT
// Dynamic delegates: bound by object and function name, called through ProcessEvent. Mirrors Epic's
// "UObject/ScriptDelegates.h" and the DECLARE_DYNAMIC_* half of "Delegates/DelegateCombinations.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/WeakObjectPtrTemplates.h"

/** A weakly held object and the name of one of its functions; the value of an FDelegateProperty. */
class FScriptDelegate {
public:
    using UnicastDelegateType = FScriptDelegate;

    FScriptDelegate() = default;

    void BindUFunction(UObject* InObject, const FName& InFunctionName) {
        Object = InObject;
        FunctionName = InFunctionName;
    }
    /** True if the object is alive and has the function. */
    COREUOBJECT_API bool IsBound() const;
    bool IsBoundToObject(void const* InUserObject) const { return InUserObject && InUserObject == GetUObject(); }
    bool IsBoundToObjectEvenIfUnreachable(void const* InUserObject) const {
        return InUserObject && InUserObject == GetUObjectEvenIfUnreachable();
    }
    /** True if the object is gone, so that the delegate can be dropped from a list. */
    bool IsCompactable() const { return FunctionName.IsNone() || !Object.Get(true); }
    void Unbind() {
        Object = nullptr;
        FunctionName = NAME_None;
    }
    void Clear() { Unbind(); }
    /** "Path.Function" or "<Unbound>". */
    COREUOBJECT_API FString ToString() const;
    template <class UObjectTemplate>
    FString ToString() const {
        return ToString();
    }
    UObject* GetUObject() { return Object.Get(); }
    const UObject* GetUObject() const { return Object.Get(); }
    UObject* GetUObjectEvenIfUnreachable() { return Object.GetEvenIfUnreachable(); }
    const UObject* GetUObjectEvenIfUnreachable() const { return Object.GetEvenIfUnreachable(); }
    TWeakObjectPtr<UObject>& GetUObjectRef() { return Object; }
    FName GetFunctionName() const { return FunctionName; }
    /** Calls the function with a parameter block; the delegate must be bound. */
    COREUOBJECT_API void ProcessDelegate(void* Parameters) const;
    template <class UObjectTemplate>
    void ProcessDelegate(void* Parameters) const {
        ProcessDelegate(Parameters);
    }
    bool operator==(const FScriptDelegate& Other) const {
        return FunctionName == Other.FunctionName && Object.HasSameIndexAndSerialNumber(Other.Object);
    }
    friend uint32 GetTypeHash(const FScriptDelegate& Delegate) {
        return HashCombine(GetTypeHash(Delegate.Object), GetTypeHash(Delegate.FunctionName));
    }

protected:
    TWeakObjectPtr<UObject> Object;
    FName FunctionName;
};

/** A list of script delegates; the value of an FMulticastInlineDelegateProperty. */
class FMulticastScriptDelegate {
public:
    using UnicastDelegateType = FScriptDelegate;
    using InvocationListType = TArray<FScriptDelegate>;

    /** True if at least one delegate is bound to a living object. */
    COREUOBJECT_API bool IsBound() const;
    bool Contains(const FScriptDelegate& InDelegate) const { return InvocationList.Contains(InDelegate); }
    COREUOBJECT_API bool Contains(const UObject* InObject, FName InFunctionName) const;
    /** Adds a delegate that is not yet in the list. */
    COREUOBJECT_API void Add(const FScriptDelegate& InDelegate);
    /** Adds a delegate unless the list has it. */
    COREUOBJECT_API void AddUnique(const FScriptDelegate& InDelegate);
    COREUOBJECT_API void Remove(const FScriptDelegate& InDelegate);
    COREUOBJECT_API void Remove(const UObject* InObject, FName InFunctionName);
    COREUOBJECT_API void RemoveAll(const UObject* Object);
    void Clear() { InvocationList.Empty(); }
    /** Compares lists regardless of order. */
    COREUOBJECT_API bool operator==(const FMulticastScriptDelegate& Other) const;
    /** "[Path.Function, ...]" */
    COREUOBJECT_API FString ToString() const;
    template <class UObjectTemplate>
    FString ToString() const {
        return ToString();
    }
    /** Calls all delegates that are bound when their turn comes; the list may change meanwhile. */
    COREUOBJECT_API void ProcessMulticastDelegate(void* Parameters) const;
    template <class UObjectTemplate>
    void ProcessMulticastDelegate(void* Parameters) const {
        ProcessMulticastDelegate(Parameters);
    }
    COREUOBJECT_API TArray<UObject*> GetAllObjects() const;
    const InvocationListType& GetInvocationList() const { return InvocationList; }

protected:
    void CompactInvocationList() const;
    mutable InvocationListType InvocationList;
};

namespace UE::CoreUObject::Private {
/**
 * The parameter block of a call, laid out like the struct `{ Params...; RetVal; }` that reflection uses: values in
 * order, each at its natural alignment.
 */
template <typename RetVal, typename... Params>
class TScriptParameters {
    template <typename T>
    using TValue = std::remove_cv_t<std::remove_reference_t<T>>;
    using FReturn = std::conditional_t<std::is_void_v<RetVal>, uint8, TValue<RetVal>>;
    static constexpr int32 NumParams = sizeof...(Params);

    static constexpr SIZE_T AlignUp(SIZE_T Offset, SIZE_T Alignment) {
        return (Offset + Alignment - 1) & ~(Alignment - 1);
    }
    struct FOffsets {
        SIZE_T Values[NumParams + 1];
        SIZE_T Size;
        SIZE_T Alignment;
    };
    static constexpr FOffsets ComputeOffsets() {
        FOffsets Result{};
        Result.Alignment = 1;
        SIZE_T Offset = 0;
        int32 Index = 0;
        const SIZE_T Sizes[] = {sizeof(TValue<Params>)..., std::is_void_v<RetVal> ? 0 : sizeof(FReturn)};
        const SIZE_T Alignments[] = {alignof(TValue<Params>)..., alignof(FReturn)};
        for (; Index <= NumParams; ++Index) {
            Offset = AlignUp(Offset, Alignments[Index]);
            Result.Values[Index] = Offset;
            Offset += Sizes[Index];
            Result.Alignment = Result.Alignment > Alignments[Index] ? Result.Alignment : Alignments[Index];
        }
        Result.Size = Offset > 0 ? AlignUp(Offset, Result.Alignment) : 1;
        return Result;
    }
    static constexpr FOffsets Offsets = ComputeOffsets();

public:
    explicit TScriptParameters(const TValue<Params>&... Arguments) {
        Construct(std::index_sequence_for<Params...>(), Arguments...);
        if constexpr (!std::is_void_v<RetVal>) {
            new (Memory + Offsets.Values[NumParams]) FReturn();
        }
    }
    ~TScriptParameters() {
        Destroy(std::index_sequence_for<Params...>());
        if constexpr (!std::is_void_v<RetVal>) {
            ReturnValue().~FReturn();
        }
    }
    void* GetData() { return Memory; }
    FReturn& ReturnValue() { return *reinterpret_cast<FReturn*>(Memory + Offsets.Values[NumParams]); }
    /** Copies values back into arguments that are references to non-const. */
    template <typename... Arguments>
    void CopyOut(Arguments&... OutArguments) {
        CopyOutImpl(std::index_sequence_for<Params...>(), OutArguments...);
    }

private:
    template <typename T>
    T& At(SIZE_T Index) {
        return *reinterpret_cast<T*>(Memory + Offsets.Values[Index]);
    }
    template <SIZE_T... Indices>
    void Construct(std::index_sequence<Indices...>, const TValue<Params>&... Arguments) {
        (new (Memory + Offsets.Values[Indices]) TValue<Params>(Arguments), ...);
    }
    template <SIZE_T... Indices>
    void Destroy(std::index_sequence<Indices...>) {
        (DestroyOne(At<TValue<Params>>(Indices)), ...);
    }
    template <typename T>
    static void DestroyOne(T& Value) {
        Value.~T();
    }
    template <SIZE_T... Indices, typename... Arguments>
    void CopyOutImpl(std::index_sequence<Indices...>, Arguments&... OutArguments) {
        (CopyOutOne<Params>(At<TValue<Params>>(Indices), OutArguments), ...);
    }
    template <typename Param, typename Value, typename Argument>
    static void CopyOutOne(Value& From, Argument& To) {
        if constexpr (std::is_lvalue_reference_v<Param> && !std::is_const_v<std::remove_reference_t<Param>>) {
            To = From;
        }
    }
    alignas(Offsets.Alignment) uint8 Memory[Offsets.Size] = {};
};
} // namespace UE::CoreUObject::Private

/** Base of the classes that DECLARE_DYNAMIC_DELEGATE* makes. */
template <typename RetVal, typename... ParamTypes>
class TBaseDynamicDelegate : public FScriptDelegate {
public:
    template <class UserClass>
    using TMethodPtr = RetVal (UserClass::*)(ParamTypes...);

    TBaseDynamicDelegate() = default;
    explicit TBaseDynamicDelegate(const FScriptDelegate& InDelegate) : FScriptDelegate(InDelegate) {}

    /** Use the macro BindDynamic. */
    template <class UserClass>
    void __Internal_BindDynamic(
        UserClass* InUserObject, TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) {
        check(InUserObject != nullptr && InMethodPtr != nullptr);
        BindUFunction(InUserObject, InFunctionName);
        ensureMsgf(IsBound(), TEXT("BindDynamic: %s is not a UFUNCTION"), *InFunctionName.ToString());
    }
    template <class UserClass>
    void __Internal_BindDynamic(const TObjectPtr<UserClass>& InUserObject,
        TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) {
        __Internal_BindDynamic(InUserObject.Get(), InMethodPtr, InFunctionName);
    }
    /** Calls the function; the delegate must be bound. */
    RetVal Execute(ParamTypes... Params) const {
        UE::CoreUObject::Private::TScriptParameters<RetVal, ParamTypes...> Parameters(Params...);
        ProcessDelegate(Parameters.GetData());
        Parameters.CopyOut(Params...);
        if constexpr (!std::is_void_v<RetVal>) {
            return Parameters.ReturnValue();
        }
    }
    /** Calls the function if the delegate is bound. Only delegates without a return value have it. */
    bool ExecuteIfBound(ParamTypes... Params) const
        requires std::is_void_v<RetVal>
    {
        if (!IsBound()) {
            return false;
        }
        UE::CoreUObject::Private::TScriptParameters<RetVal, ParamTypes...> Parameters(Params...);
        ProcessDelegate(Parameters.GetData());
        Parameters.CopyOut(Params...);
        return true;
    }
};

/** Base of the classes that DECLARE_DYNAMIC_MULTICAST_DELEGATE* makes. */
template <typename RetVal, typename... ParamTypes>
class TBaseDynamicMulticastDelegate : public FMulticastScriptDelegate {
    static_assert(std::is_void_v<RetVal>, "Multicast delegates have no return value.");

public:
    using FDelegate = TBaseDynamicDelegate<RetVal, ParamTypes...>;
    template <class UserClass>
    using TMethodPtr = RetVal (UserClass::*)(ParamTypes...);

    TBaseDynamicMulticastDelegate() = default;
    explicit TBaseDynamicMulticastDelegate(const FMulticastScriptDelegate& InDelegate)
        : FMulticastScriptDelegate(InDelegate) {}

    template <class UserClass>
    bool __Internal_IsAlreadyBound(
        UserClass* InUserObject, TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) const {
        return Contains(InUserObject, InFunctionName);
    }
    template <class UserClass>
    void __Internal_AddDynamic(
        UserClass* InUserObject, TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) {
        FDelegate NewDelegate;
        NewDelegate.__Internal_BindDynamic(InUserObject, InMethodPtr, InFunctionName);
        Add(NewDelegate);
    }
    template <class UserClass>
    void __Internal_AddUniqueDynamic(
        UserClass* InUserObject, TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) {
        FDelegate NewDelegate;
        NewDelegate.__Internal_BindDynamic(InUserObject, InMethodPtr, InFunctionName);
        AddUnique(NewDelegate);
    }
    template <class UserClass>
    void __Internal_RemoveDynamic(
        UserClass* InUserObject, TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) {
        Remove(InUserObject, InFunctionName);
    }
    template <class UserClass>
    void __Internal_AddDynamic(const TObjectPtr<UserClass>& InUserObject,
        TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) {
        __Internal_AddDynamic(InUserObject.Get(), InMethodPtr, InFunctionName);
    }
    template <class UserClass>
    void __Internal_AddUniqueDynamic(const TObjectPtr<UserClass>& InUserObject,
        TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) {
        __Internal_AddUniqueDynamic(InUserObject.Get(), InMethodPtr, InFunctionName);
    }
    template <class UserClass>
    void __Internal_RemoveDynamic(const TObjectPtr<UserClass>& InUserObject,
        TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr, FName InFunctionName) {
        __Internal_RemoveDynamic(InUserObject.Get(), InMethodPtr, InFunctionName);
    }
    /** Calls all bound functions. */
    void Broadcast(ParamTypes... Params) const {
        if (!InvocationList.IsEmpty()) {
            UE::CoreUObject::Private::TScriptParameters<RetVal, ParamTypes...> Parameters(Params...);
            ProcessMulticastDelegate(Parameters.GetData());
            Parameters.CopyOut(Params...);
        }
    }
};

namespace UE::CoreUObject::Private {
/** "&AFoo::Bar" as the name "Bar". */
COREUOBJECT_API FName FunctionNameOfExpression(const TCHAR* Expression);
} // namespace UE::CoreUObject::Private
#define STATIC_FUNCTION_FNAME(Expression) UE::CoreUObject::Private::FunctionNameOfExpression(Expression)

/** Binds a UFUNCTION: `Delegate.BindDynamic(this, &AFoo::Bar)`. */
#define BindDynamic(UserObject, FuncName)                                                                              \
    __Internal_BindDynamic(UserObject, FuncName, STATIC_FUNCTION_FNAME(TEXT(#FuncName)))
/** Adds a UFUNCTION to a multicast delegate. */
#define AddDynamic(UserObject, FuncName)                                                                               \
    __Internal_AddDynamic(UserObject, FuncName, STATIC_FUNCTION_FNAME(TEXT(#FuncName)))
#define AddUniqueDynamic(UserObject, FuncName)                                                                         \
    __Internal_AddUniqueDynamic(UserObject, FuncName, STATIC_FUNCTION_FNAME(TEXT(#FuncName)))
#define RemoveDynamic(UserObject, FuncName)                                                                            \
    __Internal_RemoveDynamic(UserObject, FuncName, STATIC_FUNCTION_FNAME(TEXT(#FuncName)))
#define IsAlreadyBound(UserObject, FuncName)                                                                           \
    __Internal_IsAlreadyBound(UserObject, FuncName, STATIC_FUNCTION_FNAME(TEXT(#FuncName)))

#define UE_DYNAMIC_DELEGATE(DelegateName, ...)                                                                         \
    class DelegateName : public TBaseDynamicDelegate<__VA_ARGS__> {                                                    \
    public:                                                                                                            \
        using TBaseDynamicDelegate<__VA_ARGS__>::TBaseDynamicDelegate;                                                 \
        DelegateName() = default;                                                                                      \
        explicit DelegateName(const FScriptDelegate& InDelegate) : TBaseDynamicDelegate<__VA_ARGS__>(InDelegate) {}    \
    };
#define UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, ...)                                                               \
    class DelegateName : public TBaseDynamicMulticastDelegate<__VA_ARGS__> {                                           \
    public:                                                                                                            \
        DelegateName() = default;                                                                                      \
        explicit DelegateName(const FMulticastScriptDelegate& InDelegate)                                              \
            : TBaseDynamicMulticastDelegate<__VA_ARGS__>(InDelegate) {}                                                \
    };

#define DECLARE_DYNAMIC_DELEGATE(DelegateName) UE_DYNAMIC_DELEGATE(DelegateName, void)
#define DECLARE_DYNAMIC_DELEGATE_OneParam(DelegateName, Param1Type, Param1Name)                                        \
    UE_DYNAMIC_DELEGATE(DelegateName, void, Param1Type)
#define DECLARE_DYNAMIC_DELEGATE_TwoParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name)               \
    UE_DYNAMIC_DELEGATE(DelegateName, void, Param1Type, Param2Type)
#define DECLARE_DYNAMIC_DELEGATE_ThreeParams(                                                                          \
    DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name)                              \
    UE_DYNAMIC_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type)
#define DECLARE_DYNAMIC_DELEGATE_FourParams(                                                                           \
    DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name, Param4Type, Param4Name)      \
    UE_DYNAMIC_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type)
#define DECLARE_DYNAMIC_DELEGATE_FiveParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type,  \
    Param3Name, Param4Type, Param4Name, Param5Type, Param5Name)                                                        \
    UE_DYNAMIC_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type)
#define DECLARE_DYNAMIC_DELEGATE_SixParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type,   \
    Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name)                                \
    UE_DYNAMIC_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type, Param6Type)
#define DECLARE_DYNAMIC_DELEGATE_SevenParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, \
    Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name, Param7Type, Param7Name)        \
    UE_DYNAMIC_DELEGATE(                                                                                               \
        DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type, Param6Type, Param7Type)
#define DECLARE_DYNAMIC_DELEGATE_EightParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, \
    Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name, Param7Type, Param7Name,        \
    Param8Type, Param8Name)                                                                                            \
    UE_DYNAMIC_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type, Param6Type,    \
        Param7Type, Param8Type)
#define DECLARE_DYNAMIC_DELEGATE_NineParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type,  \
    Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name, Param7Type, Param7Name,        \
    Param8Type, Param8Name, Param9Type, Param9Name)                                                                    \
    UE_DYNAMIC_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type, Param6Type,    \
        Param7Type, Param8Type, Param9Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal(ReturnValueType, DelegateName)                                                 \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_OneParam(ReturnValueType, DelegateName, Param1Type, Param1Name)                \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType, Param1Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_TwoParams(                                                                     \
    ReturnValueType, DelegateName, Param1Type, Param1Name, Param2Type, Param2Name)                                     \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType, Param1Type, Param2Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_ThreeParams(                                                                   \
    ReturnValueType, DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name)             \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType, Param1Type, Param2Type, Param3Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_FourParams(ReturnValueType, DelegateName, Param1Type, Param1Name, Param2Type,  \
    Param2Name, Param3Type, Param3Name, Param4Type, Param4Name)                                                        \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType, Param1Type, Param2Type, Param3Type, Param4Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_FiveParams(ReturnValueType, DelegateName, Param1Type, Param1Name, Param2Type,  \
    Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name)                                \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_SixParams(ReturnValueType, DelegateName, Param1Type, Param1Name, Param2Type,   \
    Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name)        \
    UE_DYNAMIC_DELEGATE(                                                                                               \
        DelegateName, ReturnValueType, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type, Param6Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_SevenParams(ReturnValueType, DelegateName, Param1Type, Param1Name, Param2Type, \
    Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name,        \
    Param7Type, Param7Name)                                                                                            \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type,     \
        Param6Type, Param7Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_EightParams(ReturnValueType, DelegateName, Param1Type, Param1Name, Param2Type, \
    Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name,        \
    Param7Type, Param7Name, Param8Type, Param8Name)                                                                    \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type,     \
        Param6Type, Param7Type, Param8Type)
#define DECLARE_DYNAMIC_DELEGATE_RetVal_NineParams(ReturnValueType, DelegateName, Param1Type, Param1Name, Param2Type,  \
    Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name,        \
    Param7Type, Param7Name, Param8Type, Param8Name, Param9Type, Param9Name)                                            \
    UE_DYNAMIC_DELEGATE(DelegateName, ReturnValueType, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type,     \
        Param6Type, Param7Type, Param8Type, Param9Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE(DelegateName) UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, void)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(DelegateName, Param1Type, Param1Name)                              \
    UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, void, Param1Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name)     \
    UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, void, Param1Type, Param2Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_ThreeParams(                                                                \
    DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name)                              \
    UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_FourParams(                                                                 \
    DelegateName, Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name, Param4Type, Param4Name)      \
    UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_FiveParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name,    \
    Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name)                                            \
    UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_SixParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name,     \
    Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name)                    \
    UE_DYNAMIC_MULTICAST_DELEGATE(                                                                                     \
        DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type, Param6Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_SevenParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name,   \
    Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name, Param7Type,        \
    Param7Name)                                                                                                        \
    UE_DYNAMIC_MULTICAST_DELEGATE(                                                                                     \
        DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type, Param6Type, Param7Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_EightParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name,   \
    Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name, Param7Type,        \
    Param7Name, Param8Type, Param8Name)                                                                                \
    UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type,      \
        Param6Type, Param7Type, Param8Type)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_NineParams(DelegateName, Param1Type, Param1Name, Param2Type, Param2Name,    \
    Param3Type, Param3Name, Param4Type, Param4Name, Param5Type, Param5Name, Param6Type, Param6Name, Param7Type,        \
    Param7Name, Param8Type, Param8Name, Param9Type, Param9Name)                                                        \
    UE_DYNAMIC_MULTICAST_DELEGATE(DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type, Param5Type,      \
        Param6Type, Param7Type, Param8Type, Param9Type)
