// SPDX-License-Identifier: MIT
/** FQuat: a rotation. `A * B` turns by B first, then by A. */
#pragma once

#include "Math/Rotator.h"

namespace UE::Math {
template <typename T>
struct alignas(16) TQuat {
    static_assert(std::is_floating_point_v<T>);
    using FReal = T;

    T X;
    T Y;
    T Z;
    T W;

    static const TQuat Identity;

    constexpr TQuat() : X(0), Y(0), Z(0), W(1) {}
    explicit constexpr TQuat(EForceInit) : X(0), Y(0), Z(0), W(0) {}
    constexpr TQuat(T InX, T InY, T InZ, T InW) : X(InX), Y(InY), Z(InZ), W(InW) {}
    explicit TQuat(const TRotator<T>& R) { *this = R.Quaternion(); }
    explicit TQuat(const TMatrix<T>& M);
    /** Axis of length 1, angle in radians. */
    TQuat(const TVector<T>& Axis, T AngleRad) {
        T S, C;
        FMath::SinCos(&S, &C, AngleRad * T(0.5));
        *this = TQuat(S * Axis.X, S * Axis.Y, S * Axis.Z, C);
    }
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TQuat(const TQuat<A>& Q)
        : X(static_cast<T>(Q.X)), Y(static_cast<T>(Q.Y)), Z(static_cast<T>(Q.Z)), W(static_cast<T>(Q.W)) {}

    constexpr TQuat operator+(const TQuat& Q) const { return TQuat(X + Q.X, Y + Q.Y, Z + Q.Z, W + Q.W); }
    constexpr TQuat operator-(const TQuat& Q) const { return TQuat(X - Q.X, Y - Q.Y, Z - Q.Z, W - Q.W); }
    constexpr TQuat operator-() const { return TQuat(-X, -Y, -Z, -W); }
    constexpr TQuat operator*(const TQuat& Q) const {
        return TQuat(W * Q.X + X * Q.W + Y * Q.Z - Z * Q.Y, W * Q.Y - X * Q.Z + Y * Q.W + Z * Q.X,
            W * Q.Z + X * Q.Y - Y * Q.X + Z * Q.W, W * Q.W - X * Q.X - Y * Q.Y - Z * Q.Z);
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TQuat operator*(A Scale) const {
        return TQuat(X * T(Scale), Y * T(Scale), Z * T(Scale), W * T(Scale));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    friend constexpr TQuat operator*(A Scale, const TQuat& Q) {
        return Q * Scale;
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TQuat operator/(A Scale) const {
        return *this * (T(1) / T(Scale));
    }
    TVector<T> operator*(const TVector<T>& V) const { return RotateVector(V); }
    TQuat& operator+=(const TQuat& Q) { return *this = *this + Q; }
    TQuat& operator-=(const TQuat& Q) { return *this = *this - Q; }
    TQuat& operator*=(const TQuat& Q) { return *this = *this * Q; }
    template <typename A>
        requires std::is_arithmetic_v<A>
    TQuat& operator*=(A Scale) {
        return *this = *this * Scale;
    }
    constexpr T operator|(const TQuat& Q) const { return X * Q.X + Y * Q.Y + Z * Q.Z + W * Q.W; }
    constexpr bool operator==(const TQuat& Q) const { return X == Q.X && Y == Q.Y && Z == Q.Z && W == Q.W; }

    /** Q and -Q are the same rotation, and equal here. */
    bool Equals(const TQuat& Q, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return Near(Q, Tolerance) || Near(-Q, Tolerance);
    }
    bool IsIdentity(T Tolerance = UE_SMALL_NUMBER) const { return Equals(Identity, Tolerance); }
    void Normalize(T Tolerance = UE_SMALL_NUMBER) {
        const T SquareSum = SizeSquared();
        *this = SquareSum >= Tolerance ? *this * FMath::InvSqrt(SquareSum) : Identity;
    }
    TQuat GetNormalized(T Tolerance = UE_SMALL_NUMBER) const {
        TQuat Result(*this);
        Result.Normalize(Tolerance);
        return Result;
    }
    bool IsNormalized() const { return FMath::Abs(T(1) - SizeSquared()) < UE_THRESH_QUAT_NORMALIZED; }
    T Size() const { return FMath::Sqrt(SizeSquared()); }
    constexpr T SizeSquared() const { return *this | *this; }
    /** Of a unit quaternion. */
    constexpr TQuat Inverse() const { return TQuat(-X, -Y, -Z, W); }
    TVector<T> RotateVector(const TVector<T>& V) const {
        const TVector<T> Q(X, Y, Z);
        const TVector<T> TT = T(2) * TVector<T>::CrossProduct(Q, V);
        return V + (W * TT) + TVector<T>::CrossProduct(Q, TT);
    }
    TVector<T> UnrotateVector(const TVector<T>& V) const { return Inverse().RotateVector(V); }
    TVector<T> GetAxisX() const { return RotateVector(TVector<T>(1, 0, 0)); }
    TVector<T> GetAxisY() const { return RotateVector(TVector<T>(0, 1, 0)); }
    TVector<T> GetAxisZ() const { return RotateVector(TVector<T>(0, 0, 1)); }
    TVector<T> GetForwardVector() const { return GetAxisX(); }
    TVector<T> GetRightVector() const { return GetAxisY(); }
    TVector<T> GetUpVector() const { return GetAxisZ(); }
    TVector<T> Vector() const { return GetAxisX(); }
    void ToAxisAndAngle(TVector<T>& Axis, T& Angle) const {
        Angle = GetAngle();
        Axis = GetRotationAxis();
    }
    T GetAngle() const { return T(2) * FMath::Acos(W); }
    TVector<T> GetRotationAxis() const {
        const T SquareSum = X * X + Y * Y + Z * Z;
        return SquareSum < UE_SMALL_NUMBER ? TVector<T>::XAxisVector : TVector<T>(X, Y, Z) * FMath::InvSqrt(SquareSum);
    }
    /** Axis times angle in radians. */
    TVector<T> ToRotationVector() const {
        TQuat Q = W < 0 ? -*this : *this;
        return Q.GetRotationAxis() * Q.GetAngle();
    }
    static TQuat MakeFromRotationVector(const TVector<T>& RotationVector) {
        const T Angle = RotationVector.Size();
        return Angle > UE_SMALL_NUMBER ? TQuat(RotationVector / Angle, Angle) : Identity;
    }
    /** Angle between two rotations, in radians. */
    T AngularDistance(const TQuat& Q) const {
        const T Inner = *this | Q;
        return FMath::Acos(T(2) * Inner * Inner - T(1));
    }
    /** Flips the sign if that is nearer to Other. */
    void EnforceShortestArcWith(const TQuat& Other) {
        if ((Other | *this) < 0) {
            *this = -*this;
        }
    }
    TRotator<T> Rotator() const {
        // The X axis of the rotated frame gives pitch and yaw; near the poles only one angle is left.
        const T SingularityTest = Z * X - W * Y;
        const T YawY = T(2) * (W * Z + X * Y);
        const T YawX = T(1) - T(2) * (Y * Y + Z * Z);
        const T Threshold = T(0.4999995);
        const T RadToDeg = T(180.0 / UE_DOUBLE_PI);
        TRotator<T> Result;
        Result.Yaw = FMath::Atan2(YawY, YawX) * RadToDeg;
        if (SingularityTest < -Threshold) {
            Result.Pitch = -90;
            Result.Roll = TRotator<T>::NormalizeAxis(-Result.Yaw - T(2) * FMath::Atan2(X, W) * RadToDeg);
        } else if (SingularityTest > Threshold) {
            Result.Pitch = 90;
            Result.Roll = TRotator<T>::NormalizeAxis(Result.Yaw - T(2) * FMath::Atan2(X, W) * RadToDeg);
        } else {
            Result.Pitch = FMath::Asin(T(2) * SingularityTest) * RadToDeg;
            Result.Roll = FMath::Atan2(T(-2) * (W * X + Y * Z), T(1) - T(2) * (X * X + Y * Y)) * RadToDeg;
        }
        return Result;
    }
    /** (roll, pitch, yaw) in degrees. */
    TVector<T> Euler() const { return Rotator().Euler(); }
    static TQuat MakeFromEuler(const TVector<T>& Euler) { return TRotator<T>::MakeFromEuler(Euler).Quaternion(); }
    static TQuat MakeFromRotator(const TRotator<T>& R) { return R.Quaternion(); }
    TMatrix<T> ToMatrix() const;
    /** The smallest rotation that turns one direction into the other. */
    static TQuat FindBetween(const TVector<T>& A, const TVector<T>& B) { return FindBetweenVectors(A, B); }
    static TQuat FindBetweenNormals(const TVector<T>& A, const TVector<T>& B) { return BetweenHelper(A, B, T(1)); }
    static TQuat FindBetweenVectors(const TVector<T>& A, const TVector<T>& B) {
        return BetweenHelper(A, B, FMath::Sqrt(A.SizeSquared() * B.SizeSquared()));
    }
    static T Error(const TQuat& Q1, const TQuat& Q2) { return T(1) - FMath::Abs(Q1 | Q2); }
    static TQuat FastLerp(const TQuat& A, const TQuat& B, T Alpha) {
        const T Bias = (A | B) >= 0 ? T(1) : T(-1);
        return B * Alpha + A * (Bias * (T(1) - Alpha));
    }
    /** The short way round, of constant angular speed; the result may be not quite of length 1. */
    static TQuat Slerp_NotNormalized(const TQuat& A, const TQuat& B, T Alpha) {
        const T RawCosom = A | B;
        const T Cosom = FMath::Abs(RawCosom);
        T Scale0 = T(1) - Alpha;
        T Scale1 = Alpha;
        if (Cosom < T(0.9999)) {
            const T Omega = FMath::Acos(Cosom);
            const T InvSin = T(1) / FMath::Sin(Omega);
            Scale0 = FMath::Sin((T(1) - Alpha) * Omega) * InvSin;
            Scale1 = FMath::Sin(Alpha * Omega) * InvSin;
        }
        return A * Scale0 + B * (RawCosom >= 0 ? Scale1 : -Scale1);
    }
    static TQuat Slerp(const TQuat& A, const TQuat& B, T Alpha) {
        return Slerp_NotNormalized(A, B, Alpha).GetNormalized();
    }
    bool ContainsNaN() const {
        return !FMath::IsFinite(X) || !FMath::IsFinite(Y) || !FMath::IsFinite(Z) || !FMath::IsFinite(W);
    }
    FString ToString() const {
        return FString::Printf(TEXT("X=%.9f Y=%.9f Z=%.9f W=%.9f"), static_cast<double>(X), static_cast<double>(Y),
            static_cast<double>(Z), static_cast<double>(W));
    }
    bool InitFromString(const FString& S) {
        return Private::ParseComponent(S, TEXT("X="), X) && Private::ParseComponent(S, TEXT("Y="), Y) &&
               Private::ParseComponent(S, TEXT("Z="), Z) && Private::ParseComponent(S, TEXT("W="), W);
    }
    friend uint32 GetTypeHash(const TQuat& Q) {
        return HashCombine(
            HashCombine(GetTypeHash(Q.X), GetTypeHash(Q.Y)), HashCombine(GetTypeHash(Q.Z), GetTypeHash(Q.W)));
    }

private:
    bool Near(const TQuat& Q, T Tolerance) const {
        return FMath::Abs(X - Q.X) <= Tolerance && FMath::Abs(Y - Q.Y) <= Tolerance &&
               FMath::Abs(Z - Q.Z) <= Tolerance && FMath::Abs(W - Q.W) <= Tolerance;
    }
    static TQuat BetweenHelper(const TVector<T>& A, const TVector<T>& B, T NormAB) {
        const T W_ = NormAB + (A | B);
        TQuat Result;
        if (W_ >= T(1e-6) * NormAB) {
            const TVector<T> Axis = A ^ B;
            Result = TQuat(Axis.X, Axis.Y, Axis.Z, W_);
        } else {
            // Opposite directions: turn half round about any axis at right angles.
            Result = FMath::Abs(A.X) > FMath::Abs(A.Y) ? TQuat(-A.Z, 0, A.X, 0) : TQuat(0, -A.Z, A.Y, 0);
        }
        Result.Normalize();
        return Result;
    }
};
template <typename T>
inline constexpr TQuat<T> TQuat<T>::Identity(0, 0, 0, 1);

template <typename T>
TQuat<T> TRotator<T>::Quaternion() const {
    const T HalfDegToRad = T(UE_DOUBLE_PI / 360.0);
    T SP, CP, SY, CY, SR, CR;
    FMath::SinCos(&SP, &CP, FMath::Fmod(Pitch, T(360)) * HalfDegToRad);
    FMath::SinCos(&SY, &CY, FMath::Fmod(Yaw, T(360)) * HalfDegToRad);
    FMath::SinCos(&SR, &CR, FMath::Fmod(Roll, T(360)) * HalfDegToRad);
    return TQuat<T>(CR * SP * SY - SR * CP * CY, -CR * SP * CY - SR * CP * SY, CR * CP * SY - SR * SP * CY,
        CR * CP * CY + SR * SP * SY);
}
template <typename T>
TRotator<T>::TRotator(const TQuat<T>& Quat) {
    *this = Quat.Rotator();
}
template <typename T>
TRotator<T> TRotator<T>::GetInverse() const {
    return Quaternion().Inverse().Rotator();
}
template <typename T>
bool TRotator<T>::EqualsOrientation(const TRotator& R, T Tolerance) const {
    return Quaternion().AngularDistance(R.Quaternion()) <= Tolerance;
}
template <typename T>
TVector<T> TRotator<T>::RotateVector(const TVector<T>& V) const {
    return Quaternion().RotateVector(V);
}
template <typename T>
TVector<T> TRotator<T>::UnrotateVector(const TVector<T>& V) const {
    return Quaternion().UnrotateVector(V);
}
template <typename T>
TQuat<T> TVector<T>::ToOrientationQuat() const {
    return ToOrientationRotator().Quaternion();
}
template <typename T>
TVector<T> TVector<T>::SlerpVectorToDirection(const TVector& V, const TVector& Direction, T Alpha) {
    const TQuat<T> Turn = TQuat<T>::FindBetweenVectors(V, Direction);
    return TQuat<T>::Slerp(TQuat<T>::Identity, Turn, Alpha).RotateVector(V);
}
} // namespace UE::Math
