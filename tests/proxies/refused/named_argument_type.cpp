// SPDX-License-Identifier: MIT
// refused: (could not convert|no viable conversion|no matching)
#include <spear/unreal/Engine/UKismetStringLibrary.hpp>
void test(const spear::Game& game) {
    using Arguments = spear::unreal::UKismetStringLibrary_FindSubstring_Arguments;
    const auto strings = game.get_class<spear::unreal::UKismetStringLibrary>();
    strings.FindSubstring(Arguments{.SearchIn = "haystack", .Substring = strings.async().ToUpper("st")});
#ifdef REFUSED
    strings.FindSubstring(Arguments{.SearchIn = "haystack", .Substring = 5});
#endif
}
