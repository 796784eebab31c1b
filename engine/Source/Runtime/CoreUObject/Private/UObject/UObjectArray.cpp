// SPDX-License-Identifier: MIT
#include "UObject/UObjectArray.h"

#include <atomic>

#include "UObject/Object.h"

constinit FUObjectArray GUObjectArray;

namespace {
/** Serial numbers are given to slots on demand and never twice, so a stale weak pointer can never match again. */
std::atomic<int32> GNextSerialNumber{1000};
} // namespace

FUObjectItem* FUObjectArray::IndexToObject(int32 Index, bool bEvenIfGarbage) {
    FUObjectItem* Item = IndexToObject(Index);
    if (!Item || !Item->Object || Item->IsUnreachable() || (!bEvenIfGarbage && Item->IsGarbage())) {
        return nullptr;
    }
    return Item;
}

int32 FUObjectArray::AllocateSerialNumber(int32 Index) {
    FUObjectItem* Item = IndexToObject(Index);
    check(Item);
    std::atomic_ref<int32> Serial(Item->SerialNumber);
    int32 Current = Serial.load();
    if (Current == 0) {
        const int32 Fresh = GNextSerialNumber.fetch_add(1);
        checkf(Fresh > 0, TEXT("Serial numbers of weak object pointers are used up"));
        if (Serial.compare_exchange_strong(Current, Fresh)) {
            Current = Fresh;
        }
    }
    return Current;
}

bool FUObjectArray::IsValidIndex(const UObjectBase* Object) {
    return Object && IndexToObject(Object->InternalIndex) != nullptr;
}

bool FUObjectArray::IsValid(const UObjectBase* Object) {
    const FUObjectItem* Item = Object ? IndexToObject(Object->InternalIndex) : nullptr;
    return Item && Item->Object == Object;
}

void FUObjectArray::AllocateUObjectIndex(UObjectBase* Object, EInternalObjectFlags InitialFlags) {
    int32 Index;
    if (FirstFree != INDEX_NONE) {
        Index = FirstFree;
        FirstFree = IndexToObject(Index)->RefCount;
        --NumFree;
    } else {
        Index = NumSlots;
        const int32 Chunk = Index / SlotsPerChunk;
        checkf(Chunk < MaxChunks, TEXT("More than %d objects are alive"), MaxChunks * SlotsPerChunk);
        if (!Chunks[Chunk]) {
            Chunks[Chunk] = new FUObjectItem[SlotsPerChunk];
        }
        ++NumSlots;
    }
    FUObjectItem* Item = IndexToObject(Index);
    *Item = FUObjectItem();
    Item->Object = Object;
    Item->Flags = static_cast<int32>(InitialFlags);
    Object->InternalIndex = Index;
}

void FUObjectArray::FreeUObjectIndex(UObjectBase* Object) {
    const int32 Index = Object->InternalIndex;
    FUObjectItem* Item = IndexToObject(Index);
    check(Item && Item->Object == Object);
    *Item = FUObjectItem();
    Item->RefCount = FirstFree;
    FirstFree = Index;
    ++NumFree;
    Object->InternalIndex = INDEX_NONE;
}
