// SPDX-License-Identifier: MIT
/** @file What the command line of spear-engine asks for. Plain types: the parser behind it throws, the engine does not.
 */
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/** The options of spear-engine, see --help. */
struct FLaunchOptions {
    /** Scene name or path; empty: an empty world. */
    std::string Scene;
    /** Frames per second at most; 0: as fast as it can. */
    double FramesPerSecond = 60.0;
    /** Seconds of game time per frame; not set: real time. */
    std::optional<double> FixedDeltaSeconds;
    /** Start value of the random numbers. */
    std::int32_t Seed = 0;
    /** Exit after that many frames; not set: run until asked to stop. */
    std::optional<std::uint64_t> Frames;
    /** Whether the world starts paused. */
    bool bPaused = false;
    /** Whether to list the actors of the scene and exit. */
    bool bPrintScene = false;
    /** Modules to load besides those of plugins. */
    std::vector<std::string> Modules;
    /** Folders searched for plugins besides <executable>/../plugins. */
    std::vector<std::string> PluginDirectories;
    /** Console commands to run when the scene is loaded. */
    std::vector<std::string> Commands;
    /** Least severity that is logged: fatal, error, warning, display, log, verbose, veryverbose. */
    std::string LogLevel = "log";
    /** File that the log goes to as well; empty: none. */
    std::string LogFile;
    /** Content folder; empty: found from the executable. */
    std::string ContentDirectory;
    /** Arguments that are for FCommandLine. */
    std::vector<std::string> EngineArguments;
};

/**
 * Parses the command line. Arguments of Unreal's form (-Key=Value, -Flag) and everything after "--" go to
 * EngineArguments.
 * @return nothing when the engine is to run, else the code to exit with: --help or an error, which has been printed.
 */
std::optional<int> ParseLaunchOptions(int ArgumentCount, char** Arguments, FLaunchOptions& OutOptions);
