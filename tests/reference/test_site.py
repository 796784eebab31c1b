# SPDX-License-Identifier: MIT
"""The files of the reference: complete, linked, escaped, the same from run to run, and nobody else's files are touched."""

from __future__ import annotations

import html
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from emit import reference
from emit.schema import SchemaError, SchemaSet
from pages import PageFacts, broken_links, read_index, read_page, read_site
from schema_maker import SchemaMaker

Write = Callable[..., Path]


@pytest.fixture(scope="module")
def engine_pages(engine_site: Path) -> dict[Path, PageFacts]:
    return read_site(engine_site)


def _bytes(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


# The whole engine -----------------------------------------------------------------------------------------------------------


def test_every_type_and_member_has_its_place(engine_site: Path, engine_schemas: SchemaSet, engine_pages: dict[Path, PageFacts]) -> None:
    missing = []
    for module in engine_schemas.main_modules:
        for entity in module.entities():
            name = "I" + entity["name"][1:] if "Interface" in entity.get("flags", ()) else entity["name"]
            if entity.get("owner"):
                name = f"{entity['owner']}_{name}"
            page = engine_pages.get((engine_site / module.name / f"{name}.html").resolve())
            if page is None:
                missing.append(f"{module.name}/{name}.html")
                continue
            members = [m["name"] for kind in ("functions", "properties") for m in entity.get(kind, ())] + [e["name"].rpartition("::")[2] for e in entity.get("entries", ())]
            missing += [f"{name}#{member}" for member in members if member not in page.ids]
    assert missing == []


def test_no_link_is_broken(engine_pages: dict[Path, PageFacts]) -> None:
    assert len(engine_pages) > 200
    assert broken_links(engine_pages) == []


def test_pages_are_well_formed(engine_pages: dict[Path, PageFacts]) -> None:
    assert {str(path): facts.errors for path, facts in engine_pages.items() if facts.errors} == {}
    assert {str(path): facts.ids for path, facts in engine_pages.items() if len(set(facts.ids)) != len(facts.ids)} == {}
    assert [str(path) for path, facts in engine_pages.items() if not facts.title] == []


def test_pages_load_only_files_of_the_site(engine_site: Path, engine_pages: dict[Path, PageFacts]) -> None:
    assert {load for facts in engine_pages.values() for load in facts.loads if "://" in load} == set()
    for asset in (engine_site / "assets").iterdir():
        text = asset.read_text(encoding="utf-8")
        assert not re.search(r"@import|url\(\s*['\"]?(?:https?:)?//|\bfetch\(|XMLHttpRequest|\bimport\(", text), asset


def test_every_file_says_that_it_is_generated(engine_site: Path) -> None:
    silent = [str(path) for path in engine_site.rglob("*") if path.is_file() and "do not edit" not in "".join(path.read_text(encoding="utf-8").splitlines()[:3]).lower()]
    assert silent == []


def test_the_index_leads_to_every_member(engine_site: Path, engine_schemas: SchemaSet, engine_pages: dict[Path, PageFacts]) -> None:
    entries = read_index(engine_site)
    functions = [entry for entry in entries if entry.kind == "f"]
    properties = [entry for entry in entries if entry.kind == "p"]
    assert len(functions) == sum(len(c["functions"]) for c in engine_schemas.classes.values())
    assert len(properties) == sum(len(e["properties"]) for kind in (engine_schemas.classes, engine_schemas.structs) for e in kind.values())
    wrong = []
    for entry in entries:
        file, _, anchor = entry.target.partition("#")
        page = engine_pages.get((engine_site / file).resolve())
        if page is None or (anchor and anchor not in page.ids):
            wrong.append(entry)
    assert wrong == []
    found = next(entry for entry in functions if (entry.owner, entry.name) == ("AActor", "SetActorScale3D"))
    assert found.target == "Engine/AActor.html#SetActorScale3D"
    assert found.summary == "Set the Actor's world-space scale."


def test_a_function_is_told_in_full(engine_site: Path, engine_schemas: SchemaSet) -> None:
    page = (engine_site / "Engine" / "AActor.html").read_text(encoding="utf-8")
    section = page[page.index('id="K2_SetActorLocation"'):]
    section = section[: section.index("</section>")]
    function = next(f for f in engine_schemas.classes["AActor"]["functions"] if f["name"] == "K2_SetActorLocation")
    assert f"Actor.h:{function['source']['line']}" in section
    assert "Move the Actor to the specified location." in section
    assert '<a href="../CoreUObject/FVector.html">FVector</a>' in section
    assert '<td class="dir out">out' in section and '<a href="FHitResult.html">FHitResult</a>' in section
    assert "the new location to move the Actor to, in centimetres." in section
    assert "async_.K2_SetActorLocation(…) -&gt; Future[AActor_K2_SetActorLocation_Result]" in section
    assert "spear::Future&lt;unreal::AActor_K2_SetActorLocation_Result&gt; async().K2_SetActorLocation(…)" in section


def test_inherited_members_are_linked(engine_pages: dict[Path, PageFacts], engine_site: Path) -> None:
    page = engine_pages[(engine_site / "Engine" / "AStaticMeshActor.html").resolve()]
    assert "AActor.html#SetActorScale3D" in page.links
    assert "AActor.html#RootComponent" in page.links


# Spelling is that of stubs and proxies ------------------------------------------------------------------------------------------


def _section(page: str, anchor: str) -> str:
    start = page.index(f'<section class="member" id="{anchor}">')
    return page[start: page.index("</section>", start)]


def _code(section: str, language: str) -> str:
    match = re.search(rf'<pre class="{language}"[^>]*>(.*?)</pre>', section, re.DOTALL)
    assert match
    return re.sub(r"</?i>", "", match[1]).replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")


@pytest.mark.parametrize("name", ["AActor", "UKismetMathLibrary", "USceneComponent", "UGameplayStatics"])
def test_python_is_spelled_as_in_the_stub(name: str, engine_site: Path, engine_schemas: SchemaSet, source_directory: Path) -> None:
    stubs = source_directory / "generated" / "python" / "spear" / "unreal" / "Engine"
    stub = "".join(path.read_text(encoding="utf-8") for path in stubs.glob("*.pyi") if re.search(rf"^class {name}_members\b", path.read_text(encoding="utf-8"), re.MULTILINE))
    assert stub, f"no stub of {name} below {stubs}"
    page = (engine_site / "Engine" / f"{name}.html").read_text(encoding="utf-8")
    # The stub as a reader sees it: no future in arguments, no alias for structs and enums.
    plain = re.sub(r" \| Future\[[^][]*(?:\[[^][]*(?:\[[^][]*\])?[^][]*\])*[^][]*\]|self, |self|: \.\.\.$", "", stub, flags=re.MULTILINE)
    plain = re.sub(r"\b_T_\w+", "T", re.sub(r"\b_?(\w+)_in\b", r"\1", plain))
    wrong = []
    for function in engine_schemas.classes[name]["functions"]:
        code = " ".join(_code(_section(page, function["name"]), "py").partition("\nasync_")[0].partition("\n#")[0].split()).replace("( ", "(").replace(" )", ")")
        if f"def {code}:" not in re.sub(r"\b_([A-Z]\w+)", r"\1", plain):
            wrong.append(code)
    assert wrong == []


@pytest.mark.parametrize("name", ["AActor", "USceneComponent", "ULightComponent"])
def test_variables_are_spelled_as_in_the_stub(name: str, engine_site: Path, engine_schemas: SchemaSet, source_directory: Path) -> None:
    stubs = source_directory / "generated" / "python" / "spear" / "unreal" / "Engine"
    stub = next(text for path in sorted(stubs.glob("*.pyi")) if f"class {name}_members" in (text := path.read_text(encoding="utf-8")))
    page = (engine_site / "Engine" / f"{name}.html").read_text(encoding="utf-8")
    variables = engine_schemas.classes[name]["properties"]
    assert len(variables) > 5
    for variable in variables:
        spelled = _code(_section(page, variable["name"]), "py").partition(".get()")[0]
        assert re.search(rf"^    {re.escape(spelled)}: ", stub, re.MULTILINE), spelled


@pytest.mark.parametrize("name", ["AActor", "UKismetMathLibrary", "USceneComponent", "UGameplayStatics"])
def test_cpp_is_spelled_as_in_the_proxy(name: str, engine_site: Path, engine_schemas: SchemaSet, source_directory: Path) -> None:
    proxy = (source_directory / "generated" / "cpp" / "spear" / "unreal" / "Engine" / f"{name}.hpp").read_text(encoding="utf-8")
    page = (engine_site / "Engine" / f"{name}.html").read_text(encoding="utf-8")
    wrong = []
    for function in engine_schemas.classes[name]["functions"]:
        head, _, _ = _code(_section(page, function["name"]), "cpp").partition("(")
        result, _, spelled = head.rpartition(" ")
        if f"spear::ResultOf<SpearBase, {result}> {spelled}(" not in proxy:
            wrong.append(head)
    for variable in engine_schemas.classes[name]["properties"]:
        line = _code(_section(page, variable["name"]), "cpp").split("\n")[0]
        kind, _, spelled = line.removesuffix("().get()").rpartition(" ")
        if f"spear::PropertyOf<SpearBase, {kind}> {spelled}() const" not in proxy:
            wrong.append(line)
    assert wrong == []


def test_the_example_of_the_first_page_runs(engine_site: Path, build_directory: Path, tmp_path: Path) -> None:
    program = tmp_path / "example.py"
    program.write_text(html.unescape(_code((engine_site / "index.html").read_text(encoding="utf-8"), "py")))
    path = os.pathsep.join([str(build_directory / "python"), os.environ.get("PYTHONPATH", "")])
    run = subprocess.run([sys.executable, str(program)], env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True)
    assert (run.returncode, run.stdout.strip()) == (0, "FVector(X=0.0, Y=0.0, Z=0.0) False"), run.stderr


# Runs ------------------------------------------------------------------------------------------------------------------------


def _small(maker: SchemaMaker) -> SchemaMaker:
    maker.add_class("UObject", "CoreUObject")
    maker.add_class("AThing", super_class="UObject", functions=(maker.function("Open", comment="Opens it."),), properties=(maker.property("Width", comment="How wide."),))
    maker.add_class("AOther", super_class="AThing")
    return maker


def test_the_same_schema_gives_the_same_bytes(engine_schemas: SchemaSet, engine_site: Path, tmp_path: Path) -> None:
    reference.emit(engine_schemas, tmp_path, jobs=1)
    assert _bytes(tmp_path) == _bytes(engine_site)


def test_a_second_run_writes_nothing(maker: SchemaMaker, tmp_path: Path) -> None:
    first = reference.emit(_small(maker).schemas(), tmp_path)
    assert first.changed == first.total > 5
    second = reference.emit(maker.schemas(), tmp_path)
    assert (second.changed, second.removed, second.total) == (0, 0, first.total)


def test_pages_of_types_that_are_gone_are_removed_and_foreign_files_stay(maker: SchemaMaker, write: Write) -> None:
    folder = write(_small(maker))
    (folder / "Game" / "notes.txt").write_text("mine")
    (folder / "CNAME").write_text("example.org")
    maker.document["classes"] = [c for c in maker.document["classes"] if c["name"] != "AOther"]
    write(maker)
    assert not (folder / "Game" / "AOther.html").exists()
    assert (folder / "Game" / "AThing.html").exists()
    assert (folder / "Game" / "notes.txt").read_text() == "mine"
    assert (folder / "CNAME").read_text() == "example.org"


@pytest.mark.parametrize("manifest", [None, "not json", "[]", json.dumps({"files": 7}), json.dumps({"files": ["Engine/__init__.pyi"]})])
def test_a_folder_with_something_else_is_refused(maker: SchemaMaker, tmp_path: Path, manifest: str | None) -> None:
    (tmp_path / "thesis.html").write_text("years of work")
    if manifest is not None:
        (tmp_path / ".spear-generated.json").write_text(manifest)
    before = _bytes(tmp_path)
    with pytest.raises(SchemaError, match="not empty"):
        reference.emit(_small(maker).schemas(), tmp_path)
    assert _bytes(tmp_path) == before


def test_a_file_in_place_of_the_folder_is_refused(maker: SchemaMaker, tmp_path: Path) -> None:
    (tmp_path / "site").write_text("")
    with pytest.raises(SchemaError, match="is a file"):
        reference.emit(_small(maker).schemas(), tmp_path / "site")


def test_a_run_that_was_stopped_can_be_repeated(maker: SchemaMaker, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(reference._Writer, "_write_modules", stop)
        with pytest.raises(KeyboardInterrupt):
            reference.emit(_small(maker).schemas(), tmp_path, jobs=1)
    assert (tmp_path / "Game" / "AThing.html").exists()
    maker.document["classes"] = [c for c in maker.document["classes"] if c["name"] != "AThing"]
    reference.emit(maker.schemas(), tmp_path)
    assert (tmp_path / "index.html").exists()
    assert not (tmp_path / "Game" / "AThing.html").exists(), "what the stopped run left is removed like anything else of an earlier one"


def test_a_schema_without_source_and_metadata_is_enough(engine_schemas: SchemaSet, tmp_path: Path) -> None:
    def bare(value: object) -> object:
        if isinstance(value, dict):
            return {key: bare(inner) for key, inner in value.items() if key not in ("source", "editor")}
        return [bare(inner) for inner in value] if isinstance(value, list) else value

    document = bare(engine_schemas.main)
    assert isinstance(document, dict)
    reference.emit(SchemaSet.of([document]), tmp_path)
    site = read_site(tmp_path)
    assert broken_links(site) == []
    page = site[(tmp_path / "Engine" / "AActor.html").resolve()]
    assert "SetActorScale3D" in page.ids and ".h:" not in page.text


# Awkward contents ----------------------------------------------------------------------------------------------------------------

_NASTY = "Breaks </script><script>document.title='broken'</script> & \"quotes\" 'too' <b onclick=alert(1)>bold</b> `a<b>` \u2028 ü 猫 {{ 7 * 7 }} {% raw %}"


def test_comments_and_texts_are_escaped(maker: SchemaMaker, write: Write) -> None:
    maker.add_class("AThing", comment=_NASTY, functions=(
        maker.function("Open", (maker.parameter("Angle", maker.type("float"), default="\"</td><script>x</script>\""),), comment=f"{_NASTY}\n@param Angle {_NASTY}\n@return {_NASTY}",
                       returns=maker.type("bool"), CPP_Default_Angle="<1>"),), properties=(maker.property("Width", comment=_NASTY, default="TEXT(\"<i>&\")"),))
    maker.add_enum("EMood", {"Good": 1}, comment=_NASTY)
    folder = write(maker, title="A <title> & \"more\"")
    site = read_site(folder)
    assert {path: facts.errors for path, facts in site.items() if facts.errors} == {}
    page = site[(folder / "Game" / "AThing.html").resolve()]
    assert "document.title='broken'" in page.text and "{{ 7 * 7 }}" in page.text and 'TEXT("<i>&")' in page.text
    assert page.title == 'AThing · A <title> & "more"'
    for path in folder.rglob("*"):
        if path.is_file() and path.suffix in (".html", ".js"):
            text = path.read_text(encoding="utf-8")
            assert "<script>document" not in text and "<b onclick" not in text and "<script>x" not in text
    assert "</script" not in (folder / "assets" / "search-summaries-0.js").read_text(encoding="utf-8")
    assert any("quotes" in entry.summary for entry in read_index(folder))


def test_names_that_files_and_anchors_cannot_have(maker: SchemaMaker, write: Write) -> None:
    maker.add_class("UObject", "CoreUObject")
    maker.add_class("BP_My Door (1)", "../Evil Module", "UObject", functions=(maker.function("Open Now!"), maker.function("Open Now?"), maker.function("open_now_")),
                    properties=(maker.property("Open Now!"), maker.property("Größe"), maker.property("section-functions"), maker.property("search")))
    maker.add_class("UDOOR", "../Evil Module", "UObject")
    maker.add_class("UDoor", "../Evil Module", "UObject")
    maker.add_class("index", "../Evil Module", "UObject")
    maker.add_class("UThing", "assets", "UObject")
    folder = write(maker)
    site = read_site(folder)
    assert broken_links(site) == []
    assert {path: facts.ids for path, facts in site.items() if len(set(facts.ids)) != len(facts.ids)} == {}
    files = [path.relative_to(folder).as_posix() for path in folder.rglob("*.html")]
    assert len({file.lower() for file in files}) == len(files), "file systems that know no case hold all of them"
    assert all(re.fullmatch(r"[A-Za-z0-9_./-]+", file) for file in files)
    entries = read_index(folder)
    targets = [entry.target for entry in entries if entry.name == "Open Now!"]
    assert len(set(targets)) == 2, "a function and a property of one name have two anchors"


def test_unknown_types_are_named_without_a_link(maker: SchemaMaker, write: Write) -> None:
    maker.add_class("AThing", super_class="AElsewhere", interfaces=("INowhere",), functions=(maker.function("Take", (
        maker.parameter("Other", maker.type("object", "UMissing*", name="UMissing")), maker.parameter("Set", maker.type("struct", "FMissing", name="FMissing")),
        maker.parameter("Mode", maker.type("enum", "EMissing", name="EMissing", underlying="uint8")))),),
        properties=(maker.property("OnDone", maker.type("multicast_delegate", "FMissingSignature", name="FMissingSignature")),))
    site = read_site(write(maker))
    assert broken_links(site) == []
    page = next(facts for path, facts in site.items() if path.name == "AThing.html")
    for name in ("UMissing*", "FMissing", "EMissing", "AElsewhere", "INowhere", "FMissingSignature"):
        assert name in page.text


def test_properties_tell_arrays_bits_and_editing(maker: SchemaMaker, write: Write) -> None:
    maker.add_class("AThing", properties=(
        maker.property("Slots", maker.type("float"), array_dim=4, array_text="MaxSlots"),
        maker.property("bOpen", maker.type("bool", bitfield=True), bits=1, flags=("Edit", "EditConst", "BlueprintVisible", "BlueprintReadOnly")),
        maker.property("Speed", maker.type("float"), flags=("Edit", "DisableEditOnTemplate", "Transient"), default="600.0f")))
    text = (write(maker) / "Game" / "AThing.html").read_text(encoding="utf-8")
    assert "float[MaxSlots = 4]" in text
    assert "bool : 1" in text and ">visible<" in text and ">Blueprint read only<" in text
    assert ">editable in instances<" in text and ">transient<" in text and "<code>600.0f</code>" in text


def test_delegates_and_structs_have_pages(maker: SchemaMaker, write: Write) -> None:
    maker.add_class("AThing", properties=(maker.property("OnOpened", maker.type("multicast_delegate", "FOpened", name="FOpened", owner="AThing")),))
    maker.add_delegate("FOpened", owner="AThing", parameters=(maker.parameter("Angle", maker.type("double")),), comment="It has been opened.")
    maker.add_struct("FBase", properties=(maker.property("A", maker.type("double")),))
    maker.add_struct("FDerived", super_struct="FBase", properties=(maker.property("B", maker.type("struct", "FBase", name="FBase")),))
    folder = write(maker)
    assert "AThing_FOpened.html" in read_page(folder / "Game" / "AThing.html").links
    delegate = read_page(folder / "Game" / "AThing_FOpened.html")
    assert "AThing.html#OnOpened" in delegate.links, "the variable of that type"
    assert "It has been opened." in delegate.text and "Angle" in delegate.text and "AThing.html" in delegate.links
    assert "FBase.html#A" in read_page(folder / "Game" / "FDerived.html").links
    assert "FDerived.html" in read_page(folder / "Game" / "FBase.html").links


def test_an_empty_schema_gives_an_empty_site(tmp_path: Path) -> None:
    document = {"format": "spear-schema", "version": 1, "origin": "offline", "modules": [], "classes": [], "structs": [], "enums": [], "delegates": []}
    reference.emit(SchemaSet.of([document]), tmp_path)
    assert broken_links(read_site(tmp_path)) == []


def test_entry_points_of_the_sdk_are_listed(engine_site: Path) -> None:
    from spear._native import ENTRY_POINTS

    page = read_page(engine_site / "entry_points.html")
    for name, _, _, documentation, signature in ENTRY_POINTS:
        assert re.sub(r"\W", "_", name) in page.ids
        assert " ".join(documentation.split()) in page.text
        assert " ".join(signature.partition(" @")[0].split()) in page.text
