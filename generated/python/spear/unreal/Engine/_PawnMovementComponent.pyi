# generated, do not edit (Engine: Public/GameFramework/PawnMovementComponent.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import FVector, FVector_in
from ._MovementComponent import UMovementComponent, UMovementComponent_async, UMovementComponent_members, UMovementComponent_send
from ._Pawn import APawn, APawn_async_path, APawn_path

class UPawnMovementComponent_members(UMovementComponent_members):
    """Functions and variables of UPawnMovementComponent."""
    def AddInputVector(self, WorldVector: FVector_in, bForce: bool | Future[bool] = False) -> None:
        """Adds the given vector to the accumulated input in world space. Input vectors are usually between 0 and 1 in
        magnitude.

        Unreal: UPawnMovementComponent.AddInputVector
        """
    def ConsumeInputVector(self) -> FVector:
        """Returns the pending input vector and resets it to zero.

        Unreal: UPawnMovementComponent.ConsumeInputVector
        """
    def GetLastInputVector(self) -> FVector:
        """Return the last input vector in world space that was processed by ConsumeInputVector().

        Unreal: UPawnMovementComponent.GetLastInputVector
        """
    def GetPawnOwner(self) -> APawn | None:
        """Return the Pawn that owns UpdatedComponent.

        Unreal: UPawnMovementComponent.GetPawnOwner
        """
    def GetPendingInputVector(self) -> FVector:
        """Return the pending input vector in world space. This is the most up-to-date value before it is consumed.

        Unreal: UPawnMovementComponent.GetPendingInputVector
        """
    def IsMoveInputIgnored(self) -> bool:
        """Helper to see if move input is ignored. If there is no Pawn or UpdatedComponent, returns true, otherwise
        defers to the Pawn's implementation of IsMoveInputIgnored().

        Unreal: UPawnMovementComponent.IsMoveInputIgnored
        """
    PawnOwner: Property[APawn_path, APawn | Future[APawn] | None]
    """Pawn that owns this component.

    Unreal: UPawnMovementComponent.PawnOwner (APawn*)
    """

class UPawnMovementComponent_async(UMovementComponent_async):
    """UPawnMovementComponent under ``async_``: each function gives a future."""
    def AddInputVector(self, WorldVector: FVector_in, bForce: bool | Future[bool] = False) -> Future[None]:
        """Adds the given vector to the accumulated input in world space."""
    def ConsumeInputVector(self) -> Future[FVector]:
        """Returns the pending input vector and resets it to zero."""
    def GetLastInputVector(self) -> Future[FVector]:
        """Return the last input vector in world space that was processed by ConsumeInputVector()."""
    def GetPawnOwner(self) -> Future[APawn | None]:
        """Return the Pawn that owns UpdatedComponent."""
    def GetPendingInputVector(self) -> Future[FVector]:
        """Return the pending input vector in world space."""
    def IsMoveInputIgnored(self) -> Future[bool]:
        """Helper to see if move input is ignored."""
    PawnOwner: Property[APawn_async_path, APawn | Future[APawn] | None]
    """Pawn that owns this component."""

class UPawnMovementComponent_send(UMovementComponent_send):
    """UPawnMovementComponent under ``send_``: no function answers."""
    def AddInputVector(self, WorldVector: FVector_in, bForce: bool | Future[bool] = False) -> None:
        """Adds the given vector to the accumulated input in world space."""
    def ConsumeInputVector(self) -> None:
        """Returns the pending input vector and resets it to zero."""
    def GetLastInputVector(self) -> None:
        """Return the last input vector in world space that was processed by ConsumeInputVector()."""
    def GetPawnOwner(self) -> None:
        """Return the Pawn that owns UpdatedComponent."""
    def GetPendingInputVector(self) -> None:
        """Return the pending input vector in world space."""
    def IsMoveInputIgnored(self) -> None:
        """Helper to see if move input is ignored."""
    PawnOwner: SendProperty[APawn | Future[APawn] | None]

class UPawnMovementComponent(UPawnMovementComponent_members, UMovementComponent):
    """PawnMovementComponent can be used to update movement for an associated Pawn. It also provides ways to
    accumulate and read directional input in a generic way.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/UPawnMovementComponent

    Unreal: /Script/Engine.PawnMovementComponent
    """
    @property
    def async_(self) -> UPawnMovementComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UPawnMovementComponent_send:
        """The same functions and variables, fire-and-forget."""

class UPawnMovementComponent_path(ObjectPath[UPawnMovementComponent, UPawnMovementComponent_async_path, UPawnMovementComponent_send], UPawnMovementComponent_members):
    """A variable that refers to an object of UPawnMovementComponent: its path."""

class UPawnMovementComponent_async_path(AsyncObjectPath[UPawnMovementComponent], UPawnMovementComponent_async):
    """The same under ``async_``."""
