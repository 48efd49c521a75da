#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/lessons/support.hpp"

using namespace jw;

namespace {

/// Words that mean something to the reader, and values at the edge of what it takes.
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

std::string mutated(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    // values and keys are exchanged whole, so that many mutants survive the TOML parser
    const auto word_at = [&](std::size_t k) {
        const std::size_t begin = text.find_last_of(" \n", k);
        const std::size_t end = text.find_first_of(" \n,]", k);
        const std::size_t first = begin == std::string::npos ? 0 : begin + 1;
        return std::pair(first, std::min(end, text.size()) - first);
    };
    const std::size_t changes = 1 + below(4);
    for (std::size_t k = 0; k < changes && !text.empty(); ++k) {
        const std::size_t at = below(text.size());
        switch (below(6)) {
            case 0: text[at] = static_cast<char>(below(256)); break;
            case 1: text.erase(at, 1 + below(20)); break;
            case 2: text.insert(at, kWords[below(kWords.size())]); break;
            case 3: text.insert(at, text.substr(below(text.size()), below(60))); break;
            default: {
                const auto [first, length] = word_at(at);
                text.replace(first, length, kWords[below(kWords.size())]);
            }
        }
    }
    return text;
}

/// Visits every number of a lesson.
class NumbersOf {
public:
    explicit NumbersOf(const Lesson& lesson) {
        for (const Body& body : lesson.mechanism.bodies) {
            add(body.r, body.p, body.r_dot, body.omega_local);
        }
        for (const Joint& joint : lesson.mechanism.joints) { add_geometry(joint.geometry); }
        for (const Driver& driver : lesson.mechanism.drivers) { add_driver(driver); }
        for (const Look& look : lesson.looks) { add_look(look); }
        for (const Claim& claim : lesson.claims) { add_claim(claim); }
        if (lesson.motion) { add(lesson.motion->from, lesson.motion->to, lesson.motion->duration); }
        if (lesson.dynamics) { add_dynamics(*lesson.dynamics); }
        add_camera(lesson.camera);
        for (const auto& text : lesson.step_texts.times) { add(text.from); }
    }
    bool all_finite() const { return all_finite_; }

private:
    template <class... Ts>
    void add(const Ts&... values) {
        (add_one(values), ...);
    }
    void add_one(double x) { all_finite_ = all_finite_ && std::isfinite(x); }
    template <class Derived>
    void add_one(const Eigen::MatrixBase<Derived>& m) {
        all_finite_ = all_finite_ && m.allFinite();
    }

    void add_geometry(const JointGeometry& g) {
        add(g.P_i_local, g.P_j_local, g.s_i_local, g.s_j_local, g.h_i_local, g.h_j_local, g.u_i_local,
            g.u_j_local, g.length, g.alpha, g.d_0, g.theta_0);
    }
    void add_measure(const Measure& measure) {
        if (const auto* m = std::get_if<AngleMeasure>(&measure)) {
            add(m->s_i_local, m->u_i_local, m->u_j_local);
        }
        if (const auto* m = std::get_if<DisplacementMeasure>(&measure)) {
            add(m->s_i_local, m->B_i_local, m->B_j_local);
        }
        if (const auto* m = std::get_if<SquaredDistanceMeasure>(&measure)) {
            add(m->P_i_local, m->P_j_local);
        }
    }
    void add_driver(const Driver& driver) {
        add_measure(driver.measure);
        add_function(driver.function);
    }
    void add_function(const TimeFunction& function) {
        for (const double c : function.polynomial) { add(c); }
        for (const auto& h : function.harmonics) { add(h.amplitude, h.omega, h.phase); }
        for (const auto& s : function.steps) { add(s.from, s.to, s.start, s.end); }
    }
    void add_dynamics(const DynamicsPlan& plan) {
        const Loads& loads = plan.loads;
        add(loads.gravity, plan.duration, plan.tolerance, plan.step);
        if (plan.point) { add(plan.point->point_local); }
        if (plan.point_at_end) { add(*plan.point_at_end); }
        for (const auto& mass : loads.masses) {
            if (mass) { add(mass->mass, mass->centre_local, mass->J_local); }
        }
        for (const AppliedForce& force : loads.forces) {
            add(force.point_local, force.direction);
            add_function(force.magnitude);
        }
        for (const AppliedTorque& torque : loads.torques) {
            add(torque.direction);
            add_function(torque.magnitude);
        }
        for (const Spring& s : loads.springs) {
            add(s.P_i_local, s.P_j_local, s.stiffness, s.damping, s.free_length);
        }
        for (const RotationalSpring& s : loads.rotational_springs) {
            add_measure(s.angle);
            add(s.stiffness, s.damping, s.free_angle);
        }
    }
    void add_look(const Look& look) {
        for (const Shape& shape : look.shapes) {
            if (const auto* s = std::get_if<Box>(&shape)) { add(s->size, s->centre, s->axes); }
            if (const auto* s = std::get_if<Cylinder>(&shape)) { add(s->from, s->to, s->radius); }
            if (const auto* s = std::get_if<Sphere>(&shape)) { add(s->centre, s->radius); }
            if (const auto* s = std::get_if<Rod>(&shape)) { add(s->from, s->to, s->radius); }
        }
        if (look.colour) { add(look.colour->red, look.colour->green, look.colour->blue); }
    }
    void add_claim(const Claim& claim) {
        if (const auto* when = std::get_if<AtTime>(&claim.when)) { add(when->t); }
        if (const auto* fact = std::get_if<BoundClaim>(&claim.fact)) { add(fact->limit); }
        if (const auto* fact = std::get_if<QuantityClaim>(&claim.fact)) {
            add(fact->value, fact->tolerance);
            if (const auto* q = std::get_if<MeasureQuantity>(&fact->quantity)) { add_measure(q->measure); }
            if (const auto* q = std::get_if<PointQuantity>(&fact->quantity)) { add(q->s_local); }
            if (const auto* q = std::get_if<PointSpeedQuantity>(&fact->quantity)) { add(q->s_local); }
        }
    }
    void add_camera(const CameraWish& camera) {
        if (camera.from) { add(*camera.from); }
        if (camera.target) { add(*camera.target); }
        if (camera.distance) { add(*camera.distance); }
        if (camera.up) { add(*camera.up); }
    }

    bool all_finite_ = true;
};

/// True if the loads are as the equations of motion assume.
bool loads_are_sound(const Mechanism& m, const Loads& loads) {
    const auto moves = [&](int index) {
        return index >= 0 && index < static_cast<int>(m.bodies.size()) &&
               !m.bodies[static_cast<std::size_t>(index)].fixed;
    };
    // throws if a mass is missing or not positive
    CHECK_NOTHROW(centroidal(m, loads));
    return std::ranges::all_of(loads.forces, [&](const auto& force) { return moves(force.body); }) &&
           std::ranges::all_of(loads.torques, [&](const auto& torque) { return moves(torque.body); }) &&
           std::ranges::all_of(
               loads.springs, [&](const auto& s) { return moves(s.body_i) || moves(s.body_j); });
}

bool is_sound(const Lesson& lesson) {
    const Mechanism& m = lesson.mechanism;
    const auto body = [&](int index) { return index >= 0 && index < static_cast<int>(m.bodies.size()); };
    bool good = lesson.order.size() == m.joints.size() + m.drivers.size() &&
                lesson.looks.size() == m.bodies.size() &&
                lesson.step_texts.joints.size() == m.joints.size() &&
                lesson.step_texts.drivers.size() == m.drivers.size() && m.moving_bodies_count() > 0;
    for (const Body& b : m.bodies) { good = good && std::abs(b.p.norm() - 1.0) < 2e-3; }
    for (const Joint& j : m.joints) {
        good = good && j.type != nullptr && body(j.body_i) && body(j.body_j) && j.body_i != j.body_j &&
               j.geometry.s_i_local.norm() > 0.0;
    }
    for (const Driver& d : m.drivers) {
        good = good && body(d.body_i) && body(d.body_j) && std::isfinite(d.function.at(0.0).f);
    }
    if (lesson.dynamics) { good = good && loads_are_sound(m, lesson.dynamics->loads); }
    for (const Claim& claim : lesson.claims) {
        const auto* quantity = std::get_if<QuantityClaim>(&claim.fact);
        good = good && claim.span.line > 0 && (quantity == nullptr || quantity->tolerance > 0.0);
    }
    return good && NumbersOf(lesson).all_finite();
}

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
    REQUIRE(is_sound(test::lesson_of(original)));
    int read = 0;
    int refused = 0;
    for (int k = 0; k < 10000; ++k) {
        const std::string text = mutated(original, random);
        const ReadResult result = read_lesson(text, "mutant.toml");
        const bool has_error = std::ranges::any_of(
            result.diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
        const bool good = result.lesson ? is_sound(*result.lesson) && !has_error : has_error;
        if (!good) { FAIL("mutant " << k << ":\n" << text << "\n" << result.report()); }
        (result.lesson ? read : refused) += 1;
        // every report can be written, wherever its mark falls
        if (k % 10 == 0) { CHECK(result.report().size() < 200000); }
    }
    // both roads are taken often enough to mean something
    CHECK(read > 500);
    CHECK(refused > 5000);
}
