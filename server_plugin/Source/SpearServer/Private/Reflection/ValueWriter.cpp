// SPDX-License-Identifier: MIT
#include "Reflection/ValueWriter.h"

#include "SpearText.h"

#include "Frame/Session.h"
#include "Reflection/DelegateAccess.h"

#include "UObject/EnumProperty.h"
#include "UObject/PropertyOptional.h"
#include "UObject/TextProperty.h"

#include "spear/limits.hpp"

namespace SpearServer {

namespace {

class FValueWriter {
public:
    FValueWriter(FSession& InSession, spear::Encoder& InOut) : Session(InSession), Out(InOut) {}

    bool Write(const FTypePlan& Plan, const void* Address, std::size_t Depth) {
        if (Depth > spear::limits::max_value_depth) {
            return Fail("a value nested deeper than limits::max_value_depth = " +
                        std::to_string(spear::limits::max_value_depth));
        }
        if (Out.buffer.size() > spear::limits::max_message_bytes) {
            return Fail("a value larger than limits::max_message_bytes = " +
                        std::to_string(spear::limits::max_message_bytes) + "; read it in parts");
        }
        const uint8* Bytes = static_cast<const uint8*>(Address);
        switch (Plan.Kind) {
        case EValueKind::Number:
            Out.put_raw(Address, static_cast<std::size_t>(Plan.Size));
            return true;
        case EValueKind::Bool:
            Out.put(static_cast<uint8>(CastFieldChecked<FBoolProperty>(Plan.Property)->GetPropertyValue(Address)));
            return true;
        case EValueKind::Enum:
            Out.put(ReadEnum(Plan, Address));
            return true;
        case EValueKind::String:
            return WriteText(*static_cast<const FString*>(Address));
        case EValueKind::Name:
            return WriteText(static_cast<const FName*>(Address)->ToString());
        case EValueKind::Text:
            return WriteText(static_cast<const FText*>(Address)->ToString());
        case EValueKind::Object:
            WriteObject(CastFieldChecked<FObjectPropertyBase>(Plan.Property)->GetObjectPropertyValue(Address));
            return true;
        case EValueKind::SoftObject:
            return WriteText(static_cast<const FSoftObjectPtr*>(Address)->ToSoftObjectPath().ToString());
        case EValueKind::Interface:
            WriteObject(static_cast<const FScriptInterface*>(Address)->GetObject());
            return true;
        case EValueKind::Struct:
            if (Plan.bRaw) {
                for (const FTypePlan::FRun& Run : Plan.Runs) {
                    Out.put_raw(Bytes + Run.Offset, static_cast<std::size_t>(Run.Size));
                }
                return true;
            }
            for (const FTypePlan::FField& Field : Plan.Fields) {
                if (!Write(*Field.Plan, Bytes + Field.Offset, Depth + 1)) {
                    return false;
                }
            }
            return true;
        case EValueKind::StaticArray:
            return WriteElements(*Plan.Inner, Bytes, Plan.ArrayDim, Plan.Inner->Size, Depth);
        case EValueKind::Array: {
            FScriptArrayHelper Helper(CastFieldChecked<FArrayProperty>(Plan.Property), Address);
            return WriteElements(
                *Plan.Inner, Helper.Num() ? Helper.GetRawPtr(0) : nullptr, Helper.Num(), Plan.Inner->Size, Depth);
        }
        case EValueKind::Set: {
            FScriptSetHelper Helper(CastFieldChecked<FSetProperty>(Plan.Property), Address);
            Out.put(static_cast<uint32>(Helper.Num()));
            for (int32 Index = 0; Index < Helper.GetMaxIndex(); ++Index) {
                if (Helper.IsValidIndex(Index) && !Write(*Plan.Inner, Helper.GetElementPtr(Index), Depth + 1)) {
                    return false;
                }
            }
            return true;
        }
        case EValueKind::Map: {
            FScriptMapHelper Helper(CastFieldChecked<FMapProperty>(Plan.Property), Address);
            Out.put(static_cast<uint32>(Helper.Num()));
            for (int32 Index = 0; Index < Helper.GetMaxIndex(); ++Index) {
                if (Helper.IsValidIndex(Index) && !(Write(*Plan.Key, Helper.GetKeyPtr(Index), Depth + 1) &&
                                                      Write(*Plan.Inner, Helper.GetValuePtr(Index), Depth + 1))) {
                    return false;
                }
            }
            return true;
        }
        case EValueKind::Optional: {
            const FOptionalProperty* Property = CastFieldChecked<FOptionalProperty>(Plan.Property);
            if (!Property->IsSet(Address)) {
                Out.put(spear::types::null);
                return true;
            }
            Out.put(Session.TypeNumbers.NumberOf(*Plan.Inner));
            return Write(*Plan.Inner, Property->GetValuePointerForRead(Address), Depth + 1);
        }
        case EValueKind::Delegate:
            WriteDelegate(*static_cast<const FScriptDelegate*>(Address));
            return true;
        case EValueKind::MulticastDelegate: {
            const FMulticastScriptDelegate* Delegate =
                CastFieldChecked<FMulticastDelegateProperty>(Plan.Property)->GetMulticastDelegate(Address);
            const std::size_t CountAt = Out.reserve<uint32>();
            uint32 Count = 0;
            if (Delegate) {
                ForEachBinding(*Delegate, [&](const FScriptDelegate& Binding) {
                    WriteDelegate(Binding);
                    ++Count;
                });
            }
            Out.patch(CountAt, Count);
            return true;
        }
        case EValueKind::Indirect: {
            const FTypePlanRef Struct = GetStructPlan(Plan.Struct);
            Out.put(Session.TypeNumbers.NumberOf(*Struct));
            return Write(*Struct, Address, Depth + 1);
        }
        case EValueKind::Exported: {
            FString Text;
            Plan.Property->ExportTextItem_Direct(Text, Address, nullptr, nullptr, PPF_None);
            return WriteText(Text);
        }
        }
        return true;
    }

    ErrorInfo Error;

private:
    static int64 ReadEnum(const FTypePlan& Plan, const void* Address) {
        if (const FEnumProperty* EnumProperty = CastField<FEnumProperty>(Plan.Property)) {
            return EnumProperty->GetUnderlyingProperty()->GetSignedIntPropertyValue(Address);
        }
        return *static_cast<const uint8*>(Address);
    }
    bool WriteElements(const FTypePlan& Inner, const uint8* First, int32 Count, int32 Stride, std::size_t Depth) {
        Out.put(static_cast<uint32>(Count));
        if (Inner.IsOneRun()) {
            Out.put_raw(First, static_cast<std::size_t>(Count) * static_cast<std::size_t>(Stride));
            return true;
        }
        for (int32 Index = 0; Index < Count; ++Index) {
            if (!Write(Inner, First + static_cast<std::ptrdiff_t>(Index) * Stride, Depth + 1)) {
                return false;
            }
        }
        return true;
    }
    void WriteObject(const UObject* Object) {
        const spear::ObjectRef Reference = ReferTo(Session, Object);
        Out.put(Reference.handle);
        Out.put(Reference.class_type);
    }
    void WriteDelegate(const FScriptDelegate& Delegate) {
        const UObject* Object = Delegate.GetUObject();
        WriteObject(Object);
        Out.put_text(Object ? ToUtf8(Delegate.GetFunctionName()) : std::string());
    }
    bool WriteText(const FString& Text) {
        const std::string Utf8 = ToUtf8(Text);
        if (Utf8.size() > spear::limits::max_string_bytes) {
            return Fail(
                "a text longer than limits::max_string_bytes = " + std::to_string(spear::limits::max_string_bytes));
        }
        Out.put_text(Utf8);
        return true;
    }
    bool Fail(std::string What) {
        Error = MakeError(ErrorCode::LimitExceeded, "the result is " + What);
        return false;
    }

    FSession& Session;
    spear::Encoder& Out;
};

} // namespace

spear::ObjectRef ReferTo(FSession& Session, const UObject* Object) {
    if (!Object) {
        return {};
    }
    return {Session.Handles.HandleOf(Object), Session.TypeNumbers.NumberOf(Object->GetClass())};
}

FStatus WritePayload(
    FSession& Session, const FTypePlan& Plan, const void* Address, spear::Encoder& Out, std::size_t Depth) {
    FValueWriter Writer(Session, Out);
    if (!Writer.Write(Plan, Address, Depth)) {
        return std::move(Writer.Error);
    }
    return {};
}

FStatus WriteValue(FSession& Session, const FTypePlan& Plan, const void* Address, spear::Encoder& Out) {
    // `any` begins with the number of what is inside; it has none of its own outside of structs and containers.
    if (const spear::TypeId Number = Session.TypeNumbers.NumberOf(Plan); Number != spear::types::any) {
        Out.put(Number);
    }
    return WritePayload(Session, Plan, Address, Out);
}

} // namespace SpearServer
