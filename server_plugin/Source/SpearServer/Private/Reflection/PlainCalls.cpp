// SPDX-License-Identifier: MIT
#include "Reflection/PlainCalls.h"

#include "Frame/Session.h"

#include "UObject/Script.h"

#include <cstring>

namespace SpearServer {

namespace {

/// An object and a shape as values, with which the arguments of unreal_service.call_function begin.
struct FCallHead {
    uint64 Handle = 0;
    spear::TypeId Shape = 0;
    std::size_t Bytes = 0; ///< 0: it is not of that form

    explicit FCallHead(std::span<const std::byte> Arguments) {
        constexpr std::size_t TagBytes = sizeof(spear::TypeId);
        if (Arguments.size() < 24) {
            return;
        }
        const std::byte* const At = Arguments.data();
        spear::TypeId Tag = 0;
        std::memcpy(&Tag, At, TagBytes);
        const std::size_t ShapeAt = TagBytes + (Tag == spear::types::handle ? 8 : 12);
        spear::TypeId ShapeTag = 0;
        std::memcpy(&ShapeTag, At + ShapeAt, TagBytes);
        if ((Tag == spear::types::handle || Tag == spear::types::object) && ShapeTag == spear::types::u32) {
            std::memcpy(&Handle, At + TagBytes, sizeof(Handle));
            std::memcpy(&Shape, At + ShapeAt + TagBytes, sizeof(Shape));
            Bytes = ShapeAt + 2 * TagBytes;
        }
    }
};

/// Most values are a few numbers of eight bytes, for which a call of memcpy is a detour.
void CopyBytes(void* To, const void* From, uint32 Size) {
    if (Size == 24) {
        std::memcpy(To, From, 24);
    } else if (Size == 8) {
        std::memcpy(To, From, 8);
    } else {
        std::memcpy(To, From, Size);
    }
}

constexpr int32 MostTries = 8;

} // namespace

FPlainCalls::FReady FPlainCalls::Find(const FSession& Session, std::span<const std::byte> Arguments) {
    if (Epoch != GarbageEpoch) {
        Entries.fill({});
        Epoch = GarbageEpoch;
        return {};
    }
    const FCallHead Head(Arguments);
    if (Head.Bytes == 0) {
        return {};
    }
    UObject* const Object = Session.Handles.ResolveAgain(Head.Handle);
    if (!Object) {
        return {};
    }
    const UClass* const Class = Object->GetClass();
    const FEntry& Entry = Entries[IndexOf(Class, Head.Shape)];
    if (Entry.Class != Class || Entry.Shape != Head.Shape) {
        return {};
    }
    const FPlainCall& Plain = *Entry.Plain;
    const std::byte* const Values = Arguments.data() + Head.Bytes;
    if (Arguments.size() - Head.Bytes != Plain.ValueBytes) {
        return {};
    }
    for (const FPlainCall::FTag& Tag : Plain.Tags) {
        if (std::memcmp(Values + Tag.At, &Tag.Type, sizeof(Tag.Type)) != 0) {
            return {};
        }
    }
    return {Object, &Plain, Values};
}

void FPlainCalls::Make(const FReady& Ready, std::byte* To) {
    const FPlainCall& Plain = *Ready.Plain;
    alignas(16) uint8 Parameters[MostParameterBytes];
    for (uint32 At = 0; At < Plain.ParameterBytes; At += 16) {
        std::memset(Parameters + At, 0, 16);
    }
    for (const FPlainCall::FCopy& Copy : Plain.In) {
        CopyBytes(Parameters + Copy.To, Ready.Values + Copy.From, Copy.Size);
    }
    {
#if WITH_EDITOR
        const TGuardValue<bool> AllowScript(GAllowActorScriptExecutionInEditor, true);
#endif
        Ready.Object->ProcessEvent(Plain.Function, Parameters);
    }
    if (To) {
        std::memcpy(To, &Plain.ResultType, sizeof(spear::TypeId));
        for (const FPlainCall::FCopy& Copy : Plain.Out) {
            CopyBytes(To + sizeof(spear::TypeId) + Copy.To, Parameters + Copy.From, Copy.Size);
        }
    }
}

bool FPlainCalls::Describe(
    FSession& Session, const FCallPlan& Plan, std::span<const std::byte> Values, FPlainCall& Plain) {
    UFunction* const Function = static_cast<UFunction*>(Plan.Function.Get(true));
    const FParameterLayout& Layout = *Plan.Layout;
    if (Plan.LatentInfo || Plan.WorldContext || Plan.bOnDefaultObject || !Plan.Omitted.empty() ||
        !Layout.ToInitialise.empty() || !Layout.ToDestroy.empty() || Layout.Size > MostParameterBytes ||
        Layout.Alignment > 16 || Plan.Results.size() > 1 || (Plan.Results.size() == 1 && !Plan.bHasReturnValue)) {
        return false;
    }
#if WITH_EDITOR
    if (!Function->HasAnyFunctionFlags(FUNC_Native)) { // compiled anew in place
        return false;
    }
#endif
    Plain.Function = Function;
    Plain.ParameterBytes = static_cast<uint32>((Layout.Size + 15) / 16 * 16);

    spear::Decoder In(Values);
    for (const FCallPlan::FParameter& Argument : Plan.Arguments) {
        const auto At = static_cast<uint32>(Values.size() - In.remaining());
        const auto Type = In.get<spear::TypeId>();
        const auto Offset = static_cast<uint32>(Argument.Property->GetOffset_ForInternal());
        Plain.Tags.push_back({At, Type});
        uint32 Bytes = 0;
        if (Argument.Plan->Kind == EValueKind::Number && Type == Argument.Plan->Builtin) {
            Bytes = static_cast<uint32>(Argument.Plan->Size);
            Plain.In.push_back({At + 4, Offset, Bytes});
        } else if (Argument.Plan->Kind == EValueKind::Struct) {
            const auto Known = Session.Conversions.find((static_cast<uint64>(Type) << 32) | Argument.Plan->Index);
            if (Known == Session.Conversions.end() || !Known->second->bDirect) {
                return false;
            }
            Bytes = static_cast<uint32>(Known->second->PayloadBytes);
            for (const FStructConversion::FCopy& Copy : Known->second->Copies) {
                Plain.In.push_back({At + 4 + static_cast<uint32>(Copy.From), Offset + static_cast<uint32>(Copy.To),
                    static_cast<uint32>(Copy.Size)});
            }
        } else {
            return false;
        }
        (void)In.get_raw(Bytes);
    }
    if (!In.ok() || In.remaining() != 0) {
        return false;
    }
    Plain.ValueBytes = static_cast<uint32>(Values.size());

    if (Plan.Results.size() == 1) {
        const FCallPlan::FParameter& Result = Plan.Results.front();
        if (!Result.Plan->bRaw) {
            return false;
        }
        const auto Offset = static_cast<uint32>(Result.Property->GetOffset_ForInternal());
        for (const FTypePlan::FRun& Run : Result.Plan->Runs) {
            Plain.Out.push_back(
                {Offset + static_cast<uint32>(Run.Offset), Plain.ResultBytes, static_cast<uint32>(Run.Size)});
            Plain.ResultBytes += static_cast<uint32>(Run.Size);
        }
        Plain.ResultType = Session.TypeNumbers.NumberOf(*Result.Plan);
    }
    return true;
}

void FPlainCalls::Learn(FSession& Session, const UObject* Target, spear::TypeId Shape, FCallPlan& Plan,
    std::span<const std::byte> Values) {
    if (Target->IsA<UClass>() || Epoch != GarbageEpoch) {
        return;
    }
    if (!Plan.Plain) {
        if (Plan.PlainTries >= MostTries) {
            return;
        }
        ++Plan.PlainTries;
        auto Plain = std::make_unique<FPlainCall>();
        if (!Describe(Session, Plan, Values, *Plain)) {
            return;
        }
        Plan.Plain = std::move(Plain);
    }
    Entries[IndexOf(Target->GetClass(), Shape)] = {Target->GetClass(), Shape, Plan.Plain.get()};
}

} // namespace SpearServer
