// SPDX-License-Identifier: MIT
// Struct and array properties.
#include "UObject/PropertyContainers.h"

#include "PropertyContainerText.h"

using namespace PropertyText;

IMPLEMENT_FIELD(FStructProperty)
IMPLEMENT_FIELD(FArrayProperty)

#define EXPORT_TEXT(TClass)                                                                                            \
    void TClass::ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,                          \
        EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,          \
        UObject* ExportRootScope) const
#define IMPORT_TEXT(TClass)                                                                                            \
    const TCHAR* TClass::ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,                        \
        EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags, FOutputDevice* ErrorText)     \
        const

// ---------------------------------------------------------------------------------------------------------------------------
// FStructProperty

FString FStructProperty::GetCPPType(FString* ExtendedTypeText, uint32) const { return Struct->GetStructCPPName(); }
int32 FStructProperty::GetMinAlignment() const { return Struct->GetMinAlignment(); }
void FStructProperty::LinkInternal() {
    check(Struct);
    ElementSize = Struct->GetStructureSize();
    if (ICppStructOps* Ops = Struct->GetCppStructOps()) {
        PropertyFlags |= Ops->GetComputedPropertyFlags();
    } else {
        PropertyFlags |= (Struct->StructFlags & STRUCT_IsPlainOldData ? CPF_IsPlainOldData : CPF_None) |
                         (Struct->StructFlags & STRUCT_NoDestructor ? CPF_NoDestructor : CPF_None) |
                         (Struct->StructFlags & STRUCT_ZeroConstructor ? CPF_ZeroConstructor : CPF_None);
    }
}
void FStructProperty::CopyValuesInternal(void* Dest, void const* Src, int32 Count) const {
    Struct->CopyScriptStruct(Dest, Src, Count);
}
void FStructProperty::ClearValueInternal(void* Data) const { Struct->ClearScriptStruct(Data, 1); }
void FStructProperty::InitializeValueInternal(void* Dest) const { Struct->InitializeStruct(Dest, ArrayDim); }
void FStructProperty::DestroyValueInternal(void* Dest) const { Struct->DestroyStruct(Dest, ArrayDim); }
bool FStructProperty::Identical(const void* A, const void* B, uint32 PortFlags) const {
    return Struct->CompareScriptStruct(A, B, PortFlags);
}
uint32 FStructProperty::GetValueTypeHashInternal(const void* Src) const { return Struct->GetStructTypeHash(Src); }
bool FStructProperty::ContainsObjectReference(
    TArray<const FStructProperty*>& EncounteredStructProps, EPropertyObjectReferenceType InReferenceType) const {
    if (!Struct || EncounteredStructProps.Contains(this)) {
        return false;
    }
    if ((Struct->StructFlags & STRUCT_AddStructReferencedObjects) &&
        EnumHasAnyFlags(InReferenceType, EPropertyObjectReferenceType::Strong)) {
        return true;
    }
    EncounteredStructProps.Add(this);
    bool bFound = false;
    for (FProperty* Property = Struct->PropertyLink; Property && !bFound; Property = Property->PropertyLinkNext) {
        bFound = Property->ContainsObjectReference(EncounteredStructProps, InReferenceType);
    }
    EncounteredStructProps.RemoveSingle(this);
    return bFound;
}
void FStructProperty::CollectReferences(void* Value, FReferenceCollector& Collector, const UObject* Referencer) const {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        Collector.AddPropertyReferences(Struct, static_cast<uint8*>(Value) + Index * ElementSize, Referencer);
    }
}
void FStructProperty::InstanceSubobjects(
    void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        Struct->InstanceSubobjectTemplates(static_cast<uint8*>(Data) + Index * ElementSize,
            DefaultData ? static_cast<const uint8*>(DefaultData) + Index * ElementSize : nullptr, Struct, InOwner,
            InstanceGraph);
    }
}
void* FStructProperty::GetValueAddressAtIndex_Direct(const FProperty* Inner, void* InValueAddress, int32 Index) const {
    return Inner ? Inner->ContainerPtrToValuePtr<void>(InValueAddress, Index)
                 : static_cast<uint8*>(InValueAddress) + Index * ElementSize;
}
EXPORT_TEXT(FStructProperty) {
    Struct->ExportText(ValueStr, PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType), DefaultValue, Parent,
        PortFlags, ExportRootScope);
}
IMPORT_TEXT(FStructProperty) {
    return Struct->ImportText(Buffer, PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType), OwnerObject,
        PortFlags, ErrorText, GetName());
}

// ---------------------------------------------------------------------------------------------------------------------------
// FArrayProperty

FArrayProperty::~FArrayProperty() { delete Inner; }
FString FArrayProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    if (ExtendedTypeText) {
        *ExtendedTypeText = FString::Printf(TEXT("<%s>"), *FullCPPType(Inner));
    }
    return FString(TEXT("TArray"));
}
void FArrayProperty::LinkInternal() {
    Inner->Link();
    ElementSize = sizeof(FScriptArray);
    PropertyFlags |= CPF_ZeroConstructor;
}
void FArrayProperty::CopyValuesInternal(void* Dest, void const* Src, int32 Count) const {
    check(Count == 1);
    FScriptArrayHelper Source(this, Src);
    FScriptArrayHelper Target(this, Dest);
    const int32 Num = Source.Num();
    Target.EmptyAndAddValues(Num);
    for (int32 Index = 0; Index < Num; ++Index) {
        Inner->CopyCompleteValue(Target.GetRawPtr(Index), Source.GetRawPtr(Index));
    }
}
void FArrayProperty::ClearValueInternal(void* Data) const { FScriptArrayHelper(this, Data).EmptyValues(); }
void FArrayProperty::InitializeValueInternal(void* Dest) const { new (Dest) FScriptArray; }
void FArrayProperty::DestroyValueInternal(void* Dest) const {
    FScriptArrayHelper(this, Dest).EmptyValues();
    static_cast<FScriptArray*>(Dest)->~FScriptArray();
}
bool FArrayProperty::Identical(const void* A, const void* B, uint32 PortFlags) const {
    FScriptArrayHelper ArrayA(this, A);
    const int32 Num = ArrayA.Num();
    if (!B) {
        return Num == 0;
    }
    FScriptArrayHelper ArrayB(this, B);
    if (ArrayB.Num() != Num) {
        return false;
    }
    for (int32 Index = 0; Index < Num; ++Index) {
        if (!Inner->Identical(ArrayA.GetRawPtr(Index), ArrayB.GetRawPtr(Index), PortFlags)) {
            return false;
        }
    }
    return true;
}
bool FArrayProperty::ContainsObjectReference(
    TArray<const FStructProperty*>& EncounteredStructProps, EPropertyObjectReferenceType InReferenceType) const {
    return Inner->ContainsObjectReference(EncounteredStructProps, InReferenceType);
}
void FArrayProperty::CollectReferences(void* Value, FReferenceCollector& Collector, const UObject* Referencer) const {
    FScriptArrayHelper Array(this, Value);
    for (int32 Index = 0; Index < Array.Num(); ++Index) {
        Inner->CollectReferences(Array.GetRawPtr(Index), Collector, Referencer);
    }
}
void FArrayProperty::InstanceSubobjects(
    void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) {
    FScriptArrayHelper Array(this, Data);
    for (int32 Index = 0; Index < Array.Num(); ++Index) {
        Inner->InstanceSubobjects(Array.GetRawPtr(Index), nullptr, InOwner, InstanceGraph);
    }
}
void* FArrayProperty::GetValueAddressAtIndex_Direct(const FProperty*, void* InValueAddress, int32 Index) const {
    FScriptArrayHelper Array(this, InValueAddress);
    return Array.IsValidIndex(Index) ? Array.GetRawPtr(Index) : nullptr;
}
void FArrayProperty::GetInnerFields(TArray<FField*>& OutFields) {
    OutFields.Add(Inner);
    Inner->GetInnerFields(OutFields);
}
FField* FArrayProperty::GetInnerFieldByName(const FName& InName) { return FieldIfNamed(Inner, InName); }
EXPORT_TEXT(FArrayProperty) {
    const FScriptArrayHelper Array(this, PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType));
    ValueStr += TEXT("(");
    for (int32 Index = 0; Index < Array.Num(); ++Index) {
        ValueStr += Index > 0 ? TEXT(",") : TEXT("");
        Inner->ExportTextItem_Direct(
            ValueStr, Array.GetRawPtr(Index), nullptr, Parent, PortFlags | PPF_Delimited, ExportRootScope);
    }
    ValueStr += TEXT(")");
}
IMPORT_TEXT(FArrayProperty) {
    FScriptArrayHelper Array(this, PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    Array.EmptyValues();
    return ImportList(this, Buffer, ErrorText, [&](const TCHAR* Cursor) {
        const int32 Index = Array.AddValue();
        return Inner->ImportText_Direct(
            Cursor, Array.GetRawPtr(Index), OwnerObject, PortFlags | PPF_Delimited, ErrorText);
    });
}

void FScriptArrayHelper::ConstructItem(int32 Index) { InnerProperty->InitializeValue(GetRawPtr(Index)); }
void FScriptArrayHelper::DestructItems(int32 Index, int32 Count) {
    if (!InnerProperty->HasAnyPropertyFlags(CPF_NoDestructor)) {
        for (int32 Offset = 0; Offset < Count; ++Offset) {
            InnerProperty->DestroyValue(GetRawPtr(Index + Offset));
        }
    }
}
void FScriptArrayHelper::EmptyValues(int32 Slack) {
    DestructItems(0, Num());
    Array->Empty(Slack, static_cast<SIZE_T>(ElementSize), ElementAlignment);
}
void FScriptArrayHelper::EmptyAndAddValues(int32 Count) {
    EmptyValues(Count);
    if (Count > 0) {
        AddValues(Count);
    }
}
void FScriptArrayHelper::EmptyAndAddUninitializedValues(int32 Count) {
    EmptyValues(Count);
    if (Count > 0) {
        AddUninitializedValues(Count);
    }
}
int32 FScriptArrayHelper::AddUninitializedValues(int32 Count) {
    return Array->Add(Count, static_cast<SIZE_T>(ElementSize), ElementAlignment);
}
int32 FScriptArrayHelper::AddUninitializedValue() { return AddUninitializedValues(1); }
int32 FScriptArrayHelper::AddValues(int32 Count) {
    const int32 First = AddUninitializedValues(Count);
    for (int32 Offset = 0; Offset < Count; ++Offset) {
        ConstructItem(First + Offset);
    }
    return First;
}
int32 FScriptArrayHelper::AddValue() { return AddValues(1); }
void FScriptArrayHelper::InsertValues(int32 Index, int32 Count) {
    check(Index >= 0 && Index <= Num() && Count >= 0);
    Array->Insert(Index, Count, static_cast<SIZE_T>(ElementSize), ElementAlignment);
    for (int32 Offset = 0; Offset < Count; ++Offset) {
        ConstructItem(Index + Offset);
    }
}
void FScriptArrayHelper::RemoveValues(int32 Index, int32 Count) {
    check(Index >= 0 && Count >= 0 && Index + Count <= Num());
    DestructItems(Index, Count);
    Array->Remove(Index, Count, static_cast<SIZE_T>(ElementSize), ElementAlignment);
}
void FScriptArrayHelper::ClearValues(int32 Index, int32 Count) {
    for (int32 Offset = 0; Offset < Count; ++Offset) {
        InnerProperty->ClearValue(GetElementPtr(Index + Offset));
    }
}
void FScriptArrayHelper::Resize(int32 Count) {
    check(Count >= 0);
    const int32 Old = Num();
    if (Count > Old) {
        AddValues(Count - Old);
    } else if (Count < Old) {
        RemoveValues(Count, Old - Count);
    }
}
