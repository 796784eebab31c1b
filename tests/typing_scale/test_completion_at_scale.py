# SPDX-License-Identifier: MIT
"""Completion, hover and signature help in an editor (pyright's language server) over the stubs of a code base as large as the real engine."""

from __future__ import annotations

import json
import statistics

import measure
from subject import Subject


def test_code_base_is_as_large_as_promised(environment: measure.Environment, subject: Subject) -> None:
    classes = environment.schemas.main["classes"]
    assert sum(len(entity["functions"]) for entity in classes) >= 15_000
    assert sum(len(entity["properties"]) for kind in ("classes", "structs") for entity in environment.schemas.main[kind]) >= 55_000
    assert len(subject.inherited) >= 1_000
    assert max(file.stat().st_size for file in environment.files) <= 500_000


def test_every_member_is_offered(environment: measure.Environment, subject: Subject, answers: measure.Answers) -> None:
    """Functions and properties of all super classes, and the SDK's own; the same on async_."""
    unreal = unreal_names(environment, subject)
    for labels in (answers.labels, answers.asynchronous):
        missing = subject.members - {unreal.get(label, label.rstrip("_")) for label in labels} - labels
        assert not missing, f"{len(missing)} of {len(subject.members)} members are not offered: {sorted(missing)[:20]}"
    assert {"async_", "send_"} <= answers.labels


def unreal_names(environment: measure.Environment, subject: Subject) -> dict[str, str]:
    """Python's name -> Unreal's, where facts.json says that they differ."""
    names: dict[str, str] = {}
    for file in (environment.stubs / "unreal").glob("*/facts.json"):
        for entity in json.loads(file.read_text(encoding="utf-8"))["classes"].values():
            names.update(entity.get("names", {}))
    return names


def test_documentation_is_shown(subject: Subject, answers: measure.Answers) -> None:
    functions, properties = subject.functions(12), subject.documented_properties(4)
    assert len(functions) == 12 and len(properties) == 4
    for name, words in [(f.name, f.words) for f in functions] + properties:
        assert words in answers.hover_texts[name], answers.hover_texts[name]
        assert words in answers.documentation[name], answers.documentation[name]
    for function in functions:
        assert f"def {function.name}(" in answers.hover_texts[function.name].replace("\n", "")


def test_signature_help_names_the_parameters(subject: Subject, answers: measure.Answers) -> None:
    for function in subject.functions(12):
        expected = [parameter.python_name for parameter in function.signature.inputs if not parameter.keyword_only]
        assert [label for label in answers.parameters[function.name] if label not in ("*", "/")][: len(expected)] == expected


def test_sample_program_has_no_errors_in_the_editor(answers: measure.Answers) -> None:
    assert not answers.diagnostics, "\n".join(answers.diagnostics)


def test_first_answer_comes_within_5_seconds(environment: measure.Environment, subject: Subject, answers: measure.Answers) -> None:
    """The best of three starts, so that a moment when the machine is busy does not count."""
    times = [answers.start]
    while min(times) >= 5 and len(times) < 3:
        times.append(measure.first_answer(environment, subject))
    print(f"first answer: {', '.join(f'{time:.1f}' for time in times)} s")
    assert min(times) < 5


def test_answers_take_less_than_200_ms_once_warm(answers: measure.Answers) -> None:
    for what, times in (("completion while typing", answers.completions), ("hover", answers.hovers), ("signature help", answers.signatures)):
        assert statistics.median(times) < 0.2, f"{what}: median {statistics.median(times) * 1000:.0f} ms"


def test_server_needs_less_than_1500_mib(answers: measure.Answers) -> None:
    assert answers.memory < 1.5 * 1024 * measure.MIB, f"{answers.memory / measure.MIB:.0f} MiB"
