// SPDX-License-Identifier: MIT
/** TOptional: a value or nothing. Layout as UE's: the value's bytes, then a bool. */
#pragma once

#include "Templates/TypeCompatibleBytes.h"
#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

struct FNullOpt {
    explicit constexpr FNullOpt(int) {}
};
inline constexpr FNullOpt NullOpt{0};

template <typename OptionalType>
struct TOptional {
public:
    using ElementType = OptionalType;

    TOptional() = default;
    TOptional(FNullOpt) {}
    TOptional(const OptionalType& InValue) { Emplace(InValue); }
    TOptional(OptionalType&& InValue) { Emplace(MoveTempIfPossible(InValue)); }
    template <typename... ArgTypes>
    explicit TOptional(EInPlace, ArgTypes&&... Args) {
        Emplace(Forward<ArgTypes>(Args)...);
    }
    TOptional(const TOptional& Other) { *this = Other; }
    TOptional(TOptional&& Other) { *this = MoveTemp(Other); }
    ~TOptional() { Reset(); }

    TOptional& operator=(const TOptional& Other) {
        if (this != &Other) {
            Reset();
            if (Other.bIsSet) {
                Emplace(Other.GetValue());
            }
        }
        return *this;
    }
    TOptional& operator=(TOptional&& Other) {
        if (this != &Other) {
            Reset();
            if (Other.bIsSet) {
                Emplace(MoveTempIfPossible(Other.GetValue()));
            }
        }
        return *this;
    }
    TOptional& operator=(const OptionalType& InValue) {
        if (&InValue != Storage.GetTypedPtr()) {
            Emplace(InValue);
        }
        return *this;
    }
    TOptional& operator=(OptionalType&& InValue) {
        if (&InValue != Storage.GetTypedPtr()) {
            Emplace(MoveTempIfPossible(InValue));
        }
        return *this;
    }

    void Reset() {
        if (bIsSet) {
            bIsSet = false;
            using FDestroyed = OptionalType;
            Storage.GetTypedPtr()->FDestroyed::~FDestroyed();
        }
    }
    template <typename... ArgsType>
    OptionalType& Emplace(ArgsType&&... Args) {
        Reset();
        OptionalType* Result = ::new (static_cast<void*>(Storage.Pad)) OptionalType(Forward<ArgsType>(Args)...);
        bIsSet = true;
        return *Result;
    }
    bool IsSet() const { return bIsSet; }
    explicit operator bool() const { return bIsSet; }
    OptionalType& GetValue() {
        checkf(bIsSet,
            TEXT("It is an error to call GetValue() on an unset TOptional. Check IsSet() or use Get(DefaultValue)."));
        return *Storage.GetTypedPtr();
    }
    const OptionalType& GetValue() const {
        checkf(bIsSet,
            TEXT("It is an error to call GetValue() on an unset TOptional. Check IsSet() or use Get(DefaultValue)."));
        return *Storage.GetTypedPtr();
    }
    OptionalType* operator->() { return &GetValue(); }
    const OptionalType* operator->() const { return &GetValue(); }
    OptionalType& operator*() { return GetValue(); }
    const OptionalType& operator*() const { return GetValue(); }
    const OptionalType& Get(const OptionalType& DefaultValue) const {
        return bIsSet ? *Storage.GetTypedPtr() : DefaultValue;
    }
    OptionalType* GetPtrOrNull() { return bIsSet ? Storage.GetTypedPtr() : nullptr; }
    const OptionalType* GetPtrOrNull() const { return bIsSet ? Storage.GetTypedPtr() : nullptr; }

    bool operator==(const TOptional& Other) const {
        return bIsSet == Other.bIsSet && (!bIsSet || *Storage.GetTypedPtr() == *Other.Storage.GetTypedPtr());
    }
    friend uint32 GetTypeHash(const TOptional& Optional) { return Optional.bIsSet ? GetTypeHashHelper(*Optional) : 0; }

private:
    TTypeCompatibleBytes<OptionalType> Storage;
    bool bIsSet = false;
};
