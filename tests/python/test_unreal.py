# SPDX-License-Identifier: MIT
"""spear.unreal: names of Unreal by their modules, with and without facts, with and without an engine."""

from __future__ import annotations

import json
import os
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

import spear
import spear.unreal.CoreUObject
import spear.unreal.Engine
from spear import facts
from spear.unreal.Engine import AActor, ACoordinateAxes, APawn, AStaticMeshActor, ECollisionChannel, FHitResult, UCameraComponent, USceneComponent


def in_new_process(program: str, *folders: Path, code: int = 0) -> str:
    """Runs a program in an interpreter of its own; ``folders`` go onto its path."""
    package = Path(spear.__file__).parent.parent
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, (package, *folders)))}
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, env=environment)
    assert result.returncode == code, result.stdout + result.stderr
    return result.stdout + result.stderr


@pytest.fixture
def actor(instance: spear.Instance, game: spear.Game):
    with instance.begin_frame():
        spawned = game.spawn_actor(ACoordinateAxes)
        yield spawned
        game.destroy_actor(spawned)
    with instance.end_frame():
        pass


# Names ------------------------------------------------------------------------------------------------------------------------------------


def test_the_same_object_each_time() -> None:
    import spear.unreal.Engine as again

    assert again.AActor is AActor and spear.unreal.Engine is again
    assert spear.unreal.CoreUObject.FVector is spear.FVector and spear.unreal.CoreUObject.FTransform is spear.FTransform
    assert AActor.unreal_name == AActor.__name__ == "AActor" and AActor.__module__ == "spear.unreal.Engine"
    assert pickle.loads(pickle.dumps(AActor)) is AActor and pickle.loads(pickle.dumps(FHitResult)) is FHitResult
    assert "spear.unreal.Engine" in repr(AActor) and "spear.unreal.Engine" in repr(again)


def test_python_classes_derive_as_unreals_do() -> None:
    assert issubclass(AStaticMeshActor, AActor) and not issubclass(AActor, AStaticMeshActor)
    assert [c.__name__ for c in APawn.__mro__[:3]] == ["APawn", "AActor", "UObject"]
    from spear.unreal.CoreUObject import UObject
    assert issubclass(AActor, UObject) and issubclass(spear.UnrealObject, UObject)


def test_modules_list_what_is_known() -> None:
    names = dir(spear.unreal.Engine)
    assert {"AActor", "FHitResult", "ECollisionChannel"} <= set(names) and names == sorted(names)
    assert {"Engine", "CoreUObject"} <= set(dir(spear.unreal))


def test_unknown_names_say_which_are_near() -> None:
    with pytest.raises(ImportError, match="AActor"):
        from spear.unreal.Engine import AActr  # noqa: F401
    with pytest.raises(AttributeError, match="ECollisionChannel"):
        spear.unreal.Engine.ECollisionChanel
    with pytest.raises(ImportError, match="it is in spear.unreal.CoreUObject"):
        from spear.unreal.Engine import FVector  # noqa: F401
    with pytest.raises(ImportError):
        __import__("spear.unreal.Engine.AActor")
    with pytest.raises(AttributeError, match="import spear.unreal.Nothing"):
        spear.unreal.Nothing


def test_modules_without_facts_take_any_name() -> None:
    import spear.unreal.SomeGame as game_module
    from spear.unreal.SomeGame import AHero, EMood, FScore, IWalker

    assert game_module.AHero is AHero and AHero.unreal_name == "AHero" and isinstance(AHero, type) and isinstance(IWalker, type)
    score = FScore(Points=3, Name="x")
    assert score.Points == 3 and score == {"Points": 3, "Name": "x"}
    with pytest.raises(TypeError, match="by name"):
        FScore(3)
    for ask in (lambda: EMood.Happy, lambda: EMood("Happy"), lambda: EMood(1)):
        with pytest.raises((AttributeError, ValueError), match="spear schema stubs"):
            ask()
    with pytest.raises(AttributeError, match="begin with"):
        game_module.hero


def test_names_of_stubs_alone_can_be_imported() -> None:
    from spear.unreal.Engine import AActor_async, AActor_K2_SetActorLocation_Result, AActor_path, AActor_send, FHitResult_dict, FHitResult_in

    def annotated(a: AActor_async | None, b: AActor_path, c: AActor_send, d: FHitResult_dict, e: FHitResult_in | None) -> AActor_K2_SetActorLocation_Result: ...

    assert not isinstance(3, AActor_path)
    with pytest.raises(TypeError, match="annotations"):
        AActor_path()


def test_imports_need_no_engine_and_are_fast() -> None:
    program = """
import sys, time
import spear
from spear.unreal.Engine import AActor, FHitResult, ECollisionChannel
import spear.unreal.Anything as m
assert m.UThing.unreal_name == "UThing" and FHitResult(Time=1).Time == 1 and ECollisionChannel.ECC_Pawn.name == "ECC_Pawn"
assert not {"jinja2", "numpy", "spear.codegen.schema", "spear.codegen.cli"} & set(sys.modules), sorted(sys.modules)
"""
    in_new_process(program)
    loaded = in_new_process("import sys, spear; print(sorted(m for m in sys.modules if m.startswith(('spear.codegen', 'spear.unreal.', 'jinja', 'json'))))")
    assert loaded.strip() == "[]"


# Facts ------------------------------------------------------------------------------------------------------------------------------------


def write_stubs(folder: Path, module: str, document: object) -> Path:
    target = folder / "spear-stubs" / "unreal" / module
    target.mkdir(parents=True)
    (target / "facts.json").write_text(document if isinstance(document, str) else json.dumps(document), encoding="utf-8")
    return folder


GAME_FACTS = {
    "classes": {
        "AHero": {"super": "APawn", "interfaces": ["IWalker"], "never_null": [], "names": {"Max_Health": "Max Health"}},
        "UWalker": {"super": "UInterface", "interfaces": [], "never_null": [], "names": {}},
    },
    "structs": {
        "FScore": {"super": None, "fields": ["Points", "Best Player", "copy"], "names": {"Best_Player": "Best Player"}},
        "FBigScore": {"super": "FScore", "fields": ["Points", "Best Player", "copy", "Bonus"], "names": {"Best_Player": "Best Player"}},
    },
    "enums": {
        "EMood": {"flags": False, "entries": [["None", 0], ["Very Happy", 5]], "names": {"Very_Happy": "Very Happy"}},
        "EKeys": {"flags": True, "entries": [["Up", 1], ["Down", 2]], "names": {}},
    },
}


def test_stubs_of_the_application_come_first(tmp_path: Path) -> None:
    """Its own modules and, where it has them, those of the engine."""
    write_stubs(tmp_path, "MyGame", GAME_FACTS)
    write_stubs(tmp_path, "Engine", {"classes": {"APawn": {"super": "AActor"}, "AActor": {"super": "UObject"}, "ANewActor": {"super": "AActor"}}})
    program = """
import spear
from spear.unreal.MyGame import AHero, IWalker, UWalker, FScore, FBigScore, EMood, EKeys
from spear.unreal.Engine import ANewActor, AActor
assert [c.__name__ for c in AHero.__mro__[:4]] == ["AHero", "APawn", "AActor", "UObject"] and issubclass(AHero, IWalker) and UWalker is IWalker
score = FScore(Points=1, Best_Player="me", copy_=2)
assert score.to_dict() == {"Points": 1, "Best Player": "me", "copy": 2}, score
assert issubclass(FBigScore, FScore) and FBigScore(1, "x", 2, 3).Bonus == 3
assert EMood.None_ == 0 and EMood("None") is EMood.None_ and EMood("EMood::Very Happy") is EMood.Very_Happy and EMood["Very_Happy"] == 5
assert EKeys("Up | Down") == EKeys.Up | EKeys.Down == 3
try:
    from spear.unreal.Engine import AStaticMeshActor
except ImportError as error:
    print("good:", error)
try:
    FScore(Best="x")
except TypeError as error:
    print("good:", error)
"""
    output = in_new_process(program, tmp_path)
    assert output.count("good:") == 2 and "spear schema stubs" in output and "FScore has no field 'Best'" in output


@pytest.mark.parametrize("content", ["{", "[]", ""])
def test_broken_facts_are_an_import_error_that_names_the_file(tmp_path: Path, content: str) -> None:
    write_stubs(tmp_path, "MyGame", content)
    output = in_new_process("import spear.unreal.MyGame", tmp_path, code=1)
    assert "ImportError" in output and "facts.json" in output and "spear schema stubs" in output
    in_new_process("import spear; from spear.unreal.Engine import AActor", tmp_path)


# Objects ----------------------------------------------------------------------------------------------------------------------------------


def test_isinstance_asks_for_unreals_class(game: spear.Game, actor: spear.UnrealObject) -> None:
    assert isinstance(actor, ACoordinateAxes) and isinstance(actor, AActor) and not isinstance(actor, APawn)
    assert isinstance(actor.RootComponent.get(), USceneComponent) and not isinstance(actor.RootComponent.get(), AActor)
    assert not isinstance("AActor", AActor) and not isinstance(None, AActor) and not isinstance(AActor, AActor)
    assert actor.unreal_name == "ACoordinateAxes"
    match actor:
        case APawn():
            raise AssertionError
        case AActor():
            pass
        case _:
            raise AssertionError


def test_classes_are_taken_wherever_names_are(instance: spear.Instance, game: spear.Game, actor: spear.UnrealObject) -> None:
    assert actor in game.find_actors_by_class(AActor) and game.find_actor_by_class(ACoordinateAxes) == actor
    assert game.get_default_object(AActor) != actor and isinstance(game.get_default_object(APawn), APawn)
    component = actor.get_component(USceneComponent, actor.RootComponent.get().get_path_name().rsplit(".")[-1])
    assert component == actor.RootComponent.get() and component in actor.get_components(USceneComponent)
    assert actor.async_.get_components(USceneComponent).get() == actor.get_components(USceneComponent)
    with pytest.raises(spear.UnknownObject):
        actor.get_component(UCameraComponent)
    added = actor.AddComponentByClass(Class=UCameraComponent, bManualAttachment=False, RelativeTransform=spear.FTransform(), bDeferredFinish=False)
    assert isinstance(added, UCameraComponent) and actor.get_component(UCameraComponent) == added == game.get_component_by_class(actor, UCameraComponent)
    with pytest.raises(TypeError, match="no class of Unreal"):
        game.spawn_actor(dict)  # type: ignore[type-var]
    with pytest.raises(TypeError, match="spawn_actor"):
        AActor()


def test_cast_checks(actor: spear.UnrealObject) -> None:
    assert spear.cast(AActor, actor) is actor
    with pytest.raises(spear.WrongType, match="ACoordinateAxes"):
        spear.cast(APawn, actor)
    with pytest.raises(spear.NullObject):
        spear.cast(APawn, None)
    with pytest.raises(spear.WrongType, match="int"):
        spear.cast(APawn, 3)
    with pytest.raises(TypeError):
        spear.cast(int, actor)


def test_interfaces_by_both_names(round_trip: spear.Instance, things: spear.UnrealObject, calls: spear.UnrealObject) -> None:
    from spear.unreal.RoundTrip import IRoundTripListener, URoundTripListener

    assert isinstance(things, IRoundTripListener) and not isinstance(calls, IRoundTripListener)
    assert URoundTripListener is IRoundTripListener
    things.InterfaceValue = things
    assert isinstance(things.InterfaceValue.get(), IRoundTripListener)


def test_what_no_file_knows_is_asked_from_the_engine(round_trip: spear.Instance) -> None:
    import spear.unreal.RoundTrip as module

    assert {"URoundTrip", "FRoundTripRecord", "ERoundTripMode"} <= set(dir(module))
    assert module.FRoundTripRecord(5, False) == {"Count": 5, "bOn": False} and module.FRoundTripRecord.field_names[:2] == ("Count", "bOn")
    assert module.ERoundTripMode.Reckless == 7
    with pytest.raises(AttributeError, match="ERoundTripMode"):
        module.ERoundTripMod
    # An enum or struct made before there was an engine has the same class afterwards.
    facts.forget()
    assert module.ERoundTripMode("Fast").name == "Fast"


def test_every_name_of_the_stubs_exists_at_run_time() -> None:
    """What an editor offers after ``from spear.unreal.Engine import`` can be imported, as the kind of thing that the stub says."""
    import ast
    import importlib

    folder = Path(spear.unreal.__file__ or "").parent
    count = 0
    for stub in sorted(folder.glob("*/__init__.pyi")):
        module = importlib.import_module(f"spear.unreal.{stub.parent.name}")
        for node in ast.parse(stub.read_text(encoding="utf-8")).body:
            for alias in node.names if isinstance(node, ast.ImportFrom) else ():
                name = alias.asname or alias.name
                assert getattr(module, name) is getattr(module, name), name
                count += 1
        known = facts.from_files(stub.parent.name)
        assert known is not None
        for name in known.classes:
            assert isinstance(getattr(module, name), type) and getattr(module, name).unreal_name.lstrip("IU") == name.lstrip("IU"), name
        for name, entity in known.structs.items():
            assert list(getattr(module, name).field_names) == entity["fields"], name
        for name, entity in known.enums.items():
            made = getattr(module, name)
            assert issubclass(made, spear.UnrealFlags if entity["flags"] else spear.UnrealEnum), name
            assert {made(entry) == value for entry, value in entity["entries"]} == {True}, name
    assert count > 500
