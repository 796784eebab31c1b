// SPDX-License-Identifier: MIT
#pragma once

// A client's session as the game thread has it: handles, announced types, kept results, caches. Only the game thread
// touches it.

#include "CoreMinimal.h"

#include "Frame/Inbox.h"
#include "Frame/Result.h"
#include "Reflection/CallPlan.h"
#include "Reflection/Handles.h"
#include "Reflection/PropertyPath.h"
#include "Reflection/TypeNumbers.h"
#include "Reflection/ValueReader.h"

#include "spear/codec.hpp"

#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

namespace SpearServer {

/// The result of an operation that later operations may name as a future.
struct FKeptResult {
    enum EState : uint8 { Pending, Succeeded, Failed } State = Succeeded;
    spear::ByteBuffer Value; ///< type number and payload
    ErrorInfo Error;
};

class FSession {
public:
    explicit FSession(FSessionGreeting InGreeting) : Greeting(std::move(InGreeting)) {}

    uint64 GetId() const { return Greeting.Id; }
    const std::string& GetClientName() const { return Greeting.ClientName; }
    /// Our number of an entry point that the client has as Number (checked when the batch arrived).
    uint16 EntryPointOf(uint16 Number) const { return Greeting.EntryPoints[Number]; }

    spear::TypeTables Tables() const { return {&ClientTypes, &TypeNumbers.Table()}; }

    /// The value of an earlier operation. DependencyFailed, NeedsFrames, or UnknownObject if there is none.
    TSpearResult<std::span<const std::byte>> ResolveFuture(uint64 Number) const;
    /// A place for the result of an operation, pending. Null if limits::max_kept_results is reached or the number is
    /// taken. Stays where it is until it is released.
    FKeptResult* Keep(uint64 Number);
    FKeptResult* FindKept(uint64 Number);
    void ReleaseKept(uint64 Number);
    std::size_t NumKept() const { return Kept.size(); }

    /// After a garbage collection: drops what names dead objects, classes and functions.
    void Sweep();

    spear::TypeTable ClientTypes{spear::types::first_client_type};
    FTypeNumbers TypeNumbers;
    FHandleTable Handles;
    FStructConversions Conversions;
    FEnumConversions EnumConversions;
    FCallPlans CallPlans;
    FPropertyPaths PropertyPaths;

private:
    FSessionGreeting Greeting;
    using FKept = std::unordered_map<uint64, FKeptResult>;
    FKept Kept;
    std::vector<FKept::node_type> Spare; ///< released ones with their memory, for the next
};

} // namespace SpearServer
