#include "app/session/output/json.hpp"
#include "app/session/view/dynamics_view.hpp"

namespace jw {

namespace {

Json bodies_of(const DynamicsView& dynamics) {
    Json list = Json::array();
    for (const DynamicsView::Body& body : dynamics.bodies) {
        list.push_back(
            {{"name", body.name},
             {"mass", number(body.mass)},
             {"J_local", json_of(MatrixX(body.J_local))},
             {"f", json_of(body.f)},
             {"n_local", json_of(body.n_local)},
             {"r_ddot", json_of(body.r_ddot)},
             {"omega_local_dot", json_of(body.omega_local_dot)}});
    }
    return list;
}

Json multipliers_of(const DynamicsView& dynamics) {
    Json list = Json::array();
    for (const DynamicsView::Multiplier& multiplier : dynamics.multipliers) {
        list.push_back(
            {{"owner", multiplier.owner},
             {"row", multiplier.row},
             {"lambda", number(multiplier.lambda)},
             {"left_out", multiplier.left_out}});
    }
    return list;
}

}  // namespace

Json json_of(const std::optional<DynamicsView>& dynamics) {
    if (!dynamics) { return {}; }
    return {
        {"bodies", bodies_of(*dynamics)},
        {"multipliers", multipliers_of(*dynamics)},
        {"M", json_of(dynamics->M)},
        {"jacobian", json_of(dynamics->jacobian)},
        {"Q", json_of(dynamics->Q)},
        {"acceleration", json_of(dynamics->acceleration)},
        {"lambda", json_of(dynamics->lambda)},
        {"gamma", json_of(dynamics->gamma)},
        {"residual", number(dynamics->residual)},
        {"kinetic_energy", number(dynamics->energy.kinetic)},
        {"potential_energy", number(dynamics->energy.potential)},
        {"momentum", json_of(dynamics->momentum)},
        {"angular_momentum", json_of(dynamics->angular_momentum)}};
}

}  // namespace jw
