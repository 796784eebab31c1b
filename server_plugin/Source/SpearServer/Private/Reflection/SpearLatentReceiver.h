// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

#include "SpearLatentReceiver.generated.h"

/** Receives the completion of latent functions that clients have called (FLatentActionInfo::CallbackTarget). */
UCLASS(Transient, NotBlueprintable, Hidden)
class USpearLatentReceiver : public UObject {
    GENERATED_BODY()

public:
    /** Called by the engine when a latent function has completed; Linkage is the number of the call. */
    UFUNCTION()
    void OnLatentCompleted(int32 Linkage);
};
