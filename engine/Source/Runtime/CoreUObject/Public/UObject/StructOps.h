// SPDX-License-Identifier: MIT
// Operations of C++ structs through reflection, and the traits that choose them. In UE part of "UObject/Class.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

class FOutputDevice;
class FReferenceCollector;
class UObject;

/** What a USTRUCT's C++ type can do; specialise TStructOpsTypeTraits to change it. */
template <class CPPSTRUCT>
struct TStructOpsTypeTraitsBase2 {
    enum {
        WithZeroConstructor = false,
        WithNoInitConstructor = false,
        WithNoDestructor = false,
        WithCopy = !std::is_trivially_copyable_v<CPPSTRUCT>,
        WithIdenticalViaEquality = false,
        WithIdentical = false,
        WithExportTextItem = false,
        WithImportTextItem = false,
        WithAddStructReferencedObjects = false,
        WithSerializer = false,
        WithStructuredSerializer = false,
        WithPostSerialize = false,
        WithNetSerializer = false,
        WithNetDeltaSerializer = false,
        WithSerializeFromMismatchedTag = false,
        WithStructuredSerializeFromMismatchedTag = false,
        WithPostScriptConstruct = false,
        WithNetSharedSerialization = false,
        WithGetPreloadDependencies = false,
        WithPureVirtual = false,
        WithFindInnerPropertyInstance = false,
        WithCanEditChange = false,
    };
};
template <class CPPSTRUCT>
struct TStructOpsTypeTraits : public TStructOpsTypeTraitsBase2<CPPSTRUCT> {};

/** Type-erased operations of a struct. */
struct ICppStructOps {
    ICppStructOps(int32 InSize, int32 InAlignment) : Size(InSize), Alignment(InAlignment) {}
    virtual ~ICppStructOps() = default;

    int32 GetSize() const { return Size; }
    int32 GetAlignment() const { return Alignment; }
    /** Flags of the struct that follow from its C++ type. */
    virtual EStructFlags GetComputedStructFlags() const = 0;
    /** Flags of properties of this struct that follow from its C++ type. */
    virtual EPropertyFlags GetComputedPropertyFlags() const = 0;
    virtual bool HasNoopConstructor() const = 0;
    virtual bool HasZeroConstructor() const = 0;
    virtual void Construct(void* Dest) = 0;
    virtual bool HasDestructor() const = 0;
    virtual void Destruct(void* Dest) = 0;
    virtual bool IsPlainOldData() const = 0;
    /** Assigns ArrayDim values with operator=; false if it must be done property by property. */
    virtual bool Copy(void* Dest, void const* Src, int32 ArrayDim) = 0;
    virtual bool HasIdentical() const = 0;
    /** Returns true if it compared; the result is in bOutResult. */
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags, bool& bOutResult) = 0;
    virtual bool HasExportTextItem() const = 0;
    virtual bool ExportTextItem(FString& ValueStr, const void* PropertyValue, const void* DefaultValue, UObject* Parent,
        int32 PortFlags, UObject* ExportRootScope) = 0;
    virtual bool HasImportTextItem() const = 0;
    virtual bool ImportTextItem(
        const TCHAR*& Buffer, void* Data, int32 PortFlags, UObject* OwnerObject, FOutputDevice* ErrorText) = 0;
    virtual bool HasAddStructReferencedObjects() const = 0;
    virtual void AddStructReferencedObjects(void* Value, FReferenceCollector& Collector) = 0;
    virtual bool HasGetTypeHash() const = 0;
    virtual uint32 GetStructTypeHash(const void* Src) = 0;
    virtual bool HasPostScriptConstruct() const = 0;
    virtual void PostScriptConstruct(void* Data) = 0;

private:
    const int32 Size;
    const int32 Alignment;
};

/** ICppStructOps of one type. */
template <class CPPSTRUCT>
struct TCppStructOps final : public ICppStructOps {
    typedef TStructOpsTypeTraits<CPPSTRUCT> TTraits;
    static constexpr bool bPlainOldData =
        std::is_trivially_copyable_v<CPPSTRUCT> && std::is_trivially_destructible_v<CPPSTRUCT>;
    static constexpr bool bHasDestructor = !TTraits::WithNoDestructor && !std::is_trivially_destructible_v<CPPSTRUCT>;
    static constexpr bool bHasTypeHash = requires(const CPPSTRUCT& Value) { GetTypeHash(Value); };

    TCppStructOps() : ICppStructOps(sizeof(CPPSTRUCT), alignof(CPPSTRUCT)) {}

    virtual EStructFlags GetComputedStructFlags() const override {
        return (bPlainOldData ? STRUCT_IsPlainOldData : STRUCT_NoFlags) |
               (!bHasDestructor ? STRUCT_NoDestructor : STRUCT_NoFlags) |
               (TTraits::WithZeroConstructor ? STRUCT_ZeroConstructor : STRUCT_NoFlags) |
               (TTraits::WithCopy ? STRUCT_CopyNative : STRUCT_NoFlags) |
               (HasIdentical() ? STRUCT_IdenticalNative : STRUCT_NoFlags) |
               (TTraits::WithExportTextItem ? STRUCT_ExportTextItemNative : STRUCT_NoFlags) |
               (TTraits::WithImportTextItem ? STRUCT_ImportTextItemNative : STRUCT_NoFlags) |
               (TTraits::WithAddStructReferencedObjects ? STRUCT_AddStructReferencedObjects : STRUCT_NoFlags) |
               (TTraits::WithNetSerializer ? STRUCT_NetSerializeNative : STRUCT_NoFlags) |
               (TTraits::WithNetDeltaSerializer ? STRUCT_NetDeltaSerializeNative : STRUCT_NoFlags) |
               (TTraits::WithSerializer || TTraits::WithStructuredSerializer ? STRUCT_SerializeNative
                                                                             : STRUCT_NoFlags) |
               (TTraits::WithPostSerialize ? STRUCT_PostSerializeNative : STRUCT_NoFlags) |
               (TTraits::WithPostScriptConstruct ? STRUCT_PostScriptConstruct : STRUCT_NoFlags) |
               (TTraits::WithNetSharedSerialization ? STRUCT_NetSharedSerialization : STRUCT_NoFlags);
    }
    virtual EPropertyFlags GetComputedPropertyFlags() const override {
        return (bPlainOldData ? CPF_IsPlainOldData : CPF_None) | (!bHasDestructor ? CPF_NoDestructor : CPF_None) |
               (TTraits::WithZeroConstructor ? CPF_ZeroConstructor : CPF_None) |
               (bHasTypeHash ? CPF_HasGetValueTypeHash : CPF_None);
    }
    virtual bool HasNoopConstructor() const override { return false; }
    virtual bool HasZeroConstructor() const override { return TTraits::WithZeroConstructor; }
    virtual void Construct(void* Dest) override {
        if constexpr (TTraits::WithZeroConstructor) {
            FMemory::Memzero(Dest, sizeof(CPPSTRUCT));
        } else if constexpr (TTraits::WithNoInitConstructor) {
            new (Dest) CPPSTRUCT(ForceInit);
        } else {
            // Members without initialiser are zero, as in memory that UE hands out.
            FMemory::Memzero(Dest, sizeof(CPPSTRUCT));
            new (Dest) CPPSTRUCT();
        }
    }
    virtual bool HasDestructor() const override { return bHasDestructor; }
    virtual void Destruct(void* Dest) override {
        if constexpr (bHasDestructor) {
            static_cast<CPPSTRUCT*>(Dest)->~CPPSTRUCT();
        }
    }
    virtual bool IsPlainOldData() const override { return bPlainOldData; }
    virtual bool Copy(void* Dest, void const* Src, int32 ArrayDim) override {
        if constexpr (TTraits::WithCopy) {
            for (int32 Index = 0; Index < ArrayDim; ++Index) {
                static_cast<CPPSTRUCT*>(Dest)[Index] = static_cast<const CPPSTRUCT*>(Src)[Index];
            }
            return true;
        } else {
            return false;
        }
    }
    virtual bool HasIdentical() const override { return TTraits::WithIdentical || TTraits::WithIdenticalViaEquality; }
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags, bool& bOutResult) override {
        if constexpr (TTraits::WithIdentical) {
            bOutResult = static_cast<const CPPSTRUCT*>(A)->Identical(static_cast<const CPPSTRUCT*>(B), PortFlags);
            return true;
        } else if constexpr (TTraits::WithIdenticalViaEquality) {
            bOutResult = *static_cast<const CPPSTRUCT*>(A) == *static_cast<const CPPSTRUCT*>(B);
            return true;
        } else {
            return false;
        }
    }
    virtual bool HasExportTextItem() const override { return TTraits::WithExportTextItem; }
    virtual bool ExportTextItem(FString& ValueStr, const void* PropertyValue, const void* DefaultValue, UObject* Parent,
        int32 PortFlags, UObject* ExportRootScope) override {
        if constexpr (TTraits::WithExportTextItem) {
            const CPPSTRUCT Default{};
            return static_cast<const CPPSTRUCT*>(PropertyValue)
                ->ExportTextItem(ValueStr, DefaultValue ? *static_cast<const CPPSTRUCT*>(DefaultValue) : Default,
                    Parent, PortFlags, ExportRootScope);
        } else {
            return false;
        }
    }
    virtual bool HasImportTextItem() const override { return TTraits::WithImportTextItem; }
    virtual bool ImportTextItem(
        const TCHAR*& Buffer, void* Data, int32 PortFlags, UObject* OwnerObject, FOutputDevice* ErrorText) override {
        if constexpr (TTraits::WithImportTextItem) {
            return static_cast<CPPSTRUCT*>(Data)->ImportTextItem(Buffer, PortFlags, OwnerObject, ErrorText);
        } else {
            return false;
        }
    }
    virtual bool HasAddStructReferencedObjects() const override { return TTraits::WithAddStructReferencedObjects; }
    virtual void AddStructReferencedObjects(void* Value, FReferenceCollector& Collector) override {
        if constexpr (TTraits::WithAddStructReferencedObjects) {
            static_cast<CPPSTRUCT*>(Value)->AddStructReferencedObjects(Collector);
        }
    }
    virtual bool HasGetTypeHash() const override { return bHasTypeHash; }
    virtual uint32 GetStructTypeHash(const void* Src) override {
        if constexpr (bHasTypeHash) {
            return GetTypeHash(*static_cast<const CPPSTRUCT*>(Src));
        } else {
            return 0;
        }
    }
    virtual bool HasPostScriptConstruct() const override { return TTraits::WithPostScriptConstruct; }
    virtual void PostScriptConstruct(void* Data) override {
        if constexpr (TTraits::WithPostScriptConstruct) {
            static_cast<CPPSTRUCT*>(Data)->PostScriptConstruct();
        }
    }
};
