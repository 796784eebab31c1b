// SPDX-License-Identifier: MIT
#include "files.h"

#include "projects.h"
#include "run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <unistd.h>

namespace spear::header_tool {

namespace fs = std::filesystem;

std::string read_file(const std::string& path) {
    auto fail = [&] { return UserError(fmt::format("cannot read {}: {}", path, std::strerror(errno))); };
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file)
        throw fail();
    std::string text;
    std::error_code error;
    auto size = fs::file_size(path, error);
    for (std::size_t step = error ? 65536 : static_cast<std::size_t>(size) + 1;; step = 65536) {
        std::size_t before = text.size();
        text.resize(before + step);
        text.resize(before + std::fread(text.data() + before, 1, step, file.get()));
        if (std::ferror(file.get()))
            throw fail();
        if (std::feof(file.get()))
            return text;
    }
}

nlohmann::json read_json(const std::string& path) {
    std::string text = read_file(path);
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& e) {
        throw UserError(fmt::format("{} is not valid JSON: {}", path, e.what()));
    }
}

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
    fs::path target(path);
    std::error_code error;
    if (target.has_parent_path())
        fs::create_directories(target.parent_path(), error);
    std::string temporary = fmt::format("{}.{}.part", path, getpid());
    {
        std::vector<char> buffer(1 << 20);
        std::ofstream file;
        file.rdbuf()->pubsetbuf(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        file.open(temporary, std::ios::binary | std::ios::trunc);
        if (file)
            write(file);
        file.close();
        if (!file) {
            std::string reason = std::strerror(errno);
            fs::remove(temporary, error);
            throw UserError(fmt::format("cannot write {}: {}", path, reason));
        }
    }
    fs::rename(temporary, target, error);
    if (error) {
        std::string reason = error.message();
        fs::remove(temporary, error);
        throw UserError(fmt::format("cannot write {}: {}", path, reason));
    }
}

void write_file(const std::string& path, const std::string& text) {
    write_file(path, [&](std::ostream& out) { out << text; });
}

std::vector<std::unique_ptr<Header>> find_headers(const std::vector<ModuleInfo>& modules, Report& report) {
    std::vector<std::unique_ptr<Header>> out;
    std::map<std::string, std::string> roots; // canonical folder -> path as given
    auto canonical = [](const std::string& path) {
        std::error_code error;
        return fs::weakly_canonical(path, error).string();
    };
    for (const ModuleInfo& m : modules)
        roots.emplace(canonical(m.path), m.name);
    for (const ModuleInfo& m : modules) {
        std::vector<std::string> files;
        // A module inside this one's folder has its own headers.
        std::set<std::string> inner;
        std::string own = canonical(m.path) + "/";
        for (const auto& [root, name] : roots)
            if (root.starts_with(own))
                inner.insert(root);
        walk(m.path, report, ignored_folder, [&](const std::string& path, const std::string& name) {
            if (!name.ends_with(".h") || name.ends_with(".generated.h"))
                return;
            if (!inner.empty()) {
                std::string file = canonical(fs::path(path).parent_path().string());
                for (const std::string& root : inner)
                    if (file == root || file.starts_with(root + "/"))
                        return;
            }
            files.push_back(path.substr(m.path.size() + 1));
        });
        std::sort(files.begin(), files.end());
        for (const std::string& relative : files) {
            auto header = std::make_unique<Header>();
            header->module = m.name;
            header->relative = relative;
            header->path = m.path + "/" + relative;
            header->include = relative;
            for (std::string_view folder : {"Public/", "Classes/", "Private/", "Internal/"})
                if (relative.starts_with(folder))
                    header->include = relative.substr(folder.size());
            out.push_back(std::move(header));
        }
    }
    return out;
}

void write_depfile(const std::string& path, const std::string& output, const std::vector<std::string>& headers,
    const std::vector<std::string>& imports) {
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
    for (const std::string& h : headers)
        text += " \\\n  " + escape(h);
    for (const std::string& file : imports)
        text += " \\\n  " + escape(file);
    write_file(path, text + "\n");
}

} // namespace spear::header_tool
