# generated, do not edit (Engine: Public/Engine/EngineTypes.h)
from typing import TypeAlias, TypedDict
from spear.enums import UnrealEnum
from spear.structs import Struct
from spear.typing import AsyncBoolProperty, AsyncValuePath, BoolProperty, Future, Property, StructPath, ValuePath
from ..CoreUObject._Intrinsic import FScriptDelegate

class ETeleportType(UnrealEnum):
    """Whether to teleport physics body or not.

    Unreal: /Script/Engine.ETeleportType
    """
    None_ = 0
    """Do not teleport physics body. This means velocity will reflect the movement between initial and final
    position, and collisions along the way will occur.
    """
    TeleportPhysics = 1
    """Teleport physics body so that velocity remains the same and no collision occurs."""
    ResetPhysics = 2
    """Teleport physics body and reset physics state completely."""

ETeleportType_in: TypeAlias = ETeleportType | str | Future[ETeleportType]
"""What stands for ETeleportType as an argument: an entry, the name that Unreal gives it, a future."""

class EComponentMobility(UnrealEnum):
    """Describes how often a component is allowed to move.

    Unreal: /Script/Engine.EComponentMobility
    """
    Static = 0
    """Static objects cannot be moved or changed in game."""
    Stationary = 1
    """A stationary light will only have its shadowing and bounced lighting from static geometry baked, all other
    lighting will be dynamic. It can change color and intensity in game.
    """
    Movable = 2
    """Movable objects can be moved and changed in game."""

EComponentMobility_in: TypeAlias = EComponentMobility | str | Future[EComponentMobility]
"""What stands for EComponentMobility as an argument: an entry, the name that Unreal gives it, a future."""

class EEndPlayReason(UnrealEnum):
    """Details of what ended play of an actor or component.

    Unreal: /Script/Engine.EEndPlayReason
    """
    Destroyed = 0
    """When the Actor or Component is explicitly destroyed."""
    LevelTransition = 1
    """When the world is being unloaded for a level transition."""
    EndPlayInEditor = 2
    """When the world is being unloaded because PIE is ending."""
    RemovedFromWorld = 3
    """When the level it is a member of is streamed out."""
    Quit = 4
    """When the application is being exited."""

EEndPlayReason_in: TypeAlias = EEndPlayReason | str | Future[EEndPlayReason]
"""What stands for EEndPlayReason as an argument: an entry, the name that Unreal gives it, a future."""

class ENetRole(UnrealEnum):
    """The network role of an actor on a local/remote network context. Without network every spawned actor has
    ROLE_Authority.

    Unreal: /Script/Engine.ENetRole
    """
    ROLE_None = 0
    """No role at all."""
    ROLE_SimulatedProxy = 1
    """Locally simulated proxy of this actor."""
    ROLE_AutonomousProxy = 2
    """Locally autonomous proxy of this actor."""
    ROLE_Authority = 3
    """Authoritative control over the actor."""
    ROLE_MAX = 4

ENetRole_in: TypeAlias = ENetRole | str | Future[ENetRole]
"""What stands for ENetRole as an argument: an entry, the name that Unreal gives it, a future."""

class EAttachLocation(UnrealEnum):
    """Rules for attaching components. Used by the deprecated attachment functions of old content.

    Unreal: /Script/Engine.EAttachLocation
    """
    KeepRelativeOffset = 0
    """Keep current relative transform as the relative transform to the new parent."""
    KeepWorldPosition = 1
    """Automatically calculate the relative transform such that the attached component maintains the same world
    transform.
    """
    SnapToTarget = 2
    """Snap location and rotation to the attach point. Calculates the relative scale so that the final world scale of
    the component remains the same.
    """
    SnapToTargetIncludingScale = 3
    """Snap entire transform to target, including scale."""

EAttachLocation_in: TypeAlias = EAttachLocation | str | Future[EAttachLocation]
"""What stands for EAttachLocation as an argument: an entry, the name that Unreal gives it, a future."""

class EAttachmentRule(UnrealEnum):
    """Rules for attaching components.

    Unreal: /Script/Engine.EAttachmentRule
    """
    KeepRelative = 0
    """Keeps current relative transform as the relative transform to the new parent."""
    KeepWorld = 1
    """Automatically calculates the relative transform such that the attached component maintains the same world
    transform.
    """
    SnapToTarget = 2
    """Snaps transform to the attach point."""

EAttachmentRule_in: TypeAlias = EAttachmentRule | str | Future[EAttachmentRule]
"""What stands for EAttachmentRule as an argument: an entry, the name that Unreal gives it, a future."""

class EDetachmentRule(UnrealEnum):
    """Rules for detaching components; needs to be kept synced with EAttachmentRule.

    Unreal: /Script/Engine.EDetachmentRule
    """
    KeepRelative = 0
    """Keeps current relative transform."""
    KeepWorld = 1
    """Automatically calculates the relative transform such that the detached component maintains the same world
    transform.
    """

EDetachmentRule_in: TypeAlias = EDetachmentRule | str | Future[EDetachmentRule]
"""What stands for EDetachmentRule as an argument: an entry, the name that Unreal gives it, a future."""

class ESpawnActorCollisionHandlingMethod(UnrealEnum):
    """Defines available strategies for handling the case where an actor is spawned in such a way that it penetrates
    blocking collision.

    Unreal: /Script/Engine.ESpawnActorCollisionHandlingMethod
    """
    Undefined = 0
    """Fall back to default settings."""
    AlwaysSpawn = 1
    """Actor will spawn in desired location, regardless of collisions."""
    AdjustIfPossibleButAlwaysSpawn = 2
    """Actor will try to find a nearby non-colliding location (based on shape components), but will always spawn even
    if one cannot be found.
    """
    AdjustIfPossibleButDontSpawnIfColliding = 3
    """Actor will try to find a nearby non-colliding location (based on shape components), but will NOT spawn unless
    one is found.
    """
    DontSpawnIfColliding = 4
    """Actor will fail to spawn."""

ESpawnActorCollisionHandlingMethod_in: TypeAlias = ESpawnActorCollisionHandlingMethod | str | Future[ESpawnActorCollisionHandlingMethod]
"""What stands for ESpawnActorCollisionHandlingMethod as an argument: an entry, the name that Unreal gives it, a future."""

class ESpawnActorScaleMethod(UnrealEnum):
    """Determines how the transform being passed into actor spawning methods interact with the actor's default root
    component.

    Unreal: /Script/Engine.ESpawnActorScaleMethod
    """
    OverrideRootScale = 0
    """Ignore the default scale in the actor's root component and hard-set it to the value of SpawnTransform
    Parameter.
    """
    MultiplyWithRoot = 1
    """Multiply value of the SpawnTransform Parameter with the default scale in the actor's root component."""
    SelectDefaultAtRuntime = 2
    """Determine whether to override or multiply on spawn: native root components multiply."""

ESpawnActorScaleMethod_in: TypeAlias = ESpawnActorScaleMethod | str | Future[ESpawnActorScaleMethod]
"""What stands for ESpawnActorScaleMethod as an argument: an entry, the name that Unreal gives it, a future."""

class EComponentCreationMethod(UnrealEnum):
    """Specifies the goal/source of a UActorComponent's creation.

    Unreal: /Script/Engine.EComponentCreationMethod
    """
    Native = 0
    """A component that is part of a native class."""
    SimpleConstructionScript = 1
    """A component that is created from a template defined in the Components section of the Blueprint."""
    UserConstructionScript = 2
    """A dynamically created component, either from the UserConstructionScript or from a Add Component node in a
    Blueprint event graph.
    """
    Instance = 3
    """A component added to a single Actor instance via the Component section of the Actor's details panel."""

EComponentCreationMethod_in: TypeAlias = EComponentCreationMethod | str | Future[EComponentCreationMethod]
"""What stands for EComponentCreationMethod as an argument: an entry, the name that Unreal gives it, a future."""

class ECollisionChannel(UnrealEnum):
    """Which channels an object or a trace is in for collision.

    Unreal: /Script/Engine.ECollisionChannel
    """
    ECC_WorldStatic = 0
    ECC_WorldDynamic = 1
    ECC_Pawn = 2
    ECC_Visibility = 3
    ECC_Camera = 4
    ECC_PhysicsBody = 5
    ECC_Vehicle = 6
    ECC_Destructible = 7
    ECC_EngineTraceChannel1 = 8
    """Reserved for gizmo collision."""
    ECC_EngineTraceChannel2 = 9
    ECC_EngineTraceChannel3 = 10
    ECC_EngineTraceChannel4 = 11
    ECC_EngineTraceChannel5 = 12
    ECC_EngineTraceChannel6 = 13
    ECC_GameTraceChannel1 = 14
    ECC_GameTraceChannel2 = 15
    ECC_GameTraceChannel3 = 16
    ECC_GameTraceChannel4 = 17
    ECC_GameTraceChannel5 = 18
    ECC_GameTraceChannel6 = 19
    ECC_GameTraceChannel7 = 20
    ECC_GameTraceChannel8 = 21
    ECC_GameTraceChannel9 = 22
    ECC_GameTraceChannel10 = 23
    ECC_GameTraceChannel11 = 24
    ECC_GameTraceChannel12 = 25
    ECC_GameTraceChannel13 = 26
    ECC_GameTraceChannel14 = 27
    ECC_GameTraceChannel15 = 28
    ECC_GameTraceChannel16 = 29
    ECC_GameTraceChannel17 = 30
    ECC_GameTraceChannel18 = 31
    ECC_OverlapAll_Deprecated = 32
    """Add new serializeable channels above here (i.e. entries that exist in FCollisionResponseContainer)."""
    ECC_MAX = 33

ECollisionChannel_in: TypeAlias = ECollisionChannel | str | Future[ECollisionChannel]
"""What stands for ECollisionChannel as an argument: an entry, the name that Unreal gives it, a future."""

class ECollisionResponse(UnrealEnum):
    """Enum indicating how each type should respond.

    Unreal: /Script/Engine.ECollisionResponse
    """
    ECR_Ignore = 0
    ECR_Overlap = 1
    ECR_Block = 2
    ECR_MAX = 3

ECollisionResponse_in: TypeAlias = ECollisionResponse | str | Future[ECollisionResponse]
"""What stands for ECollisionResponse as an argument: an entry, the name that Unreal gives it, a future."""

class ECollisionEnabled(UnrealEnum):
    """What types of collision a body takes part in.

    Unreal: /Script/Engine.ECollisionEnabled
    """
    NoCollision = 0
    """Will not create any representation in the physics engine. Cannot be used for spatial queries (raycasts,
    sweeps, overlaps) or simulation (rigid body, constraints).
    """
    QueryOnly = 1
    """Only used for spatial queries (raycasts, sweeps, and overlaps). Cannot be used for simulation (rigid body,
    constraints).
    """
    PhysicsOnly = 2
    """Only used only for physics simulation (rigid body, constraints). Cannot be used for spatial queries (raycasts,
    sweeps, overlaps).
    """
    QueryAndPhysics = 3
    """Can be used for both spatial queries (raycasts, sweeps, overlaps) and simulation (rigid body, constraints)."""
    ProbeOnly = 4
    """Only used for probing the physics simulation (rigid body, constraints)."""
    QueryAndProbe = 5
    """Can be used for both spatial queries and probing the physics simulation."""

ECollisionEnabled_in: TypeAlias = ECollisionEnabled | str | Future[ECollisionEnabled]
"""What stands for ECollisionEnabled as an argument: an entry, the name that Unreal gives it, a future."""

class EAutoReceiveInput(UnrealEnum):
    """Which local player, if any, something is assigned to automatically.

    Unreal: /Script/Engine.EAutoReceiveInput
    """
    Disabled = 0
    Player0 = 1
    Player1 = 2
    Player2 = 3
    Player3 = 4
    Player4 = 5
    Player5 = 6
    Player6 = 7
    Player7 = 8

EAutoReceiveInput_in: TypeAlias = EAutoReceiveInput | str | Future[EAutoReceiveInput]
"""What stands for EAutoReceiveInput as an argument: an entry, the name that Unreal gives it, a future."""

class EComponentSocketType(UnrealEnum):
    """What kind of thing a socket of a component is.

    Unreal: /Script/Engine.EComponentSocketType
    """
    Invalid = 0
    """Not a valid socket or bone name."""
    Bone = 1
    """Skeletal bone."""
    Socket = 2
    """Socket."""

EComponentSocketType_in: TypeAlias = EComponentSocketType | str | Future[EComponentSocketType]
"""What stands for EComponentSocketType as an argument: an entry, the name that Unreal gives it, a future."""

class FCollisionResponseContainer(Struct):
    """The response of a body to each collision channel, one named byte each.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FCollisionResponseContainer

    Unreal: /Script/Engine.CollisionResponseContainer
    """
    def __init__(self, WorldStatic: ECollisionResponse = ..., WorldDynamic: ECollisionResponse = ..., Pawn: ECollisionResponse = ..., Visibility: ECollisionResponse = ..., Camera: ECollisionResponse = ..., PhysicsBody: ECollisionResponse = ..., Vehicle: ECollisionResponse = ..., Destructible: ECollisionResponse = ..., EngineTraceChannel1: ECollisionResponse = ..., EngineTraceChannel2: ECollisionResponse = ..., EngineTraceChannel3: ECollisionResponse = ..., EngineTraceChannel4: ECollisionResponse = ..., EngineTraceChannel5: ECollisionResponse = ..., EngineTraceChannel6: ECollisionResponse = ..., GameTraceChannel1: ECollisionResponse = ..., GameTraceChannel2: ECollisionResponse = ..., GameTraceChannel3: ECollisionResponse = ..., GameTraceChannel4: ECollisionResponse = ..., GameTraceChannel5: ECollisionResponse = ..., GameTraceChannel6: ECollisionResponse = ..., GameTraceChannel7: ECollisionResponse = ..., GameTraceChannel8: ECollisionResponse = ..., GameTraceChannel9: ECollisionResponse = ..., GameTraceChannel10: ECollisionResponse = ..., GameTraceChannel11: ECollisionResponse = ..., GameTraceChannel12: ECollisionResponse = ..., GameTraceChannel13: ECollisionResponse = ..., GameTraceChannel14: ECollisionResponse = ..., GameTraceChannel15: ECollisionResponse = ..., GameTraceChannel16: ECollisionResponse = ..., GameTraceChannel17: ECollisionResponse = ..., GameTraceChannel18: ECollisionResponse = ...) -> None: ...
    WorldStatic: ECollisionResponse
    """Response to the channel WorldStatic."""
    WorldDynamic: ECollisionResponse
    """Response to the channel WorldDynamic."""
    Pawn: ECollisionResponse
    """Response to the channel Pawn."""
    Visibility: ECollisionResponse
    """Response to the channel Visibility."""
    Camera: ECollisionResponse
    """Response to the channel Camera."""
    PhysicsBody: ECollisionResponse
    """Response to the channel PhysicsBody."""
    Vehicle: ECollisionResponse
    """Response to the channel Vehicle."""
    Destructible: ECollisionResponse
    """Response to the channel Destructible."""
    EngineTraceChannel1: ECollisionResponse
    EngineTraceChannel2: ECollisionResponse
    EngineTraceChannel3: ECollisionResponse
    EngineTraceChannel4: ECollisionResponse
    EngineTraceChannel5: ECollisionResponse
    EngineTraceChannel6: ECollisionResponse
    GameTraceChannel1: ECollisionResponse
    GameTraceChannel2: ECollisionResponse
    GameTraceChannel3: ECollisionResponse
    GameTraceChannel4: ECollisionResponse
    GameTraceChannel5: ECollisionResponse
    GameTraceChannel6: ECollisionResponse
    GameTraceChannel7: ECollisionResponse
    GameTraceChannel8: ECollisionResponse
    GameTraceChannel9: ECollisionResponse
    GameTraceChannel10: ECollisionResponse
    GameTraceChannel11: ECollisionResponse
    GameTraceChannel12: ECollisionResponse
    GameTraceChannel13: ECollisionResponse
    GameTraceChannel14: ECollisionResponse
    GameTraceChannel15: ECollisionResponse
    GameTraceChannel16: ECollisionResponse
    GameTraceChannel17: ECollisionResponse
    GameTraceChannel18: ECollisionResponse

class FCollisionResponseContainer_dict(TypedDict, total=False):
    """Any of the fields of FCollisionResponseContainer: what a dictionary for it may hold."""
    WorldStatic: ECollisionResponse_in
    WorldDynamic: ECollisionResponse_in
    Pawn: ECollisionResponse_in
    Visibility: ECollisionResponse_in
    Camera: ECollisionResponse_in
    PhysicsBody: ECollisionResponse_in
    Vehicle: ECollisionResponse_in
    Destructible: ECollisionResponse_in
    EngineTraceChannel1: ECollisionResponse_in
    EngineTraceChannel2: ECollisionResponse_in
    EngineTraceChannel3: ECollisionResponse_in
    EngineTraceChannel4: ECollisionResponse_in
    EngineTraceChannel5: ECollisionResponse_in
    EngineTraceChannel6: ECollisionResponse_in
    GameTraceChannel1: ECollisionResponse_in
    GameTraceChannel2: ECollisionResponse_in
    GameTraceChannel3: ECollisionResponse_in
    GameTraceChannel4: ECollisionResponse_in
    GameTraceChannel5: ECollisionResponse_in
    GameTraceChannel6: ECollisionResponse_in
    GameTraceChannel7: ECollisionResponse_in
    GameTraceChannel8: ECollisionResponse_in
    GameTraceChannel9: ECollisionResponse_in
    GameTraceChannel10: ECollisionResponse_in
    GameTraceChannel11: ECollisionResponse_in
    GameTraceChannel12: ECollisionResponse_in
    GameTraceChannel13: ECollisionResponse_in
    GameTraceChannel14: ECollisionResponse_in
    GameTraceChannel15: ECollisionResponse_in
    GameTraceChannel16: ECollisionResponse_in
    GameTraceChannel17: ECollisionResponse_in
    GameTraceChannel18: ECollisionResponse_in

FCollisionResponseContainer_in: TypeAlias = FCollisionResponseContainer | FCollisionResponseContainer_dict | Future[FCollisionResponseContainer]
"""What stands for FCollisionResponseContainer as an argument: itself, a dictionary of its fields, a future."""

class FCollisionResponseContainer_path(StructPath[FCollisionResponseContainer, FCollisionResponseContainer_in, FCollisionResponseContainer_async]):
    """A variable of type FCollisionResponseContainer: its path."""
    WorldStatic: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    """Response to the channel WorldStatic."""
    WorldDynamic: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    """Response to the channel WorldDynamic."""
    Pawn: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    """Response to the channel Pawn."""
    Visibility: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    """Response to the channel Visibility."""
    Camera: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    """Response to the channel Camera."""
    PhysicsBody: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    """Response to the channel PhysicsBody."""
    Vehicle: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    """Response to the channel Vehicle."""
    Destructible: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    """Response to the channel Destructible."""
    EngineTraceChannel1: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel2: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel3: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel4: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel5: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel6: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel1: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel2: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel3: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel4: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel5: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel6: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel7: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel8: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel9: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel10: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel11: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel12: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel13: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel14: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel15: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel16: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel17: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel18: Property[ValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]

class FCollisionResponseContainer_async(AsyncValuePath[FCollisionResponseContainer, FCollisionResponseContainer_in]):
    """The same under ``async_``."""
    WorldStatic: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    WorldDynamic: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    Pawn: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    Visibility: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    Camera: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    PhysicsBody: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    Vehicle: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    Destructible: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel1: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel2: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel3: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel4: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel5: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    EngineTraceChannel6: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel1: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel2: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel3: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel4: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel5: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel6: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel7: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel8: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel9: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel10: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel11: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel12: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel13: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel14: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel15: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel16: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel17: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]
    GameTraceChannel18: Property[AsyncValuePath[ECollisionResponse, ECollisionResponse_in], ECollisionResponse_in]

class FLightingChannels(Struct):
    """Which lighting channels a light or a primitive is in: a light affects a primitive if they share one.

    Unreal: /Script/Engine.LightingChannels
    """
    def __init__(self, bChannel0: bool = ..., bChannel1: bool = ..., bChannel2: bool = ...) -> None: ...
    bChannel0: bool
    """Default channel for all primitives and lights."""
    bChannel1: bool
    """First custom channel."""
    bChannel2: bool
    """Second custom channel."""

class FLightingChannels_dict(TypedDict, total=False):
    """Any of the fields of FLightingChannels: what a dictionary for it may hold."""
    bChannel0: bool | Future[bool]
    bChannel1: bool | Future[bool]
    bChannel2: bool | Future[bool]

FLightingChannels_in: TypeAlias = FLightingChannels | FLightingChannels_dict | Future[FLightingChannels]
"""What stands for FLightingChannels as an argument: itself, a dictionary of its fields, a future."""

class FLightingChannels_path(StructPath[FLightingChannels, FLightingChannels_in, FLightingChannels_async]):
    """A variable of type FLightingChannels: its path."""
    bChannel0: BoolProperty
    """Default channel for all primitives and lights."""
    bChannel1: BoolProperty
    """First custom channel."""
    bChannel2: BoolProperty
    """Second custom channel."""

class FLightingChannels_async(AsyncValuePath[FLightingChannels, FLightingChannels_in]):
    """The same under ``async_``."""
    bChannel0: AsyncBoolProperty
    bChannel1: AsyncBoolProperty
    bChannel2: AsyncBoolProperty

FTimerDynamicDelegate: TypeAlias = FScriptDelegate
"""Delegate of a timer that is bound to a reflected function.

Called as FTimerDynamicDelegate(); a value tells what is bound.

Unreal: /Script/Engine.TimerDynamicDelegate__DelegateSignature
"""
