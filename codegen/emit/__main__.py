# SPDX-License-Identifier: MIT
"""``python codegen/emit COMMAND``: works on the source tree, before the Python package is built."""

from __future__ import annotations

import sys
from pathlib import Path

if not __package__:
    # Run as a folder: the package is what the folder holds, found from its parent.
    sys.path[0] = str(Path(__file__).resolve().parent.parent)
    from emit.cli import main
else:
    from .cli import main

if __name__ == "__main__":
    sys.exit(main())
