# generated, do not edit (CoreUObject: Intrinsic.h)
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import AsyncObjectPath, AsyncStrProperty, AsyncValuePath, Future, ObjectPath, Property, StrProperty, StructPath
from ._NoExportTypes import UObject, UObject_async, UObject_async_path, UObject_members, UObject_path, UObject_send

class FScriptDelegate(Struct):
    """What is bound to a delegate.

    Unreal: FScriptDelegate
    """
    def __init__(self, Object: UObject | None = ..., FunctionName: str = ...) -> None: ...
    Object: UObject | None
    """The object that is called; None if nothing is bound."""
    FunctionName: str
    """The function of it."""

class FScriptDelegate_dict(TypedDict, total=False):
    """Any of the fields of FScriptDelegate: what a dictionary for it may hold."""
    Object: UObject | Future[UObject] | None
    FunctionName: str | Future[str]

FScriptDelegate_in: TypeAlias = FScriptDelegate | FScriptDelegate_dict | Future[FScriptDelegate]
"""What stands for FScriptDelegate as an argument: itself, a dictionary of its fields, a future."""

class FScriptDelegate_path(StructPath[FScriptDelegate, FScriptDelegate_in, FScriptDelegate_async]):
    """A variable of type FScriptDelegate: its path."""
    Object: Property[UObject_path, UObject | Future[UObject] | None]
    """The object that is called; None if nothing is bound."""
    FunctionName: StrProperty
    """The function of it."""

class FScriptDelegate_async(AsyncValuePath[FScriptDelegate, FScriptDelegate_in]):
    """The same under ``async_``."""
    Object: Property[UObject_async_path, UObject | Future[UObject] | None]
    FunctionName: AsyncStrProperty

class UClass_members(UStruct_members):
    """Functions and variables of UClass."""

class UClass_async(UStruct_async):
    """UClass under ``async_``: each function gives a future."""

class UClass_send(UStruct_send):
    """UClass under ``send_``: no function answers."""

class UClass(UClass_members, UStruct):
    """A class of Unreal, an object too.

    Unreal: /Script/CoreUObject.Class
    """
    @property
    def async_(self) -> UClass_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UClass_send:
        """The same functions and variables, fire-and-forget."""

class UClass_path(ObjectPath[UClass, UClass_async_path, UClass_send], UClass_members):
    """A variable that refers to an object of UClass: its path."""

class UClass_async_path(AsyncObjectPath[UClass], UClass_async):
    """The same under ``async_``."""

class UEnum_members(UField_members):
    """Functions and variables of UEnum."""

class UEnum_async(UField_async):
    """UEnum under ``async_``: each function gives a future."""

class UEnum_send(UField_send):
    """UEnum under ``send_``: no function answers."""

class UEnum(UEnum_members, UField):
    """An enum as an object.

    Unreal: /Script/CoreUObject.Enum
    """
    @property
    def async_(self) -> UEnum_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UEnum_send:
        """The same functions and variables, fire-and-forget."""

class UEnum_path(ObjectPath[UEnum, UEnum_async_path, UEnum_send], UEnum_members):
    """A variable that refers to an object of UEnum: its path."""

class UEnum_async_path(AsyncObjectPath[UEnum], UEnum_async):
    """The same under ``async_``."""

class UField_members(UObject_members):
    """Functions and variables of UField."""

class UField_async(UObject_async):
    """UField under ``async_``: each function gives a future."""

class UField_send(UObject_send):
    """UField under ``send_``: no function answers."""

class UField(UField_members, UObject):
    """Base of reflected types as objects.

    Unreal: /Script/CoreUObject.Field
    """
    @property
    def async_(self) -> UField_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UField_send:
        """The same functions and variables, fire-and-forget."""

class UField_path(ObjectPath[UField, UField_async_path, UField_send], UField_members):
    """A variable that refers to an object of UField: its path."""

class UField_async_path(AsyncObjectPath[UField], UField_async):
    """The same under ``async_``."""

class UFunction_members(UStruct_members):
    """Functions and variables of UFunction."""

class UFunction_async(UStruct_async):
    """UFunction under ``async_``: each function gives a future."""

class UFunction_send(UStruct_send):
    """UFunction under ``send_``: no function answers."""

class UFunction(UFunction_members, UStruct):
    """A function as an object.

    Unreal: /Script/CoreUObject.Function
    """
    @property
    def async_(self) -> UFunction_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UFunction_send:
        """The same functions and variables, fire-and-forget."""

class UFunction_path(ObjectPath[UFunction, UFunction_async_path, UFunction_send], UFunction_members):
    """A variable that refers to an object of UFunction: its path."""

class UFunction_async_path(AsyncObjectPath[UFunction], UFunction_async):
    """The same under ``async_``."""

class UInterface_members(UObject_members):
    """Functions and variables of UInterface."""

class UInterface_async(UObject_async):
    """UInterface under ``async_``: each function gives a future."""

class UInterface_send(UObject_send):
    """UInterface under ``send_``: no function answers."""

class UInterface(UInterface_members, UObject):
    """Base of the classes of interfaces.

    Unreal: /Script/CoreUObject.Interface
    """
    @property
    def async_(self) -> UInterface_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UInterface_send:
        """The same functions and variables, fire-and-forget."""

class UInterface_path(ObjectPath[UInterface, UInterface_async_path, UInterface_send], UInterface_members):
    """A variable that refers to an object of UInterface: its path."""

class UInterface_async_path(AsyncObjectPath[UInterface], UInterface_async):
    """The same under ``async_``."""

class UPackage_members(UObject_members):
    """Functions and variables of UPackage."""

class UPackage_async(UObject_async):
    """UPackage under ``async_``: each function gives a future."""

class UPackage_send(UObject_send):
    """UPackage under ``send_``: no function answers."""

class UPackage(UPackage_members, UObject):
    """What objects are saved in.

    Unreal: /Script/CoreUObject.Package
    """
    @property
    def async_(self) -> UPackage_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UPackage_send:
        """The same functions and variables, fire-and-forget."""

class UPackage_path(ObjectPath[UPackage, UPackage_async_path, UPackage_send], UPackage_members):
    """A variable that refers to an object of UPackage: its path."""

class UPackage_async_path(AsyncObjectPath[UPackage], UPackage_async):
    """The same under ``async_``."""

class UScriptStruct_members(UStruct_members):
    """Functions and variables of UScriptStruct."""

class UScriptStruct_async(UStruct_async):
    """UScriptStruct under ``async_``: each function gives a future."""

class UScriptStruct_send(UStruct_send):
    """UScriptStruct under ``send_``: no function answers."""

class UScriptStruct(UScriptStruct_members, UStruct):
    """A struct type as an object.

    Unreal: /Script/CoreUObject.ScriptStruct
    """
    @property
    def async_(self) -> UScriptStruct_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UScriptStruct_send:
        """The same functions and variables, fire-and-forget."""

class UScriptStruct_path(ObjectPath[UScriptStruct, UScriptStruct_async_path, UScriptStruct_send], UScriptStruct_members):
    """A variable that refers to an object of UScriptStruct: its path."""

class UScriptStruct_async_path(AsyncObjectPath[UScriptStruct], UScriptStruct_async):
    """The same under ``async_``."""

class UStruct_members(UField_members):
    """Functions and variables of UStruct."""

class UStruct_async(UField_async):
    """UStruct under ``async_``: each function gives a future."""

class UStruct_send(UField_send):
    """UStruct under ``send_``: no function answers."""

class UStruct(UStruct_members, UField):
    """Base of classes, structs and functions as objects.

    Unreal: /Script/CoreUObject.Struct
    """
    @property
    def async_(self) -> UStruct_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UStruct_send:
        """The same functions and variables, fire-and-forget."""

class UStruct_path(ObjectPath[UStruct, UStruct_async_path, UStruct_send], UStruct_members):
    """A variable that refers to an object of UStruct: its path."""

class UStruct_async_path(AsyncObjectPath[UStruct], UStruct_async):
    """The same under ``async_``."""
