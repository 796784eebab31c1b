// SPDX-License-Identifier: MIT
#include "Reflection/ValueReader.h"

#include "SpearText.h"

#include "Frame/Session.h"
#include "Reflection/ClassLookup.h"
#include "Reflection/NearestNames.h"

#include "Misc/StringOutputDevice.h"
#include "UObject/EnumProperty.h"
#include "UObject/PropertyOptional.h"
#include "UObject/TextProperty.h"

#include "spear/limits.hpp"

namespace SpearServer {

namespace types = spear::types;

FTemporaryValue::FTemporaryValue(const FProperty* InProperty)
    : Property(InProperty), Memory(FMemory::Malloc(static_cast<SIZE_T>(InProperty->GetSize()),
                                static_cast<uint32>(InProperty->GetMinAlignment()))) {
    Property->InitializeValue(Memory);
}

FTemporaryValue::~FTemporaryValue() {
    Property->DestroyValue(Memory);
    FMemory::Free(Memory);
}

std::string ExpectedTypeOf(const FTypePlan& Plan) {
    if (Plan.Kind == EValueKind::StaticArray) {
        return CppTypeOf(Plan.Property) + "[" + std::to_string(Plan.ArrayDim) + "]";
    }
    return Plan.Property ? CppTypeOf(Plan.Property) : CppNameOf(Plan.Struct);
}

// Errors
// --------------------------------------------------------------------------------------------------------------------

bool FValueReader::Fail(ErrorCode Code, std::string Message, std::string Expected) {
    Error = MakeError(Code, std::move(Message), std::string(Name), std::move(Expected));
    return false;
}

bool FValueReader::FailType(const FTypePlan& Plan, spear::TypeId Found) {
    const std::string Expected = ExpectedTypeOf(Plan);
    return Fail(ErrorCode::WrongType,
        Place() + " must be " + Expected + ", not " + DescribeType(Operation.Session->Tables(), Found), Expected);
}

bool FValueReader::FailMalformed() {
    return Fail(ErrorCode::MalformedMessage, Place() + " is malformed: its bytes end too early or name unknown types");
}

bool FValueReader::TakeMemory(std::size_t Bytes) {
    TakenBytes += Bytes;
    if (TakenBytes > spear::limits::max_decoded_bytes) {
        return Fail(ErrorCode::LimitExceeded, Place() + " would take more memory than limits::max_decoded_bytes = " +
                                                  std::to_string(spear::limits::max_decoded_bytes));
    }
    return true;
}

// Dispatch
// ------------------------------------------------------------------------------------------------------------------

bool FValueReader::ReadValue(const FTypePlan& Plan, void* Address, spear::Decoder& In) {
    const auto Type = In.get<spear::TypeId>();
    if (!In.ok()) {
        return FailMalformed();
    }
    if (Type != types::future) {
        return Read(Plan, Address, In, Type);
    }
    const spear::DecodeContext Context = Operation.DecodeContext();
    std::span<const std::byte> Bytes;
    if (!Context.resolve_future(Context.user, In.get<uint64>(), Bytes)) {
        Error = Operation.Error;
        Error.argument = std::string(Name);
        return false;
    }
    spear::Decoder Result(Bytes);
    const auto ResultType = Result.get<spear::TypeId>();
    return Result.ok() ? Read(Plan, Address, Result, ResultType) : FailMalformed();
}

bool FValueReader::Read(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    if (++Depth > spear::limits::max_value_depth) {
        return Fail(ErrorCode::LimitExceeded, Place() + " is nested deeper than limits::max_value_depth = " +
                                                  std::to_string(spear::limits::max_value_depth));
    }
    bool bOk = false;
    if (Type == types::any) {
        bOk = ReadValue(Plan, Address, In);
    } else {
        switch (Plan.Kind) {
        case EValueKind::Struct:
            bOk = ReadStruct(Plan, Address, In, Type);
            break;
        case EValueKind::Indirect:
            bOk = ReadStruct(*GetStructPlan(Plan.Struct), Address, In, Type);
            break;
        case EValueKind::StaticArray:
            bOk = ReadStaticArray(Plan, Address, In, Type);
            break;
        case EValueKind::Array:
            bOk = ReadArray(Plan, Address, In, Type);
            break;
        case EValueKind::Set:
            bOk = ReadSet(Plan, Address, In, Type);
            break;
        case EValueKind::Map:
            bOk = ReadMap(Plan, Address, In, Type);
            break;
        default:
            bOk = ReadScalar(Plan, Address, In, Type);
            break;
        }
    }
    --Depth;
    return bOk && !In.ok() ? FailMalformed() : bOk;
}

bool FValueReader::ReadScalar(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    switch (Plan.Kind) {
    case EValueKind::Number:
        return ReadNumber(Plan, Address, In, Type);
    case EValueKind::Bool:
        if (Type != types::boolean) {
            return FailType(Plan, Type);
        }
        CastFieldChecked<FBoolProperty>(Plan.Property)->SetPropertyValue(Address, In.get<uint8>() != 0);
        return true;
    case EValueKind::Enum:
        return ReadEnum(Plan, Address, In, Type);
    case EValueKind::Object:
        return ReadObject(Plan, Address, In, Type);
    case EValueKind::SoftObject:
        return ReadSoftObject(Plan, Address, In, Type);
    case EValueKind::Interface:
        return ReadInterface(Plan, Address, In, Type);
    case EValueKind::Delegate: {
        FScriptDelegate Delegate;
        if (!ReadDelegate(CastFieldChecked<FDelegateProperty>(Plan.Property)->SignatureFunction, Delegate, In, Type)) {
            return false;
        }
        *static_cast<FScriptDelegate*>(Address) = Delegate;
        return true;
    }
    case EValueKind::MulticastDelegate:
        return ReadMulticast(Plan, Address, In, Type);
    case EValueKind::Optional: {
        const FOptionalProperty* Property = CastFieldChecked<FOptionalProperty>(Plan.Property);
        if (Type == types::null) {
            Property->MarkUnset(Address);
            return true;
        }
        return Read(*Plan.Inner, Property->MarkSetAndGetInitializedValuePointerToReplace(Address), In, Type);
    }
    default:
        break;
    }

    // What is left are texts.
    if (Type != types::string) {
        return FailType(Plan, Type);
    }
    const std::string_view Text = In.get_text();
    switch (Plan.Kind) {
    case EValueKind::String:
        *static_cast<FString*>(Address) = FromUtf8(Text);
        return true;
    case EValueKind::Text:
        *static_cast<FText*>(Address) = FText::FromString(FromUtf8(Text));
        return true;
    case EValueKind::Name:
        if (!IsValidName(Text)) {
            return Fail(ErrorCode::OutOfRange,
                Place() + " is no valid name: names have less than " + std::to_string(NAME_SIZE) +
                    " characters and no zero byte",
                "FName");
        }
        *static_cast<FName*>(Address) = Text.empty() ? FName() : FName(*FromUtf8(Text));
        return true;
    default: {
        FStringOutputDevice Problems;
        if (!Plan.Property->ImportText_Direct(*FromUtf8(Text), Address, nullptr, PPF_None, &Problems)) {
            return Fail(ErrorCode::WrongType,
                Place() + " is no text of a " + ExpectedTypeOf(Plan) + ": " + ToUtf8(Problems), ExpectedTypeOf(Plan));
        }
        return true;
    }
    }
}

bool FValueReader::ReadNumber(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    const auto ReadAs = [&](auto Zero) {
        decltype(Zero) Value = Zero;
        const spear::CodecError Code = spear::decode_number(In, Type, Value);
        if (Code == spear::CodecError::none) {
            FMemory::Memcpy(Address, &Value, sizeof(Value));
        }
        return Code;
    };
    spear::CodecError Code = spear::CodecError::wrong_type;
    const spear::TypeInfo* Info = Operation.Session->Tables().find(Type);
    if (const FNumericProperty* Numeric = CastField<FNumericProperty>(Plan.Property);
        Info && Info->kind == spear::TypeKind::enumeration && Numeric && Numeric->IsInteger()) {
        const auto Value = In.get<int64>(); // an enum's entry as a mere number
        if (!Numeric->CanHoldValue(Value)) {
            return Fail(ErrorCode::OutOfRange, Place() + " is outside the range of " + ExpectedTypeOf(Plan),
                ExpectedTypeOf(Plan));
        }
        Numeric->SetIntPropertyValue(Address, Value);
        return true;
    }
    switch (Plan.Builtin) {
    case types::i8:
        Code = ReadAs(int8{});
        break;
    case types::i16:
        Code = ReadAs(int16{});
        break;
    case types::i32:
        Code = ReadAs(int32{});
        break;
    case types::i64:
        Code = ReadAs(int64{});
        break;
    case types::u8:
        Code = ReadAs(uint8{});
        break;
    case types::u16:
        Code = ReadAs(uint16{});
        break;
    case types::u32:
        Code = ReadAs(uint32{});
        break;
    case types::u64:
        Code = ReadAs(uint64{});
        break;
    case types::f32:
        Code = ReadAs(float{});
        break;
    case types::f64:
        Code = ReadAs(double{});
        break;
    default:
        break;
    }
    if (Code == spear::CodecError::out_of_range) {
        return Fail(
            ErrorCode::OutOfRange, Place() + " is outside the range of " + ExpectedTypeOf(Plan), ExpectedTypeOf(Plan));
    }
    return Code == spear::CodecError::none || FailType(Plan, Type);
}

bool FValueReader::ReadEnum(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    const std::string Expected = ToUtf8(Plan.Enum->GetName());
    const FNumericProperty* Underlying = nullptr;
    if (const FEnumProperty* EnumProperty = CastField<FEnumProperty>(Plan.Property)) {
        Underlying = EnumProperty->GetUnderlyingProperty();
    } else {
        Underlying = CastFieldChecked<FByteProperty>(Plan.Property);
    }

    int64 Value = 0;
    const spear::TypeInfo* Info = Operation.Session->Tables().find(Type);
    if (Type == types::string) {
        const std::string Text(In.get_text());
        FNearestNames Nearest(Text);
        bool bFound = false;
        for (int32 Index = 0; Index < Plan.Enum->NumEnums() && !bFound; ++Index) {
            const std::string Full = ToUtf8(Plan.Enum->GetNameByIndex(Index));
            const std::string Short = ShortNameOfEntry(Plan.Enum, Index);
            if (EqualsWithoutCase(Text, Full) || EqualsWithoutCase(Text, Short)) {
                Value = Plan.Enum->GetValueByIndex(Index);
                bFound = true;
            }
            Nearest.Add(Short);
        }
        if (!bFound) {
            return Fail(ErrorCode::OutOfRange,
                Place() + ": " + Expected + " has no entry '" + Text + "'" + Nearest.Suggestion(), Expected);
        }
    } else {
        if (Info && Info->kind == spear::TypeKind::enumeration) {
            if (!EqualsWithoutCase(Info->name, Expected)) {
                return FailType(Plan, Type);
            }
            if (!ConvertEnum(Plan, Type, *Info, In.get<int64>(), Value)) {
                return false;
            }
        } else if (const spear::CodecError Code = spear::decode_number(In, Type, Value);
            Code == spear::CodecError::out_of_range) {
            return Fail(ErrorCode::OutOfRange, Place() + " is outside the range of " + Expected, Expected);
        } else if (Code != spear::CodecError::none) {
            return FailType(Plan, Type);
        }
        const bool bFlags = Plan.Enum->HasAnyEnumFlags(EEnumFlags::Flags);
        if (!(bFlags ? Underlying->CanHoldValue(Value) : Plan.Enum->IsValidEnumValue(Value))) {
            return Fail(ErrorCode::OutOfRange, Place() + ": " + std::to_string(Value) + " is no value of " + Expected,
                Expected);
        }
    }
    Underlying->SetIntPropertyValue(Address, Value);
    return true;
}

bool FValueReader::ConvertEnum(
    const FTypePlan& Plan, spear::TypeId Type, const spear::TypeInfo& Info, int64 From, int64& To) {
    FEnumConversions& Conversions = Operation.Session->EnumConversions;
    const uint64 Key = (static_cast<uint64>(Type) << 32) | Plan.Index;
    auto At = Conversions.find(Key);
    if (At == Conversions.end()) {
        At = Conversions.emplace(Key, FEnumConversion()).first;
        bool bSame = true;
        for (const spear::EnumEntry& Entry : Info.entries) {
            FEnumConversion::FEntry& Added = At->second.Entries.emplace_back();
            Added.Name = Entry.name;
            Added.From = Entry.value;
            for (int32 Index = 0; Index < Plan.Enum->NumEnums() && !Added.bKnown; ++Index) {
                if (EqualsWithoutCase(Entry.name, ShortNameOfEntry(Plan.Enum, Index))) {
                    Added.To = Plan.Enum->GetValueByIndex(Index);
                    Added.bKnown = true;
                }
            }
            bSame = bSame && Added.bKnown && Added.From == Added.To;
        }
        if (bSame) {
            At->second.Entries.clear();
        }
    }
    const std::vector<FEnumConversion::FEntry>& Entries = At->second.Entries;
    To = From;
    if (Entries.empty()) {
        return true;
    }
    const std::string Expected = ToUtf8(Plan.Enum->GetName());
    const FEnumConversion::FEntry* Unknown = nullptr;
    for (const FEnumConversion::FEntry& Entry : Entries) {
        if (Entry.From == From && Entry.bKnown) {
            To = Entry.To;
            return true;
        }
        Unknown = Entry.From == From && !Unknown ? &Entry : Unknown;
    }
    if (Plan.Enum->HasAnyEnumFlags(EEnumFlags::Flags) && !Unknown) {
        To = 0;
        int64 Left = From;
        for (const FEnumConversion::FEntry& Entry : Entries) {
            const bool bOneBit =
                Entry.From != 0 && (static_cast<uint64>(Entry.From) & (static_cast<uint64>(Entry.From) - 1)) == 0;
            if (bOneBit && (Left & Entry.From) != 0) {
                if (!Entry.bKnown) {
                    Unknown = &Entry;
                    break;
                }
                To |= Entry.To;
                Left &= ~Entry.From;
            }
        }
        if (!Unknown && Left == 0) {
            return true;
        }
    }
    if (Unknown) {
        FNearestNames Nearest(Unknown->Name);
        for (int32 Index = 0; Index < Plan.Enum->NumEnums(); ++Index) {
            Nearest.Add(ShortNameOfEntry(Plan.Enum, Index));
        }
        return Fail(ErrorCode::OutOfRange,
            Place() + ": this engine's " + Expected + " has no entry '" + Unknown->Name + "'" + Nearest.Suggestion(),
            Expected);
    }
    return Fail(ErrorCode::OutOfRange,
        Place() + ": the sender's " + Expected + " has other numbers than this engine's, and " + std::to_string(From) +
            " is none of its entries",
        Expected);
}

// References
// ----------------------------------------------------------------------------------------------------------------

bool FValueReader::ReadObjectReference(
    const FTypePlan& Plan, UObject*& Object, spear::Decoder& In, spear::TypeId Type, bool bClassNames) {
    Object = nullptr;
    if (Type == types::null) {
        return true;
    }
    if (Type == types::string && bClassNames) {
        TSpearResult<UClass*> Class = FindClassByName(In.get_text());
        if (!Class.IsOk()) {
            return Fail(Class.GetError().code, Place() + ": " + Class.GetError().message, ExpectedTypeOf(Plan));
        }
        Object = Class.GetValue();
        return true;
    }
    if (Type != types::object && Type != types::handle) {
        return FailType(Plan, Type);
    }
    const auto Handle = In.get<uint64>();
    if (Type == types::object) {
        (void)In.get<spear::TypeId>();
    }
    TSpearResult<UObject*> Resolved = Operation.Session->Handles.Resolve(Handle);
    if (!Resolved.IsOk()) {
        return Fail(Resolved.GetError().code, Place() + ": " + Resolved.GetError().message, ExpectedTypeOf(Plan));
    }
    Object = Resolved.GetValue();
    return true;
}

bool FValueReader::ReadObject(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    const FObjectPropertyBase* Property = CastFieldChecked<FObjectPropertyBase>(Plan.Property);
    const FClassProperty* ClassProperty = CastField<FClassProperty>(Plan.Property);
    UObject* Object = nullptr;
    if (!ReadObjectReference(Plan, Object, In, Type, ClassProperty != nullptr)) {
        return false;
    }
    if (Object) {
        const UClass* AsClass = Cast<UClass>(Object);
        const bool bFits = ClassProperty
                               ? AsClass && (!ClassProperty->MetaClass || AsClass->IsChildOf(ClassProperty->MetaClass))
                               : Object->IsA(Property->PropertyClass);
        if (!bFits) {
            const std::string Expected = ExpectedTypeOf(Plan);
            return Fail(ErrorCode::WrongType,
                Place() + " must be " + Expected + ", not " +
                    (AsClass ? "the class " + CppNameOf(AsClass)
                             : "the " + CppNameOf(Object->GetClass()) + " '" + ToUtf8(Object->GetName()) + "'"),
                Expected);
        }
    }
    Property->SetObjectPropertyValue(Address, Object);
    return true;
}

bool FValueReader::ReadSoftObject(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    const FSoftObjectProperty* Property = CastFieldChecked<FSoftObjectProperty>(Plan.Property);
    const FSoftClassProperty* ClassProperty = CastField<FSoftClassProperty>(Plan.Property);
    FSoftObjectPtr& Pointer = *static_cast<FSoftObjectPtr*>(Address);
    if (Type == types::string) {
        const std::string_view Path = In.get_text();
        if (Path.empty() || Path == "None") {
            Pointer = FSoftObjectPtr();
            return true;
        }
        if (Path[0] != '/' || Path.find('\0') != std::string_view::npos || Path.size() >= NAME_SIZE) {
            return Fail(ErrorCode::OutOfRange,
                Place() + ": '" + std::string(Path.substr(0, 200)) +
                    "' is no object path; paths look like \"/Game/Folder/Asset.Asset\"",
                ExpectedTypeOf(Plan));
        }
        Pointer = FSoftObjectPtr(FSoftObjectPath(FromUtf8(Path)));
        return true;
    }
    UObject* Object = nullptr;
    if (!ReadObjectReference(Plan, Object, In, Type, false)) {
        return false;
    }
    if (Object) {
        const UClass* AsClass = Cast<UClass>(Object);
        const bool bFits = ClassProperty
                               ? AsClass && (!ClassProperty->MetaClass || AsClass->IsChildOf(ClassProperty->MetaClass))
                               : Object->IsA(Property->PropertyClass);
        if (!bFits) {
            return Fail(ErrorCode::WrongType,
                Place() + " must be " + ExpectedTypeOf(Plan) + ", not '" + ToUtf8(Object->GetPathName()) + "'",
                ExpectedTypeOf(Plan));
        }
    }
    Pointer = FSoftObjectPtr(Object);
    return true;
}

bool FValueReader::ReadInterface(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    const FInterfaceProperty* Property = CastFieldChecked<FInterfaceProperty>(Plan.Property);
    UObject* Object = nullptr;
    if (!ReadObjectReference(Plan, Object, In, Type, false)) {
        return false;
    }
    if (Object && !Object->GetClass()->ImplementsInterface(Property->InterfaceClass)) {
        return Fail(ErrorCode::WrongType,
            Place() + " must implement " + CppNameOf(Property->InterfaceClass) + "; the " +
                CppNameOf(Object->GetClass()) + " '" + ToUtf8(Object->GetName()) + "' does not",
            ExpectedTypeOf(Plan));
    }
    FScriptInterface& Interface = *static_cast<FScriptInterface*>(Address);
    Interface.SetObject(Object);
    Interface.SetInterface(Object ? Object->GetInterfaceAddress(Property->InterfaceClass) : nullptr);
    return true;
}

} // namespace SpearServer
