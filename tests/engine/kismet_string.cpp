// SPDX-License-Identifier: MIT
#include "engine_fixture.h"

#include "Kismet/KismetStringLibrary.h"

using Str = UKismetStringLibrary;

TEST_CASE("string library: conversions") {
    CHECK(Str::Conv_IntToString(-12) == TEXT("-12"));
    CHECK(Str::Conv_BoolToString(true) == TEXT("true"));
    CHECK(Str::Conv_DoubleToString(1.5) == TEXT("1.5"));
    CHECK(Str::Conv_DoubleToString(2.0) == TEXT("2.0"));
    CHECK(Str::Conv_StringToInt(TEXT("42 apples")) == 42);
    CHECK(Str::Conv_StringToInt(TEXT("apples")) == 0);
    CHECK(Str::Conv_ObjectToString(nullptr) == TEXT("None"));
    FVector vector;
    bool valid = false;
    Str::Conv_StringToVector(Str::Conv_VectorToString(FVector(1, -2, 3.5)), vector, valid);
    CHECK(valid);
    CHECK(vector.Equals(FVector(1, -2, 3.5), 1e-3));
    Str::Conv_StringToVector(TEXT("no vector"), vector, valid);
    CHECK_FALSE(valid);
    CHECK(Str::TimeSecondsToString(75.25f) == TEXT("01:15.25"));
    CHECK(Str::TimeSecondsToString(-1.5f) == TEXT("-00:01.50"));
}

TEST_CASE("string library: operations") {
    CHECK(Str::Concat_StrStr(TEXT("a"), TEXT("b")) == TEXT("ab"));
    CHECK(Str::EqualEqual_StriStri(TEXT("Chair"), TEXT("chair")));
    CHECK_FALSE(Str::EqualEqual_StrStr(TEXT("Chair"), TEXT("chair")));
    CHECK(Str::FindSubstring(TEXT("one two one"), TEXT("ONE")) == 0);
    CHECK(Str::FindSubstring(TEXT("one two one"), TEXT("one"), false, true) == 8);
    CHECK(Str::FindSubstring(TEXT("one"), TEXT("two")) == -1);
    CHECK(Str::GetSubstring(TEXT("abcdef"), 2, 3) == TEXT("cde"));
    CHECK(Str::GetSubstring(TEXT("abc"), 9, 3).IsEmpty());
    CHECK(Str::GetCharacterAsNumber(TEXT("A")) == 65);
    CHECK(Str::GetCharacterAsNumber(TEXT("A"), 5) == 0);
    const TArray<FString> parts = Str::ParseIntoArray(TEXT("a,,b"), TEXT(","));
    CHECK(parts.Num() == 2);
    CHECK(Str::ParseIntoArray(TEXT("a,,b"), TEXT(","), false).Num() == 3);
    CHECK(Str::JoinStringArray(parts, TEXT("-")) == TEXT("a-b"));
    CHECK(Str::MatchesWildcard(TEXT("Kitchen_Chair_12"), TEXT("*chair*")));
    CHECK(Str::Replace(TEXT("a b a"), TEXT("a"), TEXT("x")) == TEXT("x b x"));
    FString left, right;
    CHECK(Str::Split(TEXT("key=value"), TEXT("="), left, right));
    CHECK(left == TEXT("key"));
    CHECK(right == TEXT("value"));
    CHECK_FALSE(Str::Split(TEXT("key"), TEXT("="), left, right));
    CHECK(Str::Reverse(TEXT("abc")) == TEXT("cba"));
    CHECK(Str::LeftPad(TEXT("7"), 3) == TEXT("  7"));
    CHECK(Str::Trim(TEXT("  a ")) == TEXT("a "));
}
