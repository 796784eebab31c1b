// SPDX-License-Identifier: MIT
// FReferenceCollector: through it the garbage collector learns of references. In UE it lives in
// "UObject/UObjectGlobals.h", which includes this file.
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectPtr.h"

class FProperty;
class UObject;
class UStruct;
struct FWeakObjectPtr;

/** Visitor of object references. Holders call it with the address of each reference; it may null or exchange them. */
class FReferenceCollector {
public:
    virtual ~FReferenceCollector() = default;

    /** Reports one reference. T must be complete (its address is that of its UObject). */
    template <class UObjectType>
    void AddReferencedObject(UObjectType*& Object, const UObject* ReferencingObject = nullptr,
        const FProperty* ReferencingProperty = nullptr) {
        HandleObjectReference(*reinterpret_cast<UObject**>(const_cast<std::remove_const_t<UObjectType>**>(&Object)),
            ReferencingObject, ReferencingProperty);
    }
    template <class UObjectType>
    void AddReferencedObject(TObjectPtr<UObjectType>& Object, const UObject* ReferencingObject = nullptr,
        const FProperty* ReferencingProperty = nullptr) {
        HandleObjectReference(reinterpret_cast<UObject*&>(Object), ReferencingObject, ReferencingProperty);
    }
    /** Reports a weak pointer as if it were strong: the object stays alive. */
    COREUOBJECT_API void AddReferencedObject(FWeakObjectPtr& Object, const UObject* ReferencingObject = nullptr,
        const FProperty* ReferencingProperty = nullptr);

    template <class ElementType, typename Allocator>
    void AddReferencedObjects(TArray<ElementType, Allocator>& ObjectArray, const UObject* ReferencingObject = nullptr,
        const FProperty* ReferencingProperty = nullptr) {
        for (auto& Object : ObjectArray) {
            AddReferencedObject(Object, ReferencingObject, ReferencingProperty);
        }
    }
    template <class ElementType, typename KeyFuncs, typename Allocator>
    void AddReferencedObjects(TSet<ElementType, KeyFuncs, Allocator>& ObjectSet,
        const UObject* ReferencingObject = nullptr, const FProperty* ReferencingProperty = nullptr) {
        for (auto& Object : ObjectSet) {
            AddReferencedObject(const_cast<ElementType&>(Object), ReferencingObject, ReferencingProperty);
        }
    }
    /** Reports those of keys and values that are object references. */
    template <typename KeyType, typename ValueType, typename Allocator, typename KeyFuncs>
    void AddReferencedObjects(TMap<KeyType, ValueType, Allocator, KeyFuncs>& Map,
        const UObject* ReferencingObject = nullptr, const FProperty* ReferencingProperty = nullptr) {
        for (auto& Pair : Map) {
            AddIfReference(const_cast<KeyType&>(Pair.Key), ReferencingObject, ReferencingProperty);
            AddIfReference(Pair.Value, ReferencingObject, ReferencingProperty);
        }
    }
    /** Reports what the reflected properties of a struct value refer to. */
    COREUOBJECT_API void AddPropertyReferences(
        const UStruct* Struct, void* Instance, const UObject* ReferencingObject = nullptr);
    void AddPropertyReferencesWithStructARO(
        const UStruct* Struct, void* Instance, const UObject* ReferencingObject = nullptr) {
        AddPropertyReferences(Struct, Instance, ReferencingObject);
    }
    template <class UObjectType>
    void AddStableReference(TObjectPtr<UObjectType>* Object) {
        AddReferencedObject(*Object);
    }

    /** True if archetypes shall not be reported. */
    virtual bool IsIgnoringArchetypeRef() const { return false; }
    virtual bool IsIgnoringTransient() const { return false; }
    /** Switches the nulling of references to garbage on and off for what follows. */
    virtual void AllowEliminatingReferences(bool bAllow) {}

protected:
    /** Called for each reference that is not null. */
    virtual void HandleObjectReference(
        UObject*& InObject, const UObject* InReferencingObject, const FProperty* InReferencingProperty) = 0;

private:
    template <typename T>
    void AddIfReference(T& Value, const UObject* ReferencingObject, const FProperty* ReferencingProperty) {
        if constexpr (std::is_pointer_v<T> || TIsTObjectPtr<T>::Value) {
            AddReferencedObject(Value, ReferencingObject, ReferencingProperty);
        }
    }
};
