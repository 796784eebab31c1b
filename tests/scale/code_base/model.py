# SPDX-License-Identifier: MIT
"""What the generator knows about the code base while it writes it."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass
class Style:
    """How one team formats its headers."""

    indent: str = "\t"
    brace_below: bool = True
    one_line_properties: bool = False
    object_pointers: bool = True  # TObjectPtr<T> for members
    old_bodies: bool = False  # GENERATED_UCLASS_BODY()
    comment: str = "block"  # block | line | star_less
    crlf: bool = False
    bom: bool = False


@dataclass
class EnumType:
    name: str
    form: str  # class | regular | namespaced
    underlying: str  # "" for none
    entries: list[str]
    header: Header
    flags: bool = False

    @property
    def cpp(self) -> str:
        return self.name + "::Type" if self.form == "namespaced" else self.name

    def entry(self, i: int) -> str:
        """C++ spelling of the i-th entry."""
        name = self.entries[i % len(self.entries)]
        return name if self.form == "regular" else f"{self.name}::{name}"


@dataclass
class StructType:
    name: str
    header: Header
    parent: StructType | None = None
    fields: set[str] = field(default_factory=set)  # lower case, inherited ones too


@dataclass
class ClassType:
    name: str
    header: Header
    kind: str  # actor | component | object | library | interface
    parent: ClassType | None
    base: str  # C++ name of the super class, also where it is none of ours
    names: set[str] = field(default_factory=set)  # lower case names of members, inherited ones too
    parameters: set[str] = field(default_factory=set)  # lower case names of parameters of its own functions; no member may have one of them
    members: int = 0  # with those inherited inside the code base
    depth: int = 1
    old_body: bool = False
    interfaces: list[str] = field(default_factory=list)
    #: which constructors a class derived from it may call
    constructors: set[str] = field(default_factory=lambda: {"default", "initializer"})

    @property
    def super_constructors(self) -> set[str]:
        """The same of its super class. Subsystems have no constructor with an FObjectInitializer."""
        if self.parent:
            return self.parent.constructors
        return {"default"} if self.base.endswith("Subsystem") else {"default", "initializer"}


@dataclass
class DelegateType:
    name: str
    header: Header
    multicast: bool
    owner: str = ""
    sparse: bool = False


@dataclass
class Module:
    name: str
    topics: list[str]
    index: int
    headers: list[Header] = field(default_factory=list)
    classes: list[ClassType] = field(default_factory=list)
    structs: list[StructType] = field(default_factory=list)
    enums: list[EnumType] = field(default_factory=list)
    delegates: list[DelegateType] = field(default_factory=list)
    interfaces: list[ClassType] = field(default_factory=list)

    @property
    def api(self) -> str:
        return self.name.upper() + "_API"


@dataclass
class Header:
    module: Module
    folder: str  # Public/Water, Classes, Private ...
    stem: str
    kind: str
    topic: str
    functions: int
    properties: int
    style: Style
    includes: set[str] = field(default_factory=set)
    forwards: set[str] = field(default_factory=set)
    declared: set[str] = field(default_factory=set)  # types declared in it
    source: list[str] = field(default_factory=list)  # lines of the .cpp
    serial: int = 0

    @property
    def include(self) -> str:
        first, _, rest = self.folder.partition("/")
        path = rest if first in ("Public", "Classes", "Private") else self.folder
        return f"{path}/{self.stem}.h" if path else f"{self.stem}.h"

    @property
    def path(self) -> str:
        return f"{self.folder}/{self.stem}.h" if self.folder else f"{self.stem}.h"
