// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"

#include "Door.generated.h"

class USceneComponent;
class UStaticMeshComponent;

/** A door on a hinge, 90 centimetres wide and 200 high. Nothing in this file or beside it knows that SPEAR exists. */
UCLASS(Blueprintable)
class DOOR_API ADoor : public AActor {
    GENERATED_BODY()

public:
    ADoor();

    /** Opens the door to an angle in degrees; 0 is closed, and it turns no further than MaxAngle to either side. */
    UFUNCTION(BlueprintCallable, Category = "Door")
    void Open(float Angle = 90.0f);

    /** How far the door is open, in degrees. */
    UFUNCTION(BlueprintPure, Category = "Door")
    float GetAngle() const;

    /** How far it can turn to either side, in degrees. */
    UPROPERTY(EditAnywhere, Category = "Door")
    float MaxAngle = 120.0f;

private:
    /** Where the door hangs: turns about Z. */
    UPROPERTY(VisibleAnywhere, Category = "Door")
    TObjectPtr<USceneComponent> Hinge;

    /** The leaf, hung on the hinge by one edge. */
    UPROPERTY(VisibleAnywhere, Category = "Door")
    TObjectPtr<UStaticMeshComponent> Leaf;
};
