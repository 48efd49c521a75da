#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "app/exercises/kinds.hpp"
#include "lessons/exercise/handed_in.hpp"

/// Grades what one student hands in.
namespace jw {

/// An exercise with what makes its tasks.
struct CourseExercise {
    const Exercise* exercise = nullptr;
    TaskMaker maker;
};

/// Exercises of a course, made ready once. `exercises` must outlive it.
struct ReadyCourse {
    std::string secret;
    std::vector<CourseExercise> exercises;
    std::string digest;   ///< of everything that grades depend on besides what is handed in
    std::string problem;  ///< an exercise of which no task can be made
};
ReadyCourse ready_course(std::string secret, const std::vector<Exercise>& exercises);

/// The task of a student.
Task task_of(const ReadyCourse& course, const CourseExercise& exercise, const std::string& student);

struct ExerciseGrade {
    std::string name;
    std::string title;
    double points = 0.0;  ///< that there are
    double earned = 0.0;
    bool handed_in = false;
    bool not_run = false;  ///< a program that this machine cannot run
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
/// NAME.cpp ...). Nothing outside the folder is read, links are not followed, programs run in a sandbox or
/// not at all.
ExerciseGrade grade_exercise(
    const ReadyCourse& course, const CourseExercise& entry, const Submission& submission);

/// Longest time that grading an exercise takes on a busy machine [s]: of a program with compiling and run.
double longest_grading(const Exercise& exercise);

/// Runs a program in the sandbox and judges what it writes; why it was not run is said in the feedback.
/// @param stop  kills the program: its answers are not wanted any more
Judged judge_program_file(
    const Task& task, const std::filesystem::path& file, const std::stop_token& stop = {});

/// Digest of all that a folder hands in; empty if it cannot be read.
std::string digest_of(const std::filesystem::path& folder);

/// A grade as JSON and back.
std::string json_text(const Grade& grade);
std::string json_text(const ExerciseGrade& grade);
/// @return false if it is none
bool read_grade(const std::string& json, Grade& grade);
bool read_grade(const std::string& json, ExerciseGrade& grade);

}  // namespace jw
