# SPDX-License-Identifier: MIT
"""Doc comments taken apart, for docstrings, Markdown and HTML."""

from __future__ import annotations

import html as _html
import re
import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

Entity = Mapping[str, Any]

_TAG = re.compile(
    r"[@\\](param|tparam|returns?|retval|result|see|sa|deprecated|note|warning|todo|brief|details|throws?|exception|code|endcode|verbatim|endverbatim)\b"
    r"[ \t]*"
)
#: The white space before a tag that does not begin its line.
_TAG_WITHIN_LINE = re.compile(r"(?<=[\w.,;:)!?'\"`]) +(?=[@\\](?:param|returns?|see|note|warning|deprecated)\b)")
_PARAM = re.compile(r"(?:\[(?:in|out|in,\s*out)\]\s*)?(\*?[\w.]+)\s*[:,-]*\s*(.*)", re.DOTALL)
_LIST_ITEM = re.compile(r"^\s*(?:[-*+•]|\d+[.)])\s+")
_INLINE = ((re.compile(r"[@\\][cp]\s+([\w:.]+(?:\(\))?)"), r"`\1`"), (re.compile(r"[@\\](?:ref|link)\s+([\w:.]+(?:\(\))?)"), r"`\1`"),
           (re.compile(r"[@\\](?:b|e|em|a)\s+(\w+)"), r"\1"), (re.compile(r"</?(?:b|i|em|strong|tt|code)>", re.IGNORECASE), ""),
           (re.compile(r"<(?:br|p)\s*/?>", re.IGNORECASE), "\n"), (re.compile(r"</p>", re.IGNORECASE), ""),
           (re.compile(r"[@\\](?:endlink|n)\b"), ""))


@dataclass(frozen=True)
class Block:
    """A part of the text. ``kind``: "text" (one paragraph, flowing), "list" (one item per line of ``lines``), "code" (as it stands)."""

    kind: str
    lines: tuple[str, ...]

    @property
    def text(self) -> str:
        """The lines: of code and lists one below the other, of a paragraph in one."""
        return ("\n" if self.kind != "text" else " ").join(self.lines)


@dataclass
class Documentation:
    """What a doc comment says. Empty parts are empty."""

    #: First sentence or first line, without markup.
    summary: str = ""
    #: Everything before the first tag, the summary included.
    blocks: list[Block] = field(default_factory=list)
    parameters: dict[str, str] = field(default_factory=dict)
    returns: str = ""
    notes: list[tuple[str, str]] = field(default_factory=list)  # ("Note" | "Warning" | "Deprecated" | "Throws" | "See", text)

    def __bool__(self) -> bool:
        return bool(self.blocks or self.parameters or self.returns or self.notes)

    def parameter(self, name: str) -> str:
        """What is said of a parameter; names compare without case."""
        found = self.parameters.get(name)
        if found is None:
            found = next((text for key, text in self.parameters.items() if key.lower() == name.lower()), "")
        return found


# Reading ---------------------------------------------------------------------------------------------------------------------


def clean_comment(comment: str) -> str:
    """A comment as written, without its marks (``/**``, ``*``, ``//``) and common indentation."""
    text = comment.replace("\r\n", "\n").replace("\r", "\n").strip()
    if "/*" not in text and "//" not in text:
        return textwrap.dedent(text).strip()
    lines: list[str] = []
    in_block = False
    for line in text.split("\n"):
        stripped = line.strip()
        if not in_block and stripped.startswith("/*"):
            in_block = True
            line = re.sub(r"^/\*+[!<]*", "", stripped)
            if "*/" in line:
                in_block = False
                line = line[: line.index("*/")]
            lines.append(line[1:] if line.startswith(" ") else line)
        elif in_block:
            if "*/" in line:
                in_block = False
                line = re.sub(r"\**$", "", line[: line.index("*/")].rstrip())
            star = re.match(r"\s*\*+ ?", line)
            lines.append(line[star.end():] if star else line.strip())
        else:
            lines.append(re.sub(r"^///?[!<]* ?", "", stripped))
    joined = "\n".join(line.rstrip() for line in lines)
    return textwrap.dedent(joined).strip("\n").strip()


def comment_of(entity: Entity) -> str:
    """The text of an entity's doc comment, cleaned: a written ToolTip, else the comment of the editor or the source tier."""
    meta = entity.get("editor", {}).get("meta", {})
    for text in (meta.get("ToolTip"), meta.get("Comment"), entity.get("source", {}).get("comment")):
        if text and text.strip():
            return clean_comment(text)
    return ""


def parse_comment(text: str) -> Documentation:
    """Takes a cleaned comment apart."""
    result = Documentation()
    if not text:
        return result
    sections = _sections(text)
    result.blocks = _blocks(sections[0][1])
    for tag, content in sections[1:]:
        content = _flow(content)
        if tag == "param":
            match = _PARAM.match(content)
            if match:
                result.parameters.setdefault(match[1].lstrip("*"), match[2].strip())
        elif tag in ("return", "returns", "retval", "result"):
            result.returns = f"{result.returns} {content}".strip()
        elif tag in ("see", "sa", "note", "warning", "deprecated", "throw", "throws", "exception"):
            label = {"see": "See", "sa": "See", "note": "Note", "warning": "Warning", "deprecated": "Deprecated"}.get(tag, "Throws")
            result.notes.append((label, content))
        elif tag in ("brief", "details") and content:
            result.blocks.append(Block("text", (content,)))
    first = next((block for block in result.blocks if block.kind != "code"), None)
    if first is not None:
        result.summary = _first_sentence(first.lines[0] if first.kind == "list" else first.text)
    elif result.returns:
        result.summary = _first_sentence("Returns " + result.returns)
    return result


def documentation(entity: Entity) -> Documentation:
    """The documentation of a class, struct, enum, entry, function, property or delegate."""
    return parse_comment(comment_of(entity))


def units_of(entity: Entity) -> str:
    """The unit of a property or parameter (``Units``, ``ForceUnits``): "cm", "deg", ...; or ""."""
    meta = entity.get("editor", {}).get("meta", {})
    return str(meta.get("ForceUnits") or meta.get("Units") or "")


def range_of(entity: Entity) -> str:
    """The range of a number (``ClampMin``, ``ClampMax``): "0 to 1", "at least 0", "at most 1"; or ""."""
    meta = entity.get("editor", {}).get("meta", {})
    low, high = meta.get("ClampMin", ""), meta.get("ClampMax", "")
    if low and high:
        return f"{low} to {high}"
    return f"at least {low}" if low else f"at most {high}" if high else ""


def _sections(text: str) -> list[tuple[str, str]]:
    """The text before the first tag, then (tag, text) each. Code between @code and @endcode is no place for tags."""
    sections: list[tuple[str, list[str]]] = [("", [])]
    in_code = False
    if "@" in text or "\\" in text:
        text = _TAG_WITHIN_LINE.sub("\n", text)
    for line in text.split("\n"):
        match = _TAG.match(line.lstrip())
        if match and match[1] in ("code", "verbatim"):
            in_code = True
            sections[-1][1].append("```")
        elif match and match[1] in ("endcode", "endverbatim"):
            in_code = False
            sections[-1][1].append("```")
        elif match and not in_code:
            sections.append((match[1], [line.lstrip()[match.end():]]))
        elif not in_code and not line.strip() and len(sections) > 1 and sections[-1][0] not in ("", "brief", "details"):
            sections.append(("details", []))  # a blank line ends a tag's text
        else:
            sections[-1][1].append(line)
    return [(tag, "\n".join(lines)) for tag, lines in sections]


def _blocks(text: str) -> list[Block]:
    blocks: list[Block] = []
    gathered: list[str] = []

    def flush() -> None:
        if not gathered:
            return
        if _LIST_ITEM.match(gathered[0]):
            items: list[str] = []
            for line in gathered:
                if _LIST_ITEM.match(line) or not items:
                    items.append(_LIST_ITEM.sub("", line).strip())
                else:
                    items[-1] += " " + line.strip()
            blocks.append(Block("list", tuple(_inline(item) for item in items)))
        else:
            blocks.append(Block("text", tuple(line for line in _inline("\n".join(part.strip() for part in gathered)).split("\n") if line)))
        gathered.clear()

    code: list[str] | None = None
    for line in text.split("\n"):
        if line.strip().startswith("```"):
            if code is None:
                flush()
                code = []
            else:
                blocks.append(Block("code", tuple(textwrap.dedent("\n".join(code)).split("\n"))))
                code = None
        elif code is not None:
            code.append(line)
        elif not line.strip():
            flush()
        else:
            if _LIST_ITEM.match(line) and gathered and not _LIST_ITEM.match(gathered[0]):
                flush()
            gathered.append(line)
    if code is not None:
        blocks.append(Block("code", tuple(textwrap.dedent("\n".join(code)).split("\n"))))
    flush()
    return [block for block in blocks if any(line.strip() for line in block.lines)]


def _inline(text: str) -> str:
    if not ("@" in text or "\\" in text or "<" in text):
        return text
    for pattern, replacement in _INLINE:
        text = pattern.sub(replacement, text)
    return text


def _flow(text: str) -> str:
    return " ".join(_inline(text).split())


def _first_sentence(text: str) -> str:
    match = re.match(r"(.+?[.!?])(?=\s+[A-Z(`\"']|\s*$)", text)
    sentence = match[1] if match else text
    # "e.g. X" and the like end no sentence.
    while match and re.search(r"\b(?:e\.g|i\.e|etc|vs|approx|incl)\.$", sentence) and len(sentence) < len(text):
        rest = re.match(r".+?[.!?](?=\s+[A-Z(`\"']|\s*$)", text[len(sentence):])
        sentence = sentence + rest[0] if rest else text
        match = rest
    return sentence.strip()


# Writing ---------------------------------------------------------------------------------------------------------------------


def body_lines(documented: Documentation, width: int = 110) -> list[str]:
    """Summary and paragraphs as lines of plain text; one empty line between blocks."""
    lines: list[str] = []
    for block in documented.blocks:
        if lines:
            lines.append("")
        if block.kind == "text":
            lines += textwrap.wrap(block.text, width, break_long_words=False, break_on_hyphens=False) or [""]
        elif block.kind == "list":
            for item in block.lines:
                wrapped = textwrap.wrap(item, width - 2, break_long_words=False, break_on_hyphens=False) or [""]
                lines += [("  " if number else "- ") + line for number, line in enumerate(wrapped)]
        else:
            lines += ["    " + line for line in block.lines]
    return lines


def docstring(lines: Iterable[str], indent: str) -> list[str]:
    """A docstring of the lines, ready to be written at an indentation; no line if there is nothing to say."""
    text = [line.rstrip() for line in lines]
    while text and not text[0]:
        text.pop(0)
    while text and not text[-1]:
        text.pop()
    if not text:
        return []
    escaped = [line.replace("\\", "\\\\").replace('"""', '\\"\\"\\"') for line in text]
    if escaped[-1].endswith('"'):
        escaped[-1] = escaped[-1][:-1] + '\\"'
    escaped = ["".join(c if c.isprintable() else " " for c in line) for line in escaped]
    if len(escaped) == 1:
        return [f'{indent}"""{escaped[0]}"""']
    return [f'{indent}"""{escaped[0]}', *(f"{indent}{line}" if line else "" for line in escaped[1:]), f'{indent}"""']


def markdown(documented: Documentation) -> str:
    """Body, parameters, result and notes as Markdown."""
    parts: list[str] = []
    for block in documented.blocks:
        if block.kind == "code":
            parts.append("```\n" + block.text + "\n```")
        elif block.kind == "list":
            parts.append("\n".join(f"- {line}" for line in block.lines))
        else:
            parts.append("\n".join(block.lines))
    if documented.parameters:
        parts.append("\n".join(f"- `{name}`: {text}" for name, text in documented.parameters.items()))
    if documented.returns:
        parts.append(f"Returns {documented.returns}")
    parts += [f"{label}: {text}" for label, text in documented.notes]
    return "\n\n".join(parts)


def html_text(text: str) -> str:
    """Plain text as HTML: escaped, `code` marked, addresses made links."""
    escaped = _html.escape(text, quote=True)
    escaped = re.sub(r"`([^`]+)`", r"<code>\1</code>", escaped)
    return re.sub(r"\bhttps?://[^\s<>&]+(?:&amp;[^\s<>&]+)*[^\s<>&.,;:)]", lambda m: f'<a href="{m[0]}" rel="noopener">{m[0]}</a>', escaped)


def html_pieces(documented: Documentation) -> list[tuple[str, list[str]]]:
    """The blocks as (kind, safe HTML of each line); kind as in Block."""
    return [(b.kind, [_html.escape(line, quote=True) if b.kind == "code" else html_text(line) for line in b.lines]) for b in documented.blocks]
