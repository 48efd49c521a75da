#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include <nlohmann/json.hpp>

#include "lessons/format/key.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

TEST_CASE("docs/lesson.schema.json is what schema writes", "[app][schema][golden]") {
    const Ran ran = run({"schema"});
    CHECK(ran.status == 0);
    CHECK(ran.err.empty());
    const std::string path = std::string(JW_SOURCE_ROOT) + "/docs/lesson.schema.json";
    if (std::getenv("JW_REGENERATE_GOLDEN") != nullptr) { std::ofstream(path) << ran.out; }
    CHECK(bytes_of(path) == ran.out);
}

TEST_CASE("The schema has every table with all its keys, and takes no others", "[app][schema]") {
    const nlohmann::json schema = nlohmann::json::parse(run({"schema"}).out);
    for (const KeyTable& table : key_tables()) {
        CAPTURE(table.name);
        const std::vector<SpelledKey> keys = spelled_keys(table);
        const bool is_lesson = table.name == key_tables().front().name;
        const nlohmann::json& written = is_lesson ? schema : schema["definitions"][std::string(table.name)];
        CHECK(written["additionalProperties"] == false);
        CHECK(written["properties"].size() == keys.size());
        for (const SpelledKey& key : keys) {
            CAPTURE(key.name);
            CHECK(written["properties"][key.name]["description"] == key.about);
        }
    }
}

TEST_CASE("docs/keys.md is what keys writes", "[app][schema][golden]") {
    const Ran ran = run({"keys", "--format", "markdown"});
    CHECK(ran.status == 0);
    CHECK(ran.err.empty());
    const std::string path = std::string(JW_SOURCE_ROOT) + "/docs/keys.md";
    if (std::getenv("JW_REGENERATE_GOLDEN") != nullptr) { std::ofstream(path) << ran.out; }
    CHECK(bytes_of(path) == ran.out);
}

TEST_CASE(
    "keys shows every table with all spellings of its keys, wherever the table may stand", "[app][schema]") {
    const nlohmann::json pages = nlohmann::json::parse(run({"keys", "--format", "json"}).out)["tables"];
    CHECK(pages.size() == key_tables().size());
    const std::string list = run({"keys"}).out;
    for (const nlohmann::json& page : pages) {
        const std::string path = page["path"];
        CAPTURE(path);
        CHECK(("\n" + list).find('\n' + path + "  ") != std::string::npos);
        // follows the path from table to table, independently of the code that wrote it
        const KeyTable* table = &key_tables().front();
        std::istringstream names(path == "lesson" ? "" : path);
        for (std::string name; std::getline(names, name, '.');) {
            const Key* key = find_key(*table, name);
            REQUIRE(key != nullptr);
            table = &key_table(key->table);
        }
        std::vector<std::string> found;
        for (const nlohmann::json& key : page["keys"]) {
            for (const std::string name : key["names"]) {
                found.push_back(name);
                CHECK(find_key(*table, name)->required == key["required"]);
            }
        }
        std::vector<std::string> known;
        for (const SpelledKey& key : spelled_keys(*table)) { known.push_back(key.name); }
        CHECK(found == known);
        const Ran one = run({"keys", path});
        CHECK(one.status == 0);
        for (const std::string& name : known) {
            const std::regex line("\\n  ([^\\n]*, )?" + name + "(, [^\\n]*)?( \\(required\\))?\\n");
            CHECK(std::regex_search(one.out, line));
        }
    }
}

TEST_CASE("keys takes a table as it stands in a file, and names the one that was meant", "[app][schema]") {
    CHECK(run({"keys", "[[body.shape]]"}).out == run({"keys", "body.shape"}).out);
    // a table that is first listed elsewhere
    CHECK(run({"keys", "torque.table"}).out.starts_with("[torque.table]: values at given times\n"));
    CHECK(
        run({"keys", "torque"}).out.find("table [torque.table], with the keys of [force.table]") !=
        std::string::npos);
    CHECK(run({"keys", "torque.body"}).status == 2);
    const Ran ran = run({"keys", "jiont"});
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK(
        ran.err ==
        "jointwise: error: no table 'jiont' in a lesson; expected a table such as 'joint' or 'body.shape'\n"
        "hint: did you mean 'joint'?\n");
}

}  // namespace jw::test
