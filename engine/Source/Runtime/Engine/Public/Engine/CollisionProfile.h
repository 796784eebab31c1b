// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"

#include "CollisionProfile.generated.h"

/** A named set of collision settings. Epic page: FCollisionResponseTemplate. */
USTRUCT()
struct ENGINE_API FCollisionResponseTemplate {
    GENERATED_BODY()

    /** Name of the profile. */
    UPROPERTY()
    FName Name;

    /** What a body with this profile takes part in. */
    UPROPERTY()
    TEnumAsByte<ECollisionEnabled::Type> CollisionEnabled;

    /** Whether projects may change it. */
    UPROPERTY()
    bool bCanModify;

    /** Name of the object type. */
    UPROPERTY()
    FName ObjectTypeName;

    /** The object type. */
    TEnumAsByte<enum ECollisionChannel> ObjectType;

    /** The responses to the channels. */
    FCollisionResponseContainer ResponseToChannels;

    FCollisionResponseTemplate();
};

/**
 * The collision profiles of the engine: the ones every UE project starts with.
 * Epic pages: UCollisionProfile, "Collision Response Reference".
 */
UCLASS()
class ENGINE_API UCollisionProfile : public UObject {
    GENERATED_BODY()

public:
    /** Default profile names that the engine's own classes use. */
    static const FName NoCollision_ProfileName;
    static const FName BlockAll_ProfileName;
    static const FName PhysicsActor_ProfileName;
    static const FName BlockAllDynamic_ProfileName;
    static const FName Pawn_ProfileName;
    /** The name of a body whose settings come from no profile. */
    static const FName CustomCollisionProfileName;

    /** The profiles. */
    static UCollisionProfile* Get();

    /** Finds a profile by name; returns whether there is one and copies it. */
    bool GetProfileTemplate(FName ProfileName, FCollisionResponseTemplate& ProfileData) const;

    UCollisionProfile(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

private:
    /** The profiles. */
    UPROPERTY()
    TArray<FCollisionResponseTemplate> Profiles;
};
