# SPDX-License-Identifier: MIT
"""The offline dump of the embedded engine equals the live one, tier by tier. The live one comes from UClass and FProperty alone."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import helpers
import jsonschema
import pytest

import spear

#: Module -> entities that must be there at least, so that two empty dumps are no success.
MODULES = {"CoreUObject": 20, "Engine": 150, "SpearServer": 1, "RoundTrip": 5, "Door": 1}


@pytest.fixture(scope="module")
def engine(build_directory: Path) -> Iterator[spear.Instance]:
    """An engine with the server and all plugins that are no part of it."""
    plugins = [argument for folder in ("test_plugins", "example_plugins") for argument in ("--plugin-dir", str(build_directory / folder))]
    with spear.launch(scene="apartment", fps=0, arguments=plugins) as running:
        yield running


def offline(build_directory: Path, module: str) -> dict[str, Any]:
    document = json.loads((build_directory / "codegen" / module / f"{module}.schema.json").read_text(encoding="utf-8"))
    assert document["origin"] == "offline"
    return dict(document)


@pytest.mark.parametrize("module", MODULES)
def test_offline_equals_live(engine: spear.Instance, build_directory: Path, module: str) -> None:
    written, running = offline(build_directory, module), engine.get_schema([module])
    assert running["origin"] == "live"
    assert sum(len(written[kind]) for kind in ("classes", "structs", "enums", "delegates")) >= MODULES[module]
    for tier in (helpers.runtime_tier, helpers.without_source):
        left, right = tier(written), tier(running)
        found = list(helpers.differences(left, right))
        assert not found, f"{len(found)} differences in {tier.__name__}:\n" + "\n".join(found[:40])
        # Text against text as well: no difference that the comparison above might not see (1 and 1.0, the order of keys).
        assert json.dumps(left, sort_keys=True) == json.dumps(right, sort_keys=True)


def test_several_modules_are_the_sum(engine: spear.Instance) -> None:
    together, engine_alone, door_alone = engine.get_schema(["Engine", "Door"]), engine.get_schema(["Engine"]), engine.get_schema(["Door"])
    for kind in ("modules", "classes", "structs", "enums", "delegates"):
        key = lambda entity: (entity["name"], entity.get("path", ""))  # noqa: E731
        assert together[kind] == sorted(engine_alone[kind] + door_alone[kind], key=key)
    everything = {module["name"] for module in engine.get_schema()["modules"]}
    assert set(MODULES) <= everything


def test_live_dump_is_a_good_schema(engine: spear.Instance, source_directory: Path) -> None:
    rules = json.loads((source_directory / "codegen" / "schema.schema.json").read_text(encoding="utf-8"))
    errors = [f"/{'/'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in jsonschema.Draft202012Validator(rules).iter_errors(engine.get_schema())]
    assert not errors, "\n".join(errors[:20])


def test_live_dump_has_no_source_tier(engine: spear.Instance) -> None:
    """Comments and C++ texts are known offline only: their presence would mean that schema text was embedded."""

    def keys(node: Any) -> Iterator[str]:
        if isinstance(node, dict):
            for key, value in node.items():
                if key != "meta":
                    yield key
                    yield from keys(value)
        elif isinstance(node, list):
            for item in node:
                yield from keys(item)

    assert "source" not in set(keys(engine.get_schema()))
