#include <catch2/catch.hpp>

#include <sys/stat.h>

#include <unistd.h>
#include <csignal>
#include <filesystem>

#include "app/exercises/grading/grade_reports.hpp"
#include "app/exercises/grading/workers.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

namespace {

namespace fs = std::filesystem;

const char* const kExercises = R"(format = 1
title = "Small"

[[exercise]]
name = "value"
title = "A value"
kind = "number"
source = "slide 2"
ask = "Compute $s_i^T s_j$."
points = 2
scene = '''
format = 1
title = "S"
[[body]]
name = "a"
p = [1, 0, 0, 0]
[[body]]
name = "b"
p = [1, 0, 0, 0]
[[joint]]
name = "arms"
type = "n1"
bodies = ["a", "b"]
axis_i = [2, 1, 0]
axis_j = [0, 1, 2]
'''
as_given = true
joint = "arms"
formula = '\Phi = s_i^T A_j s_j'''
given = ["s_i", "A_j", "s'_j"]
vary = [{ key = "body.a.p", nice = "p" }, { key = "body.b.p", nice = "p" }]

[[exercise]]
name = "sorted"
title = "An order"
kind = "order"
ask = "Sort."
items = ["one", "two", "three"]
)";

/// The exercises above with one quote of TOML that a raw string cannot hold.
std::string exercises_text() {
    std::string text = kExercises;
    const std::string wrong = "formula = '\\Phi = s_i^T A_j s_j'''";
    text.replace(text.find(wrong), wrong.size(), "formula = \"\\\\Phi = s_i^T A_j s'_j\"");
    return text;
}

/// A class in a folder.
class Class {
public:
    Class() : read_(read_exercises(exercises_text(), "small.toml")) {
        INFO(read_.report());
        REQUIRE(read_.exercises.size() == 2);
        folder_.file("small.toml", exercises_text());
        key_ = folder_.file(
            "key.toml", "format = 1\nsecret = \"quite a secret\"\nexercises = [\"small.toml\"]\n");
        course_ = ready_course("quite a secret", read_.exercises);
        fs::create_directory(folder_.path("in"));
    }

    Task task(const std::string& student, std::size_t exercise) const {
        return task_of(course_, course_.exercises[exercise], student);
    }
    std::string right(const std::string& student) const {
        return "value = \"" + right_value(task(student, 0)).text +
               "\"\nsorted = " + right_value(task(student, 1)).text + "\n";
    }
    /// @return the folder of the submission
    std::string hand_in(const std::string& student, const std::string& answers) const {
        const std::string place = folder_.path("in/" + student);
        fs::create_directory(place);
        folder_.file(
            "in/" + student + "/answers.toml",
            "format = 1\nstudent = \"" + student + "\"\n[answers]\n" + answers);
        return place;
    }
    Ran grade(std::vector<std::string> more) const {
        std::vector<std::string> arguments{"grade", folder_.path("in"), "--key", key_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    const Folder& folder() const { return folder_; }
    const ReadyCourse& course() const { return course_; }

private:
    ExercisesRead read_;
    Folder folder_;
    std::string key_;
    ReadyCourse course_;
};

}  // namespace

TEST_CASE("A right submission gets all points, a known mistake its name", "[exercises][grade]") {
    const Class c;
    c.hand_in("ann", c.right("ann"));
    const Task task = c.task("bob", 0);
    const KnownMistake& mistake = task.asked.mistakes.front();
    c.hand_in("bob", "value = \"" + written(mistake.answer) + "\"\n");
    const Ran ran = c.grade({"--format", "csv"});
    INFO(ran.err);
    CHECK(ran.status == 0);
    CHECK_THAT(ran.out, Catch::Contains("ann,ann,3,3,2,,1,,\n"));
    CHECK_THAT(ran.out, Catch::Contains("bob,bob,0,3,0," + mistake.name + ",0,,\n"));
    const Ran text = c.grade({});
    CHECK_THAT(text.out, Catch::Contains("wrong: " + title_of(mistake)));
    CHECK_THAT(text.out, Catch::Contains("sorted: not handed in"));
}

TEST_CASE(
    "Hostile and malformed submissions get a reason, and the others their points", "[exercises][grade]") {
    const Class c;
    for (const char* student : {"s1", "s2", "s3"}) { c.hand_in(student, c.right(student)); }
    const auto bad = [&](const std::string& name) {
        fs::create_directory(c.folder().path("in/" + name));
        return "in/" + name + "/answers.toml";
    };
    c.folder().file(bad("not-toml"), "[[[[");
    c.folder().file(bad("no-utf8"), "student = \"\xff\xfe\"");
    c.folder().file(bad("path"), "student = \"../../etc/passwd\"\n[answers]\n");
    c.folder().file(bad("escape"), "student = \"x\"\n[answers]\nvalue = \"\\u001b[2J\\u0007\"\n");
    c.folder().file(bad("large"), std::string(5000000, 'x'));
    c.folder().file(bad("deep"), "student = \"d\"\n[answers]\nvalue = " + std::string(20000, '[') + "\n");
    c.folder().file(bad("many"), "student = \"m\"\n[answers]\nvalue = \"" + std::string(15000, '(') + "\"\n");
    fs::create_symlink("/etc/passwd", c.folder().path(bad("link")));
    REQUIRE(mkfifo(c.folder().path(bad("pipe")).c_str(), 0600) == 0);
    fs::create_directory(c.folder().path(bad("folder")));
    bad("empty");
    const Ran ran = c.grade({"--format", "csv", "--jobs", "3"});
    INFO(ran.out);
    CHECK(ran.status == 0);
    for (const char* student : {"s1", "s2", "s3"}) {
        CHECK_THAT(ran.out, Catch::Contains(std::string(student) + "," + student + ",3,3"));
    }
    CHECK(std::count(ran.out.begin(), ran.out.end(), '\n') >= 15);
    CHECK(ran.out.find("root:") == std::string::npos);
    CHECK(c.grade({}).out.find('\x1b') == std::string::npos);
}

TEST_CASE("Results are kept and used again until something changes", "[exercises][grade]") {
    const Class c;
    c.hand_in("ann", c.right("ann"));
    const std::string out = c.folder().path("out");
    const Ran first = c.grade({"--out", out});
    CHECK_THAT(first.out, Catch::Contains("3 of 3 points"));
    const std::string result = out + "/results/ann.json";
    std::string kept = bytes_of(result);
    REQUIRE_THAT(kept, Catch::Contains("\"earned\": 2.0"));
    kept.replace(kept.find("\"earned\": 2.0"), 13, "\"earned\": 1.0");
    c.folder().file("out/results/ann.json", kept);
    CHECK_THAT(c.grade({"--out", out}).out, Catch::Contains("2 of 3 points"));
    CHECK_THAT(c.grade({"--out", out, "--again"}).out, Catch::Contains("3 of 3 points"));
    c.hand_in("ann", "");
    CHECK_THAT(c.grade({"--out", out}).out, Catch::Contains("0 of 3 points"));
    CHECK_THAT(bytes_of(out + "/class.html"), Catch::Contains("1 submission,"));
    CHECK_THAT(bytes_of(out + "/grades.csv"), Catch::Contains("ann,ann,0,3"));
}

TEST_CASE("A kept result ends with any part of the exercise that it depends on", "[exercises][grade]") {
    const ExercisesRead read = read_exercises(exercises_text(), "small.toml");
    const std::string before = ready_course("quite a secret", read.exercises).digest;
    CHECK(ready_course("quite a secret", read.exercises).digest == before);
    CHECK(ready_course("another secret", read.exercises).digest != before);
    using Change = void (*)(Exercise&);
    const Change changes[] = {
        [](Exercise& e) { e.tolerance *= 1.01; },
        [](Exercise& e) { e.absolute = true; },
        [](Exercise& e) { e.points = 5.0; },
        [](Exercise& e) { e.unit = "m"; },
        [](Exercise& e) { e.only = {"sign"}; },
        [](Exercise& e) { e.vary.pop_back(); },
        [](Exercise& e) { e.condition_below = 9; },
        [](Exercise& e) { e.given.emplace_back("r_i"); },
        [](Exercise& e) { e.most = 2; },
        [](Exercise& e) { e.alternatives.push_back(Exercise(e)); }};
    for (const Change& change : changes) {
        std::vector<Exercise> changed = read.exercises;
        change(changed.front());
        CHECK(ready_course("quite a secret", changed).digest != before);
    }
    std::vector<Exercise> sorted = read.exercises;
    sorted.back().items[0] = "zero";
    CHECK(ready_course("quite a secret", sorted).digest != before);
}

TEST_CASE("A submission has one name, its own, and is not a link", "[exercises][grade]") {
    const Class c;
    c.hand_in("s1", c.right("s1"));
    c.hand_in("s2", c.right("s2"));
    const std::string in = c.folder().path("in");
    // no answers, but folders with the names of others
    fs::create_directories(in + "/s3/s1");
    fs::create_directories(in + "/.git");
    fs::create_directory_symlink(in + "/s1", in + "/s4");
    const std::string name = std::string(250, 'n') + "\xC2\x9B";
    c.hand_in(name, "");
    c.folder().file("in/s5.zip", "PK");
    const Ran all = c.grade({"--out", c.folder().path("out"), "--format", "csv"});
    CHECK(all.status == 0);
    CHECK(std::count(all.out.begin(), all.out.end(), '\n') == 6);
    CHECK_THAT(all.out, Catch::Contains("s1,s1,3,3"));
    CHECK_THAT(all.out, Catch::Contains(",s4,0,3,0,,0,,The submission is a symbolic link"));
    CHECK(all.out.find("\xC2\x9B") == std::string::npos);
    const Ran json = c.grade({"--format", "json"});
    CHECK(json.out.find("\xC2\x9B") == std::string::npos);
    CHECK_THAT(json.out, Catch::Contains("n\\u009b\","));
    CHECK_THAT(all.err, Catch::Contains("'s5.zip' is an archive"));
    CHECK(c.grade({"--out", c.folder().path("out"), "--format", "csv"}).out == all.out);
    const Ran named = run(
        {"grade", in + "/s1", in + "/s2", in + "/s3", "--key", c.folder().path("key.toml"), "--format",
         "csv"});
    INFO(named.err);
    CHECK(named.status == 0);
    CHECK(std::count(named.out.begin(), named.out.end(), '\n') == 4);
}

TEST_CASE("Grades are the same twice, in every format", "[exercises][grade]") {
    const Class c;
    for (const char* student : {"s1", "s2", "s3", "s4"}) { c.hand_in(student, c.right(student)); }
    for (const char* format : {"text", "json", "junit", "csv"}) {
        const Ran one = c.grade({"--format", format, "--jobs", "1"});
        const Ran four = c.grade({"--format", format, "--jobs", "4"});
        CHECK(one.status == 0);
        CHECK(one.out == four.out);
    }
    const Ran many = c.grade({"--format", "gradescope"});
    CHECK(many.status == 2);
    CHECK_THAT(many.err, Catch::Contains("is for one submission"));
}

TEST_CASE("A grade survives its way through JSON", "[exercises][grade]") {
    const Class c;
    const std::string folder = c.hand_in("ann", c.right("ann"));
    const Submission submission = read_submission(folder);
    Grade grade = empty_grade(c.course(), submission);
    for (std::size_t k = 0; k < grade.exercises.size(); ++k) {
        grade.exercises[k] = grade_exercise(c.course(), c.course().exercises[k], submission);
    }
    Grade back;
    REQUIRE(read_grade(json_text(grade), back));
    CHECK(json_text(back) == json_text(grade));
    CHECK(back.earned() == 3.0);
    CHECK_FALSE(read_grade("{}", back));
    CHECK_FALSE(read_grade("nonsense", back));
}

TEST_CASE("A part of a work that crashes, hangs or eats memory is lost alone", "[exercises][grade]") {
    WorkerLimits limits;
    limits.address_bytes = 1ULL << 30U;
    std::vector<std::vector<WorkDone>> all(2);
    Work work;
    work.pieces = 2;
    work.parts = 8;
    work.wall_seconds = [](int) { return 1.0; };
    work.carry_out = [](int piece, int part) -> std::string {
        if (piece == 1 && part == 1) { raise(SIGSEGV); }
        if (piece == 1 && part == 2) {
            for (;;) { pause(); }
        }
        if (piece == 1 && part == 3) { return std::string(static_cast<std::size_t>(3) << 30U, 'x'); }
        if (piece == 1 && part == 4) { throw 1; }
        if (piece == 1 && part == 5) { return std::string(static_cast<std::size_t>(5) << 20U, 'x'); }
        // all parts together take longer than one part may take
        usleep(400000);
        return "part " + std::to_string(part);
    };
    work.ended = [&](int piece, std::vector<WorkDone> done) {
        all[static_cast<std::size_t>(piece)] = std::move(done);
    };
    do_in_processes(work, 2, limits);
    for (const std::vector<WorkDone>& piece : all) { REQUIRE(piece.size() == 8); }
    for (std::size_t part = 0; part < 8; ++part) {
        CAPTURE(part);
        CHECK(all[0][part].result == "part " + std::to_string(part));
        const bool bad = part >= 1 && part <= 5;
        CHECK(all[1][part].problem.empty() != bad);
        CHECK(all[1][part].result == (bad ? "" : "part " + std::to_string(part)));
    }
    CHECK_THAT(all[1][2].problem, Catch::Contains("too long"));
    CHECK_THAT(all[1][3].problem, Catch::Contains("memory"));
}

TEST_CASE("Without its first part a piece of work has no others", "[exercises][grade]") {
    Work work;
    work.pieces = 1;
    work.parts = 3;
    work.wall_seconds = [](int) { return 60.0; };
    work.carry_out = [](int, int) -> std::string { throw 1; };
    std::size_t parts = 0;
    work.ended = [&](int, const std::vector<WorkDone>& done) { parts = done.size(); };
    do_in_processes(work, 1, {});
    CHECK(parts == 1);
}

}  // namespace jw::test
