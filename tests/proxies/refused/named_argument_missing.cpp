// SPDX-License-Identifier: MIT
// refused: (deleted|Substring)
#include <spear/unreal/Engine/UKismetStringLibrary.hpp>
void test(const spear::Game& game) {
    using Arguments = spear::unreal::UKismetStringLibrary_FindSubstring_Arguments;
    const auto strings = game.get_class<spear::unreal::UKismetStringLibrary>();
    strings.FindSubstring(Arguments{.SearchIn = "haystack", .Substring = "st", .bSearchFromEnd = true});
#ifdef REFUSED
    strings.FindSubstring(Arguments{.SearchIn = "haystack", .bSearchFromEnd = true});
#endif
}
