# SPDX-License-Identifier: MIT
"""Full /dev/shm and full disks, in small file systems of a mount namespace of our own: a clear error, or the work goes on by other means."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from engine import BUILD, ENGINE, running_engine  # noqa: E402

import spear  # noqa: E402

MAY_MOUNT = subprocess.run(["unshare", "--mount", "sh", "-c", "mount -t tmpfs tmpfs /mnt"], capture_output=True).returncode == 0
pytestmark = pytest.mark.skipif(not MAY_MOUNT, reason="mount namespaces are not permitted here")


def apart(mounts: str) -> list[str]:
    """A command prefix: runs the rest in a mount namespace with these mounts."""
    return ["unshare", "--mount", "sh", "-c", mounts + ' && exec "$0" "$@"']


def test_full_shared_memory_falls_back_to_rpc_and_the_log_says_why() -> None:
    with running_engine(wrapper=apart("mount -t tmpfs -o size=64k tmpfs /dev/shm")) as engine, spear.connect(engine.address) as instance:
        assert not instance.uses_channel
        with instance.begin_frame():
            target = instance.get_game().new_object("USpearBench")
            assert target.Move(By=spear.FVector(1, 2, 3)) == spear.FVector(1, 2, 3)
        with instance.end_frame():
            pass
        assert "by RPC: no shared memory: No space left on device" in engine.text()


PROGRAM = """
import json, sys
sys.path.insert(0, sys.argv[1])
import spear
try:
    with spear.launch(scene="", fps=0, executable=sys.argv[2]) as instance:
        with instance.begin_frame():
            found = len(instance.get_game().find_actors_by_class("AActor"))
        with instance.end_frame():
            pass
    print(json.dumps({"error": "", "found": found}))
except spear.Error as error:
    print(json.dumps({"error": type(error).__name__, "message": str(error)}))
"""


def launch_in(mounts: str, folder: Path) -> dict[str, object]:
    """What spear.launch gives with its directory for sockets and logs at `folder`."""
    done = subprocess.run(
        [*apart(mounts), "env", f"XDG_RUNTIME_DIR={folder}", sys.executable, "-c", PROGRAM, str(BUILD / "python"), ENGINE],
        capture_output=True, text=True, check=True,
    )
    found: dict[str, object] = json.loads(done.stdout)
    return found


def test_a_full_disk_under_log_and_engine_list_stops_nobody(tmp_path: Path) -> None:
    full = f"mount -t tmpfs -o size=16k tmpfs {tmp_path} && mkdir -m 700 {tmp_path}/spear && (head -c 64k /dev/zero > {tmp_path}/filler 2>/dev/null || true)"
    assert launch_in(full, tmp_path)["error"] == ""


def test_no_room_for_the_socket_is_a_clear_error(tmp_path: Path) -> None:
    no_inodes = f"mount -t tmpfs -o nr_inodes=2 tmpfs {tmp_path} && mkdir -m 700 {tmp_path}/spear"
    outcome = launch_in(no_inodes, tmp_path)
    assert outcome["error"] in ("LaunchFailed", "EngineExited"), outcome
    assert "No space left on device" in str(outcome["message"]), outcome
