// SPDX-License-Identifier: MIT
#pragma once

#include "Materials/MaterialInstance.h"

/** The entry of a parameter in a list of parameter values, or null. */
template <typename ValueType>
ValueType* FindParameter(TArray<ValueType>& Values, const FMaterialParameterInfo& Info) {
    for (ValueType& Value : Values) {
        if (Value.ParameterInfo == Info) {
            return &Value;
        }
    }
    return nullptr;
}

template <typename ValueType>
const ValueType* FindParameter(const TArray<ValueType>& Values, const FMaterialParameterInfo& Info) {
    for (const ValueType& Value : Values) {
        if (Value.ParameterInfo == Info) {
            return &Value;
        }
    }
    return nullptr;
}
