# SPDX-License-Identifier: MIT
"""What changed between two schemas, and what of it breaks programs that use the old one.

A change is *breaking* if a program written against the old schema may fail against the new one (Python or C++): something is gone, a type, the order or
the direction of parameters changed, an enum entry has another value. Everything else is *compatible*.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

from .schema import KINDS, Entity, SchemaSet

#: From the least to the most: each tier is compared together with those before it (SCHEMA.md section 1).
TIERS = ("runtime", "editor", "source")
SINGULAR = {"classes": "class", "structs": "struct", "enums": "enum", "delegates": "delegate"}

#: Flags whose appearance or disappearance breaks programs.
BREAKING_FLAGS_ADDED = {"class": {"Abstract"}, "function": {"Static", "EditorOnly", "NetServer", "NetClient", "NetMulticast", "NetRequest", "NetResponse"}, "property": {"EditorOnly", "ConstParm"},
                        "enum": {"Flags"}}
BREAKING_FLAGS_REMOVED = {"function": {"Static", "NetServer", "NetClient", "NetMulticast", "NetRequest", "NetResponse"}, "enum": {"Flags"}}
#: Metadata that changes how a function is called.
BREAKING_META = {"Latent", "LatentInfo", "WorldContext", "CustomThunk"}
#: Metadata that repeats the source tier; compared with that tier only.
SOURCE_META = {"Comment", "ToolTip", "ShortTooltip", "ModuleRelativePath", "IncludePath", "Name", "NativeConst", "NativeConstTemplateArg"}
#: Flags that only repeat what the parameters' directions and types say.
IMPLIED_FLAGS = {"parameter": {"OutParm", "ReferenceParm", "ConstParm"}, "function": {"HasOutParms", "HasDefaults"}, "delegate": {"HasOutParms", "HasDefaults"}}

OBJECT_KINDS = {"object", "class", "weak_object", "lazy_object", "soft_object", "soft_class", "interface"}


@dataclass(frozen=True)
class Change:
    """One difference."""

    severity: str  # breaking | compatible
    change: str  # removed | changed | added
    kind: str  # module, class, struct, enum, delegate, function, property, parameter, return, entry
    module: str
    subject: str  # "AActor.GetName", "ECollisionChannel.ECC_Pawn", "AActor.SetOwner(NewOwner)"
    facet: str  # what of it changed: "type", "default", "super" ...; "" if it is there or not
    old: Any
    new: Any
    text: str  # the change in words, without the subject

    def to_dict(self) -> dict[str, Any]:
        """For JSON."""
        return asdict(self)


def diff(old: SchemaSet, new: SchemaSet, tier: str = "editor") -> list[Change]:
    """All differences, sorted by module, subject and kind. Parts that only one of both has (a live dump has no source tier) are not compared."""
    if tier not in TIERS:
        raise ValueError(f"no such tier: {tier}")
    found = list(_Comparison(old, new, TIERS.index(tier)).run())
    return sorted(found, key=lambda c: (c.module, c.subject, c.kind, c.facet, c.change))


class _Comparison:
    def __init__(self, old: SchemaSet, new: SchemaSet, depth: int):
        self.old, self.new, self.depth = old, new, depth

    def run(self) -> Iterator[Change]:
        old_modules, new_modules = {m.name for m in self.old.main_modules}, {m.name for m in self.new.main_modules}
        for name in sorted(old_modules - new_modules):
            yield Change("breaking", "removed", "module", name, name, "", name, None, "is gone")
        for name in sorted(new_modules - old_modules):
            yield Change("compatible", "added", "module", name, name, "", None, name, "is new")
        for kind in KINDS:
            left, right = _by_key(self.old.main[kind]), _by_key(self.new.main[kind])
            single = SINGULAR[kind]
            for key in sorted(left.keys() - right.keys()):
                yield Change("breaking", "removed", single, left[key]["module"], _title(left[key]), "", left[key].get("path"), None, "is gone")
            for key in sorted(right.keys() - left.keys()):
                yield Change("compatible", "added", single, right[key]["module"], _title(right[key]), "", None, right[key].get("path"), "is new")
            for key in sorted(left.keys() & right.keys()):
                yield from self._type(single, left[key], right[key])

    # Types --------------------------------------------------------------------------------------------------------------

    def _type(self, kind: str, old: Entity, new: Entity) -> Iterator[Change]:
        module, subject = new["module"], _title(new)

        def change(severity: str, facet: str, before: Any, after: Any, text: str) -> Change:
            return Change(severity, "changed", kind, module, subject, facet, before, after, text)

        if old["module"] != new["module"]:
            yield change("breaking", "module", old["module"], new["module"], f"moved from module {old['module']} to {new['module']}")
        elif old.get("path") != new.get("path"):
            yield change("breaking", "path", old.get("path"), new.get("path"), f"has the path {new.get('path')}, it was {old.get('path')}")
        yield from self._flags(kind, old, new, change)
        if kind in ("class", "struct"):
            yield from self._super(old, new, change)
            yield from self._members("property", old, new)
        if kind == "class":
            for gone in sorted(set(old["interfaces"]) - set(new["interfaces"])):
                severity = "compatible" if self._implements(new["super"], gone) else "breaking"
                yield change(severity, "interface", gone, None, f"no longer implements {gone}" + ("; its super class does" if severity == "compatible" else ""))
            for added in sorted(set(new["interfaces"]) - set(old["interfaces"])):
                yield change("compatible", "interface", None, added, f"implements {added}")
            for facet in ("within", "config"):
                if old[facet] != new[facet]:
                    yield change("compatible", facet, old[facet], new[facet], f"has {facet} '{new[facet]}', it was '{old[facet]}'")
            yield from self._members("function", old, new)
        if kind == "enum":
            for facet in ("form", "cpp_type"):
                if old[facet] != new[facet]:
                    yield change("breaking", facet, old[facet], new[facet], f"has {facet} {new[facet]}, it was {old[facet]}")
            yield from self._entries(old, new)
        if kind == "delegate":
            if old["kind"] != new["kind"]:
                yield change("breaking", "kind", old["kind"], new["kind"], f"is a {new['kind']} delegate, it was {old['kind']}")
            yield from self._signature(kind, module, subject, old, new)
        yield from self._meta_and_source(change, old, new)

    def _super(self, old: Entity, new: Entity, change: Any) -> Iterator[Change]:
        if old["super"] == new["super"]:
            return
        kept = old["super"] is None or old["super"] in self.new.ancestors(new["name"])
        yield change("compatible" if kept else "breaking", "super", old["super"], new["super"],
                     f"derives from {new['super'] or 'nothing'}, it was {old['super'] or 'nothing'}" + (f" (which is a base of {new['super']})" if kept and old["super"] else ""))

    def _implements(self, name: str | None, interface: str) -> bool:
        while name and name in self.new.classes:
            if interface in self.new.classes[name]["interfaces"]:
                return True
            name = self.new.classes[name]["super"]
        return False

    def _inherited(self, owner: Entity, kind: str, name: str) -> str | None:
        """The ancestor, in the new schema, that has a member of this name."""
        collection = "functions" if kind == "function" else "properties"
        for above in self.new.ancestors(owner["name"]):
            entity = self.new.classes.get(above) or self.new.structs.get(above)
            if entity and any(m["name"] == name for m in entity.get(collection, [])):
                return above
        return None

    # Members ------------------------------------------------------------------------------------------------------------

    def _members(self, kind: str, old: Entity, new: Entity) -> Iterator[Change]:
        collection = "functions" if kind == "function" else "properties"
        left, right = {m["name"]: m for m in old[collection]}, {m["name"]: m for m in new[collection]}
        module = new["module"]
        for name in sorted(left.keys() - right.keys()):
            above = self._inherited(new, kind, name)
            spelled = _signature_text(left[name]) if kind == "function" else left[name]["type"]["cpp"]
            text = f"moved up to {above}" if above else "is gone"
            yield Change("compatible" if above else "breaking", "changed" if above else "removed", kind, module, f"{_title(new)}.{name}", "owner" if above else "", spelled, above, text)
        for name in sorted(right.keys() - left.keys()):
            spelled = _signature_text(right[name]) if kind == "function" else right[name]["type"]["cpp"]
            yield Change("compatible", "added", kind, module, f"{_title(new)}.{name}", "", None, spelled, f"is new: {spelled}")
        for name in sorted(left.keys() & right.keys()):
            yield from (self._function if kind == "function" else self._property)(new, left[name], right[name])
        if kind == "property" and old["name"] in self.old.structs:
            order = [n for n in left if n in right]
            if order != [n for n in right if n in left]:
                yield Change("breaking", "changed", "struct", module, _title(new), "order", list(left), list(right), "has its members in another order")

    def _property(self, owner: Entity, old: Entity, new: Entity) -> Iterator[Change]:
        subject = f"{_title(owner)}.{new['name']}"

        def change(severity: str, facet: str, before: Any, after: Any, text: str) -> Change:
            return Change(severity, "changed", "property", owner["module"], subject, facet, before, after, text)

        yield from self._types(old, new, change, widening=None)
        yield from self._flags("property", old, new, change)
        for facet, word in (("rep_notify", "replication notification"), ("native_getter", "native getter"), ("native_setter", "native setter")):
            if old.get(facet) != new.get(facet):
                yield change("compatible", facet, old.get(facet), new.get(facet), f"{word} {_shown(new.get(facet))}, it was {_shown(old.get(facet))}")
        yield from self._meta_and_source(change, old, new)

    def _function(self, owner: Entity, old: Entity, new: Entity) -> Iterator[Change]:
        subject = f"{_title(owner)}.{new['name']}"

        def change(severity: str, facet: str, before: Any, after: Any, text: str) -> Change:
            return Change(severity, "changed", "function", owner["module"], subject, facet, before, after, text)

        yield from self._flags("function", old, new, change)
        yield from self._signature("function", owner["module"], subject, old, new)
        yield from self._meta_and_source(change, old, new)

    def _signature(self, kind: str, module: str, subject: str, old: Entity, new: Entity) -> Iterator[Change]:
        def change(severity: str, facet: str, before: Any, after: Any, text: str) -> Change:
            return Change(severity, "changed", kind, module, subject, facet, before, after, text)

        before, after = old["returns"], new["returns"]
        if (before is None) != (after is None):
            yield change("compatible" if before is None and not any(_direction(p) == "out" for p in old["parameters"]) else "breaking", "returns", before and before["type"]["cpp"], after and after["type"]["cpp"],
                         f"returns {after['type']['cpp'] if after else 'nothing'}, it was {before['type']['cpp'] if before else 'nothing'}")
        elif before is not None:
            yield from self._types(before, after, lambda s, f, b, a, t: Change(s, "changed", "return", module, subject, f, b, a, "return value: " + t), widening="return")
        left, right = {p["name"]: p for p in old["parameters"]}, {p["name"]: p for p in new["parameters"]}
        renamed = _renamed(old["parameters"], new["parameters"])
        for was, now in renamed:
            yield change("breaking", "parameter name", was, now, f"parameter {was} is called {now}")
        gone, came = {a for a, _ in renamed}, {b for _, b in renamed}
        for name in left:
            if name not in right and name not in gone:
                yield Change("breaking", "removed", "parameter", module, f"{subject}({name})", "", left[name]["type"]["cpp"], None, "is gone")
        names = list(right)
        for name in right:
            if name not in left and name not in came:
                last = all(n not in left for n in names[names.index(name) :])
                harmless = _default(right[name]) is not None and last
                yield Change("compatible" if harmless else "breaking", "added", "parameter", module, f"{subject}({name})", "", None, right[name]["type"]["cpp"],
                             "is new" + (f", with the default {_default(right[name]) or '(empty)'!s}" if _default(right[name]) is not None else ", without default") + ("" if last else ", before others"))
        if [n for n in left if n in right] != [n for n in right if n in left]:
            yield change("breaking", "order", list(left), list(right), f"has its parameters in another order: {', '.join(right)}; it was {', '.join(left)}")
        for was, now in [*((n, n) for n in left if n in right), *renamed]:
            yield from self._parameter(module, f"{subject}({now})", left[was], right[now])

    def _parameter(self, module: str, subject: str, old: Entity, new: Entity) -> Iterator[Change]:
        def change(severity: str, facet: str, before: Any, after: Any, text: str) -> Change:
            return Change(severity, "changed", "parameter", module, subject, facet, before, after, text)

        before, after = _direction(old), _direction(new)
        if before != after:
            yield change("breaking", "direction", before, after, f"is {_DIRECTIONS[after]}, it was {_DIRECTIONS[before]}")
        yield from self._types(old, new, change, widening="parameter" if after == "in" else None)
        yield from self._flags("parameter", old, new, change)
        if self.depth >= 1 and "editor" in old and "editor" in new:
            old_default, new_default = _default(old), _default(new)
            if old_default != new_default:
                if new_default is None:
                    yield change("breaking", "default", old_default, None, f"has no default any more, it was {old_default or '(empty)'}")
                elif old_default is None:
                    yield change("compatible", "default", None, new_default, f"has a default: {new_default or '(empty)'}")
                else:
                    yield change("compatible", "default", old_default, new_default, f"has the default {new_default or '(empty)'}, it was {old_default or '(empty)'}")
        yield from self._meta_and_source(change, old, new)

    def _entries(self, old: Entity, new: Entity) -> Iterator[Change]:
        left, right = {e["name"]: e for e in old["entries"]}, {e["name"]: e for e in new["entries"]}
        module, title = new["module"], _title(new)
        for name in left:
            if name not in right:
                yield Change("breaking", "removed", "entry", module, f"{title}.{_short(name)}", "", left[name]["value"], None, f"is gone (it was {left[name]['value']})")
        for name in right:
            subject = f"{title}.{_short(name)}"
            if name not in left:
                yield Change("compatible", "added", "entry", module, subject, "", None, right[name]["value"], f"is new, value {right[name]['value']}")
                continue

            def change(severity: str, facet: str, before: Any, after: Any, text: str, subject: str = subject) -> Change:
                return Change(severity, "changed", "entry", module, subject, facet, before, after, text)

            if left[name]["value"] != right[name]["value"]:
                yield change("breaking", "value", left[name]["value"], right[name]["value"], f"has the value {right[name]['value']}, it was {left[name]['value']}")
            yield from self._meta_and_source(change, left[name], right[name])

    # Parts --------------------------------------------------------------------------------------------------------------

    def _types(self, old: Entity, new: Entity, change: Any, widening: str | None) -> Iterator[Change]:
        before, after = old["type"], new["type"]
        if before != after:
            same = {k: v for k, v in before.items() if k != "bitfield"} == {k: v for k, v in after.items() if k != "bitfield"}
            if same:
                yield change("compatible", "type", _type_text(before), _type_text(after), f"is {_type_text(after)}, it was {_type_text(before)}")
            else:
                severity = "compatible" if widening and self._widened(before, after, widening) else "breaking"
                yield change(severity, "type", _type_text(before), _type_text(after), f"has the type {_type_text(after)}, it was {_type_text(before)}")
        if old.get("array_dim", 1) != new.get("array_dim", 1):
            yield change("breaking", "array_dim", old["array_dim"], new["array_dim"], f"is an array of {new['array_dim']}, it was {old['array_dim']}")

    def _widened(self, before: Entity, after: Entity, where: str) -> bool:
        """A parameter that takes more, a return value that promises more."""
        if before["kind"] != after["kind"] or before["kind"] not in OBJECT_KINDS:
            return False
        special, general = (before["name"], after["name"]) if where == "parameter" else (after["name"], before["name"])
        return general == "UObject" or self.new.is_a(special, general)

    def _flags(self, kind: str, old: Entity, new: Entity, change: Any) -> Iterator[Change]:
        without = IMPLIED_FLAGS.get(kind, set())
        before, after = set(old.get("flags", ())) - without, set(new.get("flags", ())) - without
        for flag in sorted(after - before):
            yield change("breaking" if flag in BREAKING_FLAGS_ADDED.get(kind, ()) else "compatible", "flag", None, flag, f"is {flag} now")
        for flag in sorted(before - after):
            yield change("breaking" if flag in BREAKING_FLAGS_REMOVED.get(kind, ()) else "compatible", "flag", flag, None, f"is no longer {flag}")

    def _meta_and_source(self, change: Any, old: Entity, new: Entity) -> Iterator[Change]:
        if self.depth >= 1 and "editor" in old and "editor" in new:
            before, after = old["editor"].get("meta", {}), new["editor"].get("meta", {})
            for key in sorted(before.keys() | after.keys()):
                if before.get(key) == after.get(key) or key.startswith("CPP_Default_") or (key in SOURCE_META and self.depth < 2):
                    continue
                severity = "breaking" if key in BREAKING_META else "compatible"
                if key not in before:
                    yield change(severity, f"meta {key}", None, after[key], f"has the metadata {key} = '{_cut(after[key])}'")
                elif key not in after:
                    yield change(severity, f"meta {key}", before[key], None, f"has no metadata {key} any more (it was '{_cut(before[key])}')")
                else:
                    yield change(severity, f"meta {key}", before[key], after[key], f"has the metadata {key} = '{_cut(after[key])}', it was '{_cut(before[key])}'")
        if self.depth >= 2 and "source" in old and "source" in new:
            before, after = old["source"], new["source"]
            for key in ("header", "type_text", "default", "cpp_name", "access", "underlying", "comment", "deprecated"):
                if before.get(key) != after.get(key):
                    yield change("compatible", f"source {key}", before.get(key), after.get(key), f"{_SOURCE_WORDS.get(key, key)} {_shown(after.get(key))}, it was {_shown(before.get(key))}")


_DIRECTIONS = {"in": "an input", "out": "an output", "ref": "an input and output"}
_SOURCE_WORDS = {"type_text": "is written", "default": "C++ default", "header": "header", "cpp_name": "C++ name"}


def _by_key(entities: list[Entity]) -> dict[tuple[str, str], Entity]:
    return {(e.get("owner") or "", e["name"]): e for e in entities}


def _title(entity: Entity) -> str:
    owner = entity.get("owner")
    return f"{owner}.{entity['name']}" if isinstance(owner, str) and owner else str(entity["name"])


def _short(name: str) -> str:
    return name.rpartition("::")[2]


def _direction(parameter: Entity) -> str:
    flags = parameter["flags"]
    if "OutParm" not in flags or "ConstParm" in flags:
        return "in"
    return "ref" if "ReferenceParm" in flags else "out"


def _default(parameter: Entity) -> str | None:
    default: str | None = parameter.get("editor", {}).get("default", parameter.get("source", {}).get("default"))
    return default


def _renamed(old: list[Entity], new: list[Entity]) -> list[tuple[str, str]]:
    """Parameters at the same place, with the same type, whose name alone is another one."""
    if len(old) != len(new):
        return []
    names_old, names_new = {p["name"] for p in old}, {p["name"] for p in new}
    return [(a["name"], b["name"]) for a, b in zip(old, new, strict=True) if a["name"] not in names_new and b["name"] not in names_old and a["type"] == b["type"]]


def _type_text(node: Entity) -> str:
    text = str(node["cpp"])
    return f"{text} (bit field)" if node.get("bitfield") else text


def _signature_text(function: Entity) -> str:
    returns = function["returns"]["type"]["cpp"] if function["returns"] else "void"
    return f"{returns} {function['name']}({', '.join(p['type']['cpp'] + ' ' + p['name'] for p in function['parameters'])})"


def _shown(value: Any) -> str:
    return "(none)" if value in (None, "") else f"'{_cut(str(value))}'"


def _cut(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= 120 else line[:117] + "..."
