# SPDX-License-Identifier: MIT
"""An engine under test: started with the frame log, watched from outside, checked for leftovers."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BUILD = Path(os.environ.get("SPEAR_BUILD_DIR", ROOT / "build" / "release"))
os.environ.setdefault("SPEAR_BUILD_DIR", str(BUILD))
if str(BUILD / "python") not in sys.path:
    sys.path.insert(0, str(BUILD / "python"))

from spear.cli.frame_log import FrameLog  # noqa: E402

PLUGINS = ["--plugin-dir", str(BUILD / "bench_plugins"), "--plugin-dir", str(BUILD / "test_plugins")]
"""Arguments with which an engine finds SpearBench and RoundTrip."""

ENGINE = os.environ.get("SPEAR_TEST_ENGINE", str(BUILD / "bin" / "spear-engine"))
"""The engine: another one, for instance with sanitizers, by the environment variable SPEAR_TEST_ENGINE."""

PATIENCE = 60.0
"""Seconds after which something that must happen is taken not to happen at all: the tests' only use of the clock."""


class Engine:
    """An engine process of our own, not launched by a client: it dies when told to. A context manager."""

    def __init__(self, fps: float = 100.0, arguments: list[str] | None = None, environment: dict[str, str] | None = None, wrapper: list[str] | None = None) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="spear-robustness-"))
        self.fps = fps
        self.runtime = self.folder / "run"
        self.runtime.mkdir(mode=0o700)
        self.address = f"unix:{self.folder}/engine.sock"
        self.log = FrameLog(self.folder / "frames")
        self.output = self.folder / "engine.log"
        self._files = self.output.open("w")
        self.process = subprocess.Popen(
            [*(wrapper or []), ENGINE, "--fps", str(fps), "--fixed-dt", "0.01", *PLUGINS, *(arguments or []),
             FrameLog.argument(self.folder / "frames"), f"-SpearAddress={self.address}"],
            stdin=subprocess.DEVNULL, stdout=self._files, stderr=self._files, env={**os.environ, "XDG_RUNTIME_DIR": str(self.runtime), **(environment or {})},
        )
        try:
            wait_until(lambda: self.log.count() > 3 or self.process.poll() is not None, "the engine runs frames", self)
            assert self.process.poll() is None, self.output.read_text()
        except BaseException:
            self.stop()
            raise

    def __enter__(self) -> Engine:
        return self

    def __exit__(self, *error: object) -> None:
        self.stop()

    @property
    def pid(self) -> int:
        return self.process.pid

    def text(self) -> str:
        """What it has written so far."""
        return self.output.read_text(errors="replace")

    def regions(self) -> list[str]:
        """Its shared memory that still has a name."""
        return [name for name in os.listdir("/dev/shm") if name.startswith(f"spear-{self.pid}-")]

    def resources(self) -> tuple[int, int, int]:
        """Its open files, threads, and mapped channels."""
        folder = Path(f"/proc/{self.pid}")
        mapped = sum("/dev/shm/spear-" in line for line in (folder / "maps").read_text().splitlines())
        return len(os.listdir(folder / "fd")), len(os.listdir(folder / "task")), mapped

    def memory_mb(self) -> float:
        """Its resident memory."""
        lines = Path(f"/proc/{self.pid}/status").read_text().splitlines()
        return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1024

    def stop(self) -> None:
        """Ends it in good order, or not."""
        if self.process.poll() is None:
            self.process.terminate()
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.process.wait(PATIENCE)
            self.process.kill()
            self.process.wait()
        self.log.close()
        self._files.close()

    def forget(self) -> None:
        """Removes its folder."""
        for file in sorted(self.folder.rglob("*"), reverse=True):
            file.rmdir() if file.is_dir() and not file.is_symlink() else file.unlink()
        self.folder.rmdir()


def wait_until(done: object, what: str, engine: Engine | None = None) -> None:
    """Waits for something that must happen; AssertionError with the engine's output if it does not."""
    ends = time.monotonic() + PATIENCE
    while not done():  # type: ignore[operator]
        assert time.monotonic() < ends, f"not within {PATIENCE} s: {what}\n{engine.text()[-3000:] if engine else ''}"
        time.sleep(0.001)


@contextlib.contextmanager
def running_engine(**options: object) -> Iterator[Engine]:
    """An engine, its folder removed afterwards."""
    engine = Engine(**options)  # type: ignore[arg-type]
    try:
        yield engine
    finally:
        engine.stop()
        engine.forget()
