// SPDX-License-Identifier: MIT
// What reflection may assume about the core types (see TStructOpsTypeTraits). In UE these stand beside each type's
// property source.
#pragma once

#include "CoreMinimal.h"
#include "UObject/SoftObjectPath.h"
#include "UObject/StructOps.h"

namespace UE::CoreUObject::Private {
/** Values that are all zero when fresh. */
template <typename T>
struct TZeroStructTraits : public TStructOpsTypeTraitsBase2<T> {
    enum {
        WithZeroConstructor = true,
        WithIdenticalViaEquality = true,
    };
};
/** Values whose fresh state is their default constructor's. */
template <typename T>
struct TDefaultedStructTraits : public TStructOpsTypeTraitsBase2<T> {
    enum {
        WithIdenticalViaEquality = true,
    };
};
} // namespace UE::CoreUObject::Private

#define UE_ZERO_STRUCT(Type)                                                                                           \
    template <>                                                                                                        \
    struct TStructOpsTypeTraits<Type> : public UE::CoreUObject::Private::TZeroStructTraits<Type> {};
#define UE_DEFAULTED_STRUCT(Type)                                                                                      \
    template <>                                                                                                        \
    struct TStructOpsTypeTraits<Type> : public UE::CoreUObject::Private::TDefaultedStructTraits<Type> {};

UE_ZERO_STRUCT(FVector)
UE_ZERO_STRUCT(FVector3f)
UE_ZERO_STRUCT(FVector2D)
UE_ZERO_STRUCT(FVector2f)
UE_ZERO_STRUCT(FVector4)
UE_ZERO_STRUCT(FVector4f)
UE_ZERO_STRUCT(FPlane)
UE_ZERO_STRUCT(FPlane4f)
UE_ZERO_STRUCT(FRotator)
UE_ZERO_STRUCT(FRotator3f)
UE_ZERO_STRUCT(FIntPoint)
UE_ZERO_STRUCT(FIntVector2)
UE_ZERO_STRUCT(FIntVector)
UE_ZERO_STRUCT(FIntVector4)
UE_ZERO_STRUCT(FLinearColor)
UE_ZERO_STRUCT(FBox)
UE_ZERO_STRUCT(FBox3f)
UE_ZERO_STRUCT(FBox2D)
UE_ZERO_STRUCT(FDateTime)
UE_ZERO_STRUCT(FTimespan)
UE_ZERO_STRUCT(FColor)
UE_DEFAULTED_STRUCT(FQuat)
UE_DEFAULTED_STRUCT(FQuat4f)

/** "0123456789ABCDEF0123456789ABCDEF" instead of four members. */
template <>
struct TStructOpsTypeTraits<FGuid> : public TStructOpsTypeTraitsBase2<FGuid> {
    enum {
        WithZeroConstructor = true,
        WithIdenticalViaEquality = true,
        WithExportTextItem = true,
        WithImportTextItem = true,
    };
};
/** "/Package.Asset:Sub" instead of members. */
template <>
struct TStructOpsTypeTraits<FSoftObjectPath> : public TStructOpsTypeTraitsBase2<FSoftObjectPath> {
    enum {
        WithZeroConstructor = true,
        WithIdenticalViaEquality = true,
        WithExportTextItem = true,
        WithImportTextItem = true,
    };
};
template <>
struct TStructOpsTypeTraits<FSoftClassPath> : public TStructOpsTypeTraitsBase2<FSoftClassPath> {
    enum {
        WithZeroConstructor = true,
        WithExportTextItem = true,
        WithImportTextItem = true,
    };
};

#undef UE_ZERO_STRUCT
#undef UE_DEFAULTED_STRUCT
