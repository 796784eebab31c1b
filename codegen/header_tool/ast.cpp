// SPDX-License-Identifier: MIT
#include "ast.h"

#include "constants.h"
#include "prelude.h"

#include <clang-c/Index.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <unordered_map>

namespace spear::header_tool {

namespace {

constexpr const char* main_name = "/spear/header.h";
constexpr const char* prelude_name = "/spear/prelude.h";

struct IndexDeleter {
    void operator()(void* index) const { clang_disposeIndex(index); }
};
struct UnitDeleter {
    void operator()(CXTranslationUnitImpl* unit) const { clang_disposeTranslationUnit(unit); }
};
using Unit = std::unique_ptr<CXTranslationUnitImpl, UnitDeleter>;

std::string take(CXString string) {
    const char* text = clang_getCString(string);
    std::string out = text ? text : "";
    clang_disposeString(string);
    return out;
}

CXIndex thread_index() {
    thread_local std::unique_ptr<void, IndexDeleter> index(clang_createIndex(0, 0));
    return index.get();
}

Unit parse(const std::string& text, const std::string* prelude_text, const Defines& defines, unsigned options) {
    std::vector<std::string> args{"-x", "c++", "-std=c++20", "-nostdinc", "-nostdinc++", "-fsyntax-only", "-w",
        "-ferror-limit=0", "-fms-extensions", "-ftemplate-depth=64", "-fno-spell-checking"};
    for (const auto& [name, value] : defines)
        args.push_back("-D" + name + "=" + value);
    std::vector<CXUnsavedFile> files{{main_name, text.data(), text.size()}};
    if (prelude_text) {
        args.insert(args.end(), {"-include", prelude_name});
        files.push_back({prelude_name, prelude_text->data(), prelude_text->size()});
    }
    std::vector<const char*> pointers;
    for (const std::string& arg : args)
        pointers.push_back(arg.c_str());
    CXTranslationUnit unit = nullptr;
    clang_parseTranslationUnit2(thread_index(), main_name, pointers.data(), static_cast<int>(pointers.size()),
        files.data(), static_cast<unsigned>(files.size()), options, &unit);
    return Unit(unit);
}

void blank(std::string& text, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, text.size()); ++i)
        if (text[i] != '\n')
            text[i] = ' ';
}

std::size_t offset_of(CXSourceLocation location) {
    unsigned offset = 0;
    clang_getFileLocation(location, nullptr, nullptr, nullptr, &offset);
    return offset;
}

} // namespace

std::string clang_version() { return take(clang_getClangVersion()); }

Defines default_defines() {
    return {{"CPP", "0"}, {"WITH_EDITOR", "1"}, {"WITH_EDITORONLY_DATA", "1"}, {"WITH_METADATA", "1"},
        {"WITH_ENGINE", "1"}, {"WITH_HOT_RELOAD", "1"}, {"WITH_SERVER_CODE", "1"}, {"UE_BUILD_DEVELOPMENT", "1"},
        {"UE_BUILD_DEBUG", "0"}, {"UE_BUILD_SHIPPING", "0"}, {"UE_BUILD_TEST", "0"}, {"PLATFORM_LINUX", "1"},
        {"PLATFORM_WINDOWS", "0"}, {"PLATFORM_MAC", "0"}, {"PLATFORM_ANDROID", "0"}, {"PLATFORM_IOS", "0"},
        {"PLATFORM_DESKTOP", "1"}, {"PLATFORM_64BITS", "1"}, {"ENGINE_MAJOR_VERSION", "5"},
        {"ENGINE_MINOR_VERSION", "5"}, {"ENGINE_PATCH_VERSION", "0"},
        {"UE_VERSION_OLDER_THAN(a,b,c)", "(5<(a)||(5==(a)&&5<(b)))"},
        {"UE_VERSION_NEWER_THAN(a,b,c)", "(5>(a)||(5==(a)&&5>(b)))"}, {"DO_CHECK", "1"}, {"STATS", "0"},
        {"ENABLE_DRAW_DEBUG", "1"}};
}

std::vector<ByteRange> inactive_branches(const SourceText& source, const std::vector<Directive>& directives,
    const ConditionMap& conditions, const Defines& defines) {
    if (conditions.branches().empty())
        return {};
    // Only the directives matter here: everything else is blanked, so this is a preprocessor run over a few lines.
    std::string text = source.bytes();
    std::size_t at = 0;
    for (const Directive& d : directives) {
        blank(text, at, d.name == "include" || d.name == "import" ? d.end : d.begin);
        at = d.end;
    }
    blank(text, at, text.size());
    Unit unit =
        parse(text, nullptr, defines, CXTranslationUnit_DetailedPreprocessingRecord | CXTranslationUnit_KeepGoing);
    std::vector<ByteRange> out;
    if (!unit)
        return out;
    CXFile file = clang_getFile(unit.get(), main_name);
    CXSourceRangeList* skipped = clang_getSkippedRanges(unit.get(), file);
    std::vector<ByteRange> ranges;
    for (unsigned i = 0; skipped && i < skipped->count; ++i)
        ranges.push_back(
            {offset_of(clang_getRangeStart(skipped->ranges[i])), offset_of(clang_getRangeEnd(skipped->ranges[i]))});
    if (skipped)
        clang_disposeSourceRangeList(skipped);
    for (const ByteRange& branch : conditions.branches())
        for (const ByteRange& range : ranges)
            if (branch.end > branch.begin && range.begin <= branch.begin && range.end >= branch.end) {
                out.push_back(branch);
                break;
            }
    // Nested branches lie inside their parents: keep the outermost only.
    std::vector<ByteRange> flat;
    for (const ByteRange& range : out)
        if (flat.empty() || range.begin >= flat.back().end)
            flat.push_back(range);
    return flat;
}

namespace {

struct AstEntry {
    CXCursorKind kind;
    std::string name, type;
    long long value = 0;       // enumerators
    long long array_size = -1; // fields that are C arrays
};

using Entries = std::unordered_map<std::size_t, AstEntry>;

// Also true inside a macro's expansion in this file.
bool is_main_file(CXSourceLocation location) {
    CXFile file = nullptr;
    clang_getFileLocation(location, &file, nullptr, nullptr, nullptr);
    return file && take(clang_getFileName(file)) == main_name;
}

CXChildVisitResult visit(CXCursor cursor, CXCursor, CXClientData data) {
    Entries& entries = *static_cast<Entries*>(data);
    CXCursorKind kind = clang_getCursorKind(cursor);
    if (!clang_Location_isFromMainFile(clang_getCursorLocation(cursor))) {
        // What the prelude's delegate macros made counts, as it is written here.
        bool parameter = kind == CXCursor_ParmDecl;
        CXCursor function = parameter ? clang_getCursorSemanticParent(cursor) : cursor;
        bool delegate = (parameter || kind == CXCursor_CXXMethod) && is_main_file(clang_getCursorLocation(cursor)) &&
                        take(clang_getCursorSpelling(function)) == delegate_function;
        if (!delegate)
            return kind == CXCursor_StructDecl && is_main_file(clang_getCursorLocation(cursor)) ? CXChildVisit_Recurse
                                                                                                : CXChildVisit_Continue;
    }
    switch (kind) {
    case CXCursor_FieldDecl:
    case CXCursor_VarDecl:
    case CXCursor_ParmDecl:
    case CXCursor_CXXMethod:
    case CXCursor_FunctionDecl:
    case CXCursor_EnumConstantDecl: {
        AstEntry entry{kind, take(clang_getCursorSpelling(cursor)), {}, 0, -1};
        CXType type = clang_getCursorType(cursor);
        if (kind == CXCursor_CXXMethod || kind == CXCursor_FunctionDecl)
            type = clang_getResultType(type);
        if (kind == CXCursor_EnumConstantDecl) {
            CXType underlying =
                clang_getCanonicalType(clang_getEnumDeclIntegerType(clang_getCursorSemanticParent(cursor)));
            bool is_unsigned = underlying.kind >= CXType_Bool &&
                               underlying.kind <= CXType_UInt128; // clang lists the unsigned kinds in this span
            entry.value = is_unsigned ? static_cast<long long>(clang_getEnumConstantDeclUnsignedValue(cursor))
                                      : clang_getEnumConstantDeclValue(cursor);
        } else
            entry.type = take(clang_getTypeSpelling(type));
        if (kind == CXCursor_FieldDecl && type.kind == CXType_ConstantArray)
            entry.array_size = clang_getArraySize(type);
        entries.emplace(offset_of(clang_getCursorLocation(cursor)), std::move(entry));
        break;
    }
    default:
        break;
    }
    bool descend = kind == CXCursor_Namespace || kind == CXCursor_ClassDecl || kind == CXCursor_StructDecl ||
                   kind == CXCursor_EnumDecl || kind == CXCursor_CXXMethod || kind == CXCursor_FunctionDecl ||
                   kind == CXCursor_LinkageSpec || kind == CXCursor_UnexposedDecl;
    return descend ? CXChildVisit_Recurse : CXChildVisit_Continue;
}

// For comparison: no blanks, no elaborating keywords, no leading ::, no array part.
std::string comparable(std::string text) {
    std::size_t bracket = text.find('[');
    if (bracket != std::string::npos)
        text.erase(bracket);
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        bool word = i == 0 || !(std::isalnum(static_cast<unsigned char>(text[i - 1])) || text[i - 1] == '_');
        bool skipped = false;
        for (std::string_view keyword : {"class ", "struct ", "enum ", "typename "})
            if (word && text.compare(i, keyword.size(), keyword) == 0) {
                i += keyword.size();
                skipped = true;
                break;
            }
        if (skipped)
            continue;
        if (word && text.compare(i, 2, "::") == 0 && (i == 0 || text[i - 1] != '>')) {
            i += 2;
            continue;
        }
        if (text[i] != ' ')
            out += text[i];
        else if (!out.empty() && i + 1 < text.size() && std::isalnum(static_cast<unsigned char>(out.back())) &&
                 std::isalnum(static_cast<unsigned char>(text[i + 1])))
            out += ' ';
        ++i;
    }
    return out;
}

// A name that clang did not know, from a diagnostic: 'X' in quotes.
std::string quoted_name(const std::string& message) {
    std::size_t open = message.find('\'');
    std::size_t close = open == std::string::npos ? open : message.find('\'', open + 1);
    return close == std::string::npos ? std::string() : message.substr(open + 1, close - open - 1);
}

class Checker {
public:
    Checker(Header& header, const Registry& registry, const Defines& defines, Report& report)
        : header_(header), registry_(registry), defines_(defines), report_(report) {}

    AstStatistics run() {
        text_ = header_.source->bytes();
        // Inactive branches go too: their directives stay, so that clang decides as before.
        for (const Directive& d : header_.lexed.directives)
            if (d.name == "include" || d.name == "import" || d.name == "error")
                blank(text_, d.begin, d.end);
        for (const ByteRange& range : header_.blanks)
            blank(text_, range.begin, range.end);
        names_ = used_names(header_);
        for (const ConstantFacts& constant : find_constants(header_.lexed))
            own_constants_.insert(constant.name);
        for (const Enum& e : header_.enums)
            for (const EnumEntry& entry : e.entries)
                need_constants(entry.value_text, e.name);
        for (const Class& c : header_.classes)
            for (const Property& p : c.properties)
                need_constants(p.array_text, c.name);
        for (const Struct& s : header_.structs)
            for (const Property& p : s.properties)
                need_constants(p.array_text, s.name);
        for (statistics_.rounds = 1; statistics_.rounds <= 5; ++statistics_.rounds) {
            if (!parse_once())
                break;
            if (count(false) || !learn())
                break;
        }
        statistics_.declarations = statistics_.confirmed = statistics_.missing = 0;
        count(true);
        enum_values();
        array_sizes();
        return statistics_;
    }

private:
    // Enums and constants of other headers that a constant expression names.
    void need_constants(const std::string& expression, const std::string& scope) {
        for (const std::string& name : names_in(expression)) {
            std::size_t colon = name.rfind("::");
            std::string last = colon == std::string::npos ? name : name.substr(colon + 2);
            std::string space = colon == std::string::npos ? "" : name.substr(0, colon);
            bool is_enum = false;
            for (const std::string& owner : registry_.enums_with_entry(last)) {
                const TypeInfo* info = registry_.find(owner);
                if (info && (space.empty() ? info->form == "regular" : space == owner || space == info->cpp_type)) {
                    names_.insert(owner);
                    is_enum = true;
                }
            }
            bool own = own_constants_.contains(name) || own_constants_.contains(scope + "::" + name);
            if (is_enum || own || prelude_knows(name) || space.find("::") != std::string::npos)
                continue;
            if (auto value = registry_.constant(name, scope))
                constants_[space][last] = *value;
        }
    }

    bool parse_once() {
        std::string prelude_text = prelude(header_, registry_, names_, macros_, constants_);
        unit_ = parse(text_, &prelude_text, defines_,
            CXTranslationUnit_SkipFunctionBodies | CXTranslationUnit_KeepGoing | CXTranslationUnit_Incomplete);
        entries_.clear();
        if (!unit_) {
            report_.warning("ast-diagnostic", header_.path, 1, header_.relative,
                "libclang could not parse this header; its declarations are taken from the text only");
            return false;
        }
        clang_visitChildren(clang_getTranslationUnitCursor(unit_.get()), visit, &entries_);
        return true;
    }

    // Adds names that diagnostics complain about; false when there is nothing new.
    bool learn() {
        bool fresh = false;
        unsigned n = clang_getNumDiagnostics(unit_.get());
        std::set<std::string> defined(header_.defined_names.begin(), header_.defined_names.end());
        for (const Delegate& d : header_.delegates)
            defined.insert(d.name);
        for (unsigned i = 0; i < n; ++i) {
            CXDiagnostic diagnostic = clang_getDiagnostic(unit_.get(), i);
            std::string message = take(clang_getDiagnosticSpelling(diagnostic));
            std::size_t offset = offset_of(clang_getDiagnosticLocation(diagnostic));
            clang_disposeDiagnostic(diagnostic);
            bool type = message.starts_with("unknown type name") || message.starts_with("no template named") ||
                        message.starts_with("use of undeclared identifier") ||
                        message.starts_with("unknown class name");
            if (!type)
                continue;
            std::string name = quoted_name(message);
            if (name.empty() || defined.contains(name) || name.find(' ') != std::string::npos)
                continue;
            if (is_macro_like(name) && name.size() > 2) {
                std::size_t after = offset + name.size();
                while (after < text_.size() && (text_[after] == ' ' || text_[after] == '\t'))
                    ++after;
                bool call = after < text_.size() && text_[after] == '(';
                if (macros_.insert(call ? name + "(...)" : name).second) {
                    fresh = true;
                    report_.note("macro-blanked", header_.path,
                        header_.source->line(std::min(offset, text_.size() - 1)), name, "unknown macro taken as empty");
                }
            } else if (names_.insert(name).second) {
                fresh = true;
            }
        }
        return fresh;
    }

    bool check_one(const std::string& subject, std::size_t offset, unsigned line, const TypeSyntax& type,
        bool parameter, bool report) {
        ++statistics_.declarations;
        auto it = entries_.find(offset);
        if (it == entries_.end()) {
            ++statistics_.missing;
            if (report)
                report_.note("ast-missing", header_.path, line, subject, "not in the AST; taken from the text");
            return false;
        }
        std::string expected = comparable(type.text()), found = comparable(it->second.type);
        if (parameter && expected.ends_with("*const"))
            expected.erase(expected.size() - 5); // top-level const
        if (parameter && found.ends_with("*const"))
            found.erase(found.size() - 5);
        if (expected != found) {
            if (report)
                report_.warning("type-differs", header_.path, line, subject,
                    fmt::format("text says '{}', the AST says '{}'; the text is kept", type.text(), it->second.type));
            return false;
        }
        ++statistics_.confirmed;
        return true;
    }

    bool check_function(const std::string& owner, const Function& f, bool report) {
        bool good = check_one(owner + "::" + f.name, f.name_offset, f.line, f.return_type, false, report);
        for (const Parameter& p : f.parameters)
            if (!p.name.empty())
                good &=
                    check_one(owner + "::" + f.name + "(" + p.name + ")", p.name_offset, f.line, p.type, true, report);
        return good;
    }

    // The prelude makes each delegate macro a struct with a function of its signature, at the macro's place.
    bool check_delegate(const Delegate& d, bool report) {
        bool good = check_one(d.name, d.macro_token, d.line, d.return_type, false, report);
        for (const Parameter& p : d.parameters)
            if (!p.name.empty())
                good &= check_one(d.name + "(" + p.name + ")", p.name_offset, d.line, p.type, true, report);
        return good;
    }

    bool check_record(const Record& r, bool report) {
        bool good = true;
        for (const Function& f : r.functions)
            good &= check_function(r.name, f, report);
        for (const Property& p : r.properties)
            good &= check_one(r.name + "::" + p.cpp_name, p.name_offset, p.line, p.type, false, report);
        return good;
    }

    bool count(bool report) {
        bool good = true;
        for (const Class& c : header_.classes) {
            good &= check_record(c, report);
            if (c.native)
                good &= check_record(*c.native, report);
        }
        for (const Struct& s : header_.structs)
            good &= check_record(s, report);
        for (const Delegate& d : header_.delegates)
            good &= check_delegate(d, report);
        return good;
    }

    // True when clang reported an error inside the range: then it made a value up.
    bool has_error(const ByteRange& range) const {
        unsigned n = unit_ ? clang_getNumDiagnostics(unit_.get()) : 0;
        for (unsigned i = 0; i < n; ++i) {
            CXDiagnostic diagnostic = clang_getDiagnostic(unit_.get(), i);
            bool error = clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error;
            CXSourceLocation location = clang_getDiagnosticLocation(diagnostic);
            bool here = error && clang_Location_isFromMainFile(location) && range.contains(offset_of(location));
            clang_disposeDiagnostic(diagnostic);
            if (here)
                return true;
        }
        return false;
    }

    // clang's value, our own where clang lacks a part, a report entry where neither can tell.
    void array_sizes() {
        auto fill = [&](std::vector<Property>& properties, const std::string& scope) {
            for (Property& p : properties) {
                if (p.array_text.empty())
                    continue;
                auto it = entries_.find(p.name_offset);
                bool found = it != entries_.end() && it->second.array_size > 0 && !has_error(p.array_range);
                std::optional<long long> computed = registry_.evaluate(p.array_text, scope);
                if (found)
                    p.array_size = static_cast<int>(it->second.array_size);
                else if (computed && *computed > 0 && *computed <= std::numeric_limits<int>::max())
                    p.array_size = static_cast<int>(*computed);
                else
                    report_.warning("array-dimension", header_.path, p.line, scope + "::" + p.cpp_name,
                        fmt::format("array dimension '{}' is unknown here; 1 is written", p.array_text));
                if (found && computed && *computed != *p.array_size)
                    report_.warning("array-dimension", header_.path, p.line, scope + "::" + p.cpp_name,
                        fmt::format("array dimension '{}' is {} to clang and {} by the text; {} is written",
                            p.array_text, *p.array_size, *computed, *p.array_size));
            }
        };
        for (Class& c : header_.classes)
            fill(c.properties, c.name);
        for (Struct& s : header_.structs)
            fill(s.properties, s.name);
    }

    void enum_values() {
        for (Enum& e : header_.enums) {
            const TypeInfo* info = registry_.find(e.name);
            if (!info || info->kind != TypeKind::enum_)
                continue;
            const auto& computed = registry_.entries_of(*info);
            bool same = computed.size() == e.entries.size(); // else another declaration of this name is kept
            long long next = 0;
            for (std::size_t i = 0; i < e.entries.size(); ++i) {
                EnumEntry& entry = e.entries[i];
                auto it = entries_.find(entry.name_offset);
                bool found = it != entries_.end() && it->second.kind == CXCursor_EnumConstantDecl &&
                             !(entry.value_range.end > 0 && has_error(entry.value_range));
                std::optional<long long> value = same ? computed[i].second : std::nullopt;
                entry.value = found ? it->second.value : value.value_or(next);
                if (!found && !value && !entry.value_text.empty())
                    report_.rule("enum-value", header_.path, entry.line, e.name + "::" + entry.name,
                        fmt::format("value '{}' could not be computed; {} is assumed", entry.value_text, next));
                if (found && value && !same_value(*value, it->second.value))
                    report_.warning("enum-value", header_.path, entry.line, e.name + "::" + entry.name,
                        fmt::format("value '{}' is {} to clang and {} by the text; {} is written", entry.value_text,
                            it->second.value, *value, it->second.value));
                next = static_cast<long long>(static_cast<unsigned long long>(*entry.value) + 1);
            }
        }
    }

    // -1 in an unsigned enum is its largest value.
    static bool same_value(long long a, long long b) {
        return a == b || static_cast<std::uint32_t>(a) == static_cast<std::uint64_t>(b) ||
               static_cast<std::uint16_t>(a) == static_cast<std::uint64_t>(b) ||
               static_cast<std::uint8_t>(a) == static_cast<std::uint64_t>(b);
    }

    Header& header_;
    const Registry& registry_;
    const Defines& defines_;
    Report& report_;
    std::string text_;
    std::set<std::string> names_, macros_, own_constants_;
    PreludeConstants constants_;
    Unit unit_;
    Entries entries_;
    AstStatistics statistics_;
};

} // namespace

AstStatistics check_with_ast(Header& header, const Registry& registry, const Defines& defines, Report& report) {
    return Checker(header, registry, defines, report).run();
}

} // namespace spear::header_tool
