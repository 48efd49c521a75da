#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "lessons/catalogue.hpp"
#include "lessons/fields.hpp"
#include "lessons/format/exercise_keys.hpp"
#include "lessons/format/key.hpp"
#include "tests/lessons/support.hpp"

using namespace jw;

namespace {

/// Keys that stand in no lesson of the catalogue and of the docs.
constexpr const char* kRareKeys = R"(
[[body]]
name = "slide"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = "thread"
type = "screw"
bodies = ["ground", "slide"]
at = [0, 0, 0]
axis = [0, 0, 1]
pitch = 0.1
theta_deg = 0
[[driver]]
name = "lift"
quantity = "thread.displacement"
harmonics = { amplitude = 0.1, frequency_hz = 1 }
step = { from = 0, to = 0.1, end_s = 1 }
[[torque]]
body = "slide"
direction = [0, 0, 1]
polynomial = [1]
harmonics = [{ amplitude = 1, omega_rad_per_s = 1, phase_deg = 90 }, { amplitude = 1, frequency_hz = 1 }]
step = { from = 0, to = 1, start_s = 0, end_s = 1 }
[[force]]
body = "slide"
direction = [0, 0, 1]
harmonics = [{ amplitude = 1, omega_rad_per_s = 1, phase_deg = 90 }, { amplitude = 1, frequency_hz = 1 }]
step = { from = 0, to = 1, start_s = 0, end_s = 1 }
[[rotational_spring]]
joint = "thread"
stiffness = 1
free_angle_deg = 10
[dynamics]
duration = 1
[[question]]
at = "motion"
ask = "How far?"
quantity = "thread.displacement"
at_s = 1
tolerance = 0.1
[[question]]
at = "motion"
ask = "Where?"
quantity = "slide.point.x"
point = [0, 0, 1]
at_s = 1
tolerance = 0.1
[precision]
digits = 4
)";

/// The same, in their other spellings.
constexpr const char* kOtherKeys = R"(
format = 1
title = "t"
order = ["hinge", "thread", "gap", "first", "second", "third", "lift"]
[precision]
exact = true
[camera]
distance = 3
orthographic = true
[[body]]
name = "post"
fixed = true
rotation = { axis = [0, 0, 1], angle_rad = 0.1 }
[[body]]
name = "arm"
position = [1, 0, 0]
omega_global_rad_per_s = [0, 0, 1]
mass = 1
inertia = [1, 1, 1]
[[body]]
name = "nut"
position = [0, 2, 0]
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = "hinge"
type = "revolute"
bodies = ["post", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]
without = ["s z"]
[[joint]]
name = "thread"
type = "screw"
bodies = ["post", "nut"]
at = [0, 2, 0]
axis = [0, 0, 1]
advance_per_rad = 0.1
d_0 = 0
theta_0_rad = 0
theta_rad = 0
theta_dot_rad_per_s = 0
[[joint]]
name = "gap"
type = "distance"
bodies = ["arm", "nut"]
at = [1, 0, 0]
to = [0, 2, 0]
[[driver]]
name = "first"
quantity = "angle"
joint = "hinge"
polynomial_rad = [0, 1]
[[driver]]
name = "second"
quantity = "angle"
joint = "hinge"
harmonics = { amplitude_rad = 1, omega_rad_per_s = 1, phase_rad = 0 }
step = { from_deg = 0, to_deg = 1, start_s = 0, end_s = 1 }
[[driver]]
name = "third"
quantity = "angle"
joint = "hinge"
step = { from_rad = 0, to_rad = 1, end_s = 1 }
[[driver]]
name = "lift"
quantity = "distance"
bodies = ["arm", "nut"]
at = [1, 0, 0]
to = [0, 2, 0]
polynomial = [2]
[dynamics]
duration = 1
treatment = "projection"
[[force]]
body = "arm"
point = [0, 0, 1]
frame = "local"
force = [0, 0, 1]
harmonics = { amplitude = 1, frequency_hz = 1, phase_rad = 0 }
[[torque]]
body = "arm"
frame = "local"
torque = [0, 0, 1]
[[spring]]
bodies = ["arm", "nut"]
at = [1, 0, 0]
to = [0, 2, 0]
stiffness = 1
[[rotational_spring]]
joint = "hinge"
damping = 1
free_angle_rad = 1
[[expect]]
at_s = 1
of = "dynamics"
quantity = "arm.x"
value = 1
tolerance = 1
[[exercise]]
)";

constexpr const char* kOneMoreKey = R"(
format = 1
title = "t"
[[body]]
name = "nut"
[[joint]]
name = "thread"
type = "screw"
bodies = ["ground", "nut"]
at = [0, 0, 0]
axis = [0, 0, 1]
pitch = 0.1
theta_dot_deg_per_s = 0
)";

/// Scene of exercises with rare keys.
constexpr const char* kScene = R"(
format = 1
title = "t"
[[body]]
name = "arm"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = "hinge"
type = "revolute"
bodies = ["ground", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]
[motion]
to_s = 1
[dynamics]
duration = 1
)";

/// Exercises with the keys that stand in no other.
std::string rare_exercises() {
    std::string exercises = "format = 1\ntitle = \"t\"\n";
    auto add = [&, count = 0](const std::string& kind, const std::string& keys) mutable {
        exercises += "[[exercise]]\nname = \"e" + std::to_string(++count) +
                     "\"\ntitle = \"t\"\nask = \"?\"\nkind = \"" + kind + "\"\nscene = \"\"\"" + kScene +
                     "\"\"\"\n" + keys + '\n';
    };
    const std::string change = "change = { key = \"body.arm.mass\", value = 2 }\ncondition_below = 1e6\n";
    add("number", change + "quantity = \"hinge.angle\"\nat_s = 1\nof = \"dynamics\"\ntolerance_rad = 1");
    add("number", "quantity = \"hinge.angle_dot\"\nat_s = 1\ntolerance_rad_per_s = 1");
    add("number", "quantity = \"hinge.angle_ddot\"\nat_s = 1\ntolerance_rad_per_s2 = 1");
    add("number", "quantity = \"hinge.angle_ddot\"\nat_s = 1\ntolerance_deg_per_s2 = 1");
    add("number", "quantity = \"arm.point.x\"\npoint = [1, 0, 0]\nat_s = 1\ntolerance = 1");
    add("vector",
        "formula = \"\\\\Phi = r_i^P - r_j^P\"\njoint = \"hinge\"\nprimitive = \"s\"\nabsolute = true\ncases "
        "= 3");
    return exercises;
}

/// A question about an angle or one of its derivatives.
std::string question_about(const std::string& quantity, const std::string& ending) {
    return "[[question]]\nat = \"motion\"\nask = \"?\"\nquantity = \"" + quantity +
           "\"\nat_s = 1\ntolerance" + ending + " = 1\n";
}

/// A lesson with the keys that are rare.
std::string rare_lesson() {
    std::string lesson = "format = 1\ntitle = \"t\"" + std::string(kRareKeys);
    const std::map<std::string, std::string> rates{{"", ""}, {"_dot", "_per_s"}, {"_ddot", "_per_s2"}};
    for (const auto& [dot, per] : rates) {
        for (const char* unit : {"_deg", "_rad"}) {
            lesson += question_about("thread.angle" + dot, unit + per);
        }
    }
    return lesson;
}

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

/// The keys of a lesson that is read without an error.
void add_keys_of(const ReadResult& read, Keys& keys) {
    if (read.lesson) { add_keys(toml::parse(read.source), key_tables().front(), keys); }
}

Keys keys_of_lessons() {
    Keys keys;
    for (const auto& file : lessons_below(catalogue_folder())) { add_keys_of(read_lesson_file(file), keys); }
    for (const std::string& lesson : test::documented_toml()) {
        add_keys_of(read_lesson(lesson, "page.toml"), keys);
    }
    const auto add_exercises = [&](const ExercisesRead& read) {
        INFO(read.report());
        REQUIRE_FALSE(read.exercises.empty());
        add_keys(toml::parse(read.source), format::kExerciseFile, keys);
    };
    add_exercises(read_exercises(rare_exercises(), "rare.toml"));
    const std::filesystem::path exercises = std::filesystem::path(JW_SOURCE_ROOT) / "lessons/exercises";
    for (const auto& entry : std::filesystem::directory_iterator(exercises)) {
        if (entry.path().extension() == ".toml") { add_exercises(read_exercise_file(entry.path())); }
    }
    for (const std::string& lesson : {rare_lesson(), std::string(kOtherKeys), std::string(kOneMoreKey)}) {
        const ReadResult read = read_lesson(lesson, "rare.toml");
        INFO(read.report());
        REQUIRE(read.lesson.has_value());
        add_keys_of(read, keys);
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
