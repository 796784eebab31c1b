// SPDX-License-Identifier: MIT
/** @file Types used all over the engine: collision channels, mobility, attachment and spawn rules. Mirrors UE's
 * Engine/EngineTypes.h. */
#pragma once

#include "CoreMinimal.h"
#include "Materials/BlendMode.h"
#include "Engine/EngineBaseTypes.h"
#include "Engine/TimerHandle.h"
#include "Templates/SubclassOf.h"
#include "UObject/ObjectMacros.h"
#include "UObject/ScriptDelegates.h"

#include "EngineTypes.generated.h"

class AActor;
class UActorComponent;
class UPrimitiveComponent;
class USceneComponent;

/** Delegate of a timer that is bound to a reflected function. */
DECLARE_DYNAMIC_DELEGATE(FTimerDynamicDelegate);

/** Whether to teleport physics body or not. */
UENUM()
enum class ETeleportType : uint8 {
    /** Do not teleport physics body. This means velocity will reflect the movement between initial and final position,
       and collisions along the way will occur. */
    None,
    /** Teleport physics body so that velocity remains the same and no collision occurs. */
    TeleportPhysics,
    /** Teleport physics body and reset physics state completely. */
    ResetPhysics,
};

/** Converts a bool of old functions to ETeleportType. */
inline ETeleportType TeleportFlagToEnum(bool bTeleport) {
    return bTeleport ? ETeleportType::TeleportPhysics : ETeleportType::None;
}

/** Converts ETeleportType to the bool of old functions. */
inline bool TeleportEnumToFlag(ETeleportType Teleport) { return Teleport == ETeleportType::TeleportPhysics; }

/** Describes how often a component is allowed to move. */
UENUM(BlueprintType)
namespace EComponentMobility {
enum Type : int {
    /** Static objects cannot be moved or changed in game. */
    Static,
    /** A stationary light will only have its shadowing and bounced lighting from static geometry baked, all other
       lighting will be dynamic. It can change color and intensity in game. */
    Stationary,
    /** Movable objects can be moved and changed in game. */
    Movable
};
}

/** What a world is used for. */
namespace EWorldType {
enum Type : int {
    /** An untyped world, in most cases this will be the vestigial worlds of streamed in sub-levels. */
    None,
    /** The game world. */
    Game,
    /** A world being edited in the editor. */
    Editor,
    /** A Play In Editor world. */
    PIE,
    /** A preview world for an editor tool. */
    EditorPreview,
    /** A preview world for a game. */
    GamePreview,
    /** A minimal RPC world for a game. */
    GameRPC,
    /** An editor world that was loaded but not currently being edited in the level editor. */
    Inactive
};
}

/** Returns a text for the world type. */
ENGINE_API const TCHAR* LexToString(const EWorldType::Type Value);

/** Details of what ended play of an actor or component. */
UENUM(BlueprintType)
namespace EEndPlayReason {
enum Type : int {
    /** When the Actor or Component is explicitly destroyed. */
    Destroyed,
    /** When the world is being unloaded for a level transition. */
    LevelTransition,
    /** When the world is being unloaded because PIE is ending. */
    EndPlayInEditor,
    /** When the level it is a member of is streamed out. */
    RemovedFromWorld,
    /** When the application is being exited. */
    Quit,
};
}

/** The network role of an actor on a local/remote network context. Without network every spawned actor has
 * ROLE_Authority. */
UENUM()
enum ENetRole : int {
    /** No role at all. */
    ROLE_None,
    /** Locally simulated proxy of this actor. */
    ROLE_SimulatedProxy,
    /** Locally autonomous proxy of this actor. */
    ROLE_AutonomousProxy,
    /** Authoritative control over the actor. */
    ROLE_Authority,
    ROLE_MAX UMETA(Hidden),
};

/** Rules for attaching components. Used by the deprecated attachment functions of old content. */
UENUM()
namespace EAttachLocation {
enum Type : int {
    /** Keep current relative transform as the relative transform to the new parent. */
    KeepRelativeOffset,
    /** Automatically calculate the relative transform such that the attached component maintains the same world
       transform. */
    KeepWorldPosition,
    /** Snap location and rotation to the attach point. Calculates the relative scale so that the final world scale of
       the component remains the same. */
    SnapToTarget,
    /** Snap entire transform to target, including scale. */
    SnapToTargetIncludingScale,
};
}

/** Rules for attaching components. */
UENUM()
enum class EAttachmentRule : uint8 {
    /** Keeps current relative transform as the relative transform to the new parent. */
    KeepRelative,
    /** Automatically calculates the relative transform such that the attached component maintains the same world
       transform. */
    KeepWorld,
    /** Snaps transform to the attach point. */
    SnapToTarget,
};

/** Rules for detaching components; needs to be kept synced with EAttachmentRule. */
UENUM()
enum class EDetachmentRule : uint8 {
    /** Keeps current relative transform. */
    KeepRelative,
    /** Automatically calculates the relative transform such that the detached component maintains the same world
       transform. */
    KeepWorld,
};

struct FDetachmentTransformRules;

/**
 * Rules for attaching components.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FAttachmentTransformRules
 */
struct FAttachmentTransformRules {
    /** Various preset attachment rules. Note that these default rules do NOT by default weld simulated bodies. */
    static ENGINE_API FAttachmentTransformRules KeepRelativeTransform;
    static ENGINE_API FAttachmentTransformRules KeepWorldTransform;
    static ENGINE_API FAttachmentTransformRules SnapToTargetNotIncludingScale;
    static ENGINE_API FAttachmentTransformRules SnapToTargetIncludingScale;

    FAttachmentTransformRules(EAttachmentRule InRule, bool bInWeldSimulatedBodies)
        : LocationRule(InRule), RotationRule(InRule), ScaleRule(InRule), bWeldSimulatedBodies(bInWeldSimulatedBodies) {}

    FAttachmentTransformRules(EAttachmentRule InLocationRule, EAttachmentRule InRotationRule,
        EAttachmentRule InScaleRule, bool bInWeldSimulatedBodies)
        : LocationRule(InLocationRule), RotationRule(InRotationRule), ScaleRule(InScaleRule),
          bWeldSimulatedBodies(bInWeldSimulatedBodies) {}

    bool operator==(const FAttachmentTransformRules& Other) const {
        return LocationRule == Other.LocationRule && RotationRule == Other.RotationRule &&
               ScaleRule == Other.ScaleRule && bWeldSimulatedBodies == Other.bWeldSimulatedBodies;
    }

    /** The rule to apply to location when attaching. */
    EAttachmentRule LocationRule;
    /** The rule to apply to rotation when attaching. */
    EAttachmentRule RotationRule;
    /** The rule to apply to scale when attaching. */
    EAttachmentRule ScaleRule;
    /** Whether to weld simulated bodies together when attaching. */
    bool bWeldSimulatedBodies;
};

/** Rules for detaching components. */
struct FDetachmentTransformRules {
    /** Various preset detachment rules. */
    static ENGINE_API FDetachmentTransformRules KeepRelativeTransform;
    static ENGINE_API FDetachmentTransformRules KeepWorldTransform;

    FDetachmentTransformRules(EDetachmentRule InRule, bool bInCallModify)
        : LocationRule(InRule), RotationRule(InRule), ScaleRule(InRule), bCallModify(bInCallModify) {}

    FDetachmentTransformRules(
        EDetachmentRule InLocationRule, EDetachmentRule InRotationRule, EDetachmentRule InScaleRule, bool bInCallModify)
        : LocationRule(InLocationRule), RotationRule(InRotationRule), ScaleRule(InScaleRule),
          bCallModify(bInCallModify) {}

    FDetachmentTransformRules(const FAttachmentTransformRules& AttachmentRules, bool bInCallModify)
        : LocationRule(AttachmentRules.LocationRule == EAttachmentRule::KeepRelative ? EDetachmentRule::KeepRelative
                                                                                     : EDetachmentRule::KeepWorld),
          RotationRule(AttachmentRules.RotationRule == EAttachmentRule::KeepRelative ? EDetachmentRule::KeepRelative
                                                                                     : EDetachmentRule::KeepWorld),
          ScaleRule(AttachmentRules.ScaleRule == EAttachmentRule::KeepRelative ? EDetachmentRule::KeepRelative
                                                                               : EDetachmentRule::KeepWorld),
          bCallModify(bInCallModify) {}

    /** The rule to apply to location when detaching. */
    EDetachmentRule LocationRule;
    /** The rule to apply to rotation when detaching. */
    EDetachmentRule RotationRule;
    /** The rule to apply to scale when detaching. */
    EDetachmentRule ScaleRule;
    /** Whether to call Modify() on the components concerned when detaching. */
    bool bCallModify;
};

/** Defines available strategies for handling the case where an actor is spawned in such a way that it penetrates
 * blocking collision. */
UENUM(BlueprintType)
enum class ESpawnActorCollisionHandlingMethod : uint8 {
    /** Fall back to default settings. */
    Undefined UMETA(DisplayName = "Default"),
    /** Actor will spawn in desired location, regardless of collisions. */
    AlwaysSpawn UMETA(DisplayName = "Always Spawn, Ignore Collisions"),
    /** Actor will try to find a nearby non-colliding location (based on shape components), but will always spawn even
       if one cannot be found. */
    AdjustIfPossibleButAlwaysSpawn UMETA(DisplayName = "Try To Adjust Location, But Always Spawn"),
    /** Actor will try to find a nearby non-colliding location (based on shape components), but will NOT spawn unless
       one is found. */
    AdjustIfPossibleButDontSpawnIfColliding UMETA(
        DisplayName = "Try To Adjust Location, Don't Spawn If Still Colliding"),
    /** Actor will fail to spawn. */
    DontSpawnIfColliding UMETA(DisplayName = "Do Not Spawn"),
};

/** Determines how the transform being passed into actor spawning methods interact with the actor's default root
 * component. */
UENUM(BlueprintType)
enum class ESpawnActorScaleMethod : uint8 {
    /** Ignore the default scale in the actor's root component and hard-set it to the value of SpawnTransform Parameter.
     */
    OverrideRootScale UMETA(DisplayName = "Override Root Component Scale"),
    /** Multiply value of the SpawnTransform Parameter with the default scale in the actor's root component. */
    MultiplyWithRoot UMETA(DisplayName = "Multiply Scale With Root Component Scale"),
    /** Determine whether to override or multiply on spawn: native root components multiply. */
    SelectDefaultAtRuntime UMETA(DisplayName = "Select Scale Method At Runtime"),
};

/** Specifies the goal/source of a UActorComponent's creation. */
UENUM()
enum class EComponentCreationMethod : uint8 {
    /** A component that is part of a native class. */
    Native,
    /** A component that is created from a template defined in the Components section of the Blueprint. */
    SimpleConstructionScript,
    /** A dynamically created component, either from the UserConstructionScript or from a Add Component node in a
       Blueprint event graph. */
    UserConstructionScript,
    /** A component added to a single Actor instance via the Component section of the Actor's details panel. */
    Instance,
};

/** Which channels an object or a trace is in for collision. */
UENUM(BlueprintType)
enum ECollisionChannel : int {
    ECC_WorldStatic UMETA(DisplayName = "WorldStatic"),
    ECC_WorldDynamic UMETA(DisplayName = "WorldDynamic"),
    ECC_Pawn UMETA(DisplayName = "Pawn"),
    ECC_Visibility UMETA(DisplayName = "Visibility", TraceQuery = "1"),
    ECC_Camera UMETA(DisplayName = "Camera", TraceQuery = "1"),
    ECC_PhysicsBody UMETA(DisplayName = "PhysicsBody"),
    ECC_Vehicle UMETA(DisplayName = "Vehicle"),
    ECC_Destructible UMETA(DisplayName = "Destructible"),
    /** Reserved for gizmo collision. */
    ECC_EngineTraceChannel1 UMETA(Hidden),
    ECC_EngineTraceChannel2 UMETA(Hidden),
    ECC_EngineTraceChannel3 UMETA(Hidden),
    ECC_EngineTraceChannel4 UMETA(Hidden),
    ECC_EngineTraceChannel5 UMETA(Hidden),
    ECC_EngineTraceChannel6 UMETA(Hidden),
    ECC_GameTraceChannel1 UMETA(Hidden),
    ECC_GameTraceChannel2 UMETA(Hidden),
    ECC_GameTraceChannel3 UMETA(Hidden),
    ECC_GameTraceChannel4 UMETA(Hidden),
    ECC_GameTraceChannel5 UMETA(Hidden),
    ECC_GameTraceChannel6 UMETA(Hidden),
    ECC_GameTraceChannel7 UMETA(Hidden),
    ECC_GameTraceChannel8 UMETA(Hidden),
    ECC_GameTraceChannel9 UMETA(Hidden),
    ECC_GameTraceChannel10 UMETA(Hidden),
    ECC_GameTraceChannel11 UMETA(Hidden),
    ECC_GameTraceChannel12 UMETA(Hidden),
    ECC_GameTraceChannel13 UMETA(Hidden),
    ECC_GameTraceChannel14 UMETA(Hidden),
    ECC_GameTraceChannel15 UMETA(Hidden),
    ECC_GameTraceChannel16 UMETA(Hidden),
    ECC_GameTraceChannel17 UMETA(Hidden),
    ECC_GameTraceChannel18 UMETA(Hidden),
    /** Add new serializeable channels above here (i.e. entries that exist in FCollisionResponseContainer). */
    ECC_OverlapAll_Deprecated UMETA(Hidden),
    ECC_MAX,
};

/** Enum indicating how each type should respond. */
UENUM(BlueprintType)
enum ECollisionResponse : int {
    ECR_Ignore UMETA(DisplayName = "Ignore"),
    ECR_Overlap UMETA(DisplayName = "Overlap"),
    ECR_Block UMETA(DisplayName = "Block"),
    ECR_MAX,
};

/** What types of collision a body takes part in. */
UENUM(BlueprintType)
namespace ECollisionEnabled {
enum Type : int {
    /** Will not create any representation in the physics engine. Cannot be used for spatial queries (raycasts, sweeps,
       overlaps) or simulation (rigid body, constraints). */
    NoCollision UMETA(DisplayName = "No Collision"),
    /** Only used for spatial queries (raycasts, sweeps, and overlaps). Cannot be used for simulation (rigid body,
       constraints). */
    QueryOnly UMETA(DisplayName = "Query Only (No Physics Collision)"),
    /** Only used only for physics simulation (rigid body, constraints). Cannot be used for spatial queries (raycasts,
       sweeps, overlaps). */
    PhysicsOnly UMETA(DisplayName = "Physics Only (No Query Collision)"),
    /** Can be used for both spatial queries (raycasts, sweeps, overlaps) and simulation (rigid body, constraints). */
    QueryAndPhysics UMETA(DisplayName = "Collision Enabled (Query and Physics)"),
    /** Only used for probing the physics simulation (rigid body, constraints). */
    ProbeOnly UMETA(DisplayName = "Probe Only (Contact Data, No Query or Physics Collision)"),
    /** Can be used for both spatial queries and probing the physics simulation. */
    QueryAndProbe UMETA(DisplayName = "Query and Probe (Query Collision and Contact Data, No Physics Collision)"),
};
}

/** Which local player, if any, something is assigned to automatically. */
UENUM(BlueprintType)
namespace EAutoReceiveInput {
enum Type : int {
    Disabled,
    Player0,
    Player1,
    Player2,
    Player3,
    Player4,
    Player5,
    Player6,
    Player7,
};
}

/**
 * The response of a body to each collision channel, one named byte each.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FCollisionResponseContainer
 */
USTRUCT(BlueprintType)
struct FCollisionResponseContainer {
    GENERATED_BODY()

    /** Response to the channel WorldStatic. */
    UPROPERTY(
        EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer", meta = (DisplayName = "WorldStatic"))
    TEnumAsByte<ECollisionResponse> WorldStatic;

    /** Response to the channel WorldDynamic. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer",
        meta = (DisplayName = "WorldDynamic"))
    TEnumAsByte<ECollisionResponse> WorldDynamic;

    /** Response to the channel Pawn. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer", meta = (DisplayName = "Pawn"))
    TEnumAsByte<ECollisionResponse> Pawn;

    /** Response to the channel Visibility. */
    UPROPERTY(
        EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer", meta = (DisplayName = "Visibility"))
    TEnumAsByte<ECollisionResponse> Visibility;

    /** Response to the channel Camera. */
    UPROPERTY(
        EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer", meta = (DisplayName = "Camera"))
    TEnumAsByte<ECollisionResponse> Camera;

    /** Response to the channel PhysicsBody. */
    UPROPERTY(
        EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer", meta = (DisplayName = "PhysicsBody"))
    TEnumAsByte<ECollisionResponse> PhysicsBody;

    /** Response to the channel Vehicle. */
    UPROPERTY(
        EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer", meta = (DisplayName = "Vehicle"))
    TEnumAsByte<ECollisionResponse> Vehicle;

    /** Response to the channel Destructible. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer",
        meta = (DisplayName = "Destructible"))
    TEnumAsByte<ECollisionResponse> Destructible;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> EngineTraceChannel1;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> EngineTraceChannel2;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> EngineTraceChannel3;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> EngineTraceChannel4;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> EngineTraceChannel5;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> EngineTraceChannel6;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel1;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel2;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel3;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel4;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel5;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel6;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel7;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel8;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel9;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel10;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel11;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel12;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel13;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel14;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel15;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel16;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel17;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "CollisionResponseContainer")
    TEnumAsByte<ECollisionResponse> GameTraceChannel18;

    /** Blocks every channel. */
    FCollisionResponseContainer() : FCollisionResponseContainer(ECR_Block) {}
    /** The same response to every channel. */
    ENGINE_API explicit FCollisionResponseContainer(ECollisionResponse DefaultResponse);

    /** Sets the response of a particular channel. Returns whether it changed. */
    ENGINE_API bool SetResponse(ECollisionChannel Channel, ECollisionResponse NewResponse);
    /** Sets all channels to the specified response. Returns whether anything changed. */
    ENGINE_API bool SetAllChannels(ECollisionResponse NewResponse);
    /** Replaces the channels matching the old response with the new response. Returns whether anything changed. */
    ENGINE_API bool ReplaceChannels(ECollisionResponse OldResponse, ECollisionResponse NewResponse);
    /** Returns the response set on the specified channel. */
    ENGINE_API ECollisionResponse GetResponse(ECollisionChannel Channel) const;

    /** Takes two response containers and creates a new response container with minimum response of both. */
    static ENGINE_API FCollisionResponseContainer CreateMinContainer(
        const FCollisionResponseContainer& A, const FCollisionResponseContainer& B);

    ENGINE_API bool operator==(const FCollisionResponseContainer& Other) const;
    bool operator!=(const FCollisionResponseContainer& Other) const { return !(*this == Other); }
};

/** Whether bodies with this setting take part in the physics simulation. */
inline bool CollisionEnabledHasPhysics(ECollisionEnabled::Type CollisionEnabled) {
    return CollisionEnabled == ECollisionEnabled::PhysicsOnly || CollisionEnabled == ECollisionEnabled::QueryAndPhysics;
}

/** Whether bodies with this setting take part in spatial queries. */
inline bool CollisionEnabledHasQuery(ECollisionEnabled::Type CollisionEnabled) {
    return CollisionEnabled == ECollisionEnabled::QueryOnly || CollisionEnabled == ECollisionEnabled::QueryAndPhysics ||
           CollisionEnabled == ECollisionEnabled::QueryAndProbe;
}

/** What kind of thing a socket of a component is. */
UENUM()
namespace EComponentSocketType {
enum Type : int {
    /** Not a valid socket or bone name. */
    Invalid,
    /** Skeletal bone. */
    Bone,
    /** Socket. */
    Socket,
};
}

/** Info about a socket of a component. */
struct FComponentSocketDescription {
    /** Name of the socket. */
    FName Name;
    /** Type of the socket. */
    TEnumAsByte<EComponentSocketType::Type> Type;

    FComponentSocketDescription() : Name(NAME_None), Type(EComponentSocketType::Invalid) {}
    FComponentSocketDescription(FName SocketName, EComponentSocketType::Type SocketType)
        : Name(SocketName), Type(SocketType) {}
};

/** Which lighting channels a light or a primitive is in: a light affects a primitive if they share one. */
USTRUCT(BlueprintType)
struct FLightingChannels {
    GENERATED_BODY()

    FLightingChannels() : bChannel0(true), bChannel1(false), bChannel2(false) {}

    /** Default channel for all primitives and lights. */
    UPROPERTY(BlueprintReadWrite, EditAnywhere, Category = Channels)
    uint8 bChannel0 : 1;

    /** First custom channel. */
    UPROPERTY(BlueprintReadWrite, EditAnywhere, Category = Channels)
    uint8 bChannel1 : 1;

    /** Second custom channel. */
    UPROPERTY(BlueprintReadWrite, EditAnywhere, Category = Channels)
    uint8 bChannel2 : 1;
};
