// SPDX-License-Identifier: MIT
// Cast, CastChecked, ExactCast and CastField between object, interface and field types. Mirrors Epic's
// "Templates/Casts.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/ObjectPtr.h"
#include "UObject/WeakObjectPtrTemplates.h"

class UClass;

/** What CastChecked does with null. */
namespace ECastCheckedType {
enum Type { NullAllowed, NullChecked };
}

/** True for I-classes of UINTERFACE pairs (and not for classes that implement one and so inherit its UClassType). */
template <typename T>
struct TIsIInterface {
    static constexpr bool Value = requires { typename T::UClassType; } && !std::is_base_of_v<UObject, T>;
};

namespace UE::CoreUObject::Private {
/** Object->IsA(Class), quick through the cast flags where the class has one. */
COREUOBJECT_API bool ObjectIsA(const UObject* Object, const UClass* Class, EClassCastFlags CastFlags);
[[noreturn]] COREUOBJECT_API void CastFailed(const UObject* Object, const UClass* Class);

template <typename From>
UObject* ObjectOf(From* Src) {
    if constexpr (TIsIInterface<From>::Value) {
        return Src ? Src->_getUObject() : nullptr;
    } else {
        return const_cast<UObject*>(static_cast<const UObject*>(Src));
    }
}
template <typename To>
UClass* CastTargetClass() {
    if constexpr (TIsIInterface<To>::Value) {
        return To::UClassType::StaticClass();
    } else {
        return To::StaticClass();
    }
}
template <typename To>
To* CastObject(UObject* Object) {
    if (!Object) {
        return nullptr;
    }
    if constexpr (TIsIInterface<To>::Value) {
        return static_cast<To*>(Object->GetInterfaceAddress(To::UClassType::StaticClass()));
    } else if constexpr (std::is_same_v<To, UObject>) {
        return Object;
    } else {
        return ObjectIsA(Object, To::StaticClass(), To::StaticClassCastFlags()) ? static_cast<To*>(Object) : nullptr;
    }
}
} // namespace UE::CoreUObject::Private

/** Src as To, or null if it is not one. Works between classes and interfaces. */
template <typename To, typename From>
FORCEINLINE std::conditional_t<std::is_const_v<From>, const To, To>* Cast(From* Src) {
    return UE::CoreUObject::Private::CastObject<std::remove_const_t<To>>(
        UE::CoreUObject::Private::ObjectOf(const_cast<std::remove_const_t<From>*>(Src)));
}
template <typename To, typename From>
FORCEINLINE To* Cast(const TObjectPtr<From>& Src) {
    return Cast<To>(Src.Get());
}
template <typename To, typename From>
FORCEINLINE To* Cast(const TWeakObjectPtr<From>& Src) {
    return Cast<To>(Src.Get());
}
/** As Cast for objects known to be of that type: a wrong type is a fatal error. */
template <typename To, typename From>
std::conditional_t<std::is_const_v<From>, const To, To>* CastChecked(
    From* Src, ECastCheckedType::Type CheckType = ECastCheckedType::NullChecked) {
    auto* Result = Cast<To>(Src);
    if (!Result && (Src || CheckType == ECastCheckedType::NullChecked)) {
        UE::CoreUObject::Private::CastFailed(
            UE::CoreUObject::Private::ObjectOf(const_cast<std::remove_const_t<From>*>(Src)),
            UE::CoreUObject::Private::CastTargetClass<std::remove_const_t<To>>());
    }
    return Result;
}
template <typename To, typename From>
To* CastChecked(const TObjectPtr<From>& Src, ECastCheckedType::Type CheckType = ECastCheckedType::NullChecked) {
    return CastChecked<To>(Src.Get(), CheckType);
}
template <typename To, typename From>
To* CastChecked(const TWeakObjectPtr<From>& Src, ECastCheckedType::Type CheckType = ECastCheckedType::NullChecked) {
    return CastChecked<To>(Src.Get(), CheckType);
}
/** Src as T if its class is exactly T. */
template <typename T>
T* ExactCast(UObject* Src) {
    return Src && Src->GetClass() == T::StaticClass() ? static_cast<T*>(Src) : nullptr;
}
template <typename T>
T* ExactCast(const TObjectPtr<UObject>& Src) {
    return ExactCast<T>(Src.Get());
}

/** IsValid for interface pointers. */
template <typename T>
    requires TIsIInterface<T>::Value
bool IsValid(const T* Interface) {
    return Interface && IsValid(Interface->_getUObject());
}
