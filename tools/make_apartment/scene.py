# SPDX-License-Identifier: MIT
"""The scene being built: named objects, lights and actors without geometry, in metres with Y up (glTF's axes)."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from geometry import Mesh

Vector = tuple[float, float, float]


@dataclass
class Node:
    """One named object. Its front is local +Z; yaw turns it counter-clockwise seen from above (90 degrees: the front
    looks to +X)."""

    name: str
    position: Vector
    yaw: float = 0.0
    rotation: tuple[float, float, float, float] | None = None
    scale: Vector = (1.0, 1.0, 1.0)
    mesh: str | None = None
    light: dict[str, Any] | None = None
    unreal_class: str | None = None
    tags: list[str] = field(default_factory=list)
    component_tags: list[str] = field(default_factory=list)
    mobility: str = "Static"
    folder: str = ""
    properties: dict[str, Any] = field(default_factory=dict)
    parent: str | None = None

    def quaternion(self) -> tuple[float, float, float, float]:
        if self.rotation is not None:
            return self.rotation
        half = math.radians(self.yaw) / 2
        return (0.0, math.sin(half), 0.0, math.cos(half))


class Scene:
    """Collects meshes and nodes. Names are `<kind>_<number>`, numbered in the order of creation, so that they stay
    stable."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.meshes: dict[str, Mesh] = {}
        self.nodes: list[Node] = []
        self.actors: list[dict[str, Any]] = []
        self._numbers: dict[str, int] = {}
        self.room = ""

    def _name(self, kind: str) -> str:
        self._numbers[kind] = self._numbers.get(kind, 0) + 1
        return f"{kind}_{self._numbers[kind]}"

    def shared(self, name: str, mesh: Mesh) -> str:
        """Registers a mesh that several objects use and returns its name."""
        if name in self.meshes:
            raise ValueError(f"the mesh {name!r} is registered already")
        self.meshes[name] = mesh
        return name

    def add(
        self,
        kind: str,
        mesh: Mesh | str,
        at: Vector = (0.0, 0.0, 0.0),
        yaw: float = 0.0,
        tags: tuple[str, ...] = (),
        group: str = "Furniture",
        movable: bool = False,
        scale: float = 1.0,
        unreal_class: str | None = None,
        parent: str | None = None,
    ) -> str:
        """Places an object and returns its name. Every object is also tagged with its kind and its room."""
        name = self._name(kind)
        if isinstance(mesh, Mesh):
            self.meshes[name] = mesh
            mesh = name
        if mesh not in self.meshes:
            raise ValueError(f"{name}: there is no mesh {mesh!r}")
        all_tags = list(dict.fromkeys([*tags, snake(kind), *([snake(self.room)] if self.room else [])]))
        folder = "/".join(part for part in (self.room, group) if part)
        self.nodes.append(
            Node(
                name,
                at,
                yaw,
                None,
                (scale, scale, scale),
                mesh,
                None,
                unreal_class,
                all_tags,
                mobility="Movable" if movable else "Static",
                folder=folder,
                parent=parent,
            )
        )
        return name

    def light(
        self,
        kind: str,
        at: Vector,
        intensity: float,
        colour: Vector = (1.0, 0.82, 0.62),
        reach: float = 8.0,
        spot: tuple[float, float] | None = None,
        direction: Vector | None = None,
        properties: dict[str, Any] | None = None,
    ) -> str:
        """A punctual light: intensity in candela (lux for a directional one), reach in metres, spot = (inner, outer)
        half angles in degrees.

        direction is where the light shines to; only spots and directional lights have one.
        """
        light: dict[str, Any] = {"type": kind, "intensity": intensity, "color": [round(c, 4) for c in colour]}
        if kind != "directional":
            light["range"] = reach
        if spot is not None:
            light["spot"] = {"innerConeAngle": math.radians(spot[0]), "outerConeAngle": math.radians(spot[1])}
        unreal_class = {"point": "APointLight", "spot": "ASpotLight", "directional": "ADirectionalLight"}[kind]
        name = self._name(unreal_class[1:])
        folder = f"{self.room}/Lights" if self.room else "Lights"
        tags = ["light", kind + "_light", *([snake(self.room)] if self.room else ["outside"])]
        self.nodes.append(
            Node(
                name,
                at,
                0.0,
                look_along(direction) if direction else None,
                light=light,
                unreal_class=unreal_class,
                tags=tags,
                mobility="Movable",
                folder=folder,
                properties=properties or {},
            )
        )
        return name

    def actor(
        self, name: str, unreal_class: str, location: Vector, rotation: Vector = (0.0, 0.0, 0.0), **rest: Any
    ) -> None:
        """An actor of the sidecar alone: location in UE's centimetres, rotation as pitch, yaw and roll in degrees."""
        self.actors.append(
            {"name": name, "class": unreal_class, "location": list(location), "rotation": list(rotation), **rest}
        )


def look_along(direction: Vector) -> tuple[float, float, float, float]:
    """The rotation that turns glTF's light axis, -Z, to a direction."""
    x, y, z = direction
    length = math.sqrt(x * x + y * y + z * z)
    x, y, z = x / length, y / length, z / length
    # Half-way construction of the shortest turn from (0, 0, -1).
    w = 1.0 - z
    if w < 1e-9:
        return (0.0, 1.0, 0.0, 0.0)
    qx, qy, qz = y, -x, 0.0
    norm = math.sqrt(qx * qx + qy * qy + w * w)
    return (qx / norm, qy / norm, qz / norm, w / norm)


def snake(name: str) -> str:
    """LivingRoom -> living_room."""
    return "".join(("_" if c.isupper() and i else "") + c.lower() for i, c in enumerate(name))
