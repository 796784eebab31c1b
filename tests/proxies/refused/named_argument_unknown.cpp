// SPDX-License-Identifier: MIT
// refused: Nonsense
#include <spear/unreal/Engine/UKismetSystemLibrary.hpp>
void test(const spear::Game& game) {
    using Arguments = spear::unreal::UKismetSystemLibrary_PrintString_Arguments;
    game.get_class<spear::unreal::UKismetSystemLibrary>().PrintString(Arguments{.InString = "text", .Duration = 1.0});
#ifdef REFUSED
    game.get_class<spear::unreal::UKismetSystemLibrary>().PrintString(Arguments{.Nonsense = 1.0});
#endif
}
