// SPDX-License-Identifier: MIT
/** FMemory: the engine's heap and memory block operations. */
#pragma once

#include <cstring>

#include "CoreTypes.h"

enum { DEFAULT_ALIGNMENT = 0, MIN_ALIGNMENT = 8 };

struct FMemory {
    /** Aborts with a message when memory is exhausted, so the result is never null (Count 0 included). */
    static CORE_API void* Malloc(SIZE_T Count, uint32 Alignment = DEFAULT_ALIGNMENT);
    static CORE_API void* MallocZeroed(SIZE_T Count, uint32 Alignment = DEFAULT_ALIGNMENT);
    /** Count 0 frees and returns null. */
    static CORE_API void* Realloc(void* Original, SIZE_T Count, uint32 Alignment = DEFAULT_ALIGNMENT);
    static CORE_API void Free(void* Original);
    /** Usable size of a block of this heap. */
    static CORE_API SIZE_T GetAllocSize(void* Original);
    static SIZE_T QuantizeSize(SIZE_T Count, uint32 /*Alignment*/ = DEFAULT_ALIGNMENT) {
        return (Count + 15) & ~SIZE_T(15);
    }

    static void* SystemMalloc(SIZE_T Size) { return Malloc(Size); }
    static void SystemFree(void* Ptr) { Free(Ptr); }

    static void* Memmove(void* Dest, const void* Src, SIZE_T Count) {
        return Count ? std::memmove(Dest, Src, Count) : Dest;
    }
    static int32 Memcmp(const void* Buf1, const void* Buf2, SIZE_T Count) {
        return Count ? std::memcmp(Buf1, Buf2, Count) : 0;
    }
    static void* Memset(void* Dest, uint8 Char, SIZE_T Count) { return Count ? std::memset(Dest, Char, Count) : Dest; }
    template <class T>
    static void Memset(T& Src, uint8 ValueToSet) {
        Memset(static_cast<void*>(&Src), ValueToSet, sizeof(T));
    }
    static void* Memzero(void* Dest, SIZE_T Count) { return Memset(Dest, 0, Count); }
    template <class T>
    static void Memzero(T& Src) {
        Memzero(static_cast<void*>(&Src), sizeof(T));
    }
    static void* Memcpy(void* Dest, const void* Src, SIZE_T Count) {
        return Count ? std::memcpy(Dest, Src, Count) : Dest;
    }
    template <class T>
    static void Memcpy(T& Dest, const T& Src) {
        Memcpy(static_cast<void*>(&Dest), static_cast<const void*>(&Src), sizeof(T));
    }
    static CORE_API void Memswap(void* Ptr1, void* Ptr2, SIZE_T Size);
    static bool MemIsZero(const void* Ptr, SIZE_T Count) {
        for (SIZE_T Index = 0; Index < Count; ++Index) {
            if (static_cast<const uint8*>(Ptr)[Index] != 0) {
                return false;
            }
        }
        return true;
    }
};

/** Stack memory for the current function. */
#define FMemory_Alloca(Size)                                                                                           \
    ((Size) == 0 ? nullptr : (void*)(((UPTRINT)__builtin_alloca((Size) + 15) + 15) & ~UPTRINT(15)))
#define FMemory_Alloca_Aligned(Size, Alignment)                                                                        \
    ((Size) == 0 ? nullptr                                                                                             \
                 : (void*)(((UPTRINT)__builtin_alloca((Size) + (Alignment) - 1) + (Alignment) - 1) &                   \
                           ~((UPTRINT)(Alignment) - 1)))
