# generated, do not edit (Engine)
"""Types of Unreal's module Engine."""
from ._Actor import (
    AActor as AActor, AActor_GetActorBounds_Result as AActor_GetActorBounds_Result,
    AActor_GetActorEyesViewPoint_Result as AActor_GetActorEyesViewPoint_Result, AActor_GetAttachedActors_Result as AActor_GetAttachedActors_Result,
    AActor_K2_AddActorLocalOffset_Result as AActor_K2_AddActorLocalOffset_Result,
    AActor_K2_AddActorLocalRotation_Result as AActor_K2_AddActorLocalRotation_Result,
    AActor_K2_AddActorLocalTransform_Result as AActor_K2_AddActorLocalTransform_Result,
    AActor_K2_AddActorWorldOffset_Result as AActor_K2_AddActorWorldOffset_Result,
    AActor_K2_AddActorWorldRotation_Result as AActor_K2_AddActorWorldRotation_Result,
    AActor_K2_AddActorWorldTransformKeepScale_Result as AActor_K2_AddActorWorldTransformKeepScale_Result,
    AActor_K2_AddActorWorldTransform_Result as AActor_K2_AddActorWorldTransform_Result,
    AActor_K2_SetActorLocationAndRotation_Result as AActor_K2_SetActorLocationAndRotation_Result,
    AActor_K2_SetActorLocation_Result as AActor_K2_SetActorLocation_Result,
    AActor_K2_SetActorRelativeLocation_Result as AActor_K2_SetActorRelativeLocation_Result,
    AActor_K2_SetActorRelativeRotation_Result as AActor_K2_SetActorRelativeRotation_Result,
    AActor_K2_SetActorRelativeTransform_Result as AActor_K2_SetActorRelativeTransform_Result,
    AActor_K2_SetActorTransform_Result as AActor_K2_SetActorTransform_Result, AActor_path as AActor_path,
    FActorBeginOverlapSignature as FActorBeginOverlapSignature, FActorDestroyedSignature as FActorDestroyedSignature,
    FActorEndOverlapSignature as FActorEndOverlapSignature, FActorEndPlaySignature as FActorEndPlaySignature,
    FActorHitSignature as FActorHitSignature,
)
from ._ActorComponent import (
    FActorComponentActivatedSignature as FActorComponentActivatedSignature, FActorComponentDeactivateSignature as FActorComponentDeactivateSignature,
    UActorComponent as UActorComponent, UActorComponent_path as UActorComponent_path,
)
from ._ActorInstanceHandle import (
    FActorInstanceHandle as FActorInstanceHandle, FActorInstanceHandle_dict as FActorInstanceHandle_dict,
    FActorInstanceHandle_in as FActorInstanceHandle_in, FActorInstanceHandle_path as FActorInstanceHandle_path,
)
from ._ArrowComponent import UArrowComponent as UArrowComponent, UArrowComponent_path as UArrowComponent_path
from ._BlendMode import EBlendMode as EBlendMode, EBlendMode_in as EBlendMode_in
from ._BlueprintFunctionLibrary import (
    UBlueprintFunctionLibrary as UBlueprintFunctionLibrary, UBlueprintFunctionLibrary_path as UBlueprintFunctionLibrary_path,
)
from ._BodyInstance import (
    FBodyInstance as FBodyInstance, FBodyInstance_dict as FBodyInstance_dict, FBodyInstance_in as FBodyInstance_in,
    FBodyInstance_path as FBodyInstance_path,
)
from ._BoxComponent import UBoxComponent as UBoxComponent, UBoxComponent_path as UBoxComponent_path
from ._CameraActor import ACameraActor as ACameraActor, ACameraActor_path as ACameraActor_path
from ._CameraComponent import (
    UCameraComponent as UCameraComponent, UCameraComponent_GetCameraView_Result as UCameraComponent_GetCameraView_Result,
    UCameraComponent_path as UCameraComponent_path,
)
from ._CameraTypes import (
    ECameraProjectionMode as ECameraProjectionMode, ECameraProjectionMode_in as ECameraProjectionMode_in, FMinimalViewInfo as FMinimalViewInfo,
    FMinimalViewInfo_dict as FMinimalViewInfo_dict, FMinimalViewInfo_in as FMinimalViewInfo_in, FMinimalViewInfo_path as FMinimalViewInfo_path,
)
from ._CapsuleComponent import (
    UCapsuleComponent as UCapsuleComponent, UCapsuleComponent_GetScaledCapsuleSize_Result as UCapsuleComponent_GetScaledCapsuleSize_Result,
    UCapsuleComponent_GetUnscaledCapsuleSize_Result as UCapsuleComponent_GetUnscaledCapsuleSize_Result,
    UCapsuleComponent_path as UCapsuleComponent_path,
)
from ._CollisionProfile import (
    FCollisionResponseTemplate as FCollisionResponseTemplate, FCollisionResponseTemplate_dict as FCollisionResponseTemplate_dict,
    FCollisionResponseTemplate_in as FCollisionResponseTemplate_in, FCollisionResponseTemplate_path as FCollisionResponseTemplate_path,
    UCollisionProfile as UCollisionProfile, UCollisionProfile_path as UCollisionProfile_path,
)
from ._Controller import (
    AController as AController, AController_GetPlayerViewPoint_Result as AController_GetPlayerViewPoint_Result, AController_path as AController_path,
    FOnPossessedPawnChanged as FOnPossessedPawnChanged,
)
from ._CoordinateAxes import ACoordinateAxes as ACoordinateAxes, ACoordinateAxes_path as ACoordinateAxes_path
from ._DefaultPawn import ADefaultPawn as ADefaultPawn, ADefaultPawn_path as ADefaultPawn_path
from ._DirectionalLight import ADirectionalLight as ADirectionalLight, ADirectionalLight_path as ADirectionalLight_path
from ._DirectionalLightComponent import (
    UDirectionalLightComponent as UDirectionalLightComponent, UDirectionalLightComponent_path as UDirectionalLightComponent_path,
)
from ._Engine import (
    FWorldContext as FWorldContext, FWorldContext_dict as FWorldContext_dict, FWorldContext_in as FWorldContext_in,
    FWorldContext_path as FWorldContext_path, UEngine as UEngine, UEngine_path as UEngine_path,
)
from ._EngineBaseTypes import (
    ETickingGroup as ETickingGroup, ETickingGroup_in as ETickingGroup_in, ETravelType as ETravelType, ETravelType_in as ETravelType_in,
    FActorComponentTickFunction as FActorComponentTickFunction, FActorComponentTickFunction_dict as FActorComponentTickFunction_dict,
    FActorComponentTickFunction_in as FActorComponentTickFunction_in, FActorComponentTickFunction_path as FActorComponentTickFunction_path,
    FActorTickFunction as FActorTickFunction, FActorTickFunction_dict as FActorTickFunction_dict, FActorTickFunction_in as FActorTickFunction_in,
    FActorTickFunction_path as FActorTickFunction_path, FTickFunction as FTickFunction, FTickFunction_dict as FTickFunction_dict,
    FTickFunction_in as FTickFunction_in, FTickFunction_path as FTickFunction_path, FURL as FURL, FURL_dict as FURL_dict, FURL_in as FURL_in,
    FURL_path as FURL_path,
)
from ._EngineSubsystem import UEngineSubsystem as UEngineSubsystem, UEngineSubsystem_path as UEngineSubsystem_path
from ._EngineTypes import (
    EAttachLocation as EAttachLocation, EAttachLocation_in as EAttachLocation_in, EAttachmentRule as EAttachmentRule,
    EAttachmentRule_in as EAttachmentRule_in, EAutoReceiveInput as EAutoReceiveInput, EAutoReceiveInput_in as EAutoReceiveInput_in,
    ECollisionChannel as ECollisionChannel, ECollisionChannel_in as ECollisionChannel_in, ECollisionEnabled as ECollisionEnabled,
    ECollisionEnabled_in as ECollisionEnabled_in, ECollisionResponse as ECollisionResponse, ECollisionResponse_in as ECollisionResponse_in,
    EComponentCreationMethod as EComponentCreationMethod, EComponentCreationMethod_in as EComponentCreationMethod_in,
    EComponentMobility as EComponentMobility, EComponentMobility_in as EComponentMobility_in, EComponentSocketType as EComponentSocketType,
    EComponentSocketType_in as EComponentSocketType_in, EDetachmentRule as EDetachmentRule, EDetachmentRule_in as EDetachmentRule_in,
    EEndPlayReason as EEndPlayReason, EEndPlayReason_in as EEndPlayReason_in, ENetRole as ENetRole, ENetRole_in as ENetRole_in,
    ESpawnActorCollisionHandlingMethod as ESpawnActorCollisionHandlingMethod,
    ESpawnActorCollisionHandlingMethod_in as ESpawnActorCollisionHandlingMethod_in, ESpawnActorScaleMethod as ESpawnActorScaleMethod,
    ESpawnActorScaleMethod_in as ESpawnActorScaleMethod_in, ETeleportType as ETeleportType, ETeleportType_in as ETeleportType_in,
    FCollisionResponseContainer as FCollisionResponseContainer, FCollisionResponseContainer_dict as FCollisionResponseContainer_dict,
    FCollisionResponseContainer_in as FCollisionResponseContainer_in, FCollisionResponseContainer_path as FCollisionResponseContainer_path,
    FLightingChannels as FLightingChannels, FLightingChannels_dict as FLightingChannels_dict, FLightingChannels_in as FLightingChannels_in,
    FLightingChannels_path as FLightingChannels_path, FTimerDynamicDelegate as FTimerDynamicDelegate,
)
from ._FloatingPawnMovement import UFloatingPawnMovement as UFloatingPawnMovement, UFloatingPawnMovement_path as UFloatingPawnMovement_path
from ._GameEngine import UGameEngine as UGameEngine, UGameEngine_path as UGameEngine_path
from ._GameInstance import UGameInstance as UGameInstance, UGameInstance_path as UGameInstance_path
from ._GameInstanceSubsystem import UGameInstanceSubsystem as UGameInstanceSubsystem, UGameInstanceSubsystem_path as UGameInstanceSubsystem_path
from ._GameModeBase import AGameModeBase as AGameModeBase, AGameModeBase_path as AGameModeBase_path
from ._GameStateBase import AGameStateBase as AGameStateBase, AGameStateBase_path as AGameStateBase_path
from ._GameViewportClient import UGameViewportClient as UGameViewportClient, UGameViewportClient_path as UGameViewportClient_path
from ._GameplayStatics import (
    UGameplayStatics as UGameplayStatics, UGameplayStatics_FindNearestActor_Result as UGameplayStatics_FindNearestActor_Result,
    UGameplayStatics_GetAccurateRealTime_Result as UGameplayStatics_GetAccurateRealTime_Result,
    UGameplayStatics_GetActorArrayBounds_Result as UGameplayStatics_GetActorArrayBounds_Result,
    UGameplayStatics_GetAllActorsOfClassWithTag_Result as UGameplayStatics_GetAllActorsOfClassWithTag_Result,
    UGameplayStatics_GetAllActorsOfClass_Result as UGameplayStatics_GetAllActorsOfClass_Result,
    UGameplayStatics_GetAllActorsWithInterface_Result as UGameplayStatics_GetAllActorsWithInterface_Result,
    UGameplayStatics_GetAllActorsWithTag_Result as UGameplayStatics_GetAllActorsWithTag_Result,
    UGameplayStatics_GetKeyValue_Result as UGameplayStatics_GetKeyValue_Result, UGameplayStatics_path as UGameplayStatics_path,
)
from ._HitResult import (
    FHitResult as FHitResult, FHitResult_dict as FHitResult_dict, FHitResult_in as FHitResult_in, FHitResult_path as FHitResult_path,
)
from ._Info import AInfo as AInfo, AInfo_path as AInfo_path
from ._InterpToMovementComponent import (
    EInterpToBehaviourType as EInterpToBehaviourType, EInterpToBehaviourType_in as EInterpToBehaviourType_in,
    FInterpControlPoint as FInterpControlPoint, FInterpControlPoint_dict as FInterpControlPoint_dict,
    FInterpControlPoint_in as FInterpControlPoint_in, FInterpControlPoint_path as FInterpControlPoint_path,
    FOnInterpToResetDelegate as FOnInterpToResetDelegate, FOnInterpToReverseDelegate as FOnInterpToReverseDelegate,
    FOnInterpToStopDelegate as FOnInterpToStopDelegate, UInterpToMovementComponent as UInterpToMovementComponent,
    UInterpToMovementComponent_path as UInterpToMovementComponent_path,
)
from ._KismetMathLibrary import (
    EEasingFunc as EEasingFunc, EEasingFunc_in as EEasingFunc_in, ELerpInterpolationMode as ELerpInterpolationMode,
    ELerpInterpolationMode_in as ELerpInterpolationMode_in, UKismetMathLibrary as UKismetMathLibrary,
    UKismetMathLibrary_BreakColor_Result as UKismetMathLibrary_BreakColor_Result,
    UKismetMathLibrary_BreakDateTime_Result as UKismetMathLibrary_BreakDateTime_Result,
    UKismetMathLibrary_BreakRandomStream_Result as UKismetMathLibrary_BreakRandomStream_Result,
    UKismetMathLibrary_BreakRotIntoAxes_Result as UKismetMathLibrary_BreakRotIntoAxes_Result,
    UKismetMathLibrary_BreakRotator_Result as UKismetMathLibrary_BreakRotator_Result,
    UKismetMathLibrary_BreakTimespan_Result as UKismetMathLibrary_BreakTimespan_Result,
    UKismetMathLibrary_BreakTransform_Result as UKismetMathLibrary_BreakTransform_Result,
    UKismetMathLibrary_BreakVector2D_Result as UKismetMathLibrary_BreakVector2D_Result,
    UKismetMathLibrary_BreakVector_Result as UKismetMathLibrary_BreakVector_Result, UKismetMathLibrary_FMod_Result as UKismetMathLibrary_FMod_Result,
    UKismetMathLibrary_GetAzimuthAndElevation_Result as UKismetMathLibrary_GetAzimuthAndElevation_Result,
    UKismetMathLibrary_GetYawPitchFromVector_Result as UKismetMathLibrary_GetYawPitchFromVector_Result,
    UKismetMathLibrary_MaxOfFloatArray_Result as UKismetMathLibrary_MaxOfFloatArray_Result,
    UKismetMathLibrary_MaxOfIntArray_Result as UKismetMathLibrary_MaxOfIntArray_Result,
    UKismetMathLibrary_MinOfFloatArray_Result as UKismetMathLibrary_MinOfFloatArray_Result,
    UKismetMathLibrary_MinOfIntArray_Result as UKismetMathLibrary_MinOfIntArray_Result,
    UKismetMathLibrary_RGBToHSV_Result as UKismetMathLibrary_RGBToHSV_Result,
    UKismetMathLibrary_SeedRandomStream_Result as UKismetMathLibrary_SeedRandomStream_Result,
    UKismetMathLibrary_SetRandomStreamSeed_Result as UKismetMathLibrary_SetRandomStreamSeed_Result,
    UKismetMathLibrary_Vector_Assign_Result as UKismetMathLibrary_Vector_Assign_Result,
    UKismetMathLibrary_Vector_Set_Result as UKismetMathLibrary_Vector_Set_Result, UKismetMathLibrary_path as UKismetMathLibrary_path,
)
from ._KismetStringLibrary import (
    UKismetStringLibrary as UKismetStringLibrary, UKismetStringLibrary_Conv_StringToColor_Result as UKismetStringLibrary_Conv_StringToColor_Result,
    UKismetStringLibrary_Conv_StringToRotator_Result as UKismetStringLibrary_Conv_StringToRotator_Result,
    UKismetStringLibrary_Conv_StringToVector2D_Result as UKismetStringLibrary_Conv_StringToVector2D_Result,
    UKismetStringLibrary_Conv_StringToVector_Result as UKismetStringLibrary_Conv_StringToVector_Result,
    UKismetStringLibrary_Split_Result as UKismetStringLibrary_Split_Result, UKismetStringLibrary_path as UKismetStringLibrary_path,
)
from ._KismetSystemLibrary import (
    EMoveComponentAction as EMoveComponentAction, EMoveComponentAction_in as EMoveComponentAction_in, EQuitPreference as EQuitPreference,
    EQuitPreference_in as EQuitPreference_in, UKismetSystemLibrary as UKismetSystemLibrary,
    UKismetSystemLibrary_BreakSoftObjectPath_Result as UKismetSystemLibrary_BreakSoftObjectPath_Result,
    UKismetSystemLibrary_GetActorListFromComponentList_Result as UKismetSystemLibrary_GetActorListFromComponentList_Result,
    UKismetSystemLibrary_GetComponentBounds_Result as UKismetSystemLibrary_GetComponentBounds_Result,
    UKismetSystemLibrary_K2_ClearAndInvalidateTimerHandle_Result as UKismetSystemLibrary_K2_ClearAndInvalidateTimerHandle_Result,
    UKismetSystemLibrary_K2_InvalidateTimerHandle_Result as UKismetSystemLibrary_K2_InvalidateTimerHandle_Result,
    UKismetSystemLibrary_ParseParamValue_Result as UKismetSystemLibrary_ParseParamValue_Result,
    UKismetSystemLibrary_path as UKismetSystemLibrary_path,
)
from ._LatentActionManager import (
    FLatentActionInfo as FLatentActionInfo, FLatentActionInfo_dict as FLatentActionInfo_dict, FLatentActionInfo_in as FLatentActionInfo_in,
    FLatentActionInfo_path as FLatentActionInfo_path, FLatentActionManager as FLatentActionManager,
    FLatentActionManager_dict as FLatentActionManager_dict, FLatentActionManager_in as FLatentActionManager_in,
    FLatentActionManager_path as FLatentActionManager_path,
)
from ._Level import ULevel as ULevel, ULevel_path as ULevel_path
from ._Light import ALight as ALight, ALight_path as ALight_path
from ._LightComponent import ULightComponent as ULightComponent, ULightComponent_path as ULightComponent_path
from ._LightComponentBase import ULightComponentBase as ULightComponentBase, ULightComponentBase_path as ULightComponentBase_path
from ._LocalLightComponent import ULocalLightComponent as ULocalLightComponent, ULocalLightComponent_path as ULocalLightComponent_path
from ._LocalPlayer import ULocalPlayer as ULocalPlayer, ULocalPlayer_path as ULocalPlayer_path
from ._LocalPlayerSubsystem import ULocalPlayerSubsystem as ULocalPlayerSubsystem, ULocalPlayerSubsystem_path as ULocalPlayerSubsystem_path
from ._Material import UMaterial as UMaterial, UMaterial_path as UMaterial_path
from ._MaterialInstance import (
    FMaterialInstanceBasePropertyOverrides as FMaterialInstanceBasePropertyOverrides,
    FMaterialInstanceBasePropertyOverrides_dict as FMaterialInstanceBasePropertyOverrides_dict,
    FMaterialInstanceBasePropertyOverrides_in as FMaterialInstanceBasePropertyOverrides_in,
    FMaterialInstanceBasePropertyOverrides_path as FMaterialInstanceBasePropertyOverrides_path, FScalarParameterValue as FScalarParameterValue,
    FScalarParameterValue_dict as FScalarParameterValue_dict, FScalarParameterValue_in as FScalarParameterValue_in,
    FScalarParameterValue_path as FScalarParameterValue_path, FTextureParameterValue as FTextureParameterValue,
    FTextureParameterValue_dict as FTextureParameterValue_dict, FTextureParameterValue_in as FTextureParameterValue_in,
    FTextureParameterValue_path as FTextureParameterValue_path, FVectorParameterValue as FVectorParameterValue,
    FVectorParameterValue_dict as FVectorParameterValue_dict, FVectorParameterValue_in as FVectorParameterValue_in,
    FVectorParameterValue_path as FVectorParameterValue_path, UMaterialInstance as UMaterialInstance,
    UMaterialInstance_path as UMaterialInstance_path,
)
from ._MaterialInstanceConstant import (
    UMaterialInstanceConstant as UMaterialInstanceConstant, UMaterialInstanceConstant_path as UMaterialInstanceConstant_path,
)
from ._MaterialInstanceDynamic import (
    UMaterialInstanceDynamic as UMaterialInstanceDynamic, UMaterialInstanceDynamic_path as UMaterialInstanceDynamic_path,
)
from ._MaterialInterface import UMaterialInterface as UMaterialInterface, UMaterialInterface_path as UMaterialInterface_path
from ._MaterialTypes import (
    EMaterialParameterAssociation as EMaterialParameterAssociation, EMaterialParameterAssociation_in as EMaterialParameterAssociation_in,
    FMaterialParameterInfo as FMaterialParameterInfo, FMaterialParameterInfo_dict as FMaterialParameterInfo_dict,
    FMaterialParameterInfo_in as FMaterialParameterInfo_in, FMaterialParameterInfo_path as FMaterialParameterInfo_path,
)
from ._MeshComponent import UMeshComponent as UMeshComponent, UMeshComponent_path as UMeshComponent_path
from ._MovementComponent import (
    EPlaneConstraintAxisSetting as EPlaneConstraintAxisSetting, EPlaneConstraintAxisSetting_in as EPlaneConstraintAxisSetting_in,
    UMovementComponent as UMovementComponent, UMovementComponent_K2_MoveUpdatedComponent_Result as UMovementComponent_K2_MoveUpdatedComponent_Result,
    UMovementComponent_path as UMovementComponent_path,
)
from ._NetSerialization import (
    FVector_NetQuantize as FVector_NetQuantize, FVector_NetQuantize100 as FVector_NetQuantize100,
    FVector_NetQuantize100_dict as FVector_NetQuantize100_dict, FVector_NetQuantize100_in as FVector_NetQuantize100_in,
    FVector_NetQuantize100_path as FVector_NetQuantize100_path, FVector_NetQuantizeNormal as FVector_NetQuantizeNormal,
    FVector_NetQuantizeNormal_dict as FVector_NetQuantizeNormal_dict, FVector_NetQuantizeNormal_in as FVector_NetQuantizeNormal_in,
    FVector_NetQuantizeNormal_path as FVector_NetQuantizeNormal_path, FVector_NetQuantize_dict as FVector_NetQuantize_dict,
    FVector_NetQuantize_in as FVector_NetQuantize_in, FVector_NetQuantize_path as FVector_NetQuantize_path,
)
from ._Pawn import APawn as APawn, APawn_path as APawn_path, FPawnControllerChangedSignature as FPawnControllerChangedSignature
from ._PawnMovementComponent import UPawnMovementComponent as UPawnMovementComponent, UPawnMovementComponent_path as UPawnMovementComponent_path
from ._Player import UPlayer as UPlayer, UPlayer_path as UPlayer_path
from ._PlayerCameraManager import (
    APlayerCameraManager as APlayerCameraManager, APlayerCameraManager_path as APlayerCameraManager_path,
    EViewTargetBlendFunction as EViewTargetBlendFunction, EViewTargetBlendFunction_in as EViewTargetBlendFunction_in,
    FCameraCacheEntry as FCameraCacheEntry, FCameraCacheEntry_dict as FCameraCacheEntry_dict, FCameraCacheEntry_in as FCameraCacheEntry_in,
    FCameraCacheEntry_path as FCameraCacheEntry_path, FTViewTarget as FTViewTarget, FTViewTarget_dict as FTViewTarget_dict,
    FTViewTarget_in as FTViewTarget_in, FTViewTarget_path as FTViewTarget_path, FViewTargetTransitionParams as FViewTargetTransitionParams,
    FViewTargetTransitionParams_dict as FViewTargetTransitionParams_dict, FViewTargetTransitionParams_in as FViewTargetTransitionParams_in,
    FViewTargetTransitionParams_path as FViewTargetTransitionParams_path,
)
from ._PlayerController import (
    APlayerController as APlayerController, APlayerController_GetViewportSize_Result as APlayerController_GetViewportSize_Result,
    APlayerController_path as APlayerController_path,
)
from ._PlayerStart import APlayerStart as APlayerStart, APlayerStart_path as APlayerStart_path
from ._PlayerState import APlayerState as APlayerState, APlayerState_path as APlayerState_path, FOnPlayerStatePawnSet as FOnPlayerStatePawnSet
from ._PointLight import APointLight as APointLight, APointLight_path as APointLight_path
from ._PointLightComponent import UPointLightComponent as UPointLightComponent, UPointLightComponent_path as UPointLightComponent_path
from ._PrimitiveComponent import UPrimitiveComponent as UPrimitiveComponent, UPrimitiveComponent_path as UPrimitiveComponent_path
from ._ProjectileMovementComponent import (
    UProjectileMovementComponent as UProjectileMovementComponent, UProjectileMovementComponent_path as UProjectileMovementComponent_path,
)
from ._RectLight import ARectLight as ARectLight, ARectLight_path as ARectLight_path
from ._RectLightComponent import URectLightComponent as URectLightComponent, URectLightComponent_path as URectLightComponent_path
from ._RotatingMovementComponent import (
    URotatingMovementComponent as URotatingMovementComponent, URotatingMovementComponent_path as URotatingMovementComponent_path,
)
from ._Scene import ELightUnits as ELightUnits, ELightUnits_in as ELightUnits_in
from ._SceneComponent import (
    ERelativeTransformSpace as ERelativeTransformSpace, ERelativeTransformSpace_in as ERelativeTransformSpace_in, USceneComponent as USceneComponent,
    USceneComponent_GetChildrenComponents_Result as USceneComponent_GetChildrenComponents_Result,
    USceneComponent_GetParentComponents_Result as USceneComponent_GetParentComponents_Result,
    USceneComponent_K2_AddLocalOffset_Result as USceneComponent_K2_AddLocalOffset_Result,
    USceneComponent_K2_AddLocalRotation_Result as USceneComponent_K2_AddLocalRotation_Result,
    USceneComponent_K2_AddLocalTransform_Result as USceneComponent_K2_AddLocalTransform_Result,
    USceneComponent_K2_AddRelativeLocation_Result as USceneComponent_K2_AddRelativeLocation_Result,
    USceneComponent_K2_AddRelativeRotation_Result as USceneComponent_K2_AddRelativeRotation_Result,
    USceneComponent_K2_AddWorldOffset_Result as USceneComponent_K2_AddWorldOffset_Result,
    USceneComponent_K2_AddWorldRotation_Result as USceneComponent_K2_AddWorldRotation_Result,
    USceneComponent_K2_AddWorldTransformKeepScale_Result as USceneComponent_K2_AddWorldTransformKeepScale_Result,
    USceneComponent_K2_AddWorldTransform_Result as USceneComponent_K2_AddWorldTransform_Result,
    USceneComponent_K2_SetRelativeLocationAndRotation_Result as USceneComponent_K2_SetRelativeLocationAndRotation_Result,
    USceneComponent_K2_SetRelativeLocation_Result as USceneComponent_K2_SetRelativeLocation_Result,
    USceneComponent_K2_SetRelativeRotation_Result as USceneComponent_K2_SetRelativeRotation_Result,
    USceneComponent_K2_SetRelativeTransform_Result as USceneComponent_K2_SetRelativeTransform_Result,
    USceneComponent_K2_SetWorldLocationAndRotation_Result as USceneComponent_K2_SetWorldLocationAndRotation_Result,
    USceneComponent_K2_SetWorldLocation_Result as USceneComponent_K2_SetWorldLocation_Result,
    USceneComponent_K2_SetWorldRotation_Result as USceneComponent_K2_SetWorldRotation_Result,
    USceneComponent_K2_SetWorldTransform_Result as USceneComponent_K2_SetWorldTransform_Result, USceneComponent_path as USceneComponent_path,
)
from ._ShapeComponent import UShapeComponent as UShapeComponent, UShapeComponent_path as UShapeComponent_path
from ._SkyAtmosphereComponent import (
    ASkyAtmosphere as ASkyAtmosphere, ASkyAtmosphere_path as ASkyAtmosphere_path, ESkyAtmosphereTransformMode as ESkyAtmosphereTransformMode,
    ESkyAtmosphereTransformMode_in as ESkyAtmosphereTransformMode_in, USkyAtmosphereComponent as USkyAtmosphereComponent,
    USkyAtmosphereComponent_path as USkyAtmosphereComponent_path,
)
from ._SkyLight import ASkyLight as ASkyLight, ASkyLight_path as ASkyLight_path
from ._SkyLightComponent import USkyLightComponent as USkyLightComponent, USkyLightComponent_path as USkyLightComponent_path
from ._SpectatorPawn import ASpectatorPawn as ASpectatorPawn, ASpectatorPawn_path as ASpectatorPawn_path
from ._SphereComponent import USphereComponent as USphereComponent, USphereComponent_path as USphereComponent_path
from ._SpotLight import ASpotLight as ASpotLight, ASpotLight_path as ASpotLight_path
from ._SpotLightComponent import USpotLightComponent as USpotLightComponent, USpotLightComponent_path as USpotLightComponent_path
from ._StaticMesh import (
    FStaticMaterial as FStaticMaterial, FStaticMaterial_dict as FStaticMaterial_dict, FStaticMaterial_in as FStaticMaterial_in,
    FStaticMaterial_path as FStaticMaterial_path, UStaticMesh as UStaticMesh, UStaticMesh_path as UStaticMesh_path,
)
from ._StaticMeshActor import AStaticMeshActor as AStaticMeshActor, AStaticMeshActor_path as AStaticMeshActor_path
from ._StaticMeshComponent import (
    UStaticMeshComponent as UStaticMeshComponent, UStaticMeshComponent_GetLocalBounds_Result as UStaticMeshComponent_GetLocalBounds_Result,
    UStaticMeshComponent_path as UStaticMeshComponent_path,
)
from ._StreamableRenderAsset import UStreamableRenderAsset as UStreamableRenderAsset, UStreamableRenderAsset_path as UStreamableRenderAsset_path
from ._Subsystem import (
    UDynamicSubsystem as UDynamicSubsystem, UDynamicSubsystem_path as UDynamicSubsystem_path, USubsystem as USubsystem,
    USubsystem_path as USubsystem_path,
)
from ._TargetPoint import ATargetPoint as ATargetPoint, ATargetPoint_path as ATargetPoint_path
from ._Texture import UTexture as UTexture, UTexture_path as UTexture_path
from ._Texture2D import UTexture2D as UTexture2D, UTexture2D_path as UTexture2D_path
from ._TextureDefines import (
    TextureAddress as TextureAddress, TextureAddress_in as TextureAddress_in, TextureFilter as TextureFilter, TextureFilter_in as TextureFilter_in,
)
from ._TimerHandle import (
    FTimerHandle as FTimerHandle, FTimerHandle_dict as FTimerHandle_dict, FTimerHandle_in as FTimerHandle_in, FTimerHandle_path as FTimerHandle_path,
)
from ._World import UWorld as UWorld, UWorld_path as UWorld_path
from ._WorldSettings import AWorldSettings as AWorldSettings, AWorldSettings_path as AWorldSettings_path
from ._WorldSubsystem import (
    UTickableWorldSubsystem as UTickableWorldSubsystem, UTickableWorldSubsystem_path as UTickableWorldSubsystem_path,
    UWorldSubsystem as UWorldSubsystem, UWorldSubsystem_path as UWorldSubsystem_path,
)
