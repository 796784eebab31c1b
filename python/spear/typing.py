# SPDX-License-Identifier: MIT
"""Types for annotations: paths to variables of objects, as typed code meets them (``typing.pyi`` beside this file is their description).

At run time a path is one thing, :class:`spear.Member`, whatever it leads to; the names here stand for it in annotations and in
``isinstance``, which tells a path from a value, but no kind of path from another.
"""

from __future__ import annotations

from typing import Any

from spear._native import Future


class _Marker(type):
    """Classes of which nothing is ever made."""

    def __instancecheck__(cls, value: object) -> bool:
        from spear import unreal_object

        return isinstance(value, getattr(unreal_object, cls.__run_time__))  # type: ignore[attr-defined]

    def __call__(cls, *_: object, **__: object) -> Any:
        raise TypeError(f"spear.typing.{cls.__name__} is for annotations; paths come from objects: actor.RootComponent")


class _Path(metaclass=_Marker):
    __run_time__ = "Member"

    def __class_getitem__(cls, _: object) -> type[_Path]:
        return cls


class ValuePath(_Path): ...


class Path(ValuePath): ...


class StructPath(ValuePath): ...


class ObjectPath(_Path): ...


class ClassPath(ValuePath): ...


class ArrayPath(ValuePath): ...


class SetPath(ValuePath): ...


class MapPath(ValuePath): ...


class AsyncValuePath(_Path): ...


class AsyncPath(AsyncValuePath): ...


class AsyncObjectPath(AsyncValuePath): ...


class AsyncClassPath(AsyncValuePath): ...


class AsyncArrayPath(AsyncValuePath): ...


class AsyncMapPath(AsyncValuePath): ...


class SendPath(_Path): ...


class Property(_Path): ...


class SendProperty(_Path): ...


BoolProperty = IntProperty = FloatProperty = StrProperty = Property
AsyncBoolProperty = AsyncIntProperty = AsyncFloatProperty = AsyncStrProperty = Property
SendBoolProperty = SendIntProperty = SendFloatProperty = SendStrProperty = SendProperty

#: NumPy arrays and the like; nothing at run time.
Buffer = Any
Numbers = Any

__all__ = [
    "ArrayPath", "AsyncArrayPath", "AsyncBoolProperty", "AsyncClassPath", "AsyncFloatProperty", "AsyncIntProperty", "AsyncMapPath",
    "AsyncObjectPath", "AsyncPath", "AsyncStrProperty", "AsyncValuePath", "BoolProperty", "Buffer", "ClassPath", "FloatProperty", "Future",
    "IntProperty", "MapPath", "Numbers", "ObjectPath", "Path", "Property", "SendBoolProperty", "SendFloatProperty", "SendIntProperty",
    "SendPath", "SendProperty", "SendStrProperty", "SetPath", "StrProperty", "StructPath", "ValuePath",
]
