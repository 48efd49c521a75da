#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "core/motion/loads.hpp"
#include "lessons/lesson/lesson.hpp"

/// Invariants of every lesson that was read.
namespace jw::test {

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
        for (const FormulaStep& step : g.formula.steps) { add(step.number); }
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
        if (function.formula) {
            const std::array<double, 3> values = function.formula->taylor_at(0.0);
            add(values[0], values[1], values[2]);
        }
        if (!function.table) { return; }
        for (const double t : function.table->times) { add(t); }
        for (const double value : function.table->values) { add(value); }
    }
    void add_dynamics(const DynamicsPlan& plan) {
        const Loads& loads = plan.loads;
        add(loads.gravity, plan.duration, plan.settings.tolerance, plan.settings.step);
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
            add(s.P_i_local, s.P_j_local, s.stiffness, s.damping, s.free_length, s.friction.size,
                s.friction.speed);
            if (s.s_i_local) { add(*s.s_i_local); }
        }
        for (const RotationalSpring& s : loads.rotational_springs) {
            add_measure(s.angle);
            add(s.stiffness, s.damping, s.free_angle, s.friction.size, s.friction.speed);
        }
        for (const Bushing& b : loads.bushings) {
            add(b.P_i_local, b.P_j_local, b.axes_i_local, b.axes_j_local, b.stiffness, b.damping,
                b.rotational_stiffness, b.rotational_damping);
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
inline bool loads_are_sound(const Mechanism& m, const Loads& loads) {
    const auto moves = [&](int index) {
        return index >= 0 && index < static_cast<int>(m.bodies.size()) &&
               !m.bodies[static_cast<std::size_t>(index)].fixed;
    };
    try {
        centroidal(m, loads);
    } catch (const std::invalid_argument&) { return false; }  // a mass is missing or not positive
    return std::ranges::all_of(loads.forces, [&](const auto& force) { return moves(force.body); }) &&
           std::ranges::all_of(loads.torques, [&](const auto& torque) { return moves(torque.body); }) &&
           std::ranges::all_of(
               loads.springs, [&](const auto& s) { return moves(s.body_i) || moves(s.body_j); });
}

/// True if a lesson satisfies all conditions that its users take for granted.
inline bool is_sound(const Lesson& lesson) {
    const Mechanism& m = lesson.mechanism;
    const auto body = [&](int index) { return index >= 0 && index < static_cast<int>(m.bodies.size()); };
    bool good = lesson.order.size() == m.joints.size() + m.drivers.size() &&
                lesson.looks.size() == m.bodies.size() &&
                lesson.step_texts.joints.size() == m.joints.size() &&
                lesson.step_texts.drivers.size() == m.drivers.size() && m.moving_bodies_count() > 0;
    for (const Body& b : m.bodies) { good = good && std::abs(b.p.norm() - 1.0) < 2e-3; }
    for (const Joint& j : m.joints) {
        good = good && j.type != nullptr && body(j.body_i) && body(j.body_j) && j.body_i != j.body_j &&
               j.geometry.s_i_local.norm() > 0.0 &&
               (!j.type->has_formula() || !j.geometry.formula.steps.empty());
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

}  // namespace jw::test
