#include <catch2/catch.hpp>

#include "app/session/story/story.hpp"
#include "app/session/view/view.hpp"
#include "core/equations/assembler.hpp"
#include "tests/app/program.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

StoryOptions no_motion() {
    StoryOptions options;
    options.with_motion = false;
    return options;
}

StoryOptions motion_in(int intervals) {
    StoryOptions options;
    options.intervals = intervals;
    return options;
}

std::vector<View> assembled_views(const Story& story) {
    std::vector<View> views;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        if (story.steps()[static_cast<std::size_t>(k)].kind == Step::Kind::assembled) {
            views.push_back(view_of(story, k));
        }
    }
    return views;
}

}  // namespace

TEST_CASE("a story goes from the bodies joint by joint over the drivers to the motion", "[app][story]") {
    const Lesson lesson = lesson_named("loops/four-bar");
    const Story story(lesson);
    int additions = 0;
    Step::Kind last = Step::Kind::bodies;
    REQUIRE(story.steps().front().kind == Step::Kind::bodies);
    for (std::size_t k = 1; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        switch (step.kind) {
            case Step::Kind::equations:
                CHECK((last == Step::Kind::bodies || last == Step::Kind::assembled || is_asked(last)));
                CHECK(step.additions == ++additions);
                break;
            case Step::Kind::iteration:
                CHECK((last == Step::Kind::equations || last == Step::Kind::iteration));
                break;
            case Step::Kind::assembled:
                CHECK((last == Step::Kind::equations || last == Step::Kind::iteration));
                break;
            case Step::Kind::motion:
                CHECK((last == Step::Kind::assembled || last == Step::Kind::motion || is_asked(last)));
                break;
            case Step::Kind::question:
            case Step::Kind::answer: CHECK(last != Step::Kind::iteration); break;
            case Step::Kind::bodies:
            case Step::Kind::failed: FAIL("unexpected step " << k);
        }
        last = step.kind;
    }
    CHECK(additions == static_cast<int>(lesson.order.size()));
    // the lesson ends with a question about the motion
    CHECK(last == Step::Kind::answer);
    CHECK(story.failure() == nullptr);
}

TEST_CASE("the last joint of a four-bar adds five equations of which three are redundant", "[app][story]") {
    const Lesson lesson = lesson_named("loops/four-bar");
    const Story story(lesson, no_motion());
    const std::vector<View> views = assembled_views(story);
    REQUIRE(views.size() == 5);
    CHECK(views[0].rank.rank == 5);
    CHECK(views[1].rank.rank == 10);
    CHECK(views[2].rank.rank == 15);
    CHECK(views[3].rank.rank == 17);
    CHECK(views[3].rank.rows == 20);
    CHECK(views[3].rank.redundant_rows.size() == 3);
    CHECK(
        views[3].sentence.starts_with("Joint D adds 5 equations, the rank grows by 2 (15 → 17): three are "
                                      "redundant, implied by A, B and C. "
                                      "1 freedom is left."));
    CHECK(views[4].rank.dof == 0);
    for (const std::string& label : views[3].rank.redundant_rows) { CHECK(label.starts_with("D · ")); }
}

TEST_CASE("iterations of a step end below the tolerance and shrink quadratically", "[app][story]") {
    const Lesson lesson = lesson_named("loops/four-bar");
    const Story story(lesson, no_motion());
    for (const View& view : assembled_views(story)) {
        REQUIRE_FALSE(view.newton.empty());
        CHECK(view.newton.back().note == "closed");
        // the first look, the steps, the last look
        CHECK(view.newton.size() <= 8);
        CHECK(view.rank.residual < 1e-12);
    }
}

TEST_CASE(
    "every equation holds at every moment, left-out ones included, however large the intervals",
    "[app][story]") {
    const Lesson lesson = lesson_named("parallel/which-two-of-three");
    for (const int intervals : {2, 3, 5, 8, 100}) {
        const Story story(lesson, motion_in(intervals));
        REQUIRE(story.failure() == nullptr);
        for (const Step& step : story.steps()) {
            if (step.kind != Step::Kind::assembled && step.kind != Step::Kind::motion) { continue; }
            for (const Constraint& c : step.system->constraints()) {
                // Newton's 1e-13, passed on by the kept pair with its condition of at most 2.2
                INFO(intervals << " intervals, t = " << step.t);
                CHECK(values_of(c, step.state).cwiseAbs().maxCoeff() < 1e-12);
            }
        }
    }
}

TEST_CASE("before assembly a view says the rank here and the rank once assembled", "[app][story]") {
    // at the start estimate all three rows of p1 are independent; at the solution one is redundant
    const Lesson lesson = lesson_named("parallel/parallel-vectors");
    const Story story(lesson, no_motion());
    int looked_at = 0;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        const View view = view_of(story, k);
        const bool before = view.kind == Step::Kind::equations || view.kind == Step::Kind::iteration;
        CHECK(view.rank.once_assembled.has_value() == before);
        if (view.kind != Step::Kind::equations || view.title.rfind("Joint p1", 0) != 0) { continue; }
        ++looked_at;
        CHECK(view.rank.rank == 11);
        CHECK(view.rank.once_assembled == 10);
        CHECK_THAT(view.sentence, Catch::Contains("Rank 11 here, 10 once assembled"));
        CHECK_THAT(describe(view), Catch::Contains("Rank 11 here, 10 once assembled"));
        CHECK(json_of(story, k)["steps"].back()["rank"]["rank_once_assembled"] == 10);
    }
    CHECK(looked_at == 1);
}

TEST_CASE("a rank that assembly does not change is said once", "[app][story]") {
    const Lesson lesson = lesson_named("loops/four-bar");
    const Story story(lesson, no_motion());
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        const View view = view_of(story, k);
        const bool differs = view.rank.once_assembled && *view.rank.once_assembled != view.rank.rank;
        CAPTURE(k, view.sentence);
        CHECK((view.sentence.find("once assembled") != std::string::npos) == differs);
    }
}

TEST_CASE("a view says so exactly where the choice of rows has changed", "[app][story]") {
    const Lesson lesson = lesson_named("parallel/which-two-of-three");
    const Story story(lesson);
    int switches = 0;
    for (int k = 1; k < static_cast<int>(story.steps().size()); ++k) {
        const Step& step = story.steps()[static_cast<std::size_t>(k)];
        if (step.kind != Step::Kind::motion) { continue; }
        bool switched = false;
        for (const EquationGroup& group : view_of(story, k).equations) {
            switched = switched || (group.choice && group.choice->switched);
        }
        CHECK(switched == step.rows_switched);
        switches += switched ? 1 : 0;
    }
    // z to x, x to y, y to z in one turn
    CHECK(switches == 3);
}

TEST_CASE("a lesson without motion ends when the mechanism is assembled", "[app][story]") {
    const Folder folder;
    const std::string text(kCrank);
    const ReadResult read = read_lesson(text.substr(0, text.find("[motion]")), "crank.toml");
    REQUIRE(read.lesson.has_value());
    const Story story(*read.lesson);
    CHECK(story.steps().back().kind == Step::Kind::assembled);
}

TEST_CASE("views of one story are equal however often they are made", "[app][story]") {
    const Lesson lesson = lesson_named("parallel/which-two-of-three");
    const Story one(lesson);
    const Story two(lesson);
    REQUIRE(one.steps().size() == two.steps().size());
    for (int k = 0; k < static_cast<int>(one.steps().size()); ++k) {
        const View a = view_of(one, k);
        const View b = view_of(two, k);
        CHECK(a.sentence == b.sentence);
        CHECK(a.matrix.values == b.matrix.values);  // to the last bit
        CHECK(a.rank.singular_values == b.rank.singular_values);
    }
}

}  // namespace jw::test
