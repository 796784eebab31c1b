// SPDX-License-Identifier: MIT
/** @file Where players start. Mirrors UE's GameFramework/PlayerStart.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"

#include "PlayerStart.generated.h"

class UCapsuleComponent;

/**
 * This class indicates a location where a player can spawn when the game begins.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/APlayerStart
 */
UCLASS(Blueprintable, ClassGroup = Common, HideCategories = Collision)
class ENGINE_API APlayerStart : public AActor {
    GENERATED_BODY()

public:
    APlayerStart(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Used when searching for which playerstart to use. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Object)
    FName PlayerStartTag;

    /** Returns CapsuleComponent subobject. */
    UCapsuleComponent* GetCapsuleComponent() const { return CapsuleComponent; }

private:
    /** Capsule of the size of the player, centred on the start location. */
    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Category = NavigationObjectBase, meta = (AllowPrivateAccess = "true"))
    TObjectPtr<UCapsuleComponent> CapsuleComponent;
};
