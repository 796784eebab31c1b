// SPDX-License-Identifier: MIT
#include "PropertyPath.h"

#include "Misc/StringOutputDevice.h"
#include "UObject/Class.h"
#include "UObject/Object.h"
#include "UObject/UnrealType.h"

bool SetPropertyByPath(UObject* Object, const FString& Path, const FString& Text, FString& OutError) {
    if (Object == nullptr) {
        OutError = FString::Printf(TEXT("there is no object to set '%s' on"), *Path);
        return false;
    }
    TArray<FString> Parts;
    Path.ParseIntoArray(Parts, TEXT("."), false);
    UObject* Owner = Object;
    UStruct* Type = Object->GetClass();
    void* Container = Object;
    for (int32 Index = 0; Index < Parts.Num(); ++Index) {
        FProperty* Property = Type->FindPropertyByName(FName(*Parts[Index]));
        if (Property == nullptr) {
            OutError = FString::Printf(
                TEXT("'%s' of the property path '%s' is no property of %s"), *Parts[Index], *Path, *Type->GetName());
            return false;
        }
        if (Index == Parts.Num() - 1) {
            FStringOutputDevice Errors;
            const TCHAR* Rest = Property->ImportText_InContainer(*Text, Container, Owner, PPF_None, &Errors);
            if (Rest == nullptr || !FString(Rest).TrimStartAndEnd().IsEmpty() || !Errors.IsEmpty()) {
                OutError = FString::Printf(TEXT("property '%s' has type %s, which cannot be read from '%s'%s%s"), *Path,
                    *Property->GetCPPType(), *Text, Errors.IsEmpty() ? TEXT("") : TEXT(": "), *Errors);
                return false;
            }
            return true;
        }
        if (const FStructProperty* StructProperty = CastField<FStructProperty>(Property)) {
            Container = StructProperty->ContainerPtrToValuePtr<void>(Container);
            Type = StructProperty->Struct;
        } else if (const FObjectProperty* ObjectProperty = CastField<FObjectProperty>(Property)) {
            Owner = ObjectProperty->GetObjectPropertyValue(ObjectProperty->ContainerPtrToValuePtr<void>(Container));
            if (Owner == nullptr) {
                OutError = FString::Printf(TEXT("'%s' of the property path '%s' is null"), *Parts[Index], *Path);
                return false;
            }
            Container = Owner;
            Type = Owner->GetClass();
        } else {
            OutError = FString::Printf(TEXT("'%s' of the property path '%s' has type %s, which has no members"),
                *Parts[Index], *Path, *Property->GetCPPType());
            return false;
        }
    }
    OutError = TEXT("an empty property path");
    return false;
}
