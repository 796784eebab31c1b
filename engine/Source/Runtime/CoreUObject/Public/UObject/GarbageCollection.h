// SPDX-License-Identifier: MIT
// Helpers around garbage collection. Mirrors Epic's "UObject/GarbageCollection.h".
#pragma once

#include "UObject/UObjectGlobals.h"

/** Keeps collections from running in its scope; a CollectGarbage inside it is skipped (TryCollectGarbage returns
 * false). */
class FGCScopeGuard {
public:
    COREUOBJECT_API FGCScopeGuard();
    COREUOBJECT_API ~FGCScopeGuard();
    UE_NONCOPYABLE(FGCScopeGuard)
};
