// SPDX-License-Identifier: MIT
// The inside of classes, interfaces and structs, and what file scope shares with it.
#pragma once

#include "scan.h"

namespace spear::header_tool {

class BodyScanner {
public:
    BodyScanner(Header& header, const ConditionMap& conditions, Report& report)
        : header_(header), report_(report), members_(header, conditions, report), tokens_(header.lexed.tokens),
          source_(*header.source) {}

    // Reads the members between tokens[open] == '{' and tokens[close] into `r`. `owner`: the class that delegates
    // declared here belong to, "" for structs.
    void body(Record& r, std::size_t open, std::size_t close, const std::string& owner, bool is_struct);
    // tokens[at] is UDELEGATE or a dynamic delegate macro; returns the index behind it.
    std::size_t delegate(std::size_t at, const std::string& owner, const std::string& space);
    // tokens[at] is `template`; returns the index behind its <...>.
    std::size_t skip_template(std::size_t at) const;
    // Reports reflection macros inside a body that is not reflected.
    void orphans_inside(std::size_t from, std::size_t to) const;

    MemberParser& members() { return members_; }

private:
    // UE_DEPRECATED(...) and its kind directly before the member at `at`: its text and the comment above it count.
    void decorate(Declared& declared, std::string* deprecated, std::size_t at) const;
    std::size_t member(Record& r, std::size_t at, std::size_t close, Access access);
    std::size_t macro_end(std::size_t begin, std::size_t macro);
    void function_like(Record& r, std::size_t begin, std::size_t name, std::size_t params_end, Access access);

    Header& header_;
    Report& report_;
    MemberParser members_;
    const std::vector<Token>& tokens_;
    const SourceText& source_;
    std::size_t decoration_begin_ = 0, decoration_end_ = 0; // the last macro call in front of a declaration
    std::string decoration_deprecated_;
};

} // namespace spear::header_tool
