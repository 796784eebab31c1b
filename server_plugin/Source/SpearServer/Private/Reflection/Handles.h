// SPDX-License-Identifier: MIT
#pragma once

// Objects as a session names them: a slot (low 32 bits) with a generation (high 32 bits), resolved to a weak pointer at
// each use. The same object has the same handle as long as it lives; a dead one is the error StaleObject, never a
// crash.

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/StrongObjectPtr.h"
#include "UObject/WeakObjectPtr.h"

#include "Frame/Result.h"

#include <deque>
#include <unordered_map>
#include <vector>

namespace SpearServer {

/// Rises with each garbage collection: until the next one, an object that was found alive keeps its memory, though it may
/// be destroyed. Game thread.
inline uint32 GarbageEpoch = 1;

class FHandleTable {
public:
    /// The object's handle; 0 for null.
    uint64 HandleOf(const UObject* Object);

    /// The living object of a handle, null for 0. StaleObject if it was destroyed (also if it only waits to be
    /// collected) or if the handle was never given.
    TSpearResult<UObject*> Resolve(uint64 Handle) const;
    /// Like Resolve, but null is the error NullObject.
    TSpearResult<UObject*> ResolveNonNull(uint64 Handle) const;
    /// The same for an object that is no class and was resolved since the last garbage collection; null otherwise, which
    /// says nothing.
    UObject* ResolveAgain(uint64 Handle) const;
    /// Whether the handle names a living object.
    bool IsAlive(uint64 Handle) const;

    /// Keeps an object from being collected until Release or the end of the session.
    void KeepAlive(UObject* Object);
    /// False if the object was not kept.
    bool Release(UObject* Object);

    /// Frees the slots of objects that were collected. The next object in such a slot gets a new generation.
    void Sweep();

private:
    struct FSlot {
        FWeakObjectPtr Object;
        uint32 Generation = 1;
        bool bFree = false;
        FName Name; ///< for the message of StaleObject
        FName Class;
    };
    /// What is known of the object of a slot, until the next garbage collection.
    enum class EAlive : uint8 { Object, Actor, Component };
    struct FResolved {
        UObject* Object = nullptr;
        uint32 Generation = 0;
        uint32 Epoch = 0;
        EAlive Alive = EAlive::Object;
    };
    static uint64 Compose(uint32 Slot, uint32 Generation) { return (static_cast<uint64>(Generation) << 32) | Slot; }
    const FSlot* Find(uint64 Handle) const;

    std::deque<FSlot> Slots;
    mutable std::vector<FResolved> Resolved; ///< by slot; may be shorter
    std::deque<uint32>
        FreeSlots; ///< the one freed longest ago is used first, so that stale handles keep their names long
    std::unordered_map<const UObject*, uint32> SlotOf;
    std::unordered_map<const UObject*, TStrongObjectPtr<UObject>> Kept;
};

/// Whether the object can be used: not null, not destroyed, not about to be.
bool IsUsable(const UObject* Object);

} // namespace SpearServer
