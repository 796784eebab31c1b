# generated, do not edit (Engine: Public/GameFramework/WorldSettings.h)
from spear.typing import (
    AsyncBoolProperty, AsyncClassPath, AsyncFloatProperty, AsyncObjectPath, BoolProperty, ClassPath, FloatProperty, Future, ObjectPath, Property,
    SendBoolProperty, SendFloatProperty, SendProperty,
)
from ..CoreUObject._Intrinsic import UClass
from ._GameModeBase import AGameModeBase
from ._Info import AInfo, AInfo_async, AInfo_members, AInfo_send
from ._PlayerState import APlayerState, APlayerState_async_path, APlayerState_path

class AWorldSettings_members(AInfo_members):
    """Functions and variables of AWorldSettings."""
    bGlobalGravitySet: BoolProperty
    """If true, GlobalGravityZ is used; otherwise the default gravity, -980 cm/s^2.

    Unreal: AWorldSettings.bGlobalGravitySet (bool)
    """
    bEnableWorldBoundsChecks: BoolProperty
    """If true, enables KillZ checks: actors that fall below it are destroyed.

    Unreal: AWorldSettings.bEnableWorldBoundsChecks (bool)
    """
    bWorldGravitySet: BoolProperty
    """If true, WorldGravityZ has been set and is used as it is.

    Unreal: AWorldSettings.bWorldGravitySet (bool)
    """
    KillZ: FloatProperty
    """Any actor falling below this level gets destroyed, in centimetres. Checked for actors that move by a movement
    component.

    Unreal: AWorldSettings.KillZ (float)
    """
    WorldGravityZ: FloatProperty
    """Current gravity actually being used, in centimetres per second squared, see GetGravityZ.

    Unreal: AWorldSettings.WorldGravityZ (float)
    """
    GlobalGravityZ: FloatProperty
    """Level specific gravity value used if bGlobalGravitySet, in centimetres per second squared.

    Unreal: AWorldSettings.GlobalGravityZ (float)
    """
    DefaultGameMode: Property[ClassPath[UClass, type[AGameModeBase] | UClass | str | Future[UClass] | None], type[AGameModeBase] | UClass | str | Future[UClass] | None]
    """The default GameMode to use when starting this map in the game. If this value is NULL, the INI setting for
    default game type is used.

    Unreal: AWorldSettings.DefaultGameMode (TSubclassOf<AGameModeBase>)
    """
    TimeDilation: FloatProperty
    """Normally 1 - scales real time passage. Warning - most use cases should use GetEffectiveTimeDilation() instead
    of reading from this directly.

    Unreal: AWorldSettings.TimeDilation (float)
    """
    CinematicTimeDilation: FloatProperty
    """Additional TimeDilation used to control demo playback speed.

    Unreal: AWorldSettings.CinematicTimeDilation (float)
    """
    MinGlobalTimeDilation: FloatProperty
    """Lowest acceptable global time dilation.

    at least 0

    Unreal: AWorldSettings.MinGlobalTimeDilation (float)
    """
    MaxGlobalTimeDilation: FloatProperty
    """Highest acceptable global time dilation.

    at least 0

    Unreal: AWorldSettings.MaxGlobalTimeDilation (float)
    """
    MinUndilatedFrameTime: FloatProperty
    """Smallest possible frametime, not considering dilation. Equiv to 1/FastestFPS. Seconds.

    at least 0

    Unreal: AWorldSettings.MinUndilatedFrameTime (float)
    """
    MaxUndilatedFrameTime: FloatProperty
    """Largest possible frametime, not considering dilation. Equiv to 1/SlowestFPS. Seconds.

    at least 0

    Unreal: AWorldSettings.MaxUndilatedFrameTime (float)
    """
    PauserPlayerState: Property[APlayerState_path, APlayerState | Future[APlayerState] | None]
    """If paused, PlayerState of person pausing the game.

    Unreal: AWorldSettings.PauserPlayerState (APlayerState*)
    """

class AWorldSettings_async(AInfo_async):
    """AWorldSettings under ``async_``: each function gives a future."""
    bGlobalGravitySet: AsyncBoolProperty
    """If true, GlobalGravityZ is used; otherwise the default gravity, -980 cm/s^2."""
    bEnableWorldBoundsChecks: AsyncBoolProperty
    """If true, enables KillZ checks: actors that fall below it are destroyed."""
    bWorldGravitySet: AsyncBoolProperty
    """If true, WorldGravityZ has been set and is used as it is."""
    KillZ: AsyncFloatProperty
    """Any actor falling below this level gets destroyed, in centimetres."""
    WorldGravityZ: AsyncFloatProperty
    """Current gravity actually being used, in centimetres per second squared, see GetGravityZ."""
    GlobalGravityZ: AsyncFloatProperty
    """Level specific gravity value used if bGlobalGravitySet, in centimetres per second squared."""
    DefaultGameMode: Property[AsyncClassPath[UClass, type[AGameModeBase] | UClass | str | Future[UClass] | None], type[AGameModeBase] | UClass | str | Future[UClass] | None]
    """The default GameMode to use when starting this map in the game."""
    TimeDilation: AsyncFloatProperty
    """Normally 1 - scales real time passage."""
    CinematicTimeDilation: AsyncFloatProperty
    """Additional TimeDilation used to control demo playback speed."""
    MinGlobalTimeDilation: AsyncFloatProperty
    """Lowest acceptable global time dilation."""
    MaxGlobalTimeDilation: AsyncFloatProperty
    """Highest acceptable global time dilation."""
    MinUndilatedFrameTime: AsyncFloatProperty
    """Smallest possible frametime, not considering dilation."""
    MaxUndilatedFrameTime: AsyncFloatProperty
    """Largest possible frametime, not considering dilation."""
    PauserPlayerState: Property[APlayerState_async_path, APlayerState | Future[APlayerState] | None]
    """If paused, PlayerState of person pausing the game."""

class AWorldSettings_send(AInfo_send):
    """AWorldSettings under ``send_``: no function answers."""
    bGlobalGravitySet: SendBoolProperty
    bEnableWorldBoundsChecks: SendBoolProperty
    bWorldGravitySet: SendBoolProperty
    KillZ: SendFloatProperty
    WorldGravityZ: SendFloatProperty
    GlobalGravityZ: SendFloatProperty
    DefaultGameMode: SendProperty[type[AGameModeBase] | UClass | str | Future[UClass] | None]
    TimeDilation: SendFloatProperty
    CinematicTimeDilation: SendFloatProperty
    MinGlobalTimeDilation: SendFloatProperty
    MaxGlobalTimeDilation: SendFloatProperty
    MinUndilatedFrameTime: SendFloatProperty
    MaxUndilatedFrameTime: SendFloatProperty
    PauserPlayerState: SendProperty[APlayerState | Future[APlayerState] | None]

class AWorldSettings(AWorldSettings_members, AInfo):
    """Actor containing all script accessible world properties.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AWorldSettings

    Unreal: /Script/Engine.WorldSettings
    """
    @property
    def async_(self) -> AWorldSettings_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> AWorldSettings_send:
        """The same functions and variables, fire-and-forget."""

class AWorldSettings_path(ObjectPath[AWorldSettings, AWorldSettings_async_path, AWorldSettings_send], AWorldSettings_members):
    """A variable that refers to an object of AWorldSettings: its path."""

class AWorldSettings_async_path(AsyncObjectPath[AWorldSettings], AWorldSettings_async):
    """The same under ``async_``."""
