#include "app/session/output/describe_inspection.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/text_table.hpp"

namespace jw {

namespace {

constexpr const char* kSlide24 =
    "  Equations of motion in (r, ω′), bodies at their centres of mass:\n"
    "    | M   Φqᵀ | |  q̈ |   | Q |\n"
    "    | Φq   0  | | −λ | = | γ |,   M = diag(m I, J′),   Q = [f; n′ − ω̃′J′ω′]\n\n";

std::string mass_text(const DynamicsView& dynamics) {
    TextRows table{{"body", "m [kg]", "J′ [kg m²]", "f [N]", "n′ − ω̃′J′ω′ [N m]"}};
    TextRows motions{{"body", "r̈ [m/s²]", "ω̇′ [rad/s²]"}};
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
    TextRows table{{"λ of", "", "", ""}};
    const std::string* owner = nullptr;
    for (const DynamicsView::Multiplier& m : dynamics.multipliers) {
        const bool same = owner != nullptr && *owner == m.owner;
        owner = &m.owner;
        table.push_back(
            {same ? "" : m.owner, m.row, number_text(m.lambda, 6), m.left_out ? "repeats others" : ""});
    }
    std::vector<TextColumn> columns = columns_of_numbers(4, 2);
    columns[1].right = false;
    return '\n' + text_table(table, columns);
}

std::string energy_text(const DynamicsView& dynamics) {
    const Energy& energy = dynamics.energy;
    return "\n  kinetic energy " + number_text(energy.kinetic, 8) + " J, potential energy " +
           number_text(energy.potential, 8) + " J, together " +
           number_text(energy.kinetic + energy.potential, 8) + " J\n  momentum " +
           vector_text(dynamics.momentum, 6) + " kg m/s, angular momentum about the origin " +
           vector_text(dynamics.angular_momentum, 6) + " kg m²/s\n  |M q̈ − Φqᵀ λ − Q| is " +
           small_text(dynamics.residual) + " of |M q̈| + |Q|\n";
}

}  // namespace

std::string describe(const DynamicsView& dynamics) {
    return kSlide24 + mass_text(dynamics) + lambda_text(dynamics) + energy_text(dynamics);
}

}  // namespace jw
