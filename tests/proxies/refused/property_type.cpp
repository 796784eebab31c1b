// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*set
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor) {
    actor.CustomTimeDilation().set(0.5);
#ifdef REFUSED
    actor.CustomTimeDilation().set("fast");
#endif
}
