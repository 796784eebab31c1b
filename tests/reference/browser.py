# SPDX-License-Identifier: MIT
"""Headless Chromium for the tests of the reference, driven through its DevTools protocol over a pipe. Needs nothing but Chromium."""

from __future__ import annotations

import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any

#: Keys by their name in DOM events: (code, Windows key code).
_KEYS = {"Enter": ("Enter", 13), "Escape": ("Escape", 27), "ArrowDown": ("ArrowDown", 40), "ArrowUp": ("ArrowUp", 38), "Tab": ("Tab", 9), "/": ("Slash", 191), "Backspace": ("Backspace", 8)}


def find_chromium() -> str | None:
    """The browser's program, or None."""
    return next((path for name in ("chromium", "chromium-browser", "google-chrome") if (path := shutil.which(name))), None)


class BrowserError(Exception):
    """The browser said no, did not answer, or a script threw."""


class Browser:
    """One browser with one page. Everything that the page's console says, and every exception, is kept in ``problems``."""

    def __init__(self, width: int = 1280, height: int = 900, answer_timeout: float = 120.0) -> None:
        program = find_chromium()
        if program is None:
            raise BrowserError("Chromium is not installed")
        self.answer_timeout = answer_timeout
        self.problems: list[str] = []
        self._events: list[dict[str, Any]] = []
        self._number = 0
        self._buffer = b""
        self._profile = tempfile.mkdtemp(prefix="spear-browser-")
        to_child, self._write = os.pipe()
        self._read, from_child = os.pipe()

        def connect() -> None:  # in the child: Chromium reads commands from descriptor 3 and writes answers to 4
            ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 16) for end in (to_child, from_child)]
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)
            os.close(ends[0])
            os.close(ends[1])

        self._process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--disable-background-networking", "--no-first-run", "--hide-scrollbars",
             f"--user-data-dir={self._profile}", "--remote-debugging-pipe", "about:blank"],
            preexec_fn=connect, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_child)
        os.close(from_child)
        try:
            page = next(target for target in self._command("Target.getTargets")["targetInfos"] if target["type"] == "page")
            self._session = self._command("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
            for domain in ("Page", "Runtime", "Log", "Network"):
                self.command(f"{domain}.enable")
            self.command("Emulation.setFocusEmulationEnabled", enabled=True)
            self.resize(width, height)
        except BaseException:
            self.close()
            raise

    # Protocol ---------------------------------------------------------------------------------------------------------------

    def command(self, method: str, **parameters: Any) -> dict[str, Any]:
        """One command to the page; gives its result."""
        return self._command(method, self._session, **parameters)

    def _command(self, method: str, session: str | None = None, **parameters: Any) -> dict[str, Any]:
        self._number += 1
        number = self._number
        message: dict[str, Any] = {"id": number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + self.answer_timeout
        while True:
            answer = self._receive(deadline)
            if answer is None:
                raise BrowserError(f"no answer to {method} within {self.answer_timeout} s")
            if answer.get("id") == number:
                if "error" in answer:
                    raise BrowserError(f"{method}: {answer['error']}")
                result: dict[str, Any] = answer["result"]
                return result
            self._note(answer)

    def _receive(self, deadline: float) -> dict[str, Any] | None:
        while b"\0" not in self._buffer:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self._read], [], [], left)[0]:
                return None
            data = os.read(self._read, 1 << 20)
            if not data:
                raise BrowserError(f"Chromium has closed the pipe; its exit code is {self._process.wait(10)}")
            self._buffer += data
        line, _, self._buffer = self._buffer.partition(b"\0")
        message: dict[str, Any] = json.loads(line)
        return message

    def _note(self, event: dict[str, Any]) -> None:
        method, parameters = event.get("method"), event.get("params", {})
        if method == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.problems.append(f"exception: {details.get('exception', {}).get('description', details['text'])}")
        elif method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
            self.problems.append(f"console.{parameters['type']}: {[a.get('value', a.get('description')) for a in parameters['args']]}")
        elif method == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            self.problems.append(f"log: {parameters['entry']['text']} ({parameters['entry'].get('url', '')})")
        elif method == "Network.requestWillBeSent":
            self._events.append(event)

    # What a user does ----------------------------------------------------------------------------------------------------------

    def resize(self, width: int, height: int, mobile: bool = False) -> None:
        """The size of the window in CSS pixels."""
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=mobile)

    def prefer(self, scheme: str) -> None:
        """``light`` or ``dark``, as the system says."""
        self.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])

    def open(self, file: Path, anchor: str = "") -> None:
        """Opens a page from a file and waits until it is loaded."""
        self.command("Page.navigate", url="about:blank")  # so that another anchor of the same page loads it again
        result = self.command("Page.navigate", url=file.resolve().as_uri() + (f"#{anchor}" if anchor else ""))
        if result.get("errorText"):
            raise BrowserError(f"{file}: {result['errorText']}")
        self.wait("location.protocol === 'file:' && document.readyState === 'complete'")

    def run(self, script: str) -> Any:
        """The value of an expression (awaited, if it is a promise)."""
        result = self.command("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise BrowserError(f"{script}: {result['exceptionDetails'].get('exception', {}).get('description')}")
        return result["result"].get("value")

    def wait(self, condition: str, timeout: float = 60.0) -> None:
        """Waits until an expression is true. Pages may change meanwhile."""
        deadline = time.monotonic() + timeout
        while True:
            try:
                if self.run(f"!!({condition})"):
                    return
            except BrowserError:
                if time.monotonic() > deadline:
                    raise
            if time.monotonic() > deadline:
                raise BrowserError(f"not true after {timeout} s: {condition}")
            time.sleep(0.02)

    def press(self, key: str, modifiers: int = 0) -> None:
        """Presses and releases a key. ``modifiers``: 2 is Ctrl."""
        code, number = _KEYS.get(key, (f"Key{key.upper()}", ord(key.upper())) if len(key) == 1 and key.isascii() and key.isalnum() else ("", 0))
        text = {"Enter": "\r"}.get(key, key if len(key) == 1 and not modifiers else "")
        fields: dict[str, Any] = {"key": key, "code": code, "windowsVirtualKeyCode": number, "modifiers": modifiers}
        self.command("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", **fields, **({"text": text} if text else {}))
        self.command("Input.dispatchKeyEvent", type="keyUp", **fields)

    def type(self, text: str) -> None:
        """Types a text, key by key."""
        for character in text:
            self.press(character)

    def click(self, selector: str) -> None:
        """Clicks the middle of an element with the mouse."""
        place = self.run(f"(() => {{ const e = document.querySelector({json.dumps(selector)}); e.scrollIntoView({{block: 'center'}}); const r = e.getBoundingClientRect();"
                         " return [r.x + r.width / 2, r.y + r.height / 2]; })()")
        for kind in ("mousePressed", "mouseReleased"):
            self.command("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left", clickCount=1)

    def screenshot(self, file: Path, full_page: bool = False) -> None:
        """What is seen now, as PNG."""
        data = self.command("Page.captureScreenshot", format="png", captureBeyondViewport=full_page)["data"]
        file.write_bytes(base64.b64decode(data))

    def requested(self) -> list[str]:
        """Addresses of everything that pages asked for since the last call."""
        self.run("0")
        found = [event["params"]["request"]["url"] for event in self._events]
        self._events.clear()
        return found

    def close(self) -> None:
        """Ends the browser."""
        try:
            self._command("Browser.close")
        except (BrowserError, OSError):
            pass
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        for descriptor in (self._read, self._write):
            os.close(descriptor)
        shutil.rmtree(self._profile, ignore_errors=True)

    def __enter__(self) -> Browser:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
