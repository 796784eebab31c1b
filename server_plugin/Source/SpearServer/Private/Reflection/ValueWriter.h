// SPDX-License-Identifier: MIT
#pragma once

// Property values to the wire.

#include "CoreMinimal.h"

#include "Frame/Result.h"
#include "Reflection/TypePlan.h"

#include "spear/codec.hpp"
#include "spear/encode.hpp"

namespace SpearServer {

class FSession;

/// A reference to an object as it travels: its handle and its announced class.
spear::ObjectRef ReferTo(FSession& Session, const UObject* Object);

/// Writes a type number and the value at the address.
FStatus WriteValue(FSession& Session, const FTypePlan& Plan, const void* Address, spear::Encoder& Out);
/// Writes the value alone, for where the type is announced (fields, elements).
FStatus WritePayload(
    FSession& Session, const FTypePlan& Plan, const void* Address, spear::Encoder& Out, std::size_t Depth = 0);

} // namespace SpearServer
