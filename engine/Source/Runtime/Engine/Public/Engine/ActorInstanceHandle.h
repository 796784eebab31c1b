// SPDX-License-Identifier: MIT
/** @file Handle to an actor in a hit result. Mirrors UE's Engine/ActorInstanceHandle.h. */
#pragma once

#include "CoreMinimal.h"
#include "UObject/Class.h"
#include "UObject/WeakObjectPtrTemplates.h"

#include "ActorInstanceHandle.generated.h"

class AActor;

/**
 * Handle to a unique object. It may specify a full weight actor or a light weight instance in UE; here it is always an
 * actor.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FActorInstanceHandle
 */
USTRUCT(BlueprintType)
struct FActorInstanceHandle {
    GENERATED_BODY()

    FActorInstanceHandle() = default;
    ENGINE_API explicit FActorInstanceHandle(AActor* InActor);

    /** Whether the handle refers to a live actor. */
    ENGINE_API bool IsValid() const;
    /** Whether the handle refers to an actor of the given class. */
    ENGINE_API bool DoesRepresentClass(const UClass* OtherClass) const;
    /** World location in centimetres; zero when the actor is gone. */
    ENGINE_API FVector GetLocation() const;
    /** World rotation; zero when the actor is gone. */
    ENGINE_API FRotator GetRotation() const;
    /** Name of the actor, NAME_None when it is gone. */
    ENGINE_API FName GetFName() const;
    /** Name of the actor, empty when it is gone. */
    ENGINE_API FString GetName() const;
    /** The actor this stands for, or null. */
    ENGINE_API AActor* FetchActor() const;
    /** The actor cast to T, or null. */
    template <typename T>
    T* FetchActor() const {
        return Cast<T>(FetchActor());
    }

    ENGINE_API bool operator==(const FActorInstanceHandle& Other) const;
    bool operator!=(const FActorInstanceHandle& Other) const { return !(*this == Other); }
    ENGINE_API bool operator==(const AActor* OtherActor) const;
    bool operator!=(const AActor* OtherActor) const { return !(*this == OtherActor); }

    friend uint32 GetTypeHash(const FActorInstanceHandle& Handle) { return GetTypeHash(Handle.Actor); }

private:
    /** This is cached here for convenience. */
    UPROPERTY()
    TWeakObjectPtr<AActor> Actor;
};
