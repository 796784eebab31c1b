// SPDX-License-Identifier: MIT
// refused: no matching (member )?function.*SetOwner
#include <spear/unreal/Engine/AActor.hpp>
void test(const spear::unreal::AActor& actor, const spear::Object& object) {
    actor.SetOwner(object.cast<spear::unreal::AActor>());
#ifdef REFUSED
    actor.SetOwner(object);
#endif
}
