// SPDX-License-Identifier: MIT
#include "run.h"

#include "ast.h"
#include "cache.h"
#include "constants.h"
#include "emit.h"
#include "files.h"
#include "progress.h"
#include "read.h"
#include "strict.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <thread>
#include <unordered_map>

namespace spear::header_tool {

namespace {

constexpr std::size_t largest_header = 16u << 20;
// Headers that are read keep their text and tokens until they are checked; beyond this many bytes of text in all they
// are let go and read once more.
constexpr std::size_t most_kept_text = 96u << 20;
constexpr std::size_t most_shown_warnings = 20;

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

// One header on its way through the run.
struct Work {
    std::unique_ptr<Header> header; // what was read; module and paths always
    bool written = true;            // of a module that is written
    bool relevant = false;          // mentions reflection
    bool scanned = false;           // `header` holds its declarations
    Hash text, key;                 // of its bytes; of its cache entry
    bool from_cache = false;
    CacheEntry entry;
};

class Dump {
public:
    explicit Dump(const DumpOptions& options)
        : options_(options), defines_(parse_defines(options.defines)), report_(options.strict),
          jobs_(options.jobs != 0 ? options.jobs : std::max(1u, std::thread::hardware_concurrency())),
          cache_(cache_folder(options), options.cache_mebibytes << 20) {}

    int run() {
        auto start = std::chrono::steady_clock::now();
        import();
        FoundModules found = find_modules(options_.places, report_);
        for (const std::string& error : found.errors)
            fmt::print(stderr, "spear-header-tool: {}\n", error);
        bool any =
            std::any_of(found.modules.begin(), found.modules.end(), [](const ModuleInfo& m) { return m.written; });
        if (!any)
            return 2;
        prepare_keys();
        list(found.modules);
        read();
        know();
        check();
        cache_.evict();
        if (std::string trouble = cache_.trouble(); !trouble.empty() && !options_.quiet)
            fmt::print(stderr,
                "spear-header-tool: no cache: {}; everything is read anew each time (--cache DIR names "
                "another folder)\n",
                trouble);
        int code = write(found.modules);
        if (!options_.quiet)
            summary(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        return code != 0 ? code : found.errors.empty() ? 0 : 2;
    }

private:
    static std::string cache_folder(const DumpOptions& options) {
        return options.no_cache ? std::string() : options.cache.value_or(default_cache_folder());
    }

    void import() {
        for (const std::string& file : options_.imports)
            try {
                registry_.import_schema(read_json(file), file);
            } catch (const nlohmann::json::exception& e) {
                throw UserError(fmt::format("--import {}: not a complete spear-schema file: {}", file, e.what()));
            }
    }

    // What every key contains: the program, its libclang, the options that change what is found in a header.
    void prepare_keys() {
        std::optional<Hash> fingerprint = cache_.enabled() ? tool_fingerprint() : std::nullopt;
        caching_ = fingerprint.has_value();
        if (!caching_)
            return;
        Hasher hasher;
        hasher.add(fingerprint->text()).add(clang_version()).add(options_.strict);
        for (const auto& [name, value] : defines_)
            hasher.add(name).add(value);
        run_key_ = hasher.hash();
    }

    void list(const std::vector<ModuleInfo>& modules) {
        std::unordered_map<std::string, bool> written;
        for (const ModuleInfo& m : modules)
            written[m.name] = m.written;
        for (std::unique_ptr<Header>& header : find_headers(modules, report_)) {
            Work work;
            work.written = written[header->module];
            work.header = std::move(header);
            works_.push_back(std::move(work));
        }
    }

    // The bytes of a header, or nothing and a report entry.
    std::optional<std::string> bytes_of(const Header& header, Report& report) const {
        try {
            std::error_code error;
            std::uintmax_t size = std::filesystem::file_size(header.path, error);
            if (error || size <= largest_header)
                return read_file(header.path);
            report.rule("too-large", header.path, 1, header.relative,
                fmt::format("has {} bytes, more than {} are no header; it is skipped", size, largest_header));
        } catch (const std::exception& e) {
            report.rule("unreadable", header.path, 1, header.relative, e.what());
        }
        return std::nullopt;
    }

    // Fills work.header's declarations and work.entry's facts.
    void scan_header(Work& work, std::string bytes) {
        Report found(options_.strict);
        try {
            read_header(*work.header, std::move(bytes), defines_, found);
            if (work.header->source) {
                work.entry.facts = collect_facts(*work.header);
                work.scanned = true;
            }
        } catch (const std::exception& e) {
            found.rule("unreadable", work.header->path, 1, work.header->relative, e.what());
            work.entry.facts = {};
        }
        work.entry.scan_report = found.entries();
    }

    void read() {
        Progress progress("reading", works_.size(), options_.quiet);
        std::atomic<std::size_t> kept{0};
        parallel(works_.size(), jobs_, [&](std::size_t i) {
            Work& work = works_[i];
            Report found(options_.strict);
            if (std::optional<std::string> bytes = bytes_of(*work.header, found)) {
                work.relevant = mentions_reflection(*bytes);
                if (work.relevant)
                    read_one(work, std::move(*bytes), kept);
            }
            if (work.written)
                report_.append(found.entries());
            progress.step();
        });
    }

    void read_one(Work& work, std::string bytes, std::atomic<std::size_t>& kept) {
        const Header& h = *work.header;
        work.text = hash_bytes(bytes);
        if (caching_) {
            Hasher hasher;
            hasher.add(run_key_.low).add(run_key_.high).add(work.text.low).add(work.text.high);
            work.key = hasher.add(h.module).add(h.path).add(h.relative).hash();
            if (std::optional<CacheEntry> entry = cache_.load(work.key)) {
                work.entry = std::move(*entry);
                work.from_cache = true;
                return;
            }
        }
        std::size_t size = bytes.size();
        scan_header(work, std::move(bytes));
        if (caching_ && !work.written)
            cache_.store(work.key, work.entry);
        if (!work.entry.facts.reflected || !work.written || (kept += size) > most_kept_text)
            forget(work);
    }

    // Lets go of what can be read again.
    static void forget(Work& work) {
        auto fresh = std::make_unique<Header>();
        fresh->module = work.header->module;
        fresh->path = work.header->path;
        fresh->relative = work.header->relative;
        fresh->include = work.header->include;
        work.header = std::move(fresh);
        work.scanned = false;
    }

    // Tells the registry every header's facts, the written modules first: their types win over others of the same name.
    void know() {
        Report others(options_.strict); // an engine's own trouble is not this run's
        for (bool written : {true, false})
            for (Work& work : works_)
                if (work.relevant && work.written == written) {
                    const HeaderFacts& facts = work.entry.facts;
                    if (facts.reflected)
                        registry_.add(facts, work.header->module, work.header->path, written ? report_ : others);
                    else
                        registry_.add_constants(facts.constants);
                }
        find_more_constants();
        registry_.finish(report_);
    }

    // Constants that only headers without reflection define: those are searched for the names that nothing explains.
    void find_more_constants() {
        std::set<std::string> wanted, searched;
        for (const Work& work : works_)
            if (work.written)
                for (const std::string& name : work.entry.facts.asked)
                    if (!registry_.explains(name))
                        wanted.insert(name.substr(name.rfind(':') + 1));
        for (int round = 0; round < 3 && !wanted.empty(); ++round) {
            std::vector<std::vector<ConstantFacts>> found(works_.size());
            parallel(works_.size(), jobs_, [&](std::size_t i) {
                if (!works_[i].relevant)
                    found[i] = constants_in(*works_[i].header, wanted);
            });
            searched.merge(wanted);
            wanted.clear();
            for (const std::vector<ConstantFacts>& constants : found) {
                registry_.add_constants(constants);
                for (const ConstantFacts& constant : constants)
                    for (const std::string& name : names_in(constant.text))
                        if (std::string last = name.substr(name.rfind(':') + 1);
                            !registry_.explains(last) && !searched.contains(last))
                            wanted.insert(last);
            }
        }
    }

    // Definitions of wanted names in a header that has no reflected types.
    std::vector<ConstantFacts> constants_in(const Header& header, const std::set<std::string>& wanted) const {
        Report ignored(false);
        std::optional<std::string> bytes = bytes_of(header, ignored);
        bool any = bytes && std::any_of(wanted.begin(), wanted.end(),
                                [&](const std::string& name) { return bytes->find(name) != std::string::npos; });
        if (!any || !SourceText::looks_like_text(*bytes))
            return {};
        SourceText source(SourceText::to_utf8(std::move(*bytes)));
        std::vector<ConstantFacts> out = find_constants(lex(source, {}));
        std::erase_if(
            out, [&](const ConstantFacts& c) { return !wanted.contains(c.name.substr(c.name.rfind(':') + 1)); });
        return out;
    }

    bool still_holds(const CacheEntry& entry) const {
        return entry.has_result &&
               std::all_of(entry.questions.begin(), entry.questions.end(),
                   [&](const auto& question) { return registry_.fact(question.first) == question.second; });
    }

    void check() {
        std::vector<Work*> todo;
        for (Work& work : works_)
            if (work.relevant && work.written)
                todo.push_back(&work);
        Progress progress("checking", todo.size(), options_.quiet);
        parallel(todo.size(), jobs_, [&](std::size_t i) {
            Work& work = *todo[i];
            bool checked = work.entry.facts.reflected && !still_holds(work.entry);
            if (checked)
                check_one(work);
            else if (work.from_cache)
                ++reused_;
            if (caching_ && (checked || !work.from_cache))
                cache_.store(work.key, work.entry);
            forget(work);
            progress.step();
        });
    }

    void check_one(Work& work) {
        Report found(options_.strict);
        CacheEntry& entry = work.entry;
        entry.has_result = false;
        entry.questions.clear();
        entry.fragments.clear();
        entry.statistics = {};
        try {
            if (!work.scanned) {
                std::string bytes = read_file(work.header->path);
                if (hash_bytes(bytes) != work.text)
                    throw UserError("changed while it was read; run again");
                Report again(options_.strict); // what reading it reports is in the entry already
                read_header(*work.header, std::move(bytes), defines_, again);
                if (!work.header->source)
                    throw UserError("is no text any more");
            }
            Trace trace;
            Registry::set_trace(&trace);
            entry.statistics = check_with_ast(*work.header, registry_, defines_, found);
            check_rules(*work.header, registry_, found);
            entry.fragments = emit_header(*work.header, registry_, found);
            Registry::set_trace(nullptr);
            for (const std::string& question : trace)
                entry.questions.emplace_back(question, registry_.fact(question));
            entry.has_result = true;
        } catch (const std::exception& e) {
            Registry::set_trace(nullptr);
            found.rule("unreadable", work.header->path, 1, work.header->relative,
                std::string("could not be read: ") + e.what() + "; the header is skipped");
        }
        entry.check_report = found.entries();
    }

    int write(const std::vector<ModuleInfo>& modules) {
        std::vector<HeaderEntry> headers;
        std::vector<const Fragment*> fragments;
        std::vector<std::string> read;
        for (const Work& work : works_) {
            if (work.relevant && work.entry.facts.reflected)
                read.push_back(work.header->path);
            if (!work.written || !work.relevant)
                continue;
            report_.append(work.entry.scan_report);
            report_.append(work.entry.check_report);
            if (!work.entry.facts.reflected)
                continue;
            const HeaderFacts& facts = work.entry.facts;
            headers.push_back(
                {work.header->module, work.header->relative, work.header->include, facts.generated, facts.type_names});
            for (const Fragment& fragment : work.entry.fragments)
                fragments.push_back(&fragment);
            total_.declarations += work.entry.statistics.declarations;
            total_.confirmed += work.entry.statistics.confirmed;
            total_.missing += work.entry.statistics.missing;
        }
        headers_ = headers.size();
        if (!options_.report.empty())
            write_file(options_.report, report_.json(headers_, total_.declarations, total_.confirmed, total_.missing));
        print_report();
        if (std::size_t errors = report_.errors(); errors > 0) {
            fmt::print(stderr, "spear-header-tool: {} error{}; {} was not written\n", errors, errors == 1 ? "" : "s",
                options_.output);
            return 1;
        }
        write_file(options_.output, [&](std::ostream& out) { emit_document(out, modules, headers, fragments); });
        if (!options_.depfile.empty())
            write_depfile(options_.depfile, options_.output, read, options_.imports);
        return 0;
    }

    // Every error; the first warnings, and how many more there are.
    void print_report() const {
        std::size_t warnings = 0;
        for (const ReportEntry& e : report_.entries()) {
            warnings += e.severity == Severity::warning ? 1 : 0;
            if (e.severity == Severity::note ||
                (e.severity == Severity::warning && (options_.quiet || warnings > most_shown_warnings)))
                continue;
            fmt::print(stderr, "{}:{}: {}: {}: {} [{}]\n", e.file, e.line, to_string(e.severity), e.subject, e.message,
                e.rule);
        }
        if (warnings > most_shown_warnings && !options_.quiet)
            fmt::print(stderr, "... and {} warnings more: --report FILE writes all\n", warnings - most_shown_warnings);
    }

    void summary(double seconds) const {
        std::map<std::string, std::size_t> rules;
        for (const ReportEntry& e : report_.entries())
            ++rules[e.rule];
        std::string doubts;
        for (const auto& [rule, count] : rules)
            doubts += fmt::format("{}{} {}", doubts.empty() ? "" : ", ", count, rule);
        fmt::print(stderr,
            "{} of {} headers hold reflection{}; {} of {} written types confirmed by libclang; {:.2f} s\n", headers_,
            works_.size(), reused_ > 0 ? fmt::format(" ({} unchanged, from the cache)", reused_.load()) : "",
            total_.confirmed, total_.declarations, seconds);
        fmt::print(stderr, "report: {}\n", doubts.empty() ? "nothing skipped or doubtful" : doubts);
    }

    const DumpOptions& options_;
    Defines defines_;
    Report report_;
    unsigned jobs_;
    Cache cache_;
    bool caching_ = false;
    Hash run_key_;
    Registry registry_;
    std::vector<Work> works_;
    std::atomic<std::size_t> reused_{0};
    std::size_t headers_ = 0;
    AstStatistics total_;
};

} // namespace

int run_dump(const DumpOptions& options) { return Dump(options).run(); }

} // namespace spear::header_tool
