# SPDX-License-Identifier: MIT
"""What users install: the C++ SDK by `cmake --install` and find_package(spear), the Python package by `pip install ./python`."""

from __future__ import annotations

import re
import subprocess
import sys
import venv
import zipfile
from collections.abc import Iterator
from pathlib import Path

import helpers
import pytest


@pytest.fixture(scope="module")
def address(build_directory: Path) -> Iterator[str]:
    with helpers.running_engine(build_directory) as running:
        yield running


def test_outside_project_finds_the_sdk(address: str, build_directory: Path, source_directory: Path, tmp_path: Path) -> None:
    """tests/consumer, built against an installed SDK alone, talks to a running engine."""
    prefix, build = tmp_path / "prefix", tmp_path / "build"
    helpers.run(["cmake", "--install", build_directory / "sdk", "--prefix", prefix])
    installed = "\n".join(file.read_text(encoding="utf-8") for file in prefix.rglob("*.cmake"))
    for place in (source_directory, build_directory):
        assert str(place) not in installed, "the installed CMake files name the source or build tree"
    helpers.run(["cmake", "-G", "Ninja", "-S", source_directory / "tests" / "consumer", "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release",
                 "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror"], env=helpers.bare_environment())
    helpers.run(["cmake", "--build", build], timeout=600, env=helpers.bare_environment())
    result = helpers.run([build / "consumer", address], env=helpers.bare_environment())
    assert re.fullmatch(r"\S.* with scene apartment\nan actor at X = 1\n", result.stdout), result.stdout
    assert "EngineNotRunning" in helpers.run([build / "consumer"], env=helpers.bare_environment()).stdout


@pytest.fixture(scope="module")
def installed_python(source_directory: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The interpreter of an empty virtual environment after `pip install ./python`."""
    folder = tmp_path_factory.mktemp("wheel")
    venv.create(folder / "environment", with_pip=True)
    python = folder / "environment" / "bin" / "python"
    environment = helpers.bare_environment(PIP_DISABLE_PIP_VERSION_CHECK="1")
    helpers.run([python, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", folder / "dist", source_directory / "python"], timeout=1200, cwd=folder, env=environment)
    (wheel,) = (folder / "dist").glob("spear_sdk-*.whl")
    names = zipfile.ZipFile(wheel).namelist()
    assert "spear/lib/libspear_wire.so.1" in names and "spear/py.typed" in names and "spear/_native.pyi" in names
    assert not [name for name in names if not name.startswith(("spear/", "spear_sdk-"))], names
    for part in ("unreal/__init__.pyi", "unreal/Engine/__init__.pyi", "unreal/Engine/facts.json", "codegen/names.py", "codegen/schema.schema.json", "codegen/templates/"):
        assert any(name.startswith(f"spear/{part}") for name in names), f"the wheel has no spear/{part}"
    assert not [name for name in names if "__pycache__" in name], names
    helpers.run([python, "-m", "pip", "install", "--quiet", wheel], timeout=600, cwd=folder, env=environment)
    return python


PROGRAM = """
import sys, spear
assert "site-packages" in spear.__file__, spear.__file__
with spear.connect(sys.argv[1]) as instance:
    game = instance.get_game()
    with instance.begin_frame():
        actor = game.spawn_actor("ACoordinateAxes", location=spear.FVector(1, 2, 3))
        print(actor.K2_GetActorLocation())
        game.destroy_actor(actor)
    with instance.end_frame():
        pass
"""


def test_wheel_works_in_an_empty_environment(address: str, installed_python: Path, tmp_path: Path) -> None:
    result = helpers.run([installed_python, "-c", PROGRAM, address], cwd=tmp_path, env=helpers.bare_environment())
    assert result.stdout == "FVector(X=1.0, Y=2.0, Z=3.0)\n"
    command = installed_python.parent / "spear"
    assert "Usage: spear" in helpers.run([command, "--help"], cwd=tmp_path, env=helpers.bare_environment()).stdout
    assert '"format": "spear-schema"' in helpers.run([command, "schema", "live", address, "-m", "SpearServer"], cwd=tmp_path, env=helpers.bare_environment()).stdout


def test_import_takes_less_than_200_ms(installed_python: Path, tmp_path: Path) -> None:
    """The best of five, so that a busy machine does not count; NumPy comes in only when arrays are used."""
    environment = helpers.bare_environment()
    times = []
    for _ in range(5):
        report = helpers.run([installed_python, "-X", "importtime", "-c", "import spear"], cwd=tmp_path, env=environment).stderr
        times.append(int(report.splitlines()[-1].split("|")[1]) / 1000)
        assert report.splitlines()[-1].split("|")[2].strip() == "spear" and " numpy" not in report
    print(f"import spear: {min(times):.0f} ms (of {', '.join(f'{time:.0f}' for time in times)}), Python {sys.version.split()[0]}")
    assert min(times) < 200


TYPED_PROGRAM = """
from typing import assert_type

import spear
from spear import FVector, Future
from spear.unreal.Door import ADoor
from spear.unreal.Engine import AActor


def open_all(game: spear.Game, door: ADoor) -> None:
    door.Open(Angle=45)
    assert_type(door.GetAngle(), float)
    assert_type(door.MaxAngle.get(), float)
    assert_type(door.async_.GetAngle(), Future[float])
    assert_type(door.K2_GetActorLocation(), FVector)
    assert_type(game.spawn_actor(ADoor), ADoor)
    actor: AActor = door
    actor.bHidden = True
"""


def test_stubs_of_a_project_in_an_installed_environment(installed_python: Path, build_directory: Path, tmp_path: Path) -> None:
    """`spear schema stubs` puts a project's types into the environment: mypy and pyright find them with no settings, and the program runs on them."""
    schemas = [build_directory / "codegen" / name / f"{name}.schema.json" for name in ("CoreUObject", "Engine", "SpearServer", "Door")]
    spear, bare = installed_python.parent / "spear", helpers.bare_environment()
    program = tmp_path / "program.py"
    program.write_text(TYPED_PROGRAM, encoding="utf-8")
    (tmp_path / "pyrightconfig.json").write_text("{}", encoding="utf-8")  # else one of a parent folder counts
    checkers = (
        [sys.executable, "-m", "mypy", "--strict", "--python-executable", installed_python, "--cache-dir", tmp_path / "cache", program],
        [sys.executable, "-m", "pyright", "--pythonpath", installed_python, "-p", tmp_path],
    )
    for checker in checkers:  # the wheel knows the embedded engine, and no door
        result = subprocess.run([str(part) for part in checker], capture_output=True, text=True, cwd=tmp_path, env=bare, timeout=300, check=False)
        assert result.returncode == 1 and "Door" in result.stdout and "AActor" not in result.stdout, result.stdout

    assert "a good schema" in helpers.run([spear, "schema", "check", *schemas], cwd=tmp_path, env=bare).stdout
    helpers.run([spear, "schema", "stubs", *schemas], cwd=tmp_path, env=bare)
    for checker in checkers:
        helpers.run(checker, timeout=300, cwd=tmp_path, env=bare)
    program.write_text(TYPED_PROGRAM.replace("GetAngle(), float", "GetAngle(), str"), encoding="utf-8")
    for checker in checkers:
        result = subprocess.run([str(part) for part in checker], capture_output=True, text=True, cwd=tmp_path, env=bare, timeout=300, check=False)
        assert result.returncode == 1 and "str" in result.stdout, result.stdout

    facts = "from spear.unreal.Door import ADoor; print(ADoor.unreal_name); from spear.unreal.Engine import ECollisionChannel; print(int(ECollisionChannel.ECC_Pawn))"
    assert helpers.run([installed_python, "-c", facts], cwd=tmp_path, env=bare).stdout.split() == ["ADoor", "2"]
    helpers.run([spear, "schema", "docs", *schemas, "-o", tmp_path / "site", "--title", "Doors"], cwd=tmp_path, env=bare)
    assert "Doors" in (tmp_path / "site" / "index.html").read_text(encoding="utf-8")
    helpers.run([spear, "schema", "cpp", *schemas, "-o", tmp_path / "include"], cwd=tmp_path, env=bare)
    assert "ADoor" in (tmp_path / "include" / "spear" / "unreal" / "Door" / "ADoor.hpp").read_text(encoding="utf-8")
