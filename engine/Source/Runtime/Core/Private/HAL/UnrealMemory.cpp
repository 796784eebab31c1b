// SPDX-License-Identifier: MIT
// FMemory over the C heap.
#include "HAL/UnrealMemory.h"

#include <cstdio>
#include <cstdlib>

#include <malloc.h>

namespace {

[[noreturn]] void OutOfMemory(SIZE_T Count) {
    std::fprintf(stderr, "Fatal: out of memory: %zu bytes were asked for\n", static_cast<size_t>(Count));
    std::abort();
}

bool IsOverAligned(uint32 Alignment) { return Alignment > alignof(std::max_align_t); }

} // namespace

void* FMemory::Malloc(SIZE_T Count, uint32 Alignment) {
    const SIZE_T Size = Count ? Count : 1;
    void* Result = nullptr;
    if (!IsOverAligned(Alignment)) {
        Result = std::malloc(Size);
    } else if (::posix_memalign(&Result, Alignment, Size) != 0) {
        Result = nullptr;
    }
    if (!Result) {
        OutOfMemory(Count);
    }
    return Result;
}

void* FMemory::MallocZeroed(SIZE_T Count, uint32 Alignment) {
    return Memzero(Malloc(Count, Alignment), Count ? Count : 1);
}

void* FMemory::Realloc(void* Original, SIZE_T Count, uint32 Alignment) {
    if (Count == 0) {
        std::free(Original);
        return nullptr;
    }
    if (!IsOverAligned(Alignment)) {
        void* Result = std::realloc(Original, Count);
        if (!Result) {
            OutOfMemory(Count);
        }
        return Result;
    }
    void* Result = Malloc(Count, Alignment);
    if (Original) {
        const SIZE_T OldSize = GetAllocSize(Original);
        Memcpy(Result, Original, OldSize < Count ? OldSize : Count);
        std::free(Original);
    }
    return Result;
}

void FMemory::Free(void* Original) { std::free(Original); }
SIZE_T FMemory::GetAllocSize(void* Original) { return Original ? ::malloc_usable_size(Original) : 0; }

void FMemory::Memswap(void* Ptr1, void* Ptr2, SIZE_T Size) {
    uint8* A = static_cast<uint8*>(Ptr1);
    uint8* B = static_cast<uint8*>(Ptr2);
    for (SIZE_T Index = 0; Index < Size; ++Index) {
        const uint8 Kept = A[Index];
        A[Index] = B[Index];
        B[Index] = Kept;
    }
}
