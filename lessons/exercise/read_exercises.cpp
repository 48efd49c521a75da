#include "lessons/exercise/read_exercises.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "lessons/exercise/exercise_index.hpp"
#include "lessons/exercise/scene_edits.hpp"
#include "lessons/fields/fields.hpp"
#include "lessons/files/file_text.hpp"
#include "lessons/format/exercise_keys.hpp"
#include "lessons/read/reader.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestExercises = 2U << 20U;
constexpr std::size_t kMostExercises = 500;
constexpr double kMostPoints = 1000.0;
constexpr std::size_t kMostHints = 10;
constexpr std::size_t kMostAlternatives = 20;

bool is_name(const std::string& name) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    };
    return !name.empty() && name.size() <= 60 && std::ranges::all_of(name, fits);
}

void read_exercise_name(Fields& fields, std::set<std::string>& names, Exercise& exercise) {
    fields.require("name", "a short name of letters, digits, '-' and '_'");
    const auto name = fields.text("name");
    if (!name) { return; }
    fields.call("exercise " + in_quotes(name->value));
    exercise.name = name->value;
    if (!is_name(name->value)) {
        fields.report(
            Code::faulty_name, name->span,
            in_quotes(name->value) +
                " cannot be the name of a file; expected up to 60 letters, digits, "
                "'-' and '_'");
    } else if (!names.insert(name->value).second) {
        fields.report(
            Code::taken_name, name->span,
            "there are two exercises " + in_quotes(name->value) + "; expected each name once");
    }
}

/// Reads the question, its explanation and its hints.
void read_question(Fields& fields, Exercise& exercise) {
    fields.require("ask", "what is asked");
    if (const auto ask = fields.words("ask")) { exercise.ask = ask->value; }
    if (const auto why = fields.words("why")) { exercise.why = why->value; }
    exercise.ask.drop_line_feeds();
    exercise.why.drop_line_feeds();
    if (const auto hints = fields.list_of_words("hints")) {
        if (hints->value.size() > kMostHints) {
            fields.report(
                Code::wrong_count, hints->span, "expected at most " + std::to_string(kMostHints) + " hints");
        }
        exercise.hints = hints->value;
        for (Text& hint : exercise.hints) { hint.drop_line_feeds(); }
    }
}

void read_frame(Fields& fields, Exercise& exercise) {
    fields.require("title", "a title");
    if (const auto title = fields.words("title")) { exercise.title = title->value; }
    if (const auto source = fields.text("source")) { exercise.source = source->value; }
    if (const auto allowed = fields.word("allowed")) {
        exercise.allowed = *allowed == 0 ? Allowed::paper : Allowed::program;
    }
    if (const auto points = fields.positive("points")) {
        exercise.points = points->value;
        if (points->value > kMostPoints) {
            fields.report(Code::out_of_range, points->span, "expected at most 1000 points");
        }
    }
}

/// The lesson of the catalogue that the exercise belongs to; in a lesson file, it is that lesson.
void read_lesson_key(Fields& fields, Exercise& exercise) {
    const auto lesson = fields.text("lesson");
    if (!lesson) { return; }
    if (!exercise.lesson.empty()) {
        fields.report(
            Code::exclusive_keys, lesson->span,
            "an exercise within a lesson belongs to that lesson; expected no key 'lesson' here",
            "take it out, or move the exercise into a file of exercises");
        return;
    }
    exercise.lesson = lesson->value;
    const std::vector<std::string> names = names_of_lessons();
    if (std::ranges::find(names, lesson->value) != names.end()) { return; }
    const std::string meant = did_you_mean(lesson->value, names);
    fields.report(
        Code::unknown_name, lesson->span,
        "there is no lesson " + in_quotes(lesson->value) +
            "; expected the folder and the name of a lesson of the catalogue, such as \"vectors/frames\"",
        meant.empty() ? "'jointwise list' shows them" : meant);
}

/// Applies the changes of the scene that come before the draws.
void read_changes(Fields& fields, Exercise& exercise) {
    const std::vector<SceneEdit> changes = reading::read_edits(fields, "change");
    if (exercise.scene.empty() || changes.empty()) { return; }
    EditedScene edited = with_edits(exercise.scene, changes);
    if (!edited.problem.empty()) {
        fields.report(
            Code::exercise_edit, fields.span("change"), edited.problem + "; expected keys of the scene");
        return;
    }
    exercise.scene = std::move(edited.text);
    const ReadResult read = read_lesson(exercise.scene, exercise.scene_name);
    if (read.lesson) { return; }
    fields.report(
        Code::exercise_scene, fields.span("change"),
        "the changed scene is not a lesson: " + read.diagnostics.front().message,
        read.diagnostics.front().hint);
}

/// Reads the scene: a file beside the exercises, or a lesson written in place.
void read_scene(Fields& fields, const fs::path& folder, Exercise& exercise) {
    const auto scene = fields.text("scene");
    if (!scene) {
        const bool needs_none = exercise.kind == ExerciseKind::order || fields.has("choices");
        if (exercise.scene.empty() && !needs_none) {
            fields.require("scene", "a lesson file, or a lesson as text of several lines");
        }
        return;
    }
    if (scene->value.find('\n') != std::string::npos) {
        exercise.scene = scene->value;
        exercise.scene_name = "the scene of " + exercise.name;
    } else {
        const fs::path path = folder / scene->value;
        FileText file = read_file_text(path, kLargestExercises);
        if (!file.problem.empty()) {
            fields.report(
                Code::exercise_scene, scene->span,
                in_quotes(scene->value) + ": " + file.problem +
                    "; expected a lesson file, relative to "
                    "the file of exercises");
            return;
        }
        exercise.scene = std::move(file.text);
        exercise.scene_name = path.string();
    }
    const ReadResult read = read_lesson(exercise.scene, exercise.scene_name);
    if (read.lesson) { return; }
    const Diagnostic& first = read.diagnostics.front();
    fields.report(
        Code::exercise_scene, scene->span,
        "the scene is not a lesson: line " + std::to_string(first.span.line) + ": " + first.message,
        "'jointwise check' tells all that is wrong with a file");
}

/// Reads question, scene and draws of an exercise or of an alternative.
void read_task(Fields& fields, const fs::path& folder, Exercise& exercise) {
    read_question(fields, exercise);
    read_scene(fields, folder, exercise);
    read_changes(fields, exercise);
    reading::read_draws(fields, exercise);
}

/// Another question under the name of an exercise.
/// @param other  what it shares with the exercise: frame, kind and scene
Exercise read_alternative(Fields& fields, const fs::path& folder, Exercise other) {
    other.span = fields.span();
    fields.call("an alternative of exercise " + in_quotes(other.name));
    read_task(fields, folder, other);
    reading::read_answer(fields, other);
    fields.finish();
    return other;
}

Exercise read_exercise(
    Fields& fields, const fs::path& folder, const Exercise& defaults, std::set<std::string>& names) {
    Exercise exercise = defaults;
    exercise.span = fields.span();
    fields.call("the exercise");
    read_exercise_name(fields, names, exercise);
    read_frame(fields, exercise);
    read_lesson_key(fields, exercise);
    fields.require("kind", comma_list(words_of(kExerciseKinds)));
    const int errors = fields.problems().errors_count();
    const auto kind = fields.word("kind", kExerciseKinds);
    if (kind) { exercise.kind = *kind; }
    Exercise shared = exercise;
    read_task(fields, folder, exercise);
    shared.scene = exercise.scene;
    shared.scene_name = exercise.scene_name;
    if (kind) {
        reading::read_answer(fields, exercise);
        for (Fields& alternative : fields.tables("alternative", kMostAlternatives)) {
            exercise.alternatives.push_back(read_alternative(alternative, folder, shared));
        }
    }
    if (kind || fields.problems().errors_count() == errors) { fields.finish(); }
    return exercise;
}

bool is_lesson_table(const toml::table& table) { return table.contains("body") || table.contains("joint"); }

bool read_exercise_head(Fields& root, ExercisesRead& read, Exercise& defaults) {
    root.require("format", "format = 1 as the first key");
    root.integer("format");
    root.require("title", "a title");
    if (const auto title = root.words("title")) { read.title = title->value; }
    if (const auto source = root.text("source")) { defaults.source = source->value; }
    return root.problems().errors_count() == 0;
}

}  // namespace

std::vector<Exercise> read_exercise_tables(Fields& root, const fs::path& folder, const Exercise& defaults) {
    std::vector<Exercise> exercises;
    std::set<std::string> names;
    for (Fields& fields : root.tables("exercise", kMostExercises)) {
        exercises.push_back(read_exercise(fields, folder, defaults, names));
    }
    return exercises;
}

ExercisesRead read_exercises(std::string source, const fs::path& path) {
    ExercisesRead read;
    std::vector<Diagnostic> of_lesson;
    const auto take = [&](const toml::table& table, Problems& problems) {
        Fields root(table, "the exercises", problems, &format::kExerciseFile);
        Exercise defaults;
        const bool is_lesson = is_lesson_table(table);
        if (is_lesson) {
            // other mistakes in the lesson are reported by its own reader
            ReadResult lesson = read_lesson(read.source, path.string());
            if (!lesson.lesson) {
                of_lesson = std::move(lesson.diagnostics);
                return;
            }
            read.title = lesson.lesson->title;
            defaults.source = lesson.lesson->source;
            defaults.lesson = lesson_name(path);
            defaults.scene = read.source;
            defaults.scene_name = path.string();
        } else {
            read_exercise_head(root, read, defaults);
        }
        root.require("exercise", "a table [[exercise]]");
        read.exercises = read_exercise_tables(root, path.parent_path(), defaults);
        if (!is_lesson) { root.finish(); }
        if (problems.errors_count() > 0) { read.exercises.clear(); }
    };
    read_toml(read, std::move(source), path.string(), take);
    if (!of_lesson.empty()) { read.diagnostics = std::move(of_lesson); }
    return read;
}

ExerciseTables exercise_tables_in(const fs::path& path) {
    // a pipe can be read only once
    std::error_code error;
    if (!fs::is_regular_file(path, error)) { return ExerciseTables::none; }
    FileText file = read_file_text(path, kLargestExercises);
    Problems problems(path.string(), file.text);
    const auto table = parse_toml(file.text, problems);
    if (!table || !table->contains("exercise")) { return ExerciseTables::none; }
    return is_lesson_table(*table) ? ExerciseTables::in_lesson : ExerciseTables::alone;
}

ExercisesRead read_exercise_file(const fs::path& path) {
    FileText file = read_file_text(path, kLargestExercises);
    if (file.problem.empty()) { return read_exercises(std::move(file.text), path); }
    ExercisesRead read;
    read.blame(path.string(), Code::file_unreadable, file.problem + "; expected a file of exercises (.toml)");
    return read;
}

}  // namespace jw
