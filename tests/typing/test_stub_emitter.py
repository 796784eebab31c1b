# SPDX-License-Identifier: MIT
"""The emitter of stubs on small schemas made here: names, signatures, documentation, layout, and what is odd in real code."""

from __future__ import annotations

import ast
import json
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "codegen"))

from emit import python_stubs  # noqa: E402
from emit.documentation import clean_comment, docstring, documentation, html_pieces, markdown, parse_comment, range_of, units_of  # noqa: E402
from emit.names import CPP_WORDS, ENUM_MEMBERS, OBJECT_MEMBERS, RESERVED, STRUCT_MEMBERS, ScopeNames, cpp_name, python_name, python_names, unreal_name_of  # noqa: E402
from emit.python_stub_pieces import HAND_WRITTEN_STRUCTS  # noqa: E402
from emit.schema import SchemaSet  # noqa: E402
from emit.signatures import signature  # noqa: E402

# Small schemas --------------------------------------------------------------------------------------------------------------


def node(kind: str, name: str = "", **more: Any) -> dict[str, Any]:
    return {"kind": kind, "cpp": name or kind, **({"name": name} if name else {}), **more}


def parameter(name: str, type_: dict[str, Any], *flags: str, meta: dict[str, str] | None = None) -> dict[str, Any]:
    return {"name": name, "type": type_, "flags": ["Parm", *flags], "array_dim": 1, "editor": {"meta": meta or {}}}


def function(name: str, *parameters: dict[str, Any], returns: dict[str, Any] | None = None, flags: tuple[str, ...] = (), **meta: str) -> dict[str, Any]:
    result = returns and {"type": returns, "flags": ["OutParm", "Parm", "ReturnParm"], "editor": {"meta": {}}}
    return {"name": name, "flags": list(flags), "parameters": list(parameters), "returns": result, "editor": {"meta": meta}}


def variable(name: str, type_: dict[str, Any], dimension: int = 1, **meta: str) -> dict[str, Any]:
    return {"name": name, "type": type_, "flags": [], "array_dim": dimension, "editor": {"meta": meta}}


def reflected_class(name: str, super_: str | None = "UObject", module: str = "Game", header: str = "Public/Things.h", **more: Any) -> dict[str, Any]:
    return {"name": name, "reflected_name": name[1:], "path": f"/Script/{module}.{name[1:]}", "module": module, "super": super_, "interfaces": [], "flags": [],
            "within": "UObject", "config": "", "functions": [], "properties": [], "editor": {"meta": {"ModuleRelativePath": header}}, **more}


def struct(name: str, *fields: dict[str, Any], super_: str | None = None, module: str = "Game", header: str = "Public/Things.h") -> dict[str, Any]:
    return {"name": name, "reflected_name": name[1:], "path": f"/Script/{module}.{name[1:]}", "module": module, "super": super_, "flags": [],
            "properties": list(fields), "editor": {"meta": {"ModuleRelativePath": header}}}


def enum(name: str, *entries: str, module: str = "Game", header: str = "Public/Things.h") -> dict[str, Any]:
    listed = [{"name": f"{name}::{entry}", "value": value, "editor": {"meta": {}}} for value, entry in enumerate(entries)]
    return {"name": name, "reflected_name": name, "path": f"/Script/{module}.{name}", "module": module, "form": "class", "cpp_type": name, "flags": [],
            "entries": listed, "editor": {"meta": {"ModuleRelativePath": header}}}


def schema_of(*entities: dict[str, Any]) -> dict[str, Any]:
    """A document of entities; UObject and AActor come with it."""
    everything = [reflected_class("UObject", None, "CoreUObject", "Public/Object.h"), reflected_class("AActor", module="Engine", header="Public/Actor.h"), *entities]
    document: dict[str, Any] = {"format": "spear-schema", "version": 1, "origin": "live", "classes": [], "structs": [], "enums": [], "delegates": []}
    for entity in everything:
        kind = "classes" if "functions" in entity else "enums" if "entries" in entity else "delegates" if "kind" in entity else "structs"
        document[kind].append(entity)
    document["modules"] = [{"name": name} for name in sorted({entity["module"] for entity in everything})]
    return document


def emit(folder: Path, *entities: dict[str, Any], jobs: int = 1) -> Path:
    """The stubs of some entities. Every file must parse."""
    python_stubs.emit(SchemaSet.of([schema_of(*entities)]), folder, jobs=jobs)
    for path in folder.rglob("*.pyi"):
        ast.parse(path.read_text())
    return folder


def stub(folder: Path, *entities: dict[str, Any], name: str = "Game/_Things.pyi") -> str:
    return (emit(folder, *entities) / name).read_text()


OBJECT, ACTOR, INT, FLOAT, NAME, BOOL = node("object", "UObject"), node("object", "AActor"), node("int32"), node("float"), node("name"), node("bool")

# Names ----------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("unreal, python", [
    ("Location", "Location"), ("None", "None_"), ("import", "import_"), ("get", "get_"), ("async", "async__"), ("send", "send__"), ("async_", "async___"),
    ("get_component", "get_component_"), ("int", "int_"), ("get_", "get__"), ("bHidden", "bHidden"), ("Ünïcode", "Ünïcode"),
])
def test_reserved_names_get_an_underscore_that_comes_off_again(unreal: str, python: str) -> None:
    assert python_name(unreal) == python
    assert unreal_name_of(python) == unreal


@pytest.mark.parametrize("unreal, python", [("My Variable", "My_Variable"), ("2D", "x2D"), ("What?", "What_"), ("__x", "x__x"), ("_handle", "x_handle"), ("ﬁeld", "field"), ("", "x")])
def test_what_is_no_identifier_is_told_by_a_table(unreal: str, python: str) -> None:
    names = ScopeNames([unreal])
    assert names[unreal] == python and python.isidentifier()
    assert unreal_name_of(python, names.table()) == unreal


def test_names_of_one_scope_are_distinct_and_plain_ones_keep_theirs() -> None:
    assert python_names(["My Name", "My-Name", "My_Name"]) == ["My_Name_2", "My_Name_3", "My_Name"]
    assert ScopeNames(["My Name", "My_Name"]).table() == {"My_Name_2": "My Name"}


def test_scopes_differ() -> None:
    assert python_name("value", "entry") == "value_" and python_name("value", "parameter") == "value"
    assert python_name("self", "parameter") == "self_" and python_name("count", "result") == "count_"


def test_closed_lists_are_those_of_the_run_time() -> None:
    import spear
    from spear.unreal_object import OBJECT_METHODS

    assert OBJECT_METHODS <= OBJECT_MEMBERS
    assert {name for name in vars(spear.Struct) if not name.startswith("_")} <= STRUCT_MEMBERS
    assert set(dir(spear.FVector)) - {n for n in dir(spear.FVector) if n.startswith("_")} - {"X", "Y", "Z"} <= STRUCT_MEMBERS
    assert {name for name in dir(int) if not name.startswith("_")} - {"is_integer"} <= ENUM_MEMBERS
    assert OBJECT_MEMBERS <= RESERVED["member"] and STRUCT_MEMBERS <= RESERVED["field"] and ENUM_MEMBERS <= RESERVED["entry"]


def test_hand_written_structs_are_those_of_the_run_time() -> None:
    import spear.structs

    own = {value.struct_name for value in vars(spear.structs).values() if isinstance(value, type) and issubclass(value, spear.structs.Struct) and value.struct_name}
    assert own == HAND_WRITTEN_STRUCTS


def test_cpp_names() -> None:
    assert cpp_name("class") == "class_" and cpp_name("My Name") == "My_Name" and cpp_name("2D") == "x2D" and cpp_name("call", {"call"}) == "call_"
    assert "requires" in CPP_WORDS

# Signatures -----------------------------------------------------------------------------------------------------------------


def described(entity: dict[str, Any]) -> Any:
    return signature(entity, SchemaSet.of([schema_of(struct("FVector", *(variable(n, node("double")) for n in "XYZ")), enum("EMode", "Slow", "Fast"))]))


def test_const_references_are_inputs_plain_ones_outputs_ref_ones_both() -> None:
    found = described(function(
        "F", parameter("In", node("struct", "FVector"), "ConstParm", "OutParm", "ReferenceParm"), parameter("Out", INT, "OutParm"),
        parameter("Both", INT, "OutParm", "ReferenceParm")))
    assert [p.name for p in found.inputs] == ["In", "Both"] and [o.name for o in found.outputs] == ["Out", "Both"] and found.returns == "tuple"


def test_shapes_of_results() -> None:
    assert described(function("F")).returns == "none"
    assert described(function("F", returns=INT)).returns == "single"
    assert described(function("F", parameter("Out", INT, "OutParm"))).returns == "tuple"
    both = described(function("F", parameter("Out", INT, "OutParm"), returns=BOOL))
    assert both.returns == "tuple" and [o.name for o in both.outputs] == ["ReturnValue", "Out"]


def test_world_context_and_latent_info_are_the_servers() -> None:
    latent = node("struct", "FLatentActionInfo")
    found = described(function("Delay", parameter("World", OBJECT), parameter("Duration", FLOAT), parameter("LatentInfo", latent), flags=("Static",), WorldContext="World", Latent=""))
    assert [(p.name, p.optional, p.keyword_only) for p in found.inputs] == [("Duration", False, False), ("World", True, True)]
    assert found.latent and found.world_context.name == "World"
    assert described(function("F", parameter("WorldContextObject", OBJECT), flags=("Static",))).world_context is not None
    assert described(function("F", parameter("WorldContextObject", OBJECT))).world_context is None  # not static, not declared


def test_defaults_are_those_of_the_metadata() -> None:
    vector = node("struct", "FVector")
    cases = [(INT, "5", "5", "5"), (FLOAT, "1.000000", "1.0", "1.0f"), (BOOL, "true", "True", "true"), (NAME, "None", '"None"', '"None"'),
             (ACTOR, "None", "None", "{}"), (node("enum", "EMode"), "Fast", "EMode.Fast", "EMode::Fast"), (node("string"), 'say "x"', "'say \"x\"'", '"say \\"x\\""'),
             (vector, "1.000000,2.000000,3.000000", "FVector(X=1.0, Y=2.0, Z=3.0)", "FVector{.X = 1.0, .Y = 2.0, .Z = 3.0}"), (vector, "", "FVector()", "FVector{}"),
             (node("array", inner=INT), "()", "[]", "{}")]
    for type_, text, python, cpp in cases:
        (found,) = described(function("F", parameter("P", type_), CPP_Default_P=text)).inputs
        assert (found.optional, found.default_python, found.default_cpp) == (True, python, cpp), type_
    (found,) = described(function("F", {**parameter("P", INT), "source": {"default": "Foo()"}})).inputs
    assert not found.optional and found.default_source == "Foo()"  # nobody knows its value: it must be given


def test_null_is_told_by_evidence() -> None:
    def nullable(**meta: str) -> bool:
        name = meta.pop("name", "GetThing")
        (output,) = described(function(name, returns=ACTOR, **meta)).outputs
        return bool(output.nullable)

    assert not nullable()
    assert nullable(Comment="/** The thing, or null. */") and nullable(ToolTip="The thing, if any") and nullable(Comment="/** @return nullptr if it is gone */")
    assert nullable(name="FindThing") and nullable(name="TryGetThing") and nullable(name="GetThingByName") and nullable(name="K2_FindThing")
    assert not nullable(Comment="/** The thing. @param Other may be null */") and not nullable(name="Finder")
    assert described(function("GetThing", returns=ACTOR)).never_null == ("GetThing",)
    assert described(function("GetThings", returns=node("array", inner=ACTOR))).never_null == ("GetThings[]",)
    assert described(function("GetThing", parameter("Out", ACTOR, "OutParm"), returns=ACTOR)).never_null == ("GetThing.ReturnValue",)
    assert described(function("GetThings", parameter("Out", node("array", inner=ACTOR), "OutParm"))).never_null == ("GetThings.Out[]",)
    (given,) = described(function("F", parameter("P", ACTOR), CPP_Default_P="None")).inputs
    assert given.nullable

# Documentation --------------------------------------------------------------------------------------------------------------


def test_comments_are_taken_apart() -> None:
    text = clean_comment("/**\n * Opens the door, e.g. for guests. It stays open.\n *\n * - slowly\n * - surely\n *\n * @param Angle in degrees;\n *   0 is closed\n * @return whether it @c moved\n * @note Not twice.\n */")
    said = parse_comment(text)
    assert said.summary == "Opens the door, e.g. for guests."
    assert [b.kind for b in said.blocks] == ["text", "list"] and said.blocks[1].lines == ("slowly", "surely")
    assert said.parameter("angle") == "in degrees; 0 is closed" and said.returns == "whether it `moved`" and said.notes == [("Note", "Not twice.")]
    assert "- `Angle`: in degrees" in markdown(said)


def test_line_comments_code_and_tags_within_a_line() -> None:
    assert clean_comment("// one\n//  two\n") == "one\n two"
    said = parse_comment("Sets the owner. @param NewOwner the new one @return nothing")
    assert said.summary == "Sets the owner." and said.parameter("NewOwner") == "the new one" and said.returns == "nothing"
    said = parse_comment("Use:\n@code\nF(); // @param no tag\n@endcode\nThen wait.")
    assert [b.kind for b in said.blocks] == ["text", "code", "text"] and not said.parameters
    assert html_pieces(parse_comment("a < b & `c`"))[0] == ("text", ["a &lt; b &amp; <code>c</code>"])


def test_docstrings_survive_what_comments_hold() -> None:
    for text in ('ends in "quotes"', 'has """ three', "back\\slash", "tab\tand\x07bell", "über"):
        lines = docstring([text], "")
        assert isinstance(ast.literal_eval("\n".join(lines)), str)
    assert docstring(["", ""], "") == []


def test_units_and_ranges() -> None:
    assert units_of(variable("X", FLOAT, Units="cm")) == "cm" and range_of(variable("X", FLOAT, ClampMin="0", ClampMax="1")) == "0 to 1"
    assert documentation({"editor": {"meta": {"ToolTip": "Written.", "Comment": "/** Other. */"}}}).summary == "Written."

# Layout and oddities --------------------------------------------------------------------------------------------------------


def test_modules_and_files(tmp_path: Path) -> None:
    emit(tmp_path, reflected_class("UA", header="Public/A.h"), reflected_class("UB", header="Private/a.h"), struct("FC", header="Public/Sub/C.h"))
    assert {p.name for p in (tmp_path / "Game").iterdir()} == {"__init__.pyi", "facts.json", "_A.pyi", "_a_2.pyi", "_C.pyi"} or \
        {p.name for p in (tmp_path / "Game").iterdir()} == {"__init__.pyi", "facts.json", "_a.pyi", "_A_2.pyi", "_C.pyi"}
    assert "UA as UA" in (tmp_path / "Game" / "__init__.pyi").read_text()


def test_members_hide_no_types(tmp_path: Path) -> None:
    text = stub(tmp_path, enum("EMode", "One"), reflected_class("UA", properties=[
        variable("Path", node("soft_object", "UObject")), variable("Property", BOOL), variable("EMode", node("enum", "EMode")), variable("Future", INT), variable("AActor", ACTOR)]))
    assert "Path: _Property[ValuePath[str, str | UObject | _Future[str] | _Future[UObject] | None]," in text and "_EMode = EMode" in text and "AActor as _AActor" in text


def test_names_that_python_reserves(tmp_path: Path) -> None:
    text = stub(tmp_path, reflected_class("UA", functions=[function("None", parameter("from", INT), parameter("self", INT)), function("get")],
                                          properties=[variable("My Variable", BOOL), variable("async_", BOOL)]))
    assert "def None_(self, from_: int | Future[int], self_: int | Future[int]) -> None" in text and "def get_(self)" in text
    assert "    My_Variable: BoolProperty" in text and "    async___: BoolProperty" in text
    facts = json.loads((tmp_path / "Game" / "facts.json").read_text())
    assert facts["classes"]["UA"]["names"] == {"My_Variable": "My Variable"}


def test_types_of_modules_that_were_not_dumped(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = stub(tmp_path, reflected_class("AThing", "ACharacter"), reflected_class("UA", "UUnknown", functions=[
        function("F", parameter("A", node("object", "UNiagara")), parameter("S", node("struct", "FGameplayTag")), parameter("E", node("enum", "EOther")), returns=node("interface", "IOther"))]))
    assert "class AThing(AThing_members, AActor)" in text and "class UA(UA_members, UObject)" in text
    assert "def F(self, A: UObject | Future[UObject], S: Any, E: int | str | Future[int]) -> UObject" in text
    report = json.loads((tmp_path / "report.json").read_text())
    assert set(report["unknown"]) == {"ACharacter", "UUnknown", "UNiagara", "FGameplayTag", "EOther", "IOther"}
    assert report["unknown"]["UNiagara"] == ["UA"]
    assert "6 types are in no schema" in capsys.readouterr().err


def test_interfaces_inherit_beside_classes(tmp_path: Path) -> None:
    interface = reflected_class("UFoo", "UInterface", flags=["Interface"], functions=[function("Hear")])
    text = stub(tmp_path, interface, reflected_class("UBar", "UFoo", flags=["Interface"]), reflected_class("UA", interfaces=["IFoo", "IBar"]),
                reflected_class("AThing", "AActor", interfaces=["IFoo"]), reflected_class("AChild", "AThing", interfaces=["IFoo"]))
    assert "class IFoo(IFoo_members, UObject)" in text and "class IBar(IBar_members, IFoo)" in text and "class UFoo(UInterface)" in text
    assert "class UA(UA_members, IBar)" in text  # which is an IFoo, too
    assert "class AThing(AThing_members, AActor, IFoo)" in text and "class AChild(AChild_members, AThing)" in text


def test_members_that_hide_others_of_another_type_are_allowed_only_where_they_are(tmp_path: Path) -> None:
    emit(tmp_path, reflected_class("UA", functions=[function("F", returns=INT)], header="Public/A.h"),
         reflected_class("UB", "UA", functions=[function("F", returns=NAME)], header="Public/B.h"), reflected_class("UC", "UA", functions=[function("F", returns=INT)], header="Public/C.h"))
    assert [("reportIncompatibleMethodOverride" in (tmp_path / "Game" / f"_{name}.pyi").read_text()) for name in "ABC"] == [False, True, False]


def test_structs(tmp_path: Path) -> None:
    text = stub(tmp_path, struct("FBase", variable("X", FLOAT)), struct("FOdd", variable("class", INT), variable("A B", ACTOR), super_="FBase"), struct("FInts", variable("A", INT), variable("B", FLOAT)))
    assert "def __init__(self, X: float = ..., class_: int = ..., A_B: AActor | None = ...) -> None" in text and "class FOdd(FBase)" in text
    assert 'FOdd_dict = TypedDict("FOdd_dict", {"X": "float | Future[float]", "class": "int | Future[int]", "A B": "AActor | Future[AActor] | None"}, total=False)' in text
    assert "class FBase_members" in text and "class FOdd_members(FBase_members)" in text and "class FInts_members" not in text
    assert "FInts_in: TypeAlias = FInts | FInts_dict | Future[FInts] | Numbers" in text
    facts = json.loads((tmp_path / "Game" / "facts.json").read_text())["structs"]["FOdd"]
    assert facts == {"super": "FBase", "fields": ["X", "class", "A B"], "names": {"A_B": "A B"}}


def test_enums(tmp_path: Path) -> None:
    text = stub(tmp_path, enum("EMode", "None", "Fast", "name"))
    assert "    None_ = 0\n    Fast = 1\n    name_ = 2" in text
    assert json.loads((tmp_path / "Game" / "facts.json").read_text())["enums"]["EMode"]["entries"] == [["None", 0], ["Fast", 1], ["name", 2]]


def test_delegates_of_one_name_in_two_classes(tmp_path: Path) -> None:
    made = [{"name": "FDone", "reflected_name": "Done__DelegateSignature", "path": f"/Script/Game.{owner}:Done", "module": "Game", "owner": owner, "kind": "single",
             **function("Done", parameter("Count", INT)), "editor": {"meta": {"ModuleRelativePath": "Public/Things.h"}}} for owner in ("UA", "UB")]
    for entity in made:
        entity["name"] = "FDone"
    text = stub(tmp_path, *made, reflected_class("UA", properties=[variable("OnDone", node("delegate", "FDone", owner="UA"))]), reflected_class("UB"))
    assert "UA_FDone: TypeAlias = FScriptDelegate" in text and "UB_FDone: TypeAlias = FScriptDelegate" in text and "Delegate: FDone(Count: int)" in text
    assert json.loads((tmp_path / "Game" / "facts.json").read_text())["delegates"] == {"UA_FDone": "single", "UB_FDone": "single"}


def test_deprecation(tmp_path: Path) -> None:
    old = {**function("F"), "source": {"deprecated": '5.2, "Call \\"G\\"."'}}
    text = stub(tmp_path, reflected_class("UA", functions=[old, function("H", DeprecationMessage="Gone.", DeprecatedFunction="")]))
    assert '@deprecated("Call \\\\\\"G\\\\\\". (since 5.2)")' in text and '@deprecated("Gone.")' in text


def test_defaults_and_order_of_parameters(tmp_path: Path) -> None:
    text = stub(tmp_path, reflected_class("UA", functions=[
        function("F", parameter("A", INT), parameter("B", BOOL), parameter("C", node("struct", "FV")), CPP_Default_B="true", CPP_Default_C="()"),
        function("G", parameter("A", INT), parameter("B", INT), CPP_Default_A="1")]), struct("FV", variable("X", FLOAT)))
    assert "def F(self, A: int | Future[int], B: bool | Future[bool] = True, C: FV_in = ...) -> None" in text
    assert "def G(self, A: int | Future[int] = 1, *, B: int | Future[int]) -> None" in text  # by keyword only: Python wants defaults last


def test_functions_that_cannot_be_called(tmp_path: Path) -> None:
    text = stub(tmp_path, reflected_class("UA", functions=[function("F", CustomThunk="true")]))
    assert "def F(self) -> NoReturn" in text and "raises NotCallable" in text


def test_the_class_that_is_asked_for_is_the_class_of_the_result(tmp_path: Path) -> None:
    text = stub(tmp_path, reflected_class("UA", functions=[function("Get", parameter("Class", node("class", "AActor")), returns=ACTOR, DeterminesOutputType="Class")]))
    assert "def Get(self, Class: type[_T_AActor]) -> _T_AActor:" in text and "def Get(self, Class: UClass | str | Future[UClass]) -> AActor: ..." in text


def test_docstrings_tell_parameters_units_defaults_and_the_name_in_unreal(tmp_path: Path) -> None:
    text = stub(tmp_path, reflected_class("UA", functions=[function(
        "Open", parameter("Angle", FLOAT, meta={"Units": "deg", "ClampMin": "0", "ClampMax": "180"}), parameter("At", node("struct", "FV")),
        Comment="/** Opens it.\n * @param Angle how far\n * @return nothing */", CPP_Default_At="()")], properties=[
        variable("Speed", FLOAT, ToolTip="How fast.", Units="cm/s")]), struct("FV", variable("X", FLOAT)))
    assert '        """Opens it.\n\n        Args:\n            Angle: how far [deg] (0 to 180)\n            At: Default FV().\n\n        Returns:\n            nothing\n\n        Unreal: UA.Open\n' in text
    assert '    """How fast.\n\n    unit cm/s\n\n    Unreal: UA.Speed (float)\n    """' in text


def test_no_file_is_too_large_and_nothing_is_lost(tmp_path: Path) -> None:
    functions = [function(f"Function{i:04}", parameter("Value", INT), returns=INT, ToolTip="What it does. " * 40) for i in range(1500)]
    emit(tmp_path, reflected_class("UHuge", functions=functions), reflected_class("UChild", "UHuge"))
    sizes = {p.name: p.stat().st_size for p in (tmp_path / "Game").glob("*.pyi")}
    assert max(sizes.values()) < 500_000 and len(sizes) > 4, sizes
    text = "".join(p.read_text() for p in sorted((tmp_path / "Game").glob("*.pyi")))
    assert all(text.count(f"def Function{i:04}(") == 3 for i in range(1500))  # itself, async_, send_
    assert "from ._Things import" in (tmp_path / "Game" / "__init__.pyi").read_text()


def test_output_is_the_same_each_time_and_on_any_number_of_cores(tmp_path: Path) -> None:
    entities = [reflected_class(f"U{i}", header=f"Public/H{i}.h", properties=[variable("Next", node("object", f"U{(i + 1) % 40}"))]) for i in range(40)]
    one, two = emit(tmp_path / "one", *entities, jobs=1), emit(tmp_path / "two", *reversed(entities), jobs=2)
    files = sorted(p.relative_to(one) for p in one.rglob("*") if p.is_file())
    assert files == sorted(p.relative_to(two) for p in two.rglob("*") if p.is_file())
    assert all((one / f).read_bytes() == (two / f).read_bytes() for f in files)


def test_what_is_gone_from_the_schema_is_gone_from_the_stubs(tmp_path: Path) -> None:
    emit(tmp_path, reflected_class("UOld", header="Public/Old.h"), reflected_class("UNew"))
    assert (tmp_path / "Game" / "_Old.pyi").is_file()
    emit(tmp_path, reflected_class("UNew"))
    assert not (tmp_path / "Game" / "_Old.pyi").exists() and (tmp_path / "Game" / "_Things.pyi").is_file()


def test_the_editor_tier_alone_gives_the_same_promises(tmp_path: Path, module_schemas: dict[str, Path]) -> None:
    """A live dump has no source tier: same names, types and defaults; only what just the text of a header tells is absent."""
    full = [json.loads(module_schemas[name].read_text()) for name in ("CoreUObject", "Engine")]
    checked_in = [json.loads((ROOT / "generated" / "schema" / f"{name}.schema.json").read_text()) for name in ("CoreUObject", "Engine")]
    python_stubs.emit(SchemaSet.of(full), tmp_path / "full")
    python_stubs.emit(SchemaSet.of(checked_in), tmp_path / "live")
    for path in (tmp_path / "full").rglob("*.pyi"):
        other = (tmp_path / "live" / path.relative_to(tmp_path / "full")).read_text()
        assert normal(other) == normal(path.read_text()), path
    assert (tmp_path / "full/Engine/facts.json").read_bytes() == (tmp_path / "live/Engine/facts.json").read_bytes()


def normal(text: str) -> list[str]:
    """The declarations of a stub, sorted, without docstrings: order within a header needs the lines of the source tier."""
    tree = ast.parse(text)
    for entity in ast.walk(tree):
        if isinstance(entity, (ast.Module, ast.ClassDef, ast.FunctionDef)):
            entity.body = [s for s in entity.body if not (isinstance(s, ast.Expr) and isinstance(s.value, ast.Constant))] or [ast.Pass()]
    return sorted(ast.unparse(statement) for statement in tree.body)
