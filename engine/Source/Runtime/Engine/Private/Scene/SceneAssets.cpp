// SPDX-License-Identifier: MIT
#include "SceneAssets.h"

#include "Engine/StaticMesh.h"
#include "Engine/Texture2D.h"
#include "Materials/Material.h"
#include "Materials/MaterialInstanceConstant.h"
#include "SceneConversion.h"
#include "UObject/Package.h"
#include "UObject/UObjectGlobals.h"

namespace {

/** Finds or makes the asset PackagePath.Name of a class. */
template <typename AssetType>
AssetType* FindOrMakeAsset(const FString& PackagePath, const FString& Name) {
    UPackage* Package = CreatePackage(*(PackagePath / Name));
    if (AssetType* Existing = FindObject<AssetType>(Package, *Name)) {
        return Existing;
    }
    return NewObject<AssetType>(Package, FName(*Name), RF_Public | RF_Standalone);
}

TextureAddress Address(SceneFile::EWrap Wrap) {
    return Wrap == SceneFile::EWrap::Clamp ? TA_Clamp : Wrap == SceneFile::EWrap::Mirror ? TA_Mirror : TA_Wrap;
}

FString NameOr(const std::string& Name, const TCHAR* Kind, int Index) {
    return Name.empty() ? FString::Printf(TEXT("%s_%d"), Kind, Index)
                        : SceneAssetNames::Clean(SceneConversion::ToString(Name));
}

void FillTexture(UTexture2D* Texture, const SceneFile::FTexture& Source, bool bColor) {
    Texture->SRGB = bColor ? 1 : 0;
    Texture->Filter = Source.bNearest ? TF_Nearest : TF_Default;
    Texture->AddressX = Address(Source.WrapU);
    Texture->AddressY = Address(Source.WrapV);
}

TArray<uint8> Bytes(const std::vector<std::uint8_t>& Source) {
    TArray<uint8> Result;
    Result.Append(Source.data(), static_cast<int32>(Source.size()));
    return Result;
}

} // namespace

FString SceneAssetNames::Clean(const FString& Text) {
    FString Result = Text;
    for (TCHAR& Character : Result.GetCharArray()) {
        const bool bPlain = (Character >= TEXT('a') && Character <= TEXT('z')) ||
                            (Character >= TEXT('A') && Character <= TEXT('Z')) ||
                            (Character >= TEXT('0') && Character <= TEXT('9')) || Character == TEXT('_') ||
                            Character == TEXT('-') || Character == 0 || Character > 127;
        if (!bPlain) {
            Character = TEXT('_');
        }
    }
    return Result;
}

FSceneAssets::FSceneAssets(const SceneFile::FDocument& InDocument, const FString& InSceneName)
    : Document(InDocument), Root(TEXT("/Game/Scenes/") + SceneAssetNames::Clean(InSceneName)) {}

bool FSceneAssets::Build(FString& OutError) { return BuildMaterials(OutError) && BuildMeshes(OutError); }

UStaticMesh* FSceneAssets::GetMesh(int Index) const { return Meshes.IsValidIndex(Index) ? Meshes[Index] : nullptr; }

UTexture2D* FSceneAssets::Texture(int TextureIndex, bool bColor, FString& OutError) {
    const SceneFile::FTexture& Source = Document.Textures[static_cast<std::size_t>(TextureIndex)];
    const SceneFile::FImage& Image = Document.Images[static_cast<std::size_t>(Source.Image)];
    FString Name = NameOr(Image.Name, TEXT("Texture"), Source.Image);
    // An image that serves as colour here and as data there becomes two textures.
    if (UTexture2D** Known = Textures.Find(Name)) {
        if (((*Known)->SRGB != 0) == bColor) {
            return *Known;
        }
        Name += bColor ? TEXT("_srgb") : TEXT("_linear");
        if (UTexture2D** Other = Textures.Find(Name)) {
            return *Other;
        }
    }
    UTexture2D* Result = FindOrMakeAsset<UTexture2D>(Root / TEXT("Textures"), Name);
    FillTexture(Result, Source, bColor);
    if (!Result->SetPixels(Image.Width, Image.Height, PF_R8G8B8A8, Bytes(Image.Pixels), OutError)) {
        return nullptr;
    }
    Textures.Add(Name, Result);
    return Result;
}

UTexture2D* FSceneAssets::OcclusionRoughnessMetallic(const SceneFile::FMaterial& Material, FString& OutError) {
    const int Rough = Material.MetallicRoughnessTexture;
    const int Occlusion = Material.OcclusionTexture;
    const auto ImageOf = [this](int Index) { return Document.Textures[static_cast<std::size_t>(Index)].Image; };
    if (Occlusion < 0 || (Rough >= 0 && ImageOf(Rough) == ImageOf(Occlusion))) {
        return Texture(Rough, false, OutError);
    }
    // Two images: red of the one, green and blue of the other, at the size of the one that holds roughness.
    const SceneFile::FTexture& Source = Document.Textures[static_cast<std::size_t>(Rough >= 0 ? Rough : Occlusion)];
    const SceneFile::FImage& Base = Document.Images[static_cast<std::size_t>(Source.Image)];
    const SceneFile::FImage& Red = Document.Images[static_cast<std::size_t>(ImageOf(Occlusion))];
    FString Name = NameOr(Base.Name, TEXT("Texture"), Source.Image) + TEXT("_") +
                   NameOr(Red.Name, TEXT("Texture"), ImageOf(Occlusion));
    if (UTexture2D** Known = Textures.Find(Name)) {
        return *Known;
    }
    TArray<uint8> Pixels = Bytes(Base.Pixels);
    for (int Row = 0; Row < Base.Height; ++Row) {
        for (int Column = 0; Column < Base.Width; ++Column) {
            const int Place = 4 * (Row * Base.Width + Column);
            const int64 RedRow = static_cast<int64>(Row) * Red.Height / Base.Height;
            const int64 RedColumn = static_cast<int64>(Column) * Red.Width / Base.Width;
            Pixels[Place] = Red.Pixels[static_cast<std::size_t>(4 * (RedRow * Red.Width + RedColumn))];
            if (Rough < 0) {
                Pixels[Place + 1] = Pixels[Place + 2] = 255;
            }
        }
    }
    UTexture2D* Result = FindOrMakeAsset<UTexture2D>(Root / TEXT("Textures"), Name);
    FillTexture(Result, Source, false);
    if (!Result->SetPixels(Base.Width, Base.Height, PF_R8G8B8A8, MoveTemp(Pixels), OutError)) {
        return nullptr;
    }
    Textures.Add(Name, Result);
    return Result;
}

bool FSceneAssets::BuildMaterials(FString& OutError) {
    UMaterialInterface* Surface =
        LoadObject<UMaterialInterface>(nullptr, TEXT("/Engine/EngineMaterials/Surface.Surface"));
    if (Surface == nullptr) {
        OutError = TEXT(
            "/Engine/EngineMaterials/Surface.Surface cannot be loaded: the engine's content loader is not registered");
        return false;
    }
    TMap<FString, int32> Taken;
    for (std::size_t Index = 0; Index < Document.Materials.size(); ++Index) {
        const SceneFile::FMaterial& Source = Document.Materials[Index];
        TArray<FScalarParameterValue> Scalars;
        TArray<FVectorParameterValue> Vectors;
        TArray<FTextureParameterValue> TextureValues;
        const auto Scalar = [&Scalars](const TCHAR* Name, double Value) {
            Scalars.Add(FScalarParameterValue(FMaterialParameterInfo(Name), static_cast<float>(Value)));
        };
        const auto Vector = [&Vectors](const TCHAR* Name, double R, double G, double B, double A) {
            Vectors.Add(FVectorParameterValue(
                FMaterialParameterInfo(Name), FLinearColor(static_cast<float>(R), static_cast<float>(G),
                                                  static_cast<float>(B), static_cast<float>(A))));
        };
        Vector(TEXT("BaseColor"), Source.BaseColor[0], Source.BaseColor[1], Source.BaseColor[2], Source.BaseColor[3]);
        Vector(TEXT("EmissiveColor"), Source.Emissive[0], Source.Emissive[1], Source.Emissive[2], 1.0);
        Vector(TEXT("UVTransform"), Source.UVScale[0], Source.UVScale[1], Source.UVOffset[0], Source.UVOffset[1]);
        Scalar(TEXT("Metallic"), Source.Metallic);
        Scalar(TEXT("Roughness"), Source.Roughness);
        Scalar(TEXT("Specular"), Source.Specular);
        Scalar(TEXT("NormalScale"), Source.NormalScale);
        Scalar(TEXT("OcclusionStrength"), Source.OcclusionTexture >= 0 ? Source.OcclusionStrength : 0.0);
        const auto AddTexture = [&TextureValues](const TCHAR* Name, UTexture2D* Value) {
            TextureValues.Add(FTextureParameterValue(FMaterialParameterInfo(Name), Value));
            return Value != nullptr;
        };
        bool bGood = true;
        if (Source.BaseColorTexture >= 0) {
            bGood = bGood && AddTexture(TEXT("BaseColorTexture"), Texture(Source.BaseColorTexture, true, OutError));
        }
        if (Source.EmissiveTexture >= 0) {
            bGood = bGood && AddTexture(TEXT("EmissiveTexture"), Texture(Source.EmissiveTexture, true, OutError));
        }
        if (Source.NormalTexture >= 0) {
            bGood = bGood && AddTexture(TEXT("NormalTexture"), Texture(Source.NormalTexture, false, OutError));
        }
        if (Source.MetallicRoughnessTexture >= 0 || Source.OcclusionTexture >= 0) {
            bGood = bGood &&
                    AddTexture(TEXT("OcclusionRoughnessMetallicTexture"), OcclusionRoughnessMetallic(Source, OutError));
        }
        if (!bGood) {
            return false;
        }
        FMaterialInstanceBasePropertyOverrides Overrides;
        Overrides.bOverride_BlendMode = 1;
        Overrides.bOverride_TwoSided = 1;
        Overrides.bOverride_OpacityMaskClipValue = 1;
        Overrides.BlendMode = Source.Alpha == SceneFile::EAlpha::Blend  ? BLEND_Translucent
                              : Source.Alpha == SceneFile::EAlpha::Mask ? BLEND_Masked
                                                                        : BLEND_Opaque;
        Overrides.TwoSided = Source.bDoubleSided ? 1 : 0;
        Overrides.OpacityMaskClipValue = static_cast<float>(Source.AlphaCutoff);
        FString Name = NameOr(Source.Name, TEXT("Material"), static_cast<int>(Index));
        if (int32* Count = Taken.Find(Name)) {
            Name += FString::Printf(TEXT("_%d"), ++*Count);
        } else {
            Taken.Add(Name, 1);
        }
        UMaterialInstanceConstant* Material =
            FindOrMakeAsset<UMaterialInstanceConstant>(Root / TEXT("Materials"), Name);
        Material->InitializeAsset(Surface, Scalars, Vectors, TextureValues, Overrides);
        Materials.Add(Material);
    }
    return true;
}

bool FSceneAssets::BuildMeshes(FString& OutError) {
    UMaterialInterface* Default =
        LoadObject<UMaterialInterface>(nullptr, TEXT("/Engine/EngineMaterials/DefaultMaterial.DefaultMaterial"));
    TMap<FString, int32> Taken;
    for (std::size_t Index = 0; Index < Document.Meshes.size(); ++Index) {
        const SceneFile::FMesh& Source = Document.Meshes[Index];
        FString Name = NameOr(Source.Name, TEXT("Mesh"), static_cast<int>(Index));
        if (int32* Count = Taken.Find(Name)) {
            Name += FString::Printf(TEXT("_%d"), ++*Count);
        } else {
            Taken.Add(Name, 1);
        }
        UStaticMesh* Mesh = FindOrMakeAsset<UStaticMesh>(Root / TEXT("Meshes"), Name);
        TArray<FStaticMaterial> Slots;
        for (const SceneFile::FPrimitive& Primitive : Source.Primitives) {
            UMaterialInterface* Material =
                Materials.IsValidIndex(Primitive.Material) ? Materials[Primitive.Material] : Default;
            const FName Base = Material ? Material->GetFName() : FName(TEXT("Material"));
            FName SlotName = Base;
            for (int32 Number = 1; Slots.ContainsByPredicate(
                     [SlotName](const FStaticMaterial& Slot) { return Slot.MaterialSlotName == SlotName; });
                ++Number) {
                SlotName = FName(*FString::Printf(TEXT("%s_%d"), *Base.ToString(), Number));
            }
            Slots.Add(FStaticMaterial(Material, SlotName));
        }
        Mesh->SetStaticMaterials(Slots);
        if (!Mesh->SetGeometry(SceneConversion::Geometry(Source), OutError)) {
            return false;
        }
        Meshes.Add(Mesh);
    }
    return true;
}
