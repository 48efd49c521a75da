#include "app/session/answers/right_answer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <vector>

#include "app/session/story/dynamics_rows.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/elementary/elementary.hpp"
#include "core/numerics/decimal.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

// the answer is computed again at every change of the lesson: a scene that was made stiff or endless has no
// answer
constexpr long kMostStepsOfAnswer = 100'000;

RightAnswer right_count(const CountAnswer& answer, const Step& step) {
    const RankReport report = rank_of(step);
    return {.number = static_cast<double>(count_of(report, answer.count)), .known = report.decided};
}

RightAnswer right_axis(const DroppedAnswer& answer, const Step& step) {
    RightAnswer right;
    for (const Constraint& c : step.system->constraints()) {
        if (c.joint == answer.joint && c.role == answer.role) { right.choice = c.dropped; }
    }
    right.known = right.choice >= 0;
    return right;
}

/// The instant at a time of the motion that the lesson prescribes.
std::optional<Instant> driven_instant(const Story& story, double t) {
    const Step& assembled = story.steps()[at(story.last_assembled())];
    System system = *assembled.system;
    MotionTracker tracker(system, assembled.state, assembled.t);
    bool switched = false;
    if (!advance_along(tracker, story.lesson(), t, switched)) { return std::nullopt; }
    return instant_of(std::make_shared<const System>(system), tracker.frame());
}

double value_at(const QuantityAnswer& answer, const Instant& instant) {
    return evaluate(answer.quantity, instant, answer.derivative).derivatives[at(answer.derivative)];
}

/// The instant at exactly the time `t` of the motion by masses and forces.
std::optional<Instant> instant_of_run(const Lesson& lesson, double t, double tolerance) {
    std::map<double, Instant> found;
    const RunLimits limits{tolerance, kMostStepsOfAnswer};
    const std::string failure = instants_by_forces(lesson, limits, {t}, found);
    if (!failure.empty() || found.empty()) { return std::nullopt; }
    return found.rbegin()->second;
}

/// Result of `read` at a time of the motion. Nothing if two runs by masses and forces with different
/// tolerances differ by more than the answer allows.
template <class Read, class Agree>
auto found_at(const Story& story, const AtTime& when, const Read& read, const Agree& agree)
    -> std::optional<decltype(read(Instant{}))> {
    if (!when.by_forces) {
        const auto instant = driven_instant(story, when.t);
        return instant ? std::optional(read(*instant)) : std::nullopt;
    }
    const auto tight = instant_of_run(story.lesson(), when.t, kTightRun);
    const auto loose = instant_of_run(story.lesson(), when.t, kLooseRun);
    if (!tight || !loose || !agree(read(*tight), read(*loose))) { return std::nullopt; }
    return read(*tight);
}

RightAnswer right_quantity(const QuantityAnswer& answer, const Story& story) {
    RightAnswer right;
    const auto found = found_at(
        story, answer.when, [&](const Instant& instant) { return value_at(answer, instant); },
        [&](double a, double b) { return std::abs(a - b) <= answer.tolerance; });
    const double value = found.value_or(std::numeric_limits<double>::quiet_NaN());
    const double factor = answer.in_degrees ? kDegreesPerRadian : 1.0;
    right.number = factor * value;
    right.tolerance = factor * answer.tolerance;
    const bool modulo_turn = answer.derivative == 0 && is_modulo_turn(answer.quantity);
    right.turn = modulo_turn ? factor * 2.0 * std::numbers::pi : 0.0;
    right.known = std::isfinite(right.number);
    return right;
}

BodyPose pose_of(const State& state, int body) {
    const auto b = at(body);
    return {state.r[b], state.p[b]};
}

RightAnswer right_pose(const PoseAnswer& answer, const Story& story, const Step& step) {
    RightAnswer right;
    right.tolerance = answer.tolerance_m;
    right.tolerance_rad = answer.tolerance_rad;
    right.pose = pose_of(step.state, answer.body);
    if (answer.when) {
        right.pose = found_at(
            story, *answer.when, [&](const Instant& instant) { return pose_of(instant.state, answer.body); },
            [&](const BodyPose& a, const BodyPose& b) {
                return (a.r - b.r).norm() <= answer.tolerance_m && a.turn_from(b) <= answer.tolerance_rad;
            });
    }
    right.known = right.pose && right.pose->r.allFinite() && right.pose->p.allFinite();
    if (!right.known) { right.pose.reset(); }
    return right;
}

/// The rows that p1 and p2 leave out: those of the joint that the step adds, otherwise those of all joints.
std::vector<Thing> dropped_rows(const Question& question, const Step& step) {
    const bool of_one =
        question.place == Question::Place::addition && question.addition.kind == Addition::Kind::joint;
    std::vector<Thing> rows;
    for (const Constraint& c : step.system->constraints()) {
        if (c.dropped < 0 || (of_one && c.joint != question.addition.index)) { continue; }
        rows.push_back(Thing::row(c.joint, {c.role, c.dropped}));
    }
    return rows;
}

/// Every row of a linear dependency, in the order of the system: each of them could be left out instead of
/// the one that was found.
std::vector<Thing> redundant_rows(const Step& step, const RankReport& report) {
    std::vector<int> found;
    for (const RedundantRow& redundant : report.redundant_rows) {
        found.push_back(redundant.row);
        for (const RedundantRow::Term& term : redundant.terms) { found.push_back(term.row); }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<Thing> rows;
    for (const int row : found) {
        if (const auto thing = thing_of_row(*step.system, row)) { rows.push_back(*thing); }
    }
    return rows;
}

RightAnswer right_things(const PointedAnswer& answer, const Question& question, const Step& step) {
    RightAnswer right;
    right.known = true;
    right.things = answer.right;
    if (answer.found == RowsFound::dropped) {
        right.things = dropped_rows(question, step);
    } else if (answer.found == RowsFound::redundant) {
        const RankReport report = rank_of(step);
        right.things = redundant_rows(step, report);
        right.known = report.decided;
    }
    // without such a thing, no click can be right
    right.known = right.known && !right.things.empty();
    return right;
}

std::string without_blanks(const std::string& text) {
    std::string kept;
    std::ranges::copy_if(text, std::back_inserter(kept), [](char c) { return c != ' '; });
    return kept;
}

/// A number or a fraction of two numbers, with or without the unit after it.
std::optional<double> typed_number(std::string text, const std::string& unit) {
    text = without_blanks(text);
    const std::string plain_unit = without_blanks(unit);
    if (!plain_unit.empty() && text.size() > plain_unit.size() && text.ends_with(plain_unit)) {
        text.resize(text.size() - plain_unit.size());
    }
    const auto parse = [](std::string_view part) -> std::optional<double> {
        double value = 0.0;
        const auto [end, error] = read_decimal(part.data(), part.data() + part.size(), value);
        const bool whole = error == std::errc() && end == part.data() + part.size();
        return whole && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
    };
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) { return parse(text); }
    const auto above = parse(std::string_view(text).substr(0, slash));
    const auto below = parse(std::string_view(text).substr(slash + 1));
    if (!above || !below || *below == 0.0) { return std::nullopt; }
    return *above / *below;
}

int chosen(const QuestionView& view, const std::string& given) {
    const std::optional<double> number = typed_number(given, "");
    const auto count = static_cast<double>(view.choices.size());
    if (number && *number >= 1.0 && *number <= count && *number == std::floor(*number)) {
        return static_cast<int>(*number) - 1;
    }
    for (std::size_t k = 0; k < view.choices.size(); ++k) {
        if (!given.empty() && math::plain_words(view.choices[k]).starts_with(given)) {
            return static_cast<int>(k);
        }
    }
    return -1;
}

GivenAnswer not_understood(std::string why) { return {false, false, std::move(why)}; }

GivenAnswer judge_choice(const QuestionView& view, const RightAnswer& right, const std::string& given) {
    const int choice = chosen(view, given);
    if (choice < 0) {
        return not_understood(tr("expected the number of a choice, 1 to {0}", view.choices.size()));
    }
    return {true, right.known && choice == right.choice, tr("You said: {0}", view.choices[at(choice)])};
}

GivenAnswer judge_number(const QuestionView& view, const RightAnswer& right, const std::string& given) {
    const std::optional<double> number = typed_number(given, view.unit);
    if (!number) {
        return not_understood(
            view.unit.empty() ? tr("expected a number") : tr("expected a number in {0}", view.unit));
    }
    const double apart = *number - right.number;
    const double off = right.turn > 0.0 ? std::remainder(apart, right.turn) : apart;
    const std::string said = number_text(*number, 6) + (view.unit.empty() ? "" : " " + view.unit);
    GivenAnswer judged{true, right.known && std::abs(off) <= right.tolerance, tr("You said {0}.", said)};
    if (right.known && !judged.right && right.tolerance > 0.0) {
        judged.note = followed(judged.note, tr("Off by {0}.", number_text(off, 3)));
    }
    return judged;
}

GivenAnswer judge_thing(
    const QuestionView& view, const RightAnswer& right, const Mechanism& mechanism,
    const std::string& given) {
    const std::optional<Thing> thing = thing_named(mechanism, view.thing, given);
    const bool possible =
        thing && std::ranges::find(view.names, name_of(*thing, mechanism)) != view.names.end();
    if (!possible) {
        return not_understood(
            view.names.empty() ? tr("nothing of that kind is here")
                               : tr("expected a name such as {0}", view.names.front()));
    }
    const bool is_right = right.known && std::ranges::find(right.things, *thing) != right.things.end();
    return {true, is_right, tr("You said: {0}", name_of(*thing, mechanism))};
}

/// Seven numbers, separated by blanks, commas or semicolons.
std::optional<BodyPose> typed_pose(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == ',' || c == ';'; }, ' ');
    std::istringstream words(text);
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        const std::optional<double> number = typed_number(word, "");
        if (!number) { return std::nullopt; }
        numbers.push_back(*number);
    }
    if (numbers.size() != 7) { return std::nullopt; }
    BodyPose pose{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5], numbers[6]}};
    const double length = pose.p.norm();
    // a p that was typed with a few digits has length 1 only to a few per cent
    if (!(length > 0.5) || !(length < 2.0)) { return std::nullopt; }
    pose.p /= length;
    return pose;
}

GivenAnswer judge_pose(const RightAnswer& right, const std::string& given) {
    const std::optional<BodyPose> pose = typed_pose(given);
    if (!pose) { return not_understood(tr("expected x, y, z [m] and e0, e1, e2, e3; or drag the body")); }
    GivenAnswer judged{true, false, tr("You said: {0}", tr("r = {0} m", vector_text(pose->r)))};
    if (!right.known || !right.pose) { return judged; }
    const double off = (pose->r - right.pose->r).norm();
    const double turn = pose->turn_from(*right.pose);
    judged.right = off <= right.tolerance && turn <= right.tolerance_rad;
    if (!judged.right) {
        judged.note = followed(
            judged.note + ".",
            tr("Off by {0} m and {1}°.", number_text(off, 3), number_text(turn * kDegreesPerRadian, 3)));
    }
    return judged;
}

}  // namespace

double BodyPose::turn_from(const BodyPose& other) const {
    // |p - p'| = 2 sin(angle / 4); an arc cosine of pᵀp' would lose half of the digits of a small angle
    const double apart = std::min((p - other.p).norm(), (p + other.p).norm());
    return 4.0 * elementary::asin(std::min(1.0, 0.5 * apart));
}

std::optional<Thing> thing_of_row(const System& system, int row) {
    const RowOrigin origin = system.origin(row);
    const auto k = at(origin.index);
    switch (origin.kind) {
        case RowOrigin::Kind::constraint: {
            const Constraint& c = system.constraints()[k];
            return Thing::row(c.joint, {c.role, origin.component});
        }
        case RowOrigin::Kind::driver: return Thing::row_of_driver(system.drivers()[k].driver);
        case RowOrigin::Kind::normalisation: break;
    }
    return std::nullopt;
}

RightAnswer right_answer(const Story& story, int index) {
    const Question& question = story.lesson().questions[at(index)];
    for (const Step& step : story.steps()) {
        if (step.kind == Step::Kind::answer && step.question == index) {
            return right_answer(story, question, step);
        }
    }
    return {};
}

RightAnswer right_answer(const Story& story, const Question& question, const Step& step) {
    return std::visit(
        Overloaded{
            [&](const CountAnswer& a) { return right_count(a, step); },
            [&](const DroppedAnswer& a) { return right_axis(a, step); },
            [&](const QuantityAnswer& a) { return right_quantity(a, story); },
            [&](const ChoiceAnswer& a) { return RightAnswer{.choice = a.right, .known = true}; },
            [&](const PointedAnswer& a) { return right_things(a, question, step); },
            [&](const PoseAnswer& a) { return right_pose(a, story, step); },
        },
        question.answer);
}

GivenAnswer judge_answer(
    const QuestionView& view, const RightAnswer& right, const Mechanism& mechanism,
    const std::string& given) {
    switch (view.kind) {
        case QuestionView::Kind::choice: return judge_choice(view, right, given);
        case QuestionView::Kind::thing: return judge_thing(view, right, mechanism, given);
        case QuestionView::Kind::pose: return judge_pose(right, given);
        case QuestionView::Kind::number: break;
    }
    return judge_number(view, right, given);
}

std::string pose_text(const BodyPose& pose) {
    const auto exact = [](double x) { return number_text(x, 17); };
    return joined(pose.r, " ", exact) + " " + joined(pose.p, " ", exact);
}

}  // namespace jw
