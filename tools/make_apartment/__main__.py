# SPDX-License-Identifier: MIT
"""Makes the furnished apartment that the embedded engine loads by default.

    python tools/make_apartment --output <folder> [--workers N]

writes <folder>/Scenes/apartment/{apartment.gltf, apartment.bin, apartment.scene.json, textures/*.jpg}, byte for byte
the same each time.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from apartment import SETTINGS, apartment  # noqa: E402
from gltf_writer import write  # noqa: E402


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="make_apartment", description="Make the furnished apartment scene (glTF 2.0 and sidecar)."
    )
    parser.add_argument(
        "--output", type=Path, required=True, help="content folder; files go to Scenes/apartment below it"
    )
    parser.add_argument(
        "--workers",
        type=int,
        default=os.cpu_count() or 1,
        help="processes that make textures (default: all processors)",
    )
    parser.add_argument("--quiet", action="store_true", help="print nothing on success")
    arguments = parser.parse_args()
    scene = apartment()
    write(scene, SETTINGS, arguments.output / "Scenes" / scene.name, arguments.workers)
    if not arguments.quiet:
        objects = [node for node in scene.nodes if node.mesh is not None]
        triangles = sum(scene.meshes[node.mesh].triangle_count for node in objects if node.mesh is not None)
        lights = sum(node.light is not None for node in scene.nodes)
        print(f"apartment: {len(objects)} objects, {len(scene.meshes)} meshes, {triangles} triangles, {lights} lights")
    return 0


if __name__ == "__main__":
    sys.exit(main())
