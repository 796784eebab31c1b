// SPDX-License-Identifier: MIT
// refused: (only declared here: include its header|incomplete type)
#include <spear/unreal/Engine/AActor.hpp>
#ifndef REFUSED
#include <spear/unreal/Engine/USceneComponent.hpp>
#endif
void test(const spear::unreal::AActor& actor) { actor.K2_GetRootComponent(); }
