# SPDX-License-Identifier: MIT
"""A class in a header outside of engine and server is callable from C++ and Python, with no other edit: examples/door."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import helpers
import pytest

import spear


@pytest.fixture(scope="module")
def address(build_directory: Path) -> Iterator[str]:
    with helpers.running_engine(build_directory, "--plugin-dir", str(build_directory / "example_plugins")) as running:
        yield running


def test_nobody_else_knows_the_class(source_directory: Path) -> None:
    """No line of code of the rooms that make it callable names it (comments do, as an example)."""
    rooms = [source_directory / name for name in ("engine", "server_plugin", "sdk", "codegen", "python/spear", "python/src")]
    for file in (file for room in rooms for file in room.rglob("*") if file.suffix in {".h", ".hpp", ".cpp", ".py", ".pyi", ".j2", ".capnp"}):
        code = re.sub(r"//.*|\"\"\".*?\"\"\"", "", file.read_text(encoding="utf-8"), flags=re.DOTALL if file.suffix in {".py", ".pyi"} else 0)
        assert "ADoor" not in code, file


def test_function_and_variable_from_python(address: str) -> None:
    with spear.connect(address) as instance:
        game = instance.get_game()
        with instance.begin_frame():
            door = game.spawn_actor("ADoor")
            assert door.MaxAngle.get() == 120
            door.Open()  # the default of the header
            assert door.GetAngle() == pytest.approx(90)
            door.Open(Angle=45)
            assert door.Hinge.RelativeRotation.Yaw.get() == pytest.approx(45)
            door.Open(1000)
            assert door.GetAngle() == pytest.approx(120)
            door.MaxAngle = 60
            door.open(ANGLE=80)  # names compare without case
            assert door.GetAngle() == pytest.approx(60)
            with pytest.raises(spear.UnknownFunction, match="Open"):
                door.Opne(45)
            with pytest.raises(spear.WrongType):
                door.Open(Angle="wide")
            game.destroy_actor(door)
        with instance.end_frame():
            pass


def test_both_programs_print_what_the_readme_says(address: str, build_directory: Path, source_directory: Path) -> None:
    folder = source_directory / "examples" / "door"
    expected = ["at most 120.0 degrees", "Open(): 90.0", "Open(45): 45.0", "Open(80) with MaxAngle 60: 60.0"]
    readme = (folder / "README.md").read_text(encoding="utf-8")
    assert "\n".join("    " + line for line in expected) in readme
    from_cpp = helpers.run([build_directory / "bin" / "open_door", address])
    environment = {**os.environ, "PYTHONPATH": str(build_directory / "python")}
    from_python = helpers.run([sys.executable, folder / "open_door.py", address], env=environment)
    assert from_cpp.stdout.splitlines() == expected
    assert from_python.stdout == from_cpp.stdout


def test_the_header_of_the_main_readme_is_this_one(source_directory: Path) -> None:
    header = (source_directory / "examples/door/Source/Door/Public/Door.h").read_text(encoding="utf-8")
    for line in ("void Open(float Angle = 90.0f);", "float MaxAngle = 120.0f;"):
        assert line in header and line in (source_directory / "README.md").read_text(encoding="utf-8")
