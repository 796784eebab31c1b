// SPDX-License-Identifier: MIT
// UField, UStruct and UScriptStruct.
#include "ObjectSystem.h"
#include "PropertyText.h"
#include "UObject/Class.h"
#include "UObject/UnrealType.h"

UField::~UField() {
#if WITH_METADATA
    delete MetaDataMap;
#endif
}

UClass* UField::GetOwnerClass() const {
    for (const UObject* Object = this; Object; Object = Object->GetOuter()) {
        if (Object->IsA<UClass>()) {
            return static_cast<UClass*>(const_cast<UObject*>(Object));
        }
    }
    return nullptr;
}
UStruct* UField::GetOwnerStruct() const {
    for (const UObject* Object = this; Object; Object = Object->GetOuter()) {
        if (Object->IsA<UStruct>()) {
            return static_cast<UStruct*>(const_cast<UObject*>(Object));
        }
    }
    return nullptr;
}

#if WITH_METADATA
const FString* UField::FindMetaData(const FName& Key) const { return MetaDataMap ? MetaDataMap->Find(Key) : nullptr; }
const FString* UField::FindMetaData(const TCHAR* Key) const { return FindMetaData(FName(Key)); }
const FString& UField::GetMetaData(const FName& Key) const {
    static const FString Empty;
    const FString* Found = FindMetaData(Key);
    return Found ? *Found : Empty;
}
const FString& UField::GetMetaData(const TCHAR* Key) const { return GetMetaData(FName(Key)); }
bool UField::GetBoolMetaData(const FName& Key) const {
    const FString* Found = FindMetaData(Key);
    // A key without value means true.
    return Found && (Found->IsEmpty() || Found->ToBool());
}
int32 UField::GetIntMetaData(const FName& Key) const { return FCString::Atoi(*GetMetaData(Key)); }
float UField::GetFloatMetaData(const FName& Key) const { return FCString::Atof(*GetMetaData(Key)); }
void UField::SetMetaData(const FName& Key, const TCHAR* InValue) {
    if (!MetaDataMap) {
        MetaDataMap = new TMap<FName, FString>;
    }
    MetaDataMap->Add(Key, FString(InValue));
}
void UField::SetMetaData(const TCHAR* Key, const TCHAR* InValue) { SetMetaData(FName(Key), InValue); }
FText UField::GetDisplayNameText() const {
    const FString* DisplayName = FindMetaData(TEXT("DisplayName"));
    return FText::FromString(DisplayName ? *DisplayName : FName::NameToDisplayString(GetName(), false));
}
FText UField::GetToolTipText(bool) const {
    const FString* ToolTip = FindMetaData(TEXT("ToolTip"));
    return ToolTip ? FText::FromString(*ToolTip) : GetDisplayNameText();
}

bool UStruct::GetBoolMetaDataHierarchical(const FName& Key) const {
    const UStruct* Struct = HasMetaDataHierarchical(Key);
    return Struct && Struct->GetBoolMetaData(Key);
}
bool UStruct::GetStringMetaDataHierarchical(const FName& Key, FString* OutValue) const {
    const UStruct* Struct = HasMetaDataHierarchical(Key);
    if (Struct && OutValue) {
        *OutValue = Struct->GetMetaData(Key);
    }
    return Struct != nullptr;
}
const UStruct* UStruct::HasMetaDataHierarchical(const FName& Key) const {
    for (const UStruct* Struct = this; Struct; Struct = Struct->GetSuperStruct()) {
        if (Struct->FindMetaData(Key)) {
            return Struct;
        }
    }
    return nullptr;
}
#endif

// ---------------------------------------------------------------------------------------------------------------------------

UStruct::~UStruct() {
    for (FField* Field = ChildProperties; Field;) {
        FField* NextField = Field->Next;
        delete Field;
        Field = NextField;
    }
}

FProperty* UStruct::FindPropertyByName(FName InName) const {
    for (FProperty* Property = PropertyLink; Property; Property = Property->PropertyLinkNext) {
        if (Property->GetFName() == InName) {
            return Property;
        }
    }
    return nullptr;
}
FProperty* FindFProperty_Internal(const UStruct* Owner, FName FieldName) {
    return Owner ? Owner->FindPropertyByName(FieldName) : nullptr;
}

void UStruct::InitializeStruct(void* InDest, int32 ArrayDim) const {
    const int32 Stride = GetStructureSize();
    FMemory::Memzero(InDest, static_cast<SIZE_T>(Stride) * static_cast<SIZE_T>(ArrayDim));
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        uint8* Dest = static_cast<uint8*>(InDest) + Index * Stride;
        for (FProperty* Property = PropertyLink; Property; Property = Property->PropertyLinkNext) {
            if (!Property->HasAnyPropertyFlags(CPF_ZeroConstructor)) {
                Property->InitializeValue_InContainer(Dest);
            }
        }
    }
}
void UStruct::DestroyStruct(void* InDest, int32 ArrayDim) const {
    const int32 Stride = GetStructureSize();
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        uint8* Dest = static_cast<uint8*>(InDest) + Index * Stride;
        for (FProperty* Property = DestructorLink; Property; Property = Property->DestructorLinkNext) {
            Property->DestroyValue_InContainer(Dest);
        }
    }
}

void UStruct::AddCppProperty(FProperty* Property) {
    FField** Tail = &ChildProperties;
    while (*Tail) {
        Tail = &(*Tail)->Next;
    }
    Property->Next = nullptr;
    *Tail = Property;
}

void UStruct::Link(bool bComputeLayout) {
    if (bComputeLayout) {
        PropertiesSize = SuperStruct ? SuperStruct->PropertiesSize : 0;
        MinAlignment = SuperStruct ? SuperStruct->MinAlignment : 1;
    }
    for (FField* Field = ChildProperties; Field; Field = Field->Next) {
        FProperty* Property = static_cast<FProperty*>(Field);
        Property->Link();
        if (bComputeLayout) {
            PropertiesSize = Property->SetupOffset(PropertiesSize);
            MinAlignment = FMath::Max(MinAlignment, Property->GetMinAlignment());
        }
    }
    PropertyLink = RefLink = DestructorLink = PostConstructLink = nullptr;
    FProperty** PropertyTail = &PropertyLink;
    FProperty** RefTail = &RefLink;
    FProperty** DestructorTail = &DestructorLink;
    FProperty** PostConstructTail = &PostConstructLink;
    TArray<const FStructProperty*> Encountered;
    for (FField* Field = ChildProperties; Field; Field = Field->Next) {
        FProperty* Property = static_cast<FProperty*>(Field);
        *PropertyTail = Property;
        PropertyTail = &Property->PropertyLinkNext;
        Encountered.Reset();
        if (Property->ContainsObjectReference(Encountered, EPropertyObjectReferenceType::Strong)) {
            *RefTail = Property;
            RefTail = &Property->NextRef;
        }
        if (!Property->HasAnyPropertyFlags(CPF_NoDestructor)) {
            *DestructorTail = Property;
            DestructorTail = &Property->DestructorLinkNext;
        }
        if (Property->HasAnyPropertyFlags(CPF_Config)) {
            *PostConstructTail = Property;
            PostConstructTail = &Property->PostConstructLinkNext;
        }
    }
    // The base type's lists follow the own ones.
    *PropertyTail = SuperStruct ? SuperStruct->PropertyLink : nullptr;
    *RefTail = SuperStruct ? SuperStruct->RefLink : nullptr;
    *DestructorTail = SuperStruct ? SuperStruct->DestructorLink : nullptr;
    *PostConstructTail = SuperStruct ? SuperStruct->PostConstructLink : nullptr;
}

void UStruct::AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector) {
    UStruct* This = static_cast<UStruct*>(InThis);
    Collector.AddReferencedObject(This->SuperStruct, This);
    for (UField* Field = This->Children; Field; Field = Field->Next) {
        UField* Child = Field;
        Collector.AddReferencedObject(Child, This);
    }
    for (FField* Field = This->ChildProperties; Field; Field = Field->Next) {
        Field->AddReferencedObjects(Collector);
    }
    Super::AddReferencedObjects(InThis, Collector);
}

// ---------------------------------------------------------------------------------------------------------------------------

void UScriptStruct::PrepareCppStructOps() {
    if (CppStructOps) {
        StructFlags |= CppStructOps->GetComputedStructFlags() | STRUCT_Native;
        PropertiesSize = CppStructOps->GetSize();
        MinAlignment = CppStructOps->GetAlignment();
    }
}

void UScriptStruct::Link(bool bComputeLayout) {
    UStruct::Link(bComputeLayout && !CppStructOps);
    if (!CppStructOps) {
        StructFlags &= ~(STRUCT_IsPlainOldData | STRUCT_NoDestructor | STRUCT_ZeroConstructor);
        bool bPlain = true;
        bool bZero = true;
        for (FProperty* Property = PropertyLink; Property; Property = Property->PropertyLinkNext) {
            bPlain = bPlain && Property->HasAnyPropertyFlags(CPF_IsPlainOldData);
            bZero = bZero && Property->HasAnyPropertyFlags(CPF_ZeroConstructor);
        }
        StructFlags |= (bPlain ? STRUCT_IsPlainOldData : STRUCT_NoFlags) |
                       (DestructorLink ? STRUCT_NoFlags : STRUCT_NoDestructor) |
                       (bZero ? STRUCT_ZeroConstructor : STRUCT_NoFlags);
    }
    for (FProperty* Property = PropertyLink; Property; Property = Property->PropertyLinkNext) {
        if (Property->ContainsInstancedObjectProperty()) {
            StructFlags |= STRUCT_HasInstancedReference;
        }
    }
}

void UScriptStruct::InitializeStruct(void* Dest, int32 ArrayDim) const {
    if (!CppStructOps) {
        UStruct::InitializeStruct(Dest, ArrayDim);
        return;
    }
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        CppStructOps->Construct(static_cast<uint8*>(Dest) + Index * GetStructureSize());
    }
}
void UScriptStruct::DestroyStruct(void* Dest, int32 ArrayDim) const {
    if (StructFlags & (STRUCT_IsPlainOldData | STRUCT_NoDestructor)) {
        return;
    }
    if (!CppStructOps) {
        UStruct::DestroyStruct(Dest, ArrayDim);
        return;
    }
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        CppStructOps->Destruct(static_cast<uint8*>(Dest) + Index * GetStructureSize());
    }
}
void UScriptStruct::CopyScriptStruct(void* InDest, void const* InSrc, int32 ArrayDim) const {
    if (InDest == InSrc) {
        return;
    }
    const int32 Stride = GetStructureSize();
    if (StructFlags & STRUCT_IsPlainOldData) {
        FMemory::Memcpy(InDest, InSrc, static_cast<SIZE_T>(Stride) * static_cast<SIZE_T>(ArrayDim));
        return;
    }
    if (CppStructOps && CppStructOps->Copy(InDest, InSrc, ArrayDim)) {
        return;
    }
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        for (FProperty* Property = PropertyLink; Property; Property = Property->PropertyLinkNext) {
            Property->CopyCompleteValue_InContainer(
                static_cast<uint8*>(InDest) + Index * Stride, static_cast<const uint8*>(InSrc) + Index * Stride);
        }
    }
}
void UScriptStruct::ClearScriptStruct(void* Dest, int32 ArrayDim) const {
    DestroyStruct(Dest, ArrayDim);
    InitializeStruct(Dest, ArrayDim);
}
bool UScriptStruct::CompareScriptStruct(const void* A, const void* B, uint32 PortFlags) const {
    check(A);
    if (!B) {
        // Null stands for a fresh value.
        void* Fresh = FMemory::MallocZeroed(
            static_cast<SIZE_T>(FMath::Max(GetStructureSize(), 1)), static_cast<uint32>(MinAlignment));
        InitializeStruct(Fresh);
        const bool bEqual = CompareScriptStruct(A, Fresh, PortFlags);
        DestroyStruct(Fresh);
        FMemory::Free(Fresh);
        return bEqual;
    }
    bool bResult = false;
    if (CppStructOps && CppStructOps->Identical(A, B, PortFlags, bResult)) {
        return bResult;
    }
    for (FProperty* Property = PropertyLink; Property; Property = Property->PropertyLinkNext) {
        for (int32 Index = 0; Index < Property->ArrayDim; ++Index) {
            if (!Property->Identical_InContainer(A, B, Index, PortFlags)) {
                return false;
            }
        }
    }
    return true;
}
uint32 UScriptStruct::GetStructTypeHash(const void* Src) const {
    if (CppStructOps && CppStructOps->HasGetTypeHash()) {
        return CppStructOps->GetStructTypeHash(Src);
    }
    uint32 Hash = 0;
    for (FProperty* Property = PropertyLink; Property; Property = Property->PropertyLinkNext) {
        for (int32 Index = 0; Index < Property->ArrayDim; ++Index) {
            Hash = HashCombine(Hash, Property->GetValueTypeHash(Property->ContainerPtrToValuePtr<void>(Src, Index)));
        }
    }
    return Hash;
}

void UScriptStruct::ExportText(FString& ValueStr, const void* Value, const void* Defaults, UObject* OwnerObject,
    int32 PortFlags, UObject* ExportRootScope, bool bAllowNativeOverride) const {
    if (bAllowNativeOverride && CppStructOps && CppStructOps->HasExportTextItem() &&
        CppStructOps->ExportTextItem(ValueStr, Value, Defaults, OwnerObject, PortFlags, ExportRootScope)) {
        return;
    }
    bool bFirst = true;
    // Base types first, in order of declaration, as people read them.
    TArray<const UStruct*> Chain;
    for (const UStruct* Struct = this; Struct; Struct = Struct->GetSuperStruct()) {
        Chain.Insert(Struct, 0);
    }
    for (const UStruct* Struct : Chain) {
        for (const FField* Field = Struct->ChildProperties; Field; Field = Field->Next) {
            const FProperty* Property = static_cast<const FProperty*>(Field);
            if (!Property->ShouldPort(static_cast<uint32>(PortFlags))) {
                continue;
            }
            for (int32 Index = 0; Index < Property->ArrayDim; ++Index) {
                FString Inner;
                if (!Property->ExportText_InContainer(
                        Index, Inner, Value, Defaults, OwnerObject, PPF_Delimited | PortFlags, ExportRootScope)) {
                    continue;
                }
                ValueStr += bFirst ? TEXT("(") : TEXT(",");
                bFirst = false;
                ValueStr += Property->GetName();
                if (Property->ArrayDim > 1) {
                    ValueStr += FString::Printf(TEXT("[%d]"), Index);
                }
                ValueStr += TEXT("=");
                ValueStr += Inner;
            }
        }
    }
    ValueStr += bFirst ? TEXT("()") : TEXT(")");
}

const TCHAR* UScriptStruct::ImportText(const TCHAR* Buffer, void* Value, UObject* OwnerObject, int32 PortFlags,
    FOutputDevice* ErrorText, const FString& StructName, bool bAllowNativeOverride) const {
    if (bAllowNativeOverride && CppStructOps && CppStructOps->HasImportTextItem()) {
        const TCHAR* Cursor = Buffer;
        if (CppStructOps->ImportTextItem(Cursor, Value, PortFlags, OwnerObject, ErrorText)) {
            return Cursor;
        }
    }
    PropertyText::FReader Reader(Buffer);
    Reader.SkipSpace();
    if (!Reader.Accept('(')) {
        PropertyText::Report(
            ErrorText, FString::Printf(TEXT("%s: '(' expected, found '%s'"), *StructName, *Reader.Rest()));
        return nullptr;
    }
    Reader.SkipSpace();
    while (!Reader.Accept(')')) {
        const FString Name = Reader.ReadName();
        int32 Index = 0;
        if (Reader.Accept('[')) {
            Index = Reader.ReadInt();
            if (!Reader.Accept(']')) {
                PropertyText::Report(ErrorText,
                    FString::Printf(TEXT("%s.%s: ']' expected, found '%s'"), *StructName, *Name, *Reader.Rest()));
                return nullptr;
            }
        }
        Reader.SkipSpace();
        if (Name.IsEmpty() || !Reader.Accept('=')) {
            PropertyText::Report(ErrorText,
                FString::Printf(TEXT("%s: 'Name=' expected, found '%s'"), *StructName, *(Name + Reader.Rest())));
            return nullptr;
        }
        const FProperty* Property = FindPropertyByName(FName(*Name));
        if (!Property) {
            PropertyText::Report(ErrorText, FString::Printf(TEXT("%s has no property '%s'"), *StructName, *Name));
            return nullptr;
        }
        if (Index < 0 || Index >= Property->ArrayDim) {
            PropertyText::Report(
                ErrorText, FString::Printf(TEXT("%s.%s: index %d is out of range, there are %d elements"), *StructName,
                               *Name, Index, Property->ArrayDim));
            return nullptr;
        }
        Reader.SkipSpace();
        const TCHAR* After = Property->ImportText_Direct(Reader.Cursor(),
            Property->ContainerPtrToValuePtr<void>(Value, Index), OwnerObject, PortFlags | PPF_Delimited, ErrorText);
        if (!After) {
            return nullptr;
        }
        Reader.Set(After);
        Reader.SkipSpace();
        if (!Reader.Accept(',') && !Reader.Is(')')) {
            PropertyText::Report(
                ErrorText, FString::Printf(TEXT("%s: ',' or ')' expected, found '%s'"), *StructName, *Reader.Rest()));
            return nullptr;
        }
        Reader.SkipSpace();
    }
    return Reader.Cursor();
}
