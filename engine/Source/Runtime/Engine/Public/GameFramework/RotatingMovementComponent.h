// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/MovementComponent.h"
#include "UObject/ObjectMacros.h"

#include "RotatingMovementComponent.generated.h"

/** Turns the updated component at a constant rate, optionally about a pivot. Epic page: URotatingMovementComponent. */
UCLASS(ClassGroup = Movement, meta = (BlueprintSpawnableComponent), HideCategories = Velocity)
class ENGINE_API URotatingMovementComponent : public UMovementComponent {
    GENERATED_BODY()

public:
    /** How fast to update roll/pitch/yaw of the component we update, in degrees per second. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = RotatingComponent)
    FRotator RotationRate;

    /** Translation of pivot point around which we rotate, relative to the current rotation, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = RotatingComponent)
    FVector PivotTranslation;

    /** Whether rotation is applied in local or world space. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = RotatingComponent)
    uint32 bRotationInLocalSpace : 1;

    URotatingMovementComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    virtual void TickComponent(
        float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override;
};
