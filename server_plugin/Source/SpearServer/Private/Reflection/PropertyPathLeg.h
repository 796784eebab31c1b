// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

#include "Reflection/CallPlanBuilder.h"
#include "Reflection/PropertyPath.h"

namespace SpearServer {

/// Works out the leg that begins at a segment, on objects of the class. UnknownProperty, OutOfRange.
TSpearResult<std::unique_ptr<FPathLeg>> BuildPathLeg(
    const std::vector<FPathSegment>& Segments, const UClass* Class, std::size_t First);

/// The first segments as a path again, for messages.
std::string TextOfSegments(const std::vector<FPathSegment>& Segments, std::size_t Count);

/// The object that an object, class, weak, lazy, soft or interface property refers to.
UObject* ObjectBehind(const FProperty* Property, const void* Address);

/// Reads the text between brackets as a key of a map.
FStatus ReadMapKey(const FProperty* Property, const std::string& Text, void* Key);

} // namespace SpearServer
