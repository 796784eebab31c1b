// SPDX-License-Identifier: MIT
/** @file Base class of everything that can be placed or spawned in a world. Mirrors UE's GameFramework/Actor.h. */
#pragma once

#include "Components/ActorComponent.h"
#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "Engine/HitResult.h"
#include "Templates/SubclassOf.h"
#include "UObject/Interface.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"
#include "UObject/ScriptDelegates.h"
#include "UObject/SparseDelegate.h"

#include "Actor.generated.h"

class AActor;
class AController;
class APawn;
class APlayerController;
class FTimerManager;
class UActorComponent;
class UGameInstance;
class ULevel;
class UPrimitiveComponent;
class USceneComponent;
class UWorld;
struct FMinimalViewInfo;

DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_TwoParams(
    FActorBeginOverlapSignature, AActor, OnActorBeginOverlap, AActor*, OverlappedActor, AActor*, OtherActor);
DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_TwoParams(
    FActorEndOverlapSignature, AActor, OnActorEndOverlap, AActor*, OverlappedActor, AActor*, OtherActor);
DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_FourParams(FActorHitSignature, AActor, OnActorHit, AActor*, SelfActor,
    AActor*, OtherActor, FVector, NormalImpulse, const FHitResult&, Hit);
DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_OneParam(
    FActorDestroyedSignature, AActor, OnDestroyed, AActor*, DestroyedActor);
DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_TwoParams(
    FActorEndPlaySignature, AActor, OnEndPlay, AActor*, Actor, EEndPlayReason::Type, EndPlayReason);

/** How far the play of an actor has got. */
enum class EActorBeginPlayState : uint8 {
    HasNotBegunPlay,
    BeginningPlay,
    HasBegunPlay,
};

/**
 * Actor is the base class for an Object that can be placed or spawned in a level.
 *
 * Actors may contain a collection of ActorComponents, which can be used to control how actors move, how they are
 * rendered, etc. Their transform is that of the root component.
 *
 * Life: spawned (constructor, PostSpawnInitialize, components registered), PreInitializeComponents, InitializeComponent
 * of the components, PostInitializeComponents, BeginPlay, ticks, EndPlay, Destroyed. A destroyed actor is out of the
 * world at once but lingers as an object, marked as garbage, until the garbage is collected.
 *
 * Locations in centimetres, rotations in degrees (left-handed, Z up).
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AActor
 */
UCLASS(BlueprintType, Blueprintable, config = Engine,
    meta = (ShortTooltip = "An Actor is an object that can be placed or spawned in the world."))
class ENGINE_API AActor : public UObject {
    GENERATED_BODY()

public:
    /** Default constructor for AActor. */
    AActor();
    /** Constructor for AActor that takes an ObjectInitializer for backward compatibility. */
    AActor(const FObjectInitializer& ObjectInitializer);

    // ------------------------------------------------------------------------------------------------------ properties

    /** Primary Actor tick function, which calls TickActor(). */
    UPROPERTY(EditDefaultsOnly, Category = Tick)
    FActorTickFunction PrimaryActorTick;

    /** Allow each actor to run at a different time speed. The DeltaTime for a frame is multiplied by the global
     * TimeDilation (in WorldSettings) and this CustomTimeDilation for this actor's tick. */
    UPROPERTY(BlueprintReadWrite, AdvancedDisplay, Category = Actor)
    float CustomTimeDilation;

    /** How long this Actor lives before dying, 0 = forever. Note this is the INITIAL value and should not be modified
     * once play has begun. Seconds. */
    UPROPERTY(EditDefaultsOnly, BlueprintReadOnly, Category = Actor)
    float InitialLifeSpan;

    /** If true, this actor should search for an owned camera component to view through when used as a view target. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, AdvancedDisplay, Category = Actor)
    uint8 bFindCameraComponentWhenViewTarget : 1;

    /** Controls how to handle spawning this actor in a situation where it's colliding with something else. "Default"
     * means AlwaysSpawn here. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, AdvancedDisplay, Category = Actor)
    ESpawnActorCollisionHandlingMethod SpawnCollisionHandlingMethod;

    /** Array of tags that can be used for grouping and categorizing. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, AdvancedDisplay, Category = Actor)
    TArray<FName> Tags;

    /** Array of all Actors whose Owner is this actor, these are not necessarily spawned by UChildActorComponent. */
    UPROPERTY(Transient)
    TArray<TObjectPtr<AActor>> Children;

    /** Called when another actor begins to overlap this actor, for example a player walking into a trigger. */
    UPROPERTY(BlueprintAssignable, Category = "Collision")
    FActorBeginOverlapSignature OnActorBeginOverlap;

    /** Called when another actor stops overlapping this actor. */
    UPROPERTY(BlueprintAssignable, Category = "Collision")
    FActorEndOverlapSignature OnActorEndOverlap;

    /** Called when this Actor hits (or is hit by) something solid. */
    UPROPERTY(BlueprintAssignable, Category = "Collision")
    FActorHitSignature OnActorHit;

    /** Event triggered when the actor has been explicitly destroyed. */
    UPROPERTY(BlueprintAssignable, Category = "Game")
    FActorDestroyedSignature OnDestroyed;

    /** Event triggered when the actor is being deleted or removed from a level. */
    UPROPERTY(BlueprintAssignable, Category = "Game")
    FActorEndPlaySignature OnEndPlay;

protected:
    /** The component that defines the transform (location, rotation, scale) of this Actor in the world, all other
     * components must be attached to this one somehow. */
    UPROPERTY(BlueprintGetter = K2_GetRootComponent, Category = "Transformation")
    TObjectPtr<USceneComponent> RootComponent;

    /** Pawn responsible for damage and other gameplay events caused by this actor. */
    UPROPERTY(BlueprintReadWrite, Category = Actor, meta = (ExposeOnSpawn = "true"))
    TObjectPtr<APawn> Instigator;

private:
    /** Owner of this Actor, used primarily for replication (bNetUseOwnerRelevancy & bOnlyRelevantToOwner) and
     * visibility (PrimitiveComponent bOwnerNoSee and bOnlyOwnerSee). */
    UPROPERTY()
    TObjectPtr<AActor> Owner;

    /** Allows us to only see this Actor in the Editor, and not in the actual game. */
    UPROPERTY(Interp, EditAnywhere, Category = Rendering, BlueprintReadOnly,
        meta = (AllowPrivateAccess = "true", DisplayName = "Actor Hidden In Game",
            SequencerTrackClass = "/Script/MovieSceneTracks.MovieSceneVisibilityTrack"))
    uint8 bHidden : 1;

    /** Enables any collision on this actor. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Collision, meta = (AllowPrivateAccess = "true"))
    uint8 bActorEnableCollision : 1;

    /** If true then destroy self when "finished", meaning all relevant components report that they are done and no
     * timelines or timers are in flight. */
    UPROPERTY(BlueprintReadWrite, Category = Actor, meta = (AllowPrivateAccess = "true"))
    uint8 bAutoDestroyWhenFinished : 1;

    /** Array of ActorComponents that are created by blueprints and serialized per-instance. */
    UPROPERTY(TextExportTransient, NonTransactional)
    TArray<TObjectPtr<UActorComponent>> BlueprintCreatedComponents;

    /** Array of ActorComponents that have been added by the user on a per-instance basis. */
    UPROPERTY(Instanced)
    TArray<TObjectPtr<UActorComponent>> InstanceComponents;

public:
    // ------------------------------------------------------------------------------------------------- hidden,
    // collision

    /** Sets the actor to be hidden in the game. @param bNewHidden whether or not to hide the actor and all its
     * components. */
    UFUNCTION(BlueprintCallable, Category = "Rendering",
        meta = (DisplayName = "Set Actor Hidden In Game", Keywords = "Visible Hidden Show Hide"))
    virtual void SetActorHiddenInGame(bool bNewHidden);

    /** Returns whether this actor is hidden in game. */
    bool IsHidden() const { return bHidden; }
    /** Directly writes bHidden; SetActorHiddenInGame also updates the components. */
    void SetHidden(const bool bInHidden) { bHidden = bInHidden; }

    /** Allows enabling/disabling collision for the whole actor. */
    UFUNCTION(BlueprintCallable, Category = "Collision")
    void SetActorEnableCollision(bool bNewActorEnableCollision);

    /** Get current state of collision for the whole actor. */
    UFUNCTION(BlueprintPure, Category = "Collision")
    bool GetActorEnableCollision() const;

    // ------------------------------------------------------------------------------------------------- destroy,
    // lifetime

    /** Destroy the actor. */
    UFUNCTION(BlueprintCallable, Category = "Actor",
        meta = (Keywords = "Delete", DisplayName = "Destroy Actor", ScriptName = "DestroyActor"))
    virtual void K2_DestroyActor();

    /**
     * Destroy this actor. Returns true the actor is destroyed or already marked for destruction, false if
     * indestructible.
     * @param bNetForce not used without network.
     * @param bShouldModifyLevel not used outside of an editor.
     */
    bool Destroy(bool bNetForce = false, bool bShouldModifyLevel = true);

    /** Returns true if this actor has begun the destruction process. */
    UFUNCTION(BlueprintCallable, Category = "Game", meta = (DisplayName = "Is Actor Being Destroyed"))
    bool IsActorBeingDestroyed() const { return bActorIsBeingDestroyed; }

    /** Set the lifespan of this actor. When it expires the object will be destroyed. If requested lifespan is 0, the
     * timer is cleared and the actor will not be destroyed. Seconds. */
    UFUNCTION(BlueprintCallable, Category = "Utilities", meta = (Keywords = "delete destroy"))
    virtual void SetLifeSpan(float InLifespan);

    /** Get the remaining lifespan of this actor, in seconds. If zero is returned the actor lives forever. */
    UFUNCTION(BlueprintCallable, Category = "Utilities", meta = (Keywords = "delete destroy"))
    virtual float GetLifeSpan() const;

    /** Destroys the actor if it is below the KillZ of the world settings. Movement components call it. @return whether
     * the actor is still there. */
    virtual bool CheckStillInWorld();

    /** Called when the lifespan of an actor expires (if he has one). */
    virtual void LifeSpanExpired();

    /** Set if this actor should automatically destroy itself when finished. */
    void SetAutoDestroyWhenFinished(bool bVal) { bAutoDestroyWhenFinished = bVal; }
    bool GetAutoDestroyWhenFinished() const { return bAutoDestroyWhenFinished; }

    /** The number of seconds (in game time) since this Actor was created, relative to Get Game Time In Seconds. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Time")
    float GetGameTimeSinceCreation() const;

    // ------------------------------------------------------------------------------------------------------ network
    // role

    /** Returns whether this actor has network authority: always, without network. */
    UFUNCTION(BlueprintCallable, Category = "Networking")
    bool HasAuthority() const;

    /** Returns how much control the local machine has over this actor. */
    UFUNCTION(BlueprintCallable, Category = "Networking")
    ENetRole GetLocalRole() const { return ROLE_Authority; }

    /** Returns how much control the remote machine has over this actor. */
    UFUNCTION(BlueprintCallable, Category = "Networking")
    ENetRole GetRemoteRole() const { return ROLE_None; }

    /** Get the network mode of the world of this actor. */
    ENetMode GetNetMode() const { return NM_Standalone; }

    // --------------------------------------------------------------------------------------------------------
    // components

    /**
     * Creates a new component and assigns ownership to the Actor this is called for. Automatic attachment causes the
     * first component created to become the root, and all subsequent components to be attached under that root. When
     * bManualAttachment is set, automatic attachment is skipped and it is up to the user to attach the resulting
     * component (or set it up as the root) themselves.
     *
     * @param Class class of component to create.
     * @param bManualAttachment whether manual or automatic attachment is to be used.
     * @param RelativeTransform relative transform between the new component and its attach parent (automatic only).
     * @param bDeferredFinish whether or not to immediately complete the creation and registration process for this
     * component. FinishAddComponent must be called.
     */
    UFUNCTION(
        BlueprintCallable, Category = Actor, meta = (BlueprintInternalUseOnly = "true", DeterminesOutputType = "Class"))
    UActorComponent* AddComponentByClass(UPARAM(meta = (AllowAbstract = "false")) TSubclassOf<UActorComponent> Class,
        bool bManualAttachment, const FTransform& RelativeTransform, bool bDeferredFinish);

    /** Completes the creation of a new actor component. Called either from AddComponentByClass, or after setting
     * exposed properties of a component with bDeferredFinish. */
    UFUNCTION(BlueprintCallable, Category = Actor, meta = (BlueprintInternalUseOnly = "true"))
    void FinishAddComponent(UActorComponent* Component, bool bManualAttachment, const FTransform& RelativeTransform);

    /** Searches components array and returns first encountered component of the specified class. */
    virtual UActorComponent* FindComponentByClass(const TSubclassOf<UActorComponent> ComponentClass) const;

    /** Script exposed version of FindComponentByClass. */
    UFUNCTION(BlueprintCallable, Category = "Actor", meta = (ComponentClass = "/Script/Engine.ActorComponent"),
        meta = (DeterminesOutputType = "ComponentClass"))
    UActorComponent* GetComponentByClass(TSubclassOf<UActorComponent> ComponentClass) const;

    /** Templatized version of FindComponentByClass that handles casting for you. */
    template <class T>
    T* FindComponentByClass() const {
        return static_cast<T*>(FindComponentByClass(T::StaticClass()));
    }
    template <class T>
    T* GetComponentByClass() const {
        return FindComponentByClass<T>();
    }

    /** Gets all the components that inherit from the given class. Currently returns an array of UActorComponent which
     * must be cast to the correct type. */
    UFUNCTION(BlueprintCallable, Category = "Actor",
        meta = (ComponentClass = "/Script/Engine.ActorComponent", DisplayName = "Get Components By Class",
            ScriptName = "GetComponentsByClass", DeterminesOutputType = "ComponentClass"))
    TArray<UActorComponent*> K2_GetComponentsByClass(TSubclassOf<UActorComponent> ComponentClass) const;

    /** Gets all the components that inherit from the given class with a given tag. */
    UFUNCTION(BlueprintCallable, Category = "Actor", meta = (ComponentClass = "/Script/Engine.ActorComponent"),
        meta = (DeterminesOutputType = "ComponentClass"))
    TArray<UActorComponent*> GetComponentsByTag(TSubclassOf<UActorComponent> ComponentClass, FName Tag) const;

    /** Searches components array and returns the first component of the class that has the tag, or null. */
    UFUNCTION(BlueprintCallable, Category = "Actor",
        meta = (ComponentClass = "/Script/Engine.ActorComponent", DisplayName = "Find Component By Tag",
            DeterminesOutputType = "ComponentClass"))
    UActorComponent* FindComponentByTag(TSubclassOf<UActorComponent> ComponentClass, FName Tag) const;

    /** Gets all the components that implement the given interface. */
    UFUNCTION(BlueprintCallable, Category = "Actor", meta = (ComponentClass = "/Script/Engine.ActorComponent"),
        meta = (DeterminesOutputType = "Interface"))
    TArray<UActorComponent*> GetComponentsByInterface(TSubclassOf<UInterface> Interface) const;

    /** Calls the supplied function for all components that are T. @param bIncludeFromChildActors not used: there are no
     * child actor components. */
    template <class T, class FunctionType>
    void ForEachComponent(bool bIncludeFromChildActors, FunctionType InFunc) const {
        for (UActorComponent* Component : OwnedComponents) {
            if (T* Typed = Cast<T>(Component)) {
                InFunc(Typed);
            }
        }
    }

    /**
     * Get all components derived from class 'ComponentClass' and fill in the OutComponents array with the result.
     * @param bIncludeFromChildActors not used: there are no child actor components.
     */
    void GetComponents(TSubclassOf<UActorComponent> ComponentClass, TArray<UActorComponent*>& OutComponents,
        bool bIncludeFromChildActors = false) const;
    /** Get all components derived from the type of the array. It is emptied first. */
    template <class T, class AllocatorType>
    void GetComponents(TArray<T*, AllocatorType>& OutComponents, bool bIncludeFromChildActors = false) const {
        OutComponents.Reset();
        ForEachComponent<T>(bIncludeFromChildActors, [&OutComponents](T* Component) { OutComponents.Add(Component); });
    }
    template <class T, class AllocatorType>
    void GetComponents(
        TArray<TObjectPtr<T>, AllocatorType>& OutComponents, bool bIncludeFromChildActors = false) const {
        OutComponents.Reset();
        ForEachComponent<T>(bIncludeFromChildActors, [&OutComponents](T* Component) { OutComponents.Add(Component); });
    }
    /** Get a direct reference to the components of this actor, in the order of their creation. Changes when components
     * are added or destroyed. */
    const TArray<TObjectPtr<UActorComponent>>& GetComponents() const { return OwnedComponents; }

    /** Puts a component in to the OwnedComponents array of the Actor. The Component must be owned by the Actor. */
    void AddOwnedComponent(UActorComponent* Component);
    /** Removes a component from the OwnedComponents array of the Actor. */
    void RemoveOwnedComponent(UActorComponent* Component);
    /** Utility function for validating that a component is correctly in its Owner's OwnedComponents array. */
    bool OwnsComponent(UActorComponent* Component) const { return OwnedComponents.Contains(Component); }

    /** Adds a component to the instance components array. */
    void AddInstanceComponent(UActorComponent* Component);
    /** Removes a component from the instance components array. */
    void RemoveInstanceComponent(UActorComponent* Component);
    /** Returns the instance components array. */
    const TArray<UActorComponent*>& GetInstanceComponents() const;

    /** Ensure that all the components in the Components array are registered. */
    virtual void RegisterAllComponents();
    /** Unregister all currently registered components. */
    virtual void UnregisterAllComponents(bool bForReregister = false);
    /** Called before all the components in the Components array are registered, called both in editor and during
     * gameplay. */
    virtual void PreRegisterAllComponents() {}
    /** Called after all the components in the Components array are registered, called both in editor and during
     * gameplay. */
    virtual void PostRegisterAllComponents() {}
    /** Marks all components as garbage. Called when the actor is destroyed. */
    virtual void MarkComponentsAsGarbage(bool bModify = true);
    /** Calls MarkRenderStateDirty of all components. */
    virtual void MarkComponentsRenderStateDirty();
    /** Update all components' world transforms. */
    void UpdateComponentTransforms();

    /** Returns the RootComponent of this Actor. */
    USceneComponent* GetRootComponent() const { return RootComponent; }
    /** Returns the RootComponent of this Actor. */
    UFUNCTION(BlueprintGetter)
    USceneComponent* K2_GetRootComponent() const;
    /** Sets root component to be the specified component. NewRootComponent's owner should be this actor. @return true
     * if successful. */
    bool SetRootComponent(USceneComponent* NewRootComponent);

    // ---------------------------------------------------------------------------------------------------------
    // transform

    /** Get the actor-to-world transform. */
    UFUNCTION(BlueprintCallable, meta = (DisplayName = "Get Actor Transform", ScriptName = "GetActorTransform"),
        Category = "Transformation")
    const FTransform& GetTransform() const { return ActorToWorld(); }
    /** Get the local-to-world transform of the RootComponent. Identical to GetTransform(). */
    const FTransform& ActorToWorld() const;
    /** Get the actor-to-world transform. */
    FTransform GetActorTransform() const { return ActorToWorld(); }

    /** Returns the location of the RootComponent of this Actor. */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Get Actor Location", ScriptName = "GetActorLocation", Keywords = "position"),
        Category = "Transformation")
    FVector K2_GetActorLocation() const;
    /** Returns the location of the RootComponent of this Actor, or zero if there is none. */
    FVector GetActorLocation() const;

    /**
     * Move the Actor to the specified location.
     * @param NewLocation the new location to move the Actor to, in centimetres.
     * @param bSweep whether we sweep to the destination location, triggering overlaps along the way and stopping short
     * of the target if blocked by something. Without collision the move is never blocked.
     * @param SweepHitResult the hit result from the move if swept.
     * @param bTeleport whether we teleport the physics state (if physics collision is enabled for this object).
     * @return whether the location was successfully set (if not swept), or whether movement occurred at all (if swept).
     */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Set Actor Location", ScriptName = "SetActorLocation", Keywords = "position",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"),
        Category = "Transformation")
    bool K2_SetActorLocation(FVector NewLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Move the Actor to the specified location. */
    bool SetActorLocation(const FVector& NewLocation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Returns rotation of the RootComponent of this Actor. */
    UFUNCTION(BlueprintCallable, meta = (DisplayName = "Get Actor Rotation", ScriptName = "GetActorRotation"),
        Category = "Transformation")
    FRotator K2_GetActorRotation() const;
    /** Returns rotation of the RootComponent of this Actor, or zero if there is none. */
    FRotator GetActorRotation() const;
    /** Returns quaternion of the RootComponent of this Actor. */
    FQuat GetActorQuat() const;

    /**
     * Set the Actor's rotation instantly to the specified rotation.
     * @param NewRotation the new rotation for the Actor, in degrees.
     * @param bTeleportPhysics whether we teleport the physics state (if physics collision is enabled for this object).
     * @return whether the rotation was successfully set.
     */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Set Actor Rotation", ScriptName = "SetActorRotation",
            AdvancedDisplay = "bTeleportPhysics"),
        Category = "Transformation")
    bool K2_SetActorRotation(FRotator NewRotation, bool bTeleportPhysics);
    /** Set the Actor's rotation instantly to the specified rotation. */
    bool SetActorRotation(FRotator NewRotation, ETeleportType Teleport = ETeleportType::None);
    bool SetActorRotation(const FQuat& NewRotation, ETeleportType Teleport = ETeleportType::None);

    /**
     * Move the actor instantly to the specified location and rotation.
     * @param NewLocation the new location to teleport the Actor to.
     * @param NewRotation the new rotation for the Actor.
     * @param bSweep see K2_SetActorLocation.
     * @param SweepHitResult see K2_SetActorLocation.
     * @param bTeleport see K2_SetActorLocation.
     */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set Actor Location And Rotation", ScriptName = "SetActorLocationAndRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    bool K2_SetActorLocationAndRotation(
        FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Move the actor instantly to the specified location and rotation. */
    bool SetActorLocationAndRotation(FVector NewLocation, FRotator NewRotation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);
    bool SetActorLocationAndRotation(FVector NewLocation, const FQuat& NewRotation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Set the Actor's world-space scale. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    void SetActorScale3D(FVector NewScale3D);
    /** Returns the Actor's world-space scale. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    FVector GetActorScale3D() const;

    /** Set the Actors transform to the specified one. See K2_SetActorLocation. */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Set Actor Transform", ScriptName = "SetActorTransform",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"),
        Category = "Transformation")
    bool K2_SetActorTransform(const FTransform& NewTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Set the Actors transform to the specified one. */
    bool SetActorTransform(const FTransform& NewTransform, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the location of this actor in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Actor World Offset", ScriptName = "AddActorWorldOffset",
            Keywords = "location position", AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddActorWorldOffset(FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void AddActorWorldOffset(FVector DeltaLocation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the rotation of this actor in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Actor World Rotation", ScriptName = "AddActorWorldRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddActorWorldRotation(FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void AddActorWorldRotation(FRotator DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);
    void AddActorWorldRotation(const FQuat& DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the transform of this actor in world space. Scale is unchanged. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Actor World Transform", ScriptName = "AddActorWorldTransform",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddActorWorldTransform(
        const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void AddActorWorldTransform(const FTransform& DeltaTransform, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the transform of this actor in world space. Scale is unchanged. Ignores scale and sets it to
     * (1,1,1) in the delta. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Actor World Transform Keep Scale", ScriptName = "AddActorWorldTransformKeepScale",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddActorWorldTransformKeepScale(
        const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void AddActorWorldTransformKeepScale(const FTransform& DeltaTransform, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the location of this component in its local reference frame. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Actor Local Offset", ScriptName = "AddActorLocalOffset",
            Keywords = "location position", AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddActorLocalOffset(FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void AddActorLocalOffset(FVector DeltaLocation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the rotation of this component in its local reference frame. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Actor Local Rotation", ScriptName = "AddActorLocalRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddActorLocalRotation(FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void AddActorLocalRotation(FRotator DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);
    void AddActorLocalRotation(const FQuat& DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the transform of this component in its local reference frame. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Actor Local Transform", ScriptName = "AddActorLocalTransform",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddActorLocalTransform(
        const FTransform& NewTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void AddActorLocalTransform(const FTransform& NewTransform, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Set the actor's RootComponent to the specified relative location. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set Actor Relative Location", ScriptName = "SetActorRelativeLocation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_SetActorRelativeLocation(
        FVector NewRelativeLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void SetActorRelativeLocation(FVector NewRelativeLocation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Set the actor's RootComponent to the specified relative rotation. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set Actor Relative Rotation", ScriptName = "SetActorRelativeRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_SetActorRelativeRotation(
        FRotator NewRelativeRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void SetActorRelativeRotation(FRotator NewRelativeRotation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);
    void SetActorRelativeRotation(const FQuat& NewRelativeRotation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Set the actor's RootComponent to the specified relative transform. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set Actor Relative Transform", ScriptName = "SetActorRelativeTransform",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_SetActorRelativeTransform(
        const FTransform& NewRelativeTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    void SetActorRelativeTransform(const FTransform& NewRelativeTransform, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Set the actor's RootComponent to the specified relative scale 3d. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    void SetActorRelativeScale3D(FVector NewRelativeScale);
    /** Return the actor's relative scale 3d. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    FVector GetActorRelativeScale3D() const;

    /** Get the forward (X) vector (length 1.0) from this Actor, in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    FVector GetActorForwardVector() const;
    /** Get the up (Z) vector (length 1.0) from this Actor, in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    FVector GetActorUpVector() const;
    /** Get the right (Y) vector (length 1.0) from this Actor, in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    FVector GetActorRightVector() const;

    /**
     * Returns the bounding box of all components that make up this Actor (excluding ChildActorComponents).
     * @param bOnlyCollidingComponents if true, will only return the bounding box for components with collision enabled.
     * @param Origin set to the center of the actor in world space.
     * @param BoxExtent set to half the actor's size in 3d space.
     * @param bIncludeFromChildActors not used: there are no child actor components.
     */
    UFUNCTION(BlueprintCallable, Category = "Collision", meta = (DisplayName = "Get Actor Bounds"))
    virtual void GetActorBounds(
        bool bOnlyCollidingComponents, FVector& Origin, FVector& BoxExtent, bool bIncludeFromChildActors = false) const;
    /** Returns the bounding box of all registered primitive components of this Actor, in world space. @param
     * bNonColliding includes components without collision. */
    virtual FBox GetComponentsBoundingBox(bool bNonColliding = false, bool bIncludeFromChildActors = false) const;

    /** Returns velocity (in cm/s (Unreal Units/second) of the rootcomponent if it is either using physics or has an
     * associated MovementComponent. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    virtual FVector GetVelocity() const;

    /** Returns the distance from this Actor to OtherActor, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    float GetDistanceTo(const AActor* OtherActor) const;
    /** Returns the squared distance from this Actor to OtherActor. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    float GetSquaredDistanceTo(const AActor* OtherActor) const;
    /** Returns the distance from this Actor to OtherActor, ignoring Z. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    float GetHorizontalDistanceTo(const AActor* OtherActor) const;
    /** Returns the squared distance from this Actor to OtherActor, ignoring Z. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    float GetSquaredHorizontalDistanceTo(const AActor* OtherActor) const;
    /** Returns the distance from this Actor to OtherActor, ignoring XY. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    float GetVerticalDistanceTo(const AActor* OtherActor) const;
    /** Returns the dot product from this Actor to OtherActor. Returns -2.0 on failure. Returns 0.0 for coincidental
     * actors. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    float GetDotProductTo(const AActor* OtherActor) const;
    /** Returns the dot product from this Actor to OtherActor, ignoring Z. Returns -2.0 on failure. Returns 0.0 for
     * coincidental actors. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    float GetHorizontalDotProductTo(const AActor* OtherActor) const;

    /** Teleport this actor to a new location. @return true if the actor has been successfully moved. */
    UFUNCTION(BlueprintCallable, meta = (DisplayName = "Teleport", ScriptName = "Teleport", Keywords = "Move Position"),
        Category = "Transformation")
    bool K2_TeleportTo(FVector DestLocation, FRotator DestRotation);
    virtual bool TeleportTo(
        const FVector& DestLocation, const FRotator& DestRotation, bool bIsATest = false, bool bNoCheck = false);

    // --------------------------------------------------------------------------------------------------------
    // attachment

    /**
     * Attaches the RootComponent of this Actor to the supplied component, optionally at a named socket.
     * @param Parent parent to attach to.
     * @param SocketName optional socket to attach to on the parent.
     * @param LocationRule how to handle translation when attaching.
     * @param RotationRule how to handle rotation when attaching.
     * @param ScaleRule how to handle scale when attaching.
     * @param bWeldSimulatedBodies whether to weld together simulated physics bodies. Not used without physics.
     * @return whether the attachment was successful.
     */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Attach Actor To Component", ScriptName = "AttachToComponent",
            bWeldSimulatedBodies = true),
        Category = "Transformation")
    bool K2_AttachToComponent(USceneComponent* Parent, FName SocketName, EAttachmentRule LocationRule,
        EAttachmentRule RotationRule, EAttachmentRule ScaleRule, bool bWeldSimulatedBodies);
    bool AttachToComponent(
        USceneComponent* Parent, const FAttachmentTransformRules& AttachmentRules, FName SocketName = NAME_None);

    /** Attaches the RootComponent of this Actor to the RootComponent of the supplied actor, optionally at a named
     * socket. See K2_AttachToComponent. */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Attach Actor To Actor", ScriptName = "AttachToActor", bWeldSimulatedBodies = true),
        Category = "Transformation")
    bool K2_AttachToActor(AActor* ParentActor, FName SocketName, EAttachmentRule LocationRule,
        EAttachmentRule RotationRule, EAttachmentRule ScaleRule, bool bWeldSimulatedBodies);
    bool AttachToActor(
        AActor* ParentActor, const FAttachmentTransformRules& AttachmentRules, FName SocketName = NAME_None);

    /** Detaches the RootComponent of this Actor from any SceneComponent it is currently attached to. */
    UFUNCTION(BlueprintCallable, meta = (DisplayName = "Detach From Actor", ScriptName = "DetachFromActor"),
        Category = "Transformation")
    void K2_DetachFromActor(EDetachmentRule LocationRule = EDetachmentRule::KeepRelative,
        EDetachmentRule RotationRule = EDetachmentRule::KeepRelative,
        EDetachmentRule ScaleRule = EDetachmentRule::KeepRelative);
    void DetachFromActor(const FDetachmentTransformRules& DetachmentRules);

    /** Detaches all SceneComponents in this Actor from the supplied parent SceneComponent. */
    void DetachAllSceneComponents(USceneComponent* InParentComponent, const FDetachmentTransformRules& DetachmentRules);

    /** Walk up the attachment chain from RootComponent until we encounter a different actor, and return it. If we are
     * not attached to a component in a different actor, returns nullptr. */
    UFUNCTION(BlueprintPure, Category = "Actor")
    AActor* GetAttachParentActor() const;
    /** Walk up the attachment chain from RootComponent until we encounter a different actor, and return the socket name
     * in the component. NAME_None if there is none. */
    UFUNCTION(BlueprintPure, Category = "Actor")
    FName GetAttachParentSocketName() const;
    /**
     * Find all Actors which are attached directly to a component in this actor.
     * @param OutActors receives them.
     * @param bResetArray whether to empty the array first.
     * @param bRecursivelyIncludeAttachedActors whether to add the actors attached to those, and so on.
     */
    UFUNCTION(BlueprintPure, Category = "Actor")
    void GetAttachedActors(
        TArray<AActor*>& OutActors, bool bResetArray = true, bool bRecursivelyIncludeAttachedActors = false) const;
    /** Calls the function for each directly attached actor, until it returns false. */
    void ForEachAttachedActors(TFunctionRef<bool(AActor*)> Functor) const;
    /** Whether this actor is attached, directly or not, to that one. */
    bool IsAttachedTo(const AActor* Other) const;
    /** The component that the root component is attached to, or null. */
    USceneComponent* GetDefaultAttachComponent() const { return RootComponent; }

    // ---------------------------------------------------------------------------------------------- owner and
    // instigator

    /** Set the owner of this Actor, used primarily for network replication. @param NewOwner the Actor who takes over
     * ownership of this Actor. */
    UFUNCTION(BlueprintCallable, Category = Actor)
    virtual void SetOwner(AActor* NewOwner);
    /** Get the owner of this Actor, used primarily for network replication. */
    UFUNCTION(BlueprintCallable, Category = Actor)
    AActor* GetOwner() const;
    /** Templated version of GetOwner(), will return nullptr if cast fails. */
    template <class T>
    T* GetOwner() const {
        return Cast<T>(GetOwner());
    }
    /** This will check to see if the Actor is owned by that one, directly or not. */
    bool IsOwnedBy(const AActor* TestOwner) const;
    /** Whether the actor's net owner is the same as the other's: here, its outermost owner. */
    virtual const AActor* GetNetOwner() const { return Owner; }

    /** Returns the instigator for this actor, or nullptr if there is none. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintProtected = "false"), Category = "Game")
    APawn* GetInstigator() const;
    /** Get the instigator, cast as a specific class. */
    template <class T>
    T* GetInstigator() const {
        return Cast<T>(Instigator);
    }
    /** Sets the instigator. */
    void SetInstigator(APawn* InInstigator);
    /** Returns the instigator's controller for this actor, or nullptr if there is none. */
    UFUNCTION(BlueprintCallable, meta = (BlueprintProtected = "false"), Category = "Game")
    AController* GetInstigatorController() const;

    // ---------------------------------------------------------------------------------------------------------------
    // tags

    /** See if this actor's Tags array contains the supplied name tag. */
    UFUNCTION(BlueprintCallable, Category = "Actor")
    bool ActorHasTag(FName Tag) const;

    // ---------------------------------------------------------------------------------------------------------------
    // tick

    /** Function called every frame on this Actor. Override this function to implement custom logic to be executed every
     * frame. @param DeltaSeconds game time elapsed during last frame modified by the time dilation. */
    virtual void Tick(float DeltaSeconds);
    /** Dispatches a tick to the actor: called by its tick function. */
    virtual void TickActor(float DeltaTime, ELevelTick TickType, FActorTickFunction& ThisTickFunction);
    /** If true, actor is ticked even if TickType==LEVELTICK_ViewportsOnly. */
    virtual bool ShouldTickIfViewportsOnly() const { return false; }

    /** Sets whether this actor tick is enabled. Only modifies the tick function if it is registered. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick")
    void SetActorTickEnabled(bool bEnabled);
    /** Returns whether this actor has tick enabled or not. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick")
    bool IsActorTickEnabled() const;
    /** Sets the tick interval of this actor's primary tick function. Will not enable a disabled tick function. Takes
     * effect on next tick. @param TickInterval the rate at which this actor should be ticking, in seconds. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick")
    void SetActorTickInterval(float TickInterval);
    /** Returns the tick interval of this actor's primary tick function, in seconds. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick")
    float GetActorTickInterval() const;
    /** Changes the ticking group for this actor. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick")
    void SetTickGroup(ETickingGroup NewTickGroup);
    /** Sets whether this actor can tick when paused. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick")
    void SetTickableWhenPaused(bool bTickableWhenPaused);
    /** Gets whether this actor can tick when paused. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick")
    bool GetTickableWhenPaused();
    /** Make this actor tick after PrerequisiteActor. This only applies to this actor's tick function; dependencies for
     * owned components must be set separately if desired. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick", meta = (Keywords = "dependency"))
    virtual void AddTickPrerequisiteActor(AActor* PrerequisiteActor);
    /** Make this actor tick after PrerequisiteComponent. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick", meta = (Keywords = "dependency"))
    virtual void AddTickPrerequisiteComponent(UActorComponent* PrerequisiteComponent);
    /** Remove tick dependency on PrerequisiteActor. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick", meta = (Keywords = "dependency"))
    virtual void RemoveTickPrerequisiteActor(AActor* PrerequisiteActor);
    /** Remove tick dependency on PrerequisiteComponent. */
    UFUNCTION(BlueprintCallable, Category = "Actor|Tick", meta = (Keywords = "dependency"))
    virtual void RemoveTickPrerequisiteComponent(UActorComponent* PrerequisiteComponent);
    /** Set this actor's tick functions to be enabled or disabled, registering them or not. */
    virtual void RegisterActorTickFunctions(bool bRegister);
    /** When called, will call the virtual call chain to register all of the tick functions for both the actor and
     * optionally all components. */
    void RegisterAllActorTickFunctions(bool bRegister, bool bDoComponents);
    /** CustomTimeDilation times the effective time dilation of the world. */
    float GetActorTimeDilation() const;

    // -------------------------------------------------------------------------------------------------------------
    // events

    /** Event when play begins for this actor. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "BeginPlay"))
    void ReceiveBeginPlay();
    /** Event called every frame, if ticking is enabled. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "Tick"))
    void ReceiveTick(float DeltaSeconds);
    /** Event to notify blueprints this actor is being deleted or removed from a level. */
    UFUNCTION(BlueprintImplementableEvent, meta = (Keywords = "delete", DisplayName = "End Play"))
    void ReceiveEndPlay(EEndPlayReason::Type EndPlayReason);
    /** Called when the actor has been explicitly destroyed. */
    UFUNCTION(BlueprintImplementableEvent, meta = (Keywords = "delete", DisplayName = "Destroyed"))
    void ReceiveDestroyed();
    /** Event when this actor overlaps another actor, for example a player walking into a trigger. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "ActorBeginOverlap"), Category = "Collision")
    void ReceiveActorBeginOverlap(AActor* OtherActor);
    /** Event when an actor no longer overlaps another actor, and they have separated. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "ActorEndOverlap"), Category = "Collision")
    void ReceiveActorEndOverlap(AActor* OtherActor);
    /** Event when this actor bumps into a blocking object, or blocks another actor that bumps into it. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "Hit"), Category = "Collision")
    void ReceiveHit(UPrimitiveComponent* MyComp, AActor* Other, UPrimitiveComponent* OtherComp, bool bSelfMoved,
        FVector HitLocation, FVector HitNormal, FVector NormalImpulse, const FHitResult& Hit);
    /** Event called when this Actor becomes the view target for the given PlayerController. */
    UFUNCTION(BlueprintImplementableEvent,
        meta = (DisplayName = "OnBecomeViewTarget", ScriptName = "OnBecomeViewTarget"), Category = Actor)
    void K2_OnBecomeViewTarget(APlayerController* PC);
    /** Event called when this Actor is no longer the view target for the given PlayerController. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "OnEndViewTarget", ScriptName = "OnEndViewTarget"),
        Category = Actor)
    void K2_OnEndViewTarget(APlayerController* PC);
    /** Event called when this Actor is reset to its initial state - used when restarting level without reloading. */
    UFUNCTION(BlueprintImplementableEvent, Category = Actor, meta = (DisplayName = "On Reset", ScriptName = "OnReset"))
    void K2_OnReset();
    /** Construction script, the place to spawn components and do other setup. */
    UFUNCTION(
        BlueprintImplementableEvent, meta = (BlueprintInternalUseOnly = "true", DisplayName = "Construction Script"))
    void UserConstructionScript();

    /** Event when this actor overlaps another actor, for example a player walking into a trigger. */
    virtual void NotifyActorBeginOverlap(AActor* OtherActor);
    /** Event when an actor no longer overlaps another actor, and they have separated. */
    virtual void NotifyActorEndOverlap(AActor* OtherActor);
    /** Event when this actor bumps into a blocking object, or blocks another actor that bumps into it. */
    virtual void NotifyHit(UPrimitiveComponent* MyComp, AActor* Other, UPrimitiveComponent* OtherComp, bool bSelfMoved,
        FVector HitLocation, FVector HitNormal, FVector NormalImpulse, const FHitResult& Hit);
    /** Reset actor to initial state - used when restarting level without reloading. */
    virtual void Reset();

    // --------------------------------------------------------------------------------------------------------- view
    // target

    /** Returns the point of view of the actor: the location and rotation of its root component, or of its eyes for
     * pawns. */
    UFUNCTION(BlueprintCallable, Category = Actor)
    virtual void GetActorEyesViewPoint(FVector& OutLocation, FRotator& OutRotation) const;
    /** Calculate camera view point, when viewing this actor: through its active camera component, if there is one, else
     * from its eyes. */
    virtual void CalcCamera(float DeltaTime, FMinimalViewInfo& OutResult);
    /** Returns true if the actor contains an active camera component. */
    virtual bool HasActiveCameraComponent(bool bForceFindCamera = false) const;
    /** Called when this Actor becomes the given PlayerController's ViewTarget. Triggers the Blueprint event
     * K2_OnBecomeViewTarget. */
    virtual void BecomeViewTarget(APlayerController* PC);
    /** Called when this Actor is no longer the given PlayerController's ViewTarget. Also triggers the Blueprint event
     * K2_OnEndViewTarget. */
    virtual void EndViewTarget(APlayerController* PC);
    /** Returns the optimal location to fire weapons at this actor: the centre of its bounds. */
    virtual FVector GetTargetLocation(AActor* RequestedBy = nullptr) const;

    // ------------------------------------------------------------------------------------------------------- level,
    // world

    /** Return the ULevel that this Actor is part of. */
    UFUNCTION(BlueprintCallable, Category = "Level")
    ULevel* GetLevel() const;
    /** Return the FTransform of the level this actor is a part of: the identity. */
    UFUNCTION(BlueprintCallable, Category = "Level")
    FTransform GetLevelTransform() const;
    /** Get the owning UGameInstance of the world of this actor. */
    UGameInstance* GetGameInstance() const;
    template <class T>
    T* GetGameInstance() const {
        return Cast<T>(GetGameInstance());
    }
    /** The timer manager of the world; the world must be there. */
    FTimerManager& GetWorldTimerManager() const;
    /** Whether the actor is in the persistent level. */
    bool IsInPersistentLevel(bool bIncludeLevelStreamingPersistent = false) const;
    /** Returns this actor's name: labels exist in editors only. */
    FString GetActorNameOrLabel() const { return GetName(); }
    /** Gets the name of the actor as text for people. */
    virtual FString GetHumanReadableName() const { return GetName(); }

    // -------------------------------------------------------------------------------------------------------- life
    // cycle

    /** Called right before components are initialized, only called during gameplay. */
    virtual void PreInitializeComponents();
    /** Allow actors to initialize themselves on the C++ side after all of their components have been initialized, only
     * called during gameplay. */
    virtual void PostInitializeComponents();
    /** Called when an instance of this class is placed (in editor) or spawned. @param Transform the transform the actor
     * was constructed at. */
    virtual void OnConstruction(const FTransform& Transform) {}
    /** Called after the actor has been spawned in the world. */
    virtual void PostActorCreated() {}
    /** Called to finish the spawning process, generally in the case of deferred spawning. @param bIsDefaultTransform
     * whether Transform is the one that the actor was spawned with. */
    void FinishSpawning(const FTransform& Transform, bool bIsDefaultTransform = false,
        const class FComponentInstanceDataCache* InstanceDataCache = nullptr,
        ESpawnActorScaleMethod TransformScaleMethod = ESpawnActorScaleMethod::OverrideRootScale);
    /** Initiate a begin play call on this Actor, will handle calling in the correct order. */
    void DispatchBeginPlay(bool bFromLevelStreaming = false);
    /** Returns whether an actor has been initialized for gameplay. */
    bool IsActorInitialized() const { return bActorInitialized; }
    /** Returns whether an actor is in the process of beginning play. */
    bool IsActorBeginningPlay() const { return ActorHasBegunPlay == EActorBeginPlayState::BeginningPlay; }
    /** Returns whether an actor has had BeginPlay called on it (and not subsequently had EndPlay called). */
    bool HasActorBegunPlay() const { return ActorHasBegunPlay == EActorBeginPlayState::HasBegunPlay; }
    /** Whether construction (including the construction script) is over. */
    bool IsActorFinishedSpawning() const { return bHasFinishedSpawning; }
    /** Called whenever this actor is being removed from a level. Overridable native event. */
    virtual void EndPlay(const EEndPlayReason::Type EndPlayReason);
    /** Called when this actor is explicitly being destroyed during gameplay or in the editor, not called during level
     * streaming or gameplay ending. */
    virtual void Destroyed();
    /** Called from level transitions and level streaming. @param EndPlayReason why. */
    void RouteEndPlay(const EEndPlayReason::Type EndPlayReason);
    /** Iterates over all components, calling InitializeComponent on those that want it and activating those that
     * auto-activate. */
    void InitializeComponents();
    /** Iterates over all components, calling UninitializeComponent. */
    void UninitializeComponents();

    // UObject
    virtual UWorld* GetWorld() const override final;
    virtual void PostInitProperties() override;
    virtual void BeginDestroy() override;
    static void AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector);

protected:
    /** Overridable native event for when play begins for this actor. */
    virtual void BeginPlay();

private:
    friend class UWorld;
    friend class UActorComponent;

    /** Called by UWorld::SpawnActor after construction. */
    void PostSpawnInitialize(const FTransform& SpawnTransform, AActor* InOwner, APawn* InInstigator,
        bool bDeferConstruction, ESpawnActorScaleMethod TransformScaleMethod);
    /** Called after construction is finished: initialises components and starts play, as far as the world has got. */
    void PostActorConstruction();
    void InitializeDefaults();
    /** Called by UWorld::DestroyActor: takes the actor out of the owner's children and out of the attachment. */
    void OnLeaveWorld();

    /** All ActorComponents owned by this Actor, in the order of their creation. */
    TArray<TObjectPtr<UActorComponent>> OwnedComponents;
    /** Handle for efficient management of LifeSpanExpired timer. */
    FTimerHandle TimerHandle_LifeSpanExpired;
    /** Time in seconds of the world at which this was created. */
    double CreationTime;
    EActorBeginPlayState ActorHasBegunPlay;
    uint8 bActorInitialized : 1;
    uint8 bActorIsBeingDestroyed : 1;
    uint8 bHasFinishedSpawning : 1;
    uint8 bTickFunctionsRegistered : 1;
    uint8 bHasRegisteredAllComponents : 1;
};
