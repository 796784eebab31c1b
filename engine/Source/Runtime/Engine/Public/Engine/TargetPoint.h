// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "UObject/ObjectMacros.h"

#include "TargetPoint.generated.h"

/** A place in the world, to be found by others. Epic page: ATargetPoint. */
UCLASS()
class ENGINE_API ATargetPoint : public AActor {
    GENERATED_BODY()

public:
    ATargetPoint(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());
};
