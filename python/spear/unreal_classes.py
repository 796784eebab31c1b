# SPDX-License-Identifier: MIT
"""Classes of Unreal as Python classes: ``from spear.unreal.Engine import AActor``.

Such a class has no instances of its own making: objects come from an engine. It is the *name* of a class, everywhere one is taken
(``game.spawn_actor(AStaticMeshActor)``), and answers ``isinstance(actor, AActor)`` for objects of the class and of all that derive from it,
whether or not those are known here.
"""

from __future__ import annotations

from typing import Any, ClassVar, NoReturn, TypeVar

from spear import _native, facts
from spear.errors import Error, NullObject, WrongType
from spear.unreal_object import ObjectBase

_T = TypeVar("_T")
_classes: dict[str, type] = {}
_implements: dict[tuple[int, str, str], bool] = {}  # (session, class, interface), from engines


class UnrealClass(type):
    """The type of classes of Unreal."""

    unreal_name: str
    _module_name: str

    def __call__(cls, *args: Any, **kwargs: Any) -> NoReturn:
        raise TypeError(
            f"{cls.__name__} is a class of the engine, whose objects are made there: game.spawn_actor({cls.__name__}) for actors, "
            f"game.new_object({cls.__name__}) for other objects; spear.cast({cls.__name__}, object) checks the class of one you have"
        )

    def __instancecheck__(cls, instance: Any) -> bool:
        return isinstance(instance, _native.Object) and is_a(instance, cls.unreal_name)

    def __subclasscheck__(cls, subclass: type) -> bool:
        if cls.unreal_name == "UObject" and isinstance(subclass, type) and issubclass(subclass, ObjectBase):
            return True
        return super().__subclasscheck__(subclass) or (
            isinstance(subclass, UnrealClass) and cls.unreal_name[:1] == "I" and _facts_say(subclass.unreal_name, cls.unreal_name))

    def __repr__(cls) -> str:
        return f"<class {cls.__module__}.{cls.__name__} of Unreal>"


def is_a(instance: Any, unreal_name: str) -> bool:
    """Whether an object is of a class or interface, or of one derived from it."""
    names = instance._class_names
    if unreal_name in names or unreal_name == "UObject":
        return True
    if unreal_name[:1] != "I":
        return False
    if any(_facts_say(name, unreal_name) for name in names):
        return True
    key = (instance._session.serial, instance._class_name, unreal_name)
    if key not in _implements:
        try:
            answer = instance._session.call("unreal_service.is_a", (instance, unreal_name), {}, _native.SYNC)
        except Error:
            return False  # the object or the engine is gone, or the engine has no such interface
        _implements[key] = bool(answer)
    return _implements[key]


def _facts_say(name: str, interface: str) -> bool:
    """Whether facts tell that a class implements an interface, itself or by a class it derives from."""
    current: str | None = name
    while current:
        entity = facts.class_facts(current)
        if entity is None:
            return False
        for implemented in entity.get("interfaces") or ():
            if implemented == interface or _facts_say(implemented, interface):
                return True
        current = entity.get("super")
        if current == interface:
            return True
    return False


class UnrealType(metaclass=UnrealClass):
    """Base of all classes of Unreal in Python."""

    __slots__ = ()
    #: Unreal's name of the class, ``"AActor"``.
    unreal_name: ClassVar[str] = "UObject"


def unreal_class(name: str, module: str = "") -> type:
    """The Python class of a class of Unreal: always the same one. It derives as facts tell, else from UObject."""
    with facts.making:
        return _unreal_class(name, module)


def _unreal_class(name: str, module: str) -> type:
    made = _classes.get(name)
    if made is None:
        found = facts.find(module, name) if module else None
        entity = found[1] if found and found[0] == "classes" else {}
        parent = entity.get("super") or ("" if name == "UObject" else "UInterface" if name[:1] == "I" else "UObject")
        base: type = UnrealType if not parent or parent == name else unreal_class(parent, _module_of_class(parent, module))
        if name in _classes:  # made meanwhile, as a base
            return _classes[name]
        made = UnrealClass(name, (base,), {
            "__slots__": (), "__module__": "spear.unreal." + module if module else "spear.unreal_classes", "unreal_name": name,
            "__doc__": f"The class {name} of Unreal{f' (module {module})' if module else ''}: a name for it, as objects are made by the engine.",
        })
        _classes[name] = made
    elif module and not made.__module__.startswith("spear.unreal."):
        made.__module__ = "spear.unreal." + module
    return made


def _module_of_class(name: str, module: str) -> str:
    entity = facts.class_facts(name)
    if entity is not None:
        return facts.module_of_class(name)
    return "CoreUObject" if name in ("UObject", "UInterface", "UClass", "UStruct", "UField") else ""


def cast(uclass: type[_T], unreal_object: Any) -> _T:
    """The object, known as one of a class: ``spear.cast(AStaticMeshActor, actor)``. Raises WrongType if it is of another, NullObject for None."""
    name = getattr(uclass, "unreal_name", None)
    if not isinstance(name, str):
        raise TypeError(f"{uclass!r} is no class of Unreal: give one of spear.unreal")
    if unreal_object is None:
        raise NullObject(f"cast to {name}: an object is needed, found None", "cast", "unreal_object", name)
    if not isinstance(unreal_object, _native.Object):
        raise WrongType(f"cast to {name}: an object of the engine is needed, not a {type(unreal_object).__name__}", "cast", "unreal_object", name)
    if not is_a(unreal_object, name):
        raise WrongType(f"cast to {name}: the object is a {unreal_object._class_name} ({unreal_object!r})", "cast", "unreal_object", name)
    return unreal_object  # type: ignore[return-value]
