// SPDX-License-Identifier: MIT
// Helpers of container properties' text. Private to the module.
#pragma once

#include "PropertyText.h"
#include "UObject/UnrealType.h"

namespace PropertyText {
inline FString FullCPPType(const FProperty* Property) {
    FString Extended;
    const FString Type = Property->GetCPPType(&Extended);
    return Type + Extended;
}
/** An inner value in memory of its own while it is being read. */
class FScopedValue {
public:
    explicit FScopedValue(const FProperty* InProperty)
        : Property(InProperty), Memory(InProperty->AllocateAndInitializeValue()) {}
    ~FScopedValue() { Property->DestroyAndFreeValue(Memory); }
    void* Get() const { return Memory; }
    void Reset() { Property->ClearValue(Memory); }
    UE_NONCOPYABLE(FScopedValue)

private:
    const FProperty* Property;
    void* Memory;
};
inline const TCHAR* BadContainer(
    FOutputDevice* ErrorText, const FProperty* Property, const TCHAR* Expected, const FReader& Reader) {
    Report(ErrorText,
        FString::Printf(TEXT("%s: %s is expected, found '%s'"), *Property->GetName(), Expected, *Reader.Rest()));
    return nullptr;
}
/** Reads "(a,b,c)", calling ReadElement with a cursor for each element. */
template <typename TReadElement>
const TCHAR* ImportList(
    const FProperty* Property, const TCHAR* Buffer, FOutputDevice* ErrorText, const TReadElement& ReadElement) {
    FReader Reader(Buffer);
    Reader.SkipSpace();
    if (!Reader.Accept('(')) {
        return BadContainer(ErrorText, Property, TEXT("'('"), Reader);
    }
    Reader.SkipSpace();
    while (!Reader.Accept(')')) {
        const TCHAR* After = ReadElement(Reader.Cursor());
        if (!After) {
            return nullptr;
        }
        Reader.Set(After);
        Reader.SkipSpace();
        if (!Reader.Accept(',') && !Reader.Is(')')) {
            return BadContainer(ErrorText, Property, TEXT("',' or ')'"), Reader);
        }
        Reader.SkipSpace();
    }
    return Reader.Cursor();
}
inline FField* FieldIfNamed(FField* Field, const FName& Name) {
    return Field && Field->GetFName() == Name ? Field : nullptr;
}
} // namespace PropertyText
