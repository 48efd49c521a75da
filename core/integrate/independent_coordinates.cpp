#include "core/integrate/independent_coordinates.hpp"

#include <algorithm>
#include <cmath>

#include "core/eigen/decompositions.hpp"
#include "core/jets/body_kinematics.hpp"
#include "core/model/joint_types.hpp"
#include "core/motion/flat_state.hpp"

namespace jw {

namespace {

/// Smallest ratio of pivots with which coordinates still distinguish the freedoms.
constexpr double kDistinct = 0.05;
/// Share of its first value to which the sine of the angle between coordinates may fall during the motion.
constexpr double kStillDistinct = 0.3;

/// Sensitivity of a coordinate to a motion along its gradient, 1 at best. e_k is a cosine: near ±1 it is
/// insensitive to rotation and does not show on which side of ±1 the body is.
double sharpness_of(const IndependentCoordinate& c, const MeasureJet& jet) {
    const auto* of_body = std::get_if<CoordinateMeasure>(&c.measure);
    return of_body != nullptr && of_body->coordinate >= 3 ? 2.0 * jet.by_j.norm() : 1.0;
}

double share_of(double pivot, double best) { return best > 0.0 ? pivot / best : 0.0; }

}  // namespace

IndependentCoordinates::IndependentCoordinates(const Centroidal& centroidal, DrivableEquations& equations)
    : scene_(&centroidal), equations_(&equations), moving_(moving_bodies_of(centroidal.mechanism)) {
    const Mechanism& mechanism = centroidal.mechanism;
    int moving = 0;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        order_of_body_.push_back(mechanism.bodies[b].fixed ? -1 : moving++);
        if (mechanism.bodies[b].fixed) { continue; }
        for (int k = 0; k < 7; ++k) { of_bodies_.push_back({CoordinateMeasure{k}, 0, static_cast<int>(b)}); }
    }
    for (const Joint& joint : mechanism.joints) {
        if (joint.type->has_angle()) { of_joints_.push_back({angle_of(joint), joint.body_i, joint.body_j}); }
        if (joint.type->has_displacement()) {
            of_joints_.push_back({displacement_of(joint), joint.body_i, joint.body_j});
        }
    }
}

VectorX IndependentCoordinates::sizes(const StateScales& scales) const {
    const auto d = static_cast<Eigen::Index>(chosen_.size());
    const double length = extent(scene_->mechanism);
    VectorX out(2 * d);
    for (Eigen::Index k = 0; k < d; ++k) {
        out(k) = unit_of(chosen_[static_cast<std::size_t>(k)].measure, length);
    }
    out.tail(d) = out.head(d) * scales.omega();
    return out;
}

MeasureJet IndependentCoordinates::jet_at(const IndependentCoordinate& c, const double* y) const {
    const auto kinematics = [&](int body) {
        const Body& fixed = scene_->mechanism.bodies[at(body)];
        if (order_of(body) < 0) { return kinematics_at<OmegaLocal>(fixed.r, fixed.p); }
        const double* numbers = body_numbers(y, at(order_of(body)));
        return kinematics_at<OmegaLocal>(
            vec3(numbers), vec4(numbers + 3), vec3(numbers + 7), vec3(numbers + 10));
    };
    return jet_of(c.measure, kinematics(c.body_i), kinematics(c.body_j), Theta{});
}

MatrixX IndependentCoordinates::gradients(
    const std::vector<IndependentCoordinate>& of, const double* y) const {
    const auto bodies = std::ranges::count_if(order_of_body_, [](int order) { return order >= 0; });
    MatrixX rows = MatrixX::Zero(static_cast<Eigen::Index>(of.size()), 6 * bodies);
    for (std::size_t k = 0; k < of.size(); ++k) {
        const MeasureJet jet = jet_at(of[k], y);
        const auto add = [&](int body, const MeasureJet::Row& gradient) {
            if (order_of(body) < 0) { return; }
            rows.block<1, 6>(static_cast<Eigen::Index>(k), 6 * order_of(body)) += gradient;
        };
        add(of[k].body_i, jet.by_i);
        add(of[k].body_j, jet.by_j);
    }
    return rows;
}

double IndependentCoordinates::along(
    const IndependentCoordinate& c, const MeasureJet& jet, const double* y_dot) const {
    const auto of_body = [&](int body, const MeasureJet::Row& gradient) {
        if (order_of(body) < 0) { return 0.0; }
        const double* six = body_numbers(y_dot, at(order_of(body))) + 7;
        return gradient.dot(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(six));
    };
    return of_body(c.body_i, jet.by_i) + of_body(c.body_j, jet.by_j);
}

VectorX IndependentCoordinates::choose(double t, const double* y) {
    equations_->choose_rows(t, y);
    std::vector<double> y_dot(at(equations_->size()));
    equations_->evaluate(t, y, y_dot.data());
    pivot_of_rows_ = equations_->smallest_pivot();
    // displacements and rotations scaled by the extent; orthonormal, so that masses do not decide
    MatrixX free = equations_->free_motions(t, y);
    const double length = extent(scene_->mechanism);
    for (Eigen::Index k = 0; k < free.rows(); ++k) { free.row(k) *= k % 6 < 3 ? 1.0 : length; }
    const Eigen::Index d = free.cols();
    free = orthonormal_columns(free);
    const auto choose_from = [&](const std::vector<IndependentCoordinate>& candidates) {
        // projection of unit gradients; a coordinate at the end of its range is insensitive to any motion
        MatrixX rows = gradients(candidates, y);
        for (Eigen::Index k = 0; k < rows.cols(); ++k) { rows.col(k) /= k % 6 < 3 ? 1.0 : length; }
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            auto row = rows.row(static_cast<Eigen::Index>(k));
            const double size = row.norm();
            row *= size > 0.0 ? sharpness_of(candidates[k], jet_at(candidates[k], y)) / size : 0.0;
        }
        rows = (rows * free).eval();
        chosen_.clear();
        if (d == 0) { return 1.0; }
        if (rows.rows() < d) { return 0.0; }
        const Eigen::ColPivHouseholderQR<MatrixX> qr(rows.transpose());
        for (Eigen::Index k = 0; k < d; ++k) {
            chosen_.push_back(candidates[at(qr.colsPermutation().indices()(k))]);
        }
        // where no candidate takes part in the free motions, all pivots are rounding and similar in size;
        // hence the comparison with the coordinate of a body that takes part most
        const double most = std::max(std::abs(qr.matrixR()(0, 0)), free.rowwise().norm().maxCoeff());
        return std::abs(qr.matrixR()(d - 1, d - 1)) / most;
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
    VectorX x(2 * d);
    for (Eigen::Index k = 0; k < d; ++k) {
        const MeasureJet jet = jet_at(chosen_[at(k)], y);
        x(k) = jet.value;
        x(d + k) = jet.rate;
    }
    driven_ = block_equations(driven_scene_);
    driven_->forget_masses();
    drive(t, x);
    driven_->begin_turns(t, y);
    driven_->choose_rows(t, y);
    std::vector<double> here(y, y + equations_->size());
    driven_->project(t, here.data());
    driven_->keep_pivots();
    best_pivot_of_rows_ = std::max(best_pivot_of_rows_, pivot_of_rows_);
    if (d == 0 && !tracker_) { begin_tracking(t, y); }
    accept(t, y);
    return x;
}

void IndependentCoordinates::begin_tracking(double t, const double* y) {
    const Mechanism& mechanism = scene_->mechanism;
    State state = unpacked(mechanism, moving_, y).first;
    system_ = std::make_unique<System>(mechanism, everything(mechanism));
    tracker_ = std::make_unique<MotionTracker>(*system_, std::move(state), t);
}

/// Moves y to the pose and velocity with coordinates x.
void IndependentCoordinates::place(double t, const VectorX& x, double* y) {
    if (!tracker_) {
        drive(t, x);
        driven_->project(t, y);
        return;
    }
    const bool reached = tracker_->advance_to(t);
    pack(tracker_->frame().state, tracker_->frame().velocity, moving_, y);
    // after a failure, the way back cannot be proved: tracking starts again from the last accepted state
    if (!reached) { begin_tracking(accepted_t_, accepted_.data()); }
}

void IndependentCoordinates::follow_turns(double t, const double* y) {
    equations_->follow_turns(t, y);
    driven_->follow_turns(t, y);
    accept(t, y);
}

void IndependentCoordinates::accept(double t, const double* y) {
    if (!tracker_) { return; }
    accepted_t_ = t;
    accepted_.assign(y, y + equations_->size());
}

bool IndependentCoordinates::is_sound() const {
    if (tracker_) { return true; }
    constexpr double kept = kStillDistinct * kStillDistinct;
    return driven_->share_of_pivots() > kept && equations_->smallest_pivot() > kept * pivot_of_rows_ &&
           sharpness_ > kStillDistinct;
}

double IndependentCoordinates::pivot_left() const {
    return share_of(equations_->smallest_pivot(), best_pivot_of_rows_);
}

double IndependentCoordinates::pivot_with_coordinates_left() const {
    return tracker_ ? 1.0 : driven_->share_of_pivots();
}

/// Sets the drivers of the coordinates to x at t, continuing with their rates.
void IndependentCoordinates::drive(double t, const VectorX& x) {
    const auto d = static_cast<Eigen::Index>(chosen_.size());
    const int first = static_cast<int>(scene_->mechanism.drivers.size());
    for (Eigen::Index k = 0; k < d; ++k) {
        driven_->set_driver(first + static_cast<int>(k), x(k) - t * x(d + k), x(d + k));
    }
}

void IndependentCoordinates::evaluate(
    double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot) {
    const auto d = static_cast<Eigen::Index>(chosen_.size());
    place(t, x, y);
    verdict_ = equations_->evaluate(t, y, y_dot);
    x_dot.head(d) = x.tail(d);
    sharpness_ = 1.0;
    for (Eigen::Index k = 0; k < d; ++k) {
        const IndependentCoordinate& c = chosen_[static_cast<std::size_t>(k)];
        const MeasureJet jet = jet_at(c, y);
        x_dot(d + k) = jet.bias + along(c, jet, y_dot);
        sharpness_ = std::min(sharpness_, sharpness_of(c, jet));
    }
}

}  // namespace jw
