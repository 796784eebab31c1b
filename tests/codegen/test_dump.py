# SPDX-License-Identifier: MIT
"""What the header tool writes for well-formed headers: the sample module against its golden file, and each fact by name."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from header_tool_runs import FIXTURES, ROOT, Dump, Result, compare_with_golden, run_tool

SAMPLE = FIXTURES / "Sample"
GOLDEN = FIXTURES / "Sample.schema.json"


@pytest.fixture(scope="module")
def sample(tool: Path, tmp_path_factory: pytest.TempPathFactory, validator: jsonschema.Draft202012Validator) -> Result:
    result = run_tool(tool, tmp_path_factory.mktemp("sample"), ["--strict", "--module", str(SAMPLE)])
    assert result.code == 0, result.errors
    validator.validate(result.schema)
    return result


def flags(entity: dict[str, Any]) -> set[str]:
    assert entity["flags"] == sorted(entity["flags"])
    return set(entity["flags"])


def meta(entity: dict[str, Any]) -> dict[str, str]:
    return entity["editor"]["meta"]


def test_golden(sample: Result) -> None:
    schema = json.loads(json.dumps(sample.schema))
    schema["modules"][0]["source"]["path"] = "Sample"
    text = json.dumps(schema, indent=2, sort_keys=True, ensure_ascii=False) + "\n"
    compare_with_golden(text, GOLDEN)


def test_module_and_headers(sample: Result) -> None:
    assert sample.schema is not None
    (module,) = sample.schema["modules"]
    assert module["name"] == "Sample" and module["source"]["build_cs"] == "Sample.Build.cs"
    assert [(h["path"], h["include"], h["generated"]) for h in module["source"]["headers"]] == [
        ("Private/Hidden.h", "Hidden.h", "Hidden.generated.h"),
        ("Public/SampleActor.h", "SampleActor.h", "SampleActor.generated.h"),
        ("Public/SampleTypes.h", "SampleTypes.h", "SampleTypes.generated.h"),
        ("Public/Things/Empty.h", "Things/Empty.h", "Empty.generated.h"),
    ]


def test_every_written_type_is_confirmed_by_the_ast(sample: Result) -> None:
    assert sample.report is not None
    ast = sample.report["ast"]
    assert ast["declarations"] > 80 and ast["missing"] == 0
    assert ast["confirmed"] == ast["declarations"]


def test_report_names_what_is_not_declared(sample: Result) -> None:
    lines = (SAMPLE / "Public/SampleActor.h").read_text().splitlines()
    never = next(i for i, line in enumerate(lines, 1) if "Never" in line)
    mesh = next(i for i, line in enumerate(lines, 1) if "VisibleAnywhere" in line)
    assert ("inactive-region", never) in sample.rules()
    assert ("property-semicolon", mesh) in sample.rules()


def test_classes(sample: Result) -> None:
    actor = sample.entity("classes", "ASampleActor")
    assert (actor["reflected_name"], actor["path"], actor["super"]) == ("SampleActor", "/Script/Sample.SampleActor", "AActor")
    assert actor["interfaces"] == ["ISampleInterface"]
    assert meta(actor) == {
        "BlueprintSpawnableComponent": "",
        "BlueprintType": "true",
        "ClassGroupNames": "Custom Sample",
        "Comment": "// An actor\n// in two lines\n",
        "IncludePath": "SampleActor.h",
        "IsBlueprintBase": "true",
        "ModuleRelativePath": "Public/SampleActor.h",
        "ObjectInitializerConstructorDeclared": "",
        "ShortToolTip": "Short",
        "ToolTip": "An actor\nin two lines",
    }
    source = actor["source"]
    assert [b["text"] for b in source["bases"]] == ["public AActor", "public ISampleInterface", "public FNotReflected<int32>"]
    assert [c["kind"] for c in source["constructors"]] == ["object_initializer", "vtable_helper", "other"]
    assert source["destructor"] and source["api"] == "SAMPLE_API"
    assert {"ServerDo_Validate", "MulticastDo_Implementation", "Ask_Implementation", "execGeneric", "Pure", "Move"} <= set(source["declares"])
    assert "ServerDo_Implementation" not in source["declares"]
    hidden = sample.entity("classes", "UHiddenThing")
    assert flags(hidden) == {"Transient"} and meta(hidden)["IsBlueprintBase"] == "false"
    assert hidden["source"]["constructors"][0] | {"line": 0} == {"kind": "default", "access": "public", "deleted": False, "defaulted": True, "line": 0}


def test_inheritance_between_classes(sample: Result) -> None:
    part, child = sample.entity("classes", "USamplePart"), sample.entity("classes", "USampleSubPart")
    assert flags(part) == {"Config", "DefaultConfig", "DefaultToInstanced", "EditInlineNew"}
    assert flags(child) == flags(part) and child["source"]["final"]
    assert (part["within"], child["within"]) == ("ASampleActor", "ASampleActor")
    assert (part["config"], child["config"]) == ("Game", "Game")
    assert meta(part)["HideCategories"] == "Physics Big Things"
    assert meta(child)["HideCategories"] == "Big Things Extra"
    assert part["source"]["generated_body"]["macro"] == "GENERATED_UCLASS_BODY" and part["source"]["generated_body"]["access"] == "public"


def test_interfaces(sample: Result) -> None:
    interface = sample.entity("classes", "USampleInterface")
    assert flags(interface) == {"Abstract", "Interface", "MinimalAPI"} and interface["super"] == "UInterface"
    assert interface["source"]["interface"]["name"] == "ISampleInterface"
    assert interface["source"]["interface"]["api"] == "SAMPLE_API"
    assert [f["name"] for f in interface["functions"]] == ["CanDo", "Plain"]
    can_do = sample.function("USampleInterface", "CanDo")
    assert flags(can_do) == {"BlueprintCallable", "BlueprintEvent", "BlueprintPure", "Const", "Event", "Native", "Public"}
    assert flags(sample.function("USampleInterface", "Plain")) == {"Native", "Public"}


FUNCTION_FLAGS = {
    "Move": "BlueprintCallable Final HasOutParms HasDefaults Native Public",
    "Find": "BlueprintCallable BlueprintPure Final Native Public Static",
    "GetNames": "BlueprintCallable BlueprintPure Const Final HasOutParms Native Public",
    "Impure": "BlueprintCallable Const Final Native Public",
    "ServerDo": "Event Final HasDefaults Native Net NetReliable NetServer NetValidate Public",
    "MulticastDo": "Event Final Native Net NetMulticast Public",
    "ClientDo": "Event Native Net NetClient NetReliable Public",
    "Happened": "BlueprintEvent Event HasOutParms Public",
    "Ask": "BlueprintEvent Event HasDefaults HasOutParms Native Public",
    "Console": "BlueprintCosmetic Exec Final Native Public",
    "Button": "BlueprintAuthorityOnly Final Native Public",
    "Generic": "BlueprintCallable Final HasOutParms Native Public Static",
    "GetGuarded": "BlueprintCallable BlueprintPure Const Final Native Public",
    "SetGuarded": "BlueprintCallable Final Native Public",
    "EditorOnlyCall": "EditorOnly Final Native Public",
}


@pytest.mark.parametrize("name", FUNCTION_FLAGS)
def test_function_flags(sample: Result, name: str) -> None:
    assert flags(sample.function("ASampleActor", name)) == set(FUNCTION_FLAGS[name].split())


PARAMETER_FLAGS = [
    ("Move", "Where", "ConstParm OutParm Parm ReferenceParm"),
    ("Move", "Speed", "Parm"),
    ("Find", "WorldContextObject", "ConstParm Parm"),
    ("Find", "Name", "Parm"),
    ("Find", "Class", "Parm UObjectWrapper"),
    ("GetNames", "OutText", "OutParm Parm"),
    ("GetNames", "InOut", "OutParm Parm ReferenceParm"),
    ("ServerDo", "Where", "ConstParm Parm ReferenceParm"),
    ("ServerDo", "What", "Parm"),
]


@pytest.mark.parametrize(("function", "parameter", "expected"), PARAMETER_FLAGS)
def test_parameter_flags(sample: Result, function: str, parameter: str, expected: str) -> None:
    (found,) = [p for p in sample.function("ASampleActor", function)["parameters"] if p["name"] == parameter]
    assert flags(found) == {*expected.split(), "NativeAccessSpecifierPublic"}


def test_functions_in_detail(sample: Result) -> None:
    move = sample.function("ASampleActor", "Move")
    assert meta(move)["ToolTip"] == "Moves it.\n\n@param Where   the target,\n               in centimetres\n@return whether it arrived"
    assert meta(move)["DisplayName"] == 'Move "it"' and meta(move)["Keywords"] == "go walk"
    assert meta(move)["AdvancedDisplay"] == "Speed, Mode" and meta(move)["Category"] == "Sample|Motion"
    assert (meta(move)["CPP_Default_Speed"], meta(move)["CPP_Default_Mode"]) == ("100.000000", "Walk")
    assert meta(move["returns"]) == {"DisplayName": "Arrived"}
    names = sample.function("ASampleActor", "GetNames")
    assert set(names["returns"]["flags"]) >= {"ConstParm", "OutParm", "ReturnParm", "ReferenceParm"}
    assert names["returns"]["source"]["type_text"] == "const TArray<FName>&"
    assert [p["source"]["type_text"] for p in names["parameters"]] == ["FString&", "TArray<int32>&", "int32"]
    find = sample.function("ASampleActor", "Find")
    assert find["returns"]["type"] == {"kind": "object", "name": "ASampleActor", "cpp": "ASampleActor*"}
    assert meta(find["parameters"][0]) == {"NativeConst": ""} and find["parameters"][2]["editor"]["default"] == "None"
    server = sample.function("ASampleActor", "ServerDo")["source"]
    assert (server["implementation"], server["implementation_declared"]) == ("ServerDo_Implementation", False)
    assert (server["validation"], server["validation_declared"]) == ("ServerDo_Validate", True)
    assert sample.function("ASampleActor", "Generic")["source"]["custom_thunk"]
    assert sample.function("ASampleActor", "Wait")["parameters"][0]["type"]["name"] == "FLatentActionInfo"


PROPERTY_FLAGS = [
    ("OnMoved", "BlueprintAssignable"),
    ("Health", "Net RepNotify SaveGame"),
    ("Weak", "Net Transient UObjectWrapper"),
    ("Guarded", "BlueprintVisible"),
    ("Parts", "ContainsInstancedReference Edit ExportObject PersistentInstance TObjectPtr UObjectWrapper"),
    ("Spawned", "DisableEditOnInstance Edit ExposeOnSpawn UObjectWrapper"),
    ("Interface", "AdvancedDisplay DisableEditOnTemplate Edit UObjectWrapper"),
    ("Colour", "BlueprintVisible Edit Interp"),
    ("EditorNote", "Edit EditorOnly"),
]


@pytest.mark.parametrize(("name", "expected"), PROPERTY_FLAGS)
def test_property_flags(sample: Result, name: str, expected: str) -> None:
    assert flags(sample.property("classes", "ASampleActor", name)) == {*expected.split(), "NativeAccessSpecifierPublic"}


def test_access_of_properties(sample: Result) -> None:
    mesh = sample.property("classes", "ASampleActor", "Mesh")
    assert flags(mesh) == {
        "BlueprintReadOnly", "BlueprintVisible", "Edit", "EditConst", "ExportObject", "InstancedReference", "NativeAccessSpecifierProtected", "Protected",
    }
    assert meta(mesh)["EditInline"] == "true" and mesh["source"]["default"] == "nullptr"
    assert "NativeAccessSpecifierPrivate" in flags(sample.property("classes", "ASampleActor", "Soft"))
    assert sample.property("classes", "ASampleActor", "Lazy")["source"]["mutable"]


def test_accessors(sample: Result) -> None:
    flag = sample.property("classes", "ASampleActor", "bFlag")
    assert flag["native_getter"] and flag["native_setter"]
    assert (flag["source"]["getter"], flag["source"]["setter"]) == ("GetFlag", "PutFlag")
    health = sample.property("classes", "ASampleActor", "Health")
    assert health["rep_notify"] == "OnRep_Health" and "native_getter" not in health
    guarded = sample.property("classes", "ASampleActor", "Guarded")
    assert (meta(guarded)["BlueprintGetter"], meta(guarded)["BlueprintSetter"]) == ("GetGuarded", "SetGuarded")


STRUCT_TYPES = [
    ("bPlain", {"kind": "bool", "cpp": "bool"}),
    ("bBit", {"kind": "bool", "cpp": "bool", "bitfield": True}),
    ("bOther", {"kind": "bool", "cpp": "bool", "bitfield": True}),
    ("Byte", {"kind": "uint8", "cpp": "uint8"}),
    ("Old", {"kind": "int32", "cpp": "int32"}),
    ("X", {"kind": "double", "cpp": "double"}),
    ("Y", {"kind": "double", "cpp": "double"}),
    ("Z", {"kind": "double", "cpp": "double"}),
    ("Names", {"kind": "array", "cpp": "TArray<FName>", "inner": {"kind": "name", "cpp": "FName"}}),
    ("Numbers", {"kind": "set", "cpp": "TSet<int32>", "inner": {"kind": "int32", "cpp": "int32"}}),
    ("Maybe", {"kind": "optional", "cpp": "TOptional<FSampleBase>", "inner": {"kind": "struct", "name": "FSampleBase", "cpp": "FSampleBase"}}),
    ("Old2", {"kind": "byte_enum", "name": "ESampleOld", "cpp": "TEnumAsByte<ESampleOld::Type>"}),
    ("Plain", {"kind": "byte_enum", "name": "ESamplePlain", "cpp": "TEnumAsByte<ESamplePlain>"}),
    ("Motion", {"kind": "enum", "name": "ESampleMotion", "cpp": "ESampleMotion", "underlying": "uint8"}),
    ("Path", {"kind": "field_path", "name": "FProperty", "cpp": "TFieldPath<FProperty>"}),
    ("Instanced", {"kind": "struct", "name": "FInstancedStruct", "cpp": "FInstancedStruct"}),
    (
        "Textures",
        {
            "kind": "map",
            "cpp": "TMap<FName, TSoftObjectPtr<UTexture2D>>",
            "key": {"kind": "name", "cpp": "FName"},
            "value": {"kind": "soft_object", "name": "UTexture2D", "cpp": "TSoftObjectPtr<UTexture2D>"},
        },
    ),
]


@pytest.mark.parametrize(("name", "expected"), STRUCT_TYPES)
def test_types(sample: Result, name: str, expected: dict[str, Any]) -> None:
    assert sample.property("structs", "FSampleStruct", name)["type"] == expected


def test_structs(sample: Result) -> None:
    struct, base, mirror = (sample.entity("structs", name) for name in ("FSampleStruct", "FSampleBase", "FSampleMirror"))
    assert struct["super"] == "FSampleBase" and flags(struct) == {"Atomic", "RequiredAPI"}
    assert base["source"]["has_defaults"] and meta(base["properties"][0])["ClampMax"] == "10"
    assert flags(mirror) == {"Atomic", "Immutable", "NoExport"} and mirror["source"]["generated_body"] is None
    properties = {p["name"]: p for p in struct["properties"]}
    assert [properties[n]["array_dim"] for n in ("Four", "Five", "PerMode", "Byte")] == [4, 5, 9, 1]
    assert meta(properties["PerMode"])["ArraySizeEnum"] == "/Script/Sample.ESamplePlain"
    assert properties["Stale"]["source"]["cpp_name"] == "Stale_DEPRECATED" and "Deprecated" in flags(properties["Stale"])
    assert properties["Text"]["source"]["default"] == 'TEXT("a, \\"b\\"; // no comment")'
    assert properties["Y"]["source"]["default"] == "2.0" and "default" not in properties["Z"]["source"]
    assert "NotReflected" not in properties


def test_enums(sample: Result) -> None:
    motion = sample.entity("enums", "ESampleMotion")
    assert [(e["name"], e["value"]) for e in motion["entries"]] == [
        ("ESampleMotion::None", 0), ("ESampleMotion::Walk", 4), ("ESampleMotion::Drive", 5), ("ESampleMotion::Sum", 5), ("ESampleMotion::Negative", 128),
    ]
    assert meta(motion["entries"][0]) == {"Comment": "/** Not at all */", "DisplayName": "Standing still", "Name": "ESampleMotion::None", "ToolTip": "Not at all"}
    assert meta(motion["entries"][2])["ToolTip"] == "On wheels,\nor on rails"
    plain = sample.entity("enums", "ESamplePlain")
    assert (plain["form"], plain["cpp_type"]) == ("regular", "ESamplePlain")
    assert [(e["name"], e["value"]) for e in plain["entries"]] == [("Sample_A", 0), ("Sample_B", 7), ("Sample_C", 8), ("Sample_MAX", 9)]
    old = sample.entity("enums", "ESampleOld")
    assert (old["form"], old["cpp_type"]) == ("namespaced", "ESampleOld::Type")
    assert [(e["name"], e["value"]) for e in old["entries"]] == [("ESampleOld::First", -3), ("ESampleOld::Second", -2)]
    big = sample.entity("enums", "ESampleFlags")
    assert big["flags"] == ["Flags"] and big["entries"][1]["value"] == 1 << 40


def test_delegates(sample: Result) -> None:
    moved = sample.entity("delegates", "FSampleMoved")
    assert moved["reflected_name"] == "SampleMoved__DelegateSignature" and moved["path"] == "/Script/Sample.SampleMoved__DelegateSignature"
    assert moved["kind"] == "multicast" and flags(moved) == {"Delegate", "HasDefaults", "HasOutParms", "MulticastDelegate", "Public"}
    assert meta(moved)["ToolTip"] == "Fires when something moved."
    ask = sample.entity("delegates", "FSampleAsk")
    assert ask["kind"] == "single" and ask["returns"]["type"]["kind"] == "bool"
    assert [p["name"] for p in ask["parameters"]] == ["Question", "OutAnswer"]
    assert len(sample.entity("delegates", "FSampleNine")["parameters"]) == 9
    inner = sample.entity("delegates", "FInner")
    assert inner["owner"] == "ASampleActor" and inner["path"] == "/Script/Sample.SampleActor:Inner__DelegateSignature"
    assert sample.property("classes", "ASampleActor", "OnInner")["type"] == {
        "kind": "multicast_delegate", "name": "FInner", "owner": "ASampleActor", "cpp": "FInner",
    }
    sparse = sample.entity("delegates", "FSampleSparse")
    assert sparse["kind"] == "sparse" and sparse["source"]["sparse"] == {"owner": "ASampleActor", "property": "OnSparse"}
    assert sample.property("classes", "ASampleActor", "OnSparse")["type"]["kind"] == "sparse_delegate"


def test_without_editor(tool: Path, tmp_path: Path) -> None:
    result = run_tool(tool, tmp_path, ["--strict", "--module", str(SAMPLE), "--define", "WITH_EDITOR=0", "--define", "WITH_EDITORONLY_DATA=0"])
    assert result.code == 0, result.errors
    actor = result.entity("classes", "ASampleActor")
    assert "EditorNote" not in {p["name"] for p in actor["properties"]}
    assert "EditorOnlyCall" not in {f["name"] for f in actor["functions"]}
    assert "NotReflectedHere" in actor["source"]["declares"]


def test_output_is_deterministic(tool: Path, tmp_path: Path) -> None:
    texts = set()
    for jobs in (1, 2, 8, 8):
        run_tool(tool, tmp_path, ["--module", str(SAMPLE), "--jobs", str(jobs)])
        texts.add(((tmp_path / "out.schema.json").read_text(), (tmp_path / "out.report.json").read_text()))
    assert len(texts) == 1


def test_imports_give_types_their_meaning(tool: Path, tmp_path: Path, dump: Dump) -> None:
    run_tool(tool, tmp_path, ["--module", str(SAMPLE)])
    sample_schema = tmp_path / "Sample.schema.json"
    (tmp_path / "out.schema.json").rename(sample_schema)
    text = """#include "Test.generated.h"
UCLASS() class UTestPart : public USamplePart { GENERATED_BODY()
public:
    UPROPERTY() TObjectPtr<USampleSubPart> Part;
    UPROPERTY() TEnumAsByte<ESampleOld::Type> Old;
    UPROPERTY(BlueprintAssignable) FSampleMoved Moved;
    UPROPERTY() TScriptInterface<ISampleInterface> Interface;
    UPROPERTY() ESampleFlags Mask;
    UFUNCTION() void F(FSampleBase In);
};
UCLASS() class ATestActor : public ASampleActor, public ISampleInterface { GENERATED_BODY() };
"""
    result = dump({"Test.h": text}, "--import", str(sample_schema))
    part = result.entity("classes", "UTestPart")
    assert flags(part) >= {"DefaultToInstanced", "EditInlineNew", "Config", "HasInstancedReference"} and part["config"] == "Game"
    types = {p["name"]: p for p in part["properties"]}
    assert "InstancedReference" in flags(types["Part"]) and types["Mask"]["type"]["underlying"] == "uint64"
    assert types["Moved"]["type"]["kind"] == "multicast_delegate" and types["Old"]["type"]["cpp"] == "TEnumAsByte<ESampleOld::Type>"
    assert "HasDefaults" in flags(result.function("UTestPart", "F"))
    assert result.entity("classes", "ATestActor")["interfaces"] == ["ISampleInterface"]
    assert result.report is not None and not [e for e in result.report["entries"] if e["rule"] == "assumed-type"]
    assert result.schema is not None and [c["name"] for c in result.schema["classes"]] == ["ATestActor", "UTestPart"], "imports are not written again"


def test_depfile(tool: Path, tmp_path: Path) -> None:
    run_tool(tool, tmp_path, ["--module", str(SAMPLE), "--depfile", str(tmp_path / "d")])
    text = (tmp_path / "d").read_text()
    assert text.startswith(str(tmp_path / "out.schema.json").replace(" ", "\\ ") + ":")
    assert "SampleActor.h" in text and "Hidden.h" in text


def test_several_modules_below_one_folder(tool: Path, tmp_path: Path) -> None:
    for name in ("One", "Two", "One/Inner"):
        folder = tmp_path / "p" / name
        folder.mkdir(parents=True)
        short = name.split("/")[-1]
        (folder / f"{short}.Build.cs").write_text("")
        (folder / f"{short}.h").write_text(f'#include "{short}.generated.h"\nUSTRUCT() struct F{short} {{ GENERATED_BODY() }};\n')
    result = run_tool(tool, tmp_path, ["--strict", "--module", str(tmp_path / "p")])
    assert result.schema is not None, result.errors
    assert {s["name"]: s["module"] for s in result.schema["structs"]} == {"FInner": "Inner", "FOne": "One", "FTwo": "Two"}


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "latin-1"])
def test_encodings_and_line_ends(tool: Path, tmp_path: Path, encoding: str) -> None:
    module = tmp_path / "m"
    module.mkdir()
    text = '#include "A.generated.h"\r\n/** größer */\r\nUSTRUCT()\r\nstruct FA\r\n{ GENERATED_BODY()\r\nUPROPERTY() int32 X; };\r\n'
    (module / "A.h").write_bytes(text.encode(encoding))
    result = run_tool(tool, tmp_path, ["--strict", "--module", f"A={module}"])
    assert result.code == 0, result.errors
    struct = result.entity("structs", "FA")
    assert meta(struct)["ToolTip"] == "größer" and struct["source"]["line"] == 4 and struct["properties"][0]["source"]["line"] == 6


DEFAULTS = [
    ("int32", "5", "5"), ("int32", "-1", "-1"), ("int32", "0xFF", "255"), ("int32", "INDEX_NONE", "-1"), ("int32", "MAX_int32", "2147483647"),
    ("int64", "9007199254740993", "9007199254740993"), ("uint8", "255", "255"), ("int32", "1'000", "1000"),
    ("float", "1", "1.000000"), ("float", "1.f", "1.000000"), ("double", "-0.5", "-0.500000"), ("float", "1e3f", "1000.000000"), ("float", ".25f", "0.250000"),
    ("bool", "true", "true"), ("bool", "false", "false"),
    ("const FString&", 'TEXT("a, b")', "a, b"), ("FString", '"q\\"q"', 'q"q'), ("FString", 'FString(TEXT("x"))', "x"), ("FString", "FString()", ""), ("const FString&", '""', ""),
    ("FName", "NAME_None", "None"), ("FName", 'TEXT("n")', "n"), ("FName", "FName()", "None"), ("FName", 'FName(TEXT("n"))', "n"), ("FName", 'FName("n")', "n"),
    ("FText", "FText::GetEmpty()", ""), ("FText", "FText()", ""), ("FText", 'INVTEXT("t")', 'INVTEXT("t")'),
    ("AActor*", "nullptr", "None"), ("AActor*", "NULL", "None"), ("TSubclassOf<AActor>", "TSubclassOf<AActor>()", "None"), ("TSubclassOf<AActor>", "nullptr", "None"),
    ("ECollisionChannel", "ECC_Visibility", "ECC_Visibility"), ("EFoo", "EFoo::Bar", "Bar"), ("TEnumAsByte<EOld::Type>", "EOld::A", "A"), ("EFoo", "EFoo::Type::Bar", "Bar"),
    ("FVector", "FVector(1, 2.5f, -3)", "1.000000,2.500000,-3.000000"), ("FVector", "FVector(1.f)", "1.000000,1.000000,1.000000"), ("FVector", "FVector::ZeroVector", ""),
    ("FVector", "FVector::UpVector", "0.000000,0.000000,1.000000"), ("FVector", "FVector(ForceInit)", ""), ("FVector", "FVector()", ""), ("const FVector&", "FVector::OneVector", "1.000000,1.000000,1.000000"),
    ("FRotator", "FRotator(1,2,3)", "1.000000,2.000000,3.000000"), ("FRotator", "FRotator::ZeroRotator", ""),
    ("FVector2D", "FVector2D(1,2)", "(X=1.000,Y=2.000)"), ("FVector2D", "FVector2D::ZeroVector", ""),
    ("FLinearColor", "FLinearColor(1,0,0)", "(R=1.000000,G=0.000000,B=0.000000,A=1.000000)"), ("FLinearColor", "FLinearColor::White", "(R=1.000000,G=1.000000,B=1.000000,A=1.000000)"),
    ("FColor", "FColor::Red", "(R=255,G=0,B=0,A=255)"), ("FColor", "FColor(1,2,3,4)", "(R=1,G=2,B=3,A=4)"),
    ("FFoo", "FFoo()", "()"), ("FFoo", "FFoo{}", "()"), ("FFoo", "{}", "()"), ("FTransform", "FTransform::Identity", "()"), ("const TArray<int32>&", "TArray<int32>()", "()"),
]


@pytest.mark.parametrize(("type_text", "default", "expected"), DEFAULTS, ids=[f"{t}={d}" for t, d, _ in DEFAULTS])
def test_default_arguments(dump_class: Dump, type_text: str, default: str, expected: str) -> None:
    result = dump_class(f"UFUNCTION() void F({type_text} Value = {default});", "--strict")
    assert result.code == 0, result.errors
    function = result.function("UTest", "F")
    assert function["parameters"][0]["editor"]["default"] == expected
    assert function["parameters"][0]["source"]["default"] == default
    assert meta(function)["CPP_Default_Value"] == expected


@pytest.mark.parametrize(
    "text",
    [
        "SOME_MACRO\nUPROPERTY() int32 X;",
        "ATTRIBUTE_ACCESSORS(UTest, X)\nUPROPERTY() int32 X;",
        "virtual bool F() const PURE_VIRTUAL(UTest::F, return false;)\nUPROPERTY() int32 X;",
        "template <class T, class = void> void F(T A) { if (A < 3) { } }\nUPROPERTY() int32 X;",
        "int32 A[] = {1, 2, 3}; UPROPERTY() int32 X;",
        "TFunction<void(int32, float)> F; UPROPERTY() int32 X;",
        "struct { int32 A; } Anonymous; UPROPERTY() int32 X;",
        "union { float A; int32 B; };\nUPROPERTY() int32 X;",
        "bool operator<(const UTest& Other) const; UPROPERTY() int32 X;",
        "using FSuper = UObject; typedef TArray<int32> FInts; UPROPERTY() int32 X;",
        "int32 Bits : 3; UPROPERTY() int32 X;",
        "UTest(int32 A) : Y{A}, Z(A) { } int32 Y, Z; UPROPERTY() int32 X;",
        "auto F() -> decltype(1 + 2); UPROPERTY() int32 X;",
        "static_assert(sizeof(int) == 4, \"UPROPERTY() int32 Never;\"); UPROPERTY() int32 X;",
        "/* UPROPERTY() int32 Never; */ UPROPERTY() int32 X; // UPROPERTY() int32 NeverAgain;",
        "UPROPERTY(meta=(A=\"UPROPERTY() int32 Never;\")) int32 X;",
        "UPROPERTY() UE_TRANSIENT(int) int32 X;",
        "UPROPERTY()\n// why\nint32\nX\n;",
        "UPROPERTY(EditAnywhere, // comment)\n Category=A) int32 X;",
        "UPROPERTY() class UObject* Y; UPROPERTY() int32 X;",
        "const char* Quote = \"'\"; char C = '\"'; UPROPERTY() int32 X;",
        "int32 Value = 1'000'000; UPROPERTY() int32 X;",
        "FString Raw = TEXT(R\"(a \" ) b)\"); UPROPERTY() int32 X;",
        "UPROPERTY() TArray<int32, FDefaultAllocator> Y; UPROPERTY() int32 X;",
        "DECLARE_EVENT_OneParam(UTest, FEvent, int32) FEvent Event; UPROPERTY() int32 X;",
        "UE_DEPRECATED(5.0, \"no (\") void Old(); UPROPERTY() int32 X;",
        "[[nodiscard]] bool F(); UPROPERTY() int32 X;",
    ],
)
def test_odd_surroundings_lose_nothing(dump_class: Dump, text: str) -> None:
    result = dump_class(text)
    assert result.code == 0, result.errors
    found = result.property("classes", "UTest", "X")
    assert found["type"]["kind"] == "int32" and "NativeAccessSpecifierPublic" in found["flags"]
    assert not {"Never", "NeverAgain"} & {p["name"] for p in result.entity("classes", "UTest")["properties"]}
    assert result.report is not None and not [e for e in result.report["entries"] if e["severity"] != "note"], result.errors


def test_independent_count_agrees(tool: Path) -> None:
    script = Path(__file__).with_name("independent_check.py")
    run = subprocess.run([sys.executable, str(script), "--tool", str(tool), str(SAMPLE), "--verbose"], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "100.000 %" in run.stdout


ENGINE_MODULES = {"Core": [], "CoreUObject": ["Core"], "Engine": ["Core", "CoreUObject"]}


def test_engine_and_plugin_headers_are_strict(tool: Path, tmp_path: Path, validator: jsonschema.Draft202012Validator) -> None:
    """The headers of this repository, in the order of their build."""
    modules = [(name, ROOT / "engine/Source/Runtime" / name) for name in ENGINE_MODULES] + [("SpearServer", ROOT / "server_plugin/Source/SpearServer")]
    imports: list[str] = []
    for name, folder in modules:
        assert folder.is_dir(), folder
        result = run_tool(tool, tmp_path, ["--strict", "--module", f"{name}={folder}", *imports, "--define", "WITH_EDITOR=0", "--define", "WITH_EDITORONLY_DATA=0"])
        assert result.code == 0, result.errors
        validator.validate(result.schema)
        assert result.report is not None and result.report["ast"]["confirmed"] == result.report["ast"]["declarations"], name
        schema = tmp_path / f"{name}.schema.json"
        (tmp_path / "out.schema.json").rename(schema)
        imports += ["--import", str(schema)]


def test_values_of_enums_in_other_headers(dump: Dump, tmp_path: Path, tool: Path) -> None:
    first = '#include "First.generated.h"\nUENUM() enum class EFirst : uint8 { A = 3, B, Count };\nUENUM() namespace EOld { enum Type { X = -2 }; }\nUENUM() enum EPlain { Plain_Z = 9 };\n'
    text = '#include "{}.generated.h"\nUENUM() enum class E{} : uint8 {{ One = (uint8)EFirst::B, Two = (int)EOld::X + 10, Three = Plain_Z }};\nUSTRUCT() struct F{} {{ GENERATED_BODY() UPROPERTY() int32 N[(int)EFirst::Count]; }};\n'
    result = dump({"First.h": first, "Second.h": text.format("Second", "Second", "Second")})
    assert [e["value"] for e in result.entity("enums", "ESecond")["entries"]] == [4, 8, 9]
    assert result.property("structs", "FSecond", "N")["array_dim"] == 5
    assert not [r for r in result.rules() if r[0] in ("enum-value", "unresolved-type")]
    imported = tmp_path / "first.json"
    (tmp_path / "out.schema.json").rename(imported)
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "Third.h").write_text(text.format("Third", "Third", "Third"))
    result = run_tool(tool, tmp_path, ["--module", f"Other={tmp_path}/other", "--import", str(imported)])
    assert [e["value"] for e in result.entity("enums", "EThird")["entries"]] == [4, 8, 9]
    assert result.property("structs", "FThird", "N")["array_dim"] == 5
