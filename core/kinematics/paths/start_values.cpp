#include "core/kinematics/paths/start_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/equations/assembler.hpp"
#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/large_rank.hpp"

namespace jw {

namespace {

// four typed digits: values that differ less agree
constexpr double kTypedValue = 1e-4;
// rounding of an assembled pose
constexpr double kSameValue = 1e-9;
// the ways round of more angles than these are too many to try them all
constexpr int kMostAngles = 3;

/// Drives joints of a mechanism whose own drivers stand still.
class ValueDrivers {
public:
    ValueDrivers(
        const Mechanism& mechanism, const Selection& present, std::span<const GivenValue> values, double t,
        const State& start)
        : still_(mechanism), selection_(present), values_(values), start_(start), length_(extent(mechanism)) {
        for (Body& body : still_.bodies) { body.r_dot = body.omega_local = Vec3::Zero(); }
        for (Joint& joint : still_.joints) { joint.geometry.theta_dot_start.reset(); }
        for (Driver& driver : still_.drivers) {
            driver.function = TimeFunction{.polynomial = {driver.function.at(t).f}};
        }
        RankReport now = rank();
        for (std::size_t k = 0; k < values.size() && now.dof > 0; ++k) {
            const Joint& joint = still_.joints[at(values[k].joint)];
            selection_.drivers.push_back(static_cast<int>(still_.drivers.size()));
            still_.drivers.push_back(
                {"", values[k].joint, joint.body_i, joint.body_j, values[k].measure,
                 TimeFunction{.polynomial = {value_at(k, start)}}});
            RankReport with = rank();
            if (with.dof < now.dof) {
                driven_.push_back(k);
                now = std::move(with);
            } else {
                still_.drivers.pop_back();
                selection_.drivers.pop_back();
            }
        }
        is_determined_ = now.dof == 0;
    }

    bool is_determined() const { return is_determined_; }

    double value_at(std::size_t k, const State& state) const {
        const GivenValue& given = values_[k];
        const Joint& joint = still_.joints[at(given.joint)];
        const Motion none = zero_motion(still_);
        return evaluate_measure(
                   given.measure, joint.body_i, joint.body_j, still_.theta_indices()[at(given.joint)], state,
                   none, none)
            .value;
    }
    /// What is missing to a given value, of an angle by the shorter way.
    double left(std::size_t k, const State& state) const {
        const std::optional<double>& value = values_[k].value;
        return value ? -driver_residual(values_[k].measure, value_at(k, state), *value) : 0.0;
    }
    bool is_met(std::size_t k, const State& state, double tolerance) const {
        return std::abs(left(k, state)) <= tolerance * unit_of(values_[k].measure, length_);
    }
    bool are_met(const State& state) const {
        for (std::size_t k = 0; k < values_.size(); ++k) {
            if (!is_met(k, state, kSameValue)) { return false; }
        }
        return true;
    }

    /// Moves `state` from the start to the values that are driven. @return why the shorter ways end early
    std::optional<MissedValue> drive(State& state) {
        if (std::ranges::none_of(driven_, [&](std::size_t k) { return values_[k].value.has_value(); })) {
            return std::nullopt;
        }
        const auto angles = std::ranges::count_if(driven_, [&](std::size_t k) { return has_two_ways(k); });
        const int ways = angles <= kMostAngles ? 1 << angles : 1;
        std::optional<MissedValue> missed;
        for (int way = 0; way < ways; ++way) {
            set_ramps(way);
            System system(still_, selection_);
            MotionTracker tracker(system, start_, 0.0);
            const bool arrives = tracker.advance_to(1.0);
            if (arrives && tracker.crossings().empty()) {
                state = tracker.frame().state;
                return std::nullopt;
            }
            if (missed) { continue; }
            missed = arrives ? missed_at_crossing(tracker.crossings().front())
                             : missed_at(tracker.frame().state, tracker.failure());
        }
        return missed;
    }

private:
    bool has_two_ways(std::size_t k) const {
        return std::holds_alternative<AngleMeasure>(values_[k].measure) && !is_met(k, start_, kSameValue);
    }

    /// Lets the drivers lead from the start to the given values from t = 0 to 1. @param way  bit n: the n-th
    /// angle goes the longer way round
    void set_ramps(int way) {
        Driver* driver = &still_.drivers[still_.drivers.size() - driven_.size()];
        for (const std::size_t k : driven_) {
            double change = left(k, start_);
            if (has_two_ways(k)) {
                if (way % 2 != 0) { change -= std::copysign(2.0 * std::numbers::pi, change); }
                way /= 2;
            }
            (driver++)->function.polynomial = {value_at(k, start_), change};
        }
    }

    RankReport rank() const {
        System system(still_, selection_);
        system.choose_rows(start_);
        Assembler<OmegaLocal> assembler(system);
        assembler.assemble_phi_and_jacobian(start_, 0.0);
        return analyse_rank_verdict(system, assembler.sparse_jacobian(), assembler.phi());
    }

    /// The first driven value at the time of the ramps at which branches meet.
    MissedValue missed_at_crossing(double t) const {
        PositionFailure failure;
        failure.cause = FailureCause::undecided;
        const Driver& first = still_.drivers[still_.drivers.size() - driven_.size()];
        return {driven_.front(), first.function.at(t).f, false, failure};
    }

    /// The driven value of which most is missing.
    MissedValue missed_at(const State& state, const std::optional<PositionFailure>& failure) const {
        MissedValue missed{driven_.front(), 0.0, false, failure};
        double most = 0.0;
        for (const std::size_t k : driven_) {
            const double off = std::abs(left(k, state)) / unit_of(values_[k].measure, length_);
            if (!(off > most)) { continue; }
            most = off;
            missed.given = k;
        }
        missed.found = value_at(missed.given, state);
        return missed;
    }

    Mechanism still_;
    Selection selection_;
    std::span<const GivenValue> values_;
    const State& start_;
    double length_;
    std::vector<std::size_t> driven_;  ///< values with a driver; these are the last drivers
    bool is_determined_ = false;
};

}  // namespace

std::optional<MissedValue> move_to_values(
    const Mechanism& mechanism, const Selection& present, std::span<const GivenValue> values, double t,
    State& state) {
    const State start = state;
    ValueDrivers drivers(mechanism, present, values, t, start);
    if (drivers.are_met(start)) { return std::nullopt; }
    State reached = start;
    if (auto missed = drivers.drive(reached)) { return missed; }
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (drivers.is_met(k, reached, kTypedValue)) { continue; }
        return MissedValue{k, drivers.value_at(k, reached), drivers.is_determined(), std::nullopt};
    }
    state = std::move(reached);
    return std::nullopt;
}

}  // namespace jw
