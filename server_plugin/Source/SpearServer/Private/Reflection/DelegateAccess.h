// SPDX-License-Identifier: MIT
#pragma once

// The bindings of a dynamic multicast delegate. Unreal offers only the bound objects, not the functions' names; the
// list itself is a protected member, open to derived classes.

#include "CoreMinimal.h"
#include "UObject/ScriptDelegates.h"

namespace SpearServer {

struct FMulticastDelegateAccess : FMulticastScriptDelegate {
    static const auto& ListOf(const FMulticastScriptDelegate& Delegate) {
        return Delegate.*(&FMulticastDelegateAccess::InvocationList);
    }
};

/// Calls Visit(const FScriptDelegate&) for each binding whose object lives.
template <typename F>
void ForEachBinding(const FMulticastScriptDelegate& Delegate, F&& Visit) {
    for (const auto& Binding : FMulticastDelegateAccess::ListOf(Delegate)) {
        if (Binding.IsBound()) {
            FScriptDelegate Copy;
            Copy.BindUFunction(const_cast<UObject*>(Binding.GetUObject()), Binding.GetFunctionName());
            Visit(Copy);
        }
    }
}

} // namespace SpearServer
