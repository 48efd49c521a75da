#include "core/kinematics/proof/proved_part.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jw {

namespace {

// All bounds are sums and products of numbers that are not negative: 10^4 operations round by 10^-12.
constexpr double kWidening = 1.0 + 1e-9;
// The next anchor is set ahead by this share of the time for which the last one lasted, because it also
// proves steps before it. At most this many steps ahead, as a path cannot be continued farther.
constexpr double kShareAhead = 0.8;
constexpr double kMostAhead = 10.0;
// Least ρ, in units of the coordinates.
constexpr double kLeastRadius = 1e-14;
// A step of no length must be proved with this multiple of its rounding: a real step needs some room as well,
// and with little room steps become far too short.
constexpr double kRoomForStep = 4.0;
constexpr int kMostTrials = 6;
// First ρ, as a multiple of the distance for K = 0: at least 2.5, or 1.25 times what the last step needed,
// but at most 10: if K is nearly 1, what was needed grows without bound.
constexpr double kFirstRadius = 2.5;
constexpr double kMoreThanBefore = 1.25;
constexpr double kLargestFirstRadius = 10.0;
constexpr double kEnlargement = 1.15;

}  // namespace

ProvedPart::ProvedPart(Part part, ProvedStep& step)
    : part_(std::move(part)), step_(&step), has_formula_(has_formula()) {
    std::vector<int> place(step.table().all().size(), -1);
    int column = 0;
    for (int k = 0; k < coordinates(); ++k) {
        const bool is_own = at(k) < part_.unknowns.size();
        int& next = is_own ? column : input_columns_;
        first_column_.push_back(next);
        next += step.table().all()[at(coordinate(at(k)))].size;
        place[at(coordinate(at(k)))] = k;
    }
    for (const int e : part_.equations) {
        std::array<int, kBlocks>& places = places_.emplace_back();
        for (std::size_t b = 0; b < kBlocks; ++b) {
            const int k = step.blocks(e)[b];
            places[b] = k < 0 ? -1 : place[at(k)];
        }
    }
    reach_.resize(at(coordinates()) + part_.equations.size());
    distance_.resize(reach_.size());
    residual_.resize(part_.equations.size());
    needed_.setConstant(static_cast<Eigen::Index>(part_.unknowns.size()), kFirstRadius);
}

double ProvedPart::ahead() const {
    const double h = std::abs(step_->h());
    return std::clamp(kShareAhead * lasted_ - h, 0.0, kMostAhead * h);
}

bool ProvedPart::prove_ahead(const StepEnd& ahead) {
    const std::vector<int> chosen = chosen_;
    const double size = size_of_inverse_;
    if (try_anchor_at(ahead) && prove_by_trial()) { return true; }
    size_of_inverse_ = size;
    if (chosen_ != chosen) { chosen_.clear(); }
    return false;
}

bool ProvedPart::prove() {
    if (!prove(anchor_)) { return false; }
    lasted_ = std::max(std::copysign(1.0, step_->h()) * (step_->to().t - anchor_.t), 0.0);
    return true;
}

/// Distances of the step's path from the anchor. @return false if it leaves the region
bool ProvedPart::measure_reach(const Anchor& anchor) {
    for (int k = 0; k < coordinates(); ++k) {
        const Coordinates& c = step_->table().all()[at(coordinate(at(k)))];
        const Path& path = step_->path(coordinate(at(k)));
        const double sign = c.size == 4 && path.control[0].dot(anchor.centre[at(k)]) < 0.0 ? -1.0 : 1.0;
        double square = 0.0;
        for (const Vec4& b : path.control) {
            square = std::max(square, (b - sign * anchor.centre[at(k)]).squaredNorm());
        }
        reach_[at(k)] = std::sqrt(square) / c.scale;
        distance_[at(k)] = reach_[at(k)] + step_->error(coordinate(at(k)));
    }
    for (std::size_t g = 0; g < part_.equations.size(); ++g) {
        const std::size_t e = at(part_.equations[g]);
        const bool is_target = step_->equations()[e].target != nullptr && step_->equations()[e].theta < 0;
        const auto from_anchor = [&](const StepEnd& end) {
            return std::abs(end.thetas[e].value - anchor.targets[g]);
        };
        // the path from one end to a time and on to the other end is not longer than rate times h
        distance_[at(coordinates()) + g] =
            is_target ? 0.5 * (from_anchor(step_->from()) + from_anchor(step_->to()) +
                               step_->target(static_cast<int>(e))[1] * std::abs(step_->h()))
                      : 0.0;
    }
    return is_within_reach(anchor);
}

bool ProvedPart::is_within_reach(const Anchor& anchor) const {
    for (int k = 0; k < coordinates(); ++k) {
        const Coordinates& c = step_->table().all()[at(coordinate(at(k)))];
        const double reach =
            c.theta >= 0 ? kReachOfTheta : anchor.reach * (c.size == 3 ? kReachOfLength : kReachOfP);
        const double distance = distance_[at(k)];
        // negated, so that NaN fails
        if (!(distance <= reach)) { return false; }
        const double radius = distance - reach_[at(k)];
        if (c.size == 4 && step_->path(coordinate(at(k))).size + radius > kSizeOfP) { return false; }
    }
    return std::all_of(
        distance_.begin() + coordinates(), distance_.end(), [](double x) { return x <= kReachOfTheta; });
}

/// Bounds |Φ(x̂(t), t)| over the step.
void ProvedPart::bound_residuals(Anchor& anchor) {
    const double h = std::abs(step_->h());
    for (std::size_t g = 0; g < part_.equations.size(); ++g) {
        const std::size_t e = at(part_.equations[g]);
        const ProvedEquation& equation = step_->equations()[e];
        const auto set_series = [&](BodyKinematics<Majorants>& body, int index) {
            const int k = step_->table().of_body(index);
            if (k < 0) { return; }
            body.r_series = step_->path(k).series;
            body.p_series = step_->path(k + 1).series;
        };
        set_series(anchor.i[g], equation.body_i);
        set_series(anchor.j[g], equation.body_j);
        BoundedTheta theta{anchor.targets[g], kReachOfTheta, {}};
        if (equation.target != nullptr) { theta.series = step_->target(static_cast<int>(e)); }
        if (equation.theta >= 0) {
            theta.series =
                detail::sum(theta.series, step_->path(step_->table().of_theta(equation.theta)).series);
        }
        TaylorSeries series{};
        visit_equation<Content::motion>(
            equation, anchor.i[g], anchor.j[g], theta, [&](const auto& jet) { series = jet.bounds; });
        residual_[g] =
            std::max(step_->from().phi[e], step_->to().phi[e]) + anchor.rounding[g] +
            4.0 / 27.0 * h *
                (step_->from().rate[e] + step_->to().rate[e] + kRoundingOfRow * series[1] / equation.unit) +
            h * h * h * h / 16.0 * series[4] / equation.unit;
    }
}

/// Adds the effect of the errors of the inputs on the unknowns if K is 0.
void ProvedPart::add_errors_of_inputs(const Anchor& anchor, VectorX& errors) const {
    for (Eigen::Index k = 0; k < anchor.passed_on.cols(); ++k) {
        errors += step_->error(part_.inputs[at(k)]) * anchor.passed_on.col(k);
    }
}

/// K and α for the distances of the part.
void ProvedPart::find_bounds(const Anchor& anchor) {
    const auto unknowns = static_cast<Eigen::Index>(part_.unknowns.size());
    K_ = anchor.defect;
    alpha_.setZero(unknowns);
    add_errors_of_inputs(anchor, alpha_);
    passed_residual_ = residual_;
    const auto n = static_cast<std::ptrdiff_t>(unknowns);
    for (const Curvature& c : anchor.curvatures) {
        const double change = c.bound * distance_[at(c.along)];
        if (c.of >= unknowns) {
            passed_residual_[at(c.equation)] += change * step_->error(coordinate(at(c.of)));
            continue;
        }
        const double* M = anchor.inverse.data() + n * c.equation;
        double* K = K_.data() + n * c.of;
        for (std::ptrdiff_t u = 0; u < n; ++u) { K[u] += change * M[u]; }
    }
    for (std::size_t g = 0; g < part_.equations.size(); ++g) {
        alpha_ += passed_residual_[g] * anchor.inverse.col(static_cast<Eigen::Index>(g));
    }
}

bool ProvedPart::prove(Anchor& anchor) {
    for (const int k : part_.unknowns) { step_->set_error(k, 0.0); }
    if (!anchor.is_set || !measure_reach(anchor)) { return false; }
    bound_residuals(anchor);
    if (step_->h() == 0.0) {
        for (double& residual : residual_) { residual *= kRoomForStep; }
    }
    const auto unknowns = static_cast<Eigen::Index>(part_.unknowns.size());
    first_.setConstant(unknowns, kLeastRadius);
    add_errors_of_inputs(anchor, first_);
    for (std::size_t g = 0; g < part_.equations.size(); ++g) {
        first_ += residual_[g] * anchor.inverse.col(static_cast<Eigen::Index>(g));
    }
    const bool was_larger = (needed_.array() > kFirstRadius).any();
    radius_ = needed_.cwiseMax(kFirstRadius).cwiseProduct(first_);
    if (contracts(anchor)) { return true; }
    needed_.setConstant(kFirstRadius);
    if (!was_larger) { return false; }
    // a smaller ρ may contract where a larger one does not: K grows with ρ
    radius_ = kFirstRadius * first_;
    return contracts(anchor);
}

/// True if a tube of radius `radius_` or wider is mapped into itself; then sets the error of the step.
bool ProvedPart::contracts(const Anchor& anchor) {
    const Eigen::Index unknowns = radius_.size();
    for (int n = 0; n < kMostTrials; ++n) {
        for (Eigen::Index u = 0; u < unknowns; ++u) { distance_[at(u)] = reach_[at(u)] + radius_(u); }
        if (!is_within_reach(anchor)) { return false; }
        find_bounds(anchor);
        image_.noalias() = K_ * radius_;
        // if a matrix maps a positive vector above itself, it does not map any vector below itself
        if ((image_.array() >= radius_.array()).all()) { return false; }
        image_ = kWidening * (image_ + alpha_);
        if ((image_.array() < radius_.array()).all()) {
            // the solution is in the tube, so it is in the image of the tube, and in the image of that image
            for (Eigen::Index u = 0; u < unknowns; ++u) {
                const double error = kWidening * (alpha_(u) + K_.row(u).dot(image_));
                step_->set_error(part_.unknowns[at(u)], error);
                needed_(u) = std::min(kMoreThanBefore * error / first_(u), kLargestFirstRadius);
            }
            return true;
        }
        radius_ = kEnlargement * image_;
    }
    return false;
}

}  // namespace jw
