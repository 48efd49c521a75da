#pragma once

#include "lessons/format/claim_keys.hpp"
#include "lessons/lesson/exercise.hpp"

/// Keys of exercises, in a lesson or in a file of their own.
namespace jw::format {

inline std::vector<std::string> allowed_aids() { return {"paper", "program"}; }
inline std::vector<std::string> nice_draws() { return {"direction", "p"}; }

/// Keys of the question, its scene and its draws.
inline constexpr std::array kTask{
    required({"ask", KeyKind::words, "the question"}),
    Key{"why", KeyKind::words, "shown with the answer"},
    counted("hints", KeyKind::list_of_words, "shown one after the other", 0, 10),
    Key{"scene", KeyKind::text, "a lesson file, relative to this one, or a lesson as text of several lines"},
    in_table("change", KeyKind::tables, "changes of the scene, before values are drawn", "change"),
    in_table("vary", KeyKind::tables, "values that differ from student to student", "draw"),
    Key{"condition_below", KeyKind::positive, "draws with a larger condition number are drawn again"}};

inline constexpr std::array kAnswer = joined(
    kMoment, kMeasured, kSubjectOfFormula,
    std::array{
        Key{"formula", KeyKind::formula, "answer: the value of a formula (docs/mathematics.md)"},
        Key{"given", KeyKind::texts, "symbols whose values are given"},
        one_of("count", "answer: how many there are", words_in<kCounts>),
        Key{"dropped", KeyKind::text, "answer: which of x, y, z is left out of \"hinge p1\""},
        spelled({"tolerance", KeyKind::positive, "largest deviation that counts as right"}, Spelling::any),
        Key{"absolute", KeyKind::flag, "true: the tolerance is absolute, not relative"},
        Key{"unit", KeyKind::text, "unit of the answer, shown beside it"},
        Key{"mistakes", KeyKind::texts, "known mistakes that are looked for; default all"},
        Key{"branch", KeyKind::texts, "experiments that lead to other right answers"},
        counted("cases", KeyKind::whole_number, "inputs on which a program is tried", 1, 1000),
        in_table("choices", KeyKind::tables, "answer: one of these sentences", "choice"),
        counted("items", KeyKind::list_of_words, "answer: these sentences in their right order", 3, 10),
        in_table("expect", KeyKind::tables, "hidden claims; default those of the scene", "claim"),
        counted("most", KeyKind::whole_number, "joints or experiments at most", 0, 100),
        in_table("spoil", KeyKind::tables, "changes that make the scene wrong", "change"),
        Key{"solution", KeyKind::text, "joints that solve it, as they stand in a lesson file"},
        Key{"do", KeyKind::texts, "experiments that solve it"}});

inline constexpr std::array kAlternative = joined(kTask, kAnswer);

inline constexpr std::array kExercise = joined(
    std::array{
        required({"name", KeyKind::text, "a short name of letters, digits, '-' and '_'"}),
        required({"title", KeyKind::words, "title of the exercise"}),
        Key{"source", KeyKind::text, "slides or pages of the book"},
        one_of("allowed", "what may be used", allowed_aids),
        Key{"points", KeyKind::positive, "points that it is worth; at most 1000"},
        Key{"lesson", KeyKind::text,
            "lesson of the catalogue that it belongs to, such as \"vectors/frames\""},
        required(one_of("kind", "what is handed in", words_in<kExerciseKinds>)),
        in_table("alternative", KeyKind::tables, "another question under the same name", "alternative")},
    kAlternative);

inline constexpr std::array kChange{
    required({"key", KeyKind::text, "what is changed, such as \"joint.B.axis\""}),
    Key{"value", KeyKind::any, "its new value; without one it is taken out"}};

inline constexpr std::array kDraw{
    Key{"key", KeyKind::text, "what is drawn, such as \"joint.B.axis\""},
    Key{"keys", KeyKind::texts, "instead: several that get the same value"},
    Key{"values", KeyKind::any, "one of this list"},
    Key{"from", KeyKind::number, "instead: smallest number"},
    Key{"to", KeyKind::number, "largest number"},
    Key{"step", KeyKind::positive, "between numbers; default 1"},
    counted("count", KeyKind::whole_number, "numbers of a list; default a number alone", 1, 12),
    one_of("nice", "instead: a direction, or Euler parameters, of small fractions", nice_draws)};

inline constexpr std::array kChoice{
    required({"text", KeyKind::words, "the words of the choice"}),
    Key{"why", KeyKind::words, "why it is right, or wrong"},
    Key{"right", KeyKind::flag, "true for the right one"}};

inline constexpr std::array kExerciseTables{
    KeyTable{"exercise", kExercise}, KeyTable{"alternative", kAlternative}, KeyTable{"change", kChange},
    KeyTable{"draw", kDraw}, KeyTable{"choice", kChoice}};

inline constexpr std::array kExerciseFileKeys{
    required(counted("format", KeyKind::whole_number, "version of the format; the first key", 1, 1)),
    required({"title", KeyKind::words, "title of all exercises"}),
    Key{"source", KeyKind::text, "slides or pages of the book"},
    required(in_table("exercise", KeyKind::tables, "exercises, with answers that are judged", "exercise"))};
/// Table of a file with exercises alone.
inline constexpr KeyTable kExerciseFile{"exercises", kExerciseFileKeys};

}  // namespace jw::format
