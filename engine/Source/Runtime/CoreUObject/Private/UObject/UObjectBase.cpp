// SPDX-License-Identifier: MIT
#include "UObject/UObjectBase.h"

#include "ObjectSystem.h"
#include "UObject/Class.h"
#include "UObject/Package.h"
#include "UObject/UObjectBaseUtility.h"

namespace {
/** Identity of the object whose constructor starts next on this thread. */
struct FPendingIdentity {
    UClass* Class;
    UObject* Outer;
    FName Name;
    EObjectFlags Flags;
    EInternalObjectFlags InternalFlags;
    bool bSet;
};
thread_local FPendingIdentity GPendingIdentity{};
} // namespace

void* FObjectSystem::AllocateObject(SIZE_T Size, SIZE_T Alignment) {
    // UE promises that members without initialiser are zero.
    return FMemory::MallocZeroed(Size, static_cast<uint32>(Alignment > 16 ? Alignment : 16));
}

void FObjectSystem::SetNextIdentity(
    const UClass* Class, UObject* Outer, FName Name, EObjectFlags Flags, EInternalObjectFlags InternalFlags) {
    GPendingIdentity = {const_cast<UClass*>(Class), Outer, Name, Flags, InternalFlags, true};
}

UObjectBase::UObjectBase() {
    FPendingIdentity& Pending = GPendingIdentity;
    checkf(Pending.bSet, TEXT("Objects can only be made by NewObject or CreateDefaultSubobject"));
    Pending.bSet = false;
    ObjectFlags = Pending.Flags;
    ClassPrivate = Pending.Class;
    NamePrivate = Pending.Name;
    OuterPrivate = Pending.Outer;
    GUObjectArray.AllocateUObjectIndex(this, Pending.InternalFlags);
    if (ClassPrivate) {
        FObjectSystem::Hash(this);
    }
}

UObjectBase::~UObjectBase() {
    // Reached only through the collector or an in-place replacement, both of which ran the destruction steps before.
    if (InternalIndex != INDEX_NONE) {
        if (!NamePrivate.IsNone()) {
            FObjectSystem::Unhash(this);
        }
        FObjectSystem::ForgetObject(static_cast<UObject*>(this));
        GUObjectArray.FreeUObjectIndex(this);
    }
}

void FObjectSystem::DestroyAndFree(UObject* Object) {
    Object->~UObject();
    FMemory::Free(Object);
}

void FObjectSystem::DestroyInPlace(UObject* Object) {
    const SIZE_T Size = static_cast<SIZE_T>(Object->GetClass()->GetPropertiesSize());
    Object->ConditionalBeginDestroy();
    Object->ConditionalFinishDestroy();
    Object->~UObject();
    FMemory::Memzero(Object, Size);
}

bool UObjectBase::IsValidLowLevel() const { return GUObjectArray.IsValid(this); }

bool UObjectBase::IsValidLowLevelFast(bool bRecursive) const {
    const void* Address = this;
    if (reinterpret_cast<UPTRINT>(Address) < 0x100 || (reinterpret_cast<UPTRINT>(Address) & 7) != 0 ||
        !GUObjectArray.IsValid(this)) {
        return false;
    }
    return ClassPrivate && (!bRecursive || static_cast<const UObjectBase*>(ClassPrivate)->IsValidLowLevelFast(false));
}

void UObjectBase::LowLevelRename(FName NewName, UObject* NewOuter) {
    FObjectSystem::Unhash(this);
    NamePrivate = NewName;
    if (NewOuter) {
        OuterPrivate = NewOuter;
    }
    if (!NamePrivate.IsNone()) {
        FObjectSystem::Hash(this);
    }
}

void UObjectBase::SetClass(UClass* NewClass) {
    FObjectSystem::Unhash(this);
    ClassPrivate = NewClass;
    FObjectSystem::Hash(this);
}

// ---------------------------------------------------------------------------------------------------------------------------

EInternalObjectFlags UObjectBaseUtility::GetInternalFlags() const {
    return GUObjectArray.ObjectToObjectItem(this)->GetFlags();
}
bool UObjectBaseUtility::HasAnyInternalFlags(EInternalObjectFlags FlagsToCheck) const {
    const FUObjectItem* Item = GUObjectArray.ObjectToObjectItem(this);
    return Item && Item->HasAnyFlags(FlagsToCheck);
}
void UObjectBaseUtility::SetInternalFlags(EInternalObjectFlags FlagsToSet) const {
    GUObjectArray.ObjectToObjectItem(this)->Flags |= static_cast<int32>(FlagsToSet);
}
void UObjectBaseUtility::ClearInternalFlags(EInternalObjectFlags FlagsToClear) const {
    GUObjectArray.ObjectToObjectItem(this)->Flags &= ~static_cast<int32>(FlagsToClear);
}
bool UObjectBaseUtility::AtomicallySetInternalFlags(EInternalObjectFlags FlagsToSet) const {
    const bool bChanged = (GetInternalFlags() & FlagsToSet) != FlagsToSet;
    SetInternalFlags(FlagsToSet);
    return bChanged;
}
bool UObjectBaseUtility::AtomicallyClearInternalFlags(EInternalObjectFlags FlagsToClear) const {
    const bool bChanged = HasAnyInternalFlags(FlagsToClear);
    ClearInternalFlags(FlagsToClear);
    return bChanged;
}

void UObjectBaseUtility::MarkAsGarbage() {
    checkf(!IsRooted(), TEXT("%s is in the root set and cannot become garbage; call RemoveFromRoot first"),
        *GetPathName());
    AtomicallySetFlags(RF_MirroredGarbage);
    SetInternalFlags(EInternalObjectFlags::Garbage);
}
void UObjectBaseUtility::ClearGarbage() {
    AtomicallyClearFlags(RF_MirroredGarbage);
    ClearInternalFlags(EInternalObjectFlags::Garbage);
}
void UObjectBaseUtility::AddToRoot() { SetInternalFlags(EInternalObjectFlags::RootSet); }
void UObjectBaseUtility::RemoveFromRoot() { ClearInternalFlags(EInternalObjectFlags::RootSet); }
bool UObjectBaseUtility::IsRooted() const { return HasAnyInternalFlags(EInternalObjectFlags::RootSet); }

FString UObjectBaseUtility::GetName() const { return GetFName().ToString(); }
void UObjectBaseUtility::GetName(FString& ResultString) const { GetFName().ToString(ResultString); }

FString UObjectBaseUtility::GetFullName(const UObject* StopOuter) const {
    FString Result;
    GetFullName(Result, StopOuter);
    return Result;
}
void UObjectBaseUtility::GetFullName(FString& ResultString, const UObject* StopOuter) const {
    ResultString = GetClass()->GetName() + TEXT(" ") + GetPathName(StopOuter);
}

FString UObjectBaseUtility::GetPathName(const UObject* StopOuter) const {
    FString Result;
    GetPathName(StopOuter, Result);
    return Result;
}
void UObjectBaseUtility::GetPathName(const UObject* StopOuter, FString& ResultString) const {
    ResultString.Reset();
    if (static_cast<const UObjectBase*>(this) == static_cast<const UObjectBase*>(StopOuter)) {
        return;
    }
    const UObject* Outer = GetOuter();
    if (Outer && Outer != StopOuter) {
        Outer->GetPathName(StopOuter, ResultString);
        // The object directly below a top-level object starts the subobject part of the path.
        const bool bStartsSubobjectPath = Outer->GetClass() != UPackage::StaticClass() && Outer->GetOuter() &&
                                          Outer->GetOuter()->GetClass() == UPackage::StaticClass();
        ResultString += bStartsSubobjectPath ? SUBOBJECT_DELIMITER : TEXT(".");
    }
    ResultString += GetName();
}

UPackage* UObjectBaseUtility::GetOutermost() const { return GetPackage(); }
UPackage* UObjectBaseUtility::GetPackage() const {
    const UObjectBase* Top = this;
    while (Top->GetOuter()) {
        Top = Top->GetOuter();
    }
    return Top->GetClass() && Top->GetClass()->HasAnyCastFlag(CASTCLASS_UPackage)
               ? static_cast<UPackage*>(const_cast<UObjectBase*>(Top))
               : nullptr;
}
UObject* UObjectBaseUtility::GetOutermostObject() const {
    UObject* Top = static_cast<UObject*>(const_cast<UObjectBaseUtility*>(this));
    while (Top->GetOuter() && Top->GetOuter()->GetOuter()) {
        Top = Top->GetOuter();
    }
    return Top;
}
bool UObjectBaseUtility::MarkPackageDirty() const {
    UPackage* Package = HasAnyFlags(RF_Transient) ? nullptr : GetPackage();
    if (!Package) {
        return false;
    }
    Package->SetDirtyFlag(true);
    return true;
}
bool UObjectBaseUtility::IsPackageExternal() const { return false; }
bool UObjectBaseUtility::RootPackageHasAnyFlags(uint32 CheckFlagMask) const {
    const UPackage* Package = GetPackage();
    return Package && Package->HasAnyPackageFlags(CheckFlagMask);
}

UObject* UObjectBaseUtility::GetTypedOuter(UClass* Target) const {
    for (UObject* Outer = GetOuter(); Outer; Outer = Outer->GetOuter()) {
        if (Outer->IsA(Target)) {
            return Outer;
        }
    }
    return nullptr;
}
bool UObjectBaseUtility::IsIn(const UObject* SomeOuter) const {
    for (const UObject* Outer = GetOuter(); Outer; Outer = Outer->GetOuter()) {
        if (Outer == SomeOuter) {
            return true;
        }
    }
    return SomeOuter == nullptr;
}
bool UObjectBaseUtility::IsInOuter(const UObject* SomeOuter) const { return IsIn(SomeOuter); }
bool UObjectBaseUtility::IsInPackage(const UPackage* SomePackage) const {
    return static_cast<const UObjectBase*>(SomePackage) != this && GetPackage() == SomePackage;
}
bool UObjectBaseUtility::IsInA(const UClass* SomeBaseClass) const {
    return IsA(SomeBaseClass) || GetTypedOuter(const_cast<UClass*>(SomeBaseClass)) != nullptr;
}

bool UObjectBaseUtility::IsA(const UClass* SomeBase) const {
    checkf(SomeBase, TEXT("IsA(null) on %s"), *GetPathName());
    return GetClass() == SomeBase || GetClass()->IsChildOf(SomeBase);
}
UClass* UObjectBaseUtility::FindNearestCommonBaseClass(UClass* TestClass) const {
    return UClass::FindCommonBase(GetClass(), TestClass);
}

void* UObjectBaseUtility::GetInterfaceAddress(UClass* InterfaceClass) {
    if (!InterfaceClass || !InterfaceClass->HasAnyClassFlags(CLASS_Interface)) {
        return nullptr;
    }
    for (const UClass* Class = GetClass(); Class; Class = Class->GetSuperClass()) {
        for (const FImplementedInterface& Interface : Class->Interfaces) {
            if (Interface.Class && Interface.Class->IsChildOf(InterfaceClass)) {
                return reinterpret_cast<uint8*>(this) + Interface.PointerOffset;
            }
        }
    }
    return nullptr;
}
void* UObjectBaseUtility::GetNativeInterfaceAddress(UClass* InterfaceClass) {
    return GetInterfaceAddress(InterfaceClass);
}

bool UObjectBaseUtility::IsDefaultSubobject() const { return HasAnyFlags(RF_DefaultSubObject); }
bool UObjectBaseUtility::IsTemplate(EObjectFlags TemplateTypes) const {
    for (const UObject* Object = static_cast<const UObject*>(this); Object; Object = Object->GetOuter()) {
        if (Object->HasAnyFlags(TemplateTypes)) {
            return true;
        }
    }
    return false;
}

bool IsValidChecked(const UObject* Test) {
    check(Test);
    return !Test->HasAnyInternalFlags(EInternalObjectFlags::Garbage);
}
bool IsValid(const UObject* Test) { return Test && IsValidChecked(Test); }

FString GetNameSafe(const UObjectBaseUtility* Object) { return Object ? Object->GetName() : FString(TEXT("None")); }
FString GetPathNameSafe(const UObjectBaseUtility* Object) {
    return Object ? Object->GetPathName() : FString(TEXT("None"));
}
FString GetFullNameSafe(const UObjectBaseUtility* Object) {
    return Object ? Object->GetFullName() : FString(TEXT("None"));
}
