// SPDX-License-Identifier: MIT
// Macros of native function thunks: reading parameters from an FFrame. Mirrors Epic's "UObject/ScriptMacros.h". The
// types they name (FFrame, properties) come from "UObject/Stack.h", which every generated .gen.cpp includes.
#pragma once

#include "UObject/Script.h"

/** Declares the thunk of a native function. */
#define DECLARE_FUNCTION(func) static void func(UObject* Context, FFrame& Stack, RESULT_DECL)
/** Defines a thunk; func is qualified with its class. */
#define DEFINE_FUNCTION(func) void func(UObject* Context, FFrame& Stack, RESULT_DECL)

#define P_THIS_OBJECT (Context)
#define P_THIS_CAST(ClassType) (reinterpret_cast<ClassType*>(P_THIS_OBJECT))
#define P_THIS P_THIS_CAST(ThisClass)

/** Ends the reading of parameters. */
#define P_FINISH
/** Around the call of the C++ function. */
#define P_NATIVE_BEGIN {
#define P_NATIVE_END }

#define P_GET_PROPERTY(PropertyType, ParamName)                                                                        \
    PropertyType::TCppType ParamName = PropertyType::GetDefaultPropertyValue();                                        \
    Stack.StepCompiledIn<PropertyType>(&ParamName);
#define P_GET_PROPERTY_REF(PropertyType, ParamName)                                                                    \
    PropertyType::TCppType ParamName##Temp = PropertyType::GetDefaultPropertyValue();                                  \
    PropertyType::TCppType& ParamName = Stack.StepCompiledInRef<PropertyType, PropertyType::TCppType>(&ParamName##Temp);

#define P_GET_UBOOL(ParamName)                                                                                         \
    bool ParamName = false;                                                                                            \
    Stack.StepCompiledIn<FBoolProperty>(&ParamName);
#define P_GET_UBOOL_REF(ParamName)                                                                                     \
    bool ParamName##Temp = false;                                                                                      \
    bool& ParamName = Stack.StepCompiledInRef<FBoolProperty, bool>(&ParamName##Temp);

#define P_GET_STRUCT(StructType, ParamName)                                                                            \
    StructType ParamName{};                                                                                            \
    Stack.StepCompiledIn<FStructProperty>(&ParamName);
#define P_GET_STRUCT_REF(StructType, ParamName)                                                                        \
    StructType ParamName##Temp{};                                                                                      \
    StructType& ParamName = Stack.StepCompiledInRef<FStructProperty, StructType>(&ParamName##Temp);

#define P_GET_OBJECT(ObjectType, ParamName)                                                                            \
    ObjectType* ParamName = nullptr;                                                                                   \
    Stack.StepCompiledIn<FObjectPropertyBase>(&ParamName);
#define P_GET_OBJECT_REF(ObjectType, ParamName)                                                                        \
    ObjectType* ParamName##Temp = nullptr;                                                                             \
    ObjectType*& ParamName = Stack.StepCompiledInRef<FObjectPropertyBase, ObjectType*>(&ParamName##Temp);
#define P_GET_OBJECT_NO_PTR(ObjectType, ParamName)                                                                     \
    ObjectType ParamName{};                                                                                            \
    Stack.StepCompiledIn<FObjectPropertyBase>(&ParamName);
#define P_GET_OBJECT_REF_NO_PTR(ObjectType, ParamName)                                                                 \
    ObjectType ParamName##Temp{};                                                                                      \
    ObjectType& ParamName = Stack.StepCompiledInRef<FObjectPropertyBase, ObjectType>(&ParamName##Temp);

#define P_GET_VALUE_OF(PropertyClass, ValueType, ParamName)                                                            \
    ValueType ParamName{};                                                                                             \
    Stack.StepCompiledIn<PropertyClass>(&ParamName);
#define P_GET_VALUE_REF_OF(PropertyClass, ValueType, ParamName)                                                        \
    ValueType ParamName##Temp{};                                                                                       \
    ValueType& ParamName = Stack.StepCompiledInRef<PropertyClass, ValueType>(&ParamName##Temp);

#define P_GET_TARRAY(ElementType, ParamName) P_GET_VALUE_OF(FArrayProperty, TArray<ElementType>, ParamName)
#define P_GET_TARRAY_REF(ElementType, ParamName) P_GET_VALUE_REF_OF(FArrayProperty, TArray<ElementType>, ParamName)
#define P_GET_TMAP(KeyType, ValueType, ParamName)                                                                      \
    TMap<KeyType, ValueType> ParamName;                                                                                \
    Stack.StepCompiledIn<FMapProperty>(&ParamName);
#define P_GET_TMAP_REF(KeyType, ValueType, ParamName)                                                                  \
    TMap<KeyType, ValueType> ParamName##Temp;                                                                          \
    auto& ParamName = Stack.StepCompiledInRef<FMapProperty, TMap<KeyType, ValueType>>(&ParamName##Temp);
#define P_GET_TSET(ElementType, ParamName) P_GET_VALUE_OF(FSetProperty, TSet<ElementType>, ParamName)
#define P_GET_TSET_REF(ElementType, ParamName) P_GET_VALUE_REF_OF(FSetProperty, TSet<ElementType>, ParamName)
#define P_GET_TINTERFACE(ObjectType, ParamName)                                                                        \
    P_GET_VALUE_OF(FInterfaceProperty, TScriptInterface<ObjectType>, ParamName)
#define P_GET_TINTERFACE_REF(ObjectType, ParamName)                                                                    \
    P_GET_VALUE_REF_OF(FInterfaceProperty, TScriptInterface<ObjectType>, ParamName)
#define P_GET_SOFTOBJECT(ObjectType, ParamName) P_GET_VALUE_OF(FSoftObjectProperty, ObjectType, ParamName)
#define P_GET_SOFTOBJECT_REF(ObjectType, ParamName) P_GET_VALUE_REF_OF(FSoftObjectProperty, ObjectType, ParamName)
#define P_GET_SOFTCLASS(ObjectType, ParamName) P_GET_VALUE_OF(FSoftClassProperty, ObjectType, ParamName)
#define P_GET_SOFTCLASS_REF(ObjectType, ParamName) P_GET_VALUE_REF_OF(FSoftClassProperty, ObjectType, ParamName)
#define P_GET_WEAKOBJECT(ObjectType, ParamName) P_GET_VALUE_OF(FWeakObjectProperty, ObjectType, ParamName)
#define P_GET_WEAKOBJECT_REF(ObjectType, ParamName) P_GET_VALUE_REF_OF(FWeakObjectProperty, ObjectType, ParamName)
#define P_GET_WEAKOBJECT_NO_PTR(ObjectType, ParamName) P_GET_VALUE_OF(FWeakObjectProperty, ObjectType, ParamName)

/** An enum of any storage size. */
#define P_GET_ENUM(EnumType, ParamName)                                                                                \
    EnumType ParamName = static_cast<EnumType>(0);                                                                     \
    Stack.StepCompiledIn<FEnumProperty>(&ParamName);
#define P_GET_ENUM_REF(EnumType, ParamName)                                                                            \
    EnumType ParamName##Temp = static_cast<EnumType>(0);                                                               \
    EnumType& ParamName = Stack.StepCompiledInRef<FEnumProperty, EnumType>(&ParamName##Temp);

/** Reports that the _Validate function of an RPC refused its arguments. */
COREUOBJECT_API void RPC_ValidateFailed(const TCHAR* Reason);
