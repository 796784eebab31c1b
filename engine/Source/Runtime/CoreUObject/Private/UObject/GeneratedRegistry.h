// SPDX-License-Identifier: MIT
// Private parts of registration that more than one file needs.
#pragma once

#include "CoreMinimal.h"

class UClass;

/** Intrinsic classes that are made but not linked yet. */
TArray<UClass*>& UnfinishedIntrinsics();
/** Makes all intrinsic classes exist. */
void ForceIntrinsicClasses();
