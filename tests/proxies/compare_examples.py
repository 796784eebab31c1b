# SPDX-License-Identifier: MIT
"""compare_examples.py UNTYPED TYPED: the first example, by name and by typed proxies, must say the same of the same simulation."""

import subprocess
import sys

untyped = subprocess.run([sys.argv[1], "--steps", "30"], capture_output=True, text=True, check=True).stdout.splitlines()
typed = subprocess.run([sys.argv[2], "", "30"], capture_output=True, text=True, check=True).stdout.splitlines()
if len(typed) != 4 or untyped[:-1] != typed:  # the last line counts what is reflected
    sys.exit(f"the examples differ:\n{untyped}\n{typed}")
