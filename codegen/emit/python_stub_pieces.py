# SPDX-License-Identifier: MIT
"""The text of each type in the stubs: classes with their paths and twins, structs, enums, delegates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import jinja2

from .documentation import body_lines, docstring, documentation, range_of, units_of
from .names import ScopeNames, python_name, short_entry_name
from .python_types import PythonTypes, result_name
from .schema import SchemaSet
from .signatures import NUMBER_KINDS, Signature, deprecated_text, meta_value, signature

Entity = Mapping[str, Any]

#: Structs that spear.structs has itself, with what NumPy and arithmetic want; a test compares.
HAND_WRITTEN_STRUCTS = frozenset({"FColor", "FLinearColor", "FQuat", "FRotator", "FTransform", "FVector", "FVector2D", "FVector4"})

#: A class with more text than this is given its members by several classes, in several files.
LARGEST_BODY = 300_000


@dataclass
class Piece:
    """Some text of a file, and the names that it defines."""

    text: str
    defines: list[str]


@dataclass
class Facts:
    """What the run time wants to know of the types of a file (``facts.json``)."""

    classes: dict[str, Any] = field(default_factory=dict)
    structs: dict[str, Any] = field(default_factory=dict)
    enums: dict[str, Any] = field(default_factory=dict)
    delegates: dict[str, str] = field(default_factory=dict)

    def update(self, other: Facts) -> None:
        """Adds what another one knows."""
        for name in ("classes", "structs", "enums", "delegates"):
            getattr(self, name).update(getattr(other, name))


def environment() -> jinja2.Environment:
    """The templates of the stubs."""
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).resolve().parent / "templates" / "python_stubs"),
        undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True, autoescape=False,
    )


def own_members(entity: Entity) -> ScopeNames:
    """The Python names of the functions and variables that a class declares itself."""
    return ScopeNames([f["name"] for f in entity["functions"]] + [p["name"] for p in entity["properties"]], "member")


def interface_name(entity: Entity) -> str:
    """``IFoo`` of the class ``UFoo`` of an interface."""
    return "I" + str(entity["name"])[1:]


class PieceWriter:
    """Writes the types of one header. ``use`` gives the text for a name of another type or helper, and remembers that it is needed."""

    def __init__(
        self, schemas: SchemaSet, templates: jinja2.Environment, use: Callable[[str, str], str], delegates: Mapping[tuple[str, str], str] | None = None,
    ) -> None:
        self.schemas = schemas
        self.delegates = delegates or {}
        self.templates = templates
        self.types = PythonTypes(schemas, use)
        self.use = use
        self.facts = Facts()
        #: members left out: "AActor.Foo: why"
        self.left_out: list[str] = []

    def _render(self, template: str, **values: Any) -> str:
        for helper in ("AsyncObjectPath", "AsyncValuePath", "Future", "ObjectPath", "StructPath", "TypeAlias", "TypedDict"):
            if helper in _USES[template]:
                values[helper] = self.use(helper, "")
        return self.templates.get_template(template + ".pyi.j2").render(values).rstrip("\n")

    # Classes ------------------------------------------------------------------------------------------------------------

    def reflected_class(self, entity: Entity) -> list[Piece]:
        """A class: what it has, itself, the path of variables that refer to it, its twins."""
        is_interface = "Interface" in entity["flags"]
        unreal = entity["name"]
        name = python_name(interface_name(entity) if is_interface else unreal, "type")
        supers = self._bases(entity, is_interface)
        names = own_members(entity)
        body = {"members": [], "async": [], "send": []}  # type: dict[str, list[str]]
        results: list[str] = []
        never_null: list[str] = []
        seen: set[str] = set()
        for function in entity["functions"]:
            if function["name"] in seen:
                self.left_out.append(f"{unreal}.{function['name']}: a second function of that name")
                continue
            seen.add(function["name"])
            described = signature(function, self.schemas)
            never_null += described.never_null
            if described.returns == "tuple" and described.callable:
                results.append(self._result(described, unreal, function))
            self._function(function, described, unreal, names[function["name"]], body)
        for variable in entity["properties"]:
            if variable["name"] in seen:
                self.left_out.append(f"{unreal}.{variable['name']}: a second member of that name")
                continue
            seen.add(variable["name"])
            self._variable(variable, unreal, names[variable["name"]], body)

        pieces: list[Piece] = [Piece(text, [text.partition("(")[0].removeprefix("class ")]) for text in results]
        for facet, root, said in _FACETS:
            bases = [self.use(base, "_" + facet) for base in supers if base != "ObjectBase"] or ([self.use(root, "")] if root else [])
            pieces += self._chained(f"{name}_{facet}", bases, f'    """{said.format(name)}"""', body[facet])
        fact: dict[str, Any] = {"super": entity["super"], "interfaces": list(entity["interfaces"]), "never_null": never_null, "names": names.table()}
        if is_interface:
            super_class = self.use(entity["super"] or "UInterface", "") if entity["super"] != "UObject" else self.use("UInterface", "")
            class_name = python_name(unreal, "type")
            pieces.append(Piece(self._render("interface_class", name=class_name, base=super_class, interface=name), [class_name]))
            self.facts.classes[interface_name(entity)] = {**fact, "super": "UObject" if supers[0] in ("UObject", "ObjectBase") else supers[0]}
            self.facts.classes[unreal] = {"super": entity["super"], "interfaces": [], "never_null": [], "names": {}}
        else:
            self.facts.classes[unreal] = fact
        text = self._render("class", name=name, bases=", ".join(self.use(base, "") for base in supers),
                            documentation=docstring([*body_lines(documentation(entity)), "", f"Unreal: {entity['path'] or unreal}"], "    "))
        pieces.append(Piece(text, [name, name + "_path", name + "_async_path"]))
        return pieces

    def _bases(self, entity: Entity, is_interface: bool) -> list[str]:
        """The super class and the interfaces that no super class has yet; "ObjectBase" for UObject."""
        above = entity["super"]
        if above is None:
            return ["ObjectBase"]
        if is_interface:
            parent = self.schemas.classes.get(above)
            return [interface_name(parent)] if parent and "Interface" in parent["flags"] else ["UObject"]
        interfaces = new_interfaces(entity, self.schemas)
        base = self.types.class_name(above)
        return interfaces if interfaces and base == "UObject" else [base, *interfaces]  # an interface is a UObject already

    def _chained(self, name: str, bases: list[str], said: str, blocks: list[str]) -> list[Piece]:
        """A class of the blocks; of too many, a chain of classes."""
        parts: list[list[str]] = [[]]
        size = 0
        for block in blocks:
            if size + len(block) > LARGEST_BODY and parts[-1]:
                parts.append([])
                size = 0
            parts[-1].append(block)
            size += len(block) + 1
        pieces = []
        for number, part in enumerate(parts, 1):
            own = name if number == len(parts) else f"{name}_part{number}"
            inherits = f"({', '.join(bases)})" if bases else ""
            pieces.append(Piece("\n".join([f"class {own}{inherits}:", said, *part]), [own]))
            bases = [own]
        return pieces

    # Functions ----------------------------------------------------------------------------------------------------------

    def _function(self, function: Entity, described: Signature, owner: str, name: str, body: dict[str, list[str]]) -> None:
        parameters = ", ".join(["self", *self.types.parameters(described)])
        result = self.types.result(described, owner)
        lines = self._function_lines(function, described, owner)
        mark = []
        if described.deprecated:
            mark = [f"    @{self.use('deprecated', '')}({_quoted(described.deprecated)})"]
        generic = self.generic(function, described)
        if generic:
            # The class that is asked for is the class of the result: once by a Python class, once in every other way.
            future = self.use("Future", "")
            for facet, wrapped in (("members", "{}"), ("async", future + "[{}]")):
                for form, said in ((generic[0], lines), (generic[1], [])):
                    head = f"    @{self.use('overload', '')}\n    def {name}({form[0]}) -> {wrapped.format(form[1])}:"
                    body[facet].append("\n".join([head, *docstring(said, "        ")]) if said else head + " ...")
            body["send"].append(f"    def {name}({parameters}) -> None: ...")
            return
        body["members"].append("\n".join([*mark, f"    def {name}({parameters}) -> {result}:", *docstring(lines, "        ")]))
        short = docstring([line for line in (documentation(function).summary or f"Unreal: {owner}.{function['name']}",)], "        ")
        body["async"].append("\n".join([*mark, f"    def {name}({parameters}) -> {self.use('Future', '')}[{result}]:", *short]))
        body["send"].append("\n".join([*mark, f"    def {name}({parameters}) -> None:", *short]))

    def generic(self, function: Entity, described: Signature) -> tuple[tuple[str, str], tuple[str, str]] | None:
        """(parameters, result) of the two forms of a function whose result is of the class given (meta DeterminesOutputType); None for others."""
        chosen = (meta_value(function, "DeterminesOutputType") or "").lower()
        if not chosen or described.returns != "single" or described.deprecated or not described.callable:
            return None
        output = described.outputs[0]
        node = output.type["inner"] if output.type["kind"] == "array" else output.type
        given = next((p for p in described.inputs if p.name.lower() == chosen and p.type["kind"] == "class"), None)
        if given is None or node["kind"] != "object" or given.optional or output.array_dim > 1:
            return None
        bound = self.types.class_name(given.type["name"])
        if not self.schemas.is_a(bound, node["name"]):
            return None  # the components that have an interface are not interfaces
        variable = self.use("TypeVar:" + bound, "")
        plain = self.types.argument(given.type, 1, given.nullable)
        head = f"{given.python_name}: {plain}"
        parameters = ["self", *self.types.parameters(described)]
        result = self.types.result(described, "")
        generic_result = result.replace(self.types.value(node, 1, False), variable, 1)
        others = plain.split(" | ", 1)[1]
        return (
            (", ".join(f"{given.python_name}: type[{variable}]" if p == head else p for p in parameters), generic_result),
            (", ".join(f"{given.python_name}: {others}" if p == head else p for p in parameters), result),
        )

    def _function_lines(self, function: Entity, described: Signature, owner: str) -> list[str]:
        said = documentation(function)
        lines = body_lines(said)
        arguments: list[str] = []
        for parameter in described.inputs:
            text = [said.parameter(parameter.name)]
            if units_of(parameter.entity):
                text.append(f"[{units_of(parameter.entity)}]")
            if range_of(parameter.entity):
                text.append(f"({range_of(parameter.entity)})")
            if parameter.keyword_only:
                text.append("The world; the server fills it in.")
            elif parameter.optional and parameter.type["kind"] in ("struct", "array", "set", "map") and parameter.default_python:
                text.append(f"Default {parameter.default_python}.")
            if parameter.is_reference:
                text.append("Also a result.")
            joined = " ".join(part for part in text if part)
            if joined:
                arguments.append(f"    {parameter.python_name}: {joined}")
        if arguments:
            lines += ["", "Args:", *arguments]
        returned = said.returns
        results = [f"{o.python_name}: {said.parameter(o.name)}" for o in described.outputs if not o.is_return and said.parameter(o.name)]
        if returned or results:
            lines += ["", "Returns:", *[f"    {line}" for line in ([returned] if returned else []) + results]]
        for label, note in said.notes:
            lines += ["", f"{label}: {note}"]
        if not described.callable:
            lines += ["", "Cannot be called from outside (custom thunk): raises NotCallable."]
        elif described.latent:
            lines += ["", "Latent: completes in a later frame."]
        return [*lines, "", f"Unreal: {owner}.{function['name']}{' (static)' if described.static else ''}"]

    def _result(self, described: Signature, owner: str, function: Entity) -> str:
        said = documentation(function)
        lines = [f"class {result_name(owner, described.name)}({self.use('NamedTuple', '')}):", f'    """Results of {owner}.{described.name}."""']
        for output in described.outputs:
            lines.append(f"    {output.python_name}: {self.types.value(output.type, output.array_dim, output.nullable)}")
            lines += docstring([said.returns if output.is_return else said.parameter(output.name)], "    ")
        return "\n".join(lines)

    # Variables ----------------------------------------------------------------------------------------------------------

    def _variable(self, variable: Entity, owner: str, name: str, body: dict[str, list[str]]) -> None:
        node, dimension = variable["type"], variable["array_dim"]
        declared = f"    {name}: {self.types.variable(node, dimension)}"
        body["members"].append("\n".join([declared, *docstring(self._variable_lines(variable, owner), "    ")]))
        short = docstring([documentation(variable).summary], "    ")
        body["async"].append("\n".join([f"    {name}: {self.types.variable(node, dimension, 'Async')}", *short]))
        body["send"].append(f"    {name}: {self.types.variable(node, dimension, 'Send')}")

    def _variable_lines(self, variable: Entity, owner: str) -> list[str]:
        said = documentation(variable)
        lines = body_lines(said)
        for label, text in said.notes:
            lines += ["", f"{label}: {text}"]
        if deprecated_text(variable) or "Deprecated" in variable["flags"]:
            lines += ["", f"Deprecated: {deprecated_text(variable)}".rstrip(": ")]
        facts = [f"unit {units_of(variable)}"] * bool(units_of(variable)) + [range_of(variable)] * bool(range_of(variable))
        default = variable.get("source", {}).get("default")
        if default:
            facts.append(f"initially {default}")
        if facts:
            lines += ["", "; ".join(facts)]
        described = self._delegate_text(variable["type"])
        if described:
            lines += ["", described]
        dimension = f"[{variable['array_dim']}]" if variable["array_dim"] > 1 else ""
        return [*lines, "", f"Unreal: {owner}.{variable['name']} ({variable['type']['cpp']}{dimension})"]

    def _delegate_text(self, node: Entity) -> str:
        if node["kind"] not in ("delegate", "multicast_delegate", "sparse_delegate"):
            return ""
        delegate = self.schemas.delegate_of(dict(node))
        return f"Delegate: {self._delegate_signature(delegate)}" if delegate else ""

    def _delegate_signature(self, delegate: Entity) -> str:
        plain = PythonTypes(self.schemas)
        described = signature(delegate, self.schemas)
        parts = [f"{p.python_name}: {plain.value(p.type, p.array_dim, False)}" for p in described.inputs]
        returned = delegate["returns"]
        return f"{delegate['name']}({', '.join(parts)})" + (f" -> {plain.value(returned['type'], 1, False)}" if returned else "")

    # Structs ------------------------------------------------------------------------------------------------------------

    def struct(self, entity: Entity) -> list[Piece]:
        """A struct: its value, its dictionary, what stands for it as an argument, its paths."""
        unreal = entity["name"]
        name = python_name(unreal, "type")
        above = entity["super"] if entity["super"] in self.schemas.structs else None
        bases = [self.schemas.structs[base] for base in reversed(self.schemas.ancestors(unreal)) if base in self.schemas.structs]
        inherited = [f for base in bases for f in base["properties"]]
        properties = _distinct(entity["properties"], {f["name"] for f in inherited})
        if len(properties) != len(entity["properties"]):
            self.left_out.append(f"{unreal}: a second field of a name")
        names = ScopeNames([f["name"] for f in [*inherited, *properties]], "field")
        hand_written = unreal in HAND_WRITTEN_STRUCTS
        fields = [self._field(f, names) for f in properties]
        everything = [self._field(f, names) for f in inherited] + fields
        functional = any(f["unreal"] != f["name"] for f in everything)
        numbers = f" | {self.use('Numbers', '')}" if everything and all(self._is_numbers(f) for f in [*inherited, *properties]) else ""
        text = self._render(
            "struct", name=name, hand_written=hand_written, base=self.use(above or "Struct", ""), fields=fields, all_fields=everything,
            documentation=docstring([*body_lines(documentation(entity)), "", f"Unreal: {entity['path'] or unreal}"], "    "), functional=functional,
            dict_base=self.use(above, "_dict") if above else self.use("TypedDict", ""), numbers=numbers,
        )
        shared = above is not None or bool(self.schemas.derived_structs.get(unreal))
        paths = self._render(
            "struct_paths", name=name, shared=shared, members_base=f"({self.use(above, '_members')})" if above else "",
            async_members_base=f"({self.use(above, '_async_members')})" if above else "",
            path_lines=[line for f in fields for line in (f"    {f['name']}: {f['path']}", *f["documentation"])],
            async_lines=[f"    {f['name']}: {f['async_path']}" for f in fields],
        )
        helpers = ["_path", "_async"] + ["_members", "_async_members"] * shared
        self.facts.structs[unreal] = {"super": entity["super"], "fields": [f["unreal"] for f in everything], "names": names.table()}
        return [Piece(text, [name, name + "_dict", name + "_in"]), Piece(paths, [name + helper for helper in helpers])]

    def _field(self, entity: Entity, names: ScopeNames) -> dict[str, Any]:
        node, dimension = entity["type"], entity["array_dim"]
        said = documentation(entity)
        facts = [f"[{units_of(entity)}]"] * bool(units_of(entity)) + [f"({range_of(entity)})"] * bool(range_of(entity))
        lines = body_lines(said)
        if facts:
            lines += ["", " ".join(facts)]
        argument = self.types.argument(node, dimension, True)
        return {
            "unreal": entity["name"], "name": names[entity["name"]], "key": _quoted(entity["name"]), "type": self.types.value(node, dimension),
            "argument": argument, "argument_text": _quoted(argument), "path": self.types.variable(node, dimension),
            "async_path": self.types.variable(node, dimension, "Async"), "documentation": docstring(lines, "    "),
        }

    def _is_numbers(self, entity: Entity) -> bool:
        return entity["type"]["kind"] in NUMBER_KINDS and entity["array_dim"] == 1

    # Enums, delegates ---------------------------------------------------------------------------------------------------

    def enum(self, entity: Entity) -> list[Piece]:
        """An enum and what stands for it as an argument."""
        name = python_name(entity["name"], "type")
        short = [short_entry_name(entry["name"]) for entry in entity["entries"]]
        names = ScopeNames(short, "entry")
        entries = []
        for entry, unreal in zip(entity["entries"], short):
            entries.append({"name": names[unreal], "value": entry["value"], "documentation": docstring(body_lines(documentation(entry)), "    ")})
        flags = "Flags" in entity["flags"]
        text = self._render(
            "enum", name=name, base=self.use("UnrealFlags" if flags else "UnrealEnum", ""), entries=_distinct(entries, set()),
            documentation=docstring([*body_lines(documentation(entity)), "", f"Unreal: {entity['path'] or entity['name']}"], "    "),
        )
        self.facts.enums[entity["name"]] = {
            "flags": flags, "entries": [[unreal, entry["value"]] for entry, unreal in zip(entity["entries"], short)], "names": names.table(),
        }
        return [Piece(text, [name, name + "_in"])]

    def delegate(self, entity: Entity) -> list[Piece]:
        """The type of a delegate's value: what is bound to it."""
        name = self.delegates.get((entity["owner"] or "", entity["name"])) or python_name(entity["name"], "type")
        value = self.use("FScriptDelegate", "")
        said = [f"Called as {self._delegate_signature(entity)}; a value tells what is bound.", "", f"Unreal: {entity['path'] or entity['name']}"]
        lines = [*body_lines(documentation(entity)), "", *said]
        kind = value if entity["kind"] == "single" else f"list[{value}]"
        text = "\n".join([f"{name}: {self.use('TypeAlias', '')} = {kind}", *docstring(lines, "")])
        self.facts.delegates[name] = entity["kind"]
        return [Piece(text, [name])]


#: The classes that hold what a class has: suffix, base of all, documentation.
_FACETS = (
    ("members", "", "Functions and variables of {}."), ("async", "AsyncBase", "{} under ``async_``: each function gives a future."),
    ("send", "SendBase", "{} under ``send_``: no function answers."),
)

#: The helpers that each template names.
_USES: Mapping[str, tuple[str, ...]] = {
    "class": ("AsyncObjectPath", "ObjectPath"), "interface_class": (), "struct": ("Future", "TypeAlias", "TypedDict"),
    "struct_paths": ("AsyncValuePath", "StructPath"), "enum": ("Future", "TypeAlias"),
}


def new_interfaces(entity: Entity, schemas: SchemaSet) -> list[str]:
    """The interfaces that a class adds: known ones, none that a super class or another one here has already."""
    def chain(interface: str) -> list[str]:
        found = schemas.class_of_reference(interface)
        return [] if found is None else ["I" + name[1:] for name in schemas.ancestors(found["name"]) if name in schemas.classes and name != "UObject"]

    inherited: set[str] = set()
    for ancestor in schemas.ancestors(entity["name"]):
        for interface in schemas.classes.get(ancestor, {"interfaces": []})["interfaces"]:
            inherited |= {interface, *chain(interface)}
    listed = [interface for interface in dict.fromkeys(entity["interfaces"]) if schemas.class_of_reference(interface) and interface not in inherited]
    implied = {above for interface in listed for above in chain(interface)}
    return [interface for interface in listed if interface not in implied]


def _distinct(entries: Iterable[Any], seen: set[str]) -> list[Any]:
    """Those whose name is new."""
    found = []
    for entry in entries:
        if entry["name"] not in seen:
            seen.add(entry["name"])
            found.append(entry)
    return found


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ")
    return f'"{escaped}"'
