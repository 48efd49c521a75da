#include <catch2/catch.hpp>

#include "lessons/files/catalogue.hpp"
#include "lessons/typed/exact_text.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writer.hpp"
#include "tests/lessons/lesson_difference.hpp"
#include "tests/lessons/random_lessons.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace jw;
using test::first_difference;
using test::lesson_of;
using test::Random;
using test::random_lesson;

namespace {

/// Writes, reads and writes again: nothing may differ.
void check_there_and_back(const Lesson& lesson) {
    const std::string text = lesson_text(lesson);
    INFO(text);
    const ReadResult read = read_lesson(text, lesson.file_name);
    INFO(read.report());
    REQUIRE(read.lesson.has_value());
    CHECK(first_difference(lesson, *read.lesson) == "");
    CHECK(lesson_text(*read.lesson) == text);
}

}  // namespace

TEST_CASE("Every lesson of the catalogue is written as it was read", "[lessons][writing]") {
    const auto files = lessons_below(catalogue_folder());
    REQUIRE(files.size() >= 18);
    for (const auto& file : files) {
        INFO(file);
        const ReadResult read = read_lesson_file(file);
        REQUIRE(read.lesson.has_value());
        check_there_and_back(*read.lesson);
    }
}

TEST_CASE("The lessons of the documentation are written as they were read", "[lessons][writing]") {
    check_there_and_back(lesson_of(test::documented_lesson()));
    check_there_and_back(lesson_of(test::documented_toml()[3]));
}

TEST_CASE("Random mechanisms are written and read digit for digit", "[lessons][writing]") {
    for (unsigned seed = 1; seed <= 24; ++seed) {
        INFO("seed " << seed);
        check_there_and_back(random_lesson(seed));
    }
}

TEST_CASE("Everything that a lesson can say is written as it was read", "[lessons][writing]") {
    const std::string rest = R"(
[[body]]
name = "post"
fixed = true
position = [-0.0, 1e-12, 123456789.125]
axes = { x = [1, 1, 0], z = [0, 0.0003, 1] }
colour = "#0a0b0c"
shape = { box = { size = [1, 2, 3], at = [0, 0, 1], axes = { x = [1, 2, 2], y = [-2, -1, 2] } } }
[[body]]
name = "nut"
p = [0.5001, 0.5, -0.5, 0.4998]
mass = 2.5
inertia = [[1, 0.1, 0.3], [0.1, 2, 0.2], [0.3, 0.2, 2.3]]
centre = [0.01, 0, 0]
velocity = [0, 0, -0.3]
omega_global_deg_per_s = [10, 20, -30]
[[joint]]
name = "thread"
type = "screw"
bodies = ["post", "nut"]
point_i = [0, 0, 0]
point_j = [0, 0, 0.1]
axis_i = [0, 0, 2]
axis_j = [0, 3, 4]
side_i = [3, 4, 0]
side_j = [7, 0, 0]
pitch = -0.08
angle_row = "sine"
theta_deg = 750
theta_dot_deg_per_s = 33.3
parallel = "drop y"
text = "one line"
[[joint]]
name = "slide in it"
type = "prismatic"
bodies = ["nut", "arm"]
at = [0.1, 0.2, 0.3]
to = [0.1, 0.2, 0.5]
axis = [1, 2, 3]
side = [3, 0, -1]
[[joint]]
name = "rod"
type = "distance"
bodies = ["nut", "arm"]
at = [0.1, 0.2, 0.3]
to = [0.7, 0.2, 0.5]
[[driver]]
name = "twist"
joint = "thread"
quantity = "angle"
polynomial_deg = [0, 360, -5.5]
harmonics = [{ amplitude_deg = 20, frequency_hz = 0.3, phase_deg = 45 }, { amplitude_rad = 0.1, omega_rad_per_s = 3 }]
from_start = true
[[driver]]
name = "push"
joint = "slide in it"
quantity = "displacement"
step = [{ from = 0.1, to = 0.2, start_s = 0.5, end_s = 1 }, { to = -0.1, end_s = 2 }]
text = """
two lines
of words"""
[[driver]]
name = "nothing"
body = "base"
coordinate = "e2"
quantity = "coordinate"
harmonics = []
[motion]
from_s = -1
to_s = 2
[camera]
from = [0.7, -1, 0.35]
up = [0, 1, 0]
[dynamics]
duration = 2.5
gravity = [0, 0, -9.81]
method = "implicit-5"
treatment = "tangent"
tolerance = 1e-8
step = 0.01
point = { body = "nut", at = [0.1, 0.2, 0.3] }
point_at_end = [1, 2, 3]
[[force]]
body = "nut"
at = [0.1, 0.2, 0.3]
force = [0, 0, 5]
frame = "local"
[[force]]
body = "nut"
direction = [1, 2, 2]
harmonics = { amplitude = 7, frequency_hz = 0.3, phase_deg = 45 }
[[torque]]
body = "arm"
torque = [0, 3, 0]
step = { to = 1, end_s = 1 }
[[spring]]
bodies = ["post", "arm"]
at = [0, 0, 0]
to = [1, 0, 0]
damping = 3
[[rotational_spring]]
joint = "thread"
stiffness = 7
free_angle_deg = 15
[[expect]]
after = "thread"
rank = 6
rows = 9
columns = 19
closes = false
condition_above = 3
dropped = "thread p2 z"
quantity = "nut.omega_local.y"
value_deg_per_s = 0.1
tolerance_deg_per_s = 1e-3
why = "One \"block\"."
[[expect]]
as_given = true
rows = 3
[[expect]]
as_given = true
rank = 3
mobility_by_counting = -7
[[expect]]
at_s = 0.1
quantity = "nut.omega.x"
derivative = 1
value_rad_per_s2 = 0.1
tolerance_rad_per_s2 = 2
[[expect]]
at_s = 0.1
quantity = "thread.angle"
derivative = 2
value_deg_per_s2 = 123.4
tolerance_deg_per_s2 = 0.7
[[expect]]
at_s = 0.1
quantity = "thread.angle"
value_rad = 0.1
tolerance_rad = 1e-9
[[expect]]
quantity = "nut.point.z"
point = [0.1, 0.2, 0.3]
value = 1
tolerance = 0.1
[[expect]]
residual_below = 1e-12
change_point = true
)";
    std::string text = test::with_two_bodies(rest);
    for (const std::string name : {"base", "arm"}) {
        text.insert(text.find("name = \"" + name), "mass = 1\ninertia = [1, 2, 3]\n");
    }
    check_there_and_back(lesson_of(text));
    // what was typed comes back as typed
    const std::string written = lesson_text(lesson_of(text));
    for (const char* line :
         {"\nrotation = { axis = [0, 0, 1], angle_deg = 90 }\n", "\nside_i = [3, 4, 0]\n", "\npitch = -0.08 ",
          "\ntheta_deg = 750\n", "\ninertia = [1, 2, 2.3, 0.1, 0.3, 0.2] ",
          "\ndirection = [1, 2, 2]\nharmonics = { amplitude = 7, frequency_hz = 0.3, phase_deg = 45 }\n",
          "\nforce = [0, 0, 5] ", "\nfree_angle_deg = 15\n", "\nmethod = \"implicit-5\"\n",
          "\ntheta_dot_deg_per_s = 33.3\n", "\nfrom = [0.7, -1, 0.35]\n",
          "{ amplitude_deg = 20, frequency_hz = 0.3, phase_deg = 45 }", "omega_rad_per_s = 3 }",
          "\nvalue_deg_per_s2 = 123.4\ntolerance_deg_per_s2 = 0.7\n",
          "\n[[expect]]\nafter = \"thread\"\nrows = 9\ncolumns = 19\nrank = 6\ncondition_above = 3\n"}) {
        CHECK_THAT(written, Catch::Contains(line));
    }
}

TEST_CASE("A joint that has been taken out is not written, nor what hangs on it", "[lessons][writing]") {
    Lesson lesson = lesson_of(test::documented_lesson());
    // the pivot, joint 0, and with it the driver along it
    std::erase(lesson.order, Addition{Addition::Kind::joint, 0});
    const Lesson read = lesson_of(lesson_text(lesson));
    REQUIRE(read.mechanism.joints.size() == 3);
    CHECK(read.mechanism.joints[0].name == "pin");
    CHECK(read.mechanism.drivers.empty());
    CHECK(read.order.size() == 3);
    CHECK(read.step_texts.joints[2] == lesson.step_texts.joints[3]);
    CHECK(read.mechanism.bodies.size() == lesson.mechanism.bodies.size());
}

TEST_CASE("A spring about a joint goes with the joint, and about no joint is refused", "[lessons][writing]") {
    Random random(5);
    Lesson lesson = random_lesson(2);
    auto& springs = lesson.dynamics->loads.rotational_springs;
    const std::size_t count = springs.size();
    const auto hinge = std::ranges::find(lesson.mechanism.joints, "the revolute", &Joint::name);
    const int index = static_cast<int>(hinge - lesson.mechanism.joints.begin());
    std::erase(lesson.order, Addition{Addition::Kind::joint, index});
    CHECK(lesson_of(lesson_text(lesson)).dynamics->loads.rotational_springs.size() == count - 1);
    springs[0].angle.s_i_local = random.direction();
    CHECK_THROWS_AS(lesson_text(lesson), std::invalid_argument);
}

TEST_CASE("Any text survives in quotes", "[lessons][writing]") {
    for (const std::string text :
         {"plain", "\"quoted\" \\backslash\\ 'single'", "\"\"\"", "a\n\"\"\"\nb\"", "\"\n\"\"",
          "tab\there\n\tand here", "\xF0\x9F\x94\xA9 \u03c6\u2032 \u00df", "\n", "\n\nempty lines\n\n",
          "ends with a backslash \\\n", " blank ", "C:\\new\\table", "# no comment\n[no.table]\nno = 1"}) {
        CAPTURE(text);
        Lesson lesson = lesson_of(test::documented_lesson());
        lesson.step_texts.joints[0] = text;
        lesson.claims[0].why = text;
        check_there_and_back(lesson);
    }
    Lesson lesson = lesson_of(test::documented_lesson());
    lesson.text = "ends with\na quote\"";
    lesson.mechanism.bodies[1].name = "crank \\ #1 \u03c9";
    check_there_and_back(lesson);
}

TEST_CASE("Control characters are escaped, and refused by the reader's own rule", "[lessons][writing]") {
    CHECK(writing::string_text("\x01\x1f\x7f") == "\"\\u0001\\u001F\\u007F\"");
    CHECK(writing::string_text("bell\a\nrings") == "\"\"\"\nbell\\u0007\nrings\"\"\"");
    Lesson lesson = lesson_of(test::documented_lesson());
    lesson.title = "bell\a";
    const ReadResult read = read_lesson(lesson_text(lesson), "bell.toml");
    REQUIRE(read.diagnostics.size() == 1);
    CHECK_THAT(read.report(), Catch::Contains("bell.toml:2:9: error: 'title' contains a control character"));
}

TEST_CASE("A lesson file is written whole or not at all", "[lessons][writing]") {
    const test::TemporaryFolder folder;
    std::string error;
    const auto path = folder.write("kept.toml", "before");
    CHECK(write_lesson_file(path, "after", error));
    CHECK(read_lesson_file(path).source == "after");
    CHECK(write_lesson_file(folder.path() / "new.toml", "new", error));
    CHECK(folder.files() == 2);
    CHECK(error.empty());

    // a symbolic link is kept; the lesson is written to its target
    const auto elsewhere = folder.write("elsewhere/lesson.toml", "old");
    std::filesystem::create_symlink(elsewhere, folder.path() / "link.toml");
    CHECK(write_lesson_file(folder.path() / "link.toml", "through", error));
    CHECK(std::filesystem::is_symlink(folder.path() / "link.toml"));
    CHECK(read_lesson_file(elsewhere).source == "through");

    // what an earlier program left behind is neither used nor removed
    folder.write("kept.toml.part-1", "left behind");
    std::filesystem::permissions(
        path, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    CHECK(write_lesson_file(path, "again", error));
    CHECK(read_lesson_file(path).source == "again");
    CHECK(
        std::filesystem::status(path).permissions() ==
        (std::filesystem::perms::owner_read | std::filesystem::perms::owner_write));
    std::filesystem::remove(folder.path() / "kept.toml.part-1");

    CHECK_FALSE(write_lesson_file(folder.path(), "text", error));
    CHECK_THAT(error, Catch::Contains("this is a folder"));
    CHECK_FALSE(write_lesson_file(folder.path() / "no" / "x.toml", "text", error));
    CHECK_THAT(error, Catch::Contains("there is no folder '" + (folder.path() / "no").string() + "'"));
    CHECK_FALSE(write_lesson_file(folder.path() / std::string(300, 'x'), "text", error));
    CHECK_THAT(error, Catch::Contains("File name too long"));
    CHECK(folder.files() == 4);
}

TEST_CASE("A driver that no lesson can describe is refused", "[lessons][writing]") {
    Lesson lesson = lesson_of(test::documented_lesson());
    lesson.mechanism.drivers[0].joint = -1;
    CHECK_THROWS_AS(lesson_text(lesson), std::invalid_argument);
}
