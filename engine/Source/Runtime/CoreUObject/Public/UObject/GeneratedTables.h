// SPDX-License-Identifier: MIT
// What generated registration code is made of: constant tables, one per class, struct, enum, function, delegate and
// property, and registrars that hand them to the run time when their library is loaded. Nothing is built then;
// ProcessNewlyLoadedUObjects() builds packages, enums, structs, classes and class default objects later, in dependency
// order. Texts in tables are UTF-8. This is our own design; Unreal's counterpart is private to its header tool.
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"
#include "UObject/Script.h"

class FObjectInitializer;
class FReferenceCollector;
class UClass;
class UEnum;
class UFunction;
class UObject;
class UScriptStruct;
class UStruct;

namespace GeneratedTables {

/** A metadata pair. */
struct FMetaPair {
    const char* Key;
    const char* Value;
};

/** Which FProperty class a property gets. */
enum class EPropertyKind : uint8 {
    Bool,
    Int8,
    Int16,
    Int32,
    Int64,
    UInt8,
    UInt16,
    UInt32,
    UInt64,
    Float,
    Double,
    String,
    Name,
    Text,
    Enum,     // FEnumProperty; Underlying says which number is below it
    ByteEnum, // FByteProperty with an enum
    Object,
    Class,
    WeakObject,
    LazyObject,
    SoftObject,
    SoftClass,
    Interface,
    Struct,
    Array,
    Set,
    Map,
    Optional,
    Delegate,
    MulticastDelegate,
    SparseDelegate,
    FieldPath,
};

/** One property: a member, parameter, return value, or an element, key or value of another property. Unused parts are
 * null. */
struct FPropertyTable {
    const char* Name;
    EPropertyKind Kind;
    EPropertyKind Underlying = EPropertyKind::UInt8; // Enum
    /** Declared flags; those computed from the type are added when the property is linked. */
    uint64 Flags = 0;
    int32 ArrayDim = 1;
    /** In the class, struct or parameter block. 0 for elements, keys, values, and for bit-fields (found with SetBit).
     */
    int32 Offset = 0;
    /** sizeof one element as the C++ compiler sees it: checked against FProperty::ElementSize. 0: unknown (inner,
     * bit-field). */
    int32 ElementSize = 0;
    /** Enum, ByteEnum. */
    UEnum* (*EnumFunc)() = nullptr;
    /** Struct. */
    UScriptStruct* (*StructFunc)() = nullptr;
    /** Object, weak, lazy, soft: the class; Class, SoftClass: the meta class; Interface: the U class. */
    UClass* (*ClassFunc)() = nullptr;
    /** Delegates. */
    UFunction* (*SignatureFunc)() = nullptr;
    /** Array, Set, Optional: element. Map: value. */
    const FPropertyTable* Inner = nullptr;
    /** Map. */
    const FPropertyTable* Key = nullptr;
    /** Bool bit-fields: sets the bit in an object or struct of OuterSize bytes. Null for a native bool. */
    void (*SetBit)(void* Container) = nullptr;
    int32 OuterSize = 0;
    void (*Setter)(void* Container, const void* Value) = nullptr;
    void (*Getter)(const void* Container, void* Value) = nullptr;
    const char* RepNotify = nullptr;
    /** FieldPath: name of the FFieldClass. */
    const char* FieldClass = nullptr;
    const FMetaPair* Meta = nullptr;
    int32 NumMeta = 0;
};

/** A function, or the signature of a delegate. The return value, if any, is the last parameter. */
struct FFunctionTable {
    const char* Name; // for delegates with "__DelegateSignature"
    EFunctionFlags Flags;
    /** Size and alignment of the parameter block. */
    int32 ParmsSize;
    int32 ParmsAlignment;
    const FPropertyTable* const* Parameters = nullptr;
    int32 NumParameters = 0;
    const FMetaPair* Meta = nullptr;
    int32 NumMeta = 0;
    /** Delegates only: 1 single, 2 multicast, 3 sparse; 0 for functions. */
    uint8 DelegateForm = 0;
    /** Delegates declared inside a class. */
    UClass* (*OwnerFunc)() = nullptr;
    /** Sparse delegates: the class and property that own them. */
    const char* SparseOwner = nullptr;
    const char* SparseProperty = nullptr;
};

/** An interface that a class implements. */
struct FInterfaceTable {
    UClass* (*InterfaceFunc)();
    /** Byte offset of the I class in the implementing class. */
    int32 Offset;
};

struct FClassTable {
    const TCHAR* Package;   // "/Script/Engine"
    const char* Name;       // "Actor"
    UClass* (*SuperFunc)(); // null for UObject
    UClass* (*WithinFunc)();
    int32 Size;
    int32 Alignment;
    EClassFlags Flags;
    const TCHAR* ConfigName; // ini file without extension, "" if none
    void (*Constructor)(const FObjectInitializer&);
    void (*AddReferencedObjects)(UObject*, FReferenceCollector&);
    const FNameNativePtrPair* Natives = nullptr;
    int32 NumNatives = 0;
    const FFunctionTable* const* Functions = nullptr;
    int32 NumFunctions = 0;
    const FPropertyTable* const* Properties = nullptr;
    int32 NumProperties = 0;
    const FInterfaceTable* Interfaces = nullptr;
    int32 NumInterfaces = 0;
    const FMetaPair* Meta = nullptr;
    int32 NumMeta = 0;
};

struct FStructTable {
    const TCHAR* Package;
    const char* Name; // "HitResult"
    UScriptStruct* (*SuperFunc)();
    int32 Size;
    int32 Alignment;
    EStructFlags Flags;
    /** Makes UScriptStruct::TCppStructOps<T>; a void pointer so that this header needs no more. */
    void* (*NewStructOps)();
    const FPropertyTable* const* Properties = nullptr;
    int32 NumProperties = 0;
    const FMetaPair* Meta = nullptr;
    int32 NumMeta = 0;
};

struct FEnumEntryTable {
    const char* Name; // as UEnum holds it: "EFoo::Bar", "ECC_WorldStatic"
    int64 Value;
    const FMetaPair* Meta = nullptr; // keys without the entry's name; "Name" is among them
    int32 NumMeta = 0;
};

struct FEnumTable {
    const TCHAR* Package;
    const char* Name;
    const char* CppType;
    uint8 Form;  // UEnum::ECppForm
    uint8 Flags; // EEnumFlags
    const FEnumEntryTable* Entries;
    int32 NumEntries;
    const FMetaPair* Meta = nullptr;
    int32 NumMeta = 0;
};

/**
 * The UClass of a table, without properties and functions yet (its name, package, super, size, flags, constructor and
 * native functions stand): what StaticClass() returns at any time, also while other classes are being built. Result is
 * the storage behind StaticClass().
 */
COREUOBJECT_API void MakeClassShell(const FClassTable& Table, UClass*& Result);

/** The finished struct, enum or signature; built on the first call. Result is the storage behind the generated
 * accessor. */
COREUOBJECT_API UScriptStruct* FindOrBuildStruct(const FStructTable& Table, UScriptStruct*& Result);
COREUOBJECT_API UEnum* FindOrBuildEnum(const FEnumTable& Table, UEnum*& Result);
COREUOBJECT_API UFunction* FindOrBuildDelegate(const TCHAR* Package, const FFunctionTable& Table, UFunction*& Result);

/** One class of a header, for ProcessNewlyLoadedUObjects(). */
struct FClassEntry {
    UClass* (*StaticClassFunc)();
    const FClassTable* Table;
};

/** Hands the tables of one header to the run time; a static object in each generated file. Links itself into a list,
 * nothing more. */
struct FHeaderRegistrar {
    COREUOBJECT_API FHeaderRegistrar(const FClassEntry* InClasses, int32 InNumClasses,
        UScriptStruct* (*const* InStructs)(), int32 InNumStructs, UEnum* (*const* InEnums)(), int32 InNumEnums,
        UFunction* (*const* InDelegates)(), int32 InNumDelegates);

    const FClassEntry* Classes;
    int32 NumClasses;
    UScriptStruct* (*const* Structs)();
    int32 NumStructs;
    UEnum* (*const* Enums)();
    int32 NumEnums;
    UFunction* (*const* Delegates)();
    int32 NumDelegates;
    FHeaderRegistrar* Next = nullptr;
};

/** Makes the package of a module exist, also if it reflects nothing; a static object in MODULE.init.gen.cpp. */
struct FPackageRegistrar {
    COREUOBJECT_API explicit FPackageRegistrar(const TCHAR* InPackage);

    const TCHAR* Package;
    FPackageRegistrar* Next = nullptr;
};

} // namespace GeneratedTables
