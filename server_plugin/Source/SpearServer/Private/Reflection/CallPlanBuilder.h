// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

#include "Reflection/CallPlan.h"

namespace SpearServer {

/// Works out a plan for calling the function that the shape names on objects of the target's class. UnknownFunction,
/// NotCallable, UnknownArgument, MissingArgument.
TSpearResult<std::unique_ptr<FCallPlan>> BuildCallPlan(UObject* Target, const spear::TypeInfo& Shape);

/// Reads a default as Unreal's header tool writes it (CPP_Default_X). False if it does not fit the property.
bool ImportDefaultText(const FProperty* Property, const TCHAR* Text, void* Value);

} // namespace SpearServer
