// SPDX-License-Identifier: MIT
#pragma once

// Object arguments of entry points as the objects they mean.

#include "CoreMinimal.h"
#include "UObject/Object.h"

#include "SpearText.h"

#include "Frame/EntryPointTable.h"
#include "Frame/Session.h"
#include "Reflection/TypePlan.h"
#include "Reflection/ValueWriter.h"
#include "Reflection/Worlds.h"

#include "Engine/World.h"

#include "spear/entry_points/types.hpp"

namespace SpearServer {

/// The object, which must not be null and must be a T. NullObject, StaleObject, WrongType.
template <typename T>
TSpearResult<T*> ResolveArgument(FOperation& Operation, const spear::ObjectRef& Reference, const char* Argument) {
    TSpearResult<UObject*> Object = Operation.Session->Handles.ResolveNonNull(Reference.handle);
    if (!Object.IsOk()) {
        Object.GetError().argument = Argument;
        return std::move(Object.GetError());
    }
    T* Typed = Cast<T>(Object.GetValue());
    if (!Typed) {
        const std::string Expected = CppNameOf(T::StaticClass()) + "*";
        return MakeError(ErrorCode::WrongType,
            "argument '" + std::string(Argument) + "' must be " + Expected + ", not the " +
                CppNameOf(Object.GetValue()->GetClass()) + " '" + ToUtf8(Object.GetValue()->GetName()) + "'",
            Argument, Expected);
    }
    return Typed;
}

/// The world; null means the primary one. UnknownObject if there is none.
inline TSpearResult<UWorld*> ResolveWorld(FOperation& Operation, const spear::ObjectRef& Reference) {
    if (Reference.handle != 0) {
        return ResolveArgument<UWorld>(Operation, Reference, "world");
    }
    if (UWorld* World = GetPrimaryWorld()) {
        return World;
    }
    return MakeError(ErrorCode::UnknownObject, "there is no world yet", "world");
}

} // namespace SpearServer
