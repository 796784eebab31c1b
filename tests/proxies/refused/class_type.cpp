// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*GetComponentByClass
#include <spear/unreal/Engine/AActor.hpp>
#include <spear/unreal/Engine/USceneComponent.hpp>
void test(const spear::unreal::AActor& actor) {
    actor.GetComponentByClass(spear::class_of<spear::unreal::USceneComponent>);
#ifdef REFUSED
    actor.GetComponentByClass(spear::class_of<spear::unreal::AActor>);
#endif
}
