// SPDX-License-Identifier: MIT
/** @file Collections of subsystems. Mirrors UE's Subsystems/SubsystemCollection.h. */
#pragma once

#include "Containers/Map.h"
#include "CoreMinimal.h"
#include "Subsystems/Subsystem.h"
#include "Templates/SubclassOf.h"
#include "UObject/GCObject.h"

/** The subsystems of one owner, in the order of their initialisation (by class path, dependencies first). */
class ENGINE_API FSubsystemCollectionBase : public FGCObject {
public:
    virtual ~FSubsystemCollectionBase();

    /** Initialize the collection of systems. @param NewOuter the owner; it becomes the outer of each. */
    void Initialize(UObject* NewOuter);
    /** Clears the collection, while deinitializing the systems, in the reverse order. */
    void Deinitialize();
    /** Returns true if Initialize was called and Deinitialize was not. */
    bool IsInitialized() const { return Outer != nullptr; }

    /**
     * Only call from Initialize() of subsystems to ensure initialization order. Note: Dependencies only work within a
     * collection.
     * @return the dependency, or null when it does not exist in this collection.
     */
    template <typename TSubsystemClass>
    TSubsystemClass* InitializeDependency() {
        return Cast<TSubsystemClass>(InitializeDependency(TSubsystemClass::StaticClass()));
    }
    USubsystem* InitializeDependency(TSubclassOf<USubsystem> SubsystemClass);

    /** Adds all classes of newly loaded modules that are missing. */
    void AddNewlyLoadedClasses();

    // FGCObject
    virtual void AddReferencedObjects(FReferenceCollector& Collector) override;
    virtual FString GetReferencerName() const override;

protected:
    /** Protected constructor - for use by the template only. */
    explicit FSubsystemCollectionBase(UClass* InBaseType);

    /** Get a Subsystem by type: of that class, or of the first derived one. */
    USubsystem* GetSubsystemInternal(UClass* SubsystemClass) const;
    /** Get all subsystems of a class. */
    TArray<USubsystem*> GetSubsystemArrayInternal(UClass* SubsystemClass) const;

private:
    USubsystem* AddAndInitializeSubsystem(UClass* SubsystemClass);

    UClass* BaseType;
    UObject* Outer;
    /** In the order of initialisation. */
    TArray<TObjectPtr<USubsystem>> Subsystems;
    /** Classes whose Initialize is under way or that declined: guards against cycles. */
    TArray<UClass*> VisitedClasses;
};

/** The subsystems that derive from TBaseType. */
template <typename TBaseType>
class FObjectSubsystemCollection : public FSubsystemCollectionBase {
public:
    FObjectSubsystemCollection() : FSubsystemCollectionBase(TBaseType::StaticClass()) {}

    /** Get a Subsystem by type, or null. */
    template <typename TSubsystemClass>
    TSubsystemClass* GetSubsystem(const TSubclassOf<TSubsystemClass>& SubsystemClass) const {
        return static_cast<TSubsystemClass*>(GetSubsystemInternal(SubsystemClass));
    }

    /** Get all subsystems of that type. */
    template <typename TSubsystemClass>
    TArray<TSubsystemClass*> GetSubsystemArrayCopy(const TSubclassOf<TSubsystemClass>& SubsystemClass) const {
        TArray<TSubsystemClass*> Result;
        for (USubsystem* Subsystem : GetSubsystemArrayInternal(SubsystemClass)) {
            Result.Add(static_cast<TSubsystemClass*>(Subsystem));
        }
        return Result;
    }
};

/** UE's older name of the same. */
template <typename TBaseType>
using FSubsystemCollection = FObjectSubsystemCollection<TBaseType>;
