// SPDX-License-Identifier: MIT
// What was skipped, assumed or wrong. A silent skip is a bug: whoever drops or doubts a declaration says so here.
//
// Rules (stable words): unreadable, not-text, no-generated-include, ast-diagnostic, ast-missing, type-differs,
// unsupported-type, unresolved-type, assumed-type, inactive-region, orphan-macro, unparsed-declaration, missing-body,
// unknown-specifier, default-argument, deprecated-specifier, property-semicolon, enum-value, duplicate-name,
// unresolved-super, macro-blanked, module-name, and the strict ones: nested-container, overloaded-function,
// namespaced-type, unsupported-blueprint-type, arbitrary-condition, generated-include-last, missing-generated-body,
// unnamed-parameter, template-type, category-missing, private-blueprint-property, enum-underlying, raw-enum-member,
// nested-type, static-property, const-property, interface-property, delegate-parameter-count, function-name,
// config-without-class-config, missing-rep-notify, missing-accessor, prefix, raw-reference-member.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace spear::header_tool {

enum class Severity { error, warning, note };

struct ReportEntry {
    Severity severity = Severity::warning;
    std::string rule, file;
    unsigned line = 0;
    std::string subject, message;
};

class Report {
public:
    explicit Report(bool strict) : strict_(strict) {}

    // Something UHT would reject: an error with --strict, else a warning.
    void rule(std::string rule, std::string file, unsigned line, std::string subject, std::string message);
    void warning(std::string rule, std::string file, unsigned line, std::string subject, std::string message);
    void note(std::string rule, std::string file, unsigned line, std::string subject, std::string message);

    // Sorted by file, line, rule, subject; duplicates removed.
    std::vector<ReportEntry> entries() const;
    std::size_t errors() const;
    bool strict() const { return strict_; }

    // The report as JSON text. `headers`: how many were read.
    // `declarations`/`confirmed`/`missing`: what the AST said to the written types.
    std::string json(std::size_t headers, std::size_t declarations, std::size_t confirmed, std::size_t missing) const;

private:
    void add(
        Severity severity, std::string rule, std::string file, unsigned line, std::string subject, std::string message);

    bool strict_;
    mutable std::mutex mutex_;
    std::vector<ReportEntry> entries_;
};

std::string to_string(Severity severity);

} // namespace spear::header_tool
