// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*SetActorScale3D
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor) {
    actor.GetAttachedActors(spear::omit);
#ifdef REFUSED
    actor.SetActorScale3D(spear::omit);
#endif
}
