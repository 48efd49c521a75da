#include "app/session/try/experiments.hpp"

#include <catch2/catch.hpp>

#include <sstream>

#include "app/session/try/carry_out.hpp"
#include "app/session/try/experiment_text.hpp"
#include "lessons/write/writer.hpp"
#include "tests/app/session/all_experiments.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

using Sentences = std::vector<std::string>;

/// Everything that edits can change, with every bit of every number; the rest as in a lesson file.
std::string bits_of(const Lesson& lesson) {
    std::ostringstream out;
    out << std::hexfloat << lesson_text(lesson) << '\n';
    for (const Body& body : lesson.mechanism.bodies) {
        out << body.r.transpose() << ' ' << body.p.transpose() << '\n';
    }
    for (const Joint& joint : lesson.mechanism.joints) {
        const JointGeometry& g = joint.geometry;
        for (const Vec3& v :
             {g.P_i_local, g.P_j_local, g.s_i_local, g.s_j_local, g.h_i_local, g.h_j_local, g.u_i_local,
              g.u_j_local}) {
            out << v.transpose() << ' ';
        }
        out << g.length << ' ' << g.alpha << ' ' << g.d_0 << ' ' << g.theta_0 << ' '
            << g.theta_start.value_or(1e99) << ' ' << g.theta_dot_start.value_or(1e99) << '\n';
    }
    for (const Driver& driver : lesson.mechanism.drivers) {
        for (const double c : driver.function.polynomial) { out << c << ' '; }
        for (const double t : {0.0, 0.37, 1.0}) { out << driver.function.at(t).f << ' '; }
        out << driver.measure.index() << '\n';
    }
    return out.str();
}

/// The lesson that the sentences lead to, from the one that was written.
std::string bits_after(const Sentences& sentences, const Lesson& written) {
    Session session(written, false);
    for (const std::string& sentence : sentences) {
        const ExperimentResult result = carry_out(session, sentence);
        INFO(sentence << ": " << result.said);
        REQUIRE(result.done);
    }
    return bits_of(session.lesson());
}

Sentences tried_after(const Sentences& experiments, const std::string& lesson) {
    Session session(without_motion(lesson_named(lesson)));
    for (const std::string& text : experiments) {
        const ExperimentResult result = carry_out(session, text);
        INFO(text << ": " << result.said);
        REQUIRE(result.done);
    }
    CHECK(bits_after(session.tried(), session.as_written()) == bits_of(session.lesson()));
    return session.tried();
}

}  // namespace

TEST_CASE(
    "What was tried leads from the lesson as written to the lesson as it is, bit by bit", "[app][session]") {
    Random random(5);
    constexpr int kTried = 24;
    for (const auto& file : all_lesson_files()) {
        Session session(without_motion(shipped(file)));
        int longest = 0;
        for (int k = 0; k < kTried; ++k) {
            std::vector<Experiment> all = all_experiments(session.lesson(), random);
            all.emplace_back(GoTo{session.story().last_assembled()});
            // as often as edits of any one thing
            for (const Experiment& history :
                 {Experiment(Undo{}), Experiment(Redo{}), Experiment(Release{})}) {
                all.insert(all.end(), all.size() / 10, history);
            }
            const auto pick =
                static_cast<std::size_t>(random.number(0.0, 1.0) * static_cast<double>(all.size()));
            session.apply(all[std::min(pick, all.size() - 1)]);
            longest = std::max(longest, static_cast<int>(session.tried().size()));
            if (k % 8 != 7) { continue; }
            INFO(file << " after " << k + 1);
            CHECK(bits_after(session.tried(), session.as_written()) == bits_of(session.lesson()));
        }
        CHECK(longest <= kTried);
        while (session.is_changed() && !session.undo_text().empty()) { session.apply(Undo{}); }
        CHECK(session.tried().empty());
    }
}

TEST_CASE("A slider that is dragged is one sentence of what was tried", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    const auto slide = [&](int joint, double x) {
        JointGeometry g = session.lesson().mechanism.joints[static_cast<std::size_t>(joint)].geometry;
        g.P_i_local = {x, 0.0, 0.0};
        session.apply(SetGeometry{joint, g});
    };
    for (const double x : {-0.5, -0.49, -0.48}) { slide(0, x); }
    const Sentences first{"point A i -0.48 0 0"};
    CHECK(session.tried() == first);
    for (const double x : {0.41, 0.42}) { slide(1, x); }
    CHECK(session.tried() == Sentences{"point A i -0.48 0 0", "point B i 0.42 0 0"});
    session.apply(Undo{});
    CHECK(session.tried() == first);
    session.apply(Redo{});
    CHECK(session.tried().size() == 2);
    session.apply(StartOver{});
    CHECK(session.tried().empty());
    session.apply(Undo{});
    CHECK(session.tried().size() == 2);
}

TEST_CASE("A later edit stands for one of the same thing before, where that is exact", "[app][session]") {
    struct Case {
        Sentences experiments;
        Sentences tried;
    };
    const std::vector<Case> cases{
        {{"form D drop x", "take out motor", "form D pair"}, {"take out motor", "form D pair"}},
        {{"coordinates rp", "coordinates omega-local"}, {"coordinates omega-local"}},
        // an edit that is taken back leaves no sentence
        {{"form D drop x", "coordinates rp", "form D rule"}, {"coordinates rp"}},
        {{"take out A", "put back A", "put back motor"}, {}},
        {{"take out D p1 x", "take out D p1 y", "put back D p1 x"}, {"take out D p1 y"}},
        // the same equation has another name in another form
        {{"form D pair", "take out D n1 pair a", "form D all three"},
         {"take out D p1 x", "form D all three"}},
        // the motor was taken out with the joint and stays out: neither sentence alone leads to this lesson
        {{"take out A", "put back A"}, {"take out A", "put back A"}},
        {{"form D pair", "form A rule", "place crank at -0.48 -0.03 0.38"}, {"form D pair"}},
        {{"form D pair", "undo", "redo"}, {"form D pair"}},
        {{"point A i 1 2 3", "form A pair", "point A i 3 2 1"}, {"form A pair", "point A i 3 2 1"}},
        {{"place crank at 0 0 2", "place coupler turned 0 0 0 1", "place crank at 0 0 1"},
         {"place coupler turned 0 0 0 1", "place crank at 0 0 1"}},
    };
    for (const Case& c : cases) {
        INFO(c.experiments.front() << " ... " << c.experiments.back());
        CHECK(tried_after(c.experiments, "loops/four-bar") == c.tried);
    }
}

TEST_CASE(
    "A pose that a hand or a free motion led to is told by the places of the bodies", "[app][session]") {
    const Sentences alone = tried_after({"drag crank by 0 0 2"}, "loops/four-bar");
    REQUIRE(alone.size() == 1);
    CHECK(alone[0].starts_with("place crank at "));
    // every body that moves with it
    const Sentences loop =
        tried_after({"take out motor", "go to D", "drag rocker at 0.8 0 0 by 0.1 0 0.1"}, "loops/four-bar");
    REQUIRE(loop.size() == 4);
    CHECK(loop[1].starts_with("place crank "));
    CHECK(loop[2].starts_with("place coupler "));
    CHECK(loop[3].starts_with("place rocker "));
    // for a body that moves along a screw, its θ
    const Sentences nut = tried_after({"take out turn", "go to thread", "follow 1"}, "joints/screw");
    REQUIRE(nut.size() >= 2);
    CHECK(nut.back().starts_with("geometry thread theta_start "));
    // the same experiment again replaces the first one
    CHECK(
        tried_after({"take out motor", "go to D", "follow 1", "follow 1 -0.5"}, "loops/four-bar").size() ==
        4);
}

TEST_CASE("A place that no file can say is refused with the reason", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    for (const auto& [text, why] :
         {std::pair{"place crank turned 1 1 0 0", "the Euler parameters must have length 1"},
          std::pair{"place crank turned 0 0 0 0", "the Euler parameters must have length 1"},
          std::pair{"place ground at 0 0 1", "ground is fixed: it has no unknowns."}}) {
        const ExperimentResult result = carry_out(session, text);
        INFO(text << ": " << result.said);
        CHECK_FALSE(result.done);
        CHECK(result.said.find(why) != std::string::npos);
        CHECK(session.tried().empty());
    }
}

TEST_CASE("A file saved anew begins what was tried anew, and undo brings it back", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    session.apply(SetParallelForm{3, ParallelForm::pair});
    session.replace(without_motion(lesson_named("loops/four-bar")));
    CHECK(session.tried().empty());
    session.apply(SetParallelForm{3, ParallelForm::all_three});
    CHECK(session.tried() == Sentences{"form D all three"});
    session.apply(Undo{});
    session.apply(Undo{});
    CHECK(session.tried() == Sentences{"form D pair"});
}

TEST_CASE("A session that becomes another is one change of the first", "[app][session]") {
    const Lesson lesson = without_motion(lesson_named("loops/four-bar"));
    Session session(lesson);
    session.apply(GoTo{3});
    session.apply(SetParallelForm{3, ParallelForm::pair});
    const std::string before = told(session.story());
    Session other(lesson);
    for (const char* text : {"form A all three", "take out motor", "go to step 5"}) {
        REQUIRE(carry_out(other, text).done);
    }
    const std::string after = told(other.story());
    const std::uint64_t version = session.version();
    session.become(std::move(other), "all of it");
    CHECK(session.version() > version);
    CHECK(session.tried() == Sentences{"form A all three", "take out motor"});
    CHECK(session.index() == 5);
    CHECK(session.undo_text() == "all of it");
    CHECK(told(session.story()) == after);
    session.apply(Undo{});
    CHECK(session.tried() == Sentences{"form D pair"});
    CHECK(session.index() == 3);
    CHECK(told(session.story()) == before);
    session.apply(Redo{});
    CHECK(told(session.story()) == after);
}

}  // namespace jw::test
