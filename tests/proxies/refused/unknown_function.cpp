// SPDX-License-Identifier: MIT
// refused: SetActorScale4D
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor) {
    actor.SetActorScale3D({4, 4, 4});
#ifdef REFUSED
    actor.SetActorScale4D({4, 4, 4});
#endif
}
