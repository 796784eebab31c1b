// SPDX-License-Identifier: MIT
// refused: (conversion from|no viable conversion)
#include <spear/unreal/Engine/APawn.hpp>
void test(const spear::unreal::AActor& actor) {
    spear::unreal::APawn pawn = actor.cast<spear::unreal::APawn>();
#ifdef REFUSED
    pawn = actor;
    spear::unreal::APawn other = actor;
#endif
}
