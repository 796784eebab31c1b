# SPDX-License-Identifier: MIT
"""Opens a door from Python; open_door.cpp beside it does the same and prints the same.

    tools/spear engine --address unix:/tmp/door.sock --plugin-dir build/release/example_plugins
    PYTHONPATH=build/release/python python examples/door/open_door.py unix:/tmp/door.sock
"""

import argparse

import spear


def main() -> None:
    parser = argparse.ArgumentParser(description="Opens a door in a running engine that has the Door plugin.")
    parser.add_argument("address", help="unix:/path or tcp://host:port")
    with spear.connect(parser.parse_args().address) as instance:
        game = instance.get_game()
        with instance.begin_frame():
            door = game.spawn_actor("ADoor", location=(100, 0, 0))
            print(f"at most {door.MaxAngle.get():.1f} degrees")
            door.Open()
            print(f"Open(): {door.GetAngle():.1f}")
            door.Open(Angle=45)
            print(f"Open(45): {door.GetAngle():.1f}")
            door.MaxAngle = 60
            door.Open(Angle=80)
            print(f"Open(80) with MaxAngle 60: {door.GetAngle():.1f}")
            game.destroy_actor(door)
        with instance.end_frame():
            pass


if __name__ == "__main__":
    main()
