// SPDX-License-Identifier: MIT
/** Forward declarations of Core types. */
#pragma once

#include "Containers/ContainersFwd.h"
#include "Math/MathFwd.h"

class FOutputDevice;
struct FGuid;
struct FDateTime;
struct FTimespan;
class IConsoleVariable;
class FRunnableThread;
class FEvent;
class UObject;
class UClass;
class UWorld;
