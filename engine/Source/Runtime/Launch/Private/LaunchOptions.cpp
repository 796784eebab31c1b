// SPDX-License-Identifier: MIT
#include "LaunchOptions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>

std::optional<int> ParseLaunchOptions(int ArgumentCount, char** Arguments, FLaunchOptions& OutOptions) {
    // Unreal's own arguments have one dash and are for FCommandLine: they never reach the parser, which would read them
    // as bundles of one-letter options. Numbers like -1 are values.
    std::vector<std::string> OwnArguments;
    bool bRestIsForEngine = false;
    for (int Index = 1; Index < ArgumentCount; ++Index) {
        const std::string Argument = Arguments[Index];
        const bool bUnrealForm =
            Argument.size() > 1 && Argument[0] == '-' && std::isalpha(static_cast<unsigned char>(Argument[1]));
        if (!bRestIsForEngine && Argument == "--") {
            bRestIsForEngine = true;
        } else if (bRestIsForEngine || bUnrealForm) {
            OutOptions.EngineArguments.push_back(Argument);
        } else {
            OwnArguments.push_back(Argument);
        }
    }

    CLI::App App{
        "Runs the embedded engine without a window.\n"
        "Arguments of the form -Key=Value or -Flag, and everything after --, are kept for the engine and its plugins,\n"
        "for instance -SpearAddress=unix:/tmp/spear.sock, -ResX=1920, -EnablePlugins=A,B."};
    App.name("spear-engine");
    App.set_help_flag("--help", "Print this help and exit");
    App.add_option("--scene", OutOptions.Scene,
           "Scene to load: a name below the content folder, or a .gltf, .glb or .scene.json file")
        ->type_name("NAME|PATH");
    App.add_option("--fps", OutOptions.FramesPerSecond, "Frames per second at most; 0: as fast as it can")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    App.add_option(
           "--fixed-dt", OutOptions.FixedDeltaSeconds, "Game time of each frame, in seconds; without it, real time")
        ->check(CLI::PositiveNumber)
        ->type_name("SECONDS");
    App.add_option("--seed", OutOptions.Seed, "Start value of the random numbers")->capture_default_str();
    App.add_option("--frames", OutOptions.Frames, "Exit after this many frames")->type_name("N");
    App.add_flag("--paused", OutOptions.bPaused, "Start with the world paused");
    App.add_flag("--print-scene", OutOptions.bPrintScene, "List the actors of the scene and exit");
    // One value each time: a list of values would swallow what follows.
    App.add_option("--module", OutOptions.Modules, "Module to load at start; may be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    App.add_option("--plugin-dir", OutOptions.PluginDirectories, "Folder searched for *.uplugin; may be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    App.add_option("--exec", OutOptions.Commands, "Console command to run when the scene is loaded; may be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    App.add_option("--log", OutOptions.LogLevel, "Least severity that is logged")
        ->check(
            CLI::IsMember({"fatal", "error", "warning", "display", "log", "verbose", "veryverbose"}, CLI::ignore_case))
        ->capture_default_str();
    App.add_option("--log-file", OutOptions.LogFile, "File that the log is written to as well")->type_name("PATH");
    App.add_option("--content-dir", OutOptions.ContentDirectory,
           "Content folder; without it, SPEAR_CONTENT_DIR or the one near the executable")
        ->type_name("DIR");

    try {
        std::reverse(OwnArguments.begin(), OwnArguments.end());
        App.parse(OwnArguments);
    } catch (const CLI::ParseError& Error) {
        return App.exit(Error);
    }
    return std::nullopt;
}
