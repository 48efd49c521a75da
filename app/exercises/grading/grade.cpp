#include "app/exercises/grading/grade.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string_view>

#include "app/exercises/grading/fault_text.hpp"
#include "app/exercises/grading/plain_file.hpp"
#include "app/exercises/random.hpp"
#include "app/exercises/run/languages.hpp"
#include "app/exercises/run/safe_text.hpp"
#include "app/exercises/run/student_file.hpp"
#include "app/session/wording/messages.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestHandedIn = 200000;
/// Stands in the table of kinds for the extensions of all languages.
constexpr std::string_view kProgramEnding = "program";
/// Earned points are rounded to multiples of this, so that 2/3 of 3 points are 2.
constexpr double kFinest = 1e-6;

/// Judgement of a program, and whether this machine could run it.
struct ProgramVerdict {
    Judged judged;
    bool not_run = false;
};

ProgramVerdict not_run(const exercises::ProgramResult::Outcome outcome, const std::string& why) {
    using Outcome = exercises::ProgramResult::Outcome;
    return {not_understood(why), outcome == Outcome::no_sandbox || outcome == Outcome::no_tool};
}

/// Beginning of the output of a program that gave no answers: often a number that the program prints in
/// addition.
std::string beginning_of(const std::string& out) {
    const std::string text = exercises::printable(out.substr(0, 1000));
    const std::size_t first = text.find_first_not_of(" \n\t");
    if (first == std::string::npos) { return tr("The program wrote nothing to standard output."); }
    return tr(
        "What it wrote begins with \"{0}\". Nothing but the answers may be written to standard output.",
        exercises::first_lines(text.substr(first, text.find('\n', first) - first), 1, 60));
}

/// Runs the program of the student and judges what it writes.
ProgramVerdict judge_program(
    const Task& task, const exercises::StudentProgram& program, const std::stop_token& stop = {}) {
    const exercises::ReadyProgram ready = exercises::make_ready(program, stop);
    if (ready.outcome != exercises::ProgramResult::Outcome::ran) {
        return not_run(ready.outcome, unready_text(ready, program.file));
    }
    const exercises::SandboxLimits limits;
    const exercises::ProgramResult result = exercises::run_ready(ready, program_input(task), limits, stop);
    if (result.outcome != exercises::ProgramResult::Outcome::ran) {
        return not_run(result.outcome, result.message);
    }
    if (std::string fault = program_fault(result.run, limits); !fault.empty()) {
        return {not_understood(std::move(fault))};
    }
    ProgramVerdict verdict{kind_of(task.exercise().kind).judge(task, {result.run.out, {}})};
    if (!verdict.judged.understood) { verdict.judged.feedback.push_back(beginning_of(result.run.out)); }
    return verdict;
}

void grade_program(const Task& task, const fs::path& folder, ExerciseGrade& grade) {
    const exercises::ProgramSearch found = exercises::find_program(folder.string(), grade.name);
    grade.handed_in = found.outcome != exercises::ProgramSearch::Outcome::absent;
    if (found.outcome == exercises::ProgramSearch::Outcome::found) {
        ProgramVerdict verdict = judge_program(task, found.program);
        grade.judged = std::move(verdict.judged);
        grade.not_run = verdict.not_run;
    } else if (grade.handed_in) {
        grade.judged = not_understood(found.reason);
    }
}

void grade_file(const Task& task, const fs::path& path, ExerciseGrade& grade) {
    const PlainFile file = read_plain_file(path, kLargestHandedIn);
    if (file.absent) { return; }
    grade.handed_in = true;
    grade.judged = file.problem.empty() ? kind_of(task.exercise().kind).judge(task, {file.text, {}})
                                        : not_understood(file.problem);
}

void grade_answer(const Task& task, const HandedIn& handed, ExerciseGrade& grade) {
    const auto answer = handed.answers.find(grade.name);
    if (answer == handed.answers.end()) { return; }
    const GivenText& given = answer->second;
    const bool empty = given.text.find_first_not_of(" \n\t\r") == std::string::npos;
    if (empty && given.list.empty()) { return; }
    if (given.text == "[]") { return; }
    grade.handed_in = true;
    const bool of_lists = task.exercise().kind == ExerciseKind::experiment;
    const std::vector<std::string> list = given.list.empty() ? std::vector{given.text} : given.list;
    grade.judged =
        kind_of(task.exercise().kind).judge(task, of_lists ? Handed{{}, list} : Handed{given.text, {}});
}

/// Judges the part of a submission that belongs to an exercise; the grade stays empty if there is none.
void grade_task(const Task& task, const Submission& submission, ExerciseGrade& grade) {
    const std::string ending = kind_of(task.exercise().kind).file;
    if (ending == kProgramEnding) { return grade_program(task, submission.folder, grade); }
    if (!ending.empty()) { return grade_file(task, submission.folder / (grade.name + ending), grade); }
    grade_answer(task, submission.handed, grade);
}

ExerciseGrade nothing_for(const Exercise& exercise) {
    ExerciseGrade grade;
    grade.name = exercise.name;
    grade.title = exercise.title;
    grade.points = exercise.points;
    return grade;
}

/// Everything that a grade depends on, each part with its length, so that two different exercises never have
/// the same text.
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
    for (const Exercise& alternative : e.alternatives) { add(text_of(alternative)); }
    return text.str();
}

/// Languages of programs that run here: a grade without a sandbox is not valid on a machine that has one.
std::string means_of_running() {
    std::string text = exercises::sandbox_availability().available ? "sandbox" : "no sandbox";
    for (const exercises::Language& language : exercises::kLanguages) {
        text += exercises::missing_tool(language);
    }
    return text;
}

}  // namespace

Judged judge_program_file(const Task& task, const fs::path& file, const std::stop_token& stop) {
    const exercises::ProgramSearch found = exercises::read_program(file.string());
    if (found.outcome == exercises::ProgramSearch::Outcome::found) {
        return judge_program(task, found.program, stop).judged;
    }
    return not_understood(
        found.reason.empty() ? tr("There is no file '{0}'; expected a program.", file.string())
                             : found.reason);
}

ReadyCourse ready_course(std::string secret, const std::vector<Exercise>& exercises) {
    ReadyCourse course;
    course.secret = std::move(secret);
    // the feedback is stored as text, so the language counts
    const std::string words = language() == "en" ? std::string() : std::string(language());
    std::uint64_t digest = seed_of(means_of_running() + words, JW_VERSION, course.secret);
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

Submission read_submission(const fs::path& folder) {
    Submission submission{folder, {}};
    std::error_code error;
    if (fs::is_symlink(folder, error)) {
        submission.handed.problem = tr("The submission is a symbolic link; expected a folder.");
        return submission;
    }
    const PlainFile answers = read_plain_file(folder / kAnswersFile, kLargestHandedIn);
    if (answers.problem.empty()) {
        submission.handed = read_answers_text(answers.text);
    } else {
        submission.handed.problem = answers.problem;
    }
    return submission;
}

Grade empty_grade(const ReadyCourse& course, const Submission& submission) {
    Grade grade;
    grade.submission = submission.folder.filename().string();
    grade.problem = submission.handed.problem;
    if (grade.problem.empty()) { grade.student = submission.handed.student; }
    for (const CourseExercise& entry : course.exercises) {
        grade.exercises.push_back(nothing_for(*entry.exercise));
    }
    return grade;
}

ExerciseGrade grade_exercise(
    const ReadyCourse& course, const CourseExercise& entry, const Submission& submission) {
    ExerciseGrade grade = nothing_for(*entry.exercise);
    if (!submission.handed.problem.empty()) { return grade; }
    const Task task = task_of(course, entry, submission.handed.student);
    if (task.problem.empty()) {
        grade_task(task, submission, grade);
    } else {
        grade.judged = not_understood(tr("The exercise cannot be set for this student: {0}.", task.problem));
    }
    grade.earned = std::round(grade.judged.share * grade.points / kFinest) * kFinest;
    return grade;
}

double longest_grading(const Exercise& exercise) {
    constexpr double kWithoutProgram = 60.0;
    const bool is_program = std::string(kind_of(exercise.kind).file) == kProgramEnding;
    return kWithoutProgram + (is_program ? exercises::longest_program_seconds() : 0.0);
}

}  // namespace jw
