# generated, do not edit (Engine: Public/Components/PrimitiveComponent.h)
from typing_extensions import deprecated
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncIntProperty, AsyncObjectPath, BoolProperty, FloatProperty, Future, IntProperty, ObjectPath, Property,
    SendBoolProperty, SendFloatProperty, SendIntProperty, SendProperty,
)
from ._BodyInstance import FBodyInstance_async, FBodyInstance_in, FBodyInstance_path
from ._EngineTypes import (
    ECollisionChannel, ECollisionChannel_in, ECollisionEnabled, ECollisionEnabled_in, ECollisionResponse, ECollisionResponse_in,
    FLightingChannels_async, FLightingChannels_in, FLightingChannels_path,
)
from ._MaterialInstanceDynamic import UMaterialInstanceDynamic
from ._MaterialInterface import UMaterialInterface
from ._SceneComponent import USceneComponent, USceneComponent_async, USceneComponent_members, USceneComponent_send

class UPrimitiveComponent_members(USceneComponent_members):
    """Functions and variables of UPrimitiveComponent."""
    @deprecated("Use CreateDynamicMaterialInstance instead.")
    def CreateAndSetMaterialInstanceDynamic(self, ElementIndex: int | Future[int]) -> UMaterialInstanceDynamic:
        """Creates a dynamic material instance for the specified element; the parent is set to the material being
        replaced.

        Unreal: UPrimitiveComponent.CreateAndSetMaterialInstanceDynamic
        """
    @deprecated("Use CreateDynamicMaterialInstance instead.")
    def CreateAndSetMaterialInstanceDynamicFromMaterial(self, ElementIndex: int | Future[int], Parent: UMaterialInterface | Future[UMaterialInterface]) -> UMaterialInstanceDynamic:
        """Creates a dynamic material instance for the specified element, over the given parent.

        Unreal: UPrimitiveComponent.CreateAndSetMaterialInstanceDynamicFromMaterial
        """
    def CreateDynamicMaterialInstance(self, ElementIndex: int | Future[int], SourceMaterial: UMaterialInterface | Future[UMaterialInterface] | None = None, OptionalName: str | Future[str] = "None") -> UMaterialInstanceDynamic | None:
        """Creates a dynamic material instance for the specified element, optionally from the supplied material.

        Args:
            ElementIndex: the index of the element
            SourceMaterial: the parent; when null, the material being replaced
            OptionalName: the name of the new object; a unique one is made when it is None

        Returns:
            the instance, or null when there is no such element or no material to derive from

        Unreal: UPrimitiveComponent.CreateDynamicMaterialInstance
        """
    def GetCollisionEnabled(self) -> ECollisionEnabled:
        """Returns the form of collision for this component; `NoCollision` when the owner's collision is off.

        Unreal: UPrimitiveComponent.GetCollisionEnabled
        """
    def GetCollisionObjectType(self) -> ECollisionChannel:
        """Gets the collision object type.

        Unreal: UPrimitiveComponent.GetCollisionObjectType
        """
    def GetCollisionProfileName(self) -> str:
        """Get the collision profile name.

        Unreal: UPrimitiveComponent.GetCollisionProfileName
        """
    def GetCollisionResponseToChannel(self, Channel: ECollisionChannel_in) -> ECollisionResponse:
        """Gets the response type given a specific channel.

        Unreal: UPrimitiveComponent.GetCollisionResponseToChannel
        """
    def GetGenerateOverlapEvents(self) -> bool:
        """If true, this component will generate overlap events when it is overlapping other components.

        Unreal: UPrimitiveComponent.GetGenerateOverlapEvents
        """
    def GetMaterial(self, ElementIndex: int | Future[int]) -> UMaterialInterface | None:
        """Returns the material used by the element at the specified index; null if there is none.

        Unreal: UPrimitiveComponent.GetMaterial
        """
    def GetMaterialByName(self, MaterialSlotName: str | Future[str]) -> UMaterialInterface | None:
        """Returns the material of the slot with that name; null if there is no such slot.

        Unreal: UPrimitiveComponent.GetMaterialByName
        """
    def GetNumMaterials(self) -> int:
        """Returns the number of material elements in this primitive.

        Unreal: UPrimitiveComponent.GetNumMaterials
        """
    def K2_IsCollisionEnabled(self) -> bool:
        """Utility to see if there is any form of collision (query or physics) enabled on this component.

        Unreal: UPrimitiveComponent.K2_IsCollisionEnabled
        """
    def K2_IsPhysicsCollisionEnabled(self) -> bool:
        """Utility to see if there is any physics collision enabled on this component.

        Unreal: UPrimitiveComponent.K2_IsPhysicsCollisionEnabled
        """
    def K2_IsQueryCollisionEnabled(self) -> bool:
        """Utility to see if there is any query collision enabled on this component.

        Unreal: UPrimitiveComponent.K2_IsQueryCollisionEnabled
        """
    def SetAffectDistanceFieldLighting(self, NewAffectDistanceFieldLighting: bool | Future[bool]) -> None:
        """Changes the value of bAffectDistanceFieldLighting.

        Unreal: UPrimitiveComponent.SetAffectDistanceFieldLighting
        """
    def SetAffectDynamicIndirectLighting(self, bNewAffectDynamicIndirectLighting: bool | Future[bool]) -> None:
        """Changes the value of bAffectDynamicIndirectLighting.

        Unreal: UPrimitiveComponent.SetAffectDynamicIndirectLighting
        """
    def SetBoundsScale(self, NewBoundsScale: float | Future[float] = 1.0) -> None:
        """Scales the bounds of this component, used for frustum culling and the like.

        Unreal: UPrimitiveComponent.SetBoundsScale
        """
    def SetCastHiddenShadow(self, NewCastHiddenShadow: bool | Future[bool]) -> None:
        """Changes the value of bCastHiddenShadow.

        Unreal: UPrimitiveComponent.SetCastHiddenShadow
        """
    def SetCastShadow(self, NewCastShadow: bool | Future[bool]) -> None:
        """Changes the value of CastShadow.

        Unreal: UPrimitiveComponent.SetCastShadow
        """
    def SetCollisionEnabled(self, NewType: ECollisionEnabled_in) -> None:
        """Controls what kind of collision is enabled for this body; its profile becomes `Custom`.

        Unreal: UPrimitiveComponent.SetCollisionEnabled
        """
    def SetCollisionObjectType(self, Channel: ECollisionChannel_in) -> None:
        """Changes the collision channel that this object uses when it moves.

        Unreal: UPrimitiveComponent.SetCollisionObjectType
        """
    def SetCollisionProfileName(self, InCollisionProfileName: str | Future[str], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Set collision profile name: every collision setting is taken from that profile.

        Unreal: UPrimitiveComponent.SetCollisionProfileName
        """
    def SetCollisionResponseToAllChannels(self, NewResponse: ECollisionResponse_in) -> None:
        """Changes all responses of this component.

        Unreal: UPrimitiveComponent.SetCollisionResponseToAllChannels
        """
    def SetCollisionResponseToChannel(self, Channel: ECollisionChannel_in, NewResponse: ECollisionResponse_in) -> None:
        """Changes a member of the response container for this component.

        Unreal: UPrimitiveComponent.SetCollisionResponseToChannel
        """
    def SetCullDistance(self, NewCullDistance: float | Future[float]) -> None:
        """Changes the value of CullDistance, in centimetres.

        Unreal: UPrimitiveComponent.SetCullDistance
        """
    def SetCustomDepthStencilValue(self, Value: int | Future[int]) -> None:
        """Sets the CustomDepth stencil value (0 - 255).

        Unreal: UPrimitiveComponent.SetCustomDepthStencilValue
        """
    def SetGenerateOverlapEvents(self, bInGenerateOverlapEvents: bool | Future[bool]) -> None:
        """Changes whether overlap events are generated.

        Unreal: UPrimitiveComponent.SetGenerateOverlapEvents
        """
    def SetHiddenInSceneCapture(self, bValue: bool | Future[bool]) -> None:
        """Sets bHiddenInSceneCapture: when true, will not be captured by scene captures.

        Unreal: UPrimitiveComponent.SetHiddenInSceneCapture
        """
    def SetLightingChannels(self, bChannel0: bool | Future[bool], bChannel1: bool | Future[bool], bChannel2: bool | Future[bool]) -> None:
        """Sets the lighting channels of this component.

        Unreal: UPrimitiveComponent.SetLightingChannels
        """
    def SetMaterial(self, ElementIndex: int | Future[int], Material: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Changes the material applied to an element of the mesh.

        Unreal: UPrimitiveComponent.SetMaterial
        """
    def SetMaterialByName(self, MaterialSlotName: str | Future[str], Material: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Changes the material applied to the slot with that name.

        Unreal: UPrimitiveComponent.SetMaterialByName
        """
    def SetOnlyOwnerSee(self, bNewOnlyOwnerSee: bool | Future[bool]) -> None:
        """Changes the value of bOnlyOwnerSee.

        Unreal: UPrimitiveComponent.SetOnlyOwnerSee
        """
    def SetOwnerNoSee(self, bNewOwnerNoSee: bool | Future[bool]) -> None:
        """Changes the value of bOwnerNoSee.

        Unreal: UPrimitiveComponent.SetOwnerNoSee
        """
    def SetReceivesDecals(self, bNewReceivesDecals: bool | Future[bool]) -> None:
        """Sets bReceivesDecals: whether the primitive receives decals.

        Unreal: UPrimitiveComponent.SetReceivesDecals
        """
    def SetRenderCustomDepth(self, bValue: bool | Future[bool]) -> None:
        """Sets the bRenderCustomDepth property.

        Unreal: UPrimitiveComponent.SetRenderCustomDepth
        """
    def SetRenderInDepthPass(self, bValue: bool | Future[bool]) -> None:
        """Changes the value of bRenderInDepthPass.

        Unreal: UPrimitiveComponent.SetRenderInDepthPass
        """
    def SetRenderInMainPass(self, bValue: bool | Future[bool]) -> None:
        """Changes the value of bRenderInMainPass.

        Unreal: UPrimitiveComponent.SetRenderInMainPass
        """
    def SetTranslucentSortPriority(self, NewTranslucentSortPriority: int | Future[int]) -> None:
        """Changes the translucent sort priority of the component.

        Unreal: UPrimitiveComponent.SetTranslucentSortPriority
        """
    def SetVisibleInRayTracing(self, bNewVisibleInRayTracing: bool | Future[bool]) -> None:
        """Changes the value of bVisibleInRayTracing.

        Unreal: UPrimitiveComponent.SetVisibleInRayTracing
        """
    def SetVisibleInSceneCaptureOnly(self, bValue: bool | Future[bool]) -> None:
        """Sets bVisibleInSceneCaptureOnly: when true, will only be visible in scene captures.

        Unreal: UPrimitiveComponent.SetVisibleInSceneCaptureOnly
        """
    MinDrawDistance: FloatProperty
    """The minimum distance at which the primitive should be rendered, measured from the centre of its bounding
    sphere, in centimetres.

    Unreal: UPrimitiveComponent.MinDrawDistance (float)
    """
    LDMaxDrawDistance: FloatProperty
    """Max draw distance exposed to level designers. The real one is the smaller of this and volumes' limits. 0 is no
    limit.

    Unreal: UPrimitiveComponent.LDMaxDrawDistance (float)
    """
    CachedMaxDrawDistance: FloatProperty
    """The distance to cull this primitive at. 0 means that it is not culled by distance.

    Unreal: UPrimitiveComponent.CachedMaxDrawDistance (float)
    """
    BoundsScale: FloatProperty
    """Scales the bounds of the object.

    Unreal: UPrimitiveComponent.BoundsScale (float)
    """
    bRenderInMainPass: BoolProperty
    """If true, this component will be rendered in the main pass (z prepass, base pass, translucency).

    Unreal: UPrimitiveComponent.bRenderInMainPass (bool)
    """
    bRenderInDepthPass: BoolProperty
    """If true, this component will be rendered in the depth pass even if it is not rendered in the main pass.

    Unreal: UPrimitiveComponent.bRenderInDepthPass (bool)
    """
    bReceivesDecals: BoolProperty
    """Whether the primitive receives decals.

    Unreal: UPrimitiveComponent.bReceivesDecals (bool)
    """
    bOwnerNoSee: BoolProperty
    """If this is true, this component won't be visible when the view actor is the component's owner.

    Unreal: UPrimitiveComponent.bOwnerNoSee (bool)
    """
    bOnlyOwnerSee: BoolProperty
    """If this is true, this component will only be visible when the view actor is the component's owner.

    Unreal: UPrimitiveComponent.bOnlyOwnerSee (bool)
    """
    bVisibleInReflectionCaptures: BoolProperty
    """If true, this component will be visible in reflection captures.

    Unreal: UPrimitiveComponent.bVisibleInReflectionCaptures (bool)
    """
    bVisibleInRayTracing: BoolProperty
    """If true, this component will be visible in ray tracing effects.

    Unreal: UPrimitiveComponent.bVisibleInRayTracing (bool)
    """
    bVisibleInSceneCaptureOnly: BoolProperty
    """When true, will only be visible in scene captures.

    Unreal: UPrimitiveComponent.bVisibleInSceneCaptureOnly (bool)
    """
    bHiddenInSceneCapture: BoolProperty
    """When true, will not be captured by scene captures.

    Unreal: UPrimitiveComponent.bHiddenInSceneCapture (bool)
    """
    CastShadow: BoolProperty
    """Controls whether the primitive component should cast a shadow or not.

    Unreal: UPrimitiveComponent.CastShadow (bool)
    """
    bAffectDynamicIndirectLighting: BoolProperty
    """Controls whether the primitive should influence indirect lighting while it moves.

    Unreal: UPrimitiveComponent.bAffectDynamicIndirectLighting (bool)
    """
    bAffectDistanceFieldLighting: BoolProperty
    """Controls whether the primitive should affect dynamic distance field lighting methods.

    Unreal: UPrimitiveComponent.bAffectDistanceFieldLighting (bool)
    """
    bCastDynamicShadow: BoolProperty
    """Controls whether the primitive should cast shadows in the case of non precomputed shadowing.

    Unreal: UPrimitiveComponent.bCastDynamicShadow (bool)
    """
    bCastStaticShadow: BoolProperty
    """Whether the object should cast a static shadow from shadow casting lights.

    Unreal: UPrimitiveComponent.bCastStaticShadow (bool)
    """
    bCastHiddenShadow: BoolProperty
    """If true, the primitive will cast shadows even if bHidden is true.

    Unreal: UPrimitiveComponent.bCastHiddenShadow (bool)
    """
    bCastShadowAsTwoSided: BoolProperty
    """Whether this primitive should cast dynamic shadows as if it were a two sided material.

    Unreal: UPrimitiveComponent.bCastShadowAsTwoSided (bool)
    """
    bRenderCustomDepth: BoolProperty
    """If true, this component will be rendered in the CustomDepth pass.

    Unreal: UPrimitiveComponent.bRenderCustomDepth (bool)
    """
    CustomDepthStencilValue: IntProperty
    """Optionally write this 0-255 value to the stencil buffer in the CustomDepth pass.

    Unreal: UPrimitiveComponent.CustomDepthStencilValue (int32)
    """
    TranslucencySortPriority: IntProperty
    """Translucent objects with a lower sort priority draw behind objects with a higher one.

    Unreal: UPrimitiveComponent.TranslucencySortPriority (int32)
    """
    LightingChannels: Property[FLightingChannels_path, FLightingChannels_in]
    """Channels that this component should be in. Lights with matching channels will affect the component.

    Unreal: UPrimitiveComponent.LightingChannels (FLightingChannels)
    """
    BodyInstance: Property[FBodyInstance_path, FBodyInstance_in]
    """The collision settings.

    Unreal: UPrimitiveComponent.BodyInstance (FBodyInstance)
    """
    bGenerateOverlapEvents: BoolProperty
    """If true, this component will generate overlap events when it is overlapping other components.

    Unreal: UPrimitiveComponent.bGenerateOverlapEvents (bool)
    """

class UPrimitiveComponent_async(USceneComponent_async):
    """UPrimitiveComponent under ``async_``: each function gives a future."""
    @deprecated("Use CreateDynamicMaterialInstance instead.")
    def CreateAndSetMaterialInstanceDynamic(self, ElementIndex: int | Future[int]) -> Future[UMaterialInstanceDynamic]:
        """Creates a dynamic material instance for the specified element; the parent is set to the material being replaced."""
    @deprecated("Use CreateDynamicMaterialInstance instead.")
    def CreateAndSetMaterialInstanceDynamicFromMaterial(self, ElementIndex: int | Future[int], Parent: UMaterialInterface | Future[UMaterialInterface]) -> Future[UMaterialInstanceDynamic]:
        """Creates a dynamic material instance for the specified element, over the given parent."""
    def CreateDynamicMaterialInstance(self, ElementIndex: int | Future[int], SourceMaterial: UMaterialInterface | Future[UMaterialInterface] | None = None, OptionalName: str | Future[str] = "None") -> Future[UMaterialInstanceDynamic | None]:
        """Creates a dynamic material instance for the specified element, optionally from the supplied material."""
    def GetCollisionEnabled(self) -> Future[ECollisionEnabled]:
        """Returns the form of collision for this component; `NoCollision` when the owner's collision is off."""
    def GetCollisionObjectType(self) -> Future[ECollisionChannel]:
        """Gets the collision object type."""
    def GetCollisionProfileName(self) -> Future[str]:
        """Get the collision profile name."""
    def GetCollisionResponseToChannel(self, Channel: ECollisionChannel_in) -> Future[ECollisionResponse]:
        """Gets the response type given a specific channel."""
    def GetGenerateOverlapEvents(self) -> Future[bool]:
        """If true, this component will generate overlap events when it is overlapping other components."""
    def GetMaterial(self, ElementIndex: int | Future[int]) -> Future[UMaterialInterface | None]:
        """Returns the material used by the element at the specified index; null if there is none."""
    def GetMaterialByName(self, MaterialSlotName: str | Future[str]) -> Future[UMaterialInterface | None]:
        """Returns the material of the slot with that name; null if there is no such slot."""
    def GetNumMaterials(self) -> Future[int]:
        """Returns the number of material elements in this primitive."""
    def K2_IsCollisionEnabled(self) -> Future[bool]:
        """Utility to see if there is any form of collision (query or physics) enabled on this component."""
    def K2_IsPhysicsCollisionEnabled(self) -> Future[bool]:
        """Utility to see if there is any physics collision enabled on this component."""
    def K2_IsQueryCollisionEnabled(self) -> Future[bool]:
        """Utility to see if there is any query collision enabled on this component."""
    def SetAffectDistanceFieldLighting(self, NewAffectDistanceFieldLighting: bool | Future[bool]) -> Future[None]:
        """Changes the value of bAffectDistanceFieldLighting."""
    def SetAffectDynamicIndirectLighting(self, bNewAffectDynamicIndirectLighting: bool | Future[bool]) -> Future[None]:
        """Changes the value of bAffectDynamicIndirectLighting."""
    def SetBoundsScale(self, NewBoundsScale: float | Future[float] = 1.0) -> Future[None]:
        """Scales the bounds of this component, used for frustum culling and the like."""
    def SetCastHiddenShadow(self, NewCastHiddenShadow: bool | Future[bool]) -> Future[None]:
        """Changes the value of bCastHiddenShadow."""
    def SetCastShadow(self, NewCastShadow: bool | Future[bool]) -> Future[None]:
        """Changes the value of CastShadow."""
    def SetCollisionEnabled(self, NewType: ECollisionEnabled_in) -> Future[None]:
        """Controls what kind of collision is enabled for this body; its profile becomes `Custom`."""
    def SetCollisionObjectType(self, Channel: ECollisionChannel_in) -> Future[None]:
        """Changes the collision channel that this object uses when it moves."""
    def SetCollisionProfileName(self, InCollisionProfileName: str | Future[str], bUpdateOverlaps: bool | Future[bool] = True) -> Future[None]:
        """Set collision profile name: every collision setting is taken from that profile."""
    def SetCollisionResponseToAllChannels(self, NewResponse: ECollisionResponse_in) -> Future[None]:
        """Changes all responses of this component."""
    def SetCollisionResponseToChannel(self, Channel: ECollisionChannel_in, NewResponse: ECollisionResponse_in) -> Future[None]:
        """Changes a member of the response container for this component."""
    def SetCullDistance(self, NewCullDistance: float | Future[float]) -> Future[None]:
        """Changes the value of CullDistance, in centimetres."""
    def SetCustomDepthStencilValue(self, Value: int | Future[int]) -> Future[None]:
        """Sets the CustomDepth stencil value (0 - 255)."""
    def SetGenerateOverlapEvents(self, bInGenerateOverlapEvents: bool | Future[bool]) -> Future[None]:
        """Changes whether overlap events are generated."""
    def SetHiddenInSceneCapture(self, bValue: bool | Future[bool]) -> Future[None]:
        """Sets bHiddenInSceneCapture: when true, will not be captured by scene captures."""
    def SetLightingChannels(self, bChannel0: bool | Future[bool], bChannel1: bool | Future[bool], bChannel2: bool | Future[bool]) -> Future[None]:
        """Sets the lighting channels of this component."""
    def SetMaterial(self, ElementIndex: int | Future[int], Material: UMaterialInterface | Future[UMaterialInterface]) -> Future[None]:
        """Changes the material applied to an element of the mesh."""
    def SetMaterialByName(self, MaterialSlotName: str | Future[str], Material: UMaterialInterface | Future[UMaterialInterface]) -> Future[None]:
        """Changes the material applied to the slot with that name."""
    def SetOnlyOwnerSee(self, bNewOnlyOwnerSee: bool | Future[bool]) -> Future[None]:
        """Changes the value of bOnlyOwnerSee."""
    def SetOwnerNoSee(self, bNewOwnerNoSee: bool | Future[bool]) -> Future[None]:
        """Changes the value of bOwnerNoSee."""
    def SetReceivesDecals(self, bNewReceivesDecals: bool | Future[bool]) -> Future[None]:
        """Sets bReceivesDecals: whether the primitive receives decals."""
    def SetRenderCustomDepth(self, bValue: bool | Future[bool]) -> Future[None]:
        """Sets the bRenderCustomDepth property."""
    def SetRenderInDepthPass(self, bValue: bool | Future[bool]) -> Future[None]:
        """Changes the value of bRenderInDepthPass."""
    def SetRenderInMainPass(self, bValue: bool | Future[bool]) -> Future[None]:
        """Changes the value of bRenderInMainPass."""
    def SetTranslucentSortPriority(self, NewTranslucentSortPriority: int | Future[int]) -> Future[None]:
        """Changes the translucent sort priority of the component."""
    def SetVisibleInRayTracing(self, bNewVisibleInRayTracing: bool | Future[bool]) -> Future[None]:
        """Changes the value of bVisibleInRayTracing."""
    def SetVisibleInSceneCaptureOnly(self, bValue: bool | Future[bool]) -> Future[None]:
        """Sets bVisibleInSceneCaptureOnly: when true, will only be visible in scene captures."""
    MinDrawDistance: AsyncFloatProperty
    """The minimum distance at which the primitive should be rendered, measured from the centre of its bounding sphere, in centimetres."""
    LDMaxDrawDistance: AsyncFloatProperty
    """Max draw distance exposed to level designers."""
    CachedMaxDrawDistance: AsyncFloatProperty
    """The distance to cull this primitive at. 0 means that it is not culled by distance."""
    BoundsScale: AsyncFloatProperty
    """Scales the bounds of the object."""
    bRenderInMainPass: AsyncBoolProperty
    """If true, this component will be rendered in the main pass (z prepass, base pass, translucency)."""
    bRenderInDepthPass: AsyncBoolProperty
    """If true, this component will be rendered in the depth pass even if it is not rendered in the main pass."""
    bReceivesDecals: AsyncBoolProperty
    """Whether the primitive receives decals."""
    bOwnerNoSee: AsyncBoolProperty
    """If this is true, this component won't be visible when the view actor is the component's owner."""
    bOnlyOwnerSee: AsyncBoolProperty
    """If this is true, this component will only be visible when the view actor is the component's owner."""
    bVisibleInReflectionCaptures: AsyncBoolProperty
    """If true, this component will be visible in reflection captures."""
    bVisibleInRayTracing: AsyncBoolProperty
    """If true, this component will be visible in ray tracing effects."""
    bVisibleInSceneCaptureOnly: AsyncBoolProperty
    """When true, will only be visible in scene captures."""
    bHiddenInSceneCapture: AsyncBoolProperty
    """When true, will not be captured by scene captures."""
    CastShadow: AsyncBoolProperty
    """Controls whether the primitive component should cast a shadow or not."""
    bAffectDynamicIndirectLighting: AsyncBoolProperty
    """Controls whether the primitive should influence indirect lighting while it moves."""
    bAffectDistanceFieldLighting: AsyncBoolProperty
    """Controls whether the primitive should affect dynamic distance field lighting methods."""
    bCastDynamicShadow: AsyncBoolProperty
    """Controls whether the primitive should cast shadows in the case of non precomputed shadowing."""
    bCastStaticShadow: AsyncBoolProperty
    """Whether the object should cast a static shadow from shadow casting lights."""
    bCastHiddenShadow: AsyncBoolProperty
    """If true, the primitive will cast shadows even if bHidden is true."""
    bCastShadowAsTwoSided: AsyncBoolProperty
    """Whether this primitive should cast dynamic shadows as if it were a two sided material."""
    bRenderCustomDepth: AsyncBoolProperty
    """If true, this component will be rendered in the CustomDepth pass."""
    CustomDepthStencilValue: AsyncIntProperty
    """Optionally write this 0-255 value to the stencil buffer in the CustomDepth pass."""
    TranslucencySortPriority: AsyncIntProperty
    """Translucent objects with a lower sort priority draw behind objects with a higher one."""
    LightingChannels: Property[FLightingChannels_async, FLightingChannels_in]
    """Channels that this component should be in."""
    BodyInstance: Property[FBodyInstance_async, FBodyInstance_in]
    """The collision settings."""
    bGenerateOverlapEvents: AsyncBoolProperty
    """If true, this component will generate overlap events when it is overlapping other components."""

class UPrimitiveComponent_send(USceneComponent_send):
    """UPrimitiveComponent under ``send_``: no function answers."""
    @deprecated("Use CreateDynamicMaterialInstance instead.")
    def CreateAndSetMaterialInstanceDynamic(self, ElementIndex: int | Future[int]) -> None:
        """Creates a dynamic material instance for the specified element; the parent is set to the material being replaced."""
    @deprecated("Use CreateDynamicMaterialInstance instead.")
    def CreateAndSetMaterialInstanceDynamicFromMaterial(self, ElementIndex: int | Future[int], Parent: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Creates a dynamic material instance for the specified element, over the given parent."""
    def CreateDynamicMaterialInstance(self, ElementIndex: int | Future[int], SourceMaterial: UMaterialInterface | Future[UMaterialInterface] | None = None, OptionalName: str | Future[str] = "None") -> None:
        """Creates a dynamic material instance for the specified element, optionally from the supplied material."""
    def GetCollisionEnabled(self) -> None:
        """Returns the form of collision for this component; `NoCollision` when the owner's collision is off."""
    def GetCollisionObjectType(self) -> None:
        """Gets the collision object type."""
    def GetCollisionProfileName(self) -> None:
        """Get the collision profile name."""
    def GetCollisionResponseToChannel(self, Channel: ECollisionChannel_in) -> None:
        """Gets the response type given a specific channel."""
    def GetGenerateOverlapEvents(self) -> None:
        """If true, this component will generate overlap events when it is overlapping other components."""
    def GetMaterial(self, ElementIndex: int | Future[int]) -> None:
        """Returns the material used by the element at the specified index; null if there is none."""
    def GetMaterialByName(self, MaterialSlotName: str | Future[str]) -> None:
        """Returns the material of the slot with that name; null if there is no such slot."""
    def GetNumMaterials(self) -> None:
        """Returns the number of material elements in this primitive."""
    def K2_IsCollisionEnabled(self) -> None:
        """Utility to see if there is any form of collision (query or physics) enabled on this component."""
    def K2_IsPhysicsCollisionEnabled(self) -> None:
        """Utility to see if there is any physics collision enabled on this component."""
    def K2_IsQueryCollisionEnabled(self) -> None:
        """Utility to see if there is any query collision enabled on this component."""
    def SetAffectDistanceFieldLighting(self, NewAffectDistanceFieldLighting: bool | Future[bool]) -> None:
        """Changes the value of bAffectDistanceFieldLighting."""
    def SetAffectDynamicIndirectLighting(self, bNewAffectDynamicIndirectLighting: bool | Future[bool]) -> None:
        """Changes the value of bAffectDynamicIndirectLighting."""
    def SetBoundsScale(self, NewBoundsScale: float | Future[float] = 1.0) -> None:
        """Scales the bounds of this component, used for frustum culling and the like."""
    def SetCastHiddenShadow(self, NewCastHiddenShadow: bool | Future[bool]) -> None:
        """Changes the value of bCastHiddenShadow."""
    def SetCastShadow(self, NewCastShadow: bool | Future[bool]) -> None:
        """Changes the value of CastShadow."""
    def SetCollisionEnabled(self, NewType: ECollisionEnabled_in) -> None:
        """Controls what kind of collision is enabled for this body; its profile becomes `Custom`."""
    def SetCollisionObjectType(self, Channel: ECollisionChannel_in) -> None:
        """Changes the collision channel that this object uses when it moves."""
    def SetCollisionProfileName(self, InCollisionProfileName: str | Future[str], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Set collision profile name: every collision setting is taken from that profile."""
    def SetCollisionResponseToAllChannels(self, NewResponse: ECollisionResponse_in) -> None:
        """Changes all responses of this component."""
    def SetCollisionResponseToChannel(self, Channel: ECollisionChannel_in, NewResponse: ECollisionResponse_in) -> None:
        """Changes a member of the response container for this component."""
    def SetCullDistance(self, NewCullDistance: float | Future[float]) -> None:
        """Changes the value of CullDistance, in centimetres."""
    def SetCustomDepthStencilValue(self, Value: int | Future[int]) -> None:
        """Sets the CustomDepth stencil value (0 - 255)."""
    def SetGenerateOverlapEvents(self, bInGenerateOverlapEvents: bool | Future[bool]) -> None:
        """Changes whether overlap events are generated."""
    def SetHiddenInSceneCapture(self, bValue: bool | Future[bool]) -> None:
        """Sets bHiddenInSceneCapture: when true, will not be captured by scene captures."""
    def SetLightingChannels(self, bChannel0: bool | Future[bool], bChannel1: bool | Future[bool], bChannel2: bool | Future[bool]) -> None:
        """Sets the lighting channels of this component."""
    def SetMaterial(self, ElementIndex: int | Future[int], Material: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Changes the material applied to an element of the mesh."""
    def SetMaterialByName(self, MaterialSlotName: str | Future[str], Material: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Changes the material applied to the slot with that name."""
    def SetOnlyOwnerSee(self, bNewOnlyOwnerSee: bool | Future[bool]) -> None:
        """Changes the value of bOnlyOwnerSee."""
    def SetOwnerNoSee(self, bNewOwnerNoSee: bool | Future[bool]) -> None:
        """Changes the value of bOwnerNoSee."""
    def SetReceivesDecals(self, bNewReceivesDecals: bool | Future[bool]) -> None:
        """Sets bReceivesDecals: whether the primitive receives decals."""
    def SetRenderCustomDepth(self, bValue: bool | Future[bool]) -> None:
        """Sets the bRenderCustomDepth property."""
    def SetRenderInDepthPass(self, bValue: bool | Future[bool]) -> None:
        """Changes the value of bRenderInDepthPass."""
    def SetRenderInMainPass(self, bValue: bool | Future[bool]) -> None:
        """Changes the value of bRenderInMainPass."""
    def SetTranslucentSortPriority(self, NewTranslucentSortPriority: int | Future[int]) -> None:
        """Changes the translucent sort priority of the component."""
    def SetVisibleInRayTracing(self, bNewVisibleInRayTracing: bool | Future[bool]) -> None:
        """Changes the value of bVisibleInRayTracing."""
    def SetVisibleInSceneCaptureOnly(self, bValue: bool | Future[bool]) -> None:
        """Sets bVisibleInSceneCaptureOnly: when true, will only be visible in scene captures."""
    MinDrawDistance: SendFloatProperty
    LDMaxDrawDistance: SendFloatProperty
    CachedMaxDrawDistance: SendFloatProperty
    BoundsScale: SendFloatProperty
    bRenderInMainPass: SendBoolProperty
    bRenderInDepthPass: SendBoolProperty
    bReceivesDecals: SendBoolProperty
    bOwnerNoSee: SendBoolProperty
    bOnlyOwnerSee: SendBoolProperty
    bVisibleInReflectionCaptures: SendBoolProperty
    bVisibleInRayTracing: SendBoolProperty
    bVisibleInSceneCaptureOnly: SendBoolProperty
    bHiddenInSceneCapture: SendBoolProperty
    CastShadow: SendBoolProperty
    bAffectDynamicIndirectLighting: SendBoolProperty
    bAffectDistanceFieldLighting: SendBoolProperty
    bCastDynamicShadow: SendBoolProperty
    bCastStaticShadow: SendBoolProperty
    bCastHiddenShadow: SendBoolProperty
    bCastShadowAsTwoSided: SendBoolProperty
    bRenderCustomDepth: SendBoolProperty
    CustomDepthStencilValue: SendIntProperty
    TranslucencySortPriority: SendIntProperty
    LightingChannels: SendProperty[FLightingChannels_in]
    BodyInstance: SendProperty[FBodyInstance_in]
    bGenerateOverlapEvents: SendBoolProperty

class UPrimitiveComponent(UPrimitiveComponent_members, USceneComponent):
    """A scene component with geometry: something that can be drawn and that has collision settings.

    The settings here are state that a renderer and collision queries read. Epic page: UPrimitiveComponent.

    Unreal: /Script/Engine.PrimitiveComponent
    """
    @property
    def async_(self) -> UPrimitiveComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UPrimitiveComponent_send:
        """The same functions and variables, fire-and-forget."""

class UPrimitiveComponent_path(ObjectPath[UPrimitiveComponent, UPrimitiveComponent_async_path, UPrimitiveComponent_send], UPrimitiveComponent_members):
    """A variable that refers to an object of UPrimitiveComponent: its path."""

class UPrimitiveComponent_async_path(AsyncObjectPath[UPrimitiveComponent], UPrimitiveComponent_async):
    """The same under ``async_``."""
