// SPDX-License-Identifier: MIT
#include "Reflection/CallPlanBuilder.h"

#include "SpearCompat.h"
#include "SpearText.h"

#include "Reflection/ClassLookup.h"
#include "Reflection/NearestNames.h"

#include "Engine/LatentActionManager.h"
#include "UObject/EnumProperty.h"
#include "UObject/Script.h"

#include <algorithm>

namespace SpearServer {

namespace {

/// Metadata of a function, where the build has it.
FString MetaOf(const UFunction* Function, const TCHAR* Key) {
#if WITH_METADATA
    return Function->GetMetaData(Key);
#else
    return FString();
#endif
}

bool HasMeta(const UFunction* Function, const TCHAR* Key) {
#if WITH_METADATA
    return Function->HasMetaData(Key);
#else
    return false;
#endif
}

struct FFoundFunction {
    UFunction* Function = nullptr;
    bool bOnDefaultObject = false;
};

TSpearResult<FFoundFunction> FindFunctionFor(UObject* Target, const std::string& Name) {
    const UClass* TargetAsClass = Cast<UClass>(Target);
    const std::string Owner = CppNameOf(TargetAsClass ? TargetAsClass : Target->GetClass());
    const FName FunctionName = FindName(Name);
    FFoundFunction Found;
    if (!FunctionName.IsNone()) {
        Found.Function = Target->FindFunction(FunctionName);
        if (!Found.Function && TargetAsClass) {
            Found.Function = TargetAsClass->FindFunctionByName(FunctionName);
            Found.bOnDefaultObject = Found.Function != nullptr;
        }
    }
    if (!Found.Function) {
        FNearestNames Nearest(Name);
        AddFunctionNames(Nearest, TargetAsClass ? TargetAsClass : Target->GetClass());
        return MakeError(ErrorCode::UnknownFunction,
            Owner + " has no function '" + Name.substr(0, 256) + "'" + Nearest.Suggestion());
    }

    const UFunction* Function = Found.Function;
    const std::string Full = Owner + "::" + ToUtf8(Function->GetName());
    if (Found.bOnDefaultObject && !Function->HasAnyFunctionFlags(FUNC_Static)) {
        return MakeError(
            ErrorCode::NotCallable, Full + " is not static: call it on an object of the class, not on the class");
    }
    if (Found.bOnDefaultObject && TargetAsClass->HasAnyClassFlags(CLASS_Interface)) {
        return MakeError(
            ErrorCode::NotCallable, Full + " is a function of an interface: call it on an object that implements it");
    }
    if (Function->HasAnyFunctionFlags(FUNC_Delegate)) {
        return MakeError(ErrorCode::NotCallable, Full + " is the signature of a delegate, not a function");
    }
    if (HasMeta(Function, TEXT("CustomThunk"))) {
        return MakeError(ErrorCode::NotCallable,
            Full + " has a custom thunk: it takes values whose types only the Blueprint compiler knows");
    }
    if (!Function->HasAnyFunctionFlags(FUNC_Native) && Function->Script.Num() == 0) {
        return MakeError(
            ErrorCode::NotCallable, Full + " has no body in " + Owner + ": it is an event that nobody has implemented");
    }
    return Found;
}

bool IsOutput(const FProperty* Property) {
    return Property->HasAnyPropertyFlags(CPF_OutParm) && !Property->HasAnyPropertyFlags(CPF_ConstParm);
}

/// An output that is no input: not passed by reference from the caller (UPARAM(ref)).
bool IsPureOutput(const FProperty* Property) {
    return IsOutput(Property) && !Property->HasAnyPropertyFlags(CPF_ReferenceParm);
}

const FObjectPropertyBase* FindWorldContext(const UFunction* Function) {
    const FString Declared = MetaOf(Function, TEXT("WorldContext"));
    for (TFieldIterator<FProperty> It(Function); It && It->HasAnyPropertyFlags(CPF_Parm); ++It) {
        const FString Name = It->GetName();
        if (Name.Equals(Declared, ESearchCase::IgnoreCase) ||
            (Declared.IsEmpty() && Function->HasAnyFunctionFlags(FUNC_Static) &&
                Name.Equals(TEXT("WorldContextObject"), ESearchCase::IgnoreCase))) {
            return CastField<FObjectProperty>(*It);
        }
    }
    return nullptr;
}

const FStructProperty* FindLatentInfo(const UFunction* Function) {
    for (TFieldIterator<FProperty> It(Function); It && It->HasAnyPropertyFlags(CPF_Parm); ++It) {
        const FStructProperty* Property = CastField<FStructProperty>(*It);
        if (Property && Property->Struct == FLatentActionInfo::StaticStruct()) {
            return Property;
        }
    }
    return nullptr;
}

ErrorInfo UnknownArgument(const FCallPlan& Plan, const UFunction* Function, const std::string& Name) {
    FNearestNames Nearest(Name);
    std::string All;
    for (TFieldIterator<FProperty> It(Function); It && It->HasAnyPropertyFlags(CPF_Parm); ++It) {
        if (!It->HasAnyPropertyFlags(CPF_ReturnParm)) {
            Nearest.Add(ToUtf8(It->GetName()));
            All += (All.empty() ? "" : ", ") + ToUtf8(It->GetName());
        }
    }
    std::string Suggestion = Nearest.Suggestion();
    if (Suggestion.empty()) {
        Suggestion = All.empty() ? "; it has no parameters" : "; its parameters are " + All;
    }
    return MakeError(ErrorCode::UnknownArgument,
        Plan.OperationName + " has no parameter '" + Name.substr(0, 256) + "'" + Suggestion, Name.substr(0, 256));
}

/// Gives each omitted parameter its default, or says which has none.
FStatus FillDefaults(FCallPlan& Plan, UFunction* Function, const std::vector<const FProperty*>& Given) {
    Plan.Layout = std::make_unique<FParameterLayout>(Function);
    Plan.Defaults = std::make_unique<FParameters>(*Plan.Layout);
    for (TFieldIterator<FProperty> It(Function); It && It->HasAnyPropertyFlags(CPF_Parm); ++It) {
        const FProperty* Property = *It;
        if (Property->HasAnyPropertyFlags(CPF_ReturnParm) || Property == Plan.WorldContext ||
            Property == Plan.LatentInfo || std::find(Given.begin(), Given.end(), Property) != Given.end()) {
            continue;
        }
        const FString Key = FString(TEXT("CPP_Default_")) + Property->GetName();
        if (HasMeta(Function, *Key)) {
            const FString Text = MetaOf(Function, *Key);
            // An empty text stands for what a new value is anyway.
            if (!Text.IsEmpty() &&
                !ImportDefaultText(Property, *Text, Property->ContainerPtrToValuePtr<void>(Plan.Defaults->Get()))) {
                return MakeError(ErrorCode::MissingArgument,
                    Plan.OperationName + ": the default '" + ToUtf8(Text) + "' of '" + ToUtf8(Property->GetName()) +
                        "' cannot be read; give the argument",
                    ToUtf8(Property->GetName()), CppTypeOf(Property));
            }
            Plan.Omitted.push_back(Property);
        } else if (!IsPureOutput(Property)) {
            return MakeError(ErrorCode::MissingArgument,
                Plan.OperationName + ": argument '" + ToUtf8(Property->GetName()) + "' (" + CppTypeOf(Property) +
                    ") is missing and has no default",
                ToUtf8(Property->GetName()), CppTypeOf(Property));
        }
    }
    return {};
}

void DescribeResults(FCallPlan& Plan, UFunction* Function) {
    if (const FProperty* Return = Function->GetReturnProperty()) {
        Plan.bHasReturnValue = true;
        Plan.Results.push_back({Return, GetTypePlan(Return), "ReturnValue"});
    }
    for (TFieldIterator<FProperty> It(Function); It && It->HasAnyPropertyFlags(CPF_Parm); ++It) {
        if (!It->HasAnyPropertyFlags(CPF_ReturnParm) && IsOutput(*It)) {
            Plan.Results.push_back({*It, GetTypePlan(*It), ToUtf8(It->GetName())});
        }
    }
    Plan.ResultType.kind = spear::TypeKind::structure;
    Plan.ResultType.name = ToUtf8(Function->GetName()) + "_Result";
}

} // namespace

bool ImportDefaultText(const FProperty* Property, const TCHAR* Text, void* Value) {
    // Defaults of vectors and rotators are written as three bare numbers (UHT's way), which ImportText does not read.
    const FStructProperty* Struct = CastField<FStructProperty>(Property);
    if (Struct && Text[0] != TEXT('(')) {
        TArray<FString> Parts;
        FString(Text).ParseIntoArray(Parts, TEXT(","), true);
        int32 Index = 0;
        for (TFieldIterator<FProperty> It(Struct->Struct); It; ++It, ++Index) {
            if (Index >= Parts.Num() ||
                !It->ImportText_Direct(*Parts[Index], It->ContainerPtrToValuePtr<void>(Value), nullptr, PPF_None)) {
                return false;
            }
        }
        return Index == Parts.Num();
    }
    if (FStrProperty const* String = CastField<FStrProperty>(Property)) {
        String->SetPropertyValue(Value, FString(Text)); // bare text, without the quotes that ImportText may ask for
        return true;
    }
    const FEnumProperty* EnumProperty = CastField<FEnumProperty>(Property);
    const FByteProperty* ByteProperty = CastField<FByteProperty>(Property);
    if (const UEnum* Enum = EnumProperty   ? EnumProperty->GetEnum()
                            : ByteProperty ? ByteProperty->GetIntPropertyEnum()
                                           : nullptr) {
        const int32 Index = Enum->GetIndexByNameString(Text);
        if (Index == INDEX_NONE) {
            return false;
        }
        const FNumericProperty* Underlying = EnumProperty ? EnumProperty->GetUnderlyingProperty() : ByteProperty;
        Underlying->SetIntPropertyValue(Value, Enum->GetValueByIndex(Index));
        return true;
    }
    return Property->ImportText_Direct(Text, Value, nullptr, PPF_None) != nullptr;
}

TSpearResult<std::unique_ptr<FCallPlan>> BuildCallPlan(UObject* Target, const spear::TypeInfo& Shape) {
    // The path, if there is one, holds the name as the user wrote it, before the client replaced an alias
    // ("GetActorLocation" for K2_GetActorLocation): a class that has that very function means it.
    TSpearResult<FFoundFunction> Found = FindFunctionFor(Target, Shape.path.empty() ? Shape.name : Shape.path);
    if (!Found.IsOk() && !Shape.path.empty() && Found.GetError().code == ErrorCode::UnknownFunction) {
        Found = FindFunctionFor(Target, Shape.name);
    }
    if (!Found.IsOk()) {
        return std::move(Found.GetError());
    }
    UFunction* Function = Found.GetValue().Function;
    auto Plan = std::make_unique<FCallPlan>();
    Plan->bOnDefaultObject = Found.GetValue().bOnDefaultObject;
    Plan->Class = FWeakObjectPtr(Plan->bOnDefaultObject ? Cast<UClass>(Target) : Target->GetClass());
    Plan->Function = FWeakObjectPtr(Function);
    Plan->OperationName = CppNameOf(Cast<UClass>(Plan->Class.Get(true))) + "::" + ToUtf8(Function->GetName());
    const FObjectPropertyBase* const WorldContext = FindWorldContext(Function);
    const FStructProperty* const LatentInfo = FindLatentInfo(Function);

    // The parameters that positional arguments fill, in order.
    std::vector<const FProperty*> Positional;
    for (TFieldIterator<FProperty> It(Function); It && It->HasAnyPropertyFlags(CPF_Parm); ++It) {
        if (!It->HasAnyPropertyFlags(CPF_ReturnParm) && !IsPureOutput(*It) && *It != WorldContext &&
            *It != LatentInfo) {
            Positional.push_back(*It);
        }
    }

    std::vector<const FProperty*> Given;
    std::size_t NextPositional = 0;
    for (const spear::FieldInfo& Field : Shape.fields) {
        const FProperty* Property = nullptr;
        if (Field.name.empty()) {
            if (NextPositional >= Positional.size()) {
                return MakeError(ErrorCode::UnknownArgument, Plan->OperationName + " takes at most " +
                                                                 std::to_string(Positional.size()) +
                                                                 " positional arguments");
            }
            Property = Positional[NextPositional++];
        } else {
            const FName Name = FindName(Field.name);
            Property = Name.IsNone() ? nullptr : Function->FindPropertyByName(Name);
            if (!Property || !Property->HasAnyPropertyFlags(CPF_Parm) ||
                Property->HasAnyPropertyFlags(CPF_ReturnParm)) {
                return UnknownArgument(*Plan, Function, Field.name);
            }
        }
        if (Property == LatentInfo) {
            return MakeError(ErrorCode::UnknownArgument,
                Plan->OperationName + ": '" + Field.name + "' is filled in by the server; the call gives a future",
                Field.name);
        }
        if (std::find(Given.begin(), Given.end(), Property) != Given.end()) {
            return MakeError(ErrorCode::UnknownArgument,
                Plan->OperationName + ": argument '" + ToUtf8(Property->GetName()) + "' is given twice",
                ToUtf8(Property->GetName()));
        }
        Given.push_back(Property);
        Plan->Arguments.push_back({Property, GetTypePlan(Property), ToUtf8(Property->GetName())});
    }
    Plan->LatentInfo = LatentInfo;
    if (std::find(Given.begin(), Given.end(), WorldContext) == Given.end()) {
        Plan->WorldContext = WorldContext;
    }

    FStatus Defaults = FillDefaults(*Plan, Function, Given);
    if (!Defaults.IsOk()) {
        return std::move(Defaults.GetError());
    }
    DescribeResults(*Plan, Function);
    return Plan;
}

} // namespace SpearServer
