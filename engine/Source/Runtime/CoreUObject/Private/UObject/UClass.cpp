// SPDX-License-Identifier: MIT
// UClass.
#include "ObjectSystem.h"
#include "UObject/Class.h"
#include "UObject/Package.h"
#include "UObject/UObjectHash.h"
#include "UObject/UnrealType.h"

UClass::~UClass() = default;

void UClass::SetSuperStruct(UStruct* NewSuperStruct) {
    UStruct::SetSuperStruct(NewSuperStruct);
    FObjectSystem::NoteSuperClass(this, static_cast<UClass*>(NewSuperStruct));
}

const TCHAR* UClass::GetPrefixCPP() const {
    static const FName ActorName(TEXT("Actor"));
    bool bIsActor = false;
    for (const UClass* Class = this; Class && !bIsActor; Class = Class->GetSuperClass()) {
        bIsActor = Class->GetFName() == ActorName;
    }
    if (HasAnyClassFlags(CLASS_Deprecated)) {
        return bIsActor ? TEXT("ADEPRECATED_") : TEXT("UDEPRECATED_");
    }
    return bIsActor ? TEXT("A") : TEXT("U");
}

FString UClass::GetConfigName() const { return ClassConfigName.ToString(); }

FName UClass::GetDefaultObjectName() const { return FName(*(FString(TEXT("Default__")) + GetName())); }

UObject* UClass::CreateDefaultObject() {
    if (ClassDefaultObject) {
        return ClassDefaultObject;
    }
    checkf(HasAnyClassFlags(CLASS_Constructed),
        TEXT("Class %s is not registered yet, its class default object cannot be made"), *GetPathName());
    if (UClass* SuperClass = GetSuperClass()) {
        SuperClass->GetDefaultObject();
    }
    // Constructors may ask for this class default object, so the pointer is set before they run.
    void* Memory =
        FObjectSystem::AllocateObject(static_cast<SIZE_T>(GetPropertiesSize()), static_cast<SIZE_T>(GetMinAlignment()));
    ClassDefaultObject = static_cast<UObject*>(Memory);
    const EObjectFlags Flags = RF_Public | RF_ClassDefaultObject | RF_ArchetypeObject | RF_NeedInitialization;
    FStaticConstructObjectParameters Params(this);
    Params.Outer = GetOuter();
    Params.Name = GetDefaultObjectName();
    Params.SetFlags = Flags;
    FObjectSystem::SetNextIdentity(this, GetOuter(), Params.Name, Flags, EInternalObjectFlags::None);
    {
        FObjectInitializer Initializer(ClassDefaultObject, Params);
        ++FObjectSystem::ConstructorDepth();
        ClassConstructor(Initializer);
        --FObjectSystem::ConstructorDepth();
    }
    ClassDefaultObject->PostCDOContruct();
    return ClassDefaultObject;
}

UObject* UClass::GetDefaultSubobjectByName(FName ToFind) {
    return GetDefaultObject()->GetDefaultSubobjectByName(ToFind);
}
void UClass::GetDefaultObjectSubobjects(TArray<UObject*>& OutDefaultSubobjects) {
    GetDefaultObject()->GetDefaultSubobjects(OutDefaultSubobjects);
}

UFunction* UClass::FindFunctionByName(FName InName, EIncludeSuperFlag::Type IncludeSuper) const {
    for (const UClass* Class = this; Class; Class = Class->GetSuperClass()) {
        if (UFunction* const* Own = Class->FuncMap.Find(InName)) {
            return *Own;
        }
        for (const FImplementedInterface& Interface : Class->Interfaces) {
            if (Interface.Class) {
                if (UFunction* Function = Interface.Class->FindFunctionByName(InName)) {
                    return Function;
                }
            }
        }
        if (IncludeSuper == EIncludeSuperFlag::ExcludeSuper) {
            break;
        }
    }
    return nullptr;
}
void UClass::GenerateFunctionList(TArray<FName>& OutArray) const { FuncMap.GenerateKeyArray(OutArray); }
bool UClass::IsFunctionImplementedInScript(FName) const { return false; }
void UClass::AddNativeFunction(const ANSICHAR* InName, FNativeFuncPtr InPointer) {
    NativeFunctionLookupTable.Add({FName(InName), InPointer});
}
void UClass::AddNativeFunction(const TCHAR* InName, FNativeFuncPtr InPointer) {
    NativeFunctionLookupTable.Add({FName(InName), InPointer});
}
void UClass::LinkChildFunction(UFunction* Function) {
    Function->Next = nullptr;
    if (!Children) {
        Children = Function;
    } else {
        UField* Last = Children;
        while (Last->Next) {
            Last = Last->Next;
        }
        Last->Next = Function;
    }
    AddFunctionToFunctionMap(Function, Function->GetFName());
}

bool UClass::ImplementsInterface(const UClass* SomeInterface) const {
    if (!SomeInterface || !SomeInterface->HasAnyClassFlags(CLASS_Interface)) {
        return false;
    }
    for (const UClass* Class = this; Class; Class = Class->GetSuperClass()) {
        for (const FImplementedInterface& Interface : Class->Interfaces) {
            if (Interface.Class && Interface.Class->IsChildOf(SomeInterface)) {
                return true;
            }
        }
    }
    return false;
}

void UClass::Link(bool bComputeLayout) {
    UStruct::Link(bComputeLayout);
    for (FProperty* Property = PropertyLink; Property; Property = Property->PropertyLinkNext) {
        if (Property->ContainsInstancedObjectProperty()) {
            ClassFlags |= CLASS_HasInstancedReference;
        }
    }
}

UClass* UClass::FindCommonBase(UClass* InClassA, UClass* InClassB) {
    UClass* Common = InClassA;
    while (Common && InClassB && !InClassB->IsChildOf(Common)) {
        Common = Common->GetSuperClass();
    }
    return InClassB ? Common : nullptr;
}

void UClass::AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector) {
    UClass* This = static_cast<UClass*>(InThis);
    Collector.AddReferencedObject(This->ClassDefaultObject, This);
    Collector.AddReferencedObject(This->ClassWithin, This);
    for (FImplementedInterface& Interface : This->Interfaces) {
        Collector.AddReferencedObject(Interface.Class, This);
    }
    Super::AddReferencedObjects(InThis, Collector);
}
