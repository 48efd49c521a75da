#pragma once

#include "core/quantity/names.hpp"
#include "lessons/format/key.hpp"
#include "lessons/lesson/enum_words.hpp"

/// Keys of claims, questions, trials and texts of steps.
namespace jw::format {

/// Largest number of rows, columns, ... that a claim can give.
inline constexpr int kMostCounted = 100000;

/// Primitives of all types of joints, once each.
std::vector<std::string> words_of_roles();
inline std::vector<std::string> motions_of_time() { return {"motion", "dynamics"}; }

inline constexpr std::array kMoment{
    Key{"after", KeyKind::text, "when: this joint or driver has been added"},
    Key{"at_s", KeyKind::number, "when: a time of the motion [s]"},
    one_of("of", "which motion 'at_s' is a time of", motions_of_time),
    Key{"at_rest", KeyKind::flag, "when: the equilibrium to which the forces lead"},
    Key{"as_given", KeyKind::flag, "when: the start pose, nothing assembled"},
    Key{"any_state", KeyKind::flag, "when: random states; for formulas"}};

/// Keys named by the words of enumerators.
template <const auto& entries, class Make>
constexpr auto keys_of(Make&& make) {
    std::array<Key, entries.size()> keys{};
    std::ranges::transform(entries, keys.begin(), make);
    return keys;
}
inline constexpr std::array kFacts = joined(
    keys_of<kCounts>([](const EnumWord<Count>& count) {
        const int least = count.value == Count::mobility_by_counting ? -kMostCounted : 0;
        return counted(count.word, KeyKind::whole_number, "how many there are", least, kMostCounted);
    }),
    keys_of<kBounds>([](const EnumWord<Bound>& bound) {
        return Key{bound.word, KeyKind::positive, "a bound of the residual or of the condition number"};
    }),
    keys_of<kVerdicts>([](const EnumWord<Verdict>& verdict) {
        return Key{verdict.word, KeyKind::flag, "whether it is so"};
    }),
    std::array{
        Key{"dropped", KeyKind::text, "the equation that a joint leaves out, such as \"hinge p1 z\""}});

inline constexpr std::array kSubjectOfFormula{
    Key{"joint", KeyKind::text, "joint that the formula is about"},
    one_of("primitive", "primitive of the joint that it is about", words_of_roles),
    Key{"body", KeyKind::text, "body that the formula is about"},
    one_of("coordinates", "choice of coordinates of a formula of the system", words_in<kChoices>),
    Key{"where", KeyKind::texts, "definitions of further symbols"}};

inline constexpr std::array kMeasured{
    Key{"quantity", KeyKind::text, "what is measured, such as \"crank.x\""},
    counted("derivative", KeyKind::whole_number, "1 for its rate, 2 for its acceleration", 0, 2),
    Key{"point", KeyKind::vector, "the point of \"crank.point.x\", local", "m"}};

inline constexpr std::array kClaim = joined(
    std::array{Key{"why", KeyKind::words, "reason, shown if it fails"}}, kMoment, kFacts, kMeasured,
    std::array{
        spelled({"value", KeyKind::number, "value of the quantity"}, Spelling::any),
        spelled({"tolerance", KeyKind::positive, "largest allowed deviation"}, Spelling::any),
        Key{"formula", KeyKind::formula, "equation that holds (docs/mathematics.md)"},
        Key{"holds", KeyKind::flag, "false: the formula is a misprint"}},
    kSubjectOfFormula);

inline constexpr std::array kQuestion{
    required({"at", KeyKind::text, "\"bodies\", \"motion\", a joint or a driver, before which it is asked"}),
    required({"ask", KeyKind::words, "the question"}),
    Key{"why", KeyKind::words, "shown with the answer"},
    one_of("count", "answer: how many there are once the step is done", words_in<kCounts>),
    Key{"dropped", KeyKind::text, "answer: which of x, y, z is left out of \"hinge p1\""},
    Key{"quantity", KeyKind::text, "answer: a quantity at a time of the motion"},
    Key{"at_s", KeyKind::number, "time of the quantity or pose [s]"},
    Key{"point", KeyKind::vector, "the point of \"crank.point.x\", local", "m"},
    counted("choices", KeyKind::list_of_words, "answer: one of these sentences", 2, 8),
    counted("answer", KeyKind::whole_number, "number of the right choice, from 1", 1, 8),
    one_of("click", "answer: a thing of this kind, clicked or named", words_in<kThings>),
    Key{"right", KeyKind::texts, "names of the things that are right, such as [\"hinge s_i\"]"},
    one_of("rows", "instead: rows that are found once the step is done", words_in<kRowsFound>),
    Key{"pose", KeyKind::text, "answer: the pose of this body, to which it is dragged"},
    spelled({"tolerance", KeyKind::positive, "largest deviation that counts as right"}, Spelling::any)};

inline constexpr std::array kStep{
    Key{"at", KeyKind::text, "\"bodies\", \"motion\", a joint or a driver"},
    Key{"at_s", KeyKind::number, "instead: a time from which it is shown [s]"},
    required({"text", KeyKind::words, "the words to show"})};

inline constexpr std::array kTrial{
    required({"text", KeyKind::words, "what to try, and what to look at"}),
    required(counted("do", KeyKind::texts, "experiments in the form that --try takes", 1, 20)),
    Key{"breaks", KeyKind::flag, "true: the experiments break the scene on purpose"}};

inline constexpr std::array kClaimTables{
    KeyTable{"step", kStep}, KeyTable{"question", kQuestion}, KeyTable{"trial", kTrial},
    KeyTable{"claim", kClaim}};

}  // namespace jw::format
