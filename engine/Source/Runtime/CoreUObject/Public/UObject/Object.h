// SPDX-License-Identifier: MIT
// UObject, the base class of all reflected objects. Mirrors Epic's "UObject/Object.h" (API page UObject).
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"
#include "UObject/UObjectBaseUtility.h"
#include "UObject/UObjectGlobals.h"

class FConfigCacheIni;
class FOutputDevice;
class FProperty;
class UFunction;
class UWorld;
struct FFrame;
struct FObjectInstancingGraph;

/**
 * Base class of all reflected objects. Made only by NewObject and CreateDefaultSubobject, destroyed only by garbage
 * collection.
 */
class COREUOBJECT_API UObject : public UObjectBaseUtility {
    DECLARE_CLASS(UObject, UObject, CLASS_Abstract | CLASS_MatchedSerializers, CASTCLASS_None,
        TEXT("/Script/CoreUObject"), COREUOBJECT_API)
    DEFINE_DEFAULT_OBJECT_INITIALIZER_CONSTRUCTOR_CALL(UObject)

    friend struct Z_Construct_UClass_UObject_Statics;

public:
    typedef UObject WithinClass;
    static const TCHAR* StaticConfigName() { return TEXT("Engine"); }

    /** Default constructor; the running construction provides identity. */
    COREUOBJECT_API UObject();
    COREUOBJECT_API explicit UObject(const FObjectInitializer& ObjectInitializer);

    // ---- creation of default subobjects, in constructors only

    /** Creates a component or subobject; only inside a constructor. Null only if a subclass said
     * DoNotCreateDefaultSubobject. */
    COREUOBJECT_API UObject* CreateDefaultSubobject(
        FName SubobjectFName, UClass* ReturnType, UClass* ClassToCreateByDefault, bool bIsRequired, bool bIsTransient);
    template <class TReturnType>
    TReturnType* CreateDefaultSubobject(FName SubobjectName, bool bTransient = false) {
        UClass* ReturnType = TReturnType::StaticClass();
        return static_cast<TReturnType*>(
            CreateDefaultSubobject(SubobjectName, ReturnType, ReturnType, true, bTransient));
    }
    template <class TReturnType, class TClassToConstructByDefault>
    TReturnType* CreateDefaultSubobject(FName SubobjectName, bool bTransient = false) {
        return static_cast<TReturnType*>(CreateDefaultSubobject(
            SubobjectName, TReturnType::StaticClass(), TClassToConstructByDefault::StaticClass(), true, bTransient));
    }
    template <class TReturnType>
    TReturnType* CreateOptionalDefaultSubobject(FName SubobjectName, bool bTransient = false) {
        UClass* ReturnType = TReturnType::StaticClass();
        return static_cast<TReturnType*>(
            CreateDefaultSubobject(SubobjectName, ReturnType, ReturnType, false, bTransient));
    }
    /** The subobject of that name, created in a constructor or not. */
    COREUOBJECT_API UObject* GetDefaultSubobjectByName(FName ToFind);
    COREUOBJECT_API void GetDefaultSubobjects(TArray<UObject*>& OutDefaultSubobjects);

    // ---- life time

    /** After the C++ constructor and after properties were initialised, class default object included. */
    COREUOBJECT_API virtual void PostInitProperties();
    /** After the class default object is complete. */
    virtual void PostCDOContruct() {}
    /** After the object was supplied from content. */
    COREUOBJECT_API virtual void PostLoad();
    COREUOBJECT_API void ConditionalPostLoad();
    /** First step of destruction: the object is unreachable, others may be too. Overrides must call Super. */
    COREUOBJECT_API virtual void BeginDestroy();
    /** False keeps the object's memory a while longer. */
    virtual bool IsReadyForFinishDestroy() { return true; }
    /** Last step before the destructor. Overrides must call Super. */
    COREUOBJECT_API virtual void FinishDestroy();
    COREUOBJECT_API bool ConditionalBeginDestroy();
    COREUOBJECT_API bool ConditionalFinishDestroy();
    virtual void ShutdownAfterError() {}
    virtual void PostDuplicate(bool bDuplicateForPIE) {}
    virtual void PostDuplicate(EDuplicateMode::Type DuplicateMode) {
        PostDuplicate(DuplicateMode == EDuplicateMode::PIE);
    }
    virtual void PostRename(UObject* OldOuter, const FName OldName) {}
    /** Called for properties that were set from text (scene files, sidecars). */
    virtual void PostEditImport() {}
    virtual void PostReinitProperties() {}

#if WITH_EDITOR
    virtual void PreEditChange(FProperty* PropertyAboutToChange) {}
    virtual void PostEditChange() {}
    virtual void PostEditChangeProperty(struct FPropertyChangedEvent& PropertyChangedEvent) {}
#endif

    // ---- identity

    /** Changes name and/or outer. Null name makes a unique one; null outer keeps the outer. False with REN_Test if
     * impossible. */
    COREUOBJECT_API virtual bool Rename(
        const TCHAR* NewName = nullptr, UObject* NewOuter = nullptr, ERenameFlags Flags = REN_None);
    /** The class default object or template that the object was made from. */
    COREUOBJECT_API UObject* GetArchetype() const;
    COREUOBJECT_API bool IsBasedOnArchetype(const UObject* const SomeObject) const;
    /** One line about the object for lists. */
    virtual FString GetDesc() { return FString(); }
    virtual bool IsAsset() const { return false; }
    virtual bool IsEditorOnly() const { return false; }
    virtual bool IsSelected() const { return false; }
    virtual bool IsPostLoadThreadSafe() const { return false; }
    virtual bool IsDestructionThreadSafe() const { return false; }
    virtual bool CanModify() const { return true; }
    /** Transactions exist in the editor only; false says that nothing was recorded. */
    virtual bool Modify(bool bAlwaysMarkDirty = true) { return false; }
    virtual bool IsNameStableForNetworking() const { return HasAnyFlags(RF_ClassDefaultObject | RF_WasLoaded); }
    virtual bool IsFullNameStableForNetworking() const { return IsNameStableForNetworking(); }
    virtual bool IsSupportedForNetworking() const { return IsFullNameStableForNetworking(); }
    bool IsSafeForRootSet() const { return IsValid(this); }

    // ---- world

    /** The world the object lives in; null for class default objects. */
    COREUOBJECT_API virtual UWorld* GetWorld() const;
    /** True if the class overrides GetWorld. */
    virtual bool ImplementsGetWorld() const { return true; }

    // ---- script calls

    /** The function of that name in this object's class, subclasses' overrides first. Null if there is none. */
    COREUOBJECT_API UFunction* FindFunction(FName InName) const;
    /** As FindFunction; a missing function is a fatal error. */
    COREUOBJECT_API UFunction* FindFunctionChecked(FName InName) const;
    /**
     * Calls a function with its parameters in one block, laid out as the function's properties say. Out-parameters and
     * the return value are written back into the block.
     */
    COREUOBJECT_API virtual void ProcessEvent(UFunction* Function, void* Parms);
    /** Calls "FunctionName arg arg ..." on this object if it is an Exec function (or bForceCallWithNonExec). */
    COREUOBJECT_API bool CallFunctionByNameWithArguments(
        const TCHAR* Cmd, FOutputDevice& Ar, UObject* Executor, bool bForceCallWithNonExec = false);

    // ---- garbage collection

    /** Reports references that no UPROPERTY holds. Classes declare a static of this name to add theirs; call Super's.
     */
    COREUOBJECT_API static void AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector);
};
