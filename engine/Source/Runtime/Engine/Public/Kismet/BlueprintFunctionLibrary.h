// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"

#include "BlueprintFunctionLibrary.generated.h"

/** Base of the classes that hold static functions for scripts and remote programs. Epic page:
 * UBlueprintFunctionLibrary. */
UCLASS(Abstract)
class ENGINE_API UBlueprintFunctionLibrary : public UObject {
    GENERATED_BODY()

public:
    UBlueprintFunctionLibrary(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());
};
