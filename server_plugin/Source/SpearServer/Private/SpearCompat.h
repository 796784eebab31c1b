// SPDX-License-Identifier: MIT
#pragma once

// The few real differences between Unreal Engine and the embedded engine, in one place. Everything else in this plugin
// is written once, against Unreal Engine 5.5's public API.

#include "CoreMinimal.h"
#include "UObject/Class.h"

#include <string>

/// Whether metadata is kept at run time: default arguments, the names of world-context parameters, the schema's editor
/// tier.
#ifndef WITH_METADATA
#define WITH_METADATA WITH_EDITORONLY_DATA
#endif

#if defined(SPEAR_EMBEDDED_ENGINE)

namespace SpearServer {

inline constexpr const char* EngineName = "embedded";

/// The embedded engine has no field path properties.
inline std::string FieldPathTypeOf(const FProperty*) { return {}; }

#if WITH_METADATA
inline const TMap<FName, FString>* MetaDataOf(const UField* Field) { return Field->GetMetaDataMap(); }
#endif

} // namespace SpearServer

#else

#include "UObject/FieldPathProperty.h"
#include "UObject/MetaData.h"

namespace SpearServer {

inline constexpr const char* EngineName = "unreal";

/// "FProperty" of a TFieldPath<FProperty>; empty for properties of other kinds.
inline std::string FieldPathTypeOf(const FProperty* Property) {
    const FFieldPathProperty* FieldPath = CastField<FFieldPathProperty>(Property);
    if (!FieldPath) {
        return {};
    }
    return std::string("F") +
           (FieldPath->PropertyClass ? TCHAR_TO_UTF8(*FieldPath->PropertyClass->GetName()) : "Property");
}

#if WITH_METADATA
/// Unreal keeps the metadata of types and functions beside them, in their package.
inline const TMap<FName, FString>* MetaDataOf(const UField* Field) { return UMetaData::GetMapForObject(Field); }
#endif

} // namespace SpearServer

#endif
