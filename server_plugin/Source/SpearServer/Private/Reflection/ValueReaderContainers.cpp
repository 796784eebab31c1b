// SPDX-License-Identifier: MIT
#include "Reflection/ValueReader.h"

#include "SpearText.h"

#include "Frame/Session.h"
#include "Reflection/NearestNames.h"

#include "spear/limits.hpp"

namespace SpearServer {

namespace types = spear::types;

// Structs
// -------------------------------------------------------------------------------------------------------------------

namespace {

const FTypePlan::FField* FindField(const FTypePlan& Plan, std::string_view Name) {
    for (const FTypePlan::FField& Field : Plan.Fields) {
        if (EqualsWithoutCase(Field.Name, Name)) {
            return &Field;
        }
    }
    return nullptr;
}

/// Whether payloads of the wire type are numbers that can be copied to where the plan's numbers lie; adds the copies.
bool FlattenNumbers(const spear::TypeTables& Tables, spear::TypeId Type, const FTypePlan& Plan, int32 To,
    FStructConversion& Conversion) {
    if (Plan.Kind == EValueKind::Number) {
        if (Type != Plan.Builtin) {
            return false;
        }
        const int32 From = Conversion.PayloadBytes;
        Conversion.PayloadBytes += Plan.Size;
        if (!Conversion.Copies.empty()) {
            FStructConversion::FCopy& Last = Conversion.Copies.back();
            if (Last.From + Last.Size == From && Last.To + Last.Size == To) {
                Last.Size += Plan.Size;
                return true;
            }
        }
        Conversion.Copies.push_back({From, To, Plan.Size});
        return true;
    }
    const spear::TypeInfo* Info = Tables.find(Type);
    if (Plan.Kind != EValueKind::Struct || !Info || Info->kind != spear::TypeKind::structure) {
        return false;
    }
    for (const spear::FieldInfo& Field : Info->fields) {
        const FTypePlan::FField* Target = FindField(Plan, Field.name);
        if (!Target || !FlattenNumbers(Tables, Field.type, *Target->Plan, To + Target->Offset, Conversion)) {
            return false;
        }
    }
    return true;
}

void ApplyCopies(const FStructConversion& Conversion, const std::byte* From, void* To) {
    for (const FStructConversion::FCopy& Copy : Conversion.Copies) {
        FMemory::Memcpy(static_cast<uint8*>(To) + Copy.To, From + Copy.From, static_cast<SIZE_T>(Copy.Size));
    }
}

} // namespace

const FStructConversion& FValueReader::ConversionOf(
    const FTypePlan& Plan, spear::TypeId Type, const spear::TypeInfo& Info) {
    std::unique_ptr<FStructConversion>& Cached =
        Operation.Session->Conversions[(static_cast<uint64>(Type) << 32) | Plan.Index];
    if (!Cached) {
        Cached = std::make_unique<FStructConversion>();
        Cached->Plan = GetStructPlan(Plan.Struct);
        for (const spear::FieldInfo& Field : Info.fields) {
            const FTypePlan::FField* Target = FindField(*Cached->Plan, Field.name);
            if (!Target) {
                Cached->UnknownField = Field.name;
                break;
            }
            Cached->Fields.push_back({Target, Field.type});
        }
        Cached->bDirect = Cached->UnknownField.empty() &&
                          FlattenNumbers(Operation.Session->Tables(), Type, *Cached->Plan, 0, *Cached);
    }
    return *Cached;
}

bool FValueReader::ReadStruct(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    uint8* Bytes = static_cast<uint8*>(Address);
    const auto FailField = [&](std::string_view Field) {
        FNearestNames Nearest(Field);
        for (const FTypePlan::FField& Known : Plan.Fields) {
            Nearest.Add(Known.Name);
        }
        return Fail(ErrorCode::WrongType,
            Place() + ": " + CppNameOf(Plan.Struct) + " has no member '" + std::string(Field) + "'" +
                Nearest.Suggestion(),
            CppNameOf(Plan.Struct));
    };
    const auto ReadField = [&](const FTypePlan::FField& Field, spear::TypeId FieldType) {
        const std::size_t Length = Where.size();
        Where += "." + Field.Name;
        const bool bOk = Read(*Field.Plan, Bytes + Field.Offset, In, FieldType);
        Where.resize(Length);
        return bOk;
    };

    if (Type == types::dict) {
        for (uint32 Left = In.get_count(8); Left != 0 && In.ok(); --Left) {
            const std::string_view Key = In.get_text();
            const FTypePlan::FField* Field = FindField(Plan, Key);
            if (!In.ok()) {
                return FailMalformed();
            }
            if (!Field) {
                return FailField(Key);
            }
            if (!ReadField(*Field, types::any)) {
                return false;
            }
        }
        return true;
    }
    const spear::TypeInfo* Info = Operation.Session->Tables().find(Type);
    if (Type == types::list || (Info && Info->kind == spear::TypeKind::array)) {
        spear::TypeId ElementType = types::any;
        uint32 Count = 0;
        if (!ReadCount(Plan, In, Type, ElementType, Count)) {
            return false;
        }
        if (Count != Plan.Fields.size()) {
            return Fail(ErrorCode::WrongType,
                Place() + ": a list for " + CppNameOf(Plan.Struct) + " needs all " +
                    std::to_string(Plan.Fields.size()) + " members in order, not " + std::to_string(Count),
                CppNameOf(Plan.Struct));
        }
        for (const FTypePlan::FField& Field : Plan.Fields) {
            if (!ReadField(Field, ElementType)) {
                return false;
            }
        }
        return true;
    }
    if (!Info || Info->kind != spear::TypeKind::structure) {
        return FailType(Plan, Type);
    }
    const FStructConversion& Conversion = ConversionOf(Plan, Type, *Info);
    if (!Conversion.UnknownField.empty()) {
        return FailField(Conversion.UnknownField);
    }
    if (Conversion.bDirect) {
        const std::span<const std::byte> Payload = In.get_raw(static_cast<std::size_t>(Conversion.PayloadBytes));
        if (!In.ok()) {
            return FailMalformed();
        }
        ApplyCopies(Conversion, Payload.data(), Address);
        return true;
    }
    for (const FStructConversion::FField& Field : Conversion.Fields) {
        if (!ReadField(*Field.Target, Field.Type)) {
            return false;
        }
    }
    return true;
}

// Containers
// ----------------------------------------------------------------------------------------------------------------

bool FValueReader::ReadCount(
    const FTypePlan& Plan, spear::Decoder& In, spear::TypeId Type, spear::TypeId& ElementType, uint32& Count) {
    if (Type == types::list) {
        ElementType = types::any;
        Count = In.get_count(4);
    } else {
        const spear::TypeInfo* Info = Operation.Session->Tables().find(Type);
        if (!Info || (Info->kind != spear::TypeKind::array && Info->kind != spear::TypeKind::set)) {
            return FailType(Plan, Type);
        }
        ElementType = Info->element;
        Count = In.get_count(1);
    }
    return In.ok() || FailMalformed();
}

bool FValueReader::ReadElement(
    const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId ElementType, uint32 Index) {
    const std::size_t Length = Where.size();
    Where += "[" + std::to_string(Index) + "]";
    const bool bOk = Read(Plan, Address, In, ElementType);
    Where.resize(Length);
    return bOk;
}

bool FValueReader::ReadStaticArray(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    spear::TypeId ElementType = types::any;
    uint32 Count = 0;
    if (!ReadCount(Plan, In, Type, ElementType, Count)) {
        return false;
    }
    if (Count != static_cast<uint32>(Plan.ArrayDim)) {
        return Fail(ErrorCode::OutOfRange,
            Place() + " must have exactly " + std::to_string(Plan.ArrayDim) + " elements, not " + std::to_string(Count),
            ExpectedTypeOf(Plan));
    }
    for (uint32 Index = 0; Index < Count; ++Index) {
        void* Element =
            static_cast<uint8*>(Address) + static_cast<std::size_t>(Index) * static_cast<std::size_t>(Plan.Inner->Size);
        if (!ReadElement(*Plan.Inner, Element, In, ElementType, Index)) {
            return false;
        }
    }
    return true;
}

bool FValueReader::ReadArray(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    FScriptArrayHelper Helper(CastFieldChecked<FArrayProperty>(Plan.Property), Address);
    const FTypePlan& Inner = *Plan.Inner;
    const std::size_t Stride = static_cast<std::size_t>(Inner.Size);

    /// Fills the array with Count elements that lie in the message as they lie in memory.
    const auto CopyAll = [&](std::size_t Count) {
        const std::span<const std::byte> Raw = In.get_raw(Count * Stride);
        if (!In.ok()) {
            return FailMalformed();
        }
        if (!TakeMemory(Raw.size())) {
            return false;
        }
        Helper.EmptyValues();
        Helper.AddValues(static_cast<int32>(Count));
        if (Count != 0) {
            FMemory::Memcpy(Helper.GetRawPtr(0), Raw.data(), Raw.size());
        }
        return true;
    };
    if (Type == types::bytes && (Inner.Builtin == types::u8 || Inner.Builtin == types::i8)) {
        return CopyAll(In.get<uint32>());
    }

    spear::TypeId ElementType = types::any;
    uint32 Count = 0;
    if (!ReadCount(Plan, In, Type, ElementType, Count)) {
        return false;
    }
    if (Inner.Kind == EValueKind::Number && ElementType == Inner.Builtin) {
        return CopyAll(Count);
    }
    const spear::TypeInfo* Info = Operation.Session->Tables().find(ElementType);
    const FStructConversion* Conversion = nullptr;
    if (Inner.Kind == EValueKind::Struct && Info && Info->kind == spear::TypeKind::structure) {
        Conversion = &ConversionOf(Inner, ElementType, *Info);
        if (Conversion->bDirect && Conversion->Copies.size() == 1 && Conversion->Copies[0].To == 0 &&
            static_cast<std::size_t>(Conversion->PayloadBytes) == Stride &&
            Conversion->Copies[0].Size == Conversion->PayloadBytes) {
            return CopyAll(Count);
        }
    }
    if (!TakeMemory(static_cast<std::size_t>(Count) * Stride)) {
        return false;
    }
    Helper.EmptyValues();
    Helper.AddValues(static_cast<int32>(Count));
    for (uint32 Index = 0; Index < Count; ++Index) {
        if (!ReadElement(Inner, Helper.GetRawPtr(static_cast<int32>(Index)), In, ElementType, Index)) {
            return false;
        }
    }
    return true;
}

bool FValueReader::ReadSet(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    const FSetProperty* Property = CastFieldChecked<FSetProperty>(Plan.Property);
    FScriptSetHelper Helper(Property, Address);
    spear::TypeId ElementType = types::any;
    uint32 Count = 0;
    if (!ReadCount(Plan, In, Type, ElementType, Count)) {
        return false;
    }
    if (!TakeMemory(static_cast<std::size_t>(Count) * (static_cast<std::size_t>(Plan.Inner->Size) + 8))) {
        return false;
    }
    Helper.EmptyElements();
    for (uint32 Index = 0; Index < Count; ++Index) {
        const FTemporaryValue Element(Property->ElementProp);
        if (!ReadElement(*Plan.Inner, Element.Get(), In, ElementType, Index)) {
            return false;
        }
        Helper.AddElement(Element.Get());
    }
    return true;
}

bool FValueReader::ReadMap(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type) {
    const FMapProperty* Property = CastFieldChecked<FMapProperty>(Plan.Property);
    FScriptMapHelper Helper(Property, Address);
    spear::TypeId KeyType = types::any;
    spear::TypeId ValueType = types::any;
    uint32 Count = 0;
    if (Type == types::dict || Type == types::map) {
        Count = In.get_count(8);
    } else {
        const spear::TypeInfo* Info = Operation.Session->Tables().find(Type);
        if (!Info || Info->kind != spear::TypeKind::map) {
            return FailType(Plan, Type);
        }
        KeyType = Info->key;
        ValueType = Info->element;
        Count = In.get_count(1);
    }
    if (!In.ok()) {
        return FailMalformed();
    }
    if (!TakeMemory(
            static_cast<std::size_t>(Count) * (static_cast<std::size_t>(Plan.Inner->Size + Plan.Key->Size) + 8))) {
        return false;
    }
    Helper.EmptyValues();
    for (uint32 Index = 0; Index < Count; ++Index) {
        const FTemporaryValue Key(Property->KeyProp);
        const FTemporaryValue Value(Property->ValueProp);
        const std::size_t Length = Where.size();
        Where += "[key " + std::to_string(Index) + "]";
        // The keys of a dict are strings without a type number: read as such, so that they fit names and enums too.
        const bool bKey = Read(*Plan.Key, Key.Get(), In, Type == types::dict ? types::string : KeyType);
        Where.resize(Length);
        if (!bKey || !ReadElement(*Plan.Inner, Value.Get(), In, ValueType, Index)) {
            return false;
        }
        Helper.AddPair(Key.Get(), Value.Get());
    }
    return true;
}

} // namespace SpearServer
