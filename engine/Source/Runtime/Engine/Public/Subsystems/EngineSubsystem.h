// SPDX-License-Identifier: MIT
/** @file Subsystems of the engine. Mirrors UE's Subsystems/EngineSubsystem.h. */
#pragma once

#include "CoreMinimal.h"
#include "Subsystems/Subsystem.h"

#include "EngineSubsystem.generated.h"

/** Base class for auto instanced and initialized systems that share the lifetime of the engine. Reach them by
 * GEngine->GetEngineSubsystem<T>(). */
UCLASS(Abstract)
class ENGINE_API UEngineSubsystem : public UDynamicSubsystem {
    GENERATED_BODY()

public:
    UEngineSubsystem();
};
