#include "app/session/try/experiments.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/session/story/story.hpp"
#include "app/session/try/experiment_text.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writer.hpp"

namespace jw {

namespace {

bool is_index(int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; }

Edit refused(std::string why) { return {std::nullopt, std::move(why)}; }

/// Shortest turn from one direction to another.
Mat3 turn_between(const Vec3& from, const Vec3& to) {
    const Vec3 a = from.normalized();
    const Vec3 b = to.normalized();
    const double cosine = a.dot(b);
    if (cosine < -1.0 + 1e-12) {
        const Vec3 side = a.unitOrthogonal();
        return 2.0 * side * side.transpose() - Mat3::Identity();
    }
    const Mat3 v = tilde(a.cross(b));
    return Mat3::Identity() + v + v * v / (1.0 + cosine);
}

bool is_finite(const TimeFunction& f) {
    const auto finite = [](double value) { return std::isfinite(value); };
    return std::ranges::all_of(f.polynomial, finite) &&
           std::ranges::all_of(
               f.harmonics,
               [&](const auto& h) { return finite(h.amplitude) && finite(h.omega) && finite(h.phase); }) &&
           std::ranges::all_of(
               f.steps,
               [&](const auto& s) {
                   return finite(s.from) && finite(s.to) && finite(s.start) && finite(s.end) &&
                          s.start < s.end;
               }) &&
           (!f.table ||
            (std::ranges::all_of(f.table->times, finite) && std::ranges::all_of(f.table->values, finite)));
}

bool usable(const JointGeometry& g) {
    const auto is_usable = [&](const auto& key) {
        const Vec3& v = g.*key.member;
        const bool is_point = &v == &g.P_i_local || &v == &g.P_j_local;
        return v.allFinite() && (is_point || v.norm() > 1e-9);
    };
    return std::ranges::all_of(experiment_text::kVectors, is_usable) && std::isfinite(g.length);
}

/// Geometry with 0 for each minus zero: lesson files and sentences have no minus zero.
JointGeometry without_minus_zeros(JointGeometry g) {
    for (const auto& key : experiment_text::kVectors) { g.*key.member += Vec3::Zero(); }
    for (const auto& key : experiment_text::kNumbers) { g.*key.member += 0.0; }
    for (const auto& key : experiment_text::kOptional) {
        if (g.*key.member) { *(g.*key.member) += 0.0; }
    }
    return g;
}

TimeFunction without_minus_zeros(TimeFunction f) {
    for (double& c : f.polynomial) { c += 0.0; }
    for (TimeFunction::Harmonic& h : f.harmonics) {
        for (double* x : {&h.amplitude, &h.omega, &h.phase}) { *x += 0.0; }
    }
    for (TimeFunction::SmoothStep& s : f.steps) {
        for (double* x : {&s.from, &s.to, &s.start, &s.end}) { *x += 0.0; }
    }
    if (f.table) {
        for (auto* list : {&f.table->times, &f.table->values}) {
            for (double& x : *list) { x += 0.0; }
        }
    }
    return f;
}

/// True for an experiment with its own numbers; the others choose from values that a lesson can express.
bool says_numbers(const Experiment& experiment) {
    return std::holds_alternative<SetGeometry>(experiment) || std::holds_alternative<SetDriver>(experiment) ||
           std::holds_alternative<SetPose>(experiment);
}

/// The first error in the file that the lesson would become; empty if there is none.
std::string mistake_in(const Lesson& lesson) {
    try {
        const ReadResult read = read_lesson(lesson_text(lesson), lesson.file_name);
        if (read.lesson) { return {}; }
        return std::ranges::find(read.diagnostics, Severity::error, &Diagnostic::severity)->message;
    } catch (const std::invalid_argument& error) { return error.what(); }
}

/// Reason why the changed lesson could not be read again after it was saved; empty if it could. Also empty if
/// this was true before the change, because such a lesson was made by code that does not save it.
std::string why_not_savable(const Lesson& changed, const Lesson& before) {
    const std::string mistake = mistake_in(changed);
    if (mistake.empty() || !mistake_in(before).empty()) { return {}; }
    return tr("this cannot be written as a lesson: {0}", mistake);
}

class Editor {
public:
    Editor(Lesson lesson, const Lesson& written) : lesson_(std::move(lesson)), written_(written) {}

    Edit operator()(const SetParallelForm& a) {
        Joint* const joint = joint_of(a.joint);
        if (joint == nullptr) { return refused(tr("there is no such joint")); }
        if (!joint->type->uses(Role::axes_parallel) && !joint->type->uses(Role::distance_parallel)) {
            return refused(tr("{0} has no p1 or p2", joint->name));
        }
        joint->parallel_form = a.form;
        return done(joint->name + ": " + name_of_form(a.form));
    }

    Edit operator()(const SetScrewAngleForm& a) {
        Joint* const joint = joint_of(a.joint);
        if (joint == nullptr || !joint->type->uses(Role::screw_angle)) {
            return refused(tr("only a screw has an angle row"));
        }
        joint->geometry.screw_angle_form = a.form;
        return done(joint->name + ": " + tr(label_of(kAngleRows, a.form)));
    }

    Edit operator()(const SetCoordinates& a) {
        lesson_.coordinates = a.choice;
        return done(tr("coordinates {0}", name_of_choice(a.choice)));
    }

    Edit operator()(const SetPresent& a) {
        const std::size_t size = a.what.kind == Addition::Kind::joint ? lesson_.mechanism.joints.size()
                                                                      : lesson_.mechanism.drivers.size();
        if (!is_index(a.what.index, size)) {
            return refused(tr("there is no joint or driver of that number"));
        }
        const std::string name = name_of(a.what, lesson_.mechanism);
        const bool is_present = std::ranges::find(lesson_.order, a.what) != lesson_.order.end();
        if (is_present == a.present) {
            return refused(
                is_present ? tr("{0} is already present", name) : tr("{0} is already taken out", name));
        }
        if (a.present) { return put_back(a.what, name); }
        std::erase(lesson_.order, a.what);
        // a driver is taken out with the joint that it drives
        std::erase_if(lesson_.order, [&](const Addition& other) {
            return a.what.kind == Addition::Kind::joint && joint_driven_by(other) == a.what.index;
        });
        return done(tr("{0} taken out", name));
    }

    Edit operator()(const SetEquationPresent& a) {
        Joint* const joint = joint_of(a.joint);
        if (joint == nullptr || !joint->type->uses(a.equation.role)) {
            return refused(tr("the joint has no such equation"));
        }
        const auto found = std::ranges::find(joint->without, a.equation);
        const bool is_present = found == joint->without.end();
        if (is_present == a.present) { return refused(tr("nothing changes")); }
        if (a.present) {
            joint->without.erase(found);
        } else {
            joint->without.push_back(a.equation);
        }
        const std::string name = joint->name + " · " + name_of_role(a.equation.role, joint->parallel_form);
        return done(a.present ? tr("{0}: equation put back", name) : tr("{0}: equation taken out", name));
    }

    Edit operator()(const SetGeometry& a) {
        Joint* const joint = joint_of(a.joint);
        if (joint == nullptr) { return refused(tr("there is no such joint")); }
        if (!usable(a.geometry)) { return refused(tr("points must be finite and directions not zero")); }
        if (joint->type->uses(Role::length) && a.geometry.length <= 0.0) {
            return refused(tr("a length must be above 0"));
        }
        set_geometry(a.joint, without_minus_zeros(a.geometry));
        return done(tr("{0} moved", joint->name));
    }

    Edit operator()(const SetDriver& a) {
        if (!is_index(a.driver, lesson_.mechanism.drivers.size())) {
            return refused(tr("there is no such driver"));
        }
        if (!is_finite(a.function)) {
            return refused(tr("numbers of a driver must be finite, a step must have an end"));
        }
        Driver& driver = lesson_.mechanism.drivers[at(a.driver)];
        driver.function = without_minus_zeros(a.function);
        return done(tr("{0} changed", driver.name));
    }

    Edit operator()(const SetPose& a) {
        if (!is_index(a.body, lesson_.mechanism.bodies.size())) {
            return refused(tr("there is no such body"));
        }
        Body& body = lesson_.mechanism.bodies[at(a.body)];
        if (body.fixed) { return refused(tr("{0} is fixed: it has no unknowns.", body.name)); }
        if (!a.r.allFinite() || !(std::abs(a.p.norm() - 1.0) <= kUnitP)) {
            return refused(tr("the position must be finite, and the Euler parameters must have length 1"));
        }
        body.r = a.r + Vec3::Zero();
        body.p = a.p + Vec4::Zero();
        return done(tr("{0} placed", body.name));
    }

    template <class E>
    requires(!EditsLesson<E>) Edit operator()(const E& /*experiment*/) { return refused(""); }

private:
    Joint* joint_of(int index) {
        return is_index(index, lesson_.mechanism.joints.size()) ? &lesson_.mechanism.joints[at(index)]
                                                                : nullptr;
    }

    /// Gives a joint another geometry, by which its drivers and the springs on its axis measure from then on.
    void set_geometry(int index, const JointGeometry& geometry) {
        Joint& joint = lesson_.mechanism.joints[at(index)];
        const Joint before = joint;
        joint.geometry = geometry;
        measure_anew(index);
        if (!lesson_.dynamics) { return; }
        Loads& loads = lesson_.dynamics->loads;
        const auto take_displacement = [&](Spring& spring) {
            if (!acts_along(spring, before)) { return; }
            const DisplacementMeasure displacement = displacement_of(joint);
            spring.s_i_local = displacement.s_i_local;
            spring.P_i_local = displacement.B_i_local;
            spring.P_j_local = displacement.B_j_local;
        };
        std::ranges::for_each(loads.springs, take_displacement);
        for_each_measuring<Spring>(loads, take_displacement);
        for_each_angle(loads, [&](RotationalSpring& spring) {
            if (acts_about(spring, before)) { spring.angle = angle_of(joint); }
        });
        for_each_law(loads, [&](LoadLaw& law) {
            for (auto& [name, measured] : law.quantities) {
                auto* distance = std::get_if<Spring>(&measured);
                if (distance == nullptr || name != joint.name + ".distance") { continue; }
                distance->P_i_local = geometry.P_i_local;
                distance->P_j_local = geometry.P_j_local;
            }
        });
    }

    /// Updates the measures of the drivers along a joint to its new geometry.
    void measure_anew(int index) {
        const Joint& joint = lesson_.mechanism.joints[at(index)];
        for (Driver& driver : lesson_.mechanism.drivers) {
            if (driver.joint != index) { continue; }
            driver.measure = std::visit(
                Overloaded{
                    [&](const AngleMeasure&) -> Measure { return angle_of(joint); },
                    [&](const DisplacementMeasure&) -> Measure { return displacement_of(joint); },
                    [](const SquaredDistanceMeasure& m) -> Measure { return m; },
                    [](const CoordinateMeasure& m) -> Measure { return m; },
                    [](const ThetaMeasure& m) -> Measure { return m; },
                },
                driver.measure);
        }
    }

    /// The joint that a driver acts along, -1 for anything else.
    int joint_driven_by(const Addition& addition) const {
        if (addition.kind == Addition::Kind::joint) { return -1; }
        return lesson_.mechanism.drivers[at(addition.index)].joint;
    }

    /// Puts `what` back, after everything that the author has before it.
    Edit put_back(const Addition& what, const std::string& name) {
        const Addition its_joint{Addition::Kind::joint, joint_driven_by(what)};
        if (its_joint.index >= 0 && std::ranges::find(lesson_.order, its_joint) == lesson_.order.end()) {
            return refused(
                tr("{0} drives {1}: put {1} back first", name, name_of(its_joint, lesson_.mechanism)));
        }
        const auto rank = [&](const Addition& a) { return std::ranges::find(written_.order, a); };
        const auto later =
            std::ranges::find_if(lesson_.order, [&](const Addition& a) { return rank(a) > rank(what); });
        lesson_.order.insert(later, what);
        return done(tr("{0} put back", name));
    }

    Edit done(std::string what) { return {std::move(lesson_), std::move(what)}; }

    Lesson lesson_;
    const Lesson& written_;
};

}  // namespace

JointGeometry with_axis(const JointGeometry& geometry, bool in_body_j, const Vec3& s_local) {
    JointGeometry moved = geometry;
    Vec3& s = in_body_j ? moved.s_j_local : moved.s_i_local;
    Vec3& h = in_body_j ? moved.h_j_local : moved.h_i_local;
    Vec3& u = in_body_j ? moved.u_j_local : moved.u_i_local;
    const Mat3 turn = turn_between(s, s_local);
    s = s_local.normalized() * s.norm();
    h = turn * h;
    u = turn * u;
    return moved;
}

Edit edit_of(Lesson lesson, const Lesson& written, const Experiment& experiment) {
    return std::visit(Editor(std::move(lesson), written), experiment);
}

Edit edited(const Lesson& lesson, const Lesson& written, const Experiment& experiment) {
    return edited(lesson, written, std::span(&experiment, 1));
}

Edit edited(const Lesson& lesson, const Lesson& written, std::span<const Experiment> experiments) {
    Edit edit{lesson, {}};
    for (const Experiment& experiment : experiments) {
        edit = edit_of(std::move(*edit.lesson), written, experiment);
        if (!edit.lesson) { return edit; }
    }
    if (std::ranges::none_of(experiments, says_numbers)) { return edit; }
    std::string why = why_not_savable(*edit.lesson, lesson);
    return why.empty() ? edit : refused(std::move(why));
}

std::vector<Experiment> moves_to(const State& state, const Lesson& lesson) {
    std::vector<Experiment> moves;
    Mechanism moved = lesson.mechanism;
    for (std::size_t b = 0; b < moved.bodies.size(); ++b) {
        Body& body = moved.bodies[b];
        // a pose in hand has every p normalised, which is not a motion
        const double turned = (body.p - state.p[b]).cwiseAbs().maxCoeff();
        if (body.fixed || (body.r == state.r[b] && turned <= kUnitUpToRounding)) { continue; }
        body.r = state.r[b];
        body.p = state.p[b];
        moves.emplace_back(SetPose{static_cast<int>(b), body.r, body.p});
    }
    // a θ that is not given is measured; it need not be given if it equals the measured one
    const std::vector<double> measured = start_state(moved).theta;
    const std::vector<int> thetas = moved.theta_indices();
    for (std::size_t j = 0; j < moved.joints.size(); ++j) {
        const auto k = at(std::max(0, thetas[j]));
        if (thetas[j] < 0 || measured[k] == state.theta[k]) { continue; }
        JointGeometry geometry = moved.joints[j].geometry;
        geometry.theta_start = state.theta[k];
        moves.emplace_back(SetGeometry{static_cast<int>(j), geometry});
    }
    return moves;
}

}  // namespace jw
