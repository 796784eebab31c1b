# SPDX-License-Identifier: MIT
"""The stubs against the running engine: every name, parameter, order, default and type, and nothing besides.

The stubs are read with ``ast`` alone, the engine's side is its live schema; the table of types below is this test's own.
"""

from __future__ import annotations

import ast
import importlib
from pathlib import Path
from typing import Any

import pytest

import spear

MODULES = ("CoreUObject", "Engine", "SpearServer")
HAND_WRITTEN = {"FColor", "FLinearColor", "FQuat", "FRotator", "FTransform", "FVector", "FVector2D", "FVector4"}
INTEGERS = {"int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64"}
FLOATS = {"float", "double"}
TEXTS = {"string", "name", "text", "field_path"}
OBJECTS = {"object", "weak_object", "lazy_object", "interface"}


#: What spear.typing calls the descriptors of plain variables.
PLAIN = {
    f"{facet}{word}Property": f"Property[{facet}Path[{plain}], {plain} | Future[{plain}]]" if facet != "Send" else f"SendProperty[{plain} | Future[{plain}]]"
    for facet in ("", "Async", "Send") for word, plain in (("Bool", "bool"), ("Int", "int"), ("Float", "float"), ("Str", "str"))
}


class StubFile:
    """One .pyi, its classes, and what its local names mean."""

    def __init__(self, path: Path) -> None:
        self.tree = ast.parse(path.read_text(encoding="utf-8"))
        self.meaning: dict[str, str] = {}
        for node in self.tree.body:
            if isinstance(node, ast.ImportFrom):
                self.meaning.update({alias.asname or alias.name: "AbstractSet" if alias.name == "Set" else alias.name for alias in node.names})
            elif isinstance(node, ast.Assign) and isinstance(node.value, ast.Name) and isinstance(node.targets[0], ast.Name):
                self.meaning[node.targets[0].id] = node.value.id
        self.classes = {node.name: node for node in self.tree.body if isinstance(node, ast.ClassDef)}
        self.assigned = {node.target.id: node.value for node in self.tree.body if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)}

    def text(self, annotation: ast.expr | None) -> str:
        """An annotation with the names that everybody knows."""
        assert annotation is not None
        copied = ast.parse(ast.unparse(annotation), mode="eval")
        for node in ast.walk(copied):
            if isinstance(node, ast.Name):
                node.id = self.meaning.get(node.id, node.id)
        return ast.unparse(copied)

    def union(self, annotation: ast.expr | None) -> set[str]:
        """The members of a union."""
        parts: set[str] = set()
        waiting = [ast.parse(self.text(annotation), mode="eval").body]
        while waiting:
            node = waiting.pop()
            if isinstance(node, ast.BinOp):
                waiting += [node.left, node.right]
            else:
                parts.add(ast.unparse(node))
        return parts


class Stubs:
    """All of them: class name -> (file, class)."""

    def __init__(self, folder: Path) -> None:
        self.files = {path: StubFile(path) for module in MODULES for path in sorted((folder / module).glob("*.pyi"))}
        self.classes: dict[str, tuple[StubFile, ast.ClassDef]] = {}
        self.aliases: dict[str, tuple[StubFile, ast.expr]] = {}
        for file in self.files.values():
            for name, node in file.classes.items():
                assert name not in self.classes, f"{name} is declared twice"
                self.classes[name] = (file, node)
            self.aliases.update({name: (file, value) for name, value in file.assigned.items() if value is not None})


@pytest.fixture(scope="module")
def stubs(build_directory: Path) -> Stubs:
    return Stubs(build_directory / "python" / "spear" / "unreal")


@pytest.fixture(scope="module")
def schema(instance: spear.Instance) -> dict[str, Any]:
    """What the engine says that it has."""
    return instance.get_schema(MODULES)


@pytest.fixture(scope="module")
def known(schema: dict[str, Any]) -> dict[str, set[str]]:
    return {kind: {entity["name"] for entity in schema[kind]} for kind in ("classes", "structs", "enums")}


# Types -----------------------------------------------------------------------------------------------------------------------


def read(node: dict[str, Any], dimension: int = 1, nullable: bool = True) -> set[str]:
    """What reading a value of a type gives, as the members of a union."""
    kind, none = node["kind"], {"None"} if nullable else set()
    if dimension > 1:
        return {f"list[{joined(read(node))}]"}
    if kind == "bool":
        return {"bool"}
    if kind in INTEGERS:
        return {"int"}
    if kind in FLOATS:
        return {"float"}
    if kind in TEXTS | {"soft_object", "soft_class"}:
        return {"str"}
    if kind in {"enum", "byte_enum", "struct"}:
        return {node["name"]}
    if kind in OBJECTS:
        return {node["name"]} | none
    if kind == "class":
        return {"UClass"} | none
    if kind == "array":
        return {f"list[{joined(read(node['inner'], 1, nullable))}]"}
    if kind == "set":
        return {f"{'list' if node['inner']['kind'] == 'struct' else 'set'}[{joined(read(node['inner'], 1, nullable))}]"}
    if kind == "map":
        return {f"dict[{joined(read(node['key'], 1, False))}, {joined(read(node['value']))}]"}
    if kind == "optional":
        return read(node["inner"], 1, False) | {"None"}
    if kind == "delegate":
        return {"FScriptDelegate"}
    assert kind in {"multicast_delegate", "sparse_delegate"}, kind
    return {"list[FScriptDelegate]"}


def written(node: dict[str, Any], dimension: int = 1, nullable: bool = True) -> set[str]:
    """What may be given for a value of a type."""
    kind, none = node["kind"], {"None"} if nullable else set()
    if dimension > 1:
        return {f"Sequence[{joined(written(node))}]", f"Future[{joined(read(node, dimension))}]"}
    if kind in OBJECTS:
        return {node["name"], f"Future[{node['name']}]"} | none
    if kind == "class":
        return {f"type[{node['name']}]", "UClass", "str", "Future[UClass]"} | none
    if kind in {"soft_object", "soft_class"}:
        name = "UClass" if kind == "soft_class" else node["name"]
        return {"str", name, "Future[str]", f"Future[{name}]"} | none
    if kind in {"enum", "byte_enum", "struct"}:
        return {node["name"] + "_in"}
    if kind in {"array", "set"}:
        inner = joined(written(node["inner"]))
        numbers = {"Buffer"} if node["inner"]["kind"] in INTEGERS | FLOATS else set()
        return {f"Sequence[{inner}]", f"Future[{joined(read(node))}]"} | numbers | ({f"AbstractSet[{inner}]"} if kind == "set" else set())
    if kind == "map":
        key = joined(read(node["key"], 1, False))
        return {f"Mapping[{k}, {joined(written(node['value']))}]" for k in {"str", key}} | {f"Future[{joined(read(node))}]"}
    if kind == "optional":
        return written(node["inner"]) | {"None"}
    if kind == "delegate":
        return {"FScriptDelegate_in", "None"}
    if kind in {"multicast_delegate", "sparse_delegate"}:
        return {"Sequence[FScriptDelegate_in]", "None"}
    (plain,) = read(node)
    return {plain, f"Future[{plain}]"}


def path(node: dict[str, Any], dimension: int, prefix: str = "") -> str:
    """How the path of a variable begins: the class of the path, and what get() gives."""
    kind = node["kind"]
    if dimension > 1 or kind == "array":
        element = node if dimension > 1 else node["inner"]
        return f"{prefix}ArrayPath[{joined(read(element))}, "
    if kind in OBJECTS:
        return node["name"] + ("_async_path" if prefix else "_path")
    if kind == "struct":
        return node["name"] + ("_async" if prefix else "_path")
    if kind == "class":
        return f"{prefix}ClassPath[UClass, "
    if kind == "map":
        return f"{prefix}MapPath[{joined(read(node['key'], 1, False))}, {joined(read(node['value']))}, "
    if kind == "set" and not prefix:
        return f"SetPath[{joined(read(node['inner']))}, "
    if kind in {"enum", "byte_enum", "soft_object", "soft_class", "set", "optional", "delegate", "multicast_delegate", "sparse_delegate"}:
        return f"{prefix}ValuePath[{joined(read(node))}, "
    return f"{prefix}Path[{joined(read(node))}]"


def joined(parts: set[str]) -> str:
    """A union of some members in a fixed order, for comparing texts: see `sorted_unions`."""
    return " | ".join(sorted(parts))


def sorted_unions(text: str) -> str:
    """A type with the members of every union in it sorted."""
    def sort(node: ast.expr) -> str:
        if isinstance(node, ast.BinOp):
            members: list[str] = []
            waiting: list[ast.expr] = [node]
            while waiting:
                current = waiting.pop()
                if isinstance(current, ast.BinOp):
                    waiting += [current.left, current.right]
                else:
                    members.append(sort(current))
            return " | ".join(sorted(set(members)))
        if isinstance(node, ast.Subscript):
            inner = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
            return f"{ast.unparse(node.value)}[{', '.join(sort(part) for part in inner)}]"
        return ast.unparse(node)

    return sort(ast.parse(text, mode="eval").body)


def same_type(file: StubFile, annotation: ast.expr | None, expected: set[str], where: str) -> None:
    found = {sorted_unions(part) for part in file.union(annotation)}
    assert found == {sorted_unions(part) for part in expected}, f"{where}: stub {found}, engine {expected}"


# Classes ---------------------------------------------------------------------------------------------------------------------


def family(entity: dict[str, Any]) -> str:
    """The name under which a class's members stand: interfaces by their I name."""
    return "I" + entity["name"][1:] if "Interface" in entity["flags"] else str(entity["name"])


def members_of(stubs: Stubs, name: str) -> tuple[StubFile, dict[str, ast.FunctionDef], dict[str, ast.expr]]:
    file, node = stubs.classes[name]
    functions: dict[str, ast.FunctionDef] = {}
    variables: dict[str, ast.expr] = {}
    for item in node.body:
        if isinstance(item, ast.FunctionDef) and item.name not in functions:
            functions[item.name] = item  # of two overloads the first, compared apart
        elif isinstance(item, ast.AnnAssign):
            assert isinstance(item.target, ast.Name)
            variables[item.target.id] = item.annotation
    return file, functions, variables


def test_classes_and_their_bases(stubs: Stubs, schema: dict[str, Any]) -> None:
    names = {family(entity) for entity in schema["classes"]}
    for entity in schema["classes"]:
        file, node = stubs.classes[family(entity)]
        bases = [file.text(base) for base in node.bases]
        if "Interface" in entity["flags"]:
            assert bases[0] == family(entity) + "_members"
            continue
        expected = [entity["name"] + "_members", entity["super"] or "ObjectBase"]
        if entity["super"] == "UObject" and entity["interfaces"]:
            expected.remove("UObject")  # the interfaces are UObjects
        assert bases[: len(expected)] == expected and set(bases[len(expected):]) <= set(entity["interfaces"]), entity["name"]
        for suffix in ("_members", "_path", "_async", "_async_path", "_send"):
            assert entity["name"] + suffix in stubs.classes
    extra = {n for n in stubs.classes if n + "_members" in stubs.classes and n + "_async_path" in stubs.classes} - names
    assert extra == {"UClass", "UStruct", "UScriptStruct", "UField", "UFunction", "UEnum", "UPackage", "UInterface"}  # intrinsic: in no schema


def test_functions_and_variables_are_exactly_those_of_the_engine(stubs: Stubs, schema: dict[str, Any]) -> None:
    for entity in schema["classes"]:
        for suffix in ("_members", "_async", "_send"):
            _, functions, variables = members_of(stubs, family(entity) + suffix)
            assert list(functions) == [f["name"] for f in entity["functions"]], entity["name"] + suffix
            assert list(variables) == [p["name"] for p in entity["properties"]], entity["name"] + suffix


def is_output(parameter: dict[str, Any]) -> bool:
    return "OutParm" in parameter["flags"] and "ConstParm" not in parameter["flags"]


def positional_and_context(function: dict[str, Any]) -> tuple[list[dict[str, Any]], dict[str, Any] | None]:
    declared = function["editor"]["meta"].get("WorldContext")
    inputs, context = [], None
    for parameter in function["parameters"]:
        if parameter["name"] == declared or (declared is None and "Static" in function["flags"] and parameter["name"] == "WorldContextObject"):
            context = parameter
        elif parameter["type"]["cpp"] != "FLatentActionInfo" and not (is_output(parameter) and "ReferenceParm" not in parameter["flags"]):
            inputs.append(parameter)
    return inputs, context


def test_parameters_order_defaults_and_types(stubs: Stubs, schema: dict[str, Any]) -> None:
    compared = 0
    for entity in schema["classes"]:
        for suffix in ("_members", "_async", "_send"):
            file, functions, _ = members_of(stubs, family(entity) + suffix)
            for function in entity["functions"]:
                where = f"{entity['name']}{suffix}.{function['name']}"
                node = functions[function["name"]]
                inputs, context = positional_and_context(function)
                given = node.args.args[1:] + node.args.kwonlyargs
                assert [a.arg for a in given] == [p["name"] for p in [*inputs, *([context] if context else [])]], where
                assert [a.arg for a in node.args.kwonlyargs] == ([context["name"]] if context else []), where
                defaults = dict(zip([a.arg for a in node.args.args[::-1]], node.args.defaults[::-1]))
                meta = function["editor"]["meta"]
                overloaded = any(ast.unparse(d).endswith("overload") for d in node.decorator_list)
                for argument, parameter in zip(given, inputs):
                    text = meta.get("CPP_Default_" + parameter["name"])
                    assert (argument.arg in defaults) == (text is not None), where
                    if text is not None:
                        same_default(defaults[argument.arg], text, parameter["type"], where)
                    if overloaded and meta.get("DeterminesOutputType") == argument.arg and suffix != "_send":
                        assert file.text(argument.annotation) == f"type[_T_{parameter['type']['name']}]", where
                        continue
                    nullable = parameter["type"]["kind"] in OBJECTS | {"class", "soft_object", "soft_class"} and text in ("None", "")
                    same_type(file, argument.annotation, written(parameter["type"], parameter["array_dim"], nullable), f"{where}({argument.arg})")
                    compared += 1
    assert compared > 3000


def same_default(stub: ast.expr, text: str, node: dict[str, Any], where: str) -> None:
    """The default in the stub is that of the metadata; an ellipsis stands for those that have no plain form."""
    kind = node["kind"]
    if kind == "bool":
        assert ast.literal_eval(stub) is (text.lower() == "true"), where
    elif kind in INTEGERS | FLOATS:
        assert ast.literal_eval(stub) == float(text), where
    elif kind in {"string", "name"}:
        assert ast.literal_eval(stub) == text, where
    elif kind in {"enum", "byte_enum"}:
        assert ast.unparse(stub) == f"{node['name']}.{text}", where
    elif kind in OBJECTS | {"class"}:
        assert ast.literal_eval(stub) is None, where
    else:
        assert ast.unparse(stub) == "...", where


def test_results(stubs: Stubs, schema: dict[str, Any]) -> None:
    tuples = 0
    for entity in schema["classes"]:
        for function in entity["functions"]:
            where = f"{entity['name']}.{function['name']}"
            outputs = [("ReturnValue", function["returns"])] * bool(function["returns"]) + [(p["name"], p) for p in function["parameters"] if is_output(p)]
            file, functions, _ = members_of(stubs, family(entity) + "_members")
            node = functions[function["name"]]
            twin_file, twins, _ = members_of(stubs, family(entity) + "_async")
            returned = file.text(node.returns)
            assert twin_file.text(twins[function["name"]].returns) == f"Future[{returned}]", where
            assert ast.unparse(members_of(stubs, family(entity) + "_send")[1][function["name"]].returns or ast.Constant(0)) == "None", where
            if "CustomThunk" in function["editor"]["meta"]:
                assert returned == "NoReturn", where
            elif not outputs:
                assert returned == "None", where
            elif len(outputs) == 1 and function["returns"]:
                if "_T_" not in returned:
                    result_type(file, node.returns, function["returns"], where)
            else:
                assert returned == f"{entity['name']}_{function['name']}_Result", where
                result_file, result = stubs.classes[returned]
                fields = [item for item in result.body if isinstance(item, ast.AnnAssign)]
                assert [f.target.id for f in fields if isinstance(f.target, ast.Name)] == [name for name, _ in outputs], where
                for field, (_, output) in zip(fields, outputs):
                    result_type(result_file, field.annotation, output, where)
                tuples += 1
    assert tuples > 60


def result_type(file: StubFile, annotation: ast.expr | None, output: dict[str, Any], where: str) -> None:
    """The type of a result; whether an object may be None is a matter of evidence, not of the schema."""
    dimension = output.get("array_dim", 1)
    found = {sorted_unions(part) for part in file.union(annotation)}
    allowed = [{sorted_unions(part) for part in read(output["type"], dimension, nullable)} for nullable in (True, False)]
    assert found in allowed, f"{where}: stub {found}, engine {allowed}"


def test_types_of_variables(stubs: Stubs, schema: dict[str, Any]) -> None:
    compared = 0
    for entity in schema["classes"]:
        for suffix, prefix in (("_members", ""), ("_async", "Async")):
            file, _, variables = members_of(stubs, family(entity) + suffix)
            for variable in entity["properties"]:
                where = f"{entity['name']}{suffix}.{variable['name']}"
                compare_variable(file, variables[variable["name"]], variable, prefix, where)
                compared += 1
        file, _, variables = members_of(stubs, family(entity) + "_send")
        for variable in entity["properties"]:
            annotation = descriptor(file, variables[variable["name"]])
            assert isinstance(annotation, ast.Subscript) and file.text(annotation.value) == "SendProperty"
            same_type(file, annotation.slice, written(variable["type"], variable["array_dim"]), f"{entity['name']}_send.{variable['name']}")
    assert compared > 600


def descriptor(file: StubFile, annotation: ast.expr) -> ast.expr:
    """The annotation of a variable without the short names."""
    return ast.parse(PLAIN.get(file.text(annotation), file.text(annotation)), mode="eval").body


def test_short_names_mean_what_this_test_takes_them_for(source_directory: Path) -> None:
    tree = ast.parse((source_directory / "python" / "spear" / "typing.pyi").read_text())
    found = {n.target.id: ast.unparse(n.value) for n in tree.body if isinstance(n, ast.AnnAssign) and isinstance(n.target, ast.Name) and n.value is not None}
    assert {name: text for name, text in found.items() if name in PLAIN} == PLAIN


def compare_variable(file: StubFile, annotation: ast.expr, variable: dict[str, Any], prefix: str, where: str) -> None:
    annotation = descriptor(file, annotation)
    assert isinstance(annotation, ast.Subscript) and file.text(annotation.value) == "Property", where
    assert isinstance(annotation.slice, ast.Tuple), where
    path_type, set_type = annotation.slice.elts
    expected = path(variable["type"], variable["array_dim"], prefix)
    found = sorted_unions(file.text(path_type))
    assert found == expected or found.startswith(expected) and expected.endswith(", "), f"{where}: stub {found}, engine {expected}"
    same_type(file, set_type, written(variable["type"], variable["array_dim"]), where)


# Structs, enums, delegates ---------------------------------------------------------------------------------------------------


def all_fields(schema: dict[str, Any], struct: dict[str, Any]) -> list[dict[str, Any]]:
    by_name = {s["name"]: s for s in schema["structs"]}
    return (all_fields(schema, by_name[struct["super"]]) if struct["super"] else []) + struct["properties"]


def test_structs(stubs: Stubs, schema: dict[str, Any]) -> None:
    for struct in schema["structs"]:
        name, own = struct["name"], struct["properties"]
        members = name + "_members" if name + "_members" in stubs.classes else name + "_path"
        file, _, paths = members_of(stubs, members)
        assert list(paths) == [p["name"] for p in own], name
        for variable in own:
            compare_variable(file, paths[variable["name"]], variable, "", f"{name}.{variable['name']}")
        members = name + "_async_members" if name + "_async_members" in stubs.classes else name + "_async"
        file, _, paths = members_of(stubs, members)
        for variable in own:
            compare_variable(file, paths[variable["name"]], variable, "Async", f"{name}.{variable['name']}")
        file, _, keys = members_of(stubs, name + "_dict")
        assert list(keys) == [p["name"] for p in own], name
        for variable in own:
            same_type(file, keys[variable["name"]], written(variable["type"], variable["array_dim"]), f"{name}.{variable['name']}")
        file, alias = stubs.aliases[name + "_in"]
        assert {name, name + "_dict", f"Future[{name}]"} <= file.union(alias)
        plain = all(p["type"]["kind"] in INTEGERS | FLOATS and p["array_dim"] == 1 for p in all_fields(schema, struct)) and bool(all_fields(schema, struct))
        assert ("Numbers" in file.union(alias)) == plain, name
        if name in HAND_WRITTEN:
            value = getattr(spear, name)
            assert value.field_names == tuple(p["name"] for p in all_fields(schema, struct))
            continue
        file, functions, fields = members_of(stubs, name)
        assert file.text(stubs.classes[name][1].bases[0]) == (struct["super"] or "Struct")
        assert list(fields) == [p["name"] for p in own], name
        for variable in own:
            same_type(file, fields[variable["name"]], read(variable["type"], variable["array_dim"]), f"{name}.{variable['name']}")
        assert [a.arg for a in functions["__init__"].args.args[1:]] == [p["name"] for p in all_fields(schema, struct)], name


def test_enums(stubs: Stubs, schema: dict[str, Any]) -> None:
    for enum in schema["enums"]:
        file, node = stubs.classes[enum["name"]]
        assert file.text(node.bases[0]) == ("UnrealFlags" if "Flags" in enum["flags"] else "UnrealEnum")
        entries = [(i.targets[0].id, ast.literal_eval(i.value)) for i in node.body if isinstance(i, ast.Assign) and isinstance(i.targets[0], ast.Name)]
        expected = [(entry["name"].rpartition("::")[2], entry["value"]) for entry in enum["entries"]]
        assert [(name.rstrip("_") if name.rstrip("_") in ("None", "name", "value") else name, value) for name, value in entries] == expected, enum["name"]
        file, alias = stubs.aliases[enum["name"] + "_in"]
        assert file.union(alias) == {enum["name"], "str", f"Future[{enum['name']}]"}


def test_delegates(stubs: Stubs, schema: dict[str, Any]) -> None:
    for delegate in schema["delegates"]:
        file, alias = stubs.aliases[delegate["name"]]
        assert file.text(alias) == ("FScriptDelegate" if delegate["kind"] == "single" else "list[FScriptDelegate]")


# Run time --------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("module", MODULES)
def test_every_name_of_the_stubs_exists_at_run_time(stubs: Stubs, build_directory: Path, module: str) -> None:
    folder = build_directory / "python" / "spear" / "unreal" / module
    exported = [alias.asname for node in StubFile(folder / "__init__.pyi").tree.body if isinstance(node, ast.ImportFrom) for alias in node.names]
    assert module == "SpearServer" or len(exported) > 100
    run_time = importlib.import_module(f"spear.unreal.{module}")
    for name in exported:
        assert name is not None and getattr(run_time, name) is not None, name


def test_classes_and_values_at_run_time_are_what_the_stub_says(schema: dict[str, Any]) -> None:
    for entity in schema["classes"]:
        python_class = getattr(importlib.import_module(f"spear.unreal.{entity['module']}"), entity["name"])
        assert isinstance(python_class, type) and python_class.unreal_name == entity["name"]
        if entity["super"]:
            above = next(e for e in schema["classes"] if e["name"] == entity["super"])
            assert issubclass(python_class, getattr(importlib.import_module(f"spear.unreal.{above['module']}"), above["name"]))
    for struct in schema["structs"]:
        value = getattr(importlib.import_module(f"spear.unreal.{struct['module']}"), struct["name"])
        assert issubclass(value, spear.Struct) and value.field_names == tuple(p["name"] for p in all_fields(schema, struct)), struct["name"]
    for enum in schema["enums"]:
        python_enum = getattr(importlib.import_module(f"spear.unreal.{enum['module']}"), enum["name"])
        for entry in enum["entries"]:
            assert python_enum(entry["name"]).value == entry["value"], entry["name"]
