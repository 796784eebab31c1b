// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Kismet/BlueprintFunctionLibrary.h"
#include "Math/RandomStream.h"
#include "Misc/DateTime.h"
#include "Misc/Timespan.h"
#include "Templates/SubclassOf.h"
#include "UObject/ObjectMacros.h"

#include "KismetMathLibrary.generated.h"

/** Easing functions. Epic page: EEasingFunc::Type. */
UENUM(BlueprintType)
namespace EEasingFunc {
enum Type : int {
    /** Simple linear interpolation. */
    Linear,
    /** Simple step interpolation. */
    Step,
    /** Sinusoidal in interpolation. */
    SinusoidalIn,
    /** Sinusoidal out interpolation. */
    SinusoidalOut,
    /** Sinusoidal in/out interpolation. */
    SinusoidalInOut,
    /** Smoothly accelerates, but does not decelerate into the target. Ease amount controlled by BlendExp. */
    EaseIn,
    /** Immediately accelerates, but smoothly decelerates into the target. Ease amount controlled by BlendExp. */
    EaseOut,
    /** Smoothly accelerates and decelerates. Ease amount controlled by BlendExp. */
    EaseInOut,
    /** Easing in using an exponential. */
    ExpoIn,
    /** Easing out using an exponential. */
    ExpoOut,
    /** Easing in/out using an exponential method. */
    ExpoInOut,
    /** Easing is based on a half circle. */
    CircularIn,
    /** Easing is based on an inverted half circle. */
    CircularOut,
    /** Easing is based on two half circles. */
    CircularInOut
};
}

/** Different methods for interpolating rotation between transforms. Epic page: ELerpInterpolationMode::Type. */
UENUM(BlueprintType)
namespace ELerpInterpolationMode {
enum Type : int {
    /** Shortest path or quaternion interpolation for the rotation. */
    QuatInterp,
    /** Rotor or Euler angle interpolation. */
    EulerInterp,
    /** Dual quaternion interpolation, follows helix or screw-motion path between keyframes. */
    DualQuatInterp
};
}

/**
 * Mathematics for scripts and remote programs. Angles are in degrees unless a name says radians; "float" in names and
 * titles means double precision, as in UE 5. Division by zero gives zero and a warning in the log. Epic page:
 * UKismetMathLibrary.
 */
UCLASS(meta = (BlueprintThreadSafe, ScriptName = "MathLibrary"))
class ENGINE_API UKismetMathLibrary : public UBlueprintFunctionLibrary {
    GENERATED_BODY()

public:
    // ----------------------------------------------------------------------------------------------- Boolean functions

    /** Returns a uniformly distributed random bool. */
    UFUNCTION(BlueprintPure, Category = "Math|Boolean")
    static bool RandomBool();

    /** Gets a random chance with the specified weight: 0 is never, 1 is always. */
    UFUNCTION(BlueprintPure, Category = "Math|Boolean")
    static bool RandomBoolWithWeight(float Weight);

    /** Returns the logical complement of the Boolean value (NOT A). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "NOT Boolean", CompactNodeTitle = "NOT", Keywords = "! not negate"),
        Category = "Math|Boolean")
    static bool Not_PreBool(bool A);

    /** Returns true if the values are equal (A == B). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Equal (Boolean)", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Math|Boolean")
    static bool EqualEqual_BoolBool(bool A, bool B);

    /** Returns true if the values are not equal (A != B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Not Equal (Boolean)", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Math|Boolean")
    static bool NotEqual_BoolBool(bool A, bool B);

    /** Returns the logical AND of two values (A AND B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "AND Boolean", CompactNodeTitle = "AND", Keywords = "& and",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Boolean")
    static bool BooleanAND(bool A, bool B);

    /** Returns the logical NAND of two values (A NAND B). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "NAND Boolean", CompactNodeTitle = "NAND", Keywords = "!& nand"),
        Category = "Math|Boolean")
    static bool BooleanNAND(bool A, bool B);

    /** Returns the logical OR of two values (A OR B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "OR Boolean", CompactNodeTitle = "OR", Keywords = "| or",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Boolean")
    static bool BooleanOR(bool A, bool B);

    /** Returns the logical eXclusive OR of two values (A XOR B). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "XOR Boolean", CompactNodeTitle = "XOR", Keywords = "^ xor"),
        Category = "Math|Boolean")
    static bool BooleanXOR(bool A, bool B);

    /** Returns the logical Not OR of two values (A NOR B). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "NOR Boolean", CompactNodeTitle = "NOR", Keywords = "!^ nor"),
        Category = "Math|Boolean")
    static bool BooleanNOR(bool A, bool B);

    // -------------------------------------------------------------------------------------------------- Byte functions

    /** Multiplication (A * B), modulo 256. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "byte * byte", CompactNodeTitle = "*", Keywords = "* multiply",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Byte")
    static uint8 Multiply_ByteByte(uint8 A, uint8 B);

    /** Division (A / B). Division by zero gives 0 and a warning in the log. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "byte / byte", CompactNodeTitle = "/", Keywords = "/ divide division"),
        Category = "Math|Byte")
    static uint8 Divide_ByteByte(uint8 A, uint8 B = 1);

    /** Modulo (A % B). Modulo zero gives 0 and a warning in the log. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "% (Byte)", CompactNodeTitle = "%", Keywords = "% modulus"),
        Category = "Math|Byte")
    static uint8 Percent_ByteByte(uint8 A, uint8 B = 1);

    /** Addition (A + B), modulo 256. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "byte + byte", CompactNodeTitle = "+", Keywords = "+ add plus",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Byte")
    static uint8 Add_ByteByte(uint8 A, uint8 B = 1);

    /** Subtraction (A - B), modulo 256. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "byte - byte", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|Byte")
    static uint8 Subtract_ByteByte(uint8 A, uint8 B = 1);

    /** Returns the minimum value of A and B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Min (Byte)", CompactNodeTitle = "MIN", CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Byte")
    static uint8 BMin(uint8 A, uint8 B);

    /** Returns the maximum value of A and B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Max (Byte)", CompactNodeTitle = "MAX", CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Byte")
    static uint8 BMax(uint8 A, uint8 B);

    /** Returns true if A < B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "byte < byte", CompactNodeTitle = "<", Keywords = "< less"),
        Category = "Math|Byte")
    static bool Less_ByteByte(uint8 A, uint8 B);

    /** Returns true if A > B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "byte > byte", CompactNodeTitle = ">", Keywords = "> greater"),
        Category = "Math|Byte")
    static bool Greater_ByteByte(uint8 A, uint8 B);

    /** Returns true if A <= B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "byte <= byte", CompactNodeTitle = "<=", Keywords = "<= less or equal"),
        Category = "Math|Byte")
    static bool LessEqual_ByteByte(uint8 A, uint8 B);

    /** Returns true if A >= B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "byte >= byte", CompactNodeTitle = ">=", Keywords = ">= greater or equal"),
        Category = "Math|Byte")
    static bool GreaterEqual_ByteByte(uint8 A, uint8 B);

    /** Returns true if A == B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "byte == byte", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Math|Byte")
    static bool EqualEqual_ByteByte(uint8 A, uint8 B);

    /** Returns true if A != B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "byte != byte", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Math|Byte")
    static bool NotEqual_ByteByte(uint8 A, uint8 B);

    // ----------------------------------------------------------------------------------------------- Integer functions

    /** Multiplication (A * B); wraps on overflow. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer * integer", CompactNodeTitle = "*", Keywords = "* multiply",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer")
    static int32 Multiply_IntInt(int32 A, int32 B);

    /** Division (A / B), towards zero. Division by zero gives 0 and a warning in the log. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer / integer", CompactNodeTitle = "/", Keywords = "/ divide division"),
        Category = "Math|Integer")
    static int32 Divide_IntInt(int32 A, int32 B = 1);

    /** Modulo (A % B). Modulo zero gives 0 and a warning in the log. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "% (Integer)", CompactNodeTitle = "%", Keywords = "% modulus"),
        Category = "Math|Integer")
    static int32 Percent_IntInt(int32 A, int32 B = 1);

    /** Addition (A + B); wraps on overflow. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer + integer", CompactNodeTitle = "+", Keywords = "+ add plus",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer")
    static int32 Add_IntInt(int32 A, int32 B = 1);

    /** Subtraction (A - B); wraps on overflow. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer - integer", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|Integer")
    static int32 Subtract_IntInt(int32 A, int32 B = 1);

    /** Returns true if A < B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "integer < integer", CompactNodeTitle = "<", Keywords = "< less"),
        Category = "Math|Integer")
    static bool Less_IntInt(int32 A, int32 B);

    /** Returns true if A > B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "integer > integer", CompactNodeTitle = ">", Keywords = "> greater"),
        Category = "Math|Integer")
    static bool Greater_IntInt(int32 A, int32 B);

    /** Returns true if A <= B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer <= integer", CompactNodeTitle = "<=", Keywords = "<= less or equal"),
        Category = "Math|Integer")
    static bool LessEqual_IntInt(int32 A, int32 B);

    /** Returns true if A >= B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer >= integer", CompactNodeTitle = ">=", Keywords = ">= greater or equal"),
        Category = "Math|Integer")
    static bool GreaterEqual_IntInt(int32 A, int32 B);

    /** Returns true if A == B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer == integer", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Math|Integer")
    static bool EqualEqual_IntInt(int32 A, int32 B);

    /** Returns true if A != B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer != integer", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Math|Integer")
    static bool NotEqual_IntInt(int32 A, int32 B);

    /** Bitwise AND (A & B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Bitwise AND", CompactNodeTitle = "&", Keywords = "& and",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer")
    static int32 And_IntInt(int32 A, int32 B);

    /** Bitwise XOR (A ^ B). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Bitwise XOR", CompactNodeTitle = "^", Keywords = "^ xor"),
        Category = "Math|Integer")
    static int32 Xor_IntInt(int32 A, int32 B);

    /** Bitwise OR (A | B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Bitwise OR", CompactNodeTitle = "|", Keywords = "| or",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer")
    static int32 Or_IntInt(int32 A, int32 B);

    /** Bitwise NOT (~A). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Bitwise NOT", CompactNodeTitle = "~", Keywords = "~ not"),
        Category = "Math|Integer")
    static int32 Not_Int(int32 A);

    /** Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Sign (Integer)"), Category = "Math|Integer")
    static int32 SignOfInteger(int32 A);

    /** Returns the minimum value of A and B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Min (Integer)", CompactNodeTitle = "MIN", CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer")
    static int32 Min(int32 A, int32 B);

    /** Returns the maximum value of A and B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Max (Integer)", CompactNodeTitle = "MAX", CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer")
    static int32 Max(int32 A, int32 B);

    /** Returns Value clamped to be between Min and Max (inclusive). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Clamp (Integer)"), Category = "Math|Integer")
    static int32 Clamp(int32 Value, int32 Min, int32 Max);

    /** Returns the absolute (positive) value of A. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Absolute (Integer)", CompactNodeTitle = "ABS"), Category = "Math|Integer")
    static int32 Abs_Int(int32 A);

    // --------------------------------------------------------------------------------------------- Integer64 functions

    /** Multiplication (A * B); wraps on overflow. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 * integer64", CompactNodeTitle = "*", Keywords = "* multiply",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer64")
    static int64 Multiply_Int64Int64(int64 A, int64 B);

    /** Division (A / B), towards zero. Division by zero gives 0 and a warning in the log. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 / integer64", CompactNodeTitle = "/", Keywords = "/ divide division"),
        Category = "Math|Integer64")
    static int64 Divide_Int64Int64(int64 A, int64 B = 1);

    /** Modulo (A % B). Modulo zero gives 0 and a warning in the log. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "% (Integer64)", CompactNodeTitle = "%", Keywords = "% modulus"),
        Category = "Math|Integer64")
    static int64 Percent_Int64Int64(int64 A, int64 B = 1);

    /** Addition (A + B); wraps on overflow. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 + integer64", CompactNodeTitle = "+", Keywords = "+ add plus",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer64")
    static int64 Add_Int64Int64(int64 A, int64 B = 1);

    /** Subtraction (A - B); wraps on overflow. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 - integer64", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|Integer64")
    static int64 Subtract_Int64Int64(int64 A, int64 B = 1);

    /** Returns true if A < B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 < integer64", CompactNodeTitle = "<", Keywords = "< less"),
        Category = "Math|Integer64")
    static bool Less_Int64Int64(int64 A, int64 B);

    /** Returns true if A > B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 > integer64", CompactNodeTitle = ">", Keywords = "> greater"),
        Category = "Math|Integer64")
    static bool Greater_Int64Int64(int64 A, int64 B);

    /** Returns true if A <= B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 <= integer64", CompactNodeTitle = "<=", Keywords = "<= less or equal"),
        Category = "Math|Integer64")
    static bool LessEqual_Int64Int64(int64 A, int64 B);

    /** Returns true if A >= B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 >= integer64", CompactNodeTitle = ">=", Keywords = ">= greater or equal"),
        Category = "Math|Integer64")
    static bool GreaterEqual_Int64Int64(int64 A, int64 B);

    /** Returns true if A == B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 == integer64", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Math|Integer64")
    static bool EqualEqual_Int64Int64(int64 A, int64 B);

    /** Returns true if A != B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "integer64 != integer64", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Math|Integer64")
    static bool NotEqual_Int64Int64(int64 A, int64 B);

    /** Bitwise AND (A & B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Bitwise AND", CompactNodeTitle = "&", Keywords = "& and",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer64")
    static int64 And_Int64Int64(int64 A, int64 B);

    /** Bitwise XOR (A ^ B). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Bitwise XOR", CompactNodeTitle = "^", Keywords = "^ xor"),
        Category = "Math|Integer64")
    static int64 Xor_Int64Int64(int64 A, int64 B);

    /** Bitwise OR (A | B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Bitwise OR", CompactNodeTitle = "|", Keywords = "| or",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer64")
    static int64 Or_Int64Int64(int64 A, int64 B);

    /** Bitwise NOT (~A). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Bitwise NOT", CompactNodeTitle = "~", Keywords = "~ not"),
        Category = "Math|Integer64")
    static int64 Not_Int64(int64 A);

    /** Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Sign (Integer64)"), Category = "Math|Integer64")
    static int64 SignOfInteger64(int64 A);

    /** Returns the minimum value of A and B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Min (Integer64)", CompactNodeTitle = "MIN",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer64")
    static int64 MinInt64(int64 A, int64 B);

    /** Returns the maximum value of A and B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Max (Integer64)", CompactNodeTitle = "MAX",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Integer64")
    static int64 MaxInt64(int64 A, int64 B);

    /** Returns Value clamped to be between Min and Max (inclusive). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Clamp (Integer64)"), Category = "Math|Integer64")
    static int64 ClampInt64(int64 Value, int64 Min, int64 Max);

    /** Returns the absolute (positive) value of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Absolute (Integer64)", CompactNodeTitle = "ABS"),
        Category = "Math|Integer64")
    static int64 Abs_Int64(int64 A);

    // ------------------------------------------------------------------------------------------ More integer functions

    /** Returns Value wrapped to be between Min and Max (inclusive); an empty range gives Min. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Wrap (Integer)"), Category = "Math|Integer")
    static int32 Wrap(int32 Value, int32 Min, int32 Max);

    /** Returns true if value is between Min and Max. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "In Range (Integer)", Min = "0", Max = "10"), Category = "Math|Integer")
    static bool InRange_IntInt(int32 Value, int32 Min, int32 Max, bool InclusiveMin = true, bool InclusiveMax = true);

    /** Returns true if value is between Min and Max. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "In Range (Integer64)", Min = "0", Max = "10"), Category = "Math|Integer")
    static bool InRange_Int64Int64(
        int64 Value, int64 Min, int64 Max, bool InclusiveMin = true, bool InclusiveMax = true);

    // ------------------------------------------------------------------------------ Float (double-precision) functions

    /** Power (Base to the Exp-th power). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Power", CompactNodeTitle = "^", Keywords = "** ^ power"),
        Category = "Math|Float")
    static double MultiplyMultiply_FloatFloat(double Base, double Exp);

    /** Multiplication (A * B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "float * float", CompactNodeTitle = "*", Keywords = "* multiply",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Float")
    static double Multiply_DoubleDouble(double A, double B);

    /** Multiplication (A * B). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "integer * float", CompactNodeTitle = "*", Keywords = "* multiply"),
        Category = "Math|Float")
    static double Multiply_IntFloat(int32 A, double B);

    /** Division (A / B). Division by zero gives 0 and a warning in the log. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "float / float", CompactNodeTitle = "/", Keywords = "/ divide division"),
        Category = "Math|Float")
    static double Divide_DoubleDouble(double A, double B = 1.0);

    /** Modulo (A % B), with the sign of A. Modulo zero gives 0 and a warning in the log. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "% (Float)", CompactNodeTitle = "%", Keywords = "% modulus"),
        Category = "Math|Float")
    static double Percent_FloatFloat(double A, double B = 1.0);

    /** Returns the fractional part of a float: A - floor(A). */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static double Fraction(double A);

    /** Addition (A + B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "float + float", CompactNodeTitle = "+", Keywords = "+ add plus",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Float")
    static double Add_DoubleDouble(double A, double B = 1.0);

    /** Subtraction (A - B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "float - float", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|Float")
    static double Subtract_DoubleDouble(double A, double B = 1.0);

    /** Returns true if A < B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "float < float", CompactNodeTitle = "<", Keywords = "< less"),
        Category = "Math|Float")
    static bool Less_DoubleDouble(double A, double B);

    /** Returns true if A > B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "float > float", CompactNodeTitle = ">", Keywords = "> greater"),
        Category = "Math|Float")
    static bool Greater_DoubleDouble(double A, double B);

    /** Returns true if A <= B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "float <= float", CompactNodeTitle = "<=", Keywords = "<= less or equal"),
        Category = "Math|Float")
    static bool LessEqual_DoubleDouble(double A, double B);

    /** Returns true if A >= B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "float >= float", CompactNodeTitle = ">=", Keywords = ">= greater or equal"),
        Category = "Math|Float")
    static bool GreaterEqual_DoubleDouble(double A, double B);

    /** Returns true if A == B exactly. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "float == float", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Math|Float")
    static bool EqualEqual_DoubleDouble(double A, double B);

    /** Returns true if A != B exactly. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "float != float", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Math|Float")
    static bool NotEqual_DoubleDouble(double A, double B);

    /** Returns true if A and B differ by no more than the tolerance. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Nearly Equal (Float)", Keywords = "== equal"), Category = "Math|Float")
    static bool NearlyEqual_FloatFloat(double A, double B, double ErrorTolerance = 1.e-6);

    /** Returns true if value is between Min and Max. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "In Range (Float)", Min = "0.0", Max = "1.0"), Category = "Math|Float")
    static bool InRange_FloatFloat(
        double Value, double Min, double Max, bool InclusiveMin = true, bool InclusiveMax = true);

    /** Returns the hypotenuse of a right-angled triangle given the width and height. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "pythagorean theorem"), Category = "Math|Float")
    static double Hypotenuse(double Width, double Height);

    /** Returns log of A base B (if B^R == A, returns R). A base of 1 or less gives 0. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static double Log(double A, double Base = 1.0);

    /** Returns natural log of A (if e^R == A, returns R). */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static double Loge(double A);

    /** Returns exponential (e) to the power A (e^A). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "e", CompactNodeTitle = "e"), Category = "Math|Float")
    static double Exp(double A);

    /** Returns the square root of A; 0 with a warning in the log when A is negative. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "square root", CompactNodeTitle = "SQRT"), Category = "Math|Float")
    static double Sqrt(double A);

    /** Returns square of A (A * A). */
    UFUNCTION(BlueprintPure, meta = (CompactNodeTitle = "^2"), Category = "Math|Float")
    static double Square(double A);

    /** Returns the absolute (positive) value of A. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Absolute (Float)", CompactNodeTitle = "ABS"), Category = "Math|Float")
    static double Abs(double A);

    /** Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Sign (Float)"), Category = "Math|Float")
    static double SignOfFloat(double A);

    /** Returns Value normalized to the given range. (For example 20 normalized to the range 10-50 would result in
     * 0.25.) */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static double NormalizeToRange(double Value, double RangeMin, double RangeMax);

    /** Returns Value mapped from one range into another. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "get mapped value"), Category = "Math|Float")
    static double MapRangeUnclamped(double Value, double InRangeA, double InRangeB, double OutRangeA, double OutRangeB);

    /** Returns Value mapped from one range into another where the Value is clamped to the input range. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "get mapped value"), Category = "Math|Float")
    static double MapRangeClamped(double Value, double InRangeA, double InRangeB, double OutRangeA, double OutRangeB);

    /** Multiplies the input value by pi. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Multiply By Pi"), Category = "Math|Float")
    static double MultiplyByPi(double Value);

    /** Interpolates between A and B, applying an ease in/out function. Exponent controls the degree of the curve. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Interp Ease In Out"), Category = "Math|Float")
    static double FInterpEaseInOut(double A, double B, double Alpha, double Exponent);

    /** Makes a value that pulsates between 0 and 1 with the current time (seconds); a phase of 0 starts at 0.5 and
     * rises. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static double MakePulsatingValue(double InCurrentTime, float InPulsesPerSecond = 1.0f, float InPhase = 0.0f);

    /** Returns Value wrapped to be between Min and Max (inclusive); an empty range gives Min. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Wrap (Float)"), Category = "Math|Float")
    static double FWrap(double Value, double Min, double Max);

    /** Returns the minimum value of A and B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Min (Float)", CompactNodeTitle = "MIN", CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Float")
    static double FMin(double A, double B);

    /** Returns the maximum value of A and B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Max (Float)", CompactNodeTitle = "MAX", CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Float")
    static double FMax(double A, double B);

    /** Returns Value clamped between Min and Max (inclusive). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Clamp (Float)", Min = "0.0", Max = "1.0"), Category = "Math|Float")
    static double FClamp(double Value, double Min, double Max);

    /** Returns max of all array entries and the index at which it was found. Returns value of 0 and index of -1 if the
     * supplied array is empty. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static void MaxOfIntArray(const TArray<int32>& IntArray, int32& IndexOfMaxValue, int32& MaxValue);

    /** Returns min of all array entries and the index at which it was found. Returns value of 0 and index of -1 if the
     * supplied array is empty. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static void MinOfIntArray(const TArray<int32>& IntArray, int32& IndexOfMinValue, int32& MinValue);

    /** Returns max of all array entries and the index at which it was found. Returns value of 0 and index of -1 if the
     * supplied array is empty. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static void MaxOfFloatArray(const TArray<float>& FloatArray, int32& IndexOfMaxValue, float& MaxValue);

    /** Returns min of all array entries and the index at which it was found. Returns value of 0 and index of -1 if the
     * supplied array is empty. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static void MinOfFloatArray(const TArray<float>& FloatArray, int32& IndexOfMinValue, float& MinValue);

    /** Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Lerp"), Category = "Math|Float")
    static double Lerp(double A, double B, double Alpha);

    /** Eases between A and B using a specified easing function. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Ease", BlueprintInternalUseOnly = "true"), Category = "Math|Float")
    static double Ease(double A, double B, double Alpha, TEnumAsByte<EEasingFunc::Type> EasingFunc, double BlendExp = 2,
        int32 Steps = 2);

    /** Rounds A to the nearest integer. A fraction of .5 rounds up: 1.5 gives 2, -1.5 gives -1. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static int32 Round(double A);

    /** Rounds A down towards negative infinity. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Floor"), Category = "Math|Float")
    static int32 FFloor(double A);

    /** Rounds A towards zero, truncating the fractional part. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Truncate", Keywords = "BlueprintAutocast"), Category = "Math|Float")
    static int32 FTrunc(double A);

    /** Rounds A up towards positive infinity. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Ceil"), Category = "Math|Float")
    static int32 FCeil(double A);

    /** Rounds A to the nearest integer. A fraction of .5 rounds up. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Round to Integer64"), Category = "Math|Float")
    static int64 Round64(double A);

    /** Rounds A down towards negative infinity. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Floor to Integer64"), Category = "Math|Float")
    static int64 FFloor64(double A);

    /** Rounds A towards zero, truncating the fractional part. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Truncate to Integer64"), Category = "Math|Float")
    static int64 FTrunc64(double A);

    /** Rounds A up towards positive infinity. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Ceil to Integer64"), Category = "Math|Float")
    static int64 FCeil64(double A);

    /** Returns the number of times Divisor will go into Dividend and the remainder. A zero divisor gives 0 and 0. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Division (whole and remainder)"), Category = "Math|Float")
    static int32 FMod(double Dividend, double Divisor, double& Remainder);

    /** Scalar division (A / B) where a zero divisor gives 0. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static double SafeDivide(double A, double B);

    /** Returns a new rotation component value: InCurrent moved towards InDesired the shorter way by no more than
     * InDeltaRate, in degrees. */
    UFUNCTION(BlueprintPure, Category = "Math|Float")
    static double FixedTurn(double InCurrent, double InDesired, double InDeltaRate);

    /** Returns the value of pi. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get PI", CompactNodeTitle = "PI"), Category = "Math|Float")
    static double GetPI();

    /** Returns the value of tau (= 2 * pi). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get TAU", CompactNodeTitle = "TAU"), Category = "Math|Float")
    static double GetTAU();

    // ---------------------------------------------------------------------------------------------------- Trigonometry

    /** Returns the sine of A (expects Radians). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Sin (Radians)", CompactNodeTitle = "SIN"), Category = "Math|Trig")
    static double Sin(double A);

    /** Returns the cosine of A (expects Radians). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Cos (Radians)", CompactNodeTitle = "COS"), Category = "Math|Trig")
    static double Cos(double A);

    /** Returns the tan of A (expects Radians). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Tan (Radians)", CompactNodeTitle = "TAN"), Category = "Math|Trig")
    static double Tan(double A);

    /** Returns the inverse function (arcsin) of A (result is in Radians). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Asin (Radians)", CompactNodeTitle = "ASIN"), Category = "Math|Trig")
    static double Asin(double A);

    /** Returns the inverse function (arccos) of A (result is in Radians). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Acos (Radians)", CompactNodeTitle = "ACOS"), Category = "Math|Trig")
    static double Acos(double A);

    /** Returns the inverse function (arctan) of A (result is in Radians). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Atan (Radians)", CompactNodeTitle = "ATAN"), Category = "Math|Trig")
    static double Atan(double A);

    /** Returns the inverse tan (atan2) of Y/X (result is in Radians). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Atan2 (Radians)"), Category = "Math|Trig")
    static double Atan2(double Y, double X);

    /** Returns degrees value based on the input radians. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Radians To Degrees", CompactNodeTitle = "R2D"), Category = "Math|Trig")
    static double RadiansToDegrees(double A);

    /** Returns radians value based on the input degrees. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Degrees To Radians", CompactNodeTitle = "D2R"), Category = "Math|Trig")
    static double DegreesToRadians(double A);

    /** Returns the sin of A (expects Degrees). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Sin (Degrees)", CompactNodeTitle = "SINd"), Category = "Math|Trig")
    static double DegSin(double A);

    /** Returns the cos of A (expects Degrees). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Cos (Degrees)", CompactNodeTitle = "COSd"), Category = "Math|Trig")
    static double DegCos(double A);

    /** Returns the tan of A (expects Degrees). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Tan (Degrees)", CompactNodeTitle = "TANd"), Category = "Math|Trig")
    static double DegTan(double A);

    /** Returns the inverse function (arcsin) of A (result is in Degrees). */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Asin (Degrees)", CompactNodeTitle = "ASINd"), Category = "Math|Trig")
    static double DegAsin(double A);

    /** Returns the inverse function (arccos) of A (result is in Degrees). */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Acos (Degrees)", CompactNodeTitle = "ACOSd"), Category = "Math|Trig")
    static double DegAcos(double A);

    /** Returns the inverse function (arctan) of A (result is in Degrees). */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Atan (Degrees)", CompactNodeTitle = "ATANd"), Category = "Math|Trig")
    static double DegAtan(double A);

    /** Returns the inverse tan (atan2) of Y/X (result is in Degrees). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Atan2 (Degrees)"), Category = "Math|Trig")
    static double DegAtan2(double Y, double X);

    /** Clamps an arbitrary angle to be between the given angles. Will clamp to nearest boundary. The result is between
     * -180 and 180. */
    UFUNCTION(BlueprintPure, Category = "Math|Trig")
    static double ClampAngle(double AngleDegrees, double MinAngleDegrees, double MaxAngleDegrees);

    /** Clamps an angle to the range of [-180, 180]. */
    UFUNCTION(BlueprintPure, Category = "Math|Trig")
    static double NormalizeAxis(double Angle);

    /** Clamps an angle to the range of [0, 360]. */
    UFUNCTION(BlueprintPure, Category = "Math|Trig")
    static double ClampAxis(double Angle);

    // ---------------------------------------------------------------------------------------- Interpolation of numbers

    /** Tries to reach Target based on distance from Current position, giving a nice smooth feeling when tracking a
     * position. A speed of 0 jumps. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "position"), Category = "Math|Interpolation")
    static double FInterpTo(double Current, double Target, double DeltaTime, double InterpSpeed);

    /** Tries to reach Target at a constant rate. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "position"), Category = "Math|Interpolation")
    static double FInterpTo_Constant(double Current, double Target, double DeltaTime, double InterpSpeed);

    // ----------------------------------------------------------------------------------------------------- Conversions

    /** Converts a float to a 64 bit integer. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Integer64 (Float)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static int64 Conv_DoubleToInt64(double InDouble);

    /** Converts a double-precision number to a single-precision one. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Float (Double)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static float Conv_DoubleToFloat(double InDouble);

    /** Converts a single-precision number to a double-precision one. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Double (Float)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static double Conv_FloatToDouble(float InFloat);

    /** Converts an integer to a float. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Float (Integer)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static double Conv_IntToDouble(int32 InInt);

    /** Converts an integer to a 64 bit integer. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Integer64 (Integer)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static int64 Conv_IntToInt64(int32 InInt);

    /** Converts an integer to a byte (if the integer is too large, returns the low 8 bits). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Byte (Integer)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static uint8 Conv_IntToByte(int32 InInt);

    /** Converts a 64 bit integer to a 32 bit integer (the low 32 bits). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Integer (Integer64)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static int32 Conv_Int64ToInt(int64 InInt);

    /** Converts a 64 bit integer to a float. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Float (Integer64)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static double Conv_Int64ToDouble(int64 InInt);

    /** Converts an int to a bool. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Boolean (Integer)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static bool Conv_IntToBool(int32 InInt);

    /** Converts a bool to an int. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Integer (Boolean)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static int32 Conv_BoolToInt(bool InBool);

    /** Converts a bool to a float (0.0 or 1.0). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Float (Boolean)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static double Conv_BoolToDouble(bool InBool);

    /** Converts a bool to a byte. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Byte (Boolean)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static uint8 Conv_BoolToByte(bool InBool);

    /** Converts a byte to a float. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Float (Byte)", CompactNodeTitle = "->", Keywords = "cast convert", BlueprintAutocast),
        Category = "Math|Conversions")
    static double Conv_ByteToDouble(uint8 InByte);

    /** Converts a byte to an integer. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Integer (Byte)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static int32 Conv_ByteToInt(uint8 InByte);

    /** Converts a byte to a 64 bit integer. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Integer64 (Byte)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static int64 Conv_ByteToInt64(uint8 InByte);

    /** Converts a float to a vector, with the same value in every component. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Vector (Float)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector Conv_DoubleToVector(double InDouble);

    /** Converts a float to a 2D vector, with the same value in both components. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Vector2D (Float)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector2D Conv_DoubleToVector2D(double InDouble);

    /** Converts a float to a linear colour: grey, opaque. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To LinearColor (Float)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FLinearColor Conv_DoubleToLinearColor(double InDouble);

    /** Converts an integer to a vector, with the same value in every component. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Vector (Integer)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector Conv_IntToVector(int32 InInt);

    /** Converts a vector to a linear colour, opaque. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To LinearColor (Vector)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FLinearColor Conv_VectorToLinearColor(FVector InVec);

    /** Converts a vector to a 2D vector by dropping Z. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Vector2D (Vector)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector2D Conv_VectorToVector2D(FVector InVector);

    /** Converts a 2D vector to a vector. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Vector (Vector2D)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector Conv_Vector2DToVector(FVector2D InVector2D, float Z = 0);

    /** Converts a vector to a transform: a translation. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Transform (Vector)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FTransform Conv_VectorToTransform(FVector InLocation);

    /** Returns the rotation that points along a direction: yaw and pitch, no roll. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Rotation From X Vector", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FRotator Conv_VectorToRotator(FVector InVec);

    /** Returns the rotation that points along a direction. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Quaternion (Vector)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FQuat Conv_VectorToQuaternion(FVector InVec);

    /** Gets the X direction vector after this rotation. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Get Rotation X Vector", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector Conv_RotatorToVector(FRotator InRot);

    /** Converts a rotator to a transform. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Transform (Rotator)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FTransform Conv_RotatorToTransform(const FRotator& InRotator);

    /** Converts a rotator to a quaternion. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Quaternion (Rotator)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FQuat Conv_RotatorToQuaternion(FRotator InRot);

    /** Converts an integer vector to a vector. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Vector (IntVector)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector Conv_IntVectorToVector(const FIntVector& InIntVector);

    /** Converts an integer point to a 2D vector. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Vector2D (IntPoint)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector2D Conv_IntPointToVector2D(FIntPoint InIntPoint);

    /** Converts an sRGB-encoded colour to a linear one. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To LinearColor (Color)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FLinearColor Conv_ColorToLinearColor(FColor InColor);

    /** Converts a linear colour to a vector (alpha is dropped). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Vector (LinearColor)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FVector Conv_LinearColorToVector(FLinearColor InLinearColor);

    /** Converts a linear colour to a byte colour, with or without the sRGB gamma. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Color (LinearColor)", CompactNodeTitle = "->", Keywords = "cast convert",
            BlueprintAutocast),
        Category = "Math|Conversions")
    static FColor Conv_LinearColorToColor(FLinearColor InLinearColor, bool InUseSRGB = true);

    // ------------------------------------------------------------------------------------------------ Vector functions

    /** 3D vector (0, 0, 0). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Zero Vector", ScriptConstant = "ZERO",
            ScriptConstantHost = "/Script/CoreUObject.Vector"),
        Category = "Math|Vector")
    static FVector Vector_Zero();

    /** 3D vector (1, 1, 1). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "One Vector", ScriptConstant = "ONE", ScriptConstantHost = "/Script/CoreUObject.Vector"),
        Category = "Math|Vector")
    static FVector Vector_One();

    /** 3D vector forward: (1, 0, 0). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Forward Vector", ScriptConstant = "FORWARD",
            ScriptConstantHost = "/Script/CoreUObject.Vector"),
        Category = "Math|Vector")
    static FVector Vector_Forward();

    /** 3D vector backward: (-1, 0, 0). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Backward Vector", ScriptConstant = "BACKWARD",
            ScriptConstantHost = "/Script/CoreUObject.Vector"),
        Category = "Math|Vector")
    static FVector Vector_Backward();

    /** 3D vector up: (0, 0, 1). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Up Vector", ScriptConstant = "UP", ScriptConstantHost = "/Script/CoreUObject.Vector"),
        Category = "Math|Vector")
    static FVector Vector_Up();

    /** 3D vector down: (0, 0, -1). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Down Vector", ScriptConstant = "DOWN",
            ScriptConstantHost = "/Script/CoreUObject.Vector"),
        Category = "Math|Vector")
    static FVector Vector_Down();

    /** 3D vector right: (0, 1, 0). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Right Vector", ScriptConstant = "RIGHT",
            ScriptConstantHost = "/Script/CoreUObject.Vector"),
        Category = "Math|Vector")
    static FVector Vector_Right();

    /** 3D vector left: (0, -1, 0). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Left Vector", ScriptConstant = "LEFT",
            ScriptConstantHost = "/Script/CoreUObject.Vector"),
        Category = "Math|Vector")
    static FVector Vector_Left();

    /** Makes a vector {X, Y, Z}. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build", NativeMakeFunc), Category = "Math|Vector")
    static FVector MakeVector(double X, double Y, double Z);

    /** Creates a directional vector from rotation values {Yaw, Pitch} supplied in degrees with specified Length. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Vector")
    static FVector CreateVectorFromYawPitch(float Yaw, float Pitch, float Length = 1.0f);

    /** Breaks a vector apart into X, Y, Z. */
    UFUNCTION(BlueprintPure, meta = (NativeBreakFunc), Category = "Math|Vector")
    static void BreakVector(FVector InVec, double& X, double& Y, double& Z);

    /** Returns true if vector A is equal to vector B (A == B) exactly. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Equal Exactly (Vector)", CompactNodeTitle = "===", ScriptMethod = "IsExactlyEqual",
            Keywords = "== equal"),
        Category = "Math|Vector")
    static bool EqualExactly_VectorVector(FVector A, FVector B);

    /** Returns true if vector A is equal to vector B (A == B) within a specified error tolerance. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Nearly Equal (Vector)", CompactNodeTitle = "==", ScriptMethod = "IsNearEqual",
            Keywords = "== equal"),
        Category = "Math|Vector")
    static bool EqualEqual_VectorVector(FVector A, FVector B, float ErrorTolerance = 1.e-4f);

    /** Returns true if vector A is not equal to vector B (A != B) exactly. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Not Equal Exactly (Vector)", CompactNodeTitle = "!==", Keywords = "!= not equal"),
        Category = "Math|Vector")
    static bool NotEqualExactly_VectorVector(FVector A, FVector B);

    /** Returns true if vector A is not equal to vector B (A != B) within a specified error tolerance. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Not Equal (Vector)", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Math|Vector")
    static bool NotEqual_VectorVector(FVector A, FVector B, float ErrorTolerance = 1.e-4f);

    /** Vector addition. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector + vector", CompactNodeTitle = "+", Keywords = "+ add plus",
            CommutativeAssociativeBinaryOperator = "true", ScriptMethod = "Add", ScriptOperator = "+;+="),
        Category = "Math|Vector")
    static FVector Add_VectorVector(FVector A, FVector B);

    /** Adds a float to each component of a vector. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "vector + float", CompactNodeTitle = "+", Keywords = "+ add plus"),
        Category = "Math|Vector")
    static FVector Add_VectorFloat(FVector A, double B);

    /** Adds an integer to each component of a vector. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "vector + integer", CompactNodeTitle = "+", Keywords = "+ add plus"),
        Category = "Math|Vector")
    static FVector Add_VectorInt(FVector A, int32 B);

    /** Vector subtraction. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector - vector", CompactNodeTitle = "-", Keywords = "- subtract minus",
            ScriptMethod = "Subtract", ScriptOperator = "-;-="),
        Category = "Math|Vector")
    static FVector Subtract_VectorVector(FVector A, FVector B);

    /** Subtracts a float from each component of a vector. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector - float", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|Vector")
    static FVector Subtract_VectorFloat(FVector A, double B);

    /** Subtracts an integer from each component of a vector. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector - integer", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|Vector")
    static FVector Subtract_VectorInt(FVector A, int32 B);

    /** Element-wise vector multiplication (Result = {A.x*B.x, A.y*B.y, A.z*B.z}). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector * vector", CompactNodeTitle = "*", Keywords = "* multiply",
            CommutativeAssociativeBinaryOperator = "true", ScriptMethod = "Multiply", ScriptOperator = "*;*="),
        Category = "Math|Vector")
    static FVector Multiply_VectorVector(FVector A, FVector B);

    /** Scales vector A by B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector * float", CompactNodeTitle = "*", Keywords = "* multiply",
            ScriptMethod = "MultiplyFloat"),
        Category = "Math|Vector")
    static FVector Multiply_VectorFloat(FVector A, double B);

    /** Scales vector A by B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "vector * integer", CompactNodeTitle = "*", Keywords = "* multiply"),
        Category = "Math|Vector")
    static FVector Multiply_VectorInt(FVector A, int32 B);

    /** Element-wise vector division (Result = {A.x/B.x, A.y/B.y, A.z/B.z}). A component of B that is zero gives a zero
     * vector and a warning in the log. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector / vector", CompactNodeTitle = "/", Keywords = "/ divide division",
            ScriptMethod = "Divide", ScriptOperator = "/;/="),
        Category = "Math|Vector")
    static FVector Divide_VectorVector(FVector A, FVector B = FVector(1.f, 1.f, 1.f));

    /** Vector divide by a float. Division by zero gives a zero vector and a warning in the log. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector / float", CompactNodeTitle = "/", Keywords = "/ divide division"),
        Category = "Math|Vector")
    static FVector Divide_VectorFloat(FVector A, double B = 1.0);

    /** Vector divide by an integer. Division by zero gives a zero vector and a warning in the log. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector / integer", CompactNodeTitle = "/", Keywords = "/ divide division"),
        Category = "Math|Vector")
    static FVector Divide_VectorInt(FVector A, int32 B = 1);

    /** Negate a vector. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "Negated", ScriptOperator = "neg"), Category = "Math|Vector")
    static FVector NegateVector(FVector A);

    /** Returns the dot product of two 3D vectors. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Dot Product", CompactNodeTitle = "dot", ScriptMethod = "Dot", ScriptOperator = "|"),
        Category = "Math|Vector")
    static double Dot_VectorVector(FVector A, FVector B);

    /** Returns the cross product of two 3D vectors. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Cross Product", CompactNodeTitle = "cross", ScriptMethod = "Cross",
            ScriptOperator = "^"),
        Category = "Math|Vector")
    static FVector Cross_VectorVector(FVector A, FVector B);

    /** Returns the result of rotating a vector by a rotator. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Rotate Vector", ScriptMethod = "Rotate"), Category = "Math|Vector")
    static FVector GreaterGreater_VectorRotator(FVector A, FRotator B);

    /** Returns result of vector A rotated by the inverse of rotator B. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Unrotate Vector", ScriptMethod = "Unrotate"), Category = "Math|Vector")
    static FVector LessLess_VectorRotator(FVector A, FRotator B);

    /** Returns result of vector InVect rotated by AngleDeg degrees around Axis (a unit vector). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Rotate Vector Around Axis", ScriptMethod = "RotateAngleAxis"),
        Category = "Math|Vector")
    static FVector RotateAngleAxis(FVector InVect, float AngleDeg, FVector Axis);

    /** Set the values of the vector directly. */
    UFUNCTION(BlueprintCallable, meta = (ScriptMethod = "Set"), Category = "Math|Vector")
    static void Vector_Set(UPARAM(ref) FVector& A, double X, double Y, double Z);

    /** Assign the values of the supplied vector. */
    UFUNCTION(BlueprintCallable, meta = (ScriptMethod = "Assign"), Category = "Math|Vector")
    static void Vector_Assign(UPARAM(ref) FVector& A, const FVector& InVector);

    /** Returns the length of the vector. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Vector Length", ScriptMethod = "Length", Keywords = "magnitude"),
        Category = "Math|Vector")
    static double VSize(FVector A);

    /** Returns the squared length of the vector. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Vector Length Squared", ScriptMethod = "LengthSquared", Keywords = "magnitude"),
        Category = "Math|Vector")
    static double VSizeSquared(FVector A);

    /** Returns the length of the vector's XY components. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Vector Length XY", ScriptMethod = "Length2D", Keywords = "magnitude"),
        Category = "Math|Vector")
    static double VSizeXY(FVector A);

    /** Returns the squared length of the vector's XY components. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Vector Length XY Squared", ScriptMethod = "Length2DSquared", Keywords = "magnitude"),
        Category = "Math|Vector")
    static double VSizeXYSquared(FVector A);

    /** Distance between two points. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Distance (Vector)", ScriptMethod = "Distance", Keywords = "magnitude"),
        Category = "Math|Vector")
    static double Vector_Distance(FVector V1, FVector V2);

    /** Squared distance between two points. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Distance Squared (Vector)", ScriptMethod = "DistanceSquared", Keywords = "magnitude"),
        Category = "Math|Vector")
    static double Vector_DistanceSquared(FVector V1, FVector V2);

    /** Distance between two points in the XY plane (ignoring Z). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Distance 2D (Vector)", ScriptMethod = "Distance2D", Keywords = "magnitude"),
        Category = "Math|Vector")
    static double Vector_Distance2D(FVector V1, FVector V2);

    /** Squared distance between two points in the XY plane (ignoring Z). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Distance2D Squared (Vector)", ScriptMethod = "Distance2DSquared",
            Keywords = "magnitude"),
        Category = "Math|Vector")
    static double Vector_Distance2DSquared(FVector V1, FVector V2);

    /** Gets a normalized unit vector; a zero vector when the length of A squared is smaller than the tolerance. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Normalize", Keywords = "Unit Vector", ScriptMethod = "Normal"),
        Category = "Math|Vector")
    static FVector Normal(FVector A, float Tolerance = 1.e-4f);

    /** Gets a normalized unit vector of the XY components, with Z zero. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Normalize 2D (Vector)", Keywords = "Unit Vector", ScriptMethod = "Normal2D"),
        Category = "Math|Vector")
    static FVector Vector_Normal2D(FVector A, float Tolerance = 1.e-4f);

    /** Checks whether all components of the vector are exactly zero. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Is Zero (Vector)", ScriptMethod = "IsZero"), Category = "Math|Vector")
    static bool Vector_IsZero(const FVector& A);

    /** Checks whether the vector is near to zero within a specified tolerance. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Is Nearly Zero (Vector)", ScriptMethod = "IsNearlyZero"),
        Category = "Math|Vector")
    static bool Vector_IsNearlyZero(const FVector& A, float Tolerance = 1.e-4f);

    /** Determines if any component is not a number (NAN). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Is NaN (Vector)", ScriptMethod = "IsNAN"), Category = "Math|Vector")
    static bool Vector_IsNAN(const FVector& A);

    /** Checks whether all components of the vector are the same, within a tolerance. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Is Uniform (Vector)", ScriptMethod = "IsUniform"),
        Category = "Math|Vector")
    static bool Vector_IsUniform(const FVector& A, float Tolerance = 1.e-4f);

    /** Determines if vector is normalized / unit (length 1) within specified squared tolerance. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Is Unit (Vector)", ScriptMethod = "IsUnit", Keywords = "Unit Vector"),
        Category = "Math|Vector")
    static bool Vector_IsUnit(const FVector& A, float SquaredLenthTolerance = 1.e-4f);

    /** Determines if vector is normalized / unit (length 1). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Is Normal (Vector)", ScriptMethod = "IsNormal", Keywords = "Unit Vector"),
        Category = "Math|Vector")
    static bool Vector_IsNormal(const FVector& A);

    /** Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Lerp (Vector)", ScriptMethod = "LerpTo"), Category = "Math|Vector")
    static FVector VLerp(FVector A, FVector B, float Alpha);

    /** Eases between A and B using a specified easing function. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Ease (Vector)", BlueprintInternalUseOnly = "true"),
        Category = "Math|Vector")
    static FVector VEase(FVector A, FVector B, float Alpha, TEnumAsByte<EEasingFunc::Type> EasingFunc,
        float BlendExp = 2, int32 Steps = 2);

    /** Tries to reach Target based on distance from Current position, giving a nice smooth feeling when tracking a
     * position. A speed of 0 jumps. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "InterpTo", Keywords = "position"), Category = "Math|Vector")
    static FVector VInterpTo(FVector Current, FVector Target, float DeltaTime, float InterpSpeed);

    /** Tries to reach Target at a constant rate. */
    UFUNCTION(
        BlueprintPure, meta = (ScriptMethod = "InterpToConstant", Keywords = "position"), Category = "Math|Vector")
    static FVector VInterpTo_Constant(FVector Current, FVector Target, float DeltaTime, float InterpSpeed);

    /** Gets the reciprocal of this vector, avoiding division by zero: zero components give 3.4e38. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Reciprocal (Vector)", ScriptMethod = "Reciprocal"),
        Category = "Math|Vector")
    static FVector Vector_Reciprocal(const FVector& A);

    /** Given a direction vector and a surface normal, returns the vector reflected across the surface normal. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "Reflection"), Category = "Math|Vector")
    static FVector GetReflectionVector(FVector Direction, FVector SurfaceNormal);

    /** Mirrors a vector by a normal (a unit vector). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Mirror Vector By Normal", ScriptMethod = "MirrorByVector"),
        Category = "Math|Vector")
    static FVector MirrorVectorByNormal(FVector InVect, FVector InNormal);

    /** Projects one vector (V) onto another (Target) and returns the projected vector. A zero target gives a zero
     * vector. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "ProjectOnTo", Keywords = "ProjectOnTo"), Category = "Math|Vector")
    static FVector ProjectVectorOnToVector(FVector V, FVector Target);

    /** Projects a point onto a plane defined by a point on the plane and a plane normal. */
    UFUNCTION(BlueprintPure, Category = "Math|Vector")
    static FVector ProjectPointOnToPlane(FVector Point, FVector PlaneBase, FVector PlaneNormal);

    /** Projects a vector onto a plane defined by a normalized vector (PlaneNormal). */
    UFUNCTION(BlueprintPure, Category = "Math|Vector")
    static FVector ProjectVectorOnToPlane(FVector V, FVector PlaneNormal);

    /** Creates a copy of this vector with its magnitude clamped between Min and Max. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Clamp Vector Size", ScriptMethod = "ClampedSize"),
        Category = "Math|Vector")
    static FVector ClampVectorSize(FVector A, double Min, double Max);

    /** Creates a copy of this vector with its maximum magnitude clamped to Max. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Clamp Size Max (Vector)", ScriptMethod = "ClampedSizeMax"),
        Category = "Math|Vector")
    static FVector Vector_ClampSizeMax(FVector A, double Max);

    /** Finds the minimum element (X, Y or Z) of a vector. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "GetMinElement"), Category = "Math|Vector")
    static double GetMinElement(FVector A);

    /** Finds the maximum element (X, Y or Z) of a vector. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "GetMaxElement"), Category = "Math|Vector")
    static double GetMaxElement(FVector A);

    /** Gets a copy of this vector with absolute value of each component. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Absolute (Vector)", ScriptMethod = "GetAbs"),
        Category = "Math|Vector")
    static FVector Vector_GetAbs(FVector A);

    /** Finds the unit direction vector from one position to another; a zero vector when they coincide. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Get Unit Direction (Vector)", ScriptMethod = "DirectionUnitTo",
            Keywords = "Unit Vector"),
        Category = "Math|Vector")
    static FVector GetDirectionUnitVector(FVector From, FVector To);

    /** Breaks a direction vector apart into Yaw and Pitch rotation values given in degrees. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Vector")
    static void GetYawPitchFromVector(FVector InVec, float& Yaw, float& Pitch);

    /** Breaks a direction vector apart into azimuth (yaw) and elevation (pitch) rotation values given in degrees, in
     * the frame of the transform. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Vector")
    static void GetAzimuthAndElevation(
        FVector InDirection, const FTransform& ReferenceFrame, float& Azimuth, float& Elevation);

    /** Finds the average of an array of vectors; zero for an empty one. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Vector Array Average"), Category = "Math|Vector")
    static FVector GetVectorArrayAverage(const TArray<FVector>& Vectors);

    /** Finds the distance of Point to the closest point on the line segment. */
    UFUNCTION(BlueprintPure, Category = "Math|Vector")
    static double GetPointDistanceToSegment(FVector Point, FVector SegmentStart, FVector SegmentEnd);

    /** Finds the distance from a point to the infinite line. */
    UFUNCTION(BlueprintPure, Category = "Math|Vector")
    static double GetPointDistanceToLine(FVector Point, FVector LineOrigin, FVector LineDirection);

    /** Finds the closest point on a line segment to a given point. */
    UFUNCTION(BlueprintPure, Category = "Math|Vector")
    static FVector FindClosestPointOnSegment(FVector Point, FVector SegmentStart, FVector SegmentEnd);

    /** Finds the closest point on an infinite line to a given point. */
    UFUNCTION(BlueprintPure, Category = "Math|Vector")
    static FVector FindClosestPointOnLine(FVector Point, FVector LineOrigin, FVector LineDirection);

    /** Determines whether the given point is in an axis-aligned box. Includes points on the box. */
    UFUNCTION(BlueprintPure, Category = "Math|Vector")
    static bool IsPointInBox(FVector Point, FVector BoxOrigin, FVector BoxExtent);

    /** Finds a rotation for an object at Start location to point at Target location. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Vector")
    static FRotator FindLookAtRotation(const FVector& Start, const FVector& Target);

    // ---------------------------------------------------------------------------------------------- Vector2D functions

    /** Makes a 2D vector {X, Y}. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build", NativeMakeFunc), Category = "Math|Vector2D")
    static FVector2D MakeVector2D(double X, double Y);

    /** Breaks a 2D vector apart into X, Y. */
    UFUNCTION(BlueprintPure, meta = (NativeBreakFunc), Category = "Math|Vector2D")
    static void BreakVector2D(FVector2D InVec, double& X, double& Y);

    /** Addition (A + B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector2d + vector2d", CompactNodeTitle = "+", Keywords = "+ add plus",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Vector2D")
    static FVector2D Add_Vector2DVector2D(FVector2D A, FVector2D B);

    /** Subtraction (A - B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector2d - vector2d", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|Vector2D")
    static FVector2D Subtract_Vector2DVector2D(FVector2D A, FVector2D B);

    /** Scales A by B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "vector2d * float", CompactNodeTitle = "*", Keywords = "* multiply"),
        Category = "Math|Vector2D")
    static FVector2D Multiply_Vector2DFloat(FVector2D A, double B);

    /** Element-wise multiplication. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector2d * vector2d", CompactNodeTitle = "*", Keywords = "* multiply",
            CommutativeAssociativeBinaryOperator = "true"),
        Category = "Math|Vector2D")
    static FVector2D Multiply_Vector2DVector2D(FVector2D A, FVector2D B);

    /** Division by a float. Division by zero gives a zero vector and a warning in the log. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "vector2d / float", CompactNodeTitle = "/", Keywords = "/ divide division"),
        Category = "Math|Vector2D")
    static FVector2D Divide_Vector2DFloat(FVector2D A, double B = 1.0);

    /** Returns the dot product of two 2D vectors. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Dot Product (2D)", CompactNodeTitle = "dot", ScriptMethod = "Dot", ScriptOperator = "|"),
        Category = "Math|Vector2D")
    static double DotProduct2D(FVector2D A, FVector2D B);

    /** Returns the cross product of two 2D vectors. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Cross Product (2D)", CompactNodeTitle = "cross", ScriptMethod = "Cross",
            ScriptOperator = "^"),
        Category = "Math|Vector2D")
    static double CrossProduct2D(FVector2D A, FVector2D B);

    /** Returns the length of a 2D vector. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Vector2D Length", ScriptMethod = "Length", Keywords = "magnitude"),
        Category = "Math|Vector2D")
    static double VSize2D(FVector2D A);

    /** Returns the squared length of a 2D vector. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Vector2D Length Squared", ScriptMethod = "LengthSquared", Keywords = "magnitude"),
        Category = "Math|Vector2D")
    static double VSize2DSquared(FVector2D A);

    /** Distance between two 2D points. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Distance (Vector2D)", ScriptMethod = "Distance", Keywords = "magnitude"),
        Category = "Math|Vector2D")
    static double Distance2D(FVector2D V1, FVector2D V2);

    /** Gets a normalized copy of the vector; zero when its squared length is below the tolerance. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Safe Normal (Vector2D)", ScriptMethod = "Normal", Keywords = "Unit Vector"),
        Category = "Math|Vector2D")
    static FVector2D Normal2D(FVector2D A, float Tolerance = 1.e-8f);

    /** Returns true if A equals B within a specified error tolerance. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Nearly Equal (Vector2D)", CompactNodeTitle = "==", ScriptMethod = "IsNearEqual",
            Keywords = "== equal"),
        Category = "Math|Vector2D")
    static bool EqualEqual_Vector2DVector2D(FVector2D A, FVector2D B, float ErrorTolerance = 1.e-4f);

    /** Tries to reach Target based on distance from Current position. A speed of 0 jumps. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "InterpTo", Keywords = "position"), Category = "Math|Vector2D")
    static FVector2D Vector2DInterpTo(FVector2D Current, FVector2D Target, float DeltaTime, float InterpSpeed);

    // ----------------------------------------------------------------------------------------------- Rotator functions

    /** Makes a rotator {Roll, Pitch, Yaw} from rotation values supplied in degrees. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build rotation rotate rotator makerotator", NativeMakeFunc),
        Category = "Math|Rotator")
    static FRotator MakeRotator(UPARAM(DisplayName = "X (Roll)") float Roll,
        UPARAM(DisplayName = "Y (Pitch)") float Pitch, UPARAM(DisplayName = "Z (Yaw)") float Yaw);

    /** Breaks apart a rotator into {Roll, Pitch, Yaw} angles in degrees. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate rotator breakrotator", NativeBreakFunc),
        Category = "Math|Rotator")
    static void BreakRotator(FRotator InRot, UPARAM(DisplayName = "X (Roll)") float& Roll,
        UPARAM(DisplayName = "Y (Pitch)") float& Pitch, UPARAM(DisplayName = "Z (Yaw)") float& Yaw);

    /** Breaks apart a rotator into its component axes. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Rotator")
    static void BreakRotIntoAxes(const FRotator& InRot, FVector& X, FVector& Y, FVector& Z);

    /** Builds a rotator given only a XAxis. The remaining axes are unspecified but will be orthonormal. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build rotation rotate rotator"), Category = "Math|Rotator")
    static FRotator MakeRotFromX(const FVector& X);

    /** Builds a rotator given only a YAxis. The remaining axes are unspecified but will be orthonormal. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build rotation rotate rotator"), Category = "Math|Rotator")
    static FRotator MakeRotFromY(const FVector& Y);

    /** Builds a rotator given only a ZAxis. The remaining axes are unspecified but will be orthonormal. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build rotation rotate rotator"), Category = "Math|Rotator")
    static FRotator MakeRotFromZ(const FVector& Z);

    /** Builds a rotator with the given X axis and Y axis. X remains fixed; Y may be changed minimally to enforce
     * orthogonality. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build rotation rotate rotator"), Category = "Math|Rotator")
    static FRotator MakeRotFromXY(const FVector& X, const FVector& Y);

    /** Builds a rotator with the given X axis and Z axis. X remains fixed; Z may be changed minimally to enforce
     * orthogonality. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build rotation rotate rotator"), Category = "Math|Rotator")
    static FRotator MakeRotFromXZ(const FVector& X, const FVector& Z);

    /** Builds a reference frame from three axes. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build rotation rotate rotator"), Category = "Math|Rotator")
    static FRotator MakeRotationFromAxes(FVector Forward, FVector Right, FVector Up);

    /** Returns true if rotator A is equal to rotator B (A == B) within a specified error tolerance; whole turns do not
     * count. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Equal (Rotator)", CompactNodeTitle = "==", ScriptMethod = "IsNearEqual",
            Keywords = "== equal"),
        Category = "Math|Rotator")
    static bool EqualEqual_RotatorRotator(FRotator A, FRotator B, float ErrorTolerance = 1.e-4f);

    /** Returns true if rotator A is not equal to rotator B (A != B) within a specified error tolerance. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Not Equal (Rotator)", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Math|Rotator")
    static bool NotEqual_RotatorRotator(FRotator A, FRotator B, float ErrorTolerance = 1.e-4f);

    /** Returns rotator representing rotator A scaled by B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Scale Rotator", CompactNodeTitle = "*", ScriptMethod = "Scale",
            Keywords = "* multiply rotate rotation"),
        Category = "Math|Rotator")
    static FRotator Multiply_RotatorFloat(FRotator A, float B);

    /** Returns rotator representing rotator A scaled by B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Scale Rotator (Integer)", CompactNodeTitle = "*",
            Keywords = "* multiply rotate rotation"),
        Category = "Math|Rotator")
    static FRotator Multiply_RotatorInt(FRotator A, int32 B);

    /** Combines 2 rotations to give you the resulting rotation of first applying A, then B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Combine Rotators", ScriptMethod = "Combine", Keywords = "rotate rotation add"),
        Category = "Math|Rotator")
    static FRotator ComposeRotators(FRotator A, FRotator B);

    /** Negates a rotator: the inverse rotation. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Invert Rotator", ScriptMethod = "Inversed", Keywords = "rotate rotation"),
        Category = "Math|Rotator")
    static FRotator NegateRotator(FRotator A);

    /** Rotates the world forward vector by the given rotation. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Rotator")
    static FVector GetForwardVector(FRotator InRot);

    /** Rotates the world right vector by the given rotation. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Rotator")
    static FVector GetRightVector(FRotator InRot);

    /** Rotates the world up vector by the given rotation. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Rotator")
    static FVector GetUpVector(FRotator InRot);

    /** Linearly interpolates between A and B based on Alpha; optionally the shorter way round. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Lerp (Rotator)", ScriptMethod = "Lerp"), Category = "Math|Rotator")
    static FRotator RLerp(FRotator A, FRotator B, float Alpha, bool bShortestPath);

    /** Eases between A and B using a specified easing function. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Ease (Rotator)", BlueprintInternalUseOnly = "true"),
        Category = "Math|Rotator")
    static FRotator REase(FRotator A, FRotator B, float Alpha, bool bShortestPath,
        TEnumAsByte<EEasingFunc::Type> EasingFunc, float BlendExp = 2, int32 Steps = 2);

    /** Normalized A-B: each angle between -180 and 180. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Delta (Rotator)", ScriptMethod = "Delta"), Category = "Math|Rotator")
    static FRotator NormalizedDeltaRotator(FRotator A, FRotator B);

    /** Creates a rotation from an axis and an angle in degrees. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "make construct build rotate rotation"), Category = "Math|Rotator")
    static FRotator RotatorFromAxisAndAngle(FVector Axis, float Angle);

    /** Tries to reach Target rotation based on Current rotation, giving a nice smooth feeling when rotating to Target
     * rotation. A speed of 0 jumps. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Rotator")
    static FRotator RInterpTo(FRotator Current, FRotator Target, float DeltaTime, float InterpSpeed);

    /** Tries to reach Target rotation at a constant rate, in degrees per second for each angle. A speed of 0 jumps. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotation rotate"), Category = "Math|Rotator")
    static FRotator RInterpTo_Constant(FRotator Current, FRotator Target, float DeltaTime, float InterpSpeed);

    /** Generates a random rotation, with optional random roll. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "rotate rotation"), Category = "Math|Rotator")
    static FRotator RandomRotator(bool bRoll = false);

    // -------------------------------------------------------------------------------------------- Quaternion functions

    /** Identity quaternion constant. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Identity (Quat)", ScriptConstant = "IDENTITY",
            ScriptConstantHost = "/Script/CoreUObject.Quat"),
        Category = "Math|Quat")
    static FQuat Quat_Identity();

    /** Returns true if quaternion A is equal to quaternion B (A == B) within a specified error tolerance; Q and -Q are
     * the same rotation. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Equal (Quat)", CompactNodeTitle = "==", ScriptMethod = "IsNearEqual",
            Keywords = "== equal"),
        Category = "Math|Quat")
    static bool EqualEqual_QuatQuat(const FQuat& A, const FQuat& B, float Tolerance = 1.e-4f);

    /** Returns true if quaternion A is not equal to quaternion B (A != B) within a specified error tolerance. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Not Equal (Quat)", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Math|Quat")
    static bool NotEqual_QuatQuat(const FQuat& A, const FQuat& B, float ErrorTolerance = 1.e-4f);

    /** Returns addition of vector B to vector A, element by element. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Add (Quat)", CompactNodeTitle = "+", ScriptMethod = "Add",
            ScriptOperator = "+;+=", Keywords = "+ add plus"),
        Category = "Math|Quat")
    static FQuat Add_QuatQuat(const FQuat& A, const FQuat& B);

    /** Returns subtraction of B from A, element by element. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Subtract (Quat)", CompactNodeTitle = "-", ScriptMethod = "Subtract",
            ScriptOperator = "-;-=", Keywords = "- subtract minus"),
        Category = "Math|Quat")
    static FQuat Subtract_QuatQuat(const FQuat& A, const FQuat& B);

    /** Gets the result of multiplying two quaternions (A * B). The order matters: (A * B) first applies B, then A. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Multiply (Quat)", CompactNodeTitle = "*", ScriptMethod = "Multiply",
            ScriptOperator = "*;*=", Keywords = "* multiply"),
        Category = "Math|Quat")
    static FQuat Multiply_QuatQuat(const FQuat& A, const FQuat& B);

    /** Checks whether this quaternion is an identity quaternion, within a tolerance. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Is Identity (Quat)", ScriptMethod = "IsIdentity"), Category = "Math|Quat")
    static bool Quat_IsIdentity(const FQuat& Q, float Tolerance = 1.e-4f);

    /** Returns true if this quaternion is normalized. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Is Normalized (Quat)", ScriptMethod = "IsNormalized", Keywords = "Unit Quaternion"),
        Category = "Math|Quat")
    static bool Quat_IsNormalized(const FQuat& Q);

    /** Determines if all the values are finite (not NaN nor Inf) in this quaternion. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Is Finite (Quat)", ScriptMethod = "IsFinite"), Category = "Math|Quat")
    static bool Quat_IsFinite(const FQuat& Q);

    /** Finds the angular distance/difference between two rotation quaternions, in radians. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Angular Distance (Quat)", ScriptMethod = "AngularDistance"),
        Category = "Math|Quat")
    static double Quat_AngularDistance(const FQuat& A, const FQuat& B);

    /** Gets the length squared of this quaternion. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Size Squared (Quat)", ScriptMethod = "SizeSquared"),
        Category = "Math|Quat")
    static double Quat_SizeSquared(const FQuat& Q);

    /** Gets the length of this quaternion. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Size (Quat)", ScriptMethod = "Size"), Category = "Math|Quat")
    static double Quat_Size(const FQuat& Q);

    /** Gets the angle of this quaternion, in radians. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Get Angle (Quat)", ScriptMethod = "GetAngle"), Category = "Math|Quat")
    static double Quat_GetAngle(const FQuat& Q);

    /** Gets the axis of rotation; forward for the identity. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Rotation Axis (Quat)", ScriptMethod = "GetRotationAxis"),
        Category = "Math|Quat")
    static FVector Quat_GetRotationAxis(const FQuat& Q);

    /** Gets the X direction after it has been rotated by this quaternion. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Get Axis X (Quat)", ScriptMethod = "GetAxisX"), Category = "Math|Quat")
    static FVector Quat_GetAxisX(const FQuat& Q);

    /** Gets the Y direction after it has been rotated by this quaternion. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Get Axis Y (Quat)", ScriptMethod = "GetAxisY"), Category = "Math|Quat")
    static FVector Quat_GetAxisY(const FQuat& Q);

    /** Gets the Z direction after it has been rotated by this quaternion. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Get Axis Z (Quat)", ScriptMethod = "GetAxisZ"), Category = "Math|Quat")
    static FVector Quat_GetAxisZ(const FQuat& Q);

    /** Gets the forward direction (X axis) after it has been rotated by this quaternion. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Vector Forward (Quat)", ScriptMethod = "VectorForward"),
        Category = "Math|Quat")
    static FVector Quat_VectorForward(const FQuat& Q);

    /** Gets the right direction (Y axis) after it has been rotated by this quaternion. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Vector Right (Quat)", ScriptMethod = "VectorRight"),
        Category = "Math|Quat")
    static FVector Quat_VectorRight(const FQuat& Q);

    /** Gets the up direction (Z axis) after it has been rotated by this quaternion. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Vector Up (Quat)", ScriptMethod = "VectorUp"), Category = "Math|Quat")
    static FVector Quat_VectorUp(const FQuat& Q);

    /** Returns an inversed copy of this quaternion. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Inversed (Quat)", ScriptMethod = "Inversed"), Category = "Math|Quat")
    static FQuat Quat_Inversed(const FQuat& Q);

    /** Gets a normalized copy of this quaternion; the identity if it is too small. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Normalized (Quat)", ScriptMethod = "Normalized"), Category = "Math|Quat")
    static FQuat Quat_Normalized(const FQuat& Q, float Tolerance = 1.e-4f);

    /** Rotates a vector by this quaternion. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Rotate Vector (Quat)", ScriptMethod = "RotateVector"),
        Category = "Math|Quat")
    static FVector Quat_RotateVector(const FQuat& Q, const FVector& V);

    /** Rotates a vector by the inverse of this quaternion. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Unrotate Vector (Quat)", ScriptMethod = "UnrotateVector"),
        Category = "Math|Quat")
    static FVector Quat_UnrotateVector(const FQuat& Q, const FVector& V);

    /** Converts a quaternion to a rotator. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To Rotator (Quat)", CompactNodeTitle = "->", ScriptMethod = "Rotator",
            Keywords = "cast convert", BlueprintAutocast),
        Category = "Math|Quat")
    static FRotator Quat_Rotator(const FQuat& Q);

    /** Converts a vector of floating-point Euler angles (roll, pitch, yaw in degrees) into a quaternion. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Make from Euler (Quat)"), Category = "Math|Quat")
    static FQuat Quat_MakeFromEuler(const FVector& Euler);

    /** Converts a quaternion into floating-point Euler angles (roll, pitch, yaw in degrees). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Euler (Quat)", ScriptMethod = "Euler"), Category = "Math|Quat")
    static FVector Quat_Euler(const FQuat& Q);

    /** Spherical interpolation between quaternions. The result is normalized. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Lerp (Quat)"), Category = "Math|Quat")
    static FQuat Quat_Slerp(const FQuat& A, const FQuat& B, double Alpha);

    // --------------------------------------------------------------------------------------------- Transform functions

    /** Makes a transform from location, rotation and scale. */
    UFUNCTION(BlueprintPure, meta = (Scale = "1,1,1", Keywords = "construct build", NativeMakeFunc),
        Category = "Math|Transform")
    static FTransform MakeTransform(FVector Location, FRotator Rotation, FVector Scale = FVector(1.f, 1.f, 1.f));

    /** Breaks apart a transform into location, rotation and scale. */
    UFUNCTION(BlueprintPure, meta = (NativeBreakFunc), Category = "Math|Transform")
    static void BreakTransform(const FTransform& InTransform, FVector& Location, FRotator& Rotation, FVector& Scale);

    /** Composes two transforms in order: A * B. Order matters when composing transforms: A * B first applies A, then B.
     */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Compose Transforms", CompactNodeTitle = "*", ScriptMethod = "Multiply",
            ScriptOperator = "*;*=", Keywords = "multiply *"),
        Category = "Math|Transform")
    static FTransform ComposeTransforms(const FTransform& A, const FTransform& B);

    /** Transforms a position by the given transform, scale counted. */
    UFUNCTION(
        BlueprintPure, meta = (ScriptMethod = "TransformLocation", Keywords = "location"), Category = "Math|Transform")
    static FVector TransformLocation(const FTransform& T, FVector Location);

    /** Transforms a direction vector by the given transform: does not change its length. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "TransformDirection"), Category = "Math|Transform")
    static FVector TransformDirection(const FTransform& T, FVector Direction);

    /** Transforms a rotator by the given transform. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "TransformRotation"), Category = "Math|Transform")
    static FRotator TransformRotation(const FTransform& T, FRotator Rotation);

    /** Transforms a position by the inverse of the given transform: from world to local space. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "InverseTransformLocation"), Category = "Math|Transform")
    static FVector InverseTransformLocation(const FTransform& T, FVector Location);

    /** Transforms a direction vector by the inverse of the given transform: does not change its length. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "InverseTransformDirection"), Category = "Math|Transform")
    static FVector InverseTransformDirection(const FTransform& T, FVector Direction);

    /** Transforms a rotator by the inverse of the given transform. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "InverseTransformRotation"), Category = "Math|Transform")
    static FRotator InverseTransformRotation(const FTransform& T, FRotator Rotation);

    /** Returns the given transform, converted to be relative to the given parent transform. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Make Relative Transform", ScriptMethod = "MakeRelative", Keywords = "convert"),
        Category = "Math|Transform")
    static FTransform MakeRelativeTransform(const FTransform& A, const FTransform& RelativeTo);

    /** Returns the inverse of the given transform. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "Inverse", Keywords = "inverse"), Category = "Math|Transform")
    static FTransform InvertTransform(const FTransform& T);

    /** Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Lerp (Transform)", ScriptMethod = "Lerp", AdvancedDisplay = "3"),
        Category = "Math|Transform")
    static FTransform TLerp(const FTransform& A, const FTransform& B, float Alpha,
        TEnumAsByte<ELerpInterpolationMode::Type> InterpMode = ELerpInterpolationMode::QuatInterp);

    /** Eases between A and B using a specified easing function. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Ease (Transform)", BlueprintInternalUseOnly = "true"),
        Category = "Math|Transform")
    static FTransform TEase(const FTransform& A, const FTransform& B, float Alpha,
        TEnumAsByte<EEasingFunc::Type> EasingFunc, float BlendExp = 2, int32 Steps = 2);

    /** Tries to reach a target transform. A speed of 0 jumps. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "InterpTo"), Category = "Math|Transform")
    static FTransform TInterpTo(
        const FTransform& Current, const FTransform& Target, float DeltaTime, float InterpSpeed);

    /** Returns true if transform A is nearly equal to B. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Nearly Equal (Transform)", ScriptMethod = "IsNearEqual", Keywords = "== equal"),
        Category = "Math|Transform")
    static bool NearlyEqual_TransformTransform(const FTransform& A, const FTransform& B,
        float LocationTolerance = 1.e-4f, float RotationTolerance = 1.e-4f, float Scale3DTolerance = 1.e-4f);

    /** Returns true if transform A is equal to transform B, within a small tolerance. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Equal Transform", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Math|Transform")
    static bool EqualEqual_TransformTransform(const FTransform& A, const FTransform& B);

    /** Computes the determinant of the transform converted to a matrix: the product of the scale. */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Determinant", ScriptMethod = "Determinant"), Category = "Math|Transform")
    static double Transform_Determinant(const FTransform& Transform);

    // --------------------------------------------------------------------------------------------------- Box functions

    /** Makes an FBox from Min and Max and sets IsValid to true. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build", NativeMakeFunc), Category = "Math|Box")
    static FBox MakeBox(FVector Min, FVector Max);

    /** Makes an FBox from Origin and Extent and sets IsValid to true. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Make Box with Origin"), Category = "Math|Box")
    static FBox MakeBoxWithOrigin(const FVector& Origin, const FVector& Extent);

    /**
     * Checks whether the given location is inside this box. Points on the border do not count, see IsPointInBox_Box.
     */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Is Vector Inside (Box)"), Category = "Math|Box")
    static bool Box_IsPointInside(const FBox& Box, const FVector& Point);

    /** Determines whether the given point is in a box. Includes points on the box. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Is Point In Box (Box)"), Category = "Math|Geometry")
    static bool IsPointInBox_Box(FVector Point, FBox Box);

    /** Checks whether bounding box A intersects bounding box B. Boxes that touch do. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Intersects (Box)"), Category = "Math|Box")
    static bool Box_Intersects(const FBox& A, const FBox& B);

    // ----------------------------------------------------------------------------------------- Linear colour functions

    /** White linear colour. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "White (Linear Color)", ScriptConstant = "WHITE",
            ScriptConstantHost = "/Script/CoreUObject.LinearColor"),
        Category = "Math|Color")
    static FLinearColor LinearColor_White();

    /** Gray linear colour. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Gray (Linear Color)", ScriptConstant = "GRAY",
            ScriptConstantHost = "/Script/CoreUObject.LinearColor"),
        Category = "Math|Color")
    static FLinearColor LinearColor_Gray();

    /** Black linear colour. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Black (Linear Color)", ScriptConstant = "BLACK",
            ScriptConstantHost = "/Script/CoreUObject.LinearColor"),
        Category = "Math|Color")
    static FLinearColor LinearColor_Black();

    /** Red linear colour. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Red (Linear Color)", ScriptConstant = "RED",
            ScriptConstantHost = "/Script/CoreUObject.LinearColor"),
        Category = "Math|Color")
    static FLinearColor LinearColor_Red();

    /** Green linear colour. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Green (Linear Color)", ScriptConstant = "GREEN",
            ScriptConstantHost = "/Script/CoreUObject.LinearColor"),
        Category = "Math|Color")
    static FLinearColor LinearColor_Green();

    /** Blue linear colour. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Blue (Linear Color)", ScriptConstant = "BLUE",
            ScriptConstantHost = "/Script/CoreUObject.LinearColor"),
        Category = "Math|Color")
    static FLinearColor LinearColor_Blue();

    /** Yellow linear colour. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Yellow (Linear Color)", ScriptConstant = "YELLOW",
            ScriptConstantHost = "/Script/CoreUObject.LinearColor"),
        Category = "Math|Color")
    static FLinearColor LinearColor_Yellow();

    /** Transparent linear colour: black with alpha 0. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Transparent (Linear Color)", ScriptConstant = "TRANSPARENT",
            ScriptConstantHost = "/Script/CoreUObject.LinearColor"),
        Category = "Math|Color")
    static FLinearColor LinearColor_Transparent();

    /** Makes a colour from individual colour components (RGB space, linear). */
    UFUNCTION(BlueprintPure, meta = (Keywords = "construct build", NativeMakeFunc), Category = "Math|Color")
    static FLinearColor MakeColor(float R, float G, float B, float A = 1.0f);

    /** Breaks apart a colour into individual RGB components (as well as alpha). */
    UFUNCTION(BlueprintPure, meta = (NativeBreakFunc), Category = "Math|Color")
    static void BreakColor(FLinearColor InColor, float& R, float& G, float& B, float& A);

    /** Makes a colour from individual colour components (HSV space; hue is [0..360], saturation and value are [0..1]).
     */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "HSV to RGB"), Category = "Math|Color")
    static FLinearColor HSVToRGB(float H, float S, float V, float A = 1.0f);

    /** Breaks apart a colour into individual HSV components (as well as alpha) (hue is [0..360], saturation and value
     * are [0..1]). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "RGB to HSV"), Category = "Math|Color")
    static void RGBToHSV(FLinearColor InColor, float& H, float& S, float& V, float& A);

    /** Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1). */
    UFUNCTION(
        BlueprintPure, meta = (DisplayName = "Lerp (Linear Color)", ScriptMethod = "Lerp"), Category = "Math|Color")
    static FLinearColor LinearColorLerp(FLinearColor A, FLinearColor B, float Alpha);

    /** Tries to reach a target colour. A speed of 0 jumps. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "InterpTo"), Category = "Math|Color")
    static FLinearColor CInterpTo(FLinearColor Current, FLinearColor Target, float DeltaTime, float InterpSpeed);

    /** Element-wise multiplication of two linear colours. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "* (LinearColor)", CompactNodeTitle = "*", ScriptMethod = "Multiply",
            ScriptOperator = "*;*="),
        Category = "Math|Color")
    static FLinearColor Multiply_LinearColorLinearColor(FLinearColor A, FLinearColor B);

    /** Element-wise multiplication of a linear colour by a float. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "* (LinearColor)", CompactNodeTitle = "*", ScriptMethod = "MultiplyFloat"),
        Category = "Math|Color")
    static FLinearColor Multiply_LinearColorFloat(FLinearColor A, float B);

    /** Element-wise addition of two linear colours. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "+ (LinearColor)", CompactNodeTitle = "+", ScriptMethod = "Add", ScriptOperator = "+;+="),
        Category = "Math|Color")
    static FLinearColor Add_LinearColorLinearColor(FLinearColor A, FLinearColor B);

    /** Element-wise subtraction of two linear colours. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "- (LinearColor)", CompactNodeTitle = "-", ScriptMethod = "Subtract",
            ScriptOperator = "-;-="),
        Category = "Math|Color")
    static FLinearColor Subtract_LinearColorLinearColor(FLinearColor A, FLinearColor B);

    /** Returns true if linear colour A is equal to linear colour B exactly. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Equal (LinearColor)", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Math|Color")
    static bool EqualEqual_LinearColorLinearColor(FLinearColor A, FLinearColor B);

    /** Computes the luminance of a linear colour. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Luminance (LinearColor)", ScriptMethod = "GetLuminance"),
        Category = "Math|Color")
    static float LinearColor_GetLuminance(FLinearColor InColor);

    /** Returns a desaturated colour, with 0 meaning no desaturation and 1 == full desaturation. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Desaturate (LinearColor)", ScriptMethod = "Desaturated"),
        Category = "Math|Color")
    static FLinearColor LinearColor_Desaturated(FLinearColor InColor, float InDesaturation);

    /** Euclidean distance between two colour points. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Distance (LinearColor)", ScriptMethod = "Distance"),
        Category = "Math|Color")
    static float LinearColor_Distance(FLinearColor C1, FLinearColor C2);

    /** Quantizes the linear colour and returns the result as an 8-bit colour. This bypasses the sRGB conversion. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Quantize to 8-bit (LinearColor)", ScriptMethod = "Quantize", Keywords = "QuantizeRound"),
        Category = "Math|Color")
    static FColor LinearColor_Quantize(FLinearColor InColor);

    // -------------------------------------------------------------------------------------------------- Random numbers

    /** Returns a uniformly distributed random number between 0 and Max - 1; 0 when Max is 0 or less. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static int32 RandomInteger(int32 Max);

    /** Returns a random integer between Min and Max (>= Min and <= Max). */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static int32 RandomIntegerInRange(int32 Min, int32 Max);

    /** Returns a random float between 0 and 1. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static double RandomFloat();

    /** Generates a random number between Min and Max. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static double RandomFloatInRange(double Min, double Max);

    /** Returns a random vector with length of 1, uniformly distributed over the sphere. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "direction"), Category = "Math|Random")
    static FVector RandomUnitVector();

    /** Returns a random point within the specified bounding box. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static FVector RandomPointInBoundingBox(const FVector Center, const FVector HalfSize);

    /** Makes a SRand-based random number generator. */
    UFUNCTION(BlueprintPure, meta = (NativeMakeFunc), Category = "Math|Random")
    static FRandomStream MakeRandomStream(int32 InitialSeed);

    /** Breaks out a random number generator into its initial seed. */
    UFUNCTION(BlueprintPure, meta = (NativeBreakFunc), Category = "Math|Random")
    static void BreakRandomStream(const FRandomStream& InRandomStream, int32& InitialSeed);

    // -------------------------------------------------------------------------------------------------- Random streams

    /** Returns a uniformly distributed random number between 0 and Max - 1. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static int32 RandomIntegerFromStream(const FRandomStream& Stream, int32 Max);

    /** Returns a random integer between Min and Max (>= Min and <= Max). */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static int32 RandomIntegerInRangeFromStream(const FRandomStream& Stream, int32 Min, int32 Max);

    /** Returns a random bool. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static bool RandomBoolFromStream(const FRandomStream& Stream);

    /** Gets a random chance with the specified weight: 0 is never, 1 is always. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static bool RandomBoolWithWeightFromStream(const FRandomStream& RandomStream, float Weight);

    /** Returns a random float between 0 and 1. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static float RandomFloatFromStream(const FRandomStream& Stream);

    /** Generates a random number between Min and Max. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static float RandomFloatInRangeFromStream(const FRandomStream& Stream, float Min, float Max);

    /** Returns a random vector with length of 1.0. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static FVector RandomUnitVectorFromStream(const FRandomStream& Stream);

    /** Creates a random rotation, with optional random roll. */
    UFUNCTION(BlueprintPure, Category = "Math|Random")
    static FRotator RandomRotatorFromStream(const FRandomStream& Stream, bool bRoll);

    /** Resets a random stream to its initial seed. */
    UFUNCTION(BlueprintCallable, Category = "Math|Random")
    static void ResetRandomStream(const FRandomStream& Stream);

    /** Creates a new random seed for a random stream. */
    UFUNCTION(BlueprintCallable, Category = "Math|Random")
    static void SeedRandomStream(UPARAM(ref) FRandomStream& Stream);

    /** Sets the seed of a random stream to a specific number. */
    UFUNCTION(BlueprintCallable, Category = "Math|Random")
    static void SetRandomStreamSeed(UPARAM(ref) FRandomStream& Stream, int32 NewSeed);

    // --------------------------------------------------------------------------------------------------------- Choices

    /** If bPickA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Select String"), Category = "Utilities|Select")
    static FString SelectString(const FString& A, const FString& B, bool bPickA);

    /** If bPickA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Select Int"), Category = "Utilities|Select")
    static int32 SelectInt(int32 A, int32 B, bool bPickA);

    /** If bPickA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Select Float"), Category = "Utilities|Select")
    static double SelectFloat(double A, double B, bool bPickA);

    /** If bPickA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Select Vector"), Category = "Utilities|Select")
    static FVector SelectVector(FVector A, FVector B, bool bPickA);

    /** If bPickA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Select Rotator"), Category = "Utilities|Select")
    static FRotator SelectRotator(FRotator A, FRotator B, bool bPickA);

    /** If bPickA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Select Color"), Category = "Utilities|Select")
    static FLinearColor SelectColor(FLinearColor A, FLinearColor B, bool bPickA);

    /** If bPickA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Select Transform"), Category = "Utilities|Select")
    static FTransform SelectTransform(const FTransform& A, const FTransform& B, bool bPickA);

    /** If bSelectA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Select")
    static UObject* SelectObject(UObject* A, UObject* B, bool bSelectA);

    /** If bSelectA is true, A is returned, otherwise B is. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Select")
    static UClass* SelectClass(UClass* A, UClass* B, bool bSelectA);

    /** Returns true if A and B are the same object. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Equal (Object)", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Utilities|Select")
    static bool EqualEqual_ObjectObject(UObject* A, UObject* B);

    /** Returns true if A and B are not the same object. */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Not Equal (Object)", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Utilities|Select")
    static bool NotEqual_ObjectObject(UObject* A, UObject* B);

    /** Returns true if A and B are the same class. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Equal (Class)", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Utilities|Select")
    static bool EqualEqual_ClassClass(UClass* A, UClass* B);

    /** Determines if a class is a child of another class. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Select")
    static bool ClassIsChildOf(TSubclassOf<UObject> TestClass, TSubclassOf<UObject> ParentClass);

    /** Returns true if A and B are equal (A == B); names compare without case. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Equal (Name)", CompactNodeTitle = "==", Keywords = "== equal"),
        Category = "Utilities|Select")
    static bool EqualEqual_NameName(FName A, FName B);

    /** Returns true if A and B are not equal (A != B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Not Equal (Name)", CompactNodeTitle = "!=", Keywords = "!= not equal"),
        Category = "Utilities|Select")
    static bool NotEqual_NameName(FName A, FName B);

    // ----------------------------------------------------------------------------------------- Date and time functions

    /** Makes a date and time; the zero one, with a warning in the log, where the parts are out of range. */
    UFUNCTION(BlueprintPure, meta = (NativeMakeFunc, AdvancedDisplay = "3"), Category = "Math|DateTime")
    static FDateTime MakeDateTime(
        int32 Year, int32 Month, int32 Day, int32 Hour = 0, int32 Minute = 0, int32 Second = 0, int32 Millisecond = 0);

    /** Breaks a date and time into its components. */
    UFUNCTION(BlueprintPure, meta = (NativeBreakFunc, AdvancedDisplay = "4"), Category = "Math|DateTime")
    static void BreakDateTime(FDateTime InDateTime, int32& Year, int32& Month, int32& Day, int32& Hour, int32& Minute,
        int32& Second, int32& Millisecond);

    /** Addition (A + B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "DateTime + Timespan", CompactNodeTitle = "+", Keywords = "+ add plus"),
        Category = "Math|DateTime")
    static FDateTime Add_DateTimeTimespan(FDateTime A, FTimespan B);

    /** Subtraction (A - B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "DateTime - Timespan", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|DateTime")
    static FDateTime Subtract_DateTimeTimespan(FDateTime A, FTimespan B);

    /** Subtraction (A - B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "DateTime - DateTime", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|DateTime")
    static FTimespan Subtract_DateTimeDateTime(FDateTime A, FDateTime B);

    /** Returns true if A == B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "DateTime == DateTime", CompactNodeTitle = "==", Keywords = "=="),
        Category = "Math|DateTime")
    static bool EqualEqual_DateTimeDateTime(FDateTime A, FDateTime B);

    /** Returns true if A != B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "DateTime != DateTime", CompactNodeTitle = "!=", Keywords = "!="),
        Category = "Math|DateTime")
    static bool NotEqual_DateTimeDateTime(FDateTime A, FDateTime B);

    /** Returns true if A > B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "DateTime > DateTime", CompactNodeTitle = ">", Keywords = ">"),
        Category = "Math|DateTime")
    static bool Greater_DateTimeDateTime(FDateTime A, FDateTime B);

    /** Returns true if A >= B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "DateTime >= DateTime", CompactNodeTitle = ">=", Keywords = ">="),
        Category = "Math|DateTime")
    static bool GreaterEqual_DateTimeDateTime(FDateTime A, FDateTime B);

    /** Returns true if A < B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "DateTime < DateTime", CompactNodeTitle = "<", Keywords = "<"),
        Category = "Math|DateTime")
    static bool Less_DateTimeDateTime(FDateTime A, FDateTime B);

    /** Returns true if A <= B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "DateTime <= DateTime", CompactNodeTitle = "<=", Keywords = "<="),
        Category = "Math|DateTime")
    static bool LessEqual_DateTimeDateTime(FDateTime A, FDateTime B);

    /** Returns the day component, 1 to 31 of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Day"), Category = "Math|DateTime")
    static int32 GetDay(FDateTime A);

    /** Returns the day of the year, 1 to 366 of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get DayOfYear"), Category = "Math|DateTime")
    static int32 GetDayOfYear(FDateTime A);

    /** Returns the hour of the day, 0 to 23 of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Hour"), Category = "Math|DateTime")
    static int32 GetHour(FDateTime A);

    /** Returns the hour of the day in 12-hour format, 1 to 12 of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Hour12"), Category = "Math|DateTime")
    static int32 GetHour12(FDateTime A);

    /** Returns the millisecond component, 0 to 999 of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Millisecond"), Category = "Math|DateTime")
    static int32 GetMillisecond(FDateTime A);

    /** Returns the minute component, 0 to 59 of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Minute"), Category = "Math|DateTime")
    static int32 GetMinute(FDateTime A);

    /** Returns the month component, 1 to 12 of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Month"), Category = "Math|DateTime")
    static int32 GetMonth(FDateTime A);

    /** Returns the second component, 0 to 59 of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Second"), Category = "Math|DateTime")
    static int32 GetSecond(FDateTime A);

    /** Returns the year component of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Year"), Category = "Math|DateTime")
    static int32 GetYear(FDateTime A);

    /** Returns the date component of A. */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static FDateTime GetDate(FDateTime A);

    /** Returns the time elapsed since midnight of A. */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static FTimespan GetTimeOfDay(FDateTime A);

    /** Returns whether given year is a leap year. */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static bool IsLeapYear(int32 Year);

    /** Returns the number of days in the given year and month; 0 with a warning for a month out of range. */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static int32 DaysInMonth(int32 Year, int32 Month);

    /** Returns the number of days in the given year. */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static int32 DaysInYear(int32 Year);

    /** Returns the local date and time on this computer. */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static FDateTime Now();

    /** Returns the local date on this computer. */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static FDateTime Today();

    /** Returns the UTC date and time on this computer. */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static FDateTime UtcNow();

    /** Returns a date and time from a unix timestamp (seconds since 1970-01-01 00:00 UTC). */
    UFUNCTION(BlueprintPure, Category = "Math|DateTime")
    static FDateTime FromUnixTimestamp(const int64 UnixTime);

    /** Returns this date and time as the number of seconds since the unix epoch. */
    UFUNCTION(BlueprintPure, meta = (ScriptMethod = "ToUnixTimestamp"), Category = "Math|DateTime")
    static int64 ToUnixTimestamp(const FDateTime& Time);

    // ---------------------------------------------------------------------------------------------- Timespan functions

    /** Makes a time span. */
    UFUNCTION(BlueprintPure, meta = (NativeMakeFunc), Category = "Math|Timespan")
    static FTimespan MakeTimespan(int32 Days, int32 Hours, int32 Minutes, int32 Seconds, int32 Milliseconds);

    /** Breaks a time span into its components. */
    UFUNCTION(BlueprintPure, meta = (NativeBreakFunc), Category = "Math|Timespan")
    static void BreakTimespan(
        FTimespan InTimespan, int32& Days, int32& Hours, int32& Minutes, int32& Seconds, int32& Milliseconds);

    /** Addition (A + B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Timespan + Timespan", CompactNodeTitle = "+", Keywords = "+ add plus"),
        Category = "Math|Timespan")
    static FTimespan Add_TimespanTimespan(FTimespan A, FTimespan B);

    /** Subtraction (A - B). */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "Timespan - Timespan", CompactNodeTitle = "-", Keywords = "- subtract minus"),
        Category = "Math|Timespan")
    static FTimespan Subtract_TimespanTimespan(FTimespan A, FTimespan B);

    /** Scalar multiplication (A * s). */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Timespan * float", CompactNodeTitle = "*", Keywords = "* multiply"),
        Category = "Math|Timespan")
    static FTimespan Multiply_TimespanFloat(FTimespan A, float Scalar);

    /** Returns true if A == B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Timespan == Timespan", CompactNodeTitle = "==", Keywords = "=="),
        Category = "Math|Timespan")
    static bool EqualEqual_TimespanTimespan(FTimespan A, FTimespan B);

    /** Returns true if A != B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Timespan != Timespan", CompactNodeTitle = "!=", Keywords = "!="),
        Category = "Math|Timespan")
    static bool NotEqual_TimespanTimespan(FTimespan A, FTimespan B);

    /** Returns true if A > B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Timespan > Timespan", CompactNodeTitle = ">", Keywords = ">"),
        Category = "Math|Timespan")
    static bool Greater_TimespanTimespan(FTimespan A, FTimespan B);

    /** Returns true if A >= B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Timespan >= Timespan", CompactNodeTitle = ">=", Keywords = ">="),
        Category = "Math|Timespan")
    static bool GreaterEqual_TimespanTimespan(FTimespan A, FTimespan B);

    /** Returns true if A < B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Timespan < Timespan", CompactNodeTitle = "<", Keywords = "<"),
        Category = "Math|Timespan")
    static bool Less_TimespanTimespan(FTimespan A, FTimespan B);

    /** Returns true if A <= B. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Timespan <= Timespan", CompactNodeTitle = "<=", Keywords = "<="),
        Category = "Math|Timespan")
    static bool LessEqual_TimespanTimespan(FTimespan A, FTimespan B);

    /** Returns the total number of days of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Total Days"), Category = "Math|Timespan")
    static double GetTotalDays(FTimespan A);

    /** Returns the total number of hours of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Total Hours"), Category = "Math|Timespan")
    static double GetTotalHours(FTimespan A);

    /** Returns the total number of milliseconds of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Total Milliseconds"), Category = "Math|Timespan")
    static double GetTotalMilliseconds(FTimespan A);

    /** Returns the total number of minutes of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Total Minutes"), Category = "Math|Timespan")
    static double GetTotalMinutes(FTimespan A);

    /** Returns the total number of seconds of A. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Total Seconds"), Category = "Math|Timespan")
    static double GetTotalSeconds(FTimespan A);

    /** Returns the days component of A. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static int32 GetDays(FTimespan A);

    /** Returns the hours component of A. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static int32 GetHours(FTimespan A);

    /** Returns the minutes component of A. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static int32 GetMinutes(FTimespan A);

    /** Returns the seconds component of A. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static int32 GetSeconds(FTimespan A);

    /** Returns the milliseconds component of A. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static int32 GetMilliseconds(FTimespan A);

    /** Returns the absolute value of A. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static FTimespan GetDuration(FTimespan A);

    /** Returns a time span that represents the specified number of days. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static FTimespan FromDays(double Days);

    /** Returns a time span that represents the specified number of hours. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static FTimespan FromHours(double Hours);

    /** Returns a time span that represents the specified number of minutes. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static FTimespan FromMinutes(double Minutes);

    /** Returns a time span that represents the specified number of seconds. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static FTimespan FromSeconds(double Seconds);

    /** Returns a time span that represents the specified number of milliseconds. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static FTimespan FromMilliseconds(double Milliseconds);

    /** Returns a zero time span value. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static FTimespan TimespanZeroValue();

    /** Returns the ratio between two time spans (A / B), handles zero values. */
    UFUNCTION(BlueprintPure, Category = "Math|Timespan")
    static float TimespanRatio(FTimespan A, FTimespan B);
};
