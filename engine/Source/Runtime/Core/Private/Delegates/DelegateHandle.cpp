// SPDX-License-Identifier: MIT
#include <atomic>

#include "Delegates/IDelegateInstance.h"

uint64 FDelegateHandle::GenerateNewID() {
    static std::atomic<uint64> NextID{1};
    return NextID.fetch_add(1);
}
