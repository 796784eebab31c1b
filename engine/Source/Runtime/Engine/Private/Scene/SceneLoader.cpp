// SPDX-License-Identifier: MIT
#include "Engine/SceneLoader.h"

#include "Camera/CameraActor.h"
#include "Camera/CameraComponent.h"
#include "Components/LocalLightComponent.h"
#include "Components/SpotLightComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/DirectionalLight.h"
#include "Engine/Level.h"
#include "Engine/PointLight.h"
#include "Engine/SpotLight.h"
#include "Engine/StaticMesh.h"
#include "Engine/StaticMeshActor.h"
#include "Engine/World.h"
#include "GameFramework/WorldSettings.h"
#include "Misc/Paths.h"
#include "PropertyPath.h"
#include "SceneAssets.h"
#include "SceneConversion.h"
#include "../ThirdParty/SidecarFile.h"

namespace {

using SceneConversion::ToString;

TMap<TWeakObjectPtr<const AActor>, FString>& FolderPaths() {
    static TMap<TWeakObjectPtr<const AActor>, FString> Paths;
    return Paths;
}

/** An actor to be spawned: everything is checked before the first one is. */
struct FPlannedActor {
    FString Name;
    UClass* Class = nullptr;
    FTransform Transform;
    /** Index into the glTF document's nodes, or -1. */
    int32 Node = INDEX_NONE;
    /** Index into the plan of the actor this one is attached to. */
    int32 Parent = INDEX_NONE;
    FString Folder;
    const SceneFile::FActorEntry* Entry = nullptr;
};

class FSceneBuilder {
public:
    FSceneBuilder(UWorld* InWorld, const FSceneLoader::FSettings& InSettings) : World(InWorld), Settings(InSettings) {}

    bool Run(FString& OutError) { return Read(OutError) && Plan(OutError) && Spawn(OutError); }

private:
    bool Fault(const FString& Where, const FString& Text, FString& OutError) const {
        const FString& File = Settings.SidecarPath.IsEmpty() ? Settings.GltfPath : Settings.SidecarPath;
        OutError = FString::Printf(TEXT("%s: %s%s%s"), *File, *Where, Where.IsEmpty() ? TEXT("") : TEXT(": "), *Text);
        return false;
    }

    bool Read(FString& OutError) {
        std::string Error;
        if (!Settings.SidecarPath.IsEmpty() &&
            !SceneFile::ReadSidecar(SceneConversion::ToStd(Settings.SidecarPath), Sidecar, Error)) {
            OutError = ToString(Error);
            return false;
        }
        if (!SceneFile::ReadGltf(SceneConversion::ToStd(Settings.GltfPath), Document, Error)) {
            OutError = ToString(Error);
            return false;
        }
        return true;
    }

    /** Class by name with or without its prefix letter, or by path. */
    UClass* FindActorClass(const FString& Name) const {
        UClass* Class = nullptr;
        if (Name.StartsWith(TEXT("/"))) {
            Class = FindObject<UClass>(nullptr, *Name);
        } else {
            if (Name.Len() > 1 && Name[0] == TEXT('A') && FChar::IsUpper(Name[1])) {
                Class = FindFirstObject<UClass>(*Name.RightChop(1), EFindFirstObjectOptions::NativeFirst);
            }
            if (Class == nullptr) {
                Class = FindFirstObject<UClass>(*Name, EFindFirstObjectOptions::NativeFirst);
            }
        }
        return Class;
    }

    bool ResolveClass(const std::string& Text, const FString& Where, UClass*& OutClass, FString& OutError) const {
        const FString Name = ToString(Text);
        OutClass = FindActorClass(Name);
        if (OutClass == nullptr) {
            return Fault(Where, FString::Printf(TEXT("there is no class '%s' in this engine"), *Name), OutError);
        }
        if (!OutClass->IsChildOf(AActor::StaticClass()) || OutClass->HasAnyClassFlags(CLASS_Abstract)) {
            return Fault(Where,
                FString::Printf(TEXT("class '%s' is %s, so it cannot be placed"), *Name,
                    OutClass->IsChildOf(AActor::StaticClass()) ? TEXT("abstract") : TEXT("not an actor")),
                OutError);
        }
        return true;
    }

    UClass* DefaultClass(const SceneFile::FNode& Node) const {
        if (Node.Mesh >= 0) {
            return AStaticMeshActor::StaticClass();
        }
        if (Node.Light >= 0) {
            switch (Document.Lights[static_cast<std::size_t>(Node.Light)].Type) {
            case SceneFile::ELight::Directional:
                return ADirectionalLight::StaticClass();
            case SceneFile::ELight::Spot:
                return ASpotLight::StaticClass();
            case SceneFile::ELight::Point:
                return APointLight::StaticClass();
            }
        }
        return Node.Camera >= 0 ? ACameraActor::StaticClass() : nullptr;
    }

    bool Plan(FString& OutError) {
        TArray<FTransform> WorldTransforms;
        TArray<int32> PlanOfNode;
        TArray<FString> Groups;
        TSet<FName> Names;
        TSet<FString> Seen;
        for (std::size_t Index = 0; Index < Document.Nodes.size(); ++Index) {
            const SceneFile::FNode& Node = Document.Nodes[Index];
            const FTransform Local = SceneConversion::NodeTransform(Node);
            WorldTransforms.Add(Node.Parent >= 0 ? Local * WorldTransforms[Node.Parent] : Local);
            PlanOfNode.Add(INDEX_NONE);
            const FString NodeName = ToString(Node.Name);
            Seen.Add(NodeName);
            const auto Found = Sidecar.Nodes.find(Node.Name);
            FPlannedActor Actor;
            Actor.Entry = Found == Sidecar.Nodes.end() ? nullptr : &Found->second;
            Actor.Node = static_cast<int32>(Index);
            Actor.Name =
                Node.Name.empty() ? FString::Printf(TEXT("Node_%d"), Actor.Node) : SceneAssetNames::Clean(NodeName);
            const FString Where = FString::Printf(TEXT("node '%s'"), *Actor.Name);
            Actor.Class = DefaultClass(Node);
            if (Actor.Entry && !Actor.Entry->Class.empty() &&
                !ResolveClass(Actor.Entry->Class, Where, Actor.Class, OutError)) {
                return false;
            }
            const FString ParentGroup = Node.Parent >= 0 ? Groups[Node.Parent] : FString();
            if (Actor.Class == nullptr) {
                // A node without content is a group: it moves its children and names their folder.
                Groups.Add(ParentGroup.IsEmpty() ? Actor.Name : ParentGroup / Actor.Name);
                continue;
            }
            Groups.Add(ParentGroup);
            Actor.Folder = Actor.Entry && !Actor.Entry->Folder.empty() ? ToString(Actor.Entry->Folder) : ParentGroup;
            if (Names.Contains(FName(*Actor.Name))) {
                return Fault(Where,
                    TEXT(
                        "there are two nodes of this name (names are compared without case); actors need unique names"),
                    OutError);
            }
            Names.Add(FName(*Actor.Name));
            Actor.Transform = WorldTransforms.Last();
            if (Node.Mesh < 0 && (Node.Light >= 0 || Node.Camera >= 0)) {
                Actor.Transform.SetRotation(Actor.Transform.GetRotation() * SceneConversion::LookRotation());
                Actor.Transform.SetScale3D(FVector(1.0, 1.0, 1.0));
            }
            for (int Ancestor = Node.Parent; Ancestor >= 0 && Actor.Parent == INDEX_NONE;
                Ancestor = Document.Nodes[static_cast<std::size_t>(Ancestor)].Parent) {
                Actor.Parent = PlanOfNode[Ancestor];
            }
            PlanOfNode.Last() = Planned.Num();
            Planned.Add(Actor);
        }
        for (const auto& Item : Sidecar.Nodes) {
            if (!Seen.Contains(ToString(Item.first))) {
                return Fault(FString::Printf(TEXT("node '%s'"), *ToString(Item.first)),
                    FString::Printf(TEXT("%s has no node of this name"), *Settings.GltfPath), OutError);
            }
        }
        return PlanSidecarActors(Names, OutError);
    }

    bool PlanSidecarActors(TSet<FName>& Names, FString& OutError) {
        for (const SceneFile::FActorEntry& Entry : Sidecar.Actors) {
            FPlannedActor Actor;
            Actor.Name = SceneAssetNames::Clean(ToString(Entry.Name));
            Actor.Entry = &Entry;
            Actor.Folder = ToString(Entry.Folder);
            const FString Where = FString::Printf(TEXT("actor '%s'"), *Actor.Name);
            if (Names.Contains(FName(*Actor.Name))) {
                return Fault(
                    Where, TEXT("there is a node or actor of this name already; actors need unique names"), OutError);
            }
            Names.Add(FName(*Actor.Name));
            if (!ResolveClass(Entry.Class, Where, Actor.Class, OutError)) {
                return false;
            }
            Actor.Transform = FTransform(FQuat(FRotator(Entry.Rotation[0], Entry.Rotation[1], Entry.Rotation[2])),
                FVector(Entry.Location[0], Entry.Location[1], Entry.Location[2]),
                FVector(Entry.Scale[0], Entry.Scale[1], Entry.Scale[2]));
            Planned.Add(Actor);
        }
        for (const FPlannedActor& Actor : Planned) {
            if (StaticFindObjectFast(UObject::StaticClass(), World->GetCurrentLevel(), FName(*Actor.Name)) != nullptr) {
                return Fault(FString::Printf(TEXT("actor '%s'"), *Actor.Name),
                    TEXT("the level has an object of this name already"), OutError);
            }
        }
        return true;
    }

    bool Spawn(FString& OutError) {
        FSceneAssets Assets(Document, Settings.Name);
        if (!Assets.Build(OutError)) {
            return Fault(FString(), OutError, OutError);
        }
        TArray<AActor*> Actors;
        const auto Undo = [this, &Actors] {
            for (AActor* Actor : Actors) {
                // A destroyed actor keeps its name until it is collected; another attempt shall not meet it.
                World->DestroyActor(Actor);
                Actor->Rename(nullptr, nullptr, REN_DontCreateRedirectors | REN_DoNotDirty | REN_ForceNoResetLoaders);
            }
            return false;
        };
        for (const FPlannedActor& Plan : Planned) {
            FActorSpawnParameters Parameters;
            Parameters.Name = FName(*Plan.Name);
            Parameters.NameMode = decltype(Parameters.NameMode)::Required_ReturnNull;
            Parameters.SpawnCollisionHandlingOverride = ESpawnActorCollisionHandlingMethod::AlwaysSpawn;
            Parameters.bDeferConstruction = true;
            AActor* Actor = World->SpawnActor(Plan.Class, &Plan.Transform, Parameters);
            if (Actor == nullptr) {
                Fault(FString::Printf(TEXT("actor '%s'"), *Plan.Name),
                    FString::Printf(TEXT("the world refused to spawn an actor of class %s"), *Plan.Class->GetName()),
                    OutError);
                return Undo();
            }
            Actors.Add(Actor);
            if (!SetUp(Actor, Plan, Assets, OutError)) {
                return Undo();
            }
            Actor->FinishSpawning(Plan.Transform);
            if (!Plan.Folder.IsEmpty()) {
                FolderPaths().Add(Actor, Plan.Folder);
            }
        }
        for (int32 Index = 0; Index < Planned.Num(); ++Index) {
            if (Planned[Index].Parent != INDEX_NONE) {
                Actors[Index]->AttachToActor(
                    Actors[Planned[Index].Parent], FAttachmentTransformRules::KeepWorldTransform);
            }
        }
        for (const auto& Setting : Sidecar.WorldSettings) {
            FString Error;
            if (!SetPropertyByPath(
                    World->GetWorldSettings(), ToString(Setting.first), ToString(Setting.second), Error)) {
                Fault(TEXT("world_settings"), Error, OutError);
                return Undo();
            }
        }
        return true;
    }

    bool SetUp(AActor* Actor, const FPlannedActor& Plan, const FSceneAssets& Assets, FString& OutError) {
        const FString Where = FString::Printf(TEXT("actor '%s'"), *Plan.Name);
        if (Plan.Node != INDEX_NONE &&
            !SetUpContent(Actor, Document.Nodes[static_cast<std::size_t>(Plan.Node)], Where, Assets, OutError)) {
            return false;
        }
        USceneComponent* Root = Actor->GetRootComponent();
        if (Plan.Entry == nullptr) {
            return true;
        }
        for (const std::string& Tag : Plan.Entry->Tags) {
            Actor->Tags.Add(FName(*ToString(Tag)));
        }
        for (const std::string& Tag : Plan.Entry->ComponentTags) {
            if (Root == nullptr) {
                return Fault(Where, TEXT("has component tags, but no root component"), OutError);
            }
            Root->ComponentTags.Add(FName(*ToString(Tag)));
        }
        for (const auto& Property : Plan.Entry->Properties) {
            FString Error;
            if (!SetPropertyByPath(Actor, ToString(Property.first), ToString(Property.second), Error)) {
                return Fault(Where, Error, OutError);
            }
        }
        if (!Plan.Entry->Mobility.empty() && Root != nullptr) {
            const std::string& Text = Plan.Entry->Mobility;
            Root->SetMobility(Text == "Movable"      ? EComponentMobility::Movable
                              : Text == "Stationary" ? EComponentMobility::Stationary
                                                     : EComponentMobility::Static);
        }
        return true;
    }

    bool SetUpContent(AActor* Actor, const SceneFile::FNode& Node, const FString& Where, const FSceneAssets& Assets,
        FString& OutError) {
        if (Node.Mesh >= 0) {
            UStaticMeshComponent* Component = Actor->FindComponentByClass<UStaticMeshComponent>();
            if (Component == nullptr) {
                return Fault(Where,
                    FString::Printf(TEXT("its node has a mesh, but class %s has no static mesh component"),
                        *Actor->GetClass()->GetName()),
                    OutError);
            }
            Component->SetStaticMesh(Assets.GetMesh(Node.Mesh));
        }
        if (Node.Light >= 0 && Node.Mesh < 0) {
            ULightComponent* Component = Actor->FindComponentByClass<ULightComponent>();
            if (Component == nullptr) {
                return Fault(Where,
                    FString::Printf(TEXT("its node has a light, but class %s has no light component"),
                        *Actor->GetClass()->GetName()),
                    OutError);
            }
            SetUpLight(Component, Document.Lights[static_cast<std::size_t>(Node.Light)]);
        }
        if (Node.Camera >= 0) {
            if (UCameraComponent* Component = Actor->FindComponentByClass<UCameraComponent>()) {
                SetUpCamera(Component, Document.Cameras[static_cast<std::size_t>(Node.Camera)]);
            }
        }
        return true;
    }

    static void SetUpLight(ULightComponent* Component, const SceneFile::FLight& Light) {
        Component->SetLightColor(FLinearColor(static_cast<float>(Light.Color[0]), static_cast<float>(Light.Color[1]),
            static_cast<float>(Light.Color[2])));
        if (ULocalLightComponent* Local = Cast<ULocalLightComponent>(Component)) {
            Local->SetIntensityUnits(ELightUnits::Candelas);
            // Without a range the light ends where it has fallen to a hundredth of a lux.
            const double Range =
                Light.Range > 0.0 ? Light.Range : FMath::Sqrt(FMath::Max(Light.Intensity, 0.01) / 0.01);
            Local->SetAttenuationRadius(static_cast<float>(Range * SceneConversion::UnitsPerMetre));
        }
        Component->SetIntensity(static_cast<float>(Light.Intensity));
        if (USpotLightComponent* Spot = Cast<USpotLightComponent>(Component)) {
            Spot->SetInnerConeAngle(static_cast<float>(FMath::RadiansToDegrees(Light.InnerConeAngle)));
            Spot->SetOuterConeAngle(static_cast<float>(FMath::RadiansToDegrees(Light.OuterConeAngle)));
        }
    }

    static void SetUpCamera(UCameraComponent* Component, const SceneFile::FCamera& Camera) {
        if (!Camera.bPerspective) {
            Component->SetProjectionMode(ECameraProjectionMode::Orthographic);
            Component->SetOrthoWidth(static_cast<float>(Camera.OrthographicWidth * SceneConversion::UnitsPerMetre));
            return;
        }
        // UE's field of view is horizontal, glTF's vertical.
        const double Aspect = Camera.AspectRatio > 0.0 ? Camera.AspectRatio : 16.0 / 9.0;
        Component->SetAspectRatio(static_cast<float>(Aspect));
        Component->SetFieldOfView(static_cast<float>(
            FMath::RadiansToDegrees(2.0 * FMath::Atan(FMath::Tan(Camera.VerticalFieldOfView / 2.0) * Aspect))));
    }

    UWorld* World;
    FSceneLoader::FSettings Settings;
    SceneFile::FDocument Document;
    SceneFile::FSidecar Sidecar;
    TArray<FPlannedActor> Planned;
};

} // namespace

bool FSceneLoader::LoadScene(UWorld* World, const FString& Path, FString& OutError) {
    if (World == nullptr) {
        OutError = TEXT("there is no world to load a scene into");
        return false;
    }
    for (auto It = FolderPaths().CreateIterator(); It; ++It) {
        if (!It.Key().IsValid()) {
            It.RemoveCurrent();
        }
    }
    FSettings Settings;
    return ReadSceneSettings(Path, Settings, OutError) && FSceneBuilder(World, Settings).Run(OutError);
}

FString FSceneLoader::GetFolderPath(const AActor* Actor) {
    const FString* Found = FolderPaths().Find(TWeakObjectPtr<const AActor>(Actor));
    return Found ? *Found : FString();
}
