# SPDX-License-Identifier: MIT
"""One header: its enums, structs, delegates and its class or interface, in the format of its team."""

from __future__ import annotations

import random

from .comments import words_of, written
from .functions import Functions
from .model import ClassType, DelegateType, EnumType, Header, StructType
from .properties import Properties, fresh_name
from .types import ENGINE_INCLUDES, Types, visible
from .vocabulary import ENUM_SUFFIXES, NOUNS, QUALIFIERS, RESERVED_ENTRIES, SENTENCES, STRUCT_SUFFIXES

COUNTS = {0: "", 1: "_OneParam", 2: "_TwoParams", 3: "_ThreeParams", 4: "_FourParams", 5: "_FiveParams", 6: "_SixParams"}


class Writer:
    """Makes the text of headers, and remembers the types that they declare for the headers after them."""

    def __init__(self, random_: random.Random, types: Types, type_names: set[str], compilable: bool):
        self.random, self.types, self.names, self.compilable = random_, types, type_names, compilable
        self.properties = Properties(random_, types, compilable)
        self.functions = Functions(random_, types, compilable)
        self.made_functions = self.made_properties = 0

    # Small types --------------------------------------------------------------------------------------------------------

    def type_name(self, prefix: str, stem: str, suffixes: list[str]) -> str:
        """A name not yet given, without regard to the prefix, as Unreal demands."""
        r = self.random
        for attempt in range(1000):
            core = stem + (r.choice(NOUNS) if attempt or r.random() < 0.7 else "") + r.choice(suffixes)
            if attempt > 10:
                core = stem + r.choice(QUALIFIERS) + r.choice(NOUNS) + r.choice(suffixes)
            if core.lower() not in self.names:
                self.names.add(core.lower())
                return prefix + core
        raise AssertionError("no name left")

    def enum(self, header: Header) -> list[str]:
        """A new enum in one of the forms."""
        r, indent = self.random, header.style.indent
        form = r.choices(["class", "regular", "namespaced"], [80, 12, 8])[0]
        name = self.type_name("E", header.stem.replace(header.module.name, "")[:24] if r.random() < 0.5 else header.topic, ENUM_SUFFIXES)
        flags = form == "class" and r.random() < 0.15
        underlying = r.choices(["uint8", "", "int32", "uint16"], [85, 5, 7, 3])[0] if form == "class" else ""
        taken: set[str] = set()
        entries: list[str] = []
        initials = "".join(c for c in name[1:] if c.isupper())[:4].upper()
        for _ in range(r.choice([2, 3, 3, 4, 4, 5, 6, 8, 12] + ([40] if r.random() < 0.02 and not flags else []))):
            entry = fresh_name(r, taken, r.choice(["{n}", "{q}", "{q}{n}"]), None)
            if form == "class" and r.random() < 0.03:
                word = r.choice(RESERVED_ENTRIES)
                if word.lower() not in taken:
                    taken.add(word.lower())
                    entry = word
            # Entries of a regular enum share the scope of the whole program; every one carries its enum's initials and a number.
            entries.append(f"{initials}{len(self.names)}_{entry}" if form == "regular" else entry)
        if flags:
            entries = ["None", *[e for e in entries if e not in ("None", "All")][:7]]
        found = EnumType(name, form, underlying, entries, header, flags)
        specifiers = ["BlueprintType"] if r.random() < 0.85 and (underlying == "uint8" or form != "class") else []
        if flags:
            specifiers += ["Flags"] if r.random() < 0.5 else []
            specifiers.append('meta = (Bitflags, UseEnumValuesAsMaskValuesInEditor = "true")')
        lines = written([f"{words_of(name[1:]).capitalize()}."] if r.random() < 0.6 else [], header.style, "")
        lines.append(f"UENUM({', '.join(specifiers)})")
        if form == "namespaced":
            lines += [f"namespace {name}", "{", f"{indent}enum Type", f"{indent}{{"]
        elif header.style.brace_below:
            lines += [f"enum {'class ' if form == 'class' else ''}{name}{' : ' + underlying if underlying else ''}", "{"]
        else:
            lines.append(f"enum {'class ' if form == 'class' else ''}{name}{' : ' + underlying if underlying else ''} {{")
        inner = indent * (2 if form == "namespaced" else 1)
        value = 0
        hidden = r.random() < 0.15 and not flags
        for i, entry in enumerate(entries):
            text = entry
            if flags:
                text += " = 0" if i == 0 else f" = 1 << {i - 1}" if r.random() < 0.8 else f" = {hex(1 << (i - 1))}"
            elif r.random() < 0.08:
                value += r.randint(1, 5)
                text += f" = {value}"
            value += 1
            meta = []
            if r.random() < 0.35:
                meta.append(f'DisplayName = "{words_of(entry).title()}"')
            if r.random() < 0.04:
                meta.append(r.choice(["Hidden", 'ToolTip = "One of many, really"']))
            text += f" UMETA({', '.join(meta)})" if meta else ""
            comment = r.random()
            if comment < 0.15:
                lines += written([f"{words_of(entry).capitalize()}, as usual."], header.style, inner)
            lines.append(f"{inner}{text}," + (f"  // {words_of(entry)}" if 0.15 < comment < 0.2 else ""))
        if hidden:
            lines.append(f"{inner}{name[1:] + '_MAX' if form == 'regular' else 'MAX'} UMETA(Hidden)")
        lines += [f"{indent}}};", "}"] if form == "namespaced" else ["};"]
        if flags and r.random() < 0.6:
            lines.append(f"ENUM_CLASS_FLAGS({name});")
        header.module.enums.append(found)
        return [*lines, ""]

    def struct(self, header: Header, count: int) -> list[str]:
        """A new struct with so many properties."""
        r, style = self.random, header.style
        parent = None
        candidates = header.module.structs
        if r.random() < 0.12:
            found = visible(r, self.types.modules, header.module, "structs")
            parent = found if isinstance(found, StructType) else None
        base = ""
        if parent:
            self.types.need(header, parent)
            base = f" : public {parent.name}"
        elif not self.compilable and r.random() < 0.05:
            self.types.include(header, "FTableRowBase")
            base = " : public FTableRowBase"
        struct = StructType(self.type_name("F", r.choice([header.topic, header.stem]), STRUCT_SUFFIXES), header, parent, set(parent.fields) if parent else set())
        specifiers = ["BlueprintType"] + ([] if r.random() < 0.95 else ["Atomic"])
        lines = written([f"{words_of(struct.name[1:]).capitalize()}. {r.choice(SENTENCES)}."] if r.random() < 0.6 else [], style, "")
        lines += [f"USTRUCT({', '.join(specifiers)})", f"struct {header.module.api + ' ' if r.random() < 0.7 else ''}{struct.name}{base}", "{"]
        lines.append(f"{style.indent}{'GENERATED_USTRUCT_BODY' if style.old_bodies else 'GENERATED_BODY'}()")
        lines.append("")
        if r.random() < 0.2:
            lines += [f"{style.indent}{struct.name}() = default;", ""]
        for _ in range(count):
            lines += [*self.properties.of_struct(struct, header, style.indent), ""]
        lines[-1:] = ["};", ""]
        candidates.append(struct)
        self.made_properties += count
        return lines

    def delegate(self, header: Header, owner: ClassType | None, indent: str = "") -> list[str]:
        """A dynamic delegate declaration."""
        r = self.random
        multicast = r.random() < 0.75
        if self.compilable:
            header.includes.add("UObject/ScriptDelegates.h")
        draft_names: set[str] = set()
        arguments = []
        for _ in range(r.choice([0, 1, 1, 2, 2, 3, 4, 6])):
            use = self.types.value(header)
            text = f"const {use.text}&" if use.large else use.text
            if "," in text:
                text = "int32"
            arguments.append(f"{text}, {fresh_name(r, draft_names, 'b{q}{n}' if use.kind == 'bool' else '{q}{n}')}")
        returns = not multicast and r.random() < 0.25
        name = self.type_name("F", ("On" if multicast else "") + header.topic, ["Changed", "Signature", "Event", "Delegate", "Dynamic"])
        parts = [name, *arguments]
        if returns:
            parts.insert(0, r.choice(["bool", "int32", "float", "FString"]))
        macro = f"DECLARE_DYNAMIC_{'MULTICAST_' if multicast else ''}DELEGATE{'_RetVal' if returns else ''}{COUNTS[len(arguments)]}"
        header.module.delegates.append(DelegateType(name, header, multicast, owner.name if owner else ""))
        lines = written([f"Broadcast when {words_of(name[1:])}."] if r.random() < 0.4 else [], header.style, indent)
        return [*lines, f"{indent}{macro}({', '.join(parts)});", ""]

    # Classes ------------------------------------------------------------------------------------------------------------

    def interface(self, header: Header, interface: ClassType, functions: int) -> list[str]:
        """A UINTERFACE pair."""
        style, api = header.style, header.module.api
        header.includes.add(ENGINE_INCLUDES["UInterface"])
        native = "I" + interface.name[1:]
        lines = [f"UINTERFACE({self.random.choice(['', 'BlueprintType', 'Blueprintable'])})", f"class {api} {interface.name} : public UInterface", "{", f"{style.indent}GENERATED_BODY()", "};", "",
                 *written([f"What {words_of(interface.name[1:])} can do."], style, ""), f"class {api} {native}", "{", f"{style.indent}GENERATED_BODY()", "", "public:"]
        for _ in range(functions):
            made, source = self.functions.of_class(interface, header, style.indent, "public")
            lines += [*made, ""]
            header.source += source
        self.made_functions += functions
        lines[-1:] = ["};", ""]
        header.module.interfaces.append(interface)
        return lines

    def class_(self, header: Header, class_: ClassType, functions: int, properties: int) -> list[str]:
        """A class with so many functions and properties, accessor functions counted among the functions."""
        r, style, api = self.random, header.style, header.module.api
        indent = style.indent
        lines = written([f"{words_of(class_.name[1:]).capitalize()}.", *(["", r.choice(SENTENCES) + "."] if r.random() < 0.5 else [])] if r.random() < 0.75 else [], style, "")
        lines += [f"UCLASS({', '.join(self._class_specifiers(class_, header))})", f"class {api} {class_.name} : public {class_.base}{''.join(', public ' + i for i in class_.interfaces)}"]
        lines[-1] += "" if style.brace_below else " {"
        lines += ["{"] if style.brace_below else []
        body = class_.old_body
        lines += [f"{indent}{'GENERATED_UCLASS_BODY' if body else 'GENERATED_BODY'}()", ""]
        name = class_.name
        possible = class_.super_constructors
        class_.constructors = {"default", "initializer"} if "initializer" in possible else {"default"}
        if body:
            class_.constructors = {"initializer"}
            header.source.append(f"{name}::{name}(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {{}}")
        elif class_.kind != "library" and r.random() < 0.5:
            if "default" in possible and (r.random() < 0.6 or "initializer" not in possible):
                class_.constructors = {"default"}
                lines += ["public:", f"{indent}{name}();", ""]
                header.source.append(f"{name}::{name}() {{}}")
            else:
                lines += ["public:", f"{indent}{name}(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());", ""]
                header.source.append(f"{name}::{name}(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {{}}")
        if class_.kind == "actor" and r.random() < 0.3:
            lines += [*([] if lines[-2:-1] == ["public:"] else ["protected:"]), f"{indent}virtual void BeginPlay() override;", ""]
            header.source.append(f"void {name}::BeginPlay() {{ Super::BeginPlay(); }}")
        if r.random() < 0.06 and class_.kind != "library":
            lines += ["public:", *self.delegate(header, class_, indent)]
        lines += self._members(header, class_, functions, properties)
        lines += ["};", ""]
        header.module.classes.append(class_)
        return lines

    def _members(self, header: Header, class_: ClassType, functions: int, properties: int) -> list[str]:
        r, indent = self.random, header.style.indent
        lines: list[str] = []
        blocks = []  # (access, functions, properties)
        if class_.kind == "library":
            blocks = [("public", functions, 0)]
        else:
            shares = r.choice([[("public", 1.0, 1.0)], [("public", 0.7, 0.6), ("protected", 0.3, 0.4)], [("public", 0.6, 0.5), ("protected", 0.25, 0.3), ("private", 0.15, 0.2)], [("protected", 0.2, 0.6), ("public", 0.8, 0.4)]])
            left_f, left_p = functions, properties
            for i, (access, f, p) in enumerate(shares):
                last = i == len(shares) - 1
                blocks.append((access, left_f if last else round(functions * f), left_p if last else round(properties * p)))
                left_f, left_p = left_f - blocks[-1][1], left_p - blocks[-1][2]
        if functions and r.random() < 0.5:
            blocks = [b for access, f, p in blocks for b in ((access, 0, p), (access, f, 0))]
        spare = 0  # functions that properties brought along; taken from the next block
        for access, wanted_functions, wanted_properties in blocks:
            parts: list[list[str]] = []
            public: list[str] = []
            made = 0
            for _ in range(wanted_properties):
                own, extra, source = self.properties.of_class(class_, header, indent, access)
                parts.append(own)
                public += extra
                header.source += source
                made += sum(line.lstrip().startswith("UFUNCTION") for line in extra)
            spare += made
            use = min(spare, wanted_functions)
            spare -= use
            for _ in range(wanted_functions - use):
                own, source = self.functions.of_class(class_, header, indent, access)
                parts.append(own)
                header.source += source
            self.made_functions += wanted_functions - use + made
            self.made_properties += wanted_properties
            if public:
                lines += ["public:", *public]
            if parts:
                lines.append(f"{access}:")
                if r.random() < 0.3 and wanted_functions and wanted_properties:
                    r.shuffle(parts)
                for part in parts:
                    lines += [*part, ""]
        return lines

    def _class_specifiers(self, class_: ClassType, header: Header) -> list[str]:
        r = self.random
        specifiers = []
        if class_.kind == "library":
            return r.choice([[], ['meta = (ScriptName = "' + class_.name[1:] + 'Lib")'], ["BlueprintType"]])
        chance = r.random()
        if chance < 0.3:
            specifiers.append("Blueprintable")
        elif chance < 0.5:
            specifiers.append("BlueprintType")
        elif chance < 0.55:
            specifiers += ["Abstract", "BlueprintType"]
        if class_.kind == "component":
            specifiers += [f"ClassGroup = ({header.topic})", "meta = (BlueprintSpawnableComponent)"] if r.random() < 0.7 else []
        if class_.kind == "object" and r.random() < 0.1:
            specifiers += ["DefaultToInstanced", "EditInlineNew"]
        if r.random() < 0.05:
            specifiers.append(r.choice(["NotPlaceable", "Transient", "HideDropdown", 'hidecategories = (Object, Mobility)', 'meta = (DisplayName = "Renamed for the editor")']))
            if specifiers[-1].startswith("meta") and any(s.startswith("meta") for s in specifiers[:-1]):
                specifiers.pop()
        return specifiers
