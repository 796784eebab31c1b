// SPDX-License-Identifier: MIT
// Flags of objects, classes, structs and properties, and the macros of reflected declarations.
// Mirrors Epic's "UObject/ObjectMacros.h" (API pages EObjectFlags, EClassFlags, EClassCastFlags, EStructFlags,
// EPropertyFlags).
#pragma once

#include "CoreMinimal.h"
#include "UObject/Script.h"

class FObjectInitializer;
class FReferenceCollector;
class UClass;
class UEnum;
class UObject;
class UPackage;
class UScriptStruct;
struct FFrame;

/** 1 in every compiler that sees real C++; our header tool sees 0 and reads the NoExport mirrors below `#if !CPP`. */
#ifndef CPP
#define CPP 1
#endif

/** Tag type of the placement new that builds objects; user code never makes one. */
enum EInternal { EC_InternalUseOnlyConstructor };
enum EStaticConstructor { EC_StaticConstructor };

/** Options of StaticLoadObject and friends. */
enum ELoadFlags {
    LOAD_None = 0x00000000,
    LOAD_Async = 0x00000001,
    LOAD_NoWarn = 0x00000002,
    LOAD_EditorOnly = 0x00000004,
    LOAD_Quiet = 0x00002000,
    LOAD_FindIfFail = 0x00004000,
    LOAD_MemoryReader = 0x00008000,
    LOAD_NoRedirects = 0x00010000,
    LOAD_ForDiff = 0x00020000,
    LOAD_DisableDependencyPreloading = 0x00001000,
    LOAD_PackageForPIE = 0x00080000,
};

/** Flags of a package. */
enum EPackageFlags : uint32 {
    PKG_None = 0x00000000,
    PKG_NewlyCreated = 0x00000001,
    PKG_ClientOptional = 0x00000002,
    PKG_ServerSideOnly = 0x00000004,
    PKG_CompiledIn = 0x00000010,
    PKG_ForDiffing = 0x00000020,
    PKG_EditorOnly = 0x00000040,
    PKG_Developer = 0x00000080,
    PKG_ContainsMap = 0x00020000,
    PKG_PlayInEditor = 0x00100000,
    PKG_ContainsScript = 0x00200000,
    PKG_RuntimeGenerated = 0x20000000,
};
ENUM_CLASS_FLAGS(EPackageFlags)

/** Flags of a class. */
enum EClassFlags : uint32 {
    CLASS_None = 0x00000000u,
    CLASS_Abstract = 0x00000001u,
    CLASS_DefaultConfig = 0x00000002u,
    CLASS_Config = 0x00000004u,
    CLASS_Transient = 0x00000008u,
    CLASS_Optional = 0x00000010u,
    CLASS_MatchedSerializers = 0x00000020u,
    CLASS_ProjectUserConfig = 0x00000040u,
    CLASS_Native = 0x00000080u,
    CLASS_NoExport = 0x00000100u,
    CLASS_NotPlaceable = 0x00000200u,
    CLASS_PerObjectConfig = 0x00000400u,
    CLASS_ReplicationDataIsSetUp = 0x00000800u,
    CLASS_EditInlineNew = 0x00001000u,
    CLASS_CollapseCategories = 0x00002000u,
    CLASS_Interface = 0x00004000u,
    CLASS_PerPlatformConfig = 0x00008000u,
    CLASS_Const = 0x00010000u,
    CLASS_NeedsDeferredDependencyLoading = 0x00020000u,
    CLASS_CompiledFromBlueprint = 0x00040000u,
    CLASS_MinimalAPI = 0x00080000u,
    CLASS_RequiredAPI = 0x00100000u,
    CLASS_DefaultToInstanced = 0x00200000u,
    CLASS_TokenStreamAssembled = 0x00400000u,
    CLASS_HasInstancedReference = 0x00800000u,
    CLASS_Hidden = 0x01000000u,
    CLASS_Deprecated = 0x02000000u,
    CLASS_HideDropDown = 0x04000000u,
    CLASS_GlobalUserConfig = 0x08000000u,
    CLASS_Intrinsic = 0x10000000u,
    CLASS_Constructed = 0x20000000u,
    CLASS_ConfigDoNotCheckDefaults = 0x40000000u,
    CLASS_NewerVersionExists = 0x80000000u,
};
ENUM_CLASS_FLAGS(EClassFlags)

/** Class flags a subclass inherits. */
#define CLASS_Inherit                                                                                                  \
    ((EClassFlags)(CLASS_Transient | CLASS_Optional | CLASS_DefaultConfig | CLASS_Config | CLASS_PerObjectConfig |     \
                   CLASS_ConfigDoNotCheckDefaults | CLASS_NotPlaceable | CLASS_Const | CLASS_HasInstancedReference |   \
                   CLASS_Deprecated | CLASS_DefaultToInstanced | CLASS_GlobalUserConfig | CLASS_ProjectUserConfig |    \
                   CLASS_PerPlatformConfig | CLASS_NeedsDeferredDependencyLoading))
#define CLASS_ScriptInherit ((EClassFlags)(CLASS_Inherit | CLASS_EditInlineNew | CLASS_CollapseCategories))
#define CLASS_AllFlags ((EClassFlags)0xFFFFFFFFu)

/** One bit per core class, so that casts to it need no walk up the hierarchy. */
enum EClassCastFlags : uint64 {
    CASTCLASS_None = 0x0000000000000000,
    CASTCLASS_UField = 0x0000000000000001,
    CASTCLASS_FInt8Property = 0x0000000000000002,
    CASTCLASS_UEnum = 0x0000000000000004,
    CASTCLASS_UStruct = 0x0000000000000008,
    CASTCLASS_UScriptStruct = 0x0000000000000010,
    CASTCLASS_UClass = 0x0000000000000020,
    CASTCLASS_FByteProperty = 0x0000000000000040,
    CASTCLASS_FIntProperty = 0x0000000000000080,
    CASTCLASS_FFloatProperty = 0x0000000000000100,
    CASTCLASS_FUInt64Property = 0x0000000000000200,
    CASTCLASS_FClassProperty = 0x0000000000000400,
    CASTCLASS_FUInt32Property = 0x0000000000000800,
    CASTCLASS_FInterfaceProperty = 0x0000000000001000,
    CASTCLASS_FNameProperty = 0x0000000000002000,
    CASTCLASS_FStrProperty = 0x0000000000004000,
    CASTCLASS_FProperty = 0x0000000000008000,
    CASTCLASS_FObjectProperty = 0x0000000000010000,
    CASTCLASS_FBoolProperty = 0x0000000000020000,
    CASTCLASS_FUInt16Property = 0x0000000000040000,
    CASTCLASS_UFunction = 0x0000000000080000,
    CASTCLASS_FStructProperty = 0x0000000000100000,
    CASTCLASS_FArrayProperty = 0x0000000000200000,
    CASTCLASS_FInt64Property = 0x0000000000400000,
    CASTCLASS_FDelegateProperty = 0x0000000000800000,
    CASTCLASS_FNumericProperty = 0x0000000001000000,
    CASTCLASS_FMulticastDelegateProperty = 0x0000000002000000,
    CASTCLASS_FObjectPropertyBase = 0x0000000004000000,
    CASTCLASS_FWeakObjectProperty = 0x0000000008000000,
    CASTCLASS_FLazyObjectProperty = 0x0000000010000000,
    CASTCLASS_FSoftObjectProperty = 0x0000000020000000,
    CASTCLASS_FTextProperty = 0x0000000040000000,
    CASTCLASS_FInt16Property = 0x0000000080000000,
    CASTCLASS_FDoubleProperty = 0x0000000100000000,
    CASTCLASS_FSoftClassProperty = 0x0000000200000000,
    CASTCLASS_UPackage = 0x0000000400000000,
    CASTCLASS_ULevel = 0x0000000800000000,
    CASTCLASS_AActor = 0x0000001000000000,
    CASTCLASS_APlayerController = 0x0000002000000000,
    CASTCLASS_APawn = 0x0000004000000000,
    CASTCLASS_USceneComponent = 0x0000008000000000,
    CASTCLASS_UPrimitiveComponent = 0x0000010000000000,
    CASTCLASS_USkinnedMeshComponent = 0x0000020000000000,
    CASTCLASS_USkeletalMeshComponent = 0x0000040000000000,
    CASTCLASS_UBlueprint = 0x0000080000000000,
    CASTCLASS_UDelegateFunction = 0x0000100000000000,
    CASTCLASS_UStaticMeshComponent = 0x0000200000000000,
    CASTCLASS_FMapProperty = 0x0000400000000000,
    CASTCLASS_FSetProperty = 0x0000800000000000,
    CASTCLASS_FEnumProperty = 0x0001000000000000,
    CASTCLASS_USparseDelegateFunction = 0x0002000000000000,
    CASTCLASS_FMulticastInlineDelegateProperty = 0x0004000000000000,
    CASTCLASS_FMulticastSparseDelegateProperty = 0x0008000000000000,
    CASTCLASS_FFieldPathProperty = 0x0010000000000000,
    CASTCLASS_FOptionalProperty = 0x0100000000000000,
    CASTCLASS_AllFlags = 0xFFFFFFFFFFFFFFFF,
};
ENUM_CLASS_FLAGS(EClassCastFlags)

/** Flags of a property. */
enum EPropertyFlags : uint64 {
    CPF_None = 0,
    CPF_Edit = 0x0000000000000001,
    CPF_ConstParm = 0x0000000000000002,
    CPF_BlueprintVisible = 0x0000000000000004,
    CPF_ExportObject = 0x0000000000000008,
    CPF_BlueprintReadOnly = 0x0000000000000010,
    CPF_Net = 0x0000000000000020,
    CPF_EditFixedSize = 0x0000000000000040,
    CPF_Parm = 0x0000000000000080,
    CPF_OutParm = 0x0000000000000100,
    CPF_ZeroConstructor = 0x0000000000000200,
    CPF_ReturnParm = 0x0000000000000400,
    CPF_DisableEditOnTemplate = 0x0000000000000800,
    CPF_NonNullable = 0x0000000000001000,
    CPF_Transient = 0x0000000000002000,
    CPF_Config = 0x0000000000004000,
    CPF_RequiredParm = 0x0000000000008000,
    CPF_DisableEditOnInstance = 0x0000000000010000,
    CPF_EditConst = 0x0000000000020000,
    CPF_GlobalConfig = 0x0000000000040000,
    CPF_InstancedReference = 0x0000000000080000,
    CPF_ExperimentalExternalObjects = 0x0000000000100000,
    CPF_DuplicateTransient = 0x0000000000200000,
    CPF_SaveGame = 0x0000000001000000,
    CPF_NoClear = 0x0000000002000000,
    CPF_Virtual = 0x0000000004000000,
    CPF_ReferenceParm = 0x0000000008000000,
    CPF_BlueprintAssignable = 0x0000000010000000,
    CPF_Deprecated = 0x0000000020000000,
    CPF_IsPlainOldData = 0x0000000040000000,
    CPF_RepSkip = 0x0000000080000000,
    CPF_RepNotify = 0x0000000100000000,
    CPF_Interp = 0x0000000200000000,
    CPF_NonTransactional = 0x0000000400000000,
    CPF_EditorOnly = 0x0000000800000000,
    CPF_NoDestructor = 0x0000001000000000,
    CPF_AutoWeak = 0x0000004000000000,
    CPF_ContainsInstancedReference = 0x0000008000000000,
    CPF_AssetRegistrySearchable = 0x0000010000000000,
    CPF_SimpleDisplay = 0x0000020000000000,
    CPF_AdvancedDisplay = 0x0000040000000000,
    CPF_Protected = 0x0000080000000000,
    CPF_BlueprintCallable = 0x0000100000000000,
    CPF_BlueprintAuthorityOnly = 0x0000200000000000,
    CPF_TextExportTransient = 0x0000400000000000,
    CPF_NonPIEDuplicateTransient = 0x0000800000000000,
    CPF_ExposeOnSpawn = 0x0001000000000000,
    CPF_PersistentInstance = 0x0002000000000000,
    CPF_UObjectWrapper = 0x0004000000000000,
    CPF_HasGetValueTypeHash = 0x0008000000000000,
    CPF_NativeAccessSpecifierPublic = 0x0010000000000000,
    CPF_NativeAccessSpecifierProtected = 0x0020000000000000,
    CPF_NativeAccessSpecifierPrivate = 0x0040000000000000,
    CPF_SkipSerialization = 0x0080000000000000,
    CPF_TObjectPtr = 0x0100000000000000,
    CPF_ExperimentalOverridableLogic = 0x0200000000000000,
    CPF_ExperimentalAlwaysOverriden = 0x0400000000000000,
    CPF_ExperimentalNeverOverriden = 0x0800000000000000,
    CPF_AllowSelfReference = 0x1000000000000000,
};
ENUM_CLASS_FLAGS(EPropertyFlags)

#define CPF_NativeAccessSpecifiers                                                                                     \
    ((EPropertyFlags)(CPF_NativeAccessSpecifierPublic | CPF_NativeAccessSpecifierProtected |                           \
                      CPF_NativeAccessSpecifierPrivate))
/** All parameter flags. */
#define CPF_ParmFlags                                                                                                  \
    ((EPropertyFlags)(CPF_Parm | CPF_OutParm | CPF_ReturnParm | CPF_RequiredParm | CPF_ReferenceParm | CPF_ConstParm))
/** Flags that pass from a container to its inner properties. */
#define CPF_PropagateToArrayInner                                                                                      \
    ((EPropertyFlags)(CPF_ExportObject | CPF_PersistentInstance | CPF_InstancedReference |                             \
                      CPF_ContainsInstancedReference | CPF_Config | CPF_EditConst | CPF_Deprecated | CPF_EditorOnly |  \
                      CPF_AutoWeak | CPF_UObjectWrapper))
/** Flags the run time computes itself; the header tool never sets them. */
#define CPF_ComputedFlags                                                                                              \
    ((EPropertyFlags)(CPF_IsPlainOldData | CPF_NoDestructor | CPF_ZeroConstructor | CPF_HasGetValueTypeHash))
#define CPF_AllFlags ((EPropertyFlags)0xFFFFFFFFFFFFFFFF)

/** Flags of an object instance. */
enum EObjectFlags : uint32 {
    RF_NoFlags = 0x00000000,
    RF_Public = 0x00000001,
    RF_Standalone = 0x00000002,
    RF_MarkAsNative = 0x00000004,
    RF_Transactional = 0x00000008,
    RF_ClassDefaultObject = 0x00000010,
    RF_ArchetypeObject = 0x00000020,
    RF_Transient = 0x00000040,
    RF_MarkAsRootSet = 0x00000080,
    RF_TagGarbageTemp = 0x00000100,
    RF_NeedInitialization = 0x00000200,
    RF_NeedLoad = 0x00000400,
    RF_KeepForCooker = 0x00000800,
    RF_NeedPostLoad = 0x00001000,
    RF_NeedPostLoadSubobjects = 0x00002000,
    RF_NewerVersionExists = 0x00004000,
    RF_BeginDestroyed = 0x00008000,
    RF_FinishDestroyed = 0x00010000,
    RF_BeingRegenerated = 0x00020000,
    RF_DefaultSubObject = 0x00040000,
    RF_WasLoaded = 0x00080000,
    RF_TextExportTransient = 0x00100000,
    RF_LoadCompleted = 0x00200000,
    RF_InheritableComponentTemplate = 0x00400000,
    RF_DuplicateTransient = 0x00800000,
    RF_StrongRefOnFrame = 0x01000000,
    RF_NonPIEDuplicateTransient = 0x02000000,
    RF_WillBeLoaded = 0x08000000,
    RF_HasExternalPackage = 0x10000000,
    RF_MirroredGarbage = 0x40000000,
    RF_AllocatedInSharedPage = 0x80000000,
};
ENUM_CLASS_FLAGS(EObjectFlags)

#define RF_AllFlags ((EObjectFlags)0xFFFFFFFF)
#define RF_Load                                                                                                        \
    ((EObjectFlags)(RF_Public | RF_Standalone | RF_Transactional | RF_ClassDefaultObject | RF_ArchetypeObject |        \
                    RF_DefaultSubObject | RF_TextExportTransient | RF_InheritableComponentTemplate |                   \
                    RF_DuplicateTransient | RF_NonPIEDuplicateTransient))
/** Sub-objects inherit these flags from their outer. */
#define RF_PropagateToSubObjects ((EObjectFlags)(RF_Public | RF_ArchetypeObject | RF_Transactional | RF_Transient))
/** Objects a garbage collection keeps: none outside the editor (Epic: GARBAGE_COLLECTION_KEEPFLAGS). */
#define GARBAGE_COLLECTION_KEEPFLAGS (WITH_EDITOR ? RF_Standalone : RF_NoFlags)

/** Flags kept beside the object in GUObjectArray. */
enum class EInternalObjectFlags : int32 {
    None = 0,
    LoaderImport = 1 << 20,
    Garbage = 1 << 21,
    AsyncLoadingPhase1 = 1 << 22,
    ReachableInCluster = 1 << 23,
    ClusterRoot = 1 << 24,
    Native = 1 << 25,
    Async = 1 << 26,
    AsyncLoadingPhase2 = 1 << 27,
    Unreachable = 1 << 28,
    RefCounted = 1 << 29,
    RootSet = 1 << 30,
};
ENUM_CLASS_FLAGS(EInternalObjectFlags)

/** Internal flags that keep an object alive whatever refers to it. */
inline constexpr EInternalObjectFlags EInternalObjectFlags_RootFlags = static_cast<EInternalObjectFlags>(
    static_cast<int32>(EInternalObjectFlags::RootSet) | static_cast<int32>(EInternalObjectFlags::Native));
inline constexpr EInternalObjectFlags EInternalObjectFlags_GarbageCollectionKeepFlags = EInternalObjectFlags::Native;

/** Flags of a UScriptStruct. */
enum EStructFlags : uint32 {
    STRUCT_NoFlags = 0x00000000,
    STRUCT_Native = 0x00000001,
    STRUCT_IdenticalNative = 0x00000002,
    STRUCT_HasInstancedReference = 0x00000004,
    STRUCT_NoExport = 0x00000008,
    STRUCT_Atomic = 0x00000010,
    STRUCT_Immutable = 0x00000020,
    STRUCT_AddStructReferencedObjects = 0x00000040,
    STRUCT_RequiredAPI = 0x00000200,
    STRUCT_NetSerializeNative = 0x00000400,
    STRUCT_SerializeNative = 0x00000800,
    STRUCT_CopyNative = 0x00001000,
    STRUCT_IsPlainOldData = 0x00002000,
    STRUCT_NoDestructor = 0x00004000,
    STRUCT_ZeroConstructor = 0x00008000,
    STRUCT_ExportTextItemNative = 0x00010000,
    STRUCT_ImportTextItemNative = 0x00020000,
    STRUCT_PostSerializeNative = 0x00040000,
    STRUCT_SerializeFromMismatchedTag = 0x00080000,
    STRUCT_NetDeltaSerializeNative = 0x00100000,
    STRUCT_PostScriptConstruct = 0x00200000,
    STRUCT_NetSharedSerialization = 0x00400000,
    STRUCT_Trashed = 0x00800000,
    STRUCT_NewerVersionExists = 0x01000000,
    STRUCT_CanEditChange = 0x02000000,
};
ENUM_CLASS_FLAGS(EStructFlags)

#define STRUCT_Inherit ((EStructFlags)(STRUCT_HasInstancedReference | STRUCT_Atomic))
/** Flags the run time derives from the C++ type. */
#define STRUCT_ComputedFlags                                                                                           \
    ((EStructFlags)(STRUCT_NetDeltaSerializeNative | STRUCT_NetSerializeNative | STRUCT_SerializeNative |              \
                    STRUCT_PostSerializeNative | STRUCT_CopyNative | STRUCT_IsPlainOldData | STRUCT_NoDestructor |     \
                    STRUCT_ZeroConstructor | STRUCT_IdenticalNative | STRUCT_AddStructReferencedObjects |              \
                    STRUCT_ExportTextItemNative | STRUCT_ImportTextItemNative | STRUCT_SerializeFromMismatchedTag |    \
                    STRUCT_PostScriptConstruct | STRUCT_NetSharedSerialization))

/** Whether a property function gets the address of the value or of the struct or object that holds it. */
enum class EPropertyPointerType {
    Direct = 0,
    Container = 1,
};

// ---------------------------------------------------------------------------------------------------------------------------
// Declarations that the header tool reads. The C++ compiler sees nothing, or what the generated header defines.

#define UPROPERTY(...)
#define UFUNCTION(...)
#define USTRUCT(...)
#define UMETA(...)
#define UPARAM(...)
#define UENUM(...)
#define UDELEGATE(...)
#define UCLASS(...)
#define UINTERFACE(...)
#define RIGVM_METHOD(...)

#define BODY_MACRO_COMBINE_INNER(A, B, C, D) A##B##C##D
#define BODY_MACRO_COMBINE(A, B, C, D) BODY_MACRO_COMBINE_INNER(A, B, C, D)

/** The generated part of a reflected class or struct; defined per file and line by `<Header>.generated.h`. */
#define GENERATED_BODY(...) BODY_MACRO_COMBINE(CURRENT_FILE_ID, _, __LINE__, _GENERATED_BODY)
#define GENERATED_BODY_LEGACY(...) BODY_MACRO_COMBINE(CURRENT_FILE_ID, _, __LINE__, _GENERATED_BODY_LEGACY)
#define GENERATED_USTRUCT_BODY(...) GENERATED_BODY()
#define GENERATED_UCLASS_BODY(...) GENERATED_BODY_LEGACY()
#define GENERATED_UINTERFACE_BODY(...) GENERATED_BODY_LEGACY()
#define GENERATED_IINTERFACE_BODY(...) GENERATED_BODY_LEGACY()

#ifndef NO_API
#define NO_API
#endif

/** Byte offset of an interface subobject inside a class. */
#define VTABLE_OFFSET(Class, BaseClass)                                                                                \
    static_cast<int32>(                                                                                                \
        reinterpret_cast<PTRINT>(static_cast<BaseClass*>(reinterpret_cast<Class*>(PTRINT(16)))) - PTRINT(16))

// ---------------------------------------------------------------------------------------------------------------------------
// Class declaration blocks, used by generated headers and by the intrinsic classes.

#define DECLARE_CLASS(TClass, TSuperClass, TStaticFlags, TStaticCastFlags, TPackage, TRequiredAPI)                     \
private:                                                                                                               \
    TClass& operator=(TClass&&) = delete;                                                                              \
    TClass& operator=(const TClass&) = delete;                                                                         \
    TRequiredAPI static UClass* GetPrivateStaticClass();                                                               \
                                                                                                                       \
public:                                                                                                                \
    /** Flags known at compile time. */                                                                                \
    static constexpr EClassFlags StaticClassFlags = EClassFlags(TStaticFlags);                                         \
    typedef TSuperClass Super;                                                                                         \
    typedef TClass ThisClass;                                                                                          \
    /** The UClass of this class. */                                                                                   \
    inline static UClass* StaticClass() { return GetPrivateStaticClass(); }                                            \
    /** The package that owns this class. */                                                                           \
    inline static const TCHAR* StaticPackage() { return TPackage; }                                                    \
    /** The cast bit of this class, if it has one. */                                                                  \
    inline static EClassCastFlags StaticClassCastFlags() { return EClassCastFlags(TStaticCastFlags); }                 \
    /** Objects are only made by NewObject, into memory it provides. */                                                \
    inline void* operator new(const size_t, EInternal* InMem) { return static_cast<void*>(InMem); }                    \
    inline void operator delete(void*) {}                                                                              \
    inline void operator delete(void*, EInternal*) {}

/** Calls the default constructor in place. */
#define DEFINE_DEFAULT_CONSTRUCTOR_CALL(TClass)                                                                        \
    static void __DefaultConstructor(const FObjectInitializer& X) {                                                    \
        new (reinterpret_cast<EInternal*>(X.GetObj())) TClass;                                                         \
    }
/** Calls the FObjectInitializer constructor in place. */
#define DEFINE_DEFAULT_OBJECT_INITIALIZER_CONSTRUCTOR_CALL(TClass)                                                     \
    static void __DefaultConstructor(const FObjectInitializer& X) {                                                    \
        new (reinterpret_cast<EInternal*>(X.GetObj())) TClass(X);                                                      \
    }
/** An abstract C++ class (with pure virtual functions) that can never be built; only its UClass exists. */
#define DEFINE_FORBIDDEN_DEFAULT_CONSTRUCTOR_CALL(TClass)                                                              \
    static void __DefaultConstructor(const FObjectInitializer& X) {                                                    \
        checkf(false, TEXT("Constructor of " #TClass " is not reachable"));                                            \
    }

#define DECLARE_WITHIN_INTERNAL(TWithinClass, bCanUseOnCDO)                                                            \
    typedef TWithinClass WithinClass;                                                                                  \
    template <typename T = TWithinClass>                                                                               \
    T* GetOuter##TWithinClass() const {                                                                                \
        return static_cast<T*>(GetOuter());                                                                            \
    }
#define DECLARE_WITHIN(TWithinClass) DECLARE_WITHIN_INTERNAL(TWithinClass, true)

/** Declares a class that exists without the header tool: only the meta classes of the reflection system itself. */
#define DECLARE_CASTED_CLASS_INTRINSIC_NO_CTOR(                                                                        \
    TClass, TSuperClass, TStaticFlags, TPackage, TStaticCastFlags, TRequiredAPI)                                       \
    DECLARE_CLASS(TClass, TSuperClass, (TStaticFlags) | CLASS_Intrinsic, TStaticCastFlags, TPackage, TRequiredAPI)     \
    DEFINE_DEFAULT_OBJECT_INITIALIZER_CONSTRUCTOR_CALL(TClass)
#define DECLARE_CLASS_INTRINSIC(TClass, TSuperClass, TStaticFlags, TPackage)                                           \
    DECLARE_CLASS(TClass, TSuperClass, (TStaticFlags) | CLASS_Intrinsic, CASTCLASS_None, TPackage, NO_API)             \
    explicit TClass(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {}                         \
    DEFINE_DEFAULT_OBJECT_INITIALIZER_CONSTRUCTOR_CALL(TClass)

/** Name of the class without its prefix letter and without the deprecation mark. */
#define UE_STATIC_CLASS_NAME(TClass) (&(TEXT(#TClass)[1]))

#include "UObject/ScriptMacros.h"
