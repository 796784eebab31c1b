// SPDX-License-Identifier: MIT
#pragma once

// Shapes that generated C++ trips over. Read by the header tool only, never compiled.

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "UObject/Interface.h"

#include "Awkward.generated.h"

UENUM(meta = (Bitflags))
enum class EAwkwardBits : uint8 {
    None = 0,
    First = 1 << 0,
    Second = 1 << 1,
};

UENUM(Flags)
enum class EAwkwardFlags : int64 {
    NULL_ = 0,
    Low = 1,
    High = 0x4000000000000000,
};

/** Names that C++ keeps for itself, and values on both sides of zero. */
UENUM()
namespace EAwkwardScoped {
enum Type {
    operator_ = -5,
    Default = 0,
    EOF_ = 2147483647,
};
}

UENUM()
enum EAwkwardEmpty {};

/** A tree: contains itself through containers. \ */
USTRUCT()
struct FAwkwardNode {
    GENERATED_BODY()

    UPROPERTY() FString Name;
    UPROPERTY() TArray<FAwkwardNode> Children;
    UPROPERTY() TMap<FName, FAwkwardNode> ByName;
    UPROPERTY() TArray<TObjectPtr<AAwkwardActor>> Actors;
};

/** Two structs that contain each other. */
USTRUCT()
struct FAwkwardHere {
    GENERATED_BODY()
    UPROPERTY() TArray<FAwkwardThere> There;
};

USTRUCT()
struct FAwkwardThere {
    GENERATED_BODY()
    UPROPERTY() TArray<FAwkwardHere> Here;
    UPROPERTY() TObjectPtr<AAwkwardActor> Actor;
    UPROPERTY() TMap<FName, TObjectPtr<AAwkwardActor>> Named;
};

/** Members with the names of the SDK's, of C++ and of the struct. */
USTRUCT()
struct FAwkwardWords : public FAwkwardHere {
    GENERATED_BODY()
    UPROPERTY() int32 get = 0;
    UPROPERTY() int32 set = 0;
    UPROPERTY() int32 async = 0;
    UPROPERTY() int32 property = 0;
    UPROPERTY() bool spear = false;
    UPROPERTY() bool unreal = false;
    UPROPERTY() FVector std;
    UPROPERTY() FVector FAwkwardWords_Path;
    UPROPERTY() int32 Fixed[3];
    UPROPERTY() FAwkwardNode Nodes[2];
};

/** A vector that travels in fewer bits. */
USTRUCT()
struct FAwkwardVector : public FVector {
    GENERATED_BODY()
};

UINTERFACE()
class UAwkwardBase : public UInterface {
    GENERATED_BODY()
};
class IAwkwardBase {
    GENERATED_BODY()
public:
    UFUNCTION(BlueprintCallable, BlueprintImplementableEvent, Category = "A") void Below();
};

UINTERFACE()
class UAwkwardDerived : public UAwkwardBase {
    GENERATED_BODY()
};
class IAwkwardDerived : public IAwkwardBase {
    GENERATED_BODY()
public:
    UFUNCTION(BlueprintCallable, BlueprintImplementableEvent, Category = "A") int32 Above(int32 Value);
};

UCLASS()
class AAwkwardActor : public AActor, public IAwkwardDerived {
    GENERATED_BODY()

public:
    // Functions and properties named as the SDK's, as words of C++, as types, as parameters of templates.
    UFUNCTION(BlueprintCallable, Category = "A") int32 get(int32 set) const;
    UFUNCTION(BlueprintCallable, Category = "A") static void async(int32 send);
    UFUNCTION(BlueprintCallable, Category = "A") void call(bool spear, bool unreal, bool std, bool Value_T, int32 this_);
    UFUNCTION(BlueprintCallable, Category = "A") void AActor_Members();
    UFUNCTION(BlueprintCallable, Category = "A") FVector FVector_();
    UFUNCTION(BlueprintCallable, Category = "A") bool is_a();
    UPROPERTY() int32 SpearBase;
    UPROPERTY() int32 is_null;
    UPROPERTY() int32 FVector;
    UPROPERTY() int32 AActor;
    UPROPERTY() bool EOF_OF_FILE;
    /** Ends in a backslash \ */
    UPROPERTY() TArray<FAwkwardWords> Words;
    UPROPERTY() TSet<TObjectPtr<AAwkwardActor>> Friends;
    UPROPERTY() TMap<TObjectPtr<AAwkwardActor>, FAwkwardNode> Nodes;
    UPROPERTY() TMap<TEnumAsByte<EAwkwardScoped::Type>, FString> Texts;
    UPROPERTY() FUnheardOf Unknown;
    UPROPERTY() TObjectPtr<UUnheardOf> UnknownObject;
    UPROPERTY() TArray<EUnheardOf> UnknownEnums;

    /** A default in front of a parameter that has none. */
    UFUNCTION(BlueprintCallable, Category = "A", meta = (CPP_Default_First = "5"))
    int32 Middle(int32 First, int32 Second);
    /** Outputs of every kind, one of them passed in as well. */
    UFUNCTION(BlueprintCallable, Category = "A")
    AAwkwardActor* Outputs(UPARAM(ref) FAwkwardNode& Node, TArray<AAwkwardActor*>& Actors, EAwkwardFlags& Flags,
        TSubclassOf<AAwkwardActor>& Class, TSoftObjectPtr<AAwkwardActor>& Soft);
    UFUNCTION(BlueprintCallable, Category = "A")
    void ManyDefaults(FAwkwardNode Required, AAwkwardActor* Actor, FVector Place = FVector(1, 2, 3), const FString& Text = TEXT("a\"b"),
        EAwkwardFlags Flags = EAwkwardFlags::Low, AAwkwardActor* Other = nullptr);
    UFUNCTION(BlueprintCallable, Category = "A", meta = (DeprecatedFunction, DeprecationMessage = "Use \"Middle\" instead."))
    void Old();
    /** Unknown types everywhere. */
    UFUNCTION(BlueprintCallable, Category = "A")
    FUnheardOf Strange(FUnheardOf Struct, UUnheardOf* Object, EUnheardOf Enum, TArray<FUnheardOf> Structs);
};

UCLASS()
class AAwkwardChild : public AAwkwardActor, public IAwkwardBase {
    GENERATED_BODY()
public:
    // Hides a property of the class above.
    UFUNCTION(BlueprintCallable, Category = "A") void Words(int32 Count);
};

/** A class above which there is one that no schema knows. */
UCLASS()
class UAwkwardOrphan : public UUnheardOfBase {
    GENERATED_BODY()
public:
    UPROPERTY() int32 Number = 0;
};
