# SPDX-License-Identifier: MIT
"""The SDK's own entry points, as the native part of the installed ``spear`` package lists them (nothing, where it is not installed)."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module

from .reference_site import numbered


@dataclass
class EntryPoint:
    """One call of the server."""

    name: str
    anchor: str
    doc: str
    signature: str
    runs_on: str


@dataclass
class Service:
    """Entry points that belong together."""

    name: str
    id: str
    points: list[EntryPoint]


def services() -> list[Service]:
    """All entry points by service, sorted by name."""
    try:
        listed = import_module("spear._native").ENTRY_POINTS
    except (ImportError, AttributeError):
        return []
    listed = sorted(listed)
    result: dict[str, Service] = {}
    for (full_name, _, runs_on, doc, signature), anchor in zip(listed, numbered(entry[0] for entry in listed)):
        service, _, name = full_name.rpartition(".")
        group = result.setdefault(service, Service(service, "section-" + service, []))
        group.points.append(EntryPoint(name, anchor, doc, signature.partition(" @")[0], runs_on.replace("_", " ")))
    return list(result.values())
