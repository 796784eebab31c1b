// SPDX-License-Identifier: MIT
// Cache entries as bytes: fields one after the other, numbers in the machine's order (a cache stays on its machine),
// every length checked when read.
#include "cache.h"

#include <cstring>
#include <type_traits>

namespace spear::header_tool {

namespace {

struct Damaged {};

// One description of each structure serves writing and reading: an archive is a Writer or a Reader.
class Writer {
public:
    std::string bytes;

    template <class T>
    void number(const T& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void operator()(const std::string& text) {
        number(static_cast<std::uint32_t>(text.size()));
        bytes.append(text);
    }
    template <class T>
    std::size_t length(const T& items) {
        number(static_cast<std::uint32_t>(items.size()));
        return items.size();
    }
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    template <class T>
    void number(T& value) {
        if (rest_.size() < sizeof value)
            throw Damaged();
        std::memcpy(&value, rest_.data(), sizeof value);
        rest_.remove_prefix(sizeof value);
    }
    void operator()(std::string& text) {
        std::uint32_t size = 0;
        number(size);
        if (rest_.size() < size)
            throw Damaged();
        text.assign(rest_.substr(0, size));
        rest_.remove_prefix(size);
    }
    template <class T>
    std::size_t length(T&) {
        std::uint32_t size = 0;
        number(size);
        if (rest_.size() < size) // every item takes a byte at least
            throw Damaged();
        return size;
    }
    bool at_end() const { return rest_.empty(); }

    int depth = 0;

private:
    std::string_view rest_;
};

template <class T>
using Plain = std::enable_if_t<std::is_arithmetic_v<std::remove_const_t<T>> || std::is_enum_v<std::remove_const_t<T>>>;

template <class Archive, class T, class = Plain<T>>
void archive(Archive& a, T& value) {
    a.number(value);
}

template <class Archive>
void archive(Archive& a, const std::string& text) {
    a(text);
}
template <class Archive>
void archive(Archive& a, std::string& text) {
    a(text);
}

// A bool or enum is read as it was written only if it is in range; other bytes are damage.
template <class T>
void checked(Reader& a, T& value, unsigned char most) {
    unsigned char byte = 0;
    a.number(byte);
    if (byte > most)
        throw Damaged();
    value = static_cast<T>(byte);
}
template <class T>
void checked(Writer& a, const T& value, unsigned char) {
    a.number(static_cast<unsigned char>(value));
}

template <class Archive, class T>
void list(Archive& a, T& items);

template <class T>
void each(Writer& a, const T& items) {
    for (const auto& item : items)
        archive(a, item);
}

void archive(Writer& a, const std::set<std::string>& items) {
    a.length(items);
    each(a, items);
}
void archive(Reader& a, std::set<std::string>& items) {
    std::size_t count = a.length(items);
    for (std::size_t i = 0; i < count; ++i) {
        std::string item;
        a(item);
        items.insert(items.end(), std::move(item));
    }
}

template <class Archive, class Type>
void archive_type(Archive& a, Type& t) {
    archive(a, t.name);
    checked(a, t.is_const, 1);
    checked(a, t.is_raw, 1);
    archive(a, t.pointers);
    checked(a, t.pointer_const, 1);
    checked(a, t.reference, 2);
    list(a, t.args);
}
void archive(Writer& a, const TypeSyntax& t) { archive_type(a, t); }
void archive(Reader& a, TypeSyntax& t) {
    if (++a.depth > 200)
        throw Damaged();
    archive_type(a, t);
    --a.depth;
}

template <class Archive, class Record>
void archive_record(Archive& a, Record& r) {
    archive(a, r.name);
    archive(a, r.line);
    list(a, r.bases);
    archive(a, r.flags);
    archive(a, r.removed);
    list(a, r.functions);
    list(a, r.holds);
    checked(a, r.instanced, 1);
    checked(a, r.config_property, 1);
    checked(a, r.interface, 1);
    for (auto* text : {&r.within, &r.config, &r.hide_categories, &r.show_categories, &r.collapse_categories,
             &r.dont_collapse_categories})
        archive(a, *text);
    checked(a, r.has_defaults, 1);
}
void archive(Writer& a, const RecordFacts& r) { archive_record(a, r); }
void archive(Reader& a, RecordFacts& r) { archive_record(a, r); }

template <class Archive, class Entry>
void archive_entry(Archive& a, Entry& e) {
    archive(a, e.name);
    archive(a, e.value_text);
}
void archive(Writer& a, const EnumEntryFacts& e) { archive_entry(a, e); }
void archive(Reader& a, EnumEntryFacts& e) { archive_entry(a, e); }

template <class Archive, class Enumeration>
void archive_enum(Archive& a, Enumeration& e) {
    for (auto* text : {&e.name, &e.form, &e.cpp_type, &e.underlying})
        archive(a, *text);
    archive(a, e.line);
    list(a, e.entries);
}
void archive(Writer& a, const EnumFacts& e) { archive_enum(a, e); }
void archive(Reader& a, EnumFacts& e) { archive_enum(a, e); }

template <class Archive, class Delegate>
void archive_delegate(Archive& a, Delegate& d) {
    for (auto* text : {&d.name, &d.owner, &d.kind})
        archive(a, *text);
    archive(a, d.line);
}
void archive(Writer& a, const DelegateFacts& d) { archive_delegate(a, d); }
void archive(Reader& a, DelegateFacts& d) { archive_delegate(a, d); }

void archive(Writer& a, const ConstantFacts& c) {
    a(c.name);
    a(c.text);
}
void archive(Reader& a, ConstantFacts& c) {
    a(c.name);
    a(c.text);
}

template <class Archive, class Entry>
void archive_report(Archive& a, Entry& e) {
    checked(a, e.severity, 2);
    for (auto* text : {&e.rule, &e.file, &e.subject, &e.message})
        archive(a, *text);
    archive(a, e.line);
}
void archive(Writer& a, const ReportEntry& e) { archive_report(a, e); }
void archive(Reader& a, ReportEntry& e) { archive_report(a, e); }

template <class Archive, class Question>
void archive_question(Archive& a, Question& q) {
    archive(a, q.first);
    archive(a, q.second.low);
    archive(a, q.second.high);
}
void archive(Writer& a, const std::pair<std::string, Hash>& q) { archive_question(a, q); }
void archive(Reader& a, std::pair<std::string, Hash>& q) { archive_question(a, q); }

template <class Archive, class Part>
void archive_fragment(Archive& a, Part& f) {
    checked(a, f.kind, 3);
    for (auto* text : {&f.name, &f.path, &f.text})
        archive(a, *text);
}
void archive(Writer& a, const Fragment& f) { archive_fragment(a, f); }
void archive(Reader& a, Fragment& f) { archive_fragment(a, f); }

template <class Archive, class T>
void list(Archive& a, T& items) {
    if constexpr (std::is_const_v<T>) {
        a.length(items);
        each(a, items);
    } else {
        std::size_t count = a.length(items);
        items.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            items.emplace_back();
            archive(a, items.back());
        }
    }
}

template <class Archive, class Entry>
void archive_all(Archive& a, Entry& e) {
    checked(a, e.facts.reflected, 1);
    archive(a, e.facts.generated);
    list(a, e.facts.type_names);
    list(a, e.facts.classes);
    list(a, e.facts.structs);
    list(a, e.facts.enums);
    list(a, e.facts.delegates);
    list(a, e.facts.constants);
    list(a, e.facts.asked);
    list(a, e.scan_report);
    checked(a, e.has_result, 1);
    list(a, e.questions);
    for (auto* number :
        {&e.statistics.declarations, &e.statistics.confirmed, &e.statistics.missing, &e.statistics.rounds})
        archive(a, *number);
    list(a, e.check_report);
    list(a, e.fragments);
}

} // namespace

std::string to_bytes(const CacheEntry& entry) {
    Writer writer;
    archive_all(writer, entry);
    return std::move(writer.bytes);
}

std::optional<CacheEntry> from_bytes(std::string_view bytes) {
    Reader reader(bytes);
    CacheEntry entry;
    try {
        archive_all(reader, entry);
    } catch (const Damaged&) {
        return std::nullopt;
    }
    return reader.at_end() ? std::optional(std::move(entry)) : std::nullopt;
}

} // namespace spear::header_tool
