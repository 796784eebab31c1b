// SPDX-License-Identifier: MIT
#include "Subsystems/SubsystemCollection.h"

#include "UObject/Class.h"
#include "UObject/UObjectHash.h"

DEFINE_LOG_CATEGORY_STATIC(LogSubsystemCollection, Log, All);

FSubsystemCollectionBase::FSubsystemCollectionBase(UClass* InBaseType) : BaseType(InBaseType), Outer(nullptr) {}

FSubsystemCollectionBase::~FSubsystemCollectionBase() = default;

void FSubsystemCollectionBase::Initialize(UObject* NewOuter) {
    if (Outer) {
        return;
    }
    Outer = NewOuter;
    check(Outer);
    AddNewlyLoadedClasses();
}

void FSubsystemCollectionBase::AddNewlyLoadedClasses() {
    if (!Outer) {
        return;
    }
    TArray<UClass*> Classes;
    GetDerivedClasses(BaseType, Classes, true);
    // By path: the order in which classes were registered must not matter.
    Classes.Sort([](const UClass& A, const UClass& B) { return A.GetPathName() < B.GetPathName(); });
    for (UClass* Class : Classes) {
        AddAndInitializeSubsystem(Class);
    }
}

USubsystem* FSubsystemCollectionBase::AddAndInitializeSubsystem(UClass* SubsystemClass) {
    for (const TObjectPtr<USubsystem>& Subsystem : Subsystems) {
        if (Subsystem->GetClass() == SubsystemClass) {
            return Subsystem;
        }
    }
    if (VisitedClasses.Contains(SubsystemClass) ||
        SubsystemClass->HasAnyClassFlags(CLASS_Abstract | CLASS_Deprecated)) {
        return nullptr;
    }
    VisitedClasses.Add(SubsystemClass);
    if (!SubsystemClass->GetDefaultObject<USubsystem>()->ShouldCreateSubsystem(Outer)) {
        return nullptr;
    }
    USubsystem* Subsystem = NewObject<USubsystem>(Outer, SubsystemClass);
    Subsystem->InternalOwningSubsystem = this;
    // Kept from now on, so that Initialize may make garbage; its place is after its dependencies.
    Subsystems.Add(Subsystem);
    Subsystem->Initialize(*this);
    Subsystems.Remove(Subsystem);
    Subsystems.Add(Subsystem);
    return Subsystem;
}

USubsystem* FSubsystemCollectionBase::InitializeDependency(TSubclassOf<USubsystem> SubsystemClass) {
    if (!SubsystemClass || !SubsystemClass->IsChildOf(BaseType)) {
        UE_LOG(LogSubsystemCollection, Error,
            TEXT("InitializeDependency: %s is not a %s, so that it is in another collection"),
            *GetNameSafe(SubsystemClass.Get()), *BaseType->GetName());
        return nullptr;
    }
    return AddAndInitializeSubsystem(SubsystemClass.Get());
}

void FSubsystemCollectionBase::Deinitialize() {
    while (Subsystems.Num() > 0) {
        USubsystem* Subsystem = Subsystems.Last();
        Subsystem->Deinitialize();
        Subsystem->InternalOwningSubsystem = nullptr;
        Subsystems.Remove(Subsystem);
    }
    VisitedClasses.Empty();
    Outer = nullptr;
}

USubsystem* FSubsystemCollectionBase::GetSubsystemInternal(UClass* SubsystemClass) const {
    for (const TObjectPtr<USubsystem>& Subsystem : Subsystems) {
        if (Subsystem->GetClass() == SubsystemClass) {
            return Subsystem;
        }
    }
    const TArray<USubsystem*> Derived = GetSubsystemArrayInternal(SubsystemClass);
    return Derived.Num() > 0 ? Derived[0] : nullptr;
}

TArray<USubsystem*> FSubsystemCollectionBase::GetSubsystemArrayInternal(UClass* SubsystemClass) const {
    TArray<USubsystem*> Result;
    for (const TObjectPtr<USubsystem>& Subsystem : Subsystems) {
        if (SubsystemClass && Subsystem->IsA(SubsystemClass)) {
            Result.Add(Subsystem);
        }
    }
    return Result;
}

void FSubsystemCollectionBase::AddReferencedObjects(FReferenceCollector& Collector) {
    Collector.AddReferencedObjects(Subsystems);
}

FString FSubsystemCollectionBase::GetReferencerName() const { return TEXT("FSubsystemCollectionBase"); }
