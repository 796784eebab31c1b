// SPDX-License-Identifier: MIT
/** @file Plugins, as their .uplugin files describe them. Plain types: the parser behind it throws, the engine does not.
 */
#pragma once

#include <string>
#include <vector>

/** One module of a plugin. */
struct FPluginModule {
    std::string Name;
    /** "Runtime", "Editor", ... */
    std::string Type;
    /** "PreDefault", "Default", "PostEngineInit", ... */
    std::string LoadingPhase;
};

/** One plugin. */
struct FPluginDescriptor {
    /** Name: that of the file. */
    std::string Name;
    /** Folder of the file. */
    std::string Directory;
    bool bEnabledByDefault = true;
    std::vector<FPluginModule> Modules;
    /** Names of the plugins that this one needs. */
    std::vector<std::string> Dependencies;
};

/**
 * Finds and reads the plugins in a folder: its own *.uplugin files and those of its direct subfolders, in alphabetical
 * order.
 * @param OutErrors receives one text for each file that could not be read, naming it.
 */
std::vector<FPluginDescriptor> ReadPlugins(const std::string& Directory, std::vector<std::string>& OutErrors);

/** Orders plugins so that each comes after those it depends on; names found twice keep the first. */
std::vector<FPluginDescriptor> SortPlugins(std::vector<FPluginDescriptor> Plugins, std::vector<std::string>& OutErrors);
