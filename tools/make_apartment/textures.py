# SPDX-License-Identifier: MIT
"""Procedural textures: tileable colour, height, roughness and occlusion maps from numpy.

Every function is pure: the same size and seed give the same arrays. Colours are sRGB values in 0..1; heights are in
millimetres.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Colour = tuple[float, float, float]


@dataclass
class Maps:
    """Maps of one material. height None means no normal map, roughness None none of occlusion, roughness and
    metallic."""

    colour: Array
    height: Array | None = None
    roughness: Array | None = None
    metallic: float = 0.0
    occlusion: Array | None = None


def noise(
    size: int,
    seed: int,
    exponent: float = 2.0,
    stretch: tuple[float, float] = (1.0, 1.0),
    low: float = 1.0,
    high: float = 1e9,
) -> Array:
    """Tileable noise with mean 0 and deviation 1: spectrum 1 / f^exponent between the frequencies low and high
    (cycles a tile).

    stretch multiplies the frequencies along x and y: (0.05, 1) makes streaks along x.
    """
    random = np.random.default_rng(seed)
    fx = np.fft.fftfreq(size, 1 / size)[None, :] / stretch[0]
    fy = np.fft.fftfreq(size, 1 / size)[:, None] / stretch[1]
    f = np.hypot(fx, fy)
    amplitude = np.where((f >= low) & (f <= high), np.maximum(f, 1e-9) ** -exponent, 0.0)
    white = np.fft.fft2(random.standard_normal((size, size)))
    result = np.real(np.fft.ifft2(white * amplitude))
    result -= result.mean()
    return result / max(float(result.std()), 1e-12)


def coordinates(size: int) -> tuple[Array, Array]:
    """x and y of the pixel centres in 0..1."""
    c = (np.arange(size) + 0.5) / size
    return np.meshgrid(c, c)


def lookup(image: Array, x: Array, y: Array) -> Array:
    """Bilinear, periodic sampling of an image at x, y in tiles."""
    h, w = image.shape[:2]
    px, py = x * w - 0.5, y * h - 0.5
    x0, y0 = np.floor(px).astype(np.int64), np.floor(py).astype(np.int64)
    fx, fy = px - x0, py - y0
    x1, y1 = (x0 + 1) % w, (y0 + 1) % h
    x0, y0 = x0 % w, y0 % h
    if image.ndim == 3:
        fx, fy = fx[..., None], fy[..., None]
    top = image[y0, x0] * (1 - fx) + image[y0, x1] * fx
    bottom = image[y1, x0] * (1 - fx) + image[y1, x1] * fx
    result: Array = top * (1 - fy) + bottom * fy
    return result


def smoothstep(low: float, high: float, value: Array) -> Array:
    t = np.clip((value - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def mix(a: Colour | Array, b: Colour | Array, t: NDArray[Any]) -> Array:
    result: Array = np.asarray(a) * (1 - t[..., None]) + np.asarray(b) * t[..., None]
    return result


def plain(size: int, colour: Colour) -> Array:
    return np.broadcast_to(np.asarray(colour, dtype=float), (size, size, 3)).copy()


def wood(size: int, seed: int, light: Colour, dark: Colour, contrast: float = 1.0, gloss: float = 0.45) -> Maps:
    """Straight-grained wood, grain along x: growth rings cut lengthways, pores and slow changes of tone."""
    x, y = coordinates(size)
    bend = noise(size, seed, 2.4, (0.25, 1.0), high=8) * 0.035
    rings = (y + bend) * 9 + noise(size, seed + 1, 2.0, (0.12, 1.0), high=16) * 0.25
    band = 0.5 + 0.5 * np.sin(2 * math.pi * rings)
    band = band**1.6
    fine = noise(size, seed + 2, 0.9, (0.02, 1.0), low=6)
    pores = smoothstep(1.1, 2.4, noise(size, seed + 3, 0.35, (0.03, 1.0), low=10))
    tone = np.clip(0.30 + 0.38 * band + 0.11 * fine + 0.10 * noise(size, seed + 4, 2.5, high=6), 0, 1)
    tone = np.clip(0.5 + (tone - 0.5) * contrast, 0, 1)
    colour = mix(light, dark, tone) * (1 - 0.28 * pores)[..., None]
    height = -0.05 * pores + 0.012 * fine - 0.02 * band
    return Maps(np.clip(colour, 0, 1), height, np.clip(gloss + 0.07 * fine + 0.18 * pores, 0.05, 1))


def planks(size: int, seed: int, light: Colour, dark: Colour, rows: int = 12, mean_length: float = 0.55) -> Maps:
    """A strip floor: boards along x, each with its own piece of wood, bevelled joints."""
    random = np.random.default_rng(seed)
    base = wood(size, seed + 5, light, dark, 0.9, 0.36)
    assert base.height is not None and base.roughness is not None
    x, y = coordinates(size)
    row = np.minimum((y * rows).astype(np.int64), rows - 1)
    in_row = y * rows - row
    colour, height, rough = np.zeros((size, size, 3)), np.zeros((size, size)), np.zeros((size, size))
    gap_x = np.ones((size, size))
    for r in range(rows):
        cuts = [float(random.uniform(0, 0.4))]
        while cuts[-1] + mean_length * 0.65 < cuts[0] + 1 - mean_length * 0.35:
            cuts.append(cuts[-1] + mean_length * float(random.uniform(0.7, 1.25)))
        if cuts[0] + 1 - cuts[-1] < 0.18:
            cuts.pop()
        ends = [*cuts[1:], cuts[0] + 1]
        for start, end in zip(cuts, ends, strict=True):
            local = (x - start) % 1.0
            mask = (row == r) & (local < end - start)
            ox, oy = random.uniform(size=2)
            tone = 1 + random.normal() * 0.085
            tint = np.array([1 + random.normal() * 0.012, 1.0, 1 - abs(random.normal()) * 0.03])
            flip = -1.0 if random.uniform() < 0.5 else 1.0
            sx, sy = ox + flip * local[mask], oy + in_row[mask] / rows * 1.0
            colour[mask] = np.clip(lookup(base.colour, sx, sy) * tone * tint, 0, 1)
            height[mask] = lookup(base.height, sx, sy)
            rough[mask] = lookup(base.roughness, sx, sy) + random.normal() * 0.02
            gap_x[mask] = np.minimum(local[mask], end - start - local[mask])
    edge = np.minimum(gap_x * size, np.minimum(in_row, 1 - in_row) / rows * size)
    joint = 1 - smoothstep(0.6, 2.2, edge)
    colour *= (1 - 0.62 * joint)[..., None]
    return Maps(colour, height - 0.35 * joint, np.clip(rough + 0.3 * joint, 0, 1), occlusion=1 - 0.5 * joint)


def plaster(size: int, seed: int, roughness: float = 0.85) -> Maps:
    """White painted plaster with the orange-peel of a roller."""
    fine = noise(size, seed, 0.6, low=30, high=180)
    slow = noise(size, seed + 1, 2.0, high=12)
    return Maps(
        np.clip(plain(size, (0.93, 0.93, 0.925)) * (1 + 0.008 * slow + 0.004 * fine)[..., None], 0, 1),
        0.05 * fine + 0.05 * slow,
        np.full((size, size), roughness),
    )


def tiles(
    size: int,
    seed: int,
    nx: int,
    ny: int,
    grout: Colour,
    body: Array,
    gap: float = 0.012,
    offset: float = 0.0,
    variation: float = 0.03,
    gloss: float = 0.12,
) -> Maps:
    """nx x ny tiles cut from the image `body`, with rounded edges and rough grout; offset shifts every second row
    (0.5 is a brick bond)."""
    random = np.random.default_rng(seed)
    x, y = coordinates(size)
    row = np.minimum((y * ny).astype(np.int64), ny - 1)
    sx = (x * nx + offset * (row % 2)) % nx
    column = np.minimum(sx.astype(np.int64), nx - 1)
    u, v = sx - column, y * ny - row
    edge = np.minimum(np.minimum(u, 1 - u) / nx, np.minimum(v, 1 - v) / ny)
    inside = smoothstep(gap * 0.45, gap * 0.75, edge)
    tone = 1 + variation * random.standard_normal((ny, nx))[row, column]
    shift = random.uniform(size=(ny, nx, 2))[row, column]
    picked = lookup(body, x + shift[..., 0], y + shift[..., 1]) * tone[..., None]
    grain = noise(size, seed + 1, 0.6, low=20)
    mortar = np.asarray(grout) * (1 + 0.06 * grain)[..., None]
    colour = np.clip(mix(mortar, picked, inside), 0, 1)
    tilt = random.normal(size=(ny, nx, 2))[row, column] * 0.12
    height = smoothstep(gap * 0.4, gap * 1.4, edge) * 1.0 + inside * (
        tilt[..., 0] * (u - 0.5) + tilt[..., 1] * (v - 0.5)
    )
    rough = 0.85 * (1 - inside) + inside * (gloss + 0.02 * grain)
    return Maps(colour, height + (1 - inside) * 0.04 * grain, np.clip(rough, 0.04, 1), occlusion=0.6 + 0.4 * inside)


def marble(size: int, seed: int, base: Colour, vein: Colour, gloss: float = 0.14) -> Maps:
    """Polished marble: veins along the zero lines of warped noise."""
    x, y = coordinates(size)
    wx, wy = noise(size, seed, 2.2, high=24) * 0.05, noise(size, seed + 1, 2.2, high=24) * 0.05
    total = np.zeros((size, size))
    for k, (exponent, width, weight) in enumerate(((2.2, 0.035, 0.85), (1.9, 0.05, 0.45), (1.6, 0.07, 0.25))):
        field = lookup(noise(size, seed + 2 + k, exponent, high=10 + 14 * k), x + wx, y + wy)
        strength = 0.35 + 0.65 * smoothstep(-0.8, 1.2, noise(size, seed + 12 + k, 2.0, high=8))
        total += weight * strength * np.exp(-np.abs(field) / width)
    cloud = 0.10 * smoothstep(-1.5, 2.0, noise(size, seed + 9, 2.0, high=20))
    colour = mix(base, vein, np.clip(total * 0.75 + cloud, 0, 1))
    return Maps(np.clip(colour, 0, 1), None, np.clip(gloss + 0.1 * total, 0.05, 1) * np.ones((size, size)))


def weave(
    size: int,
    seed: int,
    colour: Colour,
    threads: int = 64,
    contrast: float = 0.35,
    slub: float = 0.5,
    second: Colour | None = None,
) -> Maps:
    """Plain-woven cloth: warp over weft in a checkerboard, threads of uneven thickness and tone."""
    x, y = coordinates(size)
    jx = noise(size, seed, 1.5, (1.0, 0.1), high=40) * 0.0012
    jy = noise(size, seed + 1, 1.5, (0.1, 1.0), high=40) * 0.0012
    a, b = (x + jx) * threads, (y + jy) * threads
    over = (np.floor(a).astype(np.int64) + np.floor(b).astype(np.int64)) % 2
    profile_a, profile_b = np.sin(math.pi * (a % 1.0)), np.sin(math.pi * (b % 1.0))
    bump = np.where(
        over == 0,
        profile_a * (0.55 + 0.45 * np.sin(math.pi * (b % 1.0))),
        profile_b * (0.55 + 0.45 * np.sin(math.pi * (a % 1.0))),
    )
    warp = noise(size, seed + 2, 0.6, (1.0, 0.02), low=4)
    weft = noise(size, seed + 3, 0.6, (0.02, 1.0), low=4)
    tone = 1 + 0.07 * slub * np.where(over == 0, warp, weft) + 0.03 * noise(size, seed + 4, 0.3, low=30)
    tone = tone * (1 - contrast + contrast * bump)
    tint = (
        plain(size, colour)
        if second is None
        else np.where((over == 0)[..., None], np.asarray(colour), np.asarray(second))
    )
    return Maps(
        np.clip(tint * tone[..., None], 0, 1), bump * 0.35, np.full((size, size), 0.92), occlusion=0.55 + 0.45 * bump
    )


def boucle(size: int, seed: int, colour: Colour) -> Maps:
    """Looped wool: rounded blobs at two scales."""
    a = noise(size, seed, 0.4, low=28, high=60)
    b = noise(size, seed + 1, 0.3, low=60, high=130)
    height = smoothstep(-1.6, 1.6, a * 0.75 + b * 0.45)
    tone = 0.62 + 0.4 * height + 0.02 * noise(size, seed + 2, 1.0)
    return Maps(
        np.clip(plain(size, colour) * tone[..., None], 0, 1),
        height * 0.9,
        np.full((size, size), 0.97),
        occlusion=0.5 + 0.5 * height,
    )


def leather(size: int, seed: int, colour: Colour) -> Maps:
    """Grained leather: a net of fine creases."""
    a = np.abs(noise(size, seed, 0.8, low=22, high=60))
    b = np.abs(noise(size, seed + 1, 0.6, low=50, high=130))
    crease = 1 - np.minimum(smoothstep(0.0, 0.55, a), smoothstep(0.0, 0.4, b) * 0.5 + 0.5)
    wear = noise(size, seed + 2, 2.2, high=12)
    result = plain(size, colour) * (1 - 0.35 * crease + 0.05 * wear)[..., None]
    return Maps(np.clip(result, 0, 1), -0.25 * crease, np.clip(0.48 + 0.2 * crease - 0.05 * wear, 0.2, 1))


def brushed(size: int, seed: int, colour: Colour, roughness: float = 0.3) -> Maps:
    """Brushed metal, brushed along x."""
    streak = noise(size, seed, 0.3, (0.01, 1.0), low=4)
    slow = noise(size, seed + 1, 2.0, high=6)
    return Maps(
        np.clip(plain(size, colour) * (1 + 0.015 * streak)[..., None], 0, 1),
        0.006 * streak,
        np.clip(roughness + 0.05 * streak + 0.02 * slow, 0.05, 1),
        metallic=1.0,
    )


def speckle(
    size: int, seed: int, colour: Colour, spot: Colour, amount: float = 0.5, roughness: float = 0.6, bump: float = 0.1
) -> Maps:
    """A plain colour with soft spots: fruit, stone, soil, cork."""
    n = noise(size, seed, 0.8, low=6, high=90)
    slow = noise(size, seed + 1, 2.0, high=10)
    t = np.clip(smoothstep(0.2, 1.8, n) * amount + 0.15 * slow * amount, 0, 1)
    return Maps(np.clip(mix(colour, spot, t), 0, 1), n * bump, np.full((size, size), roughness))


def grass(size: int, seed: int) -> Maps:
    n = noise(size, seed, 0.5, (1.0, 0.35), low=16)
    m = noise(size, seed + 1, 1.6, high=14)
    t = np.clip(0.5 + 0.22 * n + 0.16 * m, 0, 1)
    return Maps(np.clip(mix((0.16, 0.25, 0.07), (0.44, 0.53, 0.20), t), 0, 1), n * 4.0, np.full((size, size), 0.95))


def brick(size: int, seed: int) -> Maps:
    body = mix((0.52, 0.27, 0.19), (0.70, 0.42, 0.30), np.clip(0.5 + 0.25 * noise(size, seed, 1.2, low=4), 0, 1))
    return tiles(size, seed, 4, 12, (0.66, 0.63, 0.58), body, 0.012, 0.5, 0.10, 0.85)


def stripes(size: int, seed: int, colours: list[Colour], widths: list[float]) -> Maps:
    """Woven stripes across x in the given shares of a tile."""
    base = weave(size, seed, (1.0, 1.0, 1.0), 96, 0.3)
    x, _ = coordinates(size)
    edges = np.cumsum(widths) / sum(widths)
    index = np.minimum(np.searchsorted(edges, x[0]), len(colours) - 1)
    tint = np.asarray(colours)[index][None, :, :]
    return Maps(np.clip(base.colour * tint, 0, 1), base.height, base.roughness, occlusion=base.occlusion)


def leaf(size: int, seed: int, light: Colour, dark: Colour) -> Maps:
    """A leaf from base (x = 0) to tip (x = 1), midrib at y = 0.5, side veins at an angle."""
    x, y = coordinates(size)
    off = np.abs(y - 0.5) * 2
    rib = np.exp(-off / 0.035)
    side = np.exp(-np.abs(((x - off * 0.28) * 11) % 1.0 - 0.5) / 0.07) * smoothstep(0.0, 0.12, off) * 0.55
    t = np.clip(0.42 + 0.10 * noise(size, seed, 1.6, high=60) + 0.18 * off - 0.55 * rib - 0.35 * side, 0, 1)
    return Maps(np.clip(mix(light, dark, t), 0, 1), 0.5 * rib + 0.25 * side, np.clip(0.42 + 0.1 * t, 0, 1))
