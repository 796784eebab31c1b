// SPDX-License-Identifier: MIT
// Splitting paths, and working out their legs.
#include "Reflection/PropertyPathLeg.h"

#include "SpearText.h"

#include "Reflection/ClassLookup.h"
#include "Reflection/NearestNames.h"

#include "UObject/PropertyOptional.h"

#include "spear/limits.hpp"

#include <charconv>

namespace SpearServer {

TSpearResult<std::vector<FPathSegment>> ParsePropertyPath(std::string_view Path) {
    std::vector<FPathSegment> Segments;
    const auto Malformed = [&](std::string_view Why) {
        return MakeError(ErrorCode::UnknownProperty,
            "'" + std::string(Path.substr(0, 256)) + "' is no property path: " + std::string(Why) +
                "; paths look like RootComponent.RelativeLocation.X, Tags[0], Weights[\"door\"]");
    };
    std::size_t At = 0;
    bool bWantsName = true;
    while (At < Path.size() || bWantsName) {
        if (Segments.size() >= spear::limits::max_path_segments) {
            return MakeError(ErrorCode::LimitExceeded, "the property path has more than limits::max_path_segments = " +
                                                           std::to_string(spear::limits::max_path_segments) +
                                                           " segments");
        }
        FPathSegment Segment;
        if (bWantsName) {
            const std::size_t End = std::min(Path.find_first_of(".[", At), Path.size());
            Segment.Text = std::string(Path.substr(At, End - At));
            if (Segment.Text.empty()) {
                return Malformed("a name is missing");
            }
            At = End;
            bWantsName = false;
        } else if (Path[At] == '.') {
            ++At;
            bWantsName = true;
            continue;
        } else if (Path[At] == '[') {
            ++At;
            Segment.bBracket = true;
            Segment.bQuoted = At < Path.size() && Path[At] == '"';
            if (Segment.bQuoted) {
                for (++At; At < Path.size() && Path[At] != '"'; ++At) {
                    if (Path[At] == '\\' && At + 1 < Path.size()) {
                        ++At;
                    }
                    Segment.Text += Path[At];
                }
                if (At >= Path.size()) {
                    return Malformed("a quote is not closed");
                }
                ++At;
            } else {
                const std::size_t End = Path.find(']', At);
                if (End == std::string_view::npos || End == At) {
                    return Malformed("a bracket is empty or not closed");
                }
                Segment.Text = std::string(Path.substr(At, End - At));
                At = End;
            }
            if (At >= Path.size() || Path[At] != ']') {
                return Malformed("a bracket is not closed");
            }
            ++At;
        } else {
            return Malformed("after a bracket comes '.', '[' or the end");
        }
        Segments.push_back(std::move(Segment));
    }
    return Segments;
}

std::string TextOfSegments(const std::vector<FPathSegment>& Segments, std::size_t Count) {
    std::string Text;
    for (std::size_t Index = 0; Index < Count && Index < Segments.size(); ++Index) {
        const FPathSegment& Segment = Segments[Index];
        if (Segment.bBracket) {
            Text += Segment.bQuoted ? "[\"" + Segment.Text + "\"]" : "[" + Segment.Text + "]";
        } else {
            Text += (Text.empty() ? "" : ".") + Segment.Text;
        }
    }
    return Text;
}

namespace {

/// A non-negative integer, or -1.
int32 ParseIndex(const FPathSegment& Segment) {
    int32 Index = -1;
    const char* End = Segment.Text.data() + Segment.Text.size();
    const auto Result = std::from_chars(Segment.Text.data(), End, Index);
    return Result.ec == std::errc() && Result.ptr == End && !Segment.bQuoted ? Index : -1;
}

ErrorInfo NoSuchMember(const UStruct* Owner, const std::string& OwnerName, const std::string& Name) {
    FNearestNames Nearest(Name);
    AddPropertyNames(Nearest, Owner);
    return MakeError(ErrorCode::UnknownProperty,
        OwnerName + " has no property '" + Name.substr(0, 256) + "'" + Nearest.Suggestion());
}

const FProperty* FindMember(const UStruct* Owner, const std::string& Name) {
    const FName PropertyName = FindName(Name);
    return PropertyName.IsNone() ? nullptr : Owner->FindPropertyByName(PropertyName);
}

} // namespace

UObject* ObjectBehind(const FProperty* Property, const void* Address) {
    if (const FInterfaceProperty* Interface = CastField<FInterfaceProperty>(Property)) {
        return Interface->GetPropertyValue(Address).GetObject();
    }
    return CastFieldChecked<FObjectPropertyBase>(Property)->GetObjectPropertyValue(Address);
}

TSpearResult<std::unique_ptr<FPathLeg>> BuildPathLeg(
    const std::vector<FPathSegment>& Segments, const UClass* Class, std::size_t First) {
    auto Leg = std::make_unique<FPathLeg>();
    Leg->Class = FWeakObjectPtr(Class);
    std::size_t At = First;
    for (; At < Segments.size(); ++At) {
        const FPathSegment& Segment = Segments[At];
        const FProperty* Current = Leg->Last;
        const bool bWholeStaticArray = Current && Current->ArrayDim > 1 && !Leg->bStaticElement;
        const std::string Place = "'" + TextOfSegments(Segments, At) + "'";

        if (!Segment.bBracket) {
            const FStructProperty* StructProperty = bWholeStaticArray ? nullptr : CastField<FStructProperty>(Current);
            if (Current && !bWholeStaticArray &&
                (Current->IsA<FObjectPropertyBase>() || Current->IsA<FInterfaceProperty>())) {
                break; // the rest is up to the object's own class
            }
            if (Current && !StructProperty) {
                return MakeError(ErrorCode::UnknownProperty,
                    Place + " is a " + CppTypeOf(Current) + (bWholeStaticArray ? " array" : "") +
                        ": it has no property '" + Segment.Text.substr(0, 256) + "'");
            }
            const UStruct* Owner = Current ? static_cast<const UStruct*>(StructProperty->Struct) : Class;
            const FProperty* Member = FindMember(Owner, Segment.Text);
            if (!Member) {
                return NoSuchMember(
                    Owner, Current ? CppNameOf(StructProperty->Struct) : CppNameOf(Class), Segment.Text);
            }
            Leg->Steps.push_back({FPathStep::Field, Member, 0, {}});
            Leg->Last = Member;
            Leg->bStaticElement = false;
            continue;
        }

        if (!Current) {
            return MakeError(ErrorCode::UnknownProperty, Place + " leads to an object, which cannot be indexed");
        }
        const int32 Index = ParseIndex(Segment);
        const auto WantsIndex = [&] {
            return MakeError(ErrorCode::OutOfRange,
                "[" + Segment.Text.substr(0, 256) + "] is no index of " + Place + ": a number from 0 is needed");
        };
        if (bWholeStaticArray) {
            if (Index < 0 || Index >= Current->ArrayDim) {
                return MakeError(ErrorCode::OutOfRange, "[" + Segment.Text.substr(0, 256) + "] is no index of " +
                                                            Place + ", which has " + std::to_string(Current->ArrayDim) +
                                                            " elements");
            }
            Leg->Steps.push_back({FPathStep::StaticElement, Current, Index, {}});
            Leg->bStaticElement = true;
        } else if (const FArrayProperty* Array = CastField<FArrayProperty>(Current)) {
            if (Index < 0) {
                return WantsIndex();
            }
            Leg->Steps.push_back({FPathStep::ArrayElement, Current, Index, {}});
            Leg->Last = Array->Inner;
            Leg->bStaticElement = false;
        } else if (const FSetProperty* Set = CastField<FSetProperty>(Current)) {
            if (Index < 0) {
                return WantsIndex();
            }
            Leg->Steps.push_back({FPathStep::SetElement, Current, Index, {}});
            Leg->Last = Set->ElementProp;
            Leg->bStaticElement = false;
        } else if (const FMapProperty* Map = CastField<FMapProperty>(Current)) {
            Leg->Steps.push_back({FPathStep::MapValue, Current, 0, Segment.Text});
            Leg->Last = Map->ValueProp;
            Leg->bStaticElement = false;
        } else {
            return MakeError(
                ErrorCode::UnknownProperty, Place + " is a " + CppTypeOf(Current) + " and cannot be indexed");
        }
    }
    Leg->NextSegment = At;
    Leg->Plan = GetTypePlan(Leg->Last);
    if (Leg->bStaticElement) {
        Leg->Plan = Leg->Plan->Inner;
    }
    return Leg;
}

FStatus ReadMapKey(const FProperty* Property, const std::string& Text, void* Key) {
    const FString Unreal = FromUtf8(Text);
    bool bGood = true;
    if (const FStrProperty* String = CastField<FStrProperty>(Property)) {
        String->SetPropertyValue(Key, Unreal);
    } else if (const FNameProperty* Name = CastField<FNameProperty>(Property)) {
        bGood = IsValidName(Text);
        if (bGood) {
            Name->SetPropertyValue(Key, FName(*Unreal));
        }
    } else if (Property->IsA<FNumericProperty>() && !CastFieldChecked<FNumericProperty>(Property)->IsEnum()) {
        const FNumericProperty* Number = CastFieldChecked<FNumericProperty>(Property);
        const char* End = Text.data() + Text.size();
        if (Number->IsInteger()) {
            int64 Value = 0;
            const auto Result = std::from_chars(Text.data(), End, Value);
            bGood = Result.ec == std::errc() && Result.ptr == End && Number->CanHoldValue(Value);
            if (bGood) {
                Number->SetIntPropertyValue(Key, Value);
            }
        } else {
            char* Parsed = nullptr;
            const double Value = std::strtod(Text.c_str(), &Parsed);
            bGood = !Text.empty() && Parsed == Text.c_str() + Text.size();
            Number->SetFloatingPointPropertyValue(Key, Value);
        }
    } else {
        bGood = ImportDefaultText(Property, *Unreal, Key);
    }
    if (!bGood) {
        return MakeError(ErrorCode::OutOfRange,
            "'" + Text.substr(0, 256) + "' is no key of type " + CppTypeOf(Property), {}, CppTypeOf(Property));
    }
    return {};
}

} // namespace SpearServer
