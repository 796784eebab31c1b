#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the reference: time to write it, its size, broken links, and how fast its search answers in headless Chromium.

examples:
  measure.py schema.json                               # writes the site to a folder that is removed afterwards
  measure.py Core.schema.json Engine.schema.json Game.schema.json --site /tmp/site --json

Exit codes: 0 measured, 1 a link is broken, a page complained, or the search was slower than 50 ms (median of all keys).
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import statistics
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

sys.path[:0] = [str(Path(__file__).resolve().parents[2] / "codegen"), str(Path(__file__).parent)]

from browser import Browser, find_chromium  # noqa: E402
from emit import reference  # noqa: E402
from emit.schema import SchemaSet  # noqa: E402
from pages import broken_links, read_site  # noqa: E402

#: Typed character by character: rare and frequent words, humps, several words, members of a type, nothing.
QUERIES = ("setactorlocation", "SetAcSc", "actor location", "AActor.Set", "e", "getrel", "vector", "xyzzy", "b")
ROUNDS = 5
LIMIT_MS = 50.0


def _cpu() -> float:
    return sum(u.ru_utime + u.ru_stime for u in (resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)))


def _write(schemas: list[Path], folder: Path, jobs: int) -> dict[str, Any]:
    began, cpu = time.perf_counter(), _cpu()
    loaded = SchemaSet.load_all(schemas)
    read = time.perf_counter() - began
    output = reference.emit(loaded, folder, jobs=jobs, progress=True)
    files = [path for path in folder.rglob("*") if path.is_file()]
    pages = [path for path in files if path.suffix == ".html"]
    largest = max(pages, key=lambda path: path.stat().st_size)
    return {
        "schema_read_s": read, "write_s": time.perf_counter() - began, "cpu_s": _cpu() - cpu, "load_average": os.getloadavg()[0], "files": len(files), "changed": output.changed,
        "functions": sum(len(c["functions"]) for c in loaded.classes.values()),
        "properties": sum(len(e["properties"]) for kind in (loaded.classes, loaded.structs) for e in kind.values()),
        "site_mb": sum(path.stat().st_size for path in files) / 1e6, "largest_page": f"{largest.relative_to(folder)} {largest.stat().st_size / 1e3:.0f} kB",
        "index_names_mb": (folder / "assets" / "search-names.js").stat().st_size / 1e6,
        "index_summaries_mb": sum(path.stat().st_size for path in folder.glob("assets/search-summaries-*.js")) / 1e6,
    }


def _browse(folder: Path, largest: str) -> dict[str, Any]:
    with Browser() as browser:
        browser.open(folder / "index.html")
        loading = browser.run("new Promise(done => { const began = performance.now(); document.getElementById('ui-search').focus();"
                              " const look = () => typeof spearSearch === 'object' && spearSearch.size ? done(performance.now() - began) : setTimeout(look, 2); look(); })")
        size = browser.run("spearSearch.size")
        times: dict[str, list[float]] = {}
        for _ in range(ROUNDS):
            for query in QUERIES:
                browser.run("document.getElementById('ui-search').value = ''")
                for end, character in enumerate(query, 1):
                    browser.type(character)
                    times.setdefault(query[:end], []).append(float(browser.run("document.getElementById('ui-results').dataset.milliseconds")))
        slowest = max(times, key=lambda query: min(times[query]))
        everything = sorted(value for values in times.values() for value in values)
        browser.open(folder / largest)
        timing = browser.run("(() => { const t = performance.getEntriesByType('navigation')[0]; return t.loadEventEnd - t.startTime; })()")
        return {
            "names": size, "index_load_ms": loading, "search_median_ms": statistics.median(everything), "search_p95_ms": everything[int(len(everything) * 0.95)],
            "slowest_query": slowest, "slowest_query_best_ms": min(times[slowest]), "largest_page_load_ms": timing, "problems": browser.problems,
        }


def main() -> int:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0], epilog=__doc__.split("\n\n", 1)[1], formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("schemas", type=Path, nargs="+", metavar="SCHEMA")
    parser.add_argument("--site", type=Path, help="where to write it, and leave it (default: a folder that is removed)")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="processes (default: one per core)")
    parser.add_argument("--json", action="store_true", help="print JSON")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="spear-reference-") as temporary:
        folder = options.site or Path(temporary) / "site"
        figures = _write(options.schemas, folder, options.jobs)
        broken = broken_links(read_site(folder))
        figures["broken_links"] = len(broken)
        if find_chromium():
            figures |= _browse(folder, figures["largest_page"].partition(" ")[0])
    if options.json:
        print(json.dumps(figures, indent=1))
    else:
        for name, value in figures.items():
            print(f"{name:26} {f'{value:.2f}' if isinstance(value, float) else value}")
    for link in broken[:20]:
        print(f"broken: {link}", file=sys.stderr)
    return 1 if broken or figures.get("problems") or figures.get("search_median_ms", 0) > LIMIT_MS else 0


if __name__ == "__main__":
    sys.exit(main())
