// SPDX-License-Identifier: MIT
// What was skipped, assumed or wrong. A silent skip is a bug: whoever drops or doubts a declaration says so here.
//
// Rules (stable words): arbitrary-condition, array-dimension, assumed-type, ast-diagnostic, ast-missing,
// bad-descriptor, config-without-class-config, const-property, container-allocator, default-argument,
// delegate-parameter-count, duplicate-module, duplicate-name, enum-underlying, enum-value, function-name,
// generated-include-last, inactive-region, interface-property, macro-blanked, missing-accessor, missing-body,
// missing-generated-body, missing-module, missing-rep-notify, namespaced-type, nested-container, nested-type,
// no-generated-include, not-text, orphan-macro, overloaded-function, prefix, private-blueprint-property,
// property-semicolon, raw-enum-member, static-property, template-type, too-deep, too-large, type-differs,
// unknown-specifier, unnamed-parameter, unparsed-declaration, unreadable, unresolved-super, unresolved-type,
// unsupported-blueprint-type, unsupported-type.
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

    // Takes over what was found elsewhere (in one header, or in an earlier run of it).
    void append(const std::vector<ReportEntry>& entries);

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
