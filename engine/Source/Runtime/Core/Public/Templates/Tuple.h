// SPDX-License-Identifier: MIT
/** TTuple and TPair (the tuple of two, with members Key and Value). */
#pragma once

#include <tuple>

#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

template <typename... Types>
struct TTuple {
    TTuple() = default;
    template <typename... ArgTypes>
        requires(sizeof...(ArgTypes) == sizeof...(Types) && sizeof...(Types) != 0 &&
                 (std::is_constructible_v<Types, ArgTypes &&> && ...))
    explicit(sizeof...(Types) == 1) TTuple(ArgTypes&&... Args) : Elements(Forward<ArgTypes>(Args)...) {}

    template <uint32 Index>
    auto& Get() & {
        return std::get<Index>(Elements);
    }
    template <uint32 Index>
    const auto& Get() const& {
        return std::get<Index>(Elements);
    }
    template <uint32 Index>
    auto&& Get() && {
        return std::get<Index>(MoveTemp(Elements));
    }
    template <typename T>
    T& Get() & {
        return std::get<T>(Elements);
    }
    template <typename T>
    const T& Get() const& {
        return std::get<T>(Elements);
    }
    template <typename FuncType, typename... ArgTypes>
    decltype(auto) ApplyAfter(FuncType&& Func, ArgTypes&&... Args) const {
        return std::apply(
            [&](const Types&... Values) -> decltype(auto) { return Func(Forward<ArgTypes>(Args)..., Values...); },
            Elements);
    }
    template <typename FuncType, typename... ArgTypes>
    decltype(auto) ApplyBefore(FuncType&& Func, ArgTypes&&... Args) const {
        return std::apply(
            [&](const Types&... Values) -> decltype(auto) { return Func(Values..., Forward<ArgTypes>(Args)...); },
            Elements);
    }
    bool operator==(const TTuple& Other) const { return Elements == Other.Elements; }
    bool operator<(const TTuple& Other) const { return Elements < Other.Elements; }

    friend uint32 GetTypeHash(const TTuple& Tuple) {
        uint32 Hash = 0;
        std::apply([&](const Types&... Values) { ((Hash = HashCombine(Hash, GetTypeHashHelper(Values))), ...); },
            Tuple.Elements);
        return Hash;
    }

private:
    std::tuple<Types...> Elements;
};

template <typename InKeyType, typename InValueType>
struct TTuple<InKeyType, InValueType> {
    using KeyType = InKeyType;
    using ValueType = InValueType;

    InKeyType Key;
    InValueType Value;

    TTuple() : Key(), Value() {}
    TTuple(const TTuple&) = default;
    TTuple(TTuple&&) = default;
    TTuple& operator=(const TTuple&) = default;
    TTuple& operator=(TTuple&&) = default;
    template <typename K, typename V>
        requires(std::is_constructible_v<InKeyType, K &&> && std::is_constructible_v<InValueType, V &&>)
    TTuple(K&& InKey, V&& InValue) : Key(Forward<K>(InKey)), Value(Forward<V>(InValue)) {}
    template <typename K, typename V>
        requires(std::is_constructible_v<InKeyType, const K&> && std::is_constructible_v<InValueType, const V&> &&
                    !(std::is_same_v<K, InKeyType> && std::is_same_v<V, InValueType>))
    TTuple(const TTuple<K, V>& Other) : Key(Other.Key), Value(Other.Value) {}

    template <uint32 Index>
    decltype(auto) Get() & {
        static_assert(Index < 2);
        if constexpr (Index == 0) {
            return (Key);
        } else {
            return (Value);
        }
    }
    template <uint32 Index>
    decltype(auto) Get() const& {
        static_assert(Index < 2);
        if constexpr (Index == 0) {
            return (Key);
        } else {
            return (Value);
        }
    }
    bool operator==(const TTuple& Other) const { return Key == Other.Key && Value == Other.Value; }
    bool operator<(const TTuple& Other) const { return Key < Other.Key || (!(Other.Key < Key) && Value < Other.Value); }
    friend uint32 GetTypeHash(const TTuple& Pair) {
        return HashCombine(GetTypeHashHelper(Pair.Key), GetTypeHashHelper(Pair.Value));
    }
};

template <typename KeyType, typename ValueType>
using TPair = TTuple<KeyType, ValueType>;

template <typename... Types>
TTuple<std::decay_t<Types>...> MakeTuple(Types&&... Args) {
    return TTuple<std::decay_t<Types>...>(Forward<Types>(Args)...);
}
/** References to variables, to be assigned from a tuple. */
template <typename A, typename B>
struct TTiedPair {
    A& First;
    B& Second;
    template <typename K, typename V>
    void operator=(const TTuple<K, V>& Pair) {
        First = Pair.Key;
        Second = Pair.Value;
    }
};
template <typename A, typename B>
TTiedPair<A, B> Tie(A& First, B& Second) {
    return {First, Second};
}

// Structured bindings. Pairs bind through their two public members.
template <SIZE_T Index, typename... Types>
    requires(sizeof...(Types) != 2)
decltype(auto) get(TTuple<Types...>& Tuple) {
    return Tuple.template Get<static_cast<uint32>(Index)>();
}
template <SIZE_T Index, typename... Types>
    requires(sizeof...(Types) != 2)
decltype(auto) get(const TTuple<Types...>& Tuple) {
    return Tuple.template Get<static_cast<uint32>(Index)>();
}
template <SIZE_T Index, typename... Types>
    requires(sizeof...(Types) != 2)
decltype(auto) get(TTuple<Types...>&& Tuple) {
    return MoveTemp(Tuple).template Get<static_cast<uint32>(Index)>();
}
template <typename... Types>
    requires(sizeof...(Types) != 2)
struct std::tuple_size<TTuple<Types...>> : std::integral_constant<std::size_t, sizeof...(Types)> {};
template <std::size_t Index, typename... Types>
    requires(sizeof...(Types) != 2)
struct std::tuple_element<Index, TTuple<Types...>> {
    using type = std::tuple_element_t<Index, std::tuple<Types...>>;
};
