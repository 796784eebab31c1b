# SPDX-License-Identifier: MIT
"""Pieces that several rooms use: legs, handles, books, frames, lamps, curtains, plants, doors of cupboards."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from geometry import Array, Mesh, box, curve, cylinder, lathe, normalize, quad, soft_box, sphere, surface, tube, union
from pictures import BOOK_CELLS


def box_at(
    material: str,
    size: Sequence[float],
    x: float,
    y: float,
    z: float,
    radius: float = 0.004,
    segments: int = 1,
    grain: str = "x",
) -> Mesh:
    """A box whose bottom is centred at (x, y, z)."""
    return box(material, size, radius, segments, grain).move(x, y + size[1] / 2, z)


def board(material: str, size: Sequence[float], x: float, y: float, z: float, radius: float = 0.003) -> Mesh:
    """A box_at whose wood grain runs along its longest side."""
    grain = "xyz"[int(np.argmax(size))]
    return box_at(material, size, x, y, z, radius, 1, grain)


def tapered_leg(
    material: str, height: float, top: float, bottom: float, lean: tuple[float, float] = (0.0, 0.0)
) -> Mesh:
    """A round leg from the origin upwards; lean moves its foot outwards in x and z."""
    mesh = lathe(material, [(0, 0), (bottom * 0.8, 0), (bottom, 0.006), (top, height), (0, height)], 14, 40)
    for part in mesh.parts:
        share = (1 - part.positions[:, 1] / height)[:, None]
        part.positions = part.positions + share * np.array([lean[0], 0, lean[1]])
        part.uv = part.uv[:, ::-1].copy()
    return mesh


def turned_leg(material: str, height: float, radius: float) -> Mesh:
    """A lathe-turned table leg with a foot, rings and a square block at the top."""
    h, r = height - 0.11, radius
    profile = [
        (0, 0),
        (r * 0.42, 0),
        (r * 0.55, 0.015),
        (r * 0.5, 0.04),
        (r * 0.36, 0.05),
        (r * 0.42, 0.10),
        (r * 0.62, h * 0.45),
        (r * 0.72, h * 0.70),
        (r * 0.60, h * 0.80),
        (r * 0.42, h * 0.85),
        (r * 0.66, h * 0.88),
        (r * 0.72, h * 0.905),
        (r * 0.62, h * 0.93),
        (r * 0.46, h * 0.95),
        (r * 0.8, h * 0.985),
        (r * 0.8, h),
        (0, h),
    ]
    leg = lathe(material, profile, 18, 60)
    leg.map_uv(lambda uv: uv[:, ::-1].copy())
    return leg.add(box_at(material, (2 * r * 0.86, 0.11, 2 * r * 0.86), 0, h, 0, 0.005, 1, "y"))


def bar_handle(material: str, length: float, vertical: bool = False) -> Mesh:
    """A bar on two posts, centred, sticking out to +Z by 3 cm."""
    half = length / 2
    mesh = tube(material, [(-half, 0, 0.028), (half, 0, 0.028)], 0.0055, 10)
    for x in (-half * 0.8, half * 0.8):
        mesh.add(tube(material, [(x, 0, 0), (x, 0, 0.028)], 0.0042, 8))
    return mesh.rotate("z", 90) if vertical else mesh


def knob(material: str, radius: float = 0.014) -> Mesh:
    return lathe(
        material,
        [
            (0, 0),
            (radius * 0.5, 0),
            (radius * 0.42, 0.010),
            (radius, 0.018),
            (radius * 0.9, 0.027),
            (radius * 0.45, 0.031),
            (0, 0.032),
        ],
        16,
        70,
    ).rotate("x", 90)


def panel_front(material: str, width: float, height: float, frame: float = 0.055, thickness: float = 0.019) -> Mesh:
    """A shaker door: frame of four rails round a recessed panel; centred, front at +Z, back at 0."""
    w, h, f, t = width, height, frame, thickness
    mesh = Mesh()
    for x in (-(w - f) / 2, (w - f) / 2):
        mesh.add(box(material, (f, h, t), 0.003, 1, "y").move(x, 0, t / 2))
    for y in (-(h - f) / 2, (h - f) / 2):
        mesh.add(box(material, (w - 2 * f, f, t), 0.003, 1, "x").move(0, y, t / 2))
    return mesh.add(
        box(material, (w - 2 * f + 0.004, h - 2 * f + 0.004, t * 0.45), 0.0, 1, "y" if h > w else "x").move(
            0, 0, t * 0.225
        )
    )


def book(width: float, height: float, depth: float, cell: int) -> Mesh:
    """A standing book, spine to +Z, bottom centred at the origin: a cover round a block of pages."""
    t = 0.0022
    cover = Mesh()
    for x in (-(width - t) / 2, (width - t) / 2):
        cover.add(box_at("books", (t, height, depth), x, 0, 0, 0.0, 1))
    cover.add(box_at("books", (width, height, t), 0, 0, depth / 2 - t / 2, 0.0008, 1))
    u0, u1 = (cell + 0.04) / BOOK_CELLS, (cell + 0.96) / BOOK_CELLS
    for part in cover.parts:
        across, up = part.positions[:, 0] / width + 0.5, part.positions[:, 1] / height
        spine = np.abs(part.normals[:, 2]) > 0.5
        u = np.where(spine, u0 + (u1 - u0) * np.clip(across, 0, 1), u0 + 0.02)
        part.uv = np.stack([u, np.where(spine, 1 - np.clip(up, 0.0, 1.0), 0.75)], 1)
    pages = box_at("paper", (width - 2 * t, height - 0.006, depth - 0.006), 0, 0.003, -0.001, 0.0)
    return cover.add(pages)


def book_row(
    length: float, seed: int, heights: tuple[float, float] = (0.17, 0.25), depth: float = 0.15, lean: bool = True
) -> Mesh:
    """Books side by side along X from 0 to at most `length`, spines to +Z at z = 0; the last one leans on the
    others."""
    random = np.random.default_rng(seed)
    mesh = Mesh()
    x = 0.0
    while True:
        width = float(random.uniform(0.016, 0.042))
        height = float(random.uniform(*heights))
        if x + width > length:
            break
        d = depth * float(random.uniform(0.82, 1.0))
        one = book(width, height, d, int(random.integers(0, BOOK_CELLS))).move(0, 0, -d / 2)
        if lean and x + width + 0.09 > length and x > 0.1:
            one = one.move(width / 2).rotate("z", 11).move(x + 0.002 + height * math.sin(math.radians(11)), 0, 0)
            mesh.add(one)
            break
        mesh.add(one.move(x + width / 2, 0, float(random.uniform(-0.006, 0.0))))
        x += width + 0.0012
    return mesh


def book_stack(count: int, seed: int) -> Mesh:
    """Books lying on each other, bottom at y = 0."""
    random = np.random.default_rng(seed)
    mesh, y = Mesh(), 0.0
    for _ in range(count):
        width, height, depth = (
            float(random.uniform(0.018, 0.034)),
            float(random.uniform(0.19, 0.25)),
            float(random.uniform(0.14, 0.17)),
        )
        one = (
            book(width, height, depth, int(random.integers(0, BOOK_CELLS)))
            .move(0, -height / 2)
            .rotate("z", 90)
            .move(0, width / 2)
        )
        mesh.add(one.rotate("y", float(random.uniform(-16, 16)) + 90).move(0, y, 0))
        y += width + 0.001
    return mesh


def picture(
    image: str, width: float, height: float, frame: str = "oak", mount: bool = True, bar: float = 0.028
) -> Mesh:
    """A framed picture hanging on a wall: centred, its back at z = 0, facing +Z."""
    mesh = Mesh()
    for x in (-(width - bar) / 2, (width - bar) / 2):
        mesh.add(box(frame, (bar, height, 0.030), 0.004, 2, "y").move(x, 0, 0.015))
    for y in (-(height - bar) / 2, (height - bar) / 2):
        mesh.add(box(frame, (width - 2 * bar, bar, 0.030), 0.004, 2, "x").move(0, y, 0.015))
    inset = 0.06 * min(width, height) if mount else 0.0
    mesh.add(box("paper", (width - bar, height - bar, 0.010), 0.0).move(0, 0, 0.008))
    return mesh.add(quad(image, width - 2 * (bar + inset), height - 2 * (bar + inset)).move(0, 0, 0.0145))


def lampshade(bottom: float, top: float, height: float, material: str = "lampshade") -> Mesh:
    """An open drum or cone of cloth with wire rims, bottom at y = 0."""
    outer = lathe(material, [(bottom, 0), (top, height)], 36)
    rims = union(
        *(
            tube(
                "brass",
                [(r * math.cos(a), y, r * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 36, endpoint=False)],
                0.0022,
                6,
                closed=True,
            )
            for r, y in ((bottom, 0.0), (top, height))
        )
    )
    spokes = union(
        *(
            tube("brass", [(0, height - 0.03, 0), (top * math.cos(a), height, top * math.sin(a))], 0.0018, 6)
            for a in (0.0, 2.1, 4.2)
        )
    )
    return union(outer, rims, spokes)


def bulb(radius: float = 0.03) -> Mesh:
    return union(
        sphere("bulb", radius, 14, 1.1), cylinder("brass", radius * 0.45, radius * 1.1, 12).move(0, radius * 0.8, 0)
    )


def table_lamp(body: str, seed: int = 0) -> Mesh:
    """A ceramic table lamp with a cloth shade; the bulb is 0.36 m up."""
    profile = [
        (0, 0),
        (0.062, 0),
        (0.066, 0.008),
        (0.062, 0.016),
        (0.05, 0.022),
        (0.072, 0.06),
        (0.088, 0.11),
        (0.080, 0.165),
        (0.048, 0.215),
        (0.022, 0.24),
        (0.020, 0.258),
        (0, 0.258),
    ]
    mesh = lathe(body, profile, 28, 60)
    mesh.add(
        cylinder("brass", 0.008, 0.075, 10).move(0, 0.255, 0),
        cylinder("brass", 0.017, 0.045, 14, 0.003).move(0, 0.30, 0),
    )
    mesh.add(sphere("bulb", 0.028, 14).move(0, 0.372, 0))
    return mesh.add(lampshade(0.150, 0.105, 0.20).move(0, 0.275, 0))


def floor_lamp() -> Mesh:
    """A tripod floor lamp; the bulb is 1.42 m up."""
    mesh = Mesh()
    for k in range(3):
        a = 2 * math.pi * k / 3 + 0.3
        mesh.add(
            tube(
                "walnut",
                [(0.30 * math.cos(a), 0.004, 0.30 * math.sin(a)), (0.035 * math.cos(a), 1.22, 0.035 * math.sin(a))],
                [0.010, 0.015],
                12,
            )
        )
    mesh.add(
        cylinder("brass", 0.055, 0.035, 24, 0.005).move(0, 1.20, 0),
        cylinder("brass", 0.010, 0.16, 12).move(0, 1.235, 0),
    )
    mesh.add(sphere("bulb", 0.034, 14).move(0, 1.42, 0))
    return mesh.add(lampshade(0.235, 0.19, 0.30).move(0, 1.28, 0))


def pendant(drop: float, shade: str = "painted_black", radius: float = 0.17) -> Mesh:
    """A metal dome hanging from the ceiling: the ceiling is at y = 0, the rim of the dome at -drop."""
    mesh = union(
        cylinder("black_metal", 0.05, 0.022, 20, 0.004).move(0, -0.022, 0),
        tube("rubber", [(0, -0.02, 0), (0, -drop + radius + 0.03, 0)], 0.0032, 8),
    )
    steps = np.linspace(0, 1, 10)
    outer = [
        (
            radius * math.sin(1.5 * t) / math.sin(1.5),
            -drop + radius * 0.92 * (math.cos(1.5 * t) - math.cos(1.5)) / (1 - math.cos(1.5)),
        )
        for t in steps[::-1]
    ]
    inner = [(r * 0.985, y - 0.003) for r, y in outer[::-1]]
    mesh.add(lathe(shade, outer, 32, 60), lathe("brass", inner, 32, 60))
    mesh.add(cylinder("brass", 0.022, 0.05, 14, 0.004).move(0, -drop + radius * 0.9, 0))
    return mesh.add(bulb(0.036).move(0, -drop + 0.06, 0))


def flush_lamp(radius: float = 0.2) -> Mesh:
    """A shallow opal ceiling lamp below y = 0."""
    ring = lathe("brass", [(radius * 0.92, -0.045), (radius, -0.040), (radius, 0), (radius * 0.9, 0)], 36, 30)
    steps = np.linspace(0, 1, 8)
    dome = [(radius * 0.94 * math.sin(1.45 * t), -0.035 - 0.055 * math.cos(1.45 * t)) for t in steps]
    return union(ring, lathe("led", dome, 36, 80))


def curtain(width: float, height: float, material: str, seed: int, folds: float = 9.0, depth: float = 0.055) -> Mesh:
    """A drawn curtain hanging from y = height to 0, centred in x; the folds deepen towards the hem."""
    random = np.random.default_rng(seed)
    phases, sizes = random.uniform(0, 2 * math.pi, 4), random.uniform(0.6, 1.0, 4)

    def shape(u: Array, v: Array) -> Array:
        swing = u + 0.012 * np.sin(5 * u + 3 * v + phases[3])
        wave = np.sin(2 * math.pi * folds * swing + phases[0]) * sizes[0]
        wave = wave + 0.45 * np.sin(2 * math.pi * folds * 0.5 * swing + phases[1] + 0.6 * v) * (1 - 0.6 * v) * sizes[1]
        wave = wave + 0.2 * np.sin(2 * math.pi * folds * 1.9 * swing + phases[2] + 2.2 * v) * sizes[2] * (1 - v)
        amount = depth * (0.62 + 0.38 * (1 - v))
        gather = 1 - 0.05 * np.sin(math.pi * v)
        return np.stack([(u - 0.5) * width * gather, v * height, amount * wave * 0.62], 1)

    cloth = surface(material, shape, 14, int(folds * 11), (width * 1.7, height))
    return cloth


def curtain_rod(length: float, material: str = "brass") -> Mesh:
    """A rod with finials, brackets to -Z and rings, centred at the origin."""
    half = length / 2
    mesh = tube(material, [(-half, 0, 0), (half, 0, 0)], 0.011, 14)
    for side in (-1, 1):
        mesh.add(sphere(material, 0.024, 16).move(side * (half + 0.018), 0, 0))
        mesh.add(tube(material, [(side * (half - 0.12), 0, 0), (side * (half - 0.12), 0, -0.09)], 0.007, 8))
        mesh.add(cylinder(material, 0.024, 0.008, 16, 0.002).rotate("x", 90).move(side * (half - 0.12), 0, -0.098))
    for x in np.linspace(-half + 0.05, half - 0.05, int(length / 0.11)):
        if abs(x) > half * 0.45:
            ring = [
                (float(x), -0.012 + 0.021 * math.sin(a), 0.021 * math.cos(a))
                for a in np.linspace(0, 2 * math.pi, 12, endpoint=False)
            ]
            mesh.add(tube(material, ring, 0.0022, 6, closed=True))
    return mesh


def leaf_blade(
    material: str,
    length: float,
    width: float,
    droop: float,
    steps: int = 7,
    cup: float = 0.25,
    tip: float = 0.85,
    rows: int = 5,
) -> Mesh:
    """A leaf from the origin along +X, drooping downwards along its length; texture from 0 to 1."""

    def shape(u: Array, v: Array) -> Array:
        outline = np.sin(math.pi * np.clip(u, 0, 1) ** tip) ** 0.75
        angle = -droop * u
        x = length * np.where(abs(droop) < 1e-6, u, np.sin(droop * u) / max(droop, 1e-6))
        y = length * np.where(abs(droop) < 1e-6, 0 * u, -(1 - np.cos(droop * u)) / max(droop, 1e-6))
        side = (v - 0.5) * width * outline
        lift = cup * np.abs(v - 0.5) * 2 * width * 0.5 * outline
        return np.stack([x - lift * np.sin(angle), y + lift * np.cos(angle), -side], 1)

    return surface(material, shape, rows, steps)


def plant_pot(material: str, radius: float, height: float) -> Mesh:
    """A pot with a rim, filled with soil to 3 cm below it."""
    r = radius
    pot = lathe(
        material,
        [
            (0, 0),
            (r * 0.70, 0),
            (r * 0.72, 0.006),
            (r * 0.92, height - 0.035),
            (r, height - 0.03),
            (r, height),
            (r * 0.93, height),
            (r * 0.88, height - 0.05),
            (r * 0.85, height - 0.06),
        ],
        32,
        40,
    )
    soil = lathe("soil", [(r * 0.89, height - 0.035), (r * 0.5, height - 0.025), (0, height - 0.022)], 24, 80)
    return pot.add(soil)


def fiddle_plant(seed: int, height: float, leaves: int, material: str = "leaf_dark", leaf_size: float = 0.24) -> Mesh:
    """A rubber-tree-like plant: two stems with large leaves, rooted at the origin."""
    random = np.random.default_rng(seed)
    mesh = Mesh()
    stems = []
    for k in range(2):
        a = random.uniform(0, 2 * math.pi)
        points = [(0.02 * math.cos(a + k * 3), 0.0, 0.02 * math.sin(a + k * 3))]
        for t in (0.35, 0.7, 1.0):
            points.append(
                (
                    points[0][0] + 0.10 * t * math.cos(a + k * 3) + random.normal() * 0.015,
                    height * t * (1 - 0.18 * k),
                    points[0][2] + 0.10 * t * math.sin(a + k * 3) + random.normal() * 0.015,
                )
            )
        path = curve(*points, steps=6)
        stems.append(path)
        mesh.add(tube("bark", path, list(np.linspace(0.013, 0.006, len(path))), 8))
    for k in range(leaves):
        path = stems[k % 2]
        t = 0.18 + 0.82 * (k + 0.5) / leaves
        p = path[min(int(t * (len(path) - 1)), len(path) - 1)]
        a = k * 137.5
        size = leaf_size * (0.75 + 0.5 * random.uniform()) * (1.15 - 0.45 * t)
        lift = 25 + 40 * t + random.normal() * 8
        blade = leaf_blade(material, size, size * 0.62, 0.9 + 0.4 * random.uniform(), 8)
        stalk = tube("stem", [(0, 0, 0), (0.05, 0.0, 0)], [0.004, 0.003], 6)
        mesh.add(union(stalk, blade.move(0.045)).rotate("z", lift).rotate("y", a).move(*p))
    return mesh


def snake_plant(seed: int, height: float, leaves: int) -> Mesh:
    """Upright sword leaves twisting from the origin."""
    random = np.random.default_rng(seed)
    mesh = Mesh()
    for k in range(leaves):
        size = height * float(random.uniform(0.6, 1.0))
        width = 0.055 * float(random.uniform(0.8, 1.2))
        twist, bend = float(random.normal() * 0.7), float(random.uniform(0.02, 0.22))

        def shape(
            u: Array, v: Array, size: float = size, width: float = width, twist: float = twist, bend: float = bend
        ) -> Array:
            w = width * np.clip(np.minimum(0.65 + u * 1.2, (1 - u) * 3.2 + 0.02), 0, 1) * (v - 0.5)
            a = twist * u
            x = bend * u * u * size + w * np.sin(a)
            cup = 0.6 * np.abs(v - 0.5) * width
            return np.stack([x + cup, size * u, w * np.cos(a)], 1)

        mesh.add(
            surface("leaf_light" if k % 3 == 0 else "leaf", shape, 5, 9)
            .rotate("y", k * 137.5)
            .move(0.035 * math.cos(k * 2.4) * (k / leaves), 0, 0.035 * math.sin(k * 2.4) * (k / leaves))
        )
    return mesh


def fern(seed: int, radius: float, fronds: int, material: str = "leaf_light") -> Mesh:
    """Arching fronds with many small leaves, rooted at the origin."""
    random = np.random.default_rng(seed)
    mesh = Mesh()
    for k in range(fronds):
        a = k * 137.5 + random.normal() * 6
        length = radius * float(random.uniform(0.75, 1.1))
        rise = float(random.uniform(0.35, 0.95)) * radius
        path = curve(
            (0, 0, 0), (length * 0.3, rise * 0.8, 0), (length * 0.7, rise, 0), (length, rise * 0.55, 0), steps=5
        )
        frond = tube("stem", path, list(np.linspace(0.003, 0.001, len(path))), 5, caps=False)
        for i in range(2, len(path)):
            t = i / len(path)
            size = 0.34 * radius * (math.sin(math.pi * (0.12 + 0.85 * t)) ** 0.8)
            for side in (-1, 1):
                frond.add(
                    leaf_blade(material, size, size * 0.30, 0.5, 5, 0.1, rows=3)
                    .rotate("y", side * 62)
                    .rotate("z", -10 * t)
                    .move(*path[i])
                )
        mesh.add(frond.rotate("y", a))
    return mesh


def trailing_plant(seed: int, strands: int, length: float) -> Mesh:
    """Ivy hanging over the rim of a pot whose soil is at the origin and whose rim has a radius of 8 cm."""
    random = np.random.default_rng(seed)
    mesh = Mesh()
    for k in range(strands):
        drop = length * float(random.uniform(0.35, 1.0)) * (0.35 if k % 3 == 0 else 1.0)
        out = 0.10 + 0.03 * float(random.uniform())
        path = curve(
            (0.02, 0, 0),
            (0.07, 0.05, 0),
            (out, 0.01, 0.01),
            (out + 0.01, -drop * 0.5, 0.02 * random.normal()),
            (out + 0.02 * random.normal(), -drop, 0.03 * random.normal()),
            steps=4,
        )
        strand = tube("stem", path, 0.0018, 5, caps=False)
        for i in range(1, len(path)):
            size = float(random.uniform(0.035, 0.06))
            strand.add(
                leaf_blade("leaf" if i % 2 else "leaf_light", size, size * 0.85, 0.8, 5, rows=3)
                .rotate("z", -25 + random.normal() * 20)
                .rotate("y", float(random.uniform(-80, 80)))
                .move(*path[i])
            )
        mesh.add(strand.rotate("y", k * 360 / strands + random.normal() * 8))
    return mesh


def cushion(material: str, size: float, seed: int, thickness: float = 0.10) -> Mesh:
    """A square scatter cushion standing upright in the XY plane, centred: thin corners, full middle, a piped seam."""
    n = 15

    def half(sign: float) -> Mesh:
        def shape(u: Array, v: Array) -> Array:
            x, y = 2 * u - 1, 2 * v - 1
            pinch = 1 - 0.07 * (x * x * y * y) - 0.045 * ((1 - x * x) * y * y + (1 - y * y) * x * x)
            full = np.clip((1 - x**2) * (1 - y**2), 0, 1) ** 0.42
            folds = 0.05 * np.sin(6 * x + seed) * np.sin(5 * y + 2 * seed) * full
            return np.stack([x * size / 2 * pinch, y * size / 2 * pinch, sign * thickness * (0.72 * full + folds)], 1)

        return surface(material, shape, n, n, (size, size), flip=sign < 0)

    mesh = union(half(1.0), half(-1.0))
    edge = []
    for k in range(48):
        t = k / 48 * 4
        s, f = int(t), t % 1 * 2 - 1
        x, y = [(f, -1.0), (1.0, f), (-f, 1.0), (-1.0, -f)][s]
        pinch = 1 - 0.07 * (x * x * y * y) - 0.045 * ((1 - x * x) * y * y + (1 - y * y) * x * x)
        edge.append((x * size / 2 * pinch, y * size / 2 * pinch, 0.0))
    return mesh.add(tube(material, edge, 0.0045, 6, closed=True))


def drape(
    material: str, width: float, length: float, path: Sequence[Sequence[float]], seed: int, ripple: float = 0.012
) -> Mesh:
    """A cloth of a width in z laid along a path in the XY plane, with soft ripples; both sides have faces."""
    points = np.array(path, dtype=float)
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    along /= along[-1]

    def shape(u: Array, v: Array) -> Array:
        x, y = np.interp(u, along, points[:, 0]), np.interp(u, along, points[:, 1])
        dx, dy = (
            np.interp(np.clip(u + 0.01, 0, 1), along, points[:, 0])
            - np.interp(np.clip(u - 0.01, 0, 1), along, points[:, 0]),
            np.interp(np.clip(u + 0.01, 0, 1), along, points[:, 1])
            - np.interp(np.clip(u - 0.01, 0, 1), along, points[:, 1]),
        )
        n = normalize(np.stack([-dy, dx], 1))
        wave = ripple * (0.6 + 0.4 * np.sin(9 * v + seed + 2 * u)) * (1 + np.sin(14 * v + 5 * u + seed)) * 0.5
        return np.stack(
            [x + n[:, 0] * wave, y + n[:, 1] * wave, (0.5 - v) * width * (1 + 0.03 * np.sin(7 * u + seed))], 1
        )

    return surface(material, shape, 22, 40, (length, width), flip=True)


def bowl(material: str, radius: float, height: float, thickness: float = 0.006) -> Mesh:
    steps = np.linspace(0, 1, 9)
    outer = [(radius * (0.38 + 0.62 * math.sin(t * math.pi / 2) ** 0.9), height * (t**1.5)) for t in steps]
    inner = [(max(r - thickness, 0), y + thickness * 0.5) for r, y in outer[::-1]]
    return lathe(material, [(0, 0), *outer, *inner[0:], (0, thickness + 0.002)], 30, 50)


def vase(material: str, radius: float, height: float) -> Mesh:
    r, h = radius, height
    profile = [
        (0, 0),
        (r * 0.55, 0),
        (r * 0.62, h * 0.02),
        (r * 0.86, h * 0.2),
        (r, h * 0.4),
        (r * 0.88, h * 0.62),
        (r * 0.5, h * 0.82),
        (r * 0.40, h * 0.90),
        (r * 0.46, h * 0.98),
        (r * 0.47, h),
        (r * 0.41, h),
        (r * 0.35, h * 0.9),
        (r * 0.44, h * 0.8),
        (0, h * 0.75),
    ]
    return lathe(material, profile, 30, 70)


def bottle(glass: str, height: float, radius: float, label: str | None = "label", cap: str = "painted_black") -> Mesh:
    r, h = radius, height
    mesh = lathe(
        glass,
        [
            (0, 0),
            (r * 0.92, 0),
            (r, h * 0.02),
            (r, h * 0.58),
            (r * 0.85, h * 0.68),
            (r * 0.42, h * 0.78),
            (r * 0.36, h * 0.95),
            (r * 0.42, h * 0.955),
            (r * 0.42, h * 0.97),
            (0, h * 0.97),
        ],
        22,
        50,
    )
    mesh.add(cylinder(cap, r * 0.40, h * 0.09, 16, 0.002).move(0, h * 0.91, 0))
    if label:
        mesh.add(lathe(label, [(r * 1.012, h * 0.16), (r * 1.012, h * 0.46)], 22))
    return mesh


def mug(material: str) -> Mesh:
    mesh = lathe(
        material,
        [(0, 0), (0.034, 0), (0.040, 0.004), (0.041, 0.09), (0.040, 0.092), (0.037, 0.09), (0.036, 0.008), (0, 0.006)],
        24,
        45,
    )
    return mesh.add(
        tube(
            material,
            curve((0.040, 0.075, 0), (0.066, 0.070, 0), (0.068, 0.04, 0), (0.040, 0.022, 0), steps=6),
            0.0052,
            8,
            caps=False,
        )
    )


def plate(material: str, radius: float) -> Mesh:
    r = radius
    return lathe(
        material,
        [
            (0, 0.002),
            (r * 0.55, 0.002),
            (r * 0.56, 0),
            (r * 0.62, 0),
            (r * 0.98, 0.018),
            (r, 0.021),
            (r * 0.97, 0.022),
            (r * 0.64, 0.007),
            (0, 0.006),
        ],
        34,
        50,
    )


def wine_glass() -> Mesh:
    profile = [
        (0, 0),
        (0.034, 0.0),
        (0.034, 0.002),
        (0.006, 0.008),
        (0.0038, 0.02),
        (0.0038, 0.085),
        (0.012, 0.095),
        (0.033, 0.125),
        (0.036, 0.15),
        (0.030, 0.20),
        (0.0288, 0.20),
        (0.0345, 0.15),
        (0.0315, 0.127),
        (0.0, 0.098),
    ]
    return lathe("clear_glass", profile, 24, 60)


def towel(material: str, width: float, drop: float, thickness: float = 0.03) -> Mesh:
    """A folded towel over a rail along X at the origin, hanging down on both sides, with two woven bands."""
    mesh = soft_box(material, (width, drop, thickness), thickness * 0.48, 0.003, 5, 3, 0.002, int(width * 100))
    mesh.move(0, -drop / 2 + 0.014, 0)
    return mesh.add(
        *(
            box(material, (width * 1.004, 0.012, thickness * 1.12), 0.004, 1).move(0, -drop + 0.08 + 0.02 * k, 0)
            for k in range(2)
        )
    )


def radiator(width: float, height: float) -> Mesh:
    """A column radiator, its back at z = 0, bottom at y = 0.1 on two feet."""
    mesh = Mesh()
    count = int(width / 0.05)
    for k in range(count):
        x = -width / 2 + (k + 0.5) * width / count
        for z in (0.045, 0.095):
            mesh.add(tube("white_lacquer", [(x, 0.13, z), (x, 0.10 + height - 0.03, z)], 0.0125, 7, caps=False))
        for y in (0.115, 0.10 + height - 0.018):
            mesh.add(box("white_lacquer", (width / count * 0.96, 0.034, 0.085), 0.004, 1).move(x, y, 0.07))
    for side in (-1, 1):
        mesh.add(box_at("white_lacquer", (0.03, 0.11, 0.05), side * width * 0.4, 0, 0.07, 0.004))
    valve = tube(
        "chrome", [(width / 2, 0.115, 0.07), (width / 2 + 0.05, 0.115, 0.07), (width / 2 + 0.05, 0.0, 0.07)], 0.008, 10
    )
    return mesh.add(
        valve, cylinder("plastic_white", 0.019, 0.06, 16, 0.004).rotate("z", -90).move(width / 2 + 0.05, 0.115, 0.07)
    )
