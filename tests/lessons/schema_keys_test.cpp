#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "lessons/exercise/read_exercises.hpp"
#include "lessons/fields/fields.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/format/exercise_keys.hpp"
#include "lessons/format/key.hpp"
#include "lessons/write/writer.hpp"
#include "tests/lessons/random_lessons.hpp"
#include "tests/lessons/support.hpp"

using namespace jw;

namespace {

/// Keys by the name of their table and their own.
using Keys = std::set<std::pair<std::string, std::string>>;

/// Adds the keys of a table and of those below it that the format describes.
void add_keys(const toml::table& table, const KeyTable& described, Keys& keys) {
    for (const auto& [name, node] : table) {
        const Key* key = find_key(described, name.str());
        if (key == nullptr) { continue; }
        keys.emplace(described.name, name.str());
        if (key->table.empty()) { continue; }
        if (const toml::table* below = node.as_table()) { add_keys(*below, key_table(key->table), keys); }
        if (const toml::array* list = node.as_array()) {
            for (const toml::node& entry : *list) {
                add_keys(*entry.as_table(), key_table(key->table), keys);
            }
        }
    }
}

/// Keys of all lessons and exercises that come with the program, of those in docs, and of rare_keys.
Keys keys_of_lessons() {
    Keys keys;
    const auto add_lesson = [&](const ReadResult& read) {
        if (read.lesson) { add_keys(toml::parse(read.source), key_tables().front(), keys); }
    };
    const auto add_exercises = [&](const std::filesystem::path& file) {
        const ExercisesRead read = read_exercise_file(file);
        INFO(read.report());
        REQUIRE_FALSE(read.exercises.empty());
        add_keys(toml::parse(read.source), format::kExerciseFile, keys);
    };
    const std::filesystem::path root(JW_SOURCE_ROOT);
    for (const auto& file : lessons_below(catalogue_folder())) { add_lesson(read_lesson_file(file)); }
    for (const std::string& lesson : test::documented_toml()) {
        add_lesson(read_lesson(lesson, "page.toml"));
    }
    for (const auto& entry : std::filesystem::directory_iterator(root / "lessons/exercises")) {
        if (entry.path().extension() == ".toml") { add_exercises(entry.path()); }
    }
    const std::filesystem::path rare = root / "tests/lessons/rare_keys";
    add_exercises(rare / "exercises.toml");
    for (const char* name : {"screw.toml", "spellings.toml", "turning_nut.toml"}) {
        const ReadResult read = read_lesson_file(rare / name);
        INFO(read.report());
        REQUIRE(read.lesson.has_value());
        add_lesson(read);
    }
    return keys;
}

}  // namespace

TEST_CASE("Every key of the format stands in a lesson that is read", "[schema]") {
    const Keys read = keys_of_lessons();
    for (const KeyTable& table : key_tables()) {
        // an alternative has the same keys, read by the same functions
        const std::string_view as = table.name == "alternative" ? "exercise" : table.name;
        for (const SpelledKey& key : spelled_keys(table)) {
            CAPTURE(table.name, key.name);
            CHECK(read.contains({std::string(as), key.name}));
            CHECK_FALSE(key.about.empty());
            CHECK(find_key(table, key.name) == key.key);
        }
    }
}

TEST_CASE("A key that the format does not describe, or describes otherwise, cannot be read", "[schema]") {
    const toml::table toml = toml::parse("stiffness = 1\ncolour = \"blue\"\nbodies = [\"a\", \"b\"]");
    const std::string source;
    Problems problems("file.toml", source);
    Fields fields(toml, "the spring", problems, &key_table("spring"));
    CHECK(fields.not_negative("stiffness")->value == 1.0);
    CHECK(fields.number("stiffness")->value == 1.0);
    CHECK_THROWS_AS(fields.positive("stiffness"), std::logic_error);
    CHECK_THROWS_AS(fields.text("colour"), std::logic_error);
    CHECK_THROWS_AS(fields.has("stiffness_deg"), std::logic_error);
    CHECK_THROWS_AS(fields.text("bodies"), std::logic_error);
}

TEST_CASE("A key tells its unit: in its name, or beside it", "[schema]") {
    CHECK(unit_of_key("body.crank.shape.0.rod.radius") == "m");
    CHECK(unit_of_key("body.crank.shape.rod.radius") == "m");
    CHECK(unit_of_key("body.crank.inertia") == "kg m²");
    CHECK(unit_of_key("body.crank.omega_local_deg_per_s") == "deg/s");
    CHECK(unit_of_key("body.mass.position") == "m");
    CHECK(unit_of_key("spring.0.damping") == "N s/m");
    CHECK(unit_of_key("rotational_spring.0.damping") == "N m s/rad");
    CHECK(unit_of_key("camera.from").empty());
    CHECK(unit_of_key("dynamics.gravity") == "m/s²");
    CHECK(unit_of_key("dynamics.point_at_end") == "m");
    CHECK(unit_of_key("joint.thread.advance_per_rad") == "m/rad");
    CHECK(unit_of_key("joint.thread.theta_0_deg") == "deg");
    CHECK(unit_of_key("driver.lift.step.to") == "m");
    CHECK(unit_of_key("driver.lift.step.end_s") == "s");
    CHECK(unit_of_key("nobody.knows").empty());
}

TEST_CASE("Units of keys are those that the writer puts behind their values", "[schema]") {
    const std::regex header(R"(^\[+([a-z_]+)\]+$)");
    const std::regex commented(R"(^([a-z_0-9]+) = .*  # (.*)$)");
    std::set<std::string> checked;
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::istringstream lines(lesson_text(test::random_lesson(seed)));
        std::string table;
        for (std::string line; std::getline(lines, line);) {
            std::smatch found;
            if (std::regex_match(line, found, header)) { table = found[1].str() + '.'; }
            if (!std::regex_match(line, found, commented)) { continue; }
            const std::string path = table + found[1].str();
            const Key* key = find_key(key_table(table.substr(0, table.size() - 1)), found[1].str());
            CAPTURE(seed, line, path);
            REQUIRE(key != nullptr);
            if (key->unit.empty()) { continue; }
            CHECK(found[2].str().starts_with(key->unit));
            CHECK(unit_of_key(path) == key->unit);
            checked.insert(path);
        }
    }
    CAPTURE(checked.size());
    CHECK(checked.size() > 15);
}

TEST_CASE("What authors try instead of a key leads to a key, and is none itself", "[lessons][reading]") {
    for (const OtherName& name : other_names()) {
        CAPTURE(name.tried, name.meant);
        int tables = 0;
        for (const KeyTable& table : key_tables()) {
            std::vector<std::string> keys;
            for (const SpelledKey& key : spelled_keys(table)) { keys.push_back(key.name); }
            const std::string meant = key_meant_by(name.tried, keys);
            if (meant.empty()) { continue; }
            ++tables;
            const std::string_view key = find_key(table, meant)->name;
            CHECK(std::ranges::any_of(other_names(), [&](const OtherName& other) {
                return other.tried == name.tried && other.meant == key;
            }));
            CHECK(find_key(table, name.tried) == nullptr);
        }
        CHECK(tables > 0);
    }
}
