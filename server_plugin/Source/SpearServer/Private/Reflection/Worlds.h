// SPDX-License-Identifier: MIT
#pragma once

// Which world is meant.

#include "CoreMinimal.h"

#include "Frame/Result.h"

class UWorld;
class UObject;

namespace SpearServer {

/// The world that an omitted world argument means: the first game (or play-in-editor) world, else the editor's. May be
/// null.
UWorld* GetPrimaryWorld();

/// What a world-context parameter gets when the client gives none: the object itself if it is in a world, else the
/// primary world. UnknownObject if there is no world.
TSpearResult<UObject*> WorldContextFor(UObject* Object);

} // namespace SpearServer
