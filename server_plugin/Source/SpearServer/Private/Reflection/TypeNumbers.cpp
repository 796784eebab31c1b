// SPDX-License-Identifier: MIT
#include "Reflection/TypeNumbers.h"

#include "SpearText.h"

namespace SpearServer {

std::string ShortNameOfEntry(const UEnum* Enum, int32 Index) {
    const std::string Full = ToUtf8(Enum->GetNameByIndex(Index));
    const std::size_t Scope = Full.rfind("::");
    return Scope == std::string::npos ? Full : Full.substr(Scope + 2);
}

spear::TypeId FTypeNumbers::NumberOf(const FTypePlan& Plan) {
    if (Plan.Builtin != spear::types::null) {
        return Plan.Builtin;
    }
    if (Plan.Index < Numbers.size() && Numbers[Plan.Index] != 0) {
        return Numbers[Plan.Index];
    }
    spear::TypeInfo Info;
    switch (Plan.Kind) {
    case EValueKind::Enum:
        Info.kind = spear::TypeKind::enumeration;
        Info.name = ToUtf8(Plan.Enum->GetName());
        Info.path = ToUtf8(Plan.Enum->GetPathName());
        Info.key = Plan.Enum->HasAnyEnumFlags(EEnumFlags::Flags) ? spear::types::u64 : spear::types::null;
        for (int32 Index = 0; Index < Plan.Enum->NumEnums(); ++Index) {
            Info.entries.push_back({ShortNameOfEntry(Plan.Enum, Index), Plan.Enum->GetValueByIndex(Index)});
        }
        break;
    case EValueKind::Struct:
        Info.kind = spear::TypeKind::structure;
        Info.name = CppNameOf(Plan.Struct);
        Info.path = ToUtf8(Plan.Struct->GetPathName());
        for (const FTypePlan::FField& Field : Plan.Fields) {
            Info.fields.push_back({Field.Name, NumberOf(*Field.Plan)});
        }
        break;
    case EValueKind::StaticArray:
    case EValueKind::Array:
        Info.kind = spear::TypeKind::array;
        Info.element = NumberOf(*Plan.Inner);
        break;
    case EValueKind::Set:
        Info.kind = spear::TypeKind::set;
        Info.element = NumberOf(*Plan.Inner);
        break;
    case EValueKind::Map:
        Info.kind = spear::TypeKind::map;
        Info.key = NumberOf(*Plan.Key);
        Info.element = NumberOf(*Plan.Inner);
        break;
    case EValueKind::Delegate:
        return DelegateNumber();
    case EValueKind::MulticastDelegate:
        Info.kind = spear::TypeKind::array;
        Info.element = DelegateNumber();
        break;
    default:
        return spear::types::any; // every other kind is built in
    }
    const spear::TypeId Number = Announcer.number_of(Info);
    if (Plan.Index >= Numbers.size()) {
        Numbers.resize(Plan.Index + 1, 0);
    }
    Numbers[Plan.Index] = Number;
    return Number;
}

spear::TypeId FTypeNumbers::NumberOf(const UClass* Class) {
    if (!Class) {
        return spear::types::null;
    }
    const auto At = ClassNumbers.find(Class);
    if (At != ClassNumbers.end() && At->second.Class.Get(true) == Class) {
        return At->second.Number;
    }
    spear::TypeInfo Info;
    Info.kind = spear::TypeKind::object_class;
    Info.name = CppNameOf(Class);
    Info.path = ToUtf8(Class->GetPathName());
    Info.element = NumberOf(Class->GetSuperClass());
    const spear::TypeId Number = Announcer.number_of(Info);
    ClassNumbers[Class] = {FWeakObjectPtr(Class), Number};
    return Number;
}

spear::TypeId FTypeNumbers::DelegateNumber() {
    if (Delegate == 0) {
        spear::TypeInfo Info;
        Info.kind = spear::TypeKind::structure;
        Info.name = "FScriptDelegate";
        Info.fields = {{"Object", spear::types::object}, {"FunctionName", spear::types::string}};
        Delegate = Announcer.number_of(Info);
    }
    return Delegate;
}

void FTypeNumbers::Sweep() {
    for (auto At = ClassNumbers.begin(); At != ClassNumbers.end();) {
        At = At->second.Class.Get(true) ? std::next(At) : ClassNumbers.erase(At);
    }
}

} // namespace SpearServer
