# SPDX-License-Identifier: MIT
"""Structs of Unreal as Python values.

A struct is a value with Unreal's field names, made with keywords or positions (``FVector(X=4, Y=4, Z=4)``, ``FVector(4, 4, 4)``), equal
to dictionaries with the same content, and convertible both ways (``FVector.from_dict``, ``to_dict``). The mathematical ones also convert
from and to NumPy. Every other struct gets a class when it is imported (``from spear.unreal.Engine import FHitResult``) or when an engine first
sends one (:func:`struct_class`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn, TypeVar

from spear import facts

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    FloatArray = npt.NDArray[np.float64]

_S = TypeVar("_S", bound="Struct")
_classes: dict[str, type[Struct]] = {}
_set = object.__setattr__


class Struct:
    """Base of all struct values. Fields are attributes; two structs are equal if name and fields are.

    A field that was not given is *unset*: it has no value here (AttributeError), it is not sent, and the engine gives it Unreal's own
    default; written to a variable, it leaves that part of the variable as it is. The mathematical structs set every field at once.
    """

    __slots__: tuple[str, ...] = ()
    #: Unreal's name of the struct, e.g. ``"FVector"``.
    struct_name: ClassVar[str] = ""
    #: Unreal's field names in Unreal's order; empty as long as neither facts nor an engine have told them.
    field_names: ClassVar[tuple[str, ...]] = ()
    #: Wire types of the fields where all of them are numbers ("f64", "f32", "u8", ...): these travel as plain numbers.
    field_types: ClassVar[tuple[str, ...]] = ()
    #: Values of fields that are not given; empty: they stay unset.
    field_defaults: ClassVar[tuple[Any, ...]] = ()
    _attributes: ClassVar[tuple[str, ...]] = ()  # the fields' names in Python, in the same order
    _made_here: ClassVar[bool] = False  # by struct_class: fields may become known later

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        if cls.__dict__.get("struct_name"):
            cls._attributes = cls.__dict__.get("_attributes", cls.field_names)
            _classes[cls.struct_name] = cls

    def __init__(self, *values: Any, **fields: Any) -> None:
        names = self._attributes
        if len(values) > len(names):
            if not names:
                _learn(type(self))
                names = self._attributes
            if len(values) > len(names):
                self._refuse_values(len(values))
        for name, default in zip(names, self.field_defaults):
            _set(self, name, default() if callable(default) else default)
        for name, value in zip(names, values):
            _set(self, name, value)
        for name, value in fields.items():
            if name not in names:
                name = self._attribute_of(name)
                names = self._attributes
            if name in names[: len(values)]:
                raise TypeError(f"{self.struct_name}: field {name!r} was given twice")
            _set(self, name, value)

    def _refuse_values(self, count: int) -> NoReturn:
        names = self._attributes
        if not names:
            raise TypeError(f"nothing is known of the order of the fields of {self.struct_name}: give them by name, or write the stubs of the application (spear schema stubs)")
        raise TypeError(f"{self.struct_name} has {len(names)} fields ({', '.join(names)}), {count} values were given")

    @classmethod
    def _attribute_of(cls, name: str) -> str:
        """The attribute of a field named in Unreal's or in Python's way; TypeError if there is none."""
        if name in cls._attributes:
            return name
        if name in cls.field_names:
            return cls._attributes[cls.field_names.index(name)]
        if not cls.field_names and cls._made_here and not _learn(cls):
            return name  # nobody knows better, the engine will
        if name in cls._attributes:
            return name
        raise TypeError(f"{cls.struct_name} has no field {name!r}{facts.advice(name, cls._attributes, 'its fields are')}")

    if not TYPE_CHECKING:  # type checkers know the fields, and no others

        def __getattr__(self, name: str) -> NoReturn:
            if name.startswith("__"):
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            if name in self._attributes:
                raise AttributeError(f"field {name!r} of this {self.struct_name} was not given: the engine will give it Unreal's own default")
            raise AttributeError(f"{self.struct_name} has no field {name!r}{facts.nearest(name, self._attributes)}")

    def _items(self) -> Iterator[tuple[str, Any]]:
        """(Unreal's name, value) of every field that is set."""
        if not self.field_names:
            yield from vars(self).items()
        for name, attribute in zip(self.field_names, self._attributes):
            try:
                yield name, object.__getattribute__(self, attribute)
            except AttributeError:
                pass

    @classmethod
    def from_dict(cls: type[_S], values: Mapping[str, Any]) -> _S:
        """Makes the struct from a dictionary of its fields; absent ones stay unset, or keep their defaults."""
        return cls(**values)

    def to_dict(self) -> dict[str, Any]:
        """The fields that are set as plain dictionaries, by Unreal's names; nested structs too."""
        return {name: _plain(value) for name, value in self._items()}

    def copy(self: _S) -> _S:
        """An independent value: nested structs and containers are copied too."""
        import copy

        return copy.deepcopy(self)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Struct):
            return self.struct_name == other.struct_name and dict(self._items()) == dict(other._items())
        if isinstance(other, Mapping):
            return dict(self._items()) == other
        return NotImplemented

    __hash__ = None  # type: ignore[assignment]  # mutable values

    def __iter__(self) -> Iterator[Any]:
        """The field values in order, so that ``x, y, z = vector`` works."""
        return (getattr(self, name) for name in self._attributes)

    def __dir__(self) -> list[str]:
        return sorted({*object.__dir__(self), *self._attributes})

    def __repr__(self) -> str:
        attributes = dict(zip(self.field_names, self._attributes))
        return f"{self.struct_name}({', '.join(f'{attributes.get(name, name)}={value!r}' for name, value in self._items())})"


def _checked_setattr(self: Struct, name: str, value: Any) -> None:
    """``__setattr__`` of classes made here; those written by hand have slots that do the same."""
    if name not in self._attributes:
        try:
            name = self._attribute_of(name)
        except TypeError as error:
            raise AttributeError(str(error)) from None
    _set(self, name, value)


def _plain(value: Any) -> Any:
    if isinstance(value, Struct):
        return value.to_dict()
    if isinstance(value, list):
        return [_plain(v) for v in value]
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}
    return value


def struct_class(name: str, field_names: Sequence[str] = (), module: str = "") -> type[Struct]:
    """The class of a struct by Unreal's name, always the same one; made on the spot for one not seen before.

    Its fields are those that facts tell, and those given here (an engine's, which come first and count).
    """
    made = _classes.get(name)
    if made is None:
        found = facts.find(module, name) if module else None
        entity = found[1] if found and found[0] == "structs" else {}
        base = struct_class(entity["super"], (), _module_of_struct(entity["super"], module)) if entity.get("super") else Struct
        namespace: dict[str, Any] = {
            "__module__": "spear.unreal." + module if module else "spear.structs", "_made_here": True, "struct_name": name,
            "field_names": (), "field_types": (), "field_defaults": (), "_attributes": (), "__setattr__": _checked_setattr,
        }
        made = type(name, (base,), namespace)
        fields = tuple(entity.get("fields") or ())
        if base is not Struct and fields == base.field_names:  # FVector_NetQuantize is an FVector in all but name
            made.field_types, made.field_defaults = base.field_types, base.field_defaults
        _set_fields(made, fields, entity.get("names"))
    if field_names and made.field_names != tuple(field_names):
        if not made._made_here:
            # An engine whose FVector is not ours: a class of its own, so that nothing is lost.
            other: type[Struct] = type(name, (Struct,), {"_made_here": True, "__module__": "spear.structs", "__setattr__": _checked_setattr})
            other.struct_name = name
            _set_fields(other, tuple(field_names))
            return other
        _set_fields(made, (*field_names, *(field for field in made.field_names if field not in field_names)))
    return made


def _set_fields(cls: type[Struct], fields: tuple[str, ...], names: Mapping[str, str] | None = None) -> None:
    if not fields:
        return
    from spear.codegen.names import ScopeNames

    python = ScopeNames(fields, "field")
    given = {unreal: attribute for attribute, unreal in (names or {}).items()}
    given.update(zip(cls.field_names, cls._attributes))  # an attribute keeps its name
    if not set(cls.field_names) <= set(fields) or (cls.field_defaults and cls.field_names != fields):
        cls.field_types, cls.field_defaults = (), ()
    cls._attributes = tuple(given.get(field) or python[field] for field in fields)
    cls.field_names = fields


def _module_of_struct(name: str, module: str) -> str:
    """The module of a struct that one of a module derives from."""
    for candidate in (module, "CoreUObject", "Engine"):
        known = facts.from_files(candidate)
        if known is not None and name in known.structs:
            return candidate
    return next((known.module for known in facts.all_files() if name in known.structs), "")


def _learn(cls: type[Struct]) -> bool:
    """Asks facts and connected engines for the fields of a class made without; whether they are known now."""
    module = cls.__module__.rpartition("spear.unreal.")[2] if cls.__module__.startswith("spear.unreal.") else ""
    if module and cls._made_here and not cls.field_names:
        for source in [facts.from_files(module), *facts.from_engines(module)]:
            entity = source.structs.get(cls.struct_name) if source is not None else None
            if entity is not None:
                _set_fields(cls, tuple(entity.get("fields") or ()), entity.get("names"))
                break
    return bool(cls.field_names)


# For the native half ---------------------------------------------------------------------------------------------------------------------


def announced(name: str, path: str, field_names: Sequence[str]) -> tuple[type[Struct], tuple[str, ...]]:
    """A struct as an engine has it: the class, and the attributes of its fields in the engine's order."""
    cls = struct_class(name, field_names, facts.module_of_path(path))
    attributes = dict(zip(cls.field_names, cls._attributes))
    return cls, tuple(attributes[field] for field in field_names)


class _Numbers(Struct):
    """A struct of numbers only, convertible from and to a one-dimensional NumPy array of its fields in order."""

    __slots__ = ()

    @classmethod
    def from_numpy(cls: type[_S], array: npt.ArrayLike) -> _S:
        """From an array of as many numbers as there are fields, in field order."""
        import numpy as np

        values = np.asarray(array)
        if values.shape != (len(cls.field_names),):
            raise ValueError(f"{cls.struct_name} needs an array of shape ({len(cls.field_names)},), got {values.shape}")
        return cls(*values.tolist())

    def to_numpy(self, dtype: npt.DTypeLike | None = None) -> npt.NDArray[Any]:
        """The fields in order as an array (float64 unless told)."""
        import numpy as np

        return np.array([getattr(self, name) for name in self.field_names], dtype=dtype or np.float64)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        return self.to_numpy(dtype)


class FVector(_Numbers):
    """A vector in centimetres (or without unit), left-handed, Z up."""

    __slots__ = ("X", "Y", "Z")
    struct_name = "FVector"
    field_names = ("X", "Y", "Z")
    field_types = ("f64", "f64", "f64")
    field_defaults = (0.0, 0.0, 0.0)
    X: float
    Y: float
    Z: float

    if TYPE_CHECKING:

        def __init__(self, X: float = ..., Y: float = ..., Z: float = ...) -> None: ...


class FVector2D(_Numbers):
    """A vector in the plane."""

    __slots__ = ("X", "Y")
    struct_name = "FVector2D"
    field_names = ("X", "Y")
    field_types = ("f64", "f64")
    field_defaults = (0.0, 0.0)
    X: float
    Y: float

    if TYPE_CHECKING:

        def __init__(self, X: float = ..., Y: float = ...) -> None: ...


class FVector4(_Numbers):
    """A homogeneous vector."""

    __slots__ = ("X", "Y", "Z", "W")
    struct_name = "FVector4"
    field_names = ("X", "Y", "Z", "W")
    field_types = ("f64", "f64", "f64", "f64")
    field_defaults = (0.0, 0.0, 0.0, 1.0)
    X: float
    Y: float
    Z: float
    W: float

    if TYPE_CHECKING:

        def __init__(self, X: float = ..., Y: float = ..., Z: float = ..., W: float = ...) -> None: ...


class FRotator(_Numbers):
    """A rotation in degrees: roll about X, then pitch about Y, then yaw about Z (Unreal's convention)."""

    __slots__ = ("Pitch", "Yaw", "Roll")
    struct_name = "FRotator"
    field_names = ("Pitch", "Yaw", "Roll")
    field_types = ("f64", "f64", "f64")
    field_defaults = (0.0, 0.0, 0.0)
    Pitch: float
    Yaw: float
    Roll: float

    if TYPE_CHECKING:

        def __init__(self, Pitch: float = ..., Yaw: float = ..., Roll: float = ...) -> None: ...

    def to_matrix(self) -> FloatArray:
        """The 3x3 rotation matrix for column vectors: ``m @ v`` rotates ``v`` as ``FRotator::RotateVector`` does."""
        import numpy as np

        p, y, r = np.radians([self.Pitch, self.Yaw, self.Roll])
        sp, cp, sy, cy, sr, cr = np.sin(p), np.cos(p), np.sin(y), np.cos(y), np.sin(r), np.cos(r)
        return np.array([
            [cp * cy, sr * sp * cy - cr * sy, -(cr * sp * cy + sr * sy)],
            [cp * sy, sr * sp * sy + cr * cy, cy * sr - cr * sp * sy],
            [sp, -sr * cp, cr * cp],
        ])

    @classmethod
    def from_matrix(cls, matrix: npt.ArrayLike) -> FRotator:
        """The rotator of a 3x3 rotation matrix for column vectors."""
        import numpy as np

        m = np.asarray(matrix, dtype=np.float64)
        if m.shape != (3, 3):
            raise ValueError(f"a rotation matrix has shape (3, 3), got {m.shape}")
        pitch = np.degrees(np.arctan2(m[2, 0], np.hypot(m[0, 0], m[1, 0])))
        yaw = np.degrees(np.arctan2(m[1, 0], m[0, 0]))
        roll = np.degrees(np.arctan2(-m[2, 1], m[2, 2]))
        return cls(Pitch=float(pitch), Yaw=float(yaw), Roll=float(roll))


class FQuat(_Numbers):
    """A rotation as a unit quaternion, W last."""

    __slots__ = ("X", "Y", "Z", "W")
    struct_name = "FQuat"
    field_names = ("X", "Y", "Z", "W")
    field_types = ("f64", "f64", "f64", "f64")
    field_defaults = (0.0, 0.0, 0.0, 1.0)
    X: float
    Y: float
    Z: float
    W: float

    if TYPE_CHECKING:

        def __init__(self, X: float = ..., Y: float = ..., Z: float = ..., W: float = ...) -> None: ...

    def to_matrix(self) -> FloatArray:
        """The 3x3 rotation matrix for column vectors; the quaternion is normalised first."""
        import numpy as np

        q = self.to_numpy()
        norm = float(np.linalg.norm(q))
        if norm == 0.0:
            raise ValueError("a quaternion of length zero is no rotation")
        x, y, z, w = q / norm
        return np.array([
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ])

    @classmethod
    def from_matrix(cls, matrix: npt.ArrayLike) -> FQuat:
        """The unit quaternion of a 3x3 rotation matrix for column vectors, with W >= 0."""
        import numpy as np

        m = np.asarray(matrix, dtype=np.float64)
        if m.shape != (3, 3):
            raise ValueError(f"a rotation matrix has shape (3, 3), got {m.shape}")
        # The largest component first (Shepperd's method): no cancellation.
        candidates = np.array([m[0, 0], m[1, 1], m[2, 2], np.trace(m)])
        i = int(np.argmax(candidates))
        q = np.empty(4)
        if i == 3:
            q[:] = m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 1 + candidates[3]
        else:
            j, k = (i + 1) % 3, (i + 2) % 3
            q[i] = 1 + m[i, i] - m[j, j] - m[k, k]
            q[j] = m[j, i] + m[i, j]
            q[k] = m[k, i] + m[i, k]
            q[3] = m[k, j] - m[j, k]
        q /= np.linalg.norm(q)
        return cls(*(q if q[3] >= 0 else -q).tolist())


class FTransform(Struct):
    """Scale, then rotate, then translate."""

    __slots__ = ("Rotation", "Translation", "Scale3D")
    struct_name = "FTransform"
    field_names = ("Rotation", "Translation", "Scale3D")
    field_defaults = (FQuat, FVector, lambda: FVector(1.0, 1.0, 1.0))
    Rotation: FQuat
    Translation: FVector
    Scale3D: FVector

    if TYPE_CHECKING:

        def __init__(self, Rotation: FQuat = ..., Translation: FVector = ..., Scale3D: FVector = ...) -> None: ...

    def to_numpy(self) -> FloatArray:
        """The 4x4 matrix for column vectors: ``m @ [x, y, z, 1]`` transforms a point."""
        import numpy as np

        m = np.eye(4)
        m[:3, :3] = self.Rotation.to_matrix() * self.Scale3D.to_numpy()
        m[:3, 3] = self.Translation.to_numpy()
        return m

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        m = self.to_numpy()
        return m if dtype is None else m.astype(dtype)

    @classmethod
    def from_numpy(cls, matrix: npt.ArrayLike) -> FTransform:
        """From a 4x4 matrix for column vectors without shear; a mirrored one gets a negative X scale, as in Unreal."""
        import numpy as np

        m = np.asarray(matrix, dtype=np.float64)
        if m.shape != (4, 4):
            raise ValueError(f"a transform matrix has shape (4, 4), got {m.shape}")
        scale = np.linalg.norm(m[:3, :3], axis=0)
        if np.linalg.det(m[:3, :3]) < 0:
            scale[0] = -scale[0]
        rotation = np.divide(m[:3, :3], scale, out=np.eye(3), where=scale != 0)
        return cls(FQuat.from_matrix(rotation), FVector.from_numpy(m[:3, 3]), FVector.from_numpy(scale))


class FLinearColor(_Numbers):
    """A colour in linear light, 1.0 is white."""

    __slots__ = ("R", "G", "B", "A")
    struct_name = "FLinearColor"
    field_names = ("R", "G", "B", "A")
    field_types = ("f32", "f32", "f32", "f32")
    field_defaults = (0.0, 0.0, 0.0, 1.0)
    R: float
    G: float
    B: float
    A: float

    if TYPE_CHECKING:

        def __init__(self, R: float = ..., G: float = ..., B: float = ..., A: float = ...) -> None: ...


class FColor(_Numbers):
    """An 8-bit sRGB colour. Unreal's field order is B, G, R, A; ``to_numpy`` gives R, G, B, A."""

    __slots__ = ("B", "G", "R", "A")
    struct_name = "FColor"
    field_names = ("B", "G", "R", "A")
    field_types = ("u8", "u8", "u8", "u8")
    field_defaults = (0, 0, 0, 255)
    B: int
    G: int
    R: int
    A: int

    if TYPE_CHECKING:

        def __init__(self, B: int = ..., G: int = ..., R: int = ..., A: int = ...) -> None: ...

    def to_numpy(self, dtype: npt.DTypeLike | None = None) -> npt.NDArray[Any]:
        """R, G, B, A as uint8."""
        import numpy as np

        return np.array([self.R, self.G, self.B, self.A], dtype=dtype or np.uint8)

    @classmethod
    def from_numpy(cls: type[_S], array: npt.ArrayLike) -> _S:
        """From R, G, B, A."""
        import numpy as np

        values = np.asarray(array)
        if values.shape != (4,):
            raise ValueError(f"FColor needs an array of shape (4,), got {values.shape}")
        red, green, blue, alpha = values.tolist()
        return cls(R=red, G=green, B=blue, A=alpha)
