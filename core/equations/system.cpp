#include "core/equations/system.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/elementary/elementary.hpp"
#include "core/jets/body_kinematics.hpp"
#include "core/jets/euler_parameters.hpp"

namespace jw {

namespace {

int equations_of(const Primitive& primitive) {
    return std::visit([](const auto& p) { return p.kEquations; }, primitive);
}

double unit_of(const Primitive& primitive, double length) {
    return std::visit([&](const auto& p) { return p.unit(length); }, primitive);
}

/// Distance from a pose at which the gradient of a formula is evaluated too: in units of length or radians.
constexpr double kBesidePose = 0.01;

/// Sets the sizes of the gradient of a formula by positions and by turns to the largest at a pose and beside
/// it, because the gradient may be 0 at the pose. Farther away it may be many times as large.
void set_size(
    FormulaEquation& formula, const std::array<Vec3, 2>& r, const std::array<Vec4, 2>& p, double length) {
    double by_length = 0.0;
    double by_turn = 0.0;
    const auto look = [&](const std::array<Vec3, 2>& at, const std::array<Vec4, 2>& turned) {
        const auto i = kinematics_at<OmegaLocal>(at[0], turned[0]);
        const auto j = kinematics_at<OmegaLocal>(at[1], turned[1]);
        const auto jet = equations<Content::jacobian>(formula, i, j, Theta{});
        for (const auto& block : {jet.block_i, jet.block_j}) {
            if (!block.allFinite()) { continue; }
            by_length = std::max(by_length, block.leftCols<3>().norm());
            by_turn = std::max(by_turn, block.rightCols<3>().norm());
        }
    };
    look(r, p);
    const auto [sine, cosine] = elementary::sine_and_cosine(0.5 * kBesidePose);
    for (std::size_t body = 0; body < 2; ++body) {
        for (int axis = 0; axis < 3; ++axis) {
            auto moved = r;
            moved[body](axis) += kBesidePose * length;
            look(moved, p);
            auto turned = p;
            turned[body] = product(p[body], Vec4(cosine * Vec4::Unit(0) + sine * Vec4::Unit(axis + 1)));
            look(r, turned);
        }
    }
    formula.by_length = by_length;
    formula.by_turn = by_length > 0.0 || by_turn > 0.0 ? by_turn : 1.0;
}

void require_index(int index, std::size_t size, const char* what) {
    if (index < 0 || static_cast<std::size_t>(index) >= size) {
        throw std::invalid_argument(
            std::string("System: ") + what + " " + std::to_string(index) + " of " + std::to_string(size));
    }
}

}  // namespace

Selection everything(const Mechanism& mechanism) {
    Selection selection;
    selection.joints.resize(mechanism.joints.size());
    selection.drivers.resize(mechanism.drivers.size());
    std::iota(selection.joints.begin(), selection.joints.end(), 0);
    std::iota(selection.drivers.begin(), selection.drivers.end(), 0);
    return selection;
}

System::System(const Mechanism& mechanism, Selection selection)
    : mechanism_(&mechanism), selection_(std::move(selection)), length_unit_(unit_of_length(mechanism)) {
    // columns: moving bodies, then the artificial coordinates of the joints present
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        order_of_body_.push_back(mechanism.bodies[b].fixed ? -1 : static_cast<int>(moving_bodies_.size()));
        if (!mechanism.bodies[b].fixed) { moving_bodies_.push_back(static_cast<int>(b)); }
    }
    order_of_theta_.assign(static_cast<std::size_t>(mechanism.thetas_count()), -1);
    const std::vector<int> thetas = mechanism.theta_indices();

    for (const int joint : selection_.joints) {
        require_index(joint, mechanism.joints.size(), "joint");
        add_joint(joint, thetas[static_cast<std::size_t>(joint)]);
    }
    for (const int driver : selection_.drivers) {
        require_index(driver, mechanism.drivers.size(), "driver");
        const Driver& d = mechanism.drivers[static_cast<std::size_t>(driver)];
        const int theta = d.joint >= 0 ? thetas[static_cast<std::size_t>(d.joint)] : -1;
        drivers_.push_back({driver, theta, 0, unit_of(d.measure, length_unit_)});
    }
    choose_rows(start_state(mechanism));
    number_rows();
}

void System::add_joint(int joint, int theta) {
    const Joint& j = mechanism_->joints[static_cast<std::size_t>(joint)];
    if (theta >= 0) {
        order_of_theta_[static_cast<std::size_t>(theta)] = static_cast<int>(active_thetas_.size());
        active_thetas_.push_back(theta);
    }
    for (const Role role : j.type->roles) {
        Constraint c;
        c.joint = joint;
        c.role = role;
        c.primitive = primitive_of(role, j.geometry, j.parallel_form);
        c.body_i = j.body_i;
        c.body_j = j.body_j;
        c.theta = theta;
        c.equations = equations_of(c.primitive);
        if (auto* formula = std::get_if<FormulaEquation>(&c.primitive)) {
            if (formula->formula.steps.empty()) {
                throw std::invalid_argument("joint '" + j.name + "' has no formula");
            }
            const Body& i = mechanism_->bodies[at(j.body_i)];
            const Body& other = mechanism_->bodies[at(j.body_j)];
            set_size(*formula, {i.r, other.r}, {i.p, other.p}, length_unit_);
        }
        c.unit = unit_of(c.primitive, length_unit_);
        for (const EquationOut& out : j.without) {
            if (out.role == role && out.component >= 0 && out.component < c.equations) {
                c.taken_out |= 1U << out.component;
            }
        }
        if (is_parallel(role)) { c.dropped = forced_drop(j.parallel_form); }
        constraints_.push_back(c);
    }
}

void System::number_rows() {
    origins_.clear();
    for (std::size_t k = 0; k < constraints_.size(); ++k) {
        Constraint& c = constraints_[k];
        c.first_row = static_cast<int>(origins_.size());
        for (int component = 0; component < c.equations; ++component) {
            if (!c.has_row(component)) { continue; }
            origins_.push_back({RowOrigin::Kind::constraint, static_cast<int>(k), component});
        }
    }
    for (std::size_t k = 0; k < drivers_.size(); ++k) {
        drivers_[k].row = static_cast<int>(origins_.size());
        origins_.push_back({RowOrigin::Kind::driver, static_cast<int>(k), 0});
    }
}

RowOrigin System::origin(int row) const {
    if (row < rows()) { return origins_[static_cast<std::size_t>(row)]; }
    return {RowOrigin::Kind::normalisation, moving_bodies_[static_cast<std::size_t>(row - rows())], 0};
}

double System::row_unit(int row) const {
    const RowOrigin o = origin(row);
    switch (o.kind) {
        case RowOrigin::Kind::constraint: return constraints_[static_cast<std::size_t>(o.index)].unit;
        case RowOrigin::Kind::driver: return drivers_[static_cast<std::size_t>(o.index)].unit;
        case RowOrigin::Kind::normalisation: break;
    }
    return 1.0;
}

bool System::choose_rows(const State& state) {
    bool changed = false;
    for (Constraint& c : constraints_) {
        const Joint& joint = mechanism_->joints[static_cast<std::size_t>(c.joint)];
        if (auto* formula = std::get_if<FormulaEquation>(&c.primitive)) {
            const std::size_t i = at(c.body_i);
            const std::size_t j = at(c.body_j);
            set_size(*formula, {state.r[i], state.r[j]}, {state.p[i], state.p[j]}, length_unit_);
            c.unit = unit_of(c.primitive, length_unit_);
        }
        if (!is_parallel(c.role) || joint.parallel_form != ParallelForm::rule) { continue; }
        if (c.taken_out != 0 && c.dropped >= 0) { continue; }
        const Vec3 s_i =
            rotation_matrix(state.p[static_cast<std::size_t>(c.body_i)]) * joint.geometry.s_i_local;
        const int dropped = choose_dropped(s_i, c.dropped);
        changed = changed || dropped != c.dropped;
        c.dropped = dropped;
    }
    if (changed) { number_rows(); }
    return changed;
}

void System::inherit_rows(const System& other) {
    // the constraints of a joint are consecutive
    std::vector<std::size_t> first_of_joint(mechanism_->joints.size(), other.constraints_.size());
    for (std::size_t k = other.constraints_.size(); k-- > 0;) {
        first_of_joint[at(other.constraints_[k].joint)] = k;
    }
    for (Constraint& c : constraints_) {
        const Joint& joint = mechanism_->joints[static_cast<std::size_t>(c.joint)];
        if (!is_parallel(c.role) || joint.parallel_form != ParallelForm::rule) { continue; }
        std::size_t k = first_of_joint[at(c.joint)];
        for (; k < other.constraints_.size() && other.constraints_[k].joint == c.joint; ++k) {
            const Constraint& same = other.constraints_[k];
            if (same.role != c.role) { continue; }
            if (same.dropped >= 0) { c.dropped = same.dropped; }
            break;
        }
    }
    number_rows();
}

}  // namespace jw
