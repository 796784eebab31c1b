// SPDX-License-Identifier: MIT
// ConditionMap: which #if conditions a declaration stands under.
#include "scan.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace spear::header_tool {

namespace {

// Conditions UHT itself understands, or that say nothing about a declaration's presence.
enum class Condition { editor, not_editor, cpp, known, arbitrary };

Condition classify(std::string_view raw) {
    std::string text;
    for (char c : raw)
        if (!std::isspace(static_cast<unsigned char>(c)))
            text += c;
    for (std::string_view editor : {"WITH_EDITOR", "WITH_EDITORONLY_DATA"}) {
        if (text == editor)
            return Condition::editor;
        if (text == "!" + std::string(editor))
            return Condition::not_editor;
    }
    if (text == "!CPP" || text == "CPP")
        return Condition::cpp;
    static constexpr std::array<std::string_view, 8> known{
        "1", "0", "!0", "WITH_HOT_RELOAD", "WITH_METADATA", "WITH_VERSE_VM", "WITH_ENGINE", "!1"};
    if (std::find(known.begin(), known.end(), text) != known.end())
        return Condition::known;
    // Include guards
    if (text.ends_with("_H") || text.ends_with("_H_") || text.ends_with("_h") || text.ends_with("_H__"))
        return Condition::known;
    return Condition::arbitrary;
}

} // namespace

ConditionMap::ConditionMap(const std::vector<Directive>& directives) {
    struct Level {
        std::string text;
        Condition kind;
        std::size_t body;
        bool inverted = false;
    };
    std::vector<Level> stack;
    auto current = [&] {
        Conditions c;
        for (const Level& level : stack) {
            switch (level.kind) {
            case Condition::editor:
                c.editor_only |= !level.inverted;
                break;
            case Condition::not_editor:
                c.editor_only |= level.inverted;
                break;
            case Condition::cpp:
                c.in_function_of_cpp = true;
                break;
            case Condition::known:
                break;
            case Condition::arbitrary:
                c.arbitrary.push_back(level.text);
                break;
            }
        }
        return c;
    };
    auto close_branch = [&](const Directive& d) {
        if (!stack.empty())
            branches_.push_back({stack.back().body, d.begin});
    };
    for (std::size_t i = 0; i < directives.size(); ++i) {
        const Directive& d = directives[i];
        if (d.name == "if" || d.name == "ifdef" || d.name == "ifndef") {
            std::string text = d.name == "if" ? d.rest : (d.name == "ifdef" ? "defined(" : "!defined(") + d.rest + ")";
            Condition kind = d.name == "if" ? classify(d.rest) : classify(d.rest);
            if (d.name == "ifndef" && i + 1 < directives.size() && directives[i + 1].name == "define" &&
                directives[i + 1].rest.starts_with(d.rest))
                kind = Condition::known; // include guard
            stack.push_back({text, kind, d.end});
        } else if (d.name == "elif" || d.name == "elifdef" || d.name == "elifndef") {
            close_branch(d);
            if (!stack.empty())
                stack.back() = {d.rest, classify(d.rest), d.end};
        } else if (d.name == "else") {
            close_branch(d);
            if (!stack.empty()) {
                stack.back().inverted = !stack.back().inverted;
                stack.back().text = "!(" + stack.back().text + ")";
                stack.back().body = d.end;
            }
        } else if (d.name == "endif") {
            close_branch(d);
            if (!stack.empty())
                stack.pop_back();
        } else {
            continue;
        }
        changes_.emplace_back(d.end, current());
    }
    std::sort(
        branches_.begin(), branches_.end(), [](const ByteRange& a, const ByteRange& b) { return a.begin < b.begin; });
}

Conditions ConditionMap::at(std::size_t offset) const {
    auto it = std::upper_bound(
        changes_.begin(), changes_.end(), offset, [](std::size_t o, const auto& change) { return o < change.first; });
    return it == changes_.begin() ? Conditions{} : std::prev(it)->second;
}

} // namespace spear::header_tool
