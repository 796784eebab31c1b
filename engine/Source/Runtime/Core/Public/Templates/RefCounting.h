// SPDX-License-Identifier: MIT
/** Intrusive reference counting: FRefCountBase, FThreadSafeRefCountedObject, TRefCountPtr. */
#pragma once

#include <atomic>

#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

/** Counts atomically and deletes itself when the last TRefCountPtr lets go. */
class FRefCountBase {
public:
    FRefCountBase() = default;
    virtual ~FRefCountBase() = default;
    UE_NONCOPYABLE(FRefCountBase)
    uint32 AddRef() const { return static_cast<uint32>(NumRefs.fetch_add(1) + 1); }
    uint32 Release() const {
        const int32 Left = NumRefs.fetch_sub(1) - 1;
        if (Left == 0) {
            delete this;
        }
        return static_cast<uint32>(Left);
    }
    uint32 GetRefCount() const { return static_cast<uint32>(NumRefs.load()); }

private:
    mutable std::atomic<int32> NumRefs{0};
};
using FRefCountedObject = FRefCountBase;
using FThreadSafeRefCountedObject = FRefCountBase;

template <typename ReferencedType>
class TRefCountPtr {
public:
    TRefCountPtr() : Reference(nullptr) {}
    TRefCountPtr(ReferencedType* InReference, bool bAddRef = true) : Reference(InReference) {
        if (Reference && bAddRef) {
            Reference->AddRef();
        }
    }
    TRefCountPtr(const TRefCountPtr& Copy) : TRefCountPtr(Copy.Reference) {}
    template <typename Other>
    explicit TRefCountPtr(const TRefCountPtr<Other>& Copy)
        : TRefCountPtr(static_cast<ReferencedType*>(Copy.GetReference())) {}
    TRefCountPtr(TRefCountPtr&& Move) : Reference(Move.Reference) { Move.Reference = nullptr; }
    ~TRefCountPtr() {
        if (Reference) {
            Reference->Release();
        }
    }
    TRefCountPtr& operator=(ReferencedType* InReference) {
        if (InReference) {
            InReference->AddRef();
        }
        ReferencedType* Old = Reference;
        Reference = InReference;
        if (Old) {
            Old->Release();
        }
        return *this;
    }
    TRefCountPtr& operator=(const TRefCountPtr& Other) { return *this = Other.Reference; }
    TRefCountPtr& operator=(TRefCountPtr&& Other) {
        if (this != &Other) {
            ReferencedType* Old = Reference;
            Reference = Other.Reference;
            Other.Reference = nullptr;
            if (Old) {
                Old->Release();
            }
        }
        return *this;
    }
    ReferencedType* operator->() const { return Reference; }
    operator ReferencedType*() const { return Reference; }
    ReferencedType* GetReference() const { return Reference; }
    bool IsValid() const { return Reference != nullptr; }
    void SafeRelease() { *this = nullptr; }
    uint32 GetRefCount() const { return Reference ? Reference->GetRefCount() : 0; }
    friend uint32 GetTypeHash(const TRefCountPtr& Ptr) { return PointerHash(Ptr.Reference); }

private:
    ReferencedType* Reference;
};
