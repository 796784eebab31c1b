// SPDX-License-Identifier: MIT
#pragma once

// unreal_service: the reflection system and the worlds. A `world` argument of null means the primary game world. Names match
// without case. Whatever is looked up and not found raises (UnknownClass, UnknownObject, ... with the nearest names); functions
// that return lists and maps return empty ones instead. (Paper, section 4, "Exposing the Reflection System".)

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "spear/entry_point.hpp"
#include "spear/entry_points/types.hpp"

namespace spear::unreal_service {

// Classes and objects ------------------------------------------------------------------------------------------------------

inline constexpr EntryPoint<"unreal_service.find_class", ObjectRef(std::string_view), Names<"name">, RunsOn::any_frame,
    "The loaded class of that name (\"AActor\", \"Actor\") or path (\"/Script/Engine.Actor\"). Raises UnknownClass, AmbiguousName."> find_class;

inline constexpr EntryPoint<"unreal_service.load_class", ObjectRef(ClassArgument, std::string_view), Names<"base", "path">, RunsOn::game_thread,
    "Loads a class by path, also from content (\"/Game/X/BP_Y.BP_Y_C\"); it must derive from base. Raises UnknownClass, WrongType."> load_class;

inline constexpr EntryPoint<"unreal_service.load_object", ObjectRef(ClassArgument, std::string_view), Names<"class", "path">, RunsOn::game_thread,
    "Finds or loads an object by path; it must be of the class. Raises UnknownObject, WrongType."> load_object;

inline constexpr EntryPoint<"unreal_service.get_default_object", ObjectRef(ClassArgument), Names<"class">, RunsOn::any_frame,
    "The class default object."> get_default_object;

inline constexpr EntryPoint<"unreal_service.get_class", ObjectRef(ObjectRef), Names<"object">, RunsOn::any_frame, "The class of an object."> get_class;

inline constexpr EntryPoint<"unreal_service.get_super_class", ObjectRef(ClassArgument), Names<"class">, RunsOn::any_frame,
    "The class that a class derives from; null for UObject."> get_super_class;

inline constexpr EntryPoint<"unreal_service.get_derived_classes", std::vector<ObjectRef>(ClassArgument, bool), Names<"class", "recursive">, RunsOn::any_frame,
    "The classes that derive from a class, by name."> get_derived_classes;

inline constexpr EntryPoint<"unreal_service.is_a", bool(ObjectRef, ClassArgument), Names<"object", "class">, RunsOn::any_frame,
    "Whether the object is of the class, or of one derived from it; for a class object, whether it derives from it."> is_a;

inline constexpr EntryPoint<"unreal_service.is_valid", bool(ObjectRef), Names<"object">, RunsOn::any_frame,
    "Whether the object still lives: not destroyed, not collected. Never raises StaleObject."> is_valid;

inline constexpr EntryPoint<"unreal_service.get_path_name", std::string(ObjectRef), Names<"object">, RunsOn::any_frame,
    "The object's path, its identity: \"/Game/Scenes/apartment.apartment:PersistentLevel.Table_3\"."> get_path_name;

inline constexpr EntryPoint<"unreal_service.new_object", ObjectRef(ClassArgument, ObjectRef, std::string_view), Names<"class", "outer", "name">,
    RunsOn::game_thread,
    "Makes an object (NewObject); outer null means the transient package, name empty a new one. The session keeps it alive until "
    "release_object or its end. Actors are spawned, not made."> new_object;

inline constexpr EntryPoint<"unreal_service.release_object", void(ObjectRef), Names<"object">, RunsOn::game_thread,
    "Lets go of an object made by new_object: it is collected as soon as nothing else refers to it."> release_object;

// Worlds and actors --------------------------------------------------------------------------------------------------------

inline constexpr EntryPoint<"unreal_service.get_worlds", std::vector<WorldInfo>(), Names<>, RunsOn::any_frame, "All worlds of the engine."> get_worlds;

inline constexpr EntryPoint<"unreal_service.spawn_actor", ObjectRef(ObjectRef, ClassArgument, SpawnOptions), Names<"world", "class", "options">,
    RunsOn::game_thread, "Spawns an actor. Raises UnknownClass, WrongType (no actor class, or abstract), SpawnFailed."> spawn_actor;

inline constexpr EntryPoint<"unreal_service.destroy_actor", bool(ObjectRef), Names<"actor">, RunsOn::game_thread,
    "Destroys an actor (AActor::Destroy). Its handles raise StaleObject from now on."> destroy_actor;

/// Finding by one key gives three entry points: `find_X` (exactly one, or UnknownObject/AmbiguousName), `find_Xs` (list, in world
/// order) and `find_Xs_as_map` (by name; components of several actors cannot clash, names are unique within an actor).
/// `scope` is a world (null: the primary one) for actors, and an actor for components.
template <FixedString Name, FixedString Scope, FixedString Key, FixedString Documentation>
using FindOne = EntryPoint<Name, ObjectRef(ObjectRef, ClassArgument, std::string_view), Names<Scope, "class", Key>, RunsOn::game_thread, Documentation>;
template <FixedString Name, FixedString Scope, FixedString Key, FixedString Documentation>
using FindList = EntryPoint<Name, std::vector<ObjectRef>(ObjectRef, ClassArgument, std::string_view), Names<Scope, "class", Key>, RunsOn::game_thread, Documentation>;
template <FixedString Name, FixedString Scope, FixedString Key, FixedString Documentation>
using FindMap = EntryPoint<Name, std::map<std::string, ObjectRef>(ObjectRef, ClassArgument, std::string_view), Names<Scope, "class", Key>, RunsOn::game_thread, Documentation>;

inline constexpr FindOne<"unreal_service.find_actor_by_name", "world", "name", "The actor of that object name."> find_actor_by_name;
inline constexpr FindOne<"unreal_service.find_actor_by_tag", "world", "tag", "The only actor with that tag."> find_actor_by_tag;
inline constexpr FindOne<"unreal_service.find_actor_by_path", "world", "path", "The actor of that object path."> find_actor_by_path;
inline constexpr FindOne<"unreal_service.find_actor_by_class", "world", "", "The only actor of the class; the last argument is empty."> find_actor_by_class;
inline constexpr FindList<"unreal_service.find_actors_by_tag", "world", "tag", "All actors with that tag."> find_actors_by_tag;
inline constexpr FindList<"unreal_service.find_actors_by_name", "world", "pattern", "All actors whose name fits a pattern with * and ?."> find_actors_by_name;
inline constexpr FindList<"unreal_service.find_actors_by_class", "world", "", "All actors of the class; the last argument is empty."> find_actors_by_class;
inline constexpr FindMap<"unreal_service.find_actors_by_tag_as_map", "world", "tag", "All actors with that tag, by name."> find_actors_by_tag_as_map;
inline constexpr FindMap<"unreal_service.find_actors_by_class_as_map", "world", "", "All actors of the class, by name."> find_actors_by_class_as_map;

inline constexpr FindOne<"unreal_service.find_component_by_name", "actor", "name", "The actor's component of that name."> find_component_by_name;
inline constexpr FindOne<"unreal_service.find_component_by_tag", "actor", "tag", "The actor's only component with that tag."> find_component_by_tag;
inline constexpr FindOne<"unreal_service.find_component_by_class", "actor", "", "The actor's only component of the class."> find_component_by_class;
inline constexpr FindList<"unreal_service.find_components_by_tag", "actor", "tag", "The actor's components with that tag."> find_components_by_tag;
inline constexpr FindList<"unreal_service.find_components_by_class", "actor", "", "The actor's components of the class."> find_components_by_class;
inline constexpr FindMap<"unreal_service.find_components_by_class_as_map", "actor", "", "The actor's components of the class, by name."> find_components_by_class_as_map;

// Functions and properties -------------------------------------------------------------------------------------------------

inline constexpr EntryPoint<"unreal_service.call_function", AnyView(ObjectRef, ShapeId, ArgumentsView), Names<"object", "shape", "arguments">,
    RunsOn::game_thread,
    "Calls a reflected function. The shape names function and arguments; the function is found through the object's own class, so overrides "
    "count. On a class object, static functions run on its default object. Returns the return value, or a struct of ReturnValue and the "
    "out-parameters by name if there are any."> call_function;

inline constexpr EntryPoint<"unreal_service.get_property", AnyView(ObjectRef, ShapeId), Names<"object", "path">, RunsOn::game_thread,
    "Reads the property at a path: \"RootComponent.RelativeLocation.X\", \"Tags[0]\", \"Map[\\\"key\\\"].Field\"; it leads through objects, structs, "
    "arrays and maps."> get_property;

inline constexpr EntryPoint<"unreal_service.set_property", void(ObjectRef, ShapeId, AnyView), Names<"object", "path", "value">, RunsOn::game_thread,
    "Writes the property at a path, through the outermost native setter where there is one."> set_property;

// Facts about types --------------------------------------------------------------------------------------------------------

inline constexpr EntryPoint<"unreal_service.describe_class", AnyView(ClassArgument), Names<"class">, RunsOn::any_frame,
    "The class as the live schema has it: its own functions and properties, its super class (see the schema's documentation)."> describe_class;

inline constexpr EntryPoint<"unreal_service.get_schema", AnyView(std::vector<std::string>), Names<"modules">, RunsOn::any_frame,
    "The live schema, found by walking classes and properties: of all modules, or of those named. Runtime and editor tiers."> get_schema;

#define SPEAR_E(name) std::remove_cv_t<decltype(name)>
using List = EntryPointList<SPEAR_E(find_class), SPEAR_E(load_class), SPEAR_E(load_object), SPEAR_E(get_default_object), SPEAR_E(get_class),
    SPEAR_E(get_super_class), SPEAR_E(get_derived_classes), SPEAR_E(is_a), SPEAR_E(is_valid), SPEAR_E(get_path_name), SPEAR_E(new_object),
    SPEAR_E(release_object), SPEAR_E(get_worlds), SPEAR_E(spawn_actor), SPEAR_E(destroy_actor), SPEAR_E(find_actor_by_name),
    SPEAR_E(find_actor_by_tag), SPEAR_E(find_actor_by_path), SPEAR_E(find_actor_by_class), SPEAR_E(find_actors_by_tag),
    SPEAR_E(find_actors_by_name), SPEAR_E(find_actors_by_class), SPEAR_E(find_actors_by_tag_as_map), SPEAR_E(find_actors_by_class_as_map),
    SPEAR_E(find_component_by_name), SPEAR_E(find_component_by_tag), SPEAR_E(find_component_by_class), SPEAR_E(find_components_by_tag),
    SPEAR_E(find_components_by_class), SPEAR_E(find_components_by_class_as_map), SPEAR_E(call_function), SPEAR_E(get_property),
    SPEAR_E(set_property), SPEAR_E(describe_class), SPEAR_E(get_schema)>;
#undef SPEAR_E

} // namespace spear::unreal_service
