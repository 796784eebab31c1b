# SPDX-License-Identifier: MIT
"""A synthetic Unreal code base of any size, in the varied shapes of real ones. `make_code_base.py` is its command line."""
