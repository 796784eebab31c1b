// SPDX-License-Identifier: MIT
// FFrame: how native functions get their arguments. Mirrors Epic's "UObject/Stack.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/Class.h"
#include "UObject/UnrealType.h"

/** Where an out-parameter's value is. */
struct FOutParmRec {
    FProperty* Property;
    uint8* PropAddr;
    FOutParmRec* NextOutParm;
};

/**
 * One call. Native functions read their parameters from it one after another, in order of declaration (P_GET_* macros),
 * then call P_FINISH. There is no bytecode: Code is always null.
 */
struct FFrame : public FOutputDevice {
    /** The function being called. */
    UFunction* Node;
    UObject* Object;
    uint8* Code = nullptr;
    /** The parameter block. */
    uint8* Locals;
    FProperty* MostRecentProperty = nullptr;
    uint8* MostRecentPropertyAddress = nullptr;
    uint8* MostRecentPropertyContainer = nullptr;
    FFrame* PreviousFrame = nullptr;
    FOutParmRec* OutParms = nullptr;
    /** The next parameter to be read. */
    FField* PropertyChainForCompiledIn;
    UFunction* CurrentNativeFunction;
    bool bArrayContextFailed = false;

    FFrame(UObject* InObject, UFunction* InNode, void* InLocals, FFrame* InPreviousFrame = nullptr,
        FField* InPropertyChain = nullptr)
        : Node(InNode), Object(InObject), Locals(static_cast<uint8*>(InLocals)), PreviousFrame(InPreviousFrame),
          PropertyChainForCompiledIn(InPropertyChain ? InPropertyChain : InNode->ChildProperties),
          CurrentNativeFunction(InNode) {}

    /** Reads the next parameter into Result (a value of its type; may be null to skip it). */
    template <class TPropertyType>
    void StepCompiledIn(void* const Result) {
        FProperty* Property = NextProperty();
        StepExplicitProperty(Result, Property);
    }
    void StepCompiledIn(void* const Result, const FFieldClass* ExpectedPropertyType) {
        FProperty* Property = NextProperty();
        checkfSlow(Property->IsA(ExpectedPropertyType), TEXT("Wrong parameter type"));
        StepExplicitProperty(Result, Property);
    }
    /** The next parameter by reference: its storage in the caller's block, or TemporaryBuffer with a copy of it. */
    template <class TPropertyType, typename TNativeType>
    TNativeType& StepCompiledInRef(void* const TemporaryBuffer) {
        FProperty* Property = NextProperty();
        MostRecentProperty = Property;
        if (Property->HasAnyPropertyFlags(CPF_OutParm)) {
            MostRecentPropertyAddress = FindOutParm(Property);
            return *reinterpret_cast<TNativeType*>(MostRecentPropertyAddress);
        }
        StepExplicitProperty(TemporaryBuffer, Property);
        return *static_cast<TNativeType*>(TemporaryBuffer);
    }
    COREUOBJECT_API void StepExplicitProperty(void* const Result, FProperty* Property);
    COREUOBJECT_API virtual void Serialize(
        const TCHAR* V, ELogVerbosity::Type Verbosity, const FName& Category) override;

private:
    FProperty* NextProperty() {
        checkf(PropertyChainForCompiledIn, TEXT("%s reads more parameters than it has"), *Node->GetName());
        FProperty* Property = static_cast<FProperty*>(PropertyChainForCompiledIn);
        PropertyChainForCompiledIn = Property->Next;
        return Property;
    }
    uint8* FindOutParm(const FProperty* Property) const {
        for (FOutParmRec* Record = OutParms; Record; Record = Record->NextOutParm) {
            if (Record->Property == Property) {
                return Record->PropAddr;
            }
        }
        return Property->ContainerPtrToValuePtr<uint8>(Locals);
    }
};
