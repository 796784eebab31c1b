// SPDX-License-Identifier: MIT
/** UE's names for type traits, on top of the standard ones. */
#pragma once

#include <type_traits>

#include "HAL/Platform.h"

/** `typename TEnableIf<Predicate, R>::Type` exists only where Predicate holds. */
template <bool Predicate, typename Result = void>
struct TEnableIf {};
template <typename Result>
struct TEnableIf<true, Result> {
    typedef Result type;
    typedef Result Type;
};

template <typename... Types>
struct TAnd {
    static constexpr bool value = (Types::value && ...);
    static constexpr bool Value = value;
};
template <typename... Types>
struct TOr {
    static constexpr bool value = (Types::value || ...);
    static constexpr bool Value = value;
};
template <typename Type>
struct TNot {
    static constexpr bool value = !Type::value;
    static constexpr bool Value = value;
};

namespace UE::Core::Private {
template <bool B>
struct TBoolTrait {
    static constexpr bool value = B;
    static constexpr bool Value = B;
};
} // namespace UE::Core::Private
#define UE_CORE_TRAIT(Name, ...)                                                                                       \
    template <typename T>                                                                                              \
    struct Name : UE::Core::Private::TBoolTrait<__VA_ARGS__> {}

UE_CORE_TRAIT(TIsEnum, std::is_enum_v<T>);
UE_CORE_TRAIT(TIsClass, std::is_class_v<T>);
UE_CORE_TRAIT(TIsPointer, std::is_pointer_v<T>);
UE_CORE_TRAIT(TIsConst, std::is_const_v<T>);
UE_CORE_TRAIT(TIsArray, std::is_array_v<T>);
UE_CORE_TRAIT(TIsArithmetic, std::is_arithmetic_v<T>);
UE_CORE_TRAIT(TIsFloatingPoint, std::is_floating_point_v<T>);
UE_CORE_TRAIT(TIsIntegral, std::is_integral_v<T>);
UE_CORE_TRAIT(TIsSigned, std::is_signed_v<T>);
UE_CORE_TRAIT(TIsAbstract, std::is_abstract_v<T>);
UE_CORE_TRAIT(TIsPolymorphic, std::is_polymorphic_v<T>);
UE_CORE_TRAIT(TIsReferenceType, std::is_reference_v<T>);
UE_CORE_TRAIT(TIsLValueReferenceType, std::is_lvalue_reference_v<T>);
UE_CORE_TRAIT(TIsRValueReferenceType, std::is_rvalue_reference_v<T>);
UE_CORE_TRAIT(TIsMemberPointer, std::is_member_pointer_v<T>);
UE_CORE_TRAIT(TIsTrivial, std::is_trivial_v<T>);
UE_CORE_TRAIT(TIsTriviallyCopyConstructible, std::is_trivially_copy_constructible_v<T>);
UE_CORE_TRAIT(TIsTriviallyCopyAssignable, std::is_trivially_copy_assignable_v<T>);
UE_CORE_TRAIT(TIsTriviallyDestructible, std::is_trivially_destructible_v<T>);
UE_CORE_TRAIT(TIsPODType, std::is_trivial_v<T>&& std::is_standard_layout_v<T>);
UE_CORE_TRAIT(TIsZeroConstructType, std::is_enum_v<T> || std::is_arithmetic_v<T> || std::is_pointer_v<T>);
UE_CORE_TRAIT(TIsCharType, std::is_same_v<T, char> || std::is_same_v<T, wchar_t> || std::is_same_v<T, char8_t> ||
                               std::is_same_v<T, char16_t> || std::is_same_v<T, char32_t>);
UE_CORE_TRAIT(TIsEnumClass, std::is_enum_v<T> && !std::is_convertible_v<T, int>);
/** True for pointer types that do not keep their object alive; specialised where such types are defined. */
UE_CORE_TRAIT(TIsWeakPointerType, false);
/** True for containers whose elements lie one after another: TArray, TArrayView, FString, C arrays, ... */
UE_CORE_TRAIT(TIsContiguousContainer, std::is_array_v<std::remove_reference_t<T>>);
UE_CORE_TRAIT(TIsTArray, false);
UE_CORE_TRAIT(TIsTSet, false);
UE_CORE_TRAIT(TIsTMap, false);
UE_CORE_TRAIT(TIsTSharedPtr, false);
UE_CORE_TRAIT(TIsTSharedRef, false);
UE_CORE_TRAIT(TIsTEnumAsByte, false);
/** Specialised to true by the reflection registration for each UENUM. */
UE_CORE_TRAIT(TIsUEnumClass, false);

template <typename T>
inline constexpr bool TIsContiguousContainer_V = TIsContiguousContainer<T>::Value;
template <typename T>
inline constexpr bool TIsCharType_V = TIsCharType<T>::Value;

template <typename A, typename B>
struct TIsSame : UE::Core::Private::TBoolTrait<std::is_same_v<A, B>> {};
template <typename T, typename... Args>
struct TIsConstructible : UE::Core::Private::TBoolTrait<std::is_constructible_v<T, Args...>> {};
template <typename Callable, typename... Args>
struct TIsInvocable : UE::Core::Private::TBoolTrait<std::is_invocable_v<Callable, Args...>> {};
/** `TIsDerivedFrom<D, B>::Value`: D is B or derived from it. */
template <typename DerivedType, typename BaseType>
struct TIsDerivedFrom : UE::Core::Private::TBoolTrait<std::is_base_of_v<BaseType, DerivedType>> {
    static constexpr bool IsDerived = std::is_base_of_v<BaseType, DerivedType>;
};
template <typename From, typename To>
struct TPointerIsConvertibleFromTo : UE::Core::Private::TBoolTrait<std::is_convertible_v<From*, To*>> {};

template <typename T>
struct TRemoveReference {
    typedef std::remove_reference_t<T> Type;
};
template <typename T>
struct TRemovePointer {
    typedef std::remove_pointer_t<T> Type;
};
template <typename T>
struct TRemoveCV {
    typedef std::remove_cv_t<T> Type;
};
template <typename T>
struct TRemoveConst {
    typedef std::remove_const_t<T> Type;
};
template <typename T>
struct TDecay {
    typedef std::decay_t<T> Type;
};
template <typename T>
struct TIdentity {
    typedef T Type;
};
template <typename T>
using TIdentity_T = typename TIdentity<T>::Type;
template <bool Predicate, typename TrueClass, typename FalseClass>
struct TChooseClass {
    typedef std::conditional_t<Predicate, TrueClass, FalseClass> Result;
};
template <typename T>
struct TUnderlyingType {
    typedef std::underlying_type_t<T> Type;
};

/** May a T be made by copying the bytes of an Arg? */
template <typename T, typename Arg>
struct TIsBitwiseConstructible
    : UE::Core::Private::TBoolTrait<std::is_same_v<std::remove_cv_t<T>, std::remove_cv_t<Arg>> &&
                                    std::is_trivially_copy_constructible_v<T>> {};

/** How a T is best passed as an argument. */
template <typename T>
struct TCallTraits {
    typedef T ValueType;
    typedef T& Reference;
    typedef const T& ConstReference;
    typedef std::conditional_t<(std::is_arithmetic_v<T> || std::is_pointer_v<T> || std::is_enum_v<T>), const T,
        const T&>
        ParamType;
    typedef std::conditional_t<std::is_pointer_v<T>, const std::remove_pointer_t<T>*, const T> ConstPointerType;
};
template <typename T>
struct TTypeTraits {
    typedef typename TCallTraits<T>::ParamType ConstInitType;
    typedef typename TCallTraits<T>::ConstPointerType ConstPointerType;
};
