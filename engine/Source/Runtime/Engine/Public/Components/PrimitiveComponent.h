// SPDX-License-Identifier: MIT
#pragma once

#include "Components/SceneComponent.h"
#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "PhysicsEngine/BodyInstance.h"
#include "UObject/ObjectMacros.h"

#include "PrimitiveComponent.generated.h"

class AActor;
class UMaterialInstanceDynamic;
class UMaterialInterface;
class UPrimitiveComponent;

/**
 * A scene component with geometry: something that can be drawn and that has collision settings.
 *
 * The settings here are state that a renderer and collision queries read. Epic page: UPrimitiveComponent.
 */
UCLASS(Abstract, HideCategories = (Mobility, VirtualTexture), ShowCategories = (PhysicsVolume))
class ENGINE_API UPrimitiveComponent : public USceneComponent {
    GENERATED_BODY()

public:
    // --------------------------------------------------------------------------------------------------- rendering

    /** The minimum distance at which the primitive should be rendered, measured from the centre of its bounding sphere,
     * in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = LOD)
    float MinDrawDistance;

    /** Max draw distance exposed to level designers. The real one is the smaller of this and volumes' limits. 0 is no
     * limit. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = LOD, meta = (DisplayName = "Desired Max Draw Distance"))
    float LDMaxDrawDistance;

    /** The distance to cull this primitive at. 0 means that it is not culled by distance. */
    UPROPERTY(Category = LOD, AdvancedDisplay, VisibleAnywhere, BlueprintReadOnly,
        meta = (DisplayName = "Current Max Draw Distance"))
    float CachedMaxDrawDistance;

    /** Scales the bounds of the object. */
    UPROPERTY(
        EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Rendering, meta = (UIMin = "1", UIMax = "10.0"))
    float BoundsScale;

    /** If true, this component will be rendered in the main pass (z prepass, base pass, translucency). */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Rendering)
    uint8 bRenderInMainPass : 1;

    /** If true, this component will be rendered in the depth pass even if it is not rendered in the main pass. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Rendering,
        meta = (EditCondition = "!bRenderInMainPass"))
    uint8 bRenderInDepthPass : 1;

    /** Whether the primitive receives decals. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Rendering)
    uint8 bReceivesDecals : 1;

    /** If this is true, this component won't be visible when the view actor is the component's owner. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Rendering)
    uint8 bOwnerNoSee : 1;

    /** If this is true, this component will only be visible when the view actor is the component's owner. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Rendering)
    uint8 bOnlyOwnerSee : 1;

    /** If true, this component will be visible in reflection captures. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Rendering)
    uint8 bVisibleInReflectionCaptures : 1;

    /** If true, this component will be visible in ray tracing effects. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Rendering)
    uint8 bVisibleInRayTracing : 1;

    /** When true, will only be visible in scene captures. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Rendering)
    uint8 bVisibleInSceneCaptureOnly : 1;

    /** When true, will not be captured by scene captures. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Rendering)
    uint8 bHiddenInSceneCapture : 1;

    /** Controls whether the primitive component should cast a shadow or not. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Lighting)
    uint8 CastShadow : 1;

    /** Controls whether the primitive should influence indirect lighting while it moves. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Lighting)
    uint8 bAffectDynamicIndirectLighting : 1;

    /** Controls whether the primitive should affect dynamic distance field lighting methods. */
    UPROPERTY(
        EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Lighting, meta = (EditCondition = "CastShadow"))
    uint8 bAffectDistanceFieldLighting : 1;

    /** Controls whether the primitive should cast shadows in the case of non precomputed shadowing. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Lighting,
        meta = (EditCondition = "CastShadow", DisplayName = "Dynamic Shadow"))
    uint8 bCastDynamicShadow : 1;

    /** Whether the object should cast a static shadow from shadow casting lights. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Lighting,
        meta = (EditCondition = "CastShadow", DisplayName = "Static Shadow"))
    uint8 bCastStaticShadow : 1;

    /** If true, the primitive will cast shadows even if bHidden is true. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Lighting,
        meta = (EditCondition = "CastShadow", DisplayName = "Hidden Shadow"))
    uint8 bCastHiddenShadow : 1;

    /** Whether this primitive should cast dynamic shadows as if it were a two sided material. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Lighting,
        meta = (EditCondition = "CastShadow", DisplayName = "Shadow Two Sided"))
    uint8 bCastShadowAsTwoSided : 1;

    /** If true, this component will be rendered in the CustomDepth pass. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Rendering,
        meta = (DisplayName = "Render CustomDepth Pass"))
    uint8 bRenderCustomDepth : 1;

    /** Optionally write this 0-255 value to the stencil buffer in the CustomDepth pass. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadOnly, Category = Rendering,
        meta = (UIMin = "0", UIMax = "255", EditCondition = "bRenderCustomDepth",
            DisplayName = "CustomDepth Stencil Value"))
    int32 CustomDepthStencilValue;

    /** Translucent objects with a lower sort priority draw behind objects with a higher one. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Rendering)
    int32 TranslucencySortPriority;

    /** Channels that this component should be in. Lights with matching channels will affect the component. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Lighting)
    FLightingChannels LightingChannels;

    // --------------------------------------------------------------------------------------------------- collision

    /** The collision settings. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Collision, meta = (ShowOnlyInnerProperties))
    FBodyInstance BodyInstance;

private:
    /** If true, this component will generate overlap events when it is overlapping other components. */
    UPROPERTY(EditAnywhere, BlueprintGetter = GetGenerateOverlapEvents, BlueprintSetter = SetGenerateOverlapEvents,
        Category = Collision)
    uint8 bGenerateOverlapEvents : 1;

public:
    UPrimitiveComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Changes whether overlap events are generated. */
    UFUNCTION(BlueprintSetter)
    void SetGenerateOverlapEvents(bool bInGenerateOverlapEvents);

    /** If true, this component will generate overlap events when it is overlapping other components. */
    UFUNCTION(BlueprintGetter)
    bool GetGenerateOverlapEvents() const;

    /** Controls what kind of collision is enabled for this body; its profile becomes `Custom`. */
    UFUNCTION(BlueprintCallable, Category = "Collision")
    virtual void SetCollisionEnabled(ECollisionEnabled::Type NewType);

    /** Returns the form of collision for this component; `NoCollision` when the owner's collision is off. */
    UFUNCTION(BlueprintCallable, Category = "Collision")
    virtual ECollisionEnabled::Type GetCollisionEnabled() const;

    /** Utility to see if there is any form of collision (query or physics) enabled on this component. */
    UFUNCTION(BlueprintPure, Category = "Collision",
        meta = (DisplayName = "Is Collision Enabled", ScriptName = "IsCollisionEnabled"))
    bool K2_IsCollisionEnabled() const;

    /** Utility to see if there is any query collision enabled on this component. */
    UFUNCTION(BlueprintPure, Category = "Collision",
        meta = (DisplayName = "Is Query Collision Enabled", ScriptName = "IsQueryCollisionEnabled"))
    bool K2_IsQueryCollisionEnabled() const;

    /** Utility to see if there is any physics collision enabled on this component. */
    UFUNCTION(BlueprintPure, Category = "Collision",
        meta = (DisplayName = "Is Physics Collision Enabled", ScriptName = "IsPhysicsCollisionEnabled"))
    bool K2_IsPhysicsCollisionEnabled() const;

    /** Set collision profile name: every collision setting is taken from that profile. */
    UFUNCTION(BlueprintCallable, Category = "Collision")
    virtual void SetCollisionProfileName(FName InCollisionProfileName, bool bUpdateOverlaps = true);

    /** Get the collision profile name. */
    UFUNCTION(BlueprintPure, Category = "Collision")
    FName GetCollisionProfileName() const;

    /** Changes the collision channel that this object uses when it moves. */
    UFUNCTION(BlueprintCallable, Category = "Collision")
    virtual void SetCollisionObjectType(ECollisionChannel Channel);

    /** Gets the collision object type. */
    UFUNCTION(BlueprintPure, Category = "Collision")
    virtual ECollisionChannel GetCollisionObjectType() const;

    /** Changes a member of the response container for this component. */
    UFUNCTION(BlueprintCallable, Category = "Collision")
    virtual void SetCollisionResponseToChannel(ECollisionChannel Channel, ECollisionResponse NewResponse);

    /** Changes all responses of this component. */
    UFUNCTION(BlueprintCallable, Category = "Collision")
    virtual void SetCollisionResponseToAllChannels(ECollisionResponse NewResponse);

    /** Changes the whole response container of this component. */
    virtual void SetCollisionResponseToChannels(const FCollisionResponseContainer& NewReponses);

    /** Gets the response type given a specific channel. */
    UFUNCTION(BlueprintPure, Category = "Collision")
    virtual ECollisionResponse GetCollisionResponseToChannel(ECollisionChannel Channel) const;

    /** All responses. */
    virtual const FCollisionResponseContainer& GetCollisionResponseToChannels() const;

    // --------------------------------------------------------------------------------------------------- materials

    /** Returns the material used by the element at the specified index; null if there is none. */
    UFUNCTION(BlueprintPure, Category = "Rendering|Material")
    virtual UMaterialInterface* GetMaterial(int32 ElementIndex) const;

    /** Returns the material of the slot with that name; null if there is no such slot. */
    UFUNCTION(BlueprintPure, Category = "Rendering|Material")
    virtual UMaterialInterface* GetMaterialByName(FName MaterialSlotName) const;

    /** Changes the material applied to an element of the mesh. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    virtual void SetMaterial(int32 ElementIndex, UMaterialInterface* Material);

    /** Changes the material applied to the slot with that name. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    virtual void SetMaterialByName(FName MaterialSlotName, UMaterialInterface* Material);

    /** Returns the number of material elements in this primitive. */
    UFUNCTION(BlueprintPure, Category = "Rendering|Material")
    virtual int32 GetNumMaterials() const;

    /** Creates a dynamic material instance for the specified element; the parent is set to the material being replaced.
     */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Create MID (Elem)", DeprecatedFunction,
            DeprecationMessage = "Use CreateDynamicMaterialInstance instead."),
        Category = "Rendering|Material")
    virtual UMaterialInstanceDynamic* CreateAndSetMaterialInstanceDynamic(int32 ElementIndex);

    /** Creates a dynamic material instance for the specified element, over the given parent. */
    UFUNCTION(BlueprintCallable,
        meta = (DisplayName = "Create MID (Elem/Parent)", DeprecatedFunction,
            DeprecationMessage = "Use CreateDynamicMaterialInstance instead."),
        Category = "Rendering|Material")
    virtual UMaterialInstanceDynamic* CreateAndSetMaterialInstanceDynamicFromMaterial(
        int32 ElementIndex, UMaterialInterface* Parent);

    /**
     * Creates a dynamic material instance for the specified element, optionally from the supplied material.
     * @param ElementIndex   the index of the element
     * @param SourceMaterial the parent; when null, the material being replaced
     * @param OptionalName   the name of the new object; a unique one is made when it is None
     * @return the instance, or null when there is no such element or no material to derive from
     */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    virtual UMaterialInstanceDynamic* CreateDynamicMaterialInstance(
        int32 ElementIndex, UMaterialInterface* SourceMaterial = nullptr, FName OptionalName = NAME_None);

    /** Lists the materials in use. */
    virtual void GetUsedMaterials(TArray<UMaterialInterface*>& OutMaterials, bool bGetDebugMaterials = false) const;

    // ------------------------------------------------------------------------------------------- rendering setters

    /** Changes the value of bRenderInMainPass. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetRenderInMainPass(bool bValue);

    /** Changes the value of bRenderInDepthPass. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetRenderInDepthPass(bool bValue);

    /** Sets bVisibleInSceneCaptureOnly: when true, will only be visible in scene captures. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetVisibleInSceneCaptureOnly(bool bValue);

    /** Sets bHiddenInSceneCapture: when true, will not be captured by scene captures. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetHiddenInSceneCapture(bool bValue);

    /** Changes the value of CastShadow. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetCastShadow(bool NewCastShadow);

    /** Changes the value of bCastHiddenShadow. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetCastHiddenShadow(bool NewCastHiddenShadow);

    /** Changes the value of bAffectDistanceFieldLighting. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetAffectDistanceFieldLighting(bool NewAffectDistanceFieldLighting);

    /** Changes the value of bAffectDynamicIndirectLighting. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetAffectDynamicIndirectLighting(bool bNewAffectDynamicIndirectLighting);

    /** Changes the value of bVisibleInRayTracing. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetVisibleInRayTracing(bool bNewVisibleInRayTracing);

    /** Changes the value of bOwnerNoSee. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetOwnerNoSee(bool bNewOwnerNoSee);

    /** Changes the value of bOnlyOwnerSee. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetOnlyOwnerSee(bool bNewOnlyOwnerSee);

    /** Sets the bRenderCustomDepth property. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetRenderCustomDepth(bool bValue);

    /** Sets the CustomDepth stencil value (0 - 255). */
    UFUNCTION(BlueprintCallable, Category = "Rendering", meta = (UIMin = "0", UIMax = "255"))
    void SetCustomDepthStencilValue(int32 Value);

    /** Sets bReceivesDecals: whether the primitive receives decals. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetReceivesDecals(bool bNewReceivesDecals);

    /** Changes the translucent sort priority of the component. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetTranslucentSortPriority(int32 NewTranslucentSortPriority);

    /** Changes the value of CullDistance, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering", meta = (DisplayName = "Set Max Draw Distance"))
    void SetCullDistance(float NewCullDistance);

    /** Scales the bounds of this component, used for frustum culling and the like. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetBoundsScale(float NewBoundsScale = 1.0f);

    /** Sets the lighting channels of this component. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetLightingChannels(bool bChannel0, bool bChannel1, bool bChannel2);

    /** Recomputes `Bounds`, `BoundsScale` counted. */
    virtual void UpdateBounds() override;
};
