// SPDX-License-Identifier: MIT
/** Declares TWeakObjectPtr, which the CoreUObject module defines. */
#pragma once

class UObject;
struct FWeakObjectPtr;
template <class T = UObject, class TWeakObjectPtrBase = FWeakObjectPtr>
struct TWeakObjectPtr;
