// SPDX-License-Identifier: MIT
#pragma once

// The live schema (codegen/SCHEMA.md): computed only by walking classes, structs, enums, functions and properties, so
// it sees whatever the engine has loaded. Runtime tier always, editor tier where the build keeps metadata; the source
// tier is offline only.

#include "CoreMinimal.h"
#include "UObject/Class.h"

#include "Frame/Result.h"

#include "spear/encode.hpp"

#include <string>
#include <vector>

namespace SpearServer {

/// One class: its own functions and properties, its super class, its flags.
void WriteClassSchema(const UClass* Class, spear::Encoder& Out);

/// The schema of all modules, or of those named (names without case; UnknownObject if there is none of a name).
FStatus WriteSchema(const std::vector<std::string>& Modules, spear::Encoder& Out);

} // namespace SpearServer
