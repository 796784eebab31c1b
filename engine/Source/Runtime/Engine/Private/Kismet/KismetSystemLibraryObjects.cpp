// SPDX-License-Identifier: MIT
#include "Kismet/KismetSystemLibrary.h"
#include "Components/PrimitiveComponent.h"
#include "Components/SceneComponent.h"
#include "DelayAction.h"
#include "Engine/Engine.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "GameFramework/PlayerController.h"
#include "HAL/IConsoleManager.h"
#include "HAL/PlatformProcess.h"
#include "KismetPrivate.h"
#include "Misc/App.h"
#include "Misc/CommandLine.h"
#include "Misc/EngineVersion.h"
#include "Misc/Parse.h"
#include "Misc/Paths.h"
#include "TimerManager.h"

// Objects

bool UKismetSystemLibrary::IsValid(const UObject* Object) { return ::IsValid(Object); }

bool UKismetSystemLibrary::IsValidClass(UClass* Class) { return ::IsValid(Class); }

FString UKismetSystemLibrary::GetObjectName(const UObject* Object) { return GetNameSafe(Object); }

FString UKismetSystemLibrary::GetPathName(const UObject* Object) { return GetPathNameSafe(Object); }

FString UKismetSystemLibrary::GetDisplayName(const UObject* Object) { return GetNameSafe(Object); }

FString UKismetSystemLibrary::GetClassDisplayName(const UClass* Class) { return Class ? Class->GetName() : FString(); }

UObject* UKismetSystemLibrary::GetOuterObject(const UObject* Object) { return Object ? Object->GetOuter() : nullptr; }

bool UKismetSystemLibrary::DoesImplementInterface(const UObject* TestObject, TSubclassOf<UInterface> Interface) {
    return ::IsValid(TestObject) && Interface && TestObject->GetClass()->ImplementsInterface(Interface);
}

bool UKismetSystemLibrary::DoesClassImplementInterface(const UClass* TestClass, TSubclassOf<UInterface> Interface) {
    return TestClass && Interface && TestClass->ImplementsInterface(Interface);
}

TSubclassOf<UObject> UKismetSystemLibrary::Conv_ObjectToClass(UObject* Object, TSubclassOf<UObject> Class) {
    UClass* const AsClass = Cast<UClass>(Object);
    return AsClass && Class && AsClass->IsChildOf(Class) ? AsClass : nullptr;
}

void UKismetSystemLibrary::CollectGarbage() { GEngine->ForceGarbageCollection(true); }

TSoftObjectPtr<UObject> UKismetSystemLibrary::Conv_ObjectToSoftObjectReference(UObject* Object) {
    return TSoftObjectPtr<UObject>(Object);
}

UObject* UKismetSystemLibrary::Conv_SoftObjectReferenceToObject(const TSoftObjectPtr<UObject>& SoftObject) {
    return SoftObject.Get();
}

FString UKismetSystemLibrary::Conv_SoftObjectReferenceToString(const TSoftObjectPtr<UObject>& SoftObjectReference) {
    return SoftObjectReference.ToString();
}

bool UKismetSystemLibrary::IsValidSoftObjectReference(const TSoftObjectPtr<UObject>& SoftObjectReference) {
    return !SoftObjectReference.IsNull();
}

bool UKismetSystemLibrary::EqualEqual_SoftObjectReference(
    const TSoftObjectPtr<UObject>& A, const TSoftObjectPtr<UObject>& B) {
    return A == B;
}

UObject* UKismetSystemLibrary::LoadAsset_Blocking(TSoftObjectPtr<UObject> Asset) { return Asset.LoadSynchronous(); }

FSoftObjectPath UKismetSystemLibrary::MakeSoftObjectPath(const FString& PathString) {
    FSoftObjectPath Path;
    Path.SetPath(PathString);
    return Path;
}

void UKismetSystemLibrary::BreakSoftObjectPath(FSoftObjectPath InSoftObjectPath, FString& PathString) {
    PathString = InSoftObjectPath.ToString();
}

// Literals

int32 UKismetSystemLibrary::MakeLiteralInt(int32 Value) { return Value; }

int64 UKismetSystemLibrary::MakeLiteralInt64(int64 Value) { return Value; }

float UKismetSystemLibrary::MakeLiteralFloat(float Value) { return Value; }

double UKismetSystemLibrary::MakeLiteralDouble(double Value) { return Value; }

bool UKismetSystemLibrary::MakeLiteralBool(bool Value) { return Value; }

FName UKismetSystemLibrary::MakeLiteralName(FName Value) { return Value; }

uint8 UKismetSystemLibrary::MakeLiteralByte(uint8 Value) { return Value; }

FString UKismetSystemLibrary::MakeLiteralString(FString Value) { return Value; }

FText UKismetSystemLibrary::MakeLiteralText(FText Value) { return Value; }

// Properties by name

void UKismetSystemLibrary::SetIntPropertyByName(UObject* Object, FName PropertyName, int32 Value) {
    KismetPrivate::SetNumber(Object, PropertyName, static_cast<int64>(Value));
}

void UKismetSystemLibrary::SetInt64PropertyByName(UObject* Object, FName PropertyName, int64 Value) {
    KismetPrivate::SetNumber(Object, PropertyName, Value);
}

void UKismetSystemLibrary::SetBytePropertyByName(UObject* Object, FName PropertyName, uint8 Value) {
    KismetPrivate::SetNumber(Object, PropertyName, static_cast<int64>(Value));
}

void UKismetSystemLibrary::SetDoublePropertyByName(UObject* Object, FName PropertyName, double Value) {
    KismetPrivate::SetNumber(Object, PropertyName, Value);
}

void UKismetSystemLibrary::SetBoolPropertyByName(UObject* Object, FName PropertyName, bool Value) {
    KismetPrivate::SetBool(Object, PropertyName, Value);
}

void UKismetSystemLibrary::SetObjectPropertyByName(UObject* Object, FName PropertyName, UObject* Value) {
    KismetPrivate::SetObject(Object, PropertyName, Value);
}

void UKismetSystemLibrary::SetClassPropertyByName(UObject* Object, FName PropertyName, TSubclassOf<UObject> Value) {
    KismetPrivate::SetObject(Object, PropertyName, Value.Get());
}

void UKismetSystemLibrary::SetNamePropertyByName(UObject* Object, FName PropertyName, FName Value) {
    KismetPrivate::SetName(Object, PropertyName, Value);
}

void UKismetSystemLibrary::SetStringPropertyByName(UObject* Object, FName PropertyName, const FString& Value) {
    KismetPrivate::SetString(Object, PropertyName, Value);
}

void UKismetSystemLibrary::SetVectorPropertyByName(UObject* Object, FName PropertyName, const FVector& Value) {
    KismetPrivate::SetStruct(Object, PropertyName, TEXT("/Script/CoreUObject.Vector"), &Value);
}

void UKismetSystemLibrary::SetRotatorPropertyByName(UObject* Object, FName PropertyName, const FRotator& Value) {
    KismetPrivate::SetStruct(Object, PropertyName, TEXT("/Script/CoreUObject.Rotator"), &Value);
}

void UKismetSystemLibrary::SetLinearColorPropertyByName(
    UObject* Object, FName PropertyName, const FLinearColor& Value) {
    KismetPrivate::SetStruct(Object, PropertyName, TEXT("/Script/CoreUObject.LinearColor"), &Value);
}

void UKismetSystemLibrary::SetTransformPropertyByName(UObject* Object, FName PropertyName, const FTransform& Value) {
    KismetPrivate::SetStruct(Object, PropertyName, TEXT("/Script/CoreUObject.Transform"), &Value);
}
