#include "core/dynamics/independent_coordinates.hpp"

#include <cmath>

#include <Eigen/QR>

namespace jw {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Smallest share of the largest pivot with which coordinates still tell the freedoms apart.
constexpr double kDistinct = 0.05;
/// Share of its first value to which the sine between coordinates may fall on the way.
constexpr double kStillDistinct = 0.3;

using Kinematics6 = BodyKinematics<OmegaLocal>;
using Row6 = Eigen::Matrix<double, 1, 6>;

Kinematics6 kinematics_of(const Body& body, const double* numbers) {
    Kinematics6 k;
    k.r = numbers != nullptr ? vec3(numbers) : body.r;
    k.p = numbers != nullptr ? vec4(numbers + 3) : body.p;
    k.A = OmegaLocal::rotation(k.p);
    if (numbers != nullptr) {
        k.r_dot = vec3(numbers + 7);
        OmegaLocal::set_motion(k, vec3(numbers + 10));
    }
    return k;
}

/// A measure with its gradient by the six columns of each body, its rate and its bias.
struct Value {
    double value = 0.0;
    double rate = 0.0;
    double bias = 0.0;
    Row6 by_i = Row6::Zero();
    Row6 by_j = Row6::Zero();
};

Value value_of(const Measure& measure, const Kinematics6& i, const Kinematics6& j) {
    return std::visit(
        [&](const auto& m) {
            const auto motion = measured<Content::motion>(m, i, j, Theta{});
            const auto gradient = measured<Content::jacobian>(m, i, j, Theta{});
            using J = std::decay_t<decltype(gradient)>;
            Value out{motion.value(0), motion.rate(0), motion.bias(0), Row6::Zero(), Row6::Zero()};
            if constexpr ((J::kSides & kBodyI) != 0) { out.by_i = gradient.block_i; }
            if constexpr ((J::kSides & kBodyJ) != 0) { out.by_j = gradient.block_j; }
            return out;
        },
        measure);
}

bool has_angle(const Joint& joint) {
    const auto name = joint.type->name;
    return name == "revolute" || name == "cylindrical" || name == "screw" || name == "planar";
}

bool has_displacement(const Joint& joint) {
    const auto name = joint.type->name;
    return name == "prismatic" || name == "cylindrical";
}

}  // namespace

IndependentCoordinates::IndependentCoordinates(const Centroidal& centroidal, MotionEquations& equations)
    : scene_(&centroidal), equations_(&equations) {
    const Mechanism& mechanism = centroidal.mechanism;
    int moving = 0;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        order_of_body_.push_back(mechanism.bodies[b].fixed ? -1 : moving++);
        if (mechanism.bodies[b].fixed) { continue; }
        for (int k = 0; k < 7; ++k) { of_bodies_.push_back({CoordinateMeasure{k}, 0, static_cast<int>(b)}); }
    }
    for (const Joint& joint : mechanism.joints) {
        if (has_angle(joint)) { of_joints_.push_back({angle_of(joint), joint.body_i, joint.body_j}); }
        if (has_displacement(joint)) {
            of_joints_.push_back({displacement_of(joint), joint.body_i, joint.body_j});
        }
    }
}

double IndependentCoordinates::scale_of(int coordinate, double length) const {
    const Measure& measure = chosen_[at(coordinate)].measure;
    const auto* of_body = std::get_if<CoordinateMeasure>(&measure);
    const bool is_length = std::holds_alternative<DisplacementMeasure>(measure) ||
                           (of_body != nullptr && of_body->coordinate < 3);
    return is_length ? length : 1.0;
}

/// Rows of six numbers per moving body.
MatrixX IndependentCoordinates::gradients(
    const std::vector<IndependentCoordinate>& of, const double* y) const {
    const auto bodies = std::ranges::count_if(order_of_body_, [](int order) { return order >= 0; });
    MatrixX rows = MatrixX::Zero(static_cast<Eigen::Index>(of.size()), 6 * bodies);
    const auto kinematics = [&](int body) {
        const int order = order_of_body_[at(body)];
        return kinematics_of(
            scene_->mechanism.bodies[at(body)], order < 0 ? nullptr : body_numbers(y, at(order)));
    };
    for (std::size_t k = 0; k < of.size(); ++k) {
        const Value value = value_of(of[k].measure, kinematics(of[k].body_i), kinematics(of[k].body_j));
        const auto row = static_cast<Eigen::Index>(k);
        const int i = order_of_body_[at(of[k].body_i)];
        const int j = order_of_body_[at(of[k].body_j)];
        if (i >= 0) { rows.block<1, 6>(row, 6 * i) += value.by_i; }
        if (j >= 0) { rows.block<1, 6>(row, 6 * j) += value.by_j; }
    }
    return rows;
}

VectorX IndependentCoordinates::choose(double t, const double* y) {
    const TangentSpace tangent = equations_->tangent_space(t, y);
    const Eigen::Index d = tangent.basis.cols();
    const auto choose_from = [&](const std::vector<IndependentCoordinate>& candidates) {
        // rows of equal size, so that units do not decide
        MatrixX rows = gradients(candidates, y) * tangent.basis;
        rows.rowwise().normalize();
        const Eigen::ColPivHouseholderQR<MatrixX> qr(rows.transpose());
        chosen_.clear();
        if (rows.rows() < d) { return 0.0; }
        for (Eigen::Index k = 0; k < d; ++k) {
            chosen_.push_back(candidates[at(qr.colsPermutation().indices()(k))]);
        }
        return d == 0 ? 1.0 : std::abs(qr.matrixR()(d - 1, d - 1) / qr.matrixR()(0, 0));
    };
    if (!(choose_from(of_joints_) > kDistinct)) {
        std::vector<IndependentCoordinate> all = of_joints_;
        all.insert(all.end(), of_bodies_.begin(), of_bodies_.end());
        choose_from(all);
    }
    driven_scene_ = *scene_;
    for (const IndependentCoordinate& c : chosen_) {
        driven_scene_.mechanism.drivers.push_back({"", -1, c.body_i, c.body_j, c.measure, TimeFunction{}});
    }
    driven_ = block_equations(driven_scene_);
    driven_->choose_rows(t, y);
    std::vector<double> here(y, y + equations_->size());
    driven_->project(t, here.data());
    pivot_at_choice_ = driven_->smallest_pivot();

    VectorX x(2 * d);
    const VectorX velocities = [&] {
        VectorX six(tangent.basis.rows());
        for (Eigen::Index k = 0; k < six.size(); ++k) {
            six(k) = body_numbers(y, at(static_cast<int>(k / 6)))[7 + k % 6];
        }
        return six;
    }();
    x.tail(d) = gradients(chosen_, y) * velocities;
    for (Eigen::Index k = 0; k < d; ++k) {
        const IndependentCoordinate& c = chosen_[at(static_cast<int>(k))];
        const auto kinematics = [&](int body) {
            const int order = order_of_body_[at(body)];
            return kinematics_of(
                scene_->mechanism.bodies[at(body)], order < 0 ? nullptr : body_numbers(y, at(order)));
        };
        x(k) = value_of(c.measure, kinematics(c.body_i), kinematics(c.body_j)).value;
    }
    return x;
}

bool IndependentCoordinates::is_sound() const {
    return driven_->smallest_pivot() > kStillDistinct * kStillDistinct * pivot_at_choice_;
}

void IndependentCoordinates::evaluate(
    double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot) {
    const auto d = static_cast<Eigen::Index>(chosen_.size());
    const int first = static_cast<int>(scene_->mechanism.drivers.size());
    for (Eigen::Index k = 0; k < d; ++k) {
        driven_->set_driver(first + static_cast<int>(k), x(k) - t * x(d + k), x(d + k));
    }
    driven_->project(t, y);
    equations_->evaluate(t, y, y_dot);
    x_dot.head(d) = x.tail(d);
    for (Eigen::Index k = 0; k < d; ++k) {
        const IndependentCoordinate& c = chosen_[at(static_cast<int>(k))];
        const int i = order_of_body_[at(c.body_i)];
        const int j = order_of_body_[at(c.body_j)];
        const double* numbers_i = i < 0 ? nullptr : body_numbers(y, at(i));
        const double* numbers_j = j < 0 ? nullptr : body_numbers(y, at(j));
        const Value value = value_of(
            c.measure, kinematics_of(scene_->mechanism.bodies[at(c.body_i)], numbers_i),
            kinematics_of(scene_->mechanism.bodies[at(c.body_j)], numbers_j));
        double acceleration = value.bias;
        const auto six = [&](int order) {
            return Eigen::Map<const Eigen::Matrix<double, 6, 1>>(body_numbers(y_dot, at(order)) + 7);
        };
        if (i >= 0) { acceleration += value.by_i * six(i); }
        if (j >= 0) { acceleration += value.by_j * six(j); }
        x_dot(d + k) = acceleration;
    }
}

}  // namespace jw
