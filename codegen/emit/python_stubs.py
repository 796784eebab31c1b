# SPDX-License-Identifier: MIT
"""Typed Python stubs: ``spear.unreal.<Module>`` for editors and type checkers, and ``facts.json`` for the run time.

One file per header (``Engine/_Actor.pyi``), small ``__init__.pyi`` files that only re-export, nothing above 500 KB. Classes inherit as Unreal's
do; nothing is flattened and nothing is overloaded by class. A class ``X`` comes as

- ``X``: what functions return and take; ``X_members``: its functions and variables, shared with
- ``X_path``: a variable that refers to an X (``actor.RootComponent``);
- ``X_async``, ``X_async_path``, ``X_send``: the same under ``async_`` and ``send_``;

a struct ``F`` as ``F`` (value), ``F_dict`` (dictionary of its fields), ``F_in`` (all that stands for it as an argument), ``F_path``, ``F_async``; an
enum ``E`` as ``E`` and ``E_in``. Types that no schema has become UObject, ``Any`` or ``int``, and are listed in ``report.json``.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any

from .names import python_name
from .output import Output
from .parallel import for_each
from .python_stub_overrides import Overrides
from .python_stub_pieces import Facts, Piece, PieceWriter, environment, interface_name, own_members
from .schema import INTRINSIC_CLASSES, Entity, Header, SchemaSet

#: No file gets larger than this, in bytes; readers of stubs give up on large ones.
LARGEST_FILE = 400_000

#: Name in a stub -> module that has it, and its name there if that is another.
_HELPERS: Mapping[str, tuple[str, str]] = {
    **{name: ("typing", name) for name in ("Any", "NamedTuple", "NoReturn", "TypeAlias", "TypeVar", "TypedDict", "overload")},
    "Sequence": ("collections.abc", "Sequence"), "Mapping": ("collections.abc", "Mapping"), "AbstractSet": ("collections.abc", "Set"),
    "deprecated": ("typing_extensions", "deprecated"),
    **{name: ("spear.unreal_object", name) for name in ("AsyncBase", "ObjectBase", "SendBase")},
    "Struct": ("spear.structs", "Struct"), "UnrealEnum": ("spear.enums", "UnrealEnum"), "UnrealFlags": ("spear.enums", "UnrealFlags"),
    **{name: ("spear.typing", name) for name in (
        "ArrayPath", "AsyncArrayPath", "AsyncClassPath", "AsyncMapPath", "AsyncObjectPath", "AsyncPath", "AsyncValuePath", "Buffer", "ClassPath",
        "Future", "MapPath", "Numbers", "ObjectPath", "Path", "Property", "SendProperty", "SetPath", "StructPath", "ValuePath",
        *(f"{facet}{plain}Property" for facet in ("", "Async", "Send") for plain in ("Bool", "Int", "Float", "Str")))},
}

#: Helpers that __init__.pyi leaves in their files: nobody names them.
_INNER = re.compile(r"_(?:members|async|async_path|async_members|send|part\d+)$")

_PRAGMAS = [
    "# mypy: disable-error-code=\"override, misc, assignment\"",
    "# pyright: reportIncompatibleMethodOverride=false, reportIncompatibleVariableOverride=false",
]


def emit(schemas: SchemaSet, output_dir: Path, *, progress: bool = False, jobs: int = 0) -> Output:
    """Writes ``__init__.pyi``, ``<Module>/...`` and, if there is something to tell, ``report.json`` below a folder."""
    everything = with_intrinsic_types(schemas)
    files = Files(everything)
    overrides = Overrides(everything)
    tasks = list(_chunks(files, 2 * 24))

    def work(chunk: list[tuple[Header, str]]) -> _Result:
        output = Output(output_dir)
        result = _Result(output)
        templates = environment()
        for header, stem in chunk:
            _HeaderFiles(everything, files, overrides, templates, header, stem).write(output, result)
        return result

    results = for_each(tasks, work, jobs=jobs, progress=progress, title="Python stubs")
    output = Output(output_dir).merge_all(result.output for result in results)
    facts: dict[str, Facts] = {name: Facts() for name in everything.modules}
    exports: dict[str, dict[str, list[str]]] = {name: {} for name in everything.modules}
    unknown: dict[str, list[str]] = {}
    left_out: list[str] = []
    for result in results:
        for module, found in result.facts.items():
            facts[module].update(found)
        for (module, stem), names in result.exports.items():
            exports[module][stem] = names
        for name, users in result.unknown.items():
            unknown.setdefault(name, []).extend(users)
        left_out += result.left_out
    for module in everything.modules:
        _write_module(output, module, exports[module], facts[module])
    _write(output, "__init__.pyi", "package", origin="all modules", imports=[], documentation=(
        "Types of Unreal by their modules: ``from spear.unreal.Engine import AActor``.\n\n"
        f"Modules here: {', '.join(everything.modules)}. ``spear schema stubs`` writes those of your own project.\n"))
    if unknown or left_out:
        examples = {name: sorted(of)[:5] for name, of in sorted(unknown.items())}
        report = {"$comment": "generated, do not edit: what these stubs could not say", "unknown": examples, "left_out": sorted(left_out)}
        output.write("report.json", json.dumps(report, indent=1) + "\n")
        if unknown:
            listed = ", ".join(sorted(unknown)[:8]) + (", ..." if len(unknown) > 8 else "")
            print(f"{len(unknown)} types are in no schema and became UObject, Any or int (report.json lists them): {listed}", file=sys.stderr)
    return output.finish()


@dataclass
class _Result:
    output: Output
    facts: dict[str, Facts] = field(default_factory=dict)
    #: (module, file) -> names that the module re-exports
    exports: dict[tuple[str, str], list[str]] = field(default_factory=dict)
    unknown: dict[str, list[str]] = field(default_factory=dict)
    left_out: list[str] = field(default_factory=list)


# What there is ---------------------------------------------------------------------------------------------------------------


def with_intrinsic_types(schemas: SchemaSet) -> SchemaSet:
    """The schemas with what Unreal's run time adds: UClass and its like, and the value of a delegate."""
    classes = [(name, above) for name, above in INTRINSIC_CLASSES.items() if name not in schemas.classes]
    if "UObject" not in schemas.classes:
        classes.insert(0, ("UObject", ""))
    made: dict[str, list[Entity]] = {"classes": [], "structs": [], "enums": [], "delegates": []}
    for name, above in classes:
        made["classes"].append({
            "name": name, "path": f"/Script/CoreUObject.{name[1:]}", "module": "CoreUObject", "super": above or None, "interfaces": [],
            "functions": [], "properties": [], "flags": [], "editor": {"meta": {"ToolTip": _INTRINSIC_TEXTS.get(name, "")}},
            "source": {"header": "Intrinsic.h", "line": 0},
        })
    if "FScriptDelegate" not in schemas.structs:
        fields = [("Object", {"kind": "object", "name": "UObject", "cpp": "UObject*"}, "The object that is called; None if nothing is bound."),
                  ("FunctionName", {"kind": "name", "cpp": "FName"}, "The function of it.")]
        made["structs"].append({
            "name": "FScriptDelegate", "path": "", "module": "CoreUObject", "super": None, "flags": [],
            "source": {"header": "Intrinsic.h", "line": 0}, "editor": {"meta": {"ToolTip": "What is bound to a delegate."}},
            "properties": [{"name": n, "type": t, "array_dim": 1, "flags": [], "editor": {"meta": {"ToolTip": text}}} for n, t, text in fields],
        })
    core = schemas.modules.get("CoreUObject")
    document: Entity = {"modules": [core.entry if core else {"name": "CoreUObject"}], **made}
    document = {kind: [*document[kind], *(e for e in getattr(core, kind, []))] if kind != "modules" else document[kind] for kind in document}
    result = SchemaSet(schemas.main)
    for module in schemas.modules.values():
        if module.name != "CoreUObject":
            result._index({"modules": [module.entry], **{kind: getattr(module, kind) for kind in made}}, main=True)
    result._index(document, main=True)
    result.modules = dict(sorted(result.modules.items()))
    return result


_INTRINSIC_TEXTS = {
    "UObject": "Base of all objects.", "UClass": "A class of Unreal, an object too.", "UStruct": "Base of classes, structs and functions as objects.",
    "UScriptStruct": "A struct type as an object.", "UFunction": "A function as an object.", "UEnum": "An enum as an object.",
    "UPackage": "What objects are saved in.", "UInterface": "Base of the classes of interfaces.", "UField": "Base of reflected types as objects.",
}


class Files:
    """Which file holds which type."""

    def __init__(self, schemas: SchemaSet) -> None:
        self.schemas = schemas
        #: type (C++ name; interfaces by both names) -> (module, file)
        self.of_type: dict[str, tuple[str, str]] = {}
        #: (owner or "", delegate) -> its Python name: two classes of a module may each declare a delegate of one name
        self.delegates: dict[tuple[str, str], str] = {}
        #: (module, header) -> file
        self.of_header: dict[tuple[str, str], str] = {}
        for module in schemas.modules.values():
            used: set[str] = set()
            names = Counter(entity["name"] for entity in module.entities())
            for delegate in module.delegates:
                name, owner = python_name(delegate["name"], "type"), delegate["owner"] or ""
                self.delegates[owner, delegate["name"]] = f"{owner}_{name}" if owner and names[delegate["name"]] > 1 else name
            for header in module.headers:
                stem = _stem(header.path, used)
                self.of_header[module.name, header.path] = stem
                for entity in header.entities():
                    self.of_type[entity["name"]] = (module.name, stem)
                    if "Interface" in entity.get("flags", ()) and "functions" in entity:
                        self.of_type[interface_name(entity)] = (module.name, stem)


def _stem(path: str, used: set[str]) -> str:
    """``_Actor`` for ``Public/GameFramework/Actor.h``; numbered where two headers of a module have one name (file systems may not tell case)."""
    base = "_" + (re.sub(r"\W", "_", PurePosixPath(path).stem) or "Types")
    stem, number = base, 1
    while stem.lower() in used:
        number += 1
        stem = f"{base}_{number}"
    used.add(stem.lower())
    return stem


def _chunks(files: Files, count: int) -> Iterator[list[tuple[Header, str]]]:
    """All headers in about so many parts of about equal work."""
    headers = [(header, files.of_header[module.name, header.path]) for module in files.schemas.modules.values() for header in module.headers]
    weights = [1 + len(h.structs) * 4 + sum(len(c["functions"]) + len(c["properties"]) for c in h.classes) for h, _ in headers]
    limit = max(1, sum(weights) // count)
    part: list[tuple[Header, str]] = []
    weight = 0
    for header, own in zip(headers, weights):
        part.append(header)
        weight += own
        if weight >= limit:
            yield part
            part, weight = [], 0
    if part:
        yield part


# One header ------------------------------------------------------------------------------------------------------------------


class _HeaderFiles:
    """Writes the types of one header: to one file, or to several that the first one re-exports."""

    def __init__(self, schemas: SchemaSet, files: Files, overrides: Overrides, templates: Any, header: Header, stem: str) -> None:
        self.schemas, self.files, self.overrides, self.templates, self.header, self.stem = schemas, files, overrides, templates, header, stem
        self.module = header.module
        #: local name -> (module to import from, or "" for this header; name there)
        self.needed: dict[str, tuple[str, str]] = {}
        self._local: dict[tuple[str, str], str] = {}
        #: type variable -> its definition
        self.variables: dict[str, str] = {}
        self.members = self._member_names()
        self.defined = {python_name(e["name"], "type") for e in header.entities()} | {files.delegates[d["owner"] or "", d["name"]] for d in header.delegates}

    def _member_names(self) -> set[str]:
        """Every name that some class body here defines: inside it, that name means the member."""
        names: set[str] = set()
        for entity in self.header.classes:
            members = own_members(entity)
            names |= {members[m["name"]] for kind in ("functions", "properties") for m in entity[kind]}
            names |= {python_name(p["name"], "result") for f in entity["functions"] for p in f["parameters"] if "OutParm" in p["flags"]}
        for entity in self.header.structs:
            names |= {python_name(p["name"], "field") for p in entity["properties"]} | {p["name"] for p in entity["properties"]}
        return names

    def use(self, name: str, suffix: str) -> str:
        """The text for a name in this file; it will be imported, under another name where members or types here have that one.

        ``TypeVar:UFoo`` is a type variable for UFoo and the classes derived from it.
        """
        if name.startswith("TypeVar:"):
            bound = self.use(name[8:], "")
            variable = "_T_" + bound
            self.variables[variable] = f'{variable} = {self.use("TypeVar", "")}("{variable}", bound={bound})'
            return variable
        if name in _HELPERS and not suffix and (name not in self.files.of_type):
            source, original = _HELPERS[name]
            local = name
        else:
            module, stem = self.files.of_type[name]
            local = original = python_name(name, "type") + suffix
            here = (module, stem) == (self.module, self.stem)
            source = "" if here else f".{stem}" if module == self.module else f"..{module}.{stem}"
        key = (source, original)
        known = self._local.get(key)
        if known is None:
            while local in self.members or (source and local in self.defined) or self.needed.get(local, key) != key:
                local = "_" + local
            known = self._local[key] = local
            self.needed[local] = key
        return known

    def write(self, output: Output, result: _Result) -> None:
        """Writes the files and adds to the result."""
        header = self.header
        writer = PieceWriter(self.schemas, self.templates, self.use, self.files.delegates)
        pieces: list[Piece] = []
        for kind, render in (("enums", writer.enum), ("structs", writer.struct), ("delegates", writer.delegate), ("classes", writer.reflected_class)):
            for entity in getattr(header, kind):
                before = set(writer.types.unknown)
                pieces += render(entity)
                for name in writer.types.unknown - before:
                    result.unknown.setdefault(name, []).append(entity["name"])
        conflicts = any(self.overrides.conflict(entity) for entity in header.classes)
        parts = _parts(pieces)
        owner = {name: number for number, part in enumerate(parts) for piece in part for name in piece.defines}
        origin = f"{self.module}: {header.path or 'types whose header is not known'}"
        for number, part in enumerate(parts):
            own = self.stem if len(parts) == 1 else f"{self.stem}_{number + 1}_of_{len(parts)}"
            text = "\n".join(piece.text for piece in part)
            output.write(f"{self.module}/{own}.pyi", self._file(part, text, origin, number, len(parts), owner, conflicts))
        if len(parts) > 1:
            imports = []
            for number, part in enumerate(parts):
                names = [name for piece in part for name in piece.defines]
                imports += _import_lines(f".{self.stem}_{number + 1}_of_{len(parts)}", [(n, n) for n in names], export=True)
            text = self.templates.get_template("file.pyi.j2").render(origin=origin, pragmas=[], imports=imports, aliases=[], pieces=[])
            output.write(f"{self.module}/{self.stem}.pyi", text)
        result.exports[self.module, self.stem] = [name for piece in pieces for name in piece.defines if not _INNER.search(name)]
        result.facts.setdefault(self.module, Facts()).update(writer.facts)
        result.left_out += writer.left_out

    def _file(self, part: list[Piece], text: str, origin: str, number: int, parts: int, owner: Mapping[str, int], conflicts: bool) -> str:
        # Names before a colon and a blank are those of parameters and variables.
        words = set(re.findall(r"\b\w+\b(?!: (?!\.\.\.))", re.sub(r'""".*?"""', "", text, flags=re.DOTALL)))
        variables = [line for name, line in sorted(self.variables.items()) if name in words]
        words.update(word for line in variables for word in re.findall(r"\w+", line))
        by_source: dict[str, list[tuple[str, str]]] = {}
        aliases: list[str] = []
        for local, (source, original) in self.needed.items():
            if local not in words:
                continue
            if not source and owner.get(original, number) != number:
                source = f".{self.stem}_{owner[original] + 1}_of_{parts}"
            if source:
                by_source.setdefault(source, []).append((original, local))
            elif local != original:
                aliases.append(local + " = " + original)
        for name in words & owner.keys() if parts > 1 else ():
            # What the types of one header name among themselves.
            source = f".{self.stem}_{owner[name] + 1}_of_{parts}"
            if owner[name] != number and name not in self.members and (name, name) not in by_source.get(source, ()):
                by_source.setdefault(source, []).append((name, name))
        imports = [line for source in sorted(by_source, key=_import_order) for line in _import_lines(source, sorted(by_source[source]))]
        rendered: str = self.templates.get_template("file.pyi.j2").render(
            origin=origin, pragmas=_PRAGMAS if conflicts else [], imports=imports, aliases=sorted(aliases) + variables,
            pieces=[piece.text for piece in part])
        return rendered


def _parts(pieces: list[Piece]) -> list[list[Piece]]:
    """The pieces in files none of which is too large."""
    parts: list[list[Piece]] = [[]]
    size = 0
    for piece in pieces:
        length = len(piece.text.encode("utf-8"))
        if size + length > LARGEST_FILE and parts[-1]:
            parts.append([])
            size = 0
        parts[-1].append(piece)
        size += length + 2
    return parts


def _import_order(source: str) -> tuple[int, str]:
    """The standard library, then spear, then relative ones."""
    return (2 if source.startswith(".") else 1 if source.startswith("spear") else 0, source)


def _import_lines(source: str, names: Iterable[tuple[str, str]], export: bool = False) -> list[str]:
    """``from source import a, b as _b``, broken where it gets long; ``export``: by ``a as a``."""
    texts = [f"{original} as {local}" if export or original != local else original for original, local in names]
    line = f"from {source} import {', '.join(texts)}"
    if len(line) <= 150:
        return [line]
    lines = [f"from {source} import ("]
    for text in texts:
        if len(lines) > 1 and len(lines[-1]) + len(text) + 2 <= 150:
            lines[-1] += f" {text},"
        else:
            lines.append(f"    {text},")
    return [*lines, ")"]


# One module ------------------------------------------------------------------------------------------------------------------


def _write(output: Output, path: str, template: str, **values: Any) -> None:
    output.write(path, environment().get_template(template + ".pyi.j2").render(values))


def _write_module(output: Output, module: str, exports: Mapping[str, list[str]], facts: Facts) -> None:
    lines: list[str] = []
    for stem in sorted(exports):
        if exports[stem]:
            lines += _import_lines(f".{stem}", [(name, name) for name in sorted(exports[stem])], export=True)
    parts: list[list[str]] = [[]]
    size = 0
    for line in lines:
        # A statement is not broken by the end of a file.
        if size > LARGEST_FILE and line.startswith("from "):
            parts.append([])
            size = 0
        parts[-1].append(line)
        size += len(line) + 1
    imports = parts[0]
    if len(parts) > 1:
        imports = []
        for number, part in enumerate(parts, 1):
            said = f"Names of {module}, part {number}."
            _write(output, f"{module}/_exports_{number}.pyi", "package", origin=module, documentation=said, imports=part)
            imports.append(f"from ._exports_{number} import *")
    _write(output, f"{module}/__init__.pyi", "package", origin=module, documentation=f"Types of Unreal's module {module}.", imports=imports)
    document = {
        "$comment": "generated, do not edit: what spear.unreal knows of these types without an engine",
        "classes": facts.classes, "structs": facts.structs, "enums": facts.enums, "delegates": facts.delegates,
    }
    output.write(f"{module}/facts.json", _facts_text(document))


def _facts_text(document: Mapping[str, Any]) -> str:
    """One line per type, sorted."""
    lines = [f'"$comment": {json.dumps(document["$comment"])}']
    for kind in ("classes", "structs", "enums", "delegates"):
        rows = ",\n".join(f"{json.dumps(name)}: {json.dumps(document[kind][name], ensure_ascii=False)}" for name in sorted(document[kind]))
        lines.append(f'"{kind}": {{\n{rows}\n}}' if rows else f'"{kind}": {{}}')
    return "{\n" + ",\n".join(lines) + "\n}\n"
