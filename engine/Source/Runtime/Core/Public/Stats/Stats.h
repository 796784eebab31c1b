// SPDX-License-Identifier: MIT
/** @file Statistics, compiled out as in UE builds without STATS: the types and macros exist, so that code which names
 * its stats compiles. */
#pragma once

/** Name of a statistic: empty without STATS. */
struct TStatId {};

/** Returns the stat id of a tickable object. */
#define RETURN_QUICK_DECLARE_CYCLE_STAT(StatId, GroupId) return TStatId();
