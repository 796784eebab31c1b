// SPDX-License-Identifier: MIT
#pragma once

// The numbers under which one session has announced the server's types: structs, arrays, enums, classes of objects.

#include "CoreMinimal.h"

#include "Reflection/TypePlan.h"

#include "spear/codec.hpp"
#include "spear/encode.hpp"

#include <unordered_map>
#include <vector>

namespace SpearServer {

/// The name of an enum's entry without the enum's scope: as it is announced.
std::string ShortNameOfEntry(const UEnum* Enum, int32 Index);

class FTypeNumbers {
public:
    const spear::TypeTable& Table() const { return Announcer.table(); }

    /// The number of the plan's type; announces it (and what it is made of) the first time.
    spear::TypeId NumberOf(const FTypePlan& Plan);
    /// The announced class (with its super classes).
    spear::TypeId NumberOf(const UClass* Class);
    /// The number of a type that no property has: results of functions.
    spear::TypeId NumberOf(const spear::TypeInfo& Info) { return Announcer.number_of(Info); }
    /// struct FScriptDelegate {Object: object, FunctionName: string}
    spear::TypeId DelegateNumber();

    bool HasPending() const { return Announcer.has_pending(); }
    /// Announcements that go ahead of the next reply.
    spear::ByteBuffer TakePending() { return Announcer.take_pending(); }
    /// Forgets classes that were collected (their numbers stay given).
    void Sweep();

private:
    struct FClassNumber {
        FWeakObjectPtr Class;
        spear::TypeId Number = 0;
    };

    spear::TypeAnnouncer Announcer{spear::types::first_server_type};
    std::vector<spear::TypeId> Numbers; ///< by FTypePlan::Index; 0: not announced
    std::unordered_map<const UClass*, FClassNumber> ClassNumbers;
    spear::TypeId Delegate = 0;
};

} // namespace SpearServer
