// SPDX-License-Identifier: MIT
// Registry: values of enumerators and of integer constants, across headers.
#include "constants.h"
#include "registry.h"

#include <algorithm>
#include <limits>

namespace spear::header_tool {

namespace {

// A chain of constants that is longer, or a tree of them that is larger, has no value here.
constexpr int deepest_chain = 32;
constexpr int most_steps = 2000;
thread_local int steps = 0;

std::pair<std::string, std::string> split_scope(const std::string& name) {
    std::size_t colon = name.rfind("::");
    return colon == std::string::npos ? std::pair(std::string(), name)
                                      : std::pair(name.substr(0, colon), name.substr(colon + 2));
}

// Constants that UE's Core and the C library give every header.
std::optional<long long> builtin_value(const std::string& name) {
    static const std::map<std::string, long long> values{{"INDEX_NONE", -1}, {"MAX_int8", 127}, {"MIN_int8", -128},
        {"MAX_uint8", 255}, {"MAX_int16", 32767}, {"MIN_int16", -32768}, {"MAX_uint16", 65535},
        {"MAX_int32", 2147483647}, {"MIN_int32", -2147483648ll}, {"MAX_uint32", 4294967295ll},
        {"MAX_int64", std::numeric_limits<long long>::max()}, {"MIN_int64", std::numeric_limits<long long>::min()},
        {"INT8_MAX", 127}, {"UINT8_MAX", 255}, {"INT16_MAX", 32767}, {"UINT16_MAX", 65535}, {"INT32_MAX", 2147483647},
        {"UINT32_MAX", 4294967295ll}, {"INT_MAX", 2147483647}};
    auto it = values.find(name);
    return it == values.end() ? std::nullopt : std::optional(it->second);
}

std::optional<long long> entry_value(const TypeInfo& info, const std::string& entry) {
    for (const auto& [name, value] : info.values)
        if (name == entry)
            return value;
    return std::nullopt;
}

bool has_entry(const TypeInfo& info, const std::string& entry) {
    return std::any_of(info.values.begin(), info.values.end(), [&](const auto& v) { return v.first == entry; });
}

} // namespace

void Registry::add_constants(const std::vector<ConstantFacts>& constants) {
    for (const ConstantFacts& constant : constants) {
        auto [it, fresh] = constants_.emplace(constant.name, Constant{constant.text, false});
        it->second.ambiguous |= !fresh && it->second.text != constant.text;
        constant_names_.insert(split_scope(constant.name).second);
    }
}

const std::vector<std::pair<std::string, std::optional<long long>>>& Registry::entries_of(const TypeInfo& info) const {
    note("entries", info.name);
    return info.values;
}

std::vector<std::string> Registry::enums_with_entry(const std::string& entry) const {
    note("entry", entry);
    auto it = entries_.find(entry);
    return it == entries_.end() ? std::vector<std::string>() : std::vector(it->second.begin(), it->second.end());
}

std::optional<long long> Registry::constant_value(const std::string& name, int depth) const {
    auto it = constants_.find(name);
    if (it == constants_.end() || it->second.ambiguous || depth > deepest_chain || ++steps > most_steps)
        return std::nullopt;
    std::string scope = split_scope(name).first;
    return header_tool::evaluate(
        it->second.text, [&](const std::string& part) { return name_value(part, scope, depth + 1); });
}

std::optional<long long> Registry::name_value(const std::string& name, const std::string& scope, int depth) const {
    if (depth == 0)
        steps = 0;
    auto [space, last] = split_scope(name);
    if (!space.empty()) {
        // EFoo::Bar, EFoo::Type::Bar, Namespace::EFoo::Bar
        std::string rest = space;
        for (int part = 0; part < 3 && !rest.empty(); ++part) {
            auto [before, word] = split_scope(rest);
            if (const TypeInfo* info = peek(word); info && info->kind == TypeKind::enum_ && has_entry(*info, last))
                return entry_value(*info, last);
            rest = before;
        }
        if (auto value = constant_value(name, depth))
            return value;
        return constant_value(split_scope(space).second + "::" + last, depth);
    }
    if (const TypeInfo* info = scope.empty() ? nullptr : peek(scope); info && has_entry(*info, last))
        return entry_value(*info, last); // an enum's own earlier entry
    if (!scope.empty())
        if (auto value = constant_value(scope + "::" + last, depth))
            return value;
    auto enums = entries_.find(last);
    if (enums != entries_.end())
        for (const std::string& owner : enums->second)
            if (const TypeInfo* info = peek(owner); info && info->form == "regular")
                return entry_value(*info, last);
    if (auto value = constant_value(last, depth))
        return value;
    return builtin_value(last);
}

std::optional<long long> Registry::evaluate(const std::string& expression, const std::string& scope) const {
    return header_tool::evaluate(expression, [&](const std::string& name) {
        note("value", scope + "|" + name);
        return name_value(name, scope, 0);
    });
}

std::optional<long long> Registry::constant(const std::string& name, const std::string& scope) const {
    note("value", scope + "|" + name);
    return name_value(name, scope, 0);
}

void Registry::compute_enum(TypeInfo& info) {
    if (info.kind != TypeKind::enum_ || !info.enumeration || !computed_enums_.insert(info.name).second)
        return;
    std::optional<long long> next = 0;
    for (std::size_t i = 0; i < info.values.size(); ++i) {
        const std::string& text = info.enumeration->entries[i].value_text;
        if (!text.empty()) {
            // Enums that this one is written in terms of come first.
            for (const std::string& name : names_in(text)) {
                auto [space, last] = split_scope(name);
                for (std::string rest = space; !rest.empty(); rest = split_scope(rest).first)
                    if (auto it = types_.find(split_scope(rest).second); it != types_.end())
                        compute_enum(it->second);
                if (auto owners = entries_.find(last); owners != entries_.end() && space.empty())
                    for (const std::string& owner : owners->second)
                        if (auto it = types_.find(owner); it != types_.end() && it->second.form == "regular")
                            compute_enum(it->second);
            }
            next = header_tool::evaluate(text, [&](const std::string& name) { return name_value(name, info.name, 0); });
        }
        info.values[i].second = next;
        if (next)
            next = static_cast<long long>(static_cast<unsigned long long>(*next) + 1);
    }
}

bool Registry::explains(const std::string& name) const {
    std::string last = split_scope(name).second;
    return entries_.contains(last) || constant_names_.contains(last);
}

} // namespace spear::header_tool
