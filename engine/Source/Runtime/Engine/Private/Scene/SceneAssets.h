// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

#include "../ThirdParty/GltfFile.h"

class UMaterialInterface;
class UObject;
class UStaticMesh;
class UTexture2D;

/**
 * Makes the assets of a scene: "/Game/Scenes/<scene>/Meshes/<Name>.<Name>", ".../Materials/..." and ".../Textures/...".
 * An asset of the same path and class that is in memory is filled anew.
 */
class FSceneAssets {
public:
    FSceneAssets(const SceneFile::FDocument& InDocument, const FString& InSceneName);

    /** Makes everything. False with a text naming the asset that failed. */
    bool Build(FString& OutError);

    /** Mesh by glTF index; null for -1 and for meshes without triangles. */
    UStaticMesh* GetMesh(int Index) const;

private:
    UTexture2D* Texture(int TextureIndex, bool bColor, FString& OutError);
    UTexture2D* OcclusionRoughnessMetallic(const SceneFile::FMaterial& Material, FString& OutError);
    bool BuildMaterials(FString& OutError);
    bool BuildMeshes(FString& OutError);

    const SceneFile::FDocument& Document;
    FString Root;
    TMap<FString, UTexture2D*> Textures;
    TArray<UMaterialInterface*> Materials;
    TArray<UStaticMesh*> Meshes;
};

namespace SceneAssetNames {

/** Text as an object name: characters that paths use, and spaces, become '_'. */
FString Clean(const FString& Text);

} // namespace SceneAssetNames
