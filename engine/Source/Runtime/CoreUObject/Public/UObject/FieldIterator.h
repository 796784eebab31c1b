// SPDX-License-Identifier: MIT
// TFieldIterator: walks properties or functions of a struct. In UE it lives in "UObject/UnrealType.h", which includes
// this file.
#pragma once

#include "UObject/Class.h"
#include "UObject/Property.h"

/** Which fields an iteration visits. */
enum class EFieldIterationFlags : uint8 {
    None = 0,
    IncludeSuper = 1 << 0,
    IncludeDeprecated = 1 << 1,
    IncludeInterfaces = 1 << 2,
    IncludeAll = IncludeSuper | IncludeDeprecated | IncludeInterfaces,
    Default = IncludeSuper | IncludeDeprecated,
};
ENUM_CLASS_FLAGS(EFieldIterationFlags)

namespace EFieldIteratorFlags {
enum SuperClassFlags { ExcludeSuper = 0, IncludeSuper };
enum DeprecatedPropertyFlags { ExcludeDeprecated = 0, IncludeDeprecated = 1 << 0 };
enum InterfaceClassFlags { ExcludeInterfaces = 0, IncludeInterfaces = 1 << 1 };
} // namespace EFieldIteratorFlags

/**
 * Walks the fields of type T (a property class, or UFunction) of a struct: own ones in order of declaration, then those
 * of interfaces (if asked), then of the super.
 */
template <class T>
class TFieldIterator {
    static constexpr bool bIsObjectField = std::is_base_of_v<UField, T>;
    using FBaseField = std::conditional_t<bIsObjectField, UField, FField>;

public:
    TFieldIterator(const UStruct* InStruct, EFieldIterationFlags InIterationFlags = EFieldIterationFlags::Default)
        : Struct(InStruct), Field(First(InStruct)), Flags(InIterationFlags) {
        SkipToMatch();
    }
    TFieldIterator(const UStruct* InStruct, EFieldIteratorFlags::SuperClassFlags SuperClassFlags,
        EFieldIteratorFlags::DeprecatedPropertyFlags DeprecatedFlags = EFieldIteratorFlags::IncludeDeprecated,
        EFieldIteratorFlags::InterfaceClassFlags InterfaceFlags = EFieldIteratorFlags::ExcludeInterfaces)
        : TFieldIterator(
              InStruct, (SuperClassFlags ? EFieldIterationFlags::IncludeSuper : EFieldIterationFlags::None) |
                            (DeprecatedFlags ? EFieldIterationFlags::IncludeDeprecated : EFieldIterationFlags::None) |
                            (InterfaceFlags ? EFieldIterationFlags::IncludeInterfaces : EFieldIterationFlags::None)) {}
    explicit operator bool() const { return Field != nullptr; }
    bool operator!() const { return Field == nullptr; }
    bool operator==(const TFieldIterator& Other) const { return Field == Other.Field; }
    void operator++() {
        Field = Field->Next;
        SkipToMatch();
    }
    T* operator*() const { return static_cast<T*>(Field); }
    T* operator->() const { return static_cast<T*>(Field); }
    /** The struct that declares the current field. */
    const UStruct* GetStruct() const { return Struct; }

private:
    static FBaseField* First(const UStruct* InStruct) {
        if constexpr (bIsObjectField) {
            return InStruct ? InStruct->Children.Get() : nullptr;
        } else {
            return InStruct ? InStruct->ChildProperties : nullptr;
        }
    }
    bool Matches() const {
        if constexpr (bIsObjectField) {
            return Field->IsA(T::StaticClass());
        } else {
            return Field->template IsA<T>() &&
                   (EnumHasAnyFlags(Flags, EFieldIterationFlags::IncludeDeprecated) ||
                       !Field->template IsA<FProperty>() ||
                       !static_cast<FProperty*>(static_cast<FField*>(Field))->HasAnyPropertyFlags(CPF_Deprecated));
        }
    }
    void SkipToMatch() {
        for (;;) {
            while (Field && !Matches()) {
                Field = Field->Next;
            }
            if (Field || !Struct) {
                return;
            }
            NextStruct();
        }
    }
    void NextStruct() {
        // Interfaces of a class come after its own fields and before its super.
        if (!InterfaceOwner && EnumHasAnyFlags(Flags, EFieldIterationFlags::IncludeInterfaces)) {
            InterfaceOwner = Cast<UClass>(Struct);
            InterfaceIndex = 0;
        }
        if (InterfaceOwner) {
            if (InterfaceIndex < InterfaceOwner->Interfaces.Num()) {
                Struct = InterfaceOwner->Interfaces[InterfaceIndex++].Class;
                Field = First(Struct);
                return;
            }
            Struct = InterfaceOwner;
            InterfaceOwner = nullptr;
        }
        Struct = EnumHasAnyFlags(Flags, EFieldIterationFlags::IncludeSuper) ? Struct->GetSuperStruct() : nullptr;
        Field = First(Struct);
    }

    const UStruct* Struct;
    FBaseField* Field;
    EFieldIterationFlags Flags;
    const UClass* InterfaceOwner = nullptr;
    int32 InterfaceIndex = 0;
};

/** Range-for over the fields of a struct. */
template <class T>
class TFieldRange {
public:
    TFieldRange(const UStruct* InStruct, EFieldIterationFlags InIterationFlags = EFieldIterationFlags::Default)
        : Begin(InStruct, InIterationFlags) {}
    TFieldIterator<T> begin() const { return Begin; }
    TFieldIterator<T> end() const { return TFieldIterator<T>(nullptr); }

private:
    TFieldIterator<T> Begin;
};
