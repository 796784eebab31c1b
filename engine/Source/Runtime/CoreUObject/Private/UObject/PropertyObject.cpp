// SPDX-License-Identifier: MIT
// Object, class and interface properties.
#include "UObject/PropertyObject.h"

#include "PropertyText.h"
#include "UObject/UnrealType.h"

IMPLEMENT_ABSTRACT_FIELD(FObjectPropertyBase)
IMPLEMENT_FIELD(FObjectProperty)
IMPLEMENT_FIELD(FWeakObjectProperty)
IMPLEMENT_FIELD(FLazyObjectProperty)
IMPLEMENT_FIELD(FSoftObjectProperty)
IMPLEMENT_FIELD(FClassProperty)
IMPLEMENT_FIELD(FSoftClassProperty)
IMPLEMENT_FIELD(FInterfaceProperty)

#define EXPORT_TEXT(TClass)                                                                                            \
    void TClass::ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,                          \
        EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,          \
        UObject* ExportRootScope) const
#define IMPORT_TEXT(TClass)                                                                                            \
    const TCHAR* TClass::ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,                        \
        EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags, FOutputDevice* ErrorText)     \
        const

FString FObjectPropertyBase::GetCPPTypeOf(const TCHAR* Template, FString* ExtendedTypeText, UClass* Inner) const {
    if (ExtendedTypeText) {
        *ExtendedTypeText = FString::Printf(TEXT("<%s%s>"), Inner->GetPrefixCPP(), *Inner->GetName());
    }
    return FString(Template);
}

bool FObjectPropertyBase::IsObjectAllowed(const UObject* Value) const {
    if (!Value) {
        return true;
    }
    const UClass* MetaClass = GetRequiredMetaClass();
    if (!Value->IsA(PropertyClass)) {
        return false;
    }
    return !MetaClass || static_cast<const UClass*>(Value)->IsChildOf(MetaClass);
}

bool FObjectPropertyBase::Identical(const void* A, const void* B, uint32 PortFlags) const {
    UObject* const ObjectA = GetObjectPropertyValue(A);
    UObject* const ObjectB = B ? GetObjectPropertyValue(B) : nullptr;
    if (ObjectA == ObjectB) {
        return true;
    }
    // Deep comparison looks into instanced objects of the same class.
    if (!ObjectA || !ObjectB || !(PortFlags & (PPF_DeepComparison | PPF_DeepCompareInstances)) ||
        ObjectA->GetClass() != ObjectB->GetClass() ||
        !HasAnyPropertyFlags(CPF_InstancedReference | CPF_PersistentInstance)) {
        return false;
    }
    for (FProperty* Property = ObjectA->GetClass()->PropertyLink; Property; Property = Property->PropertyLinkNext) {
        for (int32 Index = 0; Index < Property->ArrayDim; ++Index) {
            if (!Property->Identical_InContainer(ObjectA, ObjectB, Index, PortFlags)) {
                return false;
            }
        }
    }
    return true;
}

FString FObjectPropertyBase::GetExportPath(
    const UObject* Object, const UObject* Parent, const UObject* ExportRootScope, const uint32 PortFlags) {
    return Object ? FString::Printf(TEXT("%s'%s'"), *Object->GetClass()->GetPathName(), *Object->GetPathName())
                  : FString(TEXT("None"));
}

EXPORT_TEXT(FObjectPropertyBase) {
    const UObject* Object = GetObjectPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType));
    if (!Object) {
        ValueStr += TEXT("None");
        return;
    }
    const FString Path = GetExportPath(Object, Parent, ExportRootScope, static_cast<uint32>(PortFlags));
    ValueStr += PortFlags & PPF_Delimited ? PropertyText::Quote(Path) : Path;
}

bool FObjectPropertyBase::ParseObjectPropertyValue(const FProperty* Property, UObject* OwnerObject,
    UClass* RequiredMetaClass, uint32 PortFlags, const TCHAR*& Buffer, TObjectPtr<UObject>& OutResolvedValue) {
    PropertyText::FReader Reader(Buffer);
    Reader.SkipSpace();
    FString Token;
    if (!Reader.ReadToken(Token)) {
        return false;
    }
    if (Token.IsEmpty() || Token.Equals(TEXT("None"), ESearchCase::IgnoreCase) ||
        Token.Equals(TEXT("nullptr"), ESearchCase::IgnoreCase)) {
        OutResolvedValue = nullptr;
        Buffer = Reader.Cursor();
        return true;
    }
    UObject* Object = nullptr;
    if (Token.StartsWith(TEXT("/")) || Token.Contains(TEXT("'")) || Token.Contains(TEXT("."))) {
        Object = StaticLoadObject(RequiredMetaClass, nullptr, *Token, nullptr, LOAD_NoWarn | LOAD_Quiet);
    }
    if (!Object && OwnerObject) {
        Object = StaticFindObject(RequiredMetaClass, OwnerObject, *Token);
    }
    if (!Object) {
        Object = StaticFindFirstObject(RequiredMetaClass, *Token);
    }
    if (!Object || !Object->IsA(RequiredMetaClass)) {
        return false;
    }
    OutResolvedValue = Object;
    Buffer = Reader.Cursor();
    return true;
}

IMPORT_TEXT(FObjectPropertyBase) {
    TObjectPtr<UObject> Object;
    const TCHAR* Cursor = Buffer;
    if (!ParseObjectPropertyValue(this, OwnerObject, PropertyClass, static_cast<uint32>(PortFlags), Cursor, Object) ||
        !IsObjectAllowed(Object)) {
        PropertyText::FReader Reader(Buffer);
        const UClass* MetaClass = GetRequiredMetaClass();
        PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: '%s' is no %s%s"), *GetName(), *Reader.Rest(),
                                            MetaClass ? TEXT("child class of ") : TEXT(""),
                                            *(MetaClass ? MetaClass : PropertyClass.Get())->GetName()));
        return nullptr;
    }
    SetObjectPropertyValue(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType), Object);
    return Cursor;
}

// ---------------------------------------------------------------------------------------------------------------------------

FString FObjectProperty::GetCPPType(FString* ExtendedTypeText, uint32 CPPExportFlags) const {
    if (HasAnyPropertyFlags(CPF_TObjectPtr) && !(CPPExportFlags & (CPPF_NoTObjectPtr | CPPF_ArgumentOrReturnValue))) {
        return FString::Printf(TEXT("TObjectPtr<%s%s>"), PropertyClass->GetPrefixCPP(), *PropertyClass->GetName());
    }
    return FString::Printf(TEXT("%s%s*"), PropertyClass->GetPrefixCPP(), *PropertyClass->GetName());
}
void FObjectProperty::CollectReferences(void* Value, FReferenceCollector& Collector, const UObject* Referencer) const {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        Collector.AddReferencedObject(GetPropertyValuePtr(Value)[Index], Referencer, this);
    }
}
FString FWeakObjectProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    return FString::Printf(TEXT("%s<%s%s>"),
        HasAnyPropertyFlags(CPF_AutoWeak) ? TEXT("TAutoWeakObjectPtr") : TEXT("TWeakObjectPtr"),
        PropertyClass->GetPrefixCPP(), *PropertyClass->GetName());
}
FString FLazyObjectProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    return FString::Printf(TEXT("TLazyObjectPtr<%s%s>"), PropertyClass->GetPrefixCPP(), *PropertyClass->GetName());
}
EXPORT_TEXT(FLazyObjectProperty) {
    ValueStr +=
        GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType)).GetUniqueID().ToString();
}
IMPORT_TEXT(FLazyObjectProperty) {
    PropertyText::FReader Reader(Buffer);
    FString Token;
    FUniqueObjectGuid Guid;
    FLazyObjectPtr& Value = *GetPropertyValuePtr(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    if (!Reader.ReadToken(Token)) {
        return nullptr;
    }
    if (Token == TEXT("None")) {
        Value.Reset();
        return Reader.Cursor();
    }
    if (Guid.FromString(Token)) {
        Value = Guid;
        return Reader.Cursor();
    }
    return FObjectPropertyBase::ImportText_Internal(
        Buffer, ContainerOrPropertyPtr, PropertyPointerType, OwnerObject, PortFlags, ErrorText);
}
FString FSoftObjectProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    return FString::Printf(TEXT("TSoftObjectPtr<%s%s>"), PropertyClass->GetPrefixCPP(), *PropertyClass->GetName());
}
EXPORT_TEXT(FSoftObjectProperty) {
    const FString Path = GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType)).ToString();
    if (Path.IsEmpty()) {
        ValueStr += TEXT("None");
    } else {
        ValueStr += PortFlags & PPF_Delimited ? PropertyText::Quote(Path) : Path;
    }
}
IMPORT_TEXT(FSoftObjectProperty) {
    PropertyText::FReader Reader(Buffer);
    Reader.SkipSpace();
    FString Token;
    if (!Reader.ReadToken(Token)) {
        PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: quote is not closed"), *GetName()));
        return nullptr;
    }
    FSoftObjectPtr& Value = *GetPropertyValuePtr(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    Value = Token == TEXT("None") ? FSoftObjectPath() : FSoftObjectPath(Token);
    return Reader.Cursor();
}
FString FClassProperty::GetCPPType(FString* ExtendedTypeText, uint32 CPPExportFlags) const {
    if (HasAnyPropertyFlags(CPF_UObjectWrapper) && !HasAnyPropertyFlags(CPF_TObjectPtr)) {
        return FString::Printf(TEXT("TSubclassOf<%s%s>"), MetaClass->GetPrefixCPP(), *MetaClass->GetName());
    }
    return FObjectProperty::GetCPPType(ExtendedTypeText, CPPExportFlags);
}
FString FSoftClassProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    return FString::Printf(TEXT("TSoftClassPtr<%s%s>"), MetaClass->GetPrefixCPP(), *MetaClass->GetName());
}

// ---------------------------------------------------------------------------------------------------------------------------

FString FInterfaceProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    if (ExtendedTypeText) {
        *ExtendedTypeText = FString::Printf(TEXT("<I%s>"), *InterfaceClass->GetName());
    }
    return FString(TEXT("TScriptInterface"));
}
void FInterfaceProperty::CollectReferences(
    void* Value, FReferenceCollector& Collector, const UObject* Referencer) const {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        FScriptInterface& Interface = GetPropertyValuePtr(Value)[Index];
        Collector.AddReferencedObject(Interface.GetObjectRef(), Referencer, this);
        if (!Interface.GetObject()) {
            Interface.SetInterface(nullptr);
        }
    }
}
EXPORT_TEXT(FInterfaceProperty) {
    const UObject* Object =
        GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType)).GetObject();
    const FString Path = FObjectPropertyBase::GetExportPath(Object);
    ValueStr += Object && (PortFlags & PPF_Delimited) ? PropertyText::Quote(Path) : Path;
}
IMPORT_TEXT(FInterfaceProperty) {
    TObjectPtr<UObject> Object;
    const TCHAR* Cursor = Buffer;
    if (!FObjectPropertyBase::ParseObjectPropertyValue(
            this, OwnerObject, UObject::StaticClass(), static_cast<uint32>(PortFlags), Cursor, Object) ||
        (Object && !Object->GetClass()->ImplementsInterface(InterfaceClass))) {
        PropertyText::FReader Reader(Buffer);
        PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: '%s' does not implement %s"), *GetName(),
                                            *Reader.Rest(), *InterfaceClass->GetName()));
        return nullptr;
    }
    FScriptInterface& Value = *GetPropertyValuePtr(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    Value.SetObject(Object);
    Value.SetInterface(Object ? Object->GetInterfaceAddress(InterfaceClass) : nullptr);
    return Cursor;
}
