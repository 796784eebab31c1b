// SPDX-License-Identifier: MIT
#pragma once

// Parts of the live schema: type nodes, flags, names (codegen/SCHEMA.md, sections 2 to 7).

#include "CoreMinimal.h"
#include "UObject/Class.h"
#include "UObject/UnrealType.h"

#include "Reflection/SchemaValue.h"

#include <string>

namespace SpearServer {

/// "AActor", "UFoo" (interfaces too), "UDEPRECATED_Foo".
std::string SchemaNameOf(const UClass* Class);
/// "FFoo" of the signature "Foo__DelegateSignature".
std::string SchemaNameOf(const UFunction* Signature);
/// "Engine" of "/Script/Engine.Actor"; the package's name where it is no module.
std::string ModuleOf(const UObject* Object);

/// The type node of a property.
FSchemaDict TypeNodeOf(const FProperty* Property);

/// The names of the flags that are in the schema, sorted.
FSchemaList FlagsOf(const UClass* Class);
FSchemaList FlagsOf(const UScriptStruct* Struct);
FSchemaList FlagsOf(const UFunction* Function);
FSchemaList FlagsOf(const FProperty* Property);

} // namespace SpearServer
