#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lessons/lesson/exercise.hpp"

/// Files around exercises: the key of a course, the answers of a student, the list of a class, and what a
/// student has solved.
namespace jw {

/// Name of the file with the answers in a student's folder.
inline constexpr const char* kAnswersFile = "answers.toml";

/// The secret from which the numbers of a course are drawn, and the exercises of the course.
struct CourseKey {
    std::string secret;
    std::vector<std::filesystem::path> exercises;  ///< files; the key names them relative to its folder
    std::string problem;                           ///< all mistakes in the file; empty if there are none
};
CourseKey read_course_key(const std::filesystem::path& path);

/// An answer as it was written: a text, or a list of texts.
struct GivenText {
    std::string text;
    std::vector<std::string> list;
};

/// The answers of one student.
struct HandedIn {
    std::string student;
    std::map<std::string, GivenText> answers;  ///< by the names of exercises
    std::string problem;                       ///< why the file cannot be read; empty if it can
};
/// Reads the text of answers.toml: a table [answers], whose values are texts, numbers or lists of them.
HandedIn read_answers_text(std::string text);

/// The first column of a CSV list, without its header "student", "id" or similar.
struct Roster {
    std::vector<std::string> students;
    std::string problem;
};
Roster read_roster(const std::filesystem::path& path);

/// Why this name of a student is not valid, as folders are named after students; empty if it is valid.
std::string fault_of_student(const std::string& student);

/// Results of an exercise so far.
struct ExerciseRecord {
    int tried = 0;    ///< answers that were judged
    int solved = 0;   ///< variants answered correctly before their solution was shown
    int streak = 0;   ///< how many of these in a row, up to now
    int variant = 0;  ///< number of the variant that comes next

    bool operator==(const ExerciseRecord&) const = default;
};
/// By the keys of exercises.
using ExerciseRecords = std::map<std::string, ExerciseRecord>;

/// The text of the file: the records and nothing else.
std::string progress_text(const ExerciseRecords& records);

struct ProgressRead {
    ExerciseRecords records;
    std::string problem;  ///< why the text is not a progress file, as part of a sentence; empty if it is
};
ProgressRead read_progress(std::string text);

}  // namespace jw
