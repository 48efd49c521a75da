#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lessons/exercise/exercise.hpp"

/// Files around exercises: the key of a course, the answers of a student, the list of a class.
namespace jw {

/// Name of the file with the answers in a student's folder.
inline constexpr const char* kAnswersFile = "answers.toml";

/// What draws the numbers of a course.
struct CourseKey {
    std::string secret;
    std::vector<std::filesystem::path> exercises;  ///< files, by the folder of the key
    std::string problem;  ///< everything that is wrong with the file; empty if nothing is
};
CourseKey read_course_key(const std::filesystem::path& path);

/// An answer as it was written: a text, or a list of texts.
struct GivenText {
    std::string text;
    std::vector<std::string> list;
};

/// What a student answers.
struct HandedIn {
    std::string student;
    std::map<std::string, GivenText> answers;  ///< by the names of exercises
    std::string problem;                       ///< why the file cannot be read; empty if it can
};
/// Reads the text of answers.toml: a table [answers], whose values are texts, numbers or lists of them.
HandedIn read_answers_text(std::string text);

/// The first column of a list in CSV, without its head "student", "id" or the like.
struct Roster {
    std::vector<std::string> students;
    std::string problem;
};
Roster read_roster(const std::filesystem::path& path);

/// Why a student cannot be called so; empty if it is fine: names of folders are made of it.
std::string fault_of_student(const std::string& student);

}  // namespace jw
