// SPDX-License-Identifier: MIT
/** FCrc: CRC-32 and the string hashes. */
#pragma once

#include "Misc/Char.h"

struct FCrc {
    /** CRC-32 (polynomial 0xEDB88320) of a block; pass an earlier result to go on. */
    static CORE_API uint32 MemCrc32(const void* Data, int32 Length, uint32 CRC = 0);
    template <typename T>
    static uint32 TypeCrc32(const T& Data, uint32 CRC = 0) {
        return MemCrc32(&Data, sizeof(T), CRC);
    }
    /** Of a terminated string: each character counts as 4 bytes, so the result does not depend on the character type.
     */
    template <typename CharType>
    static uint32 StrCrc32(const CharType* Data, uint32 CRC = 0) {
        for (; *Data; ++Data) {
            CRC = MemCrc32Char(TChar<CharType>::ToUnsigned(*Data), CRC);
        }
        return CRC;
    }
    /** Hash in which case does not count. */
    template <typename CharType>
    static uint32 StrihashSpan(const CharType* Data, int32 Length) {
        uint32 Hash = 2166136261u;
        for (int32 Index = 0; Index < Length; ++Index) {
            Hash = (Hash ^ TChar<CharType>::ToUnsigned(TChar<CharType>::ToLower(Data[Index]))) * 16777619u;
        }
        return Hash ^ (Hash >> 15);
    }
    template <typename CharType>
    static uint32 Strihash_DEPRECATED(const CharType* Data) {
        int32 Length = 0;
        while (Data[Length]) {
            ++Length;
        }
        return StrihashSpan(Data, Length);
    }

private:
    static CORE_API uint32 MemCrc32Char(uint32 Char, uint32 CRC);
};
