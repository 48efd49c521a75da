#include "app/session/view/dynamics_view.hpp"

#include <algorithm>

#include "app/session/wording/labels.hpp"
#include "core/motion/dense/dense_equations.hpp"

namespace jw {

namespace {

// the dense system of twenty bodies takes some milliseconds
constexpr std::size_t kMostBodiesOfDynamics = 20;

DynamicsView::Body body_of(const DenseEquations<OmegaLocal>& equations, const MassProperties& own, int body) {
    const int column = equations.system().body_column(body, OmegaLocal::kAngular);
    DynamicsView::Body view;
    view.name = equations.system().mechanism().bodies[at(body)].name;
    view.mass = own.mass;
    view.J_local = own.J_local;
    view.f = equations.force().segment<3>(column);
    view.n_local = equations.force().segment<3>(column + 3);
    view.r_ddot = equations.acceleration().segment<3>(column);
    view.omega_local_dot = equations.acceleration().segment<3>(column + 3);
    return view;
}

std::vector<DynamicsView::Multiplier> multipliers_of(const DenseEquations<OmegaLocal>& equations) {
    const System& system = equations.system();
    std::vector<DynamicsView::Multiplier> list;
    for (int row = 0; row < static_cast<int>(equations.lambda().size()); ++row) {
        const bool kept = std::ranges::find(equations.kept_rows(), row) != equations.kept_rows().end();
        list.push_back(
            {row_owner(system, row), short_row_label(system, row), equations.lambda()(row), !kept});
    }
    return list;
}

double relative_residual(const DynamicsView& view) {
    const VectorX inertia = view.M * view.acceleration;
    const double size = inertia.norm() + view.Q.norm();
    const double left = (inertia - view.jacobian.transpose() * view.lambda - view.Q).norm();
    return size > 0.0 ? left / size : left;
}

void add_momenta(const Centroidal& scene, const State& state, const Motion& motion, DynamicsView& view) {
    for (std::size_t b = 0; b < scene.mechanism.bodies.size(); ++b) {
        if (scene.mechanism.bodies[b].fixed) { continue; }
        const MassProperties& own = *scene.loads.masses[b];
        const Vec3 momentum = own.mass * motion.r_dot[b];
        view.momentum += momentum;
        view.angular_momentum +=
            state.r[b].cross(momentum) + rotation_matrix(state.p[b]) * (own.J_local * motion.omega_local[b]);
    }
}

}  // namespace

bool DynamicsView::unique() const {
    return std::ranges::none_of(multipliers, &DynamicsView::Multiplier::left_out);
}

std::optional<DynamicsView> dynamics_view_of(
    const Centroidal& scene, double t, const State& state, const Motion& velocity,
    const std::optional<Energy>& energy) {
    if (scene.mechanism.bodies.size() > kMostBodiesOfDynamics) { return std::nullopt; }
    const State centred = scene.to_centroidal(state);
    const Motion motion = scene.to_centroidal(state, velocity);
    DenseEquations<OmegaLocal> equations(scene);
    std::vector<double> y(static_cast<std::size_t>(equations.size()));
    std::vector<double> y_dot(y.size());
    equations.pack(centred, motion, y.data());
    equations.choose_rows(t, y.data());
    equations.evaluate(t, y.data(), y_dot.data());

    DynamicsView view;
    view.M = equations.mass_matrix();
    view.jacobian = equations.jacobian();
    view.Q = equations.force();
    view.gamma = equations.right_side();
    view.lambda = equations.lambda();
    view.acceleration = equations.acceleration();
    view.multipliers = multipliers_of(equations);
    for (const int body : equations.system().moving_bodies()) {
        const MassProperties& own = *scene.loads.masses[at(body)];
        view.bodies.push_back(body_of(equations, own, body));
    }
    view.residual = relative_residual(view);
    view.energy = energy ? *energy : energy_of(scene, centred, motion);
    add_momenta(scene, centred, motion, view);
    return view;
}

std::optional<DynamicsView> dynamics_view_of(const Step& step) {
    if (!step.centroidal || step.kind != Step::Kind::motion) { return std::nullopt; }
    return dynamics_view_of(*step.centroidal, step.t, step.state, step.velocity, step.energy);
}

}  // namespace jw
