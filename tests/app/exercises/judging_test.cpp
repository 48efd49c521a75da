#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <nlohmann/json.hpp>

#include "app/exercises/answers/read_output.hpp"
#include "app/exercises/kinds.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/exercise/read_exercises.hpp"

using namespace jw;

namespace {

/// A shipped exercise, which lives with its tasks as long as this object.
struct Shipped {
    Shipped(const std::string& file, const std::string& name)
        : read(read_exercise_file(std::filesystem::path(JW_EXERCISES_FOLDER) / file)),
          maker(*std::ranges::find(read.exercises, name, &Exercise::name)),
          task(maker.make(7)) {}
    ExercisesRead read;
    TaskMaker maker;
    Task task;
};

/// An output of answers with another word for its last number.
std::string with_last_number(const std::string& output, const std::string& word) {
    const std::size_t end = output.find_last_of("0123456789") + 1;
    const std::size_t begin = output.find_last_of("[,", end) + 1;
    return output.substr(0, begin) + word + output.substr(end);
}

/// An output with `count` answers: cut, or with the last one repeated.
std::string with_answers(const std::string& output, std::size_t count) {
    nlohmann::json json = nlohmann::json::parse(output);
    nlohmann::json& answers = json["answers"];
    while (answers.size() > count) { answers.erase(answers.size() - 1); }
    while (answers.size() < count) { answers.push_back(answers.back()); }
    return json.dump();
}

/// A joint of a lesson file between the ground and the body that comes last in `scene`.
std::string joint_to_last_body(
    const std::string& scene, const std::string& name, const std::string& type, const std::string& keys) {
    const std::size_t body = scene.rfind("[[body]]");
    const std::size_t from = scene.find("name = \"", body) + 8;
    const std::string last = scene.substr(from, scene.find('"', from) - from);
    return "\n[[joint]]\nname = \"" + name + "\"\ntype = \"" + type + "\"\nbodies = [\"ground\", \"" + last +
           "\"]\n" + keys;
}

Exercise letters() {
    Exercise exercise;
    exercise.name = "letters";
    exercise.kind = ExerciseKind::order;
    return exercise;
}

}  // namespace

TEST_CASE("NaN costs a program the states in which it is written, and is named", "[exercises]") {
    const Shipped shipped("jacobians.toml", "n1-row-code");
    REQUIRE(shipped.task.problem.empty());
    const std::string right = right_output(shipped.task).text;
    for (const char* word : {"NaN", "-nan", "Infinity", "-inf", "null", "1e999"}) {
        CAPTURE(word);
        const std::string output = with_last_number(right, word);
        const Judged judged = judge_output(shipped.task, {output, {}});
        CHECK(judged.understood);
        CHECK_FALSE(judged.right);
        CHECK(judged.feedback.front() == "23 of 24 cases are right.");
        CHECK(judged.share == Approx(0.5 * 23 / 24));
        const bool named = std::ranges::any_of(judged.feedback, [](const std::string& sentence) {
            return sentence.find("1 answer has NaN or infinity") != std::string::npos;
        });
        CHECK(named);
    }
}

TEST_CASE("A known mistake is named although a state has no value", "[exercises]") {
    const Shipped shipped("jacobians.toml", "n1-row-code");
    const HandedMistake mistake = mistaken_outputs(shipped.task).front();
    const std::string output = with_last_number(mistake.handed.text, "NaN");
    CHECK(judge_output(shipped.task, {output, {}}).mistake == mistake.name);
}

TEST_CASE("Too few or too many answers cost a program only the states without one", "[exercises]") {
    const Shipped shipped("jacobians.toml", "n1-row-code");
    REQUIRE(shipped.task.problem.empty());
    const std::string right = right_output(shipped.task).text;
    const Judged fewer = judge_output(shipped.task, {with_answers(right, 21), {}});
    CAPTURE(fewer.feedback);
    CHECK(fewer.understood);
    CHECK_FALSE(fewer.right);
    CHECK(fewer.share == Approx(0.5 * 21 / 24));
    CHECK(fewer.mistake.empty());
    CHECK(fewer.feedback.front().starts_with("There are 21 answers; expected 24"));
    CHECK(fewer.feedback.back() == "21 of 24 cases are right.");

    const Judged more = judge_output(shipped.task, {with_answers(right, 26), {}});
    CAPTURE(more.feedback);
    CHECK_FALSE(more.right);
    CHECK(more.share == Approx(0.5));
    CHECK(more.feedback.front().starts_with("There are 26 answers; expected 24"));

    const Judged none = judge_output(shipped.task, {with_answers(right, 0), {}});
    CHECK(none.share == 0.0);
    CHECK(none.feedback.front().starts_with("There are 0 answers; expected 24"));
}

TEST_CASE("A known mistake is named although answers are missing, if a random state has one", "[exercises]") {
    const Shipped shipped("jacobians.toml", "n1-row-code");
    const HandedMistake mistake = mistaken_outputs(shipped.task).front();
    // the first four cases are special: different mistakes may have the same answers there
    CHECK(judge_output(shipped.task, {with_answers(mistake.handed.text, 3), {}}).mistake.empty());
    for (const std::size_t count : {5U, 23U, 25U}) {
        CAPTURE(count);
        const Judged judged = judge_output(shipped.task, {with_answers(mistake.handed.text, count), {}});
        CHECK(judged.mistake == mistake.name);
        CHECK(judged.share == 0.0);
    }
}

TEST_CASE("A mistake much larger than the right answer is named from as many digits", "[exercises]") {
    Exercise exercise;
    exercise.kind = ExerciseKind::number;
    Task task;
    task.variant.exercise = &exercise;
    task.asked.right = MatrixX::Constant(1, 1, 2.32);
    task.asked.tolerance = 0.00232;
    const auto known = [&](double answer) {
        KnownMistake mistake;
        mistake.name = std::to_string(answer);
        mistake.titles = {{"known", {}}};
        mistake.answer = MatrixX::Constant(1, 1, answer);
        return mistake;
    };
    task.asked.mistakes = {known(-198.7031), known(300.0), known(300.1)};
    for (const char* text : {"-198.7", "-198.70", "-198.6", "-198.703"}) {
        CAPTURE(text);
        CHECK(judge_value(task, {text, {}}).title == "known");
    }
    CHECK(judge_value(task, {"300.1", {}}).mistake == std::to_string(300.1));
    // not clearly nearest to one of the mistakes
    for (const char* text : {"-190", "300.05", "2.4"}) {
        CAPTURE(text);
        CHECK(judge_value(task, {text, {}}).mistake.empty());
    }
}

TEST_CASE("Text in strings and truncated output are not read as numbers", "[exercises]") {
    CHECK(
        read_program_output(R"({"nan \" inf": "NaN", "answers": [1, [NaN, 2], "nan", {}, [[1], 2]]})")
            .answers.size() == 5);
    CHECK(read_program_output(R"({"answers": ["nan"]})").answers.front().size() == 0);
    for (const char* text :
         {"", "{\"answers\": [[1, 2, 3], [4,", "nan", "\"", "\"\\", "{\"answers\": nano}"}) {
        CAPTURE(text);
        CHECK_FALSE(read_program_output(text).problem.empty());
    }
}

TEST_CASE("A component is chosen by its letter, large or small, or by its place", "[exercises]") {
    const Shipped shipped("vectors.toml", "dropped-component");
    REQUIRE(shipped.task.shown == std::vector<std::string>{"x", "y", "z"});
    const auto place = static_cast<std::size_t>(shipped.task.asked.right(0, 0)) - 1;
    std::string letter = shipped.task.shown[place];
    CHECK(judge_value(shipped.task, {letter, {}}).right);
    letter.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(letter.front())));
    CHECK(judge_value(shipped.task, {letter, {}}).right);
    CHECK(judge_value(shipped.task, {" " + letter + "\n", {}}).right);
    CHECK(judge_value(shipped.task, {std::to_string(place + 1), {}}).right);
    CHECK_FALSE(judge_value(shipped.task, {"W", {}}).understood);
}

TEST_CASE(
    "Items that are letters are sorted by their letters, large or small, or by their places", "[exercises]") {
    const Exercise exercise = letters();
    Task task;
    task.variant.exercise = &exercise;
    task.shown = {"y", "z", "x"};
    task.asked.right = VectorX(3);
    task.asked.right << 3.0, 1.0, 2.0;
    for (const char* text : {"[x, y, z]", "X Y Z", "x,Y, z", "[3, 1, 2]"}) {
        CAPTURE(text);
        CHECK(judge_value(task, {text, {}}).right);
    }
    CHECK_FALSE(judge_value(task, {"X Z Y", {}}).right);
}

TEST_CASE(
    "A mistake is named in as many digits as the sheet asks for, however large its answer", "[exercises]") {
    Exercise exercise;
    exercise.kind = ExerciseKind::number;
    Task task;
    task.variant.exercise = &exercise;
    task.asked.right = MatrixX::Constant(1, 1, 1.130079);
    task.asked.tolerance = 1e-3 * 1.130079;
    const double in_degrees = 1.130079 * 180.0 / std::numbers::pi;
    task.asked.mistakes.push_back(
        {"degrees", {}, {"Degrees.", {}}, "", MatrixX::Constant(1, 1, in_degrees), {}});
    const Judged judged = judge_value(task, {written(task.asked.mistakes.front().answer, 4), {}});
    CHECK_FALSE(judged.right);
    CHECK(judged.mistake == "degrees");
    CHECK(judge_value(task, {"65.1", {}}).mistake.empty());
}

TEST_CASE("An answer that is rounded as its sheet says is right, whatever its numbers", "[exercises]") {
    Exercise exercise;
    exercise.kind = ExerciseKind::vector;
    Task task;
    task.variant.exercise = &exercise;
    for (const double tolerance : {0.02, 0.01, 1e-3, 1e-4}) {
        exercise.tolerance = tolerance;
        for (const double first : {1.0004999, 1.0049999, 2.3456789, 9.9951, -0.00104999}) {
            task.asked.right = VectorX::Constant(3, first);
            task.asked.tolerance = tolerance * std::abs(first);
            const std::string said = accuracy_text(task);
            CAPTURE(tolerance, first, said);
            const int digits = tolerance > 0.01 ? 3 : tolerance > 1e-3 ? 3 : tolerance > 1e-4 ? 4 : 5;
            constexpr const char* kDigits[] = {"Three", "Four", "Five"};
            CHECK(
                said == std::string(kDigits[digits - 3]) + " significant digits in each number are enough.");
            CHECK(judge_value(task, {written(task.asked.right, digits), {}}).right);
        }
    }
    exercise.absolute = true;
    task.asked.tolerance = 0.5;
    task.asked.unit = "deg";
    CHECK(accuracy_text(task) == "Each number may be off by 0.5 deg.");
    exercise.kind = ExerciseKind::choose;
    CHECK(accuracy_text(task).empty());
    exercise.kind = ExerciseKind::vector;
    task.asked.tolerance = 0.0;
    CHECK(accuracy_text(task).empty());
}

TEST_CASE(
    "Joints that are none of those asked for earn nothing, and some of the right ones a part",
    "[exercises]") {
    const std::string perpendicular = "axis_i = [1, 0, 0]\naxis_j = [0, 1, 0]\n";
    const std::string upright = "axis_i = [0, 0, 1]\naxis_j = [0, 0, 1]\n";
    const std::string at_origin = "point_i = [0, 0, 0]\npoint_j = [0, 0, 0]\n";
    const std::string far = "point_i = [5, 5, 5]\npoint_j = [-7, 0, 3]\n";
    const std::string near = "point_i = [0.1, 0, 0]\npoint_j = [0.1, 0.2, 0]\n";
    const ExercisesRead read =
        read_exercise_file(std::filesystem::path(JW_EXERCISES_FOLDER) / "building.toml");
    REQUIRE(read.exercises.size() >= 8);
    for (const Exercise& exercise : read.exercises) {
        const Task task = TaskMaker(exercise).make(11);
        REQUIRE(task.problem.empty());
        const std::string scene = handed_out(task);
        const auto joint = [&](const std::string& name, const std::string& type, const std::string& keys) {
            return joint_to_last_body(scene, name, type, keys);
        };
        const std::string nonsense[] = {
            joint("x", "n1", perpendicular),
            joint("x", "spherical", at_origin),
            joint("x", "spherical", far) + joint("y", "n1", perpendicular),
            // five equations, as many as a hinge has
            joint("x", "revolute", at_origin + upright),
            joint("x", "spherical", near) + joint("y", "n1", perpendicular) +
                joint("z", "n1", "axis_i = [0, 1, 0]\naxis_j = [0, 0, 1]\n"),
        };
        for (const std::string& added : nonsense) {
            const Judged judged = judge_build(task, {scene + added, {}});
            CAPTURE(exercise.name, added, judged.feedback);
            CHECK_FALSE(judged.right);
            CHECK(judged.share == 0.0);
        }
    }
    const Shipped trammel("building.toml", "trammel");
    const std::string& solution = trammel.task.exercise().solution;
    const std::string two_of_three = solution.substr(0, solution.rfind("[[joint]]"));
    const Judged judged = judge_build(trammel.task, {handed_out(trammel.task) + "\n" + two_of_three, {}});
    CHECK(judged.mistake == "joint-missing");
    CHECK(judged.share > 0.0);
    CHECK(judged.share < 0.5);
}

TEST_CASE("Claims that already hold in the faulty lesson earn no points", "[exercises]") {
    const ExercisesRead read = read_exercise_file(std::filesystem::path(JW_EXERCISES_FOLDER) / "clinic.toml");
    int repairs = 0;
    for (const Exercise& exercise : read.exercises) {
        if (exercise.kind != ExerciseKind::repair) { continue; }
        ++repairs;
        const Task task = TaskMaker(exercise).make(11);
        REQUIRE(task.problem.empty());
        const Judged judged = judge_repair(
            task, {handed_out(task) + "\n[[body]]\nname = \"nothing to do with it\"\nfixed = true\n", {}});
        CAPTURE(exercise.name, judged.feedback);
        CHECK(judged.understood);
        CHECK_FALSE(judged.right);
        CHECK(judged.share == 0.0);
    }
    CHECK(repairs >= 10);
}
