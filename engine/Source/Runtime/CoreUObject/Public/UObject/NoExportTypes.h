// SPDX-License-Identifier: MIT
// Reflection of types that are plain C++ elsewhere: the mathematical core, dates, paths, and UObject itself. The header tool reads the
// declarations under `#if !CPP`; the compiler never sees them, but checks that size and alignment agree. Mirrors Epic's
// "UObject/NoExportTypes.h".
#pragma once

#include "CoreMinimal.h"
#include "Math/RandomStream.h"
#include "Misc/DateTime.h"
#include "Misc/Guid.h"
#include "Misc/Timespan.h"
#include "UObject/ObjectMacros.h"
#include "UObject/SoftObjectPath.h"
#include "UObject/TopLevelAssetPath.h"
#include "UObject/NoExportTypes.generated.h"

#if !CPP

/** The base class of all UE objects. */
UCLASS(Abstract, NoExport, BlueprintType)
class UObject
{
};

/** An axis of a coordinate system. */
UENUM(BlueprintType)
namespace EAxis
{
enum Type : int
{
    None,
    X,
    Y,
    Z,
};
}

/** Whether letters compare with their case. */
UENUM(BlueprintType)
namespace ESearchCase
{
enum Type : int
{
    CaseSensitive,
    IgnoreCase,
};
}

/** Where a search begins. */
UENUM(BlueprintType)
namespace ESearchDir
{
enum Type : int
{
    FromStart,
    FromEnd,
};
}

/** A globally unique identifier. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FGuid
{
    UPROPERTY(EditAnywhere, SaveGame, Category = Guid)
    int32 A;
    UPROPERTY(EditAnywhere, SaveGame, Category = Guid)
    int32 B;
    UPROPERTY(EditAnywhere, SaveGame, Category = Guid)
    int32 C;
    UPROPERTY(EditAnywhere, SaveGame, Category = Guid)
    int32 D;
};

/** A point or direction in 3D space, in centimetres where it is a place. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FVector
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    double X;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    double Y;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    double Z;
};

/** A point or direction in 3D space, in single precision. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FVector3f
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    float X;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    float Y;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector, SaveGame)
    float Z;
};

/** A 4-D homogeneous vector. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FVector4
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4, SaveGame)
    double X;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4, SaveGame)
    double Y;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4, SaveGame)
    double Z;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector4, SaveGame)
    double W;
};

/** A vector in 2D space. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FVector2D
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector2D, SaveGame)
    double X;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Vector2D, SaveGame)
    double Y;
};

/** A plane in 3D space: X, Y, Z is the normal, W the distance from the origin. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FPlane : public FVector
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Plane, SaveGame)
    double W;
};

/** A rotation in degrees. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FRotator
{
    /** Rotation about the right axis (Y), degrees: looking up and down. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator, SaveGame)
    double Pitch;
    /** Rotation about the up axis (Z), degrees: turning. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator, SaveGame)
    double Yaw;
    /** Rotation about the forward axis (X), degrees: tilting the head. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rotator, SaveGame)
    double Roll;
};

/** A rotation as a unit quaternion. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FQuat
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat, SaveGame)
    double X;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat, SaveGame)
    double Y;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat, SaveGame)
    double Z;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Quat, SaveGame)
    double W;
};

/** Scale, then rotation, then translation. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FTransform
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform, SaveGame)
    FQuat Rotation;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform, SaveGame)
    FVector Translation;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Transform, SaveGame)
    FVector Scale3D;
};

/** A 4x4 matrix for row vectors: the planes are its rows. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FMatrix
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix, SaveGame)
    FPlane XPlane;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix, SaveGame)
    FPlane YPlane;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix, SaveGame)
    FPlane ZPlane;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Matrix, SaveGame)
    FPlane WPlane;
};

/** An axis-aligned box. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FBox
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box, SaveGame)
    FVector Min;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box, SaveGame)
    FVector Max;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box, SaveGame)
    uint8 IsValid;
};

/** An axis-aligned rectangle. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FBox2D
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2D, SaveGame)
    FVector2D Min;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2D, SaveGame)
    FVector2D Max;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Box2D, SaveGame)
    uint8 bIsValid;
};

/** A sphere. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FSphere
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Sphere, SaveGame)
    FVector Center;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Sphere, SaveGame)
    double W;
};

/** A box and a sphere around the same thing. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FBoxSphereBounds
{
    /** Centre of both. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds, SaveGame)
    FVector Origin;
    /** Half the size of the box. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds, SaveGame)
    FVector BoxExtent;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = BoxSphereBounds, SaveGame)
    double SphereRadius;
};

/** An 8-bit sRGB colour. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FColor
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Color, SaveGame)
    uint8 B;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Color, SaveGame)
    uint8 G;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Color, SaveGame)
    uint8 R;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Color, SaveGame)
    uint8 A;
};

/** A colour in linear light. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FLinearColor
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = LinearColor, SaveGame)
    float R;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = LinearColor, SaveGame)
    float G;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = LinearColor, SaveGame)
    float B;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = LinearColor, SaveGame)
    float A;
};

/** A point with whole numbers. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FIntPoint
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntPoint, SaveGame)
    int32 X;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntPoint, SaveGame)
    int32 Y;
};

/** A vector with whole numbers. */
USTRUCT(BlueprintType, Atomic, NoExport, HasDefaults)
struct FIntVector
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector, SaveGame)
    int32 X;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector, SaveGame)
    int32 Y;
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = IntVector, SaveGame)
    int32 Z;
};

/** A stream of random numbers that a seed determines. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FRandomStream
{
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = RandomStream, SaveGame)
    int32 InitialSeed;
    UPROPERTY()
    int32 Seed;
};

/** A moment. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FDateTime
{
    UPROPERTY()
    int64 Ticks;
};

/** A difference of two moments. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FTimespan
{
    UPROPERTY()
    int64 Ticks;
};

/** Package and name of an asset. */
USTRUCT(BlueprintType, NoExport)
struct FTopLevelAssetPath
{
    /** Name of the package containing the asset, e.g. /Path/To/Package. */
    UPROPERTY(EditAnywhere, Category = TopLevelAssetPath)
    FName PackageName;
    /** Name of the asset within the package. */
    UPROPERTY(EditAnywhere, Category = TopLevelAssetPath)
    FName AssetName;
};

/** The path of an object that may not be loaded. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FSoftObjectPath
{
    /** Package and name of the asset. */
    UPROPERTY()
    FTopLevelAssetPath AssetPath;
    /** Path of an object inside the asset, if it is not the asset itself. */
    UPROPERTY()
    FString SubPathString;
};

/** The path of a class that may not be loaded. */
USTRUCT(BlueprintType, NoExport, HasDefaults)
struct FSoftClassPath : public FSoftObjectPath
{
};

#endif
