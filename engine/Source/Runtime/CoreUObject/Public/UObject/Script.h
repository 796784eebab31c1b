// SPDX-License-Identifier: MIT
// Script basics: function flags and the native function type. Mirrors Epic's "UObject/Script.h" (API page
// EFunctionFlags).
#pragma once

#include "CoreMinimal.h"

class UObject;
struct FFrame;

/** Flags of a UFunction. Names and values are those of Epic's EFunctionFlags page. */
enum EFunctionFlags : uint32 {
    FUNC_None = 0x00000000,
    FUNC_Final = 0x00000001,
    FUNC_RequiredAPI = 0x00000002,
    FUNC_BlueprintAuthorityOnly = 0x00000004,
    FUNC_BlueprintCosmetic = 0x00000008,
    FUNC_Net = 0x00000040,
    FUNC_NetReliable = 0x00000080,
    FUNC_NetRequest = 0x00000100,
    FUNC_Exec = 0x00000200,
    FUNC_Native = 0x00000400,
    FUNC_Event = 0x00000800,
    FUNC_NetResponse = 0x00001000,
    FUNC_Static = 0x00002000,
    FUNC_NetMulticast = 0x00004000,
    FUNC_UbergraphFunction = 0x00008000,
    FUNC_MulticastDelegate = 0x00010000,
    FUNC_Public = 0x00020000,
    FUNC_Private = 0x00040000,
    FUNC_Protected = 0x00080000,
    FUNC_Delegate = 0x00100000,
    FUNC_NetServer = 0x00200000,
    FUNC_HasOutParms = 0x00400000,
    FUNC_HasDefaults = 0x00800000,
    FUNC_NetClient = 0x01000000,
    FUNC_DLLImport = 0x02000000,
    FUNC_BlueprintCallable = 0x04000000,
    FUNC_BlueprintEvent = 0x08000000,
    FUNC_BlueprintPure = 0x10000000,
    FUNC_EditorOnly = 0x20000000,
    FUNC_Const = 0x40000000,
    FUNC_NetValidate = 0x80000000,
    FUNC_AllFlags = 0xFFFFFFFF,
};
ENUM_CLASS_FLAGS(EFunctionFlags)

/** Flags a function takes over from the function it overrides. */
#define FUNC_FuncInherit                                                                                               \
    ((EFunctionFlags)(FUNC_Exec | FUNC_Event | FUNC_BlueprintCallable | FUNC_BlueprintEvent |                          \
                      FUNC_BlueprintAuthorityOnly | FUNC_BlueprintCosmetic | FUNC_Const))
#define FUNC_FuncOverrideMatch                                                                                         \
    ((EFunctionFlags)(FUNC_Exec | FUNC_Final | FUNC_Static | FUNC_Public | FUNC_Protected | FUNC_Private))
#define FUNC_NetFuncFlags                                                                                              \
    ((EFunctionFlags)(FUNC_Net | FUNC_NetReliable | FUNC_NetServer | FUNC_NetClient | FUNC_NetMulticast))
#define FUNC_AccessSpecifiers ((EFunctionFlags)(FUNC_Public | FUNC_Private | FUNC_Protected))

/** Name of the result pointer of a native function. */
#define RESULT_PARAM Z_Param__Result
/** Declaration of the result pointer of a native function. */
#define RESULT_DECL void* const RESULT_PARAM

/** A native function as the script interface calls it: context object, frame with the arguments, where to put the
 * result. */
typedef void (*FNativeFuncPtr)(UObject* Context, FFrame& TheStack, RESULT_DECL);

/** A name with its native function; tables of these are registered per class. */
struct FNameNativePtrPair {
    const char* NameUTF8;
    FNativeFuncPtr Pointer;
};

/** Largest number of parameters the reflection system supports for one function. */
inline constexpr int32 MAX_FUNC_PARMS = 255;
