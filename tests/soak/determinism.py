# SPDX-License-Identifier: MIT
"""Proves guarantee G9: a scene stepped by unpausing and pausing with a fixed time step gives the same bits in every run.

    PYTHONPATH=build/release/python build/venv/bin/python tests/soak/determinism.py [--steps 1000] [--runs 5]

Each run starts an engine of its own, with moving and attached actors, and reads all their transforms after each step: as many runs from Python
and from C++ (``end_to_end_tests --determinism``), idle and with all cores busy. Between steps the engine goes on running frames, and how many
differs from run to run. Exit code 1, with step, actor and numbers of the first difference, if any two runs differ in one bit. (The short form
of this is tests/python/test_determinism.py.)
"""

from __future__ import annotations

import argparse
import hashlib
import os
import subprocess
import sys
import tempfile
import time
from array import array
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import spear

GROUPS = 6
NUMBERS_PER_ACTOR = 10
BUILD = Path(os.environ.get("SPEAR_BUILD_DIR", Path(__file__).resolve().parents[2] / "build" / "release"))


def build_scene(game: spear.Game) -> list[spear.UnrealObject]:
    """Balls that fly, wheels that turn, and chains of actors attached to both: as in tests/end_to_end/determinism.cpp."""
    random = game.get_class("UKismetMathLibrary")
    actors: list[spear.UnrealObject] = []

    def spawn(x: float, y: float, z: float) -> spear.UnrealObject:
        actors.append(game.spawn_actor("ACameraActor", location=(x, y, z)))
        return actors[-1]

    def add(actor: spear.UnrealObject, component: str) -> spear.UnrealObject:
        return actor.AddComponentByClass(Class=component, bManualAttachment=False, RelativeTransform=spear.FTransform(), bDeferredFinish=False)

    for i in range(GROUPS):
        ball = spawn(50.0 * i, 0, 200 + 10.0 * i)
        motion = add(ball, "UProjectileMovementComponent")
        speed = random.RandomFloatInRange(Min=50.0, Max=150.0)
        motion.set("bRotationFollowsVelocity", i % 2 == 0)
        motion.set("Velocity", spear.FVector(speed, 7.0 * i, 300))
        wheel = spawn(50.0 * i, 300, 100)
        rotation = add(wheel, "URotatingMovementComponent")
        rotation.set("RotationRate", spear.FRotator(11.0 * i, 45, 3.0 * i))
        rotation.set("PivotTranslation", spear.FVector(1.0 * i, 20, 0))
        parent = wheel if i % 2 == 0 else ball
        for link in range(1, 4):
            child = spawn(50.0 * i + 10 * link, 310, 100 + 20.0 * link)
            child.K2_AttachToActor(
                ParentActor=parent, SocketName="None", LocationRule="KeepWorld", RotationRule="KeepWorld", ScaleRule="KeepWorld",
                bWeldSimulatedBodies=False,
            )
            parent = child
        add(parent, "URotatingMovementComponent").set("RotationRate", spear.FRotator(0, 0, 90))
    return actors


def run_python(instance: spear.Instance, steps: int) -> bytes:
    """All transforms after each step: ten doubles for each actor (quaternion X Y Z W, translation, scale)."""
    game = instance.get_game()
    statics = game.get_class("UGameplayStatics")
    random = game.get_class("UKismetMathLibrary")
    with instance.begin_frame():
        actors = build_scene(game)
    with instance.end_frame():
        pass
    numbers = array("d")
    for step in range(steps):
        with instance.begin_frame():
            statics.send_.SetGamePaused(bPaused=False)
            push = random.async_.RandomFloatInRange(Min=-1.0, Max=1.0)
            actors[step % len(actors)].send_.K2_AddActorWorldOffset(DeltaLocation={"X": push, "Y": push, "Z": push}, bSweep=False, bTeleport=True)
        with instance.end_frame():
            statics.send_.SetGamePaused(bPaused=True)
            transforms = [actor.async_.GetTransform() for actor in actors]
        for future in transforms:
            value = future.get()
            rotation, translation, scale = value.Rotation, value.Translation, value.Scale3D
            numbers.extend((
                rotation.X, rotation.Y, rotation.Z, rotation.W, translation.X, translation.Y, translation.Z, scale.X, scale.Y, scale.Z,
            ))
    return numbers.tobytes()


def run_cpp(instance: spear.Instance, steps: int) -> bytes:
    """The same from C++."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "numbers"
        subprocess.run([str(BUILD / "bin" / "end_to_end_tests"), "--determinism", str(steps), str(file), instance.address], check=True)
        return file.read_bytes()


@contextmanager
def busy(processes: int) -> Iterator[None]:
    """So many processes that do nothing but keep a core busy."""
    running = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(processes)]
    try:
        yield
    finally:
        for process in running:
            process.kill()
            process.wait()


def run(language: str, steps: int, load: int = 0) -> tuple[bytes, int]:
    """One run in an engine of its own, and how many frames the engine ran meanwhile."""
    with busy(load), spear.launch(fixed_dt=1 / 60, fps=0, paused=True, arguments=["--seed", "7"], deadline=300) as instance:
        before = instance.call("engine_service.get_frame_number")
        numbers = {"Python": run_python, "C++": run_cpp}[language](instance, steps)
        return numbers, instance.call("engine_service.get_frame_number") - before


def first_difference(a: bytes, b: bytes, num_steps: int) -> str:
    """Where two runs differ; empty if they do not."""
    if a == b:
        return ""
    if len(a) != len(b):
        return f"{len(a)} bytes against {len(b)}"
    at = next(i for i in range(0, len(a), 8) if a[i:i + 8] != b[i:i + 8]) // 8
    per_step = len(a) // 8 // num_steps
    left, right = (array("d", x[at * 8:at * 8 + 8])[0] for x in (a, b))
    return f"step {at // per_step}, actor {at % per_step // NUMBERS_PER_ACTOR}, number {at % NUMBERS_PER_ACTOR}: {left!r} against {right!r}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--steps", type=int, default=1000)
    parser.add_argument("--runs", type=int, default=5, help="of each kind")
    options = parser.parse_args()
    reference: bytes | None = None
    failed = False
    print(f"{'run':>3}  {'client':6}  {'load':>4}  {'steps':>6}  {'frames':>7}  {'seconds':>7}  SHA-256 of all transforms")
    for number in range(options.runs):
        for language in ("Python", "C++"):
            for load in (0, os.cpu_count() or 1):
                start = time.monotonic()
                numbers, frames = run(language, options.steps, load)
                seconds = time.monotonic() - start
                print(f"{number + 1:3}  {language:6}  {load:4}  {options.steps:6}  {frames:7}  {seconds:7.1f}  {hashlib.sha256(numbers).hexdigest()}", flush=True)
                reference = numbers if reference is None else reference
                if difference := first_difference(reference, numbers, options.steps):
                    print(f"     differs from the first run: {difference}")
                    failed = True
    print("The runs differ." if failed else "All runs are identical to the last bit.")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
