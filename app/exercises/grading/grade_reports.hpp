#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/exercises/grading/grade.hpp"
#include "app/exercises/slide_lessons.hpp"
#include "lessons/lesson/exercise.hpp"

/// Grades for people and for other programs.
namespace jw {

/// The grade of one student, for a terminal.
std::string grade_text(const Grade& grade);
/// A table: a line for each student, a column for each exercise.
std::string grades_csv(const std::vector<Grade>& grades);
/// A test case for each exercise of each student.
std::string grades_junit(const std::vector<Grade>& grades);
/// results.json of a Gradescope autograder.
std::string gradescope_json(const Grade& grade);
/// All grades in one list.
std::string grades_json(const std::vector<Grade>& grades);

/// Lessons that explain the mistakes of a class, for the page about the class.
class AnsweringLessons {
public:
    /// Both arguments must outlive this.
    AnsweringLessons(const std::vector<SlideLesson>& lessons, const std::vector<Exercise>& exercises)
        : lessons_(&lessons), exercises_(&exercises) {}

    /// The lesson of the slide that a mistake names, else the lesson that its exercise belongs to, else the
    /// lesson of the exercise's source; nullptr if there is none.
    const SlideLesson* find(const std::string& exercise, const std::string& slide) const;

private:
    const std::vector<SlideLesson>* lessons_;
    const std::vector<Exercise>* exercises_;
};

/// A page about the class: points, how often each mistake was made in each exercise, and the lessons that
/// explain the mistakes.
std::string class_report_html(
    const std::vector<Grade>& grades, const std::string& title, const AnsweringLessons& lessons);

/// Programs that were handed in and cannot be run on this machine.
struct ProgramsNotRun {
    int count = 0;
    std::string reason;  ///< of the first one

    /// A sentence about all of these programs.
    std::string text() const;
};
ProgramsNotRun programs_not_run(const std::vector<Grade>& grades);

/// Results of a class in an exercise.
struct ExerciseCount {
    std::string name;
    std::string title;
    int right = 0;
    int partly = 0;
    int wrong = 0;
    int not_understood = 0;
    int not_run = 0;
    int missing = 0;
    struct Mistake {
        std::string title;
        std::string slide;
        int count = 0;
    };
    std::vector<Mistake> mistakes;  ///< the most frequent first
};
std::vector<ExerciseCount> counts_of(const std::vector<Grade>& grades);

}  // namespace jw
