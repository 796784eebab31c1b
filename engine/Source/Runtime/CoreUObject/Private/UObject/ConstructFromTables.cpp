// SPDX-License-Identifier: MIT
// Turns the constant tables of generated code (UObject/GeneratedTables.h) into classes, structs, enums, functions and
// properties.
#include "UObject/GeneratedTables.h"

#include "GeneratedRegistry.h"
#include "Modules/ModuleManager.h"
#include "ObjectSystem.h"
#include "UObject/Class.h"
#include "UObject/Package.h"
#include "UObject/UnrealType.h"

DEFINE_LOG_CATEGORY_STATIC(LogClassRegistration, Log, All);

namespace GeneratedTables {
namespace {
FHeaderRegistrar* GPendingHeaders = nullptr;
FHeaderRegistrar** GPendingHeadersTail = &GPendingHeaders;
FPackageRegistrar* GPendingPackages = nullptr;
FPackageRegistrar** GPendingPackagesTail = &GPendingPackages;

FString FromUtf8(const char* Text) { return FString(UTF8_TO_TCHAR(Text)); }
FName NameOf(const char* Text) { return FName(*FromUtf8(Text)); }

template <typename TTarget>
void SetMeta(TTarget* Target, const FMetaPair* Pairs, int32 NumPairs) {
#if WITH_METADATA
    for (int32 Index = 0; Index < NumPairs; ++Index) {
        if constexpr (std::is_base_of_v<FField, TTarget>) {
            Target->SetMetaData(NameOf(Pairs[Index].Key), FromUtf8(Pairs[Index].Value));
        } else {
            Target->SetMetaData(NameOf(Pairs[Index].Key), *FromUtf8(Pairs[Index].Value));
        }
    }
#endif
}

/** A rooted, native object of an intrinsic class. */
template <typename T>
T* NewNative(UObject* Outer, FName Name) {
    void* Memory = FObjectSystem::AllocateObject(sizeof(T), alignof(T));
    FObjectSystem::SetNextIdentity(T::StaticClass(), Outer, Name, RF_Public | RF_Standalone | RF_MarkAsNative,
        EInternalObjectFlags::RootSet | EInternalObjectFlags::Native);
    return new (static_cast<EInternal*>(Memory)) T;
}

template <typename T>
T* NewProperty(const FFieldVariant& Owner, const FPropertyTable& Table) {
    return new T(Owner, NameOf(Table.Name), RF_Public | RF_MarkAsNative);
}

/** Finds the bit that SetBit sets, in zeroed memory of the container's size. */
void FindBit(FBoolProperty* Property, const FPropertyTable& Table) {
    if (!Table.SetBit) {
        Property->SetBoolSize(sizeof(bool), true);
        return;
    }
    uint8* const Memory = static_cast<uint8*>(FMemory::MallocZeroed(static_cast<SIZE_T>(Table.OuterSize), 64));
    Table.SetBit(Memory);
    int32 Offset = 0;
    while (Offset < Table.OuterSize && Memory[Offset] == 0) {
        ++Offset;
    }
    checkf(Offset < Table.OuterSize, TEXT("Bit-field %s was not found"), *Property->GetPathName());
    Property->SetOffset_Internal(Offset);
    Property->SetBoolSize(sizeof(uint8), false, Memory[Offset]);
    FMemory::Free(Memory);
}

FProperty* BuildProperty(const FFieldVariant& Owner, const FPropertyTable& Table);

FNumericProperty* BuildUnderlying(FEnumProperty* Owner, const FPropertyTable& Table) {
    FPropertyTable Inner{};
    Inner.Name = "UnderlyingType";
    Inner.Kind = Table.Underlying;
    return CastFieldChecked<FNumericProperty>(BuildProperty(Owner, Inner));
}

FProperty* BuildPropertyOfKind(const FFieldVariant& Owner, const FPropertyTable& Table) {
    switch (Table.Kind) {
    case EPropertyKind::Bool: {
        FBoolProperty* Property = NewProperty<FBoolProperty>(Owner, Table);
        Property->SetOffset_Internal(Table.Offset);
        FindBit(Property, Table);
        return Property;
    }
    case EPropertyKind::Int8:
        return NewProperty<FInt8Property>(Owner, Table);
    case EPropertyKind::Int16:
        return NewProperty<FInt16Property>(Owner, Table);
    case EPropertyKind::Int32:
        return NewProperty<FIntProperty>(Owner, Table);
    case EPropertyKind::Int64:
        return NewProperty<FInt64Property>(Owner, Table);
    case EPropertyKind::UInt8:
        return NewProperty<FByteProperty>(Owner, Table);
    case EPropertyKind::UInt16:
        return NewProperty<FUInt16Property>(Owner, Table);
    case EPropertyKind::UInt32:
        return NewProperty<FUInt32Property>(Owner, Table);
    case EPropertyKind::UInt64:
        return NewProperty<FUInt64Property>(Owner, Table);
    case EPropertyKind::Float:
        return NewProperty<FFloatProperty>(Owner, Table);
    case EPropertyKind::Double:
        return NewProperty<FDoubleProperty>(Owner, Table);
    case EPropertyKind::String:
        return NewProperty<FStrProperty>(Owner, Table);
    case EPropertyKind::Name:
        return NewProperty<FNameProperty>(Owner, Table);
    case EPropertyKind::Text:
        return NewProperty<FTextProperty>(Owner, Table);
    case EPropertyKind::Enum: {
        FEnumProperty* Property = NewProperty<FEnumProperty>(Owner, Table);
        Property->SetEnum(Table.EnumFunc());
        Property->SetUnderlyingProperty(BuildUnderlying(Property, Table));
        return Property;
    }
    case EPropertyKind::ByteEnum: {
        FByteProperty* Property = NewProperty<FByteProperty>(Owner, Table);
        Property->Enum = Table.EnumFunc();
        return Property;
    }
    case EPropertyKind::Object: {
        FObjectProperty* Property = NewProperty<FObjectProperty>(Owner, Table);
        Property->SetPropertyClass(Table.ClassFunc());
        return Property;
    }
    case EPropertyKind::Class: {
        FClassProperty* Property = NewProperty<FClassProperty>(Owner, Table);
        Property->SetPropertyClass(UClass::StaticClass());
        Property->SetMetaClass(Table.ClassFunc());
        return Property;
    }
    case EPropertyKind::WeakObject: {
        FWeakObjectProperty* Property = NewProperty<FWeakObjectProperty>(Owner, Table);
        Property->SetPropertyClass(Table.ClassFunc());
        return Property;
    }
    case EPropertyKind::LazyObject: {
        FLazyObjectProperty* Property = NewProperty<FLazyObjectProperty>(Owner, Table);
        Property->SetPropertyClass(Table.ClassFunc());
        return Property;
    }
    case EPropertyKind::SoftObject: {
        FSoftObjectProperty* Property = NewProperty<FSoftObjectProperty>(Owner, Table);
        Property->SetPropertyClass(Table.ClassFunc());
        return Property;
    }
    case EPropertyKind::SoftClass: {
        FSoftClassProperty* Property = NewProperty<FSoftClassProperty>(Owner, Table);
        Property->SetPropertyClass(UClass::StaticClass());
        Property->SetMetaClass(Table.ClassFunc());
        return Property;
    }
    case EPropertyKind::Interface: {
        FInterfaceProperty* Property = NewProperty<FInterfaceProperty>(Owner, Table);
        Property->SetInterfaceClass(Table.ClassFunc());
        return Property;
    }
    case EPropertyKind::Struct: {
        FStructProperty* Property = NewProperty<FStructProperty>(Owner, Table);
        Property->Struct = Table.StructFunc();
        return Property;
    }
    case EPropertyKind::Array: {
        FArrayProperty* Property = NewProperty<FArrayProperty>(Owner, Table);
        Property->Inner = BuildProperty(Property, *Table.Inner);
        return Property;
    }
    case EPropertyKind::Set: {
        FSetProperty* Property = NewProperty<FSetProperty>(Owner, Table);
        Property->ElementProp = BuildProperty(Property, *Table.Inner);
        return Property;
    }
    case EPropertyKind::Map: {
        FMapProperty* Property = NewProperty<FMapProperty>(Owner, Table);
        Property->KeyProp = BuildProperty(Property, *Table.Key);
        Property->ValueProp = BuildProperty(Property, *Table.Inner);
        return Property;
    }
    case EPropertyKind::Optional: {
        FOptionalProperty* Property = NewProperty<FOptionalProperty>(Owner, Table);
        Property->ValueProperty = BuildProperty(Property, *Table.Inner);
        return Property;
    }
    case EPropertyKind::Delegate: {
        FDelegateProperty* Property = NewProperty<FDelegateProperty>(Owner, Table);
        Property->SignatureFunction = Table.SignatureFunc();
        return Property;
    }
    case EPropertyKind::MulticastDelegate: {
        FMulticastInlineDelegateProperty* Property = NewProperty<FMulticastInlineDelegateProperty>(Owner, Table);
        Property->SignatureFunction = Table.SignatureFunc();
        return Property;
    }
    case EPropertyKind::SparseDelegate: {
        FMulticastSparseDelegateProperty* Property = NewProperty<FMulticastSparseDelegateProperty>(Owner, Table);
        Property->SignatureFunction = Table.SignatureFunc();
        return Property;
    }
    case EPropertyKind::FieldPath: {
        FFieldPathProperty* Property = NewProperty<FFieldPathProperty>(Owner, Table);
        Property->PropertyClass = FFieldClass::FindFieldClass(NameOf(Table.FieldClass));
        return Property;
    }
    }
    checkf(false, TEXT("Unknown kind of property"));
    return nullptr;
}

FProperty* BuildProperty(const FFieldVariant& Owner, const FPropertyTable& Table) {
    FProperty* Property = BuildPropertyOfKind(Owner, Table);
    Property->ArrayDim = Table.ArrayDim;
    Property->SetPropertyFlags(static_cast<EPropertyFlags>(Table.Flags));
    if (!Table.SetBit) {
        Property->SetOffset_Internal(Table.Offset);
    }
    Property->SetNativeAccessors(Table.Setter, Table.Getter);
    if (Table.RepNotify) {
        Property->RepNotifyFunc = NameOf(Table.RepNotify);
    }
    SetMeta(Property, Table.Meta, Table.NumMeta);
    return Property;
}

void BuildProperties(UStruct* Owner, const FPropertyTable* const* Tables, int32 NumTables) {
    FField** Tail = &Owner->ChildProperties;
    for (int32 Index = 0; Index < NumTables; ++Index) {
        FProperty* Property = BuildProperty(Owner, *Tables[Index]);
        *Tail = Property;
        Tail = &Property->Next;
    }
}

/** The compiler's sizes must be the ones that reflection computed, or values would be copied with wrong lengths. */
void CheckSizes(const UStruct* Owner, const FPropertyTable* const* Tables, int32 NumTables) {
    const FField* Field = Owner->ChildProperties;
    for (int32 Index = 0; Index < NumTables; ++Index, Field = Field->Next) {
        const FProperty* Property = static_cast<const FProperty*>(Field);
        const int32 Expected = Tables[Index]->ElementSize;
        checkf(Expected == 0 || Expected == Property->GetElementSize(),
            TEXT("%s: C++ says %d bytes, its property says %d"), *Property->GetPathName(), Expected,
            Property->GetElementSize());
    }
}

void FillFunction(UFunction* Function, const FFunctionTable& Table) {
    Function->FunctionFlags = Table.Flags;
    Function->PropertiesSize = Table.ParmsSize;
    Function->MinAlignment = Table.ParmsAlignment > 0 ? Table.ParmsAlignment : 1;
    BuildProperties(Function, Table.Parameters, Table.NumParameters);
    SetMeta(Function, Table.Meta, Table.NumMeta);
    Function->Link(false);
    CheckSizes(Function, Table.Parameters, Table.NumParameters);
}

/** Gives a class its interfaces, functions and properties, after its super class (whose functions it may override). */
void BuildClass(UClass* Class, const TMap<UClass*, const FClassTable*>& Tables) {
    const FClassTable* const* Found = Tables.Find(Class);
    if (!Found || Class->HasAnyClassFlags(CLASS_Constructed)) {
        return;
    }
    const FClassTable& Table = **Found;
    Class->ClassFlags |= CLASS_Constructed;
    if (UClass* Super = Class->GetSuperClass()) {
        BuildClass(Super, Tables);
    }
    SetMeta(Class, Table.Meta, Table.NumMeta);
    for (int32 Index = 0; Index < Table.NumInterfaces; ++Index) {
        Class->Interfaces.Add(
            FImplementedInterface(Table.Interfaces[Index].InterfaceFunc(), Table.Interfaces[Index].Offset, false));
    }
    for (int32 Index = 0; Index < Table.NumFunctions; ++Index) {
        const FFunctionTable& FunctionTable = *Table.Functions[Index];
        UFunction* Function = NewNative<UFunction>(Class, NameOf(FunctionTable.Name));
        if (UClass* Super = Class->GetSuperClass()) {
            Function->SetSuperStruct(Super->FindFunctionByName(Function->GetFName()));
        }
        FillFunction(Function, FunctionTable);
        Function->Bind();
        Class->LinkChildFunction(Function);
    }
    BuildProperties(Class, Table.Properties, Table.NumProperties);
}

/** Links a class after its super class. */
void LinkClass(UClass* Class, TMap<UClass*, const FClassTable*>& Unlinked) {
    const FClassTable* const* Found = Unlinked.Find(Class);
    if (!Found) {
        return;
    }
    const FClassTable* Table = *Found;
    Unlinked.Remove(Class);
    if (UClass* Super = Class->GetSuperClass()) {
        LinkClass(Super, Unlinked);
    }
    Class->Link(false);
    CheckSizes(Class, Table->Properties, Table->NumProperties);
}
} // namespace

FHeaderRegistrar::FHeaderRegistrar(const FClassEntry* InClasses, int32 InNumClasses,
    UScriptStruct* (*const* InStructs)(), int32 InNumStructs, UEnum* (*const* InEnums)(), int32 InNumEnums,
    UFunction* (*const* InDelegates)(), int32 InNumDelegates)
    : Classes(InClasses), NumClasses(InNumClasses), Structs(InStructs), NumStructs(InNumStructs), Enums(InEnums),
      NumEnums(InNumEnums), Delegates(InDelegates), NumDelegates(InNumDelegates) {
    *GPendingHeadersTail = this;
    GPendingHeadersTail = &Next;
}

FPackageRegistrar::FPackageRegistrar(const TCHAR* InPackage) : Package(InPackage) {
    *GPendingPackagesTail = this;
    GPendingPackagesTail = &Next;
}

void MakeClassShell(const FClassTable& Table, UClass*& Result) {
    if (Result) {
        return;
    }
    const FString Name = FromUtf8(Table.Name);
    FObjectSystem::CreateNativeClass({&Result, Table.Package, *Name, static_cast<SIZE_T>(Table.Size),
        static_cast<SIZE_T>(Table.Alignment), Table.Flags, CASTCLASS_None, Table.ConfigName, Table.Constructor,
        Table.AddReferencedObjects, Table.SuperFunc, Table.WithinFunc, nullptr});
    for (int32 Index = 0; Index < Table.NumNatives; ++Index) {
        Result->AddNativeFunction(Table.Natives[Index].NameUTF8, Table.Natives[Index].Pointer);
    }
}

UScriptStruct* FindOrBuildStruct(const FStructTable& Table, UScriptStruct*& Result) {
    if (Result) {
        return Result;
    }
    UScriptStruct* Struct =
        NewNative<UScriptStruct>(FObjectSystem::FindOrCreateNativePackage(FName(Table.Package)), NameOf(Table.Name));
    Result = Struct;
    Struct->StructFlags = Table.Flags;
    Struct->SetSuperStruct(Table.SuperFunc ? Table.SuperFunc() : nullptr);
    Struct->PropertiesSize = Table.Size;
    Struct->MinAlignment = Table.Alignment;
    if (Table.NewStructOps) {
        Struct->SetCppStructOps(static_cast<ICppStructOps*>(Table.NewStructOps()));
        Struct->PrepareCppStructOps();
    }
    SetMeta(Struct, Table.Meta, Table.NumMeta);
    BuildProperties(Struct, Table.Properties, Table.NumProperties);
    Struct->Link(false);
    CheckSizes(Struct, Table.Properties, Table.NumProperties);
    return Struct;
}

UEnum* FindOrBuildEnum(const FEnumTable& Table, UEnum*& Result) {
    if (Result) {
        return Result;
    }
    UEnum* Enum = NewNative<UEnum>(FObjectSystem::FindOrCreateNativePackage(FName(Table.Package)), NameOf(Table.Name));
    Result = Enum;
    Enum->CppType = FromUtf8(Table.CppType);
    TArray<TPair<FName, int64>> Names;
    for (int32 Index = 0; Index < Table.NumEntries; ++Index) {
        Names.Add(TPair<FName, int64>(NameOf(Table.Entries[Index].Name), Table.Entries[Index].Value));
    }
    Enum->SetEnums(Names, static_cast<UEnum::ECppForm>(Table.Form), static_cast<EEnumFlags>(Table.Flags), true);
    SetMeta<UField>(Enum, Table.Meta, Table.NumMeta);
#if WITH_METADATA
    for (int32 Index = 0; Index < Table.NumEntries; ++Index) {
        const FEnumEntryTable& Entry = Table.Entries[Index];
        for (int32 Pair = 0; Pair < Entry.NumMeta; ++Pair) {
            Enum->SetMetaData(*FromUtf8(Entry.Meta[Pair].Key), *FromUtf8(Entry.Meta[Pair].Value), Index);
        }
    }
#endif
    return Enum;
}

UFunction* FindOrBuildDelegate(const TCHAR* Package, const FFunctionTable& Table, UFunction*& Result) {
    if (Result) {
        return Result;
    }
    UObject* Outer = Table.OwnerFunc ? static_cast<UObject*>(Table.OwnerFunc())
                                     : static_cast<UObject*>(FObjectSystem::FindOrCreateNativePackage(FName(Package)));
    const FName Name = NameOf(Table.Name);
    if (Table.DelegateForm == 3) {
        USparseDelegateFunction* Function = NewNative<USparseDelegateFunction>(Outer, Name);
        Function->OwningClassName = NameOf(Table.SparseOwner);
        Function->DelegateName = NameOf(Table.SparseProperty);
        Result = Function;
    } else {
        Result = NewNative<UDelegateFunction>(Outer, Name);
    }
    FillFunction(Result, Table);
    return Result;
}
} // namespace GeneratedTables

// ---------------------------------------------------------------------------------------------------------------------------

namespace {
bool GObjectSystemReady = false;

/** Binds ProcessNewlyLoadedUObjects to the module manager when this library is loaded. */
struct FModuleHook {
    FModuleHook() { FModuleManager::Get().OnProcessLoadedObjectsCallback().AddStatic(&ProcessNewlyLoadedUObjects); }
};
const FModuleHook GModuleHook;
} // namespace

bool UObjectInitialized() { return GObjectSystemReady; }

void ProcessNewlyLoadedUObjects(FName Package, bool bCanProcessNewlyLoadedObjects) {
    using namespace GeneratedTables;
    if (!bCanProcessNewlyLoadedObjects) {
        return;
    }
    // Constructors that run below may load further modules, whose tables then form a list of their own.
    FHeaderRegistrar* Headers = GPendingHeaders;
    FPackageRegistrar* Packages = GPendingPackages;
    GPendingHeaders = nullptr;
    GPendingHeadersTail = &GPendingHeaders;
    GPendingPackages = nullptr;
    GPendingPackagesTail = &GPendingPackages;
    if (!Headers && !Packages) {
        return;
    }
    ForceIntrinsicClasses();
    for (FPackageRegistrar* Entry = Packages; Entry; Entry = Entry->Next) {
        FObjectSystem::FindOrCreateNativePackage(FName(Entry->Package));
    }
    // Shells of all classes first: everything else may refer to them.
    TArray<UClass*> Classes;
    TMap<UClass*, const FClassTable*> Unlinked;
    for (FHeaderRegistrar* Header = Headers; Header; Header = Header->Next) {
        for (int32 Index = 0; Index < Header->NumClasses; ++Index) {
            UClass* Class = Header->Classes[Index].StaticClassFunc();
            Classes.Add(Class);
            Unlinked.Add(Class, Header->Classes[Index].Table);
        }
    }
    for (FHeaderRegistrar* Header = Headers; Header; Header = Header->Next) {
        for (int32 Index = 0; Index < Header->NumEnums; ++Index) {
            Header->Enums[Index]();
        }
    }
    for (FHeaderRegistrar* Header = Headers; Header; Header = Header->Next) {
        for (int32 Index = 0; Index < Header->NumStructs; ++Index) {
            Header->Structs[Index]();
        }
    }
    for (FHeaderRegistrar* Header = Headers; Header; Header = Header->Next) {
        for (int32 Index = 0; Index < Header->NumDelegates; ++Index) {
            Header->Delegates[Index]();
        }
    }
    for (UClass* Class : Classes) {
        BuildClass(Class, Unlinked);
    }
    for (UClass* Class : Classes) {
        LinkClass(Class, Unlinked);
    }
    for (UClass* Class : UnfinishedIntrinsics()) {
        Class->Link(false);
        Class->ClassFlags |= CLASS_Constructed;
    }
    TArray<UClass*> Intrinsics = MoveTemp(UnfinishedIntrinsics());
    UnfinishedIntrinsics().Reset();
    GObjectSystemReady = true;
    FCoreUObjectDelegates::CompiledInUObjectsRegisteredDelegate.Broadcast(Package);
    for (UClass* Class : Intrinsics) {
        Class->GetDefaultObject();
    }
    for (UClass* Class : Classes) {
        Class->GetDefaultObject();
    }
}
