// SPDX-License-Identifier: MIT
#pragma once

// A class with every kind of property: as a property, an argument, a return value and an out-parameter.

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "Misc/Optional.h"
#include "RoundTripTypes.h"
#include "Templates/SubclassOf.h"
#include "UObject/LazyObjectPtr.h"
#include "UObject/Object.h"
#include "UObject/ScriptInterface.h"
#include "UObject/SoftObjectPtr.h"

#include "RoundTrip.generated.h"

/** EchoX returns its argument, CopyX hands it back through an out-parameter, XValue holds it. */
UCLASS()
class ROUNDTRIP_API URoundTrip : public UObject, public IRoundTripListener {
    GENERATED_BODY()

public:
    UPROPERTY(EditAnywhere)
    bool BoolValue = false;
    UPROPERTY(EditAnywhere)
    int8 Int8Value = 0;
    UPROPERTY(EditAnywhere)
    int16 Int16Value = 0;
    UPROPERTY(EditAnywhere)
    int32 Int32Value = 0;
    UPROPERTY(EditAnywhere)
    int64 Int64Value = 0;
    UPROPERTY(EditAnywhere)
    uint8 UInt8Value = 0;
    UPROPERTY(EditAnywhere)
    uint16 UInt16Value = 0;
    UPROPERTY(EditAnywhere)
    uint32 UInt32Value = 0;
    UPROPERTY(EditAnywhere)
    uint64 UInt64Value = 0;
    UPROPERTY(EditAnywhere)
    float FloatValue = 0;
    UPROPERTY(EditAnywhere)
    double DoubleValue = 0;
    UPROPERTY(EditAnywhere)
    FString StringValue;
    UPROPERTY(EditAnywhere)
    FName NameValue;
    UPROPERTY(EditAnywhere)
    FText TextValue;
    UPROPERTY(EditAnywhere)
    ERoundTripMode EnumValue = ERoundTripMode::Slow;
    UPROPERTY(EditAnywhere)
    TEnumAsByte<ERoundTripLegacy> ByteEnumValue = RTL_First;
    UPROPERTY(EditAnywhere)
    ERoundTripBits BitsValue = ERoundTripBits::None;
    UPROPERTY(EditAnywhere)
    TObjectPtr<UObject> ObjectValue;
    UPROPERTY(EditAnywhere)
    TObjectPtr<AActor> ActorValue;
    UPROPERTY(EditAnywhere)
    TSubclassOf<AActor> ClassValue;
    UPROPERTY(EditAnywhere)
    TWeakObjectPtr<AActor> WeakValue;
    UPROPERTY(EditAnywhere)
    TLazyObjectPtr<AActor> LazyValue;
    UPROPERTY(EditAnywhere)
    TSoftObjectPtr<UObject> SoftObjectValue;
    UPROPERTY(EditAnywhere)
    TSoftClassPtr<AActor> SoftClassValue;
    UPROPERTY(EditAnywhere)
    TScriptInterface<IRoundTripListener> InterfaceValue;
    UPROPERTY(EditAnywhere)
    FVector VectorValue = FVector::ZeroVector;
    UPROPERTY(EditAnywhere)
    FTransform TransformValue;
    UPROPERTY(EditAnywhere)
    FColor ColorValue = FColor(0, 0, 0, 0);
    UPROPERTY(EditAnywhere)
    FRoundTripRecord RecordValue;
    UPROPERTY(EditAnywhere)
    FRoundTripEmpty EmptyValue;
    UPROPERTY(EditAnywhere)
    TArray<int32> IntArrayValue;
    UPROPERTY(EditAnywhere)
    TArray<uint8> ByteArrayValue;
    UPROPERTY(EditAnywhere)
    TArray<bool> BoolArrayValue;
    UPROPERTY(EditAnywhere)
    TArray<FString> StringArrayValue;
    UPROPERTY(EditAnywhere)
    TArray<FVector> VectorArrayValue;
    UPROPERTY(EditAnywhere)
    TArray<FRoundTripRecord> RecordArrayValue;
    UPROPERTY(EditAnywhere)
    TArray<TObjectPtr<AActor>> ObjectArrayValue;
    UPROPERTY(EditAnywhere)
    TSet<FName> NameSetValue;
    UPROPERTY(EditAnywhere)
    TSet<int32> IntSetValue;
    UPROPERTY(EditAnywhere)
    TMap<FString, int32> StringMapValue;
    UPROPERTY(EditAnywhere)
    TMap<FName, FVector> VectorMapValue;
    UPROPERTY(EditAnywhere)
    TMap<ERoundTripMode, FString> EnumMapValue;
    UPROPERTY(EditAnywhere)
    TOptional<int32> OptionalValue;
    UPROPERTY(EditAnywhere)
    FRoundTripDelegate DelegateValue;

    UFUNCTION()
    bool EchoBool(bool Value) { return Value; }
    UFUNCTION()
    void CopyBool(bool Value, bool& Result) { Result = Value; }

    UFUNCTION()
    int8 EchoInt8(int8 Value) { return Value; }
    UFUNCTION()
    void CopyInt8(int8 Value, int8& Result) { Result = Value; }

    UFUNCTION()
    int16 EchoInt16(int16 Value) { return Value; }
    UFUNCTION()
    void CopyInt16(int16 Value, int16& Result) { Result = Value; }

    UFUNCTION()
    int32 EchoInt32(int32 Value) { return Value; }
    UFUNCTION()
    void CopyInt32(int32 Value, int32& Result) { Result = Value; }

    UFUNCTION()
    int64 EchoInt64(int64 Value) { return Value; }
    UFUNCTION()
    void CopyInt64(int64 Value, int64& Result) { Result = Value; }

    UFUNCTION()
    uint8 EchoUInt8(uint8 Value) { return Value; }
    UFUNCTION()
    void CopyUInt8(uint8 Value, uint8& Result) { Result = Value; }

    UFUNCTION()
    uint16 EchoUInt16(uint16 Value) { return Value; }
    UFUNCTION()
    void CopyUInt16(uint16 Value, uint16& Result) { Result = Value; }

    UFUNCTION()
    uint32 EchoUInt32(uint32 Value) { return Value; }
    UFUNCTION()
    void CopyUInt32(uint32 Value, uint32& Result) { Result = Value; }

    UFUNCTION()
    uint64 EchoUInt64(uint64 Value) { return Value; }
    UFUNCTION()
    void CopyUInt64(uint64 Value, uint64& Result) { Result = Value; }

    UFUNCTION()
    float EchoFloat(float Value) { return Value; }
    UFUNCTION()
    void CopyFloat(float Value, float& Result) { Result = Value; }

    UFUNCTION()
    double EchoDouble(double Value) { return Value; }
    UFUNCTION()
    void CopyDouble(double Value, double& Result) { Result = Value; }

    UFUNCTION()
    FString EchoString(FString Value) { return Value; }
    UFUNCTION()
    void CopyString(FString Value, FString& Result) { Result = Value; }

    UFUNCTION()
    FName EchoName(FName Value) { return Value; }
    UFUNCTION()
    void CopyName(FName Value, FName& Result) { Result = Value; }

    UFUNCTION()
    FText EchoText(FText Value) { return Value; }
    UFUNCTION()
    void CopyText(FText Value, FText& Result) { Result = Value; }

    UFUNCTION()
    ERoundTripMode EchoEnum(ERoundTripMode Value) { return Value; }
    UFUNCTION()
    void CopyEnum(ERoundTripMode Value, ERoundTripMode& Result) { Result = Value; }

    UFUNCTION()
    TEnumAsByte<ERoundTripLegacy> EchoByteEnum(TEnumAsByte<ERoundTripLegacy> Value) { return Value; }
    UFUNCTION()
    void CopyByteEnum(TEnumAsByte<ERoundTripLegacy> Value, TEnumAsByte<ERoundTripLegacy>& Result) { Result = Value; }

    UFUNCTION()
    ERoundTripBits EchoBits(ERoundTripBits Value) { return Value; }
    UFUNCTION()
    void CopyBits(ERoundTripBits Value, ERoundTripBits& Result) { Result = Value; }

    UFUNCTION()
    UObject* EchoObject(UObject* Value) { return Value; }
    UFUNCTION()
    void CopyObject(UObject* Value, UObject*& Result) { Result = Value; }

    UFUNCTION()
    AActor* EchoActor(AActor* Value) { return Value; }
    UFUNCTION()
    void CopyActor(AActor* Value, AActor*& Result) { Result = Value; }

    UFUNCTION()
    TSubclassOf<AActor> EchoClass(TSubclassOf<AActor> Value) { return Value; }
    UFUNCTION()
    void CopyClass(TSubclassOf<AActor> Value, TSubclassOf<AActor>& Result) { Result = Value; }

    UFUNCTION()
    TWeakObjectPtr<AActor> EchoWeak(TWeakObjectPtr<AActor> Value) { return Value; }
    UFUNCTION()
    void CopyWeak(TWeakObjectPtr<AActor> Value, TWeakObjectPtr<AActor>& Result) { Result = Value; }

    UFUNCTION()
    TLazyObjectPtr<AActor> EchoLazy(TLazyObjectPtr<AActor> Value) { return Value; }
    UFUNCTION()
    void CopyLazy(TLazyObjectPtr<AActor> Value, TLazyObjectPtr<AActor>& Result) { Result = Value; }

    UFUNCTION()
    TSoftObjectPtr<UObject> EchoSoftObject(TSoftObjectPtr<UObject> Value) { return Value; }
    UFUNCTION()
    void CopySoftObject(TSoftObjectPtr<UObject> Value, TSoftObjectPtr<UObject>& Result) { Result = Value; }

    UFUNCTION()
    TSoftClassPtr<AActor> EchoSoftClass(TSoftClassPtr<AActor> Value) { return Value; }
    UFUNCTION()
    void CopySoftClass(TSoftClassPtr<AActor> Value, TSoftClassPtr<AActor>& Result) { Result = Value; }

    UFUNCTION()
    TScriptInterface<IRoundTripListener> EchoInterface(TScriptInterface<IRoundTripListener> Value) { return Value; }
    UFUNCTION()
    void CopyInterface(TScriptInterface<IRoundTripListener> Value, TScriptInterface<IRoundTripListener>& Result) {
        Result = Value;
    }

    UFUNCTION()
    FVector EchoVector(FVector Value) { return Value; }
    UFUNCTION()
    void CopyVector(FVector Value, FVector& Result) { Result = Value; }

    UFUNCTION()
    FTransform EchoTransform(FTransform Value) { return Value; }
    UFUNCTION()
    void CopyTransform(FTransform Value, FTransform& Result) { Result = Value; }

    UFUNCTION()
    FColor EchoColor(FColor Value) { return Value; }
    UFUNCTION()
    void CopyColor(FColor Value, FColor& Result) { Result = Value; }

    UFUNCTION()
    FRoundTripRecord EchoRecord(FRoundTripRecord Value) { return Value; }
    UFUNCTION()
    void CopyRecord(FRoundTripRecord Value, FRoundTripRecord& Result) { Result = Value; }

    UFUNCTION()
    FRoundTripEmpty EchoEmpty(FRoundTripEmpty Value) { return Value; }
    UFUNCTION()
    void CopyEmpty(FRoundTripEmpty Value, FRoundTripEmpty& Result) { Result = Value; }

    UFUNCTION()
    TArray<int32> EchoIntArray(TArray<int32> Value) { return Value; }
    UFUNCTION()
    void CopyIntArray(TArray<int32> Value, TArray<int32>& Result) { Result = Value; }

    UFUNCTION()
    TArray<uint8> EchoByteArray(TArray<uint8> Value) { return Value; }
    UFUNCTION()
    void CopyByteArray(TArray<uint8> Value, TArray<uint8>& Result) { Result = Value; }

    UFUNCTION()
    TArray<bool> EchoBoolArray(TArray<bool> Value) { return Value; }
    UFUNCTION()
    void CopyBoolArray(TArray<bool> Value, TArray<bool>& Result) { Result = Value; }

    UFUNCTION()
    TArray<FString> EchoStringArray(TArray<FString> Value) { return Value; }
    UFUNCTION()
    void CopyStringArray(TArray<FString> Value, TArray<FString>& Result) { Result = Value; }

    UFUNCTION()
    TArray<FVector> EchoVectorArray(TArray<FVector> Value) { return Value; }
    UFUNCTION()
    void CopyVectorArray(TArray<FVector> Value, TArray<FVector>& Result) { Result = Value; }

    UFUNCTION()
    TArray<FRoundTripRecord> EchoRecordArray(TArray<FRoundTripRecord> Value) { return Value; }
    UFUNCTION()
    void CopyRecordArray(TArray<FRoundTripRecord> Value, TArray<FRoundTripRecord>& Result) { Result = Value; }

    UFUNCTION()
    TArray<AActor*> EchoObjectArray(TArray<AActor*> Value) { return Value; }
    UFUNCTION()
    void CopyObjectArray(TArray<AActor*> Value, TArray<AActor*>& Result) { Result = Value; }

    UFUNCTION()
    TSet<FName> EchoNameSet(TSet<FName> Value) { return Value; }
    UFUNCTION()
    void CopyNameSet(TSet<FName> Value, TSet<FName>& Result) { Result = Value; }

    UFUNCTION()
    TSet<int32> EchoIntSet(TSet<int32> Value) { return Value; }
    UFUNCTION()
    void CopyIntSet(TSet<int32> Value, TSet<int32>& Result) { Result = Value; }

    UFUNCTION()
    TMap<FString, int32> EchoStringMap(TMap<FString, int32> Value) { return Value; }
    UFUNCTION()
    void CopyStringMap(TMap<FString, int32> Value, TMap<FString, int32>& Result) { Result = Value; }

    UFUNCTION()
    TMap<FName, FVector> EchoVectorMap(TMap<FName, FVector> Value) { return Value; }
    UFUNCTION()
    void CopyVectorMap(TMap<FName, FVector> Value, TMap<FName, FVector>& Result) { Result = Value; }

    UFUNCTION()
    TMap<ERoundTripMode, FString> EchoEnumMap(TMap<ERoundTripMode, FString> Value) { return Value; }
    UFUNCTION()
    void CopyEnumMap(TMap<ERoundTripMode, FString> Value, TMap<ERoundTripMode, FString>& Result) { Result = Value; }

    UFUNCTION()
    TOptional<int32> EchoOptional(TOptional<int32> Value) { return Value; }
    UFUNCTION()
    void CopyOptional(TOptional<int32> Value, TOptional<int32>& Result) { Result = Value; }

    UFUNCTION()
    FRoundTripDelegate EchoDelegate(FRoundTripDelegate Value) { return Value; }
    UFUNCTION()
    void CopyDelegate(FRoundTripDelegate Value, FRoundTripDelegate& Result) { Result = Value; }

    UPROPERTY()
    uint8 bBitOne : 1 = 0;
    UPROPERTY()
    uint8 bBitTwo : 1 = 0;
    UPROPERTY()
    int32 FixedValue[4] = {1, 2, 3, 4};
    UPROPERTY(BlueprintAssignable)
    FRoundTripEvent MulticastValue;

    /** What IRoundTripListener hears. */
    virtual void Hear_Implementation(int32 Number) override { LastHeard = Number; }
    UPROPERTY()
    int32 LastHeard = 0;
    /** A function that fits both delegates. */
    UFUNCTION()
    void OnEvent(int32 Number) { LastHeard = Number; }
    /** A function that fits none. */
    UFUNCTION()
    void OnOther(FString Text) {}
    UFUNCTION()
    void FireDelegate(int32 Number) { DelegateValue.ExecuteIfBound(Number); }
    UFUNCTION()
    void FireMulticast(int32 Number) { MulticastValue.Broadcast(Number); }
    UFUNCTION()
    void CallListener(int32 Number);
};
