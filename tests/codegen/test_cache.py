# SPDX-License-Identifier: MIT
"""The cache of the header tool: an incremental run writes, byte for byte, what a full one writes, whatever was edited in between and whatever happened to
the cache."""

from __future__ import annotations

import os
import random
import re
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

CODE_BASE = {
    "Thing.h": """#pragma once
#include "Thing.generated.h"
/** The first of all things. */
UCLASS(Blueprintable, Config=Game)
class UThing : public UObject
{
    GENERATED_BODY()
public:
    UPROPERTY(EditAnywhere) int32 Number = 1;
    UFUNCTION(BlueprintCallable) void Do(EKind Kind = EKind::Large);
    UFUNCTION() void OnRep_Other();
};
""",
    "Part.h": """#include "Part.generated.h"
UCLASS(DefaultToInstanced, Abstract)
class UPart : public UThing
{
    GENERATED_BODY()
public:
    UPROPERTY(ReplicatedUsing=OnRep_Other) int32 Other;
    UPROPERTY(BlueprintAssignable) FPartEvent OnPart;
};
""",
    "Kind.h": """#include "Kind.generated.h"
UENUM(BlueprintType)
enum class EKind : uint8 { Small = 1, Large = LargeKind, Most = Large + EWidth::Wide, Count };
""",
    "Width.h": """#include "Width.generated.h"
UENUM()
enum class EWidth : uint8 { Thin, Wide = 3 };
UENUM()
enum EPlain { Plain_A = 4, Plain_B };
""",
    "Limits.h": """#pragma once
#define LargeKind (2 + 3)
constexpr int32 MaxSlots = 6;
""",
    "Holder.h": """#include "Holder.generated.h"
USTRUCT(BlueprintType)
struct FHolder
{
    GENERATED_BODY()
    UPROPERTY() TArray<UPart*> Parts;
    UPROPERTY() int32 Slots[MaxSlots];
    UPROPERTY() int32 PerKind[(int32)EKind::Count];
    UPROPERTY() TEnumAsByte<EPlain> Plain;
};
""",
    "Events.h": """#include "Events.generated.h"
DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(FPartEvent, UThing*, Sender, const FHolder&, What);
""",
    "Actor.h": """#include "Actor.generated.h"
UINTERFACE()
class UUsable : public UInterface { GENERATED_BODY() };
class IUsable { GENERATED_BODY() public: UFUNCTION(BlueprintNativeEvent) bool Use(UThing* By); };
UCLASS()
class AUser : public AActor, public IUsable
{
    GENERATED_BODY()
    UPROPERTY() FHolder Holder;
    UPROPERTY() TMap<FName, EKind> Kinds;
    UPROPERTY() TScriptInterface<IUsable> Target;
    UFUNCTION(BlueprintCallable) FHolder Find(const TArray<FHolder>& In, EWidth Width = EWidth::Wide);
};
""",
    "Late.h": """#include "Late.generated.h"
UCLASS() class ULate : public UPart { GENERATED_BODY() UPROPERTY(Instanced) TObjectPtr<UThing> Thing; UPROPERTY() FMissing Missing; };
""",
}


class Module:
    """A module on disk, read with one cache or without any."""

    def __init__(self, tool: Path, folder: Path) -> None:
        self.tool, self.folder = tool, folder
        self.cache = folder / "cache"
        self.headers = folder / "Test" / "Public"
        self.headers.mkdir(parents=True)
        for name, text in CODE_BASE.items():
            (self.headers / name).write_text(text)

    def run(self, *arguments: str) -> tuple[bytes, bytes, str]:
        """Schema, report, and what was printed."""
        output, report = self.folder / "out.json", self.folder / "out.report.json"
        run = subprocess.run([str(self.tool), "dump", "--module", f"Test={self.folder / 'Test'}", "-o", str(output), "--report", str(report), *arguments],
                             capture_output=True, text=True, timeout=120)
        assert run.returncode == 0, run.stderr
        return output.read_bytes(), report.read_bytes(), run.stderr

    def full(self) -> tuple[bytes, bytes]:
        return self.run("--no-cache")[:2]

    def cached(self) -> tuple[bytes, bytes]:
        return self.run("--cache", str(self.cache))[:2]

    def reused(self, *arguments: str) -> int:
        """How many headers the cache answered for."""
        found = re.search(r"\((\d+) unchanged", self.run(*(arguments or ("--cache", str(self.cache))))[2])
        return int(found.group(1)) if found else 0

    def entries(self) -> list[Path]:
        return sorted(p for p in self.cache.rglob("*") if p.is_file())

    def edit(self, name: str, old: str, new: str) -> None:
        text = (self.headers / name).read_text()
        assert old in text
        (self.headers / name).write_text(text.replace(old, new, 1))


@pytest.fixture
def module(tool: Path, tmp_path: Path) -> Module:
    return Module(tool, tmp_path)


def test_second_run_reads_nothing_anew(module: Module) -> None:
    assert module.reused() == 0
    reflected = len(CODE_BASE) - 1
    assert module.reused() == reflected
    assert module.reused() == reflected and module.cached() == module.full()


# What is edited, and the headers whose results depend on it.
DEPENDENTS = [
    ("Late.h", "FMissing Missing", "FMissing Renamed", {"Late.h"}),  # nobody looks at its properties
    ("Thing.h", "/** The first", "/** First", {"Thing.h"}),  # a comment is nobody else's business
    ("Thing.h", "Blueprintable", "Blueprintable, Transient", {"Thing.h", "Part.h", "Late.h", "Actor.h", "Events.h", "Holder.h"}),  # inherited flags, uses of the class
    ("Width.h", "Wide = 3", "Wide = 5", {"Width.h", "Kind.h", "Thing.h", "Holder.h", "Actor.h"}),  # EKind::Most, a dimension, uses of both enums
    ("Limits.h", "MaxSlots = 6", "MaxSlots = 7", {"Holder.h"}),
    ("Limits.h", "(2 + 3)", "(2 + 4)", {"Kind.h", "Thing.h", "Holder.h", "Actor.h"}),
]


@pytest.mark.parametrize(("name", "old", "new", "dependents"), DEPENDENTS)
def test_only_what_depends_on_an_edit_is_read_again(module: Module, name: str, old: str, new: str, dependents: set[str]) -> None:
    before = module.cached()
    module.edit(name, old, new)
    assert module.reused() == len(CODE_BASE) - 1 - len(dependents)
    after = module.cached()
    assert after == module.full() and after[0] != before[0]
    module.edit(name, new, old)
    assert module.cached() == before


EDITS: list[Callable[[dict[str, str], random.Random], None]] = []


def edit(function: Callable[[dict[str, str], random.Random], None]) -> Callable[[dict[str, str], random.Random], None]:
    EDITS.append(function)
    return function


@edit
def add_a_type(code: dict[str, str], r: random.Random) -> None:
    name = f"New{r.randrange(6)}"
    code[f"{name}.h"] = f'#include "{name}.generated.h"\nUCLASS({r.choice(["", "DefaultToInstanced", "Const"])})\nclass U{name} : public {r.choice(["UThing", "UPart", "UObject", "UNew3"])} {{ GENERATED_BODY() UPROPERTY() FHolder Held; }};\n'


@edit
def remove_a_header(code: dict[str, str], r: random.Random) -> None:
    if len(code) > 4:
        del code[r.choice(sorted(code))]


@edit
def bring_a_header_back(code: dict[str, str], r: random.Random) -> None:
    name = r.choice(sorted(CODE_BASE))
    code[name] = CODE_BASE[name]


@edit
def change_a_base_class(code: dict[str, str], r: random.Random) -> None:
    name = r.choice(sorted(code))
    code[name] = re.sub(r": public U\w+", f": public {r.choice(['UObject', 'UThing', 'UPart', 'UUnknown', 'UMissingComponent'])}", code[name], count=1)


@edit
def change_an_enum_constant(code: dict[str, str], r: random.Random) -> None:
    for name in ("Width.h", "Kind.h"):
        if name in code:
            code[name] = re.sub(r"= \w+", f"= {r.choice(['1', '2', '7', 'LargeKind', 'EWidth::Wide', 'Plain_B', 'Nowhere'])}", code[name], count=1)


@edit
def add_an_enum_entry(code: dict[str, str], r: random.Random) -> None:
    for name in ("Width.h", "Kind.h"):
        if name in code:
            code[name] = code[name].replace("{ ", f"{{ Extra{r.randrange(100)}, ", 1)


@edit
def change_a_macro(code: dict[str, str], r: random.Random) -> None:
    code["Limits.h"] = f"#pragma once\n#define LargeKind ({r.randrange(9)} + EWidth::Wide)\n" + r.choice(["", f"constexpr int32 MaxSlots = {r.randrange(1, 9)};\n", f"enum {{ Unused, MaxSlots = {r.randrange(1, 5)} }};\n"])


@edit
def move_a_constant_into_a_reflected_header(code: dict[str, str], r: random.Random) -> None:
    if "Width.h" in code:
        code["Width.h"] += f"constexpr int32 MaxSlots = {r.randrange(1, 5)};\n"


@edit
def change_specifiers(code: dict[str, str], r: random.Random) -> None:
    name = r.choice(sorted(code))
    code[name] = re.sub(r"(UCLASS|USTRUCT)\([^)]*\)", rf"\1({r.choice(['', 'Abstract', 'DefaultToInstanced', 'HasDefaults', 'Config=Engine', 'NotPlaceable', 'HideCategories=(A, B)', 'Within=Part'])})", code[name], count=1)


@edit
def rename_a_type(code: dict[str, str], r: random.Random) -> None:
    name, (old, new) = r.choice(sorted(code)), r.choice([("UThing", "UThings"), ("FHolder", "FHolders"), ("EKind", "EKinds"), ("FPartEvent", "FOtherEvent"), ("UThings", "UThing"), ("FHolders", "FHolder")])
    code[name] = code[name].replace(old, new)


@edit
def rename_a_function(code: dict[str, str], r: random.Random) -> None:
    if "Thing.h" in code:
        code["Thing.h"] = code["Thing.h"].replace("OnRep_Other", r.choice(["OnRep_Other", "OnRep_Another"]))


@edit
def declare_a_type_twice(code: dict[str, str], r: random.Random) -> None:
    code[f"{r.choice('AZ')}Twice.h"] = f'#include "ZTwice.generated.h"\n\nUSTRUCT() struct {r.choice(["FHolder", "FOnce"])} {{ GENERATED_BODY() UPROPERTY() UPart* X; }};\n'


@edit
def break_a_header(code: dict[str, str], r: random.Random) -> None:
    name = r.choice(sorted(code))
    code[name] = code[name][: r.randrange(len(code[name]) + 1)]


@edit
def add_blank_lines(code: dict[str, str], r: random.Random) -> None:
    name = r.choice(sorted(code))
    code[name] = "\n" * r.randrange(1, 4) + code[name]


def test_an_incremental_run_equals_a_full_one_after_any_edit(module: Module) -> None:
    numbers = random.Random(11)
    code = dict(CODE_BASE)
    module.cached()
    for step in range(90):
        done = []
        for change in numbers.sample(EDITS, numbers.randint(1, 3)):
            change(code, numbers)
            done.append(change.__name__)
        for path in module.headers.glob("*.h"):
            if path.name not in code:
                path.unlink()
        for name, text in code.items():
            (module.headers / name).write_text(text)
        assert module.cached() == module.full(), f"step {step}: {done}"


def test_options_do_not_share_results(module: Module) -> None:
    cache = ("--cache", str(module.cache))
    for options in ([], ["--define", "WITH_EDITOR=0"], ["--define", "WITH_EDITORONLY_DATA=0"], []):
        assert module.run(*cache, *options)[:2] == module.run("--no-cache", *options)[:2]
    (module.headers / "Wrong.h").write_text('#include "Wrong.generated.h"\nUSTRUCT() struct FWrong { GENERATED_BODY() UPROPERTY() TArray<TArray<int32>> X; };\n')
    module.run(*cache)
    strict = subprocess.run([str(module.tool), "dump", "--strict", "--module", f"Test={module.folder / 'Test'}", "-o", str(module.folder / "strict.json"), *cache], capture_output=True, text=True)
    assert strict.returncode == 1 and "error:" in strict.stderr, "lenient results must not answer for a strict run"


def test_another_build_of_the_tool_believes_nothing(module: Module) -> None:
    module.cached()
    other = module.folder / "other-tool"
    shutil.copy(module.tool, other)
    with other.open("ab") as file:
        file.write(b"another build")
    module.tool = other
    assert module.reused() == 0
    assert module.reused() == len(CODE_BASE) - 1


def damaged(content: bytes, numbers: random.Random) -> Iterator[bytes]:
    yield b""
    yield b"garbage"
    yield content[: len(content) // 2]
    yield content[:24]
    yield content + b"\0"
    yield bytes(numbers.randrange(256) for _ in range(len(content)))
    yield content[:24] + bytes(len(content) - 24)
    at = numbers.randrange(len(content))
    yield content[:at] + bytes([content[at] ^ 1 << numbers.randrange(8)]) + content[at + 1 :]


def test_damaged_entries_do_no_harm(module: Module) -> None:
    expected, numbers = module.cached(), random.Random(3)
    entries = {path: path.read_bytes() for path in module.entries()}
    assert len(entries) == len(CODE_BASE) - 1
    for kind in range(8):
        for path, content in entries.items():
            path.write_bytes(list(damaged(content, numbers))[kind])
        assert module.cached() == expected
        assert module.reused() == len(entries), "damaged entries are replaced"


def test_folders_in_place_of_entries_do_no_harm(module: Module) -> None:
    expected = module.cached()
    for path in module.entries():
        path.unlink()
        path.mkdir()
    assert module.cached() == expected


@pytest.mark.parametrize("place", ["a file", "below a file", "/dev/null", "/proc/nowhere"])
def test_unusable_cache_folder(module: Module, place: str) -> None:
    (module.folder / "file").write_text("")
    cache = {"a file": str(module.folder / "file"), "below a file": str(module.folder / "file" / "x")}.get(place, place)
    expected = module.full()
    schema, report, printed = module.run("--cache", cache)
    assert (schema, report) == expected
    assert "no cache" in printed and cache in printed


def test_cache_that_takes_no_more(module: Module) -> None:
    """As if the folder were read only: none of its folders can be made."""
    module.cache.mkdir()
    for i in range(256):
        (module.cache / f"{i:02x}").write_text("")
    schema, report, printed = module.run("--cache", str(module.cache))
    assert (schema, report) == module.full() and "no cache" in printed


@pytest.mark.skipif(os.geteuid() != 0, reason="mounting a small file system needs root")
def test_full_disk(module: Module) -> None:
    module.cache.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", str(module.cache)], capture_output=True).returncode != 0:
        pytest.skip("mounting is not allowed here")
    try:
        schema, report, printed = module.run("--cache", str(module.cache))
        assert "No space left" in printed
        assert module.cached() == (schema, report)
    finally:
        subprocess.run(["umount", str(module.cache)], check=True)
    assert (schema, report) == module.full()


def test_runs_at_the_same_time(module: Module) -> None:
    expected = module.full()
    for fresh in (True, False):
        runs = [
            subprocess.Popen([str(module.tool), "dump", "--quiet", "--module", f"Test={module.folder / 'Test'}", "--cache", str(module.cache),
                              "-o", str(module.folder / f"{i}.json"), "--report", str(module.folder / f"{i}.report.json")])
            for i in range(6)
        ]
        assert [run.wait(timeout=120) for run in runs] == [0] * 6
        for i in range(6):
            assert ((module.folder / f"{i}.json").read_bytes(), (module.folder / f"{i}.report.json").read_bytes()) == expected, f"fresh cache: {fresh}"
    assert not list(module.cache.rglob("*.part"))


def test_size_is_bounded_and_nothing_else_is_touched(module: Module) -> None:
    module.cache.mkdir()
    mine = module.cache / "my thesis.txt"
    mine.write_text("x" * 3_000_000)
    (module.cache / "ab").mkdir()
    (module.cache / "ab" / "notes").write_text("y")
    for i in range(12):
        functions = "\n".join(f"/** {'Long words. ' * 20} */ UFUNCTION(BlueprintCallable) void Function{k}(int32 A, int32 B);" for k in range(150))
        (module.headers / f"Big{i}.h").write_text(f'#include "Big{i}.generated.h"\nUCLASS() class UBig{i} : public UObject {{ GENERATED_BODY() {functions} }};\n')
    for _ in range(2):
        module.run("--cache", str(module.cache), "--cache-size", "1")
        entries = [p for p in module.entries() if p.name not in ("my thesis.txt", "notes")]
        assert 0 < sum(p.stat().st_size for p in entries) <= 1 << 20
    assert mine.exists() and (module.cache / "ab" / "notes").exists()
    module.run("--cache", str(module.cache))
    assert module.reused() == len(CODE_BASE) - 1 + 12


def test_what_was_used_last_stays(module: Module) -> None:
    module.cached()
    old = module.entries()
    for path in old:
        os.utime(path, (1, 1))
    kept = old[0]
    os.utime(kept)
    for i in range(3):
        text = "\n".join(f"/** {'Long words. ' * 40} */ UPROPERTY() int32 Property{k};" for k in range(200))
        (module.headers / f"Big{i}.h").write_text(f'#include "Big{i}.generated.h"\nUSTRUCT() struct FBig{i} {{ GENERATED_BODY() {text} }};\n')
    for path in module.headers.glob("*.h"):
        if path.name in CODE_BASE:
            path.unlink()
    module.run("--cache", str(module.cache), "--cache-size", "1")
    assert not any(path.exists() for path in old[1:])


def test_default_folder(module: Module, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(module.folder / "xdg"))
    module.run()
    assert any((module.folder / "xdg" / "spear" / "headers").rglob("*"))
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(module.folder / "home"))
    module.run()
    assert any((module.folder / "home" / ".cache" / "spear" / "headers").rglob("*"))
    monkeypatch.delenv("HOME")
    assert module.run()[:2] == module.full()
    assert module.run("--no-cache")[:2] == module.full()
