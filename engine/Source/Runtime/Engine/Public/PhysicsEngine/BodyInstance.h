// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "UObject/ObjectMacros.h"

#include "BodyInstance.generated.h"

class UPrimitiveComponent;

/**
 * The collision settings of a component: what it takes part in, its object type and its responses, or the profile they
 * come from. Mass, damping and the like belong to simulation and are absent. Epic page: FBodyInstance.
 */
USTRUCT(BlueprintType)
struct ENGINE_API FBodyInstance {
    GENERATED_BODY()

private:
    /** Name of the collision profile; `Custom` when the settings were changed one by one. */
    UPROPERTY(EditAnywhere, Category = Custom)
    FName CollisionProfileName;

    /** What collision the body takes part in. */
    UPROPERTY(EditAnywhere, Category = Custom)
    TEnumAsByte<ECollisionEnabled::Type> CollisionEnabled;

    /** The type of the body, by which others respond to it. */
    UPROPERTY(EditAnywhere, Category = Custom)
    TEnumAsByte<enum ECollisionChannel> ObjectType;

    /** How the body responds to each channel. */
    UPROPERTY(EditAnywhere, Category = Custom)
    FCollisionResponseContainer CollisionResponses;

public:
    /** The profile `Custom`: blocks everything, with query and physics. */
    FBodyInstance();

    /** Changes what the body takes part in; the profile becomes `Custom`. */
    void SetCollisionEnabled(ECollisionEnabled::Type NewType);
    /** What the body takes part in. */
    ECollisionEnabled::Type GetCollisionEnabled() const { return CollisionEnabled; }
    /** Changes the object type; the profile becomes `Custom`. */
    void SetObjectType(ECollisionChannel Channel);
    /** The object type. */
    ECollisionChannel GetObjectType() const { return ObjectType; }
    /** Changes one response; the profile becomes `Custom`. Returns whether anything changed. */
    bool SetResponseToChannel(ECollisionChannel Channel, ECollisionResponse NewResponse);
    /** Changes every response; the profile becomes `Custom`. Returns whether anything changed. */
    bool SetResponseToAllChannels(ECollisionResponse NewResponse);
    /** Replaces the responses; the profile becomes `Custom`. Returns whether anything changed. */
    bool SetResponseToChannels(const FCollisionResponseContainer& NewResponses);
    /** The response to a channel. */
    ECollisionResponse GetResponseToChannel(ECollisionChannel Channel) const {
        return CollisionResponses.GetResponse(Channel);
    }
    /** All responses. */
    const FCollisionResponseContainer& GetResponseToChannels() const { return CollisionResponses; }
    /** Takes every setting from a profile. A name that no profile has is kept, and the settings stay as they are. */
    void SetCollisionProfileName(FName InCollisionProfileName);
    /** The profile's name. */
    FName GetCollisionProfileName() const { return CollisionProfileName; }

private:
    void InvalidateCollisionProfileName();
};
