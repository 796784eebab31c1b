// SPDX-License-Identifier: MIT
#include "Reflection/ValueReader.h"

#include "SpearText.h"

#include "Frame/Session.h"
#include "Reflection/ClassLookup.h"
#include "Reflection/NearestNames.h"

namespace SpearServer {

namespace types = spear::types;

bool FValueReader::ReadDelegate(
    const UFunction* Signature, FScriptDelegate& Out, spear::Decoder& In, spear::TypeId Type) {
    Out.Unbind();
    if (Type == types::null) {
        return true;
    }
    const spear::TypeTables Tables = Operation.Session->Tables();
    const std::string Expected = "a delegate {Object, FunctionName}";
    uint64 Handle = 0;
    std::string FunctionName;
    bool bGood = true;
    const auto ReadField = [&](std::string_view Field, spear::TypeId FieldType) {
        if (FieldType == types::any) {
            FieldType = In.get<spear::TypeId>();
        }
        if (EqualsWithoutCase(Field, "Object") && (FieldType == types::object || FieldType == types::null)) {
            if (FieldType == types::object) {
                Handle = In.get<uint64>();
                (void)In.get<spear::TypeId>();
            }
        } else if (EqualsWithoutCase(Field, "FunctionName") && FieldType == types::string) {
            FunctionName = std::string(In.get_text());
        } else {
            bGood = false;
        }
    };
    const spear::TypeInfo* Info = Tables.find(Type);
    if (Type == types::dict) {
        for (uint32 Left = In.get_count(8); Left != 0 && In.ok() && bGood; --Left) {
            const std::string_view Field = In.get_text();
            ReadField(Field, types::any);
        }
    } else if (Info && Info->kind == spear::TypeKind::structure) {
        for (const spear::FieldInfo& Field : Info->fields) {
            if (bGood) {
                ReadField(Field.name, Field.type);
            }
        }
    } else {
        bGood = false;
    }
    if (!bGood) {
        return Fail(ErrorCode::WrongType,
            Place() + " must be " + Expected + " or null, not " + DescribeType(Tables, Type), Expected);
    }
    if (Handle == 0 && FunctionName.empty()) {
        return true;
    }
    TSpearResult<UObject*> Object = Operation.Session->Handles.ResolveNonNull(Handle);
    if (!Object.IsOk()) {
        return Fail(Object.GetError().code, Place() + ": " + Object.GetError().message, Expected);
    }
    const FName Function = FindName(FunctionName);
    const UFunction* Found = Function.IsNone() ? nullptr : Object.GetValue()->FindFunction(Function);
    if (!Found) {
        FNearestNames Nearest(FunctionName);
        AddFunctionNames(Nearest, Object.GetValue()->GetClass());
        return Fail(ErrorCode::UnknownFunction,
            Place() + ": " + CppNameOf(Object.GetValue()->GetClass()) + " has no function '" + FunctionName + "'" +
                Nearest.Suggestion(),
            Expected);
    }
    if (Signature && !Found->IsSignatureCompatibleWith(Signature)) {
        return Fail(ErrorCode::WrongType,
            Place() + ": the parameters of '" + FunctionName + "' are not those of the delegate", Expected);
    }
    Out.BindUFunction(Object.GetValue(), Function);
    return true;
}

bool FValueReader::ReadMulticast(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    const FMulticastDelegateProperty* Property = CastFieldChecked<FMulticastDelegateProperty>(Plan.Property);
    std::vector<FScriptDelegate> Delegates;
    if (Type != types::null) {
        spear::TypeId ElementType = types::any;
        uint32 Count = 0;
        if (!ReadCount(Plan, In, Type, ElementType, Count)) {
            return false;
        }
        for (uint32 Index = 0; Index < Count; ++Index) {
            const spear::TypeId One = ElementType == types::any ? In.get<spear::TypeId>() : ElementType;
            if (!ReadDelegate(Property->SignatureFunction, Delegates.emplace_back(), In, One)) {
                return false;
            }
        }
    }
    Property->ClearDelegate(nullptr, Address);
    for (const FScriptDelegate& Delegate : Delegates) {
        if (Delegate.IsBound()) {
            Property->AddDelegate(Delegate, nullptr, Address);
        }
    }
    return true;
}

} // namespace SpearServer
