// SPDX-License-Identifier: MIT
#include "Engine/Texture2D.h"

#include "UObject/Package.h"

namespace {

constexpr int32 MaxTextureSize = 16384;

}

UTexture::UTexture(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer), SRGB(1), Filter(TF_Default) {}

UTexture2D::UTexture2D(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer), AddressX(TA_Wrap), AddressY(TA_Wrap) {}

UTexture2D* UTexture2D::CreateTransient(int32 InSizeX, int32 InSizeY, EPixelFormat InFormat, const FName InName) {
    const int32 BytesPerPixel = GetBytesPerPixel(InFormat);
    if (InSizeX < 1 || InSizeY < 1 || InSizeX > MaxTextureSize || InSizeY > MaxTextureSize || BytesPerPixel == 0) {
        UE_LOG(LogTemp, Warning,
            TEXT("UTexture2D::CreateTransient cannot make a texture of %d x %d texels of format %d; sizes go from 1 to "
                 "%d"),
            InSizeX, InSizeY, static_cast<int32>(InFormat), MaxTextureSize);
        return nullptr;
    }
    UTexture2D* Result = NewObject<UTexture2D>(GetTransientPackageAsObject(), InName, RF_Transient);
    TArray<uint8> Zeros;
    Zeros.SetNumZeroed(InSizeX * InSizeY * BytesPerPixel);
    FString Error;
    Result->SetPixels(InSizeX, InSizeY, InFormat, MoveTemp(Zeros), Error);
    return Result;
}

int32 UTexture2D::Blueprint_GetSizeX() const { return GetSizeX(); }

int32 UTexture2D::Blueprint_GetSizeY() const { return GetSizeY(); }

float UTexture2D::GetSurfaceWidth() const { return static_cast<float>(SizeX); }

float UTexture2D::GetSurfaceHeight() const { return static_cast<float>(SizeY); }

bool UTexture2D::SetPixels(
    int32 InSizeX, int32 InSizeY, EPixelFormat InFormat, TArray<uint8>&& InPixels, FString& OutError) {
    const int32 BytesPerPixel = GetBytesPerPixel(InFormat);
    if (BytesPerPixel == 0) {
        OutError = FString::Printf(TEXT("%s: pixel format %d is not one of PF_B8G8R8A8, PF_R8G8B8A8 and PF_G8"),
            *GetPathName(), static_cast<int32>(InFormat));
        return false;
    }
    if (InSizeX < 1 || InSizeY < 1 || InSizeX > MaxTextureSize || InSizeY > MaxTextureSize ||
        static_cast<int64>(InSizeX) * InSizeY * BytesPerPixel != InPixels.Num()) {
        OutError = FString::Printf(TEXT("%s: %d bytes do not make %d x %d texels of %d bytes (sizes go from 1 to %d)"),
            *GetPathName(), InPixels.Num(), InSizeX, InSizeY, BytesPerPixel, MaxTextureSize);
        return false;
    }
    SizeX = InSizeX;
    SizeY = InSizeY;
    PixelFormat = InFormat;
    Pixels = MoveTemp(InPixels);
    ++PixelsRevision;
    return true;
}

int32 UTexture2D::GetBytesPerPixel(EPixelFormat InFormat) {
    switch (InFormat) {
    case PF_B8G8R8A8:
    case PF_R8G8B8A8:
        return 4;
    case PF_G8:
        return 1;
    default:
        return 0;
    }
}
