#include <map>

#include <catch2/catch.hpp>

#include "app/exercises/grading/fault_text.hpp"
#include "app/exercises/grading/grade_reports.hpp"
#include "app/exercises/grading/sheet.hpp"
#include "app/exercises/random.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/files/catalogue.hpp"
#include "tests/app/messages/english_in.hpp"
#include "tests/app/messages/in_language.hpp"

/// In Chinese, neither the feedback on an answer nor a sheet contains English.
namespace jw {

namespace {

std::vector<std::filesystem::path> files() { return exercise_files_of(catalogue_folder()); }

/// Exercises of each kind as a reader of Chinese sees them: all of those that are judged at once, and of the
/// others as many as the test has time for.
std::vector<Exercise> exercises_in_chinese() {
    constexpr int kOfSlowKinds = 2;
    std::vector<Exercise> chosen;
    std::map<ExerciseKind, int> count;
    for (const auto& file : files()) {
        for (Exercise& exercise : read_exercise_file(file).exercises) {
            const bool fast =
                std::string(kind_of(exercise.kind).file).empty() && exercise.kind != ExerciseKind::experiment;
            if (++count[exercise.kind] > kOfSlowKinds && !fast) { continue; }
            chosen.push_back(shown_exercise(std::move(exercise)));
        }
    }
    return chosen;
}

/// Title and feedback of an answer in one text, without code.
std::string said_of(const Task& task, const Handed& handed) {
    const Judged judged = kind_of(task.exercise().kind).judge(task, handed);
    std::string all = judged.title;
    for (const std::string& sentence : judged.feedback) { all += "\n" + sentence; }
    return all;
}

/// Answers that cannot be read, have another shape, or are wrong in no known way.
std::vector<Handed> nonsense() {
    std::vector<Handed> all;
    for (const char* text :
         {"", "[", "(1", "1 +", "five", "2 apples", "3 kg m", "[1, 2]", "[[1, 2], [3]]",
          "[[1, 2, 3], [4, 5, 6]]", "1/0", "12345.678", "[3, 1, 2, 2]", "[1 2 3 4 5 6 7]", "sqrt 2", "1/2 pi",
          R"({"answers": [1, [1, 2], "x"]})", R"({"answers": []})", R"({"a": 1})"}) {
        all.push_back({text, {}});
    }
    all.push_back({{}, std::vector<std::string>(21, "undo")});
    return all;
}

/// Experiments are written in English in every language.
std::string without_experiments(std::string text, const std::vector<Exercise>& exercises) {
    for (const Exercise& exercise : exercises) {
        for (const std::string& action : exercise.does) {
            if (const std::size_t at = text.find(action); at != std::string::npos) {
                text.replace(at, action.size(), "·");
            }
        }
    }
    return text;
}

}  // namespace

TEST_CASE("No English sentence is said of an answer in Chinese", "[exercises][messages]") {
    const test::InLanguage chinese("zh-Hant");
    int said = 0;
    for (const Exercise& exercise : exercises_in_chinese()) {
        const Task task = TaskMaker(exercise).make(seed_of("chinese", "1", exercise.name));
        CAPTURE(exercise.name, task.problem);
        REQUIRE(task.problem.empty());
        std::vector<Handed> answers = nonsense();
        for (HandedMistake& mistake : kind_of(exercise.kind).mistakes(task)) {
            answers.push_back(std::move(mistake.handed));
        }
        // faults in a file are reported by the reader of lessons, whose diagnostics are English
        const bool of_files = exercise.kind == ExerciseKind::repair || exercise.kind == ExerciseKind::build;
        const std::string not_found = tr("The file does not contain what the exercise asks for: {0}.", "");
        for (const Handed& handed : answers) {
            const std::string text = said_of(task, handed);
            const bool diagnosed = text.find(".toml:") != std::string::npos ||
                                   text.find(not_found.substr(0, not_found.size() / 2)) != std::string::npos;
            if (of_files && diagnosed) { continue; }
            CAPTURE(handed.text, text);
            CHECK(test::english_in(text) == "");
            ++said;
        }
    }
    CHECK(said > 1500);
}

TEST_CASE(
    "A mistake is named in the language that was chosen since its task was made", "[exercises][messages]") {
    const std::vector<Exercise> exercises = read_exercise_file(files().back()).exercises;
    const Exercise& exercise = exercises.front();
    const Task task = TaskMaker(exercise).make(1);
    REQUIRE_FALSE(task.asked.mistakes.empty());
    const HandedMistake mistake = kind_of(exercise.kind).mistakes(task).front();
    const std::string english = said_of(task, mistake.handed);
    CHECK(test::english_in(english) != "");
    {
        const test::InLanguage chinese("zh-Hant");
        CHECK(test::english_in(said_of(task, mistake.handed)) == "");
    }
    CHECK(said_of(task, mistake.handed) == english);
}

TEST_CASE(
    "No English sentence stands on a sheet, its solutions and its quiz in Chinese", "[exercises][messages]") {
    const test::InLanguage chinese("zh-Hant");
    const std::vector<Exercise> exercises = exercises_in_chinese();
    const ReadyCourse course = ready_course("a secret of the tests", exercises);
    REQUIRE(course.problem.empty());
    const Sheet sheet = sheet_of(course, "s1", "題目", {});
    for (const bool solution : {false, true}) {
        CHECK(test::english_in(without_experiments(sheet_markdown(sheet, solution), exercises)) == "");
        CHECK(sheet_html(sheet, solution).find("<html lang=\"zh-Hant\">") != std::string::npos);
    }
    CHECK(test::english_in(moodle_xml({sheet}, "題")) == "");
}

TEST_CASE("No English sentence is said of a program that fails in Chinese", "[exercises][messages]") {
    const test::InLanguage chinese("zh-Hant");
    using Result = exercises::SandboxResult;
    std::vector<Result> all(6);
    all[0].too_much_output = true;
    all[1].out_of_memory = true;
    all[2].too_many_files = true;
    all[3].timed_out = true;
    all[4].signal = 9;
    all[5].exit_status = 1;
    for (const Result& result : all) {
        const std::string text = program_fault(result, {});
        CHECK(text.find("程式") != std::string::npos);
        CHECK(test::english_in(text) == "");
    }
}

}  // namespace jw
