#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

#include "tests/lessons/support.hpp"
#include "tests/support/mutated_text.hpp"
#include "tests/support/sound_lesson.hpp"

using namespace jw;

namespace {

/// Words that the reader knows, and values at the limits of what it accepts.
const std::vector<std::string> kWords{
    "nan",
    "inf",
    "-inf",
    "1e9",
    "-1e9",
    "1e-300",
    "1e308",
    "0",
    "-0.0",
    "-1",
    "true",
    "[]",
    "{}",
    "\"\"",
    "[0, 0, 0]",
    "[1, 0, 0]",
    "[0, 0, 1]",
    "[1e9, 1e9, 1e9]",
    "[1, 2]",
    "[nan, 0, 0]",
    "\"ground\"",
    "\"crank\"",
    "\"revolute\"",
    "\"screw\"",
    "\"universal\"",
    "\"prismatic\"",
    "\"distance\"",
    "\"n2\"",
    "\"planar\"",
    "\"formula\"",
    "[[body]]\n",
    "[[joint]]\n",
    "[[driver]]\n",
    "[[expect]]\n",
    "axis_i = ",
    "axis_j = ",
    "side = ",
    "pitch = ",
    "to = ",
    "length = ",
    "p = ",
    "mass = ",
    "inertia = ",
    "[dynamics]\n",
    "[[force]]\n",
    "rotation = ",
    "polynomial = ",
    "formula = 's_i^T s_j'",
    "\n",
    "\"",
    "'",
    "#",
    "=",
    "[",
    "]",
    ",",
    ".",
    "\\",
    "\xEF\xBB\xBF",
    "\xFF",
    "\xCE\xA6",
    "\r"};

/// A lesson with every kind of table, so that mutants reach all of the reader.
std::string many_sided_lesson() {
    std::string documented = test::documented_lesson();
    for (const char* body : {"name = \"crank\"", "name = \"rod\"", "name = \"slider\""}) {
        documented.insert(documented.find(body), "mass = 1\ninertia = [1, 2, 2.5]\n");
    }
    return documented + R"(
[[body]]
name = "nut"
position = [0, 0, 1]
mass = 2
inertia = [[1, 0.1, 0], [0.1, 1, 0], [0, 0, 1]]
centre = [0, 0.1, 0]
axes = { x = [0, 1, 0], y = [-1, 0, 0] }
omega_global_rad_per_s = [0, 0, 1]
[[joint]]
name = "jack"
type = "screw"
bodies = ["ground", "nut"]
at = [0, 0, 0]
to = [0, 0, 1]
axis = [0, 0, 1]
side = [1, 0, 0]
pitch = 0.01
[[joint]]
name = "cross"
type = "universal"
bodies = ["crank", "nut"]
point_i = [1, 0, 0]
point_j = [0, 1, 0]
axis_i = [0, 0, 2]
axis_j = [0, 1, 0]
[[joint]]
name = "own"
type = "formula"
bodies = ["crank", "nut"]
at = [0, 0, 0]
to = [0, 0, 1]
axis = [0, 0, 1]
formula = '\mathbf{d}^T \mathbf{d} + \sin(s_{xi}) |u_i \times u_j|^2 = 1'
[[driver]]
name = "pull"
bodies = ["ground", "nut"]
at = [0, 0, 0]
quantity = "distance"
step = { from = 1, to = 2, end_s = 1 }
from_start = true
[dynamics]
duration = 10
gravity = [0, 0, -9.81]
method = "rk4"
treatment = "baumgarte"
step = 1e-3
point = { body = "nut", at = [0, 0, 1] }
point_at_end = [0, 0, 2]
[[force]]
body = "nut"
at = [0, 0, 1]
direction = [0, 0, 1]
harmonics = { amplitude = 3, frequency_hz = 2 }
[[torque]]
body = "crank"
torque = [0, 0, 1]
frame = "local"
[[spring]]
bodies = ["ground", "nut"]
at = [0, 0, 0]
point_j = [0, 0, 0]
stiffness = 8e5
damping = 4e4
[[rotational_spring]]
joint = "pivot"
stiffness = 3
free_angle_deg = 30
[[expect]]
as_given = true
quantity = "nut.point.x"
point = [1, 0, 0]
value = 0
tolerance = 1e-9
)";
}

}  // namespace

TEST_CASE("Ten thousand damaged lessons are read or refused, never more", "[lessons][fuzz]") {
    constexpr unsigned kSeed = 20240229;
    INFO("seed " << kSeed);
    std::mt19937 random(kSeed);
    const std::string original = many_sided_lesson();
    REQUIRE(test::is_sound(test::lesson_of(original)));
    int read = 0;
    int refused = 0;
    for (int k = 0; k < 10000; ++k) {
        const std::string text = test::mutated(original, random, kWords);
        const ReadResult result = read_lesson(text, "mutant.toml");
        const bool has_error = std::ranges::any_of(
            result.diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
        const bool good = result.lesson ? test::is_sound(*result.lesson) && !has_error : has_error;
        if (!good) { FAIL("mutant " << k << ":\n" << text << "\n" << result.report()); }
        (result.lesson ? read : refused) += 1;
        // every report can be written, wherever its mark falls
        if (k % 10 == 0) { CHECK(result.report().size() < 200000); }
    }
    // both outcomes occur often enough to be tested
    CHECK(read > 400);
    CHECK(refused > 5000);
}
