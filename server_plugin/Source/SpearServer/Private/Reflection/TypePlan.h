// SPDX-License-Identifier: MIT
#pragma once

// How a property's values look in memory and on the wire, worked out once: a tree of plans, one node per (nested)
// property. Plans know no session; the numbers under which a session announces types are FTypeNumbers'.

#include "CoreMinimal.h"
#include "UObject/Class.h"
#include "UObject/UnrealType.h"

#include "spear/encode.hpp"

#include <memory>
#include <string>
#include <vector>

namespace SpearServer {

enum class EValueKind : uint8 {
    Number, ///< integers and floating-point numbers: copied raw
    Bool,
    Enum,
    String,
    Name,
    Text,
    Object,     ///< object, class, weak and lazy references
    SoftObject, ///< soft objects and classes: their path as a string
    Interface,
    Struct,
    StaticArray, ///< C arrays
    Array,
    Set,
    Map,
    Optional,          ///< `any`: null or the value
    Delegate,          ///< struct FScriptDelegate {Object, FunctionName}
    MulticastDelegate, ///< array of FScriptDelegate
    Indirect,          ///< `any`: a struct within itself (through a container), or too large to be announced as one
    Exported,          ///< everything else, as Unreal's own text form
};

struct FTypePlan;
using FTypePlanRef = std::shared_ptr<const FTypePlan>;

struct FTypePlan {
    struct FField {
        std::string Name;
        int32 Offset = 0; ///< within the struct
        FTypePlanRef Plan;
    };
    /// Bytes that lie together in memory and on the wire.
    struct FRun {
        int32 Offset = 0;
        int32 Size = 0;
    };

    EValueKind Kind = EValueKind::Exported;
    uint32 Index = 0;                           ///< of this plan among all plans of the process
    spear::TypeId Builtin = spear::types::null; ///< the type number, if it needs no announcement; else null
    const FProperty* Property = nullptr;        ///< null for plans of a struct as such
    int32 Size = 0;                             ///< bytes of one value in memory
    int32 ArrayDim = 1;                         ///< StaticArray
    UScriptStruct* Struct = nullptr;            ///< Struct, Indirect
    UEnum* Enum = nullptr;                      ///< Enum
    std::vector<FField> Fields;                 ///< Struct: the base struct's first
    FTypePlanRef Inner;                         ///< StaticArray, Array, Set, Optional; Map: value
    FTypePlanRef Key;                           ///< Map
    bool bRaw = false;                          ///< numbers only: encoded by copying the runs
    std::vector<FRun> Runs;
    int32 RawBytes = 0;
    uint32 Weight = 1;         ///< values inside (limits::max_type_weight)
    int32 SmallestPayload = 1; ///< 0 only for empty structs

    /// The values of an array of these are one block, in memory as on the wire.
    bool IsOneRun() const { return bRaw && Runs.size() == 1 && Runs[0].Offset == 0 && Runs[0].Size == Size; }
};

/// The plan of a property (all of it: C arrays included). Made once.
FTypePlanRef GetTypePlan(const FProperty* Property);
/// The plan of a struct. Made once.
FTypePlanRef GetStructPlan(UScriptStruct* Struct);
/// Drops the plans of structs, and of properties of classes and functions, that were collected.
void SweepTypePlans();

/// "FVector", "TArray<FString>", "EFoo", "AActor*": for messages, and as the schema spells it.
std::string CppTypeOf(const FProperty* Property);
/// "AActor", "UObject", "IFoo" for interfaces.
std::string CppNameOf(const UClass* Class);
/// "FVector".
std::string CppNameOf(const UScriptStruct* Struct);

} // namespace SpearServer
