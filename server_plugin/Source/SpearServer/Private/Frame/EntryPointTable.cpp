// SPDX-License-Identifier: MIT
#include "Frame/EntryPointTable.h"

#include "Frame/Session.h"

#include <array>

namespace SpearServer {

namespace {

struct FRow {
    std::string_view Name;
    std::string Signature;
    spear::RunsOn RunsOn = spear::RunsOn::game_thread;
    FHandler Handler = nullptr;
};

using FRows = std::array<FRow, spear::AllEntryPoints::size>;

FRows& GetRows() {
    static FRows Rows = [] {
        FRows New;
        std::size_t Index = 0;
        spear::AllEntryPoints::for_each([&](auto EntryPoint) {
            using E = decltype(EntryPoint);
            New[Index++] = {E::name, E::signature(), E::runs_on, nullptr};
        });
        return New;
    }();
    return Rows;
}

bool ResolveFuture(void* User, std::uint64_t Number, std::span<const std::byte>& Value) {
    FOperation& Operation = *static_cast<FOperation*>(User);
    TSpearResult<std::span<const std::byte>> Result = Operation.Session->Kept.Resolve(Number);
    if (!Result.IsOk()) {
        Operation.Error = std::move(Result.GetError());
        Operation.bDependencyFailed = true;
        return false;
    }
    Value = Result.GetValue();
    return true;
}

} // namespace

FHandler GetHandler(uint16 EntryPoint) { return GetRows()[EntryPoint].Handler; }
void SetHandler(uint16 EntryPoint, FHandler Handler) { GetRows()[EntryPoint].Handler = Handler; }
bool RunsOnServerThread(uint16 EntryPoint) { return GetRows()[EntryPoint].RunsOn == spear::RunsOn::server_thread; }
spear::RunsOn RunsOnOf(uint16 EntryPoint) { return GetRows()[EntryPoint].RunsOn; }
std::string_view NameOf(uint16 EntryPoint) { return GetRows()[EntryPoint].Name; }

int32 FindSignature(std::string_view Signature) {
    for (std::size_t Index = 0; Index < GetRows().size(); ++Index) {
        if (GetRows()[Index].Signature == Signature) {
            return static_cast<int32>(Index);
        }
    }
    return -1;
}

std::string SignatureOf(std::string_view Name) {
    for (const FRow& Row : GetRows()) {
        if (Row.Name == Name) {
            return Row.Signature;
        }
    }
    return {};
}

std::string UnboundEntryPoints() {
    std::string Names;
    for (const FRow& Row : GetRows()) {
        if (!Row.Handler) {
            Names += (Names.empty() ? "" : ", ") + std::string(Row.Name);
        }
    }
    return Names;
}

spear::DecodeContext FOperation::DecodeContext() {
    spear::DecodeContext Context;
    if (Session) {
        Context.tables = Session->Tables();
        Context.resolve_future = &ResolveFuture;
        Context.user = this;
    }
    return Context;
}

std::string DescribeType(const spear::TypeTables& Tables, spear::TypeId Type, int32 Depth) {
    static constexpr std::string_view Names[] = {"null", "bool", "int8", "int16", "int32", "int64", "uint8", "uint16",
        "uint32", "uint64", "float", "double", "string", "bytes", "object", "any", "future", "list", "dict", "map",
        "object"};
    if (Type <= spear::types::last_builtin) {
        return std::string(Names[Type]);
    }
    const spear::TypeInfo* Info = Tables.find(Type);
    if (!Info) {
        return "a type that was never announced";
    }
    if (Depth > 4) {
        return "..."; // announced types may be nested as deeply as a client likes
    }
    switch (Info->kind) {
    case spear::TypeKind::array:
        return "array of " + DescribeType(Tables, Info->element, Depth + 1);
    case spear::TypeKind::set:
        return "set of " + DescribeType(Tables, Info->element, Depth + 1);
    case spear::TypeKind::map:
        return "map from " + DescribeType(Tables, Info->key, Depth + 1) + " to " +
               DescribeType(Tables, Info->element, Depth + 1);
    default:
        return Info->name;
    }
}

void SetDecodeError(FOperation& Operation, spear::CodecError Error, std::string_view Argument,
    std::string_view Expected, spear::TypeId Found) {
    const std::string Name(Argument);
    const std::string Wanted(Expected);
    switch (Error) {
    case spear::CodecError::unresolved_future:
        if (!Operation.bDependencyFailed) {
            Operation.Error =
                MakeError(ErrorCode::WrongType, "argument '" + Name + "' must not be a future here", Name, Wanted);
        } else if (Operation.Error.argument.empty()) {
            Operation.Error.argument = Name;
        }
        break;
    case spear::CodecError::out_of_range:
        Operation.Error =
            MakeError(ErrorCode::OutOfRange, "argument '" + Name + "' is outside the range of " + Wanted, Name, Wanted);
        break;
    case spear::CodecError::malformed:
        Operation.Error = MakeError(ErrorCode::MalformedMessage, "argument '" + Name + "' is malformed", Name, Wanted);
        break;
    default:
        Operation.Error = MakeError(ErrorCode::WrongType,
            "argument '" + Name + "' must be " + Wanted + ", not " +
                DescribeType(Operation.Session ? Operation.Session->Tables() : spear::TypeTables(), Found),
            Name, Wanted);
        break;
    }
}

} // namespace SpearServer
