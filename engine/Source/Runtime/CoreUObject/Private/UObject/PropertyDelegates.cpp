// SPDX-License-Identifier: MIT
// Delegate properties, script delegates and sparse delegates.
#include "UObject/PropertyDelegates.h"

#include <map>
#include <unordered_map>

#include "ObjectSystem.h"
#include "PropertyText.h"
#include "UObject/UnrealType.h"

IMPLEMENT_FIELD(FDelegateProperty)
IMPLEMENT_ABSTRACT_FIELD(FMulticastDelegateProperty)
IMPLEMENT_FIELD(FMulticastInlineDelegateProperty)
IMPLEMENT_FIELD(FMulticastSparseDelegateProperty)

bool FScriptDelegate::IsBound() const {
    if (FunctionName.IsNone()) {
        return false;
    }
    const UObject* Target = Object.Get();
    return Target && Target->FindFunction(FunctionName) != nullptr;
}
FString FScriptDelegate::ToString() const {
    return IsBound() ? Object.Get()->GetPathName() + TEXT(".") + FunctionName.ToString() : FString(TEXT("<Unbound>"));
}
void FScriptDelegate::ProcessDelegate(void* Parameters) const {
    UObject* Target = Object.Get();
    checkf(Target, TEXT("A dynamic delegate was executed that is not bound or whose object is gone (function '%s')"),
        *FunctionName.ToString());
    Target->ProcessEvent(Target->FindFunctionChecked(FunctionName), Parameters);
}

bool FMulticastScriptDelegate::IsBound() const {
    for (const FScriptDelegate& Delegate : InvocationList) {
        if (Delegate.IsBound()) {
            return true;
        }
    }
    return false;
}
bool FMulticastScriptDelegate::Contains(const UObject* InObject, FName InFunctionName) const {
    for (const FScriptDelegate& Delegate : InvocationList) {
        if (Delegate.GetFunctionName() == InFunctionName && Delegate.IsBoundToObjectEvenIfUnreachable(InObject)) {
            return true;
        }
    }
    return false;
}
void FMulticastScriptDelegate::CompactInvocationList() const {
    InvocationList.RemoveAll([](const FScriptDelegate& Delegate) { return Delegate.IsCompactable(); });
}
void FMulticastScriptDelegate::Add(const FScriptDelegate& InDelegate) {
    CompactInvocationList();
    ensureMsgf(!InvocationList.Contains(InDelegate), TEXT("%s is bound to this delegate already; use AddUnique"),
        *InDelegate.ToString());
    InvocationList.Add(InDelegate);
}
void FMulticastScriptDelegate::AddUnique(const FScriptDelegate& InDelegate) {
    CompactInvocationList();
    InvocationList.AddUnique(InDelegate);
}
void FMulticastScriptDelegate::Remove(const FScriptDelegate& InDelegate) {
    InvocationList.Remove(InDelegate);
    CompactInvocationList();
}
void FMulticastScriptDelegate::Remove(const UObject* InObject, FName InFunctionName) {
    InvocationList.RemoveAll([InObject, InFunctionName](const FScriptDelegate& Delegate) {
        return Delegate.GetFunctionName() == InFunctionName && Delegate.IsBoundToObjectEvenIfUnreachable(InObject);
    });
    CompactInvocationList();
}
void FMulticastScriptDelegate::RemoveAll(const UObject* Object) {
    InvocationList.RemoveAll(
        [Object](const FScriptDelegate& Delegate) { return Delegate.IsBoundToObjectEvenIfUnreachable(Object); });
    CompactInvocationList();
}
bool FMulticastScriptDelegate::operator==(const FMulticastScriptDelegate& Other) const {
    if (InvocationList.Num() != Other.InvocationList.Num()) {
        return false;
    }
    for (const FScriptDelegate& Delegate : InvocationList) {
        if (!Other.InvocationList.Contains(Delegate)) {
            return false;
        }
    }
    return true;
}
FString FMulticastScriptDelegate::ToString() const {
    FString Result(TEXT("["));
    for (const FScriptDelegate& Delegate : InvocationList) {
        Result += (Result.Len() > 1 ? FString(TEXT(", ")) : FString()) + Delegate.ToString();
    }
    return Result + TEXT("]");
}
void FMulticastScriptDelegate::ProcessMulticastDelegate(void* Parameters) const {
    // Handlers may add and remove delegates: call a copy, and only what is still bound when its turn comes.
    const InvocationListType Copy = InvocationList;
    for (const FScriptDelegate& Delegate : Copy) {
        if (Delegate.IsBound()) {
            Delegate.ProcessDelegate(Parameters);
        }
    }
    CompactInvocationList();
}
TArray<UObject*> FMulticastScriptDelegate::GetAllObjects() const {
    TArray<UObject*> Result;
    for (const FScriptDelegate& Delegate : InvocationList) {
        if (const UObject* Object = Delegate.GetUObject()) {
            Result.Add(const_cast<UObject*>(Object));
        }
    }
    return Result;
}

namespace UE::CoreUObject::Private {
FName FunctionNameOfExpression(const TCHAR* Expression) {
    const FString Text(Expression);
    const int32 Separator = Text.Find(TEXT("::"), ESearchCase::CaseSensitive, ESearchDir::FromEnd);
    checkf(Separator != INDEX_NONE, TEXT("'%s' does not name a member function as &Class::Function"), Expression);
    return FName(*Text.Mid(Separator + 2).TrimStartAndEnd());
}
} // namespace UE::CoreUObject::Private

// ---------------------------------------------------------------------------------------------------------------------------
// Sparse delegates

namespace {
struct FNameLess {
    bool operator()(const FName& A, const FName& B) const { return A.FastLess(B); }
};
using FListsOfOwner = std::map<FName, FMulticastScriptDelegate, FNameLess>;
std::unordered_map<const UObject*, FListsOfOwner>& SparseLists() {
    static auto& Instance = *new std::unordered_map<const UObject*, FListsOfOwner>;
    return Instance;
}
} // namespace

FMulticastScriptDelegate* FSparseDelegateStorage::GetMulticastDelegate(
    const UObject* DelegateOwner, FName DelegateName) {
    auto Owner = SparseLists().find(DelegateOwner);
    if (Owner == SparseLists().end()) {
        return nullptr;
    }
    auto List = Owner->second.find(DelegateName);
    return List == Owner->second.end() ? nullptr : &List->second;
}
FMulticastScriptDelegate& FSparseDelegateStorage::GetOrCreate(
    FSparseDelegate& Delegate, const UObject* DelegateOwner, FName DelegateName) {
    Delegate.bIsBound = true;
    return SparseLists()[DelegateOwner][DelegateName];
}
void FSparseDelegateStorage::Compact(FSparseDelegate& Delegate, const UObject* DelegateOwner, FName DelegateName) {
    const FMulticastScriptDelegate* List = GetMulticastDelegate(DelegateOwner, DelegateName);
    if (!List || List->GetInvocationList().IsEmpty()) {
        Clear(Delegate, DelegateOwner, DelegateName);
    }
}
void FSparseDelegateStorage::Clear(FSparseDelegate& Delegate, const UObject* DelegateOwner, FName DelegateName) {
    Delegate.bIsBound = false;
    auto Owner = SparseLists().find(DelegateOwner);
    if (Owner != SparseLists().end()) {
        Owner->second.erase(DelegateName);
        if (Owner->second.empty()) {
            SparseLists().erase(Owner);
        }
    }
}
void FSparseDelegateStorage::NotifyObjectDestroyed(const UObject* Owner) { SparseLists().erase(Owner); }

// ---------------------------------------------------------------------------------------------------------------------------
// Properties

namespace {
FString DelegateCppName(const UFunction* Signature) {
    FString Name = Signature->GetName();
    Name.RemoveFromEnd(HEADER_GENERATED_DELEGATE_SIGNATURE_SUFFIX);
    const UClass* Owner = Signature->GetOuterUClass();
    return Owner ? FString::Printf(TEXT("%s%s::F%s"), Owner->GetPrefixCPP(), *Owner->GetName(), *Name)
                 : TEXT("F") + Name;
}
FString DelegateText(const FScriptDelegate& Delegate) {
    const UObject* Object = Delegate.GetUObject();
    return FString::Printf(
        TEXT("%s.%s"), Object ? *Object->GetPathName() : TEXT("(null)"), *Delegate.GetFunctionName().ToString());
}
/** Reads "Path.Function" or "(null).None" into a delegate whose function must fit the signature. */
const TCHAR* ImportDelegate(const FProperty* Property, const UFunction* Signature, const TCHAR* Buffer, UObject* Parent,
    FScriptDelegate& Out, FOutputDevice* ErrorText) {
    PropertyText::FReader Reader(Buffer);
    Reader.SkipSpace();
    FString Token;
    if (Reader.Accept('(')) {
        // "(null).None"
        Token = Reader.ReadName();
        Reader.Accept(')');
        Reader.Accept('.');
        Reader.ReadName();
        Out.Unbind();
        return Reader.Cursor();
    }
    if (!Reader.ReadToken(Token)) {
        PropertyText::Report(ErrorText, FString::Printf(TEXT("%s: quote is not closed"), *Property->GetName()));
        return nullptr;
    }
    if (Token.IsEmpty() || Token == TEXT("None")) {
        Out.Unbind();
        return Reader.Cursor();
    }
    int32 Dot = INDEX_NONE;
    UObject* Object = Parent;
    FString FunctionName = Token;
    if (Token.FindLastChar(TCHAR('.'), Dot)) {
        Object = StaticFindFirstObject(UObject::StaticClass(), *Token.Left(Dot));
        FunctionName = Token.Mid(Dot + 1);
    }
    const UFunction* Function = Object ? Object->FindFunction(FName(*FunctionName)) : nullptr;
    if (!Function || !Signature->IsSignatureCompatibleWith(Function)) {
        PropertyText::Report(ErrorText,
            FString::Printf(TEXT("%s: '%s' %s"), *Property->GetName(), *Token,
                Function ? TEXT("has other parameters than the delegate") : TEXT("is no function of an object")));
        return nullptr;
    }
    Out.BindUFunction(Object, FName(*FunctionName));
    return Reader.Cursor();
}
} // namespace

FString FDelegateProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    return DelegateCppName(SignatureFunction);
}
void FDelegateProperty::ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,
    EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,
    UObject* ExportRootScope) const {
    ValueStr += DelegateText(GetPropertyValue(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType)));
}
const TCHAR* FDelegateProperty::ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,
    EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags, FOutputDevice* ErrorText) const {
    FScriptDelegate Delegate;
    const TCHAR* Result = ImportDelegate(this, SignatureFunction, Buffer, OwnerObject, Delegate, ErrorText);
    if (Result) {
        SetPropertyValue(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType), Delegate);
    }
    return Result;
}

FString FMulticastDelegateProperty::GetCPPType(FString* ExtendedTypeText, uint32) const {
    return DelegateCppName(SignatureFunction);
}
bool FMulticastDelegateProperty::Identical(const void* A, const void* B, uint32) const {
    const FMulticastScriptDelegate* ListA = GetMulticastDelegate(A);
    const FMulticastScriptDelegate* ListB = B ? GetMulticastDelegate(B) : nullptr;
    const bool bEmptyA = !ListA || ListA->GetInvocationList().IsEmpty();
    const bool bEmptyB = !ListB || ListB->GetInvocationList().IsEmpty();
    return bEmptyA || bEmptyB ? bEmptyA == bEmptyB : *ListA == *ListB;
}
void FMulticastDelegateProperty::ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,
    EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,
    UObject* ExportRootScope) const {
    const FMulticastScriptDelegate* List =
        GetMulticastDelegate(PointerToValuePtr(PropertyValueOrContainer, PropertyPointerType));
    ValueStr += TEXT("(");
    bool bFirst = true;
    if (List) {
        for (const FScriptDelegate& Delegate : List->GetInvocationList()) {
            ValueStr += (bFirst ? FString() : FString(TEXT(","))) + DelegateText(Delegate);
            bFirst = false;
        }
    }
    ValueStr += TEXT(")");
}
const TCHAR* FMulticastDelegateProperty::ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,
    EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags, FOutputDevice* ErrorText) const {
    FMulticastScriptDelegate List;
    PropertyText::FReader Reader(Buffer);
    Reader.SkipSpace();
    if (!Reader.Accept('(')) {
        PropertyText::Report(
            ErrorText, FString::Printf(TEXT("%s: '(' is expected, found '%s'"), *GetName(), *Reader.Rest()));
        return nullptr;
    }
    while (!Reader.Accept(')')) {
        FScriptDelegate Delegate;
        const TCHAR* After = ImportDelegate(this, SignatureFunction, Reader.Cursor(), OwnerObject, Delegate, ErrorText);
        if (!After) {
            return nullptr;
        }
        List.AddUnique(Delegate);
        Reader.Set(After);
        Reader.SkipSpace();
        if (!Reader.Accept(',') && !Reader.Is(')')) {
            PropertyText::Report(
                ErrorText, FString::Printf(TEXT("%s: ',' or ')' is expected, found '%s'"), *GetName(), *Reader.Rest()));
            return nullptr;
        }
    }
    SetMulticastDelegate(PointerToValuePtr(ContainerOrPropertyPtr, PropertyPointerType), List);
    return Reader.Cursor();
}

void FMulticastInlineDelegateProperty::LinkInternal() {
    ElementSize = sizeof(FMulticastScriptDelegate);
    PropertyFlags |= CPF_ZeroConstructor;
}
void FMulticastInlineDelegateProperty::CopyValuesInternal(void* Dest, void const* Src, int32 Count) const {
    for (int32 Index = 0; Index < Count; ++Index) {
        static_cast<FMulticastScriptDelegate*>(Dest)[Index] = static_cast<const FMulticastScriptDelegate*>(Src)[Index];
    }
}
void FMulticastInlineDelegateProperty::ClearValueInternal(void* Data) const {
    static_cast<FMulticastScriptDelegate*>(Data)->Clear();
}
void FMulticastInlineDelegateProperty::InitializeValueInternal(void* Dest) const {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        new (static_cast<FMulticastScriptDelegate*>(Dest) + Index) FMulticastScriptDelegate;
    }
}
void FMulticastInlineDelegateProperty::DestroyValueInternal(void* Dest) const {
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        static_cast<FMulticastScriptDelegate*>(Dest)[Index].~FMulticastScriptDelegate();
    }
}
void FMulticastInlineDelegateProperty::SetMulticastDelegate(
    void* PropertyValue, FMulticastScriptDelegate ScriptDelegate) const {
    *static_cast<FMulticastScriptDelegate*>(PropertyValue) = MoveTemp(ScriptDelegate);
}
void FMulticastInlineDelegateProperty::AddDelegate(
    FScriptDelegate ScriptDelegate, UObject* Parent, void* PropertyValue) const {
    static_cast<FMulticastScriptDelegate*>(ResolveValue(Parent, PropertyValue))->AddUnique(ScriptDelegate);
}
void FMulticastInlineDelegateProperty::RemoveDelegate(
    const FScriptDelegate& ScriptDelegate, UObject* Parent, void* PropertyValue) const {
    static_cast<FMulticastScriptDelegate*>(ResolveValue(Parent, PropertyValue))->Remove(ScriptDelegate);
}
void FMulticastInlineDelegateProperty::ClearDelegate(UObject* Parent, void* PropertyValue) const {
    static_cast<FMulticastScriptDelegate*>(ResolveValue(Parent, PropertyValue))->Clear();
}

void FMulticastSparseDelegateProperty::LinkInternal() {
    ElementSize = sizeof(FSparseDelegate);
    PropertyFlags |= CPF_NoDestructor | CPF_ZeroConstructor;
}
void FMulticastSparseDelegateProperty::InitializeValueInternal(void* Dest) const { new (Dest) FSparseDelegate; }
void FMulticastSparseDelegateProperty::ClearValueInternal(void* Data) const { ClearDelegate(nullptr, Data); }
const FMulticastScriptDelegate* FMulticastSparseDelegateProperty::GetMulticastDelegate(
    const void* PropertyValue) const {
    return static_cast<const FSparseDelegate*>(PropertyValue)->IsBound()
               ? FSparseDelegateStorage::GetMulticastDelegate(OwnerOf(PropertyValue), GetFName())
               : nullptr;
}
void FMulticastSparseDelegateProperty::SetMulticastDelegate(
    void* PropertyValue, FMulticastScriptDelegate ScriptDelegate) const {
    FSparseDelegate& Delegate = *static_cast<FSparseDelegate*>(PropertyValue);
    FSparseDelegateStorage::GetOrCreate(Delegate, OwnerOf(PropertyValue), GetFName()) = MoveTemp(ScriptDelegate);
    FSparseDelegateStorage::Compact(Delegate, OwnerOf(PropertyValue), GetFName());
}
void FMulticastSparseDelegateProperty::AddDelegate(
    FScriptDelegate ScriptDelegate, UObject* Parent, void* PropertyValue) const {
    void* Value = ResolveValue(Parent, PropertyValue);
    FSparseDelegateStorage::GetOrCreate(*static_cast<FSparseDelegate*>(Value), OwnerOf(Value), GetFName())
        .AddUnique(ScriptDelegate);
}
void FMulticastSparseDelegateProperty::RemoveDelegate(
    const FScriptDelegate& ScriptDelegate, UObject* Parent, void* PropertyValue) const {
    void* Value = ResolveValue(Parent, PropertyValue);
    if (FMulticastScriptDelegate* List = FSparseDelegateStorage::GetMulticastDelegate(OwnerOf(Value), GetFName())) {
        List->Remove(ScriptDelegate);
        FSparseDelegateStorage::Compact(*static_cast<FSparseDelegate*>(Value), OwnerOf(Value), GetFName());
    }
}
void FMulticastSparseDelegateProperty::ClearDelegate(UObject* Parent, void* PropertyValue) const {
    void* Value = ResolveValue(Parent, PropertyValue);
    FSparseDelegateStorage::Clear(*static_cast<FSparseDelegate*>(Value), OwnerOf(Value), GetFName());
}
