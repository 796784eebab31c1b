// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

class UObject;

/**
 * Sets a reflected property from UE text.
 *
 * @param Object   where the path starts.
 * @param Path     property names separated by dots, going through structs and object references:
 * "LightComponent.Intensity".
 * @param Text     the value as UE's property import reads it: "5.0", "True", "(X=1,Y=2,Z=3)", "Movable".
 * @param OutError which part of the path or of the text was not understood.
 * @return whether the value was set. Native setters are used where the property has one.
 */
bool SetPropertyByPath(UObject* Object, const FString& Path, const FString& Text, FString& OutError);
