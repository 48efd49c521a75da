#include "tests/app/host/checks.hpp"

#include <algorithm>
#include <cmath>

#include <sstream>

#include <imgui.h>

#include "app/session/output/describe.hpp"
#include "app/session/output/export.hpp"
#include "tests/app/session/view_numbers.hpp"

namespace jw::test {

namespace {

bool finite(double x) { return std::isfinite(x); }

std::string fault_of_state(const State& state) {
    const auto is_finite = [](const auto& v) { return v.allFinite(); };
    if (!std::ranges::all_of(state.r, is_finite)) { return "r is not finite"; }
    if (!std::ranges::all_of(state.p, is_finite)) { return "p is not finite"; }
    if (!std::ranges::all_of(state.theta, finite)) { return "θ is not finite"; }
    return {};
}

std::string fault_of_matrix(const View& view) {
    const MatrixView& m = view.matrix;
    if (static_cast<std::size_t>(m.values.rows()) != m.rows.size()) { return "rows and their labels differ"; }
    if (static_cast<std::size_t>(m.values.cols()) != m.columns.size()) {
        return "columns and their labels differ";
    }
    if (!m.values.allFinite()) { return "Φq is not finite"; }
    const std::vector<double>& sigma = view.rank.singular_values;
    if (!std::ranges::all_of(sigma, finite)) { return "a singular value is not finite"; }
    if (!std::ranges::is_sorted(sigma, std::greater<>())) { return "singular values are not in order"; }
    if (view.rank.rank > std::min(view.rank.rows, view.rank.columns)) { return "rank beyond the matrix"; }
    if (view.rank.dof != view.rank.columns - view.rank.rank) { return "freedoms are not columns less rank"; }
    return {};
}

std::string fault_of_view(const View& view) {
    for (const EquationGroup& group : view.equations) {
        for (const EquationRow& row : group.rows) {
            if (!finite(row.value)) { return "Φ of " + group.primitive + " is not finite"; }
            if (row.row >= view.rank.rows) { return "an equation beyond the last row"; }
        }
    }
    for (const NewtonRow& row : view.newton) {
        if (!finite(row.phi_norm)) { return "‖Φ‖ of an iteration is not finite"; }
        if (row.stepped && !(finite(row.delta_norm) && finite(row.turn_deg))) {
            return "a step is not finite";
        }
    }
    for (const BodyMotion& b : view.bodies) {
        const bool pose = b.r.allFinite() && b.p.allFinite();
        const bool rates =
            b.r_dot.allFinite() && b.r_ddot.allFinite() && b.omega.allFinite() && b.omega_dot.allFinite();
        if (!pose || !rates) { return "motion of " + b.body + " is not finite"; }
    }
    for (const QuantityMotion& q : view.quantities) {
        if (!finite(q.value) || !finite(q.rate) || !finite(q.acceleration)) {
            return q.name + " is not finite";
        }
    }
    return fault_of_matrix(view);
}

std::string fault_of_drawing() {
    const ImDrawData* const data = ImGui::GetDrawData();
    if (data == nullptr || !data->Valid) { return "nothing was drawn"; }
    for (int list = 0; list < data->CmdListsCount; ++list) {
        for (const ImDrawVert& v : data->CmdLists[list]->VtxBuffer) {
            if (!std::isfinite(v.pos.x) || !std::isfinite(v.pos.y)) { return "a vertex is nowhere"; }
        }
    }
    return {};
}

}  // namespace

std::string fault_of(const host::Host& host) {
    if (std::string fault = fault_of_drawing(); !fault.empty()) { return fault; }
    const render::Camera& camera = host.camera();
    if (host.session() == nullptr) { return {}; }
    if (!camera.eye.allFinite() || !camera.target.allFinite() || !(camera.eye - camera.target).norm()) {
        return "the camera is nowhere";
    }
    const Session& session = *host.session();
    const auto steps = static_cast<int>(session.story().steps().size());
    if (session.index() < 0 || session.index() >= steps) { return "no such step"; }
    const View& view = session.view();
    if (view.step != session.index() || view.steps != steps) { return "the view is of another step"; }
    if (!finite(view.t)) { return "t is not finite"; }
    if (std::string fault = fault_of_state(session.step().state); !fault.empty()) { return fault; }
    return fault_of_view(view);
}

std::string text_of(const View& view) {
    std::ostringstream out;
    out << std::hexfloat << describe(view, 1000) << matrix_csv(view.matrix) << numbers_of(view) << view.t;
    for (const BodyMotion& b : view.bodies) {
        out << b.body << b.r.transpose() << b.p.transpose() << b.r_dot.transpose() << b.omega.transpose()
            << b.r_ddot.transpose() << b.omega_dot.transpose();
    }
    for (const EquationGroup& group : view.equations) {
        for (const EquationRow& row : group.rows) { out << ' ' << row.value << ' ' << row.row; }
    }
    return out.str();
}

}  // namespace jw::test
