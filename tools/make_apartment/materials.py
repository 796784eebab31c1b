# SPDX-License-Identifier: MIT
"""The material library: which maps and factors each named material has, and how many metres one tile of it covers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import pictures
import textures
from textures import Colour, Maps


@dataclass(frozen=True)
class Material:
    """A glTF metallic-roughness material.

    maps      name of an entry of MAPS, or empty for factors alone
    tile      metres that texture coordinates 0..1 cover; 0 for images that run from corner to corner once
    colour    sRGB colour factor, alpha; with maps it tints them
    bump      strength of the normal map
    """

    maps: str = ""
    tile: float = 1.0
    colour: tuple[float, float, float] = (1.0, 1.0, 1.0)
    alpha: float = 1.0
    metallic: float = 0.0
    roughness: float = 0.6
    emissive: tuple[float, float, float] = (0.0, 0.0, 0.0)
    emissive_strength: float = 1.0
    emissive_map: bool = False
    two_sided: bool = False
    bump: float = 1.0


def _wood(light: Colour, dark: Colour, seed: int, gloss: float = 0.45) -> Callable[[], Maps]:
    return lambda: textures.wood(1024, seed, light, dark, 1.0, gloss)


# name -> (function that makes the maps, metres that a tile covers when a height in millimetres becomes a slope)
MAPS: dict[str, tuple[Callable[[], Maps], float]] = {
    "parquet": (lambda: textures.planks(1024, 11, (0.80, 0.63, 0.44), (0.57, 0.40, 0.25)), 1.7),
    "oak": (_wood((0.80, 0.65, 0.47), (0.62, 0.46, 0.29), 21), 0.9),
    "walnut": (_wood((0.50, 0.33, 0.22), (0.29, 0.17, 0.10), 31, 0.38), 0.9),
    "deck": (lambda: textures.planks(512, 41, (0.58, 0.48, 0.38), (0.42, 0.33, 0.25), 8, 0.7), 1.2),
    "plaster": (lambda: textures.plaster(512, 51), 1.2),
    "marble": (lambda: textures.marble(1024, 61, (0.93, 0.925, 0.915), (0.50, 0.51, 0.54)), 1.5),
    "dark_marble": (lambda: textures.marble(512, 71, (0.12, 0.125, 0.13), (0.62, 0.58, 0.50)), 1.2),
    "kitchen_floor": (
        lambda: textures.tiles(
            1024,
            81,
            2,
            2,
            (0.52, 0.51, 0.49),
            textures.speckle(1024, 82, (0.66, 0.645, 0.62), (0.56, 0.545, 0.52), 0.5).colour,
            0.006,
            0.0,
            0.02,
            0.33,
        ),
        1.2,
    ),
    "metro_tiles": (
        lambda: textures.tiles(
            1024, 91, 4, 8, (0.74, 0.73, 0.71), textures.plain(1024, (0.90, 0.91, 0.90)), 0.007, 0.5, 0.012, 0.09
        ),
        0.8,
    ),
    "bath_tiles": (
        lambda: textures.tiles(
            1024,
            101,
            5,
            5,
            (0.80, 0.80, 0.78),
            textures.mix(
                (0.18, 0.37, 0.38),
                (0.30, 0.52, 0.51),
                textures.smoothstep(-1.5, 1.5, textures.noise(1024, 102, 1.6, low=2)),
            ),
            0.010,
            0.0,
            0.07,
            0.10,
        ),
        0.75,
    ),
    "bath_floor": (
        lambda: textures.tiles(
            1024,
            111,
            8,
            8,
            (0.55, 0.55, 0.54),
            textures.marble(1024, 112, (0.86, 0.86, 0.85), (0.55, 0.56, 0.58)).colour,
            0.006,
            0.0,
            0.05,
            0.25,
        ),
        0.8,
    ),
    "linen": (lambda: textures.weave(512, 121, (0.96, 0.95, 0.93), 72), 0.16),
    "heavy_weave": (lambda: textures.weave(512, 131, (1.0, 1.0, 1.0), 44, 0.45, 1.2, (0.86, 0.86, 0.87)), 0.16),
    "boucle": (lambda: textures.boucle(512, 141, (1.0, 1.0, 1.0)), 0.22),
    "throw": (
        lambda: textures.stripes(
            512, 151, [(0.86, 0.82, 0.74), (0.70, 0.36, 0.24), (0.86, 0.82, 0.74), (0.25, 0.36, 0.40)], [5, 2, 1, 1]
        ),
        0.30,
    ),
    "leather": (lambda: textures.leather(512, 161, (0.55, 0.31, 0.17)), 0.35),
    "steel": (lambda: textures.brushed(512, 171, (0.78, 0.78, 0.79), 0.30), 0.5),
    "brass": (lambda: textures.brushed(512, 181, (0.89, 0.72, 0.42), 0.26), 0.4),
    "leaf": (lambda: textures.leaf(512, 191, (0.50, 0.64, 0.26), (0.13, 0.29, 0.10)), 0.3),
    "soil": (lambda: textures.speckle(256, 201, (0.20, 0.14, 0.10), (0.36, 0.28, 0.21), 1.0, 0.98, 1.2), 0.2),
    "terracotta": (lambda: textures.speckle(512, 211, (0.72, 0.43, 0.30), (0.80, 0.55, 0.42), 0.6, 0.85, 0.08), 0.4),
    "cork": (lambda: textures.speckle(512, 221, (0.74, 0.56, 0.37), (0.50, 0.34, 0.20), 1.0, 0.95, 0.3), 0.3),
    "stone": (lambda: textures.speckle(512, 231, (0.60, 0.59, 0.57), (0.45, 0.44, 0.43), 0.8, 0.9, 0.3), 1.0),
    "wicker": (lambda: textures.weave(512, 241, (0.78, 0.62, 0.42), 14, 0.65, 1.5, (0.70, 0.54, 0.35)), 0.16),
    "grass": (lambda: textures.grass(512, 251), 1.6),
    "brick": (lambda: textures.brick(512, 261), 1.0),
    "bark": (lambda: textures.wood(512, 271, (0.42, 0.34, 0.28), (0.20, 0.15, 0.12), 1.8, 0.9), 0.5),
    "citrus": (lambda: textures.speckle(256, 281, (1.0, 1.0, 1.0), (0.86, 0.82, 0.78), 0.8, 0.5, 0.25), 0.08),
    "rug_living": (lambda: pictures.rug(1024, 301, (0.80, 0.76, 0.68), (0.30, 0.36, 0.40), (0.62, 0.30, 0.22)), 2.4),
    "rug_bedroom": (lambda: pictures.rug(512, 311, (0.62, 0.63, 0.62), (0.84, 0.82, 0.78), (0.40, 0.44, 0.48)), 2.0),
    "rug_study": (lambda: pictures.rug(512, 321, (0.42, 0.17, 0.14), (0.16, 0.19, 0.27), (0.80, 0.66, 0.44)), 2.0),
    "rug_hall": (lambda: pictures.rug(512, 331, (0.24, 0.33, 0.36), (0.78, 0.70, 0.55), (0.66, 0.34, 0.22)), 2.0),
    "painting_landscape": (lambda: pictures.landscape(1024, 401), 1.0),
    "painting_abstract": (
        lambda: pictures.abstract(
            512,
            411,
            (0.90, 0.86, 0.77),
            [(0.75, 0.33, 0.20), (0.16, 0.30, 0.36), (0.86, 0.63, 0.26), (0.30, 0.28, 0.26)],
        ),
        0.7,
    ),
    "painting_abstract_2": (
        lambda: pictures.abstract(
            512,
            421,
            (0.83, 0.85, 0.83),
            [(0.24, 0.40, 0.36), (0.85, 0.72, 0.60), (0.20, 0.22, 0.30), (0.70, 0.42, 0.36)],
        ),
        0.7,
    ),
    "painting_botanical": (lambda: pictures.botanical(512, 431), 0.5),
    "painting_waves": (lambda: pictures.waves_print(512, 441), 0.5),
    "books": (lambda: pictures.book_spines(1024, 501), 0.5),
    "clock": (lambda: pictures.clock_face(512, 511), 0.3),
    "globe": (lambda: pictures.globe(512, 521), 0.5),
    "screen": (lambda: pictures.screen(1024, 531), 0.5),
}


def _paint(r: float, g: float, b: float) -> Material:
    return Material("plaster", 1.2, (r, g, b))


def _cloth(r: float, g: float, b: float, maps: str = "linen", two_sided: bool = False) -> Material:
    return Material(maps, {"linen": 0.16, "heavy_weave": 0.16, "boucle": 0.22}[maps], (r, g, b), two_sided=two_sided)


MATERIALS: dict[str, Material] = {
    # Building
    "paint_white": _paint(1.0, 1.0, 1.0),
    "paint_ceiling": _paint(1.0, 1.0, 0.995),
    "paint_living": _paint(0.945, 0.915, 0.865),
    "paint_accent": _paint(0.44, 0.53, 0.50),
    "paint_kitchen": _paint(0.93, 0.93, 0.90),
    "paint_bedroom": _paint(0.73, 0.79, 0.83),
    "paint_study": _paint(0.62, 0.68, 0.60),
    "paint_hall": _paint(0.95, 0.92, 0.88),
    "facade": Material("brick", 1.0),
    "parquet": Material("parquet", 1.7),
    "kitchen_floor": Material("kitchen_floor", 1.2),
    "bath_floor": Material("bath_floor", 0.8),
    "bath_tiles": Material("bath_tiles", 0.75),
    "metro_tiles": Material("metro_tiles", 0.8),
    "white_lacquer": Material(colour=(0.93, 0.925, 0.91), roughness=0.32),
    "roof": Material(colour=(0.35, 0.34, 0.33), roughness=0.95),
    "glass": Material(colour=(0.96, 0.985, 0.98), alpha=0.10, roughness=0.03, two_sided=True),
    "frosted_glass": Material(colour=(0.92, 0.96, 0.97), alpha=0.55, roughness=0.45, two_sided=True),
    "mirror": Material(colour=(0.96, 0.965, 0.97), metallic=1.0, roughness=0.02),
    # Woods, stones, metals
    "oak": Material("oak", 0.9),
    "walnut": Material("walnut", 0.9),
    "deck": Material("deck", 1.2),
    "painted_navy": Material(colour=(0.17, 0.24, 0.31), roughness=0.38),
    "painted_sage": Material(colour=(0.47, 0.54, 0.47), roughness=0.40),
    "painted_black": Material(colour=(0.06, 0.06, 0.065), roughness=0.45),
    "painted_mustard": Material(colour=(0.83, 0.60, 0.20), roughness=0.4),
    "marble": Material("marble", 1.5),
    "dark_marble": Material("dark_marble", 1.2),
    "stone": Material("stone", 1.0),
    "steel": Material("steel", 0.5, metallic=1.0),
    "brass": Material("brass", 0.4, metallic=1.0),
    "chrome": Material(colour=(0.86, 0.87, 0.88), metallic=1.0, roughness=0.07),
    "black_metal": Material(colour=(0.055, 0.055, 0.06), metallic=0.6, roughness=0.42),
    "copper": Material(colour=(0.90, 0.58, 0.44), metallic=1.0, roughness=0.22),
    # Cloth and leather
    "sofa_fabric": _cloth(0.60, 0.62, 0.62, "heavy_weave"),
    "armchair_fabric": _cloth(0.83, 0.57, 0.22, "heavy_weave"),
    "boucle_cream": _cloth(0.93, 0.90, 0.84, "boucle"),
    "boucle_grey": _cloth(0.58, 0.57, 0.56, "boucle"),
    "linen_white": _cloth(0.97, 0.965, 0.95),
    "linen_sand": _cloth(0.85, 0.77, 0.65),
    "linen_blue": _cloth(0.38, 0.50, 0.60),
    "linen_teal": _cloth(0.20, 0.42, 0.43),
    "linen_rust": _cloth(0.72, 0.34, 0.21),
    "linen_mustard": _cloth(0.86, 0.63, 0.22),
    "linen_rose": _cloth(0.80, 0.60, 0.56),
    "linen_black": _cloth(0.12, 0.12, 0.13),
    "curtain_living": _cloth(0.90, 0.86, 0.78, two_sided=True),
    "curtain_bedroom": _cloth(0.46, 0.55, 0.63, two_sided=True),
    "curtain_study": _cloth(0.72, 0.64, 0.50, two_sided=True),
    "towel_white": _cloth(0.96, 0.95, 0.93, "boucle"),
    "towel_teal": _cloth(0.28, 0.50, 0.50, "boucle"),
    "throw": Material("throw", 0.30, two_sided=True),
    "leather": Material("leather", 0.35),
    "leather_black": Material("leather", 0.35, (0.20, 0.25, 0.34)),
    "lampshade": Material(
        "linen", 0.16, (1.0, 0.95, 0.86), emissive=(1.0, 0.80, 0.55), emissive_strength=0.55, two_sided=True
    ),
    "wicker": Material("wicker", 0.16),
    "cork": Material("cork", 0.3),
    # Ceramics, plastics, paper
    "ceramic_white": Material(colour=(0.94, 0.94, 0.93), roughness=0.10),
    "ceramic_blue": Material(colour=(0.22, 0.36, 0.48), roughness=0.14),
    "ceramic_sand": Material(colour=(0.80, 0.72, 0.60), roughness=0.35),
    "ceramic_black": Material(colour=(0.09, 0.09, 0.095), roughness=0.25),
    "terracotta": Material("terracotta", 0.4),
    "plastic_white": Material(colour=(0.90, 0.90, 0.89), roughness=0.35),
    "plastic_black": Material(colour=(0.045, 0.045, 0.05), roughness=0.38),
    "plastic_grey": Material(colour=(0.42, 0.43, 0.44), roughness=0.45),
    "plastic_red": Material(colour=(0.72, 0.13, 0.10), roughness=0.35),
    "rubber": Material(colour=(0.05, 0.05, 0.05), roughness=0.85),
    "screen_off": Material(colour=(0.012, 0.012, 0.015), roughness=0.06),
    "screen": Material(
        "screen",
        0.0,
        (0.02, 0.02, 0.02),
        roughness=0.12,
        emissive=(1.0, 1.0, 1.0),
        emissive_strength=1.6,
        emissive_map=True,
    ),
    "paper": Material(colour=(0.93, 0.915, 0.87), roughness=0.9),
    "card": Material(colour=(0.76, 0.62, 0.45), roughness=0.85),
    "wax": Material(colour=(0.95, 0.91, 0.82), roughness=0.5),
    "soap": Material(colour=(0.62, 0.40, 0.20), alpha=0.8, roughness=0.08, two_sided=True),
    "bulb": Material(colour=(1.0, 0.95, 0.88), roughness=0.4, emissive=(1.0, 0.84, 0.62), emissive_strength=14.0),
    "led": Material(colour=(1.0, 1.0, 1.0), roughness=0.4, emissive=(1.0, 0.90, 0.76), emissive_strength=8.0),
    "power_led": Material(colour=(0.1, 0.5, 0.3), roughness=0.3, emissive=(0.1, 1.0, 0.5), emissive_strength=3.0),
    "wine": Material(colour=(0.06, 0.12, 0.07), roughness=0.05),
    "olive_oil": Material(colour=(0.52, 0.48, 0.10), roughness=0.05),
    "label": Material(colour=(0.90, 0.86, 0.76), roughness=0.8),
    "clear_glass": Material(colour=(0.95, 0.98, 0.97), alpha=0.22, roughness=0.02, two_sided=True),
    "coffee": Material(colour=(0.16, 0.085, 0.05), roughness=0.1),
    "pasta": Material(colour=(0.90, 0.74, 0.42), roughness=0.7),
    "flour": Material(colour=(0.93, 0.91, 0.87), roughness=0.95),
    # Plants and fruit
    "leaf": Material("leaf", 0.0, two_sided=True),
    "leaf_dark": Material("leaf", 0.0, (0.66, 0.80, 0.72), two_sided=True),
    "leaf_light": Material("leaf", 0.0, (1.0, 1.0, 0.72), two_sided=True),
    "stem": Material(colour=(0.33, 0.42, 0.18), roughness=0.6),
    "soil": Material("soil", 0.2),
    "bark": Material("bark", 0.5),
    "grass": Material("grass", 2.9),
    "petal": Material(colour=(0.93, 0.55, 0.50), roughness=0.6, two_sided=True),
    "apple": Material("citrus", 0.08, (0.72, 0.12, 0.09)),
    "orange": Material("citrus", 0.08, (0.95, 0.50, 0.08)),
    "lemon": Material("citrus", 0.08, (0.96, 0.82, 0.18)),
    "pear": Material("citrus", 0.08, (0.72, 0.75, 0.25)),
    # Images
    "rug_living": Material("rug_living", 0.0),
    "rug_bedroom": Material("rug_bedroom", 0.0),
    "rug_study": Material("rug_study", 0.0),
    "rug_hall": Material("rug_hall", 0.0),
    "painting_landscape": Material("painting_landscape", 0.0),
    "painting_abstract": Material("painting_abstract", 0.0),
    "painting_abstract_2": Material("painting_abstract_2", 0.0),
    "painting_botanical": Material("painting_botanical", 0.0),
    "painting_waves": Material("painting_waves", 0.0),
    "books": Material("books", 0.0),
    "clock": Material("clock", 0.0, roughness=0.5),
    "globe": Material("globe", 0.0),
}
