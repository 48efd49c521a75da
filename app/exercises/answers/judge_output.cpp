#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/exercises/answers/read_output.hpp"
#include "app/exercises/kinds.hpp"
#include "app/session/story/taking_part.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/formula/symbol.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace {

using Json = nlohmann::json;

/// Programs compute with doubles: rounding errors are far smaller than this, mistakes far larger.
constexpr double kTolerance = 1e-6;
constexpr double kWorthOfCases = 0.5;
/// Number of entries of one answer that are listed in the feedback.
constexpr int kMostEntriesTold = 4;
constexpr std::array kHardStates{
    tr_later("all orientations p = (1, 0, 0, 0)"), tr_later("e0 = 0: half a turn"),
    tr_later("a turn of almost 360 degrees"), tr_later("positions a thousand times as large")};

/// A state of the bodies in which a program is tested.
struct CodeCase {
    const char* name = nullptr;  ///< message; null: a random state
    Asked asked;
};

Instant hard_instant(std::shared_ptr<const System> system, unsigned seed, std::size_t which) {
    Instant instant = formula::arbitrary_instant(std::move(system), seed);
    constexpr double kAlmost = 1e-6;
    for (std::size_t b = 0; b < instant.state.p.size(); ++b) {
        if (which == 0) { instant.state.p[b] = Vec4(1.0, 0.0, 0.0, 0.0); }
        if (which == 1) { instant.state.p[b] = Vec4(0.0, 0.6, 0.0, 0.8); }
        if (which == 2) { instant.state.p[b] = Vec4(-1.0, kAlmost, 0.0, kAlmost).normalized(); }
        if (which == 3) { instant.state.r[b] *= 1000.0; }
    }
    return instant;
}

std::vector<CodeCase> cases_of(const Task& task, KnownMistakes mistakes) {
    const Lesson& lesson = task.variant.lesson;
    const auto system = std::make_shared<const System>(lesson.mechanism, everything(lesson.mechanism));
    const std::shared_ptr<const Centroidal> scene = scene_of(lesson);
    std::vector<CodeCase> cases;
    const auto seed = static_cast<unsigned>(task.variant.seed & 0x3FFFFFFFU);
    for (int k = 0; k < task.exercise().cases; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const unsigned of_case = seed + static_cast<unsigned>(k);
        const bool hard = at < kHardStates.size();
        Instant instant =
            hard ? hard_instant(system, of_case, at) : formula::arbitrary_instant(system, of_case);
        instant.scene = scene;
        Asked asked = asked_at(task.variant, instant, mistakes);
        // a formula may have no value in a special state
        if (!asked.problem.empty() || !asked.right.allFinite()) { continue; }
        cases.push_back({hard ? kHardStates[at] : nullptr, std::move(asked)});
    }
    return cases;
}

Json json_of(const MatrixX& m) {
    if (m.size() == 1) { return m(0, 0); }
    Json rows = Json::array();
    for (Eigen::Index r = 0; r < m.rows(); ++r) {
        if (m.cols() == 1) {
            rows.push_back(m(r, 0));
            continue;
        }
        Json row = Json::array();
        for (Eigen::Index c = 0; c < m.cols(); ++c) { row.push_back(m(r, c)); }
        rows.push_back(std::move(row));
    }
    return rows;
}

bool fits_answer(const MatrixX& right, const MatrixX& given, const Asked& asked) {
    const double size = right.size() > 0 ? std::max(1.0, right.cwiseAbs().maxCoeff()) : 1.0;
    return given.size() > 0 && given.allFinite() && difference_from(right, given, asked) <= kTolerance * size;
}

/// True for numbers of which at least one is NaN or infinite.
bool is_without_value(const MatrixX& given) { return given.size() > 0 && !given.allFinite(); }

bool is_random(const CodeCase& c) { return c.name == nullptr; }

/// True if there is an answer in a random state: in special states, different mistakes may give the same
/// answer.
bool can_tell_mistakes(const std::vector<CodeCase>& cases, const std::vector<MatrixX>& given) {
    for (std::size_t k = 0; k < given.size(); ++k) {
        if (is_random(cases[k]) && !is_without_value(given[k])) { return true; }
    }
    return false;
}

/// The known mistake that gives all these answers; answers without a value are ignored.
const KnownMistake* mistake_of(const std::vector<CodeCase>& cases, const std::vector<MatrixX>& given) {
    if (!can_tell_mistakes(cases, given)) { return nullptr; }
    const std::size_t count = cases.front().asked.mistakes.size();
    for (std::size_t m = 0; m < count; ++m) {
        bool all = true;
        for (std::size_t k = 0; all && k < given.size(); ++k) {
            if (is_without_value(given[k])) { continue; }
            all = m < cases[k].asked.mistakes.size() &&
                  fits_answer(cases[k].asked.mistakes[m].answer, given[k], cases[k].asked);
        }
        if (all) { return &cases.front().asked.mistakes[m]; }
    }
    return nullptr;
}

/// A list with one more item, as people write it: "a; b".
std::string with_next(const std::string& list, const std::string& item) {
    return list.empty() ? item : tr("{0}; {1}", list, item);
}

std::string entry_text(double entry, int digits) {
    return std::isfinite(entry) ? number_text(entry, digits) : "NaN";
}

/// Sentence about a wrong answer in a state: it gives the shape, or the entries that differ.
std::string told_answer(const std::string& state, const MatrixX& right, const MatrixX& given) {
    if (given.size() == 0) {
        return tr(
            "In {0} the answer is not a number, a list of numbers or a list of rows of the same length; "
            "expected {1} × {2} numbers.",
            state, right.rows(), right.cols());
    }
    if (given.rows() != right.rows() || given.cols() != right.cols()) {
        return tr(
            "In {0} the answer has {1} × {2} numbers; expected {3} × {4}.", state, given.rows(), given.cols(),
            right.rows(), right.cols());
    }
    const double size = std::max(1.0, right.cwiseAbs().maxCoeff());
    std::string entries;
    int wrong = 0;
    for (Eigen::Index r = 0; r < right.rows(); ++r) {
        for (Eigen::Index c = 0; c < right.cols(); ++c) {
            const double entry = given(r, c);
            if (std::abs(entry - right(r, c)) <= kTolerance * size) { continue; }
            if (++wrong > kMostEntriesTold) { continue; }
            const int digits = writing::digits_apart(entry, right(r, c), 6);
            const std::string told =
                tr("entry ({0}, {1}) is {2}, expected {3}", r + 1, c + 1, entry_text(entry, digits),
                   number_text(right(r, c), digits));
            entries = with_next(entries, told);
        }
    }
    return wrong > kMostEntriesTold
               ? tr("In {0}: {1}; and {2} more.", state, entries, wrong - kMostEntriesTold)
               : tr("In {0}: {1}.", state, entries);
}

std::string state_of(const std::vector<CodeCase>& cases, std::size_t k) {
    return is_random(cases[k]) ? tr("case {0}", k) : tr(cases[k].name);
}

void tell_missing_values(
    const std::vector<CodeCase>& cases, const std::vector<MatrixX>& given, Judged& judged) {
    const auto first = std::ranges::find_if(given, is_without_value);
    if (first == given.end()) { return; }
    const auto count = static_cast<int>(std::ranges::count_if(given, is_without_value));
    judged.feedback.push_back(tr_count(
        count,
        "{0} answer has NaN or infinity, the first in {1}: check divisions by zero, and roots and arc "
        "cosines of numbers that rounding moved out of range.",
        "{0} answers have NaN or infinity, the first in {1}: check divisions by zero, and roots and arc "
        "cosines of numbers that rounding moved out of range.",
        state_of(cases, static_cast<std::size_t>(first - given.begin()))));
}

/// Reports too many or too few answers: they are judged in order, as many as there are cases, and cannot earn
/// all points.
void tell_number_of_answers(std::size_t answers, std::size_t cases, Judged& judged) {
    const auto count = static_cast<int>(answers);
    judged.feedback.insert(
        judged.feedback.begin(),
        answers > cases
            ? tr_count(
                  count, "There is {0} answer; expected {1}, one for each case. The first {1} are judged.",
                  "There are {0} answers; expected {1}, one for each case. The first {1} are judged.", cases)
            : tr_count(
                  count,
                  "There is {0} answer; expected {1}, one for each case. Those that are missing count as "
                  "wrong.",
                  "There are {0} answers; expected {1}, one for each case. Those that are missing count as "
                  "wrong.",
                  cases));
    judged.right = false;
    judged.share = std::min(judged.share, kWorthOfCases);
}

/// @param given  answers of the first cases; those of the others are missing
void tell_cases(const std::vector<CodeCase>& cases, const std::vector<MatrixX>& given, Judged& judged) {
    int right = 0;
    int wrong_and_random = 0;
    const CodeCase* first = nullptr;
    std::size_t at = 0;
    for (std::size_t k = 0; k < given.size(); ++k) {
        if (fits_answer(cases[k].asked.right, given[k], cases[k].asked)) {
            ++right;
            continue;
        }
        wrong_and_random += is_random(cases[k]) ? 1 : 0;
        if (first == nullptr || (!is_random(*first) && is_random(cases[k]))) {
            first = &cases[k];
            at = k;
        }
    }
    const int count = static_cast<int>(cases.size());
    judged.right = right == count;
    judged.share = judged.right ? 1.0 : kWorthOfCases * right / count;
    if (judged.right) { return; }
    judged.feedback.push_back(tr("{0} of {1} cases are right.", right, count));
    if (first == nullptr) { return; }
    judged.feedback.push_back(told_answer(state_of(cases, at), first->asked.right, given[at]));
    tell_missing_values(cases, given, judged);
    if (wrong_and_random == 0 && given.size() == cases.size()) {
        judged.feedback.emplace_back(tr("Only special cases are wrong: check limits and divisions."));
    }
}

Handed output_of(const Json& answers) { return {Json{{"answers", answers}}.dump(), {}}; }

/// "ω" -> "omega": keys of JSON are ASCII
std::string spelt(const std::string& letter) {
    constexpr std::array<std::pair<const char*, const char*>, 9> kGreek{
        {{"ω", "omega"},
         {"Φ", "phi"},
         {"γ", "gamma"},
         {"θ", "theta"},
         {"α", "alpha"},
         {"λ", "lambda"},
         {"φ", "angle"},
         {"′", ""},
         {"π", "pi"}}};
    for (const auto& [greek, name] : kGreek) {
        if (letter == greek) { return name; }
    }
    return letter;
}

/// "s_i_local_dot" of \dot{\mathbf{s}}'_i
std::string key_of(const std::string& latex) {
    math::Row row = math::read_math(latex).row;
    if (row.size() != 1) { return latex; }
    std::string ending;
    for (auto* accent = std::get_if<math::Accent>(&row.front().nucleus); accent != nullptr;
         accent = accent->inner.size() == 1 ? std::get_if<math::Accent>(&accent->inner.front().nucleus)
                                            : nullptr) {
        if (accent->kind == math::AccentKind::dot) { ending = "_dot"; }
        if (accent->kind == math::AccentKind::two_dots) { ending = "_ddot"; }
    }
    const Letter letter = letter_of(row.front());
    if (letter.sign == nullptr) { return latex; }
    formula::Superscript script;
    const formula::Symbol symbol =
        formula::symbol_of(letter.sign->utf8, letter.node->below, letter.node->above, script);
    std::string key = spelt(symbol.letter);
    if (!symbol.index.empty()) { key += "_" + symbol.index; }
    for (const char c : symbol.marks) {
        if (c == 'B' || c == 'P') { key += std::string("_") + c; }
    }
    if (symbol.primes > 0) { key += "_local"; }
    return key + ending;
}

}  // namespace

std::vector<std::string> input_names(const Exercise& exercise) {
    std::vector<std::string> names;
    for (const std::string& symbol : exercise.given) { names.push_back(key_of(symbol)); }
    return names;
}

std::string program_input(const Task& task) {
    const std::vector<std::string> names = input_names(task.exercise());
    Json cases = Json::array();
    for (const CodeCase& c : cases_of(task, KnownMistakes::left_out)) {
        Json inputs = Json::object();
        for (std::size_t k = 0; k < names.size(); ++k) { inputs[names[k]] = json_of(c.asked.given[k].value); }
        cases.push_back(std::move(inputs));
    }
    return Json{{"exercise", task.exercise().name}, {"cases", std::move(cases)}}.dump() + "\n";
}

std::string judging_of_programs(const Task& task) {
    std::string special;
    for (const char* state : kHardStates) { special = with_next(special, tr(state)); }
    return tr(
        "It is tested in {0} cases, of which the first are special ({1}). The error of an entry may be at "
        "most {2} times the largest entry.",
        cases_of(task, KnownMistakes::left_out).size(), special, number_text(kTolerance, 1));
}

Handed right_output(const Task& task) {
    Json answers = Json::array();
    for (const CodeCase& c : cases_of(task, KnownMistakes::left_out)) {
        answers.push_back(json_of(c.asked.right));
    }
    return output_of(answers);
}

std::vector<HandedMistake> mistaken_outputs(const Task& task) {
    std::vector<HandedMistake> all;
    const std::vector<CodeCase> cases = cases_of(task, KnownMistakes::answered);
    for (const KnownMistake& known : task.asked.mistakes) {
        Json answers = Json::array();
        for (const CodeCase& c : cases) {
            const auto same = std::ranges::find_if(c.asked.mistakes, [&](const KnownMistake& m) {
                return m.says == known.says && m.shown == known.shown;
            });
            if (same != c.asked.mistakes.end()) { answers.push_back(json_of(same->answer)); }
        }
        all.push_back({known.name, output_of(answers)});
    }
    return all;
}

Judged judge_output(const Task& task, const Handed& handed) {
    const ProgramOutput output = read_program_output(handed.text);
    if (!output.problem.empty()) { return not_understood(output.problem); }
    const std::vector<CodeCase> cases = cases_of(task, KnownMistakes::answered);
    const std::size_t answered = output.answers.size();
    std::vector<MatrixX> given;
    for (std::size_t k = 0; k < std::min(answered, cases.size()); ++k) {
        given.push_back(in_shape_of(cases[k].asked.right, output.answers[k]));
    }
    Judged judged;
    tell_cases(cases, given, judged);
    if (answered != cases.size()) { tell_number_of_answers(answered, cases.size(), judged); }
    if (judged.right) { return judged; }
    if (const KnownMistake* const mistake = mistake_of(cases, given)) {
        judged.mistake = mistake->name;
        judged.title = title_of(*mistake);
        judged.slide = mistake->slide;
        judged.share = 0.0;
        judged.feedback.insert(judged.feedback.begin(), tr(mistake->says));
    }
    return judged;
}

}  // namespace jw
