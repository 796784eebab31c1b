// SPDX-License-Identifier: MIT
// Reflection of types that are declared without it: UObject and the math types of Core. The compiler sees their real
// headers, the header tool (for which CPP is 0) sees mirrors with the same names and members. Mirrors Epic's
// "UObject/NoExportTypes.h".
#pragma once

#if !defined(CPP) || CPP
#include "CoreMinimal.h"
#include "Math/Axis.h"
#include "Math/Box2D.h"
#include "Math/BoxSphereBounds.h"
#include "Math/Color.h"
#include "Math/IntPoint.h"
#include "Math/IntVector.h"
#include "Math/RandomStream.h"
#include "Math/Ray.h"
#include "Math/Sphere.h"
#include "Math/Transform.h"
#include "Math/Vector2D.h"
#include "Math/Vector4.h"
#include "Misc/DateTime.h"
#include "Misc/Guid.h"
#include "Misc/Timespan.h"
#include "UObject/CoreStructTraits.h"
#include "UObject/Object.h"
#include "UObject/SoftObjectPath.h"
#endif

#include "NoExportTypes.generated.h"

#if !CPP

/** Whether letters of different case are equal when text is compared. */
UENUM()
namespace ESearchCase {
enum Type { CaseSensitive, IgnoreCase };
}

/** The end of a text at which a search starts. */
UENUM()
namespace ESearchDir {
enum Type { FromStart, FromEnd };
}

/** An axis, or none. */
UENUM()
namespace EAxis {
enum Type { None, X, Y, Z };
}

/** A point or direction in 3D space (double precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FVector {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    double X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    double Y;

    /** Z component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    double Z;
};

/** A point or direction in 3D space (single precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FVector3f {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector3f, SaveGame)
    float X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector3f, SaveGame)
    float Y;

    /** Z component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector3f, SaveGame)
    float Z;
};

/** A point or direction in 2D space (double precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FVector2D {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector2D, SaveGame)
    double X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector2D, SaveGame)
    double Y;
};

/** A point or direction in 2D space (single precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FVector2f {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector2f, SaveGame)
    float X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector2f, SaveGame)
    float Y;
};

/** A 4D homogeneous vector (double precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FVector4 {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4, SaveGame)
    double X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4, SaveGame)
    double Y;

    /** Z component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4, SaveGame)
    double Z;

    /** W component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4, SaveGame)
    double W;
};

/** A 4D homogeneous vector (single precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FVector4f {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4f, SaveGame)
    float X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4f, SaveGame)
    float Y;

    /** Z component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4f, SaveGame)
    float Z;

    /** W component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4f, SaveGame)
    float W;
};

/** A plane in 3D space: points with X*Px + Y*Py + Z*Pz = W. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FPlane : public FVector {
    /** Distance along the normal. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Plane, SaveGame)
    double W;
};

/** A plane in 3D space (single precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FPlane4f : public FVector3f {
    /** Distance along the normal. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Plane4f, SaveGame)
    float W;
};

/** A rotation in degrees. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FRotator {
    /** Rotation around the right axis (Y), looking up and down (0 = straight ahead, + = up). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator, SaveGame)
    double Pitch;

    /** Rotation around the up axis (Z), turning around (0 = forward, + = right). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator, SaveGame)
    double Yaw;

    /** Rotation around the forward axis (X), tilting the head (0 = straight, + = clockwise). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator, SaveGame)
    double Roll;
};

/** A rotation in degrees. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FRotator3f {
    /** Rotation around the right axis (Y), looking up and down (0 = straight ahead, + = up). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator3f, SaveGame)
    float Pitch;

    /** Rotation around the up axis (Z), turning around (0 = forward, + = right). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator3f, SaveGame)
    float Yaw;

    /** Rotation around the forward axis (X), tilting the head (0 = straight, + = clockwise). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator3f, SaveGame)
    float Roll;
};

/** A rotation as a quaternion (double precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FQuat {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat, SaveGame)
    double X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat, SaveGame)
    double Y;

    /** Z component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat, SaveGame)
    double Z;

    /** W component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat, SaveGame)
    double W;
};

/** A rotation as a quaternion (single precision). */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FQuat4f {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat4f, SaveGame)
    float X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat4f, SaveGame)
    float Y;

    /** Z component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat4f, SaveGame)
    float Z;

    /** W component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat4f, SaveGame)
    float W;
};

/** Scale, rotation and translation, applied in this order. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FTransform {
    /** Rotation as a quaternion. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform, SaveGame)
    FQuat Rotation;

    /** Translation in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform, SaveGame)
    FVector Translation;

    /** Scale along the local axes. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform, SaveGame)
    FVector Scale3D;
};

/** Scale, rotation and translation, applied in this order. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FTransform3f {
    /** Rotation as a quaternion. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform3f, SaveGame)
    FQuat4f Rotation;

    /** Translation in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform3f, SaveGame)
    FVector3f Translation;

    /** Scale along the local axes. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform3f, SaveGame)
    FVector3f Scale3D;
};

/** A 4x4 matrix, row vectors times matrix. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FMatrix {
    /** X row. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix, SaveGame)
    FPlane XPlane;

    /** Y row. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix, SaveGame)
    FPlane YPlane;

    /** Z row. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix, SaveGame)
    FPlane ZPlane;

    /** W row. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix, SaveGame)
    FPlane WPlane;
};

/** A 4x4 matrix, row vectors times matrix. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FMatrix44f {
    /** X row. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix44f, SaveGame)
    FPlane4f XPlane;

    /** Y row. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix44f, SaveGame)
    FPlane4f YPlane;

    /** Z row. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix44f, SaveGame)
    FPlane4f ZPlane;

    /** W row. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix44f, SaveGame)
    FPlane4f WPlane;
};

/** An axis-aligned box. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FBox {
    /** Smallest corner. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box, SaveGame)
    FVector Min;

    /** Largest corner. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box, SaveGame)
    FVector Max;

    /** 1 if the box holds a point. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box, SaveGame)
    uint8 IsValid;
};

/** An axis-aligned box. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FBox3f {
    /** Smallest corner. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box3f, SaveGame)
    FVector3f Min;

    /** Largest corner. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box3f, SaveGame)
    FVector3f Max;

    /** 1 if the box holds a point. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box3f, SaveGame)
    uint8 IsValid;
};

/** An axis-aligned rectangle. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FBox2D {
    /** Smallest corner. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2D, SaveGame)
    FVector2D Min;

    /** Largest corner. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2D, SaveGame)
    FVector2D Max;

    /** True if the rectangle holds a point. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2D, SaveGame)
    bool bIsValid;
};

/** An axis-aligned rectangle. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FBox2f {
    /** Smallest corner. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2f, SaveGame)
    FVector2f Min;

    /** Largest corner. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2f, SaveGame)
    FVector2f Max;

    /** True if the rectangle holds a point. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2f, SaveGame)
    bool bIsValid;
};

/** A box and a sphere about the same origin. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FBoxSphereBounds {
    /** Centre of both. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds, SaveGame)
    FVector Origin;

    /** Half size of the box. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds, SaveGame)
    FVector BoxExtent;

    /** Radius of the sphere. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds, SaveGame)
    double SphereRadius;
};

/** A box and a sphere about the same origin. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FBoxSphereBounds3f {
    /** Centre of both. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds3f, SaveGame)
    FVector3f Origin;

    /** Half size of the box. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds3f, SaveGame)
    FVector3f BoxExtent;

    /** Radius of the sphere. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds3f, SaveGame)
    float SphereRadius;
};

/** A sphere. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FSphere {
    /** Centre. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Sphere, SaveGame)
    FVector Center;

    /** Radius. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Sphere, SaveGame)
    double W;
};

/** A sphere. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FSphere3f {
    /** Centre. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Sphere3f, SaveGame)
    FVector3f Center;

    /** Radius. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Sphere3f, SaveGame)
    float W;
};

/** A ray. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FRay {
    /** Start. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Ray, SaveGame)
    FVector Origin;

    /** Direction of length 1. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Ray, SaveGame)
    FVector Direction;
};

/** A ray. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FRay3f {
    /** Start. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Ray3f, SaveGame)
    FVector3f Origin;

    /** Direction of length 1. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Ray3f, SaveGame)
    FVector3f Direction;
};

/** A point in 2D space with integer coordinates. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FIntPoint {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntPoint, SaveGame)
    int32 X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntPoint, SaveGame)
    int32 Y;
};

/** A 2D vector with integer components. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FIntVector2 {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector2, SaveGame)
    int32 X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector2, SaveGame)
    int32 Y;
};

/** A point in 3D space with integer coordinates. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FIntVector {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector, SaveGame)
    int32 X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector, SaveGame)
    int32 Y;

    /** Z component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector, SaveGame)
    int32 Z;
};

/** A 4D vector with integer components. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FIntVector4 {
    /** X component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector4, SaveGame)
    int32 X;

    /** Y component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector4, SaveGame)
    int32 Y;

    /** Z component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector4, SaveGame)
    int32 Z;

    /** W component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector4, SaveGame)
    int32 W;
};

/** A colour with 8 bits per channel, stored as B, G, R, A, gamma encoded. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FColor {
    /** Blue. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Color, SaveGame)
    uint8 B;

    /** Green. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Color, SaveGame)
    uint8 G;

    /** Red. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Color, SaveGame)
    uint8 R;

    /** Alpha, 255 is opaque. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Color, SaveGame)
    uint8 A;
};

/** A linear colour with floating-point channels. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FLinearColor {
    /** Red. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = LinearColor, SaveGame)
    float R;

    /** Green. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = LinearColor, SaveGame)
    float G;

    /** Blue. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = LinearColor, SaveGame)
    float B;

    /** Alpha, 1 is opaque. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = LinearColor, SaveGame)
    float A;
};

/** A repeatable sequence of random numbers. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FRandomStream {
    /** Seed the sequence started with. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = RandomStream, SaveGame)
    int32 InitialSeed;

    /** Current state. */
    UPROPERTY()
    int32 Seed;
};

/** A globally unique identifier. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FGuid {
    /** Part 1 of 4. */
    UPROPERTY(EditAnywhere, Category = Guid, SaveGame)
    int32 A;

    /** Part 2 of 4. */
    UPROPERTY(EditAnywhere, Category = Guid, SaveGame)
    int32 B;

    /** Part 3 of 4. */
    UPROPERTY(EditAnywhere, Category = Guid, SaveGame)
    int32 C;

    /** Part 4 of 4. */
    UPROPERTY(EditAnywhere, Category = Guid, SaveGame)
    int32 D;
};

/** A date and time in ticks of 100 ns since 1 January 0001. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FDateTime {
    /** Ticks of 100 ns. */
    UPROPERTY(SaveGame)
    int64 Ticks;
};

/** A time span in ticks of 100 ns. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FTimespan {
    /** Ticks of 100 ns. */
    UPROPERTY(SaveGame)
    int64 Ticks;
};

/** Package and name of a top-level object. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FTopLevelAssetPath {
    /** Package, for instance /Game/Maps/Town. */
    UPROPERTY(EditAnywhere, Category = TopLevelAssetPath)
    FName PackageName;

    /** Name of the object in the package. */
    UPROPERTY(EditAnywhere, Category = TopLevelAssetPath)
    FName AssetName;
};

/** Path of an object that may not be loaded. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults, immutable)
struct FSoftObjectPath {
    /** The asset. */
    UPROPERTY()
    FTopLevelAssetPath AssetPath;

    /** Path of an object inside the asset, or empty. */
    UPROPERTY()
    FString SubPathString;
};

/** Path of a class that may not be loaded. */
USTRUCT(noexport, BlueprintType, IsAlwaysAccessible, HasDefaults)
struct FSoftClassPath : public FSoftObjectPath {};

/** The base class of all reflected objects. */
UCLASS(abstract, noexport, MatchedSerializers)
class UObject {
    GENERATED_BODY()

public:
    /** Base of constructors that take an initializer. */
    UObject(const FObjectInitializer& ObjectInitializer);
};

#endif
