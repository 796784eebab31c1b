# SPDX-License-Identifier: MIT
"""Structs of Unreal as Python values.

A struct is a value with Unreal's field names, made with keywords or positions (``FVector(X=4, Y=4, Z=4)``, ``FVector(4, 4, 4)``), equal
to dictionaries with the same content, and convertible both ways (``FVector.from_dict``, ``to_dict``). The mathematical ones also convert
from and to NumPy. Structs without a class here get one when the engine first sends one (:func:`struct_class`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    FloatArray = npt.NDArray[np.float64]

_S = TypeVar("_S", bound="Struct")
_classes: dict[str, type[Struct]] = {}


class Struct:
    """Base of all struct values. Fields are attributes; two structs are equal if name and fields are."""

    __slots__: tuple[str, ...] = ()
    #: Unreal's name of the struct, e.g. ``"FVector"``.
    struct_name: ClassVar[str] = ""
    #: Field names in Unreal's order.
    field_names: ClassVar[tuple[str, ...]] = ()
    #: Wire types of the fields where all of them are numbers ("f64", "f32", "u8", ...): these travel as plain numbers.
    field_types: ClassVar[tuple[str, ...]] = ()
    #: Values of fields that are not given.
    field_defaults: ClassVar[tuple[Any, ...]] = ()

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        if cls.struct_name:
            _classes[cls.struct_name] = cls

    def __init__(self, *values: Any, **fields: Any) -> None:
        names = self.field_names
        if len(values) > len(names):
            raise TypeError(f"{self.struct_name} has {len(names)} fields ({', '.join(names)}), {len(values)} values were given")
        defaults = self.field_defaults or (None,) * len(names)
        for name, default in zip(names, defaults):
            setattr(self, name, default() if callable(default) else default)
        for name, value in zip(names, values):
            setattr(self, name, value)
        for name, value in fields.items():
            if name not in names:
                raise TypeError(f"{self.struct_name} has no field {name!r}; its fields are {', '.join(names)}")
            if name in names[: len(values)]:
                raise TypeError(f"{self.struct_name}: field {name!r} was given twice")
            setattr(self, name, value)

    @classmethod
    def from_dict(cls: type[_S], values: Mapping[str, Any]) -> _S:
        """Makes the struct from a dictionary of its fields; absent ones keep their defaults."""
        return cls(**values)

    def to_dict(self) -> dict[str, Any]:
        """The fields as plain dictionaries, nested structs too."""
        return {name: _plain(getattr(self, name)) for name in self.field_names}

    def copy(self: _S) -> _S:
        """An independent value: nested structs and containers are copied too."""
        import copy

        return copy.deepcopy(self)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Struct):
            return self.struct_name == other.struct_name and all(getattr(self, n) == getattr(other, n) for n in self.field_names)
        if isinstance(other, Mapping):
            return len(other) == len(self.field_names) and all(n in other and getattr(self, n) == other[n] for n in self.field_names)
        return NotImplemented

    __hash__ = None  # type: ignore[assignment]  # mutable values

    def __iter__(self) -> Iterator[Any]:
        """The field values in order, so that ``x, y, z = vector`` works."""
        return (getattr(self, name) for name in self.field_names)

    def __repr__(self) -> str:
        return f"{self.struct_name}({', '.join(f'{name}={getattr(self, name)!r}' for name in self.field_names)})"


def _plain(value: Any) -> Any:
    if isinstance(value, Struct):
        return value.to_dict()
    if isinstance(value, list):
        return [_plain(v) for v in value]
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}
    return value


def struct_class(name: str, field_names: Sequence[str] = ()) -> type[Struct]:
    """The class of a struct by Unreal's name; made on the spot, with the given fields, for one not seen before."""
    known = _classes.get(name)
    if known is not None and (not field_names or known.field_names == tuple(field_names)):
        return known
    names = tuple(field_names)
    slots = tuple(n for n in names if n.isidentifier())
    namespace: dict[str, Any] = {"__slots__": slots if slots == names else ("__dict__",), "struct_name": "", "field_names": names}
    made: type[Struct] = type(name, (Struct,), namespace)
    made.struct_name = name
    _classes.setdefault(name, made)
    return made


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


class FVector2D(_Numbers):
    """A vector in the plane."""

    __slots__ = ("X", "Y")
    struct_name = "FVector2D"
    field_names = ("X", "Y")
    field_types = ("f64", "f64")
    field_defaults = (0.0, 0.0)
    X: float
    Y: float


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
