// SPDX-License-Identifier: MIT
#pragma once

// Calls of functions whose parameters are plain numbers (and structs of them), as fast as they can be: once such a call
// has gone the general way (FCallPlans), which checks everything, the next with the same shape on an object of the same
// class only compares type numbers, copies bytes into the parameters, calls, and copies bytes out. No search, no
// allocation, no reference counting. Whatever is not exactly as it was before goes the general way again.

#include "CoreMinimal.h"
#include "UObject/Class.h"

#include "Reflection/CallPlan.h"

#include "spear/encode.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace SpearServer {

class FSession;

class FPlainCalls {
public:
    /// A call that is ready to be made.
    struct FReady {
        UObject* Object = nullptr; ///< null: it is not plain, or not yet
        const FPlainCall* Plain = nullptr;
        const std::byte* Values = nullptr;

        /// Bytes of the result as a value.
        std::size_t ResultBytes() const { return sizeof(spear::TypeId) + Plain->ResultBytes; }
    };
    /// Looks at the arguments of unreal_service.call_function.
    FReady Find(const FSession& Session, std::span<const std::byte> Arguments);
    /// Makes the call, writes the result as a value; To may be null.
    static void Make(const FReady& Ready, std::byte* To);

    /// A call has gone well the general way: remembers it, if it is plain.
    void Learn(FSession& Session, const UObject* Target, spear::TypeId Shape, FCallPlan& Plan,
        std::span<const std::byte> Values);

private:
    static constexpr std::size_t MostParameterBytes = 512;

    /// Where to look first. Objects of the class are alive when this is used, so the class is, and its functions.
    struct FEntry {
        const UClass* Class = nullptr;
        spear::TypeId Shape = 0;
        const FPlainCall* Plain = nullptr; ///< its plan's
    };
    static std::size_t IndexOf(const UClass* Class, spear::TypeId Shape) {
        return (reinterpret_cast<std::size_t>(Class) / 64 + Shape) % 256;
    }
    static bool Describe(FSession& Session, const FCallPlan& Plan, std::span<const std::byte> Values, FPlainCall& Plain);

    std::array<FEntry, 256> Entries{};
    uint32 Epoch = 0; ///< a garbage collection ends what Entries say
};

} // namespace SpearServer
