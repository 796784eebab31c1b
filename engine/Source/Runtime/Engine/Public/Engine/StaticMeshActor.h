// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "GameFramework/Actor.h"
#include "UObject/ObjectMacros.h"

#include "StaticMeshActor.generated.h"

class UStaticMeshComponent;

/** An actor that shows a static mesh; static by default. Epic page: AStaticMeshActor. */
UCLASS(HideCategories = (Input), ShowCategories = ("Input|MouseInput", "Input|TouchInput"), ComponentWrapperClass,
    Blueprintable)
class ENGINE_API AStaticMeshActor : public AActor {
    GENERATED_BODY()

private:
    /** The mesh's component, the root of this actor. */
    UPROPERTY(Category = StaticMeshActor, VisibleAnywhere, BlueprintReadOnly,
        meta = (ExposeFunctionCategories = "Mesh,Rendering,Physics,Components|StaticMesh", AllowPrivateAccess = "true"))
    TObjectPtr<UStaticMeshComponent> StaticMeshComponent;

public:
    AStaticMeshActor(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets how often the mesh is allowed to move. */
    UFUNCTION(BlueprintCallable, Category = "Mobility")
    void SetMobility(EComponentMobility::Type InMobility);

    /** The mesh's component. */
    UStaticMeshComponent* GetStaticMeshComponent() const { return StaticMeshComponent; }
};
