# SPDX-License-Identifier: MIT
"""The first program of the paper, in Python: getting_started.cpp beside it does the same and prints the same.

    tools/spear demo            runs both
    python getting_started.py   runs this one (starts the embedded engine)
"""

import argparse

import spear
from spear.unreal.Engine import ACoordinateAxes, AStaticMeshActor, UGameplayStatics, UProjectileMovementComponent


def spawn_axes(instance: spear.Instance, game: spear.Game) -> None:
    """One transaction: spawn, scale, read back, all within one frame."""
    with instance.begin_frame():  # work of this block runs at the beginning of a frame
        axes = game.spawn_actor(ACoordinateAxes, location=spear.FVector(X=-10, Y=280, Z=50))
        axes.SetActorScale3D(NewScale3D=spear.FVector(X=4, Y=4, Z=4))
        root = axes.RootComponent.get()
        location = root.async_.K2_GetComponentLocation()  # a future: nothing waits
        same_location = root.async_.call("GetComponentLocation")  # by name, here the paper's spelling of the same function
    with instance.end_frame():  # and work of this block at the end of the same frame
        scale = axes.RootComponent.RelativeScale3D.X.get()
    assert location.get() == same_location.get()
    where = location.get()
    print(f"axes at {where.X:.1f} {where.Y:.1f} {where.Z:.1f}, scaled by {scale:.1f}")


def throw_ball(instance: spear.Instance, game: spear.Game, steps: int) -> None:
    """A paused world, unpaused for exactly one frame at a time: deterministic, and the engine stays responsive in between."""
    statics = game.get_class(UGameplayStatics)
    with instance.begin_frame():
        statics.SetGamePaused(bPaused=True)
        ball = game.spawn_actor(AStaticMeshActor, location=(0, 0, 200))
        ball.StaticMeshComponent.SetMobility(NewMobility="Movable")
        added = ball.AddComponentByClass(
            Class=UProjectileMovementComponent, bManualAttachment=False, RelativeTransform=spear.FTransform(), bDeferredFinish=False
        )
        motion = spear.cast(UProjectileMovementComponent, added)
        motion.Velocity = spear.FVector(X=300, Y=0, Z=400)  # centimetres per second
    with instance.end_frame():
        pass
    for step in range(steps):
        with instance.begin_frame():
            statics.SetGamePaused(bPaused=False)
        with instance.end_frame():
            statics.SetGamePaused(bPaused=True)
            if (step + 1) % 10 == 0:
                location = ball.K2_GetActorLocation()
                print(f"step {step + 1:3d}: {location.X:9.3f} {location.Y:9.3f} {location.Z:9.3f}")


def count_reflection(instance: spear.Instance) -> None:
    """What the running engine exposes, counted in its live schema."""
    schema = instance.get_schema()
    classes = schema["classes"]
    functions = sum(len(c["functions"]) for c in classes)
    properties = sum(len(e["properties"]) for e in classes + schema["structs"])
    print(f"{len(classes)} classes, {functions} functions, {properties} properties")


def main() -> None:
    parser = argparse.ArgumentParser(description="Spawns coordinate axes, throws a ball step by step, counts what is reflected.")
    parser.add_argument("--address", help="a running engine (unix:/path, tcp://host:port); one is started if this is not given")
    parser.add_argument("--steps", type=int, default=100, help="frames of the ball's flight (default: 100)")
    options = parser.parse_args()
    with spear.connect(options.address) if options.address else spear.launch(scene="apartment", fixed_dt=1 / 60) as instance:
        game = instance.get_game()
        spawn_axes(instance, game)
        throw_ball(instance, game, options.steps)
        count_reflection(instance)


if __name__ == "__main__":
    main()
