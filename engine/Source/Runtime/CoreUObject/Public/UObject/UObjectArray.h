// SPDX-License-Identifier: MIT
// The table of all objects with their serial numbers. Mirrors Epic's "UObject/UObjectArray.h".
#pragma once

#include "UObject/UObjectBase.h"

/** One slot of the object table. */
struct FUObjectItem {
    /** The object, null while the slot is free. */
    UObjectBase* Object = nullptr;
    /** EInternalObjectFlags. */
    int32 Flags = 0;
    int32 ClusterRootIndex = 0;
    /** 0 until somebody takes a weak pointer. Never used twice. */
    int32 SerialNumber = 0;
    /** Number of TStrongObjectPtr on the object. */
    int32 RefCount = 0;

    UObjectBase* GetObject() const { return Object; }
    EInternalObjectFlags GetFlags() const { return static_cast<EInternalObjectFlags>(Flags); }
    bool HasAnyFlags(EInternalObjectFlags InFlags) const { return (Flags & static_cast<int32>(InFlags)) != 0; }
    bool IsUnreachable() const { return HasAnyFlags(EInternalObjectFlags::Unreachable); }
    bool IsGarbage() const { return HasAnyFlags(EInternalObjectFlags::Garbage); }
    bool IsRootSet() const { return HasAnyFlags(EInternalObjectFlags::RootSet); }
    int32 GetSerialNumber() const { return SerialNumber; }
    int32 GetRefCount() const { return RefCount; }
};

/**
 * All objects of the process, by index. Slots never move; an index is given to a new object only after the collection
 * that destroyed its former one, and with a new serial number, so that weak pointers can tell them apart.
 */
class FUObjectArray {
public:
    constexpr FUObjectArray() = default;

    /** Number of slots, free ones included. */
    FORCEINLINE int32 GetObjectArrayNum() const { return NumSlots; }
    /** Number of live objects. */
    FORCEINLINE int32 GetObjectArrayNumMinusAvailable() const { return NumSlots - NumFree; }

    FORCEINLINE int32 ObjectToIndex(const UObjectBase* Object) const { return Object->InternalIndex; }
    /** The slot, or null for an index that was never used. */
    FORCEINLINE FUObjectItem* IndexToObject(int32 Index) {
        return Index >= 0 && Index < NumSlots ? &Chunks[Index / SlotsPerChunk][Index % SlotsPerChunk] : nullptr;
    }
    FORCEINLINE FUObjectItem* ObjectToObjectItem(const UObjectBase* Object) {
        return IndexToObject(Object->InternalIndex);
    }
    /** The slot if it holds an object that is not unreachable (nor garbage, unless bEvenIfGarbage). */
    COREUOBJECT_API FUObjectItem* IndexToObject(int32 Index, bool bEvenIfGarbage);
    /** Serial number of a slot, given out now if it had none. */
    COREUOBJECT_API int32 AllocateSerialNumber(int32 Index);
    FORCEINLINE int32 GetSerialNumber(int32 Index) {
        const FUObjectItem* Item = IndexToObject(Index);
        return Item ? Item->SerialNumber : 0;
    }
    COREUOBJECT_API bool IsValidIndex(const UObjectBase* Object);
    /** True if the object pointer is in the table under its own index. */
    COREUOBJECT_API bool IsValid(const UObjectBase* Object);

    /** Puts an object into a slot; for the object system. */
    COREUOBJECT_API void AllocateUObjectIndex(UObjectBase* Object, EInternalObjectFlags InitialFlags);
    COREUOBJECT_API void FreeUObjectIndex(UObjectBase* Object);

private:
    static constexpr int32 SlotsPerChunk = 16 * 1024;
    static constexpr int32 MaxChunks = 2048;
    FUObjectItem* Chunks[MaxChunks] = {};
    int32 NumSlots = 0;
    int32 NumFree = 0;
    /** Head of the list of free slots, linked through RefCount. The table outlives all static destructors: it is never
     * freed. */
    int32 FirstFree = INDEX_NONE;
};

/** The one object table of the process. */
extern COREUOBJECT_API FUObjectArray GUObjectArray;
