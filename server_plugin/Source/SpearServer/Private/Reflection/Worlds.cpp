// SPDX-License-Identifier: MIT
#include "Reflection/Worlds.h"

#include "Engine/Engine.h"
#include "Engine/World.h"

namespace SpearServer {

UWorld* GetPrimaryWorld() {
    if (!GEngine) {
        return nullptr;
    }
    UWorld* Editor = nullptr;
    for (const FWorldContext& Context : GEngine->GetWorldContexts()) {
        UWorld* World = Context.World();
        if (!World) {
            continue;
        }
        if (Context.WorldType == EWorldType::Game || Context.WorldType == EWorldType::PIE) {
            return World;
        }
        if (Context.WorldType == EWorldType::Editor && !Editor) {
            Editor = World;
        }
    }
    return Editor;
}

TSpearResult<UObject*> WorldContextFor(UObject* Object) {
    if (!Object->HasAnyFlags(RF_ClassDefaultObject | RF_ArchetypeObject) && Object->GetWorld()) {
        return Object;
    }
    UWorld* World = GetPrimaryWorld();
    if (!World) {
        return MakeError(ErrorCode::UnknownObject, "there is no world yet for the function's world context");
    }
    return static_cast<UObject*>(World);
}

} // namespace SpearServer
