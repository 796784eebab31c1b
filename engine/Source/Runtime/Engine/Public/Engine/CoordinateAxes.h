// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"

#include "CoordinateAxes.generated.h"

class USceneComponent;
class UStaticMeshComponent;

/**
 * Three arrows that show where an actor is and how it is turned: X red, Y green, Z blue, each 100 centimetres long at
 * scale 1.
 *
 * Embedded engine only. The arrows are UStaticMeshComponents below a plain root component, with the mesh
 * "/Engine/BasicShapes/Arrow.Arrow" (along +X) and unlit-looking emissive materials.
 */
UCLASS(Blueprintable)
class ENGINE_API ACoordinateAxes : public AActor {
    GENERATED_BODY()

public:
    ACoordinateAxes(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The root: its location and rotation are what the arrows show. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Category = "CoordinateAxes")
    TObjectPtr<USceneComponent> AxesRoot;

    /** Red arrow along +X. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Category = "CoordinateAxes")
    TObjectPtr<UStaticMeshComponent> XAxis;

    /** Green arrow along +Y. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Category = "CoordinateAxes")
    TObjectPtr<UStaticMeshComponent> YAxis;

    /** Blue arrow along +Z. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Category = "CoordinateAxes")
    TObjectPtr<UStaticMeshComponent> ZAxis;
};
