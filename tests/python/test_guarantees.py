# SPDX-License-Identifier: MIT
"""docs/guarantees.md names tests that exist."""

import re
from pathlib import Path


def test_every_test_that_the_page_of_guarantees_names_exists(source_directory: Path) -> None:
    page = (source_directory / "docs" / "guarantees.md").read_text()
    folders = {".cpp": source_directory / "tests" / "end_to_end", ".py": source_directory / "tests" / "python"}
    named = 0
    for cell in re.split(r"[|;]", page):
        file = re.search(r"`((?:sdk_|server_|test_)\w+(\.cpp|\.py))` (\".*)", cell)
        if not file:
            continue
        # A C++ compiler joins string literals, and so does this.
        text = re.sub(r'"\s*\n\s*"', "", (folders[file[2]] / file[1]).read_text())
        for name in re.findall(r'"([^"]+)"', file[3]):
            assert (f'TEST_CASE("{name}")' in re.sub(r"TEST_CASE\(\s+", "TEST_CASE(", text)) if file[2] == ".cpp" else (f"def {name}(" in text), f"{file[1]}: {name}"
            named += 1
    assert named > 60
