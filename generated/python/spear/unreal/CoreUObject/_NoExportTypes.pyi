# generated, do not edit (CoreUObject: Public/UObject/NoExportTypes.h)
from typing import TypeAlias, TypedDict
from spear.enums import UnrealEnum
from spear.structs import Struct
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncIntProperty, AsyncObjectPath, AsyncStrProperty, AsyncValuePath, BoolProperty, FloatProperty, Future,
    IntProperty, Numbers, ObjectPath, Property, StrProperty, StructPath,
)
from spear.unreal_object import AsyncBase, ObjectBase, SendBase

class ESearchCase(UnrealEnum):
    """Whether letters of different case are equal when text is compared.

    Unreal: /Script/CoreUObject.ESearchCase
    """
    CaseSensitive = 0
    IgnoreCase = 1

ESearchCase_in: TypeAlias = ESearchCase | str | Future[ESearchCase]
"""What stands for ESearchCase as an argument: an entry, the name that Unreal gives it, a future."""

class ESearchDir(UnrealEnum):
    """The end of a text at which a search starts.

    Unreal: /Script/CoreUObject.ESearchDir
    """
    FromStart = 0
    FromEnd = 1

ESearchDir_in: TypeAlias = ESearchDir | str | Future[ESearchDir]
"""What stands for ESearchDir as an argument: an entry, the name that Unreal gives it, a future."""

class EAxis(UnrealEnum):
    """An axis, or none.

    Unreal: /Script/CoreUObject.EAxis
    """
    None_ = 0
    X = 1
    Y = 2
    Z = 3

EAxis_in: TypeAlias = EAxis | str | Future[EAxis]
"""What stands for EAxis as an argument: an entry, the name that Unreal gives it, a future."""

from spear.structs import FVector as FVector

class FVector_dict(TypedDict, total=False):
    """Any of the fields of FVector: what a dictionary for it may hold."""
    X: float | Future[float]
    Y: float | Future[float]
    Z: float | Future[float]

FVector_in: TypeAlias = FVector | FVector_dict | Future[FVector] | Numbers
"""What stands for FVector as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector_members:
    """The fields of FVector, as paths."""
    X: FloatProperty
    """X component."""
    Y: FloatProperty
    """Y component."""
    Z: FloatProperty
    """Z component."""

class FVector_async_members:
    """The fields of FVector, as paths under ``async_``."""
    X: AsyncFloatProperty
    Y: AsyncFloatProperty
    Z: AsyncFloatProperty

class FVector_path(StructPath[FVector, FVector_in, FVector_async], FVector_members):
    """A variable of type FVector: its path."""

class FVector_async(AsyncValuePath[FVector, FVector_in], FVector_async_members):
    """The same under ``async_``."""

class FVector3f(Struct):
    """A point or direction in 3D space (single precision).

    Unreal: /Script/CoreUObject.Vector3f
    """
    def __init__(self, X: float = ..., Y: float = ..., Z: float = ...) -> None: ...
    X: float
    """X component."""
    Y: float
    """Y component."""
    Z: float
    """Z component."""

class FVector3f_dict(TypedDict, total=False):
    """Any of the fields of FVector3f: what a dictionary for it may hold."""
    X: float | Future[float]
    Y: float | Future[float]
    Z: float | Future[float]

FVector3f_in: TypeAlias = FVector3f | FVector3f_dict | Future[FVector3f] | Numbers
"""What stands for FVector3f as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector3f_members:
    """The fields of FVector3f, as paths."""
    X: FloatProperty
    """X component."""
    Y: FloatProperty
    """Y component."""
    Z: FloatProperty
    """Z component."""

class FVector3f_async_members:
    """The fields of FVector3f, as paths under ``async_``."""
    X: AsyncFloatProperty
    Y: AsyncFloatProperty
    Z: AsyncFloatProperty

class FVector3f_path(StructPath[FVector3f, FVector3f_in, FVector3f_async], FVector3f_members):
    """A variable of type FVector3f: its path."""

class FVector3f_async(AsyncValuePath[FVector3f, FVector3f_in], FVector3f_async_members):
    """The same under ``async_``."""

from spear.structs import FVector2D as FVector2D

class FVector2D_dict(TypedDict, total=False):
    """Any of the fields of FVector2D: what a dictionary for it may hold."""
    X: float | Future[float]
    Y: float | Future[float]

FVector2D_in: TypeAlias = FVector2D | FVector2D_dict | Future[FVector2D] | Numbers
"""What stands for FVector2D as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector2D_path(StructPath[FVector2D, FVector2D_in, FVector2D_async]):
    """A variable of type FVector2D: its path."""
    X: FloatProperty
    """X component."""
    Y: FloatProperty
    """Y component."""

class FVector2D_async(AsyncValuePath[FVector2D, FVector2D_in]):
    """The same under ``async_``."""
    X: AsyncFloatProperty
    Y: AsyncFloatProperty

class FVector2f(Struct):
    """A point or direction in 2D space (single precision).

    Unreal: /Script/CoreUObject.Vector2f
    """
    def __init__(self, X: float = ..., Y: float = ...) -> None: ...
    X: float
    """X component."""
    Y: float
    """Y component."""

class FVector2f_dict(TypedDict, total=False):
    """Any of the fields of FVector2f: what a dictionary for it may hold."""
    X: float | Future[float]
    Y: float | Future[float]

FVector2f_in: TypeAlias = FVector2f | FVector2f_dict | Future[FVector2f] | Numbers
"""What stands for FVector2f as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector2f_path(StructPath[FVector2f, FVector2f_in, FVector2f_async]):
    """A variable of type FVector2f: its path."""
    X: FloatProperty
    """X component."""
    Y: FloatProperty
    """Y component."""

class FVector2f_async(AsyncValuePath[FVector2f, FVector2f_in]):
    """The same under ``async_``."""
    X: AsyncFloatProperty
    Y: AsyncFloatProperty

from spear.structs import FVector4 as FVector4

class FVector4_dict(TypedDict, total=False):
    """Any of the fields of FVector4: what a dictionary for it may hold."""
    X: float | Future[float]
    Y: float | Future[float]
    Z: float | Future[float]
    W: float | Future[float]

FVector4_in: TypeAlias = FVector4 | FVector4_dict | Future[FVector4] | Numbers
"""What stands for FVector4 as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector4_path(StructPath[FVector4, FVector4_in, FVector4_async]):
    """A variable of type FVector4: its path."""
    X: FloatProperty
    """X component."""
    Y: FloatProperty
    """Y component."""
    Z: FloatProperty
    """Z component."""
    W: FloatProperty
    """W component."""

class FVector4_async(AsyncValuePath[FVector4, FVector4_in]):
    """The same under ``async_``."""
    X: AsyncFloatProperty
    Y: AsyncFloatProperty
    Z: AsyncFloatProperty
    W: AsyncFloatProperty

class FVector4f(Struct):
    """A 4D homogeneous vector (single precision).

    Unreal: /Script/CoreUObject.Vector4f
    """
    def __init__(self, X: float = ..., Y: float = ..., Z: float = ..., W: float = ...) -> None: ...
    X: float
    """X component."""
    Y: float
    """Y component."""
    Z: float
    """Z component."""
    W: float
    """W component."""

class FVector4f_dict(TypedDict, total=False):
    """Any of the fields of FVector4f: what a dictionary for it may hold."""
    X: float | Future[float]
    Y: float | Future[float]
    Z: float | Future[float]
    W: float | Future[float]

FVector4f_in: TypeAlias = FVector4f | FVector4f_dict | Future[FVector4f] | Numbers
"""What stands for FVector4f as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector4f_path(StructPath[FVector4f, FVector4f_in, FVector4f_async]):
    """A variable of type FVector4f: its path."""
    X: FloatProperty
    """X component."""
    Y: FloatProperty
    """Y component."""
    Z: FloatProperty
    """Z component."""
    W: FloatProperty
    """W component."""

class FVector4f_async(AsyncValuePath[FVector4f, FVector4f_in]):
    """The same under ``async_``."""
    X: AsyncFloatProperty
    Y: AsyncFloatProperty
    Z: AsyncFloatProperty
    W: AsyncFloatProperty

class FPlane(FVector):
    """A plane in 3D space: points with X*Px + Y*Py + Z*Pz = W.

    Unreal: /Script/CoreUObject.Plane
    """
    def __init__(self, X: float = ..., Y: float = ..., Z: float = ..., W: float = ...) -> None: ...
    W: float
    """Distance along the normal."""

class FPlane_dict(FVector_dict, total=False):
    """Any of the fields of FPlane: what a dictionary for it may hold."""
    W: float | Future[float]

FPlane_in: TypeAlias = FPlane | FPlane_dict | Future[FPlane] | Numbers
"""What stands for FPlane as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FPlane_members(FVector_members):
    """The fields of FPlane, as paths."""
    W: FloatProperty
    """Distance along the normal."""

class FPlane_async_members(FVector_async_members):
    """The fields of FPlane, as paths under ``async_``."""
    W: AsyncFloatProperty

class FPlane_path(StructPath[FPlane, FPlane_in, FPlane_async], FPlane_members):
    """A variable of type FPlane: its path."""

class FPlane_async(AsyncValuePath[FPlane, FPlane_in], FPlane_async_members):
    """The same under ``async_``."""

class FPlane4f(FVector3f):
    """A plane in 3D space (single precision).

    Unreal: /Script/CoreUObject.Plane4f
    """
    def __init__(self, X: float = ..., Y: float = ..., Z: float = ..., W: float = ...) -> None: ...
    W: float
    """Distance along the normal."""

class FPlane4f_dict(FVector3f_dict, total=False):
    """Any of the fields of FPlane4f: what a dictionary for it may hold."""
    W: float | Future[float]

FPlane4f_in: TypeAlias = FPlane4f | FPlane4f_dict | Future[FPlane4f] | Numbers
"""What stands for FPlane4f as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FPlane4f_members(FVector3f_members):
    """The fields of FPlane4f, as paths."""
    W: FloatProperty
    """Distance along the normal."""

class FPlane4f_async_members(FVector3f_async_members):
    """The fields of FPlane4f, as paths under ``async_``."""
    W: AsyncFloatProperty

class FPlane4f_path(StructPath[FPlane4f, FPlane4f_in, FPlane4f_async], FPlane4f_members):
    """A variable of type FPlane4f: its path."""

class FPlane4f_async(AsyncValuePath[FPlane4f, FPlane4f_in], FPlane4f_async_members):
    """The same under ``async_``."""

from spear.structs import FRotator as FRotator

class FRotator_dict(TypedDict, total=False):
    """Any of the fields of FRotator: what a dictionary for it may hold."""
    Pitch: float | Future[float]
    Yaw: float | Future[float]
    Roll: float | Future[float]

FRotator_in: TypeAlias = FRotator | FRotator_dict | Future[FRotator] | Numbers
"""What stands for FRotator as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FRotator_path(StructPath[FRotator, FRotator_in, FRotator_async]):
    """A variable of type FRotator: its path."""
    Pitch: FloatProperty
    """Rotation around the right axis (Y), looking up and down (0 = straight ahead, + = up)."""
    Yaw: FloatProperty
    """Rotation around the up axis (Z), turning around (0 = forward, + = right)."""
    Roll: FloatProperty
    """Rotation around the forward axis (X), tilting the head (0 = straight, + = clockwise)."""

class FRotator_async(AsyncValuePath[FRotator, FRotator_in]):
    """The same under ``async_``."""
    Pitch: AsyncFloatProperty
    Yaw: AsyncFloatProperty
    Roll: AsyncFloatProperty

class FRotator3f(Struct):
    """A rotation in degrees.

    Unreal: /Script/CoreUObject.Rotator3f
    """
    def __init__(self, Pitch: float = ..., Yaw: float = ..., Roll: float = ...) -> None: ...
    Pitch: float
    """Rotation around the right axis (Y), looking up and down (0 = straight ahead, + = up)."""
    Yaw: float
    """Rotation around the up axis (Z), turning around (0 = forward, + = right)."""
    Roll: float
    """Rotation around the forward axis (X), tilting the head (0 = straight, + = clockwise)."""

class FRotator3f_dict(TypedDict, total=False):
    """Any of the fields of FRotator3f: what a dictionary for it may hold."""
    Pitch: float | Future[float]
    Yaw: float | Future[float]
    Roll: float | Future[float]

FRotator3f_in: TypeAlias = FRotator3f | FRotator3f_dict | Future[FRotator3f] | Numbers
"""What stands for FRotator3f as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FRotator3f_path(StructPath[FRotator3f, FRotator3f_in, FRotator3f_async]):
    """A variable of type FRotator3f: its path."""
    Pitch: FloatProperty
    """Rotation around the right axis (Y), looking up and down (0 = straight ahead, + = up)."""
    Yaw: FloatProperty
    """Rotation around the up axis (Z), turning around (0 = forward, + = right)."""
    Roll: FloatProperty
    """Rotation around the forward axis (X), tilting the head (0 = straight, + = clockwise)."""

class FRotator3f_async(AsyncValuePath[FRotator3f, FRotator3f_in]):
    """The same under ``async_``."""
    Pitch: AsyncFloatProperty
    Yaw: AsyncFloatProperty
    Roll: AsyncFloatProperty

from spear.structs import FQuat as FQuat

class FQuat_dict(TypedDict, total=False):
    """Any of the fields of FQuat: what a dictionary for it may hold."""
    X: float | Future[float]
    Y: float | Future[float]
    Z: float | Future[float]
    W: float | Future[float]

FQuat_in: TypeAlias = FQuat | FQuat_dict | Future[FQuat] | Numbers
"""What stands for FQuat as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FQuat_path(StructPath[FQuat, FQuat_in, FQuat_async]):
    """A variable of type FQuat: its path."""
    X: FloatProperty
    """X component."""
    Y: FloatProperty
    """Y component."""
    Z: FloatProperty
    """Z component."""
    W: FloatProperty
    """W component."""

class FQuat_async(AsyncValuePath[FQuat, FQuat_in]):
    """The same under ``async_``."""
    X: AsyncFloatProperty
    Y: AsyncFloatProperty
    Z: AsyncFloatProperty
    W: AsyncFloatProperty

class FQuat4f(Struct):
    """A rotation as a quaternion (single precision).

    Unreal: /Script/CoreUObject.Quat4f
    """
    def __init__(self, X: float = ..., Y: float = ..., Z: float = ..., W: float = ...) -> None: ...
    X: float
    """X component."""
    Y: float
    """Y component."""
    Z: float
    """Z component."""
    W: float
    """W component."""

class FQuat4f_dict(TypedDict, total=False):
    """Any of the fields of FQuat4f: what a dictionary for it may hold."""
    X: float | Future[float]
    Y: float | Future[float]
    Z: float | Future[float]
    W: float | Future[float]

FQuat4f_in: TypeAlias = FQuat4f | FQuat4f_dict | Future[FQuat4f] | Numbers
"""What stands for FQuat4f as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FQuat4f_path(StructPath[FQuat4f, FQuat4f_in, FQuat4f_async]):
    """A variable of type FQuat4f: its path."""
    X: FloatProperty
    """X component."""
    Y: FloatProperty
    """Y component."""
    Z: FloatProperty
    """Z component."""
    W: FloatProperty
    """W component."""

class FQuat4f_async(AsyncValuePath[FQuat4f, FQuat4f_in]):
    """The same under ``async_``."""
    X: AsyncFloatProperty
    Y: AsyncFloatProperty
    Z: AsyncFloatProperty
    W: AsyncFloatProperty

from spear.structs import FTransform as FTransform

class FTransform_dict(TypedDict, total=False):
    """Any of the fields of FTransform: what a dictionary for it may hold."""
    Rotation: FQuat_in
    Translation: FVector_in
    Scale3D: FVector_in

FTransform_in: TypeAlias = FTransform | FTransform_dict | Future[FTransform]
"""What stands for FTransform as an argument: itself, a dictionary of its fields, a future."""

class FTransform_path(StructPath[FTransform, FTransform_in, FTransform_async]):
    """A variable of type FTransform: its path."""
    Rotation: Property[FQuat_path, FQuat_in]
    """Rotation as a quaternion."""
    Translation: Property[FVector_path, FVector_in]
    """Translation in centimetres."""
    Scale3D: Property[FVector_path, FVector_in]
    """Scale along the local axes."""

class FTransform_async(AsyncValuePath[FTransform, FTransform_in]):
    """The same under ``async_``."""
    Rotation: Property[FQuat_async, FQuat_in]
    Translation: Property[FVector_async, FVector_in]
    Scale3D: Property[FVector_async, FVector_in]

class FTransform3f(Struct):
    """Scale, rotation and translation, applied in this order.

    Unreal: /Script/CoreUObject.Transform3f
    """
    def __init__(self, Rotation: FQuat4f = ..., Translation: FVector3f = ..., Scale3D: FVector3f = ...) -> None: ...
    Rotation: FQuat4f
    """Rotation as a quaternion."""
    Translation: FVector3f
    """Translation in centimetres."""
    Scale3D: FVector3f
    """Scale along the local axes."""

class FTransform3f_dict(TypedDict, total=False):
    """Any of the fields of FTransform3f: what a dictionary for it may hold."""
    Rotation: FQuat4f_in
    Translation: FVector3f_in
    Scale3D: FVector3f_in

FTransform3f_in: TypeAlias = FTransform3f | FTransform3f_dict | Future[FTransform3f]
"""What stands for FTransform3f as an argument: itself, a dictionary of its fields, a future."""

class FTransform3f_path(StructPath[FTransform3f, FTransform3f_in, FTransform3f_async]):
    """A variable of type FTransform3f: its path."""
    Rotation: Property[FQuat4f_path, FQuat4f_in]
    """Rotation as a quaternion."""
    Translation: Property[FVector3f_path, FVector3f_in]
    """Translation in centimetres."""
    Scale3D: Property[FVector3f_path, FVector3f_in]
    """Scale along the local axes."""

class FTransform3f_async(AsyncValuePath[FTransform3f, FTransform3f_in]):
    """The same under ``async_``."""
    Rotation: Property[FQuat4f_async, FQuat4f_in]
    Translation: Property[FVector3f_async, FVector3f_in]
    Scale3D: Property[FVector3f_async, FVector3f_in]

class FMatrix(Struct):
    """A 4x4 matrix, row vectors times matrix.

    Unreal: /Script/CoreUObject.Matrix
    """
    def __init__(self, XPlane: FPlane = ..., YPlane: FPlane = ..., ZPlane: FPlane = ..., WPlane: FPlane = ...) -> None: ...
    XPlane: FPlane
    """X row."""
    YPlane: FPlane
    """Y row."""
    ZPlane: FPlane
    """Z row."""
    WPlane: FPlane
    """W row."""

class FMatrix_dict(TypedDict, total=False):
    """Any of the fields of FMatrix: what a dictionary for it may hold."""
    XPlane: FPlane_in
    YPlane: FPlane_in
    ZPlane: FPlane_in
    WPlane: FPlane_in

FMatrix_in: TypeAlias = FMatrix | FMatrix_dict | Future[FMatrix]
"""What stands for FMatrix as an argument: itself, a dictionary of its fields, a future."""

class FMatrix_path(StructPath[FMatrix, FMatrix_in, FMatrix_async]):
    """A variable of type FMatrix: its path."""
    XPlane: Property[FPlane_path, FPlane_in]
    """X row."""
    YPlane: Property[FPlane_path, FPlane_in]
    """Y row."""
    ZPlane: Property[FPlane_path, FPlane_in]
    """Z row."""
    WPlane: Property[FPlane_path, FPlane_in]
    """W row."""

class FMatrix_async(AsyncValuePath[FMatrix, FMatrix_in]):
    """The same under ``async_``."""
    XPlane: Property[FPlane_async, FPlane_in]
    YPlane: Property[FPlane_async, FPlane_in]
    ZPlane: Property[FPlane_async, FPlane_in]
    WPlane: Property[FPlane_async, FPlane_in]

class FMatrix44f(Struct):
    """A 4x4 matrix, row vectors times matrix.

    Unreal: /Script/CoreUObject.Matrix44f
    """
    def __init__(self, XPlane: FPlane4f = ..., YPlane: FPlane4f = ..., ZPlane: FPlane4f = ..., WPlane: FPlane4f = ...) -> None: ...
    XPlane: FPlane4f
    """X row."""
    YPlane: FPlane4f
    """Y row."""
    ZPlane: FPlane4f
    """Z row."""
    WPlane: FPlane4f
    """W row."""

class FMatrix44f_dict(TypedDict, total=False):
    """Any of the fields of FMatrix44f: what a dictionary for it may hold."""
    XPlane: FPlane4f_in
    YPlane: FPlane4f_in
    ZPlane: FPlane4f_in
    WPlane: FPlane4f_in

FMatrix44f_in: TypeAlias = FMatrix44f | FMatrix44f_dict | Future[FMatrix44f]
"""What stands for FMatrix44f as an argument: itself, a dictionary of its fields, a future."""

class FMatrix44f_path(StructPath[FMatrix44f, FMatrix44f_in, FMatrix44f_async]):
    """A variable of type FMatrix44f: its path."""
    XPlane: Property[FPlane4f_path, FPlane4f_in]
    """X row."""
    YPlane: Property[FPlane4f_path, FPlane4f_in]
    """Y row."""
    ZPlane: Property[FPlane4f_path, FPlane4f_in]
    """Z row."""
    WPlane: Property[FPlane4f_path, FPlane4f_in]
    """W row."""

class FMatrix44f_async(AsyncValuePath[FMatrix44f, FMatrix44f_in]):
    """The same under ``async_``."""
    XPlane: Property[FPlane4f_async, FPlane4f_in]
    YPlane: Property[FPlane4f_async, FPlane4f_in]
    ZPlane: Property[FPlane4f_async, FPlane4f_in]
    WPlane: Property[FPlane4f_async, FPlane4f_in]

class FBox(Struct):
    """An axis-aligned box.

    Unreal: /Script/CoreUObject.Box
    """
    def __init__(self, Min: FVector = ..., Max: FVector = ..., IsValid: int = ...) -> None: ...
    Min: FVector
    """Smallest corner."""
    Max: FVector
    """Largest corner."""
    IsValid: int
    """1 if the box holds a point."""

class FBox_dict(TypedDict, total=False):
    """Any of the fields of FBox: what a dictionary for it may hold."""
    Min: FVector_in
    Max: FVector_in
    IsValid: int | Future[int]

FBox_in: TypeAlias = FBox | FBox_dict | Future[FBox]
"""What stands for FBox as an argument: itself, a dictionary of its fields, a future."""

class FBox_path(StructPath[FBox, FBox_in, FBox_async]):
    """A variable of type FBox: its path."""
    Min: Property[FVector_path, FVector_in]
    """Smallest corner."""
    Max: Property[FVector_path, FVector_in]
    """Largest corner."""
    IsValid: IntProperty
    """1 if the box holds a point."""

class FBox_async(AsyncValuePath[FBox, FBox_in]):
    """The same under ``async_``."""
    Min: Property[FVector_async, FVector_in]
    Max: Property[FVector_async, FVector_in]
    IsValid: AsyncIntProperty

class FBox3f(Struct):
    """An axis-aligned box.

    Unreal: /Script/CoreUObject.Box3f
    """
    def __init__(self, Min: FVector3f = ..., Max: FVector3f = ..., IsValid: int = ...) -> None: ...
    Min: FVector3f
    """Smallest corner."""
    Max: FVector3f
    """Largest corner."""
    IsValid: int
    """1 if the box holds a point."""

class FBox3f_dict(TypedDict, total=False):
    """Any of the fields of FBox3f: what a dictionary for it may hold."""
    Min: FVector3f_in
    Max: FVector3f_in
    IsValid: int | Future[int]

FBox3f_in: TypeAlias = FBox3f | FBox3f_dict | Future[FBox3f]
"""What stands for FBox3f as an argument: itself, a dictionary of its fields, a future."""

class FBox3f_path(StructPath[FBox3f, FBox3f_in, FBox3f_async]):
    """A variable of type FBox3f: its path."""
    Min: Property[FVector3f_path, FVector3f_in]
    """Smallest corner."""
    Max: Property[FVector3f_path, FVector3f_in]
    """Largest corner."""
    IsValid: IntProperty
    """1 if the box holds a point."""

class FBox3f_async(AsyncValuePath[FBox3f, FBox3f_in]):
    """The same under ``async_``."""
    Min: Property[FVector3f_async, FVector3f_in]
    Max: Property[FVector3f_async, FVector3f_in]
    IsValid: AsyncIntProperty

class FBox2D(Struct):
    """An axis-aligned rectangle.

    Unreal: /Script/CoreUObject.Box2D
    """
    def __init__(self, Min: FVector2D = ..., Max: FVector2D = ..., bIsValid: bool = ...) -> None: ...
    Min: FVector2D
    """Smallest corner."""
    Max: FVector2D
    """Largest corner."""
    bIsValid: bool
    """True if the rectangle holds a point."""

class FBox2D_dict(TypedDict, total=False):
    """Any of the fields of FBox2D: what a dictionary for it may hold."""
    Min: FVector2D_in
    Max: FVector2D_in
    bIsValid: bool | Future[bool]

FBox2D_in: TypeAlias = FBox2D | FBox2D_dict | Future[FBox2D]
"""What stands for FBox2D as an argument: itself, a dictionary of its fields, a future."""

class FBox2D_path(StructPath[FBox2D, FBox2D_in, FBox2D_async]):
    """A variable of type FBox2D: its path."""
    Min: Property[FVector2D_path, FVector2D_in]
    """Smallest corner."""
    Max: Property[FVector2D_path, FVector2D_in]
    """Largest corner."""
    bIsValid: BoolProperty
    """True if the rectangle holds a point."""

class FBox2D_async(AsyncValuePath[FBox2D, FBox2D_in]):
    """The same under ``async_``."""
    Min: Property[FVector2D_async, FVector2D_in]
    Max: Property[FVector2D_async, FVector2D_in]
    bIsValid: AsyncBoolProperty

class FBox2f(Struct):
    """An axis-aligned rectangle.

    Unreal: /Script/CoreUObject.Box2f
    """
    def __init__(self, Min: FVector2f = ..., Max: FVector2f = ..., bIsValid: bool = ...) -> None: ...
    Min: FVector2f
    """Smallest corner."""
    Max: FVector2f
    """Largest corner."""
    bIsValid: bool
    """True if the rectangle holds a point."""

class FBox2f_dict(TypedDict, total=False):
    """Any of the fields of FBox2f: what a dictionary for it may hold."""
    Min: FVector2f_in
    Max: FVector2f_in
    bIsValid: bool | Future[bool]

FBox2f_in: TypeAlias = FBox2f | FBox2f_dict | Future[FBox2f]
"""What stands for FBox2f as an argument: itself, a dictionary of its fields, a future."""

class FBox2f_path(StructPath[FBox2f, FBox2f_in, FBox2f_async]):
    """A variable of type FBox2f: its path."""
    Min: Property[FVector2f_path, FVector2f_in]
    """Smallest corner."""
    Max: Property[FVector2f_path, FVector2f_in]
    """Largest corner."""
    bIsValid: BoolProperty
    """True if the rectangle holds a point."""

class FBox2f_async(AsyncValuePath[FBox2f, FBox2f_in]):
    """The same under ``async_``."""
    Min: Property[FVector2f_async, FVector2f_in]
    Max: Property[FVector2f_async, FVector2f_in]
    bIsValid: AsyncBoolProperty

class FBoxSphereBounds(Struct):
    """A box and a sphere about the same origin.

    Unreal: /Script/CoreUObject.BoxSphereBounds
    """
    def __init__(self, Origin: FVector = ..., BoxExtent: FVector = ..., SphereRadius: float = ...) -> None: ...
    Origin: FVector
    """Centre of both."""
    BoxExtent: FVector
    """Half size of the box."""
    SphereRadius: float
    """Radius of the sphere."""

class FBoxSphereBounds_dict(TypedDict, total=False):
    """Any of the fields of FBoxSphereBounds: what a dictionary for it may hold."""
    Origin: FVector_in
    BoxExtent: FVector_in
    SphereRadius: float | Future[float]

FBoxSphereBounds_in: TypeAlias = FBoxSphereBounds | FBoxSphereBounds_dict | Future[FBoxSphereBounds]
"""What stands for FBoxSphereBounds as an argument: itself, a dictionary of its fields, a future."""

class FBoxSphereBounds_path(StructPath[FBoxSphereBounds, FBoxSphereBounds_in, FBoxSphereBounds_async]):
    """A variable of type FBoxSphereBounds: its path."""
    Origin: Property[FVector_path, FVector_in]
    """Centre of both."""
    BoxExtent: Property[FVector_path, FVector_in]
    """Half size of the box."""
    SphereRadius: FloatProperty
    """Radius of the sphere."""

class FBoxSphereBounds_async(AsyncValuePath[FBoxSphereBounds, FBoxSphereBounds_in]):
    """The same under ``async_``."""
    Origin: Property[FVector_async, FVector_in]
    BoxExtent: Property[FVector_async, FVector_in]
    SphereRadius: AsyncFloatProperty

class FBoxSphereBounds3f(Struct):
    """A box and a sphere about the same origin.

    Unreal: /Script/CoreUObject.BoxSphereBounds3f
    """
    def __init__(self, Origin: FVector3f = ..., BoxExtent: FVector3f = ..., SphereRadius: float = ...) -> None: ...
    Origin: FVector3f
    """Centre of both."""
    BoxExtent: FVector3f
    """Half size of the box."""
    SphereRadius: float
    """Radius of the sphere."""

class FBoxSphereBounds3f_dict(TypedDict, total=False):
    """Any of the fields of FBoxSphereBounds3f: what a dictionary for it may hold."""
    Origin: FVector3f_in
    BoxExtent: FVector3f_in
    SphereRadius: float | Future[float]

FBoxSphereBounds3f_in: TypeAlias = FBoxSphereBounds3f | FBoxSphereBounds3f_dict | Future[FBoxSphereBounds3f]
"""What stands for FBoxSphereBounds3f as an argument: itself, a dictionary of its fields, a future."""

class FBoxSphereBounds3f_path(StructPath[FBoxSphereBounds3f, FBoxSphereBounds3f_in, FBoxSphereBounds3f_async]):
    """A variable of type FBoxSphereBounds3f: its path."""
    Origin: Property[FVector3f_path, FVector3f_in]
    """Centre of both."""
    BoxExtent: Property[FVector3f_path, FVector3f_in]
    """Half size of the box."""
    SphereRadius: FloatProperty
    """Radius of the sphere."""

class FBoxSphereBounds3f_async(AsyncValuePath[FBoxSphereBounds3f, FBoxSphereBounds3f_in]):
    """The same under ``async_``."""
    Origin: Property[FVector3f_async, FVector3f_in]
    BoxExtent: Property[FVector3f_async, FVector3f_in]
    SphereRadius: AsyncFloatProperty

class FSphere(Struct):
    """A sphere.

    Unreal: /Script/CoreUObject.Sphere
    """
    def __init__(self, Center: FVector = ..., W: float = ...) -> None: ...
    Center: FVector
    """Centre."""
    W: float
    """Radius."""

class FSphere_dict(TypedDict, total=False):
    """Any of the fields of FSphere: what a dictionary for it may hold."""
    Center: FVector_in
    W: float | Future[float]

FSphere_in: TypeAlias = FSphere | FSphere_dict | Future[FSphere]
"""What stands for FSphere as an argument: itself, a dictionary of its fields, a future."""

class FSphere_path(StructPath[FSphere, FSphere_in, FSphere_async]):
    """A variable of type FSphere: its path."""
    Center: Property[FVector_path, FVector_in]
    """Centre."""
    W: FloatProperty
    """Radius."""

class FSphere_async(AsyncValuePath[FSphere, FSphere_in]):
    """The same under ``async_``."""
    Center: Property[FVector_async, FVector_in]
    W: AsyncFloatProperty

class FSphere3f(Struct):
    """A sphere.

    Unreal: /Script/CoreUObject.Sphere3f
    """
    def __init__(self, Center: FVector3f = ..., W: float = ...) -> None: ...
    Center: FVector3f
    """Centre."""
    W: float
    """Radius."""

class FSphere3f_dict(TypedDict, total=False):
    """Any of the fields of FSphere3f: what a dictionary for it may hold."""
    Center: FVector3f_in
    W: float | Future[float]

FSphere3f_in: TypeAlias = FSphere3f | FSphere3f_dict | Future[FSphere3f]
"""What stands for FSphere3f as an argument: itself, a dictionary of its fields, a future."""

class FSphere3f_path(StructPath[FSphere3f, FSphere3f_in, FSphere3f_async]):
    """A variable of type FSphere3f: its path."""
    Center: Property[FVector3f_path, FVector3f_in]
    """Centre."""
    W: FloatProperty
    """Radius."""

class FSphere3f_async(AsyncValuePath[FSphere3f, FSphere3f_in]):
    """The same under ``async_``."""
    Center: Property[FVector3f_async, FVector3f_in]
    W: AsyncFloatProperty

class FRay(Struct):
    """A ray.

    Unreal: /Script/CoreUObject.Ray
    """
    def __init__(self, Origin: FVector = ..., Direction: FVector = ...) -> None: ...
    Origin: FVector
    """Start."""
    Direction: FVector
    """Direction of length 1."""

class FRay_dict(TypedDict, total=False):
    """Any of the fields of FRay: what a dictionary for it may hold."""
    Origin: FVector_in
    Direction: FVector_in

FRay_in: TypeAlias = FRay | FRay_dict | Future[FRay]
"""What stands for FRay as an argument: itself, a dictionary of its fields, a future."""

class FRay_path(StructPath[FRay, FRay_in, FRay_async]):
    """A variable of type FRay: its path."""
    Origin: Property[FVector_path, FVector_in]
    """Start."""
    Direction: Property[FVector_path, FVector_in]
    """Direction of length 1."""

class FRay_async(AsyncValuePath[FRay, FRay_in]):
    """The same under ``async_``."""
    Origin: Property[FVector_async, FVector_in]
    Direction: Property[FVector_async, FVector_in]

class FRay3f(Struct):
    """A ray.

    Unreal: /Script/CoreUObject.Ray3f
    """
    def __init__(self, Origin: FVector3f = ..., Direction: FVector3f = ...) -> None: ...
    Origin: FVector3f
    """Start."""
    Direction: FVector3f
    """Direction of length 1."""

class FRay3f_dict(TypedDict, total=False):
    """Any of the fields of FRay3f: what a dictionary for it may hold."""
    Origin: FVector3f_in
    Direction: FVector3f_in

FRay3f_in: TypeAlias = FRay3f | FRay3f_dict | Future[FRay3f]
"""What stands for FRay3f as an argument: itself, a dictionary of its fields, a future."""

class FRay3f_path(StructPath[FRay3f, FRay3f_in, FRay3f_async]):
    """A variable of type FRay3f: its path."""
    Origin: Property[FVector3f_path, FVector3f_in]
    """Start."""
    Direction: Property[FVector3f_path, FVector3f_in]
    """Direction of length 1."""

class FRay3f_async(AsyncValuePath[FRay3f, FRay3f_in]):
    """The same under ``async_``."""
    Origin: Property[FVector3f_async, FVector3f_in]
    Direction: Property[FVector3f_async, FVector3f_in]

class FIntPoint(Struct):
    """A point in 2D space with integer coordinates.

    Unreal: /Script/CoreUObject.IntPoint
    """
    def __init__(self, X: int = ..., Y: int = ...) -> None: ...
    X: int
    """X component."""
    Y: int
    """Y component."""

class FIntPoint_dict(TypedDict, total=False):
    """Any of the fields of FIntPoint: what a dictionary for it may hold."""
    X: int | Future[int]
    Y: int | Future[int]

FIntPoint_in: TypeAlias = FIntPoint | FIntPoint_dict | Future[FIntPoint] | Numbers
"""What stands for FIntPoint as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FIntPoint_path(StructPath[FIntPoint, FIntPoint_in, FIntPoint_async]):
    """A variable of type FIntPoint: its path."""
    X: IntProperty
    """X component."""
    Y: IntProperty
    """Y component."""

class FIntPoint_async(AsyncValuePath[FIntPoint, FIntPoint_in]):
    """The same under ``async_``."""
    X: AsyncIntProperty
    Y: AsyncIntProperty

class FIntVector2(Struct):
    """A 2D vector with integer components.

    Unreal: /Script/CoreUObject.IntVector2
    """
    def __init__(self, X: int = ..., Y: int = ...) -> None: ...
    X: int
    """X component."""
    Y: int
    """Y component."""

class FIntVector2_dict(TypedDict, total=False):
    """Any of the fields of FIntVector2: what a dictionary for it may hold."""
    X: int | Future[int]
    Y: int | Future[int]

FIntVector2_in: TypeAlias = FIntVector2 | FIntVector2_dict | Future[FIntVector2] | Numbers
"""What stands for FIntVector2 as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FIntVector2_path(StructPath[FIntVector2, FIntVector2_in, FIntVector2_async]):
    """A variable of type FIntVector2: its path."""
    X: IntProperty
    """X component."""
    Y: IntProperty
    """Y component."""

class FIntVector2_async(AsyncValuePath[FIntVector2, FIntVector2_in]):
    """The same under ``async_``."""
    X: AsyncIntProperty
    Y: AsyncIntProperty

class FIntVector(Struct):
    """A point in 3D space with integer coordinates.

    Unreal: /Script/CoreUObject.IntVector
    """
    def __init__(self, X: int = ..., Y: int = ..., Z: int = ...) -> None: ...
    X: int
    """X component."""
    Y: int
    """Y component."""
    Z: int
    """Z component."""

class FIntVector_dict(TypedDict, total=False):
    """Any of the fields of FIntVector: what a dictionary for it may hold."""
    X: int | Future[int]
    Y: int | Future[int]
    Z: int | Future[int]

FIntVector_in: TypeAlias = FIntVector | FIntVector_dict | Future[FIntVector] | Numbers
"""What stands for FIntVector as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FIntVector_path(StructPath[FIntVector, FIntVector_in, FIntVector_async]):
    """A variable of type FIntVector: its path."""
    X: IntProperty
    """X component."""
    Y: IntProperty
    """Y component."""
    Z: IntProperty
    """Z component."""

class FIntVector_async(AsyncValuePath[FIntVector, FIntVector_in]):
    """The same under ``async_``."""
    X: AsyncIntProperty
    Y: AsyncIntProperty
    Z: AsyncIntProperty

class FIntVector4(Struct):
    """A 4D vector with integer components.

    Unreal: /Script/CoreUObject.IntVector4
    """
    def __init__(self, X: int = ..., Y: int = ..., Z: int = ..., W: int = ...) -> None: ...
    X: int
    """X component."""
    Y: int
    """Y component."""
    Z: int
    """Z component."""
    W: int
    """W component."""

class FIntVector4_dict(TypedDict, total=False):
    """Any of the fields of FIntVector4: what a dictionary for it may hold."""
    X: int | Future[int]
    Y: int | Future[int]
    Z: int | Future[int]
    W: int | Future[int]

FIntVector4_in: TypeAlias = FIntVector4 | FIntVector4_dict | Future[FIntVector4] | Numbers
"""What stands for FIntVector4 as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FIntVector4_path(StructPath[FIntVector4, FIntVector4_in, FIntVector4_async]):
    """A variable of type FIntVector4: its path."""
    X: IntProperty
    """X component."""
    Y: IntProperty
    """Y component."""
    Z: IntProperty
    """Z component."""
    W: IntProperty
    """W component."""

class FIntVector4_async(AsyncValuePath[FIntVector4, FIntVector4_in]):
    """The same under ``async_``."""
    X: AsyncIntProperty
    Y: AsyncIntProperty
    Z: AsyncIntProperty
    W: AsyncIntProperty

from spear.structs import FColor as FColor

class FColor_dict(TypedDict, total=False):
    """Any of the fields of FColor: what a dictionary for it may hold."""
    B: int | Future[int]
    G: int | Future[int]
    R: int | Future[int]
    A: int | Future[int]

FColor_in: TypeAlias = FColor | FColor_dict | Future[FColor] | Numbers
"""What stands for FColor as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FColor_path(StructPath[FColor, FColor_in, FColor_async]):
    """A variable of type FColor: its path."""
    B: IntProperty
    """Blue."""
    G: IntProperty
    """Green."""
    R: IntProperty
    """Red."""
    A: IntProperty
    """Alpha, 255 is opaque."""

class FColor_async(AsyncValuePath[FColor, FColor_in]):
    """The same under ``async_``."""
    B: AsyncIntProperty
    G: AsyncIntProperty
    R: AsyncIntProperty
    A: AsyncIntProperty

from spear.structs import FLinearColor as FLinearColor

class FLinearColor_dict(TypedDict, total=False):
    """Any of the fields of FLinearColor: what a dictionary for it may hold."""
    R: float | Future[float]
    G: float | Future[float]
    B: float | Future[float]
    A: float | Future[float]

FLinearColor_in: TypeAlias = FLinearColor | FLinearColor_dict | Future[FLinearColor] | Numbers
"""What stands for FLinearColor as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FLinearColor_path(StructPath[FLinearColor, FLinearColor_in, FLinearColor_async]):
    """A variable of type FLinearColor: its path."""
    R: FloatProperty
    """Red."""
    G: FloatProperty
    """Green."""
    B: FloatProperty
    """Blue."""
    A: FloatProperty
    """Alpha, 1 is opaque."""

class FLinearColor_async(AsyncValuePath[FLinearColor, FLinearColor_in]):
    """The same under ``async_``."""
    R: AsyncFloatProperty
    G: AsyncFloatProperty
    B: AsyncFloatProperty
    A: AsyncFloatProperty

class FRandomStream(Struct):
    """A repeatable sequence of random numbers.

    Unreal: /Script/CoreUObject.RandomStream
    """
    def __init__(self, InitialSeed: int = ..., Seed: int = ...) -> None: ...
    InitialSeed: int
    """Seed the sequence started with."""
    Seed: int
    """Current state."""

class FRandomStream_dict(TypedDict, total=False):
    """Any of the fields of FRandomStream: what a dictionary for it may hold."""
    InitialSeed: int | Future[int]
    Seed: int | Future[int]

FRandomStream_in: TypeAlias = FRandomStream | FRandomStream_dict | Future[FRandomStream] | Numbers
"""What stands for FRandomStream as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FRandomStream_path(StructPath[FRandomStream, FRandomStream_in, FRandomStream_async]):
    """A variable of type FRandomStream: its path."""
    InitialSeed: IntProperty
    """Seed the sequence started with."""
    Seed: IntProperty
    """Current state."""

class FRandomStream_async(AsyncValuePath[FRandomStream, FRandomStream_in]):
    """The same under ``async_``."""
    InitialSeed: AsyncIntProperty
    Seed: AsyncIntProperty

class FGuid(Struct):
    """A globally unique identifier.

    Unreal: /Script/CoreUObject.Guid
    """
    def __init__(self, A: int = ..., B: int = ..., C: int = ..., D: int = ...) -> None: ...
    A: int
    """Part 1 of 4."""
    B: int
    """Part 2 of 4."""
    C: int
    """Part 3 of 4."""
    D: int
    """Part 4 of 4."""

class FGuid_dict(TypedDict, total=False):
    """Any of the fields of FGuid: what a dictionary for it may hold."""
    A: int | Future[int]
    B: int | Future[int]
    C: int | Future[int]
    D: int | Future[int]

FGuid_in: TypeAlias = FGuid | FGuid_dict | Future[FGuid] | Numbers
"""What stands for FGuid as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FGuid_path(StructPath[FGuid, FGuid_in, FGuid_async]):
    """A variable of type FGuid: its path."""
    A: IntProperty
    """Part 1 of 4."""
    B: IntProperty
    """Part 2 of 4."""
    C: IntProperty
    """Part 3 of 4."""
    D: IntProperty
    """Part 4 of 4."""

class FGuid_async(AsyncValuePath[FGuid, FGuid_in]):
    """The same under ``async_``."""
    A: AsyncIntProperty
    B: AsyncIntProperty
    C: AsyncIntProperty
    D: AsyncIntProperty

class FDateTime(Struct):
    """A date and time in ticks of 100 ns since 1 January 0001.

    Unreal: /Script/CoreUObject.DateTime
    """
    def __init__(self, Ticks: int = ...) -> None: ...
    Ticks: int
    """Ticks of 100 ns."""

class FDateTime_dict(TypedDict, total=False):
    """Any of the fields of FDateTime: what a dictionary for it may hold."""
    Ticks: int | Future[int]

FDateTime_in: TypeAlias = FDateTime | FDateTime_dict | Future[FDateTime] | Numbers
"""What stands for FDateTime as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FDateTime_path(StructPath[FDateTime, FDateTime_in, FDateTime_async]):
    """A variable of type FDateTime: its path."""
    Ticks: IntProperty
    """Ticks of 100 ns."""

class FDateTime_async(AsyncValuePath[FDateTime, FDateTime_in]):
    """The same under ``async_``."""
    Ticks: AsyncIntProperty

class FTimespan(Struct):
    """A time span in ticks of 100 ns.

    Unreal: /Script/CoreUObject.Timespan
    """
    def __init__(self, Ticks: int = ...) -> None: ...
    Ticks: int
    """Ticks of 100 ns."""

class FTimespan_dict(TypedDict, total=False):
    """Any of the fields of FTimespan: what a dictionary for it may hold."""
    Ticks: int | Future[int]

FTimespan_in: TypeAlias = FTimespan | FTimespan_dict | Future[FTimespan] | Numbers
"""What stands for FTimespan as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FTimespan_path(StructPath[FTimespan, FTimespan_in, FTimespan_async]):
    """A variable of type FTimespan: its path."""
    Ticks: IntProperty
    """Ticks of 100 ns."""

class FTimespan_async(AsyncValuePath[FTimespan, FTimespan_in]):
    """The same under ``async_``."""
    Ticks: AsyncIntProperty

class FTopLevelAssetPath(Struct):
    """Package and name of a top-level object.

    Unreal: /Script/CoreUObject.TopLevelAssetPath
    """
    def __init__(self, PackageName: str = ..., AssetName: str = ...) -> None: ...
    PackageName: str
    """Package, for instance /Game/Maps/Town."""
    AssetName: str
    """Name of the object in the package."""

class FTopLevelAssetPath_dict(TypedDict, total=False):
    """Any of the fields of FTopLevelAssetPath: what a dictionary for it may hold."""
    PackageName: str | Future[str]
    AssetName: str | Future[str]

FTopLevelAssetPath_in: TypeAlias = FTopLevelAssetPath | FTopLevelAssetPath_dict | Future[FTopLevelAssetPath]
"""What stands for FTopLevelAssetPath as an argument: itself, a dictionary of its fields, a future."""

class FTopLevelAssetPath_path(StructPath[FTopLevelAssetPath, FTopLevelAssetPath_in, FTopLevelAssetPath_async]):
    """A variable of type FTopLevelAssetPath: its path."""
    PackageName: StrProperty
    """Package, for instance /Game/Maps/Town."""
    AssetName: StrProperty
    """Name of the object in the package."""

class FTopLevelAssetPath_async(AsyncValuePath[FTopLevelAssetPath, FTopLevelAssetPath_in]):
    """The same under ``async_``."""
    PackageName: AsyncStrProperty
    AssetName: AsyncStrProperty

class FSoftObjectPath(Struct):
    """Path of an object that may not be loaded.

    Unreal: /Script/CoreUObject.SoftObjectPath
    """
    def __init__(self, AssetPath: FTopLevelAssetPath = ..., SubPathString: str = ...) -> None: ...
    AssetPath: FTopLevelAssetPath
    """The asset."""
    SubPathString: str
    """Path of an object inside the asset, or empty."""

class FSoftObjectPath_dict(TypedDict, total=False):
    """Any of the fields of FSoftObjectPath: what a dictionary for it may hold."""
    AssetPath: FTopLevelAssetPath_in
    SubPathString: str | Future[str]

FSoftObjectPath_in: TypeAlias = FSoftObjectPath | FSoftObjectPath_dict | Future[FSoftObjectPath]
"""What stands for FSoftObjectPath as an argument: itself, a dictionary of its fields, a future."""

class FSoftObjectPath_members:
    """The fields of FSoftObjectPath, as paths."""
    AssetPath: Property[FTopLevelAssetPath_path, FTopLevelAssetPath_in]
    """The asset."""
    SubPathString: StrProperty
    """Path of an object inside the asset, or empty."""

class FSoftObjectPath_async_members:
    """The fields of FSoftObjectPath, as paths under ``async_``."""
    AssetPath: Property[FTopLevelAssetPath_async, FTopLevelAssetPath_in]
    SubPathString: AsyncStrProperty

class FSoftObjectPath_path(StructPath[FSoftObjectPath, FSoftObjectPath_in, FSoftObjectPath_async], FSoftObjectPath_members):
    """A variable of type FSoftObjectPath: its path."""

class FSoftObjectPath_async(AsyncValuePath[FSoftObjectPath, FSoftObjectPath_in], FSoftObjectPath_async_members):
    """The same under ``async_``."""

class FSoftClassPath(FSoftObjectPath):
    """Path of a class that may not be loaded.

    Unreal: /Script/CoreUObject.SoftClassPath
    """
    def __init__(self, AssetPath: FTopLevelAssetPath = ..., SubPathString: str = ...) -> None: ...

class FSoftClassPath_dict(FSoftObjectPath_dict, total=False):
    """Any of the fields of FSoftClassPath: what a dictionary for it may hold."""

FSoftClassPath_in: TypeAlias = FSoftClassPath | FSoftClassPath_dict | Future[FSoftClassPath]
"""What stands for FSoftClassPath as an argument: itself, a dictionary of its fields, a future."""

class FSoftClassPath_members(FSoftObjectPath_members):
    """The fields of FSoftClassPath, as paths."""

class FSoftClassPath_async_members(FSoftObjectPath_async_members):
    """The fields of FSoftClassPath, as paths under ``async_``."""

class FSoftClassPath_path(StructPath[FSoftClassPath, FSoftClassPath_in, FSoftClassPath_async], FSoftClassPath_members):
    """A variable of type FSoftClassPath: its path."""

class FSoftClassPath_async(AsyncValuePath[FSoftClassPath, FSoftClassPath_in], FSoftClassPath_async_members):
    """The same under ``async_``."""

class UObject_members:
    """Functions and variables of UObject."""

class UObject_async(AsyncBase):
    """UObject under ``async_``: each function gives a future."""

class UObject_send(SendBase):
    """UObject under ``send_``: no function answers."""

class UObject(UObject_members, ObjectBase):
    """The base class of all reflected objects.

    Unreal: /Script/CoreUObject.Object
    """
    @property
    def async_(self) -> UObject_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UObject_send:
        """The same functions and variables, fire-and-forget."""

class UObject_path(ObjectPath[UObject, UObject_async_path, UObject_send], UObject_members):
    """A variable that refers to an object of UObject: its path."""

class UObject_async_path(AsyncObjectPath[UObject], UObject_async):
    """The same under ``async_``."""
