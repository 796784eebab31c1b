// SPDX-License-Identifier: MIT
// Set, map and optional properties.
#include "PropertyContainerText.h"
#include "UObject/PropertyContainers.h"

using namespace PropertyText;

IMPLEMENT_FIELD(FSetProperty)
IMPLEMENT_FIELD(FMapProperty)
IMPLEMENT_FIELD(FOptionalProperty)

#define EXPORT_TEXT(TClass)                                                                                            \
    void TClass::ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,                          \
        EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,          \
        UObject* ExportRootScope) const
#define IMPORT_TEXT(TClass)                                                                                            \
    const TCHAR* TClass::ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,                        \
        EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags, FOutputDevice* ErrorText)     \
        const

// ---------------------------------------------------------------------------------------------------------------------------
// FSetProperty

FSetProperty::~FSetProperty() { delete ElementProp; }
FString FSetProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    if (ExtendedTypeText) {
        *ExtendedTypeText = FString::Printf(TEXT("<%s>"), *FullCPPType(ElementProp));
    }
    return FString(TEXT("TSet"));
}
void FSetProperty::LinkInternal() {
    ElementProp->Link();
    ElementSize = sizeof(FScriptSet);
    SetLayout = FScriptSet::GetScriptLayout(ElementProp->GetSize(), ElementProp->GetMinAlignment());
    checkf(ElementProp->HasAnyPropertyFlags(CPF_HasGetValueTypeHash), TEXT("%s: elements of a set need GetTypeHash"),
        *GetPathName());
}
void FSetProperty::CopyValuesInternal(void* Dest, void const* Src, int32 Count) const {
    check(Count == 1);
    FScriptSetHelper Source(this, Src);
    FScriptSetHelper Target(this, Dest);
    Target.EmptyElements(Source.Num());
    for (int32 Index = 0; Index < Source.GetMaxIndex(); ++Index) {
        if (Source.IsValidIndex(Index)) {
            const int32 New = Target.AddDefaultValue_Invalid_NeedsRehash();
            ElementProp->CopyCompleteValue(Target.GetElementPtr(New), Source.GetElementPtr(Index));
        }
    }
    Target.Rehash();
}
void FSetProperty::ClearValueInternal(void* Data) const { FScriptSetHelper(this, Data).EmptyElements(); }
void FSetProperty::InitializeValueInternal(void* Dest) const { new (Dest) FScriptSet; }
void FSetProperty::DestroyValueInternal(void* Dest) const {
    FScriptSetHelper(this, Dest).EmptyElements();
    static_cast<FScriptSet*>(Dest)->~FScriptSet();
}
bool FSetProperty::Identical(const void* A, const void* B, uint32 PortFlags) const {
    FScriptSetHelper SetA(this, A);
    if (!B) {
        return SetA.Num() == 0;
    }
    FScriptSetHelper SetB(this, B);
    if (SetA.Num() != SetB.Num()) {
        return false;
    }
    for (int32 Index = 0; Index < SetA.GetMaxIndex(); ++Index) {
        if (SetA.IsValidIndex(Index) && !SetB.Contains(SetA.GetElementPtr(Index))) {
            return false;
        }
    }
    return true;
}
bool FSetProperty::ContainsObjectReference(
    TArray<const FStructProperty*>& EncounteredStructProps, EPropertyObjectReferenceType InReferenceType) const {
    return ElementProp->ContainsObjectReference(EncounteredStructProps, InReferenceType);
}
void FSetProperty::CollectReferences(void* Value, FReferenceCollector& Collector, const UObject* Referencer) const {
    FScriptSetHelper Set(this, Value);
    bool bChanged = false;
    TArray<uint8> Before;
    for (int32 Index = 0; Index < Set.GetMaxIndex(); ++Index) {
        if (Set.IsValidIndex(Index)) {
            const uint32 OldHash = ElementProp->GetValueTypeHash(Set.GetElementPtr(Index));
            ElementProp->CollectReferences(Set.GetElementPtr(Index), Collector, Referencer);
            bChanged = bChanged || OldHash != ElementProp->GetValueTypeHash(Set.GetElementPtr(Index));
        }
    }
    if (bChanged) {
        // Nulled or exchanged references are found under their new hash only.
        Set.Rehash();
    }
}
void FSetProperty::InstanceSubobjects(
    void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) {
    FScriptSetHelper Set(this, Data);
    for (int32 Index = 0; Index < Set.GetMaxIndex(); ++Index) {
        if (Set.IsValidIndex(Index)) {
            ElementProp->InstanceSubobjects(Set.GetElementPtr(Index), nullptr, InOwner, InstanceGraph);
        }
    }
    Set.Rehash();
}
void* FSetProperty::GetValueAddressAtIndex_Direct(const FProperty*, void* InValueAddress, int32 Index) const {
    return FScriptSetHelper(this, InValueAddress).FindNthElementPtr(Index);
}
void FSetProperty::GetInnerFields(TArray<FField*>& OutFields) {
    OutFields.Add(ElementProp);
    ElementProp->GetInnerFields(OutFields);
}
FField* FSetProperty::GetInnerFieldByName(const FName& InName) { return FieldIfNamed(ElementProp, InName); }
EXPORT_TEXT(FSetProperty) {
    const FScriptSetHelper Set(this, PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType));
    ValueStr += TEXT("(");
    bool bFirst = true;
    for (int32 Index = 0; Index < Set.GetMaxIndex(); ++Index) {
        if (Set.IsValidIndex(Index)) {
            ValueStr += bFirst ? TEXT("") : TEXT(",");
            bFirst = false;
            ElementProp->ExportTextItem_Direct(
                ValueStr, Set.GetElementPtr(Index), nullptr, Parent, PortFlags | PPF_Delimited, ExportRootScope);
        }
    }
    ValueStr += TEXT(")");
}
IMPORT_TEXT(FSetProperty) {
    FScriptSetHelper Set(this, PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    Set.EmptyElements();
    FScopedValue Element(ElementProp);
    return ImportList(this, Buffer, ErrorText, [&](const TCHAR* Cursor) {
        Element.Reset();
        const TCHAR* After =
            ElementProp->ImportText_Direct(Cursor, Element.Get(), OwnerObject, PortFlags | PPF_Delimited, ErrorText);
        if (After) {
            Set.AddElement(Element.Get());
        }
        return After;
    });
}

int32 FScriptSetHelper::FindInternalIndex(int32 LogicalIndex) const {
    for (int32 Index = 0; Index < GetMaxIndex(); ++Index) {
        if (IsValidIndex(Index) && LogicalIndex-- == 0) {
            return Index;
        }
    }
    return INDEX_NONE;
}
int32 FScriptSetHelper::FindLogicalIndex(int32 InternalIndex) const {
    if (!IsValidIndex(InternalIndex)) {
        return INDEX_NONE;
    }
    int32 Logical = 0;
    for (int32 Index = 0; Index < InternalIndex; ++Index) {
        Logical += IsValidIndex(Index) ? 1 : 0;
    }
    return Logical;
}
void FScriptSetHelper::EmptyElements(int32 Slack) {
    for (int32 Index = 0; Index < GetMaxIndex(); ++Index) {
        if (IsValidIndex(Index)) {
            ElementProp->DestroyValue(GetElementPtr(Index));
        }
    }
    Set->Empty(Slack, SetLayout);
}
int32 FScriptSetHelper::AddDefaultValue_Invalid_NeedsRehash() {
    const int32 Index = AddUninitializedValue();
    ElementProp->InitializeValue(GetElementPtr(Index));
    return Index;
}
void FScriptSetHelper::Rehash() {
    Set->Rehash(SetLayout, [this](const void* Element) { return ElementProp->GetValueTypeHash(Element); });
}
void FScriptSetHelper::AddElement(const void* ElementToAdd) {
    Set->Add(
        ElementToAdd, SetLayout, [this](const void* Element) { return ElementProp->GetValueTypeHash(Element); },
        [this](const void* A, const void* B) { return ElementProp->Identical(A, B); },
        [this, ElementToAdd](void* New) {
            ElementProp->InitializeValue(New);
            ElementProp->CopyCompleteValue(New, ElementToAdd);
        },
        [this](void* Old) { ElementProp->DestroyValue(Old); });
}
void FScriptSetHelper::RemoveAt(int32 InternalIndex, int32 Count) {
    for (; Count > 0 && InternalIndex < GetMaxIndex(); ++InternalIndex) {
        if (IsValidIndex(InternalIndex)) {
            ElementProp->DestroyValue(GetElementPtr(InternalIndex));
            Set->RemoveAt(InternalIndex, SetLayout);
            --Count;
        }
    }
}
int32 FScriptSetHelper::FindElementIndex(const void* ElementToFind) const {
    return Set->FindIndex(
        ElementToFind, SetLayout, [this](const void* Element) { return ElementProp->GetValueTypeHash(Element); },
        [this](const void* A, const void* B) { return ElementProp->Identical(A, B); });
}
bool FScriptSetHelper::RemoveElement(const void* ElementToRemove) {
    const int32 Index = FindElementIndex(ElementToRemove);
    if (Index == INDEX_NONE) {
        return false;
    }
    RemoveAt(Index);
    return true;
}

// ---------------------------------------------------------------------------------------------------------------------------
// FMapProperty

FMapProperty::~FMapProperty() {
    delete KeyProp;
    delete ValueProp;
}
FString FMapProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    if (ExtendedTypeText) {
        *ExtendedTypeText = FString::Printf(TEXT("<%s,%s>"), *FullCPPType(KeyProp), *FullCPPType(ValueProp));
    }
    return FString(TEXT("TMap"));
}
void FMapProperty::LinkInternal() {
    KeyProp->Link();
    ValueProp->Link();
    ElementSize = sizeof(FScriptMap);
    MapLayout = FScriptMap::GetScriptLayout(
        KeyProp->GetSize(), KeyProp->GetMinAlignment(), ValueProp->GetSize(), ValueProp->GetMinAlignment());
    // The value property then also works with the address of a pair, as in UE.
    ValueProp->SetOffset_Internal(0);
    checkf(KeyProp->HasAnyPropertyFlags(CPF_HasGetValueTypeHash), TEXT("%s: keys of a map need GetTypeHash"),
        *GetPathName());
}
void FMapProperty::CopyValuesInternal(void* Dest, void const* Src, int32 Count) const {
    check(Count == 1);
    FScriptMapHelper Source(this, Src);
    FScriptMapHelper Target(this, Dest);
    Target.EmptyValues(Source.Num());
    for (int32 Index = 0; Index < Source.GetMaxIndex(); ++Index) {
        if (Source.IsValidIndex(Index)) {
            const int32 New = Target.AddDefaultValue_Invalid_NeedsRehash();
            KeyProp->CopyCompleteValue(Target.GetKeyPtr(New), Source.GetKeyPtr(Index));
            ValueProp->CopyCompleteValue(Target.GetValuePtr(New), Source.GetValuePtr(Index));
        }
    }
    Target.Rehash();
}
void FMapProperty::ClearValueInternal(void* Data) const { FScriptMapHelper(this, Data).EmptyValues(); }
void FMapProperty::InitializeValueInternal(void* Dest) const { new (Dest) FScriptMap; }
void FMapProperty::DestroyValueInternal(void* Dest) const {
    FScriptMapHelper(this, Dest).EmptyValues();
    static_cast<FScriptMap*>(Dest)->~FScriptMap();
}
bool FMapProperty::Identical(const void* A, const void* B, uint32 PortFlags) const {
    FScriptMapHelper MapA(this, A);
    if (!B) {
        return MapA.Num() == 0;
    }
    FScriptMapHelper MapB(this, B);
    if (MapA.Num() != MapB.Num()) {
        return false;
    }
    for (int32 Index = 0; Index < MapA.GetMaxIndex(); ++Index) {
        if (MapA.IsValidIndex(Index)) {
            const int32 Other = MapB.FindMapIndexWithKey(MapA.GetKeyPtr(Index));
            if (Other == INDEX_NONE ||
                !ValueProp->Identical(MapA.GetValuePtr(Index), MapB.GetValuePtr(Other), PortFlags)) {
                return false;
            }
        }
    }
    return true;
}
bool FMapProperty::ContainsObjectReference(
    TArray<const FStructProperty*>& EncounteredStructProps, EPropertyObjectReferenceType InReferenceType) const {
    return KeyProp->ContainsObjectReference(EncounteredStructProps, InReferenceType) ||
           ValueProp->ContainsObjectReference(EncounteredStructProps, InReferenceType);
}
void FMapProperty::CollectReferences(void* Value, FReferenceCollector& Collector, const UObject* Referencer) const {
    FScriptMapHelper Map(this, Value);
    bool bChanged = false;
    for (int32 Index = 0; Index < Map.GetMaxIndex(); ++Index) {
        if (Map.IsValidIndex(Index)) {
            const uint32 OldHash = KeyProp->GetValueTypeHash(Map.GetKeyPtr(Index));
            KeyProp->CollectReferences(Map.GetKeyPtr(Index), Collector, Referencer);
            bChanged = bChanged || OldHash != KeyProp->GetValueTypeHash(Map.GetKeyPtr(Index));
            ValueProp->CollectReferences(Map.GetValuePtr(Index), Collector, Referencer);
        }
    }
    if (bChanged) {
        Map.Rehash();
    }
}
void FMapProperty::InstanceSubobjects(
    void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) {
    FScriptMapHelper Map(this, Data);
    for (int32 Index = 0; Index < Map.GetMaxIndex(); ++Index) {
        if (Map.IsValidIndex(Index)) {
            KeyProp->InstanceSubobjects(Map.GetKeyPtr(Index), nullptr, InOwner, InstanceGraph);
            ValueProp->InstanceSubobjects(Map.GetValuePtr(Index), nullptr, InOwner, InstanceGraph);
        }
    }
    Map.Rehash();
}
void* FMapProperty::GetValueAddressAtIndex_Direct(const FProperty* Inner, void* InValueAddress, int32 Index) const {
    FScriptMapHelper Map(this, InValueAddress);
    const int32 Internal = Map.FindInternalIndex(Index);
    if (Internal == INDEX_NONE) {
        return nullptr;
    }
    return Inner == KeyProp ? Map.GetKeyPtr(Internal) : Map.GetValuePtr(Internal);
}
void FMapProperty::GetInnerFields(TArray<FField*>& OutFields) {
    OutFields.Add(KeyProp);
    KeyProp->GetInnerFields(OutFields);
    OutFields.Add(ValueProp);
    ValueProp->GetInnerFields(OutFields);
}
FField* FMapProperty::GetInnerFieldByName(const FName& InName) {
    FField* Key = FieldIfNamed(KeyProp, InName);
    return Key ? Key : FieldIfNamed(ValueProp, InName);
}
EXPORT_TEXT(FMapProperty) {
    const FScriptMapHelper Map(this, PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType));
    ValueStr += TEXT("(");
    bool bFirst = true;
    for (int32 Index = 0; Index < Map.GetMaxIndex(); ++Index) {
        if (Map.IsValidIndex(Index)) {
            ValueStr += bFirst ? TEXT("(") : TEXT(",(");
            bFirst = false;
            KeyProp->ExportTextItem_Direct(
                ValueStr, Map.GetKeyPtr(Index), nullptr, Parent, PortFlags | PPF_Delimited, ExportRootScope);
            ValueStr += TEXT(", ");
            ValueProp->ExportTextItem_Direct(
                ValueStr, Map.GetValuePtr(Index), nullptr, Parent, PortFlags | PPF_Delimited, ExportRootScope);
            ValueStr += TEXT(")");
        }
    }
    ValueStr += TEXT(")");
}
IMPORT_TEXT(FMapProperty) {
    FScriptMapHelper Map(this, PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    Map.EmptyValues();
    FScopedValue Key(KeyProp);
    FScopedValue Value(ValueProp);
    return ImportList(this, Buffer, ErrorText, [&](const TCHAR* Cursor) -> const TCHAR* {
        Key.Reset();
        Value.Reset();
        PropertyText::FReader Reader(Cursor);
        if (!Reader.Accept('(')) {
            return BadContainer(ErrorText, this, TEXT("'('"), Reader);
        }
        Reader.SkipSpace();
        const TCHAR* After =
            KeyProp->ImportText_Direct(Reader.Cursor(), Key.Get(), OwnerObject, PortFlags | PPF_Delimited, ErrorText);
        if (!After) {
            return nullptr;
        }
        Reader.Set(After);
        Reader.SkipSpace();
        if (!Reader.Accept(',')) {
            return BadContainer(ErrorText, this, TEXT("','"), Reader);
        }
        Reader.SkipSpace();
        After = ValueProp->ImportText_Direct(
            Reader.Cursor(), Value.Get(), OwnerObject, PortFlags | PPF_Delimited, ErrorText);
        if (!After) {
            return nullptr;
        }
        Reader.Set(After);
        Reader.SkipSpace();
        if (!Reader.Accept(')')) {
            return BadContainer(ErrorText, this, TEXT("')'"), Reader);
        }
        Map.AddPair(Key.Get(), Value.Get());
        return Reader.Cursor();
    });
}

int32 FScriptMapHelper::FindInternalIndex(int32 LogicalIndex) const {
    for (int32 Index = 0; Index < GetMaxIndex(); ++Index) {
        if (IsValidIndex(Index) && LogicalIndex-- == 0) {
            return Index;
        }
    }
    return INDEX_NONE;
}
int32 FScriptMapHelper::FindLogicalIndex(int32 InternalIndex) const {
    if (!IsValidIndex(InternalIndex)) {
        return INDEX_NONE;
    }
    int32 Logical = 0;
    for (int32 Index = 0; Index < InternalIndex; ++Index) {
        Logical += IsValidIndex(Index) ? 1 : 0;
    }
    return Logical;
}
void FScriptMapHelper::EmptyValues(int32 Slack) {
    for (int32 Index = 0; Index < GetMaxIndex(); ++Index) {
        if (IsValidIndex(Index)) {
            KeyProp->DestroyValue(GetKeyPtr(Index));
            ValueProp->DestroyValue(GetValuePtr(Index));
        }
    }
    Map->Empty(Slack, MapLayout);
}
int32 FScriptMapHelper::AddDefaultValue_Invalid_NeedsRehash() {
    const int32 Index = AddUninitializedValue();
    KeyProp->InitializeValue(GetKeyPtr(Index));
    ValueProp->InitializeValue(GetValuePtr(Index));
    return Index;
}
void FScriptMapHelper::Rehash() {
    Map->Rehash(MapLayout, [this](const void* Key) { return KeyProp->GetValueTypeHash(Key); });
}
int32 FScriptMapHelper::FindMapIndexWithKey(const void* Key) const {
    return Map->FindPairIndex(
        Key, MapLayout, [this](const void* Element) { return KeyProp->GetValueTypeHash(Element); },
        [this](const void* A, const void* B) { return KeyProp->Identical(A, B); });
}
void* FScriptMapHelper::FindOrAdd(const void* KeyPtr) {
    int32 Index = FindMapIndexWithKey(KeyPtr);
    if (Index == INDEX_NONE) {
        Index = AddDefaultValue_Invalid_NeedsRehash();
        KeyProp->CopyCompleteValue(GetKeyPtr(Index), KeyPtr);
        Rehash();
    }
    return GetValuePtr(Index);
}
void FScriptMapHelper::AddPair(const void* KeyPtr, const void* ValuePtr) {
    ValueProp->CopyCompleteValue(FindOrAdd(KeyPtr), ValuePtr);
}
void FScriptMapHelper::RemoveAt(int32 InternalIndex, int32 Count) {
    for (; Count > 0 && InternalIndex < GetMaxIndex(); ++InternalIndex) {
        if (IsValidIndex(InternalIndex)) {
            KeyProp->DestroyValue(GetKeyPtr(InternalIndex));
            ValueProp->DestroyValue(GetValuePtr(InternalIndex));
            Map->RemoveAt(InternalIndex, MapLayout);
            --Count;
        }
    }
}
bool FScriptMapHelper::RemovePair(const void* KeyPtr) {
    const int32 Index = FindMapIndexWithKey(KeyPtr);
    if (Index == INDEX_NONE) {
        return false;
    }
    RemoveAt(Index);
    return true;
}

// ---------------------------------------------------------------------------------------------------------------------------
// FOptionalProperty

FOptionalProperty::~FOptionalProperty() { delete ValueProperty; }
FString FOptionalProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    if (ExtendedTypeText) {
        *ExtendedTypeText = FString::Printf(TEXT("<%s>"), *FullCPPType(ValueProperty));
    }
    return FString(TEXT("TOptional"));
}
void FOptionalProperty::LinkInternal() {
    ValueProperty->Link();
    ElementSize = Align(ValueProperty->GetSize() + static_cast<int32>(sizeof(bool)), ValueProperty->GetMinAlignment());
    PropertyFlags |=
        CPF_ZeroConstructor | (ValueProperty->PropertyFlags & (CPF_NoDestructor | CPF_HasGetValueTypeHash));
}
void* FOptionalProperty::MarkSetAndGetInitializedValuePointerToReplace(void* Data) const {
    if (!IsSet(Data)) {
        ValueProperty->InitializeValue(Data);
        *static_cast<bool*>(SetFlag(Data)) = true;
    }
    return Data;
}
void FOptionalProperty::MarkUnset(void* Data) const {
    if (IsSet(Data)) {
        ValueProperty->DestroyValue(Data);
        *static_cast<bool*>(SetFlag(Data)) = false;
    }
}
void FOptionalProperty::CopyValuesInternal(void* Dest, void const* Src, int32 Count) const {
    for (int32 Index = 0; Index < Count; ++Index) {
        void* Target = static_cast<uint8*>(Dest) + Index * ElementSize;
        const void* Source = static_cast<const uint8*>(Src) + Index * ElementSize;
        if (IsSet(Source)) {
            ValueProperty->CopyCompleteValue(MarkSetAndGetInitializedValuePointerToReplace(Target), Source);
        } else {
            MarkUnset(Target);
        }
    }
}
void FOptionalProperty::ClearValueInternal(void* Data) const { MarkUnset(Data); }
void FOptionalProperty::InitializeValueInternal(void* Dest) const {
    FMemory::Memzero(Dest, static_cast<SIZE_T>(GetSize()));
}
void FOptionalProperty::DestroyValueInternal(void* Dest) const {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        MarkUnset(static_cast<uint8*>(Dest) + Index * ElementSize);
    }
}
bool FOptionalProperty::Identical(const void* A, const void* B, uint32 PortFlags) const {
    const bool bSetB = B && IsSet(B);
    return IsSet(A) == bSetB && (!bSetB || ValueProperty->Identical(A, B, PortFlags));
}
bool FOptionalProperty::ContainsObjectReference(
    TArray<const FStructProperty*>& EncounteredStructProps, EPropertyObjectReferenceType InReferenceType) const {
    return ValueProperty->ContainsObjectReference(EncounteredStructProps, InReferenceType);
}
void FOptionalProperty::CollectReferences(
    void* Value, FReferenceCollector& Collector, const UObject* Referencer) const {
    if (IsSet(Value)) {
        ValueProperty->CollectReferences(Value, Collector, Referencer);
    }
}
void FOptionalProperty::InstanceSubobjects(
    void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) {
    if (IsSet(Data)) {
        ValueProperty->InstanceSubobjects(Data, nullptr, InOwner, InstanceGraph);
    }
}
void* FOptionalProperty::GetValueAddressAtIndex_Direct(const FProperty*, void* InValueAddress, int32 Index) const {
    return Index == 0 && IsSet(InValueAddress) ? InValueAddress : nullptr;
}
void FOptionalProperty::GetInnerFields(TArray<FField*>& OutFields) {
    OutFields.Add(ValueProperty);
    ValueProperty->GetInnerFields(OutFields);
}
FField* FOptionalProperty::GetInnerFieldByName(const FName& InName) { return FieldIfNamed(ValueProperty, InName); }
EXPORT_TEXT(FOptionalProperty) {
    const void* Value = PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType);
    ValueStr += TEXT("(");
    if (IsSet(Value)) {
        ValueProperty->ExportTextItem_Direct(
            ValueStr, Value, nullptr, Parent, PortFlags | PPF_Delimited, ExportRootScope);
    }
    ValueStr += TEXT(")");
}
IMPORT_TEXT(FOptionalProperty) {
    void* Value = PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType);
    MarkUnset(Value);
    return ImportList(this, Buffer, ErrorText, [&](const TCHAR* Cursor) {
        return ValueProperty->ImportText_Direct(Cursor, MarkSetAndGetInitializedValuePointerToReplace(Value),
            OwnerObject, PortFlags | PPF_Delimited, ErrorText);
    });
}
