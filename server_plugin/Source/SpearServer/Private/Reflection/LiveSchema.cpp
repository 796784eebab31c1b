// SPDX-License-Identifier: MIT
#include "Reflection/LiveSchema.h"

#include "SpearCompat.h"
#include "SpearText.h"

#include "Reflection/NearestNames.h"
#include "Reflection/SchemaTypes.h"
#include "Reflection/SchemaValue.h"
#include "Reflection/TypePlan.h"

#include "UObject/EnumProperty.h"
#include "UObject/Package.h"
#include "UObject/UObjectIterator.h"

#include <algorithm>
#include <set>

namespace SpearServer {

namespace {

// Metadata
// ------------------------------------------------------------------------------------------------------------------

#if WITH_METADATA

using FMetaPairs = std::map<std::string, std::string>;

FMetaPairs PairsOf(const TMap<FName, FString>* Map) {
    FMetaPairs Pairs;
    if (Map) {
        for (const TPair<FName, FString>& Pair : *Map) {
            Pairs[ToUtf8(Pair.Key)] = ToUtf8(Pair.Value);
        }
    }
    return Pairs;
}

void SetEditor(FSchemaDict& Entity, const FMetaPairs& Pairs, const std::string* Default = nullptr) {
    FSchemaDict Meta;
    for (const auto& [Key, Value] : Pairs) {
        Meta.SetText(Key.c_str(), Value);
    }
    FSchemaDict Editor;
    Editor.SetDict("meta", Meta);
    if (Default) {
        Editor.SetText("default", *Default);
    }
    Entity.SetDict("editor", Editor);
}

#endif

template <typename T>
void SetEditorOf(FSchemaDict& Entity, const T* Type) {
#if WITH_METADATA
    SetEditor(Entity, PairsOf(MetaDataOf(Type)));
#endif
}

void SetEditorOfProperty(FSchemaDict& Entity, const FProperty* Property, const UFunction* Function = nullptr) {
#if WITH_METADATA
    const FString Key = FString(TEXT("CPP_Default_")) + Property->GetName();
    const bool bDefault = Function && !Property->HasAnyPropertyFlags(CPF_ReturnParm) && Function->HasMetaData(*Key);
    const std::string Default = bDefault ? ToUtf8(Function->GetMetaData(*Key)) : std::string();
    SetEditor(Entity, PairsOf(Property->GetMetaDataMap()), bDefault ? &Default : nullptr);
#endif
}

// Members
// -------------------------------------------------------------------------------------------------------------------

FSchemaList PropertiesOf(const UStruct* Struct) {
    FSchemaList List;
    for (TFieldIterator<FProperty> It(Struct, EFieldIterationFlags::IncludeDeprecated); It; ++It) {
        const FProperty* Property = *It;
        FSchemaDict Entity;
        Entity.SetText("name", Property->GetName());
        Entity.SetDict("type", TypeNodeOf(Property));
        Entity.SetList("flags", FlagsOf(Property));
        Entity.SetNumber("array_dim", Property->ArrayDim);
        if (Property->HasAnyPropertyFlags(CPF_RepNotify)) {
            Entity.SetText("rep_notify", ToUtf8(Property->RepNotifyFunc));
        }
        if (Property->HasGetter()) {
            Entity.SetTrue("native_getter");
        }
        if (Property->HasSetter()) {
            Entity.SetTrue("native_setter");
        }
        SetEditorOfProperty(Entity, Property);
        Entity.WriteTo(List.Add());
    }
    return List;
}

/// Parameters and return value of a function or delegate.
void SetSignature(FSchemaDict& Entity, const UFunction* Function) {
    FSchemaList Parameters;
    Entity.SetNull("returns");
    for (TFieldIterator<FProperty> It(Function, EFieldIterationFlags::IncludeDeprecated);
        It && It->HasAnyPropertyFlags(CPF_Parm); ++It) {
        const FProperty* Property = *It;
        FSchemaDict One;
        One.SetDict("type", TypeNodeOf(Property));
        One.SetList("flags", FlagsOf(Property));
        SetEditorOfProperty(One, Property, Function);
        if (Property->HasAnyPropertyFlags(CPF_ReturnParm)) {
            Entity.Set("returns").buffer.clear();
            Entity.SetDict("returns", One);
        } else {
            One.SetText("name", Property->GetName());
            One.SetNumber("array_dim", Property->ArrayDim);
            One.WriteTo(Parameters.Add());
        }
    }
    Entity.SetList("parameters", Parameters);
}

// Entities
// ------------------------------------------------------------------------------------------------------------------

FSchemaDict ClassEntity(const UClass* Class) {
    FSchemaDict Entity;
    Entity.SetText("name", SchemaNameOf(Class));
    Entity.SetText("reflected_name", Class->GetName());
    Entity.SetText("path", Class->GetPathName());
    Entity.SetText("module", ModuleOf(Class));
    if (const UClass* Super = Class->GetSuperClass()) {
        Entity.SetText("super", SchemaNameOf(Super));
    } else {
        Entity.SetNull("super");
    }
    FSchemaList Interfaces;
    for (const FImplementedInterface& Interface : Class->Interfaces) {
        if (Interface.Class &&
            !(Class->GetSuperClass() && Class->GetSuperClass()->ImplementsInterface(Interface.Class))) {
            Interfaces.AddText(CppNameOf(Interface.Class));
        }
    }
    Entity.SetList("interfaces", Interfaces);
    Entity.SetList("flags", FlagsOf(Class));
    Entity.SetText("within", Class->ClassWithin ? SchemaNameOf(Class->ClassWithin) : std::string("UObject"));
    Entity.SetText("config", Class->ClassConfigName.IsNone() ? std::string() : ToUtf8(Class->ClassConfigName));

    FSchemaEntities Functions;
    for (TFieldIterator<UFunction> It(Class, EFieldIterationFlags::IncludeDeprecated); It; ++It) {
        const UFunction* Function = *It;
        if (Function->HasAnyFunctionFlags(FUNC_Delegate)) {
            continue;
        }
        FSchemaDict One;
        One.SetText("name", Function->GetName());
        One.SetList("flags", FlagsOf(Function));
        SetSignature(One, Function);
        SetEditorOf(One, Function);
        One.WriteTo(Functions.Add(ToUtf8(Function->GetName())));
    }
    Functions.WriteTo(Entity.Set("functions"));
    Entity.SetList("properties", PropertiesOf(Class));
    SetEditorOf(Entity, Class);
    return Entity;
}

FSchemaDict StructEntity(const UScriptStruct* Struct) {
    FSchemaDict Entity;
    Entity.SetText("name", CppNameOf(Struct));
    Entity.SetText("reflected_name", Struct->GetName());
    Entity.SetText("path", Struct->GetPathName());
    Entity.SetText("module", ModuleOf(Struct));
    if (const UScriptStruct* Super = Cast<UScriptStruct>(Struct->GetSuperStruct())) {
        Entity.SetText("super", CppNameOf(Super));
    } else {
        Entity.SetNull("super");
    }
    Entity.SetList("flags", FlagsOf(Struct));
    Entity.SetList("properties", PropertiesOf(Struct));
    SetEditorOf(Entity, Struct);
    return Entity;
}

std::string ShortNameOf(const UEnum* Enum, int32 Index) {
    const std::string Full = ToUtf8(Enum->GetNameByIndex(Index));
    const std::size_t Scope = Full.rfind("::");
    return Scope == std::string::npos ? Full : Full.substr(Scope + 2);
}

/// The number of entries as written: without the hidden _MAX that UEnum::SetEnums adds.
int32 NumWrittenEntries(const UEnum* Enum) {
    const int32 Num = Enum->NumEnums();
    if (Num == 0) {
        return 0;
    }
#if WITH_METADATA
    return Enum->HasMetaData(TEXT("Name"), Num - 1) ? Num : Num - 1;
#else
    std::string Prefix = Num > 1 ? ShortNameOf(Enum, 0) : ToUtf8(Enum->GetName());
    int64 Highest = INT64_MIN;
    for (int32 Index = 0; Index + 1 < Num; ++Index) {
        const std::string Name = ShortNameOf(Enum, Index);
        const auto Different = std::mismatch(Prefix.begin(), Prefix.end(), Name.begin(), Name.end());
        Prefix.erase(Different.first, Prefix.end());
        Highest = std::max(Highest, Enum->GetValueByIndex(Index));
    }
    const std::size_t Underscore = Prefix.rfind('_');
    Prefix = Underscore == std::string::npos ? ToUtf8(Enum->GetName()) : Prefix.substr(0, Underscore);
    const bool bGenerated =
        ShortNameOf(Enum, Num - 1) == Prefix + "_MAX" && Enum->GetValueByIndex(Num - 1) == Highest + 1;
    return bGenerated ? Num - 1 : Num;
#endif
}

FSchemaDict EnumEntity(const UEnum* Enum) {
    FSchemaDict Entity;
    Entity.SetText("name", Enum->GetName());
    Entity.SetText("reflected_name", Enum->GetName());
    Entity.SetText("path", Enum->GetPathName());
    Entity.SetText("module", ModuleOf(Enum));
    const UEnum::ECppForm Form = Enum->GetCppForm();
    Entity.SetText("form", Form == UEnum::ECppForm::Regular      ? "regular"
                           : Form == UEnum::ECppForm::Namespaced ? "namespaced"
                                                                 : "class");
    Entity.SetText("cpp_type", Enum->CppType);
    FSchemaList Flags;
    if (Enum->HasAnyEnumFlags(EEnumFlags::Flags)) {
        Flags.AddText("Flags");
    }
    Entity.SetList("flags", Flags);

    const int32 Num = NumWrittenEntries(Enum);
#if WITH_METADATA
    // The enum's metadata holds that of its entries too, as "Entry.Key".
    FMetaPairs OfEnum = PairsOf(MetaDataOf(Enum));
    std::map<std::string, FMetaPairs> OfEntries;
    for (int32 Index = 0; Index < Num; ++Index) {
        OfEntries[ToLower(ShortNameOf(Enum, Index))];
    }
    for (auto At = OfEnum.begin(); At != OfEnum.end();) {
        const std::size_t Dot = At->first.find('.');
        const auto Entry =
            Dot == std::string::npos ? OfEntries.end() : OfEntries.find(ToLower(At->first.substr(0, Dot)));
        if (Entry == OfEntries.end()) {
            ++At;
            continue;
        }
        Entry->second[At->first.substr(Dot + 1)] = At->second;
        At = OfEnum.erase(At);
    }
#endif
    FSchemaList Entries;
    for (int32 Index = 0; Index < Num; ++Index) {
        FSchemaDict One;
        One.SetText("name", ToUtf8(Enum->GetNameByIndex(Index)));
        One.SetNumber("value", Enum->GetValueByIndex(Index));
#if WITH_METADATA
        SetEditor(One, OfEntries[ToLower(ShortNameOf(Enum, Index))]);
#endif
        One.WriteTo(Entries.Add());
    }
    Entity.SetList("entries", Entries);
#if WITH_METADATA
    SetEditor(Entity, OfEnum);
#endif
    return Entity;
}

FSchemaDict DelegateEntity(const UFunction* Signature) {
    FSchemaDict Entity;
    Entity.SetText("name", SchemaNameOf(Signature));
    Entity.SetText("reflected_name", Signature->GetName());
    Entity.SetText("path", Signature->GetPathName());
    Entity.SetText("module", ModuleOf(Signature));
    if (const UClass* Owner = Cast<UClass>(Signature->GetOuter())) {
        Entity.SetText("owner", SchemaNameOf(Owner));
    } else {
        Entity.SetNull("owner");
    }
    Entity.SetText("kind", Signature->IsA<USparseDelegateFunction>()                ? "sparse"
                           : Signature->HasAnyFunctionFlags(FUNC_MulticastDelegate) ? "multicast"
                                                                                    : "single");
    Entity.SetList("flags", FlagsOf(Signature));
    SetSignature(Entity, Signature);
    SetEditorOf(Entity, Signature);
    return Entity;
}

/// Types that are being replaced, or that only exist to be.
bool IsCurrent(const UObject* Type) {
    const UClass* Class = Cast<UClass>(Type);
    return IsValid(Type) && !(Class && Class->HasAnyClassFlags(CLASS_NewerVersionExists | CLASS_Intrinsic)) &&
           !Type->HasAnyFlags(RF_ClassDefaultObject);
}

} // namespace

void WriteClassSchema(const UClass* Class, spear::Encoder& Out) { ClassEntity(Class).WriteTo(Out); }

FStatus WriteSchema(const std::vector<std::string>& Modules, spear::Encoder& Out) {
    std::set<std::string> Wanted;
    for (const std::string& Module : Modules) {
        Wanted.insert(ToLower(Module));
    }
    const auto IsWanted = [&](const UObject* Type) {
        return IsCurrent(Type) && (Wanted.empty() || Wanted.count(ToLower(ModuleOf(Type))) != 0);
    };

    FSchemaEntities ModuleList;
    std::set<std::string> Known;
    for (TObjectIterator<UPackage> It; It; ++It) {
        if (!It->GetName().StartsWith(TEXT("/Script/"))) {
            continue;
        }
        const std::string Name = ModuleOf(*It);
        Known.insert(ToLower(Name));
        if (Wanted.empty() || Wanted.count(ToLower(Name)) != 0) {
            FSchemaDict Module;
            Module.SetText("name", Name);
            Module.WriteTo(ModuleList.Add(Name));
        }
    }
    for (const std::string& Module : Modules) {
        if (Known.count(ToLower(Module)) == 0) {
            FNearestNames Nearest(Module);
            for (const std::string& Name : Known) {
                Nearest.Add(Name);
            }
            return MakeError(ErrorCode::UnknownObject,
                "no module '" + Module.substr(0, 256) + "' is loaded" + Nearest.Suggestion(), "modules");
        }
    }

    FSchemaEntities Classes, Structs, Enums, Delegates;
    for (TObjectIterator<UClass> It; It; ++It) {
        if (IsWanted(*It)) {
            ClassEntity(*It).WriteTo(Classes.Add(SchemaNameOf(*It), ToUtf8(It->GetPathName())));
        }
    }
    for (TObjectIterator<UScriptStruct> It; It; ++It) {
        if (IsWanted(*It)) {
            StructEntity(*It).WriteTo(Structs.Add(CppNameOf(*It), ToUtf8(It->GetPathName())));
        }
    }
    for (TObjectIterator<UEnum> It; It; ++It) {
        if (IsWanted(*It)) {
            EnumEntity(*It).WriteTo(Enums.Add(ToUtf8(It->GetName()), ToUtf8(It->GetPathName())));
        }
    }
    for (TObjectIterator<UDelegateFunction> It; It; ++It) {
        if (IsWanted(*It)) {
            DelegateEntity(*It).WriteTo(Delegates.Add(SchemaNameOf(*It), ToUtf8(It->GetPathName())));
        }
    }

    FSchemaDict Schema;
    Schema.SetText("format", "spear-schema");
    Schema.SetNumber("version", 1);
    Schema.SetText("origin", "live");
    ModuleList.WriteTo(Schema.Set("modules"));
    Classes.WriteTo(Schema.Set("classes"));
    Structs.WriteTo(Schema.Set("structs"));
    Enums.WriteTo(Schema.Set("enums"));
    Delegates.WriteTo(Schema.Set("delegates"));
    Schema.WriteTo(Out);
    return {};
}

} // namespace SpearServer
