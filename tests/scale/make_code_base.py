#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes a synthetic Unreal code base: modules, headers, classes, structs, enums, interfaces and delegates in the varied shapes of real ones.

The same arguments give the same files, byte for byte. With --compilable it uses only what the embedded engine has, and comes with
sources and a CMakeLists.txt that registers it as a plugin.

examples:
  make_code_base.py -o /tmp/scale/base                                         # 3,000 headers, 15,000 functions, 55,000 properties
  make_code_base.py --headers 60 --functions 300 --properties 1100 -o /tmp/small
  make_code_base.py --compilable --headers 300 --functions 1500 --properties 5500 -o /tmp/compilable

Exit codes: 0 written, 2 wrong arguments, or the folder holds something else.
"""

from __future__ import annotations

import argparse
import json
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from code_base.write import build  # noqa: E402

MARK = ".synthetic-code-base.json"


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--headers", type=int, default=3000, help="number of reflected headers [3000]")
    parser.add_argument("--functions", type=int, default=15000, help="at least so many UFUNCTIONs [15000]")
    parser.add_argument("--properties", type=int, default=55000, help="at least so many UPROPERTYs [55000]")
    parser.add_argument("--seed", type=int, default=1, help="another seed, another code base [1]")
    parser.add_argument("--compilable", action="store_true", help="only what the embedded engine compiles, with sources and CMakeLists.txt")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="DIR", help="folder to write; one written before by this program is replaced")
    args = parser.parse_args()
    if args.headers < 24 or args.functions < 100 or args.properties < 100:
        parser.error("needs at least 24 headers, 100 functions and 100 properties")
    target: Path = args.output
    if target.exists() and not target.is_dir():
        parser.error(f"{target} is no folder")
    if target.is_dir() and any(target.iterdir()):
        if not (target / MARK).is_file():
            parser.error(f"{target} is not empty and was not written by this program")
        shutil.rmtree(target)
    target.mkdir(parents=True, exist_ok=True)

    def progress(done: int, total: int) -> None:
        if sys.stderr.isatty() and (done % 50 == 0 or done == total):
            print(f"\r{done}/{total} headers", end="\n" if done == total else "", file=sys.stderr)

    made = build(target, args.headers, args.functions, args.properties, args.seed, args.compilable, progress)
    (target / MARK).write_text(json.dumps({"$comment": "Made by make_code_base.py; it may replace this folder.", "seed": args.seed, "compilable": args.compilable, **made}, indent=2) + "\n")
    print(", ".join(f"{number} {name}" for name, number in made.items()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
