// SPDX-License-Identifier: MIT
using System.IO;
using UnrealBuildTool;

// The plugin needs two things from outside its folder: the headers of the SDK, and the library spear_wire, which is built beforehand
// with any compiler (it has a C interface): `cmake --build build/release --target spear_wire`, `cmake --install build/release`.
// SPEAR_ROOT names the checkout, SPEAR_WIRE the folder with the built library; both have defaults for a plugin inside the checkout.
public class SpearServer : ModuleRules
{
    public SpearServer(ReadOnlyTargetRules Target) : base(Target)
    {
        PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
        CppStandard = CppStandardVersion.Cpp20;
        bEnableExceptions = false;
        bUseRTTI = false;

        PublicDependencyModuleNames.AddRange(new string[] { "Core", "CoreUObject", "Engine" });

        string Root = System.Environment.GetEnvironmentVariable("SPEAR_ROOT") ?? Path.GetFullPath(Path.Combine(PluginDirectory, ".."));
        PrivateIncludePaths.Add(Path.Combine(ModuleDirectory, "Private"));
        PrivateIncludePaths.Add(Path.Combine(Root, "sdk", "include"));
        PrivateIncludePaths.Add(Path.Combine(Root, "sdk", "src", "wire"));

        string Wire = System.Environment.GetEnvironmentVariable("SPEAR_WIRE") ?? Path.Combine(Root, "build", "release", "lib");
        if (Target.Platform == UnrealTargetPlatform.Win64)
        {
            PublicAdditionalLibraries.Add(Path.Combine(Wire, "spear_wire.lib"));
            PublicDelayLoadDLLs.Add("spear_wire.dll");
            RuntimeDependencies.Add("$(BinaryOutputDir)/spear_wire.dll", Path.Combine(Wire, "spear_wire.dll"));
        }
        else
        {
            string Library = Target.Platform == UnrealTargetPlatform.Mac ? "libspear_wire.dylib" : "libspear_wire.so";
            PublicAdditionalLibraries.Add(Path.Combine(Wire, Library));
            RuntimeDependencies.Add("$(BinaryOutputDir)/" + Library, Path.Combine(Wire, Library));
        }
    }
}
