#include "app/exercises/grading/grade.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "app/exercises/grading/plain_file.hpp"
#include "app/exercises/random.hpp"
#include "app/exercises/run/languages.hpp"
#include "app/exercises/run/student_file.hpp"
#include "lessons/exercise/handed_in.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestHandedIn = 200000;
/// Shares are rounded to this, so that 2/3 of 3 points are 2.
constexpr double kFinest = 1e-6;

Judged not_judged(std::string why) {
    Judged judged;
    judged.understood = false;
    judged.feedback.push_back(std::move(why));
    return judged;
}

/// Runs the program of the student and judges what it writes.
Judged judge_program(const Task& task, const KindOfExercise& kind, const exercises::StudentProgram& program) {
    const exercises::ReadyProgram ready = exercises::make_ready(program);
    if (ready.outcome != exercises::ProgramResult::Outcome::ran) { return not_judged(ready.message); }
    const exercises::SandboxLimits limits;
    const exercises::ProgramResult result = exercises::run_ready(ready, program_input(task), limits);
    if (result.outcome != exercises::ProgramResult::Outcome::ran) { return not_judged(result.message); }
    const std::string fault = exercises::fault_of(result.run, limits);
    if (!fault.empty()) { return not_judged("The program " + fault); }
    return kind.judge(task, {result.run.out, {}});
}

/// What the folder has for an exercise, judged; the grade stays empty if there is nothing.
void grade_exercise(const Task& task, const fs::path& folder, const HandedIn& handed, ExerciseGrade& grade) {
    const KindOfExercise& kind = kind_of(task.exercise().kind);
    const std::string ending = kind.file;
    if (ending == "program") {
        const exercises::ProgramSearch found = exercises::find_program(folder.string(), grade.name);
        if (found.outcome == exercises::ProgramSearch::Outcome::absent) { return; }
        grade.handed_in = true;
        grade.judged = found.outcome == exercises::ProgramSearch::Outcome::found
                           ? judge_program(task, kind, found.program)
                           : not_judged(found.reason);
        return;
    }
    if (!ending.empty()) {
        const PlainFile file = read_plain_file(folder / (grade.name + ending), kLargestHandedIn);
        if (file.absent) { return; }
        grade.handed_in = true;
        grade.judged = file.problem.empty() ? kind.judge(task, {file.text, {}}) : not_judged(file.problem);
        return;
    }
    const auto answer = handed.answers.find(grade.name);
    if (answer == handed.answers.end()) { return; }
    const GivenText& given = answer->second;
    const bool empty = given.text.find_first_not_of(" \n\t\r") == std::string::npos;
    if (empty && given.list.empty()) { return; }
    if (given.text == "[]") { return; }
    grade.handed_in = true;
    const bool of_lists = task.exercise().kind == ExerciseKind::experiment;
    const std::vector<std::string> list = given.list.empty() ? std::vector{given.text} : given.list;
    grade.judged = kind.judge(task, of_lists ? Handed{{}, list} : Handed{given.text, {}});
}

/// Everything that a grade depends on, each part with its length, so that no two exercises have the same.
std::string text_of(const Exercise& e) {
    std::ostringstream text;
    const auto add = [&](const auto& part) {
        std::ostringstream one;
        one.precision(17);
        one << part;
        text << one.str().size() << ':' << one.str();
    };
    const auto add_all = [&](const auto& parts) {
        add(parts.size());
        for (const std::string& part : parts) { add(part); }
    };
    add(static_cast<int>(e.kind));
    add(e.title);
    add_all(std::array{e.name, e.scene, e.asked, e.formula, e.unit, e.expect, e.solution});
    for (const auto& parts : {e.where, e.given, e.only, e.branch, e.does}) { add_all(parts); }
    add_all(e.items);
    for (const double number : {e.points, e.condition_below, e.tolerance}) { add(number); }
    for (const int number : {e.absolute ? 1 : 0, e.cases, e.right_choice, e.most}) { add(number); }
    for (const Draw& draw : e.vary) {
        add(static_cast<int>(draw.kind));
        add_all(draw.keys);
        add_all(draw.values);
        for (const double number : {draw.from, draw.to, draw.step}) { add(number); }
        add(draw.count);
    }
    for (const ExerciseChoice& choice : e.choices) { add_all(std::array{choice.text, choice.why}); }
    for (const SceneEdit& edit : e.spoil) { add_all(std::array{edit.key, edit.value}); }
    return text.str();
}

/// Languages of programs that run here: a grade without a sandbox does not hold where there is one.
std::string means_of_running() {
    std::string text = exercises::sandbox_availability().available ? "sandbox" : "no sandbox";
    for (const exercises::Language& language : exercises::kLanguages) {
        text += exercises::missing_tool(language);
    }
    return text;
}

}  // namespace

Judged judge_program_file(const Task& task, const fs::path& file) {
    const exercises::ProgramSearch found = exercises::read_program(file.string());
    if (found.outcome == exercises::ProgramSearch::Outcome::found) {
        return judge_program(task, kind_of(task.exercise().kind), found.program);
    }
    return not_judged(
        found.reason.empty() ? "There is no file '" + file.string() + "'; expected a program."
                             : found.reason);
}

ReadyCourse ready_course(std::string secret, const std::vector<Exercise>& exercises) {
    ReadyCourse course;
    course.secret = std::move(secret);
    std::uint64_t digest = seed_of(means_of_running(), JW_VERSION, course.secret);
    for (const Exercise& exercise : exercises) {
        course.exercises.push_back({&exercise, TaskMaker(exercise)});
        const std::string& problem = course.exercises.back().maker.problem();
        if (!problem.empty()) { course.problem += "exercise " + exercise.name + ": " + problem + "\n"; }
        digest = seed_of(std::to_string(digest), exercise.name, text_of(exercise));
    }
    course.digest = std::to_string(digest);
    return course;
}

Task task_of(const ReadyCourse& course, const CourseExercise& exercise, const std::string& student) {
    return exercise.maker.make(seed_of(course.secret, student, exercise.exercise->name));
}

double Grade::points() const {
    double sum = 0.0;
    for (const ExerciseGrade& e : exercises) { sum += e.points; }
    return sum;
}

double Grade::earned() const {
    double sum = 0.0;
    for (const ExerciseGrade& e : exercises) { sum += e.earned; }
    return sum;
}

Grade grade_submission(const ReadyCourse& course, const fs::path& folder) {
    Grade grade;
    grade.submission = folder.filename().string();
    std::error_code error;
    const bool link = fs::is_symlink(folder, error);
    const PlainFile answers = link ? PlainFile{} : read_plain_file(folder / kAnswersFile, kLargestHandedIn);
    grade.problem = link ? "The submission is a symbolic link; expected a folder." : answers.problem;
    HandedIn handed;
    if (grade.problem.empty()) {
        handed = read_answers_text(answers.text);
        grade.problem = handed.problem;
    }
    grade.student = grade.problem.empty() ? handed.student : "";
    for (const CourseExercise& entry : course.exercises) {
        ExerciseGrade graded;
        graded.name = entry.exercise->name;
        graded.title = entry.exercise->title;
        graded.points = entry.exercise->points;
        if (grade.problem.empty()) {
            const Task task = task_of(course, entry, handed.student);
            if (task.problem.empty()) {
                grade_exercise(task, folder, handed, graded);
            } else {
                graded.judged =
                    not_judged("The exercise cannot be set for this student: " + task.problem + ".");
            }
            graded.earned = std::round(graded.judged.share * graded.points / kFinest) * kFinest;
        }
        grade.exercises.push_back(std::move(graded));
    }
    return grade;
}

}  // namespace jw
