// SPDX-License-Identifier: MIT
// Value: from and to bytes.
#include "value_impl.hpp"

namespace spear {
namespace {

using detail::Overloaded;

bool is_number(TypeId type) { return type >= types::i8 && type <= types::f64; }

[[noreturn]] void throw_malformed(std::string_view what) {
    throw_error(ErrorCode::MalformedMessage,
        fmt::format("The engine sent bytes that are no value of this protocol: {}.", what));
}

} // namespace

// Decoding

Value Value::decode(Decoder& in, const ValueContext& context) {
    const auto type = in.get<TypeId>();
    return decode(in, type, context, 0);
}

Value Value::decode(Decoder& in, TypeId type, const ValueContext& context, std::size_t depth) {
    if (depth > limits::max_value_depth)
        throw_malformed("it is nested too deep");
    const auto part = [&](TypeId part_type) { return decode(in, part_type, context, depth + 1); };
    const auto value = [&] {
        const auto value_type = in.get<TypeId>();
        return part(value_type);
    };
    const auto checked = [&](auto result) {
        if (!in.ok())
            throw_malformed("it is cut off");
        return Value(std::move(result));
    };
    switch (type) {
    case types::null:
        return checked(nullptr);
    case types::boolean:
        return checked(in.get<std::uint8_t>() != 0);
    case types::i8:
        return checked(in.get<std::int8_t>());
    case types::i16:
        return checked(in.get<std::int16_t>());
    case types::i32:
        return checked(in.get<std::int32_t>());
    case types::i64:
        return checked(in.get<std::int64_t>());
    case types::u8:
        return checked(in.get<std::uint8_t>());
    case types::u16:
        return checked(in.get<std::uint16_t>());
    case types::u32:
        return checked(in.get<std::uint32_t>());
    case types::u64:
        return checked(in.get<std::uint64_t>());
    case types::f32:
        return checked(in.get<float>());
    case types::f64:
        return checked(in.get<double>());
    case types::string:
        return checked(in.get_text());
    case types::bytes: {
        const auto raw = in.get_raw(in.get<std::uint32_t>());
        return checked(Bytes(raw.begin(), raw.end()));
    }
    case types::object: {
        ObjectRef ref;
        ref.handle = in.get<std::uint64_t>();
        ref.class_type = in.get<TypeId>();
        if (ref.handle == 0)
            return checked(nullptr);
        return checked(ObjectHandle(detail::session_of_context(context.session), ref));
    }
    case types::any:
        return checked(value());
    case types::future:
        throw_malformed("a future stands where a result should");
    case types::list: {
        List list;
        for (std::uint32_t n = in.get_count(4); n != 0; --n)
            list.push_back(value());
        return checked(std::move(list));
    }
    case types::dict: {
        Dict dict;
        for (std::uint32_t n = in.get_count(8); n != 0; --n) {
            std::string key(in.get_text());
            dict.emplace_back(std::move(key), value());
        }
        return checked(std::move(dict));
    }
    case types::map: {
        Map map;
        for (std::uint32_t n = in.get_count(8); n != 0; --n) {
            Value key = value();
            map.emplace_back(std::move(key), value());
        }
        return checked(std::move(map));
    }
    default:
        break;
    }

    const TypeInfo* info = context.tables.find(type);
    if (!info)
        throw_malformed(fmt::format("type number {} was never announced", type));
    switch (info->kind) {
    case TypeKind::structure: {
        StructValue structure{info->name, {}};
        structure.fields.reserve(info->fields.size());
        for (const FieldInfo& field : info->fields)
            structure.fields.emplace_back(field.name, part(field.type));
        return checked(std::move(structure));
    }
    case TypeKind::array:
    case TypeKind::set: {
        if (is_number(info->element)) {
            const std::size_t size = fixed_size(info->element);
            const std::uint32_t count = in.get_count(size);
            return checked(NumericArray(info->element, in.get_raw(count * size)));
        }
        List list;
        for (std::uint32_t n = in.get_count(1); n != 0; --n)
            list.push_back(part(info->element));
        return checked(std::move(list));
    }
    case TypeKind::map: {
        Map map;
        for (std::uint32_t n = in.get_count(1); n != 0; --n) {
            Value key = part(info->key);
            map.emplace_back(std::move(key), part(info->element));
        }
        return checked(std::move(map));
    }
    case TypeKind::enumeration: {
        EnumValue entry{info->name, {}, in.get<std::int64_t>()};
        for (const EnumEntry& candidate : info->entries) {
            if (candidate.value == entry.value) {
                entry.entry_name = candidate.name;
                break;
            }
        }
        return checked(std::move(entry));
    }
    default:
        throw_malformed(fmt::format("type number {} (\"{}\") is no type of values", type, info->name));
    }
}

// Encoding

/// The type whose payload this value is; types::any where only a value with its own type number will do.
TypeId Value::typed_number(TypeSource& source) const {
    return std::visit(Overloaded{
                          [](bool) { return types::boolean; },
                          [](std::int64_t) { return types::i64; },
                          [](std::uint64_t) { return types::u64; },
                          [](double) { return types::f64; },
                          [](const std::string&) { return types::string; },
                          [](const Bytes&) { return types::bytes; },
                          [](const ObjectHandle&) { return types::object; },
                          [](const EnumValue&) { return types::i64; },
                          [&](const StructValue& structure) {
                              TypeInfo info;
                              info.name = structure.type_name;
                              for (const auto& [name, value] : structure.fields)
                                  info.fields.push_back({name, value.typed_number(source)});
                              return source.number_of(info);
                          },
                          [&](const NumericArray& array) {
                              TypeInfo info;
                              info.kind = TypeKind::array;
                              info.element = array.element();
                              return source.number_of(info);
                          },
                          [](const auto&) { return types::any; },
                      },
        storage_);
}

void Value::encode_typed_payload(Encoder& out, TypeSource& source) const {
    std::visit(Overloaded{
                   [&](bool value) { out.put(static_cast<std::uint8_t>(value)); },
                   [&](std::int64_t value) { out.put(value); },
                   [&](std::uint64_t value) { out.put(value); },
                   [&](double value) { out.put(value); },
                   [&](const std::string& value) { out.put_text(value); },
                   [&](const Bytes& value) {
                       out.put(static_cast<std::uint32_t>(value.size()));
                       out.put_raw(value.data(), value.size());
                   },
                   [&](const ObjectHandle& value) {
                       out.put(value.ref().handle);
                       out.put(value.ref().class_type);
                   },
                   [&](const EnumValue& value) { out.put(value.value); },
                   [&](const StructValue& value) {
                       for (const auto& [name, field] : value.fields)
                           field.encode_typed_payload(out, source);
                   },
                   [&](const NumericArray& value) {
                       out.put(static_cast<std::uint32_t>(value.size()));
                       out.put_raw(value.bytes().data(), value.bytes().size());
                   },
                   [&](const auto&) { encode(out, source); },
               },
        storage_);
}

void Value::encode(Encoder& out, TypeSource& source) const {
    if (const auto* list = get_if<List>()) {
        out.put(types::list);
        out.put(static_cast<std::uint32_t>(list->size()));
        for (const Value& value : *list)
            value.encode(out, source);
    } else if (const auto* dict = get_if<Dict>()) {
        out.put(types::dict);
        out.put(static_cast<std::uint32_t>(dict->size()));
        for (const auto& [key, value] : *dict) {
            out.put_text(key);
            value.encode(out, source);
        }
    } else if (const auto* map = get_if<Map>()) {
        out.put(types::map);
        out.put(static_cast<std::uint32_t>(map->size()));
        for (const auto& [key, value] : *map) {
            key.encode(out, source);
            value.encode(out, source);
        }
    } else if (is_null()) {
        out.put(types::null);
    } else if (const auto* structure = get_if<StructValue>(); structure && structure->fields.empty()) {
        out.put(types::dict); // an announced type has at least one byte
        out.put(std::uint32_t{0});
    } else {
        out.put(typed_number(source));
        encode_typed_payload(out, source);
    }
}

void Codec<Value>::encode(Encoder& out, const Value& value) {
    if (const auto* structure = value.get_if<StructValue>()) {
        out.put(types::dict);
        out.put(static_cast<std::uint32_t>(structure->fields.size()));
        for (const auto& [key, field] : structure->fields) {
            out.put_text(key);
            encode(out, field);
        }
    } else if (const auto* list = value.get_if<Value::List>()) {
        Codec<std::vector<Value>>::encode(out, *list);
    } else if (const auto* dict = value.get_if<Value::Dict>()) {
        out.put(types::dict);
        out.put(static_cast<std::uint32_t>(dict->size()));
        for (const auto& [key, part] : *dict) {
            out.put_text(key);
            encode(out, part);
        }
    } else if (const auto* map = value.get_if<Value::Map>()) {
        out.put(types::map);
        out.put(static_cast<std::uint32_t>(map->size()));
        for (const auto& [key, part] : *map) {
            encode(out, key);
            encode(out, part);
        }
    } else if (const auto* array = value.get_if<NumericArray>()) {
        out.put(types::list);
        out.put(static_cast<std::uint32_t>(array->size()));
        for (std::size_t i = 0; i < array->size(); ++i) {
            out.put(array->element());
            const std::size_t size = fixed_size(array->element());
            out.put_raw(array->bytes().data() + i * size, size);
        }
    } else {
        LocalTypes no_types; // what is left announces nothing
        value.encode(out, no_types);
    }
}

CodecError Codec<Value>::decode(Decoder& in, TypeId type, const DecodeContext& context, Value& value) {
    try {
        value = Value::decode(in, type, ValueContext{context.tables, static_cast<Session*>(context.user)});
        return CodecError::none;
    } catch (const MalformedMessage&) {
        return CodecError::malformed;
    }
}

} // namespace spear
