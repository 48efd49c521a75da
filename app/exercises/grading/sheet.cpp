#include "app/exercises/grading/sheet.hpp"

#include "app/exercises/figure_scene.hpp"
#include "app/exercises/value_latex.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/exercise/handed_in.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace {

std::string line_of(const Exercise& exercise, const std::string& value) {
    return exercise.name + " = " + value;
}

std::string empty_line(const Exercise& exercise) {
    return line_of(exercise, exercise.kind == ExerciseKind::experiment ? "[]" : "\"\"");
}

std::string list_in_toml(const std::vector<std::string>& list) {
    std::string text = "[";
    for (std::size_t k = 0; k < list.size(); ++k) {
        text += (k > 0 ? ", " : "") + writing::string_text(list[k]);
    }
    return text + "]";
}

SheetEntry entry_of(Task task, int number, const FigureOf& figure) {
    SheetEntry entry;
    entry.task = std::move(task);
    entry.number = std::to_string(number);
    const Exercise& exercise = entry.task.exercise();
    if (exercise.kind != ExerciseKind::code) {
        for (const GivenSymbol& symbol : entry.task.asked.given) {
            entry.given.push_back("$" + given_latex(symbol) + "$");
        }
    }
    if (hands_out_file(exercise)) {
        entry.file = exercise.name + ".toml";
        entry.file_text = handed_out(entry.task);
    }
    const std::optional<FigureScene> scene = figure ? figure_scene(entry.task) : std::nullopt;
    if (scene) { entry.figure = figure(scene->lesson, scene->as_given); }
    if (std::string(kind_of(exercise.kind).file).empty()) { entry.template_line = empty_line(exercise); }
    return entry;
}

std::string given_markdown(const SheetEntry& entry) {
    std::string text;
    for (const std::string& given : entry.given) { text += "- " + markdown_words(given) + "\n"; }
    return text.empty() ? text : text + "\n";
}

std::string shown_markdown(const SheetEntry& entry) {
    std::string text;
    for (std::size_t k = 0; k < entry.task.shown.size(); ++k) {
        text += std::to_string(k + 1) + ". " + markdown_words(entry.task.shown[k]) + "\n";
    }
    return text.empty() ? text : text + "\n";
}

/// The hints stand after the sheet, so that nobody reads them by accident.
std::string hints_markdown(const Sheet& sheet) {
    std::string text;
    for (const SheetEntry& entry : sheet.entries) {
        const Exercise& exercise = entry.task.exercise();
        for (std::size_t k = 0; k < exercise.hints.size(); ++k) {
            text +=
                "- " +
                tr("Exercise {0}, hint {1}: {2}", entry.number, k + 1, markdown_words(exercise.hints[k])) +
                "\n";
        }
    }
    return text.empty() ? text : std::string("## ") + tr("Hints") + "\n\n" + text;
}

std::string solution_markdown(const SheetEntry& entry) {
    const Exercise& exercise = entry.task.exercise();
    std::string text = std::string("**") + tr("Solution.") + "** " + solution_text(entry) + "\n\n";
    if (!entry.task.asked.latex.empty()) { text += "$$" + entry.task.asked.latex + "$$\n\n"; }
    if (!exercise.why.empty()) { text += markdown_words(exercise.why) + "\n\n"; }
    for (const KnownMistake& mistake : entry.task.asked.mistakes) {
        text += "- " + written(mistake.answer, 5) + ": " + markdown_words(mistake_text(mistake)) + "\n";
    }
    return text + "\n";
}

}  // namespace

Sheet sheet_of(
    const ReadyCourse& course, const std::string& student, const std::string& title, const FigureOf& figure) {
    Sheet sheet;
    sheet.title = title;
    sheet.student = student;
    int number = 0;
    for (const CourseExercise& exercise : course.exercises) {
        Task task = task_of(course, exercise, student);
        if (task.problem.empty()) {
            sheet.entries.push_back(entry_of(std::move(task), ++number, figure));
        } else {
            sheet.problem +=
                "exercise " + exercise.exercise->name + ", student " + student + ": " + task.problem + "\n";
        }
    }
    return sheet;
}

std::string student_text(const Sheet& sheet, bool solution) {
    return solution ? tr("{0}, solutions", sheet.student) : sheet.student;
}

std::string mistake_text(const KnownMistake& mistake) {
    return tr("{0}. {1}", title_of(mistake), tr(mistake.says));
}

std::string unit_text_of(const SheetEntry& entry) {
    const std::string& unit = entry.task.asked.unit;
    return unit.empty() ? unit : tr("The answer is in {0}.", unit);
}

std::string head_text(const SheetEntry& entry) {
    const Exercise& exercise = entry.task.exercise();
    const std::string points = number_text(exercise.points, 4);
    const std::string worth = exercise.points == 1.0 ? tr("1 point") : tr("{0} points", points);
    const bool on_paper = exercise.allowed == Allowed::paper;
    if (exercise.source.empty()) {
        return on_paper ? tr("{0}, without the program", worth) : tr("{0}, the program may be used", worth);
    }
    const std::string source = shown_slides(exercise.source);
    return on_paper ? tr("{0}, {1}, without the program", worth, source)
                    : tr("{0}, {1}, the program may be used", worth, source);
}

std::string hand_in_text(const SheetEntry& entry) {
    const bool counts = entry.task.asked.tolerance == 0.0;
    const std::string& name = entry.task.exercise().name;
    if (entry.task.exercise().kind == ExerciseKind::code) {
        return tr(
            "Hand in a program in the folder of answers.toml: {0}.py, {0}.cpp, {0}.m or {0}.js. It reads "
            "JSON and writes JSON. The starter program in the folder {1} already does this; {0}-input.json "
            "beside it is an input for tests.",
            name, kStartersFolder);
    }
    if (entry.task.exercise().kind == ExerciseKind::number && counts) { return tr("Write a whole number."); }
    return followed(tr(kind_of(entry.task.exercise().kind).hand_in), accuracy_text(entry.task));
}

std::string solution_text(const SheetEntry& entry) {
    const Exercise& exercise = entry.task.exercise();
    switch (exercise.kind) {
        case ExerciseKind::code:
            return followed(tr("A program for the formula."), judging_of_programs(entry.task));
        case ExerciseKind::repair: return spoiled_text(exercise);
        case ExerciseKind::build:
            return std::string(tr("Added joints:")) + "\n\n```\n" + exercise.solution + "```";
        case ExerciseKind::experiment: return list_in_toml(exercise.does);
        default: return written(entry.task.asked.right, 6) + unit_behind(entry.task.asked);
    }
}

std::string sheet_markdown(const Sheet& sheet, bool solution) {
    std::string text = "# " + markdown_words(sheet.title) + "\n\n" + student_text(sheet, solution) + "\n\n";
    for (const SheetEntry& entry : sheet.entries) {
        const Exercise& exercise = entry.task.exercise();
        text += "## " + entry.number + ". " + markdown_words(exercise.title) + "\n\n*" +
                tr("{0}; answer {1}", head_text(entry), "`" + exercise.name + "`") + "*\n\n" +
                markdown_words(exercise.ask) + "\n\n";
        if (!entry.figure.empty()) {
            text += "![" + tr("the scene of {0}", exercise.name) + "](figures/" + exercise.name + ".png)\n\n";
        }
        text += given_markdown(entry) + shown_markdown(entry);
        std::string how;
        if (!entry.file.empty()) { how = tr("The scene is in the file {0}.", "`" + entry.file + "`"); }
        how = followed(how, followed(unit_text_of(entry), hand_in_text(entry)));
        text += how + "\n\n";
        if (exercise.kind == ExerciseKind::code) {
            std::string names;
            for (const std::string& name : input_names(exercise)) {
                names += (names.empty() ? "`" : " `") + name + "`";
            }
            text += tr("Inputs of a case: {0}.", names) + "\n\n";
        }
        if (solution) { text += solution_markdown(entry); }
    }
    return text + hints_markdown(sheet);
}

std::string answers_template(const Sheet& sheet, bool solution) {
    std::string text = "format = 1\nstudent = " + writing::string_text(sheet.student) + "\n\n[answers]\n";
    for (const SheetEntry& entry : sheet.entries) {
        const Exercise& exercise = entry.task.exercise();
        if (entry.template_line.empty()) { continue; }
        const Handed right = kind_of(exercise.kind).right(entry.task);
        const std::string value = exercise.kind == ExerciseKind::experiment
                                      ? list_in_toml(right.list)
                                      : writing::string_text(right.text);
        text += solution ? line_of(exercise, value) : entry.template_line;
        if (!entry.task.asked.unit.empty()) { text += "  # " + entry.task.asked.unit; }
        text += "\n";
    }
    return text;
}

}  // namespace jw
