// SPDX-License-Identifier: MIT
// Construction of objects: NewObject, FObjectInitializer, templates and instanced subobjects, duplication.
#include "ObjectSystem.h"
#include "UObject/Class.h"
#include "UObject/Package.h"
#include "UObject/UObjectGlobals.h"
#include "UObject/UObjectHash.h"
#include "UObject/UnrealType.h"

DEFINE_LOG_CATEGORY_STATIC(LogObjectConstruction, Log, All);

namespace {
thread_local FObjectInitializer* GCurrentInitializer = nullptr;
thread_local int32 GConstructorDepth = 0;

/** Copies the properties that both containers have. */
void CopyProperties(UObject* Target, const UObject* Source, bool bCopyTransientsFromClassDefaults) {
    const UClass* SourceClass = Source->GetClass();
    const UObject* ClassDefaults =
        bCopyTransientsFromClassDefaults ? Target->GetClass()->GetDefaultObject(false) : nullptr;
    const UClass* Common = UClass::FindCommonBase(Target->GetClass(), const_cast<UClass*>(SourceClass));
    for (FProperty* Property = Common ? Common->PropertyLink : nullptr; Property;
        Property = Property->PropertyLinkNext) {
        const bool bTransient =
            Property->HasAnyPropertyFlags(CPF_Transient | CPF_DuplicateTransient | CPF_NonPIEDuplicateTransient);
        const UObject* From = ClassDefaults && bTransient ? ClassDefaults : Source;
        if (From != Target) {
            Property->CopyCompleteValue_InContainer(Target, From);
        }
    }
}
} // namespace

int32& FObjectSystem::ConstructorDepth() { return GConstructorDepth; }
bool IsInConstructor() { return GConstructorDepth > 0; }

UObject* StaticConstructObject_Internal(const FStaticConstructObjectParameters& Params) {
    checkf(Params.Class, TEXT("NewObject: no class was given"));
    UClass* const Class = const_cast<UClass*>(Params.Class);
    const bool bIsDefaultObject = (Params.SetFlags & RF_ClassDefaultObject) != 0;
    checkf(bIsDefaultObject || !Class->HasAnyClassFlags(CLASS_Abstract),
        TEXT("NewObject: class %s is abstract; choose a child of it"), *Class->GetPathName());
    checkf(Class->HasAnyClassFlags(CLASS_Constructed), TEXT("NewObject: class %s is not registered yet"),
        *Class->GetPathName());
    checkf(!IsGarbageCollecting(), TEXT("NewObject: class %s: objects cannot be made while garbage is collected"),
        *Class->GetPathName());

    UObject* Outer = Params.Outer;
    if (!Outer && !Class->IsChildOf(UPackage::StaticClass())) {
        Outer = GetTransientPackage();
    }
    if (!bIsDefaultObject) {
        // Templates are read during construction, so they must exist first.
        Class->GetDefaultObject();
        checkf(!Class->ClassWithin || !Outer || Outer->IsA(Class->ClassWithin) || Outer->IsTemplate(),
            TEXT("NewObject: a %s must be inside a %s, not inside %s"), *Class->GetName(),
            *Class->ClassWithin->GetName(), *GetFullNameSafe(Outer));
    }
    const FName Name = Params.Name.IsNone() ? MakeUniqueObjectName(Outer, Class) : Params.Name;
    const SIZE_T Size = static_cast<SIZE_T>(Class->GetPropertiesSize());

    UObject* Object = nullptr;
    if (UObject* Existing = StaticFindObjectFast(nullptr, Outer, Name)) {
        checkf(Existing->GetClass() == Class, TEXT("NewObject: %s cannot replace the existing %s of another class"),
            *Class->GetName(), *Existing->GetFullName());
        checkf(!Existing->HasAnyFlags(RF_NeedInitialization),
            TEXT("NewObject: %s is still under construction; use another name"), *Existing->GetFullName());
        // As in UE the new object takes over name and memory of the old one.
        FObjectSystem::DestroyInPlace(Existing);
        Object = Existing;
    } else {
        Object =
            static_cast<UObject*>(FObjectSystem::AllocateObject(Size, static_cast<SIZE_T>(Class->GetMinAlignment())));
    }
    FObjectSystem::SetNextIdentity(
        Class, Outer, Name, Params.SetFlags | RF_NeedInitialization, Params.InternalSetFlags);
    {
        FObjectInitializer Initializer(Object, Params);
        ++GConstructorDepth;
        Class->ClassConstructor(Initializer);
        --GConstructorDepth;
    }
    return Object;
}

// ---------------------------------------------------------------------------------------------------------------------------

FObjectInitializer::FObjectInitializer(UObject* InObj, const FStaticConstructObjectParameters& Params)
    : Obj(InObj), ObjectArchetype(Params.Template),
      bCopyTransientsFromClassDefaults(Params.bCopyTransientsFromClassDefaults), InstanceGraph(Params.InstanceGraph),
      Previous(GCurrentInitializer) {
    GCurrentInitializer = this;
    if (!ObjectArchetype) {
        ObjectArchetype =
            Params.SetFlags & RF_ClassDefaultObject
                ? (Params.Class->GetSuperClass() ? Params.Class->GetSuperClass()->GetDefaultObject() : nullptr)
                : Params.Class->GetDefaultObject();
    }
}

FObjectInitializer::~FObjectInitializer() {
    PostConstructInit();
    GCurrentInitializer = Previous;
}

FObjectInitializer* FObjectInitializer::TryGet() { return GCurrentInitializer; }
FObjectInitializer& FObjectInitializer::Get() {
    checkf(GCurrentInitializer,
        TEXT("FObjectInitializer::Get: no object is under construction; objects are made by NewObject"));
    return *GCurrentInitializer;
}
UClass* FObjectInitializer::GetClass() const { return Obj->GetClass(); }

const FObjectInitializer::FOverride* FObjectInitializer::FindOverride(FName Name) const {
    for (const FOverride& Override : Overrides) {
        if (Override.Name == Name) {
            return &Override;
        }
    }
    return nullptr;
}

const FObjectInitializer& FObjectInitializer::SetDefaultSubobjectClass(FName SubobjectName, const UClass* Class) const {
    checkf(bSubclassOverridesAllowed,
        TEXT("SetDefaultSubobjectClass('%s'): the subobjects exist already; call it in the initialiser list"),
        *SubobjectName.ToString());
    // The most derived constructor speaks first and wins.
    if (!FindOverride(SubobjectName)) {
        Overrides.Add({SubobjectName, Class});
    }
    return *this;
}

const FObjectInitializer& FObjectInitializer::DoNotCreateDefaultSubobject(FName SubobjectName) const {
    return SetDefaultSubobjectClass(SubobjectName, nullptr);
}

UObject* FObjectInitializer::CreateDefaultSubobject(UObject* Outer, FName SubobjectFName, const UClass* ReturnType,
    const UClass* ClassToCreateByDefault, bool bIsRequired, bool bIsTransient) const {
    checkf(!SubobjectFName.IsNone(), TEXT("CreateDefaultSubobject on %s needs a name"), *Outer->GetPathName());
    const UClass* Class = ClassToCreateByDefault;
    if (const FOverride* Override = FindOverride(SubobjectFName)) {
        if (!Override->Class) {
            if (!bIsRequired) {
                return nullptr;
            }
            UE_LOG(LogObjectConstruction, Error, TEXT("%s: required subobject '%s' cannot be left out"),
                *Outer->GetPathName(), *SubobjectFName.ToString());
        } else if (Override->Class->IsChildOf(ReturnType)) {
            Class = Override->Class;
        } else {
            UE_LOG(LogObjectConstruction, Error, TEXT("%s: %s is no %s, so subobject '%s' stays a %s"),
                *Outer->GetPathName(), *Override->Class->GetName(), *ReturnType->GetName(), *SubobjectFName.ToString(),
                *Class->GetName());
        }
    }
    if (Class->HasAnyClassFlags(CLASS_Abstract)) {
        checkf(!bIsRequired, TEXT("%s: required subobject '%s' has the abstract class %s"), *Outer->GetPathName(),
            *SubobjectFName.ToString(), *Class->GetName());
        return nullptr;
    }
    checkf(!StaticFindObjectFast(nullptr, Outer, SubobjectFName), TEXT("%s already has a default subobject named '%s'"),
        *Outer->GetPathName(), *SubobjectFName.ToString());

    FStaticConstructObjectParameters Params(Class);
    Params.Outer = Outer;
    Params.Name = SubobjectFName;
    Params.SetFlags = Outer->GetMaskedFlags(RF_PropagateToSubObjects) | RF_DefaultSubObject;
    if (bIsTransient) {
        Params.SetFlags |= RF_Transient;
    }
    UObject* Result = StaticConstructObject_Internal(Params);

    // With an explicit template the subobject becomes like the template's own, once the constructors are through.
    const bool bExplicitTemplate = ObjectArchetype && !ObjectArchetype->HasAnyFlags(RF_ClassDefaultObject);
    if (bExplicitTemplate && !bIsTransient && Outer == Obj) {
        UObject* Template = FindObjectWithOuter(ObjectArchetype, nullptr, SubobjectFName);
        if (Template && Template->IsA(ReturnType)) {
            SubobjectInits.Add({Result, Template});
        }
    }
    return Result;
}

void FObjectInitializer::PostConstructInit() {
    UClass* const Class = Obj->GetClass();
    const bool bIsDefaultObject = Obj->HasAnyFlags(RF_ClassDefaultObject);
    const bool bExplicitTemplate =
        ObjectArchetype && !bIsDefaultObject && ObjectArchetype != Class->GetDefaultObject(false);
    if (bExplicitTemplate) {
        FObjectInstancingGraph LocalGraph;
        FObjectInstancingGraph* Graph = InstanceGraph ? InstanceGraph : &LocalGraph;
        Graph->SetDestinationRoot(Obj, ObjectArchetype);
        CopyProperties(Obj, ObjectArchetype, bCopyTransientsFromClassDefaults);
        for (const FSubobjectInit& Init : SubobjectInits) {
            CopyProperties(Init.Subobject, Init.Template, bCopyTransientsFromClassDefaults);
            Graph->AddNewInstance(Init.Template, Init.Subobject);
        }
        Class->InstanceSubobjectTemplates(Obj, ObjectArchetype, ObjectArchetype->GetClass(), Obj, Graph);
        for (const FSubobjectInit& Init : SubobjectInits) {
            Init.Subobject->GetClass()->InstanceSubobjectTemplates(
                Init.Subobject, Init.Template, Init.Template->GetClass(), Init.Subobject, Graph);
        }
    } else if (!bIsDefaultObject) {
        // Values that the constructor does not know: configuration was read into the class default object.
        const UObject* Defaults = Class->GetDefaultObject();
        for (FProperty* Property = Class->PostConstructLink; Property; Property = Property->PostConstructLinkNext) {
            Property->CopyCompleteValue_InContainer(Obj, Defaults);
        }
    }
    Obj->ClearFlags(RF_NeedInitialization);
    Obj->PostInitProperties();
}

// ---------------------------------------------------------------------------------------------------------------------------

void FObjectInstancingGraph::SetDestinationRoot(UObject* DestinationSubobjectRoot, UObject* InSourceRoot) {
    DestinationRoot = DestinationSubobjectRoot;
    SourceRoot = InSourceRoot ? InSourceRoot : DestinationSubobjectRoot->GetArchetype();
    AddNewInstance(SourceRoot, DestinationRoot);
}
void FObjectInstancingGraph::AddNewInstance(UObject* Source, UObject* Instance) {
    SourceToDestination.Add(Source, Instance);
}
UObject* FObjectInstancingGraph::GetDestinationObject(UObject* SourceObject) const {
    UObject* const* Found = SourceToDestination.Find(SourceObject);
    return Found ? *Found : nullptr;
}

void FObjectProperty::InstanceSubobjects(
    void* Data, void const*, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) {
    if (!InstanceGraph) {
        return;
    }
    // Transient references are led to existing counterparts too, but make no new objects.
    const bool bMayCreate = HasAnyPropertyFlags(CPF_InstancedReference | CPF_PersistentInstance) &&
                            !HasAnyPropertyFlags(CPF_Transient | CPF_DuplicateTransient);
    for (int32 Index = 0; Index < ArrayDim; ++Index) {
        void* Address = static_cast<uint8*>(Data) + Index * ElementSize;
        UObject* Value = GetObjectPropertyValue(Address);
        if (!Value) {
            continue;
        }
        if (UObject* Known = InstanceGraph->GetDestinationObject(Value)) {
            SetObjectPropertyValue(Address, Known);
            continue;
        }
        // Only objects inside the template have a counterpart; references to the outside stay as they are.
        UObject* const Source = InstanceGraph->GetSourceRoot();
        UObject* const Destination = InstanceGraph->GetDestinationRoot();
        if (!Source || !Value->IsIn(Source)) {
            continue;
        }
        UObject* const ValueOuter = InstanceGraph->GetDestinationObject(Value->GetOuter());
        UObject* const NewOuter = ValueOuter ? ValueOuter : Destination;
        UObject* Instance = StaticFindObjectFast(Value->GetClass(), NewOuter, Value->GetFName());
        if (!Instance && bMayCreate) {
            FStaticConstructObjectParameters Params(Value->GetClass());
            Params.Outer = NewOuter;
            Params.Name =
                StaticFindObjectFast(nullptr, NewOuter, Value->GetFName()) ? FName(NAME_None) : Value->GetFName();
            Params.SetFlags =
                NewOuter->GetMaskedFlags(RF_PropagateToSubObjects) | Value->GetMaskedFlags(RF_DefaultSubObject);
            Params.Template = Value;
            Instance = StaticConstructObject_Internal(Params);
        }
        if (Instance) {
            InstanceGraph->AddNewInstance(Value, Instance);
            SetObjectPropertyValue(Address, Instance);
        }
    }
}

void UStruct::InstanceSubobjectTemplates(void* Data, void const* DefaultData, UStruct* DefaultStruct, UObject* Owner,
    FObjectInstancingGraph* InstanceGraph) {
    for (FProperty* Property = RefLink; Property; Property = Property->NextRef) {
        Property->InstanceSubobjects(Property->ContainerPtrToValuePtr<void>(Data),
            Property->ContainerPtrToValuePtrForDefaults<void>(DefaultStruct, DefaultData), Owner, InstanceGraph);
    }
}

// ---------------------------------------------------------------------------------------------------------------------------

namespace {
/** Replaces references to originals by references to their copies. */
class FReferenceReplacer final : public FReferenceCollector {
public:
    explicit FReferenceReplacer(const TMap<UObject*, UObject*>& InReplacements) : Replacements(InReplacements) {}

protected:
    virtual void HandleObjectReference(UObject*& InObject, const UObject*, const FProperty*) override {
        if (UObject* const* Found = Replacements.Find(InObject)) {
            InObject = *Found;
        }
    }

private:
    const TMap<UObject*, UObject*>& Replacements;
};

UObject* MakeCopy(const UObject* Source, UObject* Outer, FName Name, EObjectFlags FlagMask, UClass* Class) {
    // The constructor of the new outer may have made this subobject already.
    if (UObject* Existing = Name.IsNone() ? nullptr : StaticFindObjectFast(Class, Outer, Name)) {
        if (Existing->GetOuter() == Outer && Existing->HasAnyFlags(RF_DefaultSubObject)) {
            return Existing;
        }
    }
    FStaticConstructObjectParameters Params(Class);
    Params.Outer = Outer;
    Params.Name = Name;
    Params.SetFlags =
        Source->GetFlags() & FlagMask & (RF_Load | RF_Transient) & ~(RF_ClassDefaultObject | RF_ArchetypeObject);
    return StaticConstructObject_Internal(Params);
}
} // namespace

UObject* StaticDuplicateObject(UObject const* SourceObject, UObject* DestOuter, const FName DestName,
    EObjectFlags FlagMask, UClass* DestClass, EDuplicateMode::Type DuplicateMode) {
    checkf(SourceObject, TEXT("DuplicateObject: no object was given"));
    UClass* Class = DestClass ? DestClass : SourceObject->GetClass();
    UObject* Outer = DestOuter ? DestOuter : static_cast<UObject*>(GetTransientPackage());

    TArray<UObject*> Sources;
    Sources.Add(const_cast<UObject*>(SourceObject));
    GetObjectsWithOuter(SourceObject, Sources, true, RF_DuplicateTransient, EInternalObjectFlags::Garbage);

    TMap<UObject*, UObject*> Copies;
    TArray<UObject*> Results;
    for (UObject* Source : Sources) {
        UObject* Copy;
        if (Source == SourceObject) {
            Copy = MakeCopy(Source, Outer, DestName, FlagMask, Class);
        } else {
            UObject* const* NewOuter = Copies.Find(Source->GetOuter());
            // A parent that was left out takes its children with it.
            Copy = NewOuter ? MakeCopy(Source, *NewOuter, Source->GetFName(), FlagMask, Source->GetClass()) : nullptr;
        }
        if (Copy) {
            Copies.Add(Source, Copy);
        }
        Results.Add(Copy);
    }
    FReferenceReplacer Replacer(Copies);
    for (int32 Index = 0; Index < Sources.Num(); ++Index) {
        UObject* Copy = Results[Index];
        if (!Copy) {
            continue;
        }
        const UClass* Common = UClass::FindCommonBase(Sources[Index]->GetClass(), Copy->GetClass());
        for (FProperty* Property = Common->PropertyLink; Property; Property = Property->PropertyLinkNext) {
            const uint64 Skipped = CPF_Transient | CPF_DuplicateTransient | CPF_SkipSerialization |
                                   (DuplicateMode == EDuplicateMode::PIE ? CPF_None : CPF_NonPIEDuplicateTransient);
            if (!Property->HasAnyPropertyFlags(Skipped)) {
                Property->CopyCompleteValue_InContainer(Copy, Sources[Index]);
            }
        }
        Replacer.AddPropertyReferences(Copy->GetClass(), Copy, Copy);
    }
    for (UObject* Copy : Results) {
        if (Copy) {
            Copy->PostDuplicate(DuplicateMode);
        }
    }
    return Results[0];
}

namespace UE::CoreUObject::Private {
UObject* DuplicateObject(const UClass*, const UObject* SourceObject, UObject* Outer, FName NewName) {
    return SourceObject ? StaticDuplicateObject(SourceObject, Outer, NewName) : nullptr;
}
} // namespace UE::CoreUObject::Private
