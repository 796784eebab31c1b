# SPDX-License-Identifier: MIT
"""UPROPERTYs of classes and structs."""

from __future__ import annotations

import random
from collections.abc import Set

from .comments import property_comment, unit_of, written
from .model import ClassType, DelegateType, Header, StructType
from .types import Types, Use, visible
from .vocabulary import NOUNS, QUALIFIERS, RESERVED_PROPERTIES, RESERVED_STRUCT_FIELDS


def fresh_name(r: random.Random, taken: set[str], pattern: str = "{q}{n}", reserved: list[str] | None = None, topic: str = "", beside: Set[str] = frozenset()) -> str:
    """A name that nobody in the hierarchy (`taken`) or in `beside` has, added to `taken`; now and then a word reserved elsewhere."""
    if reserved and r.random() < 0.004:
        word = r.choice(reserved)
        if word.lower() not in taken and word.lower() not in beside:
            taken.add(word.lower())
            return word
    for attempt in range(1000):
        q, n = r.choice(QUALIFIERS), r.choice(NOUNS)
        if attempt > 3:
            n = n + r.choice(NOUNS)
        if topic and r.random() < 0.3:
            q = q + topic
        name = pattern.format(q=q, n=n)
        if attempt > 20:
            name += str(attempt)
        if name.lower() not in taken and name.lower() not in beside:
            taken.add(name.lower())
            return name
    raise AssertionError("no name left")


class Properties:
    """Writes properties. `declarations` go into the header; accessors that a property asks for come along."""

    def __init__(self, random_: random.Random, types: Types, compilable: bool):
        self.random, self.types, self.compilable = random_, types, compilable

    def of_struct(self, struct: StructType, header: Header, indent: str) -> list[str]:
        """One property of a struct."""
        r = self.random
        blueprint = r.random() < 0.7
        use = self.types.member(header, blueprint, struct)
        blueprint = blueprint and use.blueprint
        bits = use.kind == "bool" and r.random() < 0.15
        reserved = None if use.kind == "bool" else RESERVED_STRUCT_FIELDS
        name = fresh_name(r, struct.fields, "b{q}{n}" if use.kind == "bool" else r.choice(["{n}", "{q}{n}", "{q}{n}"]), reserved)
        specifiers = [r.choice(["EditAnywhere", "EditAnywhere", "VisibleAnywhere", "EditDefaultsOnly"])] if r.random() < 0.8 else []
        if blueprint:
            specifiers += [r.choice(["BlueprintReadWrite", "BlueprintReadWrite", "BlueprintReadOnly"]), f'Category="{r.choice([header.topic, header.topic + "|" + header.module.name])}"']
        if r.random() < 0.05:
            specifiers.append(r.choice(["Transient", "SaveGame", "NotReplicated"]))
        return self._write(header, indent, use, name, specifiers, self._meta(use, name, False), bits, fixed=not blueprint and r.random() < 0.06)

    def of_class(self, owner: ClassType, header: Header, indent: str, access: str) -> tuple[list[str], list[str], list[str]]:
        """One property of a class: (lines, public lines that belong to it, lines of the source file)."""
        r = self.random
        if r.random() < 0.035:
            delegate = self._delegate(owner, header)
            if delegate:
                return self._event(owner, header, indent, delegate), [], []
        blueprint = r.random() < 0.65
        use = self.types.member(header, blueprint)
        blueprint = blueprint and use.blueprint
        bits = use.kind == "bool" and r.random() < 0.25
        name = fresh_name(r, owner.names, "b{q}{n}" if use.kind == "bool" else r.choice(["{q}{n}", "{q}{n}", "{n}" + owner.kind.capitalize()]), None if use.kind == "bool" else RESERVED_PROPERTIES, header.topic, owner.parameters)
        component = use.kind == "object" and str(use.of).endswith("Component")
        public: list[str] = []
        source: list[str] = []
        specifiers: list[str] = []
        extra: list[str] = []
        if component:
            specifiers = ["VisibleAnywhere"] if r.random() < 0.7 else ["EditDefaultsOnly", "Instanced"]
        elif r.random() < 0.82:
            specifiers = [r.choice(["EditAnywhere", "EditAnywhere", "EditDefaultsOnly", "EditInstanceOnly", "VisibleAnywhere", "VisibleInstanceOnly", "EditAnywhere, AdvancedDisplay"])]
        if blueprint:
            read_only = r.random() < 0.4 or component
            if not component and (use.kind == "object" or "TObjectPtr" not in use.text) and r.random() < 0.02 and access == "public" and self._accessors_free(owner, use, name, blueprint=True):
                specifiers.append(f"BlueprintGetter=Get{name}, BlueprintSetter=Set{name}")
                made = self._accessors(owner, header, indent, use, name, blueprint=True)
                public, source = made
            else:
                specifiers.append("BlueprintReadOnly" if read_only else "BlueprintReadWrite")
            if access == "private":
                extra.append('AllowPrivateAccess="true"')
        elif r.random() < 0.02 and use.kind in ("number", "bool", "core_struct") and not bits and access != "private" and self._accessors_free(owner, use, name, blueprint=False):
            specifiers += ["Getter", "Setter"]
            public, source = self._accessors(owner, header, indent, use, name, blueprint=False)
        if specifiers or r.random() < 0.5:
            specifiers.append(f"Category = {r.choice([chr(34) + header.topic + chr(34), chr(34) + header.topic + '|Advanced' + chr(34), header.topic, chr(34) + header.module.name + chr(34)])}")
        specifiers += [s for s, chance in (("Transient", 0.05), ("SaveGame", 0.03), ("DuplicateTransient", 0.01), ("Interp", 0.01), ("NoClear", 0.01)) if r.random() < chance and not (s == "Interp" and not blueprint)]
        if owner.kind in ("actor", "component") and r.random() < 0.04 and use.kind not in ("map", "set", "optional"):
            if r.random() < 0.5:
                specifiers.append("Replicated")
            elif f"onrep_{name.lower()}" not in owner.names:
                owner.names.add(f"onrep_{name.lower()}")
                specifiers.append(f"ReplicatedUsing = OnRep_{name}")
                public += [f"{indent}UFUNCTION()", f"{indent}void OnRep_{name}();", ""]
                source.append(f"void {owner.name}::OnRep_{name}() {{}}")
        lines = self._write(header, indent, use, name, specifiers, self._meta(use, name, True) + extra, bits, fixed=not blueprint and not public and use.kind == "number" and r.random() < 0.04)
        if r.random() < 0.025 and not public and not blueprint:
            lines = ["#if WITH_EDITORONLY_DATA", *lines, "#endif"]
        return lines, public, source

    # Parts --------------------------------------------------------------------------------------------------------------

    def _write(self, header: Header, indent: str, use: Use, name: str, specifiers: list[str], meta: list[str], bits: bool, fixed: bool = False) -> list[str]:
        r, style = self.random, header.style
        if meta:
            joined = ", ".join(meta)
            specifiers = [*specifiers, f"meta = ({joined})" if r.random() < 0.6 else f"meta=({joined})"]
        macro = f"UPROPERTY({', '.join(specifiers)})"
        if bits:
            declaration = f"{r.choice(['uint8', 'uint32'])} {name} : 1;"
        elif fixed and use.kind == "number":
            declaration = f"{use.text} {name}[{r.choice([2, 3, 4, 8])}];"
        else:
            default = f" = {r.choice(use.defaults)}" if use.defaults and r.random() < 0.75 else ""
            if use.kind in ("core_struct", "string", "array") and not default and r.random() < 0.04:
                default = "{}"
            declaration = f"{use.text} {name}{default};"
        lines = written(property_comment(r, name), style, indent)
        if style.one_line_properties and len(macro) + len(declaration) < 140:
            lines.append(f"{indent}{macro} {declaration}")
        else:
            lines += [indent + macro, indent + declaration]
        return lines

    def _meta(self, use: Use, name: str, of_class: bool) -> list[str]:
        r = self.random
        meta = []
        unit = unit_of(name)
        if use.kind == "number":
            if r.random() < 0.3:
                low, high = r.choice([("0", "1"), ("0.0", "1.0"), ("-180", "180"), ("1", "100")])
                meta += [f'ClampMin = "{low}"', f'ClampMax = "{high}"']
                if r.random() < 0.5:
                    meta += [f"UIMin = {low}", f"UIMax = {high}"]
            if unit and r.random() < 0.6:
                meta.append(f'Units = "{unit[1]}"')
        if r.random() < 0.05:
            meta.append(f'DisplayName = "{name} (beta, \\"v2\\")"')
        if r.random() < 0.05:
            meta.append(r.choice(['EditCondition = "bEnabled && Mode != 2"', "EditConditionHides", "InlineEditConditionToggle", 'ToolTip = "Written by hand, with a comma"', "ShowOnlyInnerProperties"]))
        if use.text == "FVector" and r.random() < 0.3:
            meta.append("MakeEditWidget")
        if use.kind == "array" and r.random() < 0.1:
            meta.append('TitleProperty = "{Name}: {Value}"')
        if of_class and r.random() < 0.02:
            meta.append('ExposeOnSpawn = "true"')
        if use.kind == "object" and r.random() < 0.1:
            meta.append('AllowedClasses = "/Script/Engine.StaticMesh, /Script/Engine.Texture2D"')
        return meta

    @staticmethod
    def _accessor_name(use: Use, name: str, blueprint: bool) -> str:
        """What stands behind Get and Set."""
        return name[1:] if use.kind == "bool" and not blueprint else name  # Unreal drops the b there

    def _accessors_free(self, owner: ClassType, use: Use, name: str, blueprint: bool) -> bool:
        """Whether the hierarchy has no functions of these names yet."""
        called = self._accessor_name(use, name, blueprint).lower()
        return not {f"get{called}", f"set{called}", f"new{name.lower()}"} & owner.names

    def _accessors(self, owner: ClassType, header: Header, indent: str, use: Use, name: str, blueprint: bool) -> tuple[list[str], list[str]]:
        called = self._accessor_name(use, name, blueprint)
        owner.names |= {f"get{called.lower()}", f"set{called.lower()}"}
        owner.parameters.add(f"new{name.lower()}")
        # Accessors are functions: plain pointers, as Unreal's header tool wants them.
        plain = f"{use.of}*" if use.kind == "object" else use.text
        value = f"const {plain}&" if use.large else plain
        marks = [f"{indent}UFUNCTION(BlueprintGetter)", f"{indent}UFUNCTION(BlueprintSetter)"] if blueprint else [None, None]
        declared = [f"{indent}{plain} Get{called}() const;", f"{indent}void Set{called}({value} New{name});"]
        lines = [line for pair in zip(marks, declared, strict=True) for line in pair if line] + [""]
        source = [f"{plain} {owner.name}::Get{called}() const {{ return {name}; }}", f"void {owner.name}::Set{called}({value} New{name}) {{ {name} = New{name}; }}"]
        return lines, source

    def _delegate(self, owner: ClassType, header: Header) -> DelegateType | None:
        found = visible(self.random, self.types.modules, header.module, "delegates")
        return found if isinstance(found, DelegateType) and not found.owner and not found.sparse else None

    def _event(self, owner: ClassType, header: Header, indent: str, delegate: DelegateType) -> list[str]:
        r = self.random
        if delegate.header is not header:
            header.includes.add(delegate.header.include)
        name = fresh_name(r, owner.names, "On{q}{n}Changed" if delegate.multicast else "{q}{n}Callback", beside=owner.parameters)
        macro = f'UPROPERTY(BlueprintAssignable, Category = "{header.topic}")' if delegate.multicast else "UPROPERTY()"
        return [*written(property_comment(r, name), header.style, indent), indent + macro, f"{indent}{delegate.name} {name};"]
