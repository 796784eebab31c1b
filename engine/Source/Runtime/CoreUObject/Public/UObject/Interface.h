// SPDX-License-Identifier: MIT
// UInterface, the base of the U-halves of interface pairs. Mirrors Epic's "UObject/Interface.h".
#pragma once

#include "UObject/Object.h"

/** Base class of interface classes. Intrinsic: it exists before any schema is read. */
class COREUOBJECT_API UInterface : public UObject {
    DECLARE_CLASS(UInterface, UObject, CLASS_Interface | CLASS_Abstract | CLASS_Intrinsic, CASTCLASS_None,
        TEXT("/Script/CoreUObject"), NO_API)
    DEFINE_DEFAULT_OBJECT_INITIALIZER_CONSTRUCTOR_CALL(UInterface)
public:
    typedef UObject WithinClass;
    UInterface() = default;
    explicit UInterface(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {}
};

/** Base class of the I-half of UInterface itself. */
class IInterface {
public:
    typedef UInterface UClassType;
    virtual UObject* _getUObject() const {
        check(false);
        return nullptr;
    }

protected:
    virtual ~IInterface() {}
};
