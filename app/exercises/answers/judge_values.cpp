#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "app/exercises/answers/given_value.hpp"
#include "app/exercises/kinds.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/shown_lesson.hpp"

namespace jw {

namespace {

/// Right entries earn half of their share if the whole is wrong and the mistake is not known.
constexpr double kWorthOfEntries = 0.5;
/// An answer that is nearer than this many tolerances was probably rounded too early.
constexpr double kRoundedEarly = 10.0;
/// Factor by which every other answer must be farther away for a mistake to be named.
constexpr double kClearly = 3.0;
/// For a single number, at most this many pairs of mistakes are tried.
constexpr std::size_t kMostPairsOfNumber = 20;

bool is_exact(const Asked& asked) { return asked.tolerance == 0.0; }

bool is_right(const MatrixX& right, const MatrixX& given, const Asked& asked) {
    return difference_from(right, given, asked) <= (is_exact(asked) ? 1e-9 : asked.tolerance);
}

std::string shape_of(const MatrixX& m) {
    if (m.size() == 1) { return tr("a number"); }
    if (m.cols() == 1) { return tr("a vector of {0} numbers", m.rows()); }
    return tr("{0} × {1} numbers", m.rows(), m.cols());
}

/// Allowed distance from a mistaken answer, which has as many digits as the right answer, but may be much
/// larger.
double tolerance_of(const KnownMistake& mistake, const Task& task) {
    const Asked& asked = task.asked;
    if (is_exact(asked)) { return 1e-9; }
    const double right = asked.right.cwiseAbs().maxCoeff();
    if (task.exercise().absolute || right == 0.0 || mistake.answer.size() == 0) { return asked.tolerance; }
    return asked.tolerance * std::max(1.0, mistake.answer.cwiseAbs().maxCoeff() / right);
}

/// The nearest known mistake, if the given answer is within its tolerance, and clearly nearer to it than to
/// any other answer.
const KnownMistake* known_mistake(const Task& task, const MatrixX& given) {
    const Asked& asked = task.asked;
    const KnownMistake* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const KnownMistake& mistake : asked.mistakes) {
        const double apart = difference_from(mistake.answer, given, asked);
        if (apart > tolerance_of(mistake, task) || apart >= least) { continue; }
        least = apart;
        nearest = &mistake;
    }
    if (nearest == nullptr || least <= asked.tolerance) { return nearest; }
    const auto is_other = [&](const MatrixX& answer) {
        return difference_from(answer, given, asked) < kClearly * least &&
               difference_from(answer, nearest->answer, asked) > asked.tolerance;
    };
    const bool unclear =
        is_other(asked.right) || std::ranges::any_of(asked.mistakes, is_other, &KnownMistake::answer);
    return unclear ? nullptr : nearest;
}

/// Two terms that are missing or have the wrong sign, if exactly one such pair leads to the answer, and
/// neither the right answer nor a single mistake is as near.
std::optional<KnownMistake> mistake_in_two_terms(const Task& task, const MatrixX& given) {
    const Asked& asked = task.asked;
    std::vector<KnownMistake> pairs = mistakes_in_two_terms(task.variant);
    // with many pairs, a single number is near to one of them by chance
    if (given.size() == 1 && pairs.size() > kMostPairsOfNumber) { return std::nullopt; }
    std::erase_if(pairs, [&](const KnownMistake& pair) {
        return difference_from(pair.answer, given, asked) > asked.tolerance;
    });
    if (pairs.empty()) { return std::nullopt; }
    const auto is_as_near = [&](const MatrixX& answer) {
        return difference_from(answer, given, asked) < kClearly * asked.tolerance;
    };
    const bool unclear =
        is_as_near(asked.right) || std::ranges::any_of(asked.mistakes, is_as_near, &KnownMistake::answer) ||
        std::ranges::any_of(pairs, [&](const KnownMistake& p) { return p.says != pairs.front().says; });
    return unclear ? std::nullopt : std::optional<KnownMistake>(pairs.front());
}

/// Reports which entries are wrong; right ones earn a share of the points.
void tell_entries(const Asked& asked, const MatrixX& given, Judged& judged) {
    int wrong = 0;
    int right_and_nonzero = 0;
    int nonzero = 0;
    std::string places;
    for (Eigen::Index r = 0; r < given.rows(); ++r) {
        for (Eigen::Index c = 0; c < given.cols(); ++c) {
            const bool is_wrong = std::abs(given(r, c) - asked.right(r, c)) > asked.tolerance;
            const bool counts = std::abs(asked.right(r, c)) > asked.tolerance;
            nonzero += counts ? 1 : 0;
            right_and_nonzero += counts && !is_wrong ? 1 : 0;
            if (!is_wrong) { continue; }
            if (++wrong <= 12) { places += (wrong > 1 ? ", " : "") + name_of_entry(given, r, c); }
        }
    }
    judged.feedback.push_back(tr("{0} of {1} entries are wrong: {2}.", wrong, given.size(), places));
    if (nonzero > 0) { judged.share = kWorthOfEntries * right_and_nonzero / nonzero; }
}

void tell_unknown(const std::string& apart, Judged& judged) {
    judged.feedback.push_back(tr("This answer matches no known mistake. It is off by {0}.", apart));
}

void tell_how_far(const Asked& asked, const MatrixX& given, Judged& judged) {
    const double apart = difference_from(asked.right, given, asked);
    tell_unknown(number_text(apart, 3) + unit_behind(asked), judged);
    if (apart <= kRoundedEarly * asked.tolerance) {
        judged.feedback.emplace_back(tr("This is close. Was something rounded too early?"));
    }
    if (given.size() > 1 && !asked.sign_of_p) { tell_entries(asked, given, judged); }
}

void tell_mistake(const KnownMistake& mistake, const Asked& asked, const MatrixX& given, Judged& judged) {
    judged.mistake = mistake.name;
    judged.title = title_of(mistake);
    judged.slide = mistake.slide;
    judged.feedback.push_back(tr(mistake.says));
    if (!is_exact(asked)) {
        const std::string apart = number_text(difference_from(asked.right, given, asked), 3);
        judged.feedback.push_back(tr("Off by {0}.", apart + unit_behind(asked)));
    }
    if (!mistake.slide.empty()) {
        judged.feedback.push_back(tr("Look at {0}.", shown_slides(mistake.slide)));
    }
}

/// Feedback on an order that is not a known mistake.
void tell_order(const Task& task, const MatrixX& given, Judged& judged) {
    const MatrixX& right = task.asked.right;
    std::vector<double> numbers(given.data(), given.data() + given.size());
    std::ranges::sort(numbers);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (numbers[k] == static_cast<double>(k + 1)) { continue; }
        judged.feedback.push_back(tr("Each number from 1 to {0} must appear once.", numbers.size()));
        return;
    }
    Eigen::Index first = 0;
    while (first + 1 < right.rows() && given(first, 0) == right(first, 0)) { ++first; }
    judged.feedback.push_back(
        tr("The first wrong entry is at position {0}: number {1} does not belong there.", first + 1,
           number_text(given(first, 0), 3)));
}

/// Feedback on an answer that has to be exact and is not a known mistake.
void tell_what_differs(const Task& task, const MatrixX& given, Judged& judged) {
    if (task.exercise().kind == ExerciseKind::order) { return tell_order(task, given, judged); }
    if (task.exercise().kind == ExerciseKind::choose) {
        judged.feedback.push_back(
            tr("There is no such choice; expected a number from 1 to {0}.", task.shown.size()));
        return;
    }
    tell_unknown(number_text(difference_from(task.asked.right, given, task.asked), 3), judged);
}

/// "Y " as "y"
std::string in_lower_case(const std::string& text) {
    std::string lower;
    for (const char c : text) {
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r') { continue; }
        lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return lower;
}

/// Number, from 1, of the choice or item that is shown as the letter `word`; `word` itself if there is no
/// such choice.
std::string place_of_letter(const Task& task, const std::string& word) {
    const auto same = [&](const std::string& shown) {
        const bool letter = shown.size() == 1 && std::isalpha(static_cast<unsigned char>(shown.front())) != 0;
        return letter && in_lower_case(shown) == in_lower_case(word);
    };
    const auto found = std::ranges::find_if(task.shown, same);
    return found == task.shown.end() ? word : std::to_string(found - task.shown.begin() + 1);
}

/// Replaces letters by their places where components are chosen or sorted: "y" and "Y" are 2, "[x, Z, y]" is
/// a list.
std::string number_of_letter(const Task& task, const std::string& text) {
    const ExerciseKind kind = task.exercise().kind;
    if (kind != ExerciseKind::choose && kind != ExerciseKind::order) { return text; }
    const std::string whole = place_of_letter(task, text);
    if (kind == ExerciseKind::choose || whole != text) { return whole; }
    constexpr const char* kBetween = "[](),; \t\n\r";
    std::string numbers;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t word = std::min(text.find_first_not_of(kBetween, at), text.size());
        const std::size_t end = std::min(text.find_first_of(kBetween, word), text.size());
        numbers += text.substr(at, word - at) + place_of_letter(task, text.substr(word, end - word));
        at = end;
    }
    return numbers;
}

}  // namespace

std::string written(const MatrixX& value, int digits) {
    const auto row_text = [&](const auto& row) {
        std::string text = "[";
        for (Eigen::Index k = 0; k < row.size(); ++k) {
            text += (k > 0 ? ", " : "") + number_text(row(k), digits);
        }
        return text + "]";
    };
    if (value.size() == 1) { return number_text(value(0, 0), digits); }
    if (value.cols() == 1) { return row_text(value.col(0)); }
    std::string text = "[";
    for (Eigen::Index r = 0; r < value.rows(); ++r) { text += (r > 0 ? ", " : "") + row_text(value.row(r)); }
    return text + "]";
}

Handed right_value(const Task& task) { return {written(task.asked.right), {}}; }

std::vector<HandedMistake> mistaken_values(const Task& task) {
    std::vector<HandedMistake> all;
    for (const KnownMistake& mistake : task.asked.mistakes) {
        all.push_back({mistake.name, {written(mistake.answer), {}}});
    }
    return all;
}

std::string name_of_entry(const MatrixX& value, Eigen::Index row, Eigen::Index column) {
    const std::string line = std::to_string(row + 1);
    return value.cols() == 1 ? line : "(" + line + ", " + std::to_string(column + 1) + ")";
}

Judged judge_value(const Task& task, const Handed& handed) {
    const Asked& asked = task.asked;
    const GivenValue read =
        read_given_value(number_of_letter(task, handed.text), asked.unit, asked.right.size());
    if (!read.problem.empty()) { return not_understood(read.problem); }
    const MatrixX given = in_shape_of(asked.right, read.value);
    if (given.rows() != asked.right.rows() || given.cols() != asked.right.cols()) {
        const bool turned = given.rows() == asked.right.cols() && given.cols() == asked.right.rows();
        if (!turned) {
            return not_understood(tr("You wrote {0}; expected {1}.", shape_of(given), shape_of(asked.right)));
        }
        Judged judged = not_understood(
            tr("You wrote {0}; expected {1}. The answer is transposed.", shape_of(given),
               shape_of(asked.right)));
        judged.mistake = "transposed";
        judged.title = tr("transposed");
        return judged;
    }
    Judged judged;
    judged.right = is_right(asked.right, given, asked);
    if (judged.right) {
        judged.share = 1.0;
    } else if (const KnownMistake* const mistake = known_mistake(task, given)) {
        tell_mistake(*mistake, asked, given, judged);
    } else if (is_exact(asked)) {
        tell_what_differs(task, given, judged);
    } else if (const auto two = mistake_in_two_terms(task, given)) {
        tell_mistake(*two, asked, given, judged);
    } else {
        tell_how_far(asked, given, judged);
    }
    return judged;
}

}  // namespace jw
