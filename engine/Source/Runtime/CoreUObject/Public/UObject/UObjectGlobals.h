// SPDX-License-Identifier: MIT
// Creating, finding, loading, renaming and collecting objects. Mirrors Epic's "UObject/UObjectGlobals.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"
#include "UObject/ObjectPtr.h"
#include "UObject/ReferenceCollector.h"
#include "UObject/UObjectBaseUtility.h"

class FOutputDevice;
class FProperty;
class UFunction;
class UPackage;
class UPackageMap;
class FLinkerInstancingContext;
struct FObjectInstancingGraph;
struct FStaticConstructObjectParameters;

/** Package that nobody saves and that holds objects without a better home. */
COREUOBJECT_API UPackage* GetTransientPackage();
/** GetTransientPackage as UObject, for headers that do not know UPackage. */
COREUOBJECT_API UObject* GetTransientPackageAsObject();

/** Options of UObject::Rename. */
typedef uint32 ERenameFlags;
#define REN_None (0x0000)
#define REN_ForceNoResetLoaders (0x0001)
#define REN_Test (0x0002)
#define REN_DoNotDirty (0x0004)
#define REN_DontCreateRedirectors (0x0010)
#define REN_NonTransactional (0x0020)
#define REN_ForceGlobalUnique (0x0040)
#define REN_SkipGeneratedClasses (0x0080)
#define REN_AllowPackageLinkerMismatch (0x0200)

/** How a copy of an object is made; see UObject::PostDuplicate. */
namespace EDuplicateMode {
enum Type { Normal, World, PIE };
}

/** What FindFirstObject does when a short name is ambiguous. */
enum class EFindFirstObjectOptions {
    None = 0,
    ExactClass = 1 << 0,
    NativeFirst = 1 << 1,
    EnsureIfAmbiguous = 1 << 2,
};
ENUM_CLASS_FLAGS(EFindFirstObjectOptions)

// ---------------------------------------------------------------------------------------------------------------------------
// Construction

/** Everything StaticConstructObject_Internal needs. */
struct FStaticConstructObjectParameters {
    const UClass* Class;
    UObject* Outer = nullptr;
    FName Name;
    EObjectFlags SetFlags = RF_NoFlags;
    EInternalObjectFlags InternalSetFlags = EInternalObjectFlags::None;
    bool bCopyTransientsFromClassDefaults = false;
    bool bAssumeTemplateIsArchetype = false;
    UObject* Template = nullptr;
    FObjectInstancingGraph* InstanceGraph = nullptr;
    UPackage* ExternalPackage = nullptr;

    explicit FStaticConstructObjectParameters(const UClass* InClass) : Class(InClass) {}
};

/** Creates an object of any class. NewObject is the friendly form. */
COREUOBJECT_API UObject* StaticConstructObject_Internal(const FStaticConstructObjectParameters& Params);

/** Maps instanced subobjects of a template to the ones of its copy. */
struct FObjectInstancingGraph {
    FObjectInstancingGraph() = default;
    explicit FObjectInstancingGraph(UObject* DestinationSubobjectRoot, UObject* SourceSubobjectRoot) {
        SetDestinationRoot(DestinationSubobjectRoot, SourceSubobjectRoot);
    }
    COREUOBJECT_API void SetDestinationRoot(UObject* DestinationSubobjectRoot, UObject* InSourceRoot = nullptr);
    COREUOBJECT_API void AddNewInstance(UObject* Source, UObject* Instance);
    /** The copy of SourceObject, or null if it was not instanced. */
    COREUOBJECT_API UObject* GetDestinationObject(UObject* SourceObject) const;
    bool HasDestinationObject() const { return DestinationRoot != nullptr; }
    UObject* GetDestinationRoot() const { return DestinationRoot; }
    UObject* GetSourceRoot() const { return SourceRoot; }

private:
    UObject* SourceRoot = nullptr;
    UObject* DestinationRoot = nullptr;
    TMap<UObject*, UObject*> SourceToDestination;
};

/**
 * Passed to constructors: creates and overrides default subobjects, and finishes the object (properties, subobjects,
 * PostInitProperties) when it goes out of scope. Only the object system makes one.
 */
class FObjectInitializer {
public:
    COREUOBJECT_API FObjectInitializer(UObject* InObj, const FStaticConstructObjectParameters& Params);
    COREUOBJECT_API ~FObjectInitializer();

    /** The initializer of the object under construction on this thread. */
    COREUOBJECT_API static FObjectInitializer& Get();
    /** The initializer under way, or null outside constructions. */
    COREUOBJECT_API static FObjectInitializer* TryGet();

    FORCEINLINE UObject* GetArchetype() const { return ObjectArchetype; }
    FORCEINLINE UObject* GetObj() const { return Obj; }
    COREUOBJECT_API UClass* GetClass() const;

    COREUOBJECT_API UObject* CreateDefaultSubobject(UObject* Outer, FName SubobjectFName, const UClass* ReturnType,
        const UClass* ClassToCreateByDefault, bool bIsRequired = true, bool bIsTransient = false) const;
    template <class TReturnType, class TClassToConstructByDefault = TReturnType>
    TReturnType* CreateDefaultSubobject(UObject* Outer, FName SubobjectName, bool bTransient = false) const {
        return static_cast<TReturnType*>(CreateDefaultSubobject(Outer, SubobjectName, TReturnType::StaticClass(),
            TClassToConstructByDefault::StaticClass(), true, bTransient));
    }
    template <class TReturnType>
    TReturnType* CreateOptionalDefaultSubobject(UObject* Outer, FName SubobjectName, bool bTransient = false) const {
        return static_cast<TReturnType*>(CreateDefaultSubobject(
            Outer, SubobjectName, TReturnType::StaticClass(), TReturnType::StaticClass(), false, bTransient));
    }
    /** Makes a base class's constructor create T instead of its own choice. Call in the initialiser list. */
    COREUOBJECT_API const FObjectInitializer& SetDefaultSubobjectClass(FName SubobjectName, const UClass* Class) const;
    template <class T>
    const FObjectInitializer& SetDefaultSubobjectClass(FName SubobjectName) const {
        return SetDefaultSubobjectClass(SubobjectName, T::StaticClass());
    }
    /** Keeps a base class's constructor from creating an optional subobject. */
    COREUOBJECT_API const FObjectInitializer& DoNotCreateDefaultSubobject(FName SubobjectName) const;
    /** From here on overrides are ignored: the class that would be overridden has made its subobjects. */
    void FinalizeSubobjectClassInitialization() const { bSubclassOverridesAllowed = false; }

private:
    struct FOverride {
        FName Name;
        /** Null: do not create. */
        const UClass* Class;
    };
    struct FSubobjectInit {
        UObject* Subobject;
        UObject* Template;
    };

    void PostConstructInit();
    const FOverride* FindOverride(FName Name) const;

    UObject* Obj;
    UObject* ObjectArchetype;
    bool bCopyTransientsFromClassDefaults;
    FObjectInstancingGraph* InstanceGraph;
    FObjectInitializer* Previous;
    mutable TArray<FOverride> Overrides;
    mutable TArray<FSubobjectInit> SubobjectInits;
    mutable bool bSubclassOverridesAllowed = true;

    FObjectInitializer(const FObjectInitializer&) = delete;
    FObjectInitializer& operator=(const FObjectInitializer&) = delete;
};

/**
 * Creates an object. Name none makes a unique one; an existing object of the same name and outer is replaced (destroyed
 * in place and its name taken over). Fatal for abstract classes.
 */
template <class T>
T* NewObject(UObject* Outer, const UClass* Class, FName Name = NAME_None, EObjectFlags Flags = RF_NoFlags,
    UObject* Template = nullptr, bool bCopyTransientsFromClassDefaults = false,
    FObjectInstancingGraph* InInstanceGraph = nullptr, UPackage* ExternalPackage = nullptr) {
    FStaticConstructObjectParameters Params(Class);
    Params.Outer = Outer;
    Params.Name = Name;
    Params.SetFlags = Flags;
    Params.Template = Template;
    Params.bCopyTransientsFromClassDefaults = bCopyTransientsFromClassDefaults;
    Params.InstanceGraph = InInstanceGraph;
    Params.ExternalPackage = ExternalPackage;
    return static_cast<T*>(StaticConstructObject_Internal(Params));
}
template <class T>
T* NewObject(UObject* Outer = GetTransientPackageAsObject()) {
    FStaticConstructObjectParameters Params(T::StaticClass());
    Params.Outer = Outer;
    return static_cast<T*>(StaticConstructObject_Internal(Params));
}
template <class T>
T* NewObject(UObject* Outer, FName Name, EObjectFlags Flags = RF_NoFlags, UObject* Template = nullptr,
    bool bCopyTransientsFromClassDefaults = false, FObjectInstancingGraph* InInstanceGraph = nullptr) {
    FStaticConstructObjectParameters Params(T::StaticClass());
    Params.Outer = Outer;
    Params.Name = Name;
    Params.SetFlags = Flags;
    Params.Template = Template;
    Params.bCopyTransientsFromClassDefaults = bCopyTransientsFromClassDefaults;
    Params.InstanceGraph = InInstanceGraph;
    return static_cast<T*>(StaticConstructObject_Internal(Params));
}

/** Copies an object with its subobjects below a new outer. */
COREUOBJECT_API UObject* StaticDuplicateObject(UObject const* SourceObject, UObject* DestOuter,
    const FName DestName = NAME_None, EObjectFlags FlagMask = RF_AllFlags, UClass* DestClass = nullptr,
    EDuplicateMode::Type DuplicateMode = EDuplicateMode::Normal);
namespace UE::CoreUObject::Private {
COREUOBJECT_API UObject* DuplicateObject(
    const UClass* Class, const UObject* SourceObject, UObject* Outer, FName NewName);
}
template <typename T>
T* DuplicateObject(T const* SourceObject, UObject* Outer, const FName Name = NAME_None) {
    return static_cast<T*>(UE::CoreUObject::Private::DuplicateObject(T::StaticClass(), SourceObject, Outer, Name));
}
template <typename T>
T* DuplicateObject(const TObjectPtr<T>& SourceObject, UObject* Outer, const FName Name = NAME_None) {
    return DuplicateObject<T>(SourceObject.Get(), Outer, Name);
}

/** A name not used below Parent: the base name (default: the class's) with a number. */
COREUOBJECT_API FName MakeUniqueObjectName(UObject* Parent, const UClass* Class, FName BaseName = NAME_None);

// ---------------------------------------------------------------------------------------------------------------------------
// Finding and loading

/** Object by outer and name; Name may be a path when InObjectPackage is null. */
COREUOBJECT_API UObject* StaticFindObjectFast(UClass* Class, UObject* InOuter, FName InName, bool bExactClass = false,
    EObjectFlags ExclusiveFlags = RF_NoFlags, EInternalObjectFlags ExclusiveInternalFlags = EInternalObjectFlags::None);
COREUOBJECT_API UObject* StaticFindObject(UClass* Class, UObject* InOuter, const TCHAR* Name, bool bExactClass = false);
COREUOBJECT_API UObject* StaticFindObjectChecked(
    UClass* Class, UObject* InOuter, const TCHAR* Name, bool bExactClass = false);
/** As StaticFindObject, quiet about calls at unsafe times. */
COREUOBJECT_API UObject* StaticFindObjectSafe(
    UClass* Class, UObject* InOuter, const TCHAR* Name, bool bExactClass = false);
/** First object of that short name (or path) anywhere. */
COREUOBJECT_API UObject* StaticFindFirstObject(
    UClass* Class, const TCHAR* Name, EFindFirstObjectOptions Options = EFindFirstObjectOptions::None);
/** Finds the object in memory, else asks the registered content loaders (UObject/ContentLoader.h). Null if nobody has
 * it. */
COREUOBJECT_API UObject* StaticLoadObject(UClass* Class, UObject* InOuter, const TCHAR* Name,
    const TCHAR* Filename = nullptr, uint32 LoadFlags = LOAD_None, UPackageMap* Sandbox = nullptr,
    bool bAllowObjectReconciliation = true, const FLinkerInstancingContext* InstancingContext = nullptr);
COREUOBJECT_API UClass* StaticLoadClass(UClass* BaseClass, UObject* InOuter, const TCHAR* Name,
    const TCHAR* Filename = nullptr, uint32 LoadFlags = LOAD_None, UPackageMap* Sandbox = nullptr);

template <class T>
T* FindObject(UObject* Outer, const TCHAR* Name, bool ExactClass = false) {
    return static_cast<T*>(StaticFindObject(T::StaticClass(), Outer, Name, ExactClass));
}
template <class T>
T* FindObjectFast(UObject* Outer, FName Name, bool ExactClass = false, EObjectFlags ExclusiveFlags = RF_NoFlags) {
    return static_cast<T*>(StaticFindObjectFast(T::StaticClass(), Outer, Name, ExactClass, ExclusiveFlags));
}
template <class T>
T* FindObjectChecked(UObject* Outer, const TCHAR* Name, bool ExactClass = false) {
    return static_cast<T*>(StaticFindObjectChecked(T::StaticClass(), Outer, Name, ExactClass));
}
template <class T>
T* FindObjectSafe(UObject* Outer, const TCHAR* Name, bool ExactClass = false) {
    return static_cast<T*>(StaticFindObjectSafe(T::StaticClass(), Outer, Name, ExactClass));
}
template <class T>
T* FindFirstObject(const TCHAR* Name, EFindFirstObjectOptions Options = EFindFirstObjectOptions::None) {
    return static_cast<T*>(StaticFindFirstObject(T::StaticClass(), Name, Options));
}
template <class T>
T* LoadObject(UObject* Outer, const TCHAR* Name, const TCHAR* Filename = nullptr, uint32 LoadFlags = LOAD_None,
    UPackageMap* Sandbox = nullptr, const FLinkerInstancingContext* InstancingContext = nullptr) {
    return static_cast<T*>(
        StaticLoadObject(T::StaticClass(), Outer, Name, Filename, LoadFlags, Sandbox, true, InstancingContext));
}
template <class T>
UClass* LoadClass(UObject* Outer, const TCHAR* Name, const TCHAR* Filename = nullptr, uint32 LoadFlags = LOAD_None,
    UPackageMap* Sandbox = nullptr) {
    return StaticLoadClass(T::StaticClass(), Outer, Name, Filename, LoadFlags, Sandbox);
}
/** Package in memory by name. */
COREUOBJECT_API UPackage* FindPackage(UObject* InOuter, const TCHAR* PackageName);
/** Finds or creates a package. */
COREUOBJECT_API UPackage* CreatePackage(const TCHAR* PackageName);
/** Package in memory, or one that a content loader makes. */
COREUOBJECT_API UPackage* LoadPackage(UPackage* InOuter, const TCHAR* InLongPackageName, uint32 LoadFlags);
/**
 * Walks down a path: on return InName is the last part and InPackage its outer. False if a part is missing (with Create
 * set, packages are created).
 */
COREUOBJECT_API bool ResolveName(UObject*& InPackage, FString& InOutName, bool Create, bool Throw,
    uint32 LoadFlags = LOAD_None, const FLinkerInstancingContext* InstancingContext = nullptr);
/** True while objects are loaded in the background: never here, loading is immediate. */
COREUOBJECT_API bool IsAsyncLoading();
COREUOBJECT_API bool IsLoading();
COREUOBJECT_API void FlushAsyncLoading(int32 RequestId = INDEX_NONE);

// ---------------------------------------------------------------------------------------------------------------------------
// Class defaults

/** The class default object, read-only. */
template <class T>
const T* GetDefault() {
    return static_cast<const T*>(T::StaticClass()->GetDefaultObject());
}
template <class T>
T* GetMutableDefault() {
    return static_cast<T*>(T::StaticClass()->GetDefaultObject());
}
template <class T, typename ClassType = UClass>
const T* GetDefault(const ClassType* Class) {
    return static_cast<const T*>(Class->GetDefaultObject());
}
template <class T, typename ClassType = UClass>
T* GetMutableDefault(const ClassType* Class) {
    return static_cast<T*>(Class->GetDefaultObject());
}

// ---------------------------------------------------------------------------------------------------------------------------
// Garbage collection

/** Destroys unreachable objects now. bPerformFullPurge false leaves freeing memory to IncrementalPurgeGarbage. */
COREUOBJECT_API void CollectGarbage(EObjectFlags KeepFlags, bool bPerformFullPurge = true);
COREUOBJECT_API bool TryCollectGarbage(EObjectFlags KeepFlags, bool bPerformFullPurge = true);
/** Frees objects left by a collection, for up to TimeLimit seconds. */
COREUOBJECT_API void IncrementalPurgeGarbage(bool bUseTimeLimit, double TimeLimit = 0.002);
COREUOBJECT_API bool IsIncrementalPurgePending();
COREUOBJECT_API bool IsIncrementalUnhashPending();
COREUOBJECT_API bool IsGarbageCollecting();
/** True while constructors run on this thread: the depth of objects under construction. */
COREUOBJECT_API bool IsInConstructor();

/** Delegates of the object system. */
struct FCoreUObjectDelegates {
    /** Before reachability analysis. */
    static COREUOBJECT_API FSimpleMulticastDelegate& GetPreGarbageCollectDelegate();
    /** After the collection; destroyed objects' memory may still await the purge. */
    static COREUOBJECT_API FSimpleMulticastDelegate& GetPostGarbageCollect();
    /** After reachability analysis, before anything is destroyed. */
    static COREUOBJECT_API FSimpleMulticastDelegate PostReachabilityAnalysis;
    static COREUOBJECT_API FSimpleMulticastDelegate PreGarbageCollectConditionalBeginDestroy;
    static COREUOBJECT_API FSimpleMulticastDelegate PostGarbageCollectConditionalBeginDestroy;
    static COREUOBJECT_API FSimpleMulticastDelegate GarbageCollectComplete;
    DECLARE_MULTICAST_DELEGATE_OneParam(FOnAssetLoaded, UObject*);
    /** An object was supplied by a content loader. */
    static COREUOBJECT_API FOnAssetLoaded OnAssetLoaded;
    DECLARE_MULTICAST_DELEGATE_OneParam(FPreLoadMapDelegate, const FString& /*MapName*/);
    static COREUOBJECT_API FPreLoadMapDelegate PreLoadMap;
    DECLARE_MULTICAST_DELEGATE_OneParam(FPostLoadMapDelegate, class UWorld* /*LoadedWorld*/);
    static COREUOBJECT_API FPostLoadMapDelegate PostLoadMapWithWorld;
    /** After packages, enums, structs, classes of newly loaded modules exist and before their class default objects do.
     */
    DECLARE_MULTICAST_DELEGATE_OneParam(FCompiledInUObjectsRegisteredDelegate, FName /*Package*/);
    static COREUOBJECT_API FCompiledInUObjectsRegisteredDelegate CompiledInUObjectsRegisteredDelegate;
};

/** GetClass for null too. */
COREUOBJECT_API FString GetClassNameSafe(const UObject* Object);
