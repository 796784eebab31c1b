// SPDX-License-Identifier: MIT
/** FPaths: file names, and the directories of engine and project. Directories end with '/'. */
#pragma once

#include "Containers/UnrealString.h"

class FPaths {
public:
    /** Directory of the executable, with '/'. */
    static CORE_API FString LaunchDir();
    static CORE_API FString RootDir();
    static CORE_API FString EngineDir();
    static CORE_API FString EngineContentDir();
    static CORE_API FString EngineSavedDir();
    static CORE_API FString ProjectDir();
    static CORE_API FString ProjectContentDir();
    static CORE_API FString ProjectSavedDir();
    static CORE_API FString ProjectConfigDir();
    static CORE_API FString ProjectLogDir();
    static CORE_API FString ProjectPluginsDir();
    static CORE_API FString ProjectUserDir();
    /** What the launcher decides: until then the directory of the executable. */
    static CORE_API void SetEngineDir(const FString& Dir);
    static CORE_API void SetProjectDir(const FString& Dir);
    static CORE_API void SetContentDir(const FString& Dir);

    static CORE_API FString GetExtension(const FString& InPath, bool bIncludeDot = false);
    static CORE_API FString GetCleanFilename(const FString& InPath);
    static CORE_API FString GetBaseFilename(const FString& InPath, bool bRemovePath = true);
    static CORE_API FString GetPath(const FString& InPath);
    static CORE_API FString GetPathLeaf(const FString& InPath);
    static CORE_API FString ChangeExtension(const FString& InPath, const FString& InNewExtension);
    static CORE_API FString SetExtension(const FString& InPath, const FString& InNewExtension);
    static CORE_API bool FileExists(const FString& InPath);
    static CORE_API bool DirectoryExists(const FString& InPath);
    static CORE_API bool IsRelative(const FString& InPath);
    static CORE_API void NormalizeFilename(FString& InPath);
    static CORE_API void NormalizeDirectoryName(FString& InPath);
    /** Removes "..": false if there are more of them than directories. */
    static CORE_API bool CollapseRelativeDirectories(FString& InPath);
    static CORE_API FString ConvertRelativePathToFull(const FString& InPath);
    static CORE_API FString ConvertRelativePathToFull(const FString& BasePath, const FString& InPath);
    static CORE_API bool MakePathRelativeTo(FString& InPath, const TCHAR* InRelativeTo);
    static CORE_API FString MakeValidFileName(const FString& InString, const TCHAR InReplacementChar = 0);
    static CORE_API bool IsSamePath(const FString& PathA, const FString& PathB);
    static CORE_API bool IsUnderDirectory(const FString& InPath, const FString& InDirectory);
    static CORE_API FString CreateTempFilename(
        const TCHAR* Path, const TCHAR* Prefix = TEXT(""), const TCHAR* Extension = TEXT(".tmp"));
    /** Joins with exactly one '/' between parts. */
    template <typename... PathTypes>
    static FString Combine(PathTypes&&... InPaths) {
        FString Result;
        (CombineOne(Result, FString(Forward<PathTypes>(InPaths))), ...);
        return Result;
    }

private:
    static void CombineOne(FString& Result, const FString& Part) {
        if (Result.IsEmpty()) {
            Result = Part;
        } else {
            Result.PathAppend(*Part, Part.Len());
        }
    }
};
