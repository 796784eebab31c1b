# SPDX-License-Identifier: MIT
"""Traces: record them (:class:`Trace`), read them, and say what they show (:func:`summarise`).

A trace file is in Chrome's trace event format: ui.perfetto.dev and chrome://tracing open it. `spear trace` is the command line of this
module, :mod:`spear.trace_picture` draws a part of a trace.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, NamedTuple

from spear import _native

if TYPE_CHECKING:
    from typing_extensions import Self


class Trace:
    """A recording of this program and of its engine; a context manager that :meth:`spear.Instance.trace` gives.

    The file is written by :meth:`stop`, or at the end of the ``with`` block. One recording at a time in each process and each engine.
    """

    def __init__(self, session: _native.Session, file: str | os.PathLike[str], operations: bool, events_per_thread: int) -> None:
        self.file = Path(file)
        self._recording = _native.Trace(session, os.fspath(file), operations, events_per_thread)

    def stop(self) -> None:
        """Ends the recording and writes the file. Stopping twice is harmless. Raises UnknownObject if another client has started a recording
        in the engine meanwhile: the file then has this program alone."""
        self._recording.stop()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.stop()


class Span(NamedTuple):
    """Something that took time. Times are microseconds since the beginning of the trace."""

    name: str
    category: str
    process: int
    thread: int
    begin: float
    end: float
    arguments: Mapping[str, Any]

    @property
    def duration(self) -> float:
        """Microseconds."""
        return self.end - self.begin


@dataclass
class Recorded:
    """The contents of a trace file."""

    spans: list[Span]
    """By thread and time; outer spans before those within them."""
    threads: dict[tuple[int, int], str]
    """Names, by process and thread."""
    processes: dict[int, str]
    dropped: int
    """Events that found no room in their thread's buffer."""

    def of_thread(self, process: int, thread: int) -> list[Span]:
        """The spans of one thread."""
        return [span for span in self.spans if (span.process, span.thread) == (process, thread)]

    def game_threads(self) -> list[tuple[int, int]]:
        """The threads that run frames, one for each engine."""
        return sorted({(span.process, span.thread) for span in self.spans if is_frame(span)})


def is_frame(span: Span) -> bool:
    """Whether the span is an engine's frame."""
    return span.category == "game" and "frame" in span.arguments


def read(file: str | os.PathLike[str]) -> Recorded:
    """Reads a trace file of ours. Raises ValueError if it is none."""
    import json  # `import spear` stays quick

    try:
        document = json.loads(Path(file).read_text(encoding="utf-8"))
        events = document["traceEvents"]
    except (ValueError, KeyError, TypeError) as error:
        raise ValueError(f"{os.fspath(file)} is no trace: {error}") from error
    spans = [
        Span(event["name"], event["cat"], event["pid"], event["tid"], event["ts"], round(event["ts"] + event["dur"], 3), event["args"])
        for event in events if event["ph"] == "X"
    ]
    spans.sort(key=lambda span: (span[2], span[3], span[4], -span[5]))
    names = [event for event in events if event["ph"] == "M"]
    return Recorded(
        spans,
        {(event["pid"], event["tid"]): event["args"]["name"] for event in names if event["name"] == "thread_name"},
        {event["pid"]: event["args"]["name"] for event in names if event["name"] == "process_name"},
        document["otherData"]["dropped_events"],
    )


def merge(files: Iterable[str | os.PathLike[str]], output: str | os.PathLike[str]) -> None:
    """Makes one trace of several that were recorded on one machine."""
    import json

    documents = [json.loads(Path(file).read_text(encoding="utf-8")) for file in files]
    base = min(document["otherData"]["clock_base_ns"] for document in documents)
    events = []
    for number, document in enumerate(documents):
        shift = (document["otherData"]["clock_base_ns"] - base) / 1000
        for event in document["traceEvents"]:
            if "ts" in event:
                event["ts"] = round(event["ts"] + shift, 3)
            if "id" in event:
                event["id"] = f"{number}.{event['id']}"
            events.append(event)
    dropped = sum(document["otherData"]["dropped_events"] for document in documents)
    merged = {"displayTimeUnit": "ms", "traceEvents": events, "otherData": {"clock_base_ns": base, "dropped_events": dropped}}
    Path(output).write_text(json.dumps(merged, separators=(",", ":")) + "\n", encoding="utf-8")


@dataclass
class Summary:
    """What the game thread of one engine did. Times are milliseconds."""

    engine: str
    frames: int
    seconds: float
    """From the beginning of the first frame to the end of the last."""
    transactions: int
    """Whose begin work and end work are in the trace."""
    milliseconds: dict[str, float]
    """In world ticks, begin work, end work, waiting for clients (the gap), idle to keep the frame rate, and the rest."""

    @property
    def frame_rate(self) -> float:
        """Frames per second."""
        return self.frames / self.seconds if self.seconds else 0.0


def summarise(recorded: Recorded) -> list[Summary]:
    """One summary for each engine in the trace. Waiting within begin or end work counts as waiting alone."""
    summaries = []
    for process, thread in recorded.game_threads():
        times = dict.fromkeys(("world tick", "begin work", "end work", "waiting for client", "idle"), 0.0)
        spans = recorded.of_thread(process, thread)
        frames = [span for span in spans if is_frame(span)]
        begun: set[tuple[int, int]] = set()
        ended: set[tuple[int, int]] = set()
        work: Span | None = None
        for span in spans:
            if span.category != "game" or span.name not in times:
                continue
            times[span.name] += span.duration / 1000
            if span.name in ("begin work", "end work"):
                work = span
                (begun if span.name == "begin work" else ended).add((span.arguments["session"], span.arguments["transaction"]))
            elif span.name == "waiting for client" and work and span.begin < work.end:
                times[work.name] -= span.duration / 1000
        total = (max(frame.end for frame in frames) - min(frame.begin for frame in frames)) / 1000
        times["other"] = max(0.0, total - sum(times.values()))
        summaries.append(Summary(recorded.processes.get(process, str(process)), len(frames), total / 1000, len(begun & ended), times))
    return summaries


def describe(summaries: Iterable[Summary], dropped: int) -> str:
    """The summaries as a table for people."""
    lines = []
    for summary in summaries:
        lines.append(f"{summary.engine}: {summary.frames} frames in {summary.seconds:.2f} s, {summary.frame_rate:.1f} per second, {summary.transactions} transactions")
        lines.append(f"  {'game thread':<22} {'ms':>10} {'% of time':>10} {'us a frame':>12}")
        names = {"waiting for client": "waiting for clients", "idle": "idle (frame rate)"}
        for name, milliseconds in summary.milliseconds.items():
            share = 100 * milliseconds / (summary.seconds * 1000) if summary.seconds else 0.0
            lines.append(f"  {names.get(name, name):<22} {milliseconds:>10.2f} {share:>10.2f} {milliseconds * 1000 / summary.frames:>12.1f}")
    if not lines:
        lines.append("No frame of an engine is in the trace.")
    if dropped:
        lines.append(f"{dropped} events found no room and were dropped: record for a shorter time, or without --operations.")
    return "\n".join(lines)
