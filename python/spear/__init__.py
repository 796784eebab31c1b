# SPDX-License-Identifier: MIT
"""SPEAR: drive any Unreal Engine application from Python.

    import spear

    with spear.launch(scene="apartment") as instance:
        game = instance.get_game()
        with instance.begin_frame():
            table = game.find_actor_by_name("Table_1")
            location = table.async_.K2_GetActorLocation()
        with instance.end_frame():
            pass
        print(location.get())
"""

from spear._native import Future, __version__
from spear.enums import UnrealEnum, UnrealFlags
from spear.errors import (
    AmbiguousName,
    ArgumentError,
    ConnectionError,
    DeadlineExceeded,
    DependencyFailed,
    Disconnected,
    EngineBusy,
    EngineExited,
    EngineNotRunning,
    Error,
    FrameError,
    FrameMisuse,
    HeldByClient,
    InternalError,
    LaunchFailed,
    LimitExceeded,
    LookupFailed,
    MalformedMessage,
    MissingArgument,
    NeedsFrames,
    NotCallable,
    NotInFrame,
    NullObject,
    ObjectError,
    OutOfRange,
    ReadOnly,
    SpawnFailed,
    StaleObject,
    TransactionAborted,
    Unauthorized,
    UnknownArgument,
    UnknownClass,
    UnknownEntryPoint,
    UnknownFunction,
    UnknownObject,
    UnknownProperty,
    VersionMismatch,
    WaitError,
    WrongThread,
    WrongType,
)
from spear.game import Game
from spear.instance import Frame, Instance, Statistics, Traffic, connect, launch
from spear.results import Result
from spear.structs import FColor, FLinearColor, FQuat, FRotator, FTransform, FVector, FVector2D, FVector4, Struct
from spear.unreal_classes import cast
from spear.unreal_object import FutureObject, Member, ObjectBase, UnrealObject

from spear import _setup  # noqa: F401  (tells the native half about the classes here)

__all__ = [
    "AmbiguousName", "ArgumentError", "ConnectionError", "DeadlineExceeded", "DependencyFailed", "Disconnected", "EngineBusy",
    "EngineExited", "EngineNotRunning", "Error", "FColor", "FLinearColor", "FQuat", "FRotator", "FTransform", "FVector", "FVector2D",
    "FVector4", "Frame", "FrameError", "FrameMisuse", "Future", "FutureObject", "Game", "HeldByClient", "Instance", "InternalError",
    "LaunchFailed", "LimitExceeded", "LookupFailed", "MalformedMessage", "Member", "MissingArgument", "NeedsFrames", "NotCallable",
    "NotInFrame", "NullObject", "ObjectBase", "ObjectError", "OutOfRange", "ReadOnly", "Result", "SpawnFailed", "StaleObject", "Statistics", "Struct",
    "Traffic", "TransactionAborted", "Unauthorized", "UnknownArgument", "UnknownClass", "UnknownEntryPoint", "UnknownFunction", "UnknownObject",
    "UnknownProperty", "UnrealEnum", "UnrealFlags", "UnrealObject", "VersionMismatch", "WaitError", "WrongThread", "WrongType",
    "__version__", "cast", "connect", "launch",
]
