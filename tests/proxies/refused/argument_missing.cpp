// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*K2_SetActorLocation
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor) {
    actor.K2_SetActorLocation({1, 2, 3}, false, true);
#ifdef REFUSED
    actor.K2_SetActorLocation({1, 2, 3}, false);
#endif
}
