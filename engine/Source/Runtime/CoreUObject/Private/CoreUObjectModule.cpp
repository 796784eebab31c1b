// SPDX-License-Identifier: MIT
// The module object of CoreUObject.
#include "CoreMinimal.h"
#include "Modules/ModuleManager.h"

IMPLEMENT_MODULE(FDefaultModuleImpl, CoreUObject)
