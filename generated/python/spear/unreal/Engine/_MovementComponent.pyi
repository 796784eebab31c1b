# generated, do not edit (Engine: Public/GameFramework/MovementComponent.h)
from typing import NamedTuple, TypeAlias
from spear.enums import UnrealEnum
from spear.typing import (
    AsyncBoolProperty, AsyncObjectPath, AsyncValuePath, BoolProperty, Future, ObjectPath, Property, SendBoolProperty, SendProperty, ValuePath,
)
from ..CoreUObject._NoExportTypes import FRotator_in, FVector, FVector_async, FVector_in, FVector_path
from ._ActorComponent import UActorComponent, UActorComponent_async, UActorComponent_members, UActorComponent_send
from ._HitResult import FHitResult
from ._PrimitiveComponent import UPrimitiveComponent, UPrimitiveComponent_async_path, UPrimitiveComponent_path
from ._SceneComponent import USceneComponent, USceneComponent_async_path, USceneComponent_path

class EPlaneConstraintAxisSetting(UnrealEnum):
    """Which plane movement is constrained to. Epic page: EPlaneConstraintAxisSetting.

    Unreal: /Script/Engine.EPlaneConstraintAxisSetting
    """
    Custom = 0
    """Lock movement to a user-defined axis."""
    X = 1
    """Lock movement in the X axis."""
    Y = 2
    """Lock movement in the Y axis."""
    Z = 3
    """Lock movement in the Z axis."""
    UseGlobalPhysicsSetting = 4
    """Use the physics project setting; here that is the axis set by hand."""

EPlaneConstraintAxisSetting_in: TypeAlias = EPlaneConstraintAxisSetting | str | Future[EPlaneConstraintAxisSetting]
"""What stands for EPlaneConstraintAxisSetting as an argument: an entry, the name that Unreal gives it, a future."""

class UMovementComponent_K2_MoveUpdatedComponent_Result(NamedTuple):
    """Results of UMovementComponent.K2_MoveUpdatedComponent."""
    ReturnValue: bool
    """whether it moved"""
    OutHit: FHitResult

class UMovementComponent_members(UActorComponent_members):
    """Functions and variables of UMovementComponent."""
    def ConstrainDirectionToPlane(self, Direction: FVector_in) -> FVector:
        """Constrains a direction vector to the plane, if enabled.

        Unreal: UMovementComponent.ConstrainDirectionToPlane
        """
    def ConstrainLocationToPlane(self, Location: FVector_in) -> FVector:
        """Constrains a position vector to the plane, if enabled.

        Unreal: UMovementComponent.ConstrainLocationToPlane
        """
    def ConstrainNormalToPlane(self, Normal: FVector_in) -> FVector:
        """Constrains a normal vector (of unit length) to the plane, if enabled.

        Unreal: UMovementComponent.ConstrainNormalToPlane
        """
    def GetGravityZ(self) -> float:
        """Returns gravity that affects this component, in centimetres per second squared.

        Unreal: UMovementComponent.GetGravityZ
        """
    def GetMaxSpeed(self) -> float:
        """Returns maximum speed, in centimetres per second.

        Unreal: UMovementComponent.GetMaxSpeed
        """
    def GetPlaneConstraintNormal(self) -> FVector:
        """Gets the normal of the plane.

        Unreal: UMovementComponent.GetPlaneConstraintNormal
        """
    def GetPlaneConstraintOrigin(self) -> FVector:
        """Gets the origin of the plane.

        Unreal: UMovementComponent.GetPlaneConstraintOrigin
        """
    def IsExceedingMaxSpeed(self, MaxSpeed: float | Future[float]) -> bool:
        """Returns true if the current velocity is exceeding the given max speed (usually the result of GetMaxSpeed()),
        within a small error tolerance.

        Unreal: UMovementComponent.IsExceedingMaxSpeed
        """
    def K2_MoveUpdatedComponent(self, Delta: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool] = True, bTeleport: bool | Future[bool] = False) -> UMovementComponent_K2_MoveUpdatedComponent_Result:
        """Moves the updated component by a delta, constrained to the plane.

        Returns:
            whether it moved

        Unreal: UMovementComponent.K2_MoveUpdatedComponent
        """
    def SetPlaneConstraintAxisSetting(self, NewAxisSetting: EPlaneConstraintAxisSetting_in) -> None:
        """Sets the axis setting of the plane that constrains movement.

        Unreal: UMovementComponent.SetPlaneConstraintAxisSetting
        """
    def SetPlaneConstraintEnabled(self, bEnabled: bool | Future[bool]) -> None:
        """Changes whether movement is constrained to a plane.

        Unreal: UMovementComponent.SetPlaneConstraintEnabled
        """
    def SetPlaneConstraintNormal(self, PlaneNormal: FVector_in) -> None:
        """Sets the normal of the plane that constrains movement.

        Unreal: UMovementComponent.SetPlaneConstraintNormal
        """
    def SetPlaneConstraintOrigin(self, PlaneOrigin: FVector_in) -> None:
        """Sets the origin of the plane that constrains movement.

        Unreal: UMovementComponent.SetPlaneConstraintOrigin
        """
    def SetUpdatedComponent(self, NewUpdatedComponent: USceneComponent | Future[USceneComponent]) -> None:
        """Assigns the component we move and update.

        Unreal: UMovementComponent.SetUpdatedComponent
        """
    def SnapUpdatedComponentToPlane(self) -> None:
        """Snaps the updated component to the plane, if enabled.

        Unreal: UMovementComponent.SnapUpdatedComponentToPlane
        """
    def StopMovementImmediately(self) -> None:
        """Stops movement immediately (zeroes velocity, usually zeros acceleration for components with acceleration).

        Unreal: UMovementComponent.StopMovementImmediately
        """
    UpdatedComponent: Property[USceneComponent_path, USceneComponent | Future[USceneComponent] | None]
    """The component we move and update. If this is null at startup, the owner's root component will automatically be
    set.

    Unreal: UMovementComponent.UpdatedComponent (USceneComponent*)
    """
    UpdatedPrimitive: Property[UPrimitiveComponent_path, UPrimitiveComponent | Future[UPrimitiveComponent] | None]
    """UpdatedComponent, cast as a UPrimitiveComponent. May be null.

    Unreal: UMovementComponent.UpdatedPrimitive (UPrimitiveComponent*)
    """
    Velocity: Property[FVector_path, FVector_in]
    """Current velocity of the moved component, in centimetres per second.

    Unreal: UMovementComponent.Velocity (FVector)
    """
    bConstrainToPlane: BoolProperty
    """Whether movement is constrained to a plane.

    Unreal: UMovementComponent.bConstrainToPlane (bool)
    """
    bSnapToPlaneAtStart: BoolProperty
    """If true and plane constraints are enabled, then the updated component will be snapped to the plane when first
    attached.

    Unreal: UMovementComponent.bSnapToPlaneAtStart (bool)
    """
    bAutoRegisterUpdatedComponent: BoolProperty
    """If true, after registration we will set the updated component to the owner's root where none is set.

    Unreal: UMovementComponent.bAutoRegisterUpdatedComponent (bool)
    """
    bTickBeforeOwner: BoolProperty
    """If true, the movement component ticks before its owner does.

    Unreal: UMovementComponent.bTickBeforeOwner (bool)
    """
    PlaneConstraintNormal: Property[FVector_path, FVector_in]
    """The normal of the plane that movement is constrained to.

    Unreal: UMovementComponent.PlaneConstraintNormal (FVector)
    """
    PlaneConstraintOrigin: Property[FVector_path, FVector_in]
    """The origin of the plane that movement is constrained to.

    Unreal: UMovementComponent.PlaneConstraintOrigin (FVector)
    """
    PlaneConstraintAxisSetting: Property[ValuePath[EPlaneConstraintAxisSetting, EPlaneConstraintAxisSetting_in], EPlaneConstraintAxisSetting_in]
    """Which axis the plane's normal is.

    Unreal: UMovementComponent.PlaneConstraintAxisSetting (EPlaneConstraintAxisSetting)
    """

class UMovementComponent_async(UActorComponent_async):
    """UMovementComponent under ``async_``: each function gives a future."""
    def ConstrainDirectionToPlane(self, Direction: FVector_in) -> Future[FVector]:
        """Constrains a direction vector to the plane, if enabled."""
    def ConstrainLocationToPlane(self, Location: FVector_in) -> Future[FVector]:
        """Constrains a position vector to the plane, if enabled."""
    def ConstrainNormalToPlane(self, Normal: FVector_in) -> Future[FVector]:
        """Constrains a normal vector (of unit length) to the plane, if enabled."""
    def GetGravityZ(self) -> Future[float]:
        """Returns gravity that affects this component, in centimetres per second squared."""
    def GetMaxSpeed(self) -> Future[float]:
        """Returns maximum speed, in centimetres per second."""
    def GetPlaneConstraintNormal(self) -> Future[FVector]:
        """Gets the normal of the plane."""
    def GetPlaneConstraintOrigin(self) -> Future[FVector]:
        """Gets the origin of the plane."""
    def IsExceedingMaxSpeed(self, MaxSpeed: float | Future[float]) -> Future[bool]:
        """Returns true if the current velocity is exceeding the given max speed (usually the result of GetMaxSpeed()), within a small error tolerance."""
    def K2_MoveUpdatedComponent(self, Delta: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool] = True, bTeleport: bool | Future[bool] = False) -> Future[UMovementComponent_K2_MoveUpdatedComponent_Result]:
        """Moves the updated component by a delta, constrained to the plane."""
    def SetPlaneConstraintAxisSetting(self, NewAxisSetting: EPlaneConstraintAxisSetting_in) -> Future[None]:
        """Sets the axis setting of the plane that constrains movement."""
    def SetPlaneConstraintEnabled(self, bEnabled: bool | Future[bool]) -> Future[None]:
        """Changes whether movement is constrained to a plane."""
    def SetPlaneConstraintNormal(self, PlaneNormal: FVector_in) -> Future[None]:
        """Sets the normal of the plane that constrains movement."""
    def SetPlaneConstraintOrigin(self, PlaneOrigin: FVector_in) -> Future[None]:
        """Sets the origin of the plane that constrains movement."""
    def SetUpdatedComponent(self, NewUpdatedComponent: USceneComponent | Future[USceneComponent]) -> Future[None]:
        """Assigns the component we move and update."""
    def SnapUpdatedComponentToPlane(self) -> Future[None]:
        """Snaps the updated component to the plane, if enabled."""
    def StopMovementImmediately(self) -> Future[None]:
        """Stops movement immediately (zeroes velocity, usually zeros acceleration for components with acceleration)."""
    UpdatedComponent: Property[USceneComponent_async_path, USceneComponent | Future[USceneComponent] | None]
    """The component we move and update."""
    UpdatedPrimitive: Property[UPrimitiveComponent_async_path, UPrimitiveComponent | Future[UPrimitiveComponent] | None]
    """UpdatedComponent, cast as a UPrimitiveComponent."""
    Velocity: Property[FVector_async, FVector_in]
    """Current velocity of the moved component, in centimetres per second."""
    bConstrainToPlane: AsyncBoolProperty
    """Whether movement is constrained to a plane."""
    bSnapToPlaneAtStart: AsyncBoolProperty
    """If true and plane constraints are enabled, then the updated component will be snapped to the plane when first attached."""
    bAutoRegisterUpdatedComponent: AsyncBoolProperty
    """If true, after registration we will set the updated component to the owner's root where none is set."""
    bTickBeforeOwner: AsyncBoolProperty
    """If true, the movement component ticks before its owner does."""
    PlaneConstraintNormal: Property[FVector_async, FVector_in]
    """The normal of the plane that movement is constrained to."""
    PlaneConstraintOrigin: Property[FVector_async, FVector_in]
    """The origin of the plane that movement is constrained to."""
    PlaneConstraintAxisSetting: Property[AsyncValuePath[EPlaneConstraintAxisSetting, EPlaneConstraintAxisSetting_in], EPlaneConstraintAxisSetting_in]
    """Which axis the plane's normal is."""

class UMovementComponent_send(UActorComponent_send):
    """UMovementComponent under ``send_``: no function answers."""
    def ConstrainDirectionToPlane(self, Direction: FVector_in) -> None:
        """Constrains a direction vector to the plane, if enabled."""
    def ConstrainLocationToPlane(self, Location: FVector_in) -> None:
        """Constrains a position vector to the plane, if enabled."""
    def ConstrainNormalToPlane(self, Normal: FVector_in) -> None:
        """Constrains a normal vector (of unit length) to the plane, if enabled."""
    def GetGravityZ(self) -> None:
        """Returns gravity that affects this component, in centimetres per second squared."""
    def GetMaxSpeed(self) -> None:
        """Returns maximum speed, in centimetres per second."""
    def GetPlaneConstraintNormal(self) -> None:
        """Gets the normal of the plane."""
    def GetPlaneConstraintOrigin(self) -> None:
        """Gets the origin of the plane."""
    def IsExceedingMaxSpeed(self, MaxSpeed: float | Future[float]) -> None:
        """Returns true if the current velocity is exceeding the given max speed (usually the result of GetMaxSpeed()), within a small error tolerance."""
    def K2_MoveUpdatedComponent(self, Delta: FVector_in, NewRotation: FRotator_in, bSweep: bool | Future[bool] = True, bTeleport: bool | Future[bool] = False) -> None:
        """Moves the updated component by a delta, constrained to the plane."""
    def SetPlaneConstraintAxisSetting(self, NewAxisSetting: EPlaneConstraintAxisSetting_in) -> None:
        """Sets the axis setting of the plane that constrains movement."""
    def SetPlaneConstraintEnabled(self, bEnabled: bool | Future[bool]) -> None:
        """Changes whether movement is constrained to a plane."""
    def SetPlaneConstraintNormal(self, PlaneNormal: FVector_in) -> None:
        """Sets the normal of the plane that constrains movement."""
    def SetPlaneConstraintOrigin(self, PlaneOrigin: FVector_in) -> None:
        """Sets the origin of the plane that constrains movement."""
    def SetUpdatedComponent(self, NewUpdatedComponent: USceneComponent | Future[USceneComponent]) -> None:
        """Assigns the component we move and update."""
    def SnapUpdatedComponentToPlane(self) -> None:
        """Snaps the updated component to the plane, if enabled."""
    def StopMovementImmediately(self) -> None:
        """Stops movement immediately (zeroes velocity, usually zeros acceleration for components with acceleration)."""
    UpdatedComponent: SendProperty[USceneComponent | Future[USceneComponent] | None]
    UpdatedPrimitive: SendProperty[UPrimitiveComponent | Future[UPrimitiveComponent] | None]
    Velocity: SendProperty[FVector_in]
    bConstrainToPlane: SendBoolProperty
    bSnapToPlaneAtStart: SendBoolProperty
    bAutoRegisterUpdatedComponent: SendBoolProperty
    bTickBeforeOwner: SendBoolProperty
    PlaneConstraintNormal: SendProperty[FVector_in]
    PlaneConstraintOrigin: SendProperty[FVector_in]
    PlaneConstraintAxisSetting: SendProperty[EPlaneConstraintAxisSetting_in]

class UMovementComponent(UMovementComponent_members, UActorComponent):
    """Base of the components that move a scene component (by default the owner's root).

    The embedded engine has no collision queries yet: moves never hit anything. Epic page: UMovementComponent.

    Unreal: /Script/Engine.MovementComponent
    """
    @property
    def async_(self) -> UMovementComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UMovementComponent_send:
        """The same functions and variables, fire-and-forget."""

class UMovementComponent_path(ObjectPath[UMovementComponent, UMovementComponent_async_path, UMovementComponent_send], UMovementComponent_members):
    """A variable that refers to an object of UMovementComponent: its path."""

class UMovementComponent_async_path(AsyncObjectPath[UMovementComponent], UMovementComponent_async):
    """The same under ``async_``."""
