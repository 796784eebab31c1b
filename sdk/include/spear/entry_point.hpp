// SPDX-License-Identifier: MIT
#pragma once

// An entry point is declared once, as a typed constant that client and server share:
//
//     inline constexpr EntryPoint<"unreal_service.find_class", ObjectRef(std::string_view), Names<"name">, RunsOn::game_thread,
//         "Finds a class by name."> find_class;
//
// From it come the client's synchronous, asynchronous and fire-and-forget calls (session.hpp), the server's binding (a mismatch
// is a compile error), both encodings (codec.hpp), the Python method with its keywords, and the entry-point reference.
// The texts of all declarations are compared at connect. (Paper, section 4, "Hand-Crafted Server Entry Points".)

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>

#include "spear/codec.hpp"

namespace spear {

/// Where an entry point runs, and so when it may be called.
enum class RunsOn : std::uint8_t {
    game_thread,   ///< within an open begin_frame or end_frame block; raises NotInFrame elsewhere
    any_frame,     ///< on the game thread at the next chance, in or out of a block: read-only facts about classes and worlds
    server_thread, ///< on the server's own thread, at any time, also while the game thread is busy
};

/// A string literal as a template argument.
template <std::size_t N>
struct FixedString {
    char text[N] = {};
    constexpr FixedString(const char (&literal)[N]) { std::copy_n(literal, N, text); } // NOLINT: implicit by purpose
    constexpr std::string_view view() const { return {text, N - 1}; }
};

/// The parameters' names, in order.
template <FixedString... Name>
struct Names {
    static constexpr std::array<std::string_view, sizeof...(Name)> list = {Name.view()...};
};

template <FixedString Name, typename Signature, typename ParameterNames, RunsOn Thread, FixedString Documentation = "">
struct EntryPoint;

template <FixedString Name, typename R, typename... A, FixedString... ParameterName, RunsOn Thread, FixedString Documentation>
struct EntryPoint<Name, R(A...), Names<ParameterName...>, Thread, Documentation> {
    static_assert(sizeof...(A) == sizeof...(ParameterName), "an entry point names each of its parameters");
    using Result = R;
    using Arguments = std::tuple<A...>;
    static constexpr std::string_view name = Name.view();          ///< "service.function"
    static constexpr std::string_view documentation = Documentation.view();
    static constexpr RunsOn runs_on = Thread;
    static constexpr std::array<std::string_view, sizeof...(A)> parameters = Names<ParameterName...>::list;

    /// "unreal_service.find_class(name: string) -> object @game_thread": what is compared at connect.
    static std::string signature() {
        std::string text(name);
        text += '(';
        std::size_t index = 0;
        ((text += index ? ", " : "", text += parameters[index], text += ": ", text += Codec<A>::name, ++index), ...);
        text += ") -> ";
        if constexpr (std::is_void_v<R>) text += "none";
        else text += Codec<R>::name;
        text += Thread == RunsOn::game_thread ? " @game_thread" : Thread == RunsOn::any_frame ? " @any_frame" : " @server_thread";
        return text;
    }
};

/// A list of entry points: its order is the numbering on the wire (after the signatures were compared).
template <typename... E>
struct EntryPointList {
    static constexpr std::size_t size = sizeof...(E);

    /// Calls f(entry_point) for each.
    template <typename F>
    static constexpr void for_each(F&& f) { (f(E{}), ...); }

    /// The number of an entry point; a compile error for one that is not in the list.
    template <typename Wanted>
    static constexpr std::uint16_t index_of() {
        constexpr bool matches[] = {std::is_same_v<std::remove_cv_t<Wanted>, E>...};
        constexpr std::size_t index = static_cast<std::size_t>(std::find(std::begin(matches), std::end(matches), true) - std::begin(matches));
        static_assert(index < size, "this entry point is in no list of spear/entry_points/all.hpp");
        return static_cast<std::uint16_t>(index);
    }
};

/// Joins lists.
template <typename... L>
struct JoinLists;
template <typename... A>
struct JoinLists<EntryPointList<A...>> {
    using type = EntryPointList<A...>;
};
template <typename... A, typename... B, typename... More>
struct JoinLists<EntryPointList<A...>, EntryPointList<B...>, More...> {
    using type = typename JoinLists<EntryPointList<A..., B...>, More...>::type;
};

} // namespace spear
