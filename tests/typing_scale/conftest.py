# SPDX-License-Identifier: MIT
"""The stubs of the embedded engine and of the large code base together, in an environment as a user has it."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

import measure  # noqa: E402
from subject import Subject  # noqa: E402

from spear.codegen.schema import SchemaSet  # noqa: E402


@pytest.fixture(scope="session")
def environment(scale_schema: Path, tmp_path_factory: pytest.TempPathFactory) -> measure.Environment:
    return measure.Environment(tmp_path_factory.mktemp("typing_scale"), SchemaSet.load_all([*measure.engine_schemas(), scale_schema]))


@pytest.fixture(scope="session")
def subject(environment: measure.Environment) -> Subject:
    return Subject(environment.schemas)


@pytest.fixture(scope="session")
def answers(environment: measure.Environment, subject: Subject) -> measure.Answers:
    return measure.ask(environment, subject)
