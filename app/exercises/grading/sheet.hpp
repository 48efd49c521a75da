#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/exercises/grading/grade.hpp"

/// Sheets of exercises for students.
namespace jw {

/// Draws the scene of a lesson as PNG. If there is no such function, sheets have no figures.
/// @param as_given  the pose of the file, not assembled
using FigureOf = std::function<std::vector<std::uint8_t>(const Lesson& lesson, bool as_given)>;

/// An exercise on a sheet. Texts have formulas between dollar signs.
struct SheetEntry {
    Task task;
    std::string number;              ///< "3"
    std::vector<std::string> given;  ///< "$\mathbf{s}_i = ...$"
    std::string file;                ///< handed out with the sheet, "NAME.toml"; empty: none
    std::string file_text;
    std::vector<std::uint8_t> figure;  ///< PNG
    std::string template_line;         ///< in answers.toml; empty if a file is handed in
};

/// Folder of a sheet for starter programs: beside answers.toml, several of them would be handed in.
inline constexpr const char* kStartersFolder = "starters";

struct Sheet {
    std::string title;
    std::string student;
    std::vector<SheetEntry> entries;
    std::string problem;  ///< exercises that cannot be set for this student
};
Sheet sheet_of(
    const ReadyCourse& course, const std::string& student, const std::string& title, const FigureOf& figure);

/// @param solution  with the right answers
std::string sheet_markdown(const Sheet& sheet, bool solution);
/// The whole sheet as one page that needs no other file.
std::string sheet_html(const Sheet& sheet, bool solution);
/// The file that a student fills in; with the right answers if `solution`.
std::string answers_template(const Sheet& sheet, bool solution);

/// Questions for Moodle in its XML format: for each sheet, one for each exercise that a quiz can ask. Every
/// known mistake is an answer with its feedback.
std::string moodle_xml(const std::vector<Sheet>& sheets, const std::string& category);
/// Names of exercises that no quiz can ask.
std::vector<std::string> not_for_quizzes(const Sheet& sheet);

/// Student named on a sheet: "ann", or "ann, solutions".
std::string student_text(const Sheet& sheet, bool solution);
/// Title and feedback of a mistake, for the sheet of solutions.
std::string mistake_text(const KnownMistake& mistake);
/// "The answer is in m."; empty if it has no unit.
std::string unit_text_of(const SheetEntry& entry);
/// How the exercise is handed in.
std::string hand_in_text(const SheetEntry& entry);
/// How a right answer is written on the sheet of solutions.
std::string solution_text(const SheetEntry& entry);
/// "2 points", with the source of the exercise.
std::string head_text(const SheetEntry& entry);

}  // namespace jw
