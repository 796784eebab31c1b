# SPDX-License-Identifier: MIT
"""Work on all cores: the same function on many items, in forked processes that share the schemas already read."""

from __future__ import annotations

import gc
import multiprocessing
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")

#: What the forked processes work on; set just before the fork, so nothing is sent to them but an index.
_work: Callable[[Any], Any] | None = None
_items: Sequence[Any] = ()


def for_each(items: Sequence[Item], work: Callable[[Item], Result], *, jobs: int = 0, progress: bool = False, title: str = "") -> list[Result]:
    """``[work(item) for item in items]``, on ``jobs`` processes (0: one per core), with a progress bar if that is a terminal.

    Results come in the order of the items. ``work`` may be any callable, also a closure; what it returns must be picklable.
    An exception of ``work`` ends everything and is raised here.
    """
    global _work, _items
    jobs = min(jobs or len(os.sched_getaffinity(0)), len(items))
    with _bar(len(items), title, progress) as advance:
        if jobs <= 1:
            results = []
            for item in items:
                results.append(work(item))
                advance()
            return results
        _work, _items = work, items
        gc.collect()
        gc.freeze()  # so that collections in the processes do not copy the memory they share
        try:
            with multiprocessing.get_context("fork").Pool(jobs, initializer=gc.freeze) as pool:
                results = []
                for result in pool.imap(_run, range(len(items))):
                    results.append(result)
                    advance()
                return results
        finally:
            gc.unfreeze()
            _work, _items = None, ()


def _run(index: int) -> Any:
    assert _work is not None
    return _work(_items[index])


@contextmanager
def _bar(total: int, title: str, progress: bool) -> Iterator[Callable[[], object]]:
    if not (progress and sys.stderr.isatty()):
        yield lambda: None
        return
    from tqdm import tqdm  # type: ignore[import-untyped]

    with tqdm(total=total, desc=title or None, unit="", leave=False, dynamic_ncols=True) as bar:
        yield bar.update
