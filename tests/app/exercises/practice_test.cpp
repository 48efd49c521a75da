#include <catch2/catch.hpp>

#include <atomic>
#include <fstream>
#include <thread>

#include "app/exercises/practice/practice.hpp"
#include "app/exercises/starters.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "tests/app/messages/in_language.hpp"
#include "tests/app/program.hpp"

namespace jw::test {
namespace {

namespace fs = std::filesystem;

/// All exercises that come with the program.
std::vector<PracticeExercise> shipped() {
    std::vector<PracticeExercise> all;
    for (const auto& file : fs::directory_iterator(JW_EXERCISES_FOLDER)) {
        if (file.path().extension() != ".toml") { continue; }
        for (const Exercise& exercise : read_exercise_file(file.path()).exercises) {
            all.push_back(
                {std::make_shared<const Exercise>(exercise), record_key(file.path(), exercise.name)});
        }
    }
    return all;
}

std::vector<PracticeExercise> shipped_of(ExerciseKind kind) {
    std::vector<PracticeExercise> some;
    for (PracticeExercise& entry : shipped()) {
        if (entry.exercise->kind == kind) { some.push_back(std::move(entry)); }
    }
    return some;
}

void begin(Practice& practice, int index) {
    practice.choose(index);
    practice.wait();
    REQUIRE(practice.task() != nullptr);
    REQUIRE(practice.task()->problem.empty());
}

const AnswerVerdict& checked(Practice& practice, const Handed& handed) {
    practice.check(handed);
    practice.wait();
    REQUIRE(practice.verdict() != nullptr);
    return *practice.verdict();
}

}  // namespace

TEST_CASE(
    "Every shipped exercise is solved by its own answer, names every known mistake and refuses nonsense",
    "[practice]") {
    Practice practice({.lessons = {}, .progress = {}, .judge_program = {}});
    practice.offer(shipped());
    const auto count = static_cast<int>(practice.exercises().size());
    REQUIRE(count >= 60);
    for (int k = 0; k < count; ++k) {
        begin(practice, k);
        const Task task = *practice.task();
        const KindOfExercise& kind = kind_of(task.exercise().kind);
        CAPTURE(task.exercise().name);
        const AnswerVerdict& nonsense = checked(practice, {"[[nonsense", {"nonsense"}});
        CHECK_FALSE(nonsense.judged.right);
        CHECK_FALSE(nonsense.judged.feedback.empty());
        for (const HandedMistake& mistake : kind.mistakes(task)) {
            const AnswerVerdict& wrong = checked(practice, mistake.handed);
            CAPTURE(mistake.name);
            CHECK(wrong.judged.mistake == mistake.name);
            CHECK_FALSE(wrong.judged.feedback.empty());
            CHECK_FALSE(practice.is_solved());
        }
        CHECK(checked(practice, kind.right(task)).judged.right);
        CHECK(practice.is_solved());
        CHECK(practice.record().solved == 1);
    }
}

TEST_CASE("Progress survives a restart, and every variant counts once", "[practice]") {
    const TemporaryFolder folder;
    const PracticeSetup setup{
        .lessons = {}, .progress = folder.path() / "new" / "progress.toml", .judge_program = {}};
    const std::vector<PracticeExercise> numbers = shipped_of(ExerciseKind::vector);
    std::string first;
    {
        Practice practice(setup);
        practice.offer(numbers);
        begin(practice, 0);
        first = kind_of(ExerciseKind::vector).right(*practice.task()).text;
        CHECK_FALSE(checked(practice, {"[0, 0, 12345]", {}}).judged.right);
        CHECK(checked(practice, {first, {}}).judged.right);
        CHECK(checked(practice, {first, {}}).judged.right);
        CHECK(practice.record() == ExerciseRecord{.tried = 2, .solved = 1, .streak = 1, .variant = 1});
    }
    Practice practice(setup);
    practice.offer(numbers);
    begin(practice, 0);
    CHECK(practice.record() == ExerciseRecord{.tried = 2, .solved = 1, .streak = 1, .variant = 1});
    // a student who comes back gets other numbers
    CHECK(kind_of(ExerciseKind::vector).right(*practice.task()).text != first);
    CHECK(practice.take_notice().empty());
}

TEST_CASE(
    "New numbers never end, the same counter gives the same, and unsolved ones break a streak",
    "[practice]") {
    Practice practice({.lessons = {}, .progress = {}, .judge_program = {}});
    practice.offer(shipped_of(ExerciseKind::vector));
    begin(practice, 0);
    std::vector<std::uint64_t> seeds;
    std::vector<std::string> scenes;
    for (int k = 0; k < 6; ++k) {
        CHECK(std::ranges::find(scenes, practice.task()->variant.scene) == scenes.end());
        scenes.push_back(practice.task()->variant.scene);
        practice.draw_anew();
        practice.wait();
    }
    Practice again({.lessons = {}, .progress = {}, .judge_program = {}});
    again.offer(shipped_of(ExerciseKind::vector));
    begin(again, 0);
    CHECK(again.task()->variant.scene == scenes.front());
    checked(again, kind_of(ExerciseKind::vector).right(*again.task()));
    again.draw_anew();
    again.wait();
    CHECK(again.record().streak == 1);
    checked(again, {"[0, 0, 12345]", {}});
    CHECK(again.record().streak == 0);
}

TEST_CASE("Hints come one after the other, and a solution that was shown is not solved", "[practice]") {
    Practice practice({.lessons = {}, .progress = {}, .judge_program = {}});
    practice.offer(shipped_of(ExerciseKind::vector));
    begin(practice, 0);
    const auto all = static_cast<int>(practice.exercise()->hints.size());
    REQUIRE(all > 0);
    for (int k = 1; k <= all + 1; ++k) {
        practice.give_hint();
        CHECK(practice.hints_given() == std::min(k, all));
    }
    practice.show_solution();
    CHECK(checked(practice, kind_of(ExerciseKind::vector).right(*practice.task())).judged.right);
    CHECK_FALSE(practice.is_solved());
    CHECK(practice.record() == ExerciseRecord{});
    practice.draw_anew();
    practice.wait();
    CHECK(practice.hints_given() == 0);
    CHECK_FALSE(practice.shows_solution());
}

TEST_CASE("The entries that differ are told, and how far off the answer is", "[practice]") {
    Practice practice({.lessons = {}, .progress = {}, .judge_program = {}});
    practice.offer(shipped_of(ExerciseKind::vector));
    begin(practice, 0);
    MatrixX wrong = practice.task()->asked.right;
    wrong(1, 0) += 100.0;
    const AnswerVerdict& verdict = checked(practice, {written(wrong), {}});
    CHECK_FALSE(verdict.judged.right);
    CHECK(verdict.wrong == std::vector<std::vector<bool>>{{false}, {true}, {false}});
    CHECK(verdict.judged.feedback.front().find("off by 100") != std::string::npos);
}

TEST_CASE(
    "A file of progress that is none is set aside with a notice, and never written over", "[practice]") {
    for (const std::string text :
         {"not = [toml", "format = 2\nfile = \"progress\"\n", "format = 1\n", "\xff\xfe\x00",
          "format = 1\nfile = \"progress\"\n[[exercise]]\nname = \"a\"\ntried = -4\n"}) {
        CAPTURE(text);
        const TemporaryFolder folder;
        const fs::path file = folder.write("progress.toml", text);
        Progress progress(file);
        CHECK(progress.all().empty());
        CHECK(progress.take_notice().find("could not be read") != std::string::npos);
        CHECK(progress.take_notice().empty());
        progress.keep("a/b", {.tried = 1, .solved = 1, .streak = 1, .variant = 1});
        CHECK(bytes_of(folder.path() / "progress.toml.set-aside") == text);
        Progress later(file);
        CHECK(later.of("a/b").solved == 1);
        CHECK(later.take_notice().empty());
    }
}

TEST_CASE("Two windows keep each other's progress", "[practice]") {
    const TemporaryFolder folder;
    Progress one(folder.path() / "progress.toml");
    Progress other(folder.path() / "progress.toml");
    one.keep("a", {.tried = 1});
    other.keep("b", {.tried = 2});
    one.keep("c", {.tried = 3});
    const Progress read(folder.path() / "progress.toml");
    CHECK(read.all().size() == 3);
}

TEST_CASE("An exercise that is left while its numbers are drawn is given up", "[practice]") {
    Practice practice({.lessons = {}, .progress = {}, .judge_program = {}});
    practice.offer(shipped());
    for (int k = 0; k < 20; ++k) {
        practice.choose(k);
        CHECK(practice.task() == nullptr);
        practice.leave();
        practice.look();
        CHECK(practice.doing().empty());
    }
}

TEST_CASE("Another language keeps the numbers of an exercise, and its hints", "[practice]") {
    Practice practice({.lessons = {}, .progress = {}, .judge_program = {}});
    practice.offer(shipped());
    practice.choose(0);
    practice.wait();
    REQUIRE(practice.task() != nullptr);
    const std::string title = practice.exercise()->title;
    const MatrixX right = practice.task()->asked.right;
    practice.give_hint();
    {
        const InLanguage chinese("zh-Hant");
        practice.tell_again();
        practice.wait();
        REQUIRE(practice.task() != nullptr);
        CHECK(std::string(practice.exercise()->title) != title);
        CHECK(practice.task()->variant.exercise == practice.exercise());
        CHECK(practice.task()->asked.right == right);
        CHECK(practice.hints_given() == 1);
        CHECK(practice.verdict() == nullptr);
    }
    practice.tell_again();
    practice.wait();
    CHECK(std::string(practice.exercise()->title) == title);
}

TEST_CASE("A lesson finds its exercises: its own, and those of the course that name it", "[practice]") {
    const TemporaryFolder folder;
    const std::string order = "title = \"T\"\nkind = \"order\"\nask = \"?\"\nitems = [\"1\", \"2\", \"3\"]\n";
    const fs::path lesson = folder.write(
        "lessons/x/one.toml",
        "format = 1\ntitle = \"L\"\nsource = \"slide 3\"\n[[body]]\nname = \"b\"\n[[exercise]]\nname = "
        "\"inside\"\n" +
            order);
    folder.write("exercises/all.toml", "format = 1\ntitle = \"E\"\n[[exercise]]\nname = \"none\"\n" + order);
    Practice practice({.lessons = folder.path() / "lessons", .progress = {}, .judge_program = {}});
    practice.open(lesson);
    practice.begin_reading();
    practice.wait();
    CHECK(practice.problem().empty());
    REQUIRE(practice.exercises().size() == 1);
    CHECK(practice.exercises().front().key == "x/one/inside");
    REQUIRE(practice.lesson_about("slide 3") != nullptr);
    CHECK(practice.lesson_about("slide 3")->title == "L");
    CHECK(practice.lesson_about("slide 4") == nullptr);
}

TEST_CASE("Who leaves an exercise, or everything, stops the program that is judged", "[practice]") {
    std::atomic<int> begun = 0;
    std::atomic<int> stopped = 0;
    const auto judge = [&](const Task&, const fs::path&, const std::stop_token& stop) {
        ++begun;
        while (!stop.stop_requested()) { std::this_thread::yield(); }
        ++stopped;
        return Judged();
    };
    {
        Practice practice({.lessons = {}, .progress = {}, .judge_program = judge});
        practice.offer(shipped_of(ExerciseKind::code));
        for (const bool leaves : {true, false}) {
            begin(practice, 0);
            const int before = begun;
            practice.check_program("mine.py");
            while (begun == before) { std::this_thread::yield(); }
            CHECK(practice.is_busy());
            if (leaves) { practice.leave(); }
        }
    }
    CHECK(stopped == 2);
}

TEST_CASE(
    "A starter and its input are written beside each other, and files that are there stay", "[practice]") {
    Practice practice({.lessons = {}, .progress = {}, .judge_program = {}});
    practice.offer(shipped_of(ExerciseKind::code));
    begin(practice, 0);
    const TemporaryFolder folder;
    for (const char* const ending : {".py", ".m", ".js", ".cpp"}) {
        const fs::path file = folder.path() / ("mine" + std::string(ending));
        CHECK(write_starter(*practice.task(), file).find("The program is") == 0);
        CHECK(bytes_of(file) == starter_text(*practice.task(), ending));
    }
    CHECK(bytes_of(folder.path() / "mine-input.json") == program_input(*practice.task()));
    folder.write("mine.py", "mine");
    write_starter(*practice.task(), folder.path() / "mine.py");
    CHECK(bytes_of(folder.path() / "mine.py") == "mine");
    CHECK(write_starter(*practice.task(), folder.path() / "mine").find("Type the name of a file") == 0);
    practice.check_program(folder.path() / "mine.py");
    CHECK_FALSE(practice.verdict()->judged.understood);
}

}  // namespace jw::test
