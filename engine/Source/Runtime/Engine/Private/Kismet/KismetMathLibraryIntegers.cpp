// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Boolean functions

bool UKismetMathLibrary::RandomBool() { return FMath::RandBool(); }

bool UKismetMathLibrary::RandomBoolWithWeight(float Weight) { return Weight > 0.0f && Weight >= FMath::FRand(); }

bool UKismetMathLibrary::Not_PreBool(bool A) { return !A; }

bool UKismetMathLibrary::EqualEqual_BoolBool(bool A, bool B) { return A == B; }

bool UKismetMathLibrary::NotEqual_BoolBool(bool A, bool B) { return A != B; }

bool UKismetMathLibrary::BooleanAND(bool A, bool B) { return A && B; }

bool UKismetMathLibrary::BooleanNAND(bool A, bool B) { return !(A && B); }

bool UKismetMathLibrary::BooleanOR(bool A, bool B) { return A || B; }

bool UKismetMathLibrary::BooleanXOR(bool A, bool B) { return A != B; }

bool UKismetMathLibrary::BooleanNOR(bool A, bool B) { return !(A || B); }

// Byte functions

uint8 UKismetMathLibrary::Multiply_ByteByte(uint8 A, uint8 B) { return static_cast<uint8>(A * B); }

uint8 UKismetMathLibrary::Divide_ByteByte(uint8 A, uint8 B) {
    if (B == 0) {
        WarnDivideByZero(TEXT("Divide_ByteByte"));
        return 0;
    }
    return static_cast<uint8>(A / B);
}

uint8 UKismetMathLibrary::Percent_ByteByte(uint8 A, uint8 B) {
    if (B == 0) {
        WarnDivideByZero(TEXT("Percent_ByteByte"));
        return 0;
    }
    return static_cast<uint8>(A % B);
}

uint8 UKismetMathLibrary::Add_ByteByte(uint8 A, uint8 B) { return static_cast<uint8>(A + B); }

uint8 UKismetMathLibrary::Subtract_ByteByte(uint8 A, uint8 B) { return static_cast<uint8>(A - B); }

uint8 UKismetMathLibrary::BMin(uint8 A, uint8 B) { return A < B ? A : B; }

uint8 UKismetMathLibrary::BMax(uint8 A, uint8 B) { return A > B ? A : B; }

bool UKismetMathLibrary::Less_ByteByte(uint8 A, uint8 B) { return A < B; }

bool UKismetMathLibrary::Greater_ByteByte(uint8 A, uint8 B) { return A > B; }

bool UKismetMathLibrary::LessEqual_ByteByte(uint8 A, uint8 B) { return A <= B; }

bool UKismetMathLibrary::GreaterEqual_ByteByte(uint8 A, uint8 B) { return A >= B; }

bool UKismetMathLibrary::EqualEqual_ByteByte(uint8 A, uint8 B) { return A == B; }

bool UKismetMathLibrary::NotEqual_ByteByte(uint8 A, uint8 B) { return A != B; }

// Integer functions

int32 UKismetMathLibrary::Multiply_IntInt(int32 A, int32 B) {
    return static_cast<int32>(static_cast<uint32>(A) * static_cast<uint32>(B));
}

int32 UKismetMathLibrary::Divide_IntInt(int32 A, int32 B) {
    if (B == 0) {
        WarnDivideByZero(TEXT("Divide_IntInt"));
        return 0;
    }
    return B == -1 ? static_cast<int32>(uint32(0) - static_cast<uint32>(A)) : A / B;
}

int32 UKismetMathLibrary::Percent_IntInt(int32 A, int32 B) {
    if (B == 0) {
        WarnDivideByZero(TEXT("Percent_IntInt"));
        return 0;
    }
    return B == -1 ? 0 : A % B;
}

int32 UKismetMathLibrary::Add_IntInt(int32 A, int32 B) {
    return static_cast<int32>(static_cast<uint32>(A) + static_cast<uint32>(B));
}

int32 UKismetMathLibrary::Subtract_IntInt(int32 A, int32 B) {
    return static_cast<int32>(static_cast<uint32>(A) - static_cast<uint32>(B));
}

bool UKismetMathLibrary::Less_IntInt(int32 A, int32 B) { return A < B; }

bool UKismetMathLibrary::Greater_IntInt(int32 A, int32 B) { return A > B; }

bool UKismetMathLibrary::LessEqual_IntInt(int32 A, int32 B) { return A <= B; }

bool UKismetMathLibrary::GreaterEqual_IntInt(int32 A, int32 B) { return A >= B; }

bool UKismetMathLibrary::EqualEqual_IntInt(int32 A, int32 B) { return A == B; }

bool UKismetMathLibrary::NotEqual_IntInt(int32 A, int32 B) { return A != B; }

int32 UKismetMathLibrary::And_IntInt(int32 A, int32 B) { return A & B; }

int32 UKismetMathLibrary::Xor_IntInt(int32 A, int32 B) { return A ^ B; }

int32 UKismetMathLibrary::Or_IntInt(int32 A, int32 B) { return A | B; }

int32 UKismetMathLibrary::Not_Int(int32 A) { return ~A; }

int32 UKismetMathLibrary::SignOfInteger(int32 A) { return A > 0 ? 1 : (A < 0 ? -1 : 0); }

int32 UKismetMathLibrary::Min(int32 A, int32 B) { return A < B ? A : B; }

int32 UKismetMathLibrary::Max(int32 A, int32 B) { return A > B ? A : B; }

int32 UKismetMathLibrary::Clamp(int32 Value, int32 Min, int32 Max) {
    return Value < Min ? Min : (Value < Max ? Value : Max);
}

int32 UKismetMathLibrary::Abs_Int(int32 A) {
    return A < 0 ? static_cast<int32>(uint32(0) - static_cast<uint32>(A)) : A;
}

// Integer64 functions

int64 UKismetMathLibrary::Multiply_Int64Int64(int64 A, int64 B) {
    return static_cast<int64>(static_cast<uint64>(A) * static_cast<uint64>(B));
}

int64 UKismetMathLibrary::Divide_Int64Int64(int64 A, int64 B) {
    if (B == 0) {
        WarnDivideByZero(TEXT("Divide_Int64Int64"));
        return 0;
    }
    return B == -1 ? static_cast<int64>(uint64(0) - static_cast<uint64>(A)) : A / B;
}

int64 UKismetMathLibrary::Percent_Int64Int64(int64 A, int64 B) {
    if (B == 0) {
        WarnDivideByZero(TEXT("Percent_Int64Int64"));
        return 0;
    }
    return B == -1 ? 0 : A % B;
}

int64 UKismetMathLibrary::Add_Int64Int64(int64 A, int64 B) {
    return static_cast<int64>(static_cast<uint64>(A) + static_cast<uint64>(B));
}

int64 UKismetMathLibrary::Subtract_Int64Int64(int64 A, int64 B) {
    return static_cast<int64>(static_cast<uint64>(A) - static_cast<uint64>(B));
}

bool UKismetMathLibrary::Less_Int64Int64(int64 A, int64 B) { return A < B; }

bool UKismetMathLibrary::Greater_Int64Int64(int64 A, int64 B) { return A > B; }

bool UKismetMathLibrary::LessEqual_Int64Int64(int64 A, int64 B) { return A <= B; }

bool UKismetMathLibrary::GreaterEqual_Int64Int64(int64 A, int64 B) { return A >= B; }

bool UKismetMathLibrary::EqualEqual_Int64Int64(int64 A, int64 B) { return A == B; }

bool UKismetMathLibrary::NotEqual_Int64Int64(int64 A, int64 B) { return A != B; }

int64 UKismetMathLibrary::And_Int64Int64(int64 A, int64 B) { return A & B; }

int64 UKismetMathLibrary::Xor_Int64Int64(int64 A, int64 B) { return A ^ B; }

int64 UKismetMathLibrary::Or_Int64Int64(int64 A, int64 B) { return A | B; }

int64 UKismetMathLibrary::Not_Int64(int64 A) { return ~A; }

int64 UKismetMathLibrary::SignOfInteger64(int64 A) { return A > 0 ? 1 : (A < 0 ? -1 : 0); }

int64 UKismetMathLibrary::MinInt64(int64 A, int64 B) { return A < B ? A : B; }

int64 UKismetMathLibrary::MaxInt64(int64 A, int64 B) { return A > B ? A : B; }

int64 UKismetMathLibrary::ClampInt64(int64 Value, int64 Min, int64 Max) {
    return Value < Min ? Min : (Value < Max ? Value : Max);
}

int64 UKismetMathLibrary::Abs_Int64(int64 A) {
    return A < 0 ? static_cast<int64>(uint64(0) - static_cast<uint64>(A)) : A;
}

// More integer functions

int32 UKismetMathLibrary::Wrap(int32 Value, int32 Min, int32 Max) {
    const int64 Size = static_cast<int64>(Max) - Min;
    if (Size <= 0) {
        return Min;
    }
    int64 Result = Value;
    if (Result < Min || Result > Max) {
        Result = (Result - Min) % Size;
        Result = Min + (Result < 0 ? Result + Size : Result);
    }
    return static_cast<int32>(Result);
}

bool UKismetMathLibrary::InRange_IntInt(int32 Value, int32 Min, int32 Max, bool InclusiveMin, bool InclusiveMax) {
    return (InclusiveMin ? Value >= Min : Value > Min) && (InclusiveMax ? Value <= Max : Value < Max);
}

bool UKismetMathLibrary::InRange_Int64Int64(int64 Value, int64 Min, int64 Max, bool InclusiveMin, bool InclusiveMax) {
    return (InclusiveMin ? Value >= Min : Value > Min) && (InclusiveMax ? Value <= Max : Value < Max);
}
