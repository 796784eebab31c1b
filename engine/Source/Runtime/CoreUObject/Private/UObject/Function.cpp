// SPDX-License-Identifier: MIT
// UFunction, FFrame and calls through reflection.
#include "UObject/Class.h"
#include "UObject/Object.h"
#include "UObject/Package.h"
#include "UObject/Stack.h"
#include "UObject/UnrealType.h"
#include "PropertyText.h"

DEFINE_LOG_CATEGORY_STATIC(LogScript, Log, All);

void UFunction::Link(bool bComputeLayout) {
    UStruct::Link(bComputeLayout);
    InitializeDerivedMembers();
}

void UFunction::InitializeDerivedMembers() {
    NumParms = 0;
    ParmsSize = 0;
    ReturnValueOffset = 0xFFFF;
    FirstPropertyToInit = nullptr;
    for (FField* Field = ChildProperties; Field; Field = Field->Next) {
        FProperty* Property = static_cast<FProperty*>(Field);
        if (!Property->HasAnyPropertyFlags(CPF_Parm)) {
            continue;
        }
        ++NumParms;
        const int32 End = Property->GetOffset_ForUFunction() + Property->GetSize();
        checkf(End <= 0xFFFF, TEXT("The parameters of %s take more than 64 KiB"), *GetPathName());
        ParmsSize = static_cast<uint16>(FMath::Max<int32>(ParmsSize, End));
        if (Property->HasAnyPropertyFlags(CPF_ReturnParm)) {
            ReturnValueOffset = static_cast<uint16>(Property->GetOffset_ForUFunction());
        }
    }
}

void UFunction::Bind() {
    UClass* Class = GetOuterUClass();
    if (Class && HasAnyFunctionFlags(FUNC_Native)) {
        for (const FNativeFunctionLookup& Entry : Class->NativeFunctionLookupTable) {
            if (Entry.Name == GetFName()) {
                Func = Entry.Pointer;
            }
        }
        checkf(Func, TEXT("Native function %s has no C++ thunk"), *GetPathName());
    }
}

void UFunction::Invoke(UObject* Obj, FFrame& Stack, RESULT_DECL) {
    checkf(Func, TEXT("%s has no native function"), *GetPathName());
    // Thunks of interfaces expect the address of the I-class.
    UClass* OuterClass = GetOuterUClass();
    if (OuterClass && OuterClass->HasAnyClassFlags(CLASS_Interface) && !HasAnyFunctionFlags(FUNC_Static)) {
        Obj = static_cast<UObject*>(Obj->GetInterfaceAddress(OuterClass));
        checkf(Obj, TEXT("%s called on an object that does not implement the interface"), *GetPathName());
    }
    Func(Obj, Stack, RESULT_PARAM);
}

UClass* UFunction::GetOuterUClass() const { return Cast<UClass>(GetOuter()); }
UFunction* UFunction::GetSuperFunction() const { return Cast<UFunction>(GetSuperStruct()); }
FProperty* UFunction::GetReturnProperty() const {
    for (FField* Field = ChildProperties; Field; Field = Field->Next) {
        FProperty* Property = static_cast<FProperty*>(Field);
        if (Property->HasAnyPropertyFlags(CPF_ReturnParm)) {
            return Property;
        }
    }
    return nullptr;
}
bool UFunction::IsSignatureCompatibleWith(const UFunction* OtherFunction) const {
    if (this == OtherFunction) {
        return true;
    }
    if (!OtherFunction || NumParms != OtherFunction->NumParms) {
        return false;
    }
    const FField* A = ChildProperties;
    const FField* B = OtherFunction->ChildProperties;
    for (; A && B; A = A->Next, B = B->Next) {
        const FProperty* PropertyA = static_cast<const FProperty*>(A);
        const FProperty* PropertyB = static_cast<const FProperty*>(B);
        const uint64 Compared = CPF_ReturnParm | CPF_OutParm;
        if (!PropertyA->SameType(PropertyB) ||
            (PropertyA->PropertyFlags & Compared) != (PropertyB->PropertyFlags & Compared)) {
            return false;
        }
    }
    return A == nullptr && B == nullptr;
}

// ---------------------------------------------------------------------------------------------------------------------------

void FFrame::StepExplicitProperty(void* const Result, FProperty* Property) {
    MostRecentProperty = Property;
    MostRecentPropertyAddress = Property->HasAnyPropertyFlags(CPF_OutParm)
                                    ? FindOutParm(Property)
                                    : Property->ContainerPtrToValuePtr<uint8>(Locals);
    if (Result) {
        Property->CopyCompleteValueToScriptVM(Result, MostRecentPropertyAddress);
    }
}
void FFrame::Serialize(const TCHAR* V, ELogVerbosity::Type, const FName&) {
    UE_LOG(LogScript, Warning, TEXT("%s: %s"), *GetPathNameSafe(Node), V);
}
void RPC_ValidateFailed(const TCHAR* Reason) {
    UE_LOG(LogScript, Warning, TEXT("A remote call was refused by %s"), Reason);
}

UFunction* UObject::FindFunction(FName InName) const { return GetClass()->FindFunctionByName(InName); }
UFunction* UObject::FindFunctionChecked(FName InName) const {
    UFunction* Result = FindFunction(InName);
    checkf(Result, TEXT("Failed to find function %s in %s"), *InName.ToString(), *GetFullName());
    return Result;
}

void UObject::ProcessEvent(UFunction* Function, void* Parms) {
    checkf(Function, TEXT("ProcessEvent on %s: no function was given"), *GetFullName());
    checkf(!IsUnreachable(), TEXT("%s called on an unreachable object"), *Function->GetName());
    // As UE: objects that are garbage take no calls, and an event that nobody implements does nothing.
    if (!IsValidChecked(this) || !Function->HasAnyFunctionFlags(FUNC_Native)) {
        return;
    }
    FFrame Frame(this, Function, Parms, nullptr, Function->ChildProperties);
    FOutParmRec OutRecords[MAX_FUNC_PARMS];
    FOutParmRec** Tail = &Frame.OutParms;
    int32 NumOut = 0;
    for (FField* Field = Function->ChildProperties; Field; Field = Field->Next) {
        FProperty* Property = static_cast<FProperty*>(Field);
        if (Property->HasAllPropertyFlags(CPF_Parm | CPF_OutParm)) {
            FOutParmRec& Record = OutRecords[NumOut++];
            Record = {Property, Property->ContainerPtrToValuePtr<uint8>(Parms), nullptr};
            *Tail = &Record;
            Tail = &Record.NextOutParm;
        }
    }
    uint8* const ReturnAddress =
        Function->ReturnValueOffset != 0xFFFF ? static_cast<uint8*>(Parms) + Function->ReturnValueOffset : nullptr;
    Function->Invoke(this, Frame, ReturnAddress);
}

bool UObject::CallFunctionByNameWithArguments(
    const TCHAR* Cmd, FOutputDevice& Ar, UObject* Executor, bool bForceCallWithNonExec) {
    PropertyText::FReader Reader(Cmd);
    Reader.SkipSpace();
    const FString Name = Reader.ReadName();
    UFunction* Function = Name.IsEmpty() ? nullptr : FindFunction(FName(*Name, FNAME_Find));
    if (!Function || !(Function->HasAnyFunctionFlags(FUNC_Exec) || bForceCallWithNonExec)) {
        return false;
    }
    uint8* Parms = static_cast<uint8*>(
        FMemory::MallocZeroed(static_cast<SIZE_T>(FMath::Max<int32>(Function->GetStructureSize(), 1)),
            static_cast<uint32>(Function->GetMinAlignment())));
    Function->InitializeStruct(Parms);
    bool bFailed = false;
    for (FField* Field = Function->ChildProperties; Field && !bFailed; Field = Field->Next) {
        FProperty* Property = static_cast<FProperty*>(Field);
        if (Property->HasAnyPropertyFlags(CPF_ReturnParm)) {
            continue;
        }
        // The executor stands in for a first object parameter, as for console commands.
        FObjectProperty* ObjectProperty = CastField<FObjectProperty>(Property);
        if (ObjectProperty && Executor && Field == Function->ChildProperties &&
            Executor->IsA(ObjectProperty->PropertyClass)) {
            ObjectProperty->SetObjectPropertyValue_InContainer(Parms, Executor);
            continue;
        }
        Reader.SkipSpace();
        if (Reader.AtEnd()) {
#if WITH_METADATA
            const FString* Default = Function->FindMetaData(*(FString(TEXT("CPP_Default_")) + Property->GetName()));
            if (Default) {
                Property->ImportText_Direct(
                    **Default, Property->ContainerPtrToValuePtr<void>(Parms), this, PPF_None, &Ar);
                continue;
            }
#endif
            Ar.Logf(TEXT("'%s': parameter '%s' is missing"), *Name, *Property->GetName());
            bFailed = true;
            break;
        }
        // A last string parameter takes the rest of the line.
        const bool bLast = !Field->Next || static_cast<FProperty*>(Field->Next)->HasAnyPropertyFlags(CPF_ReturnParm);
        if (bLast && Property->IsA<FStrProperty>() && !Reader.Is('"')) {
            static_cast<FStrProperty*>(Property)->SetPropertyValue_InContainer(Parms, FString(Reader.Cursor()));
            break;
        }
        const TCHAR* After = Property->ImportText_Direct(
            Reader.Cursor(), Property->ContainerPtrToValuePtr<void>(Parms), this, PPF_Delimited, &Ar);
        if (!After) {
            Ar.Logf(TEXT("'%s': bad value for parameter '%s'"), *Name, *Property->GetName());
            bFailed = true;
        } else {
            Reader.Set(After);
        }
    }
    if (!bFailed) {
        ProcessEvent(Function, Parms);
    }
    Function->DestroyStruct(Parms);
    FMemory::Free(Parms);
    return !bFailed;
}
