#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check the header tool on any checkout of an Unreal project, by counting macros in the text independently of it.

For each header below the modules (folders with a *.Build.cs) this program strips comments and strings with its own small scanner, finds the
calls of UCLASS, USTRUCT, UENUM, UINTERFACE, UFUNCTION, UPROPERTY and of the dynamic delegate macros, runs `spear-header-tool dump`, and
compares: is there a declaration in the schema for each call, and is its type (return type, each parameter, property) the written one?
Of each declaration it also compares specifiers, metadata, the doc comment, defaults and enumerator values with the text (independent_facts.py).
It shares no code with the tool: types are compared after a plain text normalisation.

    independent_check.py --tool build/release/bin/spear-header-tool /path/to/project [--report out.json] [--verbose]
    independent_check.py --tool build/release/bin/spear-header-tool ~/checkouts/*            # a table, one line each

Exit codes: 0 at least 99.9 % declared, all types right, at least 99.9 % of the other facts; 1 less than that; 2 the tool or the arguments failed.
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

sys.path.insert(0, str(Path(__file__).parent))

import independent_facts as facts_of  # noqa: E402

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
    begin: int = 0  # of the macro
    opening: int = 0  # its parenthesis
    end: int = 0  # behind the closing one
    parameters: tuple[int, int] = (0, 0)  # parentheses of a function's parameters
    entity: dict[str, Any] | None = None  # of the schema


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
            calls.append(Call("delegate", line, returns + types, name, begin=match.start(), opening=opening, end=end))
            continue
        call = Call(KINDS[word], line, begin=match.start(), opening=opening, end=end)
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
                call.parameters = (opening, closing(plain, opening))
                inside = plain[opening + 1 : call.parameters[1]]
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
        add(c, header, Call("interface" if "Interface" in c["flags"] else "class", c["source"]["line"], [], c["name"], entity=c))
        for f in c["functions"]:
            add(c, header, Call("function", f["source"]["line"], signature(f), f["name"], entity=f))
    for t in schema["classes"] + schema["structs"]:
        for p in t["properties"]:
            add(t, t["source"]["header"], Call("property", p["source"]["line"], [normalise(p["type"]["cpp"])], p["source"]["cpp_name"], entity=p))
    for s in schema["structs"]:
        add(s, s["source"]["header"], Call("struct", s["source"]["line"], [], s["name"], entity=s))
    for e in schema["enums"]:
        add(e, e["source"]["header"], Call("enum", e["source"]["line"], [], e["name"], entity=e))
    for d in schema["delegates"]:
        add(d, d["source"]["header"], Call("delegate", d["source"]["line"], signature(d), d["name"], entity=d))
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


def facts(text: str, plain: str, call: Call, entity: dict[str, Any]) -> list[facts_of.Fact]:
    """All other facts of one declaration, from the text and from the schema."""
    found: list[facts_of.Fact] = []
    if call.kind != "delegate":
        raw, inside = text[call.opening + 1 : call.end - 1], plain[call.opening + 1 : call.end - 1]
        found += facts_of.specifiers(raw, entity)
        found += facts_of.metadata(raw, inside, entity, split_top, closing)
    found += facts_of.comment(text, call.begin, entity)
    if call.kind == "property":
        found += facts_of.property_default(text, plain, call.end, entity)
    if call.kind == "function" and call.parameters[1]:
        found += facts_of.parameter_defaults(text, plain, *call.parameters, entity, split_top)
    if call.kind == "enum":
        found += facts_of.enumerators(text, plain, call.end, entity, split_top, closing)
    return found


@dataclass
class Result:
    """The counts of one project."""

    project: str
    headers: int = 0
    modules: int = 0
    text: Counter[str] = field(default_factory=Counter)
    declared: Counter[str] = field(default_factory=Counter)
    left_out: Counter[str] = field(default_factory=Counter)
    types: int = 0
    types_right: int = 0
    facts: Counter[str] = field(default_factory=Counter)
    facts_right: Counter[str] = field(default_factory=Counter)
    problems: list[str] = field(default_factory=list)

    @property
    def share(self) -> float:
        """Percent of the calls in the text that are declared."""
        return 100 * self.declared.total() / self.text.total() if self.text else 100.0

    @property
    def good(self) -> bool:
        """Whether the bars are held."""
        return self.share >= 99.9 and self.types_right == self.types and self.facts_right.total() >= 0.999 * self.facts.total()

    def to_dict(self) -> dict[str, Any]:
        """For JSON."""
        return {"project": self.project, "headers": self.headers, "text": self.text, "declared": self.declared, "inactive": self.left_out, "types": self.types, "types_right": self.types_right,
                "facts": self.facts, "facts_right": self.facts_right, "problems": self.problems}


def check(project: Path, tool: Path) -> Result | str:
    """Compares one project; a text says why it could not."""
    with tempfile.TemporaryDirectory() as folder:
        schema_file, report_file = Path(folder) / "schema.json", Path(folder) / "report.json"
        command = [str(tool), "dump", "--quiet", "--module", str(project), "-o", str(schema_file), "--report", str(report_file)]
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 0:
            return f"{project}: {' '.join(command)} ended with exit code {run.returncode}: {run.stderr.strip()}"
        schema, report = json.loads(schema_file.read_text()), json.loads(report_file.read_text())
    declared = declared_entities(schema)
    # Not declared on purpose, and said so: inactive #if branches, and macros in classes that have no UCLASS (UHT passes those by too).
    inactive = {(str(Path(e["file"]).resolve()), e["line"]) for e in report["entries"] if e["rule"] in ("inactive-region", "nested-type")}
    headers = module_headers(project)
    result = Result(project.resolve().name, len(headers), len(schema["modules"]))
    for header in headers:
        entities = declared.get(str(header), [])
        text = read_text(header)
        plain = strip(text)
        for call in read_calls(text):
            if (str(header), call.line) in inactive:
                result.left_out[call.kind] += 1
                continue
            result.text[call.kind] += 1
            candidates = [e for e in entities if e.kind == call.kind and not e.used and e.line >= call.line and (not call.name or e.name == call.name)]
            if not candidates:
                result.problems.append(f"{header}:{call.line}: {call.kind} {call.name or '?'} is not in the schema")
                continue
            best = min(candidates, key=lambda e: e.line)
            best.used = True
            result.declared[call.kind] += 1
            where = f"{header}:{call.line}: {call.kind} {best.name}"
            if call.kind in ("function", "property", "delegate"):
                count = max(len(call.types), len(best.types))
                result.types += count
                for i in range(count):
                    written = call.types[i] if i < len(call.types) else "(none)"
                    found = best.types[i] if i < len(best.types) else "(none)"
                    if written == found:
                        result.types_right += 1
                    else:
                        result.problems.append(f"{where}, type {i}: text '{written}', schema '{found}'")
            for what, written_fact, stated in facts(text, plain, call, best.entity or {}):
                group = what.split()[0]
                result.facts[group] += 1
                if written_fact == stated:
                    result.facts_right[group] += 1
                else:
                    result.problems.append(f"{where}, {what}: text {written_fact!r}, schema {stated!r}")
    return result


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("projects", type=Path, nargs="+", metavar="PROJECT", help="folder of a project or plugin")
    parser.add_argument("--tool", type=Path, required=True, help="the spear-header-tool binary")
    parser.add_argument("--report", type=Path, help="write the counts as JSON (several projects: a list)")
    parser.add_argument("--verbose", action="store_true", help="print every call without declaration, every type and every fact that differs")
    args = parser.parse_args()
    for project in args.projects:
        if not project.is_dir():
            parser.error(f"{project} is not a folder")
    results = []
    for project in args.projects:
        result = check(project, args.tool)
        if isinstance(result, str):
            print(result, file=sys.stderr)
            return 2
        results.append(result)
        if args.verbose:
            print("\n".join(result.problems))
    if len(results) == 1:
        _print_one(results[0])
    else:
        _print_table(results)
    if args.report:
        args.report.write_text(json.dumps(results[0].to_dict() if len(results) == 1 else [r.to_dict() for r in results], indent=2) + "\n")
    return 0 if all(r.good for r in results) else 1


def _print_one(r: Result) -> None:
    print(f"{r.project}: {r.headers} headers, {r.modules} modules")
    for kind in sorted(r.text):
        print(f"  {kind:<10} {r.text[kind]:>6} calls in text, {r.declared[kind]:>6} declared ({100 * r.declared[kind] / r.text[kind]:.2f} %)"
              + (f", {r.left_out[kind]} more in inactive #if branches or unreflected classes (reported)" if r.left_out[kind] else ""))
    for group in sorted(r.facts):
        print(f"  {group:<10} {r.facts[group]:>6} facts in text, {r.facts_right[group]:>6} the same in the schema")
    right = 100 * r.types_right / r.types if r.types else 100.0
    print(f"  all        {r.text.total():>6} calls in text, {r.declared.total():>6} declared ({r.share:.3f} %); types right {r.types_right} of {r.types} ({right:.3f} %)")


def _print_table(results: list[Result]) -> None:
    groups = sorted({group for r in results for group in r.facts})
    width = max(len(r.project) for r in results)
    print(f"{'project':<{width}}{'headers':>9}{'calls':>8}{'declared':>10}{'reported':>10}{'types':>8}{'right':>8}" + "".join(f"{g:>14}" for g in groups))
    for r in results:
        print(f"{r.project:<{width}}{r.headers:>9}{r.text.total():>8}{r.declared.total():>10}{r.left_out.total():>10}{r.types:>8}{r.types_right:>8}"
              + "".join(f"{f'{r.facts_right[g]}/{r.facts[g]}':>14}" for g in groups))
    print(f"{'all':<{width}}{sum(r.headers for r in results):>9}{sum(r.text.total() for r in results):>8}{sum(r.declared.total() for r in results):>10}{sum(r.left_out.total() for r in results):>10}"
          f"{sum(r.types for r in results):>8}{sum(r.types_right for r in results):>8}" + "".join(f"{f'{sum(r.facts_right[g] for r in results)}/{sum(r.facts[g] for r in results)}':>14}" for g in groups))


if __name__ == "__main__":
    sys.exit(main())
