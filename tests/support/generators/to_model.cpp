#include "tests/support/generators/to_model.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tests/support/generators/formula_to_model.hpp"

namespace jw::test {

namespace general = reference::general;

namespace {

reference::Vec3 real(const Vec3& v) { return v.cast<long double>(); }

std::optional<general::FormulaTree> law_of(const std::optional<ScalarFormula>& formula) {
    return formula ? std::optional(tree_of(formula->steps)) : std::nullopt;
}

general::Friction real(const DryFriction& f) { return {f.size, f.speed}; }

general::TimeFunction real(const TimeFunction& f) {
    general::TimeFunction out;
    out.polynomial.assign(f.polynomial.begin(), f.polynomial.end());
    for (const auto& h : f.harmonics) { out.harmonics.push_back({h.amplitude, h.omega, h.phase}); }
    for (const auto& s : f.steps) { out.ramps.push_back({s.from, s.to, s.start, s.end}); }
    if (f.table) { out.tables.push_back({f.table->times, f.table->values}); }
    if (f.formula) {
        out.formulas.push_back(
            {"*", 0.0L, {tree_of(f.formula->formula.steps), {"number", f.formula->unit, {}}}});
    }
    return out;
}

/// Writes the equations of a joint, without those that are taken out by hand.
class JointWriter {
public:
    JointWriter(const Joint& joint, int of)
        : joint_(joint),
          of_(of),
          s_i_{joint.body_i, real(joint.geometry.s_i_local)},
          s_j_{joint.body_j, real(joint.geometry.s_j_local)},
          P_i_{joint.body_i, real(joint.geometry.P_i_local)},
          P_j_{joint.body_j, real(joint.geometry.P_j_local)} {
        // the pair of the book: two vectors across s_i, of which the first lies across the axis that is least
        // in it
        const Vec3 s = joint.geometry.s_i_local;
        Eigen::Index least = 0;
        s.cwiseAbs().minCoeff(&least);
        const Vec3 a = s.cross(Vec3::Unit(least)).normalized();
        across_[0] = {joint.body_i, real(a)};
        across_[1] = {joint.body_i, real(s.normalized().cross(a))};
    }

    void same_point() {
        for (int k = 0; k < 3; ++k) { add(Role::same_point, k, general::Gap{P_j_, P_i_, k}); }
    }
    void parallel_axes() {
        parallel(
            Role::axes_parallel,
            [&](int k) {
                return general::CrossProduct{s_i_, s_j_, k};
            },
            [&](std::size_t k) {
                return general::Product{across_[k], s_j_};
            });
    }
    void parallel_distance() {
        parallel(
            Role::distance_parallel,
            [&](int k) {
                return general::CrossDistance{s_i_, P_i_, P_j_, k};
            },
            [&](std::size_t k) {
                return general::Along{across_[k], P_i_, P_j_};
            });
    }
    void perpendicular_axes() { add(Role::axes_perpendicular, 0, general::Product{s_i_, s_j_}); }
    void perpendicular_distance() { add(Role::distance_perpendicular, 0, general::Along{s_i_, P_i_, P_j_}); }
    void perpendicular_distance_j() {
        // from P_j to P_i along s_j, the other way round
        const general::Fixed back{joint_.body_j, -real(joint_.geometry.s_j_local)};
        add(Role::distance_perpendicular_j, 0, general::Along{back, P_j_, P_i_});
    }
    void perpendicular_sides() {
        const JointGeometry& g = joint_.geometry;
        add(Role::sides_perpendicular, 0,
            general::Product{{joint_.body_i, real(g.h_i_local)}, {joint_.body_j, real(g.h_j_local)}});
    }
    void length() {
        add(Role::length, 0, general::SquaredDistance{P_i_, P_j_});
        if (!out_.empty()) {
            const long double L = joint_.geometry.length;
            out_.back().constant = L * L;
        }
    }
    void thread();
    void mesh();
    void rack();
    void curve();
    void formula();

    std::vector<general::Equation> take() { return std::move(out_); }

private:
    bool taken_out(Role role, int component) const {
        return std::ranges::find(joint_.without, EquationOut{role, component}) != joint_.without.end();
    }
    void add(Role role, int component, const general::Measure& measure) {
        if (taken_out(role, component)) { return; }
        general::Equation equation;
        equation.measure = measure;
        equation.of = of_;
        out_.push_back(equation);
    }
    /// All forms state the same constraint: the rule keeps two of three equations, the pair has two others,
    /// and all three have one more than needed. Here it is always the pair. What a form drops by hand is
    /// dropped here, too.
    template <class Component, class Across>
    void parallel(Role role, const Component& component, const Across& across) {
        const ParallelForm form = joint_.parallel_form;
        const bool by_hand =
            std::ranges::any_of(joint_.without, [&](const EquationOut& out) { return out.role == role; });
        if (by_hand && form == ParallelForm::rule) {
            throw std::invalid_argument("which two the rule keeps is not known here");
        }
        const bool as_pair = form == ParallelForm::rule || form == ParallelForm::pair ||
                             (form == ParallelForm::all_three && !by_hand);
        if (as_pair) {
            for (int k = 0; k < 2; ++k) { add(role, k, across(static_cast<std::size_t>(k))); }
            return;
        }
        for (int k = 0; k < 3; ++k) {
            const bool dropped = form != ParallelForm::all_three &&
                                 k == static_cast<int>(form) - static_cast<int>(ParallelForm::drop_x);
            if (!dropped) { add(role, k, component(k)); }
        }
    }

    const Joint& joint_;
    int of_;
    general::Fixed s_i_;
    general::Fixed s_j_;
    general::Fixed P_i_;
    general::Fixed P_j_;
    std::array<general::Fixed, 2> across_;
    std::vector<general::Equation> out_;
};

general::Angle angle_between(int body_i, int body_j, const Vec3& s, const Vec3& u_i, const Vec3& u_j) {
    return {{body_i, real(s) / real(s).norm()}, {body_i, real(u_i)}, {body_j, real(u_j)}};
}

general::ThreadAngle thread_of(const Joint& joint) {
    const JointGeometry& g = joint.geometry;
    const general::Angle angle =
        angle_between(joint.body_i, joint.body_j, g.s_i_local, g.u_i_local, g.u_j_local);
    return {
        angle,
        {angle.s, {joint.body_i, real(g.P_i_local)}, {joint.body_j, real(g.P_j_local)}},
        g.alpha,
        g.d_0,
        g.theta_0};
}

/// The artificial θ is its angle plus the turns that the advance counts: one equation is left of two.
void JointWriter::thread() {
    general::Equation equation;
    equation.measure = general::Thread{thread_of(joint_)};
    equation.of = of_;
    out_.push_back(equation);
}

general::WheelAngle wheel_of(const Joint& joint, general::WheelAngle::Line line, bool of_j) {
    const JointGeometry& g = joint.geometry;
    const general::Fixed s_i{joint.body_i, real(g.s_i_local) / real(g.s_i_local).norm()};
    const general::Fixed s_j{joint.body_j, real(g.s_j_local) / real(g.s_j_local).norm()};
    general::WheelAngle wheel;
    wheel.line = line;
    wheel.s = of_j ? s_j : s_i;
    wheel.u = of_j ? general::Fixed{joint.body_j, real(g.u_j_local)}
                   : general::Fixed{joint.body_i, real(g.u_i_local)};
    wheel.from = {joint.body_i, real(g.P_i_local)};
    wheel.to = {joint.body_j, real(g.P_j_local)};
    wheel.a = s_i;
    wheel.b = s_j;
    return wheel;
}

/// Two wheels roll on each other.
void JointWriter::mesh() {
    const general::WheelAngle first = first_wheel_of(joint_);
    general::Equation equation;
    equation.measure = general::Mesh{first, wheel_of(joint_, first.line, true), joint_.geometry.ratio};
    equation.of = of_;
    out_.push_back(equation);
}

/// A wheel of j rolls on a rack of i.
void JointWriter::rack() {
    const JointGeometry& g = joint_.geometry;
    const general::WheelAngle wheel = first_wheel_of(joint_);
    general::Equation equation;
    equation.measure = general::Rolling{wheel, {wheel.a, wheel.from, wheel.to}, g.alpha, g.d_0, g.theta_0};
    equation.of = of_;
    out_.push_back(equation);
}

/// A point stays on a curve: the two directions across it.
void JointWriter::curve() {
    const JointGeometry& g = joint_.geometry;
    general::OffCurve off{P_i_, P_j_, real(g.curve.constant), real(g.curve.linear), {}, false};
    for (const Curve::Harmonic& h : g.curve.harmonics) { off.waves.push_back({real(h.cos), real(h.sin)}); }
    for (const bool second : {false, true}) {
        off.second = second;
        general::Equation equation;
        equation.measure = off;
        equation.of = of_;
        out_.push_back(equation);
    }
}

void JointWriter::formula() {
    if (!taken_out(Role::formula, 0)) { out_.push_back(equation_of_formula(joint_, of_)); }
}

void write_joint(const std::string_view type, JointWriter& writer) {
    const auto is = [&](std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, type) != names.end();
    };
    if (is({"spherical", "s", "universal", "revolute", "fixed"})) { writer.same_point(); }
    if (is({"revolute", "cylindrical", "prismatic", "screw", "fixed", "planar", "p1", "revolute-revolute"})) {
        writer.parallel_axes();
    }
    if (is({"cylindrical", "prismatic", "screw", "p2", "point-on-line"})) { writer.parallel_distance(); }
    if (is({"universal", "n1", "revolute-revolute-crossed"})) { writer.perpendicular_axes(); }
    if (is({"planar", "n2", "point-in-plane", "revolute-spherical", "revolute-revolute",
            "revolute-revolute-crossed"})) {
        writer.perpendicular_distance();
    }
    if (is({"revolute-revolute-crossed"})) { writer.perpendicular_distance_j(); }
    if (is({"prismatic", "fixed"})) { writer.perpendicular_sides(); }
    if (is({"distance", "universal-spherical", "revolute-spherical", "revolute-revolute",
            "revolute-revolute-crossed"})) {
        writer.length();
    }
    if (is({"screw"})) { writer.thread(); }
    if (is({"gear", "belt", "bevel-gear"})) { writer.mesh(); }
    if (is({"rack"})) { writer.rack(); }
    if (is({"curve"})) { writer.curve(); }
    if (is({"formula"})) { writer.formula(); }
}

void write_loads(const Loads& loads, general::Model& model) {
    model.gravity = real(loads.gravity);
    for (const AppliedForce& f : loads.forces) {
        model.forces.push_back(
            {{f.body, real(f.point_local)}, real(f.direction), f.frame == Frame::local, real(f.magnitude)});
    }
    for (const AppliedTorque& n : loads.torques) {
        model.torques.push_back(
            {n.body, real(n.direction), n.frame == Frame::local, real(n.magnitude), n.against});
    }
    for (const Spring& s : loads.springs) {
        model.springs.push_back(
            {{s.body_i, real(s.P_i_local)},
             {s.body_j, real(s.P_j_local)},
             s.stiffness,
             s.free_length,
             s.damping,
             s.s_i_local ? std::optional(general::Fixed{s.body_i, real(*s.s_i_local)}) : std::nullopt,
             real(s.friction),
             law_of(s.law)});
    }
    for (const RotationalSpring& s : loads.rotational_springs) {
        model.turning_springs.push_back(
            {angle_between(s.body_i, s.body_j, s.angle.s_i_local, s.angle.u_i_local, s.angle.u_j_local),
             s.stiffness, s.free_angle, s.damping, real(s.friction), law_of(s.law)});
    }
    for (const Bushing& b : loads.bushings) {
        // three springs along its axes; those of the generator do not resist turning
        for (Eigen::Index k = 0; k < 3; ++k) {
            model.springs.push_back(
                {{b.body_i, real(b.P_i_local)},
                 {b.body_j, real(b.P_j_local)},
                 b.stiffness[k],
                 0.0L,
                 b.damping[k],
                 general::Fixed{b.body_i, real(Vec3(b.axes_i_local.col(k)))}});
        }
    }
}

general::Body body_of(const Body& body, const std::optional<MassProperties>& mass) {
    general::Body out;
    out.fixed = body.fixed;
    out.r = real(body.r);
    out.p = body.p.cast<long double>().normalized();
    if (body.fixed || !mass) { return out; }
    out.v = real(body.r_dot);
    out.omega = reference::rotation(out.p) * real(body.omega_local);
    out.mass = mass->mass;
    out.centre = real(mass->centre_local);
    out.J = mass->J_local.cast<long double>();
    return out;
}

}  // namespace

general::WheelAngle first_wheel_of(const Joint& joint) {
    using Line = general::WheelAngle::Line;
    if (joint.type->name == "rack") { return wheel_of(joint, Line::rack, true); }
    return wheel_of(joint, joint.type->name == "bevel-gear" ? Line::normal : Line::centres, false);
}

std::vector<general::Equation> equations_of_joint(const Joint& joint, int of) {
    JointWriter writer(joint, of);
    write_joint(joint.type->name, writer);
    return writer.take();
}

general::Equation equation_of_driver(const Mechanism& mechanism, const Driver& driver, int of) {
    general::Equation out;
    out.of = of;
    out.target = real(driver.function);
    const int i = driver.body_i;
    const int j = driver.body_j;
    if (const auto* angle = std::get_if<AngleMeasure>(&driver.measure)) {
        out.measure = angle_between(i, j, angle->s_i_local, angle->u_i_local, angle->u_j_local);
        out.turns = true;
    } else if (const auto* way = std::get_if<DisplacementMeasure>(&driver.measure)) {
        const reference::Vec3 s = real(way->s_i_local);
        out.measure = general::Along{{i, s / s.norm()}, {i, real(way->B_i_local)}, {j, real(way->B_j_local)}};
    } else if (const auto* distance = std::get_if<SquaredDistanceMeasure>(&driver.measure)) {
        out.measure =
            general::SquaredDistance{{i, real(distance->P_i_local)}, {j, real(distance->P_j_local)}};
        out.squared = true;
    } else if (const auto* coordinate = std::get_if<CoordinateMeasure>(&driver.measure)) {
        out.measure = general::Coordinate{j, coordinate->coordinate};
    } else {
        out.measure = thread_of(mechanism.joints[static_cast<std::size_t>(driver.joint)]);
    }
    return out;
}

general::Model model_of(const Mechanism& mechanism, const Loads& loads) {
    general::Model model;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        model.bodies.push_back(body_of(mechanism.bodies[b], loads.masses[b]));
    }
    int of = 0;
    for (const Joint& joint : mechanism.joints) {
        for (general::Equation& equation : equations_of_joint(joint, of)) {
            model.equations.push_back(std::move(equation));
        }
        ++of;
    }
    for (const Driver& driver : mechanism.drivers) {
        model.equations.push_back(equation_of_driver(mechanism, driver, of++));
    }
    write_loads(loads, model);
    return model;
}

}  // namespace jw::test
