# generated, do not edit (Engine: Public/GameFramework/DefaultPawn.h)
from spear.typing import AsyncFloatProperty, AsyncObjectPath, FloatProperty, Future, ObjectPath, Property, SendFloatProperty, SendProperty
from ._Pawn import APawn, APawn_async, APawn_members, APawn_send
from ._PawnMovementComponent import UPawnMovementComponent, UPawnMovementComponent_async_path, UPawnMovementComponent_path
from ._SphereComponent import USphereComponent, USphereComponent_async_path, USphereComponent_path

class ADefaultPawn_members(APawn_members):
    """Functions and variables of ADefaultPawn."""
    def LookUpAtRate(self, Rate: float | Future[float]) -> None:
        """Called via input to look up at a given rate (or down if Rate is negative).

        Unreal: ADefaultPawn.LookUpAtRate
        """
    def MoveForward(self, Val: float | Future[float]) -> None:
        """Input callback to move forward in local space (or backward if Val is negative).

        Args:
            Val: amount of movement in the forward direction (or backward if negative).

        Unreal: ADefaultPawn.MoveForward
        """
    def MoveRight(self, Val: float | Future[float]) -> None:
        """Input callback to strafe right in local space (or left if Val is negative).

        Unreal: ADefaultPawn.MoveRight
        """
    def MoveUp_World(self, Val: float | Future[float]) -> None:
        """Input callback to move up in world space (or down if Val is negative).

        Unreal: ADefaultPawn.MoveUp_World
        """
    def TurnAtRate(self, Rate: float | Future[float]) -> None:
        """Called via input to turn at a given rate.

        Args:
            Rate: this is a normalized rate, i.e. 1.0 means 100% of desired turn rate.

        Unreal: ADefaultPawn.TurnAtRate
        """
    BaseTurnRate: FloatProperty
    """Base turn rate, in deg/sec. Other scaling may affect final turn rate.

    Unreal: ADefaultPawn.BaseTurnRate (float)
    """
    BaseLookUpRate: FloatProperty
    """Base lookup rate, in deg/sec. Other scaling may affect final lookup rate.

    Unreal: ADefaultPawn.BaseLookUpRate (float)
    """
    MovementComponent: Property[UPawnMovementComponent_path, UPawnMovementComponent | Future[UPawnMovementComponent] | None]
    """DefaultPawn movement component.

    Unreal: ADefaultPawn.MovementComponent (UPawnMovementComponent*)
    """
    CollisionComponent: Property[USphereComponent_path, USphereComponent | Future[USphereComponent] | None]
    """DefaultPawn collision component.

    Unreal: ADefaultPawn.CollisionComponent (USphereComponent*)
    """

class ADefaultPawn_async(APawn_async):
    """ADefaultPawn under ``async_``: each function gives a future."""
    def LookUpAtRate(self, Rate: float | Future[float]) -> Future[None]:
        """Called via input to look up at a given rate (or down if Rate is negative)."""
    def MoveForward(self, Val: float | Future[float]) -> Future[None]:
        """Input callback to move forward in local space (or backward if Val is negative)."""
    def MoveRight(self, Val: float | Future[float]) -> Future[None]:
        """Input callback to strafe right in local space (or left if Val is negative)."""
    def MoveUp_World(self, Val: float | Future[float]) -> Future[None]:
        """Input callback to move up in world space (or down if Val is negative)."""
    def TurnAtRate(self, Rate: float | Future[float]) -> Future[None]:
        """Called via input to turn at a given rate."""
    BaseTurnRate: AsyncFloatProperty
    """Base turn rate, in deg/sec."""
    BaseLookUpRate: AsyncFloatProperty
    """Base lookup rate, in deg/sec."""
    MovementComponent: Property[UPawnMovementComponent_async_path, UPawnMovementComponent | Future[UPawnMovementComponent] | None]
    """DefaultPawn movement component."""
    CollisionComponent: Property[USphereComponent_async_path, USphereComponent | Future[USphereComponent] | None]
    """DefaultPawn collision component."""

class ADefaultPawn_send(APawn_send):
    """ADefaultPawn under ``send_``: no function answers."""
    def LookUpAtRate(self, Rate: float | Future[float]) -> None:
        """Called via input to look up at a given rate (or down if Rate is negative)."""
    def MoveForward(self, Val: float | Future[float]) -> None:
        """Input callback to move forward in local space (or backward if Val is negative)."""
    def MoveRight(self, Val: float | Future[float]) -> None:
        """Input callback to strafe right in local space (or left if Val is negative)."""
    def MoveUp_World(self, Val: float | Future[float]) -> None:
        """Input callback to move up in world space (or down if Val is negative)."""
    def TurnAtRate(self, Rate: float | Future[float]) -> None:
        """Called via input to turn at a given rate."""
    BaseTurnRate: SendFloatProperty
    BaseLookUpRate: SendFloatProperty
    MovementComponent: SendProperty[UPawnMovementComponent | Future[UPawnMovementComponent] | None]
    CollisionComponent: SendProperty[USphereComponent | Future[USphereComponent] | None]

class ADefaultPawn(ADefaultPawn_members, APawn):
    """DefaultPawn implements a simple Pawn with spherical collision and built-in flying movement.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/ADefaultPawn

    Unreal: /Script/Engine.DefaultPawn
    """
    @property
    def async_(self) -> ADefaultPawn_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ADefaultPawn_send:
        """The same functions and variables, fire-and-forget."""

class ADefaultPawn_path(ObjectPath[ADefaultPawn, ADefaultPawn_async_path, ADefaultPawn_send], ADefaultPawn_members):
    """A variable that refers to an object of ADefaultPawn: its path."""

class ADefaultPawn_async_path(AsyncObjectPath[ADefaultPawn], ADefaultPawn_async):
    """The same under ``async_``."""
