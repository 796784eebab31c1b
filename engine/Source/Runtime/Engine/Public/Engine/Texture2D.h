// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/Texture.h"
#include "PixelFormat.h"

#include "Texture2D.generated.h"

/**
 * A two-dimensional image whose pixels are in main memory (UE: UTexture2D, Engine/Texture2D.h).
 */
UCLASS(BlueprintType)
class ENGINE_API UTexture2D : public UTexture {
    GENERATED_BODY()

public:
    /** What U outside 0..1 means. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Texture", meta = (DisplayName = "X-axis Tiling Method"))
    TEnumAsByte<enum TextureAddress> AddressX;

    /** What V outside 0..1 means. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Texture", meta = (DisplayName = "Y-axis Tiling Method"))
    TEnumAsByte<enum TextureAddress> AddressY;

    UTexture2D(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /**
     * Makes an empty texture in the transient package (UE: UTexture2D::CreateTransient).
     *
     * @param InSizeX  width in texels, 1 to 16384.
     * @param InSizeY  height in texels, 1 to 16384.
     * @param InFormat PF_B8G8R8A8, PF_R8G8B8A8 or PF_G8.
     * @param InName   object name, or none for a unique one.
     * @return the texture with all bytes zero, or null (and a log line) for a size or format outside these.
     */
    static UTexture2D* CreateTransient(
        int32 InSizeX, int32 InSizeY, EPixelFormat InFormat = PF_B8G8R8A8, const FName InName = NAME_None);

    /** Width in texels, 0 without pixels. */
    int32 GetSizeX() const { return SizeX; }

    /** Height in texels, 0 without pixels. */
    int32 GetSizeY() const { return SizeY; }

    /** Width in texels, for Blueprint. */
    UFUNCTION(
        BlueprintCallable, meta = (DisplayName = "GetSizeX", ScriptName = "GetSizeX"), Category = "Rendering|Texture")
    int32 Blueprint_GetSizeX() const;

    /** Height in texels, for Blueprint. */
    UFUNCTION(
        BlueprintCallable, meta = (DisplayName = "GetSizeY", ScriptName = "GetSizeY"), Category = "Rendering|Texture")
    int32 Blueprint_GetSizeY() const;

    /** Format of the pixels; PF_Unknown without pixels. */
    EPixelFormat GetPixelFormat(uint32 LayerIndex = 0u) const { return LayerIndex == 0u ? PixelFormat : PF_Unknown; }

    virtual float GetSurfaceWidth() const override;
    virtual float GetSurfaceHeight() const override;

    /**
     * The pixels, row by row from the top, GetSizeX() * bytes-per-pixel bytes a row with no padding: 4 bytes a pixel
     * for PF_B8G8R8A8 and PF_R8G8B8A8, 1 for PF_G8. Embedded engine only (UE: GetPlatformData()->Mips[0].BulkData).
     */
    const TArray<uint8>& GetPixels() const { return Pixels; }

    /**
     * Replaces size, format and pixels. Embedded engine only.
     *
     * @param InPixels rows from the top without padding, exactly InSizeX * InSizeY * bytes-per-pixel bytes.
     * @param OutError what was refused.
     * @return whether size, format and byte count fit together; if not, the texture keeps what it had.
     */
    bool SetPixels(int32 InSizeX, int32 InSizeY, EPixelFormat InFormat, TArray<uint8>&& InPixels, FString& OutError);

    /** Grows with every SetPixels, so that a renderer knows when to build its mips again. Embedded engine only. */
    uint32 GetPixelsRevision() const { return PixelsRevision; }

    /** Bytes of one pixel in a format this class stores, 0 for any other. Embedded engine only. */
    static int32 GetBytesPerPixel(EPixelFormat InFormat);

private:
    TArray<uint8> Pixels;
    int32 SizeX = 0;
    int32 SizeY = 0;
    EPixelFormat PixelFormat = PF_Unknown;
    uint32 PixelsRevision = 0;
};
