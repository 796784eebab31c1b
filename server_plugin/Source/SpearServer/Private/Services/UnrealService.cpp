// SPDX-License-Identifier: MIT
// unreal_service: classes, objects, functions, properties, schema. (Worlds, actors and queries: UnrealQueries.cpp.)
#include "Services/Services.h"

#include "Services/ObjectArguments.h"

#include "Reflection/ClassLookup.h"
#include "Reflection/LiveSchema.h"

#include "Engine/Level.h"
#include "GameFramework/Actor.h"
#include "UObject/Class.h"
#include "UObject/Package.h"
#include "UObject/UObjectGlobals.h"
#include "UObject/UObjectHash.h"

#include "spear/entry_points/unreal_service.hpp"

#include <algorithm>

namespace SpearServer {

namespace {

using spear::AnyView;
using spear::ClassArgument;
using spear::ObjectRef;

/// Whether Unreal can be asked for the path at all: it stops the program on some malformed ones.
FStatus CheckPath(std::string_view Path) {
    const bool bGood = Path.size() > 1 && Path.size() < NAME_SIZE && Path[0] == '/' &&
                       Path.find("//") == std::string_view::npos && Path.find('\0') == std::string_view::npos &&
                       Path.find_first_of("\\*?\"<>|\n\r\t") == std::string_view::npos && Path.back() != '/' &&
                       Path.back() != '.' && Path.back() != ':';
    if (bGood) {
        return {};
    }
    return MakeError(ErrorCode::UnknownObject,
        "'" + std::string(Path.substr(0, 256)) + "' is no object path; paths look like \"/Game/Folder/Asset.Asset\"",
        "path");
}

/// Names that Unreal takes for objects.
FStatus CheckObjectName(std::string_view Name) {
    if (IsValidName(Name) && Name.find_first_of("\"' ,/.:|&!~\n\r\t@#(){}[]=;^%$`\\*?<>") == std::string_view::npos) {
        return {};
    }
    return MakeError(ErrorCode::OutOfRange,
        "'" + std::string(Name.substr(0, 256)) +
            "' is no object name: it is too long or has characters that names cannot have",
        "name");
}

TSpearResult<ObjectRef> Refer(FOperation& Operation, TSpearResult<UClass*> Class) {
    if (!Class.IsOk()) {
        return std::move(Class.GetError());
    }
    return ReferTo(*Operation.Session, Class.GetValue());
}

TSpearResult<ObjectRef> LoadClass(FOperation& Operation, const ClassArgument& BaseArgument, std::string_view Path) {
    TSpearResult<UClass*> Base = ResolveClass(Operation, BaseArgument);
    if (!Base.IsOk()) {
        return std::move(Base.GetError());
    }
    FStatus Good = CheckPath(Path);
    if (!Good.IsOk()) {
        Good.GetError().code = ErrorCode::UnknownClass;
        return std::move(Good.GetError());
    }
    UClass* Class =
        StaticLoadClass(UObject::StaticClass(), nullptr, *FromUtf8(Path), nullptr, LOAD_NoWarn | LOAD_Quiet, nullptr);
    if (!Class) {
        return MakeError(ErrorCode::UnknownClass, "no class can be loaded from '" + std::string(Path) + "'", "path");
    }
    if (Base.GetValue() && !Class->IsChildOf(Base.GetValue())) {
        return MakeError(ErrorCode::WrongType,
            "the class " + CppNameOf(Class) + " does not derive from " + CppNameOf(Base.GetValue()), "path",
            CppNameOf(Base.GetValue()));
    }
    return ReferTo(*Operation.Session, Class);
}

TSpearResult<ObjectRef> LoadObject(FOperation& Operation, const ClassArgument& ClassName, std::string_view Path) {
    TSpearResult<UClass*> Class = ResolveClass(Operation, ClassName);
    if (!Class.IsOk()) {
        return std::move(Class.GetError());
    }
    FStatus Good = CheckPath(Path);
    if (!Good.IsOk()) {
        return std::move(Good.GetError());
    }
    const FString UnrealPath = FromUtf8(Path);
    UObject* Object = StaticFindObject(UObject::StaticClass(), nullptr, *UnrealPath);
    if (!Object) {
        Object = StaticLoadObject(UObject::StaticClass(), nullptr, *UnrealPath, nullptr, LOAD_NoWarn | LOAD_Quiet);
    }
    if (!IsUsable(Object)) {
        return MakeError(
            ErrorCode::UnknownObject, "no object can be found or loaded at '" + std::string(Path) + "'", "path");
    }
    if (Class.GetValue() && !Object->IsA(Class.GetValue())) {
        return MakeError(ErrorCode::WrongType,
            "the object at '" + std::string(Path) + "' is a " + CppNameOf(Object->GetClass()) + ", not a " +
                CppNameOf(Class.GetValue()),
            "path", CppNameOf(Class.GetValue()));
    }
    return ReferTo(*Operation.Session, Object);
}

TSpearResult<ObjectRef> MakeObject(
    FOperation& Operation, const ClassArgument& ClassName, const ObjectRef& OuterReference, std::string_view Name) {
    TSpearResult<UClass*> Found = ResolveClassNonNull(Operation, ClassName);
    if (!Found.IsOk()) {
        return std::move(Found.GetError());
    }
    UClass* Class = Found.GetValue();
    const std::string ClassText = CppNameOf(Class);
    if (Class->HasAnyClassFlags(CLASS_Abstract | CLASS_Interface | CLASS_NewerVersionExists)) {
        return MakeError(ErrorCode::WrongType, ClassText + " is abstract: no object of it can be made", "class");
    }
    if (Class->IsChildOf(AActor::StaticClass())) {
        return MakeError(ErrorCode::WrongType, ClassText + " is an actor class: use spawn_actor", "class");
    }
    for (const UClass* Forbidden :
        {UField::StaticClass(), UPackage::StaticClass(), UWorld::StaticClass(), ULevel::StaticClass()}) {
        if (Class->IsChildOf(Forbidden)) {
            return MakeError(ErrorCode::WrongType, "objects of " + ClassText + " are made by the engine only", "class");
        }
    }
    UObject* Outer = GetTransientPackage();
    if (OuterReference.handle != 0) {
        TSpearResult<UObject*> Given = ResolveArgument<UObject>(Operation, OuterReference, "outer");
        if (!Given.IsOk()) {
            return std::move(Given.GetError());
        }
        Outer = Given.GetValue();
    }
    if (Class->ClassWithin && !Outer->IsA(Class->ClassWithin)) {
        return MakeError(ErrorCode::WrongType,
            "a " + ClassText + " can only be within a " + CppNameOf(Class->ClassWithin) + ", not within a " +
                CppNameOf(Outer->GetClass()),
            "outer", CppNameOf(Class->ClassWithin) + "*");
    }
    FName ObjectName;
    if (!Name.empty()) {
        FStatus Good = CheckObjectName(Name);
        if (!Good.IsOk()) {
            return std::move(Good.GetError());
        }
        ObjectName = FName(*FromUtf8(Name));
        if (StaticFindObjectFast(nullptr, Outer, ObjectName)) {
            return MakeError(ErrorCode::SpawnFailed,
                "'" + ToUtf8(Outer->GetPathName()) + "' already has an object '" + std::string(Name) + "'", "name");
        }
    }
    UObject* Object = NewObject<UObject>(Outer, Class, ObjectName);
    if (!Object) {
        return MakeError(ErrorCode::SpawnFailed, "the engine did not make the " + ClassText);
    }
    Operation.Session->Handles.KeepAlive(Object);
    return ReferTo(*Operation.Session, Object);
}

void BindClasses() {
    namespace service = spear::unreal_service;

    Bind(service::find_class, [](FOperation& Operation, std::string_view Name) -> TSpearResult<ObjectRef> {
        return Refer(Operation, FindClassByName(Name));
    });

    Bind(service::load_class,
        [](FOperation& Operation, ClassArgument Base, std::string_view Path) -> TSpearResult<ObjectRef> {
            return LoadClass(Operation, Base, Path);
        });

    Bind(service::load_object,
        [](FOperation& Operation, ClassArgument Class, std::string_view Path) -> TSpearResult<ObjectRef> {
            return LoadObject(Operation, Class, Path);
        });

    Bind(service::get_default_object, [](FOperation& Operation, ClassArgument Argument) -> TSpearResult<ObjectRef> {
        TSpearResult<UClass*> Class = ResolveClassNonNull(Operation, Argument);
        if (!Class.IsOk()) {
            return std::move(Class.GetError());
        }
        return ReferTo(*Operation.Session, Class.GetValue()->GetDefaultObject());
    });

    Bind(service::get_class, [](FOperation& Operation, ObjectRef Reference) -> TSpearResult<ObjectRef> {
        TSpearResult<UObject*> Object = ResolveArgument<UObject>(Operation, Reference, "object");
        if (!Object.IsOk()) {
            return std::move(Object.GetError());
        }
        return ReferTo(*Operation.Session, Object.GetValue()->GetClass());
    });

    Bind(service::get_super_class, [](FOperation& Operation, ClassArgument Argument) -> TSpearResult<ObjectRef> {
        TSpearResult<UClass*> Class = ResolveClassNonNull(Operation, Argument);
        if (!Class.IsOk()) {
            return std::move(Class.GetError());
        }
        return ReferTo(*Operation.Session, Class.GetValue()->GetSuperClass());
    });

    Bind(service::get_derived_classes,
        [](FOperation& Operation, ClassArgument Argument, bool bRecursive) -> TSpearResult<std::vector<ObjectRef>> {
            TSpearResult<UClass*> Class = ResolveClassNonNull(Operation, Argument);
            if (!Class.IsOk()) {
                return std::move(Class.GetError());
            }
            TArray<UClass*> Derived;
            GetDerivedClasses(Class.GetValue(), Derived, bRecursive);
            std::vector<std::pair<std::string, UClass*>> Sorted;
            for (UClass* One : Derived) {
                Sorted.emplace_back(CppNameOf(One), One);
            }
            std::sort(Sorted.begin(), Sorted.end(), [](const auto& A, const auto& B) { return A.first < B.first; });
            std::vector<ObjectRef> References;
            for (const auto& [Name, One] : Sorted) {
                References.push_back(ReferTo(*Operation.Session, One));
            }
            return References;
        });

    Bind(service::is_a, [](FOperation& Operation, ObjectRef Reference, ClassArgument Argument) -> TSpearResult<bool> {
        TSpearResult<UObject*> Object = ResolveArgument<UObject>(Operation, Reference, "object");
        if (!Object.IsOk()) {
            return std::move(Object.GetError());
        }
        TSpearResult<UClass*> Class = ResolveClassNonNull(Operation, Argument);
        if (!Class.IsOk()) {
            return std::move(Class.GetError());
        }
        const UClass* AsClass = Cast<UClass>(Object.GetValue());
        const UClass* Own = AsClass ? AsClass : Object.GetValue()->GetClass();
        return Class.GetValue()->HasAnyClassFlags(CLASS_Interface) ? Own->ImplementsInterface(Class.GetValue())
                                                                   : Own->IsChildOf(Class.GetValue());
    });
}

void BindObjects() {
    namespace service = spear::unreal_service;

    Bind(service::is_valid, [](FOperation& Operation, ObjectRef Reference) -> TSpearResult<bool> {
        return Operation.Session->Handles.IsAlive(Reference.handle);
    });

    Bind(service::get_path_name, [](FOperation& Operation, ObjectRef Reference) -> TSpearResult<std::string> {
        TSpearResult<UObject*> Object = ResolveArgument<UObject>(Operation, Reference, "object");
        if (!Object.IsOk()) {
            return std::move(Object.GetError());
        }
        return ToUtf8(Object.GetValue()->GetPathName());
    });

    Bind(service::new_object,
        [](FOperation& Operation, ClassArgument Class, ObjectRef Outer,
            std::string_view Name) -> TSpearResult<ObjectRef> { return MakeObject(Operation, Class, Outer, Name); });

    Bind(service::release_object, [](FOperation& Operation, ObjectRef Reference) -> FStatus {
        TSpearResult<UObject*> Object = ResolveArgument<UObject>(Operation, Reference, "object");
        if (!Object.IsOk()) {
            return std::move(Object.GetError());
        }
        if (!Operation.Session->Handles.Release(Object.GetValue())) {
            return MakeError(ErrorCode::UnknownObject,
                "'" + ToUtf8(Object.GetValue()->GetName()) +
                    "' is not kept by this session: it was not made by new_object, or was released before",
                "object");
        }
        return {};
    });

    Bind(service::call_function,
        [](FOperation& Operation, ObjectRef Reference, spear::ShapeId Shape,
            spear::ArgumentsView Arguments) -> FStatus {
            TSpearResult<UObject*> Object = Operation.Session->Handles.ResolveNonNull(Reference.handle);
            if (!Object.IsOk()) {
                const spear::TypeInfo* Info = Operation.Session->ClientTypes.find(Shape.number);
                Object.GetError().operation = Info ? Info->name : std::string();
                Object.GetError().argument = "object";
                return std::move(Object.GetError());
            }
            return Operation.Session->CallPlans.Call(Operation, Object.GetValue(), Shape.number, Arguments.values);
        });

    Bind(service::get_property, [](FOperation& Operation, ObjectRef Reference, spear::ShapeId Path) -> FStatus {
        TSpearResult<UObject*> Object = Operation.Session->Handles.ResolveNonNull(Reference.handle);
        if (!Object.IsOk()) {
            const spear::TypeInfo* Info = Operation.Session->ClientTypes.find(Path.number);
            Object.GetError().operation = Info ? Info->name : std::string();
            Object.GetError().argument = "object";
            return std::move(Object.GetError());
        }
        return Operation.Session->PropertyPaths.Get(Operation, Object.GetValue(), Path.number);
    });

    Bind(service::set_property,
        [](FOperation& Operation, ObjectRef Reference, spear::ShapeId Path, AnyView Value) -> FStatus {
            TSpearResult<UObject*> Object = Operation.Session->Handles.ResolveNonNull(Reference.handle);
            if (!Object.IsOk()) {
                const spear::TypeInfo* Info = Operation.Session->ClientTypes.find(Path.number);
                Object.GetError().operation = Info ? Info->name : std::string();
                Object.GetError().argument = "object";
                return std::move(Object.GetError());
            }
            return Operation.Session->PropertyPaths.Set(Operation, Object.GetValue(), Path.number, Value);
        });

    Bind(service::describe_class, [](FOperation& Operation, ClassArgument Argument) -> FStatus {
        TSpearResult<UClass*> Class = ResolveClassNonNull(Operation, Argument);
        if (!Class.IsOk()) {
            return std::move(Class.GetError());
        }
        WriteClassSchema(Class.GetValue(), *Operation.Out);
        return {};
    });

    Bind(service::get_schema, [](FOperation& Operation, std::vector<std::string> Modules) -> FStatus {
        return WriteSchema(Modules, *Operation.Out);
    });
}

} // namespace

void BindUnrealService() {
    BindClasses();
    BindObjects();
}

} // namespace SpearServer
