// SPDX-License-Identifier: MIT
#include "files.h"

#include "run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

namespace spear::header_tool {

namespace fs = std::filesystem;

namespace {

bool ignored_folder(const std::string& name) {
    static const std::set<std::string> names{
        "Intermediate", "ThirdParty", "Binaries", "Saved", "DerivedDataCache", "node_modules"};
    return name.starts_with(".") || names.contains(name);
}

// Calls `use` for each regular file below `root`, in no particular order.
template <class Use>
void walk(const fs::path& root, Use use) {
    std::error_code error;
    fs::recursive_directory_iterator it(
        root, fs::directory_options::follow_directory_symlink | fs::directory_options::skip_permission_denied, error),
        end;
    if (error)
        throw UserError(fmt::format("cannot read folder {}: {}", root.string(), error.message()));
    while (it != end) {
        if (it->is_directory(error) && (ignored_folder(it->path().filename().string()) || it.depth() > 40))
            it.disable_recursion_pending();
        else if (it->is_regular_file(error))
            use(it->path());
        it.increment(error);
        if (error)
            throw UserError(fmt::format("cannot read below folder {}: {}", root.string(), error.message()));
    }
}

void require_folder(const std::string& path, const std::string& argument) {
    std::error_code error;
    if (!fs::exists(path, error))
        throw UserError(fmt::format("--module {}: folder '{}' does not exist; give the folder that holds the module's "
                                    "Build.cs or its Public/ folder",
            argument, path));
    if (!fs::is_directory(path, error))
        throw UserError(fmt::format("--module {}: '{}' is not a folder", argument, path));
}

std::vector<fs::path> build_files(const fs::path& root) {
    std::vector<fs::path> out;
    walk(root, [&](const fs::path& file) {
        if (file.filename().string().ends_with(".Build.cs"))
            out.push_back(file);
    });
    std::sort(out.begin(), out.end());
    return out;
}

std::string module_name(const fs::path& build_cs) {
    std::string name = build_cs.filename().string();
    return name.substr(0, name.size() - std::strlen(".Build.cs"));
}

} // namespace

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw UserError(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (file.bad())
        throw UserError(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
    return text;
}

nlohmann::json read_json(const std::string& path) {
    std::string text = read_file(path);
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& e) {
        throw UserError(fmt::format("{} is not valid JSON: {}", path, e.what()));
    }
}

void write_file(const std::string& path, const std::string& text) {
    fs::path target(path);
    std::error_code error;
    if (target.has_parent_path())
        fs::create_directories(target.parent_path(), error);
    std::string temporary = path + ".part";
    {
        std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
        file << text;
        file.close();
        if (!file)
            throw UserError(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
    }
    fs::rename(temporary, target, error);
    if (error)
        throw UserError(fmt::format("cannot write {}: {}", path, error.message()));
}

std::vector<ModuleInfo> find_modules(const std::vector<std::string>& arguments) {
    std::vector<ModuleInfo> out;
    auto add = [&](ModuleInfo module, const std::string& argument) {
        for (const ModuleInfo& other : out)
            if (other.name == module.name) {
                if (fs::weakly_canonical(other.path) == fs::weakly_canonical(module.path))
                    return;
                throw UserError(
                    fmt::format("--module {}: module {} was found twice, in {} and {}; name one of them with NAME=DIR",
                        argument, module.name, other.path, module.path));
            }
        out.push_back(std::move(module));
    };
    for (const std::string& argument : arguments) {
        std::size_t equals = argument.find('=');
        if (equals != std::string::npos) {
            ModuleInfo module{argument.substr(0, equals), argument.substr(equals + 1), ""};
            bool valid = !module.name.empty() && std::all_of(module.name.begin(), module.name.end(),
                                                     [](unsigned char c) { return std::isalnum(c) || c == '_'; });
            if (!valid || module.path.empty())
                throw UserError(
                    fmt::format("--module {}: expected NAME=DIR, NAME of letters, digits and underscores", argument));
            require_folder(module.path, argument);
            fs::path build = fs::path(module.path) / (module.name + ".Build.cs");
            std::error_code error;
            if (fs::exists(build, error))
                module.build_cs = build.filename().string();
            add(std::move(module), argument);
            continue;
        }
        require_folder(argument, argument);
        std::vector<fs::path> builds = build_files(argument);
        if (builds.empty())
            throw UserError(fmt::format("--module {}: no *.Build.cs was found in or below this folder, so the module's "
                                        "name is unknown; write --module NAME={}",
                argument, argument));
        for (const fs::path& build : builds)
            add({module_name(build), build.parent_path().string(), build.filename().string()}, argument);
    }
    std::sort(out.begin(), out.end(), [](const ModuleInfo& a, const ModuleInfo& b) { return a.name < b.name; });
    return out;
}

std::vector<std::unique_ptr<Header>> find_headers(const std::vector<ModuleInfo>& modules) {
    std::vector<std::unique_ptr<Header>> out;
    std::set<std::string> roots;
    for (const ModuleInfo& m : modules)
        roots.insert(fs::weakly_canonical(m.path).string());
    for (const ModuleInfo& m : modules) {
        std::vector<std::string> files;
        std::string own = fs::weakly_canonical(m.path).string();
        walk(m.path, [&](const fs::path& file) {
            std::string name = file.filename().string();
            if (!name.ends_with(".h") || name.ends_with(".generated.h"))
                return;
            // A module inside this one's folder has its own headers.
            for (fs::path at = fs::weakly_canonical(file).parent_path(); at.string().size() > own.size();
                at = at.parent_path())
                if (roots.contains(at.string()))
                    return;
            files.push_back(file.lexically_relative(m.path).generic_string());
        });
        std::sort(files.begin(), files.end());
        for (const std::string& relative : files) {
            auto header = std::make_unique<Header>();
            header->module = m.name;
            header->relative = relative;
            header->path = (fs::path(m.path) / relative).string();
            header->include = relative;
            for (std::string_view folder : {"Public/", "Classes/", "Private/", "Internal/"})
                if (relative.starts_with(folder))
                    header->include = relative.substr(folder.size());
            out.push_back(std::move(header));
        }
    }
    return out;
}

void write_depfile(const std::string& path, const std::string& output,
    const std::vector<std::unique_ptr<Header>>& headers, const std::vector<std::string>& imports) {
    auto escape = [](const std::string& name) {
        std::string out;
        for (char c : name) {
            if (c == ' ' || c == '#' || c == '\\')
                out += '\\';
            if (c == '$')
                out += '$';
            out += c;
        }
        return out;
    };
    std::string text = escape(output) + ":";
    for (const auto& h : headers)
        text += " \\\n  " + escape(h->path);
    for (const std::string& file : imports)
        text += " \\\n  " + escape(file);
    write_file(path, text + "\n");
}

} // namespace spear::header_tool
