// SPDX-License-Identifier: MIT
// Struct, array, set and map properties with their helpers. Part of "UObject/UnrealType.h".
#pragma once

#include "Containers/ScriptArray.h"
#include "UObject/PropertyObject.h"

#define UE_DECLARE_CONTAINER_VALUE                                                                                     \
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override;                             \
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,                       \
        EPropertyObjectReferenceType InReferenceType) const override;                                                  \
    virtual void CollectReferences(void* Value, FReferenceCollector& Collector, const UObject* Referencer)             \
        const override;                                                                                                \
    virtual void InstanceSubobjects(                                                                                   \
        void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) override;        \
    virtual void* GetValueAddressAtIndex_Direct(const FProperty* Inner, void* InValueAddress, int32 Index)             \
        const override;                                                                                                \
    virtual void GetInnerFields(TArray<FField*>& OutFields) override;                                                  \
    virtual FField* GetInnerFieldByName(const FName& InName) override;

#define UE_DECLARE_CONTAINER_INTERNALS                                                                                 \
    virtual void LinkInternal() override;                                                                              \
    virtual void CopyValuesInternal(void* Dest, void const* Src, int32 Count) const override;                          \
    virtual void ClearValueInternal(void* Data) const override;                                                        \
    virtual void InitializeValueInternal(void* Dest) const override;                                                   \
    virtual void DestroyValueInternal(void* Dest) const override;                                                      \
    UE_DECLARE_PROPERTY_TEXT

/** A USTRUCT by value. */
class FStructProperty : public FProperty {
    DECLARE_FIELD(FStructProperty, FProperty, CASTCLASS_FStructProperty)

    TObjectPtr<UScriptStruct> Struct;

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool PassCPPArgsByRef() const override { return true; }
    COREUOBJECT_API virtual int32 GetMinAlignment() const override;
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && Struct == static_cast<const FStructProperty*>(Other)->Struct;
    }
    virtual void AddReferencedObjects(FReferenceCollector& Collector) override {
        Collector.AddReferencedObject(Struct);
    }
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override;
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,
        EPropertyObjectReferenceType InReferenceType) const override;
    virtual void CollectReferences(
        void* Value, FReferenceCollector& Collector, const UObject* Referencer) const override;
    virtual void InstanceSubobjects(
        void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) override;
    virtual void* GetValueAddressAtIndex_Direct(
        const FProperty* Inner, void* InValueAddress, int32 Index) const override;

protected:
    virtual uint32 GetValueTypeHashInternal(const void* Src) const override;
    UE_DECLARE_CONTAINER_INTERNALS
};

/** TArray<Inner>. */
class FArrayProperty : public FProperty {
    DECLARE_FIELD(FArrayProperty, FProperty, CASTCLASS_FArrayProperty)
public:
    COREUOBJECT_API virtual ~FArrayProperty() override;
    typedef FScriptArray TCppType;

    /** The element property. */
    FProperty* Inner = nullptr;

    static const FScriptArray& GetPropertyValue(const void* A) { return *static_cast<const FScriptArray*>(A); }
    static FScriptArray* GetPropertyValuePtr(void* A) { return static_cast<FScriptArray*>(A); }
    static FScriptArray GetDefaultPropertyValue() = delete;
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool PassCPPArgsByRef() const override { return true; }
    virtual int32 GetMinAlignment() const override { return alignof(FScriptArray); }
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && Inner->SameType(static_cast<const FArrayProperty*>(Other)->Inner);
    }
    UE_DECLARE_CONTAINER_VALUE

protected:
    UE_DECLARE_CONTAINER_INTERNALS
};

/** TSet<ElementProp>. */
class FSetProperty : public FProperty {
    DECLARE_FIELD(FSetProperty, FProperty, CASTCLASS_FSetProperty)
public:
    COREUOBJECT_API virtual ~FSetProperty() override;
    typedef FScriptSet TCppType;

    FProperty* ElementProp = nullptr;
    FScriptSetLayout SetLayout = {};

    FProperty* GetElementProperty() const { return ElementProp; }
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool PassCPPArgsByRef() const override { return true; }
    virtual int32 GetMinAlignment() const override { return alignof(FScriptSet); }
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && ElementProp->SameType(static_cast<const FSetProperty*>(Other)->ElementProp);
    }
    UE_DECLARE_CONTAINER_VALUE

protected:
    UE_DECLARE_CONTAINER_INTERNALS
};

/** TMap<KeyProp, ValueProp>. */
class FMapProperty : public FProperty {
    DECLARE_FIELD(FMapProperty, FProperty, CASTCLASS_FMapProperty)
public:
    COREUOBJECT_API virtual ~FMapProperty() override;
    typedef FScriptMap TCppType;

    FProperty* KeyProp = nullptr;
    FProperty* ValueProp = nullptr;
    FScriptMapLayout MapLayout = {};

    FProperty* GetKeyProperty() const { return KeyProp; }
    FProperty* GetValueProperty() const { return ValueProp; }
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool PassCPPArgsByRef() const override { return true; }
    virtual int32 GetMinAlignment() const override { return alignof(FScriptMap); }
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && KeyProp->SameType(static_cast<const FMapProperty*>(Other)->KeyProp) &&
               ValueProp->SameType(static_cast<const FMapProperty*>(Other)->ValueProp);
    }
    UE_DECLARE_CONTAINER_VALUE

protected:
    UE_DECLARE_CONTAINER_INTERNALS
};

/** TOptional<ValueProperty>: the value, then a byte that says whether it is set. */
class FOptionalProperty : public FProperty {
    DECLARE_FIELD(FOptionalProperty, FProperty, CASTCLASS_FOptionalProperty)
public:
    COREUOBJECT_API virtual ~FOptionalProperty() override;

    FProperty* ValueProperty = nullptr;

    FProperty* GetValueProperty() const { return ValueProperty; }
    bool IsSet(const void* Data) const { return *static_cast<const bool*>(SetFlag(const_cast<void*>(Data))); }
    /** Address of the value if it is set, else null. */
    void* GetValuePointerForReplaceIfSet(void* Data) const { return IsSet(Data) ? Data : nullptr; }
    const void* GetValuePointerForReadIfSet(const void* Data) const { return IsSet(Data) ? Data : nullptr; }
    /** Address of the value, which must be set. */
    const void* GetValuePointerForRead(const void* Data) const {
        check(IsSet(Data));
        return Data;
    }
    void* GetValuePointerForReplace(void* Data) const {
        check(IsSet(Data));
        return Data;
    }
    /** Makes the value set (default value if it was not) and returns its address. */
    COREUOBJECT_API void* MarkSetAndGetInitializedValuePointerToReplace(void* Data) const;
    COREUOBJECT_API void MarkUnset(void* Data) const;
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual int32 GetMinAlignment() const override { return ValueProperty->GetMinAlignment(); }
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) &&
               ValueProperty->SameType(static_cast<const FOptionalProperty*>(Other)->ValueProperty);
    }
    UE_DECLARE_CONTAINER_VALUE

protected:
    UE_DECLARE_CONTAINER_INTERNALS

private:
    void* SetFlag(void* Data) const { return static_cast<uint8*>(Data) + ValueProperty->GetSize(); }
};

/** Array operations through reflection. Indices must be valid; new elements are initialised, removed ones destroyed. */
class FScriptArrayHelper {
public:
    FScriptArrayHelper(const FArrayProperty* InProperty, const void* InArray)
        : InnerProperty(InProperty->Inner), Array(static_cast<FScriptArray*>(const_cast<void*>(InArray))),
          ElementSize(InProperty->Inner->GetSize()),
          ElementAlignment(static_cast<uint32>(InProperty->Inner->GetMinAlignment())) {}
    bool IsValidIndex(int32 Index) const { return Index >= 0 && Index < Num(); }
    int32 Num() const { return Array->Num(); }
    static int32 Num(const void* Target) { return static_cast<const FScriptArray*>(Target)->Num(); }
    uint8* GetRawPtr(int32 Index = 0) {
        return Num() == 0 ? nullptr
                          : static_cast<uint8*>(Array->GetData()) +
                                static_cast<SIZE_T>(Index) * static_cast<SIZE_T>(ElementSize);
    }
    const uint8* GetRawPtr(int32 Index = 0) const { return const_cast<FScriptArrayHelper*>(this)->GetRawPtr(Index); }
    /** Address of an element; the index must be valid. */
    uint8* GetElementPtr(int32 Index) {
        check(IsValidIndex(Index));
        return GetRawPtr(Index);
    }
    const uint8* GetElementPtr(int32 Index) const {
        return const_cast<FScriptArrayHelper*>(this)->GetElementPtr(Index);
    }
    COREUOBJECT_API void EmptyValues(int32 Slack = 0);
    COREUOBJECT_API void EmptyAndAddValues(int32 Count);
    COREUOBJECT_API void EmptyAndAddUninitializedValues(int32 Count);
    COREUOBJECT_API int32 AddValue();
    COREUOBJECT_API int32 AddValues(int32 Count);
    COREUOBJECT_API int32 AddUninitializedValue();
    COREUOBJECT_API int32 AddUninitializedValues(int32 Count);
    COREUOBJECT_API void InsertValues(int32 Index, int32 Count = 1);
    COREUOBJECT_API void RemoveValues(int32 Index, int32 Count = 1);
    COREUOBJECT_API void ClearValues(int32 Index, int32 Count = 1);
    void SwapValues(int32 A, int32 B) { Array->SwapMemory(A, B, static_cast<SIZE_T>(ElementSize)); }
    /** Sets the number of elements. */
    COREUOBJECT_API void Resize(int32 Count);
    bool ExpandForIndex(int32 Index) {
        if (Index < Num()) {
            return false;
        }
        AddValues(Index - Num() + 1);
        return true;
    }
    COREUOBJECT_API void ConstructItem(int32 Index);
    COREUOBJECT_API void DestructItems(int32 Index, int32 Count);
    void MoveAssign(void* InOtherArray) {
        EmptyValues();
        Array->MoveAssign(
            *static_cast<FScriptArray*>(InOtherArray), static_cast<SIZE_T>(ElementSize), ElementAlignment);
    }

private:
    const FProperty* InnerProperty;
    FScriptArray* Array;
    int32 ElementSize;
    uint32 ElementAlignment;
};
class FScriptArrayHelper_InContainer : public FScriptArrayHelper {
public:
    FScriptArrayHelper_InContainer(const FArrayProperty* InProperty, const void* InContainer, int32 FixedArrayIndex = 0)
        : FScriptArrayHelper(InProperty, InProperty->ContainerPtrToValuePtr<void>(InContainer, FixedArrayIndex)) {}
};

/** Set operations through reflection. "Internal" indices have holes, "logical" ones count elements in order. */
class FScriptSetHelper {
public:
    FScriptSetHelper(const FSetProperty* InProperty, const void* InSet)
        : ElementProp(InProperty->ElementProp), SetLayout(InProperty->SetLayout),
          Set(static_cast<FScriptSet*>(const_cast<void*>(InSet))) {}
    FProperty* GetElementProperty() const { return ElementProp; }
    bool IsValidIndex(int32 InternalIndex) const { return Set->IsValidIndex(InternalIndex); }
    int32 Num() const { return Set->Num(); }
    static int32 Num(const void* Target) { return static_cast<const FScriptSet*>(Target)->Num(); }
    int32 GetMaxIndex() const { return Set->GetMaxIndex(); }
    uint8* GetElementPtr(int32 InternalIndex) {
        check(IsValidIndex(InternalIndex));
        return static_cast<uint8*>(Set->GetData(InternalIndex, SetLayout));
    }
    const uint8* GetElementPtr(int32 InternalIndex) const {
        return const_cast<FScriptSetHelper*>(this)->GetElementPtr(InternalIndex);
    }
    COREUOBJECT_API int32 FindInternalIndex(int32 LogicalIndex) const;
    COREUOBJECT_API int32 FindLogicalIndex(int32 InternalIndex) const;
    uint8* FindNthElementPtr(int32 N) {
        const int32 Index = FindInternalIndex(N);
        return Index == INDEX_NONE ? nullptr : GetElementPtr(Index);
    }
    COREUOBJECT_API void EmptyElements(int32 Slack = 0);
    /** Adds default elements that the hash does not know; call Rehash after filling them. */
    COREUOBJECT_API int32 AddDefaultValue_Invalid_NeedsRehash();
    int32 AddUninitializedValue() { return Set->AddUninitialized(SetLayout); }
    /** Adds a copy of an element unless an equal one is there. */
    COREUOBJECT_API void AddElement(const void* ElementToAdd);
    COREUOBJECT_API void RemoveAt(int32 InternalIndex, int32 Count = 1);
    COREUOBJECT_API bool RemoveElement(const void* ElementToRemove);
    COREUOBJECT_API void Rehash();
    /** Internal index of an equal element, or INDEX_NONE. */
    COREUOBJECT_API int32 FindElementIndex(const void* ElementToFind) const;
    int32 FindElementIndexFromHash(const void* ElementToFind) const { return FindElementIndex(ElementToFind); }
    bool Contains(const void* Element) const { return FindElementIndex(Element) != INDEX_NONE; }

private:
    FProperty* ElementProp;
    const FScriptSetLayout& SetLayout;
    FScriptSet* Set;
};
class FScriptSetHelper_InContainer : public FScriptSetHelper {
public:
    FScriptSetHelper_InContainer(const FSetProperty* InProperty, const void* InContainer, int32 FixedArrayIndex = 0)
        : FScriptSetHelper(InProperty, InProperty->ContainerPtrToValuePtr<void>(InContainer, FixedArrayIndex)) {}
};

/** Map operations through reflection; indices as for sets. */
class FScriptMapHelper {
public:
    FScriptMapHelper(const FMapProperty* InProperty, const void* InMap)
        : KeyProp(InProperty->KeyProp), ValueProp(InProperty->ValueProp), MapLayout(InProperty->MapLayout),
          Map(static_cast<FScriptMap*>(const_cast<void*>(InMap))) {}
    FProperty* GetKeyProperty() const { return KeyProp; }
    FProperty* GetValueProperty() const { return ValueProp; }
    bool IsValidIndex(int32 InternalIndex) const { return Map->IsValidIndex(InternalIndex); }
    int32 Num() const { return Map->Num(); }
    static int32 Num(const void* Target) { return static_cast<const FScriptMap*>(Target)->Num(); }
    int32 GetMaxIndex() const { return Map->GetMaxIndex(); }
    uint8* GetPairPtr(int32 InternalIndex) {
        check(IsValidIndex(InternalIndex));
        return static_cast<uint8*>(Map->GetData(InternalIndex, MapLayout));
    }
    const uint8* GetPairPtr(int32 InternalIndex) const {
        return const_cast<FScriptMapHelper*>(this)->GetPairPtr(InternalIndex);
    }
    uint8* GetKeyPtr(int32 InternalIndex) { return GetPairPtr(InternalIndex); }
    const uint8* GetKeyPtr(int32 InternalIndex) const { return GetPairPtr(InternalIndex); }
    uint8* GetValuePtr(int32 InternalIndex) { return GetPairPtr(InternalIndex) + MapLayout.ValueOffset; }
    const uint8* GetValuePtr(int32 InternalIndex) const { return GetPairPtr(InternalIndex) + MapLayout.ValueOffset; }
    COREUOBJECT_API int32 FindInternalIndex(int32 LogicalIndex) const;
    COREUOBJECT_API int32 FindLogicalIndex(int32 InternalIndex) const;
    COREUOBJECT_API void EmptyValues(int32 Slack = 0);
    COREUOBJECT_API int32 AddDefaultValue_Invalid_NeedsRehash();
    int32 AddUninitializedValue() { return Map->AddUninitialized(MapLayout); }
    /** Adds a pair, or replaces the value of an equal key. */
    COREUOBJECT_API void AddPair(const void* KeyPtr, const void* ValuePtr);
    COREUOBJECT_API void RemoveAt(int32 InternalIndex, int32 Count = 1);
    COREUOBJECT_API bool RemovePair(const void* KeyPtr);
    COREUOBJECT_API void Rehash();
    /** Internal index of the pair with an equal key, or INDEX_NONE. */
    COREUOBJECT_API int32 FindMapIndexWithKey(const void* Key) const;
    int32 FindMapPairIndexFromHash(const void* Key) const { return FindMapIndexWithKey(Key); }
    /** Address of the value of a key, adding the key with a default value if it is missing. */
    COREUOBJECT_API void* FindOrAdd(const void* KeyPtr);
    /** Address of the pair with an equal key, or null. */
    uint8* FindMapPairPtrFromHash(const void* KeyPtr) {
        const int32 Index = FindMapIndexWithKey(KeyPtr);
        return Index == INDEX_NONE ? nullptr : GetPairPtr(Index);
    }
    /** Address of the value of a key, or null. */
    uint8* FindValueFromHash(const void* KeyPtr) {
        const int32 Index = FindMapIndexWithKey(KeyPtr);
        return Index == INDEX_NONE ? nullptr : GetValuePtr(Index);
    }

private:
    FProperty* KeyProp;
    FProperty* ValueProp;
    const FScriptMapLayout& MapLayout;
    FScriptMap* Map;
};
class FScriptMapHelper_InContainer : public FScriptMapHelper {
public:
    FScriptMapHelper_InContainer(const FMapProperty* InProperty, const void* InContainer, int32 FixedArrayIndex = 0)
        : FScriptMapHelper(InProperty, InProperty->ContainerPtrToValuePtr<void>(InContainer, FixedArrayIndex)) {}
};
