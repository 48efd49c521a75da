#include <catch2/catch.hpp>

#include "app/session/answers/right_answer.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/view/view.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"

namespace jw::test {

namespace {

const char* const kHinge = R"(format = 1
title = "A hinge"

[[body]]
name = "lever"
position = [0.1, 0, 0.7]
rotation = { axis = [1, 0.4, 0], angle_deg = 10 }

[[joint]]
name = "hinge"
type = "revolute"
bodies = ["ground", "lever"]
point_i = [0, 0, 0.8]
point_j = [0, 0, 0]
axis_i = [0, -0.6, 0.8]
axis_j = [0, 0, 1]

[[driver]]
name = "motor"
joint = "hinge"
quantity = "angle"
polynomial_deg = [0, 90]

[motion]
to_s = 2
steps = 4

[[question]]
at = "bodies"
ask = 'Is $\mathbf{s}_i$ fixed?'
choices = ["no", "yes, in the ground"]
answer = 2
why = "It belongs to the ground."

[[question]]
at = "hinge"
ask = "How many freedoms are left?"
count = "dof"
why = "Six minus five."

[[question]]
at = "hinge"
ask = "Which equation is left out?"
dropped = "hinge p1"

[[question]]
at = "motion"
ask = "Where is it after a second and a half?"
quantity = "hinge.angle"
at_s = 1.5
tolerance_deg = 1
)";

Lesson lesson_of_text(const std::string& text) {
    const ReadResult read = read_lesson(text, "hinge.toml");
    INFO(read.report());
    REQUIRE(read.lesson);
    return *read.lesson;
}

/// Steps of a kind about a question.
std::vector<int> steps_of(const Story& story, Step::Kind kind, int question) {
    std::vector<int> found;
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        if (step.kind == kind && step.question == question) { found.push_back(static_cast<int>(k)); }
    }
    return found;
}

GivenAnswer judged(const Story& story, int question, const std::string& given) {
    const int asked = steps_of(story, Step::Kind::question, question).at(0);
    const int answered = steps_of(story, Step::Kind::answer, question).at(0);
    const Question& q = story.lesson().questions[static_cast<std::size_t>(question)];
    const RightAnswer right = right_answer(story, q, story.steps()[static_cast<std::size_t>(answered)]);
    return judge_answer(*view_of(story, asked).question, right, story.lesson().mechanism, given);
}

/// The right answer as somebody types it.
std::string typed_answer(const QuestionView& view, const RightAnswer& right, const Lesson& lesson) {
    if (right.pose) { return pose_text(*right.pose); }
    if (!right.things.empty()) { return name_of(right.things.back(), lesson.mechanism); }
    return right.choice >= 0 ? std::to_string(right.choice + 1) : view.answer;
}

}  // namespace

TEST_CASE("a question is asked before its step and answered after it", "[app][questions]") {
    const Lesson lesson = lesson_of_text(kHinge);
    const Story story(lesson);
    REQUIRE(story.failure() == nullptr);
    using Kind = Step::Kind;
    const auto kind_at = [&](int k) { return story.steps()[static_cast<std::size_t>(k)].kind; };
    for (int q = 0; q < 4; ++q) {
        CAPTURE(q);
        REQUIRE(steps_of(story, Kind::question, q).size() == 1);
        REQUIRE(steps_of(story, Kind::answer, q).size() == 1);
        CHECK(steps_of(story, Kind::question, q)[0] < steps_of(story, Kind::answer, q)[0]);
    }
    CHECK(kind_at(steps_of(story, Kind::question, 2)[0] + 1) == Kind::equations);
    CHECK(kind_at(steps_of(story, Kind::answer, 1)[0] - 1) == Kind::assembled);
    CHECK(kind_at(steps_of(story, Kind::question, 3)[0] + 1) == Kind::motion);
    CHECK(steps_of(story, Kind::answer, 3)[0] + 1 == static_cast<int>(story.steps().size()));
    CHECK(kind_at(story.last_assembled()) == Kind::assembled);
}

TEST_CASE("answers are computed from the scene", "[app][questions]") {
    const Lesson lesson = lesson_of_text(kHinge);
    const Story story(lesson);
    const auto answer = [&](int q) {
        return view_of(story, steps_of(story, Step::Kind::answer, q)[0]).question->answer;
    };
    CHECK(answer(0) == "yes, in the ground");
    CHECK(answer(1) == "1");
    CHECK(answer(2) == "z");
    CHECK(answer(3) == "135 deg");
    // a question does not show its answer
    for (int q = 0; q < 4; ++q) {
        CHECK(view_of(story, steps_of(story, Step::Kind::question, q)[0]).question->answer.empty());
    }
    const std::string told = describe(view_of(story, steps_of(story, Step::Kind::answer, 1)[0]));
    CHECK_THAT(told, Catch::Contains("How many freedoms are left?") && Catch::Contains("Six minus five."));
}

TEST_CASE("answers are understood with units, as fractions and by their number", "[app][questions]") {
    const Lesson lesson = lesson_of_text(kHinge);
    const Story story(lesson);
    struct Given {
        int question;
        const char* text;
        bool understood;
        bool right;
    };
    for (const Given& given : std::initializer_list<Given>{
             {0, "2", true, true},        {0, "yes", true, true},     {0, "1", true, false},
             {0, "3", false, false},      {0, "maybe", false, false}, {0, "", false, false},
             {1, "1", true, true},        {1, " 2 / 2 ", true, true}, {1, "2", true, false},
             {1, "one", false, false},    {2, "z", true, true},       {2, "3", true, true},
             {2, "x", true, false},       {3, "135", true, true},     {3, "135.9 deg", true, true},
             {3, "-225 deg", true, true}, {3, "137", true, false},    {3, "1/0", false, false},
             {3, "nan", false, false},    {3, "135 m", false, false}}) {
        CAPTURE(given.question, given.text);
        const GivenAnswer answer = judged(story, given.question, given.text);
        CHECK(answer.understood == given.understood);
        CHECK(answer.right == given.right);
        CHECK_FALSE(answer.note.empty());
    }
}

TEST_CASE(
    "an answer of dynamics is that of its own time, between the moments of the story", "[app][questions]") {
    const Lesson lesson = lesson_of_text(R"(format = 1
title = "A stone"

[[body]]
name = "stone"
position = [0, 0, 100]
velocity = [0, 0, 3]
mass = 2
inertia = [1, 1, 1]

[dynamics]
gravity = [0, 0, -10]
duration = 4

[[question]]
at = "motion"
ask = "How high?"
quantity = "stone.z"
at_s = 1.2345
tolerance = 1e-6
)");
    StoryOptions few;
    few.intervals = 3;
    const Story story(lesson, few);
    const int answered = steps_of(story, Step::Kind::answer, 0).at(0);
    const RightAnswer right =
        right_answer(story, lesson.questions[0], story.steps()[static_cast<std::size_t>(answered)]);
    REQUIRE(right.known);
    CHECK(right.number == Approx(100.0 + 3.0 * 1.2345 - 5.0 * 1.2345 * 1.2345).epsilon(1e-12));
}

TEST_CASE("every question of every shipped lesson has an answer", "[app][questions]") {
    int questions = 0;
    for (const auto& file : lessons_below(catalogue_folder())) {
        const ReadResult read = read_lesson_file(file);
        REQUIRE(read.lesson);
        if (read.lesson->questions.empty()) { continue; }
        const Story story(*read.lesson);
        for (const Step& step : story.steps()) {
            if (step.kind != Step::Kind::answer) { continue; }
            const Question& question = question_of(*read.lesson, step);
            CAPTURE(file, question.ask);
            const RightAnswer right = right_answer(story, question, step);
            CHECK(right.known);
            ++questions;
            // what is right is judged to be right when it is typed
            const QuestionView view = question_view_of(story, step);
            CHECK(judge_answer(view, right, read.lesson->mechanism, typed_answer(view, right, *read.lesson))
                      .right);
        }
    }
    CHECK(questions > 50);
}

TEST_CASE("a question about a joint goes with it, and the others stay", "[app][questions]") {
    Lesson lesson = lesson_of_text(kHinge);
    lesson.order.pop_back();  // the motor
    lesson.motion.reset();
    const Story story(lesson);
    CHECK(steps_of(story, Step::Kind::question, 1).size() == 1);
    CHECK(steps_of(story, Step::Kind::question, 3).empty());
}

}  // namespace jw::test
