# SPDX-License-Identifier: MIT
"""``python codegen/emit COMMAND``: works on the source tree, before the Python package is built."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path

if not __package__:
    # Run as a folder: the package is what the folder holds, found from its parent.
    sys.path[0] = str(Path(__file__).resolve().parent.parent)
    package = "emit"
else:
    package = __package__

if __name__ == "__main__":
    sys.exit(import_module(f"{package}.cli").main())
