// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*SetActorScale3D
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor, const spear::unreal::FVector& scale) {
    actor.async().SetActorScale3D(scale);
#ifdef REFUSED
    actor.async().SetActorScale3D(scale, scale);
#endif
}
