# SPDX-License-Identifier: MIT
"""A part of a trace as a picture: what client and engine do at the same time, frame by frame. Needs Pillow."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass

from spear.trace import Recorded, Span, is_frame

WIDTH, LEFT, RIGHT = 1800, 190, 24
LANE, GAP, TOP = 46, 14, 96
INK, FAINT, PAPER, GRID = (34, 38, 46), (120, 126, 138), (255, 255, 255), (226, 229, 235)
TRANSACTIONS = ((66, 133, 214), (226, 122, 46), (64, 158, 98), (148, 96, 190))
"""Colours of transactions, in turn: the same for the client's blocks and the engine's work."""
TICK, IDLE, WAIT, HELD = (188, 196, 208), (241, 243, 246), (246, 240, 222), (214, 48, 49)


@dataclass
class _Lane:
    label: str
    spans: list[Span]


def draw(recorded: Recorded, file: str | os.PathLike[str], frames: int = 5, first_frame: int | None = None) -> None:
    """Draws so many consecutive frames, by default from the middle of the trace, into a PNG file.

    ``first_frame`` is the engine's number of the first one to show. Raises ValueError if the trace has no frames, or not that one.
    """
    game_threads = recorded.game_threads()
    if not game_threads:
        raise ValueError("The trace has no frames of an engine: there is nothing to draw.")
    game = game_threads[0]
    all_frames = [span for span in recorded.of_thread(*game) if is_frame(span)]
    numbers = [span.arguments["frame"] for span in all_frames]
    if first_frame is not None and first_frame not in numbers:
        raise ValueError(f"The trace has no frame {first_frame}; it has {numbers[0]} to {numbers[-1]}.")
    start = max(0, (len(all_frames) - frames) // 2) if first_frame is None else numbers.index(first_frame)
    shown = all_frames[start:start + frames]
    margin = 0.04 * (shown[-1].end - shown[0].begin)
    _Picture(recorded, game, shown, shown[0].begin - margin, shown[-1].end + margin).save(file)


class _Picture:
    def __init__(self, recorded: Recorded, game: tuple[int, int], frames: list[Span], begin: float, end: float) -> None:
        from PIL import Image, ImageDraw, ImageFont

        self.begin, self.end = begin, end
        self.lanes = _lanes(recorded, game, begin, end)
        height = TOP + len(self.lanes) * (LANE + GAP) + 74
        self.image = Image.new("RGB", (WIDTH, height), PAPER)
        self.paint = ImageDraw.Draw(self.image)
        self.font, self.small, self.large = (ImageFont.load_default(size) for size in (16, 14, 22))
        self.paint.text((LEFT, 16), "Client and engine, frame by frame", fill=INK, font=self.large)
        milliseconds = (frames[-1].end - frames[0].begin) / 1000
        first, last = frames[0].arguments["frame"], frames[-1].arguments["frame"]
        held = sum(span.duration for lane in self.lanes for span in lane.spans if span.name == "waiting for client") / 1000
        self.paint.text(
            (LEFT, 48), f"frames {first} to {last}, {milliseconds:.2f} ms; the game thread waits for clients for {held:.2f} ms of it", fill=FAINT, font=self.font
        )
        self._axis(TOP, height - 66)
        self.middles: dict[tuple[str, int, int], tuple[float, float, float]] = {}
        for number, lane in enumerate(self.lanes):
            y = TOP + number * (LANE + GAP)
            for row, part in enumerate(lane.label.split("\n")):
                self.paint.text((14, y + 4 + 20 * row), part, fill=INK if row == 0 else FAINT, font=self.font if row == 0 else self.small)
            for span in lane.spans:
                self._span(span, y)
        self._arrows()
        self._legend(height - 34)

    def save(self, file: str | os.PathLike[str]) -> None:
        self.image.save(file, format="PNG")

    def _x(self, time: float) -> float:
        return LEFT + (min(max(time, self.begin), self.end) - self.begin) / (self.end - self.begin) * (WIDTH - LEFT - RIGHT)

    def _axis(self, top: float, bottom: float) -> None:
        span = (self.end - self.begin) / 1000
        step = 10 ** math.floor(math.log10(span / 5))
        step = next(step * factor for factor in (1, 2, 5, 10) if span / (step * factor) <= 12)
        digits = max(0, -math.floor(math.log10(step)))
        for tick in range(math.ceil(span / step)):
            x = self._x(self.begin + tick * step * 1000)
            self.paint.line((x, top - 6, x, bottom), fill=GRID)
            self.paint.text((x, bottom + 4), f"{tick * step:.{digits}f}" + (" ms" if tick == 0 else ""), fill=FAINT, font=self.small, anchor="ma")

    def _span(self, span: Span, y: float) -> None:
        left, right = self._x(span.begin), self._x(span.end)
        colour, inset, text = _look(span)
        box = (left, y + inset, max(right, left + 1), y + LANE - inset)
        self.paint.rectangle(box, fill=colour, outline=FAINT if span.name in ("idle", "wait for frame") or is_frame(span) else None)
        dark = sum(colour) > 420
        for words in (text, text.split(" ")[-1]):
            if words and self.paint.textlength(words, font=self.small) + 6 < right - left:
                self.paint.text(((left + right) / 2, y + LANE / 2), words, fill=INK if dark else PAPER, font=self.small, anchor="mm")
                break
        session, transaction = span.arguments.get("session"), span.arguments.get("transaction")
        if session is not None and transaction is not None:
            self.middles.setdefault((span.name, session, transaction), (left, right, y))

    def _arrows(self) -> None:
        """From a block of the client to its work in the engine."""
        for (name, session, transaction), (_, right, y) in self.middles.items():
            target = {"begin_frame block": "begin work", "end_frame block": "end work"}.get(name)
            found = self.middles.get((target, session, transaction)) if target else None
            if found:
                colour = TRANSACTIONS[transaction % len(TRANSACTIONS)]
                self.paint.line((right, y + LANE, found[0], found[2]), fill=colour, width=1)

    def _legend(self, y: float) -> None:
        x: float = LEFT
        entries = [
            (TRANSACTIONS[0], "a transaction's blocks, and their work in the engine (one colour each)"), (TICK, "world tick"),
            (IDLE, "idle: keeps the frame rate"), (WAIT, "client waits for a frame or a result"), (HELD, "game thread waits for a client"),
        ]
        for colour, text in entries:
            self.paint.rectangle((x, y, x + 18, y + 16), fill=colour, outline=FAINT)
            self.paint.text((x + 25, y + 8), text, fill=INK, font=self.small, anchor="lm")
            x += 25 + self.paint.textlength(text, font=self.small) + 26


def _look(span: Span) -> tuple[tuple[int, int, int], int, str]:
    """Colour, how much lower than its lane, and text."""
    if is_frame(span):
        return PAPER, 4, span.name
    if span.name in ("begin_frame block", "end_frame block", "begin work", "end work"):
        number = span.arguments["transaction"]
        return TRANSACTIONS[number % len(TRANSACTIONS)], 4, f"{span.name.split('_')[0].split(' ')[0]} {number}"
    special = {"world tick": (TICK, 8), "idle": (IDLE, 8), "waiting for client": (HELD, 8), "wait for frame": (WAIT, 8), "wait for result": (WAIT, 8)}
    colour, inset = special.get(span.name, (FAINT, 14))
    return colour, inset, span.name if span.name in special else ""


def _lanes(recorded: Recorded, game: tuple[int, int], begin: float, end: float) -> list[_Lane]:
    """Clients' threads that have blocks, then the engine's server threads, its frames, and its game thread."""
    lanes = []
    seen = [span for span in recorded.spans if span.end > begin and span.begin < end]
    clients = sorted({(span.process, span.thread) for span in seen if span.category == "client"})
    busy = [key for key in clients if any(span.name.endswith("block") for span in recorded.of_thread(*key))]
    for key in busy or clients[:1]:
        name = recorded.threads.get(key, "")
        lanes.append(_Lane(f"client\n{name}", [span for span in seen if (span.process, span.thread) == key]))
    server = sorted({(span.process, span.thread) for span in seen if span.category == "server" and (span.process, span.thread) != game})
    for key in server:
        lanes.append(_Lane(f"engine\n{recorded.threads.get(key, '')}", [span for span in seen if (span.process, span.thread) == key]))
    own = [span for span in seen if (span.process, span.thread) == game and span.category == "game"]
    lanes.append(_Lane("engine\nframes", [span for span in own if is_frame(span)]))
    lanes.append(_Lane("engine\ngame thread", [span for span in own if not is_frame(span)]))
    return lanes
