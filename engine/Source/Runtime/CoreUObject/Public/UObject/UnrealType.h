// SPDX-License-Identifier: MIT
// The property classes. Mirrors Epic's "UObject/UnrealType.h" (API page FProperty); split into one header per family.
#pragma once

#include "UObject/Property.h"
#include "UObject/PropertyNumeric.h"
#include "UObject/PropertySimple.h"
#include "UObject/PropertyObject.h"
#include "UObject/PropertyContainers.h"
#include "UObject/PropertyDelegates.h"
#include "UObject/FieldPathProperty.h"
#include "UObject/FieldIterator.h"
