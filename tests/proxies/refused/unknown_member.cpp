// SPDX-License-Identifier: MIT
// refused: (non-static data member|designator|cannot convert)
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor) {
    actor.SetActorScale3D({.X = 4});
#ifdef REFUSED
    actor.SetActorScale3D({.Xx = 4});
#endif
}
