# SPDX-License-Identifier: MIT
"""Kitchen units, appliances and things on worktops. Fronts face +Z, backs are at z = 0, everything stands on y = 0."""

from __future__ import annotations

import math

import numpy as np

from furniture_common import bar_handle, box_at, panel_front
from geometry import Mesh, box, curve, cylinder, lathe, quad, sphere, tube, union

BASE_HEIGHT = 0.87
WORKTOP = 0.91
DEPTH = 0.58


def base_unit(width: float, kind: str, front: str = "painted_sage") -> Mesh:
    """A base cabinet without worktop: kind is "doors", "drawers" or "oven"."""
    mesh = box_at("painted_black", (width, 0.10, DEPTH - 0.07), 0, 0, (DEPTH - 0.07) / 2, 0.0)
    mesh.add(box_at("white_lacquer", (width, BASE_HEIGHT - 0.10, DEPTH - 0.02), 0, 0.10, (DEPTH - 0.02) / 2, 0.001))
    face, z = BASE_HEIGHT - 0.10, DEPTH - 0.02
    if kind == "drawers":
        y = 0.10
        for share in (0.38, 0.36, 0.26):
            h = face * share
            mesh.add(panel_front(front, width - 0.005, h - 0.005, 0.05).move(0, y + h / 2, z))
            mesh.add(bar_handle("brass", min(0.22, width * 0.5)).move(0, y + h - 0.045, z + 0.017))
            y += h
    elif kind == "doors":
        count = 2 if width > 0.65 else 1
        for k in range(count):
            w = width / count
            x = -width / 2 + (k + 0.5) * w
            mesh.add(panel_front(front, w - 0.005, face - 0.005, 0.06).move(x, 0.10 + face / 2, z))
            side = 1 if k == 0 else -1
            mesh.add(bar_handle("brass", 0.16, True).move(x + side * (w / 2 - 0.04), 0.10 + face - 0.16, z + 0.017))
    else:
        mesh.add(panel_front(front, width - 0.005, 0.12, 0.03).move(0, 0.16, z))
        mesh.add(oven(width - 0.01, face - 0.13).move(0, 0.23, z))
    return mesh


def oven(width: float, height: float) -> Mesh:
    """The front of a built-in oven, bottom at y = 0, its face at z = 0."""
    mesh = box_at("steel", (width, height - 0.01, 0.02), 0, 0, 0.008, 0.004)
    mesh.add(box_at("screen_off", (width - 0.05, height - 0.20, 0.006), 0, 0.035, 0.019, 0.003))
    mesh.add(tube("chrome", [(-width * 0.42, height - 0.135, 0.055), (width * 0.42, height - 0.135, 0.055)], 0.009, 12))
    for x in (-width * 0.36, width * 0.36):
        mesh.add(tube("chrome", [(x, height - 0.135, 0.015), (x, height - 0.135, 0.055)], 0.006, 8))
    for x in (-0.22, -0.15, 0.15, 0.22):
        mesh.add(cylinder("plastic_black", 0.017, 0.024, 18, 0.003).rotate("x", 90).move(x, height - 0.06, 0.018))
    return mesh.add(
        box_at("screen_off", (0.14, 0.04, 0.004), 0, height - 0.08, 0.018, 0.002),
        box_at("power_led", (0.006, 0.006, 0.003), 0.045, height - 0.062, 0.021, 0.0),
    )


def wall_unit(width: float, height: float, front: str = "painted_sage", glass: bool = False) -> Mesh:
    """A wall cabinet, bottom at y = 0, 0.34 m deep."""
    d = 0.34
    mesh = box_at("white_lacquer", (width, height, d - 0.02), 0, 0, (d - 0.02) / 2, 0.001)
    count = 2 if width > 0.65 else 1
    for k in range(count):
        w = width / count
        x = -width / 2 + (k + 0.5) * w
        mesh.add(panel_front(front, w - 0.005, height - 0.005, 0.06).move(x, height / 2, d - 0.02))
        if glass:
            mesh.add(quad("frosted_glass", w - 0.12, height - 0.12).move(x, height / 2, d - 0.005))
        mesh.add(bar_handle("brass", 0.14, True).move(x + (1 if k == 0 else -1) * (w / 2 - 0.04), 0.13, d - 0.003))
    return mesh


def worktop(length: float, depth: float = 0.62) -> Mesh:
    return box_at("marble", (length, 0.04, depth), 0, BASE_HEIGHT, depth / 2, 0.006, 2)


def worktop_with_sink(length: float, sink_x: float, depth: float = 0.62) -> Mesh:
    """A worktop along X, centred, with a steel basin 0.54 x 0.40 m cut into it at sink_x."""
    w, d, z0 = 0.54, 0.40, 0.11
    mesh = Mesh()
    left, right = -length / 2, length / 2
    a, b = sink_x - w / 2, sink_x + w / 2
    for x0, x1 in ((left, a), (b, right)):
        mesh.add(box_at("marble", (x1 - x0, 0.04, depth), (x0 + x1) / 2, BASE_HEIGHT, depth / 2, 0.004, 2))
    mesh.add(box_at("marble", (w, 0.04, z0), sink_x, BASE_HEIGHT, z0 / 2, 0.003))
    mesh.add(box_at("marble", (w, 0.04, depth - z0 - d), sink_x, BASE_HEIGHT, z0 + d + (depth - z0 - d) / 2, 0.003))
    t, deep = 0.006, 0.19
    zc, top = z0 + d / 2, WORKTOP - 0.006
    mesh.add(box_at("steel", (w + 0.01, t, d + 0.01), sink_x, top - deep, zc, 0.002))
    for s in (-1, 1):
        mesh.add(
            box_at("steel", (t, deep, d), sink_x + s * (w / 2), top - deep, zc, 0.002),
            box_at("steel", (w, deep, t), sink_x, top - deep, zc + s * (d / 2), 0.002),
        )
        mesh.add(
            box_at("steel", (0.018, 0.003, d + 0.036), sink_x + s * (w / 2 + 0.006), WORKTOP, zc, 0.001),
            box_at("steel", (w + 0.03, 0.003, 0.018), sink_x, WORKTOP, zc + s * (d / 2 + 0.006), 0.001),
        )
    mesh.add(
        cylinder("chrome", 0.045, 0.004, 24, 0.001).move(sink_x, top - deep + t, zc),
        cylinder("painted_black", 0.03, 0.001, 20).move(sink_x, top - deep + t + 0.0042, zc),
    )
    return mesh


def tap(metal: str = "brass") -> Mesh:
    """A kitchen mixer with a swan neck reaching 0.2 m to +Z."""
    mesh = lathe(
        metal, [(0, 0), (0.028, 0), (0.028, 0.006), (0.022, 0.010), (0.019, 0.06), (0.015, 0.065), (0, 0.065)], 22, 50
    )
    neck = curve(
        (0, 0.06, 0), (0, 0.28, 0), (0, 0.37, 0.05), (0, 0.385, 0.11), (0, 0.35, 0.18), (0, 0.27, 0.20), steps=6
    )
    mesh.add(tube(metal, neck, 0.0115, 14), cylinder(metal, 0.0145, 0.035, 16, 0.002).move(0, 0.245, 0.2))
    return mesh.add(
        tube(
            metal,
            curve((0.015, 0.045, 0), (0.045, 0.05, 0), (0.10, 0.085, 0), steps=4),
            [0.008] * 4 + [0.0065] * 4 + [0.006],
            10,
        )
    )


def hob() -> Mesh:
    """A glass hob with four rings, on y = 0, centred."""
    mesh = box_at("screen_off", (0.58, 0.006, 0.50), 0, 0, 0, 0.002)
    for x, z, r in ((-0.15, -0.12, 0.09), (0.15, -0.12, 0.075), (-0.15, 0.12, 0.075), (0.15, 0.12, 0.10)):
        for q in (r, r * 0.62):
            mesh.add(lathe("plastic_grey", [(q, 0.0063), (q - 0.003, 0.0066)], 36).move(x, 0, z))
    return mesh


def hood(width: float = 0.6) -> Mesh:
    """A steel cooker hood; its lower edge at y = 0, its flue reaching 1 m up."""
    w, d = width / 2, 0.48
    low, high = (
        [(-w, 0.05, 0.0), (w, 0.05, 0.0), (w, 0.05, d), (-w, 0.05, d)],
        [(-0.13, 0.32, 0.0), (0.13, 0.32, 0.0), (0.13, 0.32, 0.24), (-0.13, 0.32, 0.24)],
    )
    mesh = box_at("steel", (width, 0.055, d), 0, 0, d / 2, 0.004)
    for k in range(4):
        a, b = low[k], low[(k + 1) % 4]
        c, e = high[(k + 1) % 4], high[k]
        corners = np.array([a, b, c, e])
        normal = np.cross(corners[1] - corners[0], corners[3] - corners[0])
        centre = corners.mean(axis=0) - np.array([0, 0.18, d / 3])
        order = np.array([[0, 1, 2], [0, 2, 3]])
        if float(normal @ centre) < 0:
            order, normal = order[:, ::-1], -normal
        part = quad("steel", 1, 1, False).parts[0]
        part.positions, part.normals, part.triangles = corners, np.tile(normal / np.linalg.norm(normal), (4, 1)), order
        mesh.add(Mesh([part]))
    mesh.add(box_at("steel", (0.26, 0.75, 0.24), 0, 0.31, 0.12, 0.004, 1, "y"))
    for x in (-0.16, 0.16):
        mesh.add(box_at("led", (0.10, 0.004, 0.05), x, -0.003, d * 0.62, 0.001))
    return mesh.add(box_at("plastic_grey", (width - 0.1, 0.003, d * 0.5), 0, -0.0015, d * 0.35, 0.0))


def fridge() -> Mesh:
    """A free-standing fridge with a freezer below, 0.62 x 2.00 x 0.62 m."""
    mesh = box_at("steel", (0.62, 1.94, 0.57), 0, 0.06, 0.285, 0.010, 2, "y")
    mesh.add(box_at("painted_black", (0.60, 0.06, 0.5), 0, 0, 0.27, 0.0))
    for y0, y1 in ((0.07, 0.72), (0.735, 1.995)):
        mesh.add(box_at("steel", (0.616, y1 - y0, 0.055), 0, y0, 0.60, 0.014, 3, "y"))
    for y0, y1 in ((0.40, 0.69), (0.77, 1.35)):
        mesh.add(tube("chrome", [(-0.26, y0, 0.675), (-0.26, y1, 0.675)], 0.011, 12))
        for y in (y0 + 0.03, y1 - 0.03):
            mesh.add(tube("chrome", [(-0.26, y, 0.62), (-0.26, y, 0.675)], 0.008, 8))
    return mesh.add(box_at("screen_off", (0.12, 0.06, 0.003), 0.15, 1.55, 0.628, 0.001))


def kettle() -> Mesh:
    mesh = lathe(
        "steel",
        [
            (0, 0.02),
            (0.078, 0.02),
            (0.082, 0.028),
            (0.078, 0.10),
            (0.066, 0.17),
            (0.058, 0.19),
            (0.05, 0.196),
            (0, 0.20),
        ],
        28,
        50,
    )
    mesh.add(cylinder("plastic_black", 0.085, 0.02, 28, 0.005), sphere("plastic_black", 0.013, 12).move(0, 0.21, 0))
    mesh.add(
        tube(
            "plastic_black",
            curve(
                (-0.058, 0.18, 0), (-0.10, 0.185, 0), (-0.125, 0.15, 0), (-0.115, 0.09, 0), (-0.08, 0.065, 0), steps=5
            ),
            0.0105,
            10,
        )
    )
    return mesh.add(tube("steel", [(0.06, 0.12, 0), (0.10, 0.165, 0), (0.112, 0.18, 0)], [0.022, 0.014, 0.012], 12))


def toaster() -> Mesh:
    mesh = box_at("painted_mustard", (0.30, 0.175, 0.165), 0, 0.015, 0, 0.035, 5)
    mesh.add(box_at("steel", (0.26, 0.012, 0.12), 0, 0.182, 0, 0.003))
    for z in (-0.03, 0.03):
        mesh.add(box_at("painted_black", (0.20, 0.004, 0.026), 0, 0.1925, z, 0.001))
    for x in (-0.10, 0.10):
        for z in (-0.05, 0.05):
            mesh.add(cylinder("rubber", 0.012, 0.018, 10).move(x, 0, z))
    mesh.add(
        box_at("painted_black", (0.006, 0.09, 0.014), 0.150, 0.06, 0, 0.0),
        box_at("chrome", (0.03, 0.012, 0.035), 0.163, 0.13, 0, 0.004, 2),
    )
    return mesh.add(cylinder("chrome", 0.014, 0.012, 16, 0.002).rotate("z", -90).move(0.150, 0.05, 0.045))


def knife_block() -> Mesh:
    mesh = box("oak", (0.10, 0.20, 0.13), 0.008, 2, "y").rotate("x", -18).move(0, 0.118, 0.0)
    for k in range(5):
        x, z = -0.03 + 0.03 * (k % 3), 0.025 - 0.05 * (k // 3)
        handle = box("painted_black", (0.016, 0.10, 0.024), 0.006, 2).move(x, 0.15, z)
        mesh.add(handle.rotate("x", -18).move(0, 0.118, 0))
    return mesh


def cutting_board() -> Mesh:
    mesh = box_at("walnut", (0.40, 0.022, 0.26), 0, 0, 0, 0.010, 3)
    for k in range(7):
        mesh.add(
            lathe(
                "pasta",
                [(0.001, 0.021), (0.045, 0.022), (0.048, 0.028), (0.048, 0.034), (0.035, 0.040), (0.001, 0.041)],
                18,
                60,
            )
            .scale(1, 1, 0.85)
            .rotate("z", -7)
            .move(-0.12 + 0.016 * k, 0.0 + 0.0012 * k, 0.02)
        )
    mesh.add(sphere("pasta", 0.055, 18).scale(1.3, 0.82, 0.9).move(0.09, 0.064, 0.02))
    knife = box_at("steel", (0.17, 0.002, 0.032), 0, 0.0225, -0.09, 0.0005)
    return mesh.add(knife, box_at("painted_black", (0.10, 0.014, 0.022), 0.13, 0.0225, -0.092, 0.006, 2))


def jar(fill: str, height: float) -> Mesh:
    mesh = lathe(fill, [(0, 0.004), (0.040, 0.004), (0.042, 0.01), (0.042, height * 0.72), (0, height * 0.74)], 20, 50)
    mesh.add(
        lathe("clear_glass", [(0, 0), (0.043, 0), (0.046, 0.004), (0.046, height * 0.93), (0.042, height)], 22, 50)
    )
    return mesh.add(cylinder("oak", 0.044, 0.022, 22, 0.004).move(0, height - 0.004, 0))


def pan(radius: float, height: float, lid: bool, colour: str = "ceramic_blue") -> Mesh:
    r, h = radius, height
    mesh = lathe(
        colour,
        [
            (0, 0),
            (r * 0.94, 0),
            (r, 0.01),
            (r, h),
            (r * 1.02, h + 0.003),
            (r * 0.97, h + 0.003),
            (r * 0.96, 0.012),
            (0, 0.01),
        ],
        32,
        45,
    )
    for s in (-1, 1):
        mesh.add(
            tube(
                colour,
                curve(
                    (s * r, h * 0.75, -0.035),
                    (s * (r + 0.035), h * 0.78, -0.03),
                    (s * (r + 0.035), h * 0.78, 0.03),
                    (s * r, h * 0.75, 0.035),
                    steps=4,
                ),
                0.007,
                8,
            )
        )
    if lid:
        mesh.add(
            lathe(
                colour,
                [(r * 1.01, h + 0.003), (r * 0.9, h + 0.022), (r * 0.4, h + 0.036), (0.02, h + 0.038), (0, h + 0.038)],
                32,
                60,
            )
        )
        mesh.add(
            lathe(
                "brass",
                [
                    (0.008, h + 0.036),
                    (0.008, h + 0.05),
                    (0.022, h + 0.056),
                    (0.022, h + 0.064),
                    (0.012, h + 0.068),
                    (0, h + 0.068),
                ],
                18,
                50,
            )
        )
    return mesh


def utensil_jar() -> Mesh:
    mesh = lathe(
        "ceramic_sand",
        [(0, 0), (0.055, 0), (0.060, 0.006), (0.060, 0.15), (0.055, 0.15), (0.054, 0.02), (0, 0.02)],
        26,
        45,
    )
    for k, material in enumerate(("oak", "walnut", "steel", "oak", "steel")):
        a = 2 * math.pi * k / 5
        top = (0.075 * math.cos(a), 0.30 + 0.02 * (k % 3), 0.075 * math.sin(a))
        mesh.add(tube(material, [(0.02 * math.cos(a), 0.03, 0.02 * math.sin(a)), top], 0.0055, 8))
        mesh.add(sphere(material, 0.026, 12).scale(1, 1.35, 0.35).rotate("y", math.degrees(-a) + 30).move(*top))
    return mesh


def coffee_machine() -> Mesh:
    mesh = box_at("steel", (0.26, 0.06, 0.32), 0, 0, 0, 0.012, 2)
    mesh.add(
        box_at("steel", (0.26, 0.33, 0.16), 0, 0.05, -0.08, 0.012, 2, "y"),
        box_at("steel", (0.26, 0.11, 0.32), 0, 0.27, 0, 0.016, 3),
    )
    mesh.add(box_at("plastic_black", (0.22, 0.006, 0.14), 0, 0.058, 0.08, 0.002))
    mesh.add(
        cylinder("chrome", 0.034, 0.05, 22, 0.004).move(0, 0.225, 0.07),
        cylinder("chrome", 0.04, 0.03, 22, 0.004).move(0, 0.20, 0.07),
    )
    mesh.add(tube("painted_black", [(0, 0.215, 0.105), (0, 0.205, 0.22)], [0.011, 0.014], 12))
    mesh.add(tube("chrome", curve((0.10, 0.27, 0.10), (0.105, 0.20, 0.13), (0.10, 0.12, 0.13), steps=5), 0.0045, 8))
    for x in (-0.07, 0.0, 0.07):
        mesh.add(cylinder("chrome", 0.013, 0.012, 16, 0.002).rotate("x", 90).move(x, 0.335, 0.16))
    return mesh


def fruit(kind: str, radius: float = 0.037) -> Mesh:
    if kind == "banana":
        path = curve((-0.09, 0.03, 0), (-0.05, 0.006, 0), (0.03, 0.0, 0), (0.09, 0.035, 0), steps=5)
        return tube(
            "lemon",
            path,
            [
                0.006,
                0.011,
                0.014,
                0.016,
                0.017,
                0.0175,
                0.018,
                0.018,
                0.0175,
                0.017,
                0.016,
                0.015,
                0.013,
                0.011,
                0.008,
                0.005,
            ],
            9,
        )
    mesh = sphere(kind, radius, 16, {"lemon": 0.85, "pear": 1.1}.get(kind, 0.93))
    if kind == "lemon":
        mesh.scale(1.25, 1, 1)
    if kind in ("apple", "pear"):
        mesh.add(tube("bark", [(0, radius * 0.8, 0), (0.004, radius * 1.25, 0)], 0.0022, 6))
    return mesh


def fruit_bowl_content(radius: float, seed: int) -> Mesh:
    """Fruit heaped in a bowl whose bottom is y = 0."""
    mesh = Mesh()
    kinds = ["apple", "orange", "pear", "apple", "lemon", "orange"]
    for k, kind in enumerate(kinds):
        a = 2 * math.pi * k / 6 + seed
        mesh.add(
            fruit(kind)
            .rotate("z", 20 * math.sin(k * 2.0))
            .rotate("y", k * 50)
            .move(radius * 0.48 * math.cos(a), 0.052, radius * 0.48 * math.sin(a))
        )
    for k, kind in enumerate(("orange", "apple", "pear")):
        a = 2 * math.pi * k / 3 + seed + 0.5
        mesh.add(fruit(kind).rotate("y", k * 80).move(radius * 0.22 * math.cos(a), 0.112, radius * 0.22 * math.sin(a)))
    return mesh


def under_cabinet_light(length: float) -> Mesh:
    return union(
        box_at("white_lacquer", (length, 0.014, 0.04), 0, -0.014, 0, 0.003),
        box_at("led", (length - 0.02, 0.004, 0.024), 0, -0.017, 0, 0.001),
    )
