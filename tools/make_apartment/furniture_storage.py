# SPDX-License-Identifier: MIT
"""Tables, shelves, cupboards. Fronts face +Z, everything stands on y = 0, backs are at z = -depth/2."""

from __future__ import annotations

import math

import numpy as np

from furniture_common import bar_handle, board, book_row, box_at, knob, panel_front, tapered_leg, turned_leg
from geometry import Mesh, box, cylinder, lathe, tube, union


def coffee_table() -> Mesh:
    """A marble slab on a walnut frame with a lower shelf, 0.80 x 1.20 m, 0.42 m high."""
    mesh = box_at("marble", (0.80, 0.028, 1.20), 0, 0.392, 0, 0.010, 3)
    for x in (-0.34, 0.34):
        for z in (-0.52, 0.52):
            mesh.add(
                tapered_leg(
                    "walnut", 0.392, 0.022, 0.014, (0.03 * math.copysign(1, x), 0.03 * math.copysign(1, z))
                ).move(x, 0, z)
            )
        mesh.add(board("walnut", (0.02, 0.05, 1.04), x, 0.338, 0))
    for z in (-0.52, 0.52):
        mesh.add(board("walnut", (0.68, 0.05, 0.02), 0, 0.338, z))
    for k in range(9):
        mesh.add(board("walnut", (0.05, 0.014, 1.06), -0.30 + 0.075 * k, 0.135, 0, 0.004))
    for z in (-0.48, 0.48):
        mesh.add(board("walnut", (0.72, 0.018, 0.03), 0, 0.117, z))
    return mesh


def round_table(radius: float, height: float, top: str = "oak", leg: str = "black_metal") -> Mesh:
    r, h = radius, height
    mesh = lathe(
        top,
        [
            (0, h - 0.022),
            (r - 0.012, h - 0.022),
            (r - 0.002, h - 0.016),
            (r, h - 0.011),
            (r - 0.003, h - 0.003),
            (r - 0.010, h),
            (0, h),
        ],
        44,
        50,
    )
    mesh.map_uv(lambda uv: uv)
    mesh.add(tube(leg, [(0, 0.01, 0), (0, h - 0.02, 0)], 0.014, 14))
    return mesh.add(
        lathe(leg, [(0, 0), (r * 0.62, 0), (r * 0.63, 0.006), (r * 0.58, 0.012), (0.02, 0.02), (0, 0.02)], 36, 40)
    )


def dining_table(length: float, width: float) -> Mesh:
    """Oak planks on turned legs, 0.75 m high, long side along Z."""
    mesh = Mesh()
    planks = 6
    for k in range(planks):
        w = width / planks
        mesh.add(
            board("oak", (w - 0.0015, 0.032, length), -width / 2 + (k + 0.5) * w, 0.718, 0, 0.004).map_uv(
                lambda uv, k=k: uv + np.array([k * 0.37, k * 0.21])  # type: ignore[misc]
            )
        )
    for x in (-width / 2 + 0.075, width / 2 - 0.075):
        for z in (-length / 2 + 0.085, length / 2 - 0.085):
            mesh.add(turned_leg("oak", 0.718, 0.047).move(x, 0, z))
        mesh.add(board("oak", (0.022, 0.085, length - 0.24), x, 0.633, 0))
    for z in (-length / 2 + 0.085, length / 2 - 0.085):
        mesh.add(board("oak", (width - 0.22, 0.085, 0.022), 0, 0.633, z))
    return mesh


def bookcase(
    width: float, height: float, depth: float, shelves: int, wood: str, seed: int, fill: float = 0.8, columns: int = 1
) -> tuple[Mesh, Mesh]:
    """A bookcase and its books as two meshes in the same frame."""
    t = 0.022
    case, books = Mesh(), Mesh()
    random = np.random.default_rng(seed)
    for k in range(columns + 1):
        case.add(board(wood, (t, height, depth), -width / 2 + t / 2 + k * (width - t) / columns, 0, 0))
    cell = (width - t) / columns
    case.add(box_at(wood, (width - 2 * t, height - 0.07, 0.008), 0, 0.07, -depth / 2 + 0.006, 0.0, 1, "y"))
    case.add(board(wood, (width - 2 * t, 0.06, 0.018), 0, 0.0, depth / 2 - 0.03))
    ys = np.linspace(0.06, height - t, shelves + 1)
    for c in range(columns):
        cx = -width / 2 + t + c * cell + (cell - t) / 2
        for y in ys:
            case.add(board(wood, (cell - t, t, depth - 0.012), cx, float(y), 0.004))
        for k, y in enumerate(ys[:-1]):
            space = float(ys[k + 1] - y) - t
            if random.uniform() > fill:
                continue
            length = (cell - t) * float(random.uniform(0.45, 0.95))
            row = book_row(
                length, seed * 31 + c * 7 + k, (space * 0.62, min(space * 0.93, 0.30)), min(depth - 0.05, 0.19)
            )
            lo, hi = row.bounds()
            span = float(hi[0] - lo[0])
            right = random.uniform() < 0.35
            x = (
                cx + (cell - t) / 2 - span - 0.004 - float(lo[0])
                if right
                else cx - (cell - t) / 2 + 0.003 - float(lo[0])
            )
            if span < cell - t - 0.006:
                books.add(row.move(x, float(y) + t, depth / 2 - 0.045))
    return case, books


def sideboard(width: float, wood: str, front: str, doors: int) -> Mesh:
    """A low cupboard on splayed legs, 0.72 m high, 0.42 m deep."""
    h, d, leg, t = 0.72, 0.42, 0.17, 0.022
    mesh = Mesh()
    for x in (-width / 2 + 0.12, width / 2 - 0.12):
        for z in (-0.13, 0.13):
            mesh.add(
                tapered_leg(wood, leg, 0.021, 0.012, (0.045 * math.copysign(1, x), 0.03 * math.copysign(1, z))).move(
                    x, 0, z
                )
            )
    mesh.add(board(wood, (width, t, d), 0, h - t, 0, 0.004), board(wood, (width - 2 * t, t, d), 0, leg, 0))
    for x in (-(width - t) / 2, (width - t) / 2):
        mesh.add(board(wood, (t, h - leg - t, d), x, leg, 0))
    mesh.add(box_at(wood, (width - 2 * t, h - leg - 2 * t, 0.01), 0, leg + t, -d / 2 + 0.01, 0.0))
    inner = width - 2 * t
    for k in range(doors):
        w = inner / doors
        x = -inner / 2 + (k + 0.5) * w
        face = h - leg - 2 * t
        if k == doors - 1:
            for row in range(3):
                fh = face / 3
                mesh.add(
                    box_at(front, (w - 0.004, fh - 0.004, 0.02), x, leg + t + row * fh + 0.002, d / 2 - 0.010, 0.003)
                )
                mesh.add(knob("brass").move(x, leg + t + (row + 0.5) * fh, d / 2))
        else:
            mesh.add(box_at(front, (w - 0.004, face - 0.004, 0.02), x, leg + t + 0.002, d / 2 - 0.010, 0.003, 1, "y"))
            slats = int((w - 0.06) / 0.022)
            for s in range(slats):
                mesh.add(
                    box_at(
                        front,
                        (0.012, face - 0.05, 0.008),
                        x - (slats - 1) * 0.011 + s * 0.022,
                        leg + t + 0.025,
                        d / 2 + 0.003,
                        0.003,
                        1,
                        "y",
                    )
                )
            mesh.add(knob("brass").move(x + (w / 2 - 0.035) * (1 if k % 2 == 0 else -1), leg + t + face * 0.55, d / 2))
    return mesh


def chest(
    width: float,
    height: float,
    depth: float,
    rows: int,
    columns: int,
    body: str,
    metal: str = "brass",
    leg: float = 0.10,
) -> Mesh:
    """A chest of drawers or a nightstand."""
    t = 0.02
    mesh = Mesh()
    for x in (-width / 2 + 0.05, width / 2 - 0.05):
        for z in (-depth / 2 + 0.05, depth / 2 - 0.05):
            mesh.add(tapered_leg("oak", leg, 0.020, 0.013).move(x, 0, z))
    mesh.add(
        box_at(body, (width, t, depth), 0, height - t, 0, 0.004, 2),
        box_at(body, (width, t, depth - 0.01), 0, leg, -0.005),
    )
    for x in (-(width - t) / 2, (width - t) / 2):
        mesh.add(box_at(body, (t, height - leg - t, depth - 0.01), x, leg, -0.005, 0.003, 1, "y"))
    mesh.add(box_at(body, (width - 2 * t, height - leg - 2 * t, 0.01), 0, leg + t, -depth / 2 + 0.02, 0.0))
    fh, fw = (height - leg - 2 * t) / rows, (width - 2 * t) / columns
    for r in range(rows):
        for c in range(columns):
            x, y = -width / 2 + t + (c + 0.5) * fw, leg + t + r * fh
            mesh.add(box_at(body, (fw - 0.005, fh - 0.005, 0.022), x, y + 0.0025, depth / 2 - 0.014, 0.004, 2))
            for k in (-1, 1) if fw > 0.45 else (0,):
                mesh.add(knob(metal).move(x + k * fw * 0.28, y + fh / 2, depth / 2 - 0.003))
    return mesh


def wardrobe(width: float, height: float, depth: float, doors: int, body: str = "white_lacquer") -> Mesh:
    t = 0.022
    mesh = box_at(body, (width, 0.09, depth - 0.05), 0, 0, -0.025, 0.002)
    mesh.add(box_at(body, (width, t, depth), 0, height - t, 0), box_at(body, (width, t, depth - 0.02), 0, 0.09, -0.01))
    for x in (-(width - t) / 2, (width - t) / 2):
        mesh.add(box_at(body, (t, height - 0.09 - t, depth - 0.02), x, 0.09, -0.01))
    mesh.add(box_at(body, (width - 2 * t, height - 0.15, 0.01), 0, 0.11, -depth / 2 + 0.01, 0.0))
    w = width / doors
    for k in range(doors):
        x = -width / 2 + (k + 0.5) * w
        mesh.add(
            panel_front(body, w - 0.005, height - 0.09 - t - 0.006, 0.075, 0.022).move(
                x, 0.09 + (height - 0.09 - t) / 2, depth / 2 - 0.020
            )
        )
        mesh.add(
            bar_handle("brass", 0.20, True).move(
                x + (w / 2 - 0.045) * (1 if k % 2 == 0 else -1), height * 0.47, depth / 2 + 0.002
            )
        )
    cornice = union(
        box_at(body, (width + 0.03, 0.03, depth + 0.03), 0, height, 0, 0.008, 2),
        box_at(body, (width + 0.05, 0.025, depth + 0.05), 0, height + 0.028, 0, 0.008, 2),
    )
    return mesh.add(cornice)


def console_table(width: float) -> Mesh:
    """A narrow hall table with two drawers, 0.80 m high, 0.32 m deep."""
    mesh = board("walnut", (width, 0.024, 0.32), 0, 0.776, 0, 0.006)
    for x in (-width / 2 + 0.04, width / 2 - 0.04):
        for z in (-0.12, 0.12):
            mesh.add(tapered_leg("walnut", 0.776, 0.022, 0.013).move(x, 0, z))
    mesh.add(board("walnut", (width - 0.10, 0.11, 0.018), 0, 0.666, -0.13))
    for x in (-width / 2 + 0.04, width / 2 - 0.04):
        mesh.add(board("walnut", (0.018, 0.11, 0.24), x, 0.666, 0))
    for k in (-1, 1):
        mesh.add(box_at("walnut", (width / 2 - 0.06, 0.10, 0.27), k * width / 4, 0.67, 0.005, 0.004))
        mesh.add(knob("brass", 0.012).move(k * width / 4, 0.72, 0.14))
    return mesh.add(board("walnut", (width - 0.10, 0.016, 0.24), 0, 0.16, 0))


def wall_shelf(width: float, wood: str = "oak") -> Mesh:
    """A board on two brass brackets, its back at z = 0, top at y = 0."""
    mesh = board(wood, (width, 0.028, 0.22), 0, -0.028, 0.11, 0.004)
    for x in (-width * 0.36, width * 0.36):
        mesh.add(
            box_at("brass", (0.022, 0.16, 0.005), x, -0.188, 0.003, 0.001),
            box_at("brass", (0.022, 0.005, 0.18), x, -0.034, 0.09, 0.001),
        )
        mesh.add(tube("brass", [(x, -0.165, 0.006), (x, -0.036, 0.16)], 0.005, 8))
    return mesh


def round_mirror(radius: float) -> Mesh:
    """A wall mirror with a brass ring, facing +Z, its back at z = 0."""
    disc = lathe("mirror", [(radius * 0.985, 0.014), (0, 0.014)], 56, 40)
    ring = lathe(
        "brass",
        [
            (radius, 0),
            (radius + 0.012, 0.002),
            (radius + 0.014, 0.018),
            (radius + 0.006, 0.024),
            (radius - 0.010, 0.022),
            (radius - 0.012, 0.014),
        ],
        56,
        50,
    )
    return union(disc, ring).rotate("x", 90)


def framed_mirror(width: float, height: float, frame: str) -> Mesh:
    mesh = box("mirror", (width - 0.05, height - 0.05, 0.006), 0.0).move(0, 0, 0.014)
    for x in (-(width - 0.04) / 2, (width - 0.04) / 2):
        mesh.add(box(frame, (0.04, height, 0.03), 0.005, 2, "y").move(x, 0, 0.015))
    for y in (-(height - 0.04) / 2, (height - 0.04) / 2):
        mesh.add(box(frame, (width - 0.08, 0.04, 0.03), 0.005, 2, "x").move(0, y, 0.015))
    return mesh


def basket(radius: float, height: float) -> Mesh:
    """A woven basket with a rim and two handles."""
    r, h = radius, height
    mesh = lathe(
        "wicker",
        [
            (0, 0.0),
            (r * 0.84, 0),
            (r * 0.88, 0.01),
            (r * 0.98, h * 0.5),
            (r, h),
            (r * 0.95, h),
            (r * 0.93, h * 0.5),
            (r * 0.82, 0.02),
            (0, 0.02),
        ],
        36,
        50,
    )
    ring = [
        (r * 0.975 * math.cos(a), h, r * 0.975 * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 36, endpoint=False)
    ]
    mesh.add(tube("wicker", ring, 0.014, 8, closed=True))
    for side in (-1, 1):
        arc = [
            (side * r * (0.98 + 0.02 * math.sin(a)), h * 0.98 + 0.07 * math.sin(a), 0.075 * math.cos(a))
            for a in np.linspace(0, math.pi, 12)
        ]
        mesh.add(tube("wicker", arc, 0.009, 8))
    return mesh


def coat_rack(width: float) -> Mesh:
    """A board with brass hooks, its back at z = 0, centred."""
    mesh = board("oak", (width, 0.11, 0.022), 0, -0.055, 0.011, 0.005)
    count = int(width / 0.17)
    for k in range(count):
        x = -width / 2 + (k + 0.5) * width / count
        mesh.add(cylinder("brass", 0.016, 0.006, 16, 0.002).rotate("x", 90).move(x, 0.0, 0.022))
        hook = [(x, 0.0, 0.024), (x, -0.005, 0.055), (x, -0.03, 0.068), (x, -0.055, 0.062), (x, -0.062, 0.045)]
        mesh.add(tube("brass", hook, 0.0055, 8), tube("brass", [(x, 0.0, 0.03), (x, 0.035, 0.06)], 0.0055, 8))
    return mesh
