// SPDX-License-Identifier: MIT
// Reflected types that use every kind of property, for the tests of the reflection system.
#pragma once

#include "CoreMinimal.h"
#include "Templates/SubclassOf.h"
#include "UObject/Interface.h"
#include "UObject/LazyObjectPtr.h"
#include "UObject/NoExportTypes.h"
#include "UObject/Object.h"
#include "UObject/ScriptDelegates.h"
#include "UObject/ScriptInterface.h"
#include "UObject/SoftObjectPtr.h"
#include "UObject/SparseDelegate.h"
#include "UObject/WeakObjectPtrTemplates.h"

#include "ReflectionTestTypes.generated.h"

class UReflectionSubject;

/** A regular enum. */
UENUM(BlueprintType)
enum ERegularTestEnum : int {
    /** The first one. */
    RTE_First,
    RTE_Second UMETA(DisplayName = "Number Two"),
    RTE_Tenth = 10
};

/** A namespaced enum. */
UENUM()
namespace ENamespacedTestEnum {
enum Type { Alpha, Beta };
}

/** An enum class. */
UENUM(BlueprintType)
enum class ETestColor : uint8 { Red, Green = 5, Blue };

/** A 32-bit flags enum. */
UENUM(Flags, meta = (Bitflags))
enum class ETestFlags : uint32 { None = 0, One = 1, Two = 2, Big = 0x10000 };
ENUM_CLASS_FLAGS(ETestFlags)

/** Two parameters. */
DECLARE_DYNAMIC_DELEGATE_TwoParams(FTestDelegate, int32, Number, const FString&, Text);
DECLARE_DYNAMIC_DELEGATE_RetVal_OneParam(int32, FTestRetValDelegate, int32, Number);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FTestMulticast, int32, Number);
DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_OneParam(FTestSparse, UReflectionSubject, OnSparse, int32, Number);

/** A plain struct. */
USTRUCT(BlueprintType)
struct REFLECTIONTEST_API FInnerTestStruct {
    GENERATED_BODY()

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Test)
    int32 Count = 3;

    UPROPERTY()
    FString Label = TEXT("label");

    bool operator==(const FInnerTestStruct& Other) const { return Count == Other.Count && Label == Other.Label; }
    friend uint32 GetTypeHash(const FInnerTestStruct& Value) {
        return HashCombine(::GetTypeHash(Value.Count), GetTypeHash(Value.Label));
    }
};

/** A struct with containers, objects and a base. */
USTRUCT(BlueprintType)
struct REFLECTIONTEST_API FOuterTestStruct : public FInnerTestStruct {
    GENERATED_BODY()

    UPROPERTY()
    TArray<FInnerTestStruct> Inners;

    UPROPERTY()
    TObjectPtr<UObject> Object;

    UPROPERTY()
    FVector Location = FVector(1.0, 2.0, 3.0);

    UPROPERTY()
    TMap<FName, int32> Scores;
};

/** A struct without constructor work. */
USTRUCT()
struct FPlainTestStruct {
    GENERATED_BODY()

    UPROPERTY()
    int32 A = 0;

    UPROPERTY()
    double B = 0.0;
};

/** An interface with a native and an implementable event and a plain native function. */
UINTERFACE(BlueprintType)
class REFLECTIONTEST_API UTestGreeter : public UInterface {
    GENERATED_BODY()
};

class REFLECTIONTEST_API ITestGreeter {
    GENERATED_BODY()

public:
    UFUNCTION(BlueprintNativeEvent, BlueprintCallable, Category = Test)
    FString Greet(const FString& Name) const;

    UFUNCTION(BlueprintNativeEvent, BlueprintCallable, Category = Test)
    void AddTo(int32& Total, int32 Amount);
};

/** Base class with an overridable function and a default subobject. */
UCLASS(Abstract, Blueprintable, BlueprintType)
class REFLECTIONTEST_API UReflectionBase : public UObject {
    GENERATED_BODY()

public:
    explicit UReflectionBase(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    UFUNCTION(BlueprintCallable, Category = Test)
    virtual int32 VirtualNumber() const;

    UFUNCTION(BlueprintNativeEvent, BlueprintCallable, Category = Test)
    int32 NativeEvent(int32 Number);

    UFUNCTION(BlueprintImplementableEvent, Category = Test)
    int32 ImplementableEvent(int32 Number);

    UPROPERTY(Instanced)
    TObjectPtr<UObject> Part;

    UPROPERTY(EditAnywhere, Category = Test)
    int32 BaseNumber = 11;
};

/** A part of other objects. */
UCLASS(EditInlineNew, DefaultToInstanced)
class REFLECTIONTEST_API UReflectionPart : public UObject {
    GENERATED_BODY()

public:
    UPROPERTY(EditAnywhere, Category = Test)
    int32 Value = 1;

    UPROPERTY()
    TObjectPtr<UObject> Reference;
};

/** A derived part, for SetDefaultSubobjectClass. */
UCLASS()
class REFLECTIONTEST_API UReflectionDerivedPart : public UReflectionPart {
    GENERATED_BODY()
};

/** Has every kind of property, and functions that take and return them. */
UCLASS(BlueprintType, Config = Test)
class REFLECTIONTEST_API UReflectionSubject : public UReflectionBase, public ITestGreeter {
    GENERATED_BODY()

public:
    explicit UReflectionSubject(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    // ---- numbers

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Test, meta = (ClampMin = "0"))
    int32 Int32Value = 42;

    UPROPERTY()
    int8 Int8Value = -8;

    UPROPERTY()
    int16 Int16Value = -16;

    UPROPERTY()
    int64 Int64Value = -64;

    UPROPERTY()
    uint8 UInt8Value = 8;

    UPROPERTY()
    uint16 UInt16Value = 16;

    UPROPERTY()
    uint32 UInt32Value = 32;

    UPROPERTY()
    uint64 UInt64Value = 64;

    UPROPERTY()
    float FloatValue = 1.5f;

    UPROPERTY()
    double DoubleValue = 2.25;

    // ---- bools and enums

    UPROPERTY()
    bool bNative = true;

    UPROPERTY()
    uint8 bBitOne : 1;

    UPROPERTY()
    uint8 bBitTwo : 1;

    UPROPERTY()
    uint32 bWideBit : 1;

    UPROPERTY()
    TEnumAsByte<ERegularTestEnum> RegularEnum = RTE_Second;

    UPROPERTY()
    TEnumAsByte<ENamespacedTestEnum::Type> NamespacedEnum = ENamespacedTestEnum::Beta;

    UPROPERTY()
    ETestColor Color = ETestColor::Green;

    UPROPERTY()
    ETestFlags Flags = ETestFlags::Two;

    // ---- text

    UPROPERTY()
    FString String = TEXT("text");

    UPROPERTY()
    FName Name = TEXT("SomeName");

    UPROPERTY()
    FText Text = FText::FromString(TEXT("shown"));

    // ---- references

    UPROPERTY()
    TObjectPtr<UObject> Strong;

    UPROPERTY()
    UReflectionSubject* RawStrong = nullptr;

    UPROPERTY()
    TSubclassOf<UReflectionBase> SubclassOf;

    UPROPERTY()
    TObjectPtr<UClass> AnyClass;

    UPROPERTY()
    TWeakObjectPtr<UObject> Weak;

    UPROPERTY()
    TLazyObjectPtr<UObject> Lazy;

    UPROPERTY()
    TSoftObjectPtr<UObject> Soft;

    UPROPERTY()
    TSoftClassPtr<UReflectionBase> SoftClass;

    UPROPERTY()
    TScriptInterface<ITestGreeter> Greeter;

    // ---- structs and containers

    UPROPERTY()
    FOuterTestStruct Struct;

    UPROPERTY()
    FVector Vector = FVector(1.0, 2.0, 3.0);

    UPROPERTY()
    FTransform Transform;

    UPROPERTY()
    TArray<int32> Ints;

    UPROPERTY()
    TArray<FString> Strings;

    UPROPERTY()
    TArray<TObjectPtr<UObject>> Objects;

    UPROPERTY()
    TArray<FOuterTestStruct> Structs;

    UPROPERTY()
    TSet<FName> Names;

    UPROPERTY()
    TMap<FString, FVector> Vectors;

    UPROPERTY()
    TMap<FName, TObjectPtr<UObject>> ObjectMap;

    UPROPERTY()
    TSet<TObjectPtr<UObject>> ObjectSet;

    UPROPERTY()
    int32 FixedArray[4] = {1, 2, 3, 4};

    UPROPERTY()
    FGuid Guid;

    // ---- delegates

    UPROPERTY()
    FTestDelegate OnEvent;

    UPROPERTY(BlueprintAssignable)
    FTestMulticast OnMulticast;

    UPROPERTY(BlueprintAssignable)
    FTestSparse OnSparse;

    UPROPERTY(Transient)
    int32 TransientValue = 0;

    // ---- functions

    UFUNCTION(BlueprintCallable, Category = Test)
    int32 Add(int32 A, int32 B = 5) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    double EchoDouble(double Value, float Single, int64 Wide) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    bool EchoBool(bool bValue, bool& bInverted) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    FString EchoString(const FString& Value, FString& OutUpper, FName InName, FName& OutName) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    FText EchoText(const FText& Value) const;

    UFUNCTION()
    ETestColor EchoEnum(ETestColor Value, TEnumAsByte<ERegularTestEnum> Regular,
        TEnumAsByte<ERegularTestEnum>& OutRegular, ETestFlags& OutFlags) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    FVector EchoVector(const FVector& Value, FVector& OutDoubled, const FTransform& Transform3D) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    FOuterTestStruct EchoStruct(
        const FOuterTestStruct& Value, FInnerTestStruct ByValue, FInnerTestStruct& OutInner) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    UObject* EchoObject(UObject* Value, UReflectionSubject*& OutSelf, const UReflectionBase* Constant);

    UFUNCTION(BlueprintCallable, Category = Test)
    TSubclassOf<UReflectionBase> EchoClass(TSubclassOf<UReflectionBase> Value, UClass* Any, UClass*& OutAny) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    TArray<FString> EchoArray(
        const TArray<int32>& Values, TArray<int32>& OutReversed, TArray<FInnerTestStruct>& OutStructs) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    TMap<FString, int32> EchoMap(const TMap<FString, int32>& Value, TSet<FName> InSet, TSet<FName>& OutSet) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    TSoftObjectPtr<UObject> EchoSoft(TSoftObjectPtr<UObject> Value, TSoftClassPtr<UReflectionBase> ClassValue,
        TSoftClassPtr<UReflectionBase>& OutClass) const;

    UFUNCTION()
    TWeakObjectPtr<UObject> EchoWeak(TWeakObjectPtr<UObject> Value) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    TScriptInterface<ITestGreeter> EchoInterface(const TScriptInterface<ITestGreeter>& Value) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    void CallBack(FTestDelegate Callback, int32 Number) const;

    UFUNCTION(BlueprintCallable, Category = Test)
    void ChangeInPlace(UPARAM(ref) FInnerTestStruct& Value, UPARAM(ref) TArray<int32>& Values) const;

    UFUNCTION(BlueprintCallable, Category = Test, meta = (WorldContext = "Context"))
    static int32 StaticSum(const UObject* Context, int32 A, int32 B);

    UFUNCTION(BlueprintCallable, Category = Test, CustomThunk)
    int32 CustomDouble(int32 Value);
    DECLARE_FUNCTION(execCustomDouble);

    UFUNCTION(Server, Reliable, WithValidation)
    void ServerSetNumber(int32 Number);

    UFUNCTION(Exec)
    void SetNumberByCommand(int32 Number, const FString& Note);

    UFUNCTION()
    void HandleEvent(int32 Number, const FString& Text3D);

    UFUNCTION()
    void HandleMulticast(int32 Number);

    UFUNCTION()
    int32 HandleRetVal(int32 Number);

    // ---- overrides

    virtual int32 VirtualNumber() const override;
    virtual int32 NativeEvent_Implementation(int32 Number) override;
    virtual FString Greet_Implementation(const FString& InName) const override;
    virtual void AddTo_Implementation(int32& Total, int32 Amount) override;
    virtual void BeginDestroy() override;

    // ---- native accessors

    float GetGuarded() const { return Guarded; }
    void SetGuarded(float Value);

    int32 NumSetterCalls = 0;
    int32 LastNumber = 0;
    FString LastText;
    /** Counts destroyed subjects. */
    static int32 NumDestroyed;

protected:
    UPROPERTY(EditAnywhere, Category = Test)
    int32 ProtectedValue = 7;

private:
    UPROPERTY(EditAnywhere, Getter, Setter, Category = Test)
    float Guarded = 1.0f;

    UPROPERTY()
    int32 PrivateValue = 9;
};

/** A child that replaces its base's subobject and leaves out another. */
UCLASS()
class REFLECTIONTEST_API UReflectionChild : public UReflectionSubject {
    GENERATED_BODY()

public:
    UReflectionChild(const FObjectInitializer& ObjectInitializer);

    virtual int32 VirtualNumber() const override { return 300; }
};

/** A class without any constructor. */
UCLASS()
class REFLECTIONTEST_API UReflectionImplicit : public UReflectionSubject {
    GENERATED_BODY()
};

/** The old form of a class body. */
UCLASS()
class REFLECTIONTEST_API UReflectionLegacy : public UObject {
    GENERATED_UCLASS_BODY()

    UPROPERTY()
    int32 Number;
};

/** Lives only inside subjects. */
UCLASS(Within = ReflectionSubject)
class REFLECTIONTEST_API UReflectionWithin : public UObject {
    GENERATED_BODY()
};
