// SPDX-License-Identifier: MIT
/** @file Messages on the screen. */
#include "Engine/Engine.h"
#include "Misc/App.h"

void UEngine::AddOnScreenDebugMessage(
    uint64 Key, float TimeToDisplay, FColor DisplayColor, const FString& DebugMessage) {
    constexpr uint64 NoKey = static_cast<uint64>(-1);
    // Old messages go when new ones come: nobody need look at the list for it to stay small.
    GetOnScreenDebugMessages();
    FScreenMessageString Message;
    Message.Key = Key;
    Message.ScreenMessage = DebugMessage;
    Message.DisplayColor = DisplayColor;
    Message.ExpireTime = FApp::GetCurrentTime() + TimeToDisplay;
    if (Key != NoKey) {
        for (FScreenMessageString& Existing : ScreenMessages) {
            if (Existing.Key == Key) {
                Existing = Message;
                return;
            }
        }
    }
    ScreenMessages.Add(Message);
}

bool UEngine::OnScreenDebugMessageExists(uint64 Key) {
    return GetOnScreenDebugMessages().ContainsByPredicate(
        [Key](const FScreenMessageString& Message) { return Message.Key == Key; });
}

void UEngine::ClearOnScreenDebugMessages() { ScreenMessages.Empty(); }

const TArray<FScreenMessageString>& UEngine::GetOnScreenDebugMessages() {
    const double Now = FApp::GetCurrentTime();
    ScreenMessages.RemoveAll([Now](const FScreenMessageString& Message) { return Message.ExpireTime <= Now; });
    return ScreenMessages;
}
