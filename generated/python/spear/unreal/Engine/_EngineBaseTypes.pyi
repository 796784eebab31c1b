# generated, do not edit (Engine: Public/Engine/EngineBaseTypes.h)
from collections.abc import Sequence
from typing import TypeAlias, TypedDict
from spear.enums import UnrealEnum
from spear.structs import Struct
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncFloatProperty, AsyncIntProperty, AsyncPath, AsyncStrProperty, AsyncValuePath, BoolProperty,
    FloatProperty, Future, IntProperty, Path, Property, StrProperty, StructPath, ValuePath,
)

class ETickingGroup(UnrealEnum):
    """Determines which ticking group a tick function belongs to. Groups run in this order, each to its end, once per
    frame.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/ETickingGroup

    Unreal: /Script/Engine.ETickingGroup
    """
    TG_PrePhysics = 0
    """Any item that needs to be executed before physics simulation starts."""
    TG_StartPhysics = 1
    """Special tick group that starts physics simulation."""
    TG_DuringPhysics = 2
    """Any item that can be run in parallel with our physics simulation work."""
    TG_EndPhysics = 3
    """Special tick group that ends physics simulation."""
    TG_PostPhysics = 4
    """Any item that needs rigid body and cloth simulation to be complete before being executed."""
    TG_PostUpdateWork = 5
    """Any item that needs the update work to be done before being ticked."""
    TG_LastDemotable = 6
    """Catchall for anything demoted to the end."""
    TG_NewlySpawned = 7
    """Special tick group that is not actually a tick group. After every tick group this is repeatedly re-run until
    there are no more newly spawned items to run.
    """
    TG_MAX = 8

ETickingGroup_in: TypeAlias = ETickingGroup | str | Future[ETickingGroup]
"""What stands for ETickingGroup as an argument: an entry, the name that Unreal gives it, a future."""

class ETravelType(UnrealEnum):
    """Travel from server to server.

    Unreal: /Script/Engine.ETravelType
    """
    TRAVEL_Absolute = 0
    """Absolute URL."""
    TRAVEL_Partial = 1
    """Partial (carry name, reset server)."""
    TRAVEL_Relative = 2
    """Relative URL."""
    TRAVEL_MAX = 3

ETravelType_in: TypeAlias = ETravelType | str | Future[ETravelType]
"""What stands for ETravelType as an argument: an entry, the name that Unreal gives it, a future."""

class FTickFunction(Struct):
    """Abstract base of all tick functions: a callback that the world runs once per frame (or per TickInterval) in a
    tick group.

    The order is deterministic. A function starts in the later of its TickGroup and the groups of its
    prerequisites; inside a group the prerequisites run first, then high-priority functions, then the others, each
    in the order of registration. Functions registered during a frame run in that frame if their group has not
    passed, else at the end of the current group.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FTickFunction

    Unreal: /Script/Engine.TickFunction
    """
    def __init__(self, TickGroup: ETickingGroup = ..., EndTickGroup: ETickingGroup = ..., bTickEvenWhenPaused: bool = ..., bCanEverTick: bool = ..., bStartWithTickEnabled: bool = ..., bAllowTickOnDedicatedServer: bool = ..., TickInterval: float = ...) -> None: ...
    TickGroup: ETickingGroup
    """Defines the minimum tick group for this tick function. These groups determine the relative order of when
    objects tick during a frame update.
    """
    EndTickGroup: ETickingGroup
    """Defines the tick group that this tick function must finish in. These groups determine the relative order of
    when objects tick during a frame update.
    """
    bTickEvenWhenPaused: bool
    """Bool indicating that this function should execute even if the game is paused. Pause ticks are very limited in
    capabilities.
    """
    bCanEverTick: bool
    """If false, this tick function will never be registered and will never tick. Only settable in defaults."""
    bStartWithTickEnabled: bool
    """If true, this tick function will start enabled, but can be disabled later on."""
    bAllowTickOnDedicatedServer: bool
    """If we allow this tick to run on a dedicated server."""
    TickInterval: float
    """The frequency in seconds at which this tick function will be executed. If less than or equal to 0 then it will
    tick every frame.
    """

class FTickFunction_dict(TypedDict, total=False):
    """Any of the fields of FTickFunction: what a dictionary for it may hold."""
    TickGroup: ETickingGroup_in
    EndTickGroup: ETickingGroup_in
    bTickEvenWhenPaused: bool | Future[bool]
    bCanEverTick: bool | Future[bool]
    bStartWithTickEnabled: bool | Future[bool]
    bAllowTickOnDedicatedServer: bool | Future[bool]
    TickInterval: float | Future[float]

FTickFunction_in: TypeAlias = FTickFunction | FTickFunction_dict | Future[FTickFunction]
"""What stands for FTickFunction as an argument: itself, a dictionary of its fields, a future."""

class FTickFunction_members:
    """The fields of FTickFunction, as paths."""
    TickGroup: Property[ValuePath[ETickingGroup, ETickingGroup_in], ETickingGroup_in]
    """Defines the minimum tick group for this tick function. These groups determine the relative order of when
    objects tick during a frame update.
    """
    EndTickGroup: Property[ValuePath[ETickingGroup, ETickingGroup_in], ETickingGroup_in]
    """Defines the tick group that this tick function must finish in. These groups determine the relative order of
    when objects tick during a frame update.
    """
    bTickEvenWhenPaused: BoolProperty
    """Bool indicating that this function should execute even if the game is paused. Pause ticks are very limited in
    capabilities.
    """
    bCanEverTick: BoolProperty
    """If false, this tick function will never be registered and will never tick. Only settable in defaults."""
    bStartWithTickEnabled: BoolProperty
    """If true, this tick function will start enabled, but can be disabled later on."""
    bAllowTickOnDedicatedServer: BoolProperty
    """If we allow this tick to run on a dedicated server."""
    TickInterval: FloatProperty
    """The frequency in seconds at which this tick function will be executed. If less than or equal to 0 then it will
    tick every frame.
    """

class FTickFunction_async_members:
    """The fields of FTickFunction, as paths under ``async_``."""
    TickGroup: Property[AsyncValuePath[ETickingGroup, ETickingGroup_in], ETickingGroup_in]
    EndTickGroup: Property[AsyncValuePath[ETickingGroup, ETickingGroup_in], ETickingGroup_in]
    bTickEvenWhenPaused: AsyncBoolProperty
    bCanEverTick: AsyncBoolProperty
    bStartWithTickEnabled: AsyncBoolProperty
    bAllowTickOnDedicatedServer: AsyncBoolProperty
    TickInterval: AsyncFloatProperty

class FTickFunction_path(StructPath[FTickFunction, FTickFunction_in, FTickFunction_async], FTickFunction_members):
    """A variable of type FTickFunction: its path."""

class FTickFunction_async(AsyncValuePath[FTickFunction, FTickFunction_in], FTickFunction_async_members):
    """The same under ``async_``."""

class FActorTickFunction(FTickFunction):
    """Tick function that calls AActor::TickActor.

    Unreal: /Script/Engine.ActorTickFunction
    """
    def __init__(self, TickGroup: ETickingGroup = ..., EndTickGroup: ETickingGroup = ..., bTickEvenWhenPaused: bool = ..., bCanEverTick: bool = ..., bStartWithTickEnabled: bool = ..., bAllowTickOnDedicatedServer: bool = ..., TickInterval: float = ...) -> None: ...

class FActorTickFunction_dict(FTickFunction_dict, total=False):
    """Any of the fields of FActorTickFunction: what a dictionary for it may hold."""

FActorTickFunction_in: TypeAlias = FActorTickFunction | FActorTickFunction_dict | Future[FActorTickFunction]
"""What stands for FActorTickFunction as an argument: itself, a dictionary of its fields, a future."""

class FActorTickFunction_members(FTickFunction_members):
    """The fields of FActorTickFunction, as paths."""

class FActorTickFunction_async_members(FTickFunction_async_members):
    """The fields of FActorTickFunction, as paths under ``async_``."""

class FActorTickFunction_path(StructPath[FActorTickFunction, FActorTickFunction_in, FActorTickFunction_async], FActorTickFunction_members):
    """A variable of type FActorTickFunction: its path."""

class FActorTickFunction_async(AsyncValuePath[FActorTickFunction, FActorTickFunction_in], FActorTickFunction_async_members):
    """The same under ``async_``."""

class FActorComponentTickFunction(FTickFunction):
    """Tick function that calls UActorComponent::TickComponent.

    Unreal: /Script/Engine.ActorComponentTickFunction
    """
    def __init__(self, TickGroup: ETickingGroup = ..., EndTickGroup: ETickingGroup = ..., bTickEvenWhenPaused: bool = ..., bCanEverTick: bool = ..., bStartWithTickEnabled: bool = ..., bAllowTickOnDedicatedServer: bool = ..., TickInterval: float = ...) -> None: ...

class FActorComponentTickFunction_dict(FTickFunction_dict, total=False):
    """Any of the fields of FActorComponentTickFunction: what a dictionary for it may hold."""

FActorComponentTickFunction_in: TypeAlias = FActorComponentTickFunction | FActorComponentTickFunction_dict | Future[FActorComponentTickFunction]
"""What stands for FActorComponentTickFunction as an argument: itself, a dictionary of its fields, a future."""

class FActorComponentTickFunction_members(FTickFunction_members):
    """The fields of FActorComponentTickFunction, as paths."""

class FActorComponentTickFunction_async_members(FTickFunction_async_members):
    """The fields of FActorComponentTickFunction, as paths under ``async_``."""

class FActorComponentTickFunction_path(StructPath[FActorComponentTickFunction, FActorComponentTickFunction_in, FActorComponentTickFunction_async], FActorComponentTickFunction_members):
    """A variable of type FActorComponentTickFunction: its path."""

class FActorComponentTickFunction_async(AsyncValuePath[FActorComponentTickFunction, FActorComponentTickFunction_in], FActorComponentTickFunction_async_members):
    """The same under ``async_``."""

class FURL(Struct):
    """A uniform resource locator of a map: "MapName?Option=Value?Flag". The embedded engine has no network, so Host
    is always empty.

    Unreal: /Script/Engine.URL
    """
    def __init__(self, Protocol: str = ..., Host: str = ..., Port: int = ..., Valid: int = ..., Map: str = ..., RedirectURL: str = ..., Op: list[str] = ..., Portal: str = ...) -> None: ...
    Protocol: str
    """Protocol, i.e. "unreal" or "http"."""
    Host: str
    """Optional hostname, i.e. "204.157.115.40" or "unreal.epicgames.com", blank if local."""
    Port: int
    """Optional host port."""
    Valid: int
    """Whether the URL could be parsed."""
    Map: str
    """Map name, i.e. "SkyCity", default is "Entry"."""
    RedirectURL: str
    """Optional place to download Map if client does not possess it."""
    Op: list[str]
    """Options, each "Name=Value" or "Name"."""
    Portal: str
    """Portal to enter through, default is ""."""

class FURL_dict(TypedDict, total=False):
    """Any of the fields of FURL: what a dictionary for it may hold."""
    Protocol: str | Future[str]
    Host: str | Future[str]
    Port: int | Future[int]
    Valid: int | Future[int]
    Map: str | Future[str]
    RedirectURL: str | Future[str]
    Op: Sequence[str | Future[str]] | Future[list[str]]
    Portal: str | Future[str]

FURL_in: TypeAlias = FURL | FURL_dict | Future[FURL]
"""What stands for FURL as an argument: itself, a dictionary of its fields, a future."""

class FURL_path(StructPath[FURL, FURL_in, FURL_async]):
    """A variable of type FURL: its path."""
    Protocol: StrProperty
    """Protocol, i.e. "unreal" or "http"."""
    Host: StrProperty
    """Optional hostname, i.e. "204.157.115.40" or "unreal.epicgames.com", blank if local."""
    Port: IntProperty
    """Optional host port."""
    Valid: IntProperty
    """Whether the URL could be parsed."""
    Map: StrProperty
    """Map name, i.e. "SkyCity", default is "Entry"."""
    RedirectURL: StrProperty
    """Optional place to download Map if client does not possess it."""
    Op: Property[ArrayPath[str, str | Future[str], Path[str], AsyncPath[str]], Sequence[str | Future[str]] | Future[list[str]]]
    """Options, each "Name=Value" or "Name"."""
    Portal: StrProperty
    """Portal to enter through, default is ""."""

class FURL_async(AsyncValuePath[FURL, FURL_in]):
    """The same under ``async_``."""
    Protocol: AsyncStrProperty
    Host: AsyncStrProperty
    Port: AsyncIntProperty
    Valid: AsyncIntProperty
    Map: AsyncStrProperty
    RedirectURL: AsyncStrProperty
    Op: Property[AsyncArrayPath[str, str | Future[str], AsyncPath[str]], Sequence[str | Future[str]] | Future[list[str]]]
    Portal: AsyncStrProperty
