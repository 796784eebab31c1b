# SPDX-License-Identifier: MIT
"""README.md and the pages say what is so: their programs run or compile, their commands and files exist."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

import click
import helpers
import pytest

from spear.cli import cli

PAGES = ["README.md", "CONTRIBUTING.md", "docs/architecture.md", "docs/programming_model.md", "docs/protocol.md", "docs/real_unreal.md", "docs/scenes.md", "docs/schema.md"]


def programs(page: Path, language: str) -> list[str]:
    return [str(found) for found in re.findall(rf"^```{language}\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)]


def run_python(build_directory: Path, file: Path, text: str) -> str:
    file.write_text(text, encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": str(build_directory / "python"), "SPEAR_BUILD_DIR": str(build_directory)}
    return helpers.run([sys.executable, file], env=environment).stdout


def test_first_program_of_the_readme(source_directory: Path, build_directory: Path, tmp_path: Path) -> None:
    text = programs(source_directory / "README.md", "python")[0]
    assert run_python(build_directory, tmp_path / "program.py", text) == "FVector(X=-10.0, Y=280.0, Z=50.0) -10.0\n"


def test_first_cpp_program_of_the_readme_compiles(source_directory: Path, tmp_path: Path) -> None:
    file = tmp_path / "program.cpp"
    file.write_text("#include <spear/spear.hpp>\nint main() {\n" + programs(source_directory / "README.md", "cpp")[0] + "    return location.get().X > 0;\n}\n", encoding="utf-8")
    include = [f"-I{source_directory / place}" for place in ("sdk/include", "generated/cpp")]
    helpers.run(["g++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", *include, file], timeout=600)


def test_first_transaction_of_the_programming_model(source_directory: Path, build_directory: Path, tmp_path: Path) -> None:
    before = """
import spear
with spear.launch(scene="") as instance:
    with instance.begin_frame():
        actor = instance.get_game().spawn_actor("ACameraActor")
    with instance.end_frame():
        pass
"""
    transaction = "".join(f"    {line}\n" for line in programs(source_directory / "docs" / "programming_model.md", "python")[0].splitlines())
    assert run_python(build_directory, tmp_path / "program.py", before + transaction + "    print(where)\n") == "FVector(X=10.0, Y=0.0, Z=0.0)\n"


@pytest.mark.parametrize("page", PAGES)
def test_commands_and_files_exist(source_directory: Path, page: str) -> None:
    text = (source_directory / page).read_text(encoding="utf-8")
    for line in re.findall(r"^    (?:tools/)?spear +(.+)$", text, re.MULTILINE) + re.findall(r"`(?:tools/)?spear +([^`]+)`", text):
        command: click.Command = cli
        words = line.split()
        while words and isinstance(command, click.Group):
            context = click.Context(command)
            if words[0].startswith("-") or not (found := command.get_command(context, words[0])):
                break
            command = found
            words.pop(0)
        assert command is not cli or words[0] in ("--help", "--version"), f"{page}: no command '{line}'"
        options = {name for parameter in command.params for name in (*parameter.opts, *parameter.secondary_opts)} | {"--help", "-h"}
        passes_on = isinstance(command, click.Group) or command.context_settings.get("ignore_unknown_options", False)
        before_program = words[: words.index("--")] if "--" in words else words
        for word in before_program:
            if re.match(r"--[a-z]", word) and not passes_on:
                assert word.partition("=")[0] in options, f"{page}: 'spear {line}' has no option {word}"
    for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", text):
        if not target.startswith(("http:", "https:")):
            assert ((source_directory / page).parent / target).exists(), f"{page}: the link {target} leads nowhere"
    for program in re.findall(r"^    (?:time )?(?:python )?((?:tools|tests|examples)/[\w/-]+(?:\.py)?)\b", text, re.MULTILINE):
        assert (source_directory / program).exists(), f"{page}: {program} is missing"
