# SPDX-License-Identifier: MIT
"""Structs of Unreal as Python values.

A struct is a value with Unreal's field names, made with keywords or positions (``FVector(X=4, Y=4, Z=4)``, ``FVector(4, 4, 4)``), equal
to dictionaries with the same content, and convertible both ways (``FVector.from_dict``, ``to_dict``). The mathematical ones also convert
from and to NumPy. Every other struct gets a class when it is imported (``from spear.unreal.Engine import FHitResult``) or when an engine first
sends one (:func:`struct_class`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from spear.struct_base import Struct as Struct
from spear.struct_base import announced as announced
from spear.struct_base import struct_class as struct_class

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    FloatArray = npt.NDArray[np.float64]

_S = TypeVar("_S", bound=Struct)


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
