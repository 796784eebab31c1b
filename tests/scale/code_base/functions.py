# SPDX-License-Identifier: MIT
"""UFUNCTIONs of every kind, with bodies that compile."""

from __future__ import annotations

import random
from dataclasses import dataclass, field

from .comments import function_comment, words_of, written
from .model import ClassType, DelegateType, Header
from .properties import fresh_name
from .types import Types, Use, visible
from .vocabulary import NOUNS, QUALIFIERS, RESERVED_FUNCTIONS, RESERVED_PARAMETERS, VERBS


@dataclass
class Draft:
    """A function being written."""

    name: str
    specifiers: list[str]
    returns: str = "void"
    parameters: list[tuple[str, str, str]] = field(default_factory=list)  # declaration before the name, name, default
    meta: list[str] = field(default_factory=list)
    const: bool = False
    static: bool = False
    virtual: bool = False
    body: str = "declared"  # declared | implementation | none | rpc
    validate: bool = False

    def parameter_list(self, defaults: bool) -> str:
        """What stands between the parentheses; without UPARAM for the definition."""
        return ", ".join(f"{before}{'' if before.endswith('&') or before.endswith('*') else ''} {name}" + (f" = {default}" if default and defaults else "")
                         for before, name, default in self.parameters)


class Functions:
    """Writes functions."""

    def __init__(self, random_: random.Random, types: Types, compilable: bool):
        self.random, self.types, self.compilable = random_, types, compilable
        self.members: set[str] = set()  # names that no parameter of the function being written may have

    def of_class(self, owner: ClassType, header: Header, indent: str, access: str) -> tuple[list[str], list[str]]:
        """One function: (lines, lines of the source file)."""
        r = self.random
        self.members = owner.names
        if owner.kind == "library":
            draft = self._library(owner, header)
        elif owner.kind == "interface":
            draft = self._interface(owner, header)
        elif access == "private":
            draft = r.choice([self._plain, self._handler])(owner, header)  # Blueprints cannot call or override what is private
        else:
            kinds = [(self._action, 30), (self._getter, 22), (self._setter, 12), (self._query, 10), (self._native_event, 7), (self._blueprint_event, 6), (self._handler, 5), (self._plain, 4), (self._editor, 2),
                     (self._latent, 1), (self._spawn, 1), (self._callback, 2)]
            if owner.kind in ("actor", "component"):
                kinds.append((self._rpc, 6))
            if owner.kind == "actor":
                kinds.append((self._exec, 1))
            draft = r.choices([k for k, _ in kinds], [w for _, w in kinds])[0](owner, header)
        owner.parameters |= {name.lower() for _, name, _ in draft.parameters}
        return self._write(owner, header, indent, draft)

    # Kinds --------------------------------------------------------------------------------------------------------------

    def _name(self, owner: ClassType, pattern: str, reserved: bool = False) -> str:
        r = self.random
        if reserved and r.random() < 0.01:
            word = r.choice(RESERVED_FUNCTIONS)
            if word.lower() not in owner.names:
                owner.names.add(word.lower())
                return word
        return fresh_name(r, owner.names, pattern.replace("{v}", r.choice(VERBS)))

    def _parameter(self, taken: set[str], pattern: str) -> str:
        """A parameter's name, which hides no member."""
        return fresh_name(self.random, taken, pattern, beside=self.members)

    def _category(self, header: Header) -> str:
        r = self.random
        return r.choice([f'Category = "{header.topic}"', f'Category="{header.topic}|{header.module.name}"', f"Category = {header.topic}"])

    def _parameters(self, header: Header, draft: Draft, count: int, defaults: bool = True, outputs: int = 0, remote: bool = False) -> None:
        r = self.random
        taken = {name.lower() for _, name, _ in draft.parameters}
        optional = False
        for _ in range(count):
            use = self.types.value(header)
            if remote and use.kind in ("map", "set", "interface", "text"):
                use = self.types.number()
            self._input(header, draft, use, taken, optional_chance=(1.0 if optional else 0.25) if defaults else 0.0)
            optional = optional or bool(draft.parameters[-1][2])
            if optional and not draft.parameters[-1][2]:
                before, name, _ = draft.parameters[-1]
                draft.parameters[-1] = ("int32", name, "0")
        for _ in range(outputs):
            use = self.types.value(header)
            name = self._parameter(taken, "Out{q}{n}")
            position = next((i for i, p in enumerate(draft.parameters) if p[2]), len(draft.parameters))
            draft.parameters.insert(position, (f"{use.text}&", name, ""))

    def _input(self, header: Header, draft: Draft, use: Use, taken: set[str], optional_chance: float) -> None:
        r = self.random
        name = self._parameter(taken, "b{q}{n}" if use.kind == "bool" else r.choice(["{n}", "{q}{n}", "In{n}", "New{n}"]))
        if use.kind != "bool" and r.random() < 0.012:
            word = r.choice(RESERVED_PARAMETERS)
            if word.lower() not in taken and word.lower() not in self.members:
                taken.add(word.lower())
                name = word
        default = r.choice(use.arguments) if use.arguments and r.random() < optional_chance else ""
        text = use.text
        if use.large and r.random() < 0.9:
            text = f"const {text}&"
        elif use.kind == "object" and r.random() < 0.15:
            text = "const " + text
        if r.random() < 0.02 and not default:
            text = f'UPARAM(DisplayName = "{words_of(name).title()}") {text}'
        draft.parameters.append((text, name, default))

    def _returns(self, header: Header, chance: float = 0.6) -> str:
        return self.types.value(header).text if self.random.random() < chance else "void"

    def _action(self, owner: ClassType, header: Header) -> Draft:
        r = self.random
        draft = Draft(self._name(owner, "{v}{n}" if r.random() < 0.3 else "{v}{q}{n}", reserved=True), ["BlueprintCallable", self._category(header)], self._returns(header, 0.35))
        self._parameters(header, draft, r.choice([0, 1, 1, 2, 2, 3, 4, 6]), outputs=r.choice([0, 0, 0, 0, 0, 1, 1, 2]))
        draft.virtual = r.random() < 0.2
        chance = r.random()
        if chance < 0.03:
            draft.meta += ["DeprecatedFunction", 'DeprecationMessage = "Use the newer one, please."']
        elif chance < 0.06:
            draft.meta.append(f'DisplayName = "{words_of(draft.name).title()}"')
        elif chance < 0.09:
            draft.meta += [f'Keywords = "{words_of(draft.name)}, more"']
        elif chance < 0.11:
            draft.specifiers.append(r.choice(["BlueprintAuthorityOnly", "BlueprintCosmetic"]))
        if r.random() < 0.03:
            taken = {n.lower() for _, n, _ in draft.parameters}
            draft.parameters.insert(0, (f"UPARAM(ref) {r.choice(['int32', 'FVector', 'TArray<FName>', 'FString'])}&", self._parameter(taken, "InOut{n}"), ""))
        by_reference = [n for t, n, d in draft.parameters if t.startswith("const ") and t.endswith("&") and not d]
        if by_reference and r.random() < 0.05:
            draft.meta.append(f'AutoCreateRefTerm = "{", ".join(by_reference)}"')
        return draft

    def _getter(self, owner: ClassType, header: Header) -> Draft:
        r = self.random
        draft = Draft(self._name(owner, r.choice(["Get{q}{n}", "Get{q}{n}", "Is{q}{n}", "Has{q}{n}", "Find{q}{n}"])), [r.choice(["BlueprintPure", "BlueprintCallable"]), self._category(header)], const=True)
        draft.returns = "bool" if draft.name.startswith(("Is", "Has")) else self.types.object(header, member=False).text if draft.name.startswith("Find") else self.types.value(header).text
        if r.random() < 0.25:
            self._parameters(header, draft, 1)
        return draft

    def _setter(self, owner: ClassType, header: Header) -> Draft:
        draft = Draft(self._name(owner, "Set{q}{n}"), ["BlueprintCallable", self._category(header)])
        taken: set[str] = set()
        self._input(header, draft, self.types.value(header), taken, 0.1)
        if self.random.random() < 0.2 and not draft.parameters[-1][2]:
            self._input(header, draft, Use("bool", "bool", None, True, [], ["true", "false"]), taken, 1.0)
        return draft

    def _query(self, owner: ClassType, header: Header) -> Draft:
        r = self.random
        draft = Draft(self._name(owner, r.choice(["Try{v}{n}", "Compute{q}{n}", "Trace{q}{n}"])), ["BlueprintCallable", self._category(header)], "bool", const=r.random() < 0.6)
        self._parameters(header, draft, r.choice([1, 2, 2, 3]), outputs=r.choice([1, 1, 2, 3]))
        if r.random() < 0.2:
            self.types.include(header, "FHitResult")
            taken = {n.lower() for _, n, _ in draft.parameters}
            position = next((i for i, p in enumerate(draft.parameters) if p[2]), len(draft.parameters))
            draft.parameters.insert(position, ("FHitResult&", self._parameter(taken, "Out{q}Hit"), ""))
        return draft

    def _native_event(self, owner: ClassType, header: Header) -> Draft:
        draft = Draft(self._name(owner, self.random.choice(["On{q}{n}", "Handle{q}{n}", "Can{v}{n}"])), ["BlueprintNativeEvent", *(["BlueprintCallable"] if self.random.random() < 0.5 else []), self._category(header)], body="implementation")
        draft.returns = "bool" if draft.name.startswith("Can") else "void"
        self._parameters(header, draft, self.random.choice([0, 1, 2, 2]), defaults=False)
        return draft

    def _blueprint_event(self, owner: ClassType, header: Header) -> Draft:
        draft = Draft(self._name(owner, "Receive{q}{n}"), ["BlueprintImplementableEvent", self._category(header)], self._returns(header, 0.15), body="none")
        self._parameters(header, draft, self.random.choice([0, 1, 2, 3]), defaults=False)
        if self.random.random() < 0.4:
            draft.meta.append(f'DisplayName = "On {words_of(draft.name[7:]).title()}"')
        return draft

    def _rpc(self, owner: ClassType, header: Header) -> Draft:
        r = self.random
        kind = r.choice(["Server", "Client", "NetMulticast"])
        draft = Draft(self._name(owner, {"Server": "Server{v}{n}", "Client": "Client{v}{n}", "NetMulticast": "Multicast{v}{n}"}[kind]), [kind, r.choice(["Reliable", "Unreliable"])], body="rpc")
        if kind == "Server" and r.random() < 0.5:
            draft.specifiers.append("WithValidation")
            draft.validate = True
        self._parameters(header, draft, r.choice([0, 1, 2]), defaults=False, remote=True)
        return draft

    def _exec(self, owner: ClassType, header: Header) -> Draft:
        draft = Draft(self._name(owner, "Cheat{v}{n}"), ["Exec"])
        draft.parameters = [(t, n, "") for t, n in (("int32", "Amount"), ("const FString&", "Filter"))[: self.random.randint(0, 2)]]
        return draft

    def _plain(self, owner: ClassType, header: Header) -> Draft:
        draft = Draft(self._name(owner, "{v}{n}Internal"), [], self._returns(header, 0.3), virtual=self.random.random() < 0.3)
        self._parameters(header, draft, self.random.choice([0, 1, 2]), defaults=False)
        return draft

    def _editor(self, owner: ClassType, header: Header) -> Draft:
        return Draft(self._name(owner, "{v}{n}InEditor"), ["CallInEditor", self._category(header)])

    def _handler(self, owner: ClassType, header: Header) -> Draft:
        draft = Draft(self._name(owner, "Handle{q}Overlap"), [])
        self.types.include(header, "FHitResult")
        header.forwards |= {"UPrimitiveComponent", "AActor"}
        draft.parameters = [("UPrimitiveComponent*", "OverlappedComponent", ""), ("AActor*", "OtherActor", ""), ("UPrimitiveComponent*", "OtherComp", ""), ("int32", "OtherBodyIndex", ""), ("bool", "bFromSweep", ""),
                            ("const FHitResult&", "SweepResult", "")]
        return draft

    def _latent(self, owner: ClassType, header: Header) -> Draft:
        self.types.include(header, "FLatentActionInfo")
        draft = Draft(self._name(owner, "{v}{n}Latent"), ["BlueprintCallable", self._category(header)], meta=["Latent", 'LatentInfo = "LatentInfo"'])
        self._parameters(header, draft, self.random.choice([0, 1]), defaults=False)
        draft.parameters.append(("FLatentActionInfo", "LatentInfo", ""))
        return draft

    def _spawn(self, owner: ClassType, header: Header) -> Draft:
        self.types.include(header, "TSubclassOf")
        header.forwards.add("AActor")
        return Draft(self._name(owner, "Create{q}Actor"), ["BlueprintCallable", self._category(header)], "AActor*", [("TSubclassOf<AActor>", "ActorClass", ""), ("const FTransform&", "SpawnTransform", "")],
                     ['DeterminesOutputType = "ActorClass"'])

    def _callback(self, owner: ClassType, header: Header) -> Draft:
        found = visible(self.random, self.types.modules, header.module, "delegates")
        if not isinstance(found, DelegateType) or found.multicast or found.owner:
            return self._action(owner, header)
        if found.header is not header:
            header.includes.add(found.header.include)
        draft = Draft(self._name(owner, "{v}{n}With"), ["BlueprintCallable", self._category(header)])
        self._parameters(header, draft, 1, defaults=False)
        taken = {n.lower() for _, n, _ in draft.parameters}
        draft.parameters.append((f"const {found.name}&" if self.random.random() < 0.5 else found.name, self._parameter(taken, "{q}Callback"), ""))
        return draft

    def _library(self, owner: ClassType, header: Header) -> Draft:
        r = self.random
        draft = Draft(self._name(owner, r.choice(["{v}{q}{n}", "Make{q}{n}", "Break{q}{n}", "Get{q}{n}", "Equal_{q}{n}", "{n}To{q}"])), [r.choice(["BlueprintPure", "BlueprintPure", "BlueprintCallable"]), self._category(header)],
                      self._returns(header, 0.85), static=True)
        chance = r.random()
        if chance < 0.2:
            draft.parameters.append(("const UObject*", "WorldContextObject", ""))
            draft.meta.append('WorldContext = "WorldContextObject"')
        elif chance < 0.23:
            self.types.include(header, "FLatentActionInfo")
            draft.parameters = [("UObject*", "WorldContextObject", ""), ("float", "Duration", ""), ("FLatentActionInfo", "LatentInfo", "")]
            draft.meta = ['WorldContext = "WorldContextObject"', "Latent", 'LatentInfo = "LatentInfo"', 'Duration = "0.2"']
            draft.returns, draft.specifiers[0] = "void", "BlueprintCallable"
            return draft
        elif chance < 0.26:
            draft.meta.append(f'CompactNodeTitle = "{r.choice(["==", "+", "->", "DOT"])}"')
        elif chance < 0.28:
            draft.specifiers.append("BlueprintInternalUseOnly") if r.random() < 0.3 else draft.meta.append(f'ScriptName = "{draft.name}Script"')
        elif chance < 0.3:
            draft.meta.append('BlueprintThreadSafe')
        self._parameters(header, draft, r.choice([1, 1, 2, 2, 3, 4]), outputs=r.choice([0, 0, 0, 1, 2]))
        return draft

    def _interface(self, owner: ClassType, header: Header) -> Draft:
        r = self.random
        native = r.random() < 0.75
        draft = Draft(self._name(owner, "{v}{q}{n}"), ["BlueprintNativeEvent" if native else "BlueprintImplementableEvent", "BlueprintCallable", self._category(header)], self._returns(header, 0.4),
                      body="implementation" if native else "none")
        self._parameters(header, draft, r.choice([0, 1, 2]), defaults=False)
        return draft

    # Text ---------------------------------------------------------------------------------------------------------------

    def _write(self, owner: ClassType, header: Header, indent: str, draft: Draft) -> tuple[list[str], list[str]]:
        r = self.random
        specifiers = list(draft.specifiers)
        if draft.meta:
            specifiers.append(f"meta = ({', '.join(draft.meta)})" if r.random() < 0.6 else f"meta=({','.join(draft.meta)})")
        parameters = [name for _, name, _ in draft.parameters]
        lines = written(function_comment(r, draft.name, parameters, draft.returns != "void"), header.style, indent)
        macro = f"UFUNCTION({', '.join(specifiers)})"
        before = ("static " if draft.static else "") + ("virtual " if draft.virtual and draft.body == "declared" else "")
        const = " const" if draft.const else ""
        declared = f"{before}{draft.returns} {draft.name}({draft.parameter_list(defaults=True)}){const};"
        if len(declared) > 130 and r.random() < 0.7:
            declared = declared.replace(", ", f",\n{indent}{header.style.indent}", 1)
        lines += [indent + macro, indent + declared]
        source: list[str] = []
        definition = draft.parameter_list(defaults=False)
        for text in {before for before, _, _ in draft.parameters if before.startswith("UPARAM")}:
            definition = definition.replace(text, text[text.index(") ") + 2 :])
        body = "{}" if draft.returns == "void" else "{ return {}; }"
        name = owner.name if owner.kind != "interface" else "I" + owner.name[1:]
        if draft.body == "declared":
            source.append(f"{draft.returns} {name}::{draft.name}({definition}){const} {body}")
        elif draft.body in ("implementation", "rpc"):
            if owner.kind != "interface":
                lines.append(f"{indent}{'virtual ' if draft.body == 'implementation' else ''}{draft.returns} {draft.name}_Implementation({definition}){const};")
                source.append(f"{draft.returns} {name}::{draft.name}_Implementation({definition}){const} {body}")
            if draft.validate:
                lines.append(f"{indent}bool {draft.name}_Validate({definition});")
                source.append(f"bool {name}::{draft.name}_Validate({definition}) {{ return true; }}")
        if "CallInEditor" in draft.specifiers and r.random() < 0.5:
            return ["#if WITH_EDITOR", *lines, "#endif"], ["#if WITH_EDITOR", *source, "#endif"]
        return lines, source
