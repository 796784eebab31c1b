#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How an editor and type checkers fare with the stubs of a whole code base: completion, hover and signature help of pyright's language
server, and mypy --strict and pyright over every stub.

Examples:
  python tests/typing_scale/measure.py                                         the synthetic code base of tests/scale, as large as the real engine
  python tests/typing_scale/measure.py build/release/codegen/*/*.schema.json   the modules of this repository
  python tests/typing_scale/measure.py engine.json game.json --only completion --class AMyActor

Exit codes: 0 measured, and no checker found an error in the stubs; 1 one did.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
BUILD = Path(os.environ.get("SPEAR_BUILD_DIR", HERE.parent.parent / "build" / "release"))
for _place in (HERE, BUILD / "python"):
    if str(_place) not in sys.path:
        sys.path.insert(0, str(_place))

import program_text  # noqa: E402
import workspace  # noqa: E402
from language_server import LanguageServer  # noqa: E402
from subject import Subject  # noqa: E402

from spear.codegen.cli import emit  # noqa: E402
from spear.codegen.schema import SchemaSet  # noqa: E402

MIB = 1 << 20


@dataclass
class Environment:
    """A user's environment with the stubs of a code base in it."""

    folder: Path
    schemas: SchemaSet
    python: Path = field(init=False)
    stubs: Path = field(init=False)
    seconds: float = field(init=False)

    def __post_init__(self) -> None:
        self.python = workspace.make_environment(self.folder / "environment", BUILD / "python")
        self.stubs = workspace.site_packages(self.python) / "spear-stubs"
        started = time.perf_counter()
        emit("stubs", self.schemas, self.stubs / "unreal")
        self.seconds = time.perf_counter() - started
        (self.stubs / "py.typed").write_text("partial\n", encoding="utf-8")
        # pyright looks for every stub of the package among those of the stub package, once there is one.
        for file in (BUILD / "python" / "spear").glob("*.pyi"):
            shutil.copy(file, self.stubs / file.name)

    @property
    def files(self) -> list[Path]:
        return sorted(self.stubs.rglob("*.pyi"))


@dataclass
class Answers:
    """What the language server said, and how long it took (seconds)."""

    start: float  # process start to the first completion answer
    first: float  # document opened to the first completion answer
    processor: float  # processor time of the server until then
    completions: list[float]  # warm, each after a change of the text, as when typing
    repeated: list[float]  # warm, text unchanged
    hovers: list[float]
    signatures: list[float]
    memory: int
    labels: set[str]
    #: label -> documentation of the resolved completion item
    documentation: dict[str, str]
    hover_texts: dict[str, str]
    #: function -> labels of its parameters
    parameters: dict[str, list[str]]
    asynchronous: set[str]
    diagnostics: list[str]


def ask(environment: Environment, subject: Subject, rounds: int = 3) -> Answers:
    """Does in an editor what a user does who explores an object: types, picks, looks."""
    folder = environment.folder / "workspace"
    folder.mkdir(exist_ok=True)
    (folder / "pyrightconfig.json").write_text("{}", encoding="utf-8")  # else one of a parent folder counts
    file = folder / "program.py"
    head = f"from spear.unreal.{subject.module} import {subject.name}\n\n\ndef explore(thing: {subject.name}) -> None:\n"

    def text(line: str) -> str:
        return f"{head}    {line}\n"

    row = 4
    with LanguageServer(folder, environment.python) as server:
        opened = time.perf_counter()
        server.open(file, text("thing."))
        items = server.completion(file, row, 4 + len("thing."))
        now = time.perf_counter()
        start, first, processor = now - server.started, now - opened, server.processor_seconds()
        labels = {item["label"] for item in items}

        repeated = [timed(lambda: server.completion(file, row, 4 + len("thing."))) for _ in range(10)]
        functions, properties = subject.functions(12), subject.documented_properties(4)
        completions = []
        for function in functions * rounds:
            for length in range(0, 3):
                line = "thing." + function.name[:length]
                server.change(file, text(line))
                completions.append(timed(lambda line=line: server.completion(file, row, 4 + len(line))))  # type: ignore[misc]
        server.change(file, text("thing."))
        items = server.completion(file, row, 4 + len("thing."))
        documentation = {}
        for name in [f.name for f in functions] + [name for name, _ in properties]:
            item = next((item for item in items if item["label"] == name), None)
            if item is not None:
                documentation[name] = server.resolve(item).get("documentation", {}).get("value", "")

        hovers: list[float] = []
        signatures: list[float] = []
        hover_texts: dict[str, str] = {}
        parameters: dict[str, list[str]] = {}
        for _ in range(rounds):
            for function in functions:
                line = f"thing.{function.name}("
                server.change(file, text(line + ")"))
                hovers.append(timed(lambda: hover_texts.__setitem__(function.name, server.hover(file, row, 4 + len("thing.") + 1))))
                answer: dict[str, Any] = {}
                signatures.append(timed(lambda: answer.update(server.signature_help(file, row, 4 + len(line)) or {})))
                if answer.get("signatures"):
                    shown = answer["signatures"][answer.get("activeSignature") or 0]
                    parameters[function.name] = [_parameter_label(shown["label"], parameter["label"]) for parameter in shown["parameters"]]
            for name, _ in properties:
                server.change(file, text(f"thing.{name}"))
                hovers.append(timed(lambda: hover_texts.__setitem__(name, server.hover(file, row, 4 + len("thing.") + 1))))
        server.change(file, text("thing.async_."))
        asynchronous = {item["label"] for item in server.completion(file, row, 4 + len("thing.async_."))}

        sample = folder / "sample.py"
        server.open(sample, program_text.write(subject))
        diagnostics = [f"{d['range']['start']['line'] + 1}: {d['message']}" for d in server.wait_for_diagnostics(sample) if d.get("severity", 1) <= 2]
        memory = server.memory()
    return Answers(
        start, first, processor, completions, repeated, hovers, signatures, memory, labels, documentation, hover_texts, parameters, asynchronous, diagnostics,
    )


def first_answer(environment: Environment, subject: Subject) -> float:
    """Seconds from the start of a new server to its first completion answer."""
    folder = environment.folder / "workspace"
    file = folder / "first.py"
    with LanguageServer(folder, environment.python) as server:
        server.open(file, f"from spear.unreal.{subject.module} import {subject.name}\n\n\ndef explore(thing: {subject.name}) -> None:\n    thing.\n")
        assert server.completion(file, 4, 4 + len("thing."))
        return time.perf_counter() - server.started


def _parameter_label(signature: str, label: str | list[int]) -> str:
    text = signature[label[0]:label[1]] if isinstance(label, list) else label
    return text.split(":")[0].split("=")[0].strip()


def timed(action: Callable[[], object]) -> float:
    started = time.perf_counter()
    action()
    return time.perf_counter() - started


@dataclass
class Checked:
    """The run of a type checker."""

    seconds: float
    memory: int
    code: int
    output: str
    summary: str


def run(command: list[str], folder: Path) -> tuple[float, int, int, str]:
    """Runs a program; its time, the largest resident memory of it or a child, its exit code and output."""
    with tempfile.TemporaryFile("w+") as output:
        started = time.perf_counter()
        process = subprocess.Popen(command, cwd=folder, stdout=output, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.perf_counter() - started
        output.seek(0)
        return seconds, usage.ru_maxrss * 1024, process.returncode, output.read()


def check_mypy(environment: Environment, subject: Subject) -> Checked:
    """mypy --strict over every stub and the sample program, without a cache."""
    folder = environment.folder / "mypy"
    folder.mkdir(exist_ok=True)
    sample = folder / "sample.py"
    sample.write_text(program_text.write(subject), encoding="utf-8")
    modules = [f"spear.unreal.{module.name}" for module in environment.schemas.main_modules]
    command = [sys.executable, "-m", "mypy", "--strict", "--python-executable", str(environment.python), "--cache-dir", os.devnull, "--no-incremental"]
    packages = [part for module in modules for part in ("-p", module)]
    seconds, memory, code, output = run([*command, *packages], folder)
    more = run([*command, "sample.py"], folder)
    summary = output.strip().splitlines()[-1] if output.strip() else ""
    return Checked(seconds, max(memory, more[1]), code or more[2], output + more[3], summary)


def check_pyright(environment: Environment, subject: Subject) -> Checked:
    """pyright, strict, over every stub and the sample program.

    pyright checks no files of installed packages, so here the package with these stubs is the project.
    """
    folder = environment.folder / "pyright"
    if not folder.is_dir():
        package = BUILD / "python" / "spear"
        shutil.copytree(package, folder / "spear", ignore=lambda place, names: [name for name in names if Path(place) == package and name == "unreal"])
        shutil.copytree(environment.stubs / "unreal", folder / "spear" / "unreal", copy_function=os.link)
    (folder / "sample.py").write_text(program_text.write(subject), encoding="utf-8")
    (folder / "pyrightconfig.json").write_text(json.dumps({"include": ["spear/unreal", "sample.py"], "typeCheckingMode": "strict"}), encoding="utf-8")
    seconds, memory, code, output = run([sys.executable, "-m", "pyright", "--pythonpath", sys.executable, "-p", str(folder)], folder)
    return Checked(seconds, memory, code, output, output.strip().splitlines()[-1] if output.strip() else "")


def full_scale(folder: Path) -> list[Path]:
    """The schemas of the embedded engine and of the large synthetic code base, which is made and dumped for it."""
    print("making and dumping the synthetic code base", file=sys.stderr)
    subprocess.run([sys.executable, str(HERE.parent / "scale" / "make_code_base.py"), "-o", str(folder / "code_base")], check=True, stdout=subprocess.DEVNULL)
    schema = folder / "scale.schema.json"
    program = BUILD / "bin" / "spear-header-tool"
    subprocess.run([str(program), "dump", "--quiet", "--no-cache", "--module", str(folder / "code_base" / "Source"), "--output", str(schema)], check=True)
    return [*engine_schemas(), schema]


def engine_schemas() -> list[Path]:
    """Those of the embedded engine, as the build dumped them."""
    return [BUILD / "codegen" / name / f"{name}.schema.json" for name in ("CoreUObject", "Engine", "SpearServer")]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("schema", nargs="*", type=Path, help="schemas that together hold everything (default: the synthetic code base and the embedded engine)")
    parser.add_argument("--class", dest="name", default="", help="class to explore (default: that with the most inherited members)")
    parser.add_argument("--only", choices=("completion", "mypy", "pyright"), action="append", help="only this part (repeatable)")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="folder for environment and stubs; kept")
    options = parser.parse_args()
    parts = options.only or ["completion", "mypy", "pyright"]
    folder = options.keep or Path(tempfile.mkdtemp(prefix="spear-typing-"))
    folder.mkdir(parents=True, exist_ok=True)
    failed = False
    try:
        schemas = SchemaSet.load_all(options.schema or full_scale(folder))
        environment = Environment(folder.resolve(), schemas)
        subject = Subject(schemas, options.name)
        sizes = [file.stat().st_size for file in environment.files]
        row("stubs", f"{len(sizes)} files, {sum(sizes) / MIB:.1f} MiB, largest {max(sizes) / 1000:.0f} KB, written in {environment.seconds:.1f} s")
        row("class", f"{subject.name} with {len(subject.inherited)} inherited members")
        if "completion" in parts:
            answers = ask(environment, subject)
            detail = f"{answers.first:.2f} s after opening the file, {answers.processor:.2f} s of processor time"
            row("first completion", f"{answers.start:.2f} s after process start ({detail}), {len(answers.labels)} items")
            rows = {"completion, typing": answers.completions, "completion, again": answers.repeated, "hover": answers.hovers, "signature help": answers.signatures}
            for title, times in rows.items():
                row(title, f"median {statistics.median(times) * 1000:.0f} ms, worst {max(times) * 1000:.0f} ms of {len(times)}")
            row("memory of the server", f"{answers.memory / MIB:.0f} MiB")
            failed |= bool(answers.diagnostics)
            for line in answers.diagnostics[:10]:
                row("sample program", line)
        for name, check in (("mypy", check_mypy), ("pyright", check_pyright)):
            if name in parts:
                checked = check(environment, subject)
                row(f"{name} --strict" if name == "mypy" else "pyright strict", f"{checked.summary}: {checked.seconds:.1f} s, {checked.memory / MIB:.0f} MiB")
                if checked.code:
                    failed = True
                    print("\n".join(checked.output.splitlines()[:40]))
    finally:
        if options.keep is None:
            shutil.rmtree(folder)
    return int(failed)


def row(title: str, text: str) -> None:
    print(f"{title:<22} {text}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
