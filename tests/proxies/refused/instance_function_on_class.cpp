// SPDX-License-Identifier: MIT
// refused: K2_GetActorLocation
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::Game& game) {
    auto actor_class = game.get_class<spear::unreal::AActor>();
    actor_class.default_object();
#ifdef REFUSED
    actor_class.K2_GetActorLocation();
#endif
}
