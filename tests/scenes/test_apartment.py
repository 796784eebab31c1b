# SPDX-License-Identifier: MIT
"""The script that makes the apartment: it is deterministic, its files are sound, and the scene has what the documents promise."""

from __future__ import annotations

import hashlib
import json
import struct
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "tools" / "make_apartment"
ROOMS = {"living_room", "kitchen", "hall", "bedroom", "bathroom", "study"}
COMPONENT_SIZES = {5121: 1, 5123: 2, 5125: 4, 5126: 4}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def make(folder: Path) -> Path:
    subprocess.run([sys.executable, str(SCRIPT), "--output", str(folder), "--quiet"], check=True, timeout=240)
    return folder / "Scenes" / "apartment"


def digests(folder: Path) -> dict[str, str]:
    return {
        str(p.relative_to(folder)): hashlib.sha256(p.read_bytes()).hexdigest()
        for p in sorted(folder.rglob("*"))
        if p.is_file()
    }


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make(tmp_path_factory.mktemp("first"))


@pytest.fixture(scope="module")
def gltf(scene: Path) -> dict[str, Any]:
    document: dict[str, Any] = json.loads((scene / "apartment.gltf").read_text())
    return document


@pytest.fixture(scope="module")
def sidecar(scene: Path) -> dict[str, Any]:
    document: dict[str, Any] = json.loads((scene / "apartment.scene.json").read_text())
    return document


def test_two_runs_are_byte_identical(scene: Path, tmp_path: Path) -> None:
    again = make(tmp_path)
    assert digests(scene) == digests(again)


def test_no_temporary_file_is_left(scene: Path) -> None:
    assert not list(scene.rglob("*.tmp"))


def test_every_referenced_file_exists_and_no_other(scene: Path, gltf: dict[str, Any]) -> None:
    uris = (
        {image["uri"] for image in gltf["images"]}
        | {buffer["uri"] for buffer in gltf["buffers"]}
        | {"apartment.gltf", "apartment.scene.json"}
    )
    assert uris == set(digests(scene))
    assert gltf["buffers"][0]["byteLength"] == (scene / "apartment.bin").stat().st_size
    for image in gltf["images"]:
        assert (scene / image["uri"]).read_bytes()[:2] == b"\xff\xd8", image["uri"]


def test_accessors_stay_inside_the_buffer(gltf: dict[str, Any]) -> None:
    size = gltf["buffers"][0]["byteLength"]
    for number, accessor in enumerate(gltf["accessors"]):
        view = gltf["bufferViews"][accessor["bufferView"]]
        length = COMPONENT_SIZES[accessor["componentType"]] * COMPONENTS[accessor["type"]] * accessor["count"]
        assert length <= view["byteLength"], number
        assert view["byteOffset"] + view["byteLength"] <= size, number
        assert view["byteOffset"] % 4 == 0, number


def primitives(gltf: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    for mesh in gltf["meshes"]:
        for primitive in mesh["primitives"]:
            yield mesh["name"], primitive


def test_indices_name_existing_vertices_and_normals_are_unit(scene: Path, gltf: dict[str, Any]) -> None:
    import numpy as np

    data = (scene / "apartment.bin").read_bytes()

    def read(number: int) -> Any:
        accessor = gltf["accessors"][number]
        kind = {5123: "<u2", 5125: "<u4", 5126: "<f4"}[accessor["componentType"]]
        count = accessor["count"] * COMPONENTS[accessor["type"]]
        return np.frombuffer(data, kind, count, gltf["bufferViews"][accessor["bufferView"]]["byteOffset"]).reshape(
            accessor["count"], -1
        )

    for name, primitive in primitives(gltf):
        positions, normals = read(primitive["attributes"]["POSITION"]), read(primitive["attributes"]["NORMAL"])
        assert np.isfinite(positions).all(), name
        assert np.isfinite(read(primitive["attributes"]["TEXCOORD_0"])).all(), name
        assert np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-3), name
        indices = read(primitive["indices"])[:, 0]
        assert len(indices) % 3 == 0 and len(indices) > 0, name
        assert indices.max() < len(positions), name
        # Faces and their normals agree, so that nothing is inside out.
        corners = positions[indices.reshape(-1, 3)].astype(float)
        front = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        agree = (front * normals[indices.reshape(-1, 3)].sum(axis=1)).sum(axis=1)
        assert (agree < -1e-8).mean() < 0.02, name


def test_figures(gltf: dict[str, Any], sidecar: dict[str, Any]) -> None:
    counts = [sum(gltf["accessors"][p["indices"]]["count"] // 3 for p in mesh["primitives"]) for mesh in gltf["meshes"]]
    objects = [node for node in gltf["nodes"] if "mesh" in node]
    assert len(objects) >= 300
    assert sum(counts[node["mesh"]] for node in objects) >= 500_000
    lights = gltf["extensions"]["KHR_lights_punctual"]["lights"]
    assert len(lights) >= 16
    assert sum(light["type"] == "directional" for light in lights) == 1
    assert len(gltf["materials"]) >= 80
    assert len(gltf["images"]) >= 60
    rooms = {tag for node in objects for tag in sidecar["nodes"][node["name"]]["tags"]} & ROOMS
    assert rooms == ROOMS
    for room in ROOMS:
        assert sum(room in sidecar["nodes"][node["name"]]["tags"] for node in objects) >= 20, room


def test_names_are_unique_without_case_and_known_to_both_files(gltf: dict[str, Any], sidecar: dict[str, Any]) -> None:
    names = [node["name"] for node in gltf["nodes"]]
    assert len({name.lower() for name in names}) == len(names)
    assert set(sidecar["nodes"]) == set(names)
    for name, entry in sidecar["nodes"].items():
        assert entry["tags"], name
        assert all(tag == tag.lower() and " " not in tag for tag in entry["tags"]), name


def test_known_objects_stand_where_the_documents_say(gltf: dict[str, Any]) -> None:
    table = next(node for node in gltf["nodes"] if node["name"] == "Table_1")
    assert table["translation"] == [-0.1, 0.0, 2.8]


def test_unknown_options_are_refused(tmp_path: Path) -> None:
    result = subprocess.run(
        [sys.executable, str(SCRIPT), "--output", str(tmp_path), "--colour", "red"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 2
    assert "--colour" in result.stderr


def test_binary_is_little_endian_floats(scene: Path, gltf: dict[str, Any]) -> None:
    number = next(p for _, p in primitives(gltf))["attributes"]["POSITION"]
    accessor = gltf["accessors"][number]
    offset = gltf["bufferViews"][accessor["bufferView"]]["byteOffset"]
    values = struct.unpack_from(f"<{3 * accessor['count']}f", (scene / "apartment.bin").read_bytes(), offset)
    assert min(values[0::3]) == pytest.approx(accessor["min"][0])
    assert max(values[1::3]) == pytest.approx(accessor["max"][1])
