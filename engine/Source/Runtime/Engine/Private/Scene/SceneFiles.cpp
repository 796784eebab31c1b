// SPDX-License-Identifier: MIT
// Where scenes are: content folders, bare names, folders, pairs of glTF file and sidecar.

#include "Engine/SceneLoader.h"

#include "SceneConversion.h"
#include "../ThirdParty/SidecarFile.h"

#include "HAL/FileManager.h"
#include "HAL/PlatformMisc.h"
#include "HAL/PlatformProcess.h"
#include "Misc/Paths.h"

namespace {

const TCHAR* SidecarSuffix = TEXT(".scene.json");

FString WithoutSuffix(const FString& Path) {
    for (const TCHAR* Suffix : {SidecarSuffix, TEXT(".gltf"), TEXT(".glb")}) {
        if (Path.EndsWith(Suffix)) {
            return Path.LeftChop(FCString::Strlen(Suffix));
        }
    }
    return Path;
}

/** Fills paths from a file that exists. */
bool FromFile(const FString& File, FSceneLoader::FSettings& Out, FString& OutError) {
    const FString Sidecar = WithoutSuffix(File) + SidecarSuffix;
    Out.Name = FPaths::GetCleanFilename(WithoutSuffix(File));
    Out.GltfPath = File.EndsWith(SidecarSuffix) ? FString() : File;
    Out.SidecarPath = FPaths::FileExists(Sidecar) ? Sidecar : FString();
    if (Out.SidecarPath.IsEmpty()) {
        return true;
    }
    SceneFile::FSidecar Document;
    std::string Error;
    if (!SceneFile::ReadSidecar(SceneConversion::ToStd(Out.SidecarPath), Document, Error)) {
        OutError = SceneConversion::ToString(Error);
        return false;
    }
    if (!Document.Name.empty()) {
        Out.Name = SceneConversion::ToString(Document.Name);
    }
    Out.GameMode = SceneConversion::ToString(Document.GameMode);
    if (Out.GltfPath.IsEmpty()) {
        Out.GltfPath = FPaths::GetPath(Out.SidecarPath) / SceneConversion::ToString(Document.Gltf);
        if (!FPaths::FileExists(Out.GltfPath)) {
            OutError = FString::Printf(TEXT("%s: its glTF file %s does not exist"), *Out.SidecarPath, *Out.GltfPath);
            return false;
        }
    }
    return true;
}

/** The one scene of a folder: the sidecar if there is one, else the glTF file. */
bool FromFolder(const FString& Folder, FSceneLoader::FSettings& Out, FString& OutError) {
    for (const TCHAR* Pattern : {TEXT("*.scene.json"), TEXT("*.gltf"), TEXT("*.glb")}) {
        TArray<FString> Found;
        IFileManager::Get().FindFiles(Found, *(Folder / Pattern), true, false);
        if (Found.Num() > 1) {
            OutError = FString::Printf(
                TEXT("%s holds %d scenes; name one of them, such as %s"), *Folder, Found.Num(), *(Folder / Found[0]));
            return false;
        }
        if (Found.Num() == 1) {
            return FromFile(Folder / Found[0], Out, OutError);
        }
    }
    OutError = FString::Printf(TEXT("%s holds no scene (.scene.json, .gltf or .glb)"), *Folder);
    return false;
}

} // namespace

TArray<FString> FSceneLoader::GetContentFolders() {
    TArray<FString> Result;
    TArray<FString> Configured;
    FPlatformMisc::GetEnvironmentVariable(TEXT("SPEAR_CONTENT_DIR")).ParseIntoArray(Configured, TEXT(":"), true);
    Result.Append(Configured);
    FString Folder = FPaths::ConvertRelativePathToFull(FPlatformProcess::BaseDir());
    while (Folder.EndsWith(TEXT("/")) && Folder.Len() > 1) {
        Folder = Folder.LeftChop(1);
    }
    for (int32 Level = 0; Level < 6 && !Folder.IsEmpty(); ++Level) {
        for (const TCHAR* Name : {TEXT("content"), TEXT("share/spear/content")}) {
            const FString Candidate = Folder / Name;
            if (FPaths::DirectoryExists(Candidate)) {
                Result.Add(Candidate);
            }
        }
        const FString Parent = FPaths::GetPath(Folder);
        if (Parent == Folder) {
            break;
        }
        Folder = Parent;
    }
    return Result;
}

bool FSceneLoader::ReadSceneSettings(const FString& Path, FSettings& OutSettings, FString& OutError) {
    OutSettings = FSettings();
    if (Path.IsEmpty()) {
        OutError = TEXT("the name of the scene is empty");
        return false;
    }
    if (FPaths::DirectoryExists(Path)) {
        return FromFolder(Path, OutSettings, OutError);
    }
    if (FPaths::FileExists(Path)) {
        if (WithoutSuffix(Path) == Path) {
            OutError = FString::Printf(TEXT("%s is not a scene; expected a .gltf, .glb or .scene.json file"), *Path);
            return false;
        }
        return FromFile(Path, OutSettings, OutError);
    }
    const TArray<FString> Folders = GetContentFolders();
    FString Searched;
    FString Known;
    for (const FString& Content : Folders) {
        const FString Scenes = Content / TEXT("Scenes");
        if (FPaths::DirectoryExists(Scenes / Path)) {
            return FromFolder(Scenes / Path, OutSettings, OutError);
        }
        Searched += (Searched.IsEmpty() ? TEXT("") : TEXT(", ")) + Scenes;
        TArray<FString> Names;
        IFileManager::Get().FindFiles(Names, *(Scenes / TEXT("*")), false, true);
        for (const FString& Name : Names) {
            Known += (Known.IsEmpty() ? TEXT("") : TEXT(", ")) + Name;
        }
    }
    OutError = FString::Printf(
        TEXT("there is no scene '%s': no such file, and no folder of that name in %s. Known scenes: %s"), *Path,
        Searched.IsEmpty() ? TEXT("(no content folder; set SPEAR_CONTENT_DIR)") : *Searched,
        Known.IsEmpty() ? TEXT("none") : *Known);
    return false;
}
