// SPDX-License-Identifier: MIT
// Number, bool, enum, string, name and text properties.
#include "UObject/PropertySimple.h"

#include "PropertyText.h"
#include "UObject/FieldPathProperty.h"
#include "UObject/UnrealType.h"

IMPLEMENT_ABSTRACT_FIELD(FNumericProperty)
IMPLEMENT_FIELD(FInt8Property)
IMPLEMENT_FIELD(FInt16Property)
IMPLEMENT_FIELD(FIntProperty)
IMPLEMENT_FIELD(FInt64Property)
IMPLEMENT_FIELD(FUInt16Property)
IMPLEMENT_FIELD(FUInt32Property)
IMPLEMENT_FIELD(FUInt64Property)
IMPLEMENT_FIELD(FFloatProperty)
IMPLEMENT_FIELD(FDoubleProperty)
IMPLEMENT_FIELD(FByteProperty)
IMPLEMENT_FIELD(FBoolProperty)
IMPLEMENT_FIELD(FEnumProperty)
IMPLEMENT_FIELD(FStrProperty)
IMPLEMENT_FIELD(FNameProperty)
IMPLEMENT_FIELD(FTextProperty)
IMPLEMENT_FIELD(FFieldPathProperty)

#define EXPORT_TEXT(TClass)                                                                                            \
    void TClass::ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,                          \
        EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,          \
        UObject* ExportRootScope) const
#define IMPORT_TEXT(TClass)                                                                                            \
    const TCHAR* TClass::ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,                        \
        EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags, FOutputDevice* ErrorText)     \
        const

namespace {
/** Reads an enum entry by name or value. */
const TCHAR* ImportEnum(
    const FProperty* Property, const UEnum* Enum, const TCHAR* Buffer, int64& OutValue, FOutputDevice* ErrorText) {
    PropertyText::FReader Reader(Buffer);
    FString Token;
    if (Reader.Is('"')) {
        if (!Reader.ReadQuoted(Token)) {
            PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: quote is not closed"), *Property->GetName()));
            return nullptr;
        }
    } else {
        const bool bNegative = Reader.Accept('-');
        for (;;) {
            Token += Reader.ReadName();
            if (Reader.Is(':')) {
                Reader.Accept(':');
                Token += TEXT(":");
            } else {
                break;
            }
        }
        if (bNegative) {
            Token = FString(TEXT("-")) + Token;
        }
    }
    const int32 Index = Enum->GetIndexByNameString(Token);
    if (Index != INDEX_NONE) {
        OutValue = Enum->GetValueByIndex(Index);
        return Reader.Cursor();
    }
    if (Token.IsNumeric()) {
        OutValue = FCString::Atoi64(*Token);
        return Reader.Cursor();
    }
    PropertyText::Report(
        ErrorText, FString::Printf(TEXT("%s: '%s' is no entry of %s"), *Property->GetName(), *Token, *Enum->GetName()));
    return nullptr;
}
FString EnumText(const UEnum* Enum, int64 Value) {
    const int32 Index = Enum->GetIndexByValue(Value);
    if (Index != INDEX_NONE) {
        return Enum->GetNameStringByIndex(Index);
    }
    return LexToString(Value);
}
} // namespace

// ---- numbers

bool FNumericProperty::SetNumericPropertyValueFromString(void* Data, const TCHAR* Value) const {
    const FString Text(Value);
    if (Text.IsEmpty()) {
        return false;
    }
    const FTCHARToUTF8 Utf8(*Text);
    const char* const Begin = reinterpret_cast<const char*>(Utf8.Get());
    char* End = nullptr;
    if (IsFloatingPoint()) {
        const double Number = strtod(Begin, &End);
        if (*End == 'f' || *End == 'F') {
            ++End;
        }
        if (End == Begin || *End) {
            return false;
        }
        SetFloatingPointPropertyValue(Data, Number);
        return true;
    }
    if (IsSigned()) {
        const long long Number = strtoll(Begin, &End, 0);
        if (End == Begin) {
            return false;
        }
        if (*End == '.') {
            // As UE: "1.5" for an integer is 1.
            SetIntPropertyValue(Data, static_cast<int64>(strtod(Begin, &End)));
        } else {
            SetIntPropertyValue(Data, static_cast<int64>(Number));
        }
    } else {
        const unsigned long long Number = strtoull(Begin, &End, 0);
        if (End == Begin) {
            return false;
        }
        if (*End == '.') {
            SetIntPropertyValue(Data, static_cast<uint64>(strtod(Begin, &End)));
        } else {
            SetIntPropertyValue(Data, static_cast<uint64>(Number));
        }
    }
    return *End == 0;
}
FString FNumericProperty::GetNumericPropertyValueToString(void const* Data) const {
    if (IsFloatingPoint()) {
        return FString::Printf(TEXT("%f"), GetFloatingPointPropertyValue(Data));
    }
    return IsSigned() ? LexToString(GetSignedIntPropertyValue(Data)) : LexToString(GetUnsignedIntPropertyValue(Data));
}
EXPORT_TEXT(FNumericProperty) {
    ValueStr += GetNumericPropertyValueToString(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType));
}
IMPORT_TEXT(FNumericProperty) {
    PropertyText::FReader Reader(Buffer);
    Reader.SkipSpace();
    const bool bQuoted = Reader.Accept('"');
    const FString Token = Reader.ReadNumber();
    if (!SetNumericPropertyValueFromString(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType), *Token)) {
        PropertyText::Report(ErrorText,
            FString::Printf(TEXT("%s: a number is expected, found '%s'"), *GetName(), *(Token + Reader.Rest())));
        return nullptr;
    }
    if (bQuoted) {
        Reader.Accept('"');
    }
    return Reader.Cursor();
}

FString FByteProperty::GetCPPType(FString* ExtendedTypeText, uint32 CPPExportFlags) const {
    if (!Enum) {
        return FString(TEXT("uint8"));
    }
    if (Enum->GetCppForm() == UEnum::ECppForm::EnumClass) {
        return Enum->CppType;
    }
    return FString::Printf(TEXT("TEnumAsByte<%s>"), *Enum->CppType);
}
EXPORT_TEXT(FByteProperty) {
    const void* Value = PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType);
    if (!Enum) {
        FNumericProperty::ExportText_Internal(
            ValueStr, Value, EPropertyPointerType::Direct, DefaultValue, Parent, PortFlags, ExportRootScope);
        return;
    }
    ValueStr += EnumText(Enum, GetPropertyValue(Value));
}
IMPORT_TEXT(FByteProperty) {
    void* Value = PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType);
    if (!Enum) {
        return FNumericProperty::ImportText_Internal(
            Buffer, Value, EPropertyPointerType::Direct, OwnerObject, PortFlags, ErrorText);
    }
    int64 Imported = 0;
    const TCHAR* Result = ImportEnum(this, Enum, Buffer, Imported, ErrorText);
    if (Result) {
        SetPropertyValue(Value, static_cast<uint8>(Imported));
    }
    return Result;
}

// ---- bool

void FBoolProperty::SetBoolSize(const uint32 InSize, const bool bIsNativeBool, const uint32 InBitMask) {
    ElementSize = static_cast<int32>(InSize);
    FieldSize = static_cast<uint8>(InSize);
    ByteOffset = 0;
    if (bIsNativeBool) {
        ByteMask = 1;
        FieldMask = 0xff;
        return;
    }
    uint32 Mask = InBitMask ? InBitMask : 1;
    while (Mask > 0xff) {
        ++ByteOffset;
        Mask >>= 8;
    }
    ByteMask = FieldMask = static_cast<uint8>(Mask);
}
void FBoolProperty::LinkInternal() {
    if (ElementSize == 0) {
        SetBoolSize(sizeof(bool), true);
    }
    PropertyFlags |= CPF_NoDestructor | CPF_HasGetValueTypeHash;
    if (IsNativeBool()) {
        // Bits share their byte with others and cannot be copied or cleared by byte.
        PropertyFlags |= CPF_IsPlainOldData | CPF_ZeroConstructor;
    }
}
void FBoolProperty::CopyValuesInternal(void* Dest, void const* Src, int32 Count) const {
    for (int32 Index = 0; Index < Count; ++Index) {
        SetPropertyValue(static_cast<uint8*>(Dest) + Index * ElementSize,
            GetPropertyValue(static_cast<const uint8*>(Src) + Index * ElementSize));
    }
}
void FBoolProperty::InitializeValueInternal(void* Dest) const {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        SetPropertyValue(static_cast<uint8*>(Dest) + Index * ElementSize, false);
    }
}
FString FBoolProperty::GetCPPType(FString* ExtendedTypeText, uint32 CPPExportFlags) const {
    if (IsNativeBool() || (CPPExportFlags & (CPPF_ArgumentOrReturnValue | CPPF_Implementation))) {
        return FString(TEXT("bool"));
    }
    return FString::Printf(TEXT("uint%d"), ElementSize * 8);
}
EXPORT_TEXT(FBoolProperty) {
    ValueStr += GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType)) ? TEXT("True")
                                                                                                   : TEXT("False");
}
IMPORT_TEXT(FBoolProperty) {
    PropertyText::FReader Reader(Buffer);
    Reader.SkipSpace();
    FString Token;
    if (Reader.Is('"')) {
        Reader.ReadQuoted(Token);
    } else {
        Token = Reader.ReadName();
    }
    void* Value = PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType);
    if (Token == TEXT("1") || Token.Equals(TEXT("True"), ESearchCase::IgnoreCase) ||
        Token.Equals(TEXT("Yes"), ESearchCase::IgnoreCase)) {
        SetPropertyValue(Value, true);
    } else if (Token == TEXT("0") || Token.Equals(TEXT("False"), ESearchCase::IgnoreCase) ||
               Token.Equals(TEXT("No"), ESearchCase::IgnoreCase)) {
        SetPropertyValue(Value, false);
    } else {
        PropertyText::Report(ErrorText,
            FString::Printf(TEXT("%s: True or False is expected, found '%s'"), *GetName(), *(Token + Reader.Rest())));
        return nullptr;
    }
    return Reader.Cursor();
}

// ---- enum

FEnumProperty::~FEnumProperty() { delete UnderlyingProp; }
void FEnumProperty::LinkInternal() {
    check(UnderlyingProp);
    UnderlyingProp->Link();
    ElementSize = UnderlyingProp->GetElementSize();
    PropertyFlags |= CPF_IsPlainOldData | CPF_NoDestructor | CPF_ZeroConstructor | CPF_HasGetValueTypeHash;
}
FString FEnumProperty::GetCPPType(FString* ExtendedTypeText, uint32 CPPExportFlags) const { return Enum->CppType; }
EXPORT_TEXT(FEnumProperty) {
    const void* Value = PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType);
    ValueStr += EnumText(Enum, UnderlyingProp->GetSignedIntPropertyValue(Value));
}
IMPORT_TEXT(FEnumProperty) {
    int64 Imported = 0;
    const TCHAR* Result = ImportEnum(this, Enum, Buffer, Imported, ErrorText);
    if (Result) {
        UnderlyingProp->SetIntPropertyValue(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType), Imported);
    }
    return Result;
}

// ---- strings, names, texts

void FStrProperty::LinkInternal() {
    FBase::LinkInternal();
    PropertyFlags |= CPF_ZeroConstructor | CPF_HasGetValueTypeHash;
}
bool FStrProperty::Identical(const void* A, const void* B, uint32 PortFlags) const {
    const FString& Left = GetPropertyValue(A);
    return B ? Left.Equals(GetPropertyValue(B), ESearchCase::CaseSensitive) : Left.IsEmpty();
}
uint32 FStrProperty::GetValueTypeHashInternal(const void* Src) const { return GetTypeHash(GetPropertyValue(Src)); }
EXPORT_TEXT(FStrProperty) {
    const FString& Value = GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType));
    ValueStr += PortFlags & PPF_Delimited ? PropertyText::Quote(Value) : Value;
}
IMPORT_TEXT(FStrProperty) {
    FString& Value = *GetPropertyValuePtr(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    if (!(PortFlags & PPF_Delimited)) {
        // Alone, the whole text is the value.
        Value = FString(Buffer);
        return Buffer + Value.Len();
    }
    PropertyText::FReader Reader(Buffer);
    FString Token;
    if (!Reader.ReadToken(Token)) {
        PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: quote is not closed"), *GetName()));
        return nullptr;
    }
    Value = Token;
    return Reader.Cursor();
}

void FNameProperty::LinkInternal() {
    FBase::LinkInternal();
    PropertyFlags |= CPF_ZeroConstructor | CPF_HasGetValueTypeHash;
}
bool FNameProperty::Identical(const void* A, const void* B, uint32 PortFlags) const {
    return GetPropertyValue(A) == GetOptionalPropertyValue(B);
}
uint32 FNameProperty::GetValueTypeHashInternal(const void* Src) const { return GetTypeHash(GetPropertyValue(Src)); }
EXPORT_TEXT(FNameProperty) {
    const FString Value = GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType)).ToString();
    ValueStr += PortFlags & PPF_Delimited ? PropertyText::Quote(Value) : Value;
}
IMPORT_TEXT(FNameProperty) {
    FName& Value = *GetPropertyValuePtr(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    PropertyText::FReader Reader(Buffer);
    FString Token;
    if (!(PortFlags & PPF_Delimited)) {
        Token = FString(Buffer);
        Reader.Set(Buffer + Token.Len());
    } else if (!Reader.ReadToken(Token)) {
        PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: quote is not closed"), *GetName()));
        return nullptr;
    }
    Value = FName(*Token);
    return Reader.Cursor();
}

void FTextProperty::LinkInternal() { FBase::LinkInternal(); }
bool FTextProperty::Identical(const void* A, const void* B, uint32 PortFlags) const {
    return GetPropertyValue(A).ToString().Equals(GetOptionalPropertyValue(B).ToString(), ESearchCase::CaseSensitive);
}
uint32 FTextProperty::GetValueTypeHashInternal(const void* Src) const {
    return GetTypeHash(GetPropertyValue(Src).ToString());
}
EXPORT_TEXT(FTextProperty) {
    const FString Value = GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType)).ToString();
    ValueStr += PortFlags & PPF_Delimited ? PropertyText::Quote(Value) : Value;
}
IMPORT_TEXT(FTextProperty) {
    FText& Value = *GetPropertyValuePtr(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType));
    PropertyText::FReader Reader(Buffer);
    FString Text;
    const FString Whole(Buffer);
    auto StartsWith = [&Whole](const TCHAR* Word) { return Whole.StartsWith(Word, ESearchCase::CaseSensitive); };
    if (StartsWith(TEXT("INVTEXT(")) || StartsWith(TEXT("LOCTEXT(")) || StartsWith(TEXT("NSLOCTEXT("))) {
        // The last quoted argument is the text itself; namespace and key mean nothing without translations.
        Reader.ReadName();
        Reader.Accept('(');
        do {
            Reader.SkipSpace();
            if (!Reader.ReadQuoted(Text)) {
                PropertyText::Report(ErrorText,
                    FString::Printf(TEXT("%s: a quoted text is expected, found '%s'"), *GetName(), *Reader.Rest()));
                return nullptr;
            }
            Reader.SkipSpace();
        } while (Reader.Accept(','));
        if (!Reader.Accept(')')) {
            PropertyText::Report(
                ErrorText, FString::Printf(TEXT("%s: ')' is expected, found '%s'"), *GetName(), *Reader.Rest()));
            return nullptr;
        }
    } else if (!(PortFlags & PPF_Delimited)) {
        Text = Whole;
        Reader.Set(Buffer + Text.Len());
    } else if (!Reader.ReadToken(Text)) {
        PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: quote is not closed"), *GetName()));
        return nullptr;
    }
    Value = Text.IsEmpty() ? FText::GetEmpty() : FText::FromString(Text);
    return Reader.Cursor();
}

// ---- field paths

FField* FFieldPath::GetTyped(FFieldClass* Type) const {
    int32 Colon = INDEX_NONE;
    if (!Path.FindLastChar(TCHAR(':'), Colon)) {
        return nullptr;
    }
    const UStruct* Owner = FindObject<UStruct>(nullptr, *Path.Left(Colon));
    FProperty* Property = Owner ? Owner->FindPropertyByName(FName(*Path.Mid(Colon + 1))) : nullptr;
    return Property && Property->IsA(Type) ? Property : nullptr;
}
FString FFieldPathProperty::GetCPPType(FString* ExtendedTypeText, uint32 CPPExportFlags) const {
    if (ExtendedTypeText) {
        *ExtendedTypeText = FString::Printf(TEXT("<F%s>"), *PropertyClass->GetName());
    }
    return FString(TEXT("TFieldPath"));
}
EXPORT_TEXT(FFieldPathProperty) {
    const FString Value = GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType)).ToString();
    ValueStr += PortFlags & PPF_Delimited ? PropertyText::Quote(Value) : Value;
}
IMPORT_TEXT(FFieldPathProperty) {
    PropertyText::FReader Reader(Buffer);
    FString Token;
    if (!Reader.ReadToken(Token)) {
        PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: quote is not closed"), *GetName()));
        return nullptr;
    }
    *GetPropertyValuePtr(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType)) =
        Token == TEXT("None") ? FFieldPath() : FFieldPath(*Token);
    return Reader.Cursor();
}
