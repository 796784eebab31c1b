# generated, do not edit (Engine: Public/GameFramework/PlayerStart.h)
from spear.typing import AsyncObjectPath, AsyncStrProperty, Future, ObjectPath, Property, SendProperty, SendStrProperty, StrProperty
from ._Actor import AActor, AActor_async, AActor_members, AActor_send
from ._CapsuleComponent import UCapsuleComponent, UCapsuleComponent_async_path, UCapsuleComponent_path

class APlayerStart_members(AActor_members):
    """Functions and variables of APlayerStart."""
    PlayerStartTag: StrProperty
    """Used when searching for which playerstart to use.

    Unreal: APlayerStart.PlayerStartTag (FName)
    """
    CapsuleComponent: Property[UCapsuleComponent_path, UCapsuleComponent | Future[UCapsuleComponent] | None]
    """Capsule of the size of the player, centred on the start location.

    Unreal: APlayerStart.CapsuleComponent (UCapsuleComponent*)
    """

class APlayerStart_async(AActor_async):
    """APlayerStart under ``async_``: each function gives a future."""
    PlayerStartTag: AsyncStrProperty
    """Used when searching for which playerstart to use."""
    CapsuleComponent: Property[UCapsuleComponent_async_path, UCapsuleComponent | Future[UCapsuleComponent] | None]
    """Capsule of the size of the player, centred on the start location."""

class APlayerStart_send(AActor_send):
    """APlayerStart under ``send_``: no function answers."""
    PlayerStartTag: SendStrProperty
    CapsuleComponent: SendProperty[UCapsuleComponent | Future[UCapsuleComponent] | None]

class APlayerStart(APlayerStart_members, AActor):
    """This class indicates a location where a player can spawn when the game begins.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/APlayerStart

    Unreal: /Script/Engine.PlayerStart
    """
    @property
    def async_(self) -> APlayerStart_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> APlayerStart_send:
        """The same functions and variables, fire-and-forget."""

class APlayerStart_path(ObjectPath[APlayerStart, APlayerStart_async_path, APlayerStart_send], APlayerStart_members):
    """A variable that refers to an object of APlayerStart: its path."""

class APlayerStart_async_path(AsyncObjectPath[APlayerStart], APlayerStart_async):
    """The same under ``async_``."""
