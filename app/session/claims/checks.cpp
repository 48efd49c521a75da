#include "app/session/claims/checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/session/claims/claim_poses.hpp"
#include "app/session/story/sentences.hpp"
#include "app/session/story/story.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/quantity_text.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "core/equations/assembler.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/text_parts.hpp"
#include "lessons/math/write_math.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace {

// all digits of a typed time: with fewer, different times look the same
constexpr int kTypedDigits = 15;

std::string text_of(const Moment& moment, const Lesson& lesson) {
    return std::visit(
        Overloaded{
            [](const AsGiven&) -> std::string { return tr("as given"); },
            [](const AnyState&) -> std::string { return tr("in any state"); },
            [](const AtRest&) -> std::string { return tr("at rest"); },
            [](const AtTime& at) { return tr("at {0} s", number_text(at.t, kTypedDigits)); },
            [&](const AfterAddition& after) -> std::string {
                if (after.count == 0) { return tr("free bodies"); }
                return tr("after {0}", name_of(lesson.order[at(after.count - 1)], lesson.mechanism));
            },
        },
        moment);
}

const char* name_of(Count count) {
    switch (count) {
        case Count::rank: return tr("rank");
        case Count::rows: return tr("rows");
        case Count::columns: return tr("columns");
        case Count::dof: return tr("dof");
        case Count::redundant: return tr("redundant");
        case Count::mobility_by_counting: break;
    }
    return tr("mobility by counting");
}

double number_of(const QuantityClaim& claim, const Instant& instant, Absence& why) {
    const QuantityValue v = evaluate(claim.quantity, instant, claim.derivative);
    why = v.absences[at(claim.derivative)];
    return v.derivatives[at(claim.derivative)];
}

/// Difference of two values. A pose determines an angle up to whole turns; a motion determines these, too.
double difference_of(const QuantityClaim& claim, const Instant& instant, double a, double b) {
    const bool has_turns_open =
        claim.derivative == 0 && is_modulo_turn(claim.quantity) && instant.turns.empty();
    return has_turns_open ? std::remainder(a - b, 2.0 * std::numbers::pi) : a - b;
}

std::string not_proved(const std::string& found, const std::string& apart) {
    return tr(
        "{0}; two runs of different tolerance are {1} apart there, so this cannot be proved", found, apart);
}

void judge(const QuantityClaim& claim, const Pose& pose, ClaimResult& result) {
    const double factor = claim.in_degrees ? kDegreesPerRadian : 1.0;
    const std::string symbol = unit_text(dimension_of(claim.quantity), claim.derivative, claim.in_degrees);
    const std::string unit = symbol.empty() ? "" : " " + symbol;
    const int derivative = claim.derivative - claim.named_derivative;
    result.subject = derivative == 0   ? claim.text
                     : derivative == 1 ? tr("{0} rate", claim.text)
                                       : tr("{0} acceleration", claim.text);
    Absence why = Absence::none;
    const double found = number_of(claim, pose.instant, why);
    const double difference = difference_of(claim, pose.instant, found, claim.value);
    result.holds = std::abs(difference) <= claim.tolerance;
    constexpr int claimed = 12;
    constexpr int computed = 15;
    const int digits =
        result.holds ? claimed : writing::digits_apart(factor * claim.value, factor * found, claimed);
    result.expected =
        number_text(factor * claim.value, digits) + unit + " ± " + number_text(factor * claim.tolerance, 3);
    if (std::isnan(found)) {
        result.found = tr("nothing: {0}", absence_text(why));
        return;
    }
    result.found =
        tr("{0}, off by {1}", number_text(factor * found, std::max(digits, computed)) + unit,
           small_text(factor * difference));
    if (!pose.rough) { return; }
    const double rough = number_of(claim, *pose.rough, why);
    const double apart = std::abs(difference_of(claim, pose.instant, found, rough));
    if (apart <= claim.tolerance) { return; }
    result.found = not_proved(result.found, small_text(factor * apart) + unit);
    result.holds = false;
}

void judge(const CountClaim& claim, const Pose& pose, ClaimResult& result) {
    const RankReport report = rank_of(*pose.instant.system, pose.instant.state, pose.instant.t);
    const int found = count_of(report, claim.count);
    const bool of_rank =
        claim.count == Count::rank || claim.count == Count::dof || claim.count == Count::redundant;
    result.subject = name_of(claim.count);
    result.expected = std::to_string(claim.value);
    result.found = std::to_string(found);
    result.holds = found == claim.value;
    if (of_rank && !report.decided) {
        result.found = tr("{0}; {1}", result.found, undecided_text(report));
        result.holds = false;
    }
}

void judge(const DroppedClaim& claim, const Pose& pose, ClaimResult& result) {
    const Joint& joint = pose.instant.system->mechanism().joints[at(claim.joint)];
    result.subject = tr("left out of {0} {1}", joint.name, name_of_role(claim.role, joint.parallel_form));
    result.expected = axis_name(claim.component);
    result.found = tr("nothing");
    for (const Constraint& c : pose.instant.system->constraints()) {
        if (c.joint != claim.joint || c.role != claim.role || c.dropped < 0) { continue; }
        result.found = axis_name(c.dropped);
        result.holds = c.dropped == claim.component;
    }
}

/// Largest |Φ| in the scene's units, as in RankReport.
double residual_of(const Pose& pose) {
    Assembler<OmegaLocal> assembler(*pose.instant.system);
    assembler.assemble_phi_and_jacobian(pose.instant.state, pose.instant.t);
    double largest = 0.0;
    for (int row = 0; row < pose.instant.system->rows(); ++row) {
        const double size = std::abs(assembler.phi()(row) / pose.instant.system->row_unit(row));
        largest = std::isnan(size) ? HUGE_VAL : std::max(largest, size);
    }
    return largest;
}

/// σ_1 / σ_r, from singular values even for large systems, since an estimate proves nothing.
double condition_of(const Pose& pose) {
    const RankReport report = rank_of(*pose.instant.system, pose.instant.state, pose.instant.t, true);
    return report.rank > 0 ? report.first_value() / report.last_value() : 1.0;
}

void judge(const BoundClaim& claim, const Pose& pose, ClaimResult& result) {
    const bool residual = claim.bound == Bound::residual_below;
    const double found = residual ? residual_of(pose) : condition_of(pose);
    result.subject = residual ? tr("residual") : tr("condition");
    const bool above = claim.bound == Bound::condition_above;
    result.holds = above ? found > claim.limit : found < claim.limit;
    const auto text = [&](double value) {
        // not by number_text, which treats a small value as rounding
        const bool exactly = !result.holds && std::isfinite(value);
        return exactly ? short_number(value, writing::digits_apart(claim.limit, found, 6))
                       : number_text(value, 6);
    };
    const std::string limit = text(claim.limit);
    result.expected = above ? tr("above {0}", limit) : tr("below {0}", limit);
    result.found = text(found);
}

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

/// Random states of the mechanism of `instant`, with its masses; the same in every run.
std::vector<Instant> arbitrary_instants(const Instant& instant) {
    std::vector<Instant> instants;
    for (unsigned seed = 0; seed < kStates; ++seed) {
        instants.push_back(formula::arbitrary_instant(instant.system, seed));
        instants.back().scene = instant.scene;
    }
    return instants;
}

/// Judges a formula. It holds if its sides agree, up to rounding, at every instant; a formula that is claimed
/// not to hold must fail clearly at one instant.
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

void judge(const FormulaClaim& claim, const Pose& pose, ClaimResult& result) {
    judge_formula(claim, {pose.instant}, result);
}

void judge_stability(bool claimed, const Pose& pose, ClaimResult& result) {
    result.subject = tr("stable");
    result.expected = claimed ? tr("yes") : tr("no");
    const Stability stability = pose.stability.value_or(Stability::cannot_tell);
    result.found = stability == Stability::stable     ? tr("yes")
                   : stability == Stability::unstable ? tr("no")
                                                      : tr("not known");
    result.holds = stability == (claimed ? Stability::stable : Stability::unstable);
}

void judge(const VerdictClaim& claim, const Pose& pose, ClaimResult& result) {
    if (claim.verdict == Verdict::stable) {
        judge_stability(claim.value, pose, result);
        return;
    }
    System system = *pose.instant.system;
    const auto begun = [&] { return MotionTracker(system, pose.instant.state, pose.instant.t).frame(); };
    const bool found = pose.change_point ? *pose.change_point : begun().change_point;
    result.subject = tr("change point");
    result.expected = claim.value ? tr("yes") : tr("no");
    result.found = found ? tr("yes") : tr("no");
    result.holds = found == claim.value;
}

ClaimResult judged(const Claim& claim, const Pose& pose) {
    ClaimResult result;
    result.failure = pose.failure;
    const auto* verdict = std::get_if<VerdictClaim>(&claim.fact);
    if (verdict != nullptr && verdict->verdict == Verdict::closes) {
        result.subject = tr("closes");
        result.expected = verdict->value ? tr("yes") : tr("no");
        result.found = pose.failure.empty() ? tr("yes") : tr("no: {0}", pose.failure);
        result.holds = verdict->value == pose.failure.empty();
    } else if (!pose.failure.empty()) {
        result.subject = tr("this claim");
        result.expected =
            std::holds_alternative<AtRest>(claim.when) ? tr("an equilibrium") : tr("a pose that closes");
        result.found = pose.failure;
    } else if (std::holds_alternative<AnyState>(claim.when)) {
        judge_formula(std::get<FormulaClaim>(claim.fact), arbitrary_instants(pose.instant), result);
    } else {
        std::visit([&](const auto& fact) { judge(fact, pose, result); }, claim.fact);
    }
    result.span = claim.span;
    result.why = math::plain_words(shown_text(claim.why));
    return result;
}

/// Judges the claim `point_at_end`, whose value comes from a trusted computation. Two runs with different
/// tolerances show how far the program's own computation can be trusted.
ClaimResult judged_end(const Lesson& lesson, const Pose& pose) {
    constexpr double far =
        1e-6;  // of the scene: above the uncertainty of both, below a wrong digit that matters
    const DynamicsPlan& plan = *lesson.dynamics;
    const double allowed = far * extent(lesson.mechanism);
    ClaimResult result;
    result.span = plan.point_at_end_span;
    result.moment = tr("at {0} s", number_text(plan.duration, 6));
    result.subject = "point_at_end";
    const auto expected = [&](int digits) {
        return vector_text(*plan.point_at_end, digits) + " m ± " + number_text(allowed, 3);
    };
    constexpr int enough = 10;
    result.expected = expected(enough);
    result.failure = pose.failure;
    if (!pose.failure.empty()) {
        result.found = pose.failure;
        return result;
    }
    const auto place_at = [&](const Instant& instant) {
        Vec3 place;
        for (int k = 0; k < 3; ++k) {
            place(k) =
                evaluate(PointQuantity{plan.point->body, plan.point->point_local, k}, instant, 0).value();
        }
        return place;
    };
    const Vec3 end = place_at(pose.instant);
    const double uncertain = (end - place_at(*pose.rough)).norm();
    const double off = (end - *plan.point_at_end).norm();
    Eigen::Index worst = 0;
    (end - *plan.point_at_end).cwiseAbs().maxCoeff(&worst);
    const int digits =
        off <= allowed ? enough : writing::digits_apart(end(worst), (*plan.point_at_end)(worst), enough);
    result.expected = expected(digits);
    result.found = tr("{0}, off by {1}", vector_text(end, digits) + " m", small_text(off));
    if (uncertain > allowed) {
        result.found = not_proved(result.found, small_text(uncertain) + " m");
        return result;
    }
    result.holds = off <= allowed;
    return result;
}

/// Moment of the changed lesson that corresponds to `when`; nothing if its joint or driver is gone.
std::optional<Moment> carried(const Moment& when, const Lesson& written, const Lesson& changed) {
    using Carried = std::optional<Moment>;
    return std::visit(
        Overloaded{
            [](const AsGiven& given) -> Carried { return given; },
            [](const AnyState& any) -> Carried { return any; },
            [](const AtRest& rest) -> Carried { return rest; },
            [&](const AfterAddition& after) -> Carried {
                if (after.count == 0) { return after; }
                const Addition& addition = written.order[at(after.count - 1)];
                const auto found = std::ranges::find(changed.order, addition);
                if (found == changed.order.end()) { return std::nullopt; }
                return AfterAddition{static_cast<int>(found - changed.order.begin()) + 1};
            },
            [](const AtTime& at) -> Carried { return at; },
        },
        when);
}

}  // namespace

std::vector<ClaimResult> check_claims(const Lesson& lesson) {
    const ClaimPoses poses(lesson);
    std::vector<ClaimResult> results;
    for (const Claim& claim : lesson.claims) {
        results.push_back(judged(claim, poses.at(claim.when)));
        results.back().moment = text_of(claim.when, lesson);
    }
    if (lesson.dynamics && lesson.dynamics->point && lesson.dynamics->point_at_end) {
        results.push_back(judged_end(lesson, poses.at(AtTime{lesson.dynamics->duration, true})));
    }
    return results;
}

std::vector<Claim> carried_claims(const Lesson& written, const Lesson& changed) {
    std::vector<Claim> claims;
    for (const Claim& claim : written.claims) {
        const Addition subject = subject_of(claim.fact);
        if (subject.index >= 0 && std::ranges::find(changed.order, subject) == changed.order.end()) {
            continue;
        }
        if (const std::optional<Moment> when = carried(claim.when, written, changed)) {
            claims.push_back(claim);
            claims.back().when = *when;
        }
    }
    return claims;
}

}  // namespace jw
