// SPDX-License-Identifier: MIT
/**
 * Delegates: DECLARE_DELEGATE*, DECLARE_MULTICAST_DELEGATE*, DECLARE_EVENT*, TDelegate, TMulticastDelegate.
 * The dynamic ones, which reflection knows, belong to the CoreUObject module. See Epic's "Delegates and Lambda
 * Functions".
 */
#pragma once

#include "Containers/Array.h"
#include "Delegates/DelegateInstancesImpl.h"

/** The one policy of this engine: a delegate belongs to one thread at a time. */
struct FDefaultDelegateUserPolicy {};

#include "Delegates/DelegateSignatureImpl.inl"

#include "Delegates/DelegateCombinations.h"

DECLARE_DELEGATE(FSimpleDelegate)
DECLARE_MULTICAST_DELEGATE(FSimpleMulticastDelegate)
