#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lessons/lesson/exercise.hpp"

/// Files around exercises: the key of a course, the answers of a student, the list of a class.
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

}  // namespace jw
