# SPDX-License-Identifier: MIT
"""Writing generated files: only what changed, never half a file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass
class Output:
    """Counts what was written below a directory."""

    directory: Path
    total: int = 0
    changed: int = 0

    def write(self, name: str, text: str) -> None:
        """Writes a file unless it holds that text already; its time stays the same then, so that nothing is compiled again."""
        path = self.directory / name
        self.total += 1
        data = text.encode("utf-8")
        if path.exists() and path.read_bytes() == data:
            return
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary = path.with_name(path.name + ".new")
        temporary.write_bytes(data)
        temporary.replace(path)
        self.changed += 1
