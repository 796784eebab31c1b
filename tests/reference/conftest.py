# SPDX-License-Identifier: MIT
"""The reference of the embedded engine and a small awkward one, each written once; a browser, once."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "codegen"))
sys.path.insert(0, str(Path(__file__).parent))

from browser import Browser, find_chromium  # noqa: E402
from emit import reference  # noqa: E402
from emit.schema import SchemaSet  # noqa: E402
from schema_maker import SchemaMaker  # noqa: E402


@pytest.fixture(scope="session")
def engine_schemas(build_directory: Path) -> SchemaSet:
    """All that the header tool wrote for the embedded engine, the source tier too."""
    files = sorted((build_directory / "codegen").glob("*/*.schema.json"))
    assert files, f"no schema below {build_directory / 'codegen'}: build the engine first"
    return SchemaSet.load_all(files)


@pytest.fixture(scope="session")
def engine_site(engine_schemas: SchemaSet, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The reference of the embedded engine."""
    folder = tmp_path_factory.mktemp("site")
    reference.emit(engine_schemas, folder)
    return folder


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Chromium, 1280 x 900."""
    if find_chromium() is None:
        pytest.skip("Chromium is not installed")
    with Browser() as running:
        yield running


@pytest.fixture
def page(browser: Browser) -> Iterator[Browser]:
    """The browser as it is at first; the test fails if a page complained of something."""
    browser.problems.clear()
    browser.requested()
    browser.resize(1280, 900)
    browser.prefer("light")
    yield browser
    assert browser.problems == []
    assert [url for url in browser.requested() if not url.startswith(("file:", "data:", "about:"))] == [], "pages must load nothing from elsewhere"


@pytest.fixture
def maker() -> SchemaMaker:
    """An empty schema to add to."""
    return SchemaMaker()


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., Path]:
    """Writes the site of a SchemaMaker below tmp_path and gives its folder."""

    def make(maker: SchemaMaker, name: str = "site", **options: Any) -> Path:
        reference.emit(maker.schemas(), tmp_path / name, **options)
        return tmp_path / name

    return make
