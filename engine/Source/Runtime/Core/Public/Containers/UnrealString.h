// SPDX-License-Identifier: MIT
/** FString and the Lex functions. */
#pragma once

#include "Containers/UnrealStringClass.h"
#include "Misc/LexicalConversion.h"
