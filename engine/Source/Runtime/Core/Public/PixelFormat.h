// SPDX-License-Identifier: MIT
/** EPixelFormat: formats of textures. Only those the engine can make; the numbers are UE's. */
#pragma once

#include "CoreTypes.h"

enum EPixelFormat : uint8 {
    PF_Unknown = 0,
    PF_A32B32G32R32F = 1,
    PF_B8G8R8A8 = 2,
    PF_G8 = 3,
    PF_G16 = 4,
    PF_FloatRGBA = 10,
    PF_R32_FLOAT = 13,
    PF_R16F = 21,
    PF_A8 = 29,
    PF_R32_UINT = 30,
    PF_R8G8B8A8 = 37,
    PF_MAX = 97,
};

/** Bytes of one pixel, or 0 for formats without pixels of their own. */
inline uint32 GetPixelFormatBlockBytes(EPixelFormat Format) {
    switch (Format) {
    case PF_A32B32G32R32F:
        return 16;
    case PF_FloatRGBA:
        return 8;
    case PF_B8G8R8A8:
    case PF_R8G8B8A8:
    case PF_R32_FLOAT:
    case PF_R32_UINT:
        return 4;
    case PF_G16:
    case PF_R16F:
        return 2;
    case PF_G8:
    case PF_A8:
        return 1;
    default:
        return 0;
    }
}
