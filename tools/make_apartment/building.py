# SPDX-License-Identifier: MIT
"""The plan of the apartment: walls, floors, doors, windows, and the garden outside.

Plan, in metres, seen from above (X to the right, Z down; UE's X and Y in centimetres are 100 times these):

    z -5.00  +-----------------+---------+---------------+
             |     Bedroom     |  Bath-  |     Study     |
             |                 |  room   |               |
    z -0.82  +----------door---+--door---+---door--------+
             |   Hall                                    | entrance
    z  0.84  +-----------------opening---+---door--------+
             |     LivingRoom            |    Kitchen    |
             |                        opening            |
    z  5.30  +--terrace door---window----+----window-----+
           x -3.40            0.86   3.06 3.46           7.00
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from furniture_common import leaf_blade, radiator
from geometry import Mesh, box, normalize, sphere, tube, union, waves
from scene import Scene
from shell import CEILING, COVING, Opening, casing, ceiling, door_leaf, floor, slab, sliding_window, trim, wall, window

INNER, OUTER = 0.12, 0.30


@dataclass(frozen=True)
class Room:
    name: str
    x0: float
    x1: float
    z0: float
    z1: float
    paint: str
    floor: str

    @property
    def centre(self) -> tuple[float, float]:
        return (self.x0 + self.x1) / 2, (self.z0 + self.z1) / 2


ROOMS = {
    room.name: room
    for room in (
        Room("LivingRoom", -3.40, 3.00, 0.90, 5.30, "paint_living", "parquet"),
        Room("Kitchen", 3.12, 7.00, 0.90, 5.30, "paint_kitchen", "kitchen_floor"),
        Room("Hall", -3.40, 7.00, -0.70, 0.78, "paint_hall", "parquet"),
        Room("Bedroom", -3.40, 0.80, -5.00, -0.82, "paint_bedroom", "parquet"),
        Room("Bathroom", 0.92, 3.40, -5.00, -0.82, "paint_white", "bath_floor"),
        Room("Study", 3.52, 7.00, -5.00, -0.82, "paint_study", "parquet"),
    )
}

DOOR_TOP = 2.10


@dataclass(frozen=True)
class Hole:
    """An opening in building coordinates: from a to b along the wall, bottom to top; kind is door, opening, window,
    terrace or entrance."""

    a: float
    b: float
    bottom: float
    top: float
    kind: str
    open_degrees: float = 0.0
    columns: int = 2


# Walls along X: z of the middle, thickness, from, to, paint on the north side, paint on the south side, holes.
WALLS_X: list[tuple[float, float, float, float, str, str, list[Hole]]] = [
    (
        5.45,
        OUTER,
        -3.70,
        3.06,
        "paint_living",
        "facade",
        [Hole(-2.4, -0.2, 0.0, 2.28, "terrace"), Hole(0.9, 2.5, 0.80, 2.25, "window")],
    ),
    (5.45, OUTER, 3.06, 7.30, "paint_kitchen", "facade", [Hole(3.9, 5.6, 0.80, 2.25, "window")]),
    (-5.15, OUTER, -3.70, 0.86, "facade", "paint_bedroom", [Hole(-2.3, -0.3, 0.80, 2.25, "window")]),
    (-5.15, OUTER, 0.86, 3.46, "facade", "metro_tiles", [Hole(1.55, 2.45, 1.35, 2.25, "window", columns=1)]),
    (-5.15, OUTER, 3.46, 7.30, "facade", "paint_study", [Hole(4.4, 6.2, 0.90, 2.25, "window")]),
    (0.84, INNER, -3.40, 3.06, "paint_hall", "paint_living", [Hole(0.9, 2.3, 0.0, 2.25, "opening")]),
    (0.84, INNER, 3.06, 7.00, "paint_hall", "paint_kitchen", [Hole(3.5, 4.4, 0.0, DOOR_TOP, "door", -78.0)]),
    (-0.76, INNER, -3.40, 0.86, "paint_bedroom", "paint_hall", [Hole(-0.5, 0.4, 0.0, DOOR_TOP, "door", 62.0)]),
    (-0.76, INNER, 0.86, 3.46, "metro_tiles", "paint_hall", [Hole(1.6, 2.45, 0.0, DOOR_TOP, "door", 48.0)]),
    (-0.76, INNER, 3.46, 7.00, "paint_study", "paint_hall", [Hole(4.2, 5.1, 0.0, DOOR_TOP, "door", 85.0)]),
]
# Walls along Z: x of the middle, thickness, from, to, paint on the west side, paint on the east side, holes.
WALLS_Z: list[tuple[float, float, float, float, str, str, list[Hole]]] = [
    (-3.55, OUTER, 0.84, 5.30, "facade", "paint_accent", []),
    (-3.55, OUTER, -0.76, 0.84, "facade", "paint_hall", []),
    (-3.55, OUTER, -5.00, -0.76, "facade", "paint_bedroom", []),
    (7.15, OUTER, 0.84, 5.30, "paint_kitchen", "facade", [Hole(2.35, 3.85, 1.15, 2.25, "window")]),
    (7.15, OUTER, -0.76, 0.84, "paint_hall", "facade", [Hole(-0.42, 0.52, 0.0, DOOR_TOP, "entrance")]),
    (7.15, OUTER, -5.00, -0.76, "paint_study", "facade", [Hole(-3.9, -2.4, 0.80, 2.25, "window")]),
    (3.06, INNER, 0.90, 5.30, "paint_living", "paint_kitchen", [Hole(3.2, 5.0, 0.0, 2.25, "opening")]),
    (0.86, INNER, -5.00, -0.82, "paint_bedroom", "metro_tiles", []),
    (3.46, INNER, -5.00, -0.82, "metro_tiles", "paint_study", []),
]


def build(scene: Scene) -> None:
    """Adds the shell of the building."""
    for z, thickness, x0, x1, north, south, holes in WALLS_X:
        openings = [Opening(h.a - x0, h.b - x0, h.bottom, h.top) for h in holes]
        scene.room = ""
        scene.add(
            "Wall",
            wall(x1 - x0, thickness, openings, south, north, x0),
            (x0, 0.0, z),
            tags=("structure",),
            group="Structure",
        )
        for hole in holes:
            _fill(scene, hole, thickness, ((hole.a + hole.b) / 2, z), 0.0)
    for x, thickness, z0, z1, west, east, holes in WALLS_Z:
        # Turned by +90 degrees the wall runs towards -Z and its front (+Z) looks to the east.
        openings = [Opening(z1 - h.b, z1 - h.a, h.bottom, h.top) for h in holes]
        scene.room = ""
        scene.add(
            "Wall",
            wall(z1 - z0, thickness, openings, east, west, -z1),
            (x, 0.0, z1),
            90.0,
            tags=("structure",),
            group="Structure",
        )
        for hole in holes:
            _fill(scene, hole, thickness, (x, (hole.a + hole.b) / 2), 90.0)
    for room in ROOMS.values():
        scene.room = room.name
        # A floor reaches to the middle of the inner walls, so that doorways have no gap.
        scene.add(
            "Floor",
            floor(room.floor, room.x0 - 0.06, room.x1 + 0.06, room.z0 - 0.06, room.z1 + 0.06),
            tags=("structure", "room"),
            group="Structure",
        )
        scene.add(
            "Ceiling",
            ceiling("paint_ceiling", room.x0 - 0.06, room.x1 + 0.06, room.z0 - 0.06, room.z1 + 0.06),
            tags=("structure",),
            group="Structure",
        )
        if room.name != "Bathroom":
            scene.add(
                "Skirting",
                trim(room.x0, room.x1, room.z0, room.z1, _gaps(room)),
                tags=("structure", "trim"),
                group="Structure",
            )
            scene.add(
                "Coving",
                trim(room.x0, room.x1, room.z0, room.z1, {}, COVING),
                tags=("structure", "trim"),
                group="Structure",
            )
    scene.room = ""
    scene.add(
        "Foundation", slab("stone", -3.70, 7.30, -5.30, 5.60, -0.30, -0.021), tags=("structure",), group="Structure"
    )
    scene.add(
        "Roof",
        slab("roof", -3.95, 7.55, -5.55, 5.85, CEILING + 0.021, CEILING + 0.32),
        tags=("structure",),
        group="Structure",
    )


def _gaps(room: Room) -> dict[str, list[tuple[float, float]]]:
    """Where openings that reach the floor interrupt the skirting of a room."""
    gaps: dict[str, list[tuple[float, float]]] = {"north": [], "south": [], "west": [], "east": []}
    for z, thickness, _, _, _, _, holes in WALLS_X:
        for h in holes:
            if h.bottom == 0.0 and room.x0 < (h.a + h.b) / 2 < room.x1:
                for side, edge in (("north", room.z0), ("south", room.z1)):
                    if abs(abs(z - edge) - thickness / 2) < 1e-6:
                        gaps[side].append((h.a - 0.055, h.b + 0.055))
    for x, thickness, _, _, _, _, holes in WALLS_Z:
        for h in holes:
            if h.bottom == 0.0 and room.z0 < (h.a + h.b) / 2 < room.z1:
                for side, edge in (("west", room.x0), ("east", room.x1)):
                    if abs(abs(x - edge) - thickness / 2) < 1e-6:
                        gaps[side].append((h.a - 0.055, h.b + 0.055))
    return gaps


def _fill(scene: Scene, hole: Hole, thickness: float, centre: tuple[float, float], yaw: float) -> None:
    """Puts door, casing or window into an opening."""
    x, z = centre
    width = hole.b - hole.a
    along_x = yaw == 0.0
    if hole.kind in ("door", "opening", "entrance"):
        scene.add("DoorFrame", casing(width, hole.top, thickness), (x, 0.0, z), yaw, ("structure", "trim"), "Structure")
    if hole.kind == "door":
        leaf = width - 0.056
        scene.add(
            "Door",
            door_leaf(leaf, hole.top - 0.026),
            (hole.a + 0.028, 0.0, z),
            hole.open_degrees,
            ("structure", "openable"),
            "Structure",
            True,
        )
    elif hole.kind == "entrance":
        leaf = width - 0.056
        scene.add(
            "Door",
            door_leaf(leaf, hole.top - 0.026, "painted_navy", "chrome"),
            (x - 0.06, 0.0, hole.b - 0.028),
            90.0,
            ("structure", "openable", "entrance"),
            "Structure",
            True,
        )
    elif hole.kind == "window":
        inward = 180.0 if (along_x and z > 0) else 0.0 if along_x else -90.0
        scene.add(
            "Window",
            window(width, hole.top - hole.bottom, hole.columns, "frosted_glass" if hole.columns == 1 else "glass"),
            (x, hole.bottom, z),
            inward,
            ("structure", "glass"),
            "Structure",
        )
        if hole.columns > 1 and hole.bottom < 1.0:
            d = OUTER / 2 + 0.002
            dx, dz = (0.0, -d if z > 0 else d) if along_x else (-d, 0.0)
            scene.add(
                "Radiator",
                radiator(min(width - 0.2, 1.5), hole.bottom - 0.26),
                (x + dx, 0.0, z + dz),
                inward,
                ("fixture",),
                "Fixtures",
            )
    elif hole.kind == "terrace":
        scene.add(
            "TerraceDoor",
            sliding_window(width, hole.top),
            (x, 0.0, z),
            180.0,
            ("structure", "glass", "door"),
            "Structure",
        )


def _tree(seed: int, height: float) -> Mesh:
    """A small deciduous tree: trunk, branches, and a crown of leaf clusters."""
    random = np.random.default_rng(seed)
    mesh = tube(
        "bark",
        [(0, -0.2, 0), (0.05, height * 0.25, 0.02), (0.0, height * 0.55, 0.05), (0.06, height * 0.85, 0.0)],
        [0.15, 0.12, 0.08, 0.03],
        10,
    )
    for k in range(9):
        a, y = k * 2.4, height * (0.38 + 0.055 * k)
        reach = height * 0.26 * (1.1 - 0.06 * k)
        tip = np.array([reach * math.cos(a), y + height * 0.12, reach * math.sin(a)])
        mesh.add(
            tube(
                "bark",
                [(0.02, y - 0.1, 0.03), tuple(tip * np.array([0.5, 1, 0.5]) - np.array([0, 0.1, 0])), tuple(tip)],
                [0.045, 0.03, 0.012],
                6,
            )
        )
    crown = np.array([0.0, height * 0.72, 0.0])
    positions = []
    for _ in range(240):
        d = normalize(random.normal(size=3)) * np.array([0.30, 0.26, 0.30]) * height * float(random.uniform(0.55, 1.0))
        positions.append(crown + d)
    shapes = [leaf_blade(m, 0.26, 0.17, 0.9, 4, 0.2, rows=3) for m in ("leaf", "leaf_dark", "leaf_light")]
    for k, p in enumerate(positions):
        for _ in range(2):
            one = shapes[k % 3].copy()
            mesh.add(
                one.rotate("z", float(random.uniform(-60, 40)))
                .rotate("y", float(random.uniform(0, 360)))
                .move(*(p + random.normal(size=3) * 0.10))
            )
    return mesh


def _hedge(length: float, seed: int) -> Mesh:
    mesh = box("leaf_dark", (length, 1.35, 0.7), 0.15, 2, flat=14).move(0, 0.62, 0)
    mesh.map_uv(lambda uv: uv * 1.8)
    return mesh.displace(
        lambda p, n: p + n * (0.09 * waves(p, 6.0, seed, 4) + 0.05 * waves(p, 23.0, seed + 1, 2))[:, None]
    )


def outside(scene: Scene) -> None:
    """The garden that the windows show."""
    scene.room = ""
    scene.add(
        "Lawn", slab("grass", -42.0, 46.0, -42.0, 46.0, -0.40, -0.18), tags=("outside", "ground"), group="Outside"
    )
    deck = Mesh()
    for k in range(24):
        deck.add(box("deck", (6.7, 0.03, 0.118), 0.004).move(-0.35, -0.05, 5.72 + 0.122 * k))
    scene.add(
        "Deck", deck.add(slab("stone", -3.65, 2.95, 5.62, 8.55, -0.25, -0.07)), tags=("outside",), group="Outside"
    )
    step = slab("stone", 7.3, 8.6, -0.75, 0.85, -0.2, -0.02)
    scene.add("DoorStep", step, tags=("outside",), group="Outside")
    hedge = scene.shared("Hedge", _hedge(9.0, 5))
    for x, z, yaw in (
        (-9.0, 12.5, 0.0),
        (0.2, 12.7, 180.0),
        (9.3, 12.4, 0.0),
        (13.6, 7.6, 90.0),
        (13.7, -1.5, 90.0),
        (13.6, -10.6, -90.0),
        (-9.0, -12.4, 0.0),
        (0.2, -12.6, 180.0),
        (9.3, -12.5, 0.0),
    ):
        scene.add("Hedge", hedge, (x, -0.18, z), yaw, ("outside", "plant"), "Outside")
    trees = [scene.shared("TreeA", _tree(11, 4.2)), scene.shared("TreeB", _tree(23, 5.2))]
    places = (
        (-6.5, 9.6),
        (3.4, 10.4),
        (7.6, 9.0),
        (11.2, 3.0),
        (10.8, -4.4),
        (6.0, -9.6),
        (-1.6, -9.2),
        (-7.6, -8.4),
        (0.4, 16.5),
        (-4.5, 17.5),
    )
    for k, (x, z) in enumerate(places):
        scene.add(
            "Tree", trees[k % 2], (x, -0.18, z), 57.0 * k, ("outside", "plant"), "Outside", scale=1.0 + 0.08 * (k % 3)
        )
    stones = Mesh()
    for k in range(6):
        stones.add(
            box("stone", (0.62, 0.06, 0.45), 0.03, 2)
            .rotate("y", 8 * math.sin(k * 2.1))
            .move(9.0 + 0.75 * k, -0.17, 0.1 * math.sin(k))
        )
    scene.add("Path", stones, tags=("outside",), group="Outside")
    planter = union(
        box("terracotta", (0.9, 0.36, 0.36), 0.02, 2).move(0, 0.14, 0),
        box("soil", (0.82, 0.02, 0.28), 0.0).move(0, 0.315, 0),
    )
    random = np.random.default_rng(9)
    for k in range(26):
        x, z = float(random.uniform(-0.38, 0.38)), float(random.uniform(-0.11, 0.11))
        planter.add(
            leaf_blade("leaf_light", 0.26, 0.09, 0.5, 5)
            .rotate("z", float(random.uniform(45, 80)))
            .rotate("y", 137.5 * k)
            .move(x, 0.32, z)
        )
        if k % 3 == 0:
            planter.add(sphere("petal", 0.032, 10, 0.7).move(x, 0.56 + 0.05 * math.sin(k), z))
    mesh = scene.shared("Planter", planter)
    for x in (-3.1, 0.5, 2.4):
        scene.add("Planter", mesh, (x, 0.0, 6.0), tags=("outside", "plant"), group="Outside")
