# SPDX-License-Identifier: MIT
"""Sofas, chairs, stools and beds. Fronts face +Z, everything stands on y = 0."""

from __future__ import annotations

import math

import numpy as np

from furniture_common import board, box_at, drape, tapered_leg
from geometry import Array, Mesh, curve, cylinder, lathe, soft_box, surface, tube, union, waves


def sofa(width: float, fabric: str, seats: int, depth: float = 0.95) -> Mesh:
    """A sofa with loose seat and back cushions on walnut legs."""
    arm, seat_height, back = 0.17, 0.26, 0.20
    mesh = Mesh()
    for x in (-width / 2 + 0.09, width / 2 - 0.09):
        for z in (-depth / 2 + 0.09, depth / 2 - 0.09):
            mesh.add(
                tapered_leg(
                    "walnut", 0.13, 0.026, 0.015, (0.02 * math.copysign(1, x), 0.02 * math.copysign(1, z))
                ).move(x, 0, z)
            )
    mesh.add(soft_box(fabric, (width - 0.02, 0.15, depth - 0.02), 0.03, 0.004, 6, 2).move(0, 0.20, 0))
    for side in (-1, 1):
        mesh.add(
            soft_box(fabric, (arm, 0.50, depth), 0.065, 0.012, 6, 3, 0.003, 3 + side).move(
                side * (width - arm) / 2, 0.13 + 0.25, 0
            )
        )
    mesh.add(
        soft_box(fabric, (width - 2 * arm, 0.58, back), 0.07, 0.012, 6, 3, 0.003, 9).move(
            0, 0.13 + 0.29, -(depth - back) / 2
        )
    )
    inner = width - 2 * arm - 0.01
    for k in range(seats):
        w = inner / seats
        x = -inner / 2 + (k + 0.5) * w
        d = depth - back - 0.01
        mesh.add(
            soft_box(fabric, (w - 0.008, 0.17, d + 0.03), 0.055, 0.028, 8, 3, 0.0045, 20 + k).move(
                x, seat_height + 0.095, back / 2 + 0.015
            )
        )
        cushion = soft_box(fabric, (w - 0.012, 0.46, 0.17), 0.07, 0.040, 8, 3, 0.006, 30 + k)
        mesh.add(cushion.rotate("x", -12).move(x, seat_height + 0.395, -depth / 2 + back + 0.075))
    return mesh


def armchair(fabric: str) -> Mesh:
    """A lounge chair: an upholstered shell on splayed wooden legs."""
    mesh = Mesh()
    for x in (-0.26, 0.26):
        for z in (-0.25, 0.27):
            mesh.add(
                tapered_leg("oak", 0.25, 0.021, 0.012, (0.07 * math.copysign(1, x), 0.06 * math.copysign(1, z))).move(
                    x, 0, z
                )
            )
    mesh.add(box_at("oak", (0.60, 0.035, 0.62), 0, 0.24, 0.01, 0.008, 2))

    def shell(u: Array, v: Array) -> Array:
        a = math.radians(-112) + u * math.radians(224)
        height = 0.36 + 0.17 * np.cos(a * 0.78) ** 2
        flare = 1 + 0.16 * v
        return np.stack([0.345 * flare * np.sin(a), 0.29 + height * v, 0.02 - 0.36 * flare * np.cos(a)], 1)

    # The shell is a thick surface: outside, inside and a rolled edge along its border.
    outer = surface(fabric, shell, 9, 30, (1.4, 0.5), flip=True)

    def inside(u: Array, v: Array) -> Array:
        p = shell(u, v)
        centre = np.array([0.0, 0.0, 0.02])
        radial = p - centre
        radial[:, 1] = 0
        length = np.linalg.norm(radial, axis=1, keepdims=True)
        bulge = 0.055 + 0.025 * np.sin(math.pi * np.clip(v, 0, 1))[:, None]
        return np.asarray(p - radial / length * bulge)

    inner = surface(fabric, inside, 9, 30, (1.4, 0.5))
    edge = []
    for u in np.linspace(0, 1, 30):
        a, b = shell(np.array([u]), np.array([1.0]))[0], inside(np.array([u]), np.array([1.0]))[0]
        edge.append((a + b) / 2)
    rim = [tuple(p) for p in edge]
    low = []
    for u, order in ((0.0, -1), (1.0, 1)):
        side = [
            tuple((shell(np.array([u]), np.array([v]))[0] + inside(np.array([u]), np.array([v]))[0]) / 2)
            for v in np.linspace(0, 1, 8)
        ]
        low.append(side if order < 0 else side[::-1])
    mesh.add(outer, inner, tube(fabric, [*low[0], *rim[1:-1], *low[1]], 0.030, 10))
    seat = soft_box(fabric, (0.57, 0.16, 0.60), 0.06, 0.03, 9, 4, 0.004, 5)
    return mesh.add(seat.move(0, 0.35, 0.055))


def dining_chair(wood: str = "oak", seat: str = "linen_sand") -> Mesh:
    """A wooden chair with a curved back rail, spindles and an upholstered seat."""
    mesh = Mesh()
    w, d, h = 0.40, 0.40, 0.45
    for x in (-w / 2, w / 2):
        mesh.add(
            tapered_leg(wood, h - 0.03, 0.017, 0.011, (0.025 * math.copysign(1, x), 0.035)).move(x, 0, d / 2 - 0.02)
        )
        back = curve(
            (x * 1.10, 0.0, -d / 2 - 0.045),
            (x, h - 0.02, -d / 2 + 0.01),
            (x * 0.98, 0.62, -d / 2 - 0.015),
            (x * 0.94, 0.82, -d / 2 - 0.075),
            steps=5,
        )
        mesh.add(tube(wood, back, list(np.linspace(0.012, 0.0145, len(back))), 12))
        mesh.add(tube(wood, [(x * 1.05, 0.20, d / 2), (x * 1.05, 0.20, -d / 2 - 0.02)], 0.008, 8))
    for z in (d / 2 - 0.02, -d / 2 + 0.01):
        mesh.add(box_at(wood, (w, 0.05, 0.018), 0, h - 0.075, z, 0.003))
    for x in (-w / 2, w / 2):
        mesh.add(box_at(wood, (0.018, 0.05, d - 0.03), x, h - 0.075, -0.005, 0.003, 1, "z"))
    mesh.add(soft_box(seat, (w + 0.045, 0.055, d + 0.03), 0.024, 0.016, 8, 3).move(0, h - 0.003, 0.0))

    def rail(u: Array, v: Array) -> Array:
        x = (u - 0.5) * (w + 0.03)
        bow = -0.055 * (1 - (2 * u - 1) ** 2)
        a = v * 2 * math.pi
        return np.stack(
            [
                x,
                0.79 + 0.058 * np.sin(a) * (0.9 + 0.1 * np.cos(math.pi * (u - 0.5))),
                -d / 2 - 0.072 + bow + 0.011 * np.cos(a),
            ],
            1,
        )

    mesh.add(surface(wood, rail, 17, 15, (w, 0.2), flip=True))
    for k in range(5):
        t = (k + 1) / 6
        x = (t - 0.5) * w
        bow = -0.055 * (1 - (2 * t - 1) ** 2)
        mesh.add(
            tube(
                wood,
                [(x, h - 0.02, -d / 2 + 0.01), (x, 0.60, -d / 2 - 0.03 + bow * 0.6), (x, 0.745, -d / 2 - 0.066 + bow)],
                0.006,
                8,
            )
        )
    return mesh


def office_chair() -> Mesh:
    """A swivel chair: five-star base with castors, gas spring, seat, mesh back, arm rests."""
    mesh = Mesh()
    for k in range(5):
        a = 2 * math.pi * k / 5 + 0.3
        c, s = math.cos(a), math.sin(a)
        mesh.add(tube("plastic_black", [(0.02 * c, 0.105, 0.02 * s), (0.30 * c, 0.075, 0.30 * s)], [0.026, 0.015], 10))
        for side in (-1, 1):
            wheel = cylinder("rubber", 0.030, 0.016, 16, 0.004).rotate("x", 90).move(0, 0.030, side * 0.016 - 0.008)
            mesh.add(wheel.rotate("y", -math.degrees(a) + 90).move(0.305 * c, 0, 0.305 * s))
        mesh.add(tube("steel", [(0.30 * c, 0.03, 0.30 * s), (0.30 * c, 0.078, 0.30 * s)], 0.007, 8))
    mesh.add(
        cylinder("plastic_black", 0.034, 0.16, 18, 0.006).move(0, 0.09, 0),
        cylinder("chrome", 0.018, 0.20, 16).move(0, 0.23, 0),
    )
    mesh.add(box_at("plastic_black", (0.22, 0.04, 0.26), 0, 0.405, 0, 0.012, 2))
    mesh.add(soft_box("linen_black", (0.50, 0.085, 0.49), 0.04, 0.018, 9, 4).move(0, 0.485, 0.02))

    def back(u: Array, v: Array) -> Array:
        x = (u - 0.5) * (0.46 - 0.10 * v**2)
        return np.stack(
            [
                x,
                0.60 + 0.52 * v,
                -0.235
                - 0.05 * np.sin(math.pi * v) * 0
                - 0.06 * v
                + 0.03 * np.sin(2.4 * v * math.pi)
                + 0.22 * x * x * 2,
            ],
            1,
        )

    net = surface("linen_black", back, 12, 12, (0.46, 0.52))
    border = [
        back(np.array([u]), np.array([v]))[0]
        for u, v in [
            *((k / 8, 0) for k in range(8)),
            *((1, k / 8) for k in range(8)),
            *((1 - k / 8, 1) for k in range(8)),
            *((0, 1 - k / 8) for k in range(8)),
        ]
    ]
    mesh.add(
        net,
        net.copy().scale(1, 1, 1).move(0, 0, -0.006),
        tube("plastic_black", [tuple(p) for p in border], 0.013, 8, closed=True),
    )
    mesh.add(
        tube(
            "plastic_black",
            curve((0, 0.42, -0.10), (0, 0.42, -0.27), (0, 0.58, -0.30), (0, 0.84, -0.275), steps=6),
            0.022,
            12,
        )
    )
    for side in (-1, 1):
        mesh.add(
            tube(
                "plastic_black",
                curve(
                    (side * 0.20, 0.43, 0.02),
                    (side * 0.30, 0.45, 0.02),
                    (side * 0.305, 0.56, 0.01),
                    (side * 0.30, 0.655, 0.0),
                    steps=5,
                ),
                0.014,
                10,
            )
        )
        mesh.add(soft_box("rubber", (0.075, 0.03, 0.25), 0.013, 0.003, 3, 3).move(side * 0.30, 0.668, 0.01))
    return mesh


def pouf(fabric: str) -> Mesh:
    steps = np.linspace(-math.pi / 2, math.pi / 2, 15)
    profile = [
        (max(0.0, 0.27 * abs(math.cos(a)) ** 0.55), 0.20 + 0.20 * math.copysign(abs(math.sin(a)) ** 0.75, math.sin(a)))
        for a in steps
    ]
    profile[0], profile[-1] = (0, profile[0][1]), (0, profile[-1][1])
    mesh = lathe(fabric, profile, 36, 180)
    return mesh.displace(lambda p, n: p + n * (0.006 * waves(p, 14, 4))[:, None])


def bench(length: float, fabric: str, wood: str = "oak") -> Mesh:
    mesh = Mesh()
    for x in (-length / 2 + 0.08, length / 2 - 0.08):
        for z in (-0.13, 0.13):
            mesh.add(
                tapered_leg(wood, 0.36, 0.019, 0.012, (0.03 * math.copysign(1, x), 0.02 * math.copysign(1, z))).move(
                    x, 0, z
                )
            )
    mesh.add(board(wood, (length - 0.02, 0.035, 0.36), 0, 0.355, 0, 0.006))
    return mesh.add(soft_box(fabric, (length, 0.085, 0.38), 0.036, 0.014, 10, 4, 0.003, 8).move(0, 0.43, 0))


def bed(width: float, length: float) -> Mesh:
    """An oak bed with an upholstered headboard and a mattress; the head is at -Z."""
    mesh = Mesh()
    w, d = width + 0.10, length + 0.10
    for x in (-w / 2 + 0.05, w / 2 - 0.05):
        for z in (-d / 2 + 0.05, d / 2 - 0.05):
            mesh.add(box_at("oak", (0.065, 0.22, 0.065), x, 0, z, 0.008, 2, "y"))
    for x in (-(w - 0.035) / 2, (w - 0.035) / 2):
        mesh.add(board("oak", (0.035, 0.17, d), x, 0.16, 0, 0.006))
    for z in (-(d - 0.035) / 2, (d - 0.035) / 2):
        mesh.add(board("oak", (w - 0.07, 0.17, 0.035), 0, 0.16, z, 0.006))
    mesh.add(box_at("oak", (w - 0.07, 0.03, d - 0.07), 0, 0.24, 0, 0.0))
    panels = 4
    for k in range(panels):
        pw = w / panels
        mesh.add(
            soft_box("boucle_grey", (pw - 0.004, 0.74, 0.09), 0.035, 0.022, 8, 3).move(
                -w / 2 + (k + 0.5) * pw, 0.30 + 0.37, -d / 2 - 0.02
            )
        )
    mesh.add(soft_box("linen_white", (width, 0.24, length), 0.06, 0.006, 8, 4).move(0, 0.27 + 0.12, 0.0))
    return mesh


def duvet(width: float, length: float, fabric: str, seed: int, rows: int = 52) -> Mesh:
    """A duvet over a mattress whose top is y = 0: it covers z from -length/2 on, hangs over both sides, and is thrown
    into folds."""
    overhang = 0.30
    top = width / 2 + 0.015

    def shape(u: Array, v: Array) -> Array:
        s = (u - 0.5) * (width + 2 * overhang)
        z = (v - 0.5) * length
        side = np.abs(s)
        over = np.clip(side - top, 0, None)
        # A quarter circle leads from the top over the edge down the side.
        r = 0.07
        bend = np.clip(over / r, 0, math.pi / 2)
        x = np.minimum(side, top) + r * np.sin(bend)
        y = -r * (1 - np.cos(bend)) - np.clip(over - r * math.pi / 2, 0, None)
        edge_fold = np.clip((over - 0.04) / 0.2, 0, 1)
        points = np.stack([s, np.zeros_like(s), z], 1)
        puff = 0.035 + 0.022 * waves(points, 5.5, seed, 2) + 0.010 * waves(points, 13, seed + 1, 2)
        ripple = 0.020 * np.sin(z * 17 + 2.2 * np.sin(z * 5 + seed)) * edge_fold
        foot = np.clip((v - 0.93) / 0.07, 0, 1)
        head = np.clip((0.06 - v) / 0.06, 0, 1)
        lift = puff * (1 - 0.55 * np.maximum(foot, head) ** 2) * (1 - 0.4 * edge_fold)
        return np.stack(
            [np.sign(s) * (x + (lift * 0.5 + ripple) * edge_fold), y + lift * (1 - edge_fold * 0.8) + 0.03, z], 1
        )

    mesh = surface(fabric, shape, rows, 72, (width + 0.6, length), flip=True)
    hem = union(
        *(tube(fabric, [tuple(p) for p in shape(np.linspace(0, 1, 60), np.full(60, v))], 0.016, 8) for v in (0.0, 1.0))
    )
    turned = union(
        *(tube(fabric, [tuple(p) for p in shape(np.full(40, u), np.linspace(0, 1, 40))], 0.010, 6) for u in (0.0, 1.0))
    )
    return union(mesh, hem, turned)


def pillow(fabric: str, width: float, depth: float, seed: int) -> Mesh:
    """A bed pillow lying flat, centred at the origin."""
    n = 17

    def half(sign: float) -> Mesh:
        def shape(u: Array, v: Array) -> Array:
            x, z = 2 * u - 1, 2 * v - 1
            full = np.clip((1 - x**2) * (1 - z**2), 0, 1) ** 0.40
            pinch = 1 - 0.035 * ((1 - x * x) * z * z + (1 - z * z) * x * x)
            points = np.stack([x, np.zeros_like(x), z], 1)
            height = sign * 0.078 * full * (1 + 0.14 * waves(points, 3.5, seed, 2)) * (1.0 if sign > 0 else 0.75)
            return np.stack([x * width / 2 * pinch, height, z * depth / 2 * pinch], 1)

        return surface(fabric, shape, n, n, (width, depth), flip=sign > 0)

    return union(half(1.0), half(-1.0))


def throw_blanket(seed: int) -> Mesh:
    """A striped blanket over a sofa arm along Z: the arm is 0.17 m thick, its top at y = 0."""
    path = curve(
        (0.10, -0.30, 0),
        (0.098, -0.08, 0),
        (0.075, 0.012, 0),
        (0.0, 0.018, 0),
        (-0.08, 0.010, 0),
        (-0.105, -0.06, 0),
        (-0.115, -0.34, 0),
        steps=7,
    )
    return drape("throw", 0.52, 0.9, path, seed, 0.012)
