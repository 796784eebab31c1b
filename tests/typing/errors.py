# SPDX-License-Identifier: MIT
"""Mistakes, none of which may pass: both type checkers must report each line marked ``# error``, and no other line.

(Not run; ``test_checkers.py`` reads it.)
"""

from __future__ import annotations

from typing import Any

import spear
from spear.unreal.CoreUObject import FRotator, FVector
from spear.unreal.Engine import AActor, APawn, APointLight, AStaticMeshActor, EComponentMobility, FHitResult, UPointLightComponent, USceneComponent


def functions(actor: AActor, pawn: APawn, vector: FVector, rotator: FRotator) -> None:
    actor.SetActorScale3D(NewScale3D=vector)
    actor.SetActorScale3D(NewScale=vector)  # error: no such parameter
    actor.SetActorScale3D(rotator)  # error: another struct
    actor.SetActorScale3D("large")  # error: no struct at all
    actor.SetActorScale3D()  # error: missing
    actor.SetActorScale3D({"X": 1, "Q": 2})  # error: no such field
    actor.SetActorScale3D({"X": "one"})  # error: a field of another type
    actor.SetActorScale4D(vector)  # error: no such function
    actor.ActorHasTag(3)  # error: a number is no name
    actor.SetOwner(NewOwner=vector)  # error: a struct is no object
    actor.SetOwner(NewOwner=None)  # error: nothing says that it may be null
    pawn.AddMovementInput(vector, "fast")  # error: a text is no number
    name: str = actor.GetActorScale3D()  # error: a vector is no text
    print(name)
    actor.GetAttachParentActor().GetActorScale3D()  # error: may be None
    actor.K2_GetActorLocation().Q  # error: no such field


def variables(actor: AStaticMeshActor, light: APointLight) -> None:
    if actor.bHidden:  # error: a path is not its value
        pass
    if not actor.bHidden:  # error: nor under "not"
        pass
    while actor.bHidden.get() and actor.bActorEnableCollision:  # error: nor in an expression
        break
    if actor.bHidden == True:  # error: nor to compare with  # noqa: E712
        pass
    print(actor.CustomTimeDilation + 1)  # error: nor to add to
    for tag in actor.Tags:  # error: nor to go through
        pass
    print(len(actor.Tags))  # error: nor to count
    actor.bHidden = "yes"  # error: a text is no bool
    actor.bHidde = True  # error: no such variable
    actor.CustomTimeDilation = "slow"  # error: a text is no number
    actor.RootComponent.RelativeLocation.Q.get()  # error: no such field
    actor.RootComponent.RelativeLocation = FRotator()  # error: another struct
    actor.RootComponent.RelativeLocation.X = "far"  # error: a text is no number
    actor.RootComponent = actor  # error: an actor is no component
    actor.Tags = [1, 2]  # error: numbers are no names
    actor.Tags[0] = 1  # error: a number is no name
    actor.StaticMeshComponent.get().Mobility = 17.5  # error: no enum
    owner: AActor = actor.Owner  # error: a path is no object
    owner = actor.Owner.get_or_none()  # error: may be None
    print(owner)
    light.PointLightComponent.Intensity.get().hex().upper().nothing()  # error: a text has no such method


def enums(root: USceneComponent) -> None:
    root.SetMobility(EComponentMobility.Movabel)  # error: no such entry
    root.SetMobility(FVector())  # error: no enum
    print(EComponentMobility.Static.nothing)  # error: no such attribute


def structs(hit: FHitResult) -> None:
    FHitResult(bBlocking=True)  # error: no such field
    FHitResult(Time="late")  # error: a text is no number
    FVector(1, 2, "three")  # error: a text is no number
    print(hit.Distanc)  # error: no such field


def futures(actor: AStaticMeshActor, other: AActor) -> None:
    location: FVector = actor.async_.K2_GetActorLocation()  # error: a future is not its value
    print(location)
    actor.async_.SetActorScale3D(NewScale=FVector())  # error: no such parameter
    actor.async_.bHidden.get() + 1  # error: a future is no number
    other.K2_SetActorLocation(actor.async_.K2_GetActorRotation(), False, True)  # error: a future of another struct
    actor.send_.K2_GetActorLocation().X  # error: nothing comes back
    actor.send_.bHidden = "yes"  # error: a text is no bool


def lookups(game: spear.Game, anything: Any) -> None:
    light: APointLight = game.spawn_actor(AStaticMeshActor)  # error: another class
    print(light)
    game.spawn_actor(FVector)  # error: a struct is no class of objects
    game.find_actor_by_tag("a", APointLight).StaticMeshComponent  # error: no such variable
    component: UPointLightComponent = anything
    game.get_component_by_class(component, AActor).NoSuch()  # error: no such function
