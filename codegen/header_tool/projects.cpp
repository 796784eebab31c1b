// SPDX-License-Identifier: MIT
#include "projects.h"

#include "files.h"
#include "run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <sys/stat.h>
#include <tuple>

namespace spear::header_tool {

namespace fs = std::filesystem;

namespace {

constexpr int deepest_folder = 60;

class Walker {
public:
    Walker(Report& report, const std::function<bool(const std::string&)>& skip,
        const std::function<void(const std::string&, const std::string&)>& use)
        : report_(report), skip_(skip), use_(use) {}

    void folder(const std::string& path, int depth) {
        struct stat status{};
        if (stat(path.c_str(), &status) != 0 || !visited_.insert({status.st_dev, status.st_ino}).second)
            return; // a link to a folder that was seen already
        std::error_code error;
        fs::directory_iterator it(path, error), end;
        std::vector<std::string> names;
        for (; !error && it != end; it.increment(error))
            names.push_back(it->path().filename().string());
        if (error)
            report_.warning("unreadable", path, 1, fs::path(path).filename().string(),
                "cannot read folder: " + error.message() + "; what it holds is skipped");
        std::sort(names.begin(), names.end());
        for (const std::string& name : names) {
            std::string full = path + "/" + name;
            if (stat(full.c_str(), &status) != 0)
                continue; // a broken link
            if (S_ISREG(status.st_mode))
                use_(full, name);
            else if (S_ISDIR(status.st_mode) && depth < deepest_folder && !skip_(name))
                folder(full, depth + 1);
        }
    }

private:
    Report& report_;
    const std::function<bool(const std::string&)>& skip_;
    const std::function<void(const std::string&, const std::string&)>& use_;
    std::set<std::pair<dev_t, ino_t>> visited_;
};

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

std::string clean(std::string path) {
    while (path.size() > 1 && path.ends_with('/'))
        path.pop_back();
    return path;
}

class Finder {
public:
    explicit Finder(Report& report) : report_(report) {}

    FoundModules run(const Places& places) {
        for (const std::string& argument : places.modules)
            module(argument);
        for (const std::string& argument : places.projects)
            project(argument);
        for (const std::string& argument : places.plugins)
            plugin(argument);
        if (!places.engine.empty()) {
            bool alone = places.modules.empty() && places.projects.empty() && places.plugins.empty();
            engine(places.engine, alone || places.write_engine);
        }
        FoundModules out;
        for (const auto& [name, info] : found_)
            out.modules.push_back(info);
        std::sort(out.modules.begin(), out.modules.end(), [](const ModuleInfo& a, const ModuleInfo& b) {
            return std::tie(b.written, a.name) < std::tie(a.written, b.name);
        });
        out.errors = std::move(errors_);
        return out;
    }

private:
    void add(ModuleInfo info, bool named) {
        auto [it, fresh] = found_.emplace(info.name, info);
        if (fresh) {
            if (named)
                named_.insert(info.name);
            return;
        }
        std::error_code error;
        if (fs::weakly_canonical(it->second.path, error) == fs::weakly_canonical(info.path, error)) {
            it->second.written |= info.written;
            return;
        }
        if (named && named_.contains(info.name))
            throw UserError(
                fmt::format("--module {}={}: module {} was found twice, in {} and {}; name only one of them", info.name,
                    info.path, info.name, it->second.path, info.path));
        if (info.written || !it->second.written)
            report_.warning("duplicate-module", info.path, 1, info.name,
                "a module of this name was already found in " + it->second.path +
                    "; this one is skipped (NAME=DIR chooses)");
    }

    void module(const std::string& argument) {
        std::size_t equals = argument.find('=');
        if (equals != std::string::npos) {
            ModuleInfo info{argument.substr(0, equals), clean(argument.substr(equals + 1)), "", true};
            bool valid = !info.name.empty() && std::all_of(info.name.begin(), info.name.end(),
                                                   [](unsigned char c) { return std::isalnum(c) || c == '_'; });
            if (!valid || info.path.empty())
                throw UserError(
                    fmt::format("--module {}: expected NAME=DIR, NAME of letters, digits and underscores", argument));
            if (!folder("--module", argument, info.path, "the folder that holds the module's Build.cs or its Public/"))
                return;
            std::error_code error;
            if (std::string build = info.name + ".Build.cs"; fs::exists(fs::path(info.path) / build, error))
                info.build_cs = build;
            add(std::move(info), true);
            return;
        }
        if (!folder("--module", argument, argument, "the folder that holds the module's Build.cs or its Public/"))
            return;
        if (below(clean(argument), true) == 0)
            errors_.push_back(fmt::format("--module {}: no *.Build.cs was found in or below this folder, so the "
                                          "module's name is unknown; write --module NAME={}",
                argument, argument));
    }

    // Adds the modules below a folder; how many.
    std::size_t below(const std::string& root, bool written) {
        std::vector<std::string> files;
        walk(root, report_, ignored_folder, [&](const std::string& path, const std::string& name) {
            if (name.ends_with(".Build.cs"))
                files.push_back(path);
        });
        for (const std::string& file : files) {
            fs::path build(file);
            std::string name = build.filename().string();
            add({name.substr(0, name.size() - std::string_view(".Build.cs").size()), build.parent_path().string(), name,
                    written},
                false);
        }
        return files.size();
    }

    bool folder(const char* option, const std::string& argument, const std::string& path, const char* wanted) {
        std::error_code error;
        if (is_folder(path))
            return true;
        errors_.push_back(
            fs::exists(path, error)
                ? fmt::format("{} {}: '{}' is not a folder; give {}", option, argument, path, wanted)
                : fmt::format("{} {}: folder '{}' does not exist; give {}", option, argument, path, wanted));
        return false;
    }

    // The descriptor an argument names: the file itself, or the only one in a folder. "" (and an error) if none.
    std::string descriptor(const char* option, const std::string& argument, const std::string& extension) {
        std::error_code error;
        if (fs::is_regular_file(argument, error)) {
            if (argument.ends_with(extension))
                return argument;
            errors_.push_back(fmt::format("{} {}: is no *{} file", option, argument, extension));
            return {};
        }
        std::vector<std::string> files;
        for (fs::directory_iterator it(argument, error), end; !error && it != end; it.increment(error))
            if (it->path().extension() == extension)
                files.push_back(it->path().string());
        if (files.size() == 1)
            return files.front();
        if (!fs::exists(argument, error))
            errors_.push_back(
                fmt::format("{} {}: does not exist; give a *{} file or its folder", option, argument, extension));
        else
            errors_.push_back(fmt::format(
                "{} {}: there are {} *{} files in this folder; name one", option, argument, files.size(), extension));
        return {};
    }

    nlohmann::json read_descriptor(const std::string& file) {
        try {
            nlohmann::json json = nlohmann::json::parse(read_file(file), nullptr, true, true);
            if (json.is_object())
                return json;
            report_.warning("bad-descriptor", file, 1, fs::path(file).filename().string(),
                "is no JSON object; its folder is read all the same");
        } catch (const std::exception& e) {
            report_.warning("bad-descriptor", file, 1, fs::path(file).filename().string(),
                std::string("cannot be read as JSON (") + e.what() + "); its folder is read all the same");
        }
        return nlohmann::json::object();
    }

    // Modules of all plugins below a folder.
    std::size_t plugins_below(const std::string& root, bool written) {
        std::vector<std::string> folders;
        auto skip = [](const std::string& name) {
            return ignored_folder(name) || name == "Content" || name == "Source" || name == "Resources" ||
                   name == "Config";
        };
        walk(root, report_, skip, [&](const std::string& path, const std::string& name) {
            if (name.ends_with(".uplugin"))
                folders.push_back(fs::path(path).parent_path().string());
        });
        std::size_t count = 0;
        for (const std::string& folder : folders)
            if (is_folder(folder + "/Source"))
                count += below(folder + "/Source", written);
        return count;
    }

    void project(const std::string& argument) {
        std::string file = descriptor("--project", argument, ".uproject");
        if (file.empty())
            return;
        nlohmann::json json = read_descriptor(file);
        std::string root = fs::path(file).has_parent_path() ? fs::path(file).parent_path().string() : ".";
        std::size_t count = 0;
        if (is_folder(root + "/Source"))
            count += below(root + "/Source", true);
        std::vector<std::string> folders{root + "/Plugins", root + "/Mods"};
        if (auto more = json.find("AdditionalPluginDirectories"); more != json.end() && more->is_array())
            for (const nlohmann::json& folder : *more)
                if (folder.is_string())
                    folders.push_back((fs::path(root) / folder.get<std::string>()).lexically_normal().string());
        for (const std::string& folder : folders)
            if (is_folder(folder))
                count += plugins_below(clean(folder), true);
        if (auto modules = json.find("Modules"); modules != json.end() && modules->is_array())
            for (const nlohmann::json& module : *modules)
                if (module.is_object() && module.contains("Name") && module["Name"].is_string() &&
                    !found_.contains(module["Name"].get<std::string>()))
                    report_.warning("missing-module", file, 1, module["Name"].get<std::string>(),
                        "the project lists this module, but there is no " + module["Name"].get<std::string>() +
                            ".Build.cs below Source/");
        if (count == 0)
            errors_.push_back(
                fmt::format("--project {}: no *.Build.cs was found below {}/Source or {}/Plugins: a project "
                            "without C++ has nothing to read",
                    argument, root, root));
    }

    void plugin(const std::string& argument) {
        std::string file = descriptor("--plugin", argument, ".uplugin");
        if (file.empty())
            return;
        read_descriptor(file);
        std::string root = fs::path(file).has_parent_path() ? fs::path(file).parent_path().string() : ".";
        std::size_t count = is_folder(root + "/Source") ? below(root + "/Source", true) : 0;
        if (count == 0)
            errors_.push_back(
                fmt::format("--plugin {}: no *.Build.cs was found below {}/Source: a plugin without C++ has "
                            "nothing to read",
                    argument, root));
    }

    void engine(const std::string& argument, bool written) {
        if (!folder("--engine", argument, argument, "the folder that holds Engine/Source/Runtime"))
            return;
        std::string root = clean(argument);
        if (is_folder(root + "/Engine/Source"))
            root += "/Engine";
        std::size_t count = 0;
        for (const char* folder : {"/Source/Runtime", "/Source/Developer", "/Source/Editor"})
            if (is_folder(root + folder))
                count += below(root + folder, written);
        if (is_folder(root + "/Plugins"))
            count += plugins_below(root + "/Plugins", written);
        if (count == 0)
            errors_.push_back(
                fmt::format("--engine {}: no *.Build.cs was found below {}/Source/Runtime or {}/Plugins; give "
                            "the folder that holds Engine/ (or Engine/ itself)",
                    argument, root, root));
    }

    Report& report_;
    std::map<std::string, ModuleInfo> found_;
    std::set<std::string> named_;
    std::vector<std::string> errors_;
};

} // namespace

bool ignored_folder(const std::string& name) {
    static const std::set<std::string> names{
        "Intermediate", "ThirdParty", "Binaries", "Saved", "DerivedDataCache", "node_modules"};
    return name.starts_with(".") || names.contains(name);
}

void walk(const std::string& root, Report& report, const std::function<bool(const std::string&)>& skip,
    const std::function<void(const std::string&, const std::string&)>& use) {
    Walker(report, skip, use).folder(root, 0);
}

FoundModules find_modules(const Places& places, Report& report) { return Finder(report).run(places); }

} // namespace spear::header_tool
