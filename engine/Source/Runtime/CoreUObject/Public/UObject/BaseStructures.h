// SPDX-License-Identifier: MIT
// TBaseStructure of the core types that "UObject/NoExportTypes.h" reflects. In UE part of "UObject/Class.h", which
// includes this file.
#pragma once

#include "Math/MathFwd.h"
#include "UObject/Class.h"

struct FDateTime;
struct FGuid;
struct FSoftClassPath;
struct FSoftObjectPath;
struct FTimespan;
struct FTopLevelAssetPath;

template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FVector>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FVector2D>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FVector4>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FRotator>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FQuat>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FTransform>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FMatrix>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FPlane>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FBox>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FBox2D>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FBoxSphereBounds>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FSphere>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FRay>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FVector3f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FVector2f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FVector4f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FRotator3f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FQuat4f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FTransform3f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FMatrix44f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FPlane4f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FBox3f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FBox2f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FBoxSphereBounds3f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FRay3f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FSphere3f>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FIntPoint>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FIntVector>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FIntVector2>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FIntVector4>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FLinearColor>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FColor>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FRandomStream>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FGuid>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FDateTime>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FTimespan>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FTopLevelAssetPath>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FSoftObjectPath>::Get();
template <>
COREUOBJECT_API UScriptStruct* TBaseStructure<FSoftClassPath>::Get();
