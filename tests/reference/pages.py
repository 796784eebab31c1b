# SPDX-License-Identifier: MIT
"""Reads the pages of a site and checks what must hold for every one."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

#: Elements that have no end tag, and those whose end tag HTML lets one leave out.
_VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "path", "circle", "source", "wbr"}
_OPTIONAL = {"p", "li", "dt", "dd", "tr", "td", "th", "thead", "tbody"}


@dataclass
class PageFacts:
    """What a page holds."""

    path: Path
    ids: list[str] = field(default_factory=list)
    links: list[str] = field(default_factory=list)
    #: what it loads: scripts, style sheets, pictures
    loads: list[str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    title: str = ""
    text: str = ""


class _Reader(HTMLParser):
    def __init__(self, facts: PageFacts) -> None:
        super().__init__(convert_charrefs=True)
        self.facts = facts
        self.open: list[str] = []
        self.pieces: list[str] = []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        given = dict(attributes)
        if given.get("id"):
            self.facts.ids.append(given["id"] or "")
        if tag == "a" and given.get("href"):
            self.facts.links.append(given["href"] or "")
        for name in ("src", "href"):
            if tag in ("script", "link", "img", "iframe", "source") and given.get(name):
                self.facts.loads.append(given[name] or "")
        if tag not in _VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag in _VOID:
            return
        while self.open and self.open[-1] != tag and self.open[-1] in _OPTIONAL:
            self.open.pop()
        if not self.open or self.open[-1] != tag:
            self.facts.errors.append(f"</{tag}> at line {self.getpos()[0]} closes {self.open[-3:]}")
        else:
            self.open.pop()

    def handle_data(self, data: str) -> None:
        if self.open and self.open[-1] == "title":
            self.facts.title += data
        elif "script" not in self.open and "style" not in self.open:
            self.pieces.append(data)


def read_page(path: Path) -> PageFacts:
    """Parses a page."""
    facts = PageFacts(path)
    reader = _Reader(facts)
    reader.feed(path.read_text(encoding="utf-8"))
    reader.close()
    facts.text = " ".join(" ".join(reader.pieces).split())
    left = [tag for tag in reader.open if tag not in _OPTIONAL]
    if left:
        facts.errors.append(f"never closed: {left}")
    return facts


def read_site(folder: Path) -> dict[Path, PageFacts]:
    """All pages of a site."""
    return {path.resolve(): read_page(path) for path in sorted(folder.rglob("*.html"))}


def broken_links(site: dict[Path, PageFacts]) -> list[str]:
    """Links within the site that lead nowhere: to a file that is not there, or an anchor that is not in it."""
    ids = {path: set(facts.ids) for path, facts in site.items()}
    broken = []
    for path, facts in site.items():
        for link in [*facts.links, *facts.loads]:
            parts = urlsplit(link)
            if parts.scheme in ("http", "https", "data"):
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                broken.append(f"{path.name}: {link} (no such file)")
            elif parts.fragment and unquote(parts.fragment) not in ids.get(target, set()):
                broken.append(f"{path.name}: {link} (no such anchor)")
    return broken


@dataclass
class IndexEntry:
    """An entry of the search index."""

    kind: str
    name: str
    owner: str
    #: file and anchor
    target: str
    summary: str


def read_index(folder: Path) -> list[IndexEntry]:
    """The search index, read as search.js reads it."""

    def arguments(file: Path) -> list[object]:
        text = file.read_text(encoding="utf-8")
        match = re.search(r"spearSearch\.\w+\((.*)\);\s*$", text, re.DOTALL)
        assert match, f"{file} does not call spearSearch"
        found = json.loads(f"[{match[1]}]")
        assert isinstance(found, list)
        return found

    lines, info = arguments(folder / "assets" / "search-names.js")
    assert isinstance(lines, str) and isinstance(info, dict)
    summaries: list[str] = []
    for number, name in enumerate(info["summaries"]):
        found = arguments(folder / "assets" / name)
        assert found[0] == number and isinstance(found[1], str)
        summaries += found[1].split("\n")
    entries: list[IndexEntry] = []
    directory = owner = file = ""
    for line in lines.split("\n"):
        head, *rest = line.split("\t")
        if head == "M":
            directory, owner = rest[0], rest[1]
            entries.append(IndexEntry("m", owner, "", f"{directory}/index.html", ""))
        elif head == "T":
            kind, name, owner, _ = rest
            file = f"{directory}/{name}.html"
            entries.append(IndexEntry(kind, owner, directory, file, ""))
        elif head == "P":
            file, owner = rest
            entries.append(IndexEntry("m", owner, "", file, ""))
        else:
            entries.append(IndexEntry(head[0], head[1:], owner, f"{file}#{rest[0] if rest else head[1:]}", ""))
    assert len(entries) == len(summaries), "every name has a summary, if an empty one"
    for entry, summary in zip(entries, summaries):
        entry.summary = summary
    return entries
