# SPDX-License-Identifier: MIT
"""What functions with several outputs return: named tuples of ``ReturnValue`` and the out-parameters."""

from __future__ import annotations

from collections.abc import Sequence
from operator import itemgetter
from typing import TYPE_CHECKING, Any, ClassVar

_classes: dict[tuple[str, tuple[str, ...]], type[Result]] = {}


class Result(tuple[Any, ...]):
    """Base of all results with several outputs: a tuple (unpacking, indexing, ``==``) whose items have names as well."""

    __slots__ = ()
    #: The names of the items: ``ReturnValue``, if the function has one, and the out-parameters in Unreal's order.
    _fields: ClassVar[tuple[str, ...]] = ()

    def _asdict(self) -> dict[str, Any]:
        """The items by name."""
        return dict(zip(self._fields, self))

    if not TYPE_CHECKING:  # type checkers know the names from the stubs

        def __getattr__(self, name: str) -> Any:
            from spear.facts import advice

            if name.startswith("__"):
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            raise AttributeError(f"{type(self).__name__} has no output {name!r}{advice(name, self._fields, 'its outputs are')}")

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in zip(self._fields, self))})"

    def __reduce__(self) -> tuple[Any, ...]:
        return make, (type(self).__name__, self._fields, tuple(self))


def result_class(name: str, fields: Sequence[str]) -> type[Result]:
    """The class of a function's results, by Unreal's names of the outputs; always the same one for the same names."""
    from spear.codegen.names import python_names

    return _class_of(name, tuple(python_names(fields, "result")))


def _class_of(name: str, fields: tuple[str, ...]) -> type[Result]:
    made = _classes.get((name, fields))
    if made is None:
        namespace: dict[str, Any] = {field: property(itemgetter(index), doc=f"Item {index}.") for index, field in enumerate(fields)}
        namespace.update(__slots__=(), _fields=fields, __match_args__=fields, __module__="spear.results")
        made = _classes[name, fields] = type(name, (Result,), namespace)
    return made


def make(name: str, fields: tuple[str, ...], values: tuple[Any, ...]) -> Result:
    """A result of its parts: what ``pickle`` calls."""
    return _class_of(name, fields)(values)
