// SPDX-License-Identifier: MIT
#pragma once

// Property paths: "RootComponent.RelativeLocation.X", "Tags[0]", "Weights[\"door\"].Value". A path is split into legs,
// one for each object it leads through; a leg is worked out once per (class of the object, path, place in it) and held
// weakly.

#include "CoreMinimal.h"
#include "UObject/Class.h"
#include "UObject/UnrealType.h"
#include "UObject/WeakObjectPtr.h"

#include "Frame/Result.h"
#include "Reflection/TypePlan.h"

#include "spear/codec.hpp"

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace SpearServer {

struct FOperation;

/// One name or bracket of a path.
struct FPathSegment {
    std::string Text; ///< the name, or what stands between the brackets (a quoted key without its quotes)
    bool bBracket = false;
    bool bQuoted = false;
};

/// Splits a path. WrongType if it is not well formed, LimitExceeded if it is too long.
TSpearResult<std::vector<FPathSegment>> ParsePropertyPath(std::string_view Path);

struct FPathStep {
    enum EKind : uint8 { Field, StaticElement, ArrayElement, SetElement, MapValue } Kind = Field;
    const FProperty* Property = nullptr; ///< Field: the field; the others: the container's property
    int32 Index = 0;
    std::string Key; ///< MapValue
};

/// The part of a path within one object.
struct FPathLeg {
    FWeakObjectPtr Class;
    std::vector<FPathStep> Steps;
    std::size_t NextSegment = 0;     ///< where the next leg begins; the number of segments if this is the last
    const FProperty* Last = nullptr; ///< of the value that the leg leads to
    bool bStaticElement = false;     ///< that value is one element of a C array
    FTypePlanRef Plan;               ///< of that value
};

/// The paths of one session.
class FPropertyPaths {
public:
    FStatus Get(FOperation& Operation, UObject* Target, spear::TypeId Shape);
    FStatus Set(FOperation& Operation, UObject* Target, spear::TypeId Shape, const spear::AnyView& Value);
    void Sweep();

private:
    struct FPath {
        std::string Text;
        std::vector<FPathSegment> Segments;
    };
    struct FKey {
        const UClass* Class;
        spear::TypeId Shape;
        std::size_t Segment;
        bool operator==(const FKey&) const = default;
    };
    struct FKeyHash {
        std::size_t operator()(const FKey& Key) const {
            return (reinterpret_cast<std::size_t>(Key.Class) / 64 * 31 + Key.Shape) * 31 + Key.Segment;
        }
    };
    TSpearResult<const FPath*> FindPath(FOperation& Operation, spear::TypeId Shape);
    TSpearResult<const FPathLeg*> FindLeg(
        const FPath& Path, const UClass* Class, spear::TypeId Shape, std::size_t Segment);
    /// Follows the path to its last object; gives that object and the leg within it.
    FStatus FollowObjects(const FPath& Path, spear::TypeId Shape, UObject*& Object, const FPathLeg*& Leg);

    std::unordered_map<spear::TypeId, FPath> Paths;
    std::unordered_map<FKey, std::unique_ptr<FPathLeg>, FKeyHash> Legs;
};

} // namespace SpearServer
