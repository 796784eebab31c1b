// SPDX-License-Identifier: MIT
// Value, Codec and wire types: every kind of value survives the way there and back, and C++ types convert both ways.
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "spear/object.hpp"
#include "spear/unreal_types.hpp"
#include "spear/value.hpp"

using namespace spear;
using unreal::FTransform;
using unreal::FVector;

namespace {

Value there_and_back(const Value& value) {
    LocalTypes types;
    Encoder out;
    value.encode(out, types);
    Decoder in(out.bytes());
    Value result = Value::decode(in, {{&types.table(), nullptr}, nullptr});
    CHECK(in.remaining() == 0);
    Decoder skipped(out.bytes());
    skip_payload(skipped, skipped.get<TypeId>(), {&types.table(), nullptr});
    CHECK(skipped.ok());
    CHECK(skipped.remaining() == 0);
    return result;
}

template <typename T>
T through_codec(const T& value) {
    Encoder out;
    encode_value(out, value);
    Decoder in(out.bytes());
    T result{};
    CHECK(decode_value(in, DecodeContext{}, result) == CodecError::none);
    CHECK(in.remaining() == 0);
    return result;
}

template <typename T>
T through_announced_types(const T& value) {
    LocalTypes types;
    Encoder out;
    encode_typed(out, value, types);
    Decoder in(out.bytes());
    T result{};
    CHECK(decode_value(in, DecodeContext{{&types.table(), nullptr}, nullptr, nullptr}, result) == CodecError::none);
    CHECK(in.remaining() == 0);
    return result;
}

enum class Channel : std::uint8_t { visibility = 2, camera = 3 };

/// A user's own struct for an Unreal struct that the SDK does not know.
struct HitResult {
    bool bBlockingHit = false;
    float Distance = 0;
    FVector Location;
    std::string BoneName;
    std::vector<std::int32_t> Faces;
    std::optional<double> Time;
    Channel TraceChannel = Channel::visibility;
    friend bool operator==(const HitResult&, const HitResult&) = default;
};

} // namespace

template <>
struct spear::Members<HitResult> {
    static constexpr std::string_view name = "FHitResult";
    static constexpr auto list = std::tuple{Member{"bBlockingHit", &HitResult::bBlockingHit},
        Member{"Distance", &HitResult::Distance}, Member{"Location", &HitResult::Location},
        Member{"BoneName", &HitResult::BoneName}, Member{"Faces", &HitResult::Faces}, Member{"Time", &HitResult::Time},
        Member{"TraceChannel", &HitResult::TraceChannel}};
};

TEST_CASE("every kind of value comes back as it went") {
    const std::vector<float> floats{1.5f, -2, 0};
    const Value values[] = {nullptr, true, false, -5, std::numeric_limits<std::int64_t>::min(),
        std::numeric_limits<std::uint64_t>::max(), 1.25, "text", "", "ümläut \0 zero",
        Value::Bytes{std::byte{1}, std::byte{2}}, StructValue{"FVector", {{"X", 1.0}, {"Y", 2.0}, {"Z", 3.0}}},
        StructValue{"FMixed",
            {{"List", Value::List{1, "a"}}, {"Inner", StructValue{"FVector", {{"X", 1.0}}}}, {"Null", nullptr}}},
        StructValue{"FEmpty", {}}, Value::List{}, Value::List{1, "two", 3.0, Value::List{nullptr}},
        Value::Dict{{"b", 1}, {"a", 2}}, Value::Map{{1, "one"}, {"two", 2}},
        NumericArray(types::f32, std::as_bytes(std::span(floats))), ObjectHandle(nullptr, {0x1'0000'0002, 0})};
    for (const Value& value : values) {
        CAPTURE(to_string(value));
        if (value.type_name() == "FEmpty") {
            CHECK(there_and_back(value).size() == 0); // no type of no bytes is announced: an empty dict
        } else {
            CHECK(there_and_back(value) == value);
        }
    }
}

TEST_CASE("announced enums, sets and maps of the other side") {
    TypeTable server(types::first_server_type);
    TypeInfo channel{TypeKind::enumeration, "ECollisionChannel", "/Script/Engine.ECollisionChannel", 0, 0, {},
        {{"WorldStatic", 0}, {"Camera", 3}}};
    const TypeId channel_type = server.add(channel);
    TypeInfo map_info;
    map_info.kind = TypeKind::map;
    map_info.key = channel_type;
    map_info.element = types::string;
    const TypeId map_type = server.add(map_info);
    const ValueContext context{{nullptr, &server}, nullptr};

    Encoder out;
    out.put(map_type);
    out.put(std::uint32_t{2});
    out.put(std::int64_t{3});
    out.put_text("c");
    out.put(std::int64_t{9});
    out.put_text("?");
    Decoder in(out.bytes());
    const Value value = Value::decode(in, context);
    const auto& entries = *value.get_if<Value::Map>();
    CHECK(*entries[0].first.get_if<EnumValue>() == EnumValue{"ECollisionChannel", "Camera", 3});
    CHECK(entries[0].first.as<Channel>() == Channel::camera);
    CHECK(entries[0].first.as<int>() == 3);
    CHECK(entries[0].first.as<std::string>() == "Camera");
    CHECK(to_string(value) == R"({ECollisionChannel::Camera: "c", ECollisionChannel::9: "?"})");

    Decoder again(out.bytes());
    std::map<std::string, std::string> no_strings;
    CHECK(decode_value(again, DecodeContext{context.tables, nullptr, nullptr}, no_strings) == CodecError::wrong_type);
}

TEST_CASE("numbers of different kinds are equal if they are the same number") {
    CHECK(Value(1) == Value(1u));
    CHECK(Value(1) == Value(1.0));
    CHECK_FALSE(Value(-1) == Value(std::numeric_limits<std::uint64_t>::max()));
    CHECK_FALSE(Value(1) == Value(true));
    CHECK_FALSE(Value(1) == Value("1"));
    CHECK(Value(NumericArray(types::u8, std::as_bytes(std::span<const char>("\1\2", 2)))) == Value(Value::List{1, 2}));
    CHECK(Value(nullptr) == Value(ObjectHandle()));
}

TEST_CASE("parts") {
    const Value vector = Value::from(FVector{1, 2, 3});
    CHECK(vector.type_name() == "FVector");
    CHECK(vector.size() == 3);
    CHECK(vector["Y"].as<double>() == 2);
    try {
        vector["W"];
        FAIL("no error");
    } catch (const UnknownProperty& error) {
        CHECK(std::string(error.what()) == "FVector has no \"W\"; it has: X, Y, Z.");
    }
    const Value list = Value::List{1, 2};
    CHECK(list[1] == Value(2));
    CHECK_THROWS_AS(list[2], OutOfRange);
    CHECK_THROWS_AS(list[-1], OutOfRange);
    CHECK_THROWS_AS(list["x"], WrongType);
    CHECK_THROWS_AS(vector[0], WrongType);
    CHECK(Value(Value::Map{{"k", 5}})["k"] == Value(5));
}

TEST_CASE("conversions") {
    CHECK(Value(3).as<float>() == 3);
    CHECK(Value(3u).as<std::int8_t>() == 3);
    CHECK_THROWS_AS(Value(300).as<std::uint8_t>(), OutOfRange);
    CHECK_THROWS_AS(Value(-1).as<unsigned>(), OutOfRange);
    CHECK_THROWS_AS(Value(1.0).as<int>(), WrongType);
    CHECK_THROWS_AS(Value("1").as<int>(), WrongType);
    CHECK_THROWS_AS(Value(1).as<bool>(), WrongType);
    CHECK(Value("text").as<std::string>() == "text");
    CHECK(Value(nullptr).as<std::optional<int>>() == std::nullopt);
    CHECK(Value(Value::List{1, 2}).as<std::vector<double>>() == std::vector<double>{1, 2});
    CHECK(Value(Value::Dict{{"X", 1}, {"Z", 3.5}}).as<FVector>() == FVector{1, 0, 3.5});
    CHECK(Value(Value::List{1, 2, 3}).as<FVector>() == FVector{1, 2, 3});
    CHECK_THROWS_AS(Value(Value::Dict{{"Pitch", 1}}).as<FVector>(), WrongType);
    CHECK(Value(Value::Dict{{"a", 1}}).as<std::map<std::string, int>>() == std::map<std::string, int>{{"a", 1}});
    const std::vector<double> doubles{1, 2, 3};
    const Value array = Value::from(doubles);
    CHECK(array.type_name() == "array<double>");
    CHECK(array.get_if<NumericArray>()->view<double>()[2] == 3);
    CHECK_THROWS_AS(array.get_if<NumericArray>()->view<float>(), WrongType);
    CHECK(array.as<std::vector<float>>() == std::vector<float>{1, 2, 3});
    CHECK(Value(ObjectHandle(nullptr, {7, 0})).as<Object>().ref().handle == 7);
    CHECK(Value(nullptr).as<Object>().is_null());
    try {
        Value(Value::Dict{{"Pitch", 1}}).as<FVector>();
        FAIL("no error");
    } catch (const WrongType& error) {
        CHECK(error.info().expected == "FVector");
        CHECK(std::string(error.what()).find("{\"Pitch\": 1}") != std::string::npos);
    }
}

TEST_CASE("C++ structs go both ways, as dicts and as announced types") {
    const HitResult hit{true, 1.5f, {1, 2, 3}, "head", {4, 5}, 0.25, Channel::camera};
    CHECK(through_codec(hit) == hit);
    CHECK(through_announced_types(hit) == hit);
    CHECK(Value::from(hit).as<HitResult>() == hit);
    CHECK(Value::from(hit).type_name() == "FHitResult");
    const FTransform transform{{0, 0, 1, 0}, {1, 2, 3}, {4, 5, 6}};
    CHECK(through_codec(transform) == transform);
    CHECK(through_announced_types(transform) == transform);
    CHECK(through_announced_types(std::vector<FVector>{{1, 2, 3}, {4, 5, 6}}) ==
          std::vector<FVector>{{1, 2, 3}, {4, 5, 6}});
    CHECK(through_announced_types(std::vector<bool>{true, false}) == std::vector<bool>{true, false});
    CHECK(through_announced_types(std::map<std::string, FVector>{{"a", {1, 2, 3}}}) ==
          std::map<std::string, FVector>{{"a", {1, 2, 3}}});
    CHECK(through_announced_types(std::optional<FVector>()) == std::nullopt);
}

TEST_CASE("announced structs are read if they have all members, and more only under the same name") {
    const Value vector = Value::from(FVector{1, 2, 3});
    CHECK_THROWS_AS(vector.as<unreal::FVector2D>(), WrongType);
    CHECK_THROWS_AS(vector.as<unreal::FRotator>(), WrongType);
    CHECK_THROWS_AS(vector.as<unreal::FQuat>(), WrongType);
    const Value larger = StructValue{"FVector2D", {{"X", 1.0}, {"Extra", Value::List{1}}, {"Y", 2.0}}};
    CHECK(larger.as<unreal::FVector2D>() == unreal::FVector2D{1, 2});
    CHECK(Value(StructValue{"FOther", {{"Y", 2.0}, {"X", 1.0}}}).as<unreal::FVector2D>() == unreal::FVector2D{1, 2});
}

TEST_CASE("an FVector travels as 24 bytes behind its type number") {
    LocalTypes types;
    Encoder out;
    encode_typed(out, FVector{1, 2, 3}, types);
    CHECK(out.buffer.size() == 4 + 24);
    const std::size_t pending = types.announcer().take_pending().size();
    CHECK(pending > 0);
    encode_typed(out, FVector{4, 5, 6}, types);
    CHECK(out.buffer.size() == 2 * (4 + 24));
    CHECK_FALSE(types.announcer().has_pending());
}

TEST_CASE("printing") {
    CHECK(to_string(Value::from(FVector{1, 2.5, -3})) == "FVector(X=1, Y=2.5, Z=-3)");
    CHECK(to_string(Value(Value::List{1, "a\"b", nullptr, true})) == R"([1, "a\"b", null, true])");
    CHECK(fmt::format("{}", Value(Value::Dict{{"k", 1.5}})) == R"({"k": 1.5})");
    CHECK(fmt::format("{:>6}", Value(12)) == "    12");
    std::ostringstream stream;
    stream << Value(EnumValue{"EAxis", "X", 1});
    CHECK(stream.str() == "EAxis::X");
}
