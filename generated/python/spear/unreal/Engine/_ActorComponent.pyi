# generated, do not edit (Engine: Public/Components/ActorComponent.h)
from collections.abc import Sequence
from typing import TypeAlias
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncObjectPath, AsyncPath, AsyncValuePath, BoolProperty, Future, ObjectPath, Path, Property,
    SendBoolProperty, SendProperty, ValuePath,
)
from ..CoreUObject._Intrinsic import FScriptDelegate, FScriptDelegate_in
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send
from ._Actor import AActor
from ._EngineBaseTypes import ETickingGroup_in, FActorComponentTickFunction_async, FActorComponentTickFunction_in, FActorComponentTickFunction_path
from ._EngineTypes import EComponentCreationMethod, EComponentCreationMethod_in, EEndPlayReason_in

FActorComponentActivatedSignature: TypeAlias = list[FScriptDelegate]
"""Called as FActorComponentActivatedSignature(Component: UActorComponent, bReset: bool); a value tells what is bound.

Unreal: /Script/Engine.ActorComponentActivatedSignature__DelegateSignature
"""

FActorComponentDeactivateSignature: TypeAlias = list[FScriptDelegate]
"""Called as FActorComponentDeactivateSignature(Component: UActorComponent); a value tells what is bound.

Unreal: /Script/Engine.ActorComponentDeactivateSignature__DelegateSignature
"""

class UActorComponent_members(UObject_members):
    """Functions and variables of UActorComponent."""
    def Activate(self, bReset: bool | Future[bool] = False) -> None:
        """Activates the SceneComponent, should be overridden by native child classes.

        Args:
            bReset: whether the activation should happen even if ShouldActivate returns false.

        Unreal: UActorComponent.Activate
        """
    def AddTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> None:
        """Make this component tick after PrerequisiteActor.

        Unreal: UActorComponent.AddTickPrerequisiteActor
        """
    def AddTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> None:
        """Make this component tick after PrerequisiteComponent.

        Unreal: UActorComponent.AddTickPrerequisiteComponent
        """
    def ComponentHasTag(self, Tag: str | Future[str]) -> bool:
        """See if this component contains the supplied tag.

        Unreal: UActorComponent.ComponentHasTag
        """
    def Deactivate(self) -> None:
        """Deactivates the SceneComponent.

        Unreal: UActorComponent.Deactivate
        """
    def GetComponentTickInterval(self) -> float:
        """Returns the tick interval for this component's primary tick function, which is the frequency in seconds at
        which it will be executed.

        Unreal: UActorComponent.GetComponentTickInterval
        """
    def GetOwner(self) -> AActor | None:
        """Follow the Outer chain to get the AActor that 'Owns' this component.

        Unreal: UActorComponent.GetOwner
        """
    def IsActive(self) -> bool:
        """Returns whether the component is active or not.

        Unreal: UActorComponent.IsActive
        """
    def IsBeingDestroyed(self) -> bool:
        """Returns whether the component is in the process of being destroyed.

        Unreal: UActorComponent.IsBeingDestroyed
        """
    def IsComponentTickEnabled(self) -> bool:
        """Returns whether this component has tick enabled or not.

        Unreal: UActorComponent.IsComponentTickEnabled
        """
    def K2_DestroyComponent(self, Object: UObject | Future[UObject]) -> None:
        """Unregister and mark for pending kill a component. This may not be used to destroy a component that is owned by
        an actor unless the owning actor is calling the function.

        Args:
            Object: the actor that calls: the owner, or the component itself.

        Unreal: UActorComponent.K2_DestroyComponent
        """
    def ReceiveBeginPlay(self) -> None:
        """Blueprint implementable event for when the component is beginning play, called before its Owner's BeginPlay on
        Actor BeginPlay or when the component is dynamically created if the Actor has already BegunPlay.

        Unreal: UActorComponent.ReceiveBeginPlay
        """
    def ReceiveEndPlay(self, EndPlayReason: EEndPlayReason_in) -> None:
        """Blueprint implementable event for when the component ends play, generally via destruction or its Actor's
        EndPlay.

        Unreal: UActorComponent.ReceiveEndPlay
        """
    def ReceiveTick(self, DeltaSeconds: float | Future[float]) -> None:
        """Event called every frame if tick is enabled.

        Unreal: UActorComponent.ReceiveTick
        """
    def RemoveTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> None:
        """Remove tick dependency on PrerequisiteActor.

        Unreal: UActorComponent.RemoveTickPrerequisiteActor
        """
    def RemoveTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> None:
        """Remove tick dependency on PrerequisiteComponent.

        Unreal: UActorComponent.RemoveTickPrerequisiteComponent
        """
    def SetActive(self, bNewActive: bool | Future[bool], bReset: bool | Future[bool] = False) -> None:
        """Sets whether the component is active or not.

        Args:
            bNewActive: the new active state of the component.
            bReset: whether the activation should happen even if ShouldActivate returns false.

        Unreal: UActorComponent.SetActive
        """
    def SetAutoActivate(self, bNewAutoActivate: bool | Future[bool]) -> None:
        """Sets whether the component should be auto activate or not. Only safe during construction scripts.

        Unreal: UActorComponent.SetAutoActivate
        """
    def SetComponentTickEnabled(self, bEnabled: bool | Future[bool]) -> None:
        """Set this component's tick functions to be enabled or disabled. Only has an effect if the function is
        registered.

        Unreal: UActorComponent.SetComponentTickEnabled
        """
    def SetComponentTickInterval(self, TickInterval: float | Future[float]) -> None:
        """Sets the tick interval for this component's primary tick function. Does not enable the tick interval. Takes
        effect on next tick.

        Args:
            TickInterval: seconds.

        Unreal: UActorComponent.SetComponentTickInterval
        """
    def SetTickGroup(self, NewTickGroup: ETickingGroup_in) -> None:
        """Changes the ticking group for this component.

        Unreal: UActorComponent.SetTickGroup
        """
    def SetTickableWhenPaused(self, bTickableWhenPaused: bool | Future[bool]) -> None:
        """Sets whether this component can tick when paused.

        Unreal: UActorComponent.SetTickableWhenPaused
        """
    def ToggleActive(self) -> None:
        """Toggles the active state of the component.

        Unreal: UActorComponent.ToggleActive
        """
    PrimaryComponentTick: Property[FActorComponentTickFunction_path, FActorComponentTickFunction_in]
    """Main tick function for the Component.

    Unreal: UActorComponent.PrimaryComponentTick (FActorComponentTickFunction)
    """
    ComponentTags: Property[ArrayPath[str, str | Future[str], Path[str], AsyncPath[str]], Sequence[str | Future[str]] | Future[list[str]]]
    """Array of tags that can be used for grouping and categorizing. Can also be accessed from scripting.

    Unreal: UActorComponent.ComponentTags (TArray<FName>)
    """
    bEditableWhenInherited: BoolProperty
    """True if this component can be modified when it was inherited from a parent actor class.

    Unreal: UActorComponent.bEditableWhenInherited (bool)
    """
    bAutoActivate: BoolProperty
    """Whether the component is activated at creation or must be explicitly activated.

    Unreal: UActorComponent.bAutoActivate (bool)
    """
    CreationMethod: Property[ValuePath[EComponentCreationMethod, EComponentCreationMethod_in], EComponentCreationMethod_in]
    """Describes how a component instance was created.

    Unreal: UActorComponent.CreationMethod (EComponentCreationMethod)
    """
    OnComponentActivated: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component has been activated, with parameter indicating if it was from a reset.

    Delegate: FActorComponentActivatedSignature(Component: UActorComponent, bReset: bool)

    Unreal: UActorComponent.OnComponentActivated (FActorComponentActivatedSignature)
    """
    OnComponentDeactivated: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component has been deactivated.

    Delegate: FActorComponentDeactivateSignature(Component: UActorComponent)

    Unreal: UActorComponent.OnComponentDeactivated (FActorComponentDeactivateSignature)
    """
    bIsActive: BoolProperty
    """Whether the component is currently active.

    Unreal: UActorComponent.bIsActive (bool)
    """

class UActorComponent_async(UObject_async):
    """UActorComponent under ``async_``: each function gives a future."""
    def Activate(self, bReset: bool | Future[bool] = False) -> Future[None]:
        """Activates the SceneComponent, should be overridden by native child classes."""
    def AddTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> Future[None]:
        """Make this component tick after PrerequisiteActor."""
    def AddTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> Future[None]:
        """Make this component tick after PrerequisiteComponent."""
    def ComponentHasTag(self, Tag: str | Future[str]) -> Future[bool]:
        """See if this component contains the supplied tag."""
    def Deactivate(self) -> Future[None]:
        """Deactivates the SceneComponent."""
    def GetComponentTickInterval(self) -> Future[float]:
        """Returns the tick interval for this component's primary tick function, which is the frequency in seconds at which it will be executed."""
    def GetOwner(self) -> Future[AActor | None]:
        """Follow the Outer chain to get the AActor that 'Owns' this component."""
    def IsActive(self) -> Future[bool]:
        """Returns whether the component is active or not."""
    def IsBeingDestroyed(self) -> Future[bool]:
        """Returns whether the component is in the process of being destroyed."""
    def IsComponentTickEnabled(self) -> Future[bool]:
        """Returns whether this component has tick enabled or not."""
    def K2_DestroyComponent(self, Object: UObject | Future[UObject]) -> Future[None]:
        """Unregister and mark for pending kill a component."""
    def ReceiveBeginPlay(self) -> Future[None]:
        """Blueprint implementable event for when the component is beginning play, called before its Owner's BeginPlay on Actor BeginPlay or when the component is dynamically created if the Actor has already BegunPlay."""
    def ReceiveEndPlay(self, EndPlayReason: EEndPlayReason_in) -> Future[None]:
        """Blueprint implementable event for when the component ends play, generally via destruction or its Actor's EndPlay."""
    def ReceiveTick(self, DeltaSeconds: float | Future[float]) -> Future[None]:
        """Event called every frame if tick is enabled."""
    def RemoveTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> Future[None]:
        """Remove tick dependency on PrerequisiteActor."""
    def RemoveTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> Future[None]:
        """Remove tick dependency on PrerequisiteComponent."""
    def SetActive(self, bNewActive: bool | Future[bool], bReset: bool | Future[bool] = False) -> Future[None]:
        """Sets whether the component is active or not."""
    def SetAutoActivate(self, bNewAutoActivate: bool | Future[bool]) -> Future[None]:
        """Sets whether the component should be auto activate or not."""
    def SetComponentTickEnabled(self, bEnabled: bool | Future[bool]) -> Future[None]:
        """Set this component's tick functions to be enabled or disabled."""
    def SetComponentTickInterval(self, TickInterval: float | Future[float]) -> Future[None]:
        """Sets the tick interval for this component's primary tick function."""
    def SetTickGroup(self, NewTickGroup: ETickingGroup_in) -> Future[None]:
        """Changes the ticking group for this component."""
    def SetTickableWhenPaused(self, bTickableWhenPaused: bool | Future[bool]) -> Future[None]:
        """Sets whether this component can tick when paused."""
    def ToggleActive(self) -> Future[None]:
        """Toggles the active state of the component."""
    PrimaryComponentTick: Property[FActorComponentTickFunction_async, FActorComponentTickFunction_in]
    """Main tick function for the Component."""
    ComponentTags: Property[AsyncArrayPath[str, str | Future[str], AsyncPath[str]], Sequence[str | Future[str]] | Future[list[str]]]
    """Array of tags that can be used for grouping and categorizing."""
    bEditableWhenInherited: AsyncBoolProperty
    """True if this component can be modified when it was inherited from a parent actor class."""
    bAutoActivate: AsyncBoolProperty
    """Whether the component is activated at creation or must be explicitly activated."""
    CreationMethod: Property[AsyncValuePath[EComponentCreationMethod, EComponentCreationMethod_in], EComponentCreationMethod_in]
    """Describes how a component instance was created."""
    OnComponentActivated: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component has been activated, with parameter indicating if it was from a reset."""
    OnComponentDeactivated: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component has been deactivated."""
    bIsActive: AsyncBoolProperty
    """Whether the component is currently active."""

class UActorComponent_send(UObject_send):
    """UActorComponent under ``send_``: no function answers."""
    def Activate(self, bReset: bool | Future[bool] = False) -> None:
        """Activates the SceneComponent, should be overridden by native child classes."""
    def AddTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> None:
        """Make this component tick after PrerequisiteActor."""
    def AddTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> None:
        """Make this component tick after PrerequisiteComponent."""
    def ComponentHasTag(self, Tag: str | Future[str]) -> None:
        """See if this component contains the supplied tag."""
    def Deactivate(self) -> None:
        """Deactivates the SceneComponent."""
    def GetComponentTickInterval(self) -> None:
        """Returns the tick interval for this component's primary tick function, which is the frequency in seconds at which it will be executed."""
    def GetOwner(self) -> None:
        """Follow the Outer chain to get the AActor that 'Owns' this component."""
    def IsActive(self) -> None:
        """Returns whether the component is active or not."""
    def IsBeingDestroyed(self) -> None:
        """Returns whether the component is in the process of being destroyed."""
    def IsComponentTickEnabled(self) -> None:
        """Returns whether this component has tick enabled or not."""
    def K2_DestroyComponent(self, Object: UObject | Future[UObject]) -> None:
        """Unregister and mark for pending kill a component."""
    def ReceiveBeginPlay(self) -> None:
        """Blueprint implementable event for when the component is beginning play, called before its Owner's BeginPlay on Actor BeginPlay or when the component is dynamically created if the Actor has already BegunPlay."""
    def ReceiveEndPlay(self, EndPlayReason: EEndPlayReason_in) -> None:
        """Blueprint implementable event for when the component ends play, generally via destruction or its Actor's EndPlay."""
    def ReceiveTick(self, DeltaSeconds: float | Future[float]) -> None:
        """Event called every frame if tick is enabled."""
    def RemoveTickPrerequisiteActor(self, PrerequisiteActor: AActor | Future[AActor]) -> None:
        """Remove tick dependency on PrerequisiteActor."""
    def RemoveTickPrerequisiteComponent(self, PrerequisiteComponent: UActorComponent | Future[UActorComponent]) -> None:
        """Remove tick dependency on PrerequisiteComponent."""
    def SetActive(self, bNewActive: bool | Future[bool], bReset: bool | Future[bool] = False) -> None:
        """Sets whether the component is active or not."""
    def SetAutoActivate(self, bNewAutoActivate: bool | Future[bool]) -> None:
        """Sets whether the component should be auto activate or not."""
    def SetComponentTickEnabled(self, bEnabled: bool | Future[bool]) -> None:
        """Set this component's tick functions to be enabled or disabled."""
    def SetComponentTickInterval(self, TickInterval: float | Future[float]) -> None:
        """Sets the tick interval for this component's primary tick function."""
    def SetTickGroup(self, NewTickGroup: ETickingGroup_in) -> None:
        """Changes the ticking group for this component."""
    def SetTickableWhenPaused(self, bTickableWhenPaused: bool | Future[bool]) -> None:
        """Sets whether this component can tick when paused."""
    def ToggleActive(self) -> None:
        """Toggles the active state of the component."""
    PrimaryComponentTick: SendProperty[FActorComponentTickFunction_in]
    ComponentTags: SendProperty[Sequence[str | Future[str]] | Future[list[str]]]
    bEditableWhenInherited: SendBoolProperty
    bAutoActivate: SendBoolProperty
    CreationMethod: SendProperty[EComponentCreationMethod_in]
    OnComponentActivated: SendProperty[Sequence[FScriptDelegate_in] | None]
    OnComponentDeactivated: SendProperty[Sequence[FScriptDelegate_in] | None]
    bIsActive: SendBoolProperty

class UActorComponent(UActorComponent_members, UObject):
    """ActorComponent is the base class for components that define reusable behavior that can be added to different
    types of Actors.

    Life: created (as a default subobject, by AddComponentByClass or NewObject), registered with the world of its
    owner, initialised, BeginPlay, ticks, EndPlay, unregistered, destroyed. A destroyed component lingers until
    the garbage is collected, as a destroyed actor does.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Components/UActorComponent

    Unreal: /Script/Engine.ActorComponent
    """
    @property
    def async_(self) -> UActorComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UActorComponent_send:
        """The same functions and variables, fire-and-forget."""

class UActorComponent_path(ObjectPath[UActorComponent, UActorComponent_async_path, UActorComponent_send], UActorComponent_members):
    """A variable that refers to an object of UActorComponent: its path."""

class UActorComponent_async_path(AsyncObjectPath[UActorComponent], UActorComponent_async):
    """The same under ``async_``."""
