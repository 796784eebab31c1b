# generated, do not edit (Engine: Public/Components/SceneComponent.h)
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias
from spear.enums import UnrealEnum
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncObjectPath, AsyncStrProperty, AsyncValuePath, BoolProperty, Future, ObjectPath, Property,
    SendBoolProperty, SendProperty, SendStrProperty, StrProperty, ValuePath,
)
from ..CoreUObject._NoExportTypes import (
    FQuat, FRotator, FRotator_async, FRotator_in, FRotator_path, FTransform, FTransform_in, FVector, FVector_async, FVector_in, FVector_path,
)
from ._ActorComponent import UActorComponent, UActorComponent_async, UActorComponent_members, UActorComponent_send
from ._EngineTypes import EAttachmentRule_in, EComponentMobility, EComponentMobility_in, EDetachmentRule, EDetachmentRule_in
from ._HitResult import FHitResult

class ERelativeTransformSpace(UnrealEnum):
    """The space a socket transform is asked for in. Epic page: ERelativeTransformSpace.

    Unreal: /Script/Engine.ERelativeTransformSpace
    """
    RTS_World = 0
    """World space transform."""
    RTS_Actor = 1
    """Actor space transform."""
    RTS_Component = 2
    """Component space transform."""
    RTS_ParentBoneSpace = 3
    """Parent bone space; components without bones answer as for `RTS_Component`."""

ERelativeTransformSpace_in: TypeAlias = ERelativeTransformSpace | str | Future[ERelativeTransformSpace]
"""What stands for ERelativeTransformSpace as an argument: an entry, the name that Unreal gives it, a future."""

class USceneComponent_GetChildrenComponents_Result(NamedTuple):
    """Results of USceneComponent.GetChildrenComponents."""
    Children: list[USceneComponent]

class USceneComponent_GetParentComponents_Result(NamedTuple):
    """Results of USceneComponent.GetParentComponents."""
    Parents: list[USceneComponent]

class USceneComponent_K2_AddLocalOffset_Result(NamedTuple):
    """Results of USceneComponent.K2_AddLocalOffset."""
    SweepHitResult: FHitResult

class USceneComponent_K2_AddLocalRotation_Result(NamedTuple):
    """Results of USceneComponent.K2_AddLocalRotation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_AddLocalTransform_Result(NamedTuple):
    """Results of USceneComponent.K2_AddLocalTransform."""
    SweepHitResult: FHitResult

class USceneComponent_K2_AddRelativeLocation_Result(NamedTuple):
    """Results of USceneComponent.K2_AddRelativeLocation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_AddRelativeRotation_Result(NamedTuple):
    """Results of USceneComponent.K2_AddRelativeRotation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_AddWorldOffset_Result(NamedTuple):
    """Results of USceneComponent.K2_AddWorldOffset."""
    SweepHitResult: FHitResult

class USceneComponent_K2_AddWorldRotation_Result(NamedTuple):
    """Results of USceneComponent.K2_AddWorldRotation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_AddWorldTransform_Result(NamedTuple):
    """Results of USceneComponent.K2_AddWorldTransform."""
    SweepHitResult: FHitResult

class USceneComponent_K2_AddWorldTransformKeepScale_Result(NamedTuple):
    """Results of USceneComponent.K2_AddWorldTransformKeepScale."""
    SweepHitResult: FHitResult

class USceneComponent_K2_SetRelativeLocation_Result(NamedTuple):
    """Results of USceneComponent.K2_SetRelativeLocation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_SetRelativeLocationAndRotation_Result(NamedTuple):
    """Results of USceneComponent.K2_SetRelativeLocationAndRotation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_SetRelativeRotation_Result(NamedTuple):
    """Results of USceneComponent.K2_SetRelativeRotation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_SetRelativeTransform_Result(NamedTuple):
    """Results of USceneComponent.K2_SetRelativeTransform."""
    SweepHitResult: FHitResult

class USceneComponent_K2_SetWorldLocation_Result(NamedTuple):
    """Results of USceneComponent.K2_SetWorldLocation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_SetWorldLocationAndRotation_Result(NamedTuple):
    """Results of USceneComponent.K2_SetWorldLocationAndRotation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_SetWorldRotation_Result(NamedTuple):
    """Results of USceneComponent.K2_SetWorldRotation."""
    SweepHitResult: FHitResult

class USceneComponent_K2_SetWorldTransform_Result(NamedTuple):
    """Results of USceneComponent.K2_SetWorldTransform."""
    SweepHitResult: FHitResult

class USceneComponent_members(UActorComponent_members):
    """Functions and variables of USceneComponent."""
    def DoesSocketExist(self, InSocketName: str | Future[str]) -> bool:
        """Whether a socket with that name exists.

        Unreal: USceneComponent.DoesSocketExist
        """
    def GetAllSocketNames(self) -> list[str]:
        """Gets the names of all the sockets on the component.

        Unreal: USceneComponent.GetAllSocketNames
        """
    def GetAttachParent(self) -> USceneComponent | None:
        """Gets the component we are attached to.

        Unreal: USceneComponent.GetAttachParent
        """
    def GetAttachSocketName(self) -> str:
        """Gets the socket we are attached to.

        Unreal: USceneComponent.GetAttachSocketName
        """
    def GetChildComponent(self, ChildIndex: int | Future[int]) -> USceneComponent | None:
        """Gets the attached child component at the specified location, or null when there is none.

        Unreal: USceneComponent.GetChildComponent
        """
    def GetChildrenComponents(self, bIncludeAllDescendants: bool | Future[bool]) -> USceneComponent_GetChildrenComponents_Result:
        """Gets the attached children components.

        Args:
            bIncludeAllDescendants: whether to include the children of the children too (parents before their children)

        Unreal: USceneComponent.GetChildrenComponents
        """
    def GetComponentVelocity(self) -> FVector:
        """Returns the velocity of the component, in centimetres per second.

        Unreal: USceneComponent.GetComponentVelocity
        """
    def GetForwardVector(self) -> FVector:
        """Returns the forward (X) unit direction vector of this component, in world space.

        Unreal: USceneComponent.GetForwardVector
        """
    def GetNumChildrenComponents(self) -> int:
        """Gets the number of attached children components.

        Unreal: USceneComponent.GetNumChildrenComponents
        """
    def GetParentComponents(self) -> USceneComponent_GetParentComponents_Result:
        """Gets all components this one is attached to, up to the root.

        Unreal: USceneComponent.GetParentComponents
        """
    def GetRelativeTransform(self) -> FTransform:
        """Returns the transform of the component relative to its parent.

        Unreal: USceneComponent.GetRelativeTransform
        """
    def GetRightVector(self) -> FVector:
        """Returns the right (Y) unit direction vector of this component, in world space.

        Unreal: USceneComponent.GetRightVector
        """
    def GetSocketLocation(self, InSocketName: str | Future[str]) -> FVector:
        """Gets the world-space socket location.

        Unreal: USceneComponent.GetSocketLocation
        """
    def GetSocketQuaternion(self, InSocketName: str | Future[str]) -> FQuat:
        """Gets the world-space socket rotation as a quaternion.

        Unreal: USceneComponent.GetSocketQuaternion
        """
    def GetSocketRotation(self, InSocketName: str | Future[str]) -> FRotator:
        """Gets the world-space socket rotation, in degrees.

        Unreal: USceneComponent.GetSocketRotation
        """
    def GetSocketTransform(self, InSocketName: str | Future[str], TransformSpace: ERelativeTransformSpace_in = ERelativeTransformSpace.RTS_World) -> FTransform:
        """Gets the world-space socket transform; the component's own when there is no such socket.

        Unreal: USceneComponent.GetSocketTransform
        """
    def GetUpVector(self) -> FVector:
        """Returns the up (Z) unit direction vector of this component, in world space.

        Unreal: USceneComponent.GetUpVector
        """
    def IsVisible(self) -> bool:
        """Returns true if this component is visible in the current context.

        Unreal: USceneComponent.IsVisible
        """
    def K2_AddLocalOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddLocalOffset_Result:
        """Adds a delta to the location of the component in its own local frame.

        Unreal: USceneComponent.K2_AddLocalOffset
        """
    def K2_AddLocalRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddLocalRotation_Result:
        """Adds a delta to the rotation of the component in its own local frame.

        Unreal: USceneComponent.K2_AddLocalRotation
        """
    def K2_AddLocalTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddLocalTransform_Result:
        """Adds a delta to the transform of the component in its own local frame. Scale is unchanged.

        Unreal: USceneComponent.K2_AddLocalTransform
        """
    def K2_AddRelativeLocation(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddRelativeLocation_Result:
        """Adds a delta to the translation of the component relative to its parent.

        Unreal: USceneComponent.K2_AddRelativeLocation
        """
    def K2_AddRelativeRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddRelativeRotation_Result:
        """Adds a delta to the rotation of the component relative to its parent (the delta is applied after it).

        Unreal: USceneComponent.K2_AddRelativeRotation
        """
    def K2_AddWorldOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddWorldOffset_Result:
        """Adds a delta to the location of the component in world space.

        Unreal: USceneComponent.K2_AddWorldOffset
        """
    def K2_AddWorldRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddWorldRotation_Result:
        """Adds a delta to the rotation of the component in world space.

        Unreal: USceneComponent.K2_AddWorldRotation
        """
    def K2_AddWorldTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddWorldTransform_Result:
        """Adds a delta to the transform of the component in world space. Ignores scale and sets it to (1,1,1).

        Unreal: USceneComponent.K2_AddWorldTransform
        """
    def K2_AddWorldTransformKeepScale(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_AddWorldTransformKeepScale_Result:
        """Adds a delta to the transform of the component in world space. Scale is unchanged.

        Unreal: USceneComponent.K2_AddWorldTransformKeepScale
        """
    def K2_AttachToComponent(self, Parent: USceneComponent | Future[USceneComponent], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> bool:
        """Attaches this component to another one.

        Args:
            Parent: what to attach to
            SocketName: optional socket on the parent
            LocationRule: how to handle the translation
            RotationRule: how to handle the rotation
            ScaleRule: how to handle the scale
            bWeldSimulatedBodies: whether to weld simulated physics bodies together

        Returns:
            whether the component is now attached

        Unreal: USceneComponent.K2_AttachToComponent
        """
    def K2_DetachFromComponent(self, LocationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, RotationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, ScaleRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, bCallModify: bool | Future[bool] = True) -> None:
        """Detaches this component from whatever it is attached to.

        Unreal: USceneComponent.K2_DetachFromComponent
        """
    def K2_GetComponentLocation(self) -> FVector:
        """Returns the location of the component, in world space.

        Unreal: USceneComponent.K2_GetComponentLocation
        """
    def K2_GetComponentRotation(self) -> FRotator:
        """Returns the rotation of the component, in world space, in degrees.

        Unreal: USceneComponent.K2_GetComponentRotation
        """
    def K2_GetComponentScale(self) -> FVector:
        """Returns the scale of the component, in world space.

        Unreal: USceneComponent.K2_GetComponentScale
        """
    def K2_GetComponentToWorld(self) -> FTransform:
        """Returns the current component-to-world transform.

        Unreal: USceneComponent.K2_GetComponentToWorld
        """
    def K2_SetRelativeLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_SetRelativeLocation_Result:
        """Sets the location of the component relative to its parent. Without collision the sweep has no effect.

        Unreal: USceneComponent.K2_SetRelativeLocation
        """
    def K2_SetRelativeLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_SetRelativeLocationAndRotation_Result:
        """Sets location and rotation of the component relative to its parent.

        Unreal: USceneComponent.K2_SetRelativeLocationAndRotation
        """
    def K2_SetRelativeRotation(self, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_SetRelativeRotation_Result:
        """Sets the rotation of the component relative to its parent, in degrees.

        Unreal: USceneComponent.K2_SetRelativeRotation
        """
    def K2_SetRelativeTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_SetRelativeTransform_Result:
        """Sets the transform of the component relative to its parent.

        Unreal: USceneComponent.K2_SetRelativeTransform
        """
    def K2_SetWorldLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_SetWorldLocation_Result:
        """Puts this component at the specified location in world space. Updates the relative location to achieve it.

        Unreal: USceneComponent.K2_SetWorldLocation
        """
    def K2_SetWorldLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_SetWorldLocationAndRotation_Result:
        """Sets location and rotation of the component in world space.

        Unreal: USceneComponent.K2_SetWorldLocationAndRotation
        """
    def K2_SetWorldRotation(self, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_SetWorldRotation_Result:
        """Puts this component at the specified rotation in world space, in degrees.

        Unreal: USceneComponent.K2_SetWorldRotation
        """
    def K2_SetWorldTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> USceneComponent_K2_SetWorldTransform_Result:
        """Sets the transform of the component in world space.

        Unreal: USceneComponent.K2_SetWorldTransform
        """
    def ResetRelativeTransform(self) -> None:
        """Resets the relative transform to the identity.

        Unreal: USceneComponent.ResetRelativeTransform
        """
    def SetAbsolute(self, bNewAbsoluteLocation: bool | Future[bool] = False, bNewAbsoluteRotation: bool | Future[bool] = False, bNewAbsoluteScale: bool | Future[bool] = False) -> None:
        """Sets which parts of the relative transform are relative to the world instead of the parent.

        Unreal: USceneComponent.SetAbsolute
        """
    def SetHiddenInGame(self, NewHidden: bool | Future[bool], bPropagateToChildren: bool | Future[bool] = False) -> None:
        """Changes the value of bHiddenInGame, optionally for all attached children too.

        Unreal: USceneComponent.SetHiddenInGame
        """
    def SetMobility(self, NewMobility: EComponentMobility_in) -> None:
        """Sets how often this component is allowed to move during runtime.

        Unreal: USceneComponent.SetMobility
        """
    def SetRelativeScale3D(self, NewScale3D: FVector_in) -> None:
        """Sets the non-uniform scale of the component relative to its parent.

        Unreal: USceneComponent.SetRelativeScale3D
        """
    def SetVisibility(self, bNewVisibility: bool | Future[bool], bPropagateToChildren: bool | Future[bool] = False) -> None:
        """Sets the visibility of the component.

        Args:
            bNewVisibility: whether it is visible
            bPropagateToChildren: whether to apply the same to all attached children, recursively

        Unreal: USceneComponent.SetVisibility
        """
    def SetWorldScale3D(self, NewScale: FVector_in) -> None:
        """Sets the scale of the component in world space.

        Unreal: USceneComponent.SetWorldScale3D
        """
    def ToggleVisibility(self, bPropagateToChildren: bool | Future[bool] = False) -> None:
        """Toggles the visibility of the component.

        Unreal: USceneComponent.ToggleVisibility
        """
    AttachParent: Property[USceneComponent_path, USceneComponent | Future[USceneComponent] | None]
    """What we are currently attached to. If valid, RelativeLocation etc. are used relative to this object.

    Unreal: USceneComponent.AttachParent (USceneComponent*)
    """
    AttachSocketName: StrProperty
    """Optional socket name on AttachParent that we are attached to.

    Unreal: USceneComponent.AttachSocketName (FName)
    """
    AttachChildren: Property[ArrayPath[USceneComponent | None, USceneComponent | Future[USceneComponent] | None, USceneComponent_path, USceneComponent_async_path], Sequence[USceneComponent | Future[USceneComponent] | None] | Future[list[USceneComponent | None]]]
    """List of child components that are attached to us.

    Unreal: USceneComponent.AttachChildren (TArray<USceneComponent*>)
    """
    RelativeLocation: Property[FVector_path, FVector_in]
    """Location of the component relative to its parent, in centimetres.

    Unreal: USceneComponent.RelativeLocation (FVector)
    """
    RelativeRotation: Property[FRotator_path, FRotator_in]
    """Rotation of the component relative to its parent, in degrees.

    Unreal: USceneComponent.RelativeRotation (FRotator)
    """
    RelativeScale3D: Property[FVector_path, FVector_in]
    """Non-uniform scaling of the component relative to its parent.

    Unreal: USceneComponent.RelativeScale3D (FVector)
    """
    ComponentVelocity: Property[FVector_path, FVector_in]
    """Velocity of the component, in centimetres per second. See `GetComponentVelocity`.

    Unreal: USceneComponent.ComponentVelocity (FVector)
    """
    bAbsoluteLocation: BoolProperty
    """If RelativeLocation should be considered relative to the world, rather than the parent.

    Unreal: USceneComponent.bAbsoluteLocation (bool)
    """
    bAbsoluteRotation: BoolProperty
    """If RelativeRotation should be considered relative to the world, rather than the parent.

    Unreal: USceneComponent.bAbsoluteRotation (bool)
    """
    bAbsoluteScale: BoolProperty
    """If RelativeScale3D should be considered relative to the world, rather than the parent.

    Unreal: USceneComponent.bAbsoluteScale (bool)
    """
    bVisible: BoolProperty
    """Whether to completely draw the component; if false, the component is not drawn at all.

    Unreal: USceneComponent.bVisible (bool)
    """
    bHiddenInGame: BoolProperty
    """Whether to hide the component in game, if visible.

    Unreal: USceneComponent.bHiddenInGame (bool)
    """
    bUseAttachParentBound: BoolProperty
    """If true, this component uses its parent's bounds when attached.

    Unreal: USceneComponent.bUseAttachParentBound (bool)
    """
    Mobility: Property[ValuePath[EComponentMobility, EComponentMobility_in], EComponentMobility_in]
    """How often this component is allowed to move. Change it with `SetMobility`.

    Unreal: USceneComponent.Mobility (TEnumAsByte<EComponentMobility::Type>)
    """

class USceneComponent_async(UActorComponent_async):
    """USceneComponent under ``async_``: each function gives a future."""
    def DoesSocketExist(self, InSocketName: str | Future[str]) -> Future[bool]:
        """Whether a socket with that name exists."""
    def GetAllSocketNames(self) -> Future[list[str]]:
        """Gets the names of all the sockets on the component."""
    def GetAttachParent(self) -> Future[USceneComponent | None]:
        """Gets the component we are attached to."""
    def GetAttachSocketName(self) -> Future[str]:
        """Gets the socket we are attached to."""
    def GetChildComponent(self, ChildIndex: int | Future[int]) -> Future[USceneComponent | None]:
        """Gets the attached child component at the specified location, or null when there is none."""
    def GetChildrenComponents(self, bIncludeAllDescendants: bool | Future[bool]) -> Future[USceneComponent_GetChildrenComponents_Result]:
        """Gets the attached children components."""
    def GetComponentVelocity(self) -> Future[FVector]:
        """Returns the velocity of the component, in centimetres per second."""
    def GetForwardVector(self) -> Future[FVector]:
        """Returns the forward (X) unit direction vector of this component, in world space."""
    def GetNumChildrenComponents(self) -> Future[int]:
        """Gets the number of attached children components."""
    def GetParentComponents(self) -> Future[USceneComponent_GetParentComponents_Result]:
        """Gets all components this one is attached to, up to the root."""
    def GetRelativeTransform(self) -> Future[FTransform]:
        """Returns the transform of the component relative to its parent."""
    def GetRightVector(self) -> Future[FVector]:
        """Returns the right (Y) unit direction vector of this component, in world space."""
    def GetSocketLocation(self, InSocketName: str | Future[str]) -> Future[FVector]:
        """Gets the world-space socket location."""
    def GetSocketQuaternion(self, InSocketName: str | Future[str]) -> Future[FQuat]:
        """Gets the world-space socket rotation as a quaternion."""
    def GetSocketRotation(self, InSocketName: str | Future[str]) -> Future[FRotator]:
        """Gets the world-space socket rotation, in degrees."""
    def GetSocketTransform(self, InSocketName: str | Future[str], TransformSpace: ERelativeTransformSpace_in = ERelativeTransformSpace.RTS_World) -> Future[FTransform]:
        """Gets the world-space socket transform; the component's own when there is no such socket."""
    def GetUpVector(self) -> Future[FVector]:
        """Returns the up (Z) unit direction vector of this component, in world space."""
    def IsVisible(self) -> Future[bool]:
        """Returns true if this component is visible in the current context."""
    def K2_AddLocalOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddLocalOffset_Result]:
        """Adds a delta to the location of the component in its own local frame."""
    def K2_AddLocalRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddLocalRotation_Result]:
        """Adds a delta to the rotation of the component in its own local frame."""
    def K2_AddLocalTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddLocalTransform_Result]:
        """Adds a delta to the transform of the component in its own local frame."""
    def K2_AddRelativeLocation(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddRelativeLocation_Result]:
        """Adds a delta to the translation of the component relative to its parent."""
    def K2_AddRelativeRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddRelativeRotation_Result]:
        """Adds a delta to the rotation of the component relative to its parent (the delta is applied after it)."""
    def K2_AddWorldOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddWorldOffset_Result]:
        """Adds a delta to the location of the component in world space."""
    def K2_AddWorldRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddWorldRotation_Result]:
        """Adds a delta to the rotation of the component in world space."""
    def K2_AddWorldTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddWorldTransform_Result]:
        """Adds a delta to the transform of the component in world space."""
    def K2_AddWorldTransformKeepScale(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_AddWorldTransformKeepScale_Result]:
        """Adds a delta to the transform of the component in world space."""
    def K2_AttachToComponent(self, Parent: USceneComponent | Future[USceneComponent], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> Future[bool]:
        """Attaches this component to another one."""
    def K2_DetachFromComponent(self, LocationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, RotationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, ScaleRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, bCallModify: bool | Future[bool] = True) -> Future[None]:
        """Detaches this component from whatever it is attached to."""
    def K2_GetComponentLocation(self) -> Future[FVector]:
        """Returns the location of the component, in world space."""
    def K2_GetComponentRotation(self) -> Future[FRotator]:
        """Returns the rotation of the component, in world space, in degrees."""
    def K2_GetComponentScale(self) -> Future[FVector]:
        """Returns the scale of the component, in world space."""
    def K2_GetComponentToWorld(self) -> Future[FTransform]:
        """Returns the current component-to-world transform."""
    def K2_SetRelativeLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_SetRelativeLocation_Result]:
        """Sets the location of the component relative to its parent."""
    def K2_SetRelativeLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_SetRelativeLocationAndRotation_Result]:
        """Sets location and rotation of the component relative to its parent."""
    def K2_SetRelativeRotation(self, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_SetRelativeRotation_Result]:
        """Sets the rotation of the component relative to its parent, in degrees."""
    def K2_SetRelativeTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_SetRelativeTransform_Result]:
        """Sets the transform of the component relative to its parent."""
    def K2_SetWorldLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_SetWorldLocation_Result]:
        """Puts this component at the specified location in world space."""
    def K2_SetWorldLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_SetWorldLocationAndRotation_Result]:
        """Sets location and rotation of the component in world space."""
    def K2_SetWorldRotation(self, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_SetWorldRotation_Result]:
        """Puts this component at the specified rotation in world space, in degrees."""
    def K2_SetWorldTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> Future[USceneComponent_K2_SetWorldTransform_Result]:
        """Sets the transform of the component in world space."""
    def ResetRelativeTransform(self) -> Future[None]:
        """Resets the relative transform to the identity."""
    def SetAbsolute(self, bNewAbsoluteLocation: bool | Future[bool] = False, bNewAbsoluteRotation: bool | Future[bool] = False, bNewAbsoluteScale: bool | Future[bool] = False) -> Future[None]:
        """Sets which parts of the relative transform are relative to the world instead of the parent."""
    def SetHiddenInGame(self, NewHidden: bool | Future[bool], bPropagateToChildren: bool | Future[bool] = False) -> Future[None]:
        """Changes the value of bHiddenInGame, optionally for all attached children too."""
    def SetMobility(self, NewMobility: EComponentMobility_in) -> Future[None]:
        """Sets how often this component is allowed to move during runtime."""
    def SetRelativeScale3D(self, NewScale3D: FVector_in) -> Future[None]:
        """Sets the non-uniform scale of the component relative to its parent."""
    def SetVisibility(self, bNewVisibility: bool | Future[bool], bPropagateToChildren: bool | Future[bool] = False) -> Future[None]:
        """Sets the visibility of the component."""
    def SetWorldScale3D(self, NewScale: FVector_in) -> Future[None]:
        """Sets the scale of the component in world space."""
    def ToggleVisibility(self, bPropagateToChildren: bool | Future[bool] = False) -> Future[None]:
        """Toggles the visibility of the component."""
    AttachParent: Property[USceneComponent_async_path, USceneComponent | Future[USceneComponent] | None]
    """What we are currently attached to."""
    AttachSocketName: AsyncStrProperty
    """Optional socket name on AttachParent that we are attached to."""
    AttachChildren: Property[AsyncArrayPath[USceneComponent | None, USceneComponent | Future[USceneComponent] | None, USceneComponent_async_path], Sequence[USceneComponent | Future[USceneComponent] | None] | Future[list[USceneComponent | None]]]
    """List of child components that are attached to us."""
    RelativeLocation: Property[FVector_async, FVector_in]
    """Location of the component relative to its parent, in centimetres."""
    RelativeRotation: Property[FRotator_async, FRotator_in]
    """Rotation of the component relative to its parent, in degrees."""
    RelativeScale3D: Property[FVector_async, FVector_in]
    """Non-uniform scaling of the component relative to its parent."""
    ComponentVelocity: Property[FVector_async, FVector_in]
    """Velocity of the component, in centimetres per second."""
    bAbsoluteLocation: AsyncBoolProperty
    """If RelativeLocation should be considered relative to the world, rather than the parent."""
    bAbsoluteRotation: AsyncBoolProperty
    """If RelativeRotation should be considered relative to the world, rather than the parent."""
    bAbsoluteScale: AsyncBoolProperty
    """If RelativeScale3D should be considered relative to the world, rather than the parent."""
    bVisible: AsyncBoolProperty
    """Whether to completely draw the component; if false, the component is not drawn at all."""
    bHiddenInGame: AsyncBoolProperty
    """Whether to hide the component in game, if visible."""
    bUseAttachParentBound: AsyncBoolProperty
    """If true, this component uses its parent's bounds when attached."""
    Mobility: Property[AsyncValuePath[EComponentMobility, EComponentMobility_in], EComponentMobility_in]
    """How often this component is allowed to move."""

class USceneComponent_send(UActorComponent_send):
    """USceneComponent under ``send_``: no function answers."""
    def DoesSocketExist(self, InSocketName: str | Future[str]) -> None:
        """Whether a socket with that name exists."""
    def GetAllSocketNames(self) -> None:
        """Gets the names of all the sockets on the component."""
    def GetAttachParent(self) -> None:
        """Gets the component we are attached to."""
    def GetAttachSocketName(self) -> None:
        """Gets the socket we are attached to."""
    def GetChildComponent(self, ChildIndex: int | Future[int]) -> None:
        """Gets the attached child component at the specified location, or null when there is none."""
    def GetChildrenComponents(self, bIncludeAllDescendants: bool | Future[bool]) -> None:
        """Gets the attached children components."""
    def GetComponentVelocity(self) -> None:
        """Returns the velocity of the component, in centimetres per second."""
    def GetForwardVector(self) -> None:
        """Returns the forward (X) unit direction vector of this component, in world space."""
    def GetNumChildrenComponents(self) -> None:
        """Gets the number of attached children components."""
    def GetParentComponents(self) -> None:
        """Gets all components this one is attached to, up to the root."""
    def GetRelativeTransform(self) -> None:
        """Returns the transform of the component relative to its parent."""
    def GetRightVector(self) -> None:
        """Returns the right (Y) unit direction vector of this component, in world space."""
    def GetSocketLocation(self, InSocketName: str | Future[str]) -> None:
        """Gets the world-space socket location."""
    def GetSocketQuaternion(self, InSocketName: str | Future[str]) -> None:
        """Gets the world-space socket rotation as a quaternion."""
    def GetSocketRotation(self, InSocketName: str | Future[str]) -> None:
        """Gets the world-space socket rotation, in degrees."""
    def GetSocketTransform(self, InSocketName: str | Future[str], TransformSpace: ERelativeTransformSpace_in = ERelativeTransformSpace.RTS_World) -> None:
        """Gets the world-space socket transform; the component's own when there is no such socket."""
    def GetUpVector(self) -> None:
        """Returns the up (Z) unit direction vector of this component, in world space."""
    def IsVisible(self) -> None:
        """Returns true if this component is visible in the current context."""
    def K2_AddLocalOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the location of the component in its own local frame."""
    def K2_AddLocalRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the rotation of the component in its own local frame."""
    def K2_AddLocalTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the transform of the component in its own local frame."""
    def K2_AddRelativeLocation(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the translation of the component relative to its parent."""
    def K2_AddRelativeRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the rotation of the component relative to its parent (the delta is applied after it)."""
    def K2_AddWorldOffset(self, DeltaLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the location of the component in world space."""
    def K2_AddWorldRotation(self, DeltaRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the rotation of the component in world space."""
    def K2_AddWorldTransform(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the transform of the component in world space."""
    def K2_AddWorldTransformKeepScale(self, DeltaTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Adds a delta to the transform of the component in world space."""
    def K2_AttachToComponent(self, Parent: USceneComponent | Future[USceneComponent], SocketName: str | Future[str], LocationRule: EAttachmentRule_in, RotationRule: EAttachmentRule_in, ScaleRule: EAttachmentRule_in, bWeldSimulatedBodies: bool | Future[bool]) -> None:
        """Attaches this component to another one."""
    def K2_DetachFromComponent(self, LocationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, RotationRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, ScaleRule: EDetachmentRule_in = EDetachmentRule.KeepRelative, bCallModify: bool | Future[bool] = True) -> None:
        """Detaches this component from whatever it is attached to."""
    def K2_GetComponentLocation(self) -> None:
        """Returns the location of the component, in world space."""
    def K2_GetComponentRotation(self) -> None:
        """Returns the rotation of the component, in world space, in degrees."""
    def K2_GetComponentScale(self) -> None:
        """Returns the scale of the component, in world space."""
    def K2_GetComponentToWorld(self) -> None:
        """Returns the current component-to-world transform."""
    def K2_SetRelativeLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Sets the location of the component relative to its parent."""
    def K2_SetRelativeLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Sets location and rotation of the component relative to its parent."""
    def K2_SetRelativeRotation(self, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Sets the rotation of the component relative to its parent, in degrees."""
    def K2_SetRelativeTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Sets the transform of the component relative to its parent."""
    def K2_SetWorldLocation(self, NewLocation: FVector_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Puts this component at the specified location in world space."""
    def K2_SetWorldLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Sets location and rotation of the component in world space."""
    def K2_SetWorldRotation(self, NewRotation: FRotator_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Puts this component at the specified rotation in world space, in degrees."""
    def K2_SetWorldTransform(self, NewTransform: FTransform_in, bSweep: bool | Future[bool], bTeleport: bool | Future[bool]) -> None:
        """Sets the transform of the component in world space."""
    def ResetRelativeTransform(self) -> None:
        """Resets the relative transform to the identity."""
    def SetAbsolute(self, bNewAbsoluteLocation: bool | Future[bool] = False, bNewAbsoluteRotation: bool | Future[bool] = False, bNewAbsoluteScale: bool | Future[bool] = False) -> None:
        """Sets which parts of the relative transform are relative to the world instead of the parent."""
    def SetHiddenInGame(self, NewHidden: bool | Future[bool], bPropagateToChildren: bool | Future[bool] = False) -> None:
        """Changes the value of bHiddenInGame, optionally for all attached children too."""
    def SetMobility(self, NewMobility: EComponentMobility_in) -> None:
        """Sets how often this component is allowed to move during runtime."""
    def SetRelativeScale3D(self, NewScale3D: FVector_in) -> None:
        """Sets the non-uniform scale of the component relative to its parent."""
    def SetVisibility(self, bNewVisibility: bool | Future[bool], bPropagateToChildren: bool | Future[bool] = False) -> None:
        """Sets the visibility of the component."""
    def SetWorldScale3D(self, NewScale: FVector_in) -> None:
        """Sets the scale of the component in world space."""
    def ToggleVisibility(self, bPropagateToChildren: bool | Future[bool] = False) -> None:
        """Toggles the visibility of the component."""
    AttachParent: SendProperty[USceneComponent | Future[USceneComponent] | None]
    AttachSocketName: SendStrProperty
    AttachChildren: SendProperty[Sequence[USceneComponent | Future[USceneComponent] | None] | Future[list[USceneComponent | None]]]
    RelativeLocation: SendProperty[FVector_in]
    RelativeRotation: SendProperty[FRotator_in]
    RelativeScale3D: SendProperty[FVector_in]
    ComponentVelocity: SendProperty[FVector_in]
    bAbsoluteLocation: SendBoolProperty
    bAbsoluteRotation: SendBoolProperty
    bAbsoluteScale: SendBoolProperty
    bVisible: SendBoolProperty
    bHiddenInGame: SendBoolProperty
    bUseAttachParentBound: SendBoolProperty
    Mobility: SendProperty[EComponentMobility_in]

class USceneComponent(USceneComponent_members, UActorComponent):
    """A component with a transform, which can be attached to another one. It has no rendering or collision of its
    own.

    Locations are in centimetres, rotations in degrees (left-handed, Z up). The relative values are relative to
    the attach parent (or one of its sockets), or to the world where `SetAbsolute` says so. Writing
    `RelativeLocation`, `RelativeRotation` or `RelativeScale3D` as properties changes only those values: the world
    transform, the bounds and the attached children follow when a setter or `UpdateComponentToWorld` runs, as in
    UE. Epic page: USceneComponent.

    Unreal: /Script/Engine.SceneComponent
    """
    @property
    def async_(self) -> USceneComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> USceneComponent_send:
        """The same functions and variables, fire-and-forget."""

class USceneComponent_path(ObjectPath[USceneComponent, USceneComponent_async_path, USceneComponent_send], USceneComponent_members):
    """A variable that refers to an object of USceneComponent: its path."""

class USceneComponent_async_path(AsyncObjectPath[USceneComponent], USceneComponent_async):
    """The same under ``async_``."""
