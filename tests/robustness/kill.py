# SPDX-License-Identifier: MIT
"""Kills clients in every state of a transaction and measures how long the engine takes to run at its full rate again.

    python tests/robustness/kill.py --kills 200             kill -9 of the client
    python tests/robustness/kill.py --what stop             SIGSTOP past the lease, then SIGCONT
    python tests/robustness/kill.py --what engine           kill -9 of the engine: what the client is told
    python tests/robustness/kill.py --what hang             SIGSTOP of the engine: the client is told at its deadline (and two seconds in which it asks why)
    python tests/robustness/kill.py --kills 40 --state begin_held --state sending --seed 7

Prints a table and fails (exit code 1) over the bar: full rate within 250 ms of the kill (of the lease's end for --what stop). Full rate is measured by the
engine itself: the plugin SpearBench notes the monotonic clock at the beginning of each frame, and the recovery ends where the first of five frames
begins that follow one another at the engine's pace (each at most one and a half times the frame time). Nothing may be left behind.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import platform
import random
import signal
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from engine import Engine, running_engine, wait_until  # noqa: E402
from victims import KINDS, STATES, State, Victim, fits  # noqa: E402

import spear  # noqa: E402

BAR_MS = 250.0
RUN = 5
"""Frames at full rate that make a recovery."""


@contextlib.contextmanager
def holding(address: str) -> Iterator[None]:
    """Another client holds the engine in an open block; it works undisturbed before and after."""
    with spear.connect(address) as instance:
        game = instance.get_game()
        with instance.begin_frame():
            before = len(game.find_actors_by_class("AActor"))
            yield
            assert len(game.find_actors_by_class("AActor")) == before
        with instance.end_frame():
            pass
        instance.flush()


@contextlib.contextmanager
def holding_to_the_end(address: str) -> Iterator[None]:
    """The same, when the engine does not live to see it let go."""
    with contextlib.suppress(spear.Error), holding(address):
        yield


class Watch:
    """Looks at the engine's frame log."""

    def __init__(self, engine: Engine) -> None:
        self.engine = engine
        self.log = engine.log
        self.pace_ns = 1e9 / engine.fps

    def is_held(self) -> bool:
        """Whether no frame ends for three frame times."""
        count = self.log.count()
        time.sleep(3 * self.pace_ns / 1e9)
        return self.log.count() == count

    def recovery_ms(self, since_ns: int, first: int) -> float:
        """Milliseconds from then to the first of RUN frames at full rate. Looks at frames noted from number `first` on."""
        found: list[float] = []

        def look() -> bool:
            began = [when for when in self.log.began(first) if when >= since_ns]
            for at in range(len(began) - RUN):
                if all(began[at + i + 1] - began[at + i] <= 1.5 * self.pace_ns for i in range(RUN)):
                    found.append((began[at] - since_ns) / 1e6)
                    return True
            return False

        wait_until(look, "the engine runs at full rate", self.engine)
        return found[0]


class Baseline:
    """What an engine has open while only we look at it."""

    def __init__(self, engine: Engine) -> None:
        self.engine = engine
        with spear.connect(engine.address):  # first use of whatever is made once
            pass
        self._usual = (0, 0, 0)
        wait_until(self._settled, "the engine has let go of its first client", engine)

    def _settled(self) -> bool:
        before = self.engine.resources()
        time.sleep(0.05)
        self._usual = self.engine.resources()
        return before == self._usual and self._usual[2] == 0

    def expect(self, what: str) -> None:
        """Waits until everything of a client is gone: files, threads, mappings, names in /dev/shm."""
        wait_until(lambda: self.engine.resources() == self._usual and not self.engine.regions(), f"nothing is left of {what}", self.engine)


def _recovered(watch: Watch, since_ns: int, first: int, whole: bool) -> float:
    """Milliseconds until full rate; 0 without `whole`, when it is enough that frames go on (a busy machine has no full rate)."""
    if whole:
        return watch.recovery_ms(since_ns, first)
    wait_until(lambda: sum(when >= since_ns for when in watch.log.began(first)) > RUN, "frames go on", watch.engine)
    return 0.0


def kill_client(engine: Engine, state: State, kind: str, baseline: Baseline, rng: random.Random, whole: bool = True) -> tuple[float, bool]:
    """One kill. Returns the milliseconds until full rate, and whether the engine stood still at the kill. `whole`: see _recovered."""
    watch = Watch(engine)
    with contextlib.ExitStack() as arranged:
        victim = Victim(state, kind, engine)
        try:
            with arranged:
                victim.arrive(arranged, holding)
                if state.holds:
                    wait_until(watch.is_held, f"{state.name} holds the engine", engine)
                elif state.flows:
                    time.sleep(rng.random() * 0.04)
                first = max(0, engine.log.count() - 1)
                held = state.needs_other or (state.holds and watch.is_held())
                since = victim.kill()
            if state.needs_other:  # from when the other one let go
                since = time.monotonic_ns()
        finally:
            victim.close()
    recovered = _recovered(watch, since, first, whole)
    baseline.expect(f"the client killed in {state.name} ({kind})")
    return recovered, held


def stop_client(engine: Engine, state: State, kind: str, baseline: Baseline, lease_ms: int, whole: bool = True) -> tuple[float, str]:
    """SIGSTOP past the lease. Returns the milliseconds from the lease's end until full rate, and the error that the client gets after SIGCONT."""
    watch = Watch(engine)
    victim = Victim(state, kind, engine, lease_ms=lease_ms)
    try:
        with contextlib.ExitStack() as arranged:
            victim.arrive(arranged, holding)
            first = max(0, engine.log.count() - 1)
            os.kill(victim.pid, signal.SIGSTOP)
            since = time.monotonic_ns()
            if state.needs_other:
                time.sleep(2 * lease_ms / 1000)
        if state.needs_other:
            since = time.monotonic_ns() - lease_ms * 1_000_000
        recovered = _recovered(watch, since, first, whole) - lease_ms
        baseline.expect(f"the client stopped in {state.name} ({kind})")
        os.kill(victim.pid, signal.SIGCONT)
        victim.say("go")
        outcome = victim.outcome()
    finally:
        victim.close()
    wanted = ("", "Disconnected") if state.ends_well else ("Disconnected", "TransactionAborted", "EngineNotRunning")
    assert outcome["error"] in wanted, f"after SIGCONT in {state.name} ({kind}): {outcome}"
    return max(0.0, recovered), outcome["error"]


def kill_engine(state: State, kind: str, launched: bool, deadline_ms: int) -> tuple[float, str]:
    """kill -9 of the engine. Returns the milliseconds until the client has its error, and the error's name."""
    with contextlib.ExitStack() as stack:
        if launched:
            engine = None
            runtime = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="spear-robustness-")))
            victim = Victim(state, kind, None, launch=True, runtime=runtime, deadline_ms=deadline_ms)
        else:
            engine = stack.enter_context(running_engine())
            runtime = engine.runtime
            victim = Victim(state, kind, engine, deadline_ms=deadline_ms)
        stack.callback(victim.close)
        victim.arrive(stack, holding_to_the_end)
        pid = victim.engine_pid if launched else engine.pid  # type: ignore[union-attr]
        os.kill(pid, signal.SIGKILL)
        since = time.monotonic_ns()
        victim.say("go")
        outcome = victim.outcome(deadline_ms / 1000 + 60)
        took = (time.monotonic_ns() - since) / 1e6
        victim.process.wait()
        if state.ends_well:
            assert outcome["error"] in ("", "Disconnected"), outcome
        elif launched:
            assert outcome["error"] == "EngineExited" and "signal 9" in outcome["message"] and "log" in outcome["message"], outcome
        else:
            assert outcome["error"] in ("Disconnected", "EngineNotRunning"), outcome
        assert not [name for name in os.listdir("/dev/shm") if name.startswith(f"spear-{pid}-")] or state.name == "connect_offered"
        if launched:
            left = [name for name in os.listdir(runtime / "spear") if not name.endswith(".log")]
            assert not left, f"left behind by the launched engine: {left}"
        return took, outcome["error"]


def hang_engine(state: State, kind: str, deadline_ms: int) -> tuple[float, str]:
    """SIGSTOP of the engine. Returns the milliseconds until the client has its error, and the error's name."""
    with running_engine() as engine, contextlib.ExitStack() as stack:
        victim = Victim(state, kind, engine, deadline_ms=deadline_ms)
        stack.callback(victim.close)
        with contextlib.ExitStack() as arranged:
            victim.arrive(arranged, holding)
            os.kill(engine.pid, signal.SIGSTOP)
            stack.callback(os.kill, engine.pid, signal.SIGCONT)
            since = time.monotonic_ns()
            victim.say("go")
            outcome = victim.outcome(deadline_ms / 1000 + 60)
            took = (time.monotonic_ns() - since) / 1e6
            os.kill(engine.pid, signal.SIGCONT)
        wanted = ("", "Disconnected") if state.ends_well else ("DeadlineExceeded", "EngineNotRunning", "Disconnected")
        assert outcome["error"] in wanted, outcome
        return took, outcome["error"]


def quantile(values: list[float], part: float) -> float:
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(len(ordered) * part))]


def machine() -> dict[str, object]:
    return {
        "system": platform.platform(), "cores": os.cpu_count(), "cores_allowed": len(os.sched_getaffinity(0)), "load": os.getloadavg(),
        "python": platform.python_version(), "spear": spear.__version__,
    }


def plan(kills: int, states: list[str], kinds: list[str], rng: random.Random) -> list[tuple[State, str]]:
    """Every state with every kind of client that can be in it, in turn and shuffled, until there are enough."""
    usable = [(STATES[name], kind) for name in states for kind in kinds if fits(STATES[name], kind)]
    trials: list[tuple[State, str]] = []
    while len(trials) < kills:
        # Each state as often as the others, its kinds in turn.
        by_state: dict[str, list[str]] = defaultdict(list)
        for state, kind in usable:
            by_state[state.name].append(kind)
        for name, of_state in by_state.items():
            trials.append((STATES[name], rng.choice(of_state)))
    rng.shuffle(trials)
    return trials[:max(kills, 0)]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=200, help="how many in all; each state as often as the others [200]")
    parser.add_argument("--what", choices=("kill", "stop", "engine", "hang"), default="kill", help="kill or stop the client, kill or stop the engine [kill]")
    parser.add_argument("--state", action="append", choices=sorted(STATES), help="only this state; may be given several times")
    parser.add_argument("--client", action="append", choices=KINDS, help="only this kind of client; may be given several times")
    parser.add_argument("--fps", type=float, default=100.0, help="frames per second of the engine [100]")
    parser.add_argument("--lease", type=int, default=200, help="milliseconds, for --what stop [200]")
    parser.add_argument("--deadline", type=int, default=5000, help="milliseconds, for --what engine and hang [5000]")
    parser.add_argument("--seed", type=int, default=1, help="of the order and of the moments [1]")
    parser.add_argument("--json", type=Path, help="write all figures there")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    trials = plan(options.kills, options.state or list(STATES), options.client or list(KINDS), rng)
    times: dict[str, list[float]] = defaultdict(list)
    notes: dict[str, set[str]] = defaultdict(set)
    held: dict[str, int] = defaultdict(int)
    failed = []
    memory = ""
    with contextlib.ExitStack() as stack:
        if options.what in ("kill", "stop"):
            lease = [f"-SpearLease={options.lease}"] if options.what == "stop" else []
            engine = stack.enter_context(running_engine(fps=options.fps, arguments=lease))
            baseline = Baseline(engine)
            before = engine.memory_mb()
        for number, (state, kind) in enumerate(trials):
            if sys.stderr.isatty():
                print(f"\r{number + 1}/{len(trials)} {state.name:<20} {kind:<10}", end="", file=sys.stderr, flush=True)
            try:
                if options.what == "kill":
                    took, stood = kill_client(engine, state, kind, baseline, rng)
                    held[state.name] += stood
                elif options.what == "stop":
                    took, error = stop_client(engine, state, kind, baseline, options.lease)
                    notes[state.name].add(error or "none")
                elif options.what == "hang":
                    took, error = hang_engine(state, kind, options.deadline)
                    notes[state.name].add(error or "none")
                else:
                    launched = not state.proxy and number % 2 == 0
                    took, error = kill_engine(state, kind, launched, options.deadline)
                    notes[state.name].add(error or "none")
            except AssertionError as error:
                failed.append(f"{state.name} ({kind}): {error}")
                print(f"\nFAILED {failed[-1]}", file=sys.stderr)
                if options.what in ("kill", "stop") and engine.process.poll() is not None:
                    break
                continue
            times[state.name].append(took)
        if options.what in ("kill", "stop") and engine.process.poll() is None:
            memory = f"; the engine's memory: {before:.1f} MB before, {engine.memory_mb():.1f} MB after"
    if sys.stderr.isatty():
        print("\r" + " " * 60 + "\r", end="", file=sys.stderr)
    # A client that connects has 10 s; one that finds no answer at its deadline asks the server thread why, for two more.
    bar = {"engine": options.deadline, "hang": max(options.deadline, 10_000) + 2500}.get(options.what, BAR_MS)
    print(f"{'state':<52} {'n':>4} {'held':>5} {'median ms':>10} {'p99 ms':>8} {'max ms':>8}  {'errors' if options.what != 'kill' else ''}")
    for name, values in sorted(times.items(), key=lambda row: list(STATES).index(row[0])):
        print(
            f"{STATES[name].what:<52} {len(values):>4} {held[name] if STATES[name].holds or STATES[name].needs_other else '-':>5} {quantile(values, 0.5):>10.1f} "
            f"{quantile(values, 0.99):>8.1f} {max(values):>8.1f}  {', '.join(sorted(notes[name]))}"
        )
    everything = [value for values in times.values() for value in values]
    if everything:
        print(f"{'all':<52} {len(everything):>4} {'':>5} {quantile(everything, 0.5):>10.1f} {quantile(everything, 0.99):>8.1f} {max(everything):>8.1f}")
    over = [value for value in everything if value > bar]
    facts = machine()
    print(f"bar {bar:.0f} ms: {len(over)} over; {len(failed)} failed{memory}; {facts['cores']} cores, load {os.getloadavg()[0]:.1f}, {facts['system']}")
    if options.json:
        options.json.write_text(json.dumps({"what": options.what, "machine": facts, "ms": times, "failed": failed}, indent=2))
    return 1 if over or failed or not everything else 0


if __name__ == "__main__":
    sys.exit(main())
