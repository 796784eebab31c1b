// SPDX-License-Identifier: MIT
/** MoveTemp, Forward, Swap and the small scope helpers. */
#pragma once

#include <initializer_list>
#include <memory>
#include <new>
#include <utility>

#include "CoreTypes.h"
#include "HAL/UnrealMemory.h"
#include "Templates/AlignmentTemplates.h"
#include "Templates/UnrealTypeTraits.h"

/** std::move that refuses constants and temporaries. */
template <typename T>
constexpr std::remove_reference_t<T>&& MoveTemp(T&& Obj) noexcept {
    static_assert(std::is_lvalue_reference_v<T>, "MoveTemp called on an rvalue");
    static_assert(!std::is_const_v<std::remove_reference_t<T>>, "MoveTemp called on a const object");
    return static_cast<std::remove_reference_t<T>&&>(Obj);
}

/** std::move without MoveTemp's checks. */
template <typename T>
constexpr std::remove_reference_t<T>&& MoveTempIfPossible(T&& Obj) noexcept {
    return static_cast<std::remove_reference_t<T>&&>(Obj);
}

/** A copy to be moved from. */
template <typename T>
T CopyTemp(T& Val) {
    return const_cast<const T&>(Val);
}
template <typename T>
T CopyTemp(const T& Val) {
    return Val;
}

template <typename T>
constexpr T&& Forward(std::remove_reference_t<T>& Obj) noexcept {
    return static_cast<T&&>(Obj);
}
template <typename T>
constexpr T&& Forward(std::remove_reference_t<T>&& Obj) noexcept {
    return static_cast<T&&>(Obj);
}

template <typename T>
constexpr void Swap(T& A, T& B) {
    T Temp = MoveTemp(A);
    A = MoveTemp(B);
    B = MoveTemp(Temp);
}
template <typename T>
constexpr void Exchange(T& A, T& B) {
    Swap(A, B);
}

/** The value itself, converted implicitly: documents a conversion without a cast. */
template <typename T>
T ImplicitConv(typename TIdentity<T>::Type Obj) {
    return Obj;
}

/** The address, also of types that overload operator&. */
template <typename T>
T* AddressOf(T& Obj) {
    return std::addressof(Obj);
}

/** Uncopyable base. */
class FNoncopyable {
protected:
    FNoncopyable() = default;
    ~FNoncopyable() = default;

private:
    FNoncopyable(const FNoncopyable&) = delete;
    FNoncopyable& operator=(const FNoncopyable&) = delete;
};

/** Sets a variable for the length of a scope. */
template <typename RefType, typename AssignedType = RefType>
struct TGuardValue : private FNoncopyable {
    [[nodiscard]] TGuardValue(RefType& ReferenceValue, const AssignedType& NewValue)
        : RefValue(ReferenceValue), OriginalValue(ReferenceValue) {
        RefValue = NewValue;
    }
    ~TGuardValue() { RefValue = OriginalValue; }
    const AssignedType& operator*() const { return OriginalValue; }
    const AssignedType& GetOriginalValue() const { return OriginalValue; }

private:
    RefType& RefValue;
    AssignedType OriginalValue;
};

/** Counts a variable up for the length of a scope. */
template <typename Type>
struct TScopeCounter : private FNoncopyable {
    [[nodiscard]] explicit TScopeCounter(Type& ReferenceValue) : RefValue(ReferenceValue) { ++RefValue; }
    ~TScopeCounter() { --RefValue; }

private:
    Type& RefValue;
};

template <typename KeyType, typename ValueType>
struct TKeyValuePair {
    TKeyValuePair(const KeyType& InKey, const ValueType& InValue) : Key(InKey), Value(InValue) {}
    TKeyValuePair() = default;
    bool operator==(const TKeyValuePair& Other) const { return Key == Other.Key; }
    bool operator<(const TKeyValuePair& Other) const { return Key < Other.Key; }
    KeyType Key;
    ValueType Value;
};

/** True if any of the values equals the first. */
template <typename ValueType, typename... Others>
bool IsAnyOf(const ValueType& Value, const Others&... Candidates) {
    return ((Value == Candidates) || ...);
}

/** Address and count of C arrays, initialiser lists and of containers with GetData() and Num(). */
template <typename T, SIZE_T N>
constexpr T* GetData(T (&Container)[N]) {
    return Container;
}
template <typename T>
constexpr T* GetData(std::initializer_list<T> List) {
    return List.begin();
}
template <typename ContainerType>
constexpr auto GetData(ContainerType&& Container) -> decltype(Container.GetData()) {
    return Container.GetData();
}
template <typename T, SIZE_T N>
constexpr SIZE_T GetNum(T (&)[N]) {
    return N;
}
template <typename T>
constexpr int32 GetNum(std::initializer_list<T> List) {
    return static_cast<int32>(List.size());
}
template <typename ContainerType>
constexpr auto GetNum(ContainerType&& Container) -> decltype(Container.Num()) {
    return Container.Num();
}
