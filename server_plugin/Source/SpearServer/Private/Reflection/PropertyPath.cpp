// SPDX-License-Identifier: MIT
#include "Reflection/PropertyPath.h"

#include "SpearText.h"

#include "Frame/Session.h"
#include "Reflection/PropertyPathLeg.h"
#include "Reflection/ValueReader.h"
#include "Reflection/ValueWriter.h"

namespace SpearServer {

namespace {

using FTemporaries = std::vector<std::unique_ptr<FTemporaryValue>>;

/// Goes one step. Container is where the value before the step lies (the object or struct for a field).
TSpearResult<void*> GoStep(const FPathStep& Step, void* Container) {
    switch (Step.Kind) {
    case FPathStep::Field:
        return Step.Property->ContainerPtrToValuePtr<void>(Container);
    case FPathStep::StaticElement:
        return static_cast<void*>(
            static_cast<uint8*>(Container) + static_cast<std::ptrdiff_t>(Step.Index) * Step.Property->GetElementSize());
    case FPathStep::ArrayElement: {
        FScriptArrayHelper Helper(CastFieldChecked<FArrayProperty>(Step.Property), Container);
        if (!Helper.IsValidIndex(Step.Index)) {
            return MakeError(ErrorCode::OutOfRange, "index " + std::to_string(Step.Index) + " is outside of '" +
                                                        ToUtf8(Step.Property->GetName()) + "', which has " +
                                                        std::to_string(Helper.Num()) + " elements");
        }
        return static_cast<void*>(Helper.GetRawPtr(Step.Index));
    }
    case FPathStep::SetElement: {
        FScriptSetHelper Helper(CastFieldChecked<FSetProperty>(Step.Property), Container);
        if (Step.Index >= Helper.Num()) {
            return MakeError(ErrorCode::OutOfRange, "index " + std::to_string(Step.Index) + " is outside of '" +
                                                        ToUtf8(Step.Property->GetName()) + "', which has " +
                                                        std::to_string(Helper.Num()) + " elements");
        }
        int32 Left = Step.Index;
        int32 Slot = 0;
        for (; Slot < Helper.GetMaxIndex(); ++Slot) {
            if (Helper.IsValidIndex(Slot) && Left-- == 0) {
                break;
            }
        }
        return static_cast<void*>(Helper.GetElementPtr(Slot));
    }
    case FPathStep::MapValue: {
        const FMapProperty* Property = CastFieldChecked<FMapProperty>(Step.Property);
        const FTemporaryValue Key(Property->KeyProp);
        FStatus Read = ReadMapKey(Property->KeyProp, Step.Key, Key.Get());
        if (!Read.IsOk()) {
            return std::move(Read.GetError());
        }
        FScriptMapHelper Helper(Property, Container);
        void* Value = Helper.FindValueFromHash(Key.Get());
        if (!Value) {
            return MakeError(ErrorCode::OutOfRange,
                "'" + ToUtf8(Property->GetName()) + "' has no key '" + Step.Key.substr(0, 256) + "'");
        }
        return Value;
    }
    }
    return static_cast<void*>(nullptr);
}

/// Copies what a property holds (through its native getter, where there is one) to temporary memory.
void* CopyCurrent(const FProperty* Property, void* Container, FTemporaries& Temporaries) {
    Temporaries.push_back(std::make_unique<FTemporaryValue>(Property));
    void* Copy = Temporaries.back()->Get();
    if (Property->HasGetter()) {
        Property->CallGetter(Container, Copy);
    } else {
        Property->CopyCompleteValue(Copy, Property->ContainerPtrToValuePtr<void>(Container));
    }
    return Copy;
}

/// Follows steps for reading.
TSpearResult<void*> GoSteps(
    const std::vector<FPathStep>& Steps, std::size_t First, std::size_t End, void* Address, FTemporaries& Temporaries) {
    for (std::size_t Index = First; Index < End; ++Index) {
        const FPathStep& Step = Steps[Index];
        if (Step.Kind == FPathStep::Field && Step.Property->HasGetter()) {
            Address = CopyCurrent(Step.Property, Address, Temporaries);
            continue;
        }
        TSpearResult<void*> Next = GoStep(Step, Address);
        if (!Next.IsOk()) {
            return Next;
        }
        Address = Next.GetValue();
    }
    return Address;
}

/// Values that are written only once they are known to be good.
bool IsWrittenAtOnce(EValueKind Kind) {
    switch (Kind) {
    case EValueKind::Struct:
    case EValueKind::Indirect:
    case EValueKind::StaticArray:
    case EValueKind::Array:
    case EValueKind::Set:
    case EValueKind::Map:
    case EValueKind::Optional:
    case EValueKind::Exported:
        return false;
    default:
        return true;
    }
}

class FPathWriter {
public:
    FPathWriter(
        FOperation& InOperation, const FPathLeg& InLeg, const std::string& InText, const spear::AnyView& InValue)
        : Operation(InOperation), Leg(InLeg), Text(InText), Value(InValue) {}

    FStatus Write(UObject* Object) {
        for (const FPathStep& Step : Leg.Steps) {
            if (Step.Kind == FPathStep::SetElement) {
                return MakeError(ErrorCode::ReadOnly, "elements of the set '" + ToUtf8(Step.Property->GetName()) +
                                                          "' cannot be written; write the whole set");
            }
        }
        // The outermost native setter decides: what lies within its property is changed in a copy, and the copy is set.
        void* Address = Object;
        for (std::size_t Index = 0; Index < Leg.Steps.size(); ++Index) {
            const FPathStep& Step = Leg.Steps[Index];
            if (Step.Kind == FPathStep::Field && Step.Property->HasSetter()) {
                FTemporaries Temporaries;
                void* Copy = CopyCurrent(Step.Property, Address, Temporaries);
                FStatus Written = WriteFrom(Index + 1, Copy);
                if (Written.IsOk()) {
                    Step.Property->CallSetter(Address, Copy);
                }
                return Written;
            }
            if (Index + 1 == Leg.Steps.size()) {
                return WriteFrom(Index, Address);
            }
            TSpearResult<void*> Next = GoStep(Step, Address);
            if (!Next.IsOk()) {
                return std::move(Next.GetError());
            }
            Address = Next.GetValue();
        }
        return {};
    }

private:
    /// Goes the steps from First on, and writes the value where they end.
    FStatus WriteFrom(std::size_t First, void* Address) {
        for (std::size_t Index = First; Index < Leg.Steps.size(); ++Index) {
            const FPathStep& Step = Leg.Steps[Index];
            if (Index + 1 == Leg.Steps.size() && Step.Kind == FPathStep::MapValue) {
                return WriteMapValue(CastFieldChecked<FMapProperty>(Step.Property), Step.Key, Address);
            }
            TSpearResult<void*> Next = GoStep(Step, Address);
            if (!Next.IsOk()) {
                return std::move(Next.GetError());
            }
            Address = Next.GetValue();
        }
        return WriteHere(Address);
    }

    FStatus WriteHere(void* Address) {
        if (IsWrittenAtOnce(Leg.Plan->Kind)) {
            return Read(Address);
        }
        const FTemporaryValue Copy(Leg.Last);
        const bool bWhole = !Leg.bStaticElement;
        bWhole ? Leg.Last->CopyCompleteValue(Copy.Get(), Address) : Leg.Last->CopySingleValue(Copy.Get(), Address);
        FStatus Status = Read(Copy.Get());
        if (Status.IsOk()) {
            bWhole ? Leg.Last->CopyCompleteValue(Address, Copy.Get()) : Leg.Last->CopySingleValue(Address, Copy.Get());
        }
        return Status;
    }

    /// The value of a key: changed, or added with the key.
    FStatus WriteMapValue(const FMapProperty* Property, const std::string& KeyText, void* Address) {
        const FTemporaryValue Key(Property->KeyProp);
        FStatus Status = ReadMapKey(Property->KeyProp, KeyText, Key.Get());
        if (!Status.IsOk()) {
            return Status;
        }
        const FTemporaryValue Copy(Property->ValueProp);
        FScriptMapHelper Helper(Property, Address);
        if (const void* Existing = Helper.FindValueFromHash(Key.Get())) {
            Property->ValueProp->CopyCompleteValue(Copy.Get(), Existing);
        }
        Status = Read(Copy.Get());
        if (Status.IsOk()) {
            Helper.AddPair(Key.Get(), Copy.Get());
        }
        return Status;
    }

    FStatus Read(void* Address) {
        FValueReader Reader(Operation, "property", Text);
        spear::Decoder In(Value.payload);
        if (!Reader.Read(*Leg.Plan, Address, In, Value.type)) {
            Reader.Error.argument = "value";
            return std::move(Reader.Error);
        }
        return {};
    }

    FOperation& Operation;
    const FPathLeg& Leg;
    const std::string& Text;
    const spear::AnyView& Value;
};

FStatus Named(FStatus Status, const UObject* Target, const std::string& Path) {
    if (!Status.IsOk() && Status.GetError().operation.empty()) {
        Status.GetError().operation = CppNameOf(Target->GetClass()) + "." + Path.substr(0, 512);
    }
    return Status;
}

} // namespace

TSpearResult<const FPropertyPaths::FPath*> FPropertyPaths::FindPath(FOperation& Operation, spear::TypeId Shape) {
    if (const auto At = Paths.find(Shape); At != Paths.end()) {
        return &At->second;
    }
    const spear::TypeInfo* Info = Operation.Session->ClientTypes.find(Shape);
    if (!Info || Info->kind != spear::TypeKind::path_shape) {
        return MakeError(
            ErrorCode::MalformedMessage, "the operation names a property path that was not announced as one", "path");
    }
    TSpearResult<std::vector<FPathSegment>> Segments = ParsePropertyPath(Info->name);
    if (!Segments.IsOk()) {
        return std::move(Segments.GetError());
    }
    FPath& Path = Paths[Shape];
    Path.Text = Info->name;
    Path.Segments = std::move(Segments.GetValue());
    return &Path;
}

TSpearResult<const FPathLeg*> FPropertyPaths::FindLeg(
    const FPath& Path, const UClass* Class, spear::TypeId Shape, std::size_t Segment) {
    std::unique_ptr<FPathLeg>& Leg = Legs[{Class, Shape, Segment}];
    if (Leg && Leg->Class.Get(true) == Class) {
        return Leg.get();
    }
    TSpearResult<std::unique_ptr<FPathLeg>> Built = BuildPathLeg(Path.Segments, Class, Segment);
    if (!Built.IsOk()) {
        Legs.erase({Class, Shape, Segment});
        return std::move(Built.GetError());
    }
    Leg = std::move(Built.GetValue());
    return Leg.get();
}

FStatus FPropertyPaths::FollowObjects(const FPath& Path, spear::TypeId Shape, UObject*& Object, const FPathLeg*& Leg) {
    std::size_t Segment = 0;
    for (;;) {
        TSpearResult<const FPathLeg*> Found = FindLeg(Path, Object->GetClass(), Shape, Segment);
        if (!Found.IsOk()) {
            return std::move(Found.GetError());
        }
        Leg = Found.GetValue();
        Segment = Leg->NextSegment;
        if (Segment == Path.Segments.size()) {
            return {};
        }
        FTemporaries Temporaries;
        TSpearResult<void*> Address = GoSteps(Leg->Steps, 0, Leg->Steps.size(), Object, Temporaries);
        if (!Address.IsOk()) {
            return std::move(Address.GetError());
        }
        UObject* Next = ObjectBehind(Leg->Last, Address.GetValue());
        const std::string Place = "'" + TextOfSegments(Path.Segments, Segment) + "'";
        if (!Next) {
            return MakeError(
                ErrorCode::NullObject, Place + " is null: it has no property '" + Path.Segments[Segment].Text + "'");
        }
        if (!IsUsable(Next)) {
            return MakeError(ErrorCode::StaleObject, Place + " is the " + CppNameOf(Next->GetClass()) + " '" +
                                                         ToUtf8(Next->GetName()) + "', which has been destroyed");
        }
        Object = Next;
    }
}

FStatus FPropertyPaths::Get(FOperation& Operation, UObject* Target, spear::TypeId Shape) {
    TSpearResult<const FPath*> Path = FindPath(Operation, Shape);
    if (!Path.IsOk()) {
        return std::move(Path.GetError());
    }
    UObject* Object = Target;
    const FPathLeg* Leg = nullptr;
    FStatus Followed = FollowObjects(*Path.GetValue(), Shape, Object, Leg);
    if (!Followed.IsOk()) {
        return Named(std::move(Followed), Target, Path.GetValue()->Text);
    }
    FTemporaries Temporaries;
    TSpearResult<void*> Address = GoSteps(Leg->Steps, 0, Leg->Steps.size(), Object, Temporaries);
    if (!Address.IsOk()) {
        return Named(std::move(Address.GetError()), Target, Path.GetValue()->Text);
    }
    return Named(
        WriteValue(*Operation.Session, *Leg->Plan, Address.GetValue(), *Operation.Out), Target, Path.GetValue()->Text);
}

FStatus FPropertyPaths::Set(FOperation& Operation, UObject* Target, spear::TypeId Shape, const spear::AnyView& Value) {
    TSpearResult<const FPath*> Path = FindPath(Operation, Shape);
    if (!Path.IsOk()) {
        return std::move(Path.GetError());
    }
    UObject* Object = Target;
    const FPathLeg* Leg = nullptr;
    FStatus Followed = FollowObjects(*Path.GetValue(), Shape, Object, Leg);
    if (!Followed.IsOk()) {
        return Named(std::move(Followed), Target, Path.GetValue()->Text);
    }
    return Named(
        FPathWriter(Operation, *Leg, Path.GetValue()->Text, Value).Write(Object), Target, Path.GetValue()->Text);
}

void FPropertyPaths::Sweep() {
    for (auto At = Legs.begin(); At != Legs.end();) {
        At = At->second && At->second->Class.Get(true) ? std::next(At) : Legs.erase(At);
    }
}

} // namespace SpearServer
