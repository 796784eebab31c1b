# SPDX-License-Identifier: MIT
"""independent_check.py agrees with the tool on a code base of every shape, and sees each kind of mistake that the tool could make."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

HEADER = """
UENUM()
enum class EMode : uint8 { Slow = 1 << 2, Fast };
UCLASS()
class UGame : public UObject
{
    GENERATED_BODY()
public:
    /** Speed in cm/s. */
    UPROPERTY(EditAnywhere, meta = (ClampMin = "0.5", Units = "cm/s"))
    float Speed = 3.f;
    // Goes.
    UFUNCTION(BlueprintCallable)
    FVector Go(const FString& Where, int32 Count = 7);
};
"""

#: What a wrong tool would write: (place in the schema's text, what stands there instead, words of the complaint).
MISTAKES = {
    "type": ('"cpp": "FVector"', '"cpp": "int32"', "type 0"),
    "lost property": ('"cpp_name": "Speed"', '"cpp_name": "Lost"', "property Speed is not in the schema"),
    "default": ('"default": "3.f"', '"default": "4.f"', "default: text '3.f'"),
    "argument": ('"default": "7"', '"default": "8"', "default of Count"),
    "value": ('"value": 5', '"value": 6', "value of Fast"),
    "metadata": ('"ClampMin": "0.5"', '"ClampMin": "0"', "meta ClampMin"),
    "comment": ('"comment": "/** Speed in cm/s. */"', '"comment": "/** Speed. */"', "comment: text"),
    "specifiers": ('"specifiers": "BlueprintCallable"', '"specifiers": ""', "specifiers: text 'BlueprintCallable'"),
}


def check(tool: Path, project: Path, *options: str) -> subprocess.CompletedProcess[str]:
    script = Path(__file__).with_name("independent_check.py")
    return subprocess.run([sys.executable, str(script), "--tool", str(tool), str(project), "--verbose", *options], capture_output=True, text=True, check=False)


@pytest.fixture
def project(tmp_path: Path) -> Path:
    folder = tmp_path / "Project" / "Source" / "Game"
    folder.mkdir(parents=True)
    (folder / "Game.Build.cs").write_text("// rules")
    (folder / "Game.h").write_text(f'#pragma once\n#include "CoreMinimal.h"\n#include "Game.generated.h"\n{HEADER}')
    return tmp_path / "Project"


def test_right(build_directory: Path, project: Path) -> None:
    result = check(build_directory / "bin" / "spear-header-tool", project)
    assert result.returncode == 0 and "4 calls in text,      4 declared (100.000 %); types right 4 of 4" in result.stdout, result.stdout


@pytest.mark.parametrize("mistake", MISTAKES)
def test_wrong(build_directory: Path, project: Path, tmp_path: Path, mistake: str) -> None:
    """A tool that makes one mistake."""
    before, after, complaint = MISTAKES[mistake]
    tool = tmp_path / "tool"
    tool.write_text(f"""#!{sys.executable}
import subprocess, sys
from pathlib import Path
code = subprocess.run([{str(build_directory / "bin" / "spear-header-tool")!r}, *sys.argv[1:]]).returncode
output = Path(sys.argv[sys.argv.index("-o") + 1])
text = output.read_text()
assert {before!r} in text, text
output.write_text(text.replace({before!r}, {after!r}))
sys.exit(code)
""")
    tool.chmod(0o755)
    result = check(tool, project)
    assert result.returncode == 1 and complaint in result.stdout, result.stdout + result.stderr


def test_every_shape(build_directory: Path, source_directory: Path, tmp_path: Path) -> None:
    """A synthetic code base of all shapes, 400 headers."""
    base = tmp_path / "base"
    command = [sys.executable, str(source_directory / "tests" / "scale" / "make_code_base.py"), "--headers", "400", "--functions", "2000", "--properties", "7000", "--seed", "7", "-o", str(base)]
    subprocess.run(command, check=True, capture_output=True)
    result = check(build_directory / "bin" / "spear-header-tool", base, "--report", str(tmp_path / "report.json"))
    assert result.returncode == 0, result.stdout[-3000:]
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["problems"] == [] and sum(report["text"].values()) == sum(report["declared"].values()) > 9000 and sum(report["facts"].values()) > 20000
