# generated, do not edit (Engine: Public/Engine/CollisionProfile.h)
from collections.abc import Sequence
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncObjectPath, AsyncStrProperty, AsyncValuePath, BoolProperty, Future, ObjectPath, Property,
    SendProperty, StrProperty, StructPath, ValuePath,
)
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send
from ._EngineTypes import ECollisionEnabled, ECollisionEnabled_in

class FCollisionResponseTemplate(Struct):
    """A named set of collision settings. Epic page: FCollisionResponseTemplate.

    Unreal: /Script/Engine.CollisionResponseTemplate
    """
    def __init__(self, Name: str = ..., CollisionEnabled: ECollisionEnabled = ..., bCanModify: bool = ..., ObjectTypeName: str = ...) -> None: ...
    Name: str
    """Name of the profile."""
    CollisionEnabled: ECollisionEnabled
    """What a body with this profile takes part in."""
    bCanModify: bool
    """Whether projects may change it."""
    ObjectTypeName: str
    """Name of the object type."""

class FCollisionResponseTemplate_dict(TypedDict, total=False):
    """Any of the fields of FCollisionResponseTemplate: what a dictionary for it may hold."""
    Name: str | Future[str]
    CollisionEnabled: ECollisionEnabled_in
    bCanModify: bool | Future[bool]
    ObjectTypeName: str | Future[str]

FCollisionResponseTemplate_in: TypeAlias = FCollisionResponseTemplate | FCollisionResponseTemplate_dict | Future[FCollisionResponseTemplate]
"""What stands for FCollisionResponseTemplate as an argument: itself, a dictionary of its fields, a future."""

class FCollisionResponseTemplate_path(StructPath[FCollisionResponseTemplate, FCollisionResponseTemplate_in, FCollisionResponseTemplate_async]):
    """A variable of type FCollisionResponseTemplate: its path."""
    Name: StrProperty
    """Name of the profile."""
    CollisionEnabled: Property[ValuePath[ECollisionEnabled, ECollisionEnabled_in], ECollisionEnabled_in]
    """What a body with this profile takes part in."""
    bCanModify: BoolProperty
    """Whether projects may change it."""
    ObjectTypeName: StrProperty
    """Name of the object type."""

class FCollisionResponseTemplate_async(AsyncValuePath[FCollisionResponseTemplate, FCollisionResponseTemplate_in]):
    """The same under ``async_``."""
    Name: AsyncStrProperty
    CollisionEnabled: Property[AsyncValuePath[ECollisionEnabled, ECollisionEnabled_in], ECollisionEnabled_in]
    bCanModify: AsyncBoolProperty
    ObjectTypeName: AsyncStrProperty

class UCollisionProfile_members(UObject_members):
    """Functions and variables of UCollisionProfile."""
    Profiles: Property[ArrayPath[FCollisionResponseTemplate, FCollisionResponseTemplate_in, FCollisionResponseTemplate_path, FCollisionResponseTemplate_async], Sequence[FCollisionResponseTemplate_in] | Future[list[FCollisionResponseTemplate]]]
    """The profiles.

    Unreal: UCollisionProfile.Profiles (TArray<FCollisionResponseTemplate>)
    """

class UCollisionProfile_async(UObject_async):
    """UCollisionProfile under ``async_``: each function gives a future."""
    Profiles: Property[AsyncArrayPath[FCollisionResponseTemplate, FCollisionResponseTemplate_in, FCollisionResponseTemplate_async], Sequence[FCollisionResponseTemplate_in] | Future[list[FCollisionResponseTemplate]]]
    """The profiles."""

class UCollisionProfile_send(UObject_send):
    """UCollisionProfile under ``send_``: no function answers."""
    Profiles: SendProperty[Sequence[FCollisionResponseTemplate_in] | Future[list[FCollisionResponseTemplate]]]

class UCollisionProfile(UCollisionProfile_members, UObject):
    """The collision profiles of the engine: the ones every UE project starts with. Epic pages: UCollisionProfile,
    "Collision Response Reference".

    Unreal: /Script/Engine.CollisionProfile
    """
    @property
    def async_(self) -> UCollisionProfile_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UCollisionProfile_send:
        """The same functions and variables, fire-and-forget."""

class UCollisionProfile_path(ObjectPath[UCollisionProfile, UCollisionProfile_async_path, UCollisionProfile_send], UCollisionProfile_members):
    """A variable that refers to an object of UCollisionProfile: its path."""

class UCollisionProfile_async_path(AsyncObjectPath[UCollisionProfile], UCollisionProfile_async):
    """The same under ``async_``."""
