#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/exercises/task.hpp"

/// Kinds of exercises: what is handed in, what is right, and how it is judged.
namespace jw {

/// What a student hands in, as text.
struct Handed {
    std::string text;  ///< numbers; the output of a program; a lesson file; for experiments, the lesson that
                       ///< they led to (if it is empty, they are carried out)
    std::vector<std::string> list;  ///< experiments
};

/// A known mistake as it would be handed in.
struct HandedMistake {
    std::string name;
    Handed handed;
};

struct Judged {
    bool understood = true;
    bool right = false;
    double share = 0.0;                 ///< of the points, 0 to 1
    std::string mistake;                ///< name of a known one, or nothing
    std::string title;                  ///< of the mistake, in a few words
    std::string slide;                  ///< where it is explained, may be empty
    std::vector<std::string> feedback;  ///< sentences
};

/// A kind is an entry of this table.
struct KindOfExercise {
    ExerciseKind kind;
    const char* hand_in;  ///< how it is handed in, a sentence for the sheet
    Handed (*right)(const Task& task);
    std::vector<HandedMistake> (*mistakes)(const Task& task);
    Judged (*judge)(const Task& task, const Handed& handed);
    const char* file;  ///< ending of the file that is handed in; empty: the answer is in answers.toml
};
const KindOfExercise& kind_of(ExerciseKind kind);

/// True if the answer is a quantity in numbers, so that it has a tolerance.
bool is_measured(ExerciseKind kind);
/// True if claims of a scene tell whether the answer is right.
bool is_judged_by_claims(ExerciseKind kind);

/// The judgement of an answer that was not understood.
Judged not_understood(std::string why);

/// How exact an answer in numbers has to be, as a sentence that does not tell the answer: "Four significant
/// digits in each number are enough.", "It may be off by 0.01 m."; empty if it is exact or not a number.
std::string accuracy_text(const Task& task);

/// Numbers as a student would write them: "[1, 2, 3]".
std::string written(const MatrixX& value, int digits = 9);

/// `given` with a row as a column where a column is expected, and the reverse; matrices stay as they are.
MatrixX in_shape_of(const MatrixX& right, const MatrixX& given);

/// Name of an entry: "2" in a column, "(2, 1)" in any other matrix.
std::string name_of_entry(const MatrixX& value, Eigen::Index row, Eigen::Index column);

// the parts of the table
Handed right_value(const Task& task);
std::vector<HandedMistake> mistaken_values(const Task& task);
Judged judge_value(const Task& task, const Handed& handed);

Handed right_output(const Task& task);
std::vector<HandedMistake> mistaken_outputs(const Task& task);
Judged judge_output(const Task& task, const Handed& handed);
/// What a program reads on its standard input.
std::string program_input(const Task& task);
/// How the answers of a program are judged, as a sentence.
std::string judging_of_programs(const Task& task);
/// Names of the inputs of a program: "s_i_local".
std::vector<std::string> input_names(const Exercise& exercise);

/// The lesson file that is handed out: for repair with its faults, for build without the joints.
std::string handed_out(const Task& task);
/// True if the file as it is handed out meets all claims, so that there is nothing to do.
bool is_solved_already(const Task& task);
/// Sentence about the keys that spoil the scene of a `repair`: its solution for people.
std::string spoiled_text(const Exercise& exercise);
Handed right_repair(const Task& task);
std::vector<HandedMistake> mistaken_repairs(const Task& task);
Judged judge_repair(const Task& task, const Handed& handed);
Handed right_build(const Task& task);
std::vector<HandedMistake> mistaken_builds(const Task& task);
Judged judge_build(const Task& task, const Handed& handed);
Handed right_experiment(const Task& task);
std::vector<HandedMistake> mistaken_experiments(const Task& task);
Judged judge_experiment(const Task& task, const Handed& handed);

}  // namespace jw
