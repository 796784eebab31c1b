// SPDX-License-Identifier: MIT
// UKismetMathLibrary against facts of UE and of arithmetic.
#include "engine_fixture.h"

#include "Kismet/KismetMathLibrary.h"

#include <cmath>

using Math = UKismetMathLibrary;

namespace {

bool near(double a, double b, double tolerance = 1e-6) { return std::fabs(a - b) <= tolerance; }
bool near(const FVector& a, const FVector& b, double tolerance = 1e-6) {
    return near(a.X, b.X, tolerance) && near(a.Y, b.Y, tolerance) && near(a.Z, b.Z, tolerance);
}
bool near(const FRotator& a, const FRotator& b, double tolerance = 1e-4) {
    return near(a.Pitch, b.Pitch, tolerance) && near(a.Yaw, b.Yaw, tolerance) && near(a.Roll, b.Roll, tolerance);
}

} // namespace

TEST_CASE("math library: integers") {
    CHECK(Math::Add_IntInt(2, 3) == 5);
    CHECK(Math::Add_IntInt(2147483647, 1) == INT32_MIN); // wraps, as in UE
    CHECK(Math::Divide_IntInt(7, -2) == -3);
    CHECK(Math::Divide_IntInt(7, 0) == 0);
    CHECK(Math::Percent_IntInt(-7, 3) == -1);
    CHECK(Math::Percent_IntInt(7, 0) == 0);
    CHECK(Math::Divide_IntInt(INT32_MIN, -1) == INT32_MIN);
    CHECK(Math::Add_ByteByte(250, 10) == 4);
    CHECK(Math::Clamp(11, 0, 10) == 10);
    CHECK(Math::Wrap(7, 0, 5) == 2);
    CHECK(Math::Wrap(-1, 0, 5) == 4);
    CHECK(Math::Wrap(5, 0, 5) == 5);
    CHECK(Math::InRange_IntInt(10, 0, 10));
    CHECK_FALSE(Math::InRange_IntInt(10, 0, 10, true, false));
    CHECK(Math::SignOfInteger(-9) == -1);
    CHECK(Math::Multiply_Int64Int64(INT64_C(3000000000), 3) == INT64_C(9000000000));
    CHECK(Math::Not_Int(0) == -1);
}

TEST_CASE("math library: rounding") {
    CHECK(Math::Round(1.5) == 2);
    CHECK(Math::Round(-1.5) == -1); // halves go up
    CHECK(Math::FFloor(-1.2) == -2);
    CHECK(Math::FCeil(-1.2) == -1);
    CHECK(Math::FTrunc(-1.8) == -1);
    CHECK(Math::FTrunc(1e300) == 2147483647);
    CHECK(Math::FFloor64(3e10 + 0.5) == INT64_C(30000000000));
    double remainder = 0.0;
    CHECK(Math::FMod(7.5, 2.0, remainder) == 3);
    CHECK(near(remainder, 1.5));
    CHECK(Math::FMod(-7.5, 2.0, remainder) == -3);
    CHECK(near(remainder, -1.5));
    CHECK(near(Math::Fraction(-1.25), 0.75));
}

TEST_CASE("math library: floats, ranges and easing") {
    CHECK(Math::Divide_DoubleDouble(1.0, 0.0) == 0.0);
    CHECK(Math::Sqrt(-1.0) == 0.0);
    CHECK(near(Math::Lerp(10.0, 20.0, 0.25), 12.5));
    CHECK(near(Math::NormalizeToRange(20.0, 10.0, 50.0), 0.25));
    CHECK(near(Math::MapRangeClamped(5.0, 0.0, 10.0, 100.0, 200.0), 150.0));
    CHECK(near(Math::MapRangeClamped(50.0, 0.0, 10.0, 100.0, 200.0), 200.0));
    CHECK(near(Math::MapRangeUnclamped(20.0, 0.0, 10.0, 100.0, 200.0), 300.0));
    CHECK(near(Math::FInterpTo(0.0, 100.0, 0.1, 5.0), 50.0));
    CHECK(near(Math::FInterpTo(0.0, 100.0, 0.1, 0.0), 100.0)); // no speed: jump
    CHECK(near(Math::FInterpTo_Constant(0.0, 100.0, 0.5, 20.0), 10.0));
    CHECK(near(Math::Ease(0.0, 10.0, 0.5, EEasingFunc::EaseIn, 2.0), 2.5));
    CHECK(near(Math::Ease(0.0, 10.0, 0.5, EEasingFunc::EaseOut, 2.0), 7.5));
    CHECK(near(Math::Ease(0.0, 10.0, 0.25, EEasingFunc::EaseInOut, 2.0), 1.25));
    CHECK(near(Math::Ease(0.0, 10.0, 0.5, EEasingFunc::SinusoidalInOut), 5.0));
    CHECK(near(Math::Ease(0.0, 10.0, 1.0, EEasingFunc::CircularOut), 10.0));
    CHECK(near(Math::Ease(0.0, 10.0, 1.0, EEasingFunc::ExpoInOut), 10.0));
    CHECK(near(Math::DegSin(30.0), 0.5));
    CHECK(near(Math::DegAtan2(1.0, 1.0), 45.0));
    CHECK(near(Math::ClampAngle(170.0, -90.0, 90.0), 90.0));
    CHECK(near(Math::NormalizeAxis(270.0), -90.0));
    CHECK(near(Math::ClampAxis(-90.0), 270.0));
    CHECK(near(Math::FixedTurn(350.0, 20.0, 10.0), 0.0));
    int32 index = 0;
    float value = 0.0f;
    Math::MaxOfFloatArray(TArray<float>{1.0f, 5.0f, 3.0f}, index, value);
    CHECK(index == 1);
    CHECK(value == 5.0f);
    Math::MaxOfFloatArray(TArray<float>(), index, value);
    CHECK(index == -1);
}

TEST_CASE("math library: vectors, left-handed with Z up") {
    CHECK(near(Math::Cross_VectorVector(FVector(1, 0, 0), FVector(0, 1, 0)), FVector(0, 0, 1)));
    CHECK(near(Math::Dot_VectorVector(FVector(1, 2, 3), FVector(4, 5, 6)), 32.0));
    CHECK(near(Math::VSize(FVector(3, 4, 12)), 13.0));
    CHECK(near(Math::Normal(FVector(0, 0, 0)), FVector(0, 0, 0)));
    CHECK(near(Math::Divide_VectorFloat(FVector(1, 2, 3), 0.0), FVector(0, 0, 0)));
    CHECK(near(Math::RotateAngleAxis(FVector(1, 0, 0), 90.0f, FVector(0, 0, 1)), FVector(0, 1, 0)));
    CHECK(near(Math::GetReflectionVector(FVector(1, 0, -1), FVector(0, 0, 1)), FVector(1, 0, 1)));
    CHECK(near(Math::ProjectVectorOnToPlane(FVector(1, 2, 3), FVector(0, 0, 1)), FVector(1, 2, 0)));
    CHECK(
        near(Math::FindClosestPointOnSegment(FVector(5, 5, 0), FVector(0, 0, 0), FVector(3, 0, 0)), FVector(3, 0, 0)));
    CHECK(near(Math::GetPointDistanceToLine(FVector(5, 5, 0), FVector(0, 0, 0), FVector(1, 0, 0)), 5.0));
    CHECK(near(Math::VInterpTo_Constant(FVector(0, 0, 0), FVector(10, 0, 0), 0.5f, 4.0f), FVector(2, 0, 0)));
    CHECK(near(Math::GetVectorArrayAverage(TArray<FVector>{FVector(0, 0, 0), FVector(2, 4, 6)}), FVector(1, 2, 3)));
    CHECK(Math::IsPointInBox(FVector(1, 1, 1), FVector(0, 0, 0), FVector(1, 1, 1)));
    double x = 0.0, y = 0.0, z = 0.0;
    Math::BreakVector(FVector(1, 2, 3), x, y, z);
    CHECK(x == 1.0);
    CHECK(z == 3.0);
}

TEST_CASE("math library: rotations") {
    CHECK(near(
        Math::MakeRotator(1.0f, 2.0f, 3.0f), FRotator(2.0, 3.0, 1.0))); // roll, pitch, yaw in; pitch, yaw, roll inside
    CHECK(near(Math::FindLookAtRotation(FVector(0, 0, 0), FVector(1, 1, 0)), FRotator(0, 45, 0)));
    CHECK(near(Math::FindLookAtRotation(FVector(0, 0, 0), FVector(0, 0, 1)), FRotator(90, 0, 0)));
    CHECK(near(Math::GetForwardVector(FRotator(0, 90, 0)), FVector(0, 1, 0)));
    CHECK(near(Math::GetRightVector(FRotator(0, 90, 0)), FVector(-1, 0, 0)));
    CHECK(near(Math::GetForwardVector(FRotator(90, 0, 0)), FVector(0, 0, 1)));
    CHECK(near(Math::GreaterGreater_VectorRotator(FVector(1, 0, 0), FRotator(0, 90, 0)), FVector(0, 1, 0)));
    CHECK(near(Math::LessLess_VectorRotator(FVector(0, 1, 0), FRotator(0, 90, 0)), FVector(1, 0, 0)));
    CHECK(near(Math::ComposeRotators(FRotator(0, 30, 0), FRotator(0, 60, 0)), FRotator(0, 90, 0)));
    CHECK(
        near(Math::ComposeRotators(FRotator(90, 0, 0), FRotator(0, 90, 0)).Quaternion().RotateVector(FVector(0, 1, 0)),
            FVector(-1, 0, 0)));
    CHECK(near(Math::NormalizedDeltaRotator(FRotator(0, 10, 0), FRotator(0, 350, 0)), FRotator(0, 20, 0)));
    CHECK(near(Math::RLerp(FRotator(0, 350, 0), FRotator(0, 10, 0), 0.5f, true), FRotator(0, 0, 0)));
    CHECK(near(Math::RLerp(FRotator(0, 350, 0), FRotator(0, 10, 0), 0.5f, false), FRotator(0, 180, 0)));
    CHECK(near(Math::RInterpTo_Constant(FRotator(0, 170, 0), FRotator(0, -170, 0), 1.0f, 5.0f), FRotator(0, 175, 0)));
    CHECK(near(Math::MakeRotFromXY(FVector(0, 1, 0), FVector(-1, 0, 0)), FRotator(0, 90, 0)));
    CHECK(near(Math::RotatorFromAxisAndAngle(FVector(0, 0, 1), 30.0f), FRotator(0, 30, 0)));
    CHECK(near(Math::Quat_AngularDistance(Math::Quat_Identity(), FRotator(0, 90, 0).Quaternion()), UE_DOUBLE_PI / 2.0));
    CHECK(near(
        Math::Quat_Rotator(Math::Multiply_QuatQuat(FRotator(0, 60, 0).Quaternion(), FRotator(0, 30, 0).Quaternion())),
        FRotator(0, 90, 0)));
    FVector x, y, z;
    Math::BreakRotIntoAxes(FRotator(0, 90, 0), x, y, z);
    CHECK(near(x, FVector(0, 1, 0)));
    CHECK(near(y, FVector(-1, 0, 0)));
    CHECK(near(z, FVector(0, 0, 1)));
}

TEST_CASE("math library: transforms") {
    const FTransform parent = Math::MakeTransform(FVector(100, 0, 0), FRotator(0, 90, 0), FVector(2, 2, 2));
    CHECK(near(Math::TransformLocation(parent, FVector(10, 0, 0)), FVector(100, 20, 0)));
    CHECK(near(Math::TransformDirection(parent, FVector(1, 0, 0)), FVector(0, 1, 0)));
    CHECK(near(Math::InverseTransformLocation(parent, FVector(100, 20, 0)), FVector(10, 0, 0)));
    const FTransform child = Math::MakeTransform(FVector(10, 0, 0), FRotator(0, 0, 0));
    const FTransform world = Math::ComposeTransforms(child, parent); // first the child, then the parent
    CHECK(near(world.GetLocation(), FVector(100, 20, 0)));
    CHECK(near(world.GetScale3D(), FVector(2, 2, 2)));
    CHECK(Math::NearlyEqual_TransformTransform(Math::MakeRelativeTransform(world, parent), child));
    CHECK(near(Math::ComposeTransforms(parent, Math::InvertTransform(parent)).GetLocation(), FVector(0, 0, 0)));
    const FTransform half = Math::TLerp(FTransform(FRotator(0, 0, 0)), parent, 0.5f);
    CHECK(near(half.GetLocation(), FVector(50, 0, 0)));
    CHECK(near(half.Rotator(), FRotator(0, 45, 0)));
    CHECK(near(half.GetScale3D(), FVector(1.5, 1.5, 1.5)));
    // The dual quaternion blend follows a screw; at the ends it is the ends.
    const FTransform end =
        Math::TLerp(FTransform(FRotator(0, 0, 0)), parent, 1.0f, ELerpInterpolationMode::DualQuatInterp);
    CHECK(near(end.GetLocation(), FVector(100, 0, 0)));
    CHECK(near(end.Rotator(), FRotator(0, 90, 0)));
}

TEST_CASE("math library: boxes") {
    const FBox box = Math::MakeBoxWithOrigin(FVector(10, 0, 0), FVector(1, 2, 3));
    CHECK(box == Math::MakeBox(FVector(9, -2, -3), FVector(11, 2, 3)));
    CHECK(Math::Box_IsPointInside(box, FVector(10, 0, 0)));
    CHECK_FALSE(Math::Box_IsPointInside(box, FVector(11, 0, 0)));
    CHECK(Math::IsPointInBox_Box(FVector(11, 0, 0), box));
    CHECK(Math::Box_Intersects(box, Math::MakeBox(FVector(11, 2, 3), FVector(20, 20, 20))));
    CHECK_FALSE(Math::Box_Intersects(box, Math::MakeBox(FVector(12, 2, 3), FVector(20, 20, 20))));
}

TEST_CASE("math library: colours, dates, streams") {
    CHECK(near(Math::HSVToRGB(120.0f, 1.0f, 1.0f).G, 1.0));
    float h = 0, s = 0, v = 0, a = 0;
    Math::RGBToHSV(FLinearColor(0.0f, 0.0f, 1.0f, 0.5f), h, s, v, a);
    CHECK(near(h, 240.0));
    CHECK(near(a, 0.5));
    CHECK(Math::Conv_LinearColorToColor(FLinearColor(0.5f, 0.5f, 0.5f, 1.0f)).R == 188); // sRGB of 0.5
    CHECK(Math::Conv_LinearColorToColor(FLinearColor(1.0f, 0.0f, 0.0f, 1.0f), false).R == 255);

    const FDateTime date = Math::MakeDateTime(2024, 2, 29, 12, 30);
    CHECK(Math::GetDayOfYear(date) == 60);
    CHECK(Math::ToUnixTimestamp(date) == INT64_C(1709209800));
    CHECK(Math::FromUnixTimestamp(INT64_C(1709209800)) == date);
    CHECK(Math::DaysInMonth(2023, 2) == 28);
    CHECK(Math::DaysInMonth(2023, 13) == 0);
    CHECK(near(Math::GetTotalSeconds(Math::Subtract_DateTimeDateTime(date, Math::MakeDateTime(2024, 2, 29))), 45000.0));
    CHECK(near(Math::GetTotalHours(Math::MakeTimespan(1, 2, 30, 0, 0)), 26.5));

    FRandomStream one = Math::MakeRandomStream(42);
    FRandomStream two = Math::MakeRandomStream(42);
    for (int i = 0; i < 100; ++i) {
        const int32 number = Math::RandomIntegerInRangeFromStream(one, -3, 3);
        CHECK(number >= -3);
        CHECK(number <= 3);
        CHECK(number == Math::RandomIntegerInRangeFromStream(two, -3, 3));
    }
    Math::ResetRandomStream(one);
    const float first = Math::RandomFloatFromStream(one);
    Math::ResetRandomStream(one);
    CHECK(first == Math::RandomFloatFromStream(one));
    CHECK(near(Math::VSize(Math::RandomUnitVectorFromStream(one)), 1.0, 1e-4));
    CHECK(Math::RandomInteger(0) == 0);
    CHECK(Math::ClassIsChildOf(AActor::StaticClass(), UObject::StaticClass()));
    CHECK(Math::EqualEqual_NameName(FName(TEXT("Chair")), FName(TEXT("chair"))));
}

TEST_CASE("math library: through reflection, with the names and metadata of Epic's pages") {
    UFunction* add = Math::StaticClass()->FindFunctionByName(FName(TEXT("add_vectorvector"))); // without case
    REQUIRE(add);
    CHECK(add->HasAllFunctionFlags(FUNC_Static | FUNC_BlueprintPure | FUNC_Native));
    CHECK(add->GetMetaData(TEXT("CompactNodeTitle")) == TEXT("+"));
    CHECK(Math::StaticClass()->GetMetaData(TEXT("ScriptName")) == TEXT("MathLibrary"));
    struct {
        FVector A = FVector(1, 2, 3);
        FVector B = FVector(10, 20, 30);
        FVector ReturnValue = FVector(0, 0, 0);
    } parameters;
    REQUIRE(add->ParmsSize == sizeof(parameters));
    GetMutableDefault<UKismetMathLibrary>()->ProcessEvent(add, &parameters);
    CHECK(parameters.ReturnValue == FVector(11, 22, 33));

    // An out-parameter by reference, and a default that metadata tells.
    UFunction* divide = Math::StaticClass()->FindFunctionByName(FName(TEXT("FMod")));
    REQUIRE(divide);
    struct {
        double Dividend = 7.5;
        double Divisor = 2.0;
        double Remainder = 0.0;
        int32 ReturnValue = 0;
    } division;
    GetMutableDefault<UKismetMathLibrary>()->ProcessEvent(divide, &division);
    CHECK(division.ReturnValue == 3);
    CHECK(division.Remainder == 1.5);
    UFunction* plus_one = Math::StaticClass()->FindFunctionByName(FName(TEXT("Add_IntInt")));
    REQUIRE(plus_one);
    CHECK(plus_one->GetMetaData(TEXT("CPP_Default_B")) == TEXT("1"));
}
