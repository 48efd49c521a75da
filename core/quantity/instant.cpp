#include <stdexcept>

#include "core/equations/assembler.hpp"
#include "core/poses/large_rank.hpp"
#include "core/quantity/evaluate.hpp"

namespace jw {

const RankReport& Instant::rank() const {
    if (!rank_) {
        Assembler<OmegaLocal> assembler(*system);
        assembler.assemble_phi_and_jacobian(state, t);
        rank_ = analyse_rank_of_any_size(*system, assembler.sparse_jacobian(), assembler.phi(), true);
    }
    return *rank_;
}

const Reactions& Instant::reactions() const {
    if (!reactions_) {
        const Motion found = find_centroidal_acceleration();
        reactions_ = reactions_from_body_frames(*scene, t, state, velocity, found);
    }
    return *reactions_;
}

Energy Instant::find_energy() const {
    if (energy) { return *energy; }
    if (!scene) { throw std::logic_error("an instant without masses has no energy"); }
    return energy_of(*scene, scene->to_centroidal(state), scene->to_centroidal(state, velocity));
}

Motion Instant::find_centroidal_acceleration() const {
    if (centroidal_acceleration) { return *centroidal_acceleration; }
    if (!scene || !acceleration) {
        throw std::logic_error("an instant without masses or accelerations has no centroidal ones");
    }
    Motion found = *acceleration;
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        const Vec3& c = scene->centres[b];
        const Vec3& omega = velocity.omega_local[b];
        const Vec3 by_turning = found.omega_local[b].cross(c) + omega.cross(omega.cross(c));
        found.r_dot[b] += rotation_matrix(state.p[b]) * by_turning;
    }
    return found;
}

}  // namespace jw
