// SPDX-License-Identifier: MIT
#include "Reflection/TypePlan.h"

#include "SpearText.h"

#include "UObject/EnumProperty.h"
#include "UObject/Interface.h"
#include "UObject/PropertyOptional.h"
#include "UObject/TextProperty.h"
#include "UObject/WeakObjectPtr.h"

#include "spear/limits.hpp"

#include <algorithm>
#include <unordered_map>

namespace SpearServer {

namespace {

/// A plan with what it must not outlive: the struct, or the owner of the property.
struct FCachedPlan {
    FWeakObjectPtr Owner;
    FTypePlanRef Plan;
};

template <typename T>
using TPlanCache = std::unordered_map<const T*, FCachedPlan>;

TPlanCache<UScriptStruct>& GetStructPlans() {
    static TPlanCache<UScriptStruct> Plans;
    return Plans;
}

TPlanCache<FProperty>& GetPropertyPlans() {
    static TPlanCache<FProperty> Plans;
    return Plans;
}

template <typename T>
void SweepPlans(TPlanCache<T>& Plans) {
    for (auto At = Plans.begin(); At != Plans.end();) {
        At = At->second.Owner.Get(true) ? std::next(At) : Plans.erase(At);
    }
}

FTypePlanRef MakeTypePlan(const FProperty* Property);

/// Structs whose plan is being made: one that contains itself is met here.
std::vector<const UScriptStruct*>& GetStructsInProgress() {
    static std::vector<const UScriptStruct*> Structs;
    return Structs;
}

std::shared_ptr<FTypePlan> NewPlan(EValueKind Kind, const FProperty* Property) {
    static uint32 LastIndex = 0;
    auto Plan = std::make_shared<FTypePlan>();
    Plan->Kind = Kind;
    Plan->Index = ++LastIndex;
    Plan->Property = Property;
    Plan->Size = Property ? Property->GetElementSize() : 0;
    return Plan;
}

void SetBuiltin(FTypePlan& Plan, spear::TypeId Builtin) {
    Plan.Builtin = Builtin;
    Plan.SmallestPayload = std::max(static_cast<int32>(spear::fixed_size(Builtin)), 4);
    if (const std::size_t Size = spear::fixed_size(Builtin)) {
        Plan.SmallestPayload = static_cast<int32>(Size);
    }
}

spear::TypeId NumberTypeOf(const FProperty* Property) {
    namespace types = spear::types;
    if (Property->IsA<FInt8Property>())
        return types::i8;
    if (Property->IsA<FInt16Property>())
        return types::i16;
    if (Property->IsA<FIntProperty>())
        return types::i32;
    if (Property->IsA<FInt64Property>())
        return types::i64;
    if (Property->IsA<FByteProperty>())
        return types::u8;
    if (Property->IsA<FUInt16Property>())
        return types::u16;
    if (Property->IsA<FUInt32Property>())
        return types::u32;
    if (Property->IsA<FUInt64Property>())
        return types::u64;
    if (Property->IsA<FFloatProperty>())
        return types::f32;
    if (Property->IsA<FDoubleProperty>())
        return types::f64;
    return types::null;
}

void AddRun(std::vector<FTypePlan::FRun>& Runs, int32 Offset, int32 Size) {
    if (!Runs.empty() && Runs.back().Offset + Runs.back().Size == Offset) {
        Runs.back().Size += Size;
    } else {
        Runs.push_back({Offset, Size});
    }
}

/// Works out whether the values can be copied raw, once the parts are known.
void FindRuns(FTypePlan& Plan) {
    switch (Plan.Kind) {
    case EValueKind::Number:
        Plan.bRaw = true;
        Plan.Runs = {{0, Plan.Size}};
        break;
    case EValueKind::Struct:
        Plan.bRaw = !Plan.Fields.empty();
        for (const FTypePlan::FField& Field : Plan.Fields) {
            // A C array of numbers has its count on the wire, so it is not raw.
            Plan.bRaw = Plan.bRaw && Field.Plan->bRaw;
        }
        if (Plan.bRaw) {
            for (const FTypePlan::FField& Field : Plan.Fields) {
                for (const FTypePlan::FRun& Run : Field.Plan->Runs) {
                    AddRun(Plan.Runs, Field.Offset + Run.Offset, Run.Size);
                }
            }
        }
        break;
    default:
        break;
    }
    for (const FTypePlan::FRun& Run : Plan.Runs) {
        Plan.RawBytes += Run.Size;
    }
}

FTypePlanRef MakeIndirect(UScriptStruct* Struct) {
    auto Plan = NewPlan(EValueKind::Indirect, nullptr);
    Plan->Struct = Struct;
    Plan->Size = Struct->GetStructureSize();
    SetBuiltin(*Plan, spear::types::any);
    return Plan;
}

/// The plan of a struct where it stands inside of something: in itself, or too heavy, it travels as `any`.
FTypePlanRef MakeInnerStruct(UScriptStruct* Struct) {
    const std::vector<const UScriptStruct*>& InProgress = GetStructsInProgress();
    if (std::find(InProgress.begin(), InProgress.end(), Struct) != InProgress.end()) {
        return MakeIndirect(Struct);
    }
    FTypePlanRef Plan = GetStructPlan(Struct);
    return Plan->Weight > spear::limits::max_type_weight / 8 || Plan->SmallestPayload == 0 ? MakeIndirect(Struct)
                                                                                           : Plan;
}

/// One element of the property, without regard to its C array dimension.
FTypePlanRef MakeElementPlan(const FProperty* Property) {
    namespace types = spear::types;
    const auto Make = [&](EValueKind Kind, spear::TypeId Builtin) {
        auto Plan = NewPlan(Kind, Property);
        SetBuiltin(*Plan, Builtin);
        return Plan;
    };
    if (Property->IsA<FBoolProperty>())
        return Make(EValueKind::Bool, types::boolean);
    if (const FEnumProperty* EnumProperty = CastField<FEnumProperty>(Property)) {
        auto Plan = Make(EValueKind::Enum, types::null);
        Plan->Enum = EnumProperty->GetEnum();
        Plan->SmallestPayload = 8;
        return Plan;
    }
    if (const FByteProperty* ByteProperty = CastField<FByteProperty>(Property); ByteProperty && ByteProperty->Enum) {
        auto Plan = Make(EValueKind::Enum, types::null);
        Plan->Enum = ByteProperty->Enum;
        Plan->SmallestPayload = 8;
        return Plan;
    }
    if (const spear::TypeId Number = NumberTypeOf(Property); Number != types::null) {
        auto Plan = Make(EValueKind::Number, Number);
        FindRuns(*Plan);
        return Plan;
    }
    if (Property->IsA<FStrProperty>())
        return Make(EValueKind::String, types::string);
    if (Property->IsA<FNameProperty>())
        return Make(EValueKind::Name, types::string);
    if (Property->IsA<FTextProperty>())
        return Make(EValueKind::Text, types::string);
    if (Property->IsA<FSoftObjectProperty>())
        return Make(EValueKind::SoftObject, types::string);
    if (Property->IsA<FObjectPropertyBase>())
        return Make(EValueKind::Object, types::object);
    if (Property->IsA<FInterfaceProperty>())
        return Make(EValueKind::Interface, types::object);
    if (const FStructProperty* StructProperty = CastField<FStructProperty>(Property))
        return MakeInnerStruct(StructProperty->Struct);
    if (const FArrayProperty* ArrayProperty = CastField<FArrayProperty>(Property)) {
        auto Plan = NewPlan(EValueKind::Array, Property);
        Plan->Inner = MakeTypePlan(ArrayProperty->Inner);
        Plan->SmallestPayload = 4;
        return Plan;
    }
    if (const FSetProperty* SetProperty = CastField<FSetProperty>(Property)) {
        auto Plan = NewPlan(EValueKind::Set, Property);
        Plan->Inner = MakeTypePlan(SetProperty->ElementProp);
        Plan->SmallestPayload = 4;
        return Plan;
    }
    if (const FMapProperty* MapProperty = CastField<FMapProperty>(Property)) {
        auto Plan = NewPlan(EValueKind::Map, Property);
        Plan->Key = MakeTypePlan(MapProperty->KeyProp);
        Plan->Inner = MakeTypePlan(MapProperty->ValueProp);
        Plan->SmallestPayload = 4;
        return Plan;
    }
    if (const FOptionalProperty* OptionalProperty = CastField<FOptionalProperty>(Property)) {
        auto Plan = Make(EValueKind::Optional, types::any);
        Plan->Inner = MakeTypePlan(OptionalProperty->GetValueProperty());
        return Plan;
    }
    if (Property->IsA<FDelegateProperty>()) {
        auto Plan = Make(EValueKind::Delegate, types::null);
        Plan->SmallestPayload = 16;
        Plan->Weight = 3;
        return Plan;
    }
    if (Property->IsA<FMulticastDelegateProperty>()) {
        auto Plan = Make(EValueKind::MulticastDelegate, types::null);
        Plan->SmallestPayload = 4;
        return Plan;
    }
    return Make(EValueKind::Exported, types::string);
}

FTypePlanRef MakeStructPlan(UScriptStruct* Struct) {
    auto Plan = NewPlan(EValueKind::Struct, nullptr);
    Plan->Struct = Struct;
    Plan->Size = Struct->GetStructureSize();
    Plan->SmallestPayload = 0;

    std::vector<const UStruct*> Chain;
    for (const UStruct* At = Struct; At; At = At->GetSuperStruct()) {
        Chain.push_back(At);
    }
    std::reverse(Chain.begin(), Chain.end());
    GetStructsInProgress().push_back(Struct);
    for (const UStruct* Part : Chain) {
        for (TFieldIterator<FProperty> It(Part, EFieldIterationFlags::IncludeDeprecated); It; ++It) {
            const FProperty* Property = *It;
            FTypePlanRef FieldPlan = MakeTypePlan(Property);
            Plan->Weight += FieldPlan->Weight;
            Plan->SmallestPayload += FieldPlan->SmallestPayload;
            Plan->Fields.push_back(
                {ToUtf8(Property->GetName()), Property->GetOffset_ForInternal(), std::move(FieldPlan)});
        }
    }
    GetStructsInProgress().pop_back();
    FindRuns(*Plan);
    return Plan;
}

FTypePlanRef MakeTypePlan(const FProperty* Property) {
    FTypePlanRef Element = MakeElementPlan(Property);
    if (Property->ArrayDim <= 1) {
        return Element;
    }
    auto Plan = NewPlan(EValueKind::StaticArray, Property);
    Plan->ArrayDim = Property->ArrayDim;
    Plan->Size = Property->GetElementSize() * Property->ArrayDim;
    Plan->Inner = std::move(Element);
    Plan->SmallestPayload = 4;
    return Plan;
}

} // namespace

FTypePlanRef GetTypePlan(const FProperty* Property) {
    UObject* Owner = Property->GetOwnerUObject();
    const auto At = GetPropertyPlans().find(Property);
    if (At != GetPropertyPlans().end() && At->second.Owner.Get(true) == Owner) {
        return At->second.Plan;
    }
    FTypePlanRef Plan = MakeTypePlan(Property);
    GetPropertyPlans()[Property] = {FWeakObjectPtr(Owner), Plan};
    return Plan;
}

FTypePlanRef GetStructPlan(UScriptStruct* Struct) {
    const auto At = GetStructPlans().find(Struct);
    if (At != GetStructPlans().end() && At->second.Owner.Get(true) == Struct) {
        return At->second.Plan;
    }
    FTypePlanRef Plan = MakeStructPlan(Struct);
    GetStructPlans()[Struct] = {FWeakObjectPtr(Struct), Plan};
    return Plan;
}

void SweepTypePlans() {
    SweepPlans(GetStructPlans());
    SweepPlans(GetPropertyPlans());
}

std::string CppNameOf(const UClass* Class) {
    if (Class->HasAnyClassFlags(CLASS_Interface) && Class != UInterface::StaticClass()) {
        return "I" + ToUtf8(Class->GetName());
    }
    return ToUtf8(FString(Class->GetPrefixCPP()) + Class->GetName());
}

std::string CppNameOf(const UScriptStruct* Struct) {
    return ToUtf8(FString(Struct->GetPrefixCPP()) + Struct->GetName());
}

std::string CppTypeOf(const FProperty* Property) {
    FString Extended;
    FString Text = Property->GetCPPType(&Extended, CPPF_None);
    return ToUtf8(Text + Extended);
}

} // namespace SpearServer
