// SPDX-License-Identifier: MIT
/** @file Base class of components. Mirrors UE's Components/ActorComponent.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"
#include "UObject/ScriptDelegates.h"
#include "UObject/SparseDelegate.h"

#include "ActorComponent.generated.h"

class AActor;
class FRegisterComponentContext;
class UActorComponent;
class ULevel;
class UWorld;

DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_TwoParams(FActorComponentActivatedSignature, UActorComponent,
    OnComponentActivated, UActorComponent*, Component, bool, bReset);
DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_OneParam(
    FActorComponentDeactivateSignature, UActorComponent, OnComponentDeactivated, UActorComponent*, Component);

/**
 * ActorComponent is the base class for components that define reusable behavior that can be added to different types of
 * Actors.
 *
 * Life: created (as a default subobject, by AddComponentByClass or NewObject), registered with the world of its owner,
 * initialised, BeginPlay, ticks, EndPlay, unregistered, destroyed. A destroyed component lingers until the garbage is
 * collected, as a destroyed actor does.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Components/UActorComponent
 */
UCLASS(DefaultToInstanced, BlueprintType, Abstract,
    meta = (ShortTooltip = "An ActorComponent is a reusable component that can be added to any actor."),
    config = Engine, HideCategories = (ComponentReplication))
class ENGINE_API UActorComponent : public UObject {
    GENERATED_BODY()

public:
    /** Default UObject constructor that takes an optional ObjectInitializer. */
    UActorComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Main tick function for the Component. */
    UPROPERTY(EditDefaultsOnly, Category = "ComponentTick")
    FActorComponentTickFunction PrimaryComponentTick;

    /** Array of tags that can be used for grouping and categorizing. Can also be accessed from scripting. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Tags)
    TArray<FName> ComponentTags;

    /** True if this component can be modified when it was inherited from a parent actor class. */
    UPROPERTY(EditDefaultsOnly, BlueprintReadOnly, Category = Variable)
    uint8 bEditableWhenInherited : 1;

    /** Whether the component is activated at creation or must be explicitly activated. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Activation)
    uint8 bAutoActivate : 1;

    /** If true, we call the virtual InitializeComponent. */
    uint8 bWantsInitializeComponent : 1;

    /** Describes how a component instance was created. */
    UPROPERTY()
    EComponentCreationMethod CreationMethod;

    /** Called when the component has been activated, with parameter indicating if it was from a reset. */
    UPROPERTY(BlueprintAssignable, Category = "Components|Activation")
    FActorComponentActivatedSignature OnComponentActivated;

    /** Called when the component has been deactivated. */
    UPROPERTY(BlueprintAssignable, Category = "Components|Activation")
    FActorComponentDeactivateSignature OnComponentDeactivated;

    // ---------------------------------------------------------------------------------------------------- owner, world

    /** Follow the Outer chain to get the AActor that 'Owns' this component. */
    UFUNCTION(BlueprintCallable, Category = "Components", meta = (Keywords = "Actor Owning Parent"))
    AActor* GetOwner() const;

    /** The owner cast to T, or null. */
    template <class T>
    T* GetOwner() const {
        return Cast<T>(GetOwner());
    }

    /** Getter for the cached world pointer, will return null if the component is not actually spawned in a level. */
    virtual UWorld* GetWorld() const override final;

    /** Get the level of the owning actor, or null. */
    ULevel* GetComponentLevel() const;

    /** Check if our owner has a role. Without a network every role is ROLE_Authority. */
    ENetRole GetOwnerRole() const;

    /** A readable name: "Owner.Component" for logs. */
    FString GetReadableName() const;

    /** See if this component contains the supplied tag. */
    UFUNCTION(BlueprintCallable, Category = "Components")
    bool ComponentHasTag(FName Tag) const;

    // ------------------------------------------------------------------------------------------------------ activation

    /**
     * Activates the SceneComponent, should be overridden by native child classes.
     * @param bReset whether the activation should happen even if ShouldActivate returns false.
     */
    UFUNCTION(BlueprintCallable, Category = "Components|Activation")
    virtual void Activate(bool bReset = false);

    /** Deactivates the SceneComponent. */
    UFUNCTION(BlueprintCallable, Category = "Components|Activation")
    virtual void Deactivate();

    /**
     * Sets whether the component is active or not.
     * @param bNewActive the new active state of the component.
     * @param bReset whether the activation should happen even if ShouldActivate returns false.
     */
    UFUNCTION(BlueprintCallable, Category = "Components|Activation")
    virtual void SetActive(bool bNewActive, bool bReset = false);

    /** Toggles the active state of the component. */
    UFUNCTION(BlueprintCallable, Category = "Components|Activation")
    virtual void ToggleActive();

    /** Returns whether the component is active or not. */
    UFUNCTION(BlueprintCallable, Category = "Components|Activation")
    virtual bool IsActive() const;

    /** Sets whether the component should be auto activate or not. Only safe during construction scripts. */
    UFUNCTION(BlueprintCallable, Category = "Components|Activation")
    virtual void SetAutoActivate(bool bNewAutoActivate);

    // ------------------------------------------------------------------------------------------------------------ tick

    /**
     * Function called every frame on this ActorComponent. Override this function to implement custom logic to be
     * executed every frame.
     * @param DeltaTime the time since the last tick, in seconds.
     * @param TickType the kind of tick this is, for example, are we paused.
     * @param ThisTickFunction internal tick function struct that caused this to run.
     */
    virtual void TickComponent(float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction);

    /** Set this component's tick functions to be enabled or disabled. Only has an effect if the function is registered.
     */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick")
    virtual void SetComponentTickEnabled(bool bEnabled);

    /** Returns whether this component has tick enabled or not. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick")
    virtual bool IsComponentTickEnabled() const;

    /** Sets the tick interval for this component's primary tick function. Does not enable the tick interval. Takes
     * effect on next tick. @param TickInterval seconds. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick")
    void SetComponentTickInterval(float TickInterval);

    /** Sets the tick interval for this component's primary tick function; cuts the current cooldown short. */
    void SetComponentTickIntervalAndCooldown(float TickInterval);

    /** Returns the tick interval for this component's primary tick function, which is the frequency in seconds at which
     * it will be executed. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick")
    float GetComponentTickInterval() const;

    /** Make this component tick after PrerequisiteActor. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick", meta = (Keywords = "dependency"))
    virtual void AddTickPrerequisiteActor(AActor* PrerequisiteActor);

    /** Make this component tick after PrerequisiteComponent. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick", meta = (Keywords = "dependency"))
    virtual void AddTickPrerequisiteComponent(UActorComponent* PrerequisiteComponent);

    /** Remove tick dependency on PrerequisiteActor. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick", meta = (Keywords = "dependency"))
    virtual void RemoveTickPrerequisiteActor(AActor* PrerequisiteActor);

    /** Remove tick dependency on PrerequisiteComponent. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick", meta = (Keywords = "dependency"))
    virtual void RemoveTickPrerequisiteComponent(UActorComponent* PrerequisiteComponent);

    /** Sets whether this component can tick when paused. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick")
    void SetTickableWhenPaused(bool bTickableWhenPaused);

    /** Changes the ticking group for this component. */
    UFUNCTION(BlueprintCallable, Category = "Components|Tick")
    void SetTickGroup(ETickingGroup NewTickGroup);

    /** Virtual call chain to register all tick functions. @param bRegister true to register, false to unregister. */
    void RegisterAllComponentTickFunctions(bool bRegister);

    /**
     * Set up a tick function for a component in the standard way: register it with the level of the owner if it can
     * ever tick.
     * @return true if it was set up.
     */
    bool SetupActorComponentTickFunction(FTickFunction* TickFunction);

    /** Event called every frame if tick is enabled. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "Tick"))
    void ReceiveTick(float DeltaSeconds);

    // ------------------------------------------------------------------------------------------------------------ play

    /** Blueprint implementable event for when the component is beginning play, called before its Owner's BeginPlay on
     * Actor BeginPlay or when the component is dynamically created if the Actor has already BegunPlay. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "Begin Play"))
    void ReceiveBeginPlay();

    /** Blueprint implementable event for when the component ends play, generally via destruction or its Actor's
     * EndPlay. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "End Play"))
    void ReceiveEndPlay(EEndPlayReason::Type EndPlayReason);

    /** Begins Play for the component. Called when the owning Actor begins play or when the component is created if the
     * Actor has already begun play. */
    virtual void BeginPlay();

    /** Ends gameplay for this component. Called from AActor::EndPlay only if bHasBegunPlay is true. */
    virtual void EndPlay(const EEndPlayReason::Type EndPlayReason);

    /** Initializes the component. Occurs at level startup or actor spawn. This is before BeginPlay. Requires
     * bWantsInitializeComponent. */
    virtual void InitializeComponent();

    /** Handle this component being Uninitialized. Called from AActor::EndPlay only if bHasBeenInitialized is true. */
    virtual void UninitializeComponent();

    /** Indicates that BeginPlay has been called, but EndPlay has not yet. */
    bool HasBegunPlay() const { return bHasBegunPlay; }
    /** Indicates that InitializeComponent has been called, but UninitializeComponent has not yet. */
    bool HasBeenInitialized() const { return bHasBeenInitialized; }
    /** Indicates that OnComponentCreated has been called. */
    bool HasBeenCreated() const { return bHasBeenCreated; }
    /** Whether an owner with bAutoDestroyWhenFinished may destroy itself as far as this component is concerned. */
    virtual bool IsReadyForOwnerToAutoDestroy() const { return true; }

    // ---------------------------------------------------------------------------------------------------- registration

    /** Register this component, creating any rendering/physics state. Will also add itself to the outer Actor's
     * Components array, if not already present. */
    void RegisterComponent();
    /** Unregister this component, destroying any rendering/physics state. */
    void UnregisterComponent();
    /** Unregister the component, remove it from its outer Actor's Components array and mark for pending kill. @param
     * bPromoteChildren see USceneComponent. */
    virtual void DestroyComponent(bool bPromoteChildren = false);
    /** Reregisters a component that is registered. */
    void ReregisterComponent();
    /** Registers a component with a specific world, which creates any visual/physical state. */
    void RegisterComponentWithWorld(UWorld* InWorld);

    /** See if this component is currently registered. */
    bool IsRegistered() const { return bRegistered; }
    /** Check whether the component class allows reregistration during ReregisterAllComponents. */
    bool AllowReregistration() const { return true; }
    /** Whether RegisterAllComponents registers this by itself. */
    bool ShouldRegister() const { return bAutoRegister; }

    /**
     * Unregister and mark for pending kill a component. This may not be used to destroy a component that is owned by an
     * actor unless the owning actor is calling the function.
     * @param Object the actor that calls: the owner, or the component itself.
     */
    UFUNCTION(BlueprintCallable, Category = "Components",
        meta = (Keywords = "Delete", HidePin = "Object", DefaultToSelf = "Object", DisplayName = "Destroy Component",
            ScriptName = "DestroyComponent"))
    void K2_DestroyComponent(UObject* Object);

    /** Returns whether the component is in the process of being destroyed. */
    UFUNCTION(BlueprintCallable, Category = "Components", meta = (DisplayName = "Is Component Being Destroyed"))
    bool IsBeingDestroyed() const { return bIsBeingDestroyed; }

    /** Called when a component is created (not loaded). This can happen in the editor or during gameplay. */
    virtual void OnComponentCreated();
    /** Called when a component is destroyed. @param bDestroyingHierarchy true if the entire component hierarchy is
     * being torn down. */
    virtual void OnComponentDestroyed(bool bDestroyingHierarchy);

    // ---------------------------------------------------------------------------------------------------- render state

    /** Marks the renderer's copy of this component as out of date, so that it is recreated at the end of the frame. */
    void MarkRenderStateDirty();
    /** Indicates that the transform needs to be sent to the renderer at the end of the frame. */
    void MarkRenderTransformDirty();
    /** Indicates that dynamic data of this component needs to be sent to the renderer at the end of the frame. */
    void MarkRenderDynamicDataDirty();
    /** Is this component's render state created. */
    bool IsRenderStateCreated() const { return bRenderStateCreated; }
    /** Is this component's render state dirty. */
    bool IsRenderStateDirty() const { return bRenderStateDirty; }
    /** Whether the transform is to be sent at the end of the frame. */
    bool IsRenderTransformDirty() const { return bRenderTransformDirty; }
    /** Recreates, or sends transform and dynamic data of, what was marked dirty. Called by the world at the end of its
     * tick. */
    void DoDeferredRenderUpdates_Concurrent();
    /** Recreate the render state right away. */
    void RecreateRenderState_Concurrent();

    // UObject
    virtual void PostInitProperties() override;
    virtual void BeginDestroy() override;

protected:
    /** Called when a component is registered, after Scene is set, but before CreateRenderState_Concurrent is called. */
    virtual void OnRegister();
    /** Called when a component is unregistered. Called after DestroyRenderState_Concurrent is called. */
    virtual void OnUnregister();
    /** Virtual function to register tick functions. */
    virtual void RegisterComponentTickFunctions(bool bRegister);
    /** Return true if CreateRenderState() should be called. */
    virtual bool ShouldCreateRenderState() const { return false; }
    /** Used to create any rendering data for this component. */
    virtual void CreateRenderState_Concurrent(FRegisterComponentContext* Context);
    /** Called to send a transform update for this component to the renderer. */
    virtual void SendRenderTransform_Concurrent();
    /** Called to send dynamic data for this component to the renderer. */
    virtual void SendRenderDynamicData_Concurrent();
    /** Used to shut down any rendering data for this component. */
    virtual void DestroyRenderState_Concurrent();
    /** Whether the component should activate. */
    virtual bool ShouldActivate() const;
    /** Sets the active flag and nothing else. */
    void SetActiveFlag(const bool bNewIsActive) { bIsActive = bNewIsActive; }

public:
    /** Does this component automatically register with its owner? */
    uint8 bAutoRegister : 1;

private:
    friend class AActor;
    friend class UWorld;
    friend struct FActorComponentTickFunction;

    /** Whether the component is currently active. */
    UPROPERTY(Transient)
    uint8 bIsActive : 1;

    uint8 bRegistered : 1;
    uint8 bHasBeenCreated : 1;
    uint8 bHasBeenInitialized : 1;
    uint8 bHasBegunPlay : 1;
    uint8 bIsBeingDestroyed : 1;
    uint8 bTickFunctionsRegistered : 1;
    uint8 bRenderStateCreated : 1;
    uint8 bRenderStateDirty : 1;
    uint8 bRenderTransformDirty : 1;
    uint8 bRenderDynamicDataDirty : 1;
    uint8 bMarkedForEndOfFrameUpdate : 1;

    /** Cached owner: the actor in the chain of outers, if any. */
    AActor* OwnerPrivate;
    /** The world this is registered with, null while it is not. */
    UWorld* WorldPrivate;

    void ExecuteRegisterEvents();
    void ExecuteUnregisterEvents();
    void MarkForNeededEndOfFrameUpdate();
};
