// SPDX-License-Identifier: MIT
#include "PhysicsEngine/BodyInstance.h"
#include "Engine/CollisionProfile.h"

FBodyInstance::FBodyInstance()
    : CollisionProfileName(UCollisionProfile::CustomCollisionProfileName),
      CollisionEnabled(ECollisionEnabled::QueryAndPhysics), ObjectType(ECC_WorldStatic), CollisionResponses(ECR_Block) {
}

void FBodyInstance::InvalidateCollisionProfileName() {
    CollisionProfileName = UCollisionProfile::CustomCollisionProfileName;
}

void FBodyInstance::SetCollisionEnabled(ECollisionEnabled::Type NewType) {
    if (CollisionEnabled != NewType) {
        CollisionEnabled = NewType;
        InvalidateCollisionProfileName();
    }
}

void FBodyInstance::SetObjectType(ECollisionChannel Channel) {
    if (ObjectType != Channel) {
        ObjectType = Channel;
        InvalidateCollisionProfileName();
    }
}

bool FBodyInstance::SetResponseToChannel(ECollisionChannel Channel, ECollisionResponse NewResponse) {
    const bool bChanged = CollisionResponses.SetResponse(Channel, NewResponse);
    if (bChanged) {
        InvalidateCollisionProfileName();
    }
    return bChanged;
}

bool FBodyInstance::SetResponseToAllChannels(ECollisionResponse NewResponse) {
    const bool bChanged = CollisionResponses.SetAllChannels(NewResponse);
    if (bChanged) {
        InvalidateCollisionProfileName();
    }
    return bChanged;
}

bool FBodyInstance::SetResponseToChannels(const FCollisionResponseContainer& NewResponses) {
    const bool bChanged = CollisionResponses != NewResponses;
    if (bChanged) {
        CollisionResponses = NewResponses;
        InvalidateCollisionProfileName();
    }
    return bChanged;
}

void FBodyInstance::SetCollisionProfileName(FName InCollisionProfileName) {
    CollisionProfileName = InCollisionProfileName;
    FCollisionResponseTemplate Profile;
    if (UCollisionProfile::Get()->GetProfileTemplate(InCollisionProfileName, Profile)) {
        CollisionEnabled = Profile.CollisionEnabled;
        ObjectType = Profile.ObjectType;
        CollisionResponses = Profile.ResponseToChannels;
    }
}
