#include "app/session/view/free_motions.hpp"

#include <algorithm>
#include <cstddef>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

// largest number of free motions times columns that is judged: this takes about 50 ms
constexpr std::ptrdiff_t kMostJudged = 1000;

/// Moving bodies that no equation constrains.
std::vector<int> loose_bodies(const System& system) {
    const Mechanism& mechanism = system.mechanism();
    std::vector<bool> held(mechanism.bodies.size(), false);
    const auto hold = [&](int body) { held[at(body)] = true; };
    for (const Constraint& c : system.constraints()) {
        hold(c.body_i);
        hold(c.body_j);
    }
    for (const DriverConstraint& d : system.drivers()) {
        hold(mechanism.drivers[at(d.driver)].body_i);
        hold(mechanism.drivers[at(d.driver)].body_j);
    }
    std::vector<int> loose;
    for (const int body : system.moving_bodies()) {
        if (!held[at(body)]) { loose.push_back(body); }
    }
    return loose;
}

bool moves_any(const System& system, const FreeMotion& motion, const std::vector<int>& bodies) {
    return std::ranges::any_of(
        bodies, [&](int body) { return !motion.segment<6>(system.body_column(body, 3)).isZero(); });
}

std::string told_motion(const System& system, const std::string& text, const FreedomJudgement& judgement) {
    const std::string told = std::string(verdict_text(judgement.verdict)) + " · " + text;
    const std::string leaves = leaving_text(system, judgement);
    return leaves.empty() ? told : told + "; " + leaves;
}

}  // namespace

FreedomJudgements judgements_on(
    const System& system, const State& state, double t, const std::vector<FreeMotion>& motions) {
    const std::vector<int> loose = loose_bodies(system);
    const auto is_held = [&](const FreeMotion& motion) { return !moves_any(system, motion, loose); };
    if (std::ranges::count_if(motions, is_held) * system.columns(OmegaLocal::kAngular) > kMostJudged) {
        return {};
    }
    FreedomJudgements judgements;
    for (const FreeMotion& motion : motions) {
        judgements.emplace_back();
        if (is_held(motion)) { judgements.back() = judge_free_motion(system, state, t, motion); }
    }
    return judgements;
}

std::vector<ListedMotion> listed_motions(
    const System& system, const std::vector<FreeMotion>& motions, const FreedomJudgements& judgements) {
    const std::vector<int> loose = loose_bodies(system);
    std::vector<ListedMotion> listed;
    for (std::size_t k = 0; k < motions.size(); ++k) {
        if (moves_any(system, motions[k], loose)) { continue; }
        ListedMotion& motion = listed.emplace_back();
        motion.index = static_cast<int>(k);
        motion.text = motion.told = free_motion_text(system, motions[k]);
        if (judgements.empty()) { continue; }
        motion.judgement = judgements[k];
        motion.told = told_motion(system, motion.text, *motion.judgement);
    }
    if (loose.empty()) { return listed; }
    const std::string names =
        joined(loose, ", ", [&](int body) { return system.mechanism().bodies[at(body)].name; });
    const std::string text = tr("{0}: all six, not constrained yet", names);
    listed.push_back({text, text, std::nullopt, -1});
    return listed;
}

}  // namespace jw
