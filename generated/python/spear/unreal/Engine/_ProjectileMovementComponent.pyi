# generated, do not edit (Engine: Public/GameFramework/ProjectileMovementComponent.h)
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncIntProperty, AsyncObjectPath, BoolProperty, FloatProperty, Future, IntProperty, ObjectPath, Property,
    SendBoolProperty, SendFloatProperty, SendIntProperty, SendProperty,
)
from ..CoreUObject._NoExportTypes import FVector_in
from ._MovementComponent import UMovementComponent, UMovementComponent_async, UMovementComponent_members, UMovementComponent_send
from ._SceneComponent import USceneComponent, USceneComponent_async_path, USceneComponent_path

class UProjectileMovementComponent_members(UMovementComponent_members):
    """Functions and variables of UProjectileMovementComponent."""
    def SetVelocityInLocalSpace(self, NewVelocity: FVector_in) -> None:
        """Sets the velocity to a vector in the updated component's local space.

        Unreal: UProjectileMovementComponent.SetVelocityInLocalSpace
        """
    InitialSpeed: FloatProperty
    """Initial speed of the projectile, in centimetres per second. If greater than zero, this will override the
    initial Velocity value and instead treat Velocity as a direction.

    Unreal: UProjectileMovementComponent.InitialSpeed (float)
    """
    MaxSpeed: FloatProperty
    """Limit on the speed of the projectile, in centimetres per second (0 means no limit).

    Unreal: UProjectileMovementComponent.MaxSpeed (float)
    """
    bRotationFollowsVelocity: BoolProperty
    """If true, this projectile will have its rotation updated each frame to match the direction of its velocity.

    Unreal: UProjectileMovementComponent.bRotationFollowsVelocity (bool)
    """
    bRotationRemainsVertical: BoolProperty
    """If true, this projectile will have its rotation updated each frame to maintain the rotation's pitch at zero.

    Unreal: UProjectileMovementComponent.bRotationRemainsVertical (bool)
    """
    bInitialVelocityInLocalSpace: BoolProperty
    """If true, the initial Velocity is interpreted as being in local space upon startup.

    Unreal: UProjectileMovementComponent.bInitialVelocityInLocalSpace (bool)
    """
    bSimulationEnabled: BoolProperty
    """If true, does normal simulation ticking and update. If false, simulation is halted, but component will still
    tick.

    Unreal: UProjectileMovementComponent.bSimulationEnabled (bool)
    """
    bForceSubStepping: BoolProperty
    """If true, forces sub-stepping to break up movement into discrete smaller steps to improve accuracy of the
    trajectory.

    Unreal: UProjectileMovementComponent.bForceSubStepping (bool)
    """
    bIsHomingProjectile: BoolProperty
    """If true, we will accelerate toward our homing target. HomingTargetComponent must be set after the projectile
    is spawned.

    Unreal: UProjectileMovementComponent.bIsHomingProjectile (bool)
    """
    ProjectileGravityScale: FloatProperty
    """Custom gravity scale for this projectile. Set to 0 for no gravity.

    Unreal: UProjectileMovementComponent.ProjectileGravityScale (float)
    """
    HomingAccelerationMagnitude: FloatProperty
    """The magnitude of our acceleration towards the homing target, in centimetres per second squared.

    Unreal: UProjectileMovementComponent.HomingAccelerationMagnitude (float)
    """
    HomingTargetComponent: Property[USceneComponent_path, USceneComponent | Future[USceneComponent] | None]
    """The current target we are homing towards.

    Unreal: UProjectileMovementComponent.HomingTargetComponent (TWeakObjectPtr<USceneComponent>)
    """
    MaxSimulationTimeStep: FloatProperty
    """Max time delta for each discrete simulation step, in seconds. Used only when sub-stepping.

    0.0166 to 0.50

    Unreal: UProjectileMovementComponent.MaxSimulationTimeStep (float)
    """
    MaxSimulationIterations: IntProperty
    """Max number of iterations used for each discrete simulation step.

    1 to 25

    Unreal: UProjectileMovementComponent.MaxSimulationIterations (int32)
    """

class UProjectileMovementComponent_async(UMovementComponent_async):
    """UProjectileMovementComponent under ``async_``: each function gives a future."""
    def SetVelocityInLocalSpace(self, NewVelocity: FVector_in) -> Future[None]:
        """Sets the velocity to a vector in the updated component's local space."""
    InitialSpeed: AsyncFloatProperty
    """Initial speed of the projectile, in centimetres per second."""
    MaxSpeed: AsyncFloatProperty
    """Limit on the speed of the projectile, in centimetres per second (0 means no limit)."""
    bRotationFollowsVelocity: AsyncBoolProperty
    """If true, this projectile will have its rotation updated each frame to match the direction of its velocity."""
    bRotationRemainsVertical: AsyncBoolProperty
    """If true, this projectile will have its rotation updated each frame to maintain the rotation's pitch at zero."""
    bInitialVelocityInLocalSpace: AsyncBoolProperty
    """If true, the initial Velocity is interpreted as being in local space upon startup."""
    bSimulationEnabled: AsyncBoolProperty
    """If true, does normal simulation ticking and update."""
    bForceSubStepping: AsyncBoolProperty
    """If true, forces sub-stepping to break up movement into discrete smaller steps to improve accuracy of the trajectory."""
    bIsHomingProjectile: AsyncBoolProperty
    """If true, we will accelerate toward our homing target."""
    ProjectileGravityScale: AsyncFloatProperty
    """Custom gravity scale for this projectile."""
    HomingAccelerationMagnitude: AsyncFloatProperty
    """The magnitude of our acceleration towards the homing target, in centimetres per second squared."""
    HomingTargetComponent: Property[USceneComponent_async_path, USceneComponent | Future[USceneComponent] | None]
    """The current target we are homing towards."""
    MaxSimulationTimeStep: AsyncFloatProperty
    """Max time delta for each discrete simulation step, in seconds."""
    MaxSimulationIterations: AsyncIntProperty
    """Max number of iterations used for each discrete simulation step."""

class UProjectileMovementComponent_send(UMovementComponent_send):
    """UProjectileMovementComponent under ``send_``: no function answers."""
    def SetVelocityInLocalSpace(self, NewVelocity: FVector_in) -> None:
        """Sets the velocity to a vector in the updated component's local space."""
    InitialSpeed: SendFloatProperty
    MaxSpeed: SendFloatProperty
    bRotationFollowsVelocity: SendBoolProperty
    bRotationRemainsVertical: SendBoolProperty
    bInitialVelocityInLocalSpace: SendBoolProperty
    bSimulationEnabled: SendBoolProperty
    bForceSubStepping: SendBoolProperty
    bIsHomingProjectile: SendBoolProperty
    ProjectileGravityScale: SendFloatProperty
    HomingAccelerationMagnitude: SendFloatProperty
    HomingTargetComponent: SendProperty[USceneComponent | Future[USceneComponent] | None]
    MaxSimulationTimeStep: SendFloatProperty
    MaxSimulationIterations: SendIntProperty

class UProjectileMovementComponent(UProjectileMovementComponent_members, UMovementComponent):
    """Flies the updated component under gravity, with an optional homing target. The position over one step is exact
    for a constant acceleration, so a thrown object follows its parabola at any frame rate. Bouncing and stopping
    need collision and are absent. Epic page: UProjectileMovementComponent.

    Unreal: /Script/Engine.ProjectileMovementComponent
    """
    @property
    def async_(self) -> UProjectileMovementComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UProjectileMovementComponent_send:
        """The same functions and variables, fire-and-forget."""

class UProjectileMovementComponent_path(ObjectPath[UProjectileMovementComponent, UProjectileMovementComponent_async_path, UProjectileMovementComponent_send], UProjectileMovementComponent_members):
    """A variable that refers to an object of UProjectileMovementComponent: its path."""

class UProjectileMovementComponent_async_path(AsyncObjectPath[UProjectileMovementComponent], UProjectileMovementComponent_async):
    """The same under ``async_``."""
