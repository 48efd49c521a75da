#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "app/exercises/kinds.hpp"
#include "lessons/exercise/handed_in.hpp"

/// Grades the submission of one student.
namespace jw {

/// An exercise, with the maker of its tasks.
struct CourseExercise {
    const Exercise* exercise = nullptr;
    TaskMaker maker;
};

/// Exercises of a course, prepared once. `exercises` must outlive it.
struct ReadyCourse {
    std::string secret;
    std::vector<CourseExercise> exercises;
    std::string digest;   ///< of everything that grades depend on, except what is handed in
    std::string problem;  ///< exercises of which no task can be made
};
ReadyCourse ready_course(std::string secret, const std::vector<Exercise>& exercises);

/// The task of a student.
Task task_of(const ReadyCourse& course, const CourseExercise& exercise, const std::string& student);

struct ExerciseGrade {
    std::string name;
    std::string title;
    double points = 0.0;  ///< that can be earned
    double earned = 0.0;
    bool handed_in = false;
    bool not_run = false;  ///< a program that cannot be run on this machine
    Judged judged;
};

struct Grade {
    std::string submission;  ///< name of the folder
    std::string student;     ///< empty if it is not known
    std::string problem;     ///< why nothing was graded; empty if it was
    std::vector<ExerciseGrade> exercises;

    double points() const;
    double earned() const;
};

/// A folder that was handed in, with its answers.toml read.
struct Submission {
    std::filesystem::path folder;
    HandedIn handed;  ///< `problem`: why nothing of the folder is graded
};
Submission read_submission(const std::filesystem::path& folder);

/// All exercises of the course with nothing handed in.
Grade empty_grade(const ReadyCourse& course, const Submission& submission);

/// Grades one exercise of a submission: its answer, its lesson file NAME.toml or its program (NAME.py,
/// NAME.cpp ...). Nothing outside the folder is read, links are not followed, and programs run only in a
/// sandbox.
ExerciseGrade grade_exercise(
    const ReadyCourse& course, const CourseExercise& entry, const Submission& submission);

/// Longest time that grading an exercise takes on a busy machine [s]; for a program, compiling and running
/// included.
double longest_grading(const Exercise& exercise);

/// Runs a program in the sandbox and judges its output; the feedback says why it was not run.
/// @param stop  kills the program if its answers are not wanted any more
Judged judge_program_file(
    const Task& task, const std::filesystem::path& file, const std::stop_token& stop = {});

/// Digest of everything in a submitted folder; empty if it cannot be read.
std::string digest_of(const std::filesystem::path& folder);

/// A grade as JSON and back.
std::string json_text(const Grade& grade);
std::string json_text(const ExerciseGrade& grade);
/// @return false if the text is not a grade
bool read_grade(const std::string& json, Grade& grade);
bool read_grade(const std::string& json, ExerciseGrade& grade);

}  // namespace jw
