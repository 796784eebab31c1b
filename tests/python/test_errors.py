# SPDX-License-Identifier: MIT
"""The error classes are those of the C++ table, with its hierarchy."""

import spear
from spear import _native, errors


def test_hierarchy_is_the_tables() -> None:
    assert set(errors.BY_NAME) == {name for name, _, _ in _native.ERROR_ROWS}
    for name, parent, meaning in _native.ERROR_ROWS:
        python_class = errors.BY_NAME[name]
        assert python_class.__bases__ == ((errors.BY_NAME[parent],) if name != "Error" else (Exception,))
        assert python_class.__doc__ is not None and python_class.__doc__.rstrip(".").lower() == meaning.lower()
        assert getattr(spear, name) is python_class


def test_every_entry_point_is_documented() -> None:
    for name, parameters, _, documentation, _ in _native.ENTRY_POINTS:
        assert "." in name and documentation, name
        assert len(set(parameters)) == len(parameters), name
