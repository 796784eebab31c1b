# generated, do not edit (Engine: Public/Engine/HitResult.h)
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncIntProperty, AsyncStrProperty, AsyncValuePath, BoolProperty, FloatProperty, Future, IntProperty,
    Property, StrProperty, StructPath,
)
from ._ActorInstanceHandle import FActorInstanceHandle, FActorInstanceHandle_async, FActorInstanceHandle_in, FActorInstanceHandle_path
from ._NetSerialization import (
    FVector_NetQuantize, FVector_NetQuantizeNormal, FVector_NetQuantizeNormal_async, FVector_NetQuantizeNormal_in, FVector_NetQuantizeNormal_path,
    FVector_NetQuantize_async, FVector_NetQuantize_in, FVector_NetQuantize_path,
)
from ._PrimitiveComponent import UPrimitiveComponent, UPrimitiveComponent_async_path, UPrimitiveComponent_path

class FHitResult(Struct):
    """Structure containing information about one hit of a trace, such as point of impact and surface normal at that
    point. Lengths in centimetres.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FHitResult

    Unreal: /Script/Engine.HitResult
    """
    def __init__(self, FaceIndex: int = ..., Time: float = ..., Distance: float = ..., Location: FVector_NetQuantize = ..., ImpactPoint: FVector_NetQuantize = ..., Normal: FVector_NetQuantizeNormal = ..., ImpactNormal: FVector_NetQuantizeNormal = ..., TraceStart: FVector_NetQuantize = ..., TraceEnd: FVector_NetQuantize = ..., PenetrationDepth: float = ..., MyItem: int = ..., Item: int = ..., ElementIndex: int = ..., bBlockingHit: bool = ..., bStartPenetrating: bool = ..., HitObjectHandle: FActorInstanceHandle = ..., Component: UPrimitiveComponent | None = ..., BoneName: str = ..., MyBoneName: str = ...) -> None: ...
    FaceIndex: int
    """Face index we hit (for complex hits with triangle meshes)."""
    Time: float
    """'Time' of impact along trace direction (ranging from 0.0 to 1.0) if there is a hit, indicating time between
    TraceStart and TraceEnd. 1 if there was no hit.
    """
    Distance: float
    """The distance from the TraceStart to the Location in world space."""
    Location: FVector_NetQuantize
    """The location in world space where the moving shape would end up against the impacted object, if there is a
    hit. Equal to the point of impact for line tests.
    """
    ImpactPoint: FVector_NetQuantize
    """Location in world space of the actual contact of the trace shape (box, sphere, ray, etc) with the impacted
    object.
    """
    Normal: FVector_NetQuantizeNormal
    """Normal of the hit in world space, for the object that was swept. Equal to ImpactNormal for line tests."""
    ImpactNormal: FVector_NetQuantizeNormal
    """Normal of the hit in world space, for the object that was hit by the sweep, if any."""
    TraceStart: FVector_NetQuantize
    """Start location of the trace."""
    TraceEnd: FVector_NetQuantize
    """End location of the trace; this is NOT where the impact occurred (if any), but the furthest point in the
    attempted sweep.
    """
    PenetrationDepth: float
    """If this test started in penetration (bStartPenetrating is true) and a depenetration vector can be computed,
    this value is the distance along Normal that will result in moving out of penetration.
    """
    MyItem: int
    """If the colliding object was part of the moving one: its item, else -1."""
    Item: int
    """Extra data about item that was hit (hit primitive specific)."""
    ElementIndex: int
    """Index to item that was hit, also hit primitive specific."""
    bBlockingHit: bool
    """Indicates if this hit was a result of blocking collision. If false, there was no hit or it was an
    overlap/touch instead.
    """
    bStartPenetrating: bool
    """Whether the trace started in penetration, i.e. with an initial blocking overlap."""
    HitObjectHandle: FActorInstanceHandle
    """Handle to the object hit by the trace."""
    Component: UPrimitiveComponent | None
    """PrimitiveComponent hit by the trace."""
    BoneName: str
    """Name of bone we hit (for skeletal meshes)."""
    MyBoneName: str
    """Name of the _my_ bone which took part in hit event (in case of two skeletal meshes colliding)."""

class FHitResult_dict(TypedDict, total=False):
    """Any of the fields of FHitResult: what a dictionary for it may hold."""
    FaceIndex: int | Future[int]
    Time: float | Future[float]
    Distance: float | Future[float]
    Location: FVector_NetQuantize_in
    ImpactPoint: FVector_NetQuantize_in
    Normal: FVector_NetQuantizeNormal_in
    ImpactNormal: FVector_NetQuantizeNormal_in
    TraceStart: FVector_NetQuantize_in
    TraceEnd: FVector_NetQuantize_in
    PenetrationDepth: float | Future[float]
    MyItem: int | Future[int]
    Item: int | Future[int]
    ElementIndex: int | Future[int]
    bBlockingHit: bool | Future[bool]
    bStartPenetrating: bool | Future[bool]
    HitObjectHandle: FActorInstanceHandle_in
    Component: UPrimitiveComponent | Future[UPrimitiveComponent] | None
    BoneName: str | Future[str]
    MyBoneName: str | Future[str]

FHitResult_in: TypeAlias = FHitResult | FHitResult_dict | Future[FHitResult]
"""What stands for FHitResult as an argument: itself, a dictionary of its fields, a future."""

class FHitResult_path(StructPath[FHitResult, FHitResult_in, FHitResult_async]):
    """A variable of type FHitResult: its path."""
    FaceIndex: IntProperty
    """Face index we hit (for complex hits with triangle meshes)."""
    Time: FloatProperty
    """'Time' of impact along trace direction (ranging from 0.0 to 1.0) if there is a hit, indicating time between
    TraceStart and TraceEnd. 1 if there was no hit.
    """
    Distance: FloatProperty
    """The distance from the TraceStart to the Location in world space."""
    Location: Property[FVector_NetQuantize_path, FVector_NetQuantize_in]
    """The location in world space where the moving shape would end up against the impacted object, if there is a
    hit. Equal to the point of impact for line tests.
    """
    ImpactPoint: Property[FVector_NetQuantize_path, FVector_NetQuantize_in]
    """Location in world space of the actual contact of the trace shape (box, sphere, ray, etc) with the impacted
    object.
    """
    Normal: Property[FVector_NetQuantizeNormal_path, FVector_NetQuantizeNormal_in]
    """Normal of the hit in world space, for the object that was swept. Equal to ImpactNormal for line tests."""
    ImpactNormal: Property[FVector_NetQuantizeNormal_path, FVector_NetQuantizeNormal_in]
    """Normal of the hit in world space, for the object that was hit by the sweep, if any."""
    TraceStart: Property[FVector_NetQuantize_path, FVector_NetQuantize_in]
    """Start location of the trace."""
    TraceEnd: Property[FVector_NetQuantize_path, FVector_NetQuantize_in]
    """End location of the trace; this is NOT where the impact occurred (if any), but the furthest point in the
    attempted sweep.
    """
    PenetrationDepth: FloatProperty
    """If this test started in penetration (bStartPenetrating is true) and a depenetration vector can be computed,
    this value is the distance along Normal that will result in moving out of penetration.
    """
    MyItem: IntProperty
    """If the colliding object was part of the moving one: its item, else -1."""
    Item: IntProperty
    """Extra data about item that was hit (hit primitive specific)."""
    ElementIndex: IntProperty
    """Index to item that was hit, also hit primitive specific."""
    bBlockingHit: BoolProperty
    """Indicates if this hit was a result of blocking collision. If false, there was no hit or it was an
    overlap/touch instead.
    """
    bStartPenetrating: BoolProperty
    """Whether the trace started in penetration, i.e. with an initial blocking overlap."""
    HitObjectHandle: Property[FActorInstanceHandle_path, FActorInstanceHandle_in]
    """Handle to the object hit by the trace."""
    Component: Property[UPrimitiveComponent_path, UPrimitiveComponent | Future[UPrimitiveComponent] | None]
    """PrimitiveComponent hit by the trace."""
    BoneName: StrProperty
    """Name of bone we hit (for skeletal meshes)."""
    MyBoneName: StrProperty
    """Name of the _my_ bone which took part in hit event (in case of two skeletal meshes colliding)."""

class FHitResult_async(AsyncValuePath[FHitResult, FHitResult_in]):
    """The same under ``async_``."""
    FaceIndex: AsyncIntProperty
    Time: AsyncFloatProperty
    Distance: AsyncFloatProperty
    Location: Property[FVector_NetQuantize_async, FVector_NetQuantize_in]
    ImpactPoint: Property[FVector_NetQuantize_async, FVector_NetQuantize_in]
    Normal: Property[FVector_NetQuantizeNormal_async, FVector_NetQuantizeNormal_in]
    ImpactNormal: Property[FVector_NetQuantizeNormal_async, FVector_NetQuantizeNormal_in]
    TraceStart: Property[FVector_NetQuantize_async, FVector_NetQuantize_in]
    TraceEnd: Property[FVector_NetQuantize_async, FVector_NetQuantize_in]
    PenetrationDepth: AsyncFloatProperty
    MyItem: AsyncIntProperty
    Item: AsyncIntProperty
    ElementIndex: AsyncIntProperty
    bBlockingHit: AsyncBoolProperty
    bStartPenetrating: AsyncBoolProperty
    HitObjectHandle: Property[FActorInstanceHandle_async, FActorInstanceHandle_in]
    Component: Property[UPrimitiveComponent_async_path, UPrimitiveComponent | Future[UPrimitiveComponent] | None]
    BoneName: AsyncStrProperty
    MyBoneName: AsyncStrProperty
