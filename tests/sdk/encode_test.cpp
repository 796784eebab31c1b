// SPDX-License-Identifier: MIT
// The byte encoding: what is written is read, and nothing that arrives as bytes leads the reader astray.
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "spear/encode.hpp"
#include "spear/value.hpp"
#include "spear/wire_type.hpp"

using namespace spear;

TEST_CASE("numbers are little-endian and unpadded") {
    Encoder out;
    out.put(std::uint8_t{1});
    out.put(std::uint32_t{0x01020304});
    out.put_text("ab");
    const std::vector<int> expected{1, 4, 3, 2, 1, 2, 0, 0, 0, 'a', 'b'};
    REQUIRE(out.buffer.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(static_cast<int>(out.buffer[i]) == expected[i]);
}

TEST_CASE("a decoder that failed stays failed and gives zeros") {
    Encoder out;
    out.put(std::uint16_t{7});
    Decoder in(out.bytes());
    CHECK(in.get<std::uint32_t>() == 0);
    CHECK_FALSE(in.ok());
    CHECK(in.get<std::uint16_t>() == 0);
    CHECK(in.get_text().empty());
    CHECK(in.remaining() == 0);
}

TEST_CASE("counts that cannot fit are refused before anything is allocated") {
    Encoder out;
    out.put(std::uint32_t{0xffffffff});
    Decoder in(out.bytes());
    CHECK(in.get_count(4) == 0);
    CHECK_FALSE(in.ok());
}

TEST_CASE("announcements") {
    TypeAnnouncer announcer(types::first_client_type);
    TypeInfo vector;
    vector.name = "FVector";
    vector.fields = {{"X", types::f64}, {"Y", types::f64}, {"Z", types::f64}};
    const TypeId number = announcer.number_of(vector);
    CHECK(announcer.number_of(vector) == number);
    TypeInfo array;
    array.kind = TypeKind::array;
    array.element = number;
    CHECK(announcer.number_of(array) == number + 1);
    const auto bytes = announcer.take_pending();
    CHECK_FALSE(announcer.has_pending());

    SUBCASE("are read back, in order") {
        TypeTable table(types::first_client_type);
        REQUIRE(decode_announcements(bytes, table));
        REQUIRE(table.find(number));
        CHECK(table.find(number)->name == "FVector");
        CHECK(table.find(number)->fields == vector.fields);
        CHECK(table.find(number + 1)->element == number);
        CHECK(table.find(number + 2) == nullptr);
        CHECK(table.find(types::f64) == nullptr);
    }
    SUBCASE("are refused if cut off anywhere") {
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            TypeTable table(types::first_client_type);
            const bool good = decode_announcements({bytes.data(), size}, table);
            CHECK((!good || table.next() < number + 2));
        }
    }
    SUBCASE("are refused out of order") {
        TypeTable table(types::first_client_type + 5);
        CHECK_FALSE(decode_announcements(bytes, table));
    }
}

TEST_CASE("a type table is read by other threads while it grows") {
    TypeTable table(types::first_server_type);
    constexpr TypeId count = 20'000;
    std::thread reader([&] {
        TypeId seen = 0;
        while (seen < count) {
            seen = table.next() - table.first();
            if (seen != 0) {
                const TypeInfo* info = table.find(table.first() + seen - 1);
                REQUIRE(info != nullptr);
                REQUIRE(info->name == std::to_string(seen - 1));
            }
        }
    });
    std::vector<const TypeInfo*> pointers;
    for (TypeId i = 0; i < count; ++i) {
        TypeInfo info;
        info.name = std::to_string(i);
        pointers.push_back(table.find(table.add(std::move(info))));
    }
    reader.join();
    for (TypeId i = 0; i < count; ++i)
        CHECK(table.find(table.first() + i) == pointers[i]);
}

TEST_CASE("operations and answers have the size that their headers say") {
    Encoder out;
    const std::size_t at = begin_operation(out, 42, 7, OperationFlags::wants_answer);
    out.put_text("payload");
    end_operation(out, at);
    Decoder in(out.bytes());
    const OperationHeader header = decode_operation_header(in);
    CHECK(header.number == 42);
    CHECK(header.entry_point == 7);
    CHECK(header.flags == OperationFlags::wants_answer);
    CHECK(header.bytes == in.remaining());
    CHECK(in.get_text() == "payload");

    Decoder cut(out.bytes().first(out.buffer.size() - 1));
    decode_operation_header(cut);
    CHECK_FALSE(cut.ok());
}

TEST_CASE("errors are read back") {
    Encoder out;
    encode_error(out, {ErrorCode::WrongType, "message", "operation", "argument", "FVector"});
    Decoder in(out.bytes());
    const ErrorInfo error = decode_error(in);
    CHECK(in.ok());
    CHECK(error.code == ErrorCode::WrongType);
    CHECK(error.message == "message");
    CHECK(error.operation == "operation");
    CHECK(error.argument == "argument");
    CHECK(error.expected == "FVector");
}

TEST_CASE("random and damaged bytes never lead a reader out of bounds") {
    LocalTypes types;
    Encoder good;
    Value(Value::Dict{{"a", Value::List{1, 2.5, "text"}},
              {"b", NumericArray(types::f32, std::as_bytes(std::span<const float>(std::vector<float>{1, 2})))},
              {"c", StructValue{"FVector", {{"X", 1.0}, {"Y", 2.0}}}}})
        .encode(good, types);
    const ValueContext context{{&types.table(), nullptr}, nullptr};
    Decoder whole(good.bytes());
    CHECK_NOTHROW(Value::decode(whole, context));

    std::mt19937 random(1);
    for (int round = 0; round < 20'000; ++round) {
        std::vector<std::byte> bytes(good.buffer.begin(), good.buffer.end());
        if (round % 2 == 0) {
            bytes.resize(random() % bytes.size());
        }
        for (std::size_t flips = random() % 8; flips != 0 && !bytes.empty(); --flips)
            bytes[random() % bytes.size()] = static_cast<std::byte>(random());
        Decoder skipped(bytes);
        skip_payload(skipped, skipped.get<TypeId>(), context.tables);
        Decoder in(bytes);
        try {
            Value::decode(in, context);
            CHECK(skipped.ok());
        } catch (const MalformedMessage&) {}
    }
}

TEST_CASE("nesting is limited") {
    Encoder out;
    for (std::size_t i = 0; i < limits::max_value_depth + 8; ++i) {
        out.put(types::list);
        out.put(std::uint32_t{1});
    }
    out.put(types::null);
    Decoder skipped(out.bytes());
    skip_payload(skipped, skipped.get<TypeId>(), {});
    CHECK_FALSE(skipped.ok());
    Decoder in(out.bytes());
    CHECK_THROWS_AS(Value::decode(in, ValueContext{}), MalformedMessage);
}
