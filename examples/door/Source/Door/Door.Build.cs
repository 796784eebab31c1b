// SPDX-License-Identifier: MIT
using UnrealBuildTool;

public class Door : ModuleRules
{
    public Door(ReadOnlyTargetRules Target) : base(Target)
    {
        PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
        PublicDependencyModuleNames.AddRange(new string[] { "Core", "CoreUObject", "Engine" });
    }
}
