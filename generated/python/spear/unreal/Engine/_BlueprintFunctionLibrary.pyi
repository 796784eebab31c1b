# generated, do not edit (Engine: Public/Kismet/BlueprintFunctionLibrary.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send

class UBlueprintFunctionLibrary_members(UObject_members):
    """Functions and variables of UBlueprintFunctionLibrary."""

class UBlueprintFunctionLibrary_async(UObject_async):
    """UBlueprintFunctionLibrary under ``async_``: each function gives a future."""

class UBlueprintFunctionLibrary_send(UObject_send):
    """UBlueprintFunctionLibrary under ``send_``: no function answers."""

class UBlueprintFunctionLibrary(UBlueprintFunctionLibrary_members, UObject):
    """Base of the classes that hold static functions for scripts and remote programs. Epic page:
    UBlueprintFunctionLibrary.

    Unreal: /Script/Engine.BlueprintFunctionLibrary
    """
    @property
    def async_(self) -> UBlueprintFunctionLibrary_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UBlueprintFunctionLibrary_send:
        """The same functions and variables, fire-and-forget."""

class UBlueprintFunctionLibrary_path(ObjectPath[UBlueprintFunctionLibrary, UBlueprintFunctionLibrary_async_path, UBlueprintFunctionLibrary_send], UBlueprintFunctionLibrary_members):
    """A variable that refers to an object of UBlueprintFunctionLibrary: its path."""

class UBlueprintFunctionLibrary_async_path(AsyncObjectPath[UBlueprintFunctionLibrary], UBlueprintFunctionLibrary_async):
    """The same under ``async_``."""
