// SPDX-License-Identifier: MIT
#include "PluginDescriptor.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

namespace {
namespace fs = std::filesystem;

FPluginDescriptor ReadPlugin(const fs::path& Path) {
    std::ifstream File(Path);
    if (!File) {
        throw std::runtime_error("the file cannot be opened");
    }
    const nlohmann::json Json = nlohmann::json::parse(File, nullptr, true, true);
    FPluginDescriptor Plugin;
    Plugin.Name = Path.stem().string();
    Plugin.Directory = Path.parent_path().string();
    Plugin.bEnabledByDefault = Json.value("EnabledByDefault", true);
    for (const nlohmann::json& Module : Json.value("Modules", nlohmann::json::array())) {
        FPluginModule Read;
        Read.Name = Module.at("Name").get<std::string>();
        Read.Type = Module.value("Type", "Runtime");
        Read.LoadingPhase = Module.value("LoadingPhase", "Default");
        Plugin.Modules.push_back(std::move(Read));
    }
    for (const nlohmann::json& Dependency : Json.value("Plugins", nlohmann::json::array())) {
        if (Dependency.value("Enabled", true) && !Dependency.value("Optional", false)) {
            Plugin.Dependencies.push_back(Dependency.at("Name").get<std::string>());
        }
    }
    return Plugin;
}

void FindDescriptors(const fs::path& Directory, std::vector<fs::path>& OutPaths) {
    std::error_code Error;
    for (const fs::directory_entry& Entry : fs::directory_iterator(Directory, Error)) {
        if (Entry.path().extension() == ".uplugin") {
            OutPaths.push_back(Entry.path());
        }
    }
}
} // namespace

std::vector<FPluginDescriptor> ReadPlugins(const std::string& Directory, std::vector<std::string>& OutErrors) {
    std::vector<fs::path> Paths;
    FindDescriptors(Directory, Paths);
    std::error_code Error;
    for (const fs::directory_entry& Entry : fs::directory_iterator(Directory, Error)) {
        if (Entry.is_directory(Error)) {
            FindDescriptors(Entry.path(), Paths);
        }
    }
    std::sort(Paths.begin(), Paths.end());

    std::vector<FPluginDescriptor> Plugins;
    for (const fs::path& Path : Paths) {
        try {
            Plugins.push_back(ReadPlugin(Path));
        } catch (const std::exception& Exception) {
            OutErrors.push_back("Cannot read the plugin " + Path.string() + ": " + Exception.what());
        }
    }
    return Plugins;
}

std::vector<FPluginDescriptor> SortPlugins(
    std::vector<FPluginDescriptor> Plugins, std::vector<std::string>& OutErrors) {
    std::map<std::string, const FPluginDescriptor*> ByName;
    for (const FPluginDescriptor& Plugin : Plugins) {
        if (!ByName.emplace(Plugin.Name, &Plugin).second) {
            OutErrors.push_back("The plugin " + Plugin.Name + " is in " + ByName[Plugin.Name]->Directory + " and in " +
                                Plugin.Directory + "; the first is used");
        }
    }
    std::vector<FPluginDescriptor> Sorted;
    std::map<std::string, bool> Visited;
    const std::function<void(const FPluginDescriptor&)> Visit = [&](const FPluginDescriptor& Plugin) {
        if (Visited[Plugin.Name]) {
            return;
        }
        Visited[Plugin.Name] = true;
        for (const std::string& Dependency : Plugin.Dependencies) {
            const auto Found = ByName.find(Dependency);
            if (Found == ByName.end()) {
                OutErrors.push_back(
                    "The plugin " + Plugin.Name + " needs the plugin " + Dependency + ", which was not found");
            } else {
                Visit(*Found->second);
            }
        }
        Sorted.push_back(Plugin);
    };
    for (const FPluginDescriptor& Plugin : Plugins) {
        Visit(*ByName[Plugin.Name]);
    }
    return Sorted;
}
