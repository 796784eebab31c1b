# SPDX-License-Identifier: MIT
"""The paper's steady state: a program of asynchronous operations alone runs at the engine's native frame rate (section 3).

While the engine runs frame n, the program prepares transaction n + 1; the game thread never waits for it. See for yourself:

    spear trace --png steady_state.png -- python steady_state.py
"""

import argparse
import math

import spear
from spear.unreal.Engine import ACoordinateAxes, URotatingMovementComponent


def spawn_ring(instance: spear.Instance, count: int) -> list[ACoordinateAxes]:
    """Actors that turn around themselves in the world's tick, in one transaction without a wait."""
    game = instance.get_game()
    with instance.begin_frame():
        actors = [game.async_.spawn_actor(ACoordinateAxes) for _ in range(count)]
        for actor in actors:
            actor.object.async_.AddComponentByClass(  # on an actor that is not there yet: the engine passes it on
                Class=URotatingMovementComponent, bManualAttachment=False, RelativeTransform=spear.FTransform(), bDeferredFinish=False
            )
    with instance.end_frame():
        pass
    return [actor.get() for actor in actors]


def turn_ring(instance: spear.Instance, actors: list[ACoordinateAxes], transactions: int) -> float:
    """Moves all actors in each transaction, and looks at what the transaction before has read. Returns how high they were on average."""
    seen: list[spear.Future[spear.FVector]] = []
    height = 0.0
    for number in range(transactions):
        angle = 0.02 * number
        with instance.begin_frame():
            for index, actor in enumerate(actors):
                at = angle + 2 * math.pi * index / len(actors)
                where = spear.FVector(X=300 * math.cos(at), Y=300 * math.sin(at), Z=150 + 50 * math.sin(3 * at))
                actor.send_.K2_SetActorLocation(NewLocation=where, bSweep=False, bTeleport=True)  # nothing waits
        with instance.end_frame():
            read = [actor.async_.K2_GetActorLocation() for actor in actors]  # futures: nothing waits
        height += sum(location.get().Z for location in seen)  # read one transaction ago: there by now, or soon
        seen = read
    height += sum(location.get().Z for location in seen)
    return height / (transactions * len(actors))


def main() -> None:
    parser = argparse.ArgumentParser(description="Moves a ring of actors in every frame, by asynchronous operations alone.")
    parser.add_argument("--address", help="a running engine (unix:/path, tcp://host:port); one is started if this is not given")
    parser.add_argument("--actors", type=int, default=1000, help="how many (default: 1000)")
    parser.add_argument("--transactions", type=int, default=200, help="how many (default: 200)")
    parser.add_argument("--fps", type=float, default=120, help="frame rate of the engine that is started (default: 120)")
    options = parser.parse_args()
    with spear.connect(options.address) if options.address else spear.launch(scene="apartment", fps=options.fps) as instance:
        actors = spawn_ring(instance, options.actors)
        first = instance.call("engine_service.get_frame_number")
        height = turn_ring(instance, actors, options.transactions)
        frames = instance.call("engine_service.get_frame_number") - first
        print(f"{options.transactions} transactions of {2 * options.actors} operations in {frames} frames; the actors were {height:.1f} cm high on average")


if __name__ == "__main__":
    main()
