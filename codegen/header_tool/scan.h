// SPDX-License-Identifier: MIT
// The declaration parser: reads the active text of a header the way UHT does (tokens, not semantics) and fills a
// Header.
#pragma once

#include "model.h"
#include "report.h"

namespace spear::header_tool {

// All directives of the text and what they mean for an offset: which #if conditions enclose it.
class ConditionMap {
public:
    explicit ConditionMap(const std::vector<Directive>& directives);
    Conditions at(std::size_t offset) const;
    // The bodies of the branches, in order; used to find which of them clang skipped.
    const std::vector<ByteRange>& branches() const { return branches_; }

private:
    std::vector<std::pair<std::size_t, Conditions>> changes_;
    std::vector<ByteRange> branches_;
};

// Parses header.lexed into declarations. `report_name` is the path that report entries carry.
void scan(Header& header, const ConditionMap& conditions, Report& report);

// Parses one member declaration behind its macro. Used by scan(); `at` is moved behind the declaration.
class MemberParser {
public:
    MemberParser(Header& header, const ConditionMap& conditions, Report& report)
        : header_(header), conditions_(conditions), report_(report), tokens_(header.lexed.tokens),
          source_(*header.source) {}

    // tokens[at] is UFUNCTION. False (and a report entry) when no function could be read.
    bool function(std::size_t& at, Function& out);
    // tokens[at] is UPROPERTY; several declarators give several properties.
    std::vector<Property> properties(std::size_t& at);
    // tokens[at] is DECLARE_DYNAMIC_...
    bool delegate(std::size_t& at, Delegate& out);
    // tokens[open] is '('.
    std::vector<Parameter> parameters(std::size_t open, std::size_t close);

    // The doc comment that stands directly before tokens[at], as written; "" if there is none.
    std::string comment_before(std::size_t at) const;
    void begin_declared(Declared& declared, std::size_t macro) const;
    // Behind the declaration that starts at `at`: after its ';' or its body.
    std::size_t skip_statement(std::size_t at) const;
    // Index behind attributes, UE_DEPRECATED(...) and other macros that may precede a declaration.
    std::size_t skip_decorations(std::size_t at, std::string* deprecated = nullptr, std::string* api = nullptr) const;
    void fail(const char* rule, std::size_t at, std::string subject, std::string message) const;
    unsigned line(std::size_t token) const { return source_.line(tokens_[token].begin); }
    std::string slice(std::size_t first, std::size_t last) const; // tokens [first, last)

private:
    Parameter parameter(std::size_t begin, std::size_t end);
    std::size_t function_tail(std::size_t at, Function& out);

    Header& header_;
    const ConditionMap& conditions_;
    Report& report_;
    const std::vector<Token>& tokens_;
    const SourceText& source_;
};

bool is_delegate_macro(std::string_view name);
// UCLASS, UPROPERTY, ... and the dynamic delegate macros.
bool is_reflection_macro(std::string_view name);
bool is_api_macro(std::string_view name);
bool is_body_macro(std::string_view name);

} // namespace spear::header_tool
