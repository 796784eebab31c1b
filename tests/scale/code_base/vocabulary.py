# SPDX-License-Identifier: MIT
"""The words that names, categories and doc comments are made of."""

from __future__ import annotations

#: Module -> (weight, its topics). Order is the order of dependency: a module may use all that come before it.
MODULES: dict[str, tuple[int, list[str]]] = {
    "BigCore": (8, ["Settings", "Math", "Time", "Identity", "Logging", "Registry", "Messages", "Tags"]),
    "BigWorld": (14, ["Terrain", "Water", "Foliage", "Weather", "Biome", "Road", "Cave", "Season"]),
    "BigPhysics": (7, ["Rope", "Cloth", "Buoyancy", "Destruction", "Vehicle", "Joint"]),
    "BigAnimation": (8, ["Pose", "Montage", "Retarget", "Facial", "Locomotion", "Ragdoll"]),
    "BigSensors": (7, ["Camera", "Lidar", "Radar", "Imu", "Depth", "Semantic"]),
    "BigCharacter": (12, ["Creature", "Health", "Stamina", "Climb", "Swim", "Perception", "Dialogue"]),
    "BigItems": (10, ["Inventory", "Crafting", "Weapon", "Armor", "Loot", "Trade"]),
    "BigAI": (10, ["Planner", "Crowd", "Navigation", "Squad", "Senses", "Behavior"]),
    "BigInterface": (8, ["Menu", "Hud", "Map", "Chat", "Notification", "Tooltip"]),
    "BigOnline": (6, ["Session", "Match", "Party", "Stats", "Replay", "Voice"]),
    "BigGame": (12, ["Quest", "Mission", "Economy", "Progress", "Save", "Rules", "Score"]),
    "BigTools": (6, ["Import", "Validation", "Placement", "Bake", "Audit"]),
}

QUALIFIERS = ("Active Ambient Base Blended Cached Current Default Delayed Desired Dynamic Effective Final Global Hidden Idle Initial Inner Last Local Locked Main Maximum Minimum Nearest "
              "Nested Next Outer Pending Persistent Preferred Previous Primary Queued Random Recent Relative Remaining Remote Requested Reserved Scaled Secondary Shared Smoothed Soft "
              "Spawned Static Target Temporary Total Tracked Upper Visible Warm Weighted World").split()

NOUNS = ("Acceleration Action Amount Angle Anchor Area Attachment Axis Balance Band Barrier Blend Boost Bounds Branch Bridge Budget Buffer Capacity Category Cell Chance Channel Charge Chunk Cluster "
         "Color Cooldown Corner Cost Count Cover Crest Curve Cycle Damage Deadline Decay Delay Density Depth Detail Direction Distance Drag Duration Edge Effect Energy Entry Extent Factor Falloff "
         "Field Filter Focus Force Formation Frame Friction Fuel Gain Gate Goal Gradient Grid Group Growth Handle Heading Heat Height History Horizon Impulse Index Input Intensity Interval Item "
         "Key Lane Latency Layer Length Level Lifetime Limit Link Load Location Mask Mass Material Mesh Modifier Moisture Momentum Noise Normal Offset Opacity Orbit Order Output Overlap Owner "
         "Parameter Patch Path Pattern Period Phase Pitch Plan Pool Portal Position Power Pressure Priority Profile Progress Quality Query Queue Radius Range Rank Rate Ratio Reach Reaction "
         "Record Reference Region Request Resistance Resolution Response Result Reward Ridge Role Rotation Route Rule Sample Scale Score Seed Segment Sensor Shadow Shape Shift Signal Size Skill "
         "Slope Slot Snapshot Socket Source Span Spawn Speed Spline Stage State Step Stiffness Strength Stride Style Surface Sway Tag Team Temperature Tension Threshold Tick Tile Tilt Timer Token "
         "Torque Track Trait Transition Trigger Turn Unit Update Value Variant Velocity Vertex Viewpoint Visibility Volume Warmth Wave Weight Width Wind Zone").split()

VERBS = ("Add Apply Attach Begin Blend Build Cancel Change Check Clear Collect Commit Compute Consume Copy Create Damage Deliver Detach Draw Drop Emit Enable Enqueue Equip Evaluate Expand Fade "
         "Fetch Fill Find Fire Flush Follow Force Grow Handle Heal Insert Interrupt Join Launch Leave Lock Make Mark Merge Move Notify Open Order Pause Place Play Plan Pop Predict Prepare Process "
         "Push Query Raise Rebuild Receive Record Refresh Register Release Remove Repair Replace Request Reset Resolve Restart Restore Resume Rotate Sample Save Select Send Show Shuffle Simulate Skip "
         "Snap Sort Spawn Split Start Stop Store Submit Swap Switch Tick Toggle Trace Transfer Trim Try Undo Unlock Update Use Validate Wait Wake").split()

ACTOR_SUFFIXES = "Actor Spawner Volume Manager Marker Pawn Gate Beacon Station Controller Tower Platform Prop Emitter Turret Vehicle Trigger".split()
COMPONENT_SUFFIXES = ["Component"]
OBJECT_SUFFIXES = "Data Asset Definition Task Instance Profile Rule Handler Policy Factory Config Recipe Effect Object Strategy".split()
STRUCT_SUFFIXES = "Info State Settings Entry Params Row Key Result Snapshot Config Sample Stats Request Options Handle".split()
ENUM_SUFFIXES = "Mode Type State Phase Kind Policy Reason Level Flags Channel Category Status".split()

#: Names that are fine in C++ and reserved, built in or taken in Python, or by the SDK's own members. For functions of classes.
RESERVED_FUNCTIONS = "lambda def from pass is print with del elif except finally nonlocal yield await raise global async get set call send_ async_ is_valid get_class type_ None_ cast unreal_name".split()
RESERVED_PROPERTIES = "lambda in_ is def from pass with del async await yield raise global self list dict str type id len get set async_ send_ get_or_none object property mro".split()
RESERVED_PARAMETERS = "self from in is lambda def with async type object list str len None pass print cls args kwargs".split()
RESERVED_STRUCT_FIELDS = "get set copy from is lambda with type to_dict from_dict struct_name field_names def pass keys items".split()
RESERVED_ENTRIES = "None name value mro True_ Self lambda from is in pass class_ Not".split()

#: Members of the engine classes that ours derive from, as far as the words above can make them; neither a member nor a parameter of ours may hide one.
ENGINE_MEMBERS = {name.lower() for name in (
    "Owner Instigator Tags World RootComponent Class Outer Name Location Rotation Mobility Role SendQueue Mask Bounds BoundsScale StaticMesh RelativeLocation RelativeRotation bHidden bVisible "
    "Add AddLocalOffset AddLocalRotation AddRelativeLocation AddRelativeRotation AddWorldOffset AddWorldRotation BeginPlay GetDefaultAttachComponent GetLevel GetLocalBounds GetLocalRole GetLocation "
    "GetMaterial GetMaterialIndex GetOuter GetOwner GetOwnerRole GetRelativeLocation GetRelativeRotation GetRemoteRole GetRotation GetSocketLocation GetSocketRotation GetStaticMesh GetTargetLocation "
    "GetVelocity GetWorld IsActive IsHidden IsVisible MoveComponent NotifyHit OnAttachmentChanged OnLeaveWorld OnRegister OnVisibilityChanged OnWorldBeginPlay ReceiveBeginPlay ReceiveHit ReceiveTick "
    "RegisterComponent Reset SetActive SetBoundsScale SetHidden SetMaterial SetOwner SetRelativeLocation SetRelativeRotation SetStaticMesh SetTickGroup SetVisibility SetWorldLocation SetWorldRotation "
    "Tick TickActor TickComponent ToggleActive ToggleVisibility UpdateBounds").split()}

UNITS = [("Distance", "cm", "in cm"), ("Speed", "cm/s", "in cm/s"), ("Angle", "deg", "in degrees"), ("Duration", "s", "in seconds"), ("Delay", "s", "(seconds)"), ("Mass", "kg", "[kg]"),
         ("Temperature", "C", "in degrees Celsius"), ("Force", "N", "in newtons"), ("Height", "cm", "in cm above the ground"), ("Radius", "cm", "[cm]"), ("Rate", "Hz", "(Hz)"), ("Length", "m", "in metres"),
         ("Torque", "Nm", "in newton metres"), ("Interval", "s", "in seconds"), ("Lifetime", "s", "in seconds")]

SENTENCES = ["Kept up to date by the owner", "Only valid after BeginPlay", "Nothing happens when it is zero", "Used by designers to tune the feel of the feature", "Changes take effect in the next frame",
             "Expensive: do not call every tick", "Safe to call from any thread", "Not replicated", "See also the setting of the same name in the project settings", "The result is cached until the next update",
             "Clamped to the limits of the profile", "Zero means \"no limit\"", "Never null once the world has started", "Negative values are treated as 0", "Works in the editor as well (not in PIE)",
             "1) waits for streaming, 2) applies the change", "Comparable to <b>UE</b>'s own, but per instance", "A value of 0.5 * Scale is a good start; 100% is too much", "Uses `FMath::Lerp` between both ends"]

ITEMS = ["the nearest one wins", "the rest is ignored", "a missing asset is reported once", "order does not matter", "duplicates are dropped"]
