# SPDX-License-Identifier: MIT
"""mypy --strict and pyright (strict) over every stub of a code base as large as the real engine, and over a program of 200 lines that uses it."""

from __future__ import annotations

import sys

import measure
import program_text
from subject import Subject


def test_program_is_long_and_states_types(subject: Subject) -> None:
    text = program_text.write(subject)
    assert text.count("\n") >= 200 and text.count("assert_type") >= 80
    for form in ("Future[", "list[", ".send_.", "= True"):
        assert form in text


def test_mypy_finds_no_error(environment: measure.Environment, subject: Subject) -> None:
    checked = measure.check_mypy(environment, subject)
    print(f"mypy: {checked.seconds:.1f} s, {checked.memory / measure.MIB:.0f} MiB")
    assert checked.code == 0, checked.output[-5000:]


def test_pyright_finds_no_error(environment: measure.Environment, subject: Subject) -> None:
    checked = measure.check_pyright(environment, subject)
    print(f"pyright: {checked.seconds:.1f} s, {checked.memory / measure.MIB:.0f} MiB")
    assert checked.code == 0, checked.output[-5000:]


def test_checkers_do_find_errors(environment: measure.Environment, subject: Subject) -> None:
    """The same checks report a wrong type and a name that does not exist: they do see the stubs."""
    function = subject.functions(1)[0]
    folder = environment.folder / "wrong"
    folder.mkdir()
    (folder / "pyrightconfig.json").write_text("{}", encoding="utf-8")
    (folder / "sample.py").write_text(
        f"from spear.unreal.{subject.module} import {subject.name}\n\n\ndef use(thing: {subject.name}) -> None:\n"
        f"    thing.{function.name}(NoSuchParameter=1)\n    thing.NoSuchMember\n    if thing.{subject.documented_properties(1)[0][0]}.get() == 1:\n        int(thing)\n", encoding="utf-8")
    commands = {
        "mypy": ["-m", "mypy", "--strict", "--python-executable", str(environment.python), "sample.py"],
        "pyright": ["-m", "pyright", "--pythonpath", str(environment.python), "sample.py"],
    }
    for name, command in commands.items():
        _, _, code, output = measure.run([sys.executable, *command], folder)
        assert code == 1 and "NoSuchParameter" in output and "NoSuchMember" in output, (name, output)
