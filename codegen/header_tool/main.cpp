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
    app.footer(
        "The format is described in codegen/SCHEMA.md.\n\nExit codes: 0 written; 1 --strict found errors, nothing was "
        "written; 2 wrong arguments, or a place that could not be used (what the others hold was written).");
    DumpOptions options;
    CLI::App* dump = app.add_subcommand("dump", "Write the schema of modules, plugins, projects or an engine.");
    dump->footer(
        "Examples:\n"
        "  spear-header-tool dump --project MyGame/MyGame.uproject -o schema.json\n"
        "  spear-header-tool dump --project MyGame --engine /opt/UnrealEngine -o schema.json --report report.json\n"
        "  spear-header-tool dump --engine /opt/UnrealEngine -o engine.schema.json\n"
        "  spear-header-tool dump --module Foo=Source/Foo --import engine.schema.json --strict -o foo.schema.json");
    dump->add_option("--module", options.places.modules,
            "NAME=DIR: a module and the folder that holds its Public/ and Private/. DIR alone: every module whose "
            "*.Build.cs lies in or below it. Repeatable.")
        ->take_all()
        ->type_name("NAME=DIR");
    dump->add_option("--project", options.places.projects,
            "A project, or its folder: all modules of its Source/, and of all plugins below Plugins/ (also those it "
            "does "
            "not enable) and its AdditionalPluginDirectories. Repeatable.")
        ->take_all()
        ->type_name("X.uproject");
    dump->add_option(
            "--plugin", options.places.plugins, "A plugin, or its folder: all modules of its Source/. Repeatable.")
        ->take_all()
        ->type_name("X.uplugin");
    dump->add_option("--engine", options.places.engine,
            "The folder that holds Engine/. The types of its modules and plugins are then known exactly; they are "
            "written only with --write-engine, or when nothing else is named.")
        ->type_name("DIR");
    dump->add_flag("--write-engine", options.places.write_engine, "Write the modules of --engine too.");
    dump->add_option("--import", options.imports,
            "Schema of a module this one depends on; its types are known, not written again. Repeatable.")
        ->type_name("FILE");
    dump->add_option("--define", options.defines,
            "Preprocessor macro, e.g. WITH_EDITOR=0. Default: as UHT (CPP=0 WITH_EDITOR=1 WITH_EDITORONLY_DATA=1). "
            "Repeatable.")
        ->type_name("NAME=VALUE");
    dump->add_flag(
        "--strict", options.strict, "Whatever Unreal's own header tool rejects is an error; nothing is written then.");
    dump->add_option("--cache", options.cache,
            "Folder for what is known of unchanged headers (default: $XDG_CACHE_HOME/spear/headers, or below "
            "~/.cache). The output does not depend on it.")
        ->type_name("DIR");
    dump->add_flag("--no-cache", options.no_cache, "Read every header anew, store nothing.");
    dump->add_option("--cache-size", options.cache_mebibytes,
            "Largest size of the cache in MiB; what was not used for the longest time goes first (default: 1024).")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 20))
        ->type_name("MIB");
    dump->add_option("--jobs", options.jobs, "Threads (default: one per core).")->type_name("N");
    dump->add_option("--report", options.report,
            "Write everything skipped, assumed or doubtful, with file, line and reason, as JSON.")
        ->type_name("FILE");
    dump->add_option("--depfile", options.depfile, "Write a Makefile fragment with the headers that were read.")
        ->type_name("FILE");
    dump->add_flag("-q,--quiet", options.quiet, "Print errors only, no progress.");
    dump->add_option("-o,--output", options.output, "The schema to write.")->required()->type_name("FILE");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    if (options.places.modules.empty() && options.places.projects.empty() && options.places.plugins.empty() &&
        options.places.engine.empty()) {
        fmt::print(stderr,
            "spear-header-tool: nothing to read: give --module, --project, --plugin or --engine (dump --help "
            "has examples)\n");
        return 2;
    }
    try {
        return run_dump(options);
    } catch (const std::exception& e) {
        fmt::print(stderr, "spear-header-tool: {}\n", e.what());
        return 2;
    }
}
