# SPDX-License-Identifier: MIT
"""Writes a Scene as glTF 2.0: <name>.gltf, <name>.bin and textures/*.jpg, and the sidecar <name>.scene.json."""

from __future__ import annotations

import io
import json
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from geometry import Mesh
from materials import MAPS, MATERIALS, Material
from scene import Scene
from textures import Array

FLOAT, UNSIGNED_SHORT, UNSIGNED_INT = 5126, 5123, 5125
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963


def linear(colour: tuple[float, float, float]) -> list[float]:
    """sRGB to linear, rounded so that the file does not depend on the last bit of a power function."""
    return [round(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4, 6) for c in colour]


def normal_map(height: Array, metres: float, size: int) -> Array:
    """Tangent-space normals (OpenGL convention) of a tileable height field in millimetres over a tile of `metres`."""
    scale = 0.001 * size / metres / 2
    dx = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * scale
    dy = (np.roll(height, -1, 0) - np.roll(height, 1, 0)) * scale
    n = np.stack([-dx, dy, np.ones_like(dx)], -1)
    unit: Array = n / np.linalg.norm(n, axis=-1, keepdims=True)
    return unit * 0.5 + 0.5


def jpeg(image: Array, quality: int) -> bytes:
    stream = io.BytesIO()
    pixels = np.clip(np.round(image * 255), 0, 255).astype(np.uint8)
    Image.fromarray(pixels).save(stream, "JPEG", quality=quality, subsampling=0 if quality > 90 else 2)
    return stream.getvalue()


def make_maps(name: str) -> dict[str, bytes]:
    """The encoded images of one entry of MAPS: color, and normal and orm where it has them."""
    function, metres = MAPS[name]
    maps = function()
    files = {"color": jpeg(maps.colour, 88)}
    size = maps.colour.shape[0]
    if maps.height is not None:
        files["normal"] = jpeg(normal_map(maps.height, metres, size), 92)
    if maps.roughness is not None:
        occlusion = maps.occlusion if maps.occlusion is not None else np.ones((size, size))
        files["orm"] = jpeg(np.stack([occlusion, maps.roughness, np.full((size, size), maps.metallic)], -1), 88)
    return files


class GltfWriter:
    """Builds the JSON document and the binary buffer of one scene."""

    def __init__(self, scene: Scene, images: dict[str, dict[str, bytes]]) -> None:
        self.scene = scene
        self.images = images
        self.binary = bytearray()
        self.document: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": "SPEAR tools/make_apartment"},
            "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_emissive_strength"],
            "scene": 0,
            "scenes": [{"name": scene.name, "nodes": []}],
            "nodes": [],
            "meshes": [],
            "materials": [],
            "textures": [],
            "images": [],
            "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}],
            "accessors": [],
            "bufferViews": [],
        }
        self._materials: dict[str, int] = {}
        self._textures: dict[str, int] = {}

    def _view(self, data: bytes, target: int) -> int:
        self.binary.extend(b"\0" * (-len(self.binary) % 4))
        views = self.document["bufferViews"]
        views.append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data), "target": target})
        self.binary.extend(data)
        return len(views) - 1

    def _accessor(
        self, array: np.ndarray[Any, Any], component: int, kind: str, target: int, bounds: bool = False
    ) -> int:
        entry: dict[str, Any] = {
            "bufferView": self._view(array.tobytes(), target),
            "componentType": component,
            "count": len(array),
            "type": kind,
        }
        if bounds:
            entry["min"] = [float(v) for v in array.min(axis=0)]
            entry["max"] = [float(v) for v in array.max(axis=0)]
        self.document["accessors"].append(entry)
        return len(self.document["accessors"]) - 1

    def _texture(self, maps: str, kind: str) -> dict[str, Any]:
        key = f"{maps}_{kind}"
        if key not in self._textures:
            self.document["images"].append({"name": key, "uri": f"textures/{key}.jpg", "mimeType": "image/jpeg"})
            self.document["textures"].append({"name": key, "sampler": 0, "source": len(self.document["images"]) - 1})
            self._textures[key] = len(self.document["textures"]) - 1
        return {"index": self._textures[key]}

    def _material(self, name: str) -> int:
        if name in self._materials:
            return self._materials[name]
        if name not in MATERIALS:
            raise ValueError(f"the material {name!r} is not in materials.py")
        m: Material = MATERIALS[name]
        pbr: dict[str, Any] = {
            "baseColorFactor": [*linear(m.colour), m.alpha],
            "metallicFactor": m.metallic,
            "roughnessFactor": m.roughness,
        }
        entry: dict[str, Any] = {"name": name, "pbrMetallicRoughness": pbr}
        if m.maps:
            files = self.images[m.maps]
            if not m.emissive_map:
                pbr["baseColorTexture"] = self._texture(m.maps, "color")
            if "orm" in files:
                pbr["metallicRoughnessTexture"] = self._texture(m.maps, "orm")
                pbr["roughnessFactor"] = 1.0
                pbr["metallicFactor"] = 1.0
                entry["occlusionTexture"] = self._texture(m.maps, "orm")
            if "normal" in files:
                entry["normalTexture"] = {**self._texture(m.maps, "normal"), "scale": m.bump}
        if any(m.emissive):
            entry["emissiveFactor"] = linear(m.emissive)
            if m.emissive_map:
                entry["emissiveTexture"] = self._texture(m.maps, "color")
            if m.emissive_strength != 1.0:
                entry["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": m.emissive_strength}}
        if m.alpha < 1.0:
            entry["alphaMode"] = "BLEND"
        if m.two_sided:
            entry["doubleSided"] = True
        self.document["materials"].append(entry)
        self._materials[name] = len(self.document["materials"]) - 1
        return self._materials[name]

    def _mesh(self, name: str, mesh: Mesh) -> int:
        primitives = []
        for part in mesh.merged():
            material = self._material(part.material)
            tile = MATERIALS[part.material].tile or 1.0
            positions = part.positions.astype("<f4")
            count = len(positions)
            short = count < 65535
            indices = part.triangles.reshape(-1).astype("<u2" if short else "<u4")
            primitives.append(
                {
                    "attributes": {
                        "POSITION": self._accessor(positions, FLOAT, "VEC3", ARRAY_BUFFER, bounds=True),
                        "NORMAL": self._accessor(part.normals.astype("<f4"), FLOAT, "VEC3", ARRAY_BUFFER),
                        "TEXCOORD_0": self._accessor((part.uv / tile).astype("<f4"), FLOAT, "VEC2", ARRAY_BUFFER),
                    },
                    "indices": self._accessor(
                        indices, UNSIGNED_SHORT if short else UNSIGNED_INT, "SCALAR", ELEMENT_ARRAY_BUFFER
                    ),
                    "material": material,
                }
            )
        self.document["meshes"].append({"name": name, "primitives": primitives})
        return len(self.document["meshes"]) - 1

    def build(self) -> tuple[dict[str, Any], bytes]:
        meshes = {name: self._mesh(name, mesh) for name, mesh in self.scene.meshes.items()}
        lights: list[dict[str, Any]] = []
        numbers = {node.name: k for k, node in enumerate(self.scene.nodes)}
        for number, node in enumerate(self.scene.nodes):
            entry: dict[str, Any] = {"name": node.name, "translation": [round(v, 6) for v in node.position]}
            q = [round(v, 7) for v in node.quaternion()]
            if q != [0.0, 0.0, 0.0, 1.0]:
                entry["rotation"] = q
            if node.scale != (1.0, 1.0, 1.0):
                entry["scale"] = list(node.scale)
            if node.mesh is not None:
                entry["mesh"] = meshes[node.mesh]
            if node.light is not None:
                lights.append({"name": node.name, **node.light})
                entry["extensions"] = {"KHR_lights_punctual": {"light": len(lights) - 1}}
            self.document["nodes"].append(entry)
            if node.parent is None:
                self.document["scenes"][0]["nodes"].append(number)
            else:
                self.document["nodes"][numbers[node.parent]].setdefault("children", []).append(number)
        if lights:
            self.document["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
        self.document["buffers"] = [{"uri": f"{self.scene.name}.bin", "byteLength": len(self.binary)}]
        return {k: v for k, v in self.document.items() if v != []}, bytes(self.binary)


def sidecar(scene: Scene, settings: dict[str, Any]) -> dict[str, Any]:
    """The sidecar document; see docs/scenes.md for the format."""
    nodes: dict[str, Any] = {}
    for node in scene.nodes:
        entry: dict[str, Any] = {}
        if node.unreal_class:
            entry["class"] = node.unreal_class
        if node.tags:
            entry["tags"] = node.tags
        if node.component_tags:
            entry["component_tags"] = node.component_tags
        if node.mobility != "Static":
            entry["mobility"] = node.mobility
        if node.folder:
            entry["folder"] = node.folder
        if node.properties:
            entry["properties"] = node.properties
        nodes[node.name] = entry
    return {
        "format": "spear-scene",
        "version": 1,
        "name": scene.name,
        "gltf": f"{scene.name}.gltf",
        **settings,
        "actors": scene.actors,
        "nodes": nodes,
    }


def write(scene: Scene, settings: dict[str, Any], folder: Path, workers: int) -> None:
    """Writes all files of the scene below `folder`, each complete or not at all."""
    used = {part.material for mesh in scene.meshes.values() for part in mesh.parts}
    unknown = sorted(used - MATERIALS.keys())
    if unknown:
        raise ValueError(f"materials used but not in materials.py: {', '.join(unknown)}")
    names = sorted({MATERIALS[m].maps for m in used if MATERIALS[m].maps})
    if workers > 1:
        with ProcessPoolExecutor(workers) as pool:
            images = dict(zip(names, pool.map(make_maps, names), strict=True))
    else:
        images = {name: make_maps(name) for name in names}
    document, binary = GltfWriter(scene, images).build()
    used_images = {image["name"] for image in document.get("images", [])}
    (folder / "textures").mkdir(parents=True, exist_ok=True)
    for name, files in images.items():
        for kind, data in files.items():
            if f"{name}_{kind}" in used_images:
                replace(folder / "textures" / f"{name}_{kind}.jpg", data)
    replace(folder / f"{scene.name}.bin", binary)
    replace(folder / f"{scene.name}.gltf", (json.dumps(document, indent=1) + "\n").encode())
    replace(folder / f"{scene.name}.scene.json", (json.dumps(sidecar(scene, settings), indent=1) + "\n").encode())


def replace(path: Path, data: bytes) -> None:
    temporary = path.with_suffix(path.suffix + ".tmp")
    temporary.write_bytes(data)
    temporary.replace(path)
