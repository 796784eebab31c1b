// SPDX-License-Identifier: MIT
// Soft references: paths of objects that may not be loaded. Mirrors Epic's "UObject/SoftObjectPath.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/TopLevelAssetPath.h"

class FOutputDevice;
class UClass;
class UObject;

/** Path of an asset ("/Package.Asset") with an optional path to an object inside ("Sub.SubSub"). */
struct FSoftObjectPath {
    FSoftObjectPath() = default;
    FSoftObjectPath(TYPE_OF_NULLPTR) {}
    FSoftObjectPath(const FString& Path) { SetPath(Path); }
    explicit FSoftObjectPath(const TCHAR* Path) { SetPath(FString(Path)); }
    FSoftObjectPath(FTopLevelAssetPath InAssetPath, FString InSubPathString = FString())
        : AssetPath(InAssetPath), SubPathString(MoveTemp(InSubPathString)) {}
    FSoftObjectPath(FName InPackageName, FName InAssetName, const FString& InSubPathString)
        : AssetPath(InPackageName, InAssetName), SubPathString(InSubPathString) {}
    COREUOBJECT_API FSoftObjectPath(const UObject* InObject);

    /** "/Package.Asset:Sub", empty for a null path. */
    COREUOBJECT_API FString ToString() const;
    void ToString(FString& Out) const { Out = ToString(); }
    FTopLevelAssetPath GetAssetPath() const { return AssetPath; }
    FTopLevelAssetPath GetWithoutSubPath() const { return AssetPath; }
    FString GetAssetPathString() const { return IsNull() ? FString() : AssetPath.ToString(); }
    const FString& GetSubPathString() const { return SubPathString; }
    void SetSubPathString(const FString& InSubPathString) { SubPathString = InSubPathString; }
    FName GetLongPackageFName() const { return AssetPath.GetPackageName(); }
    FString GetLongPackageName() const { return IsNull() ? FString() : AssetPath.GetPackageName().ToString(); }
    FName GetAssetFName() const { return AssetPath.GetAssetName(); }
    FString GetAssetName() const {
        return AssetPath.GetAssetName().IsNone() ? FString() : AssetPath.GetAssetName().ToString();
    }

    /** Parses a path; text of the form "Class'/Path'" loses its class. */
    COREUOBJECT_API void SetPath(const FString& Path);
    /** Finds or loads the object. */
    COREUOBJECT_API UObject* TryLoad(void* InLoadContext = nullptr) const;
    /** Finds the object in memory. */
    COREUOBJECT_API UObject* ResolveObject() const;
    void Reset() {
        AssetPath.Reset();
        SubPathString.Reset();
    }
    bool IsValid() const { return AssetPath.IsValid(); }
    bool IsNull() const { return AssetPath.IsNull(); }
    bool IsAsset() const { return !IsNull() && SubPathString.IsEmpty(); }
    bool IsSubobject() const { return !IsNull() && !SubPathString.IsEmpty(); }

    bool operator==(const FSoftObjectPath& Other) const {
        return AssetPath == Other.AssetPath && SubPathString == Other.SubPathString;
    }
    bool operator==(TYPE_OF_NULLPTR) const { return IsNull(); }
    friend uint32 GetTypeHash(const FSoftObjectPath& This) {
        return HashCombineFast(
            GetTypeHash(This.AssetPath), This.SubPathString.IsEmpty() ? 0 : GetTypeHash(This.SubPathString));
    }

    COREUOBJECT_API bool ExportTextItem(FString& ValueStr, const FSoftObjectPath& DefaultValue, UObject* Parent,
        int32 PortFlags, UObject* ExportRootScope) const;
    COREUOBJECT_API bool ImportTextItem(
        const TCHAR*& Buffer, int32 PortFlags, UObject* Parent, FOutputDevice* ErrorText);

    static FSoftObjectPath GetOrCreateIDForObject(const UObject* Object) { return FSoftObjectPath(Object); }
    static int32 GetCurrentTag() { return 1; }

private:
    friend struct Z_Construct_UScriptStruct_FSoftObjectPath_Statics;
    FTopLevelAssetPath AssetPath;
    FString SubPathString;
};

/** A soft path of a class. */
struct FSoftClassPath : public FSoftObjectPath {
    FSoftClassPath() = default;
    FSoftClassPath(const FString& PathString) : FSoftObjectPath(PathString) {}
    COREUOBJECT_API FSoftClassPath(const UClass* InClass);

    template <typename T>
    UClass* TryLoadClass() const {
        return LoadClassOfBase(T::StaticClass());
    }
    COREUOBJECT_API UClass* ResolveClass() const;
    static FSoftClassPath GetOrCreateIDForClass(const UClass* InClass) { return FSoftClassPath(InClass); }

private:
    COREUOBJECT_API UClass* LoadClassOfBase(UClass* BaseClass) const;
};
