#include "app/session/view/question_view.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "app/session/story/dynamics_rows.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/quantity_text.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
// the answer is found anew whenever the lesson is changed: a scene that was made stiff or endless has none
constexpr long kMostStepsOfAnswer = 100'000;

std::vector<std::string> choices_of(const Question& question) {
    return std::visit(
        Overloaded{
            [](const ChoiceAnswer& a) {
                return std::vector<std::string>(a.choices.begin(), a.choices.end());
            },
            [](const DroppedAnswer&) { return std::vector<std::string>(kAxes.begin(), kAxes.end()); },
            [](const CountAnswer&) { return std::vector<std::string>(); },
            [](const QuantityAnswer&) { return std::vector<std::string>(); },
        },
        question.answer);
}

std::string unit_of_answer(const Question& question) {
    const auto* const quantity = std::get_if<QuantityAnswer>(&question.answer);
    if (quantity == nullptr) { return {}; }
    return unit_text(dimension_of(quantity->quantity), quantity->derivative, quantity->in_degrees);
}

RightAnswer right_count(const CountAnswer& answer, const Step& step) {
    const RankReport report = step.rank ? *step.rank : rank_of(*step.system, step.state, step.t);
    RightAnswer right;
    right.number = count_of(report, answer.count);
    right.known = report.decided;
    return right;
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
    const Step& assembled = story.steps()[static_cast<std::size_t>(story.last_assembled())];
    System system = *assembled.system;
    MotionTracker tracker(system, assembled.state, assembled.t);
    bool switched = false;
    if (!advance_along(tracker, story.lesson(), t, switched)) { return std::nullopt; }
    Instant instant;
    instant.t = t;
    instant.system = std::make_shared<const System>(system);
    instant.state = tracker.frame().state;
    instant.velocity = tracker.frame().velocity;
    instant.acceleration = tracker.frame().acceleration;
    return instant;
}

double value_at(const QuantityAnswer& answer, const Instant& instant) {
    return evaluate(answer.quantity, instant, answer.derivative)
        .derivatives[static_cast<std::size_t>(answer.derivative)];
}

/// By masses and forces, at exactly that time. NaN where two runs of different tolerance do not agree as well
/// as the answer has to.
double value_by_forces(const QuantityAnswer& answer, const Lesson& lesson) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto run = [&](double tolerance) {
        std::map<double, Instant> found;
        const RunLimits limits{tolerance, kMostStepsOfAnswer};
        const std::string failure = instants_by_forces(lesson, limits, {answer.when.t}, found);
        return failure.empty() && !found.empty() ? value_at(answer, found.rbegin()->second) : none;
    };
    const double value = run(kTightRun);
    return std::abs(value - run(kLooseRun)) <= answer.tolerance ? value : none;
}

RightAnswer right_quantity(const QuantityAnswer& answer, const Story& story) {
    RightAnswer right;
    double value = std::numeric_limits<double>::quiet_NaN();
    if (answer.when.by_forces) {
        value = value_by_forces(answer, story.lesson());
    } else if (const auto instant = driven_instant(story, answer.when.t)) {
        value = value_at(answer, *instant);
    }
    const double factor = answer.in_degrees ? kDegreesPerRadian : 1.0;
    right.number = factor * value;
    right.tolerance = factor * answer.tolerance;
    const bool modulo_turn = answer.derivative == 0 && is_modulo_turn(answer.quantity);
    right.turn = modulo_turn ? factor * 2.0 * std::numbers::pi : 0.0;
    right.known = std::isfinite(right.number);
    return right;
}

std::string answer_text(const Question& question, const RightAnswer& right) {
    if (!right.known) { return tr("It cannot be told in this scene."); }
    if (right.choice >= 0) { return choices_of(question)[static_cast<std::size_t>(right.choice)]; }
    const std::string unit = unit_of_answer(question);
    // as many digits as the tolerance asks for, and two more
    const double size = std::max(std::abs(right.number), 1e-300);
    const int digits =
        right.tolerance > 0.0
            ? std::clamp(static_cast<int>(std::ceil(std::log10(size / right.tolerance))) + 2, 2, 9)
            : 6;
    return number_text(right.number, digits) + (unit.empty() ? "" : " " + unit);
}

std::string without_blanks(const std::string& text) {
    std::string kept;
    std::ranges::copy_if(text, std::back_inserter(kept), [](char c) { return c != ' '; });
    return kept;
}

/// A number, a fraction of two, with or without the unit behind it.
std::optional<double> typed_number(std::string text, const std::string& unit) {
    text = without_blanks(text);
    const std::string plain_unit = without_blanks(unit);
    if (!plain_unit.empty() && text.size() > plain_unit.size() && text.ends_with(plain_unit)) {
        text.resize(text.size() - plain_unit.size());
    }
    const auto parse = [](std::string_view part) -> std::optional<double> {
        double value = 0.0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
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

}  // namespace

QuestionView question_view_of(const Story& story, const Step& step) {
    const Question& question = story.lesson().questions[static_cast<std::size_t>(step.question)];
    QuestionView view;
    view.ask = question.ask;
    view.choices = choices_of(question);
    view.unit = unit_of_answer(question);
    view.answered = step.kind == Step::Kind::answer;
    if (!view.answered) { return view; }
    view.answer = answer_text(question, right_answer(story, question, step));
    view.why = question.why;
    return view;
}

RightAnswer right_answer(const Story& story, const Question& question, const Step& step) {
    return std::visit(
        Overloaded{
            [&](const CountAnswer& a) { return right_count(a, step); },
            [&](const DroppedAnswer& a) { return right_axis(a, step); },
            [&](const QuantityAnswer& a) { return right_quantity(a, story); },
            [&](const ChoiceAnswer& a) {
                RightAnswer right;
                right.choice = a.right;
                right.known = true;
                return right;
            },
        },
        question.answer);
}

GivenAnswer judge_answer(const QuestionView& view, const RightAnswer& right, const std::string& given) {
    GivenAnswer judged;
    if (!view.choices.empty()) {
        const int choice = chosen(view, given);
        if (choice < 0) {
            judged.note = tr("expected the number of a choice, 1 to {0}", view.choices.size());
            return judged;
        }
        judged.understood = true;
        judged.right = right.known && choice == right.choice;
        judged.note = tr("You said: {0}", view.choices[static_cast<std::size_t>(choice)]);
        return judged;
    }
    const std::optional<double> number = typed_number(given, view.unit);
    if (!number) {
        judged.note = view.unit.empty() ? tr("expected a number") : tr("expected a number in {0}", view.unit);
        return judged;
    }
    const double apart = *number - right.number;
    const double off = right.turn > 0.0 ? std::remainder(apart, right.turn) : apart;
    judged.understood = true;
    judged.right = right.known && std::abs(off) <= right.tolerance;
    judged.note = tr("You said {0}.", number_text(*number, 6) + (view.unit.empty() ? "" : " " + view.unit));
    if (right.known && !judged.right && right.tolerance > 0.0) {
        judged.note = followed(judged.note, tr("Off by {0}.", number_text(off, 3)));
    }
    return judged;
}

}  // namespace jw
