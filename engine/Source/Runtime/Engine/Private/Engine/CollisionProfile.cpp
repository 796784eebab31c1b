// SPDX-License-Identifier: MIT
#include "Engine/CollisionProfile.h"

#include <string_view>

const FName UCollisionProfile::NoCollision_ProfileName(TEXT("NoCollision"));
const FName UCollisionProfile::BlockAll_ProfileName(TEXT("BlockAll"));
const FName UCollisionProfile::PhysicsActor_ProfileName(TEXT("PhysicsActor"));
const FName UCollisionProfile::BlockAllDynamic_ProfileName(TEXT("BlockAllDynamic"));
const FName UCollisionProfile::Pawn_ProfileName(TEXT("Pawn"));
const FName UCollisionProfile::CustomCollisionProfileName(TEXT("Custom"));

namespace {

// The responses of a profile where they differ from blocking everything: one letter for each of the first eight
// channels (WorldStatic, WorldDynamic, Pawn, Visibility, Camera, PhysicsBody, Vehicle, Destructible): Block, Overlap,
// Ignore.
struct FProfileRow {
    const TCHAR* Name;
    ECollisionEnabled::Type Enabled;
    ECollisionChannel Channel;
    const TCHAR* ChannelName;
    const char* Responses;
};

constexpr FProfileRow ProfileRows[] = {
    {TEXT("NoCollision"), ECollisionEnabled::NoCollision, ECC_WorldStatic, TEXT("WorldStatic"), "IIIIIIII"},
    {TEXT("BlockAll"), ECollisionEnabled::QueryAndPhysics, ECC_WorldStatic, TEXT("WorldStatic"), "BBBBBBBB"},
    {TEXT("OverlapAll"), ECollisionEnabled::QueryOnly, ECC_WorldStatic, TEXT("WorldStatic"), "OOOOOOOO"},
    {TEXT("BlockAllDynamic"), ECollisionEnabled::QueryAndPhysics, ECC_WorldDynamic, TEXT("WorldDynamic"), "BBBBBBBB"},
    {TEXT("OverlapAllDynamic"), ECollisionEnabled::QueryOnly, ECC_WorldDynamic, TEXT("WorldDynamic"), "OOOOOOOO"},
    {TEXT("IgnoreOnlyPawn"), ECollisionEnabled::QueryOnly, ECC_WorldDynamic, TEXT("WorldDynamic"), "BBIBBBIB"},
    {TEXT("OverlapOnlyPawn"), ECollisionEnabled::QueryOnly, ECC_WorldDynamic, TEXT("WorldDynamic"), "BBOBIBOB"},
    {TEXT("Pawn"), ECollisionEnabled::QueryAndPhysics, ECC_Pawn, TEXT("Pawn"), "BBBIBBBB"},
    {TEXT("Spectator"), ECollisionEnabled::QueryOnly, ECC_Pawn, TEXT("Pawn"), "BIIIIIII"},
    {TEXT("CharacterMesh"), ECollisionEnabled::QueryOnly, ECC_Pawn, TEXT("Pawn"), "BBIIBBIB"},
    {TEXT("PhysicsActor"), ECollisionEnabled::QueryAndPhysics, ECC_PhysicsBody, TEXT("PhysicsBody"), "BBBBBBBB"},
    {TEXT("Destructible"), ECollisionEnabled::QueryAndPhysics, ECC_Destructible, TEXT("Destructible"), "BBBBBBBB"},
    {TEXT("InvisibleWall"), ECollisionEnabled::QueryAndPhysics, ECC_WorldStatic, TEXT("WorldStatic"), "BBBIBBBB"},
    {TEXT("InvisibleWallDynamic"), ECollisionEnabled::QueryAndPhysics, ECC_WorldDynamic, TEXT("WorldDynamic"),
        "BBBIBBBB"},
    {TEXT("Trigger"), ECollisionEnabled::QueryOnly, ECC_WorldDynamic, TEXT("WorldDynamic"), "OOOIOOOO"},
    {TEXT("Ragdoll"), ECollisionEnabled::QueryAndPhysics, ECC_PhysicsBody, TEXT("PhysicsBody"), "BBIIBBBB"},
    {TEXT("Vehicle"), ECollisionEnabled::QueryAndPhysics, ECC_Vehicle, TEXT("Vehicle"), "BBBBBBBB"},
    {TEXT("UI"), ECollisionEnabled::QueryOnly, ECC_WorldDynamic, TEXT("WorldDynamic"), "OOOBOOOO"},
};

ECollisionResponse ToResponse(char Letter) {
    return Letter == 'B' ? ECR_Block : (Letter == 'O' ? ECR_Overlap : ECR_Ignore);
}

} // namespace

FCollisionResponseTemplate::FCollisionResponseTemplate()
    : CollisionEnabled(ECollisionEnabled::NoCollision), bCanModify(false), ObjectType(ECC_WorldStatic),
      ResponseToChannels(ECR_Block) {}

UCollisionProfile::UCollisionProfile(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    for (const FProfileRow& Row : ProfileRows) {
        FCollisionResponseTemplate Profile;
        Profile.Name = FName(Row.Name);
        Profile.CollisionEnabled = Row.Enabled;
        Profile.ObjectTypeName = FName(Row.ChannelName);
        Profile.ObjectType = Row.Channel;
        // A profile that blocks, overlaps or ignores everything means channels that projects add, too.
        const bool bUniform =
            std::string_view(Row.Responses).find_first_not_of(Row.Responses[0]) == std::string_view::npos;
        Profile.ResponseToChannels.SetAllChannels(bUniform ? ToResponse(Row.Responses[0]) : ECR_Block);
        for (int32 Index = 0; Index < 8; ++Index) {
            Profile.ResponseToChannels.SetResponse(
                static_cast<ECollisionChannel>(Index), ToResponse(Row.Responses[Index]));
        }
        Profiles.Add(Profile);
    }
}

UCollisionProfile* UCollisionProfile::Get() { return GetMutableDefault<UCollisionProfile>(); }

bool UCollisionProfile::GetProfileTemplate(FName ProfileName, FCollisionResponseTemplate& ProfileData) const {
    for (const FCollisionResponseTemplate& Profile : Profiles) {
        if (Profile.Name == ProfileName) {
            ProfileData = Profile;
            return true;
        }
    }
    return false;
}
