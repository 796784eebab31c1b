// SPDX-License-Identifier: MIT
// Options of text export, import and comparison of properties. Mirrors Epic's "UObject/PropertyPortFlags.h".
#pragma once

#include "CoreTypes.h"

enum EPropertyPortFlags {
    PPF_None = 0x00000000,
    /** Export: write quotes and escapes where the text is part of a list or struct. Import: read them. */
    PPF_Delimited = 0x00000002,
    PPF_CheckReferences = 0x00000004,
    PPF_ExportsNotFullyQualified = 0x00000008,
    PPF_AttemptNonQualifiedSearch = 0x00000010,
    PPF_RestrictImportTypes = 0x00000020,
    PPF_SubobjectsOnly = 0x00000100,
    /** Comparison: compare instanced subobjects by content, only within their own root. */
    PPF_DeltaComparison = 0x00000200,
    PPF_DeepComparison = 0x00000400,
    PPF_DeepCompareInstances = 0x00000800,
    PPF_Copy = 0x00001000,
    PPF_Duplicate = 0x00002000,
    PPF_SimpleObjectText = 0x00004000,
    PPF_ParsingDefaultProperties = 0x00008000,
    PPF_IncludeTransient = 0x00020000,
    PPF_ForDiff = 0x00080000,
    /** Text for people: enums and names unquoted, display names. */
    PPF_PropertyWindow = 0x00100000,
    PPF_BlueprintDebugView = 0x00200000,
    PPF_ExternalEditor = 0x00400000,
    PPF_DuplicateForPIE = 0x00800000,
    PPF_SerializedAsImportText = 0x01000000,
    PPF_ConsoleVariable = 0x02000000,
    PPF_UseDeprecatedProperties = 0x04000000,
    PPF_DuplicateVerbatim = 0x08000000,
    PPF_InstanceSubobjects = 0x10000000,
    PPF_DebugDump = 0x40000000,
    PPF_DeepCompareDSOsOnly = 0x20000000,
};
