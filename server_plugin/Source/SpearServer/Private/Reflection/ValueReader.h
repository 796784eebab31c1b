// SPDX-License-Identifier: MIT
#pragma once

// Values of the wire into property memory, checked exactly: nothing is rounded, cut or guessed.
//
//   number       any number type if the value fits; floating-point numbers never become integers
//   bool         bool                              string, name, text   string
//   enum         announced enum, integer, or an entry's name (short or full)
//   object       object or null, of the property's class; classes also by name
//   soft object  path, object or null              interface            object that implements it, or null
//   struct       dict or announced struct by field names without case (the others keep their values), or a list of all
//   fields array, set   list, announced array or set; bytes for arrays of bytes map          dict, map, announced map
//   delegate             struct or dict {Object, FunctionName}, or null a future anywhere stands for its result

#include "CoreMinimal.h"

#include "Frame/EntryPointTable.h"
#include "Frame/Result.h"
#include "Reflection/TypePlan.h"

#include "spear/codec.hpp"

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace SpearServer {

/// How an announced struct of the wire maps to a struct of the engine. Cached per (wire type, plan).
struct FStructConversion {
    struct FField {
        const FTypePlan::FField* Target = nullptr;
        spear::TypeId Type = 0;
    };
    struct FCopy {
        int32 From = 0; ///< offset in the payload
        int32 To = 0;   ///< offset in memory
        int32 Size = 0;
    };
    FTypePlanRef Plan; ///< keeps the targets alive
    std::vector<FField> Fields;
    std::vector<FCopy> Copies; ///< if the same numbers stand on both sides: all there is to do
    int32 PayloadBytes = 0;
    bool bDirect = false;
    std::string UnknownField; ///< not empty: the wire type does not fit
};
/// How the numbers of an announced enum become the engine's: by the names of the entries, as the sender's may be of
/// another version.
struct FEnumConversion {
    struct FEntry {
        std::string Name;
        int64 From = 0;
        int64 To = 0;
        bool bKnown = false; ///< the engine has an entry of that name
    };
    std::vector<FEntry> Entries; ///< empty if all numbers mean the same on both sides
};
using FEnumConversions = std::unordered_map<uint64, FEnumConversion>;

using FStructConversions = std::unordered_map<uint64, std::unique_ptr<FStructConversion>>;

class FValueReader {
public:
    /// What is read, for messages: "argument" and "NewLocation", "property" and "Tags".
    /// The name must outlive the reader.
    FValueReader(FOperation& InOperation, const char* InWhat, std::string_view InName)
        : Operation(InOperation), What(InWhat), Name(InName) {}

    /// Reads type number and payload into initialised memory. False with Error set; the memory is then still a valid
    /// value.
    bool ReadValue(const FTypePlan& Plan, void* Address, spear::Decoder& In);
    bool Read(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);

    ErrorInfo Error;

private:
    bool ReadScalar(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadNumber(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadEnum(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    /// The engine's number for one of an announced enum.
    bool ConvertEnum(const FTypePlan& Plan, spear::TypeId Type, const spear::TypeInfo& Info, int64 From, int64& To);
    bool ReadObject(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadSoftObject(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadInterface(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadDelegate(const UFunction* Signature, FScriptDelegate& Out, spear::Decoder& In, spear::TypeId Type);
    bool ReadMulticast(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadStruct(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadStaticArray(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadArray(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadSet(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);
    bool ReadMap(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId Type);

    /// An object of the wire; the class is not checked yet. Strings fail unless `bClassNames`.
    bool ReadObjectReference(
        const FTypePlan& Plan, UObject*& Object, spear::Decoder& In, spear::TypeId Type, bool bClassNames);
    const FStructConversion& ConversionOf(const FTypePlan& Plan, spear::TypeId Type, const spear::TypeInfo& Info);
    /// The element type of a list, array or set (any for lists) and the count.
    bool ReadCount(
        const FTypePlan& Plan, spear::Decoder& In, spear::TypeId Type, spear::TypeId& ElementType, uint32& Count);
    bool ReadElement(const FTypePlan& Plan, void* Address, spear::Decoder& In, spear::TypeId ElementType, uint32 Index);
    bool TakeMemory(std::size_t Bytes);

    bool FailType(const FTypePlan& Plan, spear::TypeId Found);
    bool FailMalformed();
    bool Fail(ErrorCode Code, std::string Message, std::string Expected = {});
    std::string Place() const { return std::string(What) + " '" + std::string(Name) + Where + "'"; }

    FOperation& Operation;
    const char* What;
    std::string_view Name;
    std::string Where; ///< ".X", "[3]": the part of the value that is being read
    std::size_t Depth = 0;
    std::size_t TakenBytes = 0;
};

/// Memory for one value of a property, initialised and destroyed as the property wants it.
class FTemporaryValue {
public:
    explicit FTemporaryValue(const FProperty* InProperty);
    ~FTemporaryValue();
    FTemporaryValue(const FTemporaryValue&) = delete;
    FTemporaryValue& operator=(const FTemporaryValue&) = delete;
    void* Get() const { return Memory; }

private:
    const FProperty* Property;
    void* Memory;
};

/// The expected type in messages.
std::string ExpectedTypeOf(const FTypePlan& Plan);

} // namespace SpearServer
