// SPDX-License-Identifier: MIT
// Package and asset name of a top-level object. Mirrors Epic's "UObject/TopLevelAssetPath.h".
#pragma once

#include "CoreMinimal.h"

class UObject;

/** "/Package/Path.Asset" as two names. */
struct FTopLevelAssetPath {
    FTopLevelAssetPath() = default;
    FTopLevelAssetPath(TYPE_OF_NULLPTR) {}
    FTopLevelAssetPath(FName InPackageName, FName InAssetName) : PackageName(InPackageName), AssetName(InAssetName) {}
    explicit FTopLevelAssetPath(const FString& Path) { TrySetPath(Path); }
    explicit FTopLevelAssetPath(const TCHAR* Path) { TrySetPath(FString(Path)); }
    /** Path of a top-level object; none for subobjects. */
    COREUOBJECT_API explicit FTopLevelAssetPath(const UObject* InObject);

    /** Parses "/Package" or "/Package.Asset"; false and empty for anything else. */
    COREUOBJECT_API bool TrySetPath(const FString& Path);
    bool TrySetPath(FName InPackageName, FName InAssetName) {
        PackageName = InPackageName;
        AssetName = InAssetName;
        return IsValid();
    }
    FName GetPackageName() const { return PackageName; }
    FName GetAssetName() const { return AssetName; }
    COREUOBJECT_API FString ToString() const;
    void AppendString(FString& Out) const { Out += ToString(); }
    bool IsValid() const { return !PackageName.IsNone(); }
    bool IsNull() const { return PackageName.IsNone(); }
    void Reset() { *this = FTopLevelAssetPath(); }
    bool operator==(const FTopLevelAssetPath& Other) const {
        return PackageName == Other.PackageName && AssetName == Other.AssetName;
    }
    friend uint32 GetTypeHash(const FTopLevelAssetPath& Path) {
        return HashCombineFast(GetTypeHash(Path.PackageName), GetTypeHash(Path.AssetName));
    }

private:
    friend struct Z_Construct_UScriptStruct_FTopLevelAssetPath_Statics;
    FName PackageName;
    FName AssetName;
};
