#include <catch2/catch.hpp>

#include <sstream>

#include "app/session/try/possible_experiments.hpp"
#include "tests/app/program.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

/// Remembers how much had been written whenever it was flushed.
class Flushed : public std::stringbuf {
public:
    const std::vector<std::size_t>& sizes() const { return sizes_; }

protected:
    int sync() override {
        sizes_.push_back(str().size());
        return 0;
    }

private:
    std::vector<std::size_t> sizes_;
};

}  // namespace

TEST_CASE("try hands out each joint's experiments as soon as it knows them", "[app][try]") {
    Flushed buffer;
    std::ostream out(&buffer);
    std::ostringstream err;
    REQUIRE(run_program({"try", lesson_path("loops/four-bar.toml")}, Streams{out, err, false}) == 0);
    const std::string text = buffer.str();
    // the head, four joints, a driver, the rest
    REQUIRE(buffer.sizes().size() >= 7);
    CHECK(text.find("A · revolute") >= buffer.sizes()[0]);
    CHECK(text.find("A · revolute") < buffer.sizes()[1]);
    CHECK(text.find("B · revolute") >= buffer.sizes()[1]);
    CHECK(text.size() == buffer.sizes().back());
}

TEST_CASE("The experiments told one by one are those told at once", "[app][try]") {
    for (const char* const name :
         {"loops/bennett", "hard/cannot-close", "joints/screw", "dynamics/andrews"}) {
        CAPTURE(name);
        const Lesson lesson = lesson_named(name);
        Session session(lesson, false);
        session.apply(GoTo{session.story().last_assembled()});
        std::string pieces;
        std::optional<ExperimentsText> text;
        const PossibleExperiments all = possible_experiments_of(
            session, {[&](const PossibleExperiments& outline) {
                          text.emplace(outline, lesson);
                          pieces += text->head();
                      },
                      [&](const ExperimentGroup& group) { pieces += text->group(group); }});
        pieces += text->rest(all);
        CHECK(pieces == describe(all, lesson));
        // the motion does not change what can be tried at the step where everything is assembled
        Session whole(lesson);
        whole.apply(GoTo{whole.story().last_assembled()});
        CHECK(describe(possible_experiments_of(whole), lesson) == pieces);
    }
}

TEST_CASE("A verdict for an experiment is that of the whole analysis", "[app][try]") {
    std::vector<std::filesystem::path> files = all_lesson_files();
    for (const char* const large :
         {"chain-revolute-16.toml", "chain-spherical-16.toml", "four-bar-16.toml"}) {
        files.push_back(catalogue_folder().parent_path() / "benchmark" / large);
    }
    for (const auto& file : files) {
        const Lesson lesson = shipped(file);
        CAPTURE(file);
        const Story story(lesson, poses_only());
        const Step& last = story.steps()[static_cast<std::size_t>(story.last_assembled())];
        const RankReport whole = rank_of(*last.system, last.state, last.t, true);
        const RankReport verdict = rank_verdict_of(*last.system, last.state, last.t);
        CHECK(verdict.rank == whole.rank);
        CHECK(verdict.dof == whole.dof);
        CHECK(verdict.redundant() == whole.redundant());
        // 1e-16 of the squares, up to a condition of 1e4: six digits are left of the last one
        CHECK(verdict.first_value() == Approx(whole.first_value()).epsilon(1e-6));
        CHECK(verdict.last_value() == Approx(whole.last_value()).epsilon(1e-6));
    }
}

}  // namespace jw::test
