// SPDX-License-Identifier: MIT
// Sparse dynamic delegates: one byte in the object, the list in a side table. Mirrors Epic's
// "UObject/SparseDelegate.h".
#pragma once

#include "UObject/ScriptDelegates.h"

/** The byte in the object: whether the side table has a list for it. */
struct FSparseDelegate {
    bool IsBound() const { return bIsBound; }

protected:
    friend class FMulticastSparseDelegateProperty;
    friend struct FSparseDelegateStorage;
    bool bIsBound = false;
};

/** Side table of sparse delegates, by owner and delegate name. Entries go when their owner is destroyed. */
struct FSparseDelegateStorage {
    static COREUOBJECT_API FMulticastScriptDelegate* GetMulticastDelegate(
        const UObject* DelegateOwner, FName DelegateName);
    /** The list, created if missing; marks Delegate as bound. */
    static COREUOBJECT_API FMulticastScriptDelegate& GetOrCreate(
        FSparseDelegate& Delegate, const UObject* DelegateOwner, FName DelegateName);
    /** Drops an empty list and marks the delegate as unbound. */
    static COREUOBJECT_API void Compact(FSparseDelegate& Delegate, const UObject* DelegateOwner, FName DelegateName);
    static COREUOBJECT_API void Clear(FSparseDelegate& Delegate, const UObject* DelegateOwner, FName DelegateName);
    /** Called by the object system for each destroyed object. */
    static COREUOBJECT_API void NotifyObjectDestroyed(const UObject* Owner);
};

/** Base of the types that DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE* makes. */
template <typename MulticastDelegate, typename OwningClass, typename DelegateInfoClass>
struct TSparseDynamicDelegate : public FSparseDelegate {
    using FDelegate = typename MulticastDelegate::FDelegate;

    void Add(const FScriptDelegate& InDelegate) {
        FSparseDelegateStorage::GetOrCreate(*this, GetDelegateOwner(), GetDelegateName()).Add(InDelegate);
    }
    void AddUnique(const FScriptDelegate& InDelegate) {
        FSparseDelegateStorage::GetOrCreate(*this, GetDelegateOwner(), GetDelegateName()).AddUnique(InDelegate);
    }
    bool Contains(const FScriptDelegate& InDelegate) const {
        const FMulticastScriptDelegate* List = Find();
        return List && List->Contains(InDelegate);
    }
    bool Contains(const UObject* InObject, FName InFunctionName) const {
        const FMulticastScriptDelegate* List = Find();
        return List && List->Contains(InObject, InFunctionName);
    }
    void Remove(const FScriptDelegate& InDelegate) {
        if (FMulticastScriptDelegate* List = Find()) {
            List->Remove(InDelegate);
            FSparseDelegateStorage::Compact(*this, GetDelegateOwner(), GetDelegateName());
        }
    }
    void Remove(const UObject* InObject, FName InFunctionName) {
        if (FMulticastScriptDelegate* List = Find()) {
            List->Remove(InObject, InFunctionName);
            FSparseDelegateStorage::Compact(*this, GetDelegateOwner(), GetDelegateName());
        }
    }
    void RemoveAll(const UObject* Object) {
        if (FMulticastScriptDelegate* List = Find()) {
            List->RemoveAll(Object);
            FSparseDelegateStorage::Compact(*this, GetDelegateOwner(), GetDelegateName());
        }
    }
    void Clear() { FSparseDelegateStorage::Clear(*this, GetDelegateOwner(), GetDelegateName()); }
    template <typename... ParamTypes>
    void Broadcast(ParamTypes&&... Params) {
        if (const FMulticastScriptDelegate* List = Find()) {
            // A copy: handlers may remove themselves, and with the last one the list.
            const MulticastDelegate Copy(*List);
            Copy.Broadcast(Forward<ParamTypes>(Params)...);
        }
    }
    template <class UserClass>
    bool __Internal_IsAlreadyBound(UserClass* InUserObject,
        typename MulticastDelegate::template TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr,
        FName InFunctionName) const {
        return Contains(InUserObject, InFunctionName);
    }
    template <class UserClass>
    void __Internal_AddDynamic(UserClass* InUserObject,
        typename MulticastDelegate::template TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr,
        FName InFunctionName) {
        FDelegate NewDelegate;
        NewDelegate.__Internal_BindDynamic(InUserObject, InMethodPtr, InFunctionName);
        Add(NewDelegate);
    }
    template <class UserClass>
    void __Internal_AddUniqueDynamic(UserClass* InUserObject,
        typename MulticastDelegate::template TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr,
        FName InFunctionName) {
        FDelegate NewDelegate;
        NewDelegate.__Internal_BindDynamic(InUserObject, InMethodPtr, InFunctionName);
        AddUnique(NewDelegate);
    }
    template <class UserClass>
    void __Internal_RemoveDynamic(UserClass* InUserObject,
        typename MulticastDelegate::template TMethodPtr<std::type_identity_t<UserClass>> InMethodPtr,
        FName InFunctionName) {
        Remove(InUserObject, InFunctionName);
    }

private:
    FName GetDelegateName() const {
        static const FName Name(DelegateInfoClass::GetDelegateName());
        return Name;
    }
    UObject* GetDelegateOwner() const {
        const SIZE_T Offset = DelegateInfoClass::template GetDelegateOffset<OwningClass>();
        return reinterpret_cast<UObject*>(const_cast<uint8*>(reinterpret_cast<const uint8*>(this)) - Offset);
    }
    FMulticastScriptDelegate* Find() const {
        return bIsBound ? FSparseDelegateStorage::GetMulticastDelegate(GetDelegateOwner(), GetDelegateName()) : nullptr;
    }
};

#define UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, ...)                                        \
    UE_DYNAMIC_MULTICAST_DELEGATE(SparseDelegateClass##_MCSignature, __VA_ARGS__)                                      \
    struct SparseDelegateClass##InfoGetter {                                                                           \
        static const char* GetDelegateName() { return #DelegateName; }                                                 \
        template <typename T>                                                                                          \
        static SIZE_T GetDelegateOffset() {                                                                            \
            _Pragma("GCC diagnostic push")                                                                             \
                _Pragma("GCC diagnostic ignored \"-Winvalid-offsetof\"") return offsetof(T, DelegateName);             \
            _Pragma("GCC diagnostic pop")                                                                              \
        }                                                                                                              \
    };                                                                                                                 \
    struct SparseDelegateClass : public TSparseDynamicDelegate<SparseDelegateClass##_MCSignature, OwningClass,         \
                                     SparseDelegateClass##InfoGetter> {};

#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName)                      \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_OneParam(                                                            \
    SparseDelegateClass, OwningClass, DelegateName, Param1Type, Param1Name)                                            \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void, Param1Type)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_TwoParams(                                                           \
    SparseDelegateClass, OwningClass, DelegateName, Param1Type, Param1Name, Param2Type, Param2Name)                    \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void, Param1Type, Param2Type)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_ThreeParams(SparseDelegateClass, OwningClass, DelegateName,          \
    Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name)                                            \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void, Param1Type, Param2Type, Param3Type)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_FourParams(SparseDelegateClass, OwningClass, DelegateName,           \
    Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name, Param4Type, Param4Name)                    \
    UE_SPARSE_DELEGATE(                                                                                                \
        SparseDelegateClass, OwningClass, DelegateName, void, Param1Type, Param2Type, Param3Type, Param4Type)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_FiveParams(SparseDelegateClass, OwningClass, DelegateName,           \
    Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type,        \
    Param5Name)                                                                                                        \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void, Param1Type, Param2Type, Param3Type,       \
        Param4Type, Param5Type)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_SixParams(SparseDelegateClass, OwningClass, DelegateName,            \
    Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type,        \
    Param5Name, Param6Type, Param6Name)                                                                                \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void, Param1Type, Param2Type, Param3Type,       \
        Param4Type, Param5Type, Param6Type)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_SevenParams(SparseDelegateClass, OwningClass, DelegateName,          \
    Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type,        \
    Param5Name, Param6Type, Param6Name, Param7Type, Param7Name)                                                        \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void, Param1Type, Param2Type, Param3Type,       \
        Param4Type, Param5Type, Param6Type, Param7Type)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_EightParams(SparseDelegateClass, OwningClass, DelegateName,          \
    Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type,        \
    Param5Name, Param6Type, Param6Name, Param7Type, Param7Name, Param8Type, Param8Name)                                \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void, Param1Type, Param2Type, Param3Type,       \
        Param4Type, Param5Type, Param6Type, Param7Type, Param8Type)
#define DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_NineParams(SparseDelegateClass, OwningClass, DelegateName,           \
    Param1Type, Param1Name, Param2Type, Param2Name, Param3Type, Param3Name, Param4Type, Param4Name, Param5Type,        \
    Param5Name, Param6Type, Param6Name, Param7Type, Param7Name, Param8Type, Param8Name, Param9Type, Param9Name)        \
    UE_SPARSE_DELEGATE(SparseDelegateClass, OwningClass, DelegateName, void, Param1Type, Param2Type, Param3Type,       \
        Param4Type, Param5Type, Param6Type, Param7Type, Param8Type, Param9Type)
