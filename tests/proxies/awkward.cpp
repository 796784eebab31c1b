// SPDX-License-Identifier: MIT
// What proxies of awkward shapes (Awkward/Public/Awkward.h) look like. No engine knows these classes: all of this is
// the compiler's to check, but for what needs no engine.
#include "fixture.hpp"

#include <spear/unreal/Awkward/AAwkwardActor.hpp>
#include <spear/unreal/Awkward/AAwkwardChild.hpp>
#include <spear/unreal/Awkward/EAwkwardBits.hpp>
#include <spear/unreal/Awkward/EAwkwardEmpty.hpp>
#include <spear/unreal/Awkward/FAwkwardVector.hpp>
#include <spear/unreal/Awkward/FAwkwardWords.hpp>
#include <spear/unreal/Awkward/UAwkwardOrphan.hpp>

namespace {

namespace unreal = spear::unreal;
using namespace unreal;

template <typename T>
T any();
template <typename T, typename U>
constexpr bool same = std::is_same_v<T, U>;

// Names: the SDK's and C++'s get an underscore, on objects, futures and paths alike.
static_assert(same<decltype(any<AAwkwardActor>().get_(1)), std::int32_t>);
static_assert(same<decltype(any<AAwkwardActor>().async_(1)), void>);
static_assert(same<decltype(any<AAwkwardActor>().async().async_(1)), spear::Future<void>>);
static_assert(same<decltype(any<AAwkwardActor>().call_(true, true, true, false, 5)), void>);
static_assert(same<decltype(any<AAwkwardActor>().is_a_()), bool>);
static_assert(same<decltype(any<AAwkwardActor>().is_a("AActor")), bool>);
static_assert(same<decltype(any<AAwkwardActor>().SpearBase_().get()), std::int32_t>);
static_assert(same<decltype(any<AAwkwardActor>().is_null_().get()), std::int32_t>);
static_assert(same<decltype(any<AAwkwardActor>().FVector().get()), std::int32_t>);
static_assert(same<decltype(any<AAwkwardActor>().FVector_()), unreal::FVector>);
static_assert(same<decltype(any<FAwkwardWords>().get_), spear::Field<std::int32_t>>);
static_assert(same<decltype(any<AAwkwardActor>().Words()[0].set_().get()), std::int32_t>);
static_assert(same<decltype(any<spear::Future<AAwkwardActor>>().get_(1)), std::int32_t>);

// Structs: recursive, flattened, arrays, one that is another.
static_assert(same<decltype(any<FAwkwardNode>().Children), spear::Field<std::vector<FAwkwardNode>>>);
static_assert(same<decltype(any<FAwkwardNode>().ByName), spear::Field<std::map<std::string, FAwkwardNode>>>);
static_assert(
    same<decltype(any<FAwkwardWords>().There), spear::Field<std::vector<FAwkwardThere>>>); // its super struct's
static_assert(same<decltype(any<FAwkwardWords>().Nodes), spear::Field<std::array<FAwkwardNode, 2>>>);
static_assert(same<FAwkwardVector, unreal::FVector>);
static_assert(same<decltype(any<AAwkwardActor>().Nodes().get()), spear::KeyValues<AAwkwardActor, FAwkwardNode>>);
static_assert(same<decltype(any<AAwkwardActor>().Friends()[0].get()), AAwkwardActor>);
static_assert(same<decltype(any<AAwkwardActor>().Texts().get()), std::map<EAwkwardScoped, std::string>>);

// Enums.
static_assert(static_cast<int>(EAwkwardScoped::operator_) == -5);
static_assert(spear::enum_name(EAwkwardScoped::EOF_) == "EOF_");
static_assert(static_cast<std::int64_t>(EAwkwardFlags::High) == 0x4000000000000000);
static_assert((EAwkwardFlags::Low | EAwkwardFlags::High) != EAwkwardFlags::Low);
static_assert((~EAwkwardFlags::Low & EAwkwardFlags::Low) == EAwkwardFlags::NULL_);
static_assert(spear::EnumEntries<EAwkwardEmpty>::list.empty());
static_assert(!spear::FlagsEnum<EAwkwardBits>);

// What no schema knows.
static_assert(same<decltype(any<AAwkwardActor>().Unknown().get()), spear::Value>);
static_assert(same<decltype(any<AAwkwardActor>().UnknownObject().get()), spear::Object>);
static_assert(same<decltype(any<AAwkwardActor>().UnknownEnums().get()), std::vector<spear::Value>>);
static_assert(
    same<decltype(any<AAwkwardActor>().Strange(spear::Value(1), spear::Object(), "Entry", std::vector<spear::Value>{})),
        spear::Value>);
static_assert(std::derived_from<UAwkwardOrphan, spear::Object> && !std::derived_from<UAwkwardOrphan, UObject>);

// Interfaces: their functions, those above them, and where they are accepted.
static_assert(same<decltype(any<AAwkwardActor>().Above(1)), std::int32_t>);
static_assert(same<decltype(any<AAwkwardActor>().Below()), void>);
static_assert(
    spear::ObjectArgument<AAwkwardActor, IAwkwardDerived> && spear::ObjectArgument<AAwkwardChild, IAwkwardBase>);
static_assert(
    spear::ObjectArgument<IAwkwardDerived, IAwkwardBase> && !spear::ObjectArgument<unreal::AActor, IAwkwardBase>);
static_assert(sizeof(AAwkwardChild) == sizeof(spear::Object));

// Functions.
static_assert(same<decltype(any<AAwkwardActor>().Middle(1, 2)), std::int32_t>);
static_assert(same<decltype(any<AAwkwardActor>().Middle(spear::omit, 2)), std::int32_t>);
static_assert(same<decltype(any<AAwkwardChild>().Words(3)), void>);
static_assert(same<decltype(any<AAwkwardChild>().AAwkwardActor::Words().get()), std::vector<FAwkwardWords>>);
static_assert(same<decltype(any<AAwkwardActor_Outputs_Result>().ReturnValue), AAwkwardActor>);
static_assert(same<decltype(any<AAwkwardActor_Outputs_Result>().Node), FAwkwardNode>);
static_assert(same<decltype(any<AAwkwardActor_Outputs_Result>().Actors), std::vector<AAwkwardActor>>);
static_assert(same<decltype(any<AAwkwardActor_Outputs_Result>().Class), spear::SubclassOf<AAwkwardActor>>);
static_assert(same<decltype(any<AAwkwardActor>().Outputs({.Name = "x"})), AAwkwardActor_Outputs_Result>);
static_assert(same<decltype(any<AAwkwardActor>().ManyDefaults({}, nullptr)), void>);
static_assert(same<decltype(any<AAwkwardActor>().ManyDefaults(
                       {.Required = FAwkwardNode{}, .Actor = nullptr, .Flags = EAwkwardFlags::High})),
    void>);

} // namespace

TEST_CASE("recursive structs and structs in each other can be built, copied and compared") {
    FAwkwardNode root{.Name = "root", .Children = {FAwkwardNode{.Name = "leaf"}}};
    root.ByName = std::map<std::string, FAwkwardNode>{{"leaf", root.Children->front()}};
    const FAwkwardNode copy = root;
    CHECK(copy == root);
    root.Children->front().Name = "twig";
    CHECK_FALSE(copy == root);
    FAwkwardHere here;
    here.There.edit().emplace_back().Here.edit().emplace_back();
    CHECK(here.There->front().Here->size() == 1);
    CHECK_FALSE(here.There->front().Actor.is_given());
    here.There->front().Actor = AAwkwardActor();
    CHECK(here.There->front().Actor.get().is_null());
}

TEST_CASE("enums travel by name") {
    spear::LocalTypes types;
    spear::Encoder out;
    spear::encode_typed(out, std::vector{EAwkwardScoped::operator_, static_cast<EAwkwardScoped>(77)}, types);
    spear::encode_typed(out, EAwkwardFlags::Low | EAwkwardFlags::High, types);
    spear::Decoder in(out.buffer);
    const spear::DecodeContext context{.tables = {&types.table(), nullptr}};
    std::vector<spear::Value> entries;
    CHECK(spear::decode_value(in, context, entries) == spear::CodecError::none);
    CHECK(entries.at(0).as<std::string>() == "operator_");
    CHECK(entries.at(1).as<std::int64_t>() == 77);
    EAwkwardFlags flags{};
    CHECK(spear::decode_value(in, context, flags) == spear::CodecError::none);
    CHECK(flags == (EAwkwardFlags::Low | EAwkwardFlags::High));

    // An engine that numbers them in another way.
    spear::LocalTypes engine;
    const spear::TypeId type = engine.number_of({.kind = spear::TypeKind::enumeration,
        .name = "EAwkwardScoped",
        .entries = {{"Default", -5}, {"operator_", 3}, {"Newer", 4}}});
    const auto decoded = [&](std::int64_t number) {
        spear::Encoder sent;
        sent.put(type);
        sent.put(number);
        spear::Decoder from(sent.buffer);
        EAwkwardScoped value{};
        CHECK(spear::decode_value(from, {.tables = {&engine.table(), nullptr}}, value) == spear::CodecError::none);
        return value;
    };
    CHECK(decoded(3) == EAwkwardScoped::operator_);
    CHECK(decoded(-5) == EAwkwardScoped::Default);
    CHECK(static_cast<int>(decoded(4)) == 4); // an entry that this program does not know
}

TEST_CASE("generated structs are written as the members given, and read back") {
    spear::LocalTypes types;
    spear::Encoder out;
    const FAwkwardNode node{.Name = "root", .Children = {FAwkwardNode{.Name = "leaf"}, FAwkwardNode{}}};
    spear::encode_typed(out, node, types);
    spear::Decoder in(out.buffer);
    FAwkwardNode read;
    const spear::DecodeContext context{.tables = {&types.table(), nullptr}};
    CHECK(spear::decode_value(in, context, read) == spear::CodecError::none);
    CHECK(read == node);
    CHECK_FALSE(read.ByName.is_given());
    CHECK(spear::Value(spear::Value::decode(spear::AnyView{spear::types::dict, std::span(out.buffer).subspan(4)},
                           {{&types.table(), nullptr}, nullptr}))
              .as<FAwkwardNode>() == node);
}
