// SPDX-License-Identifier: MIT
// FProperty.
#include "UObject/Property.h"

#include "PropertyText.h"
#include "UObject/UnrealType.h"

IMPLEMENT_ABSTRACT_FIELD(FProperty)

void FProperty::Link() { LinkInternal(); }

int32 FProperty::SetupOffset(int32 CurrentSize) {
    Offset_Internal = Align(CurrentSize, GetMinAlignment());
    return Offset_Internal + GetSize();
}

bool FProperty::IdenticalAll(const void* A, const void* B, uint32 PortFlags) const {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        if (!Identical(static_cast<const uint8*>(A) + Index * ElementSize,
                B ? static_cast<const uint8*>(B) + Index * ElementSize : nullptr, PortFlags)) {
            return false;
        }
    }
    return true;
}

void* FProperty::AllocateAndInitializeValue() const {
    void* Memory = FMemory::MallocZeroed(static_cast<SIZE_T>(GetSize()), static_cast<uint32>(GetMinAlignment()));
    InitializeValue(Memory);
    return Memory;
}
void FProperty::DestroyAndFreeValue(void* InMemory) const {
    if (InMemory) {
        DestroyValue(InMemory);
        FMemory::Free(InMemory);
    }
}
uint32 FProperty::GetValueTypeHash(const void* Src) const {
    checkf(HasAnyPropertyFlags(CPF_HasGetValueTypeHash), TEXT("Values of %s have no hash"), *GetPathName());
    return GetValueTypeHashInternal(Src);
}

// ---------------------------------------------------------------------------------------------------------------------------

void FProperty::CallSetter(void* Container, const void* InValue) const {
    checkf(SetterFunction, TEXT("%s has no native setter"), *GetPathName());
    SetterFunction(Container, InValue);
}
void FProperty::CallGetter(const void* Container, void* OutValue) const {
    checkf(GetterFunction, TEXT("%s has no native getter"), *GetPathName());
    GetterFunction(Container, OutValue);
}
void FProperty::GetValue_InContainer(void const* InContainer, void* OutValue) const {
    if (HasGetter()) {
        CallGetter(InContainer, OutValue);
    } else {
        CopyCompleteValue(OutValue, ContainerPtrToValuePtr<void>(InContainer));
    }
}
void FProperty::SetValue_InContainer(void* OutContainer, void const* InValue) const {
    if (HasSetter()) {
        CallSetter(OutContainer, InValue);
    } else {
        CopyCompleteValue(ContainerPtrToValuePtr<void>(OutContainer), InValue);
    }
}
void FProperty::GetSingleValue_InContainer(const void* InContainer, void* OutValue, int32 ArrayIndex) const {
    if (!HasGetter()) {
        CopySingleValue(OutValue, ContainerPtrToValuePtr<void>(InContainer, ArrayIndex));
        return;
    }
    void* Whole = AllocateAndInitializeValue();
    CallGetter(InContainer, Whole);
    CopySingleValue(OutValue, static_cast<uint8*>(Whole) + ArrayIndex * ElementSize);
    DestroyAndFreeValue(Whole);
}
void FProperty::SetSingleValue_InContainer(void* OutContainer, const void* InValue, int32 ArrayIndex) const {
    if (!HasSetter()) {
        CopySingleValue(ContainerPtrToValuePtr<void>(OutContainer, ArrayIndex), InValue);
        return;
    }
    void* Whole = AllocateAndInitializeValue();
    GetValue_InContainer(OutContainer, Whole);
    CopySingleValue(static_cast<uint8*>(Whole) + ArrayIndex * ElementSize, InValue);
    CallSetter(OutContainer, Whole);
    DestroyAndFreeValue(Whole);
}
void FProperty::PerformOperationWithSetter(
    void* OutContainer, void* DirectPropertyAddress, TFunctionRef<void(void*)> DirectValueAccessFunc) const {
    if (!OutContainer || !HasSetterOrGetter()) {
        DirectValueAccessFunc(
            DirectPropertyAddress ? DirectPropertyAddress : ContainerPtrToValuePtr<void>(OutContainer));
        return;
    }
    void* Value = AllocateAndInitializeValue();
    GetValue_InContainer(OutContainer, Value);
    DirectValueAccessFunc(Value);
    SetValue_InContainer(OutContainer, Value);
    DestroyAndFreeValue(Value);
}
void FProperty::PerformOperationWithGetter(void* OutContainer, const void* DirectPropertyAddress,
    TFunctionRef<void(const void*)> DirectValueAccessFunc) const {
    if (!OutContainer || !HasGetter()) {
        DirectValueAccessFunc(
            DirectPropertyAddress ? DirectPropertyAddress : ContainerPtrToValuePtr<void>(OutContainer));
        return;
    }
    void* Value = AllocateAndInitializeValue();
    CallGetter(OutContainer, Value);
    DirectValueAccessFunc(Value);
    DestroyAndFreeValue(Value);
}

// ---------------------------------------------------------------------------------------------------------------------------

void FProperty::ExportTextItem_InContainer(FString& ValueStr, const void* Container, const void* DefaultValue,
    UObject* Parent, int32 PortFlags, UObject* ExportRootScope) const {
    PerformOperationWithGetter(const_cast<void*>(Container), nullptr, [&](const void* Value) {
        ExportText_Internal(
            ValueStr, Value, EPropertyPointerType::Direct, DefaultValue, Parent, PortFlags, ExportRootScope);
    });
}
bool FProperty::ExportText_Direct(FString& ValueStr, const void* Data, const void* Delta, UObject* Parent,
    int32 PortFlags, UObject* ExportRootScope) const {
    if (Data == Delta && Data) {
        ExportText_Internal(ValueStr, Data, EPropertyPointerType::Direct, nullptr, Parent, PortFlags, ExportRootScope);
        return true;
    }
    if (Delta && Identical(Data, Delta, static_cast<uint32>(PortFlags))) {
        return false;
    }
    ExportText_Internal(ValueStr, Data, EPropertyPointerType::Direct, Delta, Parent, PortFlags, ExportRootScope);
    return true;
}
bool FProperty::ExportText_InContainer(int32 Index, FString& ValueStr, const void* Data, const void* Delta,
    UObject* Parent, int32 PortFlags, UObject* ExportRootScope) const {
    return ExportText_Direct(ValueStr, ContainerPtrToValuePtr<void>(Data, Index),
        Delta ? ContainerPtrToValuePtr<void>(Delta, Index) : nullptr, Parent, PortFlags, ExportRootScope);
}
const TCHAR* FProperty::ImportText_InContainer(
    const TCHAR* Buffer, void* Container, UObject* OwnerObject, int32 PortFlags, FOutputDevice* ErrorText) const {
    if (!ValidateImportFlags(static_cast<uint32>(PortFlags), ErrorText)) {
        return nullptr;
    }
    if (!HasSetter()) {
        return ImportText_Internal(Buffer, ContainerPtrToValuePtr<void>(Container), EPropertyPointerType::Direct,
            OwnerObject, PortFlags, ErrorText);
    }
    void* Value = AllocateAndInitializeValue();
    GetValue_InContainer(Container, Value);
    const TCHAR* Result =
        ImportText_Internal(Buffer, Value, EPropertyPointerType::Direct, OwnerObject, PortFlags, ErrorText);
    if (Result) {
        CallSetter(Container, Value);
    }
    DestroyAndFreeValue(Value);
    return Result;
}
bool FProperty::ValidateImportFlags(uint32 PortFlags, FOutputDevice* ErrorText) const {
    if ((PortFlags & PPF_RestrictImportTypes) && HasAnyPropertyFlags(CPF_Config | CPF_Transient)) {
        PropertyText::Report(ErrorText,
            FString::Printf(TEXT("%s is transient or configured and may not be imported here"), *GetPathName()));
        return false;
    }
    return true;
}
bool FProperty::ShouldDuplicateValue() const { return !HasAnyPropertyFlags(CPF_DuplicateTransient | CPF_Transient); }
const FProperty* FProperty::GetOwnerProperty() const {
    const FProperty* Result = this;
    while (const FProperty* Outer = Result->GetOwner<FProperty>()) {
        Result = Outer;
    }
    return Result;
}

// ---------------------------------------------------------------------------------------------------------------------------

namespace PropertyText {
void Report(FOutputDevice* ErrorText, const FString& Message) {
    if (ErrorText) {
        ErrorText->Logf(TEXT("%s"), *Message);
    }
}

FString Quote(const FString& Text) {
    FString Result(TEXT("\""));
    for (int32 Index = 0; Index < Text.Len(); ++Index) {
        const TCHAR Character = Text[Index];
        switch (Character) {
        case TCHAR('"'):
            Result += TEXT("\\\"");
            break;
        case TCHAR('\\'):
            Result += TEXT("\\\\");
            break;
        case TCHAR('\n'):
            Result += TEXT("\\n");
            break;
        case TCHAR('\r'):
            Result += TEXT("\\r");
            break;
        case TCHAR('\t'):
            Result += TEXT("\\t");
            break;
        default:
            Result.AppendChar(Character);
        }
    }
    Result.AppendChar(TCHAR('"'));
    return Result;
}

FString FReader::ReadName() {
    FString Result;
    while (FChar::IsAlnum(*Text) || *Text == TCHAR('_') || *Text > 127) {
        Result.AppendChar(*Text++);
    }
    return Result;
}

FString FReader::ReadNumber() {
    FString Result;
    while (FChar::IsAlnum(*Text) || *Text == TCHAR('+') || *Text == TCHAR('-') || *Text == TCHAR('.')) {
        Result.AppendChar(*Text++);
    }
    return Result;
}
int32 FReader::ReadInt() { return FCString::Atoi(*ReadNumber()); }

bool FReader::ReadQuoted(FString& Out) {
    if (!Accept('"')) {
        return false;
    }
    Out.Reset();
    while (*Text && *Text != TCHAR('"')) {
        TCHAR Character = *Text++;
        if (Character == TCHAR('\\') && *Text) {
            const TCHAR Escaped = *Text++;
            Character = Escaped == TCHAR('n')   ? TCHAR('\n')
                        : Escaped == TCHAR('r') ? TCHAR('\r')
                        : Escaped == TCHAR('t') ? TCHAR('\t')
                                                : Escaped;
        }
        Out.AppendChar(Character);
    }
    return Accept('"');
}

bool FReader::ReadToken(FString& Out, bool bAllowSpaces) {
    if (Is('"')) {
        return ReadQuoted(Out);
    }
    Out.Reset();
    bool bInQuotes = false;
    while (*Text) {
        // Object paths may carry single quotes with anything between them.
        if (*Text == TCHAR('\'')) {
            bInQuotes = !bInQuotes;
        } else if (!bInQuotes &&
                   (*Text == TCHAR(',') || *Text == TCHAR(')') || *Text == TCHAR('\n') || *Text == TCHAR('\r') ||
                       (!bAllowSpaces && (*Text == TCHAR(' ') || *Text == TCHAR('\t'))))) {
            break;
        }
        Out.AppendChar(*Text++);
    }
    return true;
}

FString FReader::Rest() const {
    FString Result;
    for (const TCHAR* Cursor = Text; *Cursor && Result.Len() < 24; ++Cursor) {
        Result.AppendChar(*Cursor);
    }
    return Result;
}
} // namespace PropertyText
