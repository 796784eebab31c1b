// SPDX-License-Identifier: MIT
// UPackage, the outermost object. Mirrors Epic's "UObject/Package.h".
#pragma once

#include "UObject/Class.h"
#include "UObject/Object.h"

/** A package: "/Script/Module" for native types, "/Game/..." for content, "/Engine/Transient" for the rest. */
class COREUOBJECT_API UPackage : public UObject {
    UE_DECLARE_INTRINSIC(UPackage, UObject, CLASS_None, CASTCLASS_UPackage)

    void SetPackageFlags(uint32 NewFlags) { PackageFlags |= NewFlags; }
    void ClearPackageFlags(uint32 NewFlags) { PackageFlags &= ~NewFlags; }
    bool HasAnyPackageFlags(uint32 FlagsToCheck) const { return (PackageFlags & FlagsToCheck) != 0; }
    bool HasAllPackagesFlags(uint32 FlagsToCheck) const { return (PackageFlags & FlagsToCheck) == FlagsToCheck; }
    uint32 GetPackageFlags() const { return PackageFlags; }
    bool ContainsMap() const { return HasAnyPackageFlags(PKG_ContainsMap); }
    bool IsFullyLoaded() const { return true; }
    void FullyLoad() {}
    bool IsDirty() const { return bDirty; }
    void SetDirtyFlag(bool bIsDirty) { bDirty = bIsDirty; }
    /** Name of the package, which is also its path. */
    FName GetLoadedPath() const { return GetFName(); }

private:
    uint32 PackageFlags = PKG_None;
    bool bDirty = false;
};
