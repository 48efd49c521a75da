#include <catch2/catch.hpp>

#include "lessons/catalogue.hpp"
#include "lessons/equation_labels.hpp"
#include "lessons/exact_text.hpp"
#include "lessons/joint_needs.hpp"
#include "lessons/typed.hpp"
#include "lessons/writer.hpp"
#include "tests/lessons/lesson_difference.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/random_mechanisms.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace jw;
using test::first_difference;
using test::lesson_of;
using test::Random;

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

/// What the format says of a joint of this type; everything else as a lesson has it.
JointGeometry as_in_lessons(const JointType& type, const JointGeometry& any) {
    const JointNeeds needs(type);
    JointGeometry g;
    if (needs.points) {
        g.P_i_local = any.P_i_local;
        g.P_j_local = any.P_j_local;
    }
    if (needs.axis) { g.s_i_local = any.s_i_local; }
    if (needs.axis_j) { g.s_j_local = any.s_j_local; }
    if (needs.sides && has_angle(type)) {
        g.h_i_local = g.u_i_local = perpendicular_to(any.s_i_local);
        g.h_j_local = g.u_j_local = any.s_j_local.cross(any.h_j_local).normalized();
    } else if (needs.sides) {
        g.h_i_local = any.h_i_local;
        g.h_j_local = any.h_j_local;
        g.u_i_local = unit_of(any.h_i_local);
        g.u_j_local = unit_of(any.h_j_local);
    }
    if (type.uses(Role::length)) { g.length = any.length; }
    if (type.uses(Role::screw_advance)) {
        g.alpha = any.alpha;
        g.d_0 = any.d_0;
        g.theta_0 = any.theta_0;
        g.screw_angle_form = any.screw_angle_form;
        g.theta_start = any.theta_start;
        g.theta_dot_start = any.theta_dot_start;
    }
    return g;
}

TimeFunction far_from_zero(Random& random) {
    TimeFunction f = test::random_function(random);
    // a distance is never negative
    f.polynomial = {random.number(5.0, 9.0)};
    return f;
}

/// Joints of every type, drivers of every kind, words and looks: all numbers random.
Lesson random_lesson(unsigned seed) {
    Random random(seed);
    Lesson lesson;
    lesson.file_name = "random.toml";
    lesson.title = "Random " + std::to_string(seed);
    Mechanism& m = lesson.mechanism;
    m.bodies = {
        test::random_body(random, "ground"), test::random_body(random, "i \\ \u03c6"),
        test::random_body(random, "j")};
    m.bodies[0].fixed = true;
    for (const JointType& type : kJointTypes) {
        Mechanism one = test::random_joint(
            random, type, static_cast<ParallelForm>(seed % 6), static_cast<ScrewAngleForm>(seed % 3));
        Joint joint = one.joints[0];
        joint.name = "the " + std::string(type.name);
        joint.body_i = static_cast<int>(seed % 2);
        joint.body_j = 2;
        if (seed % 2 == 0) { joint.geometry.theta_start = random.number(-20.0, 20.0); }
        if (seed % 3 == 0) { joint.geometry.theta_dot_start = random.number(); }
        joint.geometry = as_in_lessons(type, joint.geometry);
        if (!std::ranges::any_of(type.roles, is_parallel)) { joint.parallel_form = ParallelForm::rule; }
        // every third equation is out, the last one first
        const auto equations = equations_of(type, joint.parallel_form);
        for (std::size_t k = equations.size(); k-- > 0;) {
            if (k % 3 == seed % 3) { joint.without.push_back(equations[k].equation); }
        }
        m.joints.push_back(joint);
    }
    const auto add = [&](const Measure& measure, int joint, int i, int j) {
        const std::string name = "driver " + std::to_string(m.drivers.size());
        m.drivers.push_back({name, joint, i, j, measure, far_from_zero(random)});
    };
    for (int k = 0; k < static_cast<int>(m.joints.size()); ++k) {
        const Joint& joint = m.joints[static_cast<std::size_t>(k)];
        if (has_angle(*joint.type)) {
            const bool screw = joint.type->artificial > 0;
            add(screw ? Measure(ThetaMeasure{}) : Measure(angle_of(joint)), k, joint.body_i, joint.body_j);
        }
        if (has_displacement(*joint.type)) { add(displacement_of(joint), k, joint.body_i, joint.body_j); }
    }
    add(SquaredDistanceMeasure{random.vector(), random.vector()}, -1, 1, 2);
    for (int k = 0; k < 7; ++k) { add(CoordinateMeasure{k}, -1, 0, 2); }

    Mat3 axes;
    axes.col(0) = random.direction();
    axes.col(1) = perpendicular_to(axes.col(0));
    axes.col(2) = axes.col(0).cross(axes.col(1));
    lesson.looks = {
        {{Box{random.vector().cwiseAbs(), random.vector(), axes}}, Colour{1.0, 0.2, 16.0 / 255.0}},
        {{Rod{random.vector(), random.vector(), 0.1}, Cylinder{random.vector(), random.vector(), 0.2}}, {}},
        {{Sphere{random.vector(), random.number(0.1, 1.0)}, Sphere{}}, {}}};
    lesson.step_texts.joints.assign(m.joints.size(), "");
    lesson.step_texts.drivers.assign(m.drivers.size(), "");
    lesson.step_texts.joints[1] = "ends with a line feed\n";
    lesson.step_texts.joints[2] = "two lines,\n\nno line feed at the end";
    for (int k = static_cast<int>(m.joints.size()) - 1; k >= 0; --k) {
        lesson.order.push_back({Addition::Kind::joint, k});
    }
    for (int k = 0; k < static_cast<int>(m.drivers.size()); ++k) {
        lesson.order.push_back({Addition::Kind::driver, k});
    }
    lesson.coordinates = static_cast<CoordinateChoice>(seed % 4);
    lesson.motion = MotionPlan{random.number(), random.number(2.0, 3.0), random.number(1.0, 9.0), 7};
    lesson.step_texts.times = {{1.0, "from 1 s"}, {1.5, "then\n\nthis"}};
    lesson.camera.from = random.direction();
    lesson.camera.target = random.vector();
    lesson.camera.distance = random.number(1.0, 2.0);
    lesson.camera.up = random.direction();
    lesson.camera.orthographic = true;
    return lesson;
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

TEST_CASE("The lesson of the documentation is written as it was read", "[lessons][writing]") {
    check_there_and_back(lesson_of(test::documented_lesson()));
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
    const std::string text = test::with_two_bodies(rest);
    check_there_and_back(lesson_of(text));
    // what was typed comes back as typed
    const std::string written = lesson_text(lesson_of(text));
    for (const char* line :
         {"\nrotation = { axis = [0, 0, 1], angle_deg = 90 }\n", "\nside_i = [3, 4, 0]\n", "\npitch = -0.08 ",
          "\ntheta_deg = 750\n", "\ntheta_dot_deg_per_s = 33.3\n", "\nfrom = [0.7, -1, 0.35]\n",
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

    // a link keeps pointing to where the lesson is
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
