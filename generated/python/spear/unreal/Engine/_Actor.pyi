# generated, do not edit (Engine: Public/GameFramework/Actor.h)
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias, TypeVar, overload
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, AsyncPath, AsyncValuePath, BoolProperty, FloatProperty, Future,
    ObjectPath, Path, Property, SendBoolProperty, SendFloatProperty, SendProperty, ValuePath,
)
from ..CoreUObject._Intrinsic import FScriptDelegate, FScriptDelegate_in, UClass, UInterface
from ..CoreUObject._NoExportTypes import (
    FRotator, FRotator_in, FTransform, FTransform_in, FVector, FVector_in, UObject, UObject_async, UObject_members, UObject_send,
)
from ._ActorComponent import UActorComponent, UActorComponent_async_path, UActorComponent_path
from ._Controller import AController
from ._EngineBaseTypes import ETickingGroup_in, FActorTickFunction_async, FActorTickFunction_in, FActorTickFunction_path
from ._EngineTypes import (
    EAttachmentRule_in, EDetachmentRule, EDetachmentRule_in, EEndPlayReason_in, ENetRole, ESpawnActorCollisionHandlingMethod,
    ESpawnActorCollisionHandlingMethod_in,
)
from ._HitResult import FHitResult, FHitResult_in
from ._Level import ULevel
from ._Pawn import APawn, APawn_async_path, APawn_path
from ._PlayerController import APlayerController
from ._PrimitiveComponent import UPrimitiveComponent
from ._SceneComponent import USceneComponent, USceneComponent_async_path, USceneComponent_path
_T_UActorComponent = TypeVar("_T_UActorComponent", bound=UActorComponent)

FActorBeginOverlapSignature: TypeAlias = list[FScriptDelegate]
"""Called as FActorBeginOverlapSignature(OverlappedActor: AActor, OtherActor: AActor); a value tells what is bound.

Unreal: /Script/Engine.ActorBeginOverlapSignature__DelegateSignature
"""

FActorEndOverlapSignature: TypeAlias = list[FScriptDelegate]
"""Called as FActorEndOverlapSignature(OverlappedActor: AActor, OtherActor: AActor); a value tells what is bound.

Unreal: /Script/Engine.ActorEndOverlapSignature__DelegateSignature
"""

FActorHitSignature: TypeAlias = list[FScriptDelegate]
"""Called as FActorHitSignature(SelfActor: AActor, OtherActor: AActor, NormalImpulse: FVector, Hit: FHitResult); a value tells what is bound.

Unreal: /Script/Engine.ActorHitSignature__DelegateSignature
"""

FActorDestroyedSignature: TypeAlias = list[FScriptDelegate]
"""Called as FActorDestroyedSignature(DestroyedActor: AActor); a value tells what is bound.

Unreal: /Script/Engine.ActorDestroyedSignature__DelegateSignature
"""

FActorEndPlaySignature: TypeAlias = list[FScriptDelegate]
"""Called as FActorEndPlaySignature(Actor: AActor, EndPlayReason: EEndPlayReason); a value tells what is bound.

Unreal: /Script/Engine.ActorEndPlaySignature__DelegateSignature
"""

class AActor_GetActorBounds_Result(NamedTuple):
    """Results of AActor.GetActorBounds."""
    Origin: FVector
    """set to the center of the actor in world space."""
    BoxExtent: FVector
    """set to half the actor's size in 3d space."""

class AActor_GetActorEyesViewPoint_Result(NamedTuple):
    """Results of AActor.GetActorEyesViewPoint."""
    OutLocation: FVector
    OutRotation: FRotator

class AActor_GetAttachedActors_Result(NamedTuple):
    """Results of AActor.GetAttachedActors."""
    OutActors: list[AActor]
    """receives them."""

class AActor_K2_AddActorLocalOffset_Result(NamedTuple):
    """Results of AActor.K2_AddActorLocalOffset."""
    SweepHitResult: FHitResult

class AActor_K2_AddActorLocalRotation_Result(NamedTuple):
    """Results of AActor.K2_AddActorLocalRotation."""
    SweepHitResult: FHitResult

class AActor_K2_AddActorLocalTransform_Result(NamedTuple):
    """Results of AActor.K2_AddActorLocalTransform."""
    SweepHitResult: FHitResult

class AActor_K2_AddActorWorldOffset_Result(NamedTuple):
    """Results of AActor.K2_AddActorWorldOffset."""
    SweepHitResult: FHitResult

class AActor_K2_AddActorWorldRotation_Result(NamedTuple):
    """Results of AActor.K2_AddActorWorldRotation."""
    SweepHitResult: FHitResult

class AActor_K2_AddActorWorldTransform_Result(NamedTuple):
    """Results of AActor.K2_AddActorWorldTransform."""
    SweepHitResult: FHitResult

class AActor_K2_AddActorWorldTransformKeepScale_Result(NamedTuple):
    """Results of AActor.K2_AddActorWorldTransformKeepScale."""
    SweepHitResult: FHitResult

class AActor_K2_SetActorLocation_Result(NamedTuple):
    """Results of AActor.K2_SetActorLocation."""
    ReturnValue: bool
    """whether the location was successfully set (if not swept), or whether movement occurred at all (if swept)."""
    SweepHitResult: FHitResult
    """the hit result from the move if swept."""

class AActor_K2_SetActorLocationAndRotation_Result(NamedTuple):
    """Results of AActor.K2_SetActorLocationAndRotation."""
    ReturnValue: bool
    SweepHitResult: FHitResult
    """see K2_SetActorLocation."""

class AActor_K2_SetActorRelativeLocation_Result(NamedTuple):
    """Results of AActor.K2_SetActorRelativeLocation."""
    SweepHitResult: FHitResult

class AActor_K2_SetActorRelativeRotation_Result(NamedTuple):
    """Results of AActor.K2_SetActorRelativeRotation."""
    SweepHitResult: FHitResult

class AActor_K2_SetActorRelativeTransform_Result(NamedTuple):
    """Results of AActor.K2_SetActorRelativeTransform."""
    SweepHitResult: FHitResult

class AActor_K2_SetActorTransform_Result(NamedTuple):
    """Results of AActor.K2_SetActorTransform."""
    ReturnValue: bool
    SweepHitResult: FHitResult

class AActor_members(UObject_members):
    """Functions and variables of AActor."""
    def ActorHasTag(self, Tag: str | Future[str]) -> bool:
        """See if this actor's Tags array contains the supplied name tag.

        Unreal: AActor.ActorHasTag
        """
    @overload
    def AddComponentByClass(self, Class: type[_T_UActorComponent], bManualAttachment: bool | Future[bool], RelativeTransform: FTransform_in, bDeferredFinish: bool | Future[bool]) -> _T_UActorComponent:
        """Creates a new component and assigns ownership to the Actor this is called for. Automatic attachment causes the
        first component created to become the root, and all subsequent components to be attached under that root. When
        bManualAttachment is set, automatic attachment is skipped and it is up to the user to attach the resulting
        component (or set it up as the root) themselves.

        Args:
            Class: class of component to create.
            bManualAttachment: whether manual or automatic attachment is to be used.
            RelativeTransform: relative transform between the new component and its attach parent (automatic only).
            bDeferredFinish: whether or not to immediately complete the creation and registration process for this component. FinishAddComponent must be called.

        Unreal: AActor.AddComponentByClass
        """
    @overload
    def AddComponentByClass(self, Class: UClass | str | Future[UClass], bManualAttachment: bool | Future[bool], RelativeTransform: FTransform_in, bDeferredFinish: bool | Future[bool]) -> UActorComponent: ...
    def AddTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> None:
        """Make this actor tick after PrerequisiteActor. This only applies to this actor's tick function; dependencies
        for owned components must be set separately if desired.

        Unreal: AActor.AddTickPrerequisiteActor
        """
    def AddTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> None:
        """Make this actor tick after PrerequisiteComponent.

        Unreal: AActor.AddTickPrerequisiteComponent
        """
    @overload
    def FindComponentByTag(self, ComponentClass: type[_T_UActorComponent], Tag: str | Future[str]) -> _T_UActorComponent | None:
        """Searches components array and returns the first component of the class that has the tag, or null.

        Unreal: AActor.FindComponentByTag
        """
    @overload
    def FindComponentByTag(self, ComponentClass: UClass | str | Future[UClass], Tag: str | Future[str]) -> UActorComponent | None: ...
    def FinishAddComponent(self, Component: UActorComponent | Future[UActorComponent], bManualAttachment: bool | Future[bool], RelativeTransform: FTransform_in) -> None:
        """Completes the creation of a new actor component. Called either from AddComponentByClass, or after setting
        exposed properties of a component with bDeferredFinish.

        Unreal: AActor.FinishAddComponent
        """
    def GetActorBounds(self, bOnlyCollidingComponents: bool | Future[bool], bIncludeFromChildActors: bool | Future[bool] = False) -> AActor_GetActorBounds_Result:
        """Returns the bounding box of all components that make up this Actor (excluding ChildActorComponents).

        Args:
            bOnlyCollidingComponents: if true, will only return the bounding box for components with collision enabled.
            bIncludeFromChildActors: not used: there are no child actor components.

        Returns:
            Origin: set to the center of the actor in world space.
            BoxExtent: set to half the actor's size in 3d space.

        Unreal: AActor.GetActorBounds
        """
    def GetActorEnableCollision(self) -> bool:
        """Get current state of collision for the whole actor.

        Unreal: AActor.GetActorEnableCollision
        """
    def GetActorEyesViewPoint(self) -> AActor_GetActorEyesViewPoint_Result:
        """Returns the point of view of the actor: the location and rotation of its root component, or of its eyes for
        pawns.

        Unreal: AActor.GetActorEyesViewPoint
        """
    def GetActorForwardVector(self) -> FVector:
        """Get the forward (X) vector (length 1.0) from this Actor, in world space.

        Unreal: AActor.GetActorForwardVector
        """
    def GetActorRelativeScale3D(self) -> FVector:
        """Return the actor's relative scale 3d.

        Unreal: AActor.GetActorRelativeScale3D
        """
    def GetActorRightVector(self) -> FVector:
        """Get the right (Y) vector (length 1.0) from this Actor, in world space.

        Unreal: AActor.GetActorRightVector
        """
    def GetActorScale3D(self) -> FVector:
        """Returns the Actor's world-space scale.

        Unreal: AActor.GetActorScale3D
        """
    def GetActorTickInterval(self) -> float:
        """Returns the tick interval of this actor's primary tick function, in seconds.

        Unreal: AActor.GetActorTickInterval
        """
    def GetActorUpVector(self) -> FVector:
        """Get the up (Z) vector (length 1.0) from this Actor, in world space.

        Unreal: AActor.GetActorUpVector
        """
    def GetAttachParentActor(self) -> AActor | None:
        """Walk up the attachment chain from RootComponent until we encounter a different actor, and return it. If we are
        not attached to a component in a different actor, returns nullptr.

        Unreal: AActor.GetAttachParentActor
        """
    def GetAttachParentSocketName(self) -> str:
        """Walk up the attachment chain from RootComponent until we encounter a different actor, and return the socket
        name in the component. NAME_None if there is none.

        Unreal: AActor.GetAttachParentSocketName
        """
    def GetAttachedActors(self, bResetArray: bool | Future[bool] = True, bRecursivelyIncludeAttachedActors: bool | Future[bool] = False) -> AActor_GetAttachedActors_Result:
        """Find all Actors which are attached directly to a component in this actor.

        Args:
            bResetArray: whether to empty the array first.
            bRecursivelyIncludeAttachedActors: whether to add the actors attached to those, and so on.

        Returns:
            OutActors: receives them.

        Unreal: AActor.GetAttachedActors
        """
    @overload
    def GetComponentByClass(self, ComponentClass: type[_T_UActorComponent]) -> _T_UActorComponent | None:
        """Script exposed version of FindComponentByClass.

        Unreal: AActor.GetComponentByClass
        """
    @overload
    def GetComponentByClass(self, ComponentClass: UClass | str | Future[UClass]) -> UActorComponent | None: ...
    def GetComponentsByInterface(self, Interface: type[UInterface] | UClass | str | Future[UClass]) -> list[UActorComponent | None]:
        """Gets all the components that implement the given interface.

        Unreal: AActor.GetComponentsByInterface
        """
    @overload
    def GetComponentsByTag(self, ComponentClass: type[_T_UActorComponent], Tag: str | Future[str]) -> list[_T_UActorComponent | None]:
        """Gets all the components that inherit from the given class with a given tag.

        Unreal: AActor.GetComponentsByTag
        """
    @overload
    def GetComponentsByTag(self, ComponentClass: UClass | str | Future[UClass], Tag: str | Future[str]) -> list[UActorComponent | None]: ...
    def GetDistanceTo(self, OtherActor: AActor | Future[AActor]) -> float:
        """Returns the distance from this Actor to OtherActor, in centimetres.

        Unreal: AActor.GetDistanceTo
        """
    def GetDotProductTo(self, OtherActor: AActor | Future[AActor]) -> float:
        """Returns the dot product from this Actor to OtherActor. Returns -2.0 on failure. Returns 0.0 for coincidental
        actors.

        Unreal: AActor.GetDotProductTo
        """
    def GetGameTimeSinceCreation(self) -> float:
        """The number of seconds (in game time) since this Actor was created, relative to Get Game Time In Seconds.

        Unreal: AActor.GetGameTimeSinceCreation
        """
    def GetHorizontalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> float:
        """Returns the distance from this Actor to OtherActor, ignoring Z.

        Unreal: AActor.GetHorizontalDistanceTo
        """
    def GetHorizontalDotProductTo(self, OtherActor: AActor | Future[AActor]) -> float:
        """Returns the dot product from this Actor to OtherActor, ignoring Z. Returns -2.0 on failure. Returns 0.0 for
        coincidental actors.

        Unreal: AActor.GetHorizontalDotProductTo
        """
    def GetInstigator(self) -> APawn | None:
        """Returns the instigator for this actor, or nullptr if there is none.

        Unreal: AActor.GetInstigator
        """
    def GetInstigatorController(self) -> AController | None:
        """Returns the instigator's controller for this actor, or nullptr if there is none.

        Unreal: AActor.GetInstigatorController
        """
    def GetLevel(self) -> ULevel:
        """Return the ULevel that this Actor is part of.

        Unreal: AActor.GetLevel
        """
    def GetLevelTransform(self) -> FTransform:
        """Return the FTransform of the level this actor is a part of: the identity.

        Unreal: AActor.GetLevelTransform
        """
    def GetLifeSpan(self) -> float:
        """Get the remaining lifespan of this actor, in seconds. If zero is returned the actor lives forever.

        Unreal: AActor.GetLifeSpan
        """
    def GetLocalRole(self) -> ENetRole:
        """Returns how much control the local machine has over this actor.

        Unreal: AActor.GetLocalRole
        """
    def GetOwner(self) -> AActor | None:
        """Get the owner of this Actor, used primarily for network replication.

        Unreal: AActor.GetOwner
        """
    def GetRemoteRole(self) -> ENetRole:
        """Returns how much control the remote machine has over this actor.

        Unreal: AActor.GetRemoteRole
        """
    def GetSquaredDistanceTo(self, OtherActor: AActor | Future[AActor]) -> float:
        """Returns the squared distance from this Actor to OtherActor.

        Unreal: AActor.GetSquaredDistanceTo
        """
    def GetSquaredHorizontalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> float:
        """Returns the squared distance from this Actor to OtherActor, ignoring Z.

        Unreal: AActor.GetSquaredHorizontalDistanceTo
        """
    def GetTickableWhenPaused(self) -> bool:
        """Gets whether this actor can tick when paused.

        Unreal: AActor.GetTickableWhenPaused
        """
    def GetTransform(self) -> FTransform:
        """Get the actor-to-world transform.

        Unreal: AActor.GetTransform
        """
    def GetVelocity(self) -> FVector:
        """Returns velocity (in cm/s (Unreal Units/second) of the rootcomponent if it is either using physics or has an
        associated MovementComponent.

        Unreal: AActor.GetVelocity
        """
    def GetVerticalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> float:
        """Returns the distance from this Actor to OtherActor, ignoring XY.

        Unreal: AActor.GetVerticalDistanceTo
        """
    def HasAuthority(self) -> bool:
        """Returns whether this actor has network authority: always, without network.

        Unreal: AActor.HasAuthority
        """
    def IsActorBeingDestroyed(self) -> bool:
        """Returns true if this actor has begun the destruction process.

        Unreal: AActor.IsActorBeingDestroyed
        """
    def IsActorTickEnabled(self) -> bool:
        """Returns whether this actor has tick enabled or not.

        Unreal: AActor.IsActorTickEnabled
        """
    def K2_AddActorLocalOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_AddActorLocalOffset_Result:
        """Adds a delta to the location of this component in its local reference frame.

        Unreal: AActor.K2_AddActorLocalOffset
        """
    def K2_AddActorLocalRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_AddActorLocalRotation_Result:
        """Adds a delta to the rotation of this component in its local reference frame.

        Unreal: AActor.K2_AddActorLocalRotation
        """
    def K2_AddActorLocalTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_AddActorLocalTransform_Result:
        """Adds a delta to the transform of this component in its local reference frame.

        Unreal: AActor.K2_AddActorLocalTransform
        """
    def K2_AddActorWorldOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_AddActorWorldOffset_Result:
        """Adds a delta to the location of this actor in world space.

        Unreal: AActor.K2_AddActorWorldOffset
        """
    def K2_AddActorWorldRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_AddActorWorldRotation_Result:
        """Adds a delta to the rotation of this actor in world space.

        Unreal: AActor.K2_AddActorWorldRotation
        """
    def K2_AddActorWorldTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_AddActorWorldTransform_Result:
        """Adds a delta to the transform of this actor in world space. Scale is unchanged.

        Unreal: AActor.K2_AddActorWorldTransform
        """
    def K2_AddActorWorldTransformKeepScale(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_AddActorWorldTransformKeepScale_Result:
        """Adds a delta to the transform of this actor in world space. Scale is unchanged. Ignores scale and sets it to
        (1,1,1) in the delta.

        Unreal: AActor.K2_AddActorWorldTransformKeepScale
        """
    def K2_AttachToActor(self, ParentActor: AActor | Future[AActor], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> bool:
        """Attaches the RootComponent of this Actor to the RootComponent of the supplied actor, optionally at a named
        socket. See K2_AttachToComponent.

        Unreal: AActor.K2_AttachToActor
        """
    def K2_AttachToComponent(self, Parent: USceneComponent | Future[USceneComponent], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> bool:
        """Attaches the RootComponent of this Actor to the supplied component, optionally at a named socket.

        Args:
            Parent: parent to attach to.
            SocketName: optional socket to attach to on the parent.
            LocationRule: how to handle translation when attaching.
            RotationRule: how to handle rotation when attaching.
            ScaleRule: how to handle scale when attaching.
            bWeldSimulatedBodies: whether to weld together simulated physics bodies. Not used without physics.

        Returns:
            whether the attachment was successful.

        Unreal: AActor.K2_AttachToComponent
        """
    def K2_DestroyActor(self) -> None:
        """Destroy the actor.

        Unreal: AActor.K2_DestroyActor
        """
    def K2_DetachFromActor(self, LocationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, RotationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, ScaleRule: EDetachmentRule_in = EDetachmentRule.KeepRelative) -> None:
        """Detaches the RootComponent of this Actor from any SceneComponent it is currently attached to.

        Unreal: AActor.K2_DetachFromActor
        """
    def K2_GetActorLocation(self) -> FVector:
        """Returns the location of the RootComponent of this Actor.

        Unreal: AActor.K2_GetActorLocation
        """
    def K2_GetActorRotation(self) -> FRotator:
        """Returns rotation of the RootComponent of this Actor.

        Unreal: AActor.K2_GetActorRotation
        """
    @overload
    def K2_GetComponentsByClass(self, ComponentClass: type[_T_UActorComponent]) -> list[_T_UActorComponent | None]:
        """Gets all the components that inherit from the given class. Currently returns an array of UActorComponent which
        must be cast to the correct type.

        Unreal: AActor.K2_GetComponentsByClass
        """
    @overload
    def K2_GetComponentsByClass(self, ComponentClass: UClass | str | Future[UClass]) -> list[UActorComponent | None]: ...
    def K2_GetRootComponent(self) -> USceneComponent:
        """Returns the RootComponent of this Actor.

        Unreal: AActor.K2_GetRootComponent
        """
    def K2_OnBecomeViewTarget(self, PC: APlayerController | Future[APlayerController]) -> None:
        """Event called when this Actor becomes the view target for the given PlayerController.

        Unreal: AActor.K2_OnBecomeViewTarget
        """
    def K2_OnEndViewTarget(self, PC: APlayerController | Future[APlayerController]) -> None:
        """Event called when this Actor is no longer the view target for the given PlayerController.

        Unreal: AActor.K2_OnEndViewTarget
        """
    def K2_OnReset(self) -> None:
        """Event called when this Actor is reset to its initial state - used when restarting level without reloading.

        Unreal: AActor.K2_OnReset
        """
    def K2_SetActorLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_SetActorLocation_Result:
        """Move the Actor to the specified location.

        Args:
            NewLocation: the new location to move the Actor to, in centimetres.
            bSweep: whether we sweep to the destination location, triggering overlaps along the way and stopping short of the target if blocked by something. Without collision the move is never blocked.
            bTeleport: whether we teleport the physics state (if physics collision is enabled for this object).

        Returns:
            whether the location was successfully set (if not swept), or whether movement occurred at all (if swept).
            SweepHitResult: the hit result from the move if swept.

        Unreal: AActor.K2_SetActorLocation
        """
    def K2_SetActorLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_SetActorLocationAndRotation_Result:
        """Move the actor instantly to the specified location and rotation.

        Args:
            NewLocation: the new location to teleport the Actor to.
            NewRotation: the new rotation for the Actor.
            bSweep: see K2_SetActorLocation.
            bTeleport: see K2_SetActorLocation.

        Returns:
            SweepHitResult: see K2_SetActorLocation.

        Unreal: AActor.K2_SetActorLocationAndRotation
        """
    def K2_SetActorRelativeLocation(self, NewRelativeLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_SetActorRelativeLocation_Result:
        """Set the actor's RootComponent to the specified relative location.

        Unreal: AActor.K2_SetActorRelativeLocation
        """
    def K2_SetActorRelativeRotation(self, NewRelativeRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_SetActorRelativeRotation_Result:
        """Set the actor's RootComponent to the specified relative rotation.

        Unreal: AActor.K2_SetActorRelativeRotation
        """
    def K2_SetActorRelativeTransform(self, NewRelativeTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_SetActorRelativeTransform_Result:
        """Set the actor's RootComponent to the specified relative transform.

        Unreal: AActor.K2_SetActorRelativeTransform
        """
    def K2_SetActorRotation(self, NewRotation: FRotator_in, bTeleportPhysics: bool | Future[bool]) -> bool:
        """Set the Actor's rotation instantly to the specified rotation.

        Args:
            NewRotation: the new rotation for the Actor, in degrees.
            bTeleportPhysics: whether we teleport the physics state (if physics collision is enabled for this object).

        Returns:
            whether the rotation was successfully set.

        Unreal: AActor.K2_SetActorRotation
        """
    def K2_SetActorTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> AActor_K2_SetActorTransform_Result:
        """Set the Actors transform to the specified one. See K2_SetActorLocation.

        Unreal: AActor.K2_SetActorTransform
        """
    def K2_TeleportTo(self, DestLocation: FVector_in, DestRotation: FRotator_in) -> bool:
        """Teleport this actor to a new location.

        Returns:
            true if the actor has been successfully moved.

        Unreal: AActor.K2_TeleportTo
        """
    def ReceiveActorBeginOverlap(self, OtherActor: AActor | Future[AActor]) -> None:
        """Event when this actor overlaps another actor, for example a player walking into a trigger.

        Unreal: AActor.ReceiveActorBeginOverlap
        """
    def ReceiveActorEndOverlap(self, OtherActor: AActor | Future[AActor]) -> None:
        """Event when an actor no longer overlaps another actor, and they have separated.

        Unreal: AActor.ReceiveActorEndOverlap
        """
    def ReceiveBeginPlay(self) -> None:
        """Event when play begins for this actor.

        Unreal: AActor.ReceiveBeginPlay
        """
    def ReceiveDestroyed(self) -> None:
        """Called when the actor has been explicitly destroyed.

        Unreal: AActor.ReceiveDestroyed
        """
    def ReceiveEndPlay(self, EndPlayReason: EEndPlayReason_in) -> None:
        """Event to notify blueprints this actor is being deleted or removed from a level.

        Unreal: AActor.ReceiveEndPlay
        """
    def ReceiveHit(self, MyComp: UPrimitiveComponent | Future[UPrimitiveComponent], Other: AActor | Future[AActor], OtherComp: UPrimitiveComponent | Future[UPrimitiveComponent], bSelfMoved: bool | Future[bool], HitLocation: FVector_in, HitNormal: FVector_in, NormalImpulse: FVector_in, Hit: FHitResult_in) -> None:
        """Event when this actor bumps into a blocking object, or blocks another actor that bumps into it.

        Unreal: AActor.ReceiveHit
        """
    def ReceiveTick(self, DeltaSeconds: float | Future[float]) -> None:
        """Event called every frame, if ticking is enabled.

        Unreal: AActor.ReceiveTick
        """
    def RemoveTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> None:
        """Remove tick dependency on PrerequisiteActor.

        Unreal: AActor.RemoveTickPrerequisiteActor
        """
    def RemoveTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> None:
        """Remove tick dependency on PrerequisiteComponent.

        Unreal: AActor.RemoveTickPrerequisiteComponent
        """
    def SetActorEnableCollision(self, bNewActorEnableCollision: bool | Future[bool]) -> None:
        """Allows enabling/disabling collision for the whole actor.

        Unreal: AActor.SetActorEnableCollision
        """
    def SetActorHiddenInGame(self, bNewHidden: bool | Future[bool]) -> None:
        """Sets the actor to be hidden in the game.

        Args:
            bNewHidden: whether or not to hide the actor and all its components.

        Unreal: AActor.SetActorHiddenInGame
        """
    def SetActorRelativeScale3D(self, NewRelativeScale: FVector_in) -> None:
        """Set the actor's RootComponent to the specified relative scale 3d.

        Unreal: AActor.SetActorRelativeScale3D
        """
    def SetActorScale3D(self, NewScale3D: FVector_in) -> None:
        """Set the Actor's world-space scale.

        Unreal: AActor.SetActorScale3D
        """
    def SetActorTickEnabled(self, bEnabled: bool | Future[bool]) -> None:
        """Sets whether this actor tick is enabled. Only modifies the tick function if it is registered.

        Unreal: AActor.SetActorTickEnabled
        """
    def SetActorTickInterval(self, TickInterval: float | Future[float]) -> None:
        """Sets the tick interval of this actor's primary tick function. Will not enable a disabled tick function. Takes
        effect on next tick.

        Args:
            TickInterval: the rate at which this actor should be ticking, in seconds.

        Unreal: AActor.SetActorTickInterval
        """
    def SetLifeSpan(self, InLifespan: float | Future[float]) -> None:
        """Set the lifespan of this actor. When it expires the object will be destroyed. If requested lifespan is 0, the
        timer is cleared and the actor will not be destroyed. Seconds.

        Unreal: AActor.SetLifeSpan
        """
    def SetOwner(self, NewOwner: AActor | Future[AActor]) -> None:
        """Set the owner of this Actor, used primarily for network replication.

        Args:
            NewOwner: the Actor who takes over ownership of this Actor.

        Unreal: AActor.SetOwner
        """
    def SetTickGroup(self, NewTickGroup: ETickingGroup_in) -> None:
        """Changes the ticking group for this actor.

        Unreal: AActor.SetTickGroup
        """
    def SetTickableWhenPaused(self, bTickableWhenPaused: bool | Future[bool]) -> None:
        """Sets whether this actor can tick when paused.

        Unreal: AActor.SetTickableWhenPaused
        """
    def UserConstructionScript(self) -> None:
        """Construction script, the place to spawn components and do other setup.

        Unreal: AActor.UserConstructionScript
        """
    PrimaryActorTick: Property[FActorTickFunction_path, FActorTickFunction_in]
    """Primary Actor tick function, which calls TickActor().

    Unreal: AActor.PrimaryActorTick (FActorTickFunction)
    """
    CustomTimeDilation: FloatProperty
    """Allow each actor to run at a different time speed. The DeltaTime for a frame is multiplied by the global
    TimeDilation (in WorldSettings) and this CustomTimeDilation for this actor's tick.

    Unreal: AActor.CustomTimeDilation (float)
    """
    InitialLifeSpan: FloatProperty
    """How long this Actor lives before dying, 0 = forever. Note this is the INITIAL value and should not be modified
    once play has begun. Seconds.

    Unreal: AActor.InitialLifeSpan (float)
    """
    bFindCameraComponentWhenViewTarget: BoolProperty
    """If true, this actor should search for an owned camera component to view through when used as a view target.

    Unreal: AActor.bFindCameraComponentWhenViewTarget (bool)
    """
    SpawnCollisionHandlingMethod: Property[ValuePath[ESpawnActorCollisionHandlingMethod, ESpawnActorCollisionHandlingMethod_in], ESpawnActorCollisionHandlingMethod_in]
    """Controls how to handle spawning this actor in a situation where it's colliding with something else. "Default"
    means AlwaysSpawn here.

    Unreal: AActor.SpawnCollisionHandlingMethod (ESpawnActorCollisionHandlingMethod)
    """
    Tags: Property[ArrayPath[str, str | Future[str], Path[str], AsyncPath[str]], Sequence[str | Future[str]] | Future[list[str]]]
    """Array of tags that can be used for grouping and categorizing.

    Unreal: AActor.Tags (TArray<FName>)
    """
    Children: Property[ArrayPath[AActor | None, AActor | Future[AActor] | None, AActor_path, AActor_async_path], Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]]
    """Array of all Actors whose Owner is this actor, these are not necessarily spawned by UChildActorComponent.

    Unreal: AActor.Children (TArray<AActor*>)
    """
    OnActorBeginOverlap: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when another actor begins to overlap this actor, for example a player walking into a trigger.

    Delegate: FActorBeginOverlapSignature(OverlappedActor: AActor, OtherActor: AActor)

    Unreal: AActor.OnActorBeginOverlap (FActorBeginOverlapSignature)
    """
    OnActorEndOverlap: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when another actor stops overlapping this actor.

    Delegate: FActorEndOverlapSignature(OverlappedActor: AActor, OtherActor: AActor)

    Unreal: AActor.OnActorEndOverlap (FActorEndOverlapSignature)
    """
    OnActorHit: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when this Actor hits (or is hit by) something solid.

    Delegate: FActorHitSignature(SelfActor: AActor, OtherActor: AActor, NormalImpulse: FVector, Hit: FHitResult)

    Unreal: AActor.OnActorHit (FActorHitSignature)
    """
    OnDestroyed: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Event triggered when the actor has been explicitly destroyed.

    Delegate: FActorDestroyedSignature(DestroyedActor: AActor)

    Unreal: AActor.OnDestroyed (FActorDestroyedSignature)
    """
    OnEndPlay: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Event triggered when the actor is being deleted or removed from a level.

    Delegate: FActorEndPlaySignature(Actor: AActor, EndPlayReason: EEndPlayReason)

    Unreal: AActor.OnEndPlay (FActorEndPlaySignature)
    """
    RootComponent: Property[USceneComponent_path, USceneComponent | Future[USceneComponent] | None]
    """The component that defines the transform (location, rotation, scale) of this Actor in the world, all other
    components must be attached to this one somehow.

    Unreal: AActor.RootComponent (USceneComponent*)
    """
    Instigator: Property[APawn_path, APawn | Future[APawn] | None]
    """Pawn responsible for damage and other gameplay events caused by this actor.

    Unreal: AActor.Instigator (APawn*)
    """
    Owner: Property[AActor_path, AActor | Future[AActor] | None]
    """Owner of this Actor, used primarily for replication (bNetUseOwnerRelevancy & bOnlyRelevantToOwner) and
    visibility (PrimitiveComponent bOwnerNoSee and bOnlyOwnerSee).

    Unreal: AActor.Owner (AActor*)
    """
    bHidden: BoolProperty
    """Allows us to only see this Actor in the Editor, and not in the actual game.

    Unreal: AActor.bHidden (bool)
    """
    bActorEnableCollision: BoolProperty
    """Enables any collision on this actor.

    Unreal: AActor.bActorEnableCollision (bool)
    """
    bAutoDestroyWhenFinished: BoolProperty
    """If true then destroy self when "finished", meaning all relevant components report that they are done and no
    timelines or timers are in flight.

    Unreal: AActor.bAutoDestroyWhenFinished (bool)
    """
    BlueprintCreatedComponents: Property[ArrayPath[UActorComponent | None, UActorComponent | Future[UActorComponent] | None, UActorComponent_path, UActorComponent_async_path], Sequence[UActorComponent | Future[UActorComponent] | None] | Future[list[UActorComponent | None]]]
    """Array of ActorComponents that are created by blueprints and serialized per-instance.

    Unreal: AActor.BlueprintCreatedComponents (TArray<UActorComponent*>)
    """
    InstanceComponents: Property[ArrayPath[UActorComponent | None, UActorComponent | Future[UActorComponent] | None, UActorComponent_path, UActorComponent_async_path], Sequence[UActorComponent | Future[UActorComponent] | None] | Future[list[UActorComponent | None]]]
    """Array of ActorComponents that have been added by the user on a per-instance basis.

    Unreal: AActor.InstanceComponents (TArray<UActorComponent*>)
    """

class AActor_async(UObject_async):
    """AActor under ``async_``: each function gives a future."""
    def ActorHasTag(self, Tag: str | Future[str]) -> Future[bool]:
        """See if this actor's Tags array contains the supplied name tag."""
    @overload
    def AddComponentByClass(self, Class: type[_T_UActorComponent], bManualAttachment: bool | Future[bool], RelativeTransform: FTransform_in, bDeferredFinish: bool | Future[bool]) -> Future[_T_UActorComponent]:
        """Creates a new component and assigns ownership to the Actor this is called for. Automatic attachment causes the
        first component created to become the root, and all subsequent components to be attached under that root. When
        bManualAttachment is set, automatic attachment is skipped and it is up to the user to attach the resulting
        component (or set it up as the root) themselves.

        Args:
            Class: class of component to create.
            bManualAttachment: whether manual or automatic attachment is to be used.
            RelativeTransform: relative transform between the new component and its attach parent (automatic only).
            bDeferredFinish: whether or not to immediately complete the creation and registration process for this component. FinishAddComponent must be called.

        Unreal: AActor.AddComponentByClass
        """
    @overload
    def AddComponentByClass(self, Class: UClass | str | Future[UClass], bManualAttachment: bool | Future[bool], RelativeTransform: FTransform_in, bDeferredFinish: bool | Future[bool]) -> Future[UActorComponent]: ...
    def AddTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> Future[None]:
        """Make this actor tick after PrerequisiteActor."""
    def AddTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> Future[None]:
        """Make this actor tick after PrerequisiteComponent."""
    @overload
    def FindComponentByTag(self, ComponentClass: type[_T_UActorComponent], Tag: str | Future[str]) -> Future[_T_UActorComponent | None]:
        """Searches components array and returns the first component of the class that has the tag, or null.

        Unreal: AActor.FindComponentByTag
        """
    @overload
    def FindComponentByTag(self, ComponentClass: UClass | str | Future[UClass], Tag: str | Future[str]) -> Future[UActorComponent | None]: ...
    def FinishAddComponent(self, Component: UActorComponent | Future[UActorComponent], bManualAttachment: bool | Future[bool], RelativeTransform: FTransform_in) -> Future[None]:
        """Completes the creation of a new actor component."""
    def GetActorBounds(self, bOnlyCollidingComponents: bool | Future[bool], bIncludeFromChildActors: bool | Future[bool] = False) -> Future[AActor_GetActorBounds_Result]:
        """Returns the bounding box of all components that make up this Actor (excluding ChildActorComponents)."""
    def GetActorEnableCollision(self) -> Future[bool]:
        """Get current state of collision for the whole actor."""
    def GetActorEyesViewPoint(self) -> Future[AActor_GetActorEyesViewPoint_Result]:
        """Returns the point of view of the actor: the location and rotation of its root component, or of its eyes for pawns."""
    def GetActorForwardVector(self) -> Future[FVector]:
        """Get the forward (X) vector (length 1.0) from this Actor, in world space."""
    def GetActorRelativeScale3D(self) -> Future[FVector]:
        """Return the actor's relative scale 3d."""
    def GetActorRightVector(self) -> Future[FVector]:
        """Get the right (Y) vector (length 1.0) from this Actor, in world space."""
    def GetActorScale3D(self) -> Future[FVector]:
        """Returns the Actor's world-space scale."""
    def GetActorTickInterval(self) -> Future[float]:
        """Returns the tick interval of this actor's primary tick function, in seconds."""
    def GetActorUpVector(self) -> Future[FVector]:
        """Get the up (Z) vector (length 1.0) from this Actor, in world space."""
    def GetAttachParentActor(self) -> Future[AActor | None]:
        """Walk up the attachment chain from RootComponent until we encounter a different actor, and return it."""
    def GetAttachParentSocketName(self) -> Future[str]:
        """Walk up the attachment chain from RootComponent until we encounter a different actor, and return the socket name in the component."""
    def GetAttachedActors(self, bResetArray: bool | Future[bool] = True, bRecursivelyIncludeAttachedActors: bool | Future[bool] = False) -> Future[AActor_GetAttachedActors_Result]:
        """Find all Actors which are attached directly to a component in this actor."""
    @overload
    def GetComponentByClass(self, ComponentClass: type[_T_UActorComponent]) -> Future[_T_UActorComponent | None]:
        """Script exposed version of FindComponentByClass.

        Unreal: AActor.GetComponentByClass
        """
    @overload
    def GetComponentByClass(self, ComponentClass: UClass | str | Future[UClass]) -> Future[UActorComponent | None]: ...
    def GetComponentsByInterface(self, Interface: type[UInterface] | UClass | str | Future[UClass]) -> Future[list[UActorComponent | None]]:
        """Gets all the components that implement the given interface."""
    @overload
    def GetComponentsByTag(self, ComponentClass: type[_T_UActorComponent], Tag: str | Future[str]) -> Future[list[_T_UActorComponent | None]]:
        """Gets all the components that inherit from the given class with a given tag.

        Unreal: AActor.GetComponentsByTag
        """
    @overload
    def GetComponentsByTag(self, ComponentClass: UClass | str | Future[UClass], Tag: str | Future[str]) -> Future[list[UActorComponent | None]]: ...
    def GetDistanceTo(self, OtherActor: AActor | Future[AActor]) -> Future[float]:
        """Returns the distance from this Actor to OtherActor, in centimetres."""
    def GetDotProductTo(self, OtherActor: AActor | Future[AActor]) -> Future[float]:
        """Returns the dot product from this Actor to OtherActor."""
    def GetGameTimeSinceCreation(self) -> Future[float]:
        """The number of seconds (in game time) since this Actor was created, relative to Get Game Time In Seconds."""
    def GetHorizontalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> Future[float]:
        """Returns the distance from this Actor to OtherActor, ignoring Z."""
    def GetHorizontalDotProductTo(self, OtherActor: AActor | Future[AActor]) -> Future[float]:
        """Returns the dot product from this Actor to OtherActor, ignoring Z."""
    def GetInstigator(self) -> Future[APawn | None]:
        """Returns the instigator for this actor, or nullptr if there is none."""
    def GetInstigatorController(self) -> Future[AController | None]:
        """Returns the instigator's controller for this actor, or nullptr if there is none."""
    def GetLevel(self) -> Future[ULevel]:
        """Return the ULevel that this Actor is part of."""
    def GetLevelTransform(self) -> Future[FTransform]:
        """Return the FTransform of the level this actor is a part of: the identity."""
    def GetLifeSpan(self) -> Future[float]:
        """Get the remaining lifespan of this actor, in seconds."""
    def GetLocalRole(self) -> Future[ENetRole]:
        """Returns how much control the local machine has over this actor."""
    def GetOwner(self) -> Future[AActor | None]:
        """Get the owner of this Actor, used primarily for network replication."""
    def GetRemoteRole(self) -> Future[ENetRole]:
        """Returns how much control the remote machine has over this actor."""
    def GetSquaredDistanceTo(self, OtherActor: AActor | Future[AActor]) -> Future[float]:
        """Returns the squared distance from this Actor to OtherActor."""
    def GetSquaredHorizontalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> Future[float]:
        """Returns the squared distance from this Actor to OtherActor, ignoring Z."""
    def GetTickableWhenPaused(self) -> Future[bool]:
        """Gets whether this actor can tick when paused."""
    def GetTransform(self) -> Future[FTransform]:
        """Get the actor-to-world transform."""
    def GetVelocity(self) -> Future[FVector]:
        """Returns velocity (in cm/s (Unreal Units/second) of the rootcomponent if it is either using physics or has an associated MovementComponent."""
    def GetVerticalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> Future[float]:
        """Returns the distance from this Actor to OtherActor, ignoring XY."""
    def HasAuthority(self) -> Future[bool]:
        """Returns whether this actor has network authority: always, without network."""
    def IsActorBeingDestroyed(self) -> Future[bool]:
        """Returns true if this actor has begun the destruction process."""
    def IsActorTickEnabled(self) -> Future[bool]:
        """Returns whether this actor has tick enabled or not."""
    def K2_AddActorLocalOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_AddActorLocalOffset_Result]:
        """Adds a delta to the location of this component in its local reference frame."""
    def K2_AddActorLocalRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_AddActorLocalRotation_Result]:
        """Adds a delta to the rotation of this component in its local reference frame."""
    def K2_AddActorLocalTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_AddActorLocalTransform_Result]:
        """Adds a delta to the transform of this component in its local reference frame."""
    def K2_AddActorWorldOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_AddActorWorldOffset_Result]:
        """Adds a delta to the location of this actor in world space."""
    def K2_AddActorWorldRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_AddActorWorldRotation_Result]:
        """Adds a delta to the rotation of this actor in world space."""
    def K2_AddActorWorldTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_AddActorWorldTransform_Result]:
        """Adds a delta to the transform of this actor in world space."""
    def K2_AddActorWorldTransformKeepScale(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_AddActorWorldTransformKeepScale_Result]:
        """Adds a delta to the transform of this actor in world space."""
    def K2_AttachToActor(self, ParentActor: AActor | Future[AActor], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> Future[bool]:
        """Attaches the RootComponent of this Actor to the RootComponent of the supplied actor, optionally at a named socket."""
    def K2_AttachToComponent(self, Parent: USceneComponent | Future[USceneComponent], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> Future[bool]:
        """Attaches the RootComponent of this Actor to the supplied component, optionally at a named socket."""
    def K2_DestroyActor(self) -> Future[None]:
        """Destroy the actor."""
    def K2_DetachFromActor(self, LocationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, RotationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, ScaleRule: EDetachmentRule_in = EDetachmentRule.KeepRelative) -> Future[None]:
        """Detaches the RootComponent of this Actor from any SceneComponent it is currently attached to."""
    def K2_GetActorLocation(self) -> Future[FVector]:
        """Returns the location of the RootComponent of this Actor."""
    def K2_GetActorRotation(self) -> Future[FRotator]:
        """Returns rotation of the RootComponent of this Actor."""
    @overload
    def K2_GetComponentsByClass(self, ComponentClass: type[_T_UActorComponent]) -> Future[list[_T_UActorComponent | None]]:
        """Gets all the components that inherit from the given class. Currently returns an array of UActorComponent which
        must be cast to the correct type.

        Unreal: AActor.K2_GetComponentsByClass
        """
    @overload
    def K2_GetComponentsByClass(self, ComponentClass: UClass | str | Future[UClass]) -> Future[list[UActorComponent | None]]: ...
    def K2_GetRootComponent(self) -> Future[USceneComponent]:
        """Returns the RootComponent of this Actor."""
    def K2_OnBecomeViewTarget(self, PC: APlayerController | Future[APlayerController]) -> Future[None]:
        """Event called when this Actor becomes the view target for the given PlayerController."""
    def K2_OnEndViewTarget(self, PC: APlayerController | Future[APlayerController]) -> Future[None]:
        """Event called when this Actor is no longer the view target for the given PlayerController."""
    def K2_OnReset(self) -> Future[None]:
        """Event called when this Actor is reset to its initial state - used when restarting level without reloading."""
    def K2_SetActorLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_SetActorLocation_Result]:
        """Move the Actor to the specified location."""
    def K2_SetActorLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_SetActorLocationAndRotation_Result]:
        """Move the actor instantly to the specified location and rotation."""
    def K2_SetActorRelativeLocation(self, NewRelativeLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_SetActorRelativeLocation_Result]:
        """Set the actor's RootComponent to the specified relative location."""
    def K2_SetActorRelativeRotation(self, NewRelativeRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_SetActorRelativeRotation_Result]:
        """Set the actor's RootComponent to the specified relative rotation."""
    def K2_SetActorRelativeTransform(self, NewRelativeTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_SetActorRelativeTransform_Result]:
        """Set the actor's RootComponent to the specified relative transform."""
    def K2_SetActorRotation(self, NewRotation: FRotator_in, bTeleportPhysics: bool | Future[bool]) -> Future[bool]:
        """Set the Actor's rotation instantly to the specified rotation."""
    def K2_SetActorTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[AActor_K2_SetActorTransform_Result]:
        """Set the Actors transform to the specified one."""
    def K2_TeleportTo(self, DestLocation: FVector_in, DestRotation: FRotator_in) -> Future[bool]:
        """Teleport this actor to a new location."""
    def ReceiveActorBeginOverlap(self, OtherActor: AActor | Future[AActor]) -> Future[None]:
        """Event when this actor overlaps another actor, for example a player walking into a trigger."""
    def ReceiveActorEndOverlap(self, OtherActor: AActor | Future[AActor]) -> Future[None]:
        """Event when an actor no longer overlaps another actor, and they have separated."""
    def ReceiveBeginPlay(self) -> Future[None]:
        """Event when play begins for this actor."""
    def ReceiveDestroyed(self) -> Future[None]:
        """Called when the actor has been explicitly destroyed."""
    def ReceiveEndPlay(self, EndPlayReason: EEndPlayReason_in) -> Future[None]:
        """Event to notify blueprints this actor is being deleted or removed from a level."""
    def ReceiveHit(self, MyComp: UPrimitiveComponent | Future[UPrimitiveComponent], Other: AActor | Future[AActor], OtherComp: UPrimitiveComponent | Future[UPrimitiveComponent], bSelfMoved: bool | Future[bool], HitLocation: FVector_in, HitNormal: FVector_in, NormalImpulse: FVector_in, Hit: FHitResult_in) -> Future[None]:
        """Event when this actor bumps into a blocking object, or blocks another actor that bumps into it."""
    def ReceiveTick(self, DeltaSeconds: float | Future[float]) -> Future[None]:
        """Event called every frame, if ticking is enabled."""
    def RemoveTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> Future[None]:
        """Remove tick dependency on PrerequisiteActor."""
    def RemoveTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> Future[None]:
        """Remove tick dependency on PrerequisiteComponent."""
    def SetActorEnableCollision(self, bNewActorEnableCollision: bool | Future[bool]) -> Future[None]:
        """Allows enabling/disabling collision for the whole actor."""
    def SetActorHiddenInGame(self, bNewHidden: bool | Future[bool]) -> Future[None]:
        """Sets the actor to be hidden in the game."""
    def SetActorRelativeScale3D(self, NewRelativeScale: FVector_in) -> Future[None]:
        """Set the actor's RootComponent to the specified relative scale 3d."""
    def SetActorScale3D(self, NewScale3D: FVector_in) -> Future[None]:
        """Set the Actor's world-space scale."""
    def SetActorTickEnabled(self, bEnabled: bool | Future[bool]) -> Future[None]:
        """Sets whether this actor tick is enabled."""
    def SetActorTickInterval(self, TickInterval: float | Future[float]) -> Future[None]:
        """Sets the tick interval of this actor's primary tick function."""
    def SetLifeSpan(self, InLifespan: float | Future[float]) -> Future[None]:
        """Set the lifespan of this actor."""
    def SetOwner(self, NewOwner: AActor | Future[AActor]) -> Future[None]:
        """Set the owner of this Actor, used primarily for network replication."""
    def SetTickGroup(self, NewTickGroup: ETickingGroup_in) -> Future[None]:
        """Changes the ticking group for this actor."""
    def SetTickableWhenPaused(self, bTickableWhenPaused: bool | Future[bool]) -> Future[None]:
        """Sets whether this actor can tick when paused."""
    def UserConstructionScript(self) -> Future[None]:
        """Construction script, the place to spawn components and do other setup."""
    PrimaryActorTick: Property[FActorTickFunction_async, FActorTickFunction_in]
    """Primary Actor tick function, which calls TickActor()."""
    CustomTimeDilation: AsyncFloatProperty
    """Allow each actor to run at a different time speed."""
    InitialLifeSpan: AsyncFloatProperty
    """How long this Actor lives before dying, 0 = forever."""
    bFindCameraComponentWhenViewTarget: AsyncBoolProperty
    """If true, this actor should search for an owned camera component to view through when used as a view target."""
    SpawnCollisionHandlingMethod: Property[AsyncValuePath[ESpawnActorCollisionHandlingMethod, ESpawnActorCollisionHandlingMethod_in], ESpawnActorCollisionHandlingMethod_in]
    """Controls how to handle spawning this actor in a situation where it's colliding with something else."""
    Tags: Property[AsyncArrayPath[str, str | Future[str], AsyncPath[str]], Sequence[str | Future[str]] | Future[list[str]]]
    """Array of tags that can be used for grouping and categorizing."""
    Children: Property[AsyncArrayPath[AActor | None, AActor | Future[AActor] | None, AActor_async_path], Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]]
    """Array of all Actors whose Owner is this actor, these are not necessarily spawned by UChildActorComponent."""
    OnActorBeginOverlap: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when another actor begins to overlap this actor, for example a player walking into a trigger."""
    OnActorEndOverlap: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when another actor stops overlapping this actor."""
    OnActorHit: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when this Actor hits (or is hit by) something solid."""
    OnDestroyed: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Event triggered when the actor has been explicitly destroyed."""
    OnEndPlay: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Event triggered when the actor is being deleted or removed from a level."""
    RootComponent: Property[USceneComponent_async_path, USceneComponent | Future[USceneComponent] | None]
    """The component that defines the transform (location, rotation, scale) of this Actor in the world, all other components must be attached to this one somehow."""
    Instigator: Property[APawn_async_path, APawn | Future[APawn] | None]
    """Pawn responsible for damage and other gameplay events caused by this actor."""
    Owner: Property[AActor_async_path, AActor | Future[AActor] | None]
    """Owner of this Actor, used primarily for replication (bNetUseOwnerRelevancy & bOnlyRelevantToOwner) and visibility (PrimitiveComponent bOwnerNoSee and bOnlyOwnerSee)."""
    bHidden: AsyncBoolProperty
    """Allows us to only see this Actor in the Editor, and not in the actual game."""
    bActorEnableCollision: AsyncBoolProperty
    """Enables any collision on this actor."""
    bAutoDestroyWhenFinished: AsyncBoolProperty
    """If true then destroy self when "finished", meaning all relevant components report that they are done and no timelines or timers are in flight."""
    BlueprintCreatedComponents: Property[AsyncArrayPath[UActorComponent | None, UActorComponent | Future[UActorComponent] | None, UActorComponent_async_path], Sequence[UActorComponent | Future[UActorComponent] | None] | Future[list[UActorComponent | None]]]
    """Array of ActorComponents that are created by blueprints and serialized per-instance."""
    InstanceComponents: Property[AsyncArrayPath[UActorComponent | None, UActorComponent | Future[UActorComponent] | None, UActorComponent_async_path], Sequence[UActorComponent | Future[UActorComponent] | None] | Future[list[UActorComponent | None]]]
    """Array of ActorComponents that have been added by the user on a per-instance basis."""

class AActor_send(UObject_send):
    """AActor under ``send_``: no function answers."""
    def ActorHasTag(self, Tag: str | Future[str]) -> None:
        """See if this actor's Tags array contains the supplied name tag."""
    def AddComponentByClass(self, Class: type[UActorComponent] | UClass | str | Future[UClass], bManualAttachment: bool | Future[bool], RelativeTransform: FTransform_in, bDeferredFinish: bool | Future[bool]) -> None: ...
    def AddTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> None:
        """Make this actor tick after PrerequisiteActor."""
    def AddTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> None:
        """Make this actor tick after PrerequisiteComponent."""
    def FindComponentByTag(self, ComponentClass: type[UActorComponent] | UClass | str | Future[UClass], Tag: str | Future[str]) -> None: ...
    def FinishAddComponent(self, Component: UActorComponent | Future[UActorComponent], bManualAttachment: bool | Future[bool], RelativeTransform: FTransform_in) -> None:
        """Completes the creation of a new actor component."""
    def GetActorBounds(self, bOnlyCollidingComponents: bool | Future[bool], bIncludeFromChildActors: bool | Future[bool] = False) -> None:
        """Returns the bounding box of all components that make up this Actor (excluding ChildActorComponents)."""
    def GetActorEnableCollision(self) -> None:
        """Get current state of collision for the whole actor."""
    def GetActorEyesViewPoint(self) -> None:
        """Returns the point of view of the actor: the location and rotation of its root component, or of its eyes for pawns."""
    def GetActorForwardVector(self) -> None:
        """Get the forward (X) vector (length 1.0) from this Actor, in world space."""
    def GetActorRelativeScale3D(self) -> None:
        """Return the actor's relative scale 3d."""
    def GetActorRightVector(self) -> None:
        """Get the right (Y) vector (length 1.0) from this Actor, in world space."""
    def GetActorScale3D(self) -> None:
        """Returns the Actor's world-space scale."""
    def GetActorTickInterval(self) -> None:
        """Returns the tick interval of this actor's primary tick function, in seconds."""
    def GetActorUpVector(self) -> None:
        """Get the up (Z) vector (length 1.0) from this Actor, in world space."""
    def GetAttachParentActor(self) -> None:
        """Walk up the attachment chain from RootComponent until we encounter a different actor, and return it."""
    def GetAttachParentSocketName(self) -> None:
        """Walk up the attachment chain from RootComponent until we encounter a different actor, and return the socket name in the component."""
    def GetAttachedActors(self, bResetArray: bool | Future[bool] = True, bRecursivelyIncludeAttachedActors: bool | Future[bool] = False) -> None:
        """Find all Actors which are attached directly to a component in this actor."""
    def GetComponentByClass(self, ComponentClass: type[UActorComponent] | UClass | str | Future[UClass]) -> None: ...
    def GetComponentsByInterface(self, Interface: type[UInterface] | UClass | str | Future[UClass]) -> None:
        """Gets all the components that implement the given interface."""
    def GetComponentsByTag(self, ComponentClass: type[UActorComponent] | UClass | str | Future[UClass], Tag: str | Future[str]) -> None: ...
    def GetDistanceTo(self, OtherActor: AActor | Future[AActor]) -> None:
        """Returns the distance from this Actor to OtherActor, in centimetres."""
    def GetDotProductTo(self, OtherActor: AActor | Future[AActor]) -> None:
        """Returns the dot product from this Actor to OtherActor."""
    def GetGameTimeSinceCreation(self) -> None:
        """The number of seconds (in game time) since this Actor was created, relative to Get Game Time In Seconds."""
    def GetHorizontalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> None:
        """Returns the distance from this Actor to OtherActor, ignoring Z."""
    def GetHorizontalDotProductTo(self, OtherActor: AActor | Future[AActor]) -> None:
        """Returns the dot product from this Actor to OtherActor, ignoring Z."""
    def GetInstigator(self) -> None:
        """Returns the instigator for this actor, or nullptr if there is none."""
    def GetInstigatorController(self) -> None:
        """Returns the instigator's controller for this actor, or nullptr if there is none."""
    def GetLevel(self) -> None:
        """Return the ULevel that this Actor is part of."""
    def GetLevelTransform(self) -> None:
        """Return the FTransform of the level this actor is a part of: the identity."""
    def GetLifeSpan(self) -> None:
        """Get the remaining lifespan of this actor, in seconds."""
    def GetLocalRole(self) -> None:
        """Returns how much control the local machine has over this actor."""
    def GetOwner(self) -> None:
        """Get the owner of this Actor, used primarily for network replication."""
    def GetRemoteRole(self) -> None:
        """Returns how much control the remote machine has over this actor."""
    def GetSquaredDistanceTo(self, OtherActor: AActor | Future[AActor]) -> None:
        """Returns the squared distance from this Actor to OtherActor."""
    def GetSquaredHorizontalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> None:
        """Returns the squared distance from this Actor to OtherActor, ignoring Z."""
    def GetTickableWhenPaused(self) -> None:
        """Gets whether this actor can tick when paused."""
    def GetTransform(self) -> None:
        """Get the actor-to-world transform."""
    def GetVelocity(self) -> None:
        """Returns velocity (in cm/s (Unreal Units/second) of the rootcomponent if it is either using physics or has an associated MovementComponent."""
    def GetVerticalDistanceTo(self, OtherActor: AActor | Future[AActor]) -> None:
        """Returns the distance from this Actor to OtherActor, ignoring XY."""
    def HasAuthority(self) -> None:
        """Returns whether this actor has network authority: always, without network."""
    def IsActorBeingDestroyed(self) -> None:
        """Returns true if this actor has begun the destruction process."""
    def IsActorTickEnabled(self) -> None:
        """Returns whether this actor has tick enabled or not."""
    def K2_AddActorLocalOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the location of this component in its local reference frame."""
    def K2_AddActorLocalRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the rotation of this component in its local reference frame."""
    def K2_AddActorLocalTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the transform of this component in its local reference frame."""
    def K2_AddActorWorldOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the location of this actor in world space."""
    def K2_AddActorWorldRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the rotation of this actor in world space."""
    def K2_AddActorWorldTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the transform of this actor in world space."""
    def K2_AddActorWorldTransformKeepScale(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the transform of this actor in world space."""
    def K2_AttachToActor(self, ParentActor: AActor | Future[AActor], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> None:
        """Attaches the RootComponent of this Actor to the RootComponent of the supplied actor, optionally at a named socket."""
    def K2_AttachToComponent(self, Parent: USceneComponent | Future[USceneComponent], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> None:
        """Attaches the RootComponent of this Actor to the supplied component, optionally at a named socket."""
    def K2_DestroyActor(self) -> None:
        """Destroy the actor."""
    def K2_DetachFromActor(self, LocationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, RotationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, ScaleRule: EDetachmentRule_in = EDetachmentRule.KeepRelative) -> None:
        """Detaches the RootComponent of this Actor from any SceneComponent it is currently attached to."""
    def K2_GetActorLocation(self) -> None:
        """Returns the location of the RootComponent of this Actor."""
    def K2_GetActorRotation(self) -> None:
        """Returns rotation of the RootComponent of this Actor."""
    def K2_GetComponentsByClass(self, ComponentClass: type[UActorComponent] | UClass | str | Future[UClass]) -> None: ...
    def K2_GetRootComponent(self) -> None:
        """Returns the RootComponent of this Actor."""
    def K2_OnBecomeViewTarget(self, PC: APlayerController | Future[APlayerController]) -> None:
        """Event called when this Actor becomes the view target for the given PlayerController."""
    def K2_OnEndViewTarget(self, PC: APlayerController | Future[APlayerController]) -> None:
        """Event called when this Actor is no longer the view target for the given PlayerController."""
    def K2_OnReset(self) -> None:
        """Event called when this Actor is reset to its initial state - used when restarting level without reloading."""
    def K2_SetActorLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Move the Actor to the specified location."""
    def K2_SetActorLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Move the actor instantly to the specified location and rotation."""
    def K2_SetActorRelativeLocation(self, NewRelativeLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Set the actor's RootComponent to the specified relative location."""
    def K2_SetActorRelativeRotation(self, NewRelativeRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Set the actor's RootComponent to the specified relative rotation."""
    def K2_SetActorRelativeTransform(self, NewRelativeTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Set the actor's RootComponent to the specified relative transform."""
    def K2_SetActorRotation(self, NewRotation: FRotator_in, bTeleportPhysics: bool | Future[bool]) -> None:
        """Set the Actor's rotation instantly to the specified rotation."""
    def K2_SetActorTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Set the Actors transform to the specified one."""
    def K2_TeleportTo(self, DestLocation: FVector_in, DestRotation: FRotator_in) -> None:
        """Teleport this actor to a new location."""
    def ReceiveActorBeginOverlap(self, OtherActor: AActor | Future[AActor]) -> None:
        """Event when this actor overlaps another actor, for example a player walking into a trigger."""
    def ReceiveActorEndOverlap(self, OtherActor: AActor | Future[AActor]) -> None:
        """Event when an actor no longer overlaps another actor, and they have separated."""
    def ReceiveBeginPlay(self) -> None:
        """Event when play begins for this actor."""
    def ReceiveDestroyed(self) -> None:
        """Called when the actor has been explicitly destroyed."""
    def ReceiveEndPlay(self, EndPlayReason: EEndPlayReason_in) -> None:
        """Event to notify blueprints this actor is being deleted or removed from a level."""
    def ReceiveHit(self, MyComp: UPrimitiveComponent | Future[UPrimitiveComponent], Other: AActor | Future[AActor], OtherComp: UPrimitiveComponent | Future[UPrimitiveComponent], bSelfMoved: bool | Future[bool], HitLocation: FVector_in, HitNormal: FVector_in, NormalImpulse: FVector_in, Hit: FHitResult_in) -> None:
        """Event when this actor bumps into a blocking object, or blocks another actor that bumps into it."""
    def ReceiveTick(self, DeltaSeconds: float | Future[float]) -> None:
        """Event called every frame, if ticking is enabled."""
    def RemoveTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> None:
        """Remove tick dependency on PrerequisiteActor."""
    def RemoveTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> None:
        """Remove tick dependency on PrerequisiteComponent."""
    def SetActorEnableCollision(self, bNewActorEnableCollision: bool | Future[bool]) -> None:
        """Allows enabling/disabling collision for the whole actor."""
    def SetActorHiddenInGame(self, bNewHidden: bool | Future[bool]) -> None:
        """Sets the actor to be hidden in the game."""
    def SetActorRelativeScale3D(self, NewRelativeScale: FVector_in) -> None:
        """Set the actor's RootComponent to the specified relative scale 3d."""
    def SetActorScale3D(self, NewScale3D: FVector_in) -> None:
        """Set the Actor's world-space scale."""
    def SetActorTickEnabled(self, bEnabled: bool | Future[bool]) -> None:
        """Sets whether this actor tick is enabled."""
    def SetActorTickInterval(self, TickInterval: float | Future[float]) -> None:
        """Sets the tick interval of this actor's primary tick function."""
    def SetLifeSpan(self, InLifespan: float | Future[float]) -> None:
        """Set the lifespan of this actor."""
    def SetOwner(self, NewOwner: AActor | Future[AActor]) -> None:
        """Set the owner of this Actor, used primarily for network replication."""
    def SetTickGroup(self, NewTickGroup: ETickingGroup_in) -> None:
        """Changes the ticking group for this actor."""
    def SetTickableWhenPaused(self, bTickableWhenPaused: bool | Future[bool]) -> None:
        """Sets whether this actor can tick when paused."""
    def UserConstructionScript(self) -> None:
        """Construction script, the place to spawn components and do other setup."""
    PrimaryActorTick: SendProperty[FActorTickFunction_in]
    CustomTimeDilation: SendFloatProperty
    InitialLifeSpan: SendFloatProperty
    bFindCameraComponentWhenViewTarget: SendBoolProperty
    SpawnCollisionHandlingMethod: SendProperty[ESpawnActorCollisionHandlingMethod_in]
    Tags: SendProperty[Sequence[str | Future[str]] | Future[list[str]]]
    Children: SendProperty[Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]]
    OnActorBeginOverlap: SendProperty[Sequence[FScriptDelegate_in] | None]
    OnActorEndOverlap: SendProperty[Sequence[FScriptDelegate_in] | None]
    OnActorHit: SendProperty[Sequence[FScriptDelegate_in] | None]
    OnDestroyed: SendProperty[Sequence[FScriptDelegate_in] | None]
    OnEndPlay: SendProperty[Sequence[FScriptDelegate_in] | None]
    RootComponent: SendProperty[USceneComponent | Future[USceneComponent] | None]
    Instigator: SendProperty[APawn | Future[APawn] | None]
    Owner: SendProperty[AActor | Future[AActor] | None]
    bHidden: SendBoolProperty
    bActorEnableCollision: SendBoolProperty
    bAutoDestroyWhenFinished: SendBoolProperty
    BlueprintCreatedComponents: SendProperty[Sequence[UActorComponent | Future[UActorComponent] | None] | Future[list[UActorComponent | None]]]
    InstanceComponents: SendProperty[Sequence[UActorComponent | Future[UActorComponent] | None] | Future[list[UActorComponent | None]]]

class AActor(AActor_members, UObject):
    """Actor is the base class for an Object that can be placed or spawned in a level.

    Actors may contain a collection of ActorComponents, which can be used to control how actors move, how they are
    rendered, etc. Their transform is that of the root component.

    Life: spawned (constructor, PostSpawnInitialize, components registered), PreInitializeComponents,
    InitializeComponent of the components, PostInitializeComponents, BeginPlay, ticks, EndPlay, Destroyed. A
    destroyed actor is out of the world at once but lingers as an object, marked as garbage, until the garbage is
    collected.

    Locations in centimetres, rotations in degrees (left-handed, Z up).

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AActor

    Unreal: /Script/Engine.Actor
    """
    @property
    def async_(self) -> AActor_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> AActor_send:
        """The same functions and variables, fire-and-forget."""

class AActor_path(ObjectPath[AActor, AActor_async_path, AActor_send], AActor_members):
    """A variable that refers to an object of AActor: its path."""

class AActor_async_path(AsyncObjectPath[AActor], AActor_async):
    """The same under ``async_``."""
