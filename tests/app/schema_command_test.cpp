#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

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

}  // namespace jw::test
