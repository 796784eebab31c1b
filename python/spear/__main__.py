# SPDX-License-Identifier: MIT
"""``python -m spear``: the command line."""

from spear.cli import main

if __name__ == "__main__":
    main()
