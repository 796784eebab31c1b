# SPDX-License-Identifier: MIT
"""What the page of one type shows, ready for its template: everything here is text or HTML that is safe already."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from html import escape
from typing import Any

from markupsafe import Markup

from .documentation import Documentation, documentation, range_of, units_of
from .names import short_entry_name
from .reference_site import Entity, Page, Site
from .reference_spelling import Spelling, Speller
from .schema import header_of, line_of
from .signatures import Parameter, Signature, deprecated_text, meta_of, signature

#: Kind of badge ("", "strong", "warn"), text, what it means.
Badge = tuple[str, str, str]

#: How many names a list of children shows before the rest is folded.
_SHOWN_NAMES = 24

_FUNCTION_BADGES = {
    "Static": ("strong", "static", "called on the class"),
    "BlueprintPure": ("", "pure", "changes nothing; no execution pin in Blueprints"),
    "Const": ("", "const", "does not change the object"),
    "BlueprintEvent": ("", "event", "may be implemented in Blueprints"),
    "Exec": ("", "exec", "may be called from the console"),
    "NetServer": ("", "runs on server", "a remote call, from the owning client to the server"),
    "NetClient": ("", "runs on client", "a remote call, from the server to the owning client"),
    "NetMulticast": ("", "multicast", "a remote call, from the server to everybody"),
    "NetReliable": ("", "reliable", "the remote call arrives for certain"),
    "BlueprintAuthorityOnly": ("", "authority only", "does nothing where the game has no authority"),
    "BlueprintCosmetic": ("", "cosmetic", "does nothing on dedicated servers"),
    "EditorOnly": ("warn", "editor only", "not there in packaged builds"),
    "Protected": ("", "protected", "protected in C++; callable through reflection"),
    "Private": ("", "private", "private in C++; callable through reflection"),
}

_PROPERTY_BADGES = {
    "Transient": ("", "transient", "neither saved nor loaded"),
    "Config": ("", "config", "read from configuration files"),
    "SaveGame": ("", "save game", "part of saved games"),
    "Net": ("", "replicated", "sent from server to clients"),
    "Interp": ("", "animated", "may be driven by a timeline"),
    "BlueprintAssignable": ("", "assignable", "Blueprints may bind to it"),
    "ExposeOnSpawn": ("", "on spawn", "may be given where an object is made"),
    "InstancedReference": ("", "instanced", "each owner has an object of its own"),
    "EditorOnly": ("warn", "editor only", "not there in packaged builds"),
    "Deprecated": ("warn", "deprecated", "should not be used any more"),
    "Protected": ("", "protected", "protected in C++; reached through reflection"),
    "NativeAccessSpecifierPrivate": ("", "private", "private in C++; reached through reflection"),
}

_CLASS_BADGES = {
    "Abstract": ("", "abstract", "cannot be made itself"),
    "Deprecated": ("warn", "deprecated", "should not be used any more"),
    "MinimalAPI": ("", "minimal API", "only its type is exported"),
    "Transient": ("", "transient", "never saved"),
    "NotPlaceable": ("", "not placeable", "cannot be placed in a level"),
    "DefaultToInstanced": ("", "instanced", "each owner has an object of its own"),
}


@cache
def _badge_html(badge: Badge) -> str:
    kind, text, hint = badge
    title = f' title="{escape(hint)}"' if hint else ""
    return f'<span class="badge{" " if kind else ""}{kind}"{title}>{escape(text)}</span>'


def _badges_html(badges: list[Badge]) -> Markup:
    return Markup("".join(map(_badge_html, badges)))


@dataclass
class Row:
    """A parameter or result in a table."""

    name: str
    type: Markup
    direction: str
    label: str
    default: str | None
    doc: Markup


@dataclass
class Member:
    """A function or a property."""

    name: str
    anchor: str
    badges: Markup
    source: str
    doc: Markup
    spelling: Spelling
    deprecated: str = ""
    rows: list[Row] = field(default_factory=list)
    remark: str = ""
    type: Markup = Markup()
    facts: list[tuple[str, Markup]] = field(default_factory=list)

    @property
    def has_defaults(self) -> bool:
        """Whether the table of parameters needs a column of defaults."""
        return any(row.default is not None for row in self.rows)


@dataclass
class Entry:
    """An entry of an enum."""

    name: str
    anchor: str
    value: int
    #: (language, spelling) where it is not the name itself
    spelled: list[tuple[str, str]]
    badges: Markup
    doc: Markup


@dataclass
class Inherited:
    """The members that come from one ancestor."""

    title: Markup
    count: int
    groups: list[tuple[str, Markup]]


@dataclass
class Section:
    """A part of the list at the side."""

    id: str
    title: str
    count: int
    links: list[tuple[str, str]]


@dataclass
class Head:
    """What stands above the members."""

    badges: Markup
    doc: Markup
    facts: list[tuple[str, Markup]]
    deprecated: str = ""
    spelling: Spelling | None = None
    rows: list[Row] = field(default_factory=list)


@dataclass
class Content:
    """All of a page, and the summaries of what is on it: its own, then its members' in the order of the page's anchors."""

    values: dict[str, Any]
    summaries: list[str]


class Pages:
    """Makes the contents of pages. One per process: it remembers pieces of HTML that several pages share."""

    def __init__(self, site: Site) -> None:
        self.site = site
        self.schemas = site.schemas
        self.speller = Speller(site)
        self._inherited: dict[tuple[str, str], Inherited | None] = {}

    def content(self, page: Page) -> Content:
        """The page of a type."""
        entity, directory = page.entity, page.directory
        documented = documentation(entity)
        head = Head(_badges_html(self._type_badges(page)), Markup(self.site.comment(documented, directory)), self._type_facts(page),
                    str(entity.get("source", {}).get("deprecated") or deprecated_text(entity)))
        summaries = [documented.summary]
        values: dict[str, Any] = {"kind": page.kind, "type": head, "heading": page.title, "description": documented.summary, "functions": [], "properties": [],
                                  "entries": [], "inherited": [], "property_title": "Fields" if page.kind == "struct" else "Properties"}
        if page.kind == "delegate":
            call = signature(entity, self.schemas)
            head.spelling = self.speller.delegate(page, call)
            head.rows = self._rows(call, documented, directory)
        else:
            head.spelling = self.speller.type(page)
        functions = [self._function(f, a, page, summaries) for f, a in zip(entity.get("functions", ()), page.functions)]
        properties = [self._property(p, a, page, summaries) for p, a in zip(entity.get("properties", ()), page.properties)]
        values["entries"] = [self._entry(e, a, page, summaries) for e, a in zip(entity.get("entries", ()), page.entries)]
        values["functions"], values["properties"] = functions, properties
        values["inherited"] = self._all_inherited(page)
        values["sections"] = self._sections(values)
        return Content(values, summaries)

    @staticmethod
    def _sections(values: dict[str, Any]) -> list[Section]:
        sections = []
        for key, title in (("entries", "Values"), ("functions", "Functions"), ("properties", values["property_title"])):
            if values[key]:
                links = [(member.anchor, member.name) for member in values[key]]
                sections.append(Section("section-" + ("values" if key == "entries" else key), title, len(links), links))
        if values["inherited"]:
            sections.append(Section("section-inherited", "Inherited members", sum(i.count for i in values["inherited"]), []))
        return sections

    # Heads of types --------------------------------------------------------------------------------------------------------

    def _type_badges(self, page: Page) -> list[Badge]:
        entity = page.entity
        flags = set(entity.get("flags", ()))
        badges: list[Badge] = []
        if page.kind == "class":
            badges = [badge for flag, badge in _CLASS_BADGES.items() if flag in flags]
            if meta_of(entity).get("BlueprintType") == "true":
                badges.append(("", "Blueprint type", "variables of Blueprints may have this type"))
            if meta_of(entity).get("IsBlueprintBase") == "true":
                badges.append(("", "Blueprintable", "Blueprints may derive from it"))
        elif page.kind == "enum":
            if "Flags" in flags:
                badges.append(("strong", "flags", "values may be combined"))
            badges.append(("", {"class": "enum class", "namespaced": "in a namespace", "regular": "plain enum"}[entity["form"]], ""))
        elif page.kind == "delegate":
            meaning = {"single": "one listener", "multicast": "any number of listeners", "sparse": "any number of listeners; empty costs nothing"}
            badges.append(("strong", entity["kind"], meaning[entity["kind"]]))
        if entity.get("source", {}).get("editor_only"):
            badges.append(("warn", "editor only", "not there in packaged builds"))
        return badges

    def _type_facts(self, page: Page) -> list[tuple[str, Markup]]:
        entity, directory, site = page.entity, page.directory, self.site
        facts: list[tuple[str, Markup]] = []
        name = entity["name"]
        chain = [] if page.kind in ("enum", "delegate") else self.schemas.ancestors(name)
        if chain:
            links = "".join(f"<span>{site.link(n, directory)}</span>" for n in reversed(chain))
            facts.append(("Inherits", Markup(f'<span class="chain">{links}<span><b>{escape(page.title)}</b></span></span>')))
        facts += self._names("Implements", entity.get("interfaces", ()), directory)
        children = self.schemas.subclasses if page.kind in ("class", "interface") else self.schemas.derived_structs if page.kind == "struct" else {}
        facts += self._names("Known children", children.get(name, ()), directory)
        if page.kind == "interface":
            facts += self._names("Implemented by", self.schemas.implementers.get(page.title, ()), directory)
        if page.kind == "delegate" and entity["owner"]:
            facts.append(("Declared in", Markup(site.link(entity["owner"], directory))))
        if page.kind == "delegate":
            variables = [f'{site.link(owner, directory)}.<a href="{site.url(where, directory)}#{anchor}">{escape(variable)}</a>'
                         for owner, variable, where, anchor in site.delegate_variables.get((entity["owner"] or "", name), ())]
            if variables:
                facts.append(("Variables", Markup(", ".join(variables))))
        if page.kind == "enum" and entity.get("source", {}).get("underlying"):
            facts.append(("Underlying type", Markup(f"<code>{escape(entity['source']['underlying'])}</code>")))
        if entity.get("within", "UObject") != "UObject":
            facts.append(("Within", Markup(site.link(entity["within"], directory))))
        if entity.get("config"):
            facts.append(("Configuration", Markup(escape(entity["config"]))))
        facts.append(("Module", Markup(f'<a href="index.html">{escape(page.module)}</a>')))
        header = header_of(entity)
        if header:
            line = line_of(entity)
            facts.append(("Header", Markup(f"<code>{escape(header)}{f':{line}' if line else ''}</code>")))
            include = self.schemas.includes.get(name) or meta_of(entity).get("IncludePath")
            if include:
                facts.append(("Include in Unreal", Markup(f"<code>#include &quot;{escape(include)}&quot;</code>")))
        facts.append(("Object path", Markup(f"<code>{escape(entity['path'])}</code>")))
        return facts

    def _names(self, label: str, names: Any, directory: str) -> list[tuple[str, Markup]]:
        """A list of types; the rest of a long one is folded."""
        if not names:
            return []
        links = [self.site.link(name, directory) for name in names]
        html = ", ".join(links[:_SHOWN_NAMES])
        if len(links) > _SHOWN_NAMES:
            html += f"<details><summary>{len(links) - _SHOWN_NAMES} more</summary>{', '.join(links[_SHOWN_NAMES:])}</details>"
        return [(label, Markup(html))]

    # Members ---------------------------------------------------------------------------------------------------------------

    def _source(self, entity: Entity, page: Page) -> str:
        """The category, and where in the header it is."""
        line = line_of(entity)
        header = header_of(page.entity)
        place = f"{header.rpartition('/')[2]}:{line}" if line and header else ""
        return " · ".join(text for text in (meta_of(entity).get("Category", "").replace("|", " › "), place) if text)

    def _function(self, function: Entity, anchor: str, page: Page, summaries: list[str]) -> Member:
        documented = documentation(function)
        summaries.append(documented.summary)
        call = signature(function, self.schemas)
        flags = set(function["flags"])
        if function.get("source", {}).get("editor_only"):
            flags.add("EditorOnly")
        badges = [badge for flag, badge in _FUNCTION_BADGES.items() if flag in flags]
        remarks = []
        if call.latent:
            badges.insert(0, ("strong", "latent", "completes in a later frame"))
            remarks.append("Latent: its future completes in a later frame, when the action is done.")
        if call.deprecated:
            badges.append(("warn", "deprecated", "should not be used any more"))
        if call.world_context:
            remarks.append(f"{call.world_context.name} is filled in with the world of the game unless it is given.")
        if not call.callable:
            badges.append(("warn", "not callable", "has a custom thunk"))
            remarks.append("Works only in compiled Blueprints (custom thunk): calling it from outside is an error.")
        return Member(function["name"], anchor, _badges_html(badges), self._source(function, page), Markup(self.site.comment(documented, page.directory)),
                      self.speller.function(page, function, call), call.deprecated, self._rows(call, documented, page.directory), " ".join(remarks))

    def _rows(self, call: Signature, documented: Documentation, directory: str) -> list[Row]:
        rows = [self._input_row(parameter, documented, directory) for parameter in call.inputs]
        given = {parameter.name for parameter in call.inputs}
        for output in call.outputs:
            if output.name in given:
                continue
            text = documented.returns if output.is_return else documented.parameter(output.name)
            kind = self.site.type_html(output.type, directory) + (f"[{output.array_dim}]" if output.array_dim > 1 else "")
            rows.append(Row("Result" if output.is_return else output.name, Markup(kind), "out", "returned" if output.is_return else "out", None,
                            self._described(text, output.entity, directory, output.nullable and output.is_return and output.type["kind"] == "object")))
        return rows

    def _input_row(self, parameter: Parameter, documented: Documentation, directory: str) -> Row:
        kind = self.site.type_html(parameter.type, directory) + (f"[{parameter.array_dim}]" if parameter.array_dim > 1 else "")
        default: str | None = None
        if parameter.keyword_only:
            default = "the world"
        elif parameter.optional:
            default = parameter.default_source or parameter.default_text or parameter.type["cpp"].partition("<")[0] + "()"
        direction, label = ("inout", "in and out") if parameter.is_reference else ("in", "in")
        return Row(parameter.name, Markup(kind), direction, label, default, self._described(documented.parameter(parameter.name), parameter.entity, directory, False))

    def _described(self, text: str, entity: Entity, directory: str, may_be_null: bool) -> Markup:
        parts = [self.site.inline(text, directory)] if text else []
        parts += [f'<span class="badge">{escape(t)}</span>' for t in (units_of(entity), range_of(entity)) if t]
        if may_be_null and not text:
            parts.append("May be null.")
        return Markup(" ".join(parts))

    def _property(self, entity: Entity, anchor: str, page: Page, summaries: list[str]) -> Member:
        documented = documentation(entity)
        summaries.append(documented.summary)
        flags, source = set(entity["flags"]), entity.get("source", {})
        kind = self.site.type_html(entity["type"], page.directory)
        if source.get("bits"):
            kind += f" : {source['bits']}"
        elif entity["type"].get("bitfield"):
            kind += " : 1"
        if entity["array_dim"] > 1:
            text = source.get("array_text", "")
            kind += f"[{entity['array_dim']}]" if not text or text == str(entity["array_dim"]) else f"[{escape(text)} = {entity['array_dim']}]"
        facts: list[tuple[str, Markup]] = []
        shown = meta_of(entity).get("DisplayName")
        if shown:
            facts.append(("Shown as", Markup(escape(shown))))
        for label, value in (("Default", source.get("default")), ("Set by", source.get("setter") if entity.get("native_setter") else None),
                             ("Read by", source.get("getter") if entity.get("native_getter") else None), ("When replicated", entity.get("rep_notify"))):
            if value:
                facts.append((label, Markup(f"<code>{escape(str(value))}</code>")))
        for label, value in (("Units", units_of(entity)), ("Range", range_of(entity))):
            if value:
                facts.append((label, Markup(escape(str(value)))))
        return Member(entity["name"], anchor, _badges_html(self._property_badges(flags, bool(source.get("editor_only")))), self._source(entity, page),
                      Markup(self.site.comment(documented, page.directory)), self.speller.property(page, entity), deprecated_text(entity), [], "", Markup(kind), facts)

    @staticmethod
    def _property_badges(flags: set[str], editor_only: bool) -> list[Badge]:
        badges: list[Badge] = []
        if "Edit" in flags:
            where = " in instances" if "DisableEditOnTemplate" in flags else " in defaults" if "DisableEditOnInstance" in flags else ""
            badges.append(("", ("visible" if "EditConst" in flags else "editable") + where, "in the editor's details"))
        if "BlueprintVisible" in flags:
            badges.append(("", "Blueprint read only" if "BlueprintReadOnly" in flags else "Blueprint read/write", "in Blueprints"))
        if editor_only:
            flags = flags | {"EditorOnly"}
        return badges + [badge for flag, badge in _PROPERTY_BADGES.items() if flag in flags]

    def _entry(self, entity: Entity, anchor: str, page: Page, summaries: list[str]) -> Entry:
        documented = documentation(entity)
        summaries.append(documented.summary)
        python, cpp = self.speller.entry(page, entity)
        name = short_entry_name(entity["name"])
        meta = meta_of(entity)
        badges: list[Badge] = [("", "hidden", "not offered in editors")] if "Hidden" in meta else []
        other = [(language, text) for language, text, tail in (("Python", python, f".{name}"), ("C++", cpp, f"::{name}")) if not text.endswith(tail)]
        doc = self.site.comment(documented, page.directory) or escape(meta.get("DisplayName", ""))
        return Entry(name, anchor, entity["value"], other, _badges_html(badges), Markup(doc))

    # Inherited members -----------------------------------------------------------------------------------------------------

    def _all_inherited(self, page: Page) -> list[Inherited]:
        if page.kind not in ("class", "interface", "struct"):
            return []
        names: list[str] = []
        chain = self.schemas.ancestors(page.entity["name"])
        for name in (page.entity["name"], *chain):
            if name != page.entity["name"]:
                names.append(name)
            entity = self.schemas.classes.get(name)
            names += [i for i in (entity["interfaces"] if entity else ()) if i not in names]
        found = (self._inherited_from(name, page.directory) for name in names)
        return [inherited for inherited in found if inherited]

    def _inherited_from(self, name: str, directory: str) -> Inherited | None:
        key = (name, directory)
        if key not in self._inherited:
            page = self.site.page_named(name)
            self._inherited[key] = self._members_of(page, directory) if page and (page.functions or page.properties) else None
        return self._inherited[key]

    def _members_of(self, page: Page, directory: str) -> Inherited:
        url = self.site.url(page, directory)
        groups = []
        counts = []
        plural = ("field", "fields") if page.kind == "struct" else ("property", "properties")
        for label, members, anchors, (one, many) in (("Functions", page.entity.get("functions", ()), page.functions, ("function", "functions")),
                                                     (plural[1].capitalize(), page.entity["properties"], page.properties, plural)):
            if members:
                counts.append(f"{len(members)} {one if len(members) == 1 else many}")
                links = " ".join(f'<a href="{url}#{anchor}">{escape(member["name"])}</a>' for member, anchor in zip(members, anchors))
                groups.append((label, Markup(links)))
        title = f"From {escape(page.title)} <span class=\"count\">{', '.join(counts)}</span>"
        return Inherited(Markup(title), len(page.functions) + len(page.properties), groups)
