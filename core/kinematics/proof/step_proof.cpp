#include "core/kinematics/proof/step_proof.hpp"

#include <algorithm>
#include <cmath>

#include "core/kinematics/proof/proved_part.hpp"

namespace jw {

namespace {

// The chord of a step may differ from the mean of the tangents at its ends by this share, and by rounding.
constexpr double kMostOffChord = 0.3;
constexpr double kRest = 1e-9;

}  // namespace

class StepProof::Parts {
public:
    Parts(const System& system, LeftFree free) : step(system), left_free(free) {}

    void divide();
    bool runs_smoothly() const;

    ProvedStep step;
    LeftFree left_free;
    bool are_divided = false;
    bool is_underdriven = false;
    std::vector<ProvedPart> all;
    std::vector<int> not_proved;  ///< coordinates of parts that are too large
    double margin = 0.0;
};

/// Divides the mechanism into parts at the start of the step.
void StepProof::Parts::divide() {
    std::vector<EquationJacobian> jacobians;
    for (std::size_t e = 0; e < step.equations().size(); ++e) {
        jacobians.push_back(step.jacobian_at(step.from(), static_cast<int>(e)));
    }
    all.clear();
    not_proved.clear();
    is_underdriven = false;
    for (Part& part : find_parts(step.table(), step.equations(), jacobians)) {
        if (part.is_underdriven && left_free == LeftFree::undetermined) {
            is_underdriven = true;
            continue;
        }
        if (part.columns > kMostProvedColumns) {
            not_proved.insert(not_proved.end(), part.unknowns.begin(), part.unknowns.end());
        } else {
            all.emplace_back(std::move(part), step);
        }
    }
    // at a singular pose, equations can be dependent that are independent elsewhere
    are_divided = !is_underdriven;
}

/// True if the velocities at both ends follow the step in parts where nothing is proved. For a free motion,
/// which has no drivers, this does not suffice: all parts must be proved.
bool StepProof::Parts::runs_smoothly() const {
    if (left_free == LeftFree::kept) { return not_proved.empty(); }
    double chord = 0.0;
    double off = 0.0;
    for (const int k : not_proved) {
        const auto& b = step.path(k).control;
        const double scale = step.table().all()[at(k)].scale;
        const Vec4 way = b[3] - b[0];
        chord = std::max(chord, way.norm() / scale);
        off = std::max(off, (way - 1.5 * (b[1] - b[0] + b[3] - b[2])).norm() / scale);
    }
    return off <= kMostOffChord * chord + kRest;
}

StepProof::StepProof(const System& system, LeftFree left_free)
    : parts_(std::make_unique<Parts>(system, left_free)) {}
StepProof::~StepProof() = default;

bool StepProof::holds(const PathEnd& from, const PathEnd& to) {
    parts_->step.set(from, to);
    if (!parts_->are_divided) { parts_->divide(); }
    if (!parts_->runs_smoothly()) { return false; }
    for (ProvedPart& part : parts_->all) {
        if (part.prove()) { continue; }
        const double ahead = part.ahead();
        if (ahead > 0.0 && part.prove_ahead(parts_->step.ahead(ahead))) {
            part.keep_trial();
            continue;
        }
        if (!part.try_anchor_at(parts_->step.to())) {
            // more equations are independent than at the start
            parts_->are_divided = false;
            return false;
        }
        if (!part.prove_by_trial()) { return false; }
        part.keep_trial();
    }
    return true;
}

/// Proves a step of no length with an anchor at the pose: its only error is rounding.
bool StepProof::decides_at(const PathEnd& pose) {
    parts_->step.set(pose, pose);
    if (!parts_->are_divided) { parts_->divide(); }
    bool decided = true;
    parts_->margin = HUGE_VAL;
    for (ProvedPart& part : parts_->all) {
        const bool is_regular = part.try_anchor_at(parts_->step.from());
        parts_->margin = is_regular ? std::min(parts_->margin, part.margin()) : 0.0;
        decided = decided && is_regular && part.prove_by_trial();
    }
    return decided;
}

bool StepProof::covers_all() const { return parts_->are_divided && parts_->not_proved.empty(); }

double StepProof::margin() const { return parts_->margin; }

double StepProof::margin_nearby() const {
    double margin = HUGE_VAL;
    for (const ProvedPart& part : parts_->all) { margin = std::min(margin, part.margin_of_anchor()); }
    return margin;
}

bool StepProof::leaves_bodies_free(const PathEnd& pose) {
    if (!parts_->are_divided) {
        parts_->step.set(pose, pose);
        parts_->divide();
    }
    return parts_->is_underdriven;
}

}  // namespace jw
