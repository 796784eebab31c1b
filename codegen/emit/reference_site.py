# SPDX-License-Identifier: MIT
"""Where everything stands in the reference: files of types, anchors of members, links between them, pieces of HTML for types and comments."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from html import escape
from typing import Any

from .documentation import Documentation, html_text
from .names import short_entry_name
from .schema import INTRINSIC_CLASSES, SchemaSet

Entity = Mapping[str, Any]

#: Kind of a page -> its letter in the search index.
KIND_LETTERS = {"class": "c", "interface": "i", "struct": "s", "enum": "e", "delegate": "d"}

_UNSAFE = re.compile(r"[^A-Za-z0-9_]")
_LINK_OR_WORD = re.compile(r"<a .*?</a>|\b[A-Z][A-Za-z0-9_]{3,}\b", re.DOTALL)


def numbered(names: Iterable[str], taken: Iterable[str] = (), *, fold: bool = False) -> list[str]:
    """The names with everything but letters, digits and underscores replaced, and a number (``-2``) behind those that are there already.

    ``fold``: also names that differ only by case count as the same, as on many file systems.
    """
    used = set(taken)
    result = []
    for name in names:
        safe = _UNSAFE.sub("_", name) or "_"
        unique, number = safe, 1
        while (unique.lower() if fold else unique) in used:
            number += 1
            unique = f"{safe}-{number}"
        used.add(unique.lower() if fold else unique)
        result.append(unique)
    return result


@dataclass(frozen=True)
class Page:
    """The page of one type."""

    kind: str  # a key of KIND_LETTERS
    module: str
    #: folder of the module, and file without ``.html``
    directory: str
    file: str
    #: as it is shown: ``AActor``, ``IFoo`` for an interface
    title: str
    entity: Entity = field(compare=False)
    #: anchors, in the order of the entity's functions, properties, entries
    functions: tuple[str, ...] = ()
    properties: tuple[str, ...] = ()
    entries: tuple[str, ...] = ()

    @property
    def path(self) -> str:
        """The file, relative to the site."""
        return f"{self.directory}/{self.file}.html"


def is_interface(entity: Entity) -> bool:
    """Whether a class is a ``UINTERFACE``."""
    return "Interface" in entity.get("flags", ()) and entity["name"].startswith("U")


class Site:
    """All pages, and links to them as seen from a module's folder."""

    def __init__(self, schemas: SchemaSet, title: str) -> None:
        self.schemas = schemas
        self.title = title
        modules = [module for module in schemas.main_modules if module.entry]
        #: module -> its folder
        self.directories: Mapping[str, str] = dict(zip((m.name for m in modules), numbered((m.name for m in modules), {"assets"}, fold=True)))
        #: module -> its pages, by kind, then as in the schema
        self.pages: dict[str, list[Page]] = {}
        self._by_name: dict[str, Page] = {}
        self._delegates: dict[tuple[str, str], Page] = {}
        for module in modules:
            entities: list[tuple[str, Entity]] = [("interface" if is_interface(e) else "class", e) for e in module.classes]
            entities += [("struct", e) for e in module.structs] + [("enum", e) for e in module.enums] + [("delegate", e) for e in module.delegates]
            titles = [self._title(kind, entity) for kind, entity in entities]
            files = numbered((t.replace("::", "_") for t in titles), {"index"}, fold=True)
            pages = self.pages[module.name] = []
            for (kind, entity), shown, file in zip(entities, titles, files):
                functions, properties = entity.get("functions", ()), entity.get("properties", ())
                names = [x["name"] for x in functions] + [x["name"] for x in properties] + [short_entry_name(x["name"]) for x in entity.get("entries", ())]
                anchors = numbered(names)
                split = len(functions) + len(properties)
                page = Page(kind, module.name, self.directories[module.name], file, shown, entity,
                            tuple(anchors[: len(functions)]), tuple(anchors[len(functions): split]), tuple(anchors[split:]))
                pages.append(page)
                if kind == "delegate":
                    self._delegates[entity["owner"] or "", entity["name"]] = page
                else:
                    self._by_name[entity["name"]] = page
                    self._by_name.setdefault(shown, page)
        self._links: dict[tuple[str, str], str] = {}
        self._types: dict[tuple[str, str, str], str] = {}

    @staticmethod
    def _title(kind: str, entity: Entity) -> str:
        name: str = entity["name"]
        if kind == "interface":
            return "I" + name[1:]
        if kind == "delegate" and entity["owner"]:
            return f"{entity['owner']}::{name}"
        return name

    def page_named(self, name: str) -> Page | None:
        """The page of a class, interface (``UFoo`` or ``IFoo``), struct or enum."""
        return self._by_name.get(name)

    def delegate_page(self, owner: str, name: str) -> Page | None:
        """The page of a delegate; ``owner`` is "" for one that is declared outside of classes."""
        return self._delegates.get((owner, name))

    def counts(self, module: str | None = None) -> dict[str, int]:
        """How many there are of each kind, in one module or in all."""
        result = dict.fromkeys((*KIND_LETTERS, "function", "property", "value"), 0)
        for name, pages in self.pages.items():
            if module in (None, name):
                for page in pages:
                    result[page.kind] += 1
                    result["function"] += len(page.functions)
                    result["property"] += len(page.properties)
                    result["value"] += len(page.entries)
        return result

    @cached_property
    def delegate_variables(self) -> Mapping[tuple[str, str], list[tuple[str, str, Page, str]]]:
        """Delegate (owner or "", name) -> the variables of that type: class or struct, variable, page, anchor."""
        found: dict[tuple[str, str], list[tuple[str, str, Page, str]]] = {}
        for pages in self.pages.values():
            for page in pages:
                for variable, anchor in zip(page.entity.get("properties", ()), page.properties):
                    node = variable["type"]
                    if node["kind"].endswith("delegate"):
                        found.setdefault((node.get("owner") or "", node["name"]), []).append((page.title, variable["name"], page, anchor))
        return found

    # Links ---------------------------------------------------------------------------------------------------------------

    def url(self, page: Page, directory: str) -> str:
        """The page as seen from a folder of the site ("" is its top)."""
        if directory == page.directory:
            return page.file + ".html"
        return f"{'../' if directory else ''}{page.path}"

    def link(self, name: str, directory: str) -> str:
        """A type's name as HTML, with a link if it has a page."""
        key = (name, directory)
        found = self._links.get(key)
        if found is None:
            page = self._by_name.get(name)
            if page:
                found = f'<a href="{self.url(page, directory)}">{escape(name)}</a>'
            else:
                hint = ' title="provided by Unreal\'s run time"' if name in INTRINSIC_CLASSES else ""
                found = f"<span{hint}>{escape(name)}</span>" if hint else escape(name)
            self._links[key] = found
        return found

    def type_html(self, node: Entity, directory: str) -> str:
        """A type node in Unreal's spelling, with links."""
        key = (node["cpp"], str(node.get("owner") or ""), directory)
        found = self._types.get(key)
        if found is None:
            found = self._types[key] = self._type(node, directory)
        return found

    def _type(self, node: Entity, directory: str) -> str:
        kind, cpp = node["kind"], node["cpp"]
        if kind in ("array", "set", "optional"):
            return f"{cpp.partition('<')[0]}&lt;{self.type_html(node['inner'], directory)}&gt;"
        if kind == "map":
            return f"TMap&lt;{self.type_html(node['key'], directory)}, {self.type_html(node['value'], directory)}&gt;"
        if kind.endswith("delegate"):
            page = self.delegate_page(node.get("owner") or "", node["name"])
            return f'<a href="{self.url(page, directory)}">{escape(cpp)}</a>' if page else escape(cpp)
        name = node.get("name")
        if not name or kind == "field_path":
            return escape(cpp)
        before, middle, after = cpp.partition(name)
        return f"{escape(before)}{self.link(name, directory)}{escape(after)}" if middle else self.link(name, directory)

    # Comments ------------------------------------------------------------------------------------------------------------

    def inline(self, text: str, directory: str) -> str:
        """Plain text as HTML, names of types made links."""
        if not text:
            return ""
        return self._with_links(html_text(text), directory)

    def _with_links(self, html: str, directory: str) -> str:
        by_name = self._by_name

        def replace(match: re.Match[str]) -> str:
            word = match[0]
            return self.link(word, directory) if word in by_name else word

        return _LINK_OR_WORD.sub(replace, html)

    def comment(self, documented: Documentation, directory: str, *, whole: bool = True) -> str:
        """A doc comment as HTML: its blocks, then (``whole``) notes. Parameters and result stand in the table of parameters."""
        parts = []
        for block in documented.blocks:
            if block.kind == "code":
                parts.append(f"<pre>{escape(block.text)}</pre>")
            elif block.kind == "list":
                parts.append("<ul>" + "".join(f"<li>{self.inline(line, directory)}" for line in block.lines) + "</ul>")
            else:
                parts.append(f"<p>{self.inline(block.text, directory)}</p>")
        if whole:
            for label, text in documented.notes:
                parts.append(f'<p class="note {label.lower()}"><b>{escape(label)}</b> {self.inline(text, directory)}</p>')
        return "".join(parts)
