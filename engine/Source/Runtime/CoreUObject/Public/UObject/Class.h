// SPDX-License-Identifier: MIT
// The reflected types: UField, UStruct, UFunction, UScriptStruct, UEnum, UClass. Mirrors Epic's "UObject/Class.h".
#pragma once

#include <string_view>

#include "CoreMinimal.h"
#include "Templates/SubclassOf.h"
#include "UObject/Field.h"
#include "UObject/Object.h"
#include "UObject/Script.h"
#include "UObject/StructOps.h"
#include "UObject/TopLevelAssetPath.h"

class FOutputDevice;
class FProperty;
class FStructProperty;
class UClass;
class UEnum;
class UFunction;
class UPackage;
class UStruct;
struct FObjectInstancingGraph;

// These classes describe the system that the schema describes everything else with, so no schema describes them: they
// are UE's "intrinsic" classes, set up by hand in Private/UObject/Intrinsic.cpp.
#define UE_DECLARE_INTRINSIC(TClass, TSuperClass, TStaticFlags, TStaticCastFlags)                                      \
    DECLARE_CLASS(TClass, TSuperClass, (TStaticFlags) | CLASS_Intrinsic | CLASS_MatchedSerializers, TStaticCastFlags,  \
        TEXT("/Script/CoreUObject"), NO_API)                                                                           \
    DEFINE_DEFAULT_OBJECT_INITIALIZER_CONSTRUCTOR_CALL(TClass)                                                         \
    typedef UObject WithinClass;                                                                                       \
    TClass() = default;                                                                                                \
    explicit TClass(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {}

/** Base class of reflected objects that are part of a struct or package: types and functions. */
class COREUOBJECT_API UField : public UObject {
    UE_DECLARE_INTRINSIC(UField, UObject, CLASS_Abstract, CASTCLASS_UField)

    /** Next field of the same owner. */
    UField* Next = nullptr;

    virtual ~UField() override;
    /** The class the field belongs to (itself, if it is one), or null. */
    UClass* GetOwnerClass() const;
    UStruct* GetOwnerStruct() const;
    /** Name as the author wrote it. */
    FString GetAuthoredName() const { return GetName(); }

#if WITH_METADATA
    const FString* FindMetaData(const TCHAR* Key) const;
    const FString* FindMetaData(const FName& Key) const;
    bool HasMetaData(const TCHAR* Key) const { return FindMetaData(Key) != nullptr; }
    bool HasMetaData(const FName& Key) const { return FindMetaData(Key) != nullptr; }
    /** The value, or an empty string. */
    const FString& GetMetaData(const TCHAR* Key) const;
    const FString& GetMetaData(const FName& Key) const;
    bool GetBoolMetaData(const FName& Key) const;
    bool GetBoolMetaData(const TCHAR* Key) const { return GetBoolMetaData(FName(Key)); }
    int32 GetIntMetaData(const FName& Key) const;
    float GetFloatMetaData(const FName& Key) const;
    void SetMetaData(const TCHAR* Key, const TCHAR* InValue);
    void SetMetaData(const FName& Key, const TCHAR* InValue);
    /** All metadata, or null if there is none. (UE keeps it in the package's UMetaData.) */
    const TMap<FName, FString>* GetMetaDataMap() const { return MetaDataMap; }
    FText GetDisplayNameText() const;
    FText GetToolTipText(bool bShortTooltip = false) const;

private:
    TMap<FName, FString>* MetaDataMap = nullptr;
#endif
};

/** A type with properties: base of classes, structs and functions. */
class COREUOBJECT_API UStruct : public UField {
    UE_DECLARE_INTRINSIC(UStruct, UField, CLASS_None, CASTCLASS_UStruct)

private:
    /** Base type, or null. */
    TObjectPtr<UStruct> SuperStruct;

public:
    /** Functions and other object fields, first of a list. */
    TObjectPtr<UField> Children;
    /** Properties, first of a list. */
    FField* ChildProperties = nullptr;
    /** Script bytecode: always empty here, functions are native. An event with neither body nor bytecode does nothing.
     */
    TArray<uint8> Script;
    /** Size of a value, including base types. */
    int32 PropertiesSize = 0;
    int32 MinAlignment = 1;
    /** All properties including those of base types, most derived first. */
    FProperty* PropertyLink = nullptr;
    /** Properties that hold strong references. */
    FProperty* RefLink = nullptr;
    /** Properties that need destruction. */
    FProperty* DestructorLink = nullptr;
    /** Properties filled after construction: config. */
    FProperty* PostConstructLink = nullptr;

    virtual ~UStruct() override;

    UStruct* GetSuperStruct() const { return SuperStruct; }
    virtual void SetSuperStruct(UStruct* NewSuperStruct) { SuperStruct = NewSuperStruct; }
    virtual UStruct* GetInheritanceSuper() const { return GetSuperStruct(); }
    bool IsChildOf(const UStruct* SomeBase) const {
        for (const UStruct* Struct = this; Struct; Struct = Struct->SuperStruct) {
            if (Struct == SomeBase) {
                return true;
            }
        }
        return false;
    }
    template <class T>
    bool IsChildOf() const {
        return IsChildOf(T::StaticClass());
    }
    /** Letter of the C++ name: "F", "U", "A". */
    virtual const TCHAR* GetPrefixCPP() const { return TEXT("F"); }

    int32 GetPropertiesSize() const { return PropertiesSize; }
    int32 GetMinAlignment() const { return MinAlignment; }
    /** PropertiesSize rounded up to the alignment. */
    int32 GetStructureSize() const { return Align(PropertiesSize, MinAlignment); }
    void SetPropertiesSize(int32 NewSize) { PropertiesSize = NewSize; }

    /** Property of this type or a base type, names compared without case. Null if there is none. */
    FProperty* FindPropertyByName(FName InName) const;
    virtual FString GetAuthoredNameForField(const FField* Field) const { return Field ? Field->GetName() : FString(); }

    /** Initialises ArrayDim values in raw memory. */
    virtual void InitializeStruct(void* Dest, int32 ArrayDim = 1) const;
    virtual void DestroyStruct(void* Dest, int32 ArrayDim = 1) const;
    /** Lists base types' and own properties into the link lists; computes offsets for types without C++ layout. */
    virtual void Link(bool bComputeLayout);
    void StaticLink(bool bRelinkExistingProperties = false) { Link(bRelinkExistingProperties); }
    /** Appends a property at the end of ChildProperties. */
    virtual void AddCppProperty(FProperty* Property);
    void InstanceSubobjectTemplates(void* Data, void const* DefaultData, UStruct* DefaultStruct, UObject* Owner,
        FObjectInstancingGraph* InstanceGraph);
    FTopLevelAssetPath GetStructPathName() const { return FTopLevelAssetPath(static_cast<const UObject*>(this)); }
    FName GetStructPropertyRedirects() const { return NAME_None; }

#if WITH_METADATA
    /** Metadata of the type or its nearest base type that has the key. */
    bool GetBoolMetaDataHierarchical(const FName& Key) const;
    bool GetStringMetaDataHierarchical(const FName& Key, FString* OutValue = nullptr) const;
    const UStruct* HasMetaDataHierarchical(const FName& Key) const;
#endif

    static void AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector);
};

/** A USTRUCT. */
class COREUOBJECT_API UScriptStruct : public UStruct {
    UE_DECLARE_INTRINSIC(UScriptStruct, UStruct, CLASS_None, CASTCLASS_UScriptStruct)

    typedef ::ICppStructOps ICppStructOps;
    template <class CPPSTRUCT>
    using TCppStructOps = ::TCppStructOps<CPPSTRUCT>;

    EStructFlags StructFlags = STRUCT_NoFlags;

    /** The C++ type's operations; null for structs without C++ type. */
    ICppStructOps* GetCppStructOps() const { return CppStructOps; }
    void SetCppStructOps(ICppStructOps* InCppStructOps) { CppStructOps = InCppStructOps; }
    void PrepareCppStructOps();

    /** Assigns ArrayDim values. */
    void CopyScriptStruct(void* Dest, void const* Src, int32 ArrayDim = 1) const;
    /** Resets values to their initial state. */
    void ClearScriptStruct(void* Dest, int32 ArrayDim = 1) const;
    bool CompareScriptStruct(const void* A, const void* B, uint32 PortFlags) const;
    uint32 GetStructTypeHash(const void* Src) const;
    virtual void InitializeStruct(void* Dest, int32 ArrayDim = 1) const override;
    virtual void DestroyStruct(void* Dest, int32 ArrayDim = 1) const override;
    virtual void Link(bool bComputeLayout) override;

    /** "FVector". */
    FString GetStructCPPName(uint32 CPPExportFlags = 0) const { return FString(GetPrefixCPP()) + GetName(); }
    bool HasDefaults() const { return false; }
    bool IsNative() const { return (StructFlags & STRUCT_Native) != 0; }

    /**
     * Appends "(A=1,B=2)", or the text the C++ type's ExportTextItem writes. Members equal to Defaults' are left out
     * (Defaults null: none are).
     */
    void ExportText(FString& ValueStr, const void* Value, const void* Defaults, UObject* OwnerObject, int32 PortFlags,
        UObject* ExportRootScope, bool bAllowNativeOverride = true) const;
    /** Reads what ExportText writes; members not named keep their values. Null on error. */
    const TCHAR* ImportText(const TCHAR* Buffer, void* Value, UObject* OwnerObject, int32 PortFlags,
        FOutputDevice* ErrorText, const FString& StructName, bool bAllowNativeOverride = true) const;

private:
    ICppStructOps* CppStructOps = nullptr;
};

/** A UFUNCTION, or the signature of a delegate. */
class COREUOBJECT_API UFunction : public UStruct {
    UE_DECLARE_INTRINSIC(UFunction, UStruct, CLASS_None, CASTCLASS_UFunction)

    EFunctionFlags FunctionFlags = FUNC_None;
    /** Number of parameters, return value included. */
    uint8 NumParms = 0;
    /** Size of the parameter block. */
    uint16 ParmsSize = 0;
    /** Offset of the return value, or MAX_uint16. */
    uint16 ReturnValueOffset = 0xFFFF;
    uint16 RPCId = 0;
    uint16 RPCResponseId = 0;
    FProperty* FirstPropertyToInit = nullptr;

    FNativeFuncPtr GetNativeFunc() const { return Func; }
    void SetNativeFunc(FNativeFuncPtr InFunc) { Func = InFunc; }
    /** Calls the native function. */
    void Invoke(UObject* Obj, FFrame& Stack, RESULT_DECL);
    /** The function's class. */
    UClass* GetOuterUClass() const;
    UClass* GetOuterUClassUnchecked() const { return reinterpret_cast<UClass*>(GetOuter()); }
    /** The same function of the super class, or null. */
    UFunction* GetSuperFunction() const;
    /** The return value's property, or null. */
    FProperty* GetReturnProperty() const;
    bool HasAnyFunctionFlags(EFunctionFlags FlagsToCheck) const { return (FunctionFlags & FlagsToCheck) != 0; }
    bool HasAllFunctionFlags(EFunctionFlags FlagsToCheck) const {
        return (FunctionFlags & FlagsToCheck) == FlagsToCheck;
    }
    bool IsSignatureCompatibleWith(const UFunction* OtherFunction) const;
    virtual const TCHAR* GetPrefixCPP() const override { return TEXT("F"); }
    virtual void Link(bool bComputeLayout) override;
    void Bind();
    /** Derives NumParms, ParmsSize and ReturnValueOffset from the properties. */
    void InitializeDerivedMembers();

private:
    FNativeFuncPtr Func = nullptr;
};

/** Signature of a dynamic delegate ("Name__DelegateSignature"). */
class COREUOBJECT_API UDelegateFunction : public UFunction {
    UE_DECLARE_INTRINSIC(UDelegateFunction, UFunction, CLASS_None, CASTCLASS_UDelegateFunction)
};

/** Signature of a sparse delegate. */
class COREUOBJECT_API USparseDelegateFunction : public UDelegateFunction {
    UE_DECLARE_INTRINSIC(USparseDelegateFunction, UDelegateFunction, CLASS_None, CASTCLASS_USparseDelegateFunction)

    FName OwningClassName;
    FName DelegateName;
};

/** Appended to delegate names to name their signature functions. */
#define HEADER_GENERATED_DELEGATE_SIGNATURE_SUFFIX TEXT("__DelegateSignature")

/** Flags of an enum. */
enum class EEnumFlags {
    None = 0,
    Flags = 1 << 0,
    NewerVersionExists = 1 << 1,
};
ENUM_CLASS_FLAGS(EEnumFlags)

/** How names given to UEnum are taken. */
enum class EGetByNameFlags {
    None = 0,
    ErrorIfNotFound = 1 << 0,
    CaseSensitive = 1 << 1,
    CheckAuthoredName = 1 << 2,
};
ENUM_CLASS_FLAGS(EGetByNameFlags)

/** A UENUM. Entry names are full ("EFoo::Bar" for enum classes and namespaced enums) and compare without case. */
class COREUOBJECT_API UEnum : public UField {
    UE_DECLARE_INTRINSIC(UEnum, UField, CLASS_None, CASTCLASS_UEnum)

    enum class ECppForm {
        /** `enum EFoo { A }` */
        Regular,
        /** `namespace EFoo { enum Type { A }; }` */
        Namespaced,
        /** `enum class EFoo { A }` */
        EnumClass
    };
    typedef FText (*FEnumDisplayNameFn)(int32);

    /** The C++ type: "EFoo", or "EFoo::Type". */
    FString CppType;

    virtual ~UEnum() override;
    /** Sets the entries; adds the hidden "<prefix>_MAX" unless one is there. False if an entry name is used elsewhere.
     */
    virtual bool SetEnums(TArray<TPair<FName, int64>>& InNames, ECppForm InCppForm,
        EEnumFlags InFlags = EEnumFlags::None, bool bAddMaxKeyIfMissing = true);
    /** Number of entries, _MAX included. */
    int32 NumEnums() const { return Names.Num(); }
    ECppForm GetCppForm() const { return CppForm; }
    bool HasAnyEnumFlags(EEnumFlags InFlags) const { return EnumHasAnyFlags(EnumFlags, InFlags); }
    void SetEnumDisplayNameFn(FEnumDisplayNameFn InEnumDisplayNameFn) { EnumDisplayNameFn = InEnumDisplayNameFn; }

    int32 GetIndexByName(FName InName, EGetByNameFlags Flags = EGetByNameFlags::None) const;
    int32 GetIndexByNameString(const FString& SearchString, EGetByNameFlags Flags = EGetByNameFlags::None) const;
    int32 GetIndexByValue(int64 InValue) const;
    FName GetNameByIndex(int32 Index) const;
    FName GetNameByValue(int64 InValue) const;
    /** Short name of an entry ("Bar"). */
    FString GetNameStringByIndex(int32 InIndex) const;
    FString GetNameStringByValue(int64 InValue) const;
    bool FindNameStringByValue(FString& Out, int64 InValue) const;
    virtual FString GetAuthoredNameStringByIndex(int32 InIndex) const { return GetNameStringByIndex(InIndex); }
    FString GetAuthoredNameStringByValue(int64 InValue) const { return GetNameStringByValue(InValue); }
    int64 GetValueByIndex(int32 Index) const;
    /** Value of a name, or INDEX_NONE. Full and short names are accepted. */
    int64 GetValueByName(FName InName, EGetByNameFlags Flags = EGetByNameFlags::None) const;
    int64 GetValueByNameString(const FString& SearchString, EGetByNameFlags Flags = EGetByNameFlags::None) const;
    int64 GetMaxEnumValue() const;
    bool IsValidEnumValue(int64 InValue) const { return GetIndexByValue(InValue) != INDEX_NONE; }
    bool IsValidEnumValueOrBitfield(int64 InValue) const;
    bool IsValidEnumName(FName InName) const { return GetIndexByName(InName) != INDEX_NONE; }
    /** Flags enums: "A | B"; others: the name. */
    FString GetValueOrBitfieldAsString(int64 InValue) const;
    FText GetDisplayNameTextByIndex(int32 InIndex) const;
    FText GetDisplayNameTextByValue(int64 InValue) const;
    bool FindDisplayNameTextByValue(FText& Out, int64 InValue) const;
    /** True if the entries as written contain a MAX entry. */
    bool ContainsExistingMax() const;
    /** Common prefix of the entries up to the last underscore, or the enum's name. */
    FString GenerateEnumPrefix() const;
    /** "EFoo::Bar" from "Bar" where the form asks for it. */
    virtual FString GenerateFullEnumName(const TCHAR* InEnumName) const;
    static FString GenerateFullEnumName(const UEnum* InEnum, const TCHAR* InEnumName) {
        return InEnum->GenerateFullEnumName(InEnumName);
    }
    static bool IsFullEnumName(const TCHAR* InEnumName) { return FString(InEnumName).Contains(TEXT("::")); }
    /** True if the last entry is the hidden MAX that SetEnums added. */
    bool HasGeneratedMax() const { return bHasGeneratedMax; }

    /** Value of a full entry name in any enum, or INDEX_NONE. */
    static int64 LookupEnumName(FName PackageName, FName TestName, UEnum** FoundEnum = nullptr);
    static int64 LookupEnumNameSlow(const TCHAR* TestShortName, UEnum** FoundEnum = nullptr);
    /** Reads "EFoo.Bar" or "Bar". */
    static int64 ParseEnum(const TCHAR*& Str);

    template <typename EnumType>
    static FString GetValueAsString(const EnumType EnumeratorValue) {
        const UEnum* Enum = StaticEnumOf<EnumType>();
        return Enum->GetNameByValue(static_cast<int64>(EnumeratorValue)).ToString();
    }
    template <typename EnumType>
    static FName GetValueAsName(const EnumType EnumeratorValue) {
        return StaticEnumOf<EnumType>()->GetNameByValue(static_cast<int64>(EnumeratorValue));
    }
    template <typename EnumType>
    static FText GetDisplayValueAsText(const EnumType EnumeratorValue) {
        return StaticEnumOf<EnumType>()->GetDisplayNameTextByValue(static_cast<int64>(EnumeratorValue));
    }

#if WITH_METADATA
    using UField::FindMetaData;
    using UField::GetMetaData;
    using UField::HasMetaData;
    using UField::SetMetaData;
    /** Metadata of an entry, or of the enum for NameIndex INDEX_NONE. Stored on the enum under "Entry.Key". */
    bool HasMetaData(const TCHAR* Key, int32 NameIndex) const;
    FString GetMetaData(const TCHAR* Key, int32 NameIndex, bool bAllowRemap = true) const;
    void SetMetaData(const TCHAR* Key, const TCHAR* InValue, int32 NameIndex) const;
    FText GetToolTipTextByIndex(int32 NameIndex) const;
#endif

private:
    template <typename EnumType>
    static UEnum* StaticEnumOf();

    TArray<TPair<FName, int64>> Names;
    ECppForm CppForm = ECppForm::Regular;
    EEnumFlags EnumFlags = EEnumFlags::None;
    FEnumDisplayNameFn EnumDisplayNameFn = nullptr;
    bool bHasGeneratedMax = false;
};

/** An interface that a class implements. */
struct FImplementedInterface {
    TObjectPtr<UClass> Class;
    /** Offset of the I-class inside the object; 0 if implemented by script. */
    int32 PointerOffset = 0;
    bool bImplementedByK2 = false;

    FImplementedInterface() = default;
    FImplementedInterface(UClass* InClass, int32 InOffset, bool InImplementedByK2)
        : Class(InClass), PointerOffset(InOffset), bImplementedByK2(InImplementedByK2) {}
    bool operator==(const FImplementedInterface& Other) const {
        return Class == Other.Class && PointerOffset == Other.PointerOffset;
    }
};

/** A native function by name; see UClass::NativeFunctionLookupTable. */
struct FNativeFunctionLookup {
    FName Name;
    FNativeFuncPtr Pointer = nullptr;
};

/** Whether a search also looks at super classes. */
namespace EIncludeSuperFlag {
enum Type { ExcludeSuper, IncludeSuper };
}

/** A class of objects. */
class COREUOBJECT_API UClass : public UStruct {
    UE_DECLARE_INTRINSIC(UClass, UStruct, CLASS_None, CASTCLASS_UClass)

    typedef void (*ClassConstructorType)(const FObjectInitializer&);
    typedef void (*ClassAddReferencedObjectsType)(UObject*, FReferenceCollector&);
    typedef UClass* (*StaticClassFunctionType)();

    /** Runs the C++ constructor in place. */
    ClassConstructorType ClassConstructor = nullptr;
    /** The class's AddReferencedObjects. */
    ClassAddReferencedObjectsType ClassAddReferencedObjects = nullptr;
    mutable int32 ClassUnique = 0;
    EClassFlags ClassFlags = CLASS_None;
    EClassCastFlags ClassCastFlags = CASTCLASS_None;
    /** Objects of this class must be inside an object of this class. */
    TObjectPtr<UClass> ClassWithin;
    /** Name of the ini file for Config properties. */
    FName ClassConfigName;
    /** Interfaces named in this class's own base list. */
    TArray<FImplementedInterface> Interfaces;
    /** Native functions registered by the generated code. */
    TArray<FNativeFunctionLookup> NativeFunctionLookupTable;

    virtual ~UClass() override;

    UClass* GetSuperClass() const { return static_cast<UClass*>(GetSuperStruct()); }
    virtual void SetSuperStruct(UStruct* NewSuperStruct) override;
    EClassFlags GetClassFlags() const { return ClassFlags; }
    bool HasAnyClassFlags(EClassFlags FlagsToCheck) const { return (ClassFlags & FlagsToCheck) != 0; }
    bool HasAllClassFlags(EClassFlags FlagsToCheck) const { return (ClassFlags & FlagsToCheck) == FlagsToCheck; }
    bool HasAnyCastFlag(EClassCastFlags FlagToCheck) const { return (ClassCastFlags & FlagToCheck) != 0; }
    bool HasAllCastFlags(EClassCastFlags FlagsToCheck) const { return (ClassCastFlags & FlagsToCheck) == FlagsToCheck; }
    /** "A" for actors, "U" for others; deprecated ones "ADEPRECATED_", "UDEPRECATED_". */
    virtual const TCHAR* GetPrefixCPP() const override;
    FName GetConfigNameAsFName() const { return ClassConfigName; }
    FString GetConfigName() const;
    FTopLevelAssetPath GetClassPathName() const { return GetStructPathName(); }
    FString GetDescription() const { return GetName(); }

    /** The class default object, created if missing and asked for. */
    UObject* GetDefaultObject(bool bCreateIfNeeded = true) const {
        if (ClassDefaultObject == nullptr && bCreateIfNeeded) {
            const_cast<UClass*>(this)->CreateDefaultObject();
        }
        return ClassDefaultObject;
    }
    template <class T>
    T* GetDefaultObject() const {
        UObject* Object = GetDefaultObject();
        check(Object->IsA<T>());
        return static_cast<T*>(Object);
    }
    virtual void PostInitInstance(UObject* InObj, FObjectInstancingGraph* InstanceGraph) {}
    /** "Default__Name". */
    FName GetDefaultObjectName() const;
    UObject* GetDefaultSubobjectByName(FName ToFind);
    void GetDefaultObjectSubobjects(TArray<UObject*>& OutDefaultSubobjects);
    virtual UObject* CreateDefaultObject();

    /** The function of that name: own ones first, then interfaces', then (if asked) the super class's. Null if there is
     * none. */
    UFunction* FindFunctionByName(
        FName InName, EIncludeSuperFlag::Type IncludeSuper = EIncludeSuperFlag::IncludeSuper) const;
    /** Names of this class's own functions. */
    void GenerateFunctionList(TArray<FName>& OutArray) const;
    void AddFunctionToFunctionMap(UFunction* Function, FName FuncName) { FuncMap.Add(FuncName, Function); }
    void RemoveFunctionFromFunctionMap(UFunction* Function) { FuncMap.Remove(Function->GetFName()); }
    bool IsFunctionImplementedInScript(FName InFunctionName) const;
    void AddNativeFunction(const ANSICHAR* InName, FNativeFuncPtr InPointer);
    void AddNativeFunction(const TCHAR* InName, FNativeFuncPtr InPointer);

    /** True if this class or a super implements the interface or a child of it. */
    bool ImplementsInterface(const class UClass* SomeInterface) const;
    /** Adds function objects as children and to the function map; for generated code. */
    void LinkChildFunction(UFunction* Function);

    virtual void Link(bool bComputeLayout) override;
    static UClass* FindCommonBase(UClass* InClassA, UClass* InClassB);
    bool IsClassGroupName(const TCHAR* InGroupName) const { return false; }

    static void AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector);

private:
    TMap<FName, UFunction*> FuncMap;
    TObjectPtr<UObject> ClassDefaultObject;
    friend struct FObjectSystem;
};

/** Any class, for generated tables that need "UDynamicClass"-like names. */
template <class TClass>
UClass* StaticClass() {
    return TClass::StaticClass();
}
/** The UScriptStruct of a USTRUCT type. */
template <class T>
UScriptStruct* StaticStruct() {
    return T::StaticStruct();
}

/** The UScriptStruct of USTRUCTs and of the core types that are reflected without being USTRUCTs (FVector, FColor,
 * ...). */
template <class T>
struct TBaseStructure {
    static UScriptStruct* Get() { return T::StaticStruct(); }
};

namespace UE::CoreUObject::Private {
/** The UEnum whose CppType is the given type name; fatal if it does not exist. */
COREUOBJECT_API UEnum* FindEnumOfCppType(const char* TypeName);

/** Name of a type as the compiler spells it, without the words around it. */
template <typename T>
constexpr auto TypeNameOf() {
#if defined(__clang__)
    constexpr std::string_view Function = __PRETTY_FUNCTION__;
    constexpr std::string_view Start = "[T = ";
#else
    constexpr std::string_view Function = __PRETTY_FUNCTION__;
    constexpr std::string_view Start = "[with T = ";
#endif
    constexpr SIZE_T Begin = Function.find(Start) + Start.size();
    constexpr SIZE_T Length = Function.size() - 1 - Begin;
    struct FName {
        char Text[Length + 1] = {};
    } Result;
    for (SIZE_T Index = 0; Index < Length; ++Index) {
        Result.Text[Index] = Function[Begin + Index];
    }
    return Result;
}
} // namespace UE::CoreUObject::Private

/** The UEnum of a UENUM type. */
template <typename EnumType>
UEnum* StaticEnum() {
    static_assert(std::is_enum_v<EnumType>, "StaticEnum needs an enum type.");
    static UEnum* const Enum = [] {
        static constexpr auto Name = UE::CoreUObject::Private::TypeNameOf<EnumType>();
        return UE::CoreUObject::Private::FindEnumOfCppType(Name.Text);
    }();
    return Enum;
}
template <typename EnumType>
UEnum* UEnum::StaticEnumOf() {
    return StaticEnum<EnumType>();
}

/** Subclasses of a class. */
COREUOBJECT_API void GetDerivedClasses(const UClass* ClassToLookFor, TArray<UClass*>& Results, bool bRecursive = true);

#include "UObject/BaseStructures.h"
