// SPDX-License-Identifier: MIT
#include "KismetPrivate.h"
#include "InterpolateComponentToAction.h"

#include "Engine/Engine.h"
#include "Engine/World.h"
#include "EngineUtils.h"
#include "GameFramework/Actor.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerController.h"
#include "HAL/IConsoleManager.h"
#include "TimerManager.h"
#include "UObject/UnrealType.h"

DEFINE_LOG_CATEGORY(LogKismet);
DEFINE_LOG_CATEGORY(LogBlueprintUserMessages);

namespace KismetPrivate {

UWorld* GetWorld(const UObject* WorldContextObject) {
    return GEngine ? GEngine->GetWorldFromContextObject(WorldContextObject, EGetWorldErrorMode::LogAndReturnNull)
                   : nullptr;
}

APawn* FindInstigator(const UObject* WorldContextObject) {
    for (const UObject* Object = WorldContextObject; Object; Object = Object->GetOuter()) {
        if (const AActor* const Actor = Cast<AActor>(Object)) {
            return Actor->GetInstigator();
        }
    }
    return nullptr;
}

void CollectActors(const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass, TArray<AActor*>& OutActors,
    TFunctionRef<bool(const AActor*)> Filter) {
    OutActors.Reset();
    UWorld* const World = ActorClass ? GetWorld(WorldContextObject) : nullptr;
    if (!World) {
        return;
    }
    for (TActorIterator<AActor> Iterator(World, ActorClass); Iterator; ++Iterator) {
        if (Filter(*Iterator)) {
            OutActors.Add(*Iterator);
        }
    }
}

bool FindOption(const FString& Options, const FString& Key, FString& OutValue) {
    TArray<FString> Pairs;
    Options.ParseIntoArray(Pairs, TEXT("?"), true);
    for (const FString& Pair : Pairs) {
        FString PairKey;
        FString PairValue;
        if (!Pair.Split(TEXT("="), &PairKey, &PairValue)) {
            PairKey = Pair;
        }
        if (PairKey.Equals(Key, ESearchCase::IgnoreCase)) {
            OutValue = PairValue;
            return true;
        }
    }
    return false;
}

namespace {

// The property to write, and where it is; null with a warning if the object has no such property or it is of another
// kind.
template <typename PropertyType>
PropertyType* FindProperty(UObject* Object, FName PropertyName, const TCHAR* WantedKind) {
    FProperty* const Property = Object ? Object->GetClass()->FindPropertyByName(PropertyName) : nullptr;
    PropertyType* const Typed = CastField<PropertyType>(Property);
    if (!Typed) {
        UE_LOG(LogKismet, Warning, TEXT("Setting '%s' of '%s': %s, wanted a %s property"), *PropertyName.ToString(),
            *GetNameSafe(Object), Property ? TEXT("it has another type") : TEXT("there is no such property"),
            WantedKind);
    }
    return Typed;
}

} // namespace

void SetNumber(UObject* Object, FName PropertyName, int64 Value) {
    FProperty* const Found = Object ? Object->GetClass()->FindPropertyByName(PropertyName) : nullptr;
    if (FEnumProperty* const Enum = CastField<FEnumProperty>(Found)) {
        Enum->GetUnderlyingProperty()->SetIntPropertyValue(Enum->ContainerPtrToValuePtr<void>(Object), Value);
        return;
    }
    FNumericProperty* const Property = FindProperty<FNumericProperty>(Object, PropertyName, TEXT("integer"));
    if (Property && Property->IsInteger()) {
        Property->SetIntPropertyValue(Property->ContainerPtrToValuePtr<void>(Object), Value);
    } else if (Property) {
        UE_LOG(LogKismet, Warning, TEXT("Setting '%s' of '%s': it is no integer property"), *PropertyName.ToString(),
            *GetNameSafe(Object));
    }
}

void SetNumber(UObject* Object, FName PropertyName, double Value) {
    FNumericProperty* const Property = FindProperty<FNumericProperty>(Object, PropertyName, TEXT("floating-point"));
    if (Property && Property->IsFloatingPoint()) {
        Property->SetFloatingPointPropertyValue(Property->ContainerPtrToValuePtr<void>(Object), Value);
    } else if (Property) {
        UE_LOG(LogKismet, Warning, TEXT("Setting '%s' of '%s': it is no floating-point property"),
            *PropertyName.ToString(), *GetNameSafe(Object));
    }
}

void SetBool(UObject* Object, FName PropertyName, bool Value) {
    if (FBoolProperty* const Property = FindProperty<FBoolProperty>(Object, PropertyName, TEXT("bool"))) {
        Property->SetPropertyValue_InContainer(Object, Value);
    }
}

void SetObject(UObject* Object, FName PropertyName, UObject* Value) {
    FObjectPropertyBase* const Property = FindProperty<FObjectPropertyBase>(Object, PropertyName, TEXT("object"));
    if (!Property) {
        return;
    }
    const FClassProperty* const ClassProperty = CastField<FClassProperty>(Property);
    const UClass* const ValueClass = Cast<UClass>(Value);
    const bool bFits = !Value || (ClassProperty ? ValueClass && ValueClass->IsChildOf(ClassProperty->MetaClass)
                                                : Value->IsA(Property->PropertyClass));
    if (bFits) {
        Property->SetObjectPropertyValue_InContainer(Object, Value);
    } else {
        UE_LOG(LogKismet, Warning, TEXT("Setting '%s' of '%s': '%s' is not of the property's class"),
            *PropertyName.ToString(), *GetNameSafe(Object), *GetNameSafe(Value));
    }
}

void SetName(UObject* Object, FName PropertyName, FName Value) {
    if (FNameProperty* const Property = FindProperty<FNameProperty>(Object, PropertyName, TEXT("name"))) {
        Property->SetPropertyValue_InContainer(Object, Value);
    }
}

void SetString(UObject* Object, FName PropertyName, const FString& Value) {
    if (FStrProperty* const Property = FindProperty<FStrProperty>(Object, PropertyName, TEXT("string"))) {
        Property->SetPropertyValue_InContainer(Object, Value);
    }
}

void SetStruct(UObject* Object, FName PropertyName, const TCHAR* StructPath, const void* Value) {
    FStructProperty* const Property = FindProperty<FStructProperty>(Object, PropertyName, TEXT("struct"));
    if (Property && Property->Struct->GetPathName() == StructPath) {
        Property->CopyCompleteValue(Property->ContainerPtrToValuePtr<void>(Object), Value);
    } else if (Property) {
        UE_LOG(LogKismet, Warning, TEXT("Setting '%s' of '%s': it is a '%s', not a '%s'"), *PropertyName.ToString(),
            *GetNameSafe(Object), *Property->Struct->GetPathName(), StructPath);
    }
}

void Print(
    const FString& Text, bool bPrintToScreen, bool bPrintToLog, FLinearColor TextColor, float Duration, FName Key) {
    if (bPrintToLog) {
        UE_LOG(LogBlueprintUserMessages, Log, TEXT("%s"), *Text);
    } else {
        UE_LOG(LogBlueprintUserMessages, Verbose, TEXT("%s"), *Text);
    }
    if (bPrintToScreen && GEngine) {
        // A message with a key replaces the one before.
        const uint64 MessageKey = Key.IsNone() ? static_cast<uint64>(-1) : static_cast<uint64>(GetTypeHash(Key));
        GEngine->AddOnScreenDebugMessage(MessageKey, Duration, TextColor.ToFColor(true), Text);
    }
}

void ExecuteConsoleCommand(
    const UObject* WorldContextObject, const FString& Command, APlayerController* SpecificPlayer) {
    APlayerController* Player = SpecificPlayer;
    UWorld* const World = Player ? Player->GetWorld() : GetWorld(WorldContextObject);
    if (!Player && World) {
        Player = World->GetFirstPlayerController();
    }
    if (Player) {
        Player->ConsoleCommand(Command, true);
    } else if (GEngine) {
        GEngine->Exec(World, *Command);
    }
}

IConsoleVariable* FindConsoleVariable(const FString& Name) {
    IConsoleVariable* const Variable = IConsoleManager::Get().FindConsoleVariable(*Name);
    if (!Variable) {
        UE_LOG(LogKismet, Warning, TEXT("There is no console variable '%s'"), *Name);
    }
    return Variable;
}

FTimerDynamicDelegate MakeTimerDelegate(UObject* Object, const FString& FunctionName) {
    FTimerDynamicDelegate Delegate;
    const UFunction* const Function = Object ? Object->FindFunction(FName(*FunctionName)) : nullptr;
    if (!Function) {
        UE_LOG(LogKismet, Warning, TEXT("A timer cannot call '%s' of '%s': there is no such function"), *FunctionName,
            *GetNameSafe(Object));
    } else if (Function->ParmsSize > 0) {
        UE_LOG(LogKismet, Warning, TEXT("A timer cannot call '%s' of '%s': the function takes or returns something"),
            *FunctionName, *GetNameSafe(Object));
    } else {
        Delegate.BindUFunction(Object, FName(*FunctionName));
    }
    return Delegate;
}

FTimerHandle SetTimer(const FTimerDynamicDelegate& Delegate, float Time, bool bLooping, bool bMaxOncePerFrame,
    float InitialStartDelay, float InitialStartDelayVariance) {
    FTimerHandle Handle;
    UWorld* const World = Delegate.IsBound() ? GetWorld(Delegate.GetUObject()) : nullptr;
    if (!World) {
        return Handle;
    }
    FTimerManager& Manager = World->GetTimerManager();
    Handle = Manager.K2_FindDynamicTimerHandle(Delegate);
    const float Delay = InitialStartDelay + InitialStartDelayVariance * static_cast<float>(2.0 * FMath::FRand() - 1.0);
    FTimerManagerTimerParameters Parameters;
    Parameters.bLoop = bLooping;
    Parameters.bMaxOncePerFrame = bMaxOncePerFrame;
    Parameters.FirstDelay = FMath::Max(Time + Delay, 0.0f);
    Manager.SetTimer(Handle, Delegate, Time, Parameters);
    return Handle;
}

void WithTimer(UObject* Object, const FString& FunctionName, TFunctionRef<void(FTimerManager&, FTimerHandle&)> Use) {
    const FTimerDynamicDelegate Delegate = MakeTimerDelegate(Object, FunctionName);
    UWorld* const World = Delegate.IsBound() ? GetWorld(Object) : nullptr;
    if (!World) {
        return;
    }
    FTimerHandle Handle = World->GetTimerManager().K2_FindDynamicTimerHandle(Delegate);
    if (Handle.IsValid()) {
        Use(World->GetTimerManager(), Handle);
    }
}

void MoveComponentTo(USceneComponent* Component, FVector TargetRelativeLocation, FRotator TargetRelativeRotation,
    bool bEaseOut, bool bEaseIn, float OverTime, bool bForceShortestRotationPath, EMoveComponentAction::Type MoveAction,
    const FLatentActionInfo& LatentInfo) {
    UWorld* const World = Component ? GetWorld(Component) : nullptr;
    if (!World) {
        UE_LOG(LogKismet, Warning, TEXT("MoveComponentTo: '%s' is no component in a world"), *GetNameSafe(Component));
        return;
    }
    FLatentActionManager& Manager = World->GetLatentActionManager();
    FInterpolateComponentToAction* const Action =
        Manager.FindExistingAction<FInterpolateComponentToAction>(LatentInfo.CallbackTarget, LatentInfo.UUID);
    switch (MoveAction) {
    case EMoveComponentAction::Move:
        if (Action) {
            Action->Restart(OverTime, bEaseOut, bEaseIn, bForceShortestRotationPath, TargetRelativeLocation,
                TargetRelativeRotation);
        } else {
            Manager.AddNewAction(LatentInfo.CallbackTarget, LatentInfo.UUID,
                new FInterpolateComponentToAction(Component, OverTime, bEaseOut, bEaseIn, bForceShortestRotationPath,
                    TargetRelativeLocation, TargetRelativeRotation, LatentInfo));
        }
        break;
    case EMoveComponentAction::Stop:
        if (Action) {
            Action->Stop();
        }
        break;
    case EMoveComponentAction::Return:
        if (Action) {
            Action->Return();
        }
        break;
    }
}

} // namespace KismetPrivate
