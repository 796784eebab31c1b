// SPDX-License-Identifier: MIT
#pragma once

// Plain types of entry-point signatures. Reflected values (FVector of a property, say) do not go through these: they are AnyView.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spear/codec.hpp"

namespace spear {

/// A class, by object or by name. Names match without case, with or without prefix ("AActor", "Actor"), or are object paths
/// ("/Script/Engine.Actor"). Neither given: no restriction (UObject).
struct ClassArgument {
    ObjectRef object;
    std::string name;
};

template <>
struct Codec<ClassArgument> {
    static constexpr std::string_view name = "class";
    static void encode(Encoder& out, const ClassArgument& value) {
        if (!value.name.empty()) Codec<std::string>::encode(out, value.name);
        else Codec<ObjectRef>::encode(out, value.object);
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, ClassArgument& value) {
        value = {};
        return type == types::string ? Codec<std::string>::decode(in, type, context, value.name)
                                     : Codec<ObjectRef>::decode(in, type, context, value.object);
    }
};

/// Centimetres, left-handed, Z up.
struct Vector3 {
    double X = 0, Y = 0, Z = 0;
};
template <>
struct Members<Vector3> {
    static constexpr std::string_view name = "Vector3";
    static constexpr auto list = std::tuple{Member{"X", &Vector3::X}, Member{"Y", &Vector3::Y}, Member{"Z", &Vector3::Z}};
};

/// Degrees.
struct Rotation3 {
    double Pitch = 0, Yaw = 0, Roll = 0;
};
template <>
struct Members<Rotation3> {
    static constexpr std::string_view name = "Rotation3";
    static constexpr auto list = std::tuple{Member{"Pitch", &Rotation3::Pitch}, Member{"Yaw", &Rotation3::Yaw}, Member{"Roll", &Rotation3::Roll}};
};

/// How an actor is spawned. Everything has a sensible default.
struct SpawnOptions {
    Vector3 location{};
    Rotation3 rotation{};
    Vector3 scale{1, 1, 1};
    std::string name{};               ///< requested object name; empty: the engine makes one. Taken: SpawnFailed
    std::vector<std::string> tags{};  ///< added to AActor::Tags before BeginPlay
    ObjectRef owner{};
    /// "always_spawn", "adjust_if_possible_but_always_spawn", "adjust_if_possible_but_dont_spawn_if_colliding",
    /// "dont_spawn_if_colliding", or "undefined" (the class decides).
    std::string collision_handling = "always_spawn";
};
template <>
struct Members<SpawnOptions> {
    static constexpr std::string_view name = "SpawnOptions";
    static constexpr auto list = std::tuple{Member{"location", &SpawnOptions::location}, Member{"rotation", &SpawnOptions::rotation},
        Member{"scale", &SpawnOptions::scale}, Member{"name", &SpawnOptions::name}, Member{"tags", &SpawnOptions::tags},
        Member{"owner", &SpawnOptions::owner}, Member{"collision_handling", &SpawnOptions::collision_handling}};
};

/// One world of the engine.
struct WorldInfo {
    ObjectRef world;
    std::string name;          ///< "apartment"
    std::string path;          ///< "/Game/Scenes/apartment.apartment"
    std::string type;          ///< "game", "pie", "editor", "editor_preview", "game_preview", "inactive", "none"
    bool is_playing = false;   ///< BeginPlay has run
    bool is_primary = false;   ///< the world that an omitted world argument means
};
template <>
struct Members<WorldInfo> {
    static constexpr std::string_view name = "WorldInfo";
    static constexpr auto list = std::tuple{Member{"world", &WorldInfo::world}, Member{"name", &WorldInfo::name}, Member{"path", &WorldInfo::path},
        Member{"type", &WorldInfo::type}, Member{"is_playing", &WorldInfo::is_playing}, Member{"is_primary", &WorldInfo::is_primary}};
};

/// What runs at the other end.
struct EngineInfo {
    std::string spear_version;
    std::string engine_name;    ///< "embedded" or "unreal"
    std::string engine_version; ///< "5.5.0"
    std::string project;
    std::string scene;          ///< the primary world's name when the server started
    std::string command_line;
    std::uint64_t process_id = 0;
    std::uint64_t frame = 0;    ///< the engine's frame counter
    bool is_editor = false;
};
template <>
struct Members<EngineInfo> {
    static constexpr std::string_view name = "EngineInfo";
    static constexpr auto list = std::tuple{Member{"spear_version", &EngineInfo::spear_version}, Member{"engine_name", &EngineInfo::engine_name},
        Member{"engine_version", &EngineInfo::engine_version}, Member{"project", &EngineInfo::project}, Member{"scene", &EngineInfo::scene},
        Member{"command_line", &EngineInfo::command_line}, Member{"process_id", &EngineInfo::process_id}, Member{"frame", &EngineInfo::frame},
        Member{"is_editor", &EngineInfo::is_editor}};
};

} // namespace spear
