// SPDX-License-Identifier: MIT
#pragma once

// Calling reflected functions. A plan is worked out once per (class of the object, call shape): which function, which
// argument goes where, what the omitted ones get, what the result looks like. Classes and functions are held weakly.

#include "CoreMinimal.h"
#include "UObject/Class.h"
#include "UObject/UnrealType.h"
#include "UObject/WeakObjectPtr.h"

#include "Frame/Result.h"
#include "Reflection/TypePlan.h"

#include "spear/codec.hpp"

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace SpearServer {

struct FOperation;
class FSession;

/// What the parameters of a function want, worked out once.
struct FParameterLayout {
    explicit FParameterLayout(UFunction* InFunction);
    FWeakObjectPtr Function; ///< plans may outlive a Blueprint's function
    SIZE_T Size = 0;
    uint32 Alignment = 1;
    std::vector<const FProperty*> ToInitialise; ///< zeros are no value of these
    std::vector<const FProperty*> ToDestroy;
};

/// The memory of a function's parameters: initialised, and destroyed, as each parameter wants it.
class FParameters {
public:
    /// The layout must outlive this.
    explicit FParameters(const FParameterLayout& InLayout);
    ~FParameters();
    FParameters(const FParameters&) = delete;
    FParameters& operator=(const FParameters&) = delete;
    uint8* Get() const { return Memory; }

private:
    static constexpr std::size_t InlineBytes = 512;
    const FParameterLayout& Layout;
    uint8* Memory;
    alignas(16) uint8 Inline[InlineBytes];
};

/// What is left to do for a call whose arguments and result are plain numbers: see FPlainCalls.
struct FPlainCall {
    struct FCopy {
        uint32 From = 0, To = 0, Size = 0;
    };
    struct FTag {
        uint32 At = 0; ///< within the arguments' values
        spear::TypeId Type = 0;
    };
    UFunction* Function = nullptr;
    uint32 ValueBytes = 0;     ///< of all arguments, with their type numbers
    uint32 ParameterBytes = 0; ///< rounded up to 16
    spear::TypeId ResultType = spear::types::null;
    uint32 ResultBytes = 0; ///< without the type number
    std::vector<FTag> Tags; ///< type numbers that stand in the values
    std::vector<FCopy> In;  ///< from the values into the parameters
    std::vector<FCopy> Out; ///< from the parameters into the result
};

struct FCallPlan {
    struct FParameter {
        const FProperty* Property = nullptr;
        FTypePlanRef Plan;
        std::string Name;
    };

    FWeakObjectPtr Class;
    FWeakObjectPtr Function;
    std::string OperationName;         ///< "AActor::K2_SetActorLocation"
    std::vector<FParameter> Arguments; ///< in the order in which the client sends them
    std::unique_ptr<FParameterLayout> Layout;
    std::unique_ptr<FParameters> Defaults;             ///< holds the values of the arguments omitted
    std::vector<const FProperty*> Omitted;             ///< taken from Defaults
    const FObjectPropertyBase* WorldContext = nullptr; ///< filled in by us
    const FStructProperty* LatentInfo = nullptr;       ///< filled in by us
    std::vector<FParameter> Results;                   ///< the return value, if any, first; then out-parameters
    bool bHasReturnValue = false;
    bool bOnDefaultObject = false; ///< the target is a class, the function a static one of its instances
    spear::TypeInfo ResultType;    ///< of several results; announced at the first use
    spear::TypeId ResultNumber = 0;
    std::unique_ptr<FPlainCall> Plain; ///< null: not plain, or not known yet
    int32 PlainTries = 0;
};

/// The plans of one session.
class FCallPlans {
public:
    /// Calls the function that the shape names on the object; writes the result to Operation.Out.
    FStatus Call(FOperation& Operation, UObject* Target, spear::TypeId Shape, std::span<const std::byte> Arguments);
    void Sweep();

private:
    struct FKey {
        const UClass* Class;
        spear::TypeId Shape;
        bool operator==(const FKey&) const = default;
    };
    struct FKeyHash {
        std::size_t operator()(const FKey& Key) const {
            return reinterpret_cast<std::size_t>(Key.Class) / 64 * 31 + Key.Shape;
        }
    };
    TSpearResult<std::shared_ptr<FCallPlan>> Find(FOperation& Operation, UObject* Target, spear::TypeId Shape);

    std::unordered_map<FKey, std::shared_ptr<FCallPlan>, FKeyHash> Plans;
};

/// Writes what the function left in its parameters: the return value alone, a struct of it and the out-parameters, or
/// null.
FStatus WriteResults(FSession& Session, FCallPlan& Plan, const uint8* Parameters, spear::Encoder& Out);

} // namespace SpearServer
