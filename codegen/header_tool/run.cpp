// SPDX-License-Identifier: MIT
#include "run.h"

#include "ast.h"
#include "emit.h"
#include "files.h"
#include "scan.h"
#include "strict.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>
#include <unistd.h>

namespace spear::header_tool {

namespace {

// A bar on a terminal, silence elsewhere.
class Progress {
public:
    Progress(std::string title, std::size_t total, bool quiet)
        : title_(std::move(title)), total_(total), shown_(!quiet && isatty(2) && total > 0) {}

    void step() {
        std::size_t done = ++done_;
        if (!shown_ || (done % 8 != 0 && done != total_))
            return;
        std::size_t width = 30, filled = width * done / total_;
        std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
        fmt::print(stderr, "\r{:<10} [{}] {}/{}{}", title_, bar, done, total_, done == total_ ? "\n" : "");
        std::fflush(stderr);
    }

private:
    std::string title_;
    std::size_t total_;
    bool shown_;
    std::atomic<std::size_t> done_{0};
};

void parallel(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    auto loop = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < jobs && i < count; ++i)
        threads.emplace_back(loop);
    loop();
}

Defines parse_defines(const std::vector<std::string>& defines) {
    Defines out = default_defines();
    for (const std::string& define : defines) {
        std::size_t equals = define.find('=');
        std::string name = define.substr(0, equals);
        if (name.empty())
            throw UserError(fmt::format("--define '{}': expected NAME=VALUE", define));
        out[name] = equals == std::string::npos ? "1" : define.substr(equals + 1);
    }
    return out;
}

// Macro calls in inactive branches are not declared; say so unless the branch is one that a build leaves out on
// purpose.
void note_inactive(const Header& header, const LexResult& whole, Report& report) {
    for (std::size_t i = 0; i < end_index(whole.tokens); ++i) {
        const Token& t = whole.tokens[i];
        if (!t.identifier() || !is_reflection_macro(t.text) || !whole.tokens[i + 1].is("("))
            continue;
        for (const ByteRange& range : header.skipped)
            if (range.contains(t.begin))
                report.note("inactive-region", header.path, header.source->line(t.begin), std::string(t.text),
                    "stands in an inactive #if branch; not declared");
    }
}

// Last line of defence against silent skips.
void report_unseen(const Header& header, Report& report) {
    const std::vector<Token>& tokens = header.lexed.tokens;
    for (std::size_t i = 0; i < end_index(tokens); ++i)
        if (tokens[i].identifier() && is_reflection_macro(tokens[i].text) && tokens[i + 1].is("(") &&
            !header.seen_macros.contains(tokens[i].begin))
            report.rule("unparsed-declaration", header.path, header.source->line(tokens[i].begin),
                std::string(tokens[i].text),
                "was passed over: the text around it could not be understood; the declaration is skipped");
}

void find_generated_include(Header& header) {
    for (const Directive& d : header.lexed.directives) {
        if (d.name != "include")
            continue;
        std::size_t open = d.rest.find_first_of("\"<"), close = d.rest.find_first_of("\">", open + 1);
        if (open == std::string::npos || close == std::string::npos)
            continue;
        std::string file = d.rest.substr(open + 1, close - open - 1);
        if (file.ends_with(".generated.h"))
            header.generated = file.substr(file.rfind('/') + 1);
    }
}

// Gives each UINTERFACE its I class.
void join_interfaces(Header& header, Report& report) {
    for (Class& c : header.classes) {
        if (!c.interface)
            continue;
        std::string native = "I" + c.name.substr(1);
        auto it = std::find_if(header.native_interfaces.begin(), header.native_interfaces.end(),
            [&](const Record& r) { return r.name == native; });
        if (it == header.native_interfaces.end())
            continue;
        c.native = std::make_shared<Record>(std::move(*it));
        header.native_interfaces.erase(it);
    }
    for (const Record& r : header.native_interfaces)
        report.rule("orphan-macro", header.path, r.line, r.name,
            "has GENERATED_BODY() but no UINTERFACE in this header; its functions are skipped");
    header.native_interfaces.clear();
}

void read_header(Header& header, const Defines& defines, Report& report) {
    std::string bytes = read_file(header.path);
    if (!SourceText::looks_like_text(bytes)) {
        report.rule("not-text", header.path, 1, header.relative, "is a binary file; it is skipped");
        return;
    }
    header.source = std::make_unique<SourceText>(SourceText::to_utf8(std::move(bytes)));
    const std::string& text = header.source->bytes();
    bool mentions = text.find(".generated.h") != std::string::npos || text.find("UCLASS") != std::string::npos ||
                    text.find("USTRUCT") != std::string::npos || text.find("UENUM") != std::string::npos ||
                    text.find("UINTERFACE") != std::string::npos ||
                    text.find("DECLARE_DYNAMIC_") != std::string::npos || text.find("UPROPERTY") != std::string::npos ||
                    text.find("UFUNCTION") != std::string::npos;
    if (!mentions)
        return;
    LexResult whole = lex(*header.source, {});
    ConditionMap conditions(whole.directives);
    header.skipped = inactive_branches(*header.source, whole.directives, conditions, defines);
    if (!header.skipped.empty())
        note_inactive(header, whole, report);
    header.lexed = lex(*header.source, header.skipped);
    find_generated_include(header);
    bool macro_definitions = false; // the headers that define the macros themselves
    for (const Directive& d : header.lexed.directives)
        macro_definitions |= d.name == "define" && (d.rest.starts_with("UCLASS(") || d.rest.starts_with("UPROPERTY("));
    if (macro_definitions)
        return;
    scan(header, conditions, report);
    report_unseen(header, report);
    join_interfaces(header, report);
    header.reflected = !header.generated.empty() || !header.type_names.empty();
}

} // namespace

int run_dump(const DumpOptions& options) {
    auto start = std::chrono::steady_clock::now();
    Defines defines = parse_defines(options.defines);
    Report report(options.strict);
    Registry registry;
    for (const std::string& file : options.imports)
        try {
            registry.import_schema(read_json(file), file);
        } catch (const nlohmann::json::exception& e) {
            throw UserError(fmt::format("--import {}: not a complete spear-schema file: {}", file, e.what()));
        }
    std::vector<ModuleInfo> modules = find_modules(options.modules);
    std::vector<std::unique_ptr<Header>> headers = find_headers(modules);
    unsigned jobs = options.jobs != 0 ? options.jobs : std::max(1u, std::thread::hardware_concurrency());

    Progress reading("reading", headers.size(), options.quiet);
    parallel(headers.size(), jobs, [&](std::size_t i) {
        try {
            read_header(*headers[i], defines, report);
        } catch (const std::exception& e) {
            report.rule("unreadable", headers[i]->path, 1, headers[i]->relative, e.what());
        }
        reading.step();
    });
    std::erase_if(headers, [](const auto& h) { return !h->reflected; });
    for (const auto& h : headers)
        registry.add(*h, report);
    registry.finish(report);

    std::vector<HeaderJson> parts(headers.size());
    std::vector<AstStatistics> statistics(headers.size());
    Progress checking("checking", headers.size(), options.quiet);
    parallel(headers.size(), jobs, [&](std::size_t i) {
        statistics[i] = check_with_ast(*headers[i], registry, defines, report);
        check_rules(*headers[i], registry, report);
        checking.step();
    });
    parallel(headers.size(), jobs, [&](std::size_t i) { parts[i] = emit_header(*headers[i], registry, report); });

    AstStatistics total;
    for (const AstStatistics& s : statistics) {
        total.declarations += s.declarations;
        total.confirmed += s.confirmed;
        total.missing += s.missing;
    }
    if (!options.report.empty())
        write_file(options.report, report.json(headers.size(), total.declarations, total.confirmed, total.missing));
    std::size_t warnings = 0;
    for (const ReportEntry& e : report.entries()) {
        warnings += e.severity == Severity::warning;
        if (e.severity == Severity::error || (e.severity == Severity::warning && !options.quiet))
            fmt::print(stderr, "{}:{}: {}: {}: {} [{}]\n", e.file, e.line, to_string(e.severity), e.subject, e.message,
                e.rule);
    }
    if (report.errors() > 0) {
        fmt::print(stderr, "spear-header-tool: {} error{}; {} was not written\n", report.errors(),
            report.errors() == 1 ? "" : "s", options.output);
        return 1;
    }
    nlohmann::json document = emit_document(modules, headers, parts);
    write_file(options.output, document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    if (!options.depfile.empty())
        write_depfile(options.depfile, options.output, headers, options.imports);
    if (!options.quiet && isatty(2)) {
        double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        fmt::print(stderr, "{} headers, {} of {} written types confirmed by the AST, {} warnings, {:.2f} s\n",
            headers.size(), total.confirmed, total.declarations, warnings, seconds);
    }
    return 0;
}

} // namespace spear::header_tool
