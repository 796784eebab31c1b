// SPDX-License-Identifier: MIT
// refused: RelativeLocatio
#include <spear/unreal/Engine/AActor.hpp>
#include <spear/unreal/Engine/USceneComponent.hpp>
double test(const spear::unreal::AActor& actor) {
#ifdef REFUSED
    return actor.RootComponent().RelativeLocatio().X().get();
#else
    return actor.RootComponent().RelativeLocation().X().get();
#endif
}
