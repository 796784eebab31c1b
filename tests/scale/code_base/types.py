# SPDX-License-Identifier: MIT
"""Choosing types, with the include or forward declaration that each needs, and values to start with."""

from __future__ import annotations

import random
from dataclasses import dataclass, field

from .model import ClassType, EnumType, Header, Module, StructType

#: Include of each engine type that headers use. What comes with CoreMinimal.h needs none.
ENGINE_INCLUDES = {
    "AActor": "GameFramework/Actor.h", "APawn": "GameFramework/Pawn.h", "AController": "GameFramework/Controller.h", "APlayerController": "GameFramework/PlayerController.h",
    "AInfo": "GameFramework/Info.h", "AGameModeBase": "GameFramework/GameModeBase.h", "UActorComponent": "Components/ActorComponent.h", "USceneComponent": "Components/SceneComponent.h",
    "UPrimitiveComponent": "Components/PrimitiveComponent.h", "UStaticMeshComponent": "Components/StaticMeshComponent.h", "UMovementComponent": "GameFramework/MovementComponent.h",
    "UObject": "UObject/Object.h", "UWorldSubsystem": "Subsystems/WorldSubsystem.h", "UGameInstanceSubsystem": "Subsystems/GameInstanceSubsystem.h",
    "UBlueprintFunctionLibrary": "Kismet/BlueprintFunctionLibrary.h", "UInterface": "UObject/Interface.h", "FHitResult": "Engine/HitResult.h", "FTimerHandle": "Engine/TimerHandle.h",
    "FLatentActionInfo": "Engine/LatentActionManager.h", "ECollisionChannel": "Engine/EngineTypes.h", "TSubclassOf": "Templates/SubclassOf.h", "TSoftObjectPtr": "UObject/SoftObjectPtr.h",
    "TLazyObjectPtr": "UObject/LazyObjectPtr.h", "TScriptInterface": "UObject/ScriptInterface.h", "TOptional": "Misc/Optional.h", "UUserWidget": "Blueprint/UserWidget.h",
    "UDataAsset": "Engine/DataAsset.h", "UPrimaryDataAsset": "Engine/DataAsset.h", "ACharacter": "GameFramework/Character.h", "UAnimInstance": "Animation/AnimInstance.h",
    "UCharacterMovementComponent": "GameFramework/CharacterMovementComponent.h", "FTableRowBase": "Engine/DataTable.h", "FGameplayTag": "GameplayTagContainer.h",
    "FGameplayTagContainer": "GameplayTagContainer.h", "UDeveloperSettings": "Engine/DeveloperSettings.h", "FDataTableRowHandle": "Engine/DataTable.h", "TWeakObjectPtr": "UObject/WeakObjectPtrTemplates.h",
}

#: Engine classes that members point to, forward declared.
ENGINE_OBJECTS = ["AActor", "APawn", "AController", "UObject", "USceneComponent", "UPrimitiveComponent", "UStaticMeshComponent", "UStaticMesh", "UTexture2D", "UMaterialInterface", "UActorComponent", "UWorld"]
UNKNOWN_OBJECTS = ["USoundBase", "UCurveFloat", "UNiagaraSystem", "UAnimMontage", "UDataTable", "USkeletalMesh", "UInputAction", "UWidgetComponent"]

NUMBERS = ["int32", "float", "double", "int64", "uint8"]
HIDDEN_NUMBERS = ["int8", "int16", "uint16", "uint32", "uint64"]
CORE_STRUCTS = ["FVector", "FRotator", "FTransform", "FLinearColor", "FVector2D", "FColor", "FQuat", "FIntPoint", "FGuid", "FIntVector", "FDateTime", "FTimespan", "FBox"]


@dataclass
class Use:
    """One type where it is used."""

    text: str  # as a member or plain value
    kind: str  # number, bool, string, name, text, enum, byte_enum, object, class, soft, weak, lazy, interface, struct, core_struct, array, set, map, optional, delegate
    of: object = None
    blueprint: bool = True
    defaults: list[str] = field(default_factory=list)  # initialisers of a member
    arguments: list[str] = field(default_factory=list)  # default arguments

    @property
    def large(self) -> bool:
        """Passed by const reference."""
        return self.kind in ("string", "text", "struct", "core_struct", "array", "set", "map", "delegate")


def visible(random_: random.Random, modules: list[Module], module: Module, kind: str) -> object | None:
    """A type of this module or of one it depends on; mostly its own."""
    own = getattr(module, kind)
    if own and (module.index == 0 or random_.random() < 0.75):
        return random_.choice(own[-60:] if random_.random() < 0.7 else own)
    others = [m for m in modules[: module.index] if getattr(m, kind)]
    if not others:
        return random_.choice(own) if own else None
    return random_.choice(getattr(random_.choice(others), kind))


class Types:
    """Makes uses of types for one header after the other."""

    def __init__(self, random_: random.Random, modules: list[Module], compilable: bool):
        self.random, self.modules, self.compilable = random_, modules, compilable

    # Needs --------------------------------------------------------------------------------------------------------------

    def include(self, header: Header, name: str) -> None:
        if name in ENGINE_INCLUDES:
            header.includes.add(ENGINE_INCLUDES[name])

    def need(self, header: Header, entity: EnumType | StructType | ClassType) -> None:
        if entity.header is not header:
            header.includes.add(entity.header.include)

    # Kinds --------------------------------------------------------------------------------------------------------------

    def number(self, blueprint: bool = True) -> Use:
        r = self.random
        text = r.choice(NUMBERS if blueprint or r.random() < 0.5 else HIDDEN_NUMBERS)
        if text in ("float", "double"):
            suffix = "f" if text == "float" else ""
            values = ["0.0" + suffix, "1.0" + suffix, "0.5" + suffix, "-1.0" + suffix, "100.0" + suffix, "1.e-3" + suffix, "2." + suffix, "90.0" + suffix]
        elif text in ("uint8", "uint16", "uint32", "uint64"):
            values = ["0", "1", "255", "0x7F", "16"]
        elif text == "int8":
            values = ["0", "-1", "100"]
        else:
            values = ["0", "1", "-1", "10", "1000", "INDEX_NONE"]
        return Use(text, "number", text, text not in HIDDEN_NUMBERS, values, values)

    def enum(self, header: Header) -> Use:
        found = visible(self.random, self.modules, header.module, "enums")
        if not isinstance(found, EnumType):
            return self.number()
        self.need(header, found)
        values = [found.entry(i) for i in range(min(3, len(found.entries)))]
        if found.form == "class":
            return Use(found.name, "enum", found, found.underlying == "uint8", values, values)
        return Use(f"TEnumAsByte<{found.cpp}>", "byte_enum", found, True, values, values)

    def object_name(self, header: Header) -> str:
        r = self.random
        found = visible(r, self.modules, header.module, "classes") if r.random() < 0.6 else None
        if isinstance(found, ClassType) and found.kind != "library":
            if found.header is not header:
                header.forwards.add(found.name)
            return found.name
        names = ENGINE_OBJECTS if self.compilable or r.random() < 0.8 else UNKNOWN_OBJECTS
        name = r.choice(names)
        if name != "UObject":
            header.forwards.add(name)
        return name

    def object(self, header: Header, member: bool = True) -> Use:
        name = self.object_name(header)
        text = f"TObjectPtr<{name}>" if member and header.style.object_pointers else f"{name}*"
        return Use(text, "object", name, True, ["nullptr"], ["nullptr"])

    def wrapped(self, header: Header, blueprint: bool) -> Use:
        template, kind = self.random.choice([("TSubclassOf", "class"), ("TSubclassOf", "class"), ("TSoftObjectPtr", "soft"), ("TSoftClassPtr", "soft"), ("TWeakObjectPtr", "weak")]
                                            + ([] if blueprint else [("TLazyObjectPtr", "lazy")]))
        self.include(header, "TSoftObjectPtr" if template == "TSoftClassPtr" else template)
        return Use(f"{template}<{self.object_name(header)}>", kind, None, template != "TLazyObjectPtr", ["nullptr"] if kind == "class" else [], ["nullptr"] if kind == "class" else [])

    def interface(self, header: Header) -> Use:
        found = visible(self.random, self.modules, header.module, "interfaces")
        if not isinstance(found, ClassType):
            return self.object(header)
        self.need(header, found)
        self.include(header, "TScriptInterface")
        return Use(f"TScriptInterface<I{found.name[1:]}>", "interface", found, True)

    def struct(self, header: Header, struct: StructType | None = None) -> Use:
        r = self.random
        if r.random() < 0.5:
            return self.core_struct()
        found = visible(r, self.modules, header.module, "structs")
        if not isinstance(found, StructType) or found is struct:
            return self.core_struct()
        self.need(header, found)
        return Use(found.name, "struct", found, True, [], [f"{found.name}()"])

    def core_struct(self) -> Use:
        name = self.random.choice(CORE_STRUCTS if self.random.random() < 0.5 else ["FVector", "FRotator", "FTransform", "FVector", "FLinearColor"])
        values = {"FVector": ["FVector::ZeroVector", "FVector(0.0, 0.0, 100.0)", "FVector::OneVector", "FVector(1.f, 2.f, -3.f)"], "FRotator": ["FRotator::ZeroRotator", "FRotator(0.0, 90.0, 0.0)"],
                  "FLinearColor": ["FLinearColor::White", "FLinearColor(1.f, 0.5f, 0.f, 1.f)"], "FVector2D": ["FVector2D::ZeroVector", "FVector2D(1.0, 0.0)"], "FColor": ["FColor::White", "FColor(255, 0, 128)"]}.get(name, [])
        return Use(name, "core_struct", name, True, values, values)

    def text(self) -> Use:
        kind = self.random.choice(["string", "name", "name", "text", "string"])
        if kind == "string":
            return Use("FString", kind, None, True, ['TEXT("")', 'TEXT("Default")', 'TEXT("a \\"quoted\\" name")'], ['TEXT("")', 'TEXT("Default")', 'TEXT("/Game/Maps/Start")'])
        if kind == "name":
            return Use("FName", kind, None, True, ["NAME_None", 'TEXT("Root")'], ["NAME_None"])
        return Use("FText", kind, None, True, [], ["FText::GetEmpty()"] if self.compilable else ["FText::GetEmpty()", "FText()"])

    def element(self, header: Header, blueprint: bool, struct: StructType | None = None) -> Use:
        """What a container holds."""
        r = self.random.random()
        if r < 0.2:
            return self.number()
        if r < 0.35:
            return self.text()
        if r < 0.65:
            return self.object(header)
        if r < 0.75:
            return self.wrapped(header, True)
        if r < 0.8:
            return self.enum(header)
        return self.struct(header, struct)

    def container(self, header: Header, blueprint: bool, struct: StructType | None = None) -> Use:
        r = self.random.random()
        if r < 0.62:
            return Use(f"TArray<{self.element(header, blueprint, struct).text}>", "array")
        if r < 0.72:
            return Use(f"TSet<{self.key(header).text}>", "set")
        if r < 0.94 or blueprint:
            return Use(f"TMap<{self.key(header).text}, {self.element(header, blueprint, struct).text}>", "map")
        self.include(header, "TOptional")
        return Use(f"TOptional<{self.random.choice([self.number(), self.core_struct(), self.text()]).text}>", "optional", None, False)

    def key(self, header: Header) -> Use:
        """What has a hash in the engine."""
        r = self.random.random()
        if r < 0.3:
            return Use("FName", "name")
        if r < 0.5:
            return Use("FString", "string")
        if r < 0.7:
            return Use("int32", "number")
        if r < 0.8:
            return Use("FGuid", "core_struct")
        enum = self.enum(header)
        return enum if enum.kind == "enum" else Use(f"{self.object_name(header)}*" if not header.style.object_pointers else f"TObjectPtr<{self.object_name(header)}>", "object")

    # Choices ------------------------------------------------------------------------------------------------------------

    def member(self, header: Header, blueprint: bool, struct: StructType | None = None) -> Use:
        """The type of a property."""
        r = self.random.random()
        if r < 0.33:
            return self.number(blueprint)
        if r < 0.46:
            return Use("bool", "bool", None, True, ["true", "false"], ["true", "false"])
        if r < 0.55:
            return self.text()
        if r < 0.63:
            return self.enum(header)
        if r < 0.73:
            return self.object(header)
        if r < 0.79:
            return self.wrapped(header, blueprint)
        if r < 0.8:
            return self.interface(header)
        if r < 0.9:
            return self.struct(header, struct)
        if not self.compilable and r < 0.91:
            name = self.random.choice(["FGameplayTag", "FGameplayTagContainer", "FDataTableRowHandle"])
            self.include(header, name)
            return Use(name, "struct")
        return self.container(header, blueprint, struct)

    def value(self, header: Header, blueprint: bool = True) -> Use:
        """The type of a parameter or return value."""
        r = self.random.random()
        if r < 0.3:
            return self.number(blueprint)
        if r < 0.42:
            return Use("bool", "bool", None, True, ["true", "false"], ["true", "false"])
        if r < 0.54:
            return self.text()
        if r < 0.6:
            return self.enum(header)
        if r < 0.76:
            return self.object(header, member=False)
        if r < 0.8:
            return self.wrapped(header, True)
        if r < 0.81:
            return self.interface(header)
        if r < 0.92:
            return self.struct(header)
        use = self.container(header, True)
        return use if "TObjectPtr" not in use.text else self.object_array(header)

    def object_array(self, header: Header) -> Use:
        """Objects in a parameter: raw pointers, as most code writes it."""
        return Use(f"TArray<{self.object_name(header)}*>", "array")
