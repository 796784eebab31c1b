// SPDX-License-Identifier: MIT
// Where content comes from. Not a UE header: UE reads packages from disk itself, here modules supply objects by path.
#pragma once

#include "CoreMinimal.h"
#include "Templates/Function.h"

class UClass;
class UObject;

/**
 * Content loaders supply objects for paths that are not in memory ("/Engine/BasicShapes/Cube.Cube"). StaticLoadObject
 * asks them in the order of registration; the first non-null answer counts. A loader creates the object below a package
 * of the path's name (CreatePackage), so that it is found in memory next time.
 */
class FContentLoaderRegistry {
public:
    /** Class may be null for "any". PackageName "/Engine/BasicShapes/Cube", AssetName "Cube". */
    using FLoader = TFunction<UObject*(UClass* Class, const FString& PackageName, const FString& AssetName)>;

    /** Adds a loader under a name (for reports and removal). */
    static COREUOBJECT_API void Register(FName LoaderName, FLoader Loader);
    static COREUOBJECT_API void Unregister(FName LoaderName);
    /** Asks all loaders. */
    static COREUOBJECT_API UObject* Load(UClass* Class, const FString& PackageName, const FString& AssetName);
};
