// SPDX-License-Identifier: MIT
/** FEngineVersion: the UE version whose API this engine offers. */
#pragma once

#include "Containers/UnrealString.h"

enum class EVersionComponent { Major, Minor, Patch, Changelist, Branch };

class FEngineVersion {
public:
    FEngineVersion() = default;
    FEngineVersion(uint16 InMajor, uint16 InMinor, uint16 InPatch, uint32 InChangelist, const FString& InBranch)
        : Major(InMajor), Minor(InMinor), Patch(InPatch), Changelist(InChangelist), Branch(InBranch) {}
    /** 5.5.0, branch "spear-embedded". */
    static CORE_API const FEngineVersion& Current();
    uint16 GetMajor() const { return Major; }
    uint16 GetMinor() const { return Minor; }
    uint16 GetPatch() const { return Patch; }
    uint32 GetChangelist() const { return Changelist; }
    const FString& GetBranch() const { return Branch; }
    bool IsEmpty() const { return Major == 0 && Minor == 0 && Patch == 0; }
    /** "5.5.0-0+spear-embedded". */
    CORE_API FString ToString(EVersionComponent LastComponent = EVersionComponent::Branch) const;

private:
    uint16 Major = 0;
    uint16 Minor = 0;
    uint16 Patch = 0;
    uint32 Changelist = 0;
    FString Branch;
};
#define ENGINE_MAJOR_VERSION 5
#define ENGINE_MINOR_VERSION 5
#define ENGINE_PATCH_VERSION 0
