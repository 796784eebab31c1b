// SPDX-License-Identifier: MIT
#pragma once

// Other spellings of reflected functions. Unreal reflects AActor::GetActorLocation as "K2_GetActorLocation"; C++
// programmers, the SPEAR paper and Unreal's own Python know it as GetActorLocation or by its ScriptName. The engine
// reflects only the first, so the other spellings are translated here, by the client, when it names a function. The
// spelling that was written travels along (TypeInfo::path of the call shape) and comes first: a class that reflects a
// function of that very name keeps it. Python uses this table too.

#include <algorithm>
#include <array>
#include <string_view>

namespace spear {

struct FunctionAlias {
    std::string_view alias;
    std::string_view name; ///< what is reflected
};

/// Sorted by alias. Only spellings that no class of the engine reflects itself.
inline constexpr auto function_aliases = std::to_array<FunctionAlias>({
    {"AddActorLocalOffset", "K2_AddActorLocalOffset"},
    {"AddActorLocalRotation", "K2_AddActorLocalRotation"},
    {"AddActorLocalTransform", "K2_AddActorLocalTransform"},
    {"AddActorWorldOffset", "K2_AddActorWorldOffset"},
    {"AddActorWorldRotation", "K2_AddActorWorldRotation"},
    {"AddActorWorldTransform", "K2_AddActorWorldTransform"},
    {"AddActorWorldTransformKeepScale", "K2_AddActorWorldTransformKeepScale"},
    {"AddLocalOffset", "K2_AddLocalOffset"},
    {"AddLocalRotation", "K2_AddLocalRotation"},
    {"AddLocalTransform", "K2_AddLocalTransform"},
    {"AddRelativeLocation", "K2_AddRelativeLocation"},
    {"AddRelativeRotation", "K2_AddRelativeRotation"},
    {"AddWorldOffset", "K2_AddWorldOffset"},
    {"AddWorldRotation", "K2_AddWorldRotation"},
    {"AddWorldTransform", "K2_AddWorldTransform"},
    {"AddWorldTransformKeepScale", "K2_AddWorldTransformKeepScale"},
    {"AttachToActor", "K2_AttachToActor"},
    {"AttachToComponent", "K2_AttachToComponent"},
    {"DestroyActor", "K2_DestroyActor"},
    {"DestroyComponent", "K2_DestroyComponent"},
    {"DetachFromActor", "K2_DetachFromActor"},
    {"DetachFromComponent", "K2_DetachFromComponent"},
    {"GetActorLocation", "K2_GetActorLocation"},
    {"GetActorRotation", "K2_GetActorRotation"},
    {"GetActorTransform", "GetTransform"},
    {"GetComponentLocation", "K2_GetComponentLocation"},
    {"GetComponentRotation", "K2_GetComponentRotation"},
    {"GetComponentScale", "K2_GetComponentScale"},
    {"GetComponentToWorld", "K2_GetComponentToWorld"},
    {"GetComponentTransform", "K2_GetComponentToWorld"},
    {"GetComponentsByClass", "K2_GetComponentsByClass"},
    {"GetRootComponent", "K2_GetRootComponent"},
    {"GetWorldLocation", "K2_GetComponentLocation"},
    {"GetWorldRotation", "K2_GetComponentRotation"},
    {"GetWorldScale", "K2_GetComponentScale"},
    {"GetWorldTransform", "K2_GetComponentToWorld"},
    {"IsCollisionEnabled", "K2_IsCollisionEnabled"},
    {"IsPhysicsCollisionEnabled", "K2_IsPhysicsCollisionEnabled"},
    {"IsQueryCollisionEnabled", "K2_IsQueryCollisionEnabled"},
    {"SetActorLocation", "K2_SetActorLocation"},
    {"SetActorLocationAndRotation", "K2_SetActorLocationAndRotation"},
    {"SetActorRelativeLocation", "K2_SetActorRelativeLocation"},
    {"SetActorRelativeRotation", "K2_SetActorRelativeRotation"},
    {"SetActorRelativeTransform", "K2_SetActorRelativeTransform"},
    {"SetActorRotation", "K2_SetActorRotation"},
    {"SetActorTransform", "K2_SetActorTransform"},
    {"SetRelativeLocation", "K2_SetRelativeLocation"},
    {"SetRelativeLocationAndRotation", "K2_SetRelativeLocationAndRotation"},
    {"SetRelativeRotation", "K2_SetRelativeRotation"},
    {"SetRelativeTransform", "K2_SetRelativeTransform"},
    {"SetWorldLocation", "K2_SetWorldLocation"},
    {"SetWorldLocationAndRotation", "K2_SetWorldLocationAndRotation"},
    {"SetWorldRotation", "K2_SetWorldRotation"},
    {"SetWorldTransform", "K2_SetWorldTransform"},
    {"Teleport", "K2_TeleportTo"},
    {"TeleportTo", "K2_TeleportTo"},
});

static_assert(std::ranges::is_sorted(function_aliases, {}, &FunctionAlias::alias));

/// The reflected name of a function; any name that is no alias is returned as it is.
constexpr std::string_view resolve_function_alias(std::string_view name) {
    const auto at = std::ranges::lower_bound(function_aliases, name, {}, &FunctionAlias::alias);
    return at != function_aliases.end() && at->alias == name ? at->name : name;
}

} // namespace spear
