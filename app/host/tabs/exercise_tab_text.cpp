#include "app/exercises/figure_scene.hpp"
#include "app/exercises/kinds.hpp"
#include "app/exercises/value_latex.hpp"
#include "app/host/tabs/exercise_tab.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/math/text_parts.hpp"

/// The tab of exercises for people who cannot see it: the words that are drawn, line by line.
namespace jw::host {

namespace {

constexpr int kWidth = 100;

/// Text of an author or of the program, with formulas in Unicode.
std::string told(const std::string& text) {
    std::string lines;
    std::string rest = math::plain_words(panels::typeset(panels::run_on(text)));
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        lines += wrapped(rest.substr(0, end), kWidth, 0) + '\n';
        rest = end == std::string::npos ? std::string() : rest.substr(end + 1);
    }
    return lines;
}

std::string as_it_stands(const std::string& text) {
    return text.empty() || text.ends_with('\n') ? text : text + '\n';
}

std::string list_text(const Practice& practice, int chosen) {
    std::string text = as_it_stands(tr("Exercises of this lesson"));
    if (practice.is_busy()) { text += as_it_stands(practice.doing()); }
    text += as_it_stands(practice.problem());
    const std::vector<PracticeExercise>& all = practice.exercises();
    if (all.empty()) {
        return practice.is_busy() ? text : text + as_it_stands(tr("This lesson has no exercises."));
    }
    const auto number_and_title = [&](std::size_t k) {
        return std::to_string(k + 1) + ". " + math::plain_words(all[k].exercise->title);
    };
    for (std::size_t k = 0; k < all.size(); ++k) {
        text += number_and_title(k) + "   ·   " +
                facts_of(*all[k].exercise, practice.progress().of(all[k].key)) + '\n';
    }
    text += as_it_stands(tr("Up and Down choose, Enter begins. The numbers are new each time."));
    // on a line of its own: if only this line changes, a screen reader reads only this line
    const std::size_t row = std::min(static_cast<std::size_t>(chosen), all.size() - 1);
    return text + as_it_stands(tr("Chosen: {0}", number_and_title(row)));
}

std::string question_text(const Task& task) {
    std::string text = told(task.exercise().ask);
    if (task.exercise().kind == ExerciseKind::code) {
        return text + told(inputs_of_program(task.exercise()));
    }
    for (const GivenSymbol& symbol : task.asked.given) { text += told("$" + given_latex(symbol) + "$"); }
    for (std::size_t k = 0; k < task.shown.size(); ++k) {
        text += told(std::to_string(k + 1) + ". " + task.shown[k]);
    }
    return text;
}

/// The scene as a lesson file, with data that a figure cannot show. It is long, so it comes last.
std::string scene_text(const Task& task) {
    if (!hands_out_file(task.exercise()) || task.exercise().asked.empty()) { return {}; }
    return as_it_stands(tr("The scene as a lesson file")) + as_it_stands(handed_out(task));
}

std::string answer_text(const Task& task, const ExerciseWork& work, const std::string& answer) {
    std::string text = as_it_stands(tr("Your answer")) + told(how_to_answer(task));
    if (task.exercise().kind == ExerciseKind::experiment) {
        for (const std::string& action : work.experiments) { text += "- " + as_it_stands(action); }
        return work.experiments.empty() ? text + as_it_stands(tr("none so far")) : text;
    }
    // a whole file would be read out again with every letter that is typed
    if (is_file(task.exercise().kind) || answer.empty()) { return text; }
    return text + as_it_stands(tr("In the field: {0}", answer));
}

std::string wrong_entries(const AnswerVerdict& verdict) {
    std::string entries;
    for (std::size_t r = 0; r < verdict.wrong.size(); ++r) {
        for (std::size_t c = 0; c < verdict.wrong[r].size(); ++c) {
            if (!verdict.wrong[r][c]) { continue; }
            entries +=
                (entries.empty() ? "" : ", ") +
                name_of_entry(verdict.given, static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
        }
    }
    return entries.empty() ? entries : as_it_stands(tr("These entries are wrong: {0}", entries));
}

std::string verdict_text(const Practice& practice) {
    const AnswerVerdict* const verdict = practice.verdict();
    if (verdict == nullptr) { return {}; }
    std::string text = told(title_of(verdict->judged));
    if (verdict->judged.right) {
        return practice.shows_solution() ? text : text + told(practice.task()->exercise().why);
    }
    for (const std::string& sentence : verdict->judged.feedback) { text += told(sentence); }
    // if no known mistake was found, the feedback already names the wrong entries
    return verdict->judged.title.empty() ? text : text + wrong_entries(*verdict);
}

std::string help_text(const Practice& practice) {
    std::string text;
    const std::vector<Text>& hints = practice.task()->exercise().hints;
    for (int k = 0; k < practice.hints_given(); ++k) {
        text += as_it_stands(tr("Hint {0} of {1}", k + 1, hints.size())) +
                told(hints[static_cast<std::size_t>(k)]);
    }
    if (!practice.shows_solution()) { return text; }
    text += as_it_stands(tr("Solution"));
    const std::string words = solution_words(*practice.task());
    const bool is_code = practice.task()->exercise().kind == ExerciseKind::build;
    return text + (is_code ? as_it_stands(words) : told(words)) + told(practice.task()->exercise().why);
}

std::string points_text(double points) {
    return points == 1.0 ? std::string(tr("1 point")) : tr("{0} points", number_text(points, 4));
}

/// "new", "tried", "solved 3 times, the last 2 in a row"
std::string record_text(const ExerciseRecord& record) {
    if (record.solved == 0) { return record.tried == 0 ? tr("new") : tr("tried"); }
    if (record.solved == 1) { return tr("solved"); }
    return record.streak > 1 ? tr("solved {0} times, the last {1} in a row", record.solved, record.streak)
                             : tr("solved {0} times", record.solved);
}

std::string how_without_unit(const Task& task) {
    const bool counts = task.asked.tolerance == 0.0;
    switch (task.exercise().kind) {
        case ExerciseKind::repair:
            return tr(
                "Repair the lesson: in this field, with 'Try it', or in an editor. Change as little as "
                "possible.");
        case ExerciseKind::build:
            return tr(
                "Add joints at the end of the lesson: in this field or in an editor. Leave the rest as it "
                "is.");
        case ExerciseKind::experiment:
            return tr(
                "Do experiments with the lesson in 'Try it'. Those that you do are listed here and judged.");
        case ExerciseKind::code:
            return tr("Write a program: .py, .cpp, .m or .js. It reads JSON and writes JSON.");
        case ExerciseKind::choose: return tr("Press the number of a choice, or type it.");
        case ExerciseKind::number:
            if (counts) { return tr("Write a whole number."); }
            break;
        default: break;
    }
    return tr(kind_of(task.exercise().kind).hand_in);
}

}  // namespace

std::string ExerciseTab::text(const Practice& practice, const ExerciseWork& work) const {
    if (practice.chosen() < 0) { return list_text(practice, row_); }
    const Exercise& exercise = *practice.exercise();
    const std::string head = told(exercise.title) + told(what_is_allowed(exercise));
    const Task* const task = practice.task();
    if (task == nullptr) { return head + as_it_stands(practice.doing()); }
    if (!task->problem.empty()) {
        return head + told(tr("This exercise cannot be set with these numbers: {0}", task->problem));
    }
    return head + question_text(*task) + answer_text(*task, work, answer_) + as_it_stands(practice.doing()) +
           verdict_text(practice) + help_text(practice) + scene_text(*task);
}

std::string facts_of(const Exercise& exercise, const ExerciseRecord& record) {
    return std::string(tr(label_of(kExerciseKinds, exercise.kind))) + "   ·   " +
           points_text(exercise.points) + "   ·   " + record_text(record);
}

std::string what_is_allowed(const Exercise& exercise) {
    const std::string where = exercise.source.empty() ? "" : shown_slides(exercise.source) + "   ·   ";
    return where + (exercise.allowed == Allowed::paper ? tr("on paper: the answer cannot be read off here")
                                                       : tr("the program may be used"));
}

std::string inputs_of_program(const Exercise& exercise) {
    std::string names;
    for (const std::string& name : input_names(exercise)) { names += (names.empty() ? "" : ", ") + name; }
    return tr("Inputs of a case: {0}.", names);
}

std::string how_to_answer(const Task& task) {
    std::string how = how_without_unit(task);
    if (!task.asked.unit.empty()) { how += " " + tr("The answer is in {0}.", task.asked.unit); }
    if (is_of_numbers(task.exercise().kind)) {
        how += std::string(" ") + tr("Type the answer; Enter checks it.");
    }
    return how;
}

std::string title_of(const Judged& judged) {
    if (judged.right) { return tr("Right."); }
    if (!judged.title.empty()) { return tr("Not correct: {0}.", judged.title); }
    return judged.understood ? tr("Not correct.") : tr("Not understood.");
}

bool is_file(ExerciseKind kind) { return kind == ExerciseKind::repair || kind == ExerciseKind::build; }

bool is_of_numbers(ExerciseKind kind) {
    return is_measured(kind) || kind == ExerciseKind::choose || kind == ExerciseKind::order;
}

}  // namespace jw::host
