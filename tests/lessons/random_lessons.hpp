#pragma once

#include <algorithm>
#include <string>

#include "core/model/placement.hpp"
#include "lessons/lesson/things.hpp"
#include "lessons/typed/typed.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Lessons that say everything a lesson can say, all numbers random.
namespace jw::test {

/// Geometry with the members that the format gives for a joint of this type; all others as a lesson has them.
inline JointGeometry as_in_lessons(const JointType& type, const JointGeometry& any) {
    const JointNeeds needs(type);
    JointGeometry g;
    if (needs.points) {
        g.P_i_local = any.P_i_local;
        g.P_j_local = any.P_j_local;
    }
    if (needs.axis) { g.s_i_local = any.s_i_local; }
    if (needs.axis_j) { g.s_j_local = any.s_j_local; }
    if (needs.sides && type.has_marks()) {
        g.h_i_local = g.u_i_local = perpendicular_to(any.s_i_local);
        g.h_j_local = g.u_j_local = any.s_j_local.cross(any.h_j_local).normalized();
    } else if (needs.sides) {
        g.h_i_local = any.h_i_local;
        g.h_j_local = any.h_j_local;
        g.u_i_local = unit_of(any.h_i_local);
        g.u_j_local = unit_of(any.h_j_local);
    }
    if (type.uses(Role::length)) { g.length = any.length; }
    if (type.uses(Role::screw_advance) || type.uses(Role::rack_advance)) {
        g.alpha = any.alpha;
        g.d_0 = any.d_0;
        g.theta_0 = any.theta_0;
    }
    if (type.uses(Role::wheel_i) || type.uses(Role::bevel_i)) { g.ratio = any.ratio; }
    if (type.uses(Role::curve_x)) { g.curve = any.curve; }
    if (type.has_formula()) { g.formula = any.formula; }
    if (type.uses(Role::screw_angle)) { g.screw_angle_form = any.screw_angle_form; }
    if (type.artificial > 0) {
        g.theta_start = any.theta_start;
        g.theta_dot_start = any.theta_dot_start;
    }
    if (type.has_angle()) { g.angle_dot_start = any.angle_dot_start; }
    if (type.has_displacement()) { g.displacement_dot_start = any.displacement_dot_start; }
    return g;
}

inline TimeFunction far_from_zero(Random& random) {
    TimeFunction f = random_function(random);
    // a distance is never negative
    f.polynomial = {random.number(5.0, 9.0)};
    return f;
}

inline MassProperties random_mass(Random& random) {
    // a cloud of points has a possible tensor; every second one is diagonal
    Mat3 J = Mat3::Zero();
    for (int k = 0; k < 4; ++k) {
        const Mat3 arm = tilde(random.vector());
        J += arm.transpose() * arm;
    }
    if (random.number() < 0.0) { J = Vec3(J.diagonal()).asDiagonal(); }
    return {random.number(1e-9, 1e9), random.vector(), 0.5 * (J + J.transpose())};
}

/// Loads of every kind on bodies 1 and 2, springs about every joint that has an angle.
inline DynamicsPlan random_dynamics(Random& random, const Mechanism& m, unsigned seed) {
    DynamicsPlan plan;
    plan.loads.masses = {{}, random_mass(random), random_mass(random)};
    // a driver moves the origin of body 2
    plan.loads.masses[2]->centre_local.setZero();
    plan.loads.gravity = random.vector();
    plan.duration = random.number(1.0, 2.0);
    plan.settings.method = kMethods[seed % kMethods.size()].method;
    plan.settings.treatment = kTreatments[seed % kTreatments.size()].treatment;
    plan.settings.tolerance = random.number(1e-9, 1e-3);
    plan.settings.step = random.number(1e-4, 1e-3);
    if (seed % 3 > 0) { plan.point = BodyPoint{2, random.vector()}; }
    if (seed % 3 > 1) { plan.point_at_end = random.vector(); }
    for (const Frame frame : {Frame::global, Frame::local}) {
        plan.loads.forces.push_back({1, random.vector(), random.vector(), frame, random_function(random)});
        plan.loads.forces.push_back({2, random.vector(), random.direction(), frame, {.polynomial = {1.0}}});
        plan.loads.torques.push_back({2, random.direction(), frame, random_function(random)});
        plan.loads.torques.push_back({1, random.vector(), frame, {}, 2});
    }
    plan.loads.forces.back().magnitude.table = random_table(random);
    plan.loads.springs = {
        {0, 1, random.vector(), random.vector(), random.number(0.0, 1e5), 0.0, random.number(0.0, 9.0)},
        {1, 2, random.vector(), random.vector(), 0.0, random.number(0.0, 9.0), 0.0}};
    plan.loads.bushings = {random_bushing(random, 0, 2), random_bushing(random, 1, 2)};
    plan.loads.bushings[1].damping = Vec3(0.0, 1.0, 0.5);
    for (Bushing& bushing : plan.loads.bushings) {
        // y is computed from z and x, as by the reader
        for (Mat3* axes : {&bushing.axes_i_local, &bushing.axes_j_local}) {
            axes->col(1) = axes->col(2).cross(axes->col(0));
        }
    }
    plan.loads.bushings[1].rotational_stiffness = Vec3::Zero();
    for (const Joint& joint : m.joints) {
        if (joint.type->has_displacement()) {
            const DisplacementMeasure along = displacement_of(joint);
            plan.loads.springs.push_back(
                {joint.body_i, joint.body_j, along.B_i_local, along.B_j_local, random.number(0.0, 9.0),
                 random.number(), random.number(0.0, 9.0), along.s_i_local});
        }
        if (!joint.type->has_angle()) { continue; }
        plan.loads.rotational_springs.push_back(
            {joint.body_i, joint.body_j, angle_of(joint), random.number(0.0, 9.0), random.number(),
             random.number(0.0, 9.0)});
    }
    return plan;
}

/// Questions of the kinds that are clicked or dragged.
inline std::vector<Question> random_questions(Random& random, const Lesson& lesson) {
    std::vector<Question> questions;
    for (const auto kind : {Thing::Kind::body, Thing::Kind::joint, Thing::Kind::vector, Thing::Kind::row}) {
        PointedAnswer answer{kind, {}, {}};
        for (const Thing& thing : things_of(lesson.mechanism, kind)) {
            if (random.number() < -0.6) { answer.right.push_back(thing); }
        }
        if (answer.right.empty()) { answer.right = {things_of(lesson.mechanism, kind).back()}; }
        questions.push_back({Question::Place::addition, lesson.order[1], "Which?", answer, "why", {}});
    }
    const PointedAnswer found{Thing::Kind::row, {}, RowsFound::redundant};
    questions.push_back({Question::Place::bodies, {}, "Which?", found, "", {}});
    const PoseAnswer pose{
        1, AtTime{random.number(1.0, 2.0), false}, random.number(1e-3, 1.0), random.number(1e-3, 1.0)};
    questions.push_back({Question::Place::motion, {}, "Where?", pose, "", {}});
    return questions;
}

/// Joints of every type, drivers of every kind, words and looks: all numbers random.
inline Lesson random_lesson(unsigned seed) {
    Random random(seed);
    Lesson lesson;
    lesson.file_name = "random.toml";
    lesson.title = "Random " + std::to_string(seed);
    Mechanism& m = lesson.mechanism;
    m.bodies = {random_body(random, "ground"), random_body(random, "i \\ \u03c6"), random_body(random, "j")};
    m.bodies[0].fixed = true;
    for (const JointType& type : kJointTypes) {
        Mechanism one = random_joint(
            random, type, static_cast<ParallelForm>(seed % 6), static_cast<ScrewAngleForm>(seed % 3));
        Joint joint = one.joints[0];
        joint.name = "the " + std::string(type.name);
        joint.body_i = static_cast<int>(seed % 2);
        joint.body_j = 2;
        if (seed % 2 == 0) { joint.geometry.theta_start = random.number(-20.0, 20.0); }
        if (seed % 3 == 0) { joint.geometry.theta_dot_start = random.number(); }
        // start rates need dynamics, which every second lesson has
        if (seed % 6 == 4) { joint.geometry.angle_dot_start = random.number(); }
        if (seed % 6 < 5 && seed % 2 == 0) { joint.geometry.displacement_dot_start = random.number(); }
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
        if (joint.type->has_angle()) {
            const bool screw = joint.type->artificial > 0;
            add(screw ? Measure(ThetaMeasure{}) : Measure(angle_of(joint)), k, joint.body_i, joint.body_j);
        }
        if (joint.type->has_displacement()) { add(displacement_of(joint), k, joint.body_i, joint.body_j); }
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
    if (seed % 2 == 0) { lesson.dynamics = random_dynamics(random, m, seed); }
    lesson.step_texts.times = {{1.0, "from 1 s"}, {1.5, "then\n\nthis"}};
    lesson.questions = random_questions(random, lesson);
    lesson.camera.from = random.direction();
    lesson.camera.target = random.vector();
    lesson.camera.distance = random.number(1.0, 2.0);
    lesson.camera.up = random.direction();
    lesson.camera.orthographic = true;
    return lesson;
}

}  // namespace jw::test
