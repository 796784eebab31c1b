// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

class AActor;
class UStaticMesh;
class UWorld;

/**
 * Loads scenes: a glTF 2.0 file (.gltf or .glb) and an optional sidecar "<name>.scene.json" beside it, which gives
 * nodes their UE classes, tags and properties. The file formats are documented in docs/scenes.md. Embedded engine only:
 * UE loads maps.
 */
struct ENGINE_API FSceneLoader {
    /**
     * Spawns everything of a scene into a world.
     *
     * Both files are read and checked completely before the first actor is spawned, so that a malformed scene leaves
     * the world as it was.
     *
     * @param World    the world to spawn into.
     * @param Path     a .gltf, .glb or .scene.json file, a folder holding exactly one scene, or the bare name of a
     * scene below the content folder
     *                 ("apartment" finds Scenes/apartment/).
     * @param OutError names the file and, where there is one, the node, what was wrong with it and what to do.
     * @return whether the scene is in the world.
     */
    static bool LoadScene(UWorld* World, const FString& Path, FString& OutError);

    /** The sidecar's player start class, game mode class and so on, readable before loading; see ReadSceneSettings. */
    struct FSettings {
        /** Name of the scene, from the sidecar or else the file. */
        FString Name;
        /** Class of the game mode, such as "AGameModeBase"; empty if the sidecar names none. */
        FString GameMode;
        /** The glTF file. */
        FString GltfPath;
        /** The sidecar, or empty if there is none. */
        FString SidecarPath;
    };

    /** Finds the files of a scene and reads what must be known before its world is made. Arguments and result as
     * LoadScene. */
    static bool ReadSceneSettings(const FString& Path, FSettings& OutSettings, FString& OutError);

    /** Folder group of an actor that LoadScene spawned, such as "LivingRoom/Furniture"; empty for other actors. */
    static FString GetFolderPath(const AActor* Actor);

    /**
     * Folders searched for content, first match wins: the environment variable SPEAR_CONTENT_DIR (several separated by
     * ':'), then "content" beside the running executable and beside its parent folders.
     */
    static TArray<FString> GetContentFolders();
};
