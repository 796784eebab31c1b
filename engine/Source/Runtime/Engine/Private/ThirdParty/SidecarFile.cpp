// SPDX-License-Identifier: MIT
// Compiled with exceptions and without any engine header: nlohmann-json needs both.

#include "SidecarFile.h"

#include <cmath>
#include <fstream>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

namespace SceneFile {
namespace {

using FJson = nlohmann::ordered_json;

[[noreturn]] void Fail(const std::string& Text) { throw std::runtime_error(Text); }

void CheckKeys(const FJson& Object, const std::string& Where, std::initializer_list<std::string_view> Known) {
    if (!Object.is_object()) {
        Fail(Where + " is not a JSON object");
    }
    for (const auto& Item : Object.items()) {
        bool bKnown = false;
        std::string List;
        for (const std::string_view Key : Known) {
            bKnown = bKnown || Item.key() == Key;
            List += (List.empty() ? "" : ", ") + std::string(Key);
        }
        if (!bKnown) {
            Fail(Where + " has the unknown key '" + Item.key() + "'; known are " + List);
        }
    }
}

std::string String(const FJson& Object, const char* Key, const std::string& Where) {
    if (!Object.contains(Key)) {
        return {};
    }
    if (!Object[Key].is_string()) {
        Fail(Where + ": '" + Key + "' is not a string");
    }
    return Object[Key].get<std::string>();
}

std::vector<std::string> Strings(const FJson& Object, const char* Key, const std::string& Where) {
    std::vector<std::string> Result;
    if (!Object.contains(Key)) {
        return Result;
    }
    if (!Object[Key].is_array()) {
        Fail(Where + ": '" + Key + "' is not a list of strings");
    }
    for (const FJson& Item : Object[Key]) {
        if (!Item.is_string()) {
            Fail(Where + ": '" + Key + "' holds something that is not a string");
        }
        Result.push_back(Item.get<std::string>());
    }
    return Result;
}

std::array<double, 3> Triple(
    const FJson& Object, const char* Key, std::array<double, 3> Default, const std::string& Where) {
    if (!Object.contains(Key)) {
        return Default;
    }
    const FJson& List = Object[Key];
    if (!List.is_array() || List.size() != 3) {
        Fail(Where + ": '" + Key + "' is not a list of 3 numbers");
    }
    for (std::size_t Index = 0; Index < 3; ++Index) {
        if (!List[Index].is_number() || !std::isfinite(List[Index].get<double>())) {
            Fail(Where + ": '" + Key + "' is not a list of 3 numbers");
        }
        Default[Index] = List[Index].get<double>();
    }
    return Default;
}

/** Values become the text that UE's property import reads. */
std::vector<std::pair<std::string, std::string>> Properties(
    const FJson& Object, const char* Key, const std::string& Where) {
    std::vector<std::pair<std::string, std::string>> Result;
    if (!Object.contains(Key)) {
        return Result;
    }
    if (!Object[Key].is_object()) {
        Fail(Where + ": '" + Key + "' is not a JSON object of property paths");
    }
    for (const auto& Item : Object[Key].items()) {
        const FJson& Value = Item.value();
        if (Value.is_string()) {
            Result.emplace_back(Item.key(), Value.get<std::string>());
        } else if (Value.is_boolean()) {
            Result.emplace_back(Item.key(), Value.get<bool>() ? "True" : "False");
        } else if (Value.is_number()) {
            Result.emplace_back(Item.key(), Value.dump());
        } else {
            Fail(Where + ": property '" + Item.key() +
                 "' is not a string, number or boolean; write structs as UE text, such as \"(X=1,Y=2,Z=3)\"");
        }
    }
    return Result;
}

FActorEntry Entry(const FJson& Object, const std::string& Where, bool bNode) {
    if (bNode) {
        CheckKeys(Object, Where, {"class", "tags", "component_tags", "mobility", "folder", "properties"});
    } else {
        CheckKeys(Object, Where,
            {"name", "class", "tags", "component_tags", "mobility", "folder", "properties", "location", "rotation",
                "scale"});
    }
    FActorEntry Result;
    Result.Name = String(Object, "name", Where);
    Result.Class = String(Object, "class", Where);
    Result.Tags = Strings(Object, "tags", Where);
    Result.ComponentTags = Strings(Object, "component_tags", Where);
    Result.Mobility = String(Object, "mobility", Where);
    if (!Result.Mobility.empty() && Result.Mobility != "Static" && Result.Mobility != "Stationary" &&
        Result.Mobility != "Movable") {
        Fail(Where + ": mobility is '" + Result.Mobility + "'; expected Static, Stationary or Movable");
    }
    Result.Folder = String(Object, "folder", Where);
    Result.Properties = Properties(Object, "properties", Where);
    Result.Location = Triple(Object, "location", Result.Location, Where);
    Result.Rotation = Triple(Object, "rotation", Result.Rotation, Where);
    Result.Scale = Triple(Object, "scale", Result.Scale, Where);
    return Result;
}

FSidecar Parse(const FJson& Document) {
    CheckKeys(Document, "the document",
        {"format", "version", "name", "gltf", "game_mode", "world_settings", "actors", "nodes", "description"});
    if (String(Document, "format", "the document") != "spear-scene") {
        Fail("'format' is not \"spear-scene\"");
    }
    if (!Document.contains("version") || Document["version"] != 1) {
        Fail("'version' is not 1, the only one this engine reads");
    }
    FSidecar Result;
    Result.Name = String(Document, "name", "the document");
    Result.Gltf = String(Document, "gltf", "the document");
    Result.GameMode = String(Document, "game_mode", "the document");
    Result.WorldSettings = Properties(Document, "world_settings", "the document");
    if (Result.Gltf.empty()) {
        Fail("'gltf' does not name the glTF file");
    }
    if (Document.contains("actors")) {
        if (!Document["actors"].is_array()) {
            Fail("'actors' is not a list");
        }
        std::size_t Number = 0;
        for (const FJson& Item : Document["actors"]) {
            const std::string Where = "actor " + std::to_string(Number++);
            FActorEntry Actor = Entry(Item, Where, false);
            if (Actor.Name.empty() || Actor.Class.empty()) {
                Fail(Where + " needs both 'name' and 'class'");
            }
            Result.Actors.push_back(std::move(Actor));
        }
    }
    if (Document.contains("nodes")) {
        if (!Document["nodes"].is_object()) {
            Fail("'nodes' is not an object of node names");
        }
        for (const auto& Item : Document["nodes"].items()) {
            Result.Nodes.emplace(Item.key(), Entry(Item.value(), "node '" + Item.key() + "'", true));
        }
    }
    return Result;
}

} // namespace

bool ReadSidecar(const std::string& Path, FSidecar& OutSidecar, std::string& OutError) {
    try {
        std::ifstream Stream(Path, std::ios::binary);
        if (!Stream) {
            Fail("the file cannot be opened");
        }
        OutSidecar = Parse(FJson::parse(Stream));
        return true;
    } catch (const std::exception& Exception) {
        OutError = Path + ": " + Exception.what();
        return false;
    }
}

} // namespace SceneFile
