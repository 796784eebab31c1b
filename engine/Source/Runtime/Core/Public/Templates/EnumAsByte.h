// SPDX-License-Identifier: MIT
/** TEnumAsByte: a plain enum stored in one byte, as UPROPERTY needs it. */
#pragma once

#include "CoreTypes.h"
#include "Templates/TypeHash.h"
#include "Templates/UnrealTypeTraits.h"

template <class InEnumType>
class TEnumAsByte {
    static_assert(!TIsEnumClass<InEnumType>::Value, "TEnumAsByte is not for enum classes; use the enum class itself.");

public:
    using EnumType = InEnumType;

    TEnumAsByte() = default;
    TEnumAsByte(const TEnumAsByte&) = default;
    TEnumAsByte& operator=(const TEnumAsByte&) = default;
    constexpr TEnumAsByte(EnumType InValue) : Value(static_cast<uint8>(InValue)) {}
    explicit constexpr TEnumAsByte(int32 InValue) : Value(static_cast<uint8>(InValue)) {}
    explicit constexpr TEnumAsByte(uint8 InValue) : Value(InValue) {}

    bool operator==(EnumType InValue) const { return static_cast<EnumType>(Value) == InValue; }
    bool operator==(TEnumAsByte InValue) const { return Value == InValue.Value; }
    constexpr operator EnumType() const { return static_cast<EnumType>(Value); }
    constexpr EnumType GetValue() const { return static_cast<EnumType>(Value); }
    constexpr uint8 GetIntValue() const { return Value; }

    friend uint32 GetTypeHash(TEnumAsByte Enum) { return Enum.Value; }

private:
    uint8 Value;
};
template <class T>
struct TIsTEnumAsByte<TEnumAsByte<T>> : UE::Core::Private::TBoolTrait<true> {};
