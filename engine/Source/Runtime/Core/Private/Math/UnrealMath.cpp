// SPDX-License-Identifier: MIT
// FMath: randomness, interpolation and geometry that is not inline. Mirrors Epic's API page FMath.
#include "CoreMinimal.h"

FVector FMath::VRand() {
    // Uniform on the sphere: a point in the cube that lies in the ball, but not too near its centre.
    for (;;) {
        const FVector Point(FRand() * 2.0 - 1.0, FRand() * 2.0 - 1.0, FRand() * 2.0 - 1.0);
        const double SizeSquared = Point.SizeSquared();
        if (SizeSquared <= 1.0 && SizeSquared >= UE_KINDA_SMALL_NUMBER) {
            return Point * (1.0 / Sqrt(SizeSquared));
        }
    }
}

FVector FMath::VRandCone(const FVector& Dir, float ConeHalfAngleRad) {
    const FVector Direction = Dir.GetSafeNormal();
    if (ConeHalfAngleRad <= 0.0f) {
        return Direction;
    }
    // Uniform on the cap: the height is uniform (Archimedes).
    const double Height =
        1.0 - FRand() * (1.0 - Cos(static_cast<double>(Min(ConeHalfAngleRad, static_cast<float>(UE_PI)))));
    const double Radius = Sqrt(Max(0.0, 1.0 - Height * Height));
    const double Angle = FRand() * 2.0 * UE_DOUBLE_PI;
    FVector AxisX, AxisY;
    Direction.FindBestAxisVectors(AxisX, AxisY);
    return (Direction * Height + AxisX * (Radius * Cos(Angle)) + AxisY * (Radius * Sin(Angle))).GetSafeNormal();
}

FVector2D FMath::RandPointInCircle(float CircleRadius) {
    const double Radius = CircleRadius * Sqrt(static_cast<double>(FRand()));
    const double Angle = FRand() * 2.0 * UE_DOUBLE_PI;
    return FVector2D(Radius * Cos(Angle), Radius * Sin(Angle));
}

FVector FMath::RandPointInBox(const FBox& Box) {
    return FVector(
        FRandRange(Box.Min.X, Box.Max.X), FRandRange(Box.Min.Y, Box.Max.Y), FRandRange(Box.Min.Z, Box.Max.Z));
}

double FMath::ClampAngle(double AngleDegrees, double MinAngleDegrees, double MaxAngleDegrees) {
    // Relative to the middle of the allowed arc.
    const double MaxDelta = FRotator::ClampAxis(MaxAngleDegrees - MinAngleDegrees) * 0.5;
    const double RangeCenter = FRotator::ClampAxis(MinAngleDegrees + MaxDelta);
    const double DeltaFromCenter = FRotator::NormalizeAxis(AngleDegrees - RangeCenter);
    if (DeltaFromCenter > MaxDelta) {
        return FRotator::NormalizeAxis(RangeCenter + MaxDelta);
    }
    if (DeltaFromCenter < -MaxDelta) {
        return FRotator::NormalizeAxis(RangeCenter - MaxDelta);
    }
    return FRotator::NormalizeAxis(AngleDegrees);
}
float FMath::ClampAngle(float AngleDegrees, float MinAngleDegrees, float MaxAngleDegrees) {
    return static_cast<float>(ClampAngle(
        static_cast<double>(AngleDegrees), static_cast<double>(MinAngleDegrees), static_cast<double>(MaxAngleDegrees)));
}

double FMath::GetRangePct(const FVector2D& Range, double Value) {
    return Range.X != Range.Y ? (Value - Range.X) / (Range.Y - Range.X) : (Value >= Range.Y ? 1.0 : 0.0);
}
double FMath::GetRangeValue(const FVector2D& Range, double Pct) { return Range.X + (Range.Y - Range.X) * Pct; }
double FMath::GetMappedRangeValueClamped(const FVector2D& InputRange, const FVector2D& OutputRange, double Value) {
    return GetRangeValue(OutputRange, Clamp(GetRangePct(InputRange, Value), 0.0, 1.0));
}
double FMath::GetMappedRangeValueUnclamped(const FVector2D& InputRange, const FVector2D& OutputRange, double Value) {
    return GetRangeValue(OutputRange, GetRangePct(InputRange, Value));
}

// Interpolation
// -----------------------------------------------------------------------------------------------------------------

namespace {

/** A share of the way that depends on the distance, or all of it without speed or near the end. */
template <typename VectorType>
VectorType InterpVector(const VectorType& Current, const VectorType& Target, float DeltaTime, float InterpSpeed) {
    const VectorType Way = Target - Current;
    if (InterpSpeed <= 0.0f || Way.SizeSquared() < UE_KINDA_SMALL_NUMBER) {
        return Target;
    }
    return Current +
           Way * FMath::Clamp<double>(static_cast<double>(DeltaTime) * static_cast<double>(InterpSpeed), 0.0, 1.0);
}

/** A step of InterpSpeed per second. */
template <typename VectorType>
VectorType InterpVectorConstant(
    const VectorType& Current, const VectorType& Target, float DeltaTime, float InterpSpeed) {
    const VectorType Way = Target - Current;
    const double Distance = Way.Size();
    const double Step = static_cast<double>(InterpSpeed) * static_cast<double>(DeltaTime);
    if (Distance <= Step || Distance < UE_KINDA_SMALL_NUMBER) {
        return Target;
    }
    return Step > 0.0 ? Current + Way * (Step / Distance) : Current;
}

} // namespace

FVector FMath::VInterpTo(const FVector& Current, const FVector& Target, float DeltaTime, float InterpSpeed) {
    return InterpVector(Current, Target, DeltaTime, InterpSpeed);
}
FVector FMath::VInterpConstantTo(const FVector& Current, const FVector& Target, float DeltaTime, float InterpSpeed) {
    return InterpVectorConstant(Current, Target, DeltaTime, InterpSpeed);
}
FVector2D FMath::Vector2DInterpTo(
    const FVector2D& Current, const FVector2D& Target, float DeltaTime, float InterpSpeed) {
    return InterpVector(Current, Target, DeltaTime, InterpSpeed);
}
FVector2D FMath::Vector2DInterpConstantTo(
    const FVector2D& Current, const FVector2D& Target, float DeltaTime, float InterpSpeed) {
    return InterpVectorConstant(Current, Target, DeltaTime, InterpSpeed);
}

FVector FMath::VInterpNormalRotationTo(
    const FVector& Current, const FVector& Target, float DeltaTime, float RotationSpeedDegrees) {
    const FQuat Difference = FQuat::FindBetween(Current, Target);
    FVector Axis;
    double Angle = 0.0;
    Difference.ToAxisAndAngle(Axis, Angle);
    const double Step = DegreesToRadians(static_cast<double>(RotationSpeedDegrees)) * static_cast<double>(DeltaTime);
    return Abs(Angle) > Step ? FQuat(Axis, Angle > 0.0 ? Step : -Step).RotateVector(Current) : Target;
}

FRotator FMath::RInterpTo(const FRotator& Current, const FRotator& Target, float DeltaTime, float InterpSpeed) {
    if (DeltaTime == 0.0f || Current == Target) {
        return Current;
    }
    const FRotator Delta = (Target - Current).GetNormalized();
    if (InterpSpeed <= 0.0f || Delta.IsNearlyZero()) {
        return Target;
    }
    const double Share = Clamp(static_cast<double>(InterpSpeed) * static_cast<double>(DeltaTime), 0.0, 1.0);
    return (Current + Delta * Share).GetNormalized();
}

FRotator FMath::RInterpConstantTo(const FRotator& Current, const FRotator& Target, float DeltaTime, float InterpSpeed) {
    if (DeltaTime == 0.0f || Current == Target) {
        return Current;
    }
    if (InterpSpeed <= 0.0f) {
        return Target;
    }
    const double Step = static_cast<double>(InterpSpeed) * static_cast<double>(DeltaTime);
    const FRotator Delta = (Target - Current).GetNormalized();
    FRotator Result = Current;
    Result.Pitch += Clamp(static_cast<double>(Delta.Pitch), -Step, Step);
    Result.Yaw += Clamp(static_cast<double>(Delta.Yaw), -Step, Step);
    Result.Roll += Clamp(static_cast<double>(Delta.Roll), -Step, Step);
    return Result.GetNormalized();
}

FQuat FMath::QInterpTo(const FQuat& Current, const FQuat& Target, float DeltaTime, float InterpSpeed) {
    if (InterpSpeed <= 0.0f || Current.Equals(Target)) {
        return Target;
    }
    return FQuat::Slerp(
        Current, Target, Clamp(static_cast<double>(InterpSpeed) * static_cast<double>(DeltaTime), 0.0, 1.0));
}

FQuat FMath::QInterpConstantTo(const FQuat& Current, const FQuat& Target, float DeltaTime, float InterpSpeed) {
    if (InterpSpeed <= 0.0f || Current.Equals(Target)) {
        return Target;
    }
    const double Step = Clamp(static_cast<double>(InterpSpeed) * static_cast<double>(DeltaTime), 0.0, 1.0);
    const double Distance = Max(UE_KINDA_SMALL_NUMBER, static_cast<double>(Target.AngularDistance(Current)));
    return FQuat::Slerp(Current, Target, Clamp(Step / Distance, 0.0, 1.0));
}

FLinearColor FMath::CInterpTo(
    const FLinearColor& Current, const FLinearColor& Target, float DeltaTime, float InterpSpeed) {
    if (InterpSpeed <= 0.0f || FLinearColor::Dist(Target, Current) < UE_KINDA_SMALL_NUMBER) {
        return Target;
    }
    return Current + (Target - Current) * Clamp<float>(DeltaTime * InterpSpeed, 0.0f, 1.0f);
}

// Geometry
// ----------------------------------------------------------------------------------------------------------------------

FVector FMath::LinePlaneIntersection(
    const FVector& Point1, const FVector& Point2, const FVector& PlaneOrigin, const FVector& PlaneNormal) {
    const FVector Way = Point2 - Point1;
    return Point1 + Way * (((PlaneOrigin - Point1) | PlaneNormal) / (Way | PlaneNormal));
}
FVector FMath::LinePlaneIntersection(const FVector& Point1, const FVector& Point2, const FPlane& Plane) {
    const FVector Normal(Plane.X, Plane.Y, Plane.Z);
    const FVector Way = Point2 - Point1;
    return Point1 + Way * ((Plane.W - (Point1 | Normal)) / (Way | Normal));
}
FVector FMath::RayPlaneIntersection(const FVector& RayOrigin, const FVector& RayDirection, const FPlane& Plane) {
    const FVector Normal(Plane.X, Plane.Y, Plane.Z);
    return RayOrigin + RayDirection * ((Plane.W - (RayOrigin | Normal)) / (RayDirection | Normal));
}
double FMath::GetTForSegmentPlaneIntersect(const FVector& StartPoint, const FVector& EndPoint, const FPlane& Plane) {
    const FVector Normal(Plane.X, Plane.Y, Plane.Z);
    return (Plane.W - (StartPoint | Normal)) / ((EndPoint - StartPoint) | Normal);
}
bool FMath::SegmentPlaneIntersection(
    const FVector& StartPoint, const FVector& EndPoint, const FPlane& Plane, FVector& OutIntersectionPoint) {
    const double Time = GetTForSegmentPlaneIntersect(StartPoint, EndPoint, Plane);
    if (Time > -UE_KINDA_SMALL_NUMBER && Time < 1.0 + UE_KINDA_SMALL_NUMBER) {
        OutIntersectionPoint = StartPoint + (EndPoint - StartPoint) * Time;
        return true;
    }
    return false;
}

bool FMath::LineBoxIntersection(const FBox& Box, const FVector& Start, const FVector& End, const FVector& Direction) {
    // Slabs: the segment is inside the box where it is between all three pairs of planes.
    double Enter = 0.0, Leave = 1.0;
    for (int32 Axis = 0; Axis < 3; ++Axis) {
        if (Abs(Direction[Axis]) < UE_DOUBLE_SMALL_NUMBER) {
            if (Start[Axis] < Box.Min[Axis] || Start[Axis] > Box.Max[Axis]) {
                return false;
            }
            continue;
        }
        double Near = (Box.Min[Axis] - Start[Axis]) / Direction[Axis];
        double Far = (Box.Max[Axis] - Start[Axis]) / Direction[Axis];
        if (Near > Far) {
            Swap(Near, Far);
        }
        Enter = Max(Enter, Near);
        Leave = Min(Leave, Far);
        if (Enter > Leave) {
            return false;
        }
    }
    return true;
}

bool FMath::LineSphereIntersection(
    const FVector& Start, const FVector& Dir, double Length, const FVector& Origin, double Radius) {
    const FVector ToStart = Start - Origin;
    const double Along = Clamp(-(ToStart | Dir), 0.0, Length);
    return (ToStart + Dir * Along).SizeSquared() <= Square(Radius);
}

bool FMath::SphereAABBIntersection(const FVector& SphereCenter, double RadiusSquared, const FBox& AABB) {
    double DistanceSquared = 0.0;
    for (int32 Axis = 0; Axis < 3; ++Axis) {
        const double Outside = Max3(AABB.Min[Axis] - SphereCenter[Axis], 0.0, SphereCenter[Axis] - AABB.Max[Axis]);
        DistanceSquared += Square(Outside);
    }
    return DistanceSquared <= RadiusSquared;
}

bool FMath::PointBoxIntersection(const FVector& Point, const FBox& Box) {
    return Point.X >= Box.Min.X && Point.X <= Box.Max.X && Point.Y >= Box.Min.Y && Point.Y <= Box.Max.Y &&
           Point.Z >= Box.Min.Z && Point.Z <= Box.Max.Z;
}

FVector FMath::ClosestPointOnLine(const FVector& LineStart, const FVector& LineEnd, const FVector& Point) {
    return ClosestPointOnSegment(Point, LineStart, LineEnd);
}
FVector FMath::ClosestPointOnInfiniteLine(const FVector& LineStart, const FVector& LineEnd, const FVector& Point) {
    const FVector Way = LineEnd - LineStart;
    const double SizeSquared = Way.SizeSquared();
    return SizeSquared < UE_DOUBLE_SMALL_NUMBER ? LineStart
                                                : LineStart + Way * (((Point - LineStart) | Way) / SizeSquared);
}
FVector FMath::ClosestPointOnSegment(const FVector& Point, const FVector& StartPoint, const FVector& EndPoint) {
    const FVector Way = EndPoint - StartPoint;
    const double SizeSquared = Way.SizeSquared();
    return SizeSquared < UE_DOUBLE_SMALL_NUMBER
               ? StartPoint
               : StartPoint + Way * Clamp(((Point - StartPoint) | Way) / SizeSquared, 0.0, 1.0);
}
double FMath::PointDistToLine(const FVector& Point, const FVector& Direction, const FVector& Origin) {
    const FVector Normal = Direction.GetSafeNormal();
    return (Origin + Normal * ((Point - Origin) | Normal) - Point).Size();
}
double FMath::PointDistToSegment(const FVector& Point, const FVector& StartPoint, const FVector& EndPoint) {
    return (Point - ClosestPointOnSegment(Point, StartPoint, EndPoint)).Size();
}
double FMath::PointDistToSegmentSquared(const FVector& Point, const FVector& StartPoint, const FVector& EndPoint) {
    return (Point - ClosestPointOnSegment(Point, StartPoint, EndPoint)).SizeSquared();
}

void FMath::SegmentDistToSegment(FVector A1, FVector B1, FVector A2, FVector B2, FVector& OutP1, FVector& OutP2) {
    // The nearest points of two segments, one parameter at a time, clamped to the segments.
    const FVector D1 = B1 - A1, D2 = B2 - A2, R = A1 - A2;
    const double A = D1 | D1, E = D2 | D2, F = D2 | R, C = D1 | R, B = D1 | D2;
    const double Denominator = A * E - B * B;
    double S = A > UE_DOUBLE_SMALL_NUMBER && Denominator > UE_DOUBLE_SMALL_NUMBER
                   ? Clamp((B * F - C * E) / Denominator, 0.0, 1.0)
                   : 0.0;
    double T = E > UE_DOUBLE_SMALL_NUMBER ? (B * S + F) / E : 0.0;
    if (T < 0.0 || T > 1.0) {
        T = Clamp(T, 0.0, 1.0);
        S = A > UE_DOUBLE_SMALL_NUMBER ? Clamp((B * T - C) / A, 0.0, 1.0) : 0.0;
    }
    OutP1 = A1 + D1 * S;
    OutP2 = A2 + D2 * T;
}

FVector FMath::GetReflectionVector(const FVector& Direction, const FVector& SurfaceNormal) {
    const FVector Normal = SurfaceNormal.GetSafeNormal();
    return Direction - Normal * (2.0 * (Direction | Normal));
}

// Noise
// -------------------------------------------------------------------------------------------------------------------------

namespace {

/** A gradient for a lattice point, from a hash of its coordinates. */
uint32 LatticeHash(int32 X, int32 Y, int32 Z) {
    uint32 Hash = static_cast<uint32>(X) * 0x8da6b343u ^ static_cast<uint32>(Y) * 0xd8163841u ^
                  static_cast<uint32>(Z) * 0xcb1ab31fu;
    Hash ^= Hash >> 15;
    Hash *= 0x2c1b3c6du;
    return Hash ^ (Hash >> 12);
}

/** The gradient's product with the way from the lattice point; gradients are the middles of a cube's edges. */
double LatticeGradient(int32 X, int32 Y, int32 Z, double DX, double DY, double DZ) {
    switch (LatticeHash(X, Y, Z) % 12) {
    case 0:
        return DX + DY;
    case 1:
        return -DX + DY;
    case 2:
        return DX - DY;
    case 3:
        return -DX - DY;
    case 4:
        return DX + DZ;
    case 5:
        return -DX + DZ;
    case 6:
        return DX - DZ;
    case 7:
        return -DX - DZ;
    case 8:
        return DY + DZ;
    case 9:
        return -DY + DZ;
    case 10:
        return DY - DZ;
    default:
        return -DY - DZ;
    }
}

double SmoothShare(double T) { return T * T * T * (T * (T * 6.0 - 15.0) + 10.0); }

} // namespace

float FMath::PerlinNoise3D(const FVector& Location) {
    const double FX = FloorToDouble(Location.X), FY = FloorToDouble(Location.Y), FZ = FloorToDouble(Location.Z);
    const int32 X = static_cast<int32>(static_cast<int64>(FX)), Y = static_cast<int32>(static_cast<int64>(FY)),
                Z = static_cast<int32>(static_cast<int64>(FZ));
    const double DX = Location.X - FX, DY = Location.Y - FY, DZ = Location.Z - FZ;
    const double U = SmoothShare(DX), V = SmoothShare(DY), W = SmoothShare(DZ);
    const auto Edge = [&](int32 J, int32 K) {
        return Lerp(LatticeGradient(X, Y + J, Z + K, DX, DY - J, DZ - K),
            LatticeGradient(X + 1, Y + J, Z + K, DX - 1.0, DY - J, DZ - K), U);
    };
    const double Value = Lerp(Lerp(Edge(0, 0), Edge(1, 0), V), Lerp(Edge(0, 1), Edge(1, 1), V), W);
    return static_cast<float>(Clamp(Value, -1.0, 1.0));
}
float FMath::PerlinNoise2D(const FVector2D& Location) { return PerlinNoise3D(FVector(Location.X, Location.Y, 0.0)); }
float FMath::PerlinNoise1D(float Value) { return PerlinNoise3D(FVector(static_cast<double>(Value), 0.0, 0.0)); }
