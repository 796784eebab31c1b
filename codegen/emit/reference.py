# SPDX-License-Identifier: MIT
"""The API reference: a static site of everything a schema knows, read from files without a server.

One page per type, one per module, a first page, the SDK's entry points, and a search over all names. How it is cut:

- ``reference_site.py``: files, anchors, links; ``reference_pages.py``: what a type's page shows; ``reference_spelling.py``: Python and C++;
- ``reference_index.py``: the search index; ``templates/reference``: HTML, style sheet, scripts.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from pathlib import Path
from typing import Any

import jinja2
from markupsafe import Markup

from .names import python_name
from .output import MANIFEST, Output
from .parallel import for_each
from .reference_entry_points import Service, services
from .reference_index import index_files
from .reference_pages import Pages
from .reference_site import Page, Site
from .schema import SchemaError, SchemaSet

TEMPLATES = Path(__file__).resolve().parent / "templates" / "reference"
_ASSETS = ("reference.css", "reference.js", "search.js")
_TITLE = "SPEAR API reference"
#: About so many functions and properties are one piece of work for a process.
_MEMBERS_PER_CHUNK = 600

_KINDS = (("class", "Classes"), ("interface", "Interfaces"), ("struct", "Structs"), ("enum", "Enums"), ("delegate", "Delegates"))


def emit(schemas: SchemaSet, output_dir: Path, *, progress: bool = False, jobs: int = 0, title: str = _TITLE) -> Output:
    """Writes the site. The folder must be empty, new, or hold a site written before; files of the last site that are not part of this one are removed."""
    _check_folder(output_dir)
    return _Writer(schemas, output_dir, title).write(progress, jobs)


def _check_folder(folder: Path) -> None:
    """Refuses a folder that holds something else: nobody's files are to be overwritten or removed."""
    if folder.exists() and not folder.is_dir():
        raise SchemaError(f"{folder} is a file; the reference needs a folder")
    if not folder.is_dir() or not any(folder.iterdir()):
        return
    if "assets/reference.css" not in _manifest(folder):
        raise SchemaError(f"{folder} is not empty and was not written by `spear schema docs`; give a new or an empty folder (its files would be overwritten)")


def _manifest(folder: Path) -> set[str]:
    """The files that a folder's manifest lists; none, if it has no manifest or a broken one."""
    try:
        files = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))["files"]
    except (OSError, ValueError, KeyError, TypeError):
        return set()
    return {name for name in files if isinstance(name, str)} if isinstance(files, list) else set()


@dataclass
class _Row:
    """A type in a module's list."""

    name: str
    url: str
    summary: Markup
    numbers: list[str]


@dataclass
class _Section:
    """The types of one kind in a module's list."""

    id: str
    title: str
    columns: list[str]
    rows: list[_Row]


class _Writer:
    """One run."""

    def __init__(self, schemas: SchemaSet, output_dir: Path, title: str) -> None:
        self.schemas = schemas
        self.site = Site(schemas, title)
        self.output = Output(output_dir)
        self.services = services()
        environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=False,
                                         auto_reload=False, keep_trailing_newline=True)
        # Compiled here, once: the processes inherit them.
        self.templates = {name: environment.get_template(name + ".html") for name in ("index", "module", "type", "entry_points")}

    @cached_property
    def pages(self) -> Pages:
        """Made in each process when it is first needed."""
        return Pages(self.site)

    def write(self, progress: bool, jobs: int) -> Output:
        """Everything, each file once."""
        self._claim()
        # Worked out once, before the processes part.
        _ = self.site.delegate_variables, self.schemas.subclasses, self.schemas.derived_structs, self.schemas.implementers
        chunks = self._chunks()
        results = for_each(chunks, self._write_pages, jobs=jobs, progress=progress, title="reference")
        summaries: dict[str, list[str]] = {}
        for part, found in results:
            self.output.merge(part)
            summaries.update(found)
        self._write_modules(summaries)
        self._write_index()
        if self.services:
            self._write_entry_points(self.services)
        for name in _ASSETS:
            self.output.write_bytes("assets/" + name, (TEMPLATES / name).read_bytes())
        points = {s.name: [(p.name, p.anchor, p.doc) for p in s.points] for s in self.services}
        for name, text in index_files(self.site, summaries, points).items():
            self.output.write("assets/" + name, text)
        return self.output.finish()

    def _claim(self) -> None:
        """Adds to the manifest what will be written, so that a run that was stopped leaves a folder that the next one accepts and cleans."""
        planned = {"assets/" + name for name in _ASSETS} | {page.path for pages in self.site.pages.values() for page in pages}
        manifest = self.output.directory / MANIFEST
        known = _manifest(self.output.directory)
        if planned <= known:
            return
        self.output.directory.mkdir(parents=True, exist_ok=True)
        text = json.dumps({"$comment": "Generated by SPEAR, do not edit: the files it wrote here.", "files": sorted(planned | known)}, indent=0)
        manifest.write_text(text + "\n", encoding="utf-8")

    def _chunks(self) -> list[list[Page]]:
        chunks: list[list[Page]] = []
        members = _MEMBERS_PER_CHUNK
        for pages in self.site.pages.values():
            for page in pages:
                if members >= _MEMBERS_PER_CHUNK:
                    chunks.append([])
                    members = 0
                chunks[-1].append(page)
                members += 3 + len(page.functions) + len(page.properties)
        return chunks

    def _render(self, template: str, name: str, output: Output, **values: Any) -> None:
        root = "../" if "/" in name else ""
        defaults = {"site": self.site, "root": root, "crumbs": [], "side": True, "languages": False, "description": ""}
        output.write(name, self.templates[template].render(defaults | values))

    def _write_pages(self, pages: Sequence[Page]) -> tuple[Output, dict[str, list[str]]]:
        output = Output(self.output.directory)
        summaries = {}
        for page in pages:
            content = self.pages.content(page)
            summaries[page.path] = content.summaries
            crumbs = [(self.site.title, "../index.html"), (page.module, "index.html")]
            self._render("type", page.path, output, crumbs=crumbs, languages=True, **content.values)
        return output, summaries

    # Lists -----------------------------------------------------------------------------------------------------------------

    def _write_modules(self, summaries: dict[str, list[str]]) -> None:
        for module, pages in self.site.pages.items():
            directory = self.site.directories[module]
            sections = []
            for kind, title in _KINDS:
                columns = {"class": ["Functions", "Properties"], "interface": ["Functions"], "struct": ["Fields"], "enum": ["Values"], "delegate": ["Parameters"]}[kind]
                rows = [_Row(page.title, page.file + ".html", Markup(self.site.inline(summaries[page.path][0], directory)), self._numbers(page)) for page in pages if page.kind == kind]
                if rows:
                    sections.append(_Section("section-" + title.lower(), title, columns, rows))
            source = self.schemas.modules[module].entry.get("source", {})
            facts = [("Python", Markup(f"<code>from spear.unreal.{escape(python_name(module, 'type'))} import ...</code>")),
                     ("C++", Markup(f"<code>#include &lt;spear/unreal/{escape(module)}/...&gt;</code>")), ("Package", Markup(f"<code>/Script/{escape(module)}</code>"))]
            if source.get("build_cs"):
                facts.append(("Build file", Markup(f"<code>{escape(source['build_cs'].replace(chr(92), '/').rpartition('/')[2])}</code>")))
            headers = [(header.path, Markup(", ".join(self.site.link(e["name"], directory) for kind in (header.classes, header.structs, header.enums) for e in kind)))
                       for header in self.schemas.modules[module].headers if header.path]
            self._render("module", directory + "/index.html", self.output, heading=module, crumbs=[(self.site.title, "../index.html")], facts=facts, sections=sections,
                         headers=headers, description=f"Types of the module {module}")

    @staticmethod
    def _numbers(page: Page) -> list[str]:
        if page.kind == "class":
            return [_number(len(page.functions)), _number(len(page.properties))]
        count = {"interface": len(page.functions), "struct": len(page.properties), "enum": len(page.entries)}.get(page.kind)
        return [_number(len(page.entity["parameters"]) if count is None else count)]

    def _write_index(self) -> None:
        columns = [("class", "Classes"), ("struct", "Structs"), ("enum", "Enums"), ("delegate", "Delegates"), ("function", "Functions"), ("property", "Properties")]
        rows = []
        for module in self.site.pages:
            counts = self.site.counts(module)
            counts["class"] += counts["interface"]
            rows.append({"name": module, "url": self.site.directories[module] + "/index.html", "numbers": [_number(counts[kind]) for kind, _ in columns]})
        counts = self.site.counts()
        figures = [(text, _number(counts[kind])) for kind, text in (("class", "classes"), ("interface", "interfaces"), ("struct", "structs"), ("enum", "enums"),
                                                                   ("delegate", "delegates"), ("function", "functions"), ("property", "properties"))]
        self._render("index", "index.html", self.output, heading=self.site.title, side=False, modules=rows, columns=[title for _, title in columns], figures=figures,
                     entry_points=sum(len(s.points) for s in self.services), description="Reference of the classes, structs, enums, functions and properties that SPEAR reaches",
                     example_address=self._example_address(), example=self.pages.speller.example())

    def _example_address(self) -> str:
        """Where a function stands: AActor's where it is there, else one of the class with the most functions."""
        page = self.site.page_named("AActor")
        if page is not None and "SetActorScale3D" in page.functions:
            return f"{page.path}#SetActorScale3D"
        classes = [p for pages in self.site.pages.values() for p in pages if p.functions]
        page = max(classes, key=lambda p: (len(p.functions), p.title), default=None)
        return f"{page.path}#{page.functions[0]}" if page else "index.html"

    def _write_entry_points(self, found: Sequence[Service]) -> None:
        self._render("entry_points", "entry_points.html", self.output, heading="Entry points", crumbs=[(self.site.title, "index.html")], services=found,
                     description="What the SPEAR server offers itself")


def _number(value: int) -> str:
    """A count; nothing is shown for none."""
    return f"{value:,}" if value else "–"
