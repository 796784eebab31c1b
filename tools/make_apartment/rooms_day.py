# SPDX-License-Identifier: MIT
"""Furniture and lamps of living room, kitchen and hall."""

from __future__ import annotations

import math

import furniture_kitchen as kitchen
import furniture_office as office
from building import ROOMS
from furniture_common import (
    book_row,
    book_stack,
    bottle,
    bowl,
    box_at,
    curtain,
    curtain_rod,
    cushion,
    fern,
    fiddle_plant,
    floor_lamp,
    flush_lamp,
    mug,
    pendant,
    picture,
    plant_pot,
    plate,
    snake_plant,
    table_lamp,
    trailing_plant,
    vase,
    wine_glass,
)
from furniture_seating import armchair, bench, dining_chair, pouf, sofa, throw_blanket
from furniture_storage import (
    basket,
    bookcase,
    coat_rack,
    coffee_table,
    console_table,
    dining_table,
    framed_mirror,
    round_mirror,
    round_table,
    sideboard,
    wall_shelf,
)
from geometry import Mesh, box, cylinder, leaf_tuft, quad, tube, union
from scene import Scene
from shell import CEILING


def rug(image: str, width: float, length: float) -> Mesh:
    """A rug 12 mm thick on y = 0, its image running along Z, with fringes at the short ends."""
    mesh = box_at("linen_sand", (width, 0.009, length), 0, 0, 0, 0.003)
    mesh.add(quad(image, width - 0.004, length - 0.004).rotate("x", -90).move(0, 0.0096, 0))
    for k in range(int(width / 0.035)):
        x = -width / 2 + 0.018 + 0.035 * k
        for side in (-1, 1):
            mesh.add(
                box_at(
                    "linen_white",
                    (0.012, 0.004, 0.06),
                    x + 0.004 * math.sin(k * 2.3),
                    0.0,
                    side * (length / 2 + 0.026),
                    0.0,
                )
            )
    return mesh


def potted(pot: str, radius: float, height: float, plant: Mesh) -> Mesh:
    return union(plant_pot(pot, radius, height), plant.move(0, height - 0.03, 0))


def window_curtains(
    scene: Scene,
    x: float,
    z: float,
    width: float,
    height: float,
    material: str,
    yaw: float,
    seed: int,
    panel: float = 0.55,
) -> None:
    """A rod with two drawn curtains in front of a window on a wall at (x, z); yaw is the direction into the room."""
    c, s = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
    scene.add(
        "CurtainRod", curtain_rod(width + 0.9), (x + 0.11 * s, height, z + 0.11 * c), yaw, ("textile",), "Textiles"
    )
    for k, side in enumerate((-1, 1)):
        offset = side * (width / 2 + 0.14)
        scene.add(
            "Curtain",
            curtain(panel, height - 0.05, material, seed + k, 6.0),
            (x + 0.11 * s + offset * c, 0.015, z + 0.11 * c - offset * s),
            yaw,
            ("textile",),
            "Textiles",
        )


def living_room(scene: Scene) -> None:
    scene.room = "LivingRoom"
    room = ROOMS["LivingRoom"]
    furniture = ("furniture",)
    decor = ("decor",)
    scene.add("Rug", rug("rug_living", 2.3, 3.3), (-0.25, 0.0, 2.8), tags=("textile",), group="Textiles")
    scene.add("Table", coffee_table(), (-0.1, 0.0, 2.8), tags=(*furniture, "coffee_table"), movable=True)
    scene.add("Sofa", sofa(2.25, "sofa_fabric", 3), (-1.62, 0.0, 2.80), 90.0, (*furniture, "seat"), movable=True)
    for k, (cloth, z, lean, turn) in enumerate(
        (
            ("linen_rust", 2.08, -18.0, 12.0),
            ("linen_mustard", 2.38, -22.0, -8.0),
            ("linen_teal", 3.52, -18.0, -14.0),
            ("linen_sand", 3.20, -24.0, 6.0),
        )
    ):
        mesh = cushion(cloth, 0.44 if k % 2 == 0 else 0.38, k).rotate("x", lean)
        scene.add(
            "Cushion",
            mesh,
            (-1.50 + (0.05 if k % 2 else 0), 0.66 if k % 2 == 0 else 0.635, z),
            90.0 + turn,
            ("textile",),
            "Textiles",
            True,
        )
    scene.add("Blanket", throw_blanket(2), (-1.55, 0.635, 3.84), -90.0, ("textile",), "Textiles", True)
    scene.add("Armchair", armchair("armchair_fabric"), (1.15, 0.0, 4.20), 214.0, (*furniture, "seat"), movable=True)
    scene.add("Pouf", pouf("boucle_cream"), (1.18, 0.0, 2.55), 20.0, (*furniture, "seat"), movable=True)
    # On the coffee table
    scene.add("Magazine", office.magazine(4), (-0.22, 0.42, 2.45), 12.0, decor, "Decor", True)
    scene.add(
        "Bowl",
        union(bowl("ceramic_blue", 0.155, 0.085), kitchen.fruit_bowl_content(0.15, 1).move(0, -0.005, 0)),
        (-0.02, 0.42, 3.12),
        0.0,
        decor,
        "Decor",
        True,
    )
    for k, (x, z, h) in enumerate(((0.14, 2.74, 0.0), (0.20, 2.62, 0.0))):
        scene.add(
            "Candle",
            office.candle_holder() if k == 0 else office.candle(0.10, 0.034),
            (x, 0.42 + h, z),
            0.0,
            decor,
            "Decor",
            True,
        )
    scene.add("Remote", office.remote_control(), (-0.30, 0.42, 2.88), 28.0, ("electronics",), "Decor", True)
    scene.add(
        "Mug",
        union(mug("ceramic_sand"), cylinder("coffee", 0.036, 0.004, 20).move(0, 0.075, 0)),
        (-0.27, 0.42, 3.06),
        60.0,
        ("tableware",),
        "Decor",
        True,
    )
    # Library behind the sofa
    for k, (z, seed) in enumerate(((1.62, 5), (2.84, 6), (4.06, 7))):
        case, books = bookcase(1.20, 2.20, 0.32, 6, "oak", seed, 0.78, 2)
        scene.add("Bookcase", case, (-3.235, 0.0, z), 90.0, (*furniture, "storage"))
        scene.add("Books", books, (-3.235, 0.0, z), 90.0, ("decor", "book"), "Decor")
        del k
    scene.add("Vase", vase("ceramic_sand", 0.09, 0.28), (-3.24, 2.20, 1.5), tags=decor, group="Decor", movable=True)
    scene.add(
        "Plant",
        potted("ceramic_white", 0.085, 0.14, trailing_plant(3, 14, 0.75)),
        (-3.15, 2.20, 4.36),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add("Basket", basket(0.15, 0.20), (-3.24, 2.20, 2.84), tags=decor, group="Decor", movable=True)
    # Television wall
    scene.add(
        "TelevisionStand",
        sideboard(1.75, "walnut", "walnut", 3).scale(1, 0.72, 0.92),
        (2.785, 0.0, 2.05),
        -90.0,
        (*furniture, "storage"),
    )
    scene.add("Television", office.television(1.30), (2.82, 0.518, 2.05), -90.0, ("electronics",), "Electronics", True)
    speaker = scene.shared("SpeakerMesh", office.speaker(0.34))
    for z in (1.27, 2.83):
        scene.add("Speaker", speaker, (2.80, 0.518, z), -90.0, ("electronics",), "Electronics", True)
    # Sideboard on the north wall
    scene.add("Sideboard", sideboard(1.70, "oak", "oak", 3), (-1.35, 0.0, 1.135), 0.0, (*furniture, "storage"))
    scene.add("RecordPlayer", office.record_player(), (-1.82, 0.72, 1.12), 0.0, ("electronics",), "Electronics", True)
    scene.add("TableLamp", table_lamp("ceramic_blue"), (-0.72, 0.72, 1.11), 0.0, ("lamp",), "Lamps", True)
    scene.light("point", (-0.72, 1.10, 1.11), 7.0, reach=5.0)
    scene.add("Books", book_stack(4, 8), (-1.22, 0.72, 1.10), 80.0, ("decor", "book"), "Decor", True)
    scene.add(
        "Vase",
        union(vase("terracotta", 0.07, 0.22), leaf_tuft("leaf_light", 9, 0.34, 4).move(0, 0.2, 0)),
        (-1.20, 0.815, 1.10),
        tags=("decor", "plant"),
        group="Decor",
        movable=True,
    )
    scene.add("Painting", picture("painting_landscape", 1.15, 0.82, "oak"), (-1.35, 1.62, 0.902), 0.0, decor, "Decor")
    scene.add(
        "Painting", picture("painting_abstract", 0.50, 0.66, "painted_black"), (-2.65, 1.55, 0.902), 0.0, decor, "Decor"
    )
    scene.add(
        "Table",
        round_table(0.23, 0.52, "walnut", "brass"),
        (-1.55, 0.0, 1.42 - 0.02),
        0.0,
        (*furniture, "side_table"),
        movable=True,
    )
    scene.add("Book", book_stack(2, 9), (-1.55, 0.52, 1.40), 30.0, ("decor", "book"), "Decor", True)
    scene.add("FloorLamp", floor_lamp(), (2.62, 0.0, 3.0 - 3.0 + 5.0 - 0.02), 0.0, ("lamp",), "Lamps", True)
    scene.light("point", (2.62, 1.42, 4.98), 9.0, reach=6.0)
    scene.add(
        "Plant",
        potted("ceramic_white", 0.19, 0.36, fiddle_plant(4, 1.45, 30)),
        (0.28, 0.0, 5.0),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add(
        "Plant",
        potted("terracotta", 0.16, 0.30, snake_plant(6, 0.85, 13)),
        (-3.0, 0.0, 5.0),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add(
        "Plant",
        potted("ceramic_blue", 0.11, 0.16, fern(7, 0.30, 13)),
        (1.95, 0.80, 5.22),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add(
        "Basket",
        union(basket(0.22, 0.34), box("boucle_grey", (0.30, 0.14, 0.28), 0.06, 3).move(0, 0.31, 0)),
        (-1.62, 0.0, 4.30),
        tags=decor,
        group="Decor",
        movable=True,
    )
    window_curtains(scene, -1.3, 5.30, 2.2, 2.42, "curtain_living", 180.0, 51, 0.62)
    window_curtains(scene, 1.7, 5.30, 1.6, 2.42, "curtain_living", 180.0, 61, 0.40)
    drop = 0.62
    shade = pendant(drop + 0.25, "painted_black", 0.26)
    scene.add("CeilingLamp", shade, (-0.1, CEILING, 2.8), tags=("lamp",), group="Lamps")
    scene.light("point", (-0.1, CEILING - drop - 0.30, 2.8), 22.0, reach=9.0)
    del room


def kitchen_room(scene: Scene) -> None:
    scene.room = "Kitchen"
    fitted = ("furniture", "fitted")
    appliance = ("appliance",)
    ware = ("tableware",)
    # East run along x = 7: units face -X.
    east = 6.995
    for z, width, kind in (
        (1.83, 0.60, "drawers"),
        (2.50, 0.74, "doors"),
        (3.27, 0.80, "doors"),
        (3.97, 0.60, "drawers"),
        (4.43, 0.32, "doors"),
    ):
        scene.add("Cupboard", kitchen.base_unit(width, kind), (east, 0.0, z), -90.0, (*fitted, "storage"))
    scene.add(
        "Worktop", kitchen.worktop_with_sink(3.69, 0.0 + (2.745 - 3.10)), (east, 0.0, 2.745), -90.0, (*fitted, "sink")
    )
    scene.add("Tap", kitchen.tap(), (east - 0.06, kitchen.WORKTOP, 3.10), -90.0, ("fixture",), "Fixtures")
    scene.add("Refrigerator", kitchen.fridge(), (east, 0.0, 4.93), -90.0, appliance, "Appliances")
    for z, width in ((1.45, 0.66), (2.02, 0.48)):
        scene.add("WallCupboard", kitchen.wall_unit(width, 0.72), (east, 1.45, z), -90.0, (*fitted, "storage"))
    # North run along z = 0.9: units face +Z.
    north = 0.905
    for x, width, kind in ((4.90, 0.40, "drawers"), (5.42, 0.62, "oven"), (6.03, 0.60, "doors")):
        scene.add("Cupboard", kitchen.base_unit(width, kind), (x, 0.0, north), 0.0, (*fitted, "storage"))
    scene.add(
        "Cupboard",
        box_at("painted_sage", (0.64, 0.77, 0.56), 0, 0.10, 0.28, 0.002),
        (6.66, 0.0, north),
        0.0,
        (*fitted, "storage"),
    )
    scene.add("Worktop", kitchen.worktop(2.30), (5.85, 0.0, north), 0.0, fitted)
    scene.add(
        "Backsplash",
        box("metro_tiles", (2.29, 0.56, 0.012), 0.0).move(0, 0.28, 0.006),
        (5.85, kitchen.WORKTOP, north - 0.002),
        0.0,
        fitted,
        "Structure",
    )
    scene.add(
        "Backsplash",
        box("metro_tiles", (1.42, 0.56, 0.012), 0.0).move(0, 0.28, 0.006),
        (east + 0.002, kitchen.WORKTOP, 1.64),
        -90.0,
        fitted,
        "Structure",
    )
    scene.add("Hob", kitchen.hob(), (5.42, kitchen.WORKTOP, north + 0.31), 0.0, appliance, "Appliances")
    scene.add("CookerHood", kitchen.hood(), (5.42, 1.62, north), 0.0, appliance, "Appliances")
    scene.light("spot", (5.42, 1.60, 1.20), 6.0, (1.0, 0.90, 0.76), 3.0, (30.0, 55.0), (0.0, -1.0, 0.0))
    for x, width in ((4.90, 0.40), (6.08, 0.66)):
        scene.add("WallCupboard", kitchen.wall_unit(width, 0.72), (x, 1.45, north), 0.0, (*fitted, "storage"))
    scene.add(
        "UnderCabinetLamp", kitchen.under_cabinet_light(0.55), (6.08, 1.45, north + 0.20), 0.0, ("lamp",), "Lamps"
    )
    scene.light("spot", (6.08, 1.42, 1.12), 4.0, (1.0, 0.90, 0.76), 2.5, (40.0, 70.0), (0.0, -1.0, 0.1))
    scene.add(
        "UnderCabinetLamp", kitchen.under_cabinet_light(0.9), (east - 0.20, 1.45, 1.75), -90.0, ("lamp",), "Lamps"
    )
    scene.light("spot", (6.79, 1.42, 1.75), 4.0, (1.0, 0.90, 0.76), 2.5, (40.0, 70.0), (-0.1, -1.0, 0.0))
    # On the worktops
    top = kitchen.WORKTOP
    scene.add("Kettle", kitchen.kettle(), (6.08, top, 1.15), 200.0, appliance, "Appliances", True)
    scene.add("Toaster", kitchen.toaster(), (6.72, top, 1.20), -50.0, appliance, "Appliances", True)
    scene.add("CoffeeMachine", kitchen.coffee_machine(), (6.76, top, 1.80), -90.0, appliance, "Appliances", True)
    scene.add("KnifeBlock", kitchen.knife_block(), (4.90, top, 1.10), 10.0, ("utensil",), "Decor", True)
    scene.add("UtensilJar", kitchen.utensil_jar(), (5.86, top, 1.02), 0.0, ("utensil",), "Decor", True)
    scene.add("CuttingBoard", kitchen.cutting_board(), (6.72, top, 2.36), -90.0, ("utensil", "food"), "Decor", True)
    for k, fill in enumerate(("pasta", "flour", "coffee")):
        scene.add(
            "Jar", kitchen.jar(fill, 0.20 - 0.025 * k), (6.86, top, 3.72 + 0.13 * k), 0.0, ("food",), "Decor", True
        )
    scene.add("Pan", kitchen.pan(0.115, 0.11, True), (5.27, top + 0.007, 1.10), 25.0, ("utensil",), "Decor", True)
    scene.add(
        "Pan", kitchen.pan(0.105, 0.06, False, "copper"), (5.57, top + 0.007, 1.34), 70.0, ("utensil",), "Decor", True
    )
    scene.add("Bottle", bottle("olive_oil", 0.27, 0.032), (5.74, top, 1.00), 0.0, ("food",), "Decor", True)
    scene.add("Bottle", kitchen_soap(), (6.88, top, 2.78), -90.0, ("fixture",), "Decor", True)
    scene.add(
        "Plates",
        union(*(plate("ceramic_white", 0.13 - 0.0002 * k).move(0.001 * (k % 3), 0.011 * k, 0) for k in range(6))),
        (6.70, top, 4.20),
        0.0,
        ware,
        "Decor",
        True,
    )
    scene.add(
        "Plant",
        potted("terracotta", 0.062, 0.105, leaf_tuft("leaf_light", 40, 0.12, 8)),
        (6.98, 1.15, 2.62),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add(
        "Plant",
        potted("terracotta", 0.062, 0.105, fern(9, 0.13, 9)),
        (6.98, 1.15, 3.55),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    scene.add(
        "Plant",
        potted("ceramic_white", 0.075, 0.12, trailing_plant(12, 10, 0.5)),
        (6.82, 2.17, 1.90),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    # Shelf with crockery on the west wall north of the opening
    shelf_z = 2.05
    for k, y in enumerate((1.45, 1.85)):
        scene.add("Shelf", wall_shelf(1.2), (3.122, y, shelf_z), 90.0, ("furniture", "storage"))
        for i in range(4):
            z = shelf_z - 0.45 + 0.16 * i
            scene.add(
                "Mug",
                mug(("ceramic_white", "ceramic_blue", "ceramic_sand", "ceramic_black")[(i + k) % 4]),
                (3.24, y, z),
                35.0 * i + 90,
                ware,
                "Decor",
                True,
            )
        scene.add(
            "Bowl",
            union(
                *(bowl("ceramic_sand" if k else "ceramic_white", 0.075, 0.055).move(0, 0.018 * i, 0) for i in range(3))
            ),
            (3.24, y, shelf_z + 0.38),
            0.0,
            ware,
            "Decor",
            True,
        )
    scene.add(
        "Books",
        book_row(0.28, 71, (0.17, 0.23), 0.14),
        (3.312, 1.85, shelf_z + 0.22),
        90.0,
        ("decor", "book"),
        "Decor",
        True,
    )
    # Dining
    scene.add("Table", dining_table(1.60, 0.86), (4.80, 0.0, 3.90), 0.0, ("furniture", "dining_table"), movable=True)
    chair = scene.shared("DiningChairMesh", dining_chair())
    for x, z, yaw in ((4.20, 3.52, 90.0), (4.18, 4.28, 84.0), (5.41, 3.52, -90.0), (5.44, 4.28, -97.0)):
        scene.add("Chair", chair, (x, 0.0, z), yaw, ("furniture", "seat"), movable=True)
    setting_plate, setting_bowl, glass = (
        scene.shared("DinnerPlate", plate("ceramic_white", 0.132)),
        scene.shared("SoupBowl", bowl("ceramic_blue", 0.082, 0.052)),
        scene.shared("WineGlassMesh", wine_glass()),
    )
    for side, z in ((-1, 3.52), (-1, 4.28), (1, 3.52), (1, 4.28)):
        x = 4.80 + side * 0.27
        scene.add("Plate", setting_plate, (x, 0.75, z), 0.0, ware, "Decor", True)
        scene.add("SoupBowl", setting_bowl, (x, 0.757, z), 0.0, ware, "Decor", True)
        scene.add("WineGlass", glass, (4.80 + side * 0.12, 0.75, z + 0.17), 0.0, ware, "Decor", True)
        cutlery = Mesh()
        for k, w in ((-1, 0.010), (1, 0.014)):
            cutlery.add(
                box_at("steel", (0.19, 0.002, w), 0, 0, k * 0.158, 0.0006),
                box_at("steel", (0.05, 0.002, 0.022), side * -0.075, 0, k * 0.158, 0.0008),
            )
        scene.add("Cutlery", cutlery, (x + side * 0.01, 0.75, z), 0.0, ware, "Decor", True)
    scene.add("Bottle", bottle("wine", 0.31, 0.038), (4.72, 0.75, 4.02), 0.0, ("food",), "Decor", True)
    scene.add(
        "Vase",
        union(
            vase("ceramic_white", 0.06, 0.20),
            *(
                union(
                    tube(
                        "stem",
                        [(0, 0.15, 0), (0.05 * math.cos(k * 1.3), 0.36 + 0.02 * (k % 3), 0.05 * math.sin(k * 1.3))],
                        0.0025,
                        6,
                    ),
                    leaf_tuft("petal", 9, 0.055, k).move(
                        0.05 * math.cos(k * 1.3), 0.36 + 0.02 * (k % 3), 0.05 * math.sin(k * 1.3)
                    ),
                )
                for k in range(7)
            ),
        ),
        (4.84, 0.75, 3.78),
        0.0,
        ("decor", "plant"),
        "Decor",
        True,
    )
    lamp = scene.shared("KitchenPendant", pendant(1.02, "painted_sage", 0.17))
    for z in (3.50, 4.30):
        scene.add("CeilingLamp", lamp, (4.80, CEILING, z), tags=("lamp",), group="Lamps")
        scene.light("point", (4.80, CEILING - 1.06, z), 9.0, reach=6.0)
    scene.add(
        "Painting",
        picture("painting_botanical", 0.44, 0.58, "oak"),
        (3.122, 1.62, 1.24 - 0.02),
        90.0,
        ("decor",),
        "Decor",
    )
    scene.add("Clock", office.wall_clock(), (4.62, 2.30 - 0.05, 0.902), 0.0, ("decor",), "Decor")
    scene.add("Rug", rug("rug_hall", 0.75, 1.6), (6.0, 0.0, 2.85), 0.0, ("textile",), "Textiles")
    window_curtains(scene, 4.75, 5.30, 1.7, 2.42, "curtain_living", 180.0, 71, 0.36)


def kitchen_soap() -> Mesh:
    from furniture_bath import pump_bottle

    return pump_bottle("soap", 0.17)


def hall(scene: Scene) -> None:
    scene.room = "Hall"
    scene.add("Rug", rug("rug_hall", 0.80, 4.2).rotate("y", 90), (0.4, 0.0, 0.05), 0.0, ("textile",), "Textiles")
    scene.add("Console", console_table(1.15), (-1.8, 0.0, 0.615), 180.0, ("furniture", "table"))
    scene.add("Mirror", round_mirror(0.38), (-1.8, 1.55, 0.778), 180.0, ("decor",), "Decor")
    scene.add("TableLamp", table_lamp("ceramic_black"), (-2.18, 0.80, 0.62), 0.0, ("lamp",), "Lamps", True)
    scene.light("point", (-2.18, 1.17, 0.62), 5.0, reach=4.0)
    scene.add(
        "Bowl",
        union(bowl("brass", 0.11, 0.05), office.key_bowl().move(0, 0.014, 0)),
        (-1.45, 0.80, 0.62),
        0.0,
        ("decor",),
        "Decor",
        True,
    )
    scene.add("Books", book_stack(3, 14), (-1.85, 0.176, 0.62), 100.0, ("decor", "book"), "Decor", True)
    scene.add(
        "Vase",
        union(vase("ceramic_sand", 0.07, 0.25), leaf_tuft("leaf", 11, 0.30, 21).move(0, 0.22, 0)),
        (-1.78, 0.80, 0.64),
        0.0,
        ("decor", "plant"),
        "Decor",
        True,
    )
    scene.add("Bench", bench(1.0, "linen_blue"), (5.95, 0.0, -0.50), 0.0, ("furniture", "seat"), movable=True)
    scene.add("CoatRack", coat_rack(1.1), (5.95, 1.72, -0.698), 0.0, ("furniture", "storage"))
    for k, (cloth, x) in enumerate((("linen_blue", 5.59), ("boucle_grey", 5.95), ("linen_rust", 6.32))):
        scene.add(
            "Coat",
            office.coat(cloth, k, 0.98 - 0.12 * (k % 2)),
            (x, 1.68, -0.635),
            0.0,
            ("textile", "clothing"),
            "Textiles",
            True,
        )
    left, right = (
        scene.shared("ShoeLeather", office.shoe("leather")),
        scene.shared("ShoeCanvas", office.shoe("linen_white")),
    )
    for mesh, x, yaw in ((left, 5.70, 4.0), (left, 5.82, -3.0), (right, 6.08, 6.0), (right, 6.20, -2.0)):
        scene.add("Shoe", mesh, (x, 0.0, -0.47), yaw, ("clothing",), "Decor", True)
    scene.add(
        "UmbrellaStand", office.umbrella_stand(), (6.78, 0.0, 0.62 - 0.01), 30.0, ("furniture", "storage"), movable=True
    )
    scene.add(
        "DoorMat",
        box_at("wicker", (0.50, 0.016, 0.85), 0, 0, 0, 0.004),
        (6.62, 0.0, 0.05),
        0.0,
        ("textile",),
        "Textiles",
        True,
    )
    scene.add(
        "Painting",
        picture("painting_waves", 0.52, 0.68, "painted_black"),
        (1.10, 1.58, -0.698),
        0.0,
        ("decor",),
        "Decor",
    )
    scene.add(
        "Painting",
        picture("painting_abstract_2", 0.52, 0.68, "painted_black"),
        (3.20, 1.58, -0.698),
        0.0,
        ("decor",),
        "Decor",
    )
    scene.add(
        "Painting", picture("painting_botanical", 0.40, 0.54, "oak"), (-1.45, 1.58, -0.698), 0.0, ("decor",), "Decor"
    )
    scene.add("Painting", picture("painting_waves", 0.40, 0.54, "oak"), (-2.05, 1.58, -0.698), 0.0, ("decor",), "Decor")
    scene.add("Mirror", framed_mirror(0.45, 1.5, "oak"), (5.35, 1.15, 0.778), 180.0, ("decor",), "Decor")
    scene.add(
        "Plant",
        potted("wicker", 0.17, 0.32, fiddle_plant(14, 1.15, 22, "leaf", 0.20)),
        (-3.10, 0.0, 0.05),
        tags=("plant",),
        group="Plants",
        movable=True,
    )
    lamp = scene.shared("HallLamp", flush_lamp(0.18))
    for x in (-1.4, 2.0, 5.4):
        scene.add("CeilingLamp", lamp, (x, CEILING, 0.04), tags=("lamp",), group="Lamps")
        scene.light("point", (x, CEILING - 0.16, 0.04), 9.0, (1.0, 0.88, 0.74), 6.0)
