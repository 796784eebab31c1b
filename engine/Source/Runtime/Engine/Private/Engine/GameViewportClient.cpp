// SPDX-License-Identifier: MIT
#include "Engine/GameViewportClient.h"

#include "Engine/Engine.h"
#include "Engine/GameInstance.h"
#include "Engine/LocalPlayer.h"
#include "Misc/CommandLine.h"
#include "Misc/Parse.h"

UGameViewportClient::UGameViewportClient(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer), Size(1280, 720) {}

void UGameViewportClient::Init(FWorldContext& WorldContext, UGameInstance* OwningGameInstance, bool) {
    GameInstance = OwningGameInstance;
    World = WorldContext.World();
    int32 SizeX = Size.X;
    int32 SizeY = Size.Y;
    FParse::Value(FCommandLine::Get(), TEXT("-ResX="), SizeX);
    FParse::Value(FCommandLine::Get(), TEXT("-ResY="), SizeY);
    SetViewportSize(SizeX, SizeY);
}

ULocalPlayer* UGameViewportClient::SetupInitialLocalPlayer(FString& OutError) {
    return GameInstance->GetFirstGamePlayer() ? GameInstance->GetFirstGamePlayer()
                                              : GameInstance->CreateInitialPlayer(OutError);
}

void UGameViewportClient::GetViewportSize(FVector2D& ViewportSize) const { ViewportSize = FVector2D(Size.X, Size.Y); }

void UGameViewportClient::SetViewportSize(int32 X, int32 Y) { Size = FIntPoint(FMath::Max(1, X), FMath::Max(1, Y)); }
