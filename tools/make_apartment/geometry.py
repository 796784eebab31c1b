# SPDX-License-Identifier: MIT
"""Triangle meshes from numpy: bevelled boxes, lathes, tubes, cloth and other surfaces, all in metres and Y up.

A `Part` is a run of triangles of one material, a `Mesh` a list of parts. Texture coordinates are in metres on the
surface (the material divides them by the size of its tile), unless a builder says that they run from 0 to 1.
Triangles are counter-clockwise seen from outside, as in glTF.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass
class Part:
    """Triangles of one material: positions (n, 3), normals (n, 3), uv (n, 2), triangles (m, 3)."""

    material: str
    positions: Array
    normals: Array
    uv: Array
    triangles: NDArray[np.int64]


@dataclass
class Mesh:
    """Parts that make up one object. Transforming methods change the mesh in place and return it."""

    parts: list[Part] = field(default_factory=list)

    def add(self, *others: Mesh) -> Mesh:
        for other in others:
            self.parts.extend(other.parts)
        return self

    def copy(self) -> Mesh:
        return Mesh(
            [
                Part(p.material, p.positions.copy(), p.normals.copy(), p.uv.copy(), p.triangles.copy())
                for p in self.parts
            ]
        )

    def move(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Mesh:
        for part in self.parts:
            part.positions = part.positions + np.array([x, y, z])
        return self

    def scale(self, x: float, y: float | None = None, z: float | None = None) -> Mesh:
        factors = np.array([x, x if y is None else y, x if z is None else z])
        for part in self.parts:
            part.positions = part.positions * factors
            part.normals = normalize(part.normals / factors)
            if np.prod(factors) < 0:
                part.triangles = part.triangles[:, ::-1]
        return self

    def rotate(self, axis: str, degrees: float) -> Mesh:
        angle = math.radians(degrees)
        c, s = math.cos(angle), math.sin(angle)
        matrix = {
            "x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]),
            "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
            "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]),
        }[axis]
        for part in self.parts:
            part.positions = part.positions @ matrix.T
            part.normals = part.normals @ matrix.T
        return self

    def map_uv(self, function: Callable[[Array], Array]) -> Mesh:
        for part in self.parts:
            part.uv = function(part.uv)
        return self

    def displace(self, function: Callable[[Array, Array], Array]) -> Mesh:
        """Moves every vertex to function(positions, normals) and computes smooth normals again."""
        for part in self.parts:
            part.positions = function(part.positions, part.normals)
            part.normals = smooth_normals(part.positions, part.triangles, part.normals)
        return self

    def bounds(self) -> tuple[Array, Array]:
        points = np.concatenate([p.positions for p in self.parts])
        return points.min(axis=0), points.max(axis=0)

    @property
    def triangle_count(self) -> int:
        return sum(len(p.triangles) for p in self.parts)

    def merged(self) -> list[Part]:
        """The parts joined by material, in order of first use."""
        groups: dict[str, list[Part]] = {}
        for part in self.parts:
            groups.setdefault(part.material, []).append(part)
        result = []
        for material, parts in groups.items():
            offsets = np.cumsum([0] + [len(p.positions) for p in parts[:-1]])
            result.append(
                Part(
                    material,
                    np.concatenate([p.positions for p in parts]),
                    np.concatenate([p.normals for p in parts]),
                    np.concatenate([p.uv for p in parts]),
                    np.concatenate([p.triangles + o for p, o in zip(parts, offsets, strict=True)]),
                )
            )
        return result


def union(*meshes: Mesh) -> Mesh:
    return Mesh().add(*meshes)


def normalize(vectors: Array) -> Array:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length < 1e-12, 1.0, length)


def smooth_normals(positions: Array, triangles: NDArray[np.int64], guide: Array | None = None) -> Array:
    """Area-weighted vertex normals; vertices at one place share one, unless `guide` says they were meant to differ by
    over 60 degrees."""
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    face = np.cross(b - a, c - a)
    keys = np.round(positions * 20000).astype(np.int64)
    if guide is not None:
        keys = np.concatenate([keys, np.round(guide * 1.2).astype(np.int64)], axis=1)
    _, inverse = np.unique(keys, axis=0, return_inverse=True)
    inverse = inverse.reshape(-1)
    total = np.zeros((inverse.max() + 1, 3))
    for k in range(3):
        np.add.at(total, inverse[triangles[:, k]], face)
    result = normalize(total)[inverse]
    if guide is not None:
        degenerate = np.linalg.norm(total[inverse], axis=1) < 1e-14
        result[degenerate] = guide[degenerate]
    return result


def grid_triangles(rows: int, columns: int) -> NDArray[np.int64]:
    """Two triangles for each cell of a rows x columns grid of vertices in row-major order."""
    r, c = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    i = (r * columns + c).reshape(-1)
    return np.stack(
        [np.stack([i, i + 1, i + columns + 1], 1), np.stack([i, i + columns + 1, i + columns], 1)], 1
    ).reshape(-1, 3)


def box_uv(positions: Array, axis: int, grain: int) -> Array:
    """Planar coordinates in metres on faces whose normal is along `axis`; U runs along the axis `grain` where the
    face has it."""
    others = [k for k in range(3) if k != axis]
    u = grain if grain in others else next(k for k in others if k != 1)
    v = next(k for k in others if k != u)
    return np.stack([positions[:, u], -positions[:, v] if v == 1 else positions[:, v]], axis=1)


def box(
    material: str,
    size: Sequence[float],
    radius: float = 0.004,
    segments: int = 1,
    grain: str = "x",
    flat: int = 0,
    grain_shift: bool = True,
) -> Mesh:
    """A box of the given size centred at the origin with rounded edges.

    radius 0 gives sharp edges (24 vertices); segments is the number of steps of each half edge; flat adds that many
    vertices
    inside each flat side, for displacement.
    """
    half = np.array(size, dtype=float) / 2
    radius = min(radius, float(half.min()) * 0.999)
    inner = half - radius
    angles = np.linspace(-math.pi / 4, 0, segments + 1) if radius > 0 else np.zeros(1)
    parts = []
    g = "xyz".index(grain)
    # Boxes of different sizes start at different places of the texture, so that a row of boards does not repeat itself.
    shift = (half[0] * 7.3 + half[1] * 3.1 + half[2] * 1.7) % 1.0 if grain_shift else 0.0
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for sign in (1.0, -1.0):

            def samples(k: int) -> tuple[Array, Array]:
                tangent = np.concatenate([np.tan(angles), np.zeros(flat), -np.tan(angles[::-1])])
                centre = np.concatenate(
                    [
                        np.full(len(angles), -inner[k]),
                        np.linspace(-inner[k], inner[k], flat + 2)[1:-1],
                        np.full(len(angles), inner[k]),
                    ]
                )
                return tangent, centre

            tu, cu = samples(u)
            tv, cv = samples(v)
            gu, gv = np.meshgrid(np.arange(len(tu)), np.arange(len(tv)), indexing="ij")
            direction = np.zeros((gu.size, 3))
            direction[:, axis] = 1.0
            direction[:, u] = tu[gu].reshape(-1)
            direction[:, v] = tv[gv].reshape(-1)
            direction = normalize(direction)
            centre = np.zeros((gu.size, 3))
            centre[:, axis] = inner[axis]
            centre[:, u] = cu[gu].reshape(-1)
            centre[:, v] = cv[gv].reshape(-1)
            positions = centre + radius * direction
            triangles = grid_triangles(len(tu), len(tv))
            # Rows run along u, columns along v: the grid's own orientation is -axis.
            triangles = triangles[:, ::-1]
            if sign < 0:
                positions[:, axis] *= -1
                direction[:, axis] *= -1
                triangles = triangles[:, ::-1]
            parts.append(Part(material, positions, direction, box_uv(positions, axis, g) + shift, triangles))
    return Mesh(parts)


def soft_box(
    material: str,
    size: Sequence[float],
    radius: float,
    puff: float,
    flat: int = 8,
    segments: int = 3,
    wrinkle: float = 0.0,
    seed: int = 0,
) -> Mesh:
    """A cushion: a rounded box whose sides bulge by `puff` metres, with low waves of `wrinkle` metres."""
    mesh = box(material, size, radius, segments, flat=flat)
    half = np.array(size) / 2

    def bulge(positions: Array, normals: Array) -> Array:
        q = positions / half
        weight = np.prod(np.clip(1 - q**2 * (1 - np.abs(normals)), 0, 1), axis=1)
        moved: Array = positions + normals * (puff * weight)[:, None]
        if wrinkle:
            moved = moved + normals * (wrinkle * waves(positions, 9.0, seed))[:, None]
        return moved

    return mesh.displace(bulge)


def waves(points: Array, frequency: float, seed: int, octaves: int = 3) -> Array:
    """Smooth pseudo-random values of about -1..1: a sum of sines in directions drawn from the seed."""
    random = np.random.default_rng(seed + 977)
    total = np.zeros(len(points))
    amplitude = 0.5
    for _ in range(octaves):
        for _ in range(4):
            direction = normalize(random.normal(size=3))
            phase = random.uniform(0, 2 * math.pi)
            total += amplitude * 0.5 * np.sin(points @ direction * frequency + phase)
        frequency *= 1.9
        amplitude *= 0.55
    return total


def surface(
    material: str,
    function: Callable[[Array, Array], Array],
    rows: int,
    columns: int,
    uv_scale: tuple[float, float] | None = None,
    weld: bool = True,
    flip: bool = False,
) -> Mesh:
    """The surface function(u, v) -> (n, 3) for u, v in 0..1; u x v points outwards (or inwards with flip).

    uv_scale gives the metres that u and v run over; None leaves texture coordinates from 0 to 1.
    """
    grid_u, grid_v = np.meshgrid(np.linspace(0, 1, columns), np.linspace(0, 1, rows))
    u, v = grid_u.reshape(-1), grid_v.reshape(-1)
    positions = function(u, v)
    triangles = grid_triangles(rows, columns)
    if flip:
        triangles = triangles[:, ::-1]
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    triangles = triangles[np.linalg.norm(np.cross(b - a, c - a), axis=1) > 1e-12]
    normals = smooth_normals(positions, triangles)
    if not weld:
        normals = normalize(normals)
    scale = np.array(uv_scale) if uv_scale else np.ones(2)
    return Mesh([Part(material, positions, normals, np.stack([u, 1 - v], 1) * scale, triangles)])


def lathe(
    material: str,
    profile: Iterable[tuple[float, float]],
    segments: int = 24,
    sharp_degrees: float = 35.0,
    arc: float = 360.0,
) -> Mesh:
    """Turns a profile of (radius, height) points, listed from bottom to top along the outside, round the Y axis."""
    points = np.array(list(profile), dtype=float)
    steps = np.diff(points, axis=0)
    keep = np.concatenate([[True], np.linalg.norm(steps, axis=1) > 1e-9])
    points = points[keep]
    steps = np.diff(points, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    edge_normals = normalize(np.stack([steps[:, 1], -steps[:, 0]], 1))
    along = np.concatenate([[0], np.cumsum(lengths)])
    # One strip for each run of edges without a sharp corner.
    runs: list[list[int]] = [[0]]
    for k in range(1, len(steps)):
        if float(edge_normals[k] @ edge_normals[k - 1]) < math.cos(math.radians(sharp_degrees)):
            runs.append([k])
        else:
            runs[-1].append(k)
    angles = np.linspace(0, math.radians(arc), segments + 1)
    mean_radius = float(points[:, 0].max())
    parts = []
    for run in runs:
        indices = [*run, run[-1] + 1]
        normals2 = []
        for i in indices:
            around = [edge_normals[k] * lengths[k] for k in (i - 1, i) if k in run]
            normals2.append(normalize(np.sum(around, axis=0)))
        n2 = np.array(normals2)
        p2 = points[indices]
        cos, sin = np.cos(angles), np.sin(angles)
        positions = np.stack(
            [p2[:, None, 0] * cos, np.broadcast_to(p2[:, None, 1], (len(p2), len(angles))), -p2[:, None, 0] * sin], -1
        ).reshape(-1, 3)
        normals = np.stack(
            [n2[:, None, 0] * cos, np.broadcast_to(n2[:, None, 1], (len(p2), len(angles))), -n2[:, None, 0] * sin], -1
        ).reshape(-1, 3)
        uv = np.stack(np.broadcast_arrays(angles[None, :] * mean_radius, -along[indices][:, None]), -1).reshape(-1, 2)
        triangles = grid_triangles(len(p2), len(angles))
        a, b, c = (positions[triangles[:, k]] for k in range(3))
        triangles = triangles[np.linalg.norm(np.cross(b - a, c - a), axis=1) > 1e-13]
        parts.append(Part(material, positions, normals, uv, triangles))
    return Mesh(parts)


def cylinder(
    material: str, radius: float, height: float, segments: int = 20, bevel: float = 0.0, top_radius: float | None = None
) -> Mesh:
    """A closed cylinder (or cone frustum) standing on the origin."""
    top = radius if top_radius is None else top_radius
    b = min(bevel, height / 3, radius / 3)
    if b <= 0:
        return lathe(material, [(0, 0), (radius, 0), (top, height), (0, height)], segments)
    return lathe(
        material,
        [(0, 0), (radius - b, 0), (radius, b), (top, height - b), (max(top - b, 0), height), (0, height)],
        segments,
        50,
    )


def sphere(material: str, radius: float, segments: int = 20, squash: float = 1.0) -> Mesh:
    angles = np.linspace(-math.pi / 2, math.pi / 2, segments // 2 + 1)
    profile = [
        (max(0.0, radius * math.cos(a)) if abs(a) < math.pi / 2 - 1e-6 else 0.0, radius * squash * math.sin(a))
        for a in angles
    ]
    return lathe(material, profile, segments, 180)


def tube(
    material: str,
    path: Iterable[Sequence[float]],
    radius: float | Sequence[float],
    segments: int = 10,
    caps: bool = True,
    closed: bool = False,
) -> Mesh:
    """A round tube along a path of points; radius may vary by point. closed joins end and start."""
    points = np.array(list(path), dtype=float)
    if closed:
        points = np.concatenate([points, points[:1]])
    n = len(points)
    radii = (
        np.broadcast_to(np.asarray(radius, dtype=float), (n,))
        if np.isscalar(radius) or closed
        else np.asarray(radius, dtype=float)
    )
    tangents = np.zeros_like(points)
    tangents[1:-1] = points[2:] - points[:-2]
    tangents[0], tangents[-1] = points[1] - points[0], points[-1] - points[-2]
    if closed:
        tangents[0] = tangents[-1] = points[1] - points[-2]
    tangents = normalize(tangents)
    reference = np.array([0.0, 1.0, 0.0]) if abs(tangents[0, 1]) < 0.9 else np.array([1.0, 0.0, 0.0])
    normal = normalize(np.cross(np.cross(tangents[0], reference), tangents[0]))
    frames = []
    for t in tangents:
        normal = normalize(normal - t * float(normal @ t))
        frames.append((normal, np.cross(t, normal)))
    angles = np.linspace(0, 2 * math.pi, segments + 1)
    ring = np.stack([np.stack([np.cos(a) * f[0] + np.sin(a) * f[1] for a in angles]) for f in frames])
    positions = (points[:, None, :] + ring * radii[:, None, None]).reshape(-1, 3)
    normals = ring.reshape(-1, 3)
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    uv = np.stack(np.broadcast_arrays(along[:, None], angles[None, :] * float(radii.max())), -1).reshape(-1, 2)
    parts = [Part(material, positions, normals, uv, grid_triangles(n, segments + 1))]
    if caps and not closed:
        for end, sign in ((0, -1.0), (n - 1, 1.0)):
            if radii[end] < 1e-6:
                continue
            rim = points[end] + ring[end, :-1] * radii[end]
            centre = points[end : end + 1]
            p = np.concatenate([centre, rim])
            i = np.arange(segments)
            t = np.stack([np.zeros(segments, dtype=np.int64), 1 + i, 1 + (i + 1) % segments], 1)
            if sign < 0:
                t = t[:, ::-1]
            parts.append(Part(material, p, np.tile(tangents[end] * sign, (len(p), 1)), p[:, [0, 2]].copy(), t))
    return Mesh(parts)


def curve(*points: Sequence[float], steps: int = 8) -> list[tuple[float, float, float]]:
    """A Catmull-Rom curve through the points, `steps` samples a span."""
    p = np.array(points, dtype=float)
    padded = np.concatenate([[2 * p[0] - p[1]], p, [2 * p[-1] - p[-2]]])
    result: list[tuple[float, float, float]] = []
    for k in range(1, len(padded) - 2):
        for s in range(steps):
            t = s / steps
            a, b, c, d = padded[k - 1 : k + 3]
            q = 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t**3)
            result.append((float(q[0]), float(q[1]), float(q[2])))
    result.append((float(p[-1, 0]), float(p[-1, 1]), float(p[-1, 2])))
    return result


def quad(material: str, width: float, height: float, unit_uv: bool = True) -> Mesh:
    """A rectangle in the XY plane, centred at the origin, facing +Z."""
    w, h = width / 2, height / 2
    positions = np.array([[-w, -h, 0], [w, -h, 0], [w, h, 0], [-w, h, 0]], dtype=float)
    uv = np.array([[0, 1], [1, 1], [1, 0], [0, 0]], dtype=float)
    if not unit_uv:
        uv = uv * np.array([width, height])
    return Mesh([Part(material, positions, np.tile([0.0, 0.0, 1.0], (4, 1)), uv, np.array([[0, 1, 2], [0, 2, 3]]))])


def sweep(material: str, profile: Iterable[tuple[float, float]], length: float) -> Mesh:
    """A flat-shaded profile in (z, y), counter-clockwise seen from +X, drawn out along X from 0 to length, with both
    ends closed."""
    points = np.array(list(profile), dtype=float)
    parts = []
    n = len(points)
    along = 0.0
    for k in range(n):
        a, b = points[k], points[(k + 1) % n]
        d = b - a
        span = float(np.linalg.norm(d))
        normal = normalize(np.array([0.0, -d[0], d[1]]))
        positions = np.array(
            [[0, a[1], a[0]], [length, a[1], a[0]], [length, b[1], b[0]], [0, b[1], b[0]]], dtype=float
        )
        uv = np.array([[0, along], [length, along], [length, along + span], [0, along + span]])
        triangles = np.array([[0, 1, 2], [0, 2, 3]])
        face = np.cross(positions[1] - positions[0], positions[2] - positions[0])
        if float(face @ normal) < 0:
            triangles = triangles[:, ::-1]
        parts.append(Part(material, positions, np.tile(normal, (4, 1)), uv, triangles))
        along += span
    fan = np.array([[0, k, k + 1] for k in range(1, n - 1)])
    for x, sign in ((0.0, -1.0), (length, 1.0)):
        positions = np.stack([np.full(n, x), points[:, 1], points[:, 0]], 1)
        normal = np.array([sign, 0.0, 0.0])
        face = np.cross(positions[1] - positions[0], positions[2] - positions[0])
        triangles = fan if float(face @ normal) > 0 else fan[:, ::-1]
        parts.append(Part(material, positions, np.tile(normal, (n, 1)), points.copy(), triangles))
    return Mesh(parts)


def leaf_tuft(material: str, count: int, length: float, seed: int) -> Mesh:
    """Small leaves standing up from the origin in all directions; for bunches and herbs."""
    random = np.random.default_rng(seed + 61)
    mesh = Mesh()
    for k in range(count):
        size = length * float(random.uniform(0.6, 1.0))
        droop = 0.8

        def shape(u: Array, v: Array, size: float = size, droop: float = droop) -> Array:
            side = (v - 0.5) * size * 0.32 * np.sin(math.pi * np.clip(u, 0.02, 1) ** 0.8)
            return np.stack(
                [
                    size * np.sin(droop * u) / droop,
                    -size * (1 - np.cos(droop * u)) / droop + 0.12 * np.abs(side),
                    -side,
                ],
                1,
            )

        blade = surface(material, shape, 3, 6)
        mesh.add(blade.rotate("z", float(random.uniform(30, 85))).rotate("y", 137.5 * k))
    return mesh
