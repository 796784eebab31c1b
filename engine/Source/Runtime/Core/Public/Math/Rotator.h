// SPDX-License-Identifier: MIT
/**
 * FRotator: pitch (up positive), yaw (right positive), roll (clockwise positive), in degrees.
 * Roll is applied first, then pitch, then yaw.
 */
#pragma once

#include "Math/Vector.h"

namespace UE::Math {
template <typename T>
struct TRotator {
    static_assert(std::is_floating_point_v<T>);
    using FReal = T;

    /** About the right axis (Y): 0 is ahead, 90 straight up. */
    T Pitch;
    /** About the up axis (Z): 0 is X, 90 is Y. */
    T Yaw;
    /** About the forward axis (X): 0 is upright. */
    T Roll;

    static const TRotator ZeroRotator;

    constexpr TRotator() : Pitch(0), Yaw(0), Roll(0) {}
    explicit constexpr TRotator(T InF) : Pitch(InF), Yaw(InF), Roll(InF) {}
    constexpr TRotator(T InPitch, T InYaw, T InRoll) : Pitch(InPitch), Yaw(InYaw), Roll(InRoll) {}
    explicit constexpr TRotator(EForceInit) : TRotator() {}
    explicit TRotator(const TQuat<T>& Quat);
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TRotator(const TRotator<A>& R)
        : Pitch(static_cast<T>(R.Pitch)), Yaw(static_cast<T>(R.Yaw)), Roll(static_cast<T>(R.Roll)) {}

    constexpr TRotator operator+(const TRotator& R) const {
        return TRotator(Pitch + R.Pitch, Yaw + R.Yaw, Roll + R.Roll);
    }
    constexpr TRotator operator-(const TRotator& R) const {
        return TRotator(Pitch - R.Pitch, Yaw - R.Yaw, Roll - R.Roll);
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TRotator operator*(A Scale) const {
        return TRotator(Pitch * T(Scale), Yaw * T(Scale), Roll * T(Scale));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    friend constexpr TRotator operator*(A Scale, const TRotator& R) {
        return R * Scale;
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    TRotator& operator*=(A Scale) {
        return *this = *this * Scale;
    }
    TRotator& operator+=(const TRotator& R) { return *this = *this + R; }
    TRotator& operator-=(const TRotator& R) { return *this = *this - R; }
    constexpr bool operator==(const TRotator& R) const { return Pitch == R.Pitch && Yaw == R.Yaw && Roll == R.Roll; }

    bool IsNearlyZero(T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return FMath::Abs(NormalizeAxis(Pitch)) <= Tolerance && FMath::Abs(NormalizeAxis(Yaw)) <= Tolerance &&
               FMath::Abs(NormalizeAxis(Roll)) <= Tolerance;
    }
    bool IsZero() const { return ClampAxis(Pitch) == 0 && ClampAxis(Yaw) == 0 && ClampAxis(Roll) == 0; }
    /** Equal angles modulo 360. */
    bool Equals(const TRotator& R, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return FMath::Abs(NormalizeAxis(Pitch - R.Pitch)) <= Tolerance &&
               FMath::Abs(NormalizeAxis(Yaw - R.Yaw)) <= Tolerance &&
               FMath::Abs(NormalizeAxis(Roll - R.Roll)) <= Tolerance;
    }
    bool EqualsOrientation(const TRotator& R, T Tolerance = UE_KINDA_SMALL_NUMBER) const;
    TRotator Add(T DeltaPitch, T DeltaYaw, T DeltaRoll) {
        Yaw += DeltaYaw;
        Pitch += DeltaPitch;
        Roll += DeltaRoll;
        return *this;
    }
    TRotator GetInverse() const;
    TRotator GridSnap(const TRotator& RotGrid) const {
        return TRotator(FMath::GridSnap(Pitch, RotGrid.Pitch), FMath::GridSnap(Yaw, RotGrid.Yaw),
            FMath::GridSnap(Roll, RotGrid.Roll));
    }
    /** The direction it points to. */
    TVector<T> Vector() const {
        T SP, CP, SY, CY;
        FMath::SinCos(&SP, &CP, FMath::DegreesToRadians(FMath::Fmod(Pitch, T(360))));
        FMath::SinCos(&SY, &CY, FMath::DegreesToRadians(FMath::Fmod(Yaw, T(360))));
        return TVector<T>(CP * CY, CP * SY, SP);
    }
    TQuat<T> Quaternion() const;
    /** (roll, pitch, yaw). */
    TVector<T> Euler() const { return TVector<T>(Roll, Pitch, Yaw); }
    static TRotator MakeFromEuler(const TVector<T>& Euler) { return TRotator(Euler.Y, Euler.Z, Euler.X); }
    TVector<T> RotateVector(const TVector<T>& V) const;
    TVector<T> UnrotateVector(const TVector<T>& V) const;
    TRotator Clamp() const { return TRotator(ClampAxis(Pitch), ClampAxis(Yaw), ClampAxis(Roll)); }
    TRotator GetNormalized() const { return TRotator(NormalizeAxis(Pitch), NormalizeAxis(Yaw), NormalizeAxis(Roll)); }
    TRotator GetDenormalized() const { return Clamp(); }
    void Normalize() { *this = GetNormalized(); }
    T GetComponentForAxis(EAxis::Type Axis) const {
        return Axis == EAxis::X ? Roll : (Axis == EAxis::Y ? Pitch : (Axis == EAxis::Z ? Yaw : T(0)));
    }
    void SetComponentForAxis(EAxis::Type Axis, T Component) {
        (Axis == EAxis::X ? Roll : (Axis == EAxis::Y ? Pitch : Yaw)) = Component;
    }
    /** The other angles of the same orientation. */
    TRotator GetEquivalentRotator() const { return TRotator(180 - Pitch, Yaw + 180, Roll + 180); }
    T GetManhattanDistance(const TRotator& R) const {
        return FMath::Abs(Yaw - R.Yaw) + FMath::Abs(Pitch - R.Pitch) + FMath::Abs(Roll - R.Roll);
    }
    void GetWindingAndRemainder(TRotator& Winding, TRotator& Remainder) const {
        Remainder = GetNormalized();
        Winding = *this - Remainder;
    }
    bool ContainsNaN() const { return !FMath::IsFinite(Pitch) || !FMath::IsFinite(Yaw) || !FMath::IsFinite(Roll); }
    FString ToString() const {
        return FString::Printf(
            TEXT("P=%f Y=%f R=%f"), static_cast<double>(Pitch), static_cast<double>(Yaw), static_cast<double>(Roll));
    }
    FString ToCompactString() const {
        return FString::Printf(TEXT("R(P=%.2f, Y=%.2f, R=%.2f)"), static_cast<double>(Pitch), static_cast<double>(Yaw),
            static_cast<double>(Roll));
    }
    bool InitFromString(const FString& InSourceString) {
        return Private::ParseComponent(InSourceString, TEXT("P="), Pitch) &&
               Private::ParseComponent(InSourceString, TEXT("Y="), Yaw) &&
               Private::ParseComponent(InSourceString, TEXT("R="), Roll);
    }
    /** In [0, 360). */
    static T ClampAxis(T Angle) {
        Angle = FMath::Fmod(Angle, T(360));
        return Angle < T(0) ? Angle + T(360) : Angle;
    }
    /** In (-180, 180]. */
    static T NormalizeAxis(T Angle) {
        Angle = ClampAxis(Angle);
        return Angle > T(180) ? Angle - T(360) : Angle;
    }
    static uint8 CompressAxisToByte(T Angle) {
        return static_cast<uint8>(FMath::RoundToInt32(Angle * T(256) / T(360)) & 0xFF);
    }
    static T DecompressAxisFromByte(uint8 Angle) { return T(Angle) * T(360) / T(256); }
    static uint16 CompressAxisToShort(T Angle) {
        return static_cast<uint16>(FMath::RoundToInt32(Angle * T(65536) / T(360)) & 0xFFFF);
    }
    static T DecompressAxisFromShort(uint16 Angle) { return T(Angle) * T(360) / T(65536); }
    friend uint32 GetTypeHash(const TRotator& R) {
        return HashCombine(HashCombine(GetTypeHash(R.Pitch), GetTypeHash(R.Yaw)), GetTypeHash(R.Roll));
    }
};
template <typename T>
inline constexpr TRotator<T> TRotator<T>::ZeroRotator(0, 0, 0);

template <typename T>
TRotator<T> TVector<T>::ToOrientationRotator() const {
    return TRotator<T>(FMath::RadiansToDegrees(FMath::Atan2(Z, FMath::Sqrt(X * X + Y * Y))),
        FMath::RadiansToDegrees(FMath::Atan2(Y, X)), 0);
}
} // namespace UE::Math
#include "Math/Quat.h"
