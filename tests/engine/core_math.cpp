// SPDX-License-Identifier: MIT
// The math types against known facts of UE: left-handed, Z up, degrees, row vectors, scale then rotate then translate.
#include "core_test.h"

using namespace core_test;

TEST_CASE("Core: rotators turn as UE's do") {
    const FVector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    CHECK(near(FRotator(0, 90, 0).RotateVector(x), y));
    CHECK(near(FRotator(0, 90, 0).RotateVector(y), -x));
    CHECK_MESSAGE(near(FRotator(90, 0, 0).RotateVector(x), z), "positive pitch looks up");
    CHECK_MESSAGE(near(FRotator(0, 0, 90).RotateVector(y), -z), "positive roll lowers the right side");
    CHECK(near(FRotator(0, 0, 90).RotateVector(z), y));
    CHECK(near(FRotator(0, 90, 0).UnrotateVector(y), x));
    CHECK(near(FRotator(30, 40, 0).Vector(), FRotator(30, 40, 0).RotateVector(x)));
    CHECK_MESSAGE((FVector(1, 0, 0) ^ FVector(0, 1, 0)) == z, "the cross product of X and Y is Z");
    // Roll, then pitch, then yaw.
    const FQuat separate =
        FRotator(0, 30, 0).Quaternion() * FRotator(20, 0, 0).Quaternion() * FRotator(0, 0, 10).Quaternion();
    CHECK(separate.Equals(FRotator(20, 30, 10).Quaternion(), 1e-12));
}

TEST_CASE("Core: rotator, quaternion and matrix say the same") {
    FRandomStream random(7);
    for (int i = 0; i < 500; ++i) {
        const FRotator r(
            random.FRandRange(-89.0, 89.0), random.FRandRange(-180.0, 180.0), random.FRandRange(-180.0, 180.0));
        const FQuat q = r.Quaternion();
        const FVector v = random.GetUnitVector();
        CHECK(near(q.Rotator(), r));
        CHECK(near(FRotationMatrix(r).Rotator(), r));
        CHECK(near(FVector(FRotationMatrix(r).TransformVector(v)), q.RotateVector(v), 1e-12));
        CHECK(FQuat(FRotationMatrix(r)).Equals(q, 1e-9));
        CHECK(q.ToMatrix().Equals(FRotationMatrix(r), 1e-12));
        CHECK(near(q.UnrotateVector(q.RotateVector(v)), v, 1e-12));
        CHECK(near(r.GetInverse().RotateVector(r.RotateVector(v)), v, 1e-9));
        CHECK(near(FRotationMatrix::MakeFromX(v).GetScaledAxis(EAxis::X), v, 1e-12));
        CHECK(near(v.Rotation().Vector(), v, 1e-12));
    }
    // At the poles one of yaw and roll is free; the orientation is kept.
    for (const double pitch : {90.0, -90.0}) {
        const FRotator r(pitch, 35, 0);
        CHECK(r.Quaternion().Rotator().Quaternion().Equals(r.Quaternion(), 1e-6));
        CHECK(near(r.Quaternion().Rotator().Pitch, pitch, 1e-6));
    }
}

TEST_CASE("Core: known rotation matrix") {
    const FMatrix m = FRotationMatrix(FRotator(0, 90, 0));
    CHECK(near(m.GetScaledAxis(EAxis::X), FVector(0, 1, 0)));
    CHECK(near(m.GetScaledAxis(EAxis::Y), FVector(-1, 0, 0)));
    const FMatrix t = FRotationTranslationMatrix(FRotator(0, 90, 0), FVector(10, 0, 0));
    CHECK(near(FVector(t.TransformPosition(FVector(1, 0, 0))), FVector(10, 1, 0)));
    CHECK(near(t.GetOrigin(), FVector(10, 0, 0)));
    CHECK(near(t.InverseTransformPosition(FVector(10, 1, 0)), FVector(1, 0, 0)));
    // A * B: first A.
    const FMatrix scale_then_move = FScaleMatrix(2.0) * FTranslationMatrix(FVector(1, 0, 0));
    CHECK(near(FVector(scale_then_move.TransformPosition(FVector(1, 1, 1))), FVector(3, 2, 2)));
    CHECK((scale_then_move * scale_then_move.Inverse()).Equals(FMatrix::Identity, 1e-12));
    CHECK(near(scale_then_move.Determinant(), 8.0));
}

TEST_CASE("Core: rotators normalise") {
    CHECK(FRotator::NormalizeAxis(270.0) == -90.0);
    CHECK(FRotator::NormalizeAxis(-180.0) == 180.0);
    CHECK(FRotator::NormalizeAxis(180.0) == 180.0);
    CHECK(FRotator::ClampAxis(-90.0) == 270.0);
    CHECK(FRotator(10, 350, 0).Equals(FRotator(10, -10, 0)));
    CHECK(FMath::UnwindDegrees(540.0) == 180.0);
    CHECK(FMath::FindDeltaAngleDegrees(350.0, 10.0) == 20.0);
    CHECK(near(FMath::RInterpTo(FRotator(0, 170, 0), FRotator(0, -170, 0), 0.5f, 1.0f), FRotator(0, 180, 0), 1e-6));
    CHECK(text(FRotator(1, 2, 3).ToString()) == "P=1.000000 Y=2.000000 R=3.000000");
    FRotator parsed;
    CHECK(parsed.InitFromString(TEXT("P=1.5 Y=-2 R=3")));
    CHECK(parsed == FRotator(1.5, -2, 3));
}

TEST_CASE("Core: transforms scale, rotate, translate, and compose from left to right") {
    const FTransform a(FRotator(0, 90, 0), FVector(10, 0, 0), FVector(2, 2, 2));
    CHECK(near(a.TransformPosition(FVector(1, 0, 0)), FVector(10, 2, 0)));
    CHECK(near(a.InverseTransformPosition(FVector(10, 2, 0)), FVector(1, 0, 0)));
    CHECK(near(a.TransformVector(FVector(1, 0, 0)), FVector(0, 2, 0)));
    CHECK(near(a.TransformVectorNoScale(FVector(1, 0, 0)), FVector(0, 1, 0)));
    const FTransform b(FRotator(0, 0, 0), FVector(0, 0, 5), FVector(3, 3, 3));
    const FVector p(1, 2, 3);
    CHECK(near((a * b).TransformPosition(p), b.TransformPosition(a.TransformPosition(p)), 1e-12));
    CHECK((a * b).ToMatrixWithScale().Equals(a.ToMatrixWithScale() * b.ToMatrixWithScale(), 1e-9));
    // A child's world transform is Relative * Parent.
    const FTransform parent(FRotator(0, 90, 0), FVector(100, 0, 0));
    const FTransform relative(FRotator::ZeroRotator, FVector(10, 0, 0));
    const FTransform world = relative * parent;
    CHECK(near(world.GetLocation(), FVector(100, 10, 0)));
    CHECK(world.GetRelativeTransform(parent).Equals(relative, 1e-9));
    CHECK((relative * relative.GetRelativeTransformReverse(world)).Equals(world, 1e-9));
    CHECK((a * a.Inverse()).Equals(FTransform::Identity, 1e-9));
    CHECK(FTransform(a.ToMatrixWithScale()).Equals(a, 1e-9));
}

TEST_CASE("Core: mirrored transforms") {
    const FTransform mirror(FRotator(0, 30, 0), FVector(1, 2, 3), FVector(-1, 1, 1));
    const FTransform turn(FRotator(10, 20, 30), FVector(4, 5, 6), FVector(2, 2, 2));
    const FVector p(7, 8, 9);
    CHECK(near((mirror * turn).TransformPosition(p), turn.TransformPosition(mirror.TransformPosition(p)), 1e-9));
    CHECK(near((turn * mirror).TransformPosition(p), mirror.TransformPosition(turn.TransformPosition(p)), 1e-9));
    const FTransform relative = mirror.GetRelativeTransform(turn);
    CHECK((relative * turn).Equals(mirror, 1e-9));
}

TEST_CASE("Core: quaternions") {
    const FQuat q(FVector(0, 0, 1), UE_DOUBLE_HALF_PI);
    CHECK(near(q.RotateVector(FVector(1, 0, 0)), FVector(0, 1, 0), 1e-7));
    const FQuat pitch = FRotator(90, 0, 0).Quaternion();
    CHECK_MESSAGE(
        near((q * pitch).RotateVector(FVector(1, 0, 0)), q.RotateVector(pitch.RotateVector(FVector(1, 0, 0)))),
        "A * B turns by B first");
    CHECK(near(FQuat::Slerp(FQuat::Identity, q, 0.5).Rotator(), FRotator(0, 45, 0)));
    CHECK(near(FQuat::FindBetweenVectors(FVector(1, 0, 0), FVector(0, 5, 0)).RotateVector(FVector(1, 0, 0)),
        FVector(0, 1, 0)));
    const FQuat half = FQuat::FindBetweenVectors(FVector(1, 0, 0), FVector(-1, 0, 0));
    CHECK(near(half.RotateVector(FVector(1, 0, 0)), FVector(-1, 0, 0)));
    CHECK(near(FQuat::Identity.AngularDistance(q), UE_DOUBLE_HALF_PI, 1e-7));
    CHECK(q.Equals(-q));
}

TEST_CASE("Core: vectors") {
    const FVector v(3, 4, 12);
    CHECK(v.Size() == 13.0);
    CHECK(v.Size2D() == 5.0);
    CHECK(near(v.GetSafeNormal().Size(), 1.0));
    CHECK(FVector::ZeroVector.GetSafeNormal().IsZero());
    CHECK((v | FVector(1, 1, 1)) == 19.0);
    CHECK(FVector::Dist(v, FVector(3, 4, 0)) == 12.0);
    CHECK(near(FVector(1, 0, 0).RotateAngleAxis(90, FVector::UpVector), FVector(0, 1, 0), 1e-7));
    CHECK(near(FVector::VectorPlaneProject(v, FVector::UpVector), FVector(3, 4, 0)));
    CHECK(v.GetClampedToMaxSize(6.5).Equals(v * 0.5));
    CHECK(text(v.ToString()) == "X=3.000 Y=4.000 Z=12.000");
    FVector parsed;
    CHECK(parsed.InitFromString(TEXT("X=1 Y=-2.5 Z=3")));
    CHECK(parsed == FVector(1, -2.5, 3));
    CHECK(!parsed.InitFromString(TEXT("nonsense")));
    CHECK(FVector(FVector3f(1.5f, 2, 3)) == FVector(1.5, 2, 3));
    CHECK(near(FVector(1, 0, 0).MirrorByVector(FVector(1, 0, 0)), FVector(-1, 0, 0)));
    CHECK(FVector2D(3, 4).Size() == 5.0);
}

TEST_CASE("Core: boxes, spheres, planes") {
    FBox box(ForceInit);
    CHECK(!box.IsValid);
    box += FVector(-1, -1, -1);
    box += FVector(1, 3, 1);
    CHECK(box.GetCenter() == FVector(0, 1, 0));
    CHECK(box.GetExtent() == FVector(1, 2, 1));
    CHECK(box.IsInside(FVector(0, 0, 0)));
    CHECK(!box.IsInside(FVector(1, 0, 0)));
    CHECK(box.Intersect(FBox(FVector(1, 1, 1), FVector(2, 2, 2))));
    const FBox turned = box.TransformBy(FTransform(FRotator(0, 90, 0)));
    CHECK(near(turned.Max, FVector(1, 1, 1)));
    CHECK(near(turned.Min, FVector(-3, -1, -1)));
    const FBoxSphereBounds bounds(box);
    CHECK(bounds.SphereRadius == FVector(1, 2, 1).Size());
    CHECK((bounds + bounds).BoxExtent == bounds.BoxExtent);
    const FPlane plane(FVector(0, 0, 5), FVector(0, 0, 1));
    CHECK(plane.PlaneDot(FVector(9, 9, 7)) == 2.0);
    CHECK(near(FMath::LinePlaneIntersection(FVector(0, 0, 0), FVector(0, 0, 1), plane), FVector(0, 0, 5)));
    CHECK(near(FMath::ClosestPointOnSegment(FVector(5, 5, 0), FVector(0, 0, 0), FVector(1, 0, 0)), FVector(1, 0, 0)));
    CHECK(FMath::LineBoxIntersection(box, FVector(-5, 0, 0), FVector(5, 0, 0), FVector(10, 0, 0)));
    CHECK(!FMath::LineBoxIntersection(box, FVector(-5, 9, 0), FVector(5, 9, 0), FVector(10, 0, 0)));
}

TEST_CASE("Core: scalar functions") {
    CHECK(FMath::Clamp(5, 0, 3) == 3);
    CHECK(FMath::Lerp(0.0, 10.0, 0.25) == 2.5);
    CHECK(FMath::RoundToInt(2.5) == 3);
    CHECK(FMath::RoundToInt(-2.5) == -2);
    CHECK(FMath::FloorToInt(-1.5) == -2);
    CHECK(FMath::CeilToInt(-1.5) == -1);
    CHECK(FMath::TruncToInt(-1.5) == -1);
    CHECK(FMath::Max3(1, 3, 2) == 3);
    CHECK(FMath::Fmod(5.5, 2.0) == 1.5);
    CHECK(FMath::DivideAndRoundUp(7, 2) == 4);
    CHECK(FMath::IsNearlyEqual(1.0, 1.0 + 1e-9));
    CHECK(FMath::Sign(-3.0) == -1.0);
    CHECK(FMath::RoundUpToPowerOfTwo(33) == 64);
    CHECK(FMath::FloorLog2(33) == 5);
    CHECK(FMath::FInterpTo(0.0, 10.0, 0.1, 0.0) == 10.0);
    CHECK(near(FMath::FInterpTo(0.0, 10.0, 0.1, 5.0), 5.0));
    CHECK(near(FMath::FInterpConstantTo(0.0, 10.0, 0.1, 5.0), 0.5));
    CHECK(near(FMath::VInterpConstantTo(FVector(0, 0, 0), FVector(10, 0, 0), 1.0f, 3.0f), FVector(3, 0, 0)));
    CHECK(near(FMath::GetMappedRangeValueClamped(FVector2D(0, 10), FVector2D(100, 200), 5), 150.0));
    CHECK(near(FMath::RadiansToDegrees(UE_DOUBLE_PI), 180.0));
    CHECK(FMath::Abs(-3) == 3);
    CHECK(FMath::SmoothStep(0.0, 1.0, 0.5) == 0.5);
}

TEST_CASE("Core: random streams repeat") {
    FRandomStream a(42), b(42);
    for (int i = 0; i < 100; ++i) {
        const float value = a.GetFraction();
        CHECK(value == b.GetFraction());
        CHECK(value >= 0.f);
        CHECK(value < 1.f);
        const int32 in_range = a.RandRange(3, 5);
        CHECK(in_range == b.RandRange(3, 5));
        CHECK(in_range >= 3);
        CHECK(in_range <= 5);
    }
    FMath::RandInit(5);
    const float first = FMath::FRand();
    FMath::RandInit(5);
    CHECK(first == FMath::FRand());
}

TEST_CASE("Core: colours") {
    CHECK(FLinearColor(FColor(255, 0, 128)).R == 1.0f);
    CHECK(near(FLinearColor(FColor(188, 188, 188)).G, 0.5, 0.005));
    CHECK(FLinearColor(0.5f, 0.5f, 0.5f).ToFColor(true) == FColor(188, 188, 188, 255));
    CHECK(FLinearColor(0.5f, 0.5f, 0.5f).ToFColor(false).R == 128);
    for (int i = 0; i < 256; ++i) {
        const FColor c(static_cast<uint8>(i), static_cast<uint8>(255 - i), 7, static_cast<uint8>(i));
        CHECK(FLinearColor(c).ToFColor(true) == c);
    }
    const FLinearColor hsv = FLinearColor(0, 1, 0).LinearRGBToHSV();
    CHECK(near(hsv.R, 120.0, 1e-4));
    CHECK(hsv.HSVToLinearRGB().Equals(FLinearColor(0, 1, 0)));
    CHECK(FColor::FromHex(TEXT("#FF8000")) == FColor(255, 128, 0));
    CHECK(text(FColor(255, 128, 0, 64).ToHex()) == "FF800040");
    CHECK(text(FLinearColor(1, 0.5f, 0).ToString()) == "(R=1.000000,G=0.500000,B=0.000000,A=1.000000)");
}
