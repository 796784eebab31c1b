# generated, do not edit (Engine: Public/Engine/Engine.h)
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import (
    AsyncClassPath, AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, ClassPath, FloatProperty, Future, ObjectPath, Property, SendFloatProperty,
    SendProperty, StructPath,
)
from ..CoreUObject._Intrinsic import UClass
from ..CoreUObject._NoExportTypes import FLinearColor_async, FLinearColor_in, FLinearColor_path, UObject, UObject_async, UObject_members, UObject_send
from ._EngineBaseTypes import FURL, FURL_async, FURL_in, FURL_path
from ._GameInstance import UGameInstance, UGameInstance_async_path, UGameInstance_path
from ._GameModeBase import AGameModeBase
from ._GameViewportClient import UGameViewportClient, UGameViewportClient_async_path, UGameViewportClient_path
from ._LocalPlayer import ULocalPlayer
from ._World import UWorld, UWorld_async_path, UWorld_path
from ._WorldSettings import AWorldSettings

class FWorldContext(Struct):
    """A context for dealing with UWorlds at the engine level. As the engine brings up and destroys world, we need a
    way to keep straight what world belongs to what.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FWorldContext

    Unreal: /Script/Engine.WorldContext
    """
    def __init__(self, LastURL: FURL = ..., GameViewport: UGameViewportClient | None = ..., OwningGameInstance: UGameInstance | None = ..., ThisCurrentWorld: UWorld | None = ...) -> None: ...
    LastURL: FURL
    """URL the last time we traveled."""
    GameViewport: UGameViewportClient | None
    """The viewport of the game."""
    OwningGameInstance: UGameInstance | None
    """The game instance that owns this context."""
    ThisCurrentWorld: UWorld | None

class FWorldContext_dict(TypedDict, total=False):
    """Any of the fields of FWorldContext: what a dictionary for it may hold."""
    LastURL: FURL_in
    GameViewport: UGameViewportClient | Future[UGameViewportClient] | None
    OwningGameInstance: UGameInstance | Future[UGameInstance] | None
    ThisCurrentWorld: UWorld | Future[UWorld] | None

FWorldContext_in: TypeAlias = FWorldContext | FWorldContext_dict | Future[FWorldContext]
"""What stands for FWorldContext as an argument: itself, a dictionary of its fields, a future."""

class FWorldContext_path(StructPath[FWorldContext, FWorldContext_in, FWorldContext_async]):
    """A variable of type FWorldContext: its path."""
    LastURL: Property[FURL_path, FURL_in]
    """URL the last time we traveled."""
    GameViewport: Property[UGameViewportClient_path, UGameViewportClient | Future[UGameViewportClient] | None]
    """The viewport of the game."""
    OwningGameInstance: Property[UGameInstance_path, UGameInstance | Future[UGameInstance] | None]
    """The game instance that owns this context."""
    ThisCurrentWorld: Property[UWorld_path, UWorld | Future[UWorld] | None]

class FWorldContext_async(AsyncValuePath[FWorldContext, FWorldContext_in]):
    """The same under ``async_``."""
    LastURL: Property[FURL_async, FURL_in]
    GameViewport: Property[UGameViewportClient_async_path, UGameViewportClient | Future[UGameViewportClient] | None]
    OwningGameInstance: Property[UGameInstance_async_path, UGameInstance | Future[UGameInstance] | None]
    ThisCurrentWorld: Property[UWorld_async_path, UWorld | Future[UWorld] | None]

class UEngine_members(UObject_members):
    """Functions and variables of UEngine."""
    LocalPlayerClass: Property[ClassPath[UClass, type[ULocalPlayer] | UClass | str | Future[UClass] | None], type[ULocalPlayer] | UClass | str | Future[UClass] | None]
    """Class used for the local player.

    Unreal: UEngine.LocalPlayerClass (TSubclassOf<ULocalPlayer>)
    """
    WorldSettingsClass: Property[ClassPath[UClass, type[AWorldSettings] | UClass | str | Future[UClass] | None], type[AWorldSettings] | UClass | str | Future[UClass] | None]
    """Class of the world settings.

    Unreal: UEngine.WorldSettingsClass (TSubclassOf<AWorldSettings>)
    """
    GameViewportClientClass: Property[ClassPath[UClass, type[UGameViewportClient] | UClass | str | Future[UClass] | None], type[UGameViewportClient] | UClass | str | Future[UClass] | None]
    """Class of the game's viewport.

    Unreal: UEngine.GameViewportClientClass (TSubclassOf<UGameViewportClient>)
    """
    GameInstanceClass: Property[ClassPath[UClass, type[UGameInstance] | UClass | str | Future[UClass] | None], type[UGameInstance] | UClass | str | Future[UClass] | None]
    """Class of the game instance.

    Unreal: UEngine.GameInstanceClass (TSubclassOf<UGameInstance>)
    """
    DefaultGameModeClass: Property[ClassPath[UClass, type[AGameModeBase] | UClass | str | Future[UClass] | None], type[AGameModeBase] | UClass | str | Future[UClass] | None]
    """The game mode of maps that name none.

    Unreal: UEngine.DefaultGameModeClass (TSubclassOf<AGameModeBase>)
    """
    GameViewport: Property[UGameViewportClient_path, UGameViewportClient | Future[UGameViewportClient] | None]
    """The viewport of the game; there may be none.

    Unreal: UEngine.GameViewport (UGameViewportClient*)
    """
    LightingOnlyBrightness: Property[FLinearColor_path, FLinearColor_in]
    """Colour of "lighting only" views.

    Unreal: UEngine.LightingOnlyBrightness (FLinearColor)
    """
    TimeSinceLastPendingKillPurge: FloatProperty
    """When we last did a full garbage collection, in seconds of the engine's clock.

    Unreal: UEngine.TimeSinceLastPendingKillPurge (float)
    """

class UEngine_async(UObject_async):
    """UEngine under ``async_``: each function gives a future."""
    LocalPlayerClass: Property[AsyncClassPath[UClass, type[ULocalPlayer] | UClass | str | Future[UClass] | None], type[ULocalPlayer] | UClass | str | Future[UClass] | None]
    """Class used for the local player."""
    WorldSettingsClass: Property[AsyncClassPath[UClass, type[AWorldSettings] | UClass | str | Future[UClass] | None], type[AWorldSettings] | UClass | str | Future[UClass] | None]
    """Class of the world settings."""
    GameViewportClientClass: Property[AsyncClassPath[UClass, type[UGameViewportClient] | UClass | str | Future[UClass] | None], type[UGameViewportClient] | UClass | str | Future[UClass] | None]
    """Class of the game's viewport."""
    GameInstanceClass: Property[AsyncClassPath[UClass, type[UGameInstance] | UClass | str | Future[UClass] | None], type[UGameInstance] | UClass | str | Future[UClass] | None]
    """Class of the game instance."""
    DefaultGameModeClass: Property[AsyncClassPath[UClass, type[AGameModeBase] | UClass | str | Future[UClass] | None], type[AGameModeBase] | UClass | str | Future[UClass] | None]
    """The game mode of maps that name none."""
    GameViewport: Property[UGameViewportClient_async_path, UGameViewportClient | Future[UGameViewportClient] | None]
    """The viewport of the game; there may be none."""
    LightingOnlyBrightness: Property[FLinearColor_async, FLinearColor_in]
    """Colour of "lighting only" views."""
    TimeSinceLastPendingKillPurge: AsyncFloatProperty
    """When we last did a full garbage collection, in seconds of the engine's clock."""

class UEngine_send(UObject_send):
    """UEngine under ``send_``: no function answers."""
    LocalPlayerClass: SendProperty[type[ULocalPlayer] | UClass | str | Future[UClass] | None]
    WorldSettingsClass: SendProperty[type[AWorldSettings] | UClass | str | Future[UClass] | None]
    GameViewportClientClass: SendProperty[type[UGameViewportClient] | UClass | str | Future[UClass] | None]
    GameInstanceClass: SendProperty[type[UGameInstance] | UClass | str | Future[UClass] | None]
    DefaultGameModeClass: SendProperty[type[AGameModeBase] | UClass | str | Future[UClass] | None]
    GameViewport: SendProperty[UGameViewportClient | Future[UGameViewportClient] | None]
    LightingOnlyBrightness: SendProperty[FLinearColor_in]
    TimeSinceLastPendingKillPurge: SendFloatProperty

class UEngine(UEngine_members, UObject):
    """Abstract base class of all Engine classes, responsible for management of systems critical to editor or game
    systems. Also defines default classes for certain engine systems.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UEngine

    Unreal: /Script/Engine.Engine
    """
    @property
    def async_(self) -> UEngine_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UEngine_send:
        """The same functions and variables, fire-and-forget."""

class UEngine_path(ObjectPath[UEngine, UEngine_async_path, UEngine_send], UEngine_members):
    """A variable that refers to an object of UEngine: its path."""

class UEngine_async_path(AsyncObjectPath[UEngine], UEngine_async):
    """The same under ``async_``."""
