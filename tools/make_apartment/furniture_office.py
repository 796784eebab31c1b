# SPDX-License-Identifier: MIT
"""Desk, electronics and small things of living and working. Fronts face +Z, everything stands on y = 0 unless said."""

from __future__ import annotations

import math

import numpy as np

from furniture_common import board, box_at, knob, tapered_leg
from geometry import Array, Mesh, box, curve, cylinder, lathe, quad, soft_box, sphere, surface, tube, union, waves


def desk(width: float, depth: float) -> Mesh:
    """An oak desk, 0.74 m high, with a drawer unit at +X; the sitter is at +Z."""
    mesh = board("oak", (width, 0.030, depth), 0, 0.710, 0, 0.008)
    for x in (-width / 2 + 0.06, width / 2 - 0.06):
        for z in (-depth / 2 + 0.06, depth / 2 - 0.06):
            mesh.add(
                tapered_leg("oak", 0.71, 0.026, 0.015, (0.03 * math.copysign(1, x), 0.02 * math.copysign(1, z))).move(
                    x, 0, z
                )
            )
    mesh.add(board("oak", (width - 0.14, 0.09, 0.02), 0, 0.62, -depth / 2 + 0.06))
    x0 = width / 2 - 0.31
    mesh.add(box_at("oak", (0.40, 0.30, depth - 0.14), x0, 0.41, 0, 0.004))
    for k in range(2):
        mesh.add(
            box_at("oak", (0.39, 0.142, 0.018), x0, 0.415 + 0.147 * k, depth / 2 - 0.066, 0.004, 2),
            knob("brass").move(x0, 0.486 + 0.147 * k, depth / 2 - 0.058),
        )
    return mesh


def monitor(width: float = 0.62) -> Mesh:
    """A monitor on a stand; its screen shows a desktop."""
    h = width * 0.58
    mesh = box_at("plastic_black", (width, h, 0.022), 0, 0.13, 0, 0.006, 2)
    mesh.add(box_at("plastic_black", (width * 0.5, h * 0.5, 0.035), 0, 0.13 + h * 0.25, -0.022, 0.012, 2))
    mesh.add(quad("screen", width - 0.016, h - 0.024).move(0, 0.13 + h / 2 + 0.004, 0.0115))
    mesh.add(
        box_at("steel", (0.05, 0.28, 0.014), 0, 0.008, -0.045, 0.004, 1, "y"),
        box_at("steel", (0.24, 0.010, 0.19), 0, 0, -0.03, 0.004, 2),
    )
    return mesh.add(box_at("power_led", (0.008, 0.002, 0.002), width / 2 - 0.03, 0.135, 0.0115, 0.0))


def keyboard() -> Mesh:
    mesh = box("plastic_grey", (0.44, 0.012, 0.135), 0.005, 2).rotate("x", 3).move(0, 0.010, 0)
    for row in range(5):
        count = 14 if row else 14
        for k in range(count):
            w = 0.0275
            if row == 4 and 3 < k < 10:
                continue
            mesh.add(
                box("plastic_white", (w - 0.004, 0.006, 0.020), 0.002, 1).move(
                    -0.193 + 0.0297 * k, 0.021 + 0.0012 * (2 - row), -0.048 + 0.0242 * row
                )
            )
    return mesh.add(box("plastic_white", (0.170, 0.006, 0.020), 0.002).move(0.0, 0.0186, 0.0488))


def mouse() -> Mesh:
    return union(
        sphere("plastic_white", 0.032, 18).scale(1.0, 0.55, 1.65).move(0, 0.016, 0),
        box("plastic_grey", (0.006, 0.010, 0.014), 0.003).move(0, 0.032, -0.022),
    )


def desk_lamp() -> Mesh:
    """An architect's lamp; its bulb is at (0.33, 0.37, 0)."""
    mesh = lathe(
        "painted_black", [(0, 0), (0.085, 0), (0.088, 0.008), (0.080, 0.022), (0.02, 0.028), (0, 0.028)], 28, 50
    )
    a, b, c = (0, 0.028, 0), (-0.10, 0.36, 0), (0.26, 0.47, 0)
    for z in (-0.010, 0.010):
        mesh.add(
            tube("painted_black", [(a[0], a[1], z), (b[0], b[1], z)], 0.0042, 8),
            tube("painted_black", [(b[0], b[1], z), (c[0], c[1], z)], 0.0042, 8),
        )
    for p in (b, c):
        mesh.add(cylinder("brass", 0.011, 0.034, 14, 0.002).rotate("x", 90).move(p[0], p[1], -0.017))
    shade = lathe("painted_black", [(0.078, -0.075), (0.075, -0.05), (0.042, 0.02), (0.026, 0.05), (0, 0.052)], 28, 60)
    inner = lathe("white_lacquer", [(0.024, 0.045), (0.040, 0.018), (0.073, -0.05), (0.076, -0.075)], 28, 60)
    return mesh.add(
        union(shade, inner, sphere("bulb", 0.026, 12).move(0, -0.02, 0)).rotate("z", -22).move(0.315, 0.405, 0)
    )


def laptop() -> Mesh:
    mesh = box_at("steel", (0.33, 0.014, 0.23), 0, 0, 0, 0.006, 2)
    lid = union(
        box_at("steel", (0.33, 0.22, 0.007), 0, 0, 0, 0.003, 2), quad("screen_off", 0.31, 0.20).move(0, 0.11, 0.0037)
    )
    mesh.add(lid.rotate("x", -18).move(0, 0.012, -0.112))
    for row in range(5):
        for k in range(12):
            mesh.add(
                box("plastic_black", (0.020, 0.003, 0.015), 0.001, 1).move(
                    -0.132 + 0.024 * k, 0.0148, -0.078 + 0.019 * row
                )
            )
    return mesh.add(box_at("plastic_grey", (0.10, 0.001, 0.065), 0, 0.014, 0.068, 0.0))


def television(width: float) -> Mesh:
    h = width * 0.575
    mesh = box_at("plastic_black", (width, h, 0.035), 0, 0.06, 0, 0.006, 2)
    mesh.add(quad("screen_off", width - 0.018, h - 0.022).move(0, 0.06 + h / 2 + 0.003, 0.018))
    for s in (-1, 1):
        mesh.add(
            tube("painted_black", [(s * width * 0.32, 0.07, 0), (s * width * 0.36, 0.006, 0.11)], 0.008, 8),
            tube("painted_black", [(s * width * 0.32, 0.07, 0), (s * width * 0.36, 0.006, -0.11)], 0.008, 8),
        )
    return mesh.add(box_at("power_led", (0.008, 0.003, 0.002), 0, 0.064, 0.0178, 0.0))


def speaker(height: float = 0.36) -> Mesh:
    w, d = height * 0.55, height * 0.62
    mesh = box_at("walnut", (w, height, d), 0, 0, 0, 0.008, 2, "y")
    mesh.add(box_at("painted_black", (w - 0.02, height - 0.02, 0.006), 0, 0.01, d / 2, 0.003))
    for y, r in ((height * 0.34, w * 0.36), (height * 0.74, w * 0.19)):
        cone = lathe("rubber", [(r, 0.004), (r * 0.96, 0.010), (r * 0.84, 0.006), (r * 0.80, -0.002)], 32, 60)
        cone.add(lathe("plastic_grey", [(r * 0.82, 0.0), (r * 0.30, -0.018), (r * 0.28, -0.004), (0, 0.004)], 32, 50))
        mesh.add(cone.rotate("x", 90).move(0, y, d / 2 + 0.003))
    return mesh


def record_player() -> Mesh:
    mesh = box_at("walnut", (0.44, 0.075, 0.35), 0, 0.012, 0, 0.008, 2)
    for x in (-0.18, 0.18):
        for z in (-0.13, 0.13):
            mesh.add(cylinder("rubber", 0.02, 0.014, 14).move(x, 0, z))
    mesh.add(
        cylinder("steel", 0.152, 0.014, 44, 0.003).move(-0.05, 0.087, 0),
        cylinder("rubber", 0.148, 0.004, 44, 0.001).move(-0.05, 0.101, 0),
        cylinder("linen_rust", 0.05, 0.001, 28).move(-0.05, 0.105, 0),
        cylinder("chrome", 0.003, 0.014, 8).move(-0.05, 0.103, 0),
    )
    for r in (0.07, 0.09, 0.11, 0.13):
        mesh.add(lathe("plastic_black", [(r + 0.004, 0.1052), (r, 0.1056)], 40).move(-0.05, 0, 0))
    mesh.add(
        cylinder("chrome", 0.022, 0.03, 18, 0.004).move(0.165, 0.087, -0.11),
        tube(
            "chrome",
            curve((0.165, 0.118, -0.145), (0.165, 0.118, 0.0), (0.125, 0.115, 0.075), (0.06, 0.110, 0.095), steps=5),
            0.0045,
            8,
        ),
    )
    return mesh.add(cylinder("chrome", 0.014, 0.012, 16, 0.002).move(0.17, 0.087, 0.13))


def globe() -> Mesh:
    ball = sphere("globe", 0.14, 36)
    for part in ball.parts:
        p = part.positions / 0.14
        angles = np.arctan2(-p[:, 2], p[:, 0]) / (2 * math.pi) % 1.0
        # The seam of the lathe repeats its first meridian: give the copy u = 1.
        columns = 37
        column = np.arange(len(p)) % columns
        part.uv = np.stack(
            [
                np.where(column == columns - 1, 1.0, np.where((column == 0), 0.0, angles)),
                0.5 - np.arcsin(np.clip(p[:, 1], -1, 1)) / math.pi,
            ],
            1,
        )
    mesh = ball.rotate("z", -23.4).move(0, 0.235, 0)
    arc = [
        (0.155 * math.cos(a), 0.235 + 0.155 * math.sin(a), 0)
        for a in np.linspace(math.radians(-113.4), math.radians(66.6), 20)
    ]
    mesh.add(tube("brass", arc, 0.0055, 8), tube("brass", [arc[0], (0, 0.05, 0)], 0.007, 8))
    return mesh.add(
        lathe(
            "walnut",
            [(0, 0), (0.095, 0), (0.098, 0.008), (0.085, 0.02), (0.03, 0.035), (0.018, 0.06), (0, 0.06)],
            28,
            60,
        )
    )


def wall_clock(radius: float = 0.15) -> Mesh:
    """A clock at ten past ten, its back at z = 0."""
    mesh = lathe(
        "walnut",
        [
            (0, 0),
            (radius, 0),
            (radius + 0.004, 0.01),
            (radius, 0.032),
            (radius - 0.012, 0.034),
            (radius - 0.014, 0.022),
        ],
        44,
        50,
    ).rotate("x", 90)
    face = lathe("clock", [(radius - 0.013, 0.022), (0.0, 0.0221)], 44, 80).rotate("x", 90)
    for part in face.parts:
        part.uv = np.stack([part.positions[:, 0] / (2 * radius) + 0.5, 0.5 - part.positions[:, 1] / (2 * radius)], 1)
    mesh.add(face)
    for angle, length, width in ((-55, radius * 0.5, 0.008), (60, radius * 0.74, 0.006)):
        mesh.add(box("painted_black", (width, length, 0.002), 0.0).move(0, length * 0.42, 0.026).rotate("z", -angle))
    mesh.add(box("plastic_red", (0.002, radius * 0.8, 0.001), 0.0).move(0, radius * 0.3, 0.028).rotate("z", 140))
    return mesh.add(cylinder("painted_black", 0.007, 0.010, 14).rotate("x", 90).move(0, 0, 0.022))


def cork_board(width: float, height: float, seed: int) -> Mesh:
    """A notice board with notes and pins, its back at z = 0, centred."""
    random = np.random.default_rng(seed)
    mesh = box("cork", (width - 0.03, height - 0.03, 0.012), 0.0).move(0, 0, 0.006)
    for x in (-(width - 0.02) / 2, (width - 0.02) / 2):
        mesh.add(box("oak", (0.022, height, 0.022), 0.004, 2, "y").move(x, 0, 0.011))
    for y in (-(height - 0.02) / 2, (height - 0.02) / 2):
        mesh.add(box("oak", (width - 0.04, 0.022, 0.022), 0.004, 2, "x").move(0, y, 0.011))
    papers = ["paper", "linen_mustard", "paper", "linen_rose", "painting_botanical", "paper", "linen_teal"]
    for k, material in enumerate(papers):
        w, h = float(random.uniform(0.09, 0.16)), float(random.uniform(0.11, 0.18))
        x, y = (
            -width / 2 + 0.13 + (k % 4) * (width - 0.26) / 3,
            height * 0.2 * (1 if k < 4 else -1) + float(random.normal() * 0.012),
        )
        tilt = float(random.normal() * 4)
        note = surface(
            material,
            lambda u, v, w=w, h=h: np.stack(  # type: ignore[misc]
                [(u - 0.5) * w, (v - 1.0) * h, 0.014 + 0.010 * (1 - v) ** 2], 1
            ),
            5,
            3,
        )
        mesh.add(
            union(note, sphere("plastic_red" if k % 2 else "ceramic_blue", 0.006, 10).move(0, -0.012, 0.019))
            .rotate("z", tilt)
            .move(x, y + h / 2, 0)
        )
    return mesh


def pen_cup() -> Mesh:
    mesh = lathe(
        "ceramic_blue",
        [(0, 0), (0.038, 0), (0.040, 0.004), (0.040, 0.095), (0.036, 0.095), (0.035, 0.01), (0, 0.01)],
        24,
        45,
    )
    for k, colour in enumerate(("painted_mustard", "painted_black", "plastic_red", "painted_navy", "painted_sage")):
        a = 2.4 * k
        mesh.add(
            tube(
                colour,
                [
                    (0.015 * math.cos(a), 0.012, 0.015 * math.sin(a)),
                    (0.040 * math.cos(a), 0.17 + 0.01 * (k % 2), 0.040 * math.sin(a)),
                ],
                0.0038,
                7,
            )
        )
    return mesh


def paper_stack(seed: int, count: int = 10) -> Mesh:
    random = np.random.default_rng(seed)
    mesh = Mesh()
    for k in range(count):
        mesh.add(
            box_at("paper", (0.21, 0.0022, 0.297), 0, 0, 0, 0.0)
            .rotate("y", float(random.normal() * 3))
            .move(float(random.normal() * 0.003), 0.0023 * k, float(random.normal() * 0.003))
        )
    return mesh


def filing_cabinet() -> Mesh:
    mesh = box_at("painted_navy", (0.42, 0.62, 0.50), 0, 0.05, 0, 0.006, 2)
    for k in range(3):
        y = 0.06 + 0.20 * k
        mesh.add(
            box_at("painted_navy", (0.40, 0.194, 0.018), 0, y, 0.255, 0.005, 2),
            tube("brass", [(-0.06, y + 0.14, 0.285), (0.06, y + 0.14, 0.285)], 0.005, 10),
        )
        for x in (-0.05, 0.05):
            mesh.add(tube("brass", [(x, y + 0.14, 0.262), (x, y + 0.14, 0.285)], 0.004, 8))
        mesh.add(box_at("label", (0.06, 0.024, 0.001), 0, y + 0.075, 0.2643, 0.0))
    for x in (-0.17, 0.17):
        for z in (-0.2, 0.2):
            mesh.add(cylinder("rubber", 0.02, 0.05, 12).move(x, 0, z))
    return mesh


def candle(height: float, radius: float = 0.03) -> Mesh:
    mesh = lathe(
        "wax",
        [
            (0, 0),
            (radius, 0),
            (radius, height),
            (radius * 0.9, height),
            (radius * 0.7, height - 0.006),
            (0, height - 0.008),
        ],
        20,
        40,
    )
    return mesh.add(tube("rubber", [(0, height - 0.01, 0), (0.002, height + 0.008, 0)], 0.001, 5))


def candle_holder() -> Mesh:
    mesh = lathe(
        "brass",
        [(0, 0), (0.045, 0), (0.046, 0.006), (0.012, 0.016), (0.008, 0.10), (0.018, 0.12), (0.020, 0.14), (0, 0.14)],
        24,
        50,
    )
    return mesh.add(candle(0.16, 0.011).move(0, 0.135, 0))


def remote_control() -> Mesh:
    mesh = box_at("plastic_black", (0.045, 0.018, 0.17), 0, 0, 0, 0.008, 2)
    for row in range(6):
        for k in range(3):
            mesh.add(
                cylinder("plastic_red" if (row, k) == (0, 2) else "plastic_grey", 0.0042, 0.003, 8).move(
                    -0.012 + 0.012 * k, 0.017, -0.062 + 0.019 * row
                )
            )
    return mesh


def coat(fabric: str, seed: int, length: float = 1.0) -> Mesh:
    """A coat on a hook at the origin, hanging against a wall at z = -0.05."""

    def shape(u: Array, v: Array) -> Array:
        a = u * 2 * math.pi
        d = 1 - v
        half = np.interp(d, [0, 0.06, 0.2, 0.6, 1.0], [0.03, 0.10, 0.19, 0.215, 0.26])
        thick = np.interp(d, [0, 0.06, 0.2, 0.6, 1.0], [0.03, 0.05, 0.06, 0.055, 0.07])
        fold = 1 + 0.16 * np.sin(a * 6 + seed + 1.5 * d) * d
        return np.stack([half * np.cos(a) * (1 + 0.02 * fold), -length * d, 0.02 + thick * np.sin(a) * fold], 1)

    body = surface(fabric, shape, 22, 42, (1.0, length), flip=True)
    mesh = union(body)
    for s in (-1, 1):
        sleeve = curve(
            (s * 0.13, -0.10, 0.02),
            (s * 0.215, -0.24, 0.03),
            (s * 0.245, -0.46, 0.04),
            (s * 0.235, -0.66, 0.05),
            steps=5,
        )
        mesh.add(tube(fabric, sleeve, list(np.linspace(0.065, 0.048, len(sleeve))), 14))
    for k in range(4):
        mesh.add(cylinder("painted_black", 0.010, 0.005, 12, 0.001).rotate("x", 90).move(0.02, -0.25 - 0.14 * k, 0.088))
    collar = [
        (0.075 * math.cos(a), -0.045 + 0.02 * math.sin(a), 0.03 + 0.05 * math.sin(a))
        for a in np.linspace(0, 2 * math.pi, 18, endpoint=False)
    ]
    return mesh.add(tube(fabric, collar, 0.020, 8, closed=True))


def shoe(material: str, sole: str = "rubber") -> Mesh:
    """A low shoe, heel at -Z, 28 cm long."""

    def upper(u: Array, v: Array) -> Array:
        a = v * math.pi
        width = np.interp(u, [0, 0.08, 0.3, 0.55, 0.8, 0.95, 1], [0.012, 0.034, 0.034, 0.040, 0.048, 0.034, 0.006])
        height = np.interp(u, [0, 0.06, 0.25, 0.42, 0.6, 0.85, 1], [0.03, 0.078, 0.082, 0.085, 0.060, 0.042, 0.012])
        z = -0.14 + 0.28 * u
        return np.stack([width * np.cos(a), 0.018 + height * np.sin(a) ** 0.8, z], 1)

    mesh = surface(material, upper, 13, 22, (0.28, 0.15))

    def base(u: Array, v: Array) -> Array:
        a = u * 2 * math.pi
        z = 0.145 * -np.cos(a)
        t = (z + 0.145) / 0.29
        width = np.interp(t, [0, 0.08, 0.3, 0.55, 0.8, 0.95, 1], [0.016, 0.038, 0.037, 0.043, 0.051, 0.036, 0.008])
        shrink = np.where(v > 0.5, (1 - v) * 2, np.minimum(v * 8, 1))
        y = np.where(v > 0.5, 0.024, np.clip(v, 0, 0.5) * 0.048)
        return np.stack([width * np.sign(np.sin(a)) * np.abs(np.sin(a)) ** 0.3 * shrink, y, z * shrink], 1)

    mesh.add(surface(sole, base, 9, 32, (0.6, 0.05), flip=True))
    mesh.add(sphere("rubber", 0.026, 14).scale(1.0, 0.16, 1.5).move(0, 0.0965, -0.06))
    for k in range(4):
        mesh.add(
            tube(
                "linen_white",
                [(-0.018, 0.092 - 0.009 * k, 0.0 + 0.02 * k), (0.018, 0.092 - 0.009 * k, 0.0 + 0.02 * k)],
                0.0022,
                6,
            )
        )
    return mesh


def umbrella_stand() -> Mesh:
    mesh = lathe(
        "black_metal", [(0, 0), (0.11, 0), (0.115, 0.01), (0.11, 0.50), (0.105, 0.50), (0.10, 0.02), (0, 0.02)], 28, 45
    )
    for k, fabric in enumerate(("linen_rust", "linen_black")):
        x = 0.04 * (1 if k else -1)
        body = lathe(
            fabric, [(0.006, 0.05), (0.018, 0.10), (0.030, 0.45), (0.024, 0.60), (0.010, 0.66), (0, 0.66)], 14, 70
        ).displace(lambda p, n: p + n * (0.003 * np.sin(np.arctan2(p[:, 2], p[:, 0]) * 8))[:, None])
        body.add(
            tube(
                "walnut",
                curve((0, 0.66, 0), (0, 0.80, 0), (0.015, 0.835, 0), (0.05, 0.84, 0), (0.065, 0.80, 0), steps=5),
                0.0095,
                10,
            )
        )
        mesh.add(body.rotate("z", -5 if k else 6).rotate("y", 40 * k).move(x, 0.0, 0.02 * k))
    return mesh


def key_bowl() -> Mesh:
    mesh = Mesh()
    for k in range(3):
        ring = [
            (0.012 * math.cos(a), 0.0, 0.012 * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 14, endpoint=False)
        ]
        mesh.add(
            union(
                tube("steel", ring, 0.0015, 6, closed=True),
                box("brass" if k % 2 else "steel", (0.008, 0.002, 0.05), 0.0).move(0, 0, 0.035),
            )
            .rotate("y", 65 * k)
            .move(0, 0.004 + 0.003 * k, 0)
        )
    return mesh


def magazine(seed: int) -> Mesh:
    random = np.random.default_rng(seed)
    covers = ["painting_abstract", "painting_waves", "painting_landscape"]
    mesh = Mesh()
    for k in range(3):
        one = box_at("paper", (0.21, 0.006, 0.28), 0, 0, 0, 0.001)
        one.add(quad(covers[k], 0.209, 0.279).rotate("x", -90).move(0, 0.0063, 0))
        mesh.add(one.rotate("y", float(random.uniform(-14, 14)) + 6 * k).move(0.004 * k, 0.0066 * k, 0))
    return mesh


def teddy(seed: int = 3) -> Mesh:
    """A small sitting bear."""
    m = "boucle_cream"
    mesh = union(
        sphere(m, 0.085, 20, 1.1).move(0, 0.095, 0),
        sphere(m, 0.065, 20).move(0, 0.225, 0.01),
        sphere(m, 0.028, 14, 0.8).move(0, 0.212, 0.062),
        sphere("rubber", 0.008, 10).move(0, 0.222, 0.088),
    )
    for s in (-1, 1):
        mesh.add(
            sphere(m, 0.024, 12).move(s * 0.048, 0.278, 0.005), sphere("rubber", 0.006, 8).move(s * 0.024, 0.242, 0.066)
        )
        mesh.add(
            sphere(m, 0.036, 14).scale(0.9, 0.9, 2.0).rotate("y", s * 22).move(s * 0.06, 0.038, 0.085),
            sphere(m, 0.030, 14).scale(0.9, 1.8, 0.9).rotate("z", s * 38).move(s * 0.092, 0.125, 0.02),
        )
    return mesh.displace(lambda p, n: p + n * (0.002 * waves(p, 60, seed))[:, None])


def floor_cushion(fabric: str) -> Mesh:
    return soft_box(fabric, (0.6, 0.16, 0.6), 0.06, 0.035, 9, 3, 0.004, 12).move(0, 0.095, 0)
