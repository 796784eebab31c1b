# generated, do not edit (SpearServer: Private/Reflection/SpearLatentReceiver.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send

class USpearLatentReceiver_members(UObject_members):
    """Functions and variables of USpearLatentReceiver."""
    def OnLatentCompleted(self, Linkage: int | Future[int]) -> None:
        """Called by the engine when a latent function has completed; Linkage is the number of the call.

        Unreal: USpearLatentReceiver.OnLatentCompleted
        """

class USpearLatentReceiver_async(UObject_async):
    """USpearLatentReceiver under ``async_``: each function gives a future."""
    def OnLatentCompleted(self, Linkage: int | Future[int]) -> Future[None]:
        """Called by the engine when a latent function has completed; Linkage is the number of the call."""

class USpearLatentReceiver_send(UObject_send):
    """USpearLatentReceiver under ``send_``: no function answers."""
    def OnLatentCompleted(self, Linkage: int | Future[int]) -> None:
        """Called by the engine when a latent function has completed; Linkage is the number of the call."""

class USpearLatentReceiver(USpearLatentReceiver_members, UObject):
    """Receives the completion of latent functions that clients have called (FLatentActionInfo::CallbackTarget).

    Unreal: /Script/SpearServer.SpearLatentReceiver
    """
    @property
    def async_(self) -> USpearLatentReceiver_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> USpearLatentReceiver_send:
        """The same functions and variables, fire-and-forget."""

class USpearLatentReceiver_path(ObjectPath[USpearLatentReceiver, USpearLatentReceiver_async_path, USpearLatentReceiver_send], USpearLatentReceiver_members):
    """A variable that refers to an object of USpearLatentReceiver: its path."""

class USpearLatentReceiver_async_path(AsyncObjectPath[USpearLatentReceiver], USpearLatentReceiver_async):
    """The same under ``async_``."""
