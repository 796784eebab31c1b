# SPDX-License-Identifier: MIT
"""Images that are used once, from corner to corner: paintings, rugs, book spines, a clock face, a globe, screens."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw

from textures import Array, Colour, Maps, coordinates, mix, noise, smoothstep, weave


def canvas_texture(image: Array, seed: int, roughness: float = 0.75) -> Maps:
    """Puts paint strokes and the weave of canvas on a painting."""
    size = image.shape[0]
    strokes = noise(size, seed, 1.0, (0.35, 1.0), low=12, high=140)
    cloth = weave(size, seed + 1, (1.0, 1.0, 1.0), 160, 0.5)
    assert cloth.height is not None
    return Maps(
        np.clip(image * (1 + 0.035 * strokes)[..., None], 0, 1),
        0.12 * strokes + 0.3 * cloth.height,
        np.full((size, size), roughness),
    )


def landscape(size: int, seed: int) -> Maps:
    """Hills in the haze under an evening sky."""
    x, y = coordinates(size)
    glow = np.exp(-(((x - 0.68) / 0.35) ** 2 + ((y - 0.42) / 0.22) ** 2))
    sky = mix(
        (0.30, 0.45, 0.62),
        (0.95, 0.78, 0.58),
        np.clip(y * 1.7 + 0.10 * noise(size, seed, 1.8, (0.4, 1.0), high=30), 0, 1),
    )
    image = mix(sky, (1.0, 0.93, 0.76), np.clip(glow * 0.8, 0, 1))
    disc = smoothstep(0.052, 0.047, np.hypot(x - 0.68, y - 0.38))
    image = mix(image, (1.0, 0.96, 0.84), disc)
    layers: list[Colour] = [
        (0.62, 0.62, 0.66),
        (0.46, 0.52, 0.55),
        (0.33, 0.43, 0.42),
        (0.22, 0.32, 0.26),
        (0.13, 0.20, 0.15),
    ]
    for k, colour in enumerate(layers):
        ridge = noise(size, seed + 10 + k, 1.7, high=40)[0] * (0.035 + 0.012 * k)
        level = 0.46 + 0.115 * k + ridge[None, :]
        tone = mix(colour, (0.85, 0.72, 0.55), np.clip(0.30 * np.exp(-(y - level) / 0.08) * (1 - k / 5), 0, 1))
        image = mix(
            image,
            tone * (1 + 0.06 * noise(size, seed + 20 + k, 1.2, (0.5, 1.0), low=4))[..., None],
            smoothstep(0.0, 0.006, y - level),
        )
    return canvas_texture(np.clip(image, 0, 1), seed + 40)


def abstract(size: int, seed: int, background: Colour, colours: list[Colour]) -> Maps:
    """Flat overlapping shapes in the manner of mid-century prints."""
    random = np.random.default_rng(seed)
    x, y = coordinates(size)
    wobble = noise(size, seed, 2.0, high=30) * 0.004
    image = np.broadcast_to(np.asarray(background), (size, size, 3)).copy()
    for k in range(9):
        colour = colours[k % len(colours)]
        cx, cy, r = random.uniform(0.2, 0.8), random.uniform(0.2, 0.8), random.uniform(0.08, 0.26)
        angle = random.uniform(0, math.pi)
        dx, dy = x - cx + wobble, y - cy + wobble
        u, v = dx * math.cos(angle) + dy * math.sin(angle), -dx * math.sin(angle) + dy * math.cos(angle)
        kind = k % 3
        if kind == 0:
            inside = smoothstep(0.003, -0.003, np.hypot(u, v) - r)
        elif kind == 1:
            inside = smoothstep(0.003, -0.003, np.maximum(np.abs(u) - r * 1.2, np.abs(v) - r * 0.35))
        else:
            inside = smoothstep(0.003, -0.003, np.hypot(u, v) - r) * smoothstep(-0.003, 0.003, v)
        image = mix(image, np.asarray(colour), inside * 0.9)
    margin = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    image = mix((0.94, 0.92, 0.87), image, smoothstep(0.055, 0.06, margin))
    return canvas_texture(image, seed + 3)


def botanical(size: int, seed: int) -> Maps:
    """A fern on paper: stem and paired leaves drawn as polygons."""
    scale = 2
    picture = Image.new("RGB", (size * scale, size * scale), (238, 232, 217))
    draw = ImageDraw.Draw(picture)
    s = size * scale
    random = np.random.default_rng(seed)

    def blade(px: float, py: float, angle: float, length: float, width: float, fill: tuple[int, int, int]) -> None:
        left, right = [], []
        for t in np.linspace(0, 1, 14):
            w = width * math.sin(math.pi * t) ** 0.8
            bend = angle + 0.35 * t * math.copysign(1, math.cos(angle))
            qx, qy = px + length * t * math.cos(bend), py - length * t * math.sin(bend)
            left.append((qx - w * math.sin(bend), qy - w * math.cos(bend)))
            right.append((qx + w * math.sin(bend), qy + w * math.cos(bend)))
        draw.polygon(left + right[::-1], fill=fill)

    for k in range(15):
        t = k / 14
        px, py = s * (0.5 + 0.04 * math.sin(3 * t)), s * (0.88 - 0.74 * t)
        for side in (-1, 1):
            angle = math.pi / 2 - side * (1.05 - 0.35 * t)
            green = 70 + int(random.integers(0, 40))
            blade(
                px,
                py,
                angle,
                s * 0.27 * (1 - t) ** 0.7 + s * 0.03,
                s * 0.028 * (1 - 0.6 * t),
                (40 + green // 4, green + 22, 52),
            )
    stem = [(s * (0.5 + 0.04 * math.sin(3 * t)), s * (0.93 - 0.80 * t)) for t in np.linspace(0, 1, 40)]
    draw.line(stem, fill=(66, 84, 44), width=max(2, s // 220))
    image = np.asarray(picture.resize((size, size), Image.Resampling.LANCZOS), dtype=float) / 255
    paper = 1 + 0.012 * noise(size, seed + 1, 1.0)
    return Maps(np.clip(image * paper[..., None], 0, 1), None, np.full((size, size), 0.8))


def waves_print(size: int, seed: int) -> Maps:
    """Concentric arcs in blues, row behind row."""
    x, y = coordinates(size)
    image = np.broadcast_to(np.array([0.93, 0.90, 0.83]), (size, size, 3)).copy()
    blues: list[Colour] = [(0.12, 0.24, 0.38), (0.22, 0.42, 0.56), (0.52, 0.68, 0.74), (0.90, 0.88, 0.82)]
    rows, columns = 9, 6
    for r in range(rows + 2):
        cy = 0.22 + r * 0.95 / rows
        for c in range(columns + 2):
            cx = (c - 0.5 + 0.5 * (r % 2)) / columns
            d = np.hypot(x - cx, y - cy) * columns
            band = np.minimum((d * 7.5).astype(np.int64), 3)
            inside = smoothstep(0.585, 0.575, d) * smoothstep(0.14, 0.16, y)
            ring = np.asarray(blues)[(band * 2 + 0) % 4 if r % 2 else (band + 1) % 4]
            image = mix(image, ring, inside)
    margin = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    return canvas_texture(mix((0.94, 0.92, 0.87), image, smoothstep(0.06, 0.065, margin)), seed)


def rug(size: int, seed: int, ground: Colour, accent: Colour, line: Colour) -> Maps:
    """A woven rug with a border, diamonds and knots."""
    x, y = coordinates(size)
    margin = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    image = np.broadcast_to(np.asarray(ground), (size, size, 3)).copy()
    u, v = (x * 6) % 1.0 - 0.5, (y * 9) % 1.0 - 0.5
    diamond = np.abs(u) + np.abs(v)
    image = mix(image, accent, smoothstep(0.02, -0.02, np.abs(diamond - 0.36) - 0.05))
    image = mix(image, line, smoothstep(0.02, -0.02, diamond - 0.13))
    zig = np.abs(((x * 6 + 0.5) % 1.0) - 0.5) * 2 / 9
    image = mix(image, line, smoothstep(0.003, -0.003, np.abs((y * 1.0 - zig * 0.3) % (1 / 9) - 0.004) - 0.004) * 0.6)
    for inner, outer, colour in (
        (0.075, 0.085, line),
        (0.035, 0.075, accent),
        (0.028, 0.035, line),
        (0.0, 0.028, ground),
    ):
        image = mix(image, colour, smoothstep(inner - 0.002, inner, margin) * smoothstep(outer, outer - 0.002, margin))
    teeth = np.abs(((x + y) * 30) % 1.0 - 0.5)
    image = mix(
        image,
        ground,
        smoothstep(0.22, 0.18, teeth) * smoothstep(0.040, 0.042, margin) * smoothstep(0.070, 0.068, margin),
    )
    pile = noise(size, seed, 0.4, low=60)
    rows = 0.5 + 0.5 * np.sin(2 * math.pi * y * 170)
    fade = 1 + 0.05 * noise(size, seed + 1, 2.0, high=12) + 0.05 * pile
    return Maps(
        np.clip(image * (fade * (0.86 + 0.14 * rows))[..., None], 0, 1),
        0.5 * rows + 0.3 * pile,
        np.full((size, size), 0.97),
    )


BOOK_CELLS = 8


def book_spines(size: int, seed: int) -> Maps:
    """An atlas of BOOK_CELLS columns: cloth spines with bands and title bars, read from top to bottom."""
    random = np.random.default_rng(seed)
    x, y = coordinates(size)
    palette: list[Colour] = [
        (0.55, 0.16, 0.13),
        (0.13, 0.24, 0.38),
        (0.17, 0.33, 0.25),
        (0.80, 0.70, 0.50),
        (0.22, 0.20, 0.22),
        (0.74, 0.46, 0.18),
        (0.85, 0.82, 0.75),
        (0.40, 0.24, 0.36),
    ]
    image = np.zeros((size, size, 3))
    for k in range(BOOK_CELLS):
        local = x * BOOK_CELLS - k
        mask = (local >= 0) & (local < 1)
        ink: Colour = (0.88, 0.76, 0.45) if sum(palette[k]) < 1.6 else (0.20, 0.16, 0.14)
        cell = np.broadcast_to(np.asarray(palette[k]), (size, size, 3)).copy()
        for level in (0.06, 0.09, 0.90, 0.93):
            cell = mix(cell, ink, smoothstep(0.004, 0.002, np.abs(y - level)))
        # Lettering reads as words from a metre away: bars of different lengths down the spine.
        top = 0.16
        while top < 0.62:
            length = float(random.uniform(0.03, 0.09))
            letters = (np.sin(y * size * 0.55) > -0.35) & (np.sin(y * size * 1.31 + k) > -0.8)
            bar = (np.abs(local - 0.5) < 0.17) & (y > top) & (y < top + length) & letters
            cell = mix(cell, ink, bar * 0.85)
            top += length + 0.025
        cell = mix(cell, ink, ((np.abs(local - 0.5) < 0.14) & (np.abs(y - 0.80) < 0.012)) * 0.8)
        image[mask] = cell[mask]
    cloth = noise(size, seed + 1, 0.3, low=40)
    return Maps(np.clip(image * (1 + 0.05 * cloth)[..., None], 0, 1), 0.08 * cloth, np.full((size, size), 0.7))


def clock_face(size: int, seed: int) -> Maps:
    scale = 4
    s = size * scale
    picture = Image.new("RGB", (s, s), (244, 241, 234))
    draw = ImageDraw.Draw(picture)
    for k in range(60):
        a = 2 * math.pi * k / 60
        inner, width = (0.40, s // 70) if k % 5 == 0 else (0.44, s // 220)
        draw.line(
            [
                (s * (0.5 + inner * math.sin(a)), s * (0.5 - inner * math.cos(a))),
                (s * (0.5 + 0.465 * math.sin(a)), s * (0.5 - 0.465 * math.cos(a))),
            ],
            fill=(34, 32, 30),
            width=width,
        )
    return Maps(np.asarray(picture.resize((size, size), Image.Resampling.LANCZOS), dtype=float) / 255, None, None)


def globe(size: int, seed: int) -> Maps:
    """Invented continents on a sea, for a sphere: u once round, v from pole to pole."""
    x, y = coordinates(size)
    land = noise(size, seed, 1.9, high=50) + 0.25 * np.cos((y - 0.45) * 2 * math.pi) - 0.15
    height = smoothstep(0.18, 0.24, land)
    sea = mix((0.30, 0.47, 0.55), (0.42, 0.60, 0.64), np.clip(0.5 + land * 0.6, 0, 1))
    ground = mix((0.72, 0.66, 0.44), (0.45, 0.52, 0.30), np.clip(0.5 + 0.3 * noise(size, seed + 1, 1.6, high=40), 0, 1))
    image = mix(sea, ground, height)
    image = mix(image, (0.33, 0.28, 0.22), np.exp(-np.abs(land - 0.21) / 0.016) * 0.8)
    grid = np.minimum(np.abs((x * 24) % 1.0 - 0.5), np.abs((y * 12) % 1.0 - 0.5) * 0.5)
    image = mix(
        image,
        (0.36, 0.32, 0.27),
        smoothstep(0.488, 0.495, np.maximum(np.abs((x * 24) % 1.0 - 0.5), np.abs((y * 12) % 1.0 - 0.5))) * 0.35
        + 0 * grid,
    )
    return Maps(np.clip(image, 0, 1), None, np.full((size, size), 0.42))


def screen(size: int, seed: int) -> Maps:
    """A desktop: an editor with coloured lines of text beside a plot."""
    s = size * 2
    random = np.random.default_rng(seed)
    picture = Image.new("RGB", (s, s), (30, 34, 42))
    draw = ImageDraw.Draw(picture)
    draw.rectangle([0, 0, s, s * 0.045], fill=(22, 25, 31))
    draw.rectangle([0, s * 0.045, s * 0.13, s], fill=(26, 30, 37))
    colours = [(198, 208, 245), (166, 209, 137), (239, 159, 118), (140, 170, 238), (202, 158, 230), (115, 121, 148)]
    for row in range(34):
        y = s * (0.07 + 0.0262 * row)
        x = s * (0.16 + 0.02 * int(random.integers(0, 4)))
        for _ in range(int(random.integers(1, 6))):
            w = s * float(random.uniform(0.02, 0.09))
            if x + w > s * 0.58:
                break
            draw.rectangle([x, y, x + w, y + s * 0.011], fill=colours[int(random.integers(0, 6))])
            x += w + s * 0.012
    for row in range(16):
        draw.rectangle(
            [
                s * 0.02,
                s * (0.08 + 0.03 * row),
                s * (0.05 + float(random.uniform(0.01, 0.06))),
                s * (0.09 + 0.03 * row),
            ],
            fill=(98, 104, 128),
        )
    draw.rectangle([s * 0.61, s * 0.07, s * 0.975, s * 0.50], fill=(239, 241, 245))
    for k, colour in enumerate(((30, 102, 245), (223, 142, 29), (64, 160, 43))):
        points = []
        for t in np.linspace(0, 1, 60):
            points.append(
                (
                    s * (0.63 + 0.325 * t),
                    s
                    * (
                        0.46
                        - 0.34 * (1 - math.exp(-t * (2 + k * 1.5))) * (0.6 + 0.18 * k)
                        - 0.008 * math.sin(t * 40 + k * 2)
                    ),
                )
            )
        draw.line(points, fill=colour, width=s // 170)
    for k in range(3):
        tone = 60 + 40 * k
        draw.rectangle([s * (0.61 + 0.125 * k), s * 0.54, s * (0.72 + 0.125 * k), s * 0.68], fill=(tone, 120, 150))
    image = np.asarray(picture.resize((size, size), Image.Resampling.LANCZOS), dtype=float) / 255
    return Maps(image, None, None)
