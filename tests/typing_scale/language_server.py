# SPDX-License-Identifier: MIT
"""A small client of the Language Server Protocol that drives ``pyright-langserver --stdio`` as an editor does."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from types import TracebackType
from typing import Any

Json = Any


class ServerError(Exception):
    """The language server answered a request with an error, or ended."""


class LanguageServer:
    """One server process with one workspace folder.

    Answers the server's own questions (its configuration, progress tokens) while it waits for its replies; everything happens in the
    caller's thread, so times are those an editor would see.
    """

    def __init__(self, folder: Path, python: Path) -> None:
        self.folder = folder
        self.python = python
        self.diagnostics: dict[str, list[Json]] = {}
        self._number = 0
        self._versions: dict[str, int] = {}
        self.started = time.perf_counter()
        command = [sys.executable, "-m", "pyright.langserver", "--stdio"]
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=folder, start_new_session=True)

    def __enter__(self) -> LanguageServer:
        completion = {"completionItem": {"documentationFormat": ["markdown"], "resolveSupport": {"properties": ["documentation", "detail"]}}}
        capabilities = {
            "workspace": {"configuration": True, "workspaceFolders": True},
            "textDocument": {
                "completion": completion, "hover": {"contentFormat": ["markdown"]},
                "signatureHelp": {"signatureInformation": {"documentationFormat": ["markdown"], "parameterInformation": {"labelOffsetSupport": True}}},
                "publishDiagnostics": {},
            },
        }
        uri = self.folder.as_uri()
        self.request("initialize", {"processId": os.getpid(), "rootUri": uri, "workspaceFolders": [{"uri": uri, "name": "test"}], "capabilities": capabilities})
        self.notify("initialized", {})
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        try:
            if kind is None:
                self.request("shutdown", None)
                self.notify("exit", None)
                self._process.wait(10)
        finally:
            for process in reversed(self.processes()):
                try:
                    os.kill(process, 9)
                except ProcessLookupError:
                    pass
            self._process.wait()
            for pipe in (self._process.stdin, self._process.stdout):
                if pipe:
                    pipe.close()

    # Documents ----------------------------------------------------------------------------------------------------------

    def open(self, path: Path, text: str) -> None:
        """Opens a document in the editor; the file need not exist."""
        self._versions[path.as_uri()] = 1
        self.notify("textDocument/didOpen", {"textDocument": {"uri": path.as_uri(), "languageId": "python", "version": 1, "text": text}})

    def change(self, path: Path, text: str) -> None:
        """Gives a document a new text."""
        version = self._versions[path.as_uri()] = self._versions[path.as_uri()] + 1
        self.notify("textDocument/didChange", {"textDocument": {"uri": path.as_uri(), "version": version}, "contentChanges": [{"text": text}]})

    # Questions ----------------------------------------------------------------------------------------------------------

    def completion(self, path: Path, line: int, character: int) -> list[Json]:
        """The completion items at a place (lines and characters from 0)."""
        result = self.request("textDocument/completion", {**self._place(path, line, character), "context": {"triggerKind": 1}})
        items: list[Json] = result["items"] if isinstance(result, dict) else result or []
        return items

    def resolve(self, item: Json) -> Json:
        """A completion item with its documentation, as an editor asks for it when the item is selected."""
        return self.request("completionItem/resolve", item)

    def hover(self, path: Path, line: int, character: int) -> str:
        """What the pointer shows there ("" if nothing)."""
        result = self.request("textDocument/hover", self._place(path, line, character))
        return str(result["contents"]["value"]) if result else ""

    def signature_help(self, path: Path, line: int, character: int) -> Json:
        """The signatures of the call that surrounds a place."""
        return self.request("textDocument/signatureHelp", {**self._place(path, line, character), "context": {"triggerKind": 1, "isRetrigger": False}})

    def wait_for_diagnostics(self, path: Path) -> list[Json]:
        """The errors and warnings of an open document, once the server has checked it."""
        while path.as_uri() not in self.diagnostics:
            self._handle(self._read())
        return self.diagnostics[path.as_uri()]

    @staticmethod
    def _place(path: Path, line: int, character: int) -> Json:
        return {"textDocument": {"uri": path.as_uri()}, "position": {"line": line, "character": character}}

    # Memory -------------------------------------------------------------------------------------------------------------

    def processes(self) -> list[int]:
        """The server's process and its descendants."""
        found, todo = [], [self._process.pid]
        while todo:
            process = todo.pop()
            found.append(process)
            try:
                todo += map(int, Path(f"/proc/{process}/task/{process}/children").read_text().split())
            except OSError:
                pass
        return found

    def memory(self) -> int:
        """Resident memory of all its processes in bytes: the highest that each has had (Linux)."""
        total = 0
        for process in self.processes():
            try:
                status = Path(f"/proc/{process}/status").read_text()
            except OSError:
                continue
            total += sum(int(line.split()[1]) for line in status.splitlines() if line.startswith("VmHWM")) * 1024
        return total

    def processor_seconds(self) -> float:
        """Processor time that all its processes have used; does not depend on what else the machine does."""
        total = 0
        for process in self.processes():
            try:
                fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            total += int(fields[11]) + int(fields[12])
        return total / os.sysconf("SC_CLK_TCK")

    # Protocol -----------------------------------------------------------------------------------------------------------

    def request(self, method: str, parameters: Json) -> Json:
        """Sends a request and waits for its result."""
        self._number += 1
        number = self._number
        self._send({"id": number, "method": method, "params": parameters})
        while True:
            message = self._read()
            if message.get("id") == number and "method" not in message:
                if "error" in message:
                    raise ServerError(f"{method}: {message['error']}")
                return message.get("result")
            self._handle(message)

    def notify(self, method: str, parameters: Json) -> None:
        """Sends a notification."""
        self._send({"method": method, "params": parameters})

    def _handle(self, message: Json) -> None:
        method = message.get("method")
        if method == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]["diagnostics"]
        if method is None or "id" not in message:
            return
        result: Json = None
        if method == "workspace/configuration":
            result = [self._settings(item.get("section", "")) for item in message["params"]["items"]]
        self._send({"id": message["id"], "result": result})

    def _settings(self, section: str) -> Json:
        settings: Json = {"python": {"pythonPath": str(self.python), "analysis": {"diagnosticMode": "openFilesOnly", "typeCheckingMode": "standard"}}, "pyright": {}}
        for part in section.split("."):
            settings = settings.get(part, {}) if part else settings
        return settings

    def _send(self, message: Json) -> None:
        data = json.dumps({"jsonrpc": "2.0", **message}).encode()
        assert self._process.stdin
        self._process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(data), data))
        self._process.stdin.flush()

    def _read(self) -> Json:
        assert self._process.stdout
        length = 0
        while True:
            line = self._process.stdout.readline()
            if not line:
                raise ServerError(f"the language server ended with exit code {self._process.wait()}")
            if line == b"\r\n":
                break
            name, _, value = line.partition(b":")
            if name.lower() == b"content-length":
                length = int(value)
        return json.loads(self._process.stdout.read(length))
