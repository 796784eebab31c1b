// SPDX-License-Identifier: MIT
// UObject: life time and identity. Script calls are in Function.cpp, construction in ObjectConstruction.cpp.
#include "UObject/Object.h"

#include "ObjectSystem.h"
#include "UObject/Class.h"
#include "UObject/SparseDelegate.h"
#include "UObject/UObjectHash.h"

UObject::UObject() = default;
UObject::UObject(const FObjectInitializer&) {}

UObject* UObject::CreateDefaultSubobject(
    FName SubobjectFName, UClass* ReturnType, UClass* ClassToCreateByDefault, bool bIsRequired, bool bIsTransient) {
    FObjectInitializer* Initializer = FObjectInitializer::TryGet();
    checkf(Initializer, TEXT("CreateDefaultSubobject('%s') on %s: only constructors may create default subobjects"),
        *SubobjectFName.ToString(), *GetPathName());
    return Initializer->CreateDefaultSubobject(
        this, SubobjectFName, ReturnType, ClassToCreateByDefault, bIsRequired, bIsTransient);
}

UObject* UObject::GetDefaultSubobjectByName(FName ToFind) {
    UObject* Object = FindObjectWithOuter(this, nullptr, ToFind);
    return Object && Object->HasAnyFlags(RF_DefaultSubObject) ? Object : nullptr;
}

void UObject::GetDefaultSubobjects(TArray<UObject*>& OutDefaultSubobjects) {
    OutDefaultSubobjects.Reset();
    TArray<UObject*> Inners;
    GetObjectsWithOuter(this, Inners, false);
    for (UObject* Inner : Inners) {
        if (Inner->HasAnyFlags(RF_DefaultSubObject)) {
            OutDefaultSubobjects.Add(Inner);
        }
    }
}

void UObject::PostInitProperties() {}

void UObject::PostLoad() { ClearFlags(RF_NeedPostLoad); }

void UObject::ConditionalPostLoad() {
    if (HasAnyFlags(RF_NeedPostLoad)) {
        ClearFlags(RF_NeedPostLoad);
        PostLoad();
    }
}

void UObject::BeginDestroy() {
    checkf(HasAnyFlags(RF_BeginDestroyed), TEXT("%s: BeginDestroy may only be called by ConditionalBeginDestroy"),
        *GetPathName());
    // The name is free for new objects from here on.
    LowLevelRename(NAME_None);
}

void UObject::FinishDestroy() {
    checkf(HasAnyFlags(RF_FinishDestroyed), TEXT("FinishDestroy may only be called by ConditionalFinishDestroy"));
}

bool UObject::ConditionalBeginDestroy() {
    if (HasAnyFlags(RF_BeginDestroyed)) {
        return false;
    }
    SetFlags(RF_BeginDestroyed);
    const FString Name = GetName();
    BeginDestroy();
    checkf(GetFName().IsNone(), TEXT("%s: BeginDestroy did not call Super::BeginDestroy"), *Name);
    return true;
}

bool UObject::ConditionalFinishDestroy() {
    if (HasAnyFlags(RF_FinishDestroyed)) {
        return false;
    }
    SetFlags(RF_FinishDestroyed);
    FinishDestroy();
    return true;
}

UObject* UObject::GetArchetype() const {
    if (HasAnyFlags(RF_ClassDefaultObject)) {
        UClass* SuperClass = GetClass()->GetSuperClass();
        return SuperClass ? SuperClass->GetDefaultObject() : nullptr;
    }
    if (HasAnyFlags(RF_DefaultSubObject) && GetOuter()) {
        // The subobject of the outer's template; the outer of a class default object's subobject looks at its super
        // class.
        UObject* OuterArchetype = GetOuter()->GetArchetype();
        if (OuterArchetype) {
            UObject* Template = FindObjectWithOuter(OuterArchetype, nullptr, GetFName());
            if (Template && GetClass()->IsChildOf(Template->GetClass())) {
                return Template;
            }
        }
    }
    return GetClass()->GetDefaultObject();
}

bool UObject::IsBasedOnArchetype(const UObject* const SomeObject) const {
    if (SomeObject && SomeObject != this) {
        for (const UObject* Template = GetArchetype(); Template; Template = Template->GetArchetype()) {
            if (Template == SomeObject) {
                return true;
            }
        }
    }
    return false;
}

bool UObject::Rename(const TCHAR* NewName, UObject* NewOuter, ERenameFlags Flags) {
    UObject* const TargetOuter = NewOuter ? NewOuter : GetOuter();
    const bool bWantsUniqueName =
        NewName == nullptr && (!TargetOuter || StaticFindObjectFast(nullptr, TargetOuter, GetFName()) != nullptr);
    FName TargetName =
        NewName ? FName(NewName) : (bWantsUniqueName ? MakeUniqueObjectName(TargetOuter, GetClass()) : GetFName());
    checkf(!NewOuter || (NewOuter != this && !NewOuter->IsIn(this)), TEXT("Rename: %s cannot be inside itself"),
        *GetPathName());

    UObject* const Existing = StaticFindObjectFast(nullptr, TargetOuter, TargetName);
    if (Existing && Existing != this) {
        if (Flags & REN_Test) {
            return false;
        }
        checkf(false, TEXT("Renaming %s to %s: %s has that name. Pass REN_Test to ask first"), *GetFullName(),
            *TargetName.ToString(), *Existing->GetFullName());
    }
    if (Flags & REN_Test) {
        return true;
    }
    UObject* const OldOuter = GetOuter();
    const FName OldName = GetFName();
    LowLevelRename(TargetName, TargetOuter);
    PostRename(OldOuter, OldName);
    return true;
}

UWorld* UObject::GetWorld() const { return GetOuter() ? GetOuter()->GetWorld() : nullptr; }

void UObject::AddReferencedObjects(UObject*, FReferenceCollector&) {}

FString GetClassNameSafe(const UObject* Object) {
    return Object ? Object->GetClass()->GetName() : FString(TEXT("None"));
}

namespace UE::CoreUObject::Private {
bool ObjectIsA(const UObject* Object, const UClass* Class, EClassCastFlags CastFlags) {
    return CastFlags != CASTCLASS_None ? Object->GetClass()->HasAllCastFlags(CastFlags) : Object->IsA(Class);
}
void CastFailed(const UObject* Object, const UClass* Class) {
    if (Object) {
        checkf(false, TEXT("CastChecked: %s is no %s"), *Object->GetFullName(), *Class->GetName());
    } else {
        checkf(false, TEXT("CastChecked: null where a %s is needed"), *Class->GetName());
    }
    PLATFORM_BREAK();
}
bool ClassIsChildOf(const UClass* Class, const UClass* Base) { return Class && Class->IsChildOf(Base); }
UObject* ClassDefaultObject(const UClass* Class) { return Class ? Class->GetDefaultObject() : nullptr; }
UClass* AsChildClass(UObject* Object, const UClass* Base) {
    UClass* Class = Cast<UClass>(Object);
    return Class && Class->IsChildOf(Base) ? Class : nullptr;
}
} // namespace UE::CoreUObject::Private
