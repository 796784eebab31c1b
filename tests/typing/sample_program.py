# SPDX-License-Identifier: MIT
"""A typed program as a user writes it: everything that stubs promise, in one place.

It is checked by mypy (--strict) and pyright (strict), where ``assert_type`` states what the checkers must see, and it runs against the
embedded engine, where ``same`` states what the engine must give. ``python tests/typing/sample_program.py`` runs it by hand.
"""

from __future__ import annotations

from typing import TypeVar

from typing_extensions import assert_type

import spear
from spear import Future
from spear.typing import ArrayPath, AsyncPath, AsyncValuePath, Path, ValuePath
from spear.unreal.CoreUObject import FColor, FRotator, FScriptDelegate, FTransform, FVector, UClass, UObject
from spear.unreal.Engine import (
    AActor,
    AActor_K2_SetActorLocation_Result,
    APlayerController,
    APointLight,
    AStaticMeshActor,
    EComponentMobility,
    EComponentMobility_in,
    FHitResult,
    FVector_NetQuantize,
    UGameplayStatics,
    UKismetMathLibrary,
    UKismetSystemLibrary,
    UMaterialInterface,
    UPointLightComponent,
    UPrimitiveComponent,
    USceneComponent,
    UStaticMesh,
    UStaticMeshComponent,
)

T = TypeVar("T")


def same(found: T, expected: T) -> T:
    """Gives the value if it is the one expected."""
    if found != expected:
        raise AssertionError(f"found {found!r}, expected {expected!r}")
    return found


def functions(actor: AStaticMeshActor) -> None:
    """Functions: inherited ones, keywords, positions, defaults, structs in each of their forms."""
    actor.SetActorScale3D(NewScale3D=FVector(X=4, Y=4, Z=4))
    scale = actor.GetActorScale3D()
    assert_type(scale, FVector)
    same(scale, FVector(4, 4, 4))
    actor.SetActorScale3D({"X": 1, "Y": 2, "Z": 3})  # a dictionary of fields
    actor.SetActorScale3D([2, 2, 2])  # its numbers in order
    same(actor.GetActorScale3D().X, 2.0)
    assert_type(actor.ActorHasTag("sample"), bool)
    same(actor.ActorHasTag(Tag="sample"), True)
    assert_type(actor.GetComponentByClass(USceneComponent), USceneComponent | None)  # the class asked for
    assert_type(actor.K2_GetRootComponent(), USceneComponent)  # never null, as far as its documentation tells
    assert_type(actor.GetAttachParentActor(), AActor | None)
    same(actor.GetAttachParentActor(), None)
    assert_type(actor.GetTransform(), FTransform)


def outputs(actor: AActor) -> None:
    """Out-parameters: a named tuple, return value first."""
    result = actor.K2_SetActorLocation(NewLocation=FVector(7, 8, 9), bSweep=False, bTeleport=True)
    assert_type(result, AActor_K2_SetActorLocation_Result)
    assert_type(result.ReturnValue, bool)
    same(result.ReturnValue, True)
    moved, hit = result
    assert_type(moved, bool)
    assert_type(hit, FHitResult)
    assert_type(hit.bBlockingHit, bool)
    assert_type(hit.Time, float)
    assert_type(hit.ImpactPoint, FVector_NetQuantize)
    same(hit.bBlockingHit, False)
    bounds = actor.GetActorBounds(bOnlyCollidingComponents=False)
    assert_type(bounds.Origin, FVector)
    assert_type(bounds.BoxExtent, FVector)


def variables(actor: AStaticMeshActor) -> None:
    """Variables are paths, of any depth; assignment writes."""
    assert_type(actor.bHidden, Path[bool])
    assert_type(actor.bHidden.get(), bool)
    actor.bHidden = True
    same(actor.bHidden.get(), True)
    actor.bHidden.set(False)
    assert_type(actor.CustomTimeDilation.get(), float)
    actor.CustomTimeDilation = 0.5
    actor.CustomTimeDilation = 2  # an int is a float to Python
    same(actor.CustomTimeDilation.get(), 2.0)

    root = actor.RootComponent.get()
    assert_type(root, USceneComponent)
    assert_type(actor.RootComponent.get_or_none(), USceneComponent | None)
    assert_type(root.AttachParent.get_or_none(), USceneComponent | None)
    same(root.AttachParent.get_or_none(), None)
    assert_type(actor.RootComponent.RelativeLocation.get(), FVector)
    assert_type(actor.RootComponent.RelativeLocation.X, Path[float])
    assert_type(actor.RootComponent.RelativeLocation.X.get(), float)
    actor.RootComponent.RelativeLocation.X = 3.5
    same(actor.RootComponent.RelativeLocation.X.get(), 3.5)
    actor.RootComponent.RelativeLocation = FVector(1, 2, 3)
    same(root.RelativeLocation.get(), FVector(1, 2, 3))
    assert_type(actor.RootComponent.K2_GetComponentLocation(), FVector)  # functions of the object that a path leads to

    assert_type(actor.Tags, ArrayPath[str, str | Future[str], Path[str], AsyncPath[str]])
    assert_type(actor.Tags.get(), list[str])
    actor.Tags = ["sample", "two"]
    actor.Tags[1] = "three"
    assert_type(actor.Tags[1].get(), str)
    same(actor.Tags.get(), ["sample", "three"])

    mesh = actor.StaticMeshComponent.get()
    assert_type(mesh, UStaticMeshComponent)
    assert_type(mesh.OverrideMaterials.get(), list[UMaterialInterface | None])
    assert_type(mesh.LightingChannels.bChannel0.get(), bool)
    assert_type(actor.OnDestroyed.get(), list[FScriptDelegate])
    same(actor.OnDestroyed.get(), [])


def enums(root: USceneComponent) -> None:
    """Enums: entries, their names as arguments, arithmetic of integers."""
    assert_type(root.Mobility, ValuePath[EComponentMobility, EComponentMobility_in])
    assert_type(root.Mobility.get(), EComponentMobility)
    root.SetMobility(EComponentMobility.Movable)
    same(root.Mobility.get(), EComponentMobility.Movable)
    root.SetMobility(NewMobility="Movable")
    same(EComponentMobility("Movable"), EComponentMobility.Movable)
    number: int = EComponentMobility.Movable
    same(number, 2)


def futures(actor: AStaticMeshActor) -> None:
    """``async_`` gives futures, futures are arguments; ``send_`` gives nothing."""
    location = actor.async_.K2_GetActorLocation()
    assert_type(location, Future[FVector])
    moved = actor.async_.K2_SetActorLocation(location, False, bTeleport=True)
    assert_type(moved, Future[AActor_K2_SetActorLocation_Result])
    assert_type(location.get(), FVector)
    same(moved.get().ReturnValue, True)
    assert_type(actor.async_.bHidden, AsyncPath[bool])
    assert_type(actor.async_.bHidden.get(), Future[bool])
    assert_type(actor.bHidden.async_.get(), Future[bool])
    same(actor.async_.bHidden.get().get(), False)
    root = actor.async_.RootComponent.get()
    assert_type(root, Future[USceneComponent])
    assert_type(actor.async_.RootComponent.RelativeLocation.X.get(), Future[float])
    assert_type(actor.RootComponent.async_.K2_GetComponentRotation(), Future[FRotator])
    assert_type(actor.async_.RootComponent.Mobility, AsyncValuePath[EComponentMobility, EComponentMobility_in])
    written = actor.async_.CustomTimeDilation.set(1.0)
    assert_type(written, Future[None])
    written.get()
    actor.send_.SetActorScale3D(FVector(1, 1, 1))
    actor.send_.bHidden = False
    actor.CustomTimeDilation.send_.set(1.0)


def lookups(game: spear.Game) -> AStaticMeshActor:
    """Lookups by class give objects of that class."""
    actor = game.spawn_actor(AStaticMeshActor, location=FVector(X=-10, Y=280, Z=50), tags=["sample"])
    assert_type(actor, AStaticMeshActor)
    assert_type(game.find_actor_by_tag("sample", AStaticMeshActor), AStaticMeshActor)
    same(game.find_actor_by_tag("sample", AStaticMeshActor), actor)
    assert_type(game.find_actors_by_class(APointLight), list[APointLight])
    assert_type(game.find_actors_by_name("Table*"), list[spear.UnrealObject])
    later = game.async_.find_actor_by_tag("sample", AStaticMeshActor)
    assert_type(later, Future[AStaticMeshActor])
    assert_type(later.object.async_.K2_GetActorLocation(), Future[FVector])  # calls on an object that is still to come: no round trip
    same(later.object.async_.K2_GetActorLocation().get(), FVector(-10, 280, 50))
    assert_type(game.get_component_by_class(actor, UStaticMeshComponent), UStaticMeshComponent)
    assert_type(actor.get_component(UPrimitiveComponent), UPrimitiveComponent)
    cube = game.load_object("/Engine/BasicShapes/Cube.Cube", UStaticMesh)
    assert_type(cube, UStaticMesh)
    actor.StaticMeshComponent.get().SetStaticMesh(cube)
    light = game.spawn_actor(APointLight)
    component = light.get_component(UPointLightComponent)
    component.LightColor = FColor(R=255, G=128, B=0)
    assert_type(component.LightColor.R.get(), int)
    same(component.LightColor.R.get(), 255)
    component.AttenuationRadius = 300
    assert_type(game.destroy_actor(light), bool)
    return actor


def statics(game: spear.Game, actor: AActor) -> None:
    """Static functions, through the class."""
    math = game.get_class(UKismetMathLibrary)
    assert_type(math, UKismetMathLibrary)
    assert_type(math.MakeVector(1, 2, Z=3), FVector)
    same(math.MakeVector(1, 2, Z=3), FVector(1, 2, 3))
    parts = math.BreakTransform(FTransform())
    assert_type(parts.Rotation, FRotator)
    found = game.get_class(UGameplayStatics).GetAllActorsOfClass(ActorClass=AStaticMeshActor)
    assert_type(found.OutActors, list[AActor])
    same(actor in found.OutActors, True)
    assert_type(game.get_class(UKismetSystemLibrary).GetDisplayName(actor), str)
    assert_type(game.get_class(UKismetSystemLibrary).async_.Delay(Duration=0.01), Future[None])
    assert_type(spear.cast(AStaticMeshActor, actor), AStaticMeshActor)
    if isinstance(actor, APlayerController):
        assert_type(actor.IsLookInputIgnored(), bool)
    kind: type[AActor] = AStaticMeshActor
    same(kind.unreal_name, "AStaticMeshActor")
    nothing: UObject | UClass | None = None
    same(nothing, None)


def main(instance: spear.Instance) -> None:
    """All of it."""
    game = instance.get_game()
    with instance.begin_frame():
        actor = lookups(game)
        enums(actor.RootComponent.get())
        functions(actor)
        outputs(actor)
        variables(actor)
        futures(actor)
        statics(game, actor)
        same(game.destroy_actor(actor), True)
    with instance.end_frame():
        pass


if __name__ == "__main__":
    with spear.launch(scene="apartment") as launched:
        main(launched)
