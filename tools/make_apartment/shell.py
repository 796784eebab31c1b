# SPDX-License-Identifier: MIT
"""Walls with openings, floors, ceilings, skirting boards, doors and windows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from furniture_common import box_at, panel_front
from geometry import Mesh, Part, box, curve, lathe, sweep, tube, union

CEILING = 2.70


@dataclass(frozen=True)
class Opening:
    """A rectangle cut out of a wall: from start to end along the wall, from bottom to top above the floor."""

    start: float
    end: float
    bottom: float
    top: float


def wall(
    length: float, thickness: float, openings: Sequence[Opening], front: str, back: str, offset: float = 0.0
) -> Mesh:
    """A wall along X from 0 to length, its front (+Z) and back painted differently, with white reveals in the openings.

    Textures continue along a row of walls through `offset`, the place of the wall's start in metres.
    """
    xs = sorted({0.0, length, *(o.start for o in openings), *(o.end for o in openings)})
    ys = sorted({0.0, CEILING, *(o.bottom for o in openings), *(o.top for o in openings)})
    mesh = Mesh()
    for sign, material in ((1.0, front), (-1.0, back)):
        z = sign * thickness / 2
        positions: list[tuple[float, float, float]] = []
        triangles: list[tuple[int, int, int]] = []
        for x0, x1 in zip(xs, xs[1:], strict=False):
            for y0, y1 in zip(ys, ys[1:], strict=False):
                x, y = (x0 + x1) / 2, (y0 + y1) / 2
                if any(o.start < x < o.end and o.bottom < y < o.top for o in openings):
                    continue
                base = len(positions)
                positions += [(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)]
                triangles += (
                    [(base, base + 1, base + 2), (base, base + 2, base + 3)]
                    if sign > 0
                    else [(base, base + 2, base + 1), (base, base + 3, base + 2)]
                )
        p = np.array(positions)
        uv = np.stack([p[:, 0] + offset, -p[:, 1]], 1)
        mesh.add(Mesh([Part(material, p, np.tile([0.0, 0.0, sign], (len(p), 1)), uv, np.array(triangles))]))
    t = thickness

    def rectangle(corners: Sequence[Sequence[float]], normal: Sequence[float]) -> None:
        p = np.array(corners, dtype=float)
        order = np.array([[0, 1, 2], [0, 2, 3]])
        if float(np.cross(p[1] - p[0], p[2] - p[0]) @ np.array(normal)) < 0:
            order = order[:, ::-1]
        uv = p[:, [2, 1]] if abs(normal[0]) > 0.5 else p[:, [0, 2]]
        mesh.add(Mesh([Part("paint_white", p, np.tile(np.array(normal, dtype=float), (4, 1)), uv.copy(), order)]))

    h = t / 2
    for x, n in ((0.0, -1.0), (length, 1.0)):
        rectangle([(x, 0, -h), (x, 0, h), (x, CEILING, h), (x, CEILING, -h)], (n, 0, 0))
    rectangle([(0, CEILING, -h), (length, CEILING, -h), (length, CEILING, h), (0, CEILING, h)], (0, 1, 0))
    for o in openings:
        rectangle(
            [(o.start, o.bottom, -h), (o.start, o.bottom, h), (o.start, o.top, h), (o.start, o.top, -h)], (1, 0, 0)
        )
        rectangle([(o.end, o.bottom, -h), (o.end, o.bottom, h), (o.end, o.top, h), (o.end, o.top, -h)], (-1, 0, 0))
        rectangle([(o.start, o.top, -h), (o.end, o.top, -h), (o.end, o.top, h), (o.start, o.top, h)], (0, -1, 0))
        if o.bottom > 0:
            rectangle(
                [(o.start, o.bottom, -h), (o.end, o.bottom, -h), (o.end, o.bottom, h), (o.start, o.bottom, h)],
                (0, 1, 0),
            )
    return mesh


def floor(material: str, x0: float, x1: float, z0: float, z1: float, thickness: float = 0.02) -> Mesh:
    """A floor whose top is at y = 0, boards along X, in coordinates of the apartment."""
    return _slab(material, x0, x1, z0, z1, -thickness, 0.0)


def _slab(material: str, x0: float, x1: float, z0: float, z1: float, y0: float, y1: float) -> Mesh:
    return (
        box(material, (x1 - x0, y1 - y0, z1 - z0), 0.0, grain_shift=False)
        .move((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2)
        .map_uv(lambda uv: uv + np.array([(x0 + x1) / 2, (z0 + z1) / 2]))
    )


def ceiling(material: str, x0: float, x1: float, z0: float, z1: float) -> Mesh:
    return _slab(material, x0, x1, z0, z1, CEILING, CEILING + 0.02)


def slab(material: str, x0: float, x1: float, z0: float, z1: float, y0: float, y1: float) -> Mesh:
    return _slab(material, x0, x1, z0, z1, y0, y1)


SKIRTING = [(0.0, 0.0), (0.0, 0.105), (0.004, 0.105), (0.010, 0.095), (0.0135, 0.080), (0.016, 0.072), (0.016, 0.0)]
COVING = [
    (0.0, CEILING),
    (0.0, CEILING - 0.075),
    (0.012, CEILING - 0.070),
    (0.022, CEILING - 0.052),
    (0.040, CEILING - 0.030),
    (0.062, CEILING - 0.018),
    (0.072, CEILING - 0.008),
    (0.078, CEILING),
]


def trim(
    x0: float,
    x1: float,
    z0: float,
    z1: float,
    gaps: Mapping[str, Sequence[tuple[float, float]]],
    profile: Sequence[tuple[float, float]] = SKIRTING,
) -> Mesh:
    """Moulding along the four walls of a room; gaps are intervals of x (walls north, south) or z (west, east)."""
    mesh = Mesh()

    def pieces(a: float, b: float, cut: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
        result, start = [], a
        for g0, g1 in sorted(cut):
            if g0 > start:
                result.append((start, g0))
            start = max(start, g1)
        if start < b:
            result.append((start, b))
        return result

    for a, b in pieces(x0, x1, gaps.get("north", ())):
        mesh.add(sweep("white_lacquer", profile, b - a).move(a, 0, z0))
    for a, b in pieces(x0, x1, gaps.get("south", ())):
        mesh.add(sweep("white_lacquer", profile, b - a).rotate("y", 180).move(b, 0, z1))
    for a, b in pieces(z0, z1, gaps.get("west", ())):
        mesh.add(sweep("white_lacquer", profile, b - a).rotate("y", 90).move(x0, 0, b))
    for a, b in pieces(z0, z1, gaps.get("east", ())):
        mesh.add(sweep("white_lacquer", profile, b - a).rotate("y", -90).move(x1, 0, a))
    return mesh


def casing(width: float, height: float, wall_thickness: float, material: str = "white_lacquer") -> Mesh:
    """Lining and architraves of a doorway, centred in x, standing on the floor, in a wall centred at z = 0."""
    mesh = Mesh()
    t = wall_thickness + 0.004
    for side in (-1, 1):
        mesh.add(box_at(material, (0.024, height, t), side * (width / 2 - 0.012), 0, 0, 0.002))
    mesh.add(box_at(material, (width - 0.048, 0.024, t), 0, height - 0.024, 0, 0.002))
    for face in (-1, 1):
        z = face * (wall_thickness / 2 + 0.009)
        for side in (-1, 1):
            mesh.add(box_at(material, (0.075, height + 0.045, 0.018), side * (width / 2 + 0.018), 0, z, 0.005, 2))
        mesh.add(box_at(material, (width + 0.135, 0.075, 0.020), 0, height - 0.018, z, 0.005, 2))
    return mesh


def _lever(material: str, side: float) -> Mesh:
    """A door handle on the face side * Z, its rose at the origin, pointing to -X."""
    rose = lathe(material, [(0, 0), (0.026, 0), (0.026, 0.006), (0.022, 0.009), (0, 0.009)], 24, 50).rotate("x", 90)
    neck = tube(
        material,
        curve((0, 0, 0.006), (0, 0, 0.045), (-0.012, 0, 0.055), (-0.03, 0, 0.056), (-0.125, 0, 0.052), steps=4),
        0.0085,
        10,
    )
    both = union(rose, neck)
    return both if side > 0 else both.rotate("x", 180)


def door_leaf(
    width: float, height: float, material: str = "white_lacquer", metal: str = "brass", panels: bool = True
) -> Mesh:
    """A door whose hinge line is the Y axis; the leaf runs along +X, centred in z, and clears the floor by 8 mm."""
    w, h, t = width, height - 0.012, 0.040
    mesh = Mesh()
    if panels:
        lower, gap = 0.82, 0.0
        for y0, y1 in ((0.0, lower), (lower + gap, h)):
            for face in (0, 180):
                panel = panel_front(material, w, y1 - y0, 0.115, t / 2).rotate("y", face)
                mesh.add(panel.move(w / 2, 0.008 + (y0 + y1) / 2, 0))
    else:
        mesh.add(box_at(material, (w, h, t), w / 2, 0.008, 0, 0.004, 1, "y"))
    for side in (-1.0, 1.0):
        mesh.add(_lever(metal, side).move(w - 0.06, 1.02, side * t / 2))
    for y in (0.25, height - 0.25):
        mesh.add(tube(metal, [(0.0, y - 0.045, t / 2 + 0.004), (0.0, y + 0.045, t / 2 + 0.004)], 0.007, 10))
    return mesh


def window(
    width: float, height: float, columns: int, glass: str = "glass", bar: float | None = None, sill: bool = True
) -> Mesh:
    """A casement window centred in x and z with its lower edge at y = 0; inside is +Z. bar is the height of a
    transom."""
    f, d = 0.055, 0.070
    mesh = Mesh()
    material = "white_lacquer"
    for side in (-1, 1):
        mesh.add(box_at(material, (f, height, d), side * (width - f) / 2, 0, 0, 0.006, 2))
    for y in (0.0, height - f):
        mesh.add(box_at(material, (width - 2 * f, f, d), 0, y, 0, 0.006, 2))
    inner = width - 2 * f
    cell = inner / columns
    for k in range(columns):
        cx = -inner / 2 + (k + 0.5) * cell
        s, ds = 0.052, 0.056
        y0, y1 = f + 0.002, height - f - 0.002
        w = cell - 0.004
        for side in (-1, 1):
            mesh.add(box_at(material, (s, y1 - y0, ds), cx + side * (w - s) / 2, y0, 0.014, 0.006, 2))
        rails = [y0, y1 - s] + ([bar] if bar else [])
        for y in rails:
            mesh.add(box_at(material, (w - 2 * s, s, ds), cx, y, 0.014, 0.006, 2))
        mesh.add(box_at(glass, (w - 2 * s + 0.01, y1 - y0 - 2 * s + 0.01, 0.006), cx, y0 + s - 0.005, 0.012, 0.0))
        # The espagnolette sits on the stile that meets the next casement.
        hx = cx + (w / 2 - s / 2) * (-1 if k % 2 else 1)
        hy = min(height * 0.45, 1.05)
        mesh.add(box_at("chrome", (0.026, 0.075, 0.008), hx, hy - 0.037, 0.045, 0.003))
        mesh.add(
            tube(
                "chrome",
                curve((hx, hy, 0.045), (hx, hy, 0.078), (hx, hy - 0.02, 0.086), (hx, hy - 0.11, 0.084), steps=4),
                0.0075,
                8,
            )
        )
    if sill:
        mesh.add(box_at("marble", (width + 0.10, 0.028, 0.30), 0, -0.028, 0.185, 0.006, 2))
        mesh.add(box_at("stone", (width + 0.06, 0.04, 0.20), 0, -0.045, -0.12, 0.004))
    return mesh


def sliding_window(width: float, height: float) -> Mesh:
    """A floor-length glazed terrace door: two black-framed leaves on a rail, inside is +Z."""
    material, f = "painted_black", 0.045
    mesh = Mesh()
    for side in (-1, 1):
        mesh.add(box_at(material, (f, height, 0.14), side * (width - f) / 2, 0, 0, 0.003))
    mesh.add(
        box_at(material, (width - 2 * f, f, 0.14), 0, height - f, 0, 0.003),
        box_at("steel", (width, 0.022, 0.15), 0, 0, 0, 0.003),
    )
    leaf = width / 2
    for k, z in ((-1, -0.032), (1, 0.032)):
        cx = k * (leaf / 2 - f * 0.4)
        w, s = leaf, 0.062
        for side in (-1, 1):
            mesh.add(box_at(material, (s, height - f - 0.02, 0.045), cx + side * (w - s) / 2, 0.02, z, 0.004))
        for y in (0.02, height - f - s):
            mesh.add(box_at(material, (w - 2 * s, s, 0.045), cx, y, z, 0.004))
        mesh.add(box_at("glass", (w - 2 * s + 0.01, height - f - 2 * s, 0.010), cx, 0.02 + s - 0.005, z, 0.0))
    mesh.add(tube("chrome", [(0.09, 0.92, 0.085), (0.09, 1.18, 0.085)], 0.009, 10))
    for y in (0.94, 1.16):
        mesh.add(tube("chrome", [(0.09, y, 0.05), (0.09, y, 0.085)], 0.006, 8))
    return mesh
