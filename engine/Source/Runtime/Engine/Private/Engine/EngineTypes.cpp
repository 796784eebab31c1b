// SPDX-License-Identifier: MIT
#include "Engine/EngineTypes.h"

FAttachmentTransformRules FAttachmentTransformRules::KeepRelativeTransform(EAttachmentRule::KeepRelative, false);
FAttachmentTransformRules FAttachmentTransformRules::KeepWorldTransform(EAttachmentRule::KeepWorld, false);
FAttachmentTransformRules FAttachmentTransformRules::SnapToTargetNotIncludingScale(
    EAttachmentRule::SnapToTarget, EAttachmentRule::SnapToTarget, EAttachmentRule::KeepWorld, false);
FAttachmentTransformRules FAttachmentTransformRules::SnapToTargetIncludingScale(EAttachmentRule::SnapToTarget, false);

FDetachmentTransformRules FDetachmentTransformRules::KeepRelativeTransform(EDetachmentRule::KeepRelative, true);
FDetachmentTransformRules FDetachmentTransformRules::KeepWorldTransform(EDetachmentRule::KeepWorld, true);

const TCHAR* LexToString(const EWorldType::Type Value) {
    switch (Value) {
    case EWorldType::None:
        return TEXT("None");
    case EWorldType::Game:
        return TEXT("Game");
    case EWorldType::Editor:
        return TEXT("Editor");
    case EWorldType::PIE:
        return TEXT("PIE");
    case EWorldType::EditorPreview:
        return TEXT("EditorPreview");
    case EWorldType::GamePreview:
        return TEXT("GamePreview");
    case EWorldType::GameRPC:
        return TEXT("GameRPC");
    case EWorldType::Inactive:
        return TEXT("Inactive");
    }
    return TEXT("Unknown");
}

namespace {
// The container is one byte per channel in the order of ECollisionChannel, so that its bytes are the table.
constexpr int32 NumCollisionChannels = ECC_OverlapAll_Deprecated;
static_assert(sizeof(TEnumAsByte<ECollisionResponse>) == 1);
static_assert(sizeof(FCollisionResponseContainer) == NumCollisionChannels, "one response byte per channel");

TEnumAsByte<ECollisionResponse>* Responses(FCollisionResponseContainer& Container) {
    return reinterpret_cast<TEnumAsByte<ECollisionResponse>*>(&Container);
}

const TEnumAsByte<ECollisionResponse>* Responses(const FCollisionResponseContainer& Container) {
    return reinterpret_cast<const TEnumAsByte<ECollisionResponse>*>(&Container);
}
} // namespace

FCollisionResponseContainer::FCollisionResponseContainer(ECollisionResponse DefaultResponse) {
    // Not by SetAllChannels: it compares with what is there, and nothing is yet.
    for (int32 Channel = 0; Channel < NumCollisionChannels; ++Channel) {
        Responses(*this)[Channel] = DefaultResponse;
    }
}

bool FCollisionResponseContainer::SetResponse(ECollisionChannel Channel, ECollisionResponse NewResponse) {
    if (Channel < 0 || Channel >= NumCollisionChannels || Responses(*this)[Channel] == NewResponse) {
        return false;
    }
    Responses(*this)[Channel] = NewResponse;
    return true;
}

bool FCollisionResponseContainer::SetAllChannels(ECollisionResponse NewResponse) {
    bool bChanged = false;
    for (int32 Channel = 0; Channel < NumCollisionChannels; ++Channel) {
        bChanged |= SetResponse(static_cast<ECollisionChannel>(Channel), NewResponse);
    }
    return bChanged;
}

bool FCollisionResponseContainer::ReplaceChannels(ECollisionResponse OldResponse, ECollisionResponse NewResponse) {
    bool bChanged = false;
    for (int32 Channel = 0; Channel < NumCollisionChannels; ++Channel) {
        if (Responses(*this)[Channel] == OldResponse) {
            bChanged |= SetResponse(static_cast<ECollisionChannel>(Channel), NewResponse);
        }
    }
    return bChanged;
}

ECollisionResponse FCollisionResponseContainer::GetResponse(ECollisionChannel Channel) const {
    return Channel >= 0 && Channel < NumCollisionChannels ? Responses(*this)[Channel].GetValue() : ECR_Ignore;
}

FCollisionResponseContainer FCollisionResponseContainer::CreateMinContainer(
    const FCollisionResponseContainer& A, const FCollisionResponseContainer& B) {
    FCollisionResponseContainer Result;
    for (int32 Channel = 0; Channel < NumCollisionChannels; ++Channel) {
        Responses(Result)[Channel] = FMath::Min(Responses(A)[Channel].GetValue(), Responses(B)[Channel].GetValue());
    }
    return Result;
}

bool FCollisionResponseContainer::operator==(const FCollisionResponseContainer& Other) const {
    for (int32 Channel = 0; Channel < NumCollisionChannels; ++Channel) {
        if (Responses(*this)[Channel] != Responses(Other)[Channel]) {
            return false;
        }
    }
    return true;
}
