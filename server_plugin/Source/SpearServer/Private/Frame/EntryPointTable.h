// SPDX-License-Identifier: MIT
#pragma once

// Entry points and what runs for them. A service binds each of its entry points (spear/entry_points) to a lambda:
//
//     Bind(service::find_class, [](FOperation& Operation, std::string_view Name) -> TSpearResult<ObjectRef> { ... });
//
// Arguments are decoded, and the result is encoded, by the declaration's codecs; a lambda that does not fit the
// declaration does not compile. For entry points that return `any` the lambda returns FStatus and writes the value to
// Operation.Out itself.

#include "CoreMinimal.h"

#include "Frame/Result.h"

#include "spear/entry_points/all.hpp"

#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace SpearServer {

class FSession;

enum class EOutcome : uint8 {
    Done,    ///< the value is written
    Failed,  ///< see FOperation::Error
    Pending, ///< a latent function has begun; its result comes later under the operation's number
    Park     ///< cannot be answered yet: run the operation again in a later frame
};

/// One operation while it runs.
struct FOperation {
    FSession* Session = nullptr; ///< null on the server thread: only entry points that run there get along without one
    spear::Encoder* Out = nullptr; ///< where the result goes, as a value
    uint64 Number = 0;
    bool bInBlock = false; ///< within a begin_frame or end_frame block
    bool bWantsAnswer = false;
    bool bKeepResult = false;
    EOutcome Outcome = EOutcome::Done; ///< a lambda may set Pending or Park, and returns success then
    ErrorInfo Error;
    bool bDependencyFailed = false; ///< an argument was a future without result; Error says why

    spear::DecodeContext DecodeContext();
};

/// Decodes the arguments, runs the entry point, encodes the result.
using FHandler = EOutcome (*)(FOperation& Operation, spear::Decoder& Arguments);

/// The handler of an entry point of AllEntryPoints; null if nothing is bound.
FHandler GetHandler(uint16 EntryPoint);
void SetHandler(uint16 EntryPoint, FHandler Handler);
/// Facts of the declarations, by number.
bool RunsOnServerThread(uint16 EntryPoint);
spear::RunsOn RunsOnOf(uint16 EntryPoint);
std::string_view NameOf(uint16 EntryPoint);
/// The number of the entry point with that signature, or -1.
int32 FindSignature(std::string_view Signature);
/// The signature of the entry point of that name ("unreal_service.find_class"), or empty.
std::string SignatureOf(std::string_view Name);
/// The names of declared entry points that nothing is bound to; empty in a sound build, checked when the server starts.
std::string UnboundEntryPoints();

/// The number of unreal_service.call_function, the one hot entry point.
constexpr uint16 CallFunctionEntryPoint() {
    return static_cast<uint16>(
        spear::AllEntryPoints::index_of<std::remove_cvref_t<decltype(spear::unreal_service::call_function)>>());
}

/// "string", "list", "FVector": what a value is, for messages.
std::string DescribeType(const spear::TypeTables& Tables, spear::TypeId Type, int32 Depth = 0);

/// Fills Operation.Error from what a codec found wrong.
void SetDecodeError(FOperation& Operation, spear::CodecError Error, std::string_view Argument,
    std::string_view Expected, spear::TypeId Found);

namespace Detail {

template <typename E, typename F>
struct THandler;

template <typename E, typename F>
struct THandler {
    using FArguments = typename E::Arguments;
    using FResult = typename E::Result;
    static constexpr bool bWritesItself = std::is_same_v<FResult, spear::AnyView>;
    using FExpected = std::conditional_t<bWritesItself || std::is_void_v<FResult>, FStatus,
        TSpearResult<std::conditional_t<std::is_void_v<FResult>, int, FResult>>>;

    template <std::size_t I>
    static bool DecodeArgument(
        FOperation& Operation, spear::Decoder& In, const spear::DecodeContext& Context, FArguments& Arguments) {
        using FArgument = std::tuple_element_t<I, FArguments>;
        if constexpr (std::is_same_v<FArgument, spear::ArgumentsView>) {
            static_assert(I + 1 == std::tuple_size_v<FArguments>, "ArgumentsView takes the rest");
            std::get<I>(Arguments).values = In.get_raw(In.remaining());
            return true;
        } else {
            spear::Decoder Peek = In;
            const auto Found = Peek.get<spear::TypeId>();
            const spear::CodecError Error = spear::decode_value(In, Context, std::get<I>(Arguments));
            if (Error == spear::CodecError::none) {
                return true;
            }
            SetDecodeError(Operation, Error, E::parameters[I], spear::Codec<FArgument>::name, Found);
            return false;
        }
    }

    template <std::size_t... I>
    static EOutcome RunWith(FOperation& Operation, spear::Decoder& In, std::index_sequence<I...>) {
        [[maybe_unused]] const spear::DecodeContext Context = Operation.DecodeContext();
        FArguments Arguments;
        if (!(DecodeArgument<I>(Operation, In, Context, Arguments) && ...)) {
            return EOutcome::Failed;
        }
        if (In.remaining() != 0) {
            Operation.Error = MakeError(
                ErrorCode::MalformedMessage, "the operation carries more than the arguments of " + E::signature());
            return EOutcome::Failed;
        }
        FExpected Result = F{}(Operation, std::move(std::get<I>(Arguments))...);
        if (!Result.IsOk()) {
            Operation.Error = std::move(Result.GetError());
            return EOutcome::Failed;
        }
        if (Operation.Outcome == EOutcome::Done) {
            if constexpr (std::is_void_v<FResult>) {
                Operation.Out->put(spear::types::null);
            } else if constexpr (!bWritesItself) {
                spear::encode_value(*Operation.Out, Result.GetValue());
            }
        }
        return Operation.Outcome;
    }

    static EOutcome Run(FOperation& Operation, spear::Decoder& In) {
        return RunWith(Operation, In, std::make_index_sequence<std::tuple_size_v<FArguments>>());
    }
};

template <typename FExpected, typename F, typename FArguments>
inline constexpr bool TFits = false;
template <typename FExpected, typename F, typename... A>
inline constexpr bool TFits<FExpected, F, std::tuple<A...>> =
    std::is_same_v<std::invoke_result_t<F, FOperation&, A...>, FExpected>;

} // namespace Detail

/// Binds an entry point to a lambda without captures.
template <typename E, typename F>
void Bind(const E&, F) {
    using FHandlerOf = Detail::THandler<E, F>;
    static_assert(std::is_default_constructible_v<F>, "the lambda must not capture anything");
    static_assert(Detail::TFits<typename FHandlerOf::FExpected, F, typename E::Arguments>,
        "the lambda does not fit the entry point's declaration");
    SetHandler(spear::AllEntryPoints::index_of<E>(), &FHandlerOf::Run);
}

} // namespace SpearServer
