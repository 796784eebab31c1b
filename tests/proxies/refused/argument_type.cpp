// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*SetActorScale3D
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor, const spear::Future<spear::unreal::FVector>& future) {
    actor.SetActorScale3D({4, 4, 4});
    actor.SetActorScale3D(future);
#ifdef REFUSED
    actor.SetActorScale3D("large");
#endif
}
