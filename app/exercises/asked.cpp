#include "app/exercises/asked.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/exercises/answers/spelling.hpp"
#include "app/exercises/formulas/mistakes.hpp"
#include "app/session/claims/checks.hpp"
#include "app/session/claims/claim_poses.hpp"
#include "app/session/story/story.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/quantity_text.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

using formula::Value;
using math::Row;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The formula of an exercise and what its symbols mean in a variant.
class AskedFormula {
public:
    AskedFormula(const FormulaPlan& plan, const FormulaClaim& claim, const Instant& instant)
        : plan_(plan), meanings_(formula::meanings_of(claim.formula.subject, instant)) {}

    /// Values of the first side, which is asked for, and of the last side, from which it is found.
    MatrixX asked() const { return value(plan_.asked, plan_.where); }
    MatrixX found() const { return value(plan_.found, plan_.where); }
    /// Value of an expression; empty if it has none.
    MatrixX value_or_empty(const Row& expression) const { return value_or_empty(expression, plan_.where); }

    /// Answers of all mistakes in the last side, and in the definitions.
    std::vector<KnownMistake> mistakes() const {
        std::vector<KnownMistake> all;
        for (const PlannedMistake& planned : plan_.mistakes) {
            const FormulaMistake& mistake = *planned.mistake;
            all.push_back(
                {mistake.name,
                 {{mistake.title, {}}},
                 planned.says,
                 mistake.slide,
                 value_or_empty(planned.expression, planned.where),
                 planned.shown});
        }
        return all;
    }

private:
    MatrixX value(const Row& expression, const std::vector<Row>& where) const {
        const Value found = formula::evaluate_expression(expression, where, meanings_);
        if (found.kind != Value::Kind::matrix) {
            throw formula::Mismatch("its shape is not known: " + formula::shape_text(found));
        }
        return found.d[0];
    }
    MatrixX value_or_empty(const Row& expression, const std::vector<Row>& where) const {
        try {
            return value(expression, where);
        } catch (const formula::NotEvaluated&) { return {}; } catch (const formula::Mismatch&) {
            return {};
        }
    }

    const FormulaPlan& plan_;
    formula::Meanings meanings_;
};

/// True if two values are equal up to rounding.
bool agree(const MatrixX& a, const MatrixX& b) {
    if (a.rows() != b.rows() || a.cols() != b.cols()) { return false; }
    // symbols are of the size of 1 to 1000; a pose is assembled to 1e-12
    return (a - b).cwiseAbs().maxCoeff() <= 1e-8 * std::max(1.0, a.cwiseAbs().maxCoeff());
}

MatrixX with_position(const Vec3& r, const MatrixX& p) {
    MatrixX pose(7, 1);
    pose << r, p;
    return pose;
}

/// Adds r to the answer: a pose asks for r and p.
void ask_for_pose(const AskedFormula& f, Asked& asked) {
    const MatrixX r = f.value_or_empty(math::own_math("r"));
    if (r.size() != 3 || asked.right.size() != 4) {
        asked.problem = "a pose needs 'body', and a formula of p if there is one";
        return;
    }
    asked.sign_of_p = true;
    asked.right = with_position(r, asked.right);
    for (KnownMistake& mistake : asked.mistakes) {
        const bool fits = mistake.answer.rows() == 4 && mistake.answer.cols() == 1;
        mistake.answer = fits ? with_position(r, mistake.answer) : MatrixX();
    }
}

MatrixX as_matrix(double value) { return MatrixX::Constant(1, 1, value); }

void add_answer(Asked& asked, const ValueMistake& mistake, MatrixX answer) {
    asked.mistakes.push_back(
        {mistake.name,
         {{mistake.title, {}}},
         {mistake.says, {asked.unit}},
         mistake.slide,
         std::move(answer),
         {}});
}

void add_value(Asked& asked, const ValueMistake& mistake, double value) {
    add_answer(asked, mistake, as_matrix(value));
}

/// Adds the right answer in degrees where radians are asked for, and the reverse.
void add_mixed_units(Asked& asked) {
    const std::optional<WrittenUnit> unit = read_unit(asked.unit);
    if (!unit || unit->powers[3] == 0) { return; }
    // 1 deg is 0.017 rad: units of degrees have a factor
    const bool in_degrees = unit->factor != 1.0;
    add_answer(asked, kMixedUnits, asked.right * (in_degrees ? unit->factor : kDegreesPerRadian));
}

void ask_formula(
    const Variant& variant, const FormulaClaim& claim, const Instant& instant, KnownMistakes mistakes,
    Asked& asked) {
    const FormulaPlan& plan = *variant.plan;
    const AskedFormula f(plan, claim, instant);
    try {
        asked.right = f.asked();
        if (!agree(asked.right, f.found())) {
            asked.problem = "the sides of its formula differ in this variant";
            return;
        }
    } catch (const std::runtime_error& error) {
        asked.problem = std::string("its formula has no value: ") + error.what();
        return;
    }
    asked.latex = math::write_latex(plan.found);
    if (mistakes == KnownMistakes::answered) { asked.mistakes = f.mistakes(); }
    for (const Row& symbol : plan.given) {
        asked.given.push_back({math::write_latex(symbol), f.value_or_empty(symbol)});
        if (asked.given.back().value.size() == 0) {
            asked.problem = "'" + math::write_plain(symbol) + "' has no value here";
        }
    }
    if (variant.exercise->kind == ExerciseKind::pose) { ask_for_pose(f, asked); }
    asked.unit = variant.exercise->unit;
    add_mixed_units(asked);
}

void ask_count(const CountClaim& claim, const Instant& instant, Asked& asked) {
    const RankReport report = rank_of(*instant.system, instant.state, instant.t);
    if (!report.decided) { asked.problem = "the rank is undecided there"; }
    asked.right = as_matrix(count_of(report, claim.count));
    for (const CountMistake& of_count : kCountMistakes) {
        if (of_count.count != claim.count) {
            add_value(asked, of_count.mistake, count_of(report, of_count.count));
        }
    }
}

void ask_dropped(const DroppedClaim& claim, const Instant& instant, Asked& asked) {
    int dropped = -1;
    for (const Constraint& c : instant.system->constraints()) {
        if (c.joint == claim.joint && c.role == claim.role) { dropped = c.dropped; }
    }
    if (dropped < 0) { asked.problem = "no equation is left out there"; }
    asked.right = as_matrix(dropped + 1);
    for (int k = 0; k < 3; ++k) {
        if (k == dropped) { continue; }
        add_value(asked, kWrongTwo, k + 1);
    }
}

double quantity_at(const QuantityClaim& claim, const Instant& instant) {
    return evaluate(claim.quantity, instant, claim.derivative)
        .derivatives[static_cast<std::size_t>(claim.derivative)];
}

/// The value if the scene is assembled on the other branch.
double value_of_other_branch(const Variant& variant, const QuantityClaim& claim, const Moment& when) {
    Session session(variant.lesson, false);
    for (const std::string& action : variant.exercise->branch) {
        if (!carry_out(session, action).done) { return kInfinity; }
    }
    const Pose pose = ClaimPoses(session.lesson()).at(when);
    return pose.failure.empty() ? quantity_at(claim, pose.instant) : kInfinity;
}

void ask_quantity(const Variant& variant, const QuantityClaim& claim, const Pose& pose, Asked& asked) {
    const double factor = claim.in_degrees ? kDegreesPerRadian : 1.0;
    const double value = factor * quantity_at(claim, pose.instant);
    if (!std::isfinite(value)) { asked.problem = "the quantity has no value there"; }
    asked.right = as_matrix(value);
    asked.unit = unit_text(dimension_of(claim.quantity), claim.derivative, claim.in_degrees);
    const bool is_angle = claim.derivative == 0 && is_modulo_turn(claim.quantity);
    if (is_angle) { asked.turn = factor * 2.0 * std::numbers::pi; }
    add_value(asked, kOppositeSign, -value);
    const std::optional<WrittenUnit> unit = read_unit(asked.unit);
    add_mixed_units(asked);
    if (!is_angle && unit && unit->powers == std::array<int, 4>{0, 0, 0, 1}) {
        const double turn = factor * 2.0 * std::numbers::pi;
        add_value(asked, kFullTurn, value - turn);
        add_value(asked, kFullTurn, value + turn);
    }
    if (!variant.exercise->branch.empty()) {
        const double other =
            factor * value_of_other_branch(variant, claim, variant.lesson.claims.front().when);
        add_value(asked, kOtherBranch, other);
    }
}

/// Keeps the mistakes that the exercise looks for, and mistakes in two terms.
void filter_mistakes(const Exercise& exercise, Asked& asked) {
    const auto is_unwanted = [&](const KnownMistake& mistake) {
        return mistake.name != kTwoTermsName && !looks_for(exercise, mistake.name);
    };
    std::erase_if(asked.mistakes, is_unwanted);
}

double tolerance_of(const Exercise& exercise, const Asked& asked) {
    if (exercise.absolute || asked.right.size() == 0) { return exercise.tolerance; }
    const double largest = asked.right.cwiseAbs().maxCoeff();
    // an answer of zero has no size
    return exercise.tolerance * (largest > 0.0 ? largest : 1.0);
}

/// The instant at which a formula is evaluated; a random one for `any_state`.
std::optional<Instant> instant_of(const Variant& variant, const Pose& pose) {
    const Claim& claim = variant.lesson.claims.front();
    if (!std::holds_alternative<AnyState>(claim.when)) { return pose.instant; }
    Instant instant =
        formula::arbitrary_instant(pose.instant.system, static_cast<unsigned>(variant.seed & 0x7FFFFFFFU));
    instant.scene = pose.instant.scene;
    return instant;
}

}  // namespace

std::string title_of(const KnownMistake& mistake) {
    std::vector<std::string> titles;
    for (const Message& title : mistake.titles) { titles.push_back(tr(title)); }
    return alternatives(titles);
}

std::string unit_behind(const Asked& asked) { return asked.unit.empty() ? "" : " " + asked.unit; }

Asked asked_in(const Variant& variant) {
    Asked asked;
    if (variant.lesson.claims.empty()) {
        asked.problem = "nothing is asked";
        return asked;
    }
    const Claim& claim = variant.lesson.claims.front();
    const Pose pose = ClaimPoses(variant.lesson).at(claim.when);
    if (!pose.failure.empty()) {
        asked.problem = "the pose is not reached: " + pose.failure;
        return asked;
    }
    const std::optional<Instant> instant = instant_of(variant, pose);
    std::visit(
        Overloaded{
            [&](const FormulaClaim& c) { ask_formula(variant, c, *instant, KnownMistakes::answered, asked); },
            [&](const CountClaim& c) { ask_count(c, *instant, asked); },
            [&](const DroppedClaim& c) { ask_dropped(c, *instant, asked); },
            [&](const QuantityClaim& c) { ask_quantity(variant, c, pose, asked); },
            [&](const auto&) { asked.problem = "this cannot be asked for"; },
        },
        claim.fact);
    if (asked.unit.empty()) { asked.unit = variant.exercise->unit; }
    if (asked.problem.empty() && !std::holds_alternative<AnyState>(claim.when) &&
        !std::holds_alternative<AsGiven>(claim.when)) {
        const RankReport report = rank_of(*pose.instant.system, pose.instant.state, pose.instant.t);
        if (report.rank > 0) { asked.condition = report.first_value() / report.last_value(); }
    }
    filter_mistakes(*variant.exercise, asked);
    asked.tolerance = tolerance_of(*variant.exercise, asked);
    return asked;
}

std::vector<KnownMistake> mistakes_in_two_terms(const Variant& variant) {
    if (!variant.plan) { return {}; }
    Variant twice = variant;
    twice.plan = std::make_shared<const FormulaPlan>(plan_of_two_terms(*variant.plan, *variant.exercise));
    Asked asked = asked_in(twice);
    // a unit adds its own mistakes
    std::erase_if(asked.mistakes, [](const KnownMistake& mistake) { return mistake.name != kTwoTermsName; });
    return std::move(asked.mistakes);
}

Asked asked_at(const Variant& variant, const Instant& instant, KnownMistakes mistakes) {
    Asked asked;
    const Claim& claim = variant.lesson.claims.front();
    const auto* const formula = std::get_if<FormulaClaim>(&claim.fact);
    if (formula == nullptr) {
        asked.problem = "no formula is asked for";
        return asked;
    }
    ask_formula(variant, *formula, instant, mistakes, asked);
    filter_mistakes(*variant.exercise, asked);
    asked.tolerance = tolerance_of(*variant.exercise, asked);
    return asked;
}

double difference_from(const MatrixX& right, const MatrixX& other, const Asked& asked) {
    if (right.rows() != other.rows() || right.cols() != other.cols() || right.size() == 0) {
        return kInfinity;
    }
    // a mistake may divide by zero
    if (!right.allFinite() || !other.allFinite()) { return kInfinity; }
    MatrixX apart = other - right;
    if (asked.turn > 0.0) { apart(0, 0) = std::remainder(apart(0, 0), asked.turn); }
    if (asked.sign_of_p) {
        const double r = apart.topRows(3).cwiseAbs().maxCoeff();
        const double same = apart.bottomRows(4).cwiseAbs().maxCoeff();
        const double opposite = (other + right).bottomRows(4).cwiseAbs().maxCoeff();
        return std::max(r, std::min(same, opposite));
    }
    return apart.cwiseAbs().maxCoeff();
}

}  // namespace jw
