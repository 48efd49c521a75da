#include "app/session/claims/formula_claims.hpp"

#include <algorithm>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

constexpr unsigned kStates = 20;
constexpr double kPlainlyOther = 1e-6;

/// The outcome that is farthest from equality; `part` is its difference relative to the largest term.
struct Worst {
    formula::Outcome outcome;
    double part = 0.0;
};

Worst worst_of(const formula::Formula& formula, const std::vector<Instant>& instants) {
    Worst worst;
    for (const Instant& instant : instants) {
        formula::Outcome outcome = formula::evaluate_at(formula, instant);
        const double scale = std::max(outcome.apart.scale, 1e-300);
        const double part = outcome.apart.difference / scale;
        // NaN counts as farthest apart
        if (!outcome.problem && part <= worst.part && !worst.outcome.left.empty()) { continue; }
        worst = {std::move(outcome), part};
        if (worst.outcome.problem || !(part >= 0.0)) { break; }
    }
    return worst;
}

}  // namespace

std::vector<Instant> arbitrary_instants(const Instant& instant) {
    std::vector<Instant> instants;
    for (unsigned seed = 0; seed < kStates; ++seed) {
        instants.push_back(formula::arbitrary_instant(instant.system, seed));
        instants.back().scene = instant.scene;
    }
    return instants;
}

void judge_formula(const FormulaClaim& claim, const std::vector<Instant>& instants, ClaimResult& result) {
    result.subject = math::write_plain(math::read_math(claim.formula.source).row);
    result.expected = claim.holds ? tr("holds") : tr("does not hold");
    const Worst worst = worst_of(claim.formula, instants);
    if (worst.outcome.misfit && !claim.holds) {
        result.holds = true;
        return;
    }
    if (worst.outcome.problem) {
        result.found = tr("nothing: {0}", worst.outcome.problem->message);
        return;
    }
    result.holds = claim.holds ? worst.part <= formula::kKnown : worst.part > kPlainlyOther;
    if (result.holds) { return; }
    result.found =
        tr("{0} and {1}, {2} apart", worst.outcome.left, worst.outcome.right,
           small_text(worst.outcome.apart.difference));
}

}  // namespace jw
