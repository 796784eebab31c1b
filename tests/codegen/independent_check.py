#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check the header tool on any checkout of an Unreal project, by counting macros in the text independently of it.

For each header below the modules (folders with a *.Build.cs) this program strips comments and strings with its own small scanner, finds the
calls of UCLASS, USTRUCT, UENUM, UINTERFACE, UFUNCTION, UPROPERTY and of the dynamic delegate macros, runs `spear-header-tool dump`, and
compares: is there a declaration in the schema for each call, and is its type (return type, each parameter, property) the written one?
It shares no code with the tool: types are compared after a plain text normalisation.

    independent_check.py --tool build/release/bin/spear-header-tool /path/to/project [--report out.json] [--verbose]
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

IGNORED_FOLDERS = {"Intermediate", "ThirdParty", "Binaries", "Saved", "DerivedDataCache", "node_modules"}
MACRO = re.compile(r"\b(UCLASS|USTRUCT|UENUM|UINTERFACE|UFUNCTION|UPROPERTY|DECLARE_DYNAMIC_\w*DELEGATE\w*)\s*\(")


def strip(text: str) -> str:
    """Blank comments, the inside of string and character literals, and #define lines; offsets and line ends stay."""
    out = list(text)
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^()\\ ]{0,16})\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Za-z_])\'(?:\\.|[^\'\\\n])*\'', re.S)
    for match in pattern.finditer(text):
        quoted = match.group()[0] in "\"'R"
        for i in range(match.start() + (1 if quoted else 0), match.end() - (1 if quoted else 0)):
            if out[i] != "\n":
                out[i] = " " if not quoted else "_"
    plain = "".join(out)
    for match in re.finditer(r"^[ \t]*#[ \t]*define\b(?:[^\n]*\\\n)*[^\n]*", plain, re.M):
        plain = plain[: match.start()] + re.sub(r"[^\n]", " ", match.group()) + plain[match.end() :]
    return plain


def closing(text: str, opening: int) -> int:
    depth = 0
    for i in range(opening, len(text)):
        if text[i] in "([{":
            depth += 1
        elif text[i] in ")]}":
            depth -= 1
            if depth == 0:
                return i
    return len(text) - 1


def split_top(text: str) -> list[str]:
    parts, depth, current = [], 0, ""
    for c in text:
        depth += c in "(<[{"
        depth -= c in ")>]}"
        if c == "," and depth == 0:
            parts.append(current)
            current = ""
        else:
            current += c
    return [p for p in [*parts, current] if p.strip()]


def normalise(written: str) -> str:
    """One spelling for a type, blind to what the schema does not tell apart: const, references, TObjectPtr, TEnumAsByte, scopes."""
    t = re.sub(r"\bUPARAM\s*\((?:[^()]|\([^()]*\))*\)", " ", written)
    t = re.sub(r"\b(const|class|struct|enum|typename|volatile|mutable|virtual|static|inline|FORCEINLINE|constexpr|explicit|UE_NODISCARD)\b", " ", t)
    t = re.sub(r"\b[A-Z][A-Z0-9_]*_API\b", " ", t)
    t = re.sub(r"\[\[[^\]]*\]\]", " ", t)
    t = re.sub(r"\bunsigned\s+int\b", "uint32", t)
    t = re.sub(r"\bint\b", "int32", t)
    t = re.sub(r"[\s&]+", "", t)
    previous = None
    while previous != t:
        previous = t
        t = re.sub(r"\bTObjectPtr<([\w:]+)>", r"\1*", t)
        t = re.sub(r"\bTEnumAsByte<([\w:]+)>", r"\1", t)
        t = re.sub(r"\bTAutoWeakObjectPtr<", "TWeakObjectPtr<", t)
        t = re.sub(r"\bTSubclassOf<UObject>", "UClass*", t)
        t = re.sub(r"\bTInstancedStruct<\w+>", "FInstancedStruct", t)
    t = re.sub(r"\b(E\w+)::\w+", r"\1", t)
    return re.sub(r"\b\w+::", "", t)


@dataclass
class Call:
    kind: str  # class, struct, enum, interface, function, property, delegate
    line: int
    types: list[str] = field(default_factory=list)  # normalised; functions: return type first
    name: str = ""
    used: bool = False


KINDS = {"UCLASS": "class", "USTRUCT": "struct", "UENUM": "enum", "UINTERFACE": "interface", "UFUNCTION": "function", "UPROPERTY": "property"}


def parameter_type(text: str) -> str:
    text = re.sub(r"\bUPARAM\s*\((?:[^()]|\([^()]*\))*\)", " ", text)
    text = re.split(r"=(?![^<]*>)", text, maxsplit=1)[0].strip()
    text = re.sub(r"\[[^\]]*\]\s*$", "", text).strip()
    return normalise(re.sub(r"\b\w+\s*$", "", text))


def skip_leading(text: str, at: int) -> int:
    while True:
        match = re.match(r"[\s;]+|\[\[[^\]]*\]\]|\b(?!UPARAM\b)[A-Z][A-Z0-9_]{3,}\s*(?=\()|#[^\n]*", text[at:])
        if not match or not match.group():
            return at
        at += match.end()
        if text[at : at + 1] == "(":
            at = closing(text, at) + 1


def read_calls(text: str) -> list[Call]:
    plain = strip(text)
    calls = []
    for match in MACRO.finditer(plain):
        opening = match.end() - 1
        end = closing(plain, opening) + 1
        line = plain.count("\n", 0, match.start()) + 1
        word = match.group(1)
        if word.startswith("DECLARE_"):
            args = split_top(plain[opening + 1 : end - 1])
            returns = ["void"]
            if "_RetVal" in word and args:
                returns = [normalise(args.pop(0))]
            name = args.pop(0).strip() if args else ""
            if "_SPARSE_" in word:
                args = args[2:]
            types = [normalise(a) for a in args[0::2]]
            calls.append(Call("delegate", line, returns + types, name))
            continue
        call = Call(KINDS[word], line)
        if call.kind == "property":
            at = skip_leading(plain, end)
            statement = re.match(r"[^;=({]*(?:=|;|\{|\()?", plain[at:], re.S)
            declared = statement.group() if statement else ""
            bit_field = re.search(r"(?<!:):(?!:)", declared)
            head = re.split(r"(?<!:):(?!:)|[;={(\[]", declared, maxsplit=1)[0]
            first = split_top(head)[0] if split_top(head) else head
            declarator = re.search(r"(\w+)\s*$", first)
            if declarator:
                call.name = declarator.group(1)
                call.types = ["bool" if bit_field else normalise(first[: declarator.start()])]
        elif call.kind == "function":
            at = skip_leading(plain, end)
            head = re.match(r"(?:UPARAM\s*\((?:[^()]|\([^()]*\))*\)|[^();{}])*?\b(?!UPARAM\b)(\w+)\s*\(", plain[at:], re.S)
            if head:
                call.name = head.group(1)
                opening = at + head.end() - 1
                inside = plain[opening + 1 : closing(plain, opening)]
                call.types = [normalise(plain[at : at + head.start(1)])]
                call.types += [parameter_type(p) for p in split_top(inside) if p.strip() != "void"]
        calls.append(call)
    return calls


def declared_entities(schema: dict[str, Any]) -> dict[str, list[Call]]:
    """By header path (module folder + relative path): what the schema declares."""
    roots = {m["name"]: Path(m["source"]["path"]) for m in schema["modules"]}
    out: dict[str, list[Call]] = {}

    def add(entity: dict[str, Any], header: str, call: Call) -> None:
        out.setdefault(str((roots[entity["module"]] / header).resolve()), []).append(call)

    def signature(f: dict[str, Any]) -> list[str]:
        returns = normalise(f["returns"]["type"]["cpp"]) if f["returns"] else "void"
        return [returns] + [normalise(p["type"]["cpp"]) for p in f["parameters"]]

    for c in schema["classes"]:
        header = c["source"]["header"]
        add(c, header, Call("interface" if "Interface" in c["flags"] else "class", c["source"]["line"], [], c["name"]))
        for f in c["functions"]:
            add(c, header, Call("function", f["source"]["line"], signature(f), f["name"]))
    for t in schema["classes"] + schema["structs"]:
        for p in t["properties"]:
            add(t, t["source"]["header"], Call("property", p["source"]["line"], [normalise(p["type"]["cpp"])], p["source"]["cpp_name"]))
    for s in schema["structs"]:
        add(s, s["source"]["header"], Call("struct", s["source"]["line"], [], s["name"]))
    for e in schema["enums"]:
        add(e, e["source"]["header"], Call("enum", e["source"]["line"], [], e["name"]))
    for d in schema["delegates"]:
        add(d, d["source"]["header"], Call("delegate", d["source"]["line"], signature(d), d["name"]))
    return out


def module_headers(project: Path) -> list[Path]:
    found: set[Path] = set()
    for build in project.rglob("*.Build.cs"):
        if any(part in IGNORED_FOLDERS or part.startswith(".") for part in build.relative_to(project).parts[:-1]):
            continue
        for header in build.parent.rglob("*.h"):
            parts = header.relative_to(build.parent).parts[:-1]
            if not any(part in IGNORED_FOLDERS or part.startswith(".") for part in parts) and not header.name.endswith(".generated.h"):
                found.add(header.resolve())
    return sorted(found)


def read_text(path: Path) -> str:
    raw = path.read_bytes()
    if raw[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return raw.decode("utf-16").replace("\r\n", "\n")
    try:
        return raw.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError:
        return raw.decode("latin-1").replace("\r\n", "\n")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("project", type=Path, help="folder of the project or plugin")
    parser.add_argument("--tool", type=Path, required=True, help="the spear-header-tool binary")
    parser.add_argument("--report", type=Path, help="write the counts as JSON")
    parser.add_argument("--verbose", action="store_true", help="print every call without declaration and every type that differs")
    args = parser.parse_args()
    if not args.project.is_dir():
        parser.error(f"{args.project} is not a folder")
    with tempfile.TemporaryDirectory() as folder:
        schema_file, report_file = Path(folder) / "schema.json", Path(folder) / "report.json"
        command = [str(args.tool), "dump", "--quiet", "--module", str(args.project), "-o", str(schema_file), "--report", str(report_file)]
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 0:
            print(run.stderr, file=sys.stderr)
            return 2
        schema, report = json.loads(schema_file.read_text()), json.loads(report_file.read_text())

    declared = declared_entities(schema)
    # Not declared on purpose, and said so: inactive #if branches, and macros in classes that have no UCLASS (UHT passes those by too).
    inactive = {(str(Path(e["file"]).resolve()), e["line"]) for e in report["entries"] if e["rule"] in ("inactive-region", "nested-type")}
    headers = module_headers(args.project)
    in_text: Counter[str] = Counter()
    matched: Counter[str] = Counter()
    left_out: Counter[str] = Counter()
    types_right = types_total = 0
    problems = []
    for header in headers:
        entities = declared.get(str(header), [])
        for call in read_calls(read_text(header)):
            if (str(header), call.line) in inactive:
                left_out[call.kind] += 1
                continue
            in_text[call.kind] += 1
            candidates = [e for e in entities if e.kind == call.kind and not e.used and e.line >= call.line and (not call.name or e.name == call.name)]
            if not candidates:
                problems.append(f"{header}:{call.line}: {call.kind} {call.name or '?'} is not in the schema")
                continue
            best = min(candidates, key=lambda e: e.line)
            best.used = True
            matched[call.kind] += 1
            if call.kind in ("function", "property", "delegate"):
                types_total += max(len(call.types), len(best.types))
                for i in range(max(len(call.types), len(best.types))):
                    text = call.types[i] if i < len(call.types) else "(none)"
                    found = best.types[i] if i < len(best.types) else "(none)"
                    if text == found:
                        types_right += 1
                    else:
                        problems.append(f"{header}:{call.line}: {call.kind} {call.name}, type {i}: text '{text}', schema '{found}'")
    total_text, total_matched = sum(in_text.values()), sum(matched.values())
    if args.verbose:
        print("\n".join(problems))
    print(f"{args.project.name}: {len(headers)} headers, {len(schema['modules'])} modules")
    for kind in sorted(in_text):
        print(f"  {kind:<10} {in_text[kind]:>6} calls in text, {matched[kind]:>6} declared ({100 * matched[kind] / in_text[kind]:.2f} %)"
            + (f", {left_out[kind]} more in inactive #if branches or unreflected classes (reported)" if left_out[kind] else ""))
    share = 100 * total_matched / total_text if total_text else 100.0
    right = 100 * types_right / types_total if types_total else 100.0
    print(f"  all        {total_text:>6} calls in text, {total_matched:>6} declared ({share:.3f} %); types right {types_right} of {types_total} ({right:.3f} %)")
    if args.report:
        args.report.write_text(json.dumps({"project": args.project.name, "headers": len(headers), "text": in_text, "declared": matched, "inactive": left_out,
            "types": types_total, "types_right": types_right, "problems": problems}, indent=2) + "\n")
    return 0 if share >= 99.9 and types_right == types_total else 1


if __name__ == "__main__":
    sys.exit(main())
