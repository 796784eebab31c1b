// SPDX-License-Identifier: MIT
// FGCObject: lets plain C++ objects hold references. Mirrors Epic's "UObject/GCObject.h".
#pragma once

#include "UObject/ReferenceCollector.h"
#include "UObject/UObjectGlobals.h"

/** Base of C++ classes that report object references to the garbage collector for as long as they live. */
class FGCObject {
public:
    enum class EFlags : uint32 {
        None = 0,
        RegisterLater = 1 << 0,
        AddStableNativeReferencesOnly = 1 << 1,
    };

    FGCObject() { RegisterGCObject(); }
    explicit FGCObject(EFlags InFlags) {
        if ((static_cast<uint32>(InFlags) & static_cast<uint32>(EFlags::RegisterLater)) == 0) {
            RegisterGCObject();
        }
    }
    FGCObject(const FGCObject&) { RegisterGCObject(); }
    FGCObject(FGCObject&&) { RegisterGCObject(); }
    FGCObject& operator=(const FGCObject&) { return *this; }
    FGCObject& operator=(FGCObject&&) { return *this; }
    virtual ~FGCObject() { UnregisterGCObject(); }

    /** Reports the references. */
    virtual void AddReferencedObjects(FReferenceCollector& Collector) = 0;
    /** Name for reports about who keeps what alive. */
    virtual FString GetReferencerName() const = 0;
    virtual bool GetReferencerPropertyName(UObject* Object, FString& OutPropertyName) const { return false; }

    COREUOBJECT_API void RegisterGCObject();
    COREUOBJECT_API void UnregisterGCObject();
};
