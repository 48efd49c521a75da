#include "app/session/try/carry_out.hpp"

#include <catch2/catch.hpp>

#include "app/session/try/possible_experiments.hpp"
#include "tests/app/program.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

const RankReport& rank_after(Session& session, const std::string& text) {
    const ExperimentResult result = carry_out(session, text);
    INFO(text << ": " << result.said);
    REQUIRE(result.done);
    return session.rank();
}

Vec3 point_of(const State& state, int body, const Vec3& local) {
    const auto b = static_cast<std::size_t>(body);
    return state.r[b] + rotation_matrix(state.p[b]) * local;
}

}  // namespace

TEST_CASE("a body dragged before anything is assembled is moved to the place asked for", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    const Body before = session.lesson().mechanism.bodies[1];
    REQUIRE(carry_out(session, "drag crank by 0 0 2").done);
    CHECK((session.lesson().mechanism.bodies[1].r - before.r - Vec3(0.0, 0.0, 2.0)).norm() < 1e-9);
    // no other body is moved
    CHECK(session.lesson().mechanism.bodies[2].r == session.as_written().mechanism.bodies[2].r);
}

TEST_CASE("a body dragged after assembly goes where the equations allow", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    REQUIRE(carry_out(session, "go to D").done);
    REQUIRE(carry_out(session, "drag rocker at 0.8 0 0 by 0.2 0 0").done);
    // the pin C stays on its circle of 0.8 m about D
    const Vec3 pin = point_of(session.step().state, 3, Vec3(0.8, 0.0, 0.0));
    CHECK((pin - Vec3(0.5, 0.0, 0.4)).norm() == Approx(0.8).epsilon(1e-10));
    CHECK(session.rank().residual < 1e-10);
    CHECK(session.is_changed());
}

TEST_CASE("what cannot be moved is said, and nothing is changed", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    REQUIRE(carry_out(session, "go to motor").done);
    const std::uint64_t times_told = session.told();
    for (const std::string text :
         {"drag crank by 0 0 0.1", "follow 1", "drag ground by 1 0 0", "put back A"}) {
        const ExperimentResult result = carry_out(session, text);
        INFO(text << ": " << result.said);
        CHECK_FALSE(result.done);
        CHECK_FALSE(result.said.empty());
        CHECK_FALSE(session.in_hand());
    }
    CHECK(session.told() == times_told);
}

TEST_CASE("what an experiment is said to do it does, at the same pose", "[app][session]") {
    for (const std::string& name : few_lessons()) {
        Session session(without_motion(lesson_named(name)));
        session.apply(GoTo{session.story().last_assembled()});
        const PossibleExperiments all = possible_experiments_of(session);
        CHECK(all.present.rank == session.rank().rank);
        CHECK(all.groups.size() == session.lesson().order.size());
        for (const ExperimentGroup& group : all.groups) {
            for (const PossibleExperiment& e : group.experiments) {
                INFO(name << ": " << e.text);
                std::string error;
                Session another(without_motion(lesson_named(name)));
                const ExperimentResult result = carry_out(another, e.text);
                // an experiment that changes nothing is still understood
                CHECK(result.said.find("expected") == std::string::npos);
                if (!e.effect || !e.text.starts_with("take out") || another.story().failure() != nullptr) {
                    continue;
                }
                another.apply(GoTo{static_cast<int>(another.story().steps().size()) - 1});
                if (another.lesson().order.size() != session.lesson().order.size()) { continue; }
                CHECK(another.rank().rows == e.effect->rows);
                CHECK(another.rank().rank == e.effect->rank);
                CHECK(e.free == (e.effect->rank == all.present.rank));
            }
        }
    }
}

TEST_CASE("an equation that costs no rank is redundant, or implies one that is", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    session.apply(GoTo{session.story().last_assembled()});
    const PossibleExperiments all = possible_experiments_of(session);
    CHECK(all.present.redundant() == 3);
    CHECK(all.combinations.size() == 3);
    CHECK(all.removable.size() == 12);
    CHECK(rank_after(session, "take out D p1 x").rank == 18);
    CHECK(rank_after(session, "take out D s y").rank == 18);
    CHECK(rank_after(session, "take out D p1 z").rank == 18);
    CHECK(session.rank().redundant() == 0);
    CHECK(possible_experiments_of(session).removable.empty());
    CHECK(rank_after(session, "take out A p1 x").rank == 17);
}

TEST_CASE("free motions are told finite from instantaneous", "[app][session]") {
    Session finite(without_motion(lesson_named("loops/rssr")));
    finite.apply(GoTo{finite.story().last_assembled()});
    const PossibleExperiments rod = possible_experiments_of(finite);
    REQUIRE(rod.free_motions.size() == 1);
    CHECK(rod.free_motions[0].verdict == FreedomVerdict::finite);
}

TEST_CASE("experiments are options of the commands", "[app][commands]") {
    const std::string four_bar = lesson_path("loops/four-bar.toml");
    const Folder folder;

    const Ran step = run({"step", four_bar, "--try", "take out D p1 x", "--until", "0"});
    CHECK(step.status == 0);
    CHECK(step.out.find("tried: D · p1: equation taken out") != std::string::npos);

    const Ran inspect = run(
        {"inspect", four_bar, "--try", "take out motor", "--try", "form D all three", "--format", "json"});
    CHECK(inspect.status == 0);
    const Json json = Json::parse(inspect.out);
    CHECK(json.at("tried").size() == 2);
    CHECK(json.at("rank").at("rows") == 21);
    CHECK(json.at("rank").at("rank") == 17);

    const Ran solve = run(
        {"solve", four_bar, "--try", "driver motor rate 45 deg/s", "--from", "0", "--to", "1", "--step",
         "1"});
    const Ran half = run({"solve", four_bar, "--from", "0", "--to", "0.5", "--step", "0.5"});
    CHECK(solve.status == 0);
    CHECK(solve.err.find("tried: motor changed") == 0);
    // the same angle at half the rate: e0 of the crank is the column after the time, x, y and z
    const auto e0 = [](const std::string& csv) {
        std::string line = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
        for (int k = 0; k < 4; ++k) { line.erase(0, line.find(',') + 1); }
        return std::stod(line);
    };
    CHECK(e0(solve.out) == Approx(e0(half.out)).epsilon(1e-10));

    const Ran render = run(
        {"render", four_bar, "--out", folder.path("frames"), "--frames", "0", "--size", "960x540", "--try",
         "coordinates omega-local"});
    CHECK(render.status == 0);
    CHECK(Json::parse(bytes_of(folder.path("frames/manifest.json"))).at("tried").size() == 1);
}

TEST_CASE("check judges what is left of a lesson's claims after an experiment", "[app][commands]") {
    const std::string four_bar = lesson_path("loops/four-bar.toml");
    const Ran harmless = run({"check", four_bar, "--try", "form A pair"});
    CHECK(harmless.out.find("tried: A: pair") == 0);
    const Ran broken = run({"check", four_bar, "--try", "take out D", "--quiet"});
    CHECK(broken.status == 1);
    CHECK(broken.out.find("not judged: 12 claims about what was taken out") != std::string::npos);
    CHECK(broken.out.find("FAILS after motor") != std::string::npos);
    // with the lesson as it was, all claims hold
    CHECK(run({"check", four_bar, "--try", "take out D", "--try", "undo"}).status == 0);
}

TEST_CASE("an experiment that cannot be done ends a command with status 2", "[app][commands]") {
    const std::string four_bar = lesson_path("loops/four-bar.toml");
    for (const std::string command : {"step", "inspect", "solve", "check", "try", "open"}) {
        const Ran ran = run({command, four_bar, "--try", "form A pair", "--try", "form E rule"});
        INFO(command << ": " << ran.err);
        CHECK(ran.status == 2);
        CHECK(ran.err == "jointwise: error: --try 'form E rule': no joint 'E'; expected one of A, B, C, D\n");
    }
    const Ran undo = run({"step", four_bar, "--try", "undo"});
    CHECK(undo.status == 2);
    CHECK(undo.err == "jointwise: error: --try 'undo': There is nothing to undo.\n");
}

TEST_CASE("try lists experiments of every lesson, as text and as JSON", "[app][commands]") {
    for (const auto& file : all_lesson_files()) {
        const Ran text = run({"try", file.string()});
        INFO(file << text.err);
        CHECK(text.status == 0);
        CHECK(text.out.find("coordinates omega-local") != std::string::npos);
        CHECK(text.out.find("nan") == std::string::npos);
        const Ran ran = run({"try", file.string(), "--format", "json"});
        const Json json = Json::parse(ran.out);
        CHECK(json.at("format") == "jointwise try");
        CHECK(json.at("coordinates").at("experiments").size() == 4);
        CHECK(json.at("groups").size() == shipped(file).order.size());
    }
}

}  // namespace jw::test
