// SPDX-License-Identifier: MIT
/** Forward declarations of the math types: double by default, with f suffix float. */
#pragma once

#include "CoreTypes.h"

namespace UE::Math {
template <typename T>
struct TVector2;
template <typename T>
struct TVector;
template <typename T>
struct TVector4;
template <typename T>
struct TPlane;
template <typename T>
struct TMatrix;
template <typename T>
struct TQuat;
template <typename T>
struct TTransform;
template <typename T>
struct TRotator;
template <typename T>
struct TBox;
template <typename T>
struct TBox2;
template <typename T>
struct TSphere;
template <typename T, typename TExtent = T>
struct TBoxSphereBounds;
template <typename T>
struct TRay;
template <typename T>
struct TIntPoint;
template <typename T>
struct TIntVector3;
template <typename T>
struct TIntVector2;
template <typename T>
struct TIntVector4;
} // namespace UE::Math

using FVector = UE::Math::TVector<double>;
using FVector3d = UE::Math::TVector<double>;
using FVector3f = UE::Math::TVector<float>;
using FVector2D = UE::Math::TVector2<double>;
using FVector2d = UE::Math::TVector2<double>;
using FVector2f = UE::Math::TVector2<float>;
using FVector4 = UE::Math::TVector4<double>;
using FVector4d = UE::Math::TVector4<double>;
using FVector4f = UE::Math::TVector4<float>;
using FPlane = UE::Math::TPlane<double>;
using FPlane4d = UE::Math::TPlane<double>;
using FPlane4f = UE::Math::TPlane<float>;
using FMatrix = UE::Math::TMatrix<double>;
using FMatrix44d = UE::Math::TMatrix<double>;
using FMatrix44f = UE::Math::TMatrix<float>;
using FQuat = UE::Math::TQuat<double>;
using FQuat4d = UE::Math::TQuat<double>;
using FQuat4f = UE::Math::TQuat<float>;
using FTransform = UE::Math::TTransform<double>;
using FTransform3d = UE::Math::TTransform<double>;
using FTransform3f = UE::Math::TTransform<float>;
using FRotator = UE::Math::TRotator<double>;
using FRotator3d = UE::Math::TRotator<double>;
using FRotator3f = UE::Math::TRotator<float>;
using FBox = UE::Math::TBox<double>;
using FBox3d = UE::Math::TBox<double>;
using FBox3f = UE::Math::TBox<float>;
using FBox2D = UE::Math::TBox2<double>;
using FBox2d = UE::Math::TBox2<double>;
using FBox2f = UE::Math::TBox2<float>;
using FSphere = UE::Math::TSphere<double>;
using FSphere3d = UE::Math::TSphere<double>;
using FSphere3f = UE::Math::TSphere<float>;
using FBoxSphereBounds = UE::Math::TBoxSphereBounds<double, double>;
using FBoxSphereBounds3d = UE::Math::TBoxSphereBounds<double, double>;
using FBoxSphereBounds3f = UE::Math::TBoxSphereBounds<float, float>;
using FRay = UE::Math::TRay<double>;
using FRay3d = UE::Math::TRay<double>;
using FRay3f = UE::Math::TRay<float>;
using FIntPoint = UE::Math::TIntPoint<int32>;
using FInt32Point = UE::Math::TIntPoint<int32>;
using FUintPoint = UE::Math::TIntPoint<uint32>;
using FIntVector = UE::Math::TIntVector3<int32>;
using FInt32Vector = UE::Math::TIntVector3<int32>;
using FInt64Vector = UE::Math::TIntVector3<int64>;
using FUintVector = UE::Math::TIntVector3<uint32>;
using FIntVector2 = UE::Math::TIntVector2<int32>;
using FIntVector4 = UE::Math::TIntVector4<int32>;
struct FLinearColor;
struct FColor;
struct FRandomStream;
