// SPDX-License-Identifier: MIT
#pragma once

// Classes by name, and the names that are near when there is none.

#include "CoreMinimal.h"
#include "UObject/Class.h"

#include "Frame/Result.h"

#include "spear/entry_points/types.hpp"

#include <string_view>

namespace SpearServer {

class FNearestNames;
struct FOperation;

/// The loaded class of that name, with or without prefix ("AActor", "Actor", "IFoo"), or path ("/Script/Engine.Actor").
/// UnknownClass with the nearest names, AmbiguousName with all paths.
TSpearResult<UClass*> FindClassByName(std::string_view Name);

/// The class that an argument means; null if it means none.
TSpearResult<UClass*> ResolveClass(FOperation& Operation, const spear::ClassArgument& Argument);
/// The same, but null is the error NullObject.
TSpearResult<UClass*> ResolveClassNonNull(FOperation& Operation, const spear::ClassArgument& Argument);

/// The functions that can be called on objects of the class; for UClass objects use the class they stand for.
void AddFunctionNames(FNearestNames& Nearest, const UClass* Class);
/// The properties of a class or struct.
void AddPropertyNames(FNearestNames& Nearest, const UStruct* Struct);

/// Forgets names found before: after a garbage collection, or when modules were loaded.
void ForgetClassNames();

} // namespace SpearServer
