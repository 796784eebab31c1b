# SPDX-License-Identifier: MIT
"""Furniture and lamps of bedroom, bathroom and study."""

from __future__ import annotations

import math

import furniture_bath as bath
import furniture_office as office
from furniture_common import (
    book_stack,
    bottle,
    box_at,
    cushion,
    fern,
    fiddle_plant,
    floor_lamp,
    flush_lamp,
    mug,
    pendant,
    picture,
    snake_plant,
    table_lamp,
    towel,
    vase,
)
from furniture_seating import armchair, bed, bench, duvet, office_chair, pillow
from furniture_storage import basket, bookcase, chest, framed_mirror, round_table, wall_shelf, wardrobe
from geometry import cylinder, leaf_tuft, union
from rooms_day import potted, rug, window_curtains
from scene import Scene
from shell import CEILING


def bedroom(scene: Scene) -> None:
    scene.room = "Bedroom"
    scene.add("Rug", rug("rug_bedroom", 2.5, 3.0).rotate("y", 90), (-1.75, 0.0, -2.90), 0.0, ("textile",), "Textiles")
    # The head of the bed is at the west wall.
    x0, z0 = -2.28, -2.90
    scene.add("Bed", bed(1.60, 2.00), (x0, 0.0, z0), 90.0, ("furniture", "seat"))
    scene.add(
        "Duvet", duvet(1.60, 1.46, "linen_white", 2), (x0 + 0.28, 0.515, z0), 90.0, ("textile",), "Textiles", True
    )
    scene.add(
        "Blanket",
        duvet(1.62, 0.55, "linen_blue", 7, 24).scale(1.03, 1.06, 1.0),
        (x0 + 0.66, 0.535, z0),
        90.0,
        ("textile",),
        "Textiles",
        True,
    )
    for k, (dx, dz, cloth, tilt) in enumerate(
        (
            (-0.74, -0.40, "linen_white", 35.0),
            (-0.74, 0.40, "linen_white", 35.0),
            (-0.60, -0.38, "linen_blue", 48.0),
            (-0.60, 0.38, "linen_blue", 48.0),
        )
    ):
        size = (0.70, 0.46) if k < 2 else (0.62, 0.42)
        scene.add(
            "Pillow",
            pillow(cloth, size[0], size[1], k).rotate("x", tilt),
            (x0 + dx, 0.51 + 0.17, z0 + dz),
            90.0 + (4 if k % 2 else -3),
            ("textile",),
            "Textiles",
            True,
        )
    scene.add(
        "Cushion",
        cushion("linen_mustard", 0.38, 5).rotate("x", -38),
        (x0 - 0.40, 0.70, z0 + 0.02),
        90.0,
        ("textile",),
        "Textiles",
        True,
    )
    scene.add("Teddy", office.teddy(), (x0 - 0.30, 0.545, z0 + 0.44), 75.0, ("toy",), "Decor", True)
    stand = scene.shared("NightstandMesh", chest(0.48, 0.50, 0.40, 2, 1, "oak"))
    for k, z in enumerate((-4.10, -1.70)):
        scene.add("Nightstand", stand, (-3.17, 0.0, z), 90.0, ("furniture", "storage"))
        scene.add(
            "BedsideLamp",
            table_lamp("ceramic_sand" if k else "ceramic_white"),
            (-3.20, 0.50, z - 0.02),
            0.0,
            ("lamp",),
            "Lamps",
            True,
        )
        scene.light("point", (-3.20, 0.87, z - 0.02), 5.5, reach=4.5)
    scene.add("Books", book_stack(2, 33), (-3.06, 0.50, -1.86), 20.0, ("decor", "book"), "Decor", True)
    clock = union(
        box_at("plastic_white", (0.14, 0.07, 0.06), 0, 0, 0, 0.014, 3),
        box_at("screen_off", (0.12, 0.045, 0.002), 0, 0.0125, 0.0305, 0.001),
    )
    scene.add("AlarmClock", clock, (-3.05, 0.50, -4.24), 80.0, ("electronics",), "Electronics", True)
    scene.add("Mug", mug("ceramic_blue"), (-3.04, 0.50, -3.98), 10.0, ("tableware",), "Decor", True)
    scene.add("Wardrobe", wardrobe(2.40, 2.20, 0.58, 4), (0.50, 0.0, -3.65), -90.0, ("furniture", "storage"))
    scene.add("Dresser", chest(1.20, 0.82, 0.44, 3, 2, "oak"), (-2.05, 0.0, -1.06), 180.0, ("furniture", "storage"))
    scene.add("Mirror", framed_mirror(0.80, 0.95, "oak"), (-2.05, 1.48, -0.822), 180.0, ("decor",), "Decor")
    scene.add(
        "JewelleryBox",
        union(
            box_at("walnut", (0.20, 0.09, 0.14), 0, 0, 0, 0.006, 2),
            box_at("brass", (0.03, 0.03, 0.006), 0, 0.04, 0.071, 0.002),
        ),
        (-1.72, 0.82, -1.04),
        170.0,
        ("decor",),
        "Decor",
        True,
    )
    scene.add(
        "Vase",
        union(vase("ceramic_sand", 0.075, 0.24), leaf_tuft("leaf_light", 10, 0.34, 31).move(0, 0.2, 0)),
        (-2.46, 0.82, -1.05),
        0.0,
        ("decor", "plant"),
        "Decor",
        True,
    )
    for k in range(3):
        scene.add(
            "Bottle",
            bottle(("soap", "clear_glass", "ceramic_white")[k], 0.12 + 0.02 * k, 0.022, None, "brass"),
            (-2.22 + 0.08 * k, 0.82, -1.00 - 0.03 * (k % 2)),
            0.0,
            ("decor",),
            "Decor",
            True,
        )
    scene.add("Bench", bench(1.30, "boucle_cream"), (-0.95, 0.0, z0), 90.0, ("furniture", "seat"), movable=True)
    scene.add(
        "Armchair", armchair("boucle_cream"), (-0.20, 0.0, -4.40 + 0.02), -42.0, ("furniture", "seat"), movable=True
    )
    scene.add(
        "Cushion",
        cushion("linen_rose", 0.36, 8).rotate("x", -16),
        (-0.15, 0.62, -4.46),
        -42.0,
        ("textile",),
        "Textiles",
        True,
    )
    scene.add(
        "Painting", picture("painting_abstract_2", 0.90, 0.70, "oak"), (-3.398, 1.62, z0), 90.0, ("decor",), "Decor"
    )
    scene.add(
        "Painting", picture("painting_botanical", 0.36, 0.48, "oak"), (0.798, 1.55, -1.75), -90.0, ("decor",), "Decor"
    )
    scene.add(
        "Plant",
        potted("terracotta", 0.17, 0.32, fiddle_plant(24, 1.25, 24)),
        (-3.05, 0.0, -4.72),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add("LaundryBasket", basket(0.22, 0.50), (0.52, 0.0, -2.05), 30.0, ("furniture", "storage"), movable=True)
    window_curtains(scene, -1.3, -5.0, 2.0, 2.42, "curtain_bedroom", 0.0, 81, 0.52)
    scene.add("CeilingLamp", pendant(0.55, "brass", 0.22), (-1.3, CEILING, -2.9), tags=("lamp",), group="Lamps")
    scene.light("point", (-1.3, CEILING - 0.62, -2.9), 15.0, reach=8.0)


def bathroom(scene: Scene) -> None:
    scene.room = "Bathroom"
    fixture = ("fixture", "sanitary")
    tub_x, tub_z = 1.79, -4.615
    scene.add("Bathtub", bath.bathtub(1.72, 0.76), (tub_x, 0.0, tub_z), 0.0, fixture, "Fixtures")
    scene.add("ShowerMixer", bath.bath_mixer(), (0.925, 0.82, tub_z), 90.0, fixture, "Fixtures")
    scene.add(
        "ShowerScreen",
        bath.glass_screen(0.80, 1.42),
        (0.925, 0.56, tub_z + 0.355),
        0.0,
        ("fixture", "glass"),
        "Fixtures",
    )
    scene.add(
        "BathNiche",
        box_at("bath_tiles", (0.72, 0.56, 0.79), 0, 0, 0, 0.004),
        (3.02, 0.0, tub_z),
        0.0,
        ("structure",),
        "Structure",
    )
    scene.add("Toilet", bath.toilet(), (3.395, 0.0, -3.35), -90.0, fixture, "Fixtures")
    scene.add("ToiletRoll", bath.toilet_roll(), (3.398, 0.72, -2.86), -90.0, ("fixture",), "Decor", True)
    scene.add("Vanity", bath.vanity(1.05), (0.925, 0.0, -2.45), 90.0, ("furniture", "storage", "sink"), "Fixtures")
    scene.add(
        "MirrorCabinet",
        bath.mirror_cabinet(0.95, 0.72),
        (0.922, 1.60, -2.45),
        90.0,
        ("furniture", "storage", "mirror"),
        "Fixtures",
    )
    scene.light("spot", (1.10, 2.00, -2.45), 8.0, (1.0, 0.92, 0.82), 4.0, (50.0, 80.0), (0.6, -1.0, 0.0))
    scene.add("TowelRadiator", bath.towel_radiator(0.50, 1.25), (3.395, 0.55, -2.10), -90.0, ("fixture",), "Fixtures")
    for k, (y, cloth) in enumerate(((1.645, "towel_teal"), (1.24, "towel_white"))):
        scene.add(
            "Towel", towel(cloth, 0.40, 0.42 - 0.04 * k), (3.325, y, -2.10), -90.0, ("textile",), "Textiles", True
        )
    scene.add("WashingMachine", bath.washing_machine(), (3.395, 0.0, -1.25), -90.0, ("appliance",), "Appliances")
    scene.add("LaundryBasket", basket(0.19, 0.46), (1.18, 0.0, -1.22), 0.0, ("furniture", "storage"), movable=True)
    scene.add(
        "BathMat",
        box_at("towel_teal", (0.80, 0.018, 0.50), 0, 0, 0, 0.007, 2),
        (1.85, 0.0, -3.92),
        2.0,
        ("textile",),
        "Textiles",
        True,
    )
    scene.add(
        "BathMat",
        box_at("towel_white", (0.55, 0.018, 0.75), 0, 0, 0, 0.007, 2),
        (1.72, 0.0, -2.45),
        -2.0,
        ("textile",),
        "Textiles",
        True,
    )
    top = 0.86
    scene.add(
        "SoapDispenser", bath.pump_bottle("ceramic_black", 0.15), (1.10, top, -2.83), 60.0, ("fixture",), "Decor", True
    )
    scene.add("ToothbrushCup", bath.toothbrush_cup(), (1.03, top, -2.08), 90.0, ("fixture",), "Decor", True)
    scene.add(
        "Plant",
        potted("ceramic_white", 0.055, 0.09, fern(41, 0.14, 9)),
        (1.02, top, -2.00 + 0.03 - 0.14 + 0.14),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add("PedalBin", bath.pedal_bin(), (3.20, 0.0, -3.75 + 0.0), -90.0, ("fixture",), "Decor", True)
    scene.add("Shelf", wall_shelf(0.70), (2.95, 1.35, -4.998), 0.0, ("furniture", "storage"))
    for k, body in enumerate(("soap", "ceramic_blue", "ceramic_white")):
        scene.add(
            "Bottle",
            bath.pump_bottle(body, 0.17 - 0.02 * k),
            (2.72 + 0.11 * k, 1.35, -4.89),
            30.0 * k,
            ("toiletry",),
            "Decor",
            True,
        )
    scene.add(
        "Towels",
        union(
            *(
                box_at(m, (0.30, 0.075, 0.20), 0, 0.077 * k, 0, 0.034, 4)
                for k, m in enumerate(("towel_white", "towel_teal", "towel_white"))
            )
        ),
        (3.13, 1.35, -4.88),
        0.0,
        ("textile",),
        "Textiles",
        True,
    )
    for k in range(3):
        scene.add(
            "Candle",
            office.candle(0.06 + 0.03 * k, 0.032),
            (2.85 + 0.10 * k, 0.56, -4.82 + 0.04 * (k % 2)),
            0.0,
            ("decor",),
            "Decor",
            True,
        )
    scene.add(
        "Plant",
        potted("terracotta", 0.11, 0.19, snake_plant(44, 0.55, 9)),
        (3.14, 0.56, -4.45),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    lamp = flush_lamp(0.17)
    scene.add("CeilingLamp", lamp, (2.1, CEILING, -3.2), tags=("lamp",), group="Lamps")
    scene.light("point", (2.1, CEILING - 0.16, -3.2), 14.0, (1.0, 0.93, 0.84), 7.0)


def study(scene: Scene) -> None:
    scene.room = "Study"
    scene.add("Rug", rug("rug_study", 1.9, 2.6), (5.35, 0.0, -2.55), 0.0, ("textile",), "Textiles")
    dx, dz, top = 5.30, -4.45, 0.74
    scene.add("Desk", office.desk(1.60, 0.76), (dx, 0.0, dz), 0.0, ("furniture", "table"))
    scene.add("OfficeChair", office_chair(), (dx - 0.05, 0.0, dz + 0.78), 196.0, ("furniture", "seat"), movable=True)
    scene.add("Monitor", office.monitor(0.62), (dx - 0.05, top, dz - 0.17), 0.0, ("electronics",), "Electronics", True)
    scene.add("Keyboard", office.keyboard(), (dx - 0.05, top, dz + 0.13), 0.0, ("electronics",), "Electronics", True)
    scene.add("Mouse", office.mouse(), (dx + 0.27, top, dz + 0.14), -8.0, ("electronics",), "Electronics", True)
    scene.add("Laptop", office.laptop(), (dx + 0.56, top, dz - 0.02), -24.0, ("electronics",), "Electronics", True)
    scene.add("DeskLamp", office.desk_lamp(), (dx - 0.66, top, dz - 0.16), -12.0, ("lamp",), "Lamps", True)
    c, s = math.cos(math.radians(-12)), math.sin(math.radians(-12))
    scene.light(
        "spot",
        (dx - 0.66 + 0.31 * c, top + 0.36, dz - 0.16 - 0.31 * s),
        9.0,
        (1.0, 0.86, 0.68),
        3.0,
        (25.0, 50.0),
        (-0.25, -1.0, 0.15),
    )
    scene.add("PenCup", office.pen_cup(), (dx + 0.42, top, dz - 0.28), 0.0, ("decor",), "Decor", True)
    scene.add("Papers", office.paper_stack(5), (dx - 0.52, top, dz + 0.17), 12.0, ("decor",), "Decor", True)
    scene.add(
        "Mug",
        union(mug("ceramic_black"), cylinder("coffee", 0.036, 0.004, 20).move(0, 0.072, 0)),
        (dx + 0.36, top, dz - 0.10),
        140.0,
        ("tableware",),
        "Decor",
        True,
    )
    scene.add(
        "Plant",
        potted("ceramic_blue", 0.06, 0.10, leaf_tuft("leaf", 36, 0.13, 55)),
        (dx + 0.66, top, dz - 0.29),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add("FilingCabinet", office.filing_cabinet(), (6.74, 0.0, -4.72), -90.0, ("furniture", "storage"))
    scene.add("Globe", office.globe(), (6.72, 0.67, -4.72), 40.0, ("decor",), "Decor", True)
    for z, seed in ((-4.30, 61), (-3.25, 63), (-2.20, 67)):
        case, books = bookcase(1.02, 2.10, 0.30, 6, "walnut", seed, 0.88, 1)
        scene.add("Bookcase", case, (3.675, 0.0, z), 90.0, ("furniture", "storage"))
        scene.add("Books", books, (3.675, 0.0, z), 90.0, ("decor", "book"), "Decor")
    scene.add("Basket", basket(0.14, 0.18), (3.67, 2.10, -4.35), 0.0, ("decor",), "Decor", True)
    scene.add(
        "Plant",
        potted("terracotta", 0.10, 0.15, fern(61, 0.27, 12)),
        (3.70, 2.10, -2.3),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add("Armchair", armchair("leather"), (6.30, 0.0, -1.52), 222.0, ("furniture", "seat"), movable=True)
    scene.add(
        "Cushion",
        cushion("linen_teal", 0.36, 9).rotate("x", -16),
        (6.36, 0.62, -1.45),
        222.0,
        ("textile",),
        "Textiles",
        True,
    )
    scene.add(
        "Table",
        round_table(0.21, 0.50, "oak", "black_metal"),
        (5.62, 0.0, -1.20),
        0.0,
        ("furniture", "side_table"),
        movable=True,
    )
    scene.add("Books", book_stack(3, 66), (5.62, 0.50, -1.20), 40.0, ("decor", "book"), "Decor", True)
    scene.add("FloorLamp", floor_lamp(), (6.66, 0.0, -1.14 + 0.0), 50.0, ("lamp",), "Lamps", True)
    scene.light("point", (6.66, 1.42, -1.14), 8.0, reach=5.0)
    scene.add("CorkBoard", office.cork_board(0.95, 0.62, 8), (5.98, 1.60, -0.822), 180.0, ("decor",), "Decor")
    scene.add("Clock", office.wall_clock(0.14), (6.998, 1.95, -4.45), -90.0, ("decor",), "Decor")
    scene.add(
        "Painting",
        picture("painting_landscape", 0.72, 0.52, "walnut"),
        (6.998, 1.62, -1.45),
        -90.0,
        ("decor",),
        "Decor",
    )
    scene.add(
        "Plant",
        potted("ceramic_white", 0.17, 0.33, fiddle_plant(64, 1.25, 24, "leaf")),
        (6.70, 0.0, -3.98 + 1.75),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    window_curtains(scene, 5.3, -5.0, 1.8, 2.42, "curtain_study", 0.0, 91, 0.42)
    scene.add("CeilingLamp", flush_lamp(0.22), (5.25, CEILING, -2.8), tags=("lamp",), group="Lamps")
    scene.light("point", (5.25, CEILING - 0.18, -2.8), 15.0, (1.0, 0.88, 0.74), 7.0)
