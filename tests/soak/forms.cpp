#include "tests/soak/forms.hpp"

namespace jw::test {

namespace {

Motion in_bodies(const Centroidal& scene, const std::vector<double>& flat) {
    const auto equations = block_equations(scene);
    std::vector<double> rate(flat.size());
    equations->choose_rows(0.0, flat.data());
    equations->evaluate(0.0, flat.data(), rate.data());
    return accelerations_in(scene, rate);
}

Motion in_joints(const Centroidal& scene, const std::vector<double>& flat) {
    TreeEquations tree(scene, flat);
    std::vector<double> y(at(tree.size()));
    std::vector<double> rate(y.size());
    tree.from_flat(flat.data(), y.data());
    tree.choose_rows(0.0, y.data());
    tree.evaluate(0.0, y.data(), rate.data());
    return accelerations_in_joints(tree, scene, 0.0, y, rate);
}

}  // namespace

Motion accelerations_in(const Centroidal& scene, const std::vector<double>& flat_dot) {
    Motion out = zero_motion(scene.mechanism);
    State ignored = start_state(scene.mechanism);
    unpack(flat_dot.data(), moving_bodies_of(scene.mechanism), ignored, out);
    return out;
}

Motion accelerations_in_joints(
    TreeEquations& tree, const Centroidal& scene, double t, const std::vector<double>& y,
    const std::vector<double>& y_dot) {
    std::vector<ProbedBody> bodies(at(tree.bodies()));
    tree.motion_of_bodies(t, y.data(), y_dot.data(), bodies);
    Motion out = zero_motion(scene.mechanism);
    const std::vector<int> moving = moving_bodies_of(scene.mechanism);
    for (std::size_t m = 0; m < moving.size(); ++m) {
        out.r_dot[at(moving[m])] = bodies[m].r_ddot;
        out.omega_local[at(moving[m])] = bodies[m].A.transpose() * bodies[m].alpha;
    }
    return out;
}

std::vector<Form> accelerations_in_all_forms(const Centroidal& scene) {
    const Moment moment{start_state(scene.mechanism), start_motion(scene.mechanism)};
    const std::vector<double> flat = flat_of(scene, moment);
    return {
        {"block equations", in_bodies(scene, flat)},
        {"joint coordinates", in_joints(scene, flat)},
        {"(r, omega')", dense_accelerations<OmegaLocal>(scene, moment, 0.0)},
        {"(r, omega)", dense_accelerations<OmegaGlobal>(scene, moment, 0.0)},
        {"(r, p)", dense_accelerations<TrueEulerParameters>(scene, moment, 0.0)},
        {"modified (r, p)", dense_accelerations<ModifiedEulerParameters>(scene, moment, 0.0)}};
}

}  // namespace jw::test
