#include "app/session/output/describe_inspection.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/text_table.hpp"

namespace jw {

namespace {

constexpr const char* kSlide24 =
    "    | M   Φqᵀ | |  q̈ |   | Q |\n"
    "    | Φq   0  | | −λ | = | γ |,   M = diag(m I, J′),   Q = [f; n′ − ω̃′J′ω′]\n\n";

std::string mass_text(const DynamicsView& dynamics) {
    TextRows table{{tr("body"), "m [kg]", "J′ [kg m²]", "f [N]", "n′ − ω̃′J′ω′ [N m]"}};
    TextRows motions{{tr("body"), "r̈ [m/s²]", "ω̇′ [rad/s²]"}};
    for (const DynamicsView::Body& body : dynamics.bodies) {
        for (Eigen::Index row = 0; row < 3; ++row) {
            const Vec3 line = body.J_local.row(row);
            const bool first = row == 0;
            table.push_back(
                {first ? body.name : "", first ? number_text(body.mass, 6) : "", vector_text(line),
                 first ? vector_text(body.f, 6) : "", first ? vector_text(body.n_local, 6) : ""});
        }
        motions.push_back({body.name, vector_text(body.r_ddot, 6), vector_text(body.omega_local_dot, 6)});
    }
    return text_table(table, columns_of_numbers(5, 2)) + '\n' + text_table(motions, columns_of_numbers(3, 2));
}

std::string lambda_text(const DynamicsView& dynamics) {
    if (dynamics.multipliers.empty()) { return {}; }
    TextRows table{{tr("λ of"), "", "", ""}};
    const std::string* owner = nullptr;
    for (const DynamicsView::Multiplier& m : dynamics.multipliers) {
        const bool same = owner != nullptr && *owner == m.owner;
        owner = &m.owner;
        table.push_back(
            {same ? "" : m.owner, m.row, number_text(m.lambda, 6), m.left_out ? tr("redundant") : ""});
    }
    std::vector<TextColumn> columns = columns_of_numbers(4, 2);
    columns[1].right = false;
    return '\n' + text_table(table, columns);
}

std::string energy_text(const DynamicsView& dynamics) {
    const Energy& energy = dynamics.energy;
    const std::string energies =
        tr("kinetic energy {0} J, potential energy {1} J, together {2} J", number_text(energy.kinetic, 8),
           number_text(energy.potential, 8), number_text(energy.kinetic + energy.potential, 8));
    const std::string momenta =
        tr("momentum {0} kg m/s, angular momentum about the origin {1} kg m²/s",
           vector_text(dynamics.momentum, 6), vector_text(dynamics.angular_momentum, 6));
    const std::string proof = tr("|M q̈ − Φqᵀ λ − Q| is {0} of |M q̈| + |Q|", small_text(dynamics.residual));
    return "\n  " + energies + "\n  " + momenta + "\n  " + proof + '\n';
}

}  // namespace

std::string describe(const DynamicsView& dynamics) {
    const std::string head = tr("Equations of motion in (r, ω′), bodies at their centres of mass:");
    return "  " + head + "\n" + kSlide24 + mass_text(dynamics) + lambda_text(dynamics) +
           energy_text(dynamics);
}

}  // namespace jw
