#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "app/session/answers/right_answer.hpp"
#include "app/session/picture/pointable.hpp"
#include "app/session/try/session.hpp"
#include "core/equations/assembler.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"
#include "tests/support/grown_mechanisms.hpp"
#include "tests/support/long_double_svd.hpp"

/// Questions that are answered by pointing at an object or by moving a body by hand.
namespace jw::test {

namespace {

Lesson four_bar() { return *read_lesson_file(catalogue_folder() / "loops/four-bar.toml").lesson; }

/// A question at the end of `lesson`'s text.
Lesson asking(const std::string& question) {
    const std::string text = lesson_text(four_bar()) + "\n[[question]]\n" + question;
    ReadResult read = read_lesson(text, "asking.toml");
    INFO(read.report());
    REQUIRE(read.lesson);
    return *read.lesson;
}

int last_question(const Lesson& lesson) { return static_cast<int>(lesson.questions.size()) - 1; }

int step_of(const Story& story, Step::Kind kind, int question) {
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        if (step.kind == kind && step.question == question) { return static_cast<int>(k); }
    }
    FAIL("the story does not tell this question");
    return -1;
}

GivenAnswer judged_by_pointing(const Story& story, int question, const std::string& given) {
    const View view = view_of(story, step_of(story, Step::Kind::question, question));
    return judge_answer(*view.question, right_answer(story, question), story.lesson().mechanism, given);
}

/// A lesson that adds every joint and driver of a mechanism that is assembled.
Lesson lesson_of_mechanism(Mechanism mechanism) {
    Lesson lesson;
    lesson.mechanism = std::move(mechanism);
    lesson.step_texts.joints.resize(lesson.mechanism.joints.size());
    lesson.step_texts.drivers.resize(lesson.mechanism.drivers.size());
    lesson.looks.resize(lesson.mechanism.bodies.size());
    for (int k = 0; k < static_cast<int>(lesson.mechanism.joints.size()); ++k) {
        lesson.order.push_back({Addition::Kind::joint, k});
    }
    for (int k = 0; k < static_cast<int>(lesson.mechanism.drivers.size()); ++k) {
        lesson.order.push_back({Addition::Kind::driver, k});
    }
    return lesson;
}

/// Number of singular values that are not rounding: grown mechanisms have none between 1e-10 and 1e-7 of the
/// largest where the program is sure of the rank.
int rank_by_singular_values(const MatrixX& matrix) {
    const VectorX values = long_double_singular_values(matrix);
    return static_cast<int>((values.array() > 1e-9 * values.maxCoeff()).count());
}

MatrixX without_row(const MatrixX& matrix, int row) {
    MatrixX less(matrix.rows() - 1, matrix.cols());
    less << matrix.topRows(row), matrix.bottomRows(matrix.rows() - 1 - row);
    return less;
}

int rank_without(const Lesson& lesson, const Thing& row) {
    Lesson less = lesson;
    less.mechanism.joints[static_cast<std::size_t>(row.index)].without.push_back(row.equation);
    const Story story(less);
    REQUIRE(story.failure() == nullptr);
    const Step& step = story.steps()[static_cast<std::size_t>(story.last_assembled())];
    return rank_of(*step.system, step.state, step.t).rank;
}

}  // namespace

TEST_CASE(
    "rows that are right for 'redundant' can each be left out without losing rank, and no other can",
    "[app][questions]") {
    const Lesson lesson =
        asking("at = \"motion\"\nask = \"Which?\"\nclick = \"row\"\nrows = \"redundant\"\n");
    const Story story(lesson);
    const RightAnswer right = right_answer(story, last_question(lesson));
    REQUIRE(right.known);
    const Step& step = story.steps()[static_cast<std::size_t>(story.last_assembled())];
    const int rank = rank_of(*step.system, step.state, step.t).rank;
    int needed = 0;
    for (int k = 0; k < step.system->rows(); ++k) {
        const auto row = thing_of_row(*step.system, k);
        if (!row || row->driven) { continue; }
        CAPTURE(name_of(*row, lesson.mechanism));
        const bool said = std::ranges::find(right.things, *row) != right.things.end();
        CHECK(said == (rank_without(lesson, *row) == rank));
        needed += said ? 0 : 1;
    }
    CHECK(needed > 0);
}

TEST_CASE(
    "rows that are right for 'redundant' are those without which the spectrum keeps its rank, in grown "
    "mechanisms",
    "[app][questions]") {
    int redundant = 0;
    int needed = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        CAPTURE(seed);
        Lesson lesson = lesson_of_mechanism(grown_mechanism(seed, 2 + static_cast<int>(seed % 5), 2));
        lesson.questions.push_back(
            {Question::Place::addition,
             lesson.order.back(),
             {},
             PointedAnswer{Thing::Kind::row, {}, RowsFound::redundant},
             {},
             {}});
        const Story story(lesson);
        REQUIRE(story.failure() == nullptr);
        const Step& step = story.steps()[static_cast<std::size_t>(story.last_assembled())];
        if (!rank_of(*step.system, step.state, step.t).decided) {
            CHECK_FALSE(right_answer(story, 0).known);
            continue;
        }
        const RightAnswer right = right_answer(story, 0);
        Assembler<OmegaLocal> assembler(*step.system);
        assembler.assemble_phi_and_jacobian(step.state, step.t);
        const MatrixX jacobian = assembler.jacobian().topRows(step.system->rows());
        const int rank = rank_by_singular_values(jacobian);
        for (int k = 0; k < step.system->rows(); ++k) {
            CAPTURE(k);
            const auto row = thing_of_row(*step.system, k);
            REQUIRE(row);
            const bool said = std::ranges::find(right.things, *row) != right.things.end();
            CHECK(said == (rank_by_singular_values(without_row(jacobian, k)) == rank));
            (said ? redundant : needed) += 1;
        }
    }
    CHECK(redundant > 500);
    CHECK(needed > 500);
}

TEST_CASE(
    "rows that are right for 'dropped' lie along the largest component of the axis, in grown mechanisms",
    "[app][questions]") {
    int dropped = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        CAPTURE(seed);
        Lesson lesson = lesson_of_mechanism(grown_mechanism(seed, 2 + static_cast<int>(seed % 5), 2));
        const std::vector<Joint>& joints = lesson.mechanism.joints;
        for (int k = 0; k < static_cast<int>(joints.size()); ++k) {
            lesson.questions.push_back(
                {Question::Place::addition,
                 {Addition::Kind::joint, k},
                 {},
                 PointedAnswer{Thing::Kind::row, {}, RowsFound::dropped},
                 {},
                 {}});
        }
        const Story story(lesson);
        REQUIRE(story.failure() == nullptr);
        for (int k = 0; k < static_cast<int>(joints.size()); ++k) {
            const Joint& joint = joints[static_cast<std::size_t>(k)];
            if (joint.parallel_form != ParallelForm::rule || !joint.without.empty()) { continue; }
            CAPTURE(joint.name);
            const Step& step = story.steps()[static_cast<std::size_t>(step_of(story, Step::Kind::answer, k))];
            const Vec4& p = step.state.p[static_cast<std::size_t>(joint.body_i)];
            const Vec3 s_i =
                Eigen::Quaterniond(p(0), p(1), p(2), p(3)) * joint.geometry.s_i_local.normalized();
            std::set<Role> roles;
            for (const Thing& row : things_of(lesson.mechanism, Thing::Kind::row)) {
                if (!row.driven && row.index == k && is_parallel(row.equation.role)) {
                    roles.insert(row.equation.role);
                }
            }
            const RightAnswer right = right_answer(story, k);
            CHECK(right.known == !roles.empty());
            CHECK(right.things.size() == roles.size());
            for (const Thing& row : right.things) {
                CHECK(row.index == k);
                CHECK(roles.erase(row.equation.role) == 1);
                // an earlier choice is kept while its component is no smaller than 0.8 of the largest
                CHECK(std::abs(s_i(row.equation.component)) >= 0.8 * s_i.cwiseAbs().maxCoeff() - 1e-12);
                ++dropped;
            }
        }
    }
    CHECK(dropped > 300);
}

TEST_CASE("a turn is measured to its last digits, small or large, by p of either sign", "[app][questions]") {
    Random random(7);
    for (int k = 0; k < 1000; ++k) {
        const double angle = std::pow(10.0, random.number(-9.0, 0.49));
        const Vec3 axis = random.direction();
        const Eigen::Quaterniond first(random.number(), random.number(), random.number(), random.number());
        const Eigen::Quaterniond from = first.normalized();
        const Eigen::Quaterniond to = from * Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
        const double sign = k % 2 == 0 ? 1.0 : -1.0;
        const BodyPose a{{}, Vec4(from.w(), from.x(), from.y(), from.z())};
        const BodyPose b{{}, sign * Vec4(to.w(), to.x(), to.y(), to.z())};
        // rounding of unit quaternions is some 1e-16
        CHECK(a.turn_from(b) == Approx(angle).epsilon(1e-12).margin(2e-15));
    }
}

TEST_CASE("rows that are left out are those of the system that has been chosen", "[app][questions]") {
    const Lesson lesson = asking("at = \"C\"\nask = \"Which?\"\nclick = \"row\"\nrows = \"dropped\"\n");
    const Story story(lesson);
    const int q = last_question(lesson);
    CHECK(judged_by_pointing(story, q, "C p1 y").right);
    CHECK(judged_by_pointing(story, q, "  C  p1  y ").right);
    CHECK_FALSE(judged_by_pointing(story, q, "A p1 y").right);
    CHECK(judged_by_pointing(story, q, "A p1 y").understood);
    CHECK_FALSE(judged_by_pointing(story, q, "C p1").understood);
    CHECK_FALSE(judged_by_pointing(story, q, "").understood);
    CHECK_FALSE(judged_by_pointing(story, q, "3").understood);
    // equations of a joint can be clicked before it is added, and do not tell which of them stay
    const int asked = step_of(story, Step::Kind::question, q);
    const View view = view_of(story, asked);
    const Step& step = story.steps()[static_cast<std::size_t>(asked)];
    std::set<std::string> names;
    for (const EquationGroup& group : view.equations) {
        CHECK_FALSE(group.choice);
        for (const EquationRow& row : group.rows) {
            CHECK(row.status == EquationRow::Status::open);
            CHECK(row.row < 0);
            const auto thing =
                thing_at(step, view, Pointable::equation(group.joint, row.equation), Thing::Kind::row);
            REQUIRE(thing);
            names.insert(name_of(*thing, lesson.mechanism));
        }
    }
    CHECK(names == std::set<std::string>{"C s x", "C s y", "C s z", "C p1 x", "C p1 y", "C p1 z"});
}

TEST_CASE("what is clicked means a thing of the kind that is asked for, or nothing", "[app][questions]") {
    const Lesson lesson = four_bar();
    const Story story(lesson);
    const int assembled = story.last_assembled();
    const View view = view_of(story, assembled);
    const Step& step = story.steps()[static_cast<std::size_t>(assembled)];
    using Kind = Thing::Kind;
    CHECK(thing_at(step, view, Pointable::body(2), Kind::body) == Thing::body(2));
    CHECK_FALSE(thing_at(step, view, Pointable::body(2), Kind::joint));
    CHECK(thing_at(step, view, Pointable::vector(1, 0), Kind::vector) == Thing::vector(1, 0));
    CHECK(thing_at(step, view, Pointable::vector(1, 0), Kind::joint) == Thing::joint(1));
    CHECK(thing_at(step, view, Pointable::column(8), Kind::body) == Thing::body(2));
    CHECK(thing_at(step, view, Pointable::row(3), Kind::row) == Thing::row(0, {Role::axes_parallel, 0}));
    CHECK_FALSE(thing_at(step, view, Pointable{}, Kind::row));
    CHECK_FALSE(thing_at(step, view, Pointable::symbol(9999), Kind::vector));
}

TEST_CASE("every thing is found by its own name", "[app][questions]") {
    for (const auto& file : lessons_below(catalogue_folder())) {
        const Lesson lesson = *read_lesson_file(file).lesson;
        for (const auto kind :
             {Thing::Kind::body, Thing::Kind::joint, Thing::Kind::vector, Thing::Kind::row}) {
            for (const Thing& thing : things_of(lesson.mechanism, kind)) {
                CAPTURE(file, name_of(thing, lesson.mechanism));
                CHECK(thing_named(lesson.mechanism, kind, name_of(thing, lesson.mechanism)) == thing);
            }
        }
    }
}

TEST_CASE("every thing is where a click on it means it", "[app][questions]") {
    int left_out = 0;
    for (const auto& file : lessons_below(catalogue_folder())) {
        const Lesson lesson = *read_lesson_file(file).lesson;
        const Story story(lesson);
        const int assembled = story.last_assembled();
        const View view = view_of(story, assembled);
        const Step& step = story.steps()[static_cast<std::size_t>(assembled)];
        for (const auto kind :
             {Thing::Kind::body, Thing::Kind::joint, Thing::Kind::vector, Thing::Kind::row}) {
            for (const Thing& thing : things_of(lesson.mechanism, kind)) {
                const Pointable place = place_of(step, thing);
                CAPTURE(file, name_of(thing, lesson.mechanism));
                // a loop that cannot be closed lacks its last joint and what drives it
                if (story.failure() != nullptr && !place) { continue; }
                CHECK(thing_at(step, view, place, kind) == thing);
                left_out += place.kind == Pointable::Kind::equation ? 1 : 0;
            }
        }
    }
    CHECK(left_out > 100);
}

TEST_CASE("at an answer the things that are right are lit, at the question nothing is", "[app][questions]") {
    int answers = 0;
    for (const auto& file : lessons_below(catalogue_folder())) {
        const Lesson lesson = *read_lesson_file(file).lesson;
        const Story story(lesson);
        for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
            const Step& step = story.steps()[static_cast<std::size_t>(k)];
            if (!is_asked(step.kind)) { continue; }
            const View view = view_of(story, k);
            if (view.question->kind != QuestionView::Kind::thing) { continue; }
            CAPTURE(file, view.question->ask);
            Emphasis lit;
            light_answer(step, lesson.coordinates, view, lit);
            CHECK(lit.empty() == (step.kind == Step::Kind::question));
            for (const Thing& thing : right_answer(story, step.question).things) {
                CHECK(lit.contains(place_of(step, thing)) == (step.kind == Step::Kind::answer));
                ++answers;
            }
        }
    }
    CHECK(answers >= 10);
}

TEST_CASE("a pose is judged by its point and its turn, whichever sign p has", "[app][questions]") {
    const Lesson lesson = asking(
        "at = \"motion\"\nask = \"Where?\"\npose = \"rocker\"\nat_s = 1\ntolerance = 0.01\ntolerance_deg = "
        "2\n");
    const Story story(lesson);
    const int q = last_question(lesson);
    const RightAnswer right = right_answer(story, q);
    REQUIRE(right.pose);
    // about -y, as the four-bar's own claim says
    CHECK(2.0 * std::acos(std::abs(right.pose->p(0))) * 180.0 / std::numbers::pi == Approx(124.821288264128));
    CHECK(judged_by_pointing(story, q, pose_text(*right.pose)).right);
    BodyPose other = *right.pose;
    other.p = -other.p;
    CHECK(judged_by_pointing(story, q, pose_text(other)).right);
    const auto turned = [&](double degrees) {
        const double half = 0.5 * degrees * std::numbers::pi / 180.0;
        const Eigen::Quaterniond p(right.pose->p(0), right.pose->p(1), right.pose->p(2), right.pose->p(3));
        const Eigen::Quaterniond q_turn(std::cos(half), 0.0, 0.0, std::sin(half));
        const Eigen::Quaterniond sum = p * q_turn;
        return BodyPose{right.pose->r, {sum.w(), sum.x(), sum.y(), sum.z()}};
    };
    CHECK(judged_by_pointing(story, q, pose_text(turned(1.99))).right);
    CHECK_FALSE(judged_by_pointing(story, q, pose_text(turned(2.01))).right);
    CHECK_THAT(judged_by_pointing(story, q, pose_text(turned(30.0))).note, Catch::Contains("30°"));
    BodyPose shifted = *right.pose;
    shifted.r += Vec3(0.0, 0.0, 0.011);
    CHECK_FALSE(judged_by_pointing(story, q, pose_text(shifted)).right);
    for (const char* const given : {"", "1 2 3", "0.5 0 0.4 0 0 0 0", "a b c d e f g", "nan 0 0 1 0 0 0"}) {
        CAPTURE(given);
        CHECK_FALSE(judged_by_pointing(story, q, given).understood);
    }
}

TEST_CASE("a body that is led somewhere at a question is an answer and no edit", "[app][questions]") {
    Session session(four_bar());
    const Story& story = session.story();
    int asked = -1;
    for (std::size_t k = 0; k < story.steps().size() && asked < 0; ++k) {
        const Step& step = story.steps()[k];
        if (step.kind != Step::Kind::question) { continue; }
        const Question& q = question_of(session.lesson(), step);
        if (std::holds_alternative<PoseAnswer>(q.answer)) { asked = static_cast<int>(k); }
    }
    REQUIRE(asked >= 0);
    session.apply(GoTo{asked});
    CHECK(session.asks_for_pose());
    const Vec3 tip(0.4, 0.0, 0.0);
    for (int k = 0; k < 20; ++k) {
        // to 60 degrees
        session.apply(Drag{1, tip, Vec3(-0.5 + 0.4 * 0.5, 0.0, 0.4 + 0.4 * std::sqrt(0.75))});
    }
    session.apply(Release{});
    CHECK(session.in_hand());
    CHECK_FALSE(session.is_changed());
    CHECK(session.view().kind == Step::Kind::question);
    const State& state = session.step().state;
    const int question = session.story().steps()[static_cast<std::size_t>(asked)].question;
    CHECK(judged_by_pointing(session.story(), question, pose_text({state.r[1], state.p[1]})).right);
    session.apply(GoTo{asked + 1});
    CHECK_FALSE(session.in_hand());
    CHECK_FALSE(session.is_changed());
    // everywhere else it is one
    session.apply(GoTo{session.story().last_assembled()});
    CHECK_FALSE(session.asks_for_pose());
}

}  // namespace jw::test
