// SPDX-License-Identifier: MIT
// unreal_service: worlds, spawning, and the families of queries for actors and components, which come from one
// template.
#include "Services/Services.h"

#include "Services/ObjectArguments.h"

#include "Reflection/ClassLookup.h"
#include "Reflection/NearestNames.h"

#include "Components/ActorComponent.h"
#include "Engine/Engine.h"
#include "Engine/World.h"
#include "EngineUtils.h"
#include "GameFramework/Actor.h"

#include "spear/entry_points/unreal_service.hpp"

#include <map>

namespace SpearServer {

namespace {

using spear::ClassArgument;
using spear::ObjectRef;

// Worlds and spawning
// -------------------------------------------------------------------------------------------------------

std::string WorldTypeText(EWorldType::Type Type) {
    switch (Type) {
    case EWorldType::Game:
        return "game";
    case EWorldType::PIE:
        return "pie";
    case EWorldType::Editor:
        return "editor";
    case EWorldType::EditorPreview:
        return "editor_preview";
    case EWorldType::GamePreview:
        return "game_preview";
    case EWorldType::Inactive:
        return "inactive";
    default:
        return "none";
    }
}

TSpearResult<ESpawnActorCollisionHandlingMethod> ParseCollisionHandling(const std::string& Text) {
    static const std::pair<const char*, ESpawnActorCollisionHandlingMethod> Known[] = {
        {"undefined", ESpawnActorCollisionHandlingMethod::Undefined},
        {"always_spawn", ESpawnActorCollisionHandlingMethod::AlwaysSpawn},
        {"adjust_if_possible_but_always_spawn", ESpawnActorCollisionHandlingMethod::AdjustIfPossibleButAlwaysSpawn},
        {"adjust_if_possible_but_dont_spawn_if_colliding",
            ESpawnActorCollisionHandlingMethod::AdjustIfPossibleButDontSpawnIfColliding},
        {"dont_spawn_if_colliding", ESpawnActorCollisionHandlingMethod::DontSpawnIfColliding},
    };
    FNearestNames Nearest(Text);
    for (const auto& [Name, Method] : Known) {
        if (EqualsWithoutCase(Name, Text)) {
            return Method;
        }
        Nearest.Add(Name);
    }
    return MakeError(ErrorCode::OutOfRange,
        "'" + Text.substr(0, 256) + "' is no way of handling collisions" + Nearest.Suggestion(),
        "options.collision_handling");
}

TSpearResult<ObjectRef> SpawnActor(FOperation& Operation, const ObjectRef& WorldReference,
    const ClassArgument& ClassName, const spear::SpawnOptions& Options) {
    TSpearResult<UWorld*> World = ResolveWorld(Operation, WorldReference);
    if (!World.IsOk()) {
        return std::move(World.GetError());
    }
    TSpearResult<UClass*> Found = ResolveClassNonNull(Operation, ClassName);
    if (!Found.IsOk()) {
        return std::move(Found.GetError());
    }
    UClass* Class = Found.GetValue();
    const std::string ClassText = CppNameOf(Class);
    if (!Class->IsChildOf(AActor::StaticClass())) {
        return MakeError(ErrorCode::WrongType, ClassText + " is no actor class", "class", "TSubclassOf<AActor>");
    }
    if (Class->HasAnyClassFlags(CLASS_Abstract | CLASS_Deprecated | CLASS_NewerVersionExists)) {
        return MakeError(ErrorCode::WrongType, ClassText + " is abstract or deprecated: it cannot be spawned", "class",
            "TSubclassOf<AActor>");
    }

    FActorSpawnParameters Parameters;
    Parameters.bDeferConstruction = true; // so that tags are there when BeginPlay runs
    TSpearResult<ESpawnActorCollisionHandlingMethod> Handling = ParseCollisionHandling(Options.collision_handling);
    if (!Handling.IsOk()) {
        return std::move(Handling.GetError());
    }
    Parameters.SpawnCollisionHandlingOverride = Handling.GetValue();
    if (!Options.name.empty()) {
        if (!IsValidName(Options.name) ||
            Options.name.find_first_of("\"' ,/.:|&!~\n\r\t@#(){}[]=;^%$`\\*?<>") != std::string::npos) {
            return MakeError(ErrorCode::OutOfRange,
                "'" + Options.name.substr(0, 256) +
                    "' is no object name: it is too long or has characters that names cannot have",
                "options.name");
        }
        Parameters.Name = FName(*FromUtf8(Options.name));
        Parameters.NameMode = decltype(Parameters.NameMode)::Required_ReturnNull;
    }
    if (Options.owner.handle != 0) {
        TSpearResult<AActor*> Owner = ResolveArgument<AActor>(Operation, Options.owner, "options.owner");
        if (!Owner.IsOk()) {
            return std::move(Owner.GetError());
        }
        Parameters.Owner = Owner.GetValue();
    }
    for (const std::string& Tag : Options.tags) {
        if (!IsValidName(Tag)) {
            return MakeError(ErrorCode::OutOfRange,
                "'" + Tag.substr(0, 256) + "' is no tag: it is too long or has a zero byte", "options.tags");
        }
    }
    const FTransform Transform(FRotator(Options.rotation.Pitch, Options.rotation.Yaw, Options.rotation.Roll),
        FVector(Options.location.X, Options.location.Y, Options.location.Z),
        FVector(Options.scale.X, Options.scale.Y, Options.scale.Z));
    if (Transform.ContainsNaN()) {
        return MakeError(ErrorCode::OutOfRange, "location, rotation or scale are not finite numbers", "options");
    }

    AActor* Actor = World.GetValue()->SpawnActor(Class, &Transform, Parameters);
    if (!Actor) {
        return MakeError(ErrorCode::SpawnFailed,
            Options.name.empty() ? "the engine did not spawn the " + ClassText +
                                       ": the place is taken (see options.collision_handling), or the world is ending"
                                 : "the engine did not spawn the " + ClassText + " '" + Options.name +
                                       "': the name or the place is taken");
    }
    for (const std::string& Tag : Options.tags) {
        Actor->Tags.Add(FName(*FromUtf8(Tag)));
    }
    Actor->FinishSpawning(Transform);
    if (!IsUsable(Actor)) {
        return MakeError(ErrorCode::SpawnFailed,
            "the " + ClassText + " was destroyed while it was spawned: the place is taken, or its own code did it");
    }
    return ReferTo(*Operation.Session, Actor);
}

void BindWorlds() {
    namespace service = spear::unreal_service;

    Bind(service::get_worlds, [](FOperation& Operation) -> TSpearResult<std::vector<spear::WorldInfo>> {
        std::vector<spear::WorldInfo> Worlds;
        const UWorld* Primary = GetPrimaryWorld();
        for (const FWorldContext& Context : GEngine->GetWorldContexts()) {
            if (UWorld* World = Context.World()) {
                Worlds.push_back(
                    {ReferTo(*Operation.Session, World), ToUtf8(World->GetMapName()), ToUtf8(World->GetPathName()),
                        WorldTypeText(World->WorldType), World->HasBegunPlay(), World == Primary});
            }
        }
        return Worlds;
    });

    Bind(service::spawn_actor,
        [](FOperation& Operation, ObjectRef World, ClassArgument Class, spear::SpawnOptions Options)
            -> TSpearResult<ObjectRef> { return SpawnActor(Operation, World, Class, Options); });

    Bind(service::destroy_actor, [](FOperation& Operation, ObjectRef Reference) -> TSpearResult<bool> {
        TSpearResult<AActor*> Actor = ResolveArgument<AActor>(Operation, Reference, "actor");
        if (!Actor.IsOk()) {
            return std::move(Actor.GetError());
        }
        return Actor.GetValue()->Destroy();
    });
}

// Queries
// -------------------------------------------------------------------------------------------------------------------

/// Actors of a world.
struct FActorFamily {
    using FElement = AActor;
    static constexpr const char* What = "actor";
    static bool HasTag(const AActor* Actor, FName Tag) { return Actor->ActorHasTag(Tag); }

    template <typename F>
    static FStatus ForEach(FOperation& Operation, const ObjectRef& Scope, UClass* Class, F&& Visit) {
        TSpearResult<UWorld*> World = ResolveWorld(Operation, Scope);
        if (!World.IsOk()) {
            return std::move(World.GetError());
        }
        for (TActorIterator<AActor> It(World.GetValue(), Class); It; ++It) {
            if (IsUsable(*It)) {
                Visit(*It);
            }
        }
        return {};
    }
    static std::string DescribeScope(const ObjectRef&) { return "in the world"; }
};

/// Components of an actor.
struct FComponentFamily {
    using FElement = UActorComponent;
    static constexpr const char* What = "component";
    static bool HasTag(const UActorComponent* Component, FName Tag) { return Component->ComponentHasTag(Tag); }

    template <typename F>
    static FStatus ForEach(FOperation& Operation, const ObjectRef& Scope, UClass* Class, F&& Visit) {
        TSpearResult<AActor*> Actor = ResolveArgument<AActor>(Operation, Scope, "actor");
        if (!Actor.IsOk()) {
            return std::move(Actor.GetError());
        }
        TArray<UActorComponent*> Components;
        Actor.GetValue()->GetComponents(Class, Components);
        for (UActorComponent* Component : Components) {
            if (IsUsable(Component)) {
                Visit(Component);
            }
        }
        return {};
    }
    static std::string DescribeScope(const ObjectRef&) { return "in the actor"; }
};

enum class EKey : uint8 { Name, Pattern, Tag, Path, Class };

template <typename TFamily>
using TFound = std::vector<typename TFamily::FElement*>;

template <typename TFamily, EKey Key>
TSpearResult<TFound<TFamily>> FindElements(
    FOperation& Operation, const ObjectRef& Scope, const ClassArgument& ClassName, std::string_view Text) {
    using FElement = typename TFamily::FElement;
    TSpearResult<UClass*> Class = ResolveClass(Operation, ClassName);
    if (!Class.IsOk()) {
        return std::move(Class.GetError());
    }
    UClass* Wanted = Class.GetValue() ? Class.GetValue() : FElement::StaticClass();
    if (!Wanted->IsChildOf(FElement::StaticClass())) {
        return MakeError(ErrorCode::WrongType, CppNameOf(Wanted) + " is no " + TFamily::What + " class", "class",
            CppNameOf(FElement::StaticClass()));
    }
    const FName Name = Key == EKey::Name || Key == EKey::Tag ? FindName(Text) : FName();
    TFound<TFamily> Found;
    FStatus Visited = TFamily::ForEach(Operation, Scope, Wanted, [&](FElement* Element) {
        bool bFits = true;
        if constexpr (Key == EKey::Name) {
            bFits = !Name.IsNone() && Element->GetFName() == Name;
        } else if constexpr (Key == EKey::Tag) {
            bFits = !Name.IsNone() && TFamily::HasTag(Element, Name);
        } else if constexpr (Key == EKey::Path) {
            bFits = EqualsWithoutCase(ToUtf8(Element->GetPathName()), Text);
        } else if constexpr (Key == EKey::Pattern) {
            bFits = MatchesPattern(ToUtf8(Element->GetName()), Text);
        }
        if (bFits) {
            Found.push_back(Element);
        }
    });
    if (!Visited.IsOk()) {
        return std::move(Visited.GetError());
    }
    return Found;
}

constexpr const char* KeyText(EKey Key) {
    return Key == EKey::Name ? "name" : Key == EKey::Tag ? "tag" : Key == EKey::Path ? "path" : "class";
}

template <typename TFamily, EKey Key>
TSpearResult<ObjectRef> FindOneElement(
    FOperation& Operation, const ObjectRef& Scope, const ClassArgument& Class, std::string_view Text) {
    TSpearResult<TFound<TFamily>> Found = FindElements<TFamily, Key>(Operation, Scope, Class, Text);
    if (!Found.IsOk()) {
        return std::move(Found.GetError());
    }
    if (Found.GetValue().size() == 1) {
        return ReferTo(*Operation.Session, Found.GetValue().front());
    }
    const std::string Wanted = std::string(TFamily::What) + " of the " + KeyText(Key) +
                               (Key == EKey::Class ? "" : " '" + std::string(Text.substr(0, 256)) + "'");
    if (Found.GetValue().empty()) {
        FNearestNames Nearest(Text);
        FStatus Visited = TFamily::ForEach(
            Operation, Scope, TFamily::FElement::StaticClass(), [&](typename TFamily::FElement* Element) {
                if constexpr (Key == EKey::Name) {
                    Nearest.Add(ToUtf8(Element->GetName()));
                } else if constexpr (Key == EKey::Path) {
                    Nearest.Add(ToUtf8(Element->GetPathName()));
                }
            });
        if (!Visited.IsOk()) {
            return std::move(Visited.GetError());
        }
        return MakeError(ErrorCode::UnknownObject,
            "there is no " + Wanted + " " + TFamily::DescribeScope(Scope) + Nearest.Suggestion(),
            Key == EKey::Class ? "class" : KeyText(Key));
    }
    std::string Names;
    constexpr std::size_t MostNames = 5;
    for (std::size_t Index = 0; Index < Found.GetValue().size() && Index < MostNames; ++Index) {
        Names += (Index ? ", " : "") + ToUtf8(Found.GetValue()[Index]->GetName());
    }
    return MakeError(ErrorCode::AmbiguousName,
        "more than one " + Wanted + ": there are " + std::to_string(Found.GetValue().size()) + " (" + Names +
            (Found.GetValue().size() > MostNames ? ", ..." : "") + "). Ask for the list, or narrow it down by class or name",
        Key == EKey::Class ? "class" : KeyText(Key));
}

template <typename TFamily, EKey Key, typename E>
void BindOne(const E& Entry) {
    Bind(Entry,
        [](FOperation& Operation, ObjectRef Scope, ClassArgument Class, std::string_view Text)
            -> TSpearResult<ObjectRef> { return FindOneElement<TFamily, Key>(Operation, Scope, Class, Text); });
}

template <typename TFamily, EKey Key, typename E>
void BindList(const E& Entry) {
    Bind(Entry,
        [](FOperation& Operation, ObjectRef Scope, ClassArgument Class,
            std::string_view Text) -> TSpearResult<std::vector<ObjectRef>> {
            TSpearResult<TFound<TFamily>> Found = FindElements<TFamily, Key>(Operation, Scope, Class, Text);
            if (!Found.IsOk()) {
                return std::move(Found.GetError());
            }
            std::vector<ObjectRef> References;
            for (const auto* Element : Found.GetValue()) {
                References.push_back(ReferTo(*Operation.Session, Element));
            }
            return References;
        });
}

template <typename TFamily, EKey Key, typename E>
void BindMap(const E& Entry) {
    Bind(Entry,
        [](FOperation& Operation, ObjectRef Scope, ClassArgument Class,
            std::string_view Text) -> TSpearResult<std::map<std::string, ObjectRef>> {
            TSpearResult<TFound<TFamily>> Found = FindElements<TFamily, Key>(Operation, Scope, Class, Text);
            if (!Found.IsOk()) {
                return std::move(Found.GetError());
            }
            std::map<std::string, ObjectRef> References;
            for (const auto* Element : Found.GetValue()) {
                // Actors of several levels may share a name: the later ones stand under their paths.
                const auto [At, bIsNew] =
                    References.try_emplace(ToUtf8(Element->GetName()), ReferTo(*Operation.Session, Element));
                if (!bIsNew) {
                    References[ToUtf8(Element->GetPathName())] = ReferTo(*Operation.Session, Element);
                }
            }
            return References;
        });
}

} // namespace

void BindUnrealQueries() {
    namespace service = spear::unreal_service;
    BindWorlds();

    BindOne<FActorFamily, EKey::Name>(service::find_actor_by_name);
    BindOne<FActorFamily, EKey::Tag>(service::find_actor_by_tag);
    BindOne<FActorFamily, EKey::Path>(service::find_actor_by_path);
    BindOne<FActorFamily, EKey::Class>(service::find_actor_by_class);
    BindList<FActorFamily, EKey::Tag>(service::find_actors_by_tag);
    BindList<FActorFamily, EKey::Pattern>(service::find_actors_by_name);
    BindList<FActorFamily, EKey::Class>(service::find_actors_by_class);
    BindMap<FActorFamily, EKey::Tag>(service::find_actors_by_tag_as_map);
    BindMap<FActorFamily, EKey::Class>(service::find_actors_by_class_as_map);

    BindOne<FComponentFamily, EKey::Name>(service::find_component_by_name);
    BindOne<FComponentFamily, EKey::Tag>(service::find_component_by_tag);
    BindOne<FComponentFamily, EKey::Class>(service::find_component_by_class);
    BindList<FComponentFamily, EKey::Tag>(service::find_components_by_tag);
    BindList<FComponentFamily, EKey::Class>(service::find_components_by_class);
    BindMap<FComponentFamily, EKey::Class>(service::find_components_by_class_as_map);
}

} // namespace SpearServer
