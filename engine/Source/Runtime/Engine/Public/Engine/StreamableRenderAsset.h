// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

#include "StreamableRenderAsset.generated.h"

/**
 * Base of the assets a renderer consumes: meshes and textures. Mirrors UE's UStreamableRenderAsset; the embedded engine
 * keeps every asset fully resident, so nothing of UE's streaming interface exists here.
 */
UCLASS(Abstract, BlueprintType)
class ENGINE_API UStreamableRenderAsset : public UObject {
    GENERATED_BODY()
};
