// SPDX-License-Identifier: MIT
// The live schema, found by walking classes and properties of the running engine, against what the header tool read
// from the headers: equal in every key of the runtime and editor tiers (codegen/SCHEMA.md).
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine_fixture.hpp"

using namespace end_to_end;
using nlohmann::json;
using spear::Value;

namespace {

json to_json(const Value& value) {
    return std::visit(
        [](const auto& part) -> json {
            using T = std::decay_t<decltype(part)>;
            if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::nullptr_t> ||
                          std::is_same_v<T, std::string>) {
                return part;
            } else if constexpr (std::is_same_v<T, Value::List>) {
                json list = json::array();
                for (const Value& element : part)
                    list.push_back(to_json(element));
                return list;
            } else if constexpr (std::is_same_v<T, Value::Dict>) {
                json dict = json::object();
                for (const auto& [key, element] : part)
                    dict[key] = to_json(element);
                return dict;
            } else {
                FAIL("the schema has a value that JSON has not");
                return nullptr;
            }
        },
        value.storage());
}

/// Without the tier that only text knows.
json without_source(const json& value) {
    if (value.is_object()) {
        json dict = json::object();
        for (const auto& [key, element] : value.items()) {
            if (key != "source")
                dict[key] = without_source(element);
        }
        return dict;
    }
    if (value.is_array()) {
        json list = json::array();
        for (const json& element : value)
            list.push_back(without_source(element));
        return list;
    }
    return value;
}

using Entities = std::map<std::pair<std::string, std::string>, json>;

void add_entities(Entities& entities, const json& list) {
    for (const json& entity : list) {
        entities[{entity.at("name"), entity.value("path", "")}] = without_source(entity);
    }
}

} // namespace

TEST_CASE("the live schema equals the offline one, tier by tier") {
    Client client;
    const json live = to_json(client.instance.call(spear::unreal_service::get_schema, std::vector<std::string>{}));
    CHECK(live.at("origin") == "live");

    const std::filesystem::path folder =
        std::filesystem::path(SPEAR_TEST_ENGINE).parent_path().parent_path() / "codegen";
    std::vector<json> offline;
    for (const json& module : live.at("modules")) {
        const std::string name = module.at("name");
        CAPTURE(name);
        std::ifstream file(folder / name / (name + ".schema.json"));
        REQUIRE(file);
        offline.push_back(json::parse(file));
    }
    for (const char* kind : {"modules", "classes", "structs", "enums", "delegates"}) {
        Entities ours, theirs;
        add_entities(ours, live.at(kind));
        for (const json& schema : offline) {
            add_entities(theirs, schema.at(kind));
        }
        CHECK(ours.size() == theirs.size());
        CHECK_FALSE(ours.empty());
        for (const auto& [name, entity] : theirs) {
            CAPTURE(kind);
            CAPTURE(name.first);
            REQUIRE(ours.count(name) == 1);
            const json difference = json::diff(entity, ours.at(name));
            CHECK_MESSAGE(difference.empty(), difference.dump(1).substr(0, 500));
        }
    }
}
