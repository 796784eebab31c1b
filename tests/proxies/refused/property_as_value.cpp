// SPDX-License-Identifier: MIT
// refused: (could not convert|value of type|contextually convertible)
#include <spear/unreal/Engine/AActor.hpp>
bool test(const spear::unreal::AActor& actor) {
    if (actor.bHidden().get())
        return true;
#ifdef REFUSED
    if (actor.bHidden())
        return true;
#endif
    return false;
}
