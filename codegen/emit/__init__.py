# SPDX-License-Identifier: MIT
"""Everything made from reflection schemas: registration code, typed Python stubs, C++ proxies, the API reference.

The build runs this folder as ``python codegen/emit COMMAND``; the Python package carries the same files as ``spear.codegen``, behind
``spear schema``. Nothing is imported here: the run time reads :mod:`.names` and pays for that alone.
"""
