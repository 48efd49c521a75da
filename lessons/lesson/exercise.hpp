#pragma once

#include <string>
#include <vector>

#include "lessons/diagnostics/text_place.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/text/text.hpp"

/// Exercises as data: what an exercise file says. docs/exercises.md describes the file.
namespace jw {

/// What a student hands in, and how it is judged (app/exercises/kinds.hpp has one entry for each).
enum class ExerciseKind {
    number,
    vector,
    matrix,
    pose,        ///< r and p of a body, 7 numbers; p and −p are the same
    choose,      ///< the number of a choice, from 1
    order,       ///< the numbers of the items in their right order
    code,        ///< a program that computes the answer for given inputs
    repair,      ///< a lesson file whose fault has been corrected
    build,       ///< a lesson file to which joints are added
    experiment,  ///< a list of experiments, as `jointwise try --try` takes them
};

inline constexpr std::array kExerciseKinds{
    EnumWord<ExerciseKind>{ExerciseKind::number, "number", tr_later("a number")},
    EnumWord<ExerciseKind>{ExerciseKind::vector, "vector", tr_later("a vector")},
    EnumWord<ExerciseKind>{ExerciseKind::matrix, "matrix", tr_later("a matrix")},
    EnumWord<ExerciseKind>{ExerciseKind::pose, "pose", tr_later("r and p of a body")},
    EnumWord<ExerciseKind>{ExerciseKind::choose, "choose", tr_later("one of the choices")},
    EnumWord<ExerciseKind>{ExerciseKind::order, "order", tr_later("the right order")},
    EnumWord<ExerciseKind>{ExerciseKind::code, "code", tr_later("a program")},
    EnumWord<ExerciseKind>{ExerciseKind::repair, "repair", tr_later("a repaired lesson file")},
    EnumWord<ExerciseKind>{ExerciseKind::build, "build", tr_later("a lesson file with joints added")},
    EnumWord<ExerciseKind>{ExerciseKind::experiment, "experiment", tr_later("a list of experiments")}};

/// Aids that are allowed for an exercise.
enum class Allowed { paper, program };

/// A parameter of the scene that differs from student to student.
struct Draw {
    enum class Kind {
        values,            ///< one of a list
        numbers,           ///< from, from + step, ... to; several for a vector, not all zero
        direction,         ///< a unit vector with rational components, such as (2, 3, 6)/7
        euler_parameters,  ///< p with rational components, such as (1, 2, 2, 4)/5
    };
    Kind kind = Kind::values;
    std::vector<std::string> keys;    ///< "body.dial.rotation.angle_deg": all get the same value
    std::vector<std::string> values;  ///< as TOML
    double from = 0.0;
    double to = 0.0;
    double step = 1.0;
    int count = 1;  ///< 1: a number, else the length of a vector
};

/// A change of a scene's file.
struct SceneEdit {
    std::string key;    ///< "joint.B.axis"; "joint.B" where a table is taken out
    std::string value;  ///< as TOML; empty: the key, or the table, is taken out

    bool operator==(const SceneEdit&) const = default;
};

/// One of several sentences to choose from.
struct ExerciseChoice {
    Text text;
    Text why;  ///< why it is wrong, or right
};

struct Exercise {
    std::string name;  ///< letters, digits, '-' and '_': it becomes the name of files
    Text title;
    ExerciseKind kind = ExerciseKind::number;
    std::string source;  ///< slides or pages
    std::string lesson;  ///< lesson that it belongs to, "vectors/frames"; may be empty
    Text ask;            ///< with formulas between dollar signs, like `why` and `hints`
    Text why;            ///< shown with the solution
    std::vector<Text> hints;
    Allowed allowed = Allowed::paper;
    double points = 1.0;
    SourceSpan span;  ///< of its table

    std::string scene;       ///< the lesson as it was written, TOML
    std::string scene_name;  ///< of its file, for messages
    std::vector<Draw> vary;
    double condition_below = 1e3;  ///< limit of largest / smallest singular value of a variant

    /// What is asked, as one claim in TOML whose value is ignored; empty for choices, order, repair, build
    /// and experiment. In a formula, the first side is what is asked for, and the last side computes it.
    std::string asked;
    std::string formula;              ///< the equation; empty if the question is not a formula
    std::vector<std::string> where;   ///< its definitions
    std::vector<std::string> given;   ///< symbols whose values are given, or are inputs of a program
    std::string unit;                 ///< unit of the answer, may be empty
    double tolerance = 1e-3;          ///< relative to the largest entry; for a quantity absolute, in its unit
    bool absolute = false;            ///< the tolerance is not relative
    std::vector<std::string> only;    ///< mistakes that are looked for, by name; empty: all
    std::vector<std::string> branch;  ///< experiments that lead to the other way to assemble the scene
    int cases = 24;                   ///< code: number of states in which the program is tested

    std::vector<ExerciseChoice> choices;  ///< empty where the choices are computed from a formula
    int right_choice = 0;
    std::vector<Text> items;  ///< order: in their right order

    std::string expect;             ///< hidden claims, [[expect]] in TOML; empty: those of the scene
    std::vector<SceneEdit> spoil;   ///< repair: edits that put the fault into the scene
    std::string solution;           ///< build: TOML that is added to the scene
    std::vector<std::string> does;  ///< experiment: a list of experiments that solves it
    int most = 1;                   ///< repair: values to change; build: joints; experiment: experiments

    /// Other questions, each a complete exercise with the same name, title and kind. A student gets this one
    /// or one of these.
    std::vector<Exercise> alternatives;
};

}  // namespace jw
