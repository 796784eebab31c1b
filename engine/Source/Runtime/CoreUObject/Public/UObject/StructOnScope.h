// SPDX-License-Identifier: MIT
// A value of a struct known at run time. Mirrors Epic's "UObject/StructOnScope.h".
#pragma once

#include "UObject/Class.h"

/** Owns (or refers to) one value of a UStruct, for instance a function's parameter block. */
class FStructOnScope {
public:
    FStructOnScope() = default;
    /** Allocates and initialises a value. */
    explicit FStructOnScope(const UStruct* InScriptStruct) : ScriptStruct(InScriptStruct) { Initialize(); }
    /** Refers to memory owned by somebody else. */
    FStructOnScope(const UStruct* InScriptStruct, uint8* InData) : ScriptStruct(InScriptStruct), Memory(InData) {}
    FStructOnScope(FStructOnScope&& Other) { *this = MoveTemp(Other); }
    FStructOnScope& operator=(FStructOnScope&& Other) {
        if (this != &Other) {
            Destroy();
            ScriptStruct = Other.ScriptStruct;
            Memory = Other.Memory;
            bOwnsMemory = Other.bOwnsMemory;
            Other.ScriptStruct = nullptr;
            Other.Memory = nullptr;
            Other.bOwnsMemory = false;
        }
        return *this;
    }
    FStructOnScope(const FStructOnScope&) = delete;
    FStructOnScope& operator=(const FStructOnScope&) = delete;
    virtual ~FStructOnScope() { Destroy(); }

    uint8* GetStructMemory() { return Memory; }
    const uint8* GetStructMemory() const { return Memory; }
    const UStruct* GetStruct() const { return ScriptStruct; }
    bool IsValid() const { return ScriptStruct && Memory; }
    bool OwnsStructMemory() const { return bOwnsMemory; }
    virtual void Destroy() {
        if (bOwnsMemory) {
            ScriptStruct->DestroyStruct(Memory);
            FMemory::Free(Memory);
        }
        bOwnsMemory = false;
        Memory = nullptr;
    }
    void Initialize(const UStruct* InScriptStruct) {
        Destroy();
        ScriptStruct = InScriptStruct;
        Initialize();
    }

private:
    void Initialize() {
        if (ScriptStruct) {
            const int32 Size = ScriptStruct->GetStructureSize();
            Memory = static_cast<uint8*>(FMemory::MallocZeroed(
                static_cast<SIZE_T>(Size > 0 ? Size : 1), static_cast<uint32>(ScriptStruct->GetMinAlignment())));
            ScriptStruct->InitializeStruct(Memory);
            bOwnsMemory = true;
        }
    }
    const UStruct* ScriptStruct = nullptr;
    uint8* Memory = nullptr;
    bool bOwnsMemory = false;
};
