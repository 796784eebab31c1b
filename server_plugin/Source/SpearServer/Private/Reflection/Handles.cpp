// SPDX-License-Identifier: MIT
#include "Reflection/Handles.h"

#include "SpearText.h"

#include "Components/ActorComponent.h"
#include "GameFramework/Actor.h"
#include "UObject/Class.h"

namespace SpearServer {

bool IsUsable(const UObject* Object) {
    if (!IsValid(Object)) {
        return false;
    }
    if (const AActor* Actor = Cast<AActor>(Object)) {
        return !Actor->IsActorBeingDestroyed();
    }
    if (const UActorComponent* Component = Cast<UActorComponent>(Object)) {
        return !Component->IsBeingDestroyed();
    }
    return true;
}

uint64 FHandleTable::HandleOf(const UObject* Object) {
    if (!Object) {
        return 0;
    }
    const FWeakObjectPtr Weak(Object);
    const auto [At, bIsNew] = SlotOf.try_emplace(Object, 0u);
    if (!bIsNew) {
        const FSlot& Slot = Slots[At->second];
        if (Slot.Object.HasSameIndexAndSerialNumber(Weak)) {
            return Compose(At->second, Slot.Generation);
        }
        // Another object at the same address: the old slot is freed by the next sweep.
    }
    uint32 Index = 0;
    if (!FreeSlots.empty()) {
        Index = FreeSlots.front();
        FreeSlots.pop_front();
        ++Slots[Index].Generation;
    } else {
        Index = static_cast<uint32>(Slots.size());
        Slots.emplace_back();
    }
    FSlot& Slot = Slots[Index];
    Slot.Object = Weak;
    Slot.bFree = false;
    Slot.Name = Object->GetFName();
    Slot.Class = Object->GetClass()->GetFName();
    At->second = Index;
    return Compose(Index, Slot.Generation);
}

const FHandleTable::FSlot* FHandleTable::Find(uint64 Handle) const {
    const uint32 Index = static_cast<uint32>(Handle);
    if (Index >= Slots.size() || Slots[Index].Generation != static_cast<uint32>(Handle >> 32)) {
        return nullptr;
    }
    return &Slots[Index];
}

bool FHandleTable::IsAlive(uint64 Handle) const {
    const FSlot* Slot = Find(Handle);
    return Slot && !Slot->bFree && IsUsable(Slot->Object.Get());
}

TSpearResult<UObject*> FHandleTable::Resolve(uint64 Handle) const {
    if (Handle == 0) {
        return static_cast<UObject*>(nullptr);
    }
    const FSlot* Slot = Find(Handle);
    if (!Slot) {
        return MakeError(ErrorCode::StaleObject, "the object has been destroyed (or its handle is of another session)");
    }
    UObject* Object = Slot->bFree ? nullptr : Slot->Object.Get();
    if (!IsUsable(Object)) {
        return MakeError(
            ErrorCode::StaleObject, "the " + ToUtf8(Slot->Class) + " '" + ToUtf8(Slot->Name) + "' has been destroyed");
    }
    if (!Object->IsA<UClass>()) {
        const auto Index = static_cast<uint32>(Handle);
        if (Index >= Resolved.size()) {
            Resolved.resize(Slots.size());
        }
        Resolved[Index] = {Object, Slot->Generation, GarbageEpoch,
            Object->IsA<AActor>()            ? EAlive::Actor
            : Object->IsA<UActorComponent>() ? EAlive::Component
                                             : EAlive::Object};
    }
    return Object;
}

UObject* FHandleTable::ResolveAgain(uint64 Handle) const {
    const auto Index = static_cast<uint32>(Handle);
    if (Index >= Resolved.size()) {
        return nullptr;
    }
    const FResolved& Known = Resolved[Index];
    if (Known.Epoch != GarbageEpoch || Known.Generation != static_cast<uint32>(Handle >> 32) ||
        !IsValid(Known.Object)) {
        return nullptr;
    }
    switch (Known.Alive) {
    case EAlive::Actor:
        return static_cast<AActor*>(Known.Object)->IsActorBeingDestroyed() ? nullptr : Known.Object;
    case EAlive::Component:
        return static_cast<UActorComponent*>(Known.Object)->IsBeingDestroyed() ? nullptr : Known.Object;
    default:
        return Known.Object;
    }
}

TSpearResult<UObject*> FHandleTable::ResolveNonNull(uint64 Handle) const {
    if (Handle == 0) {
        return MakeError(ErrorCode::NullObject, "an object is needed here, not null");
    }
    return Resolve(Handle);
}

void FHandleTable::KeepAlive(UObject* Object) { Kept.insert_or_assign(Object, TStrongObjectPtr<UObject>(Object)); }

bool FHandleTable::Release(UObject* Object) { return Kept.erase(Object) != 0; }

void FHandleTable::Sweep() {
    for (uint32 Index = 0; Index < Slots.size(); ++Index) {
        FSlot& Slot = Slots[Index];
        if (!Slot.bFree && Slot.Object.IsStale(false)) {
            Slot.bFree = true;
            FreeSlots.push_back(Index);
        }
    }
    for (auto At = SlotOf.begin(); At != SlotOf.end();) {
        At = Slots[At->second].bFree ? SlotOf.erase(At) : std::next(At);
    }
}

} // namespace SpearServer
