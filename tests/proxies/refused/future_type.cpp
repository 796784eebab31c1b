// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*SetActorScale3D
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor) {
    actor.SetActorScale3D(actor.async().K2_GetActorLocation());
#ifdef REFUSED
    actor.SetActorScale3D(actor.async().K2_GetActorRotation());
#endif
}
