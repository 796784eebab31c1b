// SPDX-License-Identifier: MIT
#include "Kismet/BlueprintFunctionLibrary.h"

UBlueprintFunctionLibrary::UBlueprintFunctionLibrary(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer) {}
