// SPDX-License-Identifier: MIT
// FPaths. Mirrors Epic's API page FPaths; the embedded engine has one content directory, which the launcher chooses.
#include "Misc/Paths.h"

#include <filesystem>

#include <unistd.h>

#include "CoreMinimal.h"
#include "HAL/FileManager.h"
#include "Misc/Guid.h"

namespace {

struct FDirectories {
    FString Launch, Engine, Project, Content;
    FDirectories() {
        char Buffer[4096];
        const ssize_t Size = readlink("/proc/self/exe", Buffer, sizeof(Buffer) - 1);
        Buffer[Size > 0 ? Size : 0] = 0;
        Launch = FPaths::GetPath(FString(UTF8_TO_TCHAR(Buffer))) + TEXT("/");
        Engine = Launch;
        Project = Launch;
        Content = Launch + TEXT("Content/");
    }
};
FDirectories& Directories() {
    static FDirectories Instance;
    return Instance;
}

FString AsDirectory(const FString& Dir) {
    FString Result = Dir;
    FPaths::NormalizeFilename(Result);
    return Result.EndsWith(TEXT("/")) ? Result : Result + TEXT("/");
}

int32 LastSlash(const FString& InPath) {
    int32 Slash = INDEX_NONE, Backslash = INDEX_NONE;
    InPath.FindLastChar(TEXT('/'), Slash);
    InPath.FindLastChar(TEXT('\\'), Backslash);
    return FMath::Max(Slash, Backslash);
}

} // namespace

FString FPaths::LaunchDir() { return Directories().Launch; }
FString FPaths::RootDir() { return Directories().Engine; }
FString FPaths::EngineDir() { return Directories().Engine; }
FString FPaths::EngineContentDir() { return Directories().Content; }
FString FPaths::EngineSavedDir() { return Directories().Engine + TEXT("Saved/"); }
FString FPaths::ProjectDir() { return Directories().Project; }
FString FPaths::ProjectContentDir() { return Directories().Content; }
FString FPaths::ProjectSavedDir() { return Directories().Project + TEXT("Saved/"); }
FString FPaths::ProjectConfigDir() { return Directories().Project + TEXT("Config/"); }
FString FPaths::ProjectLogDir() { return ProjectSavedDir() + TEXT("Logs/"); }
FString FPaths::ProjectPluginsDir() { return Directories().Project + TEXT("Plugins/"); }
FString FPaths::ProjectUserDir() { return Directories().Project; }
void FPaths::SetEngineDir(const FString& Dir) { Directories().Engine = AsDirectory(Dir); }
void FPaths::SetProjectDir(const FString& Dir) { Directories().Project = AsDirectory(Dir); }
void FPaths::SetContentDir(const FString& Dir) { Directories().Content = AsDirectory(Dir); }

FString FPaths::GetCleanFilename(const FString& InPath) { return InPath.Mid(LastSlash(InPath) + 1); }
FString FPaths::GetPathLeaf(const FString& InPath) {
    FString Path = InPath;
    NormalizeDirectoryName(Path);
    return GetCleanFilename(Path);
}
FString FPaths::GetPath(const FString& InPath) {
    const int32 Slash = LastSlash(InPath);
    return Slash == INDEX_NONE ? FString() : InPath.Left(Slash);
}
FString FPaths::GetExtension(const FString& InPath, bool bIncludeDot) {
    const FString Name = GetCleanFilename(InPath);
    int32 Dot = INDEX_NONE;
    return Name.FindLastChar(TEXT('.'), Dot) ? Name.Mid(Dot + (bIncludeDot ? 0 : 1)) : FString();
}
FString FPaths::GetBaseFilename(const FString& InPath, bool bRemovePath) {
    const FString Path = bRemovePath ? GetCleanFilename(InPath) : InPath;
    int32 Dot = INDEX_NONE;
    return Path.FindLastChar(TEXT('.'), Dot) && Dot > LastSlash(Path) ? Path.Left(Dot) : Path;
}
FString FPaths::SetExtension(const FString& InPath, const FString& InNewExtension) {
    const FString Extension =
        InNewExtension.IsEmpty() || InNewExtension.StartsWith(TEXT(".")) ? InNewExtension : TEXT(".") + InNewExtension;
    return GetBaseFilename(InPath, false) + Extension;
}
FString FPaths::ChangeExtension(const FString& InPath, const FString& InNewExtension) {
    return GetExtension(InPath).IsEmpty() ? InPath : SetExtension(InPath, InNewExtension);
}

bool FPaths::FileExists(const FString& InPath) { return IFileManager::Get().FileExists(*InPath); }
bool FPaths::DirectoryExists(const FString& InPath) { return IFileManager::Get().DirectoryExists(*InPath); }
bool FPaths::IsRelative(const FString& InPath) {
    return !InPath.StartsWith(TEXT("/")) && !InPath.StartsWith(TEXT("\\")) && !InPath.Mid(1, 1).Equals(TEXT(":"));
}
void FPaths::NormalizeFilename(FString& InPath) { InPath.ReplaceInline(TEXT("\\"), TEXT("/")); }
void FPaths::NormalizeDirectoryName(FString& InPath) {
    NormalizeFilename(InPath);
    if (InPath.Len() > 1 && InPath.EndsWith(TEXT("/"))) {
        InPath.LeftChopInline(1);
    }
}

bool FPaths::CollapseRelativeDirectories(FString& InPath) {
    NormalizeFilename(InPath);
    const bool bAbsolute = InPath.StartsWith(TEXT("/"));
    const bool bDirectory = InPath.EndsWith(TEXT("/"));
    TArray<FString> Parts, Kept;
    InPath.ParseIntoArray(Parts, TEXT("/"), true);
    for (const FString& Part : Parts) {
        if (Part == TEXT(".")) {
            continue;
        }
        if (Part == TEXT("..")) {
            if (Kept.IsEmpty()) {
                return false;
            }
            Kept.Pop();
        } else {
            Kept.Add(Part);
        }
    }
    InPath = (bAbsolute ? TEXT("/") : TEXT("")) + FString::Join(Kept, TEXT("/")) +
             (bDirectory && !Kept.IsEmpty() ? TEXT("/") : TEXT(""));
    return true;
}

FString FPaths::ConvertRelativePathToFull(const FString& InPath) {
    std::error_code Ignored;
    return ConvertRelativePathToFull(FString(UTF8_TO_TCHAR(std::filesystem::current_path(Ignored).c_str())), InPath);
}
FString FPaths::ConvertRelativePathToFull(const FString& BasePath, const FString& InPath) {
    FString Result = IsRelative(InPath) ? BasePath + TEXT("/") + InPath : InPath;
    CollapseRelativeDirectories(Result);
    return Result;
}

bool FPaths::MakePathRelativeTo(FString& InPath, const TCHAR* InRelativeTo) {
    const FString Target = ConvertRelativePathToFull(InPath);
    const FString Source = ConvertRelativePathToFull(InRelativeTo);
    TArray<FString> TargetParts, SourceParts;
    Target.ParseIntoArray(TargetParts, TEXT("/"), true);
    (Source.EndsWith(TEXT("/")) ? Source : GetPath(Source)).ParseIntoArray(SourceParts, TEXT("/"), true);
    int32 Common = 0;
    while (Common < TargetParts.Num() && Common < SourceParts.Num() && TargetParts[Common] == SourceParts[Common]) {
        ++Common;
    }
    FString Result;
    for (int32 Index = Common; Index < SourceParts.Num(); ++Index) {
        Result += TEXT("../");
    }
    for (int32 Index = Common; Index < TargetParts.Num(); ++Index) {
        Result += TargetParts[Index] + (Index + 1 < TargetParts.Num() ? TEXT("/") : TEXT(""));
    }
    InPath = Result;
    return true;
}

FString FPaths::MakeValidFileName(const FString& InString, const TCHAR InReplacementChar) {
    FString Result;
    for (const TCHAR Char : InString) {
        if (!Char) {
            break;
        }
        const bool bValid = Char >= TEXT(' ') && !FCString::Strchr(TEXT("/\\:*?\"<>|"), Char);
        if (bValid) {
            Result.AppendChar(Char);
        } else if (InReplacementChar) {
            Result.AppendChar(InReplacementChar);
        }
    }
    return Result;
}

bool FPaths::IsSamePath(const FString& PathA, const FString& PathB) {
    FString A = ConvertRelativePathToFull(PathA), B = ConvertRelativePathToFull(PathB);
    NormalizeDirectoryName(A);
    NormalizeDirectoryName(B);
    return A.Equals(B, ESearchCase::CaseSensitive);
}
bool FPaths::IsUnderDirectory(const FString& InPath, const FString& InDirectory) {
    FString Path = ConvertRelativePathToFull(InPath), Directory = ConvertRelativePathToFull(InDirectory);
    NormalizeDirectoryName(Path);
    NormalizeDirectoryName(Directory);
    return Path.Equals(Directory, ESearchCase::CaseSensitive) ||
           Path.StartsWith(Directory + TEXT("/"), ESearchCase::CaseSensitive);
}
FString FPaths::CreateTempFilename(const TCHAR* Path, const TCHAR* Prefix, const TCHAR* Extension) {
    return Combine(FString(Path), FString(Prefix) + FGuid::NewGuid().ToString() + Extension);
}
