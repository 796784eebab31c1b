# generated, do not edit (Engine: Public/GameFramework/WorldSettings.h)
from spear.typing import AsyncClassPath, AsyncObjectPath, AsyncPath, ClassPath, Future, ObjectPath, Path, Property, SendProperty
from ..CoreUObject._Intrinsic import UClass
from ._GameModeBase import AGameModeBase
from ._Info import AInfo, AInfo_async, AInfo_members, AInfo_send
from ._PlayerState import APlayerState, APlayerState_async_path, APlayerState_path

class AWorldSettings_members(AInfo_members):
    """Functions and variables of AWorldSettings."""
    bGlobalGravitySet: Property[Path[bool], bool | Future[bool]]
    """If true, GlobalGravityZ is used; otherwise the default gravity, -980 cm/s^2.

    Unreal: AWorldSettings.bGlobalGravitySet (bool)
    """
    bEnableWorldBoundsChecks: Property[Path[bool], bool | Future[bool]]
    """If true, enables KillZ checks: actors that fall below it are destroyed.

    Unreal: AWorldSettings.bEnableWorldBoundsChecks (bool)
    """
    bWorldGravitySet: Property[Path[bool], bool | Future[bool]]
    """If true, WorldGravityZ has been set and is used as it is.

    Unreal: AWorldSettings.bWorldGravitySet (bool)
    """
    KillZ: Property[Path[float], float | Future[float]]
    """Any actor falling below this level gets destroyed, in centimetres. Checked for actors that move by a movement
    component.

    Unreal: AWorldSettings.KillZ (float)
    """
    WorldGravityZ: Property[Path[float], float | Future[float]]
    """Current gravity actually being used, in centimetres per second squared, see GetGravityZ.

    Unreal: AWorldSettings.WorldGravityZ (float)
    """
    GlobalGravityZ: Property[Path[float], float | Future[float]]
    """Level specific gravity value used if bGlobalGravitySet, in centimetres per second squared.

    Unreal: AWorldSettings.GlobalGravityZ (float)
    """
    DefaultGameMode: Property[ClassPath[UClass, type[AGameModeBase] | UClass | str | Future[UClass] | None], type[AGameModeBase] | UClass | str | Future[UClass] | None]
    """The default GameMode to use when starting this map in the game. If this value is NULL, the INI setting for
    default game type is used.

    Unreal: AWorldSettings.DefaultGameMode (TSubclassOf<AGameModeBase>)
    """
    TimeDilation: Property[Path[float], float | Future[float]]
    """Normally 1 - scales real time passage. Warning - most use cases should use GetEffectiveTimeDilation() instead
    of reading from this directly.

    Unreal: AWorldSettings.TimeDilation (float)
    """
    CinematicTimeDilation: Property[Path[float], float | Future[float]]
    """Additional TimeDilation used to control demo playback speed.

    Unreal: AWorldSettings.CinematicTimeDilation (float)
    """
    MinGlobalTimeDilation: Property[Path[float], float | Future[float]]
    """Lowest acceptable global time dilation.

    at least 0

    Unreal: AWorldSettings.MinGlobalTimeDilation (float)
    """
    MaxGlobalTimeDilation: Property[Path[float], float | Future[float]]
    """Highest acceptable global time dilation.

    at least 0

    Unreal: AWorldSettings.MaxGlobalTimeDilation (float)
    """
    MinUndilatedFrameTime: Property[Path[float], float | Future[float]]
    """Smallest possible frametime, not considering dilation. Equiv to 1/FastestFPS. Seconds.

    at least 0

    Unreal: AWorldSettings.MinUndilatedFrameTime (float)
    """
    MaxUndilatedFrameTime: Property[Path[float], float | Future[float]]
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
    bGlobalGravitySet: Property[AsyncPath[bool], bool | Future[bool]]
    """If true, GlobalGravityZ is used; otherwise the default gravity, -980 cm/s^2."""
    bEnableWorldBoundsChecks: Property[AsyncPath[bool], bool | Future[bool]]
    """If true, enables KillZ checks: actors that fall below it are destroyed."""
    bWorldGravitySet: Property[AsyncPath[bool], bool | Future[bool]]
    """If true, WorldGravityZ has been set and is used as it is."""
    KillZ: Property[AsyncPath[float], float | Future[float]]
    """Any actor falling below this level gets destroyed, in centimetres."""
    WorldGravityZ: Property[AsyncPath[float], float | Future[float]]
    """Current gravity actually being used, in centimetres per second squared, see GetGravityZ."""
    GlobalGravityZ: Property[AsyncPath[float], float | Future[float]]
    """Level specific gravity value used if bGlobalGravitySet, in centimetres per second squared."""
    DefaultGameMode: Property[AsyncClassPath[UClass, type[AGameModeBase] | UClass | str | Future[UClass] | None], type[AGameModeBase] | UClass | str | Future[UClass] | None]
    """The default GameMode to use when starting this map in the game."""
    TimeDilation: Property[AsyncPath[float], float | Future[float]]
    """Normally 1 - scales real time passage."""
    CinematicTimeDilation: Property[AsyncPath[float], float | Future[float]]
    """Additional TimeDilation used to control demo playback speed."""
    MinGlobalTimeDilation: Property[AsyncPath[float], float | Future[float]]
    """Lowest acceptable global time dilation."""
    MaxGlobalTimeDilation: Property[AsyncPath[float], float | Future[float]]
    """Highest acceptable global time dilation."""
    MinUndilatedFrameTime: Property[AsyncPath[float], float | Future[float]]
    """Smallest possible frametime, not considering dilation."""
    MaxUndilatedFrameTime: Property[AsyncPath[float], float | Future[float]]
    """Largest possible frametime, not considering dilation."""
    PauserPlayerState: Property[APlayerState_async_path, APlayerState | Future[APlayerState] | None]
    """If paused, PlayerState of person pausing the game."""

class AWorldSettings_send(AInfo_send):
    """AWorldSettings under ``send_``: no function answers."""
    bGlobalGravitySet: SendProperty[bool | Future[bool]]
    bEnableWorldBoundsChecks: SendProperty[bool | Future[bool]]
    bWorldGravitySet: SendProperty[bool | Future[bool]]
    KillZ: SendProperty[float | Future[float]]
    WorldGravityZ: SendProperty[float | Future[float]]
    GlobalGravityZ: SendProperty[float | Future[float]]
    DefaultGameMode: SendProperty[type[AGameModeBase] | UClass | str | Future[UClass] | None]
    TimeDilation: SendProperty[float | Future[float]]
    CinematicTimeDilation: SendProperty[float | Future[float]]
    MinGlobalTimeDilation: SendProperty[float | Future[float]]
    MaxGlobalTimeDilation: SendProperty[float | Future[float]]
    MinUndilatedFrameTime: SendProperty[float | Future[float]]
    MaxUndilatedFrameTime: SendProperty[float | Future[float]]
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
