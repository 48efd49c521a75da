#include "tests/app/session/all_experiments.hpp"

#include "lessons/lesson/things.hpp"

namespace jw::test {

std::vector<Experiment> all_experiments(const Lesson& lesson, Random& random) {
    std::vector<Experiment> all;
    const Mechanism& m = lesson.mechanism;
    for (int j = 0; j < static_cast<int>(m.joints.size()); ++j) {
        const Joint& joint = m.joints[static_cast<std::size_t>(j)];
        for (int f = 0; f < 6; ++f) { all.push_back(SetParallelForm{j, static_cast<ParallelForm>(f)}); }
        for (int f = 0; f < 3; ++f) { all.push_back(SetScrewAngleForm{j, static_cast<ScrewAngleForm>(f)}); }
        for (const bool present : {false, true}) {
            all.push_back(SetPresent{{Addition::Kind::joint, j}, present});
            for (const LabelledEquation& e : equations_of(*joint.type, joint.parallel_form)) {
                all.push_back(SetEquationPresent{j, e.equation, present});
            }
        }
        JointGeometry point = joint.geometry;
        point.P_j_local = random.vector(1.0);
        JointGeometry anything = joint.geometry;
        anything.h_i_local = random.vector(1.0);
        anything.u_j_local = random.vector(1.0);
        anything.s_i_local = random.vector(1.0);
        anything.alpha = random.number(-1.0, 1.0);
        anything.theta_start = random.number(-9.0, 9.0);
        anything.screw_angle_form = ScrewAngleForm::sine;
        for (const JointGeometry& g :
             {point, anything, with_axis(joint.geometry, false, random.vector(1.0)),
              with_axis(joint.geometry, true, Vec3(0.0, 0.0, 2.0))}) {
            all.push_back(SetGeometry{j, g});
        }
    }
    for (int d = 0; d < static_cast<int>(m.drivers.size()); ++d) {
        for (const bool present : {false, true}) {
            all.push_back(SetPresent{{Addition::Kind::driver, d}, present});
        }
        TimeFunction moved = m.drivers[static_cast<std::size_t>(d)].function;
        moved.polynomial.resize(std::max<std::size_t>(2, moved.polynomial.size()));
        moved.polynomial[0] = random.number(-1.0, 1.0);
        moved.polynomial[1] = 0.5;
        for (const TimeFunction& f :
             {moved, random_function(random), TimeFunction{.table = random_table(random)},
              TimeFunction{.formula = dying_swing(0.5, 2.0, 0.25)}, TimeFunction{}}) {
            all.push_back(SetDriver{d, f});
        }
    }
    for (int c = 0; c < 4; ++c) { all.push_back(SetCoordinates{static_cast<CoordinateChoice>(c)}); }
    for (int b = 0; b < static_cast<int>(m.bodies.size()); ++b) {
        const Body& body = m.bodies[static_cast<std::size_t>(b)];
        for (const SetPose& pose :
             {SetPose{b, random.vector(1.0), random.unit_p()}, SetPose{b, body.r, random.unit_p()},
              SetPose{b, random.vector(1.0), body.p}, SetPose{b, body.r, body.p}}) {
            all.push_back(pose);
        }
        all.push_back(Drag{b, Vec3::Zero(), random.vector(1.0)});
        all.push_back(Drag{b, random.vector(1.0), random.vector(1.0)});
    }
    for (const Experiment& looking : std::vector<Experiment>{
             GoTo{0}, Release{}, ShowFreedom{2, -0.25}, LetGo{}, Undo{}, Redo{}, StartOver{}}) {
        all.push_back(looking);
    }
    return all;
}

}  // namespace jw::test
