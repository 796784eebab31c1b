// SPDX-License-Identifier: MIT
/** @file Actors without a body. Mirrors UE's GameFramework/Info.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "UObject/ObjectMacros.h"

#include "Info.generated.h"

/**
 * Info is the base class of an Actor that isn't meant to have a physical representation in the world, used primarily
 * for "manager" type classes that hold settings data about the world, but might need to be an Actor for replication
 * purposes.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AInfo
 */
UCLASS(Abstract,
    HideCategories = (Input, Movement, Collision, Rendering, HLOD, WorldPartition, DataLayers, Transformation),
    NotBlueprintable,
    meta = (ShowInLevelEditor = false, ShortTooltip = "A class that holds settings data about the world."))
class ENGINE_API AInfo : public AActor {
    GENERATED_BODY()

public:
    AInfo(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());
};
