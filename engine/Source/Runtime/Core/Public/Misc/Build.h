// SPDX-License-Identifier: MIT
/** Build configuration switches. Each has a default, so `-Wundef` is satisfied when the build system sets none. */
#pragma once

#ifndef UE_BUILD_DEBUG
#define UE_BUILD_DEBUG 0
#endif
#ifndef UE_BUILD_DEVELOPMENT
#define UE_BUILD_DEVELOPMENT (!UE_BUILD_DEBUG)
#endif
#ifndef UE_BUILD_TEST
#define UE_BUILD_TEST 0
#endif
#ifndef UE_BUILD_SHIPPING
#define UE_BUILD_SHIPPING 0
#endif
#ifndef UE_GAME
#define UE_GAME 1
#endif
#ifndef UE_EDITOR
#define UE_EDITOR 0
#endif
#ifndef UE_SERVER
#define UE_SERVER 0
#endif
#ifndef WITH_EDITOR
#define WITH_EDITOR 0
#endif
#ifndef WITH_EDITORONLY_DATA
#define WITH_EDITORONLY_DATA 0
#endif
#ifndef WITH_METADATA
#define WITH_METADATA 1
#endif
#ifndef WITH_ENGINE
#define WITH_ENGINE 1
#endif
#ifndef WITH_COREUOBJECT
#define WITH_COREUOBJECT 1
#endif
#ifndef WITH_UNREAL_DEVELOPER_TOOLS
#define WITH_UNREAL_DEVELOPER_TOOLS 0
#endif
#ifndef WITH_SERVER_CODE
#define WITH_SERVER_CODE 1
#endif
#ifndef IS_MONOLITHIC
#define IS_MONOLITHIC 0
#endif
#ifndef IS_PROGRAM
#define IS_PROGRAM 0
#endif
#ifndef NO_LOGGING
#define NO_LOGGING 0
#endif
#ifndef DO_CHECK
#define DO_CHECK 1
#endif
#ifndef DO_ENSURE
#define DO_ENSURE 1
#endif
#ifndef DO_GUARD_SLOW
#define DO_GUARD_SLOW UE_BUILD_DEBUG
#endif
#ifndef STATS
#define STATS 0
#endif
/** Names remember the case they were made with; see FName. */
#ifndef WITH_CASE_PRESERVING_NAME
#define WITH_CASE_PRESERVING_NAME 1
#endif
/** 1 in this embedded engine and nowhere else: for the one compatibility header that must tell it from UE. */
#ifndef SPEAR_EMBEDDED_ENGINE
#define SPEAR_EMBEDDED_ENGINE 1
#endif
