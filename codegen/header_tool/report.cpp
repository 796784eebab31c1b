// SPDX-License-Identifier: MIT
#include "report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <tuple>

namespace spear::header_tool {

std::string to_string(Severity severity) {
    switch (severity) {
    case Severity::error:
        return "error";
    case Severity::warning:
        return "warning";
    case Severity::note:
        break;
    }
    return "note";
}

void Report::add(
    Severity severity, std::string rule, std::string file, unsigned line, std::string subject, std::string message) {
    std::lock_guard lock(mutex_);
    entries_.push_back({severity, std::move(rule), std::move(file), line, std::move(subject), std::move(message)});
}

void Report::rule(std::string rule, std::string file, unsigned line, std::string subject, std::string message) {
    add(strict_ ? Severity::error : Severity::warning, std::move(rule), std::move(file), line, std::move(subject),
        std::move(message));
}

void Report::warning(std::string rule, std::string file, unsigned line, std::string subject, std::string message) {
    add(Severity::warning, std::move(rule), std::move(file), line, std::move(subject), std::move(message));
}

void Report::note(std::string rule, std::string file, unsigned line, std::string subject, std::string message) {
    add(Severity::note, std::move(rule), std::move(file), line, std::move(subject), std::move(message));
}

void Report::append(const std::vector<ReportEntry>& entries) {
    std::lock_guard lock(mutex_);
    entries_.insert(entries_.end(), entries.begin(), entries.end());
}

std::vector<ReportEntry> Report::entries() const {
    std::vector<ReportEntry> sorted;
    {
        std::lock_guard lock(mutex_);
        sorted = entries_;
    }
    auto key = [](const ReportEntry& e) { return std::tie(e.file, e.line, e.rule, e.subject, e.message); };
    std::sort(
        sorted.begin(), sorted.end(), [&](const ReportEntry& a, const ReportEntry& b) { return key(a) < key(b); });
    sorted.erase(std::unique(sorted.begin(), sorted.end(),
                     [&](const ReportEntry& a, const ReportEntry& b) { return key(a) == key(b); }),
        sorted.end());
    return sorted;
}

std::size_t Report::errors() const {
    std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(std::count_if(
        entries_.begin(), entries_.end(), [](const ReportEntry& e) { return e.severity == Severity::error; }));
}

std::string Report::json(
    std::size_t headers, std::size_t declarations, std::size_t confirmed, std::size_t missing) const {
    std::vector<ReportEntry> sorted = entries();
    std::map<std::string, int> counts;
    nlohmann::json list = nlohmann::json::array();
    for (const ReportEntry& e : sorted) {
        ++counts[e.rule];
        list.push_back({{"severity", to_string(e.severity)}, {"rule", e.rule}, {"file", e.file}, {"line", e.line},
            {"subject", e.subject}, {"message", e.message}});
    }
    nlohmann::json out = {{"format", "spear-header-report"}, {"version", 1}, {"headers", headers}, {"counts", counts},
        {"ast", {{"declarations", declarations}, {"confirmed", confirmed}, {"missing", missing}}}, {"entries", list}};
    return out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace spear::header_tool
