# generated, do not edit (Engine: Public/Engine/Texture2D.h)
from spear.typing import AsyncObjectPath, AsyncValuePath, Future, ObjectPath, Property, SendProperty, ValuePath
from ._Texture import UTexture, UTexture_async, UTexture_members, UTexture_send
from ._TextureDefines import TextureAddress, TextureAddress_in

class UTexture2D_members(UTexture_members):
    """Functions and variables of UTexture2D."""
    def Blueprint_GetSizeX(self) -> int:
        """Width in texels, for Blueprint.

        Unreal: UTexture2D.Blueprint_GetSizeX
        """
    def Blueprint_GetSizeY(self) -> int:
        """Height in texels, for Blueprint.

        Unreal: UTexture2D.Blueprint_GetSizeY
        """
    AddressX: Property[ValuePath[TextureAddress, TextureAddress_in], TextureAddress_in]
    """What U outside 0..1 means.

    Unreal: UTexture2D.AddressX (TEnumAsByte<TextureAddress>)
    """
    AddressY: Property[ValuePath[TextureAddress, TextureAddress_in], TextureAddress_in]
    """What V outside 0..1 means.

    Unreal: UTexture2D.AddressY (TEnumAsByte<TextureAddress>)
    """

class UTexture2D_async(UTexture_async):
    """UTexture2D under ``async_``: each function gives a future."""
    def Blueprint_GetSizeX(self) -> Future[int]:
        """Width in texels, for Blueprint."""
    def Blueprint_GetSizeY(self) -> Future[int]:
        """Height in texels, for Blueprint."""
    AddressX: Property[AsyncValuePath[TextureAddress, TextureAddress_in], TextureAddress_in]
    """What U outside 0..1 means."""
    AddressY: Property[AsyncValuePath[TextureAddress, TextureAddress_in], TextureAddress_in]
    """What V outside 0..1 means."""

class UTexture2D_send(UTexture_send):
    """UTexture2D under ``send_``: no function answers."""
    def Blueprint_GetSizeX(self) -> None:
        """Width in texels, for Blueprint."""
    def Blueprint_GetSizeY(self) -> None:
        """Height in texels, for Blueprint."""
    AddressX: SendProperty[TextureAddress_in]
    AddressY: SendProperty[TextureAddress_in]

class UTexture2D(UTexture2D_members, UTexture):
    """A two-dimensional image whose pixels are in main memory (UE: UTexture2D, Engine/Texture2D.h).

    Unreal: /Script/Engine.Texture2D
    """
    @property
    def async_(self) -> UTexture2D_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UTexture2D_send:
        """The same functions and variables, fire-and-forget."""

class UTexture2D_path(ObjectPath[UTexture2D, UTexture2D_async_path, UTexture2D_send], UTexture2D_members):
    """A variable that refers to an object of UTexture2D: its path."""

class UTexture2D_async_path(AsyncObjectPath[UTexture2D], UTexture2D_async):
    """The same under ``async_``."""
