// SPDX-License-Identifier: MIT
#include "Misc/Crc.h"

namespace {

struct FCrcTable {
    uint32 Values[256];
    FCrcTable() {
        for (uint32 Index = 0; Index < 256; ++Index) {
            uint32 Value = Index;
            for (int32 Bit = 0; Bit < 8; ++Bit) {
                Value = (Value & 1u) ? (Value >> 1) ^ 0xEDB88320u : Value >> 1;
            }
            Values[Index] = Value;
        }
    }
};

const FCrcTable& GetCrcTable() {
    static const FCrcTable Table;
    return Table;
}

} // namespace

uint32 FCrc::MemCrc32(const void* Data, int32 Length, uint32 CRC) {
    const FCrcTable& Table = GetCrcTable();
    const uint8* Bytes = static_cast<const uint8*>(Data);
    CRC = ~CRC;
    for (int32 Index = 0; Index < Length; ++Index) {
        CRC = (CRC >> 8) ^ Table.Values[(CRC ^ Bytes[Index]) & 0xffu];
    }
    return ~CRC;
}

uint32 FCrc::MemCrc32Char(uint32 Char, uint32 CRC) { return MemCrc32(&Char, sizeof(Char), CRC); }
