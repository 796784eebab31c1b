// SPDX-License-Identifier: MIT
/**
 * FMatrix: M[row][column] for row vectors, so a point is transformed as `v * M` and `A * B` means first A, then B.
 * Rows 0 to 2 are the images of the axes, row 3 is the translation.
 */
#pragma once

#include "Math/Plane.h"
#include "Math/Quat.h"

namespace UE::Math {
template <typename T>
struct alignas(16) TMatrix {
    static_assert(std::is_floating_point_v<T>);
    using FReal = T;

    T M[4][4];

    static const TMatrix Identity;

    constexpr TMatrix() : M{} {}
    explicit constexpr TMatrix(EForceInit) : M{} {}
    constexpr TMatrix(const TVector<T>& InX, const TVector<T>& InY, const TVector<T>& InZ, const TVector<T>& InW)
        : M{{InX.X, InX.Y, InX.Z, 0}, {InY.X, InY.Y, InY.Z, 0}, {InZ.X, InZ.Y, InZ.Z, 0}, {InW.X, InW.Y, InW.Z, 1}} {}
    constexpr TMatrix(const TPlane<T>& InX, const TPlane<T>& InY, const TPlane<T>& InZ, const TPlane<T>& InW)
        : M{{InX.X, InX.Y, InX.Z, InX.W}, {InY.X, InY.Y, InY.Z, InY.W}, {InZ.X, InZ.Y, InZ.Z, InZ.W},
              {InW.X, InW.Y, InW.Z, InW.W}} {}
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TMatrix(const TMatrix<A>& From) : M{} {
        for (int32 Row = 0; Row < 4; ++Row) {
            for (int32 Column = 0; Column < 4; ++Column) {
                M[Row][Column] = static_cast<T>(From.M[Row][Column]);
            }
        }
    }

    void SetIdentity() { *this = Identity; }
    TMatrix operator*(const TMatrix& Other) const {
        TMatrix Result;
        for (int32 Row = 0; Row < 4; ++Row) {
            for (int32 Column = 0; Column < 4; ++Column) {
                Result.M[Row][Column] = M[Row][0] * Other.M[0][Column] + M[Row][1] * Other.M[1][Column] +
                                        M[Row][2] * Other.M[2][Column] + M[Row][3] * Other.M[3][Column];
            }
        }
        return Result;
    }
    TMatrix& operator*=(const TMatrix& Other) { return *this = *this * Other; }
    TMatrix operator+(const TMatrix& Other) const {
        TMatrix Result;
        for (int32 Index = 0; Index < 16; ++Index) {
            Result.M[Index / 4][Index % 4] = M[Index / 4][Index % 4] + Other.M[Index / 4][Index % 4];
        }
        return Result;
    }
    TMatrix operator*(T Scale) const {
        TMatrix Result;
        for (int32 Index = 0; Index < 16; ++Index) {
            Result.M[Index / 4][Index % 4] = M[Index / 4][Index % 4] * Scale;
        }
        return Result;
    }
    bool operator==(const TMatrix& Other) const { return Equals(Other, 0); }
    bool Equals(const TMatrix& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        for (int32 Index = 0; Index < 16; ++Index) {
            if (FMath::Abs(M[Index / 4][Index % 4] - Other.M[Index / 4][Index % 4]) > Tolerance) {
                return false;
            }
        }
        return true;
    }
    TVector4<T> TransformFVector4(const TVector4<T>& P) const {
        return TVector4<T>(P.X * M[0][0] + P.Y * M[1][0] + P.Z * M[2][0] + P.W * M[3][0],
            P.X * M[0][1] + P.Y * M[1][1] + P.Z * M[2][1] + P.W * M[3][1],
            P.X * M[0][2] + P.Y * M[1][2] + P.Z * M[2][2] + P.W * M[3][2],
            P.X * M[0][3] + P.Y * M[1][3] + P.Z * M[2][3] + P.W * M[3][3]);
    }
    TVector4<T> TransformPosition(const TVector<T>& V) const {
        return TransformFVector4(TVector4<T>(V.X, V.Y, V.Z, 1));
    }
    /** Without translation. */
    TVector4<T> TransformVector(const TVector<T>& V) const { return TransformFVector4(TVector4<T>(V.X, V.Y, V.Z, 0)); }
    TVector<T> InverseTransformPosition(const TVector<T>& V) const {
        return TVector<T>(InverseFast().TransformPosition(V));
    }
    TVector<T> InverseTransformVector(const TVector<T>& V) const {
        return TVector<T>(InverseFast().TransformVector(V));
    }
    TMatrix GetTransposed() const {
        TMatrix Result;
        for (int32 Index = 0; Index < 16; ++Index) {
            Result.M[Index / 4][Index % 4] = M[Index % 4][Index / 4];
        }
        return Result;
    }
    T Determinant() const {
        return Minor(0, 0) * M[0][0] - Minor(0, 1) * M[0][1] + Minor(0, 2) * M[0][2] - Minor(0, 3) * M[0][3];
    }
    T RotDeterminant() const {
        return M[0][0] * (M[1][1] * M[2][2] - M[1][2] * M[2][1]) - M[1][0] * (M[0][1] * M[2][2] - M[0][2] * M[2][1]) +
               M[2][0] * (M[0][1] * M[1][2] - M[0][2] * M[1][1]);
    }
    /** The identity, if there is no inverse. */
    TMatrix Inverse() const {
        const T Det = Determinant();
        if (Det == T(0) || !FMath::IsFinite(Det)) {
            return Identity;
        }
        TMatrix Result;
        for (int32 Row = 0; Row < 4; ++Row) {
            for (int32 Column = 0; Column < 4; ++Column) {
                Result.M[Column][Row] = Minor(Row, Column) * ((Row + Column) % 2 ? T(-1) : T(1)) / Det;
            }
        }
        return Result;
    }
    TMatrix InverseFast() const { return Inverse(); }
    /** Makes the axes' lengths 1 (those that are not 0); returns the old lengths. */
    TVector<T> ExtractScaling(T Tolerance = UE_SMALL_NUMBER) {
        TVector<T> Scale;
        for (int32 Row = 0; Row < 3; ++Row) {
            const T Square = M[Row][0] * M[Row][0] + M[Row][1] * M[Row][1] + M[Row][2] * M[Row][2];
            if (Square > Tolerance) {
                Scale[Row] = FMath::Sqrt(Square);
                for (int32 Column = 0; Column < 3; ++Column) {
                    M[Row][Column] /= Scale[Row];
                }
            }
        }
        return Scale;
    }
    void RemoveScaling(T Tolerance = UE_SMALL_NUMBER) { ExtractScaling(Tolerance); }
    TMatrix GetMatrixWithoutScale(T Tolerance = UE_SMALL_NUMBER) const {
        TMatrix Result(*this);
        Result.RemoveScaling(Tolerance);
        return Result;
    }
    TVector<T> GetScaleVector(T Tolerance = UE_SMALL_NUMBER) const { return TMatrix(*this).ExtractScaling(Tolerance); }
    T GetMaximumAxisScale() const { return GetScaleVector(0).GetMax(); }
    TMatrix RemoveTranslation() const {
        TMatrix Result(*this);
        Result.SetOrigin(TVector<T>());
        return Result;
    }
    TMatrix ConcatTranslation(const TVector<T>& Translation) const {
        TMatrix Result(*this);
        Result.SetOrigin(GetOrigin() + Translation);
        return Result;
    }
    TMatrix ApplyScale(T Scale) const {
        TMatrix Result(*this);
        Result.SetAxis(0, GetScaledAxis(EAxis::X) * Scale);
        Result.SetAxis(1, GetScaledAxis(EAxis::Y) * Scale);
        Result.SetAxis(2, GetScaledAxis(EAxis::Z) * Scale);
        return Result;
    }
    bool ContainsNaN() const {
        for (int32 Index = 0; Index < 16; ++Index) {
            if (!FMath::IsFinite(M[Index / 4][Index % 4])) {
                return true;
            }
        }
        return false;
    }
    TVector<T> GetOrigin() const { return TVector<T>(M[3][0], M[3][1], M[3][2]); }
    void SetOrigin(const TVector<T>& NewOrigin) {
        M[3][0] = NewOrigin.X;
        M[3][1] = NewOrigin.Y;
        M[3][2] = NewOrigin.Z;
    }
    TVector<T> GetScaledAxis(EAxis::Type Axis) const {
        const int32 Row = static_cast<int32>(Axis) - 1;
        return Row < 0 ? TVector<T>() : TVector<T>(M[Row][0], M[Row][1], M[Row][2]);
    }
    void GetScaledAxes(TVector<T>& X, TVector<T>& Y, TVector<T>& Z) const {
        X = GetScaledAxis(EAxis::X);
        Y = GetScaledAxis(EAxis::Y);
        Z = GetScaledAxis(EAxis::Z);
    }
    TVector<T> GetUnitAxis(EAxis::Type Axis) const { return GetScaledAxis(Axis).GetSafeNormal(); }
    void GetUnitAxes(TVector<T>& X, TVector<T>& Y, TVector<T>& Z) const {
        GetScaledAxes(X, Y, Z);
        X.Normalize();
        Y.Normalize();
        Z.Normalize();
    }
    void SetAxis(int32 Row, const TVector<T>& Axis) {
        check(Row >= 0 && Row < 4);
        M[Row][0] = Axis.X;
        M[Row][1] = Axis.Y;
        M[Row][2] = Axis.Z;
    }
    TVector<T> GetColumn(int32 Column) const { return TVector<T>(M[0][Column], M[1][Column], M[2][Column]); }
    void SetColumn(int32 Column, TVector<T> Value) {
        M[0][Column] = Value.X;
        M[1][Column] = Value.Y;
        M[2][Column] = Value.Z;
    }
    TRotator<T> Rotator() const;
    TQuat<T> ToQuat() const { return TQuat<T>(*this); }
    FString ToString() const {
        FString Result;
        for (int32 Row = 0; Row < 4; ++Row) {
            Result.Appendf(TEXT("[%g %g %g %g] "), static_cast<double>(M[Row][0]), static_cast<double>(M[Row][1]),
                static_cast<double>(M[Row][2]), static_cast<double>(M[Row][3]));
        }
        return Result;
    }

private:
    T Minor(int32 Row, int32 Column) const {
        T S[3][3];
        for (int32 R = 0, OutR = 0; R < 4; ++R) {
            if (R == Row) {
                continue;
            }
            for (int32 C = 0, OutC = 0; C < 4; ++C) {
                if (C != Column) {
                    S[OutR][OutC++] = M[R][C];
                }
            }
            ++OutR;
        }
        return S[0][0] * (S[1][1] * S[2][2] - S[1][2] * S[2][1]) - S[0][1] * (S[1][0] * S[2][2] - S[1][2] * S[2][0]) +
               S[0][2] * (S[1][0] * S[2][1] - S[1][1] * S[2][0]);
    }
};
template <typename T>
inline constexpr TMatrix<T> TMatrix<T>::Identity(
    TVector<T>(1, 0, 0), TVector<T>(0, 1, 0), TVector<T>(0, 0, 1), TVector<T>(0, 0, 0));

template <typename T>
TQuat<T>::TQuat(const TMatrix<T>& InMatrix) {
    const TMatrix<T> A = InMatrix.GetMatrixWithoutScale();
    const auto& M = A.M;
    const T Trace = M[0][0] + M[1][1] + M[2][2];
    if (Trace > T(0)) {
        const T S = FMath::Sqrt(Trace + T(1)) * T(2);
        W = S / T(4);
        X = (M[1][2] - M[2][1]) / S;
        Y = (M[2][0] - M[0][2]) / S;
        Z = (M[0][1] - M[1][0]) / S;
    } else {
        // The largest diagonal element, for numerical stability.
        const int32 I = M[1][1] > M[0][0] ? (M[2][2] > M[1][1] ? 2 : 1) : (M[2][2] > M[0][0] ? 2 : 0);
        const int32 J = (I + 1) % 3;
        const int32 K = (I + 2) % 3;
        const T S = FMath::Sqrt(FMath::Max(M[I][I] - M[J][J] - M[K][K] + T(1), T(UE_SMALL_NUMBER))) * T(2);
        T Parts[3];
        Parts[I] = S / T(4);
        Parts[J] = (M[I][J] + M[J][I]) / S;
        Parts[K] = (M[I][K] + M[K][I]) / S;
        X = Parts[0];
        Y = Parts[1];
        Z = Parts[2];
        W = (M[J][K] - M[K][J]) / S;
    }
}
template <typename T>
TMatrix<T> TQuat<T>::ToMatrix() const {
    return TMatrix<T>(GetAxisX(), GetAxisY(), GetAxisZ(), TVector<T>());
}
template <typename T>
TPlane<T> TPlane<T>::TransformBy(const TMatrix<T>& M) const {
    const TVector<T> Normal = TVector<T>(M.Inverse().GetTransposed().TransformVector(GetNormal())).GetSafeNormal();
    return TPlane(TVector<T>(M.TransformPosition(GetOrigin())), Normal);
}
} // namespace UE::Math
#include "Math/RotationMatrix.h"
