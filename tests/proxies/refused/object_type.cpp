// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*SetOwner
#include <spear/unreal/Engine/APawn.hpp>
#include <spear/unreal/Engine/USceneComponent.hpp>
void test(const spear::unreal::AActor& actor, const spear::unreal::APawn& pawn, const spear::unreal::USceneComponent& component) {
    actor.SetOwner(pawn);
#ifdef REFUSED
    actor.SetOwner(component);
#else
    (void)component;
#endif
}
