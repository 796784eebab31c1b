// SPDX-License-Identifier: MIT
#pragma once

// Game: what is in a world, by name, tag, class and path; spawning and making things.
//
//     spear::Game game = instance.game();
//     spear::Object table = game.find_actor_by_name("Table_3");                       // exactly one, or UnknownObject,
//     AmbiguousName std::vector<spear::Object> lights = game.find_actors_by_class("ALight");
//     spear::Future<spear::Object> axes = game.async().spawn_actor("AStaticMeshActor", {.location = {-10, 280, 50}});
//     auto door = game.spawn_actor<unreal::ADoor>({.location = {0, 0, 0}});           // with a generated proxy
//
// Every function exists three times, from one template: `game.f()` (synchronous), `game.async().f()` (Future) and
// `game.send().f()` (fire-and-forget). They need an open block, except for classes and worlds, which are looked up at
// the engine's next chance.

#include <concepts>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "spear/object.hpp"
#include "spear/session.hpp"

namespace spear {

template <typename T>
class ClassOf; // proxy.hpp
template <typename T>
class SubclassOf; // proxy_types.hpp

template <CallMode mode>
class BasicGame {
public:
    template <typename R>
    using Result = CallResult<mode, R>;
    using AnyObject = Object;

    /// `world` null means the engine's primary world, whichever that is when an operation runs.
    explicit BasicGame(std::shared_ptr<Session> session, ObjectHandle world = {})
        : session_(std::move(session)), world_(std::move(world)) {}

    BasicGame<CallMode::async> async() const { return BasicGame<CallMode::async>(session_, world_); }
    BasicGame<CallMode::send> send() const { return BasicGame<CallMode::send>(session_, world_); }
    /// The same for another world of the engine (get_worlds).
    BasicGame in_world(ObjectHandle world) const { return BasicGame(session_, std::move(world)); }
    const std::shared_ptr<Session>& session() const noexcept { return session_; }

    // Worlds

    Result<std::vector<WorldInfo>> get_worlds() const { return session_->perform<mode>(unreal_service::get_worlds); }

    // Classes

    /// A loaded class by name ("AActor", "Actor") or path. Raises UnknownClass (with the nearest names), AmbiguousName.
    Result<Class> get_class(std::string_view name) const { return as<Class>(unreal_service::find_class, name); }
    /// The class of a generated proxy, with its static functions:
    /// `game.get_class<unreal::UGameplayStatics>().SetGamePaused(true)`.
    template <std::derived_from<AnyObject> T>
    Result<ClassOf<T>> get_class() const {
        return as<ClassOf<T>>(unreal_service::find_class, T::unreal_name);
    }
    /// Loads a class by path, also from content: "/Game/X/BP_Y.BP_Y_C". Raises UnknownClass, WrongType.
    Result<Class> load_class(std::string_view path, const ClassReference& base = {}) const {
        return as<Class>(unreal_service::load_class, base, path);
    }
    /// The same for a class that is, or derives from, that of a proxy.
    template <std::derived_from<AnyObject> T>
    Result<SubclassOf<T>> load_class(std::string_view path) const {
        return as<SubclassOf<T>>(unreal_service::load_class, class_of<T>(), path);
    }
    /// Finds or loads an asset or other object by path. Raises UnknownObject, WrongType.
    template <std::derived_from<AnyObject> T = Object>
    Result<T> load_object(std::string_view path, const ClassReference& object_class = class_of<T>()) const {
        return as<T>(unreal_service::load_object, object_class, path);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<T> get_default_object(const ClassReference& object_class = class_of<T>()) const {
        return as<T>(unreal_service::get_default_object, object_class);
    }

    // Making and unmaking

    /// Raises UnknownClass, WrongType (no actor class, or abstract), SpawnFailed.
    Result<Object> spawn_actor(const ClassReference& actor_class, const SpawnOptions& options = {}) const {
        return as<Object>(unreal_service::spawn_actor, world_, actor_class, options);
    }
    template <std::derived_from<AnyObject> T>
    Result<T> spawn_actor(const SpawnOptions& options = {}) const {
        return as<T>(unreal_service::spawn_actor, world_, class_of<T>(), options);
    }
    /// AActor::Destroy; true if it did. The actor's handles raise StaleObject from now on.
    Result<bool> destroy_actor(const ObjectReference& actor) const {
        return session_->perform<mode>(unreal_service::destroy_actor, actor);
    }
    /// NewObject; `outer` null means the transient package, an empty name a new one. The session keeps the object alive
    /// until release_object or its end.
    Result<Object> new_object(
        const ClassReference& object_class, const ObjectReference& outer = nullptr, std::string_view name = "") const {
        return as<Object>(unreal_service::new_object, object_class, outer, name);
    }
    template <std::derived_from<AnyObject> T>
    Result<T> new_object(const ObjectReference& outer = nullptr, std::string_view name = "") const {
        return as<T>(unreal_service::new_object, class_of<T>(), outer, name);
    }
    Result<void> release_object(const ObjectReference& object) const {
        return session_->perform<mode>(unreal_service::release_object, object);
    }

    // Finding actors. `find_actor_by_X` is exactly one (UnknownObject, AmbiguousName); lists and maps may be empty

    template <std::derived_from<AnyObject> T = Object>
    Result<T> find_actor_by_name(std::string_view name, const ClassReference& actor_class = class_of<T>()) const {
        return as<T>(unreal_service::find_actor_by_name, world_, actor_class, name);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<T> find_actor_by_tag(std::string_view tag, const ClassReference& actor_class = class_of<T>()) const {
        return as<T>(unreal_service::find_actor_by_tag, world_, actor_class, tag);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<T> find_actor_by_path(std::string_view path, const ClassReference& actor_class = class_of<T>()) const {
        return as<T>(unreal_service::find_actor_by_path, world_, actor_class, path);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<T> find_actor_by_class(const ClassReference& actor_class = class_of<T>()) const {
        return as<T>(unreal_service::find_actor_by_class, world_, actor_class, "");
    }
    /// Names that fit a pattern with * and ?.
    template <std::derived_from<AnyObject> T = Object>
    Result<std::vector<T>> find_actors_by_name(
        std::string_view pattern, const ClassReference& actor_class = class_of<T>()) const {
        return as<std::vector<T>>(unreal_service::find_actors_by_name, world_, actor_class, pattern);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<std::vector<T>> find_actors_by_tag(
        std::string_view tag, const ClassReference& actor_class = class_of<T>()) const {
        return as<std::vector<T>>(unreal_service::find_actors_by_tag, world_, actor_class, tag);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<std::vector<T>> find_actors_by_class(const ClassReference& actor_class = class_of<T>()) const {
        return as<std::vector<T>>(unreal_service::find_actors_by_class, world_, actor_class, "");
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<std::map<std::string, T>> find_actors_by_tag_as_map(
        std::string_view tag, const ClassReference& actor_class = class_of<T>()) const {
        return as<std::map<std::string, T>>(unreal_service::find_actors_by_tag_as_map, world_, actor_class, tag);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<std::map<std::string, T>> find_actors_by_class_as_map(
        const ClassReference& actor_class = class_of<T>()) const {
        return as<std::map<std::string, T>>(unreal_service::find_actors_by_class_as_map, world_, actor_class, "");
    }

    // Finding an actor's components

    template <std::derived_from<AnyObject> T = Object>
    Result<T> find_component_by_name(const ObjectReference& actor, std::string_view name,
        const ClassReference& component_class = class_of<T>()) const {
        return as<T>(unreal_service::find_component_by_name, actor, component_class, name);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<T> find_component_by_tag(const ObjectReference& actor, std::string_view tag,
        const ClassReference& component_class = class_of<T>()) const {
        return as<T>(unreal_service::find_component_by_tag, actor, component_class, tag);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<T> find_component_by_class(
        const ObjectReference& actor, const ClassReference& component_class = class_of<T>()) const {
        return as<T>(unreal_service::find_component_by_class, actor, component_class, "");
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<std::vector<T>> find_components_by_tag(const ObjectReference& actor, std::string_view tag,
        const ClassReference& component_class = class_of<T>()) const {
        return as<std::vector<T>>(unreal_service::find_components_by_tag, actor, component_class, tag);
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<std::vector<T>> find_components_by_class(
        const ObjectReference& actor, const ClassReference& component_class = class_of<T>()) const {
        return as<std::vector<T>>(unreal_service::find_components_by_class, actor, component_class, "");
    }
    template <std::derived_from<AnyObject> T = Object>
    Result<std::map<std::string, T>> find_components_by_class_as_map(
        const ObjectReference& actor, const ClassReference& component_class = class_of<T>()) const {
        return as<std::map<std::string, T>>(
            unreal_service::find_components_by_class_as_map, actor, component_class, "");
    }

private:
    /// A proxy's class; no restriction for plain objects.
    template <typename T>
    static ClassReference class_of() {
        if constexpr (requires { T::unreal_name; })
            return ClassReference(std::string_view(T::unreal_name));
        else
            return {};
    }
    template <typename R, typename E, typename... A>
    Result<R> as(const E& entry_point, const A&... arguments) const {
        return session_->perform_as<mode, R>(entry_point, arguments...);
    }

    std::shared_ptr<Session> session_;
    ObjectHandle world_;
};

using Game = BasicGame<CallMode::sync>;

} // namespace spear
