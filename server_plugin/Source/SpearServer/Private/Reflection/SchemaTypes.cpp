// SPDX-License-Identifier: MIT
#include "Reflection/SchemaTypes.h"

#include "SpearCompat.h"

#include "Reflection/TypePlan.h"

#include "UObject/EnumProperty.h"
#include "UObject/Package.h"
#include "UObject/PropertyOptional.h"
#include "UObject/TextProperty.h"

#include <algorithm>
#include <vector>

namespace SpearServer {

namespace {

struct FFlagName {
    uint64 Flag;
    const char* Name;
};

FSchemaList NamesOf(uint64 Flags, const std::vector<FFlagName>& Known) {
    std::vector<std::string_view> Names;
    for (const FFlagName& One : Known) {
        if ((Flags & One.Flag) != 0) {
            Names.push_back(One.Name);
        }
    }
    std::sort(Names.begin(), Names.end());
    FSchemaList List;
    for (const std::string_view Name : Names) {
        List.AddText(Name);
    }
    return List;
}

#define SPEAR_FLAG(Prefix, Name) {static_cast<uint64>(Prefix##Name), #Name}

const std::vector<FFlagName>& ClassFlagNames() {
#define F(Name) SPEAR_FLAG(CLASS_, Name)
    static const std::vector<FFlagName> Names = {F(Abstract), F(Const), F(Transient), F(Optional),
        F(DefaultToInstanced), F(Hidden), F(HideDropDown), F(Deprecated), F(EditInlineNew), F(CollapseCategories),
        F(PerObjectConfig), F(PerPlatformConfig), F(DefaultConfig), F(GlobalUserConfig), F(ProjectUserConfig),
        F(ConfigDoNotCheckDefaults), F(NeedsDeferredDependencyLoading), F(NoExport), F(MinimalAPI), F(NotPlaceable),
        F(Config), F(HasInstancedReference), F(Interface), F(RequiredAPI)};
#undef F
    return Names;
}

const std::vector<FFlagName>& StructFlagNames() {
#define F(Name) SPEAR_FLAG(STRUCT_, Name)
    static const std::vector<FFlagName> Names = {
        F(Atomic), F(Immutable), F(NoExport), F(HasInstancedReference), F(RequiredAPI)};
#undef F
    return Names;
}

const std::vector<FFlagName>& FunctionFlagNames() {
#define F(Name) SPEAR_FLAG(FUNC_, Name)
    static const std::vector<FFlagName> Names = {F(Final), F(BlueprintAuthorityOnly), F(BlueprintCosmetic), F(Net),
        F(NetReliable), F(NetRequest), F(NetResponse), F(NetMulticast), F(NetServer), F(NetClient), F(NetValidate),
        F(Exec), F(Native), F(Event), F(Static), F(MulticastDelegate), F(Delegate), F(Public), F(Private), F(Protected),
        F(HasOutParms), F(HasDefaults), F(BlueprintCallable), F(BlueprintEvent), F(BlueprintPure), F(EditorOnly),
        F(Const)};
#undef F
    return Names;
}

const std::vector<FFlagName>& PropertyFlagNames() {
#define F(Name) SPEAR_FLAG(CPF_, Name)
    static const std::vector<FFlagName> Names = {F(Edit), F(ConstParm), F(BlueprintVisible), F(ExportObject),
        F(BlueprintReadOnly), F(Net), F(EditFixedSize), F(Parm), F(OutParm), F(ReturnParm), F(DisableEditOnTemplate),
        F(Transient), F(Config), F(RequiredParm), F(DisableEditOnInstance), F(EditConst), F(GlobalConfig),
        F(InstancedReference), F(DuplicateTransient), F(SaveGame), F(NoClear), F(ReferenceParm), F(BlueprintAssignable),
        F(Deprecated), F(RepSkip), F(RepNotify), F(Interp), F(NonTransactional), F(EditorOnly), F(AutoWeak),
        F(ContainsInstancedReference), F(AssetRegistrySearchable), F(SimpleDisplay), F(AdvancedDisplay), F(Protected),
        F(BlueprintCallable), F(BlueprintAuthorityOnly), F(TextExportTransient), F(NonPIEDuplicateTransient),
        F(ExposeOnSpawn), F(PersistentInstance), F(UObjectWrapper), F(NativeAccessSpecifierPublic),
        F(NativeAccessSpecifierProtected), F(NativeAccessSpecifierPrivate), F(SkipSerialization), F(TObjectPtr)};
#undef F
    return Names;
}

#undef SPEAR_FLAG

/// Kind and canonical C++ text of properties that have no further facts.
struct FPlainKind {
    const char* Kind = nullptr;
    const char* Cpp = nullptr;
};

FPlainKind PlainKindOf(const FProperty* Property) {
    if (Property->IsA<FInt8Property>())
        return {"int8", "int8"};
    if (Property->IsA<FInt16Property>())
        return {"int16", "int16"};
    if (Property->IsA<FIntProperty>())
        return {"int32", "int32"};
    if (Property->IsA<FInt64Property>())
        return {"int64", "int64"};
    if (Property->IsA<FByteProperty>())
        return {"uint8", "uint8"};
    if (Property->IsA<FUInt16Property>())
        return {"uint16", "uint16"};
    if (Property->IsA<FUInt32Property>())
        return {"uint32", "uint32"};
    if (Property->IsA<FUInt64Property>())
        return {"uint64", "uint64"};
    if (Property->IsA<FFloatProperty>())
        return {"float", "float"};
    if (Property->IsA<FDoubleProperty>())
        return {"double", "double"};
    if (Property->IsA<FStrProperty>())
        return {"string", "FString"};
    if (Property->IsA<FNameProperty>())
        return {"name", "FName"};
    if (Property->IsA<FTextProperty>())
        return {"text", "FText"};
    return {};
}

/// A node while it is made: its C++ text is needed by the node around it.
struct FNode {
    FSchemaDict Dict;
    std::string Cpp;
};

FNode MakeNode(const FProperty* Property);

FNode Named(const char* Kind, std::string Name, std::string Cpp) {
    FNode Node;
    Node.Dict.SetText("kind", Kind);
    Node.Dict.SetText("name", Name);
    Node.Cpp = std::move(Cpp);
    return Node;
}

FNode Delegate(const char* Kind, const UFunction* Signature) {
    const std::string Name = SchemaNameOf(Signature);
    FNode Node = Named(Kind, Name, Name);
    if (const UClass* Owner = Cast<UClass>(Signature->GetOuter())) {
        Node.Dict.SetText("owner", SchemaNameOf(Owner));
    }
    return Node;
}

FNode Container(const char* Kind, const char* Template, const FProperty* Inner) {
    FNode Node;
    FNode InnerNode = MakeNode(Inner);
    Node.Dict.SetText("kind", Kind);
    Node.Dict.SetDict("inner", InnerNode.Dict);
    Node.Cpp = std::string(Template) + "<" + InnerNode.Cpp + ">";
    return Node;
}

std::string InTemplate(const char* Template, const std::string& Name) {
    return std::string(Template) + "<" + Name + ">";
}

FNode MakeNodeWithoutCpp(const FProperty* Property) {
    if (const FBoolProperty* Bool = CastField<FBoolProperty>(Property)) {
        FNode Node;
        Node.Dict.SetText("kind", "bool");
        if (!Bool->IsNativeBool()) {
            Node.Dict.SetTrue("bitfield");
        }
        Node.Cpp = "bool";
        return Node;
    }
    if (const FEnumProperty* Enum = CastField<FEnumProperty>(Property)) {
        const std::string Name = ToUtf8(Enum->GetEnum()->GetName());
        FNode Node = Named("enum", Name, Name);
        Node.Dict.SetText("underlying", PlainKindOf(Enum->GetUnderlyingProperty()).Kind);
        return Node;
    }
    if (const FByteProperty* Byte = CastField<FByteProperty>(Property); Byte && Byte->Enum) {
        return Named(
            "byte_enum", ToUtf8(Byte->Enum->GetName()), InTemplate("TEnumAsByte", ToUtf8(Byte->Enum->CppType)));
    }
    if (const FPlainKind Plain = PlainKindOf(Property); Plain.Kind) {
        FNode Node;
        Node.Dict.SetText("kind", Plain.Kind);
        Node.Cpp = Plain.Cpp;
        return Node;
    }
    if (const FClassProperty* Class = CastField<FClassProperty>(Property)) {
        const std::string Name = SchemaNameOf(Class->MetaClass ? Class->MetaClass.Get() : UObject::StaticClass());
        return Named("class", Name, InTemplate("TSubclassOf", Name));
    }
    if (const FSoftClassProperty* SoftClass = CastField<FSoftClassProperty>(Property)) {
        const std::string Name =
            SchemaNameOf(SoftClass->MetaClass ? SoftClass->MetaClass.Get() : UObject::StaticClass());
        return Named("soft_class", Name, InTemplate("TSoftClassPtr", Name));
    }
    if (const FObjectPropertyBase* Object = CastField<FObjectPropertyBase>(Property)) {
        const std::string Name = SchemaNameOf(Object->PropertyClass);
        if (Property->IsA<FWeakObjectProperty>())
            return Named("weak_object", Name, InTemplate("TWeakObjectPtr", Name));
        if (Property->IsA<FLazyObjectProperty>())
            return Named("lazy_object", Name, InTemplate("TLazyObjectPtr", Name));
        if (Property->IsA<FSoftObjectProperty>())
            return Named("soft_object", Name, InTemplate("TSoftObjectPtr", Name));
        return Named("object", Name, Name + "*");
    }
    if (const FInterfaceProperty* Interface = CastField<FInterfaceProperty>(Property)) {
        const std::string Name = CppNameOf(Interface->InterfaceClass);
        return Named("interface", Name, InTemplate("TScriptInterface", Name));
    }
    if (const FStructProperty* Struct = CastField<FStructProperty>(Property)) {
        const std::string Name = CppNameOf(Struct->Struct);
        return Named("struct", Name, Name);
    }
    if (const FArrayProperty* Array = CastField<FArrayProperty>(Property))
        return Container("array", "TArray", Array->Inner);
    if (const FSetProperty* Set = CastField<FSetProperty>(Property))
        return Container("set", "TSet", Set->ElementProp);
    if (const FOptionalProperty* Optional = CastField<FOptionalProperty>(Property))
        return Container("optional", "TOptional", Optional->GetValueProperty());
    if (const FMapProperty* Map = CastField<FMapProperty>(Property)) {
        FNode Node;
        FNode Key = MakeNode(Map->KeyProp);
        FNode Value = MakeNode(Map->ValueProp);
        Node.Dict.SetText("kind", "map");
        Node.Dict.SetDict("key", Key.Dict);
        Node.Dict.SetDict("value", Value.Dict);
        Node.Cpp = "TMap<" + Key.Cpp + ", " + Value.Cpp + ">";
        return Node;
    }
    if (const FDelegateProperty* Single = CastField<FDelegateProperty>(Property))
        return Delegate("delegate", Single->SignatureFunction);
    if (const FMulticastDelegateProperty* Multicast = CastField<FMulticastDelegateProperty>(Property)) {
        return Delegate(Property->IsA<FMulticastSparseDelegateProperty>() ? "sparse_delegate" : "multicast_delegate",
            Multicast->SignatureFunction);
    }
    if (const std::string Name = FieldPathTypeOf(Property); !Name.empty()) {
        return Named("field_path", Name, InTemplate("TFieldPath", Name));
    }
    // A kind that this version of the schema does not know: its own name for itself.
    return Named("unknown", CppTypeOf(Property), CppTypeOf(Property));
}

FNode MakeNode(const FProperty* Property) {
    FNode Node = MakeNodeWithoutCpp(Property);
    Node.Dict.SetText("cpp", Node.Cpp);
    return Node;
}

} // namespace

std::string SchemaNameOf(const UClass* Class) { return ToUtf8(FString(Class->GetPrefixCPP()) + Class->GetName()); }

std::string SchemaNameOf(const UFunction* Signature) {
    FString Name = Signature->GetName();
    Name.RemoveFromEnd(HEADER_GENERATED_DELEGATE_SIGNATURE_SUFFIX);
    return "F" + ToUtf8(Name);
}

std::string ModuleOf(const UObject* Object) {
    FString Name = Object->GetOutermost()->GetName();
    Name.RemoveFromStart(TEXT("/Script/"));
    return ToUtf8(Name);
}

FSchemaDict TypeNodeOf(const FProperty* Property) { return MakeNode(Property).Dict; }

FSchemaList FlagsOf(const UClass* Class) { return NamesOf(static_cast<uint64>(Class->ClassFlags), ClassFlagNames()); }
FSchemaList FlagsOf(const UScriptStruct* Struct) {
    return NamesOf(static_cast<uint64>(Struct->StructFlags), StructFlagNames());
}
FSchemaList FlagsOf(const UFunction* Function) {
    return NamesOf(static_cast<uint64>(Function->FunctionFlags), FunctionFlagNames());
}
FSchemaList FlagsOf(const FProperty* Property) {
    return NamesOf(static_cast<uint64>(Property->GetPropertyFlags()), PropertyFlagNames());
}

} // namespace SpearServer
