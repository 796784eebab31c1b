// SPDX-License-Identifier: MIT
/** FTransform: scale, then rotation, then translation. `A * B` means first A, then B. */
#pragma once

#include "Math/RotationMatrix.h"

namespace UE::Math {
template <typename T>
struct alignas(16) TTransform {
    static_assert(std::is_floating_point_v<T>);
    using FReal = T;

    // UE hides these three; use the accessors.
    TQuat<T> Rotation;
    TVector<T> Translation;
    TVector<T> Scale3D;

    static const TTransform Identity;

    constexpr TTransform() : Scale3D(1, 1, 1) {}
    explicit constexpr TTransform(const TVector<T>& InTranslation) : Translation(InTranslation), Scale3D(1, 1, 1) {}
    explicit constexpr TTransform(const TQuat<T>& InRotation) : Rotation(InRotation), Scale3D(1, 1, 1) {}
    explicit TTransform(const TRotator<T>& InRotation) : Rotation(InRotation), Scale3D(1, 1, 1) {}
    constexpr TTransform(
        const TQuat<T>& InRotation, const TVector<T>& InTranslation, const TVector<T>& InScale3D = TVector<T>(1, 1, 1))
        : Rotation(InRotation), Translation(InTranslation), Scale3D(InScale3D) {}
    TTransform(const TRotator<T>& InRotation, const TVector<T>& InTranslation,
        const TVector<T>& InScale3D = TVector<T>(1, 1, 1))
        : Rotation(InRotation), Translation(InTranslation), Scale3D(InScale3D) {}
    explicit TTransform(const TMatrix<T>& InMatrix) { SetFromMatrix(InMatrix); }
    TTransform(const TVector<T>& InX, const TVector<T>& InY, const TVector<T>& InZ, const TVector<T>& InTranslation) {
        SetFromMatrix(TMatrix<T>(InX, InY, InZ, InTranslation));
    }
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TTransform(const TTransform<A>& From)
        : Rotation(From.Rotation), Translation(From.Translation), Scale3D(From.Scale3D) {}

    // ----- parts

    TQuat<T> GetRotation() const { return Rotation; }
    TVector<T> GetTranslation() const { return Translation; }
    TVector<T> GetLocation() const { return Translation; }
    TVector<T> GetScale3D() const { return Scale3D; }
    TRotator<T> Rotator() const { return Rotation.Rotator(); }
    void SetRotation(const TQuat<T>& NewRotation) { Rotation = NewRotation; }
    void SetTranslation(const TVector<T>& NewTranslation) { Translation = NewTranslation; }
    void SetLocation(const TVector<T>& Origin) { Translation = Origin; }
    void SetScale3D(const TVector<T>& NewScale3D) { Scale3D = NewScale3D; }
    void SetTranslationAndScale3D(const TVector<T>& NewTranslation, const TVector<T>& NewScale3D) {
        Translation = NewTranslation;
        Scale3D = NewScale3D;
    }
    void SetComponents(const TQuat<T>& InRotation, const TVector<T>& InTranslation, const TVector<T>& InScale3D) {
        *this = TTransform(InRotation, InTranslation, InScale3D);
    }
    void SetIdentity() { *this = TTransform(); }
    void AddToTranslation(const TVector<T>& Delta) { Translation += Delta; }
    void ConcatenateRotation(const TQuat<T>& DeltaRotation) { Rotation = Rotation * DeltaRotation; }
    void MultiplyScale3D(const TVector<T>& Scale) { Scale3D *= Scale; }
    void ScaleTranslation(const TVector<T>& Scale) { Translation *= Scale; }
    void RemoveScaling(T = UE_SMALL_NUMBER) {
        Scale3D = TVector<T>(1, 1, 1);
        Rotation.Normalize();
    }
    void NormalizeRotation() { Rotation.Normalize(); }
    bool IsRotationNormalized() const { return Rotation.IsNormalized(); }
    TVector<T> GetScaledAxis(EAxis::Type Axis) const {
        switch (Axis) {
        case EAxis::X:
            return TransformVector(TVector<T>(1, 0, 0));
        case EAxis::Y:
            return TransformVector(TVector<T>(0, 1, 0));
        default:
            return TransformVector(TVector<T>(0, 0, 1));
        }
    }
    TVector<T> GetUnitAxis(EAxis::Type Axis) const {
        switch (Axis) {
        case EAxis::X:
            return Rotation.GetAxisX();
        case EAxis::Y:
            return Rotation.GetAxisY();
        default:
            return Rotation.GetAxisZ();
        }
    }
    T GetMaximumAxisScale() const { return Scale3D.GetAbsMax(); }
    T GetMinimumAxisScale() const { return Scale3D.GetAbsMin(); }
    T GetDeterminant() const { return Scale3D.X * Scale3D.Y * Scale3D.Z; }
    bool ContainsNaN() const { return Translation.ContainsNaN() || Rotation.ContainsNaN() || Scale3D.ContainsNaN(); }
    bool IsValid() const { return !ContainsNaN() && Rotation.IsNormalized(); }

    // ----- applying

    TVector<T> TransformPosition(const TVector<T>& V) const { return Rotation.RotateVector(Scale3D * V) + Translation; }
    TVector<T> TransformPositionNoScale(const TVector<T>& V) const { return Rotation.RotateVector(V) + Translation; }
    TVector<T> TransformVector(const TVector<T>& V) const { return Rotation.RotateVector(Scale3D * V); }
    TVector<T> TransformVectorNoScale(const TVector<T>& V) const { return Rotation.RotateVector(V); }
    TQuat<T> TransformRotation(const TQuat<T>& Q) const { return Rotation * Q; }
    TVector<T> InverseTransformPosition(const TVector<T>& V) const {
        return Rotation.UnrotateVector(V - Translation) * GetSafeScaleReciprocal(Scale3D);
    }
    TVector<T> InverseTransformPositionNoScale(const TVector<T>& V) const {
        return Rotation.UnrotateVector(V - Translation);
    }
    TVector<T> InverseTransformVector(const TVector<T>& V) const {
        return Rotation.UnrotateVector(V) * GetSafeScaleReciprocal(Scale3D);
    }
    TVector<T> InverseTransformVectorNoScale(const TVector<T>& V) const { return Rotation.UnrotateVector(V); }
    TQuat<T> InverseTransformRotation(const TQuat<T>& Q) const { return Rotation.Inverse() * Q; }
    TVector4<T> TransformFVector4(const TVector4<T>& V) const {
        const TVector<T> Turned = TransformVector(TVector<T>(V.X, V.Y, V.Z)) + Translation * V.W;
        return TVector4<T>(Turned, V.W);
    }

    // ----- combining

    TTransform operator*(const TTransform& Other) const {
        TTransform Result;
        Multiply(&Result, this, &Other);
        return Result;
    }
    void operator*=(const TTransform& Other) { *this = *this * Other; }
    TTransform operator*(const TQuat<T>& Other) const { return *this * TTransform(Other); }
    void operator*=(const TQuat<T>& Other) { *this = *this * Other; }
    static void Multiply(TTransform* OutTransform, const TTransform* A, const TTransform* B) {
        if (A->Scale3D.GetMin() < 0 || B->Scale3D.GetMin() < 0) {
            // A mirror does not commute with the rotation: go through matrices, and give the result the product's
            // signs.
            const TMatrix<T> Product = A->ToMatrixWithScale() * B->ToMatrixWithScale();
            *OutTransform = FromMatrixWithSigns(Product, A->Scale3D * B->Scale3D);
            return;
        }
        const TTransform Result(B->Rotation * A->Rotation,
            B->Rotation.RotateVector(B->Scale3D * A->Translation) + B->Translation, A->Scale3D * B->Scale3D);
        *OutTransform = Result;
    }
    /** `X * X.Inverse()` is the identity, as far as a non-uniform scale allows. */
    TTransform Inverse() const {
        const TQuat<T> InvRotation = Rotation.Inverse();
        const TVector<T> InvScale3D = GetSafeScaleReciprocal(Scale3D);
        return TTransform(InvRotation, InvRotation.RotateVector(InvScale3D * -Translation), InvScale3D);
    }
    /** The transform R for which `R * Other` is this one. */
    TTransform GetRelativeTransform(const TTransform& Other) const {
        if (Scale3D.GetMin() < 0 || Other.Scale3D.GetMin() < 0) {
            const TMatrix<T> Product = ToMatrixWithScale() * Other.ToMatrixWithScale().Inverse();
            return FromMatrixWithSigns(Product, Scale3D * GetSafeScaleReciprocal(Other.Scale3D));
        }
        const TVector<T> Reciprocal = GetSafeScaleReciprocal(Other.Scale3D);
        const TQuat<T> InverseOther = Other.Rotation.Inverse();
        return TTransform(InverseOther * Rotation,
            InverseOther.RotateVector(Translation - Other.Translation) * Reciprocal, Scale3D * Reciprocal);
    }
    /** The transform R for which `this * R` is Other. */
    TTransform GetRelativeTransformReverse(const TTransform& Other) const {
        const TVector<T> Reciprocal = GetSafeScaleReciprocal(Scale3D);
        TTransform Result;
        Result.Rotation = Other.Rotation * Rotation.Inverse();
        Result.Scale3D = Other.Scale3D * Reciprocal;
        Result.Translation = Other.Translation - Result.Rotation.RotateVector(Translation * Result.Scale3D);
        return Result;
    }
    void SetToRelativeTransform(const TTransform& Parent) { *this = GetRelativeTransform(Parent); }
    void Blend(const TTransform& Atom1, const TTransform& Atom2, T Alpha) {
        Rotation = TQuat<T>::FastLerp(Atom1.Rotation, Atom2.Rotation, Alpha).GetNormalized();
        Translation = FMath::Lerp(Atom1.Translation, Atom2.Translation, Alpha);
        Scale3D = FMath::Lerp(Atom1.Scale3D, Atom2.Scale3D, Alpha);
    }
    void BlendWith(const TTransform& OtherAtom, T Alpha) { Blend(TTransform(*this), OtherAtom, Alpha); }

    TMatrix<T> ToMatrixWithScale() const {
        return TMatrix<T>(Rotation.GetAxisX() * Scale3D.X, Rotation.GetAxisY() * Scale3D.Y,
            Rotation.GetAxisZ() * Scale3D.Z, Translation);
    }
    TMatrix<T> ToMatrixNoScale() const {
        return TMatrix<T>(Rotation.GetAxisX(), Rotation.GetAxisY(), Rotation.GetAxisZ(), Translation);
    }
    TMatrix<T> ToInverseMatrixWithScale() const { return ToMatrixWithScale().Inverse(); }
    void SetFromMatrix(const TMatrix<T>& InMatrix) {
        TMatrix<T> M = InMatrix;
        Scale3D = M.ExtractScaling();
        if (InMatrix.RotDeterminant() < 0) {
            // A mirror: it is put on the X axis, since a rotation cannot hold it.
            Scale3D.X = -Scale3D.X;
            M.SetAxis(0, -M.GetScaledAxis(EAxis::X));
        }
        Rotation = TQuat<T>(M);
        Translation = InMatrix.GetOrigin();
        Rotation.Normalize();
    }

    // ----- comparing

    bool RotationEquals(const TTransform& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return Rotation.Equals(Other.Rotation, Tolerance);
    }
    bool TranslationEquals(const TTransform& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return Translation.Equals(Other.Translation, Tolerance);
    }
    bool Scale3DEquals(const TTransform& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return Scale3D.Equals(Other.Scale3D, Tolerance);
    }
    bool Equals(const TTransform& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return TranslationEquals(Other, Tolerance) && RotationEquals(Other, Tolerance) &&
               Scale3DEquals(Other, Tolerance);
    }
    bool EqualsNoScale(const TTransform& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return TranslationEquals(Other, Tolerance) && RotationEquals(Other, Tolerance);
    }
    static bool AreRotationsEqual(const TTransform& A, const TTransform& B, T Tolerance = UE_KINDA_SMALL_NUMBER) {
        return A.RotationEquals(B, Tolerance);
    }
    static bool AreTranslationsEqual(const TTransform& A, const TTransform& B, T Tolerance = UE_KINDA_SMALL_NUMBER) {
        return A.TranslationEquals(B, Tolerance);
    }
    /** 1 / scale, and 0 where the scale is (nearly) 0. */
    static TVector<T> GetSafeScaleReciprocal(const TVector<T>& InScale, T Tolerance = UE_SMALL_NUMBER) {
        return TVector<T>(FMath::Abs(InScale.X) <= Tolerance ? T(0) : T(1) / InScale.X,
            FMath::Abs(InScale.Y) <= Tolerance ? T(0) : T(1) / InScale.Y,
            FMath::Abs(InScale.Z) <= Tolerance ? T(0) : T(1) / InScale.Z);
    }
    FString ToHumanReadableString() const {
        return FString::Printf(TEXT("Rotation: %s\nTranslation: %s\nScale3D: %s\n"), *Rotator().ToString(),
            *Translation.ToString(), *Scale3D.ToString());
    }
    /** "x,y,z|pitch,yaw,roll|sx,sy,sz". */
    FString ToString() const {
        const TRotator<T> R = Rotator();
        return FString::Printf(TEXT("%f,%f,%f|%f,%f,%f|%f,%f,%f"), double(Translation.X), double(Translation.Y),
            double(Translation.Z), double(R.Pitch), double(R.Yaw), double(R.Roll), double(Scale3D.X), double(Scale3D.Y),
            double(Scale3D.Z));
    }
    bool InitFromString(const FString& InSourceString) {
        TArray<FString> Parts;
        const TCHAR* Delimiters[] = {TEXT(","), TEXT("|")};
        if (InSourceString.ParseIntoArray(Parts, Delimiters, 2) != 9) {
            return false;
        }
        T V[9];
        for (int32 Index = 0; Index < 9; ++Index) {
            V[Index] = static_cast<T>(FCString::Atod(*Parts[Index]));
        }
        *this = TTransform(TRotator<T>(V[3], V[4], V[5]), TVector<T>(V[0], V[1], V[2]), TVector<T>(V[6], V[7], V[8]));
        return true;
    }
    friend uint32 GetTypeHash(const TTransform& Transform) {
        return HashCombine(HashCombine(GetTypeHash(Transform.Rotation), GetTypeHash(Transform.Translation)),
            GetTypeHash(Transform.Scale3D));
    }

private:
    static TTransform FromMatrixWithSigns(TMatrix<T> M, const TVector<T>& DesiredScale) {
        M.RemoveScaling();
        const TVector<T> Sign = DesiredScale.GetSignVector();
        M.SetAxis(0, M.GetScaledAxis(EAxis::X) * Sign.X);
        M.SetAxis(1, M.GetScaledAxis(EAxis::Y) * Sign.Y);
        M.SetAxis(2, M.GetScaledAxis(EAxis::Z) * Sign.Z);
        return TTransform(TQuat<T>(M).GetNormalized(), M.GetOrigin(), DesiredScale);
    }
};
template <typename T>
inline constexpr TTransform<T> TTransform<T>::Identity{};
} // namespace UE::Math
