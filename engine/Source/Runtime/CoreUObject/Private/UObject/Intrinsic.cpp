// SPDX-License-Identifier: MIT
// The classes that exist without a schema because they are what schemas are turned into, and the making of bare UClass
// objects.
#include "GeneratedRegistry.h"
#include "ObjectSystem.h"
#include "UObject/Interface.h"
#include "UObject/Package.h"

bool FObjectSystem::bMetaClassesReady = false;

namespace {
/** Class objects made before UClass and UPackage existed: they get class, outer and table entries afterwards. */
struct FEarlyClass {
    UClass* Class;
    const TCHAR* PackageName;
};
TArray<FEarlyClass>& EarlyClasses() {
    static TArray<FEarlyClass>& Instance = *new TArray<FEarlyClass>;
    return Instance;
}
int32 GCreationDepth = 0;

void FinishEarlyClasses() {
    UClass* const ClassClass = UClass::StaticClass();
    UPackage::StaticClass();
    FObjectSystem::bMetaClassesReady = true;
    TArray<FEarlyClass> Early = MoveTemp(EarlyClasses());
    EarlyClasses().Reset();
    // All of them need a class before any of them can be looked up.
    for (const FEarlyClass& Entry : Early) {
        FObjectSystem::SetIdentity(Entry.Class, ClassClass, nullptr);
    }
    for (const FEarlyClass& Entry : Early) {
        FObjectSystem::SetIdentity(
            Entry.Class, ClassClass, FObjectSystem::FindOrCreateNativePackage(FName(Entry.PackageName)));
        FObjectSystem::Hash(Entry.Class);
    }
}
} // namespace

UPackage* FObjectSystem::FindOrCreateNativePackage(FName Name) {
    if (UObject* Existing =
            Find(UPackage::StaticClass(), nullptr, Name, false, RF_NoFlags, EInternalObjectFlags::None)) {
        return static_cast<UPackage*>(Existing);
    }
    void* Memory = AllocateObject(sizeof(UPackage), alignof(UPackage));
    SetNextIdentity(UPackage::StaticClass(), nullptr, Name, RF_Public,
        EInternalObjectFlags::RootSet | EInternalObjectFlags::Native);
    UPackage* Package = new (static_cast<EInternal*>(Memory)) UPackage;
    Package->SetPackageFlags(PKG_CompiledIn);
    return Package;
}

void FObjectSystem::CreateNativeClass(const FNativeClassParams& Params) {
    ++GCreationDepth;
    void* Memory = AllocateObject(sizeof(UClass), alignof(UClass));
    const EInternalObjectFlags Internal = EInternalObjectFlags::RootSet | EInternalObjectFlags::Native;
    const EObjectFlags Flags = RF_Public | RF_Standalone | RF_MarkAsNative;
    UClass* Class;
    if (bMetaClassesReady) {
        SetNextIdentity(UClass::StaticClass(), FindOrCreateNativePackage(FName(Params.PackageName)), FName(Params.Name),
            Flags, Internal);
        Class = new (static_cast<EInternal*>(Memory)) UClass;
    } else {
        SetNextIdentity(nullptr, nullptr, FName(Params.Name), Flags, Internal);
        Class = new (static_cast<EInternal*>(Memory)) UClass;
        EarlyClasses().Add({Class, Params.PackageName});
    }
    *Params.Slot = Class;
    Class->PropertiesSize = static_cast<int32>(Params.Size);
    Class->MinAlignment = static_cast<int32>(Params.Alignment);
    Class->ClassFlags = Params.ClassFlags | CLASS_Native;
    Class->ClassCastFlags = Params.ClassCastFlags;
    Class->ClassConstructor = Params.Constructor;
    Class->ClassAddReferencedObjects = Params.AddReferencedObjects;
    Class->ClassConfigName = FName(Params.ConfigName);
    if (Params.SuperClass) {
        UClass* Super = Params.SuperClass();
        Class->SetSuperStruct(Super);
        Class->ClassFlags |= Super->ClassFlags & CLASS_Inherit;
        Class->ClassCastFlags |= Super->ClassCastFlags;
        if (Class->ClassConfigName.IsNone()) {
            Class->ClassConfigName = Super->ClassConfigName;
        }
    }
    if (Params.RegisterNatives) {
        Params.RegisterNatives();
    }
    --GCreationDepth;
    if (GCreationDepth == 0 && !bMetaClassesReady) {
        FinishEarlyClasses();
    }
    Class->ClassWithin = Params.WithinClass ? Params.WithinClass() : UObject::StaticClass();
    if (Params.ClassFlags & CLASS_Intrinsic) {
        // Nothing is added to intrinsic classes later: they have no properties of their own.
        UnfinishedIntrinsics().Add(Class);
    }
}

TArray<UClass*>& UnfinishedIntrinsics() {
    static TArray<UClass*>& Instance = *new TArray<UClass*>;
    return Instance;
}

#define UE_IMPLEMENT_INTRINSIC(TClass, TSuperClass)                                                                    \
    UClass* TClass::GetPrivateStaticClass() {                                                                          \
        static UClass* Class = nullptr;                                                                                \
        if (!Class) {                                                                                                  \
            FObjectSystem::CreateNativeClass({&Class, StaticPackage(), UE_STATIC_CLASS_NAME(TClass), sizeof(TClass),   \
                alignof(TClass), StaticClassFlags, StaticClassCastFlags(), TEXT(""), &TClass::__DefaultConstructor,    \
                &TClass::AddReferencedObjects, &TSuperClass::StaticClass, nullptr, nullptr});                          \
        }                                                                                                              \
        return Class;                                                                                                  \
    }

UE_IMPLEMENT_INTRINSIC(UField, UObject)
UE_IMPLEMENT_INTRINSIC(UStruct, UField)
UE_IMPLEMENT_INTRINSIC(UScriptStruct, UStruct)
UE_IMPLEMENT_INTRINSIC(UFunction, UStruct)
UE_IMPLEMENT_INTRINSIC(UDelegateFunction, UFunction)
UE_IMPLEMENT_INTRINSIC(USparseDelegateFunction, UDelegateFunction)
UE_IMPLEMENT_INTRINSIC(UEnum, UField)
UE_IMPLEMENT_INTRINSIC(UClass, UStruct)
UE_IMPLEMENT_INTRINSIC(UPackage, UObject)
UE_IMPLEMENT_INTRINSIC(UInterface, UObject)

void ForceIntrinsicClasses() {
    UField::StaticClass();
    UStruct::StaticClass();
    UScriptStruct::StaticClass();
    UFunction::StaticClass();
    UDelegateFunction::StaticClass();
    USparseDelegateFunction::StaticClass();
    UEnum::StaticClass();
    UClass::StaticClass();
    UPackage::StaticClass();
    UInterface::StaticClass();
}
