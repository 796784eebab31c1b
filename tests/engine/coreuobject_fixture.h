// SPDX-License-Identifier: MIT
// Helpers of the reflection tests: calls with a parameter block that reflection lays out.
#pragma once

#include <doctest/doctest.h>

#include "CoreUObject.h"
#include "ReflectionTestTypes.h"
#include "UObject/NoExportTypes.h"

namespace reflection_test {
/** A new subject that nothing refers to. */
inline UReflectionSubject* MakeSubject() { return NewObject<UReflectionSubject>(); }

/** One call: set arguments by name, run, read results by name. */
class FCall {
public:
    FCall(UObject* InObject, const TCHAR* Name) : Object(InObject), Function(InObject->FindFunction(FName(Name))) {
        REQUIRE(Function != nullptr);
        Block.Initialize(Function);
    }
    template <typename T>
    T& At(const TCHAR* Name) {
        FProperty* Property = Function->FindPropertyByName(FName(Name));
        REQUIRE(Property != nullptr);
        REQUIRE(static_cast<SIZE_T>(Property->GetSize()) == sizeof(T));
        return *Property->ContainerPtrToValuePtr<T>(Block.GetStructMemory());
    }
    template <typename T>
    FCall& Set(const TCHAR* Name, const T& Value) {
        At<T>(Name) = Value;
        return *this;
    }
    FCall& Run() {
        Object->ProcessEvent(Function, Block.GetStructMemory());
        return *this;
    }
    template <typename T>
    T& Result() {
        return At<T>(TEXT("ReturnValue"));
    }
    UFunction* GetFunction() const { return Function; }

private:
    UObject* Object;
    UFunction* Function;
    FStructOnScope Block;
};

/** The text of a property of an object. */
inline FString ExportOf(const UObject* Object, const TCHAR* Name, int32 PortFlags = PPF_None) {
    FProperty* Property = Object->GetClass()->FindPropertyByName(FName(Name));
    REQUIRE(Property != nullptr);
    FString Text;
    Property->ExportTextItem_InContainer(Text, Object, nullptr, nullptr, PortFlags);
    return Text;
}

/** Reads text into a property of an object; true if all of it was used. */
inline bool ImportInto(UObject* Object, const TCHAR* Name, const TCHAR* Text) {
    FProperty* Property = Object->GetClass()->FindPropertyByName(FName(Name));
    REQUIRE(Property != nullptr);
    const TCHAR* End = Property->ImportText_InContainer(Text, Object, Object, PPF_None);
    return End && *End == 0;
}
} // namespace reflection_test
