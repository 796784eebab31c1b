// SPDX-License-Identifier: MIT
#include "Reflection/ClassLookup.h"

#include "SpearText.h"

#include "Frame/Session.h"
#include "Reflection/NearestNames.h"
#include "Reflection/TypePlan.h"

#include "UObject/UObjectIterator.h"
#include "UObject/UnrealType.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace SpearServer {

namespace {

std::unordered_map<std::string, FWeakObjectPtr>& GetKnownClasses() {
    static std::unordered_map<std::string, FWeakObjectPtr> Known;
    return Known;
}

bool IsCurrent(const UClass* Class) { return !Class->HasAnyClassFlags(CLASS_NewerVersionExists) && IsValid(Class); }

bool NameFits(const UClass* Class, std::string_view Name, std::string_view ClassName) {
    return EqualsWithoutCase(Name, ClassName) || EqualsWithoutCase(Name, CppNameOf(Class)) ||
           (Class->HasAnyClassFlags(CLASS_Interface) && EqualsWithoutCase(Name, "U" + std::string(ClassName)));
}

/// All current classes that a name fits. Names are compared as numbers first: an engine has ten thousand classes, and making
/// the text of each name would take milliseconds of the game thread.
std::vector<UClass*> FindClassesByName(std::string_view Name) {
    std::vector<UClass*> Found;
    if (Name.size() >= NAME_SIZE) {
        return Found;
    }
    // As the reflection spells it, without U, A or I, and without UDEPRECATED_ or ADEPRECATED_.
    constexpr std::string_view Deprecated = "DEPRECATED_";
    std::vector<FName> Spellings;
    for (const std::size_t Prefix : {std::size_t(0), std::size_t(1), 1 + Deprecated.size()}) {
        if (Prefix < Name.size() && (Prefix < 2 || EqualsWithoutCase(Name.substr(1, Deprecated.size()), Deprecated))) {
            const FName Spelling(*FromUtf8(Name.substr(Prefix)), FNAME_Find); // None if nothing has that name
            if (!Spelling.IsNone()) {
                Spellings.push_back(Spelling);
            }
        }
    }
    if (Spellings.empty()) {
        return Found;
    }
    for (TObjectIterator<UClass> It; It; ++It) {
        const FName ClassName = It->GetFName();
        if (std::find(Spellings.begin(), Spellings.end(), ClassName) != Spellings.end() && IsCurrent(*It) &&
            NameFits(*It, Name, ToUtf8(It->GetName()))) {
            Found.push_back(*It);
        }
    }
    return Found;
}

} // namespace

TSpearResult<UClass*> FindClassByName(std::string_view Name) {
    if (Name.empty()) {
        return MakeError(ErrorCode::UnknownClass, "the name of a class is empty");
    }
    const std::string Key = ToLower(Name);
    if (const auto At = GetKnownClasses().find(Key); At != GetKnownClasses().end()) {
        if (UClass* Class = Cast<UClass>(At->second.Get()); Class && IsCurrent(Class)) {
            return Class;
        }
    }
    if (Name[0] == '/') {
        UClass* Class =
            Name.size() < NAME_SIZE && IsValidName(Name) ? FindObject<UClass>(nullptr, *FromUtf8(Name)) : nullptr;
        if (!Class) {
            FNearestNames Nearest(Name);
            for (TObjectIterator<UClass> It; It; ++It) {
                Nearest.Add(ToUtf8(It->GetPathName()));
            }
            return MakeError(ErrorCode::UnknownClass,
                "no loaded class has the path '" + std::string(Name.substr(0, 256)) + "'" + Nearest.Suggestion());
        }
        return Class;
    }

    const std::vector<UClass*> Found = FindClassesByName(Name);
    if (Found.empty()) {
        FNearestNames Nearest(Name);
        for (TObjectIterator<UClass> It; It; ++It) {
            if (IsCurrent(*It)) {
                Nearest.Add(CppNameOf(*It));
            }
        }
        return MakeError(ErrorCode::UnknownClass,
            "no loaded class is called '" + std::string(Name.substr(0, 256)) + "'" + Nearest.Suggestion());
    }
    if (Found.size() > 1) {
        std::string Paths;
        for (const UClass* Class : Found) {
            Paths += (Paths.empty() ? "" : ", ") + ToUtf8(Class->GetPathName());
        }
        return MakeError(ErrorCode::AmbiguousName,
            "several classes are called '" + std::string(Name) + "': " + Paths + "; give the path");
    }
    GetKnownClasses()[Key] = FWeakObjectPtr(Found.front());
    return Found.front();
}

TSpearResult<UClass*> ResolveClass(FOperation& Operation, const spear::ClassArgument& Argument) {
    if (!Argument.name.empty()) {
        return FindClassByName(Argument.name);
    }
    TSpearResult<UObject*> Object = Operation.Session->Handles.Resolve(Argument.object.handle);
    if (!Object.IsOk()) {
        return std::move(Object.GetError());
    }
    if (!Object.GetValue()) {
        return static_cast<UClass*>(nullptr);
    }
    UClass* Class = Cast<UClass>(Object.GetValue());
    if (!Class) {
        return MakeError(ErrorCode::WrongType,
            "a class is needed, not the " + CppNameOf(Object.GetValue()->GetClass()) + " '" +
                ToUtf8(Object.GetValue()->GetName()) + "'",
            "class", "UClass*");
    }
    return Class;
}

TSpearResult<UClass*> ResolveClassNonNull(FOperation& Operation, const spear::ClassArgument& Argument) {
    TSpearResult<UClass*> Class = ResolveClass(Operation, Argument);
    if (Class.IsOk() && !Class.GetValue()) {
        return MakeError(ErrorCode::NullObject, "a class is needed here, not null", "class", "UClass*");
    }
    return Class;
}

void AddFunctionNames(FNearestNames& Nearest, const UClass* Class) {
    for (TFieldIterator<UFunction> It(Class, EFieldIterationFlags::Default | EFieldIterationFlags::IncludeInterfaces);
        It; ++It) {
        Nearest.Add(ToUtf8(It->GetName()));
    }
}

void AddPropertyNames(FNearestNames& Nearest, const UStruct* Struct) {
    for (TFieldIterator<FProperty> It(Struct); It; ++It) {
        Nearest.Add(ToUtf8(It->GetName()));
    }
}

void ForgetClassNames() { GetKnownClasses().clear(); }

} // namespace SpearServer
