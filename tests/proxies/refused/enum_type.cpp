// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*SetMobility
#include <spear/unreal/Engine/AStaticMeshActor.hpp>
void test(const spear::unreal::AStaticMeshActor& actor) {
    actor.SetMobility(spear::unreal::EComponentMobility::Movable);
#ifdef REFUSED
    actor.SetMobility(2);
#endif
}
