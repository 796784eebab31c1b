// SPDX-License-Identifier: MIT
// TSubclassOf. Mirrors Epic's "Templates/SubclassOf.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectPtr.h"

class UClass;
class UObject;

namespace UE::CoreUObject::Private {
/** Class->IsChildOf(Base), null-safe, for headers that do not know UClass. */
COREUOBJECT_API bool ClassIsChildOf(const UClass* Class, const UClass* Base);
COREUOBJECT_API UObject* ClassDefaultObject(const UClass* Class);
/** Object as a class that is Base or a child of it, else null. */
COREUOBJECT_API UClass* AsChildClass(UObject* Object, const UClass* Base);
} // namespace UE::CoreUObject::Private

/** A class pointer that yields null unless the class is T or a child of it. T may be incomplete until the class is
 * read. */
template <typename T>
class TSubclassOf {
public:
    using ElementType = T;

    TSubclassOf() = default;
    TSubclassOf(TYPE_OF_NULLPTR) {}
    TSubclassOf(UClass* From) : Class(From) {}
    TSubclassOf(const UClass* From) : Class(const_cast<UClass*>(From)) {}
    TSubclassOf(TObjectPtr<UClass> From) : Class(From) {}
    template <typename U>
        requires(!std::is_same_v<U, T> && std::is_convertible_v<U*, T*>)
    TSubclassOf(const TSubclassOf<U>& Other) : Class(Other.GetUnchecked()) {}
    TSubclassOf& operator=(UClass* From) {
        Class = From;
        return *this;
    }
    TSubclassOf& operator=(TYPE_OF_NULLPTR) {
        Class = nullptr;
        return *this;
    }

    UClass* Get() const {
        return Class && UE::CoreUObject::Private::ClassIsChildOf(Class, std::remove_const_t<T>::StaticClass())
                   ? Class.Get()
                   : nullptr;
    }
    UClass* operator*() const { return Get(); }
    UClass* operator->() const { return Get(); }
    operator UClass*() const { return Get(); }
    explicit operator bool() const { return Get() != nullptr; }
    /** The class default object as T. */
    T* GetDefaultObject() const { return static_cast<T*>(UE::CoreUObject::Private::ClassDefaultObject(Get())); }
    /** The stored pointer without the check. */
    UClass* GetUnchecked() const { return Class; }
    TObjectPtr<UClass>& GetGCPtr() { return Class; }

    friend uint32 GetTypeHash(const TSubclassOf& SubclassOf) { return PointerHash(SubclassOf.Class.Get()); }
    friend bool operator==(const TSubclassOf& A, const TSubclassOf& B) { return A.Class == B.Class; }
    friend bool operator==(const TSubclassOf& A, const UClass* B) { return A.Class.Get() == B; }
    friend bool operator==(const TSubclassOf& A, TYPE_OF_NULLPTR) { return A.Class.Get() == nullptr; }

private:
    TObjectPtr<UClass> Class;
};
static_assert(sizeof(TSubclassOf<UObject>) == sizeof(void*));
