// SPDX-License-Identifier: MIT
/** FDelegateHandle: names one binding of a delegate. */
#pragma once

#include "CoreTypes.h"
#include "Templates/TypeHash.h"

class FDelegateHandle {
public:
    enum EGenerateNewHandleType { GenerateNewHandle };

    FDelegateHandle() : ID(0) {}
    explicit FDelegateHandle(EGenerateNewHandleType) : ID(GenerateNewID()) {}
    bool IsValid() const { return ID != 0; }
    void Reset() { ID = 0; }
    bool operator==(const FDelegateHandle& Other) const { return ID == Other.ID; }
    friend uint32 GetTypeHash(const FDelegateHandle& Key) { return GetTypeHash(Key.ID); }

private:
    static CORE_API uint64 GenerateNewID();
    uint64 ID;
};
