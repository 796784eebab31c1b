// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "UObject/ObjectMacros.h"

#include "CameraActor.generated.h"

class UCameraComponent;

/** A camera that can be placed in a level. Epic page: ACameraActor. */
UCLASS(ClassGroup = Common, HideCategories = (Input, Rendering),
    ShowCategories = ("Input|MouseInput", "Input|TouchInput"), Blueprintable)
class ENGINE_API ACameraActor : public AActor {
    GENERATED_BODY()

private:
    /** The camera component for this camera. */
    UPROPERTY(Category = CameraActor, VisibleAnywhere, BlueprintReadOnly, meta = (AllowPrivateAccess = "true"))
    TObjectPtr<UCameraComponent> CameraComponent;

    /** The root of this actor. */
    UPROPERTY(Category = CameraActor, VisibleAnywhere, BlueprintReadOnly, meta = (AllowPrivateAccess = "true"))
    TObjectPtr<USceneComponent> SceneComponent;

public:
    ACameraActor(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The camera component for this camera. */
    UCameraComponent* GetCameraComponent() const { return CameraComponent; }
};
