// SPDX-License-Identifier: MIT
// Finding, loading and naming objects.
#include "UObject/UObjectGlobals.h"

#include <unordered_map>

#include "ObjectSystem.h"
#include "UObject/Class.h"
#include "UObject/ContentLoader.h"
#include "UObject/Package.h"

DEFINE_LOG_CATEGORY_STATIC(LogUObjectGlobals, Log, All);

FSimpleMulticastDelegate FCoreUObjectDelegates::PostReachabilityAnalysis;
FSimpleMulticastDelegate FCoreUObjectDelegates::PreGarbageCollectConditionalBeginDestroy;
FSimpleMulticastDelegate FCoreUObjectDelegates::PostGarbageCollectConditionalBeginDestroy;
FSimpleMulticastDelegate FCoreUObjectDelegates::GarbageCollectComplete;
FCoreUObjectDelegates::FOnAssetLoaded FCoreUObjectDelegates::OnAssetLoaded;
FCoreUObjectDelegates::FPreLoadMapDelegate FCoreUObjectDelegates::PreLoadMap;
FCoreUObjectDelegates::FPostLoadMapDelegate FCoreUObjectDelegates::PostLoadMapWithWorld;
FCoreUObjectDelegates::FCompiledInUObjectsRegisteredDelegate
    FCoreUObjectDelegates::CompiledInUObjectsRegisteredDelegate;

FSimpleMulticastDelegate& FCoreUObjectDelegates::GetPreGarbageCollectDelegate() {
    static FSimpleMulticastDelegate Delegate;
    return Delegate;
}
FSimpleMulticastDelegate& FCoreUObjectDelegates::GetPostGarbageCollect() {
    static FSimpleMulticastDelegate Delegate;
    return Delegate;
}

UPackage* GetTransientPackage() {
    static UPackage* const Package = [] {
        UPackage* Result = NewObject<UPackage>(nullptr, TEXT("/Engine/Transient"), RF_Transient);
        Result->AddToRoot();
        return Result;
    }();
    return Package;
}
UObject* GetTransientPackageAsObject() { return GetTransientPackage(); }

FName MakeUniqueObjectName(UObject* Parent, const UClass* Class, FName BaseName) {
    if (BaseName.IsNone()) {
        BaseName = Class->GetFName();
    }
    // The search starts at the number after the last one given out, so that many objects of one name stay cheap.
    struct FKeyHash {
        SIZE_T operator()(const FNameOuterKey& Key) const {
            return HashCombineFast(GetTypeHash(Key.Name), PointerHash(Key.Outer));
        }
    };
    static std::unordered_map<FNameOuterKey, int32, FKeyHash>& NextNumbers =
        *new std::unordered_map<FNameOuterKey, int32, FKeyHash>;
    const FName Plain(BaseName, NAME_NO_NUMBER_INTERNAL);
    // Numbers are counted per class, as in UE: they never go back while the process runs.
    int32& Number = NextNumbers[{Class, Plain}];
    for (;;) {
        const FName Candidate(Plain, NAME_EXTERNAL_TO_INTERNAL(Number));
        ++Number;
        if (!FObjectSystem::Find(nullptr, Parent, Candidate, false, RF_NoFlags, EInternalObjectFlags::None)) {
            return Candidate;
        }
    }
}

// ---------------------------------------------------------------------------------------------------------------------------

UObject* StaticFindObjectFast(UClass* Class, UObject* InOuter, FName InName, bool bExactClass,
    EObjectFlags ExclusiveFlags, EInternalObjectFlags ExclusiveInternalFlags) {
    return FObjectSystem::Find(Class, InOuter, InName, bExactClass, ExclusiveFlags, ExclusiveInternalFlags);
}

namespace {
/** "Class'/Path'" without the class part and the quotes. */
FString WithoutClassPrefix(const FString& Path) {
    int32 Quote = INDEX_NONE;
    if (Path.FindChar(TCHAR('\''), Quote)) {
        FString Rest = Path.Mid(Quote + 1);
        Rest.RemoveFromEnd(TEXT("'"));
        return Rest;
    }
    return Path;
}

/** First '.' or ':' of a path, not counting dots before the last slash. */
int32 FindDelimiter(const FString& Path, int32 From) {
    for (int32 Index = From; Index < Path.Len(); ++Index) {
        if (Path[Index] == TCHAR('.') || Path[Index] == TCHAR(':')) {
            return Index;
        }
    }
    return INDEX_NONE;
}
} // namespace

bool ResolveName(UObject*& InPackage, FString& InOutName, bool Create, bool Throw, uint32 LoadFlags,
    const FLinkerInstancingContext*) {
    InOutName = WithoutClassPrefix(InOutName);
    for (;;) {
        const int32 Delimiter = FindDelimiter(InOutName, 0);
        if (Delimiter == INDEX_NONE) {
            return true;
        }
        const FString Part = InOutName.Left(Delimiter);
        UObject* Next = Part.IsEmpty() ? nullptr : StaticFindObjectFast(nullptr, InPackage, FName(*Part));
        if (!Next && !InPackage && Create && !Part.IsEmpty()) {
            Next = CreatePackage(*Part);
        }
        if (!Next) {
            return false;
        }
        InPackage = Next;
        InOutName = InOutName.Mid(Delimiter + 1);
    }
}

UObject* StaticFindObject(UClass* Class, UObject* InOuter, const TCHAR* Name, bool bExactClass) {
    checkf(Name, TEXT("StaticFindObject: no name was given"));
    UObject* Outer = InOuter;
    FString ObjectName(Name);
    if (!ResolveName(Outer, ObjectName, false, false) || ObjectName.IsEmpty()) {
        return nullptr;
    }
    return StaticFindObjectFast(Class, Outer, FName(*ObjectName), bExactClass);
}
UObject* StaticFindObjectChecked(UClass* Class, UObject* InOuter, const TCHAR* Name, bool bExactClass) {
    UObject* Result = StaticFindObject(Class, InOuter, Name, bExactClass);
    checkf(Result, TEXT("Object %s of class %s inside %s does not exist"), Name, *GetNameSafe(Class),
        *GetPathNameSafe(InOuter));
    return Result;
}
UObject* StaticFindObjectSafe(UClass* Class, UObject* InOuter, const TCHAR* Name, bool bExactClass) {
    return IsGarbageCollecting() ? nullptr : StaticFindObject(Class, InOuter, Name, bExactClass);
}
UObject* StaticFindFirstObject(UClass* Class, const TCHAR* Name, EFindFirstObjectOptions Options) {
    const FString Text(Name);
    if (Text.StartsWith(TEXT("/")) || FindDelimiter(Text, 0) != INDEX_NONE) {
        return StaticFindObject(Class, nullptr, Name, EnumHasAnyFlags(Options, EFindFirstObjectOptions::ExactClass));
    }
    int32 NumFound = 0;
    UObject* Result =
        FObjectSystem::FindByName(Class, FName(Name), EnumHasAnyFlags(Options, EFindFirstObjectOptions::ExactClass),
            RF_NoFlags, EInternalObjectFlags::None, NumFound);
    ensureMsgf(NumFound < 2 || !EnumHasAnyFlags(Options, EFindFirstObjectOptions::EnsureIfAmbiguous),
        TEXT("'%s' names %d objects; use a path"), Name, NumFound);
    return Result;
}

// ---------------------------------------------------------------------------------------------------------------------------

namespace {
struct FNamedLoader {
    FName Name;
    FContentLoaderRegistry::FLoader Loader;
};
TArray<FNamedLoader>& Loaders() {
    static TArray<FNamedLoader>& Instance = *new TArray<FNamedLoader>;
    return Instance;
}
} // namespace

void FContentLoaderRegistry::Register(FName LoaderName, FLoader Loader) {
    Unregister(LoaderName);
    Loaders().Add({LoaderName, MoveTemp(Loader)});
}
void FContentLoaderRegistry::Unregister(FName LoaderName) {
    Loaders().RemoveAll([LoaderName](const FNamedLoader& Entry) { return Entry.Name == LoaderName; });
}
UObject* FContentLoaderRegistry::Load(UClass* Class, const FString& PackageName, const FString& AssetName) {
    // A loader may register others; walk a copy.
    const TArray<FNamedLoader> Copy = Loaders();
    for (const FNamedLoader& Entry : Copy) {
        if (UObject* Object = Entry.Loader(Class, PackageName, AssetName)) {
            return Object;
        }
    }
    return nullptr;
}

UObject* StaticLoadObject(UClass* Class, UObject* InOuter, const TCHAR* Name, const TCHAR*, uint32 LoadFlags,
    UPackageMap*, bool, const FLinkerInstancingContext*) {
    checkf(Name, TEXT("StaticLoadObject: no name was given"));
    UClass* const Wanted = Class ? Class : UObject::StaticClass();
    FString Path = WithoutClassPrefix(FString(Name));
    if (Path.IsEmpty()) {
        return nullptr;
    }
    if (UObject* Found = StaticFindObject(Wanted, InOuter, *Path)) {
        return Found;
    }
    FString PackageName = InOuter ? InOuter->GetPackage()->GetName() : Path;
    FString Rest;
    if (!InOuter) {
        const int32 Delimiter = FindDelimiter(Path, 0);
        if (Delimiter != INDEX_NONE) {
            PackageName = Path.Left(Delimiter);
            Rest = Path.Mid(Delimiter + 1);
        } else {
            // "/Game/Foo" means "/Game/Foo.Foo".
            int32 Slash = INDEX_NONE;
            Path.FindLastChar(TCHAR('/'), Slash);
            Rest = Path.Mid(Slash + 1);
        }
    } else {
        Rest = Path;
    }
    if (UObject* Found = StaticFindObject(Wanted, nullptr, *(PackageName + TEXT(".") + Rest))) {
        return Found;
    }
    const int32 SubDelimiter = FindDelimiter(Rest, 0);
    const FString AssetName = SubDelimiter == INDEX_NONE ? Rest : Rest.Left(SubDelimiter);
    UObject* Asset = FContentLoaderRegistry::Load(SubDelimiter == INDEX_NONE ? Class : nullptr, PackageName, AssetName);
    if (Asset && SubDelimiter != INDEX_NONE) {
        Asset = StaticFindObject(Wanted, Asset, *Rest.Mid(SubDelimiter + 1));
    }
    if (Asset && !Asset->IsA(Wanted)) {
        UE_LOG(LogUObjectGlobals, Warning, TEXT("%s is a %s, not a %s"), *Path, *Asset->GetClass()->GetName(),
            *Wanted->GetName());
        return nullptr;
    }
    if (Asset) {
        Asset->ConditionalPostLoad();
        FCoreUObjectDelegates::OnAssetLoaded.Broadcast(Asset);
    } else if (!(LoadFlags & (LOAD_NoWarn | LOAD_Quiet))) {
        UE_LOG(LogUObjectGlobals, Warning, TEXT("Failed to find object '%s %s'"), *Wanted->GetName(), *Path);
    }
    return Asset;
}

UClass* StaticLoadClass(UClass* BaseClass, UObject* InOuter, const TCHAR* Name, const TCHAR* Filename, uint32 LoadFlags,
    UPackageMap* Sandbox) {
    UClass* Class =
        static_cast<UClass*>(StaticLoadObject(UClass::StaticClass(), InOuter, Name, Filename, LoadFlags, Sandbox));
    if (Class && BaseClass && !Class->IsChildOf(BaseClass)) {
        UE_LOG(
            LogUObjectGlobals, Warning, TEXT("%s is no child of %s"), *Class->GetPathName(), *BaseClass->GetPathName());
        return nullptr;
    }
    return Class;
}

UPackage* FindPackage(UObject* InOuter, const TCHAR* PackageName) {
    return static_cast<UPackage*>(StaticFindObjectFast(UPackage::StaticClass(), nullptr, FName(PackageName)));
}
UPackage* CreatePackage(const TCHAR* PackageName) {
    checkf(PackageName && *PackageName, TEXT("CreatePackage: no name was given"));
    if (UPackage* Existing = FindPackage(nullptr, PackageName)) {
        return Existing;
    }
    return NewObject<UPackage>(nullptr, FName(PackageName), RF_Public);
}
UPackage* LoadPackage(UPackage*, const TCHAR* InLongPackageName, uint32 LoadFlags) {
    if (UPackage* Existing = FindPackage(nullptr, InLongPackageName)) {
        return Existing;
    }
    UObject* Asset = StaticLoadObject(nullptr, nullptr, InLongPackageName, nullptr, LoadFlags);
    return Asset ? Asset->GetPackage() : nullptr;
}

bool IsAsyncLoading() { return false; }
bool IsLoading() { return false; }
void FlushAsyncLoading(int32) {}
