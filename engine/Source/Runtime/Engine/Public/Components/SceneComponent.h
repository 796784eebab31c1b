// SPDX-License-Identifier: MIT
#pragma once

#include "Components/ActorComponent.h"
#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "Engine/HitResult.h"
#include "UObject/ObjectMacros.h"

#include "SceneComponent.generated.h"

class AActor;
class USceneComponent;

/** What changed a transform, handed to `USceneComponent::OnUpdateTransform`. Epic page: EUpdateTransformFlags. */
enum class EUpdateTransformFlags : int32 {
    /** Default options. */
    None = 0x0,
    /** Do not update the underlying physics. */
    SkipPhysicsUpdate = 0x1,
    /** The update comes as a result of the parent updating. */
    PropagateFromParent = 0x2,
    /** Only update the child transform if attached to the socket of a parent. */
    OnlyUpdateIfUsingSocket = 0x4
};
ENUM_CLASS_FLAGS(EUpdateTransformFlags)

/** Options of `USceneComponent::MoveComponent`. Epic page: EMoveComponentFlags. */
enum EMoveComponentFlags {
    /** Default options. */
    MOVECOMP_NoFlags = 0x0000,
    /** Ignore collisions with things the actor is based on. */
    MOVECOMP_IgnoreBases = 0x0001,
    /** When moving this component, do not move the physics representation. */
    MOVECOMP_SkipPhysicsMove = 0x0002,
    /** Never ignore initial blocking overlaps during movement. */
    MOVECOMP_NeverIgnoreBlockingOverlaps = 0x0004,
    /** Avoid dispatching blocking hit events. */
    MOVECOMP_DisableBlockingOverlapDispatch = 0x0008
};

/** The space a socket transform is asked for in. Epic page: ERelativeTransformSpace. */
UENUM()
enum ERelativeTransformSpace : int {
    /** World space transform. */
    RTS_World,
    /** Actor space transform. */
    RTS_Actor,
    /** Component space transform. */
    RTS_Component,
    /** Parent bone space; components without bones answer as for `RTS_Component`. */
    RTS_ParentBoneSpace
};

/** Broadcast when the transform of a component was updated. Epic page: FTransformUpdated. */
DECLARE_EVENT_ThreeParams(USceneComponent, FTransformUpdated, USceneComponent* /*InRootComponent*/,
    EUpdateTransformFlags /*UpdateTransformFlags*/, ETeleportType /*Teleport*/);

/**
 * A component with a transform, which can be attached to another one. It has no rendering or collision of its own.
 *
 * Locations are in centimetres, rotations in degrees (left-handed, Z up). The relative values are relative to the
 * attach parent (or one of its sockets), or to the world where `SetAbsolute` says so. Writing `RelativeLocation`,
 * `RelativeRotation` or `RelativeScale3D` as properties changes only those values: the world transform, the bounds and
 * the attached children follow when a setter or `UpdateComponentToWorld` runs, as in UE. Epic page: USceneComponent.
 */
UCLASS(ClassGroup = (Utility, Common), BlueprintType, HideCategories = (Trigger, PhysicsVolume),
    meta = (BlueprintSpawnableComponent, IgnoreCategoryKeywordsInSubclasses,
        ShortTooltip = "A component with a transform, which can be attached to another one."))
class ENGINE_API USceneComponent : public UActorComponent {
    GENERATED_BODY()

private:
    /** What we are currently attached to. If valid, RelativeLocation etc. are used relative to this object. */
    UPROPERTY()
    TObjectPtr<USceneComponent> AttachParent;

    /** Optional socket name on AttachParent that we are attached to. */
    UPROPERTY()
    FName AttachSocketName;

    /** List of child components that are attached to us. */
    UPROPERTY(Transient)
    TArray<TObjectPtr<USceneComponent>> AttachChildren;

    /** Location of the component relative to its parent, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Transform,
        meta = (AllowPrivateAccess = "true", LinearDeltaSensitivity = "1", Delta = "1.0"))
    FVector RelativeLocation;

    /** Rotation of the component relative to its parent, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Transform,
        meta = (AllowPrivateAccess = "true", LinearDeltaSensitivity = "1", Delta = "1.0"))
    FRotator RelativeRotation;

    /** Non-uniform scaling of the component relative to its parent. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Transform,
        meta = (AllowPrivateAccess = "true", LinearDeltaSensitivity = "1", Delta = "0.0025"))
    FVector RelativeScale3D;

public:
    /** Velocity of the component, in centimetres per second. See `GetComponentVelocity`. */
    UPROPERTY()
    FVector ComponentVelocity;

private:
    /** If RelativeLocation should be considered relative to the world, rather than the parent. */
    UPROPERTY(
        EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Transform, meta = (AllowPrivateAccess = "true"))
    uint8 bAbsoluteLocation : 1;

    /** If RelativeRotation should be considered relative to the world, rather than the parent. */
    UPROPERTY(
        EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Transform, meta = (AllowPrivateAccess = "true"))
    uint8 bAbsoluteRotation : 1;

    /** If RelativeScale3D should be considered relative to the world, rather than the parent. */
    UPROPERTY(
        EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Transform, meta = (AllowPrivateAccess = "true"))
    uint8 bAbsoluteScale : 1;

    /** Whether to completely draw the component; if false, the component is not drawn at all. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Rendering, meta = (AllowPrivateAccess = "true"))
    uint8 bVisible : 1;

public:
    /** Whether to hide the component in game, if visible. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadOnly, Category = Rendering)
    uint8 bHiddenInGame : 1;

    /** If true, this component uses its parent's bounds when attached. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadWrite, Category = Rendering)
    uint8 bUseAttachParentBound : 1;

    /** How often this component is allowed to move. Change it with `SetMobility`. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Mobility)
    TEnumAsByte<EComponentMobility::Type> Mobility;

    /** Current bounds of the component, in world space. */
    FBoxSphereBounds Bounds;

    /** Broadcast each time the transform of this component was updated. */
    FTransformUpdated TransformUpdated;

    USceneComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    // ------------------------------------------------------------------------------------------- relative transform

    /** Sets the location of the component relative to its parent. Without collision the sweep has no effect. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set Relative Location", ScriptName = "SetRelativeLocation"))
    void K2_SetRelativeLocation(FVector NewLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Sets the location of the component relative to its parent. */
    void SetRelativeLocation(FVector NewLocation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Sets the rotation of the component relative to its parent, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set Relative Rotation", ScriptName = "SetRelativeRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_SetRelativeRotation(FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Sets the rotation of the component relative to its parent, in degrees. */
    void SetRelativeRotation(FRotator NewRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);
    /** Sets the rotation of the component relative to its parent. */
    void SetRelativeRotation(const FQuat& NewRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Sets location and rotation of the component relative to its parent. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set Relative Location And Rotation", ScriptName = "SetRelativeLocationAndRotation"))
    void K2_SetRelativeLocationAndRotation(
        FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Sets location and rotation of the component relative to its parent. */
    void SetRelativeLocationAndRotation(FVector NewLocation, FRotator NewRotation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);
    /** Sets location and rotation of the component relative to its parent. */
    void SetRelativeLocationAndRotation(FVector NewLocation, const FQuat& NewRotation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Sets the transform of the component relative to its parent. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set Relative Transform", ScriptName = "SetRelativeTransform"))
    void K2_SetRelativeTransform(
        const FTransform& NewTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Sets the transform of the component relative to its parent. */
    void SetRelativeTransform(const FTransform& NewTransform, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Returns the transform of the component relative to its parent. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Transformation")
    FTransform GetRelativeTransform() const;

    /** Resets the relative transform to the identity. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    void ResetRelativeTransform();

    /** Sets the non-uniform scale of the component relative to its parent. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    void SetRelativeScale3D(FVector NewScale3D);

    /** Adds a delta to the translation of the component relative to its parent. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Relative Location", ScriptName = "AddRelativeLocation"))
    void K2_AddRelativeLocation(FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the translation of the component relative to its parent. */
    void AddRelativeLocation(FVector DeltaLocation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the rotation of the component relative to its parent (the delta is applied after it). */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Relative Rotation", ScriptName = "AddRelativeRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddRelativeRotation(FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the rotation of the component relative to its parent. */
    void AddRelativeRotation(FRotator DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);
    /** Adds a delta to the rotation of the component relative to its parent. */
    void AddRelativeRotation(const FQuat& DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the location of the component in its own local frame. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Local Offset", ScriptName = "AddLocalOffset", Keywords = "location position"))
    void K2_AddLocalOffset(FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the location of the component in its own local frame. */
    void AddLocalOffset(FVector DeltaLocation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the rotation of the component in its own local frame. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Local Rotation", ScriptName = "AddLocalRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddLocalRotation(FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the rotation of the component in its own local frame. */
    void AddLocalRotation(FRotator DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);
    /** Adds a delta to the rotation of the component in its own local frame. */
    void AddLocalRotation(const FQuat& DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the transform of the component in its own local frame. Scale is unchanged. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add Local Transform", ScriptName = "AddLocalTransform"))
    void K2_AddLocalTransform(
        const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the transform of the component in its own local frame. Scale is unchanged. */
    void AddLocalTransform(const FTransform& DeltaTransform, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** The stored relative location, also when it was written raw. */
    const FVector& GetRelativeLocation() const { return RelativeLocation; }
    /** The stored relative rotation, also when it was written raw. */
    const FRotator& GetRelativeRotation() const { return RelativeRotation; }
    /** The stored relative scale, also when it was written raw. */
    const FVector& GetRelativeScale3D() const { return RelativeScale3D; }
    /** Writes the property only; the standard setters should be used. */
    void SetRelativeLocation_Direct(const FVector NewRelativeLocation) { RelativeLocation = NewRelativeLocation; }
    /** Writes the property only; the standard setters should be used. */
    void SetRelativeRotation_Direct(const FRotator NewRelativeRotation) { RelativeRotation = NewRelativeRotation; }
    /** Writes the property only; the standard setters should be used. */
    void SetRelativeScale3D_Direct(const FVector NewRelativeScale3D) { RelativeScale3D = NewRelativeScale3D; }

    // ---------------------------------------------------------------------------------------------- world transform

    /** Puts this component at the specified location in world space. Updates the relative location to achieve it. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set World Location", ScriptName = "SetWorldLocation"))
    void K2_SetWorldLocation(FVector NewLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Puts this component at the specified location in world space. */
    void SetWorldLocation(FVector NewLocation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Puts this component at the specified rotation in world space, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set World Rotation", ScriptName = "SetWorldRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_SetWorldRotation(FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Puts this component at the specified rotation in world space, in degrees. */
    void SetWorldRotation(FRotator NewRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);
    /** Puts this component at the specified rotation in world space. */
    void SetWorldRotation(const FQuat& NewRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Sets the scale of the component in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation")
    void SetWorldScale3D(FVector NewScale);

    /** Sets location and rotation of the component in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set World Location And Rotation", ScriptName = "SetWorldLocationAndRotation"))
    void K2_SetWorldLocationAndRotation(
        FVector NewLocation, FRotator NewRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Sets location and rotation of the component in world space. */
    void SetWorldLocationAndRotation(FVector NewLocation, FRotator NewRotation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);
    /** Sets location and rotation of the component in world space. */
    void SetWorldLocationAndRotation(FVector NewLocation, const FQuat& NewRotation, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Sets the transform of the component in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Set World Transform", ScriptName = "SetWorldTransform"))
    void K2_SetWorldTransform(const FTransform& NewTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Sets the transform of the component in world space. */
    void SetWorldTransform(const FTransform& NewTransform, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the location of the component in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add World Offset", ScriptName = "AddWorldOffset", Keywords = "location position"))
    void K2_AddWorldOffset(FVector DeltaLocation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the location of the component in world space. */
    void AddWorldOffset(FVector DeltaLocation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the rotation of the component in world space. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add World Rotation", ScriptName = "AddWorldRotation",
            AdvancedDisplay = "bSweep,SweepHitResult,bTeleport"))
    void K2_AddWorldRotation(FRotator DeltaRotation, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the rotation of the component in world space. */
    void AddWorldRotation(FRotator DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);
    /** Adds a delta to the rotation of the component in world space. */
    void AddWorldRotation(const FQuat& DeltaRotation, bool bSweep = false, FHitResult* OutSweepHitResult = nullptr,
        ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the transform of the component in world space. Ignores scale and sets it to (1,1,1). */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add World Transform", ScriptName = "AddWorldTransform"))
    void K2_AddWorldTransform(
        const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the transform of the component in world space. Ignores scale and sets it to (1,1,1). */
    void AddWorldTransform(const FTransform& DeltaTransform, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Adds a delta to the transform of the component in world space. Scale is unchanged. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Add World Transform Keep Scale", ScriptName = "AddWorldTransformKeepScale"))
    void K2_AddWorldTransformKeepScale(
        const FTransform& DeltaTransform, bool bSweep, FHitResult& SweepHitResult, bool bTeleport);
    /** Adds a delta to the transform of the component in world space. Scale is unchanged. */
    void AddWorldTransformKeepScale(const FTransform& DeltaTransform, bool bSweep = false,
        FHitResult* OutSweepHitResult = nullptr, ETeleportType Teleport = ETeleportType::None);

    /** Returns the location of the component, in world space. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Transformation",
        meta = (DisplayName = "Get World Location", ScriptName = "GetWorldLocation", Keywords = "position"))
    FVector K2_GetComponentLocation() const;

    /** Returns the rotation of the component, in world space, in degrees. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Transformation",
        meta = (DisplayName = "Get World Rotation", ScriptName = "GetWorldRotation"))
    FRotator K2_GetComponentRotation() const;

    /** Returns the scale of the component, in world space. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Transformation",
        meta = (DisplayName = "Get World Scale", ScriptName = "GetWorldScale"))
    FVector K2_GetComponentScale() const;

    /** Returns the current component-to-world transform. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Transformation",
        meta = (DisplayName = "Get World Transform", ScriptName = "GetWorldTransform"))
    FTransform K2_GetComponentToWorld() const;

    /** Returns the forward (X) unit direction vector of this component, in world space. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Transformation")
    FVector GetForwardVector() const;

    /** Returns the right (Y) unit direction vector of this component, in world space. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Transformation")
    FVector GetRightVector() const;

    /** Returns the up (Z) unit direction vector of this component, in world space. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Transformation")
    FVector GetUpVector() const;

    /** The current component-to-world transform. */
    const FTransform& GetComponentTransform() const { return ComponentToWorld; }
    /** The current component-to-world transform. */
    const FTransform& GetComponentToWorld() const { return ComponentToWorld; }
    /** Location of the component, in world space. */
    FVector GetComponentLocation() const { return ComponentToWorld.GetLocation(); }
    /** Rotation of the component, in world space, in degrees. */
    FRotator GetComponentRotation() const { return ComponentToWorld.Rotator(); }
    /** Rotation of the component, in world space. */
    FQuat GetComponentQuat() const { return ComponentToWorld.GetRotation(); }
    /** Scale of the component, in world space. */
    FVector GetComponentScale() const { return ComponentToWorld.GetScale3D(); }
    /** Replaces the world transform without any other side effect; for components that compute their own. */
    void SetComponentToWorld(const FTransform& NewComponentToWorld);

    /** Sets which parts of the relative transform are relative to the world instead of the parent. */
    UFUNCTION(BlueprintCallable, Category = "Utilities|Transformation")
    void SetAbsolute(
        bool bNewAbsoluteLocation = false, bool bNewAbsoluteRotation = false, bool bNewAbsoluteScale = false);
    /** Whether the location is absolute. */
    bool IsUsingAbsoluteLocation() const { return bAbsoluteLocation; }
    /** Whether the rotation is absolute. */
    bool IsUsingAbsoluteRotation() const { return bAbsoluteRotation; }
    /** Whether the scale is absolute. */
    bool IsUsingAbsoluteScale() const { return bAbsoluteScale; }
    /** Writes the flag and refreshes nothing. */
    void SetUsingAbsoluteLocation(const bool bInAbsoluteLocation) { bAbsoluteLocation = bInAbsoluteLocation; }
    /** Writes the flag and refreshes nothing. */
    void SetUsingAbsoluteRotation(const bool bInAbsoluteRotation) { bAbsoluteRotation = bInAbsoluteRotation; }
    /** Writes the flag and refreshes nothing. */
    void SetUsingAbsoluteScale(const bool bInAbsoluteScale) { bAbsoluteScale = bInAbsoluteScale; }

    /** Returns the velocity of the component, in centimetres per second. */
    UFUNCTION(BlueprintCallable, Category = "Utilities|Transformation")
    virtual FVector GetComponentVelocity() const;

    /** Recomputes the world transform, bounds and attached children from the relative transform. */
    void UpdateComponentToWorld(EUpdateTransformFlags UpdateTransformFlags = EUpdateTransformFlags::None,
        ETeleportType Teleport = ETeleportType::None);
    /** Recomputes the world transform if that never happened, the parents' first. */
    void ConditionalUpdateComponentToWorld();
    /** The world transform that a relative transform gives under a parent (null: our own) and its socket. */
    FTransform CalcNewComponentToWorld(const FTransform& NewRelativeTransform, const USceneComponent* Parent = nullptr,
        FName SocketName = NAME_None) const;

    /**
     * Moves the component by a delta in world space and sets its world rotation.
     * @return whether the component moved or there was nothing to do; false when its mobility forbids it
     */
    bool MoveComponent(const FVector& Delta, const FQuat& NewRotation, bool bSweep, FHitResult* Hit = nullptr,
        EMoveComponentFlags MoveFlags = MOVECOMP_NoFlags, ETeleportType Teleport = ETeleportType::None);
    /** Moves the component by a delta in world space and sets its world rotation, in degrees. */
    bool MoveComponent(const FVector& Delta, const FRotator& NewRotation, bool bSweep, FHitResult* Hit = nullptr,
        EMoveComponentFlags MoveFlags = MOVECOMP_NoFlags, ETeleportType Teleport = ETeleportType::None);

    // -------------------------------------------------------------------------------------------------- attachment

    /** Gets all components this one is attached to, up to the root. */
    UFUNCTION(BlueprintCallable, Category = "Components")
    void GetParentComponents(TArray<USceneComponent*>& Parents) const;

    /** Gets the number of attached children components. */
    UFUNCTION(BlueprintCallable, Category = "Components")
    int32 GetNumChildrenComponents() const;

    /** Gets the attached child component at the specified location, or null when there is none. */
    UFUNCTION(BlueprintCallable, Category = "Components")
    USceneComponent* GetChildComponent(int32 ChildIndex) const;

    /**
     * Gets the attached children components.
     * @param bIncludeAllDescendants whether to include the children of the children too (parents before their children)
     */
    UFUNCTION(BlueprintCallable, Category = "Components")
    void GetChildrenComponents(bool bIncludeAllDescendants, TArray<USceneComponent*>& Children) const;

    /** Gets the component we are attached to. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Utilities|Transformation")
    USceneComponent* GetAttachParent() const;

    /** Gets the socket we are attached to. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Utilities|Transformation")
    FName GetAttachSocketName() const;

    /** The attached children. */
    const TArray<TObjectPtr<USceneComponent>>& GetAttachChildren() const { return AttachChildren; }
    /** The top of the attachment hierarchy this component is in: itself when it is attached to nothing. */
    USceneComponent* GetAttachmentRoot() const;
    /** The owner of the top of the hierarchy. */
    AActor* GetAttachmentRootActor() const;
    /** The owner of the component we are attached to, or null. */
    AActor* GetAttachParentActor() const;
    /** Whether this component is attached, directly or not, to that one. */
    bool IsAttachedTo(const USceneComponent* TestComp) const;

    /**
     * Attaches this component to another one.
     * @param Parent             what to attach to
     * @param SocketName         optional socket on the parent
     * @param LocationRule       how to handle the translation
     * @param RotationRule       how to handle the rotation
     * @param ScaleRule          how to handle the scale
     * @param bWeldSimulatedBodies whether to weld simulated physics bodies together
     * @return whether the component is now attached
     */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Attach Component To Component", ScriptName = "AttachToComponent",
            bWeldSimulatedBodies = true))
    bool K2_AttachToComponent(USceneComponent* Parent, FName SocketName, EAttachmentRule LocationRule,
        EAttachmentRule RotationRule, EAttachmentRule ScaleRule, bool bWeldSimulatedBodies);
    /** Attaches this component to another one. Refused, with a warning in the log, where it would make a loop. */
    bool AttachToComponent(
        USceneComponent* InParent, const FAttachmentTransformRules& AttachmentRules, FName InSocketName = NAME_None);

    /** Detaches this component from whatever it is attached to. */
    UFUNCTION(BlueprintCallable, Category = "Transformation",
        meta = (DisplayName = "Detach From Component", ScriptName = "DetachFromComponent"))
    void K2_DetachFromComponent(EDetachmentRule LocationRule = EDetachmentRule::KeepRelative,
        EDetachmentRule RotationRule = EDetachmentRule::KeepRelative,
        EDetachmentRule ScaleRule = EDetachmentRule::KeepRelative, bool bCallModify = true);
    /** Detaches this component from whatever it is attached to, and its descendants with it. */
    virtual void DetachFromComponent(const FDetachmentTransformRules& DetachmentRules);

    /**
     * Names the parent that this component is attached to when it is registered. For constructors and for components
     * that are not registered yet.
     */
    void SetupAttachment(USceneComponent* InParent, FName InSocketName = NAME_None);

    // ----------------------------------------------------------------------------------------------------- sockets

    /** Gets the names of all the sockets on the component. */
    UFUNCTION(BlueprintCallable, Category = "Utilities|Transformation", meta = (Keywords = "Bone"))
    TArray<FName> GetAllSocketNames() const;

    /** Gets the world-space socket transform; the component's own when there is no such socket. */
    UFUNCTION(BlueprintCallable, Category = "Utilities|Transformation", meta = (Keywords = "Bone"))
    virtual FTransform GetSocketTransform(FName InSocketName, ERelativeTransformSpace TransformSpace = RTS_World) const;

    /** Gets the world-space socket location. */
    UFUNCTION(BlueprintCallable, Category = "Utilities|Transformation", meta = (Keywords = "Bone"))
    virtual FVector GetSocketLocation(FName InSocketName) const;

    /** Gets the world-space socket rotation, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Utilities|Transformation", meta = (Keywords = "Bone"))
    virtual FRotator GetSocketRotation(FName InSocketName) const;

    /** Gets the world-space socket rotation as a quaternion. */
    UFUNCTION(BlueprintCallable, Category = "Utilities|Transformation", meta = (Keywords = "Bone"))
    virtual FQuat GetSocketQuaternion(FName InSocketName) const;

    /** Whether a socket with that name exists. */
    UFUNCTION(BlueprintCallable, Category = "Utilities|Transformation", meta = (Keywords = "Bone"))
    virtual bool DoesSocketExist(FName InSocketName) const;

    /** Whether there is any socket. */
    virtual bool HasAnySockets() const;
    /** Lists the sockets. */
    virtual void QuerySupportedSockets(TArray<FComponentSocketDescription>& OutSockets) const;

    // ----------------------------------------------------------------------------------------- visibility, mobility

    /** Returns true if this component is visible in the current context. */
    UFUNCTION(BlueprintCallable, BlueprintPure, Category = "Rendering")
    virtual bool IsVisible() const;

    /**
     * Sets the visibility of the component.
     * @param bNewVisibility       whether it is visible
     * @param bPropagateToChildren whether to apply the same to all attached children, recursively
     */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetVisibility(bool bNewVisibility, bool bPropagateToChildren = false);

    /** Toggles the visibility of the component. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void ToggleVisibility(bool bPropagateToChildren = false);

    /** Changes the value of bHiddenInGame, optionally for all attached children too. */
    UFUNCTION(BlueprintCallable, Category = "Development")
    virtual void SetHiddenInGame(bool NewHidden, bool bPropagateToChildren = false);

    /** Whether the component is drawn: visible, not hidden in game, and its owner not hidden. */
    virtual bool ShouldRender() const;
    /** The stored `bVisible`. */
    bool GetVisibleFlag() const { return bVisible; }
    /** Writes `bVisible` only. */
    void SetVisibleFlag(const bool bInVisible) { bVisible = bInVisible; }

    /** Sets how often this component is allowed to move during runtime. */
    UFUNCTION(BlueprintCallable, Category = "Mobility")
    virtual void SetMobility(EComponentMobility::Type NewMobility);

    // ------------------------------------------------------------------------------------------------------ bounds

    /** The bounds the component would have under that transform. */
    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const;
    /** The bounds in the component's own space, scale not applied. */
    virtual FBoxSphereBounds CalcLocalBounds() const;
    /** The bounds in the component's own space, scale not applied. */
    FBoxSphereBounds GetLocalBounds() const { return CalcLocalBounds(); }
    /** Recomputes `Bounds`. */
    virtual void UpdateBounds();

    // UActorComponent
    virtual void OnRegister() override;
    virtual void OnUnregister() override;
    virtual void OnComponentDestroyed(bool bDestroyingHierarchy) override;
    /** With bPromoteChildren, hands the children to our parent (or makes the first the root) before the component is
     * destroyed. */
    virtual void DestroyComponent(bool bPromoteChildren = false) override;
    virtual void PostInitProperties() override;

protected:
    /** Called after the world transform changed. */
    virtual void OnUpdateTransform(
        EUpdateTransformFlags UpdateTransformFlags, ETeleportType Teleport = ETeleportType::None);
    /** Called after this component was attached or detached. */
    virtual void OnAttachmentChanged() {}
    /** Called after a child was attached to this component. */
    virtual void OnChildAttached(USceneComponent* ChildComponent);
    /** Called after a child was detached from this component. */
    virtual void OnChildDetached(USceneComponent* ChildComponent);
    /** Called after `bVisible` changed. */
    virtual void OnVisibilityChanged();
    /** Called after `bHiddenInGame` changed. */
    virtual void OnHiddenInGameChanged();
    /** Does the move of `MoveComponent`. */
    virtual bool MoveComponentImpl(const FVector& Delta, const FQuat& NewRotation, bool bSweep, FHitResult* Hit,
        EMoveComponentFlags MoveFlags, ETeleportType Teleport);
    /** Updates bounds, children and listeners after the world transform (or, with false, only the bounds) changed. */
    virtual void PropagateTransformUpdate(bool bTransformChanged,
        EUpdateTransformFlags UpdateTransformFlags = EUpdateTransformFlags::None,
        ETeleportType Teleport = ETeleportType::None);
    /** Updates the world transforms of the attached children. */
    void UpdateChildTransforms(EUpdateTransformFlags UpdateTransformFlags = EUpdateTransformFlags::None,
        ETeleportType Teleport = ETeleportType::None);
    /** Whether moving is forbidden now by the mobility; if so it says so in the log. */
    bool CheckStaticMobilityAndWarn(const TCHAR* ActionText) const;

private:
    /** Current transform of the component, relative to the world. */
    FTransform ComponentToWorld;

    /** Whether ComponentToWorld was ever computed. */
    uint8 bComponentToWorldUpdated : 1;

    void UpdateComponentToWorldWithParent(USceneComponent* Parent, FName SocketName,
        EUpdateTransformFlags UpdateTransformFlags, const FQuat& RelativeRotationQuat, ETeleportType Teleport);
    bool InternalSetWorldLocationAndRotation(
        const FVector& NewLocation, const FQuat& NewRotation, ETeleportType Teleport);
    // The exact quaternion behind RelativeRotation: a rotator round trip would let repeated moves drift. It is used
    // only while it still matches the property, so a raw write wins.
    FQuat GetRelativeQuat() const;
    void SetRelativeRotationExactly(const FQuat& NewRotation);
    // The quaternion of angles, which are remembered so that the property shows them again after the move.
    FQuat RememberedQuat(const FRotator& Rotation);
    FQuat CachedRelativeQuat;
    FRotator CachedRelativeRotator;
};
