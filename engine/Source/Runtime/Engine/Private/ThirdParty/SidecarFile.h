// SPDX-License-Identifier: MIT
#pragma once

// The sidecar <name>.scene.json as plain data; the format is documented in docs/scenes.md.

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace SceneFile {

/** What the sidecar says about one actor. */
struct FActorEntry {
    /** For actors without a glTF node. */
    std::string Name;
    /** With or without UE's prefix letter, or a path "/Script/Module.Class"; empty: by what the node holds. */
    std::string Class;
    std::vector<std::string> Tags;
    std::vector<std::string> ComponentTags;
    /** "Static", "Stationary", "Movable" or empty for the class's own. */
    std::string Mobility;
    std::string Folder;
    /** Property path and value as UE text. */
    std::vector<std::pair<std::string, std::string>> Properties;
    /** Centimetres; pitch, yaw, roll in degrees; only for actors without a node. */
    std::array<double, 3> Location{0.0, 0.0, 0.0};
    std::array<double, 3> Rotation{0.0, 0.0, 0.0};
    std::array<double, 3> Scale{1.0, 1.0, 1.0};
};

struct FSidecar {
    std::string Name;
    /** Relative to the sidecar's folder. */
    std::string Gltf;
    std::string GameMode;
    std::vector<std::pair<std::string, std::string>> WorldSettings;
    std::vector<FActorEntry> Actors;
    std::map<std::string, FActorEntry> Nodes;
};

/** Reads and checks a sidecar. False with a text in OutError naming the file, the entry and what was wrong. */
bool ReadSidecar(const std::string& Path, FSidecar& OutSidecar, std::string& OutError);

} // namespace SceneFile
