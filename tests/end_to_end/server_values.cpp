// SPDX-License-Identifier: MIT
// Every kind of property, through a real socket: as an argument, a return value, an out-parameter, read and written.
// (Types: RoundTrip/.)
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine_fixture.hpp"

using namespace end_to_end;
using spear::EnumValue;
using spear::Object;
using spear::StructValue;
using spear::Value;

namespace {

/// What goes there and comes back.
struct Case {
    std::string kind;
    std::vector<Value> values;
};

Value vector_value(double x, double y, double z) { return StructValue{"FVector", {{"X", x}, {"Y", y}, {"Z", z}}}; }

Value transform_value() {
    return StructValue{
        "FTransform", {{"Rotation", StructValue{"FQuat", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.6}, {"W", 0.8}}}},
                          {"Translation", vector_value(1.5, -2.5, 1e9)}, {"Scale3D", vector_value(1, 2, 3)}}};
}

Value record_value(int count) {
    return StructValue{
        "FRoundTripRecord", {{"Count", count}, {"bOn", false}, {"Title", "Grüße, 世界 🦀"},
                                {"Place", vector_value(1, 2, 3)}, {"Samples", Value::List{0.5, -1e300}},
                                {"Scores", Value::Map{{Value("alpha"), Value(1)}, {Value("beta"), Value(-2)}}}}};
}

template <typename T>
std::vector<Value> extremes() {
    return {Value(std::numeric_limits<T>::min()), Value(T{0}), Value(T{1}), Value(std::numeric_limits<T>::max())};
}

std::vector<Case> plain_cases() {
    return {
        {"Bool", {true, false}},
        {"Int8", extremes<std::int8_t>()},
        {"Int16", extremes<std::int16_t>()},
        {"Int32", extremes<std::int32_t>()},
        {"Int64", extremes<std::int64_t>()},
        {"UInt8", extremes<std::uint8_t>()},
        {"UInt16", extremes<std::uint16_t>()},
        {"UInt32", extremes<std::uint32_t>()},
        {"UInt64", extremes<std::uint64_t>()},
        {"Float",
            {0.0, -1.5, static_cast<double>(3.25e37f), static_cast<double>(std::numeric_limits<float>::denorm_min())}},
        {"Double", {0.0, -0.1, 1e308, std::numeric_limits<double>::infinity()}},
        {"String", {"", "plain", "Grüße, 世界 🦀", "line\nbreak\ttab \"quote\"", std::string(100'000, 'x')}},
        {"Name", {"None", "Something_12", "Ünï", "Caße_0"}},
        {"Text", {"", "A text, with comma"}},
        {"Enum", {EnumValue{"ERoundTripMode", "Fast", 1}, EnumValue{"ERoundTripMode", "Reckless", 7}}},
        {"ByteEnum", {EnumValue{"ERoundTripLegacy", "RTL_Second", 1}}},
        {"SoftObject", {"/Game/Nothing/There.There", ""}},
        {"SoftClass", {"/Script/Engine.StaticMeshActor"}},
        {"Vector", {vector_value(1, -2.5, 1e10)}},
        {"Transform", {transform_value()}},
        {"Color", {StructValue{"FColor", {{"B", 1}, {"G", 2}, {"R", 3}, {"A", 255}}}}},
        {"Record", {record_value(7)}},
        {"IntArray", {Value::List{}, Value::List{1, -2, 2147483647}}},
        {"ByteArray", {Value(Value::List{0, 255, 7})}},
        {"BoolArray", {Value(Value::List{true, false, true})}},
        {"StringArray", {Value(Value::List{"a", "", "ü"})}},
        {"VectorArray", {Value(Value::List{vector_value(1, 2, 3), vector_value(4, 5, 6)})}},
        {"RecordArray", {Value(Value::List{record_value(1), record_value(2)})}},
        {"NameSet", {Value(Value::List{"one", "two"})}},
        {"IntSet", {Value::List{}, Value::List{5, -3}}},
        {"StringMap", {Value::Map{}, Value::Map{{Value("key"), Value(1)}, {Value("other key"), Value(2)}}}},
        {"VectorMap", {Value::Map{{Value("up"), vector_value(0, 0, 1)}}}},
        {"EnumMap", {Value::Map{{Value(EnumValue{"ERoundTripMode", "Slow", 0}), Value("slow")}}}},
        {"Optional", {nullptr, 5}},
    };
}

/// All four ways of one value.
void check_round_trip(const Object& object, const std::string& kind, const Value& value) {
    CAPTURE(kind);
    CAPTURE(spear::to_string(value).substr(0, 200));
    CHECK(object.call("Echo" + kind, arg("Value", value)) == value);
    CHECK(object.call("Copy" + kind, value)["Result"] == value); // the parameter's position, and the result's name
    object.property(kind + "Value").set(value);
    CHECK(object.property(kind + "Value").get() == value);
}

} // namespace

TEST_CASE("every kind of value: argument, return value, out-parameter, get and set") {
    Client client;
    client.transact([&] {
        const Object object = client.game.new_object("URoundTrip");
        for (const Case& one : plain_cases()) {
            for (const Value& value : one.values) {
                check_round_trip(object, one.kind, value);
            }
        }
    });
}

TEST_CASE("references to objects: strong, weak, lazy, class, interface, arrays of them") {
    Client client;
    client.transact([&] {
        const Object object = client.game.new_object("URoundTrip");
        const Object actor = client.spawn();
        const Object listener = client.game.new_object("URoundTrip");
        const Object actor_class = client.game.get_class("ACameraActor");
        check_round_trip(object, "Object", Value(static_cast<const spear::ObjectHandle&>(listener)));
        for (const char* kind : {"Actor", "Weak", "Lazy"}) {
            check_round_trip(object, kind, Value(static_cast<const spear::ObjectHandle&>(actor)));
        }
        check_round_trip(object, "Class", Value(static_cast<const spear::ObjectHandle&>(actor_class)));
        check_round_trip(object, "Interface", Value(static_cast<const spear::ObjectHandle&>(listener)));
        check_round_trip(object, "ObjectArray",
            Value(Value::List{Value(static_cast<const spear::ObjectHandle&>(actor)), Value(nullptr)}));
        for (const char* kind : {"Object", "Actor", "Weak", "Lazy", "Class", "Interface"}) {
            CAPTURE(kind);
            CHECK(object.call("Echo" + std::string(kind), Value(nullptr)).as<Object>().is_null());
        }
        CHECK(object.call<Object>("EchoClass", "StaticMeshActor").path_name() ==
              "/Script/Engine.StaticMeshActor"); // classes also by name

        error_text<spear::WrongType>([&] { object.call("EchoActor", listener); });
        error_text<spear::WrongType>([&] { object.call("EchoClass", client.game.get_class("URoundTrip")); });
        error_text<spear::WrongType>([&] { object.call("EchoInterface", actor); });
        const std::string text = error_text<spear::WrongType>([&] { object["ActorValue"].set(listener); });
        CHECK(contains(text, "AActor"));
        CHECK(object["ActorValue"].get<Object>() == actor); // the failed write has written nothing
    });
}

TEST_CASE("delegates: bound, read back, called, unbound") {
    Client client;
    client.transact([&] {
        const Object object = client.game.new_object("URoundTrip");
        const Object listener = client.game.new_object("URoundTrip");
        const Value bound(Value::Dict{
            {"Object", Value(static_cast<const spear::ObjectHandle&>(listener))}, {"FunctionName", Value("OnEvent")}});

        object["DelegateValue"].set(bound);
        CHECK(object["DelegateValue"].get()["FunctionName"] == Value("OnEvent"));
        CHECK(object.call("EchoDelegate", bound)["Object"].as<Object>() == listener);
        object.call("FireDelegate", 11);
        CHECK(listener["LastHeard"].get<int>() == 11);

        object["MulticastValue"].set(Value(Value::List{bound}));
        CHECK(object["MulticastValue"].get().size() == 1);
        object.call("FireMulticast", 12);
        CHECK(listener["LastHeard"].get<int>() == 12);
        object["MulticastValue"].set(nullptr);
        CHECK(object["MulticastValue"].get().size() == 0);
        object.call("FireMulticast", 13);
        CHECK(listener["LastHeard"].get<int>() == 12);

        object["InterfaceValue"].set(listener);
        object.call("CallListener", 14);
        CHECK(listener["LastHeard"].get<int>() == 14);

        error_text<spear::WrongType>([&] { // a function with other parameters
            object["DelegateValue"].set(
                Value(Value::Dict{{"Object", Value(static_cast<const spear::ObjectHandle&>(listener))},
                    {"FunctionName", Value("OnOther")}}));
        });
        error_text<spear::UnknownFunction>([&] {
            object["DelegateValue"].set(
                Value(Value::Dict{{"Object", Value(static_cast<const spear::ObjectHandle&>(listener))},
                    {"FunctionName", Value("OnEvnt")}}));
        });
    });
}

TEST_CASE("bit-fields, C arrays, empty structs") {
    Client client;
    client.transact([&] {
        const Object object = client.game.new_object("URoundTrip");
        object["bBitTwo"].set(true);
        CHECK_FALSE(object["bBitOne"].get<bool>());
        CHECK(object["bBitTwo"].get<bool>());
        object["bBitOne"].set(true);
        object["bBitTwo"].set(false);
        CHECK(object["bBitOne"].get<bool>());
        CHECK_FALSE(object["bBitTwo"].get<bool>());

        CHECK(object["FixedValue"].get<std::vector<int>>() == std::vector<int>{1, 2, 3, 4});
        object["FixedValue"][2].set(33);
        CHECK(object["FixedValue"].get<std::vector<int>>() == std::vector<int>{1, 2, 33, 4});
        object["FixedValue"].set(std::vector<int>{9, 8, 7, 6});
        CHECK(object["FixedValue"][3].get<int>() == 6);
        error_text<spear::OutOfRange>([&] { object["FixedValue"].set(std::vector<int>{1, 2, 3}); });
        error_text<spear::OutOfRange>([&] { object["FixedValue"][4].get(); });

        CHECK(object.call("EchoEmpty", Value(Value::Dict{})).size() == 0);
        object["EmptyValue"].set(Value(Value::Dict{}));
        CHECK(object.call("CopyEmpty", Value(Value::Dict{})).size() == 1);
    });
}

TEST_CASE("structs from dictionaries, lists and parts; names without case") {
    Client client;
    client.transact([&] {
        const Object object = client.game.new_object("URoundTrip");
        CHECK(object.call<FVector>("EchoVector", Value(Value::Dict{{"y", 2}, {"Z", 3.5}})) == FVector{0, 2, 3.5});
        CHECK(object.call<FVector>("EchoVector", Value(Value::List{1, 2, 3})) == FVector{1, 2, 3});
        CHECK(object.call<FVector>("EchoVector", FVector{4, 5, 6}) == FVector{4, 5, 6});
        CHECK(
            object.call("EchoRecord", Value(Value::Dict{}))["Title"] == Value("untitled")); // the struct's own defaults
        object["VectorValue"].set(FVector{1, 2, 3});
        object["VectorValue"].set(Value(Value::Dict{{"Y", 20}})); // the others keep their values
        CHECK(object["VectorValue"].get<FVector>() == FVector{1, 20, 3});
        object["RecordValue"]["Place"]["Z"].set(-1);
        CHECK(object["RecordValue"]["Place"].get<FVector>() == FVector{0, 0, -1});

        CHECK(contains(
            error_text<spear::WrongType>([&] { object.call("EchoRecord", Value(Value::Dict{{"Titel", "x"}})); }),
            "Title"));
        CHECK(contains(error_text<spear::WrongType>([&] {
            object.call("EchoRecord", Value(Value::Dict{{"Place", Value(Value::Dict{{"X", "one"}})}}));
        }),
            "Place.X"));
        error_text<spear::WrongType>([&] { object.call("EchoVector", Value(Value::List{1, 2})); });
        error_text<spear::WrongType>([&] { object.call("EchoVector", 3.0); });
    });
}

TEST_CASE("numbers fit or raise; nothing is rounded or cut") {
    Client client;
    client.transact([&] {
        const Object object = client.game.new_object("URoundTrip");
        error_text<spear::OutOfRange>([&] { object.call("EchoInt8", 128); });
        error_text<spear::OutOfRange>([&] { object.call("EchoUInt8", -1); });
        error_text<spear::OutOfRange>([&] { object.call("EchoInt64", std::numeric_limits<std::uint64_t>::max()); });
        error_text<spear::WrongType>([&] { object.call("EchoInt32", 1.0); });
        error_text<spear::WrongType>([&] { object.call("EchoInt32", true); });
        error_text<spear::WrongType>([&] { object.call("EchoInt32", "1"); });
        error_text<spear::WrongType>([&] { object.call("EchoBool", 1); });
        error_text<spear::WrongType>([&] { object.call("EchoString", 1); });
        CHECK(object.call<double>("EchoDouble", 3) == 3.0);
        CHECK(object.call<std::uint64_t>("EchoUInt64", (std::uint64_t{1} << 53) + 1) == (std::uint64_t{1} << 53) + 1);

        CHECK(object.call("EchoEnum", "fast") == Value(EnumValue{"ERoundTripMode", "Fast", 1}));
        CHECK(object.call("EchoEnum", "ERoundTripMode::Reckless") == Value(EnumValue{"ERoundTripMode", "Reckless", 7}));
        CHECK(object.call("EchoEnum", 7) == Value(EnumValue{"ERoundTripMode", "Reckless", 7}));
        CHECK(contains(error_text<spear::OutOfRange>([&] { object.call("EchoEnum", "Fst"); }), "Fast"));
        error_text<spear::OutOfRange>([&] { object.call("EchoEnum", 3); });
        error_text<spear::OutOfRange>([&] { object.call("EchoName", std::string(2000, 'n')); });
        error_text<spear::OutOfRange>([&] { object.call("EchoSoftObject", "no path"); });
    });
}

TEST_CASE("futures as arguments: alone, within values, as targets, of failed operations") {
    Client client;
    client.transact([&] {
        const Object object = client.game.new_object("URoundTrip");
        const auto vector = object.async<FVector>("EchoVector", FVector{1, 2, 3});
        CHECK(object.call<FVector>("EchoVector", vector) == FVector{1, 2, 3});
        const auto made = client.game.async().new_object("URoundTrip");
        const auto set = made.property("VectorValue").async_set(vector);
        CHECK(made.property("VectorValue").get<FVector>() == FVector{1, 2, 3});

        const auto failed = object.async<int>("EchoInt8", 300);
        const auto follows = object.async<int>("EchoInt32", failed);
        error_text<spear::DependencyFailed>([&] { (void)follows.get(); });
        error_text<spear::OutOfRange>([&] { (void)failed.get(); });
        error_text<spear::WrongType>([&] { object.call("EchoInt32", vector); });
    });
}
