# SPDX-License-Identifier: MIT
"""Puts the apartment together."""

from __future__ import annotations

from typing import Any

import building
import rooms_day
import rooms_night
from scene import Scene

# Photographic units as UE's defaults: the sun has 10 lux, lamps a few candela, so that both show in one exposure.
SUN_LUX = 10.0
SUN_DIRECTION = (-0.50, -0.62, -0.60)

SETTINGS: dict[str, Any] = {
    "game_mode": "AGameModeBase",
    "world_settings": {"KillZ": -10000.0},
}


def apartment() -> Scene:
    """The scene, always the same."""
    scene = Scene("apartment")
    building.build(scene)
    rooms_day.living_room(scene)
    rooms_day.kitchen_room(scene)
    rooms_day.hall(scene)
    rooms_night.bedroom(scene)
    rooms_night.bathroom(scene)
    rooms_night.study(scene)
    building.outside(scene)
    scene.room = ""
    scene.light("directional", (0.0, 12.0, 0.0), SUN_LUX, (1.0, 0.93, 0.82), direction=SUN_DIRECTION)
    scene.actor("SkyAtmosphere_1", "ASkyAtmosphere", (0.0, 0.0, 0.0), tags=["sky", "outside"], folder="Lights")
    scene.actor(
        "SkyLight_1",
        "ASkyLight",
        (0.0, 0.0, 1000.0),
        tags=["light", "sky", "outside"],
        folder="Lights",
        properties={"LightComponent.Intensity": 1.0},
    )
    # The middle of the living room is free in front of the sofa; the player looks at the library.
    scene.actor("PlayerStart_1", "APlayerStart", (180.0, 200.0, 92.0), (0.0, 160.0, 0.0), tags=["start"])
    return scene
