// SPDX-License-Identifier: MIT
#include "Reflection/CallPlan.h"

#include "SpearText.h"

#include "Frame/Session.h"
#include "Reflection/CallPlanBuilder.h"
#include "Reflection/LatentCalls.h"
#include "Reflection/ValueWriter.h"
#include "Reflection/Worlds.h"

#include "UObject/Script.h"

#include <optional>

namespace SpearServer {

FParameterLayout::FParameterLayout(UFunction* InFunction)
    : Function(InFunction), Size(InFunction->ParmsSize), Alignment(static_cast<uint32>(InFunction->GetMinAlignment())) {
    for (TFieldIterator<FProperty> It(InFunction); It && It->HasAnyPropertyFlags(CPF_Parm); ++It) {
        if (!It->HasAnyPropertyFlags(CPF_ZeroConstructor)) {
            ToInitialise.push_back(*It);
        }
        if (!It->HasAnyPropertyFlags(CPF_NoDestructor)) {
            ToDestroy.push_back(*It);
        }
    }
}

FParameters::FParameters(const FParameterLayout& InLayout) : Layout(InLayout), Memory(Inline) {
    if (Layout.Size > InlineBytes || Layout.Alignment > 16) {
        Memory = static_cast<uint8*>(FMemory::Malloc(Layout.Size, Layout.Alignment));
    }
    FMemory::Memzero(Memory, Layout.Size);
    for (const FProperty* Property : Layout.ToInitialise) {
        Property->InitializeValue_InContainer(Memory);
    }
}

FParameters::~FParameters() {
    // When the function is gone nobody knows any more what the memory holds; a few strings may leak then.
    if (!Layout.ToDestroy.empty() && Layout.Function.Get(true)) {
        for (const FProperty* Property : Layout.ToDestroy) {
            Property->DestroyValue_InContainer(Memory);
        }
    }
    if (Memory != Inline) {
        FMemory::Free(Memory);
    }
}

TSpearResult<std::shared_ptr<FCallPlan>> FCallPlans::Find(FOperation& Operation, UObject* Target, spear::TypeId Shape) {
    // Functions of a class object are looked up for that class, not for UClass.
    const UClass* TargetAsClass = Cast<UClass>(Target);
    const FKey Key{TargetAsClass ? TargetAsClass : Target->GetClass(), TargetAsClass ? Shape | 0x8000'0000u : Shape};
    if (const auto At = Plans.find(Key); At != Plans.end()) {
        const UObject* Class = At->second->Class.Get(true);
        const UObject* Function = At->second->Function.Get(true);
        bool bCurrent = Class && Function;
#if WITH_EDITOR
        // Blueprint classes are compiled anew in place.
        bCurrent = bCurrent && static_cast<const UClass*>(Class)->FindFunctionByName(Function->GetFName()) == Function;
#endif
        if (bCurrent) {
            return At->second;
        }
        Plans.erase(At);
    }
    const spear::TypeInfo* Info = Operation.Session->ClientTypes.find(Shape);
    if (!Info || Info->kind != spear::TypeKind::call_shape) {
        return MakeError(ErrorCode::MalformedMessage, "the call names a shape that was not announced as one", "shape");
    }
    TSpearResult<std::unique_ptr<FCallPlan>> Built = BuildCallPlan(Target, *Info);
    if (!Built.IsOk()) {
        return std::move(Built.GetError());
    }
    std::shared_ptr<FCallPlan> Plan = std::move(Built.GetValue());
    Plans[Key] = Plan;
    return Plan;
}

FStatus FCallPlans::Call(
    FOperation& Operation, UObject* Target, spear::TypeId Shape, std::span<const std::byte> Arguments) {
    FSession& Session = *Operation.Session;
    TSpearResult<std::shared_ptr<FCallPlan>> Found = Find(Operation, Target, Shape);
    if (!Found.IsOk()) {
        if (Found.GetError().operation.empty()) {
            const spear::TypeInfo* Info = Session.ClientTypes.find(Shape);
            const UClass* TargetAsClass = Cast<UClass>(Target);
            Found.GetError().operation = CppNameOf(TargetAsClass ? TargetAsClass : Target->GetClass()) +
                                         "::" + (Info ? Info->name.substr(0, 256) : "?");
        }
        return std::move(Found.GetError());
    }
    FCallPlan& Plan = *Found.GetValue();
    const auto Named = [&](ErrorInfo Error) {
        Error.operation = Plan.OperationName;
        return Error;
    };
    UFunction* Function = static_cast<UFunction*>(Plan.Function.Get(true));
    UObject* Object = Plan.bOnDefaultObject ? Cast<UClass>(Target)->GetDefaultObject() : Target;

    // A latent function may write to its parameters until it completes: they live as long.
    std::optional<FParameters> OnStack;
    std::shared_ptr<FParameters> Shared;
    if (Plan.LatentInfo) {
        Shared = std::make_shared<FParameters>(*Plan.Layout);
    } else {
        OnStack.emplace(*Plan.Layout);
    }
    FParameters* const Parameters = Shared ? Shared.get() : &*OnStack;
    spear::Decoder In(Arguments);
    for (const FCallPlan::FParameter& Argument : Plan.Arguments) {
        FValueReader Reader(Operation, "argument", Argument.Name);
        if (!Reader.ReadValue(*Argument.Plan, Argument.Property->ContainerPtrToValuePtr<void>(Parameters->Get()), In)) {
            return Named(std::move(Reader.Error));
        }
    }
    if (In.remaining() != 0) {
        return Named(
            MakeError(ErrorCode::MalformedMessage, "the call carries more arguments than its shape announced"));
    }
    for (const FProperty* Property : Plan.Omitted) {
        Property->CopyCompleteValue_InContainer(Parameters->Get(), Plan.Defaults->Get());
    }
    if (Plan.WorldContext) {
        TSpearResult<UObject*> Context = WorldContextFor(Object);
        if (!Context.IsOk()) {
            return Named(std::move(Context.GetError()));
        }
        Plan.WorldContext->SetObjectPropertyValue_InContainer(Parameters->Get(), Context.GetValue());
    }
    int32 LatentCall = 0;
    if (Plan.LatentInfo) {
        LatentCall = FLatentCalls::Get().Begin(Session.GetId(), Operation.Number, Found.GetValue(), Shared);
        FLatentCalls::Get().FillInfo(LatentCall, Plan.LatentInfo->ContainerPtrToValuePtr<void>(Parameters->Get()));
    }

    {
#if WITH_EDITOR
        const TGuardValue<bool> AllowScript(GAllowActorScriptExecutionInEditor, true);
#endif
        Object->ProcessEvent(Function, Parameters->Get());
    }

    if (Plan.LatentInfo) {
        if (!FLatentCalls::Get().Completed(LatentCall)) {
            Operation.Outcome = EOutcome::Pending;
            return {};
        }
    }
    FStatus Written = WriteResults(Session, Plan, Parameters->Get(), *Operation.Out);
    if (!Written.IsOk()) {
        return Named(std::move(Written.GetError()));
    }
    if (IsUsable(Target)) {
        Session.PlainCalls.Learn(Session, Target, Shape, Plan, Arguments);
    }
    return {};
}

FStatus WriteResults(FSession& Session, FCallPlan& Plan, const uint8* Parameters, spear::Encoder& Out) {
    if (Plan.Results.empty()) {
        Out.put(spear::types::null);
        return {};
    }
    if (Plan.Results.size() == 1 && Plan.bHasReturnValue) {
        const FCallPlan::FParameter& Only = Plan.Results.front();
        return WriteValue(Session, *Only.Plan, Only.Property->ContainerPtrToValuePtr<void>(Parameters), Out);
    }
    if (Plan.ResultNumber == 0) {
        for (const FCallPlan::FParameter& Result : Plan.Results) {
            Plan.ResultType.fields.push_back({Result.Name, Session.TypeNumbers.NumberOf(*Result.Plan)});
        }
        Plan.ResultNumber = Session.TypeNumbers.NumberOf(Plan.ResultType);
    }
    Out.put(Plan.ResultNumber);
    for (const FCallPlan::FParameter& Result : Plan.Results) {
        FStatus Written =
            WritePayload(Session, *Result.Plan, Result.Property->ContainerPtrToValuePtr<void>(Parameters), Out);
        if (!Written.IsOk()) {
            Written.GetError().argument = Result.Name;
            return Written;
        }
    }
    return {};
}

void FCallPlans::Sweep() {
    for (auto At = Plans.begin(); At != Plans.end();) {
        At = At->second->Class.Get(true) && At->second->Function.Get(true) ? std::next(At) : Plans.erase(At);
    }
}

} // namespace SpearServer
