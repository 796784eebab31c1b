// SPDX-License-Identifier: MIT
#pragma once

// A client's session as the game thread has it: handles, announced types, kept results, caches. Only the game thread
// touches it.

#include "CoreMinimal.h"

#include "Frame/Inbox.h"
#include "Frame/KeptResults.h"
#include "Frame/Result.h"
#include "Reflection/CallPlan.h"
#include "Reflection/Handles.h"
#include "Reflection/PlainCalls.h"
#include "Reflection/PropertyPath.h"
#include "Reflection/TypeNumbers.h"
#include "Reflection/ValueReader.h"

#include "spear/codec.hpp"


namespace SpearServer {

class FSession {
public:
    explicit FSession(FSessionGreeting InGreeting) : Greeting(std::move(InGreeting)) {}

    uint64 GetId() const { return Greeting.Id; }
    const std::string& GetClientName() const { return Greeting.ClientName; }
    /// Our number of an entry point that the client has as Number (checked when the batch arrived).
    uint16 EntryPointOf(uint16 Number) const { return Greeting.EntryPoints[Number]; }
    bool IsEntryPoint(uint16 Number) const { return Number < Greeting.EntryPoints.size(); }

    spear::TypeTables Tables() const { return {&ClientTypes, &TypeNumbers.Table()}; }

    /// After a garbage collection: drops what names dead objects, classes and functions.
    void Sweep();

    spear::TypeTable ClientTypes{spear::types::first_client_type};
    FTypeNumbers TypeNumbers;
    FHandleTable Handles;
    FStructConversions Conversions;
    FEnumConversions EnumConversions;
    FCallPlans CallPlans;
    FPlainCalls PlainCalls;
    FPropertyPaths PropertyPaths;
    FKeptResults Kept;

private:
    FSessionGreeting Greeting;
};

} // namespace SpearServer
