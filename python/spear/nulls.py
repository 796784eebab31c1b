# SPDX-License-Identifier: MIT
"""Where a null object cannot be meant: the cold path of results that are null (the native half calls it then, and only then)."""

from __future__ import annotations

from typing import Any

from spear import _native, facts
from spear.errors import Error, NullObject


def null_result(session: Any, target: Any, name: str, is_function: bool, value: Any) -> None:
    """Raises NullObject for a variable that is null, and for null results of functions that never return null by their facts.

    ``value`` is the result with a None in it; ``target`` the object (or the future of it), ``name`` the function or the path.
    """
    if not is_function:
        if value is None:
            raise NullObject(f"'{name}' of {_text(target)} is null. get_or_none() gives None instead", f"{_class_of(target)}.{name}")
        return
    if isinstance(target, _native.Future):
        target = _value_of(target)
    if not isinstance(target, _native.Object):
        return
    for owner in _classes_of(session, target):
        entity = facts.class_facts(owner)
        for entry in entity.get("never_null") or () if entity else ():
            function, _, output = entry.partition(".")
            if function.removesuffix("[]").lower() != name.lower():
                continue
            name = function.removesuffix("[]")
            output = output or ("[]" if function.endswith("[]") else "")
            what = _null_in(value, output)
            if what is not None:
                raise NullObject(
                    f"{owner}::{name} of {_text(target)} returned a null object{what}. Where that may be, object.call({name!r}, ...) gives None instead",
                    f"{owner}::{name}")


def _null_in(value: Any, output: str) -> str | None:
    """Where in the result the null is that an entry of facts forbids, in words; None if it is not there."""
    where = ""
    if output.removesuffix("[]"):
        if not isinstance(value, tuple):
            return None
        from spear.codegen.names import python_name

        word = output.removesuffix("[]")
        value = getattr(value, python_name(word, "result"), ...)
        where = f" as {word}"
    if not output.endswith("[]"):
        return where if value is None else None
    if isinstance(value, list | set | frozenset) and None in value:
        return f"{where} in the container"
    return None


def _classes_of(session: Any, target: Any) -> tuple[str, ...]:
    """The classes of an object, most derived first; of a class object those that it stands for, as its static functions are called."""
    names: tuple[str, ...] = target._class_names
    if "UClass" not in names:
        return names
    try:
        path = str(session.call("unreal_service.get_path_name", (target,), {}, _native.SYNC))
    except Error:
        return names
    reflected = path.rpartition(".")[2]
    own = next((prefix + reflected for prefix in "UA" if facts.class_facts(prefix + reflected) is not None), None)
    chain = []
    while own is not None:
        chain.append(own)
        own = (facts.class_facts(own) or {}).get("super")
    return (*chain, *names)


def _value_of(future: Any) -> Any:
    """What a future gave, whose dependant has run."""
    try:
        return future.get()
    except Error:
        return None


def _class_of(target: Any) -> str:
    return target._class_name if isinstance(target, _native.Object) else "object"


def _text(target: Any) -> str:
    return repr(target)
