// SPDX-License-Identifier: MIT
#include "run.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

int main(int argc, char** argv) {
    using namespace spear::header_tool;
    CLI::App app{
        "Reads Unreal Engine C++ headers, with or without an engine, and writes their reflection as schema.json.",
        "spear-header-tool"};
    app.require_subcommand(1);
    app.footer("The format is described in codegen/SCHEMA.md. Exit codes: 0 written, 1 --strict found errors, 2 wrong "
               "arguments or files.");
    DumpOptions options;
    CLI::App* dump = app.add_subcommand("dump", "Write the schema of one or several modules.");
    dump->add_option("--module", options.modules,
            "NAME=DIR: a module and the folder that holds its Public/ and Private/. DIR alone: every module whose "
            "*.Build.cs lies in or below it. Repeatable.")
        ->required()
        ->take_all()
        ->type_name("NAME=DIR");
    dump->add_option("--import", options.imports,
            "Schema of a module this one depends on; its types are known, not written again. Repeatable.")
        ->type_name("FILE");
    dump->add_option("--define", options.defines,
            "Preprocessor macro, e.g. WITH_EDITOR=0. Default: as UHT (CPP=0 WITH_EDITOR=1 WITH_EDITORONLY_DATA=1). "
            "Repeatable.")
        ->type_name("NAME=VALUE");
    dump->add_flag(
        "--strict", options.strict, "Whatever Unreal's own header tool rejects is an error; nothing is written then.");
    dump->add_option("--jobs", options.jobs, "Threads (default: one per core).")->type_name("N");
    dump->add_option("--report", options.report,
            "Write everything skipped, assumed or doubtful, with file, line and reason, as JSON.")
        ->type_name("FILE");
    dump->add_option("--depfile", options.depfile, "Write a Makefile fragment with the headers that were read.")
        ->type_name("FILE");
    dump->add_flag("-q,--quiet", options.quiet, "Print errors only.");
    dump->add_option("-o,--output", options.output, "The schema to write.")->required()->type_name("FILE");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    try {
        return run_dump(options);
    } catch (const std::exception& e) {
        fmt::print(stderr, "spear-header-tool: {}\n", e.what());
        return 2;
    }
}
