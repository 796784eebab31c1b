// SPDX-License-Identifier: MIT
/** Matrices of a rotation, a translation, a scale and their combinations; perspective matrices. */
#pragma once

#include "Math/Matrix.h"

namespace UE::Math {
/** Scale, then rotation, then translation. */
template <typename T>
struct TScaleRotationTranslationMatrix : public TMatrix<T> {
    TScaleRotationTranslationMatrix(const TVector<T>& Scale, const TRotator<T>& Rot, const TVector<T>& Origin) {
        T SP, CP, SY, CY, SR, CR;
        FMath::SinCos(&SP, &CP, FMath::DegreesToRadians(FMath::Fmod(Rot.Pitch, T(360))));
        FMath::SinCos(&SY, &CY, FMath::DegreesToRadians(FMath::Fmod(Rot.Yaw, T(360))));
        FMath::SinCos(&SR, &CR, FMath::DegreesToRadians(FMath::Fmod(Rot.Roll, T(360))));
        static_cast<TMatrix<T>&>(*this) = TMatrix<T>(TVector<T>(CP * CY, CP * SY, SP) * Scale.X,
            TVector<T>(SR * SP * CY - CR * SY, SR * SP * SY + CR * CY, -SR * CP) * Scale.Y,
            TVector<T>(-(CR * SP * CY + SR * SY), CY * SR - CR * SP * SY, CR * CP) * Scale.Z, Origin);
    }
};
template <typename T>
struct TRotationTranslationMatrix : public TScaleRotationTranslationMatrix<T> {
    TRotationTranslationMatrix(const TRotator<T>& Rot, const TVector<T>& Origin)
        : TScaleRotationTranslationMatrix<T>(TVector<T>(1, 1, 1), Rot, Origin) {}
    static TMatrix<T> Make(const TRotator<T>& Rot, const TVector<T>& Origin) {
        return TRotationTranslationMatrix(Rot, Origin);
    }
};
template <typename T>
struct TRotationMatrix : public TRotationTranslationMatrix<T> {
    explicit TRotationMatrix(const TRotator<T>& Rot) : TRotationTranslationMatrix<T>(Rot, TVector<T>()) {}
    static TMatrix<T> Make(const TRotator<T>& Rot) { return TRotationMatrix(Rot); }
    static TMatrix<T> Make(const TQuat<T>& Rot) { return Rot.ToMatrix(); }
    /** A frame with that X axis; Z as far up as it can be. */
    static TMatrix<T> MakeFromX(const TVector<T>& XAxis) {
        const TVector<T> X = XAxis.GetSafeNormal();
        const TVector<T> Up =
            FMath::Abs(X.Z) < T(1) - T(UE_KINDA_SMALL_NUMBER) ? TVector<T>(0, 0, 1) : TVector<T>(1, 0, 0);
        const TVector<T> Y = (Up ^ X).GetSafeNormal();
        return TMatrix<T>(X, Y, X ^ Y, TVector<T>());
    }
    static TMatrix<T> MakeFromY(const TVector<T>& YAxis) {
        const TVector<T> Y = YAxis.GetSafeNormal();
        const TVector<T> Up =
            FMath::Abs(Y.Z) < T(1) - T(UE_KINDA_SMALL_NUMBER) ? TVector<T>(0, 0, 1) : TVector<T>(1, 0, 0);
        const TVector<T> Z = (Up - Y * (Up | Y)).GetSafeNormal();
        return TMatrix<T>(Y ^ Z, Y, Z, TVector<T>());
    }
    static TMatrix<T> MakeFromZ(const TVector<T>& ZAxis) {
        const TVector<T> Z = ZAxis.GetSafeNormal();
        const TVector<T> Up =
            FMath::Abs(Z.Z) < T(1) - T(UE_KINDA_SMALL_NUMBER) ? TVector<T>(0, 0, 1) : TVector<T>(1, 0, 0);
        const TVector<T> X = (Up - Z * (Up | Z)).GetSafeNormal();
        return TMatrix<T>(X, Z ^ X, Z, TVector<T>());
    }
    /** The first axis exactly, the second as near as possible, the third at right angles to both. */
    static TMatrix<T> MakeFromXY(const TVector<T>& XAxis, const TVector<T>& YAxis) {
        const TVector<T> X = XAxis.GetSafeNormal();
        const TVector<T> Z = (X ^ Second(X, YAxis)).GetSafeNormal();
        return TMatrix<T>(X, Z ^ X, Z, TVector<T>());
    }
    static TMatrix<T> MakeFromXZ(const TVector<T>& XAxis, const TVector<T>& ZAxis) {
        const TVector<T> X = XAxis.GetSafeNormal();
        const TVector<T> Y = (Second(X, ZAxis) ^ X).GetSafeNormal();
        return TMatrix<T>(X, Y, X ^ Y, TVector<T>());
    }
    static TMatrix<T> MakeFromYX(const TVector<T>& YAxis, const TVector<T>& XAxis) {
        const TVector<T> Y = YAxis.GetSafeNormal();
        const TVector<T> Z = (Second(Y, XAxis) ^ Y).GetSafeNormal();
        return TMatrix<T>(Y ^ Z, Y, Z, TVector<T>());
    }
    static TMatrix<T> MakeFromYZ(const TVector<T>& YAxis, const TVector<T>& ZAxis) {
        const TVector<T> Y = YAxis.GetSafeNormal();
        const TVector<T> X = (Y ^ Second(Y, ZAxis)).GetSafeNormal();
        return TMatrix<T>(X, Y, X ^ Y, TVector<T>());
    }
    static TMatrix<T> MakeFromZX(const TVector<T>& ZAxis, const TVector<T>& XAxis) {
        const TVector<T> Z = ZAxis.GetSafeNormal();
        const TVector<T> Y = (Z ^ Second(Z, XAxis)).GetSafeNormal();
        return TMatrix<T>(Y ^ Z, Y, Z, TVector<T>());
    }
    static TMatrix<T> MakeFromZY(const TVector<T>& ZAxis, const TVector<T>& YAxis) {
        const TVector<T> Z = ZAxis.GetSafeNormal();
        const TVector<T> X = (Second(Z, YAxis) ^ Z).GetSafeNormal();
        return TMatrix<T>(X, Z ^ X, Z, TVector<T>());
    }

private:
    /** The wanted second axis, or another one if it is parallel to the first. */
    static TVector<T> Second(const TVector<T>& First, const TVector<T>& Wanted) {
        const TVector<T> Normal = Wanted.GetSafeNormal();
        if (FMath::Abs(First | Normal) < T(1) - T(UE_KINDA_SMALL_NUMBER) && !Normal.IsZero()) {
            return Normal;
        }
        return FMath::Abs(First.Z) < T(1) - T(UE_KINDA_SMALL_NUMBER) ? TVector<T>(0, 0, 1) : TVector<T>(1, 0, 0);
    }
};
template <typename T>
struct TTranslationMatrix : public TMatrix<T> {
    explicit TTranslationMatrix(const TVector<T>& Delta)
        : TMatrix<T>(TVector<T>(1, 0, 0), TVector<T>(0, 1, 0), TVector<T>(0, 0, 1), Delta) {}
    static TMatrix<T> Make(const TVector<T>& Delta) { return TTranslationMatrix(Delta); }
};
template <typename T>
struct TScaleMatrix : public TMatrix<T> {
    explicit TScaleMatrix(T Scale) : TScaleMatrix(TVector<T>(Scale)) {}
    explicit TScaleMatrix(const TVector<T>& Scale)
        : TMatrix<T>(TVector<T>(Scale.X, 0, 0), TVector<T>(0, Scale.Y, 0), TVector<T>(0, 0, Scale.Z), TVector<T>()) {}
    static TMatrix<T> Make(const TVector<T>& Scale) { return TScaleMatrix(Scale); }
};
template <typename T>
struct TQuatRotationTranslationMatrix : public TMatrix<T> {
    TQuatRotationTranslationMatrix(const TQuat<T>& Q, const TVector<T>& Origin)
        : TMatrix<T>(Q.GetAxisX(), Q.GetAxisY(), Q.GetAxisZ(), Origin) {}
    static TMatrix<T> Make(const TQuat<T>& Q, const TVector<T>& Origin) {
        return TQuatRotationTranslationMatrix(Q, Origin);
    }
};
template <typename T>
struct TQuatRotationMatrix : public TQuatRotationTranslationMatrix<T> {
    explicit TQuatRotationMatrix(const TQuat<T>& Q) : TQuatRotationTranslationMatrix<T>(Q, TVector<T>()) {}
    static TMatrix<T> Make(const TQuat<T>& Q) { return TQuatRotationMatrix(Q); }
};
/** The inverse of a rotation about an origin: world to local. */
template <typename T>
struct TInverseRotationMatrix : public TMatrix<T> {
    explicit TInverseRotationMatrix(const TRotator<T>& Rot) : TMatrix<T>(TRotationMatrix<T>(Rot).GetTransposed()) {}
};
/** View matrix: X right, Y up, Z ahead. */
template <typename T>
struct TLookFromMatrix : public TMatrix<T> {
    TLookFromMatrix(const TVector<T>& EyePosition, const TVector<T>& LookDirection, const TVector<T>& UpVector) {
        const TVector<T> Z = LookDirection.GetSafeNormal();
        const TVector<T> X = (UpVector ^ Z).GetSafeNormal();
        const TVector<T> Y = Z ^ X;
        for (int32 Row = 0; Row < 3; ++Row) {
            this->M[Row][0] = X[Row];
            this->M[Row][1] = Y[Row];
            this->M[Row][2] = Z[Row];
        }
        this->M[3][0] = -(EyePosition | X);
        this->M[3][1] = -(EyePosition | Y);
        this->M[3][2] = -(EyePosition | Z);
        this->M[3][3] = 1;
    }
};
template <typename T>
struct TLookAtMatrix : public TLookFromMatrix<T> {
    TLookAtMatrix(const TVector<T>& EyePosition, const TVector<T>& LookAtPosition, const TVector<T>& UpVector)
        : TLookFromMatrix<T>(EyePosition, LookAtPosition - EyePosition, UpVector) {}
};
/** Perspective with reversed depth (1 near, 0 far) and no far plane; half of the field of view in radians. */
template <typename T>
struct TReversedZPerspectiveMatrix : public TMatrix<T> {
    TReversedZPerspectiveMatrix(T HalfFOVX, T HalfFOVY, T MultFOVX, T MultFOVY, T MinZ) {
        this->M[0][0] = MultFOVX / FMath::Tan(HalfFOVX);
        this->M[1][1] = MultFOVY / FMath::Tan(HalfFOVY);
        this->M[2][3] = 1;
        this->M[3][2] = MinZ;
    }
    TReversedZPerspectiveMatrix(T HalfFOV, T Width, T Height, T MinZ)
        : TReversedZPerspectiveMatrix(HalfFOV, HalfFOV, T(1), Width / Height, MinZ) {}
};

template <typename T>
TRotator<T> TMatrix<T>::Rotator() const {
    TVector<T> XAxis, YAxis, ZAxis;
    GetScaledAxes(XAxis, YAxis, ZAxis);
    TRotator<T> Result(
        FMath::RadiansToDegrees(FMath::Atan2(XAxis.Z, FMath::Sqrt(XAxis.X * XAxis.X + XAxis.Y * XAxis.Y))),
        FMath::RadiansToDegrees(FMath::Atan2(XAxis.Y, XAxis.X)), 0);
    const TVector<T> SYAxis = TRotationMatrix<T>(Result).GetScaledAxis(EAxis::Y);
    Result.Roll = FMath::RadiansToDegrees(FMath::Atan2(ZAxis | SYAxis, YAxis | SYAxis));
    return Result;
}
} // namespace UE::Math

using FScaleRotationTranslationMatrix = UE::Math::TScaleRotationTranslationMatrix<double>;
using FRotationTranslationMatrix = UE::Math::TRotationTranslationMatrix<double>;
using FRotationMatrix = UE::Math::TRotationMatrix<double>;
using FRotationMatrix44f = UE::Math::TRotationMatrix<float>;
using FTranslationMatrix = UE::Math::TTranslationMatrix<double>;
using FTranslationMatrix44f = UE::Math::TTranslationMatrix<float>;
using FScaleMatrix = UE::Math::TScaleMatrix<double>;
using FScaleMatrix44f = UE::Math::TScaleMatrix<float>;
using FQuatRotationTranslationMatrix = UE::Math::TQuatRotationTranslationMatrix<double>;
using FQuatRotationMatrix = UE::Math::TQuatRotationMatrix<double>;
using FInverseRotationMatrix = UE::Math::TInverseRotationMatrix<double>;
using FLookFromMatrix = UE::Math::TLookFromMatrix<double>;
using FLookAtMatrix = UE::Math::TLookAtMatrix<double>;
using FReversedZPerspectiveMatrix = UE::Math::TReversedZPerspectiveMatrix<double>;
