# SPDX-License-Identifier: MIT
"""Bathroom fittings. Fronts face +Z, backs are at z = 0, everything stands on y = 0."""

from __future__ import annotations

import math

import numpy as np

from furniture_common import bar_handle, box_at
from geometry import Array, Mesh, box, curve, cylinder, lathe, quad, sphere, surface, tube, union


def _rounded_ring(u: Array, half_x: float, half_z: float, power: float = 5.0) -> tuple[Array, Array]:
    """Points of a superellipse for u in 0..1."""
    a = u * 2 * math.pi
    c, s = np.cos(a), np.sin(a)
    return half_x * np.sign(c) * np.abs(c) ** (2 / power), half_z * np.sign(s) * np.abs(s) ** (2 / power)


def bathtub(length: float, width: float) -> Mesh:
    """A built-in tub, long side along X, centred, with a tiled apron at +Z."""
    h = 0.56
    levels = [
        (0.0, -0.004),
        (0.06, 0.0),
        (0.10, -0.006),
        (0.14, -0.06),
        (0.40, -0.30),
        (0.62, -0.395),
        (0.82, -0.415),
        (1.0, -0.42),
    ]

    def inside(u: Array, v: Array) -> Array:
        t = np.interp(v, np.linspace(0, 1, len(levels)), [lv[0] for lv in levels])
        y = np.interp(v, np.linspace(0, 1, len(levels)), [lv[1] for lv in levels])
        inset = np.interp(t, [0, 0.06, 0.14, 0.40, 0.62, 1.0], [0.0, 0.045, 0.075, 0.12, 0.19, 0.42])
        shrink = np.clip(1 - np.clip(t - 0.82, 0, 1) / 0.18, 0, 1)
        x, z = _rounded_ring(u, 1.0, 1.0, 5.0)
        hx, hz = (length / 2 - inset) * (0.0 + shrink), (width / 2 - inset * 0.75) * shrink
        return np.stack([x * np.maximum(hx, 0), h + y, z * np.maximum(hz, 0)], 1)

    basin = surface("ceramic_white", inside, 22, 64, (4.0, 1.0), flip=True)
    mesh = union(basin)
    mesh.add(
        box_at("ceramic_white", (length, 0.03, 0.05), 0, h - 0.034, width / 2 - 0.025, 0.010, 2),
        box_at("ceramic_white", (length, 0.03, 0.05), 0, h - 0.034, -width / 2 + 0.025, 0.010, 2),
    )
    for side in (-1, 1):
        mesh.add(box_at("ceramic_white", (0.05, 0.03, width), side * (length / 2 - 0.025), h - 0.034, 0, 0.010, 2))
        # The corners between the superellipse and the rectangle.
        for sz in (-1, 1):
            mesh.add(
                box_at(
                    "ceramic_white",
                    (0.13, 0.024, 0.13),
                    side * (length / 2 - 0.065),
                    h - 0.034,
                    sz * (width / 2 - 0.065),
                    0.006,
                )
            )
    apron = box_at("bath_tiles", (length, h - 0.03, 0.03), 0, 0, width / 2 - 0.02, 0.0)
    mesh.add(apron, box_at("bath_tiles", (0.03, h - 0.03, width - 0.04), length / 2 - 0.02, 0, 0, 0.0))
    mesh.add(cylinder("chrome", 0.032, 0.004, 20, 0.001).move(length * 0.30, h - 0.4195, 0))
    return mesh.add(
        lathe("chrome", [(0, 0), (0.034, 0), (0.030, 0.010), (0, 0.012)], 20, 50)
        .rotate("z", -90)
        .move(-length / 2 + 0.135, h - 0.15, 0)
    )


def bath_mixer() -> Mesh:
    """A wall mixer with hand shower on a rail; the wall is z = 0, the spout at y = 0."""
    mesh = tube("chrome", [(-0.10, 0, 0.06), (0.10, 0, 0.06)], 0.022, 16)
    for x in (-0.075, 0.075):
        mesh.add(
            tube("chrome", [(x, 0, 0), (x, 0, 0.06)], 0.014, 12),
            lathe("chrome", [(0, 0), (0.034, 0), (0.030, 0.012), (0, 0.012)], 22, 50).rotate("x", 90).move(x, 0, 0),
        )
    mesh.add(tube("chrome", curve((0, -0.01, 0.07), (0, -0.03, 0.13), (0, -0.06, 0.17), steps=4), 0.014, 12))
    for x in (-0.12, 0.12):
        mesh.add(cylinder("chrome", 0.026, 0.045, 18, 0.005).rotate("z", -90).move(x - 0.0225, 0, 0.06))
    mesh.add(tube("chrome", [(0.0, 0.55, 0.045), (0.0, 1.25, 0.045)], 0.010, 12))
    for y in (0.57, 1.23):
        mesh.add(tube("chrome", [(0, y, 0), (0, y, 0.045)], 0.012, 10))
    mesh.add(box("chrome", (0.035, 0.05, 0.05), 0.010, 2).move(0, 1.12, 0.05))
    head = union(
        tube("chrome", [(0, 0, 0), (0, 0.17, 0)], [0.011, 0.013], 12),
        lathe("chrome", [(0, 0), (0.052, 0.0), (0.054, 0.012), (0.02, 0.03), (0, 0.03)], 26, 50)
        .rotate("x", 100)
        .move(0, 0.19, 0.012),
    )
    mesh.add(head.rotate("x", 28).move(0, 1.05, 0.07))
    hose = curve(
        (0, 1.05, 0.07), (0.03, 0.75, 0.12), (0.10, 0.35, 0.13), (0.10, 0.12, 0.10), (0.05, 0.02, 0.08), steps=8
    )
    return mesh.add(tube("steel", hose, 0.0065, 8))


def glass_screen(width: float, height: float) -> Mesh:
    """A frameless screen along X from 0, with a chrome wall profile, bottom at y = 0."""
    mesh = box_at("clear_glass", (width, height, 0.008), width / 2, 0, 0, 0.002)
    return mesh.add(
        box_at("chrome", (0.024, height, 0.022), 0.012, 0, 0, 0.003, 1, "y"),
        tube("chrome", [(width * 0.96, height - 0.02, 0), (width * 0.96, height - 0.02, -0.05)], 0.006, 8),
    )


def toilet() -> Mesh:
    """A close-coupled toilet with seat and lid, 0.68 m deep."""

    def body(u: Array, v: Array) -> Array:
        a = u * 2 * math.pi
        widths = np.interp(v, [0, 0.10, 0.45, 0.80, 0.97, 1.0], [0.115, 0.110, 0.125, 0.175, 0.185, 0.180])
        front = np.interp(v, [0, 0.10, 0.45, 0.80, 0.97, 1.0], [0.17, 0.165, 0.20, 0.285, 0.30, 0.295])
        z = np.where(np.sin(a) > 0, front * np.sin(a), 0.17 * np.sign(np.sin(a)) * np.abs(np.sin(a)) ** 0.5)
        x = widths * np.sign(np.cos(a)) * np.abs(np.cos(a)) ** 0.85
        return np.stack([x, 0.39 * v, 0.36 + z], 1)

    mesh = surface("ceramic_white", body, 14, 48, (1.2, 0.4))

    def disc(y: float, grow: float, inner: float) -> Mesh:
        def shape(u: Array, v: Array) -> Array:
            p = body(u, np.full_like(u, 0.97))
            centre = np.array([0.0, 0.0, 0.40])
            r = (p - centre) * (1 + grow)
            t = inner + (1 - inner) * np.clip(v * 1.2, 0, 1)
            drop = np.clip(v * 1.2 - 1, 0, 1) * 0.09
            q: Array = centre + r * t[:, None]
            q[:, 1] = y - drop
            return q

        return surface("plastic_white", shape, 8, 48, (1.2, 0.2), flip=True)

    mesh.add(disc(0.412, 0.02, 0.62), disc(0.432, 0.03, 0.0))
    mesh.add(
        box_at("ceramic_white", (0.40, 0.40, 0.175), 0, 0.39, 0.095, 0.035, 4),
        box_at("ceramic_white", (0.42, 0.03, 0.19), 0, 0.785, 0.097, 0.012, 3),
    )
    mesh.add(box_at("ceramic_white", (0.23, 0.36, 0.22), 0, 0.02, 0.12, 0.03, 3))
    for x in (-0.024, 0.024):
        mesh.add(box_at("chrome", (0.040, 0.006, 0.03), x, 0.815, 0.097, 0.003, 2))
    for x in (-0.07, 0.07):
        mesh.add(cylinder("chrome", 0.012, 0.02, 14, 0.003).move(x, 0.40, 0.205))
    return mesh


def vanity(width: float) -> Mesh:
    """A wash-stand: oak cabinet with two drawers hung on the wall and a ceramic top with a basin."""
    d = 0.48
    # The box is lower than its sides and fronts, so that the basin has room.
    mesh = box_at("oak", (width - 0.02, 0.33, d - 0.03), 0, 0.38, (d - 0.02) / 2, 0.003)
    for side in (-1, 1):
        mesh.add(box_at("oak", (0.018, 0.44, d - 0.02), side * (width - 0.018) / 2, 0.38, (d - 0.02) / 2, 0.003))
    for k in range(2):
        mesh.add(box_at("oak", (width - 0.006, 0.214, 0.02), 0, 0.383 + 0.218 * k, d - 0.010, 0.003))
        mesh.add(bar_handle("brass", 0.26).move(0, 0.383 + 0.218 * k + 0.165, d))
    top, r_x, r_z, zc = 0.855, min(0.27, width * 0.32), 0.165, d * 0.55

    def basin(u: Array, v: Array) -> Array:
        x, z = _rounded_ring(u, 1.0, 1.0, 3.2)
        t = np.interp(v, [0, 0.15, 0.3, 0.7, 0.9, 1.0], [1.03, 1.0, 0.97, 0.86, 0.55, 0.0])
        y = np.interp(v, [0, 0.15, 0.3, 0.7, 0.9, 1.0], [0.0, 0.001, -0.012, -0.10, -0.118, -0.122])
        return np.stack([x * r_x * t, top + y, zc + z * r_z * t], 1)

    mesh.add(surface("ceramic_white", basin, 16, 44, (1.4, 0.4), flip=True))

    def rim(u: Array, v: Array) -> Array:
        x, z = _rounded_ring(u, 1.0, 1.0, 3.2)
        ox, oz = np.clip(x * 3, -1, 1) * (width / 2 + 0.005), np.clip(z * 3, -1, 1) * (d / 2 + 0.005)
        t = np.clip(v / 0.85, 0, 1)
        drop = np.clip((v - 0.85) / 0.15, 0, 1) * 0.045
        px = x * r_x * 1.03 * (1 - t) + ox * t
        pz = (zc + z * r_z * 1.03) * (1 - t) + (d / 2 + oz) * t
        return np.stack([px, top - drop, pz], 1)

    mesh.add(surface("ceramic_white", rim, 10, 64, (2.0, 0.3)))
    mesh.add(cylinder("chrome", 0.024, 0.003, 18, 0.001).move(0, top - 0.1215, zc))
    tap = union(
        lathe("chrome", [(0, 0), (0.026, 0), (0.024, 0.01), (0.019, 0.014), (0.019, 0.12), (0, 0.125)], 20, 50),
        tube("chrome", curve((0, 0.10, 0), (0, 0.125, 0.06), (0, 0.11, 0.135), steps=5), 0.0105, 12),
    )
    tap.add(box("chrome", (0.018, 0.008, 0.075), 0.004, 2).rotate("x", -20).move(0, 0.14, 0.015))
    return mesh.add(tap.move(0, top, 0.055))


def mirror_cabinet(width: float, height: float) -> Mesh:
    """A mirror cabinet with a lamp above, its back at z = 0, centred in x and y."""
    mesh = box("white_lacquer", (width, height, 0.12), 0.004).move(0, 0, 0.06)
    for k in (-1, 1):
        mesh.add(box("mirror", (width / 2 - 0.004, height - 0.004, 0.006), 0.001).move(k * width / 4, 0, 0.124))
    mesh.add(box("chrome", (width * 0.7, 0.03, 0.10), 0.006, 2).move(0, height / 2 + 0.025, 0.08))
    return mesh.add(box("led", (width * 0.66, 0.012, 0.03), 0.004, 1).move(0, height / 2 + 0.006, 0.11))


def towel_radiator(width: float, height: float) -> Mesh:
    """A ladder radiator, back towards z = 0, bottom at y = 0."""
    mesh = Mesh()
    for x in (-width / 2, width / 2):
        mesh.add(tube("chrome", [(x, 0, 0.07), (x, height, 0.07)], 0.016, 12))
        for y in (0.12, height - 0.12):
            mesh.add(tube("chrome", [(x, y, 0), (x, y, 0.07)], 0.010, 8))
    rungs = [
        r
        for r in np.arange(0.05, height - 0.03, 0.052)
        if not (height * 0.36 < r < height * 0.42 or height * 0.68 < r < height * 0.74)
    ]
    for y in rungs:
        mesh.add(tube("chrome", [(-width / 2, float(y), 0.07), (width / 2, float(y), 0.07)], 0.0105, 8, caps=False))
    return mesh


def toilet_roll() -> Mesh:
    mesh = (
        lathe("paper", [(0.020, 0), (0.055, 0), (0.055, 0.10), (0.020, 0.10), (0.020, 0)], 28, 30)
        .rotate("z", 90)
        .move(0.05, 0, 0.075)
    )
    mesh.add(quad("paper", 0.10, 0.11).move(0, -0.055, 0.130))
    holder = tube(
        "chrome",
        curve((0.08, 0.0, 0.0), (0.08, 0.0, 0.05), (0.07, 0.0, 0.075), (-0.06, 0.0, 0.075), steps=5),
        0.006,
        10,
    )
    return mesh.add(holder, cylinder("chrome", 0.022, 0.008, 18, 0.002).rotate("x", 90).move(0.08, 0, 0))


def washing_machine() -> Mesh:
    mesh = box_at("plastic_white", (0.60, 0.85, 0.56), 0, 0, 0.28, 0.014, 3)
    mesh.add(
        lathe("chrome", [(0.215, 0), (0.215, 0.02), (0.19, 0.045), (0.165, 0.045), (0.16, 0.03)], 44, 50)
        .rotate("x", 90)
        .move(0, 0.42, 0.555)
    )
    mesh.add(
        lathe("screen_off", [(0.165, 0.03), (0.12, 0.018), (0.001, 0.012)], 40, 80).rotate("x", 90).move(0, 0.42, 0.556)
    )
    mesh.add(
        box_at("plastic_grey", (0.57, 0.10, 0.006), 0, 0.735, 0.559, 0.002),
        cylinder("chrome", 0.032, 0.022, 26, 0.005).rotate("x", 90).move(0.03, 0.785, 0.56),
    )
    mesh.add(
        box_at("screen_off", (0.13, 0.045, 0.004), 0.17, 0.765, 0.562, 0.001),
        box_at("plastic_white", (0.17, 0.08, 0.008), -0.19, 0.745, 0.561, 0.003),
    )
    return mesh


def pump_bottle(body: str, height: float = 0.16) -> Mesh:
    mesh = lathe(
        body,
        [
            (0, 0),
            (0.030, 0),
            (0.033, 0.005),
            (0.033, height * 0.66),
            (0.026, height * 0.74),
            (0.013, height * 0.78),
            (0, height * 0.78),
        ],
        22,
        50,
    )
    mesh.add(
        cylinder("painted_black", 0.014, height * 0.10, 14, 0.002).move(0, height * 0.77, 0),
        cylinder("painted_black", 0.005, height * 0.10, 8).move(0, height * 0.87, 0),
    )
    return mesh.add(
        tube(
            "painted_black", [(-0.008, height * 0.97, 0), (0.034, height * 0.97, 0), (0.04, height * 0.94, 0)], 0.006, 8
        ),
        lathe("label", [(0.0335, height * 0.2), (0.0335, height * 0.5)], 22),
    )


def toothbrush_cup() -> Mesh:
    mesh = lathe(
        "ceramic_sand",
        [(0, 0), (0.034, 0), (0.036, 0.004), (0.036, 0.10), (0.033, 0.10), (0.032, 0.008), (0, 0.008)],
        22,
        45,
    )
    for k, colour in enumerate(("linen_teal", "plastic_red")):
        lean = 0.03 * (1 if k else -1)
        mesh.add(
            tube("plastic_white", [(lean * 0.3, 0.01, 0), (lean, 0.19, 0.01)], 0.0042, 8),
            box(colour, (0.012, 0.028, 0.012), 0.003).move(lean + 0.008 * (1 if k else -1), 0.18, 0.01),
        )
    return mesh


def pedal_bin() -> Mesh:
    mesh = cylinder("steel", 0.11, 0.27, 30, 0.005)
    mesh.add(
        lathe("steel", [(0.112, 0.27), (0.108, 0.285), (0.06, 0.302), (0.0, 0.306)], 30, 60),
        cylinder("painted_black", 0.112, 0.012, 30),
    )
    return mesh.add(
        box("plastic_black", (0.06, 0.010, 0.05), 0.004).move(0, 0.015, 0.125),
        sphere("painted_black", 0.010, 10).move(0, 0.308, 0),
    )
