#include <algorithm>
#include <cmath>

#include "core/kinematics/manifold.hpp"
#include "core/poses/branches.hpp"

/// Directions of a pull: Newton's method on the distance, within the free motions.
namespace jw {

namespace {

// [rad, or sizes of the machine]: an arc of 0.2 leaves its tangent by a tenth of the step
constexpr double kWholeStep = 0.2;
// a more distant target counts only by its direction; a nearer one keeps digits for the last steps
constexpr double kFar = 10.0;  // sizes of the machine
// conjugate directions: as many as there are freedoms, but not more than are useful in one step
constexpr int kMostDirections = 8;
constexpr double kDirectionRest = 1e-3;
// differences of gradients: truncation 1e-6, rounding 1e-16 / 1e-6
constexpr double kDifference = 1e-6;

}  // namespace

void Dragger::keep_free_part(VectorX& scaled) {
    scaled = scaled.cwiseProduct(scaling_.column);
    least_squares_.keep_free_part(rank_, scaled);
    scaled = scaled.cwiseQuotient(scaling_.column);
}

/// Negative gradient of ½ |goal - point|² + λᵀΦ at `state`, in scaled unknowns; the multipliers λ make it a
/// free motion at the present state.
void Dragger::slope_at(const State& state, VectorX& slope) {
    assembler_.assemble_phi_and_jacobian(state, t_);
    if (least_squares_.is_sparse()) {
        slope = -assembler_.sparse_jacobian().transposed_times(multipliers_);
    } else {
        slope.noalias() = -assembler_.jacobian().transpose() * multipliers_;
    }
    const auto b = static_cast<std::size_t>(body_);
    const int column = system_->body_column(body_, 3);
    const Mat3 A = rotation_matrix(state.p[b]);
    const Vec3 pull = goal_ - state.r[b] - A * point_local_;
    slope.segment<3>(column) += pull;
    slope.segment<3>(column + 3) += point_local_.cross(A.transpose() * pull);
    slope = slope.cwiseProduct(scaling_.column);
}

/// Second derivative of ½ |goal - point|² + λᵀΦ along a free motion, by a difference of gradients.
void Dragger::curvature_along(const VectorX& direction, VectorX& curvature) {
    const double h = kDifference / direction.norm();
    step_ = h * direction.cwiseProduct(scaling_.column);
    trial_ = state_;
    assembler_.layout().advance(trial_, step_);
    slope_at(trial_, slope_there_);
    curvature = (slope_ - slope_there_) / h;
    keep_free_part(curvature);
}

/// Newton direction by conjugate gradients within the free motions; the gradient itself where the curvature
/// of the distance is negative.
void Dragger::find_direction() {
    direction_.setZero();
    rest_ = conjugate_ = slope_;
    const int most = std::min(static_cast<int>(slope_.size()) - rank_, kMostDirections);
    for (int k = 0; k < most; ++k) {
        const double rest_square = rest_.squaredNorm();
        curvature_along(conjugate_, curvature_);
        const double bend = conjugate_.dot(curvature_);
        if (bend <= kDifference * conjugate_.squaredNorm() * size_ * size_) {
            if (k == 0) { direction_ = slope_ * (kFar / slope_.norm()); }
            return;
        }
        direction_ += rest_square / bend * conjugate_;
        rest_ -= rest_square / bend * curvature_;
        if (rest_.norm() <= kDirectionRest * slope_.norm()) { return; }
        conjugate_ = rest_ + rest_.squaredNorm() / rest_square * conjugate_;
    }
}

/// Shortens the direction to at most a whole step. @return its length as a share of a whole step
double Dragger::shorten_direction() {
    // displacements are in sizes of the machine
    const double share = largest_part(*system_, direction_, 1.0) / kWholeStep;
    if (share > 1.0) { direction_ /= share; }
    return std::min(share, 1.0);
}

/// Finds the direction of a step. @param rank  of the equations that count
/// @return its promise; an empty one if the pull has no free part
Dragger::Promise Dragger::find_way(int rank) {
    rank_ = rank;
    const Vec3 e = target_ - point(state_);
    const Vec3 way = e * (kFar * size_ / std::max(e.norm(), kFar * size_));
    goal_ = point(state_) + way;

    // the pull, and the part of it that the constraints leave free
    multipliers_.setZero();
    slope_at(state_, slope_);
    step_ = slope_.cwiseQuotient(scaling_.column);
    least_squares_.solve_transposed(step_, rank_, multipliers_);
    slope_at(state_, slope_);
    keep_free_part(slope_);
    if (slope_.norm() == 0.0) { return {}; }
    find_direction();
    const double share = shorten_direction();
    return {0.5 * way.squaredNorm(), 0.5 * slope_.dot(direction_), share};
}

}  // namespace jw
