#include "tests/soak/changed.hpp"

#include <cmath>

namespace jw::test {

namespace {

Vec3 in_mirror(const Vec3& v) { return {v.x(), v.y(), -v.z()}; }

using Kind = FormulaStep::Kind;

/// Replaces t by the result of these steps applied to t.
void take_time(TimeFormula& formula, const std::vector<FormulaStep>& change) {
    std::vector<FormulaStep> steps;
    for (const FormulaStep& step : formula.formula.steps) {
        steps.push_back(step);
        if (step.kind == Kind::variable) { steps.insert(steps.end(), change.begin(), change.end()); }
    }
    formula.formula.steps = steps;
}

/// Divides the variables by `value` and `rate`, and multiplies the result by `factor`.
void scale(ScalarFormula& law, double value, double rate, double factor) {
    std::vector<FormulaStep> steps;
    for (const FormulaStep& step : law.steps) {
        steps.push_back(step);
        if (step.kind != Kind::variable) { continue; }
        steps.push_back({Kind::number, 1.0 / (step.number == 0.0 ? value : rate)});
        steps.push_back({Kind::product, 0.0});
    }
    steps.push_back({Kind::number, factor});
    steps.push_back({Kind::product, 0.0});
    law.steps = steps;
}

/// Divides the lengths among the variables by `length`.
void scale_lengths(ScalarFormula& formula, double length) {
    std::vector<FormulaStep> steps;
    for (const FormulaStep& step : formula.steps) {
        steps.push_back(step);
        const bool is_length = step.kind == Kind::variable &&
                               step.number >= variable_of(FormulaVector::d, 0) &&
                               step.number < variable_of(FormulaVector::A_i_x, 0);
        if (!is_length) { continue; }
        steps.push_back({Kind::number, 1.0 / length});
        steps.push_back({Kind::product, 0.0});
    }
    formula.steps = steps;
}

/// f at t / time, times a factor.
TimeFunction changed(TimeFunction f, double factor, double time) {
    double power = 1.0;
    for (double& c : f.polynomial) {
        c *= factor / power;
        power *= time;
    }
    for (TimeFunction::Harmonic& h : f.harmonics) {
        h.amplitude *= factor;
        h.omega /= time;
    }
    for (TimeFunction::SmoothStep& s : f.steps) {
        s = {factor * s.from, factor * s.to, time * s.start, time * s.end};
    }
    if (f.table) {
        for (double& t : f.table->times) { t *= time; }
        for (double& value : f.table->values) { value *= factor; }
        for (double& rate : f.table->rates) { rate *= factor / time; }
    }
    if (f.formula) {
        f.formula->unit *= factor;
        take_time(*f.formula, {{Kind::number, 1.0 / time}, {Kind::product, 0.0}});
    }
    return f;
}

/// Changes every part of a mechanism and of its loads.
class Changing {
public:
    explicit Changing(const Change& change) : c_(change) {}

    void operator()(Body& body) const {
        const Vec4 own = c_.mirrored ? mirrored(body.p) : body.p;
        body.p = reference::product(c_.p.cast<long double>(), own.cast<long double>()).cast<double>();
        body.r = c_.length * c_.global(body.r) + c_.shift;
        body.r_dot = c_.length / c_.time * c_.global(body.r_dot);
        body.omega_local = c_.local_turning(body.omega_local) / c_.time;
    }

    void operator()(Joint& joint) const {
        JointGeometry& g = joint.geometry;
        point(g.P_i_local);
        point(g.P_j_local);
        for (Vec3* v : {&g.s_i_local, &g.s_j_local, &g.h_i_local, &g.h_j_local, &g.u_i_local, &g.u_j_local}) {
            *v = c_.local(*v);
        }
        g.length *= c_.length;
        g.d_0 *= c_.length;
        scale_lengths(g.formula, c_.length);
        // a mirror turns right-handed screws into left-handed ones
        g.alpha *= c_.length * c_.hand();
        g.theta_0 *= c_.hand();
        if (g.theta_start) { *g.theta_start *= c_.hand(); }
        if (g.theta_dot_start) { *g.theta_dot_start *= c_.hand() / c_.time; }
        if (g.angle_dot_start) { *g.angle_dot_start *= c_.hand() / c_.time; }
        if (g.displacement_dot_start) { *g.displacement_dot_start *= c_.length / c_.time; }
    }

    void operator()(Driver& driver) const {
        const double factor = std::visit([&](auto& measure) { return change(measure); }, driver.measure);
        driver.function = changed(driver.function, factor, c_.time);
    }

    void operator()(Loads& loads) const {
        loads.gravity = c_.length / (c_.time * c_.time) * c_.global(loads.gravity);
        for (auto& mass : loads.masses) {
            if (mass) { change(*mass); }
        }
        for (AppliedForce& f : loads.forces) {
            point(f.point_local);
            f.direction = f.frame == Frame::local ? c_.local(f.direction) : c_.global(f.direction);
            f.magnitude = changed(f.magnitude, stiffness() * c_.length, c_.time);
        }
        for (AppliedTorque& n : loads.torques) {
            n.direction =
                n.frame == Frame::local ? c_.local_turning(n.direction) : c_.global_turning(n.direction);
            n.magnitude = changed(n.magnitude, stiffness() * c_.length * c_.length, c_.time);
        }
        for (Spring& s : loads.springs) { change(s); }
        for (RotationalSpring& s : loads.rotational_springs) { change(s); }
        for (Bushing& b : loads.bushings) { change(b); }
    }

private:
    /// Euler parameters of S A S.
    static Vec4 mirrored(const Vec4& p) {
        const Vec3 e = -in_mirror(p.tail<3>());
        return {p[0], e.x(), e.y(), e.z()};
    }
    void point(Vec3& P) const { P = c_.length * c_.local(P); }
    double stiffness() const { return c_.mass / (c_.time * c_.time); }
    double damping() const { return c_.mass / c_.time; }

    // @return factor of its function of time
    double change(AngleMeasure& m) const {
        for (Vec3* v : {&m.s_i_local, &m.u_i_local, &m.u_j_local}) { *v = c_.local(*v); }
        return c_.hand();
    }
    double change(DisplacementMeasure& m) const {
        m.s_i_local = c_.local(m.s_i_local);
        point(m.B_i_local);
        point(m.B_j_local);
        return c_.length;
    }
    double change(SquaredDistanceMeasure& m) const {
        point(m.P_i_local);
        point(m.P_j_local);
        return c_.length;
    }
    double change(const CoordinateMeasure& m) const {
        // x, y, z, then e0 ... e3 of S A S
        static constexpr std::array in_mirror{1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0};
        return (m.coordinate < 3 ? c_.length : 1.0) * (c_.mirrored ? in_mirror[at(m.coordinate)] : 1.0);
    }
    double change(const ThetaMeasure& /*m*/) const { return c_.hand(); }

    void change(MassProperties& m) const {
        m.mass *= c_.mass;
        point(m.centre_local);
        const double factor = c_.mass * c_.length * c_.length;
        for (Eigen::Index k = 0; k < 3; ++k) { m.J_local.col(k) = factor * c_.local(m.J_local.col(k)); }
        for (Eigen::Index k = 0; k < 3; ++k) {
            m.J_local.row(k) = c_.local(m.J_local.row(k).transpose()).transpose();
        }
    }
    void change(Spring& s) const {
        if (s.s_i_local) { s.s_i_local = c_.local(*s.s_i_local); }
        point(s.P_i_local);
        point(s.P_j_local);
        s.free_length *= c_.length;
        s.stiffness *= stiffness();
        s.damping *= damping();
        s.friction.size *= stiffness() * c_.length;
        s.friction.speed *= c_.length / c_.time;
        const double force = stiffness() * c_.length;
        if (s.law) { scale(*s.law, c_.length, c_.length / c_.time, force); }
    }
    void change(Bushing& b) const {
        point(b.P_i_local);
        point(b.P_j_local);
        for (Mat3* axes : {&b.axes_i_local, &b.axes_j_local}) {
            // still right-handed
            for (Eigen::Index k = 0; k < 3; ++k) { axes->col(k) = c_.hand() * c_.local(axes->col(k)); }
        }
        b.stiffness *= stiffness();
        b.damping *= damping();
        b.rotational_stiffness *= stiffness() * c_.length * c_.length;
        b.rotational_damping *= damping() * c_.length * c_.length;
    }
    void change(RotationalSpring& s) const {
        const double sign = change(s.angle);
        s.free_angle *= sign;
        s.stiffness *= stiffness() * c_.length * c_.length;
        s.damping *= damping() * c_.length * c_.length;
        s.friction.size *= stiffness() * c_.length * c_.length;
        s.friction.speed /= c_.time;
        const double torque = stiffness() * c_.length * c_.length;
        // a mirror changes the sign of the angle, and of its torque
        if (s.law) { scale(*s.law, sign, sign / c_.time, sign * torque); }
    }

    const Change& c_;
};

/// f(end - t).
TimeFunction backwards(const TimeFunction& f, double end) {
    TimeFunction out = f;
    // Horner's rule with end - t in the place of t
    std::vector<double> sum;
    for (std::size_t k = f.polynomial.size(); k-- > 0;) {
        std::vector<double> next(sum.size() + 1, 0.0);
        for (std::size_t n = 0; n < sum.size(); ++n) {
            next[n] += end * sum[n];
            next[n + 1] -= sum[n];
        }
        next[0] += f.polynomial[k];
        sum = next;
    }
    out.polynomial = sum;
    for (TimeFunction::Harmonic& h : out.harmonics) { h = {-h.amplitude, h.omega, -h.omega * end - h.phase}; }
    // seen from its end, a step from 0 to 1 is a step from 1 to 0
    for (TimeFunction::SmoothStep& s : out.steps) { s = {s.to, s.from, end - s.end, end - s.start}; }
    if (f.table) {
        std::vector<double> times(f.table->times.rbegin(), f.table->times.rend());
        for (double& t : times) { t = end - t; }
        out.table =
            table_through(times, {f.table->values.rbegin(), f.table->values.rend()}, f.table->interpolation);
    }
    if (out.formula) {
        take_time(*out.formula, {{Kind::negative, 0.0}, {Kind::number, end}, {Kind::sum, 0.0}});
    }
    return out;
}

}  // namespace

Vec3 Change::local(const Vec3& v) const { return mirrored ? in_mirror(v) : v; }
Vec3 Change::local_turning(const Vec3& v) const { return hand() * local(v); }
Vec3 Change::global(const Vec3& v) const {
    return (reference::rotation(p.cast<long double>()) * local(v).cast<long double>()).cast<double>();
}
Vec3 Change::global_turning(const Vec3& v) const { return hand() * global(v); }

bool knows_directions(const Mechanism& mechanism) {
    const auto of_joint = [](const Joint& joint) {
        const auto is_global = [](const EquationOut& out) { return out.role == Role::same_point; };
        const bool is_free = joint.parallel_form == ParallelForm::rule ||
                             joint.parallel_form == ParallelForm::pair ||
                             joint.parallel_form == ParallelForm::all_three;
        return !is_free || std::ranges::any_of(joint.without, is_global);
    };
    const auto of_driver = [](const Driver& driver) {
        return std::holds_alternative<CoordinateMeasure>(driver.measure);
    };
    return std::ranges::any_of(mechanism.joints, of_joint) ||
           std::ranges::any_of(mechanism.drivers, of_driver);
}

Generated changed(Generated generated, const Change& change) {
    const Changing changing(change);
    for (Body& body : generated.mechanism.bodies) { changing(body); }
    for (Joint& joint : generated.mechanism.joints) { changing(joint); }
    for (Driver& driver : generated.mechanism.drivers) { changing(driver); }
    changing(generated.loads);
    generated.length *= change.length;
    return generated;
}

Generated played_backwards(Generated generated, double end) {
    for (Driver& driver : generated.mechanism.drivers) { driver.function = backwards(driver.function, end); }
    for (AppliedForce& f : generated.loads.forces) { f.magnitude = backwards(f.magnitude, end); }
    for (AppliedTorque& n : generated.loads.torques) { n.magnitude = backwards(n.magnitude, end); }
    for (Spring& s : generated.loads.springs) {
        s.damping = -s.damping;
        s.friction.size = -s.friction.size;
        // backwards in time, the rate changes its sign
        if (s.law) { scale(*s.law, 1.0, -1.0, 1.0); }
    }
    for (RotationalSpring& s : generated.loads.rotational_springs) {
        s.damping = -s.damping;
        s.friction.size = -s.friction.size;
        // backwards in time, the rate changes its sign
        if (s.law) { scale(*s.law, 1.0, -1.0, 1.0); }
    }
    for (Bushing& b : generated.loads.bushings) {
        b.damping = -b.damping;
        b.rotational_damping = -b.rotational_damping;
    }
    return generated;
}

}  // namespace jw::test
